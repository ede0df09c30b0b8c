"""Satellites that give, and given shares of the torque: limits, invariants, refusals."""

import math
from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from core.errors import ImpossibleMechanism, InvalidInput
from core.output.elasticity import (
    RIGID_SUPPORT,
    CrankSupport,
    ElasticMesh,
    LinearLaw,
    SatelliteSupport,
    Shares,
)
from core.output.mechanism import Mechanism
from core.output.over_turn import over_turn
from core.output.real_mechanism import RealMechanism
from core.output.room import Deviations
from core.precision import SAME, SEARCHED
from tests.inputs.classes import force_error, lag_error
from tests.inputs.real_mechanisms import (
    crank_angles,
    design,
    flat,
    reals,
    solved,
    torques,
)

ONE = design(exact=False)
TWO = replace(ONE, mechanism=Mechanism.evenly_spaced(pins=6, satellites=2, ratio=20.0))
AHEAD = replace(TWO, deviations=Deviations(disc_phase=(0.0, 3e-4)))


def same(found: RealMechanism, expected: RealMechanism, angle: float, torque: float) -> None:
    one, other = solved(found, angle, torque), solved(expected, angle, torque)
    error = force_error(one) + force_error(other)
    assert flat(one) == pytest.approx(flat(other), rel=0, abs=error)
    near = lag_error(expected.pin_circle_radius, one, other)
    assert abs(one.rotation - other.rotation) <= near
    assert one.stiffness == pytest.approx(other.stiffness, rel=SEARCHED)


@given(reals(exact=False), crank_angles, torques, st.sampled_from([CrankSupport(), ElasticMesh]))
def test_what_is_infinitely_stiff_is_rigid(
    real: RealMechanism, angle: float, torque: float, support: object
) -> None:
    rigid = support if isinstance(support, CrankSupport) else ElasticMesh(math.inf)
    same(replace(real, support=rigid), real, angle, torque)


@given(reals(exact=False), crank_angles, torques, st.sampled_from([0.0, 1e-6, 3e-5]))
def test_the_clearance_of_a_bearing_is_half_a_clearance_of_the_holes(
    real: RealMechanism, angle: float, torque: float, loose: float
) -> None:
    """In first order and but for the shape of the contact, so with laws that do not know it."""
    real = replace(real, law=LinearLaw(1e8))
    wider = replace(real, clearance=real.clearance + loose / 2)
    same(replace(real, support=CrankSupport(radial_clearance=loose)), wider, angle, torque)


@given(reals(exact=False), crank_angles, torques)
def test_shares_as_they_are_give_the_rigid_result(
    real: RealMechanism, angle: float, torque: float
) -> None:
    found = solved(real, angle, torque)
    shares = [own / torque for own in found.satellite_torque]
    if min(shares) < 0.05:
        return
    again = solved(
        replace(real, support=Shares(tuple(w / sum(shares) for w in shares))), angle, torque
    )
    # What the shares are known to, over the stiffness of the contacts, moves the forces too.
    error = force_error(found) + force_error(again)
    near = 100 * error + 1e-12 * max(flat(found))
    assert flat(again) == pytest.approx(flat(found), rel=0, abs=near)


def test_equal_shares_of_equal_discs_are_the_rigid_result() -> None:
    even = replace(TWO, mechanism=Mechanism(6, (0.0, 0.0), 20.0))
    same(replace(even, support=Shares((0.5, 0.5))), even, 0.3, 30.0)


def test_shares_multiply_the_ideal_force() -> None:
    """Wang, Luo, Su 2016: 0.55 of the torque, 1.1 of the force of equal shares."""
    even = replace(TWO, clearance=0.0)
    more, equal = (
        over_turn(real=replace(even, support=Shares(shares)), output_torque=30.0)
        for shares in ((0.55, 0.45), (0.5, 0.5))
    )
    assert more.peak_force / equal.peak_force == pytest.approx(1.1, rel=SAME)


@pytest.mark.parametrize("support", [CrankSupport(5e7, 1e-5), ElasticMesh(2e4), Shares((0.6, 0.4))])
def test_the_turn_has_the_positions_between_its_extremes(support: SatelliteSupport) -> None:
    real = replace(AHEAD, support=support)
    turn = over_turn(real=real, output_torque=30.0)
    per_wave = real.mechanism.crank_angle_per_wave
    some = [solved(real, per_wave * (i + 0.3) / 97, 30.0) for i in range(97)]
    highest = max(max(flat(each)) for each in some)
    assert 0.97 * turn.peak_force < highest <= turn.peak_force * (1 + turn.accuracy.relative_error)
    plays = [each.play[1] - each.play[0] for each in some]
    near = 1.001
    assert turn.backlash_min / near <= min(plays) and max(plays) <= turn.backlash_max * near
    stiff = [each.stiffness for each in some]
    assert turn.stiffness_min / near <= min(stiff) and max(stiff) <= turn.stiffness_max * near
    lags = [each.rotation for each in some]
    assert max(lags) - min(lags) <= turn.transmission_error * near
    # Without clearance of the bearings the play is that of rigid satellites or of their linkage.
    if isinstance(support, ElasticMesh):
        rigid = over_turn(real=AHEAD, output_torque=30.0)
        assert turn.backlash_max == pytest.approx(rigid.backlash_max, rel=SAME)
        assert turn.lost_motion > rigid.lost_motion


