"""Percentiles and yield of a sample, with intervals that hold for any distribution."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

import numpy as np

from core.arrays import FloatArray
from core.errors import InvalidInput
from core.fields import answer

CONFIDENCE = 0.95


@dataclass(frozen=True, slots=True)
class Estimate:
    """Number with its 95 % interval."""

    value: float = answer()
    """Estimate of the quantity."""
    low: float = answer()
    """Lower end of its 95 % interval."""
    high: float = answer()
    """Upper end of its 95 % interval."""


REACH = 12.0
"""Standard deviations from the mean beyond which a binomial distribution has less than 1e-11 of its
probability, even if the mean is a few successes."""


def _reached(count: int, p: float) -> tuple[int, int]:
    """Range of numbers of successes outside which the binomial distribution is negligible."""
    mean, reach = count * p, REACH * (math.sqrt(count * p * (1 - p)) + 1)
    return max(0, math.floor(mean - reach)), min(count, math.ceil(mean + reach))


def _below(count: int, p: float) -> FloatArray:
    """Probabilities of at most k successes for each k in the range of `_reached`."""
    first, last = _reached(count, p)
    k = np.arange(first + 1, last + 1)
    logs = np.concatenate([[0.0], np.cumsum(np.log((count - k + 1) / k) + math.log(p / (1 - p)))])
    below: FloatArray = np.cumsum(np.exp(logs - logs.max()))
    below /= below[-1]
    return below


def _most(tail: int, count: int, p: float) -> float:
    """Probability of at most ``tail`` successes."""
    first, last = _reached(count, p)
    if first <= tail < last:
        return float(_below(count, p)[tail - first])
    return float(tail >= last)


def fewest(percent: float) -> int:
    """Least sample size in which a percentile has an interval: p^n and (1 - p)^n are at most 2.5 %.

    >>> fewest(50), fewest(95), fewest(99)
    (6, 72, 368)
    """
    return math.ceil(math.log((1 - CONFIDENCE) / 2) / math.log(max(percent, 100 - percent) / 100))


def refuse_few(*, count: int, percent: float) -> None:
    """Raise InvalidInput if p^n or (1 - p)^n exceeds 2.5 %, as all values may lie on one side then.
    `count` is the sample size n, `percent` is 100*p, between 0 and 100.

    >>> refuse_few(count=368, percent=99)
    >>> refuse_few(count=367, percent=99)
    Traceback (most recent call last):
    core.errors.InvalidInput: percent = 99 needs a sample of at least 368
    """
    if not 0 < percent < 100:
        limit = 0 if percent <= 0 else 100
        raise InvalidInput("percent", percent, "greater_than" if limit == 0 else "less_than",
                           limit=limit)  # fmt: skip
    if count < fewest(percent):
        raise InvalidInput("percent", percent, "too_few", limit=fewest(percent))


def percentile(*, values: Sequence[float] | FloatArray, percent: float) -> Estimate:
    """Percentile of a sample by order statistics: the value of rank ceil(n*p).

    Ends of the interval are the values at the binomial quantiles, for any distribution. Raises
    InvalidInput if the sample is too small, see `refuse_few`. `percent` is 100*p, between 0 and
    100.

    >>> percentile(values=range(1, 1001), percent=50)
    Estimate(value=500.0, low=469.0, high=532.0)
    """
    refuse_few(count=len(values), percent=percent)
    ordered = np.sort(np.asarray(values, dtype=float))
    count, exact = len(ordered), Fraction(repr(percent)) / 100
    first, _ = _reached(count, float(exact))
    below = _below(count, float(exact))
    low = max(first + int(np.searchsorted(below, (1 - CONFIDENCE) / 2)), 1)
    high = min(first + int(np.searchsorted(below, (1 + CONFIDENCE) / 2)) + 1, count)
    rank = math.ceil(count * exact)
    return Estimate(*(float(ordered[each - 1]) for each in (rank, low, high)))


def share(*, successes: int, count: int) -> Estimate:
    """Share of successes with the interval of Clopper and Pearson.

    >>> found = share(successes=3122, count=4096)
    >>> round(found.low, 8), round(found.high, 8)
    (0.74886282, 0.77517624)
    """
    rest = (1 - CONFIDENCE) / 2

    def end(tail: int, above: bool) -> float:
        low, high = 0.0, 1.0
        for _ in range(60):
            p = (low + high) / 2
            most = _most(tail, count, p)
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
