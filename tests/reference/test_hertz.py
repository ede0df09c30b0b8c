"""Oracle tests: line contact in mpmath, the conformal contact against plane elasticity itself.

The conformal solution is not taken on trust: its pressure is put into the displacements of a
disc and of a hole (Michell's series for each harmonic of the pressure), and the gap that they
leave has to be closed over the contact and open beside it.
"""

import math
import random
from decimal import Decimal
from fractions import Fraction
from itertools import pairwise

import numpy as np
import pytest
from mpmath import mp, mpf

from core.hertz import (
    HALF_WIDTH_RATIO_LIMIT,
    MISMATCH_SHARES,
    conformal_half_angle_tangent,
    conformal_pressure,
    conformal_pressure_ratio,
    conformal_profile,
    hertz,
)
from core.materials import ElasticMaterial
from tests.oracles import dissimilar
from tests.oracles.hertz import axis_shear, exact_pressure, exact_tangent
from tests.oracles.seeds import seeds


@pytest.mark.parametrize("seed", seeds(20))
def test_every_number_of_the_line_contact(seed: int) -> None:
    r = random.Random(seed)
    first = ElasticMaterial(
        youngs_modulus=10 ** r.uniform(8, 12), poissons_ratio=r.choice([0.0, 0.3, 0.499])
    )
    second = ElasticMaterial(
        youngs_modulus=10 ** r.uniform(8, 12), poissons_ratio=r.uniform(0, 0.49)
    )
    pin_radius = 10 ** r.uniform(-4, 0)
    hole_radius = pin_radius * (1 + 10 ** r.uniform(-9, 2))
    force, length = 10 ** r.uniform(-6, 7), 10 ** r.uniform(-4, 0)
    factors = (r.choice([1.0, r.uniform(0.5, 3)]), r.choice([1.0, r.uniform(0.5, 3)]))
    found = hertz(
        force=force,
        contact_length=length,
        pin_radius=pin_radius,
        hole_radius=hole_radius,
        pin_material=first,
        hole_material=second,
        dynamic_factor=factors[0],
        distribution_factor=factors[1],
    )
    w = mpf(force) / mpf(length) * mpf(factors[0]) * mpf(factors[1])
    rho = mpf(hole_radius) * mpf(pin_radius) / (mpf(hole_radius) - mpf(pin_radius))
    modulus = 1 / (
        (1 - mpf(first.poissons_ratio) ** 2) / mpf(first.youngs_modulus)
        + (1 - mpf(second.poissons_ratio) ** 2) / mpf(second.youngs_modulus)
    )
    p0 = mp.sqrt(w * modulus / (mp.pi * rho))
    a = mp.sqrt(4 * w * rho / (mp.pi * modulus))
    # largest |sx - sz|/2 below the middle, by its own stationary point
    depth = mp.findroot(lambda z: mp.diff(axis_shear, z), 0.8)
    exact = {
        "reduced_radius": rho,
        "effective_modulus": modulus,
        "max_pressure": p0,
        "mean_pressure": mp.pi / 4 * p0,
        "half_width": a,
        "half_width_ratio": a / mpf(pin_radius),
        "max_shear": axis_shear(depth) * p0,
        "max_shear_depth": depth * a,
    }
    stated = found.accuracy.relative_error
    for name, value in exact.items():
        error = abs(mpf(getattr(found, name)) / value - 1)
        assert error <= 2e-15, name
        assert error <= stated, name
    # load per width: p0 over an ellipse of half-axis a carries the load
    assert found.mean_pressure * 2 * found.half_width == pytest.approx(float(w), rel=1e-14)


def test_largest_shear_is_that_of_the_whole_stress_field() -> None:
    """The shear on the axis, from Flamant's solution integrated over the pressure.

    Nothing of Johnson's closed form: sx and sz of each line force p*ds, summed numerically.
    """
    angle = np.linspace(-np.pi / 2, np.pi / 2, 20001)[1:-1]
    s, load = np.sin(angle), np.cos(angle) ** 2 * (angle[1] - angle[0])
    depths = np.linspace(0.70, 0.87, 681)
    shear = []
    for z in depths:
        r4 = (s * s + z * z) ** 2
        sz = -2 / math.pi * float((load * z**3 / r4).sum())
        sx = -2 / math.pi * float((load * z * s * s / r4).sum())
        shear.append(abs(sx - sz) / 2)
    best = int(np.argmax(shear))
    steel = ElasticMaterial(youngs_modulus=210e9, poissons_ratio=0.3)
    found = hertz(
        force=1e3,
        contact_length=0.02,
        pin_radius=0.006,
        hole_radius=0.008,
        pin_material=steel,
        hole_material=steel,
    )
    assert found.max_shear / found.max_pressure == pytest.approx(shear[best], abs=1e-6)
    assert found.max_shear_depth / found.half_width == pytest.approx(depths[best], abs=5e-4)
    assert found.max_shear / found.max_pressure == pytest.approx(0.300, abs=5e-4)
    assert found.max_shear_depth / found.half_width == pytest.approx(0.786, abs=5e-4)


