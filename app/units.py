"""The one conversion between the units of the API and SI.

A physical quantity's name in the API ends in its unit; the name without it is the core's.
"""

import math
from functools import cache
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


@cache
def suffix(field: str) -> str | None:
    """Unit suffix of an API name; None for a plain name."""
    return next((unit for unit in UNITS if field.endswith(f"_{unit}")), None)


@cache
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
    """Value in SI units as an API field carries it; lists and arrays element by element."""
    unit = suffix(field)
    if isinstance(value, np.ndarray):
        return value if unit is None else _array_from_si(unit, value)
    if unit is None or value is None:
        return value
    return _from_si(UNITS[unit][1], value)


def _from_si(size: float, value: Any) -> Any:
    if isinstance(value, (list, tuple)):
        return [_from_si(size, each) for each in value]
    if size >= 1:
        return value / size
    # 60, not 59.99999999999999: the number of 9 decimals within reach of rounding errors.
    exact = value * (1 / size)
    short = round(exact, 9)
    return short if short == exact or abs(exact - short) <= 2 * math.ulp(exact) else exact


def rounded(values: np.ndarray, digits: int) -> np.ndarray:
    """Numbers rounded to the place of the last of so many digits of the largest of them."""
    largest = float(np.abs(values).max())
    if not 0 < largest < math.inf:
        return values
    return np.round(values, digits - 1 - math.floor(math.log10(largest)))


QUANTITIES = {"angle": "deg", "position": "mm", "z": "mm", "force": "N"}
"""Units of quantities that only refusals name: last word of the core's name to its suffix."""


def api_value(name: str, value: float) -> tuple[str, float]:
    """API name and value of a core quantity in SI units, by the last word of its name."""
    unit = QUANTITIES.get(name.rsplit("_", 1)[-1])
    field = name if unit is None else f"{name}_{unit}"
    return field, from_si(field, value)


def _array_from_si(unit: str, value: np.ndarray) -> np.ndarray:
    size = UNITS[unit][1]
    if size >= 1:
        return value / size
    exact = value * (1 / size)
    short = np.round(exact, 9)
    return np.where(np.abs(exact - short) <= 2 * np.spacing(np.abs(exact)), short, exact)
