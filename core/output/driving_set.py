"""Sets of pairs that drive together, and the segments of the turn over which each set drives.

The driving pins of one satellite are neighbours at any moment, so a sum over driving pairs of a
linear or squared cosine is a few geometric sums, one for each satellite. Angles are in turns and
count from the best placed pair, which has the largest cosine of the pressure angle.
"""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from core.arrays import FloatArray
from core.output.mechanism import WavePhases
from core.precision import ROUNDING


@dataclass(frozen=True, slots=True)
class PinRun:
    """Neighbouring pins that drive, of all satellites with one phase."""

    middle: float  # phase of the run's middle against the best placed pair, in turns
    count: int  # number of pins, at least 1
    weight: int  # number of satellites


@dataclass(frozen=True, slots=True)
class DrivingSet:
    """Pairs that drive over one segment."""

    pins: int  # N: neighbours are an N-th of a turn apart
    runs: tuple[PinRun, ...]  # driving pins, phase by phase

    @property
    def number(self) -> int:
        """Number of driving pairs."""
        return sum(run.count * run.weight for run in self.runs)

    @property
    def summed_in_runs(self) -> int:
        """Number of driving pairs in runs of more than one pin, whose squares cancel in sums."""
        return sum(run.count * run.weight for run in self.runs if run.count > 1)

    def sum_of_cosines(self, offset: float) -> float:
        """Sum of cos(gamma) over the driving pairs; `offset` is the best pair's gamma, in turns."""
        step = math.sin(math.pi / self.pins)
        return sum(
            run.weight
            * cosine(offset + run.middle)
            * (1 if run.count == 1 else math.sin(math.pi * run.count / self.pins) / step)
            for run in self.runs
        )

    def sums_of_squares(self, offset: float) -> tuple[float, float, float]:
        """Sums of cos^2, sin^2 and sin*cos of gamma over the driving pairs; `offset` is the best
        pair's gamma, in turns.
        """
        cosines = sines = products = 0.0
        for run in self.runs:
            turns = offset + run.middle
            if run.count == 1:
                # A single pin keeps its digits where its cosine or sine vanishes.
                c, s = cosine(turns), math.sin(2 * math.pi * turns)
                cosines += run.weight * c * c
                sines += run.weight * s * s
                products += run.weight * s * c
            else:
                angle = 2 * math.pi / self.pins
                spread = run.weight * math.sin(angle * run.count) / math.sin(angle) / 2
                half = run.weight * run.count / 2
                double = spread * math.cos(4 * math.pi * turns)
                cosines += half + double
                sines += half - double
                products += spread * math.sin(4 * math.pi * turns)
        return cosines, sines, products

    def pairs(self) -> tuple[FloatArray, FloatArray]:
        """Phases of the driving pairs against the best placed one, in turns, and their weights."""
        count = np.array([run.count for run in self.runs])
        first = np.array([run.middle for run in self.runs]) - (count - 1) / (2 * self.pins)
        within = np.arange(count.sum()) - np.repeat(np.cumsum(count) - count, count)
        weights = np.repeat([float(run.weight) for run in self.runs], count)
        return np.repeat(first, count) + within / self.pins, weights


@dataclass(frozen=True, slots=True)
class Segment:
    """Part of the turn with one driving set and one best placed pair."""

    phase: float  # phase of the best placed pair, in turns
    low: float  # least pressure angle of that pair, in turns
    high: float  # largest pressure angle of that pair, in turns
    driving: DrivingSet  # pairs that drive over the segment


def segments(phases: WavePhases) -> Iterator[Segment]:
    """Segments over one repeat of the pattern. A segment ends where a pair starts or stops driving,
    or midway between neighbouring phases, where another pair becomes the best placed.
    """
    sector = 1 / phases.pins
    values = phases.sector_phases
    for index in range(len(values) // phases.symmetry):
        phase = values[index]
        below = phase - (values[index - 1] if index else values[-1] - sector)
        above = (values[index + 1] if index + 1 < len(values) else values[0] + sector) - phase
        low, high = -above / 2, below / 2
        for start, stop in pairwise([low, *_switches(phases, phase, low, high), high]):
            yield Segment(phase, start, stop, _driving_set(phases, phase, (start + stop) / 2))


def _switches(phases: WavePhases, phase: float, low: float, high: float) -> list[float]:
    """Offsets from `low` to `high` at which a pair starts or stops driving, ascending, turns."""
    sector = 1 / phases.pins
    apart = 4 * ROUNDING
    found = []
    for other in phases.sector_phases:
        for edge in (0.25, -0.25) if phases.pins % 2 else (0.25,):
            first = (edge - (other - phase) - low) % sector + low
            found += [
                place for place in (first - sector, first) if low + apart < place < high - apart
            ]
    merged: list[float] = []
    for place in sorted(found):
        if not merged or place - merged[-1] > apart:
            merged.append(place)
    return merged


def _driving_set(phases: WavePhases, phase: float, offset: float) -> DrivingSet:
    """Pairs that drive while the pair of a phase has the pressure angle `offset`, in turns."""
    pins = phases.pins
    runs = []
    for other, weight in zip(phases.sector_phases, phases.multiplicity, strict=True):
        difference = other - phase
        first = math.floor(pins * (-0.25 - offset - difference)) + 1
        last = math.ceil(pins * (0.25 - offset - difference)) - 1
        if last >= first:
            middle = difference + (first + last) / (2 * pins)
            runs.append(PinRun(middle, last - first + 1, weight))
    return DrivingSet(pins, tuple(runs))


def cosine(turns: float) -> float:
    """Cosine of an angle of at most half a turn, in turns, with all digits beside its zero."""
    return math.sin(2 * math.pi * (0.25 - abs(turns)))
