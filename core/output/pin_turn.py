"""The forces that one pin feels over a turn, and where any measure of them is largest.

In the frame of the carrier the force of satellite j on a pin is ``F_j*(cos(gamma_j),
sin(gamma_j))``, tangential and radial: as the pressure angle sweeps half a turn, so does the force.
Forces are complex numbers here, tangential + i*radial. All pins of a mechanism are alike but for
the time at which they feel them.
"""

import math
from collections.abc import Callable
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from core.arrays import FloatArray, IntArray
from core.output.mechanism import Mechanism

ComplexArray = NDArray[np.complex128]

SAMPLES = 512
"""Places a turn at which the forces are looked at first, for exponents up to 4; denser towards the
ends of a segment, where a power below 1 of a cosine rises steeply."""

MOST_SAMPLES = 4096

NONE = 1e-13
"""Cosine below which a pair begins or ends to drive."""

POINTS, ROUNDS = 33, 5
"""Places in a bracket, which is narrowed to two of their distances, and how often."""

WAY = np.linspace(0.0, 1.0, POINTS)


class PinTurn:
    """Forces on a pin over the turn of the wave, over F0, segment by segment.

    Between the places at which any pair starts or stops driving the forces are smooth; each place
    belongs to one such segment, its ends to both.

    Parameters
    ----------
    mechanism : Mechanism
        Pins, satellites, ratio; without a dead centre.
    force_exponent : float
        Exponent v of the force over the approach.
    """

    def __init__(self, mechanism: Mechanism, force_exponent: float) -> None:
        phases = mechanism.phases
        self.exponent = force_exponent
        self.satellite = np.array(phases.satellite_phase) - 0.75
        sectors = np.arange(phases.pins) / phases.pins
        self.phase = np.add.outer(np.array(phases.sector_phases) - 0.75, sectors).ravel()
        self.weight = np.repeat(np.array(phases.multiplicity, dtype=float), phases.pins)
        first = np.array([place for place, _ in phases.switching()])
        self.low = np.add.outer(sectors, first).ravel()
        self.high = np.append(self.low[1:], self.low[0] + 1.0)
        self.middle = (self.low + self.high) / 2
        wanted = min(SAMPLES * max(1.0, math.sqrt(force_exponent) / 2), MOST_SAMPLES)
        counts = np.maximum(np.ceil((self.high - self.low) * wanted).astype(int), 4) + 1
        self.places = np.concatenate(
            [
                low + (high - low) * (1 - np.cos(np.linspace(0.0, np.pi, count))) / 2
                for low, high, count in zip(self.low, self.high, counts, strict=True)
            ]
        )
        self.segment = np.repeat(np.arange(len(counts)), counts)
        self.forces = self.at(self.places, self.segment)
        self.neighbours = self.beside(np.arange(len(self.places)))

    def at(self, places: FloatArray, segment: IntArray) -> ComplexArray:
        """Forces of the satellites on the pin over F0.

        Parameters
        ----------
        places : array
            Places of the wave, in turns.
        segment : array, same shape
            The segments that they belong to.

        Returns
        -------
        array, shape (K, ...)
        """
        middle = self.middle[segment]
        cosines, drives, _ = _cosines(self.phase, places, middle)
        best = cosines.max(axis=0)
        relative = cosines / best
        powers = np.where(drives, relative**self.exponent, 0.0)
        shares = (powers * relative).reshape(len(self.phase), -1)
        total = best * (self.weight[:, None] * shares).sum(axis=0).reshape(best.shape)
        own, drives, angles = _cosines(self.satellite, places, middle)
        ratios = np.where(drives, (own / best) ** self.exponent, 0.0) / total
        found: ComplexArray = ratios * np.exp(2j * np.pi * angles)
        return found

    def peaks(self, values: FloatArray) -> IntArray:
        """Samples that may have the largest value of all beside them.

        Parameters
        ----------
        values : array, shape (n,)
            Value of each sample.

        Returns
        -------
        array of int
        """
        before, after = self.neighbours
        least = np.minimum(values[before], values[after])
        summit = (values >= values[before]) & (values >= values[after])
        chosen: IntArray = np.flatnonzero(summit & (2 * values - least >= values.max()))
        return chosen

    def beside(self, index: IntArray) -> tuple[IntArray, IntArray]:
        """The samples before and after, of the same segment."""
        last = len(self.places) - 1
        before, after = np.maximum(index - 1, 0), np.minimum(index + 1, last)
        own = self.segment[index]
        return (
            np.where(self.segment[before] == own, before, index),
            np.where(self.segment[after] == own, after, index),
        )

    def narrow(
        self, index: IntArray, value: Callable[[ComplexArray], FloatArray]
    ) -> tuple[FloatArray, FloatArray]:
        """Largest values beside samples, and their places.

        Parameters
        ----------
        index : array of int, shape (n,)
            The samples.
        value : callable
            Value of forces of the shape (K, n, m), of the shape (n, m).

        Returns
        -------
        values, places : array, shape (n,)
        """
        before, after = self.beside(index)
        start, stop = self.places[before], self.places[after]
        segment = np.repeat(self.segment[index][:, None], POINTS, axis=1)
        rows = np.arange(len(index))
        for _ in range(ROUNDS):
            places = start[:, None] + (stop - start)[:, None] * WAY
            values = value(self.at(places, segment))
            best = values.argmax(axis=1)
            start = places[rows, np.maximum(best - 1, 0)]
            stop = places[rows, np.minimum(best + 1, POINTS - 1)]
        return values[rows, best], places[rows, best]

    def largest(self, value: Callable[[ComplexArray], FloatArray]) -> tuple[float, ComplexArray]:
        """The largest value over the turn, and the forces there.

        Parameters
        ----------
        value : callable
            Value of forces of the shape (K, ...), of the shape (...).

        Returns
        -------
        value : float
        forces : array, shape (K,)
        """
        index = self.peaks(value(self.forces))
        values, places = self.narrow(index, value)
        best = int(values.argmax())
        forces = self.at(places[best : best + 1], self.segment[index[best : best + 1]])
        return float(values[best]), forces[:, 0]


