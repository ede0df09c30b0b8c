"""Satellites, ring and what holds it: fields of a request about their mesh."""

from typing import Annotated, Any, ClassVar, Literal, Self

from pydantic import Field, field_validator, model_validator

from app.calculations.contact_force import application_factor
from app.calculations.design import input_speed
from app.calculations.hertz import Material, contact_length, eccentricity, material_of
from app.calculations.mechanism import MAX_SATELLITES
from app.calculations.real_mechanism import (
    ContactLawFields,
    PerSatellite,
    PhasePerSatellite,
    SatelliteCouplingFields,
)
from app.model import (
    NO_DUST,
    Angle,
    Forms,
    Kinds,
    Maybe,
    RequestModel,
    Size,
    Whole,
    field_error,
    no_dust,
    quantity,
)
from app.problems import invalid_input, wrong
from app.units import to_si
from core.design.sections import MechanismSection
from core.output.contact_law import PinSupport
from core.results import Notice
from core.ring.sharing import (
    RingDeviations,
)

OF_SUPPORTS = ("span_mm", "satellite_positions_mm")
"""What ring pins have that bend."""

Change = Annotated[float, Field(ge=-0.5, le=0.5)]

RingDeviation = Annotated[float, Field(ge=-0.2, le=0.2)]

PerRingPin = Annotated[list[RingDeviation], Field(min_length=1, max_length=1000)]


class RingTeethFields(RequestModel, group="mechanism"):
    """Teeth and cranks; the pins of the output are not needed here."""

    ALTERNATIVES: ClassVar[tuple[Forms, ...]] = (
        (("crank_spacing_deg",), ("crank_angles_deg",), ()),
    )
    ASSUMED: ClassVar[tuple[str, ...]] = ("satellites",)

    satellite_teeth: Whole = quantity("Satellite teeth", "z₂", step=1, ge=2, le=999)
    """Teeth of a satellite, the lobes of a cycloid disc."""
    ring_teeth: Whole = quantity("Ring teeth", "z₃", step=1, ge=3, le=1000)
    """Teeth or pins of the ring; pins are one more than a disc has lobes."""
    satellites: Whole = quantity("Satellites", "K", default=2, step=1, ge=1, le=MAX_SATELLITES)
    """Number of satellites, each on its own crank."""
    crank_spacing_deg: Maybe[Angle] = quantity("Crank spacing", "α", step=15)
    """Angle between neighbouring cranks; 360°/K where not given."""
    crank_angles_deg: Maybe[list[Angle]] = quantity(
        "Crank angles", "α₁ … α_K", min_length=1, max_length=MAX_SATELLITES
    )
    """Angle of each crank, one for each satellite, instead of an even spacing."""
    pins: Maybe[Whole] = quantity("Pins", "N", step=1, ge=1, le=10_000)
    """Number of pins of the output link; not needed here."""

    @model_validator(mode="after")
    def _counts(self) -> Self:
        angles = self.crank_angles_deg
        if angles is not None and "satellites" not in self.model_fields_set:
            self.satellites = len(angles)
        if angles is not None and len(angles) != self.satellites:
            count = {"expected": self.satellites, "actual": len(angles)}
            raise field_error("crank_angles_deg", "different_length", **count)
        return self

    @property
    def pairs(self) -> int:
        """Number of pairs of pins and discs."""
        return self.ring_teeth * self.satellites

    @property
    def crank_angles(self) -> tuple[float, ...]:
        """Crank angles, rad."""
        angles = to_si("crank_angles_deg", self.crank_angles_deg)
        section = MechanismSection(
            pins=self.ring_teeth,
            satellites=self.satellites,
            ratio=float(self.satellite_teeth),
            crank_spacing=to_si("spacing_deg", self.crank_spacing_deg),
            crank_angles=angles and tuple(angles),
        )
        return section.built.crank_angles


class RingLoadFields(RequestModel, group="load"):
    """Torque and speed."""

    output_torque_Nm: Size = quantity("Output torque", "T", step=10)
    """Torque of all discs on the output."""
    torque_direction: Literal["driving", "reverse"] = quantity(
        "Direction of the torque", default="driving"
    )
    """Driving: the satellites turn the output; reverse: the load turns them back."""
    application_factor: Maybe[Size] = application_factor(
        help="Factor on the torque for the stresses of involute teeth; not of cycloid discs."
    )
    input_speed_rpm: Maybe[Size] = input_speed()
    pin_circle_radius_mm: Maybe[Size] = quantity("Pin circle radius", "R", step=1)
    """Radius of the circle of the output's pins; not needed here."""


class RingCrankFields(RequestModel, group="contact"):
    """The crank."""

    eccentricity_mm: Size = eccentricity()


class ModificationFields(RequestModel, group="gear"):
    """By what the tool that cuts the discs is set off from the ring's pins."""

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
    """By which the flanks are turned to either side; in first order only."""

    _sizes = field_validator("equidistant_mm", "pin_circle_mm", "rotation_arcmin")(no_dust)


