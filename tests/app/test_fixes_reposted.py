"""Fixes of designs that fail, of sizes that people build: each is what a repost says it is."""

import asyncio
from collections.abc import Sequence
from copy import deepcopy
from typing import Any

import pytest

from app.calculations.crank_planetary import CALCULATION
from app.calculations.crank_planetary_sections import CrankPlanetaryRequest
from app.examples import EXAMPLES
from app.settings import Settings
from core.checks.reserve import crank_verdict
from core.design.document import changed
from core.design.results import Results
from core.fixes.changes import Search
from core.output.turn import Turn
from core.precision import SEARCHED
from tests.inputs.bodies import applied
from tests.inputs.failing import failing
from tests.oracles.seeds import TIMES

pytestmark = pytest.mark.anyio

PATH = "crank-planetary"

DESIGNS = failing(max(27, 3 * TIMES))
REPOSTED = [0, 26] if TIMES == 1 else [0, *range(2, 3 * TIMES)]  # 1 and another of its kind below


@pytest.mark.parametrize("index", REPOSTED)
async def test_a_fix_says_the_verdict_that_a_repost_gives(api: Any, index: int) -> None:
    body = DESIGNS[index]
    asked = {"include": ["checks", "fixes", "combined"], "fixes_for": "failed"}
    answer = await api.answer(PATH, body | asked)
    assert answer["verdict"] == "fail" and answer["fixes"]
    for fix in answer["fixes"]:
        await api.reposted(PATH, body, fix)
    if "combined" in answer:
        found = answer["combined"]
        after = await api.answer(PATH, applied(body, found["sets"]) | {"include": ["checks"]})
        assert len(found["steps"]) > 1 and after["verdict"] == found["verdict"] != "fail"


@pytest.mark.parametrize(
    ("index", "variables"),
    [
        (1, ["/contact/pin_radius_mm", "/load/pin_circle_radius_mm"]),
        (7, ["/contact/pin_radius_mm", "/load/pin_circle_radius_mm"]),
    ],
)
async def test_several_inputs_cure_what_none_cures_alone(
    api: Any, index: int, variables: list[str]
) -> None:
    body = failing(8)[index]
    answer = await api.answer(PATH, body | {"include": ["fixes", "combined"]})
    loads = {"/load/output_torque_Nm", "/load/input_speed_rpm"}
    alone = [each for each in answer["fixes"] if each["pointer"] not in loads]
    assert {each["verdict"] for each in alone} <= {"fail"}
    for fix in alone:
        await api.reposted(PATH, body, fix)
    found = answer["combined"]
    assert [step["pointer"] for step in found["steps"]] == variables
    assert not loads & found["sets"].keys()
    reached = body
    for step in found["steps"]:
        reached = applied(reached, step["sets"])
        after = await api.answer(PATH, reached | {"include": ["checks"]})
        assert after["verdict"] == step["verdict"]
    assert reached == applied(body, found["sets"])
    assert after["verdict"] == found["verdict"] != "fail"
    assert after["counts"]["fail"] == 0


async def test_a_fix_keeps_the_fit_or_chooses_another(api: Any) -> None:
    """The hole follows the pin, with the clearance of the classes at its new diameters; too much
    backlash asks for the next tighter fit that has less.
    """
    body = failing(8)[7]
    del body["contact"]["hole_clearance_mm"]
    body["contact"]["fit"] = "H7/f7"
    body["requirements"]["max_backlash_arcmin"] = 1.0
    asked = {"include": ["checks", "fixes", "combined"], "fixes_for": "failed"}
    answer = await api.answer(PATH, body | asked)
    checks = {each["code"]: each for each in answer["checks"]}
    assert checks["backlash"]["status"] == "fail"
    assert {"contact_pressure_pin", "pin_static"} <= {fix["code"] for fix in answer["fixes"]}
    (tighter,) = [fix for fix in answer["fixes"] if fix["code"] == "backlash"]
    assert tighter["sets"] == {"/contact/fit": tighter["to"]} and tighter["from"] == "H7/f7"
    assert "change" not in tighter and "exact" not in tighter
    for fix in answer["fixes"]:
        after = await api.reposted(PATH, body, fix)
        there = {each["code"]: each for each in after["checks"]}
        for effect in fix["side_effects"]:
            assert there[effect["code"]]["status"] == effect["status_to"]
            if "utilisation_to" in effect:
                used = pytest.approx(effect["utilisation_to"], rel=SEARCHED)
                assert there[effect["code"]]["utilisation"] == used


