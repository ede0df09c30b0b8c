"""Many requests of one calculation: in order, in slices that are handed to a process."""

import time
from collections.abc import AsyncIterator, Callable
from dataclasses import dataclass
from typing import Any

import orjson
from pydantic import ValidationError

from app.calculation import refusals_named
from app.problems import Problem, impossible, wrong_fields
from app.processes import in_process
from app.record import Record
from app.route import encoded
from app.schemas.base import RequestModel, Values
from app.settings import Settings
from core.errors import ImpossibleMechanism

SLICE = 1000
"""Most requests that are handed to a process at once."""

SLICE_S = 0.25
"""Time after which a process hands back what it has done, so that answers begin to flow."""


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


async def answers(batched: Batched, requests: list[Any], record: Record) -> AsyncIterator[bytes]:
    """The answers as JSON: ``{"result": ...}`` or ``{"problem": ...}``."""
    waiting = requests
    alone = 0  # so many are calculated each for itself, as one of them takes longer than is allowed
    while waiting:
        some = waiting[: 1 if alone else SLICE]
        try:
            content = await in_process(_some, batched, some, record.settings, record=record)
            done = content.split(b"\n")
        except Problem as problem:
            if len(some) > 1:
                alone = len(some)
                continue
            done, alone = [orjson.dumps({"problem": problem.body()})], 1
        for line in done:
            yield line
        waiting = waiting[len(done) :]
        alone = max(0, alone - len(done))


def _some(batched: Batched, requests: list[Any], settings: Settings) -> bytes:
    """The answers to the first requests, a line each: to as many as there is time for."""
    end = time.monotonic() + SLICE_S
    lines = []
    for request in requests:
        lines.append(_line(batched, _body(batched.model, request, settings)))
        if time.monotonic() > end:
            break
    return b"\n".join(lines)


def _body(model: type[RequestModel], request: Any, settings: Settings) -> RequestModel | Problem:
    """A request as its model, or what is wrong with it."""
    try:
        body = model.model_validate(request)
        with refusals_named(body):
            body.refuse_beyond(settings)
    except ValidationError as error:
        return wrong_fields(error.errors())
    except Problem as refusal:
        return refusal
    return body


def _line(batched: Batched, body: RequestModel | Problem) -> bytes:
    """One answer as JSON."""
    if isinstance(body, RequestModel):
        try:
            result = encoded(batched.endpoint(body))
        except ImpossibleMechanism as error:
            body = impossible(error)
        except Problem as refusal:
            body = refusal
        else:
            return b'{"result":' + result + b"}"
    return orjson.dumps({"problem": body.body()})
