"""Life of a rolling bearing under a load that changes over the turn (ISO 281:2007)."""

from typing import Literal

from core.arrays import Number, check_positive
from core.errors import InvalidInput

Bearing = Literal["ball", "roller"]

EXPONENTS: dict[Bearing, float] = {"ball": 3.0, "roller": 10 / 3}
"""Exponent p of the life over the load."""

STATIC_SAFETY: dict[Bearing, float] = {"ball": 1.0, "roller": 1.5}
"""Static rating over the largest load that running as usual asks for: catalogues of SKF and IKO,
after ISO 76."""

PEAK_SAFETY = {"start": 1.5, "emergency": 1.0}
"""The same at the peak torque of a start, and of an emergency stop."""

RELIABILITIES = {90.0: 1.0, 95.0: 0.64, 96.0: 0.55, 97.0: 0.47, 98.0: 0.37, 99.0: 0.25}
"""Factor a1 by reliability, percent, of ISO 281:2007; catalogues after earlier editions have 0.62,
0.53, 0.44, 0.33 and 0.21 from 95 % on: up to a fifth less life for the same bearing."""


def rating_life(*, load: Number, rating: Number, kind: Bearing) -> Number:
    """Basic rating life ``L10 = (C/P)^p``, in millions of turns.

    Parameters
    ----------
    load : float or array
        Equivalent load P, N, > 0.
    rating : float or array
        Basic dynamic load rating C, N, > 0.
    kind : {"ball", "roller"}
        Rolling elements.

    Returns
    -------
    float or array
        Millions of turns of one ring against the other.

    Notes
    -----
    Source: ISO 281:2007, as given by Shigley, eq. (11-3).

    Examples
    --------
    A roller bearing of 91.1 kN under 10.279 kN (Shigley's example 11-3).

    >>> round(rating_life(load=10.279, rating=91.08767, kind="roller"), 2)
    1440.0
    """
    check_positive(load=load, rating=rating)
    return (rating / load) ** EXPONENTS[kind]


def reliability_factor(*, percent: float) -> float:
    """Factor a1 of the life at a reliability.

    Parameters
    ----------
    percent : float
        90, 95, 96, 97, 98 or 99.

    Returns
    -------
    float

    Notes
    -----
    Source: ISO 281:2007, table 12 to 99 %.
    """
    if percent not in RELIABILITIES:
        raise InvalidInput("reliability_percent", percent, "not_in_table", values=[*RELIABILITIES])
    return RELIABILITIES[percent]


def system_life(*, lives: Number, weibull_slope: Number) -> Number:
    """Life of several bearings together: none fails, ``(sum L^-beta)^(-1/beta)``.

    Parameters
    ----------
    lives : array, shape (..., K)
        Lives of one reliability.
    weibull_slope : float or array, shape (...)
        Slope beta of their distribution, > 0. There is no default: 10/9 of balls and 9/8 of rollers
        are often named, but no source of them was at hand.

    Returns
    -------
    array, shape (...)

    Notes
    -----
    Derived: the probabilities of survival ``exp(-(t/L)^beta*ln(1/R))`` multiply.

    Examples
    --------
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
