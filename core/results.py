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


HARDLY_KNOWN = 1e-2
"""Relative error above which a number is no guide."""


def poorly_known(accuracy: Accuracy) -> tuple[Notice, ...]:
    """Notice that hardly anything is known of a result, where its stated error says so.

    Parameters
    ----------
    accuracy : Accuracy
        Of one design.

    Returns
    -------
    tuple of Notice
        One, or none.

    Examples
    --------
    >>> poorly_known(Accuracy("closed form", 1e-15, 1))
    ()
    >>> [notice.code for notice in poorly_known(Accuracy("closed form", 0.5, 1))]
    ['hardly_known']
    """
    error = float(accuracy.relative_error)
    if error <= HARDLY_KNOWN:
        return ()
    return (
        Notice(
            code="hardly_known",
            detail="Hardly anything is known of the result: its relative error may be "
            f"{error:.2g}, because rounding of the input is magnified so much.",
            value=error,
            limit=HARDLY_KNOWN,
        ),
    )
