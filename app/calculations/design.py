"""The design document, as far as the whole design and its single calculations share it: mechanism,
load, contact, and the forces that follow.
"""

import math
from collections import ChainMap
from dataclasses import fields, replace
from functools import cached_property, partial
from typing import Annotated, Any, ClassVar, Literal, Self, TypeVar, cast

from pydantic import AfterValidator, Field, model_validator

from app.calculations.contact_force import (
    LoadFields,
    application_factor,
    force_of_one,
    peak_torque,
)
from app.calculations.contact_law import ContactLawFields
from app.calculations.mechanism import MechanismFields
from app.calculations.pin import PinBoltFields, pin_places, strengths_of
from app.calculations.pin_contact import PinContactFields
from app.calculations.pin_rollers import RollersFields
from app.calculations.real_mechanism import (
    GIVING,
    BentPinFields,
    DeviationsFields,
    GivingFields,
    torque_direction,
)
from app.calculations.ring import RING_PIN_LISTS, RingPinDeviationsFields
from app.model import (
    NO_DUST,
    Maybe,
    RequestModel,
    Size,
    no_dust,
    notices_of,
    quantity,
    result,
)
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
from core.errors import if_known, required
from core.output.contact_force import drawing_angles
from core.output.mechanism import Mechanism
from core.output.pin_geometry import PinFit, pin_fit
from core.output.sampled_turn import Direction
from core.results import Notice

ForcesUsed = Literal["ideal", "real"]

Result = TypeVar("Result")

Speed = Annotated[float, Field(ge=-1e6, le=1e6, json_schema_extra=NO_DUST), AfterValidator(no_dust)]
"""A speed with its sense."""

input_speed = partial(quantity, "Input speed", "n₁", step=50, help="Speed of the crankshaft.")


OF_BOTH = "ring_speed_rpm", "carrier_speed_rpm"
"""Speeds of which one is given where ring and pins are both the output."""

RINGLESS = "gear", "bearing", "crankshaft"
"""Sections that a coupling has none of."""


class DesignLoadFields(LoadFields, group="load"):
    """Load with the direction of its torque, its speed, and how it changes."""

    torque_direction: Direction = torque_direction()
    input_speed_rpm: Maybe[Size] = input_speed()
    application_factor: Maybe[Size] = application_factor()
    peak_torque_Nm: Maybe[Size] = peak_torque()
    peak_kind: PeakKind = quantity("Kind of the peak", default="start", advanced=True)
    """Of a start, which comes again and again, or of an emergency stop: static safety of bearings
    1.5 or 1."""
    ring_speed_rpm: Maybe[Speed] = quantity("Ring speed", "n_r", step=10, advanced=True)
    """Where ring and pins are both the output: of the ring, positive in the sense of the crank."""
    carrier_speed_rpm: Maybe[Speed] = quantity("Speed of the pins", "n_c", step=10, advanced=True)
    """The same of the pins, instead."""

    ALTERNATIVES: ClassVar[tuple[Forms, ...]] = ((("ring_speed_rpm",), ("carrier_speed_rpm",), ()),)

    def section(self, whole: Any) -> Load:
        """The load in SI units."""
        return Load(
            output_torque=self.torque(whole.mechanism.members),
            pin_circle_radius=to_si("radius_mm", self.pin_circle_radius_mm),
            force_exponent=self.force_exponent,
            torque_direction=self.torque_direction,
            input_speed=to_si("input_speed_rpm", self.input_speed_rpm),
            application_factor=self.application_factor,
            peak_torque=self.peak_torque_Nm,
            peak_kind=self.peak_kind,
            ring_speed=to_si("speed_rpm", self.ring_speed_rpm),
            carrier_speed=to_si("speed_rpm", self.carrier_speed_rpm),
        )


class DrivenLoadFields(DesignLoadFields, group="load"):
    """The same with its speed."""

    input_speed_rpm: Size = input_speed()


class DesignPinFields(BentPinFields, group="pin"):
    """A pin as it is held, bends and breaks."""

    contact_length_mm: Maybe[Size] = quantity("Contact length", "b", step=1)
    """Length of the contact along the pin: the width of the satellite."""
    rotates: bool = quantity("Pin rotates", default=False)
    """Whether the pin turns in the carrier: then its bending is fully reversed."""
    bolt: Maybe[PinBoltFields] = None

    def section(self, whole: Any) -> DesignPin:
        """The pin in SI units; what is not given is that of what is around it."""
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
    """The pin inside its sleeve; it bends where the places of the satellites are given."""

    satellite_positions_mm: Maybe[list[Size]] = pin_places()  # type: ignore[assignment]


class DesignDeviationsFields(DeviationsFields, RingPinDeviationsFields, group="deviations"):
    """What a piece deviates from its nominal sizes: of each pin, of each hole satellite by
    satellite, of each crank or disc, of each pin of the ring. Positive: outward, in the driving
    sense, larger, ahead.
    """

    @property
    def of_ring_alone(self) -> bool:
        """Whether nothing is stated but of the pins of the ring."""
        given = {*self.given}
        return bool(given) and given <= {*RING_PIN_LISTS}


