"""Path of a request through the service, from its bytes to the bytes of its answer.

`route_of` uses FastAPI's documented hook (a route class with a handler of its own): pydantic reads
the bytes and orjson writes them, which takes half the time of FastAPI's own way.
"""

import time
from collections.abc import AsyncIterator, Callable, Coroutine
from contextlib import aclosing
from functools import cache, partial
from typing import Any, TypeVar, get_args

import orjson
from fastapi import Request, Response
from fastapi.middleware.gzip import GZipMiddleware
from fastapi.responses import JSONResponse, StreamingResponse
from fastapi.routing import APIRoute
from pydantic import BaseModel, Field, TypeAdapter, ValidationError
from starlette.requests import ClientDisconnect
from starlette.types import Receive, Scope, Send

from app.content import encoded
from app.middleware import PART_BYTES
from app.model import (
    Calculation,
    Export,
    Report,
    RequestModel,
    Result,
    StudyCalculation,
    Values,
    timed,
    untold,
)
from app.problems import (
    REFUSED,
    RESPONSES,
    Problem,
    not_installed,
    problem_of,
    refusal,
    refuse_for,
    too_large,
    unavailable,
    wrong_fields,
)
from app.processes import Tell, in_parts, in_process, wanted
from app.record import Record, at_hand
from app.registry import CALCULATIONS, EXPORTS
from app.settings import Settings
from app.theme import Theme, with_words
from core.errors import CalculationError

JSON = "application/json"
LINES = "application/x-ndjson"

LIGHT_BYTES = 16_384
LIGHT_COST = 20_000
"""Largest size, bytes, and cost, points, of a request that the event loop answers itself in less
than 30 ms; handing it over costs half of one."""

MAX_NESTED = 1000
"""Largest number of lists and objects in a request, as reading them costs a hundred times more than
numbers. The longest list of objects has 500 rollers."""

COMPRESS_BYTES = 2048
"""Size from which an answer is compressed if the client accepts compression."""

COMPRESS_LEVEL = 3
"""Level of zlib that takes half the usual time on curves for 2 % more bytes."""

PROGRESS_S = 0.25
"""Interval at which a client is told the progress of a study, s."""

STREAMED: dict[int | str, dict[str, Any]] = RESPONSES | {
    200: {"content": {LINES: {"schema": {"type": "string"}}}}
}
"""Answers of calculations that report progress on request."""


Body = TypeVar("Body", bound=RequestModel)


class FigureOut(BaseModel):
    """Plotly figure, ready for Plotly.js."""

    data: list[dict[str, Any]] = Field(description="Traces of the figure, as Plotly.js takes them.")
    layout: dict[str, Any] = Field(
        description="Layout of the figure; `meta.words` contains its texts by code."
    )


def hooked(handle: Callable[[Request], Coroutine[Any, Any, Response]]) -> type[APIRoute]:
    """Route class whose requests a handler answers, by FastAPI's documented hook."""

    class HookedRoute(APIRoute):
        def get_route_handler(self) -> Callable[[Request], Coroutine[Any, Any, Response]]:
            return handle

    return HookedRoute


def route_of(calculation: Calculation, *, drawn: bool = False) -> type[APIRoute]:
    """Route class of a calculation, or of its figure. Light requests are calculated at once, others
    in a process, which keeps the event loop free.
    """

    async def handle(request: Request) -> Response:
        record = at_hand.get() or Record()
        sent = await received(request, record, record.settings.max_body_bytes)
        if isinstance(calculation, StudyCalculation) and not drawn and by_lines(request):
            return await _told_by_lines(request, calculation.name, sent, record)
        theme = _theme(request) if drawn else None
        if len(sent) <= LIGHT_BYTES:
            body = read_body(calculation, sent, record.settings)
            if body.cost() <= LIGHT_COST:
                return answer(content_of(calculation, body, theme), record)
        asked = calculation.name, sent, theme, record.settings
        async with wanted(request):
            content = await in_process(request.app.state.jobs, _answer, *asked, record=record)
        return answer(content, record)

    return hooked(handle)


