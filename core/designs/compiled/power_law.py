"""Peaks of any law of load sharing, compiled: stretches are halved until a summit stands alone.

What is done for one design in `core.force_laws`, with the same bounds: with t = tan(pressure angle
of the best placed pair) the cosine of a pair whose phase against that one is d, over the best
one's, is ``u = cos(d) - t*sin(d)``, linear in t, and the force ratio is
``f = sqrt(1 + t^2)/sum(u^(1 + v))``. It is continuous over the whole turn, for u is 0 where a pair
begins to drive.
"""

import math
from typing import Any

from core.contact_force import FloatArray
from core.designs.compiled.compiling import part
from core.designs.compiled.segments import driving, enter, join, remainder
from core.designs.room import SPLITS, TURN, ComplexArray, Records
from core.force_laws import NARROW, RESOLUTION
from core.results import ROUNDING


@part
def _gather(
    pins: int,
    best: int,
    phases: Records,
    relative: ComplexArray,
    roots: ComplexArray,
    cosines: FloatArray,
    sines: FloatArray,
) -> int:
    """Number of the pairs that drive beside the best placed one; their phases are filled in."""
    number = 0
    for k in range(len(phases)):
        first, last = driving(pins, phases[k].nearest)
        turned = remainder(phases[best].step - phases[k].step + first, pins)
        for pin in range(int(first), int(last) + 1):
            if k != best or pin != 0:
                direction = relative[best, k] * roots[int(turned)]
                cosines[number], sines[number] = direction.real, direction.imag
                number += 1
            turned = turned + 1 if turned + 1 < pins else 0.0
    return number


@part
def _look(
    row: int,
    tangent: float,
    exponent: float,
    number: int,
    cosines: FloatArray,
    sines: FloatArray,
    places: Records,
) -> float:
    """Force at a place; all that is known there is filled in."""
    total = 1.0
    lead = falling = rising = 0.0
    for pair in range(number):
        ratio = cosines[pair] - tangent * sines[pair]
        if ratio > 0:
            power = ratio**exponent
            bend = power / ratio * sines[pair] * sines[pair]
            total += power * ratio
            lead += power * sines[pair]
            falling += bend if sines[pair] > 0 else 0.0
            rising += 0.0 if sines[pair] > 0 else bend
    stretch = 1 + tangent * tangent
    rise = 1 + exponent
    balance = total + rise * tangent * lead
    place = places[row]
    place.tangent, place.force = tangent, math.sqrt(stretch) / total
    place.slope = tangent * balance + rise * lead
    place.change = balance - rise * stretch * exponent * (falling + rising)
    place.total, place.lead, place.balance = total, lead, balance
    place.falling, place.rising = falling, rising
    return math.sqrt(stretch) / total


@part
def _least_total(left: Any, right: Any, exponent: float) -> float:
    """Where the tangents of the convex total at the ends meet, or the lower end; at least 1."""
    least: float = left.total
    if right.lead >= 0:
        least = right.total
    elif left.lead > 0:
        width = (right.tangent - left.tangent) * (1 + exponent)
        meet = (left.total - right.total - width * right.lead) / (left.lead - right.lead)
        least = max(left.total - left.lead * min(max(meet, 0.0), width), 1.0)
    return least


@part
def _most_summits(left: Any, right: Any, exponent: float, highest: float) -> int:
    """Most summits above the highest found that a stretch may have: 0, 1, or 2 for more."""
    start, stop, rise = left.tangent, right.tangent, 1 + exponent
    apart = start * stop > 0
    largest = 1 + max(start * start, stop * stop)
    smallest = 1 + min(start * start, stop * stop) if apart else 1.0
    least = _least_total(left, right, exponent)
    if math.sqrt(largest) <= highest * least:
        return 0
    low, high = min(left.balance, right.balance), max(left.balance, right.balance)
    high = high if apart else max(high, left.total, right.total)
    slope_low = min(start * low, start * high, stop * low, stop * high) + rise * right.lead
    slope_high = max(start * low, start * high, stop * low, stop * high) + rise * left.lead
    if slope_low > 0 or slope_high < 0:
        return 0
    # how far the logarithm of the force rises from either end
    length = (stop - start) / (smallest * least)
    if left.force * math.exp(length * slope_high) <= highest:
        return 0
    if right.force * math.exp(-length * slope_low) <= highest:
        return 0
    bend = right.falling + left.rising if exponent > 1 else left.falling + right.rising
    return 1 if high < rise * smallest * exponent * bend else 2  # 1: the slope only falls


