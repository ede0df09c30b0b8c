"""A crank-planetary reducer as its checks look at it."""

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, Literal, TypeVar

import numpy as np

from core.checks.real_forces import RealForces
from core.checks.sections import DesignPin, FatigueBasis, Friction, Ring, RollingBearing, Shaft
from core.crank.crankshaft import Crankshaft, crankshaft
from core.crank.ring_mesh import RingMesh
from core.crank.satellite_bearing import SatelliteBearings, satellite_bearings
from core.errors import ImpossibleMechanism, InvalidInput
from core.hertz import HertzContact, hertz
from core.materials import ElasticMaterial
from core.output.contact_force import ContactForce, contact_force
from core.output.contact_law import ContactLaw, HertzLaw, contact_compliance
from core.output.losses import PinLosses, pin_losses
from core.output.mechanism import Mechanism
from core.output.pin_beam import PinBeam, face_load_factor
from core.output.pin_fatigue import FatigueStrength
from core.output.pin_geometry import FIT_TOLERANCE
from core.output.pin_strength import PinStrength, PinStresses, pin_stresses
from core.output.real_mechanism import Deviations, RealMechanism
from core.output.real_turn import made
from core.output.sampled_turn import WAYS, Direction, Made, SampledTurn
from core.output.satellite_support import SatelliteSupport
from core.results import ROUNDING, Accuracy, Notice

MOST_REAL_PAIRS, MOST_GIVING_PAIRS = 100, 25
"""Most pairs of a mechanism whose real forces are solved: over the turn that takes seconds; of one
whose satellites give."""

MOST_PIN_PAIRS, MOST_BEARING_PAIRS = 500, 2000
"""Most pairs of which the locus of a pin's moment is looked at, and of which the forces on the
satellites are integrated over the turn."""

ALIKE = 64 * ROUNDING
"""Difference of stiffnesses that only rounding makes, as a part of them."""

UNSOLVED = {"dead_centre": "dead_centre", "beyond_hertz": "no_pressure"}
"""Why forces are not known, as the reason of a check, where there is one of its own."""

Forces = RealForces | ContactForce | ImpossibleMechanism | None
"""Forces, or why there are none; None where they are not asked, or of too many pairs."""

Body = Literal["pin", "hole"]

Result = TypeVar("Result")


