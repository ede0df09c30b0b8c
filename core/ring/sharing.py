"""Load sharing of ring pins on cycloid discs, with modification, errors and elasticity.

Every disc is rigid and held by its eccentric. The one unknown is the lag of its teeth behind their
ideal angle, which `core.drive.engine` finds.
"""

import math
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np

from core.arrays import FloatArray, IntArray, check_positive, check_single
from core.drive import engine
from core.drive.model import Pieces
from core.errors import Accuracy, ImpossibleMechanism, InvalidInput, Notice, derived, poorly_known
from core.fields import answer, answered
from core.hertz import ElasticMaterial, effective_modulus
from core.numerics.extremes import first_largest
from core.output.contact_force import PairNumber
from core.output.elasticity import (
    RIGID_PINS,
    RIGID_SUPPORT,
    ContactLaw,
    HertzLaw,
    Law,
    LinearLaw,
    Pins,
    SatelliteSupport,
    Shares,
    check_law,
    law_constants,
)
from core.output.mechanism import Mechanism
from core.output.over_turn import OverTurn
from core.output.real_turn import CloseSamples, close_samples
from core.output.room import deviation_row
from core.output.stage import Solved, Stage, check_torque
from core.ring.drives import ring_drive
from core.ring.profile import CycloidDisc, Modification

DEPTHS = 0.5, 2.0
"""Range of reference depth over ring pin radius in which a half-space stands for a disc."""

USUAL_SHORTENING = 0.35, 0.9
"""Usual range of the shortening coefficient K1."""

LOOKED_PRESSING = 180
"""Number of positions of the first search for the largest interference; a finer one follows."""

NORMALS = 2e-3
"""Error of forces along the eccentric over forces across it, because normals are those of perfect
parts. Discs with 1.8 arc minutes of lag under 1200 MPa had 1.6e-3."""


@dataclass(frozen=True, slots=True)
class RingDeviations:
    """Deviations of a ring with z_p pins and K discs from nominal; empty tuples are zeros.

    Positive is outward, in the direction of the output's rotation, larger, or ahead.
    """

    pin_radial: tuple[float, ...] = ()  # place of each ring pin, m, z_p values
    pin_tangential: tuple[float, ...] = ()  # m, z_p values
    pin_radius: tuple[float, ...] = ()  # m, z_p values
    eccentricity: tuple[float, ...] = ()  # one for each crank, m, K values
    crank_phase: tuple[float, ...] = ()  # angle of each crank, rad, K values
    disc_phase: tuple[float, ...] = ()  # angle of each disc's holes to its teeth, rad, K values

    def each(self, *, pins: int, satellites: int) -> tuple[list[float], ...]:
        """All deviations as lists filled with zeros; InvalidInput for a wrong length or entry."""
        return tuple(
            deviation_row(
                name, values=getattr(self, name), expected=pins if index < 3 else satellites
            )
            for index, name in enumerate(self.__slots__)
        )


