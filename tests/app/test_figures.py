"""Every chart is a figure that Plotly accepts, and shows the numbers of its answer."""

import re
from itertools import pairwise
from pathlib import Path

import plotly.graph_objects as go
import pytest

from app.calculations.load_sharing import MAX_TURN_PAIRS
from app.calculations.mechanism import MAX_DRAWN_PAIRS, MAX_PAIRS
from app.theme import SERIES
from core.precision import JUDGED, SEARCHED
from tests.inputs.papers import GEAR, MESH, ROLLERS, SHAFT

pytestmark = pytest.mark.anyio

ROOT = Path(__file__).parents[2]
MECHANISM = {"pins": 3, "ratio": 20, "crank_spacing_deg": 90}
LOAD = {"output_torque_Nm": 500, "pin_circle_radius_mm": 50}
CONTACT = {"contact_length_mm": 20, "pin_radius_mm": 8, "hole_radius_mm": 10}
STEEL = {"youngs_modulus_GPa": 210, "poissons_ratio": 0.3, "allowable_pressure_MPa": 1000}
CHARTS = {
    "cyclogram": MECHANISM,
    "contact-force": {**MECHANISM, **LOAD},
    "fit": {
        "mechanism": MECHANISM,
        "load": {"pin_circle_radius_mm": 50},
        "contact": {**CONTACT, "eccentricity_mm": 1.9},
        "deviations": {"pin_radial_mm": [0.2, 0, 0]},
    },
    "hertz": {**CONTACT, "force_N": 9000, "pin_material": STEEL, "hole_material": STEEL},
    "crank-planetary": {"mechanism": MECHANISM, "load": LOAD, "contact": CONTACT},
}

CHARTS |= {
    "roller-strength": ROLLERS,
    "precession/contact-line": GEAR,
    "precession/meshing-load": MESH,
    "precession/shaft-deflection": SHAFT,
}


@pytest.mark.parametrize("path", CHARTS)
@pytest.mark.parametrize("theme", SERIES)
async def test_plotly_accepts_the_figure(api, path, theme):
    response = await api.post(f"{path}/chart?theme={theme}", json=CHARTS[path])
    figure = response.json()
    assert set(figure) == {"data", "layout"}
    go.Figure(data=figure["data"], layout=figure["layout"])


async def test_the_bars_are_the_driving_phases(api):
    answer = (await api.post("cyclogram", json=MECHANISM)).json()
    figure = (await api.post("cyclogram/chart", json=MECHANISM)).json()
    bars = [
        (row, base, base + length)
        for trace in figure["data"]
        if trace["type"] == "bar"
        for row, base, length in zip(trace["y"], trace["base"], trace["x"], strict=True)
    ]
    phases = [
        (f"{pair['satellite']}.{pair['pin']}", start, stop)
        for pair in answer["pairs"]
        for start, stop in pair["driving_deg"]
    ]
    rows = figure["layout"]["yaxis"]
    named = [f"S{pair['satellite']} P{pair['pin']}" for pair in answer["pairs"]]
    assert rows["ticktext"] == named and rows["tickvals"] == rows["categoryarray"][::-1]
    words = [
        [path[-1], each] for path, *each in figure["layout"]["meta"]["words"] if "ticktext" in path
    ]
    assert words[4] == [4, ["pair", {"satellite": 2, "pin": 2}]]
    assert len(bars) == len(phases)
    for bar, phase in zip(bars, phases, strict=True):
        assert bar[0] == phase[0] and bar[1:] == pytest.approx(phase[1:], abs=2e-6)


async def test_the_peak_marker_stands_on_the_highest_curve(api):
    body = CHARTS["contact-force"]
    answer = (await api.post("contact-force", json=body)).json()
    figure = (await api.post("contact-force/chart", json=body)).json()
    marker = figure["data"][-1]
    assert marker["y"] == [answer["peak_force_N"]]
    highest = max(max(trace["y"]) for trace in figure["data"][:-1])
    assert highest == pytest.approx(answer["peak_force_N"], rel=2e-4)


