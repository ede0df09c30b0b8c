"""Fixes of a check: each input that it depends on, solved alone, and what else that changes.

A fix is found, not looked up: which way an input has to go is not obvious. It aims beyond the
marginal band, is rounded to the safe side (pins to standard sizes), and all checks are made again
with it.
"""

import math
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace
from typing import Any, Literal

from core.checks.check import MARGIN, Check, Verdict
from core.checks.crank_design import CrankDesign
from core.checks.crank_planetary import CRANK, crank_checks, crank_tables
from core.checks.pin_contact import CONTACT, real_reserve
from core.checks.pins import PIN_FATIGUE
from core.checks.pins import PINS as PIN_CHECKS
from core.checks.play import PLAY
from core.errors import CalculationError
from core.exploration.solve import Solution, solve_for
from core.output.satellite_support import Shares

FixStatus = Literal["solved", "not_enough", "not_monotone"]

PIN_SIZES = (
    *(0.8, 1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0, 12.0, 16.0, 20.0, 25.0, 30.0),
    *(40.0, 50.0),
)
"""Diameters of parallel pins in mm that ISO 2338 (DIN 7) has; up to 20 mm ISO 8734 too."""

WALL = 1e-3
"""Wall that a fix aims at where none is asked, m."""

RANGE = 20.0
"""How many times larger or smaller than it is an input is looked at."""

SAMPLES = 17
"""Places at which that range is looked at first."""

COUNTS = 20
"""Most whole numbers that are tried."""

_STRESS = (
    "contact_length",
    "pin_radius",
    "pin_circle_radius",
    "pins",
    "satellites",
    "output_torque",
)

_PIN = ("pin.diameter", "pin_radius", "pin_circle_radius", "pins", "output_torque")
_LIFE = ("bearing.dynamic_rating", "pin_circle_radius", "input_speed", "output_torque")

VARIED: dict[str, tuple[str, ...]] = {
    "dead_centre": ("pins", "satellites"),
    "crank_balance": ("crank_spacing",),
    "contact_pressure_pin": _STRESS,
    "contact_pressure_hole": _STRESS,
    "contact_shakedown_pin": _STRESS,
    "contact_shakedown_hole": _STRESS,
    "contact_yield_pin": _STRESS,
    "contact_yield_hole": _STRESS,
    "contact_conformity": _STRESS,
    "interference": ("hole_radius",),
    "clearance": ("hole_radius",),
    "backlash": ("hole_radius",),
    "lost_motion": ("hole_radius",),
    "wall_holes": ("pin_circle_radius", "pin_radius", "pins"),
    "pins_apart": ("pin_circle_radius", "pin_radius", "pins"),
    "holes_off_centre": ("pin_circle_radius", "pin_radius"),
    "wall_rim": ("outer_radius", "root_radius", "pin_circle_radius", "pin_radius"),
    "wall_bore": ("bore_radius", "pin_circle_radius", "pin_radius"),
    "roller_stress": (
        "diameter",
        "hole_circle_radius",
        "rollers",
        "position_tolerance",
        "output_torque",
    ),
    "roller_fatigue": ("diameter", "hole_circle_radius", "rollers", "output_torque"),
    "roller_sharing": ("position_tolerance", "output_torque"),
    "roller_spacing": ("hole_circle_radius", "sphere_diameter", "rollers"),
    "roller_room": ("hole_circle_radius", "sphere_diameter"),
    "roller_tilt": ("cylinder_length",),
    "assembly": ("satellites",),
    "outer_diameter": ("outer_radius",),
    "pin_static": (*_PIN, "peak_torque"),
    "pin_fatigue": _PIN,
    "pin_deflection": _PIN,
    "pin_slope": _PIN,
    "efficiency": ("friction.coefficient", "pin_circle_radius", "pin.diameter"),
    "sliding_speed": ("input_speed", "pin.diameter"),
    "pv": ("pin_radius", "contact_length", "pin_circle_radius", "input_speed", "output_torque"),
    "wear": (
        "friction.wear_rate",
        "contact_length",
        "pin_radius",
        "pin_circle_radius",
        "input_speed",
        "output_torque",
    ),
    "pressure_angle": ("gear.module",),
    "gear_room": ("pin_circle_radius", "pin_radius", "gear.ring_pin_circle_radius"),
    "bearing_life": _LIFE,
    "bearing_static": (
        "bearing.static_rating",
        "pin_circle_radius",
        "output_torque",
        "peak_torque",
    ),
    "system_life": _LIFE,
    "crank_bearing_life": (
        "crankshaft.dynamic_rating",
        "pin_circle_radius",
        "input_speed",
        "output_torque",
    ),
    "unbalance_force": ("crankshaft.satellite_mass", "input_speed"),
    "unbalance_couple": ("crankshaft.satellite_mass", "input_speed"),
    "line_spacing": ("roller_radius", "roller_circle_radius"),
    "shaft_in_circle": ("shaft_diameter", "roller_radius", "roller_circle_radius"),
    "shaft_deflection": ("shaft_diameter", "overhang", "bearing_distance"),
    "shaft_slope": ("shaft_diameter", "overhang", "bearing_distance"),
    "shaft_static": ("shaft_diameter", "overhang"),
    "shaft_fatigue": ("shaft_diameter", "overhang"),
    "line_pressure": ("roller_radius", "roller_circle_radius"),
}
"""Inputs that a fix of a check may change, by their core names."""

