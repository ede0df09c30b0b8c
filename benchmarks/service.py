"""What the service adds to what its framework costs, as ratios in one run.

Each request is sent to the service and to an empty FastAPI endpoint with the same models, one
after the other on one connection, in rounds; what counts is the processor time of the server.
"""

import json
import socket
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import orjson
from fastapi import FastAPI, Response
from fastapi.testclient import TestClient
from pydantic import BaseModel

from app.examples import REQUESTS
from app.schemas.contact_force import ContactForceRequest, ContactForceResponse
from app.schemas.cyclogram import CyclogramRequest, CyclogramResponse
from app.schemas.hertz import HertzRequest, HertzResponse
from app.schemas.roller_strength import RollerStrengthRequest, RollerStrengthResponse

ROUNDS, REPEATS = 7, 400

MODELS: dict[str, tuple[type[BaseModel], type[BaseModel]]] = {
    "hertz": (HertzRequest, HertzResponse),
    "roller-strength": (RollerStrengthRequest, RollerStrengthResponse),
    "contact-force": (ContactForceRequest, ContactForceResponse),
    "cyclogram": (CyclogramRequest, CyclogramResponse),
}
FORCE = REQUESTS["contact-force"] | {"include": []}
BODIES: dict[str, dict[str, Any]] = {name: REQUESTS[name] for name in MODELS} | {
    "contact-force": FORCE
}
CURVES = FORCE | {"include": ["curves"]}


def empty() -> FastAPI:
    """An application with an empty endpoint for each calculation, and curves ready to encode."""
    from app.main import app as service

    application = FastAPI()

    def add(name: str, given: Any, answered: Any, answer: BaseModel) -> None:
        async def endpoint(body: given) -> answered:
            return answer

        application.post(f"/{name}", response_model_exclude_none=True)(endpoint)

    with TestClient(service) as client:
        for name, (given, answered) in MODELS.items():
            content = client.post(f"/api/v1/{name}", json=BODIES[name]).content
            add(name, given, answered, answered.model_validate_json(content))
        curves = client.post("/api/v1/contact-force", json=CURVES).json()
        chart = client.post("/api/v1/contact-force/chart", json=FORCE).json()

    @application.get("/hello")
    async def hello() -> dict[str, str]:
        return {"hello": "world"}

    @application.post("/contact-force/curves")
    async def encoded_curves(body: ContactForceRequest) -> Response:
        return Response(orjson.dumps(curves), media_type="application/json")

    @application.post("/contact-force/chart")
    async def encoded_chart(body: ContactForceRequest) -> Response:
        return Response(orjson.dumps(chart), media_type="application/json")

    return application


class Server:
    """A server in a process of its own, and one connection to it."""

    def __init__(self, *command: str) -> None:
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            self.port = free.getsockname()[1]
        started = time.perf_counter()
        self.process = subprocess.Popen(
            [sys.executable, "-m", *command, "--port", str(self.port)], stdout=subprocess.DEVNULL
        )
        while True:
            try:
                self.connection = socket.create_connection(("127.0.0.1", self.port))
                break
            except OSError:
                time.sleep(0.005)
        self.connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self.started = started

    def ask(self, request: bytes) -> bytes:
        """Whole answer to a request."""
        self.connection.sendall(request)
        received = self.connection.recv(1 << 20)
        head, _, body = received.partition(b"\r\n\r\n")
        length = int(head.lower().split(b"content-length:")[1].split(b"\r\n")[0])
        parts, missing = [body], length - len(body)
        while missing:
            parts.append(self.connection.recv(1 << 20))
            missing -= len(parts[-1])
        if not head.startswith(b"HTTP/1.1 200"):
            raise RuntimeError((head + b"".join(parts)).decode())
        return b"".join(parts)

    def processor_time(self) -> float:
        """Seconds that the server has calculated."""
        text = Path(f"/proc/{self.process.pid}/schedstat").read_text()
        return int(text.split()[0]) / 1e9

    def cost(self, request: bytes) -> float:
        """Processor time of a request, microseconds."""
        before = self.processor_time()
        for _ in range(REPEATS):
            self.ask(request)
        return (self.processor_time() - before) / REPEATS * 1e6


@contextmanager
def running(*command: str) -> Iterator[Server]:
    """Start a server; stop it at the end."""
    server = Server(*command)
    try:
        yield server
    finally:
        server.process.terminate()
        server.process.wait(60)


def post(path: str, body: object) -> bytes:
    """A request as bytes."""
    content = json.dumps(body).encode()
    head = f"POST {path} HTTP/1.1\r\nhost: service\r\ncontent-type: application/json\r\n"
    return f"{head}content-length: {len(content)}\r\n\r\n".encode() + content
