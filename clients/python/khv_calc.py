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
"""Most requests of one batch, and bytes of it, that a service takes by default."""

Answer = dict[str, Any]
"""An answer as the service sends it; what was not asked for is not in it."""


@dataclass(frozen=True)
class Fault:
    """What is wrong with one field.

    `pointer` is the JSON pointer of the field (empty: the request as a whole), `code` and `params`
    are for programs, `detail` is for people; `was` is the code that this one replaces.
    """

    pointer: str
    code: str
    params: dict[str, Any]
    detail: str
    was: str = ""


class Refused(Exception):
    """A request that the service does not answer, and why; `problem` is all that it said."""

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
    """A KHV Calc service.

    Parameters
    ----------
    url : str
        Where it is.
    patience_s : float
        How long a request is repeated while the service is busy, at the times that it names.
    timeout_s : float
        Longest silence of the service in an answer.
    transport : httpx.BaseTransport, optional
        Another way to the service: a proxy, certificates, tests.
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
            limits=httpx.Limits(keepalive_expiry=2.0),  # less than the service keeps them
        )

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """Close its connections."""
        self._http.close()

    def get(self, name: str) -> Answer:
        """What the service says of itself: `calculations`, `materials`, `words`, `examples`, ..."""
        with self._answer("GET", name) as answer:
            return _object(answer.read())

    def ask(
        self, calculation: str, body: Mapping[str, Any] | None = None, /, **fields: Any
    ) -> Answer:
        """Answer of a calculation, or with `/chart` behind its name its Plotly figure.

        The request is `body` and `fields` together; NumPy's numbers and arrays may be in it.

        Raises
        ------
        Refused
            If the input is wrong, the mechanism cannot work, or the service stays busy.
        """
        content = _json({**(body or {}), **fields})
        with self._answer("POST", calculation, content) as answer:
            return _object(answer.read())

    def file(
        self, export: str, body: Mapping[str, Any] | None = None, /, **fields: Any
    ) -> tuple[str, bytes]:
        """Name and content of a file, such as `export/dxf`; the request as in `ask`.

        Raises
        ------
        Refused
            As `ask`.
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
        """Answers to many requests of one calculation, in their order, as they are done.

        What cannot be answered is a `Refused` in its place, not raised. The requests are sent in
        batches of `at_once` and `most_bytes` at most. The service does not wait long for a client
        that takes no answers: do what takes longer afterwards.
        """
        head = f'{{"calculation": {json.dumps(calculation)}, "requests": ['
        for some in _cut(map(_json, bodies), at_once, most_bytes - len(head) - len("]}")):
            batch = f"{head}{','.join(some)}]}}"
            with self._answer("POST", "batch", batch, accept="application/x-ndjson") as answer:
                for _, line in zip(some, answer.iter_lines(), strict=True):
                    item = _object(line)
                    yield item["result"] if "result" in item else Refused(item["problem"])

    @contextmanager
    def _answer(
        self, method: str, path: str, content: str | None = None, accept: str = "application/json"
    ) -> Iterator[httpx.Response]:
        """A good answer, not read yet; a busy service is asked again when it says."""
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


def is_called(said: Mapping[str, Any], code: str) -> bool:
    """Whether a warning or a reason has a code: its own, or the one that it replaces."""
    return code in (said["code"], said.get("was"))


def _cut(requests: Iterable[str], at_once: int, most_bytes: int) -> Iterator[list[str]]:
    """Requests in batches of so many, and of so many bytes with commas, but of one at least."""
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
    """A request as it is sent, in ASCII."""
    return json.dumps(body, default=_plain, allow_nan=False)


def _object(text: str | bytes) -> Answer:
    values: Answer = json.loads(text)
    return values


def _plain(value: Any) -> Any:
    """NumPy's numbers and arrays as JSON."""
    if not hasattr(value, "tolist"):
        raise TypeError(f"{type(value).__name__} cannot be sent as JSON")
    return value.tolist()
