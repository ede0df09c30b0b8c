"""The crank-planetary endpoints as another program uses them."""

import json
import random
from unittest.mock import patch

import pytest
from mpmath import mp, mpf

from core.precision import SEARCHED
from tests.oracles.seeds import seeds

MECHANISM = {"pins": 3, "ratio": 20}
LOAD = {"output_torque_Nm": 500, "pin_circle_radius_mm": 50}
CONTACT = {"contact_length_mm": 20, "pin_radius_mm": 8, "hole_radius_mm": 10}
JOB = {"mechanism": MECHANISM, "load": LOAD, "contact": CONTACT | {"eccentricity_mm": 2}}
DEFAULT = {"pin_material": "steel_bearing", "hole_material": "steel_through_hardened"}

pytestmark = pytest.mark.anyio


async def test_curves_have_the_pairs_in_order_and_reach_the_peak(api):
    body = {**MECHANISM, **LOAD, "include": ["curves"], "samples": 3601}
    answer = (await api.post("contact-force", json=body)).json()
    curves = answer["curves"]
    assert [(p["satellite"], p["pin"]) for p in curves["pairs"]] == [
        (j, n) for j in (1, 2) for n in (1, 2, 3)
    ]
    assert len(curves["force_N"]) == 6 and len(curves["crank_angle_deg"]) == 3601
    largest = max(max(force) for force in curves["force_N"])
    assert largest == pytest.approx(answer["peak_force_N"], rel=SEARCHED)


async def test_only_what_is_asked_is_in_the_answer(api):
    answer = (await api.post("contact-force", json={**MECHANISM, **LOAD})).json()
    assert set(answer) == {
        "reference_force_N",
        "peak_force_N",
        "peak_force_ratio",
        "peak_crank_angle_deg",
        "peak_pair",
        "assumed",
        "accuracy",
    }
    assert "null" not in (await api.post("hertz", json={**CONTACT, "force_N": 1000})).text


@pytest.mark.parametrize(
    ("asked", "not_run"),
    [
        (["cyclogram"], ["ideal_forces.contact_force", "crank_planetary_sections.pins_in_holes"]),
        (["contact_force"], ["ideal_forces.cyclogram", "crank_planetary_sections.pins_in_holes"]),
        (["hertz"], ["ideal_forces.cyclogram", "crank_planetary_sections.pins_in_holes"]),
        (["geometry"], ["ideal_forces.cyclogram", "ideal_forces.contact_force"]),
    ],
)
async def test_what_is_not_asked_is_not_run(api, asked, not_run):
    def refuse(**_):
        raise AssertionError("ran what nobody asked for")

    patches = [patch(f"app.calculations.{name}", side_effect=refuse) for name in not_run]
    for each in patches:
        each.start()
    try:
        response = await api.post("crank-planetary", json={**JOB, "include": asked})
    finally:
        for each in patches:
            each.stop()
    assert response.status_code == 200
    assert set(response.json()) == set(asked) | {"model", "warnings", "fit", "assumed"}


async def test_the_verdict_is_there_where_it_is_asked_or_says_why_forces_are_not(api):
    async def answer(body, **asked):
        return (await api.post("crank-planetary", json=body | asked)).json()

    usual, checked = await answer(JOB), await answer(JOB, include=["checks"])
    assert all(usual[name] == checked[name] for name in ("verdict", "governing", "parts"))
    assert "verdict" not in await answer(JOB, include=["hertz"])
    contact = {name: each for name, each in JOB["contact"].items() if name != "hole_radius_mm"}
    pressed = JOB | {"contact": contact | {"hole_clearance_mm": -0.05}}
    refused = await answer(pressed, include=["hertz"])
    assert (refused["verdict"], refused["governing"]) == ("fail", "interference")
    assert "hertz" not in refused


@pytest.mark.parametrize("option", ["curves", "equal_sharing", "approximation"])
async def test_options_of_the_force_run_only_when_named(api, option):
    called = {
        "curves": "force_curves",
        "equal_sharing": "force_peak",
        "approximation": "approximate_peak_ratio",
    }[option]
    import core.output.contact_force as module

    real = getattr(module, called)
    with patch.object(module, called, side_effect=real) as spy:
        await api.post("contact-force", json={**MECHANISM, **LOAD})
        without = spy.call_count
        await api.post("contact-force", json={**MECHANISM, **LOAD, "include": [option]})
        assert spy.call_count - without == without + 1


