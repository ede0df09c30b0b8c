"""Each check names the inputs that it depends on: to move one of them moves its value, its limit
or whether it warns in some design, and to move another one never does.
"""

import importlib
import math
from collections import ChainMap
from collections.abc import Callable, Container, Iterator
from contextlib import contextmanager, nullcontext
from dataclasses import fields, replace
from functools import partial
from pkgutil import iter_modules
from typing import Any

import numpy as np
import pytest

from core import checks
from core.checks import bearings, contacts, pins
from core.checks.check import Check, Kind
from core.checks.crank_planetary import CRANK_CHECKS, crank_check, crank_codes
from core.checks.records import CHECKS
from core.design import crank_results, losses, results, ring_results
from core.design.document import Design
from core.design.results import Results
from core.design.ring import CycloidRing
from core.design.ring_results import RingResults
from core.design.sections import (
    Build,
    FatigueBasis,
    Friction,
    Requirements,
    Rollers,
    RollingBearing,
    SatelliteBody,
    SeatedBearing,
    Shaft,
    Temperatures,
)
from core.errors import CalculationError, if_known
from core.hertz import ContactLimit, ElasticMaterial, Plastic, Spread
from core.material_table import MATERIALS
from core.output import real_mechanism
from core.output.edge_load import SlopingContacts
from core.output.elasticity import CrankSupport, PowerLaw, RingInSeries
from core.output.pin_bolt import PinBolt
from core.output.pin_strength import PinStresses
from core.output.room import Deviations
from core.output.stage import Stage
from core.ring.profile import Modification
from tests.inputs.checks import WHOLE, design_of, having
from tests.oracles.seeds import TIMES

