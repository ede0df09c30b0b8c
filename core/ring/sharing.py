"""Load sharing of a ring of pins on cycloid discs, with modification, errors and elasticity.

Every disc is rigid and held by its crank. The one unknown is the lag of its teeth behind their
ideal angle; `core.drive.engine` finds it.
"""

import math
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np

from core.arrays import FloatArray, IntArray, check_finite, check_positive, check_single
from core.drive import engine
from core.drive.model import Pieces
from core.errors import Accuracy, ImpossibleMechanism, InvalidInput, Notice, derived, poorly_known
from core.hertz import ElasticMaterial, effective_modulus
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
from core.output.stage import Solved, Stage
from core.output.turn import Turn
from core.ring.drives import ring_drive
from core.ring.profile import CycloidDisc, Modification

DEPTHS = 0.5, 2.0
"""Reference depths over the pin's radius within which a half-space stands for a disc."""

USUAL_SHORTENING = 0.35, 0.9
"""Shortening coefficients of most drives."""

LOOKED_PRESSING = 180
"""Positions of the turn at which is looked for what presses most, then between two of them."""

NORMALS = 2e-3
"""Error of forces along a crank, over those across, by the normals of perfect parts: discs that lag
by 1.8 minutes under 1200 MPa had 1.6e-3."""


@dataclass(frozen=True, slots=True)
class RingDeviations:
    """What a ring and its discs deviate from their nominal sizes; empty tuples are zeros.

    Positive: outward, as the output turns, larger, ahead. z_p pins, K discs.
    """

    pin_radial: tuple[float, ...] = ()  # place of each ring pin, m, z_p values
    pin_tangential: tuple[float, ...] = ()  # m, z_p
    pin_radius: tuple[float, ...] = ()  # m, z_p
    eccentricity: tuple[float, ...] = ()  # of each crank, m, K
    crank_phase: tuple[float, ...] = ()  # angle of each crank, rad, K
    disc_phase: tuple[float, ...] = ()  # of each disc's holes against its teeth, rad, K

    def each(self, *, pins: int, satellites: int) -> tuple[list[float], ...]:
        """Its lists, zeros where none are given.

        Parameters
        ----------
        pins, satellites : int
            Numbers z_p and K.

        Returns
        -------
        tuple of list

        Raises
        ------
        InvalidInput
            If a list has another length, or an entry is not finite.
        """
        found = []
        for index, name in enumerate(self.__slots__):
            values, expected = getattr(self, name), pins if index < 3 else satellites
            if values and len(values) != expected:
                counts = {"expected": expected, "actual": len(values)}
                raise InvalidInput(name, values, "different_length", **counts)
            check_finite(**{f"{name}[{i}]": value for i, value in enumerate(values)})
            found.append([float(value) for value in values] or [0.0] * expected)
        return tuple(found)


