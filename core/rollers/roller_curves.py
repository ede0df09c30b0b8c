"""Curves of swinging rollers through one design: what a figure shows beside it."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from core.arrays import FloatArray
from core.rollers.roller_strength import (
    RollerStrength,
    load_nonuniformity,
    roller_strength,
    single_roller_limit,
)

SAMPLES = 121
"""Places on each curve."""


@dataclass(frozen=True, slots=True)
class RollerCurves:
    """Curves through a design.

    Attributes
    ----------
    design : RollerStrength
        The design itself.
    limit : float
        delta from which on one roller carries everything.
    length_ratio, relative_stiffness : array, shape (n,)
        l/d, and c/(b*E) over it.
    position_error : array, shape (n,)
        delta.
    nonuniformity : dict of int to array, shape (n,)
        Psi over delta by the number of rollers.
    stress : dict of float to array, shape (n,)
        Bending stress over l/d, Pa, by the position tolerance, m.
    """

    design: RollerStrength
    limit: float
    length_ratio: FloatArray
    relative_stiffness: FloatArray
    position_error: FloatArray
    nonuniformity: dict[int, FloatArray]
    stress: dict[float, FloatArray]


def roller_curves(**design: Any) -> RollerCurves:
    """Curves of stiffness, non-uniformity and stress through a design.

    Parameters
    ----------
    **design
        What `roller_strength` takes, of one design.

    Returns
    -------
    RollerCurves

    Notes
    -----
    Source: Ovsyannikov et al. 2019, their figs 4, 5 and 6, with the sizes of the design.
    """
    own = roller_strength(**design)
    rollers, diameter = design["rollers"], design["diameter"]
    ratios = np.linspace(min(0.5, own.length_ratio / 2), max(4.0, 1.5 * own.length_ratio), SAMPLES)
    limit = single_roller_limit(rollers=rollers)
    delta = own.relative_position_error
    errors = np.linspace(0.0, max(2 * limit, 1.25 * delta), SAMPLES)
    tolerance = delta * own.mean_force / own.stiffness
    tolerances = (
        [factor * tolerance for factor in (0.5, 1.0, 1.5, 2.0)]
        if tolerance > 0
        else [factor * diameter for factor in (0.0, 1e-4, 2e-4)]
    )
    by_length = design | {"cylinder_length": ratios * diameter, "gaps": None}
    curves = {
        each: roller_strength(**by_length | {"position_tolerance": each}) for each in tolerances
    }
    return RollerCurves(
        design=own,
        limit=limit,
        length_ratio=ratios,
        relative_stiffness=curves[tolerances[0]].relative_stiffness,
        position_error=errors,
        nonuniformity={
            each: load_nonuniformity(relative_position_error=errors, rollers=each)
            for each in sorted({3, 4, 6, 8, rollers})
        },
        stress={each: np.asarray(curve.bending_stress) for each, curve in curves.items()},
    )
