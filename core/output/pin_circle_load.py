"""Load on a circle of pins: the torque, and the forces that balance it over the turn."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Generic, TypeVar

from core.arrays import Number, check_positive, check_single
from core.output.ideal_turn import IdealTurn, ideal_turn
from core.output.mechanism import Mechanism
from core.output.sampled_turn import WAYS, Direction, PinForces

Forces = TypeVar("Forces", bound=PinForces, covariant=True)


@dataclass(frozen=True, slots=True, kw_only=True)
class PinCircleLoad(Generic[Forces]):
    """Torque on the pins, and what determines their forces; sizes not above 0 are refused."""

    mechanism: Mechanism
    output_torque: Number  # T, N*m, > 0
    pin_circle_radius: Number  # R of the circle of pin centres, m, > 0
    force_exponent: float = 1.0  # exponent v of ideal forces
    peak_torque: Number | None = None  # torque for static strength, N*m, > 0; T if not given
    # Direction of the torque, the worse one if alternating; ideal forces are alike in both.
    torque_direction: Direction = "driving"
    # Forces of the mechanism as made under a torque, N*m, negative in reverse, see
    # `core.output.real_turn.sampled`; without it forces are ideal and shared equally.
    made: Callable[[float], Forces] | None = None

    def __post_init__(self) -> None:
        check_positive(
            output_torque=self.output_torque,
            pin_circle_radius=self.pin_circle_radius,
            peak_torque=self.static_torque,
        )

    @property
    def static_torque(self) -> Number:
        """Torque for static strength, N*m."""
        return self.output_torque if self.peak_torque is None else self.peak_torque

    @property
    def forces(self) -> Callable[[float], Forces | IdealTurn]:
        """Function from a torque, N*m, negative in reverse, to the forces; arrays are refused."""
        check_single(
            output_torque=self.output_torque,
            pin_circle_radius=self.pin_circle_radius,
            peak_torque=self.peak_torque,
        )
        return self.made or partial(
            ideal_turn,
            mechanism=self.mechanism,
            force_exponent=self.force_exponent,
            pin_circle_radius=self.pin_circle_radius,
        )

    def turns(self, torque: float) -> list[Forces | IdealTurn]:
        """Forces under a torque of this magnitude, N*m, in each of its directions."""
        return [self.forces(way * torque) for way in WAYS[self.torque_direction]]
