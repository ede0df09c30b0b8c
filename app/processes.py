"""Processes for long calculations: where the event loop answers nobody while it calculates.

A job comes back as the bytes of its answer: the loop neither calculates nor encodes. Its process
is killed when the time is over or the client has gone; no calculation needs to ask whether it
should stop.
"""

import logging
import signal
import traceback
from collections.abc import Callable
from contextlib import suppress
from typing import Any

import anyio
from anyio.to_process import current_default_process_limiter, run_sync
from starlette.requests import ClientDisconnect

from app.problems import Problem, impossible, unavailable
from app.record import Record, at_hand
from core.errors import ImpossibleMechanism

LOG = logging.getLogger("khv.processes")

INLINE_MS = 15.0
"""Estimated cost up to which a request runs in the event loop, milliseconds; handing it over costs
half of one."""


class CalculationFailed(Exception):
    """An error of our own in a process; its text is the traceback from there."""


async def in_process(job: Callable[..., bytes], *args: Any, record: Record) -> bytes:
    """Outcome of a job that runs in a process as long as there is time and someone waits.

    If something stops the process from outside, another one tries it once more.

    Parameters
    ----------
    job : callable
        What to run: a function of a module.
    *args
        Its arguments; they are pickled.
    record : Record
        The request.

    Returns
    -------
    bytes

    Raises
    ------
    Problem
        The job's own; if the time is over: 503, and when to try again.
    ClientDisconnect
        If the client goes before.
    """
    settings = record.settings
    limiter = current_default_process_limiter()
    if settings.processes:
        limiter.total_tokens = settings.processes
    outcome: tuple[bytes, list[float]] | Exception = unavailable(
        f"The calculation was not done within {settings.max_seconds:g} s: it is too long, or "
        "too many are under way"
    )
    gone = anyio.Event()
    with anyio.move_on_after(settings.max_seconds):
        async with anyio.create_task_group() as group:
            group.start_soon(_stop_when_gone, record, gone, group.cancel_scope)
            for _ in range(2):
                try:
                    outcome = await run_sync(_done, job, args, cancellable=True, limiter=limiter)
                    break
                except (CalculationFailed, Problem) as failed:
                    outcome = failed
                    break
                except Exception as broken:
                    LOG.warning("a process for calculations was stopped", exc_info=broken)
                    outcome = unavailable("The process of the calculation was stopped")
            group.cancel_scope.cancel()
    if gone.is_set():
        raise ClientDisconnect
    if isinstance(outcome, Exception):
        raise outcome
    content, calculations_us = outcome
    for run_time_us in calculations_us:
        record.calculation_took(run_time_us)
    return content


async def prepared(job: Callable[[], None]) -> None:
    """Do in a process what has to be done before its first long request, in no limited time.

    Parameters
    ----------
    job : callable
        What to do: a function of a module.
    """
    with suppress(anyio.BrokenWorkerProcess, OSError):
        await run_sync(_prepare, job, cancellable=True)


async def _stop_when_gone(record: Record, gone: anyio.Event, scope: anyio.CancelScope) -> None:
    while (await record.receive())["type"] != "http.disconnect":
        pass
    gone.set()
    scope.cancel()


def _prepare(job: Callable[[], None]) -> None:
    _outlive_signals()
    job()


def _outlive_signals() -> None:
    """Leave stopping to the worker: signals to its whole group would lose requests in flight."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, signal.SIG_IGN)


def _done(job: Callable[..., bytes], args: tuple[Any, ...]) -> tuple[bytes, list[float]]:
    """Run a job in this process: what it returns, and the run times of its calculations."""
    _outlive_signals()
    record = Record()
    at_hand.set(record)
    try:
        return job(*args), record.calculations_us
    except Problem:
        raise
    except ImpossibleMechanism as error:
        raise impossible(error) from None
    except Exception:
        raise CalculationFailed(traceback.format_exc()) from None
