"""Space for the metrics that workers share, allocated in advance; see `app.observability`.

prometheus-client writes into memory-mapped files. A full file system would kill the worker;
therefore each file gets its whole size here, or the worker keeps its metrics to itself.
"""

import os
from pathlib import Path

DIRECTORY = "PROMETHEUS_MULTIPROC_DIR"

SIZES = {"counter": 1 << 18, "histogram": 1 << 18, "gauge_livesum": 1 << 12, "gauge_max": 1 << 12}
"""File sizes above those of a worker's metrics, by the names that prometheus-client gives to
files."""


def reserve() -> None:
    """Allocate the files of this process, or stop sharing metrics."""
    if DIRECTORY not in os.environ:
        return
    files = {Path(os.environ[DIRECTORY], f"{kind}_{os.getpid()}.db"): SIZES[kind] for kind in SIZES}
    try:
        for file, size in files.items():
            with file.open("wb") as opened:
                os.posix_fallocate(opened.fileno(), 0, size)
    except OSError:
        for file in files:
            file.unlink(missing_ok=True)
        del os.environ[DIRECTORY]


reserve()
