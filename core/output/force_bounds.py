"""Bounds of the force over a stretch of a segment, from values at the ends of the stretch.

Let t be the tangent of the best placed pair's pressure angle, and d the phase of another driving
pair against it. The cosine of that pair over the best one's is ``u = cos(d) - t*sin(d)``, linear in
t, and the force ratio is ``f = sqrt(1 + t^2)/T`` with ``T = sum(u^(1 + v))``. T is convex in t,
``L = sum(sin(d)*u^v)`` falls, and ``B = T + (1 + v)*t*L`` rises up to t = 0 and falls from there.
The slope of f has the sign of ``t*B + (1 + v)*L``. Neither term is large where both nearly cancel,
unlike those of ``t*T + (1 + v)*(1 + t^2)*L`` beside a dead centre.
"""

import math
from typing import NamedTuple

RESOLUTION = 1e-7
"""Last step to a summit, over its distance from the ends of its bracket: steps converge
quadratically, and the height is off by the square of the rest, so that both errors are below
rounding."""

NARROW = 2.0**-12
"""Width of a stretch, over its distance from the ends of the segment, within which several
summits have one height but for rounding: heights of summits differ by the fourth power of their
distance."""

HALVINGS = 50
"""Most halvings of a segment: narrower stretches are a rounding error."""


class Look(NamedTuple):
    """Values at one place of a segment, all dimensionless."""

    tangent: float  # t, tangent of the pressure angle of the best placed pair
    force: float  # force ratio f
    slope: float  # t*B + (1 + v)*L
    change: float  # derivative of `slope` by t
    total: float  # T
    lead: float  # L
    balance: float  # B
    falling: float  # sum of sin(d)^2*u^(v - 1) over the pairs whose u falls with t
    rising: float  # sum of sin(d)^2*u^(v - 1) over the pairs whose u rises with t


def least_total(left: Look, right: Look, exponent: float) -> float:
    """Lower bound of T over a stretch: T where its tangents at the ends meet, or at the lower end,
    and at least 1, the share of the best placed pair itself.
    """
    if left.lead <= 0:
        return left.total
    if right.lead >= 0:
        return right.total
    width = (1 + exponent) * (right.tangent - left.tangent)
    meet = (left.total - right.total - width * right.lead) / (left.lead - right.lead)
    return max(left.total - left.lead * min(max(meet, 0.0), width), 1.0)


def most_summits(left: Look, right: Look, exponent: float, highest: float, least: float) -> int:
    """Largest possible number of summits of a stretch above the force ratio `highest`: 0, 1, or 2
    for any number. `least` is the lower bound of T.
    """
    start, stop, rise = left.tangent, right.tangent, 1 + exponent
    one_sided = start * stop > 0
    largest = 1 + max(start * start, stop * stop)
    smallest = 1 + min(start * start, stop * stop) if one_sided else 1.0
    if math.sqrt(largest) <= highest * least:
        return 0
    low, high = min(left.balance, right.balance), max(left.balance, right.balance)
    high = high if one_sided else max(high, left.total, right.total)  # B is T where t is 0
    slope_low = min(start * low, start * high, stop * low, stop * high) + rise * right.lead
    slope_high = max(start * low, start * high, stop * low, stop * high) + rise * left.lead
    if slope_low > 0 or slope_high < 0:
        return 0
    # How far the logarithm of the force may rise from either end; e^700 is still a number.
    length = (stop - start) / (smallest * least)
    if left.force * math.exp(min(length * slope_high, 700.0)) <= highest:
        return 0
    if right.force * math.exp(min(-length * slope_low, 700.0)) <= highest:
        return 0
    bend = right.falling + left.rising if exponent > 1 else left.falling + right.rising
    return 1 if high < rise * smallest * exponent * bend else 2  # 1: the slope falls all along


def next_place(here: Look, start: float, stop: float) -> float:
    """Next tangent at which to look for a place where the slope falls through 0: by Newton's
    method, or the middle of the range where Newton's step leaves it.
    """
    place = here.tangent - here.slope / here.change if here.change < 0 else start
    return place if start < place < stop else (start + stop) / 2
