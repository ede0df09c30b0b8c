"""The one look of all figures: light and dark, colour-blind safe, units on the axes.

Colours are those of Okabe and Ito, darkened for white and lightened for dark paper so that lines
keep a contrast of 3:1; dash and hatch patterns repeat what the colour says.
"""

from collections.abc import Sequence
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

Theme = Literal["light", "dark"]
Figure = dict[str, Any]
Numbers = Sequence[float] | NDArray[np.floating[Any]]

SERIES: dict[Theme, tuple[str, ...]] = {
    "light": ("#0072b2", "#b35900", "#007a5e", "#a3467f", "#5c6bc0", "#806600"),
    "dark": ("#5cb8f0", "#f0a04b", "#34c9a0", "#e39ac4", "#a5b0f5", "#e0cc4d"),
}
"""Colours of satellites, rollers and methods, in their order."""

DASHES = ("solid", "dash", "dot", "dashdot", "longdash", "longdashdot")
"""Line patterns that repeat what the colours say."""

HATCHES = ("", "/", "x", "-", "\\", ".")
"""Bar patterns that repeat what the colours say."""

INK: dict[Theme, dict[str, str]] = {
    "light": {"text": "#1c2733", "muted": "#5a6875", "grid": "#e3e8ed", "alert": "#b3261e"},
    "dark": {"text": "#e6edf3", "muted": "#9aa7b4", "grid": "#2b3642", "alert": "#ff8a80"},
}
"""Colours of text, of thin lines, of the grid, and of what must not be overlooked."""


TICKS = ".8~g"
"""Numbers at ticks: plain, or with an e where they are very large or small. (Plotly's own powers
of ten are raised by inline styles, which the page does not allow.)"""


def series_style(index: int, theme: Theme) -> tuple[str, str, str]:
    """Colour, dash and hatch of the series of an index, repeating after the last."""
    size = len(DASHES)
    return SERIES[theme][index % size], DASHES[index % size], HATCHES[index % size]


def axis(theme: Theme, title: str, **more: Any) -> Figure:
    """An axis with its title (unit included) in the look of the theme."""
    ink = INK[theme]
    return {
        "title": {"text": title, "font": {"size": 13}},
        "gridcolor": ink["grid"],
        "linecolor": ink["muted"],
        "zerolinecolor": ink["muted"],
        "ticks": "outside",
        "tickcolor": ink["muted"],
        "tickformat": TICKS,
        "automargin": True,
        **more,
    }


def layout(theme: Theme, **more: Any) -> Figure:
    """The layout every figure starts from."""
    return {
        "font": {"color": INK[theme]["text"], "family": "system-ui, sans-serif", "size": 12},
        "paper_bgcolor": "rgba(0,0,0,0)",
        "plot_bgcolor": "rgba(0,0,0,0)",
        "margin": {"l": 56, "r": 16, "t": 16, "b": 48},
        "hovermode": "closest",
        "legend": {"orientation": "h", "y": 1.02, "yanchor": "bottom", "x": 0},
        **more,
    }


def note(theme: Theme, text: str, **place: Any) -> Figure:
    """An annotation without arrow unless `place` says otherwise."""
    return {
        "text": text,
        "showarrow": False,
        "font": {"size": 12, "color": INK[theme]["text"]},
        **place,
    }


def vertical_line(theme: Theme, x: float, *, ink: str = "grid", **more: Any) -> Figure:
    """A thin vertical line over the whole height of the plot."""
    return {
        "type": "line",
        "xref": "x",
        "yref": "paper",
        "x0": x,
        "x1": x,
        "y0": 0,
        "y1": 1,
        "layer": "below",
        "line": {"color": INK[theme][ink], "width": 1},
        **more,
    }


def curve(
    name: str,
    x: Numbers,
    y: Numbers,
    index: int,
    theme: Theme,
    hover: str,
    *,
    colour: int | None = None,
    **more: Any,
) -> Figure:
    """A line in the style of its index (or another's colour), rounded to what a screen shows."""
    _, dash, _ = series_style(index, theme)
    ink, _, _ = series_style(index if colour is None else colour, theme)
    return {
        "type": "scatter",
        "mode": "lines",
        "name": name,
        "x": drawn(x),
        "y": drawn(y),
        "line": {"color": ink, "dash": dash, "width": 2},
        "hovertemplate": f"{hover}<extra></extra>",
        **more,
    }


def marker(name: str, x: float, y: float, theme: Theme, hover: str, **more: Any) -> Figure:
    """The user's own design, or a peak, on a curve."""
    return {
        "type": "scatter",
        "mode": "markers",
        "name": name,
        "x": [x],
        "y": [y],
        "marker": {
            "symbol": "diamond-open",
            "size": 12,
            "color": INK[theme]["alert"],
            "line": {"width": 2},
        },
        "hovertemplate": f"{hover}<extra></extra>",
        **more,
    }


def drawn(values: Numbers) -> NDArray[np.floating[Any]]:
    """Values in single precision where they fit: more than a screen shows, half the bytes."""
    if isinstance(values, np.ndarray) and values.dtype == np.float32:
        return values
    exact = np.asarray(values, dtype=np.float64)
    with np.errstate(over="ignore"):
        single = exact.astype(np.float32)
    return single if np.isfinite(single).all() else exact
