"""Disc in a hole of another material: the integral equation of the pressure, with many terms.

``(1 + x^2)/2*(1/pi)*PV int p'(y)/(x - y) dy + beta*p = C + (1 + beta)*Q/(pi*R)*cos(angle)``, with
``x = tan(angle/2)``; ``C = E* dR/(2*R) + (1 + alpha)/2*p_0``. Dundurs' constants are positive where
the disc is the stiffer. `tests.oracles.dissimilar` has the same contact as a series.
"""

import math
from typing import Any, NamedTuple

import numpy as np
from scipy.optimize import brentq

ERROR = 1e-10
"""Relative error."""

_TERMS = 48


class Contact(NamedTuple):
    """Over Q/R, of one half-angle."""

    half_angle: float
    stiffness: float  # C
    mean: float  # p_0, over the whole rim
    pressure: float  # in the middle

    def load_parameter(self, alpha: float) -> float:
        """``E* dR/Q``."""
        return 2 * self.stiffness - (1 + alpha) * self.mean


def of_angle(half_angle: float, beta: float) -> Contact:
    """The contact of a half-angle, which of C and p_0 has any alpha."""
    # the pressure ends as (1 - s)^(1/2), with (1 - s)^(3/2) that no number of sines has
    fine, coarse = _solved(half_angle, beta, 2 * _TERMS), _solved(half_angle, beta, _TERMS)
    return Contact(half_angle, *(fine + (fine - coarse) / 15))


def of_load(load_parameter: float, alpha: float, beta: float) -> Contact:
    """The contact under a load, up to a half-angle of a right angle."""

    def over(angle: float) -> float:
        return of_angle(angle, beta).load_parameter(alpha) - load_parameter

    narrow = 1 / math.sqrt(math.pi * load_parameter + 2.2)
    low, high = 1.2 * narrow, min(3.2 * narrow, math.pi / 2)
    return of_angle(float(brentq(over, low, high, xtol=1e-14, rtol=1e-13)), beta)


def _solved(half_angle: float, beta: float, terms: int) -> Any:
    b, odd = math.tan(half_angle / 2), np.arange(1, 2 * terms, 2)
    phi = np.pi * np.arange(1, terms + 1) / (2 * terms + 1)
    x = b * np.cos(phi)
    cosine = (1 - x * x) / (1 + x * x)
    # (1/pi) PV int p'/(x - y) dy of sin(k*phi) is k*sin(k*phi)/(b*sin(phi))
    turned = (1 + x * x) / (2 * b * np.sin(phi))
    left = np.sin(np.outer(phi, odd)) * (odd * turned[:, None] + beta)
    sides = np.linalg.solve(left, np.column_stack([np.ones(terms), (1 + beta) / np.pi * cosine]))
    place = (np.arange(4 * terms) + 0.5) * np.pi / (8 * terms)
    sines = np.sin(np.outer(place, odd)) @ sides
    y = b * np.cos(place)
    angles = np.pi / (2 * terms) * b * np.sin(place) / (1 + y * y)  # of both sides
    along = (angles * (1 - y * y) / (1 + y * y)) @ sines
    stiffness = (1 - along[1]) / along[0]
    mean = angles @ sines / (2 * np.pi) @ (stiffness, 1.0)
    middle = (-1.0) ** np.arange(terms) @ sides @ (stiffness, 1.0)
    return np.array([stiffness, mean, middle])
