"""Tables of methods, run and compared; quadrature rules; references in multiple precision."""

import math

import mpmath
import numpy as np
import pytest

from core.errors import METHODS
from core.output.mechanism import Mechanism
from core.precession.rollers import RollerByLength
from core.precision import CONVERGED, EXACT
from core.work_precision.peaks import peak_force_study
from core.work_precision.precession import contact_line_study, rules
from core.work_precision.study import DEFAULT, Method, Reference, work_precision

RULES = {
    "trapezoid": (129, 1e-4),
    "simpson": (129, 1e-8),
    "gauss_legendre": (16, 1e-15),
    "clenshaw_curtis": (16, 1e-14),
    "tanh_sinh": (5, 1e-14),
}
"""A setting of each rule, and its error in the integral of a smooth function."""


def test_each_method_runs_at_each_setting_and_what_is_not_finite_is_left_out():
    root = Method(
        "golden_section", [("points", 1), ("points", 3)], lambda n: (math.sqrt(2) + 0.1**n, n)
    )
    fails = Method("approximation", [("points", 2)], lambda n: (math.nan, n))
    used = Method("closed_form", DEFAULT, lambda _: (math.sqrt(2), 1), chosen=True)
    study = work_precision(
        reference=Reference("multiple_closed_form"),
        exact=[mpmath.sqrt(2)],
        methods=[root, fails, used],
    )
    assert [(each.method, each.setting) for each in study.points] == [
        ("golden_section", ("points", 1)),
        ("golden_section", ("points", 3)),
        ("closed_form", ("default", 0.0)),
    ]
    errors = [each.relative_error for each in study.points]
    assert errors[:2] == pytest.approx([0.1 / math.sqrt(2), 0.001 / math.sqrt(2)], rel=EXACT)
    assert errors[2] < 1e-15 and study.chosen is study.points[-1]
    assert [each.evaluations for each in study.points] == [1, 3, 1]
    assert all(each.run_time > 0 for each in study.points)
    assert study.reference.digits == 40


def test_the_error_of_a_vector_is_over_its_length():
    vector = Method("closed_form", DEFAULT, lambda _: ([3.0, 4.5], 1), chosen=True)
    study = work_precision(
        reference=Reference("multiple_closed_form"), exact=[mpmath.mpf(3), mpmath.mpf(4)],
        methods=[vector],
    )  # fmt: skip
    assert study.chosen.relative_error == pytest.approx(0.1, rel=CONVERGED)


@pytest.mark.parametrize("code", RULES)
def test_rules_integrate(code):
    value, error = RULES[code]
    found = rules(code)[value].integral(lambda x: np.stack((np.exp(x), np.ones_like(x))), -1.0, 2.0)
    exact = [math.exp(2) - math.exp(-1), 3.0]
    assert abs(found / exact - 1).max() < error
    assert all(f"{code}_{along}" in METHODS for along in ("phi", "z", "shaft"))


@pytest.mark.parametrize("exponent", [0.0, 1.0, 1.5])
@pytest.mark.parametrize("cranks", [(0.3, 2.0, 4.4), (0.0,)])
def test_the_reference_of_the_peak_is_the_search_of_the_calculator(exponent, cranks):
    """Reference and search share no formula; a difference beyond rounding is another peak."""
    mechanism = Mechanism(pins=5, crank_angles=cranks, ratio=20.0, initial_crank_angle=0.7)
    study = peak_force_study(mechanism=mechanism, force_exponent=exponent)
    assert (study.reference.method, study.reference.digits) == ("multiple_peak", 40)
    assert study.chosen.relative_error < 1e-14
    sampled = [each for each in study.points if each.method == "sampling"]
    assert sampled[-1].relative_error < 1e-4


GEAR = {
    "roller_circle_radius": 0.05, "roller_radius": 0.004, "nutation_angle": 0.1, "ratio_u12": 0.96,
}  # fmt: skip


def test_the_reference_of_the_length_is_no_double():
    """Against a rounded one, errors are zero or whole roundings."""
    rollers = [RollerByLength(math.radians(angle), 0.015, 0.025) for angle in (20, 120)]
    with mpmath.workprec(53):
        study = contact_line_study(gear=GEAR, rollers=rollers)
    assert 0 < min(each.relative_error for each in study.points) < 1e-16