@dataclass(frozen=True, kw_only=True)
class CrankDesign:
    """A crank-planetary reducer, as far as it is given; SI units.

    Where clearance, deviations or elasticity are stated, its forces are those of the mechanism as
    it is made; else those of the ideal one.

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
        Largest torque, for static strength, N*m; the torque times `dynamic_factor` where not given.
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
        Required life, s.
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
    def driven(self) -> Mechanism:
        """The ideal mechanism whose pairs drive where those of this one carry: in reverse they do
        where they would brake.
        """
        if self.torque_direction != "reverse":
            return self.mechanism
        start = self.mechanism.initial_crank_angle + math.pi
        return replace(self.mechanism, initial_crank_angle=start)

    @cached_property
    def force(self) -> ContactForce | ImpossibleMechanism | None:
        """The ideal contact force; why there is none at a dead centre; None without a load."""
        if self.output_torque is None or self.pin_circle_radius is None:
            return None
        try:
            return contact_force(
                mechanism=self.driven,
                output_torque=self.output_torque,
                pin_circle_radius=self.pin_circle_radius,
                force_exponent=self.force_exponent,
            )
        except ImpossibleMechanism as refusal:
            return refusal

    @cached_property
    def as_made(self) -> bool:
        """Whether clearance, deviations, a law of contact or satellites that give are stated.
        Bending pins alone leave the ideal forces.
        """
        stated = (self.law, self.deviations, self.support)
        return (self.clearance or 0.0) > 0 or any(each is not None for each in stated)

    @cached_property
    def real(self) -> RealMechanism | None:
        """The mechanism as it is made; None where too little of it is given, or the forces cannot
        be solved: of more than `most_real_pairs`, or of holes around the centre.
        """
        if not (self.loaded and self.touching) or self.pairs > self.most_real_pairs:
            return None
        assert self.pin_circle_radius is not None and self.contact_length is not None
        assert self.pin_radius is not None and self.hole_radius is not None
        eccentricity = self.eccentricity
        if eccentricity is None:
            eccentricity = self.hole_radius - self.pin_radius
        if eccentricity >= self.pin_circle_radius:
            return None
        return RealMechanism(
            mechanism=self.mechanism,
            pin_circle_radius=self.pin_circle_radius,
            pin_radius=self.pin_radius,
            eccentricity=eccentricity,
            contact_length=self.contact_length,
            law=self.law or HertzLaw(),
            clearance=self.clearance or 0.0,
            pin_material=self.lasting("pin"),
            hole_material=self.lasting("hole"),
            pin=self.pin,
            deviations=self.deviations or Deviations(),
            exact=self.support is None,
            support=self.support,
        )

    def real_forces_at(self, factor: float) -> RealForces:
        """Forces of the mechanism as it is made under so many times the torque.

        Parameters
        ----------
        factor : float
            Factor on the torque, > 0.

        Returns
        -------
        RealForces

        Raises
        ------
        ImpossibleMechanism
            See `core.output.real_mechanism.RealMechanism.solved`.
        """
        assert self.real is not None and self.output_torque is not None
        return RealForces.solved(
            real=self.real,
            torque=self.output_torque * factor,
            direction=self.torque_direction,
        )

    @cached_property
    def real_forces(self) -> RealForces | ImpossibleMechanism | None:
        """Those forces under the torque; why there are none; None where the mechanism is not known
        or has too many pairs.
        """
        if self.real is None:
            return None
        try:
            return self.real_forces_at(1.0)
        except ImpossibleMechanism as refusal:
            return refusal

    @cached_property
    def loading(self) -> RealForces | ImpossibleMechanism | None:
        """The same under the dynamic load: the forces that are judged."""
        if self.real is None or self.dynamic_factor == 1:
            return self.real_forces
        try:
            return self.real_forces_at(self.dynamic_factor)
        except ImpossibleMechanism as refusal:
            return refusal

    @cached_property
    def judged_forces(self) -> RealForces | ContactForce | None:
        """The forces that are judged, where they are known."""
        force = self.loading if self.as_made else self.force
        return None if isinstance(force, ImpossibleMechanism) else force

    def why_unknown(self, forces: Forces) -> str:
        """Why forces are not known, as the reason of a check.

        Parameters
        ----------
        forces : ImpossibleMechanism or None
            What there is instead of them.

        Returns
        -------
        str
        """
        if isinstance(forces, ImpossibleMechanism):
            return UNSOLVED.get(forces.code, "no_balance")
        many = self.pairs > self.most_real_pairs
        return "too_many_pairs" if many else "no_balance"

    @property
    def unsolved(self) -> str:
        """Why the forces that are judged are not known."""
        if self.judged_forces is not None:
            return "too_large"  # for what bends
        return self.why_unknown(self.loading if self.as_made else self.force)

    @cached_property
    def contact(self) -> HertzContact | None:
        """The contact with the largest pressure, where the forces are known: at the end of the
        length where the pin slopes.
        """
        if self.judged_forces is None:
            return None
        if self.pin is not None and not isinstance(self.pin_loads, PinStrength):
            return None
        return self.contact_at(self.edge_factor(1.0))

    def edge_factor(self, factor: float) -> float:
        """Largest line load of a contact over the mean one of the largest force: where pins bend,
        by the worse of equal and stiffness sharing, and by their slope.

        Parameters
        ----------
        factor : float
            Factor on the forces and the slopes.

        Returns
        -------
        float
        """
        return max(self._edges(factor), default=(1.0, 0))[0]

    def _edges(self, factor: float) -> list[tuple[float, int]]:
        """The same of each satellite, with its number."""
        loads, judged = self.pin_loads if self.pin else None, self.judged_forces
        if not isinstance(loads, PinStrength) or loads.deflection is None or judged is None:
            return []
        base = self.dynamic_factor * getattr(judged, "peak_force", 0.0)
        if isinstance(judged, RealForces):
            base = judged.force
        edges = []
        bent = zip(loads.deflection.forces, loads.deflection.slopes, strict=True)
        for satellite, (force, slope) in enumerate(bent, 1):
            if not force > 0:
                continue
            approach = factor * force * self._compliance(factor * force)
            even = face_load_factor(
                slope=factor * slope, contact_length=self.contact_length or 0.0, approach=approach
            )
            edges.append((float(even) * force / base, satellite))
        return edges

    def _compliance(self, force: float) -> float:
        """Approach of a contact over its force, m/N."""
        assert self.contact_length is not None and self.pin_radius is not None
        assert self.hole_radius is not None
        if not self.hole_radius > self.pin_radius:
            raise InvalidInput("hole_radius", self.hole_radius, "larger_than", field="pin_radius")
        return contact_compliance(
            law=self.law or HertzLaw(),
            force=force,
            contact_length=self.contact_length,
            pin_radius=self.pin_radius,
            hole_radius=self.hole_radius,
            pin=self.pin_material,
            hole=self.hole_material,
        )

    def contact_at(self, factor: float) -> HertzContact:
        """The contact under so many times its force."""
        force = self.judged_forces
        if isinstance(force, RealForces):
            return force.contact_at(factor)
        assert force is not None
        assert self.contact_length is not None and self.pin_radius is not None
        assert self.hole_radius is not None
        pin, hole = self.lasting("pin"), self.lasting("hole")
        assert pin is not None and hole is not None
        return hertz(
            force=force.peak_force * factor,
            contact_length=self.contact_length,
            pin_radius=self.pin_radius,
            hole_radius=self.hole_radius,
            pin_material=pin,
            hole_material=hole,
            dynamic_factor=self.dynamic_factor,
            distribution_factor=self.distribution_factor,
        )

    def torque_factor(self, factor: float) -> float:
        """Factor on the torque under which the largest line load is so many times as large."""
        force, on_force, edge = self.judged_forces, factor, self.edge_factor(1.0)
        before = gone = 0.0  # secants of the logarithm of both
        while self.pin and 0 < on_force < math.inf:
            left = math.log(factor * edge / self.edge_factor(on_force) / on_force)
            if abs(left) <= 1e-9:
                break
            step = left if left == before or not before else gone * left / (before - left)
            before, gone = left, step
            on_force *= math.exp(step)
        return force.torque_factor(on_force) if isinstance(force, RealForces) else on_force

    @cached_property
    def peak(self) -> dict[str, float]:
        """Where the largest pressure is reached."""
        force = self.judged_forces
        if edges := self._edges(1.0):
            satellite = max(edges)[1]
            known = isinstance(force, RealForces) and force.place["satellite"] == satellite
            return force.place if known else {"satellite": satellite}  # type: ignore[union-attr]
        if isinstance(force, RealForces):
            return force.place
        if force is None:
            return {}
        return {
            "satellite": force.peak_pair.satellite,
            "pin": force.peak_pair.pin,
            "crank_angle": force.peak_crank_angle,
        }

    @property
    def loads_over_life(self) -> float | None:
        """How often a place of pin or hole is loaded over the required life, once a turn of the
        satellite against its crank; None without a speed.
        """
        if self.input_speed is None:
            return None
        return self.input_speed * self.life / self.mechanism.crank_angle_per_wave

    def lasting(self, body: Body) -> ElasticMaterial | None:
        """Material of pin or hole, its limit wanted for the loads over the life."""
        material = self.pin_material if body == "pin" else self.hole_material
        return None if material is None else material.lasting(self.loads_over_life)

    @cached_property
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

    @property
    def _forced(self) -> dict[str, Any]:
        """What the forces follow from, as arguments."""
        return {
            "mechanism": self.mechanism,
            "force_exponent": self.force_exponent,
            "output_torque": self.output_torque,
            "pin_circle_radius": self.pin_circle_radius,
            "torque_direction": self.torque_direction,
            "pair_stiffness": self.pair_stiffness,
            "made": self.made,
        }

    @property
    def _turning(self) -> dict[str, Any]:
        """The same, with what turns."""
        moving = {"eccentricity": self.eccentricity, "input_speed": self.input_speed}
        return self._forced | moving

    @cached_property
    def made(self) -> Made | None:
        """The forces of the mechanism as it is made under any torque, where they are judged."""
        return made(self.real) if self.as_made and self.real is not None else None

    @property
    def unmade(self) -> bool:
        """Whether the forces of the mechanism as it is made are wanted and cannot be solved."""
        return self.as_made and self.real is None

    @cached_property
    def pair_stiffness(self) -> tuple[float, ...] | None:
        """Stiffness of the pairs of each satellite, by which bending pins share an ideal load; None
        where all are alike.
        """
        pin, force = self.pin, self.force
        if pin is None or self.as_made or not isinstance(force, ContactForce):
            return None
        length = self.pin_length
        far = math.inf if pin.support == "cantilever" else (pin.span or 0.0)
        held = all(length / 2 <= z <= far - length / 2 for z in pin.satellite_positions)
        if not held or len(pin.satellite_positions) != self.satellites or self.satellites == 1:
            return None
        beam = PinBeam.round(
            support=pin.support,
            diameter=pin.diameter,
            contact_length=length,
            youngs_modulus=pin.material.youngs_modulus,
            poissons_ratio=pin.material.poissons_ratio,
            span=pin.span,
        )
        found = beam.pair_stiffness(
            positions=pin.satellite_positions,
            contact_compliance=self._compliance(force.peak_force * self.dynamic_factor),
        )
        return None if max(found) - min(found) <= ALIKE * max(found) else found

    @property
    def pin_length(self) -> float:
        """Length of the contact along the pin, m."""
        assert self.contact_length is not None
        given = None if self.pin is None else self.pin.contact_length
        return self.contact_length if given is None else given

    @property
    def most_real_pairs(self) -> int:
        """Most pairs of which the forces of the mechanism as it is made are solved."""
        return MOST_REAL_PAIRS if self.support is None else MOST_GIVING_PAIRS

    @property
    def pairs(self) -> int:
        """Number of pairs of pin and hole."""
        return self.pins * self.satellites

    @property
    def sleeved(self) -> bool:
        """Whether what touches the hole is not the pin, but a sleeve of it."""
        if self.pin is None or self.pin_radius is None:
            return False
        return not math.isclose(self.pin.diameter, 2 * self.pin_radius, rel_tol=1e-12)

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

    def unturned(self, found: object, *, speed: bool = True) -> tuple[str, tuple[str, ...]]:
        """Why what turns is not known, as the reason of a check, and which inputs are missing;
        `speed` whether it needs one.
        """
        if isinstance(found, ImpossibleMechanism):
            return self.why_unknown(found), ()
        if self.eccentricity is None:
            return "eccentricity_missing", ("eccentricity",)
        if speed and self.input_speed is None:
            return "speed_missing", ("input_speed",)
        return (self.why_unknown(None) if self.unmade else "too_large"), ()

    @cached_property
    def fatigue_strength(self) -> FatigueStrength | Notice | None:
        """What the fatigue of the pins is judged by; why it is not known; None without it."""
        if self.fatigue is None or self.pin is None:
            return None
        pin, basis = self.pin, self.fatigue
        if basis.criterion == "soderberg" and pin.material.yield_strength is None:
            return Notice("fatigue_no_basis")
        found = _named("fatigue", lambda: basis.strength(pin))
        if isinstance(found, Notice) or not pin.steel or pin.rotates:  # then no cycles are counted
            return found
        return replace(found, cycles=self.loads_over_life)

    @cached_property
    def _pin_stresses(self) -> PinStresses | ImpossibleMechanism | None:
        """Stresses of the pins under the dynamic load; why they are not known; None without pins,
        or of too many.
        """
        if not (self.loaded and self.touching and self.pin) or self.unmade:
            return None
        if self.pairs > MOST_PIN_PAIRS:
            return None
        pin = self.pin
        return _known(
            "pin",
            lambda: pin_stresses(
                **self._forced,
                application_factor=self.dynamic_factor,
                peak_torque=self.static_torque,
                diameter=pin.diameter,
                contact_length=self.pin_length,
                satellite_positions=pin.satellite_positions,
                material=pin.material,
                support=pin.support,
                span=pin.span,
            ),
        )

    @cached_property
    def pin_loads(self) -> PinStrength | ImpossibleMechanism | None:
        """Strength of the pins without their fatigue, with their deflection."""
        found = self._pin_stresses
        return found.strength(deflection=True) if isinstance(found, PinStresses) else found

    @cached_property
    def pin_strength(self) -> PinStrength | ImpossibleMechanism | None:
        """Strength of the pins under the dynamic load, its static safety under the peak torque; why
        it is not known; None without pins, or of too many.
        """
        judged, pin, found = self.fatigue_strength, self.pin, self.pin_loads
        if pin is None or not isinstance(found, PinStrength):
            return found
        if isinstance(judged, FatigueStrength):
            assert isinstance(self._pin_stresses, PinStresses)
            found = self._pin_stresses.strength(
                rotates=pin.rotates, fatigue=judged, input_speed=self.input_speed, deflection=True
            )
        notices: tuple[Notice, ...] = (judged,) if isinstance(judged, Notice) else ()
        valid = pin.valid_diameter
        if valid is not None and pin.diameter > valid:
            notices += (Notice("strength_beyond_size", {"limit": valid * 1e3}),)
        return replace(found, notices=notices + found.notices)

    @cached_property
    def losses(self) -> PinLosses | ImpossibleMechanism | None:
        """Friction and wear of the pins under the torque; why they are not known; None where
        friction, speed or eccentricity is not given.
        """
        friction = self.friction
        if friction is None or not (self.loaded and self.input_speed and self.eccentricity):
            return None
        if self.unmade:
            return None
        inside = self.pin.diameter if friction.sleeve and self.pin else None
        life = self.life if friction.life is None else friction.life
        return _known("pin", lambda: self._losses(friction, inside, life))

    def _losses(self, friction: Friction, inside: float | None, life: float) -> PinLosses:
        """Losses of the ideal forces, or of those of the mechanism as it is made."""
        assert self.output_torque is not None and self.pin_circle_radius is not None
        found = pin_losses(
            mechanism=self.driven,
            force_exponent=self.force_exponent,
            output_torque=self.output_torque,
            pin_circle_radius=self.pin_circle_radius,
            input_speed=self.input_speed,
            eccentricity=self.eccentricity,
            pin_radius=self.pin_radius,
            hole_radius=self.hole_radius,
            contact_length=self.contact_length,
            friction_coefficient=friction.coefficient,
            diameter=inside,
            wear_rate=friction.wear_rate,
            life=None if friction.wear_rate is None else life,
        )
        if self.made is None:
            return found
        turns = [self.made(way * self.output_torque) for way in WAYS[self.torque_direction]]
        reference = self.output_torque / self.pin_circle_radius
        return max(
            (made_losses(losses=found, turn=turn, reference=reference) for turn in turns),
            key=lambda each: each.mean_loss,
        )

    @cached_property
    def mesh(self) -> RingMesh | None:
        """The ring's force on a satellite; None without a ring or an eccentricity."""
        gear, eccentricity = self.gear, self.eccentricity
        if gear is None or eccentricity is None:
            return None
        ratio = self.mechanism.ratio
        return _named("gear", lambda: gear.mesh(eccentricity=eccentricity, ratio=ratio))

    @cached_property
    def bearings(self) -> SatelliteBearings | ImpossibleMechanism | None:
        """Load and life of the satellites' bearings under the torque, their static safety under the
        peak torque; why they are not known; None where ring, bearing or eccentricity is not given,
        or of too many pairs. Without a speed there is no life.
        """
        bearing, mesh = self.bearing, self.mesh
        if bearing is None or mesh is None or not self.loaded:
            return None
        if self.pairs > MOST_BEARING_PAIRS or self.unmade:
            return None
        return _known(
            "bearing",
            lambda: satellite_bearings(
                **self._turning,
                mesh=mesh,
                kind=bearing.kind,
                dynamic_rating=bearing.dynamic_rating,
                static_rating=bearing.static_rating,
                reliability_percent=bearing.reliability_percent,
                ring_factor=bearing.ring_factor,
                weibull_slope=bearing.weibull_slope,
                peak_torque=self.static_torque,
            ),
        )

    @cached_property
    def shaft(self) -> Crankshaft | ImpossibleMechanism | None:
        """Reactions and balance of the crankshaft under the torque; why they are not known; None
        where shaft, ring, speed or eccentricity is not given, or of too many pairs.
        """
        own, mesh = self.crankshaft, self.mesh
        if own is None or mesh is None or not (self.loaded and self.input_speed):
            return None
        if self.pairs > MOST_BEARING_PAIRS or self.unmade:
            return None
        given = self._turning
        if own.bearings is not None:
            given |= {
                "kinds": tuple(each.kind for each in own.bearings),
                "dynamic_ratings": tuple(each.dynamic_rating for each in own.bearings),
            }
        return _known(
            "crankshaft",
            lambda: crankshaft(
                **given,
                mesh=mesh,
                satellite_positions=own.satellite_positions,
                bearing_positions=own.bearing_positions,
                satellite_mass=own.satellite_mass,
            ),
        )


