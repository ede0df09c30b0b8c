"""The way of a calculation's request, from its bytes to the bytes of its answer.

`CalculationRoute` is FastAPI's documented hook (a route class with a handler of its own): pydantic
reads the bytes and orjson writes them, which takes half the time of FastAPI's own way.
"""

import gzip
import time
from collections.abc import Callable, Coroutine, Iterator
from typing import Any, get_args, get_type_hints

import numpy as np
import orjson
from fastapi import Request, Response
from fastapi.routing import APIRoute
from pydantic import BaseModel, Field, TypeAdapter, ValidationError
from starlette.requests import ClientDisconnect

from app import processes
from app.model import Calculation, RequestModel
from app.problems import MEDIA_TYPE, ErrorItem, invalid_input, not_json, too_large, wrong_fields
from app.record import Record, at_hand
from app.running import refusals_named
from app.theme import Figure, Theme, with_words
from core.errors import ImpossibleMechanism

JSON = "application/json"

MAX_NESTED = 1000
"""Most lists and objects in a request: they cost a hundred times as much to read as numbers do. The
longest list of objects has 500, rollers."""

COMPRESS_BYTES = 2048
"""Size from which an answer is compressed where the client takes that."""

COMPRESS_LEVEL = 3
"""On curves, half the time of zlib's usual level for 2 % more bytes."""

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
        endpoint, drawn = self.endpoint, "theme" in hints
        model: TypeAdapter[RequestModel] = TypeAdapter(hints["body"])

        async def handle(request: Request) -> Response:
            record = at_hand.get() or Record()
            sent = await received(request, record.settings.max_body_bytes)
            record.received = time.perf_counter()
            body = _read(model, sent)
            with refusals_named(body):
                body.refuse_beyond(record.settings)
                cost_ms = body.cost_ms(drawn=drawn)
            given = (body, _theme(request)) if drawn else (body,)
            asked = endpoint, given, takes_gzip(request)
            if cost_ms <= processes.INLINE_MS:
                (content,) = _content(*asked)
            else:
                jobs = request.app.state.jobs
                content = await processes.in_process(jobs, _content, *asked, record=record)
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


def _content(endpoint: Callable[..., Any], given: tuple[Any, ...], zipped: bool) -> Iterator[bytes]:
    """The answer of an endpoint, compressed where it is large and the client takes that."""
    values = endpoint(*given)
    content = encoded(with_words(values) if len(given) == 2 else values)
    if zipped and len(content) >= COMPRESS_BYTES:
        content = gzip.compress(content, COMPRESS_LEVEL)
    yield content


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


def _read(model: TypeAdapter[RequestModel], content: bytes) -> RequestModel:
    """The body of a request.

    Raises
    ------
    Problem
        If it is no JSON, or not what the model says.
    """
    if content.count(b"{") + content.count(b"[") > MAX_NESTED:
        raise invalid_input([ErrorItem("", "too_nested", {"limit": MAX_NESTED})])
    try:
        return model.validate_json(content)
    except ValidationError as error:
        raise wrong_fields(error) from None


def _theme(request: Request) -> str:
    theme = request.query_params.get("theme", "light")
    if theme not in get_args(Theme):
        expected = {"expected": "'light' or 'dark'"}
        raise invalid_input([ErrorItem("/query/theme", "literal_error", expected)])
    return theme


def encoded(values: Any) -> bytes:
    """Values of an answer as JSON.

    Parameters
    ----------
    values : object
        Dictionaries, lists, texts, arrays and numbers; what is not there is left out, not None.

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


def takes_gzip(request: Request) -> bool:
    """Whether a client takes compressed answers."""
    return "gzip" in request.headers.get("accept-encoding", "")


def _json_response(content: bytes) -> Response:
    """Answer of JSON, which may be compressed."""
    headers = {}
    if content.startswith(b"\x1f\x8b"):
        headers = {"vary": "accept-encoding", "content-encoding": "gzip"}
    elif len(content) >= COMPRESS_BYTES:
        headers = {"vary": "accept-encoding"}
    return Response(content, headers=headers, media_type=JSON)
