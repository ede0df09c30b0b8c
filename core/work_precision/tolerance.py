"""A quantity of many pieces: how many of them, and at how many positions each."""

import math
import time
from contextlib import suppress
from dataclasses import dataclass, replace

import numpy as np

from core.arrays import FloatArray
from core.errors import InvalidInput
from core.tolerance.quantiles import fewest, percentile
from core.tolerance.study import Study
from core.work_precision.study import Reference, WorkPoint, WorkPrecision

GRIDS = {
    "monte_carlo_quarter": 0.25,
    "monte_carlo_half": 0.5,
    "monte_carlo": 1.0,
    "monte_carlo_double": 2.0,
}
"""Methods, and how many times the positions that were asked each has."""

FINEST = 4
"""How many times the positions that were asked the reference has."""

COST = 8
"""How many times as long as the study itself this takes: its grids and the reference."""

BLOCKS = (256, 64, 16, 4)
"""Into how many blocks the pieces are split for the scatter of smaller samples."""

FEWEST_POSITIONS = 3
"""A coarser grid says nothing of a turn."""


@dataclass(frozen=True, slots=True)
class Mean:
    """The mean of the pieces."""

    @property
    def fewest(self) -> int:
        """Fewest pieces that it is taken of."""
        return 2

    def of(self, values: FloatArray) -> float:
        """Of the pieces that can work."""
        return float(values.mean())


@dataclass(frozen=True, slots=True)
class Percentile:
    """A percentile of the pieces."""

    percent: float  # between 0 and 100

    @property
    def fewest(self) -> int:
        """Fewest pieces of which it has an interval."""
        return fewest(self.percent)

    def of(self, values: FloatArray) -> float:
        """Of the pieces that can work."""
        return percentile(values=values, percent=self.percent).value


Statistic = Mean | Percentile


@dataclass(frozen=True, slots=True)
class _Sampled:
    """The pieces at one grid: its values, the estimate from all, and what it took, s."""

    values: FloatArray
    estimate: float
    run_time: float


def _estimate(values: FloatArray, statistic: Statistic) -> float:
    """Of the pieces that can work."""
    known = values[~np.isnan(values)]
    if not len(known):
        raise InvalidInput("samples", len(values), "too_few", limit=len(values) + 1)
    return statistic.of(known)


def _sampled(study: Study, positions: int, statistic: Statistic) -> _Sampled:
    own = replace(study, asked=replace(study.asked, positions=positions))
    pieces = own.pieces()
    began = time.perf_counter_ns()
    values = own.values(pieces)[0][:, 0]
    spent = (time.perf_counter_ns() - began) * 1e-9
    return _Sampled(values, _estimate(values, statistic), spent)


def _scatter(grid: _Sampled, blocks: int, statistic: Statistic) -> float:
    """Root mean square deviation of the estimates from smaller samples. Blocks of the same pieces
    lie closer to their whole than to the truth.
    """
    found = [_estimate(block, statistic) for block in np.array_split(grid.values, blocks)]
    square = float(np.mean((np.array(found) - grid.estimate) ** 2))
    return math.sqrt(square / (1 - 1 / blocks))


def tolerance_sampling_study(*, study: Study, statistic: Statistic) -> WorkPrecision:
    """Error against run time of a percentile over many pieces.

    The number of pieces makes a scatter that falls with its root, whatever the positions; the
    number of positions a bias that no number of pieces takes away. So more of one alone ends in a
    level line.

    Parameters
    ----------
    study : Study
        Design, tolerances, number of pieces and of positions; its first quantity is taken.
    statistic : Mean or Percentile
        What is taken of the pieces.

    Returns
    -------
    WorkPrecision
        The error is the scatter of smaller samples among the pieces and the bias of the grid
        against the same pieces at `FINEST` times the positions. Chosen are the pieces and positions
        as asked, whose scatter is half that of quarters of them.

    Raises
    ------
    InvalidInput
        If the pieces are too few for the percentile, quartered.
    """
    asked = study.asked.positions
    exact = _sampled(study, FINEST * asked, statistic).estimate
    lines = {
        method: _line(method, study, round(times * asked), statistic, exact)
        for method, times in GRIDS.items()
        if round(times * asked) >= FEWEST_POSITIONS
    }
    chosen = lines["monte_carlo"][-1]
    digits = -math.log10(max(chosen.relative_error, 1e-16))
    return WorkPrecision(
        reference=Reference("monte_carlo_finest", max(0, math.floor(digits))),
        points=tuple(point for line in lines.values() for point in line),
        chosen=chosen,
    )


def _line(
    method: str, study: Study, positions: int, statistic: Statistic, exact: float
) -> list[WorkPoint]:
    """Smaller samples and all pieces at one grid."""
    grid, count = _sampled(study, positions, statistic), study.samples
    scatters: dict[int, float] = {}
    for blocks in BLOCKS:
        with suppress(InvalidInput):  # of blocks that are too small for it
            scatters[count // blocks] = _scatter(grid, blocks, statistic)
    if count // BLOCKS[-1] not in scatters:
        least = BLOCKS[-1] * statistic.fewest
        raise InvalidInput("samples", count, "too_few", limit=least)
    scatters[count] = scatters[count // BLOCKS[-1]] / 2
    return [
        WorkPoint(
            method=method,
            setting=("pieces", pieces),
            relative_error=math.hypot(grid.estimate - exact, scatter) / (abs(exact) or 1.0),
            run_time=grid.run_time * pieces / count,
            evaluations=pieces * positions,
        )
        for pieces, scatter in scatters.items()
    ]
