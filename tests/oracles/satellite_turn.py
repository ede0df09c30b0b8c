"""What a satellite does over the turn, the slow way: integrated and narrowed at 64 bits.

Nothing is shared with ``core``: every pair by its own cosine, no symmetry beyond the pin spacing.
"""

from collections.abc import Callable, Sequence
from itertools import pairwise
from typing import Any

import numpy as np
from mpmath import mp, mpf

from tests.oracles.crank_planetary import breaks, phases
from tests.oracles.pin_turn import WAY, Turn, gap, long, narrowed

STEP = 1 / 64
"""Of the double exponential rule."""


def rule() -> tuple[Any, Any]:
    """Parts of the way, and weights; those beyond are nothing."""
    t = np.arange(-3.6, 3.6, STEP).astype(np.longdouble) + STEP / 2
    inner = np.longdouble(mp.nstr(mp.pi, 25)) / 2 * np.sinh(t)
    way = 1 / (1 + np.exp(-2 * inner))
    weights = np.longdouble(mp.nstr(mp.pi, 25)) * np.cosh(t) * way * (1 - way) * STEP
    return way, weights


NODES, WEIGHTS = rule()


class SatelliteTurn:
    """Share of the torque and sum of the pins' forces over F0, segment by segment."""

    def __init__(
        self, pins: int, crank_angles: Sequence[mpf], exponent: mpf, satellite: int
    ) -> None:
        rows = phases(pins, crank_angles)
        self.exponent = long(exponent)
        self.parts = []
        for start, stop in pairwise(breaks([t for row in rows for t in row], 2 * mp.pi / pins)):
            middle = (start + stop) / 2
            every, own = (
                [t for row in some for t in row if mp.sin(middle + t) < 0]
                for some in (rows, rows[satellite : satellite + 1])
            )
            angles = [Turn.angles(start, stop, each) for each in (every, own)]
            self.parts.append((long(stop - start), *angles))

    def at(self, part: int, way: Any) -> tuple[Any, Any]:
        """Share and force at parts of the way along a segment."""
        width, *pairs = self.parts[part]
        every, own = (
            np.maximum(-signs[:, None] * np.sin(beyond[:, None] + width * way), 0)
            if len(beyond)
            else np.zeros((1, len(way)), np.longdouble)
            for beyond, signs in pairs
        )
        best = every.max(axis=0)
        total = ((every / best) ** self.exponent * every).sum(axis=0)
        powers = (own / best) ** self.exponent / total
        if not len(pairs[1][0]):
            powers = np.zeros_like(own)
        return (powers * own).sum(axis=0), powers.sum(axis=0)

    def loads(self, ratio: mpf, along: mpf, exponent: mpf) -> tuple[mpf, mpf, mpf, mpf]:
        """Least, largest and equivalent load, and largest share; loads over T/(e*u)."""
        rho, pins = long(ratio), long(along)

        def load(part: int, way: Any) -> Any:
            share, force = self.at(part, way)
            return np.hypot(share, rho * share + pins * force)

        integral = turn = np.longdouble(0)
        power = long(exponent)
        most = self.largest(load)
        for part, (width, *_) in enumerate(self.parts):
            values = (load(part, NODES) / most) ** power
            integral, turn = integral + width * (WEIGHTS * values).sum(), turn + width
        least = -self.largest(lambda part, way: -load(part, way))
        share = self.largest(lambda part, way: self.at(part, way)[0])
        mean = most * (integral / turn) ** (1 / power)
        found = (least, most, mean, share)
        return tuple(mpf(np.format_float_scientific(x)) for x in found)  # type: ignore[return-value]

    def largest(self, value: Callable[[int, Any], Any]) -> Any:
        """Of all segments, narrowed about every summit of samples."""
        best = -np.inf
        for part in range(len(self.parts)):
            values = value(part, WAY)
            padded = np.concatenate(([-np.inf], values, [-np.inf]))
            for node in np.flatnonzero((values >= padded[:-2]) & (values > padded[2:])):
                if values[node] < best - abs(best) * 1e-2:
                    continue

                def grid(grids: Any, part: int = part) -> tuple[Any, Sequence[int]]:
                    found = value(part, grids[0])
                    return found.max(), (int(found.argmax()),)

                best = max(best, narrowed(grid, [WAY[node]], [(0, 1)], [gap(int(node))]))
        return best
