"""Sweeps over REST: every point is that of the single answer, however the sweep is cut."""

import json
import math
import multiprocessing
import os
import random
import signal
import time
from copy import deepcopy
from pathlib import Path
from typing import Any

import httpx
import pytest

from app.calculations.sweep import SweepRequest
from app.cut import in_processes
from app.examples import EXAMPLES, REQUESTS
from app.main import create_app
from app.pointers import with_values
from app.problems import Problem
from app.settings import Settings
from core.precision import EXACT, SAME
from tests.inputs.hostile import HOSTILE, POINTERS
from tests.running_service import eventually

pytestmark = pytest.mark.anyio

DESIGN: dict[str, Any] = REQUESTS["sweep"]["input"]
CLEARANCE: dict[str, Any] = next(each["input"] for each in EXAMPLES if each["id"] == "clearance")
HERTZ: dict[str, Any] = {
    "force_N": 5000.0,
    "contact_length_mm": 20.0,
    "pin_radius_mm": 8.0,
    "hole_radius_mm": 10.0,
    "pin_material": "steel_bearing",
    "hole_material": "steel_through_hardened",
}
RADIUS = {"pointer": "/pin_radius_mm", "from": 2.0, "to": 9.0, "steps": 8}
PRESSURE = "/max_pressure_MPa"
TORQUE = "/load/output_torque_Nm"
USED = "/checks/governing/utilisation"
HOLE = "/contact/hole_radius_mm"
PIN = {"pointer": "/contact/pin_radius_mm", "values": [5.0, 5.5]}
HOLES = {"pointer": HOLE, "values": [10.0, 11.0]}


def of_hertz(*axes: dict[str, Any], **more: Any) -> dict[str, Any]:
    asked = {"calculation": "hertz", "input": HERTZ, "axes": [*axes], "outputs": [PRESSURE]}
    return asked | more


def of_design(*axes: dict[str, Any], design: Any = DESIGN, **more: Any) -> dict[str, Any]:
    return {"calculation": "crank-planetary", "input": design, "axes": [*axes], **more}


async def test_pressures_follow_the_closed_form(api: Any) -> None:
    answer = await api.answer(
        "sweep", of_hertz(RADIUS, {"pointer": "/force_N", "values": [1e3, 4e3]})
    )
    radii, forces = (each["values"] for each in answer["axes"])
    assert radii == [2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0] and forces == [1e3, 4e3]
    found = answer["outputs"][PRESSURE]
    for k, (r, force) in enumerate((r, force) for r in radii for force in forces):
        shape = math.sqrt(force * (1 / r - 1 / 10.0)) / math.sqrt(1e3 * (1 / 2.0 - 1 / 10.0))
        assert found[k] == pytest.approx(found[0] * shape, rel=SAME)
    assert answer["status"] == ["ok"] * 16 and answer["reasons"] == []
    assert answer["governing"] == [-1] * 16 and answer["codes"] == []


async def test_ranges_are_even_or_of_equal_ratios(api: Any) -> None:
    log = RADIUS | {"from": 0.5, "to": 8.0, "steps": 5, "scale": "log"}
    answer = await api.answer("sweep", of_hertz(log))
    assert answer["axes"][0]["values"] == pytest.approx([0.5, 1.0, 2.0, 4.0, 8.0], rel=SAME)
    down = RADIUS | {"from": 0.7, "to": 0.1, "steps": 3}
    answer = await api.answer("sweep", of_hertz(down))
    assert answer["axes"][0]["values"] == [0.7, pytest.approx(0.4), 0.1]


