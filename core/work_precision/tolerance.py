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

FINEST, COST = 4, 8
"""How many times the positions that were asked the reference has; how many times as long as the
study itself all this takes, its grids and the reference."""

BLOCKS = (256, 64, 16, 4)
"""Into how many blocks the pieces are split for the scatter of smaller samples."""

FEWEST_POSITIONS = 3
"""A coarser grid says nothing of a turn."""


@dataclass(frozen=True, slots=True)
class _Sampled:
    """The pieces at one grid."""

    values: FloatArray
    percent: float | None  # of what is taken of them; None: their mean
    run_time: float  # what it took, s

    def of(self, values: FloatArray) -> float:
        """Percentile, or mean, of those of the pieces that can work."""
        known = values[~np.isnan(values)]
        if not len(known):
            raise InvalidInput("samples", len(values), "too_few", limit=len(values) + 1)
        if self.percent is None:
            return float(known.mean())
        return percentile(values=known, percent=self.percent).value

    def scatter(self, blocks: int) -> float:
        """Root mean square deviation of the estimates from smaller samples. Blocks of the same
        pieces lie closer to their whole than to the truth.
        """
        whole = self.of(self.values)
        found = np.array([self.of(block) for block in np.array_split(self.values, blocks)])
        return math.sqrt(float(np.mean((found - whole) ** 2)) / (1 - 1 / blocks))


def _sampled(study: Study, positions: int, percent: float | None) -> _Sampled:
    own = replace(study, asked=replace(study.asked, positions=positions))
    pieces = own.pieces()
    began = time.perf_counter_ns()
    values = own.values(pieces)[0][:, 0]
    return _Sampled(values, percent, (time.perf_counter_ns() - began) * 1e-9)


def tolerance_sampling_study(*, study: Study, percent: float | None) -> WorkPrecision:
    """Error against run time of a percentile over many pieces.

    The number of pieces makes a scatter that falls with its root, whatever the positions; the
    number of positions a bias that no number of pieces takes away. So more of one alone ends in a
    level line.

    Parameters
    ----------
    study : Study
        Design, tolerances, number of pieces and of positions; its first quantity is taken.
    percent : float or None
        Which percentile, between 0 and 100; None: the mean.

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
    finest = _sampled(study, FINEST * asked, percent)
    exact = finest.of(finest.values)
    lines = {
        method: _line(method, study, round(times * asked), percent, exact)
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
    method: str, study: Study, positions: int, percent: float | None, exact: float
) -> list[WorkPoint]:
    """Smaller samples and all pieces at one grid."""
    grid, count = _sampled(study, positions, percent), study.samples
    bias, scatters = grid.of(grid.values) - exact, dict[int, float]()
    for blocks in BLOCKS:
        with suppress(InvalidInput):  # of blocks that are too small for it
            scatters[count // blocks] = grid.scatter(blocks)
    if count // BLOCKS[-1] not in scatters:
        least = BLOCKS[-1] * (2 if percent is None else fewest(percent))
        raise InvalidInput("samples", count, "too_few", limit=least)
    scatters[count] = scatters[count // BLOCKS[-1]] / 2
    return [
        WorkPoint(
            method=method,
            setting=("pieces", pieces),
            relative_error=math.hypot(bias, scatter) / (abs(exact) or 1.0),
            run_time=grid.run_time * pieces / count,
            evaluations=pieces * positions,
        )
        for pieces, scatter in scatters.items()
    ]
