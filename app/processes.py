"""Long calculations: in processes beside the event loop, which answers nobody while it calculates.

A job comes back as the bytes of its answer: the loop neither calculates nor encodes. Its process
is ended when the time is over or the client has gone; no calculation needs to ask whether it
should stop.
"""

import asyncio
import traceback
from collections.abc import AsyncGenerator, AsyncIterator, Callable
from contextlib import aclosing, asynccontextmanager
from functools import partial
from typing import Any

from starlette.requests import ClientDisconnect

from app.jobs import Job, Jobs, Stopped
from app.problems import Problem, impossible
from app.record import Record, at_hand
from core.errors import ImpossibleMechanism

Tell = Callable[[Any], None]
"""What takes a part of what a job has to say."""


class CalculationFailed(Exception):
    """An error of our own in a process; its text is the traceback from there."""


async def in_process(jobs: Jobs, job: Job, *args: Any, record: Record) -> Any:
    """What a job tells that tells one thing, in a process, as long as there is time.

    If something stops the process from outside, another one tries it once more.

    Raises
    ------
    Problem
        The job's own.
    Busy, CannotRun, TooLong, Stopped
        As `Jobs.run`.
    """
    limit_s = record.settings.max_seconds
    ask = partial(in_parts, jobs, job, *args, record=record, limit_s=limit_s)
    try:
        (told,) = [part async for part in ask()]
    except Stopped:
        (told,) = [part async for part in ask(admitted=True)]
    return told


async def in_parts(
    jobs: Jobs, job: Job, *args: Any, record: Record, limit_s: float, admitted: bool = False
) -> AsyncGenerator[Any]:
    """What a job tells, in a process, as it comes; its refusal at the end, as `in_process`."""
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
async def wanted(record: Record) -> AsyncIterator[None]:
    """Ends what is done within when the client goes.

    Raises
    ------
    ClientDisconnect
        If it does.
    """
    working = asyncio.current_task()
    assert working is not None

    async def watch() -> None:
        while (await record.receive())["type"] != "http.disconnect":
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
    """Do a job in this process, and tell with each part how long its calculations took; or its
    error.
    """
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
