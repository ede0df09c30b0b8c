"""What the results of ring, crank and friction take of the forces on the output's pins."""

from collections.abc import Callable
from typing import Any, Protocol

from core.design.document import Design
from core.output.mechanism import MemberLoads
from core.output.over_turn import OverTurn
from core.output.sampled_turn import Made


class OutputForces(Protocol):
    """A design, and the forces on the pins of its output."""

    design: Design
    solved: bool

    @property
    def in_series(self) -> bool:
        """Whether both meshes are solved in series."""

    @property
    def over_turn(self) -> Callable[[float], OverTurn]:
        """Extremes over the turn, of a torque, N*m, negative in reverse."""

    @property
    def made(self) -> Made:
        """The forces on pins and satellites, where they are solved."""

    @property
    def member_loads(self) -> MemberLoads:
        """Torques, speeds and powers of crank, pins and ring, without losses."""

    @property
    def turning(self) -> dict[str, Any]:
        """What the forces follow from, and what turns, as arguments."""

    def limit_pairs(self, most: int) -> None:
        """Refuse more pairs than ideal forces are integrated of."""
