"""Parts of a design as they are drawn: the satellites and the pins of their ring.

All stand as they do at the crank angle 0, by their nominal sizes, X to the right, Y up through the
first pin of the output, as `core.output.pin_geometry` has them. The crank of satellite j points to
``phi_0 + alpha_j`` then, clockwise from Y, and the first pin of the ring to where a crank of the
angle 0 does, phi_0. A disc of z lobes has rolled anticlockwise by ``alpha_j/z``:

    C_j(t) = C(t)*exp(i*(alpha_j/z - phi_0)),  O_j = i*e*exp(-i*(phi_0 + alpha_j)),
    P_k = i*R_p*exp(i*(2*pi*k/z_p - phi_0)),   M_n = i*R*exp(2*pi*i*n/N),

with C of `core.ring.profile`, about the disc's centre O_j. About that all holes have their centres
at M_n: what differs is how the teeth are turned against them, by the assembly angle.
"""

import math
from dataclasses import dataclass

import numpy as np

from core.arrays import ComplexArray, FloatArray
from core.design.document import Design
from core.design.refusals import named
from core.errors import InvalidInput, NotKnown
from core.output.pin_geometry import pin_geometry
from core.ring.profile import MOST_POINTS, CycloidDisc, outline_points
from core.ring.sharing import CycloidMesh


@dataclass(frozen=True, slots=True)
class DrawnSatellite:
    """A cycloid disc with its holes, about its own centre; lengths in m."""

    number: int  # j, from 1
    centre: tuple[float, float]  # O_j, of the disc about the axis of the reducer
    turn: float  # of its teeth from where a valley is up, anticlockwise, rad
    outline: FloatArray  # closed polygon of its points, clockwise, shape (n, 2)
    chord_error: float  # how far the outline is from that at most
    hole_circle_radius: float  # R of the holes' centres
    hole_centres: FloatArray  # anticlockwise from the one of the first pin, shape (N, 2)
    hole_radius: float  # r_out
    bore_radius: float | None  # None where it is not given


@dataclass(frozen=True, slots=True)
class DrawnRingPins:
    """Pins of a ring about the axis of the reducer; lengths in m."""

    circle_radius: float  # R_p of their centres
    centres: FloatArray  # P_k, anticlockwise from the first one, shape (z_p, 2)
    radius: float  # r_p


@dataclass(frozen=True, slots=True)
class DrawnMesh:
    """Discs and the pins of their ring as they are made, about the axes of discs and reducer;
    lengths in m.
    """

    # Of one lobe, from a valley to the next but its end, clockwise, shape (n, 2): all others are
    # the same. None where no outline is known, of flanks that are turned.
    lobe: FloatArray | None
    turns: tuple[float, ...]  # of the teeth of each disc from where a valley is up, anticlockwise
    pin_centres: FloatArray  # with their deviations, anticlockwise, shape (z_p, 2)
    pin_radii: FloatArray  # likewise, shape (z_p,)


def drawn_disc(*, design: Design) -> CycloidDisc:
    """The cycloid disc of a design.

    Parameters
    ----------
    design : Design
        The design, with a ring of pins.

    Returns
    -------
    CycloidDisc

    Raises
    ------
    NotKnown
        If a size, the number of lobes, or by what the discs are modified is not known, or lobes are
        left out.
    InvalidInput
        If there is no such disc, or no outline of it is known.
    """
    gear = design.gear
    if gear.kind != "cycloid":
        raise InvalidInput("gear.kind", gear.kind, "no_tooth_form")
    if gear.modification is None:
        raise NotKnown("section_missing", "gear.modification")
    if gear.modification.rotation > 0:
        turned = gear.modification.rotation
        raise InvalidInput("gear.modification.rotation", turned, "flanks_not_drawn")
    difference = gear.teeth_difference or 1
    if difference > 1:  # the tips are cut off
        raise NotKnown("cycloid_difference", difference=difference)
    lobes, eccentricity = design.lobes, design.known_eccentricity
    return named(
        design, "gear", lambda: gear.disc(satellite_teeth=lobes, eccentricity=eccentricity)
    )


