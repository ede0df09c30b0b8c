"""How much work something is, however fast the machine does it."""

import sys
from collections.abc import Callable
from types import FrameType
from typing import Any

import numpy as np


def steps(work: Callable[[], object]) -> int:
    """How many functions are called, Python's and those in C, and how many numbers they return in
    arrays, until it is done or refused.
    """
    counted = 0

    def count(frame: FrameType, event: str, value: Any) -> None:
        nonlocal counted
        counted += event in ("call", "c_call")
        if event == "return":
            for each in value if isinstance(value, tuple) else (value,):
                counted += each.size if isinstance(each, np.ndarray) else 0

    before = sys.getprofile()
    sys.setprofile(count)
    try:
        work()
    finally:
        sys.setprofile(before)
    return counted
