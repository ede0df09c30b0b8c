"""Worked steps of the sections of a crank-planetary reducer's answer."""

from collections.abc import Callable
from functools import partial

from app.calculations.crank_planetary_request import CrankPlanetaryRequest, Section
from app.calculations.crank_planetary_sections import ideal_force
from app.model import Values, present
from app.worked import worked
from core.errors import if_known
from core.worked.crank import bearing_steps, shaft_steps
from core.worked.hertz import judged_steps
from core.worked.losses import loss_steps
from core.worked.mechanism import clearance_steps, cyclogram_steps, force_steps
from core.worked.members import member_steps
from core.worked.pin_rollers import roller_steps
from core.worked.pins import strength_steps
from core.worked.ring import ring_steps
from core.worked.step import Step


def _cyclogram(body: CrankPlanetaryRequest) -> list[Step]:
    found, _ = body.mechanism.solve()
    return cyclogram_steps(found=found, **body.mechanism.cyclogram_given())


def _contact_force(body: CrankPlanetaryRequest) -> list[Step]:
    """Those of the ideal force, which say so where others are judged."""
    return force_steps(
        mechanism=body.design.driven,
        found=ideal_force(body),
        judged=not body.results.solved,
        **body.known_load.force_given(body.design.members),
    )


def _clearance(body: CrankPlanetaryRequest) -> list[Step]:
    fit, pair = body.solve_fit(), body.design.contact.pair
    return clearance_steps(
        clearance=fit.clearance,
        pin_radius=pair.pin_radius,
        hole_radius=pair.hole_radius,
        eccentricity=fit.eccentricity,
    )


WORKED: dict[Section, Callable[[CrankPlanetaryRequest], list[Step]]] = {
    "cyclogram": _cyclogram,
    "members": lambda body: member_steps(body.results),
    "contact_force": _contact_force,
    "hertz": lambda body: judged_steps(body.results),
    "geometry": _clearance,
    "ring_mesh": lambda body: ring_steps(body.results),
    "pin_strength": lambda body: strength_steps(
        results=body.results, found=body.results.pin_strength, deflection=True
    ),
    "output_efficiency": lambda body: loss_steps(body.results),
    "satellite_bearing": lambda body: bearing_steps(body.results),
    "crankshaft": lambda body: shaft_steps(body.results),
    "rollers": lambda body: roller_steps(body.results),
}
"""What works the sections of the answer; the others are solved over the turn."""


def work(body: CrankPlanetaryRequest) -> list[Values]:
    """Worked steps of the sections that are named; where none is, of all usual ones that can be."""
    named = [each for each in body.sections if each in WORKED]
    if named:
        return worked(**{each: WORKED[each](body) for each in named})
    usual = [each for each in body.usual_sections() if each in WORKED]
    return worked(**present({each: if_known(partial(WORKED[each], body)) for each in usual}))