class DesignFields(GivingFields):
    """Mechanism, load and contact, and all that changes the forces.

    Where clearance, deviations, a contact law or satellites that give are given, the forces are
    those of the mechanism as it is made, as by `/load-sharing`, and the pins bend in series with
    the contacts; in first order where satellites give. Else they are the ideal ones, shared equally
    by the satellites.
    """

    BETWEEN: ClassVar[tuple[Rule, ...]] = (
        Rule("contact/pin_radius_mm", "needed_beside", "rollers"),
        Rule("friction/coefficient", "only_one", "rollers/friction_coefficient"),
        Rule("load/application_factor", "only_one", "contact/dynamic_factor"),
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

    @property
    def ring_kind(self) -> str | None:
        """Kind of the mesh with the ring, where there is one and says it."""
        return getattr(self.given.get("gear"), "kind", None)

    @property
    def known_load(self) -> DesignLoadFields:
        """The load, of what needs one."""
        load: DesignLoadFields = self.given["load"]
        return load

    @cached_property
    def as_made(self) -> bool:
        """Whether clearance, deviations, a law of contact or satellites that give are given."""
        loose = self.contact is not None and self._clearance_mm(self.contact) > 0
        made = self.deviations is not None and not self.deviations.of_ring_alone
        return loose or made or bool(self.giving) or self.contact_law is not None

    def _clearance_mm(self, contact: PinContactFields) -> float:
        """Radial clearance with what rollers add to one that is known."""
        given = contact.clearance_mm()
        if self.rollers is None or contact.clearance_unknown:
            return given
        return given + (self.rollers.radial_clearance_mm or 0.0) / 2

    def without(self, path: tuple[str, ...]) -> dict[str, Any]:
        """The ideal peak force of one satellite, where their number is assumed."""
        if path != ("mechanism", "satellites") or self.load is None:
            return {}
        return force_of_one(self.mechanism, self.load)

    def notices(self) -> tuple[Notice, ...]:
        """Also a ratio that no cycloid disc with one lobe less has."""
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
        """Which forces the results follow from."""
        return "real" if self.results.solved else "ideal"

    def cost(self) -> float:
        """Points of the ideal forces; real ones are solved, and those of bent pins searched."""
        if self.as_made or self.pin is not None or self.load is None:
            return math.inf
        return self.mechanism.points(exponent=self.load.force_exponent)

    def refuse_beyond(self, settings: Settings) -> None:
        """Refuse what exceeds the operator's limits in pairs, and lists of deviations or shares
        that do not fit the mechanism.
        """
        self.mechanism.refuse_beyond(settings)
        self.refuse_other_shares(self.mechanism.satellites)
        if self.deviations is not None:
            self.deviations.refuse_other_lengths(self.mechanism.pins, self.mechanism.satellites)
            if self.deviations.ring_lists:
                self.deviations.refuse_other_ring(if_known(lambda: self.design.ring_pins))
        super().refuse_beyond(settings)

    @cached_property
    def built(self) -> Mechanism:
        """The mechanism, built once."""
        return self.mechanism.mechanism()

    def parts(self) -> dict[str, Any]:
        """The sections of the design that are given, by their names in it."""
        given = self.given
        return {each.name: given[each.name] for each in fields(Design) if each.name in given}

    @cached_property
    def design(self) -> Design:
        """The design in SI units; what a request cannot ask for is not required."""
        sections = {name: each.section(self) for name, each in self.parts().items()}
        return Design(**{"requirements": Requirements(life=math.inf)} | sections)

    @cached_property
    def results(self) -> Results:
        """What follows from it, each result worked out once; perfect parts share equally."""
        return Results(self.design, equal=True)

    def with_fit(self, result: Result) -> Result:
        """A result with the notices of how pins and holes fit."""
        notices = notices_of(if_known(self.solve_fit), result)
        return cast(Result, replace(cast(Any, result), notices=notices))

    def drawn_angles(self) -> tuple[FloatArray, FloatArray]:
        """Crank angles of a figure's curves, and where ideal pairs switch, rad."""
        angles, switching = drawing_angles(mechanism=self.built)
        return angles, switching[:0] if self.results.solved else switching

    def solve_fit(self) -> PinFit:
        """How pins and holes fit; `NotKnown` without pins."""
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
    """The field of an answer that says which forces it follows from."""
    return result(
        "Forces that it follows from: the ideal ones, or the real ones, with clearance, deviations "
        "and elasticity, where these are given or, in the whole design, pins bend."
    )


class SatelliteBodyFields(RequestModel, group="satellite_body"):
    """The body of a satellite, as far as it is given."""

    outer_radius_mm: Maybe[Size] = quantity("Outer radius", "r_o", step=1)
    """Outer radius of the satellite, with its teeth."""
    root_radius_mm: Maybe[Size] = quantity("Root radius", "r_f", step=1)
    """Radius at the root of the satellite's teeth."""
    bore_radius_mm: Maybe[Size] = quantity("Bore radius", "r_b", step=1)
    """Radius of the satellite's bore."""
    solid_wall_mm: Maybe[Size] = quantity("Solid wall of the holes", "w_s", step=0.4)
    """Of a printed satellite, solid material behind the surface of its holes: perimeters times line
    width."""

    def section(self, _: Any) -> SatelliteBody:
        """The same in SI units."""
        return SatelliteBody(**self.to_core())


Celsius = Annotated[float, Field(ge=-60, le=250)]


class TemperaturesFields(RequestModel, group="temperatures"):
    """Temperatures of the parts at work, by which plastics are judged."""

    satellite_C: Maybe[Celsius] = quantity("Temperature of the satellites", "T_s", step=5)
    """Temperature of the satellites at work; a motor nearby heats them."""
    pins_C: Maybe[Celsius] = quantity("Temperature of the pins", "T_p", step=5)
    """Temperature of the pins at work."""

    def section(self, _: Any) -> Temperatures:
        """The same in SI units, but for degrees Celsius."""
        return Temperatures(**self.to_core())
