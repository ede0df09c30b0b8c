"""Swinging rollers and the precessional gear over REST."""

import math

import pytest

from core.precision import EXACT, JUDGED, SAME
from tests.inputs.papers import GEAR, MESH, ROLLERS, SHAFT

pytestmark = pytest.mark.anyio


def without(body, *names):
    return {name: value for name, value in body.items() if name not in names}


async def test_points_only_where_asked(api):
    plain = (await api.post("precession/contact-line", json=GEAR)).json()
    assert all("points" not in line for line in plain["lines"])
    asked = GEAR | {"include": ["points"], "samples": 7}
    for line in (await api.post("precession/contact-line", json=asked)).json()["lines"]:
        points = line["points"]
        assert len(points["z_mm"]) == 7 and (points["z_mm"][0], points["z_mm"][-1]) == (15, 25)
        for x, phi in zip(points["x_mm"], points["phi_deg"], strict=True):
            assert x == pytest.approx(4 * math.radians(phi), rel=SAME)


async def test_a_wheel_is_its_rollers_one_by_one(api):
    wheel = {
        "rollers_total": 12,
        "rollers_in_mesh": 4,
        "position_angle_deg": 30,
        "z_min_mm": 15,
        "z_max_mm": 25,
    }
    by_wheel = (
        await api.post("precession/meshing-load", json=without(MESH, "rollers") | {"wheel": wheel})
    ).json()
    one_by_one = (await api.post("precession/meshing-load", json=MESH)).json()
    assert by_wheel["force_N"] == pytest.approx(one_by_one["force_N"], rel=SAME)


async def test_a_stepped_shaft_has_the_papers_simplification_beside_it(api):
    sections = [{"length_mm": 30, "diameter_mm": 20}, {"length_mm": 40, "diameter_mm": 25}]
    body = without(SHAFT, "shaft_diameter_mm") | {"shaft_sections": sections}
    stepped = (await api.post("precession/shaft-deflection", json=body)).json()
    plain = (await api.post("precession/shaft-deflection", json=SHAFT)).json()
    assert stepped["simplified_deflection_C_mm"] == plain["deflection_C_mm"]
    error = plain["deflection_C_mm"]["total"] / stepped["deflection_C_mm"]["total"] - 1
    assert stepped["simplification_error_C"] == pytest.approx(error, rel=SAME)
    assert "simplified_deflection_C_mm" not in plain


@pytest.mark.parametrize(
    ("change", "field"),
    [
        ({"rollers": 0}, "/rollers"),
        ({"rollers": 3.5}, "/rollers"),
        ({"gaps_mm": [0, 0, 0, 0]}, "/gaps_mm"),
        ({"gaps_mm": [0, 0], "position_tolerance_mm": None}, "/gaps_mm"),
        ({"position_tolerance_mm": None}, "/position_tolerance_mm"),
        ({"position_tolerance_mm": -1}, "/position_tolerance_mm"),
        ({"shear_modulus_GPa": 78}, "/shear_modulus_GPa"),
        ({"poissons_ratio": 0.5}, "/poissons_ratio"),
        ({"diameter_mm": 0}, "/diameter_mm"),
        ({"length_mm": 1}, "/length_mm"),
    ],
)
async def test_wrong_rollers_are_refused_by_the_fields_name(api, change, field):
    body = {name: value for name, value in (ROLLERS | change).items() if value is not None}
    response = await api.post("roller-strength", json=body)
    assert response.status_code == 422
    assert [error["pointer"] for error in response.json()["errors"]] == [field]


def roller(**change):
    return {"rollers": [GEAR["rollers"][0], {"position_angle_deg": 60, **change}]}


@pytest.mark.parametrize(
    ("change", "field"),
    [
        ({"nutation_angle_deg": 0}, "/nutation_angle_deg"),
        ({"roller_radius_mm": 60}, "/roller_radius_mm"),
        (roller(z_min_mm=15, z_max_mm=15), "/rollers/1/z_max_mm"),
        (roller(z_min_mm=15), "/rollers/1/z_max_mm"),
        (roller(), "/rollers/1/z_min_mm"),
        (roller(z_min_mm=15, z_max_mm=25, phi_min_deg=3), "/rollers/1/phi_min_deg"),
        (roller(phi_min_deg=-70, phi_max_deg=-50), "/rollers/1/phi_max_deg"),
        (
            {"rollers": [{"position_angle_deg": 180, "z_min_mm": 1, "z_max_mm": 2}]},
            "/rollers/0/position_angle_deg",
        ),
        ({"rollers": []}, "/rollers"),
        ({"rollers": None}, "/rollers"),
        ({"torque_Nm": 0}, "/torque_Nm"),
        ({"overhang_mm": 0}, "/overhang_mm"),
        ({"youngs_modulus_GPa": 0}, "/youngs_modulus_GPa"),
        ({"shaft_diameter_mm": None}, "/shaft_diameter_mm"),
        (
            {"shaft_diameter_mm": None, "shaft_sections": [{"length_mm": 71, "diameter_mm": 20}]},
            "/shaft_sections",
        ),
        (
            {"shaft_diameter_mm": None, "shaft_sections": [{"length_mm": 70, "diameter_mm": 0}]},
            "/shaft_sections/0/diameter_mm",
        ),
    ],
)
async def test_a_wrong_gear_is_refused_by_the_fields_name(api, change, field):
    body = {name: value for name, value in (SHAFT | change).items() if value is not None}
    response = await api.post("precession/shaft-deflection", json=body)
    assert response.status_code == 422, response.text
    assert [error["pointer"] for error in response.json()["errors"]] == [field]


