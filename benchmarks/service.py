"""Cost that the service adds to that of its framework, as ratios in one run; time of its start.

Each request goes to the service and to an empty FastAPI endpoint with the same models, which
answers the same values without calculating them, one after the other in rounds. Processor time
counts: of the applications alone in this process, without log lines, and of the servers over a
connection, where the service writes its log and both pay for HTTP.

In process there are two empty applications: FastAPI as it comes, whose pages of documentation and
telemetry each request passes, and one as lean as the service, without these and with its order of
routes.
"""

import gc
import json
import os
import socket
import statistics
import subprocess
import sys
import time
import timeit
from collections.abc import Callable, Iterator, Sequence
from contextlib import ExitStack, contextmanager
from operator import truediv
from pathlib import Path
from typing import Any

import uvloop
from fastapi import FastAPI, Request, Response
from pydantic import TypeAdapter
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from app.about import API
from app.calculations.contact_force import ContactForceRequest
from app.calculations.contact_force import figure as contact_force_chart
from app.calculations.cyclogram import CyclogramRequest
from app.calculations.hertz import HertzRequest, HertzResponse
from app.calculations.ideal_forces import ContactForceResponse, CyclogramResponse
from app.calculations.roller_strength import RollerStrengthRequest, RollerStrengthResponse
from app.content import encoded
from app.examples import REQUESTS
from app.main import NO_TELEMETRY, create_app
from app.model import RequestModel, ResponseModel
from app.registry import CALCULATIONS
from benchmarks.options import options

ROUNDS, REPEATS, LOOPS = 100, 25, 500
"""Rounds of a comparison, requests in each, and calls in a timing of the parts."""

CLIENT, SERVERS = min(os.sched_getaffinity(0)), max(os.sched_getaffinity(0))
"""Processors of the client and of all servers; all servers share one."""

MODELS: dict[str, tuple[type[RequestModel], type[ResponseModel]]] = {
    "hertz": (HertzRequest, HertzResponse),
    "contact-force": (ContactForceRequest, ContactForceResponse),
    "roller-strength": (RollerStrengthRequest, RollerStrengthResponse),
    "cyclogram": (CyclogramRequest, CyclogramResponse),
}
FORCE = REQUESTS["contact-force"] | {"include": []}
BODIES: dict[str, dict[str, Any]] = {name: REQUESTS[name] for name in MODELS} | {
    "contact-force": FORCE
}
CURVES = FORCE | {"include": ["curves"]}
QUIET = ("--no-access-log", "--log-level", "warning")


def lean() -> FastAPI:
    """Empty application as lean as the service, files first."""
    application = FastAPI(openapi_url=None, telemetry=NO_TELEMETRY)

    async def static(request: Request) -> Response:
        return Response()

    application.add_route("/static/{name:path}", static, include_in_schema=False)
    return with_endpoints(application)


def empty() -> FastAPI:
    """Empty application as FastAPI makes it."""
    return with_endpoints(FastAPI())


def with_endpoints(application: FastAPI) -> FastAPI:
    """Add an empty endpoint for each calculation, in the order of the service, and curves."""

    def add(name: str, given: Any, answered: Any) -> None:
        answer = CALCULATIONS[name].solve(given(**BODIES[name]))

        async def endpoint(body: given) -> answered:
            return answer

        application.post(f"/{name}", response_model_exclude_none=True)(endpoint)

    for name, models in MODELS.items():
        add(name, *models)
    curves = CALCULATIONS["contact-force"].solve(ContactForceRequest(**CURVES))
    chart = contact_force_chart(ContactForceRequest(**FORCE))

    @application.post("/contact-force/curves")
    async def encoded_curves(body: ContactForceRequest) -> Response:
        return Response(encoded(curves), media_type="application/json")

    @application.post("/contact-force/chart")
    async def encoded_chart(body: ContactForceRequest) -> Response:
        return Response(encoded(chart), media_type="application/json")

    return application


