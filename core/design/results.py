"""What follows from a design: each result worked out when it is asked for, once, or why it is not
known.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache, cached_property
from typing import Any, TypeVar

import numpy as np

from core.arrays import Number
from core.conformal import first_yield_factor
from core.crank.balance import Balance, balance
from core.crank.crankshaft import Crankshaft, crankshaft
from core.crank.pin_rollers import PinRollers, pin_rollers
from core.crank.ring_mesh import RingMesh
from core.crank.satellite_bearing import SatelliteBearings, satellite_bearings
from core.derived import derived, if_known
from core.design.contact import OVALS, disc_error, shakedown
from core.design.document import Design, changed, value_at
from core.design.losses import made_losses
from core.design.real_forces import RealForces
from core.design.refusals import named
from core.design.sections import DesignPin
from core.errors import InvalidInput, NotKnown
from core.first_yield import first_yield
from core.hertz import HertzContact, force_factor, hertz
from core.materials import Body
from core.output.contact_force import ContactForce, contact_force
from core.output.contact_law import RIGID_PINS, ContactLaw, contact_compliance, usual_law
from core.output.edge_load import EdgeLoad, SlopingContacts
from core.output.fit import Fit
from core.output.loaded_position import loaded_position
from core.output.losses import PinLosses, pin_losses
from core.output.members import MemberLoads
from core.output.over_turn import OverTurn
from core.output.pin_bolt import Grip, grip
from core.output.pin_fatigue import FatigueStrength
from core.output.pin_strength import PinStrength, PinStresses, pin_stresses
from core.output.real_mechanism import Deviations, RealMechanism
from core.output.real_turn import sampled
from core.output.sampled_turn import WAYS, Made, SampledTurn
from core.output.satellite_support import RIGID_SUPPORT, Shares
from core.output.turn import Turn
from core.results import Notice
from core.ring.bent_pins import forces_on_ring
from core.ring.involute import MOST_DIFFERENCE, STANDARD_ANGLES, InvolutePair, involute_pair
from core.ring.involute_load import InvoluteLoad, RootStress, involute_load, involute_loss
from core.ring.involute_load import root_stress as tooth_root
from core.ring.loss import RingFriction, RingLoss, ring_loss
from core.ring.series import MeshesInSeries, series_position
from core.ring.series_samples import sampled_in_series
from core.ring.series_teeth import TeethInSeries
from core.ring.series_turn import SeriesOverTurn, SeriesTurn, positions_in_series
from core.ring.sharing import CycloidMesh, MeshTurn, mesh_over_turn

Calculated = TypeVar("Calculated")

MOST_REAL_PAIRS, MOST_GIVING_PAIRS = 100, 25
"""Most pairs of a mechanism whose real forces are solved: over the turn that takes seconds; of one
whose satellites give."""

MOST_PIN_PAIRS = 500
"""Most pairs of which the locus of a pin's moment is looked at."""

MOST_RING_PAIRS = 300
"""Most pairs of discs and pins of a ring over the turn."""

MOST_IN_SERIES = 250_000
"""Most forces of both meshes in series over their turns."""

MOST_BEARING_PAIRS = 2000
"""Most pairs of which the forces on the satellites are integrated over the turn."""

SOFTENED = (
    "contact.pin_material",
    "contact.hole_material",
    "pin.material",
    "gear.pin_material",
    "gear.disc_material",
)
"""Materials by whose moduli parts give."""


@dataclass(frozen=True, slots=True)
class RollersOnPins:
    """Rollers on the pins, and what they do besides carrying."""

    loads: PinRollers  # of the one that is loaded most
    loss: float | None  # of all, mean over the turn, W
    added_clearance: float  # to that of pins and holes, m
    tilt: float | None  # largest slope of a pin in them, rad


