"""Jobs for the tests of what runs in processes: each is found by its name there."""

import os
import signal
import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

from app.batch import lines
from app.calculations.hertz import HertzRequest
from app.model import Values
from app.registry import CALCULATIONS


def counts(last):
    yield from range(last)


def sleeps_after(file: Path, seconds):
    """From when a file is there."""
    while not file.exists():
        time.sleep(0.01)
    time.sleep(seconds)
    yield None


def sleeps(seconds):
    time.sleep(seconds)
    yield os.getpid()


def yields_then_sleeps(count, seconds):
    yield from range(count)
    time.sleep(seconds)
    yield "awake"


def yields_then_dies(count):
    yield from range(count)
    os.kill(os.getpid(), signal.SIGKILL)
    yield "alive"


def large(size):
    yield bytes(size)


def length(content):
    yield len(content)


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


def lines_of(solve: Callable[[HertzRequest], Values], *asked: Any) -> Iterator[tuple[bytes, int]]:
    """The job of a batch of one of these."""
    return lines(replace(CALCULATIONS["hertz"], solve=solve), *asked)
