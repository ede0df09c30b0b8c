"""Tolerances: classes against their formulas, draws, intervals, contributions."""

import itertools
import math
import random
from dataclasses import dataclass, replace
from fractions import Fraction
from statistics import NormalDist
from types import SimpleNamespace

import numpy as np
import pytest

from core.design.tolerances import HoleDiameter, ToleranceSection
from core.errors import InvalidInput
from core.hertz import ElasticMaterial
from core.output.elasticity import ConformalLaw, ContactLaw, HertzLaw, LinearLaw, PowerLaw
from core.output.mechanism import Mechanism
from core.output.over_turn import over_turn
from core.precision import CONVERGED, EXACT, SEARCHED
from core.tolerance.contributions import contributions
from core.tolerance.draws import Spread, uniforms, zone_places
from core.tolerance.iso286 import GRADES, NEAREST, SIZES, class_limits
from core.tolerance.quantiles import percentile, refuse_few, share
from core.tolerance.study import QUANTITIES, Evaluation, Study, tolerance_study
from core.tolerance.tolerances import Drawn, Tolerances
from tests.inputs.real_mechanisms import STEEL, design
from tests.oracles.seeds import seeds

LAWS: list[ContactLaw] = [HertzLaw(), LinearLaw(1e8)]
UNIT = {5: 7, 6: 10, 7: 16, 8: 25, 9: 40, 10: 64, 11: 100}


def test_grades_follow_their_formula() -> None:
    """The printed table is the standard; its formula shows a wrong digit."""
    for row, (low, high) in enumerate(zip((1, *SIZES), SIZES, strict=False)):
        mean = math.sqrt(low * high)
        unit = 0.45 * mean ** (1 / 3) + 0.001 * mean
        for grade, widths in GRADES.items():
            # The smallest sizes have more than the formula gives them.
            room = 1.3 + (0.035 if high > 3 else 0.11) * widths[row]
            assert abs(widths[row] - UNIT[grade] * unit) <= room, (grade, high)
        assert abs(-NEAREST["g"][row] - 2.5 * mean**0.34) <= 1.1, high
        assert abs(-NEAREST["f"][row] - 5.5 * mean**0.41) <= 2.1, high
        if high > 3:
            assert abs(NEAREST["m"][row] - GRADES[7][row] + GRADES[6][row]) <= 1, high


@pytest.mark.parametrize(
    ("size", "name", "lower", "upper"),
    [
        (10, "m6", 6, 15), (14, "H7", 0, 18), (30, "h6", -13, 0), (30.001, "h6", -16, 0),
        (50, "f7", -50, -25), (3, "g6", -8, -2), (25, "js6", -6.5, 6.5), (40, "G7", 9, 34),
        (100, "F8", 36, 90), (500, "JS11", -200, 200),
    ],
)  # fmt: skip
def test_limits_of_classes(size: float, name: str, lower: float, upper: float) -> None:
    found = class_limits(size=size / 1e3, tolerance_class=name)
    assert [found.lower * 1e6, found.upper * 1e6] == pytest.approx([lower, upper])


@pytest.mark.parametrize(
    ("size", "name"), [(0.0, "h6"), (0.501, "h6"), (0.01, "h4"), (0.01, "k6"), (0.01, "M6")]
)
def test_what_the_tables_have_not_is_refused(size: float, name: str) -> None:
    with pytest.raises(InvalidInput):
        class_limits(size=size, tolerance_class=name)


def test_a_sample_hangs_on_nothing_but_its_number() -> None:
    whole = uniforms(seed=3, streams=[(4, 2), (5, 2)], samples=50)[1]
    for first in (0, 1, 4, 7, 30):
        part = uniforms(seed=3, streams=[(5, 2)], samples=11, first=first)[0]
        assert part.tolist() == whole[first : first + 11].tolist()
    for other in ({"seed": 4}, {"streams": [(4, 2)]}, {"streams": [(5, 1)]}):
        stream = {"seed": 3, "streams": [(5, 2)]} | other
        assert abs(np.corrcoef(uniforms(**stream, samples=50)[0], whole)[0, 1]) < 0.5