class Results:
    """What follows from a design; SI units. What is not known raises `NotKnown`, and what cannot be
    `ImpossibleMechanism`, each time that it is asked for.

    Parameters
    ----------
    design : Design
        The design.
    equal : bool
        Whether satellites share the load equally, as in the papers, where nothing but the bending
        of their pins makes them share otherwise.
    """

    def __init__(self, design: Design, *, equal: bool = False) -> None:
        self.design = design
        self.shared_equally = equal
        self.solved = design.as_made or (design.bends and not equal)
        """Whether the forces that are judged are solved over the turn: those of the mechanism as it
        is made, or of perfect parts whose pins bend; else they are the ideal ones."""

    @cached_property
    def in_series(self) -> bool:
        """Whether both meshes are solved in series: where the ring's can be, of at most
        `MOST_IN_SERIES` forces over the turns.
        """
        return 0 < self.forces_in_series <= MOST_IN_SERIES

    @cached_property
    def forces_in_series(self) -> int:
        """Number of forces over the turns of both meshes in series; 0 where they are not."""
        if not self.design.in_series or (ring := if_known(lambda: self.ring_mesh)) is None:
            return 0
        pairs = self.design.mechanism.pairs + ring.disc.pins * self.design.mechanism.satellites
        pitches = None if not ring.pins_alike else ring.disc.satellite_teeth
        lobes = ring.disc.satellite_teeth
        return positions_in_series(lobes=lobes, pitches=pitches) * pairs

    @derived
    def series(self) -> MeshesInSeries:
        """Both meshes in series."""
        return MeshesInSeries(self.ring_mesh, self.real)

    @property
    def uneven_growth(self) -> bool:
        """Whether loads of bearings do not grow with the torque: of forces that are solved, and
        with centrifugal ones beside them.
        """
        return self.solved or self.centrifugal > 0

    @cached_property
    def equal(self) -> "Results":
        """The same where satellites share the load equally, of one mesh with the ring."""
        found = Results(self.design, equal=True)
        found.ring_turn = self.ring_turn
        return found

    @cached_property
    def softest(self) -> "Results":
        """The same with the least moduli of the materials, where sources differ: by which
        deflections are judged.
        """
        held = {name: value_at(self.design, name) for name in SOFTENED}
        softer = {
            name: each.softest
            for name, each in held.items()
            if each is not None and each.least_modulus is not None
        }
        return Results(changed(self.design, softer), equal=self.shared_equally) if softer else self

    @derived
    def member_loads(self) -> MemberLoads:
        """Torques, speeds and powers of crank, pins and ring, without losses."""
        design = self.design
        torque = design.load.output_torque
        return design.members.loads(output_torque=torque, speeds=design.speeds)

    @derived
    def contact_force(self) -> ContactForce:
        """The ideal contact force."""
        load = self.design.load
        return contact_force(
            output_torque=self.design.pin_torque,
            pin_circle_radius=load.pin_circle_radius,
            force_exponent=load.force_exponent,
            mechanism=self.design.driven,
        )

    @derived
    def real(self) -> RealMechanism:
        """The mechanism as it is made, of at most `MOST_REAL_PAIRS`, or `MOST_GIVING_PAIRS`."""
        design = self.design
        radius, pair = design.load.pin_circle_radius, design.pair
        most = MOST_GIVING_PAIRS if design.support.first_order else MOST_REAL_PAIRS
        if design.mechanism.pairs > most:
            raise design.too_many(most)
        eccentricity = design.contact.eccentricity
        if eccentricity is None:
            eccentricity = pair.hole_radius - pair.pin_radius
        if eccentricity >= radius:  # holes around the centre
            than = {"field": "pin_circle_radius", "limit": radius}
            refusal = InvalidInput("contact.eccentricity", None, "smaller_than", **than)
            raise NotKnown(refusal.code, refusal=refusal)
        bends = design.pin and design.pin.satellite_positions
        pin = self.bent_pin if bends else RIGID_PINS
        return RealMechanism(
            mechanism=design.mechanism.built,
            pin_circle_radius=radius,
            pin_radius=pair.pin_radius,
            eccentricity=eccentricity,
            contact_length=pair.contact_length,
            law=self.law,
            clearance=design.contact.clearance or 0.0,
            pin_material=design.lasting["pin"],
            hole_material=design.lasting["hole"],
            pin=pin,
            deviations=design.output_deviations or Deviations(),
            exact=not design.support.first_order
            and not (bends and design.tied)
            and not self._by_flanks,
            support=design.support,
            roller_play=design.roller_play,
        )

    @property
    def _by_flanks(self) -> bool:
        """Whether flanks of discs in series are turned, which is known in first order only."""
        change = self.design.gear.modification if self.in_series else None
        return change is not None and change.rotation > 0

    @cached_property
    def law(self) -> ContactLaw:
        """The law of contact of pins in holes: as given, or by their materials."""
        bodies = self.design.lasting
        return self.design.contact_law or usual_law(pin=bodies["pin"], hole=bodies["hole"])

    @derived
    def grip(self) -> Grip:
        """The bolt and its spacer under the largest loads of the root, dynamic and at the peak
        torque, as the spacer carries them.
        """
        pin = self.design.pin
        if not pin or pin.bolt is None:
            raise NotKnown("section_missing", "pin")
        spacer = Results(
            changed(self.design, {"pin.bolt": None}), equal=self.shared_equally
        ).pin_loads
        peak = max(1.0, spacer.static_stress / spacer.peak_equivalent_stress)
        return grip(
            bolt=pin.bolt,
            diameter=pin.diameter,
            bore=pin.bore_diameter,
            moment=peak * spacer.peak_moment,
            shear_force=peak * spacer.peak_shear_force,
        )

    @derived
    def bent_pin(self) -> DesignPin:
        """The pin that bends: of a bolt through a spacer the spacer while it is held, else the bolt
        alone.
        """
        pin = self.design.pin
        if not pin or pin.bolt is None:
            return pin
        held = pin.bolt.preload is not None and self.grip.holds
        return replace(pin, bolt=None) if held else pin.bolt_alone(pin.bolt)

    @derived
    def fit(self) -> Fit:
        """How pins and holes fit."""
        return Fit(self.real)

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
        if self.fit.impossible:
            raise self.fit.refusal()
        load = self.design.load
        return RealForces.solved(
            turn=self.over_turn,
            torque=self.design.pin_torque * factor,
            direction=load.torque_direction,
        )

    @derived
    def real_forces(self) -> RealForces:
        """Those forces under the torque."""
        return self.real_forces_at(1.0)

    @derived
    def loading(self) -> RealForces:
        """The same under the dynamic load: the forces that are judged."""
        factor = self.design.load_factor
        return self.real_forces if factor == 1 else self.real_forces_at(factor)

    @derived
    def judged_forces(self) -> RealForces | ContactForce:
        """The forces that are judged."""
        return self.loading if self.solved else self.contact_force

    @cached_property
    def turn(self) -> Callable[[float], Turn]:
        """The mechanism as it is made over the turn, of a torque, N*m, negative in reverse."""
        if self.in_series:
            return cache(lambda torque: SeriesTurn(self.series, torque))
        return cache(lambda torque: Turn(self.real, torque))

    @cached_property
    def over_turn(self) -> Callable[[float], OverTurn]:
        """Extremes of the same."""
        return cache(lambda torque: self._over(self.turn(torque)))

    def _over(self, turn: Turn) -> OverTurn:
        return SeriesOverTurn(turn) if isinstance(turn, SeriesTurn) else OverTurn(turn)

    def forces_at(self, crank_angle: float) -> tuple[tuple[float, ...], ...]:
        """Forces on the pins that are solved, N, K x N, at a crank angle, rad, under the torque in
        the direction of the larger pressure.
        """
        solved = self.real_forces
        given = {"crank_angle": crank_angle, "output_torque": solved.way * solved.torque}
        if self.in_series:
            return series_position(real=self.series, **given).force
        return loaded_position(real=solved.real, **given).force

    @derived
    def made(self) -> Made | None:
        """The forces on pins and satellites that are solved over the turn, of a torque likewise;
        None where the ideal ones are judged.
        """
        if not self.solved:
            return None
        if self.in_series:
            return cache(lambda torque: sampled_in_series(self.turn(torque)))  # type: ignore[arg-type]
        return cache(lambda torque: sampled(self.turn(torque)))

    @cached_property
    def compliance(self) -> Callable[[Number], Number]:
        """Approach of a contact over its force, m/N, of forces, N."""
        bodies = self.design.lasting
        length, pin_radius, hole_radius = self.design.pair
        if not hole_radius > pin_radius:
            than = {"field": "pin_radius", "limit": pin_radius}
            raise InvalidInput("contact.hole_radius", hole_radius, "larger_than", **than)
        return contact_compliance(
            law=self.law,
            contact_length=length,
            pin_radius=pin_radius,
            hole_radius=hole_radius,
            pin=bodies["pin"],
            hole=bodies["hole"],
        )

    @property
    def _forced(self) -> dict[str, Any]:
        """What the forces follow from, as arguments."""
        load = self.design.load
        return {
            "mechanism": self.design.mechanism.built,
            "force_exponent": load.force_exponent,
            "output_torque": self.design.pin_torque,
            "pin_circle_radius": load.pin_circle_radius,
            "torque_direction": load.torque_direction,
            "made": self.made,
        }

    @property
    def _turning(self) -> dict[str, Any]:
        """The same, with what turns."""
        moving = {
            "eccentricity": self.design.contact.eccentricity,
            "input_speed": self.design.speeds and self.design.speeds.turning,
        }
        return self._forced | moving

    def _limit_pairs(self, most: int) -> None:
        """Refuse more pairs than ideal forces are integrated of."""
        if self.made is None and self.design.mechanism.pairs > most:
            raise self.design.too_many(most)

    @derived
    def fatigue_strength(self) -> FatigueStrength:
        """What the fatigue of the pins is judged by."""
        return self._fatigue_of(self.bent_pin, self.design.loads_over)

    def _fatigue_of(
        self, pin: DesignPin, loads: Callable[[float], float | None]
    ) -> FatigueStrength:
        """The same of a pin that is loaded so often over a life, s."""
        design, basis = self.design, self.design.fatigue
        if basis.criterion == "soderberg" and pin.material.yield_strength is None:
            raise NotKnown("yield_unknown", f"{pin.material_path}.yield_strength")
        found = named(design, "fatigue", lambda: basis.strength(pin))
        if not pin.steel or pin.rotates:  # then no cycles are counted
            return found
        life = design.requirements.life if basis.life is None else basis.life
        return replace(found, cycles=loads(life))

    @property
    def loaded_pins(self) -> dict[str, Any]:
        """The pins and what loads them, as arguments of `pin_stresses`."""
        pin = self.bent_pin
        return self._forced | {
            "application_factor": self.design.load_factor * self.design.distribution_factor,
            "peak_torque": self.design.static_torque * self.design.distribution_factor,
            "diameter": pin.diameter,
            "bore_diameter": pin.bore_diameter,
            "contact_length": self.design.pin_length,
            "satellite_positions": pin.satellite_positions,
            "material": pin.material,
            "support": pin.support,
            "span": pin.span,
            "ring_joint": pin.ring_joint,
        }

    @derived
    def pin_stresses(self) -> PinStresses:
        """Stresses of the pins under the dynamic load, of at most `MOST_PIN_PAIRS`, or where a tie
        ring joins them `MOST_REAL_PAIRS`.
        """
        if not self.design.pin:
            raise NotKnown("section_missing", "pin")
        self._limit_pairs(MOST_REAL_PAIRS if self.design.tied else MOST_PIN_PAIRS)
        return named(self.design, "pin", lambda: pin_stresses(**self.loaded_pins))

    @derived
    def pin_loads(self) -> PinStrength:
        """Strength of the pins without their fatigue, with their deflection."""
        return self.pin_stresses.strength(deflection=True)

    @derived
    def pin_strength(self) -> PinStrength:
        """Strength of the pins under the dynamic load, its static safety under the peak torque."""
        return self.judged_pins()

    def judged_pins(self, *, locus: bool = False) -> PinStrength:
        """The same, at will with the locus of the moment."""
        found, notices = self.pin_loads, tuple[Notice, ...]()
        fatigue: FatigueStrength | None = None
        try:
            fatigue = self.fatigue_strength
        except NotKnown as why:
            if self.design.fatigue:
                unknown = "notch_unknown" if why.code == "notch_unknown" else "endurance_unknown"
                notices = (Notice(unknown),)
        if locus or fatigue is not None:
            found = self.pin_stresses.strength(
                rotates=self.design.pin.rotates,
                fatigue=fatigue,
                input_speed=self.design.turning_speed,
                deflection=True,
                locus=locus,
            )
        if self.design.bolted:
            found = self._bolted(found)
        return replace(found, notices=notices + self.size_notices + found.notices)

    @derived
    def static_pin_force(self) -> float:
        """Largest force of a satellite on a pin under the torque of static strength, N."""
        design = self.design
        if self.made is None:
            share = design.static_torque * design.distribution_factor / design.pin_torque
            return float(self.contact_force.peak_force * share)
        ways = WAYS[design.load.torque_direction]
        return max(float(abs(self.made(way * design.static_torque).on_pins).max()) for way in ways)

    @derived
    def wall_stress(self) -> float:
        """Largest bending stress of the wall about a pin's bore under that force, Pa."""
        pin = self.design.pin
        if not pin:
            raise NotKnown("section_missing", "pin")
        width = min(self.design.pin_length, self.design.pair.contact_length)
        return float(pin.section.wall_stress(line_load=self.static_pin_force / width))

    def _bolted(self, found: PinStrength) -> PinStrength:
        """The same of a bolt through a spacer: what is held is squeezed besides."""
        if not self.grip.holds:
            return replace(found, bolt=self.grip, notices=(Notice("bolt_alone"), *found.notices))
        static = found.static_stress + self.grip.squeeze
        strength = self.design.pin.material.yield_strength
        return replace(
            found,
            bolt=self.grip,
            peak_equivalent_stress=found.peak_equivalent_stress + self.grip.squeeze,
            static_stress=static,
            static_safety_factor=None if strength is None else strength / static,
        )

    @property
    def size_notices(self) -> tuple[Notice, ...]:
        """Whether the pin is thicker than its material's strengths hold for."""
        thick = self.design.pin.thick if self.design.pin else None
        return () if thick is None else (thick,)

    @derived
    def hertz(self) -> HertzContact:
        """The contact with the largest pressure: at the end of the length where the pin slopes."""
        return self.contact_at(self.line_load_factor)

    @derived
    def line_load_factor(self) -> float:
        """Largest line load of a contact over the mean one of the largest force: by the slope of
        bent pins at that angle.
        """
        judged, edge = self.judged_forces, self.edge
        if edge is None:
            return 1.0
        if isinstance(judged, RealForces):
            return edge.force / judged.force
        uneven = self.design.load_factor * self.design.distribution_factor
        return edge.force / (uneven * judged.peak_force)

    @derived
    def sloping(self) -> SlopingContacts | None:
        """The contacts of pins that slope; None without pins."""
        if not self.design.pin:
            return None
        stresses, length = self.pin_stresses, self.design.pair.contact_length
        return SlopingContacts(stresses.pin, stresses.loads, length, self.compliance)

    @derived
    def edge(self) -> EdgeLoad | None:
        """The contact with that line load; None without pins."""
        return None if self.sloping is None else self.sloping.largest()

    def contact_at(self, factor: float) -> HertzContact:
        """The contact under so many times its force."""
        force = self.judged_forces
        if isinstance(force, RealForces):
            return force.contact_at(factor)
        return hertz(
            **self.design.pair._asdict(),
            force=force.peak_force * factor,
            pin_material=self.design.lasting["pin"],
            hole_material=self.design.lasting["hole"],
            dynamic_factor=self.design.load_factor,
            distribution_factor=self.design.distribution_factor,
        )

    @cached_property
    def pressure_limits(self) -> dict[str, float]:
        """Limits of the largest pressure, Pa, by the code of their check."""
        found: dict[str, float] = {}
        for body, material in self.design.lasting.items():
            if material.limit is not None:
                allowed = float(material.limit.allowable)
                safety = self.design.requirements.pitting_safety
                found[f"contact_pressure_{body}"] = allowed / safety
            flows = material.yield_governs and material.plastic is None
            if flows and material.yield_strength is not None:
                friction, strength = self.design.sliding_friction, material.yield_strength
                found[f"contact_shakedown_{body}"] = shakedown(friction) * strength
                found[f"contact_yield_{body}"] = strength * first_yield(
                    poissons_ratio=float(material.poissons_ratio), friction=friction
                )
        return found

    def cold_limit(self, body: Body, contact: HertzContact) -> float:
        """Largest pressure at which a plastic body yields at once, Pa: cold, in the direction in
        which it is loaded, the less the further a contact wraps around its pin; without friction
        where that is not known, which is more.
        """
        material = self.design.lasting[body]
        strength, name = material.loaded_strength(body), f"contact.{body}_material"
        if strength is None:
            if material.yield_strength is None:
                raise NotKnown("yield_unknown", f"{name}.yield_strength", name)
            raise NotKnown("direction_unknown", f"{name}.layers", name)
        friction = self.design.hole_friction or 0.0
        ratio = float(material.poissons_ratio)
        factor = first_yield(poissons_ratio=ratio, friction=friction)
        if body == "hole" and contact.conformal_half_angle is not None:
            wrapped = first_yield_factor(
                half_angle=contact.conformal_half_angle,
                poissons_ratio=ratio,
                beta=contact.mismatch[1],
            )
            factor = min(factor, float(wrapped))
        return strength * factor

    @derived
    def contact_reserves(self) -> dict[str, float]:
        """Factors on the force of the contact under which it is at its limits, by the code of their
        check, where its pressure is known. Ideal forces on level pins grow with the torque.
        """
        contact = self.hertz
        factors = dict[str, float]()
        if contact.governing_pressure is not None:
            largest = self.line_load_factor
            for code, limit in self.pressure_limits.items():
                factors[code] = force_factor(
                    contact=contact,
                    contact_at=lambda factor: self.contact_at(factor * largest),
                    limit=limit,
                )
        return factors

    def disc_of(self, contact: HertzContact) -> Notice | None:
        """Whether the disc ends so near to its holes that the pressure of a contact is off by it,
        or is not known: of one that wraps around its pin.
        """
        distance = self.design.disc_distance
        if contact.conformal_pressure is None or distance is None:
            return None
        if distance < OVALS:
            return Notice("disc_ovals", {"distance": distance})
        error = disc_error(distance)
        params = {"distance": distance, "error": error}
        return Notice("finite_disc", params) if error else None

    def static_contact_at(self, factor: float) -> HertzContact:
        """The contact under so many times its force at the peak torque."""
        factor *= self.line_load_factor
        if not self.solved:
            return self.contact_at(factor * self.design.static_share)
        return self.static_forces.contact_at(factor)

    @derived
    def static_forces(self) -> RealForces:
        """Forces of the mechanism as it is made under the peak torque."""
        if self.design.static_share == 1:
            return self.loading
        return self.real_forces_at(self.design.static_torque / self.design.pin_torque)

    @derived
    def static_contact(self) -> HertzContact:
        """The contact with the largest pressure under the peak torque."""
        return self.static_contact_at(1.0)

    @derived
    def peak(self) -> dict[str, float]:
        """Where the largest pressure is reached."""
        force = self.judged_forces
        if edge := self.edge:
            at: dict[str, float] = {"satellite": edge.satellite}
            if edge.pin is not None:
                at["pin"] = edge.pin
            if isinstance(force, RealForces) and at.items() <= force.place.items():
                return force.place
            return at
        if isinstance(force, RealForces):
            return force.place
        return {
            "satellite": force.peak_pair.satellite,
            "pin": force.peak_pair.pin,
            "crank_angle": force.peak_crank_angle,
        }

    @derived
    def output_efficiency(self) -> PinLosses:
        """Friction and wear of the pins under the torque, by the forces that are judged."""
        if not self.design.rubs:
            raise NotKnown("section_missing", "friction")
        return named(self.design, "pin", self._losses)

    @property
    def efficiency(self) -> float:
        """Of the output, and of the ring where friction on its pins is given."""
        output, gear = float(self.output_efficiency.efficiency), self.design.gear
        if not gear or gear.friction is None:
            return output
        lost, power = self.ring_loss.mean_loss, self.member_loads.output_power
        assert lost is not None and power is not None  # at a speed, which the output needs
        return 1 / (1 / output + lost / power)

    @property
    def _rubbing_diameter(self) -> float | None:
        """Diameter at which rollers or sleeves turn on their pins, m."""
        design = self.design
        if design.rollers:
            return design.rollers.bore_diameter
        return design.pin.diameter if design.friction.sleeve and design.pin else None

    def _losses(self) -> PinLosses:
        design, friction, load = self.design, self.design.output_friction, self.design.load
        eccentricity, turn = design.known_eccentricity, self.lossy_turn
        speeds = design.known_speeds
        life = design.requirements.life if friction.life is None else friction.life
        found = pin_losses(
            mechanism=design.driven,
            force_exponent=load.force_exponent,
            output_torque=design.pin_torque,
            pin_circle_radius=load.pin_circle_radius,
            input_speed=speeds.turning,
            eccentricity=eccentricity,
            pin_radius=design.contact.pin_radius,
            hole_radius=design.contact.hole_radius,
            contact_length=design.contact.contact_length,
            friction_coefficient=friction.coefficient,
            distribution_factor=design.distribution_factor,
            diameter=self._rubbing_diameter,
            wear_rate=friction.wear_rate,
            life=None if friction.wear_rate is None else life,
            output_power=self.member_loads.output_power,
        )
        bare = design.sleeved and not friction.sleeve
        if bare and design.pin.diameter < 2 * design.contact.pair.pin_radius:
            found = replace(found, notices=(*found.notices, Notice("thin_without_sleeve")))
        if turn is None:
            return found
        reference = design.pin_torque / load.pin_circle_radius
        largest = max(float(np.abs(turn.on_pins).max()) for turn in self._lossy_turns)
        return made_losses(losses=found, turn=turn, reference=reference, largest=largest)

    @derived
    def _lossy_turns(self) -> list[SampledTurn]:
        """Forces of the mechanism as it is made, in each direction of the torque; none where the
        ideal ones are judged.
        """
        if self.made is None:
            return []
        load = self.design.load
        torque = self.design.pin_torque
        return [self.made(way * torque) for way in WAYS[load.torque_direction]]

    @derived
    def lossy_turn(self) -> SampledTurn | None:
        """Of these the ones with the larger losses."""
        return max(self._lossy_turns, key=lambda turn: float(turn.mean(turn.total)), default=None)

    @derived
    def roller_loads(self) -> PinRollers:
        """Loads and life of the rollers on the pins under the torque, their static safety under the
        peak torque, of at most `MOST_BEARING_PAIRS`. Without a speed there is no life.
        """
        own, design = self.design.rollers, self.design
        if not own:
            raise NotKnown("section_missing", "rollers")
        eccentricity = design.known_eccentricity
        self._limit_pairs(MOST_BEARING_PAIRS)
        given = {
            "eccentricity": eccentricity,
            "output_torque": design.pin_torque * design.distribution_factor,
            "peak_torque": design.static_torque * design.distribution_factor,
        }
        found = pin_rollers(
            **self._turning | given,
            pin_radius=design.pair.pin_radius,
            kind=own.kind,
            ratings=own.ratings,
            per_satellite=own.per_satellite,
            dynamic_rating=own.dynamic_rating,
            static_rating=own.static_rating,
            rolling_elements=own.rolling_elements,
        )
        if own.radial_clearance is not None:
            return found
        return replace(found, notices=(Notice("roller_clearance_unknown"), *found.notices))

    @property
    def rollers(self) -> "RollersOnPins":
        """The same with loss, clearance and tilt, as far as these are known."""
        deflection = if_known(lambda: self.pin_loads.deflection)
        return RollersOnPins(
            loads=self.roller_loads,
            loss=if_known(lambda: float(self.output_efficiency.mean_loss)),
            added_clearance=self.design.roller_play,
            tilt=None if deflection is None else deflection.slope,
        )

    @derived
    def ring_force(self) -> RingMesh:
        """The ring's force on a satellite."""
        gear = self.design.gear
        if not gear:
            raise NotKnown("section_missing", "gear")
        eccentricity, ratio = self.design.known_eccentricity, self.design.mechanism.ratio
        return named(
            self.design,
            "gear",
            lambda: gear.mesh(eccentricity=eccentricity, ratio=ratio),
        )

    @derived
    def ring_mesh(self) -> CycloidMesh:
        """Cycloid discs on the pins of their ring as they are made, where their modification is
        known: in exact geometry where flanks are not turned. All discs have one lag,
        or given shares of the torque.
        """
        design, gear = self.design, self.design.gear
        if gear.kind != "cycloid":
            raise NotKnown("no_ring_pins")
        change = gear.modification
        if change is None:
            raise NotKnown("modification_unknown", "gear.modification")
        if (difference := gear.teeth_difference or 1) > 1:
            raise NotKnown("cycloid_difference", difference=difference)
        if gear.every_second_pin:
            raise NotKnown("every_second_pin")
        length, disc_material = design.ring_length, design.disc_material
        if disc_material is None:
            raise NotKnown("limit_unknown", "gear.disc_material")
        shares = design.support if isinstance(design.support, Shares) else RIGID_SUPPORT
        pairs = design.ring_pins * design.mechanism.satellites
        if pairs > MOST_RING_PAIRS:
            raise NotKnown("too_many_ring_pairs", pairs=pairs, limit=MOST_RING_PAIRS)
        disc = self._of_ring(
            lambda: gear.disc(satellite_teeth=design.lobes, eccentricity=design.known_eccentricity)
        )
        return self._of_ring(
            lambda: gear.cycloid_mesh(
                disc=disc,
                crank_angles=design.mechanism.built.crank_angles,
                contact_length=length,
                disc_material=disc_material,
                law=gear.law,
                deviations=design.ring_deviations,
                exact=change.rotation == 0,
                support=shares,
            )
        )

    @derived
    def involute_pair(self) -> InvolutePair:
        """A satellite of involute teeth in its ring, where its shifts and heights are known."""
        design, gear = self.design, self.design.gear
        if gear.kind != "involute":
            raise NotKnown("no_involute")
        if gear.unknown_teeth:
            raise NotKnown("teeth_not_judged", *gear.unknown_teeth)
        eccentricity, _ = design.known_eccentricity, self.ring_force  # which refuses base circles
        assert gear.teeth_difference is not None and gear.reference_pressure_angle is not None
        low, high = STANDARD_ANGLES
        usual = low <= gear.reference_pressure_angle <= high
        if gear.teeth_difference > MOST_DIFFERENCE or not usual:
            raise NotKnown("outside_method")
        satellite, ring = design.lobes, design.ring_pins
        return self._of_ring(
            lambda: involute_pair(
                teeth=gear.involute_teeth(satellite_teeth=satellite, ring_teeth=ring),
                eccentricity=eccentricity,
            )
        )

    def satellite_torque(self, factor: float) -> float:
        """Largest torque of a satellite over the turn under so many times the torque, over that
        factor, N*m: its couple with the pins is that with an involute ring.
        """
        design = self.design
        if self.made is None:
            return design.pin_torque * design.disc_factor / design.mechanism.satellites
        torque = design.pin_torque * factor
        ways = WAYS[design.load.torque_direction]
        return max(float(abs(self.made(way * torque).couple).max()) for way in ways) / factor

    def satellite_torque_error(self, factor: float) -> float:
        """Estimate of the relative error of that torque."""
        if self.made is None:
            return 0.0
        torque = self.design.pin_torque * factor
        ways = WAYS[self.design.load.torque_direction]
        return max(self.made(way * torque).error for way in ways)

    def loaded_teeth(self, factor: float) -> dict[str, Any]:
        """What involute teeth carry under so many times the torque, as arguments."""
        design, gear = self.design, self.design.gear
        return {
            "torque": self.satellite_torque(factor),
            "contact_length": design.ring_length,
            "satellite_material": design.disc_material,
            "ring_material": gear.ring_material,
            "load_factor": factor * gear.face_load_factor,
        }

    def involute_load(self, factor: float) -> InvoluteLoad:
        """Forces and pressures of involute teeth under so many times the torque."""
        pair, loaded = self.involute_pair, self.loaded_teeth(factor)
        for body in ("satellite", "ring"):
            if loaded[f"{body}_material"] is None:
                raise NotKnown("limit_unknown", f"gear.{body}_material")
        return self._of_ring(lambda: involute_load(pair=pair, **loaded))

    @derived
    def root_stress(self) -> RootStress:
        """Bending of the roots of satellites' involute teeth under the dynamic load."""
        pair, loaded = self.involute_pair, self.loaded_teeth(self.design.load_factor)
        forces = {name: loaded[name] for name in ("torque", "contact_length", "load_factor")}
        return self._of_ring(lambda: tooth_root(pair=pair, **forces))

    def _of_ring(self, calculation: Callable[[], Calculated]) -> Calculated:
        """A result about the ring; what it refuses is not known of the design."""
        try:
            return named(self.design, "gear", calculation)
        except InvalidInput as refusal:
            raise NotKnown(refusal.code, refusal=refusal) from refusal

    @cached_property
    def ring_turn(self) -> Callable[[float], MeshTurn]:
        """These over the turn, of a torque on the pins, N*m, negative in reverse; where both meshes
        are in series, as they work in that.
        """

        def turn(torque: float) -> MeshTurn:
            if self.in_series:
                return self._of_ring(lambda: self._teeth_in_series(torque))
            return self._of_ring(lambda: mesh_over_turn(mesh=self.ring_mesh, output_torque=torque))

        return cache(turn)

    def _teeth_in_series(self, torque: float) -> MeshTurn:
        over = self.over_turn(torque)
        assert isinstance(over, SeriesOverTurn)
        assert over.turn.coarse  # refuses what cannot be
        return TeethInSeries(over)

    def ring_turns(self, torque: float) -> list[MeshTurn]:
        """The same in each direction of the torque, N*m, that of the larger pressure first."""
        ways = WAYS[self.design.load.torque_direction]
        turns = [self.ring_turn(way * torque) for way in ways]
        return sorted(turns, key=lambda turn: turn.max_pressure or 0.0, reverse=len(ways) > 1)

    @derived
    def ring_working(self) -> list[MeshTurn]:
        """The same under the torque without its factor."""
        return self.ring_turns(self.design.pin_torque)

    @derived
    def ring_loading(self) -> MeshTurn:
        """The mesh whose pressure is judged: under the dynamic load, of the satellite with most of
        it where an uneven share is stated.
        """
        factor = self.design.load_factor * self.design.ring_factor
        return self.ring_turns(self.design.pin_torque * factor)[0]

    @derived
    def ring_static(self) -> MeshTurn:
        """The same under the torque of static strength."""
        return self.ring_turns(self.design.static_torque * self.design.ring_factor)[0]

    @property
    def bent_ring_pin(self) -> DesignPin:
        """A pin of the ring that bends."""
        return self.design.gear.bent_pin

    @derived
    def ring_pin_stresses(self) -> PinStresses:
        """Stresses of the pins of the ring that bend, under the dynamic load."""
        design, mesh, pin = self.design, self.ring_mesh, self.bent_ring_pin
        made = cache(lambda torque: forces_on_ring(self.ring_turn(torque)))
        return self._of_ring(
            lambda: pin_stresses(
                mechanism=mesh.mechanism,
                output_torque=design.pin_torque * design.ring_factor,
                application_factor=design.load_factor,
                peak_torque=design.static_torque * design.ring_factor,
                torque_direction=design.load.torque_direction,
                pin_circle_radius=mesh.disc.ring_pin_circle_radius,
                contact_length=mesh.contact_length,
                diameter=pin.diameter,
                satellite_positions=pin.satellite_positions,
                material=pin.material,
                support=pin.support,
                span=pin.span,
                made=made,
            )
        )

    @derived
    def ring_pin_fatigue_strength(self) -> FatigueStrength:
        """What their fatigue is judged by."""
        return self._fatigue_of(self.bent_ring_pin, self.design.turns_over)

    @derived
    def ring_pin_strength(self) -> PinStrength:
        """Their strength, with the fatigue where it is known."""
        return self.ring_pin_stresses.strength(
            rotates=self.design.gear.rotates,
            fatigue=if_known(lambda: self.ring_pin_fatigue_strength),
            deflection=True,
        )

    @property
    def _ring_friction(self) -> RingFriction:
        """What slides on the ring."""
        gear = self.design.gear
        friction = gear.friction if gear else None
        if friction is None:
            raise NotKnown("ring_friction_unknown", "gear.friction_coefficient")
        return friction

    def _ring_losses(self, torque: float) -> list[RingLoss]:
        """Friction of cycloid discs on the pins in each direction of a torque, N*m."""
        friction, speed = self._ring_friction, self.design.turning_speed
        return [
            self._of_ring(
                lambda turn=turn: ring_loss(turn=turn, friction=friction, input_speed=speed)  # type: ignore[misc]
            )
            for turn in self.ring_turns(torque)
        ]

    @derived
    def ring_loss(self) -> RingLoss:
        """Friction in the ring under the torque: on its pins in the direction that loses more."""
        torque, friction = self.design.pin_torque, self._ring_friction
        if self.design.gear.kind == "involute":
            return involute_loss(
                pair=self.involute_pair,
                friction=friction.coefficient,
                output_torque=torque,
                input_speed=self.design.turning_speed,
            )
        return max(self._ring_losses(torque), key=lambda each: each.loss_ratio)

    @derived
    def ring_pv(self) -> float | None:
        """Largest product of pressure and sliding speed on the pins of the ring, Pa*m/s, of the
        satellite with most of the torque where an uneven share is stated, in either direction; None
        where no speed is known, or nothing slides.
        """
        found = self._ring_losses(self.design.pin_torque * self.design.ring_factor)
        return max((each.peak_pv for each in found if each.peak_pv is not None), default=None)

    @derived
    def satellite_bearing(self) -> SatelliteBearings:
        """Load and life of the satellites' bearings under the torque, their static safety under the
        peak torque, of at most `MOST_BEARING_PAIRS`. Without a speed there is no life.
        """
        bearing = self.design.bearing
        if not bearing:
            raise NotKnown("section_missing", "bearing")
        mesh = self.ring_force
        self._limit_pairs(MOST_BEARING_PAIRS)
        return named(
            self.design,
            "bearing",
            lambda: satellite_bearings(
                **self._turning,
                mesh=mesh,
                distribution_factor=self.design.disc_factor,
                centrifugal=self.centrifugal,
                kind=bearing.kind,
                dynamic_rating=bearing.dynamic_rating,
                static_rating=bearing.static_rating,
                reliability_percent=bearing.reliability_percent,
                ring_factor=bearing.ring_factor,
                weibull_slope=bearing.weibull_slope,
                peak_torque=self.design.static_torque,
            ),
        )

    @derived
    def crankshaft(self) -> Crankshaft:
        """Reactions and balance of the crankshaft under the torque, of at most
        `MOST_BEARING_PAIRS`.
        """
        return self._crankshaft()

    @derived
    def still_crankshaft(self) -> Crankshaft:
        """The same without centrifugal forces."""
        return self._crankshaft(satellite_mass=None)

    def _crankshaft(self, **other: Any) -> Crankshaft:
        own = self.design.crankshaft
        if not own:
            raise NotKnown("section_missing", "crankshaft")
        mesh, speeds = self.ring_force, self.design.known_speeds
        self._limit_pairs(MOST_BEARING_PAIRS)
        given = self._turning | self._on_shaft | {"input_speed": speeds.crank} | other
        if own.bearings is not None:
            given |= {
                "bearing_speeds": tuple(speeds.against(each.seat) for each in own.bearings),
                "kinds": tuple(each.kind for each in own.bearings),
                "dynamic_ratings": tuple(each.dynamic_rating for each in own.bearings),
            }
        return named(
            self.design,
            "crankshaft",
            lambda: crankshaft(**given, mesh=mesh, distribution_factor=self.design.disc_factor),
        )

    @property
    def _on_shaft(self) -> dict[str, Any]:
        """Places and masses of the crankshaft, as arguments."""
        own = self.design.crankshaft
        return {
            "satellite_positions": own.satellite_positions,
            "bearing_positions": own.bearing_positions,
            "satellite_mass": own.satellite_mass,
            "counterweights": own.counterweights,
            "rotor_mass": own.rotor_mass,
        }

    @derived
    def balance(self) -> Balance:
        """Balance of the crankshaft at its speed, whatever the forces are."""
        design, made = self.design, self.design.deviations
        if not design.crankshaft or design.crankshaft.satellite_mass is None:
            raise NotKnown("mass_unknown", "crankshaft.satellite_mass")
        if made is not None and any((*made.eccentricity, *made.crank_phase)):
            raise NotKnown("cranks_deviate")
        speed, eccentricity = design.known_speed, design.known_eccentricity
        return named(
            design,
            "crankshaft",
            lambda: balance(
                eccentricity=eccentricity,
                crank_angles=design.mechanism.built.crank_angles,
                input_speed=speed,
                **self._on_shaft,
            ),
        )

    @property
    def centrifugal(self) -> float:
        """Centrifugal force of a satellite, N, which relieves its bearing; 0 where mass or speed is
        not known.
        """
        shaft, speed = self.design.crankshaft, self.design.load.input_speed
        mass = shaft.satellite_mass if shaft else None
        eccentricity = self.design.contact.eccentricity
        if mass is None or speed is None or eccentricity is None:
            return 0.0
        return mass * eccentricity * speed**2
