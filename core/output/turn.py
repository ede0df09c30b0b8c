"""Positions of the mechanism as it is made, over the turn of the wave."""

import math
from collections.abc import Iterable, Sequence

import numpy as np

from core.arrays import FloatArray
from core.numerics.extremes import Narrow
from core.output.compiled import at_hand
from core.output.real_mechanism import RealMechanism
from core.output.sharing_kernel import (
    BACKLASH,
    LOST_MOTION,
    PLAY_END,
    Load,
    PairForces,
    Pairs,
    Poses,
    Room,
)
from core.output.summits import Grid

POSITIONS = 720
"""Positions of the turn at least, a multiple of the pairs: equal summits look equal on the grid."""

CLUSTER = 8
"""How often the distance to a pair's dead angle, where it takes up or leaves, is halved."""

MOST_CLUSTERED = 2880
"""Positions at dead angles at most: with many pairs the grid itself is dense enough there."""

SOLVES = {PLAY_END: 0, BACKLASH: 0, LOST_MOTION: 2}
"""Positions that are solved for a value; 1 for all others."""


class Turn:
    """The mechanism under a torque, over the turn; refusals as `RealMechanism.solved`."""

    def __init__(self, real: RealMechanism, torque: float, share: float = 1.0) -> None:
        self.real = real
        self.kernel = at_hand() if real.shared is None else real.loops
        direction = math.copysign(1.0, torque)
        self.load = Load(abs(torque), share, real.setup(direction), real.setup(-direction))
        self.pairs = Pairs(*map(self.kernel.row, real.pairs))
        self.room = Room(*map(self.kernel.row, real.room()))
        self.evaluations = 0

    @property
    def pair_force(self) -> list[float]:
        """Largest force of each pair so far, N."""
        return list(map(float, self.room.most))

    def poses(self, places: Sequence[float]) -> dict[str, FloatArray]:
        """Positions at wave angles, rad: rows by the names of `Poses`."""
        self.evaluations += len(places)
        results = Poses(*[self.kernel.row([0.0] * len(places)) for _ in Poses._fields])
        self._refused(
            places,
            self.kernel.poses(
                self.kernel.row(places),
                self.load.torque,
                self.load.setup,
                self.pairs,
                self.room,
                results,
            ),
        )
        return {name: np.array(row) for name, row in results._asdict().items()}

    def forces(self, places: Sequence[float]) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Forces of all pairs at wave angles, rad, shape (n, K*N); lags and errors, shape (n,)."""
        self.evaluations += len(places)
        count, row = len(self.pairs.a), self.kernel.row
        results = PairForces(*(row([0.0] * len(places) * many) for many in (count, 1, 1)))
        rows = row(places), self.load.torque, self.load.setup, self.pairs, self.room, results
        self._refused(places, self.kernel.pair_forces(*rows))
        force, lag, error = map(np.array, results)
        return force.reshape(-1, count), lag, error

    def values(self, kind: int, places: Iterable[float]) -> Grid:
        """A quantity at wave angles, rad."""
        where = [*places]
        self.evaluations += len(where) * SOLVES.get(kind, 1)
        results = self.kernel.row([0.0] * len(where))
        rows = self.kernel.row(where), self.load, self.pairs, self.room, results
        self._refused(where, self.kernel.values(kind, *rows))
        return Grid(np.array(where), np.array(results))

    def narrow(self, kind: int, sign: int = 1) -> Narrow:
        """How the largest value of a quantity between two places is found; for the sign -1 the
        least, as its opposite.
        """

        def narrowed(low: float, high: float) -> tuple[float, float, float]:
            place, height, error, looks = self.kernel.narrow(
                kind, sign, low, high, self.load, self.pairs, self.room
            )
            if not looks:
                self._refuse(place)
            self.evaluations += looks * SOLVES.get(kind, 1)
            return place, sign * height, error

        return narrowed

    def _refused(self, places: Sequence[float], first: int) -> None:
        if first >= 0:
            self._refuse(places[first])

    def _refuse(self, psi: float) -> None:
        """Say why a position cannot be."""
        load, room = self.load, self.real.room()
        self.real.solved(psi, load.torque, load.setup, room)
        for setup in (load.setup, load.back):
            self.real.solved(psi, load.share * load.torque, setup, room)

    def positions(self) -> tuple[list[float], list[float]]:
        """Wave angles of an even grid, and those around dead angles."""
        pairs, pins = self.real.pairs, self.load.setup.pins
        many = pins * self.load.setup.satellites
        count = many * -(-POSITIONS // many)
        step = 2 * math.pi / count
        first = self.real.mechanism.initial_crank_angle
        grid = [first + step * i for i in range(count)]
        dead = {
            round((half - pairs.phase[j] - 2 * math.pi * n / pins - first) % (2 * math.pi), 9)
            for half in (0.0, math.pi)
            for j in range(self.load.setup.satellites)
            for n in range(pins)
        }
        halvings = min(CLUSTER, MOST_CLUSTERED // (2 * len(dead)))
        near = [
            first + (place + sign * step * 2.0**-k) % (2 * math.pi)
            for place in dead
            for k in range(1, halvings + 1)
            for sign in (-1, 1)
        ]
        return grid, near
