"""Design document as shared by the whole design and its single calculations: mechanism, load,
contact, output mechanism as it is made, and the forces that follow.
"""

import math
from collections import ChainMap
from collections.abc import Iterator
from dataclasses import fields, replace
from functools import cached_property, partial
from typing import Annotated, Any, ClassVar, Literal, Self, TypeVar, cast

from pydantic import AfterValidator, Field, field_validator, model_validator

from app.calculations.contact_law import ContactLawFields
from app.calculations.hertz import (
    Material,
    distribution_factor,
    eccentricity,
    material_of,
    of_load_factor,
)
from app.calculations.ideal_forces import (
    LoadFields,
    TorqueFields,
    application_factor,
    force_of_one,
    peak_torque,
)
from app.calculations.mechanism import MechanismFields, PinContactFields
from app.calculations.pin import HeldPinFields, PinBoltFields, pin_places, strengths_of
from app.calculations.pin_rollers import RollersFields
from app.calculations.ring import RING_PIN_LISTS, RingPinDeviationsFields
from app.document import SectionFields
from app.model import (
    LARGEST,
    NO_DUST,
    Maybe,
    RequestModel,
    Size,
    no_dust,
    notices_of,
    quantity,
    result,
)
from app.problems import invalid_input, refusal, wrong
from app.rules import Forms, Rule, field_error
from app.settings import Settings
from app.units import to_si
from core.arrays import FloatArray
from core.design.document import Design
from core.design.results import Results
from core.design.sections import (
    DesignPin,
    Load,
    PeakKind,
    Requirements,
    SatelliteBody,
    Temperatures,
)
from core.errors import Notice, if_known, required
from core.output.contact_force import drawing_angles
from core.output.elasticity import (
    COUPLINGS,
    RIGID_SUPPORT,
    CrankSupport,
    PinSupport,
    SatelliteSupport,
    Supports,
)
from core.output.mechanism import Mechanism, PinFit, pin_fit
from core.output.room import OF_RING_PINS, Deviations
from core.output.sampled_turn import Direction

Phase = Annotated[float, Field(ge=-360, le=360)]

torque_direction = partial(
    quantity,
    "Direction of the torque",
    default="driving",
    help="Driving: the satellites turn the pins; reverse: the load turns the pins back; "
    "alternating: both directions are solved, and the answer gives the worse one.",
)


class RealLoadFields(TorqueFields, group="load"):
    """Torque, its direction, and its lever; the force exponent is that of the contact law."""

    torque_direction: Direction = torque_direction()

    def signed_torque(self, torque: float) -> float:
        """Torque with the sign of its direction, N*m."""
        return -torque if self.torque_direction == "reverse" else torque


class OneWayLoadFields(RealLoadFields, group="study"):
    """Torque in one direction."""

    torque_direction: Literal["driving", "reverse"] = quantity(
        "Direction of the torque", default="driving"
    )
    """Driving: the satellites turn the pins; reverse: the load turns the pins back."""


class RealContactFields(PinContactFields, group="contact"):
    """Pin, hole, crank and clearance. Forces and pressures are those at the torque, as the dynamic
    factor is for checks.
    """

    eccentricity_mm: Size = eccentricity()
    distribution_factor: float = distribution_factor(ge=1e-12, le=1)

    def sizes(self) -> dict[str, Any]:
        """Sizes and materials in SI units, as the core's arguments."""
        return {
            "contact_length": to_si("contact_length_mm", self.contact_length_mm),
            "pin_radius": to_si("pin_radius_mm", self.pin_radius_mm),
            "eccentricity": to_si("eccentricity_mm", self.eccentricity_mm),
            "clearance": to_si("clearance_mm", self.clearance_mm()),
            "pin_material": material_of(self.pin_material),
            "hole_material": material_of(self.hole_material),
        }


