"""Fatigue of steel: tables as printed, ranges and their ends, criteria by their drawn lines."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from core.errors import InvalidInput
from core.fatigue import (
    EnduranceFactors,
    FatigueStrength,
    cycles_to_failure,
    endurance_limit,
    finite_strength,
    judge_cycle,
    notch_factor,
    reliability_factor,
    size_factor,
    strength_fraction,
    surface_factor,
    utilisation,
)
from core.precision import EXACT, SAME, SEARCHED

# by logarithms of the printed a and b: ln ka = ln a + b*ln Rm
SURFACE = {
    ("shigley_9", "ground"): (1.58, -0.085),
    ("shigley_9", "machined"): (4.51, -0.265),
    ("shigley_9", "hot_rolled"): (57.7, -0.718),
    ("shigley_9", "forged"): (272.0, -0.995),
    ("shigley_11", "ground"): (1.38, -0.067),
    ("shigley_11", "machined"): (3.04, -0.217),
    ("shigley_11", "hot_rolled"): (38.6, -0.650),
    ("shigley_11", "forged"): (54.9, -0.758),
}


@pytest.mark.parametrize(("edition", "surface"), SURFACE)
def test_surfaces(edition, surface):
    a, b = SURFACE[edition, surface]
    for strength in (400.0, 1600.0):
        found = surface_factor(tensile_strength=strength * 1e6, surface=surface, edition=edition)
        assert found == pytest.approx(min(1, math.exp(math.log(a) + b * math.log(strength))))
    # the newer one where none is named; no surface is better than polished
    own = {"tensile_strength": 800e6, "surface": surface}
    assert surface_factor(**own) == surface_factor(**own, edition="shigley_11")
    assert surface_factor(tensile_strength=1e6, surface=surface, edition=edition) == 1


def test_sizes():
    """Printed: 0.879d^-0.107 in inches to 2 in, 0.91d^-0.157 beyond; 1 for the specimen."""
    for inches in (0.4, 1.0, 1.9):
        assert size_factor(diameter=inches * 0.0254) == pytest.approx(
            0.879 * inches**-0.107, rel=3e-3
        )
    for inches in (2.1, 5.0, 10.0):
        assert size_factor(diameter=inches * 0.0254) == pytest.approx(
            0.91 * inches**-0.157, rel=3e-3
        )
    assert f"{size_factor(diameter=0.051):.6f}" == f"{1.24 * math.exp(-0.107 * math.log(51)):.6f}"
    assert f"{size_factor(diameter=0.0511):.6f}" == f"{1.51 * 51.1**-0.157:.6f}"
    assert f"{size_factor(diameter=0.052):.6f}" == f"{1.51 * math.exp(-0.157 * math.log(52)):.6f}"
    assert size_factor(diameter=0.001) == 1


@pytest.mark.parametrize("wrong", [0.0, -1.0])
def test_sizes_that_cannot_be_are_refused(wrong: float) -> None:
    notch = {"theoretical_factor": 2.0, "radius": 1e-3, "tensile_strength": 5e8}
    for call, name, own in (
        (surface_factor, "tensile_strength", {"surface": "ground"}),
        (size_factor, "diameter", {}),
        (notch_factor, "radius", notch),
        (notch_factor, "tensile_strength", notch),
    ):
        with pytest.raises(InvalidInput) as refused:
            call(**own | {name: wrong})
        assert refused.value.parameter == name


def test_reliabilities():
    printed = {50: 1.0, 90: 0.897, 95: 0.868, 99: 0.814, 99.9: 0.753, 99.99: 0.702}
    deviates = {90: 1.288, 95: 1.645, 99: 2.326, 99.9: 3.091, 99.99: 3.719}
    for percent, factor in printed.items():
        assert reliability_factor(percent=float(percent)) == factor
        # 8 % scatter about the mean
        assert factor == pytest.approx(1 - 0.08 * deviates.get(percent, 0), abs=6e-4)
    with pytest.raises(InvalidInput) as refused:
        reliability_factor(percent=98.0)
    assert refused.value.params["values"] == [*printed]


def test_notches():
    """Sensitivity by Neuber's root, sqrt(in) of a strength in kpsi, bending: printed polynomial."""

    def neuber(kpsi: float) -> float:
        root = 0.246 - 3.08e-3 * kpsi + 1.51e-5 * kpsi**2 - 2.67e-8 * kpsi**3
        return root * math.sqrt(25.4)  # sqrt(mm)

    for kpsi in (50.0, 100.0, 150.0, 200.0, 240.0):
        for radius in (0.1, 1.0, 10.0):
            found = notch_factor(
                theoretical_factor=3.0, radius=radius / 1e3, tensile_strength=kpsi * 6.894757e6
            )
            kf = 1 + 2 / (1 + neuber(kpsi) / math.sqrt(radius))
            assert found == pytest.approx(kf, rel=2e-2)
    own = {"theoretical_factor": 2.0, "radius": 1e-3}
    for outer, inner in ((100e6, 340e6), (2500e6, 1700e6)):
        assert notch_factor(**own, tensile_strength=outer) == notch_factor(
            **own, tensile_strength=inner
        )
    # 1.24 - .765 + .18496 - .016154 = .643806 at 340 MPa
    assert notch_factor(**own, tensile_strength=340e6) == pytest.approx(
        1 + 1 / 1.643806, rel=SEARCHED
    )
    # 1.24 - 3.825 + 4.624 - 2.019243 = .019757 at 1700 MPa
    assert notch_factor(**own, tensile_strength=1700e6) == pytest.approx(
        1 + 1 / 1.019757, rel=SEARCHED
    )
    assert notch_factor(theoretical_factor=1.0, radius=1e-3, tensile_strength=5e8) == 1
    with pytest.raises(InvalidInput):
        notch_factor(theoretical_factor=0.99, radius=1e-3, tensile_strength=5e8)


