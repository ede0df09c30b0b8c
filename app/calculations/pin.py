"""The pin as a section of a design: beam, material, and what its fatigue is judged by."""

from dataclasses import replace
from functools import partial
from typing import Annotated, Any, ClassVar, Self

from pydantic import ConfigDict, Discriminator, Field, Tag, model_validator

from app.calculations.hertz import MaterialFields, MaterialName
from app.calculations.mechanism import MAX_SATELLITES
from app.calculations.output_efficiency import SleevedPinFields
from app.model import SIZE, Forms, Maybe, RequestModel, field_error, quantity, request_schema
from app.units import to_si
from core.checks.sections import FatigueBasis
from core.fatigue import Criterion, Edition, Surface
from core.materials import MATERIALS, ElasticMaterial
from core.output.pin_beam import Support

STEEL_GPA = 190.0, 220.0
"""Young's moduli of steels: for them only there is a rule of the endurance limit."""


class PinMaterialFields(MaterialFields):
    """A material of a pin by its values."""

    tensile_strength_MPa: Maybe[float] = quantity(
        "Tensile strength",
        symbol="R_m",
        group="material",
        default=None,
        **SIZE,
        step=10,
        help="Tensile strength: what fatigue is judged by.",
    )

    def material(self) -> ElasticMaterial:
        """The material in SI units, without its tensile strength."""
        return MaterialFields.material(self.model_copy(update={"tensile_strength_MPa": None}))


def strengths_of(given: str | MaterialFields) -> dict[str, Any]:
    """Material of a pin with its yield strength, and what its strength is judged by, as
    `core.checks.sections.DesignPin` names it.
    """
    if isinstance(given, str):
        entry = MATERIALS[given]
        strength = entry.strength
        return {
            "material": replace(entry.material, yield_strength=strength.yield_strength),
            "tensile_strength": strength.tensile,
            "steel": entry.group == "steel",
            "valid_diameter": strength.valid_diameter,
        }
    low, high = STEEL_GPA
    return {
        "material": given.material(),
        "tensile_strength": to_si("strength_MPa", getattr(given, "tensile_strength_MPa", None)),
        "steel": low <= given.youngs_modulus_GPa <= high,
        "own_material": True,
    }


def _kind(given: object) -> str:
    return "name" if isinstance(given, str) else "values"


PinMaterial = Annotated[
    Annotated[MaterialName, Tag("name")] | Annotated[PinMaterialFields, Tag("values")],
    Discriminator(_kind),
]


def _held_schema(schema: dict[str, Any], model: type[RequestModel]) -> None:
    """Two supports need their span."""
    request_schema(schema, model)
    schema["if"] = {
        "properties": {"support": {"enum": ["supported", "fixed"]}},
        "required": ["support"],
    }
    schema["then"] = {"required": ["span_mm"]}


class HeldPinFields(RequestModel):
    """How the pins are held, and where the satellites load them."""

    satellite_positions_mm: list[Annotated[float, Field(**SIZE)]] = quantity(
        "Places of the satellites",
        symbol="z₁ … z_K",
        group="pin",
        min_length=1,
        max_length=MAX_SATELLITES,
        help="Middle plane of each satellite, from the face of the carrier.",
    )
    support: Support = quantity(
        "Support",
        symbol="",
        group="pin",
        default="cantilever",
        help="Held at one end (cantilever), at both ends free to tilt (supported), or at both "
        "ends built in (fixed); the truth of a cage lies between the latter two.",
    )
    span_mm: Maybe[float] = quantity(
        "Span",
        symbol="L",
        group="pin",
        default=None,
        **SIZE,
        step=1,
        help="Distance of the two supports; not for a cantilever.",
    )

    model_config = ConfigDict(json_schema_extra=_held_schema)

    @model_validator(mode="after")
    def _span_of_two_supports(self) -> Self:
        if self.support != "cantilever" and self.span_mm is None:
            raise field_error("span_mm", "needed_beside", field="support")
        return self


