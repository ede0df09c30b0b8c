"""Materials in requests and in the table: names, other names, values, and what is said of them."""

import pytest

HERTZ = {"force_N": 70, "contact_length_mm": 7, "pin_radius_mm": 3.5, "hole_radius_mm": 4.3}
PRINTED = {
    "mechanism": {"pins": 6, "satellites": 1, "ratio": 15},
    "load": {"output_torque_Nm": 0.2, "pin_circle_radius_mm": 17},
    "contact": {
        "contact_length_mm": 7,
        "pin_radius_mm": 3,
        "hole_clearance_mm": 0.1,
        "eccentricity_mm": 1,
        "hole_material": "PLA",
    },
}
"""A printed disc on pins of steel."""


async def refused(api, material):
    """What is wrong with a material of a hole."""
    answer = await api.post("hertz", json=HERTZ | {"hole_material": material})
    assert answer.status_code == 422
    (error,) = answer.json()["errors"]
    return error


async def hertz(api, material):
    answer = await api.post("hertz", json=HERTZ | {"hole_material": material})
    assert answer.status_code == 200, answer.text
    return answer.json()


@pytest.mark.anyio
@pytest.mark.parametrize(
    ("alias", "name"),
    [
        ("plastic_pla", "plastic_pla_printed"),
        ("4140", "steel_through_hardened"),
        ("SUJ2", "steel_bearing"),
        ("6061 t6", "aluminium_6061_t6"),
    ],
)
async def test_other_names_are_taken(api, alias, name):
    one, two = await hertz(api, alias), await hertz(api, name)
    assert one["max_pressure_MPa"] == two["max_pressure_MPa"]


@pytest.mark.anyio
async def test_a_name_that_says_too_little_is_asked_back(api):
    unknown = await refused(api, "unobtainium")
    assert (unknown["pointer"], unknown["code"]) == ("/hole_material", "unknown_material")
    for said in ("Aluminium: aluminium_6061_t6", "plastic_pla_printed", "4140", "poissons_ratio"):
        assert said in unknown["detail"]
    assert (await refused(api, "nylon"))["params"]["candidates"].startswith("plastic_pa12")
    assert (await refused(api, "PLA+"))["code"] == "several_materials"
    assert (await refused(api, "TPU"))["code"] == "elastomer"


@pytest.mark.anyio
@pytest.mark.parametrize("given", ["PETG", {"name": "PETG", "yield_strength_MPa": 44}])
async def test_what_no_source_has_is_asked_for_at_its_field(api, given):
    error = await refused(api, given)
    assert (error["pointer"], error["code"]) == ("/hole_material/poissons_ratio", "not_sourced")


@pytest.mark.anyio
async def test_values_beside_a_name_take_its_place(api):
    own = {"name": "PETG", "poissons_ratio": 0.38}
    assert (await hertz(api, own))["max_pressure_MPa"] == pytest.approx(
        (await hertz(api, {"youngs_modulus_GPa": 3.0, "poissons_ratio": 0.38}))["max_pressure_MPa"]
    )
    assert (await refused(api, {"poissons_ratio": 0.3}))["pointer"].endswith("youngs_modulus_GPa")
    assert (await refused(api, {}))["code"] == "needed"
    assert (await refused(api, {"name": "nylon"}))["pointer"] == "/hole_material/name"
    (said,) = (await hertz(api, "PC"))["warnings"]
    assert (said["code"], said["params"]) == ("one_source", {"material": "plastic_pc_printed"})


@pytest.mark.anyio
async def test_the_table_says_sources_and_spread(api):
    table = {each["name"]: each for each in (await api.get("materials")).json()["materials"]}
    pla, petg = table["plastic_pla_printed"], table["plastic_petg_printed"]
    assert (pla["strength_in_plane_MPa"], pla["softening_C"], pla["friction"]) == (23, 51, 0.76)
    assert (pla["youngs_modulus_low_GPa"], pla["youngs_modulus_high_GPa"]) == (1.6, 3.6)
    assert pla["wear_rate_mm3_per_Nm"] == 4.4e-4 and "PLA" in pla["aliases"]
    facts = {each["name"]: each for each in pla["facts"]}
    assert (facts["strength_in_plane_MPa"]["high"], facts["strength_across_MPa"]["seen"]) == (
        65,
        "one",
    )
    assert "poissons_ratio" not in petg and "yield_strength_MPa" not in pla
    assert all(each["seen"] in ("one", "two") and each["source"] for each in petg["facts"])
    assert table["bronze_c93200"]["yield_strength_MPa"] == 138


