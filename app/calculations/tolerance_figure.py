"""Figure of the tolerance study."""

from itertools import pairwise
from typing import Any

from app.theme import (
    INK,
    Amount,
    Figure,
    Theme,
    axis,
    hover,
    layout,
    note,
    series_style,
    text,
    vertical_line,
)
from app.units import core_name, shown_unit


def tolerance_figure(name: str, quantity: dict[str, Any], theme: Theme) -> Figure:
    """Ranked contributions to a quantity of an API name, or its histogram with percentiles."""
    if "contributions" in quantity:
        return _ranked(quantity["contributions"], theme)
    return _histogram(name, quantity, theme)


def _bars(name: str, index: int, theme: Theme, **more: Any) -> Figure:
    colour, _, hatch = series_style(index, theme)
    pattern = {"shape": hatch, "fillmode": "overlay", "size": 7}
    line = {"color": colour, "width": 1}
    marker = {"color": colour, "line": line, "pattern": pattern}
    return {"type": "bar", "name": name, "marker": marker, **more}


def _histogram(name: str, quantity: dict[str, Any], theme: Theme) -> Figure:
    unit = shown_unit(name)
    histogram = quantity.get("histogram", {"edges": [], "counts": []})  # where no piece fits
    edges = [float(each) for each in histogram["edges"]]
    pairs = [*pairwise(edges)]
    low, high = (Amount(f"%{{customdata[{end}]:.5g}}", unit) for end in (0, 1))
    bars = _bars(
        text("pieces"),
        0,
        theme,
        x=[(start + end) / 2 for start, end in pairs],
        width=[end - start for start, end in pairs],
        y=[int(count) for count in histogram["counts"]],
        customdata=[[*pair] for pair in pairs],
        hovertemplate=hover(text("pieces_hover", pieces="%{y}", low=low, high=high)),
        showlegend=False,
    )
    marks = []
    if "nominal" in quantity:
        value = Amount(quantity["nominal"], unit, 5)
        marks.append((text("nominal", value=value), quantity["nominal"]))
    for each in quantity["percentiles"]:
        value = Amount(each["value"], unit, 5)
        words = text("percentile", percent=Amount(each["percent"]), value=value)
        marks.append((words, each["value"]))
    if "yield" in quantity:
        limit = quantity["yield"]["limit"]
        marks.append((text("limit", value=Amount(limit, unit, 5)), limit))
    notes = [
        note(theme, words, x=x, y=0.99 - 0.06 * row, yref="paper", xanchor="left", yanchor="top")
        for row, (words, x) in enumerate(marks)
    ]
    return {
        "data": [bars],
        "layout": layout(
            theme,
            height=420,
            bargap=0,
            xaxis=axis(theme, text(core_name(name)), unit),
            yaxis=axis(theme, text("pieces"), rangemode="tozero"),
            shapes=[vertical_line(theme, x, ink="text", layer="above") for _, x in marks],
            annotations=notes,
        ),
    }


def _ranked(ranked: list[dict[str, Any]], theme: Theme) -> Figure:
    rows = list(range(len(ranked)))
    data = []
    for index, (words, field) in enumerate((("share_in_all", "total"), ("share_alone", "first"))):
        shown = text(words)
        errors = {
            "type": "data",
            "array": [1.96 * each[f"{field}_error"] for each in ranked],
            "color": INK[theme]["text"],
            "thickness": 1,
        }
        data.append(
            _bars(
                shown,
                index,
                theme,
                orientation="h",
                x=[each[field] for each in ranked],
                y=rows,
                error_x=errors,
                hovertemplate=hover(text("mean_hover", name=shown, value=Amount("%{x:.3f}"))),
            )
        )
    names = [
        note(theme, text(core_name(each["source"])), x=0, xref="paper", y=row - 0.5,
             xanchor="left", yanchor="middle")
        for row, each in enumerate(ranked)
    ]  # fmt: skip
    return {
        "data": data,
        "layout": layout(
            theme,
            height=120 + 70 * len(ranked),
            barmode="group",
            bargap=0.4,
            xaxis=axis(theme, text("share_of_variance")),
            yaxis={
                **axis(theme, text("tolerances"), showticklabels=False, ticks="", showgrid=False),
                "range": [len(ranked) - 0.4, -0.8],
                "zeroline": False,
            },
            annotations=names,
        ),
    }
