"""Laws of load sharing: the force of the best placed pair, and where in a segment it may peak."""

import math
from collections.abc import Sequence
from functools import lru_cache
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from core.contact_force import FloatArray
from core.driving_set import DrivingSet, Segment, cosine
from core.results import ROUNDING

IntArray = NDArray[np.intp]

CHUNK = 500_000
"""Most cosines that are taken at once."""

RESOLUTION = 1e-11
"""Share of its bracket to which a peak is located: its height is then right to rounding."""


Candidate = tuple[float, int, float]
"""Force ratio, number of the segment, pressure angle of the best placed pair in turns."""


class ForceLaw:
    """Force of the best placed pair over F0 within segments, under one law of load sharing."""

    method: ClassVar[str]

    def __init__(self, parts: Sequence[Segment], exponent: float) -> None:
        self.parts = parts
        self.exponent = exponent

    def candidates(self) -> list[Candidate]:
        """The ends of all segments, and the places inside at which the force may be largest."""
        return [
            (self.of_best_pair(part.driving, offset), index, offset)
            for index, part in enumerate(self.parts)
            for offset in (part.low, part.high, *self.stationary(part))
        ]

    def of_best_pair(self, driving: DrivingSet, offset: float) -> float:
        """Force ratio."""
        raise NotImplementedError

    def stationary(self, part: Segment) -> list[float]:
        """Offsets within a segment at which the force is stationary, in turns."""
        raise NotImplementedError

    def relative_error(self, index: int, offset: float, phase_error: float) -> float:
        """Relative error of a candidate, from an error of the phases in turns."""
        raise NotImplementedError


class _EqualSharing(ForceLaw):
    """Exponent 0: 1 over the sum of cosines, which has no maximum inside a segment."""

    method = "segment-exact, equal sharing: largest at a switching angle"

    def of_best_pair(self, driving: DrivingSet, offset: float) -> float:
        return 1 / driving.sum_of_cosines(offset)

    def stationary(self, part: Segment) -> list[float]:
        return []

    def relative_error(self, index: int, offset: float, phase_error: float) -> float:
        driving = self.parts[index].driving
        condition = driving.number / driving.sum_of_cosines(offset)
        return ROUNDING * (4 + 2 * condition) + 2 * math.pi * phase_error * condition


class _Linear(ForceLaw):
    """Exponent 1: with t = tan(offset) the roots of P*t^3 + (3*P - n)*t - 2*Q = 0."""

    method = "segment-exact, roots of a cubic"

    def of_best_pair(self, driving: DrivingSet, offset: float) -> float:
        return cosine(offset) / driving.sums_of_squares(offset)[0]

    def stationary(self, part: Segment) -> list[float]:
        cosines, squares, products = part.driving.sums_of_squares(0.0)
        number = cosines + squares
        if squares <= number * ROUNDING**2:
            return []
        roots = depressed_cubic_roots(3 - number / squares, -2 * products / squares)
        offsets = [math.atan(root) / (2 * math.pi) for root in roots]
        return [offset for offset in offsets if part.low < offset < part.high]

    def relative_error(self, index: int, offset: float, phase_error: float) -> float:
        driving = self.parts[index].driving
        best = cosine(offset)
        cosines, sines, _ = driving.sums_of_squares(offset)
        # sum |sin*cos| <= sqrt(sum sin^2 * sum cos^2)
        slope = math.sqrt(1 - best * best) / best + 2 * math.sqrt(sines / cosines)
        rounding = ROUNDING * (4 + 2 * driving.summed_in_runs / cosines)
        return rounding + 2 * math.pi * phase_error * slope


