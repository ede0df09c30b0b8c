"""Satellites that give: elastic crank bearings, an elastic mesh, or given shares of the torque.

First order only. What bearings and meshes give is solved in `core.output.sharing_kernel`; with
given shares every satellite is solved for itself.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from core.arrays import check_positive
from core.errors import InvalidInput
from core.output.sharing_kernel import (
    SOLVED,
    Pairs,
    Position,
    Room,
    Setup,
)
from core.precision import ROUNDING, SAME


@dataclass(frozen=True, slots=True)
class CrankSupport:
    """Bearing of each satellite on its crank."""

    stiffness: float = math.inf  # k_b of one bearing, radial, N/m; infinite where not given
    radial_clearance: float = 0.0  # G, m: the inner ring moves by G/2 to either side of its middle


@dataclass(frozen=True, slots=True)
class ElasticMesh:
    """Mesh of each satellite with the ring, which lets the disc turn under its torque."""

    stiffness: float  # torque over rotation k_D of one disc, N*m/rad


@dataclass(frozen=True, slots=True)
class Shares:
    """Torque that is shared as given, whatever the discs need to turn for it."""

    shares: tuple[float, ...]  # w_j of each of the K satellites, > 0, of sum 1


@dataclass(frozen=True, slots=True)
class RingInSeries:
    """Each disc finds its place between the pins of its ring and those of the output, as both
    meshes give: it is no support of the one alone.
    """

    # Whether somebody says so; else it is so where that is known and all repeats after one turn
    # of the wave, as the ring's pins are alike.
    stated: bool = True


@dataclass(frozen=True, slots=True)
class SharedTorque:
    """Its satellites, each solved for itself.

    Its methods stand for the functions of the same names of `core.output.sharing_kernel`: at a
    wave angle psi, rad, of the design in first order with the torque's direction, the constants of
    its pairs, and the room that takes forces, levers and stiffnesses of the pairs and the lags of
    the satellites.
    """

    shares: tuple[float, ...]  # w_j of each of the K satellites, > 0, of sum 1
    loops: Any  # of one satellite

    def solve(self, psi: float, torque: float, setup: Setup, pairs: Pairs, room: Room) -> Position:
        """Every satellite under its share of the torque, N*m, > 0.

        Lag, stiffness and play of the position are those of a linkage that shares the torque so:
        the mean lag of the satellites, weighted by the shares.
        """
        shares, found = self.shares, []
        for j, (one, own_pairs, own) in enumerate(_each(setup, pairs, room)):
            position = self.loops.solve(psi, shares[j] * torque, one, own_pairs, own)
            found.append(position)
            room.own_lag[j] = position.lag
            for name in OF_PAIRS:
                row, values = getattr(room, name), getattr(own, name)
                row[j * setup.pins : (j + 1) * setup.pins] = values
        self.loops.at(psi, setup, pairs, room)  # as one satellite leaves it
        low, high = _mean_play(
            shares,
            [
                (math.inf, -math.inf) if each.low > each.high + each.play_error else each[2:4]
                for each in found
            ],
        )
        slopes = [each.stiffness for each in found]
        gives = 0.0
        if min(slopes) > 0:
            gives = sum(w * (w / slope) for w, slope in zip(shares, slopes, strict=True))

        def mean(name: str) -> float:
            return math.fsum(w * getattr(each, name) for w, each in zip(shares, found, strict=True))

        return Position(
            lag=mean("lag"),
            stiffness=1 / gives if gives else 0.0,
            low=low,
            high=high,
            play_error=mean("play_error"),
            lag_error=mean("lag_error") + 2 * ROUNDING * max(abs(each.lag) for each in found),
            force_error=max(each.force_error for each in found),
            status=next((each.status for each in found if each.status != SOLVED), SOLVED),
            steps=sum(each.steps for each in found),
        )

    def played(self, psi: float, setup: Setup, pairs: Pairs, room: Room) -> tuple[float, float]:
        """Limits of the play at a wave angle, rad; the first is larger where pairs press."""
        ends = []
        for one, own_pairs, own in _each(setup, pairs, room):
            self.loops.at(psi, one, own_pairs, own)
            ends.append(self.loops.play(one, own_pairs, own)[:2])
        return _mean_play(self.shares, ends)

    def interference(self, psi: float, setup: Setup, pairs: Pairs, room: Room) -> float:
        """Smallest possible worst approach of the unloaded pairs at a wave angle, m: each satellite
        turns for itself.
        """
        far, worst = setup.eccentricity / setup.radius, list[float]()
        for one, own_pairs, own in _each(setup, pairs, room):
            self.loops.at(psi, one, own_pairs, own)
            worst.append(self.loops.interference(-far, far, one, own_pairs, own))
        return max(worst)

    def wave_torque(self, psi: float, lag: float, setup: Setup, pairs: Pairs, room: Room) -> float:
        """Torque of the forces on the wave, N*m, as `solve` left the room; each satellite has its
        own lag there, and the one that is given is not used.
        """
        each = zip(room.own_lag, _each(setup, pairs, room), strict=False)
        return float(sum(self.loops.wave_torque(psi, own_lag, *own) for own_lag, own in each))


SatelliteSupport = CrankSupport | ElasticMesh | Shares


def check_support(*, support: SatelliteSupport | None, satellites: int, exact: bool) -> None:
    """Refuse what a support cannot be.

    Parameters
    ----------
    support : SatelliteSupport or None
        How the satellites are held.
    satellites : int
        Their number K.
    exact : bool
        Whether the geometry is exact.

    Raises
    ------
    InvalidInput
        If a size is out of range, shares are not one each or do not add up to 1, or the geometry is
        exact.
    """
    if support is None:
        return
    if exact:
        raise InvalidInput("exact", exact, "first_order_only", field="support")
    if isinstance(support, Shares):
        check_shares(shares=support.shares, satellites=satellites)
        return
    check_positive(stiffness=support.stiffness)
    if isinstance(support, CrankSupport) and not 0 <= support.radial_clearance < math.inf:
        given_clearance = support.radial_clearance
        raise InvalidInput("radial_clearance", given_clearance, "greater_than_equal", limit=0)


def check_shares(*, shares: tuple[float, ...], satellites: int) -> None:
    """Refuse shares that are not one each, or do not add up to 1.

    Parameters
    ----------
    shares : tuple of float
        Shares w_j of the torque.
    satellites : int
        Number K of the satellites.

    Raises
    ------
    InvalidInput
        If they are such.
    """
    if len(shares) != satellites:
        counts = {"expected": satellites, "actual": len(shares)}
        raise InvalidInput("shares", shares, "different_length", **counts)
    for j, share in enumerate(shares):
        check_positive(**{f"shares[{j}]": share})
    if not abs(math.fsum(shares) - 1) <= SAME:
        raise InvalidInput("shares", shares, "sum_not_one", sum=math.fsum(shares))


OF_CRANKS = {"arm", "phase", "own", "off", "eta"}
"""Rows of `Pairs` with one number for each satellite."""

OF_PAIRS = Room._fields[: Room._fields.index("own_lag")]
"""Rows of `Room` with one for each pair."""


def _each(setup: Setup, pairs: Pairs, room: Room) -> list[tuple[Setup, Pairs, Room]]:
    """The satellites one by one; the rows are copies."""
    pins, found = setup.pins, []
    one = setup._replace(satellites=1)
    for j in range(setup.satellites):
        rows = slice(j * pins, (j + 1) * pins)
        own = [
            row[j : j + 1] if name in OF_CRANKS else row[rows]
            for name, row in zip(pairs._fields, pairs, strict=True)
        ]
        found.append((one, type(pairs)(*own), type(room)(*[row[rows] for row in room])))
    return found


def _mean_play(
    shares: tuple[float, ...], ends: Sequence[tuple[float, float]]
) -> tuple[float, float]:
    """Play of a linkage that shares the torque; none where any satellite is pressed."""
    if any(low > high for low, high in ends):
        return math.inf, -math.inf
    low, high = (
        math.fsum(w * end for w, end in zip(shares, side, strict=True))
        for side in zip(*ends, strict=True)
    )
    return low, high