@pytest.mark.parametrize(
    ("change", "place"),
    [
        ({"ratio_u12": math.cos(math.radians(6))}, "nutation_angle_deg"),
        ({"rollers": [{"position_angle_deg": 30, "z_min_mm": -5, "z_max_mm": 5}]}, "roller"),
    ],
)
async def test_a_gear_that_cannot_work_is_refused_with_its_place(api, change, place):
    response = await api.post("precession/meshing-load", json=MESH | change)
    assert response.status_code == 422
    assert place in response.json()["where"]


@pytest.mark.parametrize("path", ["contact-line", "meshing-load", "shaft-deflection"])
async def test_what_is_hardly_known_is_warned_of(api, path):
    """Limits in z that differ only in their last digits."""
    rollers = [{"position_angle_deg": 30, "z_min_mm": 15, "z_max_mm": 15.0000000000003}]
    body = {"contact-line": GEAR, "meshing-load": MESH, "shaft-deflection": SHAFT}[path]
    answer = (await api.post(f"precession/{path}", json=body | {"rollers": rollers})).json()
    assert answer["accuracy"]["relative_error"] > 1e-2
    assert [each["code"] for each in answer["warnings"]] == ["hardly_known"]
    known = (await api.post(f"precession/{path}", json=body)).json()
    assert "warnings" not in known


TIRED = {"tensile_strength_MPa": 900, "fatigue": {"surface": "machined"}}


async def test_fatigue_outside_a_formula_is_warned_of(api):
    strong = {"tensile_strength_MPa": 1750, "fatigue": {"surface": "machined"}}
    strong["fatigue"]["notch"] = {"theoretical_factor": 2, "radius_mm": 1}
    rollers = ROLLERS | {"stress_concentration": 1} | strong
    for path, body in (("roller-strength", rollers), ("precession/shaft-deflection", SHAFT)):
        answer = (await api.post(path, json=body | strong)).json()
        codes = [each["code"] for each in answer["warnings"]]
        assert codes.count("notch_beyond_strength") == 1, path


def said_by_checks(answer):
    """Why fatigue is not checked, which no warning repeats."""
    codes = [each["reason"]["code"] for each in answer["checks"] if "fatigue" in each["code"]]
    assert not {*codes} & {each["code"] for each in answer.get("warnings", ())}
    return codes


async def test_fatigue_of_rollers_where_asked(api):
    """The stress of 508.487 MPa comes and goes; the factor of the notch counts once."""
    plain = (await api.post("roller-strength", json=ROLLERS)).json()
    assert "fatigue" not in plain and "fatigue" in plain["not_considered"]
    own = (await api.post("roller-strength", json=ROLLERS | TIRED)).json()
    cycle = own["fatigue"]
    half = 0.0024213655 * 210e3 / 2
    assert [cycle["amplitude_MPa"], cycle["mean_MPa"]] == pytest.approx([half] * 2, rel=EXACT)
    assert cycle["factors"]["notch"] == 1
    endurance = 3.04 * 900**-0.217 * 1.24 * 10**-0.107 * 450
    safety = 1 / (half / endurance + half / 900)
    assert cycle["safety_factor"] == pytest.approx(safety, rel=EXACT)
    given = TIRED | {"fatigue": {"endurance_limit_MPa": endurance}}
    cycle = (await api.post("roller-strength", json=ROLLERS | given)).json()["fatigue"]
    assert cycle["amplitude_MPa"] == pytest.approx(half / 2, rel=EXACT)
    smooth = ROLLERS | TIRED | {"stress_concentration": 1, "include": ["checks"]}
    unknown = (await api.post("roller-strength", json=smooth)).json()
    assert said_by_checks(unknown) == ["notch_unknown"] and "fatigue" not in unknown
    unknown = (await api.post("roller-strength", json=smooth | {"include": []})).json()
    assert [each["code"] for each in unknown["warnings"]] == ["notch_unknown"]
    notched = smooth | {"fatigue": {"surface": "machined", "fatigue_notch_factor": 2}}
    cycle = (await api.post("roller-strength", json=notched)).json()["fatigue"]
    assert cycle["safety_factor"] == pytest.approx(1 / (half / endurance + half / 1800), rel=EXACT)
    notched["roller_rotates"] = True
    spun = (await api.post("roller-strength", json=notched)).json()["fatigue"]
    assert spun["mean_MPa"] == 0 and spun["safety_factor"] < cycle["safety_factor"]
    both = ROLLERS | TIRED | {"fatigue": {"surface": "machined", "fatigue_notch_factor": 2}}
    refused = await api.post("roller-strength", json=both)
    assert refused.status_code == 422
    assert [each["pointer"] for each in refused.json()["errors"]] == [
        "/fatigue/fatigue_notch_factor"
    ]


