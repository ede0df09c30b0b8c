"""HTTP connections with limits: uvicorn's protocol, extended.

A proxy limits slow heads and connections by address (`deploy/nginx.conf`). Only the connection
itself can do the rest: refuse too many or too long requests, and end connections that send or take
nothing.
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
"""Largest size of request line and headers together."""

LAST_REQUEST_SECONDS = 0.5
"""Time in which an idle connection may still bring a request while the service stops, s."""

CODING = b"transfer-encoding"

PROBES = ("/livez", "/metrics")
"""Paths answered beyond the limit of connections too, as a full service is alive."""


class PatientProtocol(HttpToolsProtocol):
    """Connection with one request at a time, whose answer is taken part by part.

    A second request before the answer to the first one is not read, and ends the connection after
    that answer. A body that is not whole within `KHV_RECEIVE_SECONDS` of its head is refused, and a
    client that takes nothing of its answer for as long is cut off. Connections beyond
    `KHV_MAX_CONNECTIONS` are told when to come again.
    """

    def __init__(self, *args: Any, **given: Any) -> None:
        super().__init__(*args, **given)
        self.settings = current()
        self.body_timer: asyncio.TimerHandle | None = None
        self.answer_timer: asyncio.TimerHandle | None = None
        self.head_bytes: int | None = None
        self.stopping = self.ending = False

    def connection_made(self, transport: asyncio.Transport) -> None:  # type: ignore[override]
        """Wait for the first request, and see if there is room for the connection."""
        super().connection_made(transport)
        self.client = self.client or (OVER_UNIX, 0)  # uvicorn trusts this address
        self.timeout_keep_alive_task = self.loop.call_later(
            self.timeout_keep_alive, self.timeout_keep_alive_handler
        )
        if len(self.connections) > self.settings.max_connections:
            self.app = Full(self.app)
            BEYOND.append(self)
            if len(BEYOND) > MOST_BEYOND:
                BEYOND.popleft().transport.abort()  # descriptors must not run out

    def connection_lost(self, exc: Exception | None) -> None:
        """Stop all timers."""
        _cancel(self.body_timer)
        _cancel(self.answer_timer)
        with suppress(ValueError):
            BEYOND.remove(self)
        super().connection_lost(exc)

    def data_received(self, data: bytes) -> None:
        """Take a part of a request, unless it must not be read or its head has no end. A request
        that arrives whole, as most do, starts no timer.
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
        """Begin a request, unless the previous one is not answered yet."""
        if self.cycle is not None and not self.cycle.response_complete:
            self._read_no_more()
        super().on_message_begin()
        self.head_bytes = 0

    def on_headers_complete(self) -> None:
        """Pass a request on; while the service stops, its answer is the connection's last."""
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
        """Note that the request is whole."""
        _cancel(self.body_timer)
        self.body_timer = None
        super().on_message_complete()

    def on_response_complete(self) -> None:
        """End a connection that sends more than was requested. Surplus data are dropped for as long
        as an idle connection is kept, so that the client can read the answer.
        """
        self.ending |= self.cycle.more_body
        super().on_response_complete()
        if self.ending and not self.transport.is_closing():
            self.transport.write_eof()

    def shutdown(self) -> None:
        """Stop; an idle connection has a moment more, as a request may be on its way."""
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
        """Continue after the client has taken its part."""
        _cancel(self.answer_timer)
        super().resume_writing()

    def send_400_response(self, msg: str) -> None:
        """Refuse data that are not HTTP."""
        if not self.ending:
            self._give_up(Problem("bad-request", msg.rstrip(".")))

    def _read_no_more(self) -> NoReturn:
        """Stop the parser within its present data, and take no more."""
        self.ending = True
        raise ConnectionAbortedError

    def _refuse(self, problem: Problem) -> NoReturn:
        """Tell the client why its data are not read."""
        self._give_up(problem)
        self._read_no_more()

    def _give_up(self, problem: Problem) -> None:
        """Tell a waiting client the reason, and close the connection."""
        LOG.warning({"message": problem.detail, "status": problem.status})
        cycle = self.cycle
        if cycle is None or cycle.scope is not self.scope or not cycle.response_started:
            self.transport.write(_raw(problem))
        self.transport.close()


MOST_BEYOND = 64
"""Largest number of connections beyond the limit, which briefly ask for a probe or are refused."""

BEYOND: deque[PatientProtocol] = deque()


class Full:
    """Application that refuses every request but the probes."""

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
    """Bytes of a problem for a connection without a request."""
    response: Response = problem.response()
    headers = [*response.raw_headers, *HEADERS, (b"connection", b"close")]
    lines = [b"HTTP/1.1 %d %s" % (problem.status, problem.title.encode())]
    lines += [name + b": " + value for name, value in headers]
    return b"\r\n".join([*lines, b"", bytes(response.body)])