@dataclass(frozen=True)
class CycloidMesh(Stage):
    """Cycloid discs on a ring of pins, as they are made."""

    disc: CycloidDisc  # all discs
    crank_angles: tuple[float, ...]  # alpha_j of the K discs, rad
    contact_length: float  # b of a disc on a pin, m, > 0
    law: ContactLaw  # of contact of each pair
    pin_material: ElasticMaterial  # of the ring's pins
    disc_material: ElasticMaterial  # of the discs
    pin: Pins = RIGID_PINS  # how ring pins bend; not at all in their seats
    seat_stiffness: float = math.inf  # of a pin in its bore and what holds that, N/m
    deviations: RingDeviations = field(default_factory=RingDeviations)  # of this piece
    exact: bool = True  # geometry; else first order in lag and deviations
    # Given shares of the torque; of rigid satellites all discs have one lag. Nothing else gives.
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
        """The ring's pins and the cranks: the wave of their forces turns with the crank."""
        return Mechanism(self.disc.pins, self.crank_angles, math.inf)

    @property
    def perfect(self) -> "CycloidMesh":
        """The same of perfect rigid parts, contacts linear."""
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
        """E of the cranks, m."""
        return self.disc.eccentricity

    @property
    def dead_angles(self) -> tuple[float, ...]:
        """Angles from the crank at which a pin takes up, leaves, or has its longest lever, rad."""
        longest = math.acos(self.disc.shortening_coefficient)
        return 0.0, math.pi, longest, -longest

    @property
    def pins_alike(self) -> bool:
        """Whether all pins are alike."""
        own = self.deviations
        return not any(map(any, (own.pin_radial, own.pin_tangential, own.pin_radius)))

    @property
    def reference_depth(self) -> float:
        """Depth to which the approach of pin and disc is counted, m: the pin's radius, where the
        law has none.
        """
        radius = self.disc.ring_pin_radius
        return float(self.law.depth(radius) if isinstance(self.law, HertzLaw) else radius)

    @property
    def compliance(self) -> list[float]:
        """Of a ring pin at each disc, m/N: of its seat, and of its bending."""
        seat = 1 / self.seat_stiffness
        return [each + seat for each in self.pin.bending(len(self.crank_angles))]

    @property
    def law_constants(self) -> Law:
        """Constants of the law, of which each pair's are made."""
        return law_constants(
            law=self.law,
            contact_length=self.contact_length,
            hole_radius=self.reference_depth,
            pin=self.pin_material,
            hole=self.disc_material,
        )

    @cached_property
    def drive(self) -> Pieces:
        """The ring and its discs as the engine takes them."""
        self._refuse_no_radius()
        return ring_drive(self)

    def _refuse_no_radius(self) -> None:
        """Refuse pins and cranks without a size."""
        own, count = self.deviations, len(self.crank_angles)
        pins = np.array(own.pin_radius or (0.0,) * self.disc.pins) + self.disc.ring_pin_radius
        cranks = np.array(own.eccentricity or (0.0,) * count) + self.eccentricity
        none = np.minimum(pins, cranks[:, None]) <= 0
        if none.any():
            j, k = divmod(int(none.argmax()), self.disc.pins)
            raise ImpossibleMechanism("no_radius_left", satellite=j + 1, pin=k + 1)

    @property
    def phases(self) -> list[float]:
        """Angles of the cranks with their errors, rad."""
        errors = self.deviations.crank_phase or (0.0,) * len(self.crank_angles)
        return [angle + error for angle, error in zip(self.crank_angles, errors, strict=True)]

    @property
    def pin_radii(self) -> FloatArray:
        """Radius of each pin of the ring, m."""
        errors = self.deviations.pin_radius or (0.0,) * self.disc.pins
        return self.disc.ring_pin_radius + np.array(errors)

    def pressing_at(self, psi: float) -> float:
        """Smallest possible worst approach without load, m; below 0 where pairs are free.

        Parameters
        ----------
        psi : float
            Crank angle, rad.
        """
        return float(self.unloaded(np.array([psi]), least=True)[0, engine.INTERFERENCE])

    def with_thinner_pins(self, closer: float) -> "CycloidMesh":
        """The same with all pins of the ring so much thinner.

        Parameters
        ----------
        closer : float
            By how much, m.

        Returns
        -------
        CycloidMesh
        """
        own = self.deviations
        thinner = tuple(each - closer for each in own.pin_radius or (0.0,) * self.disc.pins)
        return replace(self, deviations=replace(own, pin_radius=thinner))

    def pressure(self, force_over_radius: float) -> float:
        """Largest Hertz pressure by a force over the reduced radius.

        Parameters
        ----------
        force_over_radius : float
            In N/m.

        Returns
        -------
        float
            In Pa.
        """
        modulus = effective_modulus(first=self.pin_material, second=self.disc_material)
        return math.sqrt(force_over_radius * modulus / (math.pi * self.contact_length))

    def notices(self, *, pressed: bool) -> tuple[Notice, ...]:
        """Limits that the mesh strains.

        Parameters
        ----------
        pressed : bool
            Whether pairs press without load.

        Returns
        -------
        tuple of Notice
        """
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


@dataclass(frozen=True, slots=True)
class MeshPosition:
    """A cycloid mesh at one crank angle under load."""

    crank_angle: float  # as asked, rad
    # Lag of each disc's teeth behind their ideal angle, less what its deviations make of it: that
    # of the output, where it is rigid; rad, K values, negative in reverse.
    rotation: tuple[float, ...]
    # Of each pair, N, K x z_p; the larger one of a pin that presses both flanks of a valley.
    force: tuple[tuple[float, ...], ...]
    disc_torque: tuple[float, ...]  # of the forces about each disc's centre, N*m, K values
    crank_across: tuple[float, ...]  # force of the ring on each disc against the crank, N, K values
    crank_along: tuple[float, ...]  # and along it, to the axis, N, K values
    loaded_pairs: int  # number of pairs with a force
    # Least and largest lag without load, rad; None where pairs press without load.
    play: tuple[float, float] | None
    # Smallest possible worst approach of the unloaded pairs, m, where they press.
    interference: float | None
    stiffness: float  # dT/dtheta, N*m/rad
    max_pressure: float  # largest Hertz pressure, Pa
    # Largest distance of a loaded contact from its pitch point, m: times the speed of the output
    # that at which a disc slides on a pin that stands still.
    sliding_distance: float
    sliding_loss: float  # sum of force times that distance over the torque
    accuracy: Accuracy  # of the forces, over the largest
    notices: tuple[Notice, ...]


