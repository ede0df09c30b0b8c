"""What an operator may set, by environment variables that start with ``KHV_``."""

import os
from difflib import get_close_matches
from functools import cache
from ipaddress import ip_network
from typing import Annotated, Any, Literal, Self

from pydantic import AfterValidator, BeforeValidator, Field, ValidationError
from pydantic_settings import BaseSettings, NoDecode, SettingsConfigDict

PREFIX = "KHV_"


def _parts(value: Any) -> Any:
    """What stands between commas."""
    if not isinstance(value, str):
        return value
    return tuple(part.strip() for part in value.split(",") if part.strip())


def _network(text: str) -> str:
    ip_network(text)
    return text


def _upper(value: Any) -> Any:
    return value.upper() if isinstance(value, str) else value


Seconds = Annotated[float, Field(ge=1e-3, le=86_400, allow_inf_nan=False)]
WholeSeconds = Annotated[int, Field(ge=1, le=86_400)]
Bytes = Annotated[int, Field(ge=1, le=2**30)]
Address = Annotated[str, AfterValidator(_network)]
Origin = Annotated[str, Field(pattern=r"^(\*|https?://[^/\s]+)$")]


class Settings(BaseSettings):
    """Addresses and limits of the service; every one has a default that suits a small machine.

    An empty variable is one that is not set. What a setting means says its description.
    """

    model_config = SettingsConfigDict(
        env_prefix=PREFIX, env_ignore_empty=True, frozen=True, extra="forbid"
    )

    host: str = Field(default="127.0.0.1", description="address that is listened at")
    port: int = Field(default=8000, ge=0, le=65_535, description="its port; 0 for any")
    unix_socket: str = Field(
        default="", description="path of a Unix socket, which is listened at instead"
    )
    workers: int = Field(default=1, ge=1, le=256, description="processes that answer requests")
    root_path: str = Field(
        default="",
        pattern=r"^(/[A-Za-z0-9._~-]+)*$",
        description="path prefix at which a proxy shows the service, such as `/reducers`",
    )
    trusted_proxies: Annotated[tuple[Address, ...], NoDecode, BeforeValidator(_parts)] = Field(
        default=("127.0.0.1", "::1"),
        description="addresses or networks whose `X-Forwarded-For` and `-Proto` are believed, "
        "by commas; over a Unix socket all are",
    )
    max_body_bytes: Bytes = Field(
        default=262_144, description="largest request body; 500 rollers take 60,000"
    )
    max_batch_bytes: Bytes = Field(default=8_388_608, description="largest body of a batch")
    max_pairs: int = Field(
        default=10_000, ge=1, le=10_000, description="most pins times satellites"
    )
    max_curve_samples: int = Field(
        default=10_001, ge=2, le=10_001, description="most crank angles of a curve"
    )
    max_batch: int = Field(
        default=10_000, ge=1, le=10_000, description="most requests in one batch"
    )
    max_seconds: Seconds = Field(
        default=10.0, description="longest calculation, without waiting for a process, s"
    )
    max_study_seconds: Seconds = Field(
        default=60.0, description="longest study that is sent with its progress, s"
    )
    processes: int = Field(
        default=0,
        ge=0,
        le=256,
        description="processes for long calculations, a worker; 0: one a processor",
    )
    max_waiting: int = Field(
        default=64,
        ge=1,
        le=100_000,
        description="long calculations that wait for a process, a worker",
    )
    max_connections: int = Field(
        default=2_000, ge=1, le=1_000_000, description="open connections, a worker"
    )
    receive_seconds: Seconds = Field(
        default=10.0, description="longest time to send a request, or to take more of an answer, s"
    )
    keep_alive_seconds: WholeSeconds = Field(
        default=5, description="how long an idle connection is kept, whole s"
    )
    stop_seconds: WholeSeconds = Field(
        default=30, description="how long a stopping worker waits for answers, whole s"
    )
    cors_origins: Annotated[tuple[Origin, ...], NoDecode, BeforeValidator(_parts)] = Field(
        default=(), description="origins of other sites that may ask, by commas"
    )
    log_level: Annotated[Literal["DEBUG", "INFO", "WARNING", "ERROR"], BeforeValidator(_upper)] = (
        Field(default="INFO", description="`WARNING` leaves out the lines of requests")
    )
    build: str = Field(
        default="", pattern=r"^[A-Za-z0-9._+-]*$", description="which build of a version it is"
    )

    @classmethod
    def from_environment(cls) -> Self:
        """Settings with what the environment overrides.

        Raises
        ------
        ValueError
            If a value cannot be, or there is no such setting: in one line that names it.
        """
        names = {PREFIX + name.upper() for name in cls.model_fields}
        for name in os.environ:
            if name.upper().startswith(PREFIX) and name not in names:
                near = get_close_matches(name.upper(), names, 1)
                raise ValueError(f"{name} is no setting" + (f"; {near[0]} is" if near else ""))
        try:
            return cls()
        except ValidationError as error:
            first = error.errors()[0]
            name = f"{PREFIX}{str(first['loc'][0]).upper()}"
            raise ValueError(f"{name}={os.environ[name]}: {first['msg']}") from None


@cache
def current() -> Settings:
    """The settings of this process, read once."""
    return Settings.from_environment()