assert WHOLE.pin and WHOLE.bearing and WHOLE.crankshaft and WHOLE.friction and WHOLE.gear
STEEL = MATERIALS["steel_case_hardened"].material
ENVELOPE = {
    "bore_diameter": 0.025,
    "outer_diameter": 0.04,
    "width": 0.0199,
    "limiting_speed": 400.0,
}
LASTING = ElasticMaterial(
    210e9, 0.3, ContactLimit("given", 2e9, curve="hardened"), yield_strength=900e6
)
INVOLUTE = replace(
    WHOLE.gear,  # type: ignore[type-var]
    satellite_profile_shift=0.05,
    ring_profile_shift=0.3,
    satellite_addendum=0.6,
    ring_addendum=0.55,
    rack_tip_radius=0.3,
    contact_length=0.018,
    satellite_material=LASTING,
    ring_material=LASTING,
    root_strength=800e6,
    face_load_factor=1.1,
    friction_coefficient=0.06,
)
"""Teeth whose shifts and heights are known."""
ALL = having(
    WHOLE,
    gear=INVOLUTE,
    max_ring_backlash=1.0,
    min_ring_efficiency=0.5,
    outer_radius=0.08,
    root_radius=0.072,
    bore_radius=0.02,
    min_wall=1e-3,
    max_backlash=1e-3,
    max_lost_motion=2e-3,
    min_efficiency=0.9,
    max_wear=1e-4,
    max_pv=1e7,
    max_sliding_speed=5.0,
    max_slope=5e-3,
    max_deflection=1e-4,
    max_outer_diameter=0.3,
    max_length=0.1,
    max_unbalance=100.0,
    max_unbalance_couple=10.0,
    static_safety=1.5,
    friction=replace(WHOLE.friction, sleeve=True),
    pin=replace(WHOLE.pin, diameter=0.014),
    bearing=replace(WHOLE.bearing, weibull_slope=10 / 9, ring_factor=1.1),
    crankshaft=replace(
        WHOLE.crankshaft,
        bearings=(
            SeatedBearing(kind="ball", dynamic_rating=50e3, static_rating=20e3, **ENVELOPE),
            SeatedBearing(kind="roller", dynamic_rating=60e3, static_rating=30e3, **ENVELOPE),
        ),
        shaft_diameter=0.02,
    ),
)
"""All sections and demands; the satellites' bearings by the room for them."""
BEARING: RollingBearing = replace(ALL.bearing, **ENVELOPE)  # type: ignore[type-var]
TIRED = FatigueBasis(surface="ground", fatigue_notch_factor=1.5)
ROLLERS = Rollers(
    kind="ball",
    bore_diameter=0.010,
    width=0.006,
    per_satellite=2,
    dynamic_rating=90e3,
    static_rating=30e3,
    rolling_elements=8,
    max_radial_load=3000.0,
    max_static_radial_load=4000.0,
    radial_clearance=4e-5,
    limiting_speed=60.0,
)
ROLLED = having(
    ALL,
    friction=replace(ALL.friction, sleeve=False),  # type: ignore[type-var]
    pin=replace(ALL.pin, diameter=0.010, bore_diameter=0.004),  # type: ignore[type-var]
    rollers=ROLLERS,
    hole_radius=0.01002,
    peak_torque=700.0,
)
SEATED = having(
    ALL,
    crankshaft=replace(
        ALL.crankshaft,  # type: ignore[type-var]
        bearings=tuple(
            replace(each, seat=seat)
            for each, seat in zip(ALL.crankshaft.bearings or (), ("carrier", "ring"), strict=True)
        ),
    ),
)
"""Bearings of the crankshaft in members that turn."""
BOLTED = replace(
    ALL.pin,  # type: ignore[type-var]
    support="supported",
    span=0.062,
    bore_diameter=0.007,
    bolt=PinBolt(core_diameter=0.005, preload=10e3, preload_scatter=1.4),
)
BOTH = having(
    SEATED,
    output="both",
    fatigue=TIRED,
    output_torque=1500.0,
    life=3e4,
    pin_material=STEEL,
    hole_material=STEEL,
    friction=replace(ALL.friction, life=None),  # type: ignore[type-var]
)
DESIGNS = {
    "a dead centre, satellites alike": design_of(
        pins=2, satellites=2, ratio=3.0, crank_spacing=math.pi, satellite_teeth=3
    ),
    "rollers": ROLLED,
    "rollers without clearance": having(
        ROLLED, hole_radius=0.010, rollers=replace(ROLLERS, radial_clearance=None, width=0.02)
    ),
    "rollers and bored pins under stated sharing": having(
        ROLLED,
        hole_radius=0.010,
        rollers=replace(ROLLERS, radial_clearance=None),
        peak_torque=None,
        distribution_factor=1.2,
    ),
    "rollers on pins that are not known": having(
        ROLLED, pin=None, rollers=replace(ROLLERS, friction_coefficient=0.002), peak_torque=None
    ),
    "ideal": ALL,
    "bolted pins, stated sharing": having(ALL, pin=BOLTED, distribution_factor=1.2),
    "clearance": having(ALL, hole_radius=0.01002),
    "bearings of known sizes": having(ALL, bearing=replace(BEARING, outer_diameter=0.039)),
    "eccentrics of a known diameter": having(
        ALL,
        bearing=replace(BEARING, width=0.0203, static_rating=10e3),
        crankshaft=replace(ALL.crankshaft, eccentric_diameter=0.02485),  # type: ignore[type-var]
    ),
    "eccentrics in the room": having(
        ALL,
        bearing=replace(ALL.bearing, static_rating=1e5),  # type: ignore[type-var]
        crankshaft=replace(ALL.crankshaft, eccentric_diameter=0.024),  # type: ignore[type-var]
    ),
    "peak torque": having(ALL, peak_torque=2000.0),
    "peak torque, ideal forces": having(ALL, pin=None, fatigue=None, peak_torque=900.0),
    "peak torque, bolted pins, uneven cranks": having(
        ALL,
        pin=BOLTED,
        torque_direction="reverse",
        peak_torque=700.0,
        crank_spacing=2.0,
        hole_radius=0.01002,
    ),
    "a share of unbalance, bolted pins": having(
        ALL, pin=BOLTED, max_unbalance_share=1e-4, crank_spacing=2.0
    ),
    "a share of unbalance beside a stated sharing": having(
        ALL, pin=None, max_unbalance_share=1e-4, crank_spacing=2.0, distribution_factor=1.2
    ),
    "a balance grade": having(
        ALL,
        max_unbalance=None,
        max_unbalance_couple=None,
        balance_grade=0.01,
        crank_spacing=2.0,
        crankshaft=replace(ALL.crankshaft, rotor_mass=5.0),  # type: ignore[type-var]
    ),
    "fast": having(
        ALL,
        output_torque=1.0,
        input_speed=1000.0,
        gear=CycloidRing(ring_pin_circle_radius=0.085, ring_pin_radius=0.005),
    ),
    "roots by the module": having(ALL, root_radius=None, outer_radius=None, gear=WHOLE.gear),
    "roots by the shift": having(
        ALL, root_radius=None, outer_radius=None, scope=("body",), pin=None
    ),
    "rim within the roots": having(ALL, root_radius=None, outer_radius=0.02),
    "bolted pins that drive a ring": having(
        ALL, pin=BOLTED, crankshaft=None, output="ring", hole_radius=0.01002
    ),
    "both as output, by the ring": having(BOTH, ring_speed=10.0),
    "both as output, by the pins": having(BOTH, carrier_speed=-5.0),
    "cycloid": having(
        ALL,
        gear=CycloidRing(ring_pin_circle_radius=0.085, ring_pin_radius=0.005),
        root_radius=None,
    ),
    "cycloid of a ratio that stays whole where it grows by a fiftieth": design_of(
        pins=6,
        satellites=2,
        ratio=50.0,
        eccentricity=0.002,
        gear=CycloidRing(
            ring_pin_circle_radius=0.2,
            ring_pin_radius=0.005,
            teeth_difference=1,
        ),
    ),
    "cycloid on an even number of pins": design_of(
        pins=6,
        satellites=2,
        ratio=49.0,
        eccentricity=0.002,
        gear=CycloidRing(ring_pin_circle_radius=0.2, ring_pin_radius=0.005),
    ),
}
SOFT = ElasticMaterial(
    3e9, 0.36, yield_strength=60e6, plastic=Plastic(softening=Spread.of(60.0), long_term_factor=0.5)
)
PLASTIC = having(
    ALL,
    hole_material=SOFT,
    friction=replace(ALL.friction, sleeve=False, coefficient=0.3),  # type: ignore[type-var]
    solid_wall=1e-3,
    temperatures=Temperatures(satellite=70.0, pins=80.0),
    gear=None,
    bearing=None,
    crankshaft=None,
    max_lost_motion=None,
    fatigue=None,
)
"""The same with holes of plastic and bare pins, without what hangs on neither."""
DESIGNS |= {
    "bare pins": having(
        PLASTIC,
        hole_material=ALL.contact.hole_material,
        friction=replace(ALL.friction, sleeve=False, coefficient=0.05),  # type: ignore[type-var]
        distribution_factor=1.2,
    ),
    "plastic, stated sharing": having(PLASTIC, distribution_factor=1.2),
    "plastic, uneven cranks": having(PLASTIC, crank_spacing=2.0, hole_radius=0.01002),
    "plastic pins, peak torque": having(PLASTIC, pin_material=SOFT, peak_torque=2000.0),
    "plastic holes, bored pins that drive a ring": having(
        PLASTIC,
        output="ring",
        hole_radius=0.01002,
        pin=replace(ALL.pin, bore_diameter=0.007),  # type: ignore[type-var]
    ),
    "rollers in plastic holes": having(
        ROLLED, hole_material=SOFT, solid_wall=1e-3, temperatures=PLASTIC.temperatures
    ),
}

