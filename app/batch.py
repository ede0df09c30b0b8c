"""POST /batch: many requests of one calculation, in slices that are handed to processes."""

import time
from collections.abc import AsyncIterator
from functools import partial
from typing import TYPE_CHECKING, Annotated, Any, Literal

import orjson
from fastapi import APIRouter, Request
from fastapi.responses import Response
from pydantic import FailFast, Field, StringConstraints
from pydantic_core import from_json, to_json

from app.content import encoded
from app.endpoint import (
    JSON,
    LINES,
    AsItComes,
    admitted,
    answered,
    by_lines,
    read_body,
    received,
    take_place,
)
from app.examples import REQUESTS
from app.jobs import Job, Jobs, Stopped, TooLong
from app.model import MAX_NAME, Calculation, Maybe, RequestModel, ResponseModel
from app.problems import (
    RESPONSES,
    Problem,
    ProblemOut,
    impossible,
    problem_of,
    refusal,
    too_large,
    too_long,
)
from app.processes import Tell, in_parts, in_process, wanted
from app.record import Record, at_hand
from app.registry import CALCULATIONS
from app.settings import Settings
from core.errors import ImpossibleMechanism, InvalidInput

FIRST_SLICE = 50
"""Number of requests in the first slice; later slices have twice as many as were done in time."""

SLICE_S = 0.25
"""Time after which a process returns finished answers, s, so that answers flow and others have a
turn."""

SLICE_BYTES = 1 << 20
"""Size of answers after which a process returns them, as a client may take them slowly."""

MAX_ERRORS = 100
"""Largest number of wrong fields named in a batch; beyond it problems state how many are left
out."""


MAX_REQUESTS = 1_000
"""Largest number of requests in a batch."""

Name = Annotated[str, StringConstraints(max_length=MAX_NAME)]

BATCHED = {name: each for name, each in CALCULATIONS.items() if each.batched}

SPELLINGS = {name: name for name in BATCHED} | {
    "contact_force": "contact-force",
    "crank_planetary": "crank-planetary",
    "roller_strength": "roller-strength",
    "contact_line": "precession/contact-line",
    "meshing_load": "precession/meshing-load",
    "shaft_deflection": "precession/shaft-deflection",
}
"""Names of calculations in a batch, former names included."""

if TYPE_CHECKING:
    Spelling = str
else:
    Spelling = Literal[tuple(SPELLINGS)]


class BatchRequest(RequestModel):
    """Requests of one calculation, each as its own endpoint takes it."""

    calculation: Spelling = Field(json_schema_extra={"enum": [*BATCHED]})
    requests: Annotated[
        list[dict[str, Any]], FailFast(), Field(min_length=1, max_length=MAX_REQUESTS)
    ]

    ids: Maybe[list[Name]] = Field(
        min_length=1,
        max_length=MAX_REQUESTS,
        description="Name of each request, returned with its answer.",
    )

    def refuse_beyond(self, settings: Settings) -> None:
        """Refuse more requests than the operator allows, and names that are not one for each."""
        if len(self.requests) > settings.max_batch:
            raise InvalidInput(
                "requests", len(self.requests), "service_limit", limit=settings.max_batch
            )
        if self.ids is not None and len(self.ids) != len(self.requests):
            count = {"expected": len(self.requests), "actual": len(self.ids)}
            raise InvalidInput("ids", len(self.ids), "different_length", **count)


class BatchItem(ResponseModel):
    """Result of one request, or its problem with pointers into that request."""

    index: Maybe[int] = Field(
        description="Place of the request in the batch, from 0; only in answers by lines."
    )
    id: Maybe[str] = Field(description="Name of the request, if the batch has `ids`.")
    result: Maybe[dict[str, Any]] = Field(description="Answer of the calculation's own endpoint.")
    problem: Maybe[ProblemOut] = None


class BatchResponse(ResponseModel):
    """The answers, in the order of the requests."""

    results: list[BatchItem]


router = APIRouter(tags=["batch"])


