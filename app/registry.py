"""All calculations of the service, from which routes, batches, examples and tests read them."""

from importlib import import_module
from pkgutil import iter_modules

from app import calculations
from app.exports import build123d, dxf, report, step, xlsx
from app.model import Calculation, Export

FIRST = (
    "hertz",
    "contact-force",
    "roller-strength",
    "cyclogram",
    "crank-planetary",
    "output-efficiency",
    "fit",
    "load-sharing",
    "ring-mesh",
    "pin-strength",
    "satellite-bearing",
    "crankshaft",
    "tolerance-study",
    "precession/contact-line",
    "precession/meshing-load",
    "precession/shaft-deflection",
    "solve",
    "propose",
    "sweep",
    "sensitivity",
    "work-precision",
)
"""Names of calculations in the order in which a request's path is compared; others follow."""


def _calculations() -> dict[str, Calculation]:
    """Calculations of those modules of `app.calculations` that have one, by name."""
    names = [f"{calculations.__name__}.{each.name}" for each in iter_modules(calculations.__path__)]
    made = [getattr(import_module(name), "CALCULATION", None) for name in names]
    found = {each.name: each for each in made if each}
    return {name: found[name] for name in dict.fromkeys((*FIRST, *found))}


CALCULATIONS = _calculations()
"""Calculations by name."""

EXPORTS: dict[str, Export] = {
    module.EXPORT.name: module.EXPORT for module in (dxf, build123d, step, xlsx, report)
}
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