TOOTHED = design_of(
    pins=6,
    satellites=2,
    ratio=6.0,
    crank_spacing=3.0,
    output_torque=100.0,
    input_speed=100.0,
    pin_circle_radius=0.03,
    contact_length=0.01,
    pin_radius=0.004,
    hole_radius=0.008,
    eccentricity=0.004,
    pin_material=LASTING,
    hole_material=LASTING,
    application_factor=1.1,
    satellite_body=SatelliteBody(),
    friction=Friction(coefficient=0.05),
    min_wall=1e-3,
    max_ring_backlash=1.0,
    max_transmission_error=1.0,
    max_pv=1e9,
    max_slope=1.0,
    min_efficiency=0.5,
    min_ring_efficiency=0.5,
    fatigue=TIRED,
    scope=("teeth", "body", "losses"),
    gear=CycloidRing(
        ring_pin_circle_radius=0.045,
        ring_pin_radius=0.004,
        modification=Modification(equidistant=1e-4, pin_circle=-1e-5, rotation=1e-4),
        pin_material=LASTING,
        pin_support="supported",
        span=0.05,
        satellite_positions=(0.018, 0.03),
        seat_stiffness=5e8,
        sleeve_bore_radius=0.003,
        friction_coefficient=0.06,
        tool_radius=0.003,
        pin_tensile_strength=1500e6,
        pin_steel=True,
    ),
)
"""Teeth on the pins of a ring, which bend in their sleeves."""
MANY = having(
    having(TOOTHED, crank_spacing=None, gear=None, satellite_body=None, friction=None),
    scope=("teeth",),
    satellites=1,
    ratio=50.0,
    eccentricity=0.0006,
    hole_radius=0.0046,
    peak_torque=200.0,
    life=3e4,
    gear=replace(
        TOOTHED.gear,  # type: ignore[type-var]
        ring_pin_radius=0.0015,
        sleeve_bore_radius=0.001,
        satellite_positions=(0.02,),
    ),
)
TOOTH = having(TOOTHED, scope=("teeth",), satellite_body=None, friction=None)
DESIGNS |= {
    "teeth": having(TOOTHED, fatigue=None, torque_direction="reverse"),
    "teeth under a factor": having(TOOTH, application_factor=1.2),
    "teeth that press": having(
        TOOTHED,
        output_torque=5.0,
        peak_torque=7.0,
        scope=("teeth", "losses"),
        gear=replace(
            TOOTHED.gear,  # type: ignore[type-var]
            modification=Modification(equidistant=-3e-5, pin_circle=-1e-5, rotation=1e-4),
            contact_length=0.011,
            disc_material=LASTING,
        ),
    ),
    "teeth of plastic": having(
        TOOTH,
        hole_material=SOFT,
        fatigue=None,
        output_torque=5.0,
        gear=replace(
            TOOTHED.gear,  # type: ignore[type-var]
            modification=Modification(equidistant=-5e-6, pin_circle=-1e-6, rotation=1e-4),
        ),
    ),
    "teeth of plastic whose friction is not given": having(
        TOOTH,
        hole_material=replace(SOFT, plastic=replace(SOFT.plastic, friction=Spread.of(0.3))),
        fatigue=None,
        max_slope=None,
        output_torque=5.0,
        gear=replace(
            TOOTHED.gear,  # type: ignore[type-var]
            modification=Modification(equidistant=-5e-6, pin_circle=-1e-6, rotation=1e-4),
            pin_support="seat",
            span=None,
            satellite_positions=(),
            sleeve_bore_radius=0.0,
            friction_coefficient=None,
        ),
    ),
    "teeth in seats": having(
        TOOTH,
        fatigue=None,
        max_slope=None,
        distribution_factor=1.2,
        max_seat_pressure=1e9,
        gear=replace(
            TOOTHED.gear,  # type: ignore[type-var]
            modification=Modification(equidistant=-5e-6, pin_circle=-1e-6, rotation=1e-4),
            pin_support="seat",
            span=None,
            satellite_positions=(),
        ),
    ),
    "teeth of a ratio that stays whole where it grows by a fiftieth": MANY,
    "such teeth that press": having(
        MANY,
        gear=CycloidRing(
            ring_pin_circle_radius=0.045,
            ring_pin_radius=0.0015,
            modification=Modification(equidistant=-1e-5, pin_circle=-5e-6, rotation=2e-5),
            pin_material=LASTING,
            friction_coefficient=0.06,
        ),
    ),
}

