"""Phases and segments of one design, compiled.

The segments of the turn are those of `core.driving_set`, here over one sector of the wave with all
satellites apart.
"""

import math

import numpy as np

from core.contact_force import FloatArray, IntArray
from core.designs.compiled.compiling import part
from core.designs.room import TURN, ComplexArray, Records
from core.mechanism import SAME_PHASE, far_angle_error
from core.results import ROUNDING

_far_angle_error = part(far_angle_error)

SLIVER = 4 * ROUNDING
"""Width below which a segment is nothing but rounding, in turns."""


@part
def _turns(angle: float) -> float:
    turns: float = (angle if abs(angle) < TURN else np.fmod(angle, TURN)) / TURN
    return turns


@part
def remainder(number: float, divisor: float) -> float:
    """Remainder of whole numbers, at least 0."""
    remainder: float = number - divisor * np.floor(number / divisor)
    return remainder


@part
def _within_sector(pins: int, position: float) -> float:
    within: float = max(position - np.floor(position * pins) / pins, 0.0)
    return within


@part
def position(pins: int, position: float) -> float:
    """Wave position within a sector, turns; a rounding error beside its ends is 0."""
    within = _within_sector(pins, position)
    return within if SAME_PHASE < within < 1 / pins - SAME_PHASE else 0.0


@part
def locate_phases(
    pins: int, cranks: FloatArray, initial: float, order: IntArray, phases: Records
) -> float:
    """Phases of a design, and by how much they may be elsewhere, in turns.

    Those that differ by rounding within their cell, an N-th of a turn or half of one, are made
    one; compare `core.mechanism.WavePhases`.
    """
    cells = pins if pins % 2 == 0 else 2 * pins
    shift, furthest = _turns(initial), 0.0
    for k in range(len(cranks)):
        furthest = max(furthest, abs(cranks[k]))
        scaled = (_turns(cranks[k]) + shift) * cells
        cell = np.floor(scaled)
        phases[k].satellite, phases[k].sector = cell, scaled - cell
        rank = k
        while rank > 0 and phases[order[rank - 1]].sector > scaled - cell:
            order[rank] = order[rank - 1]
            rank -= 1
        order[rank] = k
    tolerance = SAME_PHASE * cells
    lowest = phases[order[0]].sector
    representative = lowest
    snapped = 0.0
    for rank in range(1, len(cranks)):
        k = order[rank]
        own = phases[k].sector
        if own > 1 - tolerance and lowest <= tolerance:
            phases[k].satellite += 1
            phases[k].sector = lowest
            snapped = max(snapped, abs(lowest + 1 - own))
        elif own - representative <= tolerance:
            phases[k].sector = representative
            snapped = max(snapped, own - representative)
        else:
            representative = own
    for k in range(len(cranks)):
        cell, residue = phases[k].satellite, phases[k].sector
        phases[k].satellite = (remainder(cell, cells) + residue) / cells
        phases[k].sector = (remainder(cell, cells // pins) + residue) / cells
    return 2 * ROUNDING + snapped / cells + _far_angle_error(abs(initial) + furthest)


@part
def best_pair(pins: int, place: float, phases: Records) -> tuple[int, int]:
    """Numbers of the best placed pair at a wave position, of equals the first."""
    best = chosen = 0
    least = np.inf
    for k in range(len(phases)):
        off = (0.75 - place - phases[k].satellite) * pins
        # Midway between two pins the first of them is the one to name.
        pin = math.ceil(off - 0.5 - SAME_PHASE * pins)
        distance = np.rint(abs(off - pin) / pins * 1e12)
        if distance < least:
            least, best, chosen = distance, k, pin
    return best + 1, chosen % pins + 1


@part
def relate(phases: Records, relative: ComplexArray) -> None:
    """Fill in the sector phases of the satellites against each other, as directions."""
    for k in range(len(phases)):
        relative[k, k] = 1.0
        for other in range(k):
            angle = TURN * (phases[other].sector - phases[k].sector)
            relative[k, other] = complex(math.cos(angle), math.sin(angle))
            relative[other, k] = relative[k, other].conjugate()


@part
def locate_segments(pins: int, phases: Records, segments: Records) -> int:
    """Number of the segments of a design; where they start is filled in, ascending.

    Those that are nothing but rounding are left out: no pairs could be told to drive there.
    """
    for k in range(len(phases)):
        rank = k
        while rank > 0 and phases[rank - 1].ordered > phases[k].sector:
            phases[rank].ordered = phases[rank - 1].ordered
            rank -= 1
        phases[rank].ordered = phases[k].sector
    count = 0
    for k in range(len(phases)):
        own = phases[k].ordered
        after = phases[k + 1].ordered if k + 1 < len(phases) else phases[0].ordered + 1 / pins
        for kind in range(3 if pins % 2 else 2):
            # another pair becomes the best placed, or a pair starts or stops driving
            start = 0.75 - (own + after) / 2 if kind == 0 else (1.0 if kind == 1 else 0.5) - own
            start = _within_sector(pins, start)
            rank = count
            while rank > 0 and segments[rank - 1].start > start:
                segments[rank].start = segments[rank - 1].start
                rank -= 1
            segments[rank].start = start
            count += 1
    kept = 1
    for index in range(1, count):
        if segments[index].start - segments[kept - 1].start > SLIVER:
            segments[kept].start = segments[index].start
            kept += 1
    if kept > 1 and segments[0].start + 1 / pins - segments[kept - 1].start <= SLIVER:
        kept -= 1
    return kept


@part
def enter(pins: int, index: int, count: int, phases: Records, segments: Records) -> int:
    """The best placed satellite of a segment; its range and the nearest pins are filled in."""
    segment = segments[index]
    stop = segments[index + 1].start if index + 1 < count else segments[0].start + 1 / pins
    half = (stop - segment.start) / 2
    best = 0
    for k in range(len(phases)):
        off = segment.start + half + (phases[k].sector - 0.75)
        phases[k].step = np.rint(off * pins)
        phases[k].nearest = off - phases[k].step / pins
        if abs(phases[k].nearest) < abs(phases[best].nearest):
            best = k
    low = phases[best].nearest - half
    segment.origin = segment.start - low
    segment.left = math.tan(TURN * low)
    segment.right = low + 2 * half  # its sign is that of the tangent, see join
    return best


@part
def join(count: int, segments: Records) -> None:
    """Fill in the tangents at the ends of segments, known but for their sign.

    At a switching angle the best placed pairs of both sides are equally far from the best place.
    """
    for index in range(count):
        following = segments[index + 1 if index + 1 < count else 0].left
        segments[index].right = math.copysign(following, segments[index].right)


@part
def driving(pins: int, nearest: float) -> tuple[float, float]:
    """First and last driving pin of a satellite, counted from its nearest to the best place."""
    return np.floor(pins * (-0.25 - nearest)) + 1, np.ceil(pins * (0.25 - nearest)) - 1
