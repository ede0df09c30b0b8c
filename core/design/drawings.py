"""Parts of a design as they are drawn: satellites, ring pins or ring teeth.

All parts are drawn without deviations at crank angle 0, with X to the right and Y up through the
first output pin, as in `core.output.mechanism`. The crank of satellite j points to ``phi_0 +
alpha_j``, clockwise from Y. The first ring pin lies at phi_0, where a crank of angle 0 points. A
disc of z lobes has rolled anticlockwise by ``alpha_j/z``:

    C_j(t) = C(t)*exp(i*(alpha_j/z - phi_0)),  O_j = i*e*exp(-i*(phi_0 + alpha_j)),
    P_k = i*R_p*exp(i*(2*pi*k/z_p - phi_0)),   M_n = i*R*exp(2*pi*i*n/N),

with C of `core.ring.profile` about the disc's centre O_j. The holes of every disc have their
centres at M_n about O_j; discs differ in the assembly angle of their teeth against the holes. An
involute ring has a tooth space at the place of the first pin, and a satellite has a tooth in the
middle of a space at its crank angle: the satellite has rolled by ``alpha_j/u`` from an upright
space, turned by half a pitch more.
"""

import math
from dataclasses import dataclass, replace
from functools import partial
from typing import Annotated, NamedTuple

import numpy as np

from core.arrays import ComplexArray, FloatArray
from core.design.diameters import Sizes, diameter_of
from core.design.document import Design
from core.design.refusals import named
from core.design.results import Results
from core.errors import (
    Accuracy,
    ImpossibleMechanism,
    InvalidInput,
    Notice,
    NotKnown,
    if_known,
    required,
)
from core.fields import Output, answer
from core.output.contact_force import force_ratios, reference_force
from core.output.mechanism import pin_geometry
from core.ring.involute import InvolutePair
from core.ring.mesh_curves import MeshCurves
from core.ring.profile import MOST_POINTS, CycloidDisc, outline_points
from core.ring.series_teeth import TeethInSeries
from core.ring.sharing import CycloidMesh
from core.ring.tooth_outline import ring_outline, satellite_outline

DRAWN_RING = 120
"""Least number of crank angles at which discs and ring are drawn."""

MAX_DRAWN_PAIRS = 240
"""Largest number of pairs of discs and ring that are drawn."""

DRAWN_ERROR = 1e-5
"""Chord error of the drawn outline, m."""


@dataclass(frozen=True, slots=True)
class DrawnHoles:
    """Holes of a satellite about its own centre; lengths in m."""

    circle_radius: float  # R of their centres
    centres: FloatArray  # anticlockwise from the hole of the first pin, shape (N, 2)
    radius: float  # r_out


@dataclass(frozen=True, slots=True)
class DrawnSatellite:
    """Satellite about its own centre; lengths in m."""

    number: int  # j, from 1
    centre: tuple[float, float]  # O_j, about the axis of the reducer
    turn: float  # rotation of the teeth from an upright valley or space, anticlockwise, rad
    outline: FloatArray  # closed polygon of its points, clockwise, shape (n, 2)
    chord_error: float  # largest distance of the outline from the polygon
    holes: DrawnHoles | None  # None if neither pins nor holes are given
    bore_radius: float | None  # None if not given


@dataclass(frozen=True, slots=True)
class DrawnRingPins:
    """Ring pins about the axis of the reducer; lengths in m."""

    circle_radius: float  # R_p of their centres
    centres: FloatArray  # P_k, anticlockwise from the first pin, shape (z_p, 2)
    radius: float  # r_p


@dataclass(frozen=True, slots=True)
class DrawnRing:
    """Involute ring about the axis of the reducer; lengths in m."""

    teeth: int  # z_r
    outline: FloatArray  # closed polygon of its points, clockwise, shape (n, 2)
    chord_error: float  # largest distance of the outline from the polygon
    reference_radius: float  # radius of the reference circle
    root_assumed: bool  # True if the root circle is assumed, as no cutter is given


class MadeRingPin(NamedTuple):
    """Ring pin as it is made, about the axis of the reducer."""

    pin: Annotated[int, Output("", "k")]
    """Number of the pin, from 1."""
    centre: Annotated[tuple[float, float], Output("mm", "P_k")]
    """Centre of the pin, X and Y."""
    radius: Annotated[float, Output("mm", "r")]
    """Radius of the pin."""