RINGED = CycloidRing(
    ring_pin_circle_radius=0.085,
    ring_pin_radius=0.005,
    teeth_difference=1,
    modification=Modification(equidistant=3e-5, pin_circle=-4e-5),
    contact_length=0.018,
    contact_law=PowerLaw(1.1, 1e3, 5e-6),
    pin_material=LASTING,
    pin_support="supported",
    span=0.06,
    satellite_positions=(0.018, 0.04),
    seat_stiffness=5e8,
    sleeve_bore_radius=0.004,
    friction_coefficient=0.06,
)
SERIES = having(
    ALL,
    pins=10,  # which repeat with the ring's lobes: a tenth of a turn is all
    hole_radius=0.01006,  # wide enough for an eccentricity that is a fiftieth larger
    peak_torque=700.0,
    pin_material=LASTING,
    hole_material=LASTING,
    satellite_coupling=RingInSeries(),
    pin=replace(ALL.pin, bore_diameter=0.004),  # type: ignore[type-var]
    gear=RINGED,
    root_radius=None,
    max_ring_backlash=1.0,
    max_transmission_error=1.0,
)
"""Both meshes in series."""
DESIGNS |= {
    "both meshes": SERIES,
    "both meshes, turned flanks, uneven cranks": having(
        SERIES,
        torque_direction="reverse",
        crank_spacing=2.0,
        application_factor=1.2,
        peak_torque=None,
        max_unbalance_share=1e-4,
        gear=replace(RINGED, modification=Modification(3e-5, -4e-5, 1e-4), contact_law=None),
    ),
    "both meshes, rollers": having(
        ROLLED,
        torque_direction="reverse",
        pins=10,
        peak_torque=700.0,
        satellite_coupling=RingInSeries(),
        gear=RINGED,
        max_unbalance_share=1e-4,
        crank_spacing=2.0,
    ),
}


