"""Laws of load sharing: force of the best placed pair, and where in a segment it may peak.

Within a segment the n driving pairs stay, with phases d_i against the best placed one. The force of
that pair at its pressure angle x is ``f = cos(x)^v/sum cos(x + d_i)^(1 + v)``. With t = tan(x),
``P = sum sin^2 d_i`` and ``Q = sum sin d_i cos d_i`` it is stationary for v = 1 at the roots of
``P*t^3 + (3*P - n)*t - 2*Q = 0``. For v = 0 it has no maximum inside: the peak is at an end.
"""

import math
from collections.abc import Iterator, Sequence
from typing import ClassVar

import numpy as np

from core.arrays import FloatArray
from core.output.driving_set import DrivingSet, Segment, cosine
from core.output.force_bounds import (
    HALVINGS,
    NARROW,
    RESOLUTION,
    Look,
    least_total,
    most_summits,
    next_place,
)
from core.precision import ROUNDING

MANY = 24
"""Number of driving pairs above which arrays are faster than a loop."""


Candidate = tuple[float, int, float]
"""Force ratio, number of the segment, pressure angle of the best placed pair in turns."""


class ForceLaw:
    """Force of the best placed pair over F0 within segments, under one law of load sharing."""

    method: ClassVar[str]

    def __init__(self, parts: Sequence[Segment], exponent: float) -> None:
        self.parts = parts
        self.exponent = exponent

    def candidates(self) -> list[Candidate]:
        """Ends of all segments, and places inside at which the force may be largest."""
        return [
            (self.of_best_pair(part.driving, offset), index, offset)
            for index, part in enumerate(self.parts)
            for offset in (part.low, part.high, *self.stationary(part))
        ]

    def of_best_pair(self, driving: DrivingSet, offset: float) -> float:
        """Force ratio of the best placed pair at its pressure angle, in turns."""
        raise NotImplementedError

    def stationary(self, part: Segment) -> list[float]:
        """Offsets within a segment at which the force is stationary, in turns."""
        raise NotImplementedError

    def relative_error(self, index: int, offset: float, phase_error: float) -> float:
        """Relative error of a candidate by rounding and by an error of the phases, in turns."""
        raise NotImplementedError


class _EqualSharing(ForceLaw):
    """Law of exponent 0: 1 over the sum of cosines."""

    method = "segments_equal"

    def of_best_pair(self, driving: DrivingSet, offset: float) -> float:
        return 1 / driving.sum_of_cosines(offset)

    def stationary(self, part: Segment) -> list[float]:
        return []

    def relative_error(self, index: int, offset: float, phase_error: float) -> float:
        driving = self.parts[index].driving
        condition = driving.number / driving.sum_of_cosines(offset)
        return ROUNDING * (4 + 2 * condition) + 2 * math.pi * phase_error * condition


