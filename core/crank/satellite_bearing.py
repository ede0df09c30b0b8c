"""Load and life of the bearing of each satellite on its crank.

All forces of the pins on a satellite act along its crank, towards the axis of the reducer: together
they are ``S = sum F`` through its centre, besides the couple ``T_j = R*sum F*cos(gamma)``. The ring
takes the couple: its force has the part ``W = T_j/(e*u)`` across the crank, as every normal of its
teeth passes the pitch point, and a part ``rho*W`` along it. With involute teeth that part has the
direction of S, with a cycloid ring the opposite one. In the crank's frame the load stands still but
for its ripple:

    Q = hypot(W, rho*W + S - m*e*w_in^2)

with the centrifugal force of the satellite, which relieves its bearing, where its mass is known.
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
    check_single,
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
from core.output.contact_force import force_ratios
from core.output.ideal_turn import ideal_turn
from core.output.mechanism import Mechanism, pressure_cosines
from core.output.sampled_turn import WAYS, Direction, Made, SampledTurn
from core.precision import ROUNDING, SEARCHED


@dataclass(frozen=True)
class SatelliteBearings:
    """Load and life of the satellites' bearings; the last axis counts the satellites. What rests on
    a rating, a speed or a slope that is not given raises `NotKnown`.
    """

    given_speed: Number | None  # of a bearing's rings against each other, rad/s
    mesh: RingMesh  # the ring's force along the crank
    # rho of the ring's force along the crank to that across it; its mean where that is solved.
    radial_force_ratio: Number
    peak_load: FloatArray  # largest over the turn, N, shape (..., K)
    min_load: FloatArray  # least, of a satellite that carries least, N, shape (..., K)
    equivalent_load: FloatArray  # P, the factor of the rings in it, N, shape (..., K)
    lesser_load: FloatArray  # the same of one that does not carry most, N, shape (..., K)
    peak_ring_force: FloatArray  # largest resultant of the ring on each, N, shape (..., K)
    static_loads: Callable[[], FloatArray]  # largest at the peak torque, N, shape (..., K)
    kind: Bearing  # rolling elements
    dynamic_rating: Number | None  # C, N
    static_rating: Number | None  # C0, N
    reliability_percent: float  # at which lives are asked
    weibull_slope: Number | None  # of the distribution of lives
    load_accuracy: Accuracy  # of the loads, over those of the satellite that carries most
    # Of the ring, of satellites that carry nothing, and of what is hardly known.
    notices: tuple[Notice, ...]

    @property
    def operating_pressure_angle(self) -> Number:
        """alpha_w of involute teeth, rad."""
        return self.mesh.operating_pressure_angle

    @property
    def relative_speed(self) -> Number:
        """Speed of a bearing's rings against each other, rad/s."""
        return required(self.given_speed, "speed_missing", "load.input_speed")

    @property
    def _turning(self) -> FloatArray:
        """Time of a million turns, s, shape (..., 1)."""
        if not every(self.relative_speed > 0):
            raise NotKnown("members_locked")
        return 1e6 * 2 * math.pi / np.asarray(self.relative_speed)[..., None]

    def _turns(self, load: FloatArray) -> FloatArray:
        """Lives under equivalent loads, in million turns."""
        rating = required(self.dynamic_rating, "rating_unknown", "bearing.dynamic_rating")
        return _lives(load, rating=rating, kind=self.kind)

    @derived
    def basic_life(self) -> FloatArray:
        """Time that 90 % of such bearings reach, s, shape (..., K); infinite of a satellite that
        carries nothing.
        """
        turns = self._turns(self.equivalent_load)
        return self._turning * turns

    @derived
    def life(self) -> FloatArray:
        """The same at the reliability asked, s, shape (..., K)."""
        return reliability_factor(percent=self.reliability_percent) * self.basic_life

    @derived
    def static_safety_factor(self) -> FloatArray:
        """Static rating over the largest load, shape (..., K); infinite likewise."""
        given = required(self.static_rating, "rating_unknown", "bearing.static_rating")
        check_positive(static_rating=given)
        static, rating = self.static_loads(), np.asarray(given, dtype=np.float64)[..., None]
        return np.where(static > 0, rating / np.where(static > 0, static, rating), math.inf)

    @derived
    def system_life(self) -> Number:
        """Life of all of them together at that reliability, s, shape (...)."""
        life = self.life  # without it its own reason counts
        slope = required(self.weibull_slope, "rating_unknown", "bearing.weibull_slope")
        factor = reliability_factor(percent=self.reliability_percent)
        return _together(life, factor * self._turning * self._turns(self.lesser_load), slope)

    @derived
    def accuracy(self) -> Accuracy:
        """Of all numbers, over those of the satellite that carries most; where there are lives, the
        error of the loads times their exponent.
        """
        error = self.load_accuracy.relative_error
        if is_known(lambda: self.life):
            error *= EXPONENTS[self.kind]
        return self.load_accuracy._replace(relative_error=error + 8 * ROUNDING)


