"""Fix of a check by one input: solved, rounded to the safe side, with side effects."""

import math
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from typing import Literal

from core.checks.check import MARGIN, Check, Verdict
from core.errors import CalculationError
from core.numerics.inverse import Solution, solve_for

WHOLE = {"mechanism.pins", "mechanism.satellites", "rollers"}
"""Inputs that are whole numbers."""

FixStatus = Literal["solved", "not_enough", "not_monotone"]


class NoFix(CalculationError):
    """Refusal if no value of an input makes or improves a check."""


PIN_SIZES = (
    *(0.8, 1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0, 12.0, 16.0, 20.0, 25.0, 30.0),
    *(40.0, 50.0),
)
"""Diameters of parallel pins of ISO 2338 (DIN 7), mm; up to 20 mm also of ISO 8734."""

UNITS = {"load.input_speed": 2 * math.pi / 60}
"""Units, in SI, in which inputs are rounded if users count in other units: revolutions per
minute."""

WALL = 1e-3
"""Wall that a fix aims at if no wall is requested, m."""

RANGE = 20.0
"""Largest factor by which an input is increased or decreased."""

SAMPLES = 17
"""Number of places at which that range is sampled first."""

COUNTS = 20
"""Largest number of whole numbers that are tried."""


@dataclass(frozen=True, slots=True)
class SideEffect:
    """Effect of a fix on another check."""

    code: str  # code of the other check
    before: Check  # result without the fix
    after: Check  # result with the fix


@dataclass(frozen=True, slots=True)
class Fix:
    """One input changed so that a check passes."""

    code: str  # code of the check
    variable: str  # path of the input
    before: float | str  # SI, or the name of a choice
    after: float | str  # SI, or the name of a choice
    exact: float | None  # value before rounding, SI; None for a choice
    standard: bool  # True if the value is a standard size
    # `not_enough`: no value in range passes, the best is given; `not_monotone`: several stretches
    # of values pass, the nearest is given.
    status: FixStatus
    verdict: str  # verdict of the whole design with the fix
    side_effects: tuple[SideEffect, ...]  # changed other checks
    beside: Mapping[str, float] = field(default_factory=dict)  # inputs set together, SI, by path

    @property
    def change(self) -> float | None:
        """Relative change of the input; None for a choice, a value of 0 or a change of sign."""
        if isinstance(self.after, str) or isinstance(self.before, str) or self.exact is None:
            return None
        return self.after / self.before - 1 if self.after * self.before > 0 else None

    @property
    def extent(self) -> float:
        """Magnitude of the change: logarithm of the ratio; 0 without a ratio."""
        return abs(math.log1p(self.change or 0.0))


def aim(check: Check) -> float:
    """Torque reserve that a fix of a check aims at."""
    return 1.0 if check.warning else MARGIN


def beyond(check: Check) -> float:
    """Distance of a check beyond the target of its fix, at least 0 if met.

    Raises NotKnown if the check could not be made.
    """
    value, limit = check.compared
    if check.by_torque:
        return check.reserve - aim(check)
    if check.kind.keep == "above":
        return value / limit - 1 if limit > 0 else value - WALL
    return limit - value


Change = Callable[[float], Check]


@dataclass(frozen=True, slots=True)
class Cure:
    """Input that is to cure a check, and functions that judge the changed design."""

    code: str  # code of the check
    variable: str  # path of the input
    before: float  # value, SI, > 0
    whole_list: Callable[[float], Verdict]  # all checks with another value
    current: Verdict  # all checks without a change
    standard: tuple[float, ...] = ()  # standard sizes, SI; may be empty

    def by(self, exact: float, found: Solution, status: FixStatus) -> Fix:
        """Fix by an exact value, with rounding and side effects."""
        sizes = [] if self.variable in WHOLE or status == "not_enough" else self._sizes(exact)
        within = (
            (size, is_standard)
            for size, is_standard in sizes
            if any(start <= size <= end for start, end in found.intervals)
        )
        after, standard, verdict = self._made([*within, (exact, False)])
        if verdict.unforced and not self.current.unforced:  # the parts cannot be assembled
            raise NoFix
        effects = side_effects(code=self.code, current=self.current, found=verdict)
        outcome = verdict.verdict
        return Fix(
            self.code, self.variable, self.before, after, exact, standard, status, outcome, effects
        )

    def _sizes(self, exact: float) -> list[tuple[float, bool]]:
        """Rounded sizes on the safe side of an exact one, best first, with True if standard."""
        up = exact >= self.before
        beyond_it = [each for each in self.standard if (each >= exact if up else each <= exact)]
        sizes = [((min if up else max)(beyond_it), True)] if beyond_it else []
        unit = UNITS.get(self.variable, 1.0)
        step = 10.0 ** (2 - math.floor(math.log10(exact / unit)))
        rounded = (math.ceil if up else math.floor)(exact / unit * step)
        return [*sizes, (rounded / step * unit, False)]

    def _made(self, sizes: list[tuple[float, bool]]) -> tuple[float, bool, Verdict]:
        """First size that makes a design, True if it is standard, and the verdict."""
        (size, standard), *others = sizes
        try:
            return size, standard, self.whole_list(size)
        except CalculationError:  # for example a pin as thick as its sleeve
            if not others:
                raise
            return self._made(others)


def fix_of(*, cure: Cure, change: Change) -> Fix:
    """Fix by an input, solved so that a check passes; `change` makes the check at another value.

    Raises NoFix if the check cannot be made at any value, or is best as it is.
    """
    before, whole = cure.before, cure.variable in WHOLE

    def measure(value: float) -> float:
        try:
            return beyond(change(value))
        except CalculationError:
            return math.nan

    if whole:
        low = max(1.0, before - COUNTS // 2)
        high = low + COUNTS - 1
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
            raise NoFix
        return cure.by(found.best[0], found, "not_enough")
    ends = [end for interval in found.intervals for end in interval if end not in (low, high)]
    ends = ends or [end for interval in found.intervals for end in interval]
    exact = min(ends, key=lambda end: abs(math.log(end / before)))
    return cure.by(exact, found, "solved" if len(found.intervals) == 1 else "not_monotone")


def side_effects(*, code: str, current: Verdict, found: Verdict) -> tuple[SideEffect, ...]:
    """Changes of other checks by a fix of the check `code`, from verdicts without and with it."""
    return tuple(
        SideEffect(code=each.code, before=old, after=each)
        for each in found.checks
        if each.code != code
        for old in current.checks
        if old.code == each.code and _changed(old, each)
    )


def _changed(before: Check, after: Check) -> bool:
    if before.status != after.status:
        return True
    one, two = before.utilisation, after.utilisation
    return one is not None and two is not None and abs(two - one) > 1e-3 * abs(one)


def in_order(fixes: Iterable[Fix]) -> list[Fix]:
    """Fixes ordered by status, then by the verdict that they lead to, then by least change."""
    verdicts = ("pass", "marginal", "incomplete", "fail")
    ways = ("solved", "not_monotone", "not_enough")
    return sorted(
        fixes,
        key=lambda each: (
            ways.index(each.status),
            verdicts.index(each.verdict),
            each.extent,
        ),
    )
