"""A torque that alternates: both directions are solved, and the worse is given."""

from dataclasses import replace

from core.arrays import FloatArray
from core.output.loaded_position import LoadedPosition, loaded_position
from core.output.over_turn import TIE, OverTurn, over_turn
from core.output.real_curves import RealCurves, real_curves
from core.output.real_mechanism import RealMechanism
from core.results import Accuracy, Notice


def _reverse(driving: float, reverse: float) -> bool:
    """Whether the largest force is that of the reverse torque; of equal ones it is not."""
    return reverse > driving * (1 + TIE)


def worse_position(
    *, real: RealMechanism, crank_angle: float, output_torque: float
) -> tuple[LoadedPosition, bool]:
    """The direction with the larger force at one crank angle.

    Parameters
    ----------
    real : RealMechanism
        The mechanism.
    crank_angle : float
        Crank angle, rad.
    output_torque : float
        Size of the torque, N*m, > 0.

    Returns
    -------
    position : LoadedPosition
        Of the worse direction; the largest pressure is that of both, as a smaller force between
        narrower radii may press harder.
    reverse : bool
        Whether that is the reverse.

    Raises
    ------
    InvalidInput
        If an input is out of range.
    ImpossibleMechanism
        If either direction cannot be; see `RealMechanism.solved`.
    """
    driving, back = (
        loaded_position(real=real, crank_angle=crank_angle, output_torque=sign * output_torque)
        for sign in (1, -1)
    )
    reverse = _reverse(max(map(max, driving.force)), max(map(max, back.force)))
    worse, other = (back, driving) if reverse else (driving, back)
    return replace(worse, max_pressure=_larger_pressure(worse, other)), reverse


def _larger_pressure(
    one: LoadedPosition | OverTurn, other: LoadedPosition | OverTurn
) -> float | None:
    """The larger pressure of both directions, where it is known."""
    pressures = [each for each in (one.max_pressure, other.max_pressure) if each is not None]
    return max(pressures, default=None)


def worse_curves(
    *, real: RealMechanism, crank_angle: FloatArray, output_torque: float
) -> tuple[RealCurves, bool]:
    """The direction with the larger force at crank angles.

    Parameters
    ----------
    real : RealMechanism
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
        If either direction cannot be; see `RealMechanism.solved`.
    """
    driving, back = (
        real_curves(real=real, crank_angle=crank_angle, output_torque=sign * output_torque)
        for sign in (1, -1)
    )
    reverse = _reverse(float(driving.force.max()), float(back.force.max()))
    return (back if reverse else driving), reverse


def worse_turn(
    *, real: RealMechanism, output_torque: float, lost_motion_share: float = 0.03
) -> tuple[OverTurn, bool]:
    """The worse of both directions over the turn, number by number.

    Parameters
    ----------
    real : RealMechanism
        The mechanism.
    output_torque : float
        Size of the torque, N*m, > 0.
    lost_motion_share : float
        Share of the torque under which the lost motion is taken, 0 < share <= 1.

    Returns
    -------
    turn : OverTurn
        The peak, where it is and its pair are those of the direction with the larger peak; every
        other number is the worse of the two: errors and spreads the larger, the least stiffness the
        smaller. Backlash and lost motion are the same in both.
    reverse : bool
        Whether the peak is that of the reverse torque.

    Raises
    ------
    InvalidInput
        If an input is out of range.
    ImpossibleMechanism
        If either direction cannot be; see `RealMechanism.solved`.
    """
    driving, back = (
        over_turn(
            real=real, output_torque=sign * output_torque, lost_motion_share=lost_motion_share
        )
        for sign in (1, -1)
    )
    reverse = _reverse(driving.peak_force, back.peak_force)
    worse, other = (back, driving) if reverse else (driving, back)

    def larger(name: str) -> float:
        value: float = max(getattr(worse, name), getattr(other, name))
        return value

    notices: dict[str, Notice] = {each.code: each for each in (*other.notices, *worse.notices)}
    turn = replace(
        worse,
        max_pressure=_larger_pressure(worse, other),
        transmission_error=larger("transmission_error"),
        unloaded_transmission_error=larger("unloaded_transmission_error"),
        stiffness_min=min(worse.stiffness_min, other.stiffness_min),
        stiffness_max=larger("stiffness_max"),
        loaded_pairs_min=min(worse.loaded_pairs_min, other.loaded_pairs_min),
        loaded_pairs_max=max(worse.loaded_pairs_max, other.loaded_pairs_max),
        pair_force=tuple(
            tuple(map(max, one, two))
            for one, two in zip(worse.pair_force, other.pair_force, strict=True)
        ),
        input_torque_ripple=larger("input_torque_ripple"),
        angle_error=larger("angle_error"),
        stiffness_error=larger("stiffness_error"),
        pair_error=larger("pair_error"),
        ripple_error=larger("ripple_error"),
        accuracy=Accuracy(
            worse.accuracy.method,
            max(worse.accuracy.relative_error, other.accuracy.relative_error),
            worse.accuracy.evaluations + other.accuracy.evaluations,
        ),
        notices=tuple(notices.values()),
    )
    return turn, reverse
