"""The way of a calculation's request, from its bytes to the bytes of its answer.

`CalculationRoute` is FastAPI's documented hook (a route class with a handler of its own): pydantic
reads the bytes and orjson writes them, which takes half the time of FastAPI's own way.
"""

import gzip
import math
import time
from collections.abc import Callable, Coroutine, Iterator
from functools import cache
from typing import Any, get_args, get_type_hints

import numpy as np
import orjson
from fastapi import Request, Response
from fastapi.routing import APIRoute
from pydantic import BaseModel, Field, TypeAdapter, ValidationError
from starlette.requests import ClientDisconnect
from starlette.types import Receive, Scope, Send

from app import processes
from app.model import Calculation, RequestModel
from app.problems import (
    MEDIA_TYPE,
    ErrorItem,
    invalid_input,
    not_json,
    too_large,
    unavailable,
    wrong_fields,
)
from app.record import Record, at_hand
from app.registry import CALCULATIONS
from app.running import refusals_named
from app.settings import Settings
from app.theme import Figure, Theme, with_words
from core.errors import ImpossibleMechanism

JSON = "application/json"

LIGHT_BYTES = 16_384
LIGHT_POINTS = 20_000
"""What a request may have to be answered in the event loop: bytes, and points by `points`. It then
holds the loop for some 10 ms; to hand it over costs half of one."""

ROLLERS = ("rollers", "rollers_total")
COUNTS = ("pins", "satellites", "satellites", "revolutions", *ROLLERS)
SIZES = {*COUNTS, "include", "samples", "ratio", "ring_teeth", "satellite_teeth"}
"""Fields on which the size of a request hangs."""

ELEMENT_POINTS, DRAWN_POINTS = 20, 100
"""Points of a pair or a roller of which no curve is asked, and of one that is drawn."""

MAX_NESTED = 1000
"""Most lists and objects in a request: they cost a hundred times as much to read as numbers do. The
longest list of objects has 500, rollers."""

COMPRESS_BYTES = 2048
"""Size from which an answer is compressed where the client takes that."""

COMPRESS_LEVEL = 3
"""On curves, half the time of zlib's usual level for 2 % more bytes."""

PART_BYTES = 1 << 18
"""Size of what is sent at once."""

MOST_WAITING_BYTES = 1 << 27
"""Most bytes of large answers that wait in a worker for clients to take them."""

RESPONSES: dict[int | str, dict[str, Any]] = {
    status: {
        "description": text,
        "content": {MEDIA_TYPE: {"schema": {"$ref": "#/components/schemas/ProblemOut"}}},
    }
    for status, text in (
        (413, "The request is too large"),
        (415, "The request is not sent as JSON"),
        (422, "The input is wrong, or the mechanism cannot work"),
        (503, "Too much is asked now, or it takes too long; `Retry-After` says when to ask again"),
    )
}
"""Refusals of every calculation, as its description shows them."""


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
            sent = await received(request, record.settings.max_body_bytes)
            record.received = time.perf_counter()
            theme = _theme(request) if drawn else None
            zipped = takes_gzip(request.scope)
            body = None
            if len(sent) <= LIGHT_BYTES:
                body = read_body(CALCULATIONS[name], sent, record.settings)
            if body is not None and points(body, drawn=drawn) <= LIGHT_POINTS:
                content = _content(CALCULATIONS[name], body, theme, zipped)
            else:
                jobs = request.app.state.jobs
                asked = name, sent, theme, zipped, record.settings
                content = await processes.in_process(jobs, _answer, *asked, record=record)
            return _json_response(content)

        return handle


def answering(calculation: Calculation) -> Callable[[Any], Any]:
    """The endpoint of a calculation: its function, with the models that describe it."""
    solve = calculation.solve
    solve.__annotations__ |= {"body": calculation.request, "return": calculation.answer}
    return solve


def drawing(calculation: Calculation) -> Callable[[Any, Any], Figure]:
    """The endpoint of a calculation's figure."""
    assert calculation.figure is not None
    figure = calculation.figure
    figure.__annotations__ |= {"body": calculation.request, "theme": Theme}
    return figure


def points(body: RequestModel, *, drawn: bool) -> float:
    """How many points a request asks for, by the counts that it states: the one rule for what
    leaves the event loop.

    Pairs times satellites (each satellite has a driving set of its own, which meets those of all
    others) times turns, or rollers; and of each the samples of its curve. With `drawn`, of
    its figure.
    """
    stated = dict(_stated(body))
    asked = stated.get("include", ())
    if body.long or "fixes" in asked:
        return math.inf
    size = 1.0
    for name in COUNTS:
        if name in stated:
            count = stated[name]
            size *= max(1, len(count) if isinstance(count, list) else count)
    if any(name in stated for name in ROLLERS):
        size *= ELEMENT_POINTS  # nodes of its contact line
    teeth = stated.get("ring_teeth", 1) / stated.get("satellite_teeth", 1)
    size *= max(1.0, 1 / stated.get("ratio", 1.0), teeth)  # turns of the output link
    each = DRAWN_POINTS if drawn else ELEMENT_POINTS
    if "curves" in asked or "points" in asked:
        each = max(each, stated["samples"])
    return float(size * each)


