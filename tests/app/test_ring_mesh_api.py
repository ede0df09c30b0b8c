"""The mesh of satellites with their ring over REST: cycloid discs on pins and involute teeth,
sections, limits, refusals, figures.
"""

from copy import deepcopy

import numpy as np
import plotly.graph_objects as go
import pytest

from app.examples import REQUESTS
from core.precision import EXACT, SAME, SEARCHED
from tests.inputs.bodies import changed
from tests.inputs.involute import CASES as INVOLUTE

pytestmark = pytest.mark.anyio

PATH = "ring-mesh"
BASE = {**REQUESTS[PATH], "include": ["positions"]}


ROUND = INVOLUTE[1]["body"]
"""Involute teeth, 40 in 42, with some backlash."""


def rounded(**sections):
    body = deepcopy(ROUND)
    for name, value in sections.items():
        body[name] = body.get(name, {}) | value if isinstance(value, dict) else value
    return body


async def test_where_a_step_of_the_torque_is_not_reached_forces_are_found(api):
    """Usual steel drive; forces over the turn are no smaller than at its positions."""
    body = {
        "mechanism": {"satellite_teeth": 20, "ring_teeth": 21, "satellites": 1},
        "load": {"output_torque_Nm": 10.0},
        "contact": {"eccentricity_mm": 1.5},
        "gear": {
            "kind": "cycloid",
            "ring_pin_circle_radius_mm": 45.0,
            "ring_pin_radius_mm": 3.0,
            "contact_length_mm": 10.0,
            "modification": {"equidistant_mm": 0.01},
        },
        "crank_angle_deg": [float(np.rad2deg(0.2821021974652059)), *np.linspace(0, 18, 361)],
        "include": ["positions", "over_turn"],
    }
    answer = await api.post(PATH, json=body)
    assert answer.status_code == 200, answer.text
    found = answer.json()
    forces = [max(map(max, each["force_N"])) for each in found["positions"]]
    assert found["over_turn"]["peak_force_N"] == pytest.approx(max(forces), rel=1e-3)
    assert [each["disc_torque_Nm"] for each in found["positions"]] == [
        pytest.approx([10.0]) for _ in forces
    ]


async def test_all_sections(api):
    body = changed(
        BASE,
        include=["positions", "over_turn", "profile", "stiffness_curve", "ideal"],
        chord_error_mm=0.02,
    )
    answer = (await api.post(PATH, json=body)).json()
    turn, position = answer["over_turn"], answer["positions"][0]
    assert turn["peak_force_N"] >= max(map(max, position["force_N"]))
    ideal = answer["ideal"]
    assert turn["peak_force_ratio"] == pytest.approx(turn["peak_force_N"] / ideal["peak_force_N"])
    assert ideal["peak_force_N"] == pytest.approx(4 * 150 / (2e-3 * 19 * 20))
    assert ideal["radial_force_ratio"] < 0 < ideal["backlash_arcmin"]
    assert turn["lag_min_arcmin"] < position["rotation_arcmin"][0] < turn["lag_max_arcmin"]
    assert turn["radial_force_ratio_min"] < turn["radial_force_ratio_max"]
    lags = answer["stiffness_curve"]["rotation_arcmin"]
    assert lags == sorted(lags) and lags[-1] == pytest.approx(position["rotation_arcmin"][0])
    loss = answer["efficiency"]
    assert loss["efficiency"] == pytest.approx(1 / (1 + 0.06 * loss["loss_per_friction"]))
    power = 300 * 1500 / 19 * np.pi / 30
    assert loss["mean_loss_W"] == pytest.approx(loss["loss_ratio"] * power)
    assert loss["peak_pv_MPa_m_per_s"] > 0 < position["sliding_speed_m_per_s"]
    profile = answer["profile"]
    points = np.array(profile["points"])
    assert profile["closed"] is True and profile["chord_error_mm"] <= 0.02
    assert len(points) % 19 == 0
    assert points[0] == pytest.approx([0, answer["geometry"]["root_radius_mm"]], abs=1e-12)
    assert points[1][0] > 0  # clockwise
    largest = np.hypot(*points.T).max()
    assert largest == pytest.approx(answer["geometry"]["tip_radius_mm"], abs=0.02)
    assert {each["code"] for each in answer.get("warnings", ())} == set()


