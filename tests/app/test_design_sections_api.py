"""The design document's sections of strength and life over REST: the same as their own endpoints,
what each needs, what excludes what.
"""

import pytest

from app.endpoint import LIGHT_COST
from app.registry import CALCULATIONS
from core.precision import EXACT, JUDGED
from tests.inputs.bodies import changed

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
    "contact": {
        "contact_length_mm": 20.0,
        "pin_radius_mm": 8.0,
        "eccentricity_mm": 2.0,
        "hole_clearance_mm": 0.0,
    },
    "pin": {"satellite_positions_mm": [15.0, 37.0], "material": STEEL},
    "fatigue": {"endurance_limit_MPa": 300.0},
    "friction": {"coefficient": 0.08, "wear_rate_mm3_per_Nm": 1e-8, "life_h": 3000.0},
    "gear": {"kind": "involute", "module_mm": 1.75, "teeth_difference": 2},
    "bearing": {"kind": "ball", "dynamic_rating_N": 60000.0, "static_rating_N": 40000.0},
    "crankshaft": {
        "satellite_positions_mm": [20.0, 42.0],
        "bearing_positions_mm": [0.0, 62.0],
        "satellite_mass_kg": 1.5,
    },
    "build": {"gap_mm": 2.0},
}
STRENGTH = ("pin_strength", "output_efficiency", "satellite_bearing", "crankshaft")


FORCES = (
    "mechanism",
    "load",
    "contact",
    "contact_law",
    "deviations",
    "crank_support",
    "satellite_coupling",
    "pin",
    "build",
)
OWN = {
    "pin_strength": (*FORCES, "fatigue"),
    "output_efficiency": (*FORCES, "friction"),
    "satellite_bearing": (*FORCES, "gear", "bearing", "crankshaft"),
    "crankshaft": (*FORCES, "gear", "crankshaft"),
}


def own(body, section):
    """The sections of a document that a section's own endpoint takes."""
    parts = {name: body[name] for name in OWN[section] if name in body}
    return parts | ({"include": ["deflection"]} if section == "pin_strength" else {})


def without_time(section):
    return section | {"accuracy": section["accuracy"] | {"run_time_us": 0}}


ALONE = changed(
    DESIGN,
    mechanism__satellites=1,
    pin__satellite_positions_mm=[37.0],
    crankshaft__satellite_positions_mm=[20.0],
)
"""Of one satellite, which shares with none."""

FEW = changed(ALONE, mechanism__pins=3, contact__hole_clearance_mm=0.02)
BOTH = changed(DESIGN, mechanism__pins=3, contact__hole_clearance_mm=0.02)
DEVIATIONS = {"deviations": {"pin_tangential_mm": [-0.02, 0.0, 0.01]}}
PEAK = {"load__application_factor": 1.25, "load__peak_torque_Nm": 900.0}
STATED = changed(DESIGN, contact__distribution_factor=1.2)
"""How unevenly perfect parts share is stated: nothing is solved."""

IDEAL = {
    "plain": STATED,
    "one satellite": changed(ALONE, contact__distribution_factor=1.2),
    "no pin": changed(DESIGN, pin=None, fatigue=None),
    "factor": changed(STATED, load__application_factor=1.25),
    "dynamic factor": changed(STATED, contact__dynamic_factor=1.25),
    "peak": changed(STATED, **PEAK),
    "reverse": changed(
        ALONE,
        mechanism__pins=5,
        load__torque_direction="reverse",
        contact__distribution_factor=1.2,
    ),
    "alternating": changed(STATED, load__torque_direction="alternating"),
    "other pins": changed(STATED, pin__rotates=True, pin__material=None, pin__diameter_mm=14.0),
}
REAL = {
    "clearance": changed(BOTH, pin=None, fatigue=None),
    "materials": changed(FEW, contact__pin_material="brass", contact__hole_material="steel_s355"),
    "deviations": changed(FEW, contact__hole_clearance_mm=0.03, **DEVIATIONS, **PEAK),
    "law": changed(FEW, contact_law={"kind": "linear", "stiffness_N_per_mm": 1e5}),
    "reverse": changed(FEW, **DEVIATIONS, load__torque_direction="reverse"),
    "alternating": changed(FEW, **DEVIATIONS, **PEAK, load__torque_direction="alternating"),
    "bearings give": changed(FEW, crank_support={"stiffness_N_per_mm": 1e5}),
    "shares": changed(BOTH, satellite_coupling={"kind": "shares", "shares": [0.4, 0.6]}),
    "sleeves": changed(FEW, friction__sleeve=True, pin__diameter_mm=11.0),
}


