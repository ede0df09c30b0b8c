"""Paper values: Zyl (adviser Lustenkova), forces in the parallel-crank mechanism (P4).

P4 eq. (1) shares the torque equally between the driving pins: the program's exponent v = 0.
P4 gives its two forces to four digits; the formula behind them is checked to rounding.
"""

import math

import numpy as np
import pytest

from core.errors import ImpossibleMechanism
from core.output.contact_force import force_ratios, peak_force, reference_force
from core.output.mechanism import Mechanism
from core.precision import CONVERGED, EXACT


def p4_mechanism(pins: int, flows: int) -> Mechanism:
    """S parallel flows: one satellite, or two at pi (P4, last paragraph)."""
    return Mechanism.evenly_spaced(pins=pins, satellites=flows, ratio=11.0, crank_spacing=math.pi)


def p4_maximum(torque: float, radius: float, pins: int, flows: int) -> float:
    """P4 eq. (1) as printed."""
    total = math.fsum(math.sin(2 * math.pi * i / pins) for i in range(pins // 2 + 1))
    return torque / (radius * flows * total)


def peak(torque: float, radius: float, pins: int, flows: int) -> float:
    ratio = peak_force(mechanism=p4_mechanism(pins, flows), force_exponent=0.0).peak_force_ratio
    return ratio * reference_force(output_torque=torque, pin_circle_radius=radius)


@pytest.mark.parametrize(("pins", "printed", "force"), [(6, 888.2, 888.23), (4, 1538.0, 1538.46)])
def test_the_two_forces_of_the_paper(pins: int, printed: float, force: float) -> None:
    # T2 = 50 N*m, R0 = 32.5 mm, S = 1
    found = peak(50.0, 0.0325, pins, 1)
    # printed: 888.2 is rounded, 1538 (of 1538.46) too
    assert found == pytest.approx(printed, abs=0.5)
    assert found == pytest.approx(force, abs=0.005)
    assert found == pytest.approx(p4_maximum(50.0, 0.0325, pins, 1), rel=CONVERGED)


@pytest.mark.parametrize("flows", [1, 2])
@pytest.mark.parametrize("pins", range(3, 13))
def test_equation_1_is_the_peak_over_the_turn(pins: int, flows: int) -> None:
    assert peak(1.0, 1.0, pins, flows) == pytest.approx(
        p4_maximum(1.0, 1.0, pins, flows), rel=CONVERGED
    )


@pytest.mark.parametrize("pins", range(3, 41))
def test_sum_of_sines_in_closed_form(pins: int) -> None:
    # cot(pi/n) for even n, cot(pi/(2n))/2 for odd n
    even = pins % 2 == 0
    total = 1 / math.tan(math.pi / pins) if even else 0.5 / math.tan(math.pi / (2 * pins))
    assert peak(1.0, 1.0, pins, 1) == pytest.approx(1 / total, rel=CONVERGED)


@pytest.mark.parametrize("pins", range(3, 13))
def test_a_doubled_satellite_halves_the_load(pins: int) -> None:
    assert peak(1.0, 1.0, pins, 2) == pytest.approx(peak(1.0, 1.0, pins, 1) / 2, rel=CONVERGED)


def test_load_grows_faster_than_the_pins_become_fewer() -> None:
    # "with fewer holes the load grows non-linearly": 6 to 4 pins, a factor sqrt(3), not 1.5
    growth = peak(1.0, 1.0, 4, 1) / peak(1.0, 1.0, 6, 1)
    assert growth == pytest.approx(math.sqrt(3), rel=CONVERGED)


@pytest.mark.parametrize("flows", [1, 2])
def test_two_pins_cannot_work_though_the_sum_gives_a_number(flows: int) -> None:
    # argued rejection: for n = 2 the printed sum is sin(0) + sin(pi), zero but for rounding, and
    # its reciprocal a force of some 1e16 times T/R0. With the crank in line with both pins no
    # pin has an arm: no torque can pass at all.
    assert p4_maximum(1.0, 1.0, 2, flows) > 1e15
    with pytest.raises(ImpossibleMechanism):
        peak_force(mechanism=p4_mechanism(2, flows), force_exponent=0.0)


def test_forces_are_equal_at_every_position() -> None:
    angles = np.linspace(0.01, 6.0, 50)
    forces = force_ratios(mechanism=p4_mechanism(7, 2), crank_angles=angles, force_exponent=0.0)
    for rows in forces:
        driving = rows[rows > 0]
        assert driving == pytest.approx(driving[0], rel=CONVERGED)


@pytest.mark.parametrize("pins", [3, 4, 7])
def test_equal_sharing_is_the_limit_of_small_exponents(pins: int) -> None:
    limit = peak_force(mechanism=p4_mechanism(pins, 1), force_exponent=0.0).peak_force_ratio
    near = peak_force(mechanism=p4_mechanism(pins, 1), force_exponent=1e-10).peak_force_ratio
    assert near == pytest.approx(limit, rel=EXACT)
