"""Bearings of the satellites over REST."""

import math
from copy import deepcopy

import pytest

from app.examples import REQUESTS
from core.precision import SAME, SEARCHED

pytestmark = pytest.mark.anyio

PATH = "satellite-bearing"
BASE = REQUESTS[PATH]


async def test_only_what_is_known_is_answered(api):
    body = BASE | {"gear": {"kind": "none"}, "bearing": {"kind": "ball"}}
    answer = (await api.post(PATH, json=body)).json()
    assert [each["code"] for each in answer["warnings"]] == ["no_ring_force"]
    assert not {"basic_life_h", "life_h", "static_safety_factor"} & {*answer["satellites"][0]}
    assert answer["radial_force_ratio"] == 0 and "operating_pressure_angle_deg" not in answer


async def test_a_ring_of_pins_relieves_the_bearings(api):
    ring = {"kind": "cycloid", "ring_pin_circle_radius_mm": 84.0}
    answer = (await api.post(PATH, json=BASE | {"gear": ring})).json()
    assert round(answer["radial_force_ratio"], 7) == -0.2241421
    assert 7340 < answer["satellites"][0]["equivalent_load_N"] < 8000
    given = BASE | {"gear": {"radial_force_ratio": answer["radial_force_ratio"]}}
    again = (await api.post(PATH, json=given)).json()
    assert again["satellites"][0]["peak_load_N"] == answer["satellites"][0]["peak_load_N"]


TEETH = {"pins": 6, "satellites": 2, "satellite_teeth": 40, "ring_teeth": 42}
INVOLUTE = {"kind": "involute", "module_mm": 1.9}


async def test_the_difference_is_that_of_the_teeth(api):
    """cos(alpha_w) = m*(z3 - z2)*cos(alpha)/(2*e)."""
    cosine = 1.9 * 2 * math.cos(math.radians(20)) / (2 * 2)
    for gear in (INVOLUTE, INVOLUTE | {"teeth_difference": 2}):
        answer = (await api.post(PATH, json=BASE | {"mechanism": TEETH, "gear": gear})).json()
        angle = math.radians(answer["operating_pressure_angle_deg"])
        assert math.cos(angle) == pytest.approx(cosine, rel=SAME)


async def test_pins_with_another_difference_than_one_are_warned_of(api):
    ring = {"kind": "cycloid", "ring_pin_circle_radius_mm": 84.0}
    for teeth, codes in ((TEETH, ["cycloid_difference"]), (TEETH | {"ring_teeth": 41}, [])):
        ring["ring_pin_circle_radius_mm"] *= 2
        answer = (await api.post(PATH, json=BASE | {"mechanism": teeth, "gear": ring})).json()
        assert [each["code"] for each in answer.get("warnings", ())] == codes


async def test_loads_do_not_ask_how_thick_the_pins_of_the_ring_are(api):
    """A check of the whole design says if ring pins overlap."""
    ring = {"kind": "cycloid", "ring_pin_circle_radius_mm": 84.0}
    thick = ring | {"ring_pin_radius_mm": 80.0}
    plain, pinned = [
        (await api.post(PATH, json=BASE | {"mechanism": TEETH, "gear": gear})).json()
        for gear in (ring, thick)
    ]
    assert pinned["satellites"] == plain["satellites"]


async def test_the_figure_shows_every_satellite(api):
    figure = (await api.post(f"{PATH}/chart", json=BASE)).json()
    assert [each["name"] for each in figure["data"]] == [
        *["Satellite 1"] * 2,
        *["Satellite 2"] * 2,
        "Equivalent load",
    ]


IDLE = {
    "mechanism": {"pins": 8, "satellites": 2, "ratio": 29},
    "load": {"output_torque_Nm": 100, "pin_circle_radius_mm": 34.5, "input_speed_rpm": 1900},
    "contact": {
        "contact_length_mm": 5.28,
        "pin_radius_mm": 5.06,
        "eccentricity_mm": 1.19,
        "hole_clearance_mm": 0.0114,
    },
    "gear": {"radial_force_ratio": 0.25},
    "bearing": {
        "kind": "roller",
        "dynamic_rating_N": 20900.0,
        "static_rating_N": 5370.0,
        "weibull_slope": 1.1,
    },
}
"""Discs turned against each other by more than the load turns them."""


@pytest.mark.parametrize("phases", [[0, 0.02], [0, 0.02, 0.04]])
async def test_a_satellite_that_carries_nothing_is_said(api, phases):
    """The bearing has no life; results of the others do not depend on it."""
    body = deepcopy(IDLE) | {"deviations": {"disc_phase_deg": phases}}
    body["mechanism"]["satellites"] = len(phases)
    answer = (await api.post("satellite-bearing", json=body)).json()
    *idle, worst = answer["satellites"]
    loads = {"peak_load_N", "min_load_N", "equivalent_load_N", "peak_ring_force_N"}
    assert all(each == dict.fromkeys(loads, 0.0) for each in idle)
    assert answer["system_life_h"] == worst["life_h"]
    said = [each for each in answer["warnings"] if each["code"] == "satellite_idle"]
    assert [each["params"]["satellite"] for each in said] == [*range(1, len(phases))]
    assert answer["accuracy"]["relative_error"] < 1e-3
    alone = deepcopy(IDLE)
    alone["mechanism"]["satellites"] = 1
    alone = (await api.post("satellite-bearing", json=alone)).json()["satellites"][0]
    assert worst == {name: pytest.approx(value, rel=1e-3) for name, value in alone.items()}


@pytest.mark.slow
async def test_a_satellite_that_carries_nothing_refuses_nothing(api):
    places = [10.0, 20.0, 30.0]
    support = {"support": "supported", "span_mm": 40.0, "satellite_positions_mm": places}
    body = deepcopy(IDLE) | {
        "deviations": {"disc_phase_deg": [0, 0, 0.035]},  # more than the pins bend
        "friction": {"coefficient": 0.06},
        "crankshaft": {
            "satellite_positions_mm": places,
            "bearing_positions_mm": [0.0, 40.0],
            "bearings": [{"kind": "ball", "dynamic_rating_N": 10000.0}] * 2,
            "satellite_mass_kg": 0.5,
        },
        "pin": support | {"material": {"youngs_modulus_GPa": 206.0, "poissons_ratio": 0.3}},
        "requirements": {"life_h": 1000.0},
    }
    body["mechanism"]["satellites"] = 3
    parts = ("mechanism", "contact", "deviations")
    loads = {"mechanism", "output_torque_Nm", "pin_circle_radius_mm"}
    for path, own in (
        ("crankshaft", ("gear", "crankshaft")),
        ("output-efficiency", ("friction",)),
        ("pin-strength", ("pin",)),
        ("load-sharing", ("pin",)),
    ):
        load = body["load"]
        if path in ("pin-strength", "load-sharing"):
            load = {name: value for name, value in load.items() if name in loads}
        part = {name: body[name] for name in (*parts, *own)} | {"load": load}
        response = await api.post(path, json=part)
        assert response.status_code == 200, (path, response.text)
    response = await api.post("crank-planetary", json=body | {"include": ["checks"]})
    assert response.status_code == 200, response.text
    checks = {each["code"]: each for each in response.json()["checks"]}
    together, worst = checks["system_life"], checks["bearing_life"]
    # the centrifugal force is all that the idle bearings carry: they hardly take of the life
    assert together["status"] in ("pass", "marginal", "fail")
    assert together["value"] == pytest.approx(worst["value"], rel=SEARCHED)
    assert together["value"] < worst["value"]
    assert worst["at"] == {"satellite": 3} == checks["bearing_static"]["at"]
