"""Errors as problem details (RFC 9457): one shape, one table from exception to status."""

from collections.abc import Iterable
from dataclasses import dataclass, field, fields, replace
from http import HTTPStatus
from typing import Any, Self

import orjson
from fastapi import FastAPI, Request
from fastapi.responses import Response
from pydantic import ValidationError
from pydantic_core import ErrorDetails
from starlette.exceptions import HTTPException

from app.schemas.base import FIELD_ERROR, api_text
from app.units import api_value
from core.errors import ImpossibleMechanism

MEDIA_TYPE = "application/problem+json"

RETRY_AFTER_S = 5
"""When to ask again after a 503 where nothing says more, seconds."""

MAX_ERRORS = 50
"""Most wrong fields that an answer names."""

MAX_DESCRIBED = 1000
"""Most errors that pydantic is asked to describe, which costs more than to find them."""

MAX_NAME = 64
"""Most letters of a name in a pointer; longer ones are cut."""


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
    more : int
        How many fields besides are wrong.
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
    more: int = 0
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
        if self.more:
            body["more"] = self.more
        if self.where:
            body["where"] = self.where
        return body

    def naming_at_most(self, errors: int) -> Self:
        """The same with at most so many errors; `more` says how many are left out."""
        if len(self.errors) <= errors:
            return self
        more = self.more + len(self.errors) - errors
        named = self.errors[:errors]
        return replace(self, errors=named, more=more, detail=_sentence(named, more))

    def response(self) -> Response:
        """The problem as an HTTP answer."""
        return Response(
            orjson.dumps(self.body()), self.status, headers=self.headers, media_type=MEDIA_TYPE
        )


def invalid_input(errors: list[ErrorItem], more: int = 0) -> Problem:
    """Problem of a request whose fields are wrong: the first of them, and how many besides."""
    problem = Problem(
        422, "invalid-input", "The input is wrong", _sentence(errors, more), errors, more
    )
    return problem.naming_at_most(MAX_ERRORS)


def _sentence(errors: list[ErrorItem], more: int) -> str:
    """What is wrong with a request, for people."""
    parts = [
        f"{each.pointer.lstrip('/').replace('/', '.') or 'The body'} {each.detail}"
        for each in errors
    ]
    if more:
        parts.append(f"{more} more" if parts else _count(more))
    return "; ".join(parts)


def _count(wrong: int) -> str:
    return "1 field is wrong" if wrong == 1 else f"{wrong} fields are wrong"


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


def unavailable(detail: str, retry_after_s: int = RETRY_AFTER_S) -> Problem:
    """Problem of a service that cannot answer now but may soon."""
    headers = {"retry-after": str(retry_after_s)}
    return Problem(503, "unavailable", "Not available now", detail, headers=headers)


def failure(request_id: str) -> Problem:
    """Problem of an error of our own; what it was is for the log only, under the request's id."""
    return Problem(
        500,
        "failure",
        "The service failed",
        f"This is an error of the service, not of the input; its log names request {request_id}",
    )


def pointer(path: Iterable[str | int]) -> str:
    """JSON pointer (RFC 6901) of a path; names that are too long are cut."""
    return "".join("/" + _cut(str(part)).replace("~", "~0").replace("/", "~1") for part in path)


def _cut(name: str) -> str:
    return name if len(name) <= MAX_NAME else name[: MAX_NAME - 1] + "…"


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


def _worded(error: ErrorDetails) -> str:
    kind, context = error["type"], error.get("ctx", {})
    if kind == FIELD_ERROR:
        return str(context["message"])
    if kind in _COMPARISONS:
        name, text = _COMPARISONS[kind]
        value = context.get(name)
        return text.format(f"{value:.15g}" if isinstance(value, float) else value)
    if kind == "json_invalid":
        return _no_json(context["error"])
    return _MESSAGES.get(kind, str(error.get("msg", "is not valid")).lower())


def _no_json(why: str) -> str:
    return f"is not valid JSON: {why}"


def wrong_json(why: str) -> Problem:
    """Problem of a body that is no JSON."""
    return invalid_input([ErrorItem("", _no_json(why))])


def wrong_fields(error: ValidationError) -> Problem:
    """Problem of what pydantic found wrong with a request."""
    count = error.error_count()
    if count > MAX_DESCRIBED:
        return invalid_input([], count)
    items: dict[str, ErrorItem] = {}
    for each in error.errors(include_url=False, include_input=False):
        path = [part for part in each["loc"] if part not in UNION_TAGS]
        if each["type"] == "json_invalid":
            path = []
        elif each["type"] == FIELD_ERROR:
            path.append(each["ctx"]["field"])
        place = pointer(path)
        items.setdefault(place, ErrorItem(place, _worded(each)))
    return invalid_input(list(items.values()))


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

    async def on_http(_: Request, error: Exception) -> Response:
        assert isinstance(error, HTTPException)
        return http_problem(error).response()

    app.add_exception_handler(Problem, on_problem)
    app.add_exception_handler(ImpossibleMechanism, on_impossible)
    app.add_exception_handler(HTTPException, on_http)
