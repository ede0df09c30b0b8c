"""Rollers on the pins, bearings by name, bored pins: what is asked, answered, refused."""

from typing import Any

import pytest

from core.bearings import BEARINGS
from core.precision import EXACT, SEARCHED

pytestmark = pytest.mark.anyio

SMALL: dict[str, Any] = {
    "mechanism": {"pins": 6, "satellites": 2, "ratio": 15},
    "load": {"output_torque_Nm": 4.05, "pin_circle_radius_mm": 24, "input_speed_rpm": 300},
    "contact": {
        "contact_length_mm": 5.0,
        "pin_radius_mm": 6.5,
        "eccentricity_mm": 1.5,
        "hole_clearance_mm": 0.0,
    },
    "rollers": {
        "kind": "ball",
        "bore_diameter_mm": 6.0,
        "dynamic_rating_N": 1080.0,
        "static_rating_N": 440.0,
        "rolling_elements": 8,
        "friction_coefficient": 0.0015,
    },
}
"""A printed drive of 15:1 with bearings 686 on its pins, as perfect parts."""


def having(body: dict[str, Any], **sections: Any) -> dict[str, Any]:
    """A body with other fields of its sections; a section of None is left out."""
    changed = {
        name: {**body.get(name, {}), **each} if isinstance(each, dict) else each
        for name, each in sections.items()
    }
    return {name: each for name, each in (body | changed).items() if each is not None}


async def test_the_section_says_what_is_known_by_hand(api):
    answer = await api.answer("crank-planetary", SMALL | {"include": ["rollers", "checks"]})
    found = answer["rollers"]
    for name, value in {
        "speed_rpm": 73.84615384615384,
        "peak_load_N": 56.25,
        "equivalent_load_N": 33.55125858523685,
        "dynamic_rating_as_roller_N": 815.737158933016,
        "static_rating_as_roller_N": 275.0,
        "life_h": 3243733.4417519434,
        "static_safety_factor": 4.888888888888889,
        "loss_W": 0.007476923314173188,
        "added_clearance_mm": 0.0,
    }.items():
        assert found[name] == pytest.approx(value, rel=8e-3), name
    assert answer["model"] == found["forces"] == "ideal"
    assert {each["code"] for each in found["warnings"]} == {
        "outer_ring_not_supported",
        "roller_clearance_unknown",
    }
    assert "tilt_mrad" not in found
    loose = having(SMALL, rollers={"radial_clearance_mm": 0.01}, include=["rollers"])
    found = (await api.answer("crank-planetary", loose))["rollers"]
    assert (found["forces"], found["added_clearance_mm"]) == ("real", 0.005)
    assert found["peak_load_N"] > 57


async def test_rollers_of_which_no_clearance_is_known_are_never_green(api):
    """At 15 N·m those with 0.04 mm are pressed beyond their static rating, those without hold."""
    hard = {"hole_material": "steel_case_hardened", "hole_clearance_mm": 0.0}
    whole = {"requirements": {"scope": ["contact"]}, "include": ["checks"]}
    body = having(SMALL, contact=hard, rollers={"width_mm": 5.0}) | whole
    verdicts = {}
    for clearance in (0.0, 0.04, None):
        loose = {} if clearance is None else {"radial_clearance_mm": clearance}
        own = having(body, rollers=loose)
        answer = await api.answer("crank-planetary", having(own, load={"output_torque_Nm": 15.0}))
        verdicts[clearance] = answer["verdict"]
    assert verdicts == {0.0: "pass", 0.04: "fail", None: "incomplete"}
    (part,) = (each for each in answer["parts"] if each["code"] == "contact")
    assert (part["reason"], part["missing"]) == (
        "roller_clearance_unknown",
        ["/rollers/radial_clearance_mm"],
    )
    assert "largest_torque_Nm" not in answer


async def test_a_name_says_what_is_not_typed(api):
    named = having(SMALL, rollers=None) | {"rollers": {"name": "686ZZ"}}
    answer = await api.answer("crank-planetary", named | {"include": ["rollers"]})
    told = {each["pointer"]: each["value"] for each in answer["assumed"]}
    assert {name: told[f"/rollers/{name}"] for name in ("kind", "dynamic_rating_N")} == {
        "kind": "ball",
        "dynamic_rating_N": 830,
    }
    assert told["/rollers/outer_diameter_mm"] == 13 and told["/rollers/width_mm"] == 5
    assert answer["rollers"]["dynamic_rating_as_roller_N"] == pytest.approx(0.6 * 830)
    typed = {"name": "686", "dynamic_rating_N": 1000, "rolling_elements": 8}
    answer = await api.answer("crank-planetary", named | {"rollers": typed, "include": ["rollers"]})
    assert answer["rollers"]["dynamic_rating_as_roller_N"] == pytest.approx(755.4, rel=1e-3)
    assert "/rollers/dynamic_rating_N" not in {each["pointer"] for each in answer["assumed"]}


