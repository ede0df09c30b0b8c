"""Disc in a hole of another material, without friction: the pressure as a series.

A pressure ``p_n*cos(n*theta)`` moves the rim of a disc by ``-p_n*R/(4*mu)*((k + 1)*n - (k - 1))``
and that of a hole by ``p_n*R/(4*mu)*((k + 1)*n + (k - 1))``, over ``n^2 - 1`` (Kolosov,
``k = 3 - 4*v``); both together, with Dundurs' constants, by ``A/4*p_n*(n - beta)/(n^2 - 1)``, a
uniform pressure by ``A/8*(1 + 2*beta - alpha)``. Their sum is the gap within the
contact, up to a shift of the disc.
"""

import numpy as np
from scipy.special import jv


def contact(
    half_angle: float, alpha: float, beta: float, terms: int = 12, harmonics: int = 3000
) -> tuple[float, float]:
    """Load and largest pressure of a contact of that half-angle.

    Both in units of the difference of the radii over R and of 4/A = E*/2: Q/R and p.
    The pressure is ``sqrt(1 - s^2)`` times Chebyshev polynomials of the second kind in s, the place
    over the half-angle, whose Fourier coefficients are Bessel functions.
    """
    n = np.arange(2, harmonics + 1)
    k = np.arange(terms)
    sign = (-1.0) ** k
    s = np.cos(np.pi * (np.arange(terms + 1) + 0.5) / (2 * (terms + 1)))
    fourier = np.array([(2 * i + 1) * sign[i] * jv(2 * i + 1, n * half_angle) / n for i in k])
    moved = np.cos(np.outer(s * half_angle, n)) @ ((n - beta) / (n**2 - 1.0) * fourier).T
    moved[:, 0] += half_angle / 8 * (1 + 2 * beta - alpha)
    shift = -np.cos(half_angle * s)[:, None]
    weights = np.linalg.solve(np.hstack([moved, shift]), -np.ones(terms + 1))[:-1]
    load = np.pi * sum((2 * i + 1) * sign[i] * jv(2 * i + 1, half_angle) * weights[i] for i in k)
    return float(load), float(np.sum(weights * sign))
