"""Forces of the mechanism as it is made over a turn of the wave, at samples.

Between the samples forces are taken to be straight, so that whatever grows with them is largest at
one of them. They are dense where forces have kinks.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from core.arrays import ComplexArray, FloatArray

Direction = Literal["driving", "reverse", "alternating"]

WAYS: dict[Direction, tuple[float, ...]] = {
    "driving": (1.0,),
    "reverse": (-1.0,),
    "alternating": (1.0, -1.0),
}
"""Signs of the torque in each direction."""


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
    line = (values[..., 2:] * before + values[..., :-2] * after) / (before + after)
    found: FloatArray = np.abs(values[..., 1:-1] - line)
    return found
