"""Record of the current request, for its log line, its metrics and its calculations."""

import time
from collections import Counter
from contextvars import ContextVar
from dataclasses import dataclass, field

from app.settings import Settings, current


@dataclass(slots=True)
class Record:
    """One request: its client and its times."""

    settings: Settings = field(default_factory=current)  # limits of the service that answers
    request_id: str = ""  # the client's own, or one made
    # Address of the client as the service or a trusted proxy sees it; `unix` for a Unix socket.
    client: str = ""
    # Number of the worker's places for large requests that each client has.
    places: Counter[str] = field(default_factory=Counter)
    has_place: bool = False  # True if the request holds one of these places
    # Times of arrival, of the whole body, of the last calculation and of the start of the answer:
    # seconds of `time.perf_counter`, 0 before the event.
    started: float = field(default_factory=time.perf_counter)
    received: float = 0.0
    calculated: float = 0.0
    answered: float = 0.0
    status: int = 0  # HTTP status; 0 before the answer
    calculation_us: float = 0.0  # run time of its calculations, microseconds

    def calculation_took(self, run_time_us: float) -> None:
        """Note the run time of a calculation."""
        self.calculation_us += run_time_us
        self.calculated = time.perf_counter()


def root_path() -> str:
    """Prefix of the addresses in an answer."""
    record = at_hand.get()
    return (record.settings if record else current()).root_path


at_hand: ContextVar[Record | None] = ContextVar("at_hand", default=None)
"""Record of the current request, if there is one."""
