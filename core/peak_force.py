"""Exact peak of the contact force over the turn, for any force exponent.

At any position the pair with the largest cosine of the pressure angle carries the most. Between
the angles at which a pair starts or stops driving, or another pair becomes the best placed,
everything is smooth: there the peak is found exactly, and the largest of these is the peak over
the turn.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from core.contact_force import FloatArray, check_exponent, refuse_dead_centre
from core.driving_set import DrivingSet, cosine, segments
from core.mechanism import SAME_PHASE, Mechanism, WavePhases
from core.results import ROUNDING, Accuracy


@dataclass(frozen=True, slots=True)
class PeakForce:
    """Largest contact force of any pair over the turn.

    Attributes
    ----------
    peak_force_ratio : float
        Peak force over the reference force F0, dimensionless.
    peak_crank_angle : float
        Smallest crank angle >= 0 at which it is reached, rad.
    peak_satellite, peak_pin : int
        Numbers of the pair that carries it there, from 1.
    accuracy : Accuracy
        Of `peak_force_ratio`.
    """

    peak_force_ratio: float
    peak_crank_angle: float
    peak_satellite: int
    peak_pin: int
    accuracy: Accuracy


def peak_force(*, mechanism: Mechanism, force_exponent: float = 1.0) -> PeakForce:
    """Exact peak of the contact force over the turn, with its position and its pair.

    Between two neighbouring switching angles the set of driving pairs is constant; within it
    the best placed pair p has ``f = cos(x)^v / sum cos(x + d_i)^(1 + v)`` where x is its own
    pressure angle and d_i are the phases of the others against it. With t = tan(x) the
    stationary points for v = 1 are the roots of ``P*t^3 + (3*P - n)*t - 2*Q = 0``,
    ``P = sum sin^2 d_i``, ``Q = sum sin d_i cos d_i``; for v = 0 there is none inside, and the
    peak lies on a switching angle. One-sided values at the switching angles count.

    Parameters
    ----------
    mechanism : Mechanism
        Pins, satellites, ratio.
    force_exponent : float
        Exponent v of the force over the approach, from 0 to `MAX_FORCE_EXPONENT`.

    Returns
    -------
    PeakForce

    Raises
    ------
    InvalidInput
        If the exponent is negative or above `MAX_FORCE_EXPONENT`.
    ImpossibleMechanism
        If the mechanism has a dead centre: there the force would be unbounded.

    Notes
    -----
    Source of the force: Yanchevskiy and Niekhoroshykh 2021, eq. (10). Erratum: their remark
    after eq. (11) that f stays below 1 is false for one satellite (1.249 for three pins).

    Examples
    --------
    Three pins, one satellite; and two satellites at 180 degrees: 2/3 exactly.

    >>> one = Mechanism.evenly_spaced(pins=3, satellites=1, ratio=20.0)
    >>> round(peak_force(mechanism=one).peak_force_ratio, 13)
    1.2492332112159
    >>> two = Mechanism.evenly_spaced(pins=3, satellites=2, ratio=20.0)
    >>> peak_force(mechanism=two).peak_force_ratio == 2/3
    True
    """
    check_exponent(force_exponent)
    phases = mechanism.phases
    zones = phases.dead_zones()
    if zones:
        refuse_dead_centre(zones[0][0] * mechanism.crank_angle_per_wave)
    distinct = len(phases.sector_phases)
    if force_exponent == 1 and distinct == phases.symmetry and distinct * phases.pins % 2 == 0:
        return _evenly_spaced_peak(mechanism)

    law = _LAWS.get(force_exponent, _Power)
    candidates: list[tuple[float, float, float]] = []  # ratio, wave position, relative error
    for segment in segments(phases):
        force = law(segment.driving, force_exponent)
        for offset in (segment.low, segment.high, *force.stationary(segment.low, segment.high)):
            ratio, error = force.of_best_pair(offset, 2 * ROUNDING + phases.snapped)
            candidates.append((ratio, offset + 0.75 - segment.phase, error))
    ratio, _, error = max(candidates)
    # Of equal peaks (mirror images, repeats) the first after crank angle 0 is the one to name.
    repeat = 1 / (phases.pins * phases.symmetry)
    position = min(
        _first_repeat(place, repeat)
        for value, place, _ in candidates
        if value >= ratio * (1 - 1e-13)
    )
    satellite, pin = _best_pair(phases, position)
    return PeakForce(
        peak_force_ratio=ratio,
        peak_crank_angle=position * mechanism.crank_angle_per_wave,
        peak_satellite=satellite,
        peak_pin=pin,
        accuracy=Accuracy(method=law.method, relative_error=error, evaluations=len(candidates)),
    )


class _Law:
    """Force of the best placed pair over F0 within a segment, under one law of load sharing."""

    method: ClassVar[str]

    def __init__(self, driving: DrivingSet, exponent: float) -> None:
        self.driving = driving
        self.exponent = exponent

    def of_best_pair(self, offset: float, phase_error: float) -> tuple[float, float]:
        """Force ratio and its relative error, from an error of the phases in turns."""
        raise NotImplementedError

    def stationary(self, low: float, high: float) -> list[float]:
        """Offsets within a range at which the force is stationary, in turns."""
        raise NotImplementedError


class _EqualSharing(_Law):
    """Exponent 0: 1 over the sum of cosines, which has no maximum inside a segment."""

    method = "segment-exact, equal sharing: largest at a switching angle"

    def of_best_pair(self, offset: float, phase_error: float) -> tuple[float, float]:
        total = self.driving.sum_of_cosines(offset)
        condition = self.driving.number / total
        return 1 / total, ROUNDING * (4 + 2 * condition) + 2 * math.pi * phase_error * condition

    def stationary(self, low: float, high: float) -> list[float]:
        return []


class _Linear(_Law):
    """Exponent 1: with t = tan(offset) the roots of P*t^3 + (3*P - n)*t - 2*Q = 0."""

    method = "segment-exact, roots of a cubic"

    def of_best_pair(self, offset: float, phase_error: float) -> tuple[float, float]:
        best = cosine(offset)
        cosines, sines, _ = self.driving.sums_of_squares(offset)
        # sum |sin*cos| <= sqrt(sum sin^2 * sum cos^2)
        slope = math.sqrt(1 - best * best) / best + 2 * math.sqrt(sines / cosines)
        rounding = ROUNDING * (4 + 2 * self.driving.summed_in_runs / cosines)
        return best / cosines, rounding + 2 * math.pi * phase_error * slope

    def stationary(self, low: float, high: float) -> list[float]:
        cosines, squares, products = self.driving.sums_of_squares(0.0)
        number = cosines + squares
        if squares <= number * ROUNDING**2:
            return []
        roots = depressed_cubic_roots(3 - number / squares, -2 * products / squares)
        offsets = [math.atan(root) / (2 * math.pi) for root in roots]
        return [offset for offset in offsets if low < offset < high]


class _Power(_Law):
    """Any exponent: sign changes of the slope on a grid, each narrowed down.

    Large exponents put the peak within 1/v of the end of a segment, where the next pair takes
    over, and exponents just above 1 within (1 + v)^(-1/(v - 1)) of it, where the next pair begins
    to drive; so the grid that looks for sign changes is even inside and geometric towards both
    ends, down to where a peak would differ from the end's value by less than rounding.
    """

    method = "segment-exact, bracketed roots"

    def __init__(self, driving: DrivingSet, exponent: float) -> None:
        super().__init__(driving, exponent)
        self.offsets, self.weights = driving.pairs()

    def of_best_pair(self, offset: float, phase_error: float) -> tuple[float, float]:
        cosines, sines = self._cosines(offset)
        best_cosine, best_sine = math.cos(2 * math.pi * offset), math.sin(2 * math.pi * offset)
        relative = cosines / best_cosine
        powers = self.weights * relative**self.exponent
        total = float((powers * relative).sum())
        # d(ln f) = v*tan(x)*dx + (1 + v)*sum(c^v*|s|*dx)/sum(c^(1+v)): how the error of the
        # phases reaches the force. A pair within that error of its switching angle counts with
        # the cosine that it may have, and once more for one that may just not drive.
        angle_error = 2 * math.pi * phase_error
        widened = self.weights * ((cosines + angle_error) / best_cosine) ** self.exponent
        widened *= 1 + (cosines <= angle_error)
        slope = self.exponent * abs(best_sine) / best_cosine + (1 + self.exponent) * float(
            (widened * np.abs(sines)).sum()
        ) / (best_cosine * total)
        others = max(total - 1.0, 0.0) / total
        error = ROUNDING * (6 + 2 * (1 + self.exponent) * others)
        return 1 / (best_cosine * total), error + angle_error * slope

    def stationary(self, low: float, high: float) -> list[float]:
        levels = max(16, math.ceil(math.log2(64 * (1 + self.exponent)) / 2))
        towards_end = 0.25 ** np.arange(levels, 0, -1)
        half = np.unique(np.concatenate(([0.0], towards_end / 2, np.linspace(0.0, 0.5, 9))))
        grid = low + (high - low) * np.concatenate((half, 1 - half[-2::-1]))
        slopes = self._slope(grid)
        changes = np.flatnonzero((slopes[:-1] == 0) | (slopes[:-1] * slopes[1:] < 0))
        return [
            _root(
                lambda offset: float(self._slope(offset)),
                (float(grid[i]), float(slopes[i])),
                (float(grid[i + 1]), float(slopes[i + 1])),
            )
            for i in changes
        ]

    def _cosines(self, offset: float | FloatArray) -> tuple[FloatArray, FloatArray]:
        """Cosines and sines of the pressure angles of the driving pairs."""
        turns = np.add.outer(offset, self.offsets)
        # Beside the switching angle the distance to it keeps the digits that cos() would lose.
        cosines = np.maximum(np.sin(2 * np.pi * (0.25 - np.abs(turns))), 0.0)
        return cosines, np.sin(2 * np.pi * turns)

    def _slope(self, offset: float | FloatArray) -> FloatArray:
        """Quantity with the sign of the derivative of the force by the offset."""
        cosines, sines = self._cosines(offset)
        best = 2 * np.pi * np.asarray(offset)
        relative = cosines / np.cos(best)[..., None]
        lead = self.exponent / (1 + self.exponent) * np.sin(best)[..., None]
        terms = self.weights * relative**self.exponent * (sines - lead * relative)
        slope: FloatArray = terms.sum(axis=-1)
        return slope


_LAWS: dict[float, type[_Law]] = {0.0: _EqualSharing, 1.0: _Linear}
"""Exponents with a closed form."""


def depressed_cubic_roots(linear: float, constant: float) -> list[float]:
    """Real roots of ``t^3 + linear*t + constant``, polished by Newton's method.

    Parameters
    ----------
    linear, constant : float
        Coefficients.

    Returns
    -------
    list of float
        One root, or three (equal ones repeated).

    Examples
    --------
    >>> sorted(round(root, 12) for root in depressed_cubic_roots(-7.0, 6.0))
    [-3.0, 1.0, 2.0]
    """
    if linear == 0:
        return [math.copysign(abs(constant) ** (1 / 3), -constant)]
    scale = 2 * math.sqrt(abs(linear) / 3)
    argument = -4 * constant / scale**3 if scale**3 > 0 else math.copysign(math.inf, -constant)
    if linear > 0:
        roots = [scale * math.sinh(math.asinh(argument) / 3)]
    elif abs(argument) <= 1:
        angle = math.acos(argument) / 3
        roots = [scale * math.cos(angle + k * 2 * math.pi / 3) for k in range(3)]
    else:
        roots = [math.copysign(scale * math.cosh(math.acosh(abs(argument)) / 3), argument)]
    polished = []
    for root in roots:
        slope = 3 * root * root + linear
        step = (root * (root * root + linear) + constant) / slope if slope else 0.0
        polished.append(root - step if abs(step) < 1e-6 * abs(root) else root)
    return polished


def _root(
    function: Callable[[float], float],
    left: tuple[float, float],
    right: tuple[float, float],
) -> float:
    """Root of a function between two points of opposite sign: Illinois steps, bisection behind."""
    (a, fa), (b, fb) = left, right
    for iteration in range(200):
        if abs(b - a) <= 4 * ROUNDING * max(abs(a), abs(b)) or fa == 0:
            break
        x = b - fb * (b - a) / (fb - fa) if iteration % 4 != 3 else (a + b) / 2
        if not min(a, b) < x < max(a, b):
            x = (a + b) / 2
        fx = function(x)
        if fx == 0:
            return x
        if (fx > 0) == (fb > 0):
            fa /= 2
        else:
            a, fa = b, fb
        b, fb = x, fx
    return a if fa == 0 else b


def _evenly_spaced_peak(mechanism: Mechanism) -> PeakForce:
    """Peak for v = 1 and an even number m of evenly spaced phases, c pairs on each: 4/(c*m)."""
    phases = mechanism.phases
    pairs = mechanism.pins * mechanism.satellites
    position = _first_repeat(0.75 - phases.sector_phases[0], 1 / (phases.pins * phases.symmetry))
    satellite, pin = _best_pair(phases, position)
    return PeakForce(
        peak_force_ratio=4 / pairs,
        peak_crank_angle=position * mechanism.crank_angle_per_wave,
        peak_satellite=satellite,
        peak_pin=pin,
        accuracy=Accuracy(
            method="closed form: evenly spaced pairs",
            relative_error=ROUNDING + 4 * math.pi * phases.snapped,
            evaluations=1,
        ),
    )


def _first_repeat(position: float, repeat: float) -> float:
    """First repeat of a wave position at or after 0; a rounding error beside a repeat is 0."""
    first = position % repeat
    return first if SAME_PHASE < first < repeat - SAME_PHASE else 0.0


def _best_pair(phases: WavePhases, position: float) -> tuple[int, int]:
    """Numbers of the best placed pair at a wave position, the first of equals."""
    places = []
    for satellite, phase in enumerate(phases.satellite_phase):
        off = (0.75 - position - phase) * phases.pins
        # Midway between two pins the first of them is the one to name.
        pin = math.ceil(off - 0.5 - SAME_PHASE * phases.pins)
        distance = round(abs(off - pin) / phases.pins, 12)
        places.append((distance, satellite, pin % phases.pins))
    _, satellite, pin = min(places)
    return satellite + 1, pin + 1
