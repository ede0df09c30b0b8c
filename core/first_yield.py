"""First yield and shakedown of a sliding line contact: by which pressure, over the yield strength.

Hertz's pressure and its friction ``q = mu*p`` stress a half-plane in plane strain. Without friction
it yields first below the surface; from a friction of some 0.3 on at the surface, under less.
"""

import math
from functools import lru_cache

import numpy as np

from core.arrays import FloatArray

PLACES, ZOOMS, CLOSER = 25, 9, 6
"""Places along each side of the field that is searched, how often it is narrowed, and how far."""

SHAKEDOWN = 4 / math.sqrt(3)
"""Largest pressure of elastic shakedown over the yield strength, without friction: the largest
orthogonal shear, a quarter of it, is the shear yield strength ``Re/sqrt(3)``."""

SLIDING, SLIDING_SHAKEDOWN = 0.1, 2.06
"""The largest friction for which it is known, and what it is there (Johnson 1985: 3.565 times the
shear yield strength)."""


def squared_stress(
    *, poissons_ratio: float, friction: float, x: FloatArray, z: FloatArray
) -> FloatArray:
    """Square of the equivalent stress (Mises) below a sliding line contact.

    ``(1 - 2*v)^2/4*(sx + sz)^2 + 3/4*(sx - sz)^2 + 3*t^2``, as ``sy = v*(sx + sz)``.

    Parameters
    ----------
    poissons_ratio : float
        v, dimensionless.
    friction : float
        Friction coefficient mu, >= 0.
    x, z : array
        Place along the surface and depth over the half-width of the contact, z > 0.

    Returns
    -------
    array
        Over the square of the largest pressure.

    Notes
    -----
    Source: McEwen 1949, in Johnson, Contact Mechanics, (4.49) of the pressure and (7.8) of the
    friction.
    """
    inner = 1 - x**2 + z**2
    root = np.sqrt(inner**2 + 4 * x**2 * z**2)
    m, n = np.sqrt((root + inner) / 2), np.copysign(np.sqrt((root - inner) / 2), x)
    q, r = (z**2 + n**2) / (m**2 + n**2), (m**2 - z**2) / (m**2 + n**2)
    together = 2 * (z - m) + 2 * friction * (n - x)
    apart = 2 * (z - m * q) + 2 * friction * (n * (1 + r) - x)
    shear = -n * r - friction * (m * (1 + q) - 2 * z)
    squared = (0.5 - poissons_ratio) ** 2 * together**2 + 0.75 * apart**2 + 3 * shear**2
    return np.asarray(squared, np.float64)


@lru_cache(maxsize=1024)
def first_yield(*, poissons_ratio: float, friction: float = 0.0) -> float:
    """Largest pressure of a line contact at first yield over the yield strength (Mises).

    At the surface ``1/sqrt(3*mu^2 + (1 - 2*v)^2*(1 + mu^2))``; below it the largest equivalent
    stress is searched.

    Parameters
    ----------
    poissons_ratio : float
        v of the body, 0 <= v < 0.5.
    friction : float
        Friction coefficient mu of the sliding pair, >= 0.

    Returns
    -------
    float
        f, dimensionless: p0 = f*Re.

    Examples
    --------
    >>> [round(first_yield(poissons_ratio=v), 4) for v in (0.3, 0.36, 0.43)]
    [1.7937, 1.8582, 1.9063]
    >>> [round(first_yield(poissons_ratio=0.36, friction=mu), 3) for mu in (0.1, 0.3, 0.6)]
    [1.831, 1.626, 0.918]
    """
    at_surface = 3 * friction**2 + (1 - 2 * poissons_ratio) ** 2 * (1 + friction**2)
    x, z, wide, deep = 0.0, 0.8, 1.2, 0.8
    below = 0.0
    for _ in range(ZOOMS):
        across = np.linspace(x - wide, x + wide, PLACES)
        down = np.linspace(max(z - deep, 1e-9), z + deep, PLACES)
        stress = squared_stress(
            poissons_ratio=poissons_ratio,
            friction=friction,
            x=across[:, None],
            z=down[None, :],
        )
        i, j = np.unravel_index(np.argmax(stress), stress.shape)
        below, x, z = max(below, float(stress[i, j])), float(across[i]), float(down[j])
        wide, deep = wide / CLOSER, deep / CLOSER
    return 1 / math.sqrt(max(at_surface, below))


def shakedown(friction: float) -> float:
    """Largest pressure of elastic shakedown over the yield strength, with friction.

    Parameters
    ----------
    friction : float
        Friction coefficient of the pair that slides, >= 0.

    Returns
    -------
    float
        In between by a straight line; beyond, the last known one, above which it fails for certain,
        as friction only lowers it.

    Examples
    --------
    >>> [round(shakedown(mu), 3) for mu in (0.0, 0.05, 0.1, 0.5)]
    [2.309, 2.185, 2.06, 2.06]
    """
    part = min(friction / SLIDING, 1.0)
    return SHAKEDOWN + part * (SLIDING_SHAKEDOWN - SHAKEDOWN)
