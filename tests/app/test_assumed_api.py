"""Assumed values are in the answer; ratios with a sign, below 1, or not whole."""

import pytest

pytestmark = pytest.mark.anyio

ONE_DISC = {"pins": 4, "ratio": 30, "output_torque_Nm": 10.2, "pin_circle_radius_mm": 17}
PRINTED = {
    "mechanism": {"pins": 4, "satellites": 1, "ratio": 30},
    "load": {"output_torque_Nm": 10.2, "pin_circle_radius_mm": 17},
    "contact": {
        "contact_length_mm": 7,
        "pin_radius_mm": 3.5,
        "hole_radius_mm": 4.3,
        "eccentricity_mm": 0.8,
    },
}


async def test_two_satellites_are_assumed_and_the_force_of_one_is_said(api):
    (found,) = (await api.answer("contact-force", ONE_DISC))["assumed"]
    assert (found["pointer"], found["value"]) == ("/satellites", 2)
    one = await api.answer("contact-force", ONE_DISC | {"satellites": 1})
    assert "assumed" not in one
    assert found["without"]["peak_force_N"] == one["peak_force_N"] == pytest.approx(600)
    # two pins of one satellite have a dead centre: there is no such force
    dead_alone = ONE_DISC | {"pins": 2, "crank_spacing_deg": 90}
    (dead,) = (await api.answer("contact-force", dead_alone))["assumed"]
    assert "without" not in dead


@pytest.mark.slow
async def test_materials_that_were_left_out_are_said(api):
    async def said(body):
        answer = await api.answer("crank-planetary", body)
        return {each["pointer"]: each["value"] for each in answer["assumed"]}, answer

    plain, _ = await said(PRINTED)
    materials = {
        "/contact/pin_material": "steel_bearing",
        "/contact/hole_material": "steel_through_hardened",
    }
    assert plain.items() >= materials.items()
    given = {"pin_material": "steel_bearing", "hole_material": "steel_bearing"}
    whole = PRINTED | {"contact": PRINTED["contact"] | given}
    typed, _ = await said(whole)
    assert typed == {name: each for name, each in plain.items() if name not in materials}
    bent, _ = await said(whole | {"pin": {"support": "cantilever", "satellite_positions_mm": [10]}})
    assert bent["/pin/material"] == "steel_bearing"
    hole = {name: value for name, value in whole["contact"].items() if name != "eccentricity_mm"}
    found, answer = await said(whole | {"contact": hole})
    assert found == typed | {"/contact/eccentricity_mm": 0.8}
    assert "eccentricity_assumed" in [each["code"] for each in answer["warnings"]]


@pytest.mark.slow
async def test_a_solution_says_what_its_calculation_assumes(api):
    input = ONE_DISC | {"ratio": -30}
    target = {"pointer": "/peak_force_N", "at_most": 400}
    radius = {"pointer": "/pin_circle_radius_mm", "from": 10, "to": 50}
    body = {"calculation": "contact-force", "input": input, "target": target, "variable": radius}
    answer = await api.answer("solve", body)
    assert answer["assumed"] == [{"pointer": "/input/satellites", "value": 2}]
    assert [each["code"] for each in answer["warnings"]] == ["ratio_sign"]
    number = {"pointer": "/satellites", "from": 1, "to": 4}
    answer = await api.answer("solve", body | {"variable": number})
    assert answer["value"] and "assumed" not in answer


@pytest.mark.slow
async def test_a_solution_of_an_unknown_clearance_is_of_perfect_parts(api):
    """Also where the input by itself is no design: a pin as thick as the value cures."""
    contact = {"contact_length_mm": 20, "pin_radius_mm": 8, "eccentricity_mm": 2}
    input = {
        "mechanism": {"pins": 6, "satellites": 2, "ratio": 20},
        "load": {"output_torque_Nm": 500, "pin_circle_radius_mm": 50},
        "contact": contact | {"pin_material": "steel_bearing", "hole_material": "steel_bearing"},
        "pin": {"diameter_mm": 17, "satellite_positions_mm": [15, 37]},
    }
    body = {"calculation": "crank-planetary", "input": input}
    body["variable"] = {"pointer": "/contact/pin_radius_mm", "from": 8.6, "to": 20}
    body["target"] = {"pointer": "/hertz/max_pressure_MPa", "at_most": 400}
    answer = await api.answer("solve", body)
    assumed = {each["pointer"]: each["value"] for each in answer["assumed"]}
    assert assumed["/input/contact/hole_clearance_mm"] == 0
    input["contact"]["fit"] = "H7/f7"
    answer = await api.answer("solve", body)
    assert "/input/contact/hole_clearance_mm" not in {each["pointer"] for each in answer["assumed"]}


