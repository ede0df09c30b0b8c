"""Cyclogram: its request and its figure."""

from app.calculations.ideal_forces import CyclogramFields, CyclogramResponse, Range
from app.model import (
    Calculation,
    Values,
    WorkedFields,
    timed,
)
from app.sources import YANCHEVSKIY_2021, YANCHEVSKY_2018
from app.theme import IDEAL, INK, Amount, Figure, Theme, axis, hover, layout, series_style, text
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
        pairs, count, counted, ideal = answer["pairs"], answer["driving_count"], "driving", []
    else:
        pairs, count, counted = real["pairs"], real["loaded_count"], "loaded"
        ideal = [_outlines(answer["pairs"], theme), _ideal_count(answer["driving_count"], theme)]
    most = max(each["pairs"] for each in (*count, *answer["driving_count"]))
    data = [_bars(pairs, satellite, theme) for satellite in range(1, satellites + 1)]
    data += [_count(count, f"{counted}_pairs", theme), *ideal]
    rows = [f"{pair['satellite']}.{pair['pin']}" for pair in answer["pairs"]]
    alert = INK[theme]["alert"]
    shapes = [
        {
            "type": "rect",
            "xref": "x",
            "yref": "paper",
            "x0": start,
            "x1": stop,
            "y0": 0,
            "y1": 1,
            "fillcolor": alert,
            "opacity": 0.18,
            "line": {"width": 0},
        }
        for start, stop in answer.get("dead_zones_deg", ())
    ] + [
        {
            "type": "line",
            "xref": "x",
            "yref": "paper",
            "x0": place,
            "x1": place,
            "y0": 0,
            "y1": 1,
            "line": {"color": alert, "width": 2, "dash": "dot"},
            "name": text("dead_centre"),
            "showlegend": index == 0,
        }
        for index, place in enumerate(answer["dead_centres_deg"])
    ]
    turns = end / 360
    steps = {"dtick": 30 if turns <= 1 else 90} if turns <= 3 else {}
    return {
        "data": data,
        "layout": layout(
            theme,
            barmode="overlay",
            bargap=0.3,
            showlegend=satellites > 1 or bool(answer["dead_centres_deg"]) or bool(ideal),
            height=190 + 22 * len(rows),
            xaxis=axis(theme, text("crank_angle"), "°", range=[0, end], anchor="y2", **steps),
            yaxis=axis(
                theme,
                text("pairs_of"),
                type="category",
                categoryorder="array",
                categoryarray=rows[::-1],
                tickvals=rows,
                ticktext=[
                    text("pair", satellite=pair["satellite"], pin=pair["pin"])
                    for pair in answer["pairs"]
                ],
                domain=[0.3, 1],
                showgrid=False,
            ),
            yaxis2=axis(
                theme,
                text(counted),
                domain=[0, 0.22],
                rangemode="tozero",
                dtick=max(1, round(most / 4)),
                range=[0, most + 0.5],
            ),
            shapes=shapes,
        ),
    }


def _phases(pair: Values) -> list[Range]:
    """Phases in which a pair drives, or carries."""
    phases: list[Range] = pair["driving_deg" if "driving_deg" in pair else "loaded_deg"]
    return phases


def _bars(pairs: list[Values], satellite: int, theme: Theme) -> Figure:
    """All phases of one satellite."""
    colour, _, hatch = series_style(satellite - 1, theme)
    phases = [
        (pair["pin"], start, stop)
        for pair in pairs
        if pair["satellite"] == satellite
        for start, stop in _phases(pair)
    ]
    words = "pair_carries" if "loaded_deg" in pairs[0] else "pair_drives"
    return {
        "type": "bar",
        "orientation": "h",
        "name": text("satellite", satellite=satellite),
        "y": [f"{satellite}.{pin}" for pin, _, _ in phases],
        "base": [round(start, 6) for _, start, _ in phases],
        "x": [round(stop - start, 6) for _, start, stop in phases],
        "customdata": [
            [satellite, pin, round(start, 4), round(stop, 4)] for pin, start, stop in phases
        ],
        "hovertemplate": hover(
            text(
                words,
                satellite="%{customdata[0]}",
                pin="%{customdata[1]}",
                start=Amount("%{customdata[2]}", "°"),
                end=Amount("%{customdata[3]}", "°"),
            )
        ),
        "marker": {
            "color": colour,
            "line": {"color": colour, "width": 1},
            "pattern": {"shape": hatch, "fillmode": "overlay", "size": 7},
        },
    }


def _outlines(pairs: list[Values], theme: Theme) -> Figure:
    """Ideal phases of all pairs, as thin outlines about the real ones."""
    phases = [
        (f"{pair['satellite']}.{pair['pin']}", start, stop)
        for pair in pairs
        for start, stop in pair["driving_deg"]
    ]
    return {
        "type": "bar",
        "orientation": "h",
        "name": text("ideal"),
        "meta": IDEAL,
        "y": [row for row, _, _ in phases],
        "base": [round(start, 6) for _, start, _ in phases],
        "x": [round(stop - start, 6) for _, start, stop in phases],
        "width": 0.94,
        "hoverinfo": "skip",
        "marker": {
            "color": "rgba(0, 0, 0, 0)",
            "line": {"color": INK[theme]["muted"], "width": 1},
        },
    }


def _ideal_count(intervals: list[Values], theme: Theme) -> Figure:
    """Ideal number of driving pairs, thin behind the real one."""
    own = _count(intervals, "driving_pairs", theme)
    line = own["line"] | {"width": 1, "dash": "dot"}
    return own | {"name": text("ideal"), "meta": IDEAL, "line": line, "fill": "none"}


def _count(intervals: list[Values], words: str, theme: Theme) -> Figure:
    """Number of pairs as a step line."""
    return {
        "type": "scatter",
        "mode": "lines",
        "name": text(words),
        "xaxis": "x",
        "yaxis": "y2",
        "showlegend": False,
        "x": [round(each["from_deg"], 6) for each in intervals]
        + [round(intervals[-1]["to_deg"], 6)],
        "y": [each["pairs"] for each in intervals] + [intervals[-1]["pairs"]],
        "line": {"shape": "hv", "width": 2, "color": INK[theme]["text"]},
        "fill": "tozeroy",
        "fillcolor": INK[theme]["grid"],
        "hovertemplate": hover(text(f"{words}_hover", pairs="%{y}", angle=Amount("%{x:.2f}", "°"))),
    }


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
