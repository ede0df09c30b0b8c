"""Client of a KHV Calc service, for scripts. One file, needs httpx only: copy it where you need it.

    from khv_calc import Client, Refused

    with Client("http://127.0.0.1:8000") as calc:
        load = {"output_torque_Nm": 500, "pin_circle_radius_mm": 50}
        force = calc.ask("contact-force", load, pins=3, ratio=20)
        print(force["peak_force_N"], force["accuracy"]["relative_error"])

Names of calculations and fields are those of the API (its description: /docs of the service).
"""

import json
import time
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any, Self

import httpx

MOST_AT_ONCE, MOST_BYTES = 1000, 1 << 20
"""Most requests, and most bytes, of one batch that a service takes by default."""

Answer = dict[str, Any]
"""Answer as the service sends it; sections that were not asked for are absent."""


@dataclass(frozen=True)
class Fault:
    """One reason why a request was refused.

    `pointer` is the JSON pointer of the field, empty for the request as a whole. Programs use
    `code` and `params`, people read `detail`; `was` is an earlier code that `code` replaces.
    """

    pointer: str
    code: str
    params: dict[str, Any]
    detail: str
    was: str = ""


class Refused(Exception):
    """Error of a request that the service does not answer; `problem` holds all that it sent."""

    def __init__(self, problem: Mapping[str, Any]) -> None:
        super().__init__(problem)
        self.problem = problem
        self.status: int = problem["status"]
        self.where: dict[str, float] = problem.get("where", {})
        self.faults = [
            Fault(
                each["pointer"],
                each["code"],
                each["params"],
                each["detail"],
                each.get("was", ""),
            )
            for each in problem["errors"]
        ]

    def __str__(self) -> str:
        return str(self.problem["detail"])


