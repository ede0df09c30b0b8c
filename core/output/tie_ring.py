"""Floating tie ring: a rigid ring that joins the free ends of the pins and that only they hold.

The ring lies in a plane at the distance L from the carrier's face. It moves in this plane by U and
turns by w about the axis; it cannot tilt, as the pins keep their length. The force of the ring on
pin n, under the forces of the discs at z_j, all as complex numbers, is

    X_n = (U + w*R*t_n - sum_j F_jn*a(z_j))/f,   f = a(L),   sum X = 0,   sum Re(X*conj(t)) = 0

with the tangential direction t_n and the deflection a(z) of the pin's end under a unit force at z:
of a cantilever if the ring is pinned to the pins, and of a pin whose end cannot slope if it is
clamped. A ring on equally loaded pins turns with them and carries nothing. The movement of the ring
is the one with the least energy in the pins: of equal pins the mean movement of their ends, and
along the circle the mean of the tangential parts. Derived.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from core.arrays import ComplexArray, FloatArray, Number, larger, smaller

RingJoint = Literal["pinned", "clamped"]
"""Joint of the ring to the pins' ends: free to turn, or clamped."""


@dataclass(frozen=True, slots=True)
class TieRing:
    """Tie ring as one pin feels it."""

    joint: RingJoint  # joint of the ring to the pins
    span: float  # L of its middle from the carrier's face, m, > 0
    rigidity: float  # E*I of the pin, N*m^2, > 0
    shear_area: float  # k*E*I/(G*A) of the pin, m^2, > 0: share of shear

    def flexibility(self, x: Number, z: Number) -> Number:
        """Deflection at x under a unit force at z, m/N, of a pin whose end the ring does not hold.

        x and z are distances from the carrier's face, m, up to the span. A clamped end keeps its
        slope 0.
        """
        near, far = smaller(x, z), larger(x, z)
        bent = near * near * (3 * far - near) / 6
        if self.joint == "clamped":
            bent = bent - (x * z) ** 2 / (4 * self.span)
        return (bent + self.shear_area * near) / self.rigidity

    def end(self, z: Number) -> Number:
        """Deflection a(z) of the pin's end under a unit force at z, m/N."""
        return self.flexibility(z, self.span)

    def end_moment(self, z: Number) -> Number:
        """Moment of the ring on the pin's end under a unit force at z, m, for a slope of 0."""
        return -z * z / (2 * self.span) if self.joint == "clamped" else 0.0 * z


class RingForces(NamedTuple):
    """Forces and movement of a tie ring at m positions."""

    forces: ComplexArray  # X of the ring on each pin, N, tangential + i*radial, shape (N, m)
    shift: ComplexArray  # U of the ring's middle, m, shape (m,)
    along: FloatArray  # w*R, movement along the circle of the pins, m, shape (m,)


def ring_forces(
    *, rings: Sequence[TieRing], positions: Sequence[float], forces: ComplexArray
) -> RingForces:
    """Forces of a tie ring on its N evenly spaced pins, and the movement of the ring.

    The K middle planes of the discs are distances from the carrier's face, m. Forces on the pins
    have the shape (K, N, m), N, tangential + i*radial. `rings` is the ring as each pin feels it.
    """
    pins = len(rings)
    along = -np.exp(2j * np.pi * np.arange(pins) / pins)
    each = np.array([[ring.end(z) for ring in rings] for z in positions])
    ends = along[:, None] * np.conj((each[:, :, None] * forces).sum(axis=0))
    stiff = np.array([1 / ring.end(ring.span) for ring in rings])
    # least squares of the ends' movements, weighted by the roots of the stiffnesses
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
