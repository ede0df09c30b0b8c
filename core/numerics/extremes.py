"""Largest value of a function over a period: narrowing about samples, and a second look.

A finer grid that contains a coarser one can miss a summit between two of the coarse places whose
slopes a neighbouring summit hides. The second look therefore uses even places in another number,
shifted by an irrational part of their spacing, which share no place with the first grid.
"""

import math
from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike

from core.arrays import FloatArray
from core.precision import AS_TYPED

MOVED = (math.sqrt(5) - 1) / 2
"""Shift of the second look's places over their spacing: the golden section meets no grid."""

NEARLY = 0.05
"""Part of the range of values: summits farther below the known largest value are not narrowed."""

LOOKED = 8
"""Largest number of summits that a second look narrows."""

POINTS, ZOOMS = np.linspace(-1.0, 1.0, 17), 8
"""Places over the half width, and number of zooms: the last spacing is 6e-8 of the half width."""

LAST = len(POINTS) - 1

CLOSER_BY = float(POINTS[1] - POINTS[0])
"""Width of a zoom over that of the zoom before."""

Narrow = Callable[[FloatArray, FloatArray], tuple[float, float, float]]
"""Function that returns place, height and error of the largest value about the middle one of five
places, rad, from these and their heights, each of shape (5,).
"""


def about(
    *, places: FloatArray, heights: FloatArray, top: int, period: float
) -> tuple[FloatArray, FloatArray]:
    """Place and height of a sample of a periodic function and of two on either side, shape (5,).

    >>> about(places=np.array([0.0, 1, 2]), heights=np.array([5.0, 6, 7]), top=2, period=3)
    (array([0., 1., 2., 3., 4.]), array([5., 6., 7., 5., 6.]))
    """
    turns, near = np.divmod(np.arange(top - 2, top + 3), len(places))
    return places[near] + period * turns, heights[near]


def neighbours(heights: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Heights before and after each sample of a periodic function, each of shape (n,).

    >>> neighbours(np.array([1.0, 2, 3]))
    (array([3., 1., 2.]), array([2., 3., 1.]))
    """
    at = np.arange(len(heights))
    return heights[at - 1], heights[at + 1 - len(at)]


def first_largest(values: ArrayLike) -> int:
    """Index of the first of the largest values, which are not negative; values that differ by no
    more than two searches of one summit count as equal.

    >>> first_largest([1.0, 2.0, 2.0 + 1e-10])
    1
    """
    found = np.asarray(values)
    return int((found >= found.max() * (1 - AS_TYPED)).argmax())


def other_places(*, count: int, first: float = 0.0, period: float = 2 * math.pi) -> FloatArray:
    """Even places over a period, rad, that share none with a grid from `first`; shape (count,).

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
    """Places, heights and errors of the largest values about some places, each of shape (n,).

    The best of 17 points about each place is the centre of as many closer points, eight times. The
    error is the fall from the height to the lower one of the last neighbouring points, which bounds
    a cusp between them. `places` are the centres of the search, `width` is its half width about
    each, `low` and `high` are limits of the places.

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


def second_look(
    *,
    places: FloatArray,
    heights: FloatArray,
    known: float,
    narrow: Narrow,
    period: float = 2 * math.pi,
) -> tuple[float, float, float]:
    """Place, height and error of the largest value that a second look finds.

    Places are even over the period, rad. Where nothing is higher than `known`, the largest value of
    the first look, that one is returned with the place NaN.

    >>> places = other_places(count=7)
    >>> look = lambda places, heights: (1.0, 1.0, 0.0)
    >>> second_look(places=places, heights=np.cos(places - 1), known=0.9, narrow=look)
    (1.0, 1.0, 0.0)
    """
    before, after = neighbours(heights)
    tops = np.flatnonzero((heights >= before) & (heights > after))
    # A summit is taken to rise above its sample by no more than the fall to the lower neighbour.
    ceilings = heights + np.maximum(heights - before, heights - after)
    least = known - NEARLY * float(np.ptp(heights))
    best, where, off = known, math.nan, 0.0
    for top in sorted(tops.tolist(), key=lambda top: -heights[top])[:LOOKED]:
        if ceilings[top] < best or heights[top] < least:
            continue
        near = about(places=places, heights=heights, top=top, period=period)
        place, height, error = narrow(*near)
        if height > best:
            best, where, off = height, place, error
    return where, best, off
