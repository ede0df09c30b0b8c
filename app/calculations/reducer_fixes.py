"""Fixes of a reducer: other sizes, and other materials and fits by name."""

from collections.abc import Iterator
from typing import Any

from pydantic import ValidationError

from app.pointers import with_values
from core.checks.check import Check, Verdict
from core.checks.reserve import crank_verdict
from core.errors import CalculationError
from core.fixes.crank import CHOICES, aimed, crank_fixes
from core.fixes.fix import Fix, beyond, in_order, side_effects
from core.material_table import MATERIALS
from core.materials import PLASTICS
from core.tolerance.iso286 import fit_clearance

FITS = ("H6/h5", "H6/g5", "H7/h6", "H7/g6", "H7/f7", "H8/f7", "H8/f8", "H9/f9")
"""Usual fits of ISO 286 with clearance."""


def fixes_of(request: Any, codes: list[str], current: Verdict) -> list[Fix]:
    """Fixes of the checks `codes` of a reducer, the best first."""
    sizes = crank_fixes(results=request.results, codes=codes, current=current)
    chosen = (
        _chosen(request, current[code], variable, current)
        for code in codes
        for variable in current[code].kind.fixes
        if variable in CHOICES
    )
    return in_order([*sizes, *filter(None, chosen)])


def reposted(request: Any, sets: dict[str, Any]) -> Any:
    """Request with the values of a fix, as a client would send it."""
    document = request.model_dump(mode="json", by_alias=True, exclude_unset=True)
    return type(request).model_validate(with_values(document, sets))


def _chosen(request: Any, check: Check, variable: str, current: Verdict) -> Fix | None:
    """First other name of an input that cures a check: the weakest material or the nearest fit."""
    section, name = variable.split(".")
    before = getattr(request.contact, name, None)
    if not isinstance(before, str):  # given by values, or not at all
        return None
    others = _fits(request, before) if name == "fit" else _materials(before)
    for after in others:
        try:
            other = reposted(request, {f"/{section}/{name}": after})
        except ValidationError:  # another field states the present material of the discs too
            continue
        try:
            if not beyond(aimed(design=other.design, check=check)) >= 0:
                continue
            found = crank_verdict(other.results)
        except CalculationError:  # another class makes no design of it
            continue
        if found[check.code].status == "pass":
            effects = side_effects(code=check.code, current=current, found=found)
            outcome = found.verdict
            return Fix(check.code, variable, before, after, None, False, "solved", outcome, effects)
    return None


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
