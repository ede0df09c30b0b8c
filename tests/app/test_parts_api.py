"""Parts, scope, clearance and fit over REST: a winch of 5 kN*m, which passed with whatever was not
said of it.
"""

from copy import deepcopy

import pytest

from core.design.sections import PART_NAMES
from core.precision import EXACT

pytestmark = pytest.mark.anyio

PATH = "crank-planetary"
WINCH = {
    "mechanism": {"pins": 12, "satellites": 2, "satellite_teeth": 43, "ring_teeth": 44},
    "load": {
        "output_torque_Nm": 5000,
        "pin_circle_radius_mm": 124,
        "input_speed_rpm": 1000,
        "application_factor": 1.25,
        "peak_torque_Nm": 8000,
    },
    "contact": {
        "contact_length_mm": 28,
        "pin_radius_mm": 22,
        "eccentricity_mm": 2.75,
        "hole_radius_mm": 24.75,
        "pin_material": "steel_bearing",
        "hole_material": "steel_bearing",
    },
    "pin": {
        "satellite_positions_mm": [19.0, 52.0],
        "support": "supported",
        "span_mm": 75,
        "diameter_mm": 30,
        "material": {
            "youngs_modulus_GPa": 207,
            "poissons_ratio": 0.3,
            "yield_strength_MPa": 1700,
            "tensile_strength_MPa": 2000,
        },
    },
    "fatigue": {"surface": "ground", "fatigue_notch_factor": 1.3, "reliability_percent": 99},
    "friction": {"coefficient": 0.05, "sleeve": True},
    "gear": {"kind": "cycloid", "ring_pin_circle_radius_mm": 190, "ring_pin_radius_mm": 9},
    "bearing": {"kind": "roller", "dynamic_rating_N": 220000, "static_rating_N": 250000},
    "satellite_body": {"outer_radius_mm": 183.75, "bore_radius_mm": 78},
    "requirements": {"life_h": 6300},
    "include": ["checks"],
}
FITTED = {name: value for name, value in WINCH["contact"].items() if name != "hole_radius_mm"}
FITTED |= {"fit": "H7/f7"}
VANISHING = {
    "torque": {"load": {"output_torque_Nm": 1e-9, "peak_torque_Nm": 2e-9}},
    "rating": {"bearing": {"dynamic_rating_N": 1e-12, "static_rating_N": 1e-12}},
    "circle": {"load": {"pin_circle_radius_mm": 1e-6}},
}
BY_FORCES = ("contact", "pins", "satellite_bearing", "crank_bearings")


def winch(**sections):
    """The winch with other fields of its sections."""
    body = deepcopy(WINCH)
    for name, fields in sections.items():
        if isinstance(fields, dict) and name != "contact":
            body[name] = body.get(name, {}) | fields
        else:
            body[name] = fields
    return body


async def asked(api, body, path=PATH):
    response = await api.post(path, json=body)
    assert response.status_code == 200, response.text
    answer = response.json()
    parts = {each["code"]: each for each in answer.get("parts", ())}
    return answer, parts, {each["code"]: each for each in answer.get("checks", ())}


async def test_of_what_is_not_known_of_the_clearance_nothing_is_green(api):
    answer, parts, checks = await asked(api, WINCH)
    assert answer["verdict"] == "incomplete"
    assert not {"largest_torque_Nm", "torque_reserve"} & {*answer}
    assert {code for code in BY_FORCES if parts[code]["status"] != "open"} == set()
    assert parts["contact"]["reason"] == "clearance_unknown"
    assert parts["contact"]["missing"] == ["/contact/hole_clearance_mm"]
    assert parts["teeth"]["reason"] == "modification_unknown"
    assert parts["body"]["status"] == "pass"
    assert parts["losses"]["status"] == "not_asked"  # friction alone asks nothing
    assert checks["interference"]["missing"] == ["/contact/hole_clearance_mm"]
    assert [each["code"] for each in answer.get("warnings", ())] == []  # which the checks say
    quiet, _, _ = await asked(api, WINCH | {"include": ["hertz"]})
    assert "clearance_unknown" in [each["code"] for each in quiet["warnings"]]


@pytest.mark.slow
async def test_a_fit_is_a_clearance(api):
    """H7 of 49.5 mm: 0..25 um; f7 of 44 mm: -50..-25 um: (12.5 + 37.5)/2."""
    include = ["checks", "largest_torque"]
    fitted, parts, checks = await asked(api, winch(contact=FITTED, include=include))
    loose = {name: value for name, value in FITTED.items() if name != "fit"}
    contact = loose | {"hole_clearance_mm": 0.025}
    number, *_ = await asked(api, winch(contact=contact, include=include))
    assert fitted["fit"]["least_room_mm"] == pytest.approx(0.025, abs=1e-9)
    assert fitted["largest_torque_Nm"] == pytest.approx(number["largest_torque_Nm"], rel=EXACT)
    assert fitted["largest_torque_of"] == ["contact", "pins"]
    assert fitted["model"] == "real" and parts["pins"]["status"] == "pass"
    assert fitted["verdict"] == "incomplete"  # of teeth, crankshaft, demands on the losses
    assert checks["clearance"]["value"] == pytest.approx(0.025 / 2.75)
    without = [part for part in PART_NAMES if part != "teeth"]  # whose modification is not known
    asking = {
        "include": ["usual_fit", "largest_torque"],
        "requirements": {"life_h": 6300, "scope": without},
    }
    usual, *_ = await asked(api, WINCH | asking)
    beside = usual["usual_fit"]
    assert (beside["class"], beside["verdict"]) == ("H7/f7", "incomplete")
    assert beside["hole_clearance_mm"] == pytest.approx(0.025)
    assert beside["largest_torque_Nm"] == pytest.approx(fitted["largest_torque_Nm"], rel=EXACT)
    none, *_ = await asked(api, winch(contact=FITTED, include=["usual_fit"]))
    assert "usual_fit" not in none


