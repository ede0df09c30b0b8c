"""The one conversion between the units of the API and SI.

A physical quantity's name in the API ends in its unit; the name without it is the core's.
"""

import math
from typing import Any

import numpy as np

UNITS: dict[str, tuple[str, float]] = {
    "N_per_mm": ("N/mm", 1e3),
    "mm": ("mm", 1e-3),
    "Nm": ("N·m", 1.0),
    "N": ("N", 1.0),
    "MPa": ("MPa", 1e6),
    "GPa": ("GPa", 1e9),
    "deg": ("°", math.pi / 180),
}
"""Suffix of a name: unit as shown, and its size in SI units."""


def suffix(field: str) -> str | None:
    """Unit suffix of an API name; None for a plain name."""
    return next((unit for unit in UNITS if field.endswith(f"_{unit}")), None)


def core_name(field: str) -> str:
    """Name of the quantity in core: the API name without its unit."""
    unit = suffix(field)
    return field if unit is None else field[: -len(unit) - 1]


def shown_unit(field: str) -> str:
    """Unit as shown to people; empty for a plain name."""
    unit = suffix(field)
    return "" if unit is None else UNITS[unit][0]


def to_si(field: str, value: Any) -> Any:
    """Value of an API field in SI units; lists element by element.

    Dividing by the inverse keeps decimal inputs at the nearest double: 8 mm is 0.008 m.
    """
    unit = suffix(field)
    if unit is None or value is None:
        return value
    if isinstance(value, (list, tuple)):
        return [to_si(field, each) for each in value]
    size = UNITS[unit][1]
    return value * size if size >= 1 or unit == "deg" else value / (1 / size)


def from_si(field: str, value: Any) -> Any:
    """Value in SI units as an API field carries it; arrays become lists."""
    unit = suffix(field)
    if isinstance(value, np.ndarray):
        if unit == "deg":
            return np.round(np.degrees(value), DECIMALS_OF_DEGREES).tolist()
        return (value if unit is None else _from_si(unit, value)).tolist()
    if unit is None or value is None:
        return value
    if isinstance(value, (list, tuple)):
        return [from_si(field, each) for each in value]
    return float(f"{_from_si(unit, value):.15g}") if unit in NOISY else _from_si(unit, value)


NOISY = ("deg", "mm")
"""Units whose conversion leaves noise in the 16th digit: 60 degrees, not 59.99999999999999."""

DECIMALS_OF_DEGREES = 12
"""To which arrays of angles are rounded, against the same noise."""

QUANTITIES = {"angle": "deg", "position": "mm", "force": "N"}
"""Units of quantities that only refusals name: last word of the core's name to its suffix."""


def api_value(name: str, value: float) -> tuple[str, float]:
    """API name and value of a core quantity in SI units, by the last word of its name."""
    unit = QUANTITIES.get(name.rsplit("_", 1)[-1])
    field = name if unit is None else f"{name}_{unit}"
    return field, from_si(field, value)


def _from_si(unit: str, value: Any) -> Any:
    """The inverse of `to_si`, with the same care for the nearest double."""
    size = UNITS[unit][1]
    return value / size if size >= 1 else value * (1 / size)