@pytest.mark.parametrize(
    ("design", "forces"),
    [(each, "ideal") for each in IDEAL.values()] + [(each, "real") for each in REAL.values()],
    ids=[*(f"ideal, {name}" for name in IDEAL), *(f"real, {name}" for name in REAL)],
)
async def test_a_section_is_what_its_endpoint_answers(api, design, forces):
    """Value by value, whichever forces it follows from; how pins fit is said once in a design."""
    whole = await api.answer(PATH, design)
    sections = [each for each in STRENGTH if each != "pin_strength" or "pin" in design]
    for section in sections:
        answer = await api.answer(section.replace("_", "-"), own(design, section))
        expected = whole[section]
        assert answer["forces"] == expected["forces"] == forces
        apart = ("uneven_sharing", "hole_outside_disc")  # of all satellites, and of the pressure
        of_whole = [each for each in whole.get("warnings", []) if each["code"] not in apart]
        assert answer.get("warnings", []) == of_whole + expected.get("warnings", [])
        of_design = dict.fromkeys(("total_efficiency", "input_torque_Nm"))  # with its teeth
        said_once = {"warnings": None, "assumed": None} | of_design
        one, other = (without_time(each) | said_once for each in (answer, expected))
        assert one == other


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
        DESIGN,
        contact__hole_material=material,
        load__input_speed_rpm=rpm,
        requirements__life_h=5000.0,
        include=["hertz", "checks"],
    )
    if rpm is None and factor:
        factor = (2e6 / 1e10) ** 0.0191 if "nitrided" in str(material) else (5e7 / 1e10) ** 0.0306
    for section in ("pin", "fatigue", "friction", "bearing", "crankshaft", "gear"):
        body.pop(section, None)
    answer = await api.answer(PATH, body)
    (check,) = (each for each in answer["checks"] if each["code"] == "contact_pressure_hole")
    assert check.get("life_factor") == (factor and pytest.approx(factor, rel=JUDGED))
    assert check["limit"] == pytest.approx(limit * (factor or 1) / 1.2, rel=JUDGED)
    assert check["torque_reserve"] == pytest.approx((check["limit"] / check["value"]) ** 2)
    assert "/requirements/life_h" in check["inputs"] and "/mechanism/ratio" in check["inputs"]
    assert ("/load/input_speed_rpm" in check["inputs"]) == (rpm is not None)
    safety = answer["hertz"]["safety"][1]
    assert safety["safety_factor"] == pytest.approx(1.2 * check["limit"] / check["value"])
    assert safety["limit_MPa"] == pytest.approx(limit)
    assert ("life" in safety) == (factor is not None)
    if rpm is None and factor:
        assert safety["life"]["loads"] == 1e10
    elif factor is not None:
        assert check["reason"]["code"] == "life_of_teeth"
        life = safety["life"]
        assert life["loads"] == pytest.approx(4.725e8) and life["factor"] == check["life_factor"]
        by_hand = (life["knee_loads"] / life["loads"]) ** life["exponent"]
        assert by_hand == pytest.approx(factor, rel=JUDGED) and life["largest_factor"] > 1
    if rpm is None and factor:
        assert check["reason"]["code"] == "life_without_speed"
        assert check["missing"] == ["/load/input_speed_rpm"]
    elif factor is None:
        assert check["reason"]["code"] == "no_life_curve"
    assert ("contact_life_hole" in answer["not_considered"]) == (factor is None)