async def test_the_geometry_alone(api):
    answer = (await api.post(PATH, json=changed(BASE, include=["profile"]))).json()
    assert set(answer) == {"kind", "geometry", "profile", "accuracy", "assumed"}
    assumed = {each["pointer"] for each in answer["assumed"]}
    assert assumed == {"/gear/pin_material", "/contact/hole_material"}


async def test_what_is_not_known_is_said(api):
    body = changed(BASE, gear__modification=None, gear__seat_stiffness_N_per_mm=None)
    del body["deviations"]
    answer = (await api.post(PATH, json=body)).json()
    codes = [each["code"] for each in answer["warnings"]]
    assert codes == ["modification_unknown", "seat_rigid"]
    in_series = body | {"satellite_coupling": {"kind": "ring"}}
    assert (await api.post(PATH, json=in_series)).json()["warnings"] == answer["warnings"]
    stated = changed(BASE, gear=BASE["gear"] | {"modification": {}})
    del stated["deviations"]
    answer = (await api.post(PATH, json=stated)).json()
    assert "warnings" not in answer


async def test_output_pins_do_not_matter_to_the_ring(api):
    touching = {"pin_radius_mm": 5, "distribution_factor": 1.2}
    alone, whole = changed(BASE), changed(BASE, contact=touching, mechanism={"pins": 8})
    del alone["deviations"], whole["deviations"]
    answer = (await api.post(PATH, json=whole)).json()
    assert answer["positions"] == (await api.post(PATH, json=alone)).json()["positions"]


async def test_bent_pins_and_sleeves(api):
    held = {"pin_support": "fixed", "span_mm": 40, "satellite_positions_mm": [12, 28]}
    gear = BASE["gear"] | held
    stiff, soft = [
        (await api.post(PATH, json=changed(BASE, gear=each))).json()["positions"][0]
        for each in (BASE["gear"], gear)
    ]
    assert soft["stiffness_Nm_per_arcmin"] < stiff["stiffness_Nm_per_arcmin"]
    sleeved = changed(BASE, gear=gear | {"sleeve_bore_radius_mm": 3.0})
    thin = (await api.post(PATH, json=sleeved)).json()["positions"][0]
    assert thin["stiffness_Nm_per_arcmin"] < soft["stiffness_Nm_per_arcmin"]


async def test_reverse_and_rotation(api):
    body = changed(BASE, load={"torque_direction": "reverse"})
    answer = (await api.post(PATH, json=body)).json()["positions"][0]
    assert max(answer["rotation_arcmin"]) < 0 > sum(answer["disc_torque_Nm"])
    gear = BASE["gear"] | {"modification": {"equidistant_mm": 0.02, "rotation_arcmin": 1.0}}
    turned = changed(BASE, gear=gear, include=["positions", "ideal"])
    plain = deepcopy(turned)
    del plain["gear"]["modification"]["rotation_arcmin"]
    more, less = [(await api.post(PATH, json=each)).json() for each in (turned, plain)]
    wider = more["ideal"]["backlash_arcmin"] - less["ideal"]["backlash_arcmin"]
    assert wider == pytest.approx(2, rel=EXACT)
    plays = [np.ptp(each["positions"][0]["play_arcmin"]) for each in (more, less)]
    assert plays[0] - plays[1] == pytest.approx(2, rel=2e-3)  # as wide to squares of the gap


@pytest.mark.slow
async def test_limits_are_in_the_units_of_their_fields(api):
    body = changed(BASE, gear={"ring_pin_radius_mm": 14.0})
    error = (await api.post(PATH, json=body)).json()["errors"][0]
    limit = error["params"]["limit"]
    assert 5 < limit < 14
    near = changed(BASE, gear={"ring_pin_radius_mm": limit * (1 - 1e-8)})
    assert (await api.post(PATH, json=near)).status_code == 200
    fine = changed(BASE, include=["profile"], chord_error_mm=1e-10)
    limit = (await api.post(PATH, json=fine)).json()["errors"][0]["params"]["limit"]
    answer = await api.post(PATH, json=changed(BASE, include=["profile"], chord_error_mm=limit))
    assert answer.status_code == 200
    assert 190_000 < len(answer.json()["profile"]["points"]) <= 200_000