LOAD_PARAMETERS = [1e-12, 1e-6, 1e-3, 0.03, 0.3, 1.0, 3.0, 30.0, 300.0, 1e4, 1e8, 1e14]


@pytest.mark.parametrize("load_parameter", LOAD_PARAMETERS)
def test_conformal_half_angle_and_peak_pressure(load_parameter: float) -> None:
    b, _ = conformal_half_angle_tangent(load_parameter=load_parameter)
    exact = exact_tangent(load_parameter)
    assert abs(mpf(b) / exact - 1) < 1e-15
    ratio, tangent, _ = conformal_pressure_ratio(load_parameter=load_parameter)
    assert tangent == b
    exact_ratio = exact_pressure(mpf(0), exact) / mp.sqrt(mpf(load_parameter) / (2 * mp.pi))
    assert abs(mpf(ratio) / exact_ratio - 1) < 3e-15


@pytest.mark.parametrize("load_parameter", [0.0, *LOAD_PARAMETERS])
def test_conformal_pressure_carries_the_load(load_parameter: float) -> None:
    # Q = integral of p*cos(angle)*R over the contact
    b, _ = conformal_half_angle_tangent(load_parameter=load_parameter)
    end = 2 * mp.atan(mpf(b))

    def share(t: mpf) -> mpf:
        # angle = end*sin(t) takes the square roots at the ends away
        angle = end * mp.sin(t)
        y = min(float(mp.tan(abs(angle) / 2)), b)
        pressure = conformal_pressure(position=y, half_angle_tangent=b)
        return mpf(pressure) * mp.cos(angle) * end * mp.cos(t)

    with mp.workdps(18):
        carried = mp.quad(share, [-mp.pi / 2, 0, mp.pi / 2], maxdegree=6)
    assert float(carried) == pytest.approx(1.0, abs=1e-11)


@pytest.mark.parametrize("load_parameter", [0.0, 0.05, 0.3, 1.0, 3.0, 20.0])
def test_conformal_pressure_closes_the_gap_between_disc_and_hole(load_parameter: float) -> None:
    """Michell's series: for a pressure p_n*cos(n*t) on both rims (plane strain, one material)

    u_hole - u_disc = 4*R/E1* * p_n * n/(n^2 - 1) * cos(n*t),  n >= 2;  2*R/E1* * p_0,  n = 0

    (n = 1 is a rigid motion of the disc). Contact: u_hole - u_disc + dR = C*cos(t).
    """
    harmonics, points = 700, 4001
    b, _ = conformal_half_angle_tangent(load_parameter=load_parameter)
    end = 2 * math.atan(b)
    t = np.linspace(-np.pi / 2, np.pi / 2, points)
    weight = end * np.cos(t) * (t[1] - t[0])
    angle = end * np.sin(t)
    y = np.minimum(np.abs(np.tan(angle / 2)), b)
    pressure = np.array([conformal_pressure(position=float(p), half_angle_tangent=b) for p in y])
    load = pressure * weight
    # the middle of the contact, two places nearer its edge, and two outside it
    places = np.array([0.0, 0.3, 0.6, 0.85, 1.3, 1.7]) * end
    approach = np.full(len(places), 2 * load.sum() / (2 * math.pi))
    for n in range(2, harmonics):
        p_n = float((load * np.cos(n * angle)).sum()) / math.pi
        approach += 4 * p_n * n / (n * n - 1) * np.cos(n * places)
    # in units of Q/E1*: approach + load_parameter = C*cos(t)
    gap = approach + load_parameter
    rigid = gap[0] / math.cos(places[0])
    error = gap - rigid * np.cos(places)
    scale = float(np.abs(approach).max())
    assert np.abs(error[:4]).max() < 2e-6 * scale
    # beside the contact the disc has not reached the hole
    assert (error[4:] > 0.1 * scale).all()


def test_without_clearance_the_contact_angle_is_the_known_limit() -> None:
    # Persson's limit: dR = 0, 2 = ln(b^2 + 1) + 2*b^4, whatever the load
    b, _ = conformal_half_angle_tangent(load_parameter=0.0)
    assert abs(mpf(b) / exact_tangent(0.0) - 1) < 1e-15
    assert 2 * math.degrees(math.atan(b)) == pytest.approx(85.0, abs=0.5)


def test_hertz_is_the_limit_of_a_narrow_contact() -> None:
    # b -> 0: the first correction falls as b^2 ~ 1/load_parameter
    errors = [
        abs(conformal_pressure_ratio(load_parameter=p)[0] - 1) for p in (1e2, 1e3, 1e4, 1e5, 1e6)
    ]
    for wide, narrow in pairwise(errors):
        assert narrow == pytest.approx(wide / 10, rel=0.05)
    b, _ = conformal_half_angle_tangent(load_parameter=1e10)
    assert b == pytest.approx(math.sqrt(2 / (math.pi * 1e10)), rel=1e-9)


