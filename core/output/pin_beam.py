"""A pin as a beam: moment, shear, deflection and slope under the discs, for several supports.

All results are for a unit force spread evenly over the contact length b around the middle plane z
of its disc. x is the distance from the face of the carrier that holds the pin. The moment is
positive in the sense of a cantilever's, the deflection in the direction of the force, with

    E*I*theta' = M,   w' = theta + k*V/(G*A),   V = -M',   k = 10/9

(Timoshenko's beam, shear coefficient of Ovsyannikov et al. 2019; for a tube see
`core.output.pin_section`). Moment, shear force, slope and deflection are polynomials between the
ends of the load, in forms that lose no digits for a short load.

The face load factor is derived for a line load w in proportion to the approach d. The form is that
of K_Hbeta of ISO 6336-1 with ``c' = w/d``; tilting and crowning of the disc are left out.

The stress of a section follows from Jourawski's shear stress along the edge. With the bending
stress s and ``t = sqrt(3)*4/3*V/A`` the squared equivalent stress at the edge angle phi is
``s^2*cos^2(phi) + t^2*sin^2(phi - beta)``; inside the section it is less.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Literal

from core.arrays import (
    Number,
    check_not_negative,
    check_positive,
    larger,
    smaller,
    sqrt,
    where,
)
from core.errors import InvalidInput
from core.output.pin_section import PinSection
from core.precision import ROUNDING

Support = Literal["cantilever", "supported", "fixed", "tie_ring"]
"""Support of a pin in the carrier: at one end; at both, free to tilt; at both, built in; at one,
with a tie ring that joins the other ends (`core.output.tie_ring`), which makes it a cantilever as a
beam.
"""


def check_apart(*, name: str, positions: Sequence[float], width: float) -> None:
    """Refuse discs whose middle planes along the pin or shaft, m, in any order, are nearer than
    `width`.

    `name` is the parameter in the refusal; rounding of decimals is allowed for.

    >>> check_apart(name="positions", positions=(0.037, 0.015), width=0.022)
    >>> check_apart(name="positions", positions=(0.037, 0.015), width=0.023)
    Traceback (most recent call last):
    core.errors.InvalidInput: positions[1] = 0.015 must be at least contact_length, 0.023, from ...
    """
    order = sorted(range(len(positions)), key=lambda index: positions[index])
    for pair in pairwise(order):
        one, other = (positions[index] for index in pair)
        if other - one < width - 4 * ROUNDING * (width + abs(one) + abs(other)):
            places = {"field": "contact_length", "limit": width}
            raise InvalidInput(f"{name}[{max(pair)}]", positions[max(pair)], "too_near", **places)


@dataclass(frozen=True, slots=True)
class PinBeam:
    """Round pin in its supports; x and z are distances from the carrier's face, m."""

    support: Support
    contact_length: Number  # b of each load, m, > 0
    rigidity: Number  # E*I, N*m^2, > 0
    shear_area: Number  # k*E*I/(G*A), m^2, > 0: share of shear in the deflection
    span: Number = math.inf  # L between the supports, m; infinite for a cantilever

    @classmethod
    def round(
        cls,
        *,
        support: Support,
        diameter: Number,
        contact_length: Number,
        youngs_modulus: Number,
        poissons_ratio: Number,
        span: Number = math.inf,
        bore_diameter: Number = 0.0,
    ) -> "PinBeam":
        """Pin of one diameter, m, solid or with a bore; a cantilever has no span."""
        check_positive(
            diameter=diameter,
            contact_length=contact_length,
            youngs_modulus=youngs_modulus,
            span=span,
        )
        section = PinSection(diameter, bore_diameter)
        # I/A = (d^2 + d_i^2)/16, E/G = 2*(1 + v)
        turned = section.shear_coefficient(poissons_ratio) * (1 + poissons_ratio)
        shear = turned * (diameter**2 + bore_diameter**2) / 8
        return cls(support, contact_length, youngs_modulus * section.inertia, shear, span)

    @property
    def rooted(self) -> bool:
        """True if nothing holds the pin's other end."""
        return self.support == "cantilever"

    def _integral(self, times: Literal[1, 2, 3, 4], x: Number, z: Number) -> Number:
        """Integral of the load from 0 to x, repeated 1 to 4 times."""
        b, half = self.contact_length, self.contact_length / 2
        y = x - z
        into = smaller(larger(y + half, 0.0), b)
        if times == 1:
            return into / b
        if times == 2:
            after, inside = y, into * into / (2 * b)
        elif times == 3:
            after, inside = y * y / 2 + half * half / 6, into**3 / (6 * b)
        else:
            after, inside = y * (y * y + half * half) / 6, into**4 / (24 * b)
        return where(y >= half, after, inside)

    def reactions(self, z: Number) -> tuple[Number, Number]:
        """Shear force, dimensionless, and moment, m, at x = 0 under a unit force at z."""
        if self.support in ("cantilever", "tie_ring"):
            return 1.0 + 0.0 * z, 1.0 * z
        length = self.span
        if self.support == "supported":
            return (length - z) / length, 0.0 * z
        half = self.contact_length / 2
        y = length - z
        third = y * y / 2 + half * half / 6
        fourth = y * (y * y + half * half) / 6
        shear = (third * length / 2 - fourth + self.shear_area * y) / (
            length**3 / 12 + self.shear_area * length
        )
        return shear, shear * length / 2 - third / length

    def moment(self, x: Number, z: Number) -> Number:
        """Bending moment at x under a unit force at z, m, positive as a cantilever's."""
        shear, moment = self.reactions(z)
        return moment - shear * x + self._integral(2, x, z)

    def shear(self, x: Number, z: Number) -> Number:
        """Shear force at x under a unit force at z, dimensionless."""
        return self.reactions(z)[0] - self._integral(1, x, z)

    def slope(self, x: Number, z: Number) -> Number:
        """Rotation of the section at x under a unit force at z, rad/N."""
        shear, moment = self.reactions(z)
        bent = moment * x - shear * x * x / 2 + self._integral(3, x, z)
        return (bent + self._start(z)) / self.rigidity

    def deflection(self, x: Number, z: Number) -> Number:
        """Deflection at x under a unit force at z, m/N."""
        shear, _ = self.reactions(z)
        sheared = self.shear_area * (shear * x - self._integral(2, x, z))
        return (self._bent(x, z) + self._start(z) * x + sheared) / self.rigidity

    def _bent(self, x: Number, z: Number) -> Number:
        """E*I times the deflection at x by bending, without the rotation at 0."""
        shear, moment = self.reactions(z)
        return moment * x * x / 2 - shear * x**3 / 6 + self._integral(4, x, z)

    def _start(self, z: Number) -> Number:
        """E*I times the rotation at 0; shear does not turn a pin that is free to tilt."""
        if self.support != "supported":
            return 0.0
        return -self._bent(self.span, z) / self.span


