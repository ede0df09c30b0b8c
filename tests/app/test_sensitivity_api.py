"""Changes with inputs over REST: closed exponents of papers, and designs that are posted again."""

import math
import random
from copy import deepcopy
from itertools import pairwise
from typing import Any

import pytest

from app.calculations.sensitivity import Side, derived
from app.examples import EXAMPLES, REQUESTS
from app.pointers import with_values
from core.precision import EXACT, SEARCHED
from tests.inputs.hostile import HOSTILE, POINTERS

pytestmark = pytest.mark.anyio

PERFECT: dict[str, Any] = REQUESTS["sweep"]["input"]
CYCLOID: dict[str, Any] = next(each["input"] for each in EXAMPLES if each["id"] == "cycloid")
REAL = REQUESTS["sensitivity"]
PIN, SHIFT = "/contact/pin_radius_mm", "/contact/eccentricity_mm"
TORQUE, CIRCLE = "/load/output_torque_Nm", "/load/pin_circle_radius_mm"
LENGTH, CLEARANCE = "/contact/contact_length_mm", "/contact/hole_clearance_mm"


async def changes(api: Any, calculation: str, design: Any, **asked: Any) -> dict[str, Any]:
    body = {"calculation": calculation, "input": design, **asked}
    answer = await api.answer("sensitivity", body)
    return {each["pointer"]: each for each in answer["inputs"]}


R, E = 8.0, 2.0  # radius of pins and eccentricity of the design of perfect parts, mm


@pytest.mark.parametrize(
    ("calculation", "design", "output", "exponents"),
    [
        (
            "crank-planetary",
            PERFECT,
            "/hertz/max_pressure_MPa",
            {TORQUE: 0.5, CIRCLE: -0.5, LENGTH: -0.5, PIN: -(R + E / 2) / (R + E), SHIFT: 0.4},
        ),
        (
            "pin-strength",
            REQUESTS["pin-strength"],
            "/peak_bending_stress_MPa",
            {"/pin/diameter_mm": -3.0, TORQUE: 1.0, CIRCLE: -1.0},
        ),
        (
            "output-efficiency",
            REQUESTS["output-efficiency"],
            "/mean_loss_W",
            {SHIFT: 1.0, CIRCLE: -1.0, "/friction/coefficient": 1.0, TORQUE: 1.0},
        ),
        (
            "satellite-bearing",
            REQUESTS["satellite-bearing"],
            "/satellites/0/basic_life_h",
            {TORQUE: -10 / 3, "/bearing/dynamic_rating_N": 10 / 3, "/load/input_speed_rpm": -1.0},
        ),
    ],
)
async def test_closed_forms_have_their_exponents(
    api: Any, calculation: str, design: Any, output: str, exponents: dict[str, float]
) -> None:
    found = await changes(api, calculation, design, output=output, inputs=[*exponents])
    for pointer, exponent in exponents.items():
        each = found[pointer]
        assert each["derivative"] == pytest.approx(
            exponent, abs=2 * each["derivative_error"] + EXACT
        )
        assert each["derivative_error"] < SEARCHED and "absolute" not in each
    sizes = [abs(exponents[pointer]) for pointer in found]
    assert all(one >= other - 0.01 for one, other in pairwise(sizes))


async def test_derivatives_are_in_order_also_of_whole_numbers(api: Any) -> None:
    """One pin more changes the pressure by more than other steps, but its exponent is less."""
    names = ["/mechanism/pins", PIN, TORQUE]
    found = await changes(
        api, "crank-planetary", PERFECT, output="/hertz/max_pressure_MPa", inputs=names
    )
    assert [*found] == [PIN, TORQUE, "/mechanism/pins"]
    assert found["/mechanism/pins"]["plus"]["change"] < -50.0


async def test_the_error_covers_the_curvature(api: Any) -> None:
    """The exponent of a narrow gap, 1/r - 1/R, is not constant over the steps."""
    design = {"force_N": 5000.0, "contact_length_mm": 20.0, "pin_radius_mm": 9.9}
    design |= {"hole_radius_mm": 10.0}
    found = await changes(
        api, "hertz", design, output="/max_pressure_MPa", inputs=["/pin_radius_mm"]
    )
    each = found["/pin_radius_mm"]
    exact = -0.5 * (1 / 9.9) / (1 / 9.9 - 1 / 10.0)
    assert 1e-4 < abs(each["derivative"] - exact) <= 1.01 * each["derivative_error"] < 0.01


def sides(function: Any, start: float = 1.0) -> list[Side]:
    return [Side(x, function(x)) for x in (start + k * 1e-4 for k in (-2, -1, 0, 1, 2))]