def answer(content: bytes, record: Record, media_type: str = JSON, **headers: str) -> Response:
    """Answer of JSON or of a file; a large one takes a place while parts wait for the client."""
    if len(content) > PART_BYTES:
        take_place(record)
    kind = Response if len(content) < COMPRESS_BYTES else Compressed
    return kind(content, media_type=media_type, headers=headers)


class Compressed(Response):
    """Answer compressed for clients that accept compression."""

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Send it."""
        await GZipMiddleware(super().__call__, COMPRESS_BYTES, COMPRESS_LEVEL)(scope, receive, send)


class CompressedJSON(Compressed, JSONResponse):
    """Answer of JSON, compressed likewise."""


class AsItComes(Compressed, StreamingResponse):
    """Answer sent part by part, compressed likewise; proxies are told not to gather the parts."""

    def __init__(self, parts: AsyncIterator[bytes], media_type: str) -> None:
        headers = {"x-accel-buffering": "no"}
        StreamingResponse.__init__(self, parts, headers=headers, media_type=media_type)


def answered(calculation: Calculation, body: RequestModel, report: Report = untold) -> Values:
    """Values of the answer to a request; `report` is told the progress of a study."""
    return calculated(body, partial(calculation.answered, body, report))


def calculated(body: RequestModel, calculation: Callable[[], Result]) -> Result:
    """Result of a calculation, timed for the record; a refusal names the request's fields."""
    try:
        result, run_time_us = timed(calculation)
    except CalculationError as error:
        refuse_for(body, error)
    if record := at_hand.get():
        record.calculation_took(run_time_us)
    return result


def content_of(calculation: Calculation, body: RequestModel, theme: str | None) -> bytes:
    """Answer of a calculation, or its figure in a theme."""
    if theme is None:
        return encoded(answered(calculation, body))
    assert calculation.figure
    return encoded(with_words(calculated(body, partial(calculation.figure, body, theme))))


def _answer(tell: Tell, name: str, sent: bytes, theme: str | None, settings: Settings) -> None:
    """Answer of a calculation from the bytes of a request, in a process."""
    calculation = CALCULATIONS[name]
    tell(content_of(calculation, read_body(calculation, sent, settings), theme))


def route_of_files(export: Export) -> type[APIRoute]:
    """Route class for files of a design, which are written in a process that imports the writer."""

    async def handle(request: Request) -> Response:
        record = at_hand.get() or Record()
        sent = await received(request, record, record.settings.max_body_bytes)
        converted = export.converts(request.headers.get("accept", ""))
        if export.media_types[-converted] not in export.answered:
            raise not_installed(export)
        asked = export.name, sent, converted, record.settings
        long = export.extra and (converted or not export.convert)
        limit_s = record.settings.max_study_seconds if long else None
        async with wanted(request):
            file = await in_process(
                request.app.state.jobs, _written, *asked, record=record, limit_s=limit_s
            )
        named = {"content-disposition": f'attachment; filename="{file.name}"'}
        return answer(file.content, record, file.media_type, **named)

    return hooked(handle)


def _written(tell: Tell, name: str, sent: bytes, converted: bool, settings: Settings) -> None:
    """A file of a design from the bytes of a request, in a process."""
    export = EXPORTS[name]
    body = read_body(export, sent, settings)
    tell(calculated(body, partial(export.file, body, converted=converted)))


async def _told_by_lines(request: Request, name: str, sent: bytes, record: Record) -> Response:
    """Answer of a study line by line: its progress, and at last its result."""
    settings = record.settings.model_copy(update={"max_seconds": record.settings.max_study_seconds})
    parts = in_parts(
        request.app.state.jobs,
        *(told_progress, name, sent, settings),
        record=record,
        limit_s=settings.max_seconds,
    )
    async with wanted(request):
        await anext(parts)  # an error here refuses the request as a whole

    async def lines() -> AsyncIterator[bytes]:
        try:
            async with aclosing(parts) as some:
                async for line in some:
                    yield line
        except (*REFUSED,) as error:
            yield _line({"problem": problem_of(error).body()})

    return AsItComes(lines(), LINES)


