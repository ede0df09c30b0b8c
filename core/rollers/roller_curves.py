"""Curves of swinging rollers through one design, as figures show them."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from core.arrays import FloatArray
from core.rollers.roller_strength import (
    GivenGaps,
    PositionTolerance,
    RollerStrength,
    Spacing,
    load_nonuniformity,
    roller_strength,
    single_roller_limit,
)

SAMPLES = 121
"""Number of points on each curve."""


@dataclass(frozen=True, slots=True)
class RollerCurves:
    """Curves of swinging rollers through a design."""

    design: RollerStrength  # results of the design itself
    limit: float  # relative position error delta above which one roller carries everything
    length_ratio: FloatArray  # l/d, shape (n,)
    relative_stiffness: FloatArray  # c/(b*E) over l/d, shape (n,)
    position_error: FloatArray  # delta, shape (n,)
    nonuniformity: dict[int, FloatArray]  # Psi over delta, by the number of rollers
    # Bending stress over l/d, Pa, by the position tolerance, m, or by a factor on the gaps.
    stress: dict[float, FloatArray]
    # True if the keys of `stress` are factors on the given gaps, which then differ.
    scales_gaps: bool


def roller_curves(**design: Any) -> RollerCurves:
    """Curves of stiffness, load-sharing factor and stress through a design (arguments of
    `roller_strength`), as figs 4, 5 and 6 of Ovsyannikov et al. 2019.
    """
    found = roller_strength(**design)
    rollers, diameter = design["rollers"], design["diameter"]
    length = found.shape.length
    ratios = np.linspace(min(0.5, length / 2), max(4.0, 1.5 * length), SAMPLES)
    limit = single_roller_limit(rollers=rollers)
    delta = found.relative_position_error
    errors = np.linspace(0.0, max(2 * limit, 1.25 * delta), SAMPLES)
    factors, scales_gaps = (0.5, 1.0, 1.5, 2.0), False
    family: dict[float, Spacing]
    match design["spacing"]:
        case GivenGaps(gaps) if delta > 0:
            scales_gaps = True
            family = {each: GivenGaps([each * gap for gap in gaps]) for each in factors}
        case PositionTolerance(tolerance) if tolerance > 0:
            family = {each * tolerance: PositionTolerance(each * tolerance) for each in factors}
        case _:
            some = [each * diameter for each in (0.0, 1e-4, 2e-4)]
            family = {each: PositionTolerance(each) for each in some}
    by_length = design | {"cylinder_length": ratios * diameter}
    curves = {each: roller_strength(**by_length | {"spacing": own}) for each, own in family.items()}
    return RollerCurves(
        design=found,
        limit=limit,
        length_ratio=ratios,
        relative_stiffness=next(iter(curves.values())).relative_stiffness,
        position_error=errors,
        nonuniformity={
            each: load_nonuniformity(relative_position_error=errors, rollers=each)
            for each in sorted({3, 4, 6, 8, rollers})
        },
        stress={each: np.asarray(curve.bending_stress) for each, curve in curves.items()},
        scales_gaps=scales_gaps,
    )