class BentPinFields(HeldPinFields, group="pin"):
    """Supports of the pins, and places where the satellites load them."""

    diameter_mm: Maybe[Size] = quantity("Pin diameter", "d", step=0.5)
    """Diameter of the pin itself, inside its sleeve or its rollers where it has them."""
    bore_diameter_mm: float = quantity(
        "Bore of the pin", "d_i", default=0.0, step=0.5, ge=0, le=LARGEST, schema=NO_DUST
    )
    """Diameter of the pin's bore, up to 0.95 of the pin diameter; 0 for a solid pin."""
    material: Maybe[Material] = quantity("Material of the pin")
    """Name in the table of materials, or values; the pin material of the contact if not given."""

    _bore_size = field_validator("bore_diameter_mm")(no_dust)

    def held(self, *around: dict[str, Any]) -> PinSupport:
        """Pin in SI units; diameter, m, and material not given come from the first of `around`."""
        own = ChainMap(self.to_core(), *around)
        return PinSupport(
            support=self.support,
            diameter=own["diameter"],
            satellite_positions=own.get("satellite_positions", ()),
            material=material_of(own["material"]),
            span=own.get("span"),
            bore_diameter=own["bore_diameter"],
            ring_joint=self.ring_joint or "pinned",
        )


class CrankSupportFields(SectionFields, of=CrankSupport, group="crank_support"):
    """Bearings of the satellites on their cranks. The force of the ring on them is left out."""

    gives: ClassVar[bool] = True


class SatelliteCouplingFields(
    SectionFields,
    of={kind: COUPLINGS[kind] for kind in ("rigid", "elastic", "shares")},
    group="satellite_coupling",
):
    """Sharing of the torque between the satellites."""

    kind: Literal["rigid", "elastic", "shares"] = quantity(
        "Coupling of the satellites", default="rigid"
    )
    """Rigid: all satellites turn as one; elastic: each satellite gives in its mesh with the ring;
    shares: each satellite carries a given share."""

    @property
    def gives(self) -> bool:
        """True if the coupling makes the satellites elastic."""
        return self.kind != "rigid"


GIVING = ("crank_support", "satellite_coupling")
"""Sections that state the elasticity of the satellites."""


class GivingFields(RequestModel):
    """Elasticity of the satellites on their cranks and in their mesh."""

    crank_support: Maybe[CrankSupportFields] = None
    satellite_coupling: Maybe[SatelliteCouplingFields] = None

    def assumed(self) -> Iterator[tuple[tuple[str, ...], Any]]:
        """Assumed values, with the material of pins taken from the contact."""
        yield from super().assumed()
        match self.given:
            case {"pin": BentPinFields(material=None), "contact": PinContactFields() as contact}:
                given = contact.pin_material
                values = given if isinstance(given, str) else given.model_dump(exclude_none=True)
                yield ("pin", "material"), values

    @property
    def around_pins(self) -> list[dict[str, Any]]:
        """Values that pins take from surrounding parts if not given, the nearest part first."""
        given = self.given
        return [given[name].surface for name in ("rollers", "contact") if name in given]

    def refuse_of_a_coupling(self, *sections: str) -> None:
        """Refuse named sections that a pin coupling of two shafts does not have."""
        for name in sections:
            if self.says(name):
                raise field_error(name, "of_other_output", output="coupling")

    @property
    def tied(self) -> bool:
        """True if a tie ring joins the pins."""
        pin = getattr(self, "pin", None)
        return getattr(pin, "support", None) == "tie_ring"

    @property
    def giving(self) -> list[str]:
        """Sections that make the satellites elastic."""
        given = self.given
        return [name for name in GIVING if name in given and given[name].gives]

    @cached_property
    def support(self) -> SatelliteSupport:
        """Elasticity of the satellites."""
        given = self.given
        return Supports(
            *(given[name].section() if name in given else RIGID_SUPPORT for name in GIVING)
        )

    def refuse_other_shares(self, satellites: int) -> None:
        """Refuse shares that are not one for each satellite."""
        shares = self.support.given_shares
        if shares and len(shares) != satellites:
            counts = {"expected": satellites, "actual": len(shares)}
            raise refusal("/satellite_coupling/shares", "different_length", **counts)


class DeviationsFields(SectionFields, of=Deviations, without=OF_RING_PINS, group="deviations"):
    """Deviations of a piece from its nominal sizes: of each pin, of each hole satellite by
    satellite, of each crank or disc. Positive means outward, in the driving sense, larger, ahead.
    """

    def refuse_other_lengths(self, pins: int, satellites: int) -> None:
        """Refuse lists that do not fit the mechanism."""
        errors = [
            wrong(f"/deviations/{place}", "different_length", expected=want, actual=have)
            for place, want, have in self._lengths(pins, satellites)
            if want != have
        ]
        if errors:
            raise invalid_input(errors)

    def _lengths(self, pins: int, satellites: int) -> Iterator[tuple[str, int, int]]:
        for name, value in self.given.items():
            if name.startswith("ring"):
                continue
            if not name.startswith("hole"):
                yield name, pins if name.startswith("pin") else satellites, len(value)
                continue
            yield name, satellites, len(value)
            for index, row in enumerate(value):
                yield f"{name}/{index}", pins, len(row)


