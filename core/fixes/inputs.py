"""Which inputs a fix of a check may change."""

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
