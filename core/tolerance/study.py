"""Tolerance study of many pieces: peak force, pressure, transmission error, backlash and others."""

import math
import os
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from functools import reduce
from typing import Any, ClassVar, NamedTuple

import numpy as np

from core.arrays import BoolArray, FloatArray
from core.drive import engine, model
from core.drive.engine import BINDS, FITS, LOST, NOWHERE
from core.output.drives import output_pieces
from core.output.real_mechanism import RealMechanism
from core.output.room import Deviations
from core.output.stage import Solved
from core.output.summits import summits
from core.output.turn import Turn
from core.tolerance.quantiles import Estimate, percentile, share
from core.tolerance.tolerances import Drawn, Tolerances, deviations

QUANTITIES = (
    "peak_force",
    "max_pressure",
    "transmission_error",
    "backlash_max",
    "lost_motion",
    "stiffness_min",
)

PRESSURES = frozenset(("max_pressure", "ring_max_pressure"))
"""Pressures, for which the engine returns a quantity in proportion to their squares."""

BLOCK, LARGEST = 64, 1024
"""Least and largest number of pieces in a block."""

WORK = 500_000
"""Largest number of pairs times positions times pieces in a block above the least size. Blocks take
some tens of milliseconds, after which a study can be ended; in smaller blocks the draws of a piece
take longer than its equilibria."""

WORST = 32
"""Number of pieces with the highest peaks by which the error of the angle grid is estimated, at
most a tenth of all pieces."""

FINER, FINER_SAMPLES = 4, 8
"""Factor on the number of positions, and number of pieces, by which the error of the angle grid is
estimated for quantities other than the peak force."""


@dataclass(frozen=True, slots=True)
class Evaluation:
    """Quantities to calculate for each piece, and the load."""

    quantities: tuple[str, ...]  # names from `QUANTITIES`; with a ring its peak and pressure too
    output_torque: float  # T on the output link, N*m, not 0; negative in reverse
    positions: int = 60  # number of positions of a piece
    lost_motion_share: float = 0.03  # share of the torque at which lost motion is measured
    alternating: bool = False  # true if the worse of both directions of the torque counts

    @property
    def ways(self) -> "tuple[Evaluation, ...]":
        """Evaluation in each direction of the torque."""
        one = replace(self, alternating=False)
        return (one, replace(one, output_torque=-self.output_torque))[: 1 + self.alternating]


@dataclass(frozen=True, slots=True)
class ToleranceStudy:
    """Results of a tolerance study."""

    quantities: tuple[str, ...]  # names of the columns of `values`
    # SI units, shape (samples, quantities); NaN if a piece does not fit or cannot work.
    values: FloatArray
    fits: BoolArray  # pieces that have room at all positions of the turn, shape (samples,)
    binds: BoolArray  # pieces that have room at some positions only: they jam in turning
    # Quantities of the piece at the middle of all limits; empty if that piece does not fit.
    nominal: dict[str, float]
    cannot_assemble: Estimate  # share of the pieces that do not fit at all positions
    # Relative error of each quantity by the finite number of positions, a bias; largest values are
    # always too low. For the peak force without a ring, the mean over the highest samples, each
    # summit narrowed; otherwise from the first samples at `FINER` times the positions. Empty if it
    # is not asked.
    angle_grid_error: dict[str, float]

    def column(self, quantity: str) -> FloatArray:
        """Values of one quantity for the pieces that can work."""
        column: FloatArray = self.values[:, self.quantities.index(quantity)]
        return column[~np.isnan(column)]

    def percentile(self, *, quantity: str, percent: float) -> Estimate:
        """Percentile of a quantity over the pieces that can work."""
        return percentile(values=self.column(quantity), percent=percent)

    def yield_within(self, *, quantity: str, limit: float, of_fitting: bool = False) -> Estimate:
        """Share of pieces that keep a limit in SI units: stiffness above it, others below it.

        The share is of the pieces that fit if ``of_fitting``, otherwise of all pieces, where those
        that do not fit count as failures.
        """
        column = self.values[:, self.quantities.index(quantity)]
        kept = column >= limit if quantity == "stiffness_min" else column <= limit
        count = int(self.fits.sum()) if of_fitting else len(column)
        return share(successes=int((kept & self.fits).sum()), count=count)


def _untold(done: int) -> None:
    """Ignore the progress."""


class Pieces(NamedTuple):
    """Quantities of a block of pieces, each of shape (pieces,); NaN if a piece cannot work."""

    fits: FloatArray  # FITS, BINDS or NOWHERE of the engine
    peak_force: FloatArray  # largest force on an output pin, N
    max_pressure: FloatArray  # largest `engine.pressing` of an output pin, N/m
    transmission_error: FloatArray  # largest less least lag under load, rad
    backlash_max: FloatArray  # largest play of the output, rad
    lost_motion: FloatArray  # largest lost motion, rad
    stiffness_min: FloatArray  # least stiffness, N*m/rad
    ring_peak_force: FloatArray  # largest force on a ring pin, N
    ring_max_pressure: FloatArray  # largest force over reduced radius of a ring pin, N/m