async def test_perfect_parts_whose_pins_bend_are_solved(api):
    """The near satellite carries most: by its pins, its bearing, its contact; a section alone has
    the numbers that it has in the whole.
    """
    bent, even = (
        await api.answer(PATH, DESIGN),
        await api.answer(PATH, changed(DESIGN, pin=None, fatigue=None)),
    )
    near, far = bent["satellite_bearing"]["satellites"]
    one, other = (each["basic_life_h"] for each in even["satellite_bearing"]["satellites"])
    assert near["basic_life_h"] < one / 2 < 2 * other < far["basic_life_h"]
    assert bent["pin_strength"]["peak_force_N"] > 1.2 * bent["contact_force"]["peak_force_N"]
    assert bent["model"] == "real" and even["model"] == "ideal"
    for section in STRENGTH:
        alone = await api.answer(section.replace("_", "-"), own(DESIGN, section))
        assert (bent[section]["forces"], alone["forces"]) == ("real", "real")
        assert alone["accuracy"]["evaluations"] == bent[section]["accuracy"]["evaluations"]
    factor = bent["hertz"]["line_load_factor"]
    assert "line_load_factor" not in even["hertz"]
    ratio = bent["hertz"]["max_pressure_MPa"] / even["hertz"]["max_pressure_MPa"]
    peak = bent["load_sharing"]["peak_force_N"] / even["contact_force"]["peak_force_N"]
    assert ratio == pytest.approx((factor * peak) ** 0.5)


async def test_by_default_what_is_given_is_answered(api):
    whole = {"cyclogram", "contact_force", "hertz", *STRENGTH}
    solved = whole | {"load_sharing"}
    sections = solved | {"geometry", "checks", "fixes"}
    for changes, expected in (
        ({"pin": None}, whole - {"pin_strength"}),
        ({"contact__distribution_factor": 1.2}, whole),
        ({}, solved),
        ({"contact__hole_clearance_mm": 0.02}, solved),
        ({"friction": None}, solved - {"output_efficiency"}),
        ({"gear": None}, solved - {"satellite_bearing", "crankshaft"}),
        ({"bearing": None}, solved - {"satellite_bearing"}),
        ({"load__input_speed_rpm": None}, solved - {*STRENGTH} | {"pin_strength"}),
        (
            {
                "contact__eccentricity_mm": None,
                "contact__hole_clearance_mm": None,
                "contact__hole_radius_mm": 10.0,
            },
            solved - {*STRENGTH} | {"pin_strength"},
        ),
        ({"contact": None}, {"cyclogram", "contact_force"}),
        ({"load": None}, {"cyclogram"}),
    ):
        assert {*await api.answer(PATH, changed(DESIGN, **changes))} & sections == expected, changes


async def test_the_pin_is_that_of_the_contact_where_it_says_nothing_else(api):
    body = changed(DESIGN, pin__material=None, contact__pin_material="steel_through_hardened")
    one = (await api.answer(PATH, body))["pin_strength"]
    other = await api.answer(
        PATH, changed(body, pin__material="steel_through_hardened", pin__diameter_mm=16.0)
    )
    assert without_time(one) == without_time(other["pin_strength"])
    slim = (await api.answer(PATH, changed(STATED, pin__diameter_mm=12.0)))["pin_strength"]
    base = (await api.answer(PATH, STATED))["pin_strength"]
    ratio = slim["peak_bending_stress_MPa"] / base["peak_bending_stress_MPa"]
    assert ratio == pytest.approx((16 / 12) ** 3)
    short = (await api.answer(PATH, changed(STATED, pin__contact_length_mm=10.0)))["pin_strength"]
    assert short["deflection"] != base["deflection"]


async def test_factor_and_peak_torque(api):
    """The factor counts for stresses, the peak torque for static safety, neither for life."""
    alone = changed(ALONE, contact__distribution_factor=1.2)
    base = await api.answer(PATH, alone)
    older = {"contact__dynamic_factor": 1.25}  # its place in requests of before
    for changes in (
        {"load__application_factor": 1.25},
        older,
        older | {"load__application_factor": 1.25},
    ):
        more = await api.answer(PATH, changed(alone, **changes))
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
    peak = await api.answer(PATH, changed(alone, load__peak_torque_Nm=1000.0))
    for name in ("peak_force_N", "fatigue"):
        assert peak["pin_strength"][name] == base["pin_strength"][name]
    assert peak["pin_strength"]["static_safety_factor"] == pytest.approx(
        base["pin_strength"]["static_safety_factor"] / 2
    )


