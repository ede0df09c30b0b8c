"""What is known of the request at hand, for its log line, its metrics and its calculations."""

import time
from collections import Counter
from collections.abc import Awaitable, Callable
from contextvars import ContextVar
from dataclasses import dataclass, field
from typing import Any

from app.settings import Settings, current


async def _nothing_more() -> Any:
    """What a client outside any request sends: nothing."""
    return {"type": "http.disconnect"}


@dataclass(slots=True)
class Record:
    """One request: who asks, and where its time goes."""

    settings: Settings = field(default_factory=current)  # limits of the service that answers
    request_id: str = ""  # the client's own, or one made
    # What the client sent with its body, by names in lower case.
    headers: dict[bytes, bytes] = field(default_factory=dict)
    # The client: what it sends next, which after its body is that it has gone.
    receive: Callable[[], Awaitable[Any]] = _nothing_more
    # Its address, as the service or a trusted proxy sees it; `unix` over a Unix socket.
    client: str = ""
    # How many of the worker's places for what is large each client has.
    places: Counter[str] = field(default_factory=Counter)
    has_place: bool = False  # whether it has one of them, until it has been answered
    # When the request came, its body was whole, its last calculation was done, its answer started:
    # seconds of `time.perf_counter`, 0 where it has not happened.
    started: float = field(default_factory=time.perf_counter)
    received: float = 0.0
    calculated: float = 0.0
    answered: float = 0.0
    status: int = 0  # of HTTP; 0 where there is none yet
    calculation_us: float = 0.0  # run time of its calculations, microseconds

    def calculation_took(self, run_time_us: float) -> None:
        """Note a calculation that has just been done."""
        self.calculation_us += run_time_us
        self.calculated = time.perf_counter()


def root_path() -> str:
    """The prefix below which the addresses of an answer stand."""
    record = at_hand.get()
    return (record.settings if record else current()).root_path


at_hand: ContextVar[Record | None] = ContextVar("at_hand", default=None)
"""Record of the request at hand, if there is one."""
