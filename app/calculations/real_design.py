"""Mechanism, load and contact as the parts are made: fields shared by calculations."""

from functools import cached_property
from typing import Self

from pydantic import Field, model_validator

from app.calculations.contact_law import ContactLawFields
from app.calculations.design import (
    GIVING,
    BentPinFields,
    GivingFields,
    RealContactFields,
    RealLoadFields,
)
from app.calculations.mechanism import MechanismFields
from app.calculations.pin_rollers import RollersFields
from app.model import Maybe, quantity
from app.settings import Settings
from app.units import to_si
from core.errors import InvalidInput
from core.output.elasticity import RIGID_PINS, PinSupport
from core.output.mechanism import Mechanism, Members
from core.output.real_mechanism import RealMechanism
from core.output.room import Deviations

TIMES_AS_LONG, TIED_AS_LONG = 4, 10
"""Factors on the time of a position with elastic satellites, and with pins joined by a tie ring."""

MOST_TIED = 100
"""Largest number of pairs with a tie ring, as all pins deflect under the force on each."""


LEFT_OUT = (
    "bodies_rigid",
    "edge_pressure",
    "friction",
    "heat",
    "misalignment",
    "shaft_bearings",
)
"""Effects that the model leaves out."""


class RealDesignFields(GivingFields, group="contact_law"):
    """Mechanism, load, contact, contact law, pins, and elasticity of the satellites."""

    mechanism: MechanismFields
    load: RealLoadFields
    contact: RealContactFields
    contact_law: ContactLawFields = Field(default_factory=ContactLawFields)
    pin: Maybe[BentPinFields] = None
    rollers: Maybe[RollersFields] = None
    lost_motion_torque_share: float = quantity(
        "Torque of the lost motion",
        group="load",
        default=0.03,
        step=0.01,
        advanced=True,
        ge=1e-6,
        le=1,
    )
    """Share of the torque, in both directions, under which the lost motion is measured."""

    @model_validator(mode="after")
    def _of_a_coupling(self) -> Self:
        if self.mechanism.output == "coupling":
            self.refuse_of_a_coupling(*GIVING)
        return self

    @property
    def times_as_long(self) -> int:
        """Time to solve a position over the time with rigid satellites."""
        if self.tied:
            return TIED_AS_LONG
        return TIMES_AS_LONG if self.support.gives else 1

    def refuse_beyond(self, settings: Settings) -> None:
        """Refuse more pairs than a tie ring may join."""
        super().refuse_beyond(settings)
        if self.tied and self.mechanism.pairs > MOST_TIED:
            most = self.mechanism.most_pins(MOST_TIED)
            raise InvalidInput("pins", self.mechanism.pins, "too_many_pairs", **most)

    @cached_property
    def built(self) -> Mechanism:
        """Mechanism, built once."""
        return self.mechanism.mechanism()

    @cached_property
    def members(self) -> Members:
        """Crank, pins and ring, one of which is the output."""
        return self.mechanism.members

    @cached_property
    def torque(self) -> float:
        """Torque on the pins with the sign of its direction, N*m."""
        return self.load.signed_torque(self.load.pin_torque(self.members))

    def made(self, deviations: Deviations) -> RealMechanism:
        """Mechanism as it is made, in SI units."""
        sizes, play = self.contact.sizes(), 0.0
        pin = RIGID_PINS if self.pin is None else self.pin.held(*self.around_pins)
        if self.rollers is not None:
            rollers = self.rollers.section(self)
            diameter = pin.diameter if isinstance(pin, PinSupport) else None
            rollers.check(pin_radius=sizes["pin_radius"], pin_diameter=diameter)
            play = rollers.play
            sizes["contact_length"] = min(sizes["contact_length"], rollers.length)
        return RealMechanism(
            mechanism=self.built,
            pin_circle_radius=to_si("radius_mm", self.load.pin_circle_radius_mm),
            **sizes,
            law=self.contact_law.section(self),
            pin=pin,
            deviations=deviations,
            support=self.support,
            roller_play=play,
        )
