"""Which pairs really carry, when, how many together: the mechanism as it is made, under a torque.

A pair carries where its force is above zero. All forces repeat with the wave, so that one turn of
it is solved: on a grid, between whose places the ends are halved down.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from core.arrays import BoolArray, FloatArray, IntArray
from core.errors import Accuracy
from core.output.contact_force import CountInterval, DrivingPair
from core.output.mechanism import Mechanism
from core.output.turn import Turn
from core.precision import ROUNDING

SAMPLES = 720
"""Places of the grid over a turn of the wave, none of which is a switching angle."""

HALVINGS = 16
"""How often the step that holds an end is halved."""


class Ends(NamedTuple):
    """Where pairs begin and end to carry."""

    wave: FloatArray  # wave angles from crank angle 0, rad, shape (n,)
    pair: IntArray  # which pair, satellite by satellite, shape (n,)
    falls: BoolArray  # whether it ends there, shape (n,)
    carries: BoolArray  # which pairs carry at the first place, shape (K*N,)


@dataclass(frozen=True, slots=True)
class RealCyclogram:
    """Which pairs carry under a torque."""

    period: float  # crank angle after which each pair carries again, rad
    # All pairs, satellite by satellite, and the crank angles from and to which each carries, rad,
    # cut at the ends of the range.
    pairs: tuple[DrivingPair, ...]
    # Number of pairs that carry over the range, neighbours with the same number joined.
    loaded_count: tuple[CountInterval, ...]
    min_loaded: int  # least number of pairs over the range
    max_loaded: int  # largest number
    step: float  # of the grid, crank angle, rad: what is shorter may not be found
    accuracy: Accuracy  # of the ends, over the period


def real_cyclogram(*, turn: Turn, revolutions: float = 1.0) -> RealCyclogram:
    """Cyclogram of the pairs that carry, over a number of crank revolutions.

    Parameters
    ----------
    turn : Turn
        The mechanism as it is made under its torque.
    revolutions : float
        Length of the range, in turns of the crank from 0, > 0.

    Returns
    -------
    RealCyclogram

    Raises
    ------
    ImpossibleMechanism
        See `core.output.real_mechanism.RealMechanism.solved`.

    Notes
    -----
    The torque is that of the load without its dynamic factor. The equilibrium at each place is that
    of `core.output.loaded_position`; a force is zero where its pair has not closed its gap.
    """
    mechanism, solved = turn.real.mechanism, turn.evaluations
    step = 2 * math.pi / SAMPLES
    ends, pair, falls, carries = _ends(turn, step)
    per_wave = mechanism.crank_angle_per_wave
    crank = per_wave / (2 * math.pi)
    error = crank * step / 2.0**HALVINGS + 8 * ROUNDING * per_wave
    shown = revolutions * 2 * math.pi
    pairs = tuple(
        DrivingPair(
            index // mechanism.pins + 1,
            index % mechanism.pins + 1,
            _intervals(ends[pair == index], falls[pair == index], bool(carries[index]),
                       mechanism, shown, turn.waves),
        )
        for index in range(len(carries))
    )  # fmt: skip
    counts = _counts(pairs, shown, error)
    numbers = [each.pairs for each in counts]
    return RealCyclogram(
        period=per_wave * turn.waves,
        pairs=pairs,
        loaded_count=counts,
        min_loaded=min(numbers),
        max_loaded=max(numbers),
        step=crank * step,
        accuracy=Accuracy("bisection", error / per_wave, turn.evaluations - solved),
    )


def _ends(turn: Turn, step: float) -> Ends:
    """Where over a turn of the wave pairs begin and end to carry, in a grid of such steps."""
    first = turn.real.mechanism.initial_crank_angle
    places = first + step * (np.arange(SAMPLES * turn.waves) + 1 / math.pi)
    carries = turn.at_waves(places)["forces"] > 0
    place, pair = np.nonzero(carries != np.roll(carries, -1, axis=0))
    low, high, falls = places[place], places[place] + step, carries[place, pair]
    for _ in range(HALVINGS if len(place) else 0):
        middle = (low + high) / 2
        same = (turn.at_waves(middle)["forces"][np.arange(len(pair)), pair] > 0) == falls
        low, high = np.where(same, middle, low), np.where(same, high, middle)
    return Ends((low + high) / 2 - first, pair, falls, carries[0])


def carried_forces(
    *, turn: Turn, carried: RealCyclogram, places: Sequence[float] = (), samples: int = 361
) -> tuple[FloatArray, FloatArray]:
    """Forces over the range of a cyclogram, at crank angles that show them faithfully.

    Parameters
    ----------
    turn : Turn
        The mechanism as it is made under its torque.
    carried : RealCyclogram
        Its cyclogram.
    places : sequence of float, optional
        Crank angles that are among them, rad.
    samples : int
        Number of evenly spaced angles; both sides of every end stand between them.

    Returns
    -------
    crank_angle : array, M
        rad, ascending.
    force : array, shape (K*N, M)
        N, satellite by satellite.

    Raises
    ------
    ImpossibleMechanism
        See `core.output.real_mechanism.RealMechanism.solved`.
    """
    end, beside = carried.loaded_count[-1].end, carried.step / 2.0**HALVINGS
    ends = {place for pair in carried.pairs for phase in pair.driving for place in phase}
    sides = [place + side for place in ends for side in (-beside, beside)]
    angles = np.union1d(np.linspace(0.0, end, samples), np.clip([*sides, *places], 0.0, end))
    return angles, turn.poses([turn.real.wave(float(each)) for each in angles])["forces"].T


def _intervals(
    ends: FloatArray,
    falls: np.ndarray,
    always: bool,
    mechanism: Mechanism,
    shown: float,
    waves: int = 1,
) -> tuple[tuple[float, float], ...]:
    """Crank angles between which a pair carries, by the wave angles of a turn at which it begins
    and ends (`falls`), cut to the range.
    """
    if len(ends) == 0:
        return ((0.0, shown),) if always else ()
    per_wave, period = mechanism.crank_angle_per_wave, 2 * math.pi * waves
    starts = np.sort(ends[~falls] % period)
    stops = np.sort(ends[falls] % period)
    found = []
    for wave in range(-waves, math.ceil(shown / per_wave) + 1, waves):
        for start in starts:
            after = stops[stops > start]
            stop = after[0] if len(after) else stops[0] + period
            low, high = ((wave + each / (2 * math.pi)) * per_wave for each in (start, stop))
            if min(high, shown) > max(low, 0.0):
                found.append((float(max(low, 0.0)), float(min(high, shown))))
    return tuple(found)


def _counts(
    pairs: tuple[DrivingPair, ...], shown: float, error: float
) -> tuple[CountInterval, ...]:
    """How many pairs carry over the range; ends that cannot be told apart are one."""
    changes = sorted(
        change
        for each in pairs
        for start, stop in each.driving
        for change in ((start, 1), (stop, -1))
    )
    counts: list[CountInterval] = []
    begun, number, index = 0.0, 0, 0
    while index < len(changes):
        place, after = changes[index][0], number
        while index < len(changes) and changes[index][0] <= place + 2 * error:
            after, index = after + changes[index][1], index + 1
        if after == number or place <= 2 * error:
            number = after
            continue
        end = shown if place >= shown - 2 * error else place
        if end > begun:
            counts.append(CountInterval(begun, end, number))
        begun, number = end, after
    if begun < shown:
        counts.append(CountInterval(begun, shown, number))
    return tuple(counts)
