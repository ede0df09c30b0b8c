"""Parts of a design as they are drawn: the satellites, the pins of their ring or its teeth.

All stand as they do at the crank angle 0, by their nominal sizes, X to the right, Y up through the
first pin of the output, as `core.output.mechanism` has them. The crank of satellite j points to
``phi_0 + alpha_j`` then, clockwise from Y, and the first pin of the ring to where a crank of the
angle 0 does, phi_0. A disc of z lobes has rolled anticlockwise by ``alpha_j/z``:

    C_j(t) = C(t)*exp(i*(alpha_j/z - phi_0)),  O_j = i*e*exp(-i*(phi_0 + alpha_j)),
    P_k = i*R_p*exp(i*(2*pi*k/z_p - phi_0)),   M_n = i*R*exp(2*pi*i*n/N),

with C of `core.ring.profile`, about the disc's centre O_j. About that all holes have their centres
at M_n: what differs is how the teeth are turned against them, by the assembly angle. Of involute
teeth a space of the ring stands where the first pin does, and at the crank angle of a satellite one
of its teeth in the middle of one: it has rolled by ``alpha_j/u``, from a space that is up by half a
pitch more.
"""

import math
from dataclasses import dataclass

import numpy as np

from core.arrays import ComplexArray, FloatArray
from core.design.document import Design
from core.design.refusals import named
from core.design.results import Results
from core.errors import ImpossibleMechanism, InvalidInput, NotKnown, if_known, required
from core.output.mechanism import pin_geometry
from core.ring.involute import InvolutePair
from core.ring.profile import MOST_POINTS, CycloidDisc, outline_points
from core.ring.sharing import CycloidMesh
from core.ring.tooth_outline import ring_outline, satellite_outline


@dataclass(frozen=True, slots=True)
class DrawnSatellite:
    """A satellite with its holes, about its own centre; lengths in m."""

    number: int  # j, from 1
    centre: tuple[float, float]  # O_j, of the disc about the axis of the reducer
    turn: float  # of its teeth from where a valley, or a space, is up, anticlockwise, rad
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
class DrawnRing:
    """An involute ring about the axis of the reducer; lengths in m."""

    teeth: int  # z_r
    outline: FloatArray  # closed polygon of its points, clockwise, shape (n, 2)
    chord_error: float  # how far the outline is from that at most
    reference_radius: float  # of its reference circle
    root_assumed: bool  # whether flanks go on to a root circle that no cutter says


@dataclass(frozen=True, slots=True)
class DrawnTeeth:
    """Involute satellites and their ring, about the axes of satellites and reducer; lengths in m.

    A pitch reaches from the middle of a space to the next but its end, clockwise: all others are
    the same.
    """

    lobe: FloatArray  # a pitch of a satellite, shape (n, 2)
    turns: tuple[float, ...]  # of each satellite from where a space is up, anticlockwise, rad
    ring_lobe: FloatArray  # a pitch of the ring, shape (n, 2)
    ring_turn: float  # of the ring likewise


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
    turned = required(gear.modification, "section_missing", "gear.modification").rotation
    if turned > 0:
        raise InvalidInput("gear.modification.rotation", turned, "flanks_not_drawn")
    difference = gear.teeth_difference or 1
    if difference > 1:  # the tips are cut off
        raise NotKnown("cycloid_difference", difference=difference)
    lobes, eccentricity = design.lobes, design.known_eccentricity
    return named(
        design, "gear", lambda: gear.disc(satellite_teeth=lobes, eccentricity=eccentricity)
    )


def drawn_pair(*, design: Design) -> InvolutePair:
    """The involute teeth of a design.

    Parameters
    ----------
    design : Design
        The design, with involute teeth.

    Returns
    -------
    InvolutePair

    Raises
    ------
    NotKnown
        If a size, profile shifts or heights are not known.
    InvalidInput
        If there are no such teeth.
    ImpossibleMechanism
        If nothing is known of such teeth.
    """
    try:
        return Results(design).ring.pair
    except NotKnown as why:
        if why.refusal is not None:
            raise why.refusal from why
        if not why.missing:
            raise ImpossibleMechanism(why.code, parameter="gear.kind") from why
        raise


def _refuse_in_pieces(
    *, roots: float, circle: float, holes: int, radius: float, bore: float
) -> None:
    """Refuse holes that break out of the roots of the teeth, into each other or into the bore, by
    their radii and that of their circle, m.
    """
    name, apart = "load.pin_circle_radius", radius / math.sin(math.pi / holes) if holes > 1 else 0.0
    if circle >= roots - radius:
        raise InvalidInput(name, circle, "less_than", limit=roots - radius)
    if circle <= apart:
        raise InvalidInput(name, circle, "greater_than", limit=apart)
    if bore >= circle - radius:
        raise InvalidInput("satellite_body.bore_radius", bore, "less_than", limit=circle - radius)