@pytest.mark.parametrize(
    ("materials", "limits"),
    [
        ({}, {"Limit of the pin": 1500, "Limit of the hole": 581.9}),
        ({"hole_material": "iron_grey"}, {"Limit of the pin": 1500}),
        ({"pin_material": "brass"}, {"Limit of the hole": 581.9}),
        ({"pin_material": "brass", "hole_material": "plastic_pom"}, {}),
    ],
)
async def test_a_limit_is_drawn_for_the_bodies_that_have_one(api, materials, limits):
    body = {**CONTACT, "force_N": 9000, **materials}
    drawn = (await api.post("hertz/chart", json=body)).json()["data"]
    curves = (
        {"Hertz", "Conformal"} if materials.get("hole_material") == "plastic_pom" else {"Hertz"}
    )
    assert curves < {each["name"] for each in drawn} or (curves == {each["name"] for each in drawn})
    found = {each["name"]: each["y"] for each in drawn if each["name"] not in curves}
    assert found == {name: [pytest.approx(limit)] * 2 for name, limit in limits.items()}


async def test_a_jump_of_the_force_is_drawn_upright(api):
    """With equal sharing the force jumps where a pair starts: no slope of a sample's width."""
    body = {**CHARTS["contact-force"], "force_exponent": 0}
    for trace in (await api.post("contact-force/chart", json=body)).json()["data"][:-1]:
        for (x0, y0), (x1, y1) in zip(
            zip(trace["x"], trace["y"], strict=True),
            zip(trace["x"][1:], trace["y"][1:], strict=True),
            strict=False,
        ):
            if (y0 == 0) != (y1 == 0):
                assert x1 - x0 < 1e-3


async def test_a_dead_centre_is_marked(api):
    body = {"pins": 2, "satellites": 1, "ratio": 20}
    layout = (await api.post("cyclogram/chart", json=body)).json()["layout"]
    assert [round(each["x0"], 3) for each in layout["shapes"]] == [0.0, 171.429, 342.857]
    assert [each["name"] for each in layout["shapes"] if each["showlegend"]] == ["dead centre"]
    assert layout["showlegend"]


async def test_too_many_pairs_to_draw_are_refused_by_field(api):
    response = await api.post("cyclogram/chart", json={"pins": 1000, "ratio": 20})
    assert response.status_code == 422
    assert response.json()["errors"][0]["pointer"] == "/pins"


@pytest.mark.parametrize("revolutions", [0.1, 1, 3, 3.5, 40])
async def test_a_cyclogram_of_any_length_is_drawn(api, revolutions):
    response = await api.post("cyclogram/chart", json=MECHANISM | {"revolutions": revolutions})
    assert response.status_code == 200
    axes = response.json()["layout"]["xaxis"]
    assert axes["range"] == pytest.approx([0, 360 * revolutions])


async def test_too_many_driving_phases_to_draw_are_refused_by_field(api):
    job = {"revolutions": 1000}
    response = await api.post("cyclogram/chart", json={"pins": 3, "ratio": 20} | job)
    assert response.status_code == 422
    assert response.json()["errors"][0]["pointer"] == "/revolutions"
    largest = float(re.search(r"at most (\S+)", response.json()["detail"])[1])
    shorter = {"pins": 3, "ratio": 20} | job | {"revolutions": 0.99 * largest}
    assert (await api.post("cyclogram/chart", json=shorter)).status_code == 200


