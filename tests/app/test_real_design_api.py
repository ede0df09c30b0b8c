"""The design document with clearance, deviations and elasticity, over REST: the section of its
forces, what follows from what, refusals.
"""

from copy import deepcopy

import numpy as np
import pytest

from app.calculations.crank_planetary_sections import CrankPlanetaryRequest
from app.endpoint import LIGHT_COST
from app.examples import REQUESTS
from core.precision import EXACT
from tests.inputs.bodies import changed

pytestmark = pytest.mark.anyio

PATH = "crank-planetary"
IDEAL = REQUESTS[PATH]
DESIGN = {
    "mechanism": {"pins": 6, "satellites": 2, "ratio": 20.0},
    "load": {
        "output_torque_Nm": 200.0,
        "pin_circle_radius_mm": 40.0,
        "torque_direction": "alternating",
    },
    "contact": {
        "contact_length_mm": 12.0,
        "pin_radius_mm": 5.0,
        "eccentricity_mm": 2.0,
        "hole_clearance_mm": 0.03,
        "hole_material": "steel_case_hardened",
    },
    "deviations": {"pin_tangential_mm": [-0.02, 0.0, 0.0, 0.0, 0.0, 0.0]},
    "pin": {"support": "fixed", "satellite_positions_mm": [9.0, 23.0], "span_mm": 34.0},
    "requirements": {"max_backlash_arcmin": 8.0, "max_lost_motion_arcmin": 8.0},
    "include": ["load_sharing", "hertz", "checks"],
}
"""A design as its parts are made, with what is asked of it."""


async def test_the_section_is_that_of_load_sharing(api):
    both = {}
    for way in ("driving", "reverse"):
        body = {name: DESIGN[name] for name in ("mechanism", "contact", "deviations", "pin")}
        body["load"] = DESIGN["load"] | {"torque_direction": way}
        response = await api.post("load-sharing", json=body | {"include": ["over_turn"]})
        both[way] = response.json()["over_turn"]
    answer = await api.answer(PATH, DESIGN)
    found = answer["load_sharing"]
    worse = max(both, key=lambda way: both[way]["max_pressure_MPa"])
    assert found.pop("torque_direction") == worse
    pair, force = found["peak_pair"], found.pop("judged_force_N")
    assert force == pytest.approx(found["peak_force_N"])
    found.pop("accuracy")
    found.pop("warnings", None)
    assert found == {name: pytest.approx(value) for name, value in both[worse].items()}
    # under which the pressure is that of the section hertz and of the checks
    checks = {each["code"]: each for each in answer["checks"]}
    pressure = checks["contact_pressure_hole"]
    assert pressure["value"] == answer["hertz"]["governing_pressure_MPa"]
    # at the end of the contact, as the pins slope
    peak = found["max_pressure_MPa"] * answer["hertz"]["line_load_factor"] ** 0.5
    assert answer["hertz"]["max_pressure_MPa"] == pytest.approx(peak)
    assert {name: pressure["at"][name] for name in pair} == pair
    assert checks["backlash"]["value"] == found["backlash_max_arcmin"]
    assert checks["lost_motion"]["value"] == found["lost_motion_arcmin"]
    assert "clearance" not in answer["not_considered"]


GIVES = {
    "bearings": {"crank_support": {"stiffness_N_per_mm": 2e5, "radial_clearance_mm": 0.02}},
    "mesh": {"satellite_coupling": {"kind": "elastic", "stiffness_Nm_per_arcmin": 30.0}},
    "shares": {"satellite_coupling": {"kind": "shares", "shares": [0.55, 0.45]}},
}
GIVES["both"] = GIVES["bearings"] | GIVES["mesh"]


@pytest.mark.parametrize("gives", GIVES.values(), ids=GIVES)
async def test_satellites_that_give_are_those_of_load_sharing(api, gives):
    """One source of forces: the section, the checks and the pins."""
    design = changed(DESIGN, load__torque_direction="driving", requirements=None) | gives
    design["include"] = ["load_sharing", "pin_strength", "checks"]
    body = {name: design[name] for name in ("mechanism", "load", "contact", "deviations", "pin")}
    body |= gives | {"include": ["over_turn"]}
    expected = (await api.post("load-sharing", json=body)).json()["over_turn"]
    answer = await api.answer(PATH, design)
    found = answer["load_sharing"]
    assert {name: found[name] for name in expected} == {
        name: pytest.approx(value) for name, value in expected.items()
    }
    checks = {each["code"]: each for each in answer["checks"]}
    assert checks["lost_motion"]["value"] == found["lost_motion_arcmin"]
    peak = answer["pin_strength"]["peak_force_N"]
    assert peak == pytest.approx(expected["peak_force_N"], rel=2e-5)