async def test_what_takes_too_long_is_refused(api):
    teeth = {"satellite_teeth": 599, "ring_teeth": 600}
    gear = BASE["gear"] | {"ring_pin_circle_radius_mm": 2000.0}
    body = changed(BASE, mechanism=teeth, gear=gear, include=["over_turn"])
    error = (await api.post(PATH, json=body)).json()["errors"][0]
    assert (error["pointer"], error["code"]) == ("/mechanism/ring_teeth", "too_many_pairs")
    assert error["params"] == {"limit": 500, "satellites": 2}


async def test_a_ring_of_more_than_a_hundred_metres_is_refused_at_once(api):
    """Calculating its turn would take half a minute."""
    design = {"mechanism": BASE["mechanism"] | {"pins": 6}, "gear": {"kind": "cycloid"}}
    for path, body in ((PATH, deepcopy(BASE)), ("crank-planetary", design)):
        for name in ("ring_pin_circle_radius_mm", "ring_pin_radius_mm"):
            body["gear"] = body["gear"] | {name: 1e12}
            errors = (await api.post(path, json=body)).json()["errors"]
            (error,) = (each for each in errors if each["pointer"].endswith(name))
            assert error["code"] == "less_than_equal" and error["params"] == {"limit": 1e5}


async def test_nothing_happens_where_pins_stand_off_a_valley(api):
    """Public design whose valleys have a radius of 0.015214 mm."""
    gear = {
        "kind": "cycloid",
        "ring_pin_circle_radius_mm": 26.5,
        "ring_pin_radius_mm": 1.5,
        "contact_length_mm": 4.0,
    }
    teeth = {"satellites": 1, "satellite_teeth": 30, "ring_teeth": 31}
    body = {
        "mechanism": teeth,
        "load": {"output_torque_Nm": 2.6},
        "contact": {"eccentricity_mm": 0.75},
    }
    peaks = []
    for gap in (0.0152, 0.01523, 0.02):
        own = gear | {"modification": {"equidistant_mm": gap}}
        answer = await api.post(PATH, json=body | {"gear": own})
        assert answer.status_code == 200
        (position,) = answer.json()["positions"]
        peaks.append(max(map(max, position["force_N"])))
        codes = [each["code"] for each in answer.json().get("warnings", [])]
        assert "valley" not in codes
    assert peaks[1] == pytest.approx(peaks[0], rel=1e-3)
    assert peaks[0] < peaks[2] < 1.1 * peaks[0]


@pytest.mark.parametrize("theme", ["light", "dark"])
async def test_the_figure_shows_the_answer(api, theme):
    figure = (await api.post(f"{PATH}/chart?theme={theme}", json=BASE)).json()
    go.Figure(data=figure["data"], layout=figure["layout"])
    answer = (await api.post(PATH, json=BASE | {"include": ["positions", "over_turn"]})).json()
    force = answer["positions"][0]["force_N"]
    shown = [each for each in figure["data"] if each.get("mode") == "lines+markers"]
    for row, trace in zip(force, shown, strict=False):
        assert trace["y"] == pytest.approx(row, rel=1e-4, abs=1e-9)
    most = next(each for each in figure["data"] if each.get("yaxis") == "y3")
    peak = answer["over_turn"]["peak_force_N"]
    assert 0.9 * peak < max(most["y"]) <= peak * (1 + 1e-9)
    many = changed(BASE, mechanism={"satellite_teeth": 199, "ring_teeth": 200})
    error = (await api.post(f"{PATH}/chart", json=many)).json()["errors"][0]
    assert (error["pointer"], error["code"]) == ("/mechanism/ring_teeth", "too_many_pairs")


async def test_sections_that_a_ring_alone_does_not_use_are_listed(api):
    plain = (await api.post(PATH, json=BASE)).json()
    pin = {"satellite_positions_mm": [10.0, 30.0], "diameter_mm": 8.0, "material": "steel_bearing"}
    more = {"pin": pin, "friction": {"coefficient": 0.1}, "temperatures": {"pins_C": 40}}
    answer = (await api.post(PATH, json=BASE | more)).json()
    assert answer.pop("not_used") == ["pin", "friction", "temperatures"]
    assert "not_used" not in plain
    assert answer["positions"] == plain["positions"]


