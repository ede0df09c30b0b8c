"""Summits of a grid: which of them are narrowed for the highest one."""

import math

import numpy as np
import pytest

from core.output.summits import Grid, highest


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
