"""Friction of the pins: reference numbers, oracle, invariants, arrays, refusals."""

import math

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from core.errors import ImpossibleMechanism, InvalidInput, is_known
from core.numerics.quadrature import tanh_sinh_rule
from core.output.contact_force import force_ratios
from core.output.losses import BarePins, Sleeves, TotalForce, loss_curves, total_force
from core.output.mechanism import Mechanism, pin_geometry
from core.precision import CONVERGED, EXACT, SAME
from tests.inputs.loads import pin_losses
from tests.oracles.losses import total

REFERENCE = {
    "output_torque": 500.0,
    "pin_circle_radius": 0.05,
    "input_speed": 1500 * math.pi / 30,
    "output_power": 500.0 * 1500 * math.pi / 30 / 20,
    "eccentricity": 0.002,
    "pin_radius": 0.008,
    "contact_length": 0.02,
    "friction_coefficient": 0.08,
    "wear_rate": 1e-17,
    "life": 3000 * 3600.0,
    "rubbing": BarePins(0.010),
}
SIX_PINS = Mechanism.evenly_spaced(pins=6, satellites=2, ratio=20.0)

exponents = st.one_of(
    st.sampled_from([0.0, 1e-9, 0.3, 1.0, 10 / 9, 1.5, 3.0, 120.0]), st.floats(0.0, 10.0)
)


@st.composite
def mechanisms(draw: st.DrawFn) -> Mechanism:
    """Three pins or more, cranks at whole degrees: no dead centre."""
    degrees = draw(st.lists(st.integers(0, 359), min_size=1, max_size=4))
    return Mechanism(
        pins=draw(st.integers(3, 9)),
        crank_angles=tuple(math.radians(each) for each in degrees),
        ratio=draw(st.floats(0.5, 100.0)),
        initial_crank_angle=math.radians(draw(st.integers(-180, 180))),
    )


def test_the_reference_design() -> None:
    found = pin_losses(mechanism=SIX_PINS, **REFERENCE)
    assert found.relative_speed == pytest.approx(1575 * math.pi / 30, rel=CONVERGED)
    assert round(found.sliding_speed, 6) == 0.329867
    assert found.mean_loss == pytest.approx(336.0, rel=CONVERGED)
    assert round(found.output_power, 2) == 3926.99
    assert round(found.efficiency, 6) == 0.921182
    assert round(found.min_efficiency, 6) == 0.917768
    assert round(found.peak_pv / 1e6, 5) == 3.43612
    assert found.mean_pv / 1e6 == pytest.approx(1.09375, rel=CONVERGED)
    assert found.pin_wear == pytest.approx(0.118125e-3, rel=CONVERGED)
    assert found.hole_wear == pytest.approx(0.0945e-3, rel=CONVERGED)
    assert found.friction_couple == pytest.approx(
        4 * 0.08 * 0.008 / (math.pi * 0.05), rel=CONVERGED
    )
    assert found.sleeve_speed is None
    assert found.notices == ()
    turns = 1575 * 60 * 3000
    assert found.pin_wear / turns == pytest.approx(4.1666666666667e-13, rel=CONVERGED)


def test_the_reference_design_with_sleeves() -> None:
    bare = pin_losses(mechanism=SIX_PINS, **REFERENCE)
    found = pin_losses(mechanism=SIX_PINS, **REFERENCE | {"rubbing": Sleeves(0.011)})
    assert found.mean_loss == pytest.approx(231.0, rel=CONVERGED)
    assert round(found.efficiency, 6) == 0.944444
    assert found.sleeve_speed == pytest.approx(bare.relative_speed / 4, rel=CONVERGED)
    assert found.peak_pv == bare.peak_pv  # whatever the bore
    assert found.pin_wear == bare.pin_wear
    assert not is_known(lambda: found.hole_wear)
    assert found.notices == ()


def test_a_given_hole_is_worn_over_its_own_circumference() -> None:
    bare = pin_losses(mechanism=SIX_PINS, **REFERENCE)
    found = pin_losses(mechanism=SIX_PINS, **REFERENCE | {"rubbing": BarePins(0.0105)})
    assert found.hole_wear / bare.hole_wear == pytest.approx(10 / 10.5, rel=CONVERGED)


@pytest.mark.parametrize(
    ("pins", "satellites", "exponent", "mean"),
    [
        (3, 1, 1.0, "1.355738"),
        (5, 1, 1.0, "1.274756"),
        (3, 1, 0.0, "1.573646"),
        (6, 1, 0.0, "1.573646"),
        (3, 2, 1.0, "1.273240"),
        (4, 1, 1.0, "1.273240"),
    ],
)
def test_mean_of_the_total_force(pins: int, satellites: int, exponent: float, mean: str) -> None:
    m = Mechanism.evenly_spaced(pins=pins, satellites=satellites, ratio=20.0)
    assert f"{total_force(mechanism=m, force_exponent=exponent).mean:.6f}" == mean


