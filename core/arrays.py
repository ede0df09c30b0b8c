"""Functions that take a number or an array of designs, and the types of arrays.

Each function looks at its operand: plain floats go to `math` (some 50 ns), everything else to
NumPy. One formula thus serves a single design in microseconds and millions of designs a second.
Arrays may have any leading axes and broadcast as NumPy's do.
"""

import math
from collections.abc import Callable, Sequence
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from core.errors import InvalidInput

FloatArray = NDArray[np.float64]
ComplexArray = NDArray[np.complex128]
IntArray = NDArray[np.intp]
BoolArray = NDArray[np.bool_]

Number: TypeAlias = Any
"""Quantity of one design (float) or of many (`FloatArray`); `Any`, as type checkers reject
arithmetic on a union of both."""

Vector = tuple[float, float, float]
"""x, y, z."""


def _either(plain: Callable[[float], float], many: Callable[[Any], Any]) -> Callable[[Any], Any]:
    def function(x: Any) -> Any:
        return plain(x) if isinstance(x, float) else many(x)

    function.__name__ = function.__qualname__ = plain.__name__
    function.__doc__ = f"`math.{plain.__name__}` of a number, element by element of an array."
    return function


sqrt = _either(math.sqrt, np.sqrt)
atan = _either(math.atan, np.arctan)
atanh = _either(math.atanh, np.arctanh)
log = _either(math.log, np.log)
log1p = _either(math.log1p, np.log1p)


def larger(x: Any, y: Any) -> Any:
    """Larger of two numbers, or of two arrays element by element."""
    return max(x, y) if isinstance(x, float) and isinstance(y, float) else np.maximum(x, y)


def smaller(x: Any, y: Any) -> Any:
    """Smaller of two numbers, or of two arrays element by element."""
    return min(x, y) if isinstance(x, float) and isinstance(y, float) else np.minimum(x, y)


def ascending(values: Sequence[Any]) -> list[Any]:
    """Quantities in ascending order; arrays are sorted design by design."""
    if all(isinstance(each, float) for each in values):
        return sorted(values)
    return [*np.sort(np.stack(np.broadcast_arrays(*values)), axis=0)]


def where(condition: Any, x: Any, y: Any) -> Any:
    """x where a condition holds, else y, of numbers or arrays; both are computed beforehand."""
    if isinstance(condition, bool):
        return x if condition else y
    return np.where(condition, x, y)


def known_where(condition: Any, x: Any) -> Any:
    """x if the condition holds, else None for one design and NaN in arrays."""
    if isinstance(condition, bool):
        return x if condition else None
    return np.where(condition, x, np.nan)


def every(condition: Any) -> bool:
    """True if a condition holds for all designs."""
    return condition if isinstance(condition, bool) else bool(condition.all())


def some(condition: Any) -> bool:
    """True if a condition holds for any design."""
    return condition if isinstance(condition, bool) else bool(condition.any())


def check_positive(**values: Number) -> None:
    """Refuse quantities, given by name, not above 0; the first such entry of an array is named."""
    for name, value in values.items():
        allowed = value > 0
        if allowed is not True and not every(allowed):
            refuse(name, value, allowed, "greater_than", limit=0)


def check_not_negative(**values: Number) -> None:
    """Refuse quantities, given by name, below 0; the first such entry of an array is named."""
    for name, value in values.items():
        allowed = value >= 0
        if allowed is not True and not every(allowed):
            refuse(name, value, allowed, "greater_than_equal", limit=0)


def check_single(**values: Number | None) -> None:
    """Refuse arrays, even of one number, for functions that solve one design at a time.

    >>> check_single(diameter=np.array([0.016, 0.017]))
    Traceback (most recent call last):
    core.errors.InvalidInput: diameter = array([0.016, 0.017]) must be one number, not an array
    """
    for name, value in values.items():
        if isinstance(value, np.ndarray):
            raise InvalidInput(name, value, "not_single")


def check_count(expected: int, **lists: Sequence[object]) -> None:
    """Refuse lists, given by name, of another length."""
    for name, values in lists.items():
        if len(values) != expected:
            counts = {"expected": expected, "actual": len(values)}
            raise InvalidInput(name, values, "different_length", **counts)


def check_finite(**values: Number) -> None:
    """Refuse quantities, given by name, that are infinite or NaN; the first such entry is named."""
    for name, value in values.items():
        allowed = abs(value) < math.inf
        if allowed is not True and not every(allowed):
            refuse(name, value, allowed, "finite_number")


def _entry(value: Any, index: Any, like: Any) -> Any:
    """Entry of an array that broadcasts to the shape of another; a number is its own entry."""
    return np.broadcast_to(value, np.shape(like))[index] if np.ndim(value) else value


def refuse(name: str, value: Any, allowed: Any, code: str, **params: object) -> None:
    """Raise `InvalidInput` for a quantity, or for the first entry of an array that is not allowed.

    `allowed` is False where the quantity is refused, `code` a key of `core.codes.CODES`; `params`
    fill in the code's text, arrays among them with the refused entry.
    """
    if np.ndim(allowed):
        first = np.unravel_index(int(np.argmin(allowed)), np.shape(allowed))
        name, value = f"{name}[{','.join(map(str, first))}]", _entry(value, first, allowed)
        params = {key: _entry(each, first, allowed) for key, each in params.items()}
    params = {key: x.item() if isinstance(x, np.generic) else x for key, x in params.items()}
    raise InvalidInput(name, value, code, **params)
