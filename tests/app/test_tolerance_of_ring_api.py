"""Tolerances of a ring over REST: pieces as `/load-sharing` solves them, refusals."""

import math
from copy import deepcopy
from typing import Any

import pytest

from core.precision import EXACT
from core.ring.series_study import crank_places

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


def changed(**sections: Any) -> dict[str, Any]:
    body = deepcopy(DESIGN | STUDY)
    for name, value in sections.items():
        merged = isinstance(value, dict) and name != "tolerances"
        body[name] = body.get(name, {}) | value if merged else value
    return {name: value for name, value in body.items() if value is not None}


async def answered(api, path, body):
    answer = await api.post(path, json=body)
    assert answer.status_code == 200, answer.text
    return answer.json()


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
    answer = await answered(api, PATH, changed(tolerances=tolerances, samples=1, percentiles=[]))
    places = crank_places(lobes=20, count=4 * 12)
    angles = [math.remainder(math.degrees(each), 20 * 360) for each in places]
    gear = DESIGN["gear"] | {"modification": {"equidistant_mm": 0.018, "pin_circle_mm": -0.007}}
    made = {"ring_pin_radius_mm": [-0.002] * 21, "eccentricity_mm": [0.001] * 2}
    listed = DESIGN | {"gear": gear, "deviations": made, "crank_angle_deg": angles}
    positions = (await answered(api, "load-sharing", listed))["positions"]
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
        tolerances={"ring_pin_position_mm": 0.008, "ring_pin_diameter": {"class": "h6"}},
        quantities=["ring_peak_force_N"],
        limits={"ring_max_pressure_MPa": 1500},
        include=["contributions", "histogram"],
    )
    found = (await answered(api, PATH, body))["quantities"]
    assert [*found] == ["ring_peak_force_N", "ring_max_pressure_MPa"]
    ranked = [each["source"] for each in found["ring_peak_force_N"]["contributions"]]
    assert {*ranked} == {"ring_pin_position_mm", "ring_pin_diameter"}
    assert found["ring_max_pressure_MPa"]["yield"]["limit"] == 1500
    figure = await api.post(f"{PATH}/chart", json=body)
    assert figure.status_code == 200


@pytest.mark.parametrize(
    ("body", "pointer", "code"),
    [
        *[
            (changed(gear=None, satellite_coupling=None, quantities=["peak_force_N"],
                     tolerances={name: value}), f"/tolerances/{name}", "of_another_kind")
            for name, value in (
                ("ring_pin_position_mm", 0.01),
                ("ring_pin_diameter", {"class": "h6"}),
                ("equidistant_mm", 0.01),
                ("modification_pin_circle_mm", {"lower_mm": 0, "upper_mm": 0.01}),
            )
        ],
        (changed(gear=None, satellite_coupling=None, tolerances={"pin_position_mm": 0.01}),
         "/quantities/5", "of_another_kind"),
        (changed(gear=None, satellite_coupling=None, tolerances={"pin_position_mm": 0.01},
                 quantities=["peak_force_N"], limits={"ring_max_pressure_MPa": 900}),
         "/limits/ring_max_pressure_MPa", "of_another_kind"),
        (changed(gear=None) | {"gear": {"kind": "none"}}, "/gear/kind", "outside_method"),
        (changed(satellite_coupling={"kind": "rigid"}), "/tolerances/ring_pin_position_mm",
         "of_another_kind"),
        (changed(gear=None), "/gear", "needed_beside"),
        (changed(samples=100_000), "/samples", "service_limit"),
        (changed(gear={"ring_pin_radius_mm": 300},
                 tolerances={"ring_pin_diameter": {"class": "h6"}}),
         "/gear/ring_pin_radius_mm", "undercut"),
        (changed(tolerances={"equidistant_mm": {"lower_mm": 0, "upper_mm": 0.01, "common": True}}),
         "/tolerances/equidistant_mm/common", "extra_forbidden"),
        (changed(tolerances={"equidistant_mm": {"lower_mm": 0.02, "upper_mm": 0.01}}),
         "/tolerances/equidistant_mm/lower_mm", "at_most"),
        (changed(tolerances={"equidistant_mm": {"lower_mm": -5, "upper_mm": 0}}),
         "/tolerances/equidistant_mm", "greater_than"),
        (changed(tolerances={"equidistant_mm": {"lower_mm": 0, "upper_mm": 40}}),
         "/gear/ring_pin_radius_mm", "undercut"),
    ],
)  # fmt: skip
async def test_refusals(api, body, pointer, code):
    response = await api.post(PATH, json=body)
    assert response.status_code == 422, response.text
    found = [(each["pointer"], each["code"]) for each in response.json()["errors"]]
    assert (pointer, code) in found
