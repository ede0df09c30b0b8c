"""Every number and choice that the service fills in is in `assumed`."""

from collections.abc import Iterator
from copy import deepcopy
from typing import Any, get_args

import pytest
from pydantic import ValidationError

from app.calculations.crank_planetary import CALCULATION
from app.model import RequestModel
from core.errors import CalculationError
from core.precision import JUDGED

CYCLOID: dict[str, Any] = {
    "mechanism": {"pins": 8, "satellites": 1, "satellite_teeth": 18, "ring_teeth": 19},
    "load": {"output_torque_Nm": 30, "pin_circle_radius_mm": 20, "input_speed_rpm": 1000},
    "contact": {
        "contact_length_mm": 20,
        "pin_radius_mm": 3,
        "eccentricity_mm": 1.5,
        "hole_clearance_mm": 0.02,
        "pin_material": "steel_bearing",
        "hole_material": "steel_case_hardened",
    },
    "gear": {
        "kind": "cycloid",
        "ring_pin_circle_radius_mm": 34,
        "ring_pin_radius_mm": 2.5,
        "modification": {"equidistant_mm": 0.03},
    },
    "bearing": {"kind": "roller", "dynamic_rating_N": 10000, "static_rating_N": 9000},
}
"""The default drive of a peer's program; its author gives no life."""

INVOLUTE: dict[str, Any] = {
    "mechanism": {"pins": 6, "satellites": 1, "satellite_teeth": 45, "ring_teeth": 50},
    "load": {"output_torque_Nm": 20, "pin_circle_radius_mm": 12, "input_speed_rpm": 900},
    "contact": {
        "contact_length_mm": 10,
        "pin_radius_mm": 2,
        "eccentricity_mm": 2.665,
        "hole_clearance_mm": 0.02,
        "pin_material": "steel_bearing",
        "hole_material": "steel_case_hardened",
    },
    "gear": {
        "kind": "involute",
        "module_mm": 1,
        "satellite_profile_shift": 0,
        "ring_profile_shift": 0.2,
        "satellite_addendum": 1,
        "ring_addendum": 1,
        "ring_material": "steel_case_hardened",
    },
    "pin": {"satellite_positions_mm": [14], "diameter_mm": 4},
    "friction": {"coefficient": 0.06},
    "crankshaft": {"satellite_positions_mm": [20], "bearing_positions_mm": [0, 40]},
    "bearing": {"kind": "ball", "dynamic_rating_N": 20000, "static_rating_N": 11000},
}
"""A pair of a maker's table, which says that its teeth do not interfere."""

TIRED: dict[str, Any] = INVOLUTE | {
    "load": INVOLUTE["load"] | {"output_torque_Nm": 1.2},
    "pin": INVOLUTE["pin"] | {"material": "steel_through_hardened"},
    "fatigue": {"surface": "ground", "fatigue_notch_factor": 1.5},
}
"""It with pins that tire, which bear 1.6 times the torque."""

PERFECT: dict[str, Any] = TIRED | {
    "load": INVOLUTE["load"] | {"output_torque_Nm": 2},
    "contact": {
        name: each for name, each in INVOLUTE["contact"].items() if name != "hole_clearance_mm"
    },
}
"""It with forces of perfect parts, as the clearance is not known."""

USUAL: dict[tuple[str, ...], list[float]] = {
    ("contact", "distribution_factor"): [1.3],
    ("gear", "modification", "pin_circle_mm"): [-0.02, 0.02, 0.1],
    ("gear", "modification", "rotation_arcmin"): [2, 5, 10],
    ("pin", "bore_diameter_mm"): [1, 2, 2.5],
}
"""Usual values of what is none of a thing by default; bores up to five eighths of the pin."""

FILLED = {
    ("requirements", "life_h"),
    ("requirements", "static_safety"),
    ("gear", "rack_tip_radius"),
}
"""Fields without a default that are filled by what is usual."""


def answered(body: dict[str, Any]) -> dict[str, Any]:
    whole = deepcopy(body) | {"include": ["checks"]}
    return CALCULATION.answered(CALCULATION.request.model_validate(whole))


def judged(answer: dict[str, Any]) -> tuple[str, dict[str, str]]:
    return answer["verdict"], {each["code"]: each["status"] for each in answer["checks"]}


def defaults(model: RequestModel, *path: str) -> Iterator[tuple[tuple[str, ...], Any]]:
    """Fields of a request that are not typed and have a value all the same, models within too."""
    for name, field in type(model).model_fields.items():
        value = getattr(model, name)
        if isinstance(value, RequestModel):
            yield from defaults(value, *path, name)
        elif name not in model.model_fields_set and isinstance(value, (float, str)):
            choices = [each for each in get_args(field.annotation) if isinstance(each, str)]
            usual = [value * 0.6, value * 1.7 or 0.1] if isinstance(value, float) else choices
            yield (*path, name), usual


def moved(body: dict[str, Any], path: tuple[str, ...], value: Any) -> dict[str, Any] | None:
    """The answer with another value of a field; None where such a one is refused."""
    changed = deepcopy(body)
    inner = changed
    for part in path[:-1]:
        inner = inner.setdefault(part, {})
    inner[path[-1]] = value
    try:
        return answered(changed)
    except (ValidationError, CalculationError):
        return None