def satellite_bearings(
    *,
    mechanism: Mechanism,
    force_exponent: float = 1.0,
    output_torque: Number,
    pin_circle_radius: Number,
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
    peak_torque: Number | None = None,
    torque_direction: Direction = "driving",
    made: Made | None = None,
) -> SatelliteBearings:
    """Load and life of the satellites' bearings under the forces of the pins.

    The forces are the ideal ones, shared equally by the satellites; with `made` those of the
    mechanism as it is made. The inner ring turns at ``w_in*(1 + 1/u)`` against the outer one,
    and the load stands still against the crank: ``P = V*<Q^p>^(1/p)`` over the turn of the wave,
    ``L10 = (C/P)^p``.

    Parameters
    ----------
    mechanism : Mechanism
        Pins, satellites, ratio.
    force_exponent : float
        Exponent v of the force over the approach.
    output_torque : float or array
        Torque T on the output link, N*m, > 0.
    pin_circle_radius : float or array
        Radius R of the circle of pin centres, m, > 0.
    eccentricity : float or array
        Eccentricity e of the cranks, m, > 0.
    mesh : RingMesh
        The ring's force along the crank.
    input_speed : float or array, optional
        Speed w_in of the crank against the ring, rad/s; without it, or at 0, there is no life.
    distribution_factor : float
        Factor K_alpha of one satellite's share, from 1 to K, where that is stated: every bearing is
        judged as the one that carries K_alpha/K of the torque, the least load as one of the others,
        and together they last as with the worst choice of that one. Of ideal forces.
    centrifugal : float or array
        Centrifugal force ``m*e*w_in^2`` of a satellite with its bearing, N, >= 0. The static safety
        is the least with it and at rest.
    kind : {"ball", "roller"}
        Rolling elements.
    dynamic_rating, static_rating : float or array, optional
        Basic load ratings C and C0, N, > 0.
    reliability_percent : float
        90, 95, 96, 97, 98 or 99.
    ring_factor : float or array
        Factor V of the load for the ring that turns against it, > 0.
    weibull_slope : float or array, optional
        Slope of the distribution of lives, for the life of all of them together.
    peak_torque : float or array, optional
        Torque of the static safety, N*m, > 0; T where not given. The life takes T as it is, without
        an application factor.
    torque_direction : {"driving", "reverse", "alternating"}
        Of both directions the worse counts. Ideal forces load the bearings alike in both.
    made : callable, optional
        Forces of the mechanism as it is made, see `core.output.real_turn.sampled`; of one design.

    Returns
    -------
    SatelliteBearings

    Raises
    ------
    InvalidInput
        If a size is out of range.
    ImpossibleMechanism
        If the mechanism has a dead centre.

    Notes
    -----
    Derived; Yanchevskiy and Niekhoroshykh 2021, eq. (10) are the forces, ISO 281:2007 the life.

    Examples
    --------
    Six pins, two satellites, 500 N*m at 1500 rpm of the crank, involute teeth.

    >>> found = satellite_bearings(
    ...     mechanism=Mechanism.evenly_spaced(pins=6, satellites=2, ratio=20.0),
    ...     output_torque=500.0, pin_circle_radius=0.05, eccentricity=2e-3, kind="ball",
    ...     mesh=RingMesh(math.tan(math.radians(34.6912426))), input_speed=50*math.pi)
    >>> [round(float(each[0]), 2)
    ...  for each in (found.min_load, found.peak_load, found.equivalent_load)]
    [11877.22, 12645.46, 12390.15]
    """
    check_positive(
        output_torque=output_torque,
        pin_circle_radius=pin_circle_radius,
        eccentricity=eccentricity,
        ring_factor=ring_factor,
    )
    relative_speed = None
    if input_speed is not None:
        check_not_negative(input_speed=input_speed)
        relative_speed = input_speed * mechanism.waves_per_turn
    static_torque = output_torque if peak_torque is None else peak_torque
    check_positive(peak_torque=static_torque)
    check_not_negative(centrifugal=centrifugal)
    ratio = mechanism.ratio
    if made is None:
        ideal = partial(
            _ideal_loads,
            mechanism=mechanism,
            force_exponent=force_exponent,
            arm=eccentricity * ratio / pin_circle_radius,
            mesh=mesh,
            exponent=EXPONENTS[kind],
        )
        across = distribution_factor * output_torque / (eccentricity * ratio)
        loads = others = ideal(across=across, centrifugal=centrifugal)
        rest = uneven_shares(
            satellites=mechanism.satellites, distribution_factor=distribution_factor
        ).min()
        if rest < distribution_factor:
            others = _idle_loads(loads, centrifugal)
            if rest:
                part = rest / distribution_factor * across
                others = ideal(across=part, centrifugal=centrifugal)
        more = static_torque / output_torque

        def static_loads() -> FloatArray:
            if not np.any(centrifugal):
                return np.asarray(more)[..., None] * loads.most
            still = ideal(across=more * across)
            spun = ideal(across=more * across, centrifugal=centrifugal)
            return np.maximum(still.most, spun.most)

    else:
        check_single(output_torque=output_torque, peak_torque=peak_torque)
        ways = WAYS[torque_direction]

        def solved(torque: float, relief: float) -> _Loads:
            turns = [made(way * torque) for way in ways]
            return _made_loads(turns, eccentricity * ratio, mesh, relief, EXPONENTS[kind])

        loads = others = solved(output_torque, centrifugal)

        def static_loads() -> FloatArray:
            reliefs = {0.0, float(centrifugal)}
            most = [solved(static_torque, each).most for each in reliefs]
            return np.asarray(np.maximum.reduce(most))

    reliability_factor(percent=reliability_percent)  # refuses what is not in the table
    found = SatelliteBearings(
        given_speed=relative_speed,
        mesh=mesh,
        radial_force_ratio=loads.ratio,
        peak_load=loads.most,
        min_load=others.least,
        equivalent_load=np.asarray(ring_factor)[..., None] * loads.mean,
        lesser_load=np.asarray(ring_factor)[..., None] * others.mean,
        peak_ring_force=loads.ring,
        static_loads=cache(static_loads),
        kind=kind,
        dynamic_rating=dynamic_rating,
        static_rating=static_rating,
        reliability_percent=reliability_percent,
        weibull_slope=weibull_slope,
        load_accuracy=loads.accuracy,
        notices=(*mesh.notices, *_idle(loads)),
    )
    for name in ("life", "system_life", "static_safety_factor"):
        with suppress(NotKnown):
            getattr(found, name)  # refuses what is out of range
    return replace(found, notices=(*found.notices, *poorly_known(found.accuracy)))


