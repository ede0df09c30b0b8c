"""Tie rings and bolted pins over the API: answers, notices, what is judged, what is refused."""

from typing import Any

import pytest

from core.precision import EXACT, SEARCHED

pytestmark = pytest.mark.anyio

PIN = {
    "support": "tie_ring",
    "span_mm": 52.0,
    "satellite_positions_mm": [15.0, 37.0],
    "material": {
        "youngs_modulus_GPa": 210,
        "poissons_ratio": 0.3,
        "tensile_strength_MPa": 1000,
        "yield_strength_MPa": 800,
    },
}
LOAD = {"output_torque_Nm": 500.0, "pin_circle_radius_mm": 50.0}
MECHANISM = {"pins": 6, "satellites": 2, "ratio": 20}
CONTACT = {
    "contact_length_mm": 20.0,
    "pin_radius_mm": 8.0,
    "eccentricity_mm": 2.0,
    "hole_clearance_mm": 0.02,
}
SHARED = {
    "mechanism": MECHANISM,
    "load": LOAD,
    "contact": CONTACT,
    "contact_law": {"kind": "linear", "stiffness_N_per_mm": 1e5},
    "pin": PIN,
    "crank_angle_deg": [10.0],
}
STEEL = {"pin_material": "steel_through_hardened", "hole_material": "steel_through_hardened"}
SMALL = {
    "mechanism": {"pins": 6, "satellites": 1, "ratio": 20},
    "load": {"output_torque_Nm": 10.0, "pin_circle_radius_mm": 25},
    "contact": {
        "contact_length_mm": 5,
        "pin_radius_mm": 3.5,
        "eccentricity_mm": 1,
        "hole_clearance_mm": 0.02,
        **STEEL,
    },
}


def with_pin(body: dict[str, Any], **more: Any) -> dict[str, Any]:
    return body | {"pin": body["pin"] | more}


@pytest.mark.parametrize(
    ("joint", "moment", "end"), [("pinned", 79.27519804, 0), ("clamped", 49.59572195, 26.1029583)]
)
async def test_strength_of_pins_that_a_ring_joins(api, joint, moment, end):
    pin = PIN | {"ring_joint": joint, "contact_length_mm": 20, "diameter_mm": 16}
    body = {"mechanism": MECHANISM, "load": LOAD, "pin": pin, "include": ["deflection", "worked"]}
    found = (await api.post("pin-strength", json=body)).json()
    assert found["peak_moment_Nm"] == pytest.approx(moment, rel=EXACT)
    ring = found["tie_ring"]
    assert ring["peak_end_moment_Nm"] == pytest.approx(end, rel=EXACT)
    assert ring["peak_force_N"] > 800 and ring["shift_mm"] > 0.01 and ring["turn_mrad"] > 0.3
    codes = [each["code"] for each in found.get("warnings", [])]
    assert codes == (["ring_clearance_left_out"] if joint == "pinned" else [])
    worked = {step["code"] for step in found["worked"]}
    assert any(code.startswith("deflection") for code in worked)


async def test_a_ring_that_is_pinned_need_not_say_so(api):
    one = (await api.post("load-sharing", json=SHARED)).json()
    other = (await api.post("load-sharing", json=with_pin(SHARED, ring_joint="pinned"))).json()
    assert one["positions"] == other["positions"]
    (position,) = one["positions"]
    torques = [341.0124270344, 158.9875729656]  # of first order (tests/core/test_tie_ring.py)
    assert position["satellite_torque_Nm"] == pytest.approx(torques, rel=0.01)
    assert [each["code"] for each in one["warnings"]] == ["ring_clearance_left_out"]


async def test_the_whole_design_judges_both_ends(api):
    body = {name: SHARED[name] for name in ("mechanism", "load", "contact_law", "pin")}
    body |= {"contact": CONTACT | STEEL, "fatigue": {"endurance_limit_MPa": 300}}
    asked = body | {"include": ["checks", "pin_strength"]}
    found = (await api.post("crank-planetary", json=with_pin(asked, ring_joint="clamped"))).json()
    checks = {each["code"]: each for each in found["checks"]}
    assert checks["pin_static"]["at"]["section"] == "root"
    assert checks["pin_fatigue"]["at"]["section"] in ("root", "ring")
    assert found["pin_strength"]["tie_ring"]["peak_end_moment_Nm"] > 0
    assert "bolt_opens" not in checks


