"""Design with a usual clearance, for perfect parts or an unknown clearance."""

from dataclasses import dataclass

from core.checks.check import Verdict
from core.checks.reserve import crank_verdict
from core.design.document import Design, changed
from core.design.real_forces import RealForces
from core.design.results import Results
from core.design.ring import soft
from core.errors import InvalidInput, if_known, is_known
from core.fields import answered
from core.tolerance.iso286 import fit_clearance

USUAL_FIT = "H7/f7"
"""Fit of holes with turned or ground pins or sleeves."""

ROLLER_FIT = "H7/h6"
"""Fit of holes with outer rings of bearings, whose tolerance zone lies as h does."""

PRINTED, PRINTED_CLEARANCE = "printed", 0.25e-3
"""Radial clearance of printed holes, m: a sliding fit of FDM prints, for which printing guides
state 0.15 to 0.5 mm."""


def usual_clearance(design: Design) -> tuple[str, float]:
    """Usual fit of pins and holes by material and size, and its radial clearance, m.

    Raises InvalidInput if a diameter is outside the tables of fits.
    """
    if soft(design.contact.hole_material):
        return PRINTED, PRINTED_CLEARANCE
    pin = design.nominal_pair.pin_radius
    hole = pin + design.known_eccentricity
    fit = ROLLER_FIT if design.rollers else USUAL_FIT
    return fit, fit_clearance(fit=fit, hole_diameter=2 * hole, pin_diameter=2 * pin)


@dataclass(frozen=True, slots=True)
class UsualFit:
    """Design with a usual clearance."""

    name: str  # fit such as H7/f7; `PRINTED` for holes softer than `SOFT`
    results: Results  # results with that clearance
    judged: Verdict  # verdict with it

    @property
    @answered("mm", "c")
    def hole_clearance(self) -> float:
        """Radial clearance."""
        return self.results.design.clearance

    @property
    @answered("N", "F_max")
    def peak_force(self) -> float | None:
        """Largest force of all pairs over the turn."""
        forces = if_known(lambda: self.results.judged_forces)
        return forces.turn.peak_force if isinstance(forces, RealForces) else None


def usual_fit(design: Design, *, largest: bool = False) -> UsualFit | None:
    """Design with a usual clearance; load, contact and eccentricity have to be given. None if the
    design has a clearance or the tables of fits do not cover its sizes. True for `largest`
    searches for the largest torque too.
    """
    if if_known(lambda: design.clearance) != 0:
        return None
    try:
        name, clearance = usual_clearance(design)
    except InvalidInput:
        return None
    results = Results(_cleared(design, clearance))
    return UsualFit(name, results, crank_verdict(results, largest=largest))


def with_usual_clearance(design: Design) -> Design:
    """Design with a usual clearance if none is known and there is a usual one."""
    if not (design.clearance_unknown and is_known(lambda: design.known_eccentricity)):
        return design
    try:
        return _cleared(design, usual_clearance(design)[1])
    except InvalidInput:
        return design


def _cleared(design: Design, clearance: float) -> Design:
    """Design with holes enlarged by a radial clearance, m."""
    return changed(
        design,
        {
            "contact.hole_radius": design.nominal_pair.hole_radius + clearance,
            "contact.clearance_stated": True,
            "contact.distribution_factor": 1.0,
        },
    )