async def test_no_figure_is_built_without_chart(api):
    with patch("app.calculations.cyclogram.cyclogram_figure", side_effect=AssertionError):
        assert (await api.post("cyclogram", json=MECHANISM)).status_code == 200


async def test_no_forces_are_drawn_of_parts_that_cannot_be_put_together(api):
    contact = {**JOB["contact"], "hole_clearance_mm": -0.05}
    contact.pop("hole_radius_mm", None)
    pressed = {**JOB, "contact": contact, "include": ["contact_force"]}
    answer = await api.post("crank-planetary/chart", json=pressed)
    assert answer.status_code == 422
    assert answer.json()["type"] == "/problems/impossible-mechanism"
    pattern = {**pressed, "include": ["cyclogram"]}
    assert (await api.post("crank-planetary/chart", json=pattern)).status_code == 200


async def test_sections_agree_with_their_own_endpoints(api):
    job = (await api.post("crank-planetary", json=JOB)).json()
    alone = {
        "cyclogram": (await api.post("cyclogram", json=MECHANISM)).json(),
        "contact_force": (await api.post("contact-force", json={**MECHANISM, **LOAD})).json(),
    }
    force = alone["contact_force"]["peak_force_N"]
    alone["hertz"] = (await api.post("hertz", json={**CONTACT, "force_N": force})).json()
    for section, answer in alone.items():
        answer.pop("assumed", None)  # which a design says once
        for name in ("safety", "safety_factor"):  # over the life, which a design has
            answer.pop(name, None), job[section].pop(name, None)
        for given in (answer, job[section]):
            del given["accuracy"]["run_time_us"]
        assert job[section] == answer


async def test_every_answer_carries_its_accuracy_and_its_time(api):
    for path, body in (
        ("cyclogram", MECHANISM),
        ("contact-force", {**MECHANISM, **LOAD}),
        ("hertz", {**CONTACT, "force_N": 1000}),
    ):
        response = await api.post(path, json=body)
        accuracy = response.json()["accuracy"]
        assert set(accuracy) == {
            "method",
            "method_code",
            "relative_error",
            "evaluations",
            "run_time_us",
        }
        assert 0 < accuracy["relative_error"] < 1e-12 and accuracy["run_time_us"] > 0
        assert "calculation;dur=" in response.headers["server-timing"]


@pytest.mark.parametrize("number", ["1e999", "NaN", "-Infinity"])
async def test_no_number_is_refused_by_the_fields_name(api, number):
    response = await api.post(
        "cyclogram",
        content=f'{{"pins": 3, "ratio": {number}}}',
        headers={"content-type": "application/json"},
    )
    assert response.status_code == 422
    (error,) = response.json()["errors"]
    assert error == {
        "pointer": "/ratio",
        "code": "finite_number",
        "params": {},
        "detail": "must be a finite number",
    }


@pytest.mark.parametrize("asked", [{}, {"include": ["cyclogram"]}])
async def test_a_hole_smaller_than_the_pin_is_refused_whatever_is_asked(api, asked):
    contact = {**CONTACT, "hole_radius_mm": 7.9}
    response = await api.post("crank-planetary", json={**JOB, "contact": contact, **asked})
    assert response.status_code == 422
    (error,) = response.json()["errors"]
    assert error == {
        "pointer": "/contact/hole_radius_mm",
        "code": "larger_than",
        "params": {"field": "pin_radius_mm", "limit": 8.0},
        "detail": "must be larger than pin_radius_mm, 8",
    }


