"""Load and life of the bearing of each satellite on its crank.

All forces of the pins on a satellite act along its crank, towards the axis of the reducer: together
they are ``S = sum F`` through the satellite's centre and the couple ``T_j = R*sum F*cos(gamma)``.
The ring takes the couple: the part of its force across the crank is ``W = T_j/(e*u)``, as every
normal of the teeth passes the pitch point, and the part along the crank is ``rho*W``, in the
direction of S for involute teeth and opposite to S for a cycloid ring. In the crank's frame the
load of the bearing

    Q = hypot(W, rho*W + S - m*e*w_in^2)

stands still except for a ripple; the centrifugal force of the satellite relieves the bearing, where
the mass is known.
"""

import math
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import cache, partial

import numpy as np

from core.arrays import (
    ComplexArray,
    FloatArray,
    Number,
    check_not_negative,
    check_positive,
    every,
)
from core.crank.bearing_life import (
    EXPONENTS,
    Bearing,
    rating_life,
    reliability_factor,
    system_life,
)
from core.crank.ring_mesh import RingMesh
from core.errors import Accuracy, Notice, NotKnown, derived, is_known, poorly_known, required
from core.fields import answer, answered
from core.output.contact_force import force_ratios
from core.output.ideal_turn import ideal_turn
from core.output.mechanism import Mechanism, pressure_cosines
from core.output.pin_circle_load import PinCircleLoad
from core.output.sampled_turn import WAYS, Direction, SampledTurn
from core.precision import ROUNDING, SEARCHED


@dataclass(frozen=True, kw_only=True)
class SatelliteBearings:
    """Load and life of the satellites' bearings; the last axis of arrays counts the K satellites.

    Results that need a rating, a speed or a slope raise `NotKnown` without it.
    """

    given_speed: Number | None  # speed of a bearing's rings against each other, rad/s
    mesh: RingMesh  # the ring's force along the crank
    radial_force_ratio: Number = answer("", "ρ")
    """Force of the ring along the crank over that across it; positive towards the axis."""
    peak_load: FloatArray = answer("N", "Q_max", depth=0)
    """Largest load over the turn."""
    min_load: FloatArray = answer("N", "Q_min", depth=0)
    """Least load over the turn."""
    equivalent_load: FloatArray = answer("N", "P", depth=0)
    """Equivalent load, V·⟨Qᵖ⟩^(1/p)."""
    lesser_load: FloatArray  # P with the smaller share of the torque, N, shape (..., K)
    peak_ring_force: FloatArray = answer("N", "F_r", depth=0)
    """Largest resultant of the ring's forces on the satellite, W·√(1 + ρ²)."""
    static_loads: Callable[[], FloatArray]  # largest at the peak torque, N, shape (..., K)
    kind: Bearing  # rolling elements
    dynamic_rating: Number | None  # C, N
    static_rating: Number | None  # C0, N
    reliability_percent: float  # required reliability
    weibull_slope: Number | None  # slope beta of the distribution of lives
    load_accuracy: Accuracy  # accuracy of loads over those of the most loaded satellite
    notices: tuple[Notice, ...] = answer()  # of the ring, idle satellites and poorly known results

    @property
    @answered("deg", "α_w", optional=True)
    def operating_pressure_angle(self) -> Number:
        """Operating pressure angle of involute teeth."""
        return self.mesh.operating_pressure_angle

    @property
    @answered("rpm", "n")
    def relative_speed(self) -> Number:
        """Speed of a bearing's inner ring relative to its outer ring, n₁·(1 + 1/u)."""
        return required(self.given_speed, "speed_missing", "load.input_speed")

    @property
    def _turning(self) -> FloatArray:
        """Time of a million turns, s, shape (..., 1)."""
        if not every(self.relative_speed > 0):
            raise NotKnown("members_locked")
        return 1e6 * 2 * math.pi / np.asarray(self.relative_speed)[..., None]

    def _turns(self, load: FloatArray) -> FloatArray:
        """Lives under equivalent loads, in millions of turns."""
        rating = required(self.dynamic_rating, "rating_unknown", "bearing.dynamic_rating")
        return _lives(load, rating=rating, kind=self.kind)

    @derived
    @answered("h", "L_10h", optional=True, depth=0)
    def basic_life(self) -> FloatArray:
        """Life that 90 % of such bearings reach, (C/P)ᵖ million turns."""
        turns = self._turns(self.equivalent_load)
        return self._turning * turns

    @derived
    @answered("h", "L_nh", optional=True, depth=0)
    def life(self) -> FloatArray:
        """Life at the requested reliability."""
        return reliability_factor(percent=self.reliability_percent) * self.basic_life

    @derived
    @answered("", "S₀", optional=True, depth=0)
    def static_safety_factor(self) -> FloatArray:
        """Static load rating over the largest load at the peak torque."""
        given = required(self.static_rating, "rating_unknown", "bearing.static_rating")
        check_positive(static_rating=given)
        static, rating = self.static_loads(), np.asarray(given, dtype=np.float64)[..., None]
        return np.where(static > 0, rating / np.where(static > 0, static, rating), math.inf)

    @derived
    @answered("h", "L_s", optional=True)
    def system_life(self) -> Number:
        """Life that such reducers reach at the requested reliability without a failure of any
        satellite bearing, if the Weibull slope is given.
        """
        life = self.life  # comes first, so that a life that is not known gives its own reason
        slope = required(self.weibull_slope, "rating_unknown", "bearing.weibull_slope")
        factor = reliability_factor(percent=self.reliability_percent)
        return _together(life, factor * self._turning * self._turns(self.lesser_load), slope)

    @derived
    @answered()
    def accuracy(self) -> Accuracy:
        """Accuracy of all numbers over those of the most loaded satellite; lives multiply the error
        of the loads by their exponent.
        """
        error = self.load_accuracy.relative_error
        if is_known(lambda: self.life):
            error *= EXPONENTS[self.kind]
        return self.load_accuracy._replace(relative_error=error + 8 * ROUNDING)