async def test_satellites_that_give_are_refused_by_name(api):
    other = {"satellite_coupling": {"kind": "shares", "shares": [1.0]}}
    assert await api.refusal(PATH, DESIGN | other) == (
        "/satellite_coupling/shares",
        "different_length",
    )
    many = changed(DESIGN, mechanism__pins=13, deviations=None, load__pin_circle_radius_mm=80.0)
    assert await api.refusal(PATH, many | GIVES["mesh"]) == ("/mechanism/pins", "too_many_pairs")
    rigid = {"satellite_coupling": {"kind": "rigid"}}
    one, other = [
        (await api.answer(PATH, each | {"include": ["load_sharing"]}))["load_sharing"]
        for each in (DESIGN, DESIGN | rigid)
    ]
    assert one | {"accuracy": None} == other | {"accuracy": None}


async def test_the_section_is_at_the_torque_the_checks_at_the_dynamic_one(api):
    one = await api.answer(PATH, changed(DESIGN, contact__dynamic_factor=1.25))
    more = await api.answer(PATH, changed(DESIGN, load__output_torque_Nm=250.0))
    base = await api.answer(PATH, DESIGN)
    for name in ("peak_force_N", "lost_motion_arcmin", "max_pressure_MPa"):
        assert one["load_sharing"][name] == base["load_sharing"][name]
    for name in ("judged_force_N",):
        assert one["load_sharing"][name] == pytest.approx(more["load_sharing"][name])
    assert one["hertz"]["max_pressure_MPa"] == pytest.approx(more["hertz"]["max_pressure_MPa"])
    used = (
        next(each for each in answer["checks"] if each["code"] == "contact_pressure_hole")
        for answer in (one, more)
    )
    assert len({each["utilisation"] for each in used}) == 1


@pytest.mark.parametrize(
    ("contact", "clearance", "codes"),
    [
        ({"hole_radius_mm": 10.0, "eccentricity_mm": 2.0}, 0.0, []),
        ({"hole_radius_mm": 10.03, "eccentricity_mm": 2.0}, 0.03, ["clearance"]),
        ({"eccentricity_mm": 2.0, "hole_clearance_mm": 0.03}, 0.03, ["clearance"]),
        ({"eccentricity_mm": 2.0}, 0.0, []),
        ({"eccentricity_mm": 2.0, "hole_clearance_mm": -0.03}, -0.03, ["interference"]),
        ({"hole_radius_mm": 10.03}, 0.0, ["eccentricity_assumed"]),
        (
            {"hole_radius_mm": 10.03, "eccentricity_mm": 2.0, "hole_clearance_mm": 0.03},
            0.03,
            ["clearance"],
        ),
    ],
)
async def test_of_hole_eccentricity_and_clearance_two_say_the_third(api, contact, clearance, codes):
    body = deepcopy(IDEAL)
    body["contact"] = {"contact_length_mm": 20.0, "pin_radius_mm": 8.0} | contact
    answer = await api.answer(PATH, body | {"include": ["geometry", "checks"]})
    assert answer["geometry"]["clearance_mm"] == pytest.approx(clearance, abs=1e-12)
    unknown = clearance == 0  # as no clearance is stated
    assert "warnings" not in answer  # which the checks say
    asked = {*(each["code"] for each in answer["checks"])}
    asked |= {each["reason"]["code"] for each in answer["checks"] if "reason" in each}
    assert {*codes} <= asked
    plain = await api.answer(PATH, body | {"include": ["geometry"]})
    said = ["clearance_unknown"] if unknown and "eccentricity_mm" in contact else []
    assert [each["code"] for each in plain.get("warnings", [])] == said + codes
    reason = answer["parts"][0].get("reason")
    assert (reason == "clearance_unknown") == (unknown and answer["parts"][0]["status"] == "open")
    assert (answer["verdict"] == "fail") or clearance >= 0


