"""Invariants of the contact forces: equilibrium, symmetries, bounds."""

import math

import numpy as np
import pytest
from hypothesis import given
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
from core.precision import CONVERGED

angles = st.one_of(st.floats(-20.0, 20.0), st.integers(-48, 48).map(lambda k: math.radians(15 * k)))


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
