"""Rolling bearings as rollers on the pins: fields of a section of a design."""

from typing import Any

from app.calculations.named_bearing import NamedBearingFields
from core.bearings import NamedBearing
from core.design.sections import Rollers


class RollersFields(NamedBearingFields, of=Rollers, group="rollers"):
    """Rolling bearings on the pins, whose outer rings roll in the holes."""

    def said(self, named: NamedBearing, quantity: str) -> Any:
        """Value of the table; a drawn cup, which a housing has to hold, has no outer diameter."""
        if quantity == "kind":
            return named.elements
        held = quantity == "outer_diameter" and named.series == "HK"
        return None if held else super().said(named, quantity)

    @property
    def surface(self) -> dict[str, Any]:
        """Diameter that pins take if they do not state it, m: the bore of the rollers."""
        return {"diameter": self.to_core()["bore_diameter"]}
