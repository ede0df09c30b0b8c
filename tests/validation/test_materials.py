"""Materials: the moduli that standards print, and the reduced ones that follow from them."""

import pytest

from core.hertz import ElasticMaterial, effective_modulus, mismatch
from core.material_table import MATERIALS
from core.precision import JUDGED

WORM = ElasticMaterial(youngs_modulus=210e9, poissons_ratio=0.3)


@pytest.mark.parametrize(
    ("name", "reduced"),
    [("bronze_tin", 140_144), ("bronze_tin_nickel", 150_622), ("bronze_aluminium", 174_053)],
)
def test_reduced_modulus_of_a_worm_wheel_is_the_printed_one(name: str, reduced: float) -> None:
    """DIN 3996 and ISO/TR 14521 give ``E_red = 2/((1 - v1^2)/E1 + (1 - v2^2)/E2)``, N/mm^2, of each
    bronze against a steel worm: it holds E and v of the table together, to the last digit.
    """
    found = 2 * effective_modulus(first=WORM, second=MATERIALS[name].material)
    assert found / 1e6 == pytest.approx(reduced, abs=1.0)


def test_dundurs_constants_of_a_rigid_and_a_soft_body() -> None:
    """On a rigid body alpha is 1 and beta (1 - 2v)/(2*(1 - v)); alike, both are 0."""
    soft = ElasticMaterial(youngs_modulus=1e9, poissons_ratio=0.3)
    rigid = ElasticMaterial(youngs_modulus=1e15, poissons_ratio=0.3)
    assert mismatch(first=rigid, second=soft) == pytest.approx((1, 0.4 / 1.4), rel=JUDGED)
    assert mismatch(first=soft, second=rigid) == pytest.approx((-1, -0.4 / 1.4), rel=JUDGED)
    assert mismatch(first=soft, second=soft) == (0, 0)
