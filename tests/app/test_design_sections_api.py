"""The design document's sections of strength and life over REST: the same as their own endpoints,
what each needs, what excludes what.
"""

from copy import deepcopy

import pytest

pytestmark = pytest.mark.anyio

PATH = "crank-planetary"
STEEL = {
    "youngs_modulus_GPa": 210.0,
    "poissons_ratio": 0.3,
    "yield_strength_MPa": 800.0,
    "tensile_strength_MPa": 1000.0,
}
DESIGN = {
    "mechanism": {"pins": 6, "satellites": 2, "ratio": 20.0},
    "load": {"output_torque_Nm": 500.0, "pin_circle_radius_mm": 50.0, "input_speed_rpm": 1500.0},
    "contact": {"contact_length_mm": 20.0, "pin_radius_mm": 8.0, "eccentricity_mm": 2.0},
    "pin": {"satellite_positions_mm": [15.0, 37.0], "material": STEEL},
    "fatigue": {"endurance_limit_MPa": 300.0},
    "friction": {"coefficient": 0.08, "wear_rate_mm3_per_Nm": 1e-8, "life_h": 3000.0},
    "gear": {"kind": "involute", "module_mm": 3.5, "teeth_difference": 1},
    "bearing": {"kind": "ball", "dynamic_rating_N": 60000.0, "static_rating_N": 40000.0},
    "crankshaft": {
        "satellite_positions_mm": [20.0, 42.0],
        "bearing_positions_mm": [0.0, 62.0],
        "satellite_mass_kg": 1.5,
    },
}
STRENGTH = ("pin_strength", "output_efficiency", "satellite_bearing", "crankshaft")


def changed(body=DESIGN, /, **changes):
    """A design with changed fields: `section__field=value`; None takes one away."""
    body = deepcopy(body)
    for place, value in changes.items():
        *path, last = place.split("__")
        inner = body
        for part in path:
            inner = inner.setdefault(part, {})
        if value is None:
            inner.pop(last, None)
        else:
            inner[last] = value
    return body


async def answered(api, body, path=PATH):
    response = await api.post(path, json=body)
    assert response.status_code == 200, response.text
    return response.json()


async def refused(api, body):
    response = await api.post(PATH, json=body)
    assert response.status_code == 422, response.text
    (error,) = response.json()["errors"]
    return error["pointer"], error["code"]


def own(body, section):
    """The body of a section's own endpoint."""
    load, contact = body["load"], body["contact"]
    turning = {"mechanism": body["mechanism"], "load": load}
    if section == "pin_strength":
        pin = {"diameter_mm": 2 * contact["pin_radius_mm"], "contact_length_mm": 20.0}
        more = {"pin": pin | body["pin"], "fatigue": body["fatigue"], "include": ["deflection"]}
        return turning | more
    if section == "output_efficiency":
        return turning | {"contact": contact, "friction": body["friction"]}
    cranked = turning | {
        "contact": {"eccentricity_mm": contact["eccentricity_mm"]},
        "gear": body["gear"],
    }
    last = {"satellite_bearing": "bearing"}.get(section, section)
    return cranked | {last: body[last]}


def without_time(section):
    return section | {"accuracy": section["accuracy"] | {"run_time_us": 0}}


ALONE = changed(
    mechanism__satellites=1,
    pin__satellite_positions_mm=[37.0],
    crankshaft__satellite_positions_mm=[20.0],
)
"""Of one satellite, which shares with none."""


@pytest.mark.parametrize("section", STRENGTH)
@pytest.mark.parametrize(
    "design",
    [
        ALONE,
        changed(pin=None, fatigue=None),
        changed(ALONE, load__application_factor=1.25, load__peak_torque_Nm=900.0),
        changed(ALONE, load__application_factor=1.25),
    ],
    ids=["one", "no pin", "peak", "factor"],
)
async def test_a_section_is_what_its_endpoint_answers(api, section, design):
    """Several satellites share by the stiffness of bending pins too."""
    if section == "pin_strength" and "pin" not in design:
        return
    expected = await answered(api, own(design, section), section.replace("_", "-"))
    for include in ([section], None):
        answer = await answered(api, changed(design, include=include))
        assert without_time(answer[section]) == without_time(expected)


STEEL = {"youngs_modulus_GPa": 206.0, "poissons_ratio": 0.3, "allowable_pressure_MPa": 700.0}


