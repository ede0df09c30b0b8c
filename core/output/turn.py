"""Positions of the mechanism as it is made, over the turn of the wave."""

import math
from dataclasses import dataclass

from core.output.real_mechanism import RealMechanism
from core.output.sharing_kernel import largest

POSITIONS = 720
"""Positions of the turn at least, a multiple of the pairs: equal summits look equal on the grid."""

CLUSTER = 8
"""How often the distance to a pair's dead angle, where it takes up or leaves, is halved."""

MOST_CLUSTERED = 2880
"""Positions at dead angles at most: with many pairs the grid itself is dense enough there."""


@dataclass(frozen=True, slots=True)
class Pose:
    """One position under load, and its play; lags count in the torque's direction.

    Attributes
    ----------
    lag, stiffness : float
        Lag of the output, rad, and torque over it, N*m/rad.
    force : float
        Largest force, N.
    pressure : float
        Largest force over reduced radius, N/m.
    loaded : int
        Number of pairs with a force.
    low, high : float
        Limits of the play, rad.
    lag_error, play_error, force_error : float
        Bounds of the errors, rad and N.
    input_torque : float
        Torque that turns the crank, N*m.
    """

    lag: float
    stiffness: float
    force: float
    pressure: float
    loaded: int
    low: float
    high: float
    lag_error: float
    play_error: float
    force_error: float
    input_torque: float


class Turn:
    """The mechanism under a torque, position by position."""

    def __init__(self, real: RealMechanism, torque: float) -> None:
        self.real, self.torque = real, abs(torque)
        self.setup = real.setup(math.copysign(1.0, torque))
        self.back = real.setup(-self.setup.direction)
        self.room = real.room()
        self.curved = [
            c / r / (r + c) for r, c in zip(real.pin_radii, real.pairs.distance, strict=True)
        ]
        self.pair_force = [0.0] * len(self.curved)
        self.evaluations = 0

    def pose(self, psi: float) -> Pose:
        """A position under the torque."""
        self.evaluations += 1
        room = self.room
        found = self.real.solved(psi, self.torque, self.setup, room)
        force = largest(room.force)
        self.pair_force = list(map(max, self.pair_force, room.force))
        return Pose(
            found.lag,
            found.stiffness,
            force,
            max(map(float.__mul__, room.force, self.curved)),
            len(room.force) - room.force.count(0.0),
            found.low,
            found.high,
            found.lag_error,
            found.play_error,
            found.force_error,
            self.input_torque(psi, found.lag),
        )

    def input_torque(self, psi: float, lag: float) -> float:
        """Torque that turns the crank, as a position under load left the room."""
        return self.real.input_torque(psi, self.torque, lag, self.setup, self.room)

    def force(self, psi: float) -> float:
        """Largest force at a wave angle."""
        self.evaluations += 1
        self.real.solved(psi, self.torque, self.setup, self.room)
        self.pair_force = list(map(max, self.pair_force, self.room.force))
        return largest(self.room.force)

    def backlash(self, psi: float) -> float:
        """Play at a wave angle; none where pairs press."""
        low, high = self.played(psi)
        return max(high - low, 0.0)

    def played(self, psi: float) -> tuple[float, float]:
        """Limits of the play at a wave angle."""
        return self.real.played(psi, self.setup, self.room)

    def lost(self, psi: float, share: float) -> float:
        """Lost motion at a wave angle."""
        self.evaluations += 2
        lags = [
            self.real.solved(psi, share * self.torque, setup, self.room).lag
            for setup in (self.setup, self.back)
        ]
        return sum(lags)

    def positions(self) -> tuple[list[float], list[float]]:
        """Wave angles of an even grid, and those around dead angles."""
        pairs, pins = self.real.pairs, self.setup.pins
        many = pins * self.setup.satellites
        count = many * -(-POSITIONS // many)
        step = 2 * math.pi / count
        first = self.real.mechanism.initial_crank_angle
        grid = [first + step * i for i in range(count)]
        dead = {
            round((half - pairs.phase[j] - 2 * math.pi * n / pins - first) % (2 * math.pi), 9)
            for half in (0.0, math.pi)
            for j in range(self.setup.satellites)
            for n in range(pins)
        }
        halvings = min(CLUSTER, MOST_CLUSTERED // (2 * len(dead)))
        near = [
            first + (place + sign * step * 2.0**-k) % (2 * math.pi)
            for place in dead
            for k in range(1, halvings + 1)
            for sign in (-1, 1)
        ]
        return grid, near
