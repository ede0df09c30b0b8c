"""Errors as problem details (RFC 9457): one shape, one table from exception to status."""

from collections.abc import Iterable
from dataclasses import dataclass, field, fields
from http import HTTPStatus
from typing import Any, Self

import orjson
from fastapi import FastAPI, Request
from fastapi.exceptions import RequestValidationError
from fastapi.responses import Response
from starlette.exceptions import HTTPException

from app.schemas.base import FIELD_ERROR, api_text
from app.units import api_value
from core.errors import ImpossibleMechanism

MEDIA_TYPE = "application/problem+json"

RETRY_AFTER_S = "5"
"""When to ask again after a 503, seconds."""


@dataclass(frozen=True, slots=True)
class ErrorItem:
    """What is wrong with one field.

    Attributes
    ----------
    pointer : str
        JSON pointer to the field; empty for the body as a whole.
    detail : str
        What is wrong, as the rest of a sentence that starts with the field.
    """

    pointer: str
    detail: str


@dataclass(slots=True)
class Problem(Exception):
    """A refusal, ready to be sent.

    Attributes
    ----------
    status : int
        HTTP status.
    kind : str
        Last part of the problem's type.
    title, detail : str
        Its kind and this occurrence, for people.
    errors : list of ErrorItem
        The fields it is about.
    where : dict
        Position at which it happens, by API names.
    headers : dict
        Headers of the answer.
    """

    status: int
    kind: str
    title: str
    detail: str
    errors: list[ErrorItem] = field(default_factory=list)
    where: dict[str, float] = field(default_factory=dict)
    headers: dict[str, str] = field(default_factory=dict)

    def __reduce__(self) -> tuple[type[Self], tuple[Any, ...]]:
        """How it is handed to another process."""
        return type(self), tuple(getattr(self, each.name) for each in fields(self))

    def body(self) -> dict[str, Any]:
        """The problem as JSON."""
        body: dict[str, Any] = {
            "type": f"/problems/{self.kind}",
            "title": self.title,
            "status": self.status,
            "detail": self.detail,
            "errors": [{"pointer": each.pointer, "detail": each.detail} for each in self.errors],
        }
        if self.where:
            body["where"] = self.where
        return body

    def response(self) -> Response:
        """The problem as an HTTP answer."""
        return Response(
            orjson.dumps(self.body()), self.status, headers=self.headers, media_type=MEDIA_TYPE
        )


def invalid_input(errors: list[ErrorItem]) -> Problem:
    """Problem of a request whose fields are wrong."""
    detail = "; ".join(
        f"{each.pointer.lstrip('/').replace('/', '.') or 'The body'} {each.detail}"
        for each in errors
    )
    return Problem(422, "invalid-input", "The input is wrong", detail, errors)


def too_large(limit: int) -> Problem:
    """Problem of a body above the limit."""
    return Problem(413, "too-large", "Too large", f"The body exceeds {limit} bytes")


def http_problem(error: HTTPException) -> Problem:
    """Problem of an HTTP error: no such path, wrong method."""
    title = HTTPStatus(error.status_code).phrase
    return Problem(
        error.status_code,
        title.lower().replace(" ", "-"),
        title,
        str(error.detail),
        headers=dict(error.headers or {}),
    )


def unavailable(detail: str) -> Problem:
    """Problem of a service that cannot answer now but may soon."""
    return Problem(
        503, "unavailable", "Not available now", detail, headers={"retry-after": RETRY_AFTER_S}
    )


def failure(request_id: str) -> Problem:
    """Problem of an error of our own; what it was is for the log only, under the request's id."""
    return Problem(
        500,
        "failure",
        "The service failed",
        f"This is an error of the service, not of the input; its log names request {request_id}",
    )


def pointer(path: Iterable[str | int]) -> str:
    """JSON pointer (RFC 6901) of a path."""
    return "".join("/" + str(part).replace("~", "~0").replace("/", "~1") for part in path)


