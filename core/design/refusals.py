"""Refusals of calculations in terms of a design's sections."""

import re
from collections.abc import Callable
from typing import TypeVar

from core.design.document import Design, value_at
from core.errors import InvalidInput

Result = TypeVar("Result")

SHARED = ("mechanism", "load", "contact")
"""Sections whose values many calculations take."""


def named(design: Design, section: str, calculation: Callable[[], Result]) -> Result:
    """A result; a refusal names the field with its section.

    Parameters
    ----------
    design : Design
        The design.
    section : str
        The section that the calculation is of, whose fields come first.
    calculation : callable
        What makes the result; it refuses its own parameters.

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
        field = re.split(r"[.\[]", error.parameter)[0]
        for each in (section, *SHARED):
            if value_at(design, f"{each}.{field}") is not None:
                name = f"{each}.{error.parameter}"
                raise InvalidInput(name, error.value, error.code, **error.params) from error
        raise
