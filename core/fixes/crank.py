"""Fixes of a crank-planetary reducer."""

import math
from collections.abc import Callable, Iterable
from contextlib import suppress
from dataclasses import replace
from functools import cache

from core.checks.check import Check, Verdict
from core.checks.crank_planetary import crank_check
from core.checks.usual_fit import usual_clearance
from core.design.document import Design, value_at
from core.design.ring import CycloidRing
from core.errors import UNKNOWN, CalculationError
from core.fixes.changes import Late, Search, count_may_change, met, value_of, vary
from core.fixes.fix import (
    PIN_SIZES,
    RANGE,
    WHOLE,
    Cure,
    Fix,
    FixStatus,
    NoFix,
    fix_of,
    in_order,
    side_effects,
)
from core.fixes.shifts import SHIFT, shift_fixes, shifted
from core.numerics.inverse import Solution, edge
from core.precision import SEARCHED

LOOKS, NUDGE = 9, 0.02
"""Largest number of steps of a secant search, and relative size of its first step."""

NAMED = ("bearing.name", "rollers.name", "crankshaft.bearings.name")
"""Inputs that name a bearing."""

CHOICES = ("contact.pin_material", "contact.hole_material", "contact.fit", *NAMED)
"""Inputs chosen by name, whose fixes are found where names are known."""

SHIFTED = ("gear.modification.equidistant", "gear.modification.pin_circle")
"""Inputs that may be 0 and of either sign."""

ZONE = "tolerances.ring_pin_position"
"""Input under which one ring pin stands out, to which no power leads."""

FIRST_SHIFT, MOST_SHIFT, SHIFT_STEP = 1e-6, 0.5e-3, 1e-7
"""First change, largest value and rounding step of these inputs, m."""

CLOSE = 0.02
"""Largest excess of a check over its target by these inputs, as a logarithm."""

STRENGTH = ("pin", "pin_rollers", "friction", "bearing", "crankshaft")
"""Groups of checks whose values are nearly powers of their inputs."""


def crank_fixes(*, search: Search, codes: Iterable[str]) -> list[Fix]:
    """Fixes of the checks `codes` of a crank-planetary reducer, the best first."""
    fixes: list[Fix] = []
    chosen = cache(lambda: shifted(search))
    for code in codes:
        for variable in search.current[code].kind.fixes:
            if variable in CHOICES:
                continue
            try:
                if variable == SHIFT:
                    fixes += shift_fixes(designs=chosen(), code=code, current=search.current)
                else:
                    fixes.append(_fix(search, code, variable))
            except Late:
                search.untried[variable] = None
            except CalculationError:  # the required size may make an impossible design
                continue
    return in_order(each for each in fixes if not _too_wide(search.results.design, each))


def _too_wide(design: Design, fix: Fix) -> bool:
    """True if a fix makes a contact length or the pin circle larger than the ring pin circle.

    Without ring pins, the limits are the pin circle and ten times its size.
    """
    widens = fix.variable == "load.pin_circle_radius"
    wide = design.pin_circle_radius * (10 if widens else 1)
    if isinstance(design.gear, CycloidRing):
        wide = design.gear.ring_pin_circle_radius
    widens |= fix.variable.endswith("contact_length")
    return widens and fix.exact is not None and fix.exact > wide


def possible(fix: Fix) -> bool:
    """True if a fix makes no part overlap another that did not before."""
    made = ((each.before, each.after) for each in fix.side_effects)
    return not any(
        after.impossible and after.status == "fail" and before.status != "fail"
        for before, after in made
    )


def _fix(search: Search, code: str, variable: str) -> Fix:
    """Fix of a check by one input."""
    results, check = search.results, search.current[code]
    design, group = results.design, check.kind.group
    if code in ("interference", "clearance"):
        return _fitting(search, code)
    if group == "play":
        return _less_clearance(search, code)
    if variable in SHIFTED:
        return _shifted(search, code, variable)
    cure = _cure(search, code, variable)
    if variable == "mechanism.satellites" and not count_may_change(design):
        raise NoFix

    def change(value: float) -> Check:
        changed = vary(design=design, variable=variable, value=value)
        return search.aimed(design=changed, check=check)

    again = code == "ring_efficiency" or check.solved
    again = (again or results.solved) if group == "contact" else (again and group == "gear")
    solved = group in STRENGTH or again
    if solved and variable not in WHOLE:
        solve = _narrowed if variable == ZONE else _secant
        return _checked(cure, solve(lambda value: met(change(value)), cure.before))
    return fix_of(cure=cure, change=change)


def _cure(search: Search, code: str, variable: str) -> Cure:
    """Cure of a check by an input that is given and not 0."""
    design = search.results.design
    before = value_of(design=design, variable=variable)
    if not before:
        raise NoFix

    def whole_list(value: float) -> Verdict:
        return search.verdict(vary(design=design, variable=variable, value=value))

    standard = _standard(design, variable)
    return Cure(code, variable, float(before), whole_list, search.current, standard)


def _standard(design: Design, variable: str) -> tuple[float, ...]:
    """Standard sizes of an input, m: those of pins; empty for sleeves and other inputs."""
    if variable == "pin.diameter":
        return tuple(size / 1000 for size in PIN_SIZES)
    if variable == "contact.pin_radius" and not design.sleeved:
        return tuple(size / 2000 for size in PIN_SIZES)
    return ()


def _narrowed(measure: Callable[[float], float], before: float) -> float:
    """Largest zone of places at which a measure, which grows as the zone narrows, is at least 1."""
    least = before / RANGE
    if not measure(least) >= 1:
        raise NoFix
    exact, _ = edge(inside=least, outside=before, excess=lambda zone: measure(zone) - 1)
    return exact