@pytest.mark.anyio
async def test_a_printed_drive_gets_one_torque_and_no_green_word(api):
    answer = (await api.post("crank-planetary", json=PRINTED | {"include": ["checks"]})).json()
    cold = answer["cold_yield"]
    assert cold["quarter_Nm"] == pytest.approx(cold["torque_Nm"] / 4)
    assert (cold["strength_MPa"], cold["friction"]) == (23, 0.76) and "PolyTerra" in cold["source"]
    assert "temperature" in cold["open"] and "largest_torque_Nm" not in answer
    assert {"pointer": "/friction/coefficient", "value": 0.76} in answer["assumed"]
    checks = {each["code"]: each for each in answer["checks"]}
    first = checks["contact_static_cold"]
    assert (first["status"], first["reason"]["code"]) == ("not_checked", "necessary_only")
    assert first["value"] < first["limit"] and first["utilisation"] < 1
    assert checks["temperature"]["missing"] == ["/temperatures/satellite_C"]
    assert answer["parts"][0]["status"] == "open" and answer["verdict"] == "incomplete"
    rings = {"rollers": {"name": "683"}, "contact": PRINTED["contact"] | {"pin_radius_mm": 3.5}}
    rolling = (await api.post("crank-planetary", json=PRINTED | rings)).json()
    assert rolling["cold_yield"]["friction"] == 0  # and none is assumed
    assert "/friction/coefficient" not in {each["pointer"] for each in rolling["assumed"]}


@pytest.mark.anyio
async def test_a_strength_of_ones_own_and_what_it_is_asked_with(api):
    own = {"name": "PLA", "yield_strength_MPa": 45, "layers": "flat", "long_term_factor": 0.5}
    given = {
        "contact": PRINTED["contact"] | {"hole_material": own},
        "friction": {"coefficient": 0.3},
        "temperatures": {"satellite_C": 55},
        "satellite_body": {"solid_wall_mm": 1.2},
    }
    answer = (
        await api.post("crank-planetary", json=PRINTED | given | {"include": ["checks"]})
    ).json()
    cold = answer["cold_yield"]
    assert cold["strength_MPa"] == 45 and "source" not in cold
    assert cold["open"] == ["fatigue_plastic", "wear"]
    checks = {each["code"]: each["status"] for each in answer["checks"]}
    assert checks["temperature"] == "fail" and answer["verdict"] == "fail"
    tested = own | {"allowable_pressure_MPa": 200}
    given["contact"] = given["contact"] | {"hole_material": tested}
    answer = (
        await api.post("crank-planetary", json=PRINTED | given | {"include": ["checks"]})
    ).json()
    checks = {each["code"]: each["status"] for each in answer["checks"]}
    assert checks["contact_pressure_hole"] == "pass"


@pytest.mark.anyio
async def test_first_yield_has_a_reserve_of_its_own(api):
    """A steel hole whose first yield is at 618 MPa: 0.446 of the torque, shakedown above it."""
    hole = {"youngs_modulus_GPa": 210, "poissons_ratio": 0.3, "yield_strength_MPa": 345}
    body = {
        "mechanism": {"pins": 6, "satellites": 2, "ratio": 20},
        "load": {"output_torque_Nm": 400, "pin_circle_radius_mm": 50},
        "contact": {
            "contact_length_mm": 20,
            "pin_radius_mm": 8,
            "hole_radius_mm": 10.03,
            "eccentricity_mm": 2.0,
            "pin_material": "steel_bearing",
            "hole_material": hole | {"allowable_pressure_MPa": 2000},
        },
        "pin": {
            "satellite_positions_mm": [15, 40],
            "support": "cantilever",
            "material": "steel_through_hardened",
        },
        "include": ["checks"],
    }
    answer = (await api.post("crank-planetary", json=body)).json()
    checks = {each["code"]: each for each in answer["checks"]}
    assert checks["contact_yield_hole"]["torque_reserve"] == pytest.approx(0.446, abs=0.005)
