"""Oracle test: what is largest over the turn, within its stated error, by bisection at many places.

A few of what `make accuracy` asks six hundred times, with loops that are not compiled.
"""

import math

import numpy as np
import pytest

from core.output.elasticity import LinearLaw
from core.output.mechanism import Mechanism
from core.output.over_turn import over_turn
from core.output.real_mechanism import RealMechanism
from core.output.room import Deviations
from tests.inputs.real_mechanisms import STEEL
from tests.oracles.turns import Made, largest

TORQUE, SHARE = 200.0, 0.03


@pytest.mark.parametrize(("pins", "satellites"), [(6, 2), (8, 1), (5, 3)])
@pytest.mark.parametrize("size", [1e-6, 2e-5])
def test_the_turn(pins: int, satellites: int, size: float) -> None:
    draw = np.random.default_rng(pins)
    pin = [draw.normal(0, size, pins) for _ in range(3)]
    hole = [draw.normal(0, size, (satellites, pins)) for _ in range(3)]
    turned = draw.normal(0, size / 0.05, satellites)
    mechanism = Mechanism.evenly_spaced(pins=pins, satellites=satellites, ratio=20.0)
    cranks = mechanism.crank_angles
    made = Made(pins, cranks, 20.0, 0.05, 2e-3, 1e-5, 1e8, 1.0, *pin, *hole, turned)
    rows = [tuple(each.tolist()) for each in pin]
    tables = [tuple(map(tuple, each.tolist())) for each in hole]
    real = RealMechanism(
        mechanism=mechanism,
        pin_circle_radius=0.05,
        pin_radius=0.008,
        eccentricity=2e-3,
        contact_length=0.02,
        law=LinearLaw(1e8),
        clearance=1e-5,
        exact=False,
        deviations=Deviations(
            pin_radial=rows[0],
            pin_tangential=rows[1],
            pin_radius=rows[2],
            hole_radial=tables[0],
            hole_tangential=tables[1],
            hole_radius=tables[2],
            disc_phase=tuple(turned.tolist()),
        ),
        pin_material=STEEL,
        hole_material=STEEL,
    )
    found = over_turn(real=real, output_torque=TORQUE, lost_motion_share=SHARE)
    peak = largest(lambda psi: made.force(psi, TORQUE), 2003)
    lost = largest(lambda psi: made.lost_motion(psi, SHARE * TORQUE), 2003)
    assert math.isclose(peak, found.peak_force, rel_tol=1e-4)
    assert math.isclose(lost, found.lost_motion, rel_tol=1e-3)
    assert peak <= found.peak_force * (1 + found.accuracy.relative_error + 1e-10)
    assert lost <= found.lost_motion * (1 + 1e-8)
    play = largest(made.play, 2003)
    lag = largest(lambda psi: made.lag(psi, TORQUE)[0], 2003)
    less = largest(lambda psi: -made.lag(psi, TORQUE)[0], 2003)
    assert abs(play - found.backlash_max) <= 1e-8 * found.lost_motion
    assert abs(lag + less - found.transmission_error) <= 1e-8 * found.lost_motion + 1e-10 * lag
