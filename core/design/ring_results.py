"""Results about the ring: the mesh of satellites with ring pins or ring teeth."""

from collections.abc import Callable
from dataclasses import replace
from functools import cache, cached_property
from typing import Any, TypeVar

import numpy as np

from core.crank.ring_mesh import RingMesh
from core.design.output_forces import OutputForces
from core.design.pin_fatigue import fatigue_of
from core.design.refusals import named
from core.design.ring import InvoluteRing, RingBody
from core.design.sections import DesignPin
from core.errors import InvalidInput, NotKnown, derived, if_known, known_equal, required
from core.hertz import Body, first_yield
from core.numerics.extremes import first_largest
from core.output.elasticity import RIGID_SUPPORT
from core.output.pin_circle_load import PinCircleLoad
from core.output.pin_fatigue import FatigueStrength
from core.output.pin_strength import PinStrength, PinStresses, pin_stresses
from core.output.sampled_turn import WAYS, PinForces
from core.ring.bent_pins import forces_on_ring
from core.ring.involute import MOST_DIFFERENCE, STANDARD_ANGLES, InvolutePair, involute_pair
from core.ring.involute_load import InvoluteLoad, RootStress, involute_load, involute_loss
from core.ring.involute_load import root_stress as tooth_root
from core.ring.loss import RingFriction, RingLoss, ring_loss
from core.ring.series_teeth import TeethInSeries
from core.ring.series_turn import SeriesOverTurn
from core.ring.sharing import NORMALS, CycloidMesh, MeshTurn, mesh_over_turn

Calculated = TypeVar("Calculated")

PLACES_A_PIN = 12
"""Number of crank angles for each ring pin at which one that stands out is tried."""

MOST_RING_PAIRS = 300
"""Largest number of pairs of disc and ring pin that is solved over the turn."""


