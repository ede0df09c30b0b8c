"""Ring mesh and output mechanism in series over REST: sections, refusals."""

import json
from pathlib import Path

import pytest

from core.precision import EXACT, SAME, SEARCHED
from tests.inputs.bodies import changed
from tests.oracles.held import close

pytestmark = pytest.mark.anyio

PATH = "load-sharing"
CASES = json.loads((Path(__file__).parents[1] / "oracles/series_cases.json").read_text())
ONE, BASE = (
    {name: each for name, each in case["body"].items() if name != "geometry"} for case in CASES[:2]
)

PLAIN = changed(BASE, deviations=None) | {"deviations": {"disc_phase_deg": [0.0, 0.02]}}
"""One disc ahead: with pins that deviate the room over all turns takes a second a request."""


async def test_curves_pass_through_the_positions(api):
    named = ["positions", "curves", "stiffness_curve", "ideal", "pressure", "worked"]
    body = changed(BASE, include=named, samples=5, crank_angle_deg=[90], torques_Nm=[-240, 240])
    answer = await api.answer(PATH, body)
    curves, lag, position = (
        answer["curves"],
        answer["stiffness_curve"],
        answer["positions"][0],
    )
    lags = [curves["rotation_arcmin"][1], lag["rotation_arcmin"][1]]
    assert lags == pytest.approx([position["rotation_arcmin"]] * 2, rel=EXACT)
    behind = [position["rotation_arcmin"] - own for own in position["ring"]["rotation_arcmin"]]
    assert position["satellite_rotation_arcmin"] == pytest.approx(behind, rel=SAME)
    back = lag["rotation_arcmin"][0]
    assert curves["reverse_rotation_arcmin"][1] == pytest.approx(back, rel=EXACT) and back < 0
    forces = [force[1] for force in curves["force_N"]]
    assert forces == pytest.approx([each for row in position["force_N"] for each in row], rel=SAME)
    assert max(map(max, position["pressure_MPa"])) == pytest.approx(position["max_pressure_MPa"])
    assert answer["ideal"]["peak_force_N"] > 0 and answer["worked"]
    loads = [each["crank_load_N"] for each in [position["ring"]]]
    assert min(loads[0]) > 1000


async def test_the_ring_gives_by_its_own_law(api):
    """Hertz's where none is named, and what its seats give."""
    lags = [
        (await api.answer(PATH, changed(PLAIN, gear=change)))["positions"][0]["ring"][
            "rotation_arcmin"
        ][0]
        for change in (
            {"contact_law": {"kind": "hertz"}},
            {"contact_law": {}},
            {"contact_law": {"kind": "hertz", "reference_depth_mm": 6.0}},
            {},
            {"seat_stiffness_N_per_mm": 2e5},
        )
    ]
    assert lags[0] == lags[1] < lags[2] and lags[3] < lags[4]
    body = changed(PLAIN, gear__contact_law=None, gear__modification=None)
    answer = await api.answer(PATH, body)
    assert "modification_unknown" in [each["code"] for each in answer["warnings"]]
    assert "ring" not in answer["positions"][0]
    body = changed(PLAIN, gear__pin_material=None)
    assumed = (await api.answer(PATH, body))["assumed"]
    assert [each["pointer"] for each in assumed] == ["/gear/pin_material"]


async def test_both_meshes_are_in_series_unless_the_coupling_says_otherwise(api):
    plain = await api.answer(PATH, PLAIN)
    unsaid = await api.answer(PATH, changed(PLAIN, satellite_coupling=None))
    assert unsaid["positions"] == plain["positions"]
    rigid = await api.answer(PATH, PLAIN | {"satellite_coupling": {"kind": "rigid"}})
    assert "ring" not in rigid["positions"][0]


