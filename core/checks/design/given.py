"""A crank-planetary reducer as it is given: its inputs, and what follows from them alone."""

import math
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Literal

from core.checks.sections import DesignPin, FatigueBasis, Friction, Ring, RollingBearing, Shaft
from core.errors import InvalidInput, NotKnown
from core.materials import ElasticMaterial
from core.output.contact_law import ContactLaw
from core.output.mechanism import Mechanism
from core.output.pin_beam import check_apart
from core.output.pin_geometry import felt
from core.output.real_mechanism import Deviations
from core.output.sampled_turn import Direction
from core.output.satellite_support import SatelliteSupport

Body = Literal["pin", "hole"]

DRAWN = 1e-3
"""Part of a distance that is lost where it is rounded on a drawing."""

SAME = 1e-12
"""Difference of diameters that is rounding, as a part of them."""

TYPED = 1e-9
"""Part of a torque that is lost where its limit is written down."""


@dataclass(frozen=True, kw_only=True)
class GivenDesign:
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
    torque_direction : {"driving", "reverse", "alternating"}
        Direction of the torque; of both the worse is judged.
    law : ContactLaw or None
        How a pair gives; None where that is not stated: by Hertz.
    pin : DesignPin or None
        How the pins are held, and of what they are.
    deviations : Deviations or None
        Of this piece, where they are stated.
    support : SatelliteSupport or None
        What the satellites give, where that is stated; the geometry is of first order then.
    max_backlash, max_lost_motion : float or None
        Largest backlash and lost motion that are asked, rad.
    input_speed : float or None
        Speed of the crank, rad/s.
    peak_torque : float or None
        Largest torque, for static strength, N*m, at least the torque times `dynamic_factor`; that
        where not given.
    fatigue : FatigueBasis or None
        What the fatigue of the pins is judged by.
    friction : Friction or None
        Friction and wear of the pins.
    gear : Ring or None
        The ring.
    bearing : RollingBearing or None
        Bearing of a satellite on its crank.
    crankshaft : Shaft or None
        The crankshaft.
    bending_safety, fatigue_safety : float
        Required safety of the pins against yield, and in fatigue.
    static_safety : float or None
        Required safety of bearings against their static rating; `STATIC_SAFETY` of their kind where
        not given.
    life : float
        Required life, s; infinite where none is asked.
    min_efficiency : float or None
        Least efficiency of the output mechanism that is asked.
    max_wear : float or None
        Largest depth of wear that is asked, m.
    max_pv : float or None
        Largest pressure times speed that is asked, Pa*m/s.
    max_sliding_speed : float or None
        Largest sliding speed that is asked, m/s.
    max_slope : float or None
        Largest slope of the pins that is asked, rad.
    max_deflection : float or None
        Largest deflection of the pins that is asked, m.
    max_outer_diameter : float or None
        Largest diameter of the reducer that is asked, m.
    max_unbalance, max_unbalance_couple : float or None
        Largest force, N, and couple, N*m, of the satellites' masses that are asked.

    Raises
    ------
    InvalidInput
        If the peak torque is below the working one, satellites reach into each other, their places
        on pins and crankshaft differ, a pin is thicker than what touches the hole, or pins of the
        ring overlap.
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
    torque_direction: Direction = "driving"
    law: ContactLaw | None = None
    pin: DesignPin | None = None
    deviations: Deviations | None = None
    support: SatelliteSupport | None = None
    max_backlash: float | None = None
    max_lost_motion: float | None = None
    input_speed: float | None = None
    peak_torque: float | None = None
    fatigue: FatigueBasis | None = None
    friction: Friction | None = None
    gear: Ring | None = None
    bearing: RollingBearing | None = None
    crankshaft: Shaft | None = None
    bending_safety: float = 1.5
    fatigue_safety: float = 1.5
    static_safety: float | None = None
    life: float = 5000 * 3600.0
    min_efficiency: float | None = None
    max_wear: float | None = None
    max_pv: float | None = None
    max_sliding_speed: float | None = None
    max_slope: float | None = None
    max_deflection: float | None = None
    max_outer_diameter: float | None = None
    max_unbalance: float | None = None
    max_unbalance_couple: float | None = None

    def __post_init__(self) -> None:
        self._check_peak()
        self._check_places()
        self._check_thickness()
        if self.gear is not None:
            self.gear.check_pins_apart(self.ratio)

    def _check_places(self) -> None:
        """Satellites do not reach into each other, and are as far apart on the pins as on the
        crankshaft, whose axis may point the other way.
        """
        pin, shaft = self.pin, self.crankshaft
        on_pins = () if pin is None else pin.satellite_positions
        on_shaft = () if shaft is None else shaft.satellite_positions
        width = self.contact_length if pin is None else pin.contact_length or self.contact_length
        if width is not None:
            for section, places in (("pin", on_pins), ("crankshaft", on_shaft)):
                name = f"{section}.satellite_positions"
                check_apart(name=name, positions=places, width=width)
        if not on_pins or len(on_pins) != len(on_shaft):
            return
        away = [place - on_shaft[0] for place in on_shaft]
        wanted = [place - on_pins[0] for place in on_pins]
        way = math.copysign(1.0, away[-1] * wanted[-1])
        for index, (here, there) in enumerate(zip(away, wanted, strict=True)):
            if abs(here - way * there) > DRAWN * abs(there):
                name = f"crankshaft.satellite_positions[{index}]"
                raise InvalidInput(name, on_shaft[index], "other_pitch", limit=abs(there))

    def _check_thickness(self) -> None:
        """No pin is thicker than what touches the hole."""
        pin, radius = self.pin, self.pin_radius
        if pin is not None and radius is not None and pin.diameter > 2 * radius * (1 + SAME):
            most = {"field": "pin_radius", "limit": 2 * radius}
            raise InvalidInput("pin.diameter", pin.diameter, "too_thick", **most)

    def _check_peak(self) -> None:
        if self.output_torque is None or self.peak_torque is None:
            return
        working = self.output_torque * self.dynamic_factor
        if self.peak_torque < working * (1 - TYPED):
            raise InvalidInput("peak_torque", self.peak_torque, "below_working", limit=working)

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
    def known_eccentricity(self) -> float:
        """The eccentricity, which has to be given, m."""
        if self.eccentricity is None:
            raise NotKnown("eccentricity_assumed", "eccentricity")
        return self.eccentricity

    @property
    def known_speed(self) -> float:
        """The speed of the crank, which has to be given, rad/s."""
        if self.input_speed is None:
            raise NotKnown("speed_missing", "input_speed")
        return self.input_speed

    def too_many(self, most: int) -> NotKnown:
        """What is not calculated of so many pairs.

        Parameters
        ----------
        most : int
            Most pairs of which it is.

        Returns
        -------
        NotKnown
        """
        limit = {"limit": most // self.satellites, "satellites": self.satellites}
        code = "too_many_pairs"
        return NotKnown(code, refusal=InvalidInput("pins", self.pins, code, **limit))

    @property
    def loaded(self) -> bool:
        """Whether a load is given."""
        return self.output_torque is not None

    @property
    def touching(self) -> bool:
        """Whether pins and holes are given."""
        return self.pin_radius is not None

    @cached_property
    def driven(self) -> Mechanism:
        """The ideal mechanism whose pairs drive where those of this one carry: in reverse they do
        where they would brake.
        """
        if self.torque_direction != "reverse":
            return self.mechanism
        start = self.mechanism.initial_crank_angle + math.pi
        return replace(self.mechanism, initial_crank_angle=start)

    def loads_over(self, life: float) -> float | None:
        """How often a place of pin or hole is loaded over a life, s, once a turn of the satellite
        against its crank; None without a speed, or without an end.
        """
        if self.input_speed is None or math.isinf(life):
            return None
        return self.input_speed * life / self.mechanism.crank_angle_per_wave

    @cached_property
    def lasting(self) -> dict[Body, ElasticMaterial | None]:
        """Materials of pin and hole, their limits wanted for the loads over the life."""
        loads = self.loads_over(self.life)
        materials: dict[Body, ElasticMaterial | None] = {
            "pin": self.pin_material,
            "hole": self.hole_material,
        }
        return {body: each and each.lasting(loads) for body, each in materials.items()}

    @cached_property
    def clearance(self) -> float | None:
        """Hole radius less pin radius and eccentricity, m: interference below 0, and 0 within
        `core.output.pin_geometry.FIT_TOLERANCE`; None where they are not all given.
        """
        if self.pin_radius is None or self.hole_radius is None or self.eccentricity is None:
            return None
        clearance = self.hole_radius - (self.pin_radius + self.eccentricity)
        return felt(clearance=clearance, hole_radius=self.hole_radius)

    @property
    def known_clearance(self) -> float:
        """The same, which needs the eccentricity, m."""
        if self.clearance is None:
            raise NotKnown("eccentricity_assumed", "eccentricity")
        return self.clearance

    @cached_property
    def roots(self) -> tuple[float, float]:
        """Least and largest radius of the roots of the satellite's teeth, m: the one that is given,
        or those that its ring leaves; within its outer radius. 0 and infinite where nothing is
        known.
        """
        low, high = 0.0, math.inf
        if self.root_radius is not None:
            low = high = self.root_radius
        elif self.gear is not None:
            low, high = self.gear.roots(ratio=self.ratio, eccentricity=self.eccentricity)
        outer = math.inf if self.outer_radius is None else self.outer_radius
        return min(low, outer), min(high, outer)

    @property
    def pitch(self) -> float | None:
        """Distance of neighbouring pins, m; None where there is one only, or no circle."""
        if self.pin_circle_radius is None or self.pins < 2:
            return None
        return 2 * self.pin_circle_radius * math.sin(math.pi / self.pins)

    @property
    def pairs(self) -> int:
        """Number of pairs of pin and hole."""
        return self.pins * self.satellites

    @property
    def pin_length(self) -> float:
        """Length of the contact along the pin, m."""
        given = None if self.pin is None else self.pin.contact_length
        length = self.contact_length if given is None else given
        assert length is not None
        return length

    @property
    def sleeved(self) -> bool:
        """Whether what touches the hole is not the pin, but a sleeve of it."""
        if self.pin is None or self.pin_radius is None:
            return False
        return not math.isclose(self.pin.diameter, 2 * self.pin_radius, rel_tol=SAME)

    @property
    def static_torque(self) -> float:
        """Torque of static strength, N*m."""
        assert self.output_torque is not None
        peak = self.peak_torque
        return self.output_torque * self.dynamic_factor if peak is None else peak

    @property
    def static_share(self) -> float:
        """That torque over the one with the factor."""
        assert self.output_torque is not None
        return self.static_torque / (self.output_torque * self.dynamic_factor)
