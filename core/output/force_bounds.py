"""Bounds of the force over a stretch of a segment, from what is known at its ends.

With t the tangent of the best placed pair's pressure angle and d the phase of another driving pair
against it, ``u = cos(d) - t*sin(d)`` is that one's cosine over its own, linear in t, and the force
ratio is ``f = sqrt(1 + t^2)/T`` with ``T = sum(u^(1 + v))``. T is convex in t,
``L = sum(sin(d)*u^v)`` falls, and ``B = T + (1 + v)*t*L`` rises up to t = 0 and falls from there.
``t*B + (1 + v)*L`` has the sign of the slope of f; none of its two parts is large where they nearly
cancel, as those of ``t*T + (1 + v)*(1 + t^2)*L`` are beside a dead centre.
"""

import math
from typing import NamedTuple

RESOLUTION = 1e-7
"""Last step to a summit, over its distance from the ends of its bracket: steps converge
quadratically, and the height is off by the square of what is left, so both are below rounding."""

NARROW = 2.0**-12
"""Width of a stretch, over its distance from the ends of the segment, in which all summits, if
there are more than one, are equally high but for rounding: where two part from one, they differ
with the fourth power of their distance."""

HALVINGS = 50
"""Halvings after which a stretch of a segment is not halved any more: it is a rounding error."""


class Look(NamedTuple):
    """What is known at one place; all dimensionless."""

    tangent: float  # t, tangent of the pressure angle of the best placed pair
    force: float  # force ratio f
    slope: float  # t*B + (1 + v)*L
    change: float  # its derivative by t
    total: float  # T
    lead: float  # L
    balance: float  # B
    falling: float  # sum of sin(d)^2*u^(v - 1) over the pairs whose u falls with t
    rising: float  # the same over those whose u rises


def least_total(left: Look, right: Look, exponent: float) -> float:
    """Lower bound of T: where its tangents at the ends meet, or the lower end.

    Parameters
    ----------
    left, right : Look
        At the ends of the stretch.
    exponent : float
        Force exponent v.

    Returns
    -------
    float
        At least 1, the share of the best placed pair itself.
    """
    if left.lead <= 0:
        return left.total
    if right.lead >= 0:
        return right.total
    width = (1 + exponent) * (right.tangent - left.tangent)
    meet = (left.total - right.total - width * right.lead) / (left.lead - right.lead)
    return max(left.total - left.lead * min(max(meet, 0.0), width), 1.0)


def most_summits(left: Look, right: Look, exponent: float, highest: float, least: float) -> int:
    """Most summits above the highest force found that a stretch may have.

    Parameters
    ----------
    left, right : Look
        At its ends.
    exponent : float
        Force exponent v.
    highest : float
        The highest force ratio found.
    least : float
        Lower bound of T, see `least_total`.

    Returns
    -------
    int
        0, 1, or 2 for any number.
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
    """Where to look next for a place at which the slope falls through 0.

    Parameters
    ----------
    here : Look
        At the last place.
    start, stop : float
        Tangents between which it lies.

    Returns
    -------
    float
        A step of Newton's method, or half way between where that does not stay inside.
    """
    place = here.tangent - here.slope / here.change if here.change < 0 else start
    return place if start < place < stop else (start + stop) / 2
