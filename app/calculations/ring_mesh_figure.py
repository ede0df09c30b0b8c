"""Figures of the mesh of satellites with their ring: cycloid discs on pins, involute teeth."""

import math
from dataclasses import dataclass, replace
from typing import Self

import numpy as np

from app.theme import INK, Amount, Figure, Theme, axis, curve, layout, marker, text
from app.units import from_si
from core.arrays import FloatArray
from core.output.mechanism import Members
from core.ring.mesh_curves import MeshCurves
from core.ring.profile import outline_points
from core.ring.series_teeth import TeethInSeries
from core.ring.sharing import CycloidMesh, MeshTurn, mesh_gaps, mesh_position

Rows = tuple[tuple[float, ...], ...]

ANGLES = 360
"""Least number of crank angles of the curves."""

CHORD_ERROR = 1e-5
"""Chord error of the outline, m."""

SYMBOLS = {
    "path_start": "triangle-right-open",
    "path_end": "triangle-left-open",
    "pitch_point": "circle-open",
}
"""Symbols of the points of the path of contact."""

PANELS = (0.74, 1.0), (0.5, 0.68), (0.22, 0.4), (0.0, 0.18)
"""Places of the panels in the figure's height: forces and gaps over the pins, peak and lag."""


@dataclass(frozen=True, slots=True)
class ShownMesh:
    """Values that the figure shows, in SI units."""

    mesh: CycloidMesh
    at: float  # crank angle of forces and gaps
    force: FloatArray  # forces of all pairs there, shape (K, z_p)
    ideal: Rows  # forces of perfect parts there
    gap: FloatArray  # gaps left there under the torque
    crank_angle: FloatArray  # crank angles of the curves
    largest: FloatArray  # force at these
    lag: FloatArray  # lag of the output at these angles
    own_lag: FloatArray  # lags of the discs if they differ, shape (K or 0, n)
    # Crank angle and largest force over the turn, where it is known.
    peaks: tuple[tuple[float, float], ...] = ()
    # Lag of the first disc, and points of a disc, shape (n, 2), where it is drawn.
    outlines: tuple[tuple[float, FloatArray], ...] = ()

    @classmethod
    def at_peak(cls, turn: MeshTurn, members: Members) -> Self:
        """Mesh at its peak, without a disc; `turn` is of the ring alone or in series."""
        angle = turn.peak_crank_angle
        shown, _ = cls._of(turn, angle)
        lags = {name: members.angle_at_output(getattr(shown, name)) for name in ("lag", "own_lag")}
        return replace(shown, peaks=((angle, turn.peak_force),), **lags)

    @classmethod
    def at_angle(cls, turn: MeshTurn, crank_angle: float) -> Self:
        """Mesh of the ring alone at a crank angle, rad, with a disc."""
        shown, lag = cls._of(turn, crank_angle)
        points = outline_points(disc=turn.mesh.disc, chord_error=CHORD_ERROR).points
        return replace(shown, outlines=((lag, points),))

    @classmethod
    def _of(cls, turn: MeshTurn, angle: float) -> tuple[Self, float]:
        """Mesh at a crank angle, and the lag of the first disc there."""
        mesh, torque = turn.mesh, turn.turn.torque
        if isinstance(turn, TeethInSeries):  # the turn of the crank in which that is
            first = 2 * math.pi * (angle // (2 * math.pi))
            around = np.linspace(first, first + 2 * math.pi, ANGLES + 1)
            there, curves = MeshCurves(turn, np.array([angle])), MeshCurves(turn, around)
            force, gap, own = there.force[..., 0], there.gap[..., 0], curves.own_rotation
            lag = float(there.own_rotation[0, 0])
        else:
            found = mesh_position(mesh=mesh, crank_angle=angle, output_torque=torque)
            gaps = mesh_gaps(mesh=mesh, crank_angle=angle, rotation=found.rotation)
            force, gap = np.array(found.force), np.maximum(gaps, 0.0)
            curves, lag = MeshCurves.over_period(turn, ANGLES), found.rotation[0]
            own = np.zeros((0, len(curves.crank_angle)))
        perfect = mesh_position(mesh=mesh.perfect, crank_angle=angle, output_torque=torque)
        shown = cls(
            mesh=mesh,
            at=angle,
            force=force,
            ideal=perfect.force,
            gap=gap,
            crank_angle=curves.crank_angle,
            largest=curves.force.max(axis=(0, 1)),
            lag=curves.rotation,
            own_lag=own,
        )
        return shown, lag


def ring_mesh_figure(shown: ShownMesh, theme: Theme) -> Figure:
    """Force and gap over the ring pins at a crank angle, with forces of perfect parts thin behind;
    largest force and lag over a turn of the crank, in series the lag of each disc; first disc on
    its pins.
    """
    angle = Amount(float(from_si("angle_deg", shown.at)), "°", 4)
    pins = np.arange(1, shown.mesh.disc.pins + 1).tolist()
    data = []
    for words, rows, unit, place, look in (
        ("ideal_ring_pin", shown.ideal, "N", "y", {"showlegend": False, "opacity": 0.4}),
        ("ring_pin_force", shown.force, "N", "y", {"mode": "lines+markers"}),
        ("ring_pin_gap", shown.gap, "µm", "y2", {"mode": "lines+markers", "showlegend": False}),
    ):
        for j, row in enumerate(rows):
            hovered = text(words, satellite=j + 1, pin="%{x}", value=Amount("%{y:.5g}", unit))
            values = np.array(row) * (1e6 if unit == "µm" else 1.0)
            name = text("satellite", satellite=j + 1)
            data.append(
                curve(name, pins, values, j, theme, hovered, colour=j, **look) | {"yaxis": place}
            )
    at = Amount("%{x:.2f}", "°")
    angles = from_si("angle_deg", shown.crank_angle)
    own = {"xaxis": "x2", "showlegend": False}
    name = text("peak_force")
    hovered = text("at_angle", name=name, value=Amount("%{y:.5g}", "N"), angle=at)
    data.append(
        curve(name, angles, shown.largest, 0, theme, hovered, colour=0) | own | {"yaxis": "y3"}
    )
    name = text("peak")
    hovered = text("at_angle", name=name, value=Amount("%{y:.5g}", "N"), angle=at)
    for peak_angle, most in shown.peaks:
        there = float(from_si("angle_deg", peak_angle))
        data.append(marker(name, there, most, theme, hovered) | own | {"yaxis": "y3"})
    lags = [(text("lag"), shown.lag, 1)]
    for j, row in enumerate(shown.own_lag):
        lags.append((text("satellite_lag", satellite=j + 1), row, j))
    for index, (name, lag, colour) in enumerate(lags):
        hovered = text("at_angle", name=name, value=Amount("%{y:.5g}", "′"), angle=at)
        row = from_si("lag_arcmin", lag)
        drawn = curve(name, angles, row, index, theme, hovered, colour=colour)
        data.append(drawn | own | {"yaxis": "y4"})
    force_at, gap_at, peak_at, lag_at = PANELS
    more: Figure = {"height": 760}
    below = 0.0
    for outline in shown.outlines:
        data += _drawing(shown, *outline, theme)
        below = 0.4
        more = {
            "height": 1180,
            "shapes": _pins(shown, theme),
            "xaxis3": axis(theme, "x", "mm", anchor="y5", constrain="domain"),
            "yaxis5": axis(
                theme, "y", "mm", domain=[0, 0.33], anchor="x3", scaleanchor="x3",
                constrain="domain",
            ),
        }  # fmt: skip

    def domain(panel: tuple[float, float]) -> list[float]:
        return [below + (1 - below) * end for end in panel]

    return {
        "data": data,
        "layout": layout(
            theme,
            xaxis=axis(
                theme, text("ring_pin", angle=angle), anchor="y2", range=[0.5, len(pins) + 0.5]
            ),
            xaxis2=axis(
                theme, text("crank_angle"), "°", range=[float(angles[0]), float(angles[-1])],
                anchor="y4",
            ),
            yaxis=axis(
                theme, text("contact_force"), "N", domain=domain(force_at), rangemode="tozero"
            ),
            yaxis2=axis(theme, text("gap"), "µm", domain=domain(gap_at), rangemode="tozero"),
            yaxis3=axis(
                theme, text("peak_force"), "N", domain=domain(peak_at), anchor="x2",
                rangemode="tozero",
            ),
            yaxis4=axis(theme, text("lag"), "′", domain=domain(lag_at), anchor="x2"),
            **more,
        ),
    }  # fmt: skip


def _drawing(shown: ShownMesh, lag: float, points: FloatArray, theme: Theme) -> list[Figure]:
    """First disc: outline and pitch point."""
    mesh, phi = shown.mesh, shown.at + shown.mesh.crank_angles[0]
    disc, own = mesh.disc, {"xaxis": "x3", "yaxis": "y5", "showlegend": False}
    crank = 1j * disc.eccentricity * np.exp(-1j * phi)
    turned = np.exp(1j * (phi / disc.satellite_teeth - lag))
    outline = points @ np.array([1, 1j]) * turned + crank
    closed = np.append(outline, outline[:1])
    x, y = from_si("points_mm", closed.real), from_si("points_mm", closed.imag)
    name = text("satellite", satellite=1)
    line = {"color": INK[theme]["text"], "width": 1, "simplify": False}
    drawn = [curve(name, x, y, 0, theme, name) | own | {"line": line}]
    pitch = crank * disc.pins
    name = text("pitch_point")
    x, y = ([float(from_si("point_mm", part))] for part in (pitch.real, pitch.imag))
    return [*drawn, curve(name, x, y, 0, theme, name) | own | {"mode": "markers"}]


def _pins(shown: ShownMesh, theme: Theme) -> list[Figure]:
    """Ring pins, with those that carry the first disc in the colour of alerts."""
    disc, found = shown.mesh.disc, []
    radius = float(from_si("radius_mm", disc.ring_pin_radius))
    for k, force in enumerate(shown.force[0]):
        centre = disc.ring_pin_circle_radius * 1j * np.exp(2j * math.pi * k / disc.pins)
        x, y = (float(from_si("point_mm", part)) for part in (centre.real, centre.imag))
        ends = {"x0": x - radius, "x1": x + radius, "y0": y - radius, "y1": y + radius}
        line = {"color": INK[theme]["alert" if force > 0 else "muted"], "width": 1}
        found.append({"type": "circle", "xref": "x3", "yref": "y5", "line": line} | ends)
    return found


@dataclass(frozen=True, slots=True)
class DrawnPath:
    """Pressure along the line of action of involute teeth, in SI units; places are measured from
    the satellite's base circle.
    """

    line: FloatArray  # places from the start of the path or the pitch point to the last of them
    path: FloatArray  # places on the path of contact
    points: dict[str, float]  # start, end and pitch point, as far as their pressure is known
    line_pressure: FloatArray  # at these
    path_pressure: FloatArray
    point_pressure: FloatArray  # in their order


def path_figure(shown: DrawnPath, theme: Theme) -> Figure:
    """Pressure of one pair of involute teeth along the path of contact, up to the pitch point."""
    data, place = [], Amount("%{x:.4g}", "mm")
    for code, places, pressures, index in (
        ("line_of_action", shown.line, shown.line_pressure, 1),
        ("path_of_contact", shown.path, shown.path_pressure, 0),
    ):
        name = text(code)
        hovered = text("at_place", name=name, value=Amount("%{y:.5g}", "MPa"), place=place)
        x, y = from_si("places_mm", places), from_si("pressures_MPa", pressures)
        data.append(curve(name, x, y, index, theme, hovered))
    for (code, at), pressure in zip(shown.points.items(), shown.point_pressure, strict=True):
        name = text(code)
        hovered = text("at_place", name=name, value=Amount("%{y:.5g}", "MPa"), place=place)
        x, y = float(from_si("place_mm", at)), float(from_si("pressure_MPa", pressure))
        placed = marker(name, x, y, theme, hovered)
        placed["marker"]["symbol"] = SYMBOLS[code]
        data.append(placed)
    return {
        "data": data,
        "layout": layout(
            theme,
            xaxis=axis(theme, text("along_line"), "mm"),
            yaxis=axis(theme, text("contact_pressure"), "MPa", rangemode="tozero"),
        ),
    }