@pytest.mark.parametrize("pins", [4, 6, 8, 3])
def test_an_even_number_of_phases_has_a_closed_form(pins: int) -> None:
    """The closed form equals the integral, which a slightly different exponent uses."""
    m = Mechanism.evenly_spaced(pins=pins, satellites=2 if pins % 2 else 1, ratio=20.0)
    closed = total_force(mechanism=m)
    near = total_force(mechanism=m, force_exponent=1 + 1e-12)
    assert closed.accuracy.method == "closed_form_even"
    assert near.accuracy.method == "segments_tanh_sinh"
    assert closed.mean == 4 / math.pi
    for name in ("mean", "least", "largest"):
        assert getattr(near, name) == pytest.approx(getattr(closed, name), rel=SAME)


@pytest.mark.parametrize(
    ("pins", "degrees", "exponent"),
    [
        (3, [0.0], 0.3),
        (3, [0.0], 1e-9),
        (3, [0.0, 109.0], 2.5),
        (3, [0.0, 90.0, 91.0], 1.0),
        (3, [0.0, 120.0, 40.0], 0.05),
        (4, [0.0, 33.0], 0.0),
        (5, [0.0, 20.0, 70.0], 0.0),  # largest where pairs begin to drive, not where they end
        (5, [0.0, -20.0, -70.0], 0.0),
        (2, [0.0, 0.06], 1.0),
        (1, [0.0, 179.99, 90.0, 270.0], 1.5),
        (5, [0.0], 120.0),
        (5, [0.0, 1e-8], 1e4),
        (7, [0.0, 51.0], 500.0),
    ],
)
def test_against_integral_and_search_at_30_digits(
    pins: int, degrees: list[float], exponent: float
) -> None:
    angles = [math.radians(each) for each in degrees]
    found = total_force(
        mechanism=Mechanism(pins=pins, crank_angles=tuple(angles), ratio=20.0),
        force_exponent=exponent,
    )
    exact = total(pins, angles, exponent)
    for name in ("mean", "least", "largest"):
        true = getattr(exact, name)
        assert abs(getattr(found, name) - true) <= found.accuracy.relative_error * true, name
    assert found.accuracy.relative_error < 1e-8


@example(mechanism=Mechanism(pins=8, crank_angles=(0.0,), ratio=1.0), exponent=0.125, place=0.0)
@given(mechanism=mechanisms(), exponent=exponents, place=st.floats(0, 1))
def test_the_total_force_lies_between_its_extremes(
    mechanism: Mechanism, exponent: float, place: float
) -> None:
    found = total_force(mechanism=mechanism, force_exponent=exponent)
    angles = mechanism.crank_angle_per_wave * (place + np.arange(4096) / 4096)
    sums = force_ratios(mechanism=mechanism, crank_angles=angles, force_exponent=exponent).sum(
        axis=(1, 2)
    )
    room = 1e-9 * found.largest
    assert 1 - room <= found.least <= found.mean <= found.largest  # no cosine is above 1
    if exponent == 0:
        return  # the sum jumps where pairs switch, and just there neither of them drives
    assert found.least - room <= sums.min()
    assert sums.max() <= found.largest + room
    # a mean over so many places is off by no more than what changes between neighbours
    assert sums.mean() == pytest.approx(found.mean, abs=0.02 * (found.largest - found.least) + room)


@example(  # pairs of both satellites switch at the same place, but for rounding
    mechanism=Mechanism(pins=6, crank_angles=(0.0, 4.60766922526503), ratio=1.0),
    exponent=0.1,
    turn=-263,
)
@given(mechanism=mechanisms(), exponent=exponents, turn=st.integers(-360, 360))
def test_the_mean_does_not_depend_on_where_the_crank_starts(
    mechanism: Mechanism, exponent: float, turn: int
) -> None:
    turned = Mechanism(
        pins=mechanism.pins,
        crank_angles=tuple(each + math.radians(turn) for each in mechanism.crank_angles),
        ratio=2 * mechanism.ratio,
    )
    one = total_force(mechanism=mechanism, force_exponent=exponent)
    other = total_force(mechanism=turned, force_exponent=exponent)
    error = one.accuracy.relative_error + other.accuracy.relative_error
    for name in ("mean", "least", "largest"):
        assert getattr(one, name) == pytest.approx(getattr(other, name), rel=error)


