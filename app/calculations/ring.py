"""Ring of a request: pins and discs of a cycloid, or other teeth that load the satellites."""

from collections.abc import Iterator
from functools import partial
from typing import Annotated, Any, ClassVar, Self, TypeVar

from pydantic import Field, field_validator, model_validator

from app.calculations.contact_law import MeshLawFields
from app.calculations.hertz import Material, contact_length, material_of
from app.calculations.involute_teeth import RING_MATERIAL, InvoluteTeethFields
from app.calculations.mechanism import MAX_SATELLITES
from app.calculations.pin import strengths_of
from app.model import (
    NO_DUST,
    Maybe,
    PartFields,
    RequestModel,
    RingSize,
    Size,
    Whole,
    no_dust,
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

Change = Annotated[float, Field(ge=-0.5, le=0.5)]

RingDeviation = Annotated[float, Field(ge=-0.2, le=0.2)]

PerRingPin = Annotated[list[RingDeviation], Field(min_length=1, max_length=1000)]

pin_circle_radius = partial(
    quantity,
    "Circle of the ring's pins",
    "R_p",
    step=1,
    help="Radius of the circle of the ring's pins, on which a cycloid disc rolls.",
)
ring_pin_radius = partial(
    quantity,
    "Radius of the ring's pins",
    "r_p",
    step=0.5,
    help="Of the pins, or of their sleeves; with it the roots of a cycloid disc are known.",
)
"""Fields that are optional in some requests."""


class ModificationFields(PartFields, group="gear"):
    """Offsets of the tool that cuts the discs from the ring pins."""

    equidistant_mm: Change = quantity(
        "Equidistant modification", "Δ_e", default=0.0, step=0.005, schema=NO_DUST
    )
    """Radius of the tool less that of the pins: positive makes the disc smaller all around."""
    pin_circle_mm: Change = quantity(
        "Modification of the circle", "Δ_p", default=0.0, step=0.005, schema=NO_DUST
    )
    """Radius of the tool's circle less that of the pins: negative makes the disc smaller."""
    rotation_arcmin: float = quantity(
        "Modification by rotation", "δ_r", default=0.0, step=0.5, schema=NO_DUST, ge=0, le=30
    )
    """By which the flanks are turned to either side; tips and roots are left out."""

    _sizes = field_validator("equidistant_mm", "pin_circle_mm", "rotation_arcmin")(no_dust)

    def section(self) -> Modification:
        """Modification in SI units."""
        return Modification(**self.to_core())


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
    """Involute teeth, pins on which a cycloid disc rolls, or none: its force along the crank is
    left out."""
    ring_pin_circle_radius_mm: Maybe[RingSize] = pin_circle_radius()
    ring_pin_radius_mm: Maybe[RingSize] = ring_pin_radius()
    contact_length_mm: Maybe[Size] = contact_length()
    modification: Maybe[ModificationFields] = None
    contact_law: Maybe[MeshLawFields] = None
    pin_material: Maybe[Material] = quantity("Material of the ring's pins")
    """A name of the table of materials, or values; bearing steel where not given."""
    disc_material: Maybe[Material] = quantity("Disc material")
    """A name of the table of materials, or values; that of the holes where these have one."""
    pin_support: Maybe[RingPinSupport] = quantity("Support of the ring's pins", advanced=True)
    """In half a bore (seat), as where not given, held at both ends free to tilt (supported), or
    built in (fixed)."""
    span_mm: Maybe[Size] = quantity("Span of the ring's pins", "L", step=1, advanced=True)
    """Distance of the two supports; not of a seat."""
    satellite_positions_mm: Maybe[list[Size]] = quantity(
        "Places of the satellites",
        "z₁ … z_K",
        min_length=1,
        max_length=MAX_SATELLITES,
        advanced=True,
    )
    """Middle plane of each satellite from one support; not of a seat."""
    seat_stiffness_N_per_mm: Maybe[Size] = quantity(
        "Stiffness of a seat", "k_s", step=10_000, advanced=True
    )
    """Of a pin in its bore and of what holds that; rigid where not given."""
    friction_coefficient: Maybe[float] = quantity(
        "Friction coefficient", "μ", step=0.01, ge=0, le=1
    )
    """Of what slides on the ring's pins, or of flanks of teeth; without it no loss is answered."""
    sleeve_bore_radius_mm: Maybe[Size] = quantity("Bore of the sleeves", "r_i", step=0.5)
    """Radius of the bore of sleeves on the ring's pins, in which these slide."""
    rolling: Maybe[bool] = quantity("Rolling elements", advanced=True)
    """Whether rolling elements carry the sleeves: then the friction coefficient is theirs, at the
    bore of the sleeves, or at their outer radius where no bore is given, which is more."""

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


class RingPinDeviationsFields(RequestModel, group="deviations"):
    """Deviations of ring pins from their nominal sizes."""

    ring_pin_radial_mm: Maybe[PerRingPin] = quantity("Ring pins outward", "ρ", step=0.001)
    """Of each pin of the ring, outward; the first faces the crank at the crank angle 0."""
    ring_pin_tangential_mm: Maybe[PerRingPin] = quantity(
        "Ring pins along the circle", "τ", step=0.001
    )
    """Of each pin of the ring, as the output turns."""
    ring_pin_radius_mm: Maybe[PerRingPin] = quantity("Ring pin radii", "Δr", step=0.001)
    """Of the radius of each pin of the ring."""

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
    """Of the teeth."""
    teeth_difference: Maybe[Whole] = quantity("Difference of teeth", "z₃ − z₂", ge=1, le=1000)
    """Teeth of the ring less those of a satellite; that of the mechanism's teeth where these are
    given."""
    reference_pressure_angle_deg: Maybe[float] = quantity(
        "Reference pressure angle", "α", step=0.5, ge=1, le=60
    )
    """Of the teeth; 20° where not given."""
    root_strength_MPa: Maybe[Size] = quantity("Strength of the tooth root", "σ_FG", step=10)
    """Stress that the root of a satellite's tooth bears over the life, in the direction of the
    torque or in both; the safety in fatigue is on it."""
    radial_force_ratio: Maybe[float] = quantity(
        "Ratio of the ring's forces", "ρ", step=0.05, ge=-100, le=100
    )
    """Force along the crank over that across it: positive towards the reducer's axis, as with
    involute teeth, negative outwards, as with a ring of pins."""

    rotates: Maybe[bool] = quantity("Ring pins rotate", advanced=True)
    """Whether the pins turn in their supports: then their bending is fully reversed."""
    tool_radius_mm: Maybe[Size] = quantity("Radius of the tool", "r_t", step=1, advanced=True)
    """Of the wheel or cutter that makes the flanks of the discs, which has to reach into their
    valleys."""
    every_second_pin: Maybe[bool] = quantity("Every second pin", advanced=True)
    """Whether every second pin of the ring is left out, of an even number: the forces of such a
    ring are not calculated."""

    ring_class: Maybe[RingClass] = quantity("How the ring is made", advanced=True)
    """Ground, machined or printed, discs and ring: what is usual of their modification and of the
    places of the ring's pins, where these are not known; printed where discs are softer than
    20 GPa, else ground, where not given."""

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
