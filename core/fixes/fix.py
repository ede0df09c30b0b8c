"""A fix of a check by one input: solved, rounded to the safe side, with what else it changes."""

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
    """No value of an input is found with which a check can be made, or would be better."""


PIN_SIZES = (
    *(0.8, 1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0, 12.0, 16.0, 20.0, 25.0, 30.0),
    *(40.0, 50.0),
)
"""Diameters of parallel pins in mm that ISO 2338 (DIN 7) has; up to 20 mm ISO 8734 too."""

UNITS = {"load.input_speed": 2 * math.pi / 60}
"""Units in which inputs are rounded, in SI units, where people do not count in decimals of these: a
turn a minute."""

WALL = 1e-3
"""Wall that a fix aims at where none is asked, m."""

RANGE = 20.0
"""How many times larger or smaller than it is an input is looked at."""

SAMPLES = 17
"""Places at which that range is looked at first."""

COUNTS = 20
"""Most whole numbers that are tried."""


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
        The input's path.
    before, after : float or str
        The input without and with the fix, SI, or the names of what is chosen.
    exact : float or None
        What it had to be at least, or at most; None of what is chosen.
    standard : bool
        Whether it is a standard size.
    status : FixStatus
        `not_enough` where no value in range makes the check pass: then the best; `not_monotone`
        where there are several stretches that do: then the nearest.
    verdict : str
        Of the whole design with the fix.
    side_effects : tuple of SideEffect
        Other checks that change.
    beside : mapping
        Other inputs that are chosen with it, SI, by their paths.
    """

    code: str
    variable: str
    before: float | str
    after: float | str
    exact: float | None
    standard: bool
    status: FixStatus
    verdict: str
    side_effects: tuple[SideEffect, ...]
    beside: Mapping[str, float] = field(default_factory=dict)

    @property
    def change(self) -> float | None:
        """Relative change of the input; None of what is chosen, or was 0, or changes its sign."""
        if isinstance(self.after, str) or isinstance(self.before, str) or self.exact is None:
            return None
        return self.after / self.before - 1 if self.after * self.before > 0 else None

    @property
    def extent(self) -> float:
        """How much it changes, as the logarithm of the ratio; 0 of what is chosen, or of no such
        ratio.
        """
        return abs(math.log1p(self.change or 0.0))


def aim(check: Check) -> float:
    """Torque reserve that a fix of a check aims at.

    Parameters
    ----------
    check : Check
        The check.
    """
    return 1.0 if check.warning else MARGIN


def beyond(check: Check) -> float:
    """How far a check is beyond what a fix aims at.

    Parameters
    ----------
    check : Check
        The check.

    Returns
    -------
    float
        >= 0 where it is met.

    Raises
    ------
    NotKnown
        If it could not be made.
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
    """An input that is to cure a check, and how the design is judged with it.

    Attributes
    ----------
    code : str
        The check.
    variable : str
        The input's path.
    before : float
        Its value, SI, > 0.
    whole_list : callable
        All checks with another value of it.
    current : Verdict
        All checks without.
    standard : tuple of float
        Its standard sizes, SI, where there are any.
    """

    code: str
    variable: str
    before: float
    whole_list: Callable[[float], Verdict]
    current: Verdict
    standard: tuple[float, ...] = ()

    def by(self, exact: float, found: Solution, status: FixStatus) -> Fix:
        """The fix by a value, with its rounding and its side effects."""
        sizes = [] if self.variable in WHOLE or status == "not_enough" else self._sizes(exact)
        within = (
            (size, is_standard)
            for size, is_standard in sizes
            if any(start <= size <= end for start, end in found.intervals)
        )
        after, standard, verdict = self._made([*within, (exact, False)])
        if verdict.unforced and not self.current.unforced:  # which cannot be put together
            raise NoFix
        effects = side_effects(code=self.code, current=self.current, found=verdict)
        outcome = verdict.verdict
        return Fix(
            self.code, self.variable, self.before, after, exact, standard, status, outcome, effects
        )

    def _sizes(self, exact: float) -> list[tuple[float, bool]]:
        """Rounded sizes on the safe side of an exact one, the best first, and whether standard."""
        up = exact >= self.before
        beyond_it = [each for each in self.standard if (each >= exact if up else each <= exact)]
        sizes = [((min if up else max)(beyond_it), True)] if beyond_it else []
        unit = UNITS.get(self.variable, 1.0)
        step = 10.0 ** (2 - math.floor(math.log10(exact / unit)))
        rounded = (math.ceil if up else math.floor)(exact / unit * step)
        return [*sizes, (rounded / step * unit, False)]

    def _made(self, sizes: list[tuple[float, bool]]) -> tuple[float, bool, Verdict]:
        """The first size that makes a design, whether it is a standard one, and the verdict."""
        (size, standard), *others = sizes
        try:
            return size, standard, self.whole_list(size)
        except CalculationError:  # as where a pin is as thick as its sleeve
            if not others:
                raise
            return self._made(others)


def fix_of(*, cure: Cure, change: Change) -> Fix:
    """An input solved so that a check passes.

    Parameters
    ----------
    cure : Cure
        The input and the check.
    change : callable
        The check with another value of the input.

    Raises
    ------
    NoFix
        If the check cannot be made at any value, or is best as it is.
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
    """What the fix of a check does to the others.

    Parameters
    ----------
    code : str
        The check.
    current, found : Verdict
        All checks without and with the fix.
    """
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
    """Fixes by the verdict that they lead to, then by how little they change.

    Parameters
    ----------
    fixes : iterable of Fix
        The fixes.
    """
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
