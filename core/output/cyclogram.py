"""The cyclogram of the pin/hole pairs of a crank-planetary reducer: which drive, when, how many.

A pair drives through exactly half of each turn of the wave angle, at known angles (see
`core.output.mechanism`): the cyclogram is closed form, without sampling or search.
"""

import itertools
import math
import operator
from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

from core.errors import InvalidInput
from core.output.mechanism import Mechanism, WavePhases
from core.precision import ROUNDING, SAME
from core.results import Accuracy, Notice, poorly_known

MAX_DRIVING_PHASES = 40_000
"""Most driving phases (pairs times wave turns) that one cyclogram lists."""


class DrivingPair(NamedTuple):
    """When one pair drives."""

    satellite: int  # from 1
    pin: int  # from 1
    # Crank angles from and to which the pair drives, rad, cut at the ends of the range.
    driving: tuple[tuple[float, float], ...]


class CountInterval(NamedTuple):
    """A range of crank angle with one number of driving pairs."""

    start: float  # crank angle, rad
    end: float  # crank angle, rad
    pairs: int  # how many drive


@dataclass(frozen=True, slots=True)
class Cyclogram:
    """Which pairs drive, when, and how many together."""

    working_phase: float  # crank angle through which a pair drives without a break, rad
    period: float  # crank angle after which each pair drives again, rad: twice that
    pattern_period: float  # crank angle after which all repeats with other pairs, rad
    pairs: tuple[DrivingPair, ...]  # all, satellite by satellite
    # Number of driving pairs over the range, neighbours with the same number joined.
    driving_count: tuple[CountInterval, ...]
    min_driving: int  # least number of pairs, over the whole pattern
    max_driving: int  # largest number
    mean_driving: float  # over the whole pattern: half of all pairs, always
    dead_centres: tuple[float, ...]  # crank angles in the range, rad; both ends of each dead zone
    # Ranges in which no pair drives, rad; those of no width are in `dead_centres` only.
    dead_zones: tuple[tuple[float, float], ...]
    accuracy: Accuracy  # of angles and of the total through which a pair drives, over the range

    @property
    def notices(self) -> tuple[Notice, ...]:
        """That hardly anything is known, of a range hardly longer than rounding."""
        return poorly_known(self.accuracy)


def cyclogram(*, mechanism: Mechanism, revolutions: float = 1.0) -> Cyclogram:
    """Cyclogram of the pin/hole pairs over a number of crank revolutions, in closed form.

    A pair of phase ``theta`` drives while ``psi + theta`` lies between pi and 2*pi, that is
    through a crank angle of ``pi/(1 + 1/u)`` once in each ``2*pi/(1 + 1/u)``.

    Parameters
    ----------
    mechanism : Mechanism
        Pins, satellites, ratio.
    revolutions : float
        Length of the range, in turns of the crank from 0, > 0. The first and the last driving
        phase are cut at its ends.

    Returns
    -------
    Cyclogram

    Raises
    ------
    InvalidInput
        If `revolutions` is not positive, so small that all is a sliver of rounding, or so large
        that the range holds more than `MAX_DRIVING_PHASES`.

    Notes
    -----
    Source: Yanchevskiy and Niekhoroshykh 2021, eq. (6); Yanchevsky et al. 2018, eq. (1), is the
    same with ``initial_crank_angle = pi``.

    Examples
    --------
    Three pins, two satellites at 120 degrees, u = 20 (2021, fig. 6 b): 2 or 4 pairs drive.

    >>> m = Mechanism.evenly_spaced(pins=3, satellites=2, ratio=20.0, crank_spacing=2*math.pi/3)
    >>> c = cyclogram(mechanism=m)
    >>> c.min_driving, c.max_driving, round(math.degrees(c.working_phase), 6)
    (2, 4, 171.428571)
    """
    if not (0 < revolutions < math.inf):
        raise InvalidInput("revolutions", revolutions, "greater_than", limit=0)
    phases = mechanism.phases
    per_wave = mechanism.crank_angle_per_wave
    shown = _Range(revolutions * 2 * math.pi, per_wave)
    if shown.waves <= SAME:
        shortest = SAME * per_wave / (2 * math.pi)
        raise InvalidInput("revolutions", revolutions, "too_short_range", limit=shortest)
    pair_count = mechanism.pins * mechanism.satellites
    if shown.waves * pair_count > MAX_DRIVING_PHASES:
        raise InvalidInput("revolutions", revolutions, "too_many_phases", limit=MAX_DRIVING_PHASES)
    sector_counts = _sector_counts(phases)
    numbers = [pairs for _, pairs in sector_counts]
    counts, dropped = _counts(sector_counts, 1 / mechanism.pins, shown)
    pairs, cut_off = _pairs(phases, shown)
    dead_centres, dead_zones = _dead(phases.dead_zones(), shown)
    return Cyclogram(
        working_phase=per_wave / 2,
        period=per_wave,
        pattern_period=per_wave / (mechanism.pins * phases.symmetry),
        pairs=pairs,
        driving_count=counts,
        min_driving=min(numbers),
        max_driving=max(numbers),
        mean_driving=pair_count / 2,
        dead_centres=dead_centres,
        dead_zones=dead_zones,
        accuracy=Accuracy(
            method="closed_form",
            # the total of a pair has the ends of all its driving phases
            relative_error=ROUNDING * (4 * max(1.0, 1 / shown.waves) + shown.waves)
            + (phases.error + max(dropped, cut_off)) / shown.waves,
            evaluations=pair_count,
        ),
    )