def _cosines(
    phase: FloatArray, places: FloatArray, middle: FloatArray
) -> tuple[FloatArray, NDArray[np.bool_], FloatArray]:
    """Cosines of pressure angles, which pairs drive in the middle of the segment, and the angles
    in turns.
    """
    angles = np.add.outer(phase, places)
    angles -= np.rint(np.add.outer(phase, middle))
    drives = np.abs(angles - (places - middle)) < 0.25
    cosines = np.sin(2 * np.pi * np.maximum(0.25 - np.abs(angles), 0.0))
    cosines = np.where(drives & (cosines > NONE), cosines, 0.0)
    return cosines, drives, angles


def combine(*, weights: FloatArray, forces: ComplexArray) -> ComplexArray:
    """Sums of the satellites' forces with weights.

    Parameters
    ----------
    weights : array, shape (..., K)
        Weights, any number of sets.
    forces : array, shape (K, ...)
        Forces, any number of sets.

    Returns
    -------
    array
        The shape of the sets of weights, then that of the forces. (The products are too small for
        a library of linear algebra.)
    """
    sets = weights.reshape(-1, len(forces), 1)
    columns = forces.reshape(len(forces), -1)
    found = sets[:, 0] * columns[0]
    for k in range(1, len(forces)):
        found = found + sets[:, k] * columns[k]
    sums: ComplexArray = found.reshape(weights.shape[:-1] + forces.shape[1:])
    return sums


@lru_cache(maxsize=256)
def pin_turn(mechanism: Mechanism, force_exponent: float) -> PinTurn:
    """The forces on a pin of a mechanism, looked at once.

    Parameters
    ----------
    mechanism : Mechanism
        Pins, satellites, ratio; without a dead centre.
    force_exponent : float
        Exponent v of the force over the approach.

    Returns
    -------
    PinTurn
    """
    return PinTurn(mechanism, force_exponent)
