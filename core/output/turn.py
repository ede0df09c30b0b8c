"""The mechanism as it is made under a torque, over the turn of the wave: all that is read of a turn
is read here.

Positions are solved once, when they are first asked for. Where all pins are alike the turn repeats
with each of them, and only one pitch of it is solved.
"""

import math
from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

from core.arrays import FloatArray
from core.drive import engine
from core.errors import derived
from core.numerics.extremes import Narrow, other_places
from core.output.stage import Solved, Stage
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

OF_PLAY = engine.HIGH, engine.PLAY
"""Read-outs for which no position is solved."""

Rows = dict[str, Any]
"""Quantities at positions by their names, each shape (n,); the forces of all pairs, shape (n, K*N);
of each disc how far it lags `behind`, and is `off` its place on its crank, as `Solved.discs`; and
`wave`, the angles of the engine, rad."""


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
        self.real: Any = real
        self.torque, self.share = float(torque), float(share)
        self.room = Solved.of(real.drive)
        pins = real.kind == engine.PIN
        self.force = engine.PIN_FORCE if pins else engine.LOBE_FORCE
        """Read-out of the largest force; those of pressure and loaded pairs come next to it."""
        self.pressure = self.force + 1
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
        """Positions of which the play is not asked."""
        return self.poses(places, play=False)

    def poses(self, places: Sequence[float], *, play: bool = True) -> Rows:
        """Positions at angles of the engine, rad."""
        self.evaluations += len(places)
        room = self.real.solved(places, self.torque, play=False)
        free, pressed = room.play, room.pressed
        if play:
            free, pressed = self.real.free(places, self.torque)
        found = {
            "forces": room.forces[:, room.contacts(self.real.kind)],
            "lag": room.lag,
            "stiffness": room.stiffness,
            "force": room.rows[:, self.force],
            "pressure": room.rows[:, self.pressure],
            "loaded": room.rows[:, self.force + 2],
            "low": free[:, 0],
            "high": free[:, 1],
            "error": room.error,
            "input_torque": room.input_torque,
            "pressed": pressed,
            "wave": np.array(places),
        }
        found["behind"], found["off"] = room.discs
        return found | self.of_ring(room)

    def of_ring(self, room: Solved) -> Rows:
        """What positions have of a ring."""
        teeth = room.contacts(engine.LOBE)
        if teeth.stop == 0:
            return {}
        way = math.copysign(1.0, self.torque)
        return {
            "mesh_force": room.rows[:, engine.LOBE_FORCE],
            "mesh_pressure": room.rows[:, engine.LOBE_PRESSED],
            "mesh_loaded": room.rows[:, engine.LOBE_LOADED],
            "along": room.by_ring[:, :, 0],
            "across": room.by_ring[:, :, 1],
            "teeth": room.forces[:, teeth],
            "own": way * room.lags[:, 1 : 1 + self.real.mechanism.satellites],
        }

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
        """A read-out of the engine at its angles over a turn, or over so much of it, rad."""
        where = [*places]
        if kind in OF_PLAY:
            way = math.copysign(1.0, self.torque)
            return Grid(np.array(where), self.real.unloaded(np.array(where), way)[:, kind], period)
        ways = (1, -1) if kind == engine.LOST else (1,)
        self.evaluations += len(where) * len(ways)
        torque = self.torque * (self.share if kind == engine.LOST else 1)
        looked = engine.LAG if kind == engine.LOST else kind
        rows = [self.real.solved(where, way * torque, play=False).rows for way in ways]
        heights: FloatArray = np.sum([each[:, looked] for each in rows], axis=0)
        return Grid(np.array(where), heights, period)

    def narrow(self, kind: int, sign: int = 1) -> Narrow:
        """How the largest value of a read-out between two places is found; for the sign -1 the
        least, as its opposite.
        """
        room = self.room

        def narrowed(low: float, high: float) -> tuple[float, float, float]:
            given = kind, sign, low, high, self.torque, self.share
            place, height, error, looks = engine.narrow(*given, room.drive, room.work, room.rows[0])
            if not looks:
                status = int(room.rows[0, engine.STATUS])
                self.real.refuse(angle=place, status=status, room=room)
            if kind not in OF_PLAY:
                self.evaluations += looks * (2 if kind == engine.LOST else 1)
            return float(place), float(sign * height), float(error)

        return narrowed

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