async def test_needles_roll_on_pins_if_they_have_an_outer_ring(api):
    body = having(SMALL, rollers=None, contact={"pin_radius_mm": 11})
    body["rollers"] = {"name": "NA4900"}
    answer = await api.answer("crank-planetary", body | {"include": ["rollers"]})
    told = {each["pointer"]: each["value"] for each in answer["assumed"]}
    assert (told["/rollers/kind"], told["/rollers/outer_diameter_mm"]) == ("needle", 22)
    body["rollers"]["name"] = "HK1010"
    assert await api.refusal("crank-planetary", body) == ("/rollers/ratings", "drawn_cup")


async def test_bearings_of_satellites_and_shaft_have_names_too(api):
    body = SMALL | {
        "gear": {"radial_force_ratio": 0.3},
        "bearing": {"name": "6806"},
        "crankshaft": {
            "satellite_positions_mm": [10, 17],
            "bearing_positions_mm": [0, 27],
            "bearings": [{"name": "6803"}, {"kind": "ball", "dynamic_rating_N": 2000}],
        },
        "include": ["satellite_bearing", "crankshaft"],
    }
    answer = await api.answer("crank-planetary", body)
    told = {each["pointer"]: each["value"] for each in answer["assumed"]}
    assert told["/bearing/static_rating_N"] == 2900 and told["/bearing/bore_diameter_mm"] == 30
    assert told["/crankshaft/bearings/0/dynamic_rating_N"] == 1680
    assert not any(each.startswith("/crankshaft/bearings/1") for each in told)
    typed = body | {"bearing": {"kind": "ball", "dynamic_rating_N": 4490, "static_rating_N": 2900}}
    same = await api.answer("crank-planetary", typed)
    assert same["satellite_bearing"]["satellites"] == answer["satellite_bearing"]["satellites"]


async def test_the_table_of_bearings(api):
    rows = (await api.get("bearings")).json()["bearings"]
    assert [each["name"] for each in rows] == [*BEARINGS]
    (small,) = (each for each in rows if each["name"] == "MR105")
    assert (small["dynamic_rating_N"], small["static_rating_N"]) == (330, 140)
    assert max(each["dynamic_rating_N"] for each in small["makers"]) == 714
    assert all(each["source"] for row in rows for each in row["makers"])
    (cup,) = (each for each in rows if each["name"] == "HK1512")
    assert (cup["series"], cup["kind"], cup["elements"]) == ("HK", "roller", "needle")
    assert (cup["inner_ring"], cup["bore_diameter_mm"], cup["mass_kg"]) == (False, 15, 0.011)
    assert cup["mass_source"].startswith("SKF") and small["inner_ring"]


async def test_names_that_are_none_are_refused_with_those_that_are_like_them(api):
    body = having(SMALL, rollers=None) | {"rollers": {"name": "6884"}}
    (error,) = (await api.answer("crank-planetary", body, status=422))["errors"]
    assert (error["pointer"], error["code"]) == ("/rollers/name", "no_such_bearing")
    assert "688" in error["detail"] and "may be given instead" in error["detail"]
    bearing = SMALL | {"bearing": {"name": "7208"}}
    assert await api.refusal("crank-planetary", bearing) == ("/bearing/name", "no_such_bearing")
    assert await api.refusal("crank-planetary", SMALL | {"bearing": {}}) == (
        "/bearing/kind",
        "needed",
    )


async def test_what_contradicts_the_rollers_is_refused(api):
    cases = {
        ("/rollers/outer_diameter_mm", "only_one"): {"rollers": {"outer_diameter_mm": 14}},
        ("/rollers/ratings", "drawn_cup"): {"rollers": {"kind": "needle"}},
        ("/rollers/bore_diameter_mm", "smaller_than"): {"rollers": {"bore_diameter_mm": 13}},
        ("/friction/coefficient", "only_one"): {"friction": {"coefficient": 0.1}},
        ("/rollers/bore_diameter_mm", "needed"): {"rollers": None},
        ("/pin/diameter_mm", "only_one"): {
            "pin": {"diameter_mm": 5, "satellite_positions_mm": [4, 11]}
        },
    }
    for said, changes in cases.items():
        body = having(SMALL, **changes)
        if changes == {"rollers": None}:
            body["rollers"] = {"kind": "ball"}
        assert await api.refusal("crank-planetary", body) == said
    sleeves = having(
        SMALL,
        rollers={"friction_coefficient": 0.002},
        pin={"satellite_positions_mm": [4, 11]},
    )
    del sleeves["rollers"]["friction_coefficient"]
    sleeves["friction"] = {"coefficient": 0.1, "sleeve": True}
    assert await api.refusal("crank-planetary", sleeves) == ("/friction/sleeve", "only_one")