@pytest.mark.parametrize("design", [DESIGN, CLEARANCE])
async def test_points_are_those_of_single_answers(api: Any, design: dict[str, Any]) -> None:
    axis = {"pointer": TORQUE, "values": [40.0, 280.0, 2800.0]}
    forced = "/contact_force/peak_force_N"
    reserve = "/checks/contact_pressure_hole/utilisation"
    asked = of_design(axis, {"pointer": "/mechanism/pins", "values": [6, 8]}, design=design)
    answer = await api.answer("sweep", asked | {"outputs": [USED, forced, reserve]})
    points = [(torque, pins) for torque in axis["values"] for pins in (6, 8)]
    for k, (torque, pins) in enumerate(points):
        single = with_values(design, {TORQUE: torque, "/mechanism/pins": pins})
        single["include"] = ["checks", "contact_force"]
        posted, checks = await api.judged("crank-planetary", single)
        governing = posted["governing"]
        assert answer["codes"][answer["governing"][k]] == governing
        assert answer["outputs"][USED][k] == checks[governing]["utilisation"]
        assert answer["outputs"][forced][k] == posted["contact_force"]["peak_force_N"]
        assert answer["outputs"][reserve][k] == checks["contact_pressure_hole"]["utilisation"]
        assert answer["status"][k] == posted["verdict"]
    assert len({*answer["outputs"][USED]}) == len(points)


async def test_the_hole_follows_pin_and_eccentricity_unless_it_is_an_axis(api: Any) -> None:
    pin = {"pointer": "/contact/pin_radius_mm", "values": [6.0, 9.0]}
    shift = {"pointer": "/contact/eccentricity_mm", "values": [1.5]}
    answer = await api.answer(
        "sweep", of_design(pin, shift, objective={"pointer": USED, "sense": "largest"})
    )
    assert answer["linked"] == ["/contact/hole_radius_mm"]
    assert answer["best"]["point"] == 0
    assert answer["best"]["value"] == answer["outputs"][USED][0] > answer["outputs"][USED][1]
    assert answer["best"]["sets"] == {
        "/contact/pin_radius_mm": 6.0,
        "/contact/eccentricity_mm": 1.5,
        "/contact/hole_radius_mm": 7.5,
    }
    hole = {"pointer": "/contact/hole_radius_mm", "values": [10.0, 12.0]}
    answer = await api.answer("sweep", of_design(hole, pin))
    assert answer["linked"] == []
    assert answer["status"][0] == "incomplete" and answer["status"][1] == "impossible"


async def test_a_hole_that_is_kept_stays_as_typed_and_is_not_linked(api: Any) -> None:
    best = {"pointer": USED, "sense": "largest"}
    followed = await api.answer("sweep", of_design(PIN, objective=best))
    answer = await api.answer("sweep", of_design(PIN, objective=best, keep=[HOLE]))
    assert followed["linked"] == [HOLE] and answer["linked"] == []
    assert [*answer["best"]["sets"]] == ["/contact/pin_radius_mm"]
    for k, radius in enumerate(PIN["values"]):
        single = with_values(DESIGN, {"/contact/pin_radius_mm": radius})
        posted, checks = await api.judged("crank-planetary", single | {"include": ["checks"]})
        assert answer["outputs"][USED][k] == checks[posted["governing"]]["utilisation"]
        assert answer["outputs"][USED][k] != followed["outputs"][USED][k]


async def test_an_input_that_is_kept_stays_as_typed_in_all_three(api: Any) -> None:
    body = {"calculation": "crank-planetary", "input": DESIGN, "keep": [HOLE]}
    pin = {"pointer": "/contact/pin_radius_mm", "from": 4.0, "to": 8.0}
    target = {"pointer": "/hertz/safety_factor", "at_least": 1.0}
    found = await api.answer("solve", body | {"variable": pin, "target": target})
    assert found["linked"] == [] and HOLE not in found["sets"]
    ends = []
    for keep in ([], [HOLE]):
        asked = body | {"inputs": ["/contact/pin_radius_mm", HOLE], "keep": keep}
        answer = await api.answer("sensitivity", asked)
        assert answer["linked"] == [HOLE][len(keep) :]
        ends.append({each["pointer"]: each["plus"] for each in answer["inputs"]})
    one, other = (each["/contact/pin_radius_mm"] for each in ends)
    assert one != other and ends[0][HOLE] == ends[1][HOLE]


