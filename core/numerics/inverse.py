"""Input at which a result meets a target, found by sampling and bracketing.

The function may jump, have several solutions, or not exist in parts of the range (NaN). The range
is therefore sampled first. Two neighbouring samples of which one meets the target form a bracket,
which is narrowed until its ends are neighbouring doubles. Samples are made finer where the result
comes close to the target without meeting it, and up to where the result ceases to exist on its way
to the target.
"""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import groupby, pairwise
from typing import Literal, get_args

from core.errors import InvalidInput
from core.precision import ROUNDING

Sense = Literal["at_least", "at_most", "equals"]

SENSES: tuple[Sense, ...] = get_args(Sense)
Want = Literal["smallest", "largest"]
SolveStatus = Literal["solved", "always", "infeasible", "several"]

SAMPLES = 129
"""Number of places at which the range is sampled first."""

FINER = 16
"""Number of places, both ends included, in each of the two steps beside a closest approach."""

MOST_WHOLE = 1000
"""Largest number of whole numbers that are tried."""

TOLERANCE = 4 * ROUNDING
"""Relative width at which a bracket is narrow enough: 4 spacings of doubles."""


@dataclass(frozen=True, slots=True)
class Solution:
    """Inputs at which a result meets a target."""

    # `always` if the whole range meets the target, `several` if more than one stretch does.
    status: SolveStatus
    value: float | None  # smallest or largest input that meets the target, as wanted
    bracket: tuple[float, float] | None  # neighbours on both sides of the value, the lower first
    intervals: tuple[tuple[float, float], ...]  # stretches that meet the target, from and to
    # Input that comes closest and its result, if nothing meets the target.
    best: tuple[float, float] | None
    monotone: bool  # True if the sampled result only grows or only falls
    evaluations: int  # number of evaluations of the function


def solve_for(
    *,
    function: Callable[[float], float],
    low: float,
    high: float,
    target: float,
    sense: Sense = "at_least",
    want: Want = "smallest",
    integer: bool = False,
    log: bool = False,
    samples: int = SAMPLES,
) -> Solution:
    """Input at which a result meets a target.

    The result is NaN where none exists; low < high. `equals` finds where the result crosses the
    target, `want` chooses among the inputs that meet it. `integer` tries every whole number in the
    range, at most `MOST_WHOLE` of them; `log` spaces the first samples, at least 2, by a ratio, for
    which low must be > 0.

    >>> found = solve_for(function=lambda x: x*x, low=0.0, high=10.0, target=2.0)
    >>> found.value, found.monotone
    (1.4142135623730951, True)
    """
    if not low < high:
        raise InvalidInput("high", high, "larger_than", field="low", limit=low)
    if log and not low > 0:
        raise InvalidInput("low", low, "greater_than", limit=0)
    search = _Search(function, target, sense, integer)
    places = _whole(low, high) if integer else _spaced(low, high, samples, log)
    values = [each for each in map(search.excess, places) if not math.isnan(each)]
    steps = [later - earlier for earlier, later in pairwise(values)]
    monotone = all(step >= 0 for step in steps) or all(step <= 0 for step in steps)
    if not integer:
        for _ in range(0 if monotone else 3):
            places = search.finer(places)
        places = search.to_its_ends(places)
    meeting = search.crossings if sense == "equals" else search.stretches
    intervals, brackets = meeting(places)
    evaluations = len(search.known)
    if not intervals:
        return Solution("infeasible", None, None, (), search.closest, monotone, evaluations)
    wanted, side = (0, 0) if want == "smallest" else (-1, 1)
    status: SolveStatus = "several" if len(intervals) > 1 else "solved"
    if intervals == [(places[0], places[-1])]:
        status = "always"
    return Solution(
        status=status,
        value=intervals[wanted][side],
        bracket=brackets[wanted][side],
        intervals=tuple(intervals),
        best=None,
        monotone=monotone,
        evaluations=evaluations,
    )


def edge(*, inside: float, outside: float, excess: Callable[[float], float]) -> tuple[float, float]:
    """Two neighbouring places, one that meets a condition and one that does not.

    The condition is met where ``excess >= 0``, as at `inside`; at `outside` excess is negative or
    NaN. Source: Chandrupatla 1997, A new hybrid quadratic/bisection algorithm. Two changes to it: a
    side where the excess does not exist is halved, and the search ends on both sides of the edge,
    so that a jump is bracketed too.
    """
    met, unmet = inside, outside
    good, bad = excess(met), excess(unmet)
    earlier, before = met, good  # third place, for the quadratic step
    share = 0.5
    for _ in range(200):
        width = abs(unmet - met)
        if width <= TOLERANCE * max(abs(met), abs(unmet)) or width == 0.0:
            break
        smallest = TOLERANCE / 4 * max(abs(met), abs(unmet)) / width
        share = min(max(share, smallest), 1 - smallest)
        place = met + share * (unmet - met)
        if place in (met, unmet):
            break
        value = excess(place)
        if value >= 0:
            earlier, before, met, good = met, good, place, value
        else:
            earlier, before, unmet, bad = unmet, bad, place, value
        share = _step(met, good, unmet, bad, earlier, before)
    return met, unmet


