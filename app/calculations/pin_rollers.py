"""Rolling bearings as rollers on the pins: fields of a section of a design."""

from typing import Any

from app.calculations.named_bearing import NamedBearingFields
from core.bearings import NamedBearing
from core.design.sections import Rollers


class RollersFields(NamedBearingFields, of=Rollers, group="rollers"):
    """Rolling bearings on the pins, whose outer rings roll in the holes."""

    def said(self, named: NamedBearing, quantity: str) -> Any:
        """Kind of bearing by its rolling elements."""
        if quantity == "kind":
            return "ball" if named.kind == "ball" else "cylindrical"
        return super().said(named, quantity)

    @property
    def surface(self) -> dict[str, Any]:
        """Diameter that pins take if they do not state it, m: the bore of the rollers."""
        return {"diameter": self.to_core()["bore_diameter"]}
