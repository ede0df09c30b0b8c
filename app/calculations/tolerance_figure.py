"""Figure of the tolerance study."""

from itertools import pairwise
from typing import Any

from app.theme import Amount, Chart, Figure, Theme, text
from app.units import core_name, shown_unit


def tolerance_figure(name: str, quantity: dict[str, Any], theme: Theme) -> Figure:
    """Ranked contributions to a quantity of an API name, or its histogram with percentiles."""
    if "contributions" in quantity:
        return _ranked(quantity["contributions"], theme)
    return _histogram(name, quantity, theme)


def _histogram(name: str, quantity: dict[str, Any], theme: Theme) -> Figure:
    unit, chart = shown_unit(name), Chart(theme, height=420, bargap=0)
    chart.axis("x", text(core_name(name)), unit)
    chart.axis("y", "pieces", rangemode="tozero")
    histogram = quantity.get("histogram", {"edges": [], "counts": []})  # where no piece fits
    pairs = [*pairwise(float(each) for each in histogram["edges"])]
    low, high = (Amount(f"%{{customdata[{end}]:.5g}}", unit) for end in (0, 1))
    chart.bars(
        "pieces",
        0,
        text("pieces_hover", pieces="%{y}", low=low, high=high),
        x=[(start + end) / 2 for start, end in pairs],
        width=[end - start for start, end in pairs],
        y=[int(count) for count in histogram["counts"]],
        customdata=[[*pair] for pair in pairs],
        showlegend=False,
    )
    marks = list[tuple[str, dict[str, Amount], float]]()
    if "nominal" in quantity:
        marks.append(("nominal", {}, quantity["nominal"]))
    for each in quantity["percentiles"]:
        marks.append(("percentile", {"percent": Amount(each["percent"])}, each["value"]))
    if "yield" in quantity:
        marks.append(("limit", {}, quantity["yield"]["limit"]))
    for row, (words, params, x) in enumerate(marks):
        place = {"x": x, "y": 0.99 - 0.06 * row, "yref": "paper"}
        said = text(words, value=Amount(x, unit, 5), **params)
        chart.note(said, **place, xanchor="left", yanchor="top")
    chart.verticals([x for _, _, x in marks], "text", layer="above")
    return chart.figure


def _ranked(ranked: list[dict[str, Any]], theme: Theme) -> Figure:
    height = 120 + 70 * len(ranked)
    chart = Chart(theme, height=height, barmode="group", bargap=0.4)
    chart.axis("x", "share_of_variance")
    bare: Figure = {"showticklabels": False, "ticks": "", "showgrid": False, "zeroline": False}
    chart.axis("y", "tolerances", range=[len(ranked) - 0.4, -0.8], **bare)
    for index, (words, field) in enumerate((("share_in_all", "total"), ("share_alone", "first"))):
        errors = [1.96 * each[f"{field}_error"] for each in ranked]
        look = {"type": "data", "color": chart.ink["text"], "thickness": 1}
        chart.bars(
            words,
            index,
            text("mean_hover", name=text(words), value=Amount("%{x:.3f}")),
            orientation="h",
            x=[each[field] for each in ranked],
            y=[*range(len(ranked))],
            error_x=look | {"array": errors},
        )
    for row, each in enumerate(ranked):
        place = {"x": 0, "xref": "paper", "y": row - 0.5}
        chart.note(text(core_name(each["source"])), **place, xanchor="left", yanchor="middle")
    return chart.figure
