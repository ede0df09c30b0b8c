"""Contact of pins in holes as a section of the design document: sizes, clearance, materials."""

import re
from dataclasses import dataclass
from typing import Any, ClassVar, Literal, NamedTuple, Self

from core.design.tolerances import class_pattern
from core.errors import InvalidInput
from core.fields import Rule, optional_size, quantity
from core.hertz import ElasticMaterial
from core.output.mechanism import felt
from core.precision import SAME
from core.tolerance.iso286 import SIZES, fit_clearance

SharedBy = Literal["discs", "pins"]
"""Origin of an uneven share that a load-sharing factor states: satellites ("discs"), or pins of one
satellite."""

LEAST_CLEARANCE = 1e-9
"""Least clearance or interference other than 0, m, as none smaller is made or measured."""


class PairSizes(NamedTuple):
    """Sizes of a pair of pin and hole, m."""

    contact_length: float  # b
    pin_radius: float  # r_in
    hole_radius: float  # r_out


USUAL_FITS = ("H7/g6", "H7/h6", "H7/f7", "H8/h7", "H8/f7", "H8/f8", "H9/f9")
"""Fits that a form offers."""

FIT = f"{class_pattern(of_pins=False)}/{class_pattern(of_pins=True)}"
"""Form of a fit."""


@dataclass(frozen=True, slots=True, kw_only=True)
class StatedClearance:
    """Inputs from which the hole follows."""

    hole_clearance: float | None = quantity(
        "Clearance", "c", "mm", default=None, step=0.005, ge=-1e6, le=1e6
    )
    """Radial clearance: hole radius − pin radius − eccentricity. A negative value is interference,
    and 0 means perfect parts. Forces and stresses depend on it more than on most sizes."""
    fit: str | None = quantity("Fit", default=None, pattern=FIT, options=USUAL_FITS)
    """ISO 286 classes of hole and pin (or sleeve), such as H7/f7, given instead of the clearance,
    which is half of the mean clearance of the two diameters."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Contact:
    """Crank, pin, hole and their materials; a crank alone has an eccentricity. Any two of hole
    radius, eccentricity and clearance determine the third.
    """

    FOLLOWS_FROM: ClassVar[Any] = StatedClearance
    BETWEEN: ClassVar[tuple[Rule, ...]] = (
        Rule("hole_radius", "only_one", "fit"),
        Rule("hole_clearance", "only_one", "fit"),
        Rule("eccentricity", "needed_beside", "fit"),
        Rule("eccentricity", "needed_beside", "hole_clearance"),
        Rule("hole_radius", "needed", "eccentricity"),
    )

    contact_length: float | None = optional_size("Contact length", "b", "mm", step=1)
    """Length of the contact along the pin, which is the width of the satellite."""
    pin_radius: float | None = optional_size("Pin radius", "r_in", "mm", step=0.5)
    """Radius of the pin, or of its sleeve."""
    hole_radius: float | None = optional_size("Hole radius", "r_out", "mm", step=0.5)
    """Radius of the hole in the satellite: pin radius + eccentricity."""
    eccentricity: float | None = optional_size("Eccentricity", "e", "mm", step=0.5)
    """Eccentricity of the cranks; the default, where there is one, is hole radius − pin radius."""
    pin_material: ElasticMaterial | None = quantity("Pin material", default=None)
    """Name in the table of materials, or values."""
    hole_material: ElasticMaterial | None = quantity("Hole material", default=None)
    """Name in the table of materials, or values."""
    distribution_factor: float = quantity(
        "Distribution factor", "K_α", default=1.0, step=0.05, ge=1, le=1e12
    )
    """Factor on the largest force for uneven sharing between satellites or pins, in all results of
    that force. Torque, loss and efficiency follow from all forces together."""
    distribution_of: SharedBy | None = quantity("Uneven share of", default=None, advanced=True)
    """Parts among which the load-sharing factor states uneven sharing. Satellites: one satellite
    carries this multiple of its even share of the torque, at most all of it, and the others carry
    the rest evenly. Pins: the sharing is uneven among the pins of each satellite, and bearings do
    not feel it. The default is satellites if there are several, else pins."""
    clearance_stated: bool = False  # True if a clearance is stated, which may be 0
    iso_fit: str = ""  # fit of the clearance, such as H7/f7; empty if stated as a number

    @classmethod
    def sized(
        cls,
        *,
        pin_radius: float | None = None,
        hole_radius: float | None = None,
        eccentricity: float | None = None,
        hole_clearance: float | None = None,
        fit: str | None = None,
        **others: object,
    ) -> Self:
        """Contact whose hole follows from pin, eccentricity and clearance if it is not given.

        A radial clearance, m, is negative for interference. If none is given, the mean clearance of
        the fit, ISO 286 classes of hole and pin, is taken. `InvalidInput` is raised if the fit does
        not exist for the sizes, hole and clearance disagree, or the clearance is smaller than any
        that is made.
        """
        pin, crank = pin_radius or 0.0, eccentricity or 0.0
        clearance = hole_clearance if fit is None else _of_fit(fit, pin, crank)
        follows = pin + crank + (clearance or 0.0)
        hole = follows if hole_radius is None and pin_radius is not None else hole_radius
        stated = clearance is not None
        if stated and hole_radius is not None and abs(hole_radius - follows) > SAME * hole_radius:
            raise InvalidInput("contact.hole_radius", hole_radius, "hole_disagrees", limit=follows)
        found = cls(
            pin_radius=pin_radius,
            hole_radius=hole,
            eccentricity=eccentricity,
            clearance_stated=stated,
            iso_fit=fit or "",
            **others,  # type: ignore[arg-type]
        )
        if 0 < abs(found.clearance or 0.0) < LEAST_CLEARANCE * (1 - SAME):
            name = "hole_radius" if hole_clearance is None else "hole_clearance"
            limit = {"limit": LEAST_CLEARANCE}
            raise InvalidInput(f"contact.{name}", found.clearance, "clearance_dust", **limit)
        return found

    @property
    def clearance(self) -> float | None:
        """Radial clearance, m, negative for interference; None without pin or eccentricity."""
        pin, hole, crank = self.pin_radius, self.hole_radius, self.eccentricity
        if pin is None or hole is None or crank is None:
            return None
        return felt(clearance=hole - (pin + crank), hole_radius=hole)

    @property
    def clearance_unknown(self) -> bool:
        """True if pin and eccentricity are given, but neither a clearance nor a hole with one."""
        return self.clearance == 0 and not self.clearance_stated


def _of_fit(fit: str, pin: float, eccentricity: float) -> float:
    """Mean radial clearance of a fit of a pin and a hole of pin plus eccentricity, m."""
    if not re.fullmatch(FIT, fit):
        raise InvalidInput("contact.fit", fit, "no_fit")
    hole = pin + eccentricity
    if 2 * hole > SIZES[-1] / 1e3:
        limit = SIZES[-1] / 1e3
        raise InvalidInput("contact.fit", fit, "no_class_of_size", limit_mm=limit)
    return fit_clearance(fit=fit, hole_diameter=2 * hole, pin_diameter=2 * pin)
