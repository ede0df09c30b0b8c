"""Pin as a section of a design: beam and material."""

from collections import ChainMap
from collections.abc import Iterator
from dataclasses import replace
from typing import Any, ClassVar

from app.calculations.fatigue import STEEL_GPA
from app.calculations.hertz import Material, MaterialFields, entry_of, material_of
from app.fields import SectionFields
from app.model import Maybe, Size, quantity
from app.rules import Forms, Kinds
from app.units import from_si, to_si
from core.design.sections import DesignPin
from core.errors import Notice, required
from core.materials import NOT_LISTED
from core.output.pin_beam import Support
from core.output.pin_bolt import PinBolt, bolt_preload

BOLT_MATERIAL = "steel_bolt"
"""Material of a bolt if none is given."""


def strengths_of(given: str | MaterialFields) -> dict[str, Any]:
    """Material of a pin and its strengths, by the names of `core.design.sections.DesignPin`."""
    entry, material = entry_of(given), material_of(given)
    tensile = None if isinstance(given, str) else given.tensile_strength_MPa
    typed = tensile or (None if isinstance(given, str) else given.yield_strength_MPa)
    if entry is NOT_LISTED or typed:
        low, high = STEEL_GPA
        return {
            "material": material,
            "tensile_strength": to_si("strength_MPa", tensile),
            "steel": low <= from_si("modulus_GPa", material.youngs_modulus) <= high,
        }
    strength = entry.strength
    yields = strength.yield_strength or material.yield_strength
    return {
        "material": replace(material, yield_strength=yields),
        "tensile_strength": strength.tensile,
        "steel": entry.group == "steel",
        "valid_diameter": strength.valid_diameter,
    }


class PinBoltFields(SectionFields, of=PinBolt, group="pin"):
    """Bolt through the pin, which is a spacer then."""

    ALTERNATIVES: ClassVar[tuple[Forms, ...]] = ((("preload_N",), ("tightening_torque_Nm",), ()),)

    tightening_torque_Nm: Maybe[Size] = quantity("Tightening torque", "T_A", step=0.5)
    """Tightening torque, given instead of the preload, which is T_A/(0.2·d)."""
    bolt_material: Maybe[Material] = quantity("Material of the bolt")
    """Name in the table of materials, or values; steel of class 8.8 if not given."""

    def assumed(self) -> Iterator[tuple[tuple[str, ...], Any]]:
        """Assumed values, with the material of the bolt."""
        yield from super().assumed()
        if self.bolt_material is None:
            yield ("bolt_material",), BOLT_MATERIAL

    def notices(self) -> tuple[Notice, ...]:
        """Notice of a preload that is estimated from a tightening torque."""
        if self.tightening_torque_Nm is None:
            return ()
        return (Notice("nut_factor", {"preload": self.section().preload}),)

    def section(self, around: Any = None) -> PinBolt:
        """The bolt in SI units."""
        own = self.to_core()
        if "tightening_torque" in own:
            core, torque = own["core_diameter"], own.pop("tightening_torque")
            own["preload"] = bolt_preload(tightening_torque=torque, core_diameter=core)
        own |= strengths_of(own.pop("bolt_material", BOLT_MATERIAL))
        return PinBolt(**own)


class PinFields(SectionFields, of=DesignPin, group="pin"):
    """Pin with its support, bending and strength."""

    KIND: ClassVar[str] = "support"

    KINDS: ClassVar[Kinds] = {
        "cantilever": ((), ("span_mm",)),
        "supported": (("span_mm",), ()),
        "fixed": (("span_mm",), ()),
        "tie_ring": (("span_mm",), ("ring_joint",)),
    }

    support: Support = "cantilever"

    def section(self, around: Any = None) -> DesignPin:
        """Pin in SI units; diameter and material not given come from the surrounding parts."""
        own, surface = self.to_core(), ChainMap(*around.around_pins)
        diameter = own.get("diameter", surface.get("diameter"))
        material = self.material or surface.get("material")
        places = {"satellite_positions": own.get("satellite_positions", ())}
        given = {"diameter": required(diameter, "size_missing", "pin.diameter")}
        strengths = strengths_of(required(material, "size_missing", "pin.material"))
        return DesignPin(**own | places | given | strengths)
