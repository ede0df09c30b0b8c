"""Run a calculation for a request: time it, and say its refusals in the request's own names."""

import re
import time
from collections.abc import Callable, Iterator
from functools import cache
from typing import Any, TypeVar, get_args

from pydantic import BaseModel

from app.model import RequestModel, api_params
from app.problems import Problem, pointer, refusal
from app.record import at_hand
from app.units import core_name, from_si
from core.errors import InvalidInput

Result = TypeVar("Result")

COMPARING = frozenset(
    {
        "below_working",
        "beyond_support",
        "greater_than",
        "greater_than_equal",
        "less_than",
        "less_than_equal",
        "no_mesh",
        "other_pitch",
        "too_near",
    }
)
"""Refusals whose `limit` is a value of the refused field, in its unit."""


def run(body: RequestModel, calculation: Callable[[], Result]) -> tuple[Result, float]:
    """Result of a calculation and its run time, microseconds to a tenth; a refusal names the body's
    fields.
    """
    start = time.perf_counter_ns()
    try:
        result = calculation()
    except InvalidInput as error:
        raise named(error, body) from error
    run_time_us = (time.perf_counter_ns() - start) // 100 / 10
    record = at_hand.get()
    if record is not None:
        record.calculation_took(run_time_us)
    return result, run_time_us


def named(error: InvalidInput, body: RequestModel) -> Problem:
    """A refusal of the core in the names of a request's fields."""
    path = path_of(body, error.parameter) or ()
    params = api_params(error.params)
    if error.code in COMPARING:
        field = next((part for part in reversed(path) if isinstance(part, str)), "")
        params["limit"] = from_si(field, params["limit"])
    return refusal(pointer(path), error.code, **params)


def path_of(body: RequestModel, parameter: str) -> tuple[str | int, ...] | None:
    """Path of the field of a core parameter in a request, ``rollers[2].z_max`` included; None where
    it has none.
    """
    head, *rest = _parts(parameter)
    path = body.core_paths.get(head)
    if path is None or not rest:
        return path
    return (*path, *_deeper(body, path, rest))


@cache
def _parts(parameter: str) -> list[str]:
    return re.findall(r"[^.\[\]]+", parameter)


def _deeper(body: BaseModel, path: tuple[str, ...], rest: list[str]) -> Iterator[str | int]:
    """The rest of a path, below a field: indices, and names with the units they have there."""
    value: Any = body
    for part in path:
        value = _within(value, part)
    for part in rest:
        if part.isdigit():
            yield int(part)
            value = value[int(part)] if isinstance(value, list) else None
            continue
        name = part
        if value is not None and not isinstance(value, list):
            model = _model(value)
            name = _field(model, part)
            value = _within(value, name) if name in model.model_fields else None
        yield name


def _model(value: Any) -> type[BaseModel]:
    return value if isinstance(value, type) else type(value)


@cache
def _field(model: type[BaseModel], parameter: str) -> str:
    """The field of a core parameter; its own name where there is none."""
    return next((name for name in model.model_fields if core_name(name) == parameter), parameter)


def _within(value: Any, name: str) -> Any:
    """The model or list that a field of a model holds, else the model that it could hold."""
    model = _model(value)
    found = None if value is model else getattr(value, name)
    return found if isinstance(found, (BaseModel, list)) else _held(model, name)


@cache
def _held(model: type[BaseModel], name: str) -> type[BaseModel] | None:
    """The model that a field may hold, if any."""
    return _model_in(model.model_fields[name].annotation)


def _model_in(annotation: Any) -> type[BaseModel] | None:
    """The model that an annotation allows, if any."""
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        return annotation
    return next(filter(None, map(_model_in, get_args(annotation))), None)