TIPS = having(ALL, pin=None, fatigue=None, peak_torque=900.0, scope=("teeth",))
"""Involute teeth under ideal forces."""
DESIGNS |= {
    "involute teeth of given tips": having(
        TIPS,
        gear=replace(
            INVOLUTE,
            satellite_addendum=None,
            ring_addendum=None,
            satellite_tip_radius=0.0370125,
            ring_tip_radius=0.036575,
        ),
    ),
    "involute teeth of plastic": having(
        TIPS, peak_torque=None, gear=replace(INVOLUTE, satellite_material=SOFT)
    ),
    "involute teeth, those of the ring higher": having(
        TIPS, gear=replace(INVOLUTE, satellite_addendum=0.5, ring_addendum=0.6)
    ),
    "involute teeth of a ratio that stays whole where it grows by a fiftieth": having(
        TIPS,
        ratio=50.0,
        eccentricity=0.0016,
        hole_radius=0.0096,
        gear=replace(
            INVOLUTE,
            module=0.001,
            ring_profile_shift=0.9,
            cutter_teeth=18,
            cutter_profile_shift=0.05,
        ),
    ),
}

SPACE = having(
    WHOLE,
    scope=("body",),
    fatigue=None,
    friction=None,
    bearing=None,
    pin=replace(WHOLE.pin, diameter=0.014),
    outer_radius=0.068,
    min_wall=1e-3,
    max_outer_diameter=0.3,
    max_length=0.2,
)
"""Outer sizes alone."""
DESIGNS |= {
    "a housing of involute teeth": having(
        SPACE,
        crankshaft=None,
        pin_circle_radius=0.02,
        gear=replace(INVOLUTE, ring_profile_shift=0.6065),  # just below a whole millimetre
    ),
    "a wide carrier of bare pins": having(
        SPACE,
        gear=None,
        pin=None,
        pin_circle_radius=0.08,
        satellites=1,
        crankshaft=Shaft(
            satellite_positions=(0.02,),
            bearing_positions=(-0.005, 0.08),
            bearings=(SeatedBearing(kind="ball", width=0.01),) * 2,
        ),
    ),
    "a housing of bare satellites": having(SPACE, gear=None, crankshaft=None),
    "plates of the carrier": having(
        SPACE,
        crankshaft=None,
        pin=replace(ALL.pin, span=0.055),  # type: ignore[type-var]
        build=Build(
            gap=0.003, carrier_width=0.012, second_carrier_width=0.011, carrier_diameter=0.2
        ),
    ),
    "gaps beside the discs": having(
        SPACE,
        crankshaft=None,
        pin=replace(WHOLE.pin, diameter=0.014, contact_length=0.018),
        build=Build(gap=0.003, housing_diameter=0.2),
    ),
    "a wide housing": having(SPACE, crankshaft=None, build=Build(housing_width=0.15)),
}

OF_DISCS = ("eccentricity", "disc_phase")
OF_CRANKS = {"eccentricity": (4e-6,), "disc_phase": (1e-4,)}
OF_PINS = {"pin_radial": (8e-6,), "pin_radius": (1e-6, -2e-6)}
OF_RING = {"ring_pin_radial": (3e-6, -2e-6), "ring_pin_tangential": (0.0, 4e-6)}
ELASTIC = CrankSupport(stiffness=2e8, radial_clearance=1e-5)


def erring(design: Design, **made: tuple[float, ...]) -> Design:
    """A design with deviations of the last of its pins, satellites or pins of the ring."""
    rows = {}
    for name, row in made.items():
        of = design.mechanism.satellites if name in OF_DISCS else design.mechanism.pins
        count = design.ring_pins if name.startswith("ring_") else of
        rows[name] = (*[0.0] * (count - len(row)), *row[-count:])
    return having(design, deviations=Deviations(**rows))