@dataclass(frozen=True)
class CycloidMesh(Stage):
    """Cycloid discs on a ring of pins as they are made."""

    disc: CycloidDisc  # nominal size of all discs
    crank_angles: tuple[float, ...]  # alpha_j of the K discs, rad
    contact_length: float  # b of a disc on a pin, m, > 0
    law: ContactLaw  # contact law of each pair
    pin_material: ElasticMaterial  # material of the ring pins
    disc_material: ElasticMaterial  # material of the discs
    pin: Pins = RIGID_PINS  # bending of ring pins held at both ends; none by default
    seat_stiffness: float = math.inf  # radial stiffness of a pin in its bore and the housing, N/m
    deviations: RingDeviations = field(default_factory=RingDeviations)  # real deviations
    exact: bool = True  # false: geometry in first order of lag and deviations
    # Given shares of the torque, or rigid: then all discs have one lag. No other kind is accepted.
    support: SatelliteSupport = RIGID_SUPPORT

    kind = engine.LOBE

    def __post_init__(self) -> None:
        check_single(contact_length=self.contact_length, seat_stiffness=self.seat_stiffness)
        check_positive(contact_length=self.contact_length, seat_stiffness=self.seat_stiffness)
        check_law(self.law)
        self.disc.refuse_undercut()
        low, high = (each * self.disc.ring_pin_radius for each in DEPTHS)
        if not self.reference_depth >= low:
            depth = self.reference_depth
            raise InvalidInput("reference_depth", depth, "greater_than_equal", limit=low)
        if not self.reference_depth <= high:
            raise InvalidInput(
                "reference_depth", self.reference_depth, "less_than_equal", limit=high
            )
        if self.support.gives and not self.support.given_shares:
            raise InvalidInput("support", self.support, "not_in_table", values="given shares")
        self.support.check(len(self.crank_angles))

    @cached_property
    def mechanism(self) -> Mechanism:  # type: ignore[override] # not set
        """Ring pins and cranks as a mechanism whose wave of forces turns with the crank."""
        return Mechanism(self.disc.pins, self.crank_angles, math.inf)

    @property
    def perfect(self) -> "CycloidMesh":
        """Mesh of perfect rigid parts with linear contacts."""
        return replace(
            self,
            disc=replace(self.disc, modification=Modification()),
            law=LinearLaw(1e8),
            pin=RIGID_PINS,
            seat_stiffness=math.inf,
            deviations=RingDeviations(),
            exact=False,
            support=RIGID_SUPPORT,
        )

    @property
    def eccentricity(self) -> float:
        """Eccentricity e of the cranks, m."""
        return self.disc.eccentricity

    @property
    def dead_angles(self) -> tuple[float, ...]:
        """Angles from the crank where a pin gains or loses contact or its lever is longest, rad."""
        longest = math.acos(self.disc.shortening_coefficient)
        return 0.0, math.pi, longest, -longest

    @property
    def pins_alike(self) -> bool:
        """True if no ring pin has a deviation."""
        own = self.deviations
        return not any(map(any, (own.pin_radial, own.pin_tangential, own.pin_radius)))

    @property
    def reference_depth(self) -> float:
        """Depth over which the approach of pin and disc counts, m; by default the pin radius."""
        radius = self.disc.ring_pin_radius
        return float(self.law.depth(radius) if isinstance(self.law, HertzLaw) else radius)

    @property
    def compliance(self) -> list[float]:
        """Compliance of a ring pin at each disc by its seat and its bending, m/N."""
        seat = 1 / self.seat_stiffness
        return [each + seat for each in self.pin.bending(len(self.crank_angles))]

    @property
    def law_constants(self) -> Law:
        """Constants of the contact law from which those of each pair are made."""
        return law_constants(
            law=self.law,
            contact_length=self.contact_length,
            hole_radius=self.reference_depth,
            pin=self.pin_material,
            hole=self.disc_material,
        )

    @cached_property
    def drive(self) -> Pieces:
        """Ring and discs as the engine takes them."""
        self._refuse_no_radius()
        return ring_drive(self)

    def _refuse_no_radius(self) -> None:
        """Raise ImpossibleMechanism if a pin radius or an eccentricity as made is not positive."""
        own, count = self.deviations, len(self.crank_angles)
        pins = np.array(own.pin_radius or (0.0,) * self.disc.pins) + self.disc.ring_pin_radius
        cranks = np.array(own.eccentricity or (0.0,) * count) + self.eccentricity
        none = np.minimum(pins, cranks[:, None]) <= 0
        if none.any():
            j, k = divmod(int(none.argmax()), self.disc.pins)
            raise ImpossibleMechanism("no_radius_left", satellite=j + 1, pin=k + 1)

    @property
    def pin_radii(self) -> FloatArray:
        """Radius of each ring pin with its deviation, m."""
        errors = self.deviations.pin_radius or (0.0,) * self.disc.pins
        return self.disc.ring_pin_radius + np.array(errors)

    def pressing_at(self, psi: float) -> float:
        """Interference without load at a crank angle (rad), m: the largest approach of any pair at
        the lag where that is least; below 0 if pairs are free.
        """
        return float(self.unloaded(np.array([psi]), least=True)[0, engine.INTERFERENCE])

    def with_thinner_pins(self, closer: float) -> "CycloidMesh":
        """Mesh with all ring pin radii smaller by a length in m."""
        own = self.deviations
        thinner = tuple(each - closer for each in own.pin_radius or (0.0,) * self.disc.pins)
        return replace(self, deviations=replace(own, pin_radius=thinner))

    def pressure(self, force_over_radius: float) -> float:
        """Largest Hertz pressure in Pa from a force over the reduced radius in N/m."""
        modulus = effective_modulus(first=self.pin_material, second=self.disc_material)
        return math.sqrt(force_over_radius * modulus / (math.pi * self.contact_length))

    def notices(self, *, pressed: bool) -> tuple[Notice, ...]:
        """Notices on limits that the mesh strains; ``pressed``: pairs press without load."""
        found = [Notice("pressed_without_load")] if pressed else []
        low, high = USUAL_SHORTENING
        if not low <= self.disc.shortening_coefficient <= high:
            share = {"shortening": self.disc.shortening_coefficient}
            found.append(Notice("unusual_shortening", share))
        if self.disc.modification.rotation > 0:
            found.append(Notice("flanks_turned"))
        if not self.pin.bends and not math.isfinite(self.seat_stiffness):
            found.append(Notice("seat_rigid"))
        return tuple(found)


