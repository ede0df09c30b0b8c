"""POST /batch: many requests of one calculation, in slices that are handed to processes."""

import time
from collections.abc import AsyncIterator
from functools import partial
from typing import TYPE_CHECKING, Annotated, Any, Literal

import orjson
from fastapi import APIRouter, Request
from fastapi.responses import Response, StreamingResponse
from pydantic import FailFast, Field, StringConstraints
from pydantic_core import from_json, to_json
from starlette.middleware.gzip import GZipMiddleware
from starlette.types import Receive, Scope, Send

from app.endpoint import (
    AS_IT_COMES,
    COMPRESS_BYTES,
    COMPRESS_LEVEL,
    JSON,
    LINES,
    admitted,
    answered,
    by_lines,
    encoded,
    read_body,
    received,
    take_place,
)
from app.examples import REQUESTS
from app.jobs import Job, Jobs, Stopped, TooLong
from app.model import MAX_NAME, Calculation, Maybe, RequestModel, ResponseModel
from app.problems import RESPONSES, Problem, ProblemOut, impossible, problem_of, refusal, too_long
from app.processes import Tell, in_parts, in_process, wanted
from app.record import Record, at_hand
from app.registry import CALCULATIONS
from app.settings import Settings
from core.errors import ImpossibleMechanism, InvalidInput

FIRST_SLICE = 50
"""Requests that are handed over first; then twice as many as were done in the time of a slice."""

SLICE_S = 0.25
"""Time after which a process hands back what it has done, so that answers flow and others have
their turn."""

SLICE_BYTES = 1 << 20
"""Bytes of answers after which it does so too, as a client may take them slowly."""

MAX_ERRORS = 100
"""Most wrong fields that the answers of a batch name in all; beyond, problems say how many."""


MAX_REQUESTS = 1_000
"""Most requests of a batch."""

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
"""Names by which a calculation may be asked: its own, and what some were called once."""

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
        description="A name of each request, which comes back with its answer.",
    )

    def refuse_beyond(self, settings: Settings) -> None:
        """Refuse more requests than the operator allows, and names that are not one for each.

        Raises
        ------
        InvalidInput
            If there are.
        """
        if len(self.requests) > settings.max_batch:
            raise InvalidInput(
                "requests", len(self.requests), "service_limit", limit=settings.max_batch
            )
        if self.ids is not None and len(self.ids) != len(self.requests):
            count = {"expected": len(self.requests), "actual": len(self.ids)}
            raise InvalidInput("ids", len(self.ids), "different_length", **count)


class BatchItem(ResponseModel):
    """What became of one request: its result, or its problem with pointers into that request."""

    index: Maybe[int] = Field(description="Its place, from 0; in lines alone.")
    id: Maybe[str] = Field(description="Its name, where the batch has `ids`.")
    result: Maybe[dict[str, Any]] = Field(
        description="What the calculation's own endpoint answers."
    )
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

    With `Accept: application/x-ndjson` a line for each request, numbered from 0 by its `index`.
    Both are sent as they are done. What `ids` name comes back with its `id`.
    """
    record, jobs = at_hand.get() or Record(), request.app.state.jobs
    jobs.admit(record.client)
    content = await received(record, record.settings.max_batch_bytes)
    take_place(record)
    async with wanted(record):
        calculation, requests, ids = await in_process(
            jobs, split, content, record.settings, record=record
        )
        done = answers(jobs, partial(lines, name=SPELLINGS[calculation]), requests, record)
        first = await anext(done)  # without which there is nothing to answer
    lines_asked = by_lines(record)
    written = _written(first, done, ids, lines=lines_asked)
    media_type = LINES if lines_asked else JSON
    return AsItComes(written, headers=AS_IT_COMES, media_type=media_type)


class AsItComes(StreamingResponse):
    """Answer that is sent part by part, compressed for those who take that."""

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Send it."""
        await GZipMiddleware(super().__call__, COMPRESS_BYTES, COMPRESS_LEVEL)(scope, receive, send)


def split(tell: Tell, content: bytes, settings: Settings) -> None:
    """The calculation and the requests of a batch, each as JSON of its own, and their names.

    Raises
    ------
    Problem
        If it is no batch, or has more requests than the operator allows.
    """
    try:
        values = from_json(content)
    except ValueError as error:
        raise refusal("", "json_invalid", error=str(error)) from None
    body = admitted(BatchRequest.model_validate, values, settings)
    enough = settings.max_body_bytes + 1  # to see that a request is too large
    requests = [to_json(each, inf_nan_mode="constants")[:enough] for each in body.requests]
    tell((body.calculation, requests, body.ids))


async def answers(
    jobs: Jobs, job: Job, requests: list[bytes], record: Record
) -> AsyncIterator[list[bytes]]:
    """The answers as JSON: ``{"result": ...}`` or ``{"problem": ...}``, some at a time.

    Each request is read and calculated once. Only where its process is killed it is tried once
    more, and only a request that has had `Settings.max_seconds` for itself is refused for its time.
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
    """Answers to the first requests, to as many as there is time for, and how many wrong fields
    each names.
    """
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
            raise Problem("too-large", f"The body exceeds {settings.max_body_bytes} bytes")
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
    """The answers with their names: lines with their places too, or one object."""
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
