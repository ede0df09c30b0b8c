"""Solved forces of a design over the turn, in the direction of the torque that checks judge."""

import math
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from functools import cached_property
from typing import Self

from core.errors import NotKnown
from core.hertz import HertzContact
from core.numerics.extremes import first_largest
from core.output.over_turn import OverTurn
from core.output.real_mechanism import RealMechanism
from core.output.sampled_turn import WAYS, Direction


@dataclass(frozen=True)
class RealForces:
    """Mechanism as it is made under a torque, over the turn."""

    real: RealMechanism  # mechanism with its materials
    way: float  # sign of the torque under which the pressure is larger
    torque: float  # magnitude of the torque, N*m
    turn: OverTurn  # extremes over the turn, in the worse direction

    @classmethod
    def solved(
        cls, *, turn: Callable[[float], OverTurn], torque: float, direction: Direction
    ) -> Self:
        """Forces under a torque of magnitude `torque`, N*m, in the direction of the larger
        pressure.

        `turn` gives the extremes of a mechanism with materials, of a torque in N*m, negative in
        reverse. `ImpossibleMechanism` is raised as by `Stage.solved`.
        """
        ways = WAYS[direction]
        turns = {way: turn(way * torque) for way in ways}

        def pressure(way: float) -> float:
            with suppress(NotKnown):  # unknown materials alone; a turn without a solution raises
                return turns[way].max_pressure
            return math.inf

        way = ways[first_largest([*map(pressure, ways)])]
        return cls(turns[way].real, way, torque, turns[way])

    @cached_property
    def pair(self) -> int:
        """Index of the pair with the largest pressure, counted satellite by satellite."""
        return self.turn.hardest[0]

    @cached_property
    def force(self) -> float:
        """Force of the pair with the largest pressure, N."""
        return self.turn.hardest[1]

    @property
    def place(self) -> dict[str, float]:
        """Satellite and pin of the largest pressure, and its crank angle if known."""
        peak, pins = self.turn.peak_pair, self.real.mechanism.pins
        satellite, pin = self.pair // pins + 1, self.pair % pins + 1
        place: dict[str, float] = {"satellite": satellite, "pin": pin}
        if (peak.satellite, peak.pin) == (satellite, pin):
            place["crank_angle"] = self.turn.peak_crank_angle
        return place

    def contact_at(self, factor: float) -> HertzContact:
        """Contact of the pair with the largest pressure under its force times a factor > 0."""
        contact, turn = self.real.contact(self.pair, self.force * factor), self.turn.accuracy
        error = contact.accuracy.relative_error + turn.relative_error
        return contact._replace(accuracy=turn._replace(relative_error=error))
