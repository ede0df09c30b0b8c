"""Jobs for the tests of what runs in processes: each is found by its name there."""

import os
import signal
import time
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any
from unittest.mock import patch

from app import batch, endpoint, processes
from app.batch import lines
from app.calculations.hertz import HertzRequest
from app.model import StudyCalculation, Values
from app.processes import Tell
from app.registry import CALCULATIONS

LET = ".let"
"""How the file of a gate is called whose size is how many may pass."""


def counts(tell, last):
    for number in range(last):
        tell(number)


def starts_another(tell):
    """Tell the number of a process that does not end by itself, and wait for it."""
    if (other := os.fork()) == 0:
        time.sleep(600)
        os._exit(0)
    tell(other)
    os.waitpid(other, 0)


def wait_at(gate: Path) -> None:
    """Until as many may pass a gate as have come to it: `tests.app.conftest.Gate`."""
    with gate.open("a") as came:
        came.write("|")
        came.flush()
        place = came.tell()
    let = gate.with_suffix(LET)
    while not let.exists() or let.stat().st_size < place:
        time.sleep(0.01)


def held(gate: Path, tell, job=None, *asked):
    """Another job, or the number of this process, once a test lets it pass."""
    wait_at(gate)
    if job is None:
        tell(os.getpid())
    else:
        job(tell, *asked)


def told_when_let(gate: Path, *asked: Any) -> None:
    """Job of the service in a process that ends once a test lets it pass."""
    wait_at(gate)
    processes.told(*asked)


def told_half_way(gate: Path, *asked: Any) -> None:
    """Study that reports half of its work before it waits for the test."""
    study = CALCULATIONS["tolerance-study"]

    def half(body: Any, report: Callable[[float], None]) -> Values:
        report(0.5)
        wait_at(gate)
        assert isinstance(study, StudyCalculation)
        return study.reporting(body, lambda share: None)

    with (
        patch.dict(CALCULATIONS, {study.name: replace(study, reporting=half)}),
        patch.object(endpoint, "PROGRESS_S", -1.0),
    ):
        processes.told(*asked)


def pid_of(tell):
    tell(os.getpid())


def tells_then_blocks(tell, count):
    """For ever."""
    counts(tell, count)
    signal.pause()


def tells_then_dies(tell, count):
    counts(tell, count)
    os.kill(os.getpid(), signal.SIGKILL)
    tell("alive")


def large(tell, size):
    tell(bytes(size))


def length(tell, content):
    tell(len(content))


def noted(file: Path, body: HertzRequest) -> Values:
    """Notes each evaluation; a force of 13 N kills."""
    with file.open("a") as notes:
        notes.write(f"{body.force_N:g}\n")
    if body.force_N == 13:
        os.kill(os.getpid(), signal.SIGKILL)
    return {"force_N": body.force_N}


def endless(file: Path, body: HertzRequest) -> Values:
    """Job that ends once a test lets it pass, but never for a force of 666 N."""
    values = noted(file, body)
    if body.force_N == 666:
        signal.pause()
    return values


def lines_of(tell: Tell, *asked: Any, solve: Callable[[HertzRequest], Values]) -> None:
    """The job of a batch of one of these; the time of a slice is over after each."""
    stand_in = replace(CALCULATIONS["hertz"], solve=solve)
    with patch.dict(CALCULATIONS, hertz=stand_in), patch.object(batch, "SLICE_S", -1.0):
        lines(tell, *asked, name="hertz")
