"""The way of a calculation's request, from its bytes to the bytes of its answer.

`CalculationRoute` is FastAPI's documented hook (a route class with a handler of its own): pydantic
reads the bytes and orjson writes them, which takes half the time of FastAPI's own way.
"""

import gzip
import math
import time
from collections.abc import AsyncIterator, Callable, Coroutine, Iterator
from contextlib import aclosing
from functools import cache
from typing import Any, ClassVar, get_args, get_type_hints

import numpy as np
import orjson
from fastapi import Request, Response
from fastapi.responses import StreamingResponse
from fastapi.routing import APIRoute
from pydantic import BaseModel, Field, TypeAdapter, ValidationError
from starlette.requests import ClientDisconnect
from starlette.types import Receive, Scope, Send

from app.middleware import PART_BYTES
from app.model import Calculation, RequestModel
from app.problems import (
    REFUSED,
    RESPONSES,
    Problem,
    problem_of,
    refusal,
    unavailable,
    wrong_fields,
)
from app.processes import Tell, in_parts, in_process, wanted
from app.record import Record, at_hand
from app.registry import CALCULATIONS
from app.running import named
from app.settings import Settings
from app.theme import Theme, with_words
from core.errors import ImpossibleMechanism, InvalidInput

JSON = "application/json"
CONTENT_TYPE = (b"content-type", JSON.encode())
LINES = "application/x-ndjson"

LIGHT_BYTES = 16_384
LIGHT_POINTS = 20_000
"""What a request may have to be answered in the event loop: bytes, and points by `points`. It then
holds the loop for less than 30 ms; to hand it over costs half of one."""

COUNTS = {"pins": 1, "satellites": 2, "revolutions": 1, "rollers": 1, "rollers_total": 1}
"""Fields that count what is calculated, each with its power."""

SIZES = {*COUNTS, "samples", "force_exponent", "ratio", "ring_teeth", "satellite_teeth"}
"""Fields on which the size of a request hangs."""

PAIR_POINTS, ROLLER_POINTS = 240, 400
"""Points of a pair, whose forces are searched and integrated over the turn, and of a roller, with
the nodes of its contact line; of a curve with more samples as many as these.
"""

MAX_NESTED = 1000
"""Most lists and objects in a request: they cost a hundred times as much to read as numbers do. The
longest list of objects has 500, rollers."""

COMPRESS_BYTES = 2048
"""Size from which an answer is compressed where the client takes that."""

GZIP = b"\x1f\x8b"
"""How what is compressed begins."""

COMPRESS_LEVEL = 3
"""On curves, half the time of zlib's usual level for 2 % more bytes."""

AS_IT_COMES = {"x-accel-buffering": "no"}
"""Headers of what is sent as it is done: a proxy is not to wait for the whole."""

PROGRESS_S = 0.25
"""How often a client is told how much of a study is done, seconds."""

MOST_WAITING_BYTES = 1 << 27
"""Most bytes of large answers that wait in a worker for clients to take them."""

STREAMED: dict[int | str, dict[str, Any]] = RESPONSES | {
    200: {"content": {LINES: {"schema": {"type": "string"}}}}
}
"""Answers besides of what tells its progress where that is asked."""


class FigureOut(BaseModel):
    """A Plotly figure, ready for Plotly.js."""

    data: list[dict[str, Any]] = Field(description="Traces.")
    layout: dict[str, Any] = Field(description="Layout; `meta.words` has the texts by code.")


class CalculationRoute(APIRoute):
    """Route of a plain function of a `body`, or of a `body` and a `theme`.

    The function runs at once or, where that would hold up others, in a process. Routes of anything
    else keep FastAPI's own handler.
    """

    def get_route_handler(self) -> Callable[[Request], Coroutine[Any, Any, Response]]:
        """What answers a request."""
        hints = get_type_hints(self.endpoint, include_extras=True)
        if "body" not in hints:
            return super().get_route_handler()
        name = next(n for n, e in CALCULATIONS.items() if self.endpoint in (e.solve, e.figure))
        drawn = "theme" in hints

        async def handle(request: Request) -> Response:
            record = at_hand.get() or Record()
            sent = await received(record, record.settings.max_body_bytes)
            calculation = CALCULATIONS[name]
            if calculation.reporting is not None and not drawn and by_lines(record):
                return await _told_by_lines(request, name, sent, record)
            theme = _theme(request) if drawn else None
            zipped = takes_gzip(record.headers)
            body = None
            if len(sent) <= LIGHT_BYTES:
                body = read_body(calculation, sent, record.settings)
            if body is not None and points(body) <= LIGHT_POINTS:
                content = _content(calculation, body, theme, zipped)
            else:
                asked = name, sent, theme, zipped, record.settings
                async with wanted(record):
                    content = await in_process(
                        request.app.state.jobs, _answer, *asked, record=record
                    )
            return Answer(content)

        return handle


