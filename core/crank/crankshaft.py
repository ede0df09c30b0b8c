"""Reactions of the crankshaft's two bearings, with the balance of the shaft in them.

In the crank's frame, with the crank of satellite j in the direction ``e_j`` and ``t_j`` a right
angle ahead of it, a satellite presses its crank with ``-(W_j*t_j + (rho*W_j + S_j)*e_j)``: against
the rotation, and towards the reducer's axis. The forces stand still in this frame except for a
ripple, so that the shaft is always bent in one direction.
"""

import math
from dataclasses import dataclass
from itertools import product

import numpy as np

from core.arrays import ComplexArray, FloatArray, check_positive, check_single
from core.crank.balance import Balance, carried, check_places, rounding
from core.crank.bearing_life import EXPONENTS, Bearing, rating_life
from core.crank.ring_mesh import RingMesh
from core.crank.satellite_bearing import BearingCurves, made_parts, uneven_shares
from core.errors import Accuracy, Notice, poorly_known
from core.fields import answer
from core.output.pin_circle_load import PinCircleLoad
from core.output.sampled_turn import SampledTurn
from core.precision import ROUNDING


@dataclass(frozen=True, slots=True)
class Crankshaft:
    """Reactions and balance of a crankshaft."""

    # Largest reaction of each bearing over the turn, N, shape (2,), centrifugal forces included if
    # the balance is known; 0 where forces cancel within rounding.
    peak_reaction: FloatArray
    equivalent_reaction: FloatArray  # equivalent load of each bearing, N, shape (2,)
    # Time that 90 % of such bearings reach, s, by the bearing, 0 or 1; only for bearings that are
    # loaded and whose rating and speed are known.
    basic_life: dict[int, float]
    balance: Balance | None = answer()
    """Balance of satellites and counterweights; absent without masses or a speed."""
    accuracy: Accuracy = answer()  # of the balance over the sum of the sizes of its forces
    notices: tuple[Notice, ...] = answer()  # of the ring mesh, and of poorly known results


def crankshaft(
    *,
    load: PinCircleLoad[SampledTurn],
    eccentricity: float,
    mesh: RingMesh,
    distribution_factor: float = 1.0,
    satellite_positions: tuple[float, ...],
    bearing_positions: tuple[float, float],
    kinds: tuple[Bearing, Bearing] = ("ball", "ball"),
    dynamic_ratings: tuple[float | None, float | None] = (None, None),
    bearing_speeds: tuple[float | None, float | None] = (None, None),
    balance: Balance | None = None,
) -> Crankshaft:
    """Reactions of the crankshaft's bearings, with those to the unbalance if the balance is given.

    ``R_B = -sum F_j*(z_j - A)/(B - A)``, ``R_A = -sum F_j - R_B`` with the satellites' forces F_j
    on the cranks. Of the input drive only the torque is considered. `ImpossibleMechanism` is raised
    at a dead centre.

    For ideal forces one satellite carries K_alpha/K of the torque by the load-sharing factor
    K_alpha, from 1 to K, and the worst choice of that satellite counts for each bearing. Middle
    planes z of the satellites and places A and B of the bearings, B beyond A, are in m. The speed
    of the crank against the seat of each bearing is in rad/s; without it, or at 0, there is no
    life. The balance is that of these satellites, see `core.crank.balance`.

    Six pins, two satellites at 20 and 42 mm of 62 mm between the bearings, involute teeth.

    >>> from core.output.mechanism import Mechanism
    >>> six = Mechanism.evenly_spaced(pins=6, satellites=2, ratio=20.0)
    >>> found = crankshaft(
    ...     load=PinCircleLoad(mechanism=six, output_torque=500.0, pin_circle_radius=0.05),
    ...     eccentricity=2e-3, mesh=RingMesh(math.tan(math.radians(34.6912426))),
    ...     satellite_positions=(0.02, 0.042), bearing_positions=(0.0, 0.062))
    >>> [round(each, 3) for each in found.peak_reaction.tolist()]
    [4487.098, 4487.098]
    """
    check_single(eccentricity=eccentricity)
    check_positive(eccentricity=eccentricity)
    angles = load.mechanism.crank_angles
    check_places(satellites=len(angles), positions=satellite_positions, bearings=bearing_positions)
    turns = load.turns(load.output_torque)
    exponents = [EXPONENTS[kind] for kind in kinds]
    found = _reactions(
        turns=turns,
        arm=eccentricity * load.mechanism.ratio,
        mesh=mesh,
        carried=carried(positions=satellite_positions, bearings=bearing_positions),
        rounded=rounding(angles=angles, positions=satellite_positions, bearings=bearing_positions),
        spun=balance,
        shares=uneven_shares(satellites=len(angles), distribution_factor=distribution_factor),
        exponents=exponents,
    )
    lives: dict[int, float] = {}
    error = 0.0
    for row in np.flatnonzero(found.most).tolist():
        equivalent = float(found.equivalent[row])
        own = float(found.off[row]) / equivalent
        error = max(error, own)
        rating = dynamic_ratings[row]
        if rating is not None and (speed := bearing_speeds[row]):
            million = 1e6 * 2 * math.pi / speed
            lives[row] = million * rating_life(load=equivalent, rating=rating, kind=kinds[row])
            error = max(error, exponents[row] * own)
    evaluations = sum(turn.evaluations for turn in turns)
    accuracy = Accuracy("sampling", error + 8 * ROUNDING, evaluations)
    notices = (*mesh.notices, *poorly_known(accuracy))
    return Crankshaft(found.most, found.equivalent, lives, balance, accuracy, notices)


