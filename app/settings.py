"""Settings of the operator, by environment variables that start with ``KHV_``."""

import os
from difflib import get_close_matches
from functools import cache
from importlib.util import find_spec
from ipaddress import ip_network
from typing import Annotated, Any, Literal, Self

from pydantic import AfterValidator, BeforeValidator, Field, ValidationError
from pydantic_settings import BaseSettings, NoDecode, SettingsConfigDict

PREFIX = "KHV_"

OVER_UNIX = "unix"
"""Address of clients of a Unix socket."""


def _parts(value: Any) -> Any:
    """Texts between commas."""
    if not isinstance(value, str):
        return value
    return tuple(part.strip() for part in value.split(",") if part.strip())


def _network(text: str) -> str:
    ip_network(text)
    return text


Seconds = Annotated[float, Field(ge=1e-3, le=86_400, allow_inf_nan=False)]
WholeSeconds = Annotated[int, Field(ge=1, le=86_400)]
Bytes = Annotated[int, Field(ge=1, le=2**30)]
Address = Annotated[str, AfterValidator(_network)]
BY_COMMAS = NoDecode, BeforeValidator(_parts)
UPPER = BeforeValidator(str.upper)
Origin = Annotated[str, Field(pattern=r"^(\*|https?://[^/\s]+)$")]


class Settings(BaseSettings):
    """Addresses and limits of the service, with defaults for a small machine.

    An empty variable counts as not set. The text below a setting states its meaning.
    """

    model_config = SettingsConfigDict(
        env_prefix=PREFIX,
        env_ignore_empty=True,
        frozen=True,
        extra="forbid",
        use_attribute_docstrings=True,
    )

    host: str = "127.0.0.1"
    """address on which the service listens"""
    port: int = Field(8000, ge=0, le=65_535)
    """port on which the service listens; 0 for any"""
    unix_socket: str = ""
    """path of a Unix socket on which the service listens instead"""
    workers: int = Field(1, ge=1, le=256)
    """processes that answer requests"""
    root_path: str = Field("", pattern=r"^(/\.*[A-Za-z0-9_~-][A-Za-z0-9._~-]*)*$")
    """path prefix at which a proxy shows the service, such as `/reducers`"""
    trusted_proxies: Annotated[tuple[Address, ...], *BY_COMMAS] = ()
    """networks of proxies whose `X-Forwarded-For` is trusted; over a Unix socket all are"""
    max_body_bytes: Bytes = 262_144
    """largest request body; 500 rollers take 60,000"""
    max_batch_bytes: Bytes = 1_048_576
    """largest body of a batch"""
    max_pairs: int = Field(10_000, ge=1, le=10_000)
    """largest number of pins times satellites"""
    max_curve_samples: int = Field(10_001, ge=2, le=10_001)
    """largest number of crank angles of a curve"""
    max_batch: int = Field(1_000, ge=1, le=1_000)
    """largest number of requests in one batch"""
    max_sweep_points: int = Field(100_000, ge=1, le=1_000_000)
    """largest number of points of a sweep"""
    max_seconds: Seconds = 10.0
    """longest calculation, without waiting for a process, s"""
    max_study_seconds: Seconds = 60.0
    """longest study that is sent with its progress, s"""
    processes: int = Field(0, ge=0, le=256)
    """processes for long calculations per worker; 0: one per processor"""
    max_waiting: int = Field(64, ge=1, le=100_000)
    """long calculations that may wait for a process, per worker"""
    max_large: int = Field(12, ge=1, le=10_000)
    """simultaneous batches, bodies above 16 kB and answers above 256 kB, per worker"""
    max_connections: int = Field(1_000, ge=1, le=1_000_000)
    """open connections per worker"""
    receive_seconds: Seconds = 10.0
    """longest time to send a body, or to take 256 kB of an answer, s"""
    keep_alive_seconds: WholeSeconds = 5
    """time for which an idle connection is kept, whole s"""
    stop_seconds: WholeSeconds = 30
    """time for which a stopping worker waits for answers, whole s"""
    dask: str = Field("", pattern=r"^(tcp|tls)://[^\s/]+:\d+$|^$")
    """scheduler of a Dask cluster that calculates studies, such as `tcp://10.0.0.5:8786`"""
    cors_origins: Annotated[tuple[Origin, ...], *BY_COMMAS] = ()
    """origins of other sites that may send requests, separated by commas"""
    log_level: Annotated[Literal["DEBUG", "INFO", "WARNING", "ERROR"], UPPER] = "INFO"
    """level of the log; `WARNING` leaves out the lines of requests"""
    build: str = Field("", pattern=r"^[A-Za-z0-9._+-]*$")
    """build of the version"""

    @classmethod
    def from_environment(cls) -> Self:
        """Settings by the environment; ValueError names a wrong value or an unknown setting."""
        names = {PREFIX + name.upper() for name in cls.model_fields}
        for name in os.environ:
            if name.upper().startswith(PREFIX) and name not in names:
                near = get_close_matches(name.upper(), names, 1)
                raise ValueError(f"{name} is no setting" + (f"; {near[0]} is" if near else ""))
        try:
            found = cls()
        except ValidationError as error:
            first = error.errors()[0]
            name = f"{PREFIX}{str(first['loc'][0]).upper()}"
            raise ValueError(f"{name}={os.environ[name]}: {first['msg']}") from None
        if found.dask and find_spec("distributed") is None:
            raise ValueError(f"{PREFIX}DASK needs the extra dask: see docs/operation.md")
        return found


@cache
def current() -> Settings:
    """Settings of this process, read once."""
    return Settings.from_environment()
