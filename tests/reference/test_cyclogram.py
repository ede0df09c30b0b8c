"""Oracle tests: the cyclogram against exact switching angles in mpmath.

The cyclogram may treat phases closer than some 1e-11 rad as one, and drop intervals that
narrow; everything here allows angles 1e-11 rad of the wave, times the range where rounding
grows with it, and no more.
"""

import math
import random
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st
from mpmath import mp, mpf

from core.output.contact_force import cyclogram
from core.output.mechanism import Mechanism, assembly_angles
from core.precision import CONVERGED, EXACT
from tests.oracles.crank_planetary import (
    cosines,
    driving_count,
    driving_intervals,
    largest_gap,
    phases,
    wave_angle,
)
from tests.oracles.seeds import seeds

MERGED = 1e-11
"""Phases (rad) that the program may take for one: 1e-12 turns, rounded up."""


def random_mechanism(seed: int) -> tuple[Mechanism, float]:
    """A mechanism and a number of revolutions, with the awkward cases well represented."""
    r = random.Random(seed)
    pins = r.choice([1, 2, 3, 4, 5, 6, 7, 9, 12, 13])
    satellites = r.randint(1, 6)
    kind = r.choice(["random", "even", "coincident", "near", "degrees"])
    if kind == "even":
        angles = [j * 2 * math.pi / satellites for j in range(satellites)]
    elif kind == "coincident":
        angles = [r.choice([0.0, 1.0, math.pi, 2 * math.pi, -1.0]) for _ in range(satellites)]
    elif kind == "near":
        base = r.uniform(-7, 7)
        angles = [base + r.choice([-1, 1]) * 10 ** r.uniform(-13, -3) for _ in range(satellites)]
    elif kind == "degrees":
        angles = [math.radians(r.randrange(-360, 720, 15)) for _ in range(satellites)]
    else:
        angles = [r.uniform(-10, 10) for _ in range(satellites)]
    mechanism = Mechanism(
        pins=pins,
        crank_angles=tuple(angles),
        ratio=r.choice([20.0, 1.0, 0.05, 39.5, 10 ** r.uniform(-1, 4)]),
        initial_crank_angle=r.choice([0.0, math.pi, -math.pi / 2, r.uniform(-9, 9)]),
    )
    return mechanism, r.choice([1.0, 0.01, 0.25, 2.0, 7.3])


@pytest.mark.parametrize("seed", seeds(24))
def test_pattern_period_repeats_the_counts_and_nothing_shorter_does(seed: int) -> None:
    mechanism, _ = random_mechanism(seed)
    result = cyclogram(mechanism=mechanism)
    speed = 1 + 1 / mpf(mechanism.ratio)
    assert result.period == pytest.approx(float(2 * mp.pi / speed), rel=CONVERGED)
    assert result.working_phase == pytest.approx(float(mp.pi / speed), rel=CONVERGED)
    wave = mpf(result.pattern_period) * speed
    theta = [t for row in phases(mechanism.pins, mechanism.crank_angles) for t in row]

    def is_symmetry(shift: mpf) -> bool:
        """True if the shifted phases are the phases again, one by one."""
        turn = 2 * mp.pi
        left = list(theta)
        for t in theta:
            near = [x for x in left if abs((t + shift - x + mp.pi) % turn - mp.pi) < MERGED * 4]
            if not near:
                return False
            left.remove(near[0])
        return True

    assert is_symmetry(wave)
    # a shorter period would be a whole fraction of this one
    for part in range(2, mechanism.satellites + 1):
        assert not is_symmetry(wave / part)


@pytest.mark.parametrize(
    ("pins", "crank_angles"),
    [
        (1, (0.0,)),
        (1, (0.0, 0.0, 0.0)),
        (1, (0.0, math.pi)),
        (1, (0.0, 0.5, 1.0)),
        (1, (0.0, 2.0, 4.0)),  # gaps 2, 2, 2.28: no dead centre
        (1, (0.0, 2 * math.pi / 3, 4 * math.pi / 3)),
        (2, (0.0,)),
        (2, (0.3, 0.3)),
        (2, (0.3, 0.3 + math.pi)),  # the same phases again
        (2, (0.3, 0.3 + 1e-3)),
        (2, (0.0, math.pi / 2)),
        (3, (0.0,)),
        (3, (1.0, 1.0)),
    ],
)
def test_dead_centres_exist_where_a_gap_of_the_phases_is_half_a_turn(
    pins: int, crank_angles: tuple[float, ...]
) -> None:
    mechanism = Mechanism(pins=pins, crank_angles=crank_angles, ratio=20.0, initial_crank_angle=0.2)
    result = cyclogram(mechanism=mechanism, revolutions=3.0)
    gap = largest_gap(pins, crank_angles)
    assert bool(result.dead_centres) == (gap >= mp.pi - MERGED)
    assert bool(result.dead_zones) == (gap > mp.pi + MERGED)
    for phi in result.dead_centres:
        assert 0 <= phi <= 6 * math.pi
        psi = wave_angle(phi, mechanism.ratio, 0.2)
        largest = max(c for row in cosines(pins, crank_angles, psi) for c in row)
        assert largest < 1e-10
    speed = 1 + 1 / mpf(20)
    for start, end in result.dead_zones:
        assert float((end - start) * speed) <= float(gap - mp.pi) + 1e-10
        middle = wave_angle((start + end) / 2, mechanism.ratio, 0.2)
        assert driving_count(pins, crank_angles, middle) == 0


