"""Oracle test: the pin's give to a point force, in closed form against least work at 45 digits."""

import pytest

from core.output.elasticity import PinSupport, pin_compliance
from core.output.pin_beam import Support
from core.precision import CONVERGED
from tests.inputs.real_mechanisms import STEEL
from tests.oracles.load_sharing import pin_give


@pytest.mark.parametrize("support", ["cantilever", "supported", "fixed"])
@pytest.mark.parametrize("diameter", [0.002, 0.016, 0.08])
def test_what_a_pin_gives(support: Support, diameter: float) -> None:
    pin = PinSupport(support, diameter, (0.003, 0.02, 0.031, 0.049), STEEL, 0.05)
    assert pin_compliance(pin) == pytest.approx([*map(float, pin_give(pin))], rel=CONVERGED)
