"""Reactions of the crankshaft's two bearings, its balance in them.

In the crank's frame, with the crank of satellite j in the direction ``e_j`` and ``t_j`` at a right
angle ahead of it, a satellite presses its crank with ``-(W_j*t_j + (rho*W_j + S_j)*e_j)``: back
against the rotation, and to the reducer's axis. All of it stands still there but for its ripple, so
that the shaft is bent one way all the time.
"""

import math
from dataclasses import dataclass
from itertools import product

import numpy as np

from core.arrays import ComplexArray, FloatArray, check_positive, check_single
from core.crank.balance import (
    Balance,
    Counterweight,
    balance,
    carried,
    carried_error,
    check_places,
    crank_error,
)
from core.crank.bearing_life import EXPONENTS, Bearing, rating_life
from core.crank.ring_mesh import RingMesh
from core.crank.satellite_bearing import BearingCurves, made_parts, mean_power, uneven_shares
from core.errors import Accuracy, Notice, poorly_known
from core.output.contact_force import force_peak
from core.output.mechanism import Mechanism
from core.output.pin_search import MISSED, largest
from core.output.pin_turn import satellite_turn
from core.output.sampled_turn import WAYS, Direction, Made, SampledTurn
from core.precision import ROUNDING


@dataclass(frozen=True, slots=True)
class Crankshaft:
    """Reactions and balance of a crankshaft."""

    # Largest reaction of each bearing over the turn, N, shape (2,), with that to the centrifugal
    # forces where the balance is known; 0 where forces that cancel leave nothing but rounding.
    peak_reaction: FloatArray
    equivalent_reaction: FloatArray  # equivalent load of each, N, shape (2,), likewise
    # Time that 90 % of such bearings in the housing reach, s, by the bearing, 0 or 1: of those that
    # are loaded and whose rating and speed are known.
    basic_life: dict[int, float]
    balance: Balance | None  # where mass and speed are given
    accuracy: Accuracy  # of all numbers; of the balance over the sum of the sizes it is made of
    notices: tuple[Notice, ...]  # those of the ring


