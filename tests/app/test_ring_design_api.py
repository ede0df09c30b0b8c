"""The mesh of the ring in the design document over REST: what is refused, and that it is what
`/ring-mesh` answers.
"""

import math
from copy import deepcopy

import numpy as np
import plotly.graph_objects as go
import pytest

from app.calculations.crank_planetary import solve
from app.calculations.crank_planetary_sections import CrankPlanetaryRequest
from app.examples import REQUESTS
from core.checks.crank_planetary import CRANK_CHECKS
from core.checks.reserve import crank_verdict
from core.checks.usual_modification import usual_modification
from core.fixes.changes import Search
from core.fixes.crank import LOOKS
from core.precision import EXACT, JUDGED, SAME, SEARCHED
from core.ring.sharing import mesh_position
from tests.inputs.bodies import changed

pytestmark = pytest.mark.anyio

PATH = "crank-planetary"
ALONE = REQUESTS["ring-mesh"]
DESIGN = {
    "mechanism": {"pins": 6, **ALONE["mechanism"]},
    "load": {**ALONE["load"], "pin_circle_radius_mm": 32.0},
    "contact": {
        **ALONE["contact"],
        "pin_radius_mm": 5.0,
        "contact_length_mm": 12.0,
        "hole_clearance_mm": 0.02,
    },
    "gear": ALONE["gear"],
    "include": ["checks"],
}
"""The example of `/ring-mesh` with the pins of an output."""


@pytest.mark.slow
async def test_a_larger_modification_erases_no_check(api):
    """Public drive with 3.1 times the radius of its valleys: perfect discs have 141.5 MPa; with
    more play fewer pairs carry.
    """
    body = {
        "mechanism": {"pins": 6, "satellites": 2, "satellite_teeth": 20, "ring_teeth": 21},
        "load": {"input_torque_Nm": 0.4, "efficiency": 0.7, "pin_circle_radius_mm": 10.5},
        "contact": {
            "contact_length_mm": 4,
            "pin_radius_mm": 1.5,
            "hole_clearance_mm": 0.05,
            "eccentricity_mm": 0.75,
            "pin_material": "steel_bearing",
            "hole_material": "PLA",
        },
        "gear": {
            "kind": "cycloid",
            "ring_pin_circle_radius_mm": 18,
            "ring_pin_radius_mm": 1.5,
            "modification": {"equidistant_mm": 0.05},
        },
        "requirements": {"scope": ["contact"]},
        "include": ["checks"],
    }
    answer = (await api.post(PATH, json=body)).json()
    (cold,) = (each for each in answer["checks"] if each["code"] == "contact_static_cold")
    assert cold["value"] >= 141.5 and cold["limit"] < 40
    # By all that sources have of PLA it may hold; by the least it fails.
    assert (cold["status"], cold["reason"]["code"]) == ("marginal", "range_decides")
    body["contact"]["hole_material"] = {"name": "PLA", "yield_strength_MPa": 45}
    body |= {"friction": {"coefficient": 0.2}}
    answer = (await api.post(PATH, json=body)).json()
    (cold,) = (each for each in answer["checks"] if each["code"] == "contact_static_cold")
    assert cold["status"] == answer["verdict"] == "fail"


PRINTED = {
    "mechanism": {"pins": 3, "satellites": 1, "satellite_teeth": 20, "ring_teeth": 21},
    "load": {"output_torque_Nm": 11, "pin_circle_radius_mm": 25},
    "contact": {
        "contact_length_mm": 6,
        "pin_radius_mm": 4.5,
        "hole_clearance_mm": 0.1,
        "eccentricity_mm": 1.5,
        "hole_material": "PLA",
    },
    "gear": {
        "kind": "cycloid",
        "ring_pin_circle_radius_mm": 42,
        "ring_pin_radius_mm": 4.5,
        "modification": {"equidistant_mm": 0.1},
    },
    "requirements": {"scope": ["teeth"]},
}
"""A public printed drive."""


