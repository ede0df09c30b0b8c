"""HTTP connections that do not wait for ever: uvicorn's protocol with limits of its own."""

import asyncio
import logging
from collections import deque
from contextlib import suppress
from typing import Any

from starlette.responses import Response
from starlette.types import Receive, Scope, Send
from uvicorn.protocols.http.httptools_impl import HttpToolsProtocol

from app.middleware import HEADERS
from app.problems import Problem, unavailable
from app.settings import current

LOG = logging.getLogger("khv.connection")

MAX_HEAD_BYTES = 65_536
"""Longest request line and headers together."""

LAST_REQUEST_SECONDS = 0.5
"""How long an idle connection may still bring a request while the service stops."""

PROBES = ("/livez", "/metrics")
"""Paths that are answered even beyond the limit of connections: to be full is not to be dead."""


class PatientProtocol(HttpToolsProtocol):
    """Closes connections whose client is too slow, and refuses those that are too many.

    A request has to arrive whole within `KHV_RECEIVE_SECONDS` of the connection or of its own
    first byte, and the client has to take some of its answer within the same time; otherwise the
    connection is closed. What comes beyond `KHV_MAX_CONNECTIONS` is told when to come again.
    """

    def __init__(self, *args: Any, **given: Any) -> None:
        super().__init__(*args, **given)
        self.settings = current()
        self.request_timer: asyncio.TimerHandle | None = None
        self.answer_timer: asyncio.TimerHandle | None = None
        self.head_bytes: int | None = None
        self.stopping = False

    def connection_made(self, transport: asyncio.Transport) -> None:  # type: ignore[override]
        """Start to wait for the first request; see whether there is room for it."""
        super().connection_made(transport)
        if len(self.connections) > self.settings.max_connections:
            self.app = Full(self.app)
            BEYOND.append(self)
            if len(BEYOND) > MOST_BEYOND:
                BEYOND.popleft().transport.abort()  # descriptors are not to run out
        self._await_request()

    def connection_lost(self, exc: Exception | None) -> None:
        """Wait for nothing."""
        self.request_timer = _cancelled(self.request_timer)
        self.answer_timer = _cancelled(self.answer_timer)
        with suppress(ValueError):
            BEYOND.remove(self)
        super().connection_lost(exc)

    def data_received(self, data: bytes) -> None:
        """Take a part of a request, unless its headers have no end."""
        super().data_received(data)
        if self.head_bytes is not None:
            self.head_bytes += len(data)
            if self.head_bytes > MAX_HEAD_BYTES:
                self._give_up(HEAD_TOO_LARGE)

    def on_message_begin(self) -> None:
        """Wait for the rest of a request; the time of the first has begun with the connection."""
        super().on_message_begin()
        self.head_bytes = 0
        if self.request_timer is None:
            self._await_request()

    def on_headers_complete(self) -> None:
        """The headers had an end; while the service stops, the answer is the connection's last."""
        self.head_bytes = None
        super().on_headers_complete()
        if self.stopping and self.cycle is not None:
            self.cycle.keep_alive = False

    def shutdown(self) -> None:
        """Stop: an idle connection has a moment more, as a request may be on its way already."""
        self.stopping = True
        if self.cycle is None or self.cycle.response_complete:
            self.loop.call_later(LAST_REQUEST_SECONDS, super().shutdown)
        else:
            super().shutdown()

    def on_message_complete(self) -> None:
        """The request is whole."""
        self.request_timer = _cancelled(self.request_timer)
        super().on_message_complete()

    def pause_writing(self) -> None:
        """Wait for the client to take some of its answer."""
        super().pause_writing()
        self.answer_timer = self.loop.call_later(
            self.settings.receive_seconds, self.transport.abort
        )

    def resume_writing(self) -> None:
        """The client has taken what was there."""
        self.answer_timer = _cancelled(self.answer_timer)
        super().resume_writing()

    def send_400_response(self, msg: str) -> None:
        """Refuse what is no HTTP."""
        self._give_up(Problem("bad-request", msg.rstrip(".")))

    def _await_request(self) -> None:
        self.request_timer = self.loop.call_later(
            self.settings.receive_seconds, self._give_up, TOO_SLOW
        )

    def _give_up(self, problem: Problem) -> None:
        """Say why to a client that awaits an answer, and close the connection."""
        LOG.warning({"message": problem.detail, "status": problem.status})
        cycle = self.cycle
        if cycle is None or (
            not cycle.response_started if cycle.scope is self.scope else cycle.response_complete
        ):
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


TOO_SLOW = Problem("request-timeout", "The request did not arrive in time")
HEAD_TOO_LARGE = Problem("headers-too-large", f"The headers exceed {MAX_HEAD_BYTES} bytes")
FULL = unavailable("Too many connections are open")


def _cancelled(timer: asyncio.TimerHandle | None) -> asyncio.TimerHandle | None:
    """No timer, after cancelling one."""
    if timer is not None:
        timer.cancel()
    return None


def _raw(problem: Problem) -> bytes:
    """A problem as it goes over a connection that has no request to answer."""
    response: Response = problem.response()
    headers = [*response.raw_headers, *HEADERS, (b"connection", b"close")]
    lines = [b"HTTP/1.1 %d %s" % (problem.status, problem.title.encode())]
    lines += [name + b": " + value for name, value in headers]
    return b"\r\n".join([*lines, b"", bytes(response.body)])
