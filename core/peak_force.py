"""Exact peak of the contact force over the turn, for any force exponent.

At any position the pair with the largest cosine of the pressure angle carries the most. Between
the angles at which a pair starts or stops driving, or another pair becomes the best placed,
everything is smooth: there the peak is found exactly, and the largest of these is the peak over
the turn.
"""

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from core.contact_force import FloatArray, check_exponent, refuse_dead_centre
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

    method, stationary = _stationary_points(force_exponent)
    candidates: list[tuple[float, float, float]] = []  # ratio, wave position, relative error
    evaluations = 0
    for phase, low, high, driving in _segments(phases):
        offsets = [low, high, *stationary(driving, low, high)]
        evaluations += len(offsets)
        for offset in offsets:
            ratio, error = driving.best_force(offset, force_exponent, phases.snapped)
            candidates.append((ratio, offset + 0.75 - phase, error))
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
        accuracy=Accuracy(method=method, relative_error=error, evaluations=evaluations),
    )


@dataclass(frozen=True, slots=True)
class _DrivingSet:
    """The pairs that drive over one segment, as phases against the best placed pair.

    Attributes
    ----------
    offsets : array
        Phases d_i against the best placed pair, in turns, within half a turn.
    weights : array
        How many pairs share each.
    """

    offsets: FloatArray
    weights: FloatArray

    def cosines(self, offset: float | FloatArray) -> tuple[FloatArray, FloatArray]:
        """Cosines and sines of the pressure angles, the best pair being at `offset` turns."""
        turns = np.add.outer(offset, self.offsets)
        angle = 2 * np.pi * turns
        # Near the switching angle the distance to it keeps the digits that cos() would lose.
        return np.maximum(np.sin(2 * np.pi * (0.25 - np.abs(turns))), 0.0), np.sin(angle)

    def best_force(self, offset: float, exponent: float, snapped: float) -> tuple[float, float]:
        """Force of the best placed pair over F0 and its relative error."""
        cosines, sines = self.cosines(offset)
        best_cosine, best_sine = math.cos(2 * math.pi * offset), math.sin(2 * math.pi * offset)
        relative = cosines / best_cosine
        powers = self.weights * relative**exponent
        sharing = powers * relative
        total = float(sharing.sum())
        # d(ln f) = v*tan(x)*dx + (1 + v)*sum(c^v*|s|*dx)/sum(c^(1+v)): how the error of the
        # phases, by rounding and by merging, reaches the force.
        phase_error = 2 * math.pi * (2 * ROUNDING + snapped)
        slope = exponent * abs(best_sine) / best_cosine + (1 + exponent) * float(
            (powers * np.abs(sines)).sum()
        ) / (best_cosine * total)
        others = max(total - 1.0, 0.0) / total
        error = ROUNDING * (6 + 2 * (1 + exponent) * others) + phase_error * slope
        return 1 / (best_cosine * total), error

    def slope_sign(self, offset: float | FloatArray, exponent: float) -> FloatArray:
        """Quantity with the sign of the derivative of the best pair's force by `offset`."""
        cosines, sines = self.cosines(offset)
        best = 2 * np.pi * np.asarray(offset)
        relative = cosines / np.cos(best)[..., None]
        lead = exponent / (1 + exponent) * np.sin(best)[..., None]
        slope: FloatArray = (self.weights * relative**exponent * (sines - lead * relative)).sum(
            axis=-1
        )
        return slope


