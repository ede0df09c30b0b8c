"""Cyclogram: its request and its figure."""

from app.calculations.ideal_forces import CyclogramFields, CyclogramResponse
from app.model import (
    Calculation,
    Values,
    WorkedFields,
    timed,
)
from app.sources import YANCHEVSKIY_2021, YANCHEVSKY_2018
from app.theme import IDEAL, Amount, Chart, Figure, Theme, text
from app.worked import Steps
from core.design.sections import MechanismSection
from core.worked.mechanism import cyclogram_steps


class CyclogramRequest(
    WorkedFields, CyclogramFields, of=MechanismSection, needs=("pins",), group="mechanism"
):
    """Mechanism, range of its cyclogram, and optional worked steps."""

    def steps(self) -> Steps:
        """Worked steps of the cyclogram."""
        found, _ = self.solve()
        return {"cyclogram": cyclogram_steps(found=found, **self.cyclogram_given())}


def cyclogram_figure(answer: Values, theme: Theme, real: Values | None = None) -> Figure:
    """Cyclogram as papers draw it: pairs as rows, colour and hatch by satellite.

    `answer` is that of `/cyclogram`. `real` has the pairs that carry, as in `RealCyclogramOut`;
    they are drawn as bars then, with the ideal ones as thin outlines.
    """
    end = answer["driving_count"][-1]["to_deg"]
    satellites = max(pair["satellite"] for pair in answer["pairs"])
    if real is None:
        pairs, count, counted = answer["pairs"], answer["driving_count"], "driving"
    else:
        pairs, count, counted = real["pairs"], real["loaded_count"], "loaded"
    rows = [f"{pair['satellite']}.{pair['pin']}" for pair in answer["pairs"]]
    several = satellites > 1 or bool(answer["dead_centres_deg"]) or real is not None
    look = {"barmode": "overlay", "bargap": 0.3, "showlegend": several}
    chart = Chart(theme, height=190 + 22 * len(rows), **look)
    turns = end / 360
    steps = {"dtick": 30 if turns <= 1 else 90} if turns <= 3 else {}
    chart.axis("x", "crank_angle", "°", range=[0, end], anchor="y2", **steps)
    chart.axis(
        "y",
        "pairs_of",
        type="category",
        categoryorder="array",
        categoryarray=rows[::-1],
        tickvals=rows,
        ticktext=[
            text("pair", satellite=pair["satellite"], pin=pair["pin"]) for pair in answer["pairs"]
        ],
        domain=[0.3, 1],
        showgrid=False,
    )
    most = max(each["pairs"] for each in (*count, *answer["driving_count"]))
    counts: Figure = {"domain": [0, 0.22], "rangemode": "tozero", "range": [0, most + 0.5]}
    chart.axis("y2", counted, dtick=max(1, round(most / 4)), **counts)
    for satellite in range(1, satellites + 1):
        _add_phases(chart, pairs, satellite)
    _add_count(chart, count, f"{counted}_pairs")
    if real is not None:
        _add_outlines(chart, answer["pairs"])
        _add_count(chart, answer["driving_count"], "driving_pairs", ideal=True)
    for start, stop in answer.get("dead_zones_deg", ()):
        chart.shaded(start, stop, opacity=0.18, layer="above")
    dotted = {"color": chart.ink["alert"], "width": 2, "dash": "dot"}
    named = {"name": text("dead_centre"), "line": dotted, "layer": "above"}
    for index, place in enumerate(answer["dead_centres_deg"]):
        chart.shape("line", place, place, showlegend=index == 0, **named)
    return chart.figure


def _add_phases(chart: Chart, pairs: list[Values], satellite: int) -> None:
    """Add all phases of one satellite in which a pair drives, or carries."""
    words, field = "pair_drives", "driving_deg"
    if "loaded_deg" in pairs[0]:
        words, field = "pair_carries", "loaded_deg"
    phases = [
        (pair["pin"], start, stop)
        for pair in pairs
        if pair["satellite"] == satellite
        for start, stop in pair[field]
    ]
    start, end = (Amount(f"%{{customdata[{place}]}}", "°") for place in (2, 3))
    numbers = {"satellite": "%{customdata[0]}", "pin": "%{customdata[1]}"}
    chart.bars(
        text("satellite", satellite=satellite),
        satellite - 1,
        text(words, **numbers, start=start, end=end),
        orientation="h",
        y=[f"{satellite}.{pin}" for pin, _, _ in phases],
        base=[round(start, 6) for _, start, _ in phases],
        x=[round(stop - start, 6) for _, start, stop in phases],
        customdata=[
            [satellite, pin, round(start, 4), round(stop, 4)] for pin, start, stop in phases
        ],
    )


