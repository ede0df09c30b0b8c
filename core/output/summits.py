"""Summits of a function over the turn, found on a grid and then narrowed."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import chain

import numpy as np

from core.arrays import FloatArray
from core.numerics.extremes import Narrow, about, neighbours
from core.precision import AS_TYPED

ALIKE = 1e-11
"""Relative difference below which two summits of the grid count as equal."""

ZOOMED = 3
"""Least number of summits that are narrowed if the function has no spikes."""


@dataclass(frozen=True, slots=True)
class Summit:
    """Narrowed summit."""

    place: float  # rad
    height: float  # in the unit of what is sampled
    error: float  # largest rise of a kink within the last width
    alike: tuple[float, ...]  # places of equal summits, rad


@dataclass(frozen=True, slots=True)
class Grid:
    """Values over one period."""

    places: FloatArray  # rad, in their order
    heights: FloatArray  # in the unit of what is sampled
    period: float = 2 * math.pi  # rad


def height_of(summit: Summit) -> float:
    """Height of a summit."""
    return summit.height


def summits(
    *,
    grid: Grid,
    narrow: Narrow,
    known: Sequence[Summit] = (),
    most: int | None = None,
    top: bool = False,
) -> list[Summit]:
    """Summits of a grid, narrowed; equal ones are narrowed once.

    A summit is taken to be concave between its neighbours, so that it is not above the lines that
    lead to it from both sides. Summits known before are not narrowed again; `most` is the number of
    the highest ones to narrow, all by default. True for `top` narrows only summits that may be the
    highest of all, at least `ZOOMED`.
    """
    places, heights = grid.places, grid.heights
    count, turn = len(places), grid.period
    scale = float(np.abs(heights).max()) * ALIKE or 1.0
    before, after = neighbours(heights)
    tops = np.flatnonzero((heights >= before) & ((heights > after) | (count == 1)))
    if not len(tops):  # all alike
        return [Summit(float(places[0]), float(heights[0]), 0.0, (float(places[0]),))]
    seen: dict[tuple[float, ...], list[int]] = {}
    keys = np.round(np.stack([before, heights, after])[:, tops] / scale).T
    for i, key in zip(tops.tolist(), keys.tolist(), strict=True):
        seen.setdefault(tuple(key), []).append(i)
    gaps = neighbours(places)[1] - places
    gaps[-1] += turn
    risen, fallen = heights - before, heights - after
    slopes = neighbours(gaps)[0] / gaps
    ceilings = heights + (np.maximum(risen / slopes, fallen * slopes) if top else 0.0)
    found: list[Summit] = []
    for alike in sorted(seen.values(), key=lambda alike: -ceilings[alike[0]])[:most]:
        i = alike[0]
        if top and len(found) >= ZOOMED and ceilings[i] <= max(map(height_of, found)):
            break
        near = about(places=places, heights=heights, top=i, period=turn)
        same = [each for each in known if near[0][1] <= each.place <= near[0][3]]
        if same:
            found.append(same[0])
            continue
        place, height, error = narrow(*near)
        others = tuple(place + float(places[k] - places[i]) for k in alike)
        found.append(Summit(place, height, error, others))
    return found


def highest(*, coarse: Grid, fine: Grid, narrow: Narrow) -> tuple[list[Summit], float]:
    """Summits of a function without spikes, the highest one first with the places of all of its
    height, and the height that the coarse grid misses.

    The fine grid has all places of the coarse one.
    """
    found = summits(grid=fine, narrow=narrow, top=True)
    rough = summits(grid=coarse, narrow=narrow, known=found, top=True)
    top = max(found, key=height_of)
    equal = [each.alike for each in found if top.height - each.height <= AS_TYPED * abs(top.height)]
    top = replace(top, alike=tuple(chain.from_iterable(equal)))
    return [top, *found], abs(top.height - max(map(height_of, rough)))