def _segments(phases: WavePhases) -> Iterator[tuple[float, float, float, _DrivingSet]]:
    """Segments of smooth peak force over one repeat of the pattern.

    Yields the phase of the best placed pair, the range of its offset (its own pressure angle in
    turns) and the driving set there.
    """
    everything = phases.all_phases()
    count = len(everything)
    values = np.array([phase for phase, _ in everything])
    weights = np.array([float(number) for _, number in everything])
    for index in range(len(phases.sector_phases) // phases.symmetry):
        phase = everything[index][0]
        below = phase - everything[index - 1][0] if index else phase + 1 - everything[-1][0]
        above = (
            everything[index + 1][0] - phase if index + 1 < count else 1 - phase + everything[0][0]
        )
        low, high = -above / 2, below / 2
        relative = values - phase
        relative -= np.rint(relative)
        switches = np.concatenate((0.25 - relative, -0.25 - relative))
        apart = 4 * ROUNDING
        inner = np.sort(switches[(switches > low + apart) & (switches < high - apart)])
        inner = inner[np.diff(inner, prepend=low) > apart]
        limits = [low, *inner.tolist(), high]
        for start, stop in pairwise(limits):
            driving = np.abs((start + stop) / 2 + relative) < 0.25
            yield phase, start, stop, _DrivingSet(relative[driving], weights[driving])


_Stationary = Callable[[_DrivingSet, float, float], list[float]]


def _stationary_points(exponent: float) -> tuple[str, _Stationary]:
    """Name and finder of the stationary points of the best pair's force within a segment."""
    if exponent == 0:
        return "segment-exact, equal sharing: largest at a switching angle", lambda *_: []
    if exponent == 1:
        return "segment-exact, roots of a cubic", _cubic_stationary_points
    return (
        "segment-exact, bracketed roots",
        lambda driving, low, high: _bracketed_stationary_points(driving, low, high, exponent),
    )


def _cubic_stationary_points(driving: _DrivingSet, low: float, high: float) -> list[float]:
    """Stationary offsets for v = 1, in turns: roots of P*t^3 + (3*P - n)*t - 2*Q = 0."""
    sines = np.sin(2 * np.pi * driving.offsets)
    cosines = np.cos(2 * np.pi * driving.offsets)
    number = float(driving.weights.sum())
    squares = float((driving.weights * sines * sines).sum())
    products = float((driving.weights * sines * cosines).sum())
    if squares <= number * ROUNDING**2:
        return []
    roots = depressed_cubic_roots(3 - number / squares, -2 * products / squares)
    offsets = [math.atan(root) / (2 * math.pi) for root in roots]
    return [offset for offset in offsets if low < offset < high]


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


def _bracketed_stationary_points(
    driving: _DrivingSet, low: float, high: float, exponent: float
) -> list[float]:
    """Stationary offsets for any v, in turns: sign changes of the slope, each narrowed down.

    Large exponents put the peak within 1/v of the end of a segment, where the next pair takes
    over, and exponents just above 1 within (1 + v)^(-1/(v - 1)) of it, where the next pair begins
    to drive; so the grid that looks for sign changes is even inside and geometric towards both
    ends, down to where a peak would differ from the end's value by less than rounding.
    """
    levels = max(16, math.ceil(math.log2(64 * (1 + exponent)) / 2))
    towards_end = 0.25 ** np.arange(levels, 0, -1)
    half = np.unique(np.concatenate(([0.0], towards_end / 2, np.linspace(0.0, 0.5, 9))))
    fractions = np.concatenate((half, 1 - half[-2::-1]))
    grid = low + (high - low) * fractions
    slopes = driving.slope_sign(grid, exponent)
    found = []
    for i in range(len(grid) - 1):
        if slopes[i] == 0 or slopes[i] * slopes[i + 1] < 0:
            found.append(
                _root(
                    lambda offset: float(driving.slope_sign(offset, exponent)),
                    (float(grid[i]), float(slopes[i])),
                    (float(grid[i + 1]), float(slopes[i + 1])),
                )
            )
    return found


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
    distance = [
        (round(abs(math.remainder(position + phase + pin / phases.pins - 0.75, 1.0)), 12), j, pin)
        for j, phase in enumerate(phases.satellite_phase)
        for pin in range(phases.pins)
    ]
    _, satellite, pin = min(distance)
    return satellite + 1, pin + 1