def made_losses(*, losses: PinLosses, turn: SampledTurn, reference: float) -> PinLosses:
    """Losses of a mechanism as it is made: all forces of a satellite act along its crank but for
    its deviations, so that together they are what they do to it.

    Parameters
    ----------
    losses : PinLosses
        Those of the ideal forces.
    turn : SampledTurn
        Forces under the torque.
    reference : float
        ``F0 = T/R``, N.

    Returns
    -------
    PinLosses
    """
    total = np.abs(turn.on_satellites).sum(axis=0) / reference
    mean, least, largest = float(turn.mean(total)), float(total.min()), float(total.max())
    peak = float(np.abs(turn.on_pins).max()) / float(losses.peak_force)
    part = mean / float(losses.mean_total_force_ratio)
    share = (1 / float(losses.efficiency) - 1) / float(losses.mean_total_force_ratio)
    pin, hole = (
        None if each is None else each * peak for each in (losses.pin_wear, losses.hole_wear)
    )
    error = turn.error + losses.accuracy.relative_error
    return replace(
        losses,
        mean_total_force_ratio=mean,
        mean_loss=losses.mean_loss * part,
        efficiency=1 / (1 + share * mean),
        min_efficiency=1 / (1 + share * largest),
        max_efficiency=1 / (1 + share * least),
        peak_force=losses.peak_force * peak,
        peak_pv=losses.peak_pv * peak,
        mean_pv=losses.mean_pv * part,
        friction_couple=losses.friction_couple * part,
        pin_wear=pin,
        hole_wear=hole,
        accuracy=Accuracy("sampling", error, turn.evaluations),
    )


SECTION_OF = {
    "pin": ("satellite_positions", "span", "diameter"),
    "fatigue": ("reliability_percent",),
    "gear": ("module", "teeth_difference", "ring_pin_circle_radius"),
    "bearing": ("reliability_percent", "ring_factor", "weibull_slope"),
    "crankshaft": ("satellite_positions", "bearing_positions", "satellite_mass"),
}
"""Parameters of calculations that are fields of a section, where others may be called the same."""


def _named(section: str, calculation: Callable[[], Result]) -> Result:
    """A result; a refusal names the section of the field."""
    try:
        return calculation()
    except InvalidInput as error:
        if error.parameter.startswith(SECTION_OF[section]):
            name = f"{section}.{error.parameter}"
            raise InvalidInput(name, error.value, error.code, **error.params) from error
        raise


def _known(section: str, calculation: Callable[[], Result]) -> Result | ImpossibleMechanism:
    """A result, or why there is none."""
    try:
        return _named(section, calculation)
    except ImpossibleMechanism as refusal:
        return refusal