@pytest.mark.parametrize(
    "include", [["load_sharing"], ["hertz", "contact_force", "geometry"], None]
)
@pytest.mark.parametrize(
    ("changes", "reason"),
    [
        ({"deviations__disc_phase_deg": [0, 5]}, "discs_out_of_phase"),
        ({"deviations": None, "contact__hole_clearance_mm": -1.0}, "cannot_assemble"),
    ],
)
async def test_parts_that_cannot_be_put_together_are_judged_not_refused(
    api, changes, reason, include
):
    """Without the sections of their forces: the verdict and the fit say what is wrong."""
    body = changed(DESIGN, **changes, include=include)
    if include:
        body["include"] = [*include, "checks"]
    answer = await api.answer(PATH, body)
    assert "load_sharing" not in answer and ("contact_force" in answer) == (
        include != ["load_sharing"]
    )
    assert "hertz" not in answer
    assert (answer["verdict"], answer["governing"]) == ("fail", "interference")
    assert answer["fit"]["state"] == "does_not_fit" and answer["fit"]["needed_hole_radius_mm"] > 0
    if include:
        assert answer["checks"][0]["reason"]["code"] == reason


async def test_uneven_sharing_may_be_assumed_of_ideal_forces_only(api):
    for changes in (
        {"contact__hole_radius_mm": 10.03},
        {"contact_law": {"kind": "hertz"}},
        {"deviations": {}},
    ):
        body = changed(IDEAL, contact__distribution_factor=1.2, **changes)
        assert (await api.refusal(PATH, body))[1] == "with_real_forces"
        assert (
            await api.post(PATH, json=changed(body, contact__distribution_factor=1.0))
        ).is_success
    await api.answer(PATH, changed(IDEAL, contact__distribution_factor=1.2))


async def test_by_default_what_cannot_be_solved_is_left_out_and_said(api):
    soft = {"kind": "linear", "stiffness_N_per_mm": 1}
    answer = await api.answer(PATH, changed(DESIGN, contact_law=soft, include=None))
    assert not {"load_sharing", "hertz"} & {*answer} and "contact_force" in answer
    assert answer["verdict"] in ("incomplete", "fail") and "contact" in answer["not_considered"]
    turned = await api.answer(
        PATH, changed(DESIGN, deviations__disc_phase_deg=[0, 5], include=None)
    )
    assert not {"load_sharing", "hertz"} & {*turned} and "contact_force" in turned
    assert turned["verdict"] == "fail" and turned["governing"] == "interference"
    default = await api.answer(PATH, changed(DESIGN, include=None))
    assert {"cyclogram", "contact_force", "load_sharing", "hertz"} <= {*default}


async def test_the_geometry_has_the_real_forces(api):
    body = changed(
        DESIGN, include=["geometry"], crank_angle_deg=37.0, load__torque_direction="reverse"
    )
    pairs = (await api.answer(PATH, body))["geometry"]["pairs"]
    sharing = {name: body[name] for name in ("mechanism", "load", "contact", "deviations", "pin")}
    response = await api.post("load-sharing", json=sharing | {"crank_angle_deg": [37.0]})
    forces = [each for row in response.json()["positions"][0]["force_N"] for each in row]
    assert [each["force_N"] for each in pairs] == pytest.approx(forces)
    assert [each["driving"] for each in pairs] == [force > 0 for force in forces]


@pytest.mark.parametrize("body", [IDEAL, changed(DESIGN)])
async def test_steps_of_the_ideal_force_say_where_others_are_judged(api, body):
    answer = await api.answer(PATH, {**body, "include": ["contact_force", "worked"]})
    notes = {step["code"]: step.get("note") for step in answer["worked"]}
    solved = answer["model"] == "real"
    assert notes["reference_force_N"] == ("ideal_beside_solved" if solved else None)


async def test_in_reverse_the_other_pairs_carry(api):
    bodies = [
        changed(IDEAL, load__torque_direction=way, crank_angle_deg=20.0, include=["geometry"])
        for way in ("driving", "reverse")
    ]
    pairs = [(await api.answer(PATH, body))["geometry"]["pairs"] for body in bodies]
    for one, other in zip(*pairs, strict=True):
        assert one["pressure_angle_deg"] == other["pressure_angle_deg"]
        assert min(one["force_N"], other["force_N"]) == 0
    lever = np.cos(np.radians([each["pressure_angle_deg"] for each in pairs[1]]))
    force = np.array([each["force_N"] for each in pairs[1]])
    load = IDEAL["load"]
    torque = float(force @ lever) * load["pin_circle_radius_mm"] / 1000
    assert torque == pytest.approx(-load["output_torque_Nm"])