def test_limit_of_validity_is_where_hertz_is_off_by_one_per_cent() -> None:
    # a/R = 2*sqrt(2/(pi*load_parameter)) for dR << R
    def excess(load_parameter: mpf) -> mpf:
        b = exact_tangent(load_parameter)
        ratio = exact_pressure(mpf(0), b) / mp.sqrt(load_parameter / (2 * mp.pi))
        return abs(ratio - 1) - mpf("0.01")

    low, high = mpf(10), mpf(1e5)
    for _ in range(60):
        middle = mp.sqrt(low * high)
        if excess(middle) > 0:
            low = middle
        else:
            high = middle
    half_width_ratio = 2 * mp.sqrt(2 / (mp.pi * low))
    assert float(half_width_ratio) == pytest.approx(HALF_WIDTH_RATIO_LIMIT, abs=1e-3)


def test_the_stated_error_holds_where_nearly_equal_radii_are_typed_as_decimals() -> None:
    """Millimetres with a few digits: what is meant is the decimal, not the double beside it."""
    r = random.Random(3)
    steel = ElasticMaterial(youngs_modulus=206e9, poissons_ratio=0.3)
    shares = []
    for _ in range(4000):
        pin = Decimal(r.randint(1, 10**7)).scaleb(-5)
        hole = pin + Decimal(r.randint(1, 9)).scaleb(-r.randint(3, 9))
        found = hertz(
            force=1e3,
            contact_length=0.02,
            pin_radius=float(pin) / 1e3,
            hole_radius=float(hole) / 1e3,
            pin_material=steel,
            hole_material=steel,
        )
        exact = Fraction(pin) * Fraction(hole) / Fraction(hole - pin) / 1000
        error = abs(Fraction(found.reduced_radius) / exact - 1)
        shares.append(float(error / Fraction(found.accuracy.relative_error)))
    assert max(shares) <= 1
    assert max(shares) > 0.5, "a bound of half the size would be wrong"


def test_the_pressure_along_the_arc_is_placed_on_the_pin() -> None:
    steel = ElasticMaterial(youngs_modulus=206e9, poissons_ratio=0.3)
    contact = hertz(
        force=2e4,
        contact_length=0.02,
        pin_radius=0.008,
        hole_radius=0.00802,
        pin_material=steel,
        hole_material=steel,
    )
    assert contact.conformal_half_angle is not None
    arc, pressure = conformal_profile(contact=contact, samples=20001)
    assert arc[-1] == pytest.approx(0.008 * contact.conformal_half_angle, rel=1e-14)
    assert pressure.max() == pytest.approx(contact.conformal_pressure, rel=1e-14)
    # the load: pressure times cosine over the arc, times the length
    carried = np.trapezoid(pressure * np.cos(arc / 0.008), arc) * 0.02
    assert carried == pytest.approx(2e4, rel=0.003)  # R - r << r, and where the arc is taken


@pytest.mark.parametrize("degrees", [5, 10, 20, 40, 60, 75, 78, 83, 84.5])
def test_the_series_of_a_disc_in_a_hole_gives_persson(degrees: float) -> None:
    half_angle = math.radians(degrees)
    load, pressure = dissimilar.contact(half_angle, 0.0, 0.0)
    b = math.tan(half_angle / 2)
    expected = conformal_pressure(position=0.0, half_angle_tangent=b)
    assert pressure / load == pytest.approx(expected, rel=dissimilar.ERROR)
    # E1**dR/Q of Persson is 2*E**dR/Q
    parameter = 4.0 / load
    assert conformal_half_angle_tangent(load_parameter=parameter)[0] == pytest.approx(
        b, rel=dissimilar.ERROR
    )


@pytest.mark.parametrize("degrees", [5, 10, 20, 30, 45, 60, 70, 74, 78, 83])
@pytest.mark.parametrize(
    ("alpha", "beta", "widest"),
    [
        (0.0024, 0.0007, 85),
        (0.39, 0.1, 85),
        (-0.39, -0.1, 82.5),
        (0.39, -0.1, 85),
        (0.0, 0.2, 77.5),
        (0.0, -0.2, 85),
        (0.7, 0.0, 85),
        (-0.7, 0.0, 75.5),
    ],
)
def test_other_materials_change_the_conformal_pressure_less_than_stated(
    degrees: float, alpha: float, beta: float, widest: float
) -> None:
    """Up to the widest contact that a load makes of these materials, in degrees."""
    load, pressure = dissimilar.contact(math.radians(degrees), alpha, beta)
    assert (load > 0) == (degrees < widest)
    if load < 0:
        return
    ratio, _, _ = conformal_pressure_ratio(load_parameter=4.0 / load)
    same = ratio * math.sqrt(4.0 / load / (2 * math.pi)) * load
    share_alpha, share_beta = MISMATCH_SHARES
    stated = share_alpha * abs(alpha) + share_beta * abs(beta)
    assert abs(pressure / same - 1) <= stated + dissimilar.ERROR
