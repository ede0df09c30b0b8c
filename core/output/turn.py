"""The mechanism as it is made under a torque, over the turn of the wave: all that is read of a turn
is read here.

Positions are solved once, when they are first asked for. Where all pins are alike the turn repeats
with each of them, and only one pitch of it is solved.
"""

import math
from collections.abc import Callable, Iterable, Sequence
from typing import Any

import numpy as np

from core.arrays import FloatArray
from core.errors import derived
from core.numerics.extremes import Narrow, other_places
from core.output.loop_rows import BACKLASH, LOST_MOTION, PLAY_END, Load, Poses
from core.output.stage import Stage
from core.output.summits import Grid

POSITIONS = 720
"""Positions of the turn at least, a multiple of the pairs: equal summits look equal on the grid."""

CLUSTER = 8
"""How often the distance to a pair's dead angle, where it takes up or leaves, is halved."""

MOST_CLUSTERED = 2880
"""Positions at dead angles at most: with many pairs the grid itself is dense enough there."""

LOOKED_AGAIN = 461
"""Positions of the second look over a turn: so many as a third of the time allows."""

LEAST_AGAIN = 37
"""The same over a pitch at least."""

SOLVES = {PLAY_END: 0, BACKLASH: 0, LOST_MOTION: 2}
"""Positions that are solved for a value; 1 for all others."""

Rows = dict[str, FloatArray]
"""Quantities at positions by the names of `core.output.loop_rows.Poses`, each shape (n,); the
forces of all pairs, shape (n, K*N); and `wave`, the wave angles, rad."""


class Turn:
    """The mechanism under a torque, over the turn; refusals as `Stage.solved`.

    Parameters
    ----------
    real : Stage
        The mechanism.
    torque : float
        On the output link, N*m, not 0; negative in reverse.
    share : float
        Share of the torque under which the lost motion is taken.
    """

    def __init__(self, real: Stage, torque: float, share: float = 0.03) -> None:
        self.start(real, torque, share)
        self.kernel = real.loops_of_turns
        direction = math.copysign(1.0, torque)
        self.load = Load(
            abs(float(torque)), float(share), real.setup(direction), real.setup(-direction)
        )
        self.pairs, self.room = (
            as_rows(values=each, row=self.kernel.row) for each in (real.pairs, real.room())
        )

    def start(self, real: Stage, torque: float, share: float) -> None:
        """What any turn has."""
        self.real: Any = real
        self.torque, self.share = float(torque), float(share)
        self.evaluations = 0
        self.repeats = real.mechanism.pins if real.pins_alike else 1
        """How often the turn repeats: from one period to the next a pin feels what the next one
        felt.
        """
        self.period = 2 * math.pi / self.repeats
        self.step = 1 if self.repeats > 1 else 0
        """By how many pins that is."""
        self.waves = 1
        """Turns of the wave after which a pin feels the same again."""
        self.first = real.mechanism.initial_crank_angle
        """Wave angle at the crank angle 0."""

    def of_pairs(self, largest: FloatArray) -> FloatArray:
        """Largest values of all pairs over the turn, by those over a period."""
        if self.repeats == 1:
            return largest
        own = largest.reshape(-1, self.repeats)
        return np.broadcast_to(own.max(axis=1, keepdims=True), own.shape).ravel()

    def between(self, places: Sequence[float]) -> Rows:
        """Positions between others, of which the play need not be known."""
        return self.poses(places)

    def poses(self, places: Sequence[float]) -> Rows:
        """Positions at wave angles, rad."""
        self.evaluations += len(places)
        own = self.real.mechanism
        row, many, pairs = self.kernel.row, len(places), own.pins * own.satellites
        results = Poses(
            *[row([0.0] * many * (pairs if name == "forces" else 1)) for name in Poses._fields]
        )
        given = self.load.torque, self.load.setup, self.pairs, self.room, results
        self._refused(places, self.kernel.poses(row(places), *given))
        rows = {name: np.array(each) for name, each in results._asdict().items()}
        rows["forces"] = rows["forces"].reshape(many, pairs)
        return rows | {"wave": np.array(places)}

    def at_waves(self, places: FloatArray) -> Rows:
        """Positions at wave angles of the output, rad."""
        return self.poses(places.tolist())

    @derived
    def coarse(self) -> Rows:
        """Positions of an even grid and around dead angles, over a period."""
        even, near = self.positions()
        return self.poses(sorted({*even, *near}))

    @derived
    def fine(self) -> Rows:
        """The same, and in the middles of the even grid."""
        even, near = self.positions()
        middle = (even[1] - even[0]) / 2
        between = {psi + middle for psi in even} - {*even, *near}
        return joined(one=self.coarse, other=self.poses(sorted(between)))

    @derived
    def again(self) -> Rows:
        """Positions of the second look, none of which is one of the others, over a period."""
        places = other_places(count=self.looked_again, first=self.first, period=self.period)
        return self.poses(places.tolist())

    @property
    def looked_again(self) -> int:
        """Positions of the second look."""
        return max(LOOKED_AGAIN // self.repeats, LEAST_AGAIN)

    def values(self, kind: int, places: Iterable[float], period: float = 2 * math.pi) -> Grid:
        """A quantity at wave angles over a turn, or over so much of it, rad."""
        where = [*places]
        self.evaluations += len(where) * SOLVES.get(kind, 1)
        results = self.kernel.row([0.0] * len(where))
        rows = self.kernel.row(where), self.load, self.pairs, self.room, results
        self._refused(where, self.kernel.values(kind, *rows))
        return Grid(np.array(where), np.array(results), period)

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
        load, room, place = self.load, self.real.room(), float(psi)
        self.real.solved(place, load.torque, load.setup, room)
        for setup in (load.setup, load.back):
            self.real.solved(place, load.share * load.torque, setup, room)

    def positions(self) -> tuple[list[float], list[float]]:
        """Wave angles of an even grid over a period, and those around dead angles."""
        phases, pins = self.real.phases, self.real.mechanism.pins
        many = pins * len(phases)
        count = many * -(-POSITIONS // many)
        step = 2 * math.pi / count
        first = self.first
        grid = [first + step * i for i in range(count // self.repeats)]
        dead = {
            round((half - phase - 2 * math.pi * n / pins - first) % self.period, 9)
            for half in self.real.dead_angles
            for phase in phases
            for n in range(pins)
        }
        halvings = min(CLUSTER, MOST_CLUSTERED // (2 * len(dead)))
        near = [
            first + (place + sign * step * 2.0**-k) % self.period
            for place in dead
            for k in range(1, halvings + 1)
            for sign in (-1, 1)
        ]
        return grid, near


def as_rows(*, values: Any, row: Callable[[Any], Any]) -> Any:
    """Rows as loops take them, of which parts are rows too.

    Parameters
    ----------
    values : named tuple
        Rows, or named tuples of such.
    row : callable
        Makes one of what loops at hand take.

    Returns
    -------
    named tuple
    """
    if isinstance(values, tuple):
        return type(values)(*[as_rows(values=each, row=row) for each in values])
    if isinstance(values, memoryview) and row is list:
        return values
    return row(values)


def joined(*, one: Rows, other: Rows) -> Rows:
    """Two sets of positions as one, in the order of their wave angles.

    Parameters
    ----------
    one, other : dict of array
        Positions.

    Returns
    -------
    dict of array
    """
    order = np.argsort(np.concatenate((one["wave"], other["wave"])), kind="stable")
    return {name: np.concatenate((row, other[name]))[order] for name, row in one.items()}
