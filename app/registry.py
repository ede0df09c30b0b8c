"""All calculations of the service, from which routes, batches, examples and tests read them."""

from app.calculations import (
    contact_force,
    contact_line,
    crank_planetary,
    crankshaft,
    cyclogram,
    fit,
    hertz,
    load_sharing,
    meshing_load,
    output_efficiency,
    pin_strength,
    ring_mesh,
    roller_strength,
    satellite_bearing,
    shaft_deflection,
    solve,
    tolerance_study,
    work_precision,
)
from app.exports import dxf
from app.model import Calculation, Export

CALCULATIONS: dict[str, Calculation] = {
    module.CALCULATION.name: module.CALCULATION
    for module in (
        hertz,
        contact_force,
        roller_strength,
        cyclogram,
        crank_planetary,
        output_efficiency,
        fit,
        load_sharing,
        ring_mesh,
        pin_strength,
        satellite_bearing,
        crankshaft,
        tolerance_study,
        contact_line,
        meshing_load,
        shaft_deflection,
        solve,
        work_precision,
    )
}
"""Calculations by name, in the order in which a request's path is compared."""

EXPORTS: dict[str, Export] = {module.EXPORT.name: module.EXPORT for module in (dxf,)}
"""Files of a design, by name."""

NEGLECTED = {
    "bearing_elasticity": "play and elasticity of the bearings",
    "bodies_rigid": "the deformation of discs, hole walls, carrier and crankshaft",
    "body_strength": "the strength of teeth, discs, carrier and crankshaft",
    "centrifugal_forces": "the centrifugal forces of satellites whose mass is not given",
    "clearance": "clearance of pins and holes, and with it lost motion",
    "contact_compliance": "the compliance of the contacts of spheres and holes",
    "deviations": "deviations of the parts from their nominal shape and place",
    "edge_pressure": "the higher pressure at the ends of the contact",
    "elasticity": "the elasticity of the parts besides the contacts",
    "equal_discs": "uneven sharing between the satellites",
    "friction": "friction",
    "friction_on_forces": "what friction changes about the forces themselves",
    "heat": "heat, and what it changes",
    "lubricant_film": "the lubricant's film: the friction coefficient is the same everywhere",
    "misalignment": "misalignment, so that the load is even along the contact",
    "fretting": "fretting at the pin's seat, unless the notch factor covers it",
    "pin_bending": "the bending of the pins",
    "roller_tilt": "the tilt of the rollers against the discs",
    "seat_compliance": "the give of the pin's seats",
    "seals": "losses of seals, bearings and teeth",
    "shaft_bearings": "play and elasticity of the crankshaft's bearings",
    "shear": "the shear of the shaft",
    "tilt": "the tilt of satellites in their bearings, and of pins and holes by errors",
}
"""Effects that models leave out, by code."""
