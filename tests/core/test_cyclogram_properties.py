"""Invariants of the cyclogram, over mechanisms that hypothesis makes up."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from core.errors import InvalidInput
from core.output.contact_force import cyclogram
from core.output.mechanism import Mechanism, ratio_from_teeth

angles = st.one_of(
    st.floats(-20.0, 20.0),
    st.integers(-48, 48).map(lambda k: math.radians(15 * k)),
    st.integers(-12, 12).map(lambda k: k * math.pi / 6 + 1e-13),
)
ratios = st.one_of(st.just(20.0), st.floats(0.1, 1000.0))


few_pins = st.integers(1, 13)


@st.composite
def mechanisms(draw: st.DrawFn, pins: st.SearchStrategy[int] = few_pins) -> Mechanism:
    return Mechanism(
        pins=draw(pins),
        crank_angles=tuple(draw(st.lists(angles, min_size=1, max_size=6))),
        ratio=draw(ratios),
        initial_crank_angle=draw(angles),
    )


revolutions = st.floats(0.05, 6.0)


def sliver(mechanism: Mechanism, revolutions: float) -> float:
    """Crank angle that the program may drop or move: 1e-12 turns of the wave, rounded up."""
    return 1e-11 * max(1.0, revolutions * (1 + 1 / mechanism.ratio))


@given(st.integers(1, 5), st.integers(2, 60), st.floats(0.1, 4.0), st.floats(0.3, 30.0))
def test_many_phases_next_to_each_other_lose_no_more_than_is_stated(
    pins: int, satellites: int, apart: float, ratio: float
) -> None:
    """However many slivers follow each other, each is within rounding."""
    mechanism = Mechanism.evenly_spaced(
        pins=pins,
        satellites=satellites,
        ratio=ratio,
        crank_spacing=apart * 2e-12 * math.pi,
        initial_crank_angle=1.0,
    )
    found = cyclogram(mechanism=mechanism)
    driven = math.fsum(stop - start for pair in found.pairs for start, stop in pair.driving)
    counted = math.fsum((each.end - each.start) * each.pairs for each in found.driving_count)
    of_all = 2 * math.pi * pins * satellites
    assert abs(driven - counted) <= found.accuracy.relative_error * of_all


@given(mechanisms(pins=st.integers(1, 2)), revolutions)
def test_dead_zones_are_where_the_count_is_nought(mechanism: Mechanism, turns: float) -> None:
    result = cyclogram(mechanism=mechanism, revolutions=turns)
    tiny = 4 * sliver(mechanism, turns)
    empty = [(i.start, i.end) for i in result.driving_count if i.pairs == 0]
    empty = [z for z in empty if z[1] - z[0] > tiny]
    zones = [z for z in result.dead_zones if z[1] - z[0] > tiny]
    assert [x for z in zones for x in z] == pytest.approx([x for z in empty for x in z], abs=tiny)
    for zone in result.dead_zones:
        assert zone[0] in result.dead_centres
        assert zone[1] in result.dead_centres
    if result.min_driving == 0 and turns * (1 + 1 / mechanism.ratio) > 1.01:
        assert result.dead_centres


@pytest.mark.parametrize(
    ("parameter", "change"),
    [
        ("pins", {"pins": 0}),
        ("pins", {"pins": -3}),
        ("ratio", {"ratio": 0.0}),
        ("ratio", {"ratio": -20.0}),
        ("ratio", {"ratio": math.nan}),
        ("crank_angles[1]", {"crank_angles": (0.0, math.nan)}),
        ("initial_crank_angle", {"initial_crank_angle": math.inf}),
    ],
)
def test_impossible_mechanisms_are_refused_by_name(
    parameter: str, change: dict[str, object]
) -> None:
    given_values: dict[str, object] = {"pins": 3, "crank_angles": (0.0,), "ratio": 20.0}
    with pytest.raises(InvalidInput) as refusal:
        Mechanism(**(given_values | change))  # type: ignore[arg-type]
    assert refusal.value.parameter == parameter


@pytest.mark.parametrize("turns", [0.0, -1.0, math.nan, math.inf])
def test_a_range_of_no_length_is_refused(turns: float) -> None:
    mechanism = Mechanism.evenly_spaced(pins=3, satellites=2, ratio=20.0)
    with pytest.raises(InvalidInput) as refusal:
        cyclogram(mechanism=mechanism, revolutions=turns)
    assert refusal.value.parameter == "revolutions"


@pytest.mark.parametrize("teeth", [(40, 40), (40, 39), (0, 2)])
def test_teeth_that_do_not_mesh_are_refused(teeth: tuple[int, int]) -> None:
    with pytest.raises(InvalidInput):
        ratio_from_teeth(satellite_teeth=teeth[0], ring_teeth=teeth[1])


def test_a_range_hardly_longer_than_rounding_says_that_hardly_anything_is_known() -> None:
    mechanism = Mechanism(pins=3, crank_angles=(0.0, 1e-12), ratio=20.0)
    for revolutions, codes in ((1.0, []), (1.1e-12, ["hardly_known"])):
        shown = cyclogram(mechanism=mechanism, revolutions=revolutions)
        assert [notice.code for notice in shown.notices] == codes
