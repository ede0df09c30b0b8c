"""Errors as problem details (RFC 9457), with one table from exception to status; and refusals of a
calculation in the names of its request.
"""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field, fields, replace
from typing import Annotated, Any, NoReturn, Self, cast

import orjson
from fastapi import Request
from fastapi.exceptions import RequestValidationError
from fastapi.responses import Response
from pydantic import BaseModel, Field, ValidationError
from pydantic_core import ErrorDetails
from starlette.exceptions import HTTPException

from app.jobs import Busy, CannotRun, Stopped, TooLong
from app.model import REPLACED, UNION_TAGS, Export, Maybe, RequestModel, pointer, present
from app.record import root_path
from app.units import IN_MILLIMETRES, api_params, api_value, refusal_params, sentence
from core.codes import REFUSALS, WAS
from core.errors import CalculationError, ImpossibleMechanism, InvalidInput, NotKnown

MEDIA_TYPE = "application/problem+json"

RETRY_AFTER_S = 5
"""Default time of `Retry-After` in a 503, s."""

MAX_ERRORS = 50
"""Largest number of wrong fields that an answer names."""

MAX_DESCRIBED = 1000
"""Largest number of errors that pydantic describes, as describing costs more than finding them."""

OF_REQUESTS = {
    "always_exact": "is no longer asked: forces are solved in exact geometry alone; leave it out",
    "bool_type": "must be true or false",
    "dict_type": "must be an object",
    "dust": "must be 0 or at least {limit:g} in size",
    "elastomer": "must be stiffer: elastomers stretch by their own length at a few MPa, and their "
    "contact is not calculated",
    "extra_forbidden": "is not a known field",
    "float_type": "must be a number",
    "follows_nothing": "follows none of the inputs that vary",
    "int_type": "must be a whole number",
    "json_invalid": "is not valid JSON: {error}",
    "list_type": "must be a list",
    "literal_error": "must be one of {expected}",
    "missing": "is needed",
    "multiple_of": "must be a multiple of {limit:.15g}",
    "moved_to": "is given as {field} now",
    "needed_for": "is needed for {section}",
    "needed_to_draw": "is needed: what is not known is not drawn",
    "no_methods": "has one method only, within {relative_error:.0e}: there is nothing to compare",
    "not_installed": "needs the extra `{extra}`, which is not installed here; {instead} needs none",
    "no_such_part": "is none of the parts that are drawn: {parts}",
    "no_class_of_size": "is known for diameters up to {limit_mm:g} mm only",
    "not_this_cycloid": "must be {expected}, one more than the satellite has: discs of other "
    "cycloids, and those of which lobes are left out, are not calculated",
    "not_there": "names no number in {field}",
    "not_valid": "is not valid",
    "other_ratio": "is not that of {field} and {other}, which give {given:.6g}: leave it out",
    "service_limit": "must be at most {limit}: this service takes no more",
    "several_materials": "says too little: several materials are called so, which differ by much; "
    "name one ({candidates}), or give values",
    "string_type": "must be a text",
    "string_unicode": "is not valid text",
    "to_be_drawn": "must be at most {limit:.3g} to be drawn",
    "too_long": "must have at most {limit} entries",
    "too_nested": "must hold at most {limit} lists and objects",
    "unknown_material": "must be a material of the table, or given by values ({values}). "
    "{materials}. Other names: {aliases}",
    "with_rollers": "must be at most {limit}, with {rollers} rollers",
}
"""Texts of errors found before any calculation, in the form of `core.codes`."""

TEXTS = {code: each.text for code, each in REFUSALS.items()} | OF_REQUESTS | IN_MILLIMETRES
"""Texts of errors by code: the rest of a sentence that starts with the field; the page has its own
words for each code."""