async def test_a_thin_pin_without_a_sleeve_is_warned_of(api):
    """11 mm in a contact of 16 mm; without friction nothing says whether there is a sleeve."""
    thin = changed(DESIGN, pin__diameter_mm=11.0)
    for body in (thin, own(thin, "output_efficiency")):
        path = PATH if body is thin else "output-efficiency"
        for diameter, sleeve, warned in (
            (11.0, False, True),
            (11.0, True, False),
            (16.0, False, False),
        ):
            given = changed(body, pin__diameter_mm=diameter, friction__sleeve=sleeve)
            found = await api.answer(path, given)
            codes = [
                each["code"] for each in found.get("output_efficiency", found).get("warnings", ())
            ]
            assert ("thin_without_sleeve" in codes) == warned, (path, diameter, sleeve)


async def test_places_on_pins_and_crankshaft_agree(api):
    """Counted from either end, to a thousandth."""
    for places in ([42.0, 20.0], [-5.0, 17.0], [20.0, 42.02]):
        await api.answer(PATH, changed(DESIGN, crankshaft__satellite_positions_mm=places))
    body = changed(DESIGN, crankshaft__satellite_positions_mm=[20.0, 42.03])
    (error,) = (await api.post(PATH, json=body)).json()["errors"]
    assert error["params"] == {"limit": 22}


@pytest.mark.parametrize("path", [PATH, *(each.replace("_", "-") for each in STRENGTH)])
@pytest.mark.parametrize(
    ("torque", "limit"),
    [
        ({"output_torque_Nm": 500.0}, 500.0),
        ({"output_torque_Nm": 500.0, "application_factor": 1.25}, 625.0),
        ({"input_torque_Nm": 30.0, "efficiency": 0.9, "application_factor": 1.25}, 675.0),
    ],
)
async def test_a_peak_below_the_working_torque_is_refused(api, path, torque, limit):
    body = DESIGN if path == PATH else own(DESIGN, path.replace("-", "_"))
    load = {"pin_circle_radius_mm": 50.0, "input_speed_rpm": 1500.0, **torque}
    low = await api.post(path, json=body | {"load": load | {"peak_torque_Nm": 0.999 * limit}})
    (error,) = low.json()["errors"]
    assert (low.status_code, error["pointer"]) == (422, "/load/peak_torque_Nm")
    assert (error["code"], error["params"]) == ("below_working", {"limit": pytest.approx(limit)})
    await api.answer(path, body | {"load": load | {"peak_torque_Nm": limit}})


async def test_no_fix_sets_a_peak_below_the_working_torque(api):
    """The pins fail under the working torque too: less of a peak cures nothing."""
    body = changed(ALONE, pin__diameter_mm=8.0, load__peak_torque_Nm=900.0)
    body |= {"include": ["fixes"], "fixes_for": "failed", "requirements": {"scope": ["pins"]}}

    async def cures(**changes):
        fixes = (await api.answer(PATH, changed(body, **changes)))["fixes"]
        return {each["pointer"]: each["to"] for each in fixes if each["code"] == "pin_static"}

    none = await cures()
    assert none and "/load/peak_torque_Nm" not in none
    thick = {
        "pin__diameter_mm": 18.0,
        "contact__pin_radius_mm": 9.0,
        "contact__hole_radius_mm": 11.0,
    }
    some = await cures(**thick, load__peak_torque_Nm=1500.0)
    assert 500 <= some["/load/peak_torque_Nm"] < 1500