class Client:
    """Connection to a KHV Calc service.

    Parameters
    ----------
    url : str
        Address of the service.
    patience_s : float
        How long a request is repeated while the service is busy, s. The service names the times.
    timeout_s : float
        Longest silence of the service in an answer, s.
    transport : httpx.BaseTransport, optional
        Another way to the service, for a proxy, certificates or tests.
    """

    def __init__(
        self,
        url: str = "http://127.0.0.1:8000",
        *,
        patience_s: float = 60.0,
        timeout_s: float = 30.0,
        transport: httpx.BaseTransport | None = None,
    ) -> None:
        self.patience_s = patience_s
        self._http = httpx.Client(
            base_url=f"{url.rstrip('/')}/api/v1/",
            timeout=timeout_s,
            transport=transport,
            limits=httpx.Limits(keepalive_expiry=2.0),  # shorter than the service's
        )

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """Close the connections to the service."""
        self._http.close()

    def get(self, name: str) -> Answer:
        """Information of the service: `calculations`, `materials`, `words`, `examples`, ..."""
        with self._answer("GET", name) as answer:
            return _object(answer.read())

    def ask(
        self, calculation: str, body: Mapping[str, Any] | None = None, /, **fields: Any
    ) -> Answer:
        """Answer of a calculation, or its Plotly figure if the name ends with `/chart`.

        The request joins `body` and `fields`, which may contain NumPy numbers and arrays.

        Raises
        ------
        Refused
            If the input is wrong, the mechanism cannot work, or the service stays busy.
        """
        content = _json({**(body or {}), **fields})
        with self._answer("POST", calculation, content) as answer:
            return _object(answer.read())

    def ask_as_found(
        self, calculation: str, body: Mapping[str, Any] | None = None, /, **fields: Any
    ) -> Iterator[Answer]:
        """Lines of an answer as the service finds it: ``{"progress": 0.4, "proposal": {...}}`` of
        `propose`, ``{"progress": 0.25}`` of `tolerance-study`, `sweep`, `sensitivity`, at last
        ``{"result": {...}}``.

        Closing the iterator ends the calculation. `Refused` is raised as by `ask`.
        """
        content = _json({**(body or {}), **fields})
        lines = "application/x-ndjson"
        with self._answer("POST", calculation, content, accept=lines) as answer:
            for line in answer.iter_lines():
                said = _object(line)
                if "problem" in said:
                    raise Refused(said["problem"])
                yield said

    def file(
        self, export: str, body: Mapping[str, Any] | None = None, /, **fields: Any
    ) -> tuple[str, bytes]:
        """Name and content of a file, such as `export/dxf`.

        The request is given, and `Refused` raised, as by `ask`.
        """
        content = _json({**(body or {}), **fields})
        with self._answer("POST", export, content, accept="*/*") as answer:
            named = answer.headers["content-disposition"]
            return named.partition('filename="')[2].rstrip('"'), answer.read()

    def ask_many(
        self,
        calculation: str,
        bodies: Iterable[Mapping[str, Any]],
        *,
        at_once: int = MOST_AT_ONCE,
        most_bytes: int = MOST_BYTES,
    ) -> Iterator[Answer | Refused]:
        """Answers to many requests of one calculation, in their order, each as soon as it is done.

        A request that cannot be answered gives a `Refused` in its place; nothing is raised for it.
        Requests are sent in batches of at most `at_once` requests and `most_bytes` bytes. The
        service does not wait long for a client that takes no answers: do slow work after the last
        answer.
        """
        head = f'{{"calculation": {json.dumps(calculation)}, "requests": ['
        for some in _cut(map(_json, bodies), at_once, most_bytes - len(head) - len("]}")):
            batch = f"{head}{','.join(some)}]}}"
            with self._answer("POST", "batch", batch, accept="application/x-ndjson") as answer:
                for _, line in zip(some, answer.iter_lines(), strict=True):
                    item = _object(line)
                    yield item["result"] if "result" in item else Refused(item["problem"])

    def reopened(self, file: str) -> Iterator[tuple[str, Answer, dict[str, tuple[Any, Any]]]]:
        """Designs of a project file, asked again: name, answer, and the kept results that moved by
        more than 1e-6, each before and after.

        `file` is the text of a file that the page saved. Designs of the first form keep no request
        and are left out: the page reads them. `Refused` is raised as by `ask`.
        """
        project = _object(file)
        if project.get("format") != "khv-calc designs":
            raise ValueError("this is no project file of KHV Calc")
        for design in project["designs"]:
            if "body" in design:
                include = [*design["body"].get("include", [])]
                largest = "largest_torque_Nm" in design["results"]
                more = {"include": [*include, "largest_torque"]} if include and largest else {}
                answer = self.ask(design["path"].lstrip("/"), design["body"], **more)
                yield design["name"], answer, _moved(design["results"], answer)

    @contextmanager
    def _answer(
        self, method: str, path: str, content: str | None = None, accept: str = "application/json"
    ) -> Iterator[httpx.Response]:
        """Yield a good answer, not read yet; a busy service is asked again when it says."""
        headers = {"accept": accept, "content-type": "application/json"}
        end = time.monotonic() + self.patience_s
        while True:
            with self._http.stream(method, path, content=content, headers=headers) as answer:
                if answer.is_success:
                    yield answer
                    return
                answer.read()
            again = answer.headers.get("retry-after", "")
            if not again.isdigit() or time.monotonic() + int(again) > end:
                break
            time.sleep(int(again))
        if answer.headers.get("content-type") == "application/problem+json":
            raise Refused(answer.json())
        answer.raise_for_status()


def _moved(kept: Mapping[str, Any], answer: Answer) -> dict[str, tuple[Any, Any]]:
    """Kept results that an answer has differently, each before and after."""
    judged = [answer, *(answer.get(name, {}) for name in ("load_sharing", "hertz"))]
    parts = [*judged, *(each for each in answer.values() if isinstance(each, dict))]
    found = {}
    for name, before in kept.items():
        after = next((each[name] for each in parts if name in each), before)
        numbers = isinstance(before, (int, float)) and isinstance(after, (int, float))
        if abs(after - before) > 1e-6 * abs(before) if numbers else after != before:
            found[name] = before, after
    return found


def is_called(said: Mapping[str, Any], code: str) -> bool:
    """True if a warning or a reason has this code, or has replaced it."""
    return code in (said["code"], said.get("was"))


def _cut(requests: Iterable[str], at_once: int, most_bytes: int) -> Iterator[list[str]]:
    """Batches of at most so many requests and bytes with commas, but of at least one request."""
    some: list[str] = []
    size = 0
    for each in requests:
        if some and (len(some) == at_once or size + len(each) >= most_bytes):
            yield some
            some, size = [], 0
        some.append(each)
        size += len(each) + 1
    if some:
        yield some


def _json(body: Mapping[str, Any]) -> str:
    """JSON of a request, in ASCII."""
    return json.dumps(body, default=_plain, allow_nan=False)


def _object(text: str | bytes) -> Answer:
    values: Answer = json.loads(text)
    return values


def _plain(value: Any) -> Any:
    """NumPy number or array as plain Python values."""
    if not hasattr(value, "tolist"):
        raise TypeError(f"{type(value).__name__} cannot be sent as JSON")
    return value.tolist()