async def test_only_what_is_in_scope_is_judged(api):
    fitted = winch(contact=FITTED, include=["checks", "largest_torque"])
    alone, parts, checks = await asked(api, fitted | {"requirements": {"scope": ["contact"]}})
    assert alone["verdict"] == "pass"
    assert "largest_torque_Nm" not in alone  # before it fails the disc ends too near its holes
    assert {each["status"] for code, each in parts.items() if code != "contact"} == {"left_out"}
    assert not {"pin_static", "bearing_life", "wall_holes"} & {*checks}
    assert "pins" in alone["not_considered"] and "contact" not in alone["not_considered"]
    whole, *_ = await asked(api, fitted)
    assert whole["largest_torque_of"] == ["contact", "pins"]
    for scope in ([], ["contact", "paint"]):
        response = await api.post(PATH, json=winch(requirements={"scope": scope}))
        assert response.status_code == 422


FAILS = {
    "a bearing of 1 MN": (
        {"bearing": {"dynamic_rating_N": 1e7, "static_rating_N": 1e7}},
        ("satellite_bearing", "bearing_rating", "fail"),
    ),
    "a bearing that does not go in": (
        {"bearing": {"bore_diameter_mm": 60, "outer_diameter_mm": 170, "width_mm": 28}},
        ("satellite_bearing", "bearing_fits", "fail"),
    ),
    "a bearing that turns too fast": (
        {"bearing": {"limiting_speed_rpm": 1000}},
        ("satellite_bearing", "bearing_speed", "fail"),
    ),
    "a sleeve of 0.05 mm": ({"pin": {"diameter_mm": 43.9}}, ("pins", "wall_sleeve", "marginal")),
    "a wall of 1 mm": (
        {"satellite_body": {"bore_radius_mm": 98.2}},
        ("body", "wall_bore", "marginal"),
    ),
    "a peak of 300 times the torque": (
        {"load": {"peak_torque_Nm": 1.5e6}},
        ("contact", "contact_static_pin", "fail"),
    ),
}


@pytest.mark.parametrize("name", FAILS)
async def test_what_passed_because_nobody_asked(api, name):
    changes, (part, code, status) = FAILS[name]
    body = winch(contact=FITTED, **changes) | {"friction": None}
    body.pop("friction")
    _, parts, checks = await asked(api, body)
    assert checks[code]["status"] == status
    assert parts[part]["status"] in (status, "fail"), parts[part]


async def test_the_peak_is_of_a_start_or_of_an_emergency_stop(api):
    for kind, limit in (("start", 1.5), ("emergency", 1.0)):
        _, _, checks = await asked(api, winch(contact=FITTED, load={"peak_kind": kind}))
        assert checks["bearing_static"]["limit"] == limit


async def test_another_mechanism_is_refused_by_name(api):
    response = await api.post(PATH, json=winch(mechanism={"output": "crankshafts"}))
    error = response.json()["errors"][0]
    assert (error["pointer"], error["code"]) == ("/mechanism/output", "not_this_mechanism")


async def test_a_study_draws_both_classes_of_a_fit_about_the_basic_sizes(api):
    body = {name: WINCH[name] for name in ("mechanism", "contact")}
    body["load"] = {"output_torque_Nm": 5000, "pin_circle_radius_mm": 124}
    study = {"samples": 200, "quantities": ["backlash_max_arcmin"]}
    classes = {"pin_diameter": {"class": "f7"}, "hole_diameter": {"class": "H7"}}
    one = await api.post(
        "tolerance-study", json=body | study | {"contact": FITTED, "tolerances": {}}
    )
    basic = FITTED | {"hole_clearance_mm": 0.0}
    basic.pop("fit")
    other = await api.post(
        "tolerance-study", json=body | study | {"contact": basic, "tolerances": classes}
    )
    assert one.status_code == other.status_code == 200, one.text
    assert one.json()["quantities"] == other.json()["quantities"]
    both = body | study | {"contact": FITTED, "tolerances": classes}
    refused = (await api.post("tolerance-study", json=both)).json()["errors"][0]
    assert (refused["pointer"], refused["code"]) == ("/tolerances/pin_diameter", "only_one")


async def test_an_unknown_clearance_is_said_to_be(api):
    for path in ("load-sharing", "output-efficiency", "satellite-bearing"):
        body = {name: WINCH[name] for name in ("mechanism", "load", "contact")}
        body["contact"] = {n: v for n, v in FITTED.items() if n != "fit"}
        if path == "output-efficiency":
            body["friction"] = {"coefficient": 0.05}
        if path == "satellite-bearing":
            body |= {"gear": WINCH["gear"], "bearing": WINCH["bearing"]}
        answer, *_ = await asked(api, body, path)
        assert "clearance_unknown" in [each["code"] for each in answer["warnings"]], path
        body["contact"] = FITTED
        answer, *_ = await asked(api, body, path)
        assert "clearance_unknown" not in [each["code"] for each in answer.get("warnings", ())]


@pytest.mark.parametrize("what", VANISHING)
async def test_what_next_to_vanishes_is_judged_too(api, what):
    """Forces below their own error are not looked at ever closer, lives without end compare, and a
    part that a refusal opens says it in the refusal's words.
    """
    answer = await api.post(PATH, json=winch(contact=FITTED, **VANISHING[what]))
    assert answer.status_code == 200, answer.text
    body = answer.json()
    assert body["verdict"] == {"torque": "incomplete", "rating": "fail", "circle": "fail"}[what]
    for part in body["parts"]:
        assert ("detail" in part) == (part["status"] == "open")
