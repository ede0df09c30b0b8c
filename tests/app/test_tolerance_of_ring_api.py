"""Tolerances of a ring over REST: pieces as `/load-sharing` solves them, refusals."""

import math
from typing import Any

import pytest

from core.precision import EXACT
from core.ring.series_study import crank_places
from tests.inputs.bodies import changed

pytestmark = pytest.mark.anyio

PATH = "tolerance-study"
STEEL = {"youngs_modulus_GPa": 210, "poissons_ratio": 0.3}
DESIGN: dict[str, Any] = {
    "mechanism": {"pins": 6, "satellites": 2, "satellite_teeth": 20, "ring_teeth": 21},
    "load": {"output_torque_Nm": 240, "pin_circle_radius_mm": 34},
    "contact": {
        "contact_length_mm": 12,
        "pin_radius_mm": 5,
        "eccentricity_mm": 2,
        "hole_clearance_mm": 0.02,
        "pin_material": STEEL,
        "hole_material": STEEL,
    },
    "gear": {
        "kind": "cycloid",
        "contact_length_mm": 12,
        "pin_material": STEEL,
        "disc_material": STEEL,
        "ring_pin_circle_radius_mm": 60,
        "ring_pin_radius_mm": 4,
        "modification": {"equidistant_mm": 0.015, "pin_circle_mm": -0.005},
    },
    "satellite_coupling": {"kind": "ring"},
}
QUANTITIES = [
    "peak_force_N",
    "max_pressure_MPa",
    "transmission_error_arcmin",
    "backlash_max_arcmin",
    "stiffness_min_Nm_per_arcmin",
    "ring_peak_force_N",
    "ring_max_pressure_MPa",
]
STUDY = {
    "tolerances": {"ring_pin_position_mm": 0.008},
    "quantities": QUANTITIES,
    "samples": 6,
    "crank_angles": 12,
    "percentiles": [50],
}


async def test_a_piece_is_what_load_sharing_makes_of_it(api):
    """With equal lower and upper limits the deviations can be listed."""

    def just(value):
        return {"lower_mm": value, "upper_mm": value}

    tolerances = {
        "ring_pin_diameter": just(-0.004),
        "equidistant_mm": just(0.003),
        "modification_pin_circle_mm": just(-0.002),
        "eccentricity_mm": just(0.001),
    }
    answer = await api.answer(
        PATH, DESIGN | STUDY | {"tolerances": tolerances, "samples": 1, "percentiles": []}
    )
    places = crank_places(lobes=20, count=4 * 12)
    angles = [math.remainder(math.degrees(each), 20 * 360) for each in places]
    gear = DESIGN["gear"] | {"modification": {"equidistant_mm": 0.018, "pin_circle_mm": -0.007}}
    made = {"ring_pin_radius_mm": [-0.002] * 21, "eccentricity_mm": [0.001] * 2}
    listed = DESIGN | {"gear": gear, "deviations": made, "crank_angle_deg": angles}
    positions = (await api.answer("load-sharing", listed))["positions"]
    rings = [each["ring"] for each in positions]
    lags = [each["rotation_arcmin"] for each in positions]
    expected = {
        "peak_force_N": max(max(map(max, each["force_N"])) for each in positions),
        "max_pressure_MPa": max(each["max_pressure_MPa"] for each in positions),
        "transmission_error_arcmin": max(lags) - min(lags),
        "backlash_max_arcmin": max(
            each["play_arcmin"][1] - each["play_arcmin"][0] for each in positions
        ),
        "stiffness_min_Nm_per_arcmin": min(each["stiffness_Nm_per_arcmin"] for each in positions),
        "ring_peak_force_N": max(max(map(max, each["force_N"])) for each in rings),
        "ring_max_pressure_MPa": max(each["max_pressure_MPa"] for each in rings),
    }
    assert answer["fits"] == 1
    for name, value in expected.items():
        one = answer["quantities"][name]
        assert [one["nominal"], one["mean"]] == pytest.approx([value] * 2, rel=EXACT), name


async def test_what_the_ring_adds_is_ranked_and_kept(api):
    body = changed(
        DESIGN | STUDY,
        tolerances={"ring_pin_position_mm": 0.008, "ring_pin_diameter": {"class": "h6"}},
        quantities=["ring_peak_force_N"],
        limits={"ring_max_pressure_MPa": 1500},
        include=["contributions", "histogram"],
    )
    found = (await api.answer(PATH, body))["quantities"]
    assert [*found] == ["ring_peak_force_N", "ring_max_pressure_MPa"]
    ranked = [each["source"] for each in found["ring_peak_force_N"]["contributions"]]
    assert {*ranked} == {"ring_pin_position_mm", "ring_pin_diameter"}
    assert found["ring_max_pressure_MPa"]["yield"]["limit"] == 1500
    figure = await api.post(f"{PATH}/chart", json=body)
    assert figure.status_code == 200
