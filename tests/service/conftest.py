"""The service as operators start it: `python -m app.serve` in a process of its own."""

import json
import os
import socket
import subprocess
import sys
import threading
import time
from contextlib import contextmanager

import httpx
import pytest


class Service:
    """A running service, its address and its log."""

    def __init__(self, limits, workers):
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            self.port = free.getsockname()[1]
        self.url = f"http://127.0.0.1:{self.port}"
        arguments = ["--port", str(self.port), "--workers", str(workers)]
        environment = {name: text for name, text in os.environ.items() if name[:4] != "KHV_"}
        environment |= {f"KHV_{name.upper()}": str(value) for name, value in limits.items()}
        self.process = subprocess.Popen(
            [sys.executable, "-m", "app.serve", *arguments],
            env=environment | {"PYTHONPATH": "."},
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
        )
        self.lines = []
        self.reader = threading.Thread(target=self._read)
        self.reader.start()

    def _read(self):
        self.lines.extend(self.process.stdout)

    def log(self):
        """The log so far: every line of it is JSON."""
        return [json.loads(line) for line in self.lines]

    def wait_until_ready(self):
        for _ in range(300):
            try:
                if httpx.get(f"{self.url}/readyz").status_code == 200:
                    return
            except httpx.TransportError:
                assert self.process.poll() is None, "".join(self.lines)
            time.sleep(0.1)
        raise AssertionError("not ready in 30 s: " + "".join(self.lines))

    def stop(self):
        self.process.terminate()
        self.process.wait(30)
        self.reader.join()
        self.process.stdout.close()


@pytest.fixture(scope="module")
def serve():
    """Context manager of a running service, by its settings."""

    @contextmanager
    def running(workers=1, **limits):
        service = Service(limits, workers)
        try:
            service.wait_until_ready()
            yield service
        finally:
            service.stop()

    return running


@pytest.fixture(scope="module")
def service(serve):
    """A running service with tight limits."""
    with serve(receive_seconds=1.5, max_connections=40, max_seconds=3) as running:
        yield running
