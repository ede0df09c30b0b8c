"""Figures of the service as SVG pictures: lines, marks, bars and shapes of Plotly's figures."""

import math
from collections.abc import Iterator, Sequence
from html import escape
from typing import Any, NamedTuple

import numpy as np

from app.theme import INK, Figure, with_words
from app.words import Words

WIDTH = 340.0
"""Width of a picture, px; its letters have 8."""

FONTS = "Liberation Sans, Arial, DejaVu Sans, sans-serif"
"""Fonts of letters, each with those of all languages of the page."""

LETTER = 4.3
"""Mean width of a letter, px."""

LINE, ABOVE, BELOW, LEFT, RIGHT = 11.0, 11.0, 26.0, 34.0, 9.0
"""Height of a line of the legend, and room around panels, px."""

LEAST, SQUARE, BESIDE, SCALE = 35.0, 150.0, 84.0, 0.25
"""Least height of a panel, heights of one with equal scales, alone and beside another, px; height
of others over that on the screen."""

DASHES = {
    "dash": "6 3",
    "dot": "1.5 2.5",
    "dashdot": "6 2.5 1.5 2.5",
    "longdash": "11 3",
    "longdashdot": "11 2.5 1.5 2.5",
}
"""Dashes and gaps of lines, px."""

MARGIN, MORE = 0.05, 1.12
"""Room beyond curves over the span of their axis, and span of axes with equal scales over that."""

Trace = dict[str, Any]


class Axis(NamedTuple):
    """Scale of an axis within a panel."""

    low: float
    high: float
    size: float  # px
    upright: bool
    log: bool = False
    rows: Sequence[str] = ()  # names of an axis of names

    def at(self, value: Any) -> float:
        """Place of a value, px; not a number for one that has none."""
        number = self.rows.index(value) if self.rows else math.nan if value is None else value
        if self.log:
            number = math.log10(number) if number > 0 else math.nan
        share = (float(number) - self.low) / (self.high - self.low)
        return self.size * (1 - share if self.upright else share)

    def ticks(self) -> Iterator[Any]:
        """Values along the axis that are labelled: names, powers of ten, or round numbers."""
        rough = (self.high - self.low) / max(2.0, self.size / (22 if self.upright else 40))
        ten = 10.0 ** math.floor(math.log10(rough))
        step = next(each * ten for each in (1, 2, 2.5, 5, 10) if each * ten >= rough * 0.999)
        if self.high % 90 == 0 and 20 < rough <= 90:  # parts of a turn
            step = 45.0 if rough <= 45 else 90.0
        step = math.ceil(step) if self.log else step
        first, last = math.ceil(self.low / step - 1e-9), math.floor(self.high / step + 1e-9)
        places = (step * each for each in range(first, last + 1))
        yield from self.rows or (10.0**each if self.log else each for each in places)