async def test_a_fix_chooses_the_weakest_material_that_bears_the_load(api: Any) -> None:
    body = {
        "mechanism": {"pins": 6, "satellites": 2, "ratio": 20.0},
        "load": {"output_torque_Nm": 280.0, "pin_circle_radius_mm": 28.0},
        "contact": {
            "contact_length_mm": 20.0,
            "pin_radius_mm": 8.0,
            "eccentricity_mm": 2.0,
            "hole_clearance_mm": 0.02,
            "hole_material": "steel_structural",
        },
        "include": ["checks", "fixes"],
    }
    (chosen,) = [
        fix for fix in (await api.answer(PATH, body))["fixes"] if isinstance(fix["to"], str)
    ]
    assert chosen["code"] == "contact_pressure_hole" and chosen["from"] == "steel_structural"
    table = (await api.get("materials")).json()["materials"]
    limits = {
        each["name"]: each["allowable_pressure_MPa"]
        for each in table
        if "allowable_pressure_MPa" in each and "plastic" not in each["group_code"]
    }
    found = {}
    for name in limits:
        body["contact"]["hole_material"] = name
        checks = (await api.answer(PATH, body))["checks"]
        found[name] = {each["code"]: each["status"] for each in checks}[chosen["code"]]
    bearing = [name for name, status in found.items() if status == "pass"]
    assert "fail" in found.values() and chosen["to"] == min(bearing, key=limits.__getitem__)


@pytest.mark.parametrize("times", [6, 9.9, 10.1, 18])
async def test_no_fix_makes_a_circle_of_pins_ten_times_as_wide(api: Any, times: float) -> None:
    """Forces are as 1/R of it: a fix asks as many times the radius as the torque is too much."""
    body: dict[str, Any] = {
        "mechanism": {"pins": 6, "satellites": 2, "ratio": 20.0},
        "load": {"output_torque_Nm": 100.0, "pin_circle_radius_mm": 50.0},
        "contact": {
            "contact_length_mm": 20.0,
            "pin_radius_mm": 4.0,
            "eccentricity_mm": 2.0,
            "hole_clearance_mm": 0.0,
            "hole_material": "steel_case_hardened",
        },
        "requirements": {"scope": ["contact"]},
        "include": ["checks"],
    }
    asked = body | {"include": ["largest_torque"]}
    reserve = (await api.answer(PATH, asked))["torque_reserve"]
    body["load"]["output_torque_Nm"] *= reserve / 1.1 * times
    fixes = (await api.answer(PATH, body | {"include": ["fixes"]}))["fixes"]
    radii = [each["exact"] for each in fixes if each["pointer"] == "/load/pin_circle_radius_mm"]
    assert radii == ([] if times > 10 else [pytest.approx(50 * times, rel=1e-3)] * len(radii))
    assert (times > 10) == (not radii)


async def test_where_one_input_is_enough_several_are_not_named(api: Any) -> None:
    answer = await api.answer(PATH, failing(1)[0] | {"include": ["fixes", "combined"]})
    assert any(each["verdict"] != "fail" for each in answer["fixes"])
    assert "combined" not in answer
    assert "fixes" not in await api.answer(PATH, failing(1)[0] | {"include": ["combined"]})


