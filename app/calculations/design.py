"""Sections of the design document that only the whole design takes, or takes with more fields."""

from app.calculations.contact_force import LoadFields, application_factor, peak_torque
from app.calculations.pin import PinMaterial, pin_length, pin_rotates, strengths_of
from app.calculations.pin_contact import PinContactFields
from app.calculations.real_mechanism import BentPinFields, torque_direction
from app.model import SIZE, Maybe, RequestModel, quantity
from app.units import to_si
from core.checks.sections import DesignPin
from core.output.sampled_turn import Direction


class DesignLoadFields(LoadFields):
    """Load with the direction of its torque, its speed, and how it changes."""

    torque_direction: Direction = torque_direction()
    input_speed_rpm: Maybe[float] = quantity(
        "Input speed",
        symbol="n₁",
        group="load",
        default=None,
        **SIZE,
        step=50,
        help="Speed of the crankshaft.",
    )
    application_factor: Maybe[float] = application_factor()
    peak_torque_Nm: Maybe[float] = peak_torque()


class DesignPinFields(BentPinFields):
    """A pin as it is held, bends and breaks."""

    contact_length_mm: Maybe[float] = pin_length(default=None)
    rotates: bool = pin_rotates()
    material: Maybe[PinMaterial] = quantity(
        "Material of the pin",
        symbol="",
        group="pin",
        default=None,
        help="A name of the table of materials, or values; that of the contact where it has one.",
    )

    def pin(self, contact: PinContactFields) -> DesignPin:
        """The pin in SI units; what is not given is that of the contact."""
        held = self.held(contact)
        return DesignPin(
            support=held.support,
            diameter=held.diameter,
            satellite_positions=held.satellite_positions,
            span=held.span,
            contact_length=to_si("contact_length_mm", self.contact_length_mm),
            rotates=self.rotates,
            **strengths_of(self.material or contact.pin_material),
        )


class SatelliteBodyFields(RequestModel):
    """The body of a satellite, as far as it is given."""

    outer_radius_mm: Maybe[float] = quantity(
        "Outer radius",
        symbol="r_o",
        group="satellite_body",
        default=None,
        **SIZE,
        step=1,
        help="Outer radius of the satellite.",
    )
    root_radius_mm: Maybe[float] = quantity(
        "Root radius",
        symbol="r_f",
        group="satellite_body",
        default=None,
        **SIZE,
        step=1,
        help="Radius at the root of the satellite's teeth.",
    )
    bore_radius_mm: Maybe[float] = quantity(
        "Bore radius",
        symbol="r_b",
        group="satellite_body",
        default=None,
        **SIZE,
        step=1,
        help="Radius of the satellite's bore.",
    )
