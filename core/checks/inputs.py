"""Inputs that checks of several machine elements depend on, by their paths."""

FORCE = (
    "load.output_torque",
    "load.pin_circle_radius",
    "mechanism.pins",
    "mechanism.satellites",
    "mechanism.crank_spacing",
    "mechanism.crank_angles",
    "load.force_exponent",
    "contact.distribution_factor",  # of perfect parts: whether their sharing is solved
)
"""Of the ideal forces on pins."""

HOLE = ("contact.pin_radius", "contact.hole_radius", "contact.hole_clearance")

SHARING = (
    "contact.contact_length",
    *HOLE,
    "contact.eccentricity",
    "contact.pin_material",
    "contact.hole_material",
    "pin.diameter",  # of pins that bend
    "pin.satellite_positions",
    "pin.support",
    "pin.span",
    "pin.ring_joint",
    "pin.bolt",
    "pin.contact_length",
    "pin.material",
    "contact_law",
    "deviations",
    "crank_support",
    "satellite_coupling",
)
"""Of pins and holes as they are made: how satellites and pins share the load."""

FORCES = (*FORCE, *SHARING)
"""Of the forces on pins."""

LOADED = (*FORCES, "contact.dynamic_factor", "load.application_factor")
"""The same, with the factor on stresses and pressures."""

LIFE = ("load.input_speed", "requirements.life")

LOADS = ("load.input_speed", "mechanism.ratio", "requirements.life")
"""Of how often a load comes in the life."""

FATIGUE = (
    "fatigue.surface",
    "fatigue.surface_factor",
    "fatigue.reliability_percent",
    "fatigue.reliability_factor",
    "fatigue.fatigue_notch_factor",
    "fatigue.notch",
    "fatigue.endurance_limit",
    "fatigue.criterion",
)

RING = (
    "gear.kind",
    "gear.module",
    "gear.teeth_difference",
    "gear.reference_pressure_angle",
    "gear.ring_pin_circle_radius",
    "gear.radial_force_ratio",
)
"""Of the ring's force on a satellite."""

BEARING_LOAD = (*FORCES, "mechanism.ratio", *RING, "bearing.kind")
"""Of the load of a satellite's bearing."""

ROOTS = (
    "satellite_body.outer_radius",
    "satellite_body.root_radius",
    "gear.kind",
    "gear.module",
    "gear.teeth_difference",
    "gear.ring_pin_circle_radius",
    "gear.ring_pin_radius",
    "mechanism.ratio",
    "contact.eccentricity",
)
"""Of where the roots of a satellite's teeth are."""
