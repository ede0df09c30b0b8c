"""Ring of a request: pins and discs of a cycloid, or other teeth that load the satellites."""

from collections.abc import Iterator
from functools import partial
from typing import Any, ClassVar, Self, TypeVar

from pydantic import model_validator

from app.calculations.contact_law import MeshLawFields
from app.calculations.hertz import Material, contact_length, material_of
from app.calculations.involute_teeth import RING_MATERIAL, InvoluteTeethFields
from app.calculations.mechanism import MAX_SATELLITES
from app.calculations.pin import strengths_of
from app.document import SectionFields
from app.model import (
    Maybe,
    RequestModel,
    RingSize,
    Size,
    Whole,
    present,
    quantity,
)
from app.problems import invalid_input, wrong
from app.rules import Forms, Kinds, field_error
from app.units import to_si
from core.design.ring import (
    CycloidRing,
    InvoluteRing,
    OtherRing,
    Ring,
    RingClass,
    RingPinSupport,
)
from core.design.ring import RingKind as Kind
from core.output.room import OF_RING_PINS, Deviations
from core.ring.profile import Modification

REFERENCE_ANGLE_DEG = 20.0

PIN_MATERIAL, DISC_MATERIAL = "steel_bearing", "steel_through_hardened"
"""Materials of ring pins and discs if they are not given."""

Made = TypeVar("Made")

RINGS: dict[Kind | None, type[CycloidRing] | type[InvoluteRing] | type[OtherRing]] = {
    "cycloid": CycloidRing,
    "involute": InvoluteRing,
    "none": OtherRing,
    None: OtherRing,
}
"""Kinds of rings; None for a ring given by the ratio of its forces."""

OF_SUPPORTS = ("span_mm", "satellite_positions_mm")
"""Fields of ring pins that bend."""

pin_circle_radius = partial(
    quantity,
    "Circle of the ring's pins",
    "R_p",
    step=1,
    help="Radius of the circle of the ring pins, on which a cycloid disc rolls.",
)
ring_pin_radius = partial(
    quantity,
    "Radius of the ring's pins",
    "r_p",
    step=0.5,
    help="Radius of the ring pins, or of their sleeves; the roots of a cycloid disc follow "
    "from it.",
)
"""Fields that are optional in some requests."""


class ModificationFields(SectionFields, of=Modification, group="gear"):
    """Offsets of the tool that cuts the discs from the ring pins."""


class RingPinsFields(RequestModel, group="gear"):
    """Ring pins and the cycloid discs on them, as far as they are given."""

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

    kind: Maybe[Kind] = quantity("Ring")
    """Kind of ring: involute teeth, pins on which a cycloid disc rolls, or none, whose force along
    the crank is left out."""
    ring_pin_circle_radius_mm: Maybe[RingSize] = pin_circle_radius()
    ring_pin_radius_mm: Maybe[RingSize] = ring_pin_radius()
    contact_length_mm: Maybe[Size] = contact_length()
    modification: Maybe[ModificationFields] = None
    contact_law: Maybe[MeshLawFields] = None
    pin_material: Maybe[Material] = quantity("Material of the ring's pins")
    """Name in the table of materials, or values; bearing steel if not given."""
    disc_material: Maybe[Material] = quantity("Disc material")
    """Name in the table of materials, or values; the material of the holes if not given."""
    pin_support: Maybe[RingPinSupport] = quantity("Support of the ring's pins", advanced=True)
    """Support of the ring pins: in half a bore (seat), which is the default, held at both ends free
    to tilt (supported), or built in (fixed)."""
    span_mm: Maybe[Size] = quantity("Span of the ring's pins", "L", step=1, advanced=True)
    """Distance between the two supports of the ring pins; not for seats."""
    satellite_positions_mm: Maybe[list[Size]] = quantity(
        "Places of the satellites",
        "z₁ … z_K",
        min_length=1,
        max_length=MAX_SATELLITES,
        advanced=True,
    )
    """Middle plane of each satellite, from one support of the ring pins; not for seats."""
    seat_stiffness_N_per_mm: Maybe[Size] = quantity(
        "Stiffness of a seat", "k_s", step=10_000, advanced=True
    )
    """Stiffness of a ring pin in its bore and of the part that holds the bore; rigid if not
    given."""
    friction_coefficient: Maybe[float] = quantity(
        "Friction coefficient", "μ", step=0.01, ge=0, le=1
    )
    """Friction coefficient of sliding on the ring pins, or of the flanks of teeth; without it the
    loss is not calculated."""
    sleeve_bore_radius_mm: Maybe[Size] = quantity("Bore of the sleeves", "r_i", step=0.5)
    """Radius of the bore of sleeves, which slide on the ring pins."""
    rolling: Maybe[bool] = quantity("Rolling elements", advanced=True)
    """True if rolling elements carry the sleeves. The friction coefficient is then that of the
    rolling elements at the bore of the sleeves, or at their outer radius if no bore is given, which
    gives a larger loss."""

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

    def ring(self, made: type[Made]) -> Made:
        """Ring in SI units, by its kind."""
        return ring_of(self.to_core(), made)