def satellite_bearings(
    *,
    load: PinCircleLoad[SampledTurn],
    eccentricity: Number,
    mesh: RingMesh,
    input_speed: Number | None = None,
    distribution_factor: float = 1.0,
    centrifugal: Number = 0.0,
    kind: Bearing,
    dynamic_rating: Number | None = None,
    static_rating: Number | None = None,
    reliability_percent: float = 90.0,
    ring_factor: Number = 1.0,
    weibull_slope: Number | None = None,
) -> SatelliteBearings:
    """Load and life of the satellites' bearings under the forces of the pins.

    The inner ring turns at ``w_in*(1 + 1/u)`` against the outer one, and the load stands still
    against the crank: ``P = V*<Q^p>^(1/p)`` over the turn of the wave, ``L10 = (C/P)^p`` (ISO
    281:2007). Source of the forces: Yanchevskiy and Niekhoroshykh 2021, eq. (10).
    `ImpossibleMechanism` is raised at a dead centre.

    The load is without an application factor, and of one design if forces are those as made. The
    speed w_in of the crank against the ring is in rad/s; without it, or at 0, there is no life.
    Every bearing is judged as the one that carries K_alpha/K of the torque by the load-sharing
    factor K_alpha of ideal forces, from 1 to K; the least load is that of another, and the life of
    all together that of the worst choice. The static safety, under the peak torque, is the smaller
    one with the centrifugal force ``m*e*w_in^2`` of a satellite with its bearing, N, and at rest.
    The factor V, > 0, is for the ring that turns against the load, the Weibull slope for the life
    of all bearings together.

    Six pins, two satellites, 500 N*m at 1500 rpm of the crank, involute teeth.

    >>> six = Mechanism.evenly_spaced(pins=6, satellites=2, ratio=20.0)
    >>> found = satellite_bearings(
    ...     load=PinCircleLoad(mechanism=six, output_torque=500.0, pin_circle_radius=0.05),
    ...     eccentricity=2e-3, mesh=RingMesh(math.tan(math.radians(34.6912426))), kind="ball",
    ...     input_speed=50*math.pi)
    >>> [round(float(each[0]), 2)
    ...  for each in (found.min_load, found.peak_load, found.equivalent_load)]
    [11877.22, 12645.46, 12390.15]
    """
    check_positive(eccentricity=eccentricity, ring_factor=ring_factor)
    check_not_negative(centrifugal=centrifugal)
    relative_speed = None
    if input_speed is not None:
        check_not_negative(input_speed=input_speed)
        relative_speed = input_speed * load.mechanism.waves_per_turn
    reliability_factor(percent=reliability_percent)  # refuses what is not in the table
    satellites = _Satellites(load, eccentricity * load.mechanism.ratio, mesh, EXPONENTS[kind])
    most, count = distribution_factor, load.mechanism.satellites
    rest = uneven_shares(satellites=count, distribution_factor=most).min()
    loads = others = satellites.loads(most * load.output_torque, centrifugal)
    if rest < most:
        others = satellites.loads(rest * load.output_torque, centrifugal)
    carried = (loads.most > 0).reshape(-1, count).all(axis=0)
    idle = (np.flatnonzero(~carried) + 1).tolist()
    factor = np.asarray(ring_factor)[..., None]
    static: Callable[[], FloatArray]
    static = cache(partial(satellites.largest, most * load.static_torque, centrifugal))
    if load.made is None and not np.any(centrifugal):  # in proportion to the torque
        more = np.asarray(load.static_torque / load.output_torque)[..., None]
        static = partial(np.multiply, more, loads.most)
    found = SatelliteBearings(
        given_speed=relative_speed,
        mesh=mesh,
        radial_force_ratio=loads.ratio,
        peak_load=loads.most,
        min_load=others.least,
        equivalent_load=factor * loads.mean,
        lesser_load=factor * others.mean,
        peak_ring_force=loads.ring,
        static_loads=static,
        kind=kind,
        dynamic_rating=dynamic_rating,
        static_rating=static_rating,
        reliability_percent=reliability_percent,
        weibull_slope=weibull_slope,
        load_accuracy=loads.accuracy,
        notices=(*mesh.notices, *(Notice("satellite_idle", {"satellite": j}) for j in idle)),
    )
    for name in ("life", "system_life", "static_safety_factor"):
        with suppress(NotKnown):
            getattr(found, name)  # refuses what is out of range
    return replace(found, notices=(*found.notices, *poorly_known(found.accuracy)))


