"""The service: settings, endpoints, errors, headers, pages."""

from pathlib import Path
from typing import Any

from fastapi import FastAPI
from fastapi.middleware.gzip import GZipMiddleware
from fastapi.responses import FileResponse, JSONResponse
from fastapi.staticfiles import StaticFiles

from app import VERSION, problems
from app.middleware import BodyLimit, ServiceHeaders
from app.routers import (
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

API = "/api/v1"
STATIC = Path(__file__).parent.parent / "static"
ROUTERS = (
    service,
    crank_planetary,
    cyclogram,
    contact_force,
    hertz,
    roller_strength,
    precession,
    work_precision,
)

PROBLEMS: dict[int | str, dict[str, Any]] = {
    status: {
        "description": text,
        "content": {problems.MEDIA_TYPE: {"schema": {"$ref": "#/components/schemas/ProblemOut"}}},
    }
    for status, text in (
        (413, "The request is too large"),
        (422, "The input is wrong, or the mechanism cannot work"),
    )
}

DESCRIPTION = """
Design calculations of K-H-V planetary reducers: cyclogram, contact forces and stresses.
A quantity's name ends in its unit; plain names are dimensionless. Every answer carries its
accuracy. Errors are problem details (RFC 9457) whose `errors` point to the fields.
"""


def describe_problems(app: FastAPI) -> None:
    """Put the schema of a problem into the API's description; FastAPI would call it JSON."""
    generate = app.openapi

    def openapi() -> dict[str, Any]:
        schema = generate()
        models = ProblemOut.model_json_schema(ref_template="#/components/schemas/{model}")
        nested = models.pop("$defs")
        schema["components"]["schemas"] |= nested | {"ProblemOut": models}
        return schema

    app.openapi = openapi  # type: ignore[method-assign]


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
        title="KHV Calc", version=VERSION, description=DESCRIPTION, docs_url=None, redoc_url=None
    )
    for router in ROUTERS:
        app.include_router(router.router, prefix=API, responses=PROBLEMS)
    problems.install(app)
    describe_problems(app)
    app.add_middleware(GZipMiddleware, minimum_size=2048, compresslevel=6)
    app.add_middleware(BodyLimit, limit=settings.max_body_bytes)
    app.add_middleware(ServiceHeaders)

    @app.api_route("/", methods=["GET", "HEAD"], include_in_schema=False)
    async def page() -> FileResponse:
        return FileResponse(STATIC / "index.html")

    @app.api_route("/docs", methods=["GET", "HEAD"], include_in_schema=False)
    async def docs() -> FileResponse:
        return FileResponse(STATIC / "docs.html")

    @app.get(f"{API}/openapi.json", include_in_schema=False)
    async def openapi() -> JSONResponse:
        return JSONResponse(app.openapi())

    app.mount("/static", StaticFiles(directory=STATIC), name="static")
    return app


app = create_app()
