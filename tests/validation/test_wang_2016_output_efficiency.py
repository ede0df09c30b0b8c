"""Published value: Wang, Luo, Su 2016, drive XW3: efficiency of the output mechanism.

Their eq. (5) is ours to the first order in the friction coefficient, with
``e = K1*Dp/(2*z_p)``, and ``d_sw/(d_sw + 2*D_2)`` the radii of pin and sleeve.
"""

import math

import pytest

from core.output.losses import Sleeves
from core.output.mechanism import Mechanism
from core.precision import CONVERGED
from tests.inputs.loads import pin_losses

K1, PIN, SLEEVE, RING, HOLES, TEETH, FRICTION = 0.77495208, 14.0, 2.0, 140.0, 90.0, 44, 0.02


def test_efficiency_of_xw3() -> None:
    found = pin_losses(
        mechanism=Mechanism.evenly_spaced(pins=10, satellites=2, ratio=TEETH - 1.0),
        output_torque=200.0,
        pin_circle_radius=HOLES / 2000,
        input_speed=100.0,
        output_power=200.0 * 100.0 / (TEETH - 1),
        eccentricity=K1 * RING / (2 * TEETH) / 1000,
        pin_radius=(PIN / 2 + SLEEVE) / 1000,
        rubbing=Sleeves(PIN / 1000),
        contact_length=0.01,
        friction_coefficient=FRICTION,
    )
    lost = 4 * FRICTION * K1 * PIN * RING / (math.pi * HOLES * (PIN + 2 * SLEEVE))
    assert round(1 - lost, 10) == 0.9761243052
    assert 1 / found.efficiency - 1 == pytest.approx(lost, rel=CONVERGED)
    assert round(found.efficiency, 9) == 0.976681061
