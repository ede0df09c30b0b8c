"""Losses of the pins by the forces of the mechanism as it is made."""

from dataclasses import replace

from core.output.losses import PinLosses
from core.output.sampled_turn import SampledTurn
from core.results import Accuracy


def made_losses(
    *, losses: PinLosses, turn: SampledTurn, reference: float, largest: float
) -> PinLosses:
    """Losses of a mechanism as it is made, by the sum of its forces.

    Parameters
    ----------
    losses : PinLosses
        Those of the ideal forces.
    turn : SampledTurn
        Forces under the torque.
    reference : float
        ``F0 = T/R``, N.
    largest : float
        Largest force of a contact in any direction of the torque, N.

    Returns
    -------
    PinLosses
    """
    total = turn.total / reference
    mean, least, most = float(turn.mean(total)), float(total.min()), float(total.max())
    peak = largest / float(losses.peak_force)
    part = mean / float(losses.mean_total_force_ratio)
    share = (1 / float(losses.efficiency) - 1) / float(losses.mean_total_force_ratio)
    pin, hole = (
        None if each is None else each * peak for each in (losses.pin_wear, losses.hole_wear)
    )
    error = turn.error + losses.accuracy.relative_error
    return replace(
        losses,
        peak_force=losses.peak_force * peak,
        peak_pv=losses.peak_pv * peak,
        pin_wear=pin,
        hole_wear=hole,
        mean_total_force_ratio=mean,
        mean_loss=losses.mean_loss * part,
        efficiency=1 / (1 + share * mean),
        min_efficiency=1 / (1 + share * most),
        max_efficiency=1 / (1 + share * least),
        mean_pv=losses.mean_pv * part,
        friction_couple=losses.friction_couple * part,
        accuracy=Accuracy("sampling", error, turn.evaluations),
    )
