"""A pin as a beam: moment, shear, deflection and slope under the satellites, for three supports.

Everything is per unit of a force that is spread evenly over the contact length b around the middle
plane z of its satellite. x is the distance from the face of the carrier at which the pin is held.
The moment is positive as that of a cantilever, the deflection in the direction of the force, and

    E*I*theta' = M,   w' = theta + k*V/(G*A),   V = -M',   k = 10/9

(Timoshenko's beam, the shear coefficient of Ovsyannikov et al. 2019; of a tube as in
`core.output.pin_section`). All four are polynomials
between the ends of the load, in forms that lose no digits where the load is short.
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
"""Held in the carrier at one end; at both, free to tilt; at both, built in; at one, with a tie ring
that joins the other ends (`core.output.tie_ring`), which as a beam is a cantilever."""


def check_apart(*, name: str, positions: Sequence[float], width: float) -> None:
    """Refuse satellites that reach into each other.

    Parameters
    ----------
    name : str
        Parameter of the places.
    positions : sequence of float
        Middle plane of each satellite along pin or shaft, m, in any order.
    width : float
        Width of each, m: the length of its contact.

    Raises
    ------
    InvalidInput
        If two places are nearer to each other than the width, but for what decimals lose.

    Examples
    --------
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
    """A round pin in its supports; x and z of its methods are those of the module, m."""

    support: Support
    contact_length: Number  # b of each load, m, > 0
    rigidity: Number  # E*I, N*m^2, > 0
    shear_area: Number  # k*E*I/(G*A), m^2, > 0: what shear adds
    span: Number = math.inf  # L of the two supports, m; infinite of a cantilever

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
        """A pin of one diameter.

        Parameters
        ----------
        support : {"cantilever", "supported", "fixed"}
            How it is held.
        diameter : float or array
            Diameter d, m, > 0.
        contact_length : float or array
            Length b of each load, m, > 0.
        youngs_modulus : float or array
            Young's modulus E, Pa, > 0.
        poissons_ratio : float or array
            Poisson's ratio.
        span : float or array
            Distance L of the two supports, m, > 0; not of a cantilever.
        bore_diameter : float or array
            Diameter of its bore, m, from 0 on, smaller than d.

        Returns
        -------
        PinBeam
        """
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
        """Whether nothing holds its other end."""
        return self.support == "cantilever"

    def _integral(self, times: Literal[1, 2, 3, 4], x: Number, z: Number) -> Number:
        """Integral of the load from 0 to x, so many times."""
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
    """Largest line load of a contact along a sloping pin, over its mean.

    ``K_b = 1 + s*b/(2*d)`` of a slope s and the approach d of a level contact; where that is above
    2 a part of the length does not touch, and ``K_b = sqrt(2*s*b/d)`` on ``2/K_b`` of the length.

    Parameters
    ----------
    slope : float or array
        Rotation of the pin's section in the middle of the contact, rad, >= 0.
    contact_length : float or array
        Length b of the contact, m, > 0.
    approach : float or array
        Approach of the contact under the same force without the slope, m, > 0.

    Returns
    -------
    float or array
        On the line load; the pressure grows with its root.

    Notes
    -----
    Derived for a line load in proportion to the approach; the form is that of K_Hbeta of ISO
    6336-1, with ``c' = w/d``. The wheel's own tilting and crowning are left out.

    Examples
    --------
    >>> face_load_factor(slope=1e-3, contact_length=0.02, approach=2e-5)
    1.5
    >>> face_load_factor(slope=8e-3, contact_length=0.02, approach=2e-5)
    4.0
    """
    check_not_negative(slope=slope)
    check_positive(contact_length=contact_length, approach=approach)
    steep = slope * contact_length / approach
    return where(steep <= 2.0, 1 + steep / 2, sqrt(2 * steep))


def section_stress(*, bending: Number, mean_shear: Number) -> Number:
    """Largest equivalent stress (Mises) of a round section in bending and shear.

    The shear stress is largest, 4/3 of its mean, where there is no bending. With the moment's
    stress m and ``v = sqrt(3)*4/3*V/A`` as vectors of the section it is
    ``sqrt((|m|^2 + |v|^2 + |m^2 - v^2|)/2)``, squares as of complex numbers: the larger of the two
    where they are parallel, the hypotenuse where they are at right angles.

    Parameters
    ----------
    bending : complex, float or array
        ``M/W``, Pa, in the direction of the force that makes it.
    mean_shear : complex, float or array
        ``V/A``, Pa, in its direction.

    Returns
    -------
    float or array
        Pa.

    Notes
    -----
    Derived with Jourawski's shear stress, at the edge along the edge: there, at the angle phi,
    ``s^2*cos^2(phi) + t^2*sin^2(phi - beta)``, whose largest value this is; inside it is less.

    Examples
    --------
    >>> round(section_stress(bending=50.0, mean_shear=40.0), 4)
    92.376
    """
    shear = math.sqrt(3) * 4 / 3 * mean_shear
    apart = abs(bending * bending - shear * shear)
    return ((abs(bending) ** 2 + abs(shear) ** 2 + apart) / 2) ** 0.5