WHOLE = {"pins", "satellites", "rollers"}
"""Inputs that are whole numbers."""

GROWTH = {
    "contact_length": 1.0,
    "pin_radius": 1.8,
    "pin_circle_radius": 1.0,
    "output_torque": -1.0,
}
"""With which power of an input the torque reserve of a pressure grows, about: where a search for a
fix of the mechanism as it is made starts."""

PINS = {*PIN_CHECKS, *PIN_FATIGUE}
"""Checks of the pin itself: its sleeve does not count."""

POWERS = {
    "pin_static": {"pin.diameter": 3.0, "pin_radius": 3.0, "peak_torque": -1.0},
    "pin_fatigue": {"pin.diameter": 3.0, "pin_radius": 3.0},
    "pin_deflection": {"pin.diameter": 4.0, "pin_radius": 4.0},
    "pin_slope": {"pin.diameter": 4.0, "pin_radius": 4.0},
    "efficiency": {"pin.diameter": -1.0},
    "sliding_speed": {"pin.diameter": -1.0},
    "pv": {},
    "wear": {},
    "bearing_life": {"bearing.dynamic_rating": 1.0, "input_speed": -0.3},
    "bearing_static": {"bearing.static_rating": 1.0, "peak_torque": -1.0},
    "system_life": {"bearing.dynamic_rating": 1.0, "input_speed": -0.3},
    "crank_bearing_life": {"crankshaft.dynamic_rating": 1.0, "input_speed": -0.3},
    "unbalance_force": {"input_speed": -2.0},
    "unbalance_couple": {"input_speed": -2.0},
    "outer_diameter": {"outer_radius": -1.0},
}
"""The same of checks that grow or fall with a power of their inputs: of the reserve, else of the
reciprocal of the utilisation. What is not named is one of `USUAL`."""

USUAL = {
    "contact_length": 1.0,
    "pin_radius": 1.0,
    "pin_circle_radius": 1.0,
    "output_torque": -1.0,
    "input_speed": -1.0,
    "friction.coefficient": -1.0,
    "friction.wear_rate": -1.0,
    "crankshaft.satellite_mass": -1.0,
}

SEARCHED = 8
"""Most steps of that search, and of the one for a clearance."""


@dataclass(frozen=True, slots=True)
class SideEffect:
    """What a fix does to another check.

    Attributes
    ----------
    code : str
        Which.
    before, after : Check
        It without and with the fix.
    """

    code: str
    before: Check
    after: Check


