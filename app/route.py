"""The route of a calculation: from the bytes of a request to the bytes of its answer.

FastAPI describes the endpoint. What it would do for each request (parse the body into Python
objects, validate these, resolve dependencies, validate the answer, copy it) takes longer than
most of the calculations; here pydantic reads the bytes, and the answer is written as it is.
"""

import gzip
import time
from collections.abc import Awaitable, Callable, Iterator
from typing import Any, get_args, get_type_hints

import numpy as np
import orjson
from fastapi import APIRouter
from fastapi.routing import APIRoute
from pydantic import TypeAdapter, ValidationError
from starlette.requests import ClientDisconnect, Request
from starlette.responses import Response
from starlette.routing import Match
from starlette.types import Receive, Scope, Send

from app import processes
from app.calculation import refusals_named
from app.figures.theme import Theme
from app.problems import MEDIA_TYPE, ErrorItem, invalid_input, too_large, wrong_fields
from app.record import Record, at_hand
from app.schemas.base import RequestModel
from core.errors import ImpossibleMechanism

API = "/api/v1"

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
        (422, "The input is wrong, or the mechanism cannot work"),
        (503, "Too much is asked now, or it takes too long; `Retry-After` says when to ask again"),
    )
}
"""Refusals of every calculation, as its description shows them."""


def calculations(prefix: str, *, tag: str) -> APIRouter:
    """Router of the endpoints of a calculation.

    Parameters
    ----------
    prefix : str
        Their path below `API`.
    tag : str
        Their chapter in the description.
    """
    return APIRouter(prefix=API + prefix, tags=[tag], route_class=Calculation, responses=RESPONSES)


class Calculation(APIRoute):
    """Route whose endpoint is a plain function of the request `body`, or of it and a `theme`.

    It runs at once or, where that would hold up others, in a process.
    """

    def __init__(self, *args: Any, **settings: Any) -> None:
        super().__init__(*args, **settings)
        answer = _answering(self.endpoint)

        async def app(scope: Scope, receive: Receive, send: Send) -> None:
            response = await answer(Request(scope, receive))
            await response(scope, receive, send)

        self.app = app

    def matches(self, scope: Scope) -> tuple[Match, Scope]:
        """Whether a request is for this route; comparing is enough, its path has no parameters."""
        ours = self.path, scope.get("root_path", "") + self.path
        if scope["type"] != "http" or scope["path"] not in ours:
            return Match.NONE, {}
        match = Match.FULL if scope["method"] in (self.methods or ()) else Match.PARTIAL
        return match, {"endpoint": self.endpoint, "path_params": {}, "route": self}


def _answering(endpoint: Callable[..., Any]) -> Callable[[Request], Awaitable[Response]]:
    """What answers a request to an endpoint."""
    hints = get_type_hints(endpoint, include_extras=True)
    drawn = "theme" in hints
    model: TypeAdapter[RequestModel] = TypeAdapter(hints["body"])

    async def answer(request: Request) -> Response:
        record = at_hand.get() or Record()
        sent = await received(request, record.settings.max_body_bytes)
        record.received = time.perf_counter()
        body = _body_of(model, sent)
        with refusals_named(body):
            body.refuse_beyond(record.settings)
            cost_ms = body.cost_ms(drawn=drawn)
        given: dict[str, Any] = {"body": body}
        if drawn:
            given["theme"] = _theme(request)
        asked = endpoint, given, takes_gzip(request)
        if cost_ms <= processes.INLINE_MS:
            (content,) = _content(*asked)
        else:
            jobs = request.app.state.jobs
            content = await processes.in_process(jobs, _content, *asked, record=record)
        return _json_response(content)

    return answer


def _content(endpoint: Callable[..., Any], given: dict[str, Any], zipped: bool) -> Iterator[bytes]:
    """The answer of an endpoint, compressed where it is large and the client takes that."""
    content = encoded(endpoint(**given))
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
            break
    media_type = headers.get(b"content-type", b"").partition(b";")[0].strip().lower()
    if media_type != JSON.encode() and not media_type.endswith(b"+json"):
        raise invalid_input([ErrorItem("", f"must be an object, sent as {JSON}")])
    return b"".join(parts)


def _body_of(model: TypeAdapter[RequestModel], content: bytes) -> RequestModel:
    """The body of a request.

    Raises
    ------
    Problem
        If it is no JSON, or not what the model says.
    """
    if content.count(b"{") + content.count(b"[") > MAX_NESTED:
        raise invalid_input([ErrorItem("", f"must hold at most {MAX_NESTED} lists and objects")])
    try:
        return model.validate_json(content)
    except ValidationError as error:
        raise wrong_fields(error) from None


def _theme(request: Request) -> str:
    theme = request.query_params.get("theme", "light")
    if theme not in get_args(Theme):
        raise invalid_input([ErrorItem("/query/theme", "must be one of 'light' or 'dark'")])
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
        raise ImpossibleMechanism(
            f"The numbers given leave the range of numbers: {', '.join(names)} would not be finite"
        )
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
