"""Forces over a turn of the wave, at samples, and what is largest of them.

Whatever grows with forces is largest at one of the samples, or beside it where forces are known to
be smooth: there the parabola through the largest one and its neighbours counts. Samples are dense
where forces have kinks.
"""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from core.arrays import BoolArray, ComplexArray, FloatArray, IntArray

Direction = Literal["driving", "reverse", "alternating"]

WAYS: dict[Direction, tuple[float, ...]] = {
    "driving": (1.0,),
    "reverse": (-1.0,),
    "alternating": (1.0, -1.0),
}
"""Signs of the torque in each direction."""


TINY = 1e-300
"""Distance of samples that are the same, rad."""

FEWER = 0.9
"""Share of samples that are left where thinning them ends."""


@dataclass(frozen=True, eq=False, slots=True, kw_only=True)
class PinForces:
    """Forces on pins under one torque."""

    wave: FloatArray  # wave angles, rad, ascending within a period, shape (n,)
    # Force of each satellite on each pin, N, shape (K, N, n): tangential + i*radial, in the frame
    # of what holds the pins.
    on_pins: ComplexArray
    # Estimate of the relative error of the forces, over the largest: how far samples lie off the
    # straight line between their neighbours, and that of the positions. Honest, no proof.
    error: float
    evaluations: int  # positions that were solved
    unlike: int  # how many pins, from the first, feel what no other of them does, sooner or later

    def largest(self, values: FloatArray) -> FloatArray:
        """Largest values at the samples, which are last, shape (..., n)."""
        found: FloatArray = values.max(axis=-1)
        return found

    def felt(self, pin: int) -> "PinSamples":
        """Forces on a pin over the turn, by its number from 0."""
        return PinSamples(self.on_pins[:, pin], self.wave, np.zeros(len(self.wave), np.bool_))


@dataclass(frozen=True, eq=False, slots=True, kw_only=True)
class SampledTurn(PinForces):
    """Forces on pins and satellites under one torque."""

    # Resultant of the pins on each satellite, N, shape (K, n): along its crank towards the axis,
    # and i times that across, back against the crank's rotation under a driving torque.
    on_satellites: ComplexArray
    total: FloatArray  # sum of the sizes of all forces, N, shape (n,)
    # Couple of the pins about the satellite's centre, N*m, shape (K, n); as the torque on the
    # output link.
    couple: FloatArray
    crank_angles: tuple[float, ...]  # of each crank with its deviation, rad
    waves: int = 1  # turns of the wave after which they repeat
    # Force of the ring on each satellite, as `on_satellites`, N, shape (K, n), where its mesh is
    # solved too.
    of_ring: ComplexArray | None = None

    @property
    def period(self) -> float:
        """Wave angle after which forces repeat, rad."""
        return 2 * math.pi * self.waves

    def mean(self, values: FloatArray) -> FloatArray:
        """Mean of values over the turn.

        Parameters
        ----------
        values : array, shape (..., n)
            At the samples.

        Returns
        -------
        array, shape (...)
        """
        gaps = np.diff(self.wave, append=self.wave[0] + self.period)
        found: FloatArray = values @ (gaps + np.roll(gaps, 1)) / (2 * self.period)
        return found

    def at(self, *, wave: FloatArray, values: NDArray[Any]) -> NDArray[Any]:
        """Values at other wave angles, on the straight lines between the samples.

        Parameters
        ----------
        wave : array, shape (m,)
            Wave angles, rad.
        values : array, shape (K, n)
            At the samples.

        Returns
        -------
        array, shape (K, m)
        """
        return np.array([np.interp(wave, self.wave, row, period=self.period) for row in values])

    def missed(self, values: NDArray[Any]) -> float:
        """Estimate of the error of values between the samples.

        Parameters
        ----------
        values : array, shape (..., n)
            At the samples.

        Returns
        -------
        float
        """
        turn = self.period
        wave = np.concatenate(([self.wave[-1] - turn], self.wave, [self.wave[0] + turn]))
        around = np.concatenate((values[..., -1:], values, values[..., :1]), axis=-1)
        return float(off_straight(wave=wave, values=around).max())


