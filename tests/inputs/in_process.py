"""The service in this process: what a client would get, without a network."""

import asyncio
import json
from collections.abc import Awaitable, Callable
from typing import Any

from app.main import create_app
from app.settings import Settings

API = "/api/v1/"
JSON = {"content-type": "application/json"}

App = Callable[..., Awaitable[None]]


async def exchange(
    app: App,
    path: str,
    body: bytes = b"",
    *,
    method: str = "POST",
    query: str = "",
    headers: dict[str, str] = JSON,
) -> tuple[int, dict[bytes, bytes], bytes]:
    """Status, headers and body of the answer to a request, sent in two parts."""
    half = len(body) // 2
    parts = [part for part in (body[:half], body[half:]) if part] or [b""]
    scope = {
        "type": "http", "asgi": {"version": "3.0"}, "http_version": "1.1", "scheme": "http",
        "method": method, "path": path, "root_path": "", "raw_path": path.encode(),
        "query_string": query.encode(), "server": ("service", 80), "client": ("127.0.0.1", 1),
        "headers": [(b"host", b"service"),
                    *((key.encode(), value.encode("latin-1")) for key, value in headers.items())],
    }  # fmt: skip
    status, received, found = 0, [], {}

    async def receive() -> dict[str, Any]:
        if not parts:
            await asyncio.Event().wait()  # the client stays
        return {"type": "http.request", "body": parts.pop(0), "more_body": bool(parts)}

    async def send(message: dict[str, Any]) -> None:
        nonlocal status, found
        if message["type"] == "http.response.start":
            status, found = message["status"], dict(message["headers"])
        else:
            received.append(message.get("body", b""))

    await app(scope, receive, send)
    return status, found, b"".join(received)


class Service:
    """A service in this process that answers one request after another."""

    def __init__(self) -> None:
        self.app = create_app(Settings(max_seconds=300.0))
        self.runner = asyncio.Runner()

    def close(self) -> None:
        """End its event loop."""
        self.runner.close()

    def post(self, calculation: str, body: dict[str, Any]) -> tuple[int, Any]:
        """Status and answer of a calculation."""
        sent = exchange(self.app, API + calculation, json.dumps(body).encode())
        status, _, content = self.runner.run(sent)
        return status, json.loads(content)

    def get(self, name: str) -> Any:
        """Answer of a path."""
        status, _, content = self.runner.run(exchange(self.app, API + name, method="GET"))
        assert status == 200, content
        return json.loads(content)
