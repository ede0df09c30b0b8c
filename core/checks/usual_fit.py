"""A design of perfect parts, or of an unknown clearance, with one as such parts usually have."""

from core.checks.check import Verdict
from core.checks.reserve import crank_verdict
from core.design.document import Design, changed
from core.design.results import Results
from core.errors import InvalidInput, if_known, is_known
from core.hertz import ElasticMaterial
from core.tolerance.iso286 import fit_clearance

USUAL_FIT = "H7/f7"
"""Fit of holes and of pins or sleeves that are turned or ground."""

ROLLER_FIT = "H7/h6"
"""Fit of holes and of the outer rings of bearings, whose tolerance lies as that of h does."""

PRINTED, PRINTED_CLEARANCE = "printed", 0.25e-3
"""Radial clearance of printed holes, m: a sliding fit of FDM, for which guides of those who print
name 0.15 to 0.5 mm.
"""

SOFT = 20e9
"""Young's modulus below which a hole is taken as printed, Pa."""


def soft(material: ElasticMaterial | None) -> bool:
    """Tell whether a part is taken as printed, by its material, where that is known."""
    return material is not None and bool(material.youngs_modulus < SOFT)


def usual_clearance(design: Design) -> tuple[str, float]:
    """The fit that pins and holes of such materials and sizes usually have, and its radial
    clearance, m; `InvalidInput` of diameters that are not in the tables of fits.
    """
    if soft(design.contact.hole_material):
        return PRINTED, PRINTED_CLEARANCE
    pin = design.nominal_pair.pin_radius
    hole = pin + design.known_eccentricity
    fit = ROLLER_FIT if design.rollers else USUAL_FIT
    return fit, fit_clearance(fit=fit, hole_diameter=2 * hole, pin_diameter=2 * pin)


def usual_fit(design: Design) -> tuple[str, Results, Verdict] | None:
    """The design, of which load, contact and eccentricity are given, with a usual clearance: the
    fit, the results and the verdict; None where it has a clearance, or is beyond the sizes of the
    fit.
    """
    if if_known(lambda: design.clearance) != 0:
        return None
    try:
        name, clearance = usual_clearance(design)
    except InvalidInput:
        return None
    results = Results(_cleared(design, clearance))
    return name, results, crank_verdict(results)


def with_usual_clearance(design: Design) -> Design:
    """The design with a usual clearance where none is known and there is a usual one."""
    if not (design.clearance_unknown and is_known(lambda: design.known_eccentricity)):
        return design
    try:
        return _cleared(design, usual_clearance(design)[1])
    except InvalidInput:
        return design


def _cleared(design: Design, clearance: float) -> Design:
    """The design with holes that are larger by a clearance, m."""
    return changed(
        design,
        {
            "contact.hole_radius": design.nominal_pair.hole_radius + clearance,
            "contact.clearance_stated": True,
            "contact.distribution_factor": 1.0,
        },
    )