async def bare(scope: Scope, receive: Receive, send: Send) -> None:
    """Answer with the least that an ASGI application can."""
    if scope["type"] != "http":
        return
    while (await receive()).get("more_body"):
        pass
    headers = [(b"content-length", b"2")]
    await send({"type": "http.response.start", "status": 200, "headers": headers})
    await send({"type": "http.response.body", "body": b"{}"})


class Server:
    """Server in a process of its own, with one connection."""

    def __init__(self, *command: str) -> None:
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            self.port = free.getsockname()[1]
        started = time.perf_counter()
        self.process = subprocess.Popen(
            [sys.executable, "-m", *command, "--port", str(self.port)], stdout=subprocess.DEVNULL
        )
        os.sched_setaffinity(self.process.pid, {SERVERS})
        while True:
            try:
                self.connection = socket.create_connection(("127.0.0.1", self.port))
                break
            except OSError:
                if self.process.poll() is not None:
                    raise RuntimeError(f"{command} did not start") from None
                time.sleep(0.005)
        self.started = started
        self.connect()

    def connect(self) -> None:
        """Open a new connection, as servers soon close idle ones."""
        self.connection.close()
        self.connection = socket.create_connection(("127.0.0.1", self.port))
        self.connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)

    def ask(self, request: bytes) -> bytes:
        """Body of the whole answer to a request."""
        self.connection.sendall(request)
        received = self.connection.recv(1 << 20)
        head, _, body = received.partition(b"\r\n\r\n")
        length = int(head.lower().split(b"content-length:")[1].split(b"\r\n")[0])
        parts, missing = [body], length - len(body)
        while missing:
            parts.append(self.connection.recv(1 << 20))
            missing -= len(parts[-1])
        if not head.startswith(b"HTTP/1.1 200"):
            raise RuntimeError((head + b"".join(parts)).decode())
        return b"".join(parts)

    def processor_time(self) -> float:
        """Processor time of the server, s."""
        text = Path(f"/proc/{self.process.pid}/schedstat").read_text()
        return int(text.split()[0]) / 1e9

    def cost(self, request: bytes) -> float:
        """Processor time of a request, us."""
        before = self.processor_time()
        for _ in range(REPEATS):
            self.ask(request)
        return (self.processor_time() - before) / REPEATS * 1e6


async def asked(application: ASGIApp, path: str, content: bytes) -> None:
    """Send a request to an application in this process."""
    received = iter([{"type": "http.request", "body": content}])
    status = 0

    async def receive() -> Message:
        return next(received)

    async def send(message: Message) -> None:
        nonlocal status
        status = message.get("status", status)

    headers = {"content-type": "application/json", "content-length": str(len(content))}
    scope: Scope = {
        "type": "http",
        "method": "POST",
        "path": path,
        "query_string": b"",
        "headers": [(name.encode(), value.encode()) for name, value in headers.items()],
    }
    await application(scope, receive, send)
    if status != 200:
        raise RuntimeError(f"{path} answers {status}")


async def in_process(rounds: int) -> None:
    """Print the table of the applications alone."""
    applications = empty(), lean(), create_app()
    gc.freeze()  # like the service
    print(f"{'in process':16s} {'empty us':>9s} {'lean us':>9s} {'service us':>10s}  ratios")
    for name in MODELS:
        content = json.dumps(BODIES[name]).encode()
        costs: list[list[float]] = []
        for _ in range(rounds + 1):
            costs.append([])
            paths = f"/{name}", f"/{name}", f"{API}/{name}"
            for application, path in zip(applications, paths, strict=True):
                started = time.thread_time()
                for _ in range(REPEATS):
                    await asked(application, path, content)
                costs[-1].append((time.thread_time() - started) / REPEATS * 1e6)
        print_compared(name, costs[1:])


def print_compared(name: str, costs: Sequence[Sequence[float]]) -> None:
    """Print medians of processor times, us, and of ratios of the last to each of the others."""
    *others, own = zip(*costs, strict=True)
    ratios = [statistics.median(map(truediv, own, each)) for each in others]
    times = " ".join(f"{statistics.median(each):9.0f}" for each in others)
    told = " ".join(f"{ratio:9.2f}" for ratio in ratios)
    print(f"{name:16s} {times} {statistics.median(own):10.0f} {told}")