async def test_a_disc_at_the_limit_of_undercut_fails_by_it(api):
    """There a flank ends in a cusp, of which the curvature is no number."""
    body = changed(
        PRINTED,
        gear={"ring_pin_radius_mm": 6.156063925322055},
        rollers={"name": "MR95ZZ", "kind": "ball"},
        include=["checks"],
    )
    answer = (await api.post(PATH, json=body)).json()
    assert (answer["verdict"], answer["governing"]) == ("fail", "ring_undercut")
    checks = {each["code"]: each for each in answer["checks"]}
    assert checks["ring_static_cold"]["reason"]["code"] == "cannot_be"
    body["gear"] |= {"contact_length_mm": 6}
    ring = {name: body[name] for name in ("mechanism", "load", "contact", "gear")}
    ring["mechanism"] = {name: each for name, each in ring["mechanism"].items() if name != "pins"}
    ring["load"], ring["contact"] = {"output_torque_Nm": 11}, {"eccentricity_mm": 1.5}
    refused = await api.post("ring-mesh", json=ring)
    assert refused.json()["errors"][0]["code"] == "undercut"


def test_fixes_of_teeth_that_are_solved_take_few_looks(monkeypatch):
    """Secants solve for fixes, and for the reserve of a check."""
    looks = []

    def counted(self, **given):
        looks.append(given)
        return aimed(self, **given)

    aimed = Search.aimed
    monkeypatch.setattr(Search, "aimed", counted)
    body = changed(PRINTED, load={"output_torque_Nm": 5}, include=["fixes"])
    (fix,) = solve(CrankPlanetaryRequest.model_validate(body))["fixes"]
    assert (fix["pointer"], fix["status"]) == ("/load/output_torque_Nm", "solved")
    assert {each["check"].code for each in looks} == {"ring_static_cold"}
    assert 0 < len(looks) <= LOOKS * len(CRANK_CHECKS["ring_static_cold"].fixes)


def distance(points, polygon):
    """How far points are from a closed polygon."""
    sides, away = np.roll(polygon, -1) - polygon, points[:, None] - polygon
    along = np.clip((away / sides).real, 0, 1)
    return np.abs(away - along * sides).min(axis=1)


async def test_pins_of_the_ring_leave_those_of_the_output_alone(api):
    """Deviations of ring pins alone say nothing about the parts of the output."""
    perfect = {"contact": {"hole_clearance_mm": 0.0}, "satellite_coupling": {"kind": "rigid"}}
    made = {"deviations": {"ring_pin_radial_mm": [0.001] * 20}}
    for sections, model in ((made, "ideal"), ({"deviations": {}}, "real")):
        answer = (await api.post(PATH, json=changed(DESIGN, **perfect, **sections))).json()
        assert answer["model"] == model


async def test_the_discs_may_be_named_as_their_holes_are(api):
    named = {"gear": {"disc_material": "steel_through_hardened"}}
    assert (await api.post(PATH, json=changed(DESIGN, **named))).status_code == 200


RIGID = {"kind": "rigid"}
"""The ring by itself: discs that turn as one."""


async def test_the_mesh_is_what_its_endpoint_answers(api):
    """By default too; with the deviations of this piece in both."""
    off = [0.004, -0.003, 0.002, 0.0] * 5
    for deviations in (ALONE["deviations"], {"ring_pin_tangential_mm": off}):
        alone = {**ALONE, "deviations": deviations, "include": ["over_turn", "ideal"]}
        own = (await api.post("ring-mesh", json=alone)).json()
        body = changed(DESIGN, include=["ring_mesh"], satellite_coupling=RIGID)
        body |= {"deviations": deviations}
        answer = (await api.post(PATH, json=body)).json()
        found = answer["ring_mesh"]
        assert found["torque_direction"] == "driving"
        for name in ("geometry", "ideal", "over_turn", "efficiency"):
            assert found[name] == own[name], name
        assert found["accuracy"]["relative_error"] == own["accuracy"]["relative_error"]
    usual = changed(DESIGN)
    del usual["include"]
    answer = (await api.post(PATH, json=usual)).json()
    assert {"ring_mesh", "cyclogram", "load_sharing"} <= {*answer}
    materials = [each["pointer"] for each in answer["assumed"] if "material" in each["pointer"]]
    assert materials == ["/contact/pin_material", "/contact/hole_material", "/gear/pin_material"]


