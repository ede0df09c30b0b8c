"""Fatigue strength of a pin of the output or of the ring."""

from collections.abc import Callable
from dataclasses import replace

from core.design.document import Design
from core.design.refusals import named
from core.design.sections import DesignPin
from core.errors import required
from core.output.pin_fatigue import FatigueStrength


def fatigue_of(
    *, design: Design, pin: DesignPin, loads: Callable[[float], float]
) -> FatigueStrength:
    """Fatigue strength of a pin; `loads` gives the number of loads over a life in s.

    Raises NotKnown if the criterion needs a yield strength that is not given.
    """
    basis = design.fatigue
    if basis.criterion == "soderberg":
        path = f"{pin.material_path}.yield_strength"
        required(pin.material.yield_strength, "yield_unknown", path)
    found = named(design, "fatigue", lambda: basis.strength(pin))
    if not pin.steel or pin.rotates:  # cycles are counted for steel pins that stand still
        return found
    return replace(found, cycles=loads(design.life_of(basis)))