@contextmanager
def running(*command: str) -> Iterator[Server]:
    """Start a server and stop it at the end."""
    server = Server(*command)
    try:
        yield server
    finally:
        server.process.terminate()
        server.process.wait(60)


def post(path: str, body: object) -> bytes:
    """Bytes of a request."""
    content = json.dumps(body).encode()
    head = f"POST {path} HTTP/1.1\r\nhost: service\r\ncontent-type: application/json\r\n"
    return f"{head}content-length: {len(content)}\r\n\r\n".encode() + content


def compared(
    first: Server, one: bytes, second: Server, other: bytes, rounds: int
) -> list[tuple[float, float]]:
    """Processor times of two requests in rounds, us."""
    return [(first.cost(one), second.cost(other)) for _ in range(rounds + 1)][1:]


def start_up(service: Server) -> float:
    """Seconds from the start of the service to its first answer."""
    service.ask(post("/api/v1/hertz", BODIES["hertz"]))
    return time.perf_counter() - service.started


def main(rounds: int = ROUNDS, starts: int = 4, loops: int = LOOPS) -> None:
    """Print the tables and the time that the service takes to start."""
    os.sched_setaffinity(0, {CLIENT})
    uvloop.run(in_process(rounds))
    started = []
    with ExitStack() as stack:
        for left in reversed(range(starts)):
            service = stack.enter_context(running("app.serve"))
            started.append(start_up(service))
            if left:
                stack.close()
        bare_one, empty_one = (
            stack.enter_context(running("uvicorn", f"benchmarks.service:{named}", *rest, *QUIET))
            for named, *rest in (("bare",), ("empty", "--factory"))
        )
        time.sleep(2)  # until the service has started its process for long calculations
        for each in (bare_one, empty_one, service):
            each.connect()
        print(f"{'over HTTP':16s} {'empty us':>9s} {'service us':>10s} {'ratio':>10s}")
        requests = [(name, name, name, BODIES[name]) for name in MODELS]
        requests += [
            ("curves", "contact-force/curves", "contact-force", CURVES),
            ("chart", "contact-force/chart", "contact-force/chart", FORCE),
        ]
        for name, path, own_path, body in requests:
            other, own = post(f"/{path}", body), post(f"{API}/{own_path}", body)
            print_compared(name, compared(empty_one, other, service, own, rounds))
        curves = post(f"{API}/contact-force", CURVES)
        print("beside the least that an ASGI application can answer:")
        print_compared("curves", compared(bare_one, post("/", {}), service, curves, rounds))
    print(f"from start to first answer: {min(started):.2f} s")
    print("\nparts of a request, microseconds")
    print(f"{'request':24s} {'read':>6s} {'answer':>6s} {'encode':>6s}")
    for name, (given, _) in MODELS.items():
        print_parts(name, given, BODIES[name], CALCULATIONS[name].solve, loops)
    given, _ = MODELS["contact-force"]
    print_parts("curves", given, CURVES, CALCULATIONS["contact-force"].solve, loops)
    print_parts("chart", given, FORCE, contact_force_chart, loops)


def print_parts(
    name: str,
    given: type[RequestModel],
    request: dict[str, Any],
    answer: Callable[[Any], Any],
    loops: int,
) -> None:
    """Print times of the parts of an answer besides HTTP."""
    model, content = TypeAdapter[Any](given), json.dumps(request)
    body = model.validate_json(content)
    values = answer(body)
    times = (
        timed(lambda: model.validate_json(content), loops),
        timed(lambda: answer(body), loops),
        timed(lambda: encoded(values), loops),
    )
    print(f"{name:24s} " + " ".join(f"{us:6.1f}" for us in times))


def timed(call: Callable[[], object], loops: int) -> float:
    """Time of a call, us."""
    return min(timeit.repeat(call, number=loops, repeat=9)) / loops * 1e6


if __name__ == "__main__":
    if options(__doc__).smallest:
        main(rounds=1, starts=1, loops=1)
    else:
        main()