def test_limit():
    factors = EnduranceFactors(surface=0.8, size=0.9, reliability=0.5, notch=2.0)
    assert endurance_limit(tensile_strength=1000e6, factors=factors) == pytest.approx(90e6)
    for strength in (1400e6, 1401e6, 2000e6):
        limit = endurance_limit(tensile_strength=strength, factors=factors)
        assert limit == pytest.approx(126e6)


CYCLE = {"endurance": 300.0, "tensile_strength": 1000.0, "yield_strength": 800.0}


def used(amplitude, mean, criterion, **changes):
    return utilisation(amplitude=amplitude, mean=mean, criterion=criterion, **CYCLE | changes)


@pytest.mark.parametrize("criterion", ["goodman", "gerber", "soderberg", "fkm_haigh"])
def test_criteria_without_a_mean(criterion):
    assert used(150.0, 0.0, criterion) == 0.5
    if criterion != "fkm_haigh":  # pressing does no good there
        assert used(150.0, -200.0, criterion) == 0.5


def test_criteria_at_their_lines():
    """Points on the line of each criterion, by its drawing: utilisation 1."""
    for mean in (100.0, 400.0, 700.0):
        assert used(300 * (1 - mean / 1000), mean, "goodman") == pytest.approx(1)
        assert used(300 * (1 - mean / 800), mean, "soderberg") == pytest.approx(1)
        assert used(300 * (1 - (mean / 1000) ** 2), mean, "gerber") == pytest.approx(1)
    with pytest.raises(InvalidInput):
        used(1.0, 1.0, "soderberg", yield_strength=None)


def test_haigh_by_fkm():
    """R = -1: 300; R = 0: Se/(1 + M); R = 0.5: times (1 + M/3)/(1 + M); level beyond; M = .25."""
    strong = {"tensile_strength": 1000e6, "endurance": 300e6}
    m = 0.25

    def most(ratio: float) -> float:
        """Amplitude that is just allowed at a stress ratio."""
        mean = (1 + ratio) / (1 - ratio)
        return 2 / used(2.0, 2 * mean, "fkm_haigh", **strong)

    zero = 300e6 / (1 + m)
    assert most(-1.0) == pytest.approx(300e6)
    assert most(0.0) == pytest.approx(zero)
    assert most(0.5) == pytest.approx(zero * 3.25 / 3.75, rel=SAME)  # by the flatter line
    assert most(0.9) == pytest.approx(most(0.5))
    assert most(-3.0) == pytest.approx(300e6 / (1 - m / 2))
    # beyond minus infinity, pressing all the time, level too
    assert 1 / used(1.0, -1.0, "fkm_haigh", **strong) == pytest.approx(300e6 / (1 - m))
    assert used(1.0, -5.0, "fkm_haigh", **strong) == used(1.0, -1.0, "fkm_haigh", **strong)
    weak = {"tensile_strength": 200e6, "endurance": 100e6}
    assert used(1.0, 1.0, "fkm_haigh", **weak) == pytest.approx(1e-8)  # no M below 286 MPa


def test_share_of_the_strength():
    """Printed curve: .9 at 70 kpsi, .775 at 200; as at 70 below, as at 200 beyond."""
    kpsi = 6.894757293168361e6
    at = {each: strength_fraction(tensile_strength=each * kpsi) for each in (50, 70, 120, 200, 250)}
    assert at[70] == pytest.approx(0.89781, rel=EXACT) and at[50] == at[70]
    assert at[120] == pytest.approx(0.82336, rel=EXACT)
    assert at[200] == pytest.approx(0.776, rel=EXACT) and at[250] == at[200]


def life(amplitude, mean=0.0, **changes):
    own = {"endurance": 300.0, "tensile_strength": 1000.0, "fraction": 0.8} | changes
    return cycles_to_failure(amplitude=amplitude, mean=mean, **own)


