"""The force of the ring on a satellite: how much of it lies along the crank, and which way.

The part across the crank carries the torque. The part along it is `radial_force_ratio` times that,
positive in the direction of the force of the output pins on the satellite: to the reducer's axis.
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
"""K1 below which the cycloid's ratio is summed, as the closed form loses digits."""

TERMS = 30


@dataclass(frozen=True, slots=True)
class RingMesh:
    """The ratio rho of the ring's force along the crank to that across it."""

    radial_force_ratio: Number  # rho
    error: float = 0.0  # of rho, over the larger one of it and 1: large where an angle is small
    notices: tuple[Notice, ...] = ()

    @property
    def operating_pressure_angle(self) -> Number:
        """alpha_w of involute teeth, rad."""
        raise NotKnown("no_teeth")


@dataclass(frozen=True, slots=True)
class InvoluteMesh(RingMesh):
    """The same of involute teeth."""

    operating_pressure_angle: Number = field(kw_only=True)  # alpha_w, rad


def involute_mesh(
    *, module: Number, teeth_difference: Number, pressure_angle: Number, eccentricity: Number
) -> InvoluteMesh:
    """Involute teeth: the force along the crank has the direction of the pins' force.

    ``rho = tan(alpha_w)``, ``cos(alpha_w) = m*(z3 - z2)*cos(alpha)/(2*e)``.

    Parameters
    ----------
    module : float or array
        Module m, m, > 0.
    teeth_difference : float or array
        ``z3 - z2``, > 0.
    pressure_angle : float or array
        Reference pressure angle alpha, rad.
    eccentricity : float or array
        Eccentricity e, m, > 0.

    Returns
    -------
    InvoluteMesh
        With a positive ratio.

    Raises
    ------
    InvalidInput
        If the base circles do not leave room for the eccentricity: the teeth cannot mesh.

    Examples
    --------
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
    """A ring of pins: the force along the crank opposes that of the satellite's pins.

    ``rho = -(2 - (1 - K^2)/K*ln((1 + K)/(1 - K)))/(pi*K)``, ``K = e*(u + 1)/R_ring``, for many pins
    that share as linear contacts do.

    Parameters
    ----------
    eccentricity : float or array
        Eccentricity e, m, > 0.
    ratio : float or array
        Ratio u, > 0.
    ring_pin_circle_radius : float or array
        Radius of the circle of the ring's pins, m, above ``e*(u + 1)``.
    difference : int, optional
        Pins of the ring less lobes of a satellite; above 1 it has a notice.

    Returns
    -------
    RingMesh
        With a negative ratio.

    Raises
    ------
    InvalidInput
        If K is not below 1: there is no such cycloid.

    Notes
    -----
    Derived; a drive of kubakos with 30 pins has -0.351049 by its sum, -0.343755 by this limit.

    Examples
    --------
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
    """A number where there is one design."""
    return float(value) if np.ndim(value) == 0 else value
