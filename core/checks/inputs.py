"""Inputs that checks of several machine elements depend on, by their paths."""

FORCE = (
    "load.output_torque",
    "load.pin_circle_radius",
    "mechanism.pins",
    "mechanism.satellites",
    "mechanism.crank_spacing",
    "mechanism.crank_angles",
    "mechanism.ratio",  # of the torque of a ring
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
    "pin.bore_diameter",
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
    "rollers.radial_clearance",
    "rollers.width",  # how long they touch
    "rollers.per_satellite",
)
"""Of pins and holes as they are made: how satellites and pins share the load."""

FORCES = (*FORCE, *SHARING)
"""Of the forces on pins."""

LOADED = (*FORCES, "contact.dynamic_factor", "load.application_factor")
"""The same, with the factor on stresses and pressures."""

SLIDING = ("friction.coefficient", "friction.sleeve")
"""Of what slides in the holes."""

SPEEDS = ("load.input_speed", "load.ring_speed", "load.carrier_speed")
"""Of crank, pins and ring against each other."""

LIFE = (*SPEEDS, "requirements.life")
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

RING_PINS = (
    "gear.kind",
    "gear.ring_pin_circle_radius",
    "gear.teeth_difference",
    "gear.modification.equidistant",
    "gear.modification.pin_circle",
    "mechanism.ratio",
    "mechanism.satellites",
    "mechanism.crank_spacing",
    "mechanism.crank_angles",
    "contact.eccentricity",
    "deviations",
)
"""Of the gaps between cycloid discs and the pins of their ring, but for what takes the same part of
the lag at each.
"""

RING_GAPS = (*RING_PINS, "gear.modification.rotation")
"""Of these gaps."""

OF_BENT_PINS = ("gear.span", "gear.satellite_positions", "gear.sleeve_bore_radius")
"""Of how pins of the ring bend."""

RING_GIVES = (
    *RING_GAPS,
    "gear.ring_pin_radius",
    "gear.contact_length",
    "gear.contact_law",
    "gear.pin_material",
    "gear.disc_material",
    "gear.pin_support",
    *OF_BENT_PINS,
    "gear.seat_stiffness",
    "contact.contact_length",
    "contact.hole_material",
    "satellite_coupling",
)
"""Of how these pins share a torque."""

RING_SHARING = (*RING_GIVES, "load.output_torque")
"""Of the forces on them."""

UNEVEN = ("contact.distribution_factor", "contact.distribution_of")
"""Of a share that is stated."""

RING_LOADED = (
    *RING_SHARING,
    *UNEVEN,
    "contact.dynamic_factor",
    "load.application_factor",
)
"""The same, with the factors on pressures."""

OF_DISCS = (*FORCES, "contact.distribution_of", *RING)
"""Of the loads of satellites on the crank."""

BEARING_LOAD = (*OF_DISCS, "bearing.kind", "crankshaft.satellite_mass")
"""Of the load of a satellite's bearing."""

ROOTS = (
    "satellite_body.outer_radius",
    "satellite_body.root_radius",
    "gear.kind",
    "gear.module",
    "gear.teeth_difference",
    "gear.ring_pin_circle_radius",
    "gear.ring_pin_radius",
    "gear.modification.equidistant",
    "gear.modification.pin_circle",
    "mechanism.ratio",
    "contact.eccentricity",
)
"""Of where the roots of a satellite's teeth are."""
