"""Reactions of the crankshaft's two bearings, with the balance of the shaft in them.

In the crank's frame, with the crank of satellite j in the direction ``e_j`` and ``t_j`` a right
angle ahead of it, a satellite presses its crank with ``-(W_j*t_j + (rho*W_j + S_j)*e_j)``: against
the rotation, and towards the reducer's axis. The forces stand still in this frame except for a
ripple, so that the shaft is always bent in one direction.
"""

import math
from dataclasses import dataclass
from functools import partial
from itertools import product

import numpy as np

from core.arrays import ComplexArray, FloatArray, check_positive, check_single
from core.crank.balance import (
    Balance,
    Counterweight,
    balance,
    carried,
    check_places,
    rounding,
)
from core.crank.bearing_life import EXPONENTS, Bearing, rating_life
from core.crank.ring_mesh import RingMesh
from core.crank.satellite_bearing import BearingCurves, made_parts, uneven_shares
from core.errors import Accuracy, Notice, poorly_known
from core.fields import answer
from core.output.ideal_turn import ideal_turn
from core.output.mechanism import Mechanism
from core.output.sampled_turn import WAYS, Direction, Made, SampledTurn
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

    ``R_B = -sum F_j*(z_j - A)/(B - A)``, ``R_A = -sum F_j - R_B`` with the satellites' forces F_j
    on the cranks. Of the input drive only the torque is considered. `ImpossibleMechanism` is raised
    at a dead centre.

    For ideal forces one satellite carries K_alpha/K of the torque by the load-sharing factor
    K_alpha, from 1 to K, and the worst choice of that satellite counts for each bearing. Middle
    planes z of the satellites and places A and B of the bearings, B beyond A, are in m. A balance
    needs the mass of a satellite with its bearing, kg, and the speed of the crank against the
    housing, rad/s, > 0, as life does; the rotor mass is that of all that turns. `bearing_speeds`,
    rad/s, are against the seat of each bearing if a seat turns against the housing; at 0 there is
    no life. The direction is the worse one if alternating; forces as made (`made`, see
    `core.output.real_turn.sampled`) are by default ideal ones, shared equally.

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
    ways = WAYS[torque_direction]
    exponents = [EXPONENTS[kind] for kind in kinds]
    forces: Made = made or partial(
        ideal_turn,
        mechanism=mechanism,
        force_exponent=force_exponent,
        pin_circle_radius=pin_circle_radius,
    )
    turns = [forces(way * output_torque) for way in ways]
    found = _reactions(
        turns=turns,
        arm=eccentricity * mechanism.ratio,
        mesh=mesh,
        carried=held,
        rounded=rounding(
            angles=mechanism.crank_angles,
            positions=satellite_positions,
            bearings=bearing_positions,
        ),
        spun=spun,
        shares=uneven_shares(
            satellites=mechanism.satellites, distribution_factor=distribution_factor
        ),
        exponents=exponents,
    )
    speeds = bearing_speeds or (input_speed, input_speed)
    lives: dict[int, float] = {}
    error = 0.0
    for row in np.flatnonzero(found.most).tolist():
        load = float(found.equivalent[row])
        own = float(found.off[row]) / load
        error = max(error, own)
        rating = dynamic_ratings[row]
        if rating is not None and (speed := speeds[row]):
            million = 1e6 * 2 * math.pi / speed
            lives[row] = million * rating_life(load=load, rating=rating, kind=kinds[row])
            error = max(error, exponents[row] * own)
    evaluations = sum(turn.evaluations for turn in turns)
    accuracy = Accuracy("sampling", error + 8 * ROUNDING, evaluations)
    notices = (*mesh.notices, *poorly_known(accuracy))
    return Crankshaft(found.most, found.equivalent, lives, spun, accuracy, notices)


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
