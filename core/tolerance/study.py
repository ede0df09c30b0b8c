"""What tolerances do to many pieces: peak force, pressure, transmission error, backlash, ..."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from core.arrays import BoolArray, FloatArray
from core.errors import ImpossibleMechanism, InvalidInput
from core.output.real_mechanism import Deviations, RealMechanism
from core.output.sharing_kernel import largest
from core.output.summits import summits
from core.output.turn import Turn
from core.tolerance.quantiles import Estimate, percentile, share
from core.tolerance.tolerances import Tolerances

QUANTITIES = (
    "peak_force",
    "max_pressure",
    "transmission_error",
    "backlash_max",
    "lost_motion",
    "stiffness_min",
)

WORST = 32
"""Samples of the highest peaks, a tenth of all at most, on which the error of the angle grid is
estimated."""

FINER, FINER_SAMPLES = 4, 8
"""How many times as many positions, and of how many pieces, show what the grid misses of the other
quantities."""


@dataclass(frozen=True, slots=True)
class Evaluation:
    """What of each piece is asked, and where.

    Attributes
    ----------
    quantities : tuple of str
        Of `QUANTITIES`.
    output_torque : float
        Torque T on the output link, N*m, not 0; negative in reverse.
    positions : int
        Even positions of the wave.
    lost_motion_share : float
        Share of the torque under which the lost motion is taken.
    """

    quantities: tuple[str, ...]
    output_torque: float
    positions: int = 60
    lost_motion_share: float = 0.03


def piece_values(*, real: RealMechanism, asked: Evaluation) -> tuple[list[float], bool]:
    """Quantities of one piece, and whether it can be assembled without force.

    Parameters
    ----------
    real : RealMechanism
        The piece.
    asked : Evaluation
        What of it.

    Returns
    -------
    values : list of float
        In the order asked.
    fits : bool
        Whether its pairs are free of each other without load, at all positions.

    Raises
    ------
    ImpossibleMechanism
        If the piece cannot work.
    """
    fits = True
    turn = Turn(real, asked.output_torque)
    forces, pressures, lags, plays, lost, stiffness = [], [], [], [], [], []
    for k in range(asked.positions):
        psi = 2 * math.pi * k / asked.positions
        found = real.solved(psi, turn.torque, turn.setup, turn.room)
        fits &= found.low <= found.high + found.play_error
        forces.append(largest(turn.room.force))
        lags.append(found.lag)
        plays.append(found.high - found.low)
        stiffness.append(found.stiffness)
        if "max_pressure" in asked.quantities:
            pressures.append(max(map(float.__mul__, turn.room.force, turn.curved)))
        if "lost_motion" in asked.quantities:
            lost.append(turn.lost(psi, asked.lost_motion_share))
    values = {
        "peak_force": max(forces),
        "transmission_error": max(lags) - min(lags),
        "backlash_max": max(0.0, *plays),
        "stiffness_min": min(stiffness),
        "lost_motion": max(lost, default=0.0),
    }
    if pressures:
        # Pressure squared grows with the force over the reduced radius.
        unit = real.contact(0, 1.0)
        if unit is None:
            raise InvalidInput("pin_material", None, "needed", field="hole_material")
        square = unit.max_pressure**2 / turn.curved[0]
        values["max_pressure"] = math.sqrt(square * max(pressures))
    return [values[name] for name in asked.quantities], fits


@dataclass(frozen=True, slots=True)
class ToleranceStudy:
    """Many pieces.

    Attributes
    ----------
    quantities : tuple of str
        What was asked.
    values : array, shape (samples, quantities)
        SI units; NaN where a piece cannot work.
    fits : array of bool, shape (samples,)
        Which pieces can be assembled without force; those that cannot have their values too, once
        they are pressed together.
    nominal : dict of str to float
        Of the piece at the middle of all limits.
    cannot_assemble : Estimate
        Share of the pieces that cannot be assembled without force.
    angle_grid_error : dict of str to float
        How much the positions miss of each quantity, relative: a bias, of the largest values always
        low. Of the peak force the mean over the highest samples, each summit narrowed; of the
        others the mean over the first samples at four times the positions.
    """

    quantities: tuple[str, ...]
    values: FloatArray
    fits: BoolArray
    nominal: dict[str, float]
    cannot_assemble: Estimate
    angle_grid_error: dict[str, float]

    def column(self, quantity: str) -> FloatArray:
        """Values of a quantity, of the pieces that can work.

        Parameters
        ----------
        quantity : str
            Its name.

        Returns
        -------
        array
        """
        column: FloatArray = self.values[:, self.quantities.index(quantity)]
        return column[~np.isnan(column)]

    def percentile(self, *, quantity: str, percent: float) -> Estimate:
        """Percentile of the pieces that can work.

        Parameters
        ----------
        quantity : str
            Its name.
        percent : float
            Percentage.

        Returns
        -------
        Estimate
        """
        return percentile(values=self.column(quantity), percent=percent)

    def yield_within(self, *, quantity: str, limit: float) -> Estimate:
        """Share of all pieces that keep a limit: of the stiffness a lower one, else an upper one.

        Parameters
        ----------
        quantity : str
            Its name.
        limit : float
            Its limit, SI units.

        Returns
        -------
        Estimate
            Pieces that cannot be assembled count as failures.
        """
        column = self.values[:, self.quantities.index(quantity)]
        kept = column >= limit if quantity == "stiffness_min" else column <= limit
        return share(successes=int((kept & self.fits).sum()), count=len(column))


@dataclass(frozen=True, slots=True)
class Study:
    """A design, its tolerances, and what is asked.

    Attributes
    ----------
    real : RealMechanism
        The nominal design; its own deviations are not used.
    tolerances : Tolerances
        What its parts are made to.
    asked : Evaluation
        Quantities, torque, positions.
    samples : int
        How many pieces.
    seed : int
        Of the draws.
    progress : callable, optional
        Called with the number of pieces done.
    """

    real: RealMechanism
    tolerances: Tolerances
    asked: Evaluation
    samples: int = 4096
    seed: int = 0
    progress: Callable[[int], None] = field(default=lambda done: None)

    def pieces(
        self, *, tolerances: Tolerances | None = None, other: Sequence[str] = ()
    ) -> list[Deviations]:
        """Deviations of the pieces.

        Parameters
        ----------
        tolerances : Tolerances, optional
            Others than the study's.
        other : sequence of str
            Sources from the second sample.

        Returns
        -------
        list of Deviations
        """
        own = self.real.mechanism
        return (tolerances or self.tolerances).drawn(
            pins=own.pins,
            satellites=own.satellites,
            seed=self.seed,
            samples=self.samples,
            other=other,
        )

    def values(self, pieces: Sequence[Deviations]) -> tuple[FloatArray, BoolArray]:
        """Quantities of pieces, and which of them can be assembled.

        Parameters
        ----------
        pieces : sequence of Deviations
            The pieces.

        Returns
        -------
        values : array, shape (pieces, quantities)
            SI units; NaN where a piece cannot work.
        fits : array of bool, shape (pieces,)
            Which can be assembled without force.
        """
        rows, fits = [], []
        for done, piece in enumerate(pieces, 1):
            real = replace(self.real, deviations=piece)
            try:
                values, free = piece_values(real=real, asked=self.asked)
            except ImpossibleMechanism:
                values, free = [math.nan] * len(self.asked.quantities), False
            rows.append(values)
            fits.append(free)
            self.progress(done)
        return np.array(rows), np.array(fits)


def tolerance_study(study: Study) -> ToleranceStudy:
    """Quantities of many pieces, the nominal one, and what the positions miss.

    Parameters
    ----------
    study : Study
        Design, tolerances, what is asked.

    Returns
    -------
    ToleranceStudy

    Raises
    ------
    ImpossibleMechanism
        If the piece at the middle of all limits cannot work.
    """
    own, asked = study.real.mechanism, study.asked
    middle = study.tolerances.middle(pins=own.pins, satellites=own.satellites)
    nominal, _ = piece_values(real=replace(study.real, deviations=middle), asked=asked)
    pieces = study.pieces()
    values, fits = study.values(pieces)
    return ToleranceStudy(
        quantities=asked.quantities,
        values=values,
        fits=fits,
        nominal=dict(zip(asked.quantities, nominal, strict=True)),
        cannot_assemble=share(successes=int((~fits).sum()), count=len(fits)),
        angle_grid_error=_grid_errors(study, pieces, values),
    )


def _grid_errors(
    study: Study, pieces: Sequence[Deviations], values: FloatArray
) -> dict[str, float]:
    """What the positions miss of each quantity."""
    asked, missed = study.asked, {}
    others = tuple(name for name in asked.quantities if name != "peak_force")
    if others:
        finer = replace(asked, quantities=others, positions=FINER * asked.positions)
        finer_study = replace(study, asked=finer, progress=lambda done: None)
        fine, _ = finer_study.values(pieces[:FINER_SAMPLES])
        for name, column in zip(others, fine.T, strict=True):
            coarse = values[:FINER_SAMPLES, asked.quantities.index(name)]
            both = ~np.isnan(coarse) & ~np.isnan(column)
            size = float(np.abs(column[both]).sum())
            off = float(np.abs(column[both] - coarse[both]).sum())
            missed[name] = off / size if size else 0.0
    if "peak_force" in asked.quantities:
        missed["peak_force"] = _missed_peak(study, pieces, values)
    return missed


def _missed_peak(study: Study, pieces: Sequence[Deviations], values: FloatArray) -> float:
    """Mean of what the positions miss of the peak, over the samples of the highest peaks."""
    peaks = values[:, study.asked.quantities.index("peak_force")]
    order = [i for i in np.argsort(-peaks) if not np.isnan(peaks[i])]
    order = order[: min(WORST, math.ceil(len(peaks) / 10))]
    missed = []
    for i in order:
        real = replace(study.real, deviations=pieces[i])
        turn, count = Turn(real, study.asked.output_torque), study.asked.positions
        grid = {2 * math.pi * k / count: turn.force(2 * math.pi * k / count) for k in range(count)}
        found = summits(values=grid, function=turn.force, most=3)
        highest = max(summit.height for summit in found)
        missed.append(max(0.0, 1 - max(grid.values()) / highest))
    return float(np.mean(missed)) if missed else 0.0
