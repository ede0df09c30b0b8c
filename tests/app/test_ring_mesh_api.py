"""The mesh of cycloid discs with their ring over REST: the sixteen cases as posted, sections,
limits, refusals, the figure.
"""

import json
from copy import deepcopy
from pathlib import Path

import numpy as np
import plotly.graph_objects as go
import pytest

from app.examples import REQUESTS

pytestmark = pytest.mark.anyio

PATH = "ring-mesh"
CASES = json.loads((Path(__file__).parents[1] / "oracles/cycloid_mesh_cases.json").read_text())
BASE = {**REQUESTS[PATH], "include": ["positions"]}


def changed(without=(), **sections):
    body = deepcopy(BASE)
    for name, value in sections.items():
        body[name] = body.get(name, {}) | value if isinstance(value, dict) else value
    for section, name in without:
        del body[section][name]
    return body


def close(found, expected, path=""):
    """Every number of the expected answer, to nine digits of the largest beside it."""
    if isinstance(expected, dict):
        for name, value in expected.items():
            close(found[name], value, f"{path}/{name}")
    elif isinstance(expected, list) and expected and not isinstance(expected[0], (int, float)):
        assert len(found) == len(expected), path
        for i, (one, other) in enumerate(zip(found, expected, strict=True)):
            close(one, other, f"{path}/{i}")
    elif isinstance(expected, (bool, str)):
        assert found == expected, path
    else:
        rows = expected if isinstance(expected, list) else [expected]
        size = max(map(abs, rows)) or 1.0
        assert found == pytest.approx(expected, rel=0, abs=1e-9 * size), path


@pytest.mark.parametrize("case", CASES, ids=lambda case: case["name"].split()[0])
async def test_case(api, case):
    answer = await api.post(PATH, json=case["body"])
    assert answer.status_code == 200, answer.text
    close(answer.json(), case["expect"])
    assert set(answer.json()) - {"accuracy", "warnings", "assumed"} == {
        "kind",
        "geometry",
        *case["body"]["include"],
    }


