"""Long calculations: in processes beside the event loop, which answers nobody while it calculates.

A job comes back as the bytes of its answer: the loop neither calculates nor encodes. Its process
is ended when the time is over or the client has gone; no calculation needs to ask whether it
should stop.
"""

import asyncio
import logging
import traceback
from collections.abc import AsyncGenerator, Callable, Coroutine, Iterator
from contextlib import contextmanager
from typing import Any, TypeVar

from starlette.requests import ClientDisconnect

from app import compiled
from app.jobs import Busy, CannotRun, Jobs, Stopped, TooLong, Unfinished
from app.problems import Problem, impossible, too_long, unavailable
from app.record import Record, at_hand
from core.errors import ImpossibleMechanism

LOG = logging.getLogger("khv.processes")

Result = TypeVar("Result")


class CalculationFailed(Exception):
    """An error of our own in a process; its text is the traceback from there."""


@contextmanager
def refused_if_busy() -> Iterator[None]:
    """Say that there is no room for a job, and when there may be, as a problem."""
    try:
        yield
    except Busy as busy:
        raise unavailable("Too many calculations are waiting", busy.retry_after_s) from None
    except CannotRun:
        raise unavailable("No process for calculations can be started") from None


async def in_process(
    jobs: Jobs, job: Callable[..., Iterator[Any]], *args: Any, record: Record
) -> Any:
    """What a job yields that yields once, in a process, as long as there is time and someone waits.

    If something stops the process from outside, another one tries it once more.

    Raises
    ------
    Problem
        The job's own; 503, and when to try again, if too many are waiting, or the time is over.
    ClientDisconnect
        If the client goes before.
    """
    limit_s = record.settings.max_seconds
    for last in (False, True):
        try:
            (part,) = await in_parts(
                jobs, job, *args, record=record, limit_s=limit_s, admitted=last
            )
            break
        except Unfinished as unfinished:
            if last or isinstance(unfinished, TooLong):
                raise why(unfinished, limit_s) from None
    return part


async def in_parts(
    jobs: Jobs,
    job: Callable[..., Iterator[Any]],
    *args: Any,
    record: Record,
    limit_s: float,
    admitted: bool,
) -> list[Any]:
    """All that a job yields, in a process, as long as someone waits for it; see `Jobs.run`.

    Raises
    ------
    Problem, ClientDisconnect
        As `in_process`.
    TooLong, Stopped
        If the job does not come to its end; with what it had yielded.
    """
    running = jobs.run(_told, job, args, limit_s=limit_s, admitted=admitted, client=record.client)
    try:
        with refused_if_busy():
            return [_noted(part, record) for part in await _while_wanted(running, record)]
    except Unfinished as unfinished:
        if isinstance(unfinished, Stopped):
            LOG.warning("a process for calculations was stopped")
        unfinished.parts = [_noted(part, record) for part in unfinished.parts]
        raise


async def as_it_comes(
    jobs: Jobs, job: Callable[..., Iterator[Any]], *args: Any, record: Record, limit_s: float
) -> AsyncGenerator[Any]:
    """What a job yields, in a process, part by part, as long as someone waits for it.

    Raises
    ------
    Problem, ClientDisconnect
        As `in_process`.
    """
    parts = jobs.stream(_told, job, args, limit_s=limit_s, client=record.client)
    try:
        with refused_if_busy():
            while some := await _while_wanted(anext(parts, []), record):
                for part in some:
                    yield _noted(part, record)
    except Unfinished as unfinished:
        raise why(unfinished, limit_s) from None
    finally:
        if not getattr(parts, "ag_running", False):  # else it is cancelled already
            await parts.aclose()


def why(unfinished: Unfinished, limit_s: float) -> Problem:
    """Problem of a calculation that has not come to its end."""
    if isinstance(unfinished, TooLong):
        return too_long(limit_s)
    return unavailable("The process of the calculation was stopped")


async def _while_wanted(work: Coroutine[Any, Any, Result], record: Record) -> Result:
    """Outcome of work, which is cancelled where the client goes before."""
    working = asyncio.ensure_future(work)
    leaving = asyncio.ensure_future(_gone(record))
    try:
        await asyncio.wait((working, leaving), return_when=asyncio.FIRST_COMPLETED)
        if not working.done():
            raise ClientDisconnect
        return working.result()
    finally:
        working.cancel()
        leaving.cancel()


async def _gone(record: Record) -> None:
    while (await record.receive())["type"] != "http.disconnect":
        pass


def _noted(part: Any, record: Record) -> Any:
    """What the job had yielded, or raised; the run times of its calculations are noted."""
    if isinstance(part, Exception):
        raise part
    value, calculation_us = part
    if calculation_us:
        record.calculation_took(calculation_us)
    return value


def _told(job: Callable[..., Iterator[Any]], args: tuple[Any, ...]) -> Iterator[Any]:
    """What a job yields in this process, with the run times of its calculations; or its error.

    It may be a process from before the loops were compiled.
    """
    compiled.use()
    record = Record()
    at_hand.set(record)
    try:
        for value in job(*args):
            yield value, record.calculation_us
            record.calculation_us = 0.0
    except Problem as problem:
        yield problem
    except ImpossibleMechanism as error:
        yield impossible(error)
    except Exception:
        yield CalculationFailed(traceback.format_exc())