def mesh_position(*, mesh: CycloidMesh, crank_angle: float, output_torque: float) -> MeshPosition:
    """Forces of all pairs, lag, play and stiffness at one crank angle.

    Parameters
    ----------
    mesh : CycloidMesh
        The mesh.
    crank_angle : float
        Crank angle, rad.
    output_torque : float
        Torque T of all discs, N*m, not 0; negative in reverse.

    Returns
    -------
    MeshPosition

    Raises
    ------
    InvalidInput
        If an input is out of range.
    ImpossibleMechanism
        See `Stage.solved`.

    Notes
    -----
    Left out: friction, speed, tilting and edge load, deformation of discs and ring, clearance and
    compliance of the crank's bearings, errors of single lobes.

    Examples
    --------
    Perfect rigid parts of 29 lobes, a force of the ring of 1600 N across the crank:

    >>> from core.output.elasticity import LinearLaw
    >>> disc = CycloidDisc(satellite_teeth=29, eccentricity=1.250025e-3,
    ...                    ring_pin_circle_radius=0.0525, ring_pin_radius=3.5e-3)
    >>> steel = ElasticMaterial(210e9, 0.3)
    >>> mesh = CycloidMesh(disc=disc, crank_angles=(0.0,), contact_length=0.0135,
    ...                    law=LinearLaw(1e8), exact=False,
    ...     pin_material=steel, disc_material=steel)
    >>> found = mesh_position(mesh=mesh, crank_angle=0.0, output_torque=58.0)
    >>> round(found.crank_across[0], 6), round(max(found.force[0]), 6)
    (1599.968001, 212.944548)
    """
    check_single(crank_angle=crank_angle, output_torque=output_torque)
    check_finite(crank_angle=crank_angle, output_torque=output_torque)
    if output_torque == 0:
        raise InvalidInput("output_torque", output_torque, "not_zero")
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
    """Gaps of all pairs where the discs lag by so much: negative where they press.

    Parameters
    ----------
    mesh : CycloidMesh
        The mesh.
    crank_angle : float
        Crank angle, rad.
    rotation : tuple of float, K, optional
        Lag of each disc, rad, negative in reverse; none where it is not given.

    Returns
    -------
    tuple of tuple of float, K x z_p
        In m.

    Examples
    --------
    >>> from core.output.elasticity import LinearLaw
    >>> from core.ring.profile import Modification
    >>> disc = CycloidDisc(satellite_teeth=11, eccentricity=2.5e-3,
    ...                    ring_pin_circle_radius=0.05, ring_pin_radius=0.005,
    ...                    modification=Modification(equidistant=2e-5))
    >>> steel = ElasticMaterial(210e9, 0.3)
    >>> mesh = CycloidMesh(disc=disc, crank_angles=(0.0,), contact_length=0.01,
    ...                    law=LinearLaw(1e8),
    ...     pin_material=steel, disc_material=steel)
    >>> {round(gap, 12) for row in mesh_gaps(mesh=mesh, crank_angle=0.3) for gap in row}
    {2e-05}
    """
    check_single(crank_angle=crank_angle)
    count = len(mesh.crank_angles)
    room = Solved.of(replace(mesh, support=Shares((1 / count,) * count)).drive)
    found = np.zeros(len(room.work.w))
    lags = np.array(rotation or (0.0,) * count, float)
    engine.gaps(mesh.wave(crank_angle), lags, room.drive, room.work, found)
    return mesh.rows((-found[room.contacts(engine.LOBE)]).tolist())


