"""A check's reserve is its own, and none stands beside what cannot exist."""

import copy
import random

import pytest

from app.examples import EXAMPLES
from core.checks.reserve import NEAR
from core.precision import EXACT
from tests.inputs.bodies import changed
from tests.inputs.failing import failing
from tests.oracles.seeds import seeds

pytestmark = pytest.mark.anyio

BENT = {
    "mechanism": {"pins": 6, "satellites": 2, "ratio": 20},
    "load": {"output_torque_Nm": 400, "pin_circle_radius_mm": 50},
    "contact": {
        "contact_length_mm": 20,
        "pin_radius_mm": 8,
        "hole_radius_mm": 10.03,
        "eccentricity_mm": 2.0,
        "pin_material": "steel_bearing",
        "hole_material": {
            "youngs_modulus_GPa": 210,
            "poissons_ratio": 0.3,
            "yield_strength_MPa": 345,
            "allowable_pressure_MPa": 2000,
        },
    },
    "pin": {
        "satellite_positions_mm": [15, 40],
        "support": "cantilever",
        "material": "steel_through_hardened",
    },
    "include": ["checks", "largest_torque"],
}


DESIGNS = {
    "bent pins with clearance": changed(BENT),
    "bent pins without": changed(BENT, contact={"hole_radius_mm": 10.0, "hole_clearance_mm": 0.0}),
    "clearance": changed(BENT, pin=None),
    "ideal": changed(BENT, pin=None, contact={"hole_radius_mm": 10.0, "hole_clearance_mm": 0.0}),
    "deviations": changed(
        BENT, pin=None, deviations={"pin_tangential_mm": [0.01, 0, 0, -0.01, 0, 0]}
    ),
}


def times(body, factor):
    """A design under so many times its torque."""
    body = copy.deepcopy(body)
    body["load"]["output_torque_Nm"] *= factor
    return body


async def checks_of(api, body):
    answer = await api.answer("crank-planetary", body | {"include": ["checks"]})
    return {each["code"]: each for each in answer["checks"]}


@pytest.mark.parametrize("name", DESIGNS)
async def test_at_its_reserve_a_check_is_at_its_limit(api, name):
    """Every check by ideal forces is; by solved forces the first to fail is, from below."""
    body = DESIGNS[name]
    answer = await api.answer("crank-planetary", body)
    reserves = {
        each["code"]: each["torque_reserve"]
        for each in answer["checks"]
        if each["code"].startswith("contact_") and "torque_reserve" in each
    }
    ideal, first = name == "ideal", answer["torque_reserve"]
    several = {"contact_yield_hole", "contact_shakedown_hole", "contact_pressure_pin"}
    assert several <= {*reserves} if ideal else [*reserves.values()] == [first]
    for code, reserve in reserves.items():
        check = (await checks_of(api, times(body, reserve)))[code]
        assert check["value"] == pytest.approx(check["limit"], rel=EXACT if ideal else NEAR - 1), (
            code
        )
        assert ideal or check["value"] <= check["limit"]
    assert first in reserves.values()


@pytest.mark.parametrize("include", [["checks"], ["fixes"], None])
async def test_no_largest_torque_is_looked_for_that_nobody_asks(api, include, monkeypatch):
    monkeypatch.setattr("core.checks.reserve._Torques.bracket", None)
    for name in ("ideal", "clearance"):
        asked = {name: part for name, part in DESIGNS[name].items() if name != "include"}
        answer = await api.answer(
            "crank-planetary", asked | ({"include": include} if include else {})
        )
        assert not {"torque_reserve", "largest_torque_Nm", "largest_torque_of"} & {*answer}


@pytest.mark.parametrize("seed", seeds(8, 92))
async def test_a_reserve_lies_between_a_torque_that_holds_and_one_that_fails(api, seed):
    """By fresh requests, of designs whose contact is beyond its limit, or far below it: with ideal
    forces, with clearance, with pins that bend.
    """
    body = failing(1 + seed % 3, seed=seed)[-1]
    body = times(body, 10 ** random.Random(seed).uniform(-2, 0)) | {
        "include": ["checks", "largest_torque"]
    }
    found = await api.answer("crank-planetary", body)
    torque, reserve = found["largest_torque_Nm"], found["torque_reserve"]
    assert torque == pytest.approx(body["load"]["output_torque_Nm"] * reserve)
    held, failed = [
        await checks_of(api, body | {"load": body["load"] | {"output_torque_Nm": torque * factor}})
        for factor in (1, 1.01)
    ]
    moved = [code for code, each in held.items() if "/load/output_torque_Nm" in each["inputs"]]
    assert not any(held[code]["status"] == "fail" for code in moved)
    first = [each for each in found["checks"] if each.get("torque_reserve") == reserve]
    assert first
    for each in first:
        there = failed[each["code"]]
        assert there["status"] == "fail" or there["reason"]["code"] == "range_decides"


