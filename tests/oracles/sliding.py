"""Stresses below a sliding line contact, summed over the forces of its strip (Flamant).

A force on a half-plane presses radially from where it acts; pressure ``sqrt(1 - s^2)`` and
friction ``mu`` times that are many of them. The closed forms are not used.
"""

import math
from functools import cache
from typing import Any

import numpy as np

NODES = 400
"""Forces that stand for the contact: Gauss's for the weight of its ellipse."""


@cache
def _strip() -> tuple[Any, Any]:
    """Places of the forces over the half-width, and their part of ``pi/2``, the whole pressure."""
    angles = np.arange(1, NODES + 1) * math.pi / (NODES + 1)
    return np.cos(angles), math.pi / (NODES + 1) * np.sin(angles) ** 2


def equivalent_stress(*, poissons_ratio: float, friction: float, x: float, z: float) -> float:
    """Equivalent stress (Mises) in plane strain at a place, over the largest pressure; z well
    above the distance of the forces.
    """
    places, parts = _strip()
    along, square = x - places, (x - places) ** 2 + z**2
    # a force P down and Q to the right press with 2/pi*(P*z + Q*along)/r^2 along the radius
    radial = -2 / math.pi * parts * (z + friction * along) / square
    s_x, s_z, t = (float(np.sum(radial * each / square)) for each in (along**2, z**2, along * z))
    s_y = poissons_ratio * (s_x + s_z)
    squares = (s_x - s_z) ** 2 + (s_z - s_y) ** 2 + (s_y - s_x) ** 2
    return math.sqrt(squares / 2 + 3 * t**2)


def surface_stress(*, poissons_ratio: float, friction: float, x: float) -> float:
    """Stress at the surface within the contact, under the pressure itself: along the surface, its
    own size by the pressure, and by the friction ``-2*mu*x``, as of a half-plane.
    """
    pressure = math.sqrt(1 - x**2)
    s_x, s_z, t = -pressure - 2 * friction * x, -pressure, friction * pressure
    s_y = poissons_ratio * (s_x + s_z)
    squares = (s_x - s_z) ** 2 + (s_z - s_y) ** 2 + (s_y - s_x) ** 2
    return math.sqrt(squares / 2 + 3 * t**2)


def first_yield(*, poissons_ratio: float, friction: float, step: float = 0.02) -> float:
    """Largest pressure at first yield over the yield strength, by looking everywhere, and again
    about the largest: from a depth of 0.1 on by the forces, at the surface by what acts there.
    """
    own = {"poissons_ratio": poissons_ratio, "friction": friction}
    best, place = max(
        (equivalent_stress(**own, x=x, z=z), (x, z))
        for x in np.arange(-1.2, 1.2, 5 * step)
        for z in np.arange(0.1, 1.3, 5 * step)
    )
    width = 5 * step
    for _ in range(4):
        best, place = max(
            (
                equivalent_stress(**own, x=place[0] + i * width / 5, z=z),
                (place[0] + i * width / 5, z),
            )
            for i in range(-5, 6)
            for z in (max(0.1, place[1] + j * width / 5) for j in range(-5, 6))
        )
        width /= 4
    surface = max(surface_stress(**own, x=x) for x in np.linspace(-1, 1, 20_001))
    return 1 / max(best, surface)
