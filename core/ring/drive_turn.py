"""Positions and the turn of a ring on its discs, or of both meshes, as the engine solves them."""

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from core.arrays import FloatArray
from core.drive import engine
from core.drive.engine import Drive, Work
from core.drive.model import Pieces, work_for
from core.errors import ImpossibleMechanism
from core.numerics.extremes import Narrow
from core.output.loop_rows import (
    BACKLASH,
    FORCE,
    INPUT_TORQUE,
    LAG,
    LOST_MOTION,
    PLAY_END,
    PRESSURE,
    STIFFNESS,
    TOO_WIDE,
    Position,
)
from core.output.stage import REFUSALS, Stage
from core.output.summits import Grid
from core.output.turn import SOLVES, Rows, Turn

ALONG_MOST, ALONG_LEAST, RUB, RUB_AND_PRESS, MESH_FORCE, MESH_PRESSURE = range(8, 14)
"""Further read-outs over the turn: the largest and the least force of a disc along its
crank; the largest product of a pair's distance to the pitch point and its force, N*m, or the root
of force over reduced radius, m*sqrt(N/m); of the pins of the ring in series the largest force, and
force over reduced radius."""

PLAY_CLASS = 1e-13
"""Error of the ends of a play over them."""

OF_BOTH = {
    LAG: engine.LAG,
    STIFFNESS: engine.STIFFNESS,
    PLAY_END: engine.HIGH,
    BACKLASH: engine.PLAY,
    INPUT_TORQUE: engine.INPUT_TORQUE,
    LOST_MOTION: engine.LOST,
    ALONG_MOST: engine.ALONG_MOST,
    ALONG_LEAST: engine.ALONG_LEAST,
    RUB: engine.RUB,
    RUB_AND_PRESS: engine.RUB_PRESSED,
    MESH_FORCE: engine.LOBE_FORCE,
    MESH_PRESSURE: engine.LOBE_PRESSED,
}
OF_RING = OF_BOTH | {FORCE: engine.LOBE_FORCE, PRESSURE: engine.LOBE_PRESSED}
OF_SERIES = OF_BOTH | {FORCE: engine.PIN_FORCE, PRESSURE: engine.PIN_PRESSED}
"""Read-outs of the engine by what is looked at over the turn."""