class _Range:
    """The range [0, end] of the crank angle, which positions on the wave, in turns, are cut to."""

    __slots__ = ("end", "per_wave", "sliver", "waves")

    def __init__(self, end: float, per_wave: float) -> None:
        self.end = end
        self.per_wave = per_wave
        self.waves = end / per_wave
        self.sliver = SAME * max(1.0, self.waves)  # of rounding, not shown

    def crank_angle(self, position: float) -> float:
        """Crank angle of a wave position, rad."""
        return position * self.per_wave if position < self.waves else self.end


def _pairs(phases: WavePhases, shown: _Range) -> tuple[tuple[DrivingPair, ...], float]:
    """All pairs with their driving phases; and the width of the largest sliver of a phase dropped
    at an end of the range, in turns.
    """
    pins, waves, per_wave, sliver = phases.pins, shown.waves, shown.per_wave, shown.sliver
    pairs, dropped = [], 0.0
    for j, phase in enumerate(phases.satellite_phase, 1):
        for n in range(pins):
            start = (0.5 - phase - n / pins) % 1.0
            driving = []
            if start - 0.5 > sliver:  # begun before the range
                driving.append((0.0, shown.crank_angle(start - 0.5)))
            elif start > 0.5:
                dropped = max(dropped, start - 0.5)
            whole = math.ceil(waves - sliver - start)
            if whole < waves - start:
                dropped = max(dropped, waves - start - whole)
            for turn in range(whole):
                first = start + turn
                last = first + 0.5
                driving.append((first * per_wave, last * per_wave if last < waves else shown.end))
            pairs.append(DrivingPair(j, n + 1, tuple(driving)))
    return tuple(pairs), dropped


def _dead(
    zones: Sequence[tuple[float, float]], shown: _Range
) -> tuple[tuple[float, ...], tuple[tuple[float, float], ...]]:
    """Dead centres and dead zones of one turn, repeated and cut to the range, rad; slivers of
    rounding dropped.
    """
    if not zones:
        return (), ()
    cut = []
    for turn in range(-1, math.ceil(shown.waves) + 1):
        for start, stop in zones:
            first, last = max(start + turn, 0.0), min(stop + turn, shown.waves)
            if last - first > shown.sliver or (start == stop and first == last):
                cut.append((shown.crank_angle(first), shown.crank_angle(last)))
    centres = sorted({place for zone in cut for place in zone})
    return tuple(centres), tuple([(start, stop) for start, stop in cut if stop > start])


def _sector_counts(phases: WavePhases) -> list[tuple[float, int]]:
    """Where each number of driving pairs ends, in turns, over one sector from its first change on;
    and the number.
    """
    pins, mean = phases.pins, phases.pins * len(phases.satellite_phase) / 2
    changes = [(position, growth) for position, growth in phases.switching() if growth]
    if not changes:
        return [(1 / pins, int(mean))]
    starts, growths = zip(*changes, strict=True)
    stops = (*starts[1:], starts[0] + 1 / pins)
    # The number before the first change is the one with which the mean is half of all pairs.
    first = round(mean + pins * sum(map(operator.mul, growths, starts)))
    numbers = itertools.accumulate(growths, initial=first)
    return list(zip(stops, itertools.islice(numbers, 1, None), strict=True))


def _counts(
    sector_counts: Sequence[tuple[float, int]], sector: float, shown: _Range
) -> tuple[tuple[CountInterval, ...], float]:
    """Counts over the range, neighbours with the same count joined; and the width of the largest
    sliver dropped, in turns.
    """
    if len(sector_counts) == 1:
        return (CountInterval(0.0, shown.end, sector_counts[0][1]),), 0.0
    waves, sliver = shown.waves, shown.sliver
    joined: list[CountInterval] = []
    begun, reached, count, dropped = 0.0, 0.0, -1, 0.0  # of the interval that grows
    for turn in range(-1, math.ceil(waves / sector) + 1):
        for stop, pairs in sector_counts:
            last = stop + turn * sector
            width = (last if last < waves else waves) - reached
            if width <= sliver:
                dropped = max(dropped, width)
                continue
            if pairs != count:
                if count >= 0:
                    joined.append(CountInterval(begun, shown.crank_angle(reached), count))
                    begun = joined[-1].end
                count = pairs
            reached = last
    return (*joined, CountInterval(begun, shown.end, count)), dropped
