"""Fatigue of a pin by the stress cycle of its worst point."""

from dataclasses import dataclass

from core.fatigue import CycleFatigue, FatigueStrength, judge_cycle
from core.fields import answer
from core.precision import ROUNDING

NOTHING = 16 * ROUNDING
"""Stress over a larger one that is only rounding."""

__all__ = ["FatigueStrength", "PinFatigue", "judged"]


@dataclass(frozen=True, slots=True, kw_only=True)
class PinFatigue(CycleFatigue):
    """Worst stress cycle of a pin, one for each turn of the crank against the output."""

    direction: float | None = answer("deg", "χ")
    """Direction of the worst point of the section, measured from the tangential direction towards
    growing pressure angles; absent if the pin rotates."""
    position: float = answer("mm", "x")
    """Distance of the section from the carrier's face."""
    cycles: float | None = answer("", "N")
    """Number of cycles to failure, one cycle per turn of the crank relative to the pins; absent
    below the endurance limit."""
    life: float | None = answer("h", "L")
    """Time to failure by that number of cycles; absent below the endurance limit or without a
    speed."""


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