def _add_outlines(chart: Chart, pairs: list[Values]) -> None:
    """Add ideal phases of all pairs, as thin outlines about the real ones."""
    phases = [
        (f"{pair['satellite']}.{pair['pin']}", start, stop)
        for pair in pairs
        for start, stop in pair["driving_deg"]
    ]
    thin = {"color": chart.ink["muted"], "width": 1}
    chart.trace(
        "bar",
        "ideal",
        orientation="h",
        meta=IDEAL,
        y=[row for row, _, _ in phases],
        base=[round(start, 6) for _, start, _ in phases],
        x=[round(stop - start, 6) for _, start, stop in phases],
        width=0.94,
        hoverinfo="skip",
        marker={"color": "rgba(0, 0, 0, 0)", "line": thin},
    )


def _add_count(chart: Chart, intervals: list[Values], words: str, *, ideal: bool = False) -> None:
    """Add the number of pairs as a step line; the ideal one is thin behind the real one."""
    more: Figure = {"fill": "tozeroy"}
    line = {"shape": "hv", "width": 2, "color": chart.ink["text"], "dash": "solid"}
    if ideal:
        more, line = {"fill": "none", "meta": IDEAL}, line | {"width": 1, "dash": "dot"}
    last = intervals[-1]
    chart.trace(
        "scatter",
        "ideal" if ideal else words,
        text(f"{words}_hover", pairs="%{y}", angle=Amount("%{x:.2f}", "°")),
        "y2",
        mode="lines",
        showlegend=False,
        x=[round(each["from_deg"], 6) for each in intervals] + [round(last["to_deg"], 6)],
        y=[each["pairs"] for each in intervals] + [last["pairs"]],
        line=line,
        fillcolor=chart.ink["grid"],
        **more,
    )


def over_one_axis(pattern: Figure, forces: Figure) -> Figure:
    """Figure of the contact force below that of the cyclogram, over one axis of the crank angle."""
    upper, lower = pattern["layout"], forces["layout"]
    total = upper["height"] + lower["height"]
    share = lower["height"] / total

    def raised(axis: Figure) -> Figure:
        low, high = axis["domain"]
        return {**axis, "domain": [share + (1 - share) * low, share + (1 - share) * high]}

    return {
        "data": pattern["data"] + [{**trace, "yaxis": "y3"} for trace in forces["data"]],
        "layout": {
            **upper,
            "height": total,
            "xaxis": {**upper["xaxis"], "anchor": "y3"},
            "yaxis": raised(upper["yaxis"]),
            "yaxis2": raised(upper["yaxis2"]),
            "yaxis3": {**lower["yaxis"], "domain": [0, 0.85 * share]},
            "shapes": lower["shapes"] + upper["shapes"],
            "annotations": [{**each, "yref": "y3"} for each in lower["annotations"]],
        },
    }


def solve(body: CyclogramRequest) -> Values:
    """Pairs of pin and hole that drive, with times and counts; dead centres; assembly angles."""
    return CyclogramResponse.values(*timed(body.solve))


def figure(body: CyclogramRequest, theme: Theme = "light") -> Figure:
    """The cyclogram as a Plotly figure, ready for Plotly.js."""
    body.refuse_undrawable()
    return cyclogram_figure(solve(body), theme)


CALCULATION = Calculation(
    name="cyclogram",
    title="Cyclogram",
    tag="crank-planetary",
    request=CyclogramRequest,
    answer=CyclogramResponse,
    solve=solve,
    figure=figure,
    sources=(YANCHEVSKIY_2021, YANCHEVSKY_2018),
    neglects=("clearance", "deviations", "elasticity"),
)
