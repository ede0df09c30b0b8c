"""Pins and discs that share a torque: positions as the engine solves them."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from core.arrays import BoolArray, ComplexArray, FloatArray
from core.drive import engine
from core.drive.engine import Drive, Work
from core.drive.model import Pieces, work_for
from core.errors import ImpossibleMechanism
from core.output.mechanism import Mechanism
from core.precision import ROUNDING

REFUSALS = {
    engine.NO_DRIVE: "dead_centre",
    engine.NOT_STABLE: "not_stable",
    engine.NOT_SOLVED: "not_balanced",
    engine.TOO_WIDE: "beyond_hertz",
}
"""What a position is refused as that cannot be."""

CLASS = 5 * engine.CLASS
"""Error of the forces of positions over the largest: of the method, not of a call."""

ROUNDED = 32 * ROUNDING
"""Part of a displacement that its sums may lose."""


@dataclass(frozen=True, slots=True)
class Solved:
    """Room for positions of a drive, and what they leave there, position by position."""

    drive: Drive
    work: Work
    rows: FloatArray  # read-outs of the engine, [m, 21]
    lags: FloatArray  # of the bodies, against the direction of the output, rad
    forces: FloatArray  # of all contacts, N
    wrench: FloatArray  # of each group on its disc: along the crank, across it, about its centre
    plays: FloatArray  # of each disc in its ring, rad, [m, bodies, 2]

    @classmethod
    def of(cls, pieces: Pieces, count: int = 1) -> "Solved":
        """Room for so many positions of the first piece.

        Parameters
        ----------
        pieces : Pieces
            The drive.
        count : int
            How many positions.

        Returns
        -------
        Solved
        """
        drive, blank = pieces.drive(), np.zeros
        bodies = len(drive.share)
        return cls(
            drive,
            work_for(drive),
            blank((count, engine.INTERFERENCE + 1)),
            blank((count, bodies)),
            blank((count, len(drive.ci))),
            blank((count, len(drive.gi), 3)),
            blank((count, bodies, 2)),
        )

    def at(self, places: FloatArray, torque: float, *, play: bool = True) -> int:
        """Solve positions; the first that cannot be, or -1.

        Parameters
        ----------
        places : array, shape (m,)
            Angles of the engine, rad.
        torque : float
            N*m, negative in reverse.
        play : bool
            True where the play is asked too.

        Returns
        -------
        int
        """
        given = places, torque, play, self.drive, self.work
        left = self.rows, self.lags, self.forces, self.wrench, self.plays
        return engine.positions(*given, *left)

    def contacts(self, kind: int) -> slice:
        """The contacts of a kind, which lie together.

        Parameters
        ----------
        kind : int
            `engine.PIN` or `engine.LOBE`.

        Returns
        -------
        slice
        """
        gi = self.drive.gi[self.drive.gi[:, engine.KIND] == kind]
        return slice(gi[0, engine.START], gi[-1, engine.STOP]) if len(gi) else slice(0, 0)

    def on_discs(self, *kinds: int) -> FloatArray:
        """Forces of kinds of contacts on each disc along its crank, across it, and their torque.

        Parameters
        ----------
        *kinds : int
            Of groups.

        Returns
        -------
        array, shape (m, K, 3)
        """
        found = [self.wrench[:, self.drive.gi[:, engine.KIND] == kind] for kind in kinds]
        total: FloatArray = np.sum([each for each in found if each.shape[1]], axis=0)
        return total

    @property
    def by_ring(self) -> FloatArray:
        """Forces of the ring on each disc."""
        return self.on_discs(engine.LOBE, engine.FLANK)

    @property
    def discs(self) -> tuple[FloatArray, ComplexArray]:
        """Lag of each disc against the direction of the output, rad, and its shift on its crank,
        along it and i times across it, m, shape (m, K).
        """
        drive, first = self.drive, self.drive.gi[:, engine.KIND] == self.drive.gi[0, engine.KIND]
        gi, late = drive.gi[first], drive.gf[first, engine.LATE]
        moves = np.pad(self.lags, ((0, 0), (0, 1)))  # the last one of what does not move
        own, along, across, turn = (
            moves[:, gi[:, each]] for each in (engine.OWN, engine.ALONG, engine.ACROSS, engine.TURN)
        )
        output = self.lags @ drive.share
        return late + own + output[:, None] - turn, along + 1j * across

    @property
    def lag(self) -> FloatArray:
        """Lag of the output, counted as the torque turns, rad."""
        return np.asarray(self.rows[:, engine.LAG])

    @property
    def stiffness(self) -> FloatArray:
        """Torque over the lag, N*m/rad."""
        return np.asarray(self.rows[:, engine.STIFFNESS])

    @property
    def play(self) -> FloatArray:
        """Least and largest lag without load, counted as the torque turns, rad, shape (m, 2)."""
        return np.asarray(self.rows[:, engine.LOW : engine.HIGH + 1])

    @property
    def pressed(self) -> BoolArray:
        """True where pairs of any stage press without load."""
        pressed: BoolArray = self.rows[:, engine.PRESSED] > 0
        return pressed

    @property
    def jammed(self) -> BoolArray:
        """True where the output has no play, as pairs press."""
        jammed: BoolArray = self.play[:, 0] > self.play[:, 1] + engine.LEAST_PLAY
        return jammed

    @property
    def input_torque(self) -> FloatArray:
        """Torque that turns the crank without friction, N*m."""
        return np.asarray(self.rows[:, engine.INPUT_TORQUE])

    @property
    def steps(self) -> int:
        """Steps of all positions."""
        return int(self.rows[:, engine.STEPS].sum())

    @property
    def error(self) -> FloatArray:
        """Error of the forces, N: of the method, and by rounding of what moves, which counts under
        a torque of next to nothing.
        """
        radius = float(self.drive.gf[0, engine.CIRCLE])  # of the pins
        rounded = ROUNDED * self.stiffness * np.abs(self.lags).max(axis=1) / radius
        return np.asarray(CLASS * self.forces.max(axis=1) + rounded)


class Stage:
    """Output pins in the holes of discs, a ring of pins on the teeth of discs, or both."""

    mechanism: Mechanism  # pins and cranks; of a ring the wave turns with the crank
    support: Any  # what of the satellites gives, or their given shares; None where they are rigid
    kind = engine.PIN
    """Contacts whose forces are those of the stage."""

    @property
    def drive(self) -> Pieces:
        """The drive as the engine takes it."""
        raise NotImplementedError

    @property
    def phases(self) -> Sequence[float]:
        """Angles of the cranks with their errors, rad."""
        raise NotImplementedError

    @property
    def pins_alike(self) -> bool:
        """True where all pins are alike, and all that they touch of a satellite."""
        raise NotImplementedError

    @property
    def dead_angles(self) -> tuple[float, ...]:
        """Angles from the crank at which a pin takes up or leaves, rad."""
        return 0.0, math.pi

    def wave(self, crank_angle: float) -> float:
        """Angle of the engine at a crank angle, rad: that of the wave, within half a turn around 0.

        Parameters
        ----------
        crank_angle : float
            Crank angle, rad.
        """
        return math.remainder(self.mechanism.wave_angle(crank_angle), 2 * math.pi)

    def crank_angle(self, psi: float) -> float:
        """First crank angle >= 0 of an angle of the engine, rad.

        Parameters
        ----------
        psi : float
            As `wave` gives it, rad.
        """
        off = psi - self.mechanism.initial_crank_angle
        return off % (2 * math.pi) / self.mechanism.waves_per_turn

    def solved(self, places: Sequence[float], torque: float, *, play: bool = True) -> Solved:
        """Equilibrium at angles of the engine; what cannot be is refused.

        Parameters
        ----------
        places : sequence of float
            As `wave` gives them, rad.
        torque : float
            On the output link, N*m, not 0; negative in reverse.
        play : bool
            True where the play is asked too.

        Returns
        -------
        Solved

        Raises
        ------
        ImpossibleMechanism
            If no pair can drive, forces would not balance or not be stable, or a contact would be
            as wide as its pin.
        """
        room = Solved.of(self.drive, len(places))
        bad = room.at(np.array(places, float), torque, play=play)
        if bad >= 0:
            self.refuse(angle=places[bad], status=int(room.rows[bad, engine.STATUS]), room=room)
        return room

    def refuse(self, *, angle: float, status: int, room: Solved) -> None:
        """Refuse a position that cannot be, as the engine left it.

        Parameters
        ----------
        angle : float
            Angle of the engine, rad.
        status : int
            Of the position.
        room : Solved
            The positions.

        Raises
        ------
        ImpossibleMechanism
            Always.
        """
        params = self._beyond_law(room) if status == engine.TOO_WIDE else {}
        place = {"crank_angle": self.crank_angle(float(angle))}
        raise ImpossibleMechanism(REFUSALS[status], place, **params)

    def _beyond_law(self, room: Solved) -> dict[str, Any]:
        """The pair whose force is beyond its law: disc, and pin of the ring or the output."""
        w, gi = room.work.w, room.drive.gi
        index = int(np.flatnonzero(w[:, engine.FORCE] > w[:, engine.MOST])[0])
        g = int(((gi[:, engine.START] <= index) & (index < gi[:, engine.STOP])).argmax())
        disc = int((gi[:g, engine.KIND] == gi[g, engine.KIND]).sum())
        return {"satellite": disc + 1, "pin": index - int(gi[g, engine.START]) + 1}

    def unloaded(self, places: FloatArray, way: float = 1.0, *, least: bool = False) -> FloatArray:
        """Play, and where it is asked what presses least, at angles of the engine.

        Parameters
        ----------
        places : array, shape (m,)
            rad.
        way : float
            Direction in which lags count: 1, or -1 in reverse.
        least : bool
            True where the smallest possible worst approach is asked, of a ring alone.

        Returns
        -------
        array, shape (m, 21)
            Read-outs of the engine.
        """
        room = Solved.of(self.drive, len(places))
        engine.unloaded(places, way, least, room.drive, room.work, room.rows, room.plays)
        return room.rows

    @cached_property
    def _free(self) -> dict[bytes, FloatArray]:
        """Plays at places that were asked, which no torque changes."""
        return {}

    def free(self, places: Sequence[float], way: float) -> tuple[FloatArray, BoolArray]:
        """Play at angles of the engine, each set of them looked at once.

        Parameters
        ----------
        places : sequence of float
            As `wave` gives them, rad.
        way : float
            Direction in which lags count: 1, or -1 in reverse.

        Returns
        -------
        play : array, shape (m, 2)
            Least and largest lag without load, rad.
        pressed : array, shape (m,)
            True where pairs press without load.
        """
        there = np.array(places, float)
        if there.tobytes() not in self._free:
            self._free[there.tobytes()] = self.unloaded(there)
        rows = self._free[there.tobytes()]
        play = rows[:, engine.LOW : engine.HIGH + 1]
        return (play if way > 0 else -play[:, ::-1]), rows[:, engine.PRESSED] > 0

    def rows(self, values: Sequence[float]) -> tuple[tuple[float, ...], ...]:
        """Values of the pairs, satellite by satellite.

        Parameters
        ----------
        values : sequence of float, K*N
            Values in the engine's order.

        Returns
        -------
        tuple of tuple of float, K x N
        """
        pins = self.mechanism.pins
        return tuple(tuple(values[i : i + pins]) for i in range(0, len(values), pins))