def points(body: RequestModel) -> float:
    """How many points a request asks for, by what it states: the one rule for what leaves the event
    loop.

    Pairs times satellites (each satellite has a driving set of its own, which meets those of all
    others) times turns, or rollers; and of each the samples of its curve. Forces by an exponent
    above 1 are as much sharper over the turn, and are looked at in as many more places.
    """
    stated = _stated(body)
    asked = stated.pop("include", ())
    if body.long or "fixes" in asked:
        return math.inf
    size: float = PAIR_POINTS * max(1.0, stated.get("force_exponent", 1.0))
    if stated.get("rollers") or stated.get("rollers_total"):
        size = ROLLER_POINTS
    if "curves" in asked or "points" in asked:
        size = max(size, stated["samples"])
    for name, count in stated.items():
        if power := COUNTS.get(name):
            size *= max(1, len(count) if isinstance(count, list) else count) ** power
    teeth = (stated.get("ring_teeth") or 1) / (stated.get("satellite_teeth") or 1)
    turns = max(1.0, 1 / (stated.get("ratio") or 1), teeth)  # of the output link
    return float(size * turns)


def _stated(body: BaseModel) -> dict[str, Any]:
    """What a request and the models within it state of `SIZES`; what any of them includes."""
    stated: dict[str, Any] = {}
    asked: list[str] = []
    for name, value in vars(body).items():
        if name == "include":
            asked += value or ()
        elif name in SIZES:
            if value is not None:
                stated[name] = value
        elif isinstance(value, BaseModel):
            inner = _stated(value)
            asked += inner.pop("include", ())
            stated = inner | stated
    return stated | {"include": asked} if asked else stated


def _content(
    calculation: Calculation, body: RequestModel, theme: str | None, zipped: bool
) -> bytes:
    """The answer of a calculation, compressed where it is large and the client takes that."""
    if theme is None:
        content = encoded(calculation.answered(body))
    else:
        assert calculation.figure is not None
        content = encoded(with_words(calculation.figure(body, theme)))
    if zipped and len(content) >= COMPRESS_BYTES:
        content = gzip.compress(content, COMPRESS_LEVEL)
    return content


def _answer(
    tell: Tell, name: str, sent: bytes, theme: str | None, zipped: bool, settings: Settings
) -> None:
    """The same from the bytes of a request, in a process."""
    calculation = CALCULATIONS[name]
    tell(_content(calculation, read_body(calculation, sent, settings), theme, zipped))


async def _told_by_lines(request: Request, name: str, sent: bytes, record: Record) -> Response:
    """Answer of a study, line by line: how much of it is done, and at last its result."""
    settings = record.settings.model_copy(update={"max_seconds": record.settings.max_study_seconds})
    parts = in_parts(
        request.app.state.jobs,
        *(_progress, name, sent, settings),
        record=record,
        limit_s=settings.max_seconds,
    )
    async with wanted(record):
        await anext(parts)  # without which it is refused as a whole

    async def lines() -> AsyncIterator[bytes]:
        try:
            async with aclosing(parts) as some:
                async for line in some:
                    yield line
        except (*REFUSED,) as error:
            yield _line({"problem": problem_of(error).body()})

    return StreamingResponse(lines(), headers=AS_IT_COMES, media_type=LINES)


def _progress(tell: Tell, name: str, sent: bytes, settings: Settings) -> None:
    """Lines of a study in a process, behind an empty one where the request is right."""
    calculation = CALCULATIONS[name]
    body = read_body(calculation, sent, settings)
    tell(b"")
    last = time.monotonic()

    def report(share: float) -> None:
        nonlocal last
        if time.monotonic() - last >= PROGRESS_S:
            last = time.monotonic()
            tell(_line({"progress": share}))

    tell(b'{"result":' + encoded(calculation.answered(body, report)) + b"}\n")


def _line(values: dict[str, Any]) -> bytes:
    return orjson.dumps(values) + b"\n"


def by_lines(record: Record) -> bool:
    """Whether a client takes an answer line by line."""
    return LINES.encode() in record.headers.get(b"accept", b"")


