"""Phases and segments of smooth peak force for arrays of mechanisms with the same numbers of pairs.

The segments of the turn are those of `core.driving_set`, here over one sector of the wave with
all satellites apart. Arrays have the designs as their last axis, for it is the longest.
"""

import math
from dataclasses import dataclass
from typing import Self

import numpy as np
from numpy.typing import NDArray

from core.contact_force import FloatArray
from core.mechanism import SAME_PHASE
from core.results import ROUNDING

IntArray = NDArray[np.intp]

SLIVER = 4 * ROUNDING
"""Width below which a segment is nothing but rounding, in turns."""

EQUAL = 1e-13
"""Peaks closer than this, or than their errors, are one peak reached more than once."""


@dataclass(frozen=True, slots=True)
class Phases:
    """Phases of the satellites, in turns; compare `core.mechanism.WavePhases`.

    Attributes
    ----------
    pins : int
        Number of pins N.
    satellite : array, shape (K, n)
        Phase of the pair of each satellite with pin 1, in [0, 1).
    sector : array, shape (K, n)
        The same within a sector [0, 1/N).
    error : array, shape (n,)
        By how much they may be elsewhere.
    """

    pins: int
    satellite: FloatArray
    sector: FloatArray
    error: FloatArray

    @classmethod
    def of(cls, *, pins: int, crank_angles: FloatArray, initial: FloatArray) -> Self:
        """Phases of designs; those that differ by rounding are made one.

        Parameters
        ----------
        pins : int
            Number of pins N.
        crank_angles : array, shape (K, n)
            Angles of the cranks, rad.
        initial : array, shape (n,)
            Wave angle at crank angle 0, rad.
        """
        cells = pins if pins % 2 == 0 else 2 * pins
        turn = 2 * math.pi
        scaled = (np.fmod(crank_angles, turn) / turn + np.fmod(initial, turn) / turn) * cells
        cell = np.floor(scaled)
        residue = scaled - cell
        tolerance = SAME_PHASE * cells
        order = np.argsort(residue, axis=0)
        ascending = np.take_along_axis(residue, order, axis=0)
        wrapped = np.zeros_like(ascending)
        snapped = np.zeros(crank_angles.shape[1])
        lowest = representative = ascending[0].copy()
        for j in range(1, len(ascending)):
            own = ascending[j].copy()
            wraps = (own > 1 - tolerance) & (lowest <= tolerance)
            joins = ~wraps & (own - representative <= tolerance)
            wrapped[j] = wraps
            ascending[j] = np.where(wraps, lowest, np.where(joins, representative, own))
            snapped = np.maximum(snapped, np.abs(ascending[j] + wraps - own))
            representative = np.where(wraps | joins, representative, own)
        np.put_along_axis(residue, order, ascending, axis=0)
        carried = np.empty_like(wrapped)
        np.put_along_axis(carried, order, wrapped, axis=0)
        cell += carried
        return cls(
            pins=pins,
            satellite=(cell % cells + residue) / cells,
            sector=(cell % (cells // pins) + residue) / cells,
            error=2 * ROUNDING + snapped / cells,
        )

    def position(self, position: FloatArray) -> FloatArray:
        """Wave position within [0, 1/N), turns; a rounding error beside the ends is 0."""
        within = position % (1 / self.pins)
        inside = (within > SAME_PHASE) & (within < 1 / self.pins - SAME_PHASE)
        return np.where(inside, within, 0.0)

    def best_pair(self, position: FloatArray) -> tuple[IntArray, IntArray]:
        """Satellite and pin, from 1, of the best placed pair at wave positions; of equals the
        first.
        """
        off = (0.75 - position - self.satellite) * self.pins
        pin = np.ceil(off - 0.5 - SAME_PHASE * self.pins)
        satellite = np.argmin(np.round(np.abs(off - pin) / self.pins, 12), axis=0)
        chosen = np.take_along_axis(pin, satellite[None], axis=0)[0]
        return satellite + 1, (chosen % self.pins).astype(np.intp) + 1


@dataclass(frozen=True, slots=True)
class Segments:
    """Segments of smooth peak force over one sector of the wave, in turns.

    Attributes
    ----------
    start : array, shape (G, n)
        Wave position at which a segment starts.
    low, high : array, shape (G, n)
        Pressure angle of the best placed pair at its start and at its end.
    real : array of bool, shape (G, n)
        Whether it is more than a sliver of rounding.
    nearest : array, shape (G, K, n)
        Phase of each satellite's pin nearest to the best place, against the best placed pair.
    first : array, shape (G, K, n)
        Number of the satellite's first driving pin, from that one.
    driving : array of int, shape (G, K, n)
        How many of its pins drive.
    """

    start: FloatArray
    low: FloatArray
    high: FloatArray
    real: NDArray[np.bool_]
    nearest: FloatArray
    first: FloatArray
    driving: IntArray

    @classmethod
    def of(cls, phases: Phases) -> Self:
        """Segments of designs."""
        sector = 1 / phases.pins
        ordered = np.sort(phases.sector, axis=0)
        following = np.concatenate((ordered[1:], ordered[:1] + sector))
        switches = [0.75 - (ordered + following) / 2, 1.0 - ordered]
        if phases.pins % 2:
            switches.append(0.5 - ordered)
        start = np.sort(np.concatenate(switches) % sector, axis=0)
        width = np.concatenate((start[1:], start[:1] + sector)) - start
        middle = start + width / 2
        nearest = middle[:, None] + (phases.sector - 0.75)
        nearest -= np.rint(nearest * phases.pins) / phases.pins
        best = np.argmin(np.abs(nearest), axis=1)[:, None]
        at_middle = np.take_along_axis(nearest, best, axis=1)[:, 0]
        first = np.floor(phases.pins * (-0.25 - nearest)) + 1
        last = np.ceil(phases.pins * (0.25 - nearest)) - 1
        return cls(
            start=start,
            low=at_middle - width / 2,
            high=at_middle + width / 2,
            real=width > SLIVER,
            nearest=nearest - at_middle[:, None],
            first=first,
            driving=(last - first + 1).astype(np.intp),
        )


@dataclass(frozen=True, slots=True)
class Peaks:
    """Peaks of designs, arrays of shape (n,).

    Attributes
    ----------
    ratio : array
        Largest force over F0, dimensionless.
    place : array
        First wave position within the sector at which it is reached, turns.
    error : array
        Bound of the relative error of the ratio.
    evaluations : array of int
        Places at which the force was calculated.
    """

    ratio: FloatArray
    place: FloatArray
    error: FloatArray
    evaluations: IntArray
