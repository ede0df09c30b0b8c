"""Summits of a grid: which of them are narrowed for the highest one."""

import math

import numpy as np
import pytest

from core.output.summits import Grid, highest, summits


def wave(place):
    """Waves of nearly the same height: the highest of them is at 0.1."""
    return math.cos(11 * (place - 0.1)) + 2e-4 * math.cos(place - 0.1)


def golden(low, high):
    """The largest value between two places, by thirds."""
    while high - low > 1e-9:
        third = (high - low) / 3
        if wave(low + third) < wave(high - third):
            low += third
        else:
            high -= third
    return (low + high) / 2, wave((low + high) / 2), 0.0


@pytest.mark.parametrize("turned", np.linspace(0, 2 * math.pi / 90, 9).tolist())
def test_the_highest_is_found_however_low_it_is_on_the_grid(turned):
    places = turned + np.arange(180) * (2 * math.pi / 180)
    heights = np.array([*map(wave, places)])
    coarse = Grid(places[::2], heights[::2])
    top, _ = highest(coarse=coarse, fine=Grid(places, heights), narrow=golden)
    assert top.place % (2 * math.pi) == pytest.approx(0.1, abs=1e-6)
    assert top.height == pytest.approx(1 + 2e-4, abs=1e-12)


def test_a_rising_plateau_beside_a_jump_narrower_than_the_places() -> None:
    """The lost motion of nearly pressed pins: golden section alone runs off the plateau."""

    def value(x: float) -> float:
        off = math.remainder(x - 2.0, 2 * math.pi)
        return 1 + off if -0.004 <= off <= 0.0025 else 0.01 * math.cos(x)

    def narrow(low: float, high: float) -> tuple[float, float, float]:
        golden = (math.sqrt(5) - 1) / 2
        while high - low > 1e-11:
            a, b = high - golden * (high - low), low + golden * (high - low)
            low, high = (low, b) if value(a) >= value(b) else (a, high)
        return low, value(low), 0.0

    for start in (0.0, 0.001, 0.003, 0.0045):
        places = start + np.arange(720) * (2 * math.pi / 720)
        grid = Grid(places, np.array([*map(value, places)]))
        if grid.heights.max() < 0.5:  # no place on it
            continue
        found = max(summits(grid=grid, narrow=narrow), key=lambda each: each.height)
        assert found.height == pytest.approx(1.0025, abs=1e-9)
