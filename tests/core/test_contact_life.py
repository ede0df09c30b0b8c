"""The life factor of the contact pressure: values by hand, and what must hold for any life."""

from itertools import pairwise
from typing import get_args

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from core.contact_life import LifeCurve, life_factor
from core.errors import InvalidInput
from core.hertz import ContactLimit
from core.material_table import MATERIALS
from core.precision import CONVERGED

CURVES = get_args(LifeCurve)

# ISO 6336-2: the points of the curves; in between, lines of logarithms
POINTS: dict[str, list[tuple[float, float]]] = {
    "hardened": [(1e5, 1.6), (5e7, 1.0), (1e10, 0.85)],
    "nitrided": [(1e5, 1.3), (2e6, 1.0), (1e10, 0.85)],
    "nitrocarburised": [(1e5, 1.1), (2e6, 1.0), (1e10, 0.85)],
}

# by hand: 10^(m*lg(N_k/N_L)), to five digits
BY_HAND = [
    ("hardened", 4.725e8, 0.93358),  # 1500 turns a minute, ratio 20, 5000 h
    ("hardened", 1e6, 1.34413),
    ("hardened", 1e7, 1.12939),
    ("hardened", 5e7, 1.0),
    ("hardened", 1e9, 0.91241),
    ("hardened", 1e10, 0.85033),
    ("nitrided", 1e6, 1.06260),
    ("nitrided", 1e9, 0.88808),
    ("nitrocarburised", 1e6, 1.02229),
    ("nitrocarburised", 1e9, 0.88808),
]


@pytest.mark.parametrize(("curve", "loads", "factor"), BY_HAND)
def test_by_hand(curve: LifeCurve, loads: float, factor: float) -> None:
    assert life_factor(curve=curve, loads=loads) == pytest.approx(factor, abs=6e-6)


@pytest.mark.parametrize("curve", CURVES)
def test_the_points_of_the_standard(curve: LifeCurve) -> None:
    """The exponents are printed to three digits: 0.05 % of the factor."""
    for loads, factor in POINTS[curve]:
        assert life_factor(curve=curve, loads=loads) == pytest.approx(factor, rel=5e-4)
    most, knee = POINTS[curve][0][1], POINTS[curve][1][0]
    for few in (1e-3, 1.0, 9e4):
        assert life_factor(curve=curve, loads=few) == most
    assert life_factor(curve=curve, loads=knee) == 1
    # straight in logarithms
    for (one, above), (other, below) in pairwise(POINTS[curve]):
        middle = life_factor(curve=curve, loads=(one * other) ** 0.5)
        assert middle == pytest.approx((above * below) ** 0.5, rel=5e-4)


@given(curve=st.sampled_from(CURVES), loads=st.floats(1e-9, 1e14), more=st.floats(1.0, 1e6))
def test_a_longer_life_never_allows_more(curve: LifeCurve, loads: float, more: float) -> None:
    short, long = (life_factor(curve=curve, loads=each) for each in (loads, loads * more))
    assert 0 < long <= short
    assert long < short or more < 1 + 1e-9 or loads * more < 1e5


@pytest.mark.parametrize("curve", CURVES)
def test_numbers_and_arrays_alike(curve: LifeCurve) -> None:
    loads = np.geomspace(1e2, 1e12, 41)
    single = [life_factor(curve=curve, loads=float(each)) for each in loads]
    assert life_factor(curve=curve, loads=loads) == pytest.approx(single, rel=CONVERGED)


@pytest.mark.parametrize("loads", [0.0, -1.0])
def test_no_loads_are_no_life(loads: float) -> None:
    with pytest.raises(InvalidInput):
        life_factor(curve="hardened", loads=loads)


def test_a_limit_over_a_life() -> None:
    limit = ContactLimit("endurance", 1000.0, curve="nitrided", loads=2e6)
    assert (limit.life_factor, limit.allowable) == (1.0, 1000.0)
    for unknown in (ContactLimit("given", 1000.0, loads=1e9), ContactLimit("given", 1000.0)):
        assert (unknown.life_factor, unknown.allowable) == (None, 1000.0)
    assert ContactLimit("given", 1000.0, curve="hardened").allowable == 1000.0


def test_the_table_knows_the_curves_of_its_steels() -> None:
    """Steels with a limit of ISO 6336 have a curve; bearing steel and bronze have none."""
    curves = {
        name: each.material.limit.curve
        for name, each in MATERIALS.items()
        if not each.missing and each.material.limit
    }
    assert curves == {
        "steel_structural": "hardened",
        "steel_s355": "hardened",
        "steel_through_hardened": "hardened",
        "steel_c45": "hardened",
        "steel_case_hardened": "hardened",
        "steel_bearing": None,
        "bronze_tin_centrifugal": None,
    }
    for each in MATERIALS.values():
        for limit in each.limits:
            assert limit.curve is None or limit.criterion == "endurance"
            assert limit.loads is None
