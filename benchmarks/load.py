"""Load on the running service: 1,000 connections, a worker killed, the service stopped.

Two workers on this machine are asked from 1,000 connections at once, each of which sends its next
request when the last is answered. Answered, unanswered and refused requests are counted in quiet,
with one worker killed (SIGKILL), with ten processes for long calculations killed one after the
other, and while all is stopped (SIGTERM). The rate is a ratio to an empty FastAPI endpoint in the
same run. `make load`; the number of connections may be given: `python -m benchmarks.load 200`.
"""

import asyncio
import contextlib
import json
import os
import random
import resource
import signal
import socket
import subprocess
import sys
import time
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import cast

import uvloop
from fastapi import FastAPI

from app.examples import EXAMPLES
from benchmarks.options import options
from benchmarks.revision import ROOT

CONNECTIONS = 1000
WORKERS = 2
SECONDS = 5.0

hello = FastAPI()


@hello.get("/hello")
async def _hello() -> dict[str, str]:
    return {"hello": "world"}


def _post(path: str, body: object) -> bytes:
    content = json.dumps(body).encode()
    head = f"POST {path} HTTP/1.1\r\nhost: service\r\ncontent-type: application/json\r\n"
    return f"{head}content-length: {len(content)}\r\n\r\n".encode() + content


HELLO = b"GET /hello HTTP/1.1\r\nhost: service\r\n\r\n"
HERTZ = _post(
    "/api/v1/hertz",
    {"force_N": 5000, "contact_length_mm": 20, "pin_radius_mm": 8, "hole_radius_mm": 10},
)
CRANK_PLANETARY = _post("/api/v1/crank-planetary", EXAMPLES[0]["input"])
LONG = _post("/api/v1/cyclogram", {"pins": 100, "satellites": 12, "ratio": 20})
"""Request of a calculation outside the event loop."""

ASKING_LONG = 40
"""Connections that ask for LONG: no more than a worker lets wait of one client."""

KILLED = 10


@dataclass(slots=True)
class Count:
    """Outcomes of the requests of a run."""

    statuses: Counter[int] = field(default_factory=Counter)  # whole answers by HTTP status
    unanswered: int = 0  # requests whose connection closed before a byte of the answer
    not_taken: int = 0  # unanswered ones, first on a connection that no worker had taken
    cut: int = 0  # requests whose answer stopped midway
    refused: int = 0  # connections that were not taken
    longest: float = 0.0  # longest time to a whole answer, s

    def __str__(self) -> str:
        answered = ", ".join(f"{status}: {n}" for status, n in sorted(self.statuses.items()))
        return (
            f"answered {answered or 0}; unanswered {self.unanswered} ({self.not_taken} of them the "
            f"first on their connection), cut {self.cut}, "
            f"connections refused {self.refused}; longest wait {self.longest * 1e3:.0f} ms"
        )


class Connection(asyncio.Protocol):
    """Connection that asks again as soon as it is answered."""

    def __init__(self, request: bytes, count: Count, running: Callable[[], bool]) -> None:
        self.request, self.count, self.running = request, count, running
        self.closed: asyncio.Future[None] = asyncio.get_running_loop().create_future()
        self.waiting, self.first = False, True
        self.received = bytearray()

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        self.transport = cast(asyncio.Transport, transport)
        self._ask()

    def _ask(self) -> None:
        if not self.running():
            self.transport.close()
            return
        self.received.clear()
        self.waiting, self.asked = True, time.perf_counter()
        self.transport.write(self.request)

    def data_received(self, data: bytes) -> None:
        self.received += data
        head, found, body = self.received.partition(b"\r\n\r\n")
        if not found:
            return
        headers = bytes(head).lower()
        length = int(headers.split(b"content-length:")[1].split(b"\r\n")[0])
        if len(body) < length:
            return
        self.waiting = self.first = False
        self.count.statuses[int(headers[9:12])] += 1
        self.count.longest = max(self.count.longest, time.perf_counter() - self.asked)
        if b"connection: close" not in headers:
            self._ask()

    def connection_lost(self, error: Exception | None) -> None:
        if self.waiting:
            if self.received:
                self.count.cut += 1
            else:
                self.count.unanswered += 1
                self.count.not_taken += self.first
        self.closed.set_result(None)


async def load(
    port: int,
    request: bytes,
    connections: int,
    seconds: float,
    after: Sequence[tuple[float, Callable[[], None]]] = (),
) -> tuple[Count, float]:
    """Ask from many connections for some seconds, with actions ``after`` some of them; return the
    outcomes and the answers a second. Closed connections are opened anew.
    """
    count, loop = Count(), asyncio.get_running_loop()
    start = time.perf_counter()

    def running() -> bool:
        return time.perf_counter() - start < seconds

    async def client() -> None:
        while running():
            try:
                _, protocol = await loop.create_connection(
                    lambda: Connection(request, count, running), "127.0.0.1", port
                )
            except OSError:
                count.refused += 1
                await asyncio.sleep(0.2)
            else:
                await protocol.closed

    for delay, act in after:
        loop.call_later(delay, act)
    await asyncio.wait_for(asyncio.gather(*(client() for _ in range(connections))), seconds + 60)
    return count, count.statuses.total() / (time.perf_counter() - start)


