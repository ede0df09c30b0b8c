"""Share of each tolerance in the variance: Sobol' indices by source, percentiles without one."""

import math
from dataclasses import dataclass

import numpy as np

from core.arrays import FloatArray
from core.drive.engine import FITS
from core.fields import answer
from core.tolerance.quantiles import Estimate, percentile, share
from core.tolerance.study import Study
from core.tolerance.tolerances import Drawn


@dataclass(frozen=True, slots=True, kw_only=True)
class Contribution:
    """Contribution of one source to the variance of a quantity."""

    source: str = answer()
    """Name of the tolerance in the request."""
    total: float = answer("", "S_T")
    """Share of the variance that depends on the tolerance, alone or together with others."""
    total_error: float = answer()
    """Standard error of the total share."""
    first: float = answer("", "S_1")
    """Share of the variance that the tolerance explains alone."""
    first_error: float = answer()
    """Standard error of the share of the tolerance alone."""
    # Percentile, or share of pieces that fit, with this source at the middle of its limits.
    without: Estimate


MOST_FIT = 0.95
"""Share of pieces that fit below which contributions to the fit are calculated: contributions to a
quantity need pairs of pieces that both fit."""


def contributions(
    *, study: Study, percent: float = 95.0, to_fit: bool = False
) -> tuple[Contribution, ...]:
    """Contributions of the sources to the first quantity of a study, the largest first.

    n*(2*G + 2) pieces are calculated for G sources. Jansen 1999, with two samples A and B, and AB
    which is A with one source from B: ``S_T = mean((f_A - f_AB)^2)/(2*V)``,
    ``S_1 = 1 - mean((f_B - f_AB)^2)/(2*V)``. Correlations and linear fits say nothing, because the
    peak force is even in most deviations. Totals above 1 in sum mean that sources act together.
    Pieces that do not fit or cannot work are left out. Each index is a ratio of means, as V is
    estimated from the samples too, so the standard error is that of
    ``(f_A - f_AB)^2/2 - S*(f - <f>)^2`` over V (Cochran 1977, Sampling Techniques, 6). `percent` is
    that of the percentile without each source. True for `to_fit` takes contributions to the fit, 1
    or 0 of each piece, in place of a quantity.
    """

    def first_quantity(pieces: Drawn) -> FloatArray:
        values, fits = study.values(pieces)
        return np.where(fits == FITS, 1.0, 0.0) if to_fit else values[:, 0]

    sources = study.tolerances.sources
    one = first_quantity(study.pieces())
    other = first_quantity(study.pieces(other=sources))
    both = np.stack([one, other])
    variance = float(np.nanvar(both)) or math.inf  # infinite, so that indices are 0, if it is 0
    varied = np.mean((both - np.nanmean(both)) ** 2, axis=0) / variance

    def index(differences: FloatArray) -> tuple[float, float]:
        squares = differences**2 / (2 * variance)
        share = float(np.nanmean(squares))
        off = squares - share * varied
        return share, float(np.nanstd(off) / np.sqrt(np.count_nonzero(~np.isnan(off))))

    found = []
    for source in sources:
        mixed = first_quantity(study.pieces(other=(source,)))
        total, first = index(one - mixed), index(other - mixed)
        left = study.pieces(tolerances=study.tolerances.without(source))
        rest = first_quantity(left)
        if to_fit:
            without = share(successes=int(rest.sum()), count=len(rest))
        else:
            without = percentile(values=rest[~np.isnan(rest)], percent=percent)
        found.append(
            Contribution(
                source=source,
                total=total[0],
                total_error=total[1],
                first=1 - first[0] if variance < math.inf else 0.0,
                first_error=first[1],
                without=without,
            )
        )
    return tuple(sorted(found, key=lambda each: -each.total))