def _worse(one: Pieces, other: Pieces) -> Pieces:
    """Worse quantities of pieces that are loaded in both directions."""
    largest = Pieces(*map(np.maximum, one, other))
    least = np.minimum(one.stiffness_min, other.stiffness_min)
    return largest._replace(fits=one.fits, stiffness_min=least)


NOTHING = (math.nan,) * (len(Pieces._fields) - 1)
"""Quantities of a piece that cannot work."""


Block = Callable[[Drawn], Pieces]
"""Function that calculates a block of pieces; a study's can be pickled."""

Mapped = Callable[[Block, Sequence[Drawn]], Iterator[Pieces]]
"""Function that calculates blocks and yields their results in their order."""


@dataclass(frozen=True, slots=True)
class Study:
    """Nominal design, its tolerances, and the quantities to calculate."""

    real: RealMechanism  # nominal design; deviations in it are not used
    tolerances: Tolerances
    asked: Evaluation  # quantities, torque, positions
    samples: int = 4096  # number of pieces
    seed: int = 0  # seed of the draws
    # Called with the number of pieces done.
    progress: Callable[[int], None] = _untold
    threads: int = 0  # number of threads; 0 for one to a processor
    mapped: Mapped | None = None  # calculates blocks in place of threads, e.g. in processes

    TURN: ClassVar[Any] = Turn
    """Turn of one piece."""

    def pieces(self, *, tolerances: Tolerances | None = None, other: Sequence[str] = ()) -> Drawn:
        """Drawn pieces; ``other`` names sources that are taken from the second sample."""
        own = self.real.mechanism
        return Drawn(
            tolerances=tolerances or self.tolerances,
            pins=own.pins,
            satellites=own.satellites,
            seed=self.seed,
            samples=range(self.samples),
            other=tuple(other),
            ring_pins=self.ring_pins,
        )

    @property
    def output(self) -> RealMechanism:
        """Output mechanism."""
        return self.real

    @property
    def ring_pins(self) -> int:
        """Number of ring pins whose deviations are drawn."""
        return 0

    @property
    def pairs(self) -> int:
        """Number of pairs of a piece."""
        return self.real.mechanism.pins * self.real.mechanism.satellites

    def block(self, pieces: int) -> int:
        """Number of pieces in a block; each thread gets four blocks if there are enough pieces."""
        most = min(WORK // (self.asked.positions * self.pairs), LARGEST)
        if self.mapped is None:
            most = min(most, pieces // (4 * self.cores))
        return max(most, BLOCK)

    def values(self, pieces: Drawn) -> tuple[FloatArray, FloatArray]:
        """Quantities of pieces in SI units, shape (pieces, quantities), and FITS, BINDS or NOWHERE.

        Values are NaN if a piece does not fit or cannot work. Blocks are calculated in threads, or
        by `mapped`; results are bit-identical however pieces are split.
        """
        size = self.block(len(pieces))
        blocks = [pieces.part(first, first + size) for first in range(0, len(pieces), size)]
        found, done = [], 0
        mapped = self.in_threads if self.mapped is None else self.mapped
        plain = replace(self, real=replace(self.real), progress=_untold, mapped=None)
        for each, results in zip(blocks, mapped(plain.drawn, blocks), strict=True):
            found.append(results)
            done += len(each)
            self.progress(done)
        return self._columns(found)

    def in_threads(self, block: Block, blocks: Sequence[Drawn]) -> Iterator[Pieces]:
        """Results of blocks in their order, calculated in threads."""
        with ThreadPoolExecutor(self.cores) as threads:
            yield from threads.map(block, blocks)

    def _columns(self, found: Sequence[Pieces]) -> tuple[FloatArray, FloatArray]:
        """Values and fits, as `values` returns them, from the results of all blocks."""
        columns = {
            name: np.concatenate([getattr(each, name) for each in found])
            for name in type(found[0])._fields
        }
        for name in PRESSURES.intersection(self.asked.quantities):
            columns[name] = np.sqrt(self.square_pressure(name) * columns[name])
        values = np.stack([columns[name] for name in self.asked.quantities], axis=1)
        values[np.isinf(values).any(axis=1)] = np.nan  # a dead centre gives infinite play
        return values, columns["fits"]

    def values_of(self, pieces: Drawn) -> tuple[FloatArray, FloatArray]:
        """Values and fits, as `values` returns them, of a few pieces without threads."""
        return self._columns([self.drawn(pieces)])

    def drawn(self, pieces: Drawn) -> Pieces:
        """Quantities of pieces whose deviations are drawn here."""
        with np.errstate(invalid="ignore", divide="ignore"):  # pieces may have no size
            drives = self.drives(pieces)
        ways = (replace(self, asked=each) for each in self.asked.ways)
        return reduce(_worse, (each.in_one_way(drives) for each in ways))

    def in_one_way(self, drives: model.Pieces) -> Pieces:
        """Quantities of drives in one direction of the torque."""
        return self._rigid(drives) if self.rigid else self._solved(drives)

    def drives(self, pieces: Drawn) -> model.Pieces:
        """Drives of pieces as the engine takes them."""
        return output_pieces(output=self.real, errors=pieces.rows())

    @property
    def rigid(self) -> bool:
        """True if discs and pins are rigid, for which there is a quicker loop."""
        real = self.real
        return real.exact and real.springs == model.RIGID and not real.support.given_shares

    @property
    def cores(self) -> int:
        """Number of threads."""
        return self.threads or len(os.sched_getaffinity(0))

    @property
    def under_load(self) -> bool:
        """True if a quantity needs the forces under the torque."""
        return bool({*self.asked.quantities} - {"backlash_max", "lost_motion"})

    def places(self, count: int) -> tuple[float, ...]:
        """Angles at which pieces are solved, even over a turn of the wave, rad."""
        return tuple(2 * math.pi * k / count for k in range(count))

    @property
    def looked(self) -> FloatArray:
        """Angles at which a piece is checked for fit, rad."""
        return np.array(self.places(engine.FIT_POSITIONS))

    def _rigid(self, drives: model.Pieces) -> Pieces:
        """Quantities of pieces with rigid discs."""
        asked, sound, blank = self.asked, drives.sound, np.zeros
        gf, cf = (each if sound.all() else each[sound] for each in (drives.gf, drives.cf))
        places, count = np.array(self.places(asked.positions)), len(gf)
        fits, rows = blank(count), blank((count, engine.SOFTEST + 1))
        room = blank((cf.shape[1], engine.HARD + 1)), blank((5, max(len(places), 3)))
        wanted = self.under_load, "lost_motion" in asked.quantities
        law = int(drives.gi[0, engine.LAW])
        given = places, asked.output_torque, asked.lost_motion_share, *wanted, law
        engine.pieces(*given, gf, cf, drives.table, *room, fits, rows)
        whole = np.full((len(sound), len(NOTHING)), math.nan)
        whole[np.flatnonzero(sound), : rows.shape[1]] = rows
        of_all = np.full(len(sound), float(NOWHERE))
        of_all[sound] = fits
        return Pieces(of_all, *whole.T)

    def _solved(self, drives: model.Pieces) -> Pieces:
        """Quantities of pieces by the engine."""
        room, looked = Solved.of(drives, self.asked.positions), self.looked
        found = [
            self._piece(replace(room, drive=drives.drive(k)), looked) if sound else (NOWHERE, None)
            for k, sound in enumerate(drives.sound.tolist())
        ]
        fits = np.array([each[0] for each in found], float)
        return Pieces(fits, *np.array([each[1] or NOTHING for each in found]).T)

    def _piece(self, room: Solved, looked: FloatArray) -> tuple[int, tuple[float, ...] | None]:
        """FITS, BINDS or NOWHERE of a piece, and its quantities, None if it cannot work."""
        asked = self.asked
        fits = engine.goes_together(looked, room.drive, room.work, room.rows[0])
        if fits != FITS:
            return fits, None
        places, torque, play = np.array(self.places(asked.positions)), asked.output_torque, True
        rows, most = room.rows, np.zeros(engine.INTERFERENCE + 1)
        lag = stiffness = lost = 0.0
        if self.under_load:
            play = "backlash_max" in asked.quantities
            if room.at(places, torque, play=play) >= 0:
                return fits, None
            most, lags = rows.max(axis=0), rows[:, engine.LAG]
            lag, stiffness = np.ptp(lags), rows[:, engine.STIFFNESS].min()
        elif "backlash_max" in asked.quantities:
            engine.unloaded(places, 1.0, False, room.drive, room.work, rows, room.plays)
            most = rows.max(axis=0)
        if "lost_motion" in asked.quantities:
            both = np.zeros(len(places))
            for part in (asked.lost_motion_share, -asked.lost_motion_share):
                if room.at(places, part * torque, play=False) >= 0:
                    return fits, None
                both += rows[:, engine.LAG]
            lost = both.max()
        forces = engine.PIN_FORCE, engine.PIN_PRESSED, engine.LOBE_FORCE, engine.LOBE_PRESSED
        one, pressed, ring, ring_pressed = most[[*forces]]
        return fits, (one, pressed, lag, most[engine.PLAY], lost, stiffness, ring, ring_pressed)

    def piece(self, pieces: Drawn, index: int) -> RealMechanism:
        """Mechanism of one piece with its deviations."""
        return replace(self.real, deviations=self.deviations(pieces, index))

    def deviations(self, pieces: Drawn, index: int) -> Deviations:
        """Deviations of one piece without those of a ring."""
        rows = pieces.part(index, index + 1).rows()._asdict()
        return deviations(
            rows={name: row for name, (row,) in rows.items()}, pins=self.real.mechanism.pins
        )

    def refuse(self, pieces: Drawn) -> None:
        """Raise ImpossibleMechanism if the first piece cannot work."""
        for turn in self.turns_of(pieces, 0):
            for kind in (turn.force, LOST):
                turn.values(kind, self.places(self.asked.positions))

    def turns_of(self, pieces: Drawn, index: int) -> list[Any]:
        """One piece over the turn, under the torque in each direction."""
        piece, asked = self.piece(pieces, index), self.asked
        share = asked.lost_motion_share
        return [self.TURN(piece, each.output_torque, share) for each in asked.ways]

    def square_pressure(self, name: str) -> float:
        """Square of a pressure over the value that the engine has for it."""
        real = replace(self.output, deviations=Deviations())
        return float(real.contact(0, 1.0).max_pressure ** 2 / real.curved[0])

    def grid_errors(self, pieces: Drawn, values: FloatArray) -> dict[str, float]:
        """Relative error of each quantity by the finite number of positions, by name."""
        missed = self.missed_by_finer(pieces, values, FINER, narrowed=("peak_force",))
        if "peak_force" in self.asked.quantities:
            missed["peak_force"] = _missed_peak(self, pieces, values)
        return missed

    def missed_by_finer(
        self, pieces: Drawn, values: FloatArray, times: int, narrowed: Sequence[str] = ()
    ) -> dict[str, float]:
        """Relative error of the quantities that are not ``narrowed``, by name.

        The first pieces are solved at ``times`` as many positions and one more: a plain multiple
        would miss what the coarse grid misses.
        """
        asked, missed = self.asked, {}
        others = tuple(name for name in asked.quantities if name not in narrowed)
        if others:
            finer = replace(asked, quantities=others, positions=times * asked.positions + 1)
            fine, _ = replace(self, asked=finer).values_of(pieces.part(0, FINER_SAMPLES))
            for name, column in zip(others, fine.T, strict=True):
                coarse = values[:FINER_SAMPLES, asked.quantities.index(name)]
                both = ~np.isnan(coarse) & ~np.isnan(column)
                size = float(np.abs(column[both]).sum())
                off = float(np.abs(column[both] - coarse[both]).sum())
                missed[name] = off / size if size else 0.0
        return missed


def tolerance_study(study: Study, *, errors: bool = True) -> ToleranceStudy:
    """Quantities of many pieces and of the nominal one, with the error of the angle grid unless
    ``errors`` is false, for which some pieces are solved at more positions.

    Raises ImpossibleMechanism if the piece at the middle of all limits fits and cannot work.
    """
    nominal = _nominal(study)
    pieces = study.pieces()
    values, fits = study.values(pieces)
    return ToleranceStudy(
        quantities=study.asked.quantities,
        values=values,
        fits=fits == FITS,
        binds=fits == BINDS,
        nominal=nominal,
        cannot_assemble=share(successes=int((fits != FITS).sum()), count=len(fits)),
        angle_grid_error=study.grid_errors(pieces, values) if errors else {},
    )


def _nominal(study: Study) -> dict[str, float]:
    """Quantities of the piece at the middle of all limits; empty if that piece does not fit."""
    middle = study.pieces(tolerances=study.tolerances.middle).part(0, 1)
    (values,), (fits,) = study.values_of(middle)
    if fits != FITS:
        return {}
    if np.isnan(values).any():
        study.refuse(middle)
    return dict(zip(study.asked.quantities, map(float, values), strict=True))


def _missed_peak(study: Study, pieces: Drawn, values: FloatArray) -> float:
    """Mean relative error of the peak force over the pieces with the highest peaks."""
    peaks = values[:, study.asked.quantities.index("peak_force")]
    order = [i for i in np.argsort(-peaks) if not np.isnan(peaks[i])]
    order = order[: min(WORST, math.ceil(len(peaks) / 10))]
    missed = []
    for i in order:
        seen = highest = 0.0
        for turn in study.turns_of(pieces, int(i)):
            grid = turn.values(turn.force, study.places(study.asked.positions))
            found = summits(grid=grid, narrow=turn.narrow(turn.force), most=3)
            seen = max(seen, float(grid.heights.max()))
            highest = max(highest, *(summit.height for summit in found))
        missed.append(max(0.0, 1 - seen / highest))
    return float(np.mean(missed)) if missed else 0.0