class Plot:
    """Picture of a figure with its words in a language."""

    def __init__(self, figure: Figure, words: Words) -> None:
        self.layout, self.words = with_words(figure)["layout"], words
        self.traces: list[Trace] = figure["data"]
        self.parts: list[str] = []
        for path, id, params in self.layout["meta"]["words"]:
            part: Any = figure
            for name in path[:-1]:
                part = part[name]
            if "customdata" not in path and path[-1] != "hovertemplate":
                part[path[-1]] = words.drawn(id, params)

        self.height = self._drawn()
        self.svg = drawing("".join(self.parts), f"0 0 {WIDTH:g} {self.height:.0f}")

    def _drawn(self) -> float:
        """Draw legend and panels, and return their height."""
        top, rows = self._legend(), dict[float, list[tuple[str, str]]]()
        for pair in dict.fromkeys(map(_axes, self.traces)):
            rows.setdefault(self._domain(pair[1])[0], []).append(pair)
        for low in sorted(rows, reverse=True):
            top = self._row(rows[low], top)
        return top

    def _of(self, axis: str) -> dict[str, Any]:
        found: dict[str, Any] = self.layout[f"{axis[0]}axis{axis[1:]}"]
        return found

    def _domain(self, axis: str) -> tuple[float, float]:
        low, high = self._of(axis).get("domain", (0.0, 1.0))
        return low, high

    def _legend(self) -> float:
        """Draw the names of curves, and return the height of their lines."""
        left, base = 0.0, LINE
        shown = self.layout.get("showlegend", len(self.traces) > 1)
        named = {each["name"]: each for each in self.traces if each.get("showlegend", shown)}
        for name, trace in named.items() if shown else ():
            width = 30 + LETTER * len(name)
            if 0 < left > WIDTH - width:
                left, base = 0.0, base + LINE
            if trace["type"] == "bar":
                self._box(trace, left + 4, base - 7, 14, 6)
            elif "lines" in trace["mode"]:
                self._path(f"M{left:g} {base - 3:g}h18", trace["line"])
            else:
                self._diamond(left + 9, base - 3, trace)
            self._text(name, left + 22, base)
            left += width
        return base + 3 if left else 3.0

    def _row(self, pairs: list[tuple[str, str]], top: float) -> float:
        """Draw panels side by side, and return their lower end."""
        low, high = self._domain(pairs[0][1])
        rows = self._of(pairs[0][1]).get("categoryarray", ())
        height: float = max(
            LEAST, (high - low) * SCALE * self.layout.get("height", 450), 8.5 * len(rows)
        )
        if any(self._of(y).get("scaleanchor") for _, y in pairs):
            height = SQUARE if len(pairs) == 1 else BESIDE
        numbered = False
        for x, y in pairs:
            start, end = self._domain(x)
            width = (end - start) * WIDTH - LEFT - RIGHT
            below = len(pairs) > 1 or self._of(x).get("anchor", "y") == y
            numbered |= below
            self._panel((x, y), (start * WIDTH + LEFT, top + ABOVE, width, height), below)
        return top + ABOVE + height + (BELOW if numbered else 4.0)

    def _panel(
        self, axes: tuple[str, str], box: tuple[float, float, float, float], below: bool
    ) -> None:
        """Draw curves in a box with their axes, that of x with numbers if `below`."""
        (x, y), (left, top, width, height) = axes, box
        across, up = self._scales(axes, width, height)
        lines = [f"M{left + across.at(each):.1f} {top:.1f}v{height:.1f}" for each in across.ticks()]
        lines += [f"M{left:.1f} {top + up.at(each):.1f}h{width:.1f}" for each in up.ticks()]
        self._path("".join(lines), {"color": "#d5dbe1", "width": 0.8})
        self._path(f"M{left:.1f} {top:.1f}h{width:.1f}v{height:.1f}h{-width:.1f}Z", {"width": 1})
        named = dict(
            zip(self._of(y).get("tickvals", ()), self._of(y).get("ticktext", ()), strict=True)
        )
        for each in up.ticks():
            said = named.get(each) or self.words.number(each)
            self._text(said, left - 3, top + up.at(each) + 2.8, "end")
        for each in across.ticks() if below else ():
            self._text(self.words.number(each), left + across.at(each), top + height + 9, "middle")
        self._text(self._of(y)["title"]["text"], left - LEFT, top - 3)
        if below:
            said = self._of(x)["title"]["text"]
            self._text(said, left + width / 2, top + height + 19, "middle")
        around, self.parts = self.parts, []
        for shape in self.layout.get("shapes", ()):
            if shape["xref"] == x and shape["yref"] in (y, f"{y} domain", "paper"):
                self._shape(shape, across, up, own=shape["yref"] == y)
        for trace in self.traces:
            if _axes(trace) == axes:
                self._curve(trace, across, up)
        for note in self.layout.get("annotations", ()):
            if note["xref"] == x and (
                note["yref"] in (y, f"{y} domain") or (note["yref"], y) == ("paper", "y")
            ):
                self._note(note, across, up, own=note["yref"] == y)
        inner = tag("svg", "".join(self.parts), x=left, y=top, width=width, height=height)
        self.parts = [*around, inner]

    def _scales(self, axes: tuple[str, str], width: float, height: float) -> tuple[Axis, Axis]:
        """Scales of a panel, of equal lengths if the figure asks for that."""
        x, y = axes
        across = self._axis(x, [each for each in self.traces if _axes(each)[0] == x], width)
        up = self._axis(y, [each for each in self.traces if _axes(each)[1] == y], height)
        if not self._of(y).get("scaleanchor"):
            return across, up
        unit = MORE * max((each.high - each.low) / each.size for each in (across, up))
        middles = (
            (each, (each.low + each.high) / 2, unit * each.size / 2) for each in (across, up)
        )
        across, up = (
            each._replace(low=middle - half, high=middle + half) for each, middle, half in middles
        )
        return across, up

    def _axis(self, name: str, traces: list[Trace], size: float) -> Axis:
        own, upright = self._of(name), name[0] == "y"
        if rows := own.get("categoryarray"):
            return Axis(-0.5, len(rows) - 0.5, size, upright, rows=rows)
        log, zero = own.get("type") == "log", own.get("rangemode") == "tozero"
        curves = [each[name[0]] for each in traces if each["type"] == "scatter"]
        values = np.concatenate([np.asarray(each, dtype=float) for each in curves])
        values = np.log10(values[values > 0]) if log else values[np.isfinite(values)]
        low, high = float(values.min()), float(values.max())
        room = (high - low) * MARGIN or abs(high) * MARGIN or 1.0
        if upright or low == high:
            low, high = (0.0 if zero and low >= 0 else low - room), high + room
        low, high = own.get("range") or (low, high)
        return Axis(float(low), float(high), size, upright, log)

    def _curve(self, trace: Trace, across: Axis, up: Axis) -> None:
        """Draw a line, marks or bars."""
        if trace["type"] == "bar":
            half = up.size / len(up.rows) * trace.get("width", 0.7) / 2
            for row, start, length in zip(trace["y"], trace["base"], trace["x"], strict=True):
                left, right = across.at(start), across.at(start + length)
                self._box(trace, left, up.at(row) - half, right - left, 2 * half)
            return
        points = [(across.at(x), up.at(y)) for x, y in zip(trace["x"], trace["y"], strict=True)]
        if "lines" in trace["mode"]:
            path = _line(points, trace["line"].get("shape") == "hv")
            self._path(path, trace["line"], trace.get("opacity", 1))
        for x, y in points if "markers" in trace["mode"] else ():
            if "lines" in trace["mode"]:
                self._path(f"M{x - 1:.1f} {y:.1f}h2", trace["line"] | {"dash": "solid", "width": 5})
            else:
                self._diamond(x, y, trace)

    def _shape(self, shape: Trace, across: Axis, up: Axis, *, own: bool) -> None:
        """Draw a line, a rectangle or a circle, over the whole height unless it is its own."""
        left, right = across.at(shape["x0"]), across.at(shape["x1"])
        low, high = (up.at(shape["y0"]), up.at(shape["y1"])) if own else (up.size, 0.0)
        if shape["type"] == "line":
            self._path(f"M{left:.1f} {low:.1f}L{right:.1f} {high:.1f}", shape["line"])
            return
        fill, curved = shape.get("fillcolor", "none"), shape["type"] == "circle"
        size = {"x": left, "y": high, "width": right - left, "height": low - high}
        round_ends = {"rx": (right - left) / 2, "stroke": shape["line"].get("color")}
        own_ends = round_ends if curved else {"opacity": shape["opacity"]}
        self.parts.append(tag("rect", fill=fill, **size, **own_ends))

    def _note(self, note: Trace, across: Axis, up: Axis, *, own: bool) -> None:
        """Write a note at its place, or at the upper or lower edge."""
        x, y = (
            across.at(note["x"]),
            up.at(note["y"]) - 4 if own else 8 if note["y"] else up.size - 3,
        )
        anchor = {"left": "start", "right": "end"}.get(note.get("xanchor", ""), "middle")
        length = LETTER * len(note["text"])
        anchor = "start" if x < length / 2 else "end" if x + length > across.size else anchor
        self._text(note["text"], x + {"start": 3, "end": -3, "middle": 0}[anchor], y, anchor)

    def _diamond(self, x: float, y: float, trace: Trace) -> None:
        colour = trace.get("marker", {}).get("color", INK["light"]["text"])
        self._path(f"M{x - 4:.1f} {y:.1f}l4 -4l4 4l-4 4Z", {"color": colour, "width": 2.4})

    def _box(self, trace: Trace, x: float, y: float, width: float, height: float) -> None:
        line, fill = trace["marker"]["line"]["color"], trace["marker"]["color"]
        fill = "none" if fill.startswith("rgba") else fill
        size = {"x": x, "y": y, "width": width, "height": height}
        self.parts.append(tag("rect", fill=fill, stroke=line, stroke_width=0.6, **size))

    def _path(self, path: str, line: Trace, opacity: float = 1) -> None:
        look: dict[str, Any] = {"stroke_dasharray": DASHES.get(line.get("dash", "solid"))}
        look |= {"opacity": opacity} if opacity != 1 else {}
        colour, width = line.get("color", INK["light"]["muted"]), 0.6 * line.get("width", 2)
        drawn = tag("path", d=path, fill="none", stroke=colour, stroke_width=width, **look)
        self.parts.append(drawn)

    def _text(self, text: str, x: float, y: float, anchor: str = "start") -> None:
        self.parts.append(tag("text", escape(text), x=x, y=y, text_anchor=anchor))