@dataclass(frozen=True, eq=False, slots=True)
class PinSamples:
    """Forces of the satellites on one pin, N, as `SampledTurn.on_pins`."""

    forces: ComplexArray  # at samples, shape (K, n)
    wave: FloatArray  # wave angles of these, rad, shape (n,)
    smooth: BoolArray  # whether forces are smooth from the sample before to that after, shape (n,)

    @classmethod
    def together(cls, parts: "Sequence[PinSamples]") -> "PinSamples":
        """Samples of several directions, one after another."""
        rows = ((each.forces, each.wave, each.smooth) for each in parts)
        return cls(*(np.concatenate(each, axis=-1) for each in zip(*rows, strict=True)))

    def of(self, kept: BoolArray | IntArray) -> "PinSamples":
        """Some samples."""
        return PinSamples(self.forces[:, kept], self.wave[kept], self.smooth[kept])

    def thinned(self, enough: float) -> "PinSamples":
        """Without smooth samples that lie on the line between their neighbours, but for a part of
        the largest force.
        """
        found, enough = self, enough * float(np.abs(self.forces).max())
        while True:
            off = off_straight(wave=found.wave, values=found.forces).max(axis=0)
            kept = np.ones(len(found.wave), dtype=np.bool_)
            kept[1:-1:2] = ~found.smooth[1:-1:2] | (off[::2] > enough)
            found = found.of(kept)
            if kept.mean() > FEWER:
                return found

    def only(self, kept: BoolArray) -> "PinSamples":
        """Some samples, shape (n,), and those beside them."""
        beside = kept.copy()
        beside[1:] |= kept[:-1]
        beside[:-1] |= kept[1:]
        index = np.flatnonzero(beside)
        alone = np.diff(index, prepend=-2, append=len(kept) + 1) > 1
        found = self.of(index)
        return replace(found, smooth=found.smooth & ~alone[:-1] & ~alone[1:])

    @property
    def loaded(self) -> "PinSamples":
        """Without stretches over which nothing loads the pin, but for their ends."""
        return self.only(np.abs(self.forces).sum(axis=0) > 0)

    def sums(self, arms: NDArray[Any]) -> ComplexArray:
        """Sums of the forces times what a unit of each does, shape (rows, K), at all samples."""
        found: ComplexArray = arms @ self.forces
        return found

    def largest(self, values: FloatArray) -> FloatArray:
        """Largest values over the turn.

        Parameters
        ----------
        values : array, shape (rows, n)
            At the samples.

        Returns
        -------
        array, shape (rows,)
        """
        return largest_of_samples(values=values, wave=self.wave, smooth=self.smooth)


def largest_of_samples(*, values: FloatArray, wave: FloatArray, smooth: BoolArray) -> FloatArray:
    """Largest values over a turn: samples, or where they are smooth parabolas through three.

    Parameters
    ----------
    values : array, shape (rows, n)
        At the samples.
    wave : array, shape (n,)
        Wave angles of these, rad.
    smooth : array of bool, shape (n,)
        Whether values are smooth from the sample before to that after.

    Returns
    -------
    array, shape (rows,)

    Examples
    --------
    >>> x = np.array([0.0, 1.0, 3.0])
    >>> largest_of_samples(values=5 - (x[None] - 1.5)**2, wave=x, smooth=x == 1).tolist()
    [5.0]
    """
    row, index = np.arange(len(values)), values.argmax(axis=1)
    top: FloatArray = values[row, index]
    inner = np.minimum(np.maximum(index, 1), len(wave) - 2)
    before, after = wave[inner] - wave[inner - 1], wave[inner + 1] - wave[inner]
    curved = smooth[index] & (before > 0) & (after > 0)
    before, after = np.where(curved, before, 1.0), np.where(curved, after, 1.0)
    fall, drop = (top - values[row, inner + side] for side in (-1, 1))
    # with the slope s and the curvature 2c at the sample the parabola rises by s^2/(4c)
    slope = (fall * after / before - drop * before / after) / (before + after)
    bend = (fall / before + drop / after) / (before + after)
    curved &= bend > 0
    return top + np.where(curved, slope**2 / (4 * np.where(curved, bend, 1.0)), 0.0)


PinsMade = Callable[[float], PinForces]
"""Forces on pins under a torque, N*m, negative in reverse."""

Made = Callable[[float], SampledTurn]
"""The forces of a mechanism under a torque, N*m, negative in reverse; see
`core.output.real_turn.sampled`."""


def off_straight(*, wave: FloatArray, values: NDArray[Any]) -> FloatArray:
    """How far each sample lies off the straight line between its neighbours.

    Parameters
    ----------
    wave : array, shape (n + 2,)
        Wave angles, rad, ascending.
    values : array, shape (..., n + 2)
        At these.

    Returns
    -------
    array, shape (..., n)
        Of all samples but the first and the last.
    """
    before, after = np.diff(wave[:-1]), np.diff(wave[1:])
    line = (values[..., 2:] * before + values[..., :-2] * after) / np.maximum(before + after, TINY)
    found: FloatArray = np.abs(values[..., 1:-1] - line)
    return found