class _Power(ForceLaw):
    """Any exponent: sign changes of the slope on a grid, each narrowed down, all at once.

    Large exponents put the peak within 1/v of the end of a segment, where the next pair takes
    over, and exponents just above 1 within (1 + v)^(-1/(v - 1)) of it, where the next pair begins
    to drive; so the grid that looks for sign changes is even inside and geometric towards both
    ends, down to where a peak would differ from the end's value by less than rounding.
    """

    method = "segment-exact, bracketed roots"

    def __init__(self, parts: Sequence[Segment], exponent: float) -> None:
        super().__init__(parts, exponent)
        pairs = [part.driving.pairs() for part in parts]
        shape = len(parts), max(len(offsets) for offsets, _ in pairs)
        self.offsets = np.zeros(shape)
        self.weights = np.zeros(shape)  # 0 where a segment has fewer driving pairs than another
        for row, (offsets, weights) in enumerate(pairs):
            self.offsets[row, : len(offsets)] = offsets
            self.weights[row, : len(weights)] = weights

    def candidates(self) -> list[Candidate]:
        grid = _unit_grid(self.exponent)
        found: list[Candidate] = []
        brackets: list[tuple[float, int, float, float]] = []  # bound of the force, segment, ends
        step = max(1, CHUNK // (len(grid) * self.offsets.shape[1]))
        for first in range(0, len(self.parts), step):
            rows = np.arange(first, min(first + step, len(self.parts)))
            low, high = (
                np.array([getattr(self.parts[row], end) for row in rows.tolist()])
                for end in ("low", "high")
            )
            places = low[:, None] + (high - low)[:, None] * grid
            places[:, -1] = high
            forces, slopes = self._force_and_slope(rows[:, None], places)
            for end in (0, -1):
                values, at = forces[:, end].tolist(), places[:, end].tolist()
                found += zip(values, rows.tolist(), at, strict=True)
            row, left = np.nonzero(
                (slopes[:, :-1] > 0) & (slopes[:, 1:] < 0) | (slopes[:, :-1] == 0)
            )
            # A summit lies below the tangents at the ends of its bracket; twice their rise is safe.
            steep = np.maximum(np.abs(slopes[row, left]), np.abs(slopes[row, left + 1]))
            rise = 2 * steep * (places[row, left + 1] - places[row, left])
            bound = np.maximum(forces[row, left], forces[row, left + 1]) * np.exp(rise)
            starts, stops = places[row, left].tolist(), places[row, left + 1].tolist()
            brackets += zip(bound.tolist(), rows[row].tolist(), starts, stops, strict=True)
        highest = max(found)[0]
        for most, index, start, stop in brackets:
            if most >= highest:
                place = self._summit(index, start, stop)
                force, _ = self._force_and_slope(np.array(index), np.array(place))
                found.append((float(force), index, place))
        return found

    def _summit(self, index: int, left: float, right: float) -> float:
        """Where the slope falls through 0: Illinois steps, bisection behind."""
        count = np.count_nonzero(self.weights[index])
        pairs = list(
            zip(
                self.weights[index, :count].tolist(),
                self.offsets[index, :count].tolist(),
                strict=True,
            )
        )
        power = self.exponent

        def slope(offset: float) -> float:
            """Quantity with the sign of the derivative of the force."""
            top, rise = math.cos(2 * math.pi * offset), math.sin(2 * math.pi * offset)
            lead = total = 0.0
            for weight, phase in pairs:
                turns = offset + phase
                cosine = math.sin(2 * math.pi * (0.25 - abs(turns)))
                if cosine > 0:
                    share = weight * (cosine / top) ** power
                    total += share * cosine
                    lead += share * math.sin(2 * math.pi * turns)
            return (1 + power) * lead * top - power * rise * total

        close = RESOLUTION * (right - left)
        rising, falling = slope(left), slope(right)
        kept = 0  # which end stayed in the last step: -1 the left, 1 the right
        for iteration in range(120):
            if right - left <= close or rising == 0:
                break
            place = right - falling * (right - left) / (falling - rising)
            if not left < place < right or iteration % 4 == 3:
                place = (left + right) / 2
            value = slope(place)
            if value > 0:
                falling /= 2 if kept > 0 else 1
                left, rising, kept = place, value, 1
            else:
                rising /= 2 if kept < 0 else 1
                right, falling, kept = place, value, -1
        return left if rising == 0 else (left + right) / 2

    def _force_and_slope(
        self, rows: IntArray, offsets: FloatArray
    ) -> tuple[FloatArray, FloatArray]:
        """Force ratio and the derivative of its logarithm by the offset, per turn."""
        turns = offsets[..., None] + self.offsets[rows]
        cosines, sines = _cosines(turns), np.sin(2 * np.pi * turns)
        best = 2 * np.pi * offsets
        top, rise = np.cos(best), np.sin(best)
        relative = cosines / top[..., None]
        powers = self.weights[rows] * relative**self.exponent
        total = (powers * relative).sum(axis=-1)
        lead = (powers * sines).sum(axis=-1)
        slope = 2 * np.pi / top * ((1 + self.exponent) * lead / total - self.exponent * rise)
        return 1 / (top * total), slope

    def relative_error(self, index: int, offset: float, phase_error: float) -> float:
        count = np.count_nonzero(self.weights[index])
        turns = offset + self.offsets[index, :count]
        weights = self.weights[index, :count]
        cosines, sines = _cosines(turns), np.sin(2 * np.pi * turns)
        best_cosine, best_sine = math.cos(2 * math.pi * offset), math.sin(2 * math.pi * offset)
        relative = cosines / best_cosine
        total = float((weights * relative ** (1 + self.exponent)).sum())
        # d(ln f) = v*tan(x)*dx + (1 + v)*sum(c^v*|s|*dx)/sum(c^(1+v)): how the error of the
        # phases reaches the force. A pair within that error of its switching angle counts with
        # the cosine that it may have, and once more for one that may just not drive.
        angle_error = 2 * math.pi * phase_error
        widened = weights * ((cosines + angle_error) / best_cosine) ** self.exponent
        widened *= 1 + (cosines <= angle_error)
        slope = self.exponent * abs(best_sine) / best_cosine + (1 + self.exponent) * float(
            (widened * np.abs(sines)).sum()
        ) / (best_cosine * total)
        others = max(total - 1.0, 0.0) / total
        error = ROUNDING * (6 + 2 * (1 + self.exponent) * others)
        return error + angle_error * slope


@lru_cache(maxsize=64)
def _unit_grid(exponent: float) -> FloatArray:
    """Places from 0 to 1, even inside and geometric towards both ends."""
    levels = max(16, math.ceil(math.log2(64 * (1 + exponent)) / 2))
    towards_end = 0.25 ** np.arange(levels, 0, -1)
    half = np.unique(np.concatenate(([0.0], towards_end / 2, np.linspace(0.0, 0.5, 9))))
    return np.concatenate((half, 1 - half[-2::-1]))


def _cosines(turns: FloatArray) -> FloatArray:
    """Cosines where they are positive, else 0; beside their zero they keep their digits."""
    cosines: FloatArray = np.maximum(np.sin(2 * np.pi * (0.25 - np.abs(turns))), 0.0)
    return cosines


def force_law(*, parts: Sequence[Segment], exponent: float) -> ForceLaw:
    """The law of a force exponent over the segments of the turn.

    Parameters
    ----------
    parts : sequence of Segment
        The segments.
    exponent : float
        Force exponent v; 0 and 1 have closed forms.

    Returns
    -------
    ForceLaw
    """
    return {0.0: _EqualSharing, 1.0: _Linear}.get(exponent, _Power)(parts, exponent)


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
