"""Results of a design under other torques, where the sharing of its load moves with the torque."""

import math
from collections.abc import Callable
from typing import Any

import numpy as np

from core.arrays import FloatArray
from core.crank.crankshaft import moved_reactions
from core.crank.satellite_bearing import moved_loads
from core.design.document import changed
from core.design.results import Results
from core.output.moving_sharing import shared_largest, torque_factors
from core.output.pin_strength import PinStrength

NEAR_CYCLE = 0.8
"""Part of the largest bending stress from which a cycle by the other sharing may be the worse one:
it may be reversed further. Such cycles of smaller ones, which are rare, are not followed."""


def torque_reserve(
    *, results: Results, growth: float, value: Callable[[FloatArray], FloatArray]
) -> float:
    """Factor on the torque under which what grows with it is so many times as large.

    Parameters
    ----------
    results : Results
        Results of a design.
    growth : float
        How many times.
    value : callable
        What grows, of factors on the torque, where the sharing moves with it.

    Returns
    -------
    float
    """
    if results.sharing is None:
        return growth
    return float(torque_factors(targets=np.array([growth]), value=value)[0])


def pin_reserve(
    *,
    results: Results,
    growth: float,
    value: Callable[[PinStrength], float],
    near: float = 1.0,
    share: float = 1.0,
) -> float:
    """Factor on the torque under which a value of the pins is so many times as large.

    Parameters
    ----------
    results : Results
        Results of a design.
    growth : float
        How many times.
    value : callable
        What grows with the torque.
    near : float
        From which part of the stress by equal sharing that by stiffness may count.
    share : float
        Torque under which it is over the one with the factor.

    Returns
    -------
    float
    """
    if not 0 < growth < math.inf or not _pins_move(results, (share, growth * share), near):
        return growth
    load = results.design.load

    def under(factor: float) -> float:
        torques = {"load.output_torque": load.output_torque, "load.peak_torque": load.peak_torque}
        more = {path: each and each * factor for path, each in torques.items()}
        there = results if factor == 1 else Results(changed(results.design, more))
        return value(there.pin_strength)

    return torque_reserve(
        results=results,
        growth=growth,
        value=lambda factors: np.array([*map(under, factors.tolist())]),
    )


def _pins_move(results: Results, factors: tuple[float, ...], near: float) -> bool:
    """Whether stiffness sharing, as it is under so many times the torque, may load pins more
    than equal sharing, which does not move: by the force that each satellite may take more.
    """
    if results.sharing is None:
        return False
    stiff = results.sharing.under(np.array(factors))
    spread = float((stiff.max(axis=1) / stiff.min(axis=1) - 1).max())
    more = 1 + results.design.mechanism.satellites * spread
    one, other = results.pin_stresses.cases
    arms = np.abs(results.pin_stresses.pin.slopes)  # what cancels, cancels less with other shares
    return bool(
        more * other.bent >= near * one.bent
        or more * other.equivalent >= one.equivalent
        or more * other.deflections.max() >= one.deflections.max()
        or (other.slopes + (more - 1) * (arms @ other.forces)).max() >= one.slopes.max()
    )


def peak_under(*, results: Results, factors: FloatArray) -> FloatArray:
    """Largest force under so many times the torque over F0, where the sharing moves with it.

    Parameters
    ----------
    results : Results
        Results of a design whose sharing moves.
    factors : array, shape (n,)
        Factors on the torque.

    Returns
    -------
    array, shape (n,)
    """
    sharing = results.sharing
    assert sharing is not None
    _, forces = np.split(np.eye(2 * results.design.mechanism.satellites), 2)

    def peaks(stiffness: FloatArray) -> FloatArray:
        return shared_largest(
            turn=sharing.pin_turn, sharing=stiffness, arms=(forces,), measure=np.abs
        )

    return np.asarray(sharing.worse(factors=factors, of=peaks).max(axis=1))


def _moved(results: Results, factors: FloatArray) -> dict[str, Any]:
    """What loads follow from under so many times the torque, as arguments."""
    design = results.design
    return {
        "sharing": results.sharing,
        "factors": factors,
        "radial_force_ratio": float(results.ring_mesh.radial_force_ratio),
        "arm": design.known_eccentricity * design.mechanism.ratio / design.load.pin_circle_radius,
    }


def loads_under(
    *, results: Results, factors: FloatArray, exponent: float | None = None
) -> FloatArray:
    """Largest, or equivalent, loads of the satellites' bearings under so many times the torque
    against each other, where the sharing moves with it.

    Parameters
    ----------
    results : Results
        Results of a design whose sharing moves.
    factors : array, shape (n,)
        Factors on the torque.
    exponent : float, optional
        That of the equivalent load.

    Returns
    -------
    array, shape (n, K)
    """
    return moved_loads(**_moved(results, factors), exponent=exponent)


def reactions_under(*, results: Results, factors: FloatArray) -> FloatArray:
    """Equivalent reactions of the crankshaft's bearings likewise.

    Parameters
    ----------
    results : Results
        Results of a design whose sharing moves.
    factors : array, shape (n,)
        Factors on the torque.

    Returns
    -------
    array, shape (n, 2)
    """
    shaft = results.design.crankshaft
    assert shaft.bearings is not None
    return moved_reactions(
        **_moved(results, factors),
        satellite_positions=shaft.satellite_positions,
        bearing_positions=shaft.bearing_positions,
        kinds=(shaft.bearings[0].kind, shaft.bearings[1].kind),
        torque_direction=results.design.load.torque_direction,
    )