class RingResults:
    """Results of a design about its ring in SI units; `output` has the forces on output pins."""

    def __init__(self, output: OutputForces) -> None:
        self.design, self.output = output.design, output

    @derived
    def force(self) -> RingMesh:
        """Force of the ring on a satellite."""
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
    def on_crank(self) -> RingMesh:
        """Force of the ring on a satellite for its bearing; the mean of a solved mesh if known."""
        force, alone = self.force, self.output.solved and not self.output.in_series
        if not (alone and (turns := if_known(lambda: self.working))):
            return force
        mean = turns[0].mean_radial_force_ratio
        return replace(force, radial_force_ratio=mean, error=NORMALS)

    @derived
    def mesh(self) -> CycloidMesh:
        """Mesh of cycloid discs of known modification with the ring pins as they are made. All
        discs have one lag, or stated shares of the torque.
        """
        design, gear = self.design, self.design.cycloid
        required(gear.modification, "modification_unknown", "gear.modification")
        if (difference := gear.teeth_difference or 1) > 1:
            raise NotKnown("cycloid_difference", difference=difference)
        if gear.every_second_pin:
            raise NotKnown("every_second_pin")
        length = design.ring_length
        material = required(design.disc_material, "section_missing", "gear.disc_material")
        shares = RIGID_SUPPORT
        if design.support.given_shares:
            shares = design.satellite_coupling
        pairs = design.ring_pins * design.mechanism.satellites
        if self.output.bounded and pairs > MOST_RING_PAIRS:
            raise NotKnown("too_many_ring_pairs", pairs=pairs, limit=MOST_RING_PAIRS)
        disc = self._of_ring(
            lambda: gear.disc(satellite_teeth=design.lobes, eccentricity=design.known_eccentricity)
        )
        return self._of_ring(
            lambda: gear.cycloid_mesh(
                disc=disc,
                crank_angles=design.crank_angles,
                contact_length=length,
                disc_material=material,
                law=gear.law,
                deviations=design.ring_deviations,
                support=shares,
            )
        )

    @derived
    def pair(self) -> InvolutePair:
        """Mesh of involute satellite and ring, with known profile shifts and tooth heights."""
        assert self._involute
        eccentricity = self.design.known_eccentricity
        assert self.force  # refuses base circles
        return self.pair_at(eccentricity)

    @property
    def _involute(self) -> InvoluteRing:
        """Involute teeth whose profile shifts and heights are known."""
        gear = self.design.involute
        if gear.unknown_teeth:
            raise NotKnown("teeth_not_judged", *gear.unknown_teeth)
        return gear

    def pair_at(self, eccentricity: float | None) -> InvolutePair:
        """Mesh of involute satellite and ring at an eccentricity, m; None: without backlash."""
        design, gear = self.design, self._involute
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
        """Largest torque of a satellite over the turn under a factor on the torque, divided by the
        factor, N*m. The satellite has an equal couple with the pins and with an involute ring.
        """
        design = self.design
        if not self.output.solved:
            return design.pin_torque * design.disc_factor / design.mechanism.satellites
        turns = self.output.pin_load.turns(design.pin_torque * factor)
        return max(float(abs(turn.couple).max()) for turn in turns) / factor

    def loaded_teeth(self, factor: float) -> dict[str, Any]:
        """Arguments for the load of involute teeth under a factor on the torque."""
        design, gear = self.design, self.design.involute
        return {
            "torque": self.satellite_torque(factor),
            "contact_length": design.ring_length,
            "satellite_material": design.disc_material,
            "ring_material": gear.ring_material,
            "load_factor": factor * gear.face_load_factor,
        }

    def involute_load(self, factor: float) -> InvoluteLoad:
        """Forces and pressures of involute teeth under a factor on the torque."""
        pair, loaded = self.pair, self.loaded_teeth(factor)
        for body in ("satellite", "ring"):
            required(loaded[f"{body}_material"], "limit_unknown", f"gear.{body}_material")
        return self._of_ring(lambda: involute_load(pair=pair, **loaded))

    @derived
    def root_stress(self) -> RootStress:
        """Bending stress at the tooth roots of involute satellites under the dynamic load."""
        pair, loaded = self.pair, self.loaded_teeth(self.design.load_factor)
        forces = {name: loaded[name] for name in ("torque", "contact_length", "load_factor")}
        return self._of_ring(lambda: tooth_root(pair=pair, **forces))

    def _of_ring(self, calculation: Callable[[], Calculated]) -> Calculated:
        """Result of a calculation about the ring; a refusal becomes `NotKnown`."""
        try:
            return named(self.design, "gear", calculation)
        except InvalidInput as refusal:
            raise NotKnown(refusal.code, refusal=refusal) from refusal

    @cached_property
    def alike(self) -> "RingResults | None":
        """Results about the ring of another design with an equal mesh, so that forces are equal."""
        if self.output.in_series:
            return getattr(self.output.alike, "ring", None)
        like: RingResults | None = getattr(self.output.like, "ring", None)
        return like if like and known_equal(lambda: self.mesh, lambda: like.mesh) else None

    @cached_property
    def turn(self) -> Callable[[float], MeshTurn]:
        """Ring mesh over the turn, as a function of the torque on the pins, N*m."""
        if self.alike:
            return self.alike.turn

        def turn(torque: float) -> MeshTurn:
            if self.output.in_series:
                return self._of_ring(lambda: self._teeth_in_series(torque))
            return self._of_ring(lambda: mesh_over_turn(mesh=self.mesh, output_torque=torque))

        return cache(turn)

    def _teeth_in_series(self, torque: float) -> MeshTurn:
        over = self.output.over_turn(torque)
        assert isinstance(over, SeriesOverTurn)
        assert over.turn.coarse  # refuses impossible mechanisms
        return TeethInSeries(over)

    def turns(self, torque: float) -> list[MeshTurn]:
        """Ring mesh in each direction of the torque, N*m; the larger pressure comes first."""
        turns = [self.turn(way * torque) for way in WAYS[self.design.load.torque_direction]]
        if len(turns) == 1:
            return turns
        first = first_largest([turn.max_pressure for turn in turns])
        return turns[first:] + turns[:first]

    @derived
    def working(self) -> list[MeshTurn]:
        """Ring mesh under the working torque in each direction; the larger pressure comes first."""
        return self.turns(self.design.pin_torque)

    @derived
    def loading(self) -> MeshTurn:
        """Ring mesh of the most loaded satellite under the dynamic load, in the worse direction."""
        factor = self.design.load_factor * self.design.ring_factor
        return self.turns(self.design.pin_torque * factor)[0]

    @derived
    def pressure_on_high_pin(self) -> float:
        """Largest pressure over the turn, Pa, under the dynamic load, on one ring pin whose surface
        is ahead of the others by half the zone of the pins' places.
        """
        pins, turn = self.design.ring_pins, self.loading.turn
        high = (self.design.ring_zone / 2, *[0.0] * (pins - 1))
        made = replace(self.mesh.deviations, pin_radius=high)
        real = mesh = replace(self.mesh, deviations=made)
        if self.output.in_series:
            real = replace(turn.real, ring=mesh)
        places = np.linspace(0.0, 2 * np.pi, PLACES_A_PIN * pins, endpoint=False).tolist()
        rows = type(turn)(real, turn.torque).poses(places, play=False)
        return mesh.pressure(float(rows["mesh_pressure"].max()))

    @derived
    def static(self) -> MeshTurn:
        """Ring mesh under the torque for static strength, in the worse direction."""
        return self.turns(self.design.static_torque * self.design.ring_factor)[0]

    def teeth_strength(self, body: RingBody) -> float:
        """Strength of plastic teeth or ring pins in the direction of their load, Pa."""
        own: Body = "pin" if body == "pin" and self.design.gear.kind == "cycloid" else "hole"
        material = self.design.plastic_teeth[body]
        return material.known_strength(own, self.design.teeth_path(body))

    def cold_limit(self, body: RingBody, *, most: bool = False) -> float:
        """Pressure at which plastic teeth may yield at once, Pa; with `most` certainly yield."""
        material, design = self.design.plastic_teeth[body], self.design
        if most:
            return material.most_pressure(if_known(lambda: design.teeth_friction.low))
        ratio, strength = float(material.poissons_ratio), self.teeth_strength(body)
        return strength * first_yield(poissons_ratio=ratio, friction=design.teeth_friction.high)

    @property
    def pin(self) -> DesignPin:
        """Ring pin that bends."""
        return self.design.cycloid.bent_pin

    @cached_property
    def on_pins(self) -> Callable[[float], PinForces]:
        """Forces on the ring pins over the turn, as a function of the torque, N*m."""
        return cache(lambda torque: forces_on_ring(self.turn(torque)))

    @derived
    def pin_stresses(self) -> PinStresses:
        """Stresses of bending ring pins under the dynamic load."""
        design, mesh, pin = self.design, self.mesh, self.pin
        return self._of_ring(
            lambda: pin_stresses(
                load=PinCircleLoad(
                    mechanism=mesh.mechanism,
                    output_torque=design.load_factor * (design.pin_torque * design.ring_factor),
                    peak_torque=design.static_torque * design.ring_factor,
                    torque_direction=design.load.torque_direction,
                    pin_circle_radius=mesh.disc.ring_pin_circle_radius,
                    made=self.on_pins,
                ),
                contact_length=mesh.contact_length,
                diameter=pin.diameter,
                satellite_positions=pin.satellite_positions,
                material=pin.material,
                support=pin.support,
                span=pin.span,
            )
        )

    @derived
    def pin_fatigue_strength(self) -> FatigueStrength:
        """Fatigue strength of the ring pins."""
        return fatigue_of(design=self.design, pin=self.pin, loads=self.design.turns_over)

    @derived
    def pin_strength(self) -> PinStrength:
        """Strength of the ring pins, with fatigue if it is known."""
        return self.pin_stresses.strength(
            rotates=self.design.cycloid.rotates,
            fatigue=if_known(lambda: self.pin_fatigue_strength),
        )

    @property
    def _friction(self) -> RingFriction:
        """Sliding contact of the ring with its friction coefficient."""
        return self.design.gear.friction

    def _losses(self, torque: float) -> list[RingLoss]:
        """Friction losses of cycloid discs on the ring pins in each direction of a torque, N*m."""
        friction, speed = self._friction, self.design.turning_speed
        return [
            self._of_ring(
                lambda turn=turn: ring_loss(turn=turn, friction=friction, input_speed=speed)  # type: ignore[misc]
            )
            for turn in self.turns(torque)
        ]

    @derived
    def loss(self) -> RingLoss:
        """Friction loss in the ring under the working torque; for pins in the worse direction."""
        torque, friction = self.design.pin_torque, self._friction
        if self.design.gear.kind == "involute":
            return involute_loss(
                pair=self.pair,
                friction=friction.coefficient,
                output_torque=torque,
                input_speed=self.design.turning_speed,
            )
        return max(self._losses(torque), key=lambda each: each.loss_ratio)

    @derived
    def pv(self) -> float:
        """Largest pressure times sliding speed on the ring pins, Pa*m/s, in the worse direction."""
        found = self._losses(self.design.pin_torque * self.design.ring_factor)
        return max(each.peak_pv for each in found)
