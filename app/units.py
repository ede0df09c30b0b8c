"""Conversion between names and units of the API and those of the core, which are SI.

A physical quantity's name in the API ends in its unit; the core's name has no unit.
"""

import math
from collections.abc import Callable
from functools import cache
from typing import Any

import numpy as np
from pydantic import BaseModel

from core.codes import CODES

DEGREE = math.pi / 180

Convert = Callable[[Any], Any]

UNITS: dict[str, tuple[str, float]] = {
    "MPa_m_per_s": ("MPa·m/s", 1e6),
    "m_per_s": ("m/s", 1.0),
    "mm3_per_Nm": ("mm³/(N·m)", 1e-9),
    "N_per_mm": ("N/mm", 1e3),
    "mm_per_N": ("mm/N", 1e-3),
    "mrad_per_N": ("mrad/N", 1e-3),
    "kg_mm": ("kg·mm", 1e-3),
    "mm_per_s": ("mm/s", 1e-3),
    "mm": ("mm", 1e-3),
    "Nm": ("N·m", 1.0),
    "N": ("N", 1.0),
    "MPa": ("MPa", 1e6),
    "GPa": ("GPa", 1e9),
    "kg_m3": ("kg/m³", 1.0),
    "kg_m2": ("kg·m²", 1.0),
    "kg": ("kg", 1.0),
    "C": ("°C", 1.0),
    "Nm_per_arcmin": ("N·m/′", 10_800 / math.pi),
    "arcmin": ("′", math.pi / 10_800),
    "mrad": ("mrad", 1e-3),
    "deg": ("°", DEGREE),
    "rpm": ("rpm", math.pi / 30),
    "W": ("W", 1.0),
    "h": ("h", 3600.0),
    "us": ("µs", 1e-6),
}
"""Suffix of a name with the unit as shown and its size in SI units; the longer of two suffixes with
equal ends comes first."""


AT_C = ("deflection_C", "error_C", "reaction_C", "slope_C")
"""Ends of names that mean a place C, not degrees Celsius."""


PLAIN = ("", 1.0)
"""Unit of numbers without a unit."""


@cache
def suffix(field: str) -> str:
    """Unit suffix of an API name; empty for a plain name."""
    if field.endswith(AT_C):
        return ""
    return next((unit for unit in UNITS if field.endswith(f"_{unit}")), "")


@cache
def core_name(field: str) -> str:
    """Name of the quantity in core: the API name without its unit."""
    return field.removesuffix(f"_{suffix(field)}")


def shown_unit(field: str) -> str:
    """Unit as shown to users; empty for a plain name."""
    return UNITS.get(suffix(field), PLAIN)[0]


def _as_it_is(value: Any) -> Any:
    return value


def to_si(field: str, value: Any) -> Any:
    """Value of an API field in SI units, a list as a tuple; None and plain values are unchanged."""
    return value if value is None else to_si_converter(field)(value)


@cache
def to_si_converter(field: str) -> Convert:
    """Function that converts values of an API field to SI units. Dividing by the inverse keeps
    decimal inputs at the nearest double: 8 mm is 0.008 m.
    """
    unit = suffix(field)
    if not unit:
        return _as_it_is
    size = UNITS[unit][1]
    times, over = (size, 1.0) if size >= 1 or size == DEGREE else (1.0, 1 / size)

    def convert(value: Any) -> Any:
        if not isinstance(value, float) and isinstance(value, (list, tuple)):
            return tuple(map(convert, value))
        return value * times / over

    return convert


def from_si(field: str, value: Any) -> Any:
    """Value in SI units as an API field has it, lists and arrays by element; None is unchanged."""
    return value if value is None else from_si_converter(field)(value)


TRIFLE = 2.0**-51
"""Relative change by which a number is shortened: 60, not 59.99999999999999."""