@pytest.mark.parametrize(
    "mechanism",
    [
        {"pins": 2, "satellites": 1},
        {"pins": 1, "satellites": 1},
        {"pins": 2, "satellites": 3, "crank_angles_deg": [0, 0, 180]},
        {"pins": 1, "satellites": 2, "crank_spacing_deg": 120},
    ],
)
async def test_a_dead_centre_is_shown_in_the_cyclogram_and_refused_for_the_force(api, mechanism):
    body = {"ratio": 20, "initial_crank_angle_deg": 30, **mechanism}
    cyclogram = (await api.post("cyclogram", json=body)).json()
    response = await api.post("contact-force", json={**body, **LOAD})
    assert response.status_code == 422
    where = response.json()["where"]["crank_angle_deg"]
    assert any(abs(where - each) < 1e-9 for each in cyclogram["dead_centres_deg"])
    detail = response.json()["detail"]
    assert "no pair drives" in detail and "crankshafts" in detail  # of an RV with two of them


async def test_warnings_say_when_the_approximation_is_out_of_its_range(api):
    body = {"pins": 8, "satellites": 1, "ratio": 20, **LOAD, "include": ["approximation"]}
    answer = (await api.post("contact-force", json=body)).json()
    assert answer["approximate_peak_error"] == pytest.approx(0.2, abs=0.005)
    assert [each["code"] for each in answer["warnings"]] == ["approximation_range"]
    assert "pins" in answer["warnings"][0]["detail"]


async def test_materials_have_values_and_sources(api):
    for material in (await api.get("materials")).json()["materials"]:
        assert 0.1 < material.get("youngs_modulus_GPa", 1) < 300 and material["source"]
        body = {**CONTACT, "force_N": 1000, "pin_material": material["name"]}
        known = {"youngs_modulus_GPa", "poissons_ratio"} <= {*material}
        assert (await api.post("hertz", json=body)).status_code == (200 if known else 422)


async def test_the_same_body_gives_the_same_numbers(api):
    first, second = [(await api.post("crank-planetary", json=JOB)).json() for _ in range(2)]
    for answer in (first, second):
        for section in ("cyclogram", "contact_force", "hertz"):
            del answer[section]["accuracy"]["run_time_us"]
    assert json.dumps(first) == json.dumps(second)


async def test_a_contact_wider_than_the_pin_gets_no_safety_factor_unless_a_theory_holds(api):
    soft = {"pin_material": "plastic_pom", "hole_material": "steel_bearing"}
    contact = {**CONTACT, **soft, "hole_radius_mm": 8.001, "force_N": 1e6}
    answer = (await api.post("hertz", json=contact)).json()
    assert answer["half_width_ratio"] > 1 and "safety" not in answer
    assert "governing_pressure_MPa" not in answer
    (said,) = answer["warnings"]
    assert (said["code"], said["was"]) == ("contact_wraps", "hertz_impossible")
    other = {"pin_material": "steel_bearing", "hole_material": "plastic_pom"}
    answer = (await api.post("hertz", json={**contact, **other})).json()
    assert answer["governing_pressure_MPa"] == answer["conformal_pressure_MPa"]
    assert answer["accuracy"]["relative_error"] < 1e-8
    assert [each["code"] for each in answer["warnings"]] == ["finite_strain"]
    same = {**contact, "pin_material": "steel_bearing", "hole_material": "steel_bearing"}
    answer = (await api.post("hertz", json=same)).json()
    assert answer["conformal_pressure_MPa"] > answer["max_pressure_MPa"]
    assert answer["half_width_ratio"] > 1
    assert [each["code"] for each in answer["warnings"]] == ["finite_strain"]
    assert answer["governing_pressure_MPa"] == answer["conformal_pressure_MPa"]
    assert answer["safety_factor"] == pytest.approx(1500 / answer["conformal_pressure_MPa"])