RING = next(each["input"] for each in EXAMPLES if each["id"] == "cycloid")
RINGS: dict[str, tuple[dict[str, Any], set[str]]] = {
    "presses": (
        {"gear": {"modification": {"equidistant_mm": -0.004}}},
        {"/gear/modification/equidistant_mm", "/gear/modification/pin_circle_mm"},
    ),
    "is loose": (
        {
            "gear": {
                "modification": {"equidistant_mm": 0.08},
                "contact_length_mm": 19.0,
                "tool_radius_mm": 6.0,
            },
            "load": {"output_torque_Nm": 380.0},
            "requirements": {"min_ring_efficiency": 0.95, "max_seat_pressure_MPa": 5.0},
            "satellite_coupling": {"kind": "rigid"},  # the ring by itself: half the time
        },
        {
            "/gear/modification/equidistant_mm",
            "/gear/modification/pin_circle_mm",
            "/gear/contact_length_mm",
            "/gear/ring_pin_radius_mm",
            "/gear/tool_radius_mm",
            "/gear/friction_coefficient",
        },
    ),
    "bends": (
        {
            "gear": {
                "pin_support": "supported",
                "span_mm": 60.0,
                "satellite_positions_mm": [15.0, 39.0],
                "pin_material": {
                    "name": "steel_case_hardened",
                    "tensile_strength_MPa": 500.0,
                    "yield_strength_MPa": 200.0,
                },
            },
            "satellite_coupling": {"kind": "rigid"},
        },
        {"/gear/ring_pin_radius_mm", "/gear/span_mm"},
    ),
}
"""What else the ring of a design has, and what of it cures its teeth."""


@pytest.mark.parametrize("name", RINGS)
async def test_what_cures_the_teeth_of_a_ring_does_so(api: Any, name: str) -> None:
    sections, cures = RINGS[name]
    body = deepcopy(RING)
    for section, values in sections.items():
        body[section] = body.get(section, {}) | values
    body["requirements"]["scope"] = ["teeth"]
    asked = {"include": ["checks", "fixes"], "fixes_for": "failed"}
    answer = await api.answer(PATH, body | asked)
    assert answer["verdict"] == "fail"
    solved = [each for each in answer["fixes"] if each["status"] == "solved"]
    assert cures <= {each["pointer"] for each in solved}
    for fix in answer["fixes"]:
        await api.reposted(PATH, body, fix)


@pytest.mark.parametrize(
    ("sets", "pointers", "other"),
    [
        ({"/bearing": {"name": "NU206"}}, ["/bearing/name"], "NU306E"),
        (
            {"/crankshaft/bearings": [{"name": "6204"}] * 2},
            ["/crankshaft/bearings/0/name", "/crankshaft/bearings/1/name"],
            "6304",
        ),
    ],
)
async def test_a_named_bearing_is_exchanged_for_one_of_its_bore(
    api: Any, sets: dict[str, Any], pointers: list[str], other: str
) -> None:
    """The next larger bearing of the table is offered; all between it and the present one fail."""
    whole = next(each["input"] for each in EXAMPLES if each["id"] == "whole")
    scope = ["satellite_bearing", "crank_bearings"]
    loads = {"/load/output_torque_Nm": 300.0, "/requirements": {"life_h": 12000.0, "scope": scope}}
    body = applied(whole, sets | loads) | {"include": ["checks", "fixes"]}
    answer = await api.answer(PATH, body)
    (fix,) = [each for each in answer["fixes"] if [*each["sets"]] == pointers]
    assert (fix["to"], fix["unit"], fix["status"]) == (other, "", "solved")
    await api.reposted(PATH, body, fix)
    table = {each["name"]: each for each in (await api.get("bearings")).json()["bearings"]}
    assert table[other]["bore_diameter_mm"] == table[fix["from"]]["bore_diameter_mm"]
    assert table[other]["elements"] == table[fix["from"]]["elements"]
    between = [
        name
        for name, each in table.items()
        if each["bore_diameter_mm"] == table[other]["bore_diameter_mm"]
        and each["elements"] == table[other]["elements"]
        and each["dynamic_rating_N"] < table[other]["dynamic_rating_N"]
    ]
    assert fix["from"] in between
    for name in between:
        less = applied(body, dict.fromkeys(pointers, name)) | {"include": ["checks"]}
        checks = {each["code"]: each for each in (await api.answer(PATH, less))["checks"]}
        assert checks[fix["code"]]["status"] != "pass", name