@pytest.mark.parametrize("decade", [-9, 9])
@pytest.mark.parametrize("kind", [CrankSupport, ElasticMesh])
def test_a_stiffness_ratio_of_a_milliard(kind: type, decade: int) -> None:
    """Supports are much stiffer or much softer than the contacts; soft ones turn further than the
    room unless the torque is small.
    """
    contact = 5e7 if kind is CrankSupport else 5e7 * 0.020**2
    real = replace(AHEAD, clearance=0.0, support=kind(contact * 10.0**decade))
    if decade < 0:
        with pytest.raises(ImpossibleMechanism) as refusal:
            solved(real, 0.3, 30.0)
        assert refusal.value.code == "not_stable"
    torque = 30.0 if decade > 0 else 1e-8
    found = solved(real, 0.3, torque)
    assert sum(found.satellite_torque) == pytest.approx(torque, rel=SAME)
    if decade > 0:
        rigid = solved(replace(real, support=RIGID_SUPPORT), 0.3, torque)
        assert flat(found) == pytest.approx(flat(rigid), rel=SEARCHED, abs=1e-6)


def test_a_pressed_pair_at_its_dead_angle_does_not_hold_the_output() -> None:
    """The pair pushes its disc away; the output turns freely until another pair takes up."""
    pushed = Deviations(pin_radial=(-6.5e-6, 0.0, 0.0))
    real = design(mechanism=Mechanism(3, (0.0,), 2.0), clearance=0.0, deviations=pushed,
                  law=LinearLaw(1e8), exact=False, support=CrankSupport(1e8))  # fmt: skip
    found = solved(real, 0.0, 1e-4)
    assert found.play is None and found.loaded_pairs == 2
    # Half of what is pressed is the contact's, half the bearing's, which the other pair waits for.
    lever = real.pin_circle_radius * math.sin(math.pi / 3)
    assert found.rotation == pytest.approx(6.5e-6 / 2 / lever, rel=1e-3)


def test_interference_of_given_shares_is_that_of_the_worst_disc() -> None:
    """Discs that are turned against each other press only where one output holds both."""
    tight = replace(AHEAD, clearance=1e-6)
    rigid = solved(tight, 0.3, 30.0)
    assert rigid.play is None and rigid.interference > 0
    assert solved(replace(tight, support=ElasticMesh(1e4)), 0.3, 30.0).play is None
    apart = solved(replace(tight, support=Shares((0.5, 0.5))), 0.3, 30.0)
    assert apart.play is not None
    pressed = replace(tight, clearance=-1e-6)
    shared = solved(replace(pressed, support=Shares((0.5, 0.5))), 0.3, 30.0)
    assert shared.play is None
    alone = solved(
        replace(pressed, mechanism=replace(pressed.mechanism, crank_angles=(0.0,)),
                deviations=Deviations()), 0.3, 30.0
    )  # fmt: skip
    assert shared.interference == pytest.approx(alone.interference, rel=0.02)
    loose = solved(replace(pressed, support=CrankSupport(1e8, 1e-5)), 0.3, 30.0)
    assert loose.interference is None or loose.interference < rigid.interference + 2e-6


def test_one_pin_and_two() -> None:
    quarter = -math.pi / 2 / (1 + 1 / 18)
    for support in (CrankSupport(1e8), ElasticMesh(1e5), Shares((1.0,))):
        one = design(mechanism=Mechanism(1, (0.0,), 18.0), exact=False, support=support)
        assert max(flat(solved(one, quarter, 1.0))) == pytest.approx(50, rel=SAME)
        two = replace(one, mechanism=Mechanism(2, (0.0,), 18.0))
        for real, angle in ((one, -quarter), (two, 0.0)):
            with pytest.raises(ImpossibleMechanism) as refusal:
                solved(real, angle, 30.0)
            assert refusal.value.code in {"dead_centre", "not_stable"}


@pytest.mark.parametrize(
    ("changes", "parameter", "code"),
    [
        ({"support": CrankSupport(0.0)}, "stiffness", "greater_than"),
        ({"support": CrankSupport(1e8, -1e-6)}, "radial_clearance", "greater_than_equal"),
        ({"support": CrankSupport(1e8, math.inf)}, "radial_clearance", "greater_than_equal"),
        ({"support": ElasticMesh(math.nan)}, "stiffness", "greater_than"),
        ({"support": Shares((1.0,))}, "shares", "different_length"),
        ({"support": Shares((1.5, -0.5))}, "shares[1]", "greater_than"),
    ],
)
def test_what_is_refused(changes: dict, parameter: str, code: str) -> None:
    with pytest.raises(InvalidInput) as refusal:
        replace(TWO, **changes)
    assert (refusal.value.parameter, refusal.value.code) == (parameter, code)


def test_shares_add_up_to_the_whole() -> None:
    with pytest.raises(InvalidInput) as refusal:
        Shares((0.5, 0.4))
    assert (refusal.value.parameter, refusal.value.code) == ("shares", "sum_not_one")