class CycloidRingFields(RequestModel, group="gear"):
    """Cycloid discs and the pins of their ring."""

    ASSUMED: ClassVar[tuple[str, ...]] = ("pin_material", "disc_material")
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

    kind: Literal["cycloid"] = quantity("Ring")
    """Pins on which a cycloid disc rolls."""
    ring_pin_circle_radius_mm: Size = quantity("Circle of the ring's pins", "R_p", step=1)
    """Radius of the circle of the ring's pins, on which a cycloid disc rolls."""
    ring_pin_radius_mm: Size = quantity("Radius of the ring's pins", "r", step=0.5)
    """Of the pins, or of their sleeves."""
    contact_length_mm: Size = contact_length()
    modification: Maybe[ModificationFields] = None
    pin_material: Material = quantity("Pin material", default="steel_bearing")
    """A name of the table of materials, or values."""
    disc_material: Material = quantity("Disc material", default="steel_through_hardened")
    """A name of the table of materials, or values."""
    pin_support: Literal["seat", "supported", "fixed"] = quantity(
        "Support of the ring's pins", default="seat", advanced=True
    )
    """In half a bore (seat), held at both ends free to tilt (supported), or built in (fixed)."""
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
    """Of what slides on the ring's pins; without it no loss is answered."""
    sleeve_bore_radius_mm: Maybe[Size] = quantity("Bore of the sleeves", "r_i", step=0.5)
    """Radius of the bore of sleeves on the ring's pins, in which these slide."""
    rolling: bool = quantity("Rolling elements", default=False, advanced=True)
    """Whether rolling elements carry the sleeves: nothing slides."""

    @model_validator(mode="after")
    def _held(self) -> Self:
        for name in OF_SUPPORTS:
            given = getattr(self, name) is not None
            if given and self.pin_support == "seat":
                raise field_error(name, "of_another_kind", kind="seat")
            if not given and self.pin_support != "seat":
                raise field_error(name, "needed_beside", field="pin_support")
        return self

    def notices(self) -> tuple[Notice, ...]:
        """That nothing is known of the modification."""
        unknown = self.modification is None
        return super().notices() + ((Notice("modification_unknown"),) if unknown else ())

    def pin(self) -> PinSupport | None:
        """How the ring's pins bend, in SI units; not at all in seats."""
        if self.pin_support == "seat":
            return None
        inner = self.sleeve_bore_radius_mm or self.ring_pin_radius_mm
        return PinSupport(
            support=self.pin_support,
            diameter=2 * to_si("radius_mm", inner),
            satellite_positions=tuple(to_si("satellite_positions_mm", self.satellite_positions_mm)),
            material=material_of(self.pin_material),
            span=to_si("span_mm", self.span_mm),
        )


class RingPinDeviationsFields(RequestModel, group="deviations"):
    """What the pins of a ring deviate from their nominal sizes."""

    ring_pin_radial_mm: Maybe[PerRingPin] = quantity("Ring pins outward", "ρ", step=0.001)
    """Of each pin of the ring, outward; the first faces the crank at the crank angle 0."""
    ring_pin_tangential_mm: Maybe[PerRingPin] = quantity(
        "Ring pins along the circle", "τ", step=0.001
    )
    """Of each pin of the ring, as the output turns."""
    ring_pin_radius_mm: Maybe[PerRingPin] = quantity("Ring pin radii", "Δr", step=0.001)
    """Of the radius of each pin of the ring."""


class RingDeviationsFields(RingPinDeviationsFields, group="deviations"):
    """What a ring and its discs deviate from their nominal sizes. Positive: outward, as the output
    turns, larger, ahead.
    """

    eccentricity_mm: Maybe[PerSatellite] = quantity("Eccentricities", "Δe", step=0.001)
    """Of each crank."""
    crank_phase_deg: Maybe[PhasePerSatellite] = quantity("Crank phases", "Δα", step=0.001)
    """Angle of each crank, positive ahead."""
    disc_phase_deg: Maybe[PhasePerSatellite] = quantity("Disc phases", "η", step=0.001)
    """Angle of each disc's holes against its teeth, positive ahead."""

    def section(self) -> RingDeviations:
        """The deviations in SI units."""
        own = self.to_core()
        return RingDeviations(
            **{name.removeprefix("ring_"): tuple(value) for name, value in own.items()}
        )

    def refuse_other_lengths(self, pins: int, satellites: int) -> None:
        """Refuse lists that do not fit the ring.

        Raises
        ------
        Problem
            If there are.
        """
        counts = [
            (name, pins if name.startswith("ring") else satellites, len(value))
            for name, value in self
            if value is not None
        ]
        errors = [
            wrong(f"/deviations/{name}", "different_length", expected=want, actual=have)
            for name, want, have in counts
            if want != have
        ]
        if errors:
            raise invalid_input(errors)


class MeshCouplingFields(SatelliteCouplingFields, group="satellite_coupling"):
    """How the discs share the torque."""

    KINDS: ClassVar[Kinds] = {"rigid": ((), ()), "shares": (("shares",), ())}

    kind: Literal["rigid", "shares"] = quantity("Coupling of the satellites", default="rigid")
    """Rigid: all have one lag; shares: each carries a given share."""


class MeshLawFields(ContactLawFields, group="contact_law"):
    """How a pair gives under a force: the teeth do not wrap around the pins."""

    KINDS: ClassVar[Kinds] = {
        kind: rules for kind, rules in ContactLawFields.KINDS.items() if kind != "conformal"
    }

    kind: Maybe[Literal["hertz", "palmgren", "linear", "power"]] = quantity("Law of contact")
    """Hertz: line contact with its logarithm; Palmgren: rollers of steel; linear; power. Where not
    given, Hertz."""
