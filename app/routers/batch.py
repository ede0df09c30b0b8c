"""POST /batch: many requests of one calculation, as one answer or line by line as they are done."""

import asyncio
import time
import zlib
from collections.abc import AsyncIterator

from fastapi import APIRouter
from fastapi.responses import Response, StreamingResponse
from starlette.requests import Request

from app.batches import Batched, answers, split
from app.processes import in_process, refuse_if_busy
from app.record import Record, at_hand
from app.route import API, COMPRESS_LEVEL, JSON, RESPONSES, received, takes_gzip
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

router = APIRouter(prefix=f"{API}/batch", tags=["batch"], responses=RESPONSES)

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
    openapi_extra={
        "requestBody": {
            "required": True,
            "content": {JSON: {"schema": BatchRequest.model_json_schema()}},
        }
    },
)
async def batch(request: Request) -> Response:
    """Answers in the order of the requests, each with its result or its problem.

    With `Accept: application/x-ndjson` a line for each request. Both are sent as they are done.
    """
    record, jobs = at_hand.get() or Record(), request.app.state.jobs
    refuse_if_busy(jobs)
    content = await received(request, record.settings.max_batch_bytes)
    record.received = time.perf_counter()
    calculation, requests = await in_process(jobs, split, content, record.settings, record=record)
    done = answers(jobs, CALCULATIONS[calculation], requests, record)
    done = _from(await anext(done), done)  # without which there is nothing to answer
    by_lines = LINES in request.headers.get("accept", "")
    written = _as_lines(done) if by_lines else _as_object(done)
    headers = {"vary": "accept-encoding"}
    if takes_gzip(request):
        headers["content-encoding"] = "gzip"
        written = _zipped(written)
    return StreamingResponse(written, headers=headers, media_type=LINES if by_lines else JSON)


async def _from(
    first: list[bytes], others: AsyncIterator[list[bytes]]
) -> AsyncIterator[list[bytes]]:
    yield first
    async for some in others:
        yield some


async def _as_lines(answers: AsyncIterator[list[bytes]]) -> AsyncIterator[bytes]:
    async for some in answers:
        yield b"\n".join([*some, b""])


async def _as_object(answers: AsyncIterator[list[bytes]]) -> AsyncIterator[bytes]:
    before = b'{"results":['
    async for some in answers:
        yield before + b",".join(some)
        before = b","
    yield b"]}"


async def _zipped(written: AsyncIterator[bytes]) -> AsyncIterator[bytes]:
    """The same compressed, each part as soon as it is there, and not in the event loop."""
    packer = zlib.compressobj(COMPRESS_LEVEL, wbits=zlib.MAX_WBITS + 16)

    def packed(part: bytes) -> bytes:
        return packer.compress(part) + packer.flush(zlib.Z_SYNC_FLUSH)

    async for part in written:
        yield await asyncio.to_thread(packed, part)
    yield packer.flush()