@part
def _summit(
    row: int,
    left: Any,
    right: Any,
    exponent: float,
    number: int,
    cosines: FloatArray,
    sines: FloatArray,
    places: Records,
) -> float:
    """Force where the slope falls through 0: a secant, Newton's method, bisection behind."""
    first, last = left.tangent, right.tangent
    start, stop = first, last
    place = start + left.slope / (left.slope - right.slope) * (stop - start)
    here = places[row]
    for _ in range(100):
        _look(row, place, exponent, number, cosines, sines, places)
        if here.slope == 0 and here.change <= 0:
            break
        if here.slope > 0:
            start = place
        else:
            stop = place
        following = place - here.slope / here.change if here.change < 0 else start
        if not start < following < stop:
            following = (start + stop) / 2
        step = abs(following - place)
        place = following
        if step <= RESOLUTION * min(place - first, last - place):  # each step squares the error
            break
    return _look(row, place, exponent, number, cosines, sines, places)


@part
def power_candidates(
    pins: int,
    count: int,
    exponent: float,
    phases: Records,
    relative: ComplexArray,
    roots: ComplexArray,
    segments: Records,
    candidates: Records,
    cosines: FloatArray,
    sines: FloatArray,
    places: Records,
) -> tuple[int, int]:
    """Number of the candidates for any exponent, ends of segments and summits; of the looks."""
    for index in range(count):
        best = enter(pins, index, count, phases, segments)
        segments[index].number = _gather(
            pins, best, phases, relative, roots, cosines[index], sines[index]
        )
    join(count, segments)
    highest = 0.0
    for index in range(count):
        segment, number = segments[index], int(segments[index].number)
        for end in range(2):
            tangent = segment.right if end else segment.left
            row = 2 * index + end
            force = _look(row, tangent, exponent, number, cosines[index], sines[index], places)
            places[row].halvings = 0
            highest = max(highest, force)
            candidates[row].force = force
            candidates[row].tangent = tangent
            candidates[row].segment = index
    used = looks = 2 * count
    left = 2 * count  # the row of where the stretch at hand starts; those after it are to come
    for index in range(count if exponent > 0 else 0):
        segment, number = segments[index], int(segments[index].number)
        places[left], places[left + 1] = places[2 * index], places[2 * index + 1]
        top = left + 1
        while top > left:
            start, stop = places[left], places[top]
            summits = _most_summits(start, stop, exponent, highest)
            if summits:
                width = stop.tangent - start.tangent
                apart = min(start.tangent - segment.left, segment.right - stop.tangent)
                visible = start.slope >= 0 >= stop.slope and start.slope > stop.slope
                alone = visible and (summits == 1 or width <= NARROW * apart)
                if stop.halvings < SPLITS and not alone:
                    stop.halvings += 1
                    tangent = (start.tangent + stop.tangent) / 2
                    top += 1
                    looks += 1
                    force = _look(
                        top, tangent, exponent, number, cosines[index], sines[index], places
                    )
                    places[top].halvings = stop.halvings
                    highest = max(highest, force)
                    continue
                if visible:
                    force = _summit(
                        left, start, stop, exponent, number, cosines[index], sines[index], places
                    )
                    highest = max(highest, force)
                    looks += 1
                    if used < len(candidates) or force > candidates[used - 1].force:
                        used = min(used, len(candidates) - 1)
                        candidates[used].force = force
                        candidates[used].tangent = places[left].tangent
                        candidates[used].segment = index
                        used += 1
            places[left] = places[top]
            top -= 1
    return used, looks


@part
def power_error(
    least: float,
    used: int,
    candidates: Records,
    exponent: float,
    segments: Records,
    cosines: FloatArray,
    sines: FloatArray,
    phase_error: float,
) -> float:
    """Largest relative error of the candidates that are at least so large: at a switching angle
    one and the same peak is known with the pairs that drive before it and with those after it.
    """
    error = 0.0
    for index in range(used):
        if candidates[index].force >= least:
            each = _error(candidates[index], exponent, segments, cosines, sines, phase_error)
            error = max(error, each)
    return error


@part
def _error(
    candidate: Any,
    exponent: float,
    segments: Records,
    cosines: FloatArray,
    sines: FloatArray,
    phase_error: float,
) -> float:
    """Relative error of a force, from that of the phases in turns; as in `core.force_laws`."""
    tangent = candidate.tangent
    best = 1 / math.sqrt(1 + tangent * tangent)
    angle_error = TURN * phase_error
    total = lost = 1.0
    crossed = (1 + angle_error / best) ** exponent * abs(tangent)
    for pair in range(int(segments[candidate.segment].number)):
        cosine, sine = cosines[candidate.segment, pair], sines[candidate.segment, pair]
        ratio = max(cosine - tangent * sine, 0.0)
        power = ratio**exponent
        widened = (ratio + angle_error / best) ** exponent
        if ratio * best <= angle_error:
            widened *= 2
        total += power * ratio
        crossed += widened * abs(sine + tangent * cosine)
        lost += power
    slope = exponent * abs(tangent) + (1 + exponent) * crossed / total
    others = max(total - 1, 0.0) / total
    lost *= (1 + abs(tangent)) / total
    rounding = ROUNDING * (6 + 4 * (1 + exponent) * (others + lost))
    error: float = rounding + angle_error * slope
    return error
