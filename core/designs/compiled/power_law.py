"""Peaks of any law of load sharing, compiled: stretches are halved until a summit stands alone.

What is done for one design in `core.force_laws`, with the bounds of `core.force_bounds`. The force
is continuous over the whole turn, for a pair's share is 0 where it begins to drive.
"""

import math
from typing import Any

from core.contact_force import FloatArray
from core.designs.compiled.compiling import part
from core.designs.compiled.segments import driving, enter, join, remainder
from core.designs.room import TURN, ComplexArray, Records
from core.force_bounds import (
    HALVINGS,
    NARROW,
    RESOLUTION,
    least_total,
    most_summits,
    next_place,
)
from core.results import ROUNDING

_least_total = part(least_total)
_most_summits = part(most_summits)
_next_place = part(next_place)


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
        following = _next_place(here, start, stop)
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
            least = _least_total(start, stop, exponent)
            summits = _most_summits(start, stop, exponent, highest, least)
            if summits:
                width = stop.tangent - start.tangent
                apart = min(start.tangent - segment.left, segment.right - stop.tangent)
                visible = start.slope >= 0 >= stop.slope and start.slope > stop.slope
                alone = visible and (summits == 1 or width <= NARROW * apart)
                if stop.halvings < HALVINGS and not alone:
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
