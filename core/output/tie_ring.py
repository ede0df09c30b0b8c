"""A floating tie ring: a rigid ring that joins the free ends of the pins and is held by them alone.

The ring lies in a plane at the distance L from the carrier's face. It moves in this plane by U and
turns by w about the axis; it cannot tilt, as the pins keep their length. Of pin n, with the forces
of its satellites at z_j, all as complex numbers,

    X_n = (U + w*R*t_n - sum_j F_jn*a(z_j))/f,   f = a(L),   sum X = 0,   sum Re(X*conj(t)) = 0

is the force of the ring on it, t_n the tangential direction there and a(z) the deflection of the
end under a unit force at z: of a cantilever where the ring is pinned to the pins, of a pin whose
end cannot slope where it is clamped. Where all pins are loaded alike the ring turns with them and
carries nothing: it evens out, and does not hold.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from core.arrays import ComplexArray, FloatArray, Number, larger, smaller

RingJoint = Literal["pinned", "clamped"]
"""The pins' ends turn freely in the ring, or are clamped in it."""


@dataclass(frozen=True, slots=True)
class TieRing:
    """What a tie ring is to one pin."""

    joint: RingJoint  # to the pins
    span: float  # L of its middle from the carrier's face, m, > 0
    rigidity: float  # E*I of the pin, N*m^2, > 0
    shear_area: float  # k*E*I/(G*A) of the pin, m^2, > 0: what shear adds

    def flexibility(self, x: Number, z: Number) -> Number:
        """Deflection at x under a unit force at z, m/N, while nothing holds the end.

        Parameters
        ----------
        x, z : float or array
            Distances from the carrier's face, m, up to the span.

        Returns
        -------
        float or array
        """
        near, far = smaller(x, z), larger(x, z)
        bent = near * near * (3 * far - near) / 6
        if self.joint == "clamped":
            bent = bent - (x * z) ** 2 / (4 * self.span)
        return (bent + self.shear_area * near) / self.rigidity

    def end(self, z: Number) -> Number:
        """Deflection of the end under a unit force at z, a(z), m/N."""
        return self.flexibility(z, self.span)

    def end_moment(self, z: Number) -> Number:
        """Moment of the ring on the end under a unit force at z, m; it keeps the end's slope 0."""
        return -z * z / (2 * self.span) if self.joint == "clamped" else 0.0 * z


class RingForces(NamedTuple):
    """What a tie ring does under the forces of the satellites, m positions."""

    forces: ComplexArray  # X of the ring on each pin, N, tangential + i*radial, shape (N, m)
    shift: ComplexArray  # U of its middle, m, shape (m,)
    along: FloatArray  # w*R, how far it moves along the circle of the pins, m, shape (m,)


def ring_forces(
    *, rings: Sequence[TieRing], positions: Sequence[float], forces: ComplexArray
) -> RingForces:
    """Forces of a tie ring on its pins, and how it moves.

    Parameters
    ----------
    rings : sequence of TieRing
        The ring as each of the N pins, evenly spaced, feels it; they may differ.
    positions : sequence of float
        Middle plane z of each satellite from the carrier's face, m, K values.
    forces : array, shape (K, N, m)
        Forces on the pins, N, tangential + i*radial of each.

    Returns
    -------
    RingForces

    Notes
    -----
    Derived: the movement of the ring is the one with the least energy in the pins. Of equal pins it
    is the mean of their ends' movements, along the circle that of their tangential parts. The ring
    of a single pin follows it.

    Examples
    --------
    One of six pins is loaded: two thirds of what would hold its end, as the others give.

    >>> ring = TieRing("pinned", span=0.052, rigidity=675.6, shear_area=4.6e-5)
    >>> load = np.zeros((1, 6, 1), dtype=complex)
    >>> load[0, 0] = 1000.0
    >>> found = ring_forces(rings=[ring]*6, positions=(0.037,), forces=load)
    >>> part = ring.end(0.037)/ring.end(0.052)
    >>> bool(np.isclose(-found.forces[0, 0], 1000*part*(1 - 2/6)))
    True
    """
    pins = len(rings)
    along = -np.exp(2j * np.pi * np.arange(pins) / pins)
    each = np.array([[ring.end(z) for ring in rings] for z in positions])
    ends = along[:, None] * np.conj((each[:, :, None] * forces).sum(axis=0))
    stiff = np.array([1 / ring.end(ring.span) for ring in rings])
    # movements of the ends by those of the ring, weighted by the roots of the stiffnesses
    ones, root = np.ones(pins), np.sqrt(stiff)
    by_ring = np.block(
        [[ones[:, None], 0 * ones[:, None], along.real[:, None]],
         [0 * ones[:, None], ones[:, None], along.imag[:, None]]]
    )  # fmt: skip
    weights = np.concatenate((root, root))[:, None]
    moved = np.linalg.pinv(weights * by_ring) @ (weights * np.concatenate((ends.real, ends.imag)))
    shift = moved[0] + 1j * moved[1]
    held: NDArray[Any] = (shift + along[:, None] * moved[2] - ends) * stiff[:, None]
    return RingForces(np.conj(held / along[:, None]), shift, moved[2])
