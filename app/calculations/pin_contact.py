"""Pin, hole and crank with their clearance, as a request gives them: what follows from what."""

import re
from collections.abc import Iterator
from decimal import Decimal
from functools import cached_property
from typing import Annotated, Any, ClassVar, Self

from pydantic import Field, model_validator

from app.calculations.hertz import (
    ContactFields,
    contact_length,
    distribution_factor,
    eccentricity,
    hole_radius,
    material_of,
    pin_radius,
)
from app.model import Maybe, Size, quantity
from app.rules import Rule, field_error
from app.units import to_si
from core.design.sections import Contact, SharedBy
from core.output.pin_geometry import felt
from core.results import Notice
from core.tolerance.iso286 import CLASSES, GRADES, SIZES, fit_clearance

Deviation = Annotated[float, Field(ge=-1e6, le=1e6)]

RADII = ("pin_radius_mm", "eccentricity_mm", "stated_clearance_mm")
"""What the radius of the hole is the sum of."""


def class_pattern(of_pins: bool) -> str:
    """Pattern of the ISO 286 classes of pins, or of holes."""
    letters = "|".join(each for each in CLASSES if each.islower() == of_pins)
    return f"({letters})({'|'.join(map(str, GRADES))})"


USUAL_FITS = ["H7/g6", "H7/h6", "H7/f7", "H8/h7", "H8/f7", "H8/f8", "H9/f9"]
"""What the form offers."""

FIT = f"^{class_pattern(False)}/{class_pattern(True)}$"


