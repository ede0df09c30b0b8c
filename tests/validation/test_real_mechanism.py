"""Clearance, deviations and elasticity: cases made elsewhere, and numbers of others.

The cases were computed with 40 digits by plain bisection over vectors, apart from this program;
other numbers are those of open programs and of published examples, named at each.
"""

import math
from typing import Any

import pytest

from core.hertz import ElasticMaterial
from core.output.elasticity import (
    LinearLaw,
)
from core.output.loaded_position import loaded_position
from core.output.mechanism import Mechanism
from core.output.over_turn import over_turn
from core.output.real_mechanism import RealMechanism
from core.precision import CONVERGED, SAME
from tests.inputs.load_sharing_cases import ARCMIN, CASES, mechanism
from tests.inputs.real_mechanisms import STEEL

APART = {"S13"}
"""Cases of pins that several discs bend, each for itself: they bend each other
(`tests.reference.test_what_gives`)."""


@pytest.mark.parametrize(
    "case",
    [case for case in CASES if case["name"].split()[0] not in APART],
    ids=lambda case: case["name"].split()[0],
)
def test_case(case: dict[str, Any]) -> None:
    real, torque = mechanism(case["body"])
    for expected in case["expect"].get("positions", ()):
        angle = math.radians(expected["crank_angle_deg"])
        found = loaded_position(real=real, crank_angle=angle, output_torque=torque)
        largest = max(map(max, expected["force_N"]))
        for row, forces in zip(found.force, expected["force_N"], strict=True):
            assert row == pytest.approx(forces, rel=0, abs=1e-14 * largest)
        assert found.rotation / ARCMIN == pytest.approx(expected["rotation_arcmin"], rel=SAME)
        assert found.satellite_torque == pytest.approx(
            expected["satellite_torque_Nm"], rel=0, abs=2e-14 * largest * real.pin_circle_radius
        )
        assert found.loaded_pairs == expected["loaded_pairs"]
        assert found.stiffness * ARCMIN == pytest.approx(
            expected["stiffness_Nm_per_arcmin"], rel=CONVERGED
        )
        if "play_arcmin" in expected:
            play = [limit / ARCMIN for limit in found.play]
            assert play == pytest.approx(expected["play_arcmin"], rel=CONVERGED)
        else:
            assert found.play is None
            assert found.interference * 1e3 == pytest.approx(
                expected["interference_mm"], rel=CONVERGED
            )
        if "max_pressure_MPa" in expected:
            pressure = found.max_pressure / 1e6
            assert pressure == pytest.approx(expected["max_pressure_MPa"], rel=CONVERGED)
    if "over_turn" not in case["expect"]:
        return
    expected = case["expect"]["over_turn"]
    found = over_turn(real=real, output_torque=torque)
    accuracy = case.get("rtol", 1e-10)
    assert found.peak_force == pytest.approx(expected["peak_force_N"], rel=accuracy)
    if "backlash_max_arcmin" in expected:
        for name in ("backlash_max", "backlash_min"):
            value = getattr(found, name) / ARCMIN
            assert value == pytest.approx(expected[f"{name}_arcmin"], rel=SAME)
        assert found.pressed_without_load is expected["pressed_without_load"]


def _cycloidal_studio(clearance: float) -> RealMechanism:
    # Its effective modulus is 115385 MPa, rounded.
    steel = ElasticMaterial(youngs_modulus=2 * 0.91 * 115385e6, poissons_ratio=0.3)
    return RealMechanism(
        mechanism=Mechanism.evenly_spaced(pins=8, satellites=1, ratio=18.0),
        pin_circle_radius=0.020,
        pin_radius=0.003,
        eccentricity=0.0015,
        contact_length=0.010,
        clearance=clearance,
        law=LinearLaw(stiffness=5e7),
        pin_material=steel,
        hole_material=steel,
        exact=False,
    )


def test_cycloidal_studio() -> None:
    """SHKinsem/cycloidal-studio, physics.js; its hole is pin + eccentricity whatever the play."""
    ideal = over_turn(real=_cycloidal_studio(0.0), output_torque=30.0)
    assert ideal.peak_force == pytest.approx(750, rel=CONVERGED)
    assert round(ideal.max_pressure / 1e6, 2) == 553.23
    loose = over_turn(real=_cycloidal_studio(2e-5), output_torque=30.0)
    assert loose.peak_force == pytest.approx(250 * (1 + 2 * math.sqrt(2)), rel=CONVERGED)
    its_own = ideal.max_pressure * math.sqrt(loose.peak_force / ideal.peak_force)
    assert round(its_own / 1e6, 3) == 624.969
    assert loose.backlash_max == pytest.approx(0.04 / 20 / math.cos(math.pi / 8), rel=SAME)
    assert round(loose.backlash_max, 10) == 2.1647844e-3
    assert loose.backlash_min == pytest.approx(2e-3, rel=SAME)
    position = loaded_position(real=_cycloidal_studio(2e-5), crank_angle=0.0, output_torque=30.0)
    assert position.loaded_pairs == 3


def test_a_public_worked_example() -> None:
    """A calculation published on the web: T = 116 N*m, R = 33.875 mm, 4 pins, K = 2: 1712.2 N."""
    real = RealMechanism(
        mechanism=Mechanism.evenly_spaced(pins=4, satellites=2, ratio=20.0),
        pin_circle_radius=0.033875,
        pin_radius=0.005,
        eccentricity=0.0015,
        contact_length=0.010,
        law=LinearLaw(stiffness=1e8),
        exact=False,
        pin_material=STEEL,
        hole_material=STEEL,
    )
    assert round(over_turn(real=real, output_torque=116.0).peak_force, 1) == 1712.2


@pytest.mark.parametrize(("pins", "most", "least"), [(3, 3e-3, 2.3094e-3), (8, 2.1647844e-3, 2e-3)])
def test_backlash_of_even_clearance(pins: int, most: float, least: float) -> None:
    """Closed forms: 2c/(R*cos(pi/N)) and 2c/R for even N, else c/R*(1 + 1/cos(pi/N)), least
    2c/(R*cos(pi/2N)).
    """
    real = RealMechanism(
        mechanism=Mechanism.evenly_spaced(pins=pins, satellites=1, ratio=18.0),
        pin_circle_radius=0.020,
        pin_radius=0.003,
        eccentricity=0.0015,
        contact_length=0.010,
        clearance=2e-5,
        law=LinearLaw(stiffness=5e7),
        exact=False,
        pin_material=STEEL,
        hole_material=STEEL,
    )
    found = over_turn(real=real, output_torque=1.0)
    assert (round(found.backlash_max, 10), round(found.backlash_min, 7)) == (most, least)