def test_there_is_no_slope_at_a_kink_and_at_a_jump() -> None:
    smooth = derived(sides(lambda x: math.exp(2 * x)))
    assert smooth["derivative"] == pytest.approx(2.0, abs=2 * smooth["derivative_error"])
    kink = derived(sides(lambda x: max(x, x**3)))
    assert "derivative" not in kink
    assert kink["derivative_minus"] == pytest.approx(1.0, rel=EXACT)
    assert kink["derivative_plus"] == pytest.approx(3.0, rel=EXACT)
    assert "derivative" not in derived(sides(lambda x: 1.0 if x <= 1.0 else 2.0))
    line = derived(sides(lambda x: 3 * x - 1, start=0.0))
    assert line["absolute"] and line["derivative"] == pytest.approx(3.0, rel=EXACT)
    missing = derived(sides(lambda x: x * x if x <= 1.0 else None))
    assert missing.keys() == {"derivative_minus"}
    assert missing["derivative_minus"] == pytest.approx(2.0, abs=1e-3)


@pytest.mark.parametrize(
    ("design", "spread", "inputs"),
    [
        (REAL["input"], {CLEARANCE: 0.01}, [PIN, CLEARANCE, "/mechanism/pins"]),
        (CYCLOID, None, ["/gear/ring_pin_radius_mm", TORQUE]),
    ],
)
async def test_utilisations_are_those_of_posted_designs(
    api: Any, design: dict[str, Any], spread: Any, inputs: list[str]
) -> None:
    more = {"spread": spread} if spread else {}
    body = {"calculation": "crank-planetary", "input": design, "inputs": inputs, **more}
    answer = await api.answer("sensitivity", body)
    most = await api.answer("crank-planetary", design | {"include": ["largest_torque"]})
    assert answer["torque_Nm"] == pytest.approx(most["largest_torque_Nm"], rel=EXACT)
    assert 0.98 < answer["result"] <= 1.0 + EXACT
    loaded = with_values(design, {TORQUE: answer["torque_Nm"]})
    for each in answer["inputs"]:
        pointer, start = each["pointer"], each["value"]
        whole, given = pointer == "/mechanism/pins", (spread or {}).get(pointer)
        assert each["step"] == pytest.approx(given or (1 if whole else 0.01 * start), rel=EXACT)
        for sign, side in ((-1, each["minus"]), (1, each["plus"])):
            value = start + sign * each["step"]
            assert side["value"] == value
            set_there = value if pointer != TORQUE else answer["torque_Nm"] * value / start
            posted = with_values(loaded, {pointer: int(value) if whole else set_there})
            _, checks = await api.judged("crank-planetary", posted | {"include": ["checks"]})
            if "result" not in side:
                assert checks[side["reason"]]["impossible"]
                continue
            used = checks[side["governing"]]["utilisation"]
            assert side["result"] == pytest.approx(used, rel=SEARCHED)
            assert side["change"] == pytest.approx(side["result"] - answer["result"], abs=EXACT)
            hard = (each for code, each in checks.items() if code != "ring_pieces")  # which warns
            judged = (each.get("utilisation", 0.0) for each in hard)
            assert used == pytest.approx(max(judged), rel=SEARCHED)


async def test_the_largest_change_comes_first_and_usual_inputs_are_taken(api: Any) -> None:
    answer = await api.answer("sensitivity", REAL)
    sizes = [
        max(abs(each[side].get("change", 0.0)) for side in ("minus", "plus"))
        for each in answer["inputs"]
    ]
    assert sizes == sorted(sizes, reverse=True) and sizes[-1] > 0
    names = {each["pointer"] for each in answer["inputs"]}
    assert names == {PIN, SHIFT, CIRCLE, LENGTH, "/mechanism/pins", CLEARANCE, TORQUE}
    assert answer["governing"] == "contact_pressure_hole" and answer["linked"] == []


async def test_an_impossible_side_is_left_out_with_its_reason(api: Any) -> None:
    spread = {CLEARANCE: 0.05}  # more than the clearance
    found = await changes(api, "crank-planetary", REAL["input"], spread=spread, inputs=[CLEARANCE])
    less, more = found[CLEARANCE]["minus"], found[CLEARANCE]["plus"]
    assert "result" not in less and less["reason"]
    assert more["result"] > 1.0 and more["change"] > 0
    found = await changes(api, "crank-planetary", PERFECT, inputs=["/mechanism/pins"])
    assert found["/mechanism/pins"]["minus"]["reason"] == "dead_centre"