KINDS = {
    "failure": (
        500,
        "The service failed, not the input. The log of the service names the request by its id.",
    ),
    "impossible-mechanism": (
        422,
        "The input is well-formed, but such a mechanism cannot exist or cannot work; `errors` says "
        "why by its code, `where` at which position.",
    ),
    "invalid-input": (
        422,
        "Fields are missing, unknown, or out of their range; `errors` points to them and says by a "
        "code what is wrong.",
    ),
    "method-not-allowed": (
        405,
        "The path is there, but not for this method; `Allow` names those it has.",
    ),
    "not-found": (404, "There is nothing at this path; the API's description lists all."),
    "not-installed": (
        501,
        "The service lacks the extra that the files need; `errors` names it, and the path that "
        "answers without it.",
    ),
    "request-timeout": (
        408,
        "The body did not arrive whole in the time that the service waits.",
    ),
    "too-large": (413, "The body has more bytes than the service takes."),
    "too-long": (
        503,
        "The calculation takes longer than the service allows, and would again: ask for less at "
        "once.",
    ),
    "unavailable": (
        503,
        "Too much is asked at once, or the service starts, stops, or prepares the load sharing "
        "after an installation; `Retry-After` says when to ask again.",
    ),
    "unsupported-media-type": (415, "The body is not sent as plain `application/json`."),
}
"""Kinds of problems, as in the address of their `type`, with HTTP status and meaning."""


def _responses(*statuses: int) -> dict[int | str, dict[str, Any]]:
    """Refusals with these statuses, as the API's description shows them."""
    return {
        status: {
            "description": " ".join(meaning for each, meaning in KINDS.values() if each == status),
            "content": {MEDIA_TYPE: {"schema": {"$ref": "#/components/schemas/ProblemOut"}}},
        }
        for status in statuses
    }


RESPONSES = _responses(413, 415, 422, 503)
"""Refusals of every calculation."""

LACKING = _responses(501)
"""Refusal of files that need an extra."""

_PARAMS = {
    "greater_than": "gt",
    "greater_than_equal": "ge",
    "less_than": "lt",
    "less_than_equal": "le",
    "too_long": "max_length",
    "too_short": "min_length",
    "multiple_of": "multiple_of",
}
_CODES = {
    "float_parsing": "float_type",
    "int_from_float": "int_type",
    "model_attributes_type": "dict_type",
    "model_type": "dict_type",
    "tuple_type": "list_type",
    "union_tag_invalid": "literal_error",
    "union_tag_not_found": "missing",
}
"""Pydantic's parameters and codes where they differ from ours."""

GONE: dict[int | str, str] = {"geometry": "always_exact"}
"""Removed fields of requests with the code of the reason; kept for one release."""

SAYING = ("dust", "several_materials", "unknown_material")
"""Codes whose text contains the message of a validator."""


@dataclass(frozen=True, slots=True)
class FieldProblem:
    """Error of one field."""

    pointer: Annotated[str, Field(description="JSON pointer to the field; empty for the body.")]
    code: Annotated[
        str,
        Field(
            description="Code of the problem.", json_schema_extra=cast(Any, {"enum": sorted(TEXTS)})
        ),
    ]
    params: Annotated[
        dict[str, Any], Field(description="Limits, numbers and fields in the text of the problem.")
    ]
    detail: Annotated[
        str,
        Field(
            description="Text of the problem in English: the rest of a sentence that starts with "
            "the field."
        ),
    ]
    was: Annotated[Maybe[str], Field(description=REPLACED)] = None

    def body(self) -> dict[str, Any]:
        """Error as JSON."""
        return present({each.name: getattr(self, each.name) for each in fields(self)})


def wrong(pointer: str, code: str, **params: Any) -> FieldProblem:
    """Error of the field at a pointer, by a key of `TEXTS` and the parameters of its text."""
    detail = TEXTS[code].format(**params)
    return FieldProblem(pointer, code, params, detail, WAS["errors"].get(code))


