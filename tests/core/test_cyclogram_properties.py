"""Invariants of the cyclogram, over mechanisms that hypothesis makes up."""

import math
from itertools import pairwise

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from core.errors import InvalidInput
from core.output.contact_force import Cyclogram, cyclogram
from core.output.mechanism import Mechanism, assembly_angles, ratio_from_teeth
from core.precision import CONVERGED, EXACT

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


def driving_time(result: Cyclogram) -> float:
    return math.fsum(stop - start for p in result.pairs for start, stop in p.driving)


@given(mechanisms(), revolutions)
def test_counts_integrate_to_the_sum_of_the_intervals(mechanism: Mechanism, turns: float) -> None:
    result = cyclogram(mechanism=mechanism, revolutions=turns)
    counted = math.fsum(i.pairs * (i.end - i.start) for i in result.driving_count)
    pairs = mechanism.pins * mechanism.satellites
    phases = 2 + turns * (1 + 1 / mechanism.ratio)
    allowed = sliver(mechanism, turns) * pairs * phases * 2
    assert counted == pytest.approx(driving_time(result), abs=allowed)


@given(mechanisms(), st.integers(1, 4))
def test_each_pair_drives_half_of_every_whole_wave_turn(mechanism: Mechanism, waves: int) -> None:
    turns = waves / (1 + 1 / mechanism.ratio)
    result = cyclogram(mechanism=mechanism, revolutions=turns)
    end = 2 * math.pi * turns
    for pair in result.pairs:
        driven = math.fsum(stop - start for start, stop in pair.driving)
        assert driven == pytest.approx(end / 2, abs=4 * sliver(mechanism, turns))
    assert result.mean_driving == mechanism.pins * mechanism.satellites / 2


@given(mechanisms(), revolutions)
def test_intervals_are_ordered_and_cut_only_at_the_ends(mechanism: Mechanism, turns: float) -> None:
    result = cyclogram(mechanism=mechanism, revolutions=turns)
    end = turns * 2 * math.pi
    tiny = sliver(mechanism, turns)
    half = result.period / 2
    assert result.working_phase == pytest.approx(half, rel=CONVERGED)
    for pair in result.pairs:
        for start, stop in pair.driving:
            assert 0 <= start < stop <= end
            if start > 0 and stop < end:
                assert stop - start == pytest.approx(half, abs=tiny)
            else:
                assert stop - start <= half + tiny
        for (_, before), (after, _) in pairwise(pair.driving):
            # idle for as long as driving
            assert after - before == pytest.approx(half, abs=tiny)


@given(mechanisms(), revolutions)
def test_counts_cover_the_range_without_slivers(mechanism: Mechanism, turns: float) -> None:
    result = cyclogram(mechanism=mechanism, revolutions=turns)
    counts = result.driving_count
    assert counts[0].start == 0.0
    assert counts[-1].end == turns * 2 * math.pi
    # rounding makes no interval: what there is, is longer than 1e-12 turns
    shortest = 6e-12 / (1 + 1 / mechanism.ratio)
    for interval in counts:
        assert interval.end - interval.start > shortest / 2
        assert result.min_driving <= interval.pairs <= result.max_driving
    for before, after in pairwise(counts):
        assert before.end == after.start
        assert before.pairs != after.pairs


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


@given(mechanisms(), revolutions, st.floats(0.001, 0.999))
def test_count_anywhere_is_the_number_of_positive_cosines(
    mechanism: Mechanism, turns: float, part: float
) -> None:
    result = cyclogram(mechanism=mechanism, revolutions=turns)
    phi = part * turns * 2 * math.pi
    psi = phi * (1 + 1 / mechanism.ratio) + mechanism.initial_crank_angle
    cosines = [
        -math.sin(psi + a + 2 * math.pi * n / mechanism.pins)
        for a in mechanism.crank_angles
        for n in range(mechanism.pins)
    ]
    assume(min(abs(c) for c in cosines) > 1e-8)
    expected = sum(c > 0 for c in cosines)
    (interval,) = [i for i in result.driving_count if i.start < phi < i.end]
    assert interval.pairs == expected
    listed = sum(any(a < phi < b for a, b in p.driving) for p in result.pairs)
    assert listed == expected


@given(mechanisms(), st.randoms(use_true_random=False))
def test_order_of_the_satellites_does_not_matter(mechanism: Mechanism, random) -> None:  # type: ignore[no-untyped-def]
    order = list(range(mechanism.satellites))
    random.shuffle(order)
    shuffled = Mechanism(
        pins=mechanism.pins,
        crank_angles=tuple(mechanism.crank_angles[j] for j in order),
        ratio=mechanism.ratio,
        initial_crank_angle=mechanism.initial_crank_angle,
    )
    one, other = cyclogram(mechanism=mechanism), cyclogram(mechanism=shuffled)
    tiny = sliver(mechanism, 1.0)
    assert [i.pairs for i in one.driving_count] == [i.pairs for i in other.driving_count]
    assert [i.end for i in one.driving_count] == pytest.approx(
        [i.end for i in other.driving_count], abs=tiny
    )
    for place, j in enumerate(order):
        for n in range(mechanism.pins):
            mine = one.pairs[j * mechanism.pins + n].driving
            theirs = other.pairs[place * mechanism.pins + n].driving
            assert [x for i in mine for x in i] == pytest.approx(
                [x for i in theirs for x in i], abs=tiny
            )