@pytest.mark.parametrize(
    ("material", "limit", "factor"),
    [
        ("steel_case_hardened", 1500.0, 0.93358053),  # (5e7/4.725e8)^0.0306
        (STEEL | {"life_curve": "hardened"}, 700.0, 0.93358053),
        (STEEL | {"life_curve": "nitrided"}, 700.0, (2e6 / 4.725e8) ** 0.0191),
        (STEEL, 700.0, None),
        ("steel_bearing", 1500.0, None),
    ],
)
@pytest.mark.parametrize("rpm", [1500.0, None])
async def test_the_life_of_the_contact(api, material, limit, factor, rpm):
    """5000 h of 1500 turns a minute, ratio 20: in the limit, the reserve and the safety."""
    body = changed(
        contact__hole_material=material,
        load__input_speed_rpm=rpm,
        requirements__life_h=5000.0,
        include=["hertz", "checks"],
    )
    if rpm is None:
        factor = None
    for section in ("pin", "fatigue", "friction", "bearing", "crankshaft", "gear"):
        body.pop(section, None)
    answer = await answered(api, body)
    (check,) = (each for each in answer["checks"] if each["code"] == "contact_pressure_hole")
    assert check.get("life_factor") == (factor and pytest.approx(factor, rel=1e-5))
    assert check["limit"] == pytest.approx(limit * (factor or 1) / 1.2, rel=1e-5)
    assert check["torque_reserve"] == pytest.approx((check["limit"] / check["value"]) ** 2)
    assert "/requirements/life_h" in check["inputs"] and "/mechanism/ratio" in check["inputs"]
    assert ("/load/input_speed_rpm" in check["inputs"]) == (rpm is not None)
    safety = answer["hertz"]["safety"][1]
    assert safety["safety_factor"] == pytest.approx(1.2 * check["limit"] / check["value"])
    assert safety["limit_MPa"] == pytest.approx(limit)
    assert ("life" in safety) == (factor is not None)
    if factor is not None:
        assert check["reason"]["code"] == "life_of_teeth"
        life = safety["life"]
        assert life["loads"] == pytest.approx(4.725e8) and life["factor"] == check["life_factor"]
        by_hand = (life["knee_loads"] / life["loads"]) ** life["exponent"]
        assert by_hand == pytest.approx(factor, rel=1e-5) and life["largest_factor"] > 1
    known = (isinstance(material, str) and material != "steel_bearing") or "life_curve" in material
    if rpm is None and known:
        assert check["reason"]["code"] == "life_without_speed"
        assert check["missing"] == ["/load/input_speed_rpm"]
    elif factor is None:
        assert check["reason"]["code"] == "no_life_curve"
    assert ("contact_life_hole" in answer["not_considered"]) == (factor is None)


async def test_bending_pins_share_by_stiffness(api):
    """The near satellite carries most: by its pins, its bearing, its contact."""
    bent, even = await answered(api, DESIGN), await answered(api, changed(pin=None, fatigue=None))
    near, far = bent["satellite_bearing"]["satellites"]
    assert near["basic_life_h"] < even["satellite_bearing"]["satellites"][0]["basic_life_h"] / 4
    assert far["basic_life_h"] == even["satellite_bearing"]["satellites"][1]["basic_life_h"]
    assert bent["pin_strength"]["peak_force_N"] > 1.4 * bent["contact_force"]["peak_force_N"]
    factor = bent["hertz"]["line_load_factor"]
    assert "line_load_factor" not in even["hertz"]
    ratio = bent["hertz"]["max_pressure_MPa"] / even["hertz"]["max_pressure_MPa"]
    assert ratio == pytest.approx(factor**0.5)


async def test_by_default_what_is_given_is_answered(api):
    whole = {"cyclogram", "contact_force", "hertz", *STRENGTH}
    sections = whole | {"load_sharing", "geometry", "checks", "fixes"}
    for changes, expected in (
        ({}, whole),
        ({"pin": None}, whole - {"pin_strength"}),
        ({"contact__hole_clearance_mm": 0.02}, whole | {"load_sharing"}),
        ({"friction": None}, whole - {"output_efficiency"}),
        ({"gear": None}, whole - {"satellite_bearing", "crankshaft"}),
        ({"bearing": None}, whole - {"satellite_bearing"}),
        ({"load__input_speed_rpm": None}, whole - {*STRENGTH} | {"pin_strength"}),
        (
            {"contact__eccentricity_mm": None, "contact__hole_radius_mm": 10.0},
            whole - {*STRENGTH} | {"pin_strength"},
        ),
        ({"contact": None}, {"cyclogram", "contact_force"}),
        ({"load": None}, {"cyclogram"}),
    ):
        assert {*await answered(api, changed(**changes))} & sections == expected, changes