async def test_fatigue_over_the_required_life_or_its_own(api):
    slow = {"load__input_speed_rpm": 10.0, "pin__diameter_mm": 12.0}
    pins = [
        (await api.answer(PATH, changed(ALONE, **slow, **life)))["pin_strength"]["fatigue"]
        for life in (
            {"requirements": {"life_h": 50.0}},
            {"fatigue__life_h": 50.0},
            {"fatigue__life_h": 50.0, "requirements": {"life_h": 500.0}},
            {"requirements": {"life_h": 500.0}},
        )
    ]
    assert pins[0] == pins[1] == pins[2]
    assert pins[2]["finite_strength_MPa"] > pins[3]["finite_strength_MPa"]


ASKED = changed(
    DESIGN,
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
    gear__friction_coefficient=0.05,
    crankshaft__bearings=[{"kind": "ball", "dynamic_rating_N": 6000.0}] * 2,
    bearing__weibull_slope=1.1,
)
"""A design that fails what is asked; of pins and contacts test_fixes_reposted.py has one."""


async def test_every_fix_makes_its_check_pass(api):
    body = ASKED | {"include": ["checks", "fixes"], "fixes_for": "failed"}
    answer = await api.answer(PATH, body)
    failed = {each["code"] for each in answer["checks"] if each["status"] == "fail"}
    assert {each["code"] for each in answer["fixes"]} == failed
    for fix in answer["fixes"]:
        await api.reposted(PATH, body, fix)


async def test_what_is_missing_is_pointed_to(api):
    body = changed(
        DESIGN,
        load__input_speed_rpm=None,
        bearing__static_rating_N=None,
        gear=None,
        fatigue={"surface": "ground", "endurance_limit_MPa": None},
        pin__material={"youngs_modulus_GPa": 210.0, "poissons_ratio": 0.3},
        requirements={"max_outer_diameter_mm": 100.0, "min_efficiency": 0.5},
        include=["checks"],
    )
    answer = await api.answer(PATH, body)
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
    opened = {each["code"]: each.get("missing") for each in answer["parts"]}
    for part, pointer in {
        "pins": "/pin/material/yield_strength_MPa",
        "satellite_bearing": "/gear",
        "crank_bearings": "/crankshaft/bearings",
        "teeth": "/gear",
        "body": "/satellite_body/outer_radius_mm",
        "losses": "/load/input_speed_rpm",
    }.items():
        assert pointer in opened[part], part
    assert {"contact_life_pin", *opened} - {"contact"} <= {*answer["not_considered"]}
    pin = next(each for each in answer["checks"] if each["code"] == "pin_fatigue")
    assert "/pin/satellite_positions_mm" in pin["inputs"]
    assert "/fatigue/surface" in pin["inputs"] and "/fatigue/notch" not in pin["inputs"]


@pytest.mark.parametrize(
    ("gear", "name"),
    [
        (
            {"kind": "involute", "module_mm": 1.75, "teeth_difference": 2},
            "satellite_body/root_radius_mm",
        ),
        ({"kind": "cycloid", "ring_pin_circle_radius_mm": 84.0}, "gear/ring_pin_radius_mm"),
    ],
)
async def test_roots_that_are_missing_are_pointed_to(api, gear, name):
    """Holes that reach 28 + 5 mm: within the reference circle of 35 mm, and not its roots."""
    contact = {"pin_radius_mm": 3.0, "hole_radius_mm": 5.0, "contact_length_mm": 20.0}
    body = changed(DESIGN | {"gear": gear}, include=["checks"])
    body["load"]["pin_circle_radius_mm"] = 28.0
    body["contact"] |= contact
    body.pop("pin", None), body.pop("fatigue", None), body.pop("friction", None)
    answer = await api.answer(PATH, body)
    check = next(each for each in answer["checks"] if each["code"] == "gear_room")
    assert (check["status"], check["missing"]) == ("not_checked", [f"/{name}"])
    section, field = name.split("/")
    known = {"root_radius_mm": 34.0, "ring_pin_radius_mm": 4.0}[field]
    answer = await api.answer(PATH, body | {section: body.get(section, {}) | {field: known}})
    check = next(each for each in answer["checks"] if each["code"] == "gear_room")
    assert check["status"] == "pass"
    assert check["value"] == pytest.approx({34.0: 1.0, 4.0: 45.0}[known], rel=EXACT)
    assert f"/{name}" in check["inputs"]


