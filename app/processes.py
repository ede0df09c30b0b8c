"""Where an endpoint runs: at once if it is short, in a process of its own pool if it is long.

The event loop answers nobody while it calculates, so only what takes a few milliseconds runs in
it. A longer request is handed to another process with its endpoint, and comes back as the bytes
of its answer: the loop neither calculates nor encodes. That process is killed when the time is
over or the client has gone; no calculation needs to ask whether it should stop.
"""

import functools
import logging
import signal
import time
import traceback
from collections.abc import Awaitable, Callable
from contextlib import suppress
from dataclasses import dataclass
from typing import Any, ParamSpec, TypeVar, cast

import anyio
import orjson
from anyio.to_process import current_default_process_limiter, run_sync
from pydantic import BaseModel
from starlette.responses import Response

from app.calculation import refusals_named
from app.problems import Problem, impossible, unavailable
from app.record import Record, at_hand
from app.schemas.base import RequestModel
from core.errors import ImpossibleMechanism

Given = ParamSpec("Given")
Result = TypeVar("Result")

LOG = logging.getLogger("khv.processes")

INLINE_MS = 15.0
"""Estimated cost up to which a request runs in the event loop, milliseconds; handing it over costs
half of one."""


@dataclass(frozen=True, slots=True)
class Answer:
    """What a process hands back: an HTTP answer and the run times of its calculations."""

    status: int
    headers: dict[str, str]
    media_type: str | None
    body: bytes
    calculations_us: list[float]


class CalculationFailed(Exception):
    """An error of our own in a process; its text is the traceback from there."""


def calculating(endpoint: Callable[Given, Result]) -> Callable[Given, Awaitable[Result]]:
    """Endpoint of a calculation that runs at once or in a process, by what it will cost.

    Parameters
    ----------
    endpoint : callable
        The endpoint: a function of a module, whose argument `body` is the request.
    """
    return _placed(endpoint, drawn=False)


def drawing(endpoint: Callable[Given, Result]) -> Callable[Given, Awaitable[Result]]:
    """Endpoint of a figure, as `calculating`.

    Parameters
    ----------
    endpoint : callable
        The endpoint: a function of a module, whose argument `body` is the request.
    """
    return _placed(endpoint, drawn=True)


def _placed(
    endpoint: Callable[Given, Result], *, drawn: bool
) -> Callable[Given, Awaitable[Result]]:
    @functools.wraps(endpoint)
    async def placed(*args: Given.args, **given: Given.kwargs) -> Result:
        body = cast(RequestModel, given["body"])
        record = at_hand.get() or Record()
        with refusals_named(body):
            body.refuse_beyond(record.settings)
        if body.cost_ms(drawn=drawn) <= INLINE_MS:
            return endpoint(*args, **given)
        return cast(Result, await in_process(_answer, placed, given, record=record))

    return placed


async def in_process(job: Callable[..., Answer], *args: Any, record: Record) -> Response:
    """Answer of a job that runs in a process as long as there is time and someone waits.

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
    Response

    Raises
    ------
    Problem
        If the time is over: 503, and when to try again.
    """
    settings = record.settings
    limiter = current_default_process_limiter()
    if settings.processes:
        limiter.total_tokens = settings.processes
    outcome: Answer | Exception = unavailable(
        f"The calculation was not done within {settings.max_seconds:g} s: it is too long, or "
        "too many are under way"
    )
    with anyio.move_on_after(settings.max_seconds):
        async with anyio.create_task_group() as group:
            group.start_soon(_stop_when_gone, record, group.cancel_scope)
            for _ in range(2):
                try:
                    outcome = await run_sync(job, *args, cancellable=True, limiter=limiter)
                    break
                except CalculationFailed as failed:
                    outcome = failed
                    break
                except Exception as broken:
                    LOG.warning("a process for calculations was stopped", exc_info=broken)
                    outcome = unavailable("The process of the calculation was stopped")
            group.cancel_scope.cancel()
    if isinstance(outcome, Exception):
        raise outcome
    for run_time_us in outcome.calculations_us:
        record.calculation_took(run_time_us)
    return Response(outcome.body, outcome.status, outcome.headers, outcome.media_type)


async def warm_up() -> None:
    """Start a process before the first long request, which would wait for its imports."""
    with suppress(anyio.BrokenWorkerProcess, OSError):
        await run_sync(_ready, cancellable=True)


async def _stop_when_gone(record: Record, scope: anyio.CancelScope) -> None:
    while (await record.receive())["type"] != "http.disconnect":
        pass
    scope.cancel()


def _ready() -> None:
    """Nothing: to be called is to have imported this module."""
    _outlive_signals()


def _outlive_signals() -> None:
    """Leave stopping to the worker: signals to its whole group would lose requests in flight."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, signal.SIG_IGN)


def _answer(placed: Callable[..., Any], given: dict[str, Any]) -> Answer:
    """Run an endpoint in this process and encode what it returns."""
    _outlive_signals()
    record = Record(started=time.perf_counter())
    at_hand.set(record)
    try:
        result = placed.__wrapped__(**given)  # type: ignore[attr-defined]
    except Problem as problem:
        result = problem.response()
    except ImpossibleMechanism as error:
        result = impossible(error).response()
    except Exception:
        raise CalculationFailed(traceback.format_exc()) from None
    response = result if isinstance(result, Response) else _encoded(result)
    return Answer(
        response.status_code,
        {name: value for name, value in response.headers.items() if name != "content-length"},
        response.media_type,
        bytes(response.body),
        record.calculations_us,
    )


def _encoded(result: BaseModel | dict[str, Any]) -> Response:
    """A model or a figure as JSON."""
    content = (
        result.model_dump_json(exclude_none=True).encode()
        if isinstance(result, BaseModel)
        else orjson.dumps(result)
    )
    return Response(content, media_type="application/json")
