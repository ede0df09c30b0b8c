"""Rolling bearings as rollers on the pins: fields of a section of a design."""

from typing import Any, ClassVar

from app.calculations.named_bearing import NamedBearingFields, bearing_name
from app.model import LARGEST, Maybe, Size, Whole, quantity
from app.rules import Forms
from core.bearings import NamedBearing
from core.crank.pin_rollers import Ratings, RollerKind
from core.design.sections import Rollers


class RollersFields(NamedBearingFields, group="rollers"):
    """Rolling bearings on the pins, whose outer rings roll in the holes."""

    ALTERNATIVES: ClassVar[tuple[Forms, ...]] = (
        (("bore_diameter_mm",), ("name",), ("bore_diameter_mm", "name")),
    )

    name: Maybe[str] = bearing_name()
    kind: Maybe[RollerKind] = quantity("Rolling elements")
    """Balls, cylindrical rollers or needles."""
    bore_diameter_mm: Maybe[Size] = quantity("Bore", "d", step=1)
    """Bore diameter of the bearing, equal to the pin diameter."""
    outer_diameter_mm: Maybe[Size] = quantity("Outer diameter", "D", step=1)
    """Outer diameter of the bearing, twice the radius that touches the holes."""
    width_mm: Maybe[Size] = quantity("Width", "B", step=0.5)
    """Width of one bearing; the contact with the hole is not longer than the bearings."""
    per_satellite: Whole = quantity(
        "Bearings side by side", "n", default=1, ge=1, le=20, advanced=True
    )
    """Number of bearings on each pin under each satellite, which share the force evenly."""
    dynamic_rating_N: Maybe[Size] = quantity("Dynamic load rating", "C", step=100)
    """Basic dynamic load rating of one bearing, for the life."""
    static_rating_N: Maybe[Size] = quantity("Static load rating", "C₀", step=100)
    """Basic static load rating of one bearing, for the static safety."""
    ratings: Ratings = quantity("Ratings of", default="bearing")
    """Kind of bearing to which the ratings apply: a bearing, whose ratings hold in a rigid seat, so
    that a lower bound without a seat is used; or a track roller, whose ratings by the maker include
    the missing seat."""
    rolling_elements: Maybe[Whole] = quantity("Number of elements", "Z", ge=3, le=200)
    """Number of rolling elements of a bearing; more elements leave less of the ratings without a
    seat."""
    max_radial_load_N: Maybe[Size] = quantity("Largest load", "F_r", step=100, advanced=True)
    """Largest load of a track roller by its maker, limited by the bending of the outer ring."""
    max_static_radial_load_N: Maybe[Size] = quantity(
        "Largest static load", "F_0r", step=100, advanced=True
    )
    """Largest static load of a track roller by its maker, compared with the load at the peak
    torque."""
    radial_clearance_mm: Maybe[float] = quantity(
        "Clearance of the bearings", "G_r", step=0.005, ge=0, le=LARGEST
    )
    """Radial internal clearance as stated in catalogues; half of it adds to the clearance of pins
    and holes."""
    friction_coefficient: Maybe[float] = quantity(
        "Friction of the bearings", "μ_b", step=0.0005, ge=0, le=10, advanced=True
    )
    """Friction coefficient of the bearing at its bore; 0.0015 for balls, 0.002 for cylindrical
    rollers, 0.003 for needles if not given."""
    limiting_speed_rpm: Maybe[Size] = quantity("Limiting speed", "n_lim", step=500, advanced=True)
    """Limiting speed in the catalogue; without it the speed is not judged."""

    def said(self, named: NamedBearing, quantity: str) -> Any:
        """Kind of bearing by its rolling elements."""
        if quantity == "kind":
            return "ball" if named.kind == "ball" else "cylindrical"
        return super().said(named, quantity)

    @property
    def surface(self) -> dict[str, Any]:
        """Diameter that pins take if they do not state it, m: the bore of the rollers."""
        return {"diameter": self.to_core()["bore_diameter"]}

    def section(self, _: Any) -> Rollers:
        """Rollers in SI units."""
        return Rollers(**self.to_core())
