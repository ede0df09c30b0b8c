"""Middleware around every request: record of the request, and headers of the answer."""

import asyncio
import random
import re
import time
from collections import Counter
from collections.abc import Awaitable

from starlette.requests import ClientDisconnect
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from app import VERSION, observability
from app.problems import Problem, unavailable
from app.record import Record, at_hand
from app.settings import Settings

CONTENT_SECURITY_POLICY = (
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data: blob:; "
    "font-src 'self'; connect-src 'self'; base-uri 'none'; form-action 'self'; "
    "frame-ancestors 'none'"
)

HEADERS = [
    (b"content-security-policy", CONTENT_SECURITY_POLICY.encode()),
    (b"x-content-type-options", b"nosniff"),
    (b"referrer-policy", b"no-referrer"),
    (b"cross-origin-opener-policy", b"same-origin"),
    (b"cross-origin-resource-policy", b"same-origin"),
    (b"cache-control", b"no-cache"),
]
"""Headers of every answer."""

PART_BYTES = 1 << 18
"""Largest number of bytes sent at once, for which a client may take its allowed time."""

MAX_ADDRESS = 45
"""Longest address of a client: IPv6 with an IPv4 address in it."""

REQUEST_ID = re.compile(rb"[A-Za-z0-9._~-]{1,64}")
"""Accepted request ids of clients, without characters that could break a log line or a header."""

NO_GZIP = re.compile(rb"gzip\s*;\s*q=0(\.0*)?\s*(,|$)")
"""Pattern of an `Accept-Encoding` that excludes gzip."""


class Requests:
    """Middleware that records every request, completes its answer, and answers on failures."""

    def __init__(self, app: ASGIApp, settings: Settings) -> None:
        self.app = app
        self.settings = settings
        self.places: Counter[str] = Counter()
        version = f"{VERSION}+{settings.build}".rstrip("+")
        self.headers = [*HEADERS, (b"server", f"khv-calc/{version}".encode())]

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer one request."""
        if scope["type"] != "http":
            await self.app(scope, receive, send)
            return
        method, headers = scope["method"], dict(scope["headers"])
        root = self.settings.root_path  # a proxy may leave it before the path or take it away
        path = scope["path"].removeprefix(root)
        if NO_GZIP.search(headers.get(b"accept-encoding", b"")):
            del headers[b"accept-encoding"]
            scope = {**scope, "headers": [*headers.items()]}
        head = method == "HEAD"  # answered as GET, without a body
        if head or root:
            scope = {**scope, "root_path": root, "method": "GET" if head else method}
        client = (scope.get("client") or ("",))[0][:MAX_ADDRESS]
        request_id = _request_id(headers)
        record = Record(self.settings, request_id, client, self.places)
        at_hand.set(record)
        observability.begin()
        failed: Exception | None = None

        def with_headers(message: Message) -> Awaitable[None]:
            if message["type"] == "http.response.start":
                record.status, record.answered = message["status"], time.perf_counter()
                message["headers"] = [
                    *message.get("headers", ()),
                    *self.headers,
                    (b"x-request-id", record.request_id.encode()),
                ]
                if path.startswith("/api/"):
                    message["headers"].append((b"server-timing", _timing(record)))
            elif head:
                message["body"] = b""
            return send(message) if len(message.get("body", b"")) <= PART_BYTES else parts(message)

        async def parts(message: Message) -> None:
            # Shared content such as files is sent without copies.
            body, more = memoryview(message["body"]), message.get("more_body", False)
            for start in range(0, len(body), PART_BYTES):
                end = start + PART_BYTES
                further = more or end < len(body)
                await send({**message, "body": body[start:end], "more_body": further})

        try:
            await self.app(scope, receive, with_headers)
        except ClientDisconnect:
            pass  # the client left before its body was whole
        except asyncio.CancelledError:  # the service stops, and has waited long enough
            if not record.status:
                stopping = unavailable("The service is stopping").response()
                await stopping(scope, receive, with_headers)
        except Exception as error:
            failed = error
            if not record.status:
                detail = f"Not by the input; the service's log names request {record.request_id}"
                await Problem("failure", detail).response()(scope, receive, with_headers)
        finally:
            if record.has_place:
                self.places -= Counter((client,))
            route = path if "endpoint" in scope else "unknown"
            observability.end(record, method, route, failed)


def _request_id(headers: dict[bytes, bytes]) -> str:
    own = headers.get(b"x-request-id")
    if own is not None and REQUEST_ID.fullmatch(own):
        return str(own, "ascii")
    return random.getrandbits(96).to_bytes(12, "big").hex()


def _timing(record: Record) -> bytes:
    """Header with the times of a request."""
    total_ms = (record.answered - record.started) * 1e3
    if record.calculation_us:
        return b"calculation;dur=%.3f, total;dur=%.3f" % (record.calculation_us / 1e3, total_ms)
    return b"total;dur=%.3f" % total_ms