UNION_TAGS = (
    "name",
    "values",
    "peak_force",
    "contact_line_length",
    "meshing_load",
    "roller_sharing",
    "shaft_deflection",
)
"""Names of the branches of our unions: pydantic puts them into the path; they are no fields."""

_COMPARISONS = {
    "greater_than": ("gt", "must be greater than {}"),
    "greater_than_equal": ("ge", "must be at least {}"),
    "less_than": ("lt", "must be less than {}"),
    "less_than_equal": ("le", "must be at most {}"),
    "too_long": ("max_length", "must have at most {} entries"),
    "too_short": ("min_length", "must have at least {} entries"),
    "multiple_of": ("multiple_of", "must be a multiple of {}"),
    "literal_error": ("expected", "must be one of {}"),
}
_MESSAGES = {
    "missing": "is needed",
    "extra_forbidden": "is not a known field",
    "finite_number": "must be a finite number",
    "float_type": "must be a number",
    "int_type": "must be a whole number",
    "int_from_float": "must be a whole number",
    "bool_type": "must be true or false",
    "string_type": "must be a text",
    "list_type": "must be a list",
    "tuple_type": "must be a list",
    "dict_type": "must be an object",
    "model_type": "must be an object",
    "model_attributes_type": "must be an object",
    "string_unicode": "is not valid text",
}
"""What pydantic's error types say to a user; the only place where they are worded."""


def _worded(error: dict[str, Any]) -> str:
    kind, context = error["type"], error.get("ctx", {})
    if kind == FIELD_ERROR:
        return str(context["message"])
    if kind in _COMPARISONS:
        name, text = _COMPARISONS[kind]
        value = context.get(name)
        return text.format(f"{value:.15g}" if isinstance(value, float) else value)
    if kind == "json_invalid":
        return f"is not valid JSON: {context['error']}"
    return _MESSAGES.get(kind, str(error.get("msg", "is not valid")).lower())


def wrong_fields(errors: Iterable[Any]) -> Problem:
    """Problem of what pydantic found wrong with a request."""
    return invalid_input(_items(errors))


def _items(errors: Iterable[Any]) -> list[ErrorItem]:
    items: dict[str, ErrorItem] = {}
    for error in errors:
        path = list(error["loc"])
        if error["type"] == "json_invalid":
            path = []
        elif path and path[0] == "body":
            path = path[1:]
        if error["type"] == FIELD_ERROR:
            path.append(error["ctx"]["field"])
        path = [part for part in path if part not in UNION_TAGS]
        place = pointer(path)
        items.setdefault(place, ErrorItem(place, _worded(error)))
    return list(items.values())


def impossible(error: ImpossibleMechanism) -> Problem:
    """Problem of a mechanism that cannot exist or cannot work."""
    where = dict(api_value(name, value) for name, value in error.where.items())
    at = ", ".join(f"{name} = {value:.10g}" for name, value in where.items())
    what = api_text(error.what)
    return Problem(
        422,
        "impossible-mechanism",
        "The mechanism cannot work",
        f"{what} at {at}" if at else what,
        where=where,
    )


def install(app: FastAPI) -> None:
    """Make every refusal a problem; errors of our own are left to `Requests`."""

    async def on_problem(_: Request, problem: Exception) -> Response:
        assert isinstance(problem, Problem)
        return problem.response()

    async def on_impossible(_: Request, error: Exception) -> Response:
        assert isinstance(error, ImpossibleMechanism)
        return impossible(error).response()

    async def on_validation(_: Request, error: Exception) -> Response:
        assert isinstance(error, RequestValidationError)
        return wrong_fields(error.errors()).response()

    async def on_http(_: Request, error: Exception) -> Response:
        assert isinstance(error, HTTPException)
        return http_problem(error).response()

    app.add_exception_handler(Problem, on_problem)
    app.add_exception_handler(ImpossibleMechanism, on_impossible)
    app.add_exception_handler(RequestValidationError, on_validation)
    app.add_exception_handler(HTTPException, on_http)
