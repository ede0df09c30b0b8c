"""Involute teeth in the design document over REST: what `/ring-mesh` answers of them, what is
refused, what was passed once and cannot mesh, and fixes by profile shifts.
"""

import math
from copy import deepcopy
from typing import Any

import pytest

from app.calculations.crank_planetary_sections import CrankPlanetaryRequest
from app.examples import EXAMPLES
from core.precision import JUDGED
from tests.inputs.bodies import changed

pytestmark = pytest.mark.anyio

PATH = "crank-planetary"
WHOLE = next(each for each in EXAMPLES if each["id"] == "involute")["input"]
TEETH = {
    "mechanism": WHOLE["mechanism"],
    "load": {
        "output_torque_Nm": 400.0,
        "pin_circle_radius_mm": 37.0,
        "input_speed_rpm": 720.0,
        "application_factor": 1.25,
    },
    "contact": {**WHOLE["contact"], "hole_clearance_mm": 0.0},
    "gear": WHOLE["gear"],
    "requirements": {"scope": ["teeth"]},
    "include": ["checks"],
}
del TEETH["contact"]["fit"]


async def test_their_drawing_stands_as_their_files_do(api: Any) -> None:
    """A pitch of each, turned so that a tooth of a satellite is where its crank points."""
    body = changed(TEETH, mechanism={"initial_crank_angle_deg": 30.0}, include=["ring_drawing"])
    answer, _ = await api.judged(PATH, body)
    drawn = answer["ring_drawing"]
    pair = CrankPlanetaryRequest.model_validate(body).results.ring.pair
    for name, ends in (
        ("lobe_mm", (pair.teeth.satellite_root, pair.teeth.satellite_tip)),
        ("ring_lobe_mm", (pair.teeth.ring_tip, pair.ring_root_radius)),
    ):
        far = [math.hypot(*point) for point in drawn[name]]
        assert (min(far), max(far)) == pytest.approx([1e3 * e for e in ends], rel=JUDGED)
        assert drawn[name][0][0] == pytest.approx(0, abs=1e-4)
    assert drawn["ring_turn_deg"] == -30.0
    assert drawn["turn_deg"] == pytest.approx([4.5 - 30.0, 4.5 + 180 / 20 - 30.0])
    undercut = changed(TEETH, gear={"satellite_profile_shift": -1.5}, include=["ring_drawing"])
    assert "ring_drawing" not in (await api.judged(PATH, undercut))[0]


async def test_the_mesh_is_what_its_endpoint_answers(api: Any) -> None:
    """To the last digit, with the factors of the stresses; by default too."""
    gear = {"face_load_factor": 1.1, "pair_stiffness_N_per_mm": 3e5}
    found, checks = await api.judged(
        PATH, changed(TEETH, gear=gear, include=["ring_mesh", "checks"])
    )
    alone = {
        "mechanism": {name: TEETH["mechanism"][name] for name in ("satellite_teeth", "ring_teeth")},
        "load": {"output_torque_Nm": 400.0, "input_speed_rpm": 720.0, "application_factor": 1.25},
        "contact": {"eccentricity_mm": 3.68},
        "gear": {
            name: value
            for name, value in {**TEETH["gear"], **gear}.items()
            if name not in ("teeth_difference", "root_strength_MPa")
        }
        | {"contact_length_mm": 22.0, "satellite_material": "steel_case_hardened"},
        "include": ["stresses", "shared_pairs"],
    }
    own = (await api.post("ring-mesh", json=alone)).json()
    mesh = found["ring_mesh"]
    for name in ("geometry", "stresses", "shared_pairs", "efficiency"):
        assert mesh[name] == own[name], name
    assert mesh["accuracy"]["relative_error"] == own["accuracy"]["relative_error"]
    assert mesh["satellite_torque_Nm"] == 200.0 and "warnings" not in mesh
    drawn = await api.post(f"{PATH}/chart", json=changed(TEETH, gear=gear, include=["ring_mesh"]))
    assert drawn.json() == (await api.post("ring-mesh/chart", json=alone)).json()
    assert checks["ring_pressure_pin"]["value"] == own["stresses"]["pressure_one_pair_start_MPa"]
    root = own["stresses"]["root"]["root_stress_one_pair_MPa"]
    assert checks["mesh_root_stress"]["value"] == root
    geometry, angle = own["geometry"], checks["ring_backlash"]["value"]
    assert (checks["mesh_tips"]["value"], angle) == (
        geometry["tip_interference_G"],
        geometry["backlash_arcmin"],
    )
    body = changed(TEETH)
    del body["include"]
    assert (await api.judged(PATH, body))[0]["ring_mesh"]["geometry"] == own["geometry"]
    open_, _ = await api.judged(PATH, {**body, "gear": {"kind": "involute", "module_mm": 3.0}})
    assert "ring_mesh" not in open_