async def test_all_sections(api):
    body = changed(
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
    answer = (await api.post(PATH, json=changed(include=["profile"]))).json()
    assert set(answer) == {"kind", "geometry", "profile", "accuracy", "assumed"}
    assumed = {each["pointer"] for each in answer["assumed"]}
    assert assumed == {"/gear/pin_material", "/gear/disc_material"}


async def test_what_is_not_known_is_said(api):
    body = changed(without=[("gear", "modification"), ("gear", "seat_stiffness_N_per_mm")])
    del body["deviations"]
    answer = (await api.post(PATH, json=body)).json()
    codes = [each["code"] for each in answer["warnings"]]
    assert codes == ["modification_unknown", "seat_rigid"]
    stated = changed(gear=BASE["gear"] | {"modification": {}})
    del stated["deviations"]
    answer = (await api.post(PATH, json=stated)).json()
    assert "warnings" not in answer


async def test_bent_pins_and_sleeves(api):
    held = {"pin_support": "fixed", "span_mm": 40, "satellite_positions_mm": [12, 28]}
    gear = BASE["gear"] | held
    stiff, soft = [
        (await api.post(PATH, json=changed(gear=each))).json()["positions"][0]
        for each in (BASE["gear"], gear)
    ]
    assert soft["stiffness_Nm_per_arcmin"] < stiff["stiffness_Nm_per_arcmin"]
    sleeved = changed(gear=gear | {"sleeve_bore_radius_mm": 3.0})
    thin = (await api.post(PATH, json=sleeved)).json()["positions"][0]
    assert thin["stiffness_Nm_per_arcmin"] < soft["stiffness_Nm_per_arcmin"]
    rolling = changed(gear=gear | {"sleeve_bore_radius_mm": 3.0, "rolling": True})
    assert (await api.post(PATH, json=rolling)).json()["positions"][0]["loss_per_friction"] == 0


async def test_reverse_and_rotation(api):
    body = changed(load={"torque_direction": "reverse"})
    answer = (await api.post(PATH, json=body)).json()["positions"][0]
    assert max(answer["rotation_arcmin"]) < 0 > sum(answer["disc_torque_Nm"])
    gear = BASE["gear"] | {"modification": {"equidistant_mm": 0.02, "rotation_arcmin": 1.0}}
    turned = changed(gear=gear, geometry="first_order", include=["positions", "ideal"])
    plain = deepcopy(turned)
    del plain["gear"]["modification"]["rotation_arcmin"]
    more, less = [(await api.post(PATH, json=each)).json() for each in (turned, plain)]
    wider = more["ideal"]["backlash_arcmin"] - less["ideal"]["backlash_arcmin"]
    assert wider == pytest.approx(2, rel=1e-9)
    plays = [np.ptp(each["positions"][0]["play_arcmin"]) for each in (more, less)]
    assert plays[0] - plays[1] == pytest.approx(2, rel=1e-6)


@pytest.mark.parametrize(
    ("sections", "pointer", "code"),
    [
        ({"mechanism": {"ring_teeth": 21}}, "/mechanism/ring_teeth", "not_this_cycloid"),
        ({"gear": {"kind": "involute"}}, "/gear/kind", "not_this_ring"),
        ({"gear": {"kind": "none"}}, "/gear/kind", "literal_error"),
        ({"gear": {"ring_pin_radius_mm": 14.0}}, "/gear/ring_pin_radius_mm", "undercut"),
        (
            {"contact": {"eccentricity_mm": 3.0}},
            "/gear/ring_pin_circle_radius_mm",
            "no_cycloid",
        ),
        ({"gear": {"modification": {"pin_circle_mm": 0.6}}},
         "/gear/modification/pin_circle_mm", "less_than_equal"),
        ({"gear": {"modification": {"rotation_arcmin": 1.0}}}, "/geometry", "flanks_first_order"),
        ({"gear": {"span_mm": 40.0}}, "/gear/span_mm", "of_another_kind"),
        ({"gear": {"pin_support": "fixed"}}, "/gear/span_mm", "needed_beside"),
        (
            {"gear": {"sleeve_bore_radius_mm": 5.0}},
            "/gear/sleeve_bore_radius_mm",
            "smaller_than",
        ),
        ({"deviations": {"ring_pin_radial_mm": [0.0]}},
         "/deviations/ring_pin_radial_mm", "different_length"),
        ({"deviations": {"crank_phase_deg": [0.0]}},
         "/deviations/crank_phase_deg", "different_length"),
        ({"contact_law": {"kind": "hertz", "reference_depth_mm": 11.0}},
         "/contact_law/reference_depth_mm", "less_than_equal"),
        ({"contact_law": {"kind": "hertz", "reference_depth_mm": 2.0}},
         "/contact_law/reference_depth_mm", "greater_than_equal"),
        ({"satellite_coupling": {"kind": "shares", "shares": [1.0]}},
         "/satellite_coupling/shares", "different_length"),
        ({"satellite_coupling": {"kind": "elastic"}}, "/satellite_coupling/kind", "literal_error"),
        ({"include": ["profile"], "chord_error_mm": 1e-10},
         "/chord_error_mm", "greater_than_equal"),
    ],
)  # fmt: skip
async def test_refusals_name_the_field(api, sections, pointer, code):
    answer = await api.post(PATH, json=changed(**sections))
    assert answer.status_code == 422, answer.text
    errors = answer.json()["errors"]
    assert [(each["pointer"], each["code"]) for each in errors] == [(pointer, code)]


async def test_limits_are_in_the_units_of_their_fields(api):
    body = changed(gear={"ring_pin_radius_mm": 14.0})
    error = (await api.post(PATH, json=body)).json()["errors"][0]
    limit = error["params"]["limit"]
    assert 5 < limit < 14
    near = changed(gear={"ring_pin_radius_mm": limit * (1 - 1e-9)})
    assert (await api.post(PATH, json=near)).status_code == 200
    fine = changed(include=["profile"], chord_error_mm=1e-10)
    limit = (await api.post(PATH, json=fine)).json()["errors"][0]["params"]["limit"]
    answer = await api.post(PATH, json=changed(include=["profile"], chord_error_mm=limit))
    assert answer.status_code == 200
    assert 190_000 < len(answer.json()["profile"]["points"]) <= 200_000


async def test_what_takes_too_long_is_refused(api):
    teeth = {"satellite_teeth": 599, "ring_teeth": 600}
    gear = BASE["gear"] | {"ring_pin_circle_radius_mm": 2000.0}
    body = changed(mechanism=teeth, gear=gear, include=["over_turn"])
    error = (await api.post(PATH, json=body)).json()["errors"][0]
    assert (error["pointer"], error["code"]) == ("/mechanism/ring_teeth", "too_many_pairs")
    assert error["params"] == {"limit": 500, "satellites": 2}
    shared = {"kind": "shares", "shares": [0.5, 0.5]}
    body = changed(satellite_coupling=shared, include=["over_turn"])
    error = (await api.post(PATH, json=body)).json()["errors"][0]
    assert error["params"]["limit"] == 12
    first = await api.post(PATH, json=body | {"geometry": "first_order"})
    assert first.status_code == 200


async def test_a_pin_that_is_lost_in_a_valley(api):
    gear = {
        "kind": "cycloid",
        "ring_pin_circle_radius_mm": 90.0,
        "ring_pin_radius_mm": 1.0,
        "contact_length_mm": 12.0,
        "modification": {"equidistant_mm": 0.15},
    }
    teeth = {"satellite_teeth": 59, "ring_teeth": 60}
    body = changed(mechanism=teeth, contact={"eccentricity_mm": 1.4}, gear=gear)
    answer = await api.post(PATH, json=body)
    assert answer.status_code == 422
    assert answer.json()["errors"][0]["code"] == "valley_lost"
    first = (await api.post(PATH, json=body | {"geometry": "first_order"})).json()
    assert first["positions"][0]["loaded_pairs"] >= 1


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
    many = changed(mechanism={"satellite_teeth": 199, "ring_teeth": 200})
    error = (await api.post(f"{PATH}/chart", json=many)).json()["errors"][0]
    assert (error["pointer"], error["code"]) == ("/mechanism/ring_teeth", "too_many_pairs")


async def test_in_a_batch_it_answers_the_same(api):
    alone = (await api.post(PATH, json=BASE)).json()
    lines = {"calculation": PATH, "requests": [BASE, changed(gear={"kind": "involute"})]}
    answer = (await api.post("batch", json=lines)).json()
    assert answer["results"][0]["result"]["positions"] == alone["positions"]
    assert "not_this_ring" in json.dumps(answer["results"][1])