def uneven_shares(*, satellites: int, distribution_factor: float) -> FloatArray:
    """Shares of the torque over 1/K, where a satellite carries K_alpha/K of it and the others
    evenly what is left: ``(K - K_alpha)/(K - 1)``.

    Parameters
    ----------
    satellites : int
        Their number K.
    distribution_factor : float
        K_alpha, from 1 to K.

    Returns
    -------
    array, shape (K, K)
        A row for each choice of that satellite; shape (1, K) where all are alike.

    Examples
    --------
    >>> uneven_shares(satellites=3, distribution_factor=2.0)[0].tolist()
    [2.0, 0.5, 0.5]
    """
    if distribution_factor == 1:
        return np.ones((1, satellites))
    rest = (satellites - distribution_factor) / (satellites - 1)
    return np.where(np.eye(satellites, dtype=bool), distribution_factor, rest)


def _lives(load: FloatArray, *, rating: Number, kind: Bearing) -> FloatArray:
    """Lives in million turns; infinite without a load."""
    capacity = np.asarray(rating, dtype=np.float64)[..., None]
    carrying = load > 0
    some = np.where(carrying, load, capacity)
    lives = rating_life(load=some, rating=capacity, kind=kind)
    found: FloatArray = np.where(carrying, lives, math.inf)
    return found


def _together(life: FloatArray, others: FloatArray, weibull_slope: Number) -> Number:
    """Life of all bearings together, by the worst choice of the one that carries most: by the lives
    that each has as that one, and as one of the others.
    """
    one = np.eye(life.shape[-1], dtype=bool)
    lives = np.where(one, life[..., None, :], others[..., None, :])
    slope = np.asarray(weibull_slope)[..., None]
    found: FloatArray = np.asarray(system_life(lives=lives, weibull_slope=slope))
    return found.min(axis=-1)


@dataclass(frozen=True, slots=True)
class _Loads:
    """Largest, least and equivalent load of each satellite, and the largest force of the ring on
    it, N; the ratio of that along the crank to that across it.
    """

    most: FloatArray
    least: FloatArray
    mean: FloatArray
    ring: FloatArray
    ratio: Number
    accuracy: Accuracy


def _idle(loads: _Loads) -> list[Notice]:
    """Which satellites carry nothing."""
    idle = np.flatnonzero((loads.most == 0).reshape(-1, loads.most.shape[-1]).any(axis=0))
    return [Notice("satellite_idle", {"satellite": j + 1}) for j in idle.tolist()]


