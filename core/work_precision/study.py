"""Error against run time: a table of methods, run at their settings and compared with a reference.

A calculation gives its exact value and a table of `Method`; `work_precision` does the rest.
"""

import math
import statistics
import time
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

REFERENCE_DIGITS = 40
"""Digits of a reference in multiple precision."""

SETTINGS = {
    "default": "default",
    "level": "level {value}",
    "pieces": "{value} pieces",
    "positions": "{value} positions",
    "points": "n = {value}",
}
"""Settings of methods in English, by code."""

Setting = tuple[str, float]
"""A key of `SETTINGS`, and what it names."""

DEFAULT: tuple[Setting] = (("default", 0.0),)
"""Settings of a method that has none."""

Outcome = tuple[float | Sequence[float], int]
"""A value, or the components of a vector, and the evaluations of the function behind it."""

_REPEATS = 7
_BUDGET_S = 0.02


@dataclass(frozen=True, slots=True)
class Method:
    """A way to calculate a quantity, at one or several settings."""

    code: str  # a key of `core.errors.METHODS`
    settings: Sequence[Setting]  # what it is run at
    function: Callable[[Any], Outcome]  # `Outcome` at the value of a setting
    chosen: bool = False  # whether the calculators use it


@dataclass(frozen=True, slots=True)
class WorkPoint:
    """One method at one setting."""

    method: str  # a key of `core.errors.METHODS`
    setting: Setting  # number of samples, nodes or pieces
    relative_error: float  # measured against the reference
    run_time: float  # median, s
    evaluations: int  # how often the function behind the method was evaluated


@dataclass(frozen=True, slots=True)
class Reference:
    """What the errors are measured against."""

    method: str  # a key of `core.errors.METHODS`
    digits: int = REFERENCE_DIGITS  # with which it was calculated


@dataclass(frozen=True, slots=True)
class WorkPrecision:
    """Error against run time of the methods of a calculation."""

    reference: Reference
    points: tuple[WorkPoint, ...]  # all methods at all settings that can be had
    chosen: WorkPoint  # the one that the calculators use


def work_precision(
    *, reference: Reference, exact: Sequence[Any], methods: Iterable[Method]
) -> WorkPrecision:
    """Error against run time of each method at each of its settings.

    Parameters
    ----------
    reference : Reference
        How the exact value was got.
    exact : sequence of mpmath numbers, shape (n,)
        Components of the exact value.
    methods : iterable of Method
        The table; what gives no finite number on this input is left out. One method is chosen,
        which always gives one.

    Returns
    -------
    WorkPrecision
    """
    measured = [
        (method, point)
        for method in methods
        for setting in method.settings
        if (point := _measured(method, setting, exact))
    ]
    *_, chosen = (point for method, point in measured if method.chosen)
    return WorkPrecision(reference, tuple(point for _, point in measured), chosen)


def _measured(method: Method, setting: Setting, exact: Sequence[Any]) -> WorkPoint | None:
    """A method at a setting, compared and timed; None where it gives no finite number."""
    import mpmath

    times: list[float] = []
    began = time.perf_counter()
    while len(times) < _REPEATS and (not times or time.perf_counter() - began < _BUDGET_S):
        start = time.perf_counter_ns()
        with np.errstate(all="ignore"):  # a method may fail here: it is left out below
            value, evaluations = method.function(setting[1])
        times.append((time.perf_counter_ns() - start) * 1e-9)
    components = [value] if isinstance(value, (int, float)) else list(value)
    if not all(math.isfinite(each) for each in components):
        return None
    off = [mpmath.mpf(got) - want for got, want in zip(components, exact, strict=True)]
    return WorkPoint(
        method=method.code,
        setting=setting,
        relative_error=float(mpmath.norm(off) / mpmath.norm(exact)),
        run_time=statistics.median(times),
        evaluations=evaluations,
    )
