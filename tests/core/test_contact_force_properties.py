"""Invariants of the contact forces: equilibrium, symmetries, bounds."""

import math

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from core.errors import InvalidInput
from core.output.contact_force import (
    PeakForce,
    approximate_peak_ratio,
    approximation_notices,
    contact_force,
    force_ratios,
    output_torque_from_input,
    peak_force,
    reference_force,
)
from core.output.force_laws import depressed_cubic_roots
from core.output.mechanism import Mechanism
from core.precision import CONVERGED, EXACT

angles = st.one_of(st.floats(-20.0, 20.0), st.integers(-48, 48).map(lambda k: math.radians(15 * k)))
exponents = st.one_of(
    st.sampled_from([0.0, 1e-9, 0.3, 1.0, 10 / 9, 1.5, 3.0, 20.0, 120.0, 500.0]),
    st.floats(0.0, 10.0),
)


three_pins_or_more = st.integers(3, 13)


@st.composite
def mechanisms(draw: st.DrawFn, pins: st.SearchStrategy[int] = three_pins_or_more) -> Mechanism:
    """Three pins or more: no dead centre anywhere."""
    return Mechanism(
        pins=draw(pins),
        crank_angles=tuple(draw(st.lists(angles, min_size=1, max_size=6))),
        ratio=draw(st.one_of(st.just(20.0), st.floats(0.1, 1000.0))),
        initial_crank_angle=draw(angles),
    )


def cosines(mechanism: Mechanism, phi: float) -> np.ndarray:  # type: ignore[type-arg]
    """cos(gamma) of every pair as P2 eq. (6) says, sign and all."""
    psi = phi * (1 + 1 / mechanism.ratio) + mechanism.initial_crank_angle
    pin = 2 * math.pi * np.arange(mechanism.pins) / mechanism.pins
    found: np.ndarray = -np.sin(psi + np.add.outer(mechanism.crank_angles, pin))  # type: ignore[type-arg]
    return found


def changed(mechanism: Mechanism, **changes: object) -> Mechanism:
    values: dict[str, object] = {
        "pins": mechanism.pins,
        "crank_angles": mechanism.crank_angles,
        "ratio": mechanism.ratio,
        "initial_crank_angle": mechanism.initial_crank_angle,
    }
    return Mechanism(**(values | changes))  # type: ignore[arg-type]


@given(mechanisms(), exponents, st.floats(-7.0, 7.0))
def test_forces_are_in_equilibrium_with_the_torque(
    mechanism: Mechanism, exponent: float, phi: float
) -> None:
    # sum F*R*cos(gamma) = T, in units of F0*R = T. The angles of the sum have rounding of their
    # own: 1e-15 of up to 80 rad of wave, through v times the slope of the forces.
    found = force_ratios(
        mechanism=mechanism, crank_angles=np.array([phi]), force_exponent=exponent
    )[0]
    assert (found >= 0).all()
    assert (found * cosines(mechanism, phi)).sum() == pytest.approx(1.0, abs=1e-12)


@given(mechanisms(), exponents, st.floats(-7.0, 7.0))
def test_forces_follow_the_law_of_the_approach(
    mechanism: Mechanism, exponent: float, phi: float
) -> None:
    # F_i/F_j = (cos_i/cos_j)^v for any two driving pairs, none for the others
    found = force_ratios(
        mechanism=mechanism, crank_angles=np.array([phi]), force_exponent=exponent
    )[0]
    cosine = cosines(mechanism, phi)
    assume(np.abs(cosine).min() > 1e-6)
    assert ((found > 0) <= (cosine > 0)).all()
    best = np.unravel_index(int(np.argmax(cosine)), cosine.shape)
    law = np.where(cosine > 0, (np.maximum(cosine, 0) / cosine[best]) ** exponent, 0.0)
    assert found / found[best] == pytest.approx(law, rel=EXACT * (1 + exponent), abs=1e-300)


@given(mechanisms(), exponents, st.floats(-7.0, 7.0))
def test_reversing_the_torque_loads_the_idle_pairs(
    mechanism: Mechanism, exponent: float, phi: float
) -> None:
    assume(np.abs(cosines(mechanism, phi)).min() > 1e-6)
    reverse = changed(mechanism, initial_crank_angle=mechanism.initial_crank_angle + math.pi)
    at = np.array([phi])
    # two satellites: where one direction leaves pairs idle the other drives just these
    forward = force_ratios(mechanism=mechanism, crank_angles=at, force_exponent=0.5)
    backward = force_ratios(mechanism=reverse, crank_angles=at, force_exponent=0.5)
    assert ((forward > 0) != (backward > 0)).all()
    # and half a wave turn later everything is as with the torque reversed
    later = at + math.pi / (1 + 1 / mechanism.ratio)
    half_turn = force_ratios(mechanism=mechanism, crank_angles=later, force_exponent=exponent)
    backward = force_ratios(mechanism=reverse, crank_angles=at, force_exponent=exponent)
    assert half_turn == pytest.approx(backward, rel=EXACT * (1 + exponent), abs=1e-12)