def test_only_what_solves_or_searches_over_the_turn_is_long():
    for body, long in (
        (IDEAL, False),
        (changed(IDEAL, load__torque_direction="reverse"), False),
        (changed(IDEAL, contact__hole_radius_mm=9.9), False),
        (changed(IDEAL, pin={"satellite_positions_mm": [10, 30]}), True),
        (changed(IDEAL, requirements={"max_backlash_arcmin": 1}), False),
        (DESIGN, True),
        (changed(IDEAL, contact__hole_radius_mm=10.03), True),
        (changed(IDEAL, deviations={}), True),
        (changed(IDEAL, include=["load_sharing"]), True),
        (changed(IDEAL, requirements={"max_lost_motion_arcmin": 1}), True),
    ):
        read = CrankPlanetaryRequest.model_validate(body)
        assert (read.cost() > LIGHT_COST) == long, body
    read = CrankPlanetaryRequest.model_validate(changed(DESIGN, load=None, include=None))
    assert read.cost() <= LIGHT_COST  # without a load there is nothing to solve


PRINTED = {
    "mechanism": {"pins": 4, "satellites": 2, "satellite_teeth": 20, "ring_teeth": 21},
    "load": {"output_torque_Nm": 5.4, "pin_circle_radius_mm": 30},
    "contact": {
        "contact_length_mm": 10,
        "pin_radius_mm": 2,
        "hole_radius_mm": 4,
        "eccentricity_mm": 1.5,
    },
    "gear": {
        "kind": "cycloid",
        "ring_pin_circle_radius_mm": 54,
        "ring_pin_radius_mm": 2,
        "modification": {"equidistant_mm": 0.25},
    },
    "bearing": {"kind": "ball", "dynamic_rating_N": 6000, "static_rating_N": 3250},
    "pin": {"satellite_positions_mm": [7, 19], "support": "cantilever", "diameter_mm": 4},
}
"""A public design of printed discs."""

TEETH = {
    "kind": "involute",
    "module_mm": 2.5,
    "satellite_profile_shift": 0,
    "ring_profile_shift": 0,
    "satellite_addendum": 1,
    "ring_addendum": 1,
    "ring_material": "steel_case_hardened",
}
NO_PINS = dict.fromkeys(PRINTED["gear"].keys() - TEETH.keys())


@pytest.mark.parametrize(
    ("change", "governing"),
    [
        ({"deviations": {"disc_phase_deg": [0, 9]}}, "interference"),
        (
            {"contact__hole_radius_mm": 3.48, "contact__distribution_factor": 1.2},
            "interference",
        ),
        ({"gear__modification__equidistant_mm": -0.1}, "ring_pressed"),
        ({"gear": TEETH | NO_PINS, "load__pin_circle_radius_mm": 10}, "mesh_involute"),
    ],
)
async def test_nothing_of_forces_stands_beside_what_cannot_be_put_together(api, change, governing):
    """A public design, one disc printed twice: satellite 2 carried 28.5 times the torque."""
    body = changed(PRINTED, **change)
    usual = await api.answer(PATH, body)
    body["include"] = ["hertz", "load_sharing", "ring_mesh", "pin_strength", "checks"]
    answer = await api.answer(PATH, body)
    assert (answer["verdict"], answer["governing"]) == ("fail", governing)
    assert answer["checks"][0]["impossible"]
    forces = {"shares", "torque_reserve", "largest_torque_Nm", "hertz", "load_sharing", "ring_mesh"}
    assert not (forces | {"pin_strength"}) & ({*answer} | {*usual})
    assert "uneven_sharing" not in [each["code"] for each in answer.get("warnings", [])]
    loaded = [each for each in answer["checks"] if "/load/output_torque_Nm" in each["inputs"]]
    assert len(loaded) > 10
    for each in loaded:
        assert each["status"] in ("not_checked", "not_asked", "not_applicable")
        assert not {"value", "torque_reserve"} & {*each}


