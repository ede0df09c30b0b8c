"""Long calculations in processes beside the event loop, which cannot answer while it calculates.

A job returns the bytes of its answer, so that the loop neither calculates nor encodes. The process
of a job is ended if its time is over or the client has left; calculations need no checks for that.
"""

import asyncio
import traceback
from collections.abc import AsyncGenerator, AsyncIterator, Callable
from contextlib import aclosing, asynccontextmanager
from functools import partial
from typing import Any

from starlette.requests import ClientDisconnect, Request

from app.jobs import Job, Jobs, Stopped
from app.problems import Problem, impossible
from app.record import Record, at_hand
from core.errors import ImpossibleMechanism

Tell = Callable[[Any], None]
"""Function that takes a part of a job's result."""


class CalculationFailed(Exception):
    """Internal error in a process; the text is the traceback from there."""


async def in_process(
    jobs: Jobs, job: Job, *args: Any, record: Record, limit_s: float | None = None
) -> Any:
    """Result of a job with one part, in a process, within a time, that of a calculation by default.

    A process that is stopped from outside is replaced once. Raises the job's own `Problem`, or the
    exceptions of `Jobs.run`.
    """
    limit_s = limit_s or record.settings.max_seconds
    ask = partial(in_parts, jobs, job, *args, record=record, limit_s=limit_s)
    try:
        (told,) = [part async for part in ask()]
    except Stopped:
        (told,) = [part async for part in ask(admitted=True)]
    return told


async def in_parts(
    jobs: Jobs, job: Job, *args: Any, record: Record, limit_s: float, admitted: bool = False
) -> AsyncGenerator[Any]:
    """Parts of a job's result from a process, as they come; a refusal is raised at the end."""
    running = jobs.run(told, job, args, limit_s=limit_s, admitted=admitted, client=record.client)
    refusal: Exception | None = None
    async with aclosing(running):
        async for part, calculation_us in running:
            if isinstance(part, Exception):
                refusal = part
                continue
            if calculation_us:
                record.calculation_took(calculation_us)
            yield part
    if refusal is not None:
        raise refusal


@asynccontextmanager
async def wanted(request: Request) -> AsyncIterator[None]:
    """Context that is cancelled, and raises `ClientDisconnect`, if the client leaves."""
    working = asyncio.current_task()
    assert working is not None

    async def watch() -> None:
        while (await request.receive())["type"] != "http.disconnect":
            pass
        working.cancel()

    watching = asyncio.create_task(watch())
    try:
        yield
    except asyncio.CancelledError:
        if watching.done() and working.uncancel() == 0:
            raise ClientDisconnect from None
        raise
    finally:
        watching.cancel()


def told(tell: Callable[..., None], job: Job, args: tuple[Any, ...]) -> None:
    """Do a job in this process, and return each part with its calculation time, or the error."""
    record = Record()
    at_hand.set(record)

    def timed(part: Any) -> None:
        tell((part, record.calculation_us))
        record.calculation_us = 0.0

    try:
        job(timed, *args)
    except Problem as problem:
        timed(problem)
    except ImpossibleMechanism as error:
        timed(impossible(error))
    except Exception:
        timed(CalculationFailed(traceback.format_exc()))