@given(mechanisms(), exponents)
def test_reversing_the_torque_keeps_the_peak(mechanism: Mechanism, exponent: float) -> None:
    reverse = changed(mechanism, initial_crank_angle=mechanism.initial_crank_angle + math.pi)
    one = peak_force(mechanism=mechanism, force_exponent=exponent)
    other = peak_force(mechanism=reverse, force_exponent=exponent)
    stated = one.accuracy.relative_error + other.accuracy.relative_error
    tolerance = stated + 1e-14 * (1 + exponent)
    assert one.peak_force_ratio == pytest.approx(other.peak_force_ratio, rel=tolerance)


@given(mechanisms(), exponents, st.floats(-7, 7), st.randoms(use_true_random=False))
def test_order_start_and_pin_pitches_do_not_change_the_peak(  # type: ignore[no-untyped-def]
    mechanism: Mechanism, exponent: float, turn: float, random
) -> None:
    cranks = list(mechanism.crank_angles)
    random.shuffle(cranks)
    pitch = 2 * math.pi / mechanism.pins
    moved = [a + turn + pitch * random.randint(-3, 3) for a in cranks]
    other = changed(mechanism, crank_angles=tuple(moved), ratio=3.0)
    one = peak_force(mechanism=mechanism, force_exponent=exponent)
    two = peak_force(mechanism=other, force_exponent=exponent)
    stated = one.accuracy.relative_error + two.accuracy.relative_error
    # moving the cranks has rounding of its own, some 1e-14 rad
    tolerance = stated + 2e-14 * (10 + exponent)
    assert one.peak_force_ratio == pytest.approx(two.peak_force_ratio, rel=tolerance)


@given(mechanisms(), exponents)
def test_no_sample_of_the_turn_exceeds_the_peak(mechanism: Mechanism, exponent: float) -> None:
    peak = peak_force(mechanism=mechanism, force_exponent=exponent)
    wave = np.linspace(0, 2 * math.pi / (1 + 1 / mechanism.ratio), 2001)
    forces = force_ratios(mechanism=mechanism, crank_angles=wave, force_exponent=exponent)
    excess = float(forces.max()) / peak.peak_force_ratio - 1
    # grid and peak see the phases with 1e-15 of rounding each, and as merged within 6e-12 rad
    assert excess <= peak.accuracy.relative_error + 1e-13 * (1 + exponent)
    # and the sampled maximum is not far below, unless the peak is too narrow for the grid
    assert excess >= -0.004 * (1 + exponent)


@given(mechanisms(), exponents)
def test_the_named_pair_carries_the_peak_at_the_named_angle(
    mechanism: Mechanism, exponent: float
) -> None:
    peak = peak_force(mechanism=mechanism, force_exponent=exponent)
    at = np.array([peak.peak_crank_angle])
    forces = force_ratios(mechanism=mechanism, crank_angles=at, force_exponent=exponent)[0]
    pair = forces[peak.peak_satellite - 1, peak.peak_pin - 1]
    tolerance = 1e-11 * (10 + exponent)
    assert pair == pytest.approx(peak.peak_force_ratio, rel=tolerance)
    assert 0 <= peak.peak_crank_angle < 2 * math.pi


@given(mechanisms(), exponents, st.integers(2, 4))
def test_doubling_every_satellite_halves_every_force(
    mechanism: Mechanism, exponent: float, times: int
) -> None:
    doubled = changed(mechanism, crank_angles=mechanism.crank_angles * times)
    one = peak_force(mechanism=mechanism, force_exponent=exponent)
    many = peak_force(mechanism=doubled, force_exponent=exponent)
    assert many.peak_force_ratio * times == pytest.approx(one.peak_force_ratio, rel=CONVERGED)


@given(mechanisms(), exponents)
def test_peak_lies_between_equal_sharing_and_one_pair_alone(
    mechanism: Mechanism, exponent: float
) -> None:
    pairs = mechanism.pins * mechanism.satellites
    ratio = peak_force(mechanism=mechanism, force_exponent=exponent).peak_force_ratio
    # never less than an equal share of all that can drive; never more than one pair alone needs
    # at the worst place of the best pair, half a pin pitch from its middle
    assert ratio >= 1 / pairs
    assert ratio <= 1 / math.cos(math.pi / mechanism.pins) * (1 + 1e-12)


@given(st.floats(0, 1e6), st.floats(1e-3, 10), st.floats(0.1, 100), st.floats(0.01, 1.0))
def test_torque_and_reference_force(
    torque: float, radius: float, ratio: float, efficiency: float
) -> None:
    force = reference_force(output_torque=torque, pin_circle_radius=radius)
    assert force * radius == pytest.approx(torque, rel=CONVERGED)
    output = output_torque_from_input(input_torque=torque, ratio=ratio, efficiency=efficiency)
    assert output == pytest.approx(torque * ratio * efficiency, rel=CONVERGED)