LOOSE = {
    "all": having(ALL, hole_radius=0.01002),
    "bolted pins": having(ALL, pin=BOLTED, hole_radius=0.01002, peak_torque=700.0),
    "unbalance": having(
        ALL,
        hole_radius=0.01002,
        pin_material=LASTING,
        hole_material=LASTING,
        peak_torque=700.0,
        max_unbalance_share=1e-4,
        crank_spacing=2.0,
    ),
    "rollers": ROLLED,
    "plastic": having(PLASTIC, hole_radius=0.01002, peak_torque=2000.0),
}
TEETH = ("teeth", "teeth under a factor", "teeth of plastic")
AS_MADE = {
    **{f"{name}, deviations": erring(each, **OF_PINS) for name, each in LOOSE.items()},
    **{f"{name}, elastic": having(each, crank_support=ELASTIC) for name, each in LOOSE.items()},
    **{name: erring(DESIGNS[name], **OF_RING, **OF_CRANKS) for name in TEETH},
    "teeth in seats, stated sharing": erring(DESIGNS["teeth in seats"], **OF_RING),
    "cranks that deviate": erring(LOOSE["all"], **OF_CRANKS),
    "teeth on elastic cranks": having(TOOTHED, crank_support=ELASTIC, hole_radius=0.00802),
    "both meshes on elastic cranks": having(
        SERIES,
        crank_support=CrankSupport(2e8),
        gear=replace(RINGED, pin_tensile_strength=1500e6, pin_steel=True),
    ),
}
"""Designs in which deviations are moved, or what gives on the cranks."""

PERFECT = having(SERIES, hole_radius=0.010)
"""Both meshes in series, until a sharing is stated: it is refused beside clearance."""

INPUTS = {
    "pin.tensile_strength": "pin.material",
    "pin.steel": "pin.material",
    "gear.pin_tensile_strength": "gear.pin_material",
    "gear.pin_steel": "gear.pin_material",
}
"""Inputs by the paths of a design that have other names."""

MATERIALS_OF = (
    "contact.pin_material",
    "contact.hole_material",
    "pin.material",
    "gear.pin_material",
    "gear.disc_material",
    "gear.satellite_material",
    "gear.ring_material",
)
"""Inputs that are materials, each with values of its own."""

OF_MADE = ("deviations", "crank_support")

WHOLES = (*MATERIALS_OF, "gear.contact_law", "contact_law", "pin.bolt", *OF_MADE)
"""The same, laws of contact, a bolt, deviations and what gives."""

OTHERS = {"reverse": "driving", "supported": "fixed", "cantilever": "fixed"}
"""Of what is one of some values another one."""

SAME = 1e-6
"""Relative change that is no more than the error of a search."""


def moved(value: Any) -> Any:
    """A number that is a little larger, places of which the last is farther, what is not so; None
    of others.
    """
    if isinstance(value, Spread):
        return Spread.of(1.02 * value.usual)
    if isinstance(value, tuple) and value and (last := moved(value[-1])) is not None:
        return (*value[:-1], last)
    if isinstance(value, bool):
        return not value
    if isinstance(value, str):
        return OTHERS.get(value)
    if not isinstance(value, int | float):
        return None
    return value + 1 if isinstance(value, int) else 1.02 * value


def moves(design: Any) -> Iterator[tuple[str, Callable[[], Any]]]:
    """Inputs by their names, with the design in which they are moved."""
    for each in fields(design):
        value, name = getattr(design, each.name), each.name
        if hasattr(value, "__dataclass_fields__"):
            for inner, change in moves(value):
                yield (
                    f"{name}.{inner}",
                    lambda name=name, change=change: replace(design, **{name: change()}),
                )
        elif name != "satellites" and (to := moved(value)) is not None:
            yield name, partial(replace, design, **{name: to})


def differ(one: float | None, two: float | None) -> bool:
    if one is None or two is None or math.isinf(one):
        return one != two
    return abs(one - two) > SAME * abs(one)


def by_code(design: Design, codes: Container[str] = CHECKS) -> dict[str, Check]:
    """Checks of a design of which something is known, or that are none of it, as far as they are
    asked for.
    """
    results = Results(design)
    checks = [crank_check(code, results) for code in crank_codes(design) if code in codes]
    return {
        check.code: check
        for check in checks
        if check.status in ("pass", "marginal", "fail", "not_applicable") or check.only_needed
    }


def told(each: Any) -> Any:
    """Value that tells things apart: the value itself, or the identity."""
    try:
        hash(each)
    except TypeError:
        return id(each)
    return each


Made = ChainMap[Any, Any]
"""Results by what they follow from: those since an input was moved, and those of the design."""