@dataclass(frozen=True, slots=True, kw_only=True)
class RingDrawing:
    """Satellites about their own axes and their ring as it is made. A lobe has no end point, as the
    next one begins there.
    """

    lobe: FloatArray | None = answer("mm", default=None, depth=2)
    """Points x, y of one lobe about the disc's centre, clockwise from a valley that points up. The
    other lobes are equal, and each begins at the end of the one before. The lobe of involute teeth
    reaches from the middle of a space to the middle of the next. The points are absent if flanks
    are turned, as the outline is not known."""
    ring_lobe: FloatArray | None = answer("mm", default=None, depth=2)
    """Points x, y of one tooth of an involute ring about the axis, from the middle of a space to
    the middle of the next; without a cutter flanks continue to the roots."""
    ring_turn: float | None = answer("deg", "", "−φ₀", default=None)
    """Angle of the involute ring from the position with a space pointing up, anticlockwise."""
    turn: tuple[float, ...] = answer("deg", "", "α_j/u − φ₀; of involute teeth π/z₂ more")
    """Angle of each disc at the crank angle 0, anticlockwise; over the turn it grows by the crank
    angle over the ratio."""
    ring_pins: tuple[MadeRingPin, ...] | None = answer(default=None)
    """Pins of the ring, if it is a ring of pins."""
    crank_angle: FloatArray | None = answer("deg", "φ", default=None)
    """Crank angles of forces and gaps, until the pattern repeats; absent, as are forces and gaps,
    if this takes too many angles."""
    repeats_after: float | None = answer("deg", default=None)
    """Crank angle after which forces and gaps repeat, at pins further on."""
    pins_further: int | None = answer(default=None)
    """Number of pins by which forces and gaps have moved on after that crank angle."""
    force: FloatArray | None = answer("N", "F_jk", default=None, depth=3)
    """Force of each ring pin at the crank angles, satellite by satellite."""
    gap: FloatArray | None = answer("mm", default=None, depth=3)
    """Gap between disc and ring pin under the torque; 0 if they press."""


class PlacedPin(NamedTuple):
    """Output pin with its centre."""

    pin: Annotated[int, Output("", "n")]
    """Number of the pin, from 1."""
    centre: Annotated[tuple[float, float], Output("mm", "M_n", "2021, before eq. 6")]
    """Centre of the pin, X and Y."""


class PlacedPair(NamedTuple):
    """Hole, contact point and pressure angle of one pair."""

    satellite: Annotated[int, Output("", "j")]
    """Number of the satellite, from 1."""
    pin: Annotated[int, Output("", "n")]
    """Number of the pin, from 1."""
    hole_centre: Annotated[tuple[float, float], Output("mm", "B_jn", "2021, before eq. 6")]
    """Centre of the hole, X and Y."""
    contact_point: Annotated[tuple[float, float], Output("mm", "E_jn", "2021, before eq. 6")]
    """Contact point, X and Y."""
    pressure_angle: Annotated[float, Output("deg", "γ_jn", "2021, eq. 6")]
    """Angle between the velocity of the pin and the force."""
    driving: Annotated[bool, Output()]
    """True if the pair transmits force."""
    force: Annotated[float, Output("N", "F_jn", "2021, eq. 10")]
    """Force of the pair."""


@dataclass(frozen=True, slots=True)
class PinsInHoles:
    """Pins and holes at one crank angle, with the forces of the pairs there."""

    clearance: float = answer("mm", "c")
    """Radius of the hole less that of the pin and less the eccentricity; negative for
    interference."""
    pins: tuple[PlacedPin, ...] = answer()
    """Pins in the order of their numbers."""
    pairs: tuple[PlacedPair, ...] = answer()
    """Pairs of pins and holes, satellite by satellite."""
    accuracy: Accuracy = answer()
    notices: tuple[Notice, ...] = answer()


def pins_in_holes(*, results: Results, crank_angle: float) -> PinsInHoles:
    """Output pins and holes at a crank angle, rad, with solved forces, or else ideal ones."""
    design = results.design
    pair, radius = design.nominal_pair, design.pin_circle_radius
    found = pin_geometry(
        mechanism=design.built,
        crank_angle=crank_angle,
        pin_radius=pair.pin_radius,
        hole_radius=pair.hole_radius,
        eccentricity=design.pin_fit.eccentricity,
        pin_circle_radius=radius,
    )
    if results.solved:
        forces = results.forces_at(crank_angle)
    else:
        reference = reference_force(output_torque=design.pin_torque, pin_circle_radius=radius)
        ratios = force_ratios(
            mechanism=design.driven,
            crank_angles=np.array([crank_angle]),
            force_exponent=design.load.force_exponent,
        )
        forces = (reference * ratios[0]).tolist()
    columns = (found.hole_centres, found.contact_points, found.pressure_angles)
    pairs = (
        PlacedPair(j, n, hole, contact, angle, force > 0, force)
        for j, discs in enumerate(zip(*(each.tolist() for each in columns), forces, strict=True), 1)
        for n, (hole, contact, angle, force) in enumerate(zip(*discs, strict=True), 1)
    )
    pins = (PlacedPin(n, centre) for n, centre in enumerate(found.pin_centres.tolist(), 1))
    return PinsInHoles(found.clearance, (*pins,), (*pairs,), found.accuracy, found.notices)