@pytest.mark.parametrize("body", ["pin", "hole"])
async def test_a_body_is_judged_by_its_own_limit_only(api, body):
    """Every material of the table against the default other body."""
    table = {each["name"]: each for each in (await api.get("materials")).json()["materials"]}
    without = {name for name, each in table.items() if "allowable_pressure_MPa" not in each}
    assert without == {
        *("iron_grey", "iron_nodular", "bronze_tin", "bronze_tin_nickel", "bronze_aluminium"),
        *("brass", "plastic_pom", "plastic_pa66", "plastic_pa66_gf30", "plastic_peek"),
        *("aluminium_6061_t6", "aluminium_6082_t6", "aluminium_7075_t6", "bronze_c93200"),
        "steel_bolt",
        *(name for name in table if name.startswith("plastic_")),
    }
    for name in table:
        if not {"youngs_modulus_GPa", "poissons_ratio"} <= {*table[name]}:
            continue  # given by values only
        chosen = DEFAULT | {f"{body}_material": name}
        answer = (await api.post("hertz", json={**CONTACT, **chosen, "force_N": 3000})).json()
        pressure = answer["governing_pressure_MPa"]
        limits = {
            each: table[chosen[f"{each}_material"]].get("allowable_pressure_MPa")
            for each in ("pin", "hole")
        }
        known = {each: limit for each, limit in limits.items() if limit is not None}
        found = {each["body"]: each for each in answer["safety"]}
        assert {each: one["limit_MPa"] for each, one in found.items()} == known
        for each, limit in known.items():
            assert found[each]["criterion"].startswith("endurance") and found[each]["source"]
            assert found[each]["safety_factor"] == pytest.approx(limit / pressure)
        assert ("safety_factor" in answer) == (name not in without), name
        if name not in without:
            assert answer["safety_factor"] == pytest.approx(min(known.values()) / pressure)


async def test_what_is_not_known_of_the_safety_is_absent(api):
    """Nothing of either body, or no pressure; a limit that is given has no source."""
    own = {"youngs_modulus_GPa": 210, "poissons_ratio": 0.3}
    none = {**CONTACT, "force_N": 1000, "pin_material": own, "hole_material": "plastic_pom"}
    given = none | {"pin_material": own | {"allowable_pressure_MPa": 900}}
    for body in (none, {**CONTACT, "force_N": 0}):
        answer = (await api.post("hertz", json=body)).json()
        assert "safety" not in answer and "safety_factor" not in answer
    answer = (await api.post("hertz", json=given)).json()
    (only,) = answer["safety"]
    assert set(only) == {"body", "limit_MPa", "criterion", "safety_factor"}
    assert (only["body"], only["limit_MPa"], only["criterion"]) == ("pin", 900, "given")
    assert "safety_factor" not in answer


@pytest.mark.parametrize(
    ("bore", "code", "error"), [(28 - 3.2 * 8.05, "finite_disc", 0.08), (12.7, "disc_ovals", None)]
)
async def test_an_edge_near_a_contact_that_wraps_is_told(api, bore, code, error):
    contact = {
        "contact_length_mm": 20, "pin_radius_mm": 8, "hole_radius_mm": 8.05,
        "eccentricity_mm": 0.05, "hole_clearance_mm": 0,
        **dict.fromkeys(DEFAULT, "steel_case_hardened"),
    }  # fmt: skip
    load = {"output_torque_Nm": 1000, "pin_circle_radius_mm": 28}
    job = {"mechanism": MECHANISM, "load": load, "contact": contact, "include": ["checks"]}
    answer = (await api.post("crank-planetary", json=job)).json()
    assert code not in [each["code"] for each in answer.get("warnings", ())]
    job["satellite_body"] = {"bore_radius_mm": bore}
    answer = (await api.post("crank-planetary", json=job)).json()
    checks = {each["code"]: each for each in answer["checks"]}
    found = checks["contact_pressure_pin"]
    warned = [each for each in answer["warnings"] if each["code"] == code]
    assert found["status"] == ("not_checked" if error is None else "pass")
    (said,) = warned or [found["reason"]]
    assert said["code"] == code and "{" not in said["detail"]
    assert said["params"]["distance"] == pytest.approx((28 - bore) / 8.05)
    assert said["params"].get("error") == error
    assert found["value"] < found["limit"]


