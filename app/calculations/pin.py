"""Pin as a section of a design: beam and material."""

from collections.abc import Iterator
from dataclasses import replace
from functools import partial
from typing import Any, ClassVar

from app.calculations.fatigue import STEEL_GPA
from app.calculations.hertz import Material, MaterialFields, entry_of, material_of
from app.calculations.mechanism import MAX_SATELLITES
from app.model import Maybe, PartFields, RequestModel, Size, quantity
from app.rules import Forms, Kinds
from app.units import from_si, to_si
from core.errors import Notice
from core.materials import NOT_LISTED
from core.output.pin_beam import Support
from core.output.pin_bolt import PinBolt, bolt_preload
from core.output.tie_ring import RingJoint

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


class PinBoltFields(PartFields, group="pin"):
    """Bolt through the pin, which is a spacer then."""

    ALTERNATIVES: ClassVar[tuple[Forms, ...]] = ((("preload_N",), ("tightening_torque_Nm",), ()),)

    core_diameter_mm: Size = quantity("Core of the bolt", "d_3", step=0.1)
    """Core diameter of the bolt's thread: 2.46 mm for M3, 3.24 for M4, 4.13 for M5, 4.92 for M6,
    6.65 for M8."""
    preload_N: Maybe[Size] = quantity("Preload", "F_v", step=100)
    """Preload of the bolt after tightening; without a preload the bolt alone counts as the pin."""
    tightening_torque_Nm: Maybe[Size] = quantity("Tightening torque", "T_A", step=0.5)
    """Tightening torque, given instead of the preload, which is T_A/(0.2·d)."""
    preload_scatter: float = quantity(
        "Scatter of the preload", "α_A", default=1.8, step=0.1, ge=1, le=10
    )
    """Largest over least preload by the way of tightening; 1.6 to 2 with a torque wrench."""
    friction_coefficient: float = quantity(
        "Friction on the carrier", "μ", default=0.15, step=0.01, ge=0.01, le=1
    )
    """Friction coefficient of the spacer on the carrier, which keeps the spacer from slipping."""
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

    def section(self) -> PinBolt:
        """The bolt in SI units."""
        own = self.to_core()
        if "tightening_torque" in own:
            core, torque = own["core_diameter"], own.pop("tightening_torque")
            own["preload"] = bolt_preload(tightening_torque=torque, core_diameter=core)
        own |= strengths_of(own.pop("bolt_material", BOLT_MATERIAL))
        return PinBolt(**own)


pin_places = partial(
    quantity,
    "Places of the satellites",
    "z₁ … z_K",
    min_length=1,
    max_length=MAX_SATELLITES,
    help="Middle plane of each satellite, from the face of the carrier.",
)


class HeldPinFields(RequestModel, group="pin"):
    """Supports of the pins, and places where the satellites load them."""

    KIND: ClassVar[str] = "support"

    KINDS: ClassVar[Kinds] = {
        "cantilever": ((), ("span_mm",)),
        "supported": (("span_mm",), ()),
        "fixed": (("span_mm",), ()),
        "tie_ring": (("span_mm",), ("ring_joint",)),
    }

    satellite_positions_mm: list[Size] = pin_places()
    support: Support = quantity("Support", default="cantilever")
    """Support of the pin: one end fixed (cantilever), both ends free to tilt (supported), both ends
    built in (fixed), or one end fixed and the other ends joined by a free ring (tie ring). The true
    support of a cage lies between supported and fixed; a tie ring supports less."""
    span_mm: Maybe[Size] = quantity("Span", "L", step=1)
    """Distance between the two supports, or from the carrier to the middle of the tie ring; not for
    a cantilever."""
    ring_joint: Maybe[RingJoint] = quantity("Joint of the tie ring")
    """Joint of the pins' ends to the tie ring: free to turn (pinned), which is the default, or
    clamped."""
