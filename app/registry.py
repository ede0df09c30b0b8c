"""All calculations of the service; routes, batches, examples and tests read them from here."""

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
"""By name, in the order in which a request's path is compared."""

EXPORTS: dict[str, Export] = {module.EXPORT.name: module.EXPORT for module in (dxf,)}
"""Files of a design, by name."""
