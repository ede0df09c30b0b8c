"""Shares of the satellites over REST, stated or from forces."""

import math
from copy import deepcopy

import pytest

from core.precision import EXACT, SAME

pytestmark = pytest.mark.anyio

PATH = "crank-planetary"
STEEL = {"youngs_modulus_GPa": 210, "poissons_ratio": 0.3}
STATED = {
    "mechanism": {"pins": 6, "satellites": 2, "ratio": 20},
    "load": {"output_torque_Nm": 500.0, "pin_circle_radius_mm": 50.0},
    "contact": {
        "contact_length_mm": 20.0,
        "pin_radius_mm": 8.0,
        "eccentricity_mm": 2.0,
        "distribution_factor": 1.5,
        "pin_material": STEEL,
        "hole_material": STEEL,
    },
    "pin": {
        "diameter_mm": 16.0,
        "satellite_positions_mm": [15.0, 37.0],
        "contact_length_mm": 20.0,
        "support": "cantilever",
    },
}
ALONE = {
    "mechanism": {"pins": 6, "satellites": 1, "ratio": 17},
    "load": {"output_torque_Nm": 8.8, "pin_circle_radius_mm": 32.9},
    "contact": {
        "contact_length_mm": 6.35,
        "pin_radius_mm": 2.5,
        "hole_radius_mm": 3.8,
        "eccentricity_mm": 1.3,
        "distribution_factor": 2,
        "hole_material": "steel_s355",
    },
    "pin": {"satellite_positions_mm": [3.675], "material": "steel_s355"},
    "include": ["checks", "pin_strength"],
}
"""One disc, whose pins share unevenly."""


def with_factor(body, factor, **more):
    body = deepcopy(body)
    body["contact"] |= {"distribution_factor": factor} | more
    return body


async def test_an_uneven_share_reaches_the_bending_of_the_pins(api):
    """Specification by a user: d 5 mm at 3.675 mm under 4*T*K/(N*R)."""
    answer = await api.answer(PATH, ALONE)
    force = 4 * 8800 * 2 / (6 * 32.9)
    strength = answer["pin_strength"]
    assert strength["peak_force_N"] == pytest.approx(force, rel=SAME)
    bending = strength["peak_bending_stress_MPa"]
    assert bending == pytest.approx(force * 3.675 * 32 / (math.pi * 5**3), rel=EXACT)
    assert bending == pytest.approx(106.8, abs=0.1)


@pytest.mark.parametrize(
    ("factor", "pressure", "bending"),
    [(1.5, 479.11418126604605, 460.05725737500995), (2.0, 553.2334030530377, 613.4096765000133)],
)
async def test_two_discs_of_which_one_carries_more(api, factor, pressure, bending):
    answer = await api.answer(PATH, with_factor(STATED, factor))
    strength, contact = answer["pin_strength"], answer["hertz"]
    assert strength["peak_bending_stress_MPa"] == pytest.approx(bending, rel=EXACT)
    assert strength["peak_force_N"] == pytest.approx(factor * 1e4 / 3, rel=EXACT)
    level = contact["max_pressure_MPa"] / math.sqrt(contact["line_load_factor"])
    assert level == pytest.approx(pressure, rel=EXACT)
    alone = {name: each for name, each in STATED.items() if name != "pin"}
    answer = await api.answer(PATH, with_factor(alone, factor))
    assert answer["hertz"]["max_pressure_MPa"] == pytest.approx(pressure, rel=EXACT)


async def test_of_pins_there_may_be_more_than_satellites(api):
    answer = await api.answer(PATH, with_factor(STATED, 3.0, distribution_of="pins"))
    assert answer["pin_strength"]["peak_force_N"] == pytest.approx(1e4, rel=SAME)


async def test_a_stated_share_is_answered(api):
    answer = await api.answer(PATH, with_factor(STATED, 1.5) | {"include": ["checks"]})
    shares = answer["shares"]
    assert (shares["model"], shares["reason"]) == ("factor", "given")
    assert shares["largest"] == 0.75
    assert sorted(each["share"] for each in shares["discs"]) == [0.25, 0.75]
    (warned,) = [each for each in answer["warnings"] if each["code"] == "uneven_sharing"]
    assert (warned["params"]["share"], warned["params"]["even"]) == (0.75, 0.5)
    assert "shares" not in await api.answer(PATH, with_factor(STATED, 1.5, distribution_of="pins"))
    loose = with_factor(STATED, 1.0, hole_clearance_mm=0.02)
    del loose["pin"]
    assert "shares" not in await api.answer(PATH, loose)


REDUCER = {
    "mechanism": {"pins": 4, "satellites": 2, "satellite_teeth": 29, "ring_teeth": 30},
    "load": {"output_torque_Nm": 116, "pin_circle_radius_mm": 33.875, "input_speed_rpm": 600},
    "contact": {
        "contact_length_mm": 13.5,
        "pin_radius_mm": 6,
        "hole_radius_mm": 7.250025,
        "eccentricity_mm": 1.250025,
    },
    "pin": {"satellite_positions_mm": [6.75, 23.25], "support": "cantilever"},
    "gear": {
        "kind": "cycloid",
        "ring_pin_circle_radius_mm": 52.5,
        "ring_pin_radius_mm": 3.5,
    },
    "bearing": {"kind": "roller", "dynamic_rating_N": 34500},
    "crankshaft": {
        "satellite_positions_mm": [16, 32.5],
        "bearing_positions_mm": [0, 48.5],
        "bearings": [{"kind": "ball", "dynamic_rating_N": 2850}] * 2,
    },
    "requirements": {"life_h": 10000},
    "include": ["checks", "pin_strength", "crankshaft"],
}
"""An open design of a whole reducer, whose pins are held at one end."""


async def test_a_share_that_decides_is_said(api):
    """A crank bearing lasts 37 h by it, and 1345 h where both satellites carry alike."""
    answer = await api.answer(PATH, REDUCER)
    shares = answer["shares"]
    assert (shares["model"], shares["reason"]) == ("real", "pin_bending")
    assert shares["largest"] == pytest.approx(0.902, abs=1e-3)
    assert shares["discs"][0]["share"] == shares["largest"]
    assert shares["discs"][0]["torque_Nm"] == pytest.approx(116 * shares["largest"], rel=SAME)
    assert answer["governing"] == shares["governs"][0] == "crank_bearing_life"
    governing = answer["checks"][0]
    assert governing["value"] == pytest.approx(36.75, abs=0.1)
    even = {each["check"]: each for each in shares["even"]}["crank_bearing_life"]
    assert (even["unit"], even["status"]) == ("h", "fail")
    assert even["value"] == pytest.approx(1344.6, abs=0.1)
    (warned,) = [each for each in answer["warnings"] if each["code"] == "uneven_sharing"]
    params = warned["params"]
    assert (params["satellite"], params["reason"]) == (1, "pin_bending")
    assert (params["check"], params["unit"]) == ("crank_bearing_life", "h")
    assert (params["check_value"], params["even_value"]) == (governing["value"], even["value"])
    assert "0.902" in warned["detail"] and "1345 h" in warned["detail"]
