"""Checks of rollers and of the precessional gear name, by pointers, what moves them."""

from collections.abc import Iterator
from copy import deepcopy
from typing import Any

import pytest

pytestmark = pytest.mark.anyio

ROLLERS = {
    "output_torque_Nm": 400.0,
    "hole_circle_radius_mm": 60.0,
    "rollers": 8,
    "diameter_mm": 12.0,
    "sphere_diameter_mm": 20.0,
    "cylinder_length_mm": 12.0,
    "sphere_width_mm": 8.0,
    "youngs_modulus_GPa": 210.0,
    "poissons_ratio": 0.3,
    "position_tolerance_mm": 0.005,
    "yield_strength_MPa": 800.0,
    "tensile_strength_MPa": 1000.0,
    "stress_concentration": 1.2,
    "eccentricity_mm": 2.0,
    "fatigue": {"surface": "ground", "reliability_percent": 99},
    "requirements": {"bending_safety": 1.5, "fatigue_safety": 1.5},
    "include": ["checks"],
}
STEEL = {"youngs_modulus_GPa": 206.0, "poissons_ratio": 0.3, "allowable_pressure_MPa": 1200.0}
SHAFT = {
    "torque_Nm": 100.0,
    "roller_radius_mm": 4.0,
    "roller_circle_radius_mm": 50.0,
    "nutation_angle_deg": 6.0,
    "ratio_u12": 0.96,
    "reference_z_mm": 20.0,
    "rollers": [
        {"position_angle_deg": angle, "z_min_mm": 15.0, "z_max_mm": 25.0}
        for angle in (30.0, 60.0, 90.0, 120.0)
    ],
    "bearing_distance_mm": 60.0,
    "overhang_mm": 30.0,
    "shaft_diameter_mm": 30.0,
    "youngs_modulus_GPa": 206.0,
    "yield_strength_MPa": 600.0,
    "tensile_strength_MPa": 900.0,
    "fatigue": {"surface": "ground", "fatigue_notch_factor": 1.5},
    "line_contact": {"mating_radius_mm": 80.0, "roller_material": STEEL, "mating_material": STEEL},
    "requirements": {"max_deflection_mm": 0.1, "max_slope_mrad": 2.0},
    "include": ["checks"],
}


def numbers(body: Any, pointer: str = "") -> Iterator[str]:
    """Pointers to the numbers of a body that are no counts."""
    for name, value in enumerate(body) if isinstance(body, list) else body.items():
        if isinstance(value, dict | list):
            yield from numbers(value, f"{pointer}/{name}")
        elif isinstance(value, float):
            yield f"{pointer}/{name}"


def moved(body: dict[str, Any], pointer: str) -> dict[str, Any]:
    found = deepcopy(body)
    *sections, last = pointer.split("/")[1:]
    inner = found
    for section in sections:
        inner = inner[int(section)] if isinstance(inner, list) else inner[section]
    inner[last] *= 0.999
    return found


@pytest.mark.parametrize(
    ("path", "body"), [("roller-strength", ROLLERS), ("precession/shaft-deflection", SHAFT)]
)
async def test_what_moves_a_check_is_named(api: Any, path: str, body: dict[str, Any]) -> None:
    async def checks(asked: dict[str, Any]) -> dict[str, Any]:
        answer = await api.post(path, json=asked)
        assert answer.status_code == 200, answer.text
        return {each["code"]: each for each in answer.json()["checks"]}

    before, unnamed, seen = await checks(body), set(), 0
    for pointer in numbers(body):
        for code, after in (await checks(moved(body, pointer))).items():
            values = [(each.get("value"), each.get("limit")) for each in (before[code], after)]
            if values[0] == values[1]:
                continue
            seen += 1
            if not any(pointer.startswith(each) for each in after["inputs"]):
                unnamed.add((code, pointer))
    assert unnamed == set() and seen > 15
