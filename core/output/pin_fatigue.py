"""Fatigue of a pin: the cycle of its worst point."""

from dataclasses import dataclass

from core.fatigue import CycleFatigue, FatigueStrength, judge_cycle
from core.precision import ROUNDING

NOTHING = 16 * ROUNDING
"""A stress beside a larger one that is rounding only."""

__all__ = ["FatigueStrength", "PinFatigue", "judged"]


@dataclass(frozen=True, slots=True, kw_only=True)
class PinFatigue(CycleFatigue):
    """The worst stress cycle of a pin; one a turn of the crank against the output."""

    # Direction chi of the point of the section's edge from the tangential one, towards growing
    # pressure angles, rad, 0 to 2*pi; None where the pin rotates and all are alike.
    direction: float | None
    position: float  # of the section from the carrier's face, m
    life: float | None  # its cycles as time, s, where finite and the speed is known


def judged(
    *,
    strength: FatigueStrength,
    direction: float | None,
    position: float,
    largest: float,
    least: float,
) -> PinFatigue:
    """The fatigue of a cycle of stress.

    Parameters
    ----------
    strength : FatigueStrength
        What it is judged by.
    direction : float or None
        Direction of the point of the section's edge, rad; None where all are alike.
    position : float
        Distance of the section from the carrier's face, m.
    largest, least : float
        Ends of the cycle, Pa.

    Returns
    -------
    PinFatigue
        Without a life as time; an end of the cycle within `NOTHING` of the other is 0, as of a pin
        that is unloaded for a part of the turn.
    """
    nothing = NOTHING * max(abs(largest), abs(least))
    largest, least = (0.0 if abs(each) <= nothing else each for each in (largest, least))
    cycle = judge_cycle(strength=strength, largest=largest, least=least)
    own = {name: getattr(cycle, name) for name in CycleFatigue.__dataclass_fields__}
    return PinFatigue(**own, direction=direction, position=position, life=None)