async def test_a_mesh_without_a_height_of_its_teeth_is_no_failure(api):
    """Teeth that no height brings into mesh have no forces; others ask for the height."""
    teeth = {name: value for name, value in TEETH.items() if name != "ring_addendum"}
    body = changed(PRINTED | {"gear": teeth}, include=["ring_mesh", "checks"])
    answer = await api.answer(PATH, body)
    assert (answer["verdict"], answer["governing"]) == ("fail", "mesh_possible")
    assert "ring_mesh" not in answer
    teeth |= {"module_mm": 1.0, "ring_profile_shift": 0.2}
    body["mechanism"] |= {"satellite_teeth": 45, "ring_teeth": 50}
    body["contact"] |= {"eccentricity_mm": 2.665, "hole_radius_mm": 4.7}
    body |= {"gear": teeth, "include": ["ring_mesh"]}
    assert await api.refusal(PATH, body) == ("/gear/ring_addendum", "missing")


async def test_an_efficiency_says_what_it_leaves_out(api):
    """A ring on rolling bearings lost nothing, and 0.9993 passed; without its friction more did."""
    rolls = {"gear__friction_coefficient": 0.0015, "gear__rolling": True}
    given = {
        "friction": {"coefficient": 0.02},
        "load__input_speed_rpm": 300,
        "requirements": {"min_efficiency": 0.9},
        "include": ["checks", "ring_mesh"],
    }
    answer = await api.answer(PATH, changed(PRINTED, **given, **rolls))
    checks = {each["code"]: each for each in answer["checks"]}
    known, ring = checks["efficiency"], answer["ring_mesh"]["efficiency"]
    assert (known["status"], known["reason"]["code"]) == ("pass", "losses_left_out")
    assert 0.99 < ring["efficiency"] < 1
    unknown = []
    for least in (0.9, 0.999):
        given["requirements"] = {"min_efficiency": least}
        answer = await api.answer(PATH, changed(PRINTED, **given))
        unknown += [each for each in answer["checks"] if each["code"] == "efficiency"]
    assert [each["status"] for each in unknown] == ["not_checked", "fail"]
    assert unknown[0]["missing"] == ["/gear/friction_coefficient"]
    assert unknown[0]["value"] == unknown[1]["value"]
    lost = 1 / unknown[0]["value"] + ring["loss_ratio"]
    assert known["value"] == pytest.approx(1 / lost, rel=EXACT)


@pytest.mark.parametrize(
    ("pins", "radius", "said"), [(3, 16.0, True), (3, 10.0, False), (4, 16.0, False)]
)
async def test_thick_pins_that_are_few_may_be_crankshafts(api, pins, radius, said):
    """Sizes of an RV reducer with three crankshafts: r 16 on R 36."""
    body = {
        "mechanism": {"pins": pins, "satellites": 2, "satellite_teeth": 39, "ring_teeth": 40},
        "load": {"output_torque_Nm": 412, "pin_circle_radius_mm": 36},
        "contact": {
            "contact_length_mm": 12,
            "pin_radius_mm": radius,
            "hole_radius_mm": radius + 1.3,
            "eccentricity_mm": 1.3,
        },
    }
    answer = await api.answer(PATH, body)
    assert ("pins_like_crankshafts" in [each["code"] for each in answer["warnings"]]) == said


async def test_a_ratio_that_teeth_contradict_is_said(api):
    body = changed(PRINTED, mechanism__ratio=19.0)
    problem = (await api.post(PATH, json=body)).json()
    (error,) = problem["errors"]
    assert (error["pointer"], error["code"]) == ("/mechanism/ratio", "other_ratio")
    assert "give 20:" in error["detail"]
    body["mechanism"]["ratio"] = 20.0
    assert await api.refusal(PATH, body) == ("/mechanism/satellite_teeth", "only_one")


async def test_holes_outside_the_satellite_are_said_in_millimetres(api):
    """The distance of their edge was stated before as a negative number of radii."""
    body = changed(
        PRINTED,
        contact__hole_radius_mm=3.51,
        contact__hole_material="PLA",
        load__pin_circle_radius_mm=53.0,
        load__output_torque_Nm=200.0,
    )
    answer = await api.answer(PATH, body)
    (said,) = [each for each in answer["warnings"] if each["code"] == "hole_outside_disc"]
    # roots of the lobes: less a pin and the eccentricity, the modification, and the holes
    beyond = 53 + 3.51 - (54 - 2 - 1.5 - 0.25)
    assert said["params"]["beyond"] == pytest.approx(beyond, rel=EXACT)
    assert f"{beyond:.4g} mm" in said["detail"]