def drawn_satellites(
    *, design: Design, numbers: tuple[int, ...], chord_error: float
) -> tuple[DrawnSatellite, ...]:
    """Satellites of a design as they are drawn.

    Parameters
    ----------
    design : Design
        The design, with a ring of pins, pins of the output and their holes.
    numbers : tuple of int
        Which, from 1.
    chord_error : float
        How far an outline may be from the polygon of its points, m.

    Returns
    -------
    tuple of DrawnSatellite

    Raises
    ------
    NotKnown
        If a size is not known.
    InvalidInput
        If there is no such disc, it is undercut, or all would take more points than
        `core.ring.profile.MOST_POINTS`.
    """
    disc, built, pair = drawn_disc(design=design), design.mechanism.built, design.pair
    _ = design.known_clearance  # of a hole that is not made for perfect parts alone
    circle, start = design.load.pin_circle_radius, built.initial_crank_angle
    geometry = pin_geometry(
        mechanism=built,
        crank_angle=0.0,
        pin_circle_radius=circle,
        pin_radius=pair.pin_radius,
        hole_radius=pair.hole_radius,
        eccentricity=disc.eccentricity,
    )
    most = MOST_POINTS // len(numbers)
    own = named(
        design,
        "gear",
        lambda: outline_points(disc=disc, chord_error=chord_error, most=most),
    )
    points = own.points @ np.array([1, 1j])
    found = []
    for number in numbers:
        crank = built.crank_angles[number - 1]
        turn = _turn(design, crank)
        (centre,) = _plane(1j * disc.eccentricity * np.exp(-1j * np.array([start + crank])))
        found.append(
            DrawnSatellite(
                number=number,
                centre=(float(centre[0]), float(centre[1])),
                turn=turn,
                outline=_plane(points * np.exp(1j * turn)),
                chord_error=own.chord_error,
                hole_circle_radius=circle,
                hole_centres=geometry.pin_centres,
                hole_radius=pair.hole_radius,
                bore_radius=design.bore_radius,
            )
        )
    return tuple(found)


def drawn_ring_pins(*, design: Design) -> DrawnRingPins:
    """The pins of the ring of a design as they are drawn.

    Parameters
    ----------
    design : Design
        The design, with a ring of pins.

    Returns
    -------
    DrawnRingPins

    Raises
    ------
    NotKnown
        If a size is not known.
    InvalidInput
        If no disc rolls on them.
    """
    disc, start = drawn_disc(design=design), design.mechanism.built.initial_crank_angle
    step = 2 if design.gear.every_second_pin else 1
    around = 2 * math.pi * np.arange(0, disc.pins, step) / disc.pins - start
    return DrawnRingPins(
        circle_radius=disc.ring_pin_circle_radius,
        centres=_plane(1j * disc.ring_pin_circle_radius * np.exp(1j * around)),
        radius=disc.ring_pin_radius,
    )


def drawn_mesh(*, design: Design, mesh: CycloidMesh, chord_error: float) -> DrawnMesh:
    """The discs of a design on the pins of their ring.

    Parameters
    ----------
    design : Design
        The design.
    mesh : CycloidMesh
        Its discs and ring as they are made.
    chord_error : float
        How far an outline may be from the polygon of its points, m.

    Returns
    -------
    DrawnMesh
    """
    disc, made, built = mesh.disc, mesh.deviations, design.mechanism.built
    lobe = None
    if disc.modification.rotation == 0:
        points = outline_points(disc=disc, chord_error=chord_error).points
        lobe = points[: len(points) // disc.satellite_teeth]
    radial, tangential, larger, *_ = made.each(pins=disc.pins, satellites=len(mesh.crank_angles))
    around = 2 * math.pi * np.arange(disc.pins) / disc.pins - built.initial_crank_angle
    place = disc.ring_pin_circle_radius + np.array(radial) + 1j * np.array(tangential)
    return DrawnMesh(
        lobe=lobe,
        turns=tuple(_turn(design, crank) for crank in built.crank_angles),
        pin_centres=_plane(1j * place * np.exp(1j * around)),
        pin_radii=disc.ring_pin_radius + np.array(larger),
    )


def _turn(design: Design, crank: float) -> float:
    """Of the teeth of a disc at the crank angle 0, by the angle of its crank, rad."""
    return crank / design.lobes - design.mechanism.built.initial_crank_angle


def _plane(points: ComplexArray) -> FloatArray:
    """X and Y of points; a plain zero is not negative."""
    return np.column_stack((points.real, points.imag)) + 0.0
