"""Inputs that checks of several machine elements depend on, by their paths."""

from typing import TypeAlias

Paths: TypeAlias = "str | tuple[Paths, ...]"
"""Paths with spaces between them, or groups of such."""


def paths(*named: Paths) -> tuple[str, ...]:
    """Paths that are named, each once, in their order."""
    each = (one.split() if isinstance(one, str) else paths(*one) for one in named)
    return tuple(dict.fromkeys(path for group in each for path in group))


CRANKS = "mechanism.pins mechanism.satellites mechanism.crank_spacing mechanism.crank_angles"
"""Of where pins and satellites stand."""

FORCE = paths(
    "load.output_torque load.torque_direction load.pin_circle_radius",
    CRANKS,
    "mechanism.ratio load.force_exponent contact.distribution_factor",
)
"""Of the ideal forces on pins: by the ratio a torque of the ring is one of the pins, and the factor
says of perfect parts whether their sharing is solved."""

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
"""Of pins and holes as they are made, and of how pins bend: how satellites and pins share the load.
"""

PIN_FORCES = paths(FORCE, SHARING)
"""Of the forces on pins by themselves."""

OF_CLEARANCE = "gear.modification.equidistant gear.modification.pin_circle"
"""Modifications that open the gaps between a disc and the pins of its ring."""

RING_PINS = paths(
    "gear.kind gear.ring_pin_circle_radius gear.teeth_difference",
    OF_CLEARANCE,
    "mechanism.ratio mechanism.satellites mechanism.crank_spacing mechanism.crank_angles",
    "contact.eccentricity deviations",
)
"""Of the gaps between cycloid discs and the pins of their ring, but for what takes the same part of
the lag at each.
"""

OF_BENT_PINS = paths("gear.span gear.satellite_positions gear.sleeve_bore_radius")
"""Of how pins of the ring bend."""

RING_CARRIES = paths(
    RING_PINS,
    "gear.ring_pin_radius gear.contact_length gear.contact_law gear.pin_material",
    "gear.disc_material gear.pin_support",
    OF_BENT_PINS,
    "gear.seat_stiffness contact.contact_length contact.hole_material satellite_coupling",
)
"""Of how these pins share a torque, but for flanks that are turned, all alike."""

RING_GIVES = paths(RING_CARRIES, "gear.modification.rotation")
"""Of how these pins share a torque."""

FORCES = paths(PIN_FORCES, RING_CARRIES)
"""Of the forces on pins: of discs in series with their ring, of how that shares the torque, too."""

ON_STRESSES = "contact.dynamic_factor load.application_factor"
"""The factor on stresses and pressures."""

LOADED = paths(FORCES, ON_STRESSES)
"""Of the forces on pins, with the factor on stresses and pressures."""

SLIDING = "friction.coefficient friction.sleeve"
"""Of what slides in the holes."""

SPEEDS = paths("load.input_speed load.ring_speed load.carrier_speed")
"""Of crank, pins and ring against each other."""

LIFE = paths(SPEEDS, "requirements.life")
"""Of how often a load comes in the life."""

FATIGUE = paths(
    "fatigue.surface fatigue.surface_factor fatigue.edition fatigue.reliability_percent",
    "fatigue.reliability_factor fatigue.fatigue_notch_factor fatigue.notch",
    "fatigue.endurance_limit fatigue.criterion",
)

RING = paths(
    "gear.kind gear.module gear.teeth_difference gear.reference_pressure_angle",
    "gear.ring_pin_circle_radius gear.radial_force_ratio",
)
"""Of the ring's force on a satellite."""

RING_FORCES = paths(
    RING_GIVES,
    "load.output_torque",
    tuple(each for each in FORCE if each != "load.force_exponent"),
    tuple(each for each in SHARING if each != "crank_support"),
)
"""Of the forces on the pins of the ring; in series with the pins of the output, with cranks that do
not give then."""

RING_LOADED = paths(RING_FORCES, "contact.distribution_of", ON_STRESSES)
"""Of these forces, with the factors on pressures."""

INVOLUTE_GEARS = paths(
    "gear.kind gear.module gear.teeth_difference gear.reference_pressure_angle",
    "mechanism.ratio contact.eccentricity",
)
"""Of involute teeth, whatever their heights and shifts."""

SATELLITE_TIPS = "gear.satellite_profile_shift gear.satellite_addendum gear.satellite_tip_radius"
"""Of where the tips of the satellite are."""

RING_TIPS = "gear.ring_profile_shift gear.ring_addendum gear.ring_tip_radius"
"""Of where those of the ring are."""

INVOLUTE_TEETH = paths(INVOLUTE_GEARS, SATELLITE_TIPS, RING_TIPS)
"""Of involute teeth and where they touch."""

INVOLUTE_RACK = "gear.dedendum gear.rack_tip_radius"
"""Of the hob that makes the satellite."""

INVOLUTE_CUTTER = "gear.cutter_teeth gear.cutter_profile_shift gear.cutter_addendum"
"""Of the cutter that makes the ring."""

INVOLUTE_GIVES = paths(
    INVOLUTE_GEARS,
    "gear.contact_length gear.face_load_factor",
    tuple(each for each in PIN_FORCES if each not in ("load.output_torque", "load.force_exponent")),
    "contact.distribution_of",
)
"""Of how a torque is on them: satellites carry what their pins do."""

INVOLUTE_LOADED = paths(INVOLUTE_GIVES, "load.output_torque", ON_STRESSES)
"""Of the forces on them."""

TEETH_GAPS = paths(
    RING_PINS,
    "gear.modification.rotation",
    INVOLUTE_GEARS,
    "gear.satellite_profile_shift gear.ring_profile_shift",
)
"""Of the gaps between satellites and ring, of whatever kind."""

TEETH_GIVE = paths(
    RING_GIVES,
    "contact.distribution_factor contact.distribution_of",
    INVOLUTE_GIVES,
    RING_TIPS,
    "gear.ring_material gear.satellite_material",
)
"""Of how a torque is on satellites and ring, of whatever kind."""

TEETH_LOADED = paths(TEETH_GIVE, "load.output_torque", ON_STRESSES)
"""Of the pressure between them."""

OF_DISCS = paths(FORCES, "contact.distribution_of", RING)
"""Of the loads of satellites on the crank."""

BEARING_LOAD = paths(OF_DISCS, "bearing.kind crankshaft.satellite_mass")
"""Of the load of a satellite's bearing."""

ROOTS = paths(
    "satellite_body.outer_radius satellite_body.root_radius gear.kind gear.module",
    "gear.teeth_difference gear.ring_pin_circle_radius gear.ring_pin_radius",
    OF_CLEARANCE,
    "gear.satellite_profile_shift gear.dedendum mechanism.ratio contact.eccentricity",
)
"""Of where the roots of a satellite's teeth are."""
