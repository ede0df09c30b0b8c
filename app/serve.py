"""Start the service with the settings of its environment: ``python -m app.serve``."""

import argparse
import os
import tempfile
from contextlib import ExitStack
from typing import Any

import uvicorn

from app.settings import Settings


def log_config(level: str) -> dict[str, Any]:
    """Configuration of `logging`: everything as JSON lines on the standard output."""
    return {
        "version": 1,
        "disable_existing_loggers": False,
        "formatters": {"json": {"()": "app.observability.JsonLines"}},
        "handlers": {
            "out": {
                "class": "logging.StreamHandler",
                "formatter": "json",
                "stream": "ext://sys.stdout",
            }
        },
        "root": {"handlers": ["out"], "level": level},
    }


def main() -> None:
    """Serve until stopped; requests in flight are answered first."""
    parser = argparse.ArgumentParser(prog="python -m app.serve", description=__doc__)
    parser.add_argument("--host", default="127.0.0.1")
    parser.add_argument("--port", type=int, default=8000)
    parser.add_argument("--workers", type=int, default=1)
    options = parser.parse_args()
    settings = Settings.from_environment()
    with ExitStack() as stack:
        if options.workers > 1 and "PROMETHEUS_MULTIPROC_DIR" not in os.environ:
            shared = stack.enter_context(tempfile.TemporaryDirectory(prefix="khv-metrics-"))
            os.environ["PROMETHEUS_MULTIPROC_DIR"] = shared
        uvicorn.run(
            "app.main:app",
            host=options.host,
            port=options.port,
            workers=options.workers,
            http="app.protocol:PatientProtocol",
            ws="none",
            log_config=log_config(settings.log_level),
            access_log=False,
            server_header=False,
            timeout_keep_alive=settings.keep_alive_seconds,
            timeout_graceful_shutdown=settings.stop_seconds,
        )


if __name__ == "__main__":
    main()