def uneven_shares(*, satellites: int, distribution_factor: float) -> FloatArray:
    """Shares of the torque over 1/K: K_alpha of one satellite, ``(K - K_alpha)/(K - 1)`` of others.

    Shape (K, K) with a row for each choice of the satellite, or (1, K) of ones for K_alpha = 1.

    >>> uneven_shares(satellites=3, distribution_factor=2.0)[0].tolist()
    [2.0, 0.5, 0.5]
    """
    if distribution_factor == 1:
        return np.ones((1, satellites))
    rest = (satellites - distribution_factor) / (satellites - 1)
    return np.where(np.eye(satellites, dtype=bool), distribution_factor, rest)


def _lives(load: FloatArray, *, rating: Number, kind: Bearing) -> FloatArray:
    """Lives in millions of turns; infinite without a load."""
    capacity = np.asarray(rating, dtype=np.float64)[..., None]
    carrying = load > 0
    some = np.where(carrying, load, capacity)
    lives = rating_life(load=some, rating=capacity, kind=kind)
    found: FloatArray = np.where(carrying, lives, math.inf)
    return found


def _together(life: FloatArray, others: FloatArray, weibull_slope: Number) -> Number:
    """Life of all bearings together for the worst choice of the most loaded one; `life` and
    `others` are the lives of each bearing as the most loaded one and as another.
    """
    one = np.eye(life.shape[-1], dtype=bool)
    lives = np.where(one, life[..., None, :], others[..., None, :])
    slope = np.asarray(weibull_slope)[..., None]
    found: FloatArray = np.asarray(system_life(lives=lives, weibull_slope=slope))
    return found.min(axis=-1)


