"""Studies on all cores of a machine and on a Dask cluster of this machine, in one run.

Times are elapsed, since cores are compared, and of the processor over all processes. Two threads
are compared with two independent processes, workers of the cluster with threads, and small requests
and `/livez` alone with those beside two studies in the service.
"""

import os
import statistics
import threading
import time
from collections.abc import Callable, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import replace
from multiprocessing import get_context

import httpx
import numpy as np

from app.cluster import Lost, on_cluster
from benchmarks.options import options
from benchmarks.sharing import study_of
from core.drive import compiled
from core.tolerance.study import Mapped, Study
from tests.inputs.cluster import Cluster

POSITIONS = 60
BODY = {
    "mechanism": {"pins": 6, "satellites": 2, "ratio": 20},
    "load": {"output_torque_Nm": 200, "pin_circle_radius_mm": 40},
    "contact": {
        "contact_length_mm": 12,
        "pin_radius_mm": 5,
        "eccentricity_mm": 2,
        "hole_clearance_mm": 0.02,
    },
    "tolerances": {"pin_position_mm": 0.01, "hole_position_mm": 0.02},
}
SMALL = {"pins": 6, "ratio": 20, "output_torque_Nm": 200, "pin_circle_radius_mm": 40}


def _study(samples: int, threads: int = 1) -> Study:
    return study_of("10/9", samples, threads=threads)


def _calculated(first: int, last: int) -> float:
    """Elapsed time of some pieces in a process of its own, s."""
    compiled.load()
    study = _study(last)
    begun = time.perf_counter()
    study.values(study.pieces().part(first, last))
    return time.perf_counter() - begun


def _wall(call: Callable[[], object]) -> float:
    begun = time.perf_counter()
    call()
    return time.perf_counter() - begun


def _processor(pids: list[int]) -> float:
    """Processor time of processes, s."""
    tick, taken = os.sysconf("SC_CLK_TCK"), 0.0
    for pid in pids:
        with open(f"/proc/{pid}/stat") as stat:
            fields = stat.read().rsplit(")", 1)[1].split()
        taken += (int(fields[11]) + int(fields[12])) / tick
    return taken


def _cores(samples: int, rounds: int) -> None:
    """Print gains of two threads and of two processes."""
    study = _study(samples)
    pieces, gains, apart = study.pieces(), [], []
    half = samples // 2
    with ProcessPoolExecutor(2, mp_context=get_context("spawn")) as pool:
        list(pool.map(_calculated, (0, 0), (64, 64)))
        for _ in range(rounds):
            one = _wall(lambda: study.values(pieces))
            two = _wall(lambda: replace(study, threads=2).values(pieces))
            both = max(pool.map(_calculated, (0, half), (half, samples)))
            gains.append(one / two)
            apart.append(one / both)
    two, both = statistics.median(gains), statistics.median(apart)
    print(f"two threads {two:.2f} times one, two processes {both:.2f}: {two / both:.2f} of that")


def _lost(why: Lost) -> Mapped:
    raise why


def _cluster(samples: int, most: int) -> None:
    """Print times of a cluster of one worker, up to the most, over those of a thread here; results
    have to be equal to the bit.
    """
    study = _study(samples)
    pieces = study.pieces()
    begun = time.process_time()
    wall = _wall(lambda: study.values(pieces))
    taken, here = time.process_time() - begun, study.values(pieces)[0]
    solves = samples * POSITIONS
    print(f"{solves:.1e} positions: {wall:.1f} s here, {solves / wall:.3g} a second")
    for workers in range(1, most + 1):
        cluster = Cluster(workers)
        try:
            there = replace(study, mapped=on_cluster(cluster.address, _lost))
            there.values(there.pieces().part(0, 64))
            pids = [each.pid for each in cluster.processes] + [os.getpid()]
            before = _processor(pids)
            found: list[np.ndarray] = []
            on = _wall(lambda there=there, found=found: found.append(there.values(pieces)[0]))
            more = (_processor(pids) - before) / taken - 1
            assert found[0].tobytes() == here.tobytes()
        finally:
            cluster.stop()
        print(
            f"workers {workers}: {wall / on:.2f} times as quick as here, "
            f"{more:+.0%} of the processor, the same bits"
        )


def _beside(samples: int, seconds: float, asked_of: Sequence[int] | None) -> None:
    """Print times of a small request and of `/livez`, alone and beside two studies."""
    from benchmarks.load import service  # the processes above need no service

    body = BODY | {"samples": samples}
    with service("app.serve", running=asked_of) as running:
        url, done = f"http://127.0.0.1:{running.port}", threading.Event()

        def study() -> None:
            with httpx.Client(trust_env=False, timeout=600) as client:
                while not done.is_set():
                    client.post(f"{url}/api/v1/tolerance-study", json=body).raise_for_status()

        def asked(client: httpx.Client) -> tuple[float, float]:
            small, live = [], []
            post, end = f"{url}/api/v1/contact-force", time.perf_counter() + seconds
            while time.perf_counter() < end:
                small.append(_wall(lambda: client.post(post, json=SMALL).raise_for_status()))
                live.append(_wall(lambda: client.get(f"{url}/livez").raise_for_status()))
            return tuple(  # type: ignore[return-value]
                1e3 * float(np.percentile(times, part)) for times, part in ((small, 95), (live, 99))
            )

        with httpx.Client(trust_env=False, timeout=60) as client:
            alone = asked(client)
            threads = [threading.Thread(target=study) for _ in range(2)]
            for thread in threads:
                thread.start()
            time.sleep(min(seconds, 1.0))
            busy = asked(client)
            done.set()
            for thread in threads:
                thread.join()
    print(
        f"a small request, p95: {alone[0]:.1f} ms alone, {busy[0]:.1f} ms beside two studies; "
        f"/livez, p99: {alone[1]:.1f} and {busy[1]:.1f} ms"
    )


def main(smallest: bool, asked_of: Sequence[int] | None) -> None:
    """Print all comparisons."""
    compiled.load()
    _study(64).values(_study(64).pieces())
    _cores(256 if smallest else 65_536, 1 if smallest else 5)
    _cluster(*(4096, 1) if smallest else (166_667, 2))
    _beside(*(300, 0.3) if smallest else (6_900, 15.0), asked_of)


if __name__ == "__main__":
    asked = options(__doc__, asks=True)
    main(asked.smallest, asked.service)
