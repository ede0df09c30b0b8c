"""A torque that alternates: both directions are solved, and the worse is given."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from core.arrays import FloatArray
from core.errors import Accuracy, Notice
from core.output.loaded_position import loaded_position
from core.output.over_turn import OverTurn
from core.output.real_curves import RealCurves, real_curves
from core.output.stage import Stage
from core.precision import AS_TYPED


def _reverse(driving: float, reverse: float) -> bool:
    """Whether the largest force is that of the reverse torque; of equal ones it is not."""
    return reverse > driving * (1 + AS_TYPED)


def worse_position(
    *,
    real: Stage,
    crank_angle: float,
    output_torque: float,
    position: Callable[..., Any] = loaded_position,
) -> tuple[Any, bool]:
    """The direction with the larger force at one crank angle.

    Parameters
    ----------
    real : Stage
        The mechanism.
    crank_angle : float
        Crank angle, rad.
    output_torque : float
        Size of the torque, N*m, > 0.
    position : callable
        How a position of it is solved.

    Returns
    -------
    position : LoadedPosition
        Of the worse direction, as `position` gives it; the largest pressure is that of both, as a
        smaller force between narrower radii may press harder.
    reverse : bool
        Whether that is the reverse.

    Raises
    ------
    InvalidInput
        If an input is out of range.
    ImpossibleMechanism
        If either direction cannot be; see `Stage.solved`.
    """
    driving, back = (
        position(real=real, crank_angle=crank_angle, output_torque=sign * output_torque)
        for sign in (1, -1)
    )
    reverse = _reverse(max(map(max, driving.force)), max(map(max, back.force)))
    worse, other = (back, driving) if reverse else (driving, back)
    return replace(worse, contacts=worse.contacts + other.contacts), reverse


def worse_curves(
    *, real: Stage, crank_angle: FloatArray, output_torque: float
) -> tuple[RealCurves, bool]:
    """The direction with the larger force at crank angles.

    Parameters
    ----------
    real : Stage
        The mechanism.
    crank_angle : array, M
        Crank angles, rad.
    output_torque : float
        Size of the torque, N*m, > 0.

    Returns
    -------
    curves : RealCurves
        Of the worse direction.
    reverse : bool
        Whether that is the reverse.

    Raises
    ------
    ImpossibleMechanism
        If either direction cannot be; see `Stage.solved`.
    """
    driving, back = (
        real_curves(real=real, crank_angle=crank_angle, output_torque=sign * output_torque)
        for sign in (1, -1)
    )
    reverse = _reverse(float(driving.force.max()), float(back.force.max()))
    return (back if reverse else driving), reverse


LARGER = {
    "transmission_error",
    "unloaded_transmission_error",
    "stiffness_max",
    "loaded_pairs_max",
    "input_torque_ripple",
}
"""Numbers over the turn of which the larger one of both directions is the worse."""

LESS = {"stiffness_min", "loaded_pairs_min"}
"""The same of the smaller one."""


class WorseTurn:
    """The worse of both directions over the turn, number by number, by the names of `OverTurn`.

    The peak, where it is and its pair are those of the direction with the larger peak. Backlash and
    lost motion are the same in both.

    Parameters
    ----------
    driving, back : OverTurn
        Both directions.
    """

    def __init__(self, driving: OverTurn, back: OverTurn) -> None:
        self.reverse = _reverse(driving.peak_force, back.peak_force)
        """Whether the peak is that of the reverse torque."""
        self.worse, self.other = (back, driving) if self.reverse else (driving, back)

    def __getattr__(self, name: str) -> Any:
        worse = getattr(self.worse, name)
        if name in LARGER:
            return max(worse, getattr(self.other, name))
        return min(worse, getattr(self.other, name)) if name in LESS else worse

    @property
    def max_pressure(self) -> float:
        """Largest pressure, Pa."""
        return max(self.worse.max_pressure, self.other.max_pressure)

    @property
    def pair_force(self) -> tuple[tuple[float, ...], ...]:
        """Largest force of each pair, N, K x N."""
        rows = zip(self.worse.pair_force, self.other.pair_force, strict=True)
        return tuple(tuple(map(max, one, two)) for one, two in rows)

    @property
    def accuracy(self) -> Accuracy:
        """Of the peak force."""
        one, two = self.worse.accuracy, self.other.accuracy
        error = max(one.relative_error, two.relative_error)
        return Accuracy(one.method, error, one.evaluations + two.evaluations)

    @property
    def notices(self) -> tuple[Notice, ...]:
        """Those of either."""
        both = (*self.other.notices, *self.worse.notices)
        return tuple({each.code: each for each in both}.values())
