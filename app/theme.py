"""Common look of all figures: light and dark, colour-blind safe, with units on the axes.

Colours are those of Okabe and Ito, darkened for white and lightened for dark paper so that lines
keep a contrast of 3:1; dash and hatch patterns repeat the information of colours.
"""

from collections.abc import Iterable, Iterator, Sequence
from functools import lru_cache
from typing import Any, Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from core.errors import METHODS
from core.work_precision.study import SETTINGS

Theme = Literal["light", "dark"]
Figure = dict[str, Any]
Numbers = Sequence[float] | NDArray[np.floating[Any]]

TEXTS = {
    "across_crank": "Across the crank",
    "across_first_crank": "Across, from angle 0 of the cranks",
    "along_arc": "Place along the arc of the pin",
    "along_axis": "Along the axis z",
    "along_crank": "Along the crank, to the axis",
    "along_first_crank": "Along angle 0 of the cranks",
    "along_line": "Along the line of action, from the satellite's base circle",
    "along_shaft": "Along the shaft from C to the clamp",
    "amount": "{amount}",
    "arc_on_roller": "Arc on the roller x = ρφ",
    "at_angle": "{name}: {value} at {angle}",
    "at_place": "{name}: {value} at {place}",
    "axis": "{title}, {unit}",
    "backlash_max": "Largest backlash",
    "bearing": "Bearing {letter}",
    "bearing_load": "Load of the bearing",
    "bending_moment": "Bending moment",
    "bending_stress": "Bending stress",
    "body_limit": "Limit of the {body}",
    "body_limit_hover": "Limit of the {body}: {pressure}",
    "clamp": "clamp",
    "conformal": "Conformal",
    "contact_force": "Contact force",
    "contact_line": "{name}: contact line",
    "contact_pressure": "Contact pressure",
    "crank_angle": "Crank angle",
    "crank_phase": "Crank phase",
    "dead_centre": "dead centre",
    "deflection": "Deflection",
    "design": "This design",
    "design_nonuniformity": "This design: Ψ = {nonuniformity} at δ = {error}",
    "design_stiffness": "This design: c/(b·E) = {stiffness}",
    "design_stress": "This design: {stress}, σ/E = {ratio}",
    "disc_phase": "Disc phase",
    "driving": "Driving",
    "driving_pairs": "Driving pairs",
    "driving_pairs_hover": "Driving pairs: {pairs} at {angle}",
    "eccentricity": "Eccentricity",
    "efficiency": "Efficiency",
    "equidistant": "Equidistant modification",
    "error_in_time": "{method}, {setting}<br>error {error} in {time}",
    "error_in_time_chosen": "{method}: error {error} in {time}",
    "equivalent_load": "Equivalent load",
    "gaps_times": "Gaps × {factor}",
    "hertz": "Hertz",
    "hole": "hole",
    "hole_diameter": "Hole diameter",
    "hole_position": "Position of the holes",
    "ideal": "Ideal",
    "ideal_ring_pin": "Satellite {satellite}, ring pin {pin}, ideal<br>{value}",
    "ideal_largest": "Largest force, ideal",
    "gap": "Gap under load",
    "ideal_pair_force": "Satellite {satellite}, pin {pin}, ideal<br>{force} at {angle}",
    "lag": "Lag of the output",
    "least_room": "Least room",
    "length_of_line": "{name}, length {length}<br>x = {x}, z = {z}",
    "length_ratio": "Length over diameter l/d",
    "limit": "limit {value}",
    "line_load": "Line load",
    "line_load_hover": "{name}: {load} at z = {place}",
    "line_of_action": "Line of action",
    "loaded": "Carrying",
    "loaded_pairs": "Pairs that carry",
    "loaded_pairs_hover": "Pairs that carry: {pairs} at {angle}",
    "locus_hover": "{name}: {along}, {across}",
    "loss": "Loss",
    "lost_motion": "Lost motion",
    "max_pressure": "Largest pressure",
    "mean_hover": "{name}: {value}",
    "mean_of": "{name}, mean",
    "mean_value": "mean {value}",
    "modification_pin_circle": "Modification of the circle",
    "moment_locus": "Moment over the turn",
    "moment_radial": "Moment by radial forces",
    "moment_tangential": "Moment by tangential forces",
    "nominal": "nominal {value}",
    "nonuniformity": "Non-uniformity Ψ",
    "nonuniformity_hover": "n = {rollers}: Ψ = {nonuniformity} at δ = {error}",
    "one_carries": "one roller carries all",
    "pair_carries": "Satellite {satellite}, pin {pin}<br>really carries from {start} to {end}",
    "pair_drives": "Satellite {satellite}, pin {pin}<br>drives from {start} to {end}",
    "pair_force": "Satellite {satellite}, pin {pin}<br>{force} at {angle}",
    "peak": "Peak",
    "peak_force": "Peak force",
    "peak_hover": "Peak {force} at {angle}<br>satellite {satellite}, pin {pin}",
    "percentile": "P{percent} = {value}",
    "path_end": "End of the path",
    "path_of_contact": "Path of contact",
    "path_start": "Start of the path",
    "pieces": "Pieces",
    "pieces_hover": "{pieces} pieces from {low} to {high}",
    "pin": "pin",
    "pin_diameter": "Pin diameter",
    "pin_position": "Position of the pins",
    "pitch_point": "Pitch point",
    "plane_xz": "plane xz",
    "plane_yz": "plane yz",
    "play_from": "Play, from",
    "play_to": "Play, to",
    "position_error": "Relative position error δ",
    "pressure_hover": "{name}<br>{pressure} at {place}",
    "reaction": "Reaction",
    "relative_error": "Relative error",
    "reverse_lag": "Lag under reverse torque",
    "ring_max_pressure": "Largest pressure on a pin of the ring",
    "ring_peak_force": "Largest force of a pin of the ring",
    "ring_pin": "Pin of the ring, at {angle}",
    "ring_pin_diameter": "Diameter of the ring's pins",
    "ring_pin_force": "Satellite {satellite}, ring pin {pin}<br>{value}",
    "ring_pin_gap": "Satellite {satellite}, ring pin {pin}: gap<br>{value}",
    "ring_pin_position": "Position of the ring's pins",
    "roller_angle": "φ₁ = {angle}",
    "roller_circle": "Circle of the roller axes",
    "room": "Room",
    "run_time": "Run time",
    "satellite": "Satellite {satellite}",
    "satellite_lag": "Lag of satellite {satellite}",
    "pair": "S{satellite} P{pin}",
    "pairs_of": "Satellite S, pin P",
    "share_alone": "Alone, S₁",
    "share_in_all": "With others, S_T",
    "share_of_variance": "Share of the variance",
    "shear_force": "Shear force",
    "stiffness": "Stiffness",
    "stiffness_hover": "c/(b·E) = {stiffness} at l/d = {length}",
    "stiffness_min": "Least stiffness",
    "stiffness_ratio": "Stiffness c/(b·E)",
    "stress_hover": "{name}: {stress}, σ/E = {ratio} at l/d = {length}",
    "tolerance": "χ = {tolerance} = {ratio}·d",
    "tolerances": "Tolerances, the largest first",
    "torque": "Torque",
    "torque_at_lag": "{torque} at a lag of {lag}",
    "torque_over_lag": "Torque over lag at {angle}",
    "transmission_error": "Transmission error",
    "used": "Used by the calculator",
    "worst_direction": "Worst direction",
}
"""Texts of figures in English, by id; the page has its own words for each id."""