@dataclass(frozen=True, slots=True, kw_only=True)
class MeshPosition:
    """Cycloid mesh at one crank angle under load."""

    crank_angle: float = answer("deg", "φ")
    """Crank angle."""
    rotation: tuple[float, ...] = answer("arcmin", "θ_j")
    """Lag of each disc's teeth behind their ideal angle, including clearance; negative in reverse.
    The lag of a rigid output is the same."""
    force: tuple[tuple[float, ...], ...] = answer("N", "F_jk")
    """Force of each ring pin, as one list per satellite."""
    disc_torque: tuple[float, ...] = answer("Nm", "T_j", "ΣF·h")
    """Torque of the forces about each disc's centre."""
    crank_across: tuple[float, ...] = answer("N", "W_j")
    """Force of the ring on each disc against the turning of its crank."""
    crank_along: tuple[float, ...] = answer("N")
    """Force of the ring on each disc along its crank, to the axis."""
    loaded_pairs: int = answer()
    """Number of pairs with a force."""
    play: tuple[float, float] | None = answer("arcmin", "θ₋, θ₊")
    """Least and largest lag of the unloaded discs; absent if pairs press without load."""
    interference: float | None = answer("mm", "δ")
    """Least possible value of the largest approach of the unloaded pairs, if pairs press without
    load."""
    stiffness: float = answer("Nm_per_arcmin", "dT/dθ")
    """Torsional stiffness of the mesh alone: slope of the torque over the rotation."""
    max_pressure: float = answer("MPa", "p_0", "Johnson 4.2")
    """Largest Hertz pressure of the pairs."""
    # Largest distance of a loaded contact from its pitch point, m. A disc slides on a fixed pin at
    # this distance times the speed of the output.
    sliding_distance: float
    sliding_loss: float  # sum of force times sliding distance over the torque
    accuracy: Accuracy  # error of the forces over the largest force
    notices: tuple[Notice, ...]


