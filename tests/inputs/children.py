"""Processes that tests start: each heads a group of its own, which ends with who started it."""

import os
import signal
import subprocess
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from typing import Any

LONGEST_S = 600
"""How long a command may take that comes to its end by itself: as long as a test (pyproject.toml),
many times what it takes on a busy machine.
"""


def start(*command: Any, text: bool = True, **options: Any) -> subprocess.Popen[Any]:
    """A process that `end` has to end."""
    return subprocess.Popen(command, text=text, process_group=0, **options)


def end(process: subprocess.Popen[Any]) -> None:
    """Kill a process and all that it has started."""
    with suppress(ProcessLookupError):
        os.killpg(process.pid, signal.SIGKILL)
    process.wait()


@contextmanager
def started(*command: Any, **options: Any) -> Iterator[subprocess.Popen[Any]]:
    """A process that is ended behind it, with all that it has started."""
    with start(*command, **options) as process:
        try:
            yield process
        finally:
            end(process)


def ran(*command: Any, check: bool = True, **options: Any) -> subprocess.CompletedProcess[Any]:
    """A command that has come to its end, and what it said; without an error, where that is asked.

    Raises
    ------
    subprocess.TimeoutExpired
        If it does not end.
    """
    pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE}
    with started(*command, **(pipes | options)) as process:
        said = process.communicate(timeout=LONGEST_S)
    assert not (check and process.returncode), said
    return subprocess.CompletedProcess(command, process.returncode, *said)


def end_those_of(worker: str, run: str) -> None:
    """Kill all that the tests of one of xdist's workers have left, which has gone itself."""
    marks = {f"PYTEST_XDIST_WORKER={worker}".encode(), f"PYTEST_XDIST_TESTRUNUID={run}".encode()}
    for pid in filter(str.isdigit, os.listdir("/proc")):
        with suppress(OSError), open(f"/proc/{pid}/environ", "rb") as environment:
            if marks <= {*environment.read().split(b"\0")}:
                os.kill(int(pid), signal.SIGKILL)