ENDPOINTS = {
    "cyclogram": {"pins": 3, "ratio": 20},
    "hertz": {"force_N": 1000, **PRINTED["contact"]},
    "load-sharing": PRINTED,
    "tolerance-study": PRINTED | {"tolerances": {"hole_position_mm": 0.01}, "samples": 99},
    "output-efficiency": {
        **PRINTED,
        "load": PRINTED["load"] | {"input_speed_rpm": 100},
        "friction": {"coefficient": 0.1},
    },
    "pin-strength": {
        **PRINTED,
        "pin": {"support": "cantilever", "satellite_positions_mm": [10]},
    },
}


@pytest.mark.parametrize("path", ENDPOINTS)
async def test_every_calculation_says_what_it_assumes(api, path):
    body = dict(ENDPOINTS[path])
    if path == "hertz":
        body.pop("eccentricity_mm")
    pointers = [each["pointer"] for each in (await api.answer(path, body))["assumed"]]
    assert pointers
    if "mechanism" in body:
        less = {name: value for name, value in body["mechanism"].items() if name != "satellites"}
        if "pin" in body:
            body["pin"] = body["pin"] | {"satellite_positions_mm": [10, 30]}
        body["mechanism"] = less
        more = [each["pointer"] for each in (await api.answer(path, body))["assumed"]]
        assert more == ["/mechanism/satellites", *pointers]


async def test_a_negative_ratio_has_the_sign_of_the_output(api):
    body = ONE_DISC | {"satellites": 1}
    signed = await api.answer("contact-force", body | {"ratio": -30})
    (warning,) = signed.pop("warnings")
    assert (warning["code"], warning["params"]) == ("ratio_sign", {"ratio": 30})
    plain = await api.answer("contact-force", body)
    for each in (signed, plain):
        del each["accuracy"]["run_time_us"]
    assert signed == plain


HELD = {"support": "cantilever", "satellite_positions_mm": [10]}


@pytest.mark.parametrize(
    ("path", "body", "section", "name"),
    [
        ("hertz", ENDPOINTS["hertz"] | {"eccentricity_mm": None}, "", "dynamic_factor"),
        ("pin-strength", PRINTED | {"pin": HELD}, "contact", "dynamic_factor"),
        ("pin-strength", PRINTED | {"pin": HELD}, "load", "application_factor"),
    ],
)
async def test_a_factor_that_takes_of_the_load_is_said(api, path, body, section, name):
    for factor, said in ((0.8, True), (1.0, False), (1.25, False)):
        own = (body[section] if section else body) | {name: factor}
        asked = body | {section: own} if section else own
        asked = {key: value for key, value in asked.items() if value is not None}
        warnings = (await api.answer(path, asked)).get("warnings", ())
        found = [each["params"] for each in warnings if each["code"] == "load_factor_below_one"]
        assert found == [{"factor": factor}] * said


@pytest.mark.parametrize("ratio", [0.05, -0.05, 0.999])
async def test_a_ratio_below_1_is_refused_with_its_inverse(api, ratio):
    response = await api.post("contact-force", json=ONE_DISC | {"ratio": ratio})
    assert response.status_code == 422
    (error,) = response.json()["errors"]
    assert (error["pointer"], error["code"]) == ("/ratio", "ratio_below_one")
    assert error["params"] == {"limit": 1, "offered": pytest.approx(1 / ratio)}
    zero = (await api.post("contact-force", json=ONE_DISC | {"ratio": 0})).json()["errors"]
    assert zero[0]["code"] == "not_zero"
    teeth = {"satellite_teeth": 10, "ring_teeth": 21}
    body = {name: value for name, value in ONE_DISC.items() if name != "ratio"} | teeth
    (error,) = (await api.post("contact-force", json=body)).json()["errors"]
    assert (error["pointer"], error["code"]) == ("/ring_teeth", "ratio_of_teeth")


async def test_a_cycloid_of_one_lobe_less_has_a_whole_ratio(api):
    gear = {"kind": "cycloid", "ring_pin_circle_radius_mm": 40}
    for ratio, said in ((30, False), (30.5, True)):
        body = PRINTED | {"mechanism": PRINTED["mechanism"] | {"ratio": ratio}, "gear": gear}
        codes = [
            each["code"] for each in (await api.answer("crank-planetary", body)).get("warnings", ())
        ]
        assert ("ratio_not_whole" in codes) == said
