"""Summits of a grid: which of them are narrowed for the highest one."""

import math
import random
from collections.abc import Callable

import numpy as np
import pytest

from core.drive.engine import FLAT, MET
from core.output.summits import Grid, highest, summits
from tests.inputs.plain_engine import narrowing


def wave(place):
    """Waves of nearly the same height: the highest of them is at 0.1."""
    return math.cos(11 * (place - 0.1)) + 2e-4 * math.cos(place - 0.1)


@pytest.mark.parametrize("turned", np.linspace(0, 2 * math.pi / 90, 9).tolist())
def test_the_highest_is_found_however_low_it_is_on_the_grid(turned):
    places = turned + np.arange(180) * (2 * math.pi / 180)
    heights = np.array([*map(wave, places)])
    coarse = Grid(places[::2], heights[::2])
    (top, *_), _ = highest(coarse=coarse, fine=Grid(places, heights), narrow=narrowing(wave))
    assert top.place % (2 * math.pi) == pytest.approx(0.1, abs=1e-6)
    assert top.height == pytest.approx(1 + 2e-4, abs=1e-12)


def test_a_rising_plateau_beside_a_jump_narrower_than_the_places() -> None:
    """The lost motion of nearly pressed pins: a search that leaves the best place runs off it."""

    def value(x: float) -> float:
        off = math.remainder(x - 2.0, 2 * math.pi)
        return 1 + off if -0.004 <= off <= 0.0025 else 0.01 * math.cos(x)

    for start in (0.0, 0.001, 0.003, 0.0045):
        places = start + np.arange(720) * (2 * math.pi / 720)
        grid = Grid(places, np.array([*map(value, places)]))
        if grid.heights.max() < 0.5:  # no place on it
            continue
        found = max(summits(grid=grid, narrow=narrowing(value)), key=lambda each: each.height)
        assert found.height == pytest.approx(1.0025, abs=1e-9)


@pytest.mark.parametrize("seed", range(40))
def test_a_kink_between_bent_sides_is_found_in_few_looks(seed: int) -> None:
    """The tip of both is known; a smooth summit with a third-order part is found sooner."""
    draw = random.Random(seed)
    tip, up, down = draw.uniform(-0.5, 0.5), draw.uniform(0.01, 3), draw.uniform(0.01, 3)
    bends = draw.uniform(-2, 2), draw.uniform(-2, 2)
    skew = draw.uniform(-3, 3)

    def kinked(x: float) -> float:
        off = (x - tip) / 100
        return 5 + (up if off < 0 else -down) * off + bends[int(off > 0)] * off**2

    def smooth(x: float) -> float:
        return 5 + up * (-(((x - tip) / 100) ** 2) + skew * ((x - tip) / 100) ** 3)

    def parabola(x: float) -> float:
        return 5 - up * ((x - tip) / 100) ** 2

    for value, near in ((kinked, 22), (smooth, 12), (parabola, 6)):
        places = np.arange(-2.0, 3.0)
        narrow = narrowing(value)
        place, height, error = narrow(places, np.array([*map(value, places)]))
        assert 0 <= 5.0 - height <= 2 * FLAT * height and error <= FLAT * height
        assert place == pytest.approx(tip, abs=1e-2)
        assert narrow.looks <= near


def test_a_search_ends_at_a_known_summit_unless_it_is_higher_there() -> None:
    def tip(x: float) -> float:
        return 5 - abs(x - 0.3) - (x - 0.3) ** 2

    def searched(known: float) -> tuple[float, int]:
        places = np.arange(-2.0, 3.0) / 10 + 0.33
        narrow = narrowing(tip, known, 0.3)
        _, height, _ = narrow(places, np.array([*map(tip, places)]))
        return height, narrow.looks

    height, looks = searched(-math.inf)
    assert height == pytest.approx(5, rel=FLAT)
    assert searched(4.99) == (height, looks)
    met, few = searched(5.0)
    assert 5 - MET <= met <= 5 and few < looks


@pytest.mark.parametrize("value", [lambda x: math.nan, lambda x: math.sin(1e9 * x)])
def test_a_search_ends_whatever_the_function_is(value: Callable[[float], float]) -> None:
    narrow = narrowing(value)
    narrow(np.arange(-2.0, 3.0), np.array([0.0, 0.0, 1.0, 0.0, 0.0]))
    assert narrow.looks <= 200
