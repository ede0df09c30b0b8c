"""The engine of a drive as its source is, beside the one that is compiled."""

import importlib.util
import math
from collections.abc import Callable
from types import ModuleType

import numpy as np

from core.drive import engine
from core.numerics.extremes import Narrow


def _loaded() -> ModuleType:
    spec = importlib.util.spec_from_file_location("plain_engine", engine.__file__)
    assert spec and spec.loader
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


plain, searching = _loaded(), _loaded()


def narrowing(
    value: Callable[[float], float], known: float = -math.inf, at: float = math.nan
) -> Narrow:
    """The engine's search for the largest value, of any function of the place."""
    row, there = np.zeros(engine.INTERFERENCE + 1), [0.0]

    def place(where: float, *_: object) -> None:
        there[0] = float(where)

    def placed(*_: object) -> None:
        row[engine.PLAY] = value(there[0])

    def narrow(places: np.ndarray, heights: np.ndarray) -> tuple[float, float, float]:
        vars(searching).update(place=place, placed=placed, straighten=lambda work: None)
        given = searching.PLAY, 1, places, heights, known, at, 1.0, 1.0, None, None, row
        *found, narrow.looks = searching.narrow(*given)  # type: ignore[attr-defined]
        return tuple(found)

    return narrow