async def test_strength_of_the_shaft_where_asked(api):
    path = "precession/shaft-deflection"
    body = SHAFT | {"overhang_mm": 20}
    plain = (await api.post(path, json=body)).json()
    assert "strength" not in plain and "line_contact" not in plain
    found = (await api.post(path, json=body | {"yield_strength_MPa": 300})).json()["strength"]
    assert f"{found['bending_moment_clamp_Nm'] * 1e3:.2f}" == "18932.51"
    assert f"{found['peak_stress_MPa']:.4f}" == "24.1056"
    assert found["static_safety_factor"] == pytest.approx(300 / 24.1056, rel=JUDGED)
    assert "fatigue" not in found
    tired = body | TIRED | {"include": ["checks"]}
    unknown = (await api.post(path, json=tired)).json()
    assert said_by_checks(unknown) == ["notch_unknown"]
    unknown = (await api.post(path, json=tired | {"include": []})).json()
    assert unknown["warnings"][0]["code"] == "notch_unknown"
    tired["fatigue"] = TIRED["fatigue"] | {"fatigue_notch_factor": 1.5}
    answer = (await api.post(path, json=tired)).json()
    endurance = 3.04 * 900**-0.217 * 1.24 * 20**-0.107 * 300
    cycle = answer["strength"]["fatigue"]
    assert cycle["safety_factor"] == pytest.approx(endurance / 24.1056, rel=JUDGED)
    steady = (await api.post(path, json=tired | {"load_rotates_with_shaft": True})).json()
    assert "fatigue" not in steady["strength"]
    judged = {each["code"]: each["status"] for each in steady["checks"]}
    assert judged["shaft_fatigue"] == "not_applicable"


async def test_pressure_along_the_lines_where_the_teeth_are_given(api):
    path = "precession/shaft-deflection"
    steel = {"youngs_modulus_GPa": 207, "poissons_ratio": 0.292, "allowable_pressure_MPa": 1500}
    contact = {"mating_radius_mm": 20, "roller_material": steel, "mating_material": steel}
    body = SHAFT | {"line_contact": contact, "include": ["checks"]}
    answer = (await api.post(path, json=body)).json()
    q = (await api.post("precession/meshing-load", json=MESH)).json()["max_line_load_N_per_mm"]
    found = answer["line_contact"]
    width = math.sqrt(2 * q / math.pi * 2 * (1 - 0.292**2) / 207e3 / (1 / 8 + 1 / 40))
    assert found["half_width_mm"] == pytest.approx(width, rel=SAME)
    pressure = 2 * q / (math.pi * width)
    assert found["max_pressure_MPa"] == pytest.approx(pressure, rel=SAME)
    check = next(each for each in answer["checks"] if each["code"] == "line_pressure")
    assert check["torque_reserve"] == pytest.approx((1250 / pressure) ** 2, rel=SAME)
    hollow = body | {"line_contact": contact | {"mating_radius_mm": -3}}
    refused = (await api.post(path, json=hollow)).json()
    assert refused["errors"][0]["pointer"] == "/line_contact/mating_radius_mm"


async def test_more_rollers_cure_a_stress_unless_each_has_a_gap_of_its_own(api):
    drive = ROLLERS | {"output_torque_Nm": 4000, "yield_strength_MPa": 300}
    drive |= {"include": ["checks", "fixes"]}
    del drive["position_tolerance_mm"]
    cures = []
    for more in ({"position_tolerance_mm": 0.002}, {"gaps_mm": [0.0, 0.002, 0.0, 0.001]}):
        answer = (await api.post("roller-strength", json=drive | more)).json()
        cures.append({each["pointer"] for each in answer["fixes"]})
    both = {"/diameter_mm", "/hole_circle_radius_mm", "/output_torque_Nm"}
    assert cures == [both | {"/rollers", "/position_tolerance_mm"}, both]


async def test_a_stepped_shaft_is_mended_by_one_of_its_diameters(api):
    sections = [{"length_mm": 30.0, "diameter_mm": 20.0}, {"length_mm": 40.0, "diameter_mm": 25.0}]
    body = without(SHAFT, "shaft_diameter_mm") | {"shaft_sections": sections}
    bent = (await api.answer("precession/shaft-deflection", body))["deflection_C_mm"]["total"]
    body |= {"requirements": {"max_deflection_mm": 0.99 * bent}}
    answer = await api.answer("precession/shaft-deflection", body | {"include": ["fixes"]})
    found = {each["pointer"]: each for each in answer["fixes"]}
    assert {f"/shaft_sections/{index}/diameter_mm" for index in (0, 1)} <= {*found}
    for fix in found.values():
        assert fix["to"] > fix["from"]
        await api.reposted("precession/shaft-deflection", body, fix)
