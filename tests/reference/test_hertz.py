"""Oracle tests: line contact in mpmath."""

import math
import random
from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest
from mpmath import mp, mpf

from core.hertz import HALF_WIDTH_RATIO_LIMIT, ElasticMaterial, conformal_profile, hertz
from core.precision import CONVERGED, SEARCHED
from tests.oracles.hertz import exact_pressure, exact_tangent


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


def test_the_pressure_along_the_arc_is_placed_between_pin_and_hole() -> None:
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
    radius = math.sqrt(0.008 * 0.00802)
    assert arc[-1] == pytest.approx(radius * contact.conformal_half_angle, rel=CONVERGED)
    assert pressure.max() == pytest.approx(contact.conformal_pressure, rel=CONVERGED)
    # the load: pressure times cosine over the arc, times the length
    carried = np.trapezoid(pressure * np.cos(arc / radius), arc) * 0.02
    assert carried == pytest.approx(2e4, rel=SEARCHED)