@dataclass(slots=True)
class Problem(Exception):
    """Refusal, ready to be sent."""

    kind: str  # last part of the problem's type, a key of `KINDS`
    detail: str  # description for users
    errors: list[FieldProblem] = field(default_factory=list)  # wrong fields
    more: int = 0  # number of further wrong fields
    # Position of the error, by API names.
    where: dict[str, float] = field(default_factory=dict)
    headers: dict[str, str] = field(default_factory=dict)  # headers of the answer

    @property
    def status(self) -> int:
        """HTTP status of the kind."""
        return KINDS[self.kind][0]

    @property
    def title(self) -> str:
        """Meaning of the kind, for users."""
        return self.kind.replace("-", " ").capitalize()

    def __reduce__(self) -> tuple[type[Self], tuple[Any, ...]]:
        """Pickle the problem for another process."""
        return type(self), tuple(getattr(self, each.name) for each in fields(self))

    def body(self) -> dict[str, Any]:
        """Problem as JSON."""
        body: dict[str, Any] = {
            "type": f"{root_path()}/problems/{self.kind}",
            "title": self.title,
            "status": self.status,
            "detail": self.detail,
            "errors": [each.body() for each in self.errors],
        }
        if self.more:
            body["more"] = self.more
        if self.where:
            body["where"] = self.where
        return body

    def naming_at_most(self, errors: int) -> Self:
        """Problem with at most `most` errors; `more` counts those left out."""
        if len(self.errors) <= errors:
            return self
        more = self.more + len(self.errors) - errors
        named = self.errors[:errors]
        return replace(self, errors=named, more=more, detail=_sentence(named, more))

    def beneath(self, place: str) -> "Problem":
        """Problem of a request that is nested at a pointer of another one."""
        errors = [replace(each, pointer=place + each.pointer) for each in self.errors]
        if self.kind != "invalid-input":
            return replace(self, errors=errors)
        return invalid_input(errors, self.more)

    def response(self) -> Response:
        """Problem as an HTTP answer."""
        return Response(
            orjson.dumps(self.body()), self.status, headers=self.headers, media_type=MEDIA_TYPE
        )


class ProblemOut(BaseModel):
    """Refusal (RFC 9457); its type opens a page that explains it."""

    type: str = Field(description="Address of the explanation of this kind of problem.")
    title: str = Field(description="Kind of problem, in English.")
    status: int = Field(description="HTTP status.")
    detail: str = Field(description="Description of the problem, in English.")
    errors: list[FieldProblem] = Field(description=f"The wrong fields, {MAX_ERRORS} at most.")
    more: int = Field(default=0, description="Number of further fields with problems.")
    where: dict[str, float] = Field(
        default_factory=dict, description="Position at which the mechanism cannot work."
    )


def invalid_input(errors: list[FieldProblem], more: int = 0) -> Problem:
    """Problem of a request with wrong fields: the first ones, and the number of others."""
    return Problem("invalid-input", _sentence(errors, more), errors, more).naming_at_most(
        MAX_ERRORS
    )


def refusal(pointer: str, code: str, **params: Any) -> Problem:
    """Problem of one wrong field."""
    return invalid_input([wrong(pointer, code, **params)])


def _sentence(errors: list[FieldProblem], more: int) -> str:
    """Description of the errors of a request, for users."""
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
    """Problem of a body of more bytes than the limit."""
    return Problem("too-large", f"The body exceeds {limit} bytes")


def too_long(limit_s: float) -> Problem:
    """Problem of a calculation that takes too long, now and later."""
    return Problem("too-long", f"The calculation was not done within {limit_s:g} s")


def not_installed(export: Export) -> Problem:
    """Problem of files that need an extra which the service lacks."""
    said = {"extra": export.extra, "instead": f"/{export.instead}"}
    error = wrong("", "not_installed", **said)
    return Problem("not-installed", f"{export.title}: {error.detail}", [error])


def http_problem(error: HTTPException) -> Problem:
    """Problem of an HTTP error such as an unknown path or a wrong method."""
    kind = next(kind for kind, (status, _) in KINDS.items() if status == error.status_code)
    detail = "No such path, see /api/v1/openapi.json" if kind == "not-found" else error.detail
    return Problem(kind, str(detail), headers=dict(error.headers or {}))


def unavailable(detail: str, retry_after_s: int = RETRY_AFTER_S) -> Problem:
    """Problem of a service that cannot answer now but may soon."""
    headers = {"retry-after": str(retry_after_s)}
    return Problem("unavailable", detail, headers=headers)


def wrong_fields(error: ValidationError) -> Problem:
    """Problem of the errors that pydantic found in a request."""
    count = error.error_count()
    if count > MAX_DESCRIBED:
        return invalid_input([], count)
    tag = 1 if error.title.startswith("tagged-union") else 0  # a union's tag precedes its fields
    items: dict[str, FieldProblem] = {}
    for each in error.errors(include_url=False, include_input=False):
        item = _item(each, each["loc"][tag:])
        items.setdefault(item.pointer, item)
    return invalid_input(list(items.values()))