@pytest.mark.parametrize(
    "impossible",
    [
        {"contact": {"pin_radius_mm": 26, "hole_radius_mm": 28.03}},  # pins overlap
        {"contact": {"hole_radius_mm": 9.0}},  # too small a hole
        {"deviations": {"disc_phase_deg": [0, 5]}},  # discs out of phase
    ],
)
async def test_no_reserve_beside_what_cannot_exist(api, impossible):
    body = changed(BENT, pin=None, **impossible)
    answer = (await api.post("crank-planetary", json=body)).json()
    assert answer["verdict"] == "fail"
    assert not {"torque_reserve", "largest_torque_Nm"} & {*answer}
    assert all("torque_reserve" not in each for each in answer["checks"])
    assert any(each.get("impossible") for each in answer["checks"])


async def test_a_cycloid_that_is_none_is_refused_with_the_number(api):
    body = changed(BENT, pin=None, gear={"kind": "cycloid", "ring_pin_circle_radius_mm": 40})
    body |= {"mechanism": {"pins": 4, "satellites": 1, "satellite_teeth": 19, "ring_teeth": 20}}
    (error,) = (await api.post("crank-planetary", json=body)).json()["errors"]
    assert error["code"] == "no_cycloid" and error["params"]["limit"] == pytest.approx(40)
    assert "40" in error["detail"]


CONTACT = {
    "mechanism": {"pins": 8, "satellites": 2, "ratio": 20},
    "load": {"output_torque_Nm": 100, "pin_circle_radius_mm": 35},
    "contact": {
        "contact_length_mm": 10,
        "pin_radius_mm": 5,
        "eccentricity_mm": 1,
        "hole_clearance_mm": 0,
    },
    "requirements": {"scope": ["contact"]},
    "include": ["checks", "largest_torque"],
}


def having(**sections):
    return CONTACT | {name: CONTACT.get(name, {}) | own for name, own in sections.items()}


async def test_ideal_forces_do_not_pass_what_a_tenth_more_torque_leaves_unknown(api):
    """The contact wraps, in a disc that ends near its holes."""
    body = having(
        mechanism={"pins": 6},
        load={"output_torque_Nm": 1300, "pin_circle_radius_mm": 40},
        contact={
            "pin_radius_mm": 7,
            "eccentricity_mm": 0.5,
            "hole_material": "steel_case_hardened",
        },
        satellite_body={"bore_radius_mm": 29},
    )
    more = await api.answer("crank-planetary", times(body, 1.1))
    assert more["verdict"] == "incomplete"
    assert {each.get("reason", {}).get("code") for each in more["checks"]} >= {"disc_ovals"}
    found = await api.answer("crank-planetary", body)
    assert found["verdict"] == "marginal" and "torque_reserve" not in found  # none that fails
    farther = await api.answer("crank-planetary", body | {"satellite_body": {"bore_radius_mm": 20}})
    assert (farther["verdict"], farther["torque_reserve"] > 2) == ("pass", True)


@pytest.mark.parametrize(("limit", "verdict"), [(4.262, "marginal"), (4.2645, "pass")])
async def test_lost_motion_fails_under_more_torque_as_pressures_do(api, limit, verdict):
    body = having(
        contact={"hole_clearance_mm": 0.02},
        load={"input_speed_rpm": 100},
        requirements={"max_lost_motion_arcmin": limit},
    )
    found = await api.answer("crank-planetary", body)
    assert (found["verdict"], found["governing"]) == (verdict, "lost_motion")
    (lost,) = (each for each in found["checks"] if each["code"] == "lost_motion")
    assert lost["torque_reserve"] == found["torque_reserve"] < 1.33
    at_limit = await checks_of(api, times(body, found["torque_reserve"]))
    assert 1 / 1.01 < at_limit["lost_motion"]["utilisation"] <= 1
    assert (await api.answer("crank-planetary", times(body, 1.01 * found["torque_reserve"])))[
        "verdict"
    ] == "fail"
    easy = await api.answer("crank-planetary", body | {"requirements": {"scope": ["contact"]}})
    assert easy["torque_reserve"] > found["torque_reserve"]


