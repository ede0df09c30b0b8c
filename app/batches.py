"""Many requests of one calculation: in order, in slices that are handed to processes."""

import time
from collections.abc import AsyncIterator, Callable, Iterator
from dataclasses import dataclass

import orjson
from pydantic import ValidationError
from pydantic_core import from_json, to_json

from app.calculation import refusals_named
from app.jobs import Jobs, TooLong, Unfinished
from app.problems import Problem, impossible, too_large, wrong_fields, wrong_json
from app.processes import in_parts, why
from app.record import Record
from app.route import encoded
from app.schemas.base import RequestModel, Values
from app.schemas.batch import BatchRequest
from app.settings import Settings
from core.errors import ImpossibleMechanism

FIRST_SLICE = 50
"""Requests that are handed over first; then twice as many as were done in the time of a slice."""

SLICE_S = 0.25
"""Time after which a process hands back what it has done, so that answers flow and others have
their turn."""

MAX_ERRORS = 100
"""Most wrong fields that the answers of a batch name in all; beyond, problems say how many."""


@dataclass(frozen=True, slots=True)
class Batched:
    """A calculation that can be asked in batches.

    Attributes
    ----------
    model : type of RequestModel
        Its request.
    endpoint : callable
        Its endpoint, a function of a module.
    """

    model: type[RequestModel]
    endpoint: Callable[..., Values]


def split(content: bytes, settings: Settings) -> Iterator[tuple[str, list[bytes]]]:
    """The calculation and the requests of a batch, each as JSON of its own.

    Raises
    ------
    Problem
        If it is no batch, or has more requests than the operator allows.
    """
    try:
        body = BatchRequest.model_validate(from_json(content))
    except ValidationError as error:
        raise wrong_fields(error) from None
    except ValueError as error:
        raise wrong_json(str(error)) from None
    with refusals_named(body):
        body.refuse_beyond(settings)
    enough = settings.max_body_bytes + 1  # to see that a request is too large
    yield (
        body.calculation,
        [to_json(each, inf_nan_mode="constants")[:enough] for each in body.requests],
    )


async def answers(
    jobs: Jobs, batched: Batched, requests: list[bytes], record: Record
) -> AsyncIterator[list[bytes]]:
    """The answers as JSON: ``{"result": ...}`` or ``{"problem": ...}``, some at a time.

    Each request is read and calculated once. Only where its process is killed it is tried once
    more, and only a request that has had `Settings.max_seconds` for itself is refused for its time.
    """
    settings = record.settings
    limit_s = SLICE_S + settings.max_seconds  # the last one may start at the end of the slice
    done, size, errors, stopped_at = 0, FIRST_SLICE, MAX_ERRORS, -1
    while done < len(requests):
        some = requests[done : done + size]
        unfinished: Unfinished | None = None
        try:
            told = await in_parts(
                jobs, _lines, batched, some, settings, errors,
                record=record, limit_s=limit_s, admitted=True,
            )  # fmt: skip
        except Unfinished as error:
            unfinished, told = error, error.parts
        lines = [line for line, _ in told]
        errors -= sum(named for _, named in told)
        if unfinished is not None:
            culprit = done + len(lines)
            if isinstance(unfinished, TooLong) or culprit == stopped_at:
                lines.append(_problem(why(unfinished, record)))
            stopped_at = culprit
        if lines:
            yield lines
        done += len(lines)
        size = max(1, 2 * len(lines))


def _lines(
    batched: Batched, requests: list[bytes], settings: Settings, errors: int
) -> Iterator[tuple[bytes, int]]:
    """Answers to the first requests, to as many as there is time for, and how many wrong fields
    each names.
    """
    end = time.monotonic() + SLICE_S
    for request in requests:
        line, named = _line(batched, request, settings, errors)
        yield line, named
        errors -= named
        if time.monotonic() > end:
            break


def _line(batched: Batched, request: bytes, settings: Settings, errors: int) -> tuple[bytes, int]:
    try:
        body = _body(batched.model, request, settings)
        return b'{"result":' + encoded(batched.endpoint(body)) + b"}", 0
    except ImpossibleMechanism as error:
        problem = impossible(error)
    except Problem as refusal:
        problem = refusal.naming_at_most(errors)
    return _problem(problem), len(problem.errors)


def _body(model: type[RequestModel], request: bytes, settings: Settings) -> RequestModel:
    """A request as its model.

    Raises
    ------
    Problem
        If it is none.
    """
    if len(request) > settings.max_body_bytes:
        raise too_large(settings.max_body_bytes)
    try:
        body = model.model_validate_json(request)
    except ValidationError as error:
        raise wrong_fields(error) from None
    with refusals_named(body):
        body.refuse_beyond(settings)
    return body


def _problem(problem: Problem) -> bytes:
    return orjson.dumps({"problem": problem.body()})
