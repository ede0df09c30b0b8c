"""Jobs for the tests of what runs in processes: each is found by its name there."""

import os
import signal
import time
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any
from unittest.mock import patch

from app.batch import lines
from app.calculations.hertz import HertzRequest
from app.model import Values
from app.processes import Tell
from app.registry import CALCULATIONS


def counts(tell, last):
    for number in range(last):
        tell(number)


def sleeps_after(tell, file: Path, seconds):
    """From when a file is there."""
    while not file.exists():
        time.sleep(0.01)
    time.sleep(seconds)
    tell(None)


def sleeps(tell, seconds):
    time.sleep(seconds)
    tell(os.getpid())


def tells_then_sleeps(tell, count, seconds):
    counts(tell, count)
    time.sleep(seconds)
    tell("awake")


def tells_then_dies(tell, count):
    counts(tell, count)
    os.kill(os.getpid(), signal.SIGKILL)
    tell("alive")


def large(tell, size):
    tell(bytes(size))


def length(tell, content):
    tell(len(content))


def noted(file: Path, body: HertzRequest) -> Values:
    """Notes each evaluation; a force below 1 N is its time in seconds, 13 N kills."""
    with file.open("a") as notes:
        notes.write(f"{body.force_N:g}\n")
    if body.force_N < 1:
        time.sleep(body.force_N)
    if body.force_N == 13:
        os.kill(os.getpid(), signal.SIGKILL)
    return {"force_N": body.force_N}


def endless(file: Path, body: HertzRequest) -> Values:
    """The same, but a force of 666 N takes for ever."""
    values = noted(file, body)
    if body.force_N == 666:
        time.sleep(3600)
    return values


def lines_of(tell: Tell, *asked: Any, solve: Callable[[HertzRequest], Values]) -> None:
    """The job of a batch of one of these."""
    with patch.dict(CALCULATIONS, hertz=replace(CALCULATIONS["hertz"], solve=solve)):
        lines(tell, *asked, name="hertz")
