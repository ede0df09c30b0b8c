"""Log line and metrics of each request.

If ``PROMETHEUS_MULTIPROC_DIR`` names a directory, which `app.serve` sets for several workers,
prometheus-client adds the metrics of all through files.
"""

import atexit
import logging
import os
import queue
import threading
import time
from contextlib import suppress
from datetime import UTC, datetime
from functools import cache
from pathlib import Path
from typing import Any

from app.shared_files import DIRECTORY  # before prometheus-client looks for it

# isort: split
import orjson
from prometheus_client import (
    CONTENT_TYPE_LATEST,
    REGISTRY,
    CollectorRegistry,
    Counter,
    Gauge,
    Histogram,
    generate_latest,
)
from prometheus_client.multiprocess import MultiProcessCollector, mark_process_dead

from app import VERSION
from app.record import Record
from app.settings import current

MOST_LINES = 1000
"""Largest number of log lines waiting to be read; further lines are dropped and counted."""

PAUSE_S = 0.01
"""Time over which lines are gathered, s."""

TOGETHER_BYTES = 2048
"""Size at which gathered lines are written: below the 4096 bytes that a pipe writes without lines
of other workers between them."""

LOG = logging.getLogger("khv.request")

# Data that no line shows are not collected, as the logging module advises.
logging.logThreads = logging.logProcesses = logging.logMultiprocessing = False

BUCKETS_S = (0.0005, 0.001, 0.0025, 0.005, 0.01, 0.025, 0.05, 0.1, 0.25, 0.5, 1.0, 2.5, 5.0, 10.0)

REQUESTS = Counter("khv_requests", "Requests answered.", ("method", "route", "status"))
DURATION = Histogram(
    "khv_request_seconds",
    "From the arrival of a request to the start of its answer.",
    ("route",),
    buckets=BUCKETS_S,
)
CALCULATION = Histogram(
    "khv_calculation_seconds",
    "Calculations of a request, without reading and encoding.",
    ("route",),
    buckets=BUCKETS_S,
)
IN_FLIGHT = Gauge(
    "khv_requests_in_flight", "Requests that are being answered.", multiprocess_mode="livesum"
)
DROPPED = Counter("khv_log_lines_dropped", "Lines of the log that nobody read in time.")
BUILD = Gauge(
    "khv_build_info", "1, of this version and build.", ("version", "build"), multiprocess_mode="max"
)
BUILD.labels(VERSION, current().build).set(1)


class Output(logging.Handler):
    """Handler that writes lines to the standard output in a thread; nothing waits for it."""

    def __init__(self) -> None:
        super().__init__()
        self.lines: queue.SimpleQueue[bytes] = queue.SimpleQueue()
        self.taken = self.written = 0
        threading.Thread(target=self._write, daemon=True).start()
        atexit.register(self.flush)

    def emit(self, record: logging.LogRecord) -> None:
        """Queue a line."""
        if self.taken - self.written >= MOST_LINES:
            DROPPED.inc()
            return
        self.lines.put(self.format(record).encode() + b"\n")
        self.taken += 1

    def flush(self) -> None:
        """Wait until lines are written, at most a second."""
        end = time.monotonic() + 1
        while self.written < self.taken and time.monotonic() < end:
            time.sleep(0.005)

    def _write(self) -> None:
        while True:
            text, lines = self.lines.get(), 1
            while len(text) < TOGETHER_BYTES and not self.lines.empty():
                text, lines = text + self.lines.get(), lines + 1
            with suppress(OSError):  # the reader has gone
                while text:
                    text = text[os.write(1, text) :]
            self.written += lines
            if self.lines.empty():
                time.sleep(PAUSE_S)  # waking up for each line costs more than writing it


class JsonLines(logging.Formatter):
    """Formatter with one JSON object per line: time, level, message or fields of a request."""

    def format(self, record: logging.LogRecord) -> str:
        """Line of a record."""
        line: dict[str, Any] = {
            "time": datetime.fromtimestamp(record.created, UTC),
            "level": record.levelname.lower(),
        }
        if isinstance(record.msg, dict):
            line |= record.msg
        else:
            line["message"] = record.getMessage()
        if record.exc_info:
            line["traceback"] = self.formatException(record.exc_info)
        return orjson.dumps(line, option=orjson.OPT_UTC_Z).decode()


WHOLE = ("/static", "/problems")
"""Routes with arbitrary paths below them; each route counts as one."""


def begin() -> None:
    """Count a request as in flight."""
    IN_FLIGHT.inc()


def end(record: Record, method: str, route: str, error: Exception | None) -> None:
    """Count and log an answered request, without its content.

    Parameters
    ----------
    record : Record
        Request; without a status its client has left, which is logged as 499.
    method, route : str
        Method, and path if the route exists.
    error : Exception or None
        Failure, for the log alone.
    """
    IN_FLIGHT.dec()
    if method not in METHODS:
        method = "other"
    route = next((each for each in WHOLE if route.startswith(f"{each}/")), route)
    total_s = (record.answered or time.perf_counter()) - record.started
    requests, duration, calculation = _meters(method, route, record.status or 499)
    requests.inc()
    duration.observe(total_s)
    if record.calculation_us:
        calculation.observe(record.calculation_us / 1e6)
    level = logging.ERROR if error else logging.INFO
    if not LOG.isEnabledFor(level):
        return
    line = {
        "id": record.request_id,
        "client": record.client,
        "method": method,
        "route": route,
        "status": record.status or 499,
        "total_ms": round(total_s * 1e3, 3),
    }
    if record.received:
        line["read_ms"] = round((record.received - record.started) * 1e3, 3)
    if record.calculated:
        line["calculation_ms"] = round(record.calculation_us / 1e3, 3)
    if 0 < record.calculated <= record.answered:  # batches are answered while they are calculated
        line["encode_ms"] = round((record.answered - record.calculated) * 1e3, 3)
    raised = (type(error), error, error.__traceback__) if error else None
    # The record is made here, as logging's search for the calling line costs more than the rest.
    LOG.handle(logging.LogRecord(LOG.name, level, __file__, 0, line, (), raised))


METHODS = frozenset(("GET", "HEAD", "POST", "PUT", "PATCH", "DELETE", "OPTIONS"))


@cache
def _meters(method: str, route: str, status: int) -> tuple[Counter, Histogram, Histogram]:
    """Metrics of a route, cached."""
    return (
        REQUESTS.labels(method, route, str(status)),
        DURATION.labels(route),
        CALCULATION.labels(route),
    )


def _forget_the_dead(shared: Path) -> None:
    """Drop requests that killed workers had in flight; answered ones stay counted."""
    for file in shared.glob("gauge_live*_*.db"):
        pid = int(file.stem.rsplit("_", 1)[1])
        try:
            os.kill(pid, 0)
        except ProcessLookupError:
            mark_process_dead(pid)  # type: ignore[no-untyped-call]


def metrics() -> tuple[bytes, str]:
    """All metrics in Prometheus format, other workers included, and their media type."""
    registry = REGISTRY
    if DIRECTORY in os.environ:
        _forget_the_dead(Path(os.environ[DIRECTORY]))
        registry = CollectorRegistry()
        MultiProcessCollector(registry)  # type: ignore[no-untyped-call]
    return generate_latest(registry), CONTENT_TYPE_LATEST
