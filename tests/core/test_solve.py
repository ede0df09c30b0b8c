"""One input solved for one result: closed forms, jumps, gaps, tangents, whole numbers."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from core.errors import InvalidInput
from core.numerics.inverse import edge, solve_for
from core.precision import CONVERGED


@given(st.floats(1e-3, 1e3), st.floats(0.2, 5.0), st.booleans())
def test_a_power_is_solved_to_its_last_digits(target: float, power: float, log: bool) -> None:
    low, high = target ** (1 / power) / 37.1, target ** (1 / power) * 11.3
    found = solve_for(function=lambda x: x**power, low=low, high=high, target=target, log=log)
    assert found.status == "solved"
    assert found.value == pytest.approx(target ** (1 / power), rel=CONVERGED)
    assert found.monotone
    # the value meets the target, its neighbour in the bracket does not
    unmet, met = found.bracket  # type: ignore[misc]
    assert met == found.value
    assert met**power >= target > unmet**power
    assert met - unmet <= 2.0**-49 * met
    assert found.intervals == ((met, high),)


@pytest.mark.parametrize(
    ("sense", "want", "value"), [("at_most", "largest", 3.0), ("at_least", "smallest", 3.0)]
)
def test_a_jump_is_bracketed(sense, want, value):
    found = solve_for(
        function=lambda x: 1.0 if x < math.pi else 5.0,
        low=0.0,
        high=10.0,
        target=value,
        sense=sense,
        want=want,
    )
    low, high = found.bracket
    assert low < math.pi <= high
    assert high - low <= 2.0**-49 * high


def test_the_end_of_existence_ends_a_stretch():
    found = solve_for(
        function=lambda x: math.nan if x > 2.5 else x,
        low=0.0,
        high=10.0,
        target=1.0,
        want="largest",
    )
    assert found.value == pytest.approx(2.5, rel=CONVERGED)
    assert found.value <= 2.5
    assert found.intervals == ((pytest.approx(1.0, rel=CONVERGED), found.value),)


def test_several_stretches_are_told_and_the_wanted_one_is_given():
    def wave(x):
        return math.sin(x)

    small = solve_for(function=wave, low=0.0, high=10.0, target=0.5)
    large = solve_for(function=wave, low=0.0, high=10.0, target=0.5, want="largest")
    assert small.status == large.status == "several"
    assert not small.monotone
    assert small.value == pytest.approx(math.pi / 6, rel=CONVERGED)
    assert large.value == pytest.approx(2 * math.pi + 5 * math.pi / 6, rel=CONVERGED)
    ends = [end for interval in small.intervals for end in interval]
    assert [wave(end) >= 0.5 for end in ends] == [True] * 4


@pytest.mark.parametrize("place", [1.0, math.e, 7.77])
def test_a_tangent_root_between_samples_is_found(place):
    found = solve_for(function=lambda x: 1 - (x - place) ** 2, low=0.0, high=10.0, target=1 - 1e-6)
    assert found.status == "solved"
    assert found.value == pytest.approx(place - 1e-3, abs=1e-9)


def test_always_and_never():
    always = solve_for(function=lambda x: x + 1, low=0.0, high=1.0, target=0.5)
    assert (always.status, always.value, always.bracket) == ("always", 0.0, None)
    never = solve_for(function=lambda x: x, low=0.0, high=1.0, target=3.0)
    assert (never.status, never.value, never.best) == ("infeasible", None, (1.0, 1.0))
    at_most = solve_for(function=lambda x: x + 4, low=0.0, high=1.0, target=3.0, sense="at_most")
    assert at_most.best == (0.0, 4.0)
    nowhere = solve_for(function=lambda x: math.nan, low=0.0, high=1.0, target=3.0)
    assert (nowhere.status, nowhere.best) == ("infeasible", None)


def test_whole_numbers_are_all_tried():
    seen = []

    def function(x):
        seen.append(x)
        return (x - 5) ** 2

    found = solve_for(function=function, low=2.5, high=9, target=4.0, integer=True)
    assert seen == [3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0]
    assert found.intervals == ((3.0, 3.0), (7.0, 9.0))
    assert (found.status, found.value) == ("several", 3.0)


def test_equals_finds_crossings_from_both_sides():
    found = solve_for(function=lambda x: math.cos(x), low=0.0, high=6.0, target=0.0, sense="equals")
    assert [a for a, _ in found.intervals] == pytest.approx(
        [math.pi / 2, 3 * math.pi / 2], rel=CONVERGED
    )


@given(st.floats(1e-6, 50), st.sampled_from([1.0, -1.0]))
def test_the_edge_of_anything_is_between_neighbours(size: float, sign: float) -> None:
    place = sign * size
    met, unmet = edge(inside=-60.0, outside=60.0, excess=lambda x: math.atan(place - x))
    assert met <= place < unmet
    assert unmet - met <= 2.0**-49 * size


@pytest.mark.parametrize(
    "given", [{"low": 1.0, "high": 1.0}, {"low": 0.0, "high": 1.0, "log": True}]
)
def test_an_empty_range_is_refused(given):
    with pytest.raises(InvalidInput):
        solve_for(function=lambda x: x, target=1.0, **given)


@pytest.mark.parametrize("mirrored", [False, True])
@pytest.mark.parametrize(("sense", "sign"), [("at_least", 1), ("equals", 1), ("equals", -1)])
def test_what_is_met_only_next_to_the_end_of_existence_is_found(mirrored, sense, sign):
    """Between two samples: from 2.51 to 2.53, where the result ends."""

    def function(x):
        place = 10 - x if mirrored else x
        return sign * place if place < 2.53 else math.nan

    found = solve_for(function=function, low=0.0, high=10.0, target=sign * 2.51, sense=sense)
    assert found.status == "solved"
    ends = [2.51] if sense == "equals" else [2.51, 2.53]
    expected = sorted(10 - end for end in ends) if mirrored else ends
    assert sorted({*found.intervals[0]}) == pytest.approx(expected, rel=CONVERGED)


def test_no_more_is_asked_where_it_ends_on_its_way_from_the_target():
    """Below 2.5 it exists, and falls towards there: 129 samples are enough."""
    found = solve_for(
        function=lambda x: -x if x < 2.53 else math.nan, low=0.0, high=10.0, target=1.0
    )
    assert (found.status, found.evaluations) == ("infeasible", 129)
    assert found.best == (0.0, 0.0)


def test_no_more_whole_numbers_than_a_thousand_are_tried():
    most = solve_for(function=float, low=0.5, high=1000.9, target=999.5, integer=True)
    assert (most.value, most.evaluations) == (1000.0, 1000)
    for high in (1001.0, 1e12):
        with pytest.raises(InvalidInput) as refused:
            solve_for(function=float, low=0.5, high=high, target=999.5, integer=True)
    assert (refused.value.code, refused.value.params) == ("less_than_equal", {"limit": 1000})
