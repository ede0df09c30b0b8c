"""Mean of the total force over the turn."""

from collections.abc import Callable
from itertools import chain
from typing import Any

from core.arrays import FloatArray
from core.output.losses import total_force
from core.output.mechanism import Mechanism
from core.output.pin_forces import force_ratios
from core.work_precision.study import WorkPrecision
from core.work_precision.turn_mean import turn_mean_study


def total_force_study(*, mechanism: Mechanism, force_exponent: float = 1.0) -> WorkPrecision:
    """Error against run time of the mean total force, to which the mean loss is proportional.

    Parameters
    ----------
    mechanism : Mechanism
        Pins, satellites, ratio; at most `core.work_precision.turn_mean.MAX_PAIRS` pairs.
    force_exponent : float
        Exponent v of the force over the approach.

    Returns
    -------
    WorkPrecision

    Raises
    ------
    InvalidInput
        If there are too many pairs.
    ImpossibleMechanism
        If the mechanism has a dead centre.
    """
    forces: dict[str, Any] = {"mechanism": mechanism, "force_exponent": force_exponent}

    def totals(angles: FloatArray) -> FloatArray:
        total: FloatArray = force_ratios(crank_angles=angles, **forces).sum(axis=(1, 2))
        return total

    def exact(own: list[list[Any]], _: list[list[Any]]) -> Any:
        return sum(chain.from_iterable(own))

    calculate: Callable[..., Any] = total_force.__wrapped__  # not what it remembers
    return turn_mean_study(
        **forces,
        values=totals,
        exact=exact,
        power=1.0,
        calculate=lambda: calculate(**forces).mean,
        accuracy=total_force(**forces).accuracy,
    )
