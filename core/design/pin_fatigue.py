"""What the fatigue of a pin is judged by: of the output or of the ring."""

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
    """What the fatigue of a pin is judged by.

    Parameters
    ----------
    design : Design
        The design.
    pin : DesignPin
        The pin.
    loads : callable
        How often it is loaded over a life, s, as far as that is known.

    Returns
    -------
    FatigueStrength

    Raises
    ------
    NotKnown
        Without the yield strength that the criterion needs.
    InvalidInput
        See `core.fatigue`.
    """
    basis = design.fatigue
    if basis.criterion == "soderberg":
        path = f"{pin.material_path}.yield_strength"
        required(pin.material.yield_strength, "yield_unknown", path)
    found = named(design, "fatigue", lambda: basis.strength(pin))
    if not pin.steel or pin.rotates:  # then no cycles are counted
        return found
    return replace(found, cycles=loads(design.life_of(basis)))
