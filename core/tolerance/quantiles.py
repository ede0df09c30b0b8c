"""Percentiles and yield of a sample, with intervals that hold whatever the distribution is."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

import numpy as np

from core.arrays import FloatArray
from core.errors import InvalidInput

CONFIDENCE = 0.95


@dataclass(frozen=True, slots=True)
class Estimate:
    """A number with its interval.

    Attributes
    ----------
    value, low, high : float
        The number, and the ends of its 95 % interval.
    """

    value: float
    low: float
    high: float


def _below(count: int, p: float) -> FloatArray:
    """Probabilities of at most 0, 1, ... successes of so many trials."""
    k = np.arange(count + 1)
    logs = np.array([math.lgamma(each + 1) for each in range(count + 1)])
    with np.errstate(divide="ignore"):
        terms = logs[-1] - logs - logs[::-1] + k * math.log(p) + (count - k) * math.log1p(-p)
    return np.cumsum(np.exp(terms))


def percentile(*, values: Sequence[float] | FloatArray, percent: float) -> Estimate:
    """Percentile of a sample, by order statistics.

    Parameters
    ----------
    values : sequence of float
        The sample, n values.
    percent : float
        Percentage, between 0 and 100.

    Returns
    -------
    Estimate
        The value of rank ceil(n*p); the ends are those of the binomial quantiles, free of any
        distribution.

    Raises
    ------
    InvalidInput
        If the sample is too small for the interval.

    Examples
    --------
    >>> percentile(values=range(1, 1001), percent=99.9)
    Traceback (most recent call last):
    core.errors.InvalidInput: percent = 99.9 needs a larger sample
    >>> percentile(values=range(1, 1001), percent=50)
    Estimate(value=500.0, low=469.0, high=532.0)
    """
    if not 0 < percent < 100:
        limit = 0 if percent <= 0 else 100
        raise InvalidInput("percent", percent, "greater_than" if limit == 0 else "less_than",
                           limit=limit)  # fmt: skip
    ordered = np.sort(np.asarray(values, dtype=float))
    count, exact = len(ordered), Fraction(repr(percent)) / 100
    below = _below(count, float(exact)) if count else np.zeros(1)
    low = int(np.searchsorted(below, (1 - CONFIDENCE) / 2))
    high = int(np.searchsorted(below, (1 + CONFIDENCE) / 2)) + 1
    if low < 1 or high > count:
        raise InvalidInput("percent", percent, "too_few")
    rank = math.ceil(count * exact)
    return Estimate(*(float(ordered[each - 1]) for each in (rank, low, high)))


def share(*, successes: int, count: int) -> Estimate:
    """Share of successes, with the interval of Clopper and Pearson.

    Parameters
    ----------
    successes, count : int
        How many of how many.

    Returns
    -------
    Estimate

    Examples
    --------
    >>> found = share(successes=3122, count=4096)
    >>> round(found.low, 8), round(found.high, 8)
    (0.74886282, 0.77517624)
    """
    rest = (1 - CONFIDENCE) / 2

    def end(tail: int, above: bool) -> float:
        low, high = 0.0, 1.0
        for _ in range(60):
            p = (low + high) / 2
            most = float(_below(count, p)[tail])
            if (1 - most < rest) if above else (most > rest):
                low = p
            else:
                high = p
        return (low + high) / 2

    return Estimate(
        successes / count,
        0.0 if successes == 0 else end(successes - 1, above=True),
        1.0 if successes == count else end(successes, above=False),
    )
