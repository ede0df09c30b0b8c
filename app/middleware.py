"""What happens around every request: its record, and the headers of its answer."""

import asyncio
import random
import re
import time
from collections.abc import Iterator

from starlette.middleware.gzip import GZipMiddleware
from starlette.requests import ClientDisconnect
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from app import VERSION, observability
from app.problems import failure, unavailable
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

REQUEST_ID = re.compile(rb"[A-Za-z0-9._~-]{1,64}")
"""Request ids of clients that are taken over: nothing that could break a log line or a header."""


class Requests:
    """Keeps the record of every request; completes its answer; answers where all else failed."""

    def __init__(self, app: ASGIApp, settings: Settings) -> None:
        self.app = app
        self.settings = settings
        version = f"{VERSION}+{settings.build}".rstrip("+")
        self.headers = [*HEADERS, (b"server", f"khv-calc/{version}".encode())]

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer one request."""
        if scope["type"] != "http":
            await self.app(scope, receive, send)
            return
        asked, scope = scope, _below_root(scope, self.settings.root_path)
        client = scope.get("client") or ("",)
        record = Record(self.settings, _request_id(scope), receive, client[0])
        at_hand.set(record)
        observability.begin()
        status, answered = 0, 0.0
        failed: Exception | None = None

        async def with_headers(message: Message) -> None:
            nonlocal status, answered
            if message["type"] == "http.response.start":
                status, answered = message["status"], time.perf_counter()
                message["headers"] = [
                    *message.get("headers", ()),
                    *self.headers,
                    (b"x-request-id", record.request_id.encode()),
                    *_timing(scope, record, answered),
                ]
            elif asked["method"] == "HEAD":
                message["body"] = b""
            await send(message)

        try:
            await self.app(scope, receive, with_headers)
        except ClientDisconnect:
            pass  # before its body was whole: there is nobody to answer
        except asyncio.CancelledError:  # the service stops, and has waited long enough
            if not status:
                stopping = unavailable("The service is stopping").response()
                await stopping(scope, receive, with_headers)
        except Exception as error:
            failed = error
            if not status:
                await failure(record.request_id).response()(scope, receive, with_headers)
        finally:
            scope["method"] = asked["method"]
            observability.end(record, scope, status, answered, failed)


class CompressGet(GZipMiddleware):
    """Compresses pages and descriptions; calculations compress their own answers."""

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer one request."""
        reads = scope["type"] == "http" and scope["method"] == "GET"
        await (super().__call__ if reads else self.app)(scope, receive, send)


def _below_root(scope: Scope, root: str) -> Scope:
    """A request as the routes know it: without the prefix, which a proxy may leave or take away;
    what asks for the head of an answer is answered like what asks for all of it.
    """
    path = scope["path"]
    if root and path.startswith(root + "/"):
        path = path[len(root) :]
    return {**scope, "path": path, "method": {"HEAD": "GET"}.get(scope["method"], scope["method"])}


def _request_id(scope: Scope) -> str:
    for name, value in scope["headers"]:
        if name == b"x-request-id" and REQUEST_ID.fullmatch(value):
            return str(value, "ascii")
    return f"{random.getrandbits(96):024x}"


def _timing(scope: Scope, record: Record, now: float) -> Iterator[tuple[bytes, bytes]]:
    """Header of where the time of a request went."""
    if scope["path"].startswith("/api/"):
        timing = b"total;dur=%.3f" % ((now - record.started) * 1e3)
        if record.calculations_us:
            timing = b"calculation;dur=%.3f, %b" % (sum(record.calculations_us) / 1e3, timing)
        yield b"server-timing", timing
