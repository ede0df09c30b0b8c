"""Satellites that give, and given shares, against roots over vectors at 45 digits."""

import math
from dataclasses import replace

import pytest

from core.output.elasticity import (
    RIGID_SUPPORT,
    CrankSupport,
    ElasticMesh,
    LinearLaw,
    SatelliteSupport,
)
from core.output.mechanism import Mechanism
from core.output.over_turn import over_turn
from core.output.real_mechanism import RealMechanism
from core.output.room import Deviations
from core.precision import EXACT, SAME
from tests.inputs.real_mechanisms import STEEL, solved

ARCMIN = math.pi / 10800
DESIGN = RealMechanism(
    mechanism=Mechanism.evenly_spaced(pins=6, satellites=2, ratio=20.0),
    pin_circle_radius=0.040,
    pin_radius=0.005,
    eccentricity=0.002,
    contact_length=0.012,
    clearance=3e-5,
    law=LinearLaw(1e8),
    exact=False,
    pin_material=STEEL,
    hole_material=STEEL,
)


@pytest.mark.parametrize(
    ("stiffness", "torques", "lag"),
    [
        (math.inf, (62.830, 137.170), 3.992063361476),
        (1e5, (88.01503654, 111.9849635), 7.446788891),
        (1e4, (98.33082930, 101.6691707), 38.38650983),
    ],
)
def test_the_discs_share_by_the_stiffness_of_their_meshes(
    stiffness: float, torques: tuple[float, float], lag: float
) -> None:
    """Two discs, one ahead by 0.02 degrees; numbers made apart from this program."""
    ahead = Deviations(disc_phase=(0.0, math.radians(0.02)))
    real = replace(DESIGN, deviations=ahead, support=ElasticMesh(stiffness))
    found = solved(real, math.radians(37), 200.0)
    digits = 3 if stiffness == math.inf else 7
    assert [round(each, digits) for each in found.satellite_torque] == [
        round(each, digits) for each in torques
    ]
    assert found.rotation / ARCMIN == pytest.approx(lag, rel=EXACT)
    for own, torque in zip(found.satellite_rotation, found.satellite_torque, strict=True):
        assert own == pytest.approx(found.rotation - torque / stiffness, rel=SAME)


@pytest.mark.parametrize(
    ("support", "least", "most"),
    [
        (RIGID_SUPPORT, 3.0, 3.3),
        (CrankSupport(2e8), 4.1, 4.7),
        (CrankSupport(1e8), 5.2, 6.1),
        (CrankSupport(radial_clearance=2e-5), 3.9, 4.3),
        (CrankSupport(2e8, 2e-5), 4.9, 5.7),
    ],
)
def test_the_bearings_of_the_cranks_count_for_more_than_the_contacts(
    support: SatelliteSupport, least: float, most: float
) -> None:
    """Lag over the turn, and the peak that rises by 1 to 3 percent; numbers made apart."""
    stiff = replace(DESIGN, law=LinearLaw(5e8))
    real = replace(stiff, support=support)
    lags = [solved(real, 2 * math.pi * i / 120, 200.0).rotation / ARCMIN for i in range(120)]
    assert (round(min(lags), 1), round(max(lags), 1)) == (least, most)
    if support.gives:
        risen = over_turn(real=real, output_torque=200.0).peak_force
        assert 1.01 < risen / over_turn(real=stiff, output_torque=200.0).peak_force < 1.03