async def test_impossible_points_stay_with_their_reason(api: Any) -> None:
    answer = await api.answer("sweep", of_hertz(RADIUS | {"to": 12.0, "steps": 11}))
    assert answer["status"] == ["ok"] * 8 + ["impossible"] * 3
    assert (
        answer["outputs"][PRESSURE][8:] == [None] * 3
        and None not in answer["outputs"][PRESSURE][:8]
    )
    (reason,) = answer["reasons"]
    assert (reason["code"], reason["pointer"]) == ("larger_than", "/input/hole_radius_mm")
    assert reason["points"] == [8, 9, 10]
    crowded = {"pointer": "/contact/pin_radius_mm", "values": [8.0, 14.0]}
    pins = {"pointer": "/mechanism/pins", "from": 3, "to": 9, "steps": 7}
    answer = await api.answer("sweep", of_design(crowded, pins))
    assert answer["axes"][1]["values"] == [3, 4, 5, 6, 7, 8, 9]
    bad = [k for k, each in enumerate(answer["status"]) if each == "impossible"]
    assert bad and bad == sorted(k for each in answer["reasons"] for k in each["points"])
    assert {each["code"] for each in answer["reasons"]} <= {"wall_holes", "pins_apart"}
    assert "best" not in answer


async def test_the_best_point_neither_fails_nor_is_impossible(api: Any) -> None:
    torque = {"pointer": TORQUE, "values": [100.0, 1e5, 200.0]}
    largest = {"pointer": USED, "sense": "largest"}
    answer = await api.answer("sweep", of_design(torque, objective=largest))
    assert answer["status"] == ["incomplete", "fail", "incomplete"]
    assert answer["best"]["point"] == 2
    none = {"pointer": TORQUE, "values": [1e5, 2e5]}
    assert "best" not in await api.answer("sweep", of_design(none, objective=largest))


@pytest.mark.parametrize(
    ("asked", "pointer", "code"),
    [
        (of_hertz(RADIUS | {"pointer": "/no/such"}), "/axes/0/pointer", "not_there"),
        (of_hertz(RADIUS | {"pointer": "/no_such"}), "/axes/0/pointer", "not_there"),
        (of_hertz(RADIUS | {"pointer": "/pin_material"}), "/axes/0/pointer", "not_there"),
        (of_hertz(RADIUS, outputs=["/no_such"]), "/outputs/0", "not_there"),
        (of_hertz(RADIUS, outputs=["/accuracy/method"]), "/outputs/0", "not_there"),
        (of_hertz(RADIUS, outputs=[USED]), "/outputs/0", "not_there"),
        (of_hertz(RADIUS, objective={"pointer": "/x"}), "/objective/pointer", "not_there"),
        (of_hertz(RADIUS, RADIUS), "/axes/1/pointer", "only_one"),
        (of_hertz(RADIUS, outputs=None), "/outputs", "missing"),
        (of_hertz(RADIUS, keep=["/hole_radius_mm"]), "/keep/0", "follows_nothing"),
        (of_design(PIN, keep=[HOLE, "/pin/diameter_mm"]), "/keep/1", "follows_nothing"),
        (of_design(PIN, HOLES, keep=[HOLE]), "/keep/0", "follows_nothing"),
        (of_design(PIN, keep=[HOLE] * 3), "/keep", "too_long"),
        (of_hertz(RADIUS | {"steps": 1}), "/axes/0/steps", "greater_than_equal"),
        (of_hertz(RADIUS | {"steps": 1001}), "/axes/0/steps", "less_than_equal"),
        (of_hertz(RADIUS | {"steps": 2.5}), "/axes/0/steps", "int_type"),
        (of_hertz(RADIUS | {"values": [1.0]}), "/axes/0/values", "only_one"),
        (of_hertz({"pointer": "/force_N"}), "/axes/0/from", "needed"),
        (of_hertz({"pointer": "/force_N", "values": []}), "/axes/0/values", "too_short"),
        (of_hertz({"pointer": "/force_N", "values": ["1"]}), "/axes/0/values/0", "float_type"),
        (of_hertz(RADIUS | {"from": 0.0, "scale": "log"}), "/axes/0/from", "greater_than"),
        (of_hertz(RADIUS | {"to": -1.0, "scale": "log"}), "/axes/0/to", "greater_than"),
        (of_hertz(*[RADIUS] * 3), "/axes", "too_long"),
        (of_hertz(RADIUS, input=HERTZ | {"x": 1}), "/input/x", "extra_forbidden"),
        (
            of_design({"pointer": "/mechanism/pins", "values": [3, 3.5]}),
            "/axes/0/values",
            "int_type",
        ),
        (
            of_design({"pointer": "/mechanism/pins", "from": 3, "to": 8, "steps": 3}),
            "/axes/0/steps",
            "int_type",
        ),
    ],
)
async def test_what_cannot_be_swept_is_refused_at_its_field(
    api: Any, asked: dict[str, Any], pointer: str, code: str
) -> None:
    asked = {name: each for name, each in asked.items() if each is not None}
    problem = await api.answer("sweep", asked, status=422)
    assert (pointer, code) in [(each["pointer"], each["code"]) for each in problem["errors"]]


