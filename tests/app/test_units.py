"""The one conversion between API units and SI."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.units import UNITS, api_value, core_name, from_si, rounded, shown_unit, to_si
from core.precision import CONVERGED

DECIMALS = st.integers(-(10**9), 10**9).map(lambda thousandths: thousandths / 1000)


@pytest.mark.parametrize(
    ("field", "core", "unit"),
    [
        ("pin_radius_mm", "pin_radius", "mm"),
        ("max_line_load_N_per_mm", "max_line_load", "N/mm"),
        ("output_torque_Nm", "output_torque", "N·m"),
        ("force_N", "force", "N"),
        ("crank_angles_deg", "crank_angles", "°"),
        ("pins", "pins", ""),
        ("ratio_u12", "ratio_u12", ""),
        ("deg", "deg", ""),
    ],
)
def test_the_suffix_is_the_unit(field, core, unit):
    assert (core_name(field), shown_unit(field)) == (core, unit)


@pytest.mark.parametrize(
    ("field", "value", "si"),
    [
        ("a_mm", 8, 0.008),
        ("a_mm", 32.5, 0.0325),
        ("a_N_per_mm", 3, 3000.0),
        ("a_MPa", 1000, 1e9),
        ("a_GPa", 210, 210e9),
        ("a_deg", 180, math.pi),
        ("a_deg", [0, 90, 360], (0, math.pi / 2, 2 * math.pi)),
        ("a_Nm", 500, 500),
        ("a", "steel", "steel"),
        ("a_mm", None, None),
    ],
)
def test_conversion_both_ways(field, value, si):
    assert to_si(field, value) == si
    assert from_si(field, si) == value


@given(st.sampled_from(sorted(UNITS)), DECIMALS)
def test_what_a_user_types_comes_back_as_typed(unit, value):
    field = f"quantity_{unit}"
    assert from_si(field, to_si(field, value)) == value


@given(st.sampled_from(sorted(UNITS)), st.floats(1e-9, 1e9))
def test_no_conversion_loses_more_than_the_last_digits(unit, value):
    field = f"quantity_{unit}"
    assert from_si(field, to_si(field, value)) == pytest.approx(value, rel=CONVERGED, abs=0)


@given(
    st.sampled_from(sorted(UNITS)),
    DECIMALS | st.floats(-1e16, 1e16),
    st.integers(-4, 4),
)
def test_a_number_is_a_short_one_wherever_one_is_as_near_as_rounding(unit, value, ulps):
    size = UNITS[unit][1]
    si = to_si(f"quantity_{unit}", value)
    for _ in range(abs(ulps)):
        si = math.nextafter(si, math.copysign(math.inf, ulps))
    exact = si / size if size > 1 else si * (1 / size)
    short = round(exact, 9)
    near = abs(exact - short) <= 2.0**-51 * abs(exact)
    assert from_si(f"quantity_{unit}", si) == (short if near and size != 1 else exact)


def test_arrays_are_converted_without_the_noise_of_pi():
    degrees = [[0.0, 60.0, 120.0], [180.0, 240.0, 360.0]]
    assert from_si("angle_deg", np.radians(degrees)).tolist() == degrees
    assert from_si("force_N", np.array([1.5, 2.0])).tolist() == [1.5, 2.0]
    assert from_si("count", np.array([1, 2])).tolist() == [1, 2]


@pytest.mark.parametrize(
    ("values", "digits", "short"),
    [
        ([1234.5678, -0.05], 6, [1234.57, -0.05]),
        ([9.99996e-7, 1.23456e-9], 3, [1.0e-6, 1e-9]),
        ([123456789.0, 1.0], 3, [123000000.0, 0.0]),
        ([0.0, 0.0], 3, [0.0, 0.0]),
        ([np.inf, 1.25], 1, [np.inf, 1.25]),
    ],
)
def test_numbers_are_rounded_to_digits_of_the_largest(values, digits, short):
    assert rounded(np.array(values), digits).tolist() == short


def test_a_refusals_position_gets_its_unit():
    assert api_value("crank_angle", math.pi / 2) == ("crank_angle_deg", 90.0)
    assert api_value("satellite", 2) == ("satellite", 2)
