"""A worked step: how one number of an answer follows from others; and the sheet that they fill."""

import math
import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, NamedTuple

NAMES = re.compile(r"[A-Za-z_]\w*(?!\w*\()")
"""Names of a formula, without those of its functions."""

MOST_TERMS = 60
"""Most terms of a sum that is written out."""


class Amount(NamedTuple):
    """A number that stands for a name of a formula.

    Attributes
    ----------
    quantity : str
        What it is: a name of a result or an input, as core calls it.
    value : float
        In SI units.
    """

    quantity: str
    value: float


@dataclass(frozen=True, slots=True, kw_only=True)
class Step:
    """How one number follows from others.

    Attributes
    ----------
    code : str
        What is worked out: a result, or a key of `core.worked.words.VALUES`.
    symbol : str
        How it is called in the formulas of later steps.
    result : float
        The number, in SI units.
    formula : str
        Infix over the names of `values`: ``+ - * / ^ ( )``, ``sqrt sin cos tan asin acos atan abs
        min max`` and ``pi``; it holds in SI units. Empty where the number is searched, solved,
        counted or given.
    values : dict of str to Amount
        What its names stand for.
    method : str
        How it was got in the place of a formula, a key of `core.worked.words.NOTES`.
    source, equation : str
        Where the formula stands, a key of `core.worked.words.SOURCES`, and its number there.
    erratum : str
        What is wrong in the print, a key of `core.worked.words.ERRATA`.
    note : str
        What is to be known of it, a key of `core.worked.words.NOTES`.
    params : dict of str to object
        What the texts of note or method name: numbers by a quantity, in SI units, and codes.
    """

    code: str
    symbol: str
    result: float
    formula: str = ""
    values: Mapping[str, Amount] = field(default_factory=dict)
    method: str = ""
    source: str = ""
    equation: str = ""
    erratum: str = ""
    note: str = ""
    params: Mapping[str, Any] = field(default_factory=dict)


def names_of(formula: str) -> tuple[str, ...]:
    """Names that a formula uses, each once.

    Parameters
    ----------
    formula : str
        Of a step.

    Examples
    --------
    >>> names_of("F_0*cos(gamma_p)/(2*pi*F_0)")
    ('F_0', 'gamma_p')
    """
    found = dict.fromkeys(NAMES.findall(formula))
    return tuple(name for name in found if name != "pi")


class Sheet:
    """Steps as they follow each other: a step may use what is known, and then is known itself."""

    def __init__(self) -> None:
        self.known: dict[str, Amount] = {}
        self.steps: list[Step] = []

    def take(self, symbol: str, quantity: str, value: float | None) -> None:
        """Let a symbol of formulas stand for a number.

        Parameters
        ----------
        symbol : str
            The symbol.
        quantity : str
            What it is.
        value : float or None
            In SI units; nothing is taken where it is not there.
        """
        if value is not None:
            self.known[symbol] = Amount(quantity, float(value))

    def take_ratio(self, ratio: float) -> str:
        """Let the ratio u be known.

        Parameters
        ----------
        ratio : float
            Infinite of a coupling.

        Returns
        -------
        str
            The factor in formulas by which the wave turns faster than the crank; none of a
            coupling.
        """
        if math.isinf(ratio):
            return ""
        self.take("u", "ratio", ratio)
        return "*(1+1/u)"

    def work(self, code: str, symbol: str, result: Any, formula: str, **said: Any) -> None:
        """Add a step by a formula over what is known; none where there is no result.

        Parameters
        ----------
        code, symbol : str
            What is worked out.
        result : float or None
            The result, in SI units.
        formula : str
            Formula.
        **said
            Other fields of `Step`.
        """
        if result is None:
            return
        values = {name: self.known[name] for name in names_of(formula)}
        self._add(Step(code=code, symbol=symbol, result=float(result), formula=formula,
                       values=values, **said))  # fmt: skip

    def work_wave(self, code: str, symbol: str, result: Any, formula: str, **said: Any) -> None:
        """Add a step by a formula with the factor of `take_ratio`; of a coupling, of which there is
        none, it says that its shafts turn alike.

        Parameters
        ----------
        code, symbol : str
            What is worked out.
        result : float or None
            The result, in SI units.
        formula : str
            Formula.
        **said
            Other fields of `Step`.
        """
        if "u" in self.known:
            self.work(code, symbol, result, formula, **said)
        else:
            self.state(code, symbol, result, "of_shafts")

    def state(self, code: str, symbol: str, result: Any, method: str, **said: Any) -> None:
        """Add a step of what was searched, solved, counted or given.

        Parameters
        ----------
        code, symbol : str
            What is worked out.
        result : float or None
            The result, in SI units; no step where there is none.
        method : str
            How it was got.
        **said
            Other fields of `Step`.
        """
        if result is not None:
            self._add(Step(code=code, symbol=symbol, result=float(result), method=method, **said))

    def _add(self, step: Step) -> None:
        """A step, once: what stands before already is not worked again."""
        self.known[step.symbol] = Amount(step.code, step.result)
        if step not in self.steps:
            self.steps.append(step)


def total(term: str, *, marks: list[str]) -> str:
    """A sum written out.

    Parameters
    ----------
    term : str
        Formula of a term, with ``#`` where its mark stands.
    marks : list of str
        Mark of each term.

    Returns
    -------
    str
        In parentheses.

    Examples
    --------
    >>> total("cos(gamma_#)^2", marks=["1", "2"])
    '(cos(gamma_1)^2+cos(gamma_2)^2)'
    """
    return "(" + "+".join(term.replace("#", mark) for mark in marks) + ")"
