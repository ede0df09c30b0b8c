"""The service: settings, endpoints, errors, headers, pages."""

import asyncio
import gc
import os
import re
import threading
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from functools import cache
from mimetypes import guess_type
from pathlib import Path
from typing import Any, cast

import orjson
from fastapi import FastAPI, HTTPException, Request
from fastapi.middleware.cors import CORSMiddleware
from fastapi.responses import PlainTextResponse, Response
from fastapi.telemetry import TelemetryConfig
from starlette.types import Scope

from app import VERSION, about, batch, observability
from app.about import API, Packed
from app.endpoint import (
    JSON,
    STREAMED,
    FigureOut,
    route_of,
    route_of_files,
)
from app.examples import REQUESTS
from app.jobs import Jobs
from app.middleware import Requests
from app.model import Calculation, Export, StudyCalculation
from app.problems import LACKING, REFUSED, RESPONSES, refused, unavailable
from app.registry import CALCULATIONS, EXPORTS
from app.settings import Settings, current
from app.words import STATIC

PRELOAD = ("app.batch", "app.loaded")
"""Modules that processes for calculations import in advance."""

DESCRIBED_S = 1.0
"""Delay after the start before the service makes its API description, s."""

NO_TELEMETRY: TelemetryConfig = {"tracing": False, "metrics": False, "logs": False}
"""Settings without further telemetry; logs and metrics are in `app.observability`."""

LICENSE = {"name": "MIT", "identifier": "MIT"}

TAGS = [
    {"name": "crank-planetary", "description": "Pins of the output link in holes of satellites."},
    {"name": "rollers", "description": "Swinging rollers of the output mechanism."},
    {"name": "precessional gear", "description": "Precessional gear with a roller wheel."},
    {
        "name": "exploration",
        "description": "Results over inputs, inputs solved for a result, reducers for a "
        "requirement.",
    },
    {"name": "accuracy", "description": "Error against run time of the methods."},
    {"name": "files", "description": "Parts of a design as files for other programs."},
    {"name": "batch", "description": "Many requests of one calculation."},
    {"name": "service", "description": "Information about the service."},
]

DESCRIPTION = """
Design calculations of K-H-V planetary reducers: cyclogram, contact forces and stresses.
The name of a quantity ends in its unit; plain names are dimensionless. Every answer states its
accuracy. Errors are problem details (RFC 9457) whose `errors` point to the fields. The schemas say
which fields exclude each other and which fields belong to a kind. Requests that break other rules
between fields or parts, or describe impossible mechanisms, are refused even if a schema admits
them.
"""


def add_route(app: FastAPI, calculation: Calculation, *, drawn: bool = False) -> None:
    """Add the endpoint of a calculation, or of its figure."""
    path = f"{calculation.name}/chart" if drawn else calculation.name
    example = {"example": REQUESTS[calculation.name]}
    app.router.add_api_route(
        f"{API}/{path}",
        cast(Any, calculation.figure if drawn else calculation.solve),
        methods=["POST"],
        operation_id=path.replace("/", "_").replace("-", "_"),
        tags=[calculation.tag],
        summary=f"{calculation.title}: figure" if drawn else calculation.title,
        response_model=FigureOut if drawn else calculation.answer,
        responses=STREAMED
        if isinstance(calculation, StudyCalculation) and not drawn
        else RESPONSES,
        openapi_extra={"requestBody": {"content": {JSON: example}}},
        route_class_override=route_of(calculation, drawn=drawn),
    )


def add_export(app: FastAPI, export: Export) -> None:
    """Add the endpoint of files of a design."""
    file = {"schema": {"type": "string", "format": "binary"}}
    disposition = {"description": "Name of the file.", "schema": {"type": "string"}}
    answered = {
        "description": "The file.",
        "headers": {"content-disposition": disposition},
        "content": dict.fromkeys(export.media_types, file),
    }
    app.router.add_api_route(
        f"{API}/{export.name}",
        cast(Any, export.write),
        methods=["POST"],
        operation_id=export.name.replace("/", "_"),
        tags=["files"],
        summary=export.title,
        response_class=Response,
        response_model=None,
        responses=RESPONSES | {200: answered} | (LACKING if export.extra else {}),
        openapi_extra={"requestBody": {"content": {JSON: {"example": REQUESTS[export.name]}}}},
        route_class_override=route_of_files(export),
    )


@cache
def _packed_file(path: Path, changed_ns: int) -> Packed:
    return Packed(path.read_bytes(), guess_type(path)[0] or "application/octet-stream")


@cache
def _files() -> dict[str, Path]:
    """Files of the page by their paths; other paths are not served."""
    files = (path for path in STATIC.rglob("*") if path.is_file())
    return {path.relative_to(STATIC).as_posix(): path for path in files}


