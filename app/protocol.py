"""HTTP connections with limits: uvicorn's protocol, extended.

A proxy limits slow heads, rates and connections of a client (`deploy/nginx.conf`). Without one the
service must not run out of memory or descriptors, which only the connection itself can see to.
"""

import asyncio
from collections import deque
from contextlib import suppress
from functools import partial
from itertools import chain
from typing import Any

from starlette.types import ASGIApp, Receive, Scope, Send
from uvicorn.protocols.http.httptools_impl import HttpToolsProtocol

from app.problems import unavailable
from app.settings import OVER_UNIX, current

MAX_HEAD_BYTES = 65_536
"""Largest size of request line and headers together."""

LAST_REQUEST_SECONDS = 0.5
"""Time in which an idle connection may still bring a request while the service stops, s."""

MOST_BEYOND = 64
"""Largest number of connections beyond the limit, which briefly ask for a probe or are refused."""

CODING = b"transfer-encoding"

PROBES = ("/livez", "/metrics")
"""Paths answered beyond the limit of connections too, as a full service is alive."""


class PatientProtocol(HttpToolsProtocol):
    """Connection with one request at a time.

    A second request before the answer to the first one is not read, and ends the connection after
    that answer. A request whose body is not whole within `KHV_RECEIVE_SECONDS` is told so
    (`app.endpoint.received`), and a client that takes nothing of its answer for as long is cut off.
    Connections beyond `KHV_MAX_CONNECTIONS` are told when to come again.
    """

    def __init__(self, *args: Any, **given: Any) -> None:
        super().__init__(*args, **given)
        self.settings = current()
        self.answer_timer: asyncio.TimerHandle | None = None
        self.body_timer: asyncio.TimerHandle | None = None
        self.head_bytes: int | None = None  # None outside of a head
        self.stopping = self.ending = False

    def connection_made(self, transport: asyncio.Transport) -> None:  # type: ignore[override]
        """Wait for the first request, and see if there is room for the connection."""
        super().connection_made(transport)
        self.client = self.client or (OVER_UNIX, 0)  # uvicorn trusts this address
        self.timeout_keep_alive_task = self.loop.call_later(
            self.timeout_keep_alive, self.timeout_keep_alive_handler
        )
        if len(self.connections) > self.settings.max_connections:
            self.app = partial(_full, self.app)
            BEYOND.append(self)
            if len(BEYOND) > MOST_BEYOND:
                BEYOND.popleft().transport.abort()  # descriptors must not run out

    def connection_lost(self, exc: Exception | None) -> None:
        """Forget the connection."""
        self.resume_writing()
        self._stop_body_timer()
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
        if self.cycle is not None and self.cycle.more_body and self.body_timer is None:
            self._wake_after(self.settings.receive_seconds)
        if self.head_bytes is not None:
            self.head_bytes += len(data)
            if self.head_bytes > MAX_HEAD_BYTES:
                self.send_400_response("The headers are too long.")

    def on_message_begin(self) -> None:
        """Begin a request, unless the previous one is not answered yet."""
        if self.cycle is not None and not self.cycle.response_complete:
            self.ending = True
            raise ConnectionAbortedError  # stops the parser within its present data
        super().on_message_begin()
        self.head_bytes = 0

    def on_headers_complete(self) -> None:
        """Pass a request on, unless its head is too long or the end of its body is not known."""
        self.head_bytes = None
        codings = [value.strip().lower() for name, value in self.headers if name == CODING]
        unknown = codings and (codings != [b"chunked"] or self.parser.get_http_version() == "1.0")
        if unknown or len(self.url) + sum(map(len, chain(*self.headers))) > MAX_HEAD_BYTES:
            raise ValueError  # stops the parser, and is answered as what is no request
        super().on_headers_complete()
        if self.stopping:
            self.cycle.keep_alive = False  # the answer is the last of the connection

    def on_message_complete(self) -> None:
        """Note that the request is whole."""
        self._stop_body_timer()
        super().on_message_complete()

    def _wake_after(self, seconds: float) -> None:
        """Tell the application, again and again, that nothing more of the body has come."""

        def wake() -> None:
            self.cycle.message_event.set()
            self._wake_after(1.0)

        self.body_timer = self.loop.call_later(seconds, wake)

    def _stop_body_timer(self) -> None:
        if self.body_timer is not None:
            self.body_timer.cancel()
            self.body_timer = None

    def send_400_response(self, msg: str) -> None:
        """Refuse what is no request, unless an answer is under way."""
        if not self.ending:
            self.ending = True
            super().send_400_response(msg)

    def on_response_complete(self) -> None:
        """End a connection that sent a second request, once the client can have read the answer."""
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
        """Continue after the client has taken its part, or has gone."""
        if self.answer_timer is not None:
            self.answer_timer.cancel()
        super().resume_writing()


BEYOND: deque[PatientProtocol] = deque()
"""Connections beyond the limit."""

FULL = unavailable("Too many connections are open")
FULL.headers["connection"] = "close"


async def _full(app: ASGIApp, scope: Scope, receive: Receive, send: Send) -> None:
    """Answer a request beyond the limit of connections."""
    probe = scope["path"].removeprefix(current().root_path) in PROBES
    await (app if probe else FULL.response())(scope, receive, send)
