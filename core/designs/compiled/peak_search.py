"""The search for peaks, design by design, compiled."""

import math
from collections.abc import Callable

import numpy as np

from core.contact_force import FloatArray
from core.designs.compiled.compiling import part, sources, whole
from core.designs.compiled.linear_law import even_peak, linear_candidates, linear_error
from core.designs.compiled.power_law import power_candidates, power_error
from core.designs.compiled.segments import (
    best_pair,
    locate_phases,
    locate_segments,
    position,
    relate,
)
from core.designs.room import TURN, Peaks, Records, Room
from core.peak_force import EQUAL


@part
def _highest(candidates: Records, used: int) -> int:
    top = 0
    for index in range(1, used):
        if candidates[index].force > candidates[top].force:
            top = index
    return top


@part
def _first_place(
    pins: int, least: float, used: int, segments: Records, candidates: Records
) -> float:
    """First wave position, in turns, at which a candidate is at least that large."""
    first = np.inf
    for index in range(used):
        candidate = candidates[index]
        if candidate.force >= least:
            moved = math.atan(candidate.tangent) / TURN
            first = min(first, position(pins, segments[candidate.segment].origin + moved))
    return first


def _search(made_of: str) -> Callable[[int, FloatArray, FloatArray, FloatArray, Room, Peaks], None]:
    """The search, made anew when its sources change."""

    @whole
    def find_peaks(
        pins: int,
        crank_angles: FloatArray,
        exponent: FloatArray,
        initial: FloatArray,
        room: Room,
        peaks: Peaks,
    ) -> None:
        """Fill in the peaks of designs.

        Parameters
        ----------
        pins : int
            Number of pins N of all of them, at least 3.
        crank_angles : array, shape (n, K)
            Angles of the cranks, rad.
        exponent : array, shape (n,)
            Exponent v of the force over the approach.
        initial : array, shape (n,)
            Wave angle at crank angle 0, rad.
        room : Room
            Where to work.
        peaks : Peaks
            Where to put them.
        """
        made_of  # noqa: B018
        phases, segments, candidates = room.phases, room.segments, room.candidates
        relative, roots = room.relative, room.roots
        for design in range(len(exponent)):
            power = exponent[design]
            phase_error = locate_phases(
                pins, crank_angles[design], initial[design], room.order, phases
            )
            if power == 1 and pins % 2 == 0:
                ratio, place, error, looks = even_peak(pins, phases)
            else:
                relate(phases, relative)
                count = locate_segments(pins, phases, segments)
                if power == 1:
                    looks = linear_candidates(
                        pins, count, phases, relative, roots, segments, candidates
                    )
                    top = _highest(candidates, looks)
                    error = linear_error(candidates[top], segments, phase_error)
                    ratio, used = candidates[top].force, looks
                else:
                    used, looks = power_candidates(
                        pins, count, power, phases, relative, roots, segments, candidates,
                        room.cosines, room.sines, room.places,
                    )  # fmt: skip
                    top = _highest(candidates, used)
                    ratio = candidates[top].force
                    error = power_error(
                        ratio * (1 - EQUAL), used, candidates, power,
                        segments, room.cosines, room.sines, phase_error,
                    )  # fmt: skip
                least = ratio * (1 - max(EQUAL, error))
                place = _first_place(pins, least, used, segments, candidates)
            satellite, pin = best_pair(pins, place, phases)
            peaks.ratio[design] = ratio
            peaks.place[design] = place
            peaks.error[design] = error
            peaks.evaluations[design] = looks
            peaks.satellite[design] = satellite
            peaks.pin[design] = pin

    return find_peaks


find_peaks = _search(sources())