@dataclass(frozen=True, slots=True)
class _Loads:
    """Loads of each satellite's bearing, largest ring force, N, and ratio rho of that force."""

    most: FloatArray
    least: FloatArray
    mean: FloatArray
    ring: FloatArray
    ratio: Number
    accuracy: Accuracy


@dataclass(frozen=True)
class _Satellites:
    """Satellites under the forces of pins and ring, whose bearings they load."""

    load: PinCircleLoad[SampledTurn]
    arm: Number  # lever e*u of the ring's force about the satellite's centre, m
    mesh: RingMesh
    exponent: float  # exponent p of the life

    def loads(self, torque: Number, centrifugal: Number) -> _Loads:
        """Loads under a torque, N*m, in the worse direction, with a centrifugal force, N."""
        if self.load.made is None:
            return self._ideal(torque, centrifugal)
        return self._made(self.load.turns(torque), centrifugal)

    def largest(self, torque: Number, centrifugal: Number) -> FloatArray:
        """Largest loads under a torque, N*m, with a centrifugal force, N, and at rest."""
        found = self.loads(torque, 0.0).most
        if np.any(centrifugal):
            found = np.maximum(found, self.loads(torque, centrifugal).most)
        return found

    def _ideal(self, torque: Number, centrifugal: Number) -> _Loads:
        """Loads under the ideal forces, for all designs."""
        load, ratio = self.load, self.mesh.radial_force_ratio
        turn = ideal_turn(
            1.0,
            mechanism=load.mechanism,
            force_exponent=load.force_exponent,
            pin_circle_radius=1.0,
        )
        columns: list[Number] = [
            np.asarray(each, dtype=np.float64)[..., None, None]
            for each in (torque / self.arm, self.arm / load.pin_circle_radius, ratio, centrifugal)
        ]
        across, along, rho, relief = columns
        rings = across * (rho + 1j) * turn.couple
        held = rings + across * along * turn.on_satellites.real - relief
        off = self.mesh.error * max(1.0, float(np.abs(rho).max()))  # over W, at most the load
        return _loads([(turn, held, rings)], [turn.error + SEARCHED + off], ratio, self.exponent)

    def _made(self, turns: list[SampledTurn], centrifugal: float) -> _Loads:
        """Loads under the forces of the mechanism as made, in the worse direction."""
        forces, errors, ratios = [], [], []
        for turn in turns:
            rho = float(self.mesh.radial_force_ratio)
            parts = made_parts(turn=turn, arm=self.arm, radial_force_ratio=rho)
            given = self.mesh.error * max(1.0, abs(parts.ratio))
            held = parts.load - centrifugal
            forces.append((turn, held, parts.ring))
            missed = turn.missed(held) / np.abs(held).max()
            errors.append(missed + turn.error + (0.0 if parts.solved else given))
            ratios.append(parts.ratio)
        return _loads(forces, errors, max(ratios, key=abs), self.exponent)


