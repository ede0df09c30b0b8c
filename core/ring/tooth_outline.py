"""Outlines of involute teeth: of a planet as its hob makes it, of a ring as its cutter does.

The root fillet of the planet is left by the round tip of the rack: the centre of that round lies d
below the pitch line of rack and planet, and the normal of the fillet passes through the pitch
point. The fillet of the ring is the path of the sharp corner of its cutter; without a cutter the
flanks go on to the assumed root circle. Angles count clockwise from the middle of a space, up.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from core.arrays import ComplexArray, FloatArray, check_positive, check_single
from core.errors import ImpossibleMechanism, InvalidInput
from core.precision import ROUNDING, SAME
from core.ring.involute import Cutter, InvolutePair, InvoluteTeeth
from core.ring.line_of_action import involute, roll
from core.ring.profile import MOST_POINTS

INNER = 16
"""Number of places between two points of a curve at which its distance from the chord is taken."""

BETWEEN = 1.02
"""Allowance for a larger distance between the `INNER` places."""

Curve = Callable[[FloatArray], ComplexArray]
"""Points of a curve at values of its parameter."""


@dataclass(frozen=True, slots=True)
class ToothOutline:
    """One pitch of a body: half a space, a tooth, half a space; all pitches are equal."""

    points: FloatArray  # clockwise about the axis from the middle of a space, up, m, shape (n, 2)
    teeth: int  # number of pitches
    chord_error: float  # largest distance of the outline from the polygon of the points, m

    @property
    def whole(self) -> ComplexArray:
        """Points x + i*y of all pitches, m."""
        pitch = self.points @ np.array([1, 1j])
        turned = np.exp(-2j * math.pi * np.arange(self.teeth) / self.teeth)
        found: ComplexArray = (turned[:, None] * pitch).ravel()
        return found


def satellite_outline(
    *, pair: InvolutePair, chord_error: float, most: int = MOST_POINTS
) -> ToothOutline:
    """One tooth of an involute planet with the fillets of its hob.

    Raises InvalidInput if the chord error needs more points, ImpossibleMechanism if the hob cuts
    away a part of the involute or the teeth are pointed below their tips. The chord error, m, > 0,
    is the largest distance of the outline from the polygon of its points, at most `most` of all
    teeth.

    >>> from core.ring.involute import InvoluteTeeth, involute_pair
    >>> teeth = InvoluteTeeth(satellite_teeth=40, ring_teeth=41, module=2.5e-3,
    ...                       satellite_profile_shift=0.0, ring_profile_shift=0.58,
    ...                       satellite_addendum=0.8, ring_addendum=0.8)
    >>> found = satellite_outline(pair=involute_pair(teeth=teeth), chord_error=1e-6)
    >>> radius = np.hypot(*found.points.T)
    >>> round(1e3*float(radius.min()), 6), round(1e3*float(radius.max()), 6)
    (46.875, 52.0)
    """
    teeth, line = pair.teeth, pair.line
    if pair.satellite_undercut or pair.satellite_tip_thickness < 0:
        raise ImpossibleMechanism("teeth_not_whole")
    return _pitch(
        teeth=teeth.satellite_teeth,
        chord_error=chord_error,
        most=most,
        curves=(
            (_hob_fillet(teeth), 0.0, math.pi / 2 - teeth.rack.pressure_angle),
            (
                _flank(
                    base=line.satellite_base,
                    half=math.pi / teeth.satellite_teeth - teeth.satellite_half_angle,
                    way=1,
                ),
                pair.form_roll_satellite,
                pair.end_roll,
            ),
        ),
    )


def ring_outline(
    *, pair: InvolutePair, chord_error: float, most: int = MOST_POINTS
) -> ToothOutline:
    """One tooth of an involute ring between half spaces, with the fillets of its cutter if given.

    Raises InvalidInput if the chord error needs more points, ImpossibleMechanism if the teeth are
    pointed below their tips, spaces above their roots, or the cutter is pointed or leaves no
    involute. Arguments are those of `satellite_outline`.
    """
    teeth, base = pair.teeth, pair.line.ring_base
    low = float(roll(teeth.ring_tip, base=base))
    flank = _flank(base=base, half=teeth.ring_half_angle, way=-1)
    curves: tuple[tuple[Curve, float, float], ...]
    if teeth.cutter is None:
        high = float(roll(pair.ring_root_radius, base=base))
        whole = teeth.ring_half_angle >= float(involute(math.atan(high)))
        curves = ((flank, high, low),)
    else:
        form = pair.ring_flank.form_roll
        corner, turned, whole = _cutter_corner(teeth, teeth.cutter, pair.ring_root_radius)
        whole = whole and form >= low
        curves = ((corner, 0.0, turned), (flank, form, low))
    if not whole or pair.ring_tip_thickness < 0:
        raise ImpossibleMechanism("teeth_not_whole")
    return _pitch(teeth=teeth.ring_teeth, chord_error=chord_error, most=most, curves=curves)


def _flank(*, base: float, half: float, way: int) -> Curve:
    """Involute by roll angles, from a clockwise angle ``half`` at the base circle; ``way`` is 1 for
    the flank of a tooth, -1 for that of a space.
    """

    def at(tau: FloatArray) -> ComplexArray:
        turned = half + way * (tau - np.arctan(tau))
        return np.asarray(1j * base * np.hypot(1, tau) * np.exp(-1j * turned))

    return at


def _hob_fillet(teeth: InvoluteTeeth) -> Curve:
    """Fillet that the round tip of a rack leaves, by the angle of its normal from straight down."""
    rack, module, pitch = teeth.rack, teeth.module, teeth.module * teeth.satellite_teeth / 2
    alpha, round_tip = rack.pressure_angle, rack.tip_radius
    below = rack.dedendum - round_tip
    aside = math.pi / 4 - below * math.tan(alpha) - round_tip / math.cos(alpha)
    d = (teeth.satellite_profile_shift - below) * module

    def at(angle: FloatArray) -> ComplexArray:
        rolled = -d * np.tan(angle)
        there = 1j * (pitch + d) + rolled - 1j * round_tip * module * np.exp(1j * angle)
        return np.asarray(there * np.exp(1j * (rolled - aside * module) / pitch))

    return at


def _cutter_corner(
    teeth: InvoluteTeeth, cutter: Cutter, ring_root: float
) -> tuple[Curve, float, bool]:
    """Path of the corner of a shaper cutter by the angle from the line of centres; angle where the
    path meets the flank; True if the cutter's teeth are not pointed.
    """
    alpha, shift = teeth.rack.pressure_angle, cutter.profile_shift
    tip = teeth.module * (cutter.teeth / 2 + shift + cutter.addendum)
    reached = float(roll(tip, base=teeth.module * cutter.teeth * math.cos(alpha) / 2))
    half = (math.pi / 2 + 2 * shift * math.tan(alpha)) / cutter.teeth + float(involute(alpha))
    land = half - float(involute(math.atan(reached)))
    distance, part = ring_root - tip, cutter.teeth / teeth.ring_teeth
    more = teeth.ring_teeth - cutter.teeth
    meshing = math.acos(min(1.0, teeth.module * more * math.cos(alpha) / (2 * distance)))

    def at(angle: FloatArray) -> ComplexArray:
        there = 1j * (distance + tip * np.exp(-1j * angle))
        return np.asarray(there * np.exp(1j * part * (angle - land)))

    return at, math.atan(reached) - meshing, land >= 0


def _pitch(
    *,
    teeth: int,
    chord_error: float,
    most: int,
    curves: tuple[tuple[Curve, float, float], ...],
) -> ToothOutline:
    """One pitch from curves between root and tip circle, joined by arcs, and their mirror."""
    check_single(chord_error=chord_error)
    check_positive(chord_error=chord_error)
    half = math.pi / teeth
    (opening, start, _), (closing, _, end) = curves[0], curves[-1]
    first, last = opening(np.array([start]))[0], closing(np.array([end]))[0]
    pieces = [
        (_arc(abs(first)), 0.0, _clockwise(first)),
        *curves,
        (_arc(abs(last)), _clockwise(last), half),
    ]
    each = most // (2 * teeth * len(pieces))
    if not each > 0:
        limit = most // (2 * len(pieces))
        raise InvalidInput("satellite_teeth", teeth, "less_than_equal", limit=limit)
    found = [
        _sampled(curve, low, high, chord_error, each)
        for curve, low, high in pieces
        if abs(high - low) > SAME * half
    ]
    error = max(error for _, error in found)
    if error > chord_error:
        raise InvalidInput("chord_error", chord_error, "greater_than_equal", limit=error)
    up = np.concatenate([points[:-1] for points, _ in found])  # without the middle of the tooth
    axis = 1j * np.exp(-1j * half)  # axis of symmetry of the tooth
    points = np.concatenate((up, [abs(last) * axis], np.conj(up[:0:-1] / axis) * axis))
    return ToothOutline(
        points=np.column_stack((points.real, points.imag)),
        teeth=teeth,
        chord_error=error + 4 * ROUNDING * float(np.abs(points).max()),
    )


def _clockwise(point: complex) -> float:
    """Angle of a point from straight up, clockwise, rad."""
    return math.atan2(point.real, point.imag)


def _arc(radius: float) -> Curve:
    """Circle about the axis, by the angle from straight up, clockwise."""
    return lambda turned: np.asarray(1j * radius * np.exp(-1j * turned))


def _sampled(
    curve: Curve, start: float, end: float, chord_error: float, most: int
) -> tuple[ComplexArray, float]:
    """Points of a curve, even in its parameter, and the largest distance from their chords, m,
    which exceeds ``chord_error`` if ``most`` pieces are too few.
    """
    count = 1
    while True:
        along = curve(np.linspace(start, end, count * INNER + 1))
        ends = along[::INNER]
        chords = np.diff(ends)[:, None]
        aside = along[:-1].reshape(count, INNER) - ends[:-1, None]
        error = BETWEEN * float(np.abs((aside * np.conj(chords)).imag / np.abs(chords)).max())
        if error <= chord_error or count == most:
            return ends, error
        count = min(most, max(count + 1, math.ceil(count * math.sqrt(error / chord_error))))
