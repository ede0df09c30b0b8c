"""Displacements of a hole's and a disc's rim by the whole load, by finite elements.

Displacements ``U(rho)*cos(angle)`` along the radius and ``V(rho)*sin(angle)`` across it, plane
strain: lines of quadratic elements whose energy is least. Nothing of Michell, Kolosov or Dundurs.
"""

import math
from itertools import pairwise
from typing import Any

import numpy as np

GAUSS = np.polynomial.legendre.leggauss(4)

ERROR = 1e-7
"""Relative error with `ELEMENTS`, and with the plane held `OUT` radii away."""

ELEMENTS, OUT = 40, 6000.0
"""Elements from the rim of the hole to the circle, and in the disc; where the plane ends."""


def _stiffness(nodes: Any, youngs_modulus: float, poissons_ratio: float) -> Any:
    """Matrix of the energy over U and V at nodes, every second one in the middle of an element."""
    mu = youngs_modulus / (2 * (1 + poissons_ratio))
    lame = 2 * mu * poissons_ratio / (1 - 2 * poissons_ratio)
    matrix = np.zeros((2 * len(nodes), 2 * len(nodes)))
    for first, (low, high) in enumerate(pairwise(nodes[::2])):
        place = slice(4 * first, 4 * first + 6)
        for x, weight in zip(*GAUSS, strict=True):
            half = (high - low) / 2
            rho = low + half * (1 + x)
            shape = np.array([x * (x - 1) / 2, 1 - x * x, x * (x + 1) / 2])
            slope = np.array([x - 0.5, -2 * x, x + 0.5]) / half
            strain = np.zeros((3, 6))  # along, around, shear
            strain[0, ::2] = slope
            strain[1, ::2] = strain[1, 1::2] = shape / rho
            strain[2, ::2], strain[2, 1::2] = -shape / rho, slope - shape / rho
            law = np.diag([2 * mu, 2 * mu, mu])
            law[:2, :2] += lame
            matrix[place, place] += math.pi * weight * half * rho * strain.T @ law @ strain
    return matrix


def _mean(moved: Any, node: int) -> float:
    """Mean displacement of the circle through a node in the direction of the load."""
    return float(moved[2 * node] - moved[2 * node + 1]) / 2


def hole(youngs_modulus: float, poissons_ratio: float, far: float) -> float:
    """Radial displacement, in the direction of the load, of the rim of a hole of radius 1 under the
    pressure ``cos(angle)/pi``, less the mean displacement of a circle.
    """
    step = math.log(far) / ELEMENTS
    nodes = np.exp(step / 2 * np.arange(2 * math.ceil(math.log(OUT) / step) + 1))
    nodes[1::2] = (nodes[:-1:2] + nodes[2::2]) / 2
    matrix, load = _stiffness(nodes, youngs_modulus, poissons_ratio), np.zeros(2 * len(nodes))
    load[0] = 1.0  # the work of the pressure on a displacement cos(angle)
    moved = np.zeros(2 * len(nodes))
    moved[:-2] = np.linalg.solve(matrix[:-2, :-2], load[:-2])
    return float(moved[0]) - _mean(moved, 2 * ELEMENTS)


def disc(youngs_modulus: float, poissons_ratio: float) -> float:
    """Mean displacement of a disc of radius 1 under an even body force of size 1, which the
    pressure ``cos(angle)/pi`` on its rim holds, less the radial one of its rim.
    """
    nodes = np.linspace(0, 1, 2 * ELEMENTS + 1)
    matrix = _stiffness(nodes, youngs_modulus, poissons_ratio)
    load, size = np.zeros(2 * len(nodes)), np.zeros(len(nodes))
    for first, (low, high) in enumerate(pairwise(nodes[::2])):
        for x, weight in zip(*GAUSS, strict=True):
            half = (high - low) / 2
            shape = np.array([x * (x - 1) / 2, 1 - x * x, x * (x + 1) / 2])
            size[2 * first : 2 * first + 3] += weight * half * (low + half * (1 + x)) * shape
    load[::2], load[1::2] = size, -size  # its work, and the mean displacement
    held = [each for each in range(2 * len(nodes)) if each != 2 * (len(nodes) - 1)]
    moved = np.zeros(2 * len(nodes))
    moved[held] = np.linalg.solve(matrix[np.ix_(held, held)], load[held])
    return float(load @ moved)