_TEXTS = (
    TEXTS
    | {f"methods.{code}": words for code, words in METHODS.items()}
    | {f"settings.{code}": words for code, words in SETTINGS.items()}
)


class Amount(NamedTuple):
    """Number in a text, or Plotly's placeholder of one (``%{y:.4g}``), with its unit."""

    value: float | str  # number or placeholder
    unit: str = ""  # empty for none
    digits: int = 6  # significant digits shown

    def __format__(self, _: str) -> str:
        number = self.value if isinstance(self.value, str) else f"{self.value:.{self.digits}g}"
        return number + (self.unit if self.unit in ("", "°") else f" {self.unit}")


class Text(str):
    """Text of a figure in English, with `words`: id and parameters as sent for translation, where
    an `Amount` is an object and a text is its words.
    """

    words: list[Any]


@lru_cache(maxsize=4096, typed=True)
def text(id: str, **params: Any) -> Text:
    """Text by an id of `TEXTS`, or ``methods.`` or ``settings.`` before a code; `params` are
    numbers, `Amount` or other texts.
    """
    made = Text(_TEXTS[id].format(**params))
    made.words = [id, {name: _sent(value) for name, value in params.items()}]
    return made


def _sent(value: Any) -> Any:
    if isinstance(value, Amount):
        return value._asdict()
    return value.words if isinstance(value, Text) else value


def hover(words: str) -> str:
    """A hover text without the box for the trace's name beside it."""
    plain = f"{words}<extra></extra>"
    if not isinstance(words, Text):
        return plain
    made = Text(plain)
    made.words = words.words
    return made


def with_words(figure: Figure) -> Figure:
    """Figure with path, id and parameters of its texts in ``layout.meta.words``."""
    words = [[path, *each.words] for path, each in _texts(figure) if type(each) is Text]
    figure["layout"]["meta"] = {"words": words}
    return figure