@given(mechanisms(), st.floats(-7, 7))
def test_turning_all_cranks_is_starting_elsewhere(mechanism: Mechanism, turn: float) -> None:
    turned = Mechanism(
        pins=mechanism.pins,
        crank_angles=tuple(a + turn for a in mechanism.crank_angles),
        ratio=mechanism.ratio,
        initial_crank_angle=mechanism.initial_crank_angle,
    )
    started = Mechanism(
        pins=mechanism.pins,
        crank_angles=mechanism.crank_angles,
        ratio=mechanism.ratio,
        initial_crank_angle=mechanism.initial_crank_angle + turn,
    )
    one, other = cyclogram(mechanism=turned), cyclogram(mechanism=started)
    tiny = sliver(mechanism, 1.0)
    for a, b in zip(one.pairs, other.pairs, strict=True):
        long_a = [i for i in a.driving if i[1] - i[0] > 4 * tiny]
        long_b = [i for i in b.driving if i[1] - i[0] > 4 * tiny]
        assert [x for i in long_a for x in i] == pytest.approx(
            [x for i in long_b for x in i], abs=2 * tiny
        )
    assert (one.min_driving, one.max_driving) == (other.min_driving, other.max_driving)
    assert len(one.dead_zones) == len(other.dead_zones) or one.dead_centres != ()


@given(mechanisms(), st.floats(0.001, 0.999))
def test_reversing_the_torque_exchanges_driving_and_idle(mechanism: Mechanism, part: float) -> None:
    reverse = Mechanism(
        pins=mechanism.pins,
        crank_angles=mechanism.crank_angles,
        ratio=mechanism.ratio,
        initial_crank_angle=mechanism.initial_crank_angle + math.pi,
    )
    forward, backward = cyclogram(mechanism=mechanism), cyclogram(mechanism=reverse)
    phi = part * 2 * math.pi
    tiny = 4 * sliver(mechanism, 1.0)
    edges = [x for p in forward.pairs for i in p.driving for x in i]
    assume(min(abs(phi - x) for x in [0.0, 2 * math.pi, *edges]) > tiny)
    for one, other in zip(forward.pairs, backward.pairs, strict=True):
        drives = any(a < phi < b for a, b in one.driving)
        idles = not any(a < phi < b for a, b in other.driving)
        assert drives == idles
    pairs = mechanism.pins * mechanism.satellites
    assert backward.min_driving == pairs - forward.max_driving
    assert backward.max_driving == pairs - forward.min_driving


@given(mechanisms(pins=st.sampled_from([2, 4, 6, 8, 12])))
def test_even_numbers_of_pins_always_drive_by_half(mechanism: Mechanism) -> None:
    # each pin has one opposite it: whatever the cranks, just half of all pairs drive
    result = cyclogram(mechanism=mechanism)
    half = mechanism.pins * mechanism.satellites // 2
    assert [i.pairs for i in result.driving_count] == [half]


@given(mechanisms(pins=st.integers(3, 40)))
def test_three_pins_or_more_have_no_dead_centre(mechanism: Mechanism) -> None:
    result = cyclogram(mechanism=mechanism)
    assert result.dead_centres == ()
    assert result.dead_zones == ()
    assert result.min_driving >= (mechanism.pins // 2) * mechanism.satellites


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


@given(mechanisms(), st.sampled_from([2, 3, 5]))
def test_more_turns_go_on_where_fewer_end(mechanism: Mechanism, times: int) -> None:
    short = cyclogram(mechanism=mechanism, revolutions=1.0)
    long = cyclogram(mechanism=mechanism, revolutions=float(times))
    tiny = 4 * sliver(mechanism, times)
    for one, other in zip(short.pairs, long.pairs, strict=True):
        cut = [(a, min(b, 2 * math.pi)) for a, b in other.driving if a < 2 * math.pi - tiny]
        kept = [(a, b) for a, b in one.driving if b - a > tiny]
        cut = [(a, b) for a, b in cut if b - a > tiny]
        assert [x for i in kept for x in i] == pytest.approx([x for i in cut for x in i], abs=tiny)


@given(
    st.integers(1, 6),
    st.integers(1, 300),
    st.integers(1, 9),
    st.integers(1, 13),
)
def test_assembly_rotations_are_within_half_a_pitch(
    satellites: int, teeth: int, more: int, pins: int
) -> None:
    ratio = ratio_from_teeth(satellite_teeth=teeth, ring_teeth=teeth + more)
    assert ratio == teeth / more
    mechanism = Mechanism.evenly_spaced(pins=pins, satellites=satellites, ratio=ratio)
    found = assembly_angles(mechanism=mechanism, satellite_teeth=teeth)
    pitch = 2 * math.pi / teeth
    assert [a.satellite for a in found] == list(range(1, satellites + 1))
    assert found[0].hole_rotation == 0.0
    assert found[0].identical
    for j, angle in enumerate(found):
        assert abs(angle.hole_rotation) <= pitch / 2 * (1 + 1e-12)
        # alpha_j/u = j*2*pi/K*(z3 - z2)/z2 = j*(z3 - z2)/K pitches: whole ones turn nothing
        if j * more % satellites == 0:
            assert angle.hole_rotation == 0.0
            assert angle.identical
        else:
            part = (j * more % satellites) / satellites
            assert abs(angle.hole_rotation) == pytest.approx(min(part, 1 - part) * pitch, rel=EXACT)


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
