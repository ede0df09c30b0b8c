"""Fatigue of a pin by the stress cycle of its worst point."""

from dataclasses import dataclass

from core.fatigue import CycleFatigue, FatigueStrength, judge_cycle
from core.precision import ROUNDING

NOTHING = 16 * ROUNDING
"""Stress over a larger one that is only rounding."""

__all__ = ["FatigueStrength", "PinFatigue", "judged"]


@dataclass(frozen=True, slots=True, kw_only=True)
class PinFatigue(CycleFatigue):
    """Worst stress cycle of a pin, one for each turn of the crank against the output."""

    # Direction chi of the point on the section's edge from the tangential direction, towards
    # growing pressure angles, rad, 0 to 2*pi; None if the pin rotates, so that all are alike.
    direction: float | None
    position: float  # distance of the section from the carrier's face, m
    life: float | None  # life, s, if finite and the speed is known


def judged(
    *,
    strength: FatigueStrength,
    direction: float | None,
    position: float,
    largest: float,
    least: float,
) -> PinFatigue:
    """Fatigue of a stress cycle between `largest` and `least`, Pa, without a life as time.

    An end within `NOTHING` of the other's size counts as 0, as of a pin that is unloaded for a
    time.
    """
    nothing = NOTHING * max(abs(largest), abs(least))
    largest, least = (0.0 if abs(each) <= nothing else each for each in (largest, least))
    cycle = judge_cycle(strength=strength, largest=largest, least=least)
    own = {name: getattr(cycle, name) for name in CycleFatigue.__dataclass_fields__}
    return PinFatigue(**own, direction=direction, position=position, life=None)
