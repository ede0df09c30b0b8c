"""Results of a design; each is calculated once or raises `NotKnown` with the reason."""

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache, cached_property
from typing import Any

from core.arrays import Number
from core.conformal import OVALS, disc_error, first_yield_factor
from core.crank.pin_rollers import PinRollers, pin_rollers
from core.design.crank_results import MOST_BEARING_PAIRS, CrankResults
from core.design.document import Design, changed, value_at
from core.design.losses import LossResults
from core.design.pin_fatigue import fatigue_of
from core.design.real_forces import RealForces
from core.design.refusals import named
from core.design.ring_results import RingResults
from core.design.sections import DesignPin
from core.errors import (
    InvalidInput,
    Notice,
    NotKnown,
    derived,
    if_known,
    is_known,
    known_equal,
    required,
)
from core.hertz import Body, HertzContact, Spread, first_yield, force_factor, hertz, shakedown
from core.output.contact_force import ContactForce, contact_force
from core.output.edge_load import EdgeLoad, SlopingContacts
from core.output.elasticity import RIGID_PINS, ContactLaw, contact_compliance, usual_law
from core.output.fit import FITS, Fit
from core.output.loaded_position import loaded_position
from core.output.mechanism import MemberLoads
from core.output.over_turn import OverTurn
from core.output.pin_bolt import Grip, grip
from core.output.pin_circle_load import PinCircleLoad
from core.output.pin_fatigue import FatigueStrength
from core.output.pin_strength import PinStrength, PinStresses, pin_stresses
from core.output.real_mechanism import RealMechanism
from core.output.real_turn import sampled
from core.output.room import Deviations, Rooms
from core.output.sampled_turn import Made, SampledTurn
from core.output.turn import Turn
from core.ring.series import MeshesInSeries, in_their_ring, series_position
from core.ring.series_samples import sampled_in_series
from core.ring.series_turn import SeriesOverTurn, SeriesTurn, positions_in_series

MOST_REAL_PAIRS, MOST_GIVING_PAIRS = 100, 25
"""Largest number of pairs whose solved forces over the turn take seconds; and of pairs with
elastic satellites."""

MOST_PIN_PAIRS = 500
"""Largest number of pairs for which the moment of a pin is followed over the turn."""

MOST_IN_SERIES = 250_000
"""Largest number of forces over the turns that is solved with both meshes in series."""

SOFTENED = (
    "contact.pin_material",
    "contact.hole_material",
    "pin.material",
    "gear.pin_material",
    "gear.disc_material",
)
"""Paths of the materials whose moduli determine deflections."""


@dataclass(frozen=True, slots=True)
class RollersOnPins:
    """Rollers on the output pins with their loads, loss and play."""

    loads: PinRollers  # for the roller with the largest load
    loss: float | None  # power loss of all rollers, mean over the turn, W
    added_clearance: float  # added to the radial clearance of pins and holes, m
    tilt: float | None  # largest slope of a pin in the rollers, rad