@dataclass(frozen=True, slots=True)
class Fix:
    """One input changed so that a check passes.

    Attributes
    ----------
    code : str
        The check.
    variable : str
        The input's core name.
    before, after : float
        The input without and with the fix, SI.
    exact : float
        What it had to be at least, or at most.
    standard : bool
        Whether it is a standard size.
    status : FixStatus
        `not_enough` where no value in range makes the check pass: then the best; `not_monotone`
        where there are several stretches that do: then the nearest.
    verdict : str
        Of the whole design with the fix.
    side_effects : tuple of SideEffect
        Other checks that change.
    """

    code: str
    variable: str
    before: float
    after: float
    exact: float
    standard: bool
    status: FixStatus
    verdict: str
    side_effects: tuple[SideEffect, ...]

    @property
    def change(self) -> float:
        """Relative change of the input."""
        return self.after / self.before - 1 if self.before else math.inf


def beyond(check: Check) -> float:
    """How far a check is beyond what a fix aims at; NaN where it cannot be made.

    Parameters
    ----------
    check : Check
        The check.

    Returns
    -------
    float
        >= 0 where it is met.
    """
    if check.value is None or check.limit is None:
        return math.nan
    if check.torque_reserve is not None:
        return check.torque_reserve - (1.0 if check.warning else MARGIN)
    if check.keep == "above":
        if check.limit > 0:
            return check.value / check.limit - 1
        return check.value - WALL
    return check.limit - check.value


Change = Callable[[float], Check]


