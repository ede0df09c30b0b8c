"""The service: settings, endpoints, errors, headers, pages."""

import gc
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Any

from fastapi import FastAPI
from fastapi.middleware.cors import CORSMiddleware
from fastapi.openapi.utils import get_openapi
from fastapi.responses import FileResponse, JSONResponse, PlainTextResponse, Response
from fastapi.staticfiles import StaticFiles

from app import VERSION, about, batch, observability
from app.about import API
from app.endpoint import RESPONSES, CalculationRoute, FigureOut, answering, drawing
from app.examples import REQUESTS
from app.jobs import Jobs
from app.middleware import CompressGet, Requests
from app.problems import REFUSED, ProblemOut, refused, unavailable
from app.registry import CALCULATIONS
from app.settings import Settings

STATIC = Path(__file__).parent.parent / "static"

PRELOAD = ("app.batch", "uvicorn")
"""What processes for calculations import ahead; uvicorn as they import the service's main module,
`app.serve`, each anew."""

LICENSE = {"name": "MIT", "identifier": "MIT"}

TAGS = [
    {"name": "crank-planetary", "description": "Pins of the output link in holes of satellites."},
    {"name": "rollers", "description": "Swinging rollers of the output mechanism."},
    {"name": "precessional gear", "description": "Precessional gear with a roller wheel."},
    {"name": "exploration", "description": "What an input has to be for a result."},
    {"name": "accuracy", "description": "Error against run time of the methods."},
    {"name": "batch", "description": "Many requests of one calculation."},
    {"name": "service", "description": "What the service says about itself."},
]

DESCRIPTION = """
Design calculations of K-H-V planetary reducers: cyclogram, contact forces and stresses.
A quantity's name ends in its unit; plain names are dimensionless. Every answer carries its
accuracy. Errors are problem details (RFC 9457) whose `errors` point to the fields.
"""


def describe(app: FastAPI) -> dict[str, Any]:
    """The API's description: FastAPI's own, and the model of a problem."""
    if app.openapi_schema is None:
        schema = get_openapi(
            title=app.title,
            version=app.version,
            description=app.description,
            license_info=LICENSE,
            tags=TAGS,
            routes=app.routes,
        )
        problem = ProblemOut.model_json_schema(ref_template="#/components/schemas/{model}")
        schema["components"]["schemas"] |= problem.pop("$defs") | {"Problem": problem}
        app.openapi_schema = schema
    return app.openapi_schema


def example(body: dict[str, Any]) -> dict[str, Any]:
    """A request's example for its description."""
    return {"requestBody": {"content": {"application/json": {"example": body}}}}


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
    for kind in REFUSED:
        app.add_exception_handler(kind, refused)
    app.router.route_class = CalculationRoute
    for each in CALCULATIONS.values():
        shared: dict[str, Any] = {
            "tags": [each.tag],
            "responses": RESPONSES,
            "openapi_extra": example(REQUESTS[each.name]),
        }
        path, name = f"{API}/{each.name}", each.name.replace("/", "-").replace("-", "_")
        app.post(path, operation_id=name, summary=each.title, response_model=each.answer, **shared)(
            answering(each)
        )
        if each.figure is not None:
            app.post(
                f"{path}/chart",
                operation_id=f"{name}_chart",
                summary=f"{each.title}: figure",
                response_model=FigureOut,
                **shared,
            )(drawing(each))
    app.include_router(batch.router, prefix=API)
    app.include_router(about.router)
    app.openapi = lambda: describe(app)  # type: ignore[method-assign]
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
            raise unavailable("No process for calculations is there yet, or any more")
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
