"""One function for a number and for arrays of designs.

Each function here looks at its operand: plain floats go to `math` (some 50 ns), everything else to
NumPy, so that a formula is written once and serves one design in microseconds and millions of
designs a second. Arrays may have any leading axes and broadcast as NumPy's do.
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
"""A quantity of one design (float) or of many (`FloatArray`); a union of the two would know no
arithmetic to a type checker."""

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
    """The larger of two quantities.

    Parameters
    ----------
    x, y : float or array
        The two.

    Returns
    -------
    float or array
    """
    return max(x, y) if isinstance(x, float) and isinstance(y, float) else np.maximum(x, y)


def smaller(x: Any, y: Any) -> Any:
    """The smaller of two quantities.

    Parameters
    ----------
    x, y : float or array
        The two.

    Returns
    -------
    float or array
    """
    return min(x, y) if isinstance(x, float) and isinstance(y, float) else np.minimum(x, y)


def ascending(values: Sequence[Any]) -> list[Any]:
    """Quantities in ascending order, design by design.

    Parameters
    ----------
    values : sequence of float or array
        The quantities.

    Returns
    -------
    list of float or array
        The smallest first.
    """
    if all(isinstance(each, float) for each in values):
        return sorted(values)
    return [*np.sort(np.stack(np.broadcast_arrays(*values)), axis=0)]


def where(condition: Any, x: Any, y: Any) -> Any:
    """One quantity where a condition holds, another where not; both are computed.

    Parameters
    ----------
    condition : bool or array of bool
        The condition.
    x, y : float or array
        The two.

    Returns
    -------
    float or array
    """
    if isinstance(condition, bool):
        return x if condition else y
    return np.where(condition, x, y)


def known_where(condition: Any, x: Any) -> Any:
    """A quantity where it is known; elsewhere None of one design, NaN in arrays.

    Parameters
    ----------
    condition : bool or array of bool
        Where it is known.
    x : float or array
        The quantity.

    Returns
    -------
    float, array or None
    """
    if isinstance(condition, bool):
        return x if condition else None
    return np.where(condition, x, np.nan)


def every(condition: Any) -> bool:
    """Whether a condition holds for all designs.

    Parameters
    ----------
    condition : bool or array of bool
        The condition.
    """
    return condition if isinstance(condition, bool) else bool(condition.all())


def some(condition: Any) -> bool:
    """Whether a condition holds for any design.

    Parameters
    ----------
    condition : bool or array of bool
        The condition.
    """
    return condition if isinstance(condition, bool) else bool(condition.any())


def check_positive(**values: Number) -> None:
    """Refuse quantities that are not larger than 0.

    Parameters
    ----------
    **values : float or array
        Quantities by their names.

    Raises
    ------
    InvalidInput
        If one is; of an array the first such entry is named.
    """
    for name, value in values.items():
        allowed = value > 0
        if allowed is not True and not every(allowed):
            refuse(name, value, allowed, "greater_than", limit=0)


def check_not_negative(**values: Number) -> None:
    """Refuse quantities below 0.

    Parameters
    ----------
    **values : float or array
        Quantities by their names.

    Raises
    ------
    InvalidInput
        If one is; of an array the first such entry is named.
    """
    for name, value in values.items():
        allowed = value >= 0
        if allowed is not True and not every(allowed):
            refuse(name, value, allowed, "greater_than_equal", limit=0)


def check_single(**values: Number | None) -> None:
    """Refuse arrays where one design is searched or solved at a time.

    Parameters
    ----------
    **values : float or None
        Quantities by their names.

    Raises
    ------
    InvalidInput
        If one is an array, even of one number.

    Examples
    --------
    >>> check_single(diameter=np.array([0.016, 0.017]))
    Traceback (most recent call last):
    core.errors.InvalidInput: diameter = array([0.016, 0.017]) must be one number, not an array
    """
    for name, value in values.items():
        if isinstance(value, np.ndarray):
            raise InvalidInput(name, value, "not_single")


def check_finite(**values: Number) -> None:
    """Refuse quantities that are infinite or no number.

    Parameters
    ----------
    **values : float or array
        Quantities by their names.

    Raises
    ------
    InvalidInput
        If one is; of an array the first such entry is named.
    """
    for name, value in values.items():
        allowed = abs(value) < math.inf
        if allowed is not True and not every(allowed):
            refuse(name, value, allowed, "finite_number")


def _entry(value: Any, index: Any, like: Any) -> Any:
    """Entry of an array that is as large as another, or what is no array."""
    return np.broadcast_to(value, np.shape(like))[index] if np.ndim(value) else value


def refuse(name: str, value: Any, allowed: Any, code: str, **params: object) -> None:
    """Refuse a quantity, or the first entry of an array that is not allowed.

    Parameters
    ----------
    name : str
        Its name.
    value : float or array
        The quantity.
    allowed : bool or array of bool
        Where it is allowed.
    code : str
        What is wrong with it, see `core.codes.CODES`.
    **params : object
        What its text names; of an array the entry there.

    Raises
    ------
    InvalidInput
        Always.
    """
    if np.ndim(allowed):
        first = np.unravel_index(int(np.argmin(allowed)), np.shape(allowed))
        name, value = f"{name}[{','.join(map(str, first))}]", _entry(value, first, allowed)
        params = {key: _entry(each, first, allowed) for key, each in params.items()}
    params = {key: x.item() if isinstance(x, np.generic) else x for key, x in params.items()}
    raise InvalidInput(name, value, code, **params)
