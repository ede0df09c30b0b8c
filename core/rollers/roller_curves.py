"""Swinging rollers in dimensionless form: the curves of stiffness, non-uniformity and stress.

Lengths over the roller's diameter d, forces over ``E*d^2``. Each function takes a number or an
array for the quantity that its curve runs over.
"""

import math
from typing import Any, TypeVar

import numpy as np

from core.arrays import FloatArray

Either = TypeVar("Either", float, FloatArray)

SHEAR_FACTOR = 1.11
"""Uneven shear over a round section, the source's rounding of 10/9."""


def relative_stiffness(
    *,
    relative_length: Either,
    relative_width: float | FloatArray,
    relative_sphere: float | FloatArray,
    friction_coefficient: float | FloatArray,
    modulus_ratio: float | FloatArray,
) -> Either:
    """Relative stiffness ``c/(b*E)`` of one end of a roller over its relative length.

    With ``l = l/d, b = b/d, D = D/d`` the compliance is ``64*b*l/pi*((k*D + b)*l/4 + l^2/3 +
    b*(l + k*D + b)/4) + 4*1.11*b*(E/G)/pi*(l + b/2)``.

    Parameters
    ----------
    relative_length : float or array
        Length over diameter l/d, dimensionless.
    relative_width : float or array
        Width of a sphere over diameter b/d.
    relative_sphere : float or array
        Diameter of a sphere over diameter D/d.
    friction_coefficient : float or array
        Friction coefficient k.
    modulus_ratio : float or array
        E/G, dimensionless.

    Returns
    -------
    float or array
        Dimensionless, as `relative_length`.

    Notes
    -----
    Source: Ovsyannikov et al. 2019, eq. (10), their fig. 4.

    Examples
    --------
    >>> round(relative_stiffness(relative_length=2.0, relative_width=0.8, relative_sphere=1.5,
    ...                          friction_coefficient=0.16, modulus_ratio=210/78), 9)
    0.011424309
    """
    length: Either = relative_length
    width: Any = relative_width
    end_moment = friction_coefficient * relative_sphere + width
    bending = end_moment * length / 4 + length * length / 3 + width * (length + end_moment) / 4
    shear = 4 * SHEAR_FACTOR * modulus_ratio * (length + width / 2)
    stiffness: Either = math.pi / (width * (64 * length * bending + shear))
    return stiffness


def load_nonuniformity(*, relative_position_error: Either, rollers: int) -> Either:
    """Largest force over the mean one: ``Psi = min(n, 1 + 4*(n - 1)/n*delta)``.

    Parameters
    ----------
    relative_position_error : float or array
        delta, dimensionless, >= 0.
    rollers : int
        Either n of rollers.

    Returns
    -------
    float or array
        Dimensionless, as `relative_position_error`; n from `single_roller_limit` on.

    Notes
    -----
    Source: Ovsyannikov et al. 2019, eq. (6), their fig. 5, ended where the other rollers unload.
    """
    psi = 1 + 4 * (rollers - 1) / rollers * relative_position_error
    if isinstance(psi, float):
        return min(float(rollers), psi)
    return np.minimum(float(rollers), psi)


def single_roller_limit(*, rollers: int) -> float:
    """delta from which one roller carries everything: ``n/4``.

    Parameters
    ----------
    rollers : int
        Either n of rollers.

    Returns
    -------
    float
        Dimensionless.
    """
    return rollers / 4


def relative_stress(
    *,
    relative_length: Either,
    relative_width: float,
    relative_sphere: float,
    friction_coefficient: float,
    modulus_ratio: float,
    rollers: int,
    relative_torque: float,
    relative_radius: float,
    relative_tolerance: float,
    stress_concentration: float,
) -> Either:
    """Stress sigma/E of the most loaded roller over its relative length.

    Parameters
    ----------
    relative_length : float or array
        Length over diameter l/d, dimensionless.
    relative_width, relative_sphere : float
        Width and diameter of a sphere over the diameter, b/d and D/d.
    friction_coefficient : float
        Friction coefficient k.
    modulus_ratio : float
        E/G, dimensionless.
    rollers : int
        Either n of rollers.
    relative_torque : float
        ``T/(E*d^3)``.
    relative_radius : float
        R/d.
    relative_tolerance : float
        Position tolerance chi/d.
    stress_concentration : float
        K_sigma.

    Returns
    -------
    float or array
        Dimensionless, as `relative_length`.

    Notes
    -----
    Source: Ovsyannikov et al. 2019, eq. (13), their fig. 6, with n before the whole compliance
    (erratum) and ended where one roller carries everything, eq. (15).
    """
    stiffness = relative_width * relative_stiffness(
        relative_length=relative_length,
        relative_width=relative_width,
        relative_sphere=relative_sphere,
        friction_coefficient=friction_coefficient,
        modulus_ratio=modulus_ratio,
    )
    mean_force = relative_torque / (2 * relative_radius * rollers)
    psi = load_nonuniformity(
        relative_position_error=stiffness * (relative_tolerance / mean_force), rollers=rollers
    )
    arm = relative_length + relative_width / 2 + friction_coefficient * relative_sphere / 2
    return stress_concentration * 32 / math.pi * arm * psi * mean_force
