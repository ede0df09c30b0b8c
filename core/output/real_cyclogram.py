"""Pairs that carry under a torque in the mechanism as made, when, and how many together.

A pair carries where its force is above zero. All forces repeat with the wave, so that one turn of
the wave is solved on a grid. The ends of carrying are found by bisection between the grid's places.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from core.arrays import BoolArray, FloatArray, IntArray
from core.errors import Accuracy
from core.fields import answer
from core.output.contact_force import CountInterval, DrivingPair, numbers_of_pairs
from core.output.mechanism import Mechanism
from core.output.turn import Turn
from core.precision import ROUNDING

SAMPLES = 720
"""Number of places of the grid over a turn of the wave, none of which is a switching angle."""

HALVINGS = 16
"""Number of halvings of the step that holds an end."""


class Ends(NamedTuple):
    """Places where pairs begin and end to carry."""

    wave: FloatArray  # wave angles from crank angle 0, rad, shape (n,)
    pair: IntArray  # index of the pair, disc by disc, shape (n,)
    falls: BoolArray  # True if the pair ends to carry there, shape (n,)
    carries: BoolArray  # True for pairs that carry at the first place, shape (K*N,)


@dataclass(frozen=True, slots=True, kw_only=True)
class RealCyclogram:
    """Pairs that carry under a torque over a range of crank angles."""

    period: float = answer("deg")
    """Crank angle after which the same pairs carry again."""
    # All pairs, disc by disc, and the crank angles from and to which each carries, rad, cut at the
    # ends of the range.
    pairs: tuple[DrivingPair, ...]
    # Number of pairs that carry over the range, neighbours with the same number joined.
    loaded_count: tuple[CountInterval, ...]
    min_loaded: int  # least number of pairs over the range
    max_loaded: int  # largest number
    step: float = answer("deg")
    """Step of the search in crank angle; shorter ranges may be missed."""
    accuracy: Accuracy = answer()  # error of the ends over the period


def real_cyclogram(*, turn: Turn, revolutions: float = 1.0) -> RealCyclogram:
    """Cyclogram of the pairs that carry, over a number of crank revolutions from the crank angle 0.

    The torque of `turn` is the load without application factor K_A or dynamic factor.
    ImpossibleMechanism is raised as by `Stage.solved`.
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
    counts = numbers_of_pairs(pairs, end=shown, error=error)
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
    """Places over a turn of the wave where pairs begin and end to carry, by a grid."""
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
    """Crank angles, rad, shape (M,), and forces there, N, shape (K*N, M), over a cyclogram's range.

    The angles are evenly spaced `samples`, the given `places`, and both sides of every end of
    carrying, so that the curves show the ends faithfully. ImpossibleMechanism is raised as by
    `Stage.solved`.
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
    """Crank angles between which a pair carries, cut to the range.

    `ends` are wave angles of one turn at which the pair begins or ends (`falls`) to carry.
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
