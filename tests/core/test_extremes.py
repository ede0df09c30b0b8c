"""A second look for what is largest: places of its own, and summits that a first one missed."""

import math

import numpy as np
import pytest

from core.numerics.extremes import other_places, second_look, zoom
from tests.inputs.plain_engine import narrowing


def spike(place: float) -> float:
    """Waves, and a spike at 1.3 that is narrower than their distance."""
    return math.cos(11 * place) / 100 + max(1 - 40 * abs(place - 1.3), 0.9 * math.cos(place))


def test_the_places_are_those_of_no_even_grid() -> None:
    for count in (97, 461):
        found = other_places(count=count, first=0.3)
        for other in (count, 2 * count, 720, 1440):
            off = (found - 0.3) / (2 * math.pi) * other
            assert np.abs(off - off.round()).min() > 1e-5


def test_a_summit_that_the_first_look_missed_is_found() -> None:
    places = other_places(count=461)
    heights = np.array([*map(spike, places)])
    place, height, _ = second_look(
        places=places, heights=heights, known=0.93, narrow=narrowing(spike)
    )
    assert height == pytest.approx(max(spike(1.3 + x) for x in np.linspace(-0.01, 0.01, 4001)))
    assert place == pytest.approx(1.3, abs=1e-3)


def test_nothing_higher_is_the_first_looks_value() -> None:
    places = other_places(count=461)
    heights = np.array([*map(spike, places)])
    place, height, error = second_look(
        places=places, heights=heights, known=2.0, narrow=narrowing(spike)
    )
    assert math.isnan(place) and (height, error) == (2.0, 0.0)


def test_of_what_is_alike_everywhere_nothing_is_narrowed() -> None:
    places = other_places(count=97)
    found = second_look(places=places, heights=np.ones(97), known=1.0, narrow=narrowing(spike))
    assert found[1] == 1.0


@pytest.mark.parametrize("width", [1e-4, 1e-2, 0.5])
def test_a_spike_about_a_sample_is_found_at_its_tip(width: float) -> None:
    def narrow_spike(places: np.ndarray) -> np.ndarray:
        return np.maximum(1 - np.abs(places - 1.3) / width, np.cos(places) / 10)

    places, heights, errors = zoom(
        values=narrow_spike, places=np.array([0.0, 1.3 - width / 3]), width=width
    )
    assert heights[1] == pytest.approx(1.0, abs=1e-7) and abs(places[1] - 1.3) < 1e-7 * width
    assert 1 - heights[1] <= errors[1] < 1e-6 and errors[0] < 1e-12
    assert heights[0] == pytest.approx(0.1)


def test_nothing_is_looked_at_beyond_the_ends() -> None:
    seen: list[float] = []

    def rising(places: np.ndarray) -> np.ndarray:
        seen.extend(places.tolist())
        return places

    place, height, _ = zoom(values=rising, places=np.array([0.9]), width=0.5, low=0.5, high=1.0)
    assert place[0] == height[0] == max(seen) == 1.0 and min(seen) >= 0.5
