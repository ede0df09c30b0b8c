"""Sum of the contact forces over the turn, the slow way: integrated and searched at 30 digits.

Nothing is shared with ``core``: every pair by its own cosine, no closed form, no symmetry beyond
the pin spacing. Between the places at which a pair starts or stops to drive, or another becomes the
best placed, the sum is smooth.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from mpmath import mp, mpf

from tests.oracles.crank_planetary import breaks, phases

SLIVER = mpf("1e-11")
"""Ranges of the wave angle shorter than this, rad, have no extremes of their own."""

SWITCHED = mpf("1e-35")
"""Cosine of a pair that just begins or ends to drive, but for rounding."""

NEAR = 1e-5
"""How far below the largest of all, as a part of it, a sample is beside no largest value."""

FLAT = 1e-13
"""What doubles do not tell from their rounding, as a part of the largest of all."""


@dataclass(frozen=True, slots=True)
class Total:
    """Mean, least and largest of the sum of the forces over F0."""

    mean: mpf
    least: mpf
    largest: mpf


def total(pins: int, crank_angles: Sequence[float], exponent: float) -> Total:
    """Over the turn; the driving pairs of a segment are those that drive in its middle."""
    theta = [t for row in phases(pins, crank_angles) for t in row]
    ends = breaks(theta, 2 * mp.pi / pins)
    parts = [_Part(theta, mpf(exponent), *pair) for pair in pairwise(ends)]
    with mp.workdps(25):
        integral = mp.fsum(part.integral() for part in parts)
    wide = [part for part in parts if part.stop - part.start > SLIVER]
    return Total(
        integral / (ends[-1] - ends[0]),
        min(-each for each in _summits(wide, -1)),
        max(_summits(wide, 1)),
    )


class _Part:
    """Sum of the forces between two places."""

    def __init__(self, theta: Sequence[mpf], exponent: mpf, start: mpf, stop: mpf) -> None:
        self.exponent, self.start, self.stop = exponent, start, stop
        middle = (start + stop) / 2
        self.driving = [t for t in theta if mp.sin(middle + t) < 0]
        self.turned = [mp.cos_sin(t) for t in self.driving]

    def force(self, psi: mpf) -> mpf:
        along, across = mp.cos_sin(psi)
        cosines = [-across * cos - along * sin for cos, sin in self.turned]
        cosines = [c if c > SWITCHED else mpf(0) for c in cosines]
        best, v = max(cosines), self.exponent
        if v == 0:
            return len(cosines) / mp.fsum(cosines)
        powers = cosines if v == 1 else [(c / best) ** v if c else c for c in cosines]
        return mp.fsum(powers) / mp.fdot(powers, cosines)

    def integral(self) -> mpf:
        value, error = mp.quad(self.force, [self.start, self.stop], error=True, maxdegree=9)
        assert error < 1e-17 * value
        return value

    def samples(self) -> tuple[np.ndarray, np.ndarray]:
        """Places as parts of the way, closer at the ends, and the sum there, in doubles."""
        part = (1 - np.cos(np.linspace(0, np.pi, 1000))) / 2
        shifts = np.array([float(self.start + t) for t in self.driving])
        width = float(self.stop - self.start)
        cosines = np.maximum(-np.sin(shifts[:, None] + width * part), 0.0)
        best = cosines.max(axis=0)
        powers = (cosines / best) ** float(self.exponent)
        return part, powers.sum(axis=0) / (powers * cosines).sum(axis=0)


def _summits(parts: Sequence[_Part], sign: int) -> Iterator[mpf]:
    """Sign times the sum at all ends, and where doubles show that it may be the largest inside."""
    sampled = [(part, *part.samples()) for part in parts]
    highest = max(float((sign * values).max()) for _, _, values in sampled)
    for part, way, values in sampled:
        yield from (sign * part.force(end) for end in (part.start, part.stop))
        values = sign * values
        best = min(max(int(values.argmax()), 1), len(values) - 2)
        for i in range(1, len(values) - 1):
            beside = min(values[i - 1], values[i + 1])
            summit = values[i - 1] <= values[i] >= values[i + 1]
            clear = summit and values[i] - beside > FLAT * abs(highest)
            near = highest - values[i] < NEAR * abs(highest)
            if near and (clear or i in (1, best, len(values) - 2)):
                low, high = (
                    part.start + (part.stop - part.start) * mpf(way[j]) for j in (i - 1, i + 1)
                )
                yield _summit(lambda psi, part=part: sign * part.force(psi), low, high)


def _summit(value: Callable[[mpf], mpf], low: mpf, high: mpf) -> mpf:
    """Largest value between two places, by golden section."""
    golden = (mp.sqrt(5) - 1) / 2
    a, b = high - golden * (high - low), low + golden * (high - low)
    at_a, at_b = value(a), value(b)
    for _ in range(40):
        if at_a >= at_b:
            high, b, at_b = b, a, at_a
            a = high - golden * (high - low)
            at_a = value(a)
        else:
            low, a, at_a = a, b, at_b
            b = low + golden * (high - low)
            at_b = value(b)
    return max(at_a, at_b)