def once(calculate: Callable[..., Any], made: Made) -> Callable[..., Any]:
    """A calculation that is made once of the same things: most inputs change few of them."""

    def found(*given: Any, **named: Any) -> Any:
        things = (*given, *named, *named.values())
        key = tuple(map(told, things))
        if key not in made:
            made[key] = calculate(*given, **named), things  # kept, as is what tells them
        return made[key][0]

    return found


def of_the_same(plain: Any, things: Callable[[Any], tuple[Any, ...]], made: Made) -> Any:
    """A derived value that is worked out once of the same things."""
    calculate = getattr(plain, "func", None) or plain.calculate

    def found(results: Any) -> Any:
        if (of := if_known(lambda: things(results))) is None:
            return calculate(results)
        key = tuple(map(told, of))
        if key not in made:
            made[key] = calculate(results), of
        return made[key][0]

    return type(plain)(found)


def solved(found: Results) -> tuple[Any, ...]:
    """Solutions over the turn that a check uses, by kind of forces."""
    return (found.series if found.in_series else found.real, found.solved)


ONCE: tuple[tuple[Any, str], ...] = (
    (PinStresses, "strength"),
    (SlopingContacts, "largest"),
    (bearings, "largest_ratings_of_room"),
    (crank_results, "crankshaft"),
    (crank_results, "satellite_bearings"),
    (losses, "pin_losses"),
    (real_mechanism, "hertz"),
    (results, "contact_compliance"),
    (results, "first_yield_factor"),
    (results, "pin_rollers"),
    (results, "pin_stresses"),
    (ring_results, "involute_load"),
    (ring_results, "involute_pair"),
    (ring_results, "mesh_over_turn"),
    (ring_results, "pin_stresses"),
    (ring_results, "ring_loss"),
)
"""Calculations that follow from what they are given alone."""

OF_THE_SAME: tuple[tuple[type, str, Callable[[Any], tuple[Any, ...]]], ...] = (
    (Results, "turn", solved),
    (Results, "over_turn", solved),
    (Results, "made", solved),
    (
        Results,
        "sloping",
        lambda found: (found.pin_stresses, found.design.pair.contact_length, found.compliance),
    ),
    (
        RingResults,
        "turn",
        lambda found: (found.mesh, found.output.in_series and found.output.series),
    ),
    (RingResults, "on_pins", lambda found: (found.turn,)),
)
"""Values, each with what it follows from alone."""


def of_drive(name: str, made: Made) -> Callable[..., Any]:
    """Solutions of a stage, made once of the same numbers in its drive."""
    calculate = getattr(Stage, name)

    def found(stage: Any, places: Any, *given: Any, **named: Any) -> Any:
        numbers = (*stage.drive, np.array(places, float))
        key = *(each.tobytes() for each in numbers), given, *named.items()
        if key not in made:
            made[key] = calculate(stage, places, *given, **named)
        return made[key]

    return found


@contextmanager
def solved_once() -> Iterator[Callable[[], None]]:
    """Within, what an input does not change is not solved again, until the function that is given
    is called: it ends what is kept, and forgets all since it was called before. What `OF_THE_SAME`
    says of what a value follows from is believed there; `make accuracy` solves all again.
    """
    kept: list[Made] = []

    def made() -> Made:
        kept.append(ChainMap({}))
        return kept[-1]

    def forget() -> None:
        for each in kept:
            each.maps[:] = [{}, each.maps[-1]]

    with pytest.MonkeyPatch.context() as patch:
        for place, name in ONCE:
            patch.setattr(place, name, once(getattr(place, name), made()))
        for name in ("solved", "unloaded"):
            patch.setattr(Stage, name, of_drive(name, made()))
        for kind, name, things in OF_THE_SAME:
            shared = of_the_same(getattr(kind, name), things, made())
            shared.__set_name__(kind, name)
            patch.setattr(kind, name, shared)
        yield forget


def look(
    design: Design,
    found: dict[tuple[str, str], bool],
    inputs: Container[str] | None = None,
    turn: int = 0,
) -> None:
    """Move each input of a design, or some, and see which checks move: those of which it is not
    known yet that they do, as their names of inputs say. Of what no name says, `make test` tries
    one input of three in each design, in turn.
    """
    with nullcontext(lambda: None) if TIMES > 1 else solved_once() as forget:
        made = by_code(design).items()
        before = {code: check for code, check in made if check.status != "not_applicable"}
        for number, (name, change) in enumerate(moves(design)):
            of = input_of(name)
            if inputs and of not in inputs:
                continue
            others = TIMES > 1 or bool(inputs) or (number + turn) % 3 == 0
            open_ = {
                code
                for code in before
                if (not found.get((code, of)) if named(code, of) else others)
            }
            if not open_:
                continue
            forget()
            try:
                after = by_code(change(), open_)
            except CalculationError:  # no such bearing, no such mesh
                continue
            for code, two in after.items():
                one = before[code]
                values = (one.value, two.value), (one.limit, two.limit)
                of_other = one.warning != two.warning or two.status == "not_applicable"
                moves_it = of_other or any(differ(*each) for each in values)
                found[code, of] = found.get((code, of), False) or moves_it


