"""The service: settings, endpoints, errors, headers, pages."""

import gc
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Any

from fastapi import FastAPI
from fastapi.middleware.cors import CORSMiddleware
from fastapi.responses import FileResponse, JSONResponse, PlainTextResponse, Response
from fastapi.staticfiles import StaticFiles

from app import VERSION, observability, problems
from app.examples import REQUESTS
from app.jobs import Jobs
from app.middleware import CompressGet, Requests
from app.route import API, RESPONSES
from app.routers import (
    batch,
    contact_force,
    crank_planetary,
    cyclogram,
    hertz,
    precession,
    roller_strength,
    service,
    work_precision,
)
from app.schemas.service import ProblemOut
from app.settings import Settings

STATIC = Path(__file__).parent.parent / "static"
CALCULATIONS = (
    hertz,
    contact_force,
    roller_strength,
    cyclogram,
    crank_planetary,
    precession,
    work_precision,
    batch,
)
"""In the order in which a request is matched: the shortest first."""

PRELOAD = (*(calculation.__name__ for calculation in CALCULATIONS), "uvicorn")
"""What processes for calculations import ahead; uvicorn as they import the service's main module,
`app.serve`, each anew."""

DESCRIPTION = """
Design calculations of K-H-V planetary reducers: cyclogram, contact forces and stresses.
A quantity's name ends in its unit; plain names are dimensionless. Every answer carries its
accuracy. Errors are problem details (RFC 9457) whose `errors` point to the fields.
"""


def complete_description(app: FastAPI) -> None:
    """Put into the API's description what FastAPI does not: problems and working examples."""
    generate = app.openapi

    def openapi() -> dict[str, Any]:
        schema = generate()
        models = ProblemOut.model_json_schema(ref_template="#/components/schemas/{model}")
        nested = models.pop("$defs")
        schema["components"]["schemas"] |= nested | {"ProblemOut": models}
        for calculation, example in REQUESTS.items():
            for path in (f"{API}/{calculation}", f"{API}/{calculation}/chart"):
                if path in schema["paths"]:
                    body = schema["paths"][path]["post"]["requestBody"]
                    body["content"]["application/json"]["example"] = example
        return schema

    app.openapi = openapi  # type: ignore[method-assign]


@asynccontextmanager
async def lifespan(app: FastAPI) -> AsyncIterator[None]:
    """Have processes for long calculations as long as the service runs."""
    # What is there now stays: the collector need not look through it again and again.
    gc.collect()
    gc.freeze()
    async with app.state.jobs:
        yield


def create_app(settings: Settings | None = None) -> FastAPI:
    """The service as an ASGI application.

    Parameters
    ----------
    settings : Settings, optional
        Limits; from the environment where not given.

    Returns
    -------
    FastAPI
    """
    settings = settings or Settings.from_environment()
    app = FastAPI(
        title="KHV Calc",
        version=VERSION,
        description=DESCRIPTION,
        docs_url=None,
        redoc_url=None,
        lifespan=lifespan,
        # What is seen from outside is in app.observability.
        telemetry={"tracing": False, "metrics": False, "logs": False},
    )
    app.state.jobs = Jobs(
        processes=settings.processes, waiting=settings.max_waiting, preload=PRELOAD
    )
    for calculation in CALCULATIONS:
        # As if they were its own: FastAPI matches those of included routers twice, and slowly.
        app.router.routes += calculation.router.routes
    app.include_router(service.router, prefix=API, responses={503: RESPONSES[503]})
    problems.install(app)
    complete_description(app)
    app.add_middleware(CompressGet, minimum_size=2048, compresslevel=6)
    if settings.cors_origins:
        app.add_middleware(
            CORSMiddleware,
            allow_origins=settings.cors_origins,
            allow_methods=["GET", "POST"],
            allow_headers=["content-type", "x-request-id"],
            expose_headers=["server-timing", "x-request-id", "retry-after"],
        )
    app.add_middleware(Requests, settings=settings)

    @app.api_route("/", methods=["GET", "HEAD"], include_in_schema=False)
    async def page() -> FileResponse:
        return FileResponse(STATIC / "index.html")

    @app.api_route("/docs", methods=["GET", "HEAD"], include_in_schema=False)
    async def docs() -> FileResponse:
        return FileResponse(STATIC / "docs.html")

    @app.get("/livez", include_in_schema=False)
    async def livez() -> PlainTextResponse:
        return PlainTextResponse("alive")

    @app.get("/readyz", include_in_schema=False)
    async def readyz() -> PlainTextResponse:
        if not app.state.jobs.ready:
            raise problems.unavailable("No process for calculations is there yet, or any more")
        return PlainTextResponse("ready")

    @app.get("/metrics", include_in_schema=False)
    async def metrics() -> Response:
        return observability.metrics()

    @app.get(f"{API}/openapi.json", include_in_schema=False)
    async def openapi() -> JSONResponse:
        return JSONResponse(app.openapi())

    app.mount("/static", StaticFiles(directory=STATIC), name="static")
    return app


app = create_app()
