"""Points of a work-precision study, and how they are measured."""

import math
import statistics
import time
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import Any, Self

import numpy as np

from core.errors import InvalidInput
from core.output.mechanism import Mechanism

REFERENCE_DIGITS = 40
"""Digits of the reference."""

SETTINGS = {
    "default": "default",
    "level": "level {value}",
    "pieces": "{value} pieces",
    "positions": "{value} positions",
    "points": "n = {value}",
    "steps": "{value} steps",
}
"""Settings of methods in English, by code."""

Setting = tuple[str, float]
"""A key of `SETTINGS`, and what it names."""

DEFAULT: Setting = ("default", 0.0)
"""Of a method without a setting."""

_REPEATS = 7
_BUDGET_S = 0.02


@dataclass(frozen=True, slots=True)
class WorkPoint:
    """One method at one setting.

    Attributes
    ----------
    method : str
        Which, a key of `core.results.METHODS`.
    setting : Setting
        Its setting: number of samples, nodes, steps.
    relative_error : float
        Measured relative error against the reference, dimensionless.
    run_time : float
        Median run time, s.
    evaluations : int
        Evaluations of the function behind the method.
    """

    method: str
    setting: Setting
    relative_error: float
    run_time: float
    evaluations: int


@dataclass(frozen=True, slots=True)
class Reference:
    """What the errors are measured against.

    Attributes
    ----------
    method : str
        How it was got, a key of `core.results.METHODS`.
    digits : int
        Digits it was calculated with.
    """

    method: str
    digits: int


@dataclass(frozen=True, slots=True)
class WorkPrecision:
    """Error against run time of the methods of a calculation.

    Attributes
    ----------
    reference : Reference
        What the errors are measured against.
    points : tuple of WorkPoint
        All methods at all settings that can be had.
    chosen : WorkPoint
        The one that the calculators use.
    """

    reference: Reference
    points: tuple[WorkPoint, ...]
    chosen: WorkPoint

    @classmethod
    def against(
        cls, reference: str, *, points: Iterable[WorkPoint | None], chosen: WorkPoint | None
    ) -> Self:
        """Of what can be had, against a reference of `REFERENCE_DIGITS`.

        Parameters
        ----------
        reference : str
            Its method.
        points : iterable of WorkPoint or None
            All methods at all settings; None for those that cannot be had.
        chosen : WorkPoint
            The one that the calculators use, which always can.

        Returns
        -------
        WorkPrecision
        """
        assert chosen is not None
        some = tuple(point for point in points if point is not None)
        return cls(Reference(reference, REFERENCE_DIGITS), some, chosen)


def measured(
    *,
    method: str,
    setting: Setting = DEFAULT,
    calculate: Callable[[], float | Sequence[float]],
    exact: Sequence[Any],
    evaluations: int,
) -> WorkPoint | None:
    """A method's point: its value compared with the exact one, its run time measured.

    Parameters
    ----------
    method : str
        Which.
    setting : Setting
        Its setting.
    calculate : callable
        Returns the value, or the components of a vector.
    exact : sequence of mpmath numbers
        Components of the exact value.
    evaluations : int
        Evaluations of the function behind the method.

    Returns
    -------
    WorkPoint or None
        None where the method gives no finite number on this input.
    """
    import mpmath

    times: list[float] = []
    value: float | Sequence[float] = 0.0
    began = time.perf_counter()
    while len(times) < _REPEATS and (len(times) < 1 or time.perf_counter() - began < _BUDGET_S):
        start = time.perf_counter_ns()
        with np.errstate(all="ignore"):  # a method may fail here: it is left out below
            value = calculate()
        times.append((time.perf_counter_ns() - start) * 1e-9)
    components = [value] if isinstance(value, (int, float)) else list(value)
    if not all(math.isfinite(each) for each in components):
        return None
    size = mpmath.sqrt(sum(each**2 for each in exact))
    off = mpmath.sqrt(
        sum((mpmath.mpf(got) - want) ** 2 for got, want in zip(components, exact, strict=True))
    )
    return WorkPoint(
        method=method,
        setting=setting,
        relative_error=float(off / size),
        run_time=statistics.median(times),
        evaluations=evaluations,
    )


GOLDEN_STEPS = 40
"""Steps after which a summit is as good as doubles can tell."""


def golden_section(*, value: Callable[[Any], Any], low: Any, high: Any, steps: int) -> Any:
    """Largest value between two places, by golden-section search.

    Parameters
    ----------
    value : callable
        Of a place.
    low, high : float or mpmath number
        Ends, about one summit.
    steps : int
        Steps.

    Returns
    -------
    float or mpmath number
    """
    ratio = ((5 + 0 * low) ** 0.5 - 1) / 2  # to as many digits as the place has
    left, right = high - ratio * (high - low), low + ratio * (high - low)
    at_left, at_right = value(left), value(right)
    for _ in range(steps):
        if at_left > at_right:
            high, right, at_right = right, left, at_left
            left = high - ratio * (high - low)
            at_left = value(left)
        else:
            low, left, at_left = left, right, at_right
            right = low + ratio * (high - low)
            at_right = value(right)
    return max(at_left, at_right)


def refuse_many_pairs(*, mechanism: Mechanism, limit: int) -> None:
    """Refuse what its reference would take too long for.

    Parameters
    ----------
    mechanism : Mechanism
        Pins, satellites, ratio.
    limit : int
        Most pairs.

    Raises
    ------
    InvalidInput
        If there are more.
    """
    if mechanism.pins * mechanism.satellites > limit:
        raise InvalidInput(
            "pins",
            mechanism.pins,
            "too_many_pairs",
            limit=limit // mechanism.satellites,
            satellites=mechanism.satellites,
        )
