"""Fixes of involute teeth by profile shifts: the best shifts at the given eccentricity, with lower
heights if no shifts are possible, and the nearest eccentricity that keeps tips apart.
"""

import math
from collections.abc import Iterable, Iterator
from typing import Any, NamedTuple

from core.checks.check import Verdict
from core.design.document import changed, value_at
from core.design.results import Results
from core.errors import CalculationError, if_known
from core.fixes.changes import Search, vary
from core.fixes.fix import Fix, side_effects
from core.ring.involute import HEIGHTS, TIPS_APART, InvoluteTeeth
from core.ring.possible_teeth import possible_teeth
from core.ring.shift_choice import nearest_ring, shifts_at

SHIFT = "gear.satellite_profile_shift"
"""Input that names a fix by profile shifts."""

ECCENTRICITY = "contact.eccentricity"

DIGITS = 4
"""Decimals of shifts and heights, in modules."""

MICRON = 1e-6
"""Step of an eccentricity, m."""

SPARE = 1e-3
"""Clearance of the tips beyond the limit of their check, for rounding."""

LOWER = 0.01
"""Reduction of tooth heights, in modules, below those of the largest contact ratio, whose path ends
exactly at the ends of the flanks."""


class Shifted(NamedTuple):
    """Design with other profile shifts."""

    variable: str  # input that names the fix
    before: float  # value of the input without the fix, SI
    after: float  # value of the input with the fix, SI
    beside: dict[str, float]  # other inputs that are set
    verdict: Verdict


def shifted(search: Search) -> list[Shifted]:
    """Designs with chosen profile shifts and the inputs that change with them; empty if the teeth
    are not known or no design results.
    """
    results = search.results
    try:
        teeth = results.ring.pair.teeth
    except CalculationError:  # the shifts are not known
        return []
    made, design = [], results.design
    for variable, values in _choices(results, teeth):
        before, after = float(value_at(design, variable)), values.pop(variable)
        other = vary(design=design, variable=variable, value=after)
        try:
            verdict = search.verdict(changed(other, values))
        except CalculationError:  # the eccentricity makes no design
            continue
        made.append(Shifted(variable, before, after, values, verdict))
    return made


def shift_fixes(*, designs: Iterable[Shifted], code: str, current: Verdict) -> list[Fix]:
    """Fixes that make a check pass by profile shifts: the first for each naming input."""
    fixes: dict[str, Fix] = {}
    for each in designs:
        if each.verdict[code].status == "pass" and each.variable not in fixes:
            fixes[each.variable] = Fix(
                code=code,
                variable=each.variable,
                before=each.before,
                after=each.after,
                exact=None,
                standard=False,
                status="solved",
                verdict=each.verdict.verdict,
                side_effects=side_effects(code=code, current=current, found=each.verdict),
                beside=each.beside,
            )
    return [*fixes.values()]


def _choices(results: Results, teeth: InvoluteTeeth) -> Iterator[tuple[str, dict[str, Any]]]:
    """Naming input and all values of each choice of profile shifts."""
    line = results.ring.pair.line
    room = TIPS_APART + SPARE
    if best := if_known(lambda: shifts_at(teeth=teeth, eccentricity=line.eccentricity, room=room)):
        yield SHIFT, _values(results, best)
    possible = possible_teeth(
        satellite_teeth=teeth.satellite_teeth,
        ring_teeth=teeth.ring_teeth,
        module=teeth.module,
        eccentricity=line.eccentricity,
        rack=teeth.rack,
    )
    if possible.teeth:
        yield SHIFT, _values(results, possible.teeth, lower=LOWER)
    if nearest := if_known(lambda: nearest_ring(teeth=teeth, room=room)):
        values = _values(results, nearest.teeth)
        del values[SHIFT]
        step = math.floor(nearest.line.eccentricity / MICRON) * MICRON
        yield ECCENTRICITY, {ECCENTRICITY: round(step, 9)} | values


def _values(results: Results, teeth: InvoluteTeeth, *, lower: float = 0.0) -> dict[str, Any]:
    """Rounded shifts of teeth with heights reduced by `lower`, or tip radii if these are given."""
    gear, scale = results.design.involute, 10**DIGITS
    # Rounding up the ring's shift leaves backlash and keeps tips apart.
    ring = math.ceil(teeth.ring_profile_shift * scale - 1e-6) / scale
    values = {SHIFT: round(teeth.satellite_profile_shift, DIGITS), "gear.ring_profile_shift": ring}
    own = {"satellite": teeth.satellite_addendum, "ring": teeth.ring_addendum}
    numbers = {"satellite": teeth.satellite_teeth, "ring": teeth.ring_teeth}
    for body, addendum in own.items():
        height = math.floor((addendum - lower) * scale + 1e-6) / scale
        height = min(max(height, HEIGHTS[0]), HEIGHTS[1])
        if getattr(gear, f"{body}_addendum") is None:
            outwards = 1 if body == "satellite" else -1
            shift = values[SHIFT] if body == "satellite" else ring
            tip = numbers[body] / 2 + shift + outwards * height
            values[f"gear.{body}_tip_radius"] = gear.module * tip
        elif lower > 0:
            values[f"gear.{body}_addendum"] = height
    return values