@router.post(
    "/batch",
    operation_id="batch",
    responses=RESPONSES | {200: {"content": {LINES: {"schema": {"type": "string"}}}}},
    response_model=BatchResponse,
    openapi_extra={
        "requestBody": {
            "required": True,
            "content": {
                JSON: {"schema": BatchRequest.model_json_schema(), "example": REQUESTS["batch"]}
            },
        }
    },
)
async def batch(request: Request) -> Response:
    """Answers in the order of the requests, each with its result or its problem.

    The header `Accept: application/x-ndjson` asks for a line for each request, numbered from 0 by
    its `index`. Answers of both forms are sent as soon as they are done. An entry of `ids` comes
    back as the `id` of its request.
    """
    record, jobs = at_hand.get() or Record(), request.app.state.jobs
    jobs.admit(record.client)
    content = await received(request, record, record.settings.max_batch_bytes)
    take_place(record)
    async with wanted(request):
        calculation, requests, ids = await in_process(
            jobs, split, content, record.settings, record=record
        )
        done = answers(jobs, partial(lines, name=SPELLINGS[calculation]), requests, record)
        first = await anext(done)  # an error here refuses the batch as a whole
    lines_asked = by_lines(request)
    written = _written(first, done, ids, lines=lines_asked)
    return AsItComes(written, LINES if lines_asked else JSON)


def split(tell: Tell, content: bytes, settings: Settings) -> None:
    """Calculation, requests and names of a batch, each request as JSON of its own."""
    try:
        values = from_json(content)
    except ValueError as error:
        raise refusal("", "json_invalid", error=str(error)) from None
    body = admitted(BatchRequest.model_validate, values, settings)
    enough = settings.max_body_bytes + 1  # one byte more shows that a request is too large
    requests = [to_json(each, inf_nan_mode="constants")[:enough] for each in body.requests]
    tell((body.calculation, requests, body.ids))


async def answers(
    jobs: Jobs, job: Job, requests: list[bytes], record: Record
) -> AsyncIterator[list[bytes]]:
    """Answers as JSON, ``{"result": ...}`` or ``{"problem": ...}``, some at a time. A request whose
    process is killed is tried once more. A request is refused for its time only if it had
    `Settings.max_seconds` for itself.
    """
    settings = record.settings
    limit_s = SLICE_S + settings.max_seconds  # the last one may start at the end of the slice
    done, size, errors, stopped_at = 0, FIRST_SLICE, MAX_ERRORS, -1
    while done < len(requests):
        written: list[bytes] = []
        asked = requests[done : done + size], settings, errors
        try:
            async for line, named in in_parts(
                jobs, job, *asked, record=record, limit_s=limit_s, admitted=True
            ):
                written.append(line)
                errors -= named
        except TooLong:
            written.append(_problem(too_long(settings.max_seconds)))
        except Stopped as stopped:
            culprit = done + len(written)
            if culprit == stopped_at:
                written.append(_problem(problem_of(stopped)))
            stopped_at = culprit
        if written:
            yield written
        done += len(written)
        size = max(1, 2 * len(written))


def lines(tell: Tell, requests: list[bytes], settings: Settings, errors: int, *, name: str) -> None:
    """Answers to as many first requests as time allows, with the number of wrong fields of each."""
    end, size = time.monotonic() + SLICE_S, 0
    for request in requests:
        line, named = _line(CALCULATIONS[name], request, settings, errors)
        tell((line, named))
        errors -= named
        size += len(line)
        if time.monotonic() > end or size > SLICE_BYTES:
            break


def _line(
    calculation: Calculation, request: bytes, settings: Settings, errors: int
) -> tuple[bytes, int]:
    try:
        if len(request) > settings.max_body_bytes:
            raise too_large(settings.max_body_bytes)
        body = read_body(calculation, request, settings)
        return b'{"result":' + encoded(answered(calculation, body)) + b"}", 0
    except ImpossibleMechanism as error:
        problem = impossible(error)
    except Problem as refused:
        problem = refused.naming_at_most(errors)
    return _problem(problem), len(problem.errors)


def _problem(problem: Problem) -> bytes:
    return orjson.dumps({"problem": problem.body()})


async def _written(
    some: list[bytes] | None,
    others: AsyncIterator[list[bytes]],
    ids: list[str] | None,
    *,
    lines: bool,
) -> AsyncIterator[bytes]:
    """Answers with their names, as lines with indices or as one object."""
    place, before = 0, b'{"results":['
    while some is not None:
        for index, answer in enumerate(some):
            if ids is not None:
                answer = b'{"id":%b,%b' % (orjson.dumps(ids[place]), answer[1:])
            some[index] = b'{"index":%d,%b\n' % (place, answer[1:]) if lines else answer
            place += 1
        yield b"".join(some) if lines else before + b",".join(some)
        before, some = b",", await anext(others, None)
    if not lines:
        yield b"]}"