async def test_the_law_of_the_teeth_is_their_own(api):
    """A ring alone takes its law where the design has it, and names that place."""
    law = {"kind": "linear", "stiffness_N_per_mm": 1e5}
    alone = {**ALONE, "deviations": None, "include": ["over_turn"]}
    del alone["deviations"]
    stated = {**alone, "gear": {**alone["gear"], "contact_law": law}}
    own, usual = [(await api.post("ring-mesh", json=body)).json() for body in (stated, alone)]
    older = (await api.post("ring-mesh", json=alone | {"contact_law": law})).json()
    assert older["errors"][0]["code"] == "moved_to"
    assert older["errors"][0]["params"] == {"field": "gear.contact_law"}
    body = changed(
        DESIGN, include=["ring_mesh"], gear={"contact_law": law}, satellite_coupling=RIGID
    )
    design = (await api.post(PATH, json=body)).json()["ring_mesh"]
    assert design["over_turn"] == own["over_turn"] != usual["over_turn"]


OFF = {
    "ring_pin_radial_mm": [0.004, -0.003, 0.002, 0.0] * 5,
    "ring_pin_tangential_mm": [0.005, 0.0, -0.002, 0.003] * 5,
    "ring_pin_radius_mm": [0.001, 0.0, 0.002, -0.001] * 5,
}
UNEVEN = {"crank_angles_deg": [0.0, 100.0, 215.0], "satellites": 3, "initial_crank_angle_deg": 25.0}