@dataclass(frozen=True, slots=True)
class Solved:
    """Room for positions of a drive, and what they leave there, position by position."""

    drive: Drive
    work: Work
    rows: FloatArray  # read-outs of the engine, [m, 21]
    lags: FloatArray  # of the bodies, against the direction of the output, rad
    forces: FloatArray  # of all contacts, N
    wrench: FloatArray  # of each group on its disc: along the crank, across it, about its centre
    play: FloatArray  # of each disc in its ring, rad, [m, bodies, 2]

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
            Crank angles, rad.
        torque : float
            N*m, negative in reverse.
        play : bool
            Whether the play is asked too.

        Returns
        -------
        int
        """
        given = places, torque, play, self.drive, self.work
        left = self.rows, self.lags, self.forces, self.wrench, self.play
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
        return slice(gi[0, engine.START], gi[-1, engine.STOP])

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


class DriveStage(Stage):
    """A ring on its discs, or both meshes in series."""

    @property
    def drive(self) -> Pieces:
        """The drive as the engine takes it."""
        raise NotImplementedError

    def setup(self, direction: float) -> float:
        """The direction of the torque.

        Parameters
        ----------
        direction : float
            1, or -1 in reverse.

        Returns
        -------
        float
        """
        return direction

    def room(self) -> Solved:
        """Room for the results of one position."""
        return Solved.of(self.drive)

    def unloaded(self, places: FloatArray, *, least: bool = False) -> FloatArray:
        """Play, and where it is asked what presses least, at crank angles.

        Parameters
        ----------
        places : array, shape (m,)
            rad.
        least : bool
            Whether the smallest possible worst approach is asked, of a ring alone.

        Returns
        -------
        array, shape (m, 21)
            Read-outs of the engine.
        """
        room = Solved.of(self.drive, len(places))
        engine.unloaded(places, 1.0, least, room.drive, room.work, room.rows, room.play)
        return room.rows

    def solved(self, psi: float, torque: float, setup: float, room: Solved) -> Position:
        """Equilibrium at a crank angle; what cannot be is refused, see `Stage.solved`."""
        bad = room.at(np.array([psi]), setup * torque)
        self.refuse(bad=bad, places=[psi], room=room)
        row, play = room.rows[0], PLAY_CLASS * np.abs(room.rows[0, [engine.LOW, engine.HIGH]])
        return Position(
            lag=float(row[engine.LAG]),
            stiffness=float(row[engine.STIFFNESS]),
            low=float(row[engine.LOW]),
            high=float(row[engine.HIGH]),
            play_error=float(play.max()) + engine.LEAST_PLAY,
            lag_error=engine.CLASS * abs(float(row[engine.LAG])),
            force_error=engine.CLASS * float(room.forces.max()),
            status=int(row[engine.STATUS]),
            steps=int(row[engine.STEPS]),
        )

    def refuse(self, *, bad: int, places: Sequence[float], room: Solved) -> None:
        """Refuse a position that cannot be, as the engine left it.

        Parameters
        ----------
        bad : int
            Its number, or -1.
        places : sequence of float
            Crank angles, rad.
        room : Solved
            The positions.

        Raises
        ------
        ImpossibleMechanism
            If there is one.
        """
        if bad < 0:
            return
        status = int(room.rows[bad, engine.STATUS])
        params = self.beyond_law(room) if status == TOO_WIDE else {}
        place = {"crank_angle": self.crank_angle(float(places[bad]))}
        raise ImpossibleMechanism(REFUSALS[status], place, **params)

    def beyond_law(self, room: Solved) -> dict[str, Any]:
        """The pair whose force is beyond its law: disc, and pin of the ring or the output."""
        w, gi = room.work.w, room.drive.gi
        index = int(np.flatnonzero(w[:, engine.FORCE] > w[:, engine.MOST])[0])
        g = int(((gi[:, engine.START] <= index) & (index < gi[:, engine.STOP])).argmax())
        disc = int((gi[:g, engine.KIND] == gi[g, engine.KIND]).sum())
        return {"satellite": disc + 1, "pin": index - int(gi[g, engine.START]) + 1}

    def input_torque(
        self, psi: float, torque: float, lag: float, setup: float, room: Solved
    ) -> float:
        """Torque that turns the crank without friction, N*m, as `solved` left the room."""
        return float(room.rows[0, engine.INPUT_TORQUE])


class DriveTurn(Turn):
    """A drive under a torque over the turn; refusals as `Stage.solved`.

    Parameters
    ----------
    real : DriveStage
        The drive.
    torque : float
        On the output link, N*m, not 0; negative in reverse.
    share : float
        Share of the torque under which the lost motion is taken.
    """

    columns = OF_RING
    """Read-outs of the engine by what is looked at."""

    kind = engine.LOBE
    """Contacts whose forces are those of the turn."""

    def __init__(self, real: Any, torque: float, share: float = 0.03) -> None:
        self.start(real, torque, share)
        self.room = Solved.of(real.drive)

    def solve(self, places: Sequence[float], torque: float, *, play: bool = True) -> Solved:
        """Positions at crank angles, rad, under a torque; what cannot be is refused."""
        room = Solved.of(self.real.drive, len(places))
        bad = room.at(np.array(places, float), torque, play=play)
        self.real.refuse(bad=bad, places=places, room=room)
        return room

    def between(self, places: Sequence[float]) -> Rows:
        """Positions of which the play is not asked."""
        return self.poses(places, play=False)

    def poses(self, places: Sequence[float], *, play: bool = True) -> Rows:
        """Positions at crank angles, rad."""
        self.evaluations += len(places)
        room = self.solve(places, self.torque, play=play)
        rows, names = room.rows, self.columns
        forces = room.forces.max(axis=1)
        ends = np.abs(rows[:, [engine.LOW, engine.HIGH]]).max(axis=1)
        loaded = engine.PIN_LOADED if self.kind == engine.PIN else engine.LOBE_LOADED
        found = {
            "forces": room.forces[:, room.contacts(self.kind)],
            "lag": rows[:, engine.LAG],
            "stiffness": rows[:, engine.STIFFNESS],
            "force": rows[:, names[FORCE]],
            "pressure": rows[:, names[PRESSURE]],
            "loaded": rows[:, loaded],
            "low": rows[:, engine.LOW],
            "high": rows[:, engine.HIGH],
            "lag_error": engine.CLASS * np.abs(rows[:, engine.LAG]),
            "play_error": PLAY_CLASS * ends + engine.LEAST_PLAY,
            "force_error": engine.CLASS * forces,
            "input_torque": rows[:, engine.INPUT_TORQUE],
            "mesh_force": rows[:, engine.LOBE_FORCE],
            "mesh_pressure": rows[:, engine.LOBE_PRESSED],
            "mesh_loaded": rows[:, engine.LOBE_LOADED],
            "pressed": rows[:, engine.PRESSED],
            "along": room.by_ring[:, :, 0],
            "across": room.by_ring[:, :, 1],
            "teeth": room.forces[:, room.contacts(engine.LOBE)],
            "wave": np.array(places),
        }
        if self.kind == engine.PIN:
            found["own"] = math.copysign(1.0, self.torque) * room.lags[:, 1:]
        return found

    def values(self, kind: int, places: Iterable[float], period: float = 2 * math.pi) -> Grid:
        """A quantity at crank angles over a turn, or over so much of it, rad."""
        where = [*places]
        self.evaluations += len(where) * SOLVES.get(kind, 1)
        if kind == LOST_MOTION:
            part = self.share * self.torque
            both = [self.solve(where, each, play=False).rows for each in (part, -part)]
            heights = both[0][:, engine.LAG] + both[1][:, engine.LAG]
        else:
            play = kind in (PLAY_END, BACKLASH)
            rows = self.solve(where, self.torque, play=play).rows
            heights = rows[:, self.columns[kind]]
        return Grid(np.array(where), heights, period)

    def narrow(self, kind: int, sign: int = 1) -> Narrow:
        """How the largest value of a quantity between two places is found; for the sign -1 the
        least, as its opposite.
        """
        room = self.room

        def narrowed(low: float, high: float) -> tuple[float, float, float]:
            given = self.columns[kind], sign, low, high, self.torque, self.share
            place, height, error, looks = engine.narrow(*given, room.drive, room.work, room.rows[0])
            if not looks:
                self.real.refuse(bad=0, places=[place], room=room)
            self.evaluations += looks * SOLVES.get(kind, 1)
            return float(place), float(sign * height), float(error)

        return narrowed
