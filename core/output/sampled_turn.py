"""Forces over a turn of the wave at samples, and their largest values.

A value that grows with forces is largest at one of the samples, which are dense where forces have
kinks. Where forces are known to be smooth, the parabola through the largest sample and its
neighbours counts.
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
"""Signs of the torque for each direction."""


TINY = 1e-300
"""Distance of coincident samples, rad, against division by zero."""

FEWER = 0.9
"""Share of samples left by a round of thinning above which thinning ends."""


@dataclass(frozen=True, eq=False, slots=True, kw_only=True)
class PinForces:
    """Forces on pins under one torque."""

    wave: FloatArray  # wave angles, rad, ascending within a period, shape (n,)
    # Force of each disc on each pin, N, shape (K, N, n): tangential + i*radial, in the frame of
    # the part that holds the pins.
    on_pins: ComplexArray
    # Estimated error of the forces over the largest force: the distance of samples from the
    # straight line between their neighbours, and the error of the positions. No proof.
    error: float
    evaluations: int  # number of solved positions
    unlike: int  # number of pins, from the first, that differ in their forces

    def largest(self, values: FloatArray) -> FloatArray:
        """Largest values over the samples, the last axis of shape (..., n)."""
        found: FloatArray = values.max(axis=-1)
        return found

    def felt(self, pin: int) -> "PinSamples":
        """Forces on a pin over the turn, by its number from 0."""
        return PinSamples(self.on_pins[:, pin], self.wave, np.zeros(len(self.wave), np.bool_))


@dataclass(frozen=True, eq=False, slots=True, kw_only=True)
class SampledTurn(PinForces):
    """Forces on pins and discs under one torque."""

    # Resultant of the pins on each disc, N, shape (K, n): along + i*across; along its crank
    # towards the axis, and across it back against the crank's rotation under a driving torque.
    on_satellites: ComplexArray
    total: FloatArray  # sum of the sizes of all forces, N, shape (n,)
    # Couple of the pins about the disc's centre, N*m, shape (K, n), in the sense of the torque on
    # the output link.
    couple: FloatArray
    crank_angles: tuple[float, ...]  # angle of each crank with its deviation, rad
    waves: int = 1  # turns of the wave after which forces repeat
    # Force of the ring on each disc, as `on_satellites`, N, shape (K, n), if the ring's mesh is
    # solved too.
    of_ring: ComplexArray | None = None

    @property
    def period(self) -> float:
        """Wave angle after which forces repeat, rad."""
        return 2 * math.pi * self.waves

    def mean(self, values: FloatArray) -> FloatArray:
        """Mean over the turn of values at the samples, the last axis of shape (..., n)."""
        gaps = np.diff(self.wave, append=self.wave[0] + self.period)
        found: FloatArray = values @ (gaps + np.roll(gaps, 1)) / (2 * self.period)
        return found

    def at(self, *, wave: FloatArray, values: NDArray[Any]) -> NDArray[Any]:
        """Values at other wave angles, rad, by straight lines between samples, shape (K, n)."""
        return np.array([np.interp(wave, self.wave, row, period=self.period) for row in values])

    def missed(self, values: NDArray[Any]) -> float:
        """Estimate of the error of values, shape (..., n), between the samples."""
        turn = self.period
        wave = np.concatenate(([self.wave[-1] - turn], self.wave, [self.wave[0] + turn]))
        around = np.concatenate((values[..., -1:], values, values[..., :1]), axis=-1)
        return float(off_straight(wave=wave, values=around).max())


@dataclass(frozen=True, eq=False, slots=True)
class PinSamples:
    """Forces of the discs on one pin, N, as in `SampledTurn.on_pins`."""

    forces: ComplexArray  # forces at samples, shape (K, n)
    wave: FloatArray  # wave angles of the samples, rad, shape (n,)
    smooth: BoolArray  # True if forces are smooth between both neighbours, shape (n,)

    @classmethod
    def together(cls, parts: "Sequence[PinSamples]") -> "PinSamples":
        """Samples of several directions, one after another."""
        rows = ((each.forces, each.wave, each.smooth) for each in parts)
        return cls(*(np.concatenate(each, axis=-1) for each in zip(*rows, strict=True)))

    def of(self, kept: BoolArray | IntArray) -> "PinSamples":
        """Chosen samples."""
        return PinSamples(self.forces[:, kept], self.wave[kept], self.smooth[kept])

    def thinned(self, enough: float) -> "PinSamples":
        """Samples without smooth ones nearer their neighbours' line than this part of the force."""
        found, enough = self, enough * float(np.abs(self.forces).max())
        while True:
            off = off_straight(wave=found.wave, values=found.forces).max(axis=0)
            kept = np.ones(len(found.wave), dtype=np.bool_)
            kept[1:-1:2] = ~found.smooth[1:-1:2] | (off[::2] > enough)
            found = found.of(kept)
            if kept.mean() > FEWER:
                return found

    def only(self, kept: BoolArray) -> "PinSamples":
        """Samples of a mask, shape (n,), and their neighbours."""
        beside = kept.copy()
        beside[1:] |= kept[:-1]
        beside[:-1] |= kept[1:]
        index = np.flatnonzero(beside)
        alone = np.diff(index, prepend=-2, append=len(kept) + 1) > 1
        found = self.of(index)
        return replace(found, smooth=found.smooth & ~alone[:-1] & ~alone[1:])

    @property
    def loaded(self) -> "PinSamples":
        """Samples without stretches over which nothing loads the pin, except for their ends."""
        return self.only(np.abs(self.forces).sum(axis=0) > 0)

    def sums(self, arms: NDArray[Any]) -> ComplexArray:
        """Sums of forces times influences of shape (rows, K), at all samples, shape (rows, n)."""
        found: ComplexArray = arms @ self.forces
        return found

    def largest(self, values: FloatArray) -> FloatArray:
        """Largest values over the turn, shape (rows,), of values at samples, shape (rows, n)."""
        return largest_of_samples(values=values, wave=self.wave, smooth=self.smooth)


def largest_of_samples(*, values: FloatArray, wave: FloatArray, smooth: BoolArray) -> FloatArray:
    """Largest values over a turn, shape (rows,), by parabolas through three samples where smooth.

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
    # A parabola of slope s and curvature 2c at the sample rises above it by s^2/(4c).
    slope = (fall * after / before - drop * before / after) / (before + after)
    bend = (fall / before + drop / after) / (before + after)
    curved &= bend > 0
    return top + np.where(curved, slope**2 / (4 * np.where(curved, bend, 1.0)), 0.0)


Made = Callable[[float], SampledTurn]
"""Function from a torque, N*m, negative in reverse, to the forces on pins and discs."""


def off_straight(*, wave: FloatArray, values: NDArray[Any]) -> FloatArray:
    """Distance of inner samples from their neighbours' line, (..., n) of (..., n + 2)."""
    before, after = np.diff(wave[:-1]), np.diff(wave[1:])
    line = (values[..., 2:] * before + values[..., :-2] * after) / np.maximum(before + after, TINY)
    found: FloatArray = np.abs(values[..., 1:-1] - line)
    return found
