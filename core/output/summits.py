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


@dataclass(frozen=True, slots=True)
class Summit:
    """A summit, narrowed: its place and height, how much higher a kink within the width may be, and
    where others look the same.
    """

    place: float
    height: float
    error: float
    alike: tuple[float, ...]


def golden(f: Callable[[float], float], low: float, high: float) -> tuple[float, float, float]:
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
    values: dict[float, float],
    f: Callable[[float], float],
    known: Sequence[Summit] = (),
    most: int | None = None,
) -> list[Summit]:
    """Summits of values on a turn's grid, in its order, narrowed; those that look alike are
    narrowed once, and those that are known not again. With `most`, only so many of the highest.
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
    chosen = sorted(seen.values(), key=lambda alike: -heights[alike[0]])[:most]
    found = []
    for alike in chosen:
        i = alike[0]
        low = places[i - 1] - (turn if i == 0 else 0)
        high = places[i + 1] if i + 1 < count else places[0] + turn
        if any(low <= each.place <= high for each in known):
            continue
        place, height, error = golden(f, low, high)
        if heights[i] > height:
            place, height = places[i], heights[i]
        others = tuple(place + places[k] - places[i] for k in alike)
        found.append(Summit(place, height, error, others))
    return found


def highest(values: dict[float, float], f: Callable[[float], float]) -> Summit:
    """The highest summit over a turn, of the highest ones of its grid."""
    return max(summits(values, f, most=ZOOMED), key=lambda summit: summit.height)


def all_summits(
    coarse: dict[float, float], fine: dict[float, float], f: Callable[[float], float]
) -> tuple[list[Summit], Summit, float]:
    """All summits of a coarse and of a fine grid, the highest of them, and what the coarse one
    alone would have given.
    """

    def height(summit: Summit) -> float:
        return summit.height

    found = summits(coarse, f)
    rough = max(map(height, found))
    found += summits(fine, f, found)
    return found, max(found, key=height), rough