def drawn_satellites(
    *, design: Design, numbers: tuple[int, ...], chord_error: float
) -> tuple[DrawnSatellite, ...]:
    """Satellites of a design as they are drawn.

    Parameters
    ----------
    design : Design
        The design, with a ring of pins or involute teeth, pins of the output and their holes.
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
        If there is no such disc, it is undercut, its holes break out of it, or all would take more
        points than `core.ring.profile.MOST_POINTS`.
    ImpossibleMechanism
        See `core.ring.tooth_outline.satellite_outline`.
    """
    built, pair, involute = design.built, design.pair, design.gear.kind == "involute"
    most = MOST_POINTS // len(numbers)
    if involute:
        teeth = drawn_pair(design=design)
        eccentricity = teeth.line.eccentricity
    else:
        disc = drawn_disc(design=design)
        eccentricity = disc.eccentricity
    _ = design.known_clearance  # of a hole that is not made for perfect parts alone
    circle, start = design.load.pin_circle_radius, built.initial_crank_angle
    geometry = pin_geometry(
        mechanism=built,
        crank_angle=0.0,
        pin_circle_radius=circle,
        pin_radius=pair.pin_radius,
        hole_radius=pair.hole_radius,
        eccentricity=eccentricity,
    )
    if involute:
        tooth = named(
            design,
            "gear",
            lambda: satellite_outline(pair=teeth, chord_error=chord_error, most=most),
        )
        points, error = tooth.whole, tooth.chord_error
    else:
        own = named(
            design,
            "gear",
            lambda: outline_points(disc=disc, chord_error=chord_error, most=most),
        )
        points, error = own.points @ np.array([1, 1j]), own.chord_error
    bore = if_known(lambda: design.bore_radius)
    _refuse_in_pieces(
        roots=float(np.abs(points).min()),
        circle=circle,
        holes=built.pins,
        radius=pair.hole_radius,
        bore=bore or 0.0,
    )
    found = []
    for number in numbers:
        crank = built.crank_angles[number - 1]
        turn = _turn(design, crank)
        (centre,) = _plane(1j * eccentricity * np.exp(-1j * np.array([start + crank])))
        found.append(
            DrawnSatellite(
                number=number,
                centre=(float(centre[0]), float(centre[1])),
                turn=turn,
                outline=_plane(points * np.exp(1j * turn)),
                chord_error=error,
                hole_circle_radius=circle,
                hole_centres=geometry.pin_centres,
                hole_radius=pair.hole_radius,
                bore_radius=bore,
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
    disc, start = drawn_disc(design=design), design.built.initial_crank_angle
    step = 2 if design.cycloid.every_second_pin else 1
    around = 2 * math.pi * np.arange(0, disc.pins, step) / disc.pins - start
    return DrawnRingPins(
        circle_radius=disc.ring_pin_circle_radius,
        centres=_plane(1j * disc.ring_pin_circle_radius * np.exp(1j * around)),
        radius=disc.ring_pin_radius,
    )


def drawn_ring(*, design: Design, chord_error: float) -> DrawnRing:
    """The involute ring of a design as it is drawn.

    Parameters
    ----------
    design : Design
        The design, with involute teeth.
    chord_error : float
        How far the outline may be from the polygon of its points, m.

    Returns
    -------
    DrawnRing

    Raises
    ------
    NotKnown
        If a size, profile shifts or heights are not known.
    InvalidInput
        If there are no such teeth, or they would take too many points.
    ImpossibleMechanism
        See `core.ring.tooth_outline.ring_outline`.
    """
    pair, start = drawn_pair(design=design), design.built.initial_crank_angle
    pitch = named(design, "gear", lambda: ring_outline(pair=pair, chord_error=chord_error))
    return DrawnRing(
        teeth=pitch.teeth,
        outline=_plane(pitch.whole * np.exp(-1j * start)),
        chord_error=pitch.chord_error,
        reference_radius=pair.teeth.module * pitch.teeth / 2,
        root_assumed=pair.teeth.cutter is None,
    )


def drawn_teeth(*, design: Design, chord_error: float) -> DrawnTeeth:
    """A pitch of the involute satellites of a design and one of their ring, and how these stand.

    Parameters
    ----------
    design : Design
        The design, with involute teeth.
    chord_error : float
        How far an outline may be from the polygon of its points, m.

    Returns
    -------
    DrawnTeeth

    Raises
    ------
    CalculationError
        As `drawn_ring` and `drawn_satellites`.
    """
    pair, built = drawn_pair(design=design), design.built
    return DrawnTeeth(
        lobe=satellite_outline(pair=pair, chord_error=chord_error).points,
        turns=tuple(_turn(design, crank) for crank in built.crank_angles),
        ring_lobe=ring_outline(pair=pair, chord_error=chord_error).points,
        ring_turn=-built.initial_crank_angle,
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
    disc, made, built = mesh.disc, mesh.deviations, design.built
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
    """Of the teeth of a satellite at the crank angle 0, by the angle of its crank, rad: of a valley
    that faced the crank at first, or of a tooth that did.
    """
    half = math.pi / design.lobes if design.gear.kind == "involute" else 0.0
    return crank / design.mechanism.ratio + half - design.built.initial_crank_angle


def _plane(points: ComplexArray) -> FloatArray:
    """X and Y of points; a plain zero is not negative."""
    return np.column_stack((points.real, points.imag)) + 0.0