def test_life_on_its_line():
    """A straight line in logarithms from f*Rm at 1000 cycles to Se at a million."""
    assert life(300.0) == math.inf
    assert life(300.0000001) == pytest.approx(1e6, rel=SEARCHED)
    assert life(800.0) == pytest.approx(1e3, rel=SAME)
    assert life(math.sqrt(300 * 800)) == pytest.approx(10**4.5, rel=SAME)
    assert life(400.0, mean=500.0) == pytest.approx(1e3, rel=SAME)  # reversed: 800
    assert life(400.0, mean=-500.0) == life(400.0)
    assert life(1.0, mean=1000.0) == life(1.0, mean=1200.0) == 0
    assert life(801.0, endurance=800.0) == 0
    assert life(799.0, endurance=800.0) == math.inf
    f = strength_fraction(tensile_strength=1000e6)
    own = {"fraction": f, "tensile_strength": 1000e6, "endurance": 300e6}
    assert life(f * 1000e6, **own) == pytest.approx(1e3, rel=SAME)


def stands(cycles, **changes):
    own = {"endurance": 300.0, "tensile_strength": 1000.0, "fraction": 0.8} | changes
    return finite_strength(cycles=cycles, **own)


def test_strength_on_the_line_of_life():
    """Inverse of the line: 800 at 1000 cycles, 300 at a million, level beyond both."""
    for cycles, strength in ((1e3, 800.0), (10**4.5, math.sqrt(300 * 800)), (1e6, 300.0)):
        assert stands(cycles) == pytest.approx(strength, rel=SAME)
    assert stands(1.0) == stands(1e3) and stands(1e9) == 300.0
    assert stands(1e4, endurance=800.0) == 800.0 and stands(1e4, endurance=900.0) == 900.0
    f = strength_fraction(tensile_strength=1000e6)
    own = {"fraction": f, "tensile_strength": 1000e6, "endurance": 300e6}
    assert stands(1e3, **own) == pytest.approx(f * 1000e6, rel=SAME)


@given(st.floats(1e3, 9.99e5), st.floats(0.1, 0.7), st.floats(1.001, 100.0))
def test_strength_and_life_are_inverse(cycles, limit, more):
    own = {"endurance": limit, "tensile_strength": 1.0, "fraction": 0.8}
    strength = finite_strength(cycles=cycles, **own)
    assert cycles_to_failure(amplitude=strength, mean=0.0, **own) == pytest.approx(
        cycles, rel=EXACT
    )
    assert limit <= finite_strength(cycles=cycles * more, **own) < strength


def test_the_cycles_that_a_part_has_to_stand():
    """The safety uses the strength at the required cycles; the stated life is that of the limit."""
    lasting = FatigueStrength(300.0, 1000.0)
    for cycles in (math.inf, 1e6, 1e9):
        strength = FatigueStrength(300.0, 1000.0, cycles=cycles)
        assert strength.lasting == strength.endurance_limit
        assert judge_cycle(strength=strength, largest=400.0, least=-400.0) == judge_cycle(
            strength=lasting, largest=400.0, least=-400.0
        )
    short = FatigueStrength(300.0, 1000.0, cycles=1e4)
    f = strength_fraction(tensile_strength=1000.0)
    found = judge_cycle(strength=short, largest=500.0, least=-300.0)
    finite = 300.0 ** (1 / 3) * (f * 1000) ** (2 / 3)
    assert short.lasting == found.finite_strength == pytest.approx(finite, rel=SAME)
    assert found.safety_factor == pytest.approx(1 / (400 / finite + 100 / 1000))
    assert found.endurance_limit == 300.0
    assert found.cycles == judge_cycle(strength=lasting, largest=500.0, least=-300.0).cycles
    # at the limit of one the other is at its own
    edge = judge_cycle(strength=FatigueStrength(300.0, 1000.0, cycles=found.cycles),
                       largest=500.0, least=-300.0)  # fmt: skip
    assert edge.safety_factor == pytest.approx(1, rel=SAME)


def test_a_cycle_is_judged():
    strength = FatigueStrength(300.0, 1000.0, 800.0, "soderberg")
    found = judge_cycle(strength=strength, largest=500.0, least=-100.0)
    assert (found.amplitude, found.mean, found.endurance_limit) == (300.0, 200.0, 300.0)
    assert (found.max_stress, found.min_stress) == (500.0, -100.0)
    assert found.safety_factor == pytest.approx(1 / (1 + 200 / 800))
    assert found.cycles == pytest.approx(
        cycles_to_failure(amplitude=300.0, mean=200.0, **strength.line)
    )
    assert judge_cycle(strength=strength, largest=100.0, least=-100.0).cycles is None
    for name in ("endurance_limit", "tensile_strength"):
        sizes = {"endurance_limit": 300.0, "tensile_strength": 1000.0} | {name: 0.0}
        with pytest.raises(InvalidInput) as refused:
            FatigueStrength(**sizes)
        assert (refused.value.parameter, refused.value.params["limit"]) == (name, 0)
    assert FatigueStrength(0.5, 0.75).endurance_limit == 0.5
    with pytest.raises(InvalidInput):
        FatigueStrength(300.0, 1000.0, criterion="soderberg")
