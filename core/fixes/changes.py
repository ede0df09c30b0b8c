"""Inputs of a crank-planetary reducer, and the reducer with another value of one input."""

import math
from collections.abc import Callable
from dataclasses import dataclass, field

from core.checks.check import Check, Verdict
from core.checks.crank_planetary import crank_check
from core.checks.reserve import crank_verdict
from core.design.document import Design, changed, value_at
from core.design.results import Results
from core.errors import required
from core.fixes.fix import WHOLE, aim
from core.tolerance.iso286 import fit_clearance

RATING = "crankshaft.bearings.dynamic_rating"
"""Common dynamic rating of both crankshaft bearings."""


class Late(Exception):
    """End of a search whose time is over."""


@dataclass(frozen=True, slots=True)
class Search:
    """Search for fixes of a design; every changed design is judged here, unless it is too late."""

    results: Results
    current: Verdict  # of the design
    late: Callable[[], bool] = lambda: False  # True if the time is over
    untried: dict[str, None] = field(default_factory=dict)  # inputs that were not tried in time

    def made(self, design: Design) -> Results:
        """Results of a changed design; `Late` is raised if the time is over."""
        if self.late():
            raise Late
        return Results(design, like=self.results)

    def verdict(self, design: Design) -> Verdict:
        """Verdict of a changed design."""
        return crank_verdict(self.made(design))

    def aimed(self, *, design: Design, check: Check) -> Check:
        """Check of a changed design under the torque that its fix has to bear.

        `check` is the check before the change. If it has no reserve, the worse result under that
        torque and under the working torque is returned.
        """
        most, made = aim(check), self.made(design)
        factors = {most if check.by_torque else 1.0, most if check.kind.loaded else 1.0}
        under_each = [made.under(factor) for factor in factors]
        ways = [*under_each, *(each.equal for each in under_each if each.two_ways)]
        found = min((crank_check(check.code, way) for way in ways), key=least_met)
        if not found.by_torque:
            return found
        return found._replace(torque_reserve=found.reserve * max(factors))


def met(check: Check) -> float:
    """Value of a check over the target of its fix, at least 1 if met; NaN if not known."""
    if check.by_torque:
        return check.reserve / aim(check)
    return 1 / check.utilisation if check.utilisation else math.nan


def least_met(check: Check) -> float:
    """Value of a check over the target of its fix; minus infinity if not known."""
    found = met(check)
    return -math.inf if math.isnan(found) else found


def vary(*, design: Design, variable: str, value: float) -> Design:
    """Design with another value, SI, of an input. The hole follows pin and eccentricity and keeps
    its clearance, or takes that of its fit at the new sizes.
    """
    if variable in WHOLE:
        return changed(design, {variable: round(value)})
    values = {variable: value}
    if variable in ("contact.pin_radius", "contact.eccentricity"):
        hole = design.contact.hole_radius
        if hole is not None:
            before = value_at(design, variable) or 0.0
            values["contact.hole_radius"] = hole + value - before
    if variable == "contact.pin_radius" and design.pin and not design.sleeved:
        values["pin.diameter"] = 2 * value
    found = changed(design, values)
    if variable not in ("contact.pin_radius", "contact.eccentricity") or not found.contact.iso_fit:
        return found
    return changed(found, {"contact.hole_radius": _hole_of_fit(found)})


def _hole_of_fit(design: Design) -> float:
    """Radius of a hole that has the mean clearance of its fit, m."""
    pin = design.nominal_pair.pin_radius
    hole = pin + (design.contact.eccentricity or 0.0)
    clearance = fit_clearance(
        fit=design.contact.iso_fit, hole_diameter=2 * hole, pin_diameter=2 * pin
    )
    return hole + clearance


def value_of(*, design: Design, variable: str) -> float:
    """Value of an input, SI; `NotKnown` if it is not given or follows another one. Pins without
    sleeves, and pins in rollers, share their diameter with the contact; the hole of a fit follows
    its pin.
    """
    if variable == RATING:
        bearings = required(design.crankshaft.bearings, "rating_unknown", "crankshaft.bearings")
        return min(required(each.dynamic_rating, "rating_unknown", RATING) for each in bearings)
    follows = {
        "pin.diameter": not design.sleeved,
        "contact.pin_radius": bool(design.rollers),
        "contact.hole_radius": bool(design.contact and design.contact.iso_fit),
    }
    value: float | None = None if follows.get(variable) else value_at(design, variable)
    return required(value, "size_missing", variable)


def count_may_change(design: Design) -> bool:
    """True if the number of satellites may change: no coupling, nothing listed for each one."""
    cranks = design.mechanism
    if cranks.output == "coupling":  # a coupling has one satellite
        return False
    listed = (cranks.crank_angles, cranks.crank_spacing, design.pin, design.crankshaft)
    shares = design.support.given_shares
    return not (shares or design.deviations or any(listed))
