"""Clearance, deviations and elasticity against bisection over vectors at 45 digits."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from core.errors import ImpossibleMechanism
from core.output.elasticity import RIGID_SUPPORT, LinearLaw, PinSupport, PowerLaw, pin_compliance
from core.output.mechanism import Mechanism
from core.output.real_mechanism import RealMechanism
from tests.inputs.classes import force_error, lag_error, play_error
from tests.inputs.real_mechanisms import (
    STEEL,
    crank_angles,
    design,
    flat,
    held,
    reals,
    solved,
    torques,
)
from tests.oracles.load_sharing import exact_position


@given(st.one_of(reals(), held()), crank_angles, torques)
def test_forces_lag_and_play_are_within_their_stated_errors(
    real: RealMechanism, angle: float, torque: float
) -> None:
    found = solved(real, angle, torque)
    exact = exact_position(real, angle, torque)
    assert abs(found.rotation - exact.rotation) <= lag_error(real.pin_circle_radius, found)
    for force, expected in zip(flat(found), exact.force, strict=True):
        assert abs(force - expected) <= force_error(found)
    assert (found.play is None) == (exact.play is None)
    if found.play is not None:
        for limit, expected in zip(found.play, exact.play, strict=True):
            assert abs(limit - expected) <= play_error(found) + 1e-40  # of the oracle
    # Discs that give make forces hang less on rounding.
    stiff = isinstance(real.law, PowerLaw) and real.law.exponent < 1
    gives = real.support is not RIGID_SUPPORT
    if gives and max(exact.force) > 1 and not found.interference and not stiff:
        assert force_error(found) < 1e-9 * max(exact.force)


@pytest.mark.parametrize("exact", [False, True])
@pytest.mark.parametrize("torque", [3e-10, 1e-8, 1e-6, 1e-4, 1e-2, 1.0, 1e2, 3e2])
def test_loads_over_many_decades(torque: float, exact: bool) -> None:
    real = design(exact=exact)
    found = solved(real, 0.1, torque)
    exact_forces = exact_position(real, 0.1, torque).force
    largest = max(exact_forces)
    for force, expected in zip(flat(found), exact_forces, strict=True):
        assert abs(force - expected) <= 1e-13 * largest


@pytest.mark.parametrize(
    "clearance", [0.0, 1e-12, 1e-6, 1e-4, 1e-3, 1.4e-3, 1.5e-3, 1.6e-3, 3e-3, 4e-3]
)
def test_nothing_happens_where_the_clearance_passes_the_eccentricity(clearance: float) -> None:
    found = solved(design(clearance=clearance), 0.1, 1.0)
    exact = exact_position(design(clearance=clearance), 0.1, 1.0)
    assert flat(found) == pytest.approx(list(map(float, exact.force)), abs=1e-12)


@pytest.mark.parametrize("exact", [False, True])
@pytest.mark.parametrize("stiffness", [5e7, 5e10, 5e13, 5e16])
def test_contacts_a_milliard_times_as_stiff(stiffness: float, exact: bool) -> None:
    """The effect of rounded approaches grows with the stiffness, and is stated."""
    real = design(law=LinearLaw(stiffness), exact=exact)
    found, known = solved(real, 0.1, 30.0), exact_position(real, 0.1, 30.0)
    for force, expected in zip(flat(found), known.force, strict=True):
        assert abs(force - expected) <= force_error(found)
    assert found.accuracy.relative_error < (1e-10 if stiffness < 1e11 else 1e-5)


@pytest.mark.parametrize("exact", [False, True])
def test_a_pin_a_milliard_times_as_soft_as_its_contact(exact: bool) -> None:
    bent = PinSupport("cantilever", 0.006, (0.02,), STEEL)
    gives = pin_compliance(bent)[0]
    for law in (LinearLaw(1e9 / gives), PowerLaw(1.5, 1e3, 1e3 * gives / 1e9)):
        real = design(law=law, pin=bent, exact=exact)
        found, known = solved(real, 0.1, 30.0), exact_position(real, 0.1, 30.0)
        for force, expected in zip(flat(found), known.force, strict=True):
            assert abs(force - expected) <= force_error(found)


@pytest.mark.parametrize("pins", [1, 2])
@pytest.mark.parametrize("exact", [False, True])
def test_one_pin_and_two_have_a_right_answer_or_a_refusal(pins: int, exact: bool) -> None:
    """At every position, the dead centres and their sides too."""
    real = design(mechanism=Mechanism.evenly_spaced(pins=pins, satellites=1, ratio=18.0),
                  exact=exact)  # fmt: skip
    codes, answered = set(), 0
    for wave in (
        0.0,
        1e-12,
        1e-3,
        0.1,
        1.0,
        math.pi / 2,
        math.pi - 1e-6,
        math.pi,
        4.0,
        4.7,
        5.5,
        6.28,
    ):
        angle = wave / (1 + 1 / 18)
        try:
            found = solved(real, angle, 30.0)
        except ImpossibleMechanism as refusal:
            codes.add(refusal.code)
            continue
        known = exact_position(real, angle, 30.0)
        assert abs(found.rotation - known.rotation) <= lag_error(real.pin_circle_radius, found)
        for force, expected in zip(flat(found), known.force, strict=True):
            assert abs(force - expected) <= force_error(found)
        answered += 1
    assert answered >= 3 and codes <= {"dead_centre", "not_stable"}