def ring_of(own: dict[str, Any], made: type[Made]) -> Made:
    """Ring in SI units, by its kind, from the core's arguments of a request."""
    if "pin_material" in own:
        held = strengths_of(own.pop("pin_material"))
        own["pin_material"] = held.pop("material")
        own |= {f"pin_{name}": value for name, value in held.items()}
    for name in ("disc_material", "satellite_material", "ring_material"):
        if name in own:
            own[name] = material_of(own[name])
    return made(**own)


class RingPinDeviationsFields(SectionFields, of=Deviations, only=OF_RING_PINS, group="deviations"):
    """Deviations of ring pins from their nominal sizes."""

    @property
    def ring_lists(self) -> dict[str, list[float]]:
        """Given lists by their field."""
        given = {name: getattr(self, name) for name in RING_PIN_LISTS}
        return {name: value for name, value in given.items() if value}

    def refuse_other_ring(self, pins: int | None) -> None:
        """Refuse lists without one value for each ring pin, if the number of pins is known."""
        errors = [
            wrong(f"/deviations/{name}", "different_length", expected=pins, actual=len(value))
            for name, value in self.ring_lists.items()
            if pins not in (None, len(value))
        ]
        if errors:
            raise invalid_input(errors)


RING_PIN_LISTS = tuple(RingPinDeviationsFields.model_fields)
"""Fields with lists of ring pins."""

TOOTH_DATA = tuple(
    name
    for name in RingPinsFields.model_fields
    if name not in ("kind", "ring_pin_circle_radius_mm", "ring_pin_radius_mm")
)
"""Inputs of the mesh of cycloid discs, besides the sizes of the ring."""

INVOLUTE_DATA = (
    *InvoluteTeethFields.model_fields,
    "contact_length_mm",
    "friction_coefficient",
    "root_strength_MPa",
)
"""Inputs of the mesh of involute teeth, besides module and pressure angle."""


class RingFields(RingPinsFields, InvoluteTeethFields, group="gear"):
    """Teeth or pins of the ring, or the ratio of its forces."""

    ALTERNATIVES: ClassVar[tuple[Forms, ...]] = (
        (("kind",), ("radial_force_ratio",)),
        (("satellite_addendum",), ("satellite_tip_radius_mm",), ()),
        (("ring_addendum",), ("ring_tip_radius_mm",), ()),
    )

    KINDS: ClassVar[Kinds] = {
        "cycloid": (
            ("ring_pin_circle_radius_mm",),
            (
                "ring_pin_radius_mm",
                *TOOTH_DATA,
                "rotates",
                "tool_radius_mm",
                "every_second_pin",
                "ring_class",
            ),
        ),
        "involute": (
            ("module_mm",),
            ("teeth_difference", "reference_pressure_angle_deg", *INVOLUTE_DATA),
        ),
        "none": ((), ()),
        None: ((), ()),
    }
    """The difference of teeth is that of the mechanism where this has teeth, and needed where it
    has none; a ratio that is given needs nothing."""

    module_mm: Maybe[Size] = quantity("Module", "m", step=0.5)
    """Module of the teeth."""
    teeth_difference: Maybe[Whole] = quantity("Difference of teeth", "z₃ − z₂", ge=1, le=1000)
    """Number of teeth of the ring less that of a satellite; the difference of the mechanism's teeth
    if these are given."""
    reference_pressure_angle_deg: Maybe[float] = quantity(
        "Reference pressure angle", "α", step=0.5, ge=1, le=60
    )
    """Pressure angle of the teeth at the reference circle; 20° if not given."""
    root_strength_MPa: Maybe[Size] = quantity("Strength of the tooth root", "σ_FG", step=10)
    """Stress that the tooth root of a satellite endures over the life, for the torque in one
    direction or in both, as it acts; the safety factor in fatigue refers to it."""
    radial_force_ratio: Maybe[float] = quantity(
        "Ratio of the ring's forces", "ρ", step=0.05, ge=-100, le=100
    )
    """Force of the ring along the crank over its force across the crank: positive towards the
    reducer's axis, as with involute teeth, negative outwards, as with ring pins."""

    rotates: Maybe[bool] = quantity("Ring pins rotate", advanced=True)
    """True if the ring pins turn in their supports, so that their bending is fully reversed."""
    tool_radius_mm: Maybe[Size] = quantity("Radius of the tool", "r_t", step=1, advanced=True)
    """Radius of the wheel or cutter that makes the flanks of the discs; it has to reach into their
    valleys."""
    every_second_pin: Maybe[bool] = quantity("Every second pin", advanced=True)
    """True if every second pin of an even number of ring pins is left out; the forces of such a
    ring are not calculated."""

    ring_class: Maybe[RingClass] = quantity("How the ring is made", advanced=True)
    """Manufacture of discs and ring: ground, machined or printed. It states the usual modification
    of the discs and the usual places of the ring pins, if these are not known. The default is
    printed if discs are softer than 20 GPa, else ground."""

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

    def section(self, whole: Any) -> Ring:
        """Ring in SI units, with the difference of the mechanism's teeth if given."""
        usual: dict[str, Any] = {**self._usual_materials()}
        if self.kind == "involute":
            usual["reference_pressure_angle"] = to_si("angle_deg", REFERENCE_ANGLE_DEG)
        difference = present({"teeth_difference": whole.mechanism.teeth_difference})
        return ring_of(usual | self.to_core() | difference, RINGS[self.kind])
