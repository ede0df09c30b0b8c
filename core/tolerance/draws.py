"""Random deviations of the parts, the same for a seed whatever else is drawn.

Each part of each kind has a stream of its own: Philox4x64-10 with the key (seed, kind and index),
of which sample i is the i-th word. So a sample does not depend on how many there are, on blocks, or
on other sources. Words are used as they are: NumPy promises these, not what it makes of them.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from core.arrays import FloatArray, check_finite
from core.errors import InvalidInput

KINDS = {
    "pin_position": (0, 1),
    "pin_radius": (2,),
    "hole_position": (3, 4),
    "hole_radius": (5,),
    "eccentricity": (6,),
    "crank_phase": (7,),
    "disc_phase": (8,),
    "ring_pin_position": (9, 10),
    "ring_pin_radius": (11,),
    "equidistant": (12,),
    "modification_pin_circle": (13,),
}
"""Streams of each source; of a zone one for the radius and one for the angle."""

OF_RING = ("ring_pin_position", "ring_pin_radius", "equidistant", "modification_pin_circle")
"""Sources of a ring of pins, and of the cycloid discs on them."""

OTHER = 1000
"""Added to the kinds for a second, independent sample of the same seed."""

Distribution = Literal["normal", "uniform"]


def uniforms(
    *, seed: int, streams: Sequence[tuple[int, int]], samples: int, first: int = 0
) -> FloatArray:
    """Numbers between 0 and 1 of streams, neither of them included.

    Parameters
    ----------
    seed : int
        Of the study, >= 0.
    streams : sequence of tuple
        Kind of each, and number of the part from 0.
    samples : int
        How many.
    first : int
        Number of the first sample.

    Returns
    -------
    array, shape (streams, samples)

    Examples
    --------
    >>> uniforms(seed=7, streams=[(0, 0)], samples=2).tolist()
    [[0.8720734548204874, 0.2953653815137836]]
    """
    bits = np.random.Philox(key=np.array([seed, 0], np.uint64))
    state = bits.state
    state["state"]["counter"][0] = first // 4
    numbers = np.empty((len(streams), samples))
    for row, (kind, index) in zip(numbers, streams, strict=True):
        state["state"]["key"][1] = (kind << 32) + index
        bits.state = state  # a tenth of the time of another generator
        row[:] = bits.random_raw(first % 4 + samples)[first % 4 :] >> np.uint64(11)
    numbers *= 2.0**-53
    numbers += 2.0**-54
    return numbers


@dataclass(frozen=True, slots=True)
class Spread:
    """How a size or an angle varies."""

    lower: float  # least deviation, m or rad
    upper: float  # largest deviation
    # Normal: cut off at the limits, which are three standard deviations off the middle.
    distribution: Distribution = "normal"
    common: bool = False  # whether all parts of a piece have the same

    def __post_init__(self) -> None:
        check_finite(lower=self.lower, upper=self.upper)
        if not self.lower <= self.upper:
            raise InvalidInput("lower", self.lower, "at_most", field="upper", limit=self.upper)

    def values(self, uniform: FloatArray) -> FloatArray:
        """Deviations of numbers between 0 and 1.

        Parameters
        ----------
        uniform : array
            Numbers between 0 and 1.

        Returns
        -------
        array
        """
        return self.spread(normals(uniform) if self.distribution == "normal" else uniform)

    def spread(self, numbers: FloatArray) -> FloatArray:
        """The same of numbers of its distribution.

        Parameters
        ----------
        numbers : array
            As `normals` makes them, or between 0 and 1.

        Returns
        -------
        array
        """
        if self.distribution == "uniform":
            return self.lower + numbers * (self.upper - self.lower)
        return (self.lower + self.upper) / 2 + (self.upper - self.lower) / 6 * numbers


def normals(uniform: FloatArray) -> FloatArray:
    """Normal deviations within three standard deviations, of numbers between 0 and 1.

    Parameters
    ----------
    uniform : array
        Numbers between 0 and 1.

    Returns
    -------
    array
    """
    tail = 0.5 * math.erfc(3 / math.sqrt(2))
    return _normal_quantile(tail + uniform * (1 - 2 * tail))


CENTRE = (
    (2509.0809287301226727, 33430.575583588128105, 67265.770927008700853, 45921.953931549871457,
     13731.693765509461125, 1971.5909503065514427, 133.14166789178437745, 3.3871328727963666080),
    (5226.4952788528545610, 28729.085735721942674, 39307.895800092710610, 21213.794301586595867,
     5394.1960214247511077, 687.18700749205790830, 42.313330701600911252, 1.0),
)  # fmt: skip
TAIL = (
    (7.7454501427834140764e-4, 0.0227238449892691845833, 0.24178072517745061177,
     1.27045825245236838258, 3.64784832476320460504, 5.7694972214606914055,
     4.6303378461565452959, 1.42343711074968357734),
    (1.05075007164441684324e-9, 5.475938084995344946e-4, 0.0151986665636164571966,
     0.14810397642748007459, 0.68976733498510000455, 1.6763848301838038494,
     2.05319162663775882187, 1.0),
)  # fmt: skip
"""Wichura 1988, algorithm AS 241 (PPND16): rational functions of the normal distribution's inverse,
within 0.425 of the middle and from there to probabilities of 1e-11."""


def _polynomial(powers: tuple[float, ...], x: FloatArray) -> FloatArray:
    """By Horner's rule, in one array."""
    value = np.full_like(x, powers[0])
    for power in powers[1:]:
        value *= x
        value += power
    return value


def _normal_quantile(probability: FloatArray) -> FloatArray:
    """The number below which a normal deviation lies with a probability."""
    off = probability - 0.5
    square = 0.180625 - off * off
    centre = _polynomial(CENTRE[0], square)
    centre *= off
    centre /= _polynomial(CENTRE[1], square)
    outside = np.nonzero(np.abs(off) > 0.425)
    far = off[outside]
    depth = np.sqrt(-np.log(0.5 - np.abs(far))) - 1.6
    tail = _polynomial(TAIL[0], depth) / _polynomial(TAIL[1], depth)
    centre[outside] = np.copysign(tail, far)
    return centre


def zone_places(
    *, diameter: float, radius_uniform: FloatArray, angle_uniform: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """Places in a round zone, evenly over its area.

    Parameters
    ----------
    diameter : float
        Of the zone, m: the position tolerance.
    radius_uniform, angle_uniform : array
        Numbers between 0 and 1.

    Returns
    -------
    radial, tangential : array
        Places, m.
    """
    radius = diameter / 2 * np.sqrt(radius_uniform)
    angle = 2 * math.pi * angle_uniform
    return radius * np.cos(angle), radius * np.sin(angle)
