"""Life of a rolling bearing under a load that changes over the turn (ISO 281:2007)."""

from typing import Literal

from core.arrays import Number, check_positive
from core.errors import InvalidInput

Bearing = Literal["ball", "roller"]

EXPONENTS: dict[Bearing, float] = {"ball": 3.0, "roller": 10 / 3}
"""Exponent p of the life over the load."""

STATIC_SAFETY: dict[Bearing, float] = {"ball": 1.0, "roller": 1.5}
"""Static rating over the largest load, as required for usual running by catalogues of SKF and IKO
after ISO 76."""

PEAK_SAFETY = {"start": 1.5, "emergency": 1.0}
"""Static rating over the largest load, as required at the peak of a start or emergency stop."""

RELIABILITIES = {90.0: 1.0, 95.0: 0.64, 96.0: 0.55, 97.0: 0.47, 98.0: 0.37, 99.0: 0.25}
"""Factor a1 by reliability in percent, ISO 281:2007; catalogues after earlier editions have 0.62,
0.53, 0.44, 0.33 and 0.21 from 95 % on: up to a fifth less life of the same bearing."""


def rating_life(*, load: Number, rating: Number, kind: Bearing) -> Number:
    """Basic rating life ``L10 = (C/P)^p``, in millions of turns of one ring against the other.

    Equivalent load P and dynamic rating C are in N. Source: ISO 281:2007, as in Shigley, eq.
    (11-3), whose example 11-3 has a roller bearing of 91.1 kN under 10.279 kN:

    >>> round(rating_life(load=10.279, rating=91.08767, kind="roller"), 2)
    1440.0
    """
    check_positive(load=load, rating=rating)
    return (rating / load) ** EXPONENTS[kind]


def reliability_factor(*, percent: float) -> float:
    """Life factor a1 (ISO 281:2007, table 12); `InvalidInput` outside `RELIABILITIES`."""
    if percent not in RELIABILITIES:
        raise InvalidInput("reliability_percent", percent, "not_in_table", values=[*RELIABILITIES])
    return RELIABILITIES[percent]


def system_life(*, lives: Number, weibull_slope: Number) -> Number:
    """Life of several bearings until the first one fails: ``(sum L^-beta)^(-1/beta)``.

    The probabilities of survival ``exp(-(t/L)^beta*ln(1/R))`` multiply. Lives of one reliability
    have the shape (..., K), the slope beta of their distribution the shape (...). The slope has no
    default: 10/9 for balls and 9/8 for rollers are often named, but no source was at hand.

    >>> import numpy as np
    >>> round(float(system_life(lives=np.array([100.0, 100.0]), weibull_slope=1.0)), 9)
    50.0
    """
    check_positive(weibull_slope=weibull_slope)
    least = lives.min(axis=-1)
    shares = (least[..., None] / lives) ** (
        weibull_slope[..., None] if hasattr(weibull_slope, "shape") else weibull_slope
    )
    return least * shares.sum(axis=-1) ** (-1 / weibull_slope)