@pytest.mark.parametrize("case", INVOLUTE, ids=lambda case: case["name"])
async def test_involute_case(api, case):
    gear = {"satellite_material": "steel_structural"} | case["body"]["gear"]
    answer = (await api.post(PATH, json=case["body"] | {"gear": gear})).json()
    assert answer["kind"] == "involute"
    stresses, held = answer["stresses"], dict(case["expect"]["stresses"])
    root = held.pop("root")
    for found, expected in (
        (answer["geometry"], case["expect"]["geometry"]),
        (stresses, held),
        (stresses["root"], root),
    ):
        for name, value in expected.items():
            near = pytest.approx(value, rel=case["rtol"], abs=1e-12)
            assert found[name] == (value if isinstance(value, bool) else near), name
    assert set(answer) - {"warnings"} == {"kind", "geometry", "stresses", "accuracy", "assumed"}
    codes = [each["code"] for each in answer.get("warnings", ())]
    assert codes == (["path_short", "off_involutes"] if case["name"] == "B6" else [])


async def test_stresses_are_at_the_application_factor_and_forces_at_the_torque(api):
    plain = (await api.post(PATH, json=ROUND)).json()["stresses"]
    body = rounded(load={"application_factor": 1.5}, gear={"face_load_factor": 1.2})
    more = (await api.post(PATH, json=body)).json()["stresses"]
    for name, power in (
        ("pressure_one_pair_start_MPa", 0.5),
        ("iso_pressure_at_pitch_point_MPa", 0.5),
        ("normal_force_N", 0),
    ):
        assert more[name] == pytest.approx(plain[name] * 1.8**power, rel=SAME)
    stress = "root_stress_one_pair_MPa"
    assert more["root"][stress] == pytest.approx(1.8 * plain["root"][stress], rel=SAME)
    two = (await api.post(PATH, json=rounded(mechanism={"satellites": 2}))).json()["stresses"]
    assert two["normal_force_N"] == pytest.approx(plain["normal_force_N"] / 2, rel=SAME)


async def test_pairs_that_carry_and_the_loss_are_answered_where_they_are_asked_for(api):
    body = rounded(gear={"friction_coefficient": 0.06}, load={"input_speed_rpm": 1500.0})
    answer = (await api.post(PATH, json=body | {"include": ["stresses", "shared_pairs"]})).json()
    loss, line = answer["efficiency"], answer["geometry"]
    pitch = np.tan(np.radians(line["operating_pressure_angle_deg"]))
    end = (line["end_roll_ring"] * 42 - 2 * pitch) / 40
    middle = (
        pitch - (line["start_roll_satellite"] + end) / 2
    )  # the path ends before the pitch point
    assert loss["loss_per_friction"] == pytest.approx(middle, rel=EXACT)
    assert loss["efficiency"] == pytest.approx(1 / (1 + 0.06 * middle), rel=SAME)
    power = 300 * 1500 * np.pi / 30 * 2 / 40
    assert loss["mean_loss_W"] == pytest.approx(0.06 * middle * power, rel=EXACT)
    shared = answer["shared_pairs"]
    assert (shared["loaded_pairs_min"], shared["loaded_pairs_max"]) == (2, 3)
    assert shared["largest_share"] == pytest.approx(0.51, abs=0.01)
    only = (await api.post(PATH, json=body | {"include": ["shared_pairs"]})).json()
    assert not {"stresses", "efficiency"} & {*only}
    soft = rounded(gear={"pair_stiffness_N_per_mm": 1e9}, include=["shared_pairs"])
    assert (await api.post(PATH, json=soft)).json()["shared_pairs"]["loaded_pairs_min"] == 1


async def test_what_does_not_mesh_is_said(api):
    codes = []
    for body in (
        rounded(contact={"eccentricity_mm": 3.75}),
        rounded(gear={"satellite_addendum": 1.0}),
    ):
        answer = (await api.post(PATH, json=body)).json()
        codes.append([each["code"] for each in answer["warnings"]])
    assert codes == [["teeth_press"], ["off_involutes"]]
    body = INVOLUTE[5]["body"] | {"include": ["shared_pairs"]}
    error = (await api.post(PATH, json=body)).json()["errors"][0]
    assert error["code"] == "teeth_interfere"