def _idle_loads(loads: _Loads, centrifugal: Number) -> _Loads:
    """Loads of bearings that only the centrifugal force of their satellite presses."""
    own = np.broadcast_to(np.asarray(centrifugal)[..., None], loads.mean.shape).astype(float)
    return replace(loads, most=own, least=own, mean=own, ring=0.0 * own)


def _ideal_loads(
    *,
    mechanism: Mechanism,
    force_exponent: float,
    across: Number,
    arm: Number,
    mesh: RingMesh,
    centrifugal: Number = 0.0,
    exponent: float,
) -> _Loads:
    """Loads under the ideal forces, of all designs."""
    turn = ideal_turn(
        1.0, mechanism=mechanism, force_exponent=force_exponent, pin_circle_radius=1.0
    )
    across, along, rho, relief = (
        np.asarray(each, dtype=np.float64)[..., None, None]
        for each in (across, arm, mesh.radial_force_ratio, centrifugal)
    )
    rings = across * (rho + 1j) * turn.couple
    held = rings + across * along * turn.on_satellites.real - relief
    off = mesh.error * max(1.0, float(np.abs(rho).max()))  # of W, which is no more than the load
    ratio = mesh.radial_force_ratio
    return _loads([(turn, held, rings)], [turn.error + SEARCHED + off], ratio, exponent)


def _made_loads(
    turns: list[SampledTurn], arm: float, mesh: RingMesh, centrifugal: float, exponent: float
) -> _Loads:
    """Loads of the mechanism as it is made; of both directions the worse."""
    forces, errors, ratios = [], [], []
    for turn in turns:
        parts = made_parts(turn=turn, arm=arm, radial_force_ratio=float(mesh.radial_force_ratio))
        given = mesh.error * max(1.0, abs(parts.ratio))
        held = parts.load - centrifugal
        forces.append((turn, held, parts.ring))
        missed = turn.missed(held) / np.abs(held).max()
        errors.append(missed + turn.error + (0.0 if parts.solved else given))
        ratios.append(parts.ratio)
    return _loads(forces, errors, max(ratios, key=abs), exponent)


def _loads(
    forces: list[tuple[SampledTurn, ComplexArray, ComplexArray]],
    errors: list[float],
    ratio: Number,
    exponent: float,
) -> _Loads:
    """Loads by the forces that each bearing bears and those of the ring, shape (..., K, n), in each
    direction; what is within their error nothing, is 0.
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
    """Forces on the satellites of a mechanism as it is made, N, in the frame of each crank."""

    # Of pins and ring, shape (K, n): along the crank towards the axis, and i times that across,
    # back against the rotation of the crank under a driving torque.
    load: ComplexArray
    ring: ComplexArray  # of the ring alone, likewise
    ratio: float  # of the ring's force along the cranks to that across them; its mean where solved
    solved: bool = False  # whether the ring's force is solved; else it has the ratio that is given


def made_parts(*, turn: SampledTurn, arm: float, radial_force_ratio: float) -> MadeParts:
    """Forces on the satellites of a mechanism as it is made.

    Parameters
    ----------
    turn : SampledTurn
        Forces of the pins.
    arm : float
        ``e*u``: of the ring's force about the satellite's centre, m.
    radial_force_ratio : float
        Ratio rho of the ring's force along the crank to that across it: the teeth press apart
        whichever flank carries. Of a ring whose mesh is solved it is not used.

    Returns
    -------
    MadeParts
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
    """Load of the satellites' bearings at crank angles, in the crank's frame."""

    crank_angle: FloatArray  # rad, shape (n,)
    across: FloatArray  # part across the crank, N, shape (n, K)
    along: FloatArray  # part along it towards the reducer's axis, N, shape (n, K)
    load: FloatArray  # both together, N, shape (n, K)


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
    """Load of the satellites' bearings under the ideal forces at given crank angles.

    Parameters
    ----------
    mechanism : Mechanism
        Pins, satellites, ratio.
    force_exponent : float
        Exponent v of the force over the approach.
    output_torque : float
        Torque T on the output link, N*m.
    pin_circle_radius : float
        Radius R of the circle of pin centres, m.
    eccentricity : float
        Eccentricity e of the cranks, m.
    radial_force_ratio : float
        Ratio rho of the ring's force along the crank to that across it.
    crank_angle : array, shape (n,)
        Crank angles, rad.
    torque_direction : {"driving", "reverse", "alternating"}
        Of an alternating torque the driving one is shown.

    Returns
    -------
    BearingCurves
        In reverse the part across the crank is negative.
    """
    way = WAYS[torque_direction][0]
    if way < 0:  # those pairs carry that would brake, as half a turn of the wave later
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
