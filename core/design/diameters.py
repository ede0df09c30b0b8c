"""Diameters of pins and holes with their limits, and which of them is drawn."""

from typing import Literal, NamedTuple

from core.design.document import Design
from core.design.tolerances import ToleranceSection
from core.errors import InvalidInput
from core.tolerance.iso286 import Limits

Sizes = Literal["nominal", "mean"]
"""Diameters that are drawn: the nominal ones, or the middle of their limits."""

Part = Literal["hole", "pin", "ring_pin"]
"""Part whose diameter may have limits; the pin is its sleeve or roller where that is touched."""


class Diameter(NamedTuple):
    """Diameter of a part."""

    nominal: float  # m
    limits: Limits | None  # limit deviations, None if none are stated
    tolerance_class: str | None  # ISO 286 class that they follow from

    def drawn(self, sizes: Sizes) -> float:
        """Diameter as it is drawn, m."""
        if self.limits is None or sizes == "nominal":
            return self.nominal
        return self.nominal + (self.limits.lower + self.limits.upper) / 2


def diameter_of(design: Design, *, part: Part) -> Diameter:
    """Diameter of a part with the limits of the fit, the tolerances or the process of a design. The
    classes of a fit are those of the pin and of a hole of pin plus eccentricity.

    Raises NotKnown if the size is not known, InvalidInput if the class has no such size or nothing
    is left at the lower limit.
    """
    fit = design.contact.iso_fit if design.contact else ""
    tolerances = design.tolerances or ToleranceSection()
    stated = getattr(tolerances.filled(fit), f"{part}_diameter")
    if part == "ring_pin":
        nominal = 2 * design.cycloid.known_pin_radius
    elif part == "pin":
        nominal = 2 * design.nominal_pair.pin_radius
    elif fit:
        nominal = 2 * (design.nominal_pair.pin_radius + design.known_eccentricity)
    else:
        nominal = 2 * design.nominal_pair.hole_radius
    if stated is None:
        return Diameter(nominal, None, None)
    path = f"tolerances.{part}_diameter"
    spread = stated.of_radius(nominal, path)
    if not nominal + 2 * spread.lower > 0:
        raise InvalidInput(f"{path}.lower", 2 * spread.lower, "greater_than", limit=-nominal)
    limits = Limits(2 * spread.lower, 2 * spread.upper)
    return Diameter(nominal, limits, stated.tolerance_class)
