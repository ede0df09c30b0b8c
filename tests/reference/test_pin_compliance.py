"""Oracle test: what a pin gives to point forces, in closed form against least work at 40 digits."""

import numpy as np
import pytest

from core.output.elasticity import PinSupport, pin_compliance, pin_flexibility
from core.output.pin_beam import Support
from core.precision import CONVERGED
from tests.inputs.real_mechanisms import STEEL
from tests.oracles.load_sharing import pin_give
from tests.oracles.pin_flexibility import pin_gives


@pytest.mark.parametrize("support", ["cantilever", "supported", "fixed"])
@pytest.mark.parametrize("diameter", [0.002, 0.016, 0.08])
def test_what_a_pin_gives(support: Support, diameter: float) -> None:
    pin = PinSupport(support, diameter, (0.003, 0.02, 0.031, 0.049), STEEL, 0.05)
    assert pin_compliance(pin) == pytest.approx([*map(float, pin_give(pin))], rel=CONVERGED)
    expected = np.array(pin_gives(pin)).astype(float)
    assert pin_flexibility(pin) == pytest.approx(expected, rel=CONVERGED)