def drawn_disc(*, design: Design) -> CycloidDisc:
    """Cycloid disc of a design. `NotKnown` is raised if a size, the number of lobes or the
    modification is not known, or the difference of teeth is above 1; `InvalidInput` if the ring has
    no pins, the disc cannot exist or its flanks are rotated.
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
    """Involute teeth of a design. `NotKnown` is raised if a size, a profile shift or a tooth height
    is not known, `InvalidInput` if no such teeth exist, `ImpossibleMechanism` if the method does
    not cover them.
    """
    try:
        return Results(design).ring.pair
    except NotKnown as why:
        if why.refusal is not None:
            raise why.refusal from why
        if not why.missing:
            raise ImpossibleMechanism(why.code, parameter="gear.kind") from why
        raise


def _holes(
    *, design: Design, eccentricity: float, roots: float, bore: float, sizes: Sizes
) -> DrawnHoles | None:
    """Holes of a satellite, if pins or holes are given.

    Raises InvalidInput for holes that break into the tooth roots, each other or the bore, radii in
    m; NotKnown if a size of them is not known.
    """
    if not design.touching:
        return None
    _ = design.known_clearance  # refuses a hole of perfect parts, whose clearance is not known
    circle, pair, built = design.pin_circle_radius, design.pair, design.built
    holes, radius = built.pins, pair.hole_radius
    name, apart = "load.pin_circle_radius", radius / math.sin(math.pi / holes) if holes > 1 else 0.0
    if circle >= roots - radius:
        raise InvalidInput(name, circle, "less_than", limit=roots - radius)
    if circle <= apart:
        raise InvalidInput(name, circle, "greater_than", limit=apart)
    if bore >= circle - radius:
        raise InvalidInput("satellite_body.bore_radius", bore, "less_than", limit=circle - radius)
    geometry = pin_geometry(
        mechanism=built,
        crank_angle=0.0,
        pin_circle_radius=circle,
        pin_radius=pair.pin_radius,
        hole_radius=radius,
        eccentricity=eccentricity,
    )
    diameter = diameter_of(design, part="hole").drawn(sizes)
    return DrawnHoles(circle, geometry.pin_centres, diameter / 2)


def drawn_satellites(
    *,
    design: Design,
    numbers: tuple[int, ...],
    chord_error: float,
    sizes: Sizes = "nominal",
) -> tuple[DrawnSatellite, ...]:
    """Satellites of a design as they are drawn, without holes if no pins are given.

    Satellites are numbered from 1; the chord error is the largest distance of an outline from the
    polygon of its points, m; holes have nominal diameters or the middle of their limits. `NotKnown`
    is raised if a size is not known; `InvalidInput` if the disc cannot exist, is undercut, its
    holes break out of it, or all outlines need more than `core.ring.profile.MOST_POINTS` points;
    `ImpossibleMechanism` as by `core.ring.tooth_outline.satellite_outline`.
    """
    involute = design.gear.kind == "involute"
    most = MOST_POINTS // len(numbers)
    if involute:
        teeth = drawn_pair(design=design)
        eccentricity = teeth.line.eccentricity
    else:
        disc = drawn_disc(design=design)
        eccentricity = disc.eccentricity
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
    roots = float(np.abs(points).min())
    holes = _holes(
        design=design, eccentricity=eccentricity, roots=roots, bore=bore or 0.0, sizes=sizes
    )
    found, start = [], design.mechanism.initial_crank_angle
    for number in numbers:
        crank = design.crank_angles[number - 1]
        turn = _turn(design, crank)
        (centre,) = _plane(1j * eccentricity * np.exp(-1j * np.array([start + crank])))
        found.append(
            DrawnSatellite(
                number=number,
                centre=(float(centre[0]), float(centre[1])),
                turn=turn,
                outline=_plane(points * np.exp(1j * turn)),
                chord_error=error,
                holes=holes,
                bore_radius=bore,
            )
        )
    return tuple(found)


def drawn_ring_pins(*, design: Design, sizes: Sizes = "nominal") -> DrawnRingPins:
    """Ring pins of a design as they are drawn, of nominal diameter or the middle of its limits.

    Raises NotKnown if a size is not known, InvalidInput if no disc rolls on them.
    """
    disc, start = drawn_disc(design=design), design.mechanism.initial_crank_angle
    step = 2 if design.cycloid.every_second_pin else 1
    around = 2 * math.pi * np.arange(0, disc.pins, step) / disc.pins - start
    return DrawnRingPins(
        circle_radius=disc.ring_pin_circle_radius,
        centres=_plane(1j * disc.ring_pin_circle_radius * np.exp(1j * around)),
        radius=diameter_of(design, part="ring_pin").drawn(sizes) / 2,
    )


def drawn_ring(*, design: Design, chord_error: float) -> DrawnRing:
    """Involute ring of a design as it is drawn; `chord_error` in m as in `drawn_satellites`.

    `NotKnown` is raised if a size, a profile shift or a tooth height is not known; `InvalidInput`
    if no such teeth exist, or the outline needs too many points; `ImpossibleMechanism` as by
    `core.ring.tooth_outline.ring_outline`.
    """
    pair, start = drawn_pair(design=design), design.mechanism.initial_crank_angle
    pitch = named(design, "gear", lambda: ring_outline(pair=pair, chord_error=chord_error))
    return DrawnRing(
        teeth=pitch.teeth,
        outline=_plane(pitch.whole * np.exp(-1j * start)),
        chord_error=pitch.chord_error,
        reference_radius=pair.teeth.module * pitch.teeth / 2,
        root_assumed=pair.teeth.cutter is None,
    )


def ring_drawing(results: Results) -> RingDrawing | None:
    """Satellites in their ring, with curves of forces and gaps of ring pins under the torque; None
    for too many pairs, and for involute teeth without an outline.
    """
    design = results.design
    if design.gear.kind == "involute":
        return if_known(partial(_drawn_teeth, design))
    turn = results.ring.working[0]
    pairs = turn.mesh.disc.pins * design.mechanism.satellites
    if pairs > MAX_DRAWN_PAIRS:
        return None
    drawn = _drawn_mesh(design, turn.mesh)
    curves = MeshCurves.over_period(turn, DRAWN_RING)
    many = pairs * len(curves.crank_angle) > MAX_DRAWN_PAIRS * (DRAWN_RING + 1)
    if many and isinstance(turn, TeethInSeries):
        return drawn
    return replace(
        drawn,
        crank_angle=curves.crank_angle,
        repeats_after=curves.period,
        pins_further=curves.further,
        force=curves.force,
        gap=curves.gap,
    )


def _drawn_teeth(design: Design) -> RingDrawing:
    """Involute satellites and their ring; raises as `drawn_ring` does."""
    pair = drawn_pair(design=design)
    return RingDrawing(
        lobe=satellite_outline(pair=pair, chord_error=DRAWN_ERROR).points,
        turn=tuple(_turn(design, crank) for crank in design.crank_angles),
        ring_lobe=ring_outline(pair=pair, chord_error=DRAWN_ERROR).points,
        ring_turn=-design.mechanism.initial_crank_angle,
    )


def _drawn_mesh(design: Design, mesh: CycloidMesh) -> RingDrawing:
    """Discs on the pins of their ring, as `mesh` has them."""
    disc, made, start = mesh.disc, mesh.deviations, design.mechanism.initial_crank_angle
    lobe = None
    if disc.modification.rotation == 0:
        points = outline_points(disc=disc, chord_error=DRAWN_ERROR).points
        lobe = points[: len(points) // disc.satellite_teeth]
    radial, tangential, larger, *_ = made.each(pins=disc.pins, satellites=len(mesh.crank_angles))
    around = 2 * math.pi * np.arange(disc.pins) / disc.pins - start
    place = disc.ring_pin_circle_radius + np.array(radial) + 1j * np.array(tangential)
    centres = _plane(1j * place * np.exp(1j * around)).tolist()
    radii = (disc.ring_pin_radius + np.array(larger)).tolist()
    pins = enumerate(zip(centres, radii, strict=True), 1)
    return RingDrawing(
        lobe=lobe,
        turn=tuple(_turn(design, crank) for crank in design.crank_angles),
        ring_pins=tuple(MadeRingPin(k, centre, radius) for k, (centre, radius) in pins),
    )


def _turn(design: Design, crank: float) -> float:
    """Rotation of a satellite's teeth at crank angle 0, rad, by the angle of its crank: from a
    valley, or a tooth, that faced the crank at first.
    """
    half = math.pi / design.lobes if design.gear.kind == "involute" else 0.0
    return crank / design.mechanism.ratio + half - design.mechanism.initial_crank_angle


def _plane(points: ComplexArray) -> FloatArray:
    """X and Y of complex points, shape (n, 2), without negative zeros."""
    return np.column_stack((points.real, points.imag)) + 0.0