@pytest.mark.parametrize(
    ("change", "codes"),
    [
        ({"eccentricity_mm": 2}, []),
        ({"eccentricity_mm": 2.5}, ["interference"]),
        ({"eccentricity_mm": 1.5}, ["clearance"]),
        ({}, ["eccentricity_assumed"]),
        ({"pins": 12, "pin_circle_radius_mm": 10, "eccentricity_mm": 2},
         ["wall_holes", "pins_apart"]),
        ({"pins": 12, "pin_circle_radius_mm": 35, "eccentricity_mm": 2}, ["wall_holes"]),
        ({"pins": 1, "satellites": 3, "pin_circle_radius_mm": 1, "eccentricity_mm": 2}, []),
    ],
)  # fmt: skip
@pytest.mark.parametrize(
    "include", [None, ["cyclogram"], ["contact_force"], ["hertz"], ["geometry"]]
)
async def test_the_fit_is_said_whichever_sections_are_asked(api, change, codes, include):
    job = {
        part: given | {name: value for name, value in change.items() if name in fields}
        for part, given, fields in (
            ("mechanism", MECHANISM, ("pins", "satellites")),
            ("load", LOAD, ("pin_circle_radius_mm",)),
            ("contact", CONTACT, ("eccentricity_mm",)),
        )
    }
    asked = {} if include is None else {"include": include}
    answer = (await api.post("crank-planetary", json=job | asked)).json()
    if change.get("eccentricity_mm") == 2:
        codes = ["clearance_unknown", *codes]
    assert [each["code"] for each in answer.get("warnings", [])] == codes
    assert all(each["detail"] and "{" not in each["detail"] for each in answer.get("warnings", []))
    assert "warnings" in answer or codes == []
    if include == ["geometry"]:
        alone = [each["code"] for each in answer["geometry"].get("warnings", [])]
        assert alone == [
            code for code in codes if code not in ("eccentricity_assumed", "clearance_unknown")
        ]
    if include == ["cyclogram"]:  # neither circle nor torque is known: only the sizes are judged
        del job["load"]
        answer = (await api.post("crank-planetary", json=job | asked)).json()
        seen = [each["code"] for each in answer.get("warnings", [])]
        assert seen == [code for code in codes if code not in ("wall_holes", "pins_apart")]


async def test_any_peak_force_has_its_pressure_and_its_figure(api):
    """A nearly dead mechanism of extreme size."""
    mechanism = {"pins": 1, "crank_angles_deg": [0, 180 - 1e-9, 180 + 1e-9], "ratio": 1e9}
    load = {"input_torque_Nm": 1e12, "efficiency": 1.0, "pin_circle_radius_mm": 1e-12}
    force = (await api.post("contact-force", json=mechanism | load)).json()["peak_force_N"]
    assert force > 1e45
    contact = {**CONTACT, "force_N": force}
    assert (await api.post("hertz", json=contact)).json()["max_pressure_MPa"] > 1e15
    assert (await api.post("hertz/chart", json=contact)).status_code == 200


@pytest.mark.parametrize("size", [1e-300, 1e300])
async def test_sizes_beyond_any_machine_are_refused_by_field(api, size):
    response = await api.post("hertz", json={**CONTACT, "contact_length_mm": size, "force_N": 1})
    assert response.status_code == 422
    assert response.json()["errors"][0]["pointer"] == "/contact_length_mm"


@pytest.mark.parametrize("seed", seeds(10))
async def test_angles_of_a_cyclogram_are_within_their_error(api, seed):
    """Against 40 digits: cranks many turns on, ranges short and long, digits as they are sent."""
    r = random.Random(seed)
    angles = [r.choice([r.uniform(-3600, 3600), 15.0 * r.randint(-240, 240)]) for _ in range(3)]
    start = r.choice([0.0, 180.0, r.uniform(-3600, 3600)])
    ratio, turns = 10 ** r.uniform(0, 4), r.choice([1.0, 10 ** r.uniform(-3, 2)])
    body = {"pins": r.randint(1, 9), "ratio": ratio, "crank_angles_deg": angles}
    body |= {"revolutions": turns, "initial_crank_angle_deg": start}
    answer = (await api.post("cyclogram", json=body)).json()
    with mp.workdps(40):
        allowed = answer["accuracy"]["relative_error"] * 360 * turns
        period = 360 * mpf(ratio) / (1 + mpf(ratio))
        for pair in answer["pairs"]:
            angle = mpf(angles[pair["satellite"] - 1]) + mpf(start)
            phase = angle / 360 + mpf(pair["pin"] - 1) / body["pins"]
            for start_deg, stop_deg in pair["driving_deg"]:
                for shown, switch in ((start_deg, mpf(1) / 2), (stop_deg, mpf(0))):
                    if 0 < shown < 360 * turns * (1 - 1e-15):
                        wave = shown / period + phase - switch
                        assert abs(wave - mp.nint(wave)) * period <= allowed