class Results:
    """Results of a design in SI units.

    A result that is not known raises `NotKnown`, and one that cannot exist raises
    `ImpossibleMechanism`, at each access.

    `equal` ignores the bending of pins, so that satellites of perfect parts share the load equally,
    as the papers assume. Without `bounded` forces of any number of pairs are solved, as the caller
    has limits of its own. Forces of results that are `like` these are not solved again where the
    meshes are the same.
    """

    def __init__(
        self,
        design: Design,
        *,
        equal: bool = False,
        bounded: bool = True,
        like: "Results | None" = None,
    ) -> None:
        self.design = design
        self.shared_equally, self.bounded, self.like = equal, bounded, like
        self._others: dict[float, Results] = {}  # under other torques
        self.solved = design.as_made or (design.bends and not equal)
        """True if checks judge forces solved over the turn, with clearance, deviations, elastic
        satellites or bent pins; False if they judge ideal forces."""

    @cached_property
    def in_series(self) -> bool:
        """True if both meshes are solved in series, which takes at most `MOST_IN_SERIES` forces."""
        return 0 < self.forces_in_series <= (MOST_IN_SERIES if self.bounded else math.inf)

    @property
    def uneven(self) -> bool:
        """True if satellites may share the load unequally, by solved forces or a stated factor."""
        several = self.design.mechanism.satellites > 1
        return several and (self.solved or self.design.disc_factor > 1)

    @cached_property
    def forces_in_series(self) -> int:
        """Number of forces over the turns of both meshes in series; 0 if they are not in series."""
        if not (self.design.in_series and is_known(lambda: self.ring.mesh)):
            return 0
        ring = self.ring.mesh
        pairs = self.design.pairs + ring.disc.pins * self.design.mechanism.satellites
        lobes = ring.disc.satellite_teeth
        pitches = lobes if ring.pins_alike else lobes * (lobes + 1)
        return positions_in_series(lobes=lobes, pitches=pitches) * pairs

    @derived
    def series(self) -> MeshesInSeries:
        """Both meshes in series."""
        return MeshesInSeries(self.ring.mesh, self.real)

    @property
    def stage(self) -> RealMechanism | MeshesInSeries:
        """Part that transmits the torque as it is made: the output mechanism, or both meshes."""
        return self.series if self.in_series else self.real

    @cached_property
    def ring(self) -> RingResults:
        """Results about the ring."""
        return RingResults(self)

    @cached_property
    def losses(self) -> LossResults:
        """Results about friction and wear of the pins."""
        return LossResults(self, self.ring)

    @cached_property
    def crank(self) -> CrankResults:
        """Results about bearings and crankshaft."""
        return CrankResults(self, self.ring)

    @cached_property
    def equal(self) -> "Results":
        """Results with the load shared equally between satellites, with an unchanged ring mesh."""
        return Results(self.design, equal=True, like=self)

    @property
    def two_ways(self) -> bool:
        """True if satellites of unknown clearance may share evenly or by the bending of pins."""
        return self.design.clearance_unknown and self.solved and not self.design.as_made

    def under(self, factor: float) -> "Results":
        """Results with working and peak torque multiplied by a factor, made once for each."""
        if factor not in self._others:
            torque, peak = self.design.output_torque * factor, self.design.load.peak_torque
            more = {"load.output_torque": torque, "load.peak_torque": peak and peak * factor}
            made = Results(changed(self.design, more), equal=self.shared_equally, like=self)
            self._others[factor] = made
        return self._others[factor]

    @cached_property
    def milder(self) -> dict[str, "Results"]:
        """Results with each assumed value at the mild end of its range, by its path."""
        found = {}
        for path, value in self.design.mild.items():
            made = changed(self.design, {path: value})
            found[path] = Results(made, equal=self.shared_equally, like=self)
        return found

    @cached_property
    def softest(self) -> "Results":
        """Results with the least moduli that sources state, which judge deflections."""
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
        torque = design.output_torque
        return design.members.loads(output_torque=torque, speeds=design.speeds)

    @derived
    def contact_force(self) -> ContactForce:
        """Ideal contact force."""
        load = self.design.load
        return contact_force(
            output_torque=self.design.pin_torque,
            pin_circle_radius=self.design.pin_circle_radius,
            force_exponent=load.force_exponent,
            mechanism=self.design.driven,
        )

    @derived
    def rooms(self) -> Rooms:
        """Positions of pins in holes by geometry; at most `MOST_REAL_PAIRS` pairs if bounded."""
        design = self.design
        radius, pair = design.pin_circle_radius, design.pair
        most = MOST_GIVING_PAIRS if design.support.gives else MOST_REAL_PAIRS
        if self.bounded and design.pairs > most:
            raise design.too_many(most)
        eccentricity = design.contact.eccentricity
        if eccentricity is None:
            eccentricity = pair.hole_radius - pair.pin_radius
        if eccentricity >= radius:  # holes enclose the centre
            than = {"field": "pin_circle_radius", "limit": radius}
            refusal = InvalidInput("contact.eccentricity", None, "smaller_than", **than)
            raise NotKnown(refusal.code, refusal=refusal)
        held = Rooms(
            mechanism=design.built,
            pin_circle_radius=radius,
            pin_radius=pair.pin_radius,
            eccentricity=eccentricity,
            clearance=design.play,
            deviations=design.output_deviations or Deviations(),
            roller_play=design.roller_play,
            apart=bool(design.support.given_shares),
        )
        turn = design.in_series and is_known(lambda: self.ring.mesh)
        return in_their_ring(rooms=held, ring=self.ring.mesh) if turn else held

    @derived
    def real(self) -> RealMechanism:
        """Mechanism with its clearance, deviations, contact law and bending pins."""
        design, rooms = self.design, self.rooms
        bends = design.pin and design.pin.satellite_positions
        pin = self.bent_pin if bends else RIGID_PINS
        return RealMechanism(
            mechanism=rooms.mechanism,
            pin_circle_radius=rooms.pin_circle_radius,
            pin_radius=rooms.pin_radius,
            eccentricity=rooms.eccentricity,
            contact_length=design.pair.contact_length,
            law=self.law,
            clearance=rooms.clearance,
            pin_material=design.known_material("pin"),
            hole_material=design.known_material("hole"),
            pin=pin,
            deviations=rooms.deviations,
            support=design.support,
            roller_play=rooms.roller_play,
        )

    @cached_property
    def law(self) -> ContactLaw:
        """Contact law of pins in holes, as given or by their materials."""
        known = self.design.known_material
        return self.design.contact_law or usual_law(pin=known("pin"), hole=known("hole"))

    @derived
    def grip(self) -> Grip:
        """Bolt and spacer under the largest root moment and shear, dynamic or at peak torque."""
        pin = self.design.pin
        bolt = required(pin.bolt, "section_missing", "pin")
        spacer = Results(
            changed(self.design, {"pin.bolt": None}), equal=self.shared_equally
        ).pin_loads
        peak = max(1.0, spacer.static_stress / spacer.peak_equivalent_stress)
        core = bolt.material or pin.material
        return grip(
            bolt=bolt,
            diameter=pin.diameter,
            bore=pin.bore_diameter,
            moment=peak * spacer.peak_moment,
            shear_force=peak * spacer.peak_shear_force,
            modulus_ratio=float(core.youngs_modulus / pin.material.youngs_modulus),
        )

    @derived
    def bent_pin(self) -> DesignPin:
        """Pin that bends; for a bolt through a spacer, the spacer while clamped, else the bolt."""
        pin = self.design.pin
        if not pin or pin.bolt is None:
            return pin
        held = pin.bolt.preload is not None and self.grip.holds
        return replace(pin, bolt=None) if held else pin.bolt_alone(pin.bolt)

    @derived
    def fit(self) -> Fit:
        """Result of pins that do not fit into their holes."""
        return Fit(self.rooms, self.real)

    def refuse_misfits(self) -> None:
        """Refuse forces of pins that do not fit into their holes."""
        if self.fit.misfit not in FITS:
            raise self.fit.refusal()

    def real_forces_at(self, factor: float) -> RealForces:
        """Solved forces under the torque times a factor > 0. `ImpossibleMechanism` is raised as by
        `Stage.solved`.
        """
        self.refuse_misfits()
        load = self.design.load
        return RealForces.solved(
            turn=self.over_turn,
            torque=self.design.pin_torque * factor,
            direction=load.torque_direction,
        )

    @derived
    def real_forces(self) -> RealForces:
        """Solved forces under the working torque."""
        return self.real_forces_at(1.0)

    @derived
    def loading(self) -> RealForces:
        """Solved forces under the dynamic load."""
        factor = self.design.load_factor
        return self.real_forces if factor == 1 else self.real_forces_at(factor)

    @derived
    def judged_forces(self) -> RealForces | ContactForce:
        """Forces that checks judge, solved under the dynamic load or ideal."""
        return self.loading if self.solved else self.contact_force

    @cached_property
    def alike(self) -> "Results | None":
        """Results of another design with an equal output mechanism, so that forces are equal."""
        like = self.like
        if not like or self.in_series != like.in_series:
            return None
        return like if known_equal(lambda: self.stage, lambda: like.stage) else None

    @cached_property
    def turn(self) -> Callable[[float], Turn]:
        """Mechanism solved over the turn, as a function of the torque, N*m, negative in reverse."""
        if self.alike:
            return self.alike.turn
        if self.in_series:
            self.refuse_misfits()
            return cache(lambda torque: SeriesTurn(self.series, torque))
        return cache(lambda torque: Turn(self.real, torque))

    @cached_property
    def over_turn(self) -> Callable[[float], OverTurn]:
        """Extremes over the turn, as a function of the torque, N*m, negative in reverse."""
        if self.alike:
            return self.alike.over_turn
        kind = SeriesOverTurn if self.in_series else OverTurn
        return cache(lambda torque: kind(self.turn(torque)))  # type: ignore[arg-type]

    def forces_at(self, crank_angle: float) -> tuple[tuple[float, ...], ...]:
        """Forces on the pins, N, K x N, at a crank angle, rad, in the worse direction."""
        solved = self.real_forces
        given = {"crank_angle": crank_angle, "output_torque": solved.way * solved.torque}
        if self.in_series:
            return series_position(real=self.series, **given).force
        return loaded_position(real=solved.real, **given).force

    @derived
    def made(self) -> Made:
        """Solved forces on pins and satellites over the turn, as a function of the torque, N*m."""
        if self.alike:
            return self.alike.made
        if self.in_series:
            return cache(lambda torque: sampled_in_series(self.turn(torque)))  # type: ignore[arg-type]
        return cache(lambda torque: sampled(self.turn(torque)))

    @cached_property
    def compliance(self) -> Callable[[Number], Number]:
        """Approach of a contact over its force, m/N, as a function of the force, N."""
        known = self.design.known_material
        length, pin_radius, hole_radius = self.design.pair
        if not hole_radius > pin_radius:
            than = {"field": "pin_radius", "limit": pin_radius}
            raise InvalidInput("contact.hole_radius", hole_radius, "larger_than", **than)
        return contact_compliance(
            law=self.law,
            contact_length=length,
            pin_radius=pin_radius,
            hole_radius=hole_radius,
            pin=known("pin"),
            hole=known("hole"),
        )

    @property
    def pin_load(self) -> PinCircleLoad[SampledTurn]:
        """Load on the output pins under the working torque, with the peak torque."""
        design = self.design
        return PinCircleLoad(
            mechanism=design.built,
            force_exponent=design.load.force_exponent,
            output_torque=design.pin_torque,
            peak_torque=design.static_torque,
            pin_circle_radius=design.pin_circle_radius,
            torque_direction=design.load.torque_direction,
            made=self.made if self.solved else None,
        )

    def limit_pairs(self, most: int) -> None:
        """Raise `NotKnown` if ideal forces of more than `most` pairs are to be integrated."""
        if not self.solved and self.design.pairs > most:
            raise self.design.too_many(most)

    @derived
    def fatigue_strength(self) -> FatigueStrength:
        """Fatigue strength of the pins."""
        return fatigue_of(design=self.design, pin=self.bent_pin, loads=self.design.loads_over)

    @property
    def loaded_pins(self) -> dict[str, Any]:
        """Pins and their loads, as arguments of `pin_stresses`."""
        design, pin = self.design, self.bent_pin
        factor = design.load_factor * design.distribution_factor
        return {
            "load": replace(
                self.pin_load,
                output_torque=factor * design.pin_torque,
                peak_torque=design.static_torque * design.distribution_factor,
            ),
            "diameter": pin.diameter,
            "bore_diameter": pin.bore_diameter,
            "contact_length": design.pin_length,
            "satellite_positions": pin.satellite_positions,
            "material": pin.material,
            "support": pin.support,
            "span": pin.span,
            "ring_joint": pin.ring_joint,
        }

    @derived
    def pin_stresses(self) -> PinStresses:
        """Stresses of the pins under the dynamic load, for at most `MOST_PIN_PAIRS` pairs."""
        if not self.design.pin:
            raise NotKnown("section_missing", "pin")
        self.limit_pairs(MOST_REAL_PAIRS if self.design.tied else MOST_PIN_PAIRS)
        return named(self.design, "pin", lambda: pin_stresses(**self.loaded_pins))

    @derived
    def pin_loads(self) -> PinStrength:
        """Strength and deflection of the pins, without fatigue."""
        return self.pin_stresses.strength()

    @derived
    def pin_strength(self) -> PinStrength:
        """Strength of the pins under the dynamic load, with static safety under the peak torque."""
        return self.judged_pins()

    def judged_pins(self, *, locus: bool = False) -> PinStrength:
        """Strength of the pins; `locus` adds the locus of the bending moment."""
        fatigue, notices = None, tuple[Notice, ...]()
        try:
            fatigue = self.fatigue_strength
        except NotKnown as why:
            if self.design.fatigue:
                unknown = "notch_unknown" if why.code == "notch_unknown" else "endurance_unknown"
                notices = (Notice(unknown),)
        found = self.pin_stresses.strength(
            rotates=self.design.pin.rotates,
            fatigue=fatigue,
            input_speed=self.design.turning_speed,
            locus=locus,
        )
        if self.design.bolted:
            found = self._bolted(found)
        return replace(found, notices=notices + self.size_notices + found.notices)

    @derived
    def static_pin_force(self) -> float:
        """Largest force of a satellite on a pin under the torque for static strength, N."""
        design = self.design
        if not self.solved:
            share = design.static_torque * design.distribution_factor / design.pin_torque
            return float(self.contact_force.peak_force * share)
        turns = self.pin_load.turns(design.static_torque)
        return max(float(abs(turn.on_pins).max()) for turn in turns)

    @derived
    def wall_stress(self) -> float:
        """Largest bending stress of the wall about a pin's bore under `static_pin_force`, Pa."""
        pin = self.design.pin
        if not pin:
            raise NotKnown("section_missing", "pin")
        width = min(self.design.pin_length, self.design.pair.contact_length)
        return float(pin.section.wall_stress(line_load=self.static_pin_force / width))

    def _bolted(self, found: PinStrength) -> PinStrength:
        """Strength of a bolted pin; a bolt that clamps its spacer adds the clamping stress."""
        if not self.grip.holds:
            return replace(found, bolt=self.grip, notices=(Notice("bolt_alone"), *found.notices))
        return replace(
            found,
            bolt=self.grip,
            peak_equivalent_stress=found.peak_equivalent_stress + self.grip.squeeze,
            static_stress=found.static_stress + self.grip.squeeze,
        )

    @property
    def size_notices(self) -> tuple[Notice, ...]:
        """Notice of a bent pin thicker than the strengths of its material hold for."""
        return self.bent_pin.thick if self.design.pin else ()

    @derived
    def hertz(self) -> HertzContact:
        """Contact with the largest pressure; at the end of the contact length if the pin slopes."""
        return self.contact_at(self.line_load_factor)

    @derived
    def line_load_factor(self) -> float:
        """Largest line load of a contact over the mean line load of the largest force."""
        judged = self.judged_forces
        if not self.design.pin:
            return 1.0
        edge = self.edge
        if isinstance(judged, RealForces):
            return edge.force / judged.force
        uneven = self.design.load_factor * self.design.distribution_factor
        return edge.force / (uneven * judged.peak_force)

    @derived
    def sloping(self) -> SlopingContacts:
        """Contacts of sloping pins."""
        stresses, length = self.pin_stresses, self.design.pair.contact_length
        return SlopingContacts(stresses.pin, stresses.loads, length, self.compliance)

    @derived
    def edge(self) -> EdgeLoad:
        """Contact with the largest line load."""
        return self.sloping.largest()

    def contact_at(self, factor: float) -> HertzContact:
        """Contact under its force times a factor."""
        force = self.judged_forces
        if isinstance(force, RealForces):
            return force.contact_at(factor)
        return hertz(
            **self.design.pair._asdict(),
            force=force.peak_force * factor,
            pin_material=self.design.known_material("pin"),
            hole_material=self.design.known_material("hole"),
            dynamic_factor=self.design.load_factor,
            distribution_factor=self.design.distribution_factor,
        )

    @cached_property
    def pressure_limits(self) -> dict[str, float]:
        """Limits of the largest pressure, Pa, by the code of their check."""
        found: dict[str, float] = {}
        for body, material in self.design.lasting.items():
            if material.limit:
                allowed = float(material.limit.allowable)
                safety = self.design.requirements.pitting_safety
                found[f"contact_pressure_{body}"] = allowed / safety
            flows = material.yield_governs and not material.plastic
            if flows and material.yield_strength is not None:
                friction, strength = self.sliding_friction.high, material.yield_strength
                found[f"contact_shakedown_{body}"] = shakedown(friction) * strength
                found[f"contact_yield_{body}"] = strength * first_yield(
                    poissons_ratio=float(material.poissons_ratio), friction=friction
                )
        return found

    @property
    def sliding_friction(self) -> Spread:
        """Range of the friction coefficient in the holes for the limits of metals; 0 if it is not
        known, as a check of the plastic beside them then reports that.
        """
        return if_known(lambda: self.design.hole_friction) or Spread.of(0.0)

    def cold_limit(self, body: Body, contact: HertzContact, *, most: bool = False) -> float:
        """Least pressure at which a cold plastic body may yield at once, Pa; with `most` the
        pressure at which it does for certain. Strength is taken in the direction of the load, and a
        contact that wraps around its pin lowers the limit.
        """
        material, design = self.design.known_material(body), self.design
        ratio = float(material.poissons_ratio)
        if most:
            strength = material.most_strength
            limit = material.most_pressure(if_known(lambda: design.hole_friction.low))
        else:
            path = f"contact.{body}_material"
            try:
                friction = design.hole_friction.high
            except NotKnown as why:
                unknown = material.yield_strength is None
                raise NotKnown(
                    why.code, *why.missing, *([f"{path}.yield_strength"] if unknown else [])
                ) from why
            strength = material.known_strength(body, path)
            limit = strength * first_yield(poissons_ratio=ratio, friction=friction)
        there = contact if most else self.softest_contact(contact)
        if body == "hole" and there.is_conformal and material.yield_strength is not None:
            wrapped = first_yield_factor(
                half_angle=there.conformal_half_angle,
                poissons_ratio=ratio,
                beta=there.mismatch[1],
            )
            limit = min(limit, strength * float(wrapped))
        return limit

    def softest_contact(self, contact: HertzContact) -> HertzContact:
        """Contact under an equal load with the least moduli, which wraps farther around the pin."""
        pin, hole = self.design.known_material("pin"), self.design.known_material("hole")
        if pin.softest is pin and hole.softest is hole:
            return contact
        pair = self.design.pair
        load = contact.conformity * contact.effective_modulus * (pair.hole_radius - pair.pin_radius)
        return hertz(
            **pair._asdict(),
            force=load * pair.contact_length,
            pin_material=pin.softest,
            hole_material=hole.softest,
        )

    @derived
    def contact_reserves(self) -> dict[str, float]:
        """Factors on the contact force that reach the pressure limits, by the code of the check."""
        contact, largest = self.hertz, self.line_load_factor
        _ = contact.governing_pressure
        return {
            code: force_factor(
                contact=contact,
                contact_at=lambda factor: self.contact_at(factor * largest),
                limit=limit,
            )
            for code, limit in self.pressure_limits.items()
        }

    def disc_of(self, contact: HertzContact) -> Notice | None:
        """Notice that holes near the disc's edge make a conformal pressure inexact or unknown."""
        if not contact.is_conformal:
            return None
        distance = self.design.disc_distance
        if distance < 1:
            hole = self.design.nominal_pair.hole_radius
            return Notice("hole_outside_disc", {"beyond": (1 - distance) * hole * 1e3})
        if distance < OVALS:
            return Notice("disc_ovals", {"distance": distance})
        error = disc_error(distance)
        params = {"distance": distance, "error": error}
        return Notice("finite_disc", params) if error else None

    def ovals_under(self, factor: float) -> bool:
        """True if holes near the disc's edge leave the pressure at a torque factor unknown."""
        near = self.design.disc_distance < OVALS
        return near and self.static_contact_at(factor).is_conformal

    def static_contact_at(self, factor: float) -> HertzContact:
        """Contact under its force at the peak torque times a factor."""
        factor *= self.line_load_factor
        if not self.solved:
            return self.contact_at(factor * self.design.static_share)
        return self.static_forces.contact_at(factor)

    @derived
    def static_forces(self) -> RealForces:
        """Solved forces under the torque for static strength."""
        if self.design.static_share == 1:
            return self.loading
        return self.real_forces_at(self.design.static_torque / self.design.pin_torque)

    @derived
    def static_contact(self) -> HertzContact:
        """Contact with the largest pressure under the peak torque."""
        return self.static_contact_at(1.0)

    @derived
    def peak(self) -> dict[str, float]:
        """Satellite, pin and crank angle of the largest pressure, as far as they are known."""
        force = self.judged_forces
        if self.design.pin:
            edge, at = self.edge, dict[str, float]()
            at["satellite"] = edge.satellite
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
    def roller_loads(self) -> PinRollers:
        """Loads and life of the rollers on the pins under the working torque, static safety under
        the peak torque, for at most `MOST_BEARING_PAIRS` pairs. Without a speed there is no life.
        """
        own, design = self.design.rollers, self.design
        if not own:
            raise NotKnown("section_missing", "rollers")
        eccentricity = design.known_eccentricity
        self.limit_pairs(MOST_BEARING_PAIRS)
        found = pin_rollers(
            load=replace(
                self.pin_load,
                output_torque=design.pin_torque * design.distribution_factor,
                peak_torque=design.static_torque * design.distribution_factor,
            ),
            eccentricity=eccentricity,
            input_speed=design.speeds.turning if design.speeds else None,
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
        """Rollers on the pins with loss, clearance and tilt, as far as known."""
        return RollersOnPins(
            loads=self.roller_loads,
            loss=if_known(lambda: float(self.losses.pins.mean_loss)),
            added_clearance=self.design.roller_play,
            tilt=if_known(lambda: self.pin_loads.deflection.slope),
        )