class MeshTurn(OverTurn):
    """Extremes of a cycloid mesh over the turn of the crank, each looked for when it is asked for.

    Parameters
    ----------
    turn : Turn
        The mesh under a torque.
    """

    @property
    def mesh(self) -> CycloidMesh:
        """The mesh."""
        found: CycloidMesh = self.turn.real
        return found

    @property
    def max_pressure(self) -> float:
        """Largest Hertz pressure over the turn, Pa."""
        return self.mesh.pressure(self._pressed.height)

    @derived
    def hardest_place(self) -> tuple[PairNumber, float]:
        """The pair with that pressure, and the crank angle at which it has it, rad."""
        place, turn = self._pressed.place, self.turn
        room = self.mesh.solved([place], turn.torque)
        pairs = room.contacts(engine.LOBE)
        pressed = room.forces[0, pairs] * room.work.w[pairs, engine.BENT]
        satellite, pin = divmod(int(pressed.argmax()), self.mesh.disc.pins)
        return PairNumber(satellite + 1, pin + 1), place % self._period

    @property
    def _period(self) -> float:
        """Of the crank angles that are answered, rad."""
        return 2 * math.pi

    def forces_at(self, crank_angle: float) -> FloatArray:
        """Forces of all pairs at a crank angle, N.

        Parameters
        ----------
        crank_angle : float
            The angle, rad.

        Returns
        -------
        array, shape (K, z_p)
        """
        forces: FloatArray = self.turn.poses([crank_angle])["forces"]
        return forces.reshape(-1, self.mesh.disc.pins)

    @property
    def play_in_ring(self) -> float:
        """Largest play of the unloaded discs in the ring, rad."""
        return self.backlash_max

    @derived
    def interference(self) -> float:
        """Largest over the turn of the smallest possible worst approach without load, m; 0 where no
        pairs press anywhere.
        """
        if not self.pressed_without_load:
            return 0.0
        wave = self.turn.fine["wave"]
        apart = math.ceil(len(wave) / LOOKED_PRESSING)

        def pressing(places: IntArray) -> FloatArray:
            found: FloatArray = self.mesh.unloaded(wave[places], least=True)[:, engine.INTERFERENCE]
            return found

        coarse = np.arange(0, len(wave), apart)
        top = coarse[pressing(coarse).argmax()]
        near = np.arange(top - apart, top + apart + 1) % len(wave)
        return max(float(pressing(near).max()), 0.0)

    @property
    def peak_force_ratio(self) -> float:
        """Largest force over that of perfect parts."""
        return self.peak_force / self.ideal.peak_force

    @property
    def ideal(self) -> "IdealMesh":
        """The mesh of perfect parts under the same torque."""
        torque = abs(self.turn.torque) / len(self.mesh.crank_angles)
        return ideal_mesh(disc=self.mesh.disc, disc_torque=torque)

    @property
    def lag_max(self) -> float:
        """Largest lag, rad; negative in reverse."""
        high, low = self.lags
        return high if self.turn.torque > 0 else -low

    @property
    def lag_min(self) -> float:
        """Least lag, rad."""
        high, low = self.lags
        return low if self.turn.torque > 0 else -high

    @property
    def _across(self) -> float:
        """Force across the crank of a disc that carries its part, N."""
        disc = self.mesh.disc
        each = abs(self.turn.torque) / len(self.mesh.crank_angles)
        return each / (disc.eccentricity * disc.satellite_teeth)

    @derived
    def radial_force_ratio_max(self) -> float:
        """Largest force of a disc along its crank, to the axis, over that across the crank of one
        that carries its part.
        """
        return self._by_values(engine.ALONG_MOST) / self._across

    @derived
    def radial_force_ratio_min(self) -> float:
        """Least of the same."""
        return self._by_values(engine.ALONG_LEAST, -1) / self._across

    @property
    def samples(self) -> tuple[FloatArray, FloatArray]:
        """Crank angles of positions, rad, and the forces of all pairs there, N."""
        return self.turn.fine["wave"], self.turn.fine["forces"]

    @property
    def close(self) -> CloseSamples:
        """Forces of all pairs, sampled as closely as they need."""
        return close_samples(self.turn)

    @property
    def even(self) -> IntArray:
        """Which of these are evenly spaced."""
        places, _ = self.turn.positions()
        return np.searchsorted(self.turn.fine["wave"], places)

    @property
    def _even_forces(self) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Forces of all pairs where these are even, N, the angles of the pins from the cranks, rad,
        and the distances to the pitch points over the radius of the pins' circle, shape (M, pairs).
        """
        (wave, force), there, disc = self.samples, self.even, self.mesh.disc
        phases = np.array(self.mesh.phases)
        ring = 2 * np.pi * np.arange(disc.pins) / disc.pins
        angle = wave[there, None] + (phases[:, None] + ring).ravel()
        k = disc.shortening_coefficient
        return force[there], angle, np.sqrt((1 - k) ** 2 + 4 * k * np.sin(angle / 2) ** 2)

    @property
    def mean_radial_force_ratio(self) -> float:
        """Mean over the turn of the forces of all discs along their cranks, over that of those
        across them, by the normals of perfect parts.
        """
        force, angle, slope = self._even_forces
        along = (force * (np.cos(angle) - self.mesh.disc.shortening_coefficient) / slope).sum(1)
        across = abs((force * np.sin(angle) / slope).sum(1).mean())
        return float(along.mean() / across)

    @derived
    def sliding_loss(self) -> float:
        """Mean over the turn of the sum of force times distance to the pitch point, over the
        torque: the loss over the output for a friction coefficient of 1.
        """
        (force, _, slope), disc = self._even_forces, self.mesh.disc
        far = np.abs(disc.ring_pin_circle_radius * slope - disc.ring_pin_radius)
        return float((force * far).sum(axis=1).mean()) / abs(self.turn.torque)

    @derived
    def hardest_rub(self) -> float:
        """Largest product over the turn of force and distance to the pitch point, N*m."""
        return self._by_values(engine.RUB)

    @derived
    def hardest_pressed_rub(self) -> float:
        """Largest product of Hertz pressure and that distance, Pa*m."""
        return self.mesh.pressure(1.0) * self._by_values(engine.RUB_PRESSED)

    @property
    def notices(self) -> tuple[Notice, ...]:
        """What to know besides."""
        own = self.mesh.notices(pressed=self.pressed_without_load)
        return (*own, *poorly_known(self.accuracy))


def mesh_over_turn(
    *, mesh: CycloidMesh, output_torque: float, lost_motion_share: float = 0.03
) -> MeshTurn:
    """Peak force, backlash, lost motion, transmission error and stiffness over the turn.

    Parameters
    ----------
    mesh : CycloidMesh
        The mesh.
    output_torque : float
        Torque T of all discs, N*m, not 0; negative in reverse.
    lost_motion_share : float
        Share of the torque under which the lost motion is taken, 0 < share <= 1.

    Returns
    -------
    MeshTurn

    Raises
    ------
    InvalidInput
        If an input is out of range.
    ImpossibleMechanism
        Where a position cannot be, see `mesh_position`.

    Examples
    --------
    >>> from core.output.elasticity import LinearLaw
    >>> from core.ring.profile import Modification
    >>> disc = CycloidDisc(satellite_teeth=18, eccentricity=1.5e-3,
    ...                    ring_pin_circle_radius=0.034, ring_pin_radius=2.5e-3,
    ...                    modification=Modification(equidistant=1e-5))
    >>> steel = ElasticMaterial(210e9, 0.3)
    >>> mesh = CycloidMesh(disc=disc, crank_angles=(0.0,), contact_length=0.01,
    ...                    law=LinearLaw(5e7), exact=False,
    ...     pin_material=steel, disc_material=steel)
    >>> round(mesh_over_turn(mesh=mesh, output_torque=30.0).peak_force, 5)
    333.54715
    """
    check_single(output_torque=output_torque, lost_motion_share=lost_motion_share)
    check_finite(output_torque=output_torque)
    if output_torque == 0:
        raise InvalidInput("output_torque", output_torque, "not_zero")
    if not 0 < lost_motion_share <= 1:
        code, limit = ("greater_than", 0) if lost_motion_share <= 0 else ("less_than_equal", 1)
        raise InvalidInput("lost_motion_share", lost_motion_share, code, limit=limit)
    found = MeshTurn(Turn(mesh, output_torque, lost_motion_share))
    assert found.turn.coarse  # refuses what cannot be
    return found


@dataclass(frozen=True, slots=True)
class IdealMesh:
    """A disc of perfect parts on many pins, contacts linear."""

    peak_force: float  # largest force of a pin, N
    mean_sum_force: float  # sum of the forces on a disc, mean over the turn, N
    # Play by the modification alone, rad; None where it jams.
    backlash: float | None


def ideal_mesh(*, disc: CycloidDisc, disc_torque: float) -> IdealMesh:
    """Forces and backlash in closed form, for many pins.

    Parameters
    ----------
    disc : CycloidDisc
        The disc.
    disc_torque : float
        Torque of one disc, N*m, >= 0.

    Returns
    -------
    IdealMesh

    Notes
    -----
    The sum of the squares of the levers' sines over the slopes is z_p/4 for any K1, and the largest
    lever is ``e*z``, at ``cos(a) = K1``: ``F_max = 4*T/(e*z*z_p)``, ``sum F = 4*T/(pi*e*z)``. The
    backlash is the least of ``2*g/|h|`` over the angles. Derived.

    Examples
    --------
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
    """Backlash of discs whose modification leaves gaps; None where it makes pins press."""
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
