"""What an operator may set, by environment variables that start with ``KHV_``."""

import math
import os
from dataclasses import dataclass, fields
from typing import Any, Self


@dataclass(frozen=True, slots=True)
class Settings:
    """Limits of the service; every one has a default that suits a small machine.

    Attributes
    ----------
    max_body_bytes : int
        Largest request body, bytes.
    max_batch_bytes : int
        Largest body of a batch, bytes.
    max_pairs : int
        Most pin/hole pairs of a mechanism; at most 10000, what the calculations are tested for.
    max_curve_samples : int
        Most crank angles of a curve; at most 10001.
    max_batch : int
        Most requests in one batch.
    max_seconds : float
        Longest time of a calculation, seconds; waiting for a free process is not counted.
    processes : int
        Processes for long calculations, for each worker; 0 for one to a processor.
    max_waiting : int
        Most long calculations that wait for a process of a worker.
    max_connections : int
        Most open connections of a worker.
    receive_seconds : float
        Longest time for a client to send a request, and to take a part of the answer, seconds.
    keep_alive_seconds : int
        How long an idle connection is kept, seconds.
    stop_seconds : int
        How long a stopping worker waits for the requests in flight, seconds.
    cors_origins : tuple of str
        Origins of other sites whose pages may ask, separated by commas; none as a rule.
    log_level : str
        Least level that is logged: a line for each request is INFO.
    """

    max_body_bytes: int = 262_144
    max_batch_bytes: int = 8_388_608
    max_pairs: int = 10_000
    max_curve_samples: int = 10_001
    max_batch: int = 10_000
    max_seconds: float = 10.0
    processes: int = 0
    max_waiting: int = 64
    max_connections: int = 2_000
    receive_seconds: float = 10.0
    keep_alive_seconds: int = 5
    stop_seconds: int = 30
    cors_origins: tuple[str, ...] = ()
    log_level: str = "INFO"

    @classmethod
    def from_environment(cls) -> Self:
        """Settings with what the environment overrides.

        Raises
        ------
        ValueError
            If a value is not a number that can be where one is needed.
        """
        given: dict[str, Any] = {}
        for field in fields(cls):
            name = f"KHV_{field.name.upper()}"
            if name not in os.environ:
                continue
            text = os.environ[name]
            if field.type == tuple[str, ...]:
                given[field.name] = tuple(part.strip() for part in text.split(",") if part.strip())
                continue
            assert callable(field.type)
            try:
                given[field.name] = field.type(text)
            except ValueError as error:
                raise ValueError(f"{name} must be a number, not {text!r}") from error
            least = 0 if field.name == "processes" else 1e-3
            if field.type is not str and not least <= given[field.name] < math.inf:
                raise ValueError(f"{name} must be at least {least}, not {text}")
        return cls(**given)