async def test_the_design_lies_on_its_own_curves(api):
    """The marker of each panel of the rollers' figure lies on a curve of that panel."""
    figure = (await api.post("roller-strength/chart", json=ROLLERS)).json()
    markers = [trace for trace in figure["data"] if trace["mode"] == "markers"]
    assert len(markers) == 3
    for own in markers:
        x, y = own["x"][0], own["y"][0]
        panel = [
            t for t in figure["data"] if t["mode"] == "lines" and t.get("yaxis") == own.get("yaxis")
        ]
        off = []
        for trace in panel:
            (x0, y0), (x1, y1) = next(
                (left, right)
                for left, right in pairwise(zip(trace["x"], trace["y"], strict=True))
                if left[0] <= x <= right[0]
            )
            off.append(abs(y0 + (y1 - y0) * (x - x0) / (x1 - x0) - y) / y)
        assert min(off) < 2e-3


async def test_the_shaft_diagram_ends_where_the_answer_does(api):
    answer = (await api.post("precession/shaft-deflection", json=SHAFT)).json()
    figure = (await api.post("precession/shaft-deflection/chart", json=SHAFT)).json()
    deflections = [trace for trace in figure["data"] if trace["yaxis"] == "y3"]
    for trace, axis in zip(deflections, "xy", strict=True):
        assert trace["y"][0] == pytest.approx(answer["deflection_C_mm"][axis], rel=JUDGED)
        assert trace["y"][-1] == 0.0


@pytest.mark.parametrize("path", CHARTS)
async def test_curves_keep_all_their_points(api, path):
    """Plotly would leave out points of a bent line until it shows corners."""
    for trace in (await api.post(f"{path}/chart", json=CHARTS[path])).json()["data"]:
        bent = trace.get("mode") == "lines" and "shape" not in trace["line"] and len(trace["x"]) > 2
        assert not bent or trace["line"]["simplify"] is False


async def test_the_rollers_figure_can_be_held_against_its_source(api):
    """Curves named by chi/d with sigma/E beside every stress, and delta from 0 on."""
    figure = (await api.post("roller-strength/chart", json=ROLLERS)).json()
    stresses = [trace for trace in figure["data"] if "customdata" in trace]
    assert [trace["name"] for trace in stresses] == [
        f"χ = {0.001 * i:g} mm = {1e-4 * i:g}·d" for i in (1, 2, 3, 4)
    ]
    for trace in stresses:
        relative = [stress / 210e3 for stress in trace["y"]]
        assert trace["customdata"] == pytest.approx(relative, rel=SEARCHED)
    assert figure["layout"]["xaxis2"]["range"] == [0, 2]


async def test_given_gaps_are_scaled_in_the_rollers_figure(api):
    """The design lies on the curve of its own gaps; none is named by a tolerance nobody gave."""
    body = ROLLERS | {"gaps_mm": [0, 0.001, 0.004, 0.002]}
    del body["position_tolerance_mm"]
    figure = (await api.post("roller-strength/chart", json=body)).json()
    panel = {trace["name"]: trace for trace in figure["data"] if trace.get("yaxis") == "y3"}
    assert list(panel) == ["Gaps × 0.5", "Gaps × 1", "Gaps × 1.5", "Gaps × 2", "This design"]
    own, (place,), (stress,) = (panel["Gaps × 1"], *(panel["This design"][key] for key in "xy"))
    after = next(i for i, x in enumerate(own["x"]) if x > place)
    assert own["y"][after - 1] < stress < own["y"][after]


def test_the_page_knows_how_many_pairs_are_taken():
    text = (ROOT / "static/calculators/crank-planetary/mechanism.js").read_text()
    (known,) = re.findall(
        r"MOST_PAIRS = \{ all: ([\d_]+), turned: ([\d_]+), drawn: ([\d_]+) \}", text
    )
    assert [*map(int, known)] == [MAX_PAIRS, MAX_TURN_PAIRS, MAX_DRAWN_PAIRS]


LOOSE = {
    "mechanism": {"pins": 8, "satellites": 2, "ratio": 35},
    "load": {"output_torque_Nm": 320, "pin_circle_radius_mm": 45},
    "contact": {
        "pin_radius_mm": 6,
        "eccentricity_mm": 1.5,
        "hole_clearance_mm": 0.02,
        "contact_length_mm": 14,
    },
}


