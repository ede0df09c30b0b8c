"""Paths of core parameters in requests: pointers of refusals and of the inputs of checks."""

from typing import Any

import pytest

from app.calculations.checks import judgement
from app.calculations.crank_planetary_sections import CrankPlanetaryRequest
from app.calculations.mechanism import MechanismFields
from core.checks.crank_planetary import crank_checks

BODY: dict[str, Any] = {
    "mechanism": {"pins": 6, "ratio": 20.0},
    "load": {"output_torque_Nm": 500.0, "pin_circle_radius_mm": 50.0},
    "contact": {"contact_length_mm": 20.0, "pin_radius_mm": 8.0, "eccentricity_mm": 2.0},
}
PIN = {"satellite_positions_mm": [15.0, 37.0]}


@pytest.mark.parametrize("given", [{}, {"pin": PIN}])
@pytest.mark.parametrize(
    ("parameter", "path"),
    [
        ("pins", ("mechanism", "pins")),
        ("contact_length", ("contact", "contact_length_mm")),
        ("pin.contact_length", ("pin", "contact_length_mm")),
        ("pin.satellite_positions[1]", ("pin", "satellite_positions_mm", 1)),
        ("hole_radial[0][2]", ()),
        ("deviations.hole_radial[0][2]", ("deviations", "hole_radial_mm", 0, 2)),
        ("crank_angles[1]", ("mechanism", "crank_angles_deg", 1)),
        (
            "crankshaft.bearings[1].dynamic_rating",
            ("crankshaft", "bearings", 1, "dynamic_rating_N"),
        ),
        ("pin.material.yield_strength", ("pin", "material", "yield_strength_MPa")),
        ("nothing", ()),
    ],
)
def test_the_path_of_a_parameter(given: dict[str, Any], parameter: str, path: Any) -> None:
    """The path does not depend on the section being given, so that a refusal can name a missing
    one.
    """
    assert CrankPlanetaryRequest.model_validate(BODY | given).path_of(parameter) == path


def test_what_is_kept_of_a_request_is_of_the_fields_that_it_has() -> None:
    angles = {"pins": 6, "ratio": 20.0, "crank_angles_deg": [0.0, 120.0, 240.0]}
    assert MechanismFields.model_validate(angles).given["satellites"] == 3
    body = CrankPlanetaryRequest.model_validate(BODY)
    assert body.given.keys() >= {"load", "contact"}
    assert body.design.contact
    assert not body.model_copy(update={"contact": None}).design.contact


def inputs(code: str = "contact_pressure_hole", **changes: Any) -> set[str]:
    """Inputs of a check that a request has given."""
    body = CrankPlanetaryRequest.model_validate(BODY | changes)
    answer = judgement(crank_checks(body.results), body, torque=500.0, checks=True)
    return {*next(each for each in answer["checks"] if each["code"] == code)["inputs"]}


def test_the_inputs_of_a_check_are_those_that_are_given() -> None:
    alone = inputs()
    assert {"/mechanism/pins", "/contact/pin_radius_mm", "/requirements/pitting_safety"} <= alone
    assert not any(each.startswith("/pin/") for each in alone)
    bent = {"/pin/satellite_positions_mm", "/pin/support", "/pin/bore_diameter_mm"}
    assert inputs(pin=PIN) - alone == bent
    thinner = inputs(pin=PIN | {"diameter_mm": 15.0})
    assert thinner - alone == bent | {"/pin/diameter_mm"}
    assert inputs() == alone


def test_for_an_input_that_is_not_given_there_is_what_it_follows_from() -> None:
    teeth = {"satellite_teeth": 40, "ring_teeth": 42}
    load = {"pin_circle_radius_mm": 50.0, "input_torque_Nm": 25.0, "efficiency": 0.9}
    rubs = {"friction": {"coefficient": 0.1}}
    for code, names, changes in (
        (
            "sliding_speed",
            ["mechanism/satellite_teeth", "mechanism/ring_teeth"],
            {"mechanism": {"pins": 6} | teeth},
        ),
        (
            "sliding_speed",
            ["mechanism/output_ratio"],
            {"mechanism": {"pins": 6, "output": "ring", "output_ratio": 21.0}},
        ),
        ("lost_motion", ["load/input_torque_Nm", "load/efficiency"], {"load": load}),
    ):
        found, said = inputs(code, **rubs, **changes), inputs(code, **rubs)
        assert found - said == {f"/{name}" for name in names}
        assert len(said - found) == 1
    contact = BODY["contact"]
    sizes = {"/contact/pin_radius_mm", "/contact/eccentricity_mm"}
    others = {"/mechanism/pins", "/load/pin_circle_radius_mm"}
    for name, value in (("hole_clearance_mm", 0.02), ("fit", "H7/f7")):
        found = inputs("wall_holes", contact=contact | {name: value})
        assert found == sizes | others | {f"/contact/{name}"}
    hole = contact | {"hole_radius_mm": 10.02}
    assert inputs("wall_holes", contact=hole) == others | {"/contact/hole_radius_mm"}
    gear = {"kind": "involute", "module_mm": 1.75}
    found = inputs("pressure_angle", mechanism={"pins": 6} | teeth, gear=gear)
    assert {"/mechanism/satellite_teeth", "/mechanism/ring_teeth"} <= found
