"""Largest load ratings that a rolling bearing of given outer sizes can have.

The bounds take the gap between bore and outside as filled by rolling elements, without rings and
cage. Of about 2,300 roller and 1,000 ball bearings of catalogues, rollers reach 0.89 of the dynamic
and 0.98 of the static bound at most, balls 1.18 and 1.05 (four-point contact).
"""

import math
from dataclasses import dataclass

from core.crank.bearing_life import Bearing
from core.errors import InvalidInput

HIGH: dict[Bearing, float] = {"ball": 1.2, "roller": 1.0}
"""Share of the bounds above which a rating is higher than any known one."""

IMPOSSIBLE: dict[Bearing, float] = {"ball": 1.5, "roller": 1.2}
"""Share of the bounds above which no such bearing exists."""

LOW = 0.05
"""Share of the bounds below which a rating may be typed in another unit."""

MIN_LOAD: dict[Bearing, float] = {"ball": 0.01, "roller": 0.02}
"""Least load over the dynamic rating at which rolling elements roll (catalogues of SKF)."""

MOST_DYNAMIC, MOST_STATIC = 0.5, 1.0
"""Load over dynamic and static rating above which the life formula is invalid (ISO 281)."""

ROWS = 40
"""Numbers of rows of balls that are tried, besides the number that fits across the gap."""

BORES = 64
"""Number of bores that are tried where the bore is unknown."""

LARGE_BALL = 25.4e-3
"""Ball diameter above which the rating grows with another power, m."""


@dataclass(frozen=True, slots=True)
class Bounds:
    """Largest load ratings that fit into an envelope."""

    dynamic: float  # C, N
    static: float  # C0, N


def largest_ratings(
    *, kind: Bearing, bore_diameter: float, outer_diameter: float, width: float
) -> Bounds:
    """Largest load ratings of a bearing of these sizes, in m.

    ``D_w = (D - d)/2, d_m = (D + d)/2, gamma = D_w/d_m, Z = pi/asin(gamma)``. Rollers:
    ``C = 1.15*f_c*B^(7/9)*Z^(3/4)*D_w^(29/27)``, ``C0 = 44*(1 - gamma)*Z*B*D_w``; balls, with the
    number of rows i that carries most: ``C = 1.3*f_c*i^0.7*Z^(2/3)*D_w^1.8``,
    ``C0 = 16.5*pi*d_m*B``; in N and mm. The factors f_c are after ISO 281, the static ratings after
    ISO 76.

    >>> round(largest_ratings(
    ...     kind="ball", bore_diameter=25e-3, outer_diameter=52e-3, width=15e-3).dynamic)
    31124
    """
    if not bore_diameter < outer_diameter:
        raise InvalidInput(
            "bore_diameter",
            bore_diameter,
            "smaller_than",
            field="outer_diameter",
            limit=outer_diameter,
        )
    gap, middle = (outer_diameter - bore_diameter) / 2e-3, (outer_diameter + bore_diameter) / 2e-3
    wide = width * 1e3
    if kind == "roller":
        gamma = gap / middle
        count = math.pi / math.asin(gamma)
        other = math.pow(1.04 * ((1 - gamma) / (1 + gamma)) ** (143 / 108), 4.5)
        shape = math.pow(gamma, 2 / 9) * math.pow(1 - gamma, 29 / 27) / math.pow(1 + gamma, 0.25)
        factor = 207.9 * 0.83 * shape * math.pow(1 + other, -2 / 9)
        dynamic = 1.15 * factor * wide ** (7 / 9) * count**0.75 * gap ** (29 / 27)
        return Bounds(dynamic, 44 * (1 - gamma) * count * wide * gap)
    # More rows of balls that fill the gap carry more; with still more rows the balls shrink faster.
    most = {max(1, math.floor(wide / gap)), math.ceil(wide / gap)}
    rows = most.union(range(1, ROWS + 1))
    return Bounds(max(_balls(i, gap, middle, wide) for i in rows), 16.5 * math.pi * middle * wide)


def largest_ratings_of_room(
    *, kind: Bearing, least_bore: float, outer_diameter: float, width: float
) -> Bounds:
    """Largest ratings of bearings in a room, m, each over all bores from the least one on."""
    bounds = [
        largest_ratings(
            kind=kind,
            bore_diameter=least_bore + (outer_diameter - least_bore) * step / BORES,
            outer_diameter=outer_diameter,
            width=width,
        )
        for step in range(BORES)
    ]
    return Bounds(max(each.dynamic for each in bounds), max(each.static for each in bounds))


def _balls(rows: int, gap: float, middle: float, wide: float) -> float:
    """Dynamic rating, N, of rows of balls as large as gap and width, mm, allow."""
    ball = min(gap, wide / rows)
    gamma = ball / middle
    count = math.pi / math.asin(gamma)
    other = math.pow(1.04 * ((1 - gamma) / (1 + gamma)) ** 1.72, 10 / 3)
    shape = math.pow(gamma, 0.3) * math.pow(1 - gamma, 1.39) / math.pow(1 + gamma, 1 / 3)
    factor = 37.905 * math.pow(26, 0.41) * shape * math.pow(1 + other, -0.3)
    large = ball > LARGE_BALL * 1e3
    size = 3.647 * math.pow(ball, 1.4) if large else math.pow(ball, 1.8)
    return 1.3 * factor * math.pow(rows, 0.7) * math.pow(count, 2 / 3) * size
