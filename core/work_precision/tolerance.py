"""A quantity of many pieces: how many of them, and at how many positions each."""

import math
import time
from contextlib import suppress
from dataclasses import replace

import numpy as np

from core.arrays import FloatArray
from core.errors import InvalidInput
from core.tolerance.quantiles import fewest, percentile
from core.tolerance.study import Study
from core.work_precision.study import Reference, WorkPoint, WorkPrecision

GRIDS = {"monte_carlo_quarter": 0.25, "monte_carlo_double": 2.0, "monte_carlo": 1.0}
"""Methods, and how many times the positions that were asked each has."""

FINEST, COST = 4, 8
"""How many times the positions that were asked the reference has; how many times as long as the
study itself all this takes, its grids and the reference."""

BLOCKS = (64, 16, 4)
"""Into how many blocks the pieces are split for the scatter of smaller samples."""


def tolerance_sampling_study(*, study: Study, percent: float | None) -> WorkPrecision:
    """Error against run time of a percentile over many pieces.

    The number of pieces makes a scatter that falls with its root, whatever the positions; the
    number of positions a bias that no number of pieces takes away. The error is both: the scatter
    of smaller samples among the pieces, of all half that of quarters, and the bias against the same
    pieces at `FINEST` times the positions. Raises InvalidInput for too few pieces, quartered. The
    first quantity of the study is taken, by its mean if `percent` is None.
    """
    asked = study.asked.positions
    exact = _estimate(_values(study, FINEST * asked)[0], percent)
    points = [
        point
        for method, times in GRIDS.items()
        for point in _line(method, study, round(times * asked), percent, exact)
    ]
    digits = -math.log10(max(points[-1].relative_error, 1e-16))
    reference = Reference("monte_carlo_finest", max(0, math.floor(digits)))
    return WorkPrecision(reference, tuple(points))


def _values(study: Study, positions: int) -> tuple[FloatArray, float]:
    """The quantity of each piece at one grid, and what it took, s."""
    own = replace(study, asked=replace(study.asked, positions=positions))
    pieces = own.pieces()
    began = time.perf_counter()
    return own.values(pieces)[0][:, 0], time.perf_counter() - began


def _estimate(values: FloatArray, percent: float | None) -> float:
    """Percentile, or mean, of those of the pieces that can work."""
    known = values[~np.isnan(values)]
    if not len(known):
        raise InvalidInput("samples", len(values), "too_few", limit=len(values) + 1)
    return (
        float(known.mean()) if percent is None else percentile(values=known, percent=percent).value
    )


def _line(
    method: str, study: Study, positions: int, percent: float | None, exact: float
) -> list[WorkPoint]:
    """Smaller samples and all pieces at one grid."""
    (values, run_time), count = _values(study, positions), study.samples
    whole, scatters = _estimate(values, percent), dict[int, float]()
    for blocks in BLOCKS:
        with suppress(InvalidInput):  # of blocks that are too small for it
            parts = [_estimate(block, percent) for block in np.array_split(values, blocks)]
            # Blocks of the same pieces lie closer to their whole than to the truth.
            square = np.mean(np.subtract(parts, whole) ** 2) / (1 - 1 / blocks)
            scatters[count // blocks] = math.sqrt(square)
    if count // BLOCKS[-1] not in scatters:
        least = BLOCKS[-1] * (2 if percent is None else fewest(percent))
        raise InvalidInput("samples", count, "too_few", limit=least)
    scatters[count] = scatters[count // BLOCKS[-1]] / 2
    return [
        WorkPoint(
            method=method,
            setting="pieces",
            value=pieces,
            relative_error=math.hypot(whole - exact, scatter) / (abs(exact) or 1.0),
            run_time=run_time * pieces / count,
            evaluations=pieces * positions,
        )
        for pieces, scatter in scatters.items()
    ]