@dataclass(slots=True)
class Service:
    """Running service by its parent process and port; ``process`` is None if others started it."""

    pid: int
    port: int
    process: subprocess.Popen[bytes] | None = None

    def workers(self) -> list[int]:
        """Process ids of the workers; of a single worker the parent's."""
        return _children(self.pid, b"spawn_main") or [self.pid]

    def calculators(self) -> list[int]:
        """Process ids of calculating processes, which the fork servers of workers started."""
        servers = [each for worker in self.workers() for each in _children(worker, b"forkserver")]
        return [each for server in servers for each in _children(server)]

    def kill_calculator(self) -> None:
        """Kill one of the calculating processes."""
        if calculators := self.calculators():
            os.kill(random.choice(calculators), signal.SIGKILL)


def _children(pid: int, called: bytes = b"") -> list[int]:
    """Process ids of the children of a process whose command contains a part."""
    started = []
    with contextlib.suppress(FileNotFoundError):
        for listed in Path(f"/proc/{pid}/task").glob("*/children"):
            started += [*map(int, listed.read_text().split())]
    found = []
    for child in started:
        with contextlib.suppress(FileNotFoundError):
            if called in Path(f"/proc/{child}/cmdline").read_bytes():
                found.append(child)
    return found


@contextlib.contextmanager
def service(
    *command: str,
    running: Sequence[int] | None = None,
    workers: int = WORKERS,
    folder: Path = ROOT,
) -> Iterator[Service]:
    """Start a service from a folder on a free port and stop it at the end, or yield the running one
    with this process and port.
    """
    if running:
        yield Service(*running)
        return
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    command = (sys.executable, "-m", *command, "--port", str(port), "--workers", str(workers))
    environment = os.environ | {"PYTHONPATH": "."}
    process = subprocess.Popen(command, cwd=folder, env=environment, stdout=subprocess.DEVNULL)
    try:
        started = Service(process.pid, port, process)
        deadline = time.monotonic() + 60
        while len(started.workers()) < workers or not _answers(port):
            if time.monotonic() > deadline or process.poll() is not None:
                raise TimeoutError("the service does not start")
            time.sleep(0.1)
        time.sleep(2)  # until all workers answer
        yield started
    finally:
        process.terminate()
        process.wait(60)


def _answers(port: int) -> bool:
    try:
        socket.create_connection(("127.0.0.1", port), 1).close()
    except OSError:
        return False
    return True


def main(connections: int, seconds: float = SECONDS) -> int:
    """Run the load and print losses; 1 if the service did not hold."""
    _, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
    resource.setrlimit(resource.RLIMIT_NOFILE, (min(hard, 4 * connections + 1024), hard))

    def run(running: Service, request: bytes, **given: object) -> tuple[Count, float]:
        settings = {"connections": connections, "seconds": seconds} | given
        return uvloop.run(load(running.port, request, **settings))  # type: ignore[arg-type]

    faults = []
    with service(
        "uvicorn", "benchmarks.load:hello", "--no-access-log", "--log-level", "warning"
    ) as running:
        _, bare = run(running, HELLO)
    print(f"{connections} connections, {WORKERS} workers; hello of FastAPI: {bare:.0f}/s")
    with service("app.serve") as running:
        for name, request in (("hertz", HERTZ), ("crank-planetary", CRANK_PLANETARY)):
            count, rate = run(running, request)
            print(f"{name}: {rate:.0f}/s, {rate / bare:.2f} of hello; {count}")
            if set(count.statuses) != {200} or count.unanswered or count.cut or count.refused:
                faults.append(f"{name}: not every request was answered")

        before = running.workers()
        count, rate = run(
            running, HERTZ, seconds=3 * seconds,
            after=[(seconds, lambda: os.kill(before[0], signal.SIGKILL))],
        )  # fmt: skip
        print(f"a worker killed: {rate:.0f}/s; {count}")
        deadline = time.monotonic() + 30
        while len(after := running.workers()) < WORKERS and time.monotonic() < deadline:
            time.sleep(0.1)
        if len(after) != WORKERS or before[0] in after:
            faults.append("the killed worker was not replaced")
        if count.unanswered + count.cut > connections or count.refused:
            faults.append("more was lost than the killed worker held")

        kills = [(seconds * (1 + each) / KILLED, running.kill_calculator) for each in range(KILLED)]
        asking = min(connections, ASKING_LONG)
        count, rate = run(running, LONG, connections=asking, seconds=2 * seconds, after=kills)
        print(f"{KILLED} processes for calculations killed, {asking} asking: {rate:.0f}/s; {count}")
        if count.unanswered or count.cut or not {*count.statuses} <= {200, 503}:
            faults.append("a killed process for calculations cost more than its own requests")

        assert running.process
        count, rate = run(running, HERTZ, after=[(seconds / 2, running.process.terminate)])
        code = running.process.wait(60)
        print(f"stopped (SIGTERM): {count}; exit status {code}")
        if count.unanswered > count.not_taken or count.cut:
            faults.append("a graceful stop lost requests in flight")
    for fault in faults:
        print(f"FAULT: {fault}")
    return bool(faults)


if __name__ == "__main__":
    asked = options(__doc__, connections=CONNECTIONS)
    sys.exit(main(8, seconds=0.2) if asked.smallest else main(asked.connections))