@pytest.mark.parametrize("ratio", [20.0, 0.5])
@pytest.mark.parametrize("angle", [0.1, 2.0])
def test_sliding_speed_is_that_of_the_satellite_against_the_output(
    ratio: float, angle: float
) -> None:
    """Positions of hole and pin, seen from the output link, differentiated."""
    m = Mechanism.evenly_spaced(pins=3, satellites=1, ratio=ratio)
    sizes = {"pin_radius": 0.008, "hole_radius": 0.010, "pin_circle_radius": 0.05}

    def seen(crank_angle: float) -> complex:
        at = pin_geometry(mechanism=m, crank_angle=crank_angle, eccentricity=0.002, **sizes)
        apart, pin = (complex(*each) for each in (at.hole_centres[0, 0], at.pin_centres[0]))
        return (apart - pin) / (pin / abs(pin))

    step = 1e-5
    speed = abs(seen(angle + step) - seen(angle - step)) / (2 * step) * REFERENCE["input_speed"]
    found = pin_losses(mechanism=m, **REFERENCE)
    assert found.sliding_speed == pytest.approx(speed, rel=EXACT)


def test_curves_pass_through_the_extremes() -> None:
    losses = pin_losses(mechanism=SIX_PINS, **REFERENCE)
    angles = SIX_PINS.crank_angle_per_wave * np.arange(12) / 12
    curves = loss_curves(losses=losses, mechanism=SIX_PINS, force_exponent=1.0, crank_angle=angles)
    assert curves.efficiency.min() == pytest.approx(losses.min_efficiency, rel=CONVERGED)
    assert curves.efficiency.max() == pytest.approx(losses.max_efficiency, rel=CONVERGED)
    assert curves.loss.max() / losses.mean_loss == pytest.approx(math.pi / 3, rel=CONVERGED)


def test_arrays_of_designs_are_their_single_ones() -> None:
    radii, lengths = np.array([0.04, 0.05, 0.06])[:, None], np.array([0.01, 0.02])
    many = pin_losses(
        mechanism=SIX_PINS,
        **REFERENCE
        | {"pin_circle_radius": radii, "contact_length": lengths}
        | {"rubbing": Sleeves(np.array([0.010, 0.012]))},
    )
    for i, radius in enumerate(radii[:, 0]):
        for j, length in enumerate(lengths):
            sizes = {"pin_circle_radius": float(radius), "contact_length": float(length)}
            own = {"rubbing": Sleeves((0.010, 0.012)[j])}
            one = pin_losses(mechanism=SIX_PINS, **REFERENCE | sizes | own)
            for name in ("mean_loss", "efficiency", "peak_pv", "pin_wear", "sleeve_speed"):
                value = getattr(many, name)
                assert np.broadcast_to(value, (3, 2))[i, j] == getattr(one, name), name


def test_what_cannot_be_is_refused() -> None:
    with pytest.raises(InvalidInput) as refusal:
        pin_losses(mechanism=SIX_PINS, **REFERENCE | {"rubbing": Sleeves(0.016)})
    assert (refusal.value.parameter, refusal.value.code) == ("diameter", "no_sleeve")
    with pytest.raises(InvalidInput) as refusal:
        pin_losses(mechanism=SIX_PINS, **REFERENCE | {"rubbing": Sleeves(np.array([0.01, 0.017]))})
    assert refusal.value.parameter == "diameter[1]"
    with pytest.raises(InvalidInput) as refusal:
        pin_losses(mechanism=SIX_PINS, **REFERENCE | {"rubbing": Sleeves(0.0)})
    assert refusal.value.parameter == "diameter"
    wrong = {"friction_coefficient": -0.1, "input_speed": -1.0, "life": -1.0}
    wrong["wear_rate"] = -1e-17
    for name, value in wrong.items():
        with pytest.raises(InvalidInput) as refusal:
            pin_losses(mechanism=SIX_PINS, **REFERENCE | {name: value})
        assert refusal.value.parameter == name
    with pytest.raises(ImpossibleMechanism):
        pin_losses(mechanism=Mechanism.evenly_spaced(pins=2, satellites=1, ratio=20), **REFERENCE)


def test_without_friction_nothing_is_lost() -> None:
    found = pin_losses(mechanism=SIX_PINS, **REFERENCE | {"friction_coefficient": 0.0})
    assert (found.mean_loss, found.efficiency, found.min_efficiency) == (0, 1, 1)


def test_the_result_of_a_mechanism_is_kept() -> None:
    m = Mechanism.evenly_spaced(pins=7, satellites=1, ratio=20.0)
    assert isinstance(total_force(mechanism=m, force_exponent=1.2), TotalForce)
    assert total_force(mechanism=m, force_exponent=1.2) is total_force(
        mechanism=m, force_exponent=1.2
    )


@pytest.mark.parametrize("level", [3, 4, 5])
def test_the_rule_integrates_powers(level: int) -> None:
    near, weights = tanh_sinh_rule(level)
    assert 2 * weights.sum() == pytest.approx(1, rel=CONVERGED)
    for power in (0.01, 0.3, 1, 2.5, 7):
        integral = float(weights @ near**power + weights @ (1 - near) ** power)
        error = {3: 1e-7, 4: 1e-13, 5: 2e-15}[level]
        assert integral == pytest.approx(1 / (power + 1), rel=error)
