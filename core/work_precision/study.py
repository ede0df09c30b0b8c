"""Error against run time: a table of methods, run at their settings and compared with a reference.

A calculation gives its exact value and a table of `Method`; `work_precision` does the rest.
"""

import cmath
import statistics
import time
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from core.fields import answer, answered

REFERENCE_DIGITS = 40
"""Digits of a reference in multiple precision."""

SETTINGS = {
    "default": "default",
    "pieces": "{value} pieces",
    "positions": "{value} positions",
    "points": "n = {value}",
}
"""Settings of methods in English, by code."""

Outcome = tuple[complex, int]
"""A value, or the vector x + i*y, and the evaluations of the function behind it."""

_REPEATS, _BUDGET_S = 7, 0.02


@dataclass(frozen=True, slots=True)
class Method:
    """A way to calculate a quantity, at one or several settings."""

    code: str  # a key of `core.errors.METHODS`
    function: Callable[[Any], Outcome]  # `Outcome` at the value of a setting
    setting: str = "default"  # a key of `SETTINGS`
    values: Sequence[float] = (0.0,)  # values of the setting that it is run at


@dataclass(frozen=True, slots=True, kw_only=True)
class WorkPoint:
    """One method at one setting."""

    method: str = answer()
    """Method, in English."""
    setting: str = answer()
    """Setting that is varied, in English."""
    value: float  # number of samples, nodes or pieces
    relative_error: float = answer()
    """Relative error against the reference."""
    run_time: float = answer("us")
    """Run time."""
    evaluations: int = answer()
    """Number of evaluations of the method's function."""


@dataclass(frozen=True, slots=True)
class Reference:
    """Value against which errors are measured."""

    method: str = answer()
    """Method of the reference, in English."""
    digits: int = answer(default=REFERENCE_DIGITS)
    """Number of correct decimal digits."""


@dataclass(frozen=True, slots=True)
class WorkPrecision:
    """Error against run time of the methods of a calculation."""

    reference: Reference = answer()
    """Reference against which the errors are measured."""
    points: tuple[WorkPoint, ...] = answer()
    """Results of every method at each of its settings."""

    @property
    @answered()
    def chosen(self) -> WorkPoint:
        """Method that the calculators use."""
        return self.points[-1]


def work_precision(*, reference: Reference, exact: Any, methods: Iterable[Method]) -> WorkPrecision:
    """Error against run time of each method at each of its settings. The exact value is a number of
    mpmath; the last method is that of the calculators. A method is left out where its value is not
    finite.
    """
    measured = (_measured(method, value, exact) for method in methods for value in method.values)
    return WorkPrecision(reference, tuple(point for point in measured if point))


def _measured(method: Method, setting: float, exact: Any) -> WorkPoint | None:
    """A method at a setting, compared and timed; None where it gives no finite number."""
    import mpmath

    times: list[float] = []
    began = time.perf_counter()
    while len(times) < _REPEATS and (not times or time.perf_counter() - began < _BUDGET_S):
        start = time.perf_counter_ns()
        with np.errstate(all="ignore"):  # a method may fail here: it is left out below
            value, evaluations = method.function(setting)
        times.append((time.perf_counter_ns() - start) * 1e-9)
    if not cmath.isfinite(value):
        return None
    return WorkPoint(
        method=method.code,
        setting=method.setting,
        value=setting,
        relative_error=float(abs(mpmath.mpmathify(value) - exact) / abs(exact)),
        run_time=statistics.median(times),
        evaluations=evaluations,
    )
