"""Refusals of arrays of designs: the first entry that is out of range is named."""

import numpy as np
from numpy.typing import NDArray

from core.contact_force import FloatArray
from core.errors import InvalidInput


def first_where(wrong: NDArray[np.bool_]) -> int | None:
    """Index of the first entry that is wrong, if one is."""
    return int(np.argmax(wrong)) if wrong.any() else None


def check_finite(**arrays: FloatArray) -> None:
    """Refuse arrays of designs, shape (n, ...), with an entry that is not a finite number.

    Raises
    ------
    InvalidInput
        If there is one; array and index of the design are named.
    """
    for name, array in arrays.items():
        largest = np.abs(array).max(axis=tuple(range(1, array.ndim)), initial=0.0)
        _refuse(name, array, ~np.isfinite(largest), "must be finite")


def check_positive(**arrays: FloatArray) -> None:
    """Refuse arrays with an entry that is not larger than 0.

    Raises
    ------
    InvalidInput
        If there is one; array and index are named.
    """
    for name, array in arrays.items():
        _refuse(name, array, ~(array > 0), "must be larger than 0")


def check_not_negative(**arrays: FloatArray) -> None:
    """Refuse arrays with an entry that is below 0 or no number.

    Raises
    ------
    InvalidInput
        If there is one; array and index are named.
    """
    for name, array in arrays.items():
        _refuse(name, array, ~(array >= 0), "must not be negative")


def _refuse(name: str, array: FloatArray, wrong: NDArray[np.bool_], limit: str) -> None:
    if (index := first_where(wrong)) is not None:
        raise InvalidInput(f"{name}[{index}]", array[index], limit)