@dataclass(frozen=True, slots=True)
class _Reactions:
    """Reactions of both bearings and their error, N; reactions within their error are 0."""

    most: FloatArray
    equivalent: FloatArray
    off: FloatArray


def _reactions(
    *,
    turns: list[SampledTurn],
    arm: float,
    mesh: RingMesh,
    carried: FloatArray,
    rounded: float,
    spun: Balance | None,
    shares: FloatArray,
    exponents: list[float],
) -> _Reactions:
    """Largest reactions over the directions of the torque and the choices of shares."""
    rho = float(mesh.radial_force_ratio)
    unbalanced, still = (np.array(spun.reaction), spun.rounding) if spun else (STILL, 0.0)
    most, equivalent, off = np.zeros(2), np.zeros(2), np.zeros(2)
    for turn, own in product(turns, shares[..., None]):
        parts = made_parts(turn=turn, arm=arm, radial_force_ratio=rho)
        load = own * parts.load
        held = carried @ (load * _cranks(turn.crank_angles)[:, None]) + unbalanced[:, None]
        sizes = turn.error * np.abs(load)
        if not parts.solved:
            sizes = sizes + mesh.error * max(1.0, abs(rho)) * np.abs(own * parts.ring.imag)
        lost = np.abs(carried) @ sizes + rounded * np.abs(load).sum(axis=0) + still
        size = np.abs(held)
        for row, peak in enumerate(turn.largest(size).tolist()):
            known = turn.missed(held[row]) + float(lost[row].max())
            off[row] = max(off[row], known)
            if peak > off[row]:
                mean = float(turn.mean(size[row] ** exponents[row]) ** (1 / exponents[row]))
                most[row], equivalent[row] = max(most[row], peak), max(equivalent[row], mean)
    return _Reactions(most, equivalent, off)


STILL: ComplexArray = np.zeros(2, dtype=complex)
"""Reactions to the unbalance, N, of a shaft that does not turn."""


def _cranks(angles: tuple[float, ...]) -> ComplexArray:
    """Directions of the cranks in the crank's frame, as complex numbers."""
    found: ComplexArray = np.exp(1j * np.array(angles))
    return found


@dataclass(frozen=True, slots=True)
class ReactionCurves:
    """Reactions over the crank angle, in the crank's frame."""

    crank_angle: FloatArray  # rad, shape (n,)
    # Reactions of both bearings, N, shape (n, 2): real part along the direction of crank angle 0,
    # imaginary part a right angle ahead of it.
    reaction: ComplexArray


def reaction_curves(
    *,
    loads: BearingCurves,
    crank_angles: tuple[float, ...],
    satellite_positions: tuple[float, ...],
    bearing_positions: tuple[float, float],
    unbalanced: ComplexArray = STILL,
) -> ReactionCurves:
    """Reactions of the crankshaft's bearings to given loads of the satellites' bearings. The loads
    are without centrifugal forces, see `core.crank.satellite_bearing.bearing_curves`; angles of
    cranks are in rad, places along the shaft in m, A and B those of the bearings. `unbalanced` are
    reactions to the unbalance, N, shape (2,), which are added.
    """
    load = (loads.along + 1j * loads.across) * _cranks(crank_angles)
    held = carried(positions=satellite_positions, bearings=bearing_positions)
    reaction = (load[:, None, :] * held).sum(axis=2) + unbalanced
    return ReactionCurves(loads.crank_angle, reaction)
