"""Section of a round pin, solid or bored: area, modulus, shear, and the wall about its bore.

With the diameter d, the bore's d_i and ``m = d_i/d`` all is that of a tube; of a bore of 0 exactly
that of a solid pin.
"""

import math
from dataclasses import dataclass

from core.arrays import Number, log, where
from core.errors import InvalidInput

MOST_BORE = 0.95
"""Largest bore over the diameter that a pin is calculated of."""

WALL_BORE = 0.3
"""Bore over the diameter from which the wall about it counts: below, the pin is as a solid one."""

SHEAR_COEFFICIENT = 10 / 9
"""Shear coefficient k of a solid round section (Ovsyannikov et al. 2019)."""

UNDER_LOAD = 3 / (4 * math.pi)
"""Bending moment of the wall under the load, over the line load times the middle radius."""

GIVES = (math.pi**2 / 12 - 11 / 16) / math.pi
"""How much the wall gives under the load, over ``w*R_m^3/(E'*I)`` of a line load w."""


def check_bore(*, bore_diameter: float, diameter: float) -> None:
    """Refuse a bore that leaves no pin.

    Parameters
    ----------
    bore_diameter, diameter : float
        Diameters of the bore and of the pin, m.

    Raises
    ------
    InvalidInput
        If the bore is below 0, or above `MOST_BORE` of the pin.
    """
    if not bore_diameter >= 0:
        raise InvalidInput("bore_diameter", bore_diameter, "greater_than_equal", limit=0)
    most = MOST_BORE * diameter
    if not bore_diameter <= most:
        raise InvalidInput("bore_diameter", bore_diameter, "less_than_equal", limit=most)


@dataclass(frozen=True, slots=True)
class PinSection:
    """Section of a pin."""

    diameter: Number  # d, m, > 0
    bore_diameter: Number = 0.0  # d_i, m, from 0 to 0.95 d

    @property
    def area(self) -> Number:
        """Area A, m^2."""
        return math.pi * (self.diameter**2 - self.bore_diameter**2) / 4

    @property
    def inertia(self) -> Number:
        """Second moment of area I, m^4."""
        return math.pi * (self.diameter**4 - self.bore_diameter**4) / 64

    @property
    def modulus(self) -> Number:
        """Section modulus ``W = 2*I/d``, m^3."""
        return math.pi * (self.diameter**3 - self.bore_diameter**4 / self.diameter) / 32

    def shear_coefficient(self, poissons_ratio: Number) -> Number:
        """Shear coefficient k of Timoshenko's beam: by Cowper's of a tube over his of a solid one.

        ``kappa = 6*(1 + v)*(1 + m^2)^2/((7 + 6*v)*(1 + m^2)^2 + (20 + 12*v)*m^2)``

        Parameters
        ----------
        poissons_ratio : float or array
            Poisson's ratio v.

        Returns
        -------
        float or array
            Of a solid pin 10/9, of a thin tube of steel 1.86.

        Notes
        -----
        Cowper 1966 as it is known; recomputed from Saint-Venant's flexure of a tube.

        Examples
        --------
        >>> round(PinSection(0.016, 0.010).shear_coefficient(0.3), 6)
        1.713015
        """
        square = (self.bore_diameter / self.diameter) ** 2
        around = (1 + square) ** 2
        more = (20 + 12 * poissons_ratio) * square / ((7 + 6 * poissons_ratio) * around)
        return SHEAR_COEFFICIENT * (1 + more)

    @property
    def shear_area(self) -> Number:
        """Area over which a shear force has 3/4 of its largest stress as its mean, m^2: that of a
        solid pin, nearly 2/3 of it of a thin tube.
        """
        outer, inner = self.diameter, self.bore_diameter
        return self.area / (1 + outer * inner / (outer**2 + inner**2))

    @property
    def walled(self) -> bool:
        """Whether the bore is so large that the wall about it counts; of one pin."""
        return bool(self.bore_diameter >= WALL_BORE * self.diameter)

    @property
    def _wall(self) -> tuple[Number, Number]:
        """Thickness and middle radius of the wall, m."""
        return (
            (self.diameter - self.bore_diameter) / 2,
            (self.diameter + self.bore_diameter) / 4,
        )

    def wall_stress(self, *, line_load: Number) -> Number:
        """Largest bending stress of the wall, at the bore under the load.

        A line load on a ring that is held by the shear flow of the pin as a beam bends it by
        ``M = w*R_m*(1/2 + cos(a)/4 - (pi - a)/2*sin(a))/pi``: most under the load, 3/(4*pi). The
        stress is that of a curved beam, ``M*(t/2 - s)/(t*s*r_i)``, ``s = R_m - t/ln(r_o/r_i)``.

        Parameters
        ----------
        line_load : float or array
            Force of the satellite over the length on which it presses, w, N/m.

        Returns
        -------
        float or array
            Pa.

        Notes
        -----
        Derived. Above the exact stress of plane elasticity by 1.5 % for a bore of 0.9 of the
        diameter, 6 % of 0.7, 16 % of 0.5, 37 % of 0.3: the thinner the wall, the nearer; a thin
        ring's ``6*M/t^2`` would be below it.

        Examples
        --------
        >>> round(PinSection(0.016, 0.010).wall_stress(line_load=1e4/3/0.020)/1e6, 3)
        203.674
        """
        thick, middle = self._wall
        inner = self.bore_diameter / 2
        shifted = middle - thick / log(self.diameter / self.bore_diameter)
        moment = UNDER_LOAD * line_load * middle
        return moment * (thick / 2 - shifted) / (thick * shifted * inner)

    def wall_compliance(
        self, *, contact_length: Number, youngs_modulus: Number, poissons_ratio: Number
    ) -> Number:
        """How much the wall gives under a force of a satellite; 0 where it does not count.

        ``(pi^2/12 - 11/16)/pi*12*(1 - v^2)*R_m^3/(E*t^3*b)``

        Parameters
        ----------
        contact_length : float or array
            Length b on which the force presses, m, > 0.
        youngs_modulus : float or array
            Young's modulus E of the pin, Pa.
        poissons_ratio : float or array
            Poisson's ratio v.

        Returns
        -------
        float or array
            m/N.

        Examples
        --------
        >>> tube = PinSection(0.016, 0.014)
        >>> give = tube.wall_compliance(
        ...     contact_length=0.02, youngs_modulus=210e9, poissons_ratio=0.3)
        >>> round(give*1e6, 6)
        0.047123
        """
        thick, middle = self._wall
        bent = GIVES * 12 * (1 - poissons_ratio**2) * (middle / thick) ** 3
        counts = self.bore_diameter >= WALL_BORE * self.diameter
        return where(counts, bent / (youngs_modulus * contact_length), 0.0)