def seen() -> dict[tuple[str, str], bool]:
    """True if a check changes with an input in any of the designs."""
    found: dict[tuple[str, str], bool] = {}
    for turn, design in enumerate(DESIGNS.values()):
        look(design, found, turn=turn)
    for design in AS_MADE.values():
        look(design, found, OF_MADE)
    look(PERFECT, found, {"contact.distribution_factor"})
    return found


def input_of(name: str) -> str:
    """Name of the input of an attribute."""
    whole = next((each for each in WHOLES if name.startswith(f"{each}.")), name)
    return INPUTS.get(name, whole)


def named(code: str, name: str) -> bool:
    return name in CHECKS[code].inputs


def test_a_check_names_what_moves_it_and_nothing_else() -> None:
    """With both meshes in series the forces are one solution, so that an input of the ring moves
    the checks of the pins through the forces alone, and the other way round. One check has to show
    it, except for inputs that have designs of their own.
    """
    found = seen()  # once for both, as it takes a minute, and tests may run apart
    assert {pair for pair, moves_it in found.items() if moves_it and not named(*pair)} == set()
    without_value = {"contact_conformity", "fatigue_plastic", "mesh_ring_root"}
    assert CRANK_CHECKS.keys() - {code for code, _ in found} == without_value
    felt = {(of_ring(code), name) for (code, name), moves_it in found.items() if moves_it}
    idle = {
        (code, name)
        for (code, name), moves_it in found.items()
        if named(code, name) and not moves_it
        if of_ring(code) == name.startswith("gear.")
        or (of_ring(code), name) not in felt
        or name in OF_MADE
    }
    assert idle == set()


def of_ring(code: str) -> bool:
    return code.startswith("ring_")


FOLLOWS = {
    "contact.pin_radius": "contact.hole_radius",
    "contact.fit": "contact.hole_radius",
    "crankshaft.bearings.dynamic_rating": "crankshaft.bearings",
    "crankshaft.bearings.name": "crankshaft.bearings",
    "shaft_sections.diameter": "shaft_sections",
}
"""What moves with an input that a fix changes: the hole with its pin, a bearing with its rating, a
shaft with its stretches.
"""


def rating_of(code: str) -> str:
    """Rating that the name of a bearing states, which decides a check."""
    return "static_rating" if code.endswith("static") else "dynamic_rating"


def test_what_a_fix_changes_is_an_input_or_moves_one() -> None:
    strange = {
        (code, name)
        for code, kind in CHECKS.items()
        for name in kind.fixes
        if not {name, FOLLOWS.get(name)} & {*kind.inputs}
        and not (name.endswith(".name") and name.replace("name", rating_of(code)) in kind.inputs)
    }
    assert strange == set()


def test_every_record_is_found_by_its_code() -> None:
    modules = [
        importlib.import_module(f"core.checks.{each.name}")
        for each in iter_modules(checks.__path__)
    ]
    kinds = [kind for each in modules for kind in vars(each).values() if isinstance(kind, Kind)]
    assert len(kinds) > 30 and all(CHECKS[kind.code] is kind for kind in kinds)


def test_every_code_of_a_row_is_that_of_one_check() -> None:
    rows = [*bearings.ROWS, *contacts.IN_HOLES.values(), *contacts.IN_RING.values(), *pins.ROWS]
    codes = [code for row in rows for code in row.codes.values()]
    assert len(codes) > 30 and len({*codes}) == len(codes) and {*codes} <= {*CHECKS}


def test_what_may_be_asked_is_an_input() -> None:
    for code, kind in CHECKS.items():
        asked = {kind.asks, f"requirements.{kind.asks}"}
        assert not kind.asks or asked & {*kind.inputs}, code
        assert {*kind.requires, *kind.demands} <= {*kind.inputs}, code
        assert not kind.asks or hasattr(Requirements(), kind.asks), code
