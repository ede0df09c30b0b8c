"""Start the service with the settings of its environment: ``python -m app.serve``."""

import argparse
import logging
import logging.config
import os
import platform
import resource
import socket
import stat
import sys
import tempfile
from contextlib import ExitStack
from typing import Any

import uvicorn

from app import VERSION
from app.settings import OVER_UNIX, PREFIX, Settings

OPTIONS = ("host", "port", "workers", "unix_socket", "root_path")
"""Settings that may be given on the command line too."""

OTHER_FILES = 200
"""Number of descriptors of a worker besides connections: modules, logs, processes, pages being
sent."""

WORKER_ANSWERS_S = 30
"""Time in which a worker must answer its parent, s, or be replaced; on a busy machine it includes
the start, which would otherwise begin again and again."""

LOG = logging.getLogger("khv.serve")


def log_config(level: str) -> dict[str, Any]:
    """Configuration of `logging`: everything as JSON lines on the standard output."""
    return {
        "version": 1,
        "disable_existing_loggers": False,
        "formatters": {"json": {"()": "app.observability.JsonLines"}},
        "handlers": {"out": {"()": "app.observability.Output", "formatter": "json"}},
        "root": {"handlers": ["out"], "level": level},
    }


def connections_within(most: int) -> int:
    """Number of connections within a worker's limit of descriptors, raised as far as possible.

    Raises ValueError if the limit leaves none.
    """
    soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
    needed = most + OTHER_FILES
    if hard != resource.RLIM_INFINITY:
        needed = min(needed, hard)
    if soft != resource.RLIM_INFINITY and soft < needed:
        resource.setrlimit(resource.RLIMIT_NOFILE, (needed, hard))
    if needed <= OTHER_FILES:
        raise ValueError(
            f"the limit of descriptors is {needed}: more than {OTHER_FILES} are needed"
        )
    return min(most, needed - OTHER_FILES)


def open_standard_files() -> None:
    """Open descriptors 0 to 2, so that no socket takes their numbers and receives the log."""
    while (descriptor := os.open(os.devnull, os.O_RDWR)) < 3:
        os.set_inheritable(descriptor, True)
    os.close(descriptor)


def refuse_taken(path: str) -> None:
    """Raise ValueError if a path is no socket or a socket in use; remove an abandoned socket."""
    if not os.path.lexists(path):
        return
    if not stat.S_ISSOCK(os.lstat(path).st_mode):
        raise ValueError(f"{PREFIX}UNIX_SOCKET: {path} is there, and no socket")
    with socket.socket(socket.AF_UNIX) as asking:
        asking.setblocking(False)  # a full queue means that someone listens
        try:
            asking.connect(path)
        except ConnectionRefusedError:
            os.unlink(path)
            return
        except OSError:
            pass
    raise ValueError(f"{PREFIX}UNIX_SOCKET: somebody listens at {path}")


def refuse_address(name: str, family: socket.AddressFamily, address: Any) -> None:
    """Raise ValueError, naming the setting, if nothing can listen at an address."""
    try:
        with socket.socket(family) as trying:
            trying.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            trying.bind(address)
    except (OSError, UnicodeError) as error:
        raise ValueError(f"{PREFIX}{name}: nothing can listen at {address}: {error}") from None


def main() -> None:
    """Serve until stopped; requests in flight are answered first."""
    open_standard_files()
    parser = argparse.ArgumentParser(prog="python -m app.serve", description=__doc__)
    for name in OPTIONS:
        described = Settings.model_fields[name].description
        parser.add_argument(f"--{name.replace('_', '-')}", help=described, default="")
    for name, text in vars(parser.parse_args()).items():
        if text:
            os.environ[PREFIX + name.upper()] = text  # for the workers too
    try:
        settings = Settings.from_environment()
        if settings.unix_socket:
            refuse_taken(settings.unix_socket)
            refuse_address("UNIX_SOCKET", socket.AF_UNIX, settings.unix_socket)
            os.unlink(settings.unix_socket)
        else:
            of = socket.AF_INET6 if ":" in settings.host else socket.AF_INET
            refuse_address("HOST, KHV_PORT", of, (settings.host, settings.port))
        connections = connections_within(settings.max_connections)
    except ValueError as error:
        sys.exit(str(error))
    os.environ[f"{PREFIX}MAX_CONNECTIONS"] = str(connections)  # for the workers too
    logging.config.dictConfig(log_config(settings.log_level))
    if connections < settings.max_connections:
        LOG.warning("the limit of descriptors leaves room for %d connections", connections)
        settings = Settings.from_environment()
    started = {"version": VERSION, "python": platform.python_version(), **settings.model_dump()}
    LOG.info({"message": "settings", **started})
    with ExitStack() as stack:
        if settings.workers > 1 and "PROMETHEUS_MULTIPROC_DIR" not in os.environ:
            try:
                shared = stack.enter_context(tempfile.TemporaryDirectory(prefix="khv-metrics-"))
                os.environ["PROMETHEUS_MULTIPROC_DIR"] = shared
            except OSError as error:
                LOG.warning("metrics are those of single workers: %s", error)
        uvicorn.run(
            "app.main:app",
            host=settings.host,
            port=settings.port,
            uds=settings.unix_socket or None,
            workers=settings.workers,
            http="app.protocol:PatientProtocol",
            ws="none",
            log_config=log_config(settings.log_level),
            access_log=False,
            server_header=False,
            forwarded_allow_ips=[*settings.trusted_proxies, OVER_UNIX],
            timeout_worker_healthcheck=WORKER_ANSWERS_S,
            timeout_keep_alive=settings.keep_alive_seconds,
            timeout_graceful_shutdown=settings.stop_seconds,
        )


if __name__ == "__main__":
    main()
