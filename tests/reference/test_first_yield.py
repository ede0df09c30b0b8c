"""First yield of a sliding line contact against a sum over its forces, and numbers held by hand."""

import math
from itertools import pairwise

import numpy as np
import pytest

from core.hertz import SHAKEDOWN, first_yield, shakedown, squared_stress
from core.precision import EXACT, SAME
from tests.oracles import sliding

TABLE = {
    0.30: (1.794, 1.769, 1.695, 1.500, 1.226, 1.026, 0.878, 0.765, 0.677),
    0.33: (1.828, 1.802, 1.726, 1.589, 1.276, 1.057, 0.899, 0.780, 0.688),
    0.36: (1.858, 1.831, 1.753, 1.626, 1.323, 1.086, 0.918, 0.794, 0.699),
    0.40: (1.889, 1.862, 1.780, 1.649, 1.378, 1.118, 0.939, 0.809, 0.710),
    0.43: (1.906, 1.878, 1.795, 1.662, 1.410, 1.136, 0.951, 0.817, 0.716),
}
"""p0/Re by Poisson's ratio, for frictions of 0, 0.1, ... 0.8, to four digits."""


@pytest.mark.parametrize("ratio", TABLE)
def test_first_yield_is_that_of_the_table(ratio: float) -> None:
    """Calculated apart from this program: McEwen's closed form, and Flamant's quadrature."""
    for tenth, factor in enumerate(TABLE[ratio]):
        found = first_yield(poissons_ratio=ratio, friction=tenth / 10)
        assert found == pytest.approx(factor, abs=6e-4), tenth


@pytest.mark.parametrize(
    ("ratio", "friction"), [(0.0, 0.0), (0.3, 0.0), (0.36, 0.17), (0.3, 0.28), (0.45, 0.7)]
)
def test_first_yield_is_that_of_the_oracle(ratio: float, friction: float) -> None:
    known = sliding.first_yield(poissons_ratio=ratio, friction=friction)
    found = first_yield(poissons_ratio=ratio, friction=friction)
    assert found == pytest.approx(known, rel=1e-4)


def test_stresses_are_those_of_the_forces_of_the_contact() -> None:
    random = np.random.default_rng(7)
    for x, z in zip(random.uniform(-2, 2, 50), random.uniform(0.1, 2, 50), strict=True):
        ratio, friction = random.uniform(0, 0.49), random.uniform(0, 1)
        known = sliding.equivalent_stress(poissons_ratio=ratio, friction=friction, x=x, z=z)
        found = squared_stress(
            poissons_ratio=ratio, friction=friction, x=np.array([x]), z=np.array([z])
        )
        assert math.sqrt(found[0]) == pytest.approx(known, rel=EXACT), (x, z)


def test_friction_only_lowers_first_yield() -> None:
    for ratio in (0.0, 0.3, 0.49):
        factors = [first_yield(poissons_ratio=ratio, friction=mu / 20) for mu in range(30)]
        assert all(one > two for one, two in pairwise(factors))


def test_shakedown_falls_by_a_straight_line_to_the_last_known_friction() -> None:
    assert shakedown(0.0) == SHAKEDOWN
    assert shakedown(0.05) == pytest.approx((SHAKEDOWN + 2.06) / 2, rel=SAME)
    assert shakedown(0.1) == shakedown(0.6) == 2.06