def face_load_factor(*, slope: Number, contact_length: Number, approach: Number) -> Number:
    """Largest line load of a contact along a pin of slope s over its mean: ``K_b = 1 + s*b/(2*d)``.

    The approach d is that of a level contact, m. Above ``K_b = 2`` only ``2/K_b`` of the length b
    touches, with ``K_b = sqrt(2*s*b/d)``. The pressure grows with the root of K_b.
    """
    check_not_negative(slope=slope)
    check_positive(contact_length=contact_length, approach=approach)
    steep = slope * contact_length / approach
    return where(steep <= 2.0, 1 + steep / 2, sqrt(2 * steep))


def section_stress(*, bending: Number, mean_shear: Number) -> Number:
    """Largest equivalent stress (Mises) of a round section, Pa:
    ``sqrt((|s|^2 + |t|^2 + |s^2 - t^2|)/2)``.

    s is the bending stress ``M/W`` in the direction of the force that makes it, and
    ``t = sqrt(3)*4/3`` times the mean shear stress ``V/A``, both as complex numbers in the plane of
    the section.
    """
    shear = math.sqrt(3) * 4 / 3 * mean_shear
    apart = abs(bending * bending - shear * shear)
    return ((abs(bending) ** 2 + abs(shear) ** 2 + apart) / 2) ** 0.5
