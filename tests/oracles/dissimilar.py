"""Disc in a hole of another material, without friction: the pressure as a series.

A pressure ``p_n*cos(n*theta)`` moves the rim of a disc by ``-p_n*R/(4*mu)*((k + 1)*n - (k - 1))``
and that of a hole by ``p_n*R/(4*mu)*((k + 1)*n + (k - 1))``, over ``n^2 - 1`` (Kolosov,
``k = 3 - 4*v``); both together, with Dundurs' constants, by ``A/4*p_n*(n - beta)/(n^2 - 1)``, a
uniform pressure by ``A/8*(1 + 2*beta - alpha)``. Their sum is the gap within the
contact, up to a shift of the disc.
"""

from functools import cache
from typing import Any

import numpy as np
from scipy.special import jv

TERMS = 12
"""Chebyshev polynomials of the pressure."""

WAVES = 4000
"""Harmonics times half-angle: what is left out of the series falls with this number, whatever the
width, 1e-5 with 2000, 2e-6 with 4000, 2e-7 with 8000 (against Persson, 5 to 84.5 degrees)."""

ERROR = 5e-6
"""Relative error of load and pressure."""


@cache
def _moved(half_angle: float) -> tuple[Any, Any]:
    """What each polynomial moves at each place, without beta and by beta."""
    n = np.arange(2, round(WAVES / half_angle) + 1)
    odd = 2 * np.arange(TERMS) + 1
    fourier = np.array([i * (-1) ** (i // 2) * jv(i, n * half_angle) / n for i in odd])
    waves = np.cos(np.outer(_places() * half_angle, n)) / (n**2 - 1.0)
    return (waves * n) @ fourier.T, waves @ fourier.T


def _places() -> Any:
    """Places over the half-angle at which the gap is closed."""
    return np.cos(np.pi * (np.arange(TERMS + 1) + 0.5) / (2 * (TERMS + 1)))


def contact(half_angle: float, alpha: float, beta: float) -> tuple[float, float]:
    """Load and largest pressure of a contact of that half-angle, to `ERROR`.

    Both in units of the difference of the radii over R and of 4/A = E*/2: Q/R and p; below 0 where
    no load makes the contact that wide. The pressure is ``sqrt(1 - s^2)`` times Chebyshev
    polynomials of the second kind in s, the place over the half-angle, whose Fourier coefficients
    are Bessel functions.
    """
    same, other = _moved(half_angle)
    moved = same - beta * other
    moved[:, 0] += half_angle / 8 * (1 + 2 * beta - alpha)
    shift = -np.cos(half_angle * _places())[:, None]
    weights = np.linalg.solve(np.hstack([moved, shift]), -np.ones(TERMS + 1))[:-1]
    odd, sign = 2 * np.arange(TERMS) + 1, (-1.0) ** np.arange(TERMS)
    load = np.pi * np.sum(odd * sign * jv(odd, half_angle) * weights)
    return float(load), float(np.sum(weights * sign))
