"""Studies on a Dask cluster: scheduler and workers on loopback, as an operator starts them."""

import json
import signal
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any

import httpx
import numpy as np
import pytest

from app.cluster import Lost, on_cluster
from core.output.elasticity import PowerLaw
from core.output.mechanism import Mechanism
from core.output.real_mechanism import RealMechanism
from core.tolerance.study import Evaluation, Mapped, Study
from core.tolerance.tolerances import Tolerances
from tests.inputs.cluster import Cluster
from tests.inputs.real_mechanisms import STEEL
from tests.running_service import Service, eventually, running_service

pytestmark = pytest.mark.slow

STUDY = Study(
    RealMechanism(
        mechanism=Mechanism.evenly_spaced(pins=6, satellites=2, ratio=20.0),
        pin_circle_radius=0.04,
        pin_radius=0.005,
        eccentricity=0.002,
        contact_length=0.012,
        clearance=2e-5,
        law=PowerLaw(10 / 9, 1000.0, 1e-5),
        pin_material=STEEL,
        hole_material=STEEL,
    ),
    Tolerances(pin_position=1e-5, hole_position=2e-5),
    Evaluation(("peak_force", "backlash_max"), 200.0, positions=24),
    samples=16_000,
    seed=7,
)

BODY: dict[str, Any] = {
    "mechanism": {"pins": 6, "satellites": 2, "ratio": 20},
    "load": {"output_torque_Nm": 200, "pin_circle_radius_mm": 40},
    "contact": {
        "contact_length_mm": 12,
        "pin_radius_mm": 5,
        "eccentricity_mm": 2,
        "hole_clearance_mm": 0.02,
    },
    "tolerances": {"pin_position_mm": 0.01},
    "samples": 5000,
}

STREAM = {"accept": "application/x-ndjson"}


@pytest.fixture(scope="module")
def cluster() -> Iterator[Cluster]:
    """Cluster that loses a worker first, then the last one, then the scheduler."""
    found = Cluster()
    yield found
    found.stop()


def never(why: Lost) -> Mapped:
    raise AssertionError("the cluster is lost")


def bits(found: Sequence[np.ndarray[Any, Any]]) -> list[bytes]:
    return [each.tobytes() for each in found]


def test_a_cluster_gives_the_same_bits_with_a_worker_killed_on_the_way(
    cluster: Cluster, monkeypatch: pytest.MonkeyPatch
) -> None:
    here = bits(STUDY.values(STUDY.pieces()))
    there = replace(STUDY, mapped=on_cluster(cluster.address, never))
    victim = cluster.workers[0]

    def third(done: int) -> None:
        if done >= STUDY.samples / 3 and victim.poll() is None:
            victim.send_signal(signal.SIGKILL)
            victim.wait()

    assert bits(there.values(there.pieces())) == here
    killed = replace(there, progress=third)
    assert bits(killed.values(killed.pieces())) == here
    assert victim.poll() is not None
    monkeypatch.setattr("app.cluster.version", lambda: "another")
    lost: list[Lost] = []

    def once(why: Lost) -> Mapped:
        lost.append(why)
        return STUDY.in_threads

    own = replace(STUDY, mapped=on_cluster(cluster.address, once))
    for _ in range(2):  # once lost it is not asked again
        assert bits(own.values(own.pieces())) == here and len(lost) == 1


def last_line(url: str, body: dict[str, Any], path: str = "tolerance-study") -> dict[str, Any]:
    response = httpx.post(
        f"{url}/api/v1/{path}", json=body, headers=STREAM, timeout=60, trust_env=False
    )
    assert response.status_code == 200, response.text
    found: dict[str, Any] = json.loads(response.text.splitlines()[-1])
    return found


def test_the_service_calculates_studies_there_and_here_when_it_is_lost(cluster: Cluster) -> None:
    with running_service(dask=cluster.address, processes=1) as service:
        found = last_line(service.url, BODY)["result"]
        assert "warnings" not in found
        for worker in cluster.workers:  # or the one that another test has left
            worker.kill()
            worker.wait()
        for _ in range(2):
            without = last_line(service.url, BODY)["result"]
            assert [each["code"] for each in without["warnings"]] == ["cluster_lost"]
            assert without["quantities"] == found["quantities"]
        cluster.scheduler.kill()
        assert eventually(lambda: cluster.scheduler.poll() is not None)
        ended = last_line(service.url, BODY | {"if_cluster_lost": "end"})
        assert ended["problem"]["status"] == 503
        alone = last_line(service.url, BODY)["result"]
    assert [each["code"] for each in alone["warnings"]] == ["cluster_lost"]
    assert alone["quantities"] == found["quantities"]


def test_a_sweep_gives_the_same_bits_there(served: Service) -> None:
    axis = {"pointer": "/load/output_torque_Nm", "from": 50.0, "to": 300.0, "steps": 21}
    design = {name: each for name, each in BODY.items() if name not in ("tolerances", "samples")}
    asked = {"calculation": "crank-planetary", "input": design, "axes": [axis]}
    there = Cluster()
    try:
        with running_service(dask=there.address, processes=1) as service:
            on_cluster = last_line(service.url, asked, path="sweep")["result"]
    finally:
        there.stop()
    here = last_line(served.url, asked, path="sweep")["result"]
    for each in (on_cluster, here):
        del each["accuracy"]["run_time_us"]
    assert on_cluster == here and len({*here["outputs"]["/checks/governing/utilisation"]}) == 21
