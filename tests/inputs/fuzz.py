"""Sends requests to the service in this process and checks every answer.

No failure of the service, nothing that is not finite, the schema of the description; a refusal is a
known problem that points into the body. Whether numbers are right, `tests/oracles/answers` tells.
"""

import json
import math
import time
import warnings
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any

import jsonschema_rs

from app.main import create_app
from app.settings import Settings
from tests.inputs.fuzz_requests import (
    DESCRIPTION,
    MODELS,
    Body,
    Draw,
    Request,
    random_request,
)
from tests.inputs.in_process import API, exchange

SLOW_S = 1.0
FIELDS = {name for model in MODELS.values() for name in model.get("properties", ())}
PROBLEMS = {
    413: {"too-large"},
    415: {"unsupported-media-type"},
    422: {"invalid-input", "impossible-mechanism"},
}


@dataclass(slots=True)
class Report:
    """Results of the requests.

    Attributes
    ----------
    answers : Counter
        Answers by endpoint and status.
    slow : list of (float, str, str)
        Requests above `SLOW_S`: seconds, endpoint, the start of the body.
    failures : list of str
        What broke, with the request.
    """

    answers: Counter[tuple[str, int]] = field(default_factory=Counter)
    slow: list[tuple[float, str, str]] = field(default_factory=list)
    failures: list[str] = field(default_factory=list)

    def add(self, other: "Report") -> None:
        """Put another report into this one."""
        self.answers += other.answers
        self.slow += other.slow
        self.failures += other.failures


class Fuzz:
    """Sends requests to the service in this process and checks the answers."""

    def __init__(self) -> None:
        self.app = create_app(Settings(max_seconds=60.0))
        self.report = Report()
        self.schemas: dict[tuple[str, int], Any] = {}
        parts = {"components": DESCRIPTION["components"]}  # once for all: each copy takes megabytes
        registry = jsonschema_rs.Registry([("urn:api", parts)])
        for path, operations in DESCRIPTION["paths"].items():
            for status, answer in operations.get("post", {}).get("responses", {}).items():
                schema = next(iter(answer["content"].values()))["schema"]
                whole = json.loads(json.dumps(schema).replace('"#/', '"urn:api#/'))
                self.schemas[path.removeprefix(API), int(status)] = jsonschema_rs.validator_for(
                    whole, registry=registry
                )

    async def send(self, request: Request) -> tuple[int, dict[bytes, bytes], bytes]:
        """Status, headers and body of the answer to a request; its time is noted."""
        body, start = request.body(), time.perf_counter()
        answer = await exchange(
            self.app, API + request.endpoint, body,
            method=request.method, query=request.query, headers=request.headers,
        )  # fmt: skip
        took = time.perf_counter() - start
        self.report.answers[request.endpoint, answer[0]] += 1
        if took > SLOW_S:
            self.report.slow.append((took, request.endpoint, repr(body[:300])))
        return answer

    async def ask(self, endpoint: str, body: Body) -> Body | None:
        """Answer to one more request; None where it is refused."""
        status, _, content = await self.send(Request(endpoint, body))
        return json.loads(content) if status == 200 else None

    async def check(self, request: Request) -> None:
        """Send a request and check everything about its answer."""
        status, headers, content = await self.send(request)
        assert (request.endpoint, status) in self.schemas, f"status {status} is not described"
        answer = json.loads(content, parse_constant=_not_finite)
        self.schemas[request.endpoint, status].validate(answer)
        if status == 200:
            assert headers[b"content-type"] == b"application/json"
            for stated in _accuracies(answer):
                assert 0 <= stated["relative_error"] < math.inf, stated
                assert stated["evaluations"] >= 0 and stated["run_time_us"] >= 0, stated
        elif status == 503:
            assert answer["type"] == "/problems/too-long" or int(headers[b"retry-after"]) > 0
        else:
            assert headers[b"content-type"] == b"application/problem+json"
            assert answer["status"] == status
            assert answer["type"].removeprefix("/problems/") in PROBLEMS[status], answer["type"]
            for each in answer["errors"]:
                if request.json is not None and not each["pointer"].startswith("/query/"):
                    _resolve(each["pointer"], request.json)
            numbers, _, chart = request.endpoint.rpartition("/")
            if chart == "chart" and request.json and "range of numbers" in answer["detail"]:
                shown = await self.ask(numbers, request.json)
                assert shown is None, f"a figure of numbers that there are: {answer['detail']}"

    async def run(self, requests: int, seed: int) -> Report:
        """Send random requests."""
        warnings.simplefilter("error")
        r = Draw(seed)
        for _ in range(requests):
            request = random_request(r)
            try:
                await self.check(request)
            except Exception as error:  # whatever it is, it goes into the report
                body = request.body()[:1500]
                place = f"{request.endpoint}?{request.query} {request.headers}"
                what = f"{type(error).__name__}: {str(error)[:400]}"
                self.report.failures.append(f"{place}\n  {what}\n  {body!r}")
        return self.report


def _accuracies(answer: Any) -> Iterator[Body]:
    """Every statement of accuracy in an answer."""
    if isinstance(answer, dict):
        yield from (answer[name] for name in answer.keys() & {"accuracy"})
        for value in answer.values():
            yield from _accuracies(value)


def _not_finite(name: str) -> None:
    raise AssertionError(f"{name} in the answer")


def _resolve(pointer: str, body: Any) -> None:
    """Follow a JSON pointer; at its end a field of a request may be missing."""
    parts = [each.replace("~1", "/").replace("~0", "~") for each in pointer.split("/")[1:]]
    for i, part in enumerate(parts):
        if isinstance(body, list):
            body = body[int(part)]
        elif part in body or i < len(parts) - 1 or part not in FIELDS:
            body = body[part]