@pytest.mark.parametrize(("deviations", "direction"), [({}, "driving"), (OFF, "reverse")])
def test_discs_stand_on_the_pins_as_they_are_drawn(monkeypatch, deviations, direction):
    """Put where the answer says, a fine outline is as far from each pin as its gap says, and turned
    by the lag; where they press it reaches into it.
    """
    monkeypatch.setattr("core.design.drawings.DRAWN_ERROR", 2e-8)
    body = changed(
        DESIGN,
        mechanism=UNEVEN,
        load={"torque_direction": direction},
        deviations=deviations,
        satellite_coupling=RIGID,
        include=["ring_drawing"],
    )
    request = CrankPlanetaryRequest.model_validate(body)
    drawn = solve(request)["ring_drawing"]
    turn = request.results.ring.working[0].turn
    lobe = np.array(drawn["lobe_mm"]) @ [1, 1j]
    outline = np.concatenate([lobe * np.exp(-2j * np.pi * i / 19) for i in range(19)])
    pins = np.array([each["centre_mm"] for each in drawn["ring_pins"]]) @ [1, 1j]
    radii = [each["radius_mm"] for each in drawn["ring_pins"]]
    angles, gaps, forces = (
        np.array(drawn[name]) for name in ("crank_angle_deg", "gap_mm", "force_N")
    )
    assert angles[0] == 0 and angles[-1] == 360 and (gaps[..., 0] == gaps[..., -1]).all()
    for i in (0, 1, len(angles) // 3, len(angles) - 2):
        phi = np.radians(angles[i])
        found = mesh_position(mesh=turn.real, crank_angle=phi, output_torque=turn.torque)
        assert forces[..., i] == pytest.approx(np.array(found.force), abs=1e-5 * forces.max())
        for j, alpha in enumerate(UNEVEN["crank_angles_deg"]):
            crank = 2j * np.exp(-1j * (phi + np.radians(25.0 + alpha)))
            turned = np.radians(drawn["turn_deg"][j]) + phi / 19 - found.rotation[j]
            far = distance(pins, outline * np.exp(1j * turned) + crank) - radii
            loaded = forces[j, :, i] > 0
            assert gaps[j, ~loaded, i] == pytest.approx(far[~loaded], abs=3e-4)
            assert (far[loaded] < 0).all() and not gaps[j, loaded, i].any() and loaded.any()
    assert gaps.max() > 0.02  # of which the tolerance above is little


async def test_what_cannot_be_drawn_is_left_out(api):
    """No outline of flanks that are turned, no more pairs than are drawn."""
    asked = {"include": ["ring_drawing", "ring_mesh"], "satellite_coupling": RIGID}
    turned = changed(DESIGN, gear={"modification": {"rotation_arcmin": 1.0}}, **asked)
    drawn = (await api.post(PATH, json=turned)).json()["ring_drawing"]
    assert "lobe_mm" not in drawn and len(drawn["force_N"][0]) == 20
    many = changed(DESIGN, mechanism={"satellites": 13}, **asked)
    answer = (await api.post(PATH, json=many)).json()
    assert "ring_drawing" not in answer and "ring_mesh" in answer


async def test_the_figure_is_of_the_peak(api):
    """Forces there over the pins, peak and lag over the turn, as `/ring-mesh` has them; the lag is
    that of the output.
    """
    body = changed(
        DESIGN, include=["ring_mesh"], mechanism={"output": "ring"}, satellite_coupling=RIGID
    )
    turn = (await api.post(PATH, json=body)).json()["ring_mesh"]["over_turn"]
    figure = (await api.post(f"{PATH}/chart", json=body)).json()
    go.Figure(data=figure["data"], layout=figure["layout"])
    of = {}
    for trace in figure["data"]:
        of.setdefault(trace.get("yaxis"), []).append(trace)
    angle, pair = turn["peak_crank_angle_deg"], turn["peak_pair"]
    alone = {**ALONE, "deviations": {}, "include": ["positions"], "crank_angle_deg": [angle]}
    pins = ALONE["load"]["output_torque_Nm"] * 19 / 20  # where the ring has it all
    alone["load"] = {**ALONE["load"], "output_torque_Nm": pins}
    (there,) = (await api.post("ring-mesh", json=alone)).json()["positions"]
    shown = [each for each in of["y"] if each["mode"] == "lines+markers"]
    for row, trace in zip(there["force_N"], shown, strict=True):
        assert trace["y"] == pytest.approx(row, rel=SEARCHED, abs=1e-3)
    most = shown[pair["satellite"] - 1]
    assert most["y"][pair["pin"] - 1] == pytest.approx(turn["peak_force_N"], rel=SEARCHED)
    for gap, force in zip(of["y2"], shown, strict=True):
        assert [value > 0 for value in gap["y"]] == [value == 0 for value in force["y"]]
    curve, peak = of["y3"]
    assert (*peak["x"], *peak["y"]) == (angle, turn["peak_force_N"])
    assert 0.99 * turn["peak_force_N"] < max(curve["y"]) <= turn["peak_force_N"] * (1 + 1e-6)
    (lag,) = of["y4"]
    ends = turn["lag_min_arcmin"], turn["lag_max_arcmin"]
    assert (min(lag["y"]), max(lag["y"])) == pytest.approx(ends, rel=1e-3)
    assert ends[1] < 0.96 * max(there["rotation_arcmin"])
    assert set(of) == {"y", "y2", "y3", "y4"}
    many = changed(DESIGN, mechanism={"satellites": 13}, include=["ring_mesh"])
    (error,) = (await api.post(f"{PATH}/chart", json=many)).json()["errors"]
    assert (error["pointer"], error["code"]) == ("/mechanism/ring_teeth", "too_many_pairs")


async def test_angles_are_those_of_the_output(api):
    """The ring turns by u/(u + 1) of what the pins would, and carries as much more."""
    pins = changed(DESIGN, include=["ring_mesh"], satellite_coupling=RIGID)
    ring = changed(
        DESIGN, include=["ring_mesh"], mechanism={"output": "ring"}, satellite_coupling=RIGID
    )
    ring["load"]["output_torque_Nm"] *= 20 / 19
    one, two = [(await api.post(PATH, json=body)).json()["ring_mesh"] for body in (pins, ring)]
    for name, part in (
        ("backlash_max_arcmin", 19 / 20),
        ("transmission_error_arcmin", 19 / 20),
        ("stiffness_min_Nm_per_arcmin", (20 / 19) ** 2),
        ("max_pressure_MPa", 1.0),
    ):
        assert two["over_turn"][name] == pytest.approx(part * one["over_turn"][name], rel=SEARCHED)


async def test_more_forces_than_are_solved_in_series_are_said(api):
    """Ring pins that deviate with 58 lobes need 58 turns of 59 pitches."""
    body = {
        "mechanism": {"pins": 8, "satellites": 2, "ratio": 58},
        "load": {"output_torque_Nm": 50, "pin_circle_radius_mm": 30},
        "contact": {
            "contact_length_mm": 10,
            "pin_radius_mm": 4,
            "eccentricity_mm": 0.7,
            "hole_clearance_mm": 0.02,
        },
        "gear": {
            "kind": "cycloid",
            "ring_pin_circle_radius_mm": 60,
            "ring_pin_radius_mm": 1.5,
            "modification": {"equidistant_mm": 0.02},
        },
        "include": ["contact_force"],
    }
    lists = {"ring_pin_radial_mm": [0.001, 0.0] * 29 + [0.0]}
    answer = (await api.post(PATH, json=body | {"deviations": lists})).json()
    (said,) = [each for each in answer["warnings"] if each["code"] == "meshes_apart"]
    assert said["params"] == {"forces": 58 * 59 * 2 * (8 + 59), "limit": 250_000}
    alike = (await api.post(PATH, json=body)).json()
    assert "meshes_apart" not in {each["code"] for each in alike.get("warnings", ())}


@pytest.mark.parametrize("off", [None, [0.004, -0.003, 0.002, 0.0, 0.001] * 4])
async def test_both_meshes_are_in_series_where_both_are_known(api, off):
    """Numbers of `/load-sharing` at places of its own: over the turn, and of the cranks."""
    made = {} if off is None else {"deviations": {"ring_pin_radial_mm": off}}
    body = changed(
        DESIGN,
        include=["load_sharing", "satellite_bearing", "ring_mesh"],
        bearing={"kind": "roller", "dynamic_rating_N": 30000.0},
        load={"input_speed_rpm": 1000.0},
        **made,
    )
    answer = (await api.post(PATH, json=body)).json()
    if off is None:
        stated = {**body, "satellite_coupling": {"kind": "ring"}}
        assert (await api.post(PATH, json=stated)).json()["load_sharing"]["peak_force_N"] == (
            answer["load_sharing"]["peak_force_N"]
        )
    assert "ring" in answer["load_sharing"]
    named = ("mechanism", "load", "contact", "gear", "deviations")
    alone = {name: {**body[name]} for name in named if name in body}
    for name in ("friction_coefficient", "disc_material"):
        alone["gear"].pop(name, None)
    del alone["load"]["input_speed_rpm"]
    turns = 9 if off else 1
    count = 60 * turns
    angles = [360.0 * turns * k / count + 0.1 for k in range(count)]
    alone |= {"satellite_coupling": {"kind": "ring"}, "include": ["over_turn"]}
    whole = (await api.post("load-sharing", json=alone)).json()["over_turn"]
    made = answer["load_sharing"]
    for name in (
        "peak_force_N",
        "backlash_max_arcmin",
        "lost_motion_arcmin",
        "transmission_error_arcmin",
        "stiffness_min_Nm_per_arcmin",
    ):
        assert made[name] == pytest.approx(whole[name], rel=EXACT), name
    teeth = answer["ring_mesh"]["over_turn"]
    for name in ("peak_force_N", "max_pressure_MPa"):
        assert made["ring"][name] == pytest.approx(whole["ring"][name], rel=EXACT)
        assert teeth[name] == made["ring"][name]
    alone |= {"include": ["positions"], "crank_angle_deg": angles[:: max(1, turns // 2)]}
    found = (await api.post("load-sharing", json=alone)).json()["positions"]
    discs, bearing = [each["ring"] for each in found], answer["satellite_bearing"]
    for j, own in enumerate(bearing["satellites"]):
        load = max(each["crank_load_N"][j] for each in discs)
        assert load * (1 - 1e-4) <= own["peak_load_N"] <= load * 1.05
        ring = max(
            math.hypot(each["crank_across_N"][j], each["crank_along_N"][j]) for each in discs
        )
        assert ring * (1 - 1e-4) <= own["peak_ring_force_N"] <= ring * 1.05
    along, across = (
        sum(sum(each[f"crank_{way}_N"]) for each in discs) for way in ("along", "across")
    )
    assert bearing["radial_force_ratio"] == pytest.approx(along / across, abs=5e-3)


async def test_the_ring_is_told_as_it_works_in_series(api, monkeypatch):
    """Section, drawing, figure and checks by positions of `/load-sharing`: later turns too, gaps by
    the outline that is drawn.
    """
    asked = {"max_ring_backlash_arcmin": 50.0, "max_transmission_error_arcmin": 50.0}
    sections = ["load_sharing", "ring_mesh", "ring_drawing", "checks"]
    body = changed(DESIGN, include=sections, requirements=asked)
    monkeypatch.setattr("core.design.drawings.DRAWN_ERROR", 2e-8)
    answer = solve(CrankPlanetaryRequest.model_validate(body))
    drawn, turn = answer["ring_drawing"], answer["ring_mesh"]["over_turn"]
    angles, period, further = (
        drawn[name] for name in ("crank_angle_deg", "repeats_after_deg", "pins_further")
    )
    assert angles[-1] == pytest.approx(period) and 0 < further < 20
    shown = (*range(0, len(angles), 17), 1, 2)
    later = [4 * each % 9 for each in range(len(shown))]
    at = [angles[i] + n * period for i, n in zip(shown, later, strict=True)]
    alone = {name: deepcopy(body[name]) for name in ("mechanism", "load", "contact", "gear")}
    for name in ("friction_coefficient", "disc_material"):
        alone["gear"].pop(name, None)
    alone["load"].pop("input_speed_rpm", None)
    alone |= {"satellite_coupling": {"kind": "ring"}, "include": ["positions"]}

    async def positions(crank_angles):
        asked = {**alone, "crank_angle_deg": crank_angles}
        got = await api.post("load-sharing", json=asked)
        assert got.status_code == 200, got.text
        return got.json()["positions"]

    found = await positions(at)
    lags = np.array([each["ring"]["rotation_arcmin"] for each in found])
    forces, gaps = np.array(drawn["force_N"]), np.array(drawn["gap_mm"])
    pins = np.array([each["centre_mm"] for each in drawn["ring_pins"]]) @ [1, 1j]
    lobe = np.array(drawn["lobe_mm"]) @ [1, 1j]
    outline = np.concatenate([lobe * np.exp(-2j * math.pi * each / 19) for each in range(19)])
    for i, n, angle, there in zip(shown, later, at, found, strict=True):
        force = np.array(there["ring"]["force_N"])
        on = np.roll(forces[..., i], -n * further, axis=1)
        assert on == pytest.approx(force, abs=1e-4 * force.max())
        left = np.roll(gaps[..., i], -n * further, axis=1)
        for j, lag in enumerate(there["ring"]["rotation_arcmin"]):
            turned = np.radians(drawn["turn_deg"][j] + angle / 19 - lag / 60)
            crank = np.radians(angle + 360 * j / len(force))
            e = body["contact"]["eccentricity_mm"]
            disc = outline * np.exp(1j * turned) + 1j * e * np.exp(-1j * crank)
            far = distance(pins, disc) - body["gear"]["ring_pin_radius_mm"]
            free = force[j] == 0
            assert left[j, free] == pytest.approx(far[free], abs=3e-4)
            assert not left[j, ~free].any() and free.any()
    # From the least to the largest lag of all angles, which the positions of the turn miss by
    # less than is said.
    ends, step = [], period / 60
    even = await positions([step * k for k in range(60)])
    for best in (np.min, np.max):
        held = {step * k: best(each["ring"]["rotation_arcmin"]) for k, each in enumerate(even)}
        for wide in (step, step / 6, step / 36):
            place = max(held, key=lambda angle: held[angle] if best is np.max else -held[angle])
            near = [place + wide * k / 6 for k in range(-5, 6)]
            held |= {
                angle: best(each["ring"]["rotation_arcmin"])
                for angle, each in zip(near, await positions(near), strict=True)
            }
        ends.append(float(best(list(held.values()))))
    low, high = turn["lag_min_arcmin"], turn["lag_max_arcmin"]
    assert ends == pytest.approx([low, high], rel=10 * JUDGED)  # of places that were solved
    assert ends[0] <= lags.min() and low - ends[0] >= -JUDGED * low
    assert ends[1] >= lags.max() and ends[1] - high >= -JUDGED * high
    assert ends[1] - ends[0] == pytest.approx(high - low, rel=0.02)
    whole = {"backlash_max_arcmin", "transmission_error_arcmin", "stiffness_min_Nm_per_arcmin"}
    assert not whole & {*turn} and whole < {*answer["load_sharing"]}
    checks = {each["code"]: each for each in answer["checks"]}
    error, play = checks["ring_transmission_error"], checks["ring_backlash"]
    both = answer["load_sharing"]["transmission_error_arcmin"]
    assert error["value"] == pytest.approx(both, rel=EXACT)
    most = max(high - low for each in found for low, high in each["ring"]["play_arcmin"])
    assert most <= play["value"] <= most * 1.05
    said = [each["reason"]["code"] for each in (error, play, checks["ring_pressed"])]
    assert said == ["both_meshes", "ring_alone", "ring_alone"]
    figure = (await api.post(f"{PATH}/chart", json={**body, "include": ["ring_mesh"]})).json()
    go.Figure(data=figure["data"], layout=figure["layout"])
    of = {}
    for trace in figure["data"]:
        of.setdefault(trace.get("yaxis"), []).append(trace)
    x = of["y4"][0]["x"]
    one, peak = await positions([x[100], turn["peak_crank_angle_deg"]])
    assert [each["y"][100] for each in of["y4"]] == pytest.approx(
        [one["rotation_arcmin"], *one["ring"]["rotation_arcmin"]], rel=JUDGED
    )
    carried = [each for each in of["y"] if each["mode"] == "lines+markers"]
    for row, trace in zip(peak["ring"]["force_N"], carried, strict=True):
        assert trace["y"] == pytest.approx(row, rel=JUDGED, abs=1e-2)


async def test_discs_that_the_pins_let_turn_apart_do_not_press_in_their_ring(api):
    """Each lies in the ring as its own phase has it: only discs that turn as one would press."""
    apart = {"deviations": {"disc_phase_deg": [4 / 60, -4 / 60]}}
    room = {"contact": {"hole_clearance_mm": 0.05}, "requirements": {"max_ring_backlash_arcmin": 9}}
    found = {}
    for name, coupling in (("series", {"kind": "ring"}), ("rigid", RIGID)):
        body = changed(DESIGN, satellite_coupling=coupling, **room, **apart)
        answer = (await api.post(PATH, json=body)).json()
        checks = {each["code"]: each for each in answer["checks"]}
        found[name] = [checks[code] for code in ("ring_pressed", "ring_backlash")]
    assert [each["status"] for each in found["series"]] == ["pass", "pass"]
    assert found["series"][1]["value"] > 1.0
    assert (found["rigid"][0]["status"], found["rigid"][1]["value"]) == ("fail", 0.0)


@pytest.mark.parametrize(
    ("sections", "solved"),
    [
        ({"satellite_coupling": {"kind": "rigid"}}, True),
        ({"satellite_coupling": {"kind": "elastic", "stiffness_Nm_per_arcmin": 50.0}}, True),
        (
            {"crank_support": {"stiffness_N_per_mm": 1e5}, "satellite_coupling": {"kind": "rigid"}},
            True,
        ),
        ({"contact": {"hole_clearance_mm": None}}, False),
        ({"gear": {"modification": None}}, False),
        ({"contact": {"hole_clearance_mm": 0.0, "distribution_factor": 1.2}}, False),
    ],
)
async def test_what_is_stated_or_not_known_leaves_them_apart(api, sections, solved):
    """Bearings then have the mean ratio of the ring's forces, or the ideal one."""
    body = changed(
        DESIGN,
        include=["satellite_bearing", *["ring_mesh"] * solved],
        bearing={"kind": "roller", "dynamic_rating_N": 30000.0},
        load={"input_speed_rpm": 1000.0},
        **{name: value for name, value in sections.items() if name != "load"},
    )
    answer = (await api.post(PATH, json=body)).json()
    size = body["gear"]
    k1 = 20 * body["contact"]["eccentricity_mm"] / size["ring_pin_circle_radius_mm"]
    ideal = -(2 - (1 - k1**2) / k1 * math.log((1 + k1) / (1 - k1))) / (math.pi * k1)
    found = answer["satellite_bearing"]["radial_force_ratio"]
    if solved:
        turn = answer["ring_mesh"]["over_turn"]
        ends = [turn[f"radial_force_ratio_{end}"] for end in ("min", "max")]
        assert ideal < ends[0] < found < ends[1]
    else:
        assert found == pytest.approx(ideal, rel=EXACT)


async def test_what_is_not_known_of_the_teeth_is_said(api):
    alone = {"scope": ["teeth"]}
    for sections, assumes, reason in (
        ({"gear": {"modification": None}}, False, "modification_unknown"),
        ({}, True, None),
        ({"tolerances": {"ring_pin_position_mm": 0.004}}, False, None),
        ({"deviations": {"ring_pin_radius_mm": [0.0] * 20}}, False, None),
    ):
        answer = (await api.post(PATH, json=changed(DESIGN, requirements=alone, **sections))).json()
        assumed = {each["pointer"] for each in answer["assumed"]}
        assert ("/tolerances/ring_pin_position_mm" in assumed) == assumes
        (teeth,) = (each for each in answer["parts"] if each["code"] == "teeth")
        assert teeth.get("reason") == reason
        assert (teeth["status"] == "open") == (reason is not None)
    named = changed(DESIGN, include=["ring_mesh"], gear={"modification": None})
    (error,) = (await api.post(PATH, json=named)).json()["errors"]
    assert (error["pointer"], error["code"]) == ("/gear/modification", "needed_for")


async def test_teeth_are_cured_by_what_they_are_judged_by(api):
    """A fix, reposted, holds."""
    asked = {"requirements": {"scope": ["teeth"]}, "include": ["checks", "fixes"]}
    body = changed(DESIGN, **asked, satellite_coupling=RIGID)
    body["load"]["output_torque_Nm"] = 150.0
    answer = (await api.post(PATH, json=body)).json()
    body["gear"] = {**body["gear"], "contact_length_mm": 12.0}
    fix = next(each for each in answer["fixes"] if each["pointer"] == "/gear/contact_length_mm")
    assert (answer["verdict"], fix["verdict"]) == ("fail", "marginal")
    body["gear"]["contact_length_mm"] = fix["to"]
    cured = (await api.post(PATH, json=body)).json()
    assert (cured["verdict"], cured["governing"]) == ("marginal", "ring_pieces")
    checks = {each["code"]: each["status"] for each in cured["checks"]}
    assert checks["ring_pressure_disc"] == "pass"


async def test_a_usual_ring_is_answered_where_it_is_asked(api):
    """In the units of the answer; of the ring as output with its angles; not where all is known."""
    include = ["usual_modification", "largest_torque"]
    body = changed(DESIGN, include=include, requirements={"scope": ["teeth"]})
    body["gear"].pop("modification")
    body["gear"] |= {"ring_class": "machined"}
    body["load"]["output_torque_Nm"] = 10.0
    body.pop("deviations", None)
    found = (await api.post(PATH, json=body)).json()["usual_modification"]
    request = CrankPlanetaryRequest.model_validate(body)
    usual = usual_modification(request.design)
    assert (found["class"], found["samples"], found["crank_angles"]) == ("machined", 64, 720)
    sizes = [found["equidistant_mm"], found["pin_zone_diameter_mm"]]
    assert sizes == pytest.approx([0.03, 0.05])
    for name, spread, unit in (
        ("peak_force_N", usual.peak_force, 1),
        ("max_pressure_MPa", usual.max_pressure, 1e-6),
        ("backlash_arcmin", usual.backlash, 60 * 180 / math.pi),
    ):
        assert [found[name][key] for key in ("median", "percent_90")] == pytest.approx(
            [each * unit for each in spread], rel=SAME
        )
    assert found["cannot_assemble"] == 0
    assert found["verdict"] == usual.verdict.verdict
    torque = (
        body["load"]["output_torque_Nm"] * crank_verdict(usual.results, largest=True).torque_reserve
    )
    assert found["largest_torque_Nm"] == pytest.approx(torque, rel=SAME)
    ring = deepcopy(body) | {"include": ["usual_modification"]}
    ring["mechanism"]["output"] = "ring"
    ring["load"]["output_torque_Nm"] *= 20 / 19
    turned = (await api.post(PATH, json=ring)).json()["usual_modification"]
    parts = [each["backlash_arcmin"]["median"] for each in (turned, found)]
    assert parts[0] / parts[1] == pytest.approx(19 / 20, rel=EXACT)
    body["gear"]["modification"] = {"equidistant_mm": 0.03}
    body["deviations"] = {"ring_pin_radial_mm": [0.0] * 20}
    assert "usual_modification" not in (await api.post(PATH, json=body)).json()