@pytest.mark.slow
@pytest.mark.parametrize(
    "body",
    [CYCLOID, INVOLUTE, TIRED, PERFECT],
    ids=["cycloid", "involute", "tired", "perfect"],
)
def test_every_default_that_moves_a_check_is_said(body: dict[str, Any]) -> None:
    plain = answered(body)
    said = {each["pointer"]: each["value"] for each in plain["assumed"]}
    every = dict(defaults(CALCULATION.request.model_validate(body)))
    every |= {path: USUAL[path] for path in USUAL.keys() & every.keys()}
    every |= {path: [0.1, 1e2, 1e6] for path in FILLED if path[0] != "gear"}
    moving = set()
    for path, values in every.items():
        answers = [moved(body, path, value) for value in values]
        if any(each is not None and judged(each) != judged(plain) for each in answers):
            moving.add("/" + "/".join(path))
    filled = {"/requirements/life_h", "/requirements/static_safety"}
    assert filled & {*said} <= moving
    assert moving <= {*said}
    assert (said["/requirements/life_h"], said["/requirements/pitting_safety"]) == (5000, 1.2)


@pytest.mark.parametrize(
    ("rating", "status"), [(11800, "pass"), (10000, "marginal"), (6000, "fail"), (1000, "fail")]
)
def test_a_life_that_is_not_given_fails_where_a_fifth_of_it_does(rating: float, status: str):
    """The rating bears (C/P)^(10/3)/(60 n): 4035 h of 10 kN."""
    body = CYCLOID | {"bearing": {"kind": "roller", "dynamic_rating_N": rating}}
    answer = answered(body)
    found = next(each for each in answer["checks"] if each["code"] == "bearing_life")
    assert found["value"] == pytest.approx(4035.41 * (rating / 1e4) ** (10 / 3), rel=JUDGED)
    assert (found["status"], found["limit"]) == (status, 5000)
    assert {"pointer": "/requirements/life_h", "value": 5000} in answer["assumed"]
    if status == "marginal":
        assert found["reason"]["code"] == "default_decides"
    typed = answered(body | {"requirements": {"life_h": 5000}})
    found = next(each for each in typed["checks"] if each["code"] == "bearing_life")
    assert found["status"] == ("pass" if status == "pass" else "fail")
    assert "/requirements/life_h" not in {each["pointer"] for each in typed["assumed"]}


def test_a_plastic_is_asked_for_a_tenth_of_the_life() -> None:
    soft = CYCLOID | {"contact": CYCLOID["contact"] | {"hole_material": "PLA"}}
    answer = answered(soft)
    assert {"pointer": "/requirements/life_h", "value": 500} in answer["assumed"]


@pytest.mark.parametrize(("radius", "status"), [(None, "marginal"), (0.38, "fail"), (0.2, "pass")])
def test_a_hob_that_is_not_given_decides_nothing_alone(radius: float | None, status: str) -> None:
    body = deepcopy(INVOLUTE) | {"requirements": {"scope": ["teeth"]}}
    if radius is not None:
        body["gear"]["rack_tip_radius"] = radius
    answer = answered(body)
    (found,) = [each for each in answer["checks"] if each["code"] == "mesh_involute"]
    assert (found["status"], answer["verdict"]) == (status, status)
    said = {each["pointer"]: each["value"] for each in answer["assumed"]}
    assert said.get("/gear/rack_tip_radius") == (None if radius else 0.38)


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({}, True),
        ({"reliability_percent": 99}, False),
        ({"reliability_factor": 0.8}, False),
        ({"endurance_limit_MPa": 300}, False),
    ],
)
def test_a_reliability_is_said_where_it_counts(given: dict[str, Any], said: bool) -> None:
    """At 99 % a pin endures 0.814 of the strength at the default 50 %."""
    strong = {"surface": "ground"} if "endurance_limit_MPa" not in given else {}
    body = INVOLUTE | {"fatigue": {"fatigue_notch_factor": 1.5} | strong | given}
    answer = answered(body)
    filled = {"pointer": "/fatigue/reliability_percent", "value": 50}
    assert (filled in answer["assumed"]) == said


OF_IDEAL_FORCES = {"/load/force_exponent", "/contact/distribution_factor"}


@pytest.mark.parametrize(
    ("body", "first", "ideal"),
    [
        (CYCLOID, "/requirements/life_h", set()),
        (TIRED, "/gear/rack_tip_radius", set()),
        (PERFECT, "/gear/rack_tip_radius", OF_IDEAL_FORCES),
    ],
    ids=["cycloid", "tired", "perfect"],
)
def test_what_decides_is_first_and_what_solved_forces_have_no_part_of_is_unsaid(
    body: dict[str, Any], first: str, ideal: set[str]
) -> None:
    said = [each["pointer"] for each in answered(body)["assumed"]]
    assert (said[0], {*said} & OF_IDEAL_FORCES) == (first, ideal)
