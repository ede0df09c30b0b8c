"""Summits of a function over the turn, narrowed by golden section, which asks for no derivative."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

PLACE = 1e-10
"""Width to which a summit is narrowed, rad."""

ALIKE = 1e-11
"""Relative difference below which two summits look equal on the grid."""

ZOOMED = 3
"""How many of the highest summits are narrowed, of what has no spikes."""

GOLDEN = (math.sqrt(5) - 1) / 2


Function = Callable[[float], float]


@dataclass(frozen=True, slots=True)
class Summit:
    """A summit, narrowed.

    Attributes
    ----------
    place, height : float
        Where it is, rad, and how high.
    error : float
        How much higher a kink within the last width may be.
    alike : tuple of float
        Where others look the same, rad.
    """

    place: float
    height: float
    error: float
    alike: tuple[float, ...]


def _golden(f: Function, low: float, high: float) -> tuple[float, float, float]:
    """Place and height of the largest value between two places, by golden section, and its error:
    by how much it changed while the width was narrowed to its last sixteenth.
    """
    error = 0.0
    a, b = high - GOLDEN * (high - low), low + GOLDEN * (high - low)
    at_a, at_b = f(a), f(b)
    while high - low > PLACE:
        if high - low < 16 * PLACE:
            error = max(error, abs(at_a - at_b))
        if at_a >= at_b:
            high, b, at_b = b, a, at_a
            a = high - GOLDEN * (high - low)
            at_a = f(a)
        else:
            low, a, at_a = a, b, at_b
            b = low + GOLDEN * (high - low)
            at_b = f(b)
    return (a, at_a, error) if at_a >= at_b else (b, at_b, error)


def summits(
    *,
    values: dict[float, float],
    function: Function,
    known: Sequence[Summit] = (),
    most: int | None = None,
) -> list[Summit]:
    """Summits of values on a turn's grid, narrowed; those that look alike are narrowed once.

    Parameters
    ----------
    values : dict of float to float
        Places over one turn, rad, in their order, and the values there.
    function : callable
        The value at a place.
    known : sequence of Summit
        Summits that have been narrowed: what leads to one of them is not narrowed again.
    most : int, optional
        Only so many of the highest.

    Returns
    -------
    list of Summit
    """
    places, heights = [*values], [*values.values()]
    count, turn = len(places), 2 * math.pi
    scale = max(map(abs, heights)) * ALIKE or 1.0
    seen: dict[tuple[int, ...], list[int]] = {}
    for i, height in enumerate(heights):
        before, after = heights[i - 1], heights[(i + 1) % count]
        if height >= before and (height > after or count == 1):
            key = tuple(round(each / scale) for each in (before, height, after))
            seen.setdefault(key, []).append(i)
    if not seen:  # all alike
        return [Summit(places[0], heights[0], 0.0, (places[0],))]
    found = []
    for alike in sorted(seen.values(), key=lambda alike: -heights[alike[0]])[:most]:
        i = alike[0]
        low = places[i - 1] - (turn if i == 0 else 0)
        high = places[i + 1] if i + 1 < count else places[0] + turn
        same = next((each for each in known if low <= each.place <= high), None)
        if same is not None:
            found.append(same)
            continue
        place, height, error = _golden(function, low, high)
        if heights[i] > height:
            place, height = places[i], heights[i]
        others = tuple(place + places[k] - places[i] for k in alike)
        found.append(Summit(place, height, error, others))
    return found


def _height(summit: Summit) -> float:
    return summit.height


def highest(
    *, coarse: dict[float, float], fine: dict[float, float], function: Function
) -> tuple[Summit, float]:
    """The highest summit of what has no spikes, of the highest ones of a grid.

    Parameters
    ----------
    coarse, fine : dict of float to float
        Places over one turn, rad, in their order, and the values there; the fine grid has those of
        the coarse one.
    function : callable
        The value at a place.

    Returns
    -------
    summit : Summit
        The highest.
    missed : float
        How much of it the coarse grid alone would have missed.
    """
    found = summits(values=fine, function=function, most=ZOOMED)
    rough = summits(values=coarse, function=function, known=found, most=ZOOMED)
    top = max(found, key=_height)
    return top, abs(top.height - max(map(_height, rough)))


def all_summits(
    *, coarse: dict[float, float], fine: dict[float, float], function: Function
) -> tuple[list[Summit], Summit, float]:
    """All summits of a coarse and of a fine grid.

    Parameters
    ----------
    coarse, fine : dict of float to float
        As `highest` takes them.
    function : callable
        The value at a place.

    Returns
    -------
    summits : list of Summit
        All.
    highest : Summit
        The highest of them.
    rough : float
        Height that the coarse grid alone would have given.
    """
    found = summits(values=coarse, function=function)
    rough = max(map(_height, found))
    found += summits(values=fine, function=function, known=found)
    return found, max(found, key=_height), rough
