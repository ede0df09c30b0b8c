"""Forces of a design as it is made, as its checks look at them: over the turn, each direction."""

import math
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from functools import cached_property
from typing import Self

from core.errors import NotKnown
from core.hertz import HertzContact
from core.output.over_turn import OverTurn
from core.output.real_mechanism import RealMechanism
from core.output.sampled_turn import WAYS, Direction


@dataclass(frozen=True)
class RealForces:
    """The mechanism as it is made under a torque, over the turn.

    Attributes
    ----------
    real : RealMechanism
        The mechanism, with materials.
    way : float
        Sign of the torque under which the pressure is larger.
    torque : float
        Its size, N*m.
    turn : OverTurn
        Extremes over the turn, in the worse direction.
    """

    real: RealMechanism
    way: float
    torque: float
    turn: OverTurn

    @classmethod
    def solved(
        cls, *, turn: Callable[[float], OverTurn], torque: float, direction: Direction
    ) -> Self:
        """Forces of a mechanism.

        Parameters
        ----------
        turn : callable
            Of the torque, N*m, negative in reverse: extremes of the mechanism under it, with
            materials.
        torque : float
            Size of the torque, N*m, > 0.
        direction : {"driving", "reverse", "alternating"}
            Its direction; of both the worse counts.

        Returns
        -------
        RealForces

        Raises
        ------
        ImpossibleMechanism
            See `core.output.real_mechanism.RealMechanism.solved`.
        """
        ways = WAYS[direction]
        turns = {way: turn(way * torque) for way in ways}

        def pressure(way: float) -> float:
            with suppress(NotKnown):  # of materials; a turn that cannot be solved is refused
                return turns[way].max_pressure
            return math.inf

        way = max(ways, key=pressure)
        return cls(turns[way].real, way, torque, turns[way])

    @cached_property
    def pair(self) -> int:
        """Index of the pair with the largest pressure, satellite by satellite."""
        return self.turn.hardest[0]

    @cached_property
    def force(self) -> float:
        """Force of that pair at the largest pressure, N."""
        return self.turn.hardest[1]

    @property
    def place(self) -> dict[str, float]:
        """Where the largest pressure is reached; the crank angle where it is the largest force."""
        peak, pins = self.turn.peak_pair, self.real.mechanism.pins
        satellite, pin = self.pair // pins + 1, self.pair % pins + 1
        place: dict[str, float] = {"satellite": satellite, "pin": pin}
        if (peak.satellite, peak.pin) == (satellite, pin):
            place["crank_angle"] = self.turn.peak_crank_angle
        return place

    def contact_at(self, factor: float) -> HertzContact:
        """Contact of that pair under so many times its force.

        Parameters
        ----------
        factor : float
            Factor on the force, > 0.

        Returns
        -------
        HertzContact
        """
        contact, turn = self.real.contact(self.pair, self.force * factor), self.turn.accuracy
        error = contact.accuracy.relative_error + turn.relative_error
        return contact._replace(accuracy=turn._replace(relative_error=error))
