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
from core.designs.compiling import part
from core.designs.room import SPLITS, TURN, ComplexArray, Records
from core.designs.segments import driving, enter, join, remainder
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
    shares: FloatArray,
    leads: FloatArray,
    bends: FloatArray,
) -> float:
    """Force at a place; all that is known there is filled in."""
    total, lead = 1.0, 0.0
    for pair in range(number):
        ratio = max(cosines[pair] - tangent * sines[pair], 0.0)
        power = ratio**exponent
        shares[row, pair], leads[row, pair] = power * ratio, power * sines[pair]
        bends[row, pair] = power / ratio * sines[pair] * sines[pair] if ratio > 0 else 0.0
        total += power * ratio
        lead += power * sines[pair]
    stretch = 1 + tangent * tangent
    place = places[row]
    place.tangent = tangent
    place.force = math.sqrt(stretch) / total
    place.slope = tangent * total + (1 + exponent) * stretch * lead
    place.halvings = 0
    force: float = place.force
    return force


@part
def _move(
    row: int,
    to: int,
    number: int,
    places: Records,
    shares: FloatArray,
    leads: FloatArray,
    bends: FloatArray,
) -> None:
    places[to].tangent, places[to].force = places[row].tangent, places[row].force
    places[to].slope, places[to].halvings = places[row].slope, places[row].halvings
    for pair in range(number):
        shares[to, pair], leads[to, pair] = shares[row, pair], leads[row, pair]
        bends[to, pair] = bends[row, pair]


@part
def _most_summits(
    left: int,
    right: int,
    exponent: float,
    highest: float,
    number: int,
    places: Records,
    shares: FloatArray,
    leads: FloatArray,
    bends: FloatArray,
) -> int:
    """Most summits above the highest found that a stretch may have: 0, 1, or 2 for any number.

    Every sum is between the sums of the smaller and of the larger of its terms at the ends, and
    so are force and slope. If the slope falls all along it, there is one summit.
    """
    least = most = 1.0
    lead_low = lead_high = bend = 0.0
    for pair in range(number):
        least += min(shares[left, pair], shares[right, pair])
        most += max(shares[left, pair], shares[right, pair])
        lead_low += min(leads[left, pair], leads[right, pair])
        lead_high += max(leads[left, pair], leads[right, pair])
        bend += min(bends[left, pair], bends[right, pair])
    start, stop = places[left].tangent, places[right].tangent
    largest = 1 + max(start * start, stop * stop)
    smallest = 1 + min(start * start, stop * stop) if start * stop > 0 else 1.0
    slope_low = start * (most if start < 0 else least)
    slope_low += (1 + exponent) * lead_low * (largest if lead_low < 0 else smallest)
    slope_high = stop * (least if stop < 0 else most)
    slope_high += (1 + exponent) * lead_high * (largest if lead_high > 0 else smallest)
    if math.sqrt(largest) <= highest * least or slope_low > 0 or slope_high < 0:
        return 0
    # how far the logarithm of the force rises from either end
    length = (stop - start) / (smallest * least)
    if places[left].force * math.exp(length * slope_high) <= highest:
        return 0
    if places[right].force * math.exp(-length * slope_low) <= highest:
        return 0
    lead = max(start * lead_low, start * lead_high, stop * lead_low, stop * lead_high)
    return 1 if most + (1 + exponent) * (lead - exponent * smallest * bend) < 0 else 2


@part
def _slope(
    tangent: float, exponent: float, number: int, cosines: FloatArray, sines: FloatArray
) -> tuple[float, float]:
    """Quantity with the sign of the slope of the force, and its derivative."""
    total, lead, bend = 1.0, 0.0, 0.0
    for pair in range(number):
        ratio = max(cosines[pair] - tangent * sines[pair], 0.0)
        if ratio > 0:
            power = ratio**exponent
            total += power * ratio
            lead += power * sines[pair]
            bend -= exponent * power / ratio * sines[pair] * sines[pair]
    stretch = 1 + tangent * tangent
    slope = tangent * total + (1 + exponent) * stretch * lead
    return slope, total + (1 + exponent) * (tangent * lead + stretch * bend)


@part
def _summit(
    left: Any, right: Any, exponent: float, number: int, cosines: FloatArray, sines: FloatArray
) -> float:
    """Tangent where the slope falls through 0: a secant, Newton's method, bisection behind."""
    start, stop = left.tangent, right.tangent
    place: float = start + left.slope / (left.slope - right.slope) * (stop - start)
    for _ in range(100):
        value, change = _slope(place, exponent, number, cosines, sines)
        if value == 0 and change <= 0:
            break
        if value > 0:
            start = place
        else:
            stop = place
        following = place - value / change if change < 0 else start
        if not start < following < stop:
            following = (start + stop) / 2
        step = abs(following - place)
        place = following
        apart = min(place - left.tangent, right.tangent - place)
        if step <= RESOLUTION * apart:  # each step squares the error
            break
    return place


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
    shares: FloatArray,
    leads: FloatArray,
    bends: FloatArray,
) -> tuple[int, int]:
    """Number of the candidates for any exponent, starts of segments and summits; of the looks."""
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
            force = _look(
                2 * index + end, tangent, exponent, number, cosines[index], sines[index],
                places, shares, leads, bends,
            )  # fmt: skip
            highest = max(highest, force)
        candidates[index].force = places[2 * index].force
        candidates[index].tangent = segment.left
        candidates[index].segment = index
    used, looks = count, 2 * count
    left = 2 * count  # the row of where the stretch at hand starts; those after it are to come
    for index in range(count if exponent > 0 else 0):
        segment, number = segments[index], int(segments[index].number)
        _move(2 * index, left, number, places, shares, leads, bends)
        _move(2 * index + 1, left + 1, number, places, shares, leads, bends)
        top = left + 1
        while top > left:
            start, stop = places[left], places[top]
            summits = _most_summits(
                left, top, exponent, highest, number, places, shares, leads, bends
            )
            if summits:
                visible = start.slope >= 0 >= stop.slope and start.slope > stop.slope
                apart = min(start.tangent - segment.left, segment.right - stop.tangent)
                narrow = stop.tangent - start.tangent <= NARROW * apart
                alone = visible and (summits == 1 or narrow)
                if stop.halvings < SPLITS and not alone:
                    stop.halvings += 1
                    force = _look(
                        top + 1, (start.tangent + stop.tangent) / 2, exponent, number,
                        cosines[index], sines[index], places, shares, leads, bends,
                    )  # fmt: skip
                    highest = max(highest, force)
                    places[top + 1].halvings = stop.halvings
                    top += 1
                    looks += 1
                    continue
                if visible:
                    tangent = _summit(start, stop, exponent, number, cosines[index], sines[index])
                    force = _look(
                        left, tangent, exponent, number, cosines[index], sines[index],
                        places, shares, leads, bends,
                    )  # fmt: skip
                    highest = max(highest, force)
                    looks += 1
                    if used < len(candidates) or force > candidates[used - 1].force:
                        used = min(used, len(candidates) - 1)
                        candidates[used].force = force
                        candidates[used].tangent = tangent
                        candidates[used].segment = index
                        used += 1
            _move(top, left, number, places, shares, leads, bends)
            top -= 1
    return used, looks


@part
def power_error(
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