def mesh_position(*, mesh: CycloidMesh, crank_angle: float, output_torque: float) -> MeshPosition:
    """Forces of all pairs, angular deflection, backlash and stiffness at one crank angle.

    Friction, speed, tilting and edge load, deformation of discs and ring, clearance and compliance
    of the eccentric's bearings, and errors of single lobes are left out. Raises ImpossibleMechanism
    if there is no stable equilibrium, see `Stage.solved`. The torque of all discs, N*m, is not 0
    and negative in reverse.

    Perfect rigid parts of 29 lobes, a force of the ring of 1600 N across the crank:

    >>> from core.output.elasticity import LinearLaw
    >>> disc = CycloidDisc(satellite_teeth=29, eccentricity=1.250025e-3,
    ...                    ring_pin_circle_radius=0.0525, ring_pin_radius=3.5e-3)
    >>> steel = ElasticMaterial(210e9, 0.3)
    >>> mesh = CycloidMesh(disc=disc, crank_angles=(0.0,), contact_length=0.0135, exact=False,
    ...                    law=LinearLaw(1e8), pin_material=steel, disc_material=steel)
    >>> found = mesh_position(mesh=mesh, crank_angle=0.0, output_torque=58.0)
    >>> round(found.crank_across[0], 6), round(max(found.force[0]), 6)
    (1599.968001, 212.944548)
    """
    check_torque(output_torque, crank_angle=crank_angle)
    room = mesh.solved([mesh.wave(crank_angle)], output_torque)
    w, pairs = room.work.w, room.contacts(engine.LOBE)
    force, far = room.forces[0, pairs], w[pairs, engine.SLIDE]
    along, across, torques = room.by_ring[0].T
    loaded = force > 0
    pressed = bool(room.pressed[0])
    ends = sorted((math.copysign(1.0, output_torque) * room.play[0] + 0.0).tolist())
    accuracy = Accuracy("newton_bracket", float(room.error[0] / force.max()), room.steps)
    own = room.lags[0] if mesh.support.given_shares else room.lags[0].repeat(len(along))
    return MeshPosition(
        crank_angle=crank_angle,
        rotation=tuple(own.tolist()),
        force=mesh.rows(force.tolist()),
        disc_torque=tuple(torques.tolist()),
        crank_across=tuple(across.tolist()),
        crank_along=tuple(along.tolist()),
        loaded_pairs=int(loaded.sum()),
        play=None if pressed else (ends[0], ends[1]),
        interference=mesh.pressing_at(mesh.wave(crank_angle)) if pressed else None,
        stiffness=float(room.stiffness[0]),
        max_pressure=mesh.pressure(float(room.rows[0, engine.LOBE_PRESSED])),
        sliding_distance=float(far[loaded].max()),
        sliding_loss=float((force * far).sum()) / abs(output_torque),
        accuracy=accuracy,
        notices=(*mesh.notices(pressed=pressed), *poorly_known(accuracy)),
    )


def mesh_gaps(
    *, mesh: CycloidMesh, crank_angle: float, rotation: tuple[float, ...] = ()
) -> tuple[tuple[float, ...], ...]:
    """Gaps of all pairs where the discs have given lags, m, K x z_p; negative if a pair presses.
    `rotation` has the lag of each disc, rad, negative in reverse; 0 by default.
    """
    check_single(crank_angle=crank_angle)
    lags = np.array([rotation or (0.0,) * len(mesh.crank_angles)], float)
    return mesh.rows(gaps_at(mesh=mesh, crank_angle=np.array([crank_angle]), lags=lags)[0].tolist())


def gaps_at(*, mesh: CycloidMesh, crank_angle: FloatArray, lags: FloatArray) -> FloatArray:
    """Gaps as `mesh_gaps` at M crank angles, rad, with lags of shape (M, K); shape (M, K*z_p)."""
    count = len(mesh.crank_angles)
    room = Solved.of(replace(mesh, support=Shares((1 / count,) * count)).drive)
    found = np.zeros((len(crank_angle), len(room.work.w)))
    for angle, own, row in zip(crank_angle.tolist(), lags, found, strict=True):
        engine.gaps(mesh.wave(angle), np.ascontiguousarray(own), room.drive, room.work, row)
    return -found[:, room.contacts(engine.LOBE)]


