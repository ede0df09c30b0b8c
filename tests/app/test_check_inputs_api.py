"""Checks of rollers and of the precessional gear name, by pointers, what they depend on: to move
one of these moves a value or a limit in some request, and to move another one never does.
"""

from collections.abc import Iterator
from copy import copy
from typing import Any

import pytest

from core.checks.plain import ROLLERS, SHAFT

pytestmark = pytest.mark.anyio

ROLLER = {
    "output_torque_Nm": 400.0,
    "hole_circle_radius_mm": 60.0,
    "rollers": 8,
    "diameter_mm": 12.0,
    "sphere_diameter_mm": 20.0,
    "cylinder_length_mm": 12.0,
    "sphere_width_mm": 8.0,
    "friction_coefficient": 0.2,
    "youngs_modulus_GPa": 210.0,
    "poissons_ratio": 0.3,
    "position_tolerance_mm": 0.005,
    "yield_strength_MPa": 800.0,
    "tensile_strength_MPa": 1000.0,
    "stress_concentration": 1.2,
    "roller_rotates": False,
    "eccentricity_mm": 2.0,
    "fatigue": {"surface": "ground", "reliability_percent": 99, "criterion": "gerber"},
    "requirements": {"bending_safety": 1.5, "fatigue_safety": 1.5},
}
STEEL = {"youngs_modulus_GPa": 206.0, "poissons_ratio": 0.3, "allowable_pressure_MPa": 1200.0}
PLACE = {"position_angle_deg": 30.0, "z_min_mm": 15.0, "z_max_mm": 25.0}
GEAR = {
    "torque_Nm": 100.0,
    "roller_radius_mm": 4.0,
    "roller_circle_radius_mm": 50.0,
    "nutation_angle_deg": 6.0,
    "ratio_u12": 0.96,
    "reference_z_mm": 20.0,
    "rollers": [PLACE | {"position_angle_deg": angle} for angle in (30.0, 60.0, 90.0, 120.0)],
    "bearing_distance_mm": 60.0,
    "overhang_mm": 30.0,
    "shaft_diameter_mm": 30.0,
    "youngs_modulus_GPa": 219.0,  # those of a steel are less than 220
    "yield_strength_MPa": 600.0,
    "tensile_strength_MPa": 900.0,
    "load_rotates_with_shaft": False,
    "fatigue": {"surface": "ground", "reliability_percent": 99, "fatigue_notch_factor": 1.5},
    "line_contact": {"mating_radius_mm": 80.0, "roller_material": STEEL, "mating_material": STEEL},
    "requirements": {
        "max_deflection_mm": 0.1,
        "max_slope_mrad": 2.0,
        "bending_safety": 1.5,
        "fatigue_safety": 1.5,
        "pitting_safety": 1.2,
    },
}
FATIGUES: tuple[dict[str, Any], ...] = (
    {"surface_factor": 0.9, "reliability_factor": 0.9, "fatigue_notch_factor": 1.5},
    {
        "surface": "ground",
        "edition": "shigley_9",
        "notch": {"theoretical_factor": 2.0, "radius_mm": 1.0},
        "criterion": "soderberg",
    },
    {"endurance_limit_MPa": 300.0},
)
SECTIONS = [{"length_mm": 40.0, "diameter_mm": 30.0}, {"length_mm": 50.0, "diameter_mm": 35.0}]
REQUESTS: dict[str, list[dict[str, Any]]] = {
    "roller-strength": [
        ROLLER,
        # the others just carry, or just do not
        ROLLER | {"output_torque_Nm": 256.6},
        ROLLER | {"output_torque_Nm": 256.5},
        ROLLER | {"output_torque_Nm": 256.1, "poissons_ratio": None, "shear_modulus_GPa": 80.0},
        ROLLER | {"position_tolerance_mm": None, "gaps_mm": [*7 * [0.001], 0.0054]},
        *(ROLLER | {"stress_concentration": None, "fatigue": each} for each in FATIGUES),
    ],
    "precession/shaft-deflection": [
        GEAR,
        GEAR | {"rollers": None, "wheel": PLACE | {"rollers_total": 12, "rollers_in_mesh": 4}},
        GEAR | {"shaft_diameter_mm": None, "shaft_sections": SECTIONS},
        *(GEAR | {"fatigue": each} for each in FATIGUES),
    ],
}
KINDS = {"roller-strength": ROLLERS, "precession/shaft-deflection": SHAFT}

OTHERS = {
    False: True,
    99: 90,
    "ground": "machined",
    "shigley_9": "shigley_11",
    "gerber": "goodman",
    "soderberg": "goodman",
}
"""Of what is one of some values another one."""


def other(value: Any) -> Any:
    if value in OTHERS:
        return OTHERS[value]
    return value + 1 if isinstance(value, int) else 1.02 * value


def moves(body: Any) -> Iterator[tuple[str, Any]]:
    """Pointers to the values of a body, with the body in which they are moved."""
    for name, value in enumerate(body) if isinstance(body, list) else body.items():
        for pointer, to in moves(value) if isinstance(value, dict | list) else [("", other(value))]:
            changed = copy(body)
            changed[name] = to
            yield f"/{name}{pointer}", changed


@pytest.mark.parametrize("path", REQUESTS)
async def test_a_check_names_what_moves_it_and_nothing_else(api: Any, path: str) -> None:
    async def checks(body: dict[str, Any]) -> dict[str, Any]:
        answer = await api.post(path, json=body | {"include": ["checks"]})
        return {each["code"]: each for each in answer.json().get("checks", ())}

    named, moved = set[tuple[str, str]](), set[tuple[str, str]]()
    for given in REQUESTS[path]:
        body = {name: value for name, value in given.items() if value is not None}
        before = await checks(body)
        for pointer, changed in moves(body):
            for code, after in (await checks(changed)).items():  # none where that is refused
                inputs = before[code]["inputs"]
                named |= {(code, each) for each in inputs}
                if any(before[code].get(each) != after.get(each) for each in ("value", "limit")):
                    found = [each for each in inputs if f"{pointer}/".startswith(f"{each}/")]
                    moved |= {(code, each) for each in found or [pointer]}
    assert named == moved
    assert {code for code, _ in moved} == {kind.code for kind in KINDS[path]}