@pytest.mark.parametrize("turns", [300.0, 1e3])
def test_far_turns_keep_their_digits(turns: float) -> None:
    # turns are counted as integers, so the last interval is as good as the first
    mechanism = Mechanism.evenly_spaced(pins=3, satellites=1, ratio=20.0)
    result = cyclogram(mechanism=mechanism, revolutions=turns)
    end = 2 * mp.pi * mpf(turns)
    for pair in result.pairs:
        theta = 2 * mp.pi * (pair.pin - 1) / 3
        exact = driving_intervals(theta, 20.0, 0.0, end)
        last, exact_last = pair.driving[-1], exact[-1]
        assert len(pair.driving) == len(exact)
        assert last[0] == pytest.approx(float(exact_last[0]), rel=CONVERGED)
        assert last[1] == pytest.approx(float(exact_last[1]), rel=CONVERGED)


@given(
    pins=st.sampled_from([1, 2, 3, 4, 6]),
    sliver=st.floats(-10.5, -7).map(lambda power: 10**power),
    start=st.sampled_from([0.0, 180.0]),
    shown=st.sampled_from([1.0, 20 / 21, 2.0]),
    data=st.data(),
)
def test_the_total_of_a_pair_holds_beside_slivers_at_the_ends_of_the_range(
    pins: int, sliver: float, start: float, shown: float, data: st.DataObject
) -> None:
    cranks = st.sampled_from([0.0, 90.0, 180 - sliver, 180 + sliver, sliver, -sliver])
    angles = data.draw(st.tuples(cranks, cranks))
    mechanism = Mechanism(
        pins=pins,
        crank_angles=tuple(math.radians(angle) for angle in angles),
        ratio=20.0,
        initial_crank_angle=math.radians(start),
    )
    result = cyclogram(mechanism=mechanism, revolutions=shown)
    waves = mpf(shown) * 21 / 20

    def before(position: mpf) -> mpf:
        """Part of the wave over which a pair of phase 0 drives up to a position, in turns."""
        whole = mp.floor(position)
        return whole / 2 + max(position - whole - mpf(1) / 2, mpf(0))

    for pair in result.pairs:
        phase = (mpf(angles[pair.satellite - 1]) + mpf(start)) / 360 + mpf(pair.pin - 1) / pins
        exact = (before(waves + phase) - before(phase)) / waves
        total = sum(stop - first for first, stop in pair.driving) / (2 * math.pi * shown)
        assert abs(total - exact) <= result.accuracy.relative_error


@pytest.mark.parametrize("seed", seeds(20))
def test_assembly_angles_are_those_of_exact_fractions(seed: int) -> None:
    # in turns: (alpha_j - alpha_1)*(z3 - z2)/z2, less the nearest whole number of pitches 1/z2;
    # the same part where it is a whole number of 1/lcm(z2, N)
    r = random.Random(seed)
    pins, teeth, more = r.randint(1, 12), r.randint(5, 120), r.randint(1, 5)
    degrees = [r.choice((15, 24, 90)) * r.randint(-20, 20) for _ in range(r.randint(1, 5))]
    mechanism = Mechanism(pins, tuple(math.radians(each) for each in degrees), teeth / more)
    common = Fraction(1, math.lcm(teeth, pins))
    for found, angle in zip(
        assembly_angles(mechanism=mechanism, satellite_teeth=teeth), degrees, strict=True
    ):
        turned = Fraction((angle - degrees[0]) * more, 360 * teeth)
        left = abs(turned - round(turned * teeth) * Fraction(1, teeth))
        assert found.hole_rotation == pytest.approx(float(2 * left) * math.pi, rel=EXACT, abs=1e-12)
        assert found.identical is (turned % common == 0)