def single(section, body=DESIGN, /, **changes):
    """The path and the body of a section's own endpoint."""
    return section.replace("_", "-"), own(changed(body, **changes), section)


@pytest.mark.parametrize("section", STRENGTH)
async def test_what_the_forces_do_not_need_is_taken_and_not_used(api, section):
    path, body = single(section, pin__rotates=False)
    more = changed(
        body,
        load__include=["curves"],
        load__samples=11,
        contact__hole_radius_mm=10.0,
    )
    one, other = [await api.answer(path, each) for each in (body, more)]
    assert without_time(one) == without_time(other)


async def test_fatigue_alone_is_for_the_required_life(api):
    """A design that turns 1000 times has strength for that, and so have its pins alone."""
    slow = changed(
        DESIGN, load__input_speed_rpm=1.0, requirements={"life_h": 20.0}, include=["pin_strength"]
    )
    whole = (await api.answer(PATH, slow))["pin_strength"]["fatigue"]
    path, body = single("pin_strength", slow)
    body |= {"requirements": {"life_h": 20.0}}
    assert "finite_strength_MPa" in whole
    assert (await api.answer(path, body))["fatigue"] == whole


async def test_curves_and_figures_are_of_the_forces_that_are_answered(api):
    """Their extremes are those of the answer, which takes them from its own samples."""
    few = FEW | DEVIATIONS
    path, body = single("output_efficiency", few)
    answer = await api.answer(path, body | {"include": ["curves"], "samples": 2001})
    efficiency = answer["curves"]["efficiency"]
    assert min(efficiency) == pytest.approx(answer["min_efficiency"], rel=JUDGED)
    assert max(efficiency) == pytest.approx(answer["max_efficiency"], rel=JUDGED)
    path, body = single("satellite_bearing", few)
    answer = await api.answer(path, body)
    figure = await api.answer(f"{path}/chart", body)
    (satellite,), load = answer["satellites"], figure["data"][1]["y"]
    assert max(load) == pytest.approx(satellite["peak_load_N"], rel=1e-3)
    assert min(load) == pytest.approx(satellite["min_load_N"], rel=1e-2)
    assert figure["layout"]["shapes"] == []
    path, body = single("crankshaft", few)
    answer = await api.answer(path, body)
    figure = await api.answer(f"{path}/chart", body)
    for bearing, trace in zip(answer["bearings"], figure["data"][1::2], strict=True):
        assert max(trace["y"]) == pytest.approx(bearing["peak_N"], rel=1e-3)
    path, body = single("pin_strength", few)
    answer = await api.answer(path, body)
    figure = await api.answer(f"{path}/chart", body)
    assert max(figure["data"][-1]["y"]) == pytest.approx(
        answer["fatigue"]["max_stress_MPa"], rel=1e-3
    )


@pytest.mark.parametrize(
    "changes",
    [
        {},  # of pins that bend one satellite carries more by its stiffness, one if shared alike
        {"load__torque_direction": "reverse"},
        {
            "pin": None,
            "mechanism__crank_angles_deg": [0.0, 100.0],
            "load__torque_direction": "alternating",
        },
        {
            "mechanism__pins": 3,
            "contact__hole_clearance_mm": 0.02,
            **DEVIATIONS,
            "load__torque_direction": "alternating",
        },
    ],
)
async def test_curves_are_of_the_sharing_and_the_direction_that_are_judged(api, changes):
    path, body = single("satellite_bearing", changed(DESIGN, **changes))
    answer = await api.answer(path, body)
    figure = await api.answer(f"{path}/chart", body)
    loads = [trace["y"] for trace in figure["data"] if trace.get("xaxis") == "x2"]
    peaks = [max(load) for load in loads if len(load) > 2]
    expected = [each["peak_load_N"] for each in answer["satellites"]]
    assert peaks == pytest.approx(expected, rel=1e-2)
    path, body = single("crankshaft", changed(DESIGN, **changes))
    answer = await api.answer(path, body)
    figure = await api.answer(f"{path}/chart", body)
    peaks = [max(trace["y"]) for trace in figure["data"][1::2]]
    assert peaks == pytest.approx([each["peak_N"] for each in answer["bearings"]], rel=1e-2)


