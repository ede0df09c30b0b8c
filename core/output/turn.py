"""Positions of a mechanism as made over the turn of the wave, under one torque.

All results over a turn are read here. Positions are solved once, when they are first asked for. If
all pins are alike, the turn repeats with each of them, and only one pitch is solved.
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
from core.output.summits import Grid, Summit

POSITIONS = 720
"""Least number of positions of the turn; a multiple of the pairs keeps equal summits equal."""

CLUSTER = 8
"""Number of halvings of the distance to a pair's dead angle, where the pair takes up or leaves."""

MOST_CLUSTERED = 2880
"""Largest number of positions at dead angles: with many pairs the grid itself is dense enough."""

LOOKED_AGAIN = 461
"""Number of positions of the second look over a turn, for about a third of the time."""

LEAST_AGAIN = 37
"""Least number of positions of the second look over a pitch."""

OF_PLAY = engine.HIGH, engine.PLAY
"""Read-outs that need no solved position."""

Rows = dict[str, Any]
"""Quantities at n positions by their names, each of shape (n,): `forces` of all pairs (n, K*N), lag
of each disc (`behind`) and its shift on its crank (`off`) as in `Solved.discs`, `wave` the angles
of the engine, rad.
"""


class Turn:
    """Mechanism under a torque on the output link, N*m, over the turn.

    The torque is not 0 and negative in reverse; `Stage.solved` says what is refused. The lost
    motion is taken under `share` of it.
    """

    def __init__(self, real: Stage, torque: float, share: float = 0.03) -> None:
        self.real: Any = real
        self.torque, self.share = float(torque), float(share)
        self.room = Solved.of(real.drive)
        pins = real.kind == engine.PIN
        self.force = engine.PIN_FORCE if pins else engine.LOBE_FORCE
        """Read-out of the largest force; pressure and number of loaded pairs are the next two."""
        self.pressure = self.force + 1
        self.evaluations = 0
        self.repeats = real.mechanism.pins if real.pins_alike else 1
        """Number of periods in the turn; after one, a pin has the force of the next pin."""
        self.period = 2 * math.pi / self.repeats
        self.step = 1 if self.repeats > 1 else 0
        """Shift in pins from one period to the next."""
        self.waves = 1
        """Turns of the wave after which a pin's force repeats."""
        self.first = real.mechanism.initial_crank_angle
        """Wave angle at the crank angle 0, rad."""

    def of_pairs(self, largest: FloatArray) -> FloatArray:
        """Largest values of all pairs over the turn, from those over a period."""
        own = largest.reshape(self.real.mechanism.satellites, self.repeats, -1)
        return np.broadcast_to(own.max(axis=1, keepdims=True), own.shape).ravel()

    def poses(self, places: Sequence[float], *, play: bool = True) -> Rows:
        """Solved positions at angles of the engine, rad."""
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
        """Quantities of a ring's mesh at solved positions; empty without a ring."""
        teeth = room.contacts(engine.LOBE)
        if teeth.stop == 0:
            return {}
        way, discs = math.copysign(1.0, self.torque), self.real.mechanism.satellites
        # Discs of the ring alone have the output's lag, or each its own; in series they come next.
        first = 1 if self.real.kind == engine.PIN else 0
        own = room.lags[:, first : first + discs]
        return {
            "mesh_force": room.rows[:, engine.LOBE_FORCE],
            "mesh_pressure": room.rows[:, engine.LOBE_PRESSED],
            "mesh_loaded": room.rows[:, engine.LOBE_LOADED],
            "along": room.by_ring[:, :, 0],
            "across": room.by_ring[:, :, 1],
            "teeth": room.forces[:, teeth],
            "own": way * np.repeat(own, discs // own.shape[1], axis=1),
        }

    def at_waves(self, places: FloatArray) -> Rows:
        """Positions at wave angles of the output, rad."""
        return self.poses(places.tolist())

    @derived
    def places(self) -> tuple[list[float], list[float]]:
        """Angles of an even grid and around dead angles over a period, rad, and the middles of the
        even steps.
        """
        even, near = self.positions()
        middle = (even[1] - even[0]) / 2
        coarse = {*even, *near}
        return sorted(coarse), sorted({psi + middle for psi in even} - coarse)

    @derived
    def coarse(self) -> Rows:
        """Positions of an even grid and around dead angles, over a period."""
        return self.poses(self.places[0])

    @derived
    def fine(self) -> Rows:
        """Positions of the coarse grid and of the middles of its even steps."""
        return joined(one=self.coarse, other=self.poses(self.places[1]))

    @derived
    def again(self) -> Rows:
        """Positions of the second look over a period, none of which is on the grid."""
        places = other_places(count=self.looked_again, first=self.first, period=self.period)
        return self.poses(places.tolist())

    @property
    def looked_again(self) -> int:
        """Number of positions of the second look."""
        return max(LOOKED_AGAIN // self.repeats, LEAST_AGAIN)

    def values(self, kind: int, places: Iterable[float], period: float = 2 * math.pi) -> Grid:
        """Read-out of the engine at places, rad, over a period."""
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

    def narrow(self, kind: int, sign: int = 1, known: Sequence[Summit] = ()) -> Narrow:
        """Function that finds a read-out's largest value about five places; least for sign -1. It
        closes in no further on known summits.
        """
        room = self.room

        def narrowed(places: FloatArray, heights: FloatArray) -> tuple[float, float, float]:
            first, last = places[1], places[3]
            near = (
                (each.height, first + (place - first) % self.period)
                for each in known
                for place in each.alike
            )
            least, at = next((each for each in near if each[1] < last), (-math.inf, math.nan))
            given = kind, sign, places, heights, least, at, self.torque, self.share
            place, height, error, looks = engine.narrow(*given, room.drive, room.work, room.rows[0])
            if looks < 0:
                status = int(room.rows[0, engine.STATUS])
                self.real.refuse(angle=place, status=status, room=room)
            if kind not in OF_PLAY:
                self.evaluations += looks * (2 if kind == engine.LOST else 1)
            return float(place), float(sign * height), float(error)

        return narrowed

    def positions(self) -> tuple[list[float], list[float]]:
        """Wave angles of an even grid over a period, and those around dead angles, rad."""
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
    """Two sets of positions as one, in the order of their wave angles."""
    order = np.argsort(np.concatenate((one["wave"], other["wave"])), kind="stable")
    return {name: np.concatenate((row, other[name]))[order] for name, row in one.items()}