@pytest.mark.parametrize(
    ("changes", "pointer", "code"),
    [
        ({"pin": None, "include": ["pin_strength"]}, "/pin", "needed_for"),
        ({"friction": None, "include": ["output_efficiency"]}, "/friction", "needed_for"),
        ({"gear": None, "include": ["satellite_bearing"]}, "/gear", "needed_for"),
        ({"bearing": None, "include": ["satellite_bearing"]}, "/bearing", "needed_for"),
        ({"crankshaft": None, "include": ["crankshaft"]}, "/crankshaft", "needed_for"),
        (
            {"load__input_speed_rpm": None, "include": ["crankshaft"]},
            "/load/input_speed_rpm",
            "needed_for",
        ),
        (
            {
                "contact__eccentricity_mm": None,
                "contact__hole_radius_mm": 10.0,
                "include": ["output_efficiency"],
            },
            "/contact/eccentricity_mm",
            "needed_for",
        ),
        (
            {"load__application_factor": 1.2, "contact__dynamic_factor": 1.0},
            "/load/application_factor",
            "only_one",
        ),
        ({"pin": None, "friction__sleeve": True}, "/pin", "needed_beside"),
        ({"friction__sleeve": True}, "/pin/diameter_mm", "no_sleeve"),
        (
            {"pin__satellite_positions_mm": [15.0]},
            "/pin/satellite_positions_mm",
            "different_length",
        ),
        (
            {"pin__satellite_positions_mm": [15.0, 9.0]},
            "/pin/satellite_positions_mm/1",
            "in_carrier",
        ),
        (
            {"crankshaft__satellite_positions_mm": [20.0]},
            "/crankshaft/satellite_positions_mm",
            "different_length",
        ),
        ({"bearing__reliability_percent": 92}, "/bearing/reliability_percent", "not_in_table"),
        (
            {
                "fatigue": {
                    "surface": "ground",
                    "fatigue_notch_factor": 1.0,
                    "reliability_percent": 93,
                }
            },
            "/fatigue/reliability_percent",
            "not_in_table",
        ),
        ({"gear__module_mm": 5.0}, "/contact/eccentricity_mm", "no_mesh"),
        (
            {"mechanism__pins": 251, "include": ["pin_strength"]},
            "/mechanism/pins",
            "too_many_pairs",
        ),
    ],
)
async def test_what_does_not_fit_together_is_refused(api, changes, pointer, code):
    assert await refused(api, changed(**changes)) == (pointer, code)


async def test_the_pin_is_that_of_the_contact_where_it_says_nothing_else(api):
    body = changed(pin__material=None, contact__pin_material="steel_through_hardened")
    one = (await answered(api, body))["pin_strength"]
    other = await answered(
        api, changed(body, pin__material="steel_through_hardened", pin__diameter_mm=16.0)
    )
    assert without_time(one) == without_time(other["pin_strength"])
    slim = (await answered(api, changed(pin__diameter_mm=12.0)))["pin_strength"]
    base = (await answered(api, DESIGN))["pin_strength"]
    ratio = slim["peak_bending_stress_MPa"] / base["peak_bending_stress_MPa"]
    assert ratio == pytest.approx((16 / 12) ** 3)
    short = (await answered(api, changed(pin__contact_length_mm=10.0)))["pin_strength"]
    assert short["deflection"] != base["deflection"]


async def test_factor_and_peak_torque(api):
    """The factor counts for stresses, the peak torque for static safety, neither for life."""
    base = await answered(api, ALONE)
    for changes in ({"load__application_factor": 1.25}, {"contact__dynamic_factor": 1.25}):
        more = await answered(api, changed(ALONE, **changes))
        pins = more["pin_strength"]
        assert pins["peak_force_N"] == pytest.approx(1.25 * base["pin_strength"]["peak_force_N"])
        for name in ("static_safety_factor",):
            assert pins[name] == pytest.approx(base["pin_strength"][name] / 1.25)
        assert pins["fatigue"]["safety_factor"] == pytest.approx(
            base["pin_strength"]["fatigue"]["safety_factor"] / 1.25
        )
        ratio = more["hertz"]["max_pressure_MPa"] / base["hertz"]["max_pressure_MPa"]
        assert ratio == pytest.approx(1.25**0.5, rel=1e-2)  # the slope counts a little less
        for name in ("output_efficiency", "crankshaft"):
            assert without_time(more[name]) == without_time(base[name])
        for one, other in zip(
            more["satellite_bearing"]["satellites"],
            base["satellite_bearing"]["satellites"],
            strict=True,
        ):
            assert one["basic_life_h"] == other["basic_life_h"]
            assert one["static_safety_factor"] == pytest.approx(
                other["static_safety_factor"] / 1.25
            )
    peak = await answered(api, changed(ALONE, load__peak_torque_Nm=1000.0))
    for name in ("peak_force_N", "fatigue"):
        assert peak["pin_strength"][name] == base["pin_strength"][name]
    assert peak["pin_strength"]["static_safety_factor"] == pytest.approx(
        base["pin_strength"]["static_safety_factor"] / 2
    )


