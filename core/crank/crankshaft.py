"""Reactions of the crankshaft's two bearings, and its balance.

In the crank's frame, with the crank of satellite j in the direction ``e_j`` and ``t_j`` at a right
angle ahead of it, a satellite presses its crank with ``-(W_j*t_j + (rho*W_j + S_j)*e_j)``: back
against the rotation, and to the reducer's axis. All of it stands still there but for its ripple, so
that the shaft is bent one way all the time.
"""

import math
from dataclasses import dataclass

import numpy as np

from core.arrays import FloatArray, check_positive
from core.crank.bearing_life import EXPONENTS, Bearing, rating_life
from core.crank.ring_mesh import RingMesh
from core.crank.satellite_bearing import bearing_curves, made_parts, mean_power
from core.errors import InvalidInput
from core.output.contact_force import force_peak
from core.output.mechanism import Mechanism
from core.output.pin_search import largest
from core.output.pin_turn import ComplexArray, satellite_turn
from core.output.sampled_turn import WAYS, Direction, Made, SampledTurn
from core.results import ROUNDING, Accuracy, Notice, poorly_known


@dataclass(frozen=True, slots=True)
class Correction:
    """What balances the shaft in the plane of a bearing.

    Attributes
    ----------
    unbalance : float
        Mass times radius, kg*m.
    angle : float
        Its direction in the sense of the crank's rotation, as the crank angles are counted, rad.
    """

    unbalance: float
    angle: float


@dataclass(frozen=True, slots=True)
class Balance:
    """Centrifugal forces of the satellites on the shaft.

    Attributes
    ----------
    unbalance : float
        Mass times radius that is left, kg*m.
    force : float
        Its force at the speed of the crank, N.
    couple : float
        Couple of the satellites about the middle of the bearings, N*m.
    corrections : tuple of Correction
        In the planes of both bearings; together they balance force and couple.
    """

    unbalance: float
    force: float
    couple: float
    corrections: tuple[Correction, Correction]


@dataclass(frozen=True, slots=True)
class Crankshaft:
    """Reactions and balance of a crankshaft.

    Attributes
    ----------
    peak_reaction, equivalent_reaction : array, shape (2,)
        Largest reaction of each bearing over the turn, and its equivalent load, N; without the
        centrifugal forces.
    basic_life : tuple of float or None
        Time that 90 % of such bearings in the housing reach, s, where rating and speed are known.
    balance : Balance or None
        Where mass and speed are given.
    accuracy : Accuracy
        Of the reactions; the balance is as good as its input.
    notices : tuple of Notice
        Those of the ring.
    """

    peak_reaction: FloatArray
    equivalent_reaction: FloatArray
    basic_life: tuple[float | None, ...]
    balance: Balance | None
    accuracy: Accuracy
    notices: tuple[Notice, ...]


