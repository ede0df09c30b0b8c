"""Where over a turn of the ideal forces a value is largest, and which pairs drive there.

A turn of the wave is cut where a pair starts or stops driving; between two such places the same
pairs drive. All pins pass through one pitch of it, which is all that is looked at.
"""

import math
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from itertools import pairwise
from typing import TypeVar

import numpy as np

from core.arrays import FloatArray
from core.numerics.extremes import zoom
from core.output.mechanism import Mechanism
from core.precision import SAME
from core.worked.step import MOST_TERMS

SHORT = 1e-9
"""Segment that only rounding makes, rad."""

STEPS = 24
"""Steps of a segment beside the best of which the largest value is sought."""


@dataclass(frozen=True, slots=True)
class Position:
    """Driving pairs at a place of the wave.

    Attributes
    ----------
    satellite, pin : array of int, shape (m,)
        Numbers of the driving pairs, from 0.
    angle : array, shape (n, m)
        Their pressure angles at n places of the wave, rad, within half a turn.
    force : array, shape (n, m)
        Their forces over T/R.
    """

    satellite: FloatArray
    pin: FloatArray
    angle: FloatArray
    force: FloatArray

    def share(self, satellite: int) -> FloatArray:
        """Part of the torque that a satellite carries, shape (n,)."""
        own = self.satellite == satellite
        found: FloatArray = (self.force * np.cos(self.angle))[:, own].sum(axis=1)
        return found

    def pins(self, satellite: int) -> FloatArray:
        """Sum of the forces of its pins over T/R, shape (n,)."""
        found: FloatArray = self.force[:, self.satellite == satellite].sum(axis=1)
        return found


Found = TypeVar("Found")

Measure = Callable[[Position], FloatArray]

FOUND = 1e-10
"""Relative difference from the largest value that core has found up to which a position is that of
the value: peaks of large force exponents are narrower than what is looked at here."""


def is_at(at: Position, *, measure: Measure, value: float) -> bool:
    """Whether a largest value is that of a position, which few enough pairs drive at to be written.

    Parameters
    ----------
    at : Position
        Of one place.
    measure : callable
        Values of positions.
    value : float
        The largest value.
    """
    return len(at.pin) <= MOST_TERMS and math.isclose(float(measure(at)[0]), value, rel_tol=FOUND)


def first_largest(found: Iterable[tuple[float, Found]]) -> Found:
    """What has the largest value, the first of those that differ by rounding.

    Parameters
    ----------
    found : iterable of tuple
        Values, and what has them.

    Examples
    --------
    >>> first_largest([(1.0, "a"), (2.0, "b"), (2.0, "c")])
    'b'
    """
    (most, best), *others = found
    for value, each in others:
        if value > most * (1 + SAME):
            most, best = value, each
    return best


class IdealTurn:
    """Ideal forces over a turn of the wave.

    Parameters
    ----------
    mechanism : Mechanism
        Pins, cranks, ratio; without a dead centre.
    exponent : float
        Exponent v of the force over the approach.
    """

    def __init__(self, mechanism: Mechanism, exponent: float) -> None:
        pins, cranks = mechanism.pins, np.array(mechanism.crank_angles)
        self.exponent = exponent
        self.pitch = 2 * math.pi / pins
        self.satellite = np.repeat(np.arange(len(cranks)), pins)
        self.pin = np.tile(np.arange(pins), len(cranks))
        self.phase = cranks[self.satellite] + self.pin * self.pitch + math.pi / 2

    @property
    def segments(self) -> list[tuple[float, float]]:
        """Places of the wave between which the same pairs drive, rad."""
        cuts = np.concatenate((math.pi / 2 - self.phase, -math.pi / 2 - self.phase)) % self.pitch
        ends = np.concatenate(([0.0], np.sort(cuts), [self.pitch])).tolist()
        return [(low, high) for low, high in pairwise(ends) if high - low > SHORT]

    def at(self, wave: FloatArray, within: float) -> Position:
        """Driving pairs of the segment that a place is within, at places of it.

        Parameters
        ----------
        wave : array, shape (n,)
            Places, rad.
        within : float
            Place that says which pairs drive, rad.
        """
        drives = np.cos(within + self.phase) > 0
        angle = np.remainder(wave[:, None] + self.phase[drives] + math.pi, 2 * math.pi) - math.pi
        cosine = np.maximum(np.cos(angle), 0.0)
        force = cosine**self.exponent / (cosine ** (1 + self.exponent)).sum(axis=1, keepdims=True)
        return Position(self.satellite[drives], self.pin[drives], angle, force)

    def worst(self, measure: Measure) -> Position:
        """The position at which a value is largest over the turn.

        Parameters
        ----------
        measure : callable
            Values of positions, shape (n,).

        Returns
        -------
        Position
            Of one place.
        """
        return first_largest(self._tops(measure))

    def _tops(self, measure: Measure) -> Iterator[tuple[float, Position]]:
        """The largest value of each segment, and its position."""
        for low, high in self.segments:
            middle = (low + high) / 2

            def values(wave: FloatArray, within: float = middle) -> FloatArray:
                return measure(self.at(wave, within))

            steps = np.linspace(low, high, STEPS + 1)
            top = int(values(steps).argmax())
            place, value, _ = zoom(
                values=values,
                places=steps[top : top + 1],
                width=(high - low) / STEPS,
                low=low,
                high=high,
            )
            yield float(value[0]), self.at(place, middle)
