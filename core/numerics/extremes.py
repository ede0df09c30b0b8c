"""What is largest over a turn: about samples, ever closer, and by a second look at other places.

A finer grid that keeps the places of a coarser one misses what that missed: a summit between two of
them whose slopes hide behind a neighbour's. Even places of another number, moved by an irrational
part of their distance, share nothing with the first.
"""

import math
from collections.abc import Callable

import numpy as np

from core.arrays import FloatArray

MOVED = (math.sqrt(5) - 1) / 2
"""By what part of their distance the places are moved: none of a grid's, by the golden section."""

NEARLY = 0.05
"""How far below the first look's largest value, as a part of the range, a summit is narrowed."""

LOOKED = 8
"""Most summits that are narrowed."""

CLOSER = 24
"""Narrowings at most about a sample beside a jump."""

POINTS, ZOOMS = np.linspace(-1.0, 1.0, 17), 8
"""Places about the best one, and how often as many closer ones follow: to 6e-8 of the width."""

ROUNDED = 1e-12
"""Part of a height by which a summit may be found too low."""

LAST = len(POINTS) - 1

CLOSER_BY = float(POINTS[1] - POINTS[0])
"""By how much closer they are each time."""

Narrow = Callable[[float, float], tuple[float, float, float]]
"""Place and height of the largest value between two places, and its error."""


def other_places(*, count: int, first: float = 0.0, period: float = 2 * math.pi) -> FloatArray:
    """Even places over a period, moved off those that begin at the first.

    Parameters
    ----------
    count : int
        How many: a prime shares no place with a grid of fewer or of a multiple of others.
    first : float
        Where the other grid begins, rad.
    period : float
        Of what is looked at, rad.

    Returns
    -------
    array, shape (count,)
        rad.

    Examples
    --------
    >>> other_places(count=3).round(3).tolist()
    [1.294, 3.389, 5.483]
    """
    return np.asarray(first + (np.arange(count) + MOVED) * (period / count), np.float64)


def zoom(
    *,
    values: Callable[[FloatArray], FloatArray],
    places: FloatArray,
    width: FloatArray | float,
    low: float = -math.inf,
    high: float = math.inf,
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """The largest values about some places: the best of some points, then of as many closer ones.

    Parameters
    ----------
    values : callable
        Values at places, shape (m,).
    places : array, shape (n,)
        Where to look.
    width : float or array, shape (n,)
        How far about them.
    low, high : float
        Ends beyond which nothing is looked at.

    Returns
    -------
    places, heights : array, shape (n,)
    errors : array, shape (n,)
        How far the value falls to the last points beside: a cusp between them is no higher above
        the best, and where the value is smooth that is next to nothing.

    Examples
    --------
    A cusp at 1:

    >>> cusp = lambda x: -np.abs(x - 1)
    >>> place, height, error = zoom(values=cusp, places=np.array([0.8]), width=0.5)
    >>> bool(abs(place[0] - 1) < 1e-7 and -error[0] <= height[0] <= 0 and error[0] < 1e-7)
    True
    """
    row = np.arange(len(places))
    reach = np.broadcast_to(np.asarray(width, np.float64), places.shape)
    heights = errors = np.zeros(len(places))
    for _ in range(ZOOMS):
        around = np.clip(places[:, None] + np.multiply.outer(reach, POINTS), low, high)
        found = values(around.ravel()).reshape(around.shape)
        best = found.argmax(axis=1)
        places, heights = around[row, best], found[row, best]
        before, after = found[row, np.maximum(best - 1, 0)], found[row, np.minimum(best + 1, LAST)]
        errors = heights - np.minimum(before, after)
        reach = reach * CLOSER_BY
    return places, heights, errors


def hill(
    *, place: float, height: float, low: float, high: float, narrow: Narrow
) -> tuple[float, float, float]:
    """The largest value about a sample, between its neighbours.

    It is found where there is one hill. Where it comes out below the sample, there is a
    jump beside it, or a plateau narrower than the places are apart: then it is looked for about
    what is known to be highest, ever closer.

    Parameters
    ----------
    place, height : float
        Where the sample is, rad, and how high.
    low, high : float
        Its neighbours, rad.
    narrow : callable
        The largest value between two places.

    Returns
    -------
    place, height, error : float
        Where it is, rad, how high, and the error of the narrowing.

    Examples
    --------
    A plateau that rises to 1.2 and falls off there, with samples at 0, 1 and 2:

    >>> def narrow(low, high):
    ...     return max((x, x if 0.9 < x < 1.2 else 0.0, 0.0) for x in (low, high))
    >>> hill(place=1.0, height=1.0, low=0.0, high=2.0, narrow=narrow)[1] > 1.18
    True
    """
    found = narrow(low, high)
    if found[1] >= height - ROUNDED * abs(height):
        return found
    best, width = (place, height, 0.0), min(place - low, high - place)
    for _ in range(CLOSER):
        found = narrow(max(low, best[0] - width), min(high, best[0] + width))
        if found[1] > best[1]:
            best = found
        else:
            width /= 2
    return best


def second_look(
    *,
    places: FloatArray,
    heights: FloatArray,
    known: float,
    narrow: Narrow,
    period: float = 2 * math.pi,
) -> tuple[float, float, float]:
    """The largest value that a second look finds.

    Parameters
    ----------
    places, heights : array, shape (n,)
        Even places over a period, rad, and the values there.
    known : float
        Largest value that the first look found.
    narrow : callable
        The largest value between two places.
    period : float
        Of what is looked at, rad.

    Returns
    -------
    place, height : float
        Where it is, rad, and how high; the first look's value, at no place (NaN), where nothing
        is higher.
    error : float
        Of the narrowing there.

    Examples
    --------
    >>> places = other_places(count=7)
    >>> look = lambda low, high: (1.0, 1.0, 0.0)
    >>> second_look(places=places, heights=np.cos(places - 1), known=0.9, narrow=look)
    (1.0, 1.0, 0.0)
    """
    step = period / len(places)
    before, after = np.roll(heights, 1), np.roll(heights, -1)
    tops = np.flatnonzero((heights >= before) & (heights > after))
    # what a summit may be above its sample: as far as it fell to the farther neighbour
    ceilings = heights + np.maximum(heights - before, heights - after)
    least = known - NEARLY * float(np.ptp(heights))
    best, where, off = known, math.nan, 0.0
    for top in sorted(tops.tolist(), key=lambda top: -heights[top])[:LOOKED]:
        if ceilings[top] < best or heights[top] < least:
            continue
        place = float(places[top])
        place, height, error = hill(
            place=place,
            height=float(heights[top]),
            low=place - step,
            high=place + step,
            narrow=narrow,
        )
        if height > best:
            best, where, off = height, place, error
    return where, best, off