async def test_a_governing_check_that_changes_is_named_on_both_sides(api: Any) -> None:
    """The discs' bearings govern with few pins, or the pressure on the ring with more."""
    design = deepcopy(CYCLOID)
    design["bearing"]["dynamic_rating_N"] = 23_000.0
    spread = {"/bearing/dynamic_rating_N": 6000.0}
    found = await changes(
        api, "crank-planetary", design, spread=spread, inputs=["/bearing/dynamic_rating_N"]
    )
    each = found["/bearing/dynamic_rating_N"]
    assert each["minus"]["governing"] == "bearing_life"
    assert each["minus"]["governing"] != each["plus"]["governing"]
    assert each["minus"]["change"] > 0


async def test_pins_without_sleeves_follow_the_radius_of_the_contact(api: Any) -> None:
    for diameter, follows in ((16.0, ["/pin/diameter_mm"]), (15.0, [])):
        design = deepcopy(with_values(CYCLOID, {"/pin/diameter_mm": diameter}))
        axis = {"pointer": PIN, "values": [7.5, 8.0]}
        body = {"calculation": "crank-planetary", "input": design}
        stress = {"outputs": ["/checks/pin_static/value"]}
        answer = await api.answer("sweep", body | {"axes": [axis]} | stress)
        assert answer["linked"] == follows
        thin, thick = answer["outputs"]["/checks/pin_static/value"]
        ratio = (16 / 15) ** 3 if follows else 1.0
        assert thin == pytest.approx(thick * ratio, rel=0.1)
        design["contact"]["hole_radius_mm"] = 10.02
        del design["contact"]["hole_clearance_mm"]
        answer = await api.answer("sensitivity", body | {"input": design, "inputs": [PIN]})
        assert answer["linked"] == ["/contact/hole_radius_mm", *follows]


HERTZ = {"force_N": 5e3, "contact_length_mm": 20.0, "pin_radius_mm": 8.0, "hole_radius_mm": 10.0}


@pytest.mark.parametrize(
    ("asked", "pointer", "code"),
    [
        ({"inputs": ["/x"]}, "/inputs/0", "not_there"),
        ({"inputs": ["/force_N", "/pin_material"]}, "/inputs/1", "not_there"),
        ({"inputs": []}, "/inputs", "too_short"),
        ({"inputs": ["/force_N"] * 13}, "/inputs", "too_long"),
        ({}, "/inputs", "missing"),
        ({"inputs": ["/force_N"], "output": "/x"}, "/output", "not_there"),
        ({"inputs": ["/force_N"], "output": None}, "/output", "missing"),
        ({"inputs": ["/force_N"], "spread": {"/y": 1.0}}, "/spread/~1y", "not_there"),
        ({"inputs": ["/force_N"], "spread": {"/force_N": 0.0}}, "/spread/~1force_N", None),
        ({"inputs": ["/force_N"], "input": HERTZ | {"force_N": -1.0}}, "/input/force_N", None),
    ],
)
async def test_what_cannot_be_asked_is_refused_at_its_field(
    api: Any, asked: dict[str, Any], pointer: str, code: str | None
) -> None:
    body = {"calculation": "hertz", "input": HERTZ, "output": "/max_pressure_MPa"} | asked
    body = {name: each for name, each in body.items() if each is not None}
    problem = await api.answer("sensitivity", body, status=422)
    (error,) = problem["errors"]
    assert error["pointer"] == pointer and code in (None, error["code"])


async def test_whole_numbers_change_by_whole_numbers(api: Any) -> None:
    asked = {"inputs": ["/mechanism/pins"], "spread": {"/mechanism/pins": 1.5}}
    body = {"calculation": "crank-planetary", "input": PERFECT, **asked}
    (error,) = (await api.answer("sensitivity", body, status=422))["errors"]
    assert (error["pointer"], error["code"]) == ("/spread/~1mechanism~1pins", "int_type")


async def test_hostile_requests_are_refused_or_answered(api: Any) -> None:
    draw = random.Random(3)
    known = [*POINTERS, TORQUE, "/mechanism/pins", SHIFT, "/mechanism/ratio"]
    seen = set()
    for _ in range(120):
        design = with_values(PERFECT, {draw.choice(known[-4:]): draw.choice(HOSTILE)})
        body = {"calculation": "crank-planetary", "input": draw.choice((PERFECT, design))}
        for name, value in (
            ("inputs", draw.choices(known, k=draw.choice((1, 2)))),
            ("output", draw.choice((*POINTERS, "/checks/governing/utilisation"))),
            ("spread", {draw.choice([*known[:-4], SHIFT]): draw.choice(HOSTILE)}),
        ):
            if draw.random() < 0.4:
                body[name] = value
        body["spread"] = {str(k): v for k, v in body["spread"].items()} if "spread" in body else {}
        answer = await api.post("sensitivity", json=body)
        seen.add(answer.status_code)
        assert answer.status_code in (200, 422), (body, answer.text)
    assert seen == {200, 422}