def _step(
    met: float, good: float, unmet: float, bad: float, earlier: float, before: float
) -> float:
    """Share of the way from met to unmet: inverse quadratic or secant where safe, otherwise one
    half.
    """
    values = (good, bad, before)
    if any(not math.isfinite(each) for each in values) or before in (good, bad) or good == bad:
        return 0.5
    # Chandrupatla's criterion for the inverse quadratic step
    xi = (met - unmet) / (earlier - unmet) if earlier != unmet else 0.5
    phi = (good - bad) / (before - bad)
    if not (phi * phi < xi and (1 - phi) * (1 - phi) < 1 - xi):
        # The secant is as good close to a straight line.
        secant = good / (good - bad)
        return secant if 0.05 < secant < 0.95 else 0.5
    slope = good / (bad - good) * before / (bad - before)
    return slope + (earlier - met) / (unmet - met) * good / (before - good) * bad / (before - bad)


def _spaced(low: float, high: float, samples: int, log: bool) -> list[float]:
    """Places from low to high, both ends included."""
    last = samples - 1
    if log:
        ratio = math.log(high / low)
        inner = [low * math.exp(ratio * i / last) for i in range(1, last)]
    else:
        inner = [low + (high - low) * i / last for i in range(1, last)]
    return [low, *inner, high]


def _whole(low: float, high: float) -> list[float]:
    """Whole numbers from low to high; none, or more than `MOST_WHOLE`, are refused."""
    first, last = math.ceil(low), math.floor(high)
    if first > last:
        raise InvalidInput("high", high, "larger_than", field="low", limit=low)
    if last - first >= MOST_WHOLE:
        raise InvalidInput("high", high, "less_than_equal", limit=first + MOST_WHOLE - 1)
    return [float(x) for x in range(first, last + 1)]


Intervals = list[tuple[float, float]]
Brackets = list[tuple[tuple[float, float] | None, tuple[float, float] | None]]


class _Search:
    """Search for places at which a result meets a target."""

    def __init__(
        self, function: Callable[[float], float], target: float, sense: Sense, integer: bool
    ) -> None:
        self.function, self.target = function, target
        self.equals, self.integer = sense == "equals", integer
        self.sign = -1.0 if sense == "at_most" else 1.0
        self.known: dict[float, float] = {}  # excess at each place that was asked for

    def excess(self, x: float) -> float:
        """Amount by which the result is beyond the target; negative where the target is not met."""
        if x not in self.known:
            self.known[x] = self.sign * (self.function(x) - self.target)
        return self.known[x]

    def exists(self, x: float) -> float:
        """NaN where the result does not exist, otherwise 0."""
        return math.nan if math.isnan(self.excess(x)) else 0.0

    @property
    def closest(self) -> tuple[float, float] | None:
        """Place that comes closest to the target, and its result; None if no result exists."""
        existing = {x: each for x, each in self.known.items() if not math.isnan(each)}
        if not existing:
            return None
        best = min(existing, key=lambda x: abs(existing[x]))
        return best, self.target + self.sign * existing[best]

    def finer(self, places: list[float]) -> list[float]:
        """Places refined where the result comes closest to the target without crossing it."""
        added: list[float] = []
        for before, here, after in zip(places, places[1:], places[2:], strict=False):
            one, two, three = map(self.excess, (before, here, after))
            turns = abs(two) <= abs(one) and abs(two) <= abs(three) and not one == two == three
            if turns and one * three > 0 and one * two >= 0:
                added += _spaced(before, here, FINER, False)[1:-1]
                added += _spaced(here, after, FINER, False)[1:-1]
        for place in added:
            self.excess(place)
        return sorted({*places, *added})

    def to_its_ends(self, places: list[float]) -> list[float]:
        """Places refined up to where the result ceases to exist while it nears the target."""
        for side in (places, places[::-1]):
            for before, here, after in zip([math.nan, *side], side, side[1:], strict=False):
                last, value = self.known.get(before, math.nan), self.known[here]
                unmet = value != 0 if self.equals else value < 0
                if unmet and math.isnan(self.known[after]) and not abs(value) > abs(last):
                    edge(inside=here, outside=after, excess=self.exists)
        return sorted(self.known)

    def stretches(self, places: Sequence[float]) -> tuple[Intervals, Brackets]:
        """Stretches where the target is met, and the bracket of each end."""
        intervals: Intervals = []
        brackets: Brackets = []
        left: tuple[float, float] | None
        right: tuple[float, float] | None
        for met, stretch in groupby(
            range(len(places)), key=lambda index: self.excess(places[index]) >= 0
        ):
            held = [*stretch]
            if not met:
                continue
            first, last = held[0], held[-1]
            start, left, end, right = places[first], None, places[last], None
            if first > 0 and not self.integer:
                start, beyond = edge(inside=start, outside=places[first - 1], excess=self.excess)
                left = (beyond, start)
            if last + 1 < len(places) and not self.integer:
                end, beyond = edge(inside=end, outside=places[last + 1], excess=self.excess)
                right = (end, beyond)
            intervals.append((start, end))
            brackets.append((left, right))
        return intervals, brackets

    def crossings(self, places: Sequence[float]) -> tuple[Intervals, Brackets]:
        """Places where the result equals the target, as stretches of length 0, and brackets."""
        intervals: Intervals = []
        brackets: Brackets = []
        for index, place in enumerate(places):
            here = self.excess(place)
            if here == 0:
                intervals.append((place, place))
                brackets.append((None, None))
            elif index and not self.integer:
                last = places[index - 1]
                before = self.excess(last)
                if before * here < 0:
                    inside, outside = (place, last) if here > 0 else (last, place)
                    met, unmet = edge(inside=inside, outside=outside, excess=self.excess)
                    ends = (min(met, unmet), max(met, unmet))
                    intervals.append((met, met))
                    brackets.append((ends, ends))
        return intervals, brackets
