"""Functions of core on a load of pins, with the fields of the load among their arguments, so that
tests may change them one by one.
"""

from collections.abc import Callable
from dataclasses import fields
from functools import wraps
from typing import Any

from core.crank import crankshaft as _crankshaft
from core.crank import pin_rollers as _pin_rollers
from core.crank import satellite_bearing as _satellite_bearing
from core.output import losses as _losses
from core.output import pin_strength as _pin_strength
from core.output.pin_circle_load import PinCircleLoad

LOAD = [field.name for field in fields(PinCircleLoad)]


def loaded(function: Callable[..., Any]) -> Callable[..., Any]:
    """The function with the fields of its load as arguments."""

    @wraps(function)
    def called(**given: Any) -> Any:
        load = {name: given.pop(name) for name in LOAD if name in given}
        return function(load=PinCircleLoad(**load), **given)

    return called


crankshaft = loaded(_crankshaft.crankshaft)
pin_losses = loaded(_losses.pin_losses)
pin_rollers = loaded(_pin_rollers.pin_rollers)
pin_stresses = loaded(_pin_strength.pin_stresses)
satellite_bearings = loaded(_satellite_bearing.satellite_bearings)


def pin_strength(
    *,
    rotates: bool = False,
    fatigue: Any = None,
    input_speed: float | None = None,
    locus: bool = False,
    **given: Any,
) -> Any:
    """Strength of pins by the arguments of their stresses and of their strength."""
    judged = {"rotates": rotates, "fatigue": fatigue, "input_speed": input_speed, "locus": locus}
    return pin_stresses(**given).strength(**judged)
