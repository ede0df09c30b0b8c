"""Random deviations of the parts, which depend on the seed, the part and the sample only.

Each part of each kind has its own stream: Philox4x64-10 with the key (seed, kind and index), whose
i-th word is sample i. A sample therefore does not depend on the number of samples, on blocks, or on
other sources. Words are converted here, because NumPy guarantees the words and not the numbers that
its distributions make of them.
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
"""Streams of each source; a round zone has one for the radius and one for the angle."""

OF_RING = ("ring_pin_position", "ring_pin_radius", "equidistant", "modification_pin_circle")
"""Sources that belong to ring pins and to the cycloid discs on them."""

OTHER = 1000
"""Offset of the kinds for a second, independent sample of one seed."""

Distribution = Literal["normal", "uniform"]


def uniforms(
    *, seed: int, streams: Sequence[tuple[int, int]], samples: int, first: int = 0
) -> FloatArray:
    """Numbers of random streams, above 0 and below 1, shape (streams, samples). A stream is a kind
    and the index of a part, from 0; `first` is the index of the first sample.

    >>> uniforms(seed=7, streams=[(0, 0)], samples=2).tolist()
    [[0.8720734548204874, 0.2953653815137836]]
    """
    bits = np.random.Philox(key=np.array([seed, 0], np.uint64))
    state = bits.state
    state["state"]["counter"][0] = first // 4
    numbers = np.empty((len(streams), samples))
    for row, (kind, index) in zip(numbers, streams, strict=True):
        state["state"]["key"][1] = (kind << 32) + index
        bits.state = state  # takes a tenth of the time of a new generator
        row[:] = bits.random_raw(first % 4 + samples)[first % 4 :] >> np.uint64(11)
    numbers *= 2.0**-53
    numbers += 2.0**-54
    return numbers


@dataclass(frozen=True, slots=True)
class Spread:
    """Range and distribution of a deviation of a size or an angle."""

    lower: float  # least deviation, m or rad
    upper: float  # largest deviation, m or rad
    # A normal distribution is cut off at the limits, three standard deviations off the middle.
    distribution: Distribution = "normal"
    common: bool = False  # true if all parts of a piece have one deviation

    def __post_init__(self) -> None:
        check_finite(lower=self.lower, upper=self.upper)
        if not self.lower <= self.upper:
            raise InvalidInput("lower", self.lower, "at_most", field="upper", limit=self.upper)

    def values(self, uniform: FloatArray) -> FloatArray:
        """Deviations for numbers between 0 and 1."""
        return self.spread(normals(uniform) if self.distribution == "normal" else uniform)

    def spread(self, numbers: FloatArray) -> FloatArray:
        """Deviations for numbers of `normals`, or for numbers from 0 to 1 if uniform."""
        if self.distribution == "uniform":
            return self.lower + numbers * (self.upper - self.lower)
        return (self.lower + self.upper) / 2 + (self.upper - self.lower) / 6 * numbers


def normals(uniform: FloatArray) -> FloatArray:
    """Normal deviations within three standard deviations, for numbers between 0 and 1."""
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
"""Rational functions of the inverse normal distribution, within 0.425 of the middle, and from there
to probabilities of 1e-11 (Wichura 1988, algorithm AS 241, PPND16)."""


def _polynomial(powers: tuple[float, ...], x: FloatArray) -> FloatArray:
    """Value of a polynomial by Horner's rule."""
    value = np.full_like(x, powers[0])
    for power in powers[1:]:
        value *= x
        value += power
    return value


def _normal_quantile(probability: FloatArray) -> FloatArray:
    """Quantile of the standard normal distribution."""
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
    """Radial and tangential places in a round zone, even over its area, m. The diameter of the zone
    is the position tolerance, m; `radius_uniform` and `angle_uniform` are numbers between 0 and 1.
    """
    radius = diameter / 2 * np.sqrt(radius_uniform)
    angle = 2 * math.pi * angle_uniform
    return radius * np.cos(angle), radius * np.sin(angle)
