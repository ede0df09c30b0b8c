"""The cyclogram of the pin/hole pairs of a crank-planetary reducer: which drive, when, how many.

A pair drives through exactly half of each turn of the wave angle, at known angles (see
`core.mechanism`): the cyclogram is closed form, without sampling or search.
"""

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import NamedTuple

from core.errors import InvalidInput
from core.mechanism import SAME_PHASE, Mechanism, WavePhases
from core.results import ROUNDING, Accuracy

MAX_DRIVING_PHASES = 40_000
"""Most driving phases (pairs times wave turns) that one cyclogram lists."""


class DrivingPair(NamedTuple):
    """When one pair drives.

    Attributes
    ----------
    satellite, pin : int
        Numbers of the pair, from 1.
    driving : tuple of (float, float)
        Crank angles from and to which the pair drives, rad, cut at the ends of the range.
    """

    satellite: int
    pin: int
    driving: tuple[tuple[float, float], ...]


class CountInterval(NamedTuple):
    """A range of crank angle with one number of driving pairs.

    Attributes
    ----------
    start, end : float
        Crank angles, rad.
    pairs : int
        Number of driving pairs.
    """

    start: float
    end: float
    pairs: int


@dataclass(frozen=True, slots=True)
class Cyclogram:
    """Which pairs drive, when, and how many together.

    Attributes
    ----------
    working_phase : float
        Crank angle through which a pair drives without a break, rad.
    period : float
        Crank angle after which each pair drives again, rad: twice the working phase.
    pattern_period : float
        Crank angle after which the whole pattern repeats with other pairs, rad.
    pairs : tuple of DrivingPair
        All pairs, satellite by satellite.
    driving_count : tuple of CountInterval
        Number of driving pairs over the range, neighbours with the same number joined.
    min_driving, max_driving : int
        Smallest and largest number of driving pairs, over the whole pattern.
    mean_driving : float
        Mean over the whole pattern: half of all pairs, always.
    dead_centres : tuple of float
        Crank angles in the range at which no pair drives, rad; both ends of each dead zone.
    dead_zones : tuple of (float, float)
        Ranges in which no pair drives, rad; those of no width are in `dead_centres` only.
    accuracy : Accuracy
        Of the angles, relative to the range shown.
    """

    working_phase: float
    period: float
    pattern_period: float
    pairs: tuple[DrivingPair, ...]
    driving_count: tuple[CountInterval, ...]
    min_driving: int
    max_driving: int
    mean_driving: float
    dead_centres: tuple[float, ...]
    dead_zones: tuple[tuple[float, float], ...]
    accuracy: Accuracy


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
        raise InvalidInput("revolutions", revolutions, "must be a positive number")
    phases = mechanism.phases
    per_wave = mechanism.crank_angle_per_wave
    waves = revolutions * 2 * math.pi / per_wave
    if waves <= SAME_PHASE:
        raise InvalidInput("revolutions", revolutions, "must be larger: no phase is that short")
    pair_count = mechanism.pins * mechanism.satellites
    if waves * pair_count > MAX_DRIVING_PHASES:
        raise InvalidInput(
            "revolutions",
            revolutions,
            f"must be smaller: {{revolutions}} * (1 + 1/{{ratio}}) * {{pins}} * {{satellites}} "
            f"must stay below {MAX_DRIVING_PHASES} driving phases",
        )
    end = revolutions * 2 * math.pi

    def crank_angle(position: float) -> float:
        return end if position >= waves else position * per_wave

    sector_counts = list(_sector_counts(phases))
    zones = list(_repeated_zones(phases.dead_zones(), waves))
    return Cyclogram(
        working_phase=per_wave / 2,
        period=per_wave,
        pattern_period=per_wave / (mechanism.pins * phases.symmetry),
        pairs=tuple(_pairs(mechanism, waves, crank_angle)),
        driving_count=tuple(
            CountInterval(crank_angle(start), crank_angle(stop), pairs)
            for start, stop, pairs in _counts(sector_counts, 1 / mechanism.pins, waves)
        ),
        min_driving=min(pairs for _, _, pairs in sector_counts),
        max_driving=max(pairs for _, _, pairs in sector_counts),
        mean_driving=pair_count / 2,
        dead_centres=tuple(sorted({crank_angle(place) for zone in zones for place in zone})),
        dead_zones=tuple(
            (crank_angle(start), crank_angle(stop)) for start, stop in zones if stop > start
        ),
        accuracy=Accuracy(
            method="closed form",
            relative_error=4 * ROUNDING * (1.0 if waves >= 1 else 1 / waves)
            + (phases.snapped + _dropped(sector_counts, 1 / mechanism.pins, waves)) / waves,
            evaluations=pair_count,
        ),
    )


def _pairs(
    mechanism: Mechanism, end: float, crank_angle: Callable[[float], float]
) -> Iterator[DrivingPair]:
    """All pairs with their driving phases over [0, end] of the wave; no slivers of rounding."""
    sliver = SAME_PHASE * max(1.0, end)
    for j, phase in enumerate(mechanism.phases.satellite_phase):
        for n in range(mechanism.pins):
            start = (0.5 - phase - n / mechanism.pins) % 1.0
            stop = start + 0.5
            driving = []
            for turn in range(-1 if stop > 1 else 0, math.ceil(end - start)):
                first = start + turn if turn >= 0 else 0.0
                last = stop + turn if stop + turn < end else end
                if last - first > sliver:
                    driving.append((crank_angle(first), crank_angle(last)))
            yield DrivingPair(j + 1, n + 1, tuple(driving))


def _repeated_zones(
    zones: Sequence[tuple[float, float]], end: float
) -> Iterator[tuple[float, float]]:
    """Dead zones of one turn, repeated and cut to [0, end]; slivers of rounding dropped."""
    sliver = SAME_PHASE * max(1.0, end)
    for turn in range(-1, math.ceil(end) + 1):
        for start, stop in zones:
            first, last = max(start + turn, 0.0), min(stop + turn, end)
            if last - first > sliver or (start == stop and first == last):
                yield first, last


def _dropped(sector_counts: Sequence[tuple[float, float, int]], sector: float, end: float) -> float:
    """Width of what is dropped as a sliver at the ends of [0, end], in turns."""
    sliver = SAME_PHASE * max(1.0, end)
    widths = (
        min(width, sector - width)
        for position, _, _ in sector_counts
        for width in (position % sector, (end - position) % sector)
    )
    return max((width for width in widths if width <= sliver), default=0.0)


def _sector_counts(phases: WavePhases) -> Iterator[tuple[float, float, int]]:
    """Number of driving pairs between the switching angles of one sector, in turns."""
    sector = 1 / phases.pins
    positions = phases.switching()
    for start, stop in zip(positions, [*positions[1:], positions[0] + sector], strict=True):
        yield start, stop, phases.driving_at((start + stop) / 2)


def _counts(
    sector_counts: Sequence[tuple[float, float, int]], sector: float, end: float
) -> Iterator[tuple[float, float, int]]:
    """Counts over [0, end], neighbours with the same count joined."""
    sliver = SAME_PHASE * max(1.0, end)
    begun, reached, count = 0.0, 0.0, -1  # of the interval that grows
    for turn in range(-1, math.ceil(end / sector) + 1):
        for start, stop, pairs in sector_counts:
            first, last = start + turn * sector, stop + turn * sector
            if (last if last < end else end) - (first if first > 0 else 0.0) <= sliver:
                continue
            if pairs != count:
                if count >= 0:
                    yield begun, reached, count
                begun, count = reached, pairs
            reached = last
    if count >= 0:
        yield begun, end, count
