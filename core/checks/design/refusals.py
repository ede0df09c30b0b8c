"""Refusals of calculations in terms of a design's sections."""

from collections.abc import Callable
from typing import TypeVar

from core.errors import InvalidInput

Result = TypeVar("Result")

SECTION_OF = {
    "pin": ("satellite_positions", "span", "diameter"),
    "fatigue": ("reliability_percent",),
    "gear": ("module", "teeth_difference", "ring_pin_circle_radius"),
    "bearing": ("reliability_percent", "ring_factor", "weibull_slope"),
    "crankshaft": ("satellite_positions", "bearing_positions", "satellite_mass"),
}
"""Parameters of calculations that are fields of a section, where others may be called the same."""


def named(*, section: str, calculation: Callable[[], Result]) -> Result:
    """A result; a refusal names the section of the field.

    Parameters
    ----------
    section : str
        The section, a key of `SECTION_OF`.
    calculation : callable
        What makes the result.

    Returns
    -------
    object
        What it makes.

    Raises
    ------
    InvalidInput
        As the calculation does.
    """
    try:
        return calculation()
    except InvalidInput as error:
        if error.parameter.startswith(SECTION_OF[section]):
            name = f"{section}.{error.parameter}"
            raise InvalidInput(name, error.value, error.code, **error.params) from error
        raise
