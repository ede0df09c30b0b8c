"""POST /batch: many requests of one calculation, as one answer or line by line as they are done."""

from fastapi.responses import Response, StreamingResponse
from starlette.requests import Request

from app.batches import Batched, answers
from app.record import Record, at_hand
from app.route import calculations, json_response
from app.routers import contact_force, crank_planetary, cyclogram, hertz, precession
from app.routers import roller_strength as rollers
from app.schemas.batch import BatchRequest, BatchResponse
from app.schemas.contact_force import ContactForceRequest
from app.schemas.crank_planetary import CrankPlanetaryRequest
from app.schemas.cyclogram import CyclogramRequest
from app.schemas.hertz import HertzRequest
from app.schemas.precession.contact_line import ContactLineRequest
from app.schemas.precession.meshing_load import MeshingLoadRequest
from app.schemas.precession.shaft_deflection import ShaftDeflectionRequest
from app.schemas.roller_strength import RollerStrengthRequest

router = calculations("/batch", tag="batch")

LINES = "application/x-ndjson"

CALCULATIONS = {
    "cyclogram": Batched(CyclogramRequest, cyclogram.cyclogram),
    "contact_force": Batched(ContactForceRequest, contact_force.contact_force),
    "hertz": Batched(HertzRequest, hertz.hertz),
    "crank_planetary": Batched(CrankPlanetaryRequest, crank_planetary.crank_planetary),
    "roller_strength": Batched(RollerStrengthRequest, rollers.roller_strength),
    "contact_line": Batched(ContactLineRequest, precession.contact_line),
    "meshing_load": Batched(MeshingLoadRequest, precession.meshing_load),
    "shaft_deflection": Batched(ShaftDeflectionRequest, precession.shaft_deflection),
}


@router.post(
    "",
    response_model=BatchResponse,
    responses={200: {"content": {LINES: {"schema": {"type": "string"}}}}},
)
async def batch(body: BatchRequest, request: Request) -> Response:
    """Answers in the order of the requests, each with its result or its problem.

    With `Accept: application/x-ndjson` a line for each request, sent as it is done.
    """
    record = at_hand.get() or Record()
    lines = answers(CALCULATIONS[body.calculation], body.requests, record)
    if LINES in request.headers.get("accept", ""):
        return StreamingResponse((line + b"\n" async for line in lines), media_type=LINES)
    results = b",".join([line async for line in lines])
    return json_response(request, b'{"results":[' + results + b"]}")