@pytest.mark.parametrize("direction", ["driving", "reverse", "alternating"])
async def test_the_figure_of_a_reducer_follows_the_model_of_its_answer(api, direction):
    body = {**LOOSE, "load": LOOSE["load"] | {"torque_direction": direction}}
    asked = ["contact_force", "load_sharing", "real_cyclogram"]
    answer = (await api.post("crank-planetary", json=body | {"include": asked})).json()
    assert answer["model"] == "real"
    forces = (await api.post("crank-planetary/chart", json=body | {"include": asked[:1]})).json()
    curves = {trace["name"]: trace for trace in forces["data"]}
    peak = answer["load_sharing"]["peak_pair"]
    carried = curves[f"{peak['satellite']}.{peak['pin']}"]
    top = max(max(curve["y"]) for name, curve in curves.items() if name[0].isdigit())
    assert max(carried["y"]) == pytest.approx(top) == pytest.approx(curves["Peak"]["y"][0])
    assert top == pytest.approx(answer["load_sharing"]["peak_force_N"])
    ideal = curves["Largest force, ideal"]
    assert max(ideal["y"]) == pytest.approx(answer["contact_force"]["peak_force_N"], rel=1e-3)
    assert ideal["line"]["width"] == 1 < carried["line"]["width"]

    pattern = (
        await api.post("crank-planetary/chart", json=body | {"include": ["cyclogram"]})
    ).json()
    bars = [trace for trace in pattern["data"] if trace["type"] == "bar"]
    drawn = {
        (row, start, length)
        for bar in bars[:-1]
        for row, start, length in zip(bar["y"], bar["base"], bar["x"], strict=True)
    }
    assert drawn == {
        (f"{pair['satellite']}.{pair['pin']}", round(start, 6), round(stop - start, 6))
        for pair in answer["real_cyclogram"]["pairs"]
        for start, stop in pair["loaded_deg"]
    }
    for row, start, length in drawn:  # a pair carries where the ideal one drives
        ideal_bars = zip(bars[-1]["y"], bars[-1]["base"], bars[-1]["x"], strict=True)
        assert any(
            name == row and low <= start + 1e-4 and start + length <= low + wide + 1e-4
            for name, low, wide in ideal_bars
        )


@pytest.mark.parametrize("direction", ["driving", "reverse"])
async def test_a_figure_of_perfect_parts_is_the_ideal_one(api, direction):
    """In reverse that of a mechanism half a turn ahead, whose pairs drive where these brake."""
    load = LOOSE["load"] | {"torque_direction": direction}
    body = LOOSE | {"contact": LOOSE["contact"] | {"hole_clearance_mm": 0}, "load": load}
    turned = {"initial_crank_angle_deg": 180} if direction == "reverse" else {}
    for section, path, own in (
        ("cyclogram", "cyclogram", LOOSE["mechanism"] | turned),
        ("contact_force", "contact-force", LOOSE["mechanism"] | LOOSE["load"] | turned),
    ):
        whole = await api.post("crank-planetary/chart", json=body | {"include": [section]})
        assert whole.json() == (await api.post(f"{path}/chart", json=own)).json()
        answer = (await api.post("crank-planetary", json=body | {"include": [section]})).json()
        alone = (await api.post(path, json=own)).json()
        for found in (answer[section], alone):
            found["accuracy"].pop("run_time_us")
        assert answer[section] == alone


async def test_curves_of_the_real_forces_come_where_they_are_asked(api):
    body = LOOSE | {"include": ["load_sharing"]}
    assert "curves" not in (await api.post("crank-planetary", json=body)).json()["load_sharing"]
    body["load"] = LOOSE["load"] | {"include": ["curves"], "samples": 50}
    sharing = (await api.post("crank-planetary", json=body)).json()["load_sharing"]
    forces = sharing["curves"]["force_N"]
    assert len(forces) == 16 and max(map(max, forces)) == pytest.approx(sharing["peak_force_N"])