class _Linear(ForceLaw):
    """Law of exponent 1: cos(x) over the sum of squared cosines."""

    method = "segments_cubic"

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
    """Law of any exponent: stretches are halved until they have at most one summit that may be the
    peak; see `core.output.force_bounds`.
    """

    method = "segments_roots"

    def __init__(self, parts: Sequence[Segment], exponent: float) -> None:
        super().__init__(parts, exponent)
        self.phases = [part.driving.pairs() for part in parts]
        self.directions = [
            (weights, np.cos(2 * np.pi * offsets), np.sin(2 * np.pi * offsets))
            for offsets, weights in self.phases
        ]

    def candidates(self) -> list[Candidate]:
        found = []
        ends = []
        for index, part in enumerate(self.parts):
            places = part.low, part.high
            found += [(self._force(index, place), index, place) for place in places]
            tangents = (math.tan(2 * math.pi * place) for place in places)
            low, high = (self.look(index, tangent) for tangent in tangents)
            ends.append((low, high))
        highest = max(found)[0]
        # The most promising segments first: the higher the peak found, the less is left to search.
        order = sorted(enumerate(ends), key=lambda each: -max(look.force for look in each[1]))
        for index, (low, high) in order:
            for tangent in self._summits(index, low, high, highest):
                place = math.atan(tangent) / (2 * math.pi)
                force = self._force(index, place)
                found.append((force, index, place))
                highest = max(highest, force)
        return found

    def _force(self, index: int, offset: float) -> float:
        offsets, weights = self.phases[index]
        best = math.cos(2 * math.pi * offset)
        ratios = _cosines(offset + offsets) / best
        return 1 / (best * float((weights * ratios ** (1 + self.exponent)).sum()))

    def _summits(self, index: int, low: Look, high: Look, highest: float) -> Iterator[float]:
        """Tangents at which the force of a segment may be the highest."""
        tiny = 0.5**HALVINGS * (high.tangent - low.tangent)
        stretches = [(low, high)]
        while stretches:
            left, right = stretches.pop()
            least = least_total(left, right, self.exponent)
            summits = most_summits(left, right, self.exponent, highest, least)
            if not summits:
                continue
            width = right.tangent - left.tangent
            apart = min(left.tangent - low.tangent, high.tangent - right.tangent)
            visible = left.slope >= 0 >= right.slope and left.slope > right.slope
            if visible and (summits == 1 or width <= max(NARROW * apart, tiny)):
                yield self._summit(index, left, right)
            elif width > tiny:
                middle = self.look(index, (left.tangent + right.tangent) / 2)
                highest = max(highest, middle.force)
                stretches += [(middle, right), (left, middle)]

    def _summit(self, index: int, left: Look, right: Look) -> float:
        """Tangent at which the slope falls through 0: secant, Newton's method, bisection."""
        start, stop = left.tangent, right.tangent
        place = start + left.slope / (left.slope - right.slope) * (stop - start)
        for _ in range(100):
            here = self.look(index, place)
            if here.slope == 0 and here.change <= 0:
                break
            if here.slope > 0:
                start = place
            else:
                stop = place
            following = next_place(here, start, stop)
            step = abs(following - place)
            place = following
            apart = min(place - left.tangent, right.tangent - place)
            if step <= RESOLUTION * apart:  # each step squares the error
                break
        return place

    def look(self, index: int, tangent: float) -> Look:
        total = lead = falling = rising = 0.0
        power = self.exponent
        weights, cosines, sines = self.directions[index]
        if len(weights) <= MANY:
            pairs = zip(weights.tolist(), cosines.tolist(), sines.tolist(), strict=True)
            for weight, along, across in pairs:
                ratio = along - tangent * across
                if ratio > 0:
                    share = weight * ratio**power
                    total += share * ratio
                    lead += share * across
                    bend = share * across * across / ratio
                    falling += bend if across > 0 else 0.0
                    rising += 0.0 if across > 0 else bend
        else:
            ratios = np.maximum(cosines - tangent * sines, 0.0)
            shares = weights * ratios**power
            leads = shares * sines
            bends = np.divide(leads * sines, ratios, out=np.zeros_like(leads), where=ratios > 0)
            total, lead = float((shares * ratios).sum()), float(leads.sum())
            falling = float(bends[sines > 0].sum())
            rising = float(bends.sum()) - falling
        rise, stretch = 1 + power, 1 + tangent * tangent
        balance = total + rise * tangent * lead
        return Look(
            tangent=tangent,
            force=math.sqrt(stretch) / total,
            slope=tangent * balance + rise * lead,
            change=balance - rise * stretch * power * (falling + rising),
            total=total,
            lead=lead,
            balance=balance,
            falling=falling,
            rising=rising,
        )

    def relative_error(self, index: int, offset: float, phase_error: float) -> float:
        offsets, weights = self.phases[index]
        turns = offset + offsets
        cosines, sines = _cosines(turns), np.sin(2 * np.pi * turns)
        best_cosine, best_sine = math.cos(2 * math.pi * offset), math.sin(2 * math.pi * offset)
        relative = cosines / best_cosine
        total = float((weights * relative ** (1 + self.exponent)).sum())
        # d(ln f) = v*tan(x)*dx + (1 + v)*sum(c^v*|s|*dx)/sum(c^(1+v)): how the error of the
        # phases reaches the force. A pair within that error of its switching angle counts with
        # the cosine that it may have, and once more for one that may just not drive.
        angle_error = 2 * math.pi * phase_error
        with np.errstate(over="ignore"):  # beside a dead centre: the error is unbounded
            widened = weights * ((cosines + angle_error) / best_cosine) ** self.exponent
        widened *= 1 + (cosines <= angle_error)
        slope = self.exponent * abs(best_sine) / best_cosine + (1 + self.exponent) * float(
            (widened * np.abs(sines)).sum()
        ) / (best_cosine * total)
        others = max(total - 1.0, 0.0) / total
        error = ROUNDING * (6 + 2 * (1 + self.exponent) * others)
        return error + angle_error * slope


def _cosines(turns: FloatArray) -> FloatArray:
    """Cosines of angles in turns, 0 where negative, with all digits beside their zero."""
    cosines: FloatArray = np.maximum(np.sin(2 * np.pi * (0.25 - np.abs(turns))), 0.0)
    return cosines


def force_law(*, parts: Sequence[Segment], exponent: float) -> ForceLaw:
    """Law of a force exponent over the segments of the turn; 0 and 1 have closed forms."""
    return {0.0: _EqualSharing, 1.0: _Linear}.get(exponent, _Power)(parts, exponent)


def depressed_cubic_roots(linear: float, constant: float) -> list[float]:
    """Real roots of ``t^3 + linear*t + constant``, one or three (equal ones repeated), polished by
    Newton's method.
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
