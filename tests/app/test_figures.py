"""Every chart is a figure that Plotly accepts, and shows the numbers of its answer."""

import plotly.graph_objects as go
import pytest

from app.figures.theme import SERIES

pytestmark = pytest.mark.anyio

MECHANISM = {"pins": 3, "ratio": 20, "crank_spacing_deg": 90}
LOAD = {"output_torque_Nm": 500, "pin_circle_radius_mm": 50}
CONTACT = {"contact_length_mm": 20, "pin_radius_mm": 8, "hole_radius_mm": 10}
STEEL = {"youngs_modulus_GPa": 210, "poissons_ratio": 0.3, "allowable_pressure_MPa": 1000}
CHARTS = {
    "cyclogram": MECHANISM,
    "contact-force": {**MECHANISM, **LOAD},
    "hertz": {**CONTACT, "force_N": 9000, "pin_material": STEEL, "hole_material": STEEL},
    "crank-planetary": {"mechanism": MECHANISM, "load": LOAD, "contact": CONTACT},
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
    assert layout["annotations"][0]["text"] == "dead centre"


async def test_too_many_pairs_to_draw_are_refused_by_field(api):
    response = await api.post("cyclogram/chart", json={"pins": 1000, "ratio": 20})
    assert response.status_code == 422
    assert response.json()["errors"][0]["pointer"] == "/pins"
