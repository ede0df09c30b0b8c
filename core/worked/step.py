"""A worked step: how one number of an answer follows from others; and the sheet that they fill."""

import math
import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np

from core.errors import if_known

NAMES = re.compile(r"[A-Za-z_]\w*(?!\w*\()")
"""Names of a formula, without those of its functions."""


class Amount(NamedTuple):
    """A number that stands for a name of a formula."""

    quantity: str  # name of a result or an input, as core calls it
    value: float  # in SI units


@dataclass(frozen=True, slots=True, kw_only=True)
class Step:
    """How one number follows from others, in SI units."""

    code: str  # name of a result, or of a value on the way to one
    symbol: str  # name in the formulas of later steps
    result: float  # value of what is worked out
    # Infix over the names of `values`: + - * / ^ ( ), sqrt sin cos tan asin acos atan abs min max
    # and pi; empty if the number is summed, searched, solved, counted or given.
    formula: str = ""
    values: Mapping[str, Amount] = field(default_factory=dict)  # numbers that go in, by their names
    method: str = ""  # key of `core.worked.words.NOTES`, in the place of a formula
    source: str = ""  # key of `core.worked.words.SOURCES`
    equation: str = ""  # number in the source
    erratum: str = ""  # key of `core.worked.words.ERRATA`
    note: str = ""  # key of `core.worked.words.NOTES`
    params: Mapping[str, Any] = field(default_factory=dict)  # parameters of note or method


def names_of(formula: str) -> tuple[str, ...]:
    """Names that a formula uses, each once.

    >>> names_of("F_0*cos(gamma_p)/(2*pi*F_0)")
    ('F_0', 'gamma_p')
    """
    found = dict.fromkeys(NAMES.findall(formula))
    return tuple(name for name in found if name != "pi")


class Sheet:
    """Steps in reading order: a step may use what is known, and then is known itself.

    A step has the result that `found` has by its code, of place `at` if that is an array; no step
    is added for a result that is not known.
    """

    def __init__(self, found: Any = None, at: int | None = None) -> None:
        self.found, self.at = found, at
        self.known: dict[str, Amount] = {}
        self.steps: list[Step] = []

    def take(self, symbol: str, quantity: str, value: float | None) -> None:
        """Let a symbol stand for a number, if there is one."""
        if value is not None:
            self.known[symbol] = Amount(quantity, float(value))

    def read(self, source: Any, **symbols: str) -> None:
        """Let symbols stand for fields of a record or a dictionary, by the names of these."""
        for symbol, name in symbols.items():
            value = source[name] if isinstance(source, Mapping) else getattr(source, name)
            self.take(symbol, name, value)

    def take_ratio(self, ratio: float) -> str:
        """Factor by which the wave turns faster than the crank; none of a coupling."""
        if math.isinf(ratio):
            return ""
        self.take("u", "ratio", ratio)
        return "*(1+1/u)"

    def work(self, code: str, symbol: str, formula: str, value: Any = ..., **said: Any) -> None:
        """Add a step by a formula; if it is a single name, of shafts of a coupling, by a method."""
        names = names_of(formula)
        if len(names) == 1:
            self.state(code, symbol, "of_shafts", formula, value)
        else:
            self._add(code, symbol, value, names, formula=formula, **said)

    def state(
        self, code: str, symbol: str, method: str, of: str = "", value: Any = ..., **said: Any
    ) -> None:
        """Add a step by a method, with those of the numbers that go in which are known."""
        names = [name for name in of.split() if name in self.known]
        self._add(code, symbol, value, names, method=method, **said)

    def _add(self, code: str, symbol: str, value: Any, names: Iterable[str], **said: Any) -> None:
        """Add a step once, if its result is known."""
        if value is ...:
            value = if_known(lambda: getattr(self.found, code))
            value = value if value is None or np.ndim(value) == 0 else value[self.at]
        if value is None:
            return
        values = {name: self.known[name] for name in names}
        step = Step(code=code, symbol=symbol, result=float(value), values=values, **said)
        self.known[symbol] = Amount(code, step.result)
        if step not in self.steps:
            self.steps.append(step)
