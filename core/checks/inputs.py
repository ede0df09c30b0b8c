"""Inputs that checks of several machine elements depend on, by their paths."""

from typing import TypeAlias

Paths: TypeAlias = "str | tuple[Paths, ...]"
"""Paths with spaces between them, or groups of such."""


def paths(*named: Paths) -> tuple[str, ...]:
    """Paths that are named, each once, in their order."""
    each = (one.split() if isinstance(one, str) else paths(*one) for one in named)
    return tuple(dict.fromkeys(path for group in each for path in group))


CRANKS = "mechanism.pins mechanism.satellites mechanism.crank_spacing mechanism.crank_angles"
"""Inputs of where pins and satellites stand."""

FORCE = paths(
    "load.output_torque load.torque_direction load.pin_circle_radius",
    CRANKS,
    "mechanism.ratio load.force_exponent contact.distribution_factor",
)
"""Inputs of the ideal forces on pins: the ratio makes a torque of the ring one of the pins, and the
factor says of perfect parts whether their sharing is solved."""

HOLE = paths("contact.pin_radius contact.hole_radius contact.hole_clearance")

MATERIALS = "contact.pin_material contact.hole_material"

SHARING = paths(
    "contact.contact_length",
    HOLE,
    "contact.eccentricity",
    MATERIALS,
    "pin.diameter pin.bore_diameter pin.satellite_positions pin.support pin.span pin.ring_joint",
    "pin.bolt pin.contact_length pin.material contact_law deviations crank_support",
    "satellite_coupling rollers.radial_clearance rollers.width rollers.per_satellite",
)
"""Inputs of pins and holes as they are made and bend: of how satellites and pins share the load."""

PIN_FORCES = paths(FORCE, SHARING)
"""Inputs of the forces on pins by themselves."""

OF_CLEARANCE = "gear.modification.equidistant gear.modification.pin_circle"
"""Modifications that open the gaps between a disc and the pins of its ring."""

RING_PINS = paths(
    "gear.kind gear.ring_pin_circle_radius gear.teeth_difference",
    OF_CLEARANCE,
    "mechanism.ratio mechanism.satellites mechanism.crank_spacing mechanism.crank_angles",
    "contact.eccentricity deviations",
)
"""Inputs of the gaps between cycloid discs and the pins of their ring, but for the one that takes
the same part of the lag at each.
"""

OF_BENT_PINS = paths("gear.span gear.satellite_positions gear.sleeve_bore_radius")
"""Inputs of how pins of the ring bend."""

RING_CARRIES = paths(
    RING_PINS,
    "gear.ring_pin_radius gear.contact_length gear.contact_law gear.pin_material",
    "gear.disc_material gear.pin_support",
    OF_BENT_PINS,
    "gear.seat_stiffness contact.contact_length contact.hole_material satellite_coupling",
)
"""Inputs of how these pins share a torque, but for flanks that are turned, all alike."""

RING_GIVES = paths(RING_CARRIES, "gear.modification.rotation")
"""Inputs of how these pins share a torque."""

FORCES = paths(PIN_FORCES, RING_GIVES)
"""Inputs of the forces on pins; discs in series with their ring have those of its sharing, too."""

ON_STRESSES = "contact.dynamic_factor load.application_factor"
"""The factor on stresses and pressures."""

LOADED = paths(FORCES, ON_STRESSES)
"""Inputs of the forces on pins, with the factor on stresses and pressures."""

SLIDING = "friction.coefficient friction.sleeve"
"""Inputs of what slides in the holes."""

SPEEDS = paths("load.input_speed load.ring_speed load.carrier_speed")
"""Inputs of crank, pins and ring against each other."""

LIFE = paths(SPEEDS, "requirements.life")
"""Inputs of how often a load comes in the life."""

FATIGUE = paths(
    "fatigue.surface fatigue.surface_factor fatigue.edition fatigue.reliability_percent",
    "fatigue.reliability_factor fatigue.fatigue_notch_factor fatigue.notch",
    "fatigue.endurance_limit fatigue.criterion",
)

RING = paths(
    "gear.kind gear.module gear.teeth_difference gear.reference_pressure_angle",
    "gear.ring_pin_circle_radius gear.radial_force_ratio",
)
"""Inputs of the ring's force on a satellite."""

RING_FORCES = paths(
    RING_GIVES,
    "load.output_torque",
    tuple(each for each in FORCE if each != "load.force_exponent"),
    SHARING,
)
"""Inputs of the forces on the ring's pins, in series with the output's pins."""

RING_LOADED = paths(RING_FORCES, "contact.distribution_of", ON_STRESSES)
"""Inputs of these forces, with the factors on pressures."""

INVOLUTE_GEARS = paths(
    "gear.kind gear.module gear.teeth_difference gear.reference_pressure_angle",
    "mechanism.ratio contact.eccentricity",
)
"""Inputs of involute teeth, whatever their heights and shifts."""

SATELLITE_TIPS = "gear.satellite_profile_shift gear.satellite_addendum gear.satellite_tip_radius"
"""Inputs of where the tips of the satellite are."""

RING_TIPS = "gear.ring_profile_shift gear.ring_addendum gear.ring_tip_radius"
"""Inputs of where those of the ring are."""

INVOLUTE_TEETH = paths(INVOLUTE_GEARS, SATELLITE_TIPS, RING_TIPS)
"""Inputs of involute teeth and where they touch."""

INVOLUTE_RACK = "gear.dedendum gear.rack_tip_radius"
"""Inputs of the hob that makes the satellite."""

INVOLUTE_CUTTER = "gear.cutter_teeth gear.cutter_profile_shift gear.cutter_addendum"
"""Inputs of the cutter that makes the ring."""

INVOLUTE_GIVES = paths(
    INVOLUTE_GEARS,
    "gear.contact_length gear.face_load_factor",
    tuple(each for each in PIN_FORCES if each not in ("load.output_torque", "load.force_exponent")),
    "contact.distribution_of",
)
"""Inputs of how a torque is on them: satellites carry what their pins do."""

INVOLUTE_LOADED = paths(INVOLUTE_GIVES, "load.output_torque", ON_STRESSES)
"""Inputs of the forces on them."""

TEETH_GAPS = paths(
    RING_PINS,
    "gear.modification.rotation",
    INVOLUTE_GEARS,
    "gear.satellite_profile_shift gear.ring_profile_shift",
)
"""Inputs of the gaps between satellites and ring, of whatever kind."""

TEETH_GIVE = paths(
    RING_GIVES,
    "contact.distribution_factor contact.distribution_of",
    INVOLUTE_GIVES,
    RING_TIPS,
    "gear.ring_material gear.satellite_material",
)
"""Inputs of how a torque is on satellites and ring, of whatever kind."""

TEETH_LOADED = paths(TEETH_GIVE, "load.output_torque", ON_STRESSES)
"""Inputs of the pressure between them."""

OF_DISCS = paths(FORCES, "contact.distribution_of", RING)
"""Inputs of the loads of satellites on the crank."""

BEARING_LOAD = paths(OF_DISCS, "bearing.kind crankshaft.satellite_mass")
"""Inputs of the load of a satellite's bearing."""

ROOTS = paths(
    "satellite_body.outer_radius satellite_body.root_radius gear.kind gear.module",
    "gear.teeth_difference gear.ring_pin_circle_radius gear.ring_pin_radius",
    OF_CLEARANCE,
    "gear.satellite_profile_shift gear.dedendum mechanism.ratio contact.eccentricity",
)
"""Inputs of where the roots of a satellite's teeth are."""