async def test_rollers_alone_are_friction_enough(api):
    losses = await api.answer("output-efficiency", SMALL)
    assert losses["mean_loss_W"] == pytest.approx(0.007476923, rel=SEARCHED)
    bare = having(SMALL, rollers=None)
    assert await api.refusal("output-efficiency", bare) == ("/friction", "missing")
    asked = SMALL | {"requirements": {"min_efficiency": 0.9}, "include": ["checks"]}
    answer = await api.answer(
        "crank-planetary", having(asked, rollers={"radial_clearance_mm": 0.0})
    )
    (part,) = (each for each in answer["parts"] if each["code"] == "losses")
    assert part["status"] == "pass"


async def test_hollow_standoffs_of_an_open_design(api):
    """178.3 N at 3.675 mm of a tube of 5/2.46 mm: 56.7 MPa."""
    body = {
        "mechanism": {"pins": 6, "satellites": 1, "ratio": 17},
        "load": {"output_torque_Nm": 8.8, "pin_circle_radius_mm": 32.9},
        "contact": {
            "contact_length_mm": 6.35,
            "pin_radius_mm": 2.5,
            "hole_radius_mm": 3.8,
            "eccentricity_mm": 1.3,
        },
        "pin": {
            "satellite_positions_mm": [3.675],
            "diameter_mm": 5,
            "bore_diameter_mm": 2.46,
            "material": "steel_s355",
        },
    }
    alone = having(body, pin={"contact_length_mm": 6.35}, contact=None)
    found = await api.answer("pin-strength", alone)
    assert found["peak_bending_stress_MPa"] == pytest.approx(56.7, abs=0.05)
    checks = (await api.answer("crank-planetary", body | {"include": ["checks"]}))["checks"]
    (wall,) = (each for each in checks if each["code"] == "pin_wall")
    assert wall["status"] == "pass" and wall["limit"] == pytest.approx(230)
    wide = having(body, pin={"bore_diameter_mm": 4.8})
    assert await api.refusal("crank-planetary", wide) == (
        "/pin/bore_diameter_mm",
        "less_than_equal",
    )


async def test_forces_and_pieces_have_the_play_of_the_rollers(api):
    """Forces and play equal those of a clearance larger by the rollers' play, without wrapping."""
    loose = having(
        SMALL,
        contact={"hole_clearance_mm": 0.02},
        rollers={"radial_clearance_mm": 0.01},
        contact_law={"kind": "linear", "stiffness_N_per_mm": 5e4},
    )
    loose["load"] = {"output_torque_Nm": 4.05, "pin_circle_radius_mm": 24}
    wider = having(loose, rollers=None, contact={"hole_clearance_mm": 0.025})
    asked = {"include": ["over_turn"]}
    found, same = [
        (await api.answer("load-sharing", body | asked))["over_turn"] for body in (loose, wider)
    ]
    for name in ("peak_force_N", "backlash_max_arcmin", "lost_motion_arcmin"):
        assert found[name] == pytest.approx(same[name], rel=SEARCHED), name
    whole = await api.answer("crank-planetary", loose | {"include": ["load_sharing"]})
    assert whole["load_sharing"]["peak_force_N"] == pytest.approx(found["peak_force_N"], rel=EXACT)
    drawn = {
        "tolerances": {"eccentricity_mm": 0.005},
        "samples": 100,
        "quantities": ["peak_force_N", "backlash_max_arcmin"],
    }
    study, other = [
        (await api.answer("tolerance-study", body | drawn))["quantities"] for body in (loose, wider)
    ]
    for name, values in study.items():
        assert values["mean"] == pytest.approx(other[name]["mean"], rel=SEARCHED), name
    unlike = having(loose, contact={"pin_radius_mm": 6.0}, rollers={"outer_diameter_mm": 13.0})
    assert await api.refusal("load-sharing", unlike) == ("/rollers/outer_diameter_mm", "only_one")
    thick = having(
        loose,
        pin={"support": "cantilever", "diameter_mm": 8.0, "satellite_positions_mm": [4.0, 11.0]},
    )
    assert await api.refusal("tolerance-study", thick | drawn) == ("/pin/diameter_mm", "only_one")
