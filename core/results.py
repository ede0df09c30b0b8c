"""What every result carries besides its numbers: its accuracy, and the limits it strained."""

from dataclasses import dataclass

from core.arrays import Number

ROUNDING = 2.0**-52
"""Spacing of the doubles next to 1: the unit in which rounding errors are counted."""


@dataclass(frozen=True, slots=True)
class Accuracy:
    """How a number was got, how wrong it may be, and what it took.

    Attributes
    ----------
    method : str
        Name of the method, as an engineer would write it.
    relative_error : float or array
        Bound or honest estimate of the relative error against the exact value for the input
        as given, dimensionless: rounding, truncation and the input's own condition together.
    evaluations : int
        How many times the function behind the method was evaluated (1 for a formula).
    """

    method: str
    relative_error: Number
    evaluations: int


@dataclass(frozen=True, slots=True)
class Notice:
    """A limit of validity that the result strains; the number is given all the same.

    Attributes
    ----------
    code : str
        Stable name of the limit, for programs.
    detail : str
        What is strained and what it means, for people; ``{parameter}`` names a core parameter.
    value, limit : float
        The quantity tested and the limit it passed, dimensionless or in SI units.
    """

    code: str
    detail: str
    value: float
    limit: float
