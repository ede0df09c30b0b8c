"""Solved positions of pins and discs that share a torque.

The lag of the output is the angular deflection behind its ideal angle, rad. Angles of the engine
are wave angles, rad.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from core.arrays import BoolArray, ComplexArray, FloatArray, check_finite, check_single
from core.drive import engine
from core.drive.engine import Drive, Work
from core.drive.model import Pieces, work_for
from core.errors import ImpossibleMechanism, InvalidInput
from core.output.mechanism import Mechanism
from core.precision import ROUNDING

REFUSALS = {
    engine.NO_DRIVE: "dead_centre",
    engine.NOT_STABLE: "not_stable",
    engine.TOO_WIDE: "beyond_hertz",
}
"""Codes of the refusals of positions that cannot be solved."""

CLASS = 5 * engine.CLASS
"""Error of the forces over the largest force, from the method."""

ROUNDED = 32 * ROUNDING
"""Relative rounding error of the displacements."""


def check_torque(output_torque: float, **others: float) -> None:
    """Refuse an output torque, N*m, of 0, and numbers, given by name, that are not finite."""
    check_single(output_torque=output_torque, **others)
    check_finite(output_torque=output_torque, **others)
    if output_torque == 0:
        raise InvalidInput("output_torque", output_torque, "not_zero")


@dataclass(frozen=True, slots=True)
class Solved:
    """Solved positions of a drive, one row of every array for each of m positions."""

    drive: Drive
    work: Work
    rows: FloatArray  # read-outs of the engine, shape (m, 21)
    lags: FloatArray  # lags of the bodies against the output's sense, rad
    forces: FloatArray  # forces of all contacts, N
    wrench: FloatArray  # forces along and across the crank, N, and torque, N*m, by groups
    plays: FloatArray  # play of each disc in its ring, rad, shape (m, bodies, 2)

    @classmethod
    def of(cls, pieces: Pieces, count: int = 1) -> "Solved":
        """Empty arrays for a number of positions of the first piece of a drive."""
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
        """Solve positions at m angles of the engine; return the first unsolvable one, or -1.

        The torque is in N*m, negative in reverse. True for `play` also solves the play.
        """
        given = places, torque, play, self.drive, self.work
        left = self.rows, self.lags, self.forces, self.wrench, self.plays
        return engine.positions(*given, *left)

    def contacts(self, kind: int) -> slice:
        """Slice of the contacts of a kind, `engine.PIN` or `engine.LOBE`."""
        gi = self.drive.gi[self.drive.gi[:, engine.KIND] == kind]
        return slice(gi[0, engine.START], gi[-1, engine.STOP]) if len(gi) else slice(0, 0)

    def on_discs(self, *kinds: int) -> FloatArray:
        """Forces of some kinds of contact groups on each disc, shape (m, K, 3).

        The components are along the crank and across it, N, and the torque about the centre, N*m.
        """
        found = [self.wrench[:, self.drive.gi[:, engine.KIND] == kind] for kind in kinds]
        total: FloatArray = np.sum([each for each in found if each.shape[1]], axis=0)
        return total

    @property
    def by_ring(self) -> FloatArray:
        """Forces of the ring on each disc, N and N*m, shape (m, K, 3)."""
        return self.on_discs(engine.LOBE, engine.FLANK)

    @property
    def discs(self) -> tuple[FloatArray, ComplexArray]:
        """Lag of each disc, rad, and shift on its crank, along + i*across, m, shapes (m, K)."""
        drive, first = self.drive, self.drive.gi[:, engine.KIND] == self.drive.gi[0, engine.KIND]
        gi, late = drive.gi[first], drive.gf[first, engine.LATE]
        still = np.zeros((len(self.lags), 1))
        moves = np.hstack((self.lags, still))  # last column: parts that do not move
        own, along, across, turn = (
            moves[:, gi[:, each]] for each in (engine.OWN, engine.ALONG, engine.ACROSS, engine.TURN)
        )
        output = self.lags @ drive.share
        return late + own + output[:, None] - turn, along + 1j * across

    @property
    def lag(self) -> FloatArray:
        """Angular deflection of the output, positive in the sense of the torque, rad."""
        return np.asarray(self.rows[:, engine.LAG])

    @property
    def stiffness(self) -> FloatArray:
        """Torsional stiffness as the slope of the torque over the lag, N*m/rad."""
        return np.asarray(self.rows[:, engine.STIFFNESS])

    @property
    def play(self) -> FloatArray:
        """Least and largest lag without load in the torque's sense, rad, shape (m, 2)."""
        return np.asarray(self.rows[:, engine.LOW : engine.HIGH + 1])

    @property
    def pressed(self) -> BoolArray:
        """True where pairs of any stage press without load."""
        pressed: BoolArray = self.rows[:, engine.PRESSED] > 0
        return pressed

    @property
    def jammed(self) -> BoolArray:
        """True where the output has no play because pairs press."""
        jammed: BoolArray = self.play[:, 0] > self.play[:, 1] + engine.LEAST_PLAY
        return jammed

    @property
    def input_torque(self) -> FloatArray:
        """Torque that turns the crank without friction, N*m."""
        return np.asarray(self.rows[:, engine.INPUT_TORQUE])

    @property
    def steps(self) -> int:
        """Number of solver steps of all positions."""
        return int(self.rows[:, engine.STEPS].sum())

    @property
    def error(self) -> FloatArray:
        """Error of the forces, N, by the method and by rounding of displacements.

        Rounding counts only under a torque of next to nothing.
        """
        radius = float(self.drive.gf[0, engine.CIRCLE])  # radius of the pin circle
        rounded = ROUNDED * self.stiffness * np.abs(self.lags).max(axis=1) / radius
        return np.asarray(CLASS * self.forces.max(axis=1) + rounded)