def _secant(measure: Callable[[float], float], before: float) -> float:
    """Input at which a measure, nearly a power of the input, is 1 or slightly more."""
    points: list[tuple[float, float]] = []
    value, growth = before, 0.0
    for look in range(LOOKS):
        try:
            found = measure(value)
        except AssertionError as why:
            raise NoFix from why
        if not found > 0:
            raise NoFix
        points.append((math.log(value), math.log(found)))
        if 0 <= points[-1][1] <= SEARCHED:
            break
        if look == 0:
            value = before * (1 + NUDGE)
            continue
        if points[-1][0] != points[-2][0]:
            growth = (points[-1][1] - points[-2][1]) / (points[-1][0] - points[-2][0])
        if not abs(growth) > 0.1:
            raise NoFix
        # The step ends slightly beyond 1, so that the target is met from the safe side.
        value = math.exp(points[-1][0] - (points[-1][1] - SEARCHED / 2) / growth)
        if not before / RANGE <= value <= before * RANGE:
            raise NoFix
    return value


def _shifted(search: Search, code: str, variable: str) -> Fix:
    """Fix by a modification of the discs, which changes gaps linearly: interference is removed
    directly, other checks are met by secants.
    """
    design, current = search.results.design, search.current
    check = current[code]
    before, _ = value_of(design=design, variable=variable), check.compared
    looks = list[tuple[float, float]]()
    (other,) = (abs(value_at(design, each)) for each in SHIFTED if each != variable)
    larger = 1.0 if variable == "gear.modification.equidistant" else -1.0  # sign of larger gaps
    after, way = before, larger if code == "ring_pressed" else -larger

    def found(value: float) -> Check:
        changed = vary(design=design, variable=variable, value=value)
        return search.aimed(design=changed, check=check)

    for _ in range(LOOKS):
        seen = found(after)
        if code == "ring_pressed":
            short, _ = seen.compared
            if not short > 0:
                break
            step = short
        else:
            reached = met(seen)
            if not reached > 0:
                raise NoFix
            looks.append((after, math.log(reached)))
            if 0 <= looks[-1][1] <= CLOSE:
                break
            if len(looks) == 1:
                step = FIRST_SHIFT
            else:
                (x, one), (y, two) = looks[-2:]
                slope = (two - one) / (y - x) if y != x else 0.0
                if slope * way <= 0:
                    raise NoFix
                step = (CLOSE / 2 - two) / slope * way
                near = max(abs(after), other, 2 * FIRST_SHIFT) / 2  # small ones act steeply
                step = min(step, near)
        steps = math.ceil if step > 0 else math.floor
        after = SHIFT_STEP * round(after / SHIFT_STEP + way * steps(step / SHIFT_STEP))
        if abs(after) > MOST_SHIFT:
            raise NoFix
    else:
        raise NoFix
    made = search.verdict(vary(design=design, variable=variable, value=after))
    effects = side_effects(code=code, current=current, found=made)
    status: FixStatus = "solved" if made[code].status == "pass" else "not_enough"
    return Fix(code, variable, before, after, after, False, status, made.verdict, effects)


def _less_clearance(search: Search, code: str) -> Fix:
    """Fix of backlash or lost motion, which are nearly linear in the clearance."""
    design, check = search.results.design, search.current[code]
    clearance, cure = design.known_clearance, _cure(search, code, "contact.hole_radius")
    hole, (value, limit) = cure.before, search.aimed(design=design, check=check).compared
    backlash = crank_check("backlash", search.results).value
    if not clearance or not backlash:
        raise NoFix
    slope, place = backlash / clearance, clearance
    for _ in range(LOOKS):
        if value <= limit:
            break
        before, former = place, value
        place = math.floor((place - (value - limit) / slope) * 1e7 - 1e-6) * 1e-7  # 0.1 um
        if place < 0:
            raise NoFix
        smaller = vary(
            design=design, variable="contact.hole_radius", value=hole + place - clearance
        )
        value, _ = search.aimed(design=smaller, check=check).compared
        if value >= former:
            raise NoFix
        slope = (former - value) / (before - place)
    return _checked(cure, hole + place - clearance)


def _checked(cure: Cure, exact: float) -> Fix:
    """Fix by a solved value, with all checks made again."""
    ends = (exact, exact * RANGE) if exact >= cure.before else (exact / RANGE, exact)
    if cure.variable == "contact.hole_radius":
        ends = (exact, exact)
    verdicts: list[Verdict] = []

    def whole_list(value: float) -> Verdict:
        verdicts.append(cure.whole_list(value))
        return verdicts[-1]

    found = Solution("solved", exact, None, (ends,), None, True, 1)
    made = replace(cure, whole_list=whole_list).by(exact, found, "solved")
    check = verdicts[-1][cure.code]
    missed = check.status in ("fail", "not_checked") and not check.only_needed
    if missed or (check.warning and check.status == "marginal"):
        return replace(made, status="not_enough")
    return made


def _fitting(search: Search, code: str) -> Fix:
    """Fix by the hole radius with which parts fit and have a usual clearance."""
    results, design = search.results, search.results.design
    after = design.nominal_pair.pin_radius + design.known_eccentricity
    with suppress(*UNKNOWN):
        after = results.rooms.needed_hole_radius
    _, clearance = usual_clearance(design)
    after = math.ceil((after + clearance) * 1e6 - 1e-6) * 1e-6  # whole micrometres
    return _checked(_cure(search, code, "contact.hole_radius"), after)
