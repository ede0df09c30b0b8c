"""Force of the ring on a satellite: the ratio of its part along the crank to its part across it.

The part across the crank carries the torque. The part along it is `radial_force_ratio` times as
large, and positive towards the reducer's axis, as the force of the output pins on the satellite is.
"""

import math
from dataclasses import dataclass, field

import numpy as np

from core.arrays import Number, check_positive, every, refuse
from core.errors import Notice, NotKnown
from core.precision import ROUNDING

STEEP = math.radians(55)
"""Operating pressure angle above which the ring presses the satellite more than it turns it."""

SERIES = 0.5
"""K1 below which the cycloid's ratio is summed as a series, as the closed form loses digits."""

TERMS = 30


@dataclass(frozen=True, slots=True)
class RingMesh:
    """Ratio rho of the ring's force along the crank to that across it."""

    radial_force_ratio: Number  # rho
    error: float = 0.0  # error of rho over max(|rho|, 1); large where the angle is small
    notices: tuple[Notice, ...] = ()

    @property
    def operating_pressure_angle(self) -> Number:
        """Operating pressure angle alpha_w, rad; `NotKnown` unless the teeth are involute."""
        raise NotKnown("no_teeth")


@dataclass(frozen=True, slots=True)
class InvoluteMesh(RingMesh):
    """Ratio rho and operating pressure angle of involute teeth."""

    operating_pressure_angle: Number = field(kw_only=True)  # alpha_w, rad


def involute_mesh(
    *, module: Number, teeth_difference: Number, pressure_angle: Number, eccentricity: Number
) -> InvoluteMesh:
    """Ratio of involute teeth, positive: the ring's force along the crank adds to the pins' force.

    ``rho = tan(alpha_w)``, ``cos(alpha_w) = m*(z3 - z2)*cos(alpha)/(2*e)`` with the module m, m,
    the reference pressure angle alpha, rad, and the eccentricity e, m. `InvalidInput` is raised if
    the base circles leave no room for the eccentricity.

    >>> mesh = involute_mesh(module=3.5e-3, teeth_difference=1, eccentricity=2e-3,
    ...                      pressure_angle=math.radians(20))
    >>> round(math.degrees(mesh.operating_pressure_angle), 8)
    34.6912426
    """
    check_positive(module=module, teeth_difference=teeth_difference, eccentricity=eccentricity)
    least = module * teeth_difference * np.cos(pressure_angle) / 2
    cosine = least / eccentricity
    meshes = cosine <= 1
    if not every(meshes):
        refuse("eccentricity", eccentricity, meshes, "no_mesh", limit=least, field="module")
    sine = np.sqrt((1 - cosine) * (1 + cosine))
    angle = np.arctan2(sine, cosine)
    steep = every(angle <= STEEP)
    return InvoluteMesh(
        _plain(sine / cosine),
        operating_pressure_angle=_plain(angle),
        error=8 * ROUNDING / float(np.square(np.maximum(sine, 1e-8)).min()),
        notices=() if steep else (Notice("steep_mesh"),),
    )


def cycloid_mesh(
    *,
    eccentricity: Number,
    ratio: Number,
    ring_pin_circle_radius: Number,
    difference: int | None = None,
) -> RingMesh:
    """Ratio of a ring of pins, negative: the force along the crank opposes that of the output pins.

    ``rho = -(2 - (1 - K^2)/K*ln((1 + K)/(1 - K)))/(pi*K)``, ``K = e*(u + 1)/R_ring``, derived for
    many ring pins that share like linear contacts; a drive of kubakos with 30 pins has -0.351049 by
    its sum and -0.343755 by this limit. `InvalidInput` is raised if K >= 1, as no such cycloid
    exists. A difference of ring pins and lobes above 1 gives a notice.

    >>> mesh = cycloid_mesh(eccentricity=2e-3, ratio=20.0, ring_pin_circle_radius=0.084)
    >>> round(mesh.radial_force_ratio, 7)
    -0.2241421
    """
    check_positive(
        eccentricity=eccentricity, ratio=ratio, ring_pin_circle_radius=ring_pin_circle_radius
    )
    k = np.asarray(eccentricity * (ratio + 1) / ring_pin_circle_radius, dtype=np.float64)
    shortened = k < 1
    if not every(shortened):
        than = {"field": "ratio", "limit": eccentricity * (ratio + 1)}
        name = "ring_pin_circle_radius"
        refuse(name, ring_pin_circle_radius, shortened, "no_cycloid", **than)
    orders = np.arange(1, TERMS)
    small = np.minimum(k, SERIES)[..., None]
    summed = 4 / np.pi * (small ** (2 * orders - 1) / (4 * orders**2 - 1)).sum(axis=-1)
    large = np.maximum(k, SERIES)
    closed = (2 - 2 * (1 - large) * (1 + large) / large * np.arctanh(large)) / (np.pi * large)
    crossed = (difference or 1) > 1
    return RingMesh(
        _plain(-np.where(k < SERIES, summed, closed)),
        64 * ROUNDING,
        (Notice("cycloid_difference", {"difference": difference}),) if crossed else (),
    )


def _plain(value: Number) -> Number:
    """Float of one design; arrays stay as they are."""
    return float(value) if np.ndim(value) == 0 else value