ROBOT: dict[str, Any] = {
    "mechanism": {"pins": 8, "satellites": 2, "satellite_teeth": 20, "ring_teeth": 21},
    "load": {
        "output_torque_Nm": 650.0,
        "input_speed_rpm": 1500.0,
        "pin_circle_radius_mm": 57.0,
        "application_factor": 1.0,
    },
    "contact": {
        "eccentricity_mm": 2.2,
        "pin_radius_mm": 7.0,
        "contact_length_mm": 20.0,
        "hole_clearance_mm": 0.012,
        "pin_material": "steel_bearing",
        "hole_material": "steel_case_hardened",
    },
    "gear": {
        "kind": "cycloid",
        "ring_pin_circle_radius_mm": 77.8,
        "ring_pin_radius_mm": 4.0,
        "modification": {"equidistant_mm": 0.008},
        "pin_material": "steel_bearing",
    },
    "bearing": {"name": "NU209E"},
    "tolerances": {"ring_pin_position_mm": 0.01},
    "requirements": {"life_h": 6000.0, "scope": ["contact", "teeth", "satellite_bearing"]},
}
"""Robot joint as it is proposed, under 1.3 times its torque."""


def _solved_turns(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """Numbers of positions that are solved from now on, one for each call."""
    counts, poses = list[int](), Turn.poses

    def counted(self: Turn, places: Sequence[float], *, play: bool = True) -> Any:
        counts.append(len(places))
        return poses(self, places, play=play)

    monkeypatch.setattr(Turn, "poses", counted)
    return counts


def test_a_fix_that_leaves_the_meshes_solves_no_turn_again(monkeypatch: pytest.MonkeyPatch) -> None:
    """The rating of a bearing, and where one ring pin may stand out: the turn is the same."""
    results = CrankPlanetaryRequest.model_validate(ROBOT).results
    search = Search(results, crank_verdict(results))
    counts = _solved_turns(monkeypatch)
    longer = search.verdict(changed(results.design, {"bearing.dynamic_rating": 90e3}))
    assert counts == [12 * 21]  # of the ring pin that stands out
    assert longer["bearing_life"].value > search.current["bearing_life"].value
    finer = search.verdict(changed(results.design, {"tolerances.ring_pin_position": 5e-6}))
    assert counts == [12 * 21] * 2
    assert finer["ring_pieces"].value < search.current["ring_pieces"].value
    for found, path, value in (
        (longer, "bearing.dynamic_rating", 90e3),
        (finer, "tolerances.ring_pin_position", 5e-6),
    ):
        alone = crank_verdict(Results(changed(results.design, {path: value})))
        assert [(each.code, each.value, each.status) for each in found.checks] == [
            (each.code, each.value, each.status) for each in alone.checks
        ]


def test_fixes_of_a_ring_pin_that_stands_out_take_few_looks(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Bearing first, then the ring pin: a sampled search of the latter solves 150,000 positions."""
    body = CrankPlanetaryRequest.model_validate(ROBOT | {"include": ["combined"]})
    counts = _solved_turns(monkeypatch)
    found = CALCULATION.answered(body)["combined"]
    assert [each["code"] for each in found["steps"]] == ["bearing_life", "ring_pieces"]
    assert sum(counts) < 60_000


def test_remedies_that_were_found_in_time_are_answered(monkeypatch: pytest.MonkeyPatch) -> None:
    """A search that is ended names the inputs that it left."""
    asked, looks = ROBOT | {"include": ["fixes", "combined"]}, 0
    whole = CALCULATION.answered(CrankPlanetaryRequest.model_validate(asked))
    assert "untried" not in whole

    def late(_: Any) -> bool:
        nonlocal looks
        looks += 1
        return looks > 8

    monkeypatch.setattr(CrankPlanetaryRequest, "late", late)
    part = CALCULATION.answered(CrankPlanetaryRequest.model_validate(asked))
    assert part["verdict"] == whole["verdict"] and "combined" not in part
    assert part["fixes"] and all(each in whole["fixes"] for each in part["fixes"])
    assert len(part["fixes"]) < len(whole["fixes"])
    assert "/load/output_torque_Nm" in part["untried"]
    tried = {each["pointer"] for each in part["fixes"]}
    assert not tried & {*part["untried"]}


async def test_the_search_ends_before_the_time_of_a_request() -> None:
    body = CrankPlanetaryRequest.model_validate(ROBOT)
    assert not body.late()
    body.refuse_beyond(Settings(max_seconds=1e-3))
    await asyncio.sleep(1e-3)
    assert body.late()
    body.refuse_beyond(Settings(max_seconds=1e3))
    assert not body.late()