async def test_angles_are_those_of_the_output(api: Any) -> None:
    pins, _ = await api.judged(PATH, changed(TEETH, include=["ring_mesh"]))
    body = changed(TEETH, include=["ring_mesh"], mechanism={"output": "ring"})
    body["load"]["output_torque_Nm"] *= 21 / 20
    ring, _ = await api.judged(PATH, body)
    one, two = (each["ring_mesh"] for each in (pins, ring))
    backlash = [each["geometry"]["backlash_arcmin"] for each in (one, two)]
    assert backlash[1] == pytest.approx(backlash[0] * 20 / 21)
    for name in ("normal_force_N", "pressure_one_pair_start_MPa"):
        assert two["stresses"][name] == pytest.approx(one["stresses"][name])


@pytest.mark.parametrize(
    ("sections", "pointer", "code"),
    [
        (
            {"gear": {"satellite_material": "steel_structural"}},
            "/gear/satellite_material",
            "discs_disagree",
        ),
        ({"gear": {"pin_material": "steel_bearing"}}, "/gear/pin_material", "of_another_kind"),
        ({"gear": {"ring_addendum": 1.3}}, "/gear/ring_addendum", "less_than_equal"),
        (
            {"gear": {"satellite_profile_shift": None}, "include": ["ring_mesh"]},
            "/gear/satellite_profile_shift",
            "needed_for",
        ),
    ],
)
async def test_what_does_not_fit_together_is_refused(
    api: Any, sections: dict[str, Any], pointer: str, code: str
) -> None:
    assert await api.refusal(PATH, changed(TEETH, **sections)) == (pointer, code)


async def test_what_is_assumed_of_the_ring_is_said(api: Any) -> None:
    for material, said in ((None, True), ("steel_bearing", False)):
        answer, _ = await api.judged(PATH, changed(TEETH, gear={"ring_material": material}))
        pointers = [each["pointer"] for each in answer.get("assumed", ())]
        assert ("/gear/ring_material" in pointers) == said


REF = {
    "mechanism": {"satellite_teeth": 20, "ring_teeth": 21},
    "contact": {"eccentricity_mm": 2.0},
}
"""20 in 21 teeth of 3.5 mm, 2 mm off the axis: no tooth form at all meshes."""
REF_TEETH = {"module_mm": 3.5, "teeth_difference": 1, "cutter_teeth": None, "ring_addendum": 0.5}
STEEP = {"satellite_addendum": 0.8, "ring_addendum": 0.8}


@pytest.mark.parametrize(
    ("sections", "code", "status"),
    [
        (
            {**REF, "gear": {**REF_TEETH, "satellite_addendum": 0.5, "ring_profile_shift": 0.11}},
            "mesh_tips",
            "fail",
        ),
        (
            {**REF, "gear": {**REF_TEETH, "satellite_addendum": 0.3, "ring_profile_shift": 0.11}},
            "mesh_contact_ratio",
            "fail",
        ),
        (
            {**REF, "gear": {**REF_TEETH, "ring_addendum": 1.0, "ring_profile_shift": 0.11}},
            "mesh_involute",
            "fail",
        ),
        # the tutorial's once: 40 in 42 teeth on 3.2 mm, at 28 degrees
        (
            {"contact": {"eccentricity_mm": 3.2}, "gear": {**STEEP, "ring_profile_shift": 0.11}},
            "mesh_tips",
            "fail",
        ),
        (
            {"load": {"peak_torque_Nm": 5e4}, "gear": {"ring_material": "steel_case_hardened"}},
            "ring_static_pin",
            "fail",
        ),
        ({"load": {"output_torque_Nm": 2500.0}}, "ring_pressure_pin", "fail"),
        ({"gear": {"root_strength_MPa": 300.0}}, "mesh_root_stress", "fail"),
    ],
)
async def test_what_passed_once_is_red_and_says_why(
    api: Any, sections: dict[str, Any], code: str, status: str
) -> None:
    body = changed(TEETH, **sections)
    answer, checks = await api.judged(PATH, body)
    assert (answer["verdict"], checks[code]["status"]) == ("fail", status)
    (teeth,) = (each for each in answer["parts"] if each["code"] == "teeth")
    assert teeth["status"] == "fail"