def fix_of(
    *,
    code: str,
    variable: str,
    before: float,
    change: Change,
    whole_list: Callable[[float], Verdict],
    current: Verdict,
) -> Fix | None:
    """One input solved so that a check passes.

    Parameters
    ----------
    code : str
        The check.
    variable : str
        The input's core name.
    before : float
        Its value, SI, > 0.
    change : callable
        The check with another value of the input.
    whole_list : callable
        All checks with it.
    current : Verdict
        All checks without it.

    Returns
    -------
    Fix or None
        None where the check cannot be made at any value.
    """
    whole = variable in WHOLE

    def measure(value: float) -> float:
        try:
            return beyond(change(value))
        except CalculationError:
            return math.nan

    if whole:
        low, high = max(1.0, before - COUNTS // 2), max(1.0, before - COUNTS // 2) + COUNTS - 1
    else:
        low, high = before / RANGE, before * RANGE
    found = solve_for(
        function=measure,
        low=low,
        high=high,
        target=0.0,
        integer=whole,
        log=not whole,
        samples=SAMPLES,
    )
    if not found.intervals:
        if found.best is None or found.best[0] == before:
            return None
        return _made(
            code, variable, before, found.best[0], found, "not_enough", whole_list, current
        )
    ends = [end for interval in found.intervals for end in interval if end not in (low, high)]
    ends = ends or [end for interval in found.intervals for end in interval]
    exact = min(ends, key=lambda end: abs(math.log(end / before)))
    status: FixStatus = "solved" if len(found.intervals) == 1 else "not_monotone"
    return _made(code, variable, before, exact, found, status, whole_list, current)


def _made(
    code: str,
    variable: str,
    before: float,
    exact: float,
    found: Solution,
    status: FixStatus,
    whole_list: Callable[[float], Verdict],
    current: Verdict,
) -> Fix:
    """A fix with its rounding and its side effects."""
    up = exact >= before
    after, standard = exact, False
    if variable not in WHOLE and status != "not_enough":
        sizes = _sizes(variable, exact, up)
        for size, is_standard in sizes:
            if any(start <= size <= end for start, end in found.intervals):
                after, standard = size, is_standard
                break
    verdict = whole_list(after)
    effects = tuple(
        SideEffect(code=each.code, before=old, after=each)
        for each in verdict.checks
        if each.code != code
        for old in current.checks
        if old.code == each.code and _changed(old, each)
    )
    return Fix(code, variable, before, after, exact, standard, status, verdict.verdict, effects)


def _changed(before: Check, after: Check) -> bool:
    if before.status != after.status:
        return True
    one, two = before.utilisation, after.utilisation
    return one is not None and two is not None and abs(two - one) > 1e-3 * abs(one)


def _sizes(variable: str, exact: float, up: bool) -> list[tuple[float, bool]]:
    """Rounded sizes on the safe side of an exact one, the best first, and whether standard ones."""
    sizes: list[tuple[float, bool]] = []
    if variable in ("pin_radius", "pin.diameter"):
        unit = 2000 if variable == "pin_radius" else 1000
        beyond_it = [
            size / unit
            for size in PIN_SIZES
            if (size / unit >= exact if up else size / unit <= exact)
        ]
        if beyond_it:
            sizes.append((beyond_it[0] if up else beyond_it[-1], True))
    step = 10.0 ** (2 - math.floor(math.log10(exact)))
    rounded = (math.ceil if up else math.floor)(exact * step)
    return [*sizes, (rounded / step, False)]


def vary(*, design: CrankDesign, variable: str, value: float) -> CrankDesign:
    """A design with another value of an input; the hole follows pin and eccentricity.

    Parameters
    ----------
    design : CrankDesign
        The design.
    variable : str
        Its attribute.
    value : float
        The value, SI.

    Returns
    -------
    CrankDesign
    """
    if variable in WHOLE:
        return replace(design, **{variable: round(value)})  # type: ignore[arg-type]
    if variable == "crankshaft.dynamic_rating":
        return _rated(design, value)
    section, _, name = variable.rpartition(".")
    if section:
        part = replace(getattr(design, section), **{name: value})
        return replace(design, **{section: part})
    changed: dict[str, float] = {variable: value}
    if variable in ("pin_radius", "eccentricity") and design.hole_radius is not None:
        changed["hole_radius"] = design.hole_radius + value - (getattr(design, variable) or 0.0)
    made = replace(design, **changed)  # type: ignore[arg-type]
    if variable == "pin_radius" and design.pin and not design.sleeved:
        made = replace(made, pin=replace(design.pin, diameter=2 * value))
    return made


def _rated(design: CrankDesign, rating: float) -> CrankDesign:
    """With both bearings of the crankshaft of a rating."""
    shaft = design.crankshaft
    assert shaft is not None and shaft.bearings is not None
    one, other = (replace(each, dynamic_rating=rating) for each in shaft.bearings)
    return replace(design, crankshaft=replace(shaft, bearings=(one, other)))


def value_of(*, design: CrankDesign, variable: str) -> float | None:
    """An input of a design.

    Parameters
    ----------
    design : CrankDesign
        The design.
    variable : str
        Its attribute, with its section's name before a dot.

    Returns
    -------
    float or None
        None where it is not given, or no input of its own: the diameter of a pin without a sleeve
        is that of the contact, with one the contact is not the pin's.
    """
    if variable == "crankshaft.dynamic_rating":
        bearings = design.crankshaft and design.crankshaft.bearings
        ratings = [each.dynamic_rating for each in bearings or ()]
        return None if not ratings or None in ratings else min(ratings)  # type: ignore[type-var]
    if variable == "pin.diameter" and not design.sleeved:
        return None
    found: Any = design
    for name in variable.split("."):
        found = None if found is None else getattr(found, name)
    return found  # type: ignore[no-any-return]


def crank_fixes(
    *, design: CrankDesign, codes: Iterable[str], current: Verdict | None = None
) -> list[Fix]:
    """Fixes of checks of a crank-planetary reducer, the best first.

    Parameters
    ----------
    design : CrankDesign
        The design.
    codes : iterable of str
        The checks to be cured.
    current : Verdict, optional
        Its checks, where they were made already.

    Returns
    -------
    list of Fix
    """
    current = current or crank_checks(design)
    fixes = []
    for code in codes:
        for variable in VARIED.get(code, ()):
            try:
                fix = _fix(design, code, variable, current)
            except CalculationError:  # a size that would cure it makes no design
                continue
            if fix is not None:
                fixes.append(fix)
    return in_order(fixes)


def _fix(design: CrankDesign, code: str, variable: str, current: Verdict) -> Fix | None:
    """Fix of a check by one input."""
    before = value_of(design=design, variable=variable)
    if code in ("interference", "clearance", "crank_balance"):
        return _closed(design, code, variable, current)
    if code in PLAY:
        return _less_clearance(design, code, current)
    if not before or (variable == "satellites" and not _even(design)):
        return None
    strength = code in POWERS or (code in CONTACT and design.pin is not None)
    if strength and variable not in WHOLE:
        return _by_power(design, code, variable, current)
    if design.as_made and code in CONTACT:
        return _as_made(design, code, variable, current)
    if design.as_made and strength:  # each number would be solved over the turn
        return None

    def changed(value: float) -> CrankDesign:
        return vary(design=design, variable=variable, value=value)

    return fix_of(
        code=code,
        variable=variable,
        before=float(before),
        change=lambda value: CRANK[code](changed(value)),
        whole_list=lambda value: crank_checks(changed(value)),
        current=current,
    )


def plain_fixes(
    *,
    design: Mapping[str, Any],
    codes: Iterable[str],
    current: Verdict,
    checks: Callable[[dict[str, Any]], Verdict],
) -> list[Fix]:
    """Fixes of checks of a design whose inputs do not hang on each other, the best first.

    Parameters
    ----------
    design : mapping
        Inputs by their core names, SI.
    codes : iterable of str
        The checks to be cured.
    current : Verdict
        Its checks.
    checks : callable
        All checks of changed inputs.

    Returns
    -------
    list of Fix
    """
    fixes = []
    for code in codes:
        for variable in VARIED.get(code, ()):
            before = design.get(variable)
            if not before or (variable == "rollers" and design.get("gaps") is not None):
                continue

            def whole_list(value: float, variable: str = variable) -> Verdict:
                changed = round(value) if variable in WHOLE else value
                return checks({**design, variable: changed})

            def change(
                value: float, code: str = code, all_of: Callable[[float], Verdict] = whole_list
            ) -> Check:
                return all_of(value)[code]

            fix = fix_of(
                code=code,
                variable=variable,
                before=float(before),
                change=change,
                whole_list=whole_list,
                current=current,
            )
            if fix is not None:
                fixes.append(fix)
    return in_order(fixes)


def _even(design: CrankDesign) -> bool:
    """Whether the number of satellites may change: nothing is listed for each of them."""
    listed = (design.crank_angles, design.crank_spacing, design.pin, design.crankshaft)
    shares = isinstance(design.support, Shares)
    return not shares and all(each is None for each in (*listed, design.deviations))


def _by_power(design: CrankDesign, code: str, variable: str, current: Verdict) -> Fix | None:
    """Fix of what grows or falls about with a power of an input."""
    powers = GROWTH if code in CONTACT else USUAL | POWERS[code]
    growth = powers.get(variable)
    if growth is None or (variable == "pin_radius" and design.sleeved and code in PINS):
        return None

    def beyond_aim(value: float) -> float:
        check = CRANK[code](vary(design=design, variable=variable, value=value))
        if check.torque_reserve is not None:
            return check.torque_reserve / (1.0 if check.warning else MARGIN)
        return 1 / check.utilisation if check.utilisation else math.nan

    before = value_of(design=design, variable=variable)
    assert before is not None
    exact = _secant(beyond_aim, before, growth)
    return None if exact is None else _checked(design, code, variable, exact, current)


def _secant(beyond_aim: Callable[[float], float], before: float, growth: float) -> float | None:
    """Where a measure that is about a power of an input is 1, or a trifle more."""
    points: list[tuple[float, float]] = []
    value = before
    for _ in range(SEARCHED):
        try:
            found = beyond_aim(value)
        except (CalculationError, AssertionError):
            return None
        if not found > 0:
            return None
        points.append((math.log(value), math.log(found)))
        if 0 <= points[-1][1] <= 1e-6:
            break
        if len(points) > 1 and points[-1][0] != points[-2][0]:
            growth = (points[-1][1] - points[-2][1]) / (points[-1][0] - points[-2][0])
        if not abs(growth) > 0.1:
            return None
        # a trifle beyond, so that it is met from the safe side
        value = math.exp(points[-1][0] - (points[-1][1] - 5e-7) / growth)
        if not before / RANGE <= value <= before * RANGE:
            return None
    return value


def _as_made(design: CrankDesign, code: str, variable: str, current: Verdict) -> Fix | None:
    """Fix of a pressure of the mechanism as it is made: the torque that brings it to its limit is
    known without the forces under the torque, and a power of most inputs.
    """
    before, check = getattr(design, variable), current[code]
    if variable not in GROWTH or check.limit is None or check.value is None:
        return None
    limit, aim = check.limit, 1.0 if check.warning else MARGIN

    def beyond_aim(value: float) -> float:
        changed = vary(design=design, variable=variable, value=value)
        return real_reserve(design=changed, limit=limit) / aim

    exact = _secant(beyond_aim, before, GROWTH[variable])
    return None if exact is None else _checked(design, code, variable, exact, current)


def _less_clearance(design: CrankDesign, code: str, current: Verdict) -> Fix | None:
    """Fix of backlash or lost motion, which grow with the clearance almost straight."""
    check, clearance, hole = current[code], design.clearance, design.hole_radius
    if check.value is None or check.limit is None or hole is None or not clearance:
        return None
    backlash = CRANK["backlash"](design).value
    if not backlash:
        return None
    value, slope = check.value, backlash / clearance
    place = clearance
    for _ in range(SEARCHED):
        if value <= check.limit:
            break
        before, former = place, value
        place = math.floor((place - (value - check.limit) / slope) * 1e7 - 1e-6) * 1e-7  # 0.1 um
        if place < 0:
            return None
        found = CRANK[code](
            vary(design=design, variable="hole_radius", value=hole + place - clearance)
        )
        if found.value is None or found.value >= former:
            return None
        value, slope = found.value, (former - found.value) / (before - place)
    return _checked(design, code, "hole_radius", hole + place - clearance, current)


def _checked(design: CrankDesign, code: str, variable: str, exact: float, current: Verdict) -> Fix:
    """A fix that was found, with all checks made again."""
    before = value_of(design=design, variable=variable)
    assert before is not None
    ends = (exact, exact * RANGE) if exact >= before else (exact / RANGE, exact)
    if variable == "hole_radius":
        ends = (exact, exact)
    found = Solution("solved", exact, None, (ends,), None, True, 1)
    verdicts: list[Verdict] = []

    def whole_list(value: float) -> Verdict:
        verdicts.append(crank_checks(vary(design=design, variable=variable, value=value)))
        return verdicts[-1]

    made = _made(code, variable, before, exact, found, "solved", whole_list, current)
    if verdicts[-1][code].status in ("fail", "not_checked"):
        return replace(made, status="not_enough")
    return made


def _closed(design: CrankDesign, code: str, variable: str, current: Verdict) -> Fix | None:
    """Fixes that are no search: the hole that fits, the even spacing."""
    if code == "crank_balance":
        if design.crank_spacing is None or design.satellites < 2:
            return None
        before, after = design.crank_spacing, 2 * math.pi / design.satellites
    else:
        if design.eccentricity is None or design.pin_radius is None or design.hole_radius is None:
            return None
        before, after = design.hole_radius, design.pin_radius + design.eccentricity
    exact = Solution("solved", after, None, ((after, after),), None, True, 1)
    changed = replace(design, **{variable: after})  # type: ignore[arg-type]
    if code not in crank_tables(changed) or not before:
        return None
    made = _made(
        code, variable, before, after, exact, "solved", lambda _: crank_checks(changed), current
    )
    return replace(made, after=after, standard=False)


def in_order(fixes: Iterable[Fix]) -> list[Fix]:
    """Fixes by the verdict that they lead to, then by how little they change.

    Parameters
    ----------
    fixes : iterable of Fix
        The fixes.

    Returns
    -------
    list of Fix
    """
    verdicts = ("pass", "marginal", "incomplete", "fail")
    ways = ("solved", "not_monotone", "not_enough")
    return sorted(
        fixes,
        key=lambda each: (
            ways.index(each.status),
            verdicts.index(each.verdict),
            abs(math.log(each.after / each.before)),
        ),
    )
