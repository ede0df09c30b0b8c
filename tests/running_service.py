"""The service as operators start it: `python -m app.serve` in a process of its own."""

import json
import os
import re
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress

import httpx

from tests.inputs.children import end, start


class Service:
    """A running service, its address and its log."""

    def __init__(self, limits, workers, descriptors):
        self.workers = workers
        arguments = ["--port", "0", "--workers", str(workers)]
        environment = {name: text for name, text in os.environ.items() if name[:4] != "KHV_"}
        environment |= {f"KHV_{name.upper()}": str(value) for name, value in limits.items()}
        before = ["sh", "-c", f'ulimit -n {descriptors}; exec "$@"', "sh"] if descriptors else []
        self.process = start(
            *(*before, sys.executable, "-m", "app.serve", *arguments),
            env=environment | {"PYTHONPATH": "."},
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
        )
        self.lines = []
        self.reading = threading.Event()
        self.reading.set()
        self.uds = limits.get("unix_socket")
        self.reader = threading.Thread(target=self._read)
        self.reader.start()

    def _read(self):
        for line in self.process.stdout:
            self.lines.append(line)
            self.reading.wait()

    def hold(self):
        """Read nothing of the log."""
        self.reading.clear()

    def go_on(self):
        """Read the log again."""
        self.reading.set()

    def log(self):
        """The log so far: every line of it is JSON."""
        return [json.loads(line) for line in self.lines]

    def wait_until_ready(self, starts=None):
        """Wait until it listens, all workers have started, as often as is said, and one is ready
        to calculate.
        """
        starts = starts or self.workers
        assert eventually(
            lambda: self._address() and self.said("Application startup complete.") >= starts
        ), "".join(self.lines)
        self.url = self._address()
        self.port = int(self.url.rpartition(":")[2]) if not self.uds else None
        with self.client() as client:
            assert eventually(lambda: client.get("/readyz").status_code == 200)

    def client(self):
        """A client of it, where it listens."""
        transport = httpx.HTTPTransport(uds=self.uds)
        return httpx.Client(base_url=self.url, transport=transport, timeout=60)

    def said(self, message):
        """How often the log says it."""
        return sum(message in line for line in [*self.lines])

    def _address(self):
        """Address of the service, from its log."""
        assert self.process.poll() is None, "".join(self.lines)
        found = re.search(r"running on (?:(http://[\d.:]+)|unix)", "".join(self.lines))
        return found and (found[1] or "http://service")

    def stop(self):
        self.go_on()
        try:
            self.process.terminate()
            self.process.wait(30)
        finally:
            end(self.process)
            self.reader.join()
            self.process.stdout.close()


GONE = FileNotFoundError, ProcessLookupError
"""What /proc says of a process that has ended, and of one that ends as it is read."""


def family(pid: int) -> list[int]:
    """A process and all that it and they have started."""
    started: list[str] = []
    try:
        for thread in os.listdir(f"/proc/{pid}/task"):
            with open(f"/proc/{pid}/task/{thread}/children") as listed:
                started += listed.read().split()
    except GONE:  # it has ended meanwhile
        return []
    return [pid, *(each for child in started for each in family(int(child)))]


def lives(pid: int) -> bool:
    """True if a process still runs; a zombie does not count."""
    try:
        with open(f"/proc/{pid}/stat") as stat:
            return stat.read().rsplit(")", 1)[1].split()[0] != "Z"
    except GONE:
        return False


def calculators(pid: int) -> set[int]:
    """Processes for calculations of a worker: all that its fork server has started."""
    servers = []
    for child in family(pid)[1:]:
        with suppress(*GONE), open(f"/proc/{child}/cmdline", "rb") as command:
            if b"forkserver" in command.read():
                servers.append(child)
    return {child for server in servers for child in family(server)[1:] if lives(child)}


@contextmanager
def nothing_is_calculated(service: Service, processes: int) -> Iterator[Callable[[], None]]:
    """Make long calculations of a service with this number of processes wait until the returned
    function is called.
    """
    assert eventually(lambda: len(calculators(service.process.pid)) == processes)
    stopped = calculators(service.process.pid)

    def signalled(number: int) -> None:
        for pid in stopped:
            with suppress(ProcessLookupError):
                os.kill(pid, number)

    signalled(signal.SIGSTOP)
    try:
        yield lambda: signalled(signal.SIGCONT)
    finally:
        signalled(signal.SIGCONT)


def eventually(holds: Callable[[], bool]) -> bool:
    """True if the condition holds within five minutes: a busy machine compiles that long."""
    for _ in range(3000):
        if holds():
            return True
        time.sleep(0.1)
    return False


@contextmanager
def running_service(
    workers: int = 1, descriptors: int = 0, **limits: float | str
) -> Iterator[Service]:
    """A running service with these settings, ready to answer."""
    service = Service(limits, workers, descriptors)
    try:
        service.wait_until_ready()
        yield service
    finally:
        service.stop()
