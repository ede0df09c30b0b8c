"""Worked steps of an answer: steps of the core with API names and units."""

import math
from collections.abc import Mapping, Sequence
from typing import Any

from app.units import core_name, field_of, from_si, shown_unit
from core.worked.step import Step
from core.worked.words import OTHERS, VALUES

Values = dict[str, Any]
"""Step as it is sent."""

Steps = Mapping[str, Sequence[Step]]
"""Steps by section of an answer."""

_NAMES = {core_name(name): name for name in (*VALUES, *OTHERS.split())}


def api_name(quantity: str) -> str:
    """API name of a core quantity, with its unit at the end.

    >>> api_name("line_load"), api_name("ratio")
    ('line_load_N_per_mm', 'ratio')
    """
    return _NAMES.get(quantity) or field_of(quantity)


def step_values(section: str, step: Step) -> Values:
    """Values of a step of a section."""
    code = api_name(step.code)
    names = {symbol: api_name(amount.quantity) for symbol, amount in step.values.items()}
    values: Values = {
        "section": section,
        "code": code,
        "symbol": step.symbol,
        "names": names,
        "values": {
            symbol: from_si(names[symbol], amount.value) for symbol, amount in step.values.items()
        },
        "result": from_si(code, step.result),
        "unit": shown_unit(code),
    }
    for name in ("formula", "method", "source", "equation", "erratum", "note"):
        if text := getattr(step, name):
            values[name] = text
    if step.params:
        values["params"] = dict(step.params)
    return values


def worked(sections: Steps) -> list[Values]:
    """Steps of an answer, section after section, without those of infinite results."""
    return [
        step_values(section, step)
        for section, steps in sections.items()
        for step in steps
        if math.isfinite(step.result)
    ]


def stated(section: str, values: Values, method: str) -> list[Values]:
    """Steps of the numbers of a section's answer that all follow by one method."""
    return [
        {
            "section": section,
            "code": name,
            "symbol": core_name(name),
            "names": {},
            "values": {},
            "result": float(value),
            "unit": shown_unit(name),
            "method": method,
        }
        for name, value in values.items()
        if isinstance(value, (int, float)) and not isinstance(value, bool)
    ]