@cache
def from_si_converter(field: str) -> Convert:
    """Function that converts values in SI units to the unit of an API field."""
    size = UNITS.get(suffix(field), PLAIN)[1]
    if size == 1:
        return _as_it_is
    times, over = (1.0, size) if size > 1 else (1 / size, 1.0)

    def convert(value: Any) -> Any:
        if not isinstance(value, float):
            if isinstance(value, (list, tuple)):
                return [*map(convert, value)]
            if isinstance(value, np.ndarray):
                exact = value * times / over
                short = np.rint(exact * 1e9) / 1e9
                return np.where(np.abs(exact - short) <= TRIFLE * np.abs(exact), short, exact)
        exact = value * times / over
        billionths = exact * 1e9
        if not -1e13 < billionths < 1e13:
            short = round(exact, 9)
        elif 0.01 < billionths % 1 < 0.99:
            return exact  # no short number is near
        else:
            short = round(billionths) / 1e9  # a third of the time of `round(exact, 9)`
        return short if abs(exact - short) < TRIFLE * abs(exact) else exact

    return convert


def rounded(values: np.ndarray, digits: int) -> np.ndarray:
    """Numbers rounded to the last of some digits of the largest number."""
    largest = float(np.abs(values).max())
    if not 0 < largest < math.inf:
        return values
    return np.round(values, digits - 1 - math.floor(math.log10(largest)))


QUANTITIES = {"angle": "deg", "position": "mm", "z": "mm", "force": "N", "length": "mm"}
"""Units of quantities that only refusals name: last word of the core's name, and suffix."""


def api_value(name: str, value: float) -> tuple[str, float]:
    """API name and value of a core quantity in SI units, by the last word of its name."""
    unit = QUANTITIES.get(name.rsplit("_", 1)[-1], "")
    field = f"{name}_{unit}".removesuffix("_")
    return field, from_si(field, value)


_API_NAMES: dict[str, str] = {}


def register(model: type[BaseModel]) -> None:
    """Note the API names of a model's fields by their core names."""
    for name in model.model_fields:
        _API_NAMES.setdefault(core_name(name), name)


def field_of(quantity: str) -> str:
    """Name of the field of request or answer that has a quantity of core."""
    return _API_NAMES[quantity]


NAMING = ("field", "other")
"""Parameters of a refusal or notice that are names of fields."""


def api_params(params: dict[str, Any]) -> dict[str, Any]:
    """Parameters of a core's refusal or notice with API names of fields, in API units."""
    return dict(
        (name, _API_NAMES.get(value, value)) if name in NAMING else api_value(name, value)
        for name, value in params.items()
    )


COMPARING = frozenset(
    {
        "at_most",
        "below_working",
        "beyond_support",
        "clearance_dust",
        "greater_than",
        "greater_than_equal",
        "hole_disagrees",
        "in_carrier",
        "larger_than",
        "less_than",
        "less_than_equal",
        "no_cycloid",
        "no_mesh",
        "no_sleeve",
        "other_pitch",
        "smaller_than",
        "too_near",
        "too_thick",
        "undercut",
    }
)
"""Refusals whose `limit` is a value of the refused field, in its unit."""


def refusal_params(
    code: str, params: dict[str, Any], path: tuple[str | int, ...]
) -> dict[str, Any]:
    """Parameters of a core's refusal of the field at a path, as the API names them."""
    found = api_params(params)
    if code in COMPARING:
        field = next((part for part in reversed(path) if isinstance(part, str)), "")
        found["limit"] = from_si(field, params["limit"])
    return found


IN_MILLIMETRES = {
    "cannot_assemble": "Pins and holes press: pin {pin} and its hole of satellite {satellite} lack "
    "{missing_length_mm:.4g} mm of room; holes of a radius of {needed_length_mm:.6g} mm would do",
    "different_sum": "must have lengths that add up to {field} and {other}, "
    "{needed_length_mm:.9g} mm, not {given_length_mm:.9g} mm",
    "no_mechanism": "Holes of a radius of {given_length_mm:.6g} mm do not hold their pins, "
    "which could pass from one into the next: it must be less than {limit_length_mm:.6g} mm",
}
"""Codes of the core with lengths, in the API's unit."""


def sentence(code: str, params: dict[str, Any]) -> str:
    """Text of a code of the core, with API names."""
    return (IN_MILLIMETRES.get(code) or CODES[code].text).format(**params)
