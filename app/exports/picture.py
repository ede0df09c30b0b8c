"""Sheet of a drawing as an SVG picture: front view and section, without tables and notes."""

import math
from typing import Any

from app.exports.plot import drawing, tag
from app.exports.sheets import BEYOND, Outline, Sheet

THICK, THIN = 0.9, 0.45
"""Widths of lines, in thousandths of the picture's width."""

HATCH = 6.0
"""Distance between the lines of a hatching, likewise."""


def picture(sheet: Sheet) -> str:
    """Text of the picture of a sheet; its unit is a thousandth of its width."""
    reach = BEYOND * sheet.reach
    right = max((end for _, end in sheet.axes), default=reach)
    scale = 1000 / (right + reach)
    parts = [_outline(each, scale) for each in sheet.outlines]
    for each in sheet.circles:
        look = _look(each.hidden)
        parts.append(
            tag("circle", cx=scale * each.x, cy=-scale * each.y, r=scale * each.radius, **look)
        )
    centre = {
        "fill": "none",
        "stroke": "#000",
        "stroke_width": THIN,
        "stroke_dasharray": "12 2 2 2",
    }
    if sheet.pitch:
        parts.append(tag("circle", r=scale * sheet.pitch, **centre))
    axes = [(-reach, reach), *sheet.axes]
    path = "".join(f"M{scale * start:.1f} 0H{scale * end:.1f}" for start, end in axes)
    parts.append(tag("path", d=f"{path}M0 {-scale * reach:.1f}V{scale * reach:.1f}", **centre))
    line = tag("path", d=f"M0 0V{HATCH}", stroke="#000", stroke_width=THIN)
    turned = {"patternUnits": "userSpaceOnUse", "patternTransform": "rotate(45)"}
    hatch = tag("pattern", line, id="hatch", width=HATCH, height=HATCH, **turned)
    box = f"{-scale * reach:.0f} {-scale * reach:.0f} 1000 {2 * scale * reach:.0f}"
    return drawing(tag("defs", hatch) + "".join(parts), box)


def _look(hidden: bool, hatched: float = 0.0) -> dict[str, Any]:
    """Look of a line, which is dashed behind other parts, and of what is in it."""
    dashed = {"stroke_dasharray": "5 3"} if hidden else {}
    fill = "url(#hatch)" if hatched else "none"
    return {"fill": fill, "stroke": "#000", "stroke_width": THIN if hidden else THICK} | dashed


def _outline(outline: Outline, scale: float) -> str:
    """A closed outline of lines and arcs, with the diagonals of a bearing."""
    points = [(scale * x, -scale * y, bulge) for x, y, bulge in outline.points.tolist()]
    path = f"M{points[0][0]:.1f} {points[0][1]:.1f}"
    for (x, y, bulge), (to_x, to_y, _) in zip(points, [*points[1:], points[0]], strict=True):
        if bulge:
            radius = math.hypot(to_x - x, to_y - y) * (1 + bulge**2) / (4 * abs(bulge))
            path += f"A{radius:.2f} {radius:.2f} 0 {int(abs(bulge) > 1)} {int(bulge < 0)}"
        else:
            path += "L"
        path += f"{to_x:.1f} {to_y:.1f}"
    if outline.crossed:
        corners = [f"{x:.1f} {y:.1f}" for x, y, _ in points]
        path += "ZM{0}L{2}M{1}L{3}".format(*corners)
    return tag("path", d=path + "Z", **_look(outline.hidden, outline.hatched))