async def test_a_torque_that_alternates_is_answered_by_its_worse_direction(api):
    positions = {
        way: (await api.answer(PATH, changed(BASE, load={"torque_direction": way})))["positions"][0]
        for way in ("driving", "reverse", "alternating")
    }
    worse, way = positions["alternating"], positions["alternating"]["torque_direction"]
    peaks = {each: max(map(max, positions[each]["force_N"])) for each in ("driving", "reverse")}
    assert way == max(peaks, key=peaks.get) and min(peaks.values()) < max(peaks.values())
    assert worse["ring"] == positions[way]["ring"]


async def test_of_the_ring_as_output_the_lag_is_its_own(api):
    """Torque on the pins and angles relative to the pins are equal."""
    pins = (await api.answer(PATH, PLAIN))["positions"][0]
    load = {"output_torque_Nm": 240 * 21 / 20}
    ring = (await api.answer(PATH, changed(PLAIN, mechanism={"output": "ring"}, load=load)))[
        "positions"
    ][0]
    assert ring["rotation_arcmin"] == pytest.approx(pins["rotation_arcmin"] * 20 / 21)
    close(ring["ring"], pins["ring"])


async def test_over_all_turns(api):
    """Over as many turns as a disc has lobes no position exceeds the extremes; the ring has its
    own.
    """
    body = changed(
        BASE, include=["over_turn", "positions", "ideal"], crank_angle_deg=[0, 800, 1800]
    )
    answer = await api.answer(PATH, body)
    turn, positions = answer["over_turn"], answer["positions"]
    assert turn["peak_force_N"] > max(max(map(max, each["force_N"])) for each in positions)
    ring = turn["ring"]
    assert ring["peak_force_N"] > max(max(map(max, each["ring"]["force_N"])) for each in positions)
    assert answer["ideal"]["ratio"] == turn["peak_force_N"] / answer["ideal"]["peak_force_N"]
    assert answer["accuracy"]["relative_error"] < 1e-3
    at_peak = changed(
        BASE, crank_angle_deg=[turn["peak_crank_angle_deg"], ring["peak_crank_angle_deg"]]
    )
    one, other = (await api.answer(PATH, at_peak))["positions"]
    pair, tooth = turn["peak_pair"], ring["peak_pair"]
    force = one["force_N"][pair["satellite"] - 1][pair["pin"] - 1]
    assert force == pytest.approx(turn["peak_force_N"], rel=EXACT)
    force = other["ring"]["force_N"][tooth["satellite"] - 1][tooth["pin"] - 1]
    assert force == pytest.approx(ring["peak_force_N"], rel=EXACT)
    alone = changed(BASE, gear=None, satellite_coupling=None, include=["over_turn"])
    for name in ("ring_pin_radial_mm", "ring_pin_tangential_mm", "ring_pin_radius_mm"):
        del alone["deviations"][name]
    rigid = (await api.answer(PATH, alone))["over_turn"]
    assert "ring" not in rigid and turn["backlash_max_arcmin"] > rigid["backlash_max_arcmin"]
    assert turn["stiffness_max_Nm_per_arcmin"] < rigid["stiffness_max_Nm_per_arcmin"]
    one_disc = ONE | {"include": ["over_turn"]}
    both = one_disc | {"load": one_disc["load"] | {"torque_direction": "alternating"}}
    worse, way = [(await api.answer(PATH, each))["over_turn"] for each in (both, one_disc)]
    assert worse["peak_force_N"] == pytest.approx(way["peak_force_N"]) and worse["ring"]


BEARINGS = {"stiffness_N_per_mm": 2e5, "radial_clearance_mm": 0.012}
TIED = {
    "support": "tie_ring", "satellite_positions_mm": [10, 25], "span_mm": 40, "ring_joint": "pinned"
}  # fmt: skip