async def test_a_root_of_which_nothing_is_known_is_left_out(api):
    body = deepcopy(INVOLUTE[6]["body"])
    sharp = {"rack_tip_radius": 0.01, "satellite_profile_shift": 0.8, "ring_profile_shift": 1.4}
    body["gear"] |= sharp
    answer = (await api.post(PATH, json=body)).json()
    assert "root" not in answer["stresses"]
    assert "root_unknown" in [each["code"] for each in answer["warnings"]]


TIPS = {"satellite_tip_radius_mm": 62.4, "ring_tip_radius_mm": 61.68}


async def test_tip_radii_stand_for_addenda(api):
    plain = (await api.post(PATH, json=ROUND)).json()["geometry"]
    gear = {name: value for name, value in ROUND["gear"].items() if "addendum" not in name}
    found = (await api.post(PATH, json=ROUND | {"gear": gear | TIPS})).json()["geometry"]
    assert found == pytest.approx(plain, rel=EXACT)
    for name, value, code, limit in (
        ("satellite_tip_radius_mm", 56.0, "greater_than", 60 * np.cos(np.pi / 9)),
        ("satellite_tip_radius_mm", 60.5, "greater_than_equal", 60.9),
        ("satellite_tip_radius_mm", 64.0, "less_than_equal", 63.6),
        ("ring_tip_radius_mm", 59.0, "greater_than", 63 * np.cos(np.pi / 9)),
        ("ring_tip_radius_mm", 60.0, "greater_than_equal", 60.48),
        ("ring_tip_radius_mm", 63.5, "less_than_equal", 63.18),
    ):
        answer = await api.post(PATH, json=ROUND | {"gear": gear | TIPS | {name: value}})
        error = answer.json()["errors"][0]
        assert (error["pointer"], error["code"]) == (f"/gear/{name}", code)
        assert error["params"]["limit"] == pytest.approx(limit, rel=SAME)


@pytest.mark.parametrize("theme", ["light", "dark"])
@pytest.mark.parametrize("case", [INVOLUTE[1], INVOLUTE[4]], ids=lambda case: case["name"])
async def test_the_figure_of_involute_teeth_shows_their_pressures(api, theme, case):
    figure = (await api.post(f"{PATH}/chart?theme={theme}", json=case["body"])).json()
    go.Figure(data=figure["data"], layout=figure["layout"])
    stresses = (await api.post(PATH, json=case["body"])).json()["stresses"]
    line, path, start, end, pitch = figure["data"]
    held = ("pressure_one_pair_start_MPa", "pressure_one_pair_end_MPa")
    for mark, name, at in zip((start, end), held, (0, -1), strict=True):
        assert mark["y"] == pytest.approx([stresses[name]], rel=EXACT)
        assert path["y"][at] == pytest.approx(stresses[name], rel=SEARCHED)
    assert pitch["y"] == pytest.approx([stresses["iso_pressure_at_pitch_point_MPa"]], rel=EXACT)
    assert min(line["x"]) <= pitch["x"][0] * (1 + 1e-6)
    assert max(line["x"]) >= max(*path["x"], *pitch["x"]) * (1 - 1e-6)
    loaded = case["body"] | {"load": case["body"]["load"] | {"application_factor": 1.44}}
    more = (await api.post(f"{PATH}/chart?theme={theme}", json=loaded)).json()["data"]
    assert more[3]["y"][0] == pytest.approx(1.2 * end["y"][0], rel=EXACT)


async def test_a_path_that_starts_where_there_is_no_involute_has_no_pressure_there(api):
    gear = {"ring_profile_shift": 0.0, "ring_addendum": 1.2}
    body = rounded(gear=gear, contact={"eccentricity_mm": 6.0})
    answer = (await api.post(PATH, json=body)).json()
    assert answer["geometry"]["start_roll_satellite"] < 0
    assert "pressure_one_pair_start_MPa" not in answer["stresses"]
    assert "off_involutes" in [each["code"] for each in answer["warnings"]]
    names = [each["name"] for each in (await api.post(f"{PATH}/chart", json=body)).json()["data"]]
    assert names[2:] == ["End of the path", "Pitch point"]