def file_response(name: str, scope: Scope) -> Response:
    """Answer with a file of the page as it is now; `HTTPException` 404 without such a file."""
    path = _files().get(name)
    if path is None or not path.exists():
        raise HTTPException(404)
    return _packed_file(path, path.stat().st_mtime_ns).response(scope)


IMPORTED = re.compile(r'^(?:import|export|}) ?[^";]*?"(\.+/[^"]+)"(?: with [^;]*)?;', re.MULTILINE)
"""Path of another module in a module of the page."""

FIRST = "calculators/crank-planetary/index.js"
"""Calculator that opens without one in the address."""


@cache
def _page(calculator: str) -> Packed:
    """The page, with a link for each module that its first screen imports, one through the other:
    a browser then asks for all of them at once.
    """
    names = ["main.js", calculator]
    for name in names:
        imported = IMPORTED.findall((STATIC / name).read_text())
        found = [os.path.normpath(f"{name}/../{path}") for path in imported]
        names += [path for path in dict.fromkeys(found) if path not in names]
    kinds = {True: ' as="json"', False: ""}
    links = "".join(
        f'<link rel="modulepreload"{kinds[name.endswith("json")]} href="static/{name}">\n'
        for name in names[1:]
    )
    text = (STATIC / "index.html").read_text().replace("</head>", f"{links}</head>")
    return Packed(text.encode(), "text/html")


@asynccontextmanager
async def lifespan(app: FastAPI) -> AsyncIterator[None]:
    """Keep processes for long calculations while the service runs."""
    # Objects that exist now stay, and need no repeated garbage collection.
    gc.collect()
    gc.freeze()
    # The API description takes half a second and is made before someone opens the page.
    describing = threading.Thread(target=app.openapi, daemon=True)
    ahead = asyncio.get_running_loop().call_later(DESCRIBED_S, describing.start)
    async with app.state.jobs:
        yield
    ahead.cancel()


def create_app(settings: Settings | None = None) -> FastAPI:
    """The service as an ASGI application; settings come from the environment if none are given."""
    settings = settings or current()
    app = FastAPI(
        title="KHV Calc",
        version=VERSION,
        description=DESCRIPTION,
        license_info=LICENSE,
        openapi_tags=TAGS,
        servers=[{"url": settings.root_path}] if settings.root_path else None,
        openapi_url=None,
        docs_url=None,
        redoc_url=None,
        redirect_slashes=False,  # redirects would use the Host header
        lifespan=lifespan,
        telemetry=NO_TELEMETRY,
    )
    app.state.settings = settings
    app.state.jobs = Jobs(
        processes=settings.processes, waiting=settings.max_waiting, preload=PRELOAD
    )
    for kind in REFUSED:
        app.add_exception_handler(kind, refused)

    async def static(request: Request) -> Response:
        return file_response(request.path_params["name"], request.scope)

    # Paths are compared in this order.
    for each in CALCULATIONS.values():
        add_route(app, each)
    app.add_route("/static/{name:path}", static, include_in_schema=False)
    for each in CALCULATIONS.values():
        if each.figure:
            add_route(app, each, drawn=True)
    for export in EXPORTS.values():
        add_export(app, export)
    app.include_router(batch.router, prefix=API)
    app.include_router(about.router)
    app.include_router(about.problems)
    if settings.cors_origins:
        app.add_middleware(
            CORSMiddleware,
            allow_origins=settings.cors_origins,
            allow_methods=["GET", "POST"],
            allow_headers=["content-type", "x-request-id"],
            expose_headers=["content-disposition", "server-timing", "x-request-id", "retry-after"],
        )
    app.add_middleware(Requests, settings=settings)

    @app.get("/", include_in_schema=False)
    async def page(request: Request) -> Response:
        asked = f"calculators/{request.query_params.get('calculator')}/index.js"
        return _page(asked if asked in _files() else FIRST).response(request.scope)

    @app.get("/docs", include_in_schema=False)
    async def docs(request: Request) -> Response:
        return file_response("docs.html", request.scope)

    @app.get("/livez", include_in_schema=False)
    async def livez() -> PlainTextResponse:
        return PlainTextResponse("alive")

    @app.get("/readyz", include_in_schema=False)
    async def readyz() -> PlainTextResponse:
        if not app.state.jobs.ready:
            raise unavailable("No process for calculations is there yet, or any more")
        return PlainTextResponse("ready")

    @app.get("/metrics", include_in_schema=False)
    async def metrics(request: Request) -> Response:
        return Packed(*observability.metrics()).response(request.scope)

    @cache
    def description() -> Packed:
        return Packed(orjson.dumps(app.openapi()), JSON)

    @app.get("/openapi.json", include_in_schema=False)
    @app.get(f"{API}/openapi.json", include_in_schema=False)
    async def openapi(request: Request) -> Response:
        return description().response(request.scope)

    return app


app = create_app()