def _stated(body: BaseModel) -> Iterator[tuple[str, Any]]:
    """What is given of `SIZES` in a request and in the models within it."""
    for name in _sizing(type(body)):
        value = getattr(body, name)
        if isinstance(value, BaseModel):
            yield from _stated(value)
        elif value is not None:
            yield name, value


@cache
def _sizing(model: type[BaseModel]) -> list[str]:
    """Fields of a model that are among `SIZES`, or hold a model that may have some."""
    fields = model.model_fields.items()
    return [name for name, each in fields if name in SIZES or _holds_model(each.annotation)]


def _holds_model(annotation: Any) -> bool:
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        return True
    return any(map(_holds_model, get_args(annotation)))


def _content(
    calculation: Calculation, body: RequestModel, theme: str | None, zipped: bool
) -> bytes:
    """The answer of a calculation, compressed where it is large and the client takes that."""
    if theme is None:
        content = encoded(calculation.solve(body))
    else:
        assert calculation.figure is not None
        content = encoded(with_words(calculation.figure(body, theme)))
    if zipped and len(content) >= COMPRESS_BYTES:
        content = gzip.compress(content, COMPRESS_LEVEL)
    return content


def _answer(
    name: str, sent: bytes, theme: str | None, zipped: bool, settings: Settings
) -> Iterator[bytes]:
    """The same from the bytes of a request, in a process."""
    calculation = CALCULATIONS[name]
    yield _content(calculation, read_body(calculation, sent, settings), theme, zipped)


async def received(request: Request, limit: int) -> bytes:
    """All that a client sends, as JSON. (Starlette reads it in twice the time.)

    Raises
    ------
    Problem
        If that is more than so many bytes, or announced as more, or not sent as JSON.
    ClientDisconnect
        If the client goes before.
    """
    headers = dict(request.scope["headers"])
    media_type = headers.get(b"content-type", b"").partition(b";")[0].strip().lower()
    if media_type != JSON.encode() and not media_type.endswith(b"+json"):
        raise not_json(f"Send {JSON}")
    if headers.get(b"content-encoding", b"identity") != b"identity":
        raise not_json("Send the body as it is, without a content encoding")
    announced = headers.get(b"content-length", b"")
    if announced.isdigit() and int(announced) > limit:
        raise too_large(limit)
    parts, size = [], 0
    while True:
        message = await request.receive()
        if message["type"] == "http.disconnect":
            raise ClientDisconnect
        parts.append(message.get("body", b""))
        size += len(parts[-1])
        if size > limit:
            raise too_large(limit)
        if not message.get("more_body"):
            return b"".join(parts)


@cache
def _reader(name: str) -> TypeAdapter[RequestModel]:
    return TypeAdapter(CALCULATIONS[name].request)


def read_body(calculation: Calculation, content: bytes, settings: Settings) -> RequestModel:
    """The body of a request.

    Raises
    ------
    Problem
        If it is no JSON, not what the model says, or more than the operator allows.
    """
    if content.count(b"{") + content.count(b"[") > MAX_NESTED:
        raise invalid_input([ErrorItem("", "too_nested", {"limit": MAX_NESTED})])
    try:
        body = _reader(calculation.name).validate_json(content)
    except ValidationError as error:
        raise wrong_fields(error) from None
    with refusals_named(body):
        body.refuse_beyond(settings)
    return body


def _theme(request: Request) -> str:
    theme = request.query_params.get("theme", "light")
    if theme not in get_args(Theme):
        expected = {"expected": "'light' or 'dark'"}
        raise invalid_input([ErrorItem("/query/theme", "literal_error", expected)])
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
    """Answer of JSON, which may be compressed. What is large is sent by and by, as its client takes
    it, and refused where too much waits for clients already.
    """

    media_type = JSON
    waiting_bytes = 0

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Send it."""
        size, kind = len(self.body), type(self)
        if size <= PART_BYTES:
            await super().__call__(scope, receive, send)
            return
        if kind.waiting_bytes + size > MOST_WAITING_BYTES and kind.waiting_bytes:
            raise unavailable("Too many answers wait for clients to take them")
        kind.waiting_bytes += size
        try:
            start = {"type": "http.response.start", "status": 200, "headers": self.raw_headers}
            await send(start)
            for sent in range(0, size, PART_BYTES):
                part, more = self.body[sent : sent + PART_BYTES], sent + PART_BYTES < size
                await send({"type": "http.response.body", "body": part, "more_body": more})
        finally:
            kind.waiting_bytes -= size


def takes_gzip(scope: Scope) -> bool:
    """Whether a client takes compressed answers."""
    return any(n == b"accept-encoding" and b"gzip" in v for n, v in scope["headers"])


def _json_response(content: bytes) -> Response:
    headers = {}
    if content.startswith(b"\x1f\x8b"):
        headers = {"vary": "accept-encoding", "content-encoding": "gzip"}
    elif len(content) >= COMPRESS_BYTES:
        headers = {"vary": "accept-encoding"}
    return Answer(content, headers=headers)
