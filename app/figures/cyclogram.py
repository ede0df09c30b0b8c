"""The cyclogram: a bar for each driving phase, and the number of driving pairs under it."""

from app.figures.theme import INK, Figure, Theme, axis, layout, note, series_style
from app.schemas.base import Values


def cyclogram_figure(answer: Values, theme: Theme) -> Figure:
    """Cyclogram as papers draw it: pairs as rows, colour and hatch by satellite.

    Parameters
    ----------
    answer : dict
        The cyclogram, as `/cyclogram` answers.
    theme : {"light", "dark"}
        Look of the figure.

    Returns
    -------
    dict
        ``{data, layout}``.
    """
    end = answer["driving_count"][-1]["to_deg"]
    satellites = max(pair["satellite"] for pair in answer["pairs"])
    data = [_bars(answer, satellite, theme) for satellite in range(1, satellites + 1)]
    data.append(_count(answer, theme))
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
        }
        for place in answer["dead_centres_deg"]
    ]
    notes = [
        note(
            theme,
            "dead centre",
            x=place,
            y=1,
            xref="x",
            yref="paper",
            yanchor="bottom",
            font={"size": 11, "color": alert},
        )
        for place in answer["dead_centres_deg"][:1]
    ]
    turns = end / 360
    steps = {"dtick": 30 if turns <= 1 else 90} if turns <= 3 else {}
    return {
        "data": data,
        "layout": layout(
            theme,
            barmode="overlay",
            bargap=0.3,
            showlegend=satellites > 1,
            height=190 + 22 * len(rows),
            xaxis=axis(theme, "Crank angle, °", range=[0, end], anchor="y2", **steps),
            yaxis=axis(
                theme,
                "Satellite.pin",
                type="category",
                categoryorder="array",
                categoryarray=rows[::-1],
                domain=[0.3, 1],
                showgrid=False,
            ),
            yaxis2=axis(
                theme,
                "Driving",
                domain=[0, 0.22],
                rangemode="tozero",
                dtick=max(1, round(answer["max_driving"] / 4)),
                range=[0, answer["max_driving"] + 0.5],
            ),
            shapes=shapes,
            annotations=notes,
        ),
    }


def _bars(answer: Values, satellite: int, theme: Theme) -> Figure:
    """All driving phases of one satellite."""
    colour, _, hatch = series_style(satellite - 1, theme)
    phases = [
        (pair["pin"], start, stop)
        for pair in answer["pairs"]
        if pair["satellite"] == satellite
        for start, stop in pair["driving_deg"]
    ]
    return {
        "type": "bar",
        "orientation": "h",
        "name": f"Satellite {satellite}",
        "y": [f"{satellite}.{pin}" for pin, _, _ in phases],
        "base": [round(start, 6) for _, start, _ in phases],
        "x": [round(stop - start, 6) for _, start, stop in phases],
        "customdata": [
            [satellite, pin, round(start, 4), round(stop, 4)] for pin, start, stop in phases
        ],
        "hovertemplate": "satellite %{customdata[0]}, pin %{customdata[1]}<br>"
        "drives from %{customdata[2]}° to %{customdata[3]}°<extra></extra>",
        "marker": {
            "color": colour,
            "line": {"color": colour, "width": 1},
            "pattern": {"shape": hatch, "fillmode": "overlay", "size": 7},
        },
    }


def _count(answer: Values, theme: Theme) -> Figure:
    """Number of driving pairs as a step line."""
    intervals = answer["driving_count"]
    return {
        "type": "scatter",
        "mode": "lines",
        "name": "Driving pairs",
        "xaxis": "x",
        "yaxis": "y2",
        "showlegend": False,
        "x": [round(each["from_deg"], 6) for each in intervals]
        + [round(intervals[-1]["to_deg"], 6)],
        "y": [each["pairs"] for each in intervals] + [intervals[-1]["pairs"]],
        "line": {"shape": "hv", "width": 2, "color": INK[theme]["text"]},
        "fill": "tozeroy",
        "fillcolor": INK[theme]["grid"],
        "hovertemplate": "%{y} driving pairs at %{x:.2f}°<extra></extra>",
    }