async def test_tolerances_of_pins_that_a_ring_joins(api):
    """Pieces without deviations are the design: their peak is that of the turn's positions."""
    body = {name: each for name, each in SHARED.items() if name != "crank_angle_deg"}
    study = {"tolerances": {"disc_phase_deg": 1e-9}, "samples": 8, "percentiles": []}
    found = (await api.post("tolerance-study", json=body | study | {"crank_angles": 12})).json()
    turn = (await api.post("load-sharing", json=SHARED | {"include": ["over_turn"]})).json()
    peak = turn["over_turn"]["peak_force_N"]
    assert found["quantities"]["peak_force_N"]["nominal"] == pytest.approx(peak, rel=0.05)


@pytest.mark.parametrize(
    ("bolt", "holds", "statuses"),
    [
        ({}, False, ["not_applicable", "not_applicable"]),
        ({"preload_N": 2000.0}, False, ["marginal", "marginal"]),
        ({"preload_N": 9000.0}, True, ["pass", "pass"]),
        ({"tightening_torque_Nm": 3.0}, False, ["pass", "marginal"]),
    ],
)
async def test_a_bolt_through_a_spacer(api, bolt, holds, statuses):
    pin = {"satellite_positions_mm": [4.5], "bolt": {"core_diameter_mm": 2.459} | bolt}
    body = SMALL | {"pin": pin, "include": ["pin_strength", "checks"]}
    found = (await api.post("crank-planetary", json=body)).json()
    checks = {each["code"]: each for each in found["checks"]}
    strength = found["pin_strength"]
    assert [checks[code]["status"] for code in ("bolt_opens", "bolt_slips")] == statuses
    assert strength["bolt"]["holds"] == holds
    said = {each["code"] for each in found.get("warnings", ())}
    assert ("nut_factor" in said) == ("tightening_torque_Nm" in bolt)
    reasons = {checks[code].get("reason", {}).get("code") for code in ("bolt_opens", "bolt_slips")}
    assert ("bolt_alone" in reasons) != holds
    alone = SMALL | {
        "pin": {"satellite_positions_mm": [4.5], "diameter_mm": 7.0 if holds else 2.459},
        "include": ["pin_strength"],
    }
    (plain,) = [(await api.post("crank-planetary", json=alone)).json()["pin_strength"]]
    for name in ("peak_force_N", "peak_moment_Nm", "peak_bending_stress_MPa"):
        assert strength[name] == pytest.approx(plain[name], rel=EXACT)
    squeeze = bolt.get("preload_N", 0) / 38.48451 if holds else 0.0  # of 7 mm
    stress = plain["peak_equivalent_stress_MPa"] + squeeze
    assert strength["peak_equivalent_stress_MPa"] == pytest.approx(stress, rel=SEARCHED)
    assert checks["pin_static"]["value"] == pytest.approx(stress, rel=SEARCHED)


async def test_a_bolt_has_one_preload(api):
    both = {"core_diameter_mm": 2.459, "preload_N": 1e3, "tightening_torque_Nm": 1.0}
    body = SMALL | {"pin": {"satellite_positions_mm": [4.5], "bolt": both}}
    answer = await api.post("crank-planetary", json=body)
    assert answer.status_code == 422
    assert answer.json()["errors"][0]["pointer"].startswith("/pin/bolt")


async def test_worked_steps_are_of_what_bends(api):
    pin = {"satellite_positions_mm": [4.5], "bolt": {"core_diameter_mm": 2.459}}
    body = SMALL | {"pin": pin, "include": ["pin_strength", "worked"]}
    found = (await api.post("crank-planetary", json=body)).json()
    (step,) = [each for each in found["worked"] if each["code"] == "peak_bending_stress_MPa"]
    assert step["values"]["d"] == pytest.approx(2.459)
