"""Request of a calculation as people type it, and the exact values for its answer.

A number typed is a decimal: `typed` gives it exactly, and the exact answer is that of the decimals,
not of the doubles that stand for them in a program. So what a program loses by reading them counts
as an error of the answer.
"""

import math
import random
import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any, NamedTuple

from mpmath import mpf

Body = dict[str, Any]

GIVEN = "a count, or as given"

ELSEWHERE = (
    "/accuracy/",
    "/assumed/",
    "/counts/",
    "/fit/",
    "/largest_torque_Nm",
    "/torque_reserve",
    "/warnings/",
)
"""Numbers that other tests hold (tests/core/test_checks.py, test_room.py, tests/app/
test_assumed_api.py), by the start of a pointer."""
"""What there is to know of a number that nothing can be wrong with but the whole."""


def typed(value: float) -> mpf:
    """The decimal that was typed: the shortest that reads as this double."""
    return mpf(repr(value))


class Number(NamedTuple):
    """A number of an answer, what it should be, and the size that its stated error refers to."""

    sent: float
    exact: mpf
    size: mpf | None = None  # its own where None
    stated: float | None = None  # its own stated error, if it has one besides the answer's

    @property
    def error(self) -> float:
        """Error of an answer over its size."""
        off = abs(mpf(self.sent) - self.exact)
        return float(off / abs(self.exact if self.size is None else self.size)) if off else 0.0


Numbers = dict[str, Number]
"""Numbers of an answer by their JSON pointers."""


class Draw(random.Random):
    """Random input of practical or of extreme sizes, in decimals as people type them."""

    def __init__(self, seed: int, extreme: bool) -> None:
        super().__init__(seed)
        self.extreme = extreme

    def chance(self, probability: float) -> bool:
        return self.random() < probability

    def rounded(self, value: float) -> float:
        """A number of 2 to 4 digits, or of up to 17 where all is extreme."""
        return float(f"{value:.{self.choice((2, 3, 8, 16) if self.extreme else (1, 2, 3))}e}")

    def decimal(self, low: float, high: float) -> float:
        """Even over the range."""
        return min(max(self.rounded(self.uniform(low, high)), low), high)

    def power(self, low: float, high: float) -> float:
        """Even over the logarithm of the range."""
        value = math.exp(self.uniform(math.log(low), math.log(high)))
        return min(max(self.rounded(value), low), high)

    def size(self, low: float, high: float, decades: float = 6) -> float:
        """A usual size; where all is extreme up to so many decades off, and seldom anything."""
        if self.extreme and self.chance(0.1):
            return self.power(1e-12, 1e12)
        if self.extreme and self.chance(0.5):
            return self.power(max(low / 10**decades, 1e-12), min(high * 10**decades, 1e12))
        return self.power(low, high)

    def sign(self) -> int:
        return self.choice((-1, 1))


@dataclass(frozen=True)
class Calculation:
    """A calculation of the service.

    Attributes
    ----------
    name : str
        What people call it.
    path : str
        Its place below /api/v1/.
    request : callable
        A random body.
    numbers : callable
        Of a body and its answer: the numbers that the stated error covers.
    part : tuple of str
        Where the answer that states its error lies in what is sent.
    unbounded : dict of str to str
        Other numbers of the answer: patterns of pointers, with an asterisk for any name, and what
        is known of them.
    one_in : int
        Of how many cases of a long run one is asked, where the exact values take long.
    """

    name: str
    path: str
    request: Callable[[Draw], Body]
    numbers: Callable[[Body, Any], Numbers]
    part: tuple[str, ...] = ()
    unbounded: dict[str, str] | None = None
    one_in: int = 1

    def not_checked(self, answer: Any, numbers: Numbers) -> set[str]:
        """Numbers of the answer that nothing is said of, as patterns."""
        known = {pattern(pointer) for pointer in numbers} | set(self.unbounded or ())
        found = {pattern(pointer) for pointer in pointers(answer)} - known
        return {each for each in found if not each.startswith(ELSEWHERE)}


def pointers(answer: Any, place: str = "") -> Iterator[str]:
    """JSON pointers of all numbers."""
    if isinstance(answer, (int, float)) and not isinstance(answer, bool):
        yield place
    elif isinstance(answer, (dict, list)):
        parts = answer.items() if isinstance(answer, dict) else enumerate(answer)
        for key, value in parts:
            yield from pointers(value, f"{place}/{key}")


def pattern(pointer: str) -> str:
    """A pointer with an asterisk for each number of a list."""
    return re.sub(r"/\d+", "/*", pointer)
