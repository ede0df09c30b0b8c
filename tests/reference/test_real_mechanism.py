"""Clearance, deviations and elasticity against bisection over vectors at 45 digits."""

import pytest
from hypothesis import given, settings

from core.output.contact_law import PowerLaw
from core.output.real_mechanism import RealMechanism
from tests.oracles.load_sharing import exact_position
from tests.oracles.real_mechanisms import crank_angles, design, flat, reals, solved, torques


@settings(max_examples=30)
@given(reals(), crank_angles, torques)
def test_forces_lag_and_play_are_within_their_stated_errors(
    real: RealMechanism, angle: float, torque: float
) -> None:
    found = solved(real, angle, torque)
    exact = exact_position(real, angle, torque)
    assert abs(found.rotation - exact.rotation) <= found.rotation_error
    for force, expected in zip(flat(found), exact.force, strict=True):
        assert abs(force - expected) <= found.force_error
    assert (found.play is None) == (exact.play is None)
    if found.play is not None:
        for limit, expected in zip(found.play, exact.play, strict=True):
            assert abs(limit - expected) <= found.play_error + 1e-40  # of the oracle
    # Below the exponent 1 small forces hang on approaches beyond any digits of the sizes.
    stiff = isinstance(real.law, PowerLaw) and real.law.exponent < 1
    if max(exact.force) > 1 and not found.interference and not stiff:
        assert found.accuracy.relative_error < 1e-9


@pytest.mark.parametrize("exact", [False, True])
@pytest.mark.parametrize("torque", [1e-8, 1e-6, 1e-4, 1e-2, 1.0, 1e2, 3e2])
def test_loads_over_many_decades(torque: float, exact: bool) -> None:
    real = design(exact=exact)
    found = solved(real, 0.1, torque)
    exact_forces = exact_position(real, 0.1, torque).force
    largest = max(exact_forces)
    for force, expected in zip(flat(found), exact_forces, strict=True):
        assert abs(force - expected) <= 1e-13 * largest


@pytest.mark.parametrize("clearance", [0.0, 1e-12, 1e-6, 1e-4, 1e-3])
def test_clearance_up_to_the_eccentricity(clearance: float) -> None:
    found = solved(design(clearance=clearance), 0.1, 1.0)
    exact = exact_position(design(clearance=clearance), 0.1, 1.0)
    assert flat(found) == pytest.approx(list(map(float, exact.force)), abs=1e-12)