def _texts(figure: Figure) -> Iterator[tuple[list[str | int], Any]]:
    """Values at all places for texts in a figure, with their paths."""
    for index, trace in enumerate(figure["data"]):
        for key in ("name", "hovertemplate"):
            yield ["data", index, key], trace.get(key)
        for row, each in enumerate(trace.get("customdata", ())):
            yield ["data", index, "customdata", row], each
    for key, part in figure["layout"].items():
        if "axis" in key:
            yield ["layout", key, "title", "text"], part["title"]["text"]
            for place, each in enumerate(part.get("ticktext", ())):
                yield ["layout", key, "ticktext", place], each
    for index, each in enumerate(figure["layout"].get("shapes", ())):
        yield ["layout", "shapes", index, "name"], each.get("name")
    for index, each in enumerate(figure["layout"].get("annotations", ())):
        yield ["layout", "annotations", index, "text"], each["text"]


LEGEND = {"orientation": "h", "y": 1.02, "yanchor": "bottom", "x": 0}
"""Place of the legend: above the plot."""

SERIES: dict[Theme, tuple[str, ...]] = {
    "light": ("#0072b2", "#b35900", "#007a5e", "#a3467f", "#5c6bc0", "#806600"),
    "dark": ("#5cb8f0", "#f0a04b", "#34c9a0", "#e39ac4", "#a5b0f5", "#e0cc4d"),
}
"""Colours of satellites, rollers and methods, in their order."""

DASHES = ("solid", "dash", "dot", "dashdot", "longdash", "longdashdot")
"""Line patterns that repeat the information of colours."""

HATCHES = ("", "/", "x", "-", "\\", ".")
"""Bar patterns that repeat the information of colours."""

INK: dict[Theme, dict[str, str]] = {
    "light": {"text": "#1c2733", "muted": "#5a6875", "grid": "#e3e8ed", "alert": "#b3261e"},
    "dark": {"text": "#e6edf3", "muted": "#9aa7b4", "grid": "#2b3642", "alert": "#ff8a80"},
}
"""Colours of text, thin lines, grid, and alerts."""


IDEAL = "ideal"
"""Value of `meta` of traces with ideal forces beside real ones."""

TICKS = ".8~g"
"""Numbers at ticks: plain, or with an e if very large or small. Plotly's own powers of ten are
raised by inline styles, which the page does not allow."""


def series_style(index: int, theme: Theme) -> tuple[str, str, str]:
    """Colour, dash and hatch of the series of an index, repeating after the last."""
    size = len(DASHES)
    return SERIES[theme][index % size], DASHES[index % size], HATCHES[index % size]


def shown(words: str) -> str:
    """Text of an id; any other text as it stands."""
    return text(words) if words in TEXTS else words