ForcesUsed = Literal["ideal", "real"]

Result = TypeVar("Result")

Speed = Annotated[float, Field(ge=-1e6, le=1e6, json_schema_extra=NO_DUST), AfterValidator(no_dust)]
"""Speed with a sign for its sense."""

input_speed = partial(quantity, "Input speed", "n₁", step=50, help="Speed of the crankshaft.")


OF_BOTH = "ring_speed_rpm", "carrier_speed_rpm"
"""Speeds of which one is given if ring and pins are both outputs."""

RINGLESS = "gear", "bearing", "crankshaft"
"""Sections that a coupling does not have."""


class DesignLoadFields(LoadFields, group="load"):
    """Load with the direction of its torque, its speed and its variation."""

    torque_direction: Direction = torque_direction()
    input_speed_rpm: Maybe[Size] = input_speed()
    application_factor: Maybe[Size] = application_factor()
    peak_torque_Nm: Maybe[Size] = peak_torque()
    peak_kind: PeakKind = quantity("Kind of the peak", default="start", advanced=True)
    """Event of the peak torque: a start, which happens again and again and needs a static safety of
    bearings of 1.5, or an emergency stop, which needs 1."""
    ring_speed_rpm: Maybe[Speed] = quantity("Ring speed", "n_r", step=10, advanced=True)
    """Speed of the ring if ring and pins are both outputs, positive in the sense of the crank."""
    carrier_speed_rpm: Maybe[Speed] = quantity("Speed of the pins", "n_c", step=10, advanced=True)
    """Speed of the pins if ring and pins are both outputs, positive in the sense of the crank;
    given instead of the ring's speed."""

    ALTERNATIVES: ClassVar[tuple[Forms, ...]] = ((("ring_speed_rpm",), ("carrier_speed_rpm",), ()),)

    def notices(self) -> tuple[Notice, ...]:
        """Notices, also of an application factor below 1."""
        return super().notices() + of_load_factor(self.application_factor)

    def section(self, whole: Any) -> Load:
        """The load in SI units."""
        return Load(
            output_torque=self.torque(whole.mechanism.members),
            pin_circle_radius=to_si("radius_mm", self.pin_circle_radius_mm),
            force_exponent=self.force_exponent,
            torque_direction=self.torque_direction,
            input_speed=to_si("input_speed_rpm", self.input_speed_rpm),
            application_factor=self.application_factor or whole.older_factor or 1.0,
            peak_torque=self.peak_torque_Nm,
            peak_kind=self.peak_kind,
            ring_speed=to_si("speed_rpm", self.ring_speed_rpm),
            carrier_speed=to_si("speed_rpm", self.carrier_speed_rpm),
        )


class DrivenLoadFields(DesignLoadFields, group="load"):
    """Load with the direction of its torque and its speed."""

    input_speed_rpm: Size = input_speed()


class DesignPinFields(BentPinFields, group="pin"):
    """Pin with its support, bending and strength."""

    contact_length_mm: Maybe[Size] = quantity("Contact length", "b", step=1)
    """Length of the contact along the pin, which is the width of the satellite."""
    rotates: bool = quantity("Pin rotates", default=False)
    """True if the pin turns in the carrier, so that its bending is fully reversed."""
    bolt: Maybe[PinBoltFields] = None

    def section(self, whole: Any) -> DesignPin:
        """Pin in SI units; values not given come from the surrounding parts."""
        held = self.held(*whole.around_pins)
        own = ChainMap(self.to_core(), *whole.around_pins)
        return DesignPin(
            support=held.support,
            diameter=held.diameter,
            satellite_positions=held.satellite_positions,
            span=held.span,
            bore_diameter=held.bore_diameter,
            ring_joint=held.ring_joint,
            contact_length=to_si("contact_length_mm", self.contact_length_mm),
            rotates=self.rotates,
            bolt=own.get("bolt"),
            **strengths_of(own["material"]),
        )


class SleevedPinFields(DesignPinFields, group="pin"):
    """Pin inside its sleeve, which bends if the places of the satellites are given."""

    satellite_positions_mm: Maybe[list[Size]] = pin_places()  # type: ignore[assignment]


