"""A design whose checks are known by hand, and what a check says."""

import math
from dataclasses import replace
from typing import Any

import pytest

from core.checks.check import Check
from core.checks.crank_design import CrankDesign
from core.checks.sections import DesignPin, FatigueBasis, Friction, Ring, RollingBearing, Shaft
from core.materials import ContactLimit, ElasticMaterial

PIN = ElasticMaterial(210e9, 0.3, ContactLimit("given", 900e6), yield_strength=300e6)
HOLE = ElasticMaterial(210e9, 0.3, ContactLimit("given", 600e6), yield_strength=200e6)
REF = CrankDesign(
    pins=6,
    satellites=2,
    ratio=20.0,
    output_torque=500.0,
    pin_circle_radius=0.05,
    contact_length=0.02,
    pin_radius=0.008,
    hole_radius=0.010,
    eccentricity=0.002,
    pin_material=PIN,
    hole_material=HOLE,
    has_body=True,
)
WHOLE = replace(
    REF,
    input_speed=50 * math.pi,
    pin=DesignPin(
        support="cantilever",
        diameter=0.016,
        satellite_positions=(0.015, 0.037),
        material=ElasticMaterial(210e9, 0.3, yield_strength=800e6),
        tensile_strength=1000e6,
        steel=True,
    ),
    fatigue=FatigueBasis(endurance_limit=300e6),
    friction=Friction(coefficient=0.08, wear_rate=1e-17, life=3000 * 3600.0),
    gear=Ring(
        kind="involute",
        module=3.5e-3,
        teeth_difference=1,
        reference_pressure_angle=math.radians(20),
    ),
    bearing=RollingBearing(kind="ball", dynamic_rating=60e3, static_rating=40e3),
    crankshaft=Shaft(
        satellite_positions=(0.020, 0.042), bearing_positions=(0.0, 0.062), satellite_mass=1.5
    ),
)
"""The same with all its sections: the design of which strengths and lives are known by hand."""


def says(check: Check, **expected: Any) -> None:
    """What a check says; what is not named has its default."""
    plain = {"limit": None, "utilisation": None, "torque_reserve": None}
    plain |= {"impossible": False, "warning": False, "reason": "", "missing": ()}
    for name, value in (plain | expected).items():
        found = getattr(check, name)
        if isinstance(value, float) and value:
            assert found == pytest.approx(value, rel=1e-12), name
        else:
            assert found == value, name