async def test_a_list_that_does_not_fit_refuses_the_sweep(api: Any) -> None:
    design = deepcopy(CLEARANCE)
    pins = design["mechanism"]["pins"]
    design["deviations"] = {"pin_radius_mm": [0.001] * pins}
    axis = {"pointer": "/mechanism/pins", "values": [pins, pins + 1]}
    problem = await api.answer("sweep", of_design(axis, design=design), status=422)
    (error,) = problem["errors"]
    assert error["code"] == "different_length"
    assert error["pointer"] == "/input/deviations/pin_radius_mm"


async def test_the_operator_limits_the_number_of_points() -> None:
    transport = httpx.ASGITransport(create_app(Settings(max_sweep_points=15)))
    async with httpx.AsyncClient(transport=transport, base_url="http://service/api/v1/") as client:
        pair = of_hertz(RADIUS, {"pointer": "/force_N", "values": [1.0, 2.0]})
        (error,) = (await client.post("sweep", json=pair)).json()["errors"]
        assert (error["pointer"], error["code"]) == ("/axes/1/values", "service_limit")
        assert error["params"] == {"limit": 1}
        assert (await client.post("sweep", json=of_hertz(RADIUS))).status_code == 200


async def test_points_beyond_the_limits_of_the_operator_are_impossible() -> None:
    transport = httpx.ASGITransport(create_app(Settings(max_pairs=10)))
    axis = {"pointer": "/mechanism/pins", "values": [5, 6]}
    async with httpx.AsyncClient(transport=transport, base_url="http://service/api/v1/") as client:
        answer = (await client.post("sweep", json=of_design(axis))).json()
    assert answer["status"] == ["incomplete", "impossible"]
    (reason,) = answer["reasons"]
    assert (reason["code"], reason["pointer"]) == ("too_many_pairs", "/input/mechanism/pins")


async def test_a_value_beyond_the_limits_of_the_service_is_an_impossible_point(api: Any) -> None:
    axis = {"pointer": "/mechanism/pins", "values": [3, 10**9]}
    answer = await api.answer("sweep", of_design(axis))
    assert answer["status"][1] == "impossible"
    assert [each["points"] for each in answer["reasons"]] == [[1]]


def test_bits_do_not_hang_on_the_cut() -> None:
    axis = {"pointer": TORQUE, "from": 100.0, "to": 700.0, "steps": 13}
    body = SweepRequest.model_validate(of_design(axis, design=CLEARANCE, outputs=[USED]))
    body.refuse_beyond(Settings())
    alone = body.grid.rows(range(13))
    assert len({each.values for each in alone}) == 13
    for processes, size in ((1, 13), (2, 5), (4, 1), (3, 2)):
        blocks = body.grid.blocks(size)
        assert [k for block in blocks for k in block] == [*range(13)]
        cut = in_processes(processes)(body.grid.rows, blocks)
        assert [row for rows in cut for row in rows] == alone


