"""Tables of methods, run and compared; quadrature rules; references in multiple precision."""

import math

import mpmath
import numpy as np
import pytest

from core.errors import METHODS
from core.output.contact_force import peak_force
from core.output.mechanism import Mechanism
from core.precession.rollers import RollerByLength
from core.precision import CONVERGED, EXACT
from core.work_precision.peaks import _exact_peak, peak_force_study
from core.work_precision.precession import contact_line_study, rule
from core.work_precision.study import Method, Reference, work_precision

RULES = {"simpson": (129, 1e-8), "gauss_legendre": (16, 1e-15)}
"""A setting of each rule, and its error in the integral of a smooth function."""


def test_each_method_runs_at_each_setting_and_what_is_not_finite_is_left_out():
    root = Method("golden_section", lambda n: (math.sqrt(2) + 0.1**n, n), "points", (1, 3))
    fails = Method("approximation", lambda n: (math.nan, n), "points", (2,))
    used = Method("closed_form", lambda _: (math.sqrt(2), 1))
    study = work_precision(
        reference=Reference("multiple_closed_form"),
        exact=mpmath.sqrt(2),
        methods=[root, fails, used],
    )
    assert [(each.method, each.setting, each.value) for each in study.points] == [
        ("golden_section", "points", 1),
        ("golden_section", "points", 3),
        ("closed_form", "default", 0.0),
    ]
    errors = [each.relative_error for each in study.points]
    assert errors[:2] == pytest.approx([0.1 / math.sqrt(2), 0.001 / math.sqrt(2)], rel=EXACT)
    assert errors[2] < 1e-15 and study.chosen is study.points[-1]
    assert [each.evaluations for each in study.points] == [1, 3, 1]
    assert all(each.run_time > 0 for each in study.points)
    assert study.reference.digits == 40


def test_the_error_of_a_vector_is_over_its_length():
    vector = Method("closed_form", lambda _: (3.0 + 4.5j, 1))
    reference = Reference("multiple_closed_form")
    study = work_precision(reference=reference, exact=mpmath.mpc(3, 4), methods=[vector])
    assert study.chosen.relative_error == pytest.approx(0.1, rel=CONVERGED)


@pytest.mark.parametrize("code", RULES)
def test_rules_integrate(code):
    count, error = RULES[code]
    nodes, weights = rule(code=code, count=count)
    assert len(nodes) == count and weights.sum() == pytest.approx(2.0, rel=CONVERGED)
    assert np.exp(nodes) @ weights == pytest.approx(math.e - 1 / math.e, rel=error)


@pytest.mark.parametrize("exponent", [0.0, 1.0, 1.5])
@pytest.mark.parametrize("cranks", [(0.3, 2.0, 4.4), (0.0,)])
def test_the_reference_of_the_peak_is_the_search_of_the_calculator(exponent, cranks):
    """Reference and search share no formula; a difference beyond rounding is another peak."""
    mechanism = Mechanism(pins=5, crank_angles=cranks, ratio=20.0, initial_crank_angle=0.7)
    study = peak_force_study(mechanism=mechanism, force_exponent=exponent)
    assert study.chosen.method in METHODS
    assert (study.reference.method, study.reference.digits) == ("multiple_peak", 40)
    assert study.chosen.relative_error < 1e-14
    sampled = [each for each in study.points if each.method == "sampling"]
    assert sampled[-1].relative_error < 1e-4


def test_the_reference_has_its_digits_on_a_kink_too():
    """Equal sharing of an odd number of pins: the least sum of their arms is cot(pi/2N)/2."""
    mechanism = Mechanism(pins=5, crank_angles=(0.3,), ratio=20.0)
    there = peak_force(mechanism=mechanism, force_exponent=0.0).peak_crank_angle
    with mpmath.workdps(40):
        peak, exact = _exact_peak(mechanism, 0.0, there), 2 * mpmath.tan(mpmath.pi / 10)
        assert abs(peak / exact - 1) < 1e-37


GEAR = {
    "roller_circle_radius": 0.05, "roller_radius": 0.004, "nutation_angle": 0.1, "ratio_u12": 0.96,
}  # fmt: skip


def test_the_reference_of_the_length_is_no_double():
    """Against a rounded one, errors are zero or whole roundings."""
    rollers = [RollerByLength(math.radians(angle), 0.015, 0.025) for angle in (20, 120)]
    with mpmath.workprec(53):
        study = contact_line_study(gear=GEAR, rollers=rollers)
    assert 0 < min(each.relative_error for each in study.points) < 1e-16
