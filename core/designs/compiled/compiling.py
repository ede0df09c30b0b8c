"""Compilation of loops over designs, when they are first called."""

import hashlib
from collections.abc import Callable
from pathlib import Path
from typing import Any, ParamSpec, TypeVar

import numba

Parameters = ParamSpec("Parameters")
Result = TypeVar("Result")

OPTIONS: dict[str, Any] = {"error_model": "numpy", "nogil": True, "fastmath": {"contract"}}


def part(function: Callable[Parameters, Result]) -> Callable[Parameters, Result]:
    """Compile a function into those that call it.

    Parameters
    ----------
    function : callable
        A function of numbers and arrays.

    Returns
    -------
    callable
    """
    fast: Callable[Parameters, Result] = numba.njit(function, forceinline=True, **OPTIONS)
    return fast


def whole(function: Callable[Parameters, Result]) -> Callable[Parameters, Result]:
    """Compile a function, and keep it on disk where there is a place for it.

    Parameters
    ----------
    function : callable
        A function of numbers and arrays that closes over `sources()`: what is kept is found again
        by what it closes over.

    Returns
    -------
    callable
    """
    try:
        fast: Callable[Parameters, Result] = numba.njit(function, cache=True, **OPTIONS)
    except RuntimeError:  # there is no directory that can be written to
        fast = numba.njit(function, **OPTIONS)
    return fast


def sources() -> str:
    """Digest of all that may be compiled: what is kept is of no use after a change.

    Returns
    -------
    str
    """
    files = sorted(Path(__file__).parents[2].rglob("*.py"))
    return hashlib.sha256(b"".join(file.read_bytes() for file in files)).hexdigest()
