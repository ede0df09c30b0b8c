"""Loads of a satellite over the turn, the slow way: integrated and narrowed at 64 bits.

Nothing is shared with ``core``: every pair by its own cosine, no symmetry beyond the pin spacing.
"""

from collections.abc import Callable, Sequence
from itertools import pairwise
from typing import Any

import numpy as np
from mpmath import mp, mpf

from tests.oracles.crank_planetary import breaks, phases
from tests.oracles.pin_turn import WAY, Turn, gap, long, narrowed

STEP = 1 / 256
"""Of the double exponential rule: so fine as the size of a sum that nearly vanishes needs."""


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

        most = self.largest(load)
        mean = self.mean(load, most, long(exponent))
        least = -self.largest(lambda part, way: -load(part, way))
        share = self.largest(lambda part, way: self.at(part, way)[0])
        found = (least, most, mean, share)
        return tuple(mpf(np.format_float_scientific(x)) for x in found)  # type: ignore[return-value]

    def mean(self, load: Callable[[int, Any], Any], most: Any, power: Any) -> Any:
        """Equivalent load by the double exponential rule."""
        integral = turn = np.longdouble(0)
        for part, (width, *_) in enumerate(self.parts):
            values = (load(part, NODES) / most) ** power
            integral, turn = integral + width * (WEIGHTS * values).sum(), turn + width
        return most * (integral / turn) ** (1 / power)

    def largest(self, value: Callable[[int, Any], Any]) -> Any:
        """Largest value over all segments, narrowed about every summit of samples."""
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


class ShaftTurn:
    """Loads of all satellites together on a bearing of the crankshaft."""

    def __init__(self, pins: int, crank_angles: Sequence[mpf], exponent: mpf) -> None:
        every = range(len(crank_angles))
        self.satellites = [SatelliteTurn(pins, crank_angles, exponent, j) for j in every]
        self.cranks = [(long(mp.cos(angle)), long(mp.sin(angle))) for angle in crank_angles]

    def reaction(
        self,
        held: Sequence[mpf],
        across: mpf,
        along: mpf,
        rho: mpf,
        exponent: mpf,
        still: tuple[mpf, mpf] = (mpf(0), mpf(0)),
    ) -> tuple[mpf, mpf, mpf]:
        """Largest and equivalent reaction, and largest sum of the sizes that it is made of.

        The bearing holds the part `held` of the force of each satellite: of `across` times its
        share forward of its crank, of `rho` times that and `along` times its pins along it; and
        what stands still, along and across the zero of the cranks.
        """
        size = max(map(abs, held)) * (across + along) + max(map(abs, still)) or mpf(1)
        rest = [long(each / size) for each in still]
        parts = [[long(each * arm / size) for arm in held] for each in (across, along)]
        radial = long(rho)

        def forces(part: int, way: Any) -> Any:
            for own, crank, a, b in zip(self.satellites, self.cranks, *parts, strict=True):
                share, force = own.at(part, way)
                yield crank, a * share, radial * a * share + b * force

        def load(part: int, way: Any) -> Any:
            x, y = (np.full_like(way, each) for each in rest)
            for (cos, sin), tangential, inward in forces(part, way):
                x, y = x + inward * cos - tangential * sin, y + inward * sin + tangential * cos
            return np.hypot(x, y)

        def sizes(part: int, way: Any) -> Any:
            own = sum(abs(one) + abs(other) for _, one, other in forces(part, way))
            return own + abs(rest[0]) + abs(rest[1])

        first = self.satellites[0]
        most = first.largest(load)
        whole, power = first.largest(sizes), long(exponent)
        mean = first.mean(load, most, power) if most > 0 else most
        return tuple(size * mpf(np.format_float_scientific(x)) for x in (most, mean, whole))  # type: ignore[return-value]