pin_length = partial(
    quantity,
    "Contact length",
    symbol="b",
    group="pin",
    **SIZE,
    step=1,
    help="Length of the contact along the pin: the width of the satellite.",
)
pin_rotates = partial(
    quantity,
    "Pin rotates",
    symbol="",
    group="pin",
    default=False,
    help="Whether the pin turns in the carrier: then its bending is fully reversed.",
)


class PinSectionFields(HeldPinFields, SleevedPinFields):
    """The pin as a beam."""

    contact_length_mm: float = pin_length()
    rotates: bool = pin_rotates()
    material: PinMaterial = quantity(
        "Material of the pin",
        symbol="",
        group="pin",
        help="A name of the table of materials, or values; that of the contact where it has one.",
    )


class NotchFields(RequestModel):
    """A notch of the pin where it bends most."""

    theoretical_factor: float = quantity(
        "Stress concentration",
        symbol="K_t",
        group="fatigue",
        ge=1,
        le=100,
        step=0.1,
        help="Elastic stress concentration factor of the notch.",
    )
    radius_mm: float = quantity(
        "Notch radius", symbol="r", group="fatigue", **SIZE, step=0.1, help="Radius of the notch."
    )


class FatigueFields(RequestModel):
    """What the fatigue of the pin is judged by."""

    ALTERNATIVES: ClassVar[tuple[Forms, ...]] = (
        (("surface",), ("surface_factor",), ("endurance_limit_MPa",)),
        (("reliability_percent",), ("reliability_factor",), ()),
        (("fatigue_notch_factor",), ("notch",), ()),
    )

    surface: Maybe[Surface] = quantity(
        "Surface",
        symbol="",
        group="fatigue",
        default=None,
        help="How the surface was made; cold-drawn counts as machined.",
    )
    surface_factor: Maybe[float] = quantity(
        "Surface factor",
        symbol="k_a",
        group="fatigue",
        default=None,
        ge=0.01,
        le=1,
        step=0.05,
        help="Its factor instead.",
    )
    edition: Edition = quantity(
        "Edition",
        symbol="",
        group="fatigue",
        default="shigley_11",
        advanced=True,
        help="Edition of Shigley whose constants of the surface are taken.",
    )
    reliability_percent: Maybe[float] = quantity(
        "Reliability",
        symbol="",
        group="fatigue",
        default=None,
        ge=50,
        le=99.99,
        help="50, 90, 95, 99, 99.9 or 99.99 %; 50 where neither this nor its factor is given.",
    )
    reliability_factor: Maybe[float] = quantity(
        "Reliability factor",
        symbol="k_e",
        group="fatigue",
        default=None,
        ge=0.01,
        le=1,
        step=0.05,
        help="Its factor instead.",
    )
    fatigue_notch_factor: Maybe[float] = quantity(
        "Fatigue notch factor",
        symbol="K_f",
        group="fatigue",
        default=None,
        ge=1,
        le=100,
        step=0.1,
        help="Of the seat or any notch where the pin bends most; 1 says that there is none.",
    )
    notch: Maybe[NotchFields] = None
    endurance_limit_MPa: Maybe[float] = quantity(
        "Endurance limit",
        symbol="S_e",
        group="fatigue",
        default=None,
        **SIZE,
        step=10,
        help="Endurance limit of the pin itself, all factors in it.",
    )
    criterion: Criterion = quantity(
        "Criterion",
        symbol="",
        group="fatigue",
        default="goodman",
        help="How the mean stress counts: Goodman, Gerber, Soderberg or Haigh after FKM.",
    )

    def basis(self) -> FatigueBasis:
        """The same in SI units."""
        own = self.to_core()
        if self.notch is not None:
            radius = to_si("radius_mm", self.notch.radius_mm)
            own["notch"] = self.notch.theoretical_factor, radius
        return FatigueBasis(**own)