class Chart:
    """Figure in the making: axes, traces, and what stands beside them.

    An axis has the name that traces give it (`y2`); traces name their upright axis, and belong to
    the other one that this is anchored to. Titles and names are ids of `TEXTS`, or texts as they
    stand.
    """

    def __init__(self, theme: Theme, **look: Any) -> None:
        self.theme, self.ink = theme, INK[theme]
        self.traces: list[Figure] = []
        self.units: dict[str, str] = {}
        self.layout: Figure = {
            "font": {"color": self.ink["text"], "family": "system-ui, sans-serif", "size": 12},
            "paper_bgcolor": "rgba(0,0,0,0)",
            "plot_bgcolor": "rgba(0,0,0,0)",
            "margin": {"l": 56, "r": 16, "t": 16, "b": 48},
            "hovermode": "closest",
            "legend": LEGEND,
            "shapes": [],
            "annotations": [],
            **look,
        }

    @property
    def figure(self) -> Figure:
        """The figure for Plotly."""
        return {"data": self.traces, "layout": self.layout}

    def axis(self, name: str, title: str, unit: str = "", **more: Any) -> None:
        """Add an axis with its title and unit."""
        title = shown(title)
        words = text("axis", title=title, unit=unit) if unit else title
        self.units[name] = unit
        self.layout[f"{name[0]}axis{name[1:]}"] = {
            "title": {"text": words, "font": {"size": 13}},
            "gridcolor": self.ink["grid"],
            "linecolor": self.ink["muted"],
            "zerolinecolor": self.ink["muted"],
            "ticks": "outside",
            "tickcolor": self.ink["muted"],
            "tickformat": TICKS,
            "automargin": True,
            **more,
        }

    def trace(self, kind: str, name: str, hovered: str = "", axis: str = "y", **more: Any) -> None:
        """Add a trace of a type on an upright axis; without a text to show it says its numbers."""
        across = more.setdefault("xaxis", self.layout[f"yaxis{axis[1:]}"].get("anchor", "x"))
        name = shown(name)
        made = {"type": kind, "name": name, "yaxis": axis} | more
        if "hoverinfo" not in more:
            made["hovertemplate"] = hover(hovered or self._numbers(name, axis, across))
        self.traces.append(made)

    def _numbers(self, name: str, axis: str, across: str) -> Text:
        """Text of a point: its value, and its angle or place."""
        value, unit = Amount("%{y:.5g}", self.units[axis]), self.units[across]
        if unit == "°":
            return text("at_angle", name=name, value=value, angle=Amount("%{x:.2f}", unit))
        return text("at_place", name=name, value=value, place=Amount("%{x:.4g}", unit))

    def curve(
        self,
        name: str,
        x: Numbers,
        y: Numbers,
        index: int = 0,
        hovered: str = "",
        *,
        colour: int | None = None,
        line: Figure | None = None,
        **more: Any,
    ) -> None:
        """Add a line in the style of its index (or in another colour, or as `line` says), rounded
        to screen resolution.
        """
        _, dash, _ = series_style(index, self.theme)
        ink, _, _ = series_style(index if colour is None else colour, self.theme)
        # Plotly's simplification would leave out points until the curve shows corners.
        look = {"color": ink, "dash": dash, "width": 2, "simplify": False} | (line or {})
        points: Figure = {"mode": "lines", "x": drawn(x), "y": drawn(y), "line": look}
        self.trace("scatter", name, hovered, **points | more)

    def locus_and_turn(
        self, across: str, along: str, unit: str, over_turn: str, its_unit: str, **more: Any
    ) -> None:
        """Add axes of a locus at the left, and of what changes over the turn at the right."""
        self.axis("x", across, unit, domain=[0, 0.42])
        self.axis("y", along, unit, scaleanchor="x")
        self.axis("x2", "crank_angle", "°", domain=[0.58, 1], anchor="y2")
        self.axis("y2", over_turn, its_unit, anchor="x2", **more)

    def locus(self, name: str, x: Numbers, y: Numbers, index: int = 0, **more: Any) -> None:
        """Add a curve in a plane."""
        along, across = (Amount(f"%{{{each}:.5g}}", self.units[each]) for each in "xy")
        hovered = text("locus_hover", name=shown(name), along=along, across=across)
        self.curve(name, x, y, index, hovered, **more)

    def mark(self, name: str, x: float, y: float, hovered: str = "", **more: Any) -> None:
        """Add a mark of the user's own design, or of a peak, on a curve."""
        look: Figure = {
            "symbol": more.pop("symbol", "diamond-open"),
            "size": 12,
            "line": {"width": 2},
        }
        look["color"] = self.ink["alert"]
        # Whole at the ends of the axes too.
        point: Figure = {"mode": "markers", "x": [x], "y": [y], "cliponaxis": False, "marker": look}
        self.trace("scatter", name, hovered, **point | more)

    def bars(self, name: str, index: int, hovered: str = "", **more: Any) -> None:
        """Add bars in the style of their index."""
        colour, _, hatch = series_style(index, self.theme)
        pattern = {"shape": hatch, "fillmode": "overlay", "size": 7}
        look = {"color": colour, "line": {"color": colour, "width": 1}, "pattern": pattern}
        self.trace("bar", name, hovered, marker=look, **more)

    def shape(self, kind: str, start: float, stop: float, **more: Any) -> None:
        """Add a shape over the whole height of the plot, behind the curves."""
        across = {"x0": start, "x1": stop, "xref": "x"}
        upright = {"y0": 0, "y1": 1, "yref": "paper", "layer": "below"}
        self.layout["shapes"].append({"type": kind} | across | upright | more)

    def verticals(self, places: Iterable[float], ink: str = "grid", **more: Any) -> None:
        """Add thin vertical lines."""
        for x in places:
            self.shape("line", x, x, **{"line": {"color": self.ink[ink], "width": 1}} | more)

    def shaded(self, start: float, stop: float, **more: Any) -> None:
        """Add a stretch in the colour of alerts."""
        look: Figure = {"fillcolor": self.ink["alert"], "line": {"width": 0}}
        self.shape("rect", start, stop, **look | more)

    def note(self, words: str, **place: Any) -> None:
        """Add a text at a place."""
        font = {"size": 12, "color": self.ink["text"]}
        own = {"text": shown(words), "showarrow": False, "font": font}
        self.layout["annotations"].append(own | place)


def drawn(values: Numbers) -> NDArray[np.floating[Any]]:
    """Values in single precision if they fit: half the bytes, and more than a screen shows."""
    if isinstance(values, np.ndarray) and values.dtype == np.float32:
        return values
    exact = np.asarray(values, dtype=np.float64)
    with np.errstate(over="ignore"):
        single = exact.astype(np.float32)
    return single if np.isfinite(single).all() else exact
