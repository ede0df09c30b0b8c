"""Inputs that checks of several machine elements depend on, by their paths."""

FORCE = (
    "load.output_torque",
    "load.torque_direction",
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

PIN_FORCES = (*FORCE, *SHARING)
"""Of the forces on pins by themselves."""

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

RING_CARRIES = (
    *RING_PINS,
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
"""Of how these pins share a torque, but for flanks that are turned, all alike."""

RING_GIVES = (*RING_CARRIES, "gear.modification.rotation")
"""Of how these pins share a torque."""

FORCES = tuple(dict.fromkeys((*PIN_FORCES, *RING_CARRIES)))
"""Of the forces on pins: of discs in series with their ring, of how that shares the torque, too."""

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
    "fatigue.edition",
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

RING_SHARING = (*RING_GIVES, "load.output_torque")
"""Of the forces on them."""

UNEVEN = ("contact.distribution_factor", "contact.distribution_of")
"""Of a share that is stated."""

RING_FORCES = tuple(
    dict.fromkeys(
        (
            *RING_SHARING,
            *(each for each in FORCE if each != "load.force_exponent"),
            *(each for each in SHARING if each != "crank_support"),
        )
    )
)
"""Of these in series with the pins of the output, too, with cranks that do not give then."""

RING_LOADED = (
    *RING_FORCES,
    "contact.distribution_of",
    "contact.dynamic_factor",
    "load.application_factor",
)
"""The same, with the factors on pressures."""

INVOLUTE_GEARS = (
    "gear.kind",
    "gear.module",
    "gear.teeth_difference",
    "gear.reference_pressure_angle",
    "mechanism.ratio",
    "contact.eccentricity",
)
"""Of involute teeth, whatever their heights and shifts."""

SATELLITE_TIPS = (
    "gear.satellite_profile_shift",
    "gear.satellite_addendum",
    "gear.satellite_tip_radius",
)
"""Of where the tips of the satellite are."""

RING_TIPS = ("gear.ring_profile_shift", "gear.ring_addendum", "gear.ring_tip_radius")
"""Of where those of the ring are."""

INVOLUTE_TEETH = (*INVOLUTE_GEARS, *SATELLITE_TIPS, *RING_TIPS)
"""Of involute teeth and where they touch."""

INVOLUTE_RACK = ("gear.dedendum", "gear.rack_tip_radius")
"""Of the hob that makes the satellite."""

INVOLUTE_CUTTER = ("gear.cutter_teeth", "gear.cutter_profile_shift", "gear.cutter_addendum")
"""Of the cutter that makes the ring."""

INVOLUTE_GIVES = tuple(
    dict.fromkeys(
        (
            *INVOLUTE_GEARS,
            "gear.contact_length",
            "gear.face_load_factor",
            *(
                each
                for each in PIN_FORCES
                if each not in ("load.output_torque", "load.force_exponent")
            ),
            "contact.distribution_of",
        )
    )
)
"""Of how a torque is on them: satellites carry what their pins do."""

ON_STRESSES = ("load.output_torque", "contact.dynamic_factor", "load.application_factor")
"""Of the torque itself, with the factor on stresses and pressures."""

INVOLUTE_LOADED = (*INVOLUTE_GIVES, *ON_STRESSES)
"""Of the forces on them."""

TEETH_GAPS = tuple(
    dict.fromkeys(
        (
            *RING_GAPS,
            *INVOLUTE_GEARS,
            "gear.satellite_profile_shift",
            "gear.ring_profile_shift",
        )
    )
)
"""Of the gaps between satellites and ring, of whatever kind."""

TEETH_GIVE = tuple(
    dict.fromkeys(
        (
            *RING_GIVES,
            *UNEVEN,
            *INVOLUTE_GIVES,
            *RING_TIPS,
            "gear.ring_material",
            "gear.satellite_material",
        )
    )
)
"""Of how a torque is on satellites and ring, of whatever kind."""

TEETH_LOADED = (*TEETH_GIVE, *ON_STRESSES)
"""Of the pressure between them."""

OF_DISCS = tuple(dict.fromkeys((*FORCES, "contact.distribution_of", *RING)))
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
    "gear.satellite_profile_shift",
    "gear.dedendum",
    "mechanism.ratio",
    "contact.eccentricity",
)
"""Of where the roots of a satellite's teeth are."""
