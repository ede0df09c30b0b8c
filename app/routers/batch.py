"""POST /batch: many requests of one calculation, as one answer or line by line as they are done."""

import time
from collections.abc import AsyncIterator, Callable
from typing import Annotated, Any

import orjson
from fastapi import APIRouter, Header
from fastapi.responses import Response, StreamingResponse
from pydantic import ValidationError
from starlette.requests import Request

from app.calculation import refusals_named
from app.problems import Problem, impossible, wrong_fields
from app.processes import in_process
from app.record import Record, at_hand
from app.route import encoded, json_response
from app.routers import contact_force, crank_planetary, cyclogram, hertz, precession
from app.routers import roller_strength as rollers
from app.schemas.base import RequestModel, Values
from app.schemas.batch import BatchRequest, BatchResponse
from app.schemas.contact_force import ContactForceRequest, solve_peaks
from app.schemas.crank_planetary import CrankPlanetaryRequest
from app.schemas.cyclogram import CyclogramRequest
from app.schemas.hertz import HertzRequest, solve_contacts
from app.schemas.precession.contact_line import ContactLineRequest
from app.schemas.precession.meshing_load import MeshingLoadRequest
from app.schemas.precession.shaft_deflection import ShaftDeflectionRequest
from app.schemas.roller_strength import RollerStrengthRequest, solve_rollers
from app.settings import Settings
from core.errors import ImpossibleMechanism

router = APIRouter(prefix="/batch", tags=["batch"])

LINES = "application/x-ndjson"

SLICE = 1000
"""Most requests that are handed to a process at once."""

SLICE_S = 0.25
"""Time after which a process hands back what it has done, so that answers begin to flow."""

ENDPOINTS: dict[str, tuple[type[RequestModel], Any]] = {
    "cyclogram": (CyclogramRequest, cyclogram.cyclogram),
    "contact_force": (ContactForceRequest, contact_force.contact_force),
    "hertz": (HertzRequest, hertz.hertz),
    "crank_planetary": (CrankPlanetaryRequest, crank_planetary.crank_planetary),
    "roller_strength": (RollerStrengthRequest, rollers.roller_strength),
    "contact_line": (ContactLineRequest, precession.contact_line),
    "meshing_load": (MeshingLoadRequest, precession.meshing_load),
    "shaft_deflection": (ShaftDeflectionRequest, precession.shaft_deflection),
}
"""Request and endpoint of every calculation that can be asked in batches."""

TOGETHER: dict[str, Callable[[list[Any]], list[Values | None]]] = {
    "contact_force": solve_peaks,
    "hertz": solve_contacts,
    "roller_strength": solve_rollers,
}
"""Calculations that are done for many requests at once, as arrays."""


@router.post(
    "",
    response_model=BatchResponse,
    responses={200: {"content": {LINES: {"schema": {"type": "string"}}}}},
)
async def batch(
    request: Request, body: BatchRequest, accept: Annotated[str, Header()] = ""
) -> Response:
    """Answers in the order of the requests, each with its result or its problem.

    With `Accept: application/x-ndjson` a line for each request, sent as it is done.
    """
    record = at_hand.get() or Record()
    with refusals_named(body):
        body.refuse_beyond(record.settings)
    answers = _answers(body, record)
    if LINES in accept:
        return StreamingResponse((line + b"\n" async for line in answers), media_type=LINES)
    results = b",".join([line async for line in answers])
    return json_response(request, b'{"results":[' + results + b"]}")


async def _answers(body: BatchRequest, record: Record) -> AsyncIterator[bytes]:
    """The answers as JSON, calculated in another process and in order."""
    waiting = body.requests
    alone = 0  # so many are calculated each for itself, as one of them takes longer than is allowed
    while waiting:
        some = waiting[: 1 if alone else SLICE]
        try:
            job = body.calculation, some, record.settings
            done = (await in_process(_some, *job, record=record)).split(b"\n")
        except Problem as problem:
            if len(some) > 1:
                alone = len(some)
                continue
            done, alone = [orjson.dumps({"problem": problem.body()})], 1
        for line in done:
            yield line
        waiting = waiting[len(done) :]
        alone = max(0, alone - len(done))


def _some(calculation: str, requests: list[Any], settings: Settings) -> bytes:
    """The answers to the first requests, a line each: to as many as there is time for."""
    end = time.monotonic() + SLICE_S
    bodies = [_body(ENDPOINTS[calculation][0], request, settings) for request in requests]
    together = _together(calculation, bodies)
    lines = []
    for index, body in enumerate(bodies):
        lines.append(_line(calculation, body, together.get(index)))
        if time.monotonic() > end:
            break
    return b"\n".join(lines)


def _together(calculation: str, bodies: list[RequestModel | Problem]) -> dict[int, Values]:
    """Answers to the requests that can be calculated as arrays, by their index."""
    solve = TOGETHER.get(calculation)
    indices = [index for index, body in enumerate(bodies) if isinstance(body, RequestModel)]
    if solve is None or not indices:
        return {}
    answers = solve([bodies[index] for index in indices])
    return {
        index: answer for index, answer in zip(indices, answers, strict=True) if answer is not None
    }


def _body(model: type[RequestModel], request: Any, settings: Settings) -> RequestModel | Problem:
    """A request as its model, or what is wrong with it."""
    try:
        body = model.model_validate(request)
        with refusals_named(body):
            body.refuse_beyond(settings)
    except ValidationError as error:
        return wrong_fields(error.errors())
    except Problem as refusal:
        return refusal
    return body


def _line(calculation: str, body: RequestModel | Problem, values: Values | None) -> bytes:
    """One answer as JSON; `values` where they are known already."""
    if isinstance(body, RequestModel):
        try:
            result = encoded(ENDPOINTS[calculation][1](body) if values is None else values)
        except ImpossibleMechanism as error:
            body = impossible(error)
        except Problem as refusal:
            body = refusal
        else:
            return b'{"result":' + result + b"}"
    return orjson.dumps({"problem": body.body()})