def crankshaft(
    *,
    mechanism: Mechanism,
    force_exponent: float = 1.0,
    output_torque: float,
    pin_circle_radius: float,
    eccentricity: float,
    mesh: RingMesh,
    distribution_factor: float = 1.0,
    satellite_positions: tuple[float, ...],
    bearing_positions: tuple[float, float],
    kinds: tuple[Bearing, Bearing] = ("ball", "ball"),
    dynamic_ratings: tuple[float | None, float | None] = (None, None),
    satellite_mass: float | None = None,
    counterweights: tuple[Counterweight, ...] = (),
    rotor_mass: float | None = None,
    input_speed: float | None = None,
    bearing_speeds: tuple[float, float] | None = None,
    torque_direction: Direction = "driving",
    made: Made | None = None,
) -> Crankshaft:
    """Reactions of the crankshaft's bearings, and its balance.

    The forces are the ideal ones, shared equally by the satellites; with `made` those of the
    mechanism as it is made.
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
    distribution_factor : float
        Factor K_alpha of one satellite's share, from 1 to K, where that is stated: it carries
        K_alpha/K of the torque, the others what is left, and of all choices of it the worst counts
        for each bearing. Of ideal forces.
    satellite_positions : tuple of float
        Middle planes z of the satellites along the shaft, m.
    bearing_positions : tuple of float
        Places A and B of the bearings, m; B beyond A.
    kinds : tuple of {"ball", "roller"}
        Rolling elements of each bearing, for the equivalent load.
    dynamic_ratings : tuple of float or None
        Basic dynamic load rating C of each bearing, N, > 0, where it is known.
    satellite_mass : float, optional
        Mass m of a satellite with its bearing, kg, > 0.
    counterweights : tuple of Counterweight
        Masses besides the satellites; they count where that mass is given.
    rotor_mass : float, optional
        Mass of all that turns with the shaft, kg, > 0, for the grade of the balance.
    input_speed : float, optional
        Speed of the crank against the housing, rad/s, > 0; for balance and life.
    bearing_speeds : tuple of float, optional
        Speed of the crank against what each bearing sits in, rad/s, where that is not the housing;
        one that does not turn has no life.
    torque_direction : {"driving", "reverse", "alternating"}
        Of both directions the worse counts.
    made : callable, optional
        Forces of the mechanism as it is made, see `core.output.real_turn.sampled`.

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
    sizes = {"pin_circle_radius": pin_circle_radius, "eccentricity": eccentricity}
    check_single(
        output_torque=output_torque,
        **sizes,
        satellite_mass=satellite_mass,
        input_speed=input_speed,
    )
    check_positive(output_torque=output_torque, **sizes)
    check_places(
        satellites=mechanism.satellites,
        positions=satellite_positions,
        bearings=bearing_positions,
    )
    held = carried(positions=satellite_positions, bearings=bearing_positions)
    arm_error = carried_error(held, positions=satellite_positions, bearings=bearing_positions)
    arm_error = arm_error + np.abs(held) * crank_error(np.array(mechanism.crank_angles))
    spun = None
    if satellite_mass is not None and input_speed is not None:
        spun = balance(
            satellite_mass=satellite_mass,
            eccentricity=eccentricity,
            crank_angles=mechanism.crank_angles,
            satellite_positions=satellite_positions,
            bearing_positions=bearing_positions,
            counterweights=counterweights,
            input_speed=input_speed,
            rotor_mass=rotor_mass,
        )
    still = _still(spun) if spun else STILL
    ways = WAYS[torque_direction]
    exponents = [EXPONENTS[kind] for kind in kinds]
    if made is None:
        found = _ideal_reactions(
            mechanism=mechanism,
            force_exponent=force_exponent,
            across=output_torque / (eccentricity * mechanism.ratio),
            pins=output_torque / pin_circle_radius,
            mesh=mesh,
            carried=held,
            arm_error=arm_error,
            still=still,
            distribution_factor=distribution_factor,
            exponents=exponents,
            ways=ways,
        )
    else:
        found = _made_reactions(
            [made(way * output_torque) for way in ways],
            eccentricity * mechanism.ratio,
            mesh,
            held,
            still,
            exponents,
        )
    speeds = bearing_speeds or (input_speed, input_speed)
    lives: dict[int, float] = {}
    error = 0.0
    for row in np.flatnonzero(found.most).tolist():
        load = float(found.equivalent[row])
        own = float(found.off[row]) / load
        error = max(error, own + MISSED + found.truncation)
        rating = dynamic_ratings[row]
        if rating is not None and (speed := speeds[row]):
            million = 1e6 * 2 * math.pi / speed
            lives[row] = million * rating_life(load=load, rating=rating, kind=kinds[row])
            error = max(error, exponents[row] * own + found.truncation)
    accuracy = Accuracy(found.method, error + 8 * ROUNDING, found.evaluations)
    notices = (*mesh.notices, *poorly_known(accuracy))
    return Crankshaft(found.most, found.equivalent, lives, spun, accuracy, notices)


@dataclass(frozen=True, slots=True)
class _Reactions:
    """Largest and equivalent reaction of both bearings and their error, N; 0 where that is all
    there is; the relative error of the means; how they were found.
    """

    most: FloatArray
    equivalent: FloatArray
    off: FloatArray
    truncation: float
    method: str
    evaluations: int


def _ideal_reactions(
    *,
    mechanism: Mechanism,
    force_exponent: float,
    across: float,
    pins: float,
    mesh: RingMesh,
    carried: FloatArray,
    arm_error: FloatArray,
    still: tuple[ComplexArray, FloatArray],
    distribution_factor: float,
    exponents: list[float],
    ways: tuple[float, ...],
) -> _Reactions:
    """By the ideal forces; in reverse the part across the crank changes its sign. What stands still
    is a part of the sum of all shares, which is 1.
    """
    force_peak(mechanism, force_exponent)  # refuses what cannot be
    rho = float(mesh.radial_force_ratio)
    most, equivalent, truncation = np.zeros(2), np.zeros(2), 0.0
    turn = satellite_turn(mechanism, force_exponent)
    share, force = turn.forces.max(axis=(1, 2)).reshape(2, -1)
    share_error, force_error = turn.errors.reshape(2, -1)
    share_error = math.hypot(1, rho) * share_error + mesh.error * abs(rho) * share
    arms = carried * _cranks(mechanism.crank_angles)
    constant, still_error = still
    own = np.abs(carried) * (across * share_error + pins * force_error)
    own += arm_error * (across * math.hypot(1, rho) * share + pins * force)
    shares = uneven_shares(satellites=mechanism.satellites, distribution_factor=distribution_factor)
    off = shares.max() * own.sum(axis=1) + still_error
    off += np.abs(constant) * share_error.sum()
    for way, own_shares in product(ways, shares):
        held = own_shares * arms
        rings = across * (1j * way + rho) * held + constant[:, None]
        both = np.concatenate((rings, pins * held), axis=1)
        found = largest(turn=turn, arms=(both,), measure=np.abs)
        rows = np.flatnonzero(found > off)
        if not len(rows):
            continue
        mean, lost = mean_power(
            turn=turn,
            arms=(both[rows],),
            measure=np.abs,
            largest=found[rows],
            exponents=[exponents[row] for row in rows],
        )
        most[rows] = np.maximum(most[rows], found[rows])
        equivalent[rows] = np.maximum(equivalent[rows], mean)
        truncation = max(truncation, lost)
    size = turn.forces[0].size
    return _Reactions(most, equivalent, off, truncation, "segments_tanh_sinh", size)


def _made_reactions(
    turns: list[SampledTurn],
    arm: float,
    mesh: RingMesh,
    carried: FloatArray,
    unbalanced: tuple[ComplexArray, FloatArray],
    exponents: list[float],
) -> _Reactions:
    """By the forces of the mechanism as it is made."""
    rho, (still, still_error) = float(mesh.radial_force_ratio), unbalanced
    most, equivalent, off = np.zeros(2), np.zeros(2), np.zeros(2)
    for turn in turns:
        parts = made_parts(turn=turn, arm=arm, radial_force_ratio=rho)
        reaction = carried @ (parts.load * _cranks(turn.crank_angles)[:, None]) + still[:, None]
        sizes = turn.error * np.abs(parts.load)
        if not parts.solved:
            sizes = sizes + mesh.error * np.abs(parts.ring.real)
            sizes = sizes + mesh.ratio_error * np.abs(parts.ring.imag)
        lost = (np.abs(carried) @ sizes).max(axis=1) + still_error
        for row, size in enumerate(np.abs(reaction)):
            off[row] = max(off[row], turn.missed(reaction[row]) + lost[row])
            if size.max() > off[row]:
                mean = turn.mean(size ** exponents[row]) ** (1 / exponents[row])
                most[row] = max(most[row], size.max())
                equivalent[row] = max(equivalent[row], mean)
    evaluations = sum(turn.evaluations for turn in turns)
    return _Reactions(most, equivalent, off, 0.0, "sampling", evaluations)


STILL: tuple[ComplexArray, FloatArray] = (np.zeros(2, dtype=complex), np.zeros(2))
"""Reactions to what is not balanced, N, and their error, of what does not turn."""


def _still(spun: Balance) -> tuple[ComplexArray, FloatArray]:
    """Reactions to what is not balanced, N, shape (2,), and their error."""
    return np.array(spun.reaction), np.array(spun.reaction_error)


def _cranks(angles: tuple[float, ...]) -> ComplexArray:
    """Directions of the cranks in the crank's frame."""
    found: ComplexArray = np.exp(1j * np.array(angles))
    return found