async def test_teeth_without_shifts_are_open_and_may_fail(api: Any) -> None:
    bare = {"kind": "involute", "module_mm": 3.0}
    answer, _ = await api.judged(PATH, {**changed(TEETH), "gear": bare})
    (teeth,) = (each for each in answer["parts"] if each["code"] == "teeth")
    assert (teeth["status"], teeth["reason"]) == ("open", "teeth_not_judged")
    assert teeth["missing"] == [
        f"/gear/{name}"
        for name in (
            "satellite_profile_shift",
            "ring_profile_shift",
            "satellite_addendum",
            "ring_addendum",
        )
    ]
    body = {**changed(TEETH, **REF), "gear": {"kind": "involute", "module_mm": 3.5}}
    answer, checks = await api.judged(PATH, body)
    assert (answer["verdict"], answer["governing"]) == ("fail", "mesh_possible")
    assert checks["mesh_possible"]["impossible"] and "torque_reserve" not in answer


def set_in(body: dict[str, Any], sets: dict[str, Any]) -> dict[str, Any]:
    made = deepcopy(body)
    for pointer, value in sets.items():
        section, name = pointer.split("/")[1:]
        made[section][name] = value
    return made


@pytest.mark.parametrize(
    ("sections", "pointers"),
    [
        ({"gear": {"ring_profile_shift": 0.2}}, {"satellite_profile_shift", "eccentricity_mm"}),
        (
            {"gear": {"satellite_addendum": 1.0, "ring_addendum": 1.0}},
            {"satellite_profile_shift", "eccentricity_mm"},
        ),
        (
            {
                "gear": {
                    "satellite_addendum": None,
                    "ring_addendum": None,
                    "satellite_tip_radius_mm": 63.0,
                    "ring_tip_radius_mm": 61.5,
                }
            },
            {"satellite_profile_shift"},
        ),
        (
            {
                "contact": {
                    "eccentricity_mm": 3.2,
                    "hole_clearance_mm": None,
                    "hole_radius_mm": 10.22,
                }
            },
            {"eccentricity_mm"},
        ),
    ],
)
async def test_shifts_that_are_chosen_cure(
    api: Any, sections: dict[str, Any], pointers: set[str]
) -> None:
    """Each fix, sent again, has the verdict that it says, and cures what it is of."""
    body = changed(TEETH, **sections, include=["checks", "fixes"])
    answer, _ = await api.judged(PATH, body)
    assert answer["verdict"] == "fail"
    chosen = [each for each in answer["fixes"] if "exact" not in each]
    assert {each["pointer"].split("/")[-1] for each in chosen} == pointers
    for fix in answer["fixes"]:
        again, checks = await api.judged(PATH, set_in(body, fix["sets"]))
        assert again["verdict"] == fix["verdict"], fix
        if fix["status"] == "solved":
            assert checks[fix["code"]]["status"] == "pass", fix
    for fix in chosen:
        assert "/gear/ring_profile_shift" in fix["sets"] and "change" not in fix
        _, checks = await api.judged(PATH, set_in(body, fix["sets"]))
        for code in ("mesh_tips", "mesh_contact_ratio", "mesh_involute", "ring_pressed"):
            assert checks[code]["status"] == "pass", (fix, code)
    if "hole_radius_mm" in body["contact"]:
        (fix,) = chosen
        moved = fix["sets"]["/contact/eccentricity_mm"] - 3.2
        assert fix["sets"]["/contact/hole_radius_mm"] == pytest.approx(10.22 + moved)


async def test_the_whole_reducer_is_green(api: Any) -> None:
    answer, checks = await api.judged(PATH, {**WHOLE, "include": ["checks"]})
    assert answer["verdict"] == "pass"
    assert {each["status"] for each in answer["parts"]} == {"pass"}
    assert checks["ring_pressure_pin"]["status"] == checks["ring_static_pin"]["status"] == "pass"
