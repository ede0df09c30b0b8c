"""Inputs that checks of several machine elements depend on, by their paths."""

from typing import TypeAlias

Paths: TypeAlias = "str | tuple[Paths, ...]"
"""Paths separated by spaces, or groups of such strings."""


def paths(*named: Paths) -> tuple[str, ...]:
    """Paths of all groups, each once, in their order."""
    each = (one.split() if isinstance(one, str) else paths(*one) for one in named)
    return tuple(dict.fromkeys(path for group in each for path in group))


CRANKS = "mechanism.pins mechanism.satellites mechanism.crank_spacing mechanism.crank_angles"
"""Inputs of the places of pins and satellites."""

FORCE = paths(
    "load.output_torque load.torque_direction load.pin_circle_radius",
    CRANKS,
    "mechanism.ratio load.force_exponent contact.distribution_factor",
)
"""Inputs of the ideal forces on pins. The ratio converts a torque of the ring into one of the pins;
the load-sharing factor decides if the sharing of perfect parts is solved."""

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
"""Inputs of pins and holes that determine how satellites and pins share the load."""

PIN_FORCES = paths(FORCE, SHARING)
"""Inputs of the forces on pins without those of the ring."""

OF_CLEARANCE = "gear.modification.equidistant gear.modification.pin_circle"
"""Modifications that open the gaps between a disc and the ring pins."""

RING_PINS = paths(
    "gear.kind gear.ring_pin_circle_radius gear.teeth_difference",
    OF_CLEARANCE,
    "mechanism.ratio mechanism.satellites mechanism.crank_spacing mechanism.crank_angles",
    "contact.eccentricity deviations",
)
"""Inputs of the gaps between cycloid discs and ring pins, without the rotation of flanks, which
closes all gaps at an equal lag."""

OF_BENT_PINS = paths("gear.span gear.satellite_positions gear.sleeve_bore_radius")
"""Inputs of the bending of ring pins."""

RING_CARRIES = paths(
    RING_PINS,
    "gear.ring_pin_radius gear.contact_length gear.contact_law gear.pin_material",
    "gear.disc_material gear.pin_support",
    OF_BENT_PINS,
    "gear.seat_stiffness contact.contact_length contact.hole_material satellite_coupling",
)
"""Inputs of the sharing of a torque between ring pins, without the rotation of flanks."""

RING_GIVES = paths(RING_CARRIES, "gear.modification.rotation")
"""Inputs of the sharing of a torque between ring pins."""

FORCES = paths(PIN_FORCES, RING_GIVES)
"""Inputs of the forces on pins, with those of ring sharing for meshes in series."""

ON_STRESSES = "load.application_factor"
"""Factor on stresses and pressures."""

LOADED = paths(FORCES, ON_STRESSES)
"""Inputs of the forces on pins, with the factor on stresses and pressures."""

SLIDING = "friction.coefficient friction.sleeve"
"""Inputs of sliding in the holes."""

SPEEDS = paths("load.input_speed load.ring_speed load.carrier_speed")
"""Inputs of the speeds of crank, pins and ring."""

LIFE = paths(SPEEDS, "requirements.life")
"""Inputs of the number of loads over the life."""

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
"""Inputs of the forces on ring pins, with those of the output pins for meshes in series."""

RING_LOADED = paths(RING_FORCES, "contact.distribution_of", ON_STRESSES)
"""Inputs of the forces on ring pins, with the factors on pressures."""

INVOLUTE_GEARS = paths(
    "gear.kind gear.module gear.teeth_difference gear.reference_pressure_angle",
    "mechanism.ratio contact.eccentricity",
)
"""Inputs of involute teeth of any profile shifts and heights."""

SATELLITE_TIPS = "gear.satellite_profile_shift gear.satellite_addendum gear.satellite_tip_radius"
"""Inputs of the tip circle of an involute satellite."""

RING_TIPS = "gear.ring_profile_shift gear.ring_addendum gear.ring_tip_radius"
"""Inputs of the tip circle of an involute ring."""

INVOLUTE_TEETH = paths(INVOLUTE_GEARS, SATELLITE_TIPS, RING_TIPS)
"""Inputs of involute teeth and their path of contact."""

INVOLUTE_RACK = "gear.dedendum gear.rack_tip_radius"
"""Inputs of the hob that cuts the satellite."""

INVOLUTE_CUTTER = "gear.cutter_teeth gear.cutter_profile_shift gear.cutter_addendum"
"""Inputs of the cutter of the ring."""

INVOLUTE_GIVES = paths(
    INVOLUTE_GEARS,
    "gear.contact_length gear.face_load_factor",
    tuple(each for each in PIN_FORCES if each not in ("load.output_torque", "load.force_exponent")),
    "contact.distribution_of",
)
"""Inputs of the torque on involute teeth: satellites carry what their pins carry."""

INVOLUTE_LOADED = paths(INVOLUTE_GIVES, "load.output_torque", ON_STRESSES)
"""Inputs of the forces on involute teeth."""

TEETH_GAPS = paths(
    RING_PINS,
    "gear.modification.rotation",
    INVOLUTE_GEARS,
    "gear.satellite_profile_shift gear.ring_profile_shift",
)
"""Inputs of the gaps between satellites and ring of any kind."""

TEETH_GIVE = paths(
    RING_GIVES,
    "contact.distribution_factor contact.distribution_of",
    INVOLUTE_GIVES,
    RING_TIPS,
    "gear.ring_material gear.satellite_material",
)
"""Inputs of the torque on satellites and ring of any kind."""

TEETH_LOADED = paths(TEETH_GIVE, "load.output_torque", ON_STRESSES)
"""Inputs of the pressure between satellites and ring of any kind."""

OF_DISCS = paths(FORCES, "contact.distribution_of", RING)
"""Inputs of the loads of satellites on the crank."""

BEARING_LOAD = paths(OF_DISCS, "bearing.kind crankshaft.satellite_mass")
"""Inputs of the load of a satellite bearing."""

ROOTS = paths(
    "satellite_body.outer_radius satellite_body.root_radius gear.kind gear.module",
    "gear.teeth_difference gear.ring_pin_circle_radius gear.ring_pin_radius",
    OF_CLEARANCE,
    "gear.satellite_profile_shift gear.dedendum mechanism.ratio contact.eccentricity",
)
"""Inputs of the root radius of a satellite's teeth."""