@dataclass(frozen=True, slots=True)
class ReactionCurves:
    """Reactions at crank angles, in the crank's frame."""

    crank_angle: FloatArray  # rad, shape (n,)
    # Of both bearings, N, shape (n, 2): along the direction from which crank angles are counted,
    # and i times that ahead of it.
    reaction: ComplexArray


def reaction_curves(
    *,
    loads: BearingCurves,
    crank_angles: tuple[float, ...],
    satellite_positions: tuple[float, ...],
    bearing_positions: tuple[float, float],
    unbalanced: ComplexArray = STILL[0],
) -> ReactionCurves:
    """Reactions of the crankshaft's bearings to given loads of the satellites' bearings.

    Parameters
    ----------
    loads : BearingCurves
        Of the satellites' bearings, see `core.crank.satellite_bearing.bearing_curves`.
    crank_angles : tuple of float
        Angle of each satellite's crank, rad.
    satellite_positions : tuple of float
        Middle planes z of the satellites along the shaft, m.
    bearing_positions : tuple of float
        Places A and B of the bearings, m.
    unbalanced : array, shape (2,)
        What is added to them by what is not balanced, N; the loads are without it.

    Returns
    -------
    ReactionCurves
    """
    load = (loads.along + 1j * loads.across) * _cranks(crank_angles)
    held = carried(positions=satellite_positions, bearings=bearing_positions)
    reaction = (load[:, None, :] * held).sum(axis=2) + unbalanced
    return ReactionCurves(loads.crank_angle, reaction)
