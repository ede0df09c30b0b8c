"""Fixes of a reducer: other sizes, and other materials, fits and bearings by name."""

from collections.abc import Iterable, Iterator
from typing import Any

from pydantic import ValidationError

from app.calculations.checks import places_of, value_in
from app.model import pointer
from app.pointers import with_values
from core.bearings import Rating, exchanges, named_bearing
from core.checks.check import Check
from core.errors import CalculationError
from core.fixes.changes import Late, Search
from core.fixes.crank import CHOICES, NAMED, crank_fixes, possible
from core.fixes.fix import Fix, aim, beyond, in_order, side_effects
from core.material_table import MATERIALS
from core.materials import PLASTICS
from core.tolerance.iso286 import fit_clearance

FITS = ("H6/h5", "H6/g5", "H7/h6", "H7/g6", "H7/f7", "H8/f7", "H8/f8", "H9/f9")
"""Usual fits of ISO 286 with clearance."""

RATED: dict[str, Rating] = {"life": "dynamic_rating", "static": "static_rating"}
"""Load rating that decides a check of a bearing, by the end of its code."""


def fixes_of(request: Any, codes: list[str], search: Search) -> list[Fix]:
    """Fixes of the checks `codes` of a reducer, the best first."""
    fixes = crank_fixes(search=search, codes=codes)
    for check in map(search.current.__getitem__, codes):
        for variable in (each for each in check.kind.fixes if each in CHOICES):
            try:
                if chosen := _chosen(request, check, variable, search):
                    fixes.append(chosen)
            except Late:
                search.untried[variable] = None
    return in_order(fixes)


def reposted(request: Any, sets: dict[str, Any]) -> Any:
    """Request with the values of a fix, as a client would send it."""
    document = request.model_dump(mode="json", by_alias=True, exclude_unset=True)
    return type(request).model_validate(with_values(document, sets))


def _chosen(request: Any, check: Check, variable: str, search: Search) -> Fix | None:
    """First other name of an input that cures a check: the weakest material, the nearest fit, the
    smallest bearing.
    """
    places = places_of(variable, request)
    named = {value for each in places if isinstance(value := value_in(request, each), str)}
    if len(named) != 1:  # given by values, or not at all, or two different bearings
        return None
    (before,) = named
    for after in _others(request, check, variable, before):
        try:
            other = reposted(request, {pointer(each): after for each in places})
        except ValidationError:  # another field states the present material of the discs too
            continue
        try:
            if not beyond(search.aimed(design=other.design, check=check)) >= 0:
                continue
            found = search.verdict(other.design)
        except CalculationError:  # another class makes no design of it
            continue
        effects = side_effects(code=check.code, current=search.current, found=found)
        outcome = found.verdict
        fix = Fix(check.code, variable, before, after, None, False, "solved", outcome, effects)
        if found[check.code].status == "pass" and possible(fix):
            return fix
    return None


def _others(request: Any, check: Check, variable: str, before: str) -> Iterable[str]:
    """Other names of an input that may cure a check, the nearest first."""
    if variable == "contact.fit":
        return _fits(request, before)
    if variable not in NAMED:
        return _materials(before)
    present = named_bearing(before)
    if present is None or not check.by_torque:
        return ()
    rating = RATED[check.code.rpartition("_")[2]]
    least = getattr(present, rating) * aim(check) / check.reserve
    return exchanges(present=present, rating=rating, least=least)


def _materials(before: str) -> Iterator[str]:
    """Metals of a larger allowable pressure than that of a metal, in ascending order."""
    present = MATERIALS[before]
    if present.group in PLASTICS:
        return
    limits = {
        name: limit.pressure
        for name, each in MATERIALS.items()
        if each.group not in PLASTICS and not each.missing and (limit := each.material.limit)
    }
    least = limits.get(before, 0.0)
    yield from sorted((name for name in limits if limits[name] > least), key=limits.__getitem__)


def _fits(request: Any, before: str) -> list[str]:
    """Other usual fits, ordered by the difference of their clearance from the present one."""
    pair = request.design.nominal_pair
    pin, hole = 2 * pair.pin_radius, 2 * pair.hole_radius

    def loose(fit: str) -> float:
        return fit_clearance(fit=fit, hole_diameter=hole, pin_diameter=pin)

    present = loose(before)
    return sorted({*FITS} - {before}, key=lambda fit: (abs(loose(fit) - present), fit))