async def test_what_gives_besides_joins_the_series(api):
    """Bearings let discs float, a tie ring evens out: the output lags more than without, and forces
    move by as much as a bearing or a pin gives.
    """
    plain = (await api.answer(PATH, PLAIN))["positions"][0]
    for more in (
        {"crank_support": BEARINGS},
        {"crank_support": {"radial_clearance_mm": 0.012}},
        {"pin": TIED},
        {"crank_support": BEARINGS, "pin": TIED},
    ):
        found = (await api.answer(PATH, changed(PLAIN, **more)))["positions"][0]
        assert found["rotation_arcmin"] > plain["rotation_arcmin"]
        moved = [a - b for a, b in zip(found["force_N"][0], plain["force_N"][0], strict=True)]
        assert max(map(abs, moved)) > 1.0
        play = [row["play_arcmin"][1] - row["play_arcmin"][0] for row in (found, plain)]
        wider = play[0] - play[1]
        assert wider > 0.5 if "crank_support" in more else wider == pytest.approx(0, abs=1e-9)
    stiff = {"stiffness_N_per_mm": 1e12}
    near = (await api.answer(PATH, changed(PLAIN, crank_support=stiff)))["positions"][0]
    assert near["force_N"][0] == pytest.approx(plain["force_N"][0], rel=SEARCHED, abs=1e-3)


async def test_over_all_turns_of_discs_that_float(api):
    one = changed(PLAIN, include=["over_turn"])
    plain = (await api.answer(PATH, one))["over_turn"]
    floats = (await api.answer(PATH, one | {"crank_support": BEARINGS}))["over_turn"]
    assert floats["backlash_max_arcmin"] > plain["backlash_max_arcmin"] + 0.5
    assert floats["stiffness_min_Nm_per_arcmin"] < plain["stiffness_min_Nm_per_arcmin"]
    assert not floats["pressed_without_load"]


async def test_the_figure(api):
    figure = await api.post(f"{PATH}/chart", json=PLAIN)
    assert figure.status_code == 200
    names = [trace["name"] for trace in figure.json()["data"]]
    assert names.count("1.1") == 2
    lag = next(trace for trace in figure.json()["data"] if trace.get("yaxis") == "y2")
    assert len(lag["y"]) == 121


FREE = {
    "mechanism": {"pins": 8, "satellites": 2, "satellite_teeth": 20, "ring_teeth": 21},
    "load": {"output_torque_Nm": 10.0, "pin_circle_radius_mm": 25.0},
    "contact": {
        "contact_length_mm": 10.0, "pin_radius_mm": 3.0, "eccentricity_mm": 1.25,
        "hole_clearance_mm": 0.005, "pin_material": "steel_bearing",
        "hole_material": "steel_bearing",
    },
    "gear": {
        "kind": "cycloid", "ring_pin_circle_radius_mm": 45.0, "ring_pin_radius_mm": 2.5,
        "contact_length_mm": 10.0, "disc_material": "steel_bearing",
        "pin_material": "steel_bearing", "modification": {"equidistant_mm": 0.03},
    },
    "satellite_coupling": {"kind": "ring"},
    "deviations": {"disc_phase_deg": [0.0, 0.05]},
}  # fmt: skip


async def test_a_phase_that_the_play_in_the_ring_takes_up_is_no_misfit(api):
    """Held by the ring the pins would be 6 um too thick; each disc turns to where they are not."""
    answer = await api.answer(PATH, FREE)
    low, high = answer["positions"][0]["play_arcmin"]
    assert low < -4 and high > 1
    response = await api.post("crank-planetary", json=FREE | {"include": ["checks", "fixes"]})
    whole = response.json()
    for fit in (answer["fit"], whole["fit"]):
        assert fit == {"state": "fits", "least_room_mm": pytest.approx(0.005, rel=SAME)}
    (check,) = (each for each in whole["checks"] if each["code"] == "interference")
    assert check["status"] == "pass"
    tight = FREE | {"gear": FREE["gear"] | {"modification": {"equidistant_mm": 0.003}}}
    response = await api.post("crank-planetary", json=tight | {"include": ["checks"]})
    (check,) = (each for each in response.json()["checks"] if each["code"] == "interference")
    assert check["status"] == "fail" and -0.006 < check["value"] < 0
