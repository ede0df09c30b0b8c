"""A crank-planetary reducer as its checks look at it."""

import math
from dataclasses import dataclass
from functools import cached_property

from core.errors import ImpossibleMechanism
from core.hertz import HertzContact, hertz
from core.materials import ElasticMaterial
from core.output.contact_force import ContactForce, contact_force
from core.output.mechanism import Mechanism
from core.output.pin_geometry import FIT_TOLERANCE


@dataclass(frozen=True, kw_only=True)
class CrankDesign:
    """A crank-planetary reducer, as far as it is given; SI units.

    Attributes
    ----------
    pins, satellites : int
        Numbers of pins and satellites.
    ratio : float
        Ratio u.
    crank_spacing : float or None
        Angle between neighbouring cranks, rad; None for an even spacing.
    crank_angles : tuple of float or None
        Angle of each crank, rad, instead.
    initial_crank_angle : float
        Wave angle at crank angle 0, rad.
    satellite_teeth : int or None
        Teeth z2 of a satellite.
    output_torque, pin_circle_radius : float or None
        Torque, N*m, and radius R, m; None where there is no load.
    force_exponent : float
        Exponent v of the force over the approach.
    contact_length, pin_radius, hole_radius, eccentricity : float or None
        Sizes of pin and hole, m; None where they are not given.
    pin_material, hole_material : ElasticMaterial or None
        Their materials.
    dynamic_factor, distribution_factor : float
        Factors of the load.
    has_body : bool
        Whether the section of the satellite's body is there.
    outer_radius, root_radius, bore_radius : float or None
        Radii of the satellite, m.
    pitting_safety : float
        Required safety against pitting, of the pressure.
    min_wall : float or None
        Least wall that is asked, m.
    own_limits : tuple of str
        Which materials (`pin_material`, `hole_material`) are given by values.
    """

    pins: int
    satellites: int
    ratio: float
    crank_spacing: float | None = None
    crank_angles: tuple[float, ...] | None = None
    initial_crank_angle: float = 0.0
    satellite_teeth: int | None = None
    output_torque: float | None = None
    pin_circle_radius: float | None = None
    force_exponent: float = 1.0
    contact_length: float | None = None
    pin_radius: float | None = None
    hole_radius: float | None = None
    eccentricity: float | None = None
    pin_material: ElasticMaterial | None = None
    hole_material: ElasticMaterial | None = None
    dynamic_factor: float = 1.0
    distribution_factor: float = 1.0
    has_body: bool = False
    outer_radius: float | None = None
    root_radius: float | None = None
    bore_radius: float | None = None
    pitting_safety: float = 1.2
    min_wall: float | None = None
    own_limits: tuple[str, ...] = ()

    @cached_property
    def mechanism(self) -> Mechanism:
        """Pins and cranks."""
        if self.crank_angles is not None:
            return Mechanism(
                pins=self.pins,
                crank_angles=self.crank_angles,
                ratio=self.ratio,
                initial_crank_angle=self.initial_crank_angle,
            )
        return Mechanism.evenly_spaced(
            pins=self.pins,
            satellites=self.satellites,
            ratio=self.ratio,
            crank_spacing=self.crank_spacing,
            initial_crank_angle=self.initial_crank_angle,
        )

    @property
    def loaded(self) -> bool:
        """Whether a load is given."""
        return self.output_torque is not None

    @property
    def touching(self) -> bool:
        """Whether pins and holes are given."""
        return self.pin_radius is not None

    @cached_property
    def force(self) -> ContactForce | ImpossibleMechanism | None:
        """The contact force; why there is none at a dead centre; None without a load."""
        if self.output_torque is None or self.pin_circle_radius is None:
            return None
        try:
            return contact_force(
                mechanism=self.mechanism,
                output_torque=self.output_torque,
                pin_circle_radius=self.pin_circle_radius,
                force_exponent=self.force_exponent,
            )
        except ImpossibleMechanism as refusal:
            return refusal

    @cached_property
    def contact(self) -> HertzContact | None:
        """The contact under the peak force, where that is known."""
        return self.contact_at(1.0) if isinstance(self.force, ContactForce) else None

    def contact_at(self, factor: float) -> HertzContact:
        """The contact under so many times the torque."""
        assert isinstance(self.force, ContactForce)
        assert self.contact_length is not None and self.pin_radius is not None
        assert self.hole_radius is not None
        assert self.pin_material is not None and self.hole_material is not None
        return hertz(
            force=self.force.peak_force * factor,
            contact_length=self.contact_length,
            pin_radius=self.pin_radius,
            hole_radius=self.hole_radius,
            pin_material=self.pin_material,
            hole_material=self.hole_material,
            dynamic_factor=self.dynamic_factor,
            distribution_factor=self.distribution_factor,
        )

    @property
    def peak(self) -> dict[str, float]:
        """Where the contact force peaks."""
        if not isinstance(self.force, ContactForce):
            return {}
        pair = self.force.peak_pair
        return {
            "satellite": pair.satellite,
            "pin": pair.pin,
            "crank_angle": self.force.peak_crank_angle,
        }

    @property
    def clearance(self) -> float | None:
        """Hole radius less pin radius and eccentricity, m: interference below 0, and 0 within
        `FIT_TOLERANCE`; None where they are not all given.
        """
        if self.pin_radius is None or self.hole_radius is None or self.eccentricity is None:
            return None
        clearance = self.hole_radius - (self.pin_radius + self.eccentricity)
        return 0.0 if abs(clearance) <= FIT_TOLERANCE * self.hole_radius else clearance

    @property
    def pitch(self) -> float | None:
        """Distance of neighbouring pins, m; None where there is one only, or no circle."""
        if self.pin_circle_radius is None or self.pins < 2:
            return None
        return 2 * self.pin_circle_radius * math.sin(math.pi / self.pins)