def test_distributions_keep_their_limits_and_their_width() -> None:
    numbers = uniforms(seed=1, streams=[(2, 0)], samples=20_000)[0]
    for distribution, sigma in (("normal", 0.986578 / 3), ("uniform", 1 / math.sqrt(3))):
        values = Spread(1.0, 3.0, distribution).values(numbers)
        assert values.min() >= 1 and values.max() <= 3
        assert values.mean() == pytest.approx(2, abs=0.02)
        assert values.std() == pytest.approx(sigma, rel=0.02)
    radial, tangential = zone_places(
        diameter=2.0,
        radius_uniform=numbers,
        angle_uniform=uniforms(seed=1, streams=[(3, 0)], samples=20_000)[0],
    )
    radius = np.hypot(radial, tangential)
    assert radius.max() <= 1 and (radius < 0.5).mean() == pytest.approx(0.25, abs=0.01)


def test_normal_deviations_are_those_of_the_normal_distribution() -> None:
    numbers = uniforms(seed=1, streams=[(2, 0)], samples=2000)[0]
    tail = NormalDist().cdf(-3)
    expected = [NormalDist().inv_cdf(tail + u * (1 - 2 * tail)) for u in numbers]
    assert Spread(-3.0, 3.0).values(numbers) == pytest.approx(expected, rel=CONVERGED, abs=1e-15)


def test_common_sizes_and_the_second_sample() -> None:
    both = Tolerances(pin_radius=Spread(0.0, 1e-5, common=True), hole_radius=Spread(0.0, 1e-5))
    pieces = Drawn(both, pins=4, satellites=2, seed=5, samples=range(3))
    first, mixed = pieces.rows(), replace(pieces, other=("hole_radius",)).rows()
    assert all(len({*piece}) == 1 for piece in first.pin_radius.tolist())
    assert all(len({*piece}) == 8 for piece in first.hole_radius.tolist())
    assert (first.pin_radius == mixed.pin_radius).all()
    assert (first.hole_radius[0] != mixed.hole_radius[0]).any()
    assert not first.pin_radial.any() and first.eccentricity.shape == (3, 2)
    middle = replace(pieces, tolerances=both.middle).rows()
    assert (middle.pin_radius == 5e-6).all() and (middle.hole_radius == 5e-6).all()


def test_the_interval_of_a_percentile_covers_as_often_as_it_says() -> None:
    draws = np.random.default_rng(0).random((400, 200))
    for percent in (50, 90):
        found = [percentile(values=row, percent=percent) for row in draws]
        covered = np.mean([each.low <= percent / 100 <= each.high for each in found])
        assert covered >= 0.92
    with pytest.raises(InvalidInput):
        percentile(values=draws[0], percent=99)
    with pytest.raises(InvalidInput):
        percentile(values=draws[0], percent=100)


def test_rare_percentiles_need_the_samples_that_they_need() -> None:
    percentile(values=range(368), percent=99)
    with pytest.raises(InvalidInput):
        percentile(values=range(367), percent=99)


def exactly_below(count: int, p: Fraction) -> list[Fraction]:
    """Probabilities of at most 0, 1, ... of so many, by their definition."""
    terms = (math.comb(count, k) * p**k * (1 - p) ** (count - k) for k in range(count + 1))
    return [*itertools.accumulate(terms)]


@pytest.mark.parametrize("percent", [0.01, 1, 3.5, 50, 66.6, 95, 99])
def test_ends_of_intervals_are_the_binomial_quantiles(percent: float) -> None:
    for count in (1, 2, 5, 6, 19, 72, 73, 104, 367, 368, 369, 500):
        below = exactly_below(count, Fraction(repr(percent)) / 100)
        low = sum(each < Fraction(25, 1000) for each in below)
        high = sum(each < Fraction(975, 1000) for each in below) + 1
        values = range(1, count + 1)
        if low < 1 or high > count:
            with pytest.raises(InvalidInput, match="needs a sample of at least"):
                refuse_few(count=count, percent=percent)
            with pytest.raises(InvalidInput, match="needs a sample of at least"):
                percentile(values=values, percent=percent)
            continue
        refuse_few(count=count, percent=percent)
        found = percentile(values=values, percent=percent)
        assert (found.low, found.high) == (low, high)


