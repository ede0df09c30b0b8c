"""A calculation for a request, timed; its refusals in the request's own names."""

import re
import time
from collections.abc import Callable
from typing import TypeVar

from app.model import RequestModel, api_params
from app.problems import Problem, impossible, pointer, refusal
from app.record import at_hand
from app.units import from_si
from core.errors import ImpossibleMechanism, InvalidInput, NotKnown

Result = TypeVar("Result")

COMPARING = frozenset(
    {
        "at_most",
        "below_working",
        "beyond_support",
        "greater_than",
        "greater_than_equal",
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


def timed(calculation: Callable[[], Result]) -> tuple[Result, float]:
    """Result of a calculation and its run time, microseconds to a tenth."""
    start = time.perf_counter_ns()
    result = calculation()
    return result, (time.perf_counter_ns() - start) // 100 / 10


def calculated(body: RequestModel, calculation: Callable[[], Result]) -> Result:
    """What is calculated of a request, whose record has how long it took; a refusal names the
    body's fields.
    """
    try:
        result, run_time_us = timed(calculation)
    except InvalidInput as error:
        raise named(error, body) from error
    except NotKnown as error:
        if error.refusal is None:  # what a section needs is required of its request
            raise
        raise named(error.refusal, body) from error
    except ImpossibleMechanism as error:
        if not error.parameter:
            raise
        place = pointer(path_of(body, error.parameter))
        raise impossible(error, place) from error
    if record := at_hand.get():
        record.calculation_took(run_time_us)
    return result


def named(error: InvalidInput, body: RequestModel) -> Problem:
    """A refusal of the core in the names of a request's fields."""
    path = path_of(body, error.parameter)
    params = api_params(error.params)
    if error.code in COMPARING:
        field = next((part for part in reversed(path) if isinstance(part, str)), "")
        params["limit"] = from_si(field, params["limit"])
    return refusal(pointer(path), error.code, **params)


def path_of(body: RequestModel, parameter: str) -> tuple[str | int, ...]:
    """Path of the field of a core parameter in a request, ``rollers[2].z_max`` included; empty
    where it has none.
    """
    path = body.core_paths.get(parameter, ())
    if path or "[" not in parameter:
        return path
    parts = re.findall(r"[^.\[\]]+", parameter)
    own = [part for part in parts if not part.isdigit()]
    path = body.core_paths.get(".".join(own), ())
    if not path:
        return path
    above = len(path) - len(own)
    names = iter(path[above:])
    return (*path[:above], *(int(part) if part.isdigit() else next(names) for part in parts))
