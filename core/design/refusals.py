"""Refusals of calculations that name the field of a design with its section."""

import re
from collections.abc import Callable
from typing import TypeVar

from core.design.document import Design, value_at
from core.errors import InvalidInput

Result = TypeVar("Result")

SHARED = ("mechanism", "load", "contact")
"""Sections whose values many calculations take."""


def named(design: Design, section: str, calculation: Callable[[], Result]) -> Result:
    """Result of a calculation; its `InvalidInput` is raised again with the section before the
    field.

    `section` is searched for the field first, then the sections in `SHARED`.
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
