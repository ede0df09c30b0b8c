"""Which inputs a fix of a check may change, and how the check grows with them."""

from core.checks.pins import PIN_FATIGUE
from core.checks.pins import PINS as PIN_CHECKS

_STRESS = (
    "pin.diameter",
    "contact_length",
    "pin_radius",
    "pin_circle_radius",
    "pins",
    "satellites",
    "output_torque",
)

_PIN = ("pin.diameter", "pin_radius", "pin_circle_radius", "pins", "output_torque")

_LIFE = ("bearing.dynamic_rating", "pin_circle_radius", "input_speed", "output_torque")

VARIED: dict[str, tuple[str, ...]] = {
    "dead_centre": ("pins", "satellites"),
    "crank_balance": ("crank_spacing",),
    "contact_pressure_pin": _STRESS,
    "contact_pressure_hole": _STRESS,
    "contact_shakedown_pin": _STRESS,
    "contact_shakedown_hole": _STRESS,
    "contact_yield_pin": _STRESS,
    "contact_yield_hole": _STRESS,
    "contact_conformity": _STRESS,
    "interference": ("hole_radius",),
    "clearance": ("hole_radius",),
    "backlash": ("hole_radius",),
    "lost_motion": ("hole_radius",),
    "wall_holes": ("pin_circle_radius", "pin_radius", "pins"),
    "pins_apart": ("pin_circle_radius", "pin_radius", "pins"),
    "holes_off_centre": ("pin_circle_radius", "pin_radius"),
    "wall_rim": ("outer_radius", "root_radius", "pin_circle_radius", "pin_radius"),
    "wall_bore": ("bore_radius", "pin_circle_radius", "pin_radius"),
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
    "assembly": ("satellites",),
    "outer_diameter": ("outer_radius",),
    "pin_static": (*_PIN, "peak_torque"),
    "pin_fatigue": _PIN,
    "pin_deflection": _PIN,
    "pin_slope": _PIN,
    "efficiency": ("friction.coefficient", "pin_circle_radius", "pin.diameter"),
    "sliding_speed": ("input_speed", "pin.diameter"),
    "pv": ("pin_radius", "contact_length", "pin_circle_radius", "input_speed", "output_torque"),
    "wear": (
        "friction.wear_rate",
        "contact_length",
        "pin_radius",
        "pin_circle_radius",
        "input_speed",
        "output_torque",
    ),
    "pressure_angle": ("gear.module",),
    "gear_room": (
        "pin_circle_radius",
        "pin_radius",
        "gear.ring_pin_circle_radius",
        "gear.ring_pin_radius",
    ),
    "bearing_life": _LIFE,
    "bearing_static": (
        "bearing.static_rating",
        "pin_circle_radius",
        "output_torque",
        "peak_torque",
    ),
    "system_life": _LIFE,
    "crank_bearing_life": (
        "crankshaft.dynamic_rating",
        "pin_circle_radius",
        "input_speed",
        "output_torque",
    ),
    "unbalance_force": ("crankshaft.satellite_mass", "input_speed"),
    "unbalance_couple": ("crankshaft.satellite_mass", "input_speed"),
    "line_spacing": ("roller_radius", "roller_circle_radius"),
    "shaft_in_circle": ("shaft_diameter", "roller_radius", "roller_circle_radius"),
    "shaft_deflection": ("shaft_diameter", "overhang", "bearing_distance"),
    "shaft_slope": ("shaft_diameter", "overhang", "bearing_distance"),
    "shaft_static": ("shaft_diameter", "overhang"),
    "shaft_fatigue": ("shaft_diameter", "overhang"),
    "line_pressure": ("roller_radius", "roller_circle_radius"),
}
"""Inputs that a fix of a check may change, by their core names."""

WHOLE = {"pins", "satellites", "rollers"}
"""Inputs that are whole numbers."""

GROWTH = {
    "pin.diameter": 2.0,
    "contact_length": 1.0,
    "pin_radius": 1.8,
    "pin_circle_radius": 1.0,
    "output_torque": -1.0,
}
"""With which power of an input the torque reserve of a pressure grows, about: where a search for a
fix of the mechanism as it is made starts."""

PINS = {*PIN_CHECKS, *PIN_FATIGUE}
"""Checks of the pin itself: its sleeve does not count."""

POWERS = {
    "pin_static": {"pin.diameter": 3.0, "pin_radius": 3.0, "peak_torque": -1.0},
    "pin_fatigue": {"pin.diameter": 3.0, "pin_radius": 3.0},
    "pin_deflection": {"pin.diameter": 4.0, "pin_radius": 4.0},
    "pin_slope": {"pin.diameter": 4.0, "pin_radius": 4.0},
    "efficiency": {"pin.diameter": -1.0},
    "sliding_speed": {"pin.diameter": -1.0},
    "pv": {},
    "wear": {},
    "bearing_life": {"bearing.dynamic_rating": 1.0, "input_speed": -0.3},
    "bearing_static": {"bearing.static_rating": 1.0, "peak_torque": -1.0},
    "system_life": {"bearing.dynamic_rating": 1.0, "input_speed": -0.3},
    "crank_bearing_life": {"crankshaft.dynamic_rating": 1.0, "input_speed": -0.3},
    "unbalance_force": {"input_speed": -2.0},
    "unbalance_couple": {"input_speed": -2.0},
    "outer_diameter": {"outer_radius": -1.0},
}
"""The same of checks that grow or fall with a power of their inputs: of the reserve, else of the
reciprocal of the utilisation. What is not named is one of `USUAL`."""

USUAL = {
    "contact_length": 1.0,
    "pin_radius": 1.0,
    "pin_circle_radius": 1.0,
    "output_torque": -1.0,
    "input_speed": -1.0,
    "friction.coefficient": -1.0,
    "friction.wear_rate": -1.0,
    "crankshaft.satellite_mass": -1.0,
}
