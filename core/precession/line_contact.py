"""Hertz pressure along the contact lines of the precessional gear."""

import math
from dataclasses import dataclass

from core.arrays import check_positive
from core.errors import Accuracy, InvalidInput, Notice
from core.fields import answer, answered
from core.hertz import HALF_WIDTH_RATIO_LIMIT, ElasticMaterial, effective_modulus
from core.precision import ROUNDING


@dataclass(frozen=True, slots=True, kw_only=True)
class LineContact:
    """Contact of a roller and a tooth where the line load is largest."""

    max_pressure: float = answer("MPa", "p₀")
    """Largest Hertz pressure."""
    half_width: float = answer("mm", "a")
    """Half-width of the contact."""
    reduced_radius: float = answer("mm", "ρ")
    """Reduced radius of curvature."""
    effective_modulus: float = answer("GPa", "E*")
    """Effective modulus."""
    roller_material: ElasticMaterial  # material of the roller
    mating_material: ElasticMaterial  # material of the tooth
    accuracy: Accuracy = answer()
    notices: tuple[Notice, ...]  # a notice if the contact is too wide for Hertz

    @property
    @answered("", "S", optional=True)
    def roller_safety(self) -> float:
        """Pressure limit of the roller's material over the largest pressure, if the limit is
        known.
        """
        return float(self.roller_material.known_limit.pressure) / self.max_pressure

    @property
    @answered("", "S", optional=True)
    def mating_safety(self) -> float:
        """Pressure limit of the satellite's material over the largest pressure, if the limit is
        known.
        """
        return float(self.mating_material.known_limit.pressure) / self.max_pressure


def line_contact(
    *,
    line_load: float,
    roller_radius: float,
    mating_radius: float,
    roller_material: ElasticMaterial,
    mating_material: ElasticMaterial,
    load_error: float = 0.0,
) -> LineContact:
    """Hertz contact of two cylinders: ``p0 = sqrt(q*E*/(pi*rho))``, ``a = sqrt(4*q*rho/(pi*E*))``.

    ``1/rho = 1/r + 1/r_m`` of roller and tooth. The curvature of the tooth is an input, as the
    source of the gear, Khatetovsky et al. 2020, gives none. Source of the contact: Johnson, Contact
    Mechanics, 4.2. The load q is in N/m, with its relative error. The radius of curvature r_m of
    the tooth across the line, m, is positive if convex, negative if the roller lies in a hollow,
    which has to be larger than the roller.

    Two equal steel cylinders touch like one of half the radius and a plane.

    >>> steel = ElasticMaterial(youngs_modulus=210e9, poissons_ratio=0.3)
    >>> found = line_contact(line_load=1e5, roller_radius=0.008, mating_radius=0.008,
    ...                      roller_material=steel, mating_material=steel)
    >>> round(found.reduced_radius, 6), round(found.max_pressure/1e6, 3)
    (0.004, 958.228)
    """
    check_positive(line_load=line_load, roller_radius=roller_radius)
    if not (mating_radius > 0 or -mating_radius > roller_radius):
        than = {"field": "roller_radius", "limit": roller_radius}
        raise InvalidInput("mating_radius", mating_radius, "larger_than", **than)
    together = mating_radius + roller_radius
    reduced = mating_radius / together * roller_radius
    modulus = float(effective_modulus(first=roller_material, second=mating_material))
    pressure = math.sqrt(line_load / reduced * modulus / math.pi)
    half_width = 2 * math.sqrt(line_load * reduced / math.pi / modulus)
    ratio = half_width / roller_radius
    condition = (abs(mating_radius) + roller_radius) / abs(together)
    wide = ratio > HALF_WIDTH_RATIO_LIMIT
    return LineContact(
        max_pressure=pressure,
        half_width=half_width,
        reduced_radius=reduced,
        effective_modulus=modulus,
        roller_material=roller_material,
        mating_material=mating_material,
        accuracy=Accuracy("closed_form", load_error / 2 + ROUNDING * (8 + condition), 1),
        notices=(Notice("hertz_line_width", {"ratio": ratio}),) if wide else (),
    )