def _loads(
    forces: list[tuple[SampledTurn, ComplexArray, ComplexArray]],
    errors: list[float],
    ratio: Number,
    exponent: float,
) -> _Loads:
    """Loads by the forces on each bearing and of the ring in each direction, shape (..., K, n);
    loads within their error are 0.
    """
    rows = []
    for turn, held, ring in forces:
        load = np.abs(held)
        mean = turn.mean(load**exponent) ** (1 / exponent)
        rows.append((turn.largest(load), turn.largest(-load), mean, turn.largest(np.abs(ring))))
    most, least, mean, ring = np.maximum.reduce([np.array(each) for each in rows])
    error = max(errors)
    carrying = most > error * most.max(axis=-1, keepdims=True)
    evaluations = sum(turn.evaluations for turn, *_ in forces)
    return _Loads(
        most=np.where(carrying, most, 0.0),
        least=np.where(carrying, np.abs(least), 0.0),
        mean=np.where(carrying, mean, 0.0),
        ring=np.where(carrying, ring, 0.0),
        ratio=ratio,
        accuracy=Accuracy("sampling", error, evaluations),
    )


@dataclass(frozen=True, slots=True)
class MadeParts:
    """Forces on the satellites of a mechanism as made, N, in the frame of each crank."""

    # Force of pins and ring, shape (K, n): real part along the crank towards the axis, imaginary
    # part across it, against the rotation of the crank under a driving torque.
    load: ComplexArray
    ring: ComplexArray  # force of the ring alone, shape (K, n)
    ratio: float  # ring's force along the cranks over that across; the mean if `solved`
    solved: bool = False  # True if the mesh of the ring is solved; else the ratio is the given one


def made_parts(*, turn: SampledTurn, arm: float, radial_force_ratio: float) -> MadeParts:
    """Forces on the satellites of a mechanism as made, by the forces of the pins over a turn.

    The ring's force has the lever ``arm = e*u`` about the satellite's centre, m. Along the crank it
    is rho times the size of that across it, as teeth press apart on either flank, unless the mesh
    of the ring is solved.
    """
    if turn.of_ring is not None:
        along, turned = (turn.mean(each).sum() for each in (turn.of_ring.real, turn.of_ring.imag))
        ratio = float(along / abs(turned))
        return MadeParts(turn.on_satellites + turn.of_ring, turn.of_ring, ratio, solved=True)
    across = turn.couple / arm
    ring = radial_force_ratio * np.abs(across) + 1j * across
    return MadeParts(turn.on_satellites + ring, ring, radial_force_ratio)


@dataclass(frozen=True, slots=True)
class BearingCurves:
    """Loads of the satellites' bearings over the crank angle, in the crank's frame."""

    crank_angle: FloatArray  # rad, shape (n,)
    across: FloatArray  # part across the crank, N, shape (n, K)
    along: FloatArray  # part along the crank towards the reducer's axis, N, shape (n, K)
    load: FloatArray  # resultant of both parts, N, shape (n, K)


def bearing_curves(
    *,
    mechanism: Mechanism,
    force_exponent: float = 1.0,
    output_torque: float,
    pin_circle_radius: float,
    eccentricity: float,
    radial_force_ratio: float,
    crank_angle: FloatArray,
    torque_direction: Direction = "driving",
) -> BearingCurves:
    """Loads of the satellites' bearings under the ideal forces at crank angles, rad, shape (n,).

    Parameters are as in `satellite_bearings`; an alternating torque is shown as driving. The part
    across the crank is negative in reverse.
    """
    way = WAYS[torque_direction][0]
    if way < 0:  # in reverse the other pairs carry, which drive half a turn of the wave later
        start = mechanism.initial_crank_angle + math.pi
        mechanism = replace(mechanism, initial_crank_angle=start)
    ratios = force_ratios(
        mechanism=mechanism, crank_angles=crank_angle, force_exponent=force_exponent
    )
    cosines = pressure_cosines(mechanism=mechanism, crank_angles=crank_angle)
    across = output_torque / (eccentricity * mechanism.ratio) * (ratios * cosines).sum(axis=2)
    pins = output_torque / pin_circle_radius * ratios.sum(axis=2)
    along = radial_force_ratio * across + pins
    return BearingCurves(crank_angle, way * across, along, np.hypot(across, along))
