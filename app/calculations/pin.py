"""The pin as a section of a design: beam and material."""

from dataclasses import replace
from functools import partial
from typing import Any, ClassVar

from app.calculations.fatigue import STEEL_GPA
from app.calculations.hertz import MaterialFields
from app.calculations.mechanism import MAX_SATELLITES
from app.model import Kinds, Maybe, RequestModel, Size, quantity
from app.units import from_si, to_si
from core.material_table import MATERIALS
from core.output.pin_beam import Support


def strengths_of(given: str | MaterialFields) -> dict[str, Any]:
    """Material of a pin with its yield strength, and what its strength is judged by, as
    `core.design.sections.DesignPin` names it.
    """
    if isinstance(given, str):
        entry = MATERIALS[given]
        strength = entry.strength
        return {
            "material": replace(
                entry.material,
                yield_strength=strength.yield_strength or entry.material.yield_strength,
            ),
            "tensile_strength": strength.tensile,
            "steel": entry.group == "steel",
            "valid_diameter": strength.valid_diameter,
        }
    material, base = given.material(), given.base
    strengths = (given.tensile_strength_MPa, given.yield_strength_MPa)
    if base is not None and not any(strengths):
        return strengths_of(base.name) | {"material": material}
    low, high = STEEL_GPA
    return {
        "material": material,
        "tensile_strength": to_si("strength_MPa", given.tensile_strength_MPa),
        "steel": low <= from_si("modulus_GPa", material.youngs_modulus) <= high,
    }


pin_places = partial(
    quantity,
    "Places of the satellites",
    "z₁ … z_K",
    min_length=1,
    max_length=MAX_SATELLITES,
    help="Middle plane of each satellite, from the face of the carrier.",
)


class HeldPinFields(RequestModel, group="pin"):
    """How the pins are held, and where the satellites load them."""

    KIND: ClassVar[str] = "support"

    KINDS: ClassVar[Kinds] = {
        "cantilever": ((), ("span_mm",)),
        "supported": (("span_mm",), ()),
        "fixed": (("span_mm",), ()),
    }

    satellite_positions_mm: list[Size] = pin_places()
    support: Support = quantity("Support", default="cantilever")
    """Held at one end (cantilever), at both ends free to tilt (supported), or at both ends built in
    (fixed); the truth of a cage lies between the latter two."""
    span_mm: Maybe[Size] = quantity("Span", "L", step=1)
    """Distance of the two supports; not for a cantilever."""
