"""Results for a torque that alternates: both directions are solved and the worse one counts."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from core.arrays import FloatArray
from core.errors import Accuracy, Notice
from core.numerics.extremes import first_largest
from core.output.loaded_position import loaded_position
from core.output.over_turn import OverTurn
from core.output.real_curves import RealCurves, real_curves
from core.output.stage import Stage


def worse_position(
    *,
    real: Stage,
    crank_angle: float,
    output_torque: float,
    position: Callable[..., Any] = loaded_position,
) -> tuple[Any, bool]:
    """Loaded position in the direction with the larger force, and True if that is the reverse one.

    The position holds the hardest pressed contacts of both directions, because a smaller force may
    press harder between smaller radii. `position` solves one position as `loaded_position` does,
    under a torque, N*m; `ImpossibleMechanism` is raised if either direction cannot be solved.
    """
    driving, back = (
        position(real=real, crank_angle=crank_angle, output_torque=sign * output_torque)
        for sign in (1, -1)
    )
    reverse = first_largest([max(map(max, each.force)) for each in (driving, back)]) == 1
    worse, other = (back, driving) if reverse else (driving, back)
    return replace(worse, contacts=worse.contacts + other.contacts), reverse


def worse_curves(
    *, real: Stage, crank_angle: FloatArray, output_torque: float
) -> tuple[RealCurves, bool]:
    """Curves in the direction with the larger force, and True if that is the reverse one.

    Crank angles, shape (M,), are in rad. The torque's size is in N*m and positive.
    `ImpossibleMechanism` is raised if either direction cannot be solved; see `Stage.solved`.
    """
    driving, back = (
        real_curves(real=real, crank_angle=crank_angle, output_torque=sign * output_torque)
        for sign in (1, -1)
    )
    reverse = first_largest([driving.force.max(), back.force.max()]) == 1
    return (back if reverse else driving), reverse


LARGER = {
    "transmission_error",
    "unloaded_transmission_error",
    "stiffness_max",
    "loaded_pairs_max",
    "input_torque_ripple",
}
"""Names of numbers over the turn whose larger value of both directions is the worse one."""

LESS = {"stiffness_min", "loaded_pairs_min"}
"""Names of numbers over the turn whose smaller value of both directions is the worse one."""


class WorseTurn:
    """Worse value of both directions over the turn for each number, by the names of `OverTurn`.

    Peak force, its crank angle and its pair are those of the direction with the larger peak.
    Backlash and lost motion do not depend on the direction.
    """

    def __init__(self, driving: OverTurn, back: OverTurn) -> None:
        self.reverse = first_largest([driving.peak_force, back.peak_force]) == 1
        """True if the peak force is that of the reverse torque."""
        self.worse, self.other = (back, driving) if self.reverse else (driving, back)

    def __getattr__(self, name: str) -> Any:
        worse = getattr(self.worse, name)
        if name in LARGER:
            return max(worse, getattr(self.other, name))
        return min(worse, getattr(self.other, name)) if name in LESS else worse

    @property
    def max_pressure(self) -> float:
        """Largest pressure of both directions, Pa."""
        return max(self.worse.max_pressure, self.other.max_pressure)

    @property
    def pair_force(self) -> tuple[tuple[float, ...], ...]:
        """Largest force of each pair in both directions, N, K x N."""
        rows = zip(self.worse.pair_force, self.other.pair_force, strict=True)
        return tuple(tuple(map(max, one, two)) for one, two in rows)

    @property
    def accuracy(self) -> Accuracy:
        """Accuracy of the peak force: larger error and all evaluations of both directions."""
        one, two = self.worse.accuracy, self.other.accuracy
        error = max(one.relative_error, two.relative_error)
        return Accuracy(one.method, error, one.evaluations + two.evaluations)

    @property
    def notices(self) -> tuple[Notice, ...]:
        """Notices of both directions, one for each code."""
        both = (*self.other.notices, *self.worse.notices)
        return tuple({each.code: each for each in both}.values())