TIED = {
    "mechanism": {"pins": 3, "satellite_teeth": 10, "ring_teeth": 11},
    "load": {"output_torque_Nm": 960.9, "pin_circle_radius_mm": 49.6},
    "contact": CONTACT["contact"] | {"pin_material": "plastic_pla_printed"},
    "pin": {"satellite_positions_mm": [6, 18], "support": "tie_ring", "span_mm": 24},
    "include": ["checks", "largest_torque"],
}
BENDING = {"satellite_positions_mm": [6, 18]}
SERIES = {
    "mechanism": {"pins": 8, "satellites": 2, "satellite_teeth": 10, "ring_teeth": 11},
    "load": {"output_torque_Nm": 100, "pin_circle_radius_mm": 25},
    "contact": {
        "contact_length_mm": 15,
        "pin_radius_mm": 4,
        "eccentricity_mm": 2,
        "hole_clearance_mm": 0.01,
    },
    "gear": {
        "kind": "cycloid",
        "ring_pin_circle_radius_mm": 40,
        "ring_pin_radius_mm": 4,
        "modification": {"equidistant_mm": 0.02},
    },
    "requirements": {"scope": ["contact"]},
    "include": ["checks", "largest_torque"],
}
UNKNOWN = having(pin=BENDING) | {
    "contact": {
        name: size for name, size in CONTACT["contact"].items() if name != "hole_clearance_mm"
    }
}
OVERLOADED = {
    "a contact wraps": having(contact={"pin_material": "plastic_pla_printed"}),
    "a tie ring, and a contact wraps": TIED,
    "clearance unknown": UNKNOWN,
    "in series": SERIES,
    "another part fails": having(
        contact={"hole_clearance_mm": 0.02},
        satellite_body={"root_radius_mm": 30},
        requirements={"scope": ["contact", "body"]},
    ),
}


@pytest.mark.parametrize("name", OVERLOADED)
@pytest.mark.parametrize("factor", [1e3, 1e4, 1e6])
async def test_what_fails_under_less_torque_fails(api, name, factor):
    """A failure on the way to the torque counts as far as it is known there."""
    found = await api.answer("crank-planetary", times(OVERLOADED[name], factor))
    assert found["verdict"] == "fail"
    (contact,) = (part for part in found["parts"] if part["code"] == "contact")
    assert contact["status"] == "fail"


async def test_a_coupling_is_offered_no_second_satellite(api):
    body = having(
        load={"output_torque_Nm": 300},
        contact={"hole_clearance_mm": 0.02},
    ) | {"mechanism": {"pins": 8, "satellites": 1, "output": "coupling"}, "include": ["fixes"]}
    found = await api.answer("crank-planetary", body)
    offered = {each["pointer"] for each in found["fixes"]}
    assert "/mechanism/pins" in offered and "/mechanism/satellites" not in offered


async def test_losses_alone_are_looked_at_under_more_torque_too(api):
    """No pressure is judged, and the efficiency falls with the torque."""
    body = having(
        load={"input_speed_rpm": 1000},
        contact={"hole_clearance_mm": 0.02},
        requirements={"scope": ["losses"], "min_efficiency": 0.9},
    ) | {"friction": {"coefficient": 0.05}}
    now, more = [
        (await checks_of(api, times(body, each)))["efficiency"]["value"] for each in (1, 1.1)
    ]
    assert more < now
    asked = body | {"requirements": {"scope": ["losses"], "min_efficiency": (now + more) / 2}}
    found = await api.answer("crank-planetary", asked)
    assert (found["verdict"], found["governing"]) == ("marginal", "efficiency")
    assert 1 < found["torque_reserve"] < 1.1
    assert (await api.answer("crank-planetary", times(asked, 1.1)))["verdict"] == "fail"
    sure = await api.answer("crank-planetary", body)
    assert sure["verdict"] == "pass" and "torque_reserve" not in sure


@pytest.mark.parametrize("torque", [200, 300, 420])
async def test_of_two_limits_of_a_pressure_the_lower_one_governs(api, torque):
    """The disc's material has the lower limit, so that it fails first as the torque grows."""
    body = next(each["input"] for each in EXAMPLES if each["id"] == "cycloid")
    load = body["load"] | {"output_torque_Nm": torque}
    exact = {"tolerances": {"ring_pin_position_mm": 0.0}, "include": ["checks"]}
    answer = await api.answer("crank-planetary", body | {"load": load} | exact)
    by_code = {each["code"]: each for each in answer["checks"]}
    disc, pin = (by_code[f"ring_pressure_{body}"] for body in ("disc", "pin"))
    assert disc["utilisation"] > pin["utilisation"]
    assert answer["governing"] == disc["code"]