class DesignDeviationsFields(DeviationsFields, RingPinDeviationsFields, group="deviations"):
    """Deviations of a piece from its nominal sizes: of each pin, of each hole satellite by
    satellite, of each crank or disc, of each ring pin. Positive means outward, in the driving
    sense, larger, ahead.
    """

    @property
    def of_ring_alone(self) -> bool:
        """True if deviations of ring pins alone are stated."""
        given = {*self.given}
        return bool(given) and given <= {*RING_PIN_LISTS}


class DesignFields(GivingFields):
    """Mechanism, load and contact, and all inputs that change the forces.

    If clearance, deviations, a contact law or elastic satellites are given, forces are those of the
    mechanism as it is made, as in `/load-sharing`, and the pins bend. Otherwise forces are ideal
    and shared equally by the satellites.
    """

    BETWEEN: ClassVar[tuple[Rule, ...]] = (
        Rule("contact/pin_radius_mm", "needed_beside", "rollers"),
        Rule("friction/coefficient", "only_one", "rollers/friction_coefficient"),
    )

    mechanism: MechanismFields
    load: Maybe[DesignLoadFields] = None
    contact: Maybe[PinContactFields] = None
    contact_law: Maybe[ContactLawFields] = None
    deviations: Maybe[DesignDeviationsFields] = None
    pin: Maybe[DesignPinFields] = None
    rollers: Maybe[RollersFields] = None

    @model_validator(mode="after")
    def _of_a_coupling(self) -> Self:
        if self.mechanism.output == "coupling":
            self.refuse_of_a_coupling(*GIVING, *RINGLESS)
        return self

    @model_validator(mode="after")
    def _speeds_of_both(self) -> Self:
        load, both = self.load, self.mechanism.output == "both"
        if load is None:
            return self
        given = [name for name in OF_BOTH if name in load.given]
        driven = load.input_speed_rpm is not None
        if given and not both:
            raise field_error(f"load/{given[0]}", "of_other_output", output=self.mechanism.output)
        if given and not driven:
            raise field_error("load/input_speed_rpm", "needed_beside", field=given[0])
        if both and not given and driven:
            raise field_error(f"load/{OF_BOTH[0]}", "needed_beside", field="input_speed_rpm")
        return self

    @model_validator(mode="after")
    def _pin_in_sleeve(self) -> Self:
        friction = getattr(self, "friction", None)
        if friction is not None and friction.sleeve and self.pin is None:
            raise field_error("pin", "needed_beside", field="sleeve")
        return self

    @model_validator(mode="after")
    def _teeth_agree(self) -> Self:
        gear = getattr(self, "gear", None)
        if gear is not None:
            gear.refuse_other_teeth(self.mechanism.teeth_difference)
            if self.contact is not None:
                gear.refuse_other_discs(self.contact.hole_material)
        listed = [name for name in RING_PIN_LISTS if self.says(f"deviations/{name}")]
        of_ring = "gear" not in type(self).model_fields or self.ring_kind == "cycloid"
        if listed and not of_ring:
            raise field_error("gear", "needed_beside", field=listed[0])
        return self

    @model_validator(mode="after")
    def _no_assumed_sharing(self) -> Self:
        if self.as_made and self.contact and self.contact.distribution_factor > 1:
            raise field_error("contact/distribution_factor", "with_real_forces")
        return self

    @model_validator(mode="after")
    def _one_application_factor(self) -> Self:
        given = self.load.application_factor if self.load else None
        if None not in (given, self.older_factor) and given != self.older_factor:
            raise field_error("load/application_factor", "only_one", field="dynamic_factor")
        return self

    @property
    def older_factor(self) -> float | None:
        """Application factor where requests of before had it, beside the contact."""
        return self.contact.dynamic_factor if self.contact else None

    @property
    def ring_kind(self) -> str | None:
        """Kind of the mesh with the ring, if a ring is given and states it."""
        return getattr(self.given.get("gear"), "kind", None)

    @property
    def known_load(self) -> DesignLoadFields:
        """Load, for results that need one."""
        load: DesignLoadFields = self.given["load"]
        return load

    @cached_property
    def as_made(self) -> bool:
        """True if clearance, deviations, a contact law or elastic satellites are given."""
        loose = self.contact is not None and self._clearance_mm(self.contact) > 0
        made = self.deviations is not None and not self.deviations.of_ring_alone
        return loose or made or bool(self.giving) or self.contact_law is not None

    def _clearance_mm(self, contact: PinContactFields) -> float:
        """Known radial clearance, with the play of rollers."""
        given = contact.clearance_mm()
        if self.rollers is None or contact.clearance_unknown:
            return given
        return given + (self.rollers.radial_clearance_mm or 0.0) / 2

    def without(self, path: tuple[str, ...]) -> dict[str, Any]:
        """Ideal peak force of one satellite, if the number of satellites is assumed."""
        if path != ("mechanism", "satellites") or self.load is None:
            return {}
        return force_of_one(self.mechanism, self.load)

    def notices(self) -> tuple[Notice, ...]:
        """Notices, also of a ratio that no cycloid disc with one lobe less has."""
        gear: Any = self.given.get("gear")
        found = super().notices()
        one_lobe_less = self.ring_kind == "cycloid" and (gear.teeth_difference or 1) == 1
        if one_lobe_less and self.mechanism.teeth is None:
            ratio = self.mechanism.ratio_given()
            if not ratio.is_integer():
                found += (Notice("ratio_not_whole", {"ratio": ratio}),)
        return found

    @property
    def forces(self) -> ForcesUsed:
        """Kind of forces that the results follow from."""
        return "real" if self.results.solved else "ideal"

    def cost(self) -> float:
        """Number of points of ideal forces; infinite for solved forces and bent pins."""
        if self.as_made or self.pin is not None or self.load is None:
            return math.inf
        return self.mechanism.points(exponent=self.load.force_exponent)

    def refuse_beyond(self, settings: Settings) -> None:
        """Refuse too many pairs, and lists that do not fit the mechanism."""
        self.mechanism.refuse_beyond(settings)
        self.refuse_other_shares(self.mechanism.satellites)
        if self.deviations is not None:
            self.deviations.refuse_other_lengths(self.mechanism.pins, self.mechanism.satellites)
            if self.deviations.ring_lists:
                self.deviations.refuse_other_ring(if_known(lambda: self.design.ring_pins))
        super().refuse_beyond(settings)

    @cached_property
    def built(self) -> Mechanism:
        """Mechanism, built once."""
        return self.mechanism.mechanism()

    def parts(self) -> dict[str, Any]:
        """Given sections of the design, by their names in it."""
        given = self.given
        return {each.name: given[each.name] for each in fields(Design) if each.name in given}

    @cached_property
    def design(self) -> Design:
        """Design in SI units, without requirements that the request cannot state."""
        sections = {name: each.section(self) for name, each in self.parts().items()}
        return Design(**{"requirements": Requirements(life=math.inf)} | sections)

    @cached_property
    def results(self) -> Results:
        """Results of the design, with satellites of perfect parts sharing equally."""
        return Results(self.design, equal=True)

    def with_fit(self, result: Result) -> Result:
        """Result with notices about the fit of pins and holes."""
        fit = notices_of(if_known(self.solve_fit))
        notices = (*fit, *notices_of(result))
        return cast(Result, replace(cast(Any, result), notices=notices))

    def drawn_angles(self) -> tuple[FloatArray, FloatArray]:
        """Crank angles of a figure's curves with the switching angles of ideal pairs, rad."""
        angles, switching = drawing_angles(mechanism=self.built)
        return angles, switching[:0] if self.results.solved else switching

    def solve_fit(self) -> PinFit:
        """Fit of pins in holes; `NotKnown` without pins."""
        load, contact = self.design.load, self.design.contact
        lacks = ("section_missing", "contact")
        return pin_fit(
            pins=self.mechanism.pins,
            pin_radius=required(contact.pin_radius, *lacks),
            hole_radius=required(contact.hole_radius, *lacks),
            eccentricity=contact.eccentricity,
            pin_circle_radius=load.pin_circle_radius if load else math.inf,
        )


def forces_used() -> Any:
    """Field of an answer that states the kind of forces."""
    return result(
        "Forces behind the results: ideal forces, or real forces with clearance, deviations and "
        "elasticity, if these are given or, in the whole design, pins bend."
    )


class SatelliteBodyFields(SectionFields, of=SatelliteBody, group="satellite_body"):
    """Body of a satellite, as far as it is given."""


class TemperaturesFields(SectionFields, of=Temperatures, group="temperatures"):
    """Temperatures of the parts at work, by which plastics are judged."""