async def received(record: Record, limit: int) -> bytes:
    """All that a client sends, as JSON. (Starlette reads it in twice the time.)

    Raises
    ------
    Problem
        If that is more than so many bytes, or announced as more, or not sent as JSON.
    ClientDisconnect
        If the client goes before.
    """
    headers = record.headers
    media_type = headers.get(b"content-type", b"").partition(b";")[0].strip().lower()
    if media_type != b"application/json" and not media_type.endswith(b"+json"):
        raise Problem("unsupported-media-type", f"Send {JSON}")
    if headers.get(b"content-encoding", b"identity") != b"identity":
        raise Problem("unsupported-media-type", "Send the body without a content encoding")
    announced = headers.get(b"content-length", b"")
    if announced.isdigit() and int(announced) > limit:
        raise Problem("too-large", f"The body exceeds {limit} bytes")
    parts, size = [], 0
    while True:
        message = await record.receive()
        if message["type"] == "http.disconnect":
            raise ClientDisconnect
        part = message.get("body", b"")
        parts.append(part)
        size += len(part)
        if size > limit:
            raise Problem("too-large", f"The body exceeds {limit} bytes")
        if not message.get("more_body"):
            record.received = time.perf_counter()
            return b"".join(parts)


@cache
def _reader(name: str) -> Callable[[bytes], RequestModel]:
    return TypeAdapter(CALCULATIONS[name].request).validator.validate_json


def read_body(calculation: Calculation, content: bytes, settings: Settings) -> RequestModel:
    """The body of a request.

    Raises
    ------
    Problem
        If it is no JSON, not what the model says, or more than the operator allows.
    """
    if len(content) > MAX_NESTED and content.count(b"{") + content.count(b"[") > MAX_NESTED:
        raise refusal("", "too_nested", limit=MAX_NESTED)
    try:
        body = _reader(calculation.name)(content)
    except ValidationError as error:
        raise wrong_fields(error) from None
    try:
        body.refuse_beyond(settings)
    except InvalidInput as error:
        raise named(error, body) from error
    return body


def _theme(request: Request) -> str:
    theme = request.query_params.get("theme", "light")
    if theme not in get_args(Theme):
        raise refusal("/query/theme", "literal_error", expected="'light' or 'dark'")
    return theme


def encoded(values: Any) -> bytes:
    """Values of an answer as JSON: what is not there is left out, not None.

    Raises
    ------
    ImpossibleMechanism
        If a number is not finite: the input was beyond what doubles can carry.
    """
    content = orjson.dumps(
        values,
        option=orjson.OPT_SERIALIZE_NUMPY,
        default=np.ndarray.tolist,  # of other orders
    )
    # What is not finite is written as null, and nothing else is.
    if b"null" in content and (names := dict.fromkeys(_nulls(orjson.loads(content), ""))):
        raise ImpossibleMechanism("overflow", names=", ".join(names))
    return content


def _nulls(values: Any, name: str) -> Iterator[str]:
    """Names under which something is null."""
    if values is None:
        yield name
    elif isinstance(values, dict):
        for inner, value in values.items():
            yield from _nulls(value, inner)
    elif isinstance(values, list):
        for value in values:
            yield from _nulls(value, name)


class Answer(Response):
    """Answer of JSON, which may be compressed. What is large is refused where too much waits for
    clients already.
    """

    waiting_bytes: ClassVar[int] = 0

    def __init__(self, content: bytes) -> None:  # Starlette's own takes three times as long
        self.status_code, self.background, self.body = 200, None, content
        self.raw_headers = [CONTENT_TYPE, (b"content-length", b"%d" % len(content))]
        zipped = content.startswith(GZIP)
        if zipped or len(content) >= COMPRESS_BYTES:
            self.raw_headers.append((b"vary", b"accept-encoding"))
        if zipped:
            self.raw_headers.append((b"content-encoding", b"gzip"))

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Send it."""
        size = len(self.body)
        if size > PART_BYTES and 0 < Answer.waiting_bytes > MOST_WAITING_BYTES - size:
            raise unavailable("Too many answers wait for clients to take them")
        Answer.waiting_bytes += size
        try:
            start = {"type": "http.response.start", "status": 200, "headers": self.raw_headers}
            await send(start)
            await send({"type": "http.response.body", "body": self.body})
        finally:
            Answer.waiting_bytes -= size


def takes_gzip(headers: dict[bytes, bytes]) -> bool:
    """Whether a client takes compressed answers."""
    return b"gzip" in headers.get(b"accept-encoding", b"")