class MeshTurn(OverTurn):
    """Extremes of a cycloid mesh under a torque over a turn of the crank, found on demand."""

    @property
    def mesh(self) -> CycloidMesh:
        """Mesh as it is made."""
        found: CycloidMesh = self.turn.real
        return found

    @property
    @answered("MPa", "p_0", "Johnson 4.2")
    def max_pressure(self) -> float:
        """Largest Hertz pressure over the turn."""
        return self.mesh.pressure(self._pressed.height)

    @derived
    def hardest_place(self) -> tuple[PairNumber, float]:
        """Pair with the largest Hertz pressure, and the crank angle at which it occurs, rad."""
        place, turn = self._pressed.place, self.turn
        room = self.mesh.solved([place], turn.torque)
        pairs = room.contacts(engine.LOBE)
        pressed = room.forces[0, pairs] * room.work.w[pairs, engine.BENT]
        satellite, pin = divmod(first_largest(pressed), self.mesh.disc.pins)
        return PairNumber(satellite + 1, pin + 1), place % self._period

    @property
    def _period(self) -> float:
        """Range of the crank angles in answers, rad."""
        return 2 * math.pi

    def forces_at(self, crank_angle: float) -> FloatArray:
        """Forces of all pairs at a crank angle (rad) of the period, N, shape (K, z_p)."""
        forces: FloatArray = self.turn.poses([crank_angle])["teeth"]
        return forces.reshape(-1, self.mesh.disc.pins)

    @property
    def play_in_ring(self) -> float:
        """Largest backlash of the unloaded discs in the ring, rad."""
        return self.backlash_max

    @derived
    def interference(self) -> float:
        """Largest interference without load over the turn, m; 0 if no pair presses anywhere."""
        places = self.turn.places
        if not any(self.mesh.free(each, 1.0)[1].any() for each in places):
            return 0.0
        wave = np.sort(np.concatenate(places))
        apart = math.ceil(len(wave) / LOOKED_PRESSING)

        def pressing(places: IntArray) -> FloatArray:
            found: FloatArray = self.mesh.unloaded(wave[places], least=True)[:, engine.INTERFERENCE]
            return found

        coarse = np.arange(0, len(wave), apart)
        top = coarse[pressing(coarse).argmax()]
        near = np.arange(top - apart, top + apart + 1) % len(wave)
        return max(float(pressing(near).max()), 0.0)

    @property
    @answered()
    def peak_force_ratio(self) -> float:
        """Largest force of all pairs over that of perfect parts."""
        return self.peak_force / self.ideal.peak_force

    @property
    def ideal(self) -> "IdealMesh":
        """Mesh of perfect parts under the torque of one disc."""
        torque = abs(self.turn.torque) / len(self.mesh.crank_angles)
        return ideal_mesh(disc=self.mesh.disc, disc_torque=torque)

    @property
    @answered("arcmin", "θ")
    def lag_max(self) -> float:
        """Largest lag of a disc under load."""
        high, low = self.lags
        return high if self.turn.torque > 0 else -low

    @property
    @answered("arcmin", "θ")
    def lag_min(self) -> float:
        """Least lag of a disc under load; negative in reverse."""
        high, low = self.lags
        return low if self.turn.torque > 0 else -high

    @property
    def _across(self) -> float:
        """Force across the crank of a disc that carries an equal share of the torque, N."""
        disc = self.mesh.disc
        each = abs(self.turn.torque) / len(self.mesh.crank_angles)
        return each / (disc.eccentricity * disc.satellite_teeth)

    @derived
    @answered()
    def radial_force_ratio_max(self) -> float:
        """Largest force of the ring along a crank, over the force across the crank of a disc that
        carries its even share of the torque; negative outwards.
        """
        return self._by_values(engine.ALONG_MOST) / self._across

    @derived
    @answered()
    def radial_force_ratio_min(self) -> float:
        """Least force of the ring along a crank, over the force across the crank of a disc that
        carries its even share of the torque; negative outwards.
        """
        return self._by_values(engine.ALONG_LEAST, -1) / self._across

    @property
    def close(self) -> CloseSamples:
        """Forces of all pairs, sampled closely enough to interpolate."""
        return close_samples(self.turn)

    @property
    def _even_forces(self) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Forces of all pairs at even positions, N, angles of the pins from the cranks, rad, and S,
        distances to the pitch points over the pin circle radius; shape (M, pairs).
        """
        rows, disc, phases = self.turn.fine, self.mesh.disc, np.array(self.mesh.phases)
        there = np.searchsorted(rows["wave"], self.turn.positions()[0])
        ring = 2 * np.pi * np.arange(disc.pins) / disc.pins
        angle = rows["wave"][there, None] + (phases[:, None] + ring).ravel()
        k = disc.shortening_coefficient
        slope = np.sqrt((1 - k) ** 2 + 4 * k * np.sin(angle / 2) ** 2)
        return rows["teeth"][there], angle, slope

    @property
    def mean_radial_force_ratio(self) -> float:
        """Mean forces along the cranks over those across them, with normals of perfect parts."""
        force, angle, slope = self._even_forces
        along = (force * (np.cos(angle) - self.mesh.disc.shortening_coefficient) / slope).sum(1)
        across = abs((force * np.sin(angle) / slope).sum(1).mean())
        return float(along.mean() / across)

    @derived
    def sliding_loss(self) -> float:
        """Loss over output for mu = 1: mean sum of force times distance to pitch point / torque."""
        (force, _, slope), disc = self._even_forces, self.mesh.disc
        far = np.abs(disc.ring_pin_circle_radius * slope - disc.ring_pin_radius)
        return float((force * far).sum(axis=1).mean()) / abs(self.turn.torque)

    @derived
    def hardest_rub(self) -> float:
        """Largest product over the turn of force and distance to the pitch point, N*m."""
        return self._by_values(engine.RUB)

    @derived
    def hardest_pressed_rub(self) -> float:
        """Largest product over the turn of Hertz pressure and distance to the pitch point, Pa*m."""
        return self.mesh.pressure(1.0) * self._by_values(engine.RUB_PRESSED)

    @property
    def notices(self) -> tuple[Notice, ...]:
        """Notices on limits that the mesh strains and on poor accuracy."""
        own = self.mesh.notices(pressed=self.pressed_without_load)
        return (*own, *poorly_known(self.accuracy))


def mesh_over_turn(
    *, mesh: CycloidMesh, output_torque: float, lost_motion_share: float = 0.03
) -> MeshTurn:
    """Peak force, backlash, lost motion, transmission error and stiffness over the turn.

    Raises ImpossibleMechanism if a position has no stable equilibrium, see `Stage.solved`.
    Arguments are those of `core.output.over_turn.over_turn`; the torque is that of all discs.
    """
    return MeshTurn.of(mesh, output_torque, lost_motion_share)


@dataclass(frozen=True, slots=True)
class IdealMesh:
    """Mesh of a perfect disc on many pins with linear contacts."""

    peak_force: float = answer("N", "F_max")
    """Largest force of a pin, 4T_j/(K₁·z₂·R_p)."""
    mean_sum_force: float = answer("N", "ΣF")
    """Mean over the turn of the sum of forces on a disc, 4T_j/(π·e·z₂)."""
    backlash: float | None = answer("arcmin", "", "2(Δ_e − Δ_p·q)/(e·z₂)")
    """Play caused by the modification alone; absent if the modification makes the mesh jam."""


def ideal_mesh(*, disc: CycloidDisc, disc_torque: float) -> IdealMesh:
    """Forces and backlash of a perfect disc under its torque T, on many pins, in closed form.

    Levers are ``h = e*z*sin(a)/S``, at most ``e*z`` at ``cos(a) = K1``. Over the half of the pins
    that carries, the squares of ``sin(a)/S`` sum to z_p/4 for any K1: ``F_max = 4*T/(e*z*z_p)``,
    ``sum F = 4*T/(pi*e*z)``. The backlash is the least of ``2*g/|h|`` over the angles. Derived.

    >>> from core.ring.profile import Modification
    >>> disc = CycloidDisc(satellite_teeth=18, eccentricity=1.5e-3,
    ...                    ring_pin_circle_radius=0.034, ring_pin_radius=2.5e-3,
    ...                    modification=Modification(equidistant=1e-5))
    >>> found = ideal_mesh(disc=disc, disc_torque=30.0)
    >>> round(found.peak_force, 6), round(math.degrees(found.backlash)*60, 5)
    (233.918129, 2.54648)
    """
    longest = disc.eccentricity * disc.satellite_teeth
    return IdealMesh(
        peak_force=4 * disc_torque / (longest * disc.pins),
        mean_sum_force=4 * disc_torque / (math.pi * longest),
        backlash=_ideal_backlash(disc),
    )


def _ideal_backlash(disc: CycloidDisc) -> float | None:
    """Backlash of a disc from its modification alone, rad; None if that makes pins press."""
    longest, k = disc.eccentricity * disc.satellite_teeth, disc.shortening_coefficient
    wider, circle = disc.modification.equidistant, disc.modification.pin_circle
    root = math.sqrt((1 - k) * (1 + k))
    if circle <= (root * wider if wider > 0 else wider):
        free = 2 * (wider - circle * root) / longest
    elif root * wider < circle < wider:
        free = 2 * k * math.sqrt((wider - circle) * (wider + circle)) / longest
    else:
        return None
    free += 2 * disc.modification.rotation
    return free if free >= 0 else None