def drawing(content: str, box: str) -> str:
    """SVG picture of a content in a box, in a small sans-serif letter."""
    look = {"font_size": 8, "font_family": FONTS, "fill": "#000"}
    return tag("svg", content, xmlns="http://www.w3.org/2000/svg", viewBox=box, **look)


def tag(name: str, content: str = "", /, **given: Any) -> str:
    """Element of an SVG picture with those attributes that are not None."""
    shown = ""
    for key, each in given.items():
        digits = ".3g" if key in ("opacity", "stroke_width") else ".1f"
        if each is not None:
            value = f"{each:{digits}}" if isinstance(each, float) else each
            shown += f' {key.replace("_", "-")}="{value}"'
    return f"<{name}{shown}>{content}</{name}>"


def _axes(trace: Trace) -> tuple[str, str]:
    return trace.get("xaxis") or "x", trace.get("yaxis") or "y"


def _line(points: list[tuple[float, float]], step: bool) -> str:
    """Path through points, with gaps where there are none."""
    path, pen = "", "M"
    for x, y in points:
        known = math.isfinite(x + y)
        path += f"H{x:.1f}" if known and step and pen == "L" else ""
        path += f"{pen}{x:.1f} {y:.1f}" if known else ""
        pen = "L" if known else "M"
    return path