def _item(error: ErrorDetails, place: tuple[int | str, ...]) -> FieldProblem:
    kind, context = error["type"], error.get("ctx", {})
    last = len(place) - 1 if kind == "extra_forbidden" else None  # may be called as a tag is
    path = [part for at, part in enumerate(place) if at == last or part not in UNION_TAGS]
    if kind == "json_invalid":
        return wrong("", kind, error=context["error"])
    if kind == "field_error":
        path += context["name"].split("/") if context["name"] else []
        return wrong(pointer(path), context["code"], **context["params"])
    if kind.startswith("union_tag"):
        path.append(context["discriminator"].strip("'"))
    code = GONE.get(path[-1], kind) if kind == "extra_forbidden" else _CODES.get(kind, kind)
    if code in _PARAMS:
        params = {"limit": context[_PARAMS[code]]}
    elif code == "literal_error":
        params = {"expected": context.get("expected", context.get("expected_tags", ""))}
    else:
        params = dict(context) if code in SAYING else {}
    return wrong(pointer(path), code if code in TEXTS else "not_valid", **params)


def impossible(error: ImpossibleMechanism, place: str = "") -> Problem:
    """Problem of a mechanism that cannot exist or work, with a pointer to the field to change."""
    where = dict(api_value(name, value) for name, value in error.where.items())
    at = ", ".join(f"{name} = {value:.10g}" for name, value in where.items())
    params = api_params(error.params)
    what = sentence(error.code, error.where | params)
    return Problem(
        "impossible-mechanism",
        f"{what} at {at}" if at else what,
        errors=[wrong(place, error.code, **error.where | where | params)],
        where=where,
    )


REFUSED: dict[type[Exception], Callable[[Any], Problem]] = {
    Problem: lambda problem: problem,
    ImpossibleMechanism: impossible,
    HTTPException: http_problem,
    RequestValidationError: lambda error: invalid_input(
        [_item(each, each["loc"]) for each in error.errors()]
    ),
    Busy: lambda busy: unavailable("Too many calculations are waiting", busy.retry_after_s),
    CannotRun: lambda _: unavailable("No process for calculations can be started"),
    TooLong: lambda error: too_long(error.limit_s),
    Stopped: lambda _: unavailable("The process of the calculation was stopped"),
}
"""Problem of each exception; other errors are left to `app.middleware.Requests`."""


def problem_of(error: Exception) -> Problem:
    """Problem of an exception of `REFUSED`."""
    kind = next(kind for kind in REFUSED if isinstance(error, kind))
    return REFUSED[kind](error)


async def refused(_: Request, error: Exception) -> Response:
    """Answer of an exception of `REFUSED`."""
    return problem_of(error).response()


def refuse_for(body: RequestModel, error: CalculationError) -> NoReturn:
    """Refuse a request by an exception of its calculation, in the names of the request's fields."""
    if isinstance(error, InvalidInput):
        raise named(error, body) from error
    if isinstance(error, NotKnown) and error.refusal:
        raise named(error.refusal, body) from error
    if isinstance(error, NotKnown) and error.missing:
        raise refusal(pointer(body.path_of(error.missing[0])), "missing") from error
    if isinstance(error, NotKnown):
        params: Any = error.params
        code = error.code if error.code in TEXTS else "outside_method"
        raise impossible(ImpossibleMechanism(code, **params)) from error
    if isinstance(error, ImpossibleMechanism) and error.parameter:
        raise impossible(error, pointer(body.path_of(error.parameter))) from error
    raise error


@contextmanager
def nested(place: str, body: RequestModel) -> Iterator[None]:
    """Refuse a request that is nested at a pointer of another one by the other one's fields."""
    try:
        try:
            yield
        except CalculationError as error:
            refuse_for(body, error)
    except Problem as error:
        raise error.beneath(place) from error


def named(error: InvalidInput, body: RequestModel) -> Problem:
    """Refusal of the core in the names of a request's fields."""
    path = body.path_of(error.parameter)
    return refusal(pointer(path), error.code, **refusal_params(error.code, error.params, path))
