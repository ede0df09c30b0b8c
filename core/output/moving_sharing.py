"""Satellites that share the load by stiffness: how that moves with the torque.

Of a contact by Hertz the compliance falls with the logarithm of its force, so that under more
torque the pairs on stiff places of the pins take more. Where the stiffness of satellite j is l_j
times as large as in a turn that is known, with its share w_j of the torque there,

    F_j -> l_j*F_j/sum(l_i*w_i)

at the same place of the turn: one turn tells the forces of any sharing, also of the equal one.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from core.arrays import FloatArray, IntArray, Number
from core.output.mechanism import Mechanism
from core.output.pin_search import Measure, largest
from core.output.pin_turn import PinTurn, SatelliteTurn, pin_turn, satellite_turn

STEPS, SETTLED = 30, 3e-7
"""Most looks for a factor on the torque, and what a secant's curvature may move its logarithm by
without another look: what is left then is smaller by as much again."""

FINER = 5
"""Level of the rule of means over the turn where the forces have no slope or curvature where a pair
switches; else the coarsest."""

BESIDE = 0.03
"""By which part of the logarithm before the first place it is looked too."""

APART = 1e-7
"""Distance of logarithms below which their differences are rounding."""


class SharedPinTurn(PinTurn):
    """Shares of the satellites ``T_j/T`` of the torque, then their forces on a pin over F0.

    Parameters
    ----------
    turn : PinTurn
        The forces, by a stiffness of the pairs of each satellite.
    satellites : SatelliteTurn
        What the satellites do by the same.
    """

    def __init__(self, turn: PinTurn, satellites: SatelliteTurn) -> None:
        vars(self).update(vars(turn))
        self._satellites = satellites
        shares = satellites.forces[: len(turn.forces), self.part[self.arcs]]  # all arcs are felt
        self.forces = np.concatenate((shares, turn.forces))

    def _own(self, arcs: IntArray) -> Callable[[FloatArray], NDArray[Any]]:
        """T times both, shape (rows, 2*K, m)."""
        forces, shares = super()._own(arcs), self._satellites.carried(self.part[arcs])
        return lambda way: np.concatenate((shares(way), forces(way)), axis=1)


@dataclass(frozen=True)
class MovingSharing:
    """The stiffness of the pairs of satellites under a torque and under others."""

    stiffness: tuple[float, ...]  # K values, N/m, contact and pin in series, under the torque
    # Approach of a contact over its force, m/N, as a function of the force, N.
    compliance: Callable[[Number], Number]
    force: float  # of the contacts under the torque, N
    mechanism: Mechanism  # without a dead centre
    force_exponent: float  # v of the force over the approach

    @cached_property
    def pin_turn(self) -> SharedPinTurn:
        """Shares and forces on a pin under the torque."""
        own = pin_turn(self.mechanism, self.force_exponent, self.stiffness)
        return SharedPinTurn(own, self.satellite_turn)

    @cached_property
    def satellite_turn(self) -> SatelliteTurn:
        """Shares and forces on the satellites under it."""
        return satellite_turn(self.mechanism, self.force_exponent, self.stiffness)

    @cached_property
    def nodes(self) -> tuple[FloatArray, FloatArray]:
        """The latter at the nodes of a rule of the whole turn, shape (2*K, n); weights, (n, 1)."""
        turn = self.satellite_turn
        if not turn.smooth:
            return turn.nodes_of(FINER)
        values, weights = turn.coarse_nodes
        own = weights[:, 0] > 0
        return values[:, own], weights[own, :1]

    @property
    def equal(self) -> FloatArray:
        """Stiffnesses that are all alike over those under the torque, shape (K,)."""
        found: FloatArray = min(self.stiffness) / np.array(self.stiffness)
        return found

    def under(self, factors: FloatArray) -> FloatArray:
        """Stiffnesses under so many times the torque over those under it.

        Parameters
        ----------
        factors : array, shape (n,)
            Factors on the torque, > 0.

        Returns
        -------
        array, shape (n, K)
        """
        change = self.compliance(factors * self.force) - self.compliance(self.force)
        found: FloatArray = 1 / (1 + np.asarray(change)[:, None] * self.stiffness)
        return found

    def worse(self, *, factors: FloatArray, of: Callable[[FloatArray], FloatArray]) -> FloatArray:
        """What grows with the forces under other torques, of equal and stiffness sharing the worse.

        Parameters
        ----------
        factors : array, shape (n,)
            Factors on the torque, > 0.
        of : callable
            It, shape (m, rows), of stiffnesses over those under the torque, shape (m, K).

        Returns
        -------
        array, shape (n, rows)
        """
        each = of(np.concatenate((self.equal[None], self.under(factors))))
        found: FloatArray = factors[:, None] * np.maximum(each[0], each[1:])
        return found


def shared(
    *, sharing: FloatArray, arms: tuple[NDArray[Any], ...], measure: Measure
) -> tuple[tuple[NDArray[Any], ...], Measure, tuple[int, int]]:
    """Arms and measure by which the shares and forces of a turn tell those of other sharings.

    Parameters
    ----------
    sharing : array, shape (m, K)
        Stiffnesses over those of the turn.
    arms : tuple of array, each shape (rows, 2*K) or (m, rows, 2*K)
        What shares and forces do.
    measure : callable
        Of the sums, each shape (rows, n).

    Returns
    -------
    arms : tuple of array, each shape (m*rows, 2*K)
    measure : callable
    shape : tuple of int
        m and rows.
    """
    both = np.concatenate((sharing, sharing), axis=1)[:, None]
    moved = [both * each for each in arms]
    count, rows, size = moved[0].shape
    whole = np.concatenate((sharing, np.zeros_like(sharing)), axis=1).repeat(rows, axis=0)

    def shared_measure(*sums: NDArray[Any]) -> FloatArray:
        *each, carried = sums
        return measure(*(one / carried.real for one in each))

    return (*(each.reshape(-1, size) for each in moved), whole), shared_measure, (count, rows)


def shared_largest(
    *,
    turn: SharedPinTurn | SatelliteTurn,
    sharing: FloatArray,
    arms: tuple[NDArray[Any], ...],
    measure: Measure,
) -> FloatArray:
    """The largest of a measure over the turn under other sharings.

    Parameters
    ----------
    turn : SharedPinTurn or SatelliteTurn
        Shares and forces.
    sharing, arms, measure : as of `shared`

    Returns
    -------
    array, shape (m, rows)
    """
    flat, own, shape = shared(sharing=sharing, arms=arms, measure=measure)
    return largest(turn=turn, arms=flat, measure=own).reshape(shape)


def torque_factors(
    *,
    targets: FloatArray,
    value: Callable[[FloatArray], FloatArray],
    start: FloatArray | None = None,
) -> FloatArray:
    """Factors on the torque under which what grows with it is so many times as large.

    Parameters
    ----------
    targets : array, shape (n,)
        How many times; what is not positive and finite stays.
    value : callable
        What grows, > 0, of factors on the torque.
    start : array, shape (n,), optional
        About the factors; the targets where not given.

    Returns
    -------
    array, shape (n,)

    Notes
    -----
    Secants of the logarithms of both, bent by the third place, all targets at once. The factor lies
    between the first place and 1, near the first.
    """
    found = np.array(targets if start is None else start, dtype=np.float64)
    some = (targets > 0) & np.isfinite(targets)
    if not some.any():
        return found
    aims, x0 = np.log(targets[some]), np.log(found[some])
    x2, y2 = np.zeros_like(x0), -aims
    x1 = x0 * (1 - BESIDE) if start is None else x2
    logs = np.log(value(np.exp(np.concatenate((x0, x1 if start is None else [], [0.0])))))
    y0, y1 = logs[: len(x0)] - logs[-1] - aims, y2
    if start is None:
        y1 = logs[len(x0) : -1] - logs[-1] - aims
    for _ in range(STEPS):
        known = (each.tolist() for each in (x0, x1, x2, y0, y1, y2))
        place, missed = np.array([_secant(*each) for each in zip(*known, strict=True)]).T
        if np.abs(missed).max() <= SETTLED:
            break
        x0, x1, x2, y1, y2 = place, x0, x1, y0, y1
        y0 = np.log(value(np.exp(place))) - logs[-1] - aims
    found[some] = np.exp(place)
    return found


def _secant(
    x0: float, x1: float, x2: float, y0: float, y1: float, y2: float
) -> tuple[float, float]:
    """The next place of a secant through two places, bent by a third, and what that may miss."""
    slope = _slope(x0, x1, y0, y1, 1.0)
    place = x0 - y0 / slope
    further = _slope(x0, x2, slope, _slope(x1, x2, y1, y2, slope), 0.0)
    bent = further * (place - x0) * (place - x1) / slope
    known = x1 != x2 and y0 != y1  # else nothing is known of how it bends
    return place - bent, bent if known else place - x0


def _slope(x0: float, x1: float, y0: float, y1: float, same: float) -> float:
    """Slope between two places; a given one where they are the same, or nothing grows."""
    return (y0 - y1) / (x0 - x1) if abs(x0 - x1) > APART and y0 != y1 else same