def test_ends_of_shares_are_those_of_clopper_and_pearson() -> None:
    for count in (1, 7, 60, 300):
        for successes in {0, 1, count // 3, count - 1, count}:
            found = share(successes=successes, count=count)
            if successes:
                below = exactly_below(count, Fraction(found.low))[successes - 1]
                assert float(1 - below) == pytest.approx(0.025, rel=EXACT)
            if successes < count:
                below = exactly_below(count, Fraction(found.high))[successes]
                assert float(below) == pytest.approx(0.025, rel=EXACT)


def test_no_sample_is_gone_through_to_see_whether_it_is_large_enough() -> None:
    """Nor is more of the binomial than its ends: ten thousand million pieces have a share."""
    refuse_few(count=10**18, percent=99.99)
    found = share(successes=10**6, count=10**10)
    assert found.value == 1e-4
    assert (found.high - found.low) / 2 == pytest.approx(1.96 * 1e-7, rel=1e-3)


def test_no_failure_is_no_proof() -> None:
    found = share(successes=1000, count=1000)
    assert (found.value, found.high) == (1, 1)
    assert found.low == pytest.approx(1 - 3.7 / 1000, abs=2e-5)
    assert share(successes=0, count=10).low == 0


LOOSE = Tolerances(
    pin_position=2e-6,
    hole_position=2e-5,
    hole_radius=Spread(0.0, 2e-6),
)
ASKED = Evaluation(quantities=("peak_force",), output_torque=30.0, positions=12)


def test_the_widest_zone_contributes_most() -> None:
    found = contributions(study=Study(design(), LOOSE, ASKED, samples=64, seed=1), percent=50)
    assert found[0].source == "hole_position"
    assert found[0].total > 0.7 > 0.2 > found[-1].total
    assert found[0].without.value < min(each.without.value for each in found[1:])
    for each in found:
        assert each.total >= -1e-12 and each.total_error >= 0 and each.first_error >= 0


def test_one_source_explains_all() -> None:
    alone = Tolerances(disc_phase=Spread(-1e-4, 1e-4))
    (found,) = contributions(study=Study(design(), alone, ASKED, samples=40), percent=50)
    assert found.first == pytest.approx(1, abs=1e-12)


@dataclass
class Sum:
    """In the place of a study: 3*a + b of normal numbers, whose indices are 0.9 and 0.1."""

    seed: int
    tolerances = SimpleNamespace(sources=("a", "b"), without=lambda source: source)

    def pieces(self, other=(), tolerances=""):
        one, two = np.random.default_rng(self.seed).standard_normal((2, 100, 2))
        second = np.array([source in other for source in "ab"])
        return np.where(second, two, one) * [source != tolerances for source in "ab"]

    def values(self, pieces):
        return pieces @ [[3.0], [1.0]], None


def test_the_errors_of_the_indices_are_as_large_as_they_say() -> None:
    """Indices of 300 studies lie within 1.96 standard errors as often as expected; the variance is
    estimated too.
    """
    found = [contributions(study=Sum(seed), percent=50) for seed in range(300)]
    for name, exact in (("a", 0.9), ("b", 0.1)):
        for index in ("total", "first"):
            own = [each for study in found for each in study if each.source == name]
            off = np.array([getattr(each, index) - exact for each in own])
            stated = np.array([getattr(each, f"{index}_error") for each in own])
            assert 0.92 < np.mean(np.abs(off) <= 1.96 * stated) < 0.98, (name, index)
            assert stated.mean() == pytest.approx(off.std(), rel=0.12), (name, index)


def test_pieces_that_do_not_fit_are_counted_and_left_out() -> None:
    tight = replace(design(), clearance=8e-6)
    asked = replace(ASKED, quantities=("peak_force", "stiffness_min"))
    study = Study(tight, LOOSE, asked, samples=40)
    found = tolerance_study(study)
    assert 0.2 < found.cannot_assemble.value < 1
    assert (np.isnan(found.values).all(axis=1) == ~found.fits).all()
    kept = found.yield_within(quantity="peak_force", limit=1e9)
    assert kept.value == pytest.approx(1 - found.cannot_assemble.value)
    fitting = found.yield_within(quantity="peak_force", limit=1e9, of_fitting=True)
    assert fitting.value == 1
    stiffest = found.column("stiffness_min").max()
    kept = found.yield_within(quantity="stiffness_min", limit=stiffest, of_fitting=True)
    assert kept.value == pytest.approx(1 / found.fits.sum())
    # As each piece by itself.
    pieces = study.pieces()
    states = [study.piece(pieces, i).rooms.room.state for i in range(40)]
    assert [state == "fits" for state in states] == found.fits.tolist()
    assert [state == "binds_in_turning" for state in states] == found.binds.tolist()


@pytest.mark.parametrize("rigid", [True, False])
def test_a_torque_that_alternates_has_the_worse_of_each_piece(
    rigid: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(Study, "rigid", rigid)
    study = Study(design(), LOOSE, ASKED, samples=20)
    quantities = ("peak_force", "transmission_error", "stiffness_min")
    asked = replace(study.asked, quantities=quantities, alternating=True)
    ways = [replace(study, asked=each) for each in (asked, *asked.ways)]
    both, driving, reverse = (each.values(each.pieces())[0] for each in ways)
    assert (both[:, :2] == np.maximum(driving, reverse)[:, :2]).all()
    assert (both[:, 2] == np.minimum(driving, reverse)[:, 2]).all()
    assert (driving[:, 0] != reverse[:, 0]).any()


def test_processes_and_fits_fill_what_is_not_given() -> None:
    given = ToleranceSection(process="precise", hole_position=1e-5)
    assert given.guides().keys() == {"pin_position", "pin_diameter", "hole_diameter"}
    found = given.filled("H7/f7").of_parts({"pin": 0.012, "hole": 0.0145})
    assert (found.pin_position, found.hole_position) == (3e-5, 1e-5)
    pin = class_limits(size=0.012, tolerance_class="f7")
    assert found.pin_radius == Spread(pin.lower / 2, pin.upper / 2)
    with pytest.raises(InvalidInput, match="hole_diameter"):
        replace(given, hole_diameter=HoleDiameter(tolerance_class="H8")).filled("H7/f7")


def test_a_part_of_the_pieces_is_made_alone() -> None:
    pieces = Study(design(), LOOSE, ASKED, samples=50, seed=3).pieces()
    whole, part = pieces.rows(), pieces.part(21, 38).part(2, 9)
    assert len(part) == 7
    for own, rows in zip(part.rows(), whole, strict=True):
        assert own.tolist() == rows[23:30].tolist()


@pytest.mark.parametrize("seed", seeds(20))
def test_the_scalar_loop_of_rigid_pieces_finds_what_the_engine_finds(
    seed: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Pieces that press, bind and fit, of any law, in both directions, at dead angles."""
    r = random.Random(f"rigid pieces {seed}")
    law = r.choice([*LAWS, PowerLaw(r.uniform(0.6, 2.5), 1e3, 1e-5)])
    steel, pom = STEEL, ElasticMaterial(2.8e9, 0.38)
    law, material = r.choice([(law, steel), (law, steel), (ConformalLaw(), pom)])
    real = design(
        mechanism=uneven(r.choice([1, 2, 3, 5, 8]), r.randint(1, 3)),
        clearance=r.choice([-5e-6, 0.0, 8e-6, 3e-5, 1e-4]),
        law=law,
        pin_material=material,
        hole_material=material,
        roller_play=r.choice([0.0, 2e-6]),
    )
    torque = r.choice([30.0, -30.0]) * (0.02 if material is pom else 1)
    names = r.choice([QUANTITIES, ("backlash_max",), ("lost_motion",), ("peak_force",)])
    asked = Evaluation(names, torque, positions=r.choice([12, 17]), lost_motion_share=0.2)
    study = Study(real, LOOSE, asked, samples=6, seed=seed)
    assert study.rigid
    quick, fits = study.values(study.pieces())
    monkeypatch.setattr(Study, "rigid", False)
    found, states = study.values(study.pieces())
    assert fits.tolist() == states.tolist()
    steep = isinstance(law, PowerLaw) and law.exponent < 1
    for name, one, other in zip(names, quick.T, found.T, strict=True):
        near = 1e-7 if name == "stiffness_min" or steep else SEARCHED
        assert one == pytest.approx(other, rel=near, abs=1e-12, nan_ok=True), name


def test_backlash_alone_and_lost_motion_alone_are_those_of_the_whole_study() -> None:
    asked = replace(ASKED, quantities=QUANTITIES)
    real = design(pin_material=STEEL, hole_material=STEEL)
    study = Study(real, LOOSE, asked, samples=16)
    whole, _ = study.values(study.pieces())
    for name in ("backlash_max", "lost_motion"):
        alone = replace(study, asked=replace(asked, quantities=(name,)))
        values, _ = alone.values(alone.pieces())
        assert values[:, 0].tolist() == whole[:, QUANTITIES.index(name)].tolist()


def uneven(pins: int, satellites: int) -> Mechanism:
    return Mechanism(pins, tuple(1.3 * j * j for j in range(satellites)), 18.0)


@pytest.mark.parametrize("pins", [1, 2, 3, 8])
@pytest.mark.parametrize("size", [0.0, 1e-6, 1e-4])
def test_the_widest_play_is_that_of_all_positions(
    size: float, pins: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Parts press, just fit, or have almost the eccentricity as room, with deviations of any size,
    at dead angles.
    """
    way = Spread(-size / 3, size)
    wide = Tolerances(
        pin_position=size or None,
        hole_position=2 * size or None,
        hole_radius=way,
        eccentricity=way,
        disc_phase=Spread(-40 * size, 200 * size),
        crank_phase=Spread(-40 * size, 40 * size),
    )
    asked = replace(ASKED, quantities=("backlash_max",))
    plays = []
    for quick in (True, False):
        monkeypatch.setattr(Study, "rigid", quick)
        for i, clearance in enumerate((-size, 0.0, size, 3 * size, 30 * size, 1.2e-3)):
            real = design(
                mechanism=uneven(pins, 1 + i % 4), clearance=clearance, roller_play=1e-6 * (i % 2)
            )
            study = Study(real, wide, asked, samples=2, seed=i)
            plays.append(study.values(study.pieces())[0][:, 0].tolist())
    half = len(plays) // 2
    assert plays[:half] == [pytest.approx(each, abs=1e-12, nan_ok=True) for each in plays[half:]]


LAWS = [LinearLaw(1e8), PowerLaw(10 / 9, 1000.0, 1e-5), PowerLaw(0.5, 1000.0, 1e-5), HertzLaw()]


def test_blocks_are_larger_where_pieces_are_quick() -> None:
    """The number of pieces does not depend on the split."""
    few, many = design(), design(mechanism=Mechanism.evenly_spaced(pins=24, satellites=3, ratio=18))
    alone = replace(Study(few, LOOSE, ASKED), threads=1)
    assert alone.block(10**6) == 1024 and alone.block(1000) == 250 and alone.block(8) == 64
    assert 64 <= replace(alone, real=many).block(10**6) < 1024
    quick = replace(alone, samples=300)
    split = replace(quick, threads=4)
    assert len({study.block(300) for study in (quick, split)}) == 2
    one, other = (study.values(study.pieces())[0] for study in (quick, split))
    assert one.tobytes() == other.tobytes()


def test_what_each_tolerance_does_to_the_fit() -> None:
    tight = replace(design(), clearance=8e-6)
    found = contributions(study=Study(tight, LOOSE, ASKED, samples=64), to_fit=True)
    assert found[0].source == "hole_position" and found[0].without.value == 1


def test_every_quantity_of_an_exact_piece_is_that_of_the_nominal() -> None:
    real = design(pin_material=STEEL, hole_material=STEEL)
    done: list[int] = []
    none = Tolerances(hole_radius=Spread(0.0, 0.0))
    asked = Evaluation(QUANTITIES, 30.0, positions=8)
    study = Study(real, none, asked, samples=2, progress=done.append)
    found = tolerance_study(study)
    assert done == [2]
    for name in QUANTITIES:
        assert found.column(name).tolist() == [found.nominal[name]] * 2
    peak = found.nominal["peak_force"]
    pressure = real.contact(0, peak).max_pressure
    assert found.nominal["max_pressure"] == pytest.approx(pressure, rel=CONVERGED)
    assert found.angle_grid_error.keys() == {*QUANTITIES}
    assert 0 <= found.angle_grid_error["peak_force"] < 0.05
    assert all(0 <= each <= 1 for each in found.angle_grid_error.values())


@pytest.mark.parametrize("positions", [60, 240])
def test_what_the_angles_miss_of_parts_that_are_alike(positions: int) -> None:
    """Against the turn itself, whose extremes are narrowed."""
    mechanism = Mechanism.evenly_spaced(pins=8, satellites=2, ratio=20.0)
    real = design(mechanism=mechanism, law=HertzLaw(), exact=False)
    names = ("max_pressure", "transmission_error", "stiffness_min")
    none = Tolerances(hole_radius=Spread(0.0, 0.0))
    found = tolerance_study(Study(real, none, Evaluation(names, 30.0, positions), samples=2))
    turn = over_turn(real=real, output_torque=30.0)
    for name in names:
        missed = abs(found.nominal[name] / getattr(turn, name) - 1)
        assert 0.7 * missed < found.angle_grid_error[name] < 1.4 * missed, name