def test_real_forces_of_a_section_leave_the_event_loop():
    for section in ("output_efficiency", "satellite_bearing"):
        name, body = single(section, ALONE)
        _, real = single(section, FEW)
        body.pop("pin", None)
        real.pop("pin", None)
        request = CALCULATIONS[name].request
        assert request.model_validate(body).cost() <= LIGHT_COST
        assert request.model_validate(real).cost() > LIGHT_COST


def test_fixes_of_a_loaded_design_leave_the_event_loop():
    """Whatever its load includes."""
    body = changed(DESIGN, pin=None, fatigue=None, gear=None, include=["fixes"])
    read = CALCULATIONS[PATH].request.model_validate(body)
    assert read.cost() > LIGHT_COST


async def test_real_curves_are_at_their_angles(api):
    """The loss by the forces that `/load-sharing` solves there, which are nearly parallel."""
    design = changed(
        FEW | DEVIATIONS,
        mechanism__initial_crank_angle_deg=30.0,
        load__torque_direction="reverse",
    )
    path, body = single("output_efficiency", design)
    answer = await api.answer(path, body | {"include": ["curves"], "samples": 13})
    load = {name: each for name, each in design["load"].items() if name != "input_speed_rpm"}
    asked = {name: design[name] for name in ("mechanism", "contact", "pin", "deviations")}
    material = {
        name: design["pin"]["material"][name] for name in ("youngs_modulus_GPa", "poissons_ratio")
    }
    asked |= {"load": load, "pin": asked["pin"] | {"material": material}}
    angles = answer["curves"]["crank_angle_deg"]
    positions = (await api.answer("load-sharing", asked | {"crank_angle_deg": angles}))["positions"]
    forces = [sum(map(sum, each["force_N"])) for each in positions]
    power = [0.08 * answer["sliding_speed_m_per_s"] * each for each in forces]
    assert answer["curves"]["loss_W"] == pytest.approx(power, rel=1e-3)
    assert max(power) > 1.1 * min(power)
    path, body = single("satellite_bearing", design)
    across = (await api.answer(f"{path}/chart", body))["data"][0]["x"]
    assert max(across) < 0  # in reverse


@pytest.mark.parametrize("section", ["bearing", "rollers", "crankshaft"])
async def test_a_bearing_without_a_name_is_refused_at_its_name(api, section):
    load, contact = {"pin_circle_radius_mm": 40}, {"pin_radius_mm": 6, "eccentricity_mm": 1.5}
    body = {"mechanism": {"pins": 6, "satellites": 2, "ratio": 20}, "load": load}
    body["contact"] = contact | {"contact_length_mm": 10, "hole_clearance_mm": 0.02}
    named = {"name": ""}
    if section == "crankshaft":
        named = {
            "satellite_positions_mm": [20, 40],
            "bearing_positions_mm": [0, 60],
            "bearings": [named, named],
        }
    answer = await api.post("fit", json=body | {section: named})
    assert answer.status_code == 422
    assert "no_such_bearing" in {each["code"] for each in answer.json()["errors"]}


async def test_a_bolt_of_values_is_one_of_its_table_row(api):
    body = {
        "mechanism": {"pins": 6, "satellites": 2, "ratio": 20},
        "load": {"output_torque_Nm": 200, "pin_circle_radius_mm": 50},
        "pin": {
            "satellite_positions_mm": [10, 30],
            "support": "cantilever",
            "diameter_mm": 16,
            "contact_length_mm": 12,
            "material": "steel_through_hardened",
            "bolt": {"core_diameter_mm": 6.5, "preload_N": 9000},
        },
    }
    answers = []
    for material in ("steel_structural", {"name": "steel_structural"}):
        body["pin"]["bolt"]["bolt_material"] = material
        answer = await api.post("pin-strength", json=body)
        assert answer.status_code == 200, answer.text
        answers.append(answer.json()["bolt"])
    assert answers[0] == answers[1]