async def test_wear_over_the_required_life(api):
    body = changed(friction__life_h=None, requirements={"life_h": 3000.0})
    one, other = await answered(api, body), await answered(api, DESIGN)
    assert one["output_efficiency"]["pin_wear_mm"] == other["output_efficiency"]["pin_wear_mm"]
    assert (
        "pin_wear_mm"
        not in (await answered(api, changed(friction={"coefficient": 0.1})))["output_efficiency"]
    )


FAILING = {
    "pins": changed(pin=DESIGN["pin"] | {"diameter_mm": 16.0}, load__output_torque_Nm=800.0),
    "sleeved pins": changed(
        pin=DESIGN["pin"] | {"diameter_mm": 11.0}, friction__sleeve=True, bearing=None
    ),
    "asked": changed(
        pin=None,
        fatigue=None,
        requirements={
            "min_efficiency": 0.95,
            "max_wear_mm": 0.05,
            "max_sliding_speed_m_per_s": 0.2,
            "max_unbalance_couple_Nm": 1.0,
            "max_outer_diameter_mm": 130.0,
        },
        satellite_body={"outer_radius_mm": 66.5},
        crankshaft__bearings=[{"kind": "ball", "dynamic_rating_N": 6000.0}] * 2,
        bearing__weibull_slope=1.1,
    ),
}


@pytest.mark.parametrize("name", FAILING)
async def test_every_fix_makes_its_check_pass(api, name):
    body = FAILING[name] | {"include": ["checks", "fixes"], "fixes_for": "failed"}
    answer = await answered(api, body)
    failed = {each["code"] for each in answer["checks"] if each["status"] == "fail"}
    assert {each["code"] for each in answer["fixes"]} == failed
    for fix in answer["fixes"]:
        fixed = deepcopy(body) | {"include": ["checks"]}
        for pointer, value in fix["sets"].items():
            *parts, last = pointer.split("/")[1:]
            inner = fixed
            for part in parts:
                inner = inner[int(part)] if isinstance(inner, list) else inner[part]
            inner[last] = value
        after = await answered(api, fixed)
        assert after["verdict"] == fix["verdict"], fix
        checks = {each["code"]: each for each in after["checks"]}
        if fix["status"] == "solved":
            assert checks[fix["code"]]["status"] == "pass", fix


async def test_what_is_missing_is_pointed_to(api):
    body = changed(
        load__input_speed_rpm=None,
        bearing__static_rating_N=None,
        gear=None,
        fatigue={"surface": "ground"},
        pin__material={"youngs_modulus_GPa": 210.0, "poissons_ratio": 0.3},
        requirements={"max_outer_diameter_mm": 100.0, "min_efficiency": 0.5},
        include=["checks"],
    )
    answer = await answered(api, body)
    missing = {each["code"]: each.get("missing") for each in answer["checks"]}
    for code, pointers in {
        "pin_static": ["/pin/material/yield_strength_MPa"],
        "pin_fatigue": ["/pin/material/tensile_strength_MPa"],
        "bearing_life": ["/gear"],
        "efficiency": ["/load/input_speed_rpm"],
        "outer_diameter": ["/satellite_body/outer_radius_mm"],
        "wear": ["/requirements/max_wear_mm"],
        "crank_bearing_life": ["/crankshaft/bearings"],
    }.items():
        assert missing[code] == pointers, code
    lives = ["contact_life_pin", "contact_life_hole"]
    assert answer["not_considered"] == ["satellite_body", "clearance", *lives, "gear"]
    pin = next(each for each in answer["checks"] if each["code"] == "pin_fatigue")
    assert "/pin/satellite_positions_mm" in pin["inputs"]
    assert "/fatigue/surface" in pin["inputs"] and "/fatigue/notch" not in pin["inputs"]
