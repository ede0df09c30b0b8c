"""Interface of the forces on the output pins that results of ring, crank and friction use."""

from collections.abc import Callable
from typing import Any, Protocol

from core.design.document import Design
from core.output.mechanism import MemberLoads
from core.output.over_turn import OverTurn
from core.output.pin_circle_load import PinCircleLoad
from core.output.sampled_turn import Made, SampledTurn


class OutputForces(Protocol):
    """Design with the forces on its output pins."""

    design: Design
    solved: bool
    bounded: bool
    like: Any
    """Results of another design, whose forces need not be solved again, or None."""

    @property
    def alike(self) -> Any:
        """`like` if its output mechanism is equal, so that forces are equal; else None."""

    @property
    def in_series(self) -> bool:
        """True if both meshes are solved in series."""

    @property
    def over_turn(self) -> Callable[[float], OverTurn]:
        """Extremes over the turn, as a function of the torque, N*m, negative in reverse."""

    @property
    def made(self) -> Made:
        """Solved forces on pins and satellites over the turn, as a function of the torque, N*m."""

    @property
    def member_loads(self) -> MemberLoads:
        """Torques, speeds and powers of crank, pins and ring, without losses."""

    @property
    def pin_load(self) -> PinCircleLoad[SampledTurn]:
        """Load on the output pins under the working torque, and the peak torque."""

    def limit_pairs(self, most: int) -> None:
        """Raise `NotKnown` if ideal forces of more than `most` pairs are to be integrated."""
