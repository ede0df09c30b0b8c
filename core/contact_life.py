"""Life factor of the allowable contact pressure: its fall with the number of loads (pitting).

The curves are those of gear teeth: none is known for a pin that rolls and slides in its hole.
"""

from dataclasses import dataclass
from typing import Literal

from core.arrays import Number, check_positive, smaller, where

LifeCurve = Literal["hardened", "nitrided", "nitrocarburised"]
"""Material of a life curve: through-hardened, case-hardened and normalized steel; nitrided
steel, grey and ferritic nodular cast iron; nitrocarburised steel."""


@dataclass(frozen=True, slots=True)
class CurveOfLife:
    """Life factor over the number of loads: constant, then two lines in logarithmic scales."""

    most: float  # life factor of few loads
    knee: float  # loads at which the factor is 1 and the line bends
    before: float  # exponent of the line before the knee
    beyond: float  # exponent of the line beyond the knee


CURVES: dict[LifeCurve, CurveOfLife] = {
    "hardened": CurveOfLife(1.6, 5e7, 0.0756, 0.0306),
    "nitrided": CurveOfLife(1.3, 2e6, 0.0876, 0.0191),
    "nitrocarburised": CurveOfLife(1.1, 2e6, 0.0318, 0.0191),
}
"""Curves of ISO 6336-2, each with its largest factor up to 1e5 loads, 1 at the knee and 0.85 at
`MOST_LOADS`."""

MOST_LOADS = 1e10
"""Number of loads up to which the curves are stated."""


def life_factor(*, curve: LifeCurve, loads: Number) -> Number:
    """Life factor of the allowable pressure: ``Z_NT = (N_k/N_L)^m``, 1 at the knee N_k.

    Loads N_L > 0 beyond 1e10 continue the last line. The factors of lubricant, speed and roughness
    are taken as 1. Source: ISO 6336-2, Z_NT where no pitting is permitted, as in code that
    reproduces ISO/TR 6336-30; the exponents of the curves "nitrided" and "nitrocarburised" are
    those of lines through its points.

    5000 h at 1500 rpm and a ratio of 20.

    >>> round(life_factor(curve="hardened", loads=60*1500*(1 + 1/20)*5000), 4)
    0.9336
    """
    check_positive(loads=loads)
    line = CURVES[curve]
    share = line.knee / loads
    return smaller(where(share > 1, share**line.before, share**line.beyond), line.most)
