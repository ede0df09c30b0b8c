"""Figures of the mesh of satellites with their ring: cycloid discs on pins, involute teeth."""

import math
from dataclasses import dataclass, replace
from typing import Self

import numpy as np

from app.theme import Amount, Chart, Figure, Theme, text
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
    below = 0.4 if shown.outlines else 0.0
    force_at, gap_at, peak_at, lag_at = (
        [below + (1 - below) * end for end in panel] for panel in PANELS
    )
    pins = np.arange(1, shown.mesh.disc.pins + 1).tolist()
    angles = from_si("angle_deg", shown.crank_angle)
    chart = Chart(theme, height=1180 if shown.outlines else 760)
    title = text("ring_pin", angle=Amount(float(from_si("angle_deg", shown.at)), "°", 4))
    chart.axis("x", title, anchor="y2", range=[0.5, len(pins) + 0.5])
    turn = [float(angles[0]), float(angles[-1])]
    chart.axis("x2", "crank_angle", "°", range=turn, anchor="y4")
    chart.axis("y", "contact_force", "N", domain=force_at, rangemode="tozero")
    chart.axis("y2", "gap", "µm", domain=gap_at, rangemode="tozero")
    chart.axis("y3", "peak_force", "N", domain=peak_at, anchor="x2", rangemode="tozero")
    chart.axis("y4", "lag", "′", domain=lag_at, anchor="x2")
    marked = {"mode": "lines+markers"}
    for words, rows, unit, axis, look in (
        ("ideal_ring_pin", shown.ideal, "N", "y", {"showlegend": False, "opacity": 0.4}),
        ("ring_pin_force", shown.force, "N", "y", marked),
        ("ring_pin_gap", shown.gap, "µm", "y2", marked | {"showlegend": False}),
    ):
        for j, row in enumerate(rows):
            hovered = text(words, satellite=j + 1, pin="%{x}", value=Amount("%{y:.5g}", unit))
            values = np.array(row) * (1e6 if unit == "µm" else 1.0)
            name = text("satellite", satellite=j + 1)
            chart.curve(name, pins, values, j, hovered, axis=axis, **look)
    own: Figure = {"showlegend": False}
    chart.curve("peak_force", angles, shown.largest, axis="y3", **own)
    for peak_angle, most in shown.peaks:
        chart.mark("peak", float(from_si("angle_deg", peak_angle)), most, axis="y3", **own)
    lags = [(text("lag"), shown.lag, 1)]
    for j, row in enumerate(shown.own_lag):
        lags.append((text("satellite_lag", satellite=j + 1), row, j))
    for index, (name, lag, colour) in enumerate(lags):
        row = from_si("lag_arcmin", lag)
        chart.curve(name, angles, row, index, axis="y4", colour=colour, **own)
    for outline in shown.outlines:
        _draw(chart, shown, *outline)
    return chart.figure


def _draw(chart: Chart, shown: ShownMesh, lag: float, points: FloatArray) -> None:
    """Draw the outline of the first disc, its pitch point, and the ring pins, with those that carry
    it in the colour of alerts.
    """
    mesh, phi = shown.mesh, shown.at + shown.mesh.crank_angles[0]
    disc = mesh.disc
    own: Figure = {"axis": "y5", "showlegend": False}
    equal: Figure = {"scaleanchor": "x3", "constrain": "domain", "anchor": "x3"}
    chart.axis("x3", "x", "mm", anchor="y5", constrain="domain")
    chart.axis("y5", "y", "mm", domain=[0, 0.33], **equal)
    crank = 1j * disc.eccentricity * np.exp(-1j * phi)
    turned = np.exp(1j * (phi / disc.satellite_teeth - lag))
    outline = points @ np.array([1, 1j]) * turned + crank
    closed = np.append(outline, outline[:1])
    x, y = from_si("points_mm", closed.real), from_si("points_mm", closed.imag)
    name, line = text("satellite", satellite=1), {"color": chart.ink["text"], "width": 1}
    chart.curve(name, x, y, 0, name, line=line, **own)
    pitch, name = crank * disc.pins, text("pitch_point")
    x, y = ([from_si("point_mm", part)] for part in (pitch.real, pitch.imag))
    chart.curve(name, x, y, 0, name, mode="markers", **own)
    circle, radius = disc.ring_pin_circle_radius, from_si("radius_mm", disc.ring_pin_radius)
    for k, force in enumerate(shown.force[0]):
        angle, ink = 2 * math.pi * k / disc.pins, "alert" if force > 0 else "muted"
        across, upward = (
            from_si("point_mm", part)
            for part in (-circle * math.sin(angle), circle * math.cos(angle))
        )
        look = {"line": {"color": chart.ink[ink], "width": 1}, "layer": "above"}
        place = {"xref": "x3", "yref": "y5", "y0": upward - radius, "y1": upward + radius}
        chart.shape("circle", across - radius, across + radius, **place, **look)


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
    chart = Chart(theme)
    chart.axis("x", "along_line", "mm")
    chart.axis("y", "contact_pressure", "MPa", rangemode="tozero")
    for code, places, pressures, index in (
        ("line_of_action", shown.line, shown.line_pressure, 1),
        ("path_of_contact", shown.path, shown.path_pressure, 0),
    ):
        x, y = from_si("places_mm", places), from_si("pressures_MPa", pressures)
        chart.curve(code, x, y, index)
    for (code, at), pressure in zip(shown.points.items(), shown.point_pressure, strict=True):
        x, y = float(from_si("place_mm", at)), float(from_si("pressure_MPa", pressure))
        chart.mark(code, x, y, symbol=SYMBOLS[code])
    return chart.figure
