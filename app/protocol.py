"""HTTP connections that are bounded: uvicorn's protocol with limits of its own.

What a proxy does well is left to it: slow heads, connections by address (`deploy/nginx.conf`). Here
is what only the connection itself can do: refuse what is too many or too long, and end what does
not come or is not taken.
"""

import asyncio
import logging
from collections import deque
from contextlib import suppress
from itertools import chain
from typing import Any, NoReturn

from starlette.responses import Response
from starlette.types import Receive, Scope, Send
from uvicorn.protocols.http.httptools_impl import HttpToolsProtocol

from app.middleware import HEADERS
from app.problems import Problem, unavailable
from app.settings import OVER_UNIX, current

LOG = logging.getLogger("khv.connection")

MAX_HEAD_BYTES = 65_536
"""Longest request line and headers together."""

LAST_REQUEST_SECONDS = 0.5
"""How long an idle connection may still bring a request while the service stops."""

CODING = b"transfer-encoding"

PROBES = ("/livez", "/metrics")
"""Paths that are answered even beyond the limit of connections: to be full is not to be dead."""


class PatientProtocol(HttpToolsProtocol):
    """A connection with one request at a time, whose answer is taken part by part.

    A second request that comes before the first is answered is not read and ends the connection
    after that answer. A body that is not whole within `KHV_RECEIVE_SECONDS` of its head is refused;
    a client that takes nothing of its answer for as long is cut off. What comes beyond
    `KHV_MAX_CONNECTIONS` is told when to come again.
    """

    def __init__(self, *args: Any, **given: Any) -> None:
        super().__init__(*args, **given)
        self.settings = current()
        self.body_timer: asyncio.TimerHandle | None = None
        self.answer_timer: asyncio.TimerHandle | None = None
        self.head_bytes: int | None = None
        self.stopping = self.ending = False

    def connection_made(self, transport: asyncio.Transport) -> None:  # type: ignore[override]
        """Wait for the first request as for a next one; see whether there is room for it."""
        super().connection_made(transport)
        self.client = self.client or (OVER_UNIX, 0)  # whom uvicorn trusts
        self.timeout_keep_alive_task = self.loop.call_later(
            self.timeout_keep_alive, self.timeout_keep_alive_handler
        )
        if len(self.connections) > self.settings.max_connections:
            self.app = Full(self.app)
            BEYOND.append(self)
            if len(BEYOND) > MOST_BEYOND:
                BEYOND.popleft().transport.abort()  # descriptors are not to run out

    def connection_lost(self, exc: Exception | None) -> None:
        """Wait for nothing."""
        _cancel(self.body_timer)
        _cancel(self.answer_timer)
        with suppress(ValueError):
            BEYOND.remove(self)
        super().connection_lost(exc)

    def data_received(self, data: bytes) -> None:
        """Take a part of a request, unless it is not to be read or its head has no end; what comes
        whole, as most do, waits for nothing.
        """
        if self.ending:
            return
        super().data_received(data)
        if self.head_bytes is not None:
            self.head_bytes += len(data)
            if self.head_bytes > MAX_HEAD_BYTES:
                self._give_up(HEAD_TOO_LARGE)
        elif self.cycle is not None and self.cycle.more_body and self.body_timer is None:
            self.body_timer = self.loop.call_later(
                self.settings.receive_seconds, self._give_up, TOO_SLOW
            )

    def on_message_begin(self) -> None:
        """Begin a request, unless the one before is not answered yet."""
        if self.cycle is not None and not self.cycle.response_complete:
            self._read_no_more()
        super().on_message_begin()
        self.head_bytes = 0

    def on_headers_complete(self) -> None:
        """Hand a request over; while the service stops, its answer is the connection's last."""
        self.head_bytes = None
        if len(self.url) + sum(map(len, chain(*self.headers))) > MAX_HEAD_BYTES:
            self._refuse(HEAD_TOO_LARGE)
        if coded := [value.strip().lower() for name, value in self.headers if name == CODING]:
            if self.parser.get_http_version() == "1.0":
                self._refuse(CODED_TOO_EARLY)
            if coded != [b"chunked"]:
                self._refuse(UNKNOWN_CODING)
        super().on_headers_complete()
        if self.stopping:
            self.cycle.keep_alive = False

    def on_message_complete(self) -> None:
        """The request is whole."""
        _cancel(self.body_timer)
        self.body_timer = None
        super().on_message_complete()

    def on_response_complete(self) -> None:
        """End a connection that has more to bring than was asked of it: that is dropped as long as
        an idle one is kept, so that the answer can be read.
        """
        self.ending |= self.cycle.more_body
        super().on_response_complete()
        if self.ending and not self.transport.is_closing():
            self.transport.write_eof()

    def shutdown(self) -> None:
        """Stop: an idle connection has a moment more, as a request may be on its way already."""
        self.stopping = True
        if self.cycle is None or self.cycle.response_complete:
            self.loop.call_later(LAST_REQUEST_SECONDS, super().shutdown)
        else:
            super().shutdown()

    def pause_writing(self) -> None:
        """Wait for the client to take some of its answer."""
        super().pause_writing()
        self.answer_timer = self.loop.call_later(
            self.settings.receive_seconds, self.transport.abort
        )

    def resume_writing(self) -> None:
        """Go on: the client has taken what was there."""
        _cancel(self.answer_timer)
        super().resume_writing()

    def send_400_response(self, msg: str) -> None:
        """Refuse what is no HTTP."""
        if not self.ending:
            self._give_up(Problem("bad-request", msg.rstrip(".")))

    def _read_no_more(self) -> NoReturn:
        """Stop the parser within what it is given, and take nothing else."""
        self.ending = True
        raise ConnectionAbortedError

    def _refuse(self, problem: Problem) -> NoReturn:
        """Say why what comes is not read."""
        self._give_up(problem)
        self._read_no_more()

    def _give_up(self, problem: Problem) -> None:
        """Say why to a client that awaits an answer, and close the connection."""
        LOG.warning({"message": problem.detail, "status": problem.status})
        cycle = self.cycle
        if cycle is None or cycle.scope is not self.scope or not cycle.response_started:
            self.transport.write(_raw(problem))
        self.transport.close()


