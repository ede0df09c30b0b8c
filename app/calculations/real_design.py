"""A mechanism, its load and its contact as the parts are made: what its calculations share."""

from functools import cached_property
from typing import Literal

from pydantic import Field

from app.calculations.mechanism import MechanismFields
from app.calculations.real_mechanism import (
    BentPinFields,
    ContactLawFields,
    RealContactFields,
    RealLoadFields,
)
from app.model import Maybe, RequestModel, quantity
from app.units import to_si
from core.output.mechanism import Mechanism
from core.output.real_mechanism import Deviations, RealMechanism

LEFT_OUT = (
    "bearing_elasticity",
    "bodies_rigid",
    "edge_pressure",
    "friction",
    "heat",
    "misalignment",
    "second_flange",
)
"""What the model leaves out."""


class RealDesignFields(RequestModel):
    """Mechanism, load, contact, law of contact and pins."""

    @property
    def long(self) -> bool:
        """Whether it takes long whatever its counts are."""
        return True

    mechanism: MechanismFields
    load: RealLoadFields
    contact: RealContactFields
    contact_law: ContactLawFields = Field(default_factory=ContactLawFields)
    pin: Maybe[BentPinFields] = None
    geometry: Literal["exact", "first_order"] = quantity(
        "Geometry",
        symbol="",
        group="contact_law",
        default="exact",
        help="Exact, or first order in lag and deviations as in the papers.",
    )
    lost_motion_torque_share: float = quantity(
        "Torque of the lost motion",
        symbol="",
        group="load",
        default=0.03,
        ge=1e-6,
        le=1,
        step=0.01,
        advanced=True,
        help="Share of the torque, in both directions, under which the lost motion is taken.",
    )

    @cached_property
    def built(self) -> Mechanism:
        """The mechanism, built once."""
        return self.mechanism.mechanism()

    @cached_property
    def torque(self) -> float:
        """Torque with the sign of its direction, N*m."""
        return self.load.signed_torque(self.load.torque(self.built))

    def made(self, deviations: Deviations) -> RealMechanism:
        """The mechanism as it is made, in SI units."""
        return RealMechanism(
            mechanism=self.built,
            pin_circle_radius=to_si("radius_mm", self.load.pin_circle_radius_mm),
            **self.contact.sizes(),
            law=self.contact_law.law(),
            pin=None if self.pin is None else self.pin.held(self.contact),
            deviations=deviations,
            exact=self.geometry == "exact",
        )
