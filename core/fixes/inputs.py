"""Which inputs a fix of a check may change, and how the check grows with them."""

from core.checks.pins import PIN_FATIGUE
from core.checks.pins import PINS as PIN_CHECKS

_STRESS = (
    "pin.diameter",
    "contact.contact_length",
    "contact.pin_radius",
    "load.pin_circle_radius",
    "mechanism.pins",
    "mechanism.satellites",
    "load.output_torque",
)

_PIN = (
    "pin.diameter",
    "contact.pin_radius",
    "load.pin_circle_radius",
    "mechanism.pins",
    "load.output_torque",
)

_LIFE = (
    "bearing.dynamic_rating",
    "load.pin_circle_radius",
    "load.input_speed",
    "load.output_torque",
)

VARIED: dict[str, tuple[str, ...]] = {
    "dead_centre": ("mechanism.pins", "mechanism.satellites"),
    "crank_balance": ("mechanism.crank_spacing",),
    "contact_pressure_pin": _STRESS,
    "contact_pressure_hole": _STRESS,
    "contact_shakedown_pin": _STRESS,
    "contact_shakedown_hole": _STRESS,
    "contact_yield_pin": _STRESS,
    "contact_yield_hole": _STRESS,
    "contact_conformity": _STRESS,
    "interference": ("contact.hole_radius",),
    "clearance": ("contact.hole_radius",),
    "backlash": ("contact.hole_radius",),
    "lost_motion": ("contact.hole_radius",),
    "wall_holes": ("load.pin_circle_radius", "contact.pin_radius", "mechanism.pins"),
    "pins_apart": ("load.pin_circle_radius", "contact.pin_radius", "mechanism.pins"),
    "holes_off_centre": ("load.pin_circle_radius", "contact.pin_radius"),
    "wall_rim": (
        "satellite_body.outer_radius",
        "satellite_body.root_radius",
        "load.pin_circle_radius",
        "contact.pin_radius",
    ),
    "wall_bore": ("satellite_body.bore_radius", "load.pin_circle_radius", "contact.pin_radius"),
    "roller_stress": (
        "diameter",
        "hole_circle_radius",
        "rollers",
        "position_tolerance",
        "output_torque",
    ),
    "roller_fatigue": ("diameter", "hole_circle_radius", "rollers", "output_torque"),
    "roller_sharing": ("position_tolerance", "output_torque"),
    "roller_spacing": ("hole_circle_radius", "sphere_diameter", "rollers"),
    "roller_room": ("hole_circle_radius", "sphere_diameter"),
    "roller_tilt": ("cylinder_length",),
    "assembly": ("mechanism.satellites",),
    "outer_diameter": ("satellite_body.outer_radius",),
    "pin_static": (*_PIN, "load.peak_torque"),
    "pin_fatigue": _PIN,
    "pin_deflection": _PIN,
    "pin_slope": _PIN,
    "efficiency": ("friction.coefficient", "load.pin_circle_radius", "pin.diameter"),
    "sliding_speed": ("load.input_speed", "pin.diameter"),
    "pv": (
        "contact.pin_radius",
        "contact.contact_length",
        "load.pin_circle_radius",
        "load.input_speed",
        "load.output_torque",
    ),
    "wear": (
        "friction.wear_rate",
        "contact.contact_length",
        "contact.pin_radius",
        "load.pin_circle_radius",
        "load.input_speed",
        "load.output_torque",
    ),
    "pressure_angle": ("gear.module",),
    "gear_room": (
        "load.pin_circle_radius",
        "contact.pin_radius",
        "gear.ring_pin_circle_radius",
        "gear.ring_pin_radius",
    ),
    "bearing_life": _LIFE,
    "bearing_static": (
        "bearing.static_rating",
        "load.pin_circle_radius",
        "load.output_torque",
        "load.peak_torque",
    ),
    "system_life": _LIFE,
    "crank_bearing_life": (
        "crankshaft.bearings.dynamic_rating",
        "load.pin_circle_radius",
        "load.input_speed",
        "load.output_torque",
    ),
    "unbalance_force": ("crankshaft.satellite_mass", "load.input_speed"),
    "unbalance_couple": ("crankshaft.satellite_mass", "load.input_speed"),
    "line_spacing": ("roller_radius", "roller_circle_radius"),
    "shaft_in_circle": ("shaft_diameter", "roller_radius", "roller_circle_radius"),
    "shaft_deflection": ("shaft_diameter", "overhang", "bearing_distance"),
    "shaft_slope": ("shaft_diameter", "overhang", "bearing_distance"),
    "shaft_static": ("shaft_diameter", "overhang"),
    "shaft_fatigue": ("shaft_diameter", "overhang"),
    "line_pressure": ("roller_radius", "roller_circle_radius"),
}
"""Inputs that a fix of a check may change, by their core names."""

WHOLE = {"mechanism.pins", "mechanism.satellites", "rollers"}
"""Inputs that are whole numbers."""

GROWTH = {
    "pin.diameter": 2.0,
    "contact.contact_length": 1.0,
    "contact.pin_radius": 1.8,
    "load.pin_circle_radius": 1.0,
    "load.output_torque": -1.0,
}
"""With which power of an input the torque reserve of a pressure grows, about: where a search for a
fix of the mechanism as it is made starts."""

PINS = {*PIN_CHECKS, *PIN_FATIGUE}
"""Checks of the pin itself: its sleeve does not count."""

POWERS = {
    "pin_static": {"pin.diameter": 3.0, "contact.pin_radius": 3.0, "load.peak_torque": -1.0},
    "pin_fatigue": {"pin.diameter": 3.0, "contact.pin_radius": 3.0},
    "pin_deflection": {"pin.diameter": 4.0, "contact.pin_radius": 4.0},
    "pin_slope": {"pin.diameter": 4.0, "contact.pin_radius": 4.0},
    "efficiency": {"pin.diameter": -1.0},
    "sliding_speed": {"pin.diameter": -1.0},
    "pv": {},
    "wear": {},
    "bearing_life": {"bearing.dynamic_rating": 1.0, "load.input_speed": -0.3},
    "bearing_static": {"bearing.static_rating": 1.0, "load.peak_torque": -1.0},
    "system_life": {"bearing.dynamic_rating": 1.0, "load.input_speed": -0.3},
    "crank_bearing_life": {"crankshaft.bearings.dynamic_rating": 1.0, "load.input_speed": -0.3},
    "unbalance_force": {"load.input_speed": -2.0},
    "unbalance_couple": {"load.input_speed": -2.0},
    "outer_diameter": {"satellite_body.outer_radius": -1.0},
}
"""The same of checks that grow or fall with a power of their inputs: of the reserve, else of the
reciprocal of the utilisation. What is not named is one of `USUAL`."""

USUAL = {
    "contact.contact_length": 1.0,
    "contact.pin_radius": 1.0,
    "load.pin_circle_radius": 1.0,
    "load.output_torque": -1.0,
    "load.input_speed": -1.0,
    "friction.coefficient": -1.0,
    "friction.wear_rate": -1.0,
    "crankshaft.satellite_mass": -1.0,
}
