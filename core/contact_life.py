"""How the limit of a contact pressure falls with the number of loads: the life factor of pitting.

Curves of teeth: for a pin that rolls and slides in its hole nothing better is known.
"""

from dataclasses import dataclass
from typing import Literal

from core.arrays import Number, check_positive, smaller, where

LifeCurve = Literal["hardened", "nitrided", "nitrocarburised"]
"""Whose curve: through- and case-hardened (and normalized) steel; nitrided steel, grey and ferritic
nodular cast iron; nitrocarburised steel."""


@dataclass(frozen=True, slots=True)
class CurveOfLife:
    """The life factor over the number of loads: level, a line in logarithms, a flatter one."""

    most: float  # life factor of few loads
    knee: float  # loads at which the factor is 1 and the line bends
    before: float  # exponent of the line before the knee
    beyond: float  # and beyond it


CURVES: dict[LifeCurve, CurveOfLife] = {
    "hardened": CurveOfLife(1.6, 5e7, 0.0756, 0.0306),
    "nitrided": CurveOfLife(1.3, 2e6, 0.0876, 0.0191),
    "nitrocarburised": CurveOfLife(1.1, 2e6, 0.0318, 0.0191),
}
"""ISO 6336-2: each through its largest factor at 1e5 loads, 1 at the knee, 0.85 at `MOST_LOADS`."""

MOST_LOADS = 1e10
"""Loads to which the curves are stated."""


def life_factor(*, curve: LifeCurve, loads: Number) -> Number:
    """Life factor of the allowable pressure: ``Z_NT = (N_k/N_L)^m``, at most that of few loads.

    Parameters
    ----------
    curve : {"hardened", "nitrided", "nitrocarburised"}
        Whose curve.
    loads : float or array
        Loads N_L over the life, > 0. Stated to 1e10; beyond, the line is carried on.

    Returns
    -------
    float or array
        Dimensionless; 1 at the knee.

    Notes
    -----
    Source: ISO 6336-2, life factor Z_NT where no pitting is permitted, as in code that reproduces
    ISO/TR 6336-30; the exponents of the latter two curves are those of lines through its points.
    Meant for teeth. The factors of lubricant, speed and roughness are taken as 1.

    Examples
    --------
    5000 h of 1500 turns a minute at a ratio of 20.

    >>> round(life_factor(curve="hardened", loads=60*1500*(1 + 1/20)*5000), 4)
    0.9336
    """
    check_positive(loads=loads)
    line = CURVES[curve]
    share = line.knee / loads
    return smaller(where(share > 1, share**line.before, share**line.beyond), line.most)
