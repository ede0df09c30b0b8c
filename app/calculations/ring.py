"""Ring of a request: pins and discs of a cycloid, or other teeth that load the satellites."""

from collections.abc import Iterator
from typing import Any, ClassVar, Self

from pydantic import model_validator

from app.calculations.hertz import MaterialFields, material_of
from app.calculations.involute_teeth import RING_MATERIAL
from app.calculations.pin import strengths_of
from app.fields import SectionFields
from app.model import Maybe, present, quantity
from app.rules import field_error
from core.design.ring import RINGS, Ring, RingKind

PIN_MATERIAL, DISC_MATERIAL = "steel_bearing", "steel_through_hardened"
"""Materials of ring pins and discs if they are not given."""

OF_SUPPORTS = ("span_mm", "satellite_positions_mm")
"""Fields of ring pins that bend."""


def _of_pins(material: str | MaterialFields) -> dict[str, Any]:
    """Material of ring pins and its strengths, by the names of `CycloidRing`."""
    held = strengths_of(material)
    return {"pin_material": held.pop("material")} | {
        f"pin_{name}": value for name, value in held.items()
    }


class RingFields(SectionFields, of=RINGS, group="gear"):
    """Teeth or pins of the ring, or the ratio of its forces."""

    RULES: ClassVar[tuple[dict[str, Any], ...]] = (
        {
            "if": {
                "properties": {"pin_support": {"enum": ["supported", "fixed"]}},
                "required": ["pin_support"],
            },
            "then": {"required": [*OF_SUPPORTS]},
            "else": {"not": {"anyOf": [{"required": [name]} for name in OF_SUPPORTS]}},
        },
    )

    kind: Maybe[RingKind] = quantity("Ring")
    """Kind of ring: involute teeth, pins on which a cycloid disc rolls, or none, whose force along
    the crank is left out."""

    @model_validator(mode="after")
    def _held(self) -> Self:
        support = self.pin_support or "seat"
        for name in OF_SUPPORTS:
            given = name in self.given
            if given and support == "seat":
                raise field_error(name, "of_another_kind", kind="seat")
            if not given and support != "seat":
                raise field_error(name, "needed_beside", field="pin_support")
        return self

    def to_core(self) -> dict[str, Any]:
        """Given fields as the core's arguments, with the strengths of the pin material."""
        given = self.given.get("pin_material")
        return super().to_core() | ({} if given is None else _of_pins(given))

    def assumed(self) -> Iterator[tuple[tuple[str, ...], Any]]:
        """Assumed values, with the material of the ring if its mesh is judged."""
        yield from super().assumed()
        if self.toothed or self.modification is not None:
            for name, material in self._usual_materials().items():
                if name not in self.given:
                    yield (name,), material

    def _usual_materials(self) -> dict[str, str]:
        """Materials that are assumed if they are not given."""
        of_pins = {"pin_material": PIN_MATERIAL} if self.kind == "cycloid" else {}
        return of_pins | ({"ring_material": RING_MATERIAL} if self.toothed else {})

    @property
    def toothed(self) -> bool:
        """True if involute teeth are given with their profile shifts."""
        return self.given.keys() >= {"satellite_profile_shift", "ring_profile_shift"}

    def refuse_other_teeth(self, difference: int | None) -> None:
        """Refuse involute teeth whose difference is missing or contradicts the mechanism."""
        if self.kind != "involute":
            return
        given, name = self.teeth_difference, "gear/teeth_difference"
        if difference is None and given is None:
            raise field_error(name, "needed_beside", field="ratio")
        # a ring without more teeth than its satellites is refused by itself
        if given and difference and difference > 0 and given != difference:
            raise field_error(name, "teeth_disagree", expected=difference)

    def refuse_other_discs(self, material: Any) -> None:
        """Refuse a material of the discs other than that of their holes."""
        for name in ("disc_material", "satellite_material"):
            if material_of(self.given.get(name, material)) != material_of(material):
                raise field_error(f"gear/{name}", "discs_disagree", field="hole_material")

    def section(self, around: Any = None) -> Ring:
        """Ring in SI units, with the difference of the mechanism's teeth if given."""
        own = self.to_core()
        for name, material in self._usual_materials().items():
            if name not in own:
                usual = {name: material_of(material)}
                own |= _of_pins(material) if name == "pin_material" else usual
        difference = present({"teeth_difference": around.mechanism.teeth_difference})
        return RINGS[self.kind](**own | difference)