class PinContactFields(ContactFields, group="contact"):
    """Pin, hole, crank and clearance: of hole radius, eccentricity and clearance any two say the
    third.
    """

    BETWEEN: ClassVar[tuple[Rule, ...]] = (
        Rule("hole_radius_mm", "only_one", "fit"),
        Rule("hole_clearance_mm", "only_one", "fit"),
        Rule("eccentricity_mm", "needed_beside", "fit"),
        Rule("eccentricity_mm", "needed_beside", "hole_clearance_mm"),
        Rule("hole_radius_mm", "needed", "eccentricity_mm"),
    )

    hole_radius_mm: Maybe[Size] = hole_radius()  # type: ignore[assignment]
    eccentricity_mm: Maybe[Size] = eccentricity()
    hole_clearance_mm: Maybe[Deviation] = quantity("Clearance", "c", step=0.005)
    """Radial clearance: hole radius − pin radius − eccentricity; negative is interference, and 0
    says that perfect parts are meant. Forces and stresses hang on it more than on most sizes."""
    fit: Maybe[str] = quantity("Fit", schema={"pattern": FIT, "x-options": USUAL_FITS})
    """ISO 286 classes of the hole and of what touches it, as H7/f7, instead of the clearance: half
    of the mean clearance of the two diameters."""
    distribution_factor: float = distribution_factor(ge=1, le=1e12)
    distribution_of: Maybe[SharedBy] = quantity("Uneven share of", advanced=True)
    """Of satellites, of which one carries so many times its part of the torque, at most all of it,
    and the others evenly what is left; or of the pins of each, of which no bearing feels anything.
    Where it is not given, of satellites if there are several."""

    @model_validator(mode="after")
    def _fit_says_the_clearance(self) -> Self:
        if self.fit is None:
            return self
        if not re.fullmatch(FIT, self.fit):
            raise field_error("fit", "no_fit")
        if 2 * float(self._sum(*RADII[:2])) > SIZES[-1]:
            raise field_error("fit", "no_class_of_size", limit_mm=float(SIZES[-1]))
        return self

    @model_validator(mode="after")
    def _radii_agree(self) -> Self:
        if self.model_fields_set >= {"hole_radius_mm", "hole_clearance_mm", *RADII[:2]}:
            hole, others = self._sum("hole_radius_mm"), self._sum(*RADII)
            if abs(hole - others) > Decimal("1e-9") * hole:
                raise field_error("hole_radius_mm", "hole_disagrees", expected_mm=float(others))
        return self

    def assumed(self) -> Iterator[tuple[tuple[str, ...], Any]]:
        """Materials of pins and holes, where there are any; the eccentricity of a hole alone."""
        if self.pin_radius_mm is None:
            return
        yield from super().assumed()
        if self.eccentricity_mm is None:
            yield ("eccentricity_mm",), float(self._sum("hole_radius_mm") - self._sum(*RADII[:1]))

    def _sum(self, *names: str) -> Decimal:
        """Sum of sizes, of what is not given none, in decimals as they were typed: no digit is
        lost.
        """
        return sum((Decimal(repr(getattr(self, name) or 0.0)) for name in names), Decimal())

    @cached_property
    def stated_clearance_mm(self) -> float | None:
        """Radial clearance as it is given, or by the fit."""
        if self.fit is None:
            return self.hole_clearance_mm
        hole, pin = (float(2 * self._sum(*names)) for names in (RADII[:2], RADII[:1]))
        mean = fit_clearance(fit=self.fit, hole_diameter=hole / 1e3, pin_diameter=pin / 1e3)
        return round(mean * 1e3, 9)

    @property
    def clearance_unknown(self) -> bool:
        """Whether pin, hole and eccentricity are given, and nothing is known of their clearance."""
        return self._sized and self.in_si.clearance_unknown

    @property
    def _sized(self) -> bool:
        return self.given.keys() >= {"pin_radius_mm", "eccentricity_mm"}

    def notices(self) -> tuple[Notice, ...]:
        """Also that parts without clearance are perfect ones."""
        perfect = self._sized and not self.clearance_mm()
        return super().notices() + ((Notice("perfect_parts"),) if perfect else ())

    @cached_property
    def hole_mm(self) -> float:
        """Radius of the hole: given, or by pin, eccentricity and clearance."""
        given = self.hole_radius_mm
        return float(self._sum(*RADII)) if given is None else given

    def clearance_mm(self) -> float:
        """Radial clearance: given, or by the radii; none where no two radii say it, nor where it is
        too small to be felt.
        """
        clearance = self.stated_clearance_mm
        if clearance is None:
            typed = self.given.keys() >= {"hole_radius_mm", "eccentricity_mm"}
            clearance = float(self._sum("hole_radius_mm") - self._sum(*RADII[:2])) if typed else 0.0
        return felt(clearance=clearance, hole_radius=self.hole_mm)

    @property
    def surface(self) -> dict[str, Any]:
        """What pins have where they do not say it: diameter, m, and material."""
        diameter = 2 * to_si("radius_mm", self.pin_radius_mm)
        return {"diameter": diameter, "material": self.pin_material}

    @cached_property
    def in_si(self) -> Contact:
        """The same in SI units."""
        given = {name: getattr(self, name) for name in ("pin_material", "hole_material")}
        return Contact(
            contact_length=to_si("contact_length_mm", self.contact_length_mm),
            pin_radius=to_si("pin_radius_mm", self.pin_radius_mm),
            hole_radius=to_si("hole_radius_mm", self.hole_mm),
            eccentricity=to_si("eccentricity_mm", self.eccentricity_mm),
            dynamic_factor=self.dynamic_factor,
            distribution_factor=self.distribution_factor,
            distribution_of=self.distribution_of,
            clearance_stated=self.stated_clearance_mm is not None,
            iso_fit=self.fit or "",
            own_limits=tuple(name for name, each in given.items() if not isinstance(each, str)),
            **{name: material_of(each) for name, each in given.items()},
        )

    def section(self, _: Any) -> Contact:
        """The same in SI units."""
        return self.in_si

    def sizes_on(self, pin_circle_radius_mm: float) -> dict[str, Any]:
        """Sizes of pins and holes on their circle in SI units, None for what is not given."""
        return {
            "pin_radius": to_si("pin_radius_mm", self.pin_radius_mm),
            "hole_radius": to_si("hole_radius_mm", self.hole_mm),
            "eccentricity": to_si("eccentricity_mm", self.eccentricity_mm),
            "pin_circle_radius": to_si("pin_circle_radius_mm", pin_circle_radius_mm),
        }


TOUCHING = ("pin_radius_mm", "contact_length_mm")
"""What pins have to have where their holes are given."""


class CrankContactFields(PinContactFields, group="contact"):
    """The crank; pin and hole where the forces of real pins and holes are wanted."""

    BETWEEN: ClassVar[tuple[Rule, ...]] = tuple(
        Rule(name, "needed_beside", hole)
        for hole in ("hole_radius_mm", "hole_clearance_mm", "fit")
        for name in TOUCHING
    )

    contact_length_mm: Maybe[Size] = contact_length()  # type: ignore[assignment]
    pin_radius_mm: Maybe[Size] = pin_radius()  # type: ignore[assignment]
    eccentricity_mm: Size = eccentricity()