MOST_BEYOND = 64
"""Connections beyond the limit that may be open for a moment, to ask for a probe or be refused."""

BEYOND: deque[PatientProtocol] = deque()


class Full:
    """Refuses every request but the probes."""

    def __init__(self, app: Any) -> None:
        self.app = app

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer one request."""
        if scope["path"].removeprefix(current().root_path) in PROBES:
            await self.app(scope, receive, send)
            return
        response = FULL.response()
        response.headers["connection"] = "close"
        await response(scope, receive, send)


TOO_SLOW = Problem("request-timeout", "The body did not arrive in time")
HEAD_TOO_LARGE = Problem("headers-too-large", f"The headers exceed {MAX_HEAD_BYTES} bytes")
UNKNOWN_CODING = Problem("not-implemented", "Send the body without a coding, or chunked alone")
CODED_TOO_EARLY = Problem("bad-request", "HTTP/1.0 has no Transfer-Encoding")
FULL = unavailable("Too many connections are open")


def _cancel(timer: asyncio.TimerHandle | None) -> None:
    if timer is not None:
        timer.cancel()


def _raw(problem: Problem) -> bytes:
    """A problem as it goes over a connection that has no request to answer."""
    response: Response = problem.response()
    headers = [*response.raw_headers, *HEADERS, (b"connection", b"close")]
    lines = [b"HTTP/1.1 %d %s" % (problem.status, problem.title.encode())]
    lines += [name + b": " + value for name, value in headers]
    return b"\r\n".join([*lines, b"", bytes(response.body)])