class Stage:
    """Output pins in the holes of discs, a ring of pins on the teeth of discs, or both."""

    mechanism: Mechanism  # pins and cranks; the wave of a ring turns with the crank
    support: Any  # elastic supports or given shares of the satellites; None if rigid
    deviations: Any  # deviations of pins, discs and cranks
    kind = engine.PIN
    """Kind of the contacts whose forces are those of the stage."""

    @property
    def drive(self) -> Pieces:
        """Stage in the form that the engine takes."""
        raise NotImplementedError

    @property
    def phases(self) -> Sequence[float]:
        """Angles of the cranks with their errors, rad."""
        angles = self.mechanism.crank_angles
        errors = self.deviations.crank_phase or (0.0,) * len(angles)
        return [angle + error for angle, error in zip(angles, errors, strict=True)]

    @property
    def pins_alike(self) -> bool:
        """True if all pins are alike, and all parts of a satellite that they touch."""
        raise NotImplementedError

    @property
    def dead_angles(self) -> tuple[float, ...]:
        """Angles from the crank at which a pin takes up or leaves, rad."""
        return 0.0, math.pi

    def wave(self, crank_angle: float) -> float:
        """Angle of the engine at a crank angle, rad: the wave angle within half a turn around 0."""
        return math.remainder(self.mechanism.wave_angle(crank_angle), 2 * math.pi)

    def crank_angle(self, psi: float) -> float:
        """First crank angle >= 0 of an angle of the engine, rad."""
        off = psi - self.mechanism.initial_crank_angle
        return off % (2 * math.pi) / self.mechanism.waves_per_turn

    def solved(self, places: Sequence[float], torque: float, *, play: bool = True) -> Solved:
        """Equilibrium at angles of the engine, rad, under a torque on the output link, N*m.

        The torque is not 0 and negative in reverse. ImpossibleMechanism is raised if no pair can
        drive, if forces do not balance or are not stable, or if a contact would be as wide as its
        pin.
        """
        room = Solved.of(self.drive, len(places))
        bad = room.at(np.array(places, float), torque, play=play)
        if bad >= 0:
            self.refuse(angle=places[bad], status=int(room.rows[bad, engine.STATUS]), room=room)
        return room

    def refuse(self, *, angle: float, status: int, room: Solved) -> None:
        """Raise ImpossibleMechanism for an angle of the engine, rad, by its status."""
        params, w, gi = dict[str, Any](), room.work.w, room.drive.gi
        if status == engine.TOO_WIDE:  # the first pair whose force is beyond the contact law
            index = int(np.flatnonzero(w[:, engine.FORCE] > w[:, engine.MOST])[0])
            g = int(((gi[:, engine.START] <= index) & (index < gi[:, engine.STOP])).argmax())
            disc = int((gi[:g, engine.KIND] == gi[g, engine.KIND]).sum())
            params = {"satellite": disc + 1, "pin": index - int(gi[g, engine.START]) + 1}
        place = {"crank_angle": self.crank_angle(float(angle))}
        raise ImpossibleMechanism(REFUSALS[status], place, **params)

    def unloaded(self, places: FloatArray, way: float = 1.0, *, least: bool = False) -> FloatArray:
        """Play at angles of the engine as its read-outs, shape (m, 21).

        The sign of `way` is the sense in which lags count. True for `least` also finds the smallest
        possible worst approach, for a ring alone.
        """
        room = Solved.of(self.drive, len(places))
        engine.unloaded(places, way, least, room.drive, room.work, room.rows, room.plays)
        return room.rows

    @cached_property
    def _free(self) -> dict[bytes, FloatArray]:
        """Play by places that were asked before; torques do not change it."""
        return {}

    def free(self, places: Sequence[float], way: float) -> tuple[FloatArray, BoolArray]:
        """Least and largest lag without load, rad, shape (m, 2), and pressing pairs, shape (m,).

        The sign of `way` is the sense in which lags count. Each set of places is solved once.
        """
        there = np.array(places, float)
        if there.tobytes() not in self._free:
            self._free[there.tobytes()] = self.unloaded(there)
        rows = self._free[there.tobytes()]
        play = rows[:, engine.LOW : engine.HIGH + 1]
        return (play if way > 0 else -play[:, ::-1]), rows[:, engine.PRESSED] > 0

    def rows(self, values: Sequence[float]) -> tuple[tuple[float, ...], ...]:
        """Values of the K*N pairs as one row for each satellite."""
        pins = self.mechanism.pins
        return tuple(tuple(values[i : i + pins]) for i in range(0, len(values), pins))