def crankshaft(
    *,
    mechanism: Mechanism,
    force_exponent: float = 1.0,
    output_torque: float,
    pin_circle_radius: float,
    eccentricity: float,
    mesh: RingMesh,
    satellite_positions: tuple[float, ...],
    bearing_positions: tuple[float, float],
    kinds: tuple[Bearing, Bearing] = ("ball", "ball"),
    dynamic_ratings: tuple[float | None, float | None] = (None, None),
    satellite_mass: float | None = None,
    input_speed: float | None = None,
    torque_direction: Direction = "driving",
    pair_stiffness: tuple[float, ...] | None = None,
    made: Made | None = None,
) -> Crankshaft:
    """Reactions of the crankshaft's bearings, and its balance.

    The forces are the ideal ones, shared equally by the satellites; with `pair_stiffness` also
    shared by it, and the worse counts; with `made` those of the mechanism as it is made.
    ``R_B = -sum F_j*(z_j - A)/(B - A)``, ``R_A = -sum F_j - R_B``; unbalance ``U = sum m*e*e_j``.

    Parameters
    ----------
    mechanism : Mechanism
        Pins, satellites, ratio.
    force_exponent : float
        Exponent v of the force over the approach.
    output_torque : float
        Torque T on the output link, N*m, > 0.
    pin_circle_radius : float
        Radius R of the circle of pin centres, m, > 0.
    eccentricity : float
        Eccentricity e of the cranks, m, > 0.
    mesh : RingMesh
        The ring's force along the crank.
    satellite_positions : tuple of float
        Middle planes z of the satellites along the shaft, m.
    bearing_positions : tuple of float
        Places A and B of the bearings, m; B beyond A.
    kinds : tuple of {"ball", "roller"}
        Rolling elements of each bearing, for the equivalent load.
    dynamic_ratings : tuple of float or None
        Basic dynamic load rating C of each bearing, N, > 0, where it is known.
    satellite_mass : float, optional
        Mass m of a satellite, kg, > 0.
    input_speed : float, optional
        Speed of the crank against the housing, rad/s, > 0; for balance and life.
    torque_direction : {"driving", "reverse", "alternating"}
        Of both directions the worse counts.
    pair_stiffness : tuple of float, K, optional
        Stiffness of the pairs of each satellite against each other, see
        `core.output.pin_beam.PinBeam.pair_stiffness`; not beside `made`.
    made : callable, optional
        Forces of the mechanism as it is made, see `core.output.real_turn.made`.

    Returns
    -------
    Crankshaft

    Raises
    ------
    InvalidInput
        If a size is out of range.
    ImpossibleMechanism
        If the mechanism has a dead centre.

    Notes
    -----
    Derived. The load of the input drive itself is left out, but for its torque.

    Examples
    --------
    Six pins, two satellites at 20 and 42 mm of 62 mm between the bearings, involute teeth.

    >>> found = crankshaft(
    ...     mechanism=Mechanism.evenly_spaced(pins=6, satellites=2, ratio=20.0),
    ...     output_torque=500.0, pin_circle_radius=0.05, eccentricity=2e-3,
    ...     mesh=RingMesh(math.tan(math.radians(34.6912426))),
    ...     satellite_positions=(0.02, 0.042), bearing_positions=(0.0, 0.062))
    >>> [round(each, 3) for each in found.peak_reaction.tolist()]
    [4487.098, 4487.098]
    """
    check_positive(
        output_torque=output_torque, pin_circle_radius=pin_circle_radius, eccentricity=eccentricity
    )
    count = mechanism.satellites
    if len(satellite_positions) != count:
        sizes = {"expected": count, "actual": len(satellite_positions)}
        name = "satellite_positions"
        raise InvalidInput(name, len(satellite_positions), "different_length", **sizes)
    first, last = bearing_positions
    if not last > first:
        raise InvalidInput("bearing_positions[1]", last, "greater_than", limit=first)
    carried = _carried(satellite_positions, bearing_positions)
    ways = WAYS[torque_direction]
    if made is None:
        most, equivalent, accuracy = _ideal_reactions(
            mechanism=mechanism,
            force_exponent=force_exponent,
            across=output_torque / (eccentricity * mechanism.ratio),
            pins=output_torque / pin_circle_radius,
            mesh=mesh,
            carried=carried,
            exponents=[EXPONENTS[kind] for kind in kinds],
            ways=ways,
            stiffnesses=(None,) if pair_stiffness is None else (None, pair_stiffness),
        )
    else:
        most, equivalent, accuracy = _made_reactions(
            [made(way * output_torque) for way in ways],
            eccentricity * mechanism.ratio,
            float(mesh.radial_force_ratio),
            carried,
            [EXPONENTS[kind] for kind in kinds],
        )
    lives: list[float | None] = [None, None]
    for row, (kind, rating) in enumerate(zip(kinds, dynamic_ratings, strict=True)):
        if rating is not None and input_speed is not None:
            load = float(equivalent[row])
            million = 1e6 * 2 * math.pi / input_speed
            lives[row] = million * rating_life(load=load, rating=rating, kind=kind)
    balance = None
    if satellite_mass is not None and input_speed is not None:
        check_positive(satellite_mass=satellite_mass, input_speed=input_speed)
        unbalances = satellite_mass * eccentricity * _cranks(mechanism.crank_angles)
        balance = _balance(carried, unbalances, input_speed, last - first)
    notices = (*mesh.notices, *poorly_known(accuracy))
    return Crankshaft(most, equivalent, tuple(lives), balance, accuracy, notices)


Reactions = tuple[FloatArray, FloatArray, Accuracy]
"""Largest and equivalent reaction of both bearings, N."""


def _ideal_reactions(
    *,
    mechanism: Mechanism,
    force_exponent: float,
    across: float,
    pins: float,
    mesh: RingMesh,
    carried: FloatArray,
    exponents: list[float],
    ways: tuple[float, ...],
    stiffnesses: tuple[tuple[float, ...] | None, ...],
) -> Reactions:
    """By the ideal forces; in reverse the part across the crank changes its sign."""
    peak = force_peak(mechanism, force_exponent)  # refuses what cannot be
    rho = float(mesh.radial_force_ratio)
    arms = carried * _cranks(mechanism.crank_angles)
    cases, truncation = [], 0.0
    for stiffness in stiffnesses:
        turn = satellite_turn(mechanism, force_exponent, stiffness)
        for way in ways:
            both = np.concatenate((across * (1j * way + rho) * arms, pins * arms), axis=1)
            most = largest(turn=turn, arms=(both,), measure=np.abs)
            means = []
            for row, exponent in enumerate(exponents):
                own = slice(row, row + 1)
                mean, off = mean_power(
                    turn=turn,
                    arms=(both[own],),
                    measure=np.abs,
                    largest=most[own],
                    exponent=exponent,
                )
                means.append(mean)
                truncation = max(truncation, off)
            cases.append((most, np.concatenate(means)))
    most, equivalent = (np.maximum.reduce(each) for each in zip(*cases, strict=True))
    # satellites that oppose each other may leave little of their forces
    count = mechanism.satellites
    total = (np.abs(carried).sum(axis=1) * (across * (1 + abs(rho)) + pins * count)).max()
    error = 8 * peak.accuracy.relative_error + ROUNDING * (32 + 16 * force_exponent)
    error = 4 * ((error + mesh.error * abs(rho)) * float(total / most.min()) + truncation)
    return most, equivalent, Accuracy("segments_tanh_sinh", error, turn.forces[0].size)