def told_progress(tell: Tell, name: str, sent: bytes, settings: Settings) -> None:
    """Lines of a study in a process, after an empty one if the request is valid."""
    calculation = CALCULATIONS[name]
    body = read_body(calculation, sent, settings)
    tell(b"")
    last = time.monotonic()

    def report(share: float, **found: Values) -> None:
        nonlocal last
        if found or time.monotonic() - last >= PROGRESS_S:
            last = time.monotonic()
            tell(_line({"progress": share, **found}))

    tell(b'{"result":' + encoded(answered(calculation, body, report)) + b"}\n")


def _line(values: dict[str, Any]) -> bytes:
    return orjson.dumps(values) + b"\n"


def by_lines(request: Request) -> bool:
    """True if a client accepts an answer line by line."""
    return LINES in request.headers.get("accept", "")


def take_place(record: Record) -> None:
    """Take one of the worker's few places for large requests until the request is answered. A
    client gets at most as many as stay free for others; otherwise `Problem` is raised.
    """
    if not record.has_place:
        free = record.settings.max_large - record.places.total()
        if record.places[record.client] >= free:
            raise unavailable("Too many large requests or answers are under way")
        record.places[record.client] += 1
        record.has_place = True


async def received(request: Request, record: Record, limit: int) -> bytes:
    """Body of a request as sent.

    Raises Problem if the body is too large or slow, not JSON, or large without a free place;
    ClientDisconnect if the client leaves.
    """
    headers = dict(request.scope["headers"])  # by bytes, as each look into `Headers` is a search
    media_type = headers.get(b"content-type", b"").partition(b";")[0].strip().lower()
    if media_type != b"application/json" and not media_type.endswith(b"+json"):
        raise Problem("unsupported-media-type", f"Send {JSON}")
    if headers.get(b"content-encoding", b"identity") != b"identity":
        raise Problem("unsupported-media-type", "Send the body without a content encoding")
    if int(headers.get(b"content-length", 0)) > limit:  # FastAPI's limit answers by plain text
        raise too_large(limit)
    content, more = bytearray(), True
    while more:
        message = await request.receive()
        if message["type"] == "http.disconnect":
            raise ClientDisconnect
        content += message.get("body", b"")
        more = message.get("more_body", False)
        if more and time.perf_counter() - record.started > record.settings.receive_seconds:
            detail = "The body did not arrive in time"
            raise Problem("request-timeout", detail, headers={"connection": "close"})
        if len(content) > limit:
            raise too_large(limit)
        if len(content) > LIGHT_BYTES:
            take_place(record)
    record.received = time.perf_counter()
    return bytes(content)


@cache
def _reader(name: str) -> Callable[[bytes], RequestModel]:
    asked: Calculation | Export = CALCULATIONS[name] if name in CALCULATIONS else EXPORTS[name]
    return TypeAdapter(asked.request).validator.validate_json


def read_body(asked: Calculation | Export, content: bytes, settings: Settings) -> RequestModel:
    """Validated body of a request, within the operator's limits; raises `Problem`."""
    if len(content) > MAX_NESTED and content.count(b"{") + content.count(b"[") > MAX_NESTED:
        raise refusal("", "too_nested", limit=MAX_NESTED)
    return admitted(_reader(asked.name), content, settings)


def admitted(read: Callable[[Any], Body], content: Any, settings: Settings) -> Body:
    """Validated content, within the operator's limits; raises `Problem`."""
    try:
        body = read(content)
    except ValidationError as error:
        raise wrong_fields(error) from None
    try:
        body.refuse_beyond(settings)
    except CalculationError as error:
        refuse_for(body, error)
    return body


def _theme(request: Request) -> str:
    theme = request.query_params.get("theme", "light")
    if theme not in get_args(Theme):
        raise refusal("/query/theme", "literal_error", expected="'light' or 'dark'")
    return theme
