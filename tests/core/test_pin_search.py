"""The search for the largest value, on functions whose largest value is known."""

import math
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from core.arrays import FloatArray
from core.output.mechanism import Mechanism
from core.output.pin_search import (
    Points,
    _apart,
    _vertex,
    climbed,
    first_of,
    highest,
    summits,
)
from core.output.pin_turn import PinTurn

TURN = PinTurn(Mechanism.evenly_spaced(pins=3, satellites=1, ratio=20.0), 1.0)
NODES, GAPS = TURN.nodes, TURN.gaps
MIDDLE = (NODES - 0.5) ** 2
END = NODES[1]
BESIDE = MIDDLE[len(NODES) // 2 + 1 : len(NODES) // 2 + 3]
STEEPER = 0.8 / (BESIDE[1] - 1.8 * BESIDE[0])  # 1.8 times from one sample to the next


@pytest.mark.parametrize(
    ("values", "left"),
    [
        pytest.param(7 - MIDDLE, [], id="even hill"),
        pytest.param(7 - MIDDLE + 1e-12 * NODES, [0.5], id="tilted"),
        pytest.param(7 - MIDDLE - STEEPER * MIDDLE**2, [0.5], id="falls faster than a parabola"),
        pytest.param(7 + MIDDLE * (0.01 - MIDDLE), [0.5], id="two summits between samples"),
        pytest.param(7 - MIDDLE + 4e-15 * np.sin(97 * NODES), [], id="uneven by rounding"),
        pytest.param(7 - NODES, [], id="falls from its end"),
        pytest.param(7 + NODES, [], id="rises to its end"),
        pytest.param(7 - (NODES - END / 8) ** 2, [0.0], id="summit beside an end"),
        pytest.param(7 - (1 - NODES - END / 8) ** 2, [1.0], id="summit beside the other"),
        pytest.param(7 + 0 * NODES, [], id="flat"),
        pytest.param(7 - (NODES - NODES[10]) ** 2, [NODES[10]], id="summit on a sample"),
    ],
)
def test_summits_that_stand_on_no_sample(values: FloatArray, left: list[float]) -> None:
    most, found = _summits_left(values, smooth=True)
    assert most == values.max()
    assert found == left


def test_summits_that_others_may_fall_below_are_kept() -> None:
    """Of two hills the lower one, where it may rise as something else moves; of samples alike but
    for rounding one.
    """
    lower = -np.minimum((NODES - NODES[6]) ** 2, 0.001 + (NODES - NODES[-7]) ** 2)
    turn, row = _turn(7 + lower), np.ones((1, 1))
    drop = 1e-3 + 0.02  # and half of what it falls to its neighbours

    def places(**given: float) -> list[float]:
        _, found = summits(turn=turn, arms=(row,), measure=lambda x: x, **given)
        assert (found.height <= 7 + drop).all()
        return found.place.tolist()

    assert NODES[6] in places()
    assert places(lower=np.inf) == [NODES[6], NODES[-7]]
    flat = _turn(7 + 4e-15 * np.sin(97 * NODES))
    _, found = summits(turn=flat, arms=(row,), measure=lambda x: x, lower=np.inf)
    assert len(found.place) == 1


def test_points_of_other_stretches_are_no_neighbours() -> None:
    """A summit beyond an end of a stretch is followed on the next one alone."""
    x, low, high = np.array([[0.9, 0.8, 1.0, 1.0], [0, 0, 0, 1], [1, 1, 1, 2]])
    points = Points(x, np.zeros(4), np.full(4, 0.1), 0.0, low, high)
    assert _apart(points).tolist() == [0, 3]


def test_ends_of_arcs_without_a_slope_are_looked_at_closely() -> None:
    assert _summits_left(7 - NODES, smooth=False)[1] == [0.0]
    assert _summits_left(7 + NODES, smooth=False)[1] == [1.0]


def _turn(values: FloatArray, smooth: bool = True) -> Any:
    """One arc with these samples."""
    return SimpleNamespace(
        forces=values[None, None], nodes=NODES, gaps=GAPS, arcs=np.zeros(1, int), smooth=smooth
    )


def _summits_left(values: FloatArray, smooth: bool) -> tuple[float, list[float]]:
    """Largest sample of one arc, and where summits are that the samples alone do not tell."""
    turn = _turn(values, smooth)
    most, found = summits(turn=turn, arms=(np.ones((1, 1)),), measure=lambda x: x, known=False)
    return float(most[0]), found.place.tolist()


@pytest.mark.parametrize(
    ("enough", "looks", "most"),
    [
        pytest.param(1e-3, 2, 3 * 3, id="2.9 times as close about three points at most"),
        pytest.param(1e-5, 2, 3 * 31, id="29.3 times"),
        pytest.param(1e-7, 3, 320, id="as close as the number of points allows"),
    ],
)
def test_directions_are_looked_at_no_closer_than_they_have_to_be(
    enough: float, looks: int, most: int
) -> None:
    """Of ``cos(chi - 0.1)`` the room about points at an angle a is ``1/cos(a/2) - 1`` of it."""
    looked: list[int] = []

    def value(at: Points, _: int) -> tuple[FloatArray, FloatArray, FloatArray]:
        looked.append(len(at.section))
        values = 5 * np.cos(at.direction - 0.1)
        room = values * (1 / np.cos(at.angle / 2) - 1)
        return values, room, room

    def climb(points: Points) -> Points:
        return points

    found = highest(
        value=value, stretches=np.zeros((2, 1)), around=True, enough=enough, climb=climb, size=1,
        closed=True,
    )  # fmt: skip
    assert found is not None
    assert looked[0] == 24
    assert len(looked) == looks and sum(looked[1:]) <= most
    assert 1 / math.cos(found.angle / 2) - 1 <= enough
    assert abs(found.direction[0] - 0.1) <= found.angle / 2 * (1 + 1e-9)


def test_what_is_left_are_points_that_are_no_neighbours() -> None:
    """Of a hill with two summits alike on a stretch, and directions, one point each; none beyond
    the ends of the stretch.
    """

    def value(at: Points, _: int) -> tuple[FloatArray, FloatArray, FloatArray]:
        assert (at.section >= 0).all() and (at.section <= 1).all()
        values = 5 + np.cos(at.direction) - 4 * (np.abs(at.section - 0.5) - 0.4) ** 2
        room = 4 * at.length**2 / 4 + at.angle**2 / 8
        return values, room, room

    found = highest(
        value=value, stretches=np.array([[0.0], [1.0]]), around=True, enough=1e-5,
        climb=lambda points: points, size=1, closed=True,
    )  # fmt: skip
    assert found is not None
    assert sorted(found.section) == pytest.approx([0.1, 0.9], abs=1e-3)
    assert np.cos(found.direction) == pytest.approx([1, 1], abs=1e-4)


def test_climbed_finds_the_top_of_a_stretch() -> None:
    """Within, at either end, on a section alone, far beyond the first step."""
    tops = np.array([0.3, -1.0, 2.0, 0.3, 0.9])
    low, high = np.array([0.0, 0, 0, 0.5, 0]), np.array([1.0, 1, 1, 0.5, 1])
    length = np.array([0.2, 0.2, 0.2, 0.0, 0.01])
    start = Points(np.full(5, 0.5), np.zeros(5), length, 0.0, low, high)

    def hill(x: FloatArray) -> tuple[FloatArray, NDArray[np.bool_]]:
        away = x - tops[:, None]
        return 7 - away**2 + away**3 / 20, np.full(5, True)

    rounds = []
    x, _ = climbed(value=lambda x, _: (rounds.append(x), hill(x))[1], points=start)
    assert x[1:4] == pytest.approx([0, 1, 0.5], abs=0)
    assert x[[0, 4]] == pytest.approx(tops[[0, 4]], abs=1e-7)
    assert len(rounds) <= 14


def test_climbed_finds_the_top_over_sections_and_directions() -> None:
    """A ridge across both: its top within, beyond an end of the stretch, far off, on a section
    alone, from a saddle's flank where the first steps cannot be known.
    """
    tops = np.array([[0.3, 1.0], [-0.5, 1.0], [0.9, 3.0], [0.3, 1.0], [0.3, 1.0]])
    low, high = np.zeros(5), np.ones(5)
    low[3] = high[3] = 0.5
    section, length = np.array([0.4, 0.4, 0.4, 0.5, 0.95]), np.array([0.2, 0.2, 0.2, 0.0, 0.01])
    start = Points(section, np.full(5, 1.2), length, 0.1, low, high)
    rounds = []

    def ridge(x: FloatArray, chi: FloatArray) -> tuple[FloatArray, NDArray[np.bool_]]:
        rounds.append(x)
        a, b = x - tops[:, :1], chi - tops[:, 1:]
        return 7 / (1 + a**2 + 1.5 * a * b + b**2), np.full(5, True)

    x, chi = climbed(value=ridge, points=start)
    assert x[[0, 2, 4]] == pytest.approx([0.3, 0.9, 0.3], abs=1e-7)
    assert x[[1, 3]] == pytest.approx([0, 0.5], abs=0)
    # where the section is held, the direction goes to the top across it
    assert chi == pytest.approx([1, 1 - 0.75 * 0.5, 3, 1 - 0.75 * 0.2, 1], abs=1e-7)
    assert 4 <= len(rounds) <= 22


def test_climbed_goes_on_where_values_are_not_as_good_as_they_get() -> None:
    """Rows that are not settled are looked at again at the top, those far below are let go."""
    start = Points(np.array([0.5, 0.5]), np.zeros(2), np.full(2, 0.1), 0.0, np.zeros(2), np.ones(2))
    rounds = []

    def hills(x: FloatArray, _: FloatArray) -> tuple[FloatArray, NDArray[np.bool_]]:
        rounds.append(x)
        return np.array([[7.0], [1.0]]) - (x - 0.5) ** 2, np.array([len(rounds) > 4, True])

    x, _ = climbed(value=hills, points=start)
    assert x.tolist() == [0.5, 0.5]
    assert len(rounds) == 5


def test_climbed_ends_where_nothing_rises_from_what_is_near() -> None:
    start = Points(np.array([0.5]), np.zeros(1), np.full(1, 0.1), 0.0, np.zeros(1), np.ones(1))
    rounds = []

    def plain(x: FloatArray, _: FloatArray) -> tuple[FloatArray, NDArray[np.bool_]]:
        rounds.append(x)
        return np.full(x.shape, 7.0), np.full(1, False)

    climbed(value=plain, points=start)
    assert len(rounds) == 1


def test_climbed_looks_closer_where_its_steps_are_longer_than_a_ridge_is_wide() -> None:
    start = Points(
        np.array([0.53]), np.array([1.03]), np.array([0.2]), 0.2, np.zeros(1), np.ones(1)
    )

    def narrow(x: FloatArray, chi: FloatArray) -> tuple[FloatArray, NDArray[np.bool_]]:
        a, b = x - 0.5, chi - 1
        return 7 / (1 + 100 * (a - b) ** 2 + 0.1 * (a + b) ** 2), np.full(1, True)

    x, chi = climbed(value=narrow, points=start)
    assert [x[0], chi[0]] == pytest.approx([0.5, 1.0], abs=1e-7)


def test_of_values_alike_but_for_rounding_the_first_section_counts() -> None:
    values = np.array([3.0, 4.0, 4.0 * (1 - 5e-15), 4.0 * (1 - 15e-15)])
    assert first_of(values=values, section=np.array([0.1, 0.4, 0.3, 0.2])) == 2
    assert first_of(values=values, section=np.array([0.1, 0.3, 0.4, 0.2])) == 1


def test_a_parabola_through_places_that_coincide_has_its_value_there() -> None:
    """Where the same place was calculated twice, with other rounding."""
    places = np.array([[1.0], [1.25], [1.25]])
    (top,), (value,) = _vertex(places, np.array([[3.0], [4.0], [4.0 - 1e-15]]))
    assert (top, value) == (1.25, 4.0)
    (top,), (value,) = _vertex(np.array([[0.0], [1.0], [3.0]]), np.array([[1.0], [4.0], [4.0]]))
    assert (top, value) == (2.0, 5.0)  # 5 - (x - 2)^2