@pytest.mark.parametrize("exponent", [-1.0, -1e-300, math.nan, math.inf, 1e300])
def test_exponents_that_mean_nothing_are_refused(exponent: float) -> None:
    mechanism = Mechanism.evenly_spaced(pins=3, satellites=2, ratio=20.0)
    with pytest.raises(InvalidInput) as refusal:
        peak_force(mechanism=mechanism, force_exponent=exponent)
    assert refusal.value.parameter == "force_exponent"
    assert exponent >= 0 or "must be at least 0" in str(refusal.value)
    with pytest.raises(InvalidInput):
        force_ratios(mechanism=mechanism, crank_angles=np.zeros(1), force_exponent=exponent)


@pytest.mark.parametrize("efficiency", [0.0, -0.1, 1.1, math.nan])
def test_efficiencies_that_cannot_be_are_refused(efficiency: float) -> None:
    with pytest.raises(InvalidInput) as refusal:
        output_torque_from_input(input_torque=1.0, ratio=20.0, efficiency=efficiency)
    assert refusal.value.parameter == "efficiency"


@pytest.mark.parametrize("radius", [0.0, -1.0, math.nan])
def test_pin_circles_that_cannot_be_are_refused(radius: float) -> None:
    with pytest.raises(InvalidInput) as refusal:
        reference_force(output_torque=1.0, pin_circle_radius=radius)
    assert refusal.value.parameter == "pin_circle_radius"


@given(st.integers(1, 20), st.integers(1, 6), st.sampled_from([0.0, 1.0, 1.5]), angles)
def test_approximation_is_flagged_outside_its_range(
    pins: int, satellites: int, exponent: float, spacing: float
) -> None:
    mechanism = Mechanism.evenly_spaced(
        pins=pins, satellites=satellites, ratio=20.0, crank_spacing=spacing
    )
    flagged = bool(approximation_notices(mechanism=mechanism, force_exponent=exponent))
    opposite = satellites != 2 or abs(math.remainder(spacing - math.pi, 2 * math.pi)) < 1e-11
    inside = 3 <= pins <= 5 and satellites <= 2 and exponent == 1 and opposite
    assert flagged != inside
    exact = (0.8 + 0.05 * pins) ** (2 - satellites) * 4 / (satellites * pins)
    assert approximate_peak_ratio(pins=pins, satellites=satellites) == pytest.approx(exact)


coefficients = st.one_of(st.just(0.0), st.floats(1e-30, 1e6), st.floats(-1e6, -1e-30))


@given(coefficients, coefficients)
def test_roots_of_the_cubic_are_roots(linear: float, constant: float) -> None:
    roots = depressed_cubic_roots(linear, constant)
    assert len(roots) in (1, 3)
    for t in roots:
        # a root near 0 beside large ones is known to the rounding of the large ones
        size = abs(t) ** 3 + abs(linear) * max(abs(t), math.sqrt(abs(linear))) + abs(constant)
        assert abs(t**3 + linear * t + constant) <= 1e-14 * size + 1e-300
    # one root at least, three where the discriminant says so clearly
    discriminant = -4 * linear**3 - 27 * constant**2
    clear = 1e-9 * (4 * abs(linear) ** 3 + 27 * constant**2)
    if discriminant > clear:
        assert len(roots) == 3
    if discriminant < -clear:
        assert len(roots) == 1


@given(st.integers(-9, 9), st.integers(-9, 9))
def test_roots_of_a_cubic_known_beforehand(first: int, second: int) -> None:
    third = -first - second
    linear = first * second + (first + second) * third
    constant = -first * second * third
    roots = sorted(depressed_cubic_roots(float(linear), float(constant)))
    expected = sorted([first, second, third])
    if len(roots) == 3:
        # a double root is known to half the digits
        assert roots == pytest.approx(expected, abs=1e-6)
    else:
        assert any(abs(roots[0] - e) < 1e-6 for e in expected)


def test_the_peak_of_a_mechanism_is_searched_for_once(monkeypatch: pytest.MonkeyPatch) -> None:
    searched = []

    def counted(**given: object) -> PeakForce:
        searched.append(given)
        return peak_force(**given)  # type: ignore[arg-type]

    monkeypatch.setattr("core.output.contact_force.peak_force", counted)
    mechanism = Mechanism(pins=5, crank_angles=(0.0, 1.2345678), ratio=20.0)
    sizes = [(float(torque), 0.04) for torque in range(1, 20)]
    forces = [
        contact_force(mechanism=mechanism, output_torque=torque, pin_circle_radius=radius)
        for torque, radius in sizes
    ]
    assert len(searched) == 1
    assert forces[9].peak_force == pytest.approx(10 * forces[0].peak_force, rel=CONVERGED)


@pytest.mark.parametrize(("gap", "codes"), [(1e-9, []), (1e-11, ["hardly_known"])])
def test_a_peak_beside_a_dead_centre_says_that_hardly_anything_is_known(
    gap: float, codes: list[str]
) -> None:
    mechanism = Mechanism(pins=2, crank_angles=(0.0, math.pi - gap), ratio=20.0)
    force = contact_force(
        mechanism=mechanism, output_torque=1.0, pin_circle_radius=1.0, force_exponent=10.0
    )
    assert [notice.code for notice in force.notices] == codes
