"""The precessional gear: contact lines, wheel, line load, shaft."""

import math
from collections.abc import Sequence

from app.figures.theme import INK, Figure, Theme, axis, curve, layout, series_style, vertical_line
from app.schemas.base import Values
from app.units import from_si
from core.arrays import FloatArray
from core.precession.shaft import ShaftDiagram

MOST_NAMED = 12
"""Most rollers that a legend names."""


def contact_line_figure(
    answer: Values,
    roller_circle_radius_mm: float,
    roller_radius_mm: float,
    theme: Theme,
) -> Figure:
    """Contact lines developed on their rollers, and the wheel along its axis and from the side.

    Parameters
    ----------
    answer : ContactLineResponse
        The lines with their points, in mm and degrees.
    roller_circle_radius_mm, roller_radius_mm : float
        R_C and rho.
    theme : {"light", "dark"}
        Look of the figure.

    Returns
    -------
    dict
        ``{data, layout}``.
    """
    data, lines = [], answer["lines"]
    for index, line in enumerate(lines):
        points = line["points"]
        colour, _, _ = series_style(index, theme)
        name = f"φ₁ = {line['position_angle_deg']:g}°"
        group: Figure = {
            "legendgroup": str(index),
            "showlegend": len(lines) <= MOST_NAMED,
        }
        data.append(
            curve(
                name,
                points["x_mm"],
                points["z_mm"],
                index,
                theme,
                f"{name}, length {line['length_mm']:.5g} mm<br>"
                "x = %{x:.4g} mm, z = %{y:.4g} mm",
                **group,
            )
        )
        seen: Figure = {
            "xaxis": "x2",
            "yaxis": "y2",
            "legendgroup": str(index),
            "showlegend": False,
        }
        angle = math.radians(line["position_angle_deg"])
        x, y = _circle(
            -roller_circle_radius_mm * math.sin(angle),
            roller_circle_radius_mm * math.cos(angle),
            roller_radius_mm,
        )
        data.append(
            curve(name, x, y, index, theme, name, **seen) | {"line": {"color": colour, "width": 1}}
        )
        side = seen | {"xaxis": "x3"}
        middle = roller_circle_radius_mm * math.cos(angle)
        low, high = line["z_min_mm"], line["z_max_mm"]
        bottom, top = middle - roller_radius_mm, middle + roller_radius_mm
        data.append(
            curve(
                name,
                [low, high, high, low, low],
                [bottom, bottom, top, top, bottom],
                index,
                theme,
                name,
                **side,
            )
            | {"line": {"color": colour, "width": 1}}
        )
        across, upward, along = points["position_mm"].T
        for horizontal, view in ((across, seen), (along, side)):
            data.append(
                curve(name, horizontal, upward, index, theme, f"{name}: contact line", **view)
                | {"line": {"color": colour, "width": 4}}
            )
    x, y = _circle(0.0, 0.0, roller_circle_radius_mm)
    data.append(
        curve(
            "Roller circle",
            x,
            y,
            2,
            theme,
            "circle of the roller axes",
            xaxis="x2",
            yaxis="y2",
            showlegend=False,
        )
        | {"line": {"color": INK[theme]["muted"], "width": 1, "dash": "dot"}}
    )
    return {
        "data": data,
        "layout": layout(
            theme,
            height=820,
            xaxis=axis(theme, "Arc on the roller x = ρφ, mm", anchor="y"),
            yaxis=axis(theme, "Along the axis z, mm", domain=[0.6, 1]),
            xaxis2=axis(theme, "x, mm", anchor="y2", domain=[0, 0.62]),
            xaxis3=axis(theme, "z, mm", anchor="y2", domain=[0.7, 1]),
            yaxis2=axis(theme, "y, mm", domain=[0, 0.48], scaleanchor="x2"),
        ),
    }


def meshing_load_figure(
    curves: Sequence[tuple[float, FloatArray, FloatArray]], theme: Theme
) -> Figure:
    """Line load of every roller along the axis.

    Parameters
    ----------
    curves : sequence of (float, array, array)
        Position angle, rad, places, m, and load there, N/m, of each roller.
    theme : {"light", "dark"}
        Look of the figure.

    Returns
    -------
    dict
        ``{data, layout}``.
    """
    data = []
    for index, (angle, z, load) in enumerate(curves):
        name = f"φ₁ = {from_si('angle_deg', angle):g}°"
        data.append(
            curve(
                name,
                from_si("z_mm", z),
                from_si("load_N_per_mm", load),
                index,
                theme,
                f"{name}: %{{y:.4g}} N/mm at z = %{{x:.4g}} mm",
                showlegend=len(curves) <= MOST_NAMED,
            )
        )
    return {
        "data": data,
        "layout": layout(
            theme,
            height=340,
            xaxis=axis(theme, "Along the axis z, mm"),
            yaxis=axis(theme, "Line load, N/mm", rangemode="tozero"),
        ),
    }


def shaft_figure(diagram: ShaftDiagram, bearing_distance_mm: float, theme: Theme) -> Figure:
    """Shear force, bending moment and deflection along the shaft, in both planes.

    Parameters
    ----------
    diagram : ShaftDiagram
        Their course from C to the clamp, in SI units.
    bearing_distance_mm : float
        Distance a of B from C.
    theme : {"light", "dark"}
        Look of the figure.

    Returns
    -------
    dict
        ``{data, layout}``.
    """
    place = from_si("position_mm", diagram.position)
    panels = (
        ("Shear force, N", "shear_N", diagram.shear_force, [0.7, 1.0]),
        ("Bending moment, N·m", "moment_Nm", diagram.bending_moment, [0.36, 0.66]),
        ("Deflection, mm", "deflection_mm", diagram.deflection, [0.0, 0.32]),
    )
    data, axes = [], {}
    for row, (title, field, values, domain) in enumerate(panels, start=1):
        suffix = "" if row == 1 else str(row)
        axes[f"yaxis{suffix}"] = axis(theme, title, domain=domain)
        for plane, name in enumerate(("plane xz", "plane yz")):
            data.append(
                curve(
                    name,
                    place,
                    from_si(field, values[:, plane]),
                    plane,
                    theme,
                    f"{name}: %{{y:.5g}} at %{{x:.4g}} mm",
                    yaxis=f"y{suffix}",
                    showlegend=row == 1,
                )
            )
    return {
        "data": data,
        "layout": layout(
            theme,
            height=680,
            xaxis=axis(theme, "Along the shaft from C to the clamp, mm", anchor="y3"),
            **axes,
            shapes=[vertical_line(theme, bearing_distance_mm, ink="muted", layer="above")],
            annotations=[
                {
                    "text": name,
                    "x": x,
                    "y": 1,
                    "xref": "x",
                    "yref": "paper",
                    "yanchor": "bottom",
                    "showarrow": False,
                }
                for name, x in (("C", 0.0), ("B", bearing_distance_mm), ("clamp", place[-1]))
            ],
            legend={"orientation": "h", "y": 1.06, "yanchor": "bottom", "x": 0},
        ),
    }


def _circle(x: float, y: float, radius: float) -> tuple[list[float], list[float]]:
    """Points of a circle."""
    angles = [2 * math.pi * i / 48 for i in range(49)]
    return [x + radius * math.cos(a) for a in angles], [y + radius * math.sin(a) for a in angles]