def end(number: int) -> int:
    if number == 2:
        os.kill(os.getpid(), signal.SIGKILL)
    return number


def test_a_process_that_is_stopped_ends_the_request_as_unavailable() -> None:
    with pytest.raises(Problem) as refused:
        [*in_processes(2)(end, [1, 2, 3])]
    assert refused.value.kind == "unavailable"


async def test_the_largest_torque_is_where_the_governing_check_is_at_its_limit(api: Any) -> None:
    design = next(each["input"] for each in EXAMPLES if each["id"] == "opening")
    asked = {
        "calculation": "crank-planetary",
        "input": design,
        "variable": {"pointer": TORQUE, "from": 10.0, "to": 1e4},
        "target": {"pointer": USED, "at_most": 1.0},
        "want": "largest",
    }
    found = await api.answer("solve", asked)
    most = await api.answer("crank-planetary", design | {"include": ["largest_torque"]})
    assert found["value"] == pytest.approx(most["largest_torque_Nm"], rel=EXACT)


async def test_progress_comes_in_lines(api: Any) -> None:
    asked = of_design(
        {"pointer": TORQUE, "from": 100.0, "to": 700.0, "steps": 30}, design=CLEARANCE
    )
    whole = await api.answer("sweep", asked)
    answer = await api.post("sweep", json=asked, headers={"accept": "application/x-ndjson"})
    *told, last = map(json.loads, answer.text.splitlines())
    assert all(0 < each["progress"] <= 1 for each in told)
    for each in (whole, last["result"]):
        del each["accuracy"]["run_time_us"]
    assert last["result"] == whole


def sleep_at(place: tuple[str, int]) -> None:
    folder, number = place
    Path(folder, str(number)).write_text(str(os.getpid()))
    time.sleep(60)


def sleepers(folder: str) -> None:
    [*in_processes(2)(sleep_at, [(folder, 0), (folder, 1)])]


def gone(number: int) -> bool:
    try:
        return Path(f"/proc/{number}/stat").read_text().split()[2] == "Z"
    except FileNotFoundError:
        return True


def test_processes_end_with_their_owner(tmp_path: Path) -> None:
    owner = multiprocessing.get_context("fork").Process(target=sleepers, args=(str(tmp_path),))
    owner.start()
    notes = [tmp_path / "0", tmp_path / "1"]
    assert eventually(lambda: all(each.exists() and each.read_text() for each in notes))
    numbers = [int(each.read_text()) for each in notes]
    assert owner.pid and owner.pid not in numbers and len({*numbers}) == 2
    assert not any(map(gone, numbers))
    os.kill(owner.pid, signal.SIGKILL)
    owner.join()
    assert eventually(lambda: all(map(gone, numbers)))


async def test_hostile_sweeps_are_refused_or_answered(api: Any) -> None:
    draw = random.Random(2)
    known = [*POINTERS, TORQUE, "/mechanism/pins", "/contact/eccentricity_mm", "/mechanism/ratio"]
    seen = set()
    for _ in range(150):
        axis = {"pointer": draw.choice(known)}
        if draw.random() < 0.5:
            axis |= {name: draw.choice(HOSTILE) for name in ("from", "to")}
            axis |= {
                "steps": draw.choice((2, 3, *HOSTILE)),
                "scale": draw.choice(("log", "linear")),
            }
        else:
            axis["values"] = draw.choices(HOSTILE[: draw.choice((3, 9, 15))], k=2)
        more = {"outputs": [draw.choice((*POINTERS, USED))]} if draw.random() < 0.4 else {}
        answer = await api.post("sweep", json=of_design(axis, **more))
        seen.add(answer.status_code)
        assert answer.status_code in (200, 422), (axis, more, answer.text)
    assert seen == {200, 422}
