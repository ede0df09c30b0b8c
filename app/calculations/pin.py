"""Pin as a section of a design: beam and material."""

from collections.abc import Iterator, Mapping
from typing import Any, ClassVar

from app.calculations.hertz import Material, material_of
from app.fields import SectionFields
from app.model import Maybe, Size, quantity
from app.rules import Forms, Kinds
from app.units import Convert
from core.design.sections import DesignPin
from core.errors import Notice
from core.output.pin_beam import Support
from core.output.pin_bolt import PinBolt


class PinBoltFields(SectionFields, of=PinBolt, group="pin"):
    """Bolt through the pin, which is a spacer then."""

    ALTERNATIVES: ClassVar[tuple[Forms, ...]] = ((("preload_N",), ("tightening_torque_Nm",), ()),)
    CONVERTERS: ClassVar[Mapping[str, Convert]] = {"bolt_material": material_of}

    tightening_torque_Nm: Maybe[Size] = quantity("Tightening torque", "T_A", step=0.5)
    """Tightening torque, given instead of the preload, which is T_A/(0.2·d)."""
    bolt_material: Maybe[Material] = quantity("Material of the bolt")
    """Name in the table of materials, or values; steel of class 8.8 if not given."""

    def assumed(self) -> Iterator[tuple[tuple[str, ...], Any]]:
        """Assumed values, with the material of the bolt."""
        yield from super().assumed()
        yield from (((name,), value) for name, value in self.filled.items())

    def notices(self) -> tuple[Notice, ...]:
        """Notice of a preload that is estimated from a tightening torque."""
        if self.tightening_torque_Nm is None:
            return ()
        return (Notice("nut_factor", {"preload": self.made.preload}),)


class PinFields(SectionFields, of=DesignPin, group="pin"):
    """Pin with its support, bending and strength."""

    KIND: ClassVar[str] = "support"

    KINDS: ClassVar[Kinds] = {
        "cantilever": ((), ("span_mm",)),
        "supported": (("span_mm",), ()),
        "fixed": (("span_mm",), ()),
        "tie_ring": (("span_mm",), ("ring_joint",)),
    }

    WITHIN: ClassVar[bool] = True

    support: Support = "cantilever"
