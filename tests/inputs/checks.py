"""A design whose checks are known by hand, designs like it, and what a check says."""

import math
from collections.abc import Iterable, Mapping
from dataclasses import fields
from typing import Any

import pytest

from core.checks.check import Check
from core.checks.crank_planetary import crank_check
from core.checks.reserve import crank_verdict
from core.design.contact import Contact
from core.design.document import Design, changed
from core.design.results import Results
from core.design.ring import InvoluteRing
from core.design.sections import (
    DesignPin,
    FatigueBasis,
    Friction,
    Load,
    MechanismSection,
    Requirements,
    RollingBearing,
    SatelliteBody,
    Shaft,
)
from core.fixes.changes import Search
from core.fixes.crank import crank_fixes, possible
from core.fixes.fix import Fix
from core.hertz import ContactLimit, ElasticMaterial
from core.precision import SAME

PIN = ElasticMaterial(210e9, 0.3, ContactLimit("given", 900e6), yield_strength=300e6)
HOLE = ElasticMaterial(210e9, 0.3, ContactLimit("given", 600e6), yield_strength=200e6)
SECTIONS: dict[str, Any] = {
    "mechanism": MechanismSection,
    "load": Load,
    "contact": Contact,
    "satellite_body": SatelliteBody,
    "requirements": Requirements,
}
PLACES = {
    each.name: f"{section}.{each.name}"
    for section, kind in SECTIONS.items()
    for each in fields(kind)
}
"""Paths of the values of sections that have no name in common."""


def design_of(**values: Any) -> Design:
    """A design of values by such names, and of other sections."""
    sections: dict[str, Any] = {}
    for name, value in values.items():
        section, _, field = PLACES.get(name, name).partition(".")
        if field:
            sections.setdefault(section, {})[field] = value
        else:
            sections[section] = value
    if isinstance(contact := sections.get("contact"), dict):  # of perfect parts where of none
        contact.setdefault("clearance_stated", True)
    return Design(
        **{
            name: SECTIONS[name](**each) if isinstance(each, dict) else each
            for name, each in sections.items()
        }
    )


def having(design: Design, **values: Any) -> Design:
    """A design with other values, by names that one of these sections has, or with other sections:
    None for one that is not given.
    """
    absent = {each.name: each.default for each in fields(Design)}
    paths = {PLACES.get(name, name): value for name, value in values.items()}
    gone = {name for name, value in paths.items() if value is None and name in absent}
    return changed(design, paths | {name: absent[name] for name in gone})


def with_requirements(values: Mapping[str, Any]) -> dict[str, Any]:
    """Values of a design that is no document, with those that are requirements as its own."""
    names = {each.name for each in fields(Requirements)} & {*values}
    requirements = Requirements(**{name: values[name] for name in names})
    return {name: value for name, value in values.items() if name not in names} | {
        "requirements": requirements
    }


def check_of(code: str, design: Design) -> Check:
    """One check of a design."""
    return crank_check(code, Results(design))


def fixes_of(design: Design, codes: Iterable[str]) -> list[Fix]:
    """Fixes of checks of a design."""
    results = Results(design)
    found = crank_fixes(search=Search(results, crank_verdict(results)), codes=codes)
    return [each for each in found if possible(each)]


REF = design_of(
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
    satellite_body=SatelliteBody(),
)
WHOLE = having(
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
    gear=InvoluteRing(
        module=1.75e-3,
        teeth_difference=2,
        reference_pressure_angle=math.radians(20),
    ),
    bearing=RollingBearing(kind="ball", dynamic_rating=60e3, static_rating=40e3),
    crankshaft=Shaft(
        satellite_positions=(0.020, 0.042), bearing_positions=(0.0, 0.062), satellite_mass=1.5
    ),
)
"""The same with all its sections: the design of which strengths and lives are known by hand."""


def says(check: Check, **expected: Any) -> None:
    """Assert the attributes of a check; those that are not named have their defaults."""
    plain = {"limit": None, "utilisation": None, "torque_reserve": None}
    plain |= {"impossible": False, "warning": False, "reason": "", "missing": ()}
    for name, value in (plain | expected).items():
        found = getattr(check, name)
        if isinstance(value, float) and value:
            assert found == pytest.approx(value, rel=SAME), name
        else:
            assert found == value, name


STATED: dict[str, dict[str, Any]] = {
    "mechanism": {"pins": 6, "satellites": 2, "ratio": 20.0},
    "load": {"output_torque": 200.0, "pin_circle_radius": 0.036, "input_speed": 150.0},
    "contact": {
        "contact_length": 0.020,
        "pin_radius": 0.006,
        "eccentricity": 0.002,
        "hole_clearance": 2e-5,
    },
    "pin": {"support": "supported"},
    "gear": {"kind": "cycloid", "ring_pin_circle_radius": 0.065, "ring_pin_radius": 0.004},
    "crankshaft": {},
    "build": {},
}
"""Two discs of 20 mm between two plates, as a document states them."""
