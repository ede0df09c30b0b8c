"""Disc in a hole of another material, without friction: the pressure as a series.

A pressure ``p_n*cos(n*theta)`` moves the rim of a disc by ``-p_n*R/(4*mu)*((k + 1)*n - (k - 1))``
and that of a hole by ``p_n*R/(4*mu)*((k + 1)*n + (k - 1))``, over ``n^2 - 1`` (Kolosov,
``k = 3 - 4*v``); both together, with Dundurs' constants, positive where the disc is the stiffer, by
``A/4*p_n*(n + beta)/(n^2 - 1)``, a uniform pressure by ``A/8*(1 - 2*beta + alpha)``. Their sum is
the gap within the contact, up to a shift of the disc.
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
    """Displacement by each polynomial at each place, without beta and by beta."""
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
    weights, _ = _solved(half_angle, alpha, beta)
    sign = (-1.0) ** np.arange(TERMS)
    return float(np.pi * harmonics(half_angle, weights, 1)[0]), float(np.sum(weights * sign))


def approach(half_angle: float, alpha: float, beta: float) -> float:
    """How far the disc has moved since it touched, over the difference of the radii: by all
    harmonics but that of one wave. Times the load parameter it is known to 2*`ERROR`.
    """
    return float(_solved(half_angle, alpha, beta)[1] - 1)


def _solved(half_angle: float, alpha: float, beta: float) -> tuple[Any, Any]:
    """Polynomials of the pressure, and the shift of the disc."""
    same, other = _moved(half_angle)
    moved = same + beta * other
    moved[:, 0] += half_angle / 8 * (1 - 2 * beta + alpha)
    shift = -np.cos(half_angle * _places())[:, None]
    solved = np.linalg.solve(np.hstack([moved, shift]), -np.ones(TERMS + 1))
    return solved[:-1], solved[-1]


def harmonics(half_angle: float, weights: Any, most: int) -> Any:
    """``p_n`` of the pressure for n = 1 to `most`."""
    n, odd = np.arange(1, most + 1), 2 * np.arange(TERMS) + 1
    sign = (-1.0) ** np.arange(TERMS)
    return (jv(odd, np.outer(n, np.full(TERMS, half_angle))) * odd * sign) @ weights / n


def hoop_tension(half_angle: float, alpha: float, beta: float, poissons_ratio: float) -> float:
    """Hoop stress of the hole's rim at the ends of the contact, over the load Q/R: there
    ``2*p_0 + 2*k/(k + 1)*p_1*cos(angle)``, to `ERROR`.
    """
    weights, _ = _solved(half_angle, alpha, beta)
    k = 3 - 4 * poissons_ratio
    first = harmonics(half_angle, weights, 1)[0]
    around = weights[0] * half_angle / 2 + 2 * k / (k + 1) * first * np.cos(half_angle)
    return float(around / (np.pi * first))


def yield_factor(half_angle: float, alpha: float, beta: float, poissons_ratio: float) -> float:
    """Largest pressure over the largest stress by Mises in the plane around the hole, to 1e-3: on a
    grid of places, the stresses as a sum over the harmonics (Michell).
    """
    weights, _ = _solved(half_angle, alpha, beta)
    most = int(120 / half_angle) + 50
    p, n = harmonics(half_angle, weights, most), np.arange(1, most + 1)
    first, p, n = p[0], p[1:], n[1:]
    mean, k = weights[0] * half_angle / 4, 3 - 4 * poissons_ratio
    rho = 1 / (1 + half_angle * np.linspace(0.08, 1.6, 77))
    worst = 0.0
    for angle in half_angle * np.linspace(0, 1.1, 7):
        a = -p / (2 * (n + 1)) * rho[:, None] ** (n + 2)
        b = p / (2 * (n - 1)) * rho[:, None] ** n
        radial = -(n * (n + 1) * a + (n + 2) * (n - 1) * b) @ np.cos(n * angle) - mean * rho**2
        hoop = (n * (n + 1) * a + (n - 2) * (n - 1) * b) @ np.cos(n * angle) + mean * rho**2
        shear = (n * ((1 - n) * b - (n + 1) * a)) @ np.sin(n * angle)
        d = first * (k - 1) / (2 * (k + 1))
        radial += (-first * rho + d * (rho - rho**3)) * np.cos(angle)
        hoop += d * (rho + rho**3) * np.cos(angle)
        shear += d * (rho - rho**3) * np.sin(angle)
        worst = max(worst, float(_mises(radial, hoop, shear, poissons_ratio).max()))
    s = np.linspace(0, 1, 400)
    odd = 2 * np.arange(TERMS) + 1
    pressure = np.sin(np.outer(np.arccos(s), odd)) @ weights
    hoop = 2 * mean + 2 * k / (k + 1) * first * np.cos(half_angle * s) - pressure
    worst = max(worst, float(_mises(-pressure, hoop, 0.0, poissons_ratio).max()))
    return float(pressure[0] / worst)


def _mises(one: Any, other: Any, shear: Any, poissons_ratio: float) -> Any:
    along = poissons_ratio * (one + other)
    parts = (one - other) ** 2 + (other - along) ** 2 + (along - one) ** 2
    return np.sqrt(parts / 2 + 3 * shear**2)