def _made_reactions(
    turns: list[SampledTurn],
    arm: float,
    radial_force_ratio: float,
    carried: FloatArray,
    exponents: list[float],
) -> Reactions:
    """By the forces of the mechanism as it is made."""
    cases, error = [], 0.0
    for turn in turns:
        load = made_parts(turn=turn, arm=arm, radial_force_ratio=radial_force_ratio).load
        reaction = carried @ (load * _cranks(turn.crank_angles)[:, None])
        size = np.abs(reaction)
        mean = [
            turn.mean(row**exponent) ** (1 / exponent)
            for row, exponent in zip(size, exponents, strict=True)
        ]
        cases.append((size.max(axis=1), np.array(mean)))
        scale = (np.abs(carried) @ np.abs(load)).max()
        error = max(error, (turn.missed(reaction) + turn.error * scale) / size.max(axis=1).min())
    most, equivalent = (np.maximum.reduce(each) for each in zip(*cases, strict=True))
    evaluations = sum(turn.evaluations for turn in turns)
    return most, equivalent, Accuracy("sampling", error, evaluations)


def _carried(positions: tuple[float, ...], bearings: tuple[float, float]) -> FloatArray:
    """What each bearing carries of a force at each satellite, shape (2, K)."""
    on_last = (np.array(positions) - bearings[0]) / (bearings[1] - bearings[0])
    return np.stack((1 - on_last, on_last))


def _cranks(angles: tuple[float, ...]) -> ComplexArray:
    """Directions of the cranks in the crank's frame."""
    found: ComplexArray = np.exp(1j * np.array(angles))
    return found


def _balance(
    carried: FloatArray, unbalances: ComplexArray, speed: float, distance: float
) -> Balance:
    """Force and couple of the unbalances, and what balances them in the bearings' planes."""
    needed = -(carried * unbalances).sum(axis=1)
    corrections = tuple(Correction(abs(each), _turned(each)) for each in needed.tolist())
    left = abs(complex(unbalances.sum()))
    couple = abs(complex(needed[1] - needed[0])) / 2 * distance
    return Balance(left, left * speed**2, couple * speed**2, corrections)  # type: ignore[arg-type]


def _turned(value: complex) -> float:
    """Direction from 0 to less than a turn."""
    return math.atan2(value.imag, value.real) % (2 * math.pi)


@dataclass(frozen=True, slots=True)
class ReactionCurves:
    """Reactions at crank angles, in the crank's frame.

    Attributes
    ----------
    crank_angle : array, shape (n,)
        Crank angles, rad.
    reaction : array of complex, shape (n, 2)
        Of both bearings: along the direction from which crank angles are counted, and i times
        that ahead of it, N.
    """

    crank_angle: FloatArray
    reaction: ComplexArray


def reaction_curves(
    *,
    mechanism: Mechanism,
    force_exponent: float = 1.0,
    output_torque: float,
    pin_circle_radius: float,
    eccentricity: float,
    radial_force_ratio: float,
    satellite_positions: tuple[float, ...],
    bearing_positions: tuple[float, float],
    crank_angle: FloatArray,
) -> ReactionCurves:
    """Reactions of the crankshaft's bearings at given crank angles.

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
    satellite_positions : tuple of float
        Middle planes z of the satellites along the shaft, m.
    bearing_positions : tuple of float
        Places A and B of the bearings, m.
    crank_angle : array, shape (n,)
        Crank angles, rad.

    Returns
    -------
    ReactionCurves
    """
    loads = bearing_curves(
        mechanism=mechanism,
        force_exponent=force_exponent,
        output_torque=output_torque,
        pin_circle_radius=pin_circle_radius,
        eccentricity=eccentricity,
        radial_force_ratio=radial_force_ratio,
        crank_angle=crank_angle,
    )
    held = (loads.along + 1j * loads.across) * _cranks(mechanism.crank_angles)
    carried = _carried(satellite_positions, bearing_positions)
    return ReactionCurves(crank_angle, (held[:, None, :] * carried).sum(axis=2))
