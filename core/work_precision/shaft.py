"""Deflection of the shaft: Mohr's integral in closed form against quadrature."""

from collections.abc import Sequence
from functools import partial
from typing import Any

import numpy as np

from core.arrays import FloatArray, Vector
from core.precession.shaft import ShaftSection, bearing_reactions
from core.precession.shaft_deflection import shaft_deflection
from core.work_precision.rules import fixed_rules, integrate
from core.work_precision.study import (
    REFERENCE_DIGITS,
    WorkPoint,
    WorkPrecision,
    measured,
)


def shaft_deflection_study(
    *,
    force: Vector,
    moment: Vector,
    bearing_distance: float,
    overhang: float,
    youngs_modulus: float,
    sections: Sequence[ShaftSection],
) -> WorkPrecision:
    """Error against run time of the deflection at C, both planes.

    Parameters
    ----------
    force, moment : tuple of float, shape (3,)
        Force of the mesh, N, and its moment about C, N*m.
    bearing_distance, overhang : float
        Distances a and b, m.
    youngs_modulus : float
        Young's modulus E, Pa.
    sections : sequence of ShaftSection
        Stretches of the shaft from C to the clamp.

    Returns
    -------
    WorkPrecision
    """
    end = bearing_distance + overhang
    ends = np.cumsum([section.length for section in sections])
    stiffness = np.array(
        [youngs_modulus * np.pi * section.diameter**4 / 64 for section in sections]
    )

    def default() -> list[float]:
        result = shaft_deflection(
            force=force,
            moment=moment,
            bearing_distance=bearing_distance,
            overhang=overhang,
            youngs_modulus=youngs_modulus,
            shaft_sections=sections,
        )
        return [result.deflection_C.x, result.deflection_C.y]

    at_b, at_c = bearing_reactions(force=force, moment=moment, bearing_distance=bearing_distance)

    def integrand(s: FloatArray) -> FloatArray:
        """Moment of both planes times that of a unit force at C, over E*I, from C at s = 0."""
        behind = np.maximum(0.0, s - bearing_distance)
        rigidity = stiffness[np.minimum(np.searchsorted(ends, s), len(stiffness) - 1)]
        return np.stack([(-at_c[i] * s - at_b[i] * behind) * s / rigidity for i in (0, 1)])

    def by_rule(nodes: FloatArray, weights: FloatArray) -> list[float]:
        deflections: list[float] = integrate(
            integrand=integrand, start=0.0, end=end, nodes=nodes, weights=weights
        ).tolist()
        return deflections

    exact = _reference(force, moment, bearing_distance, end, youngs_modulus, sections)
    points: list[WorkPoint | None] = [
        measured(
            method=f"{name}_shaft",
            setting=setting,
            calculate=partial(by_rule, nodes, weights),
            exact=exact,
            evaluations=len(nodes),
        )
        for name, setting, nodes, weights in fixed_rules()
    ]
    chosen = measured(method="closed_form", calculate=default, exact=exact, evaluations=1)
    return WorkPrecision.against("multiple_closed_form", points=[*points, chosen], chosen=chosen)


def _reference(
    force: Vector,
    moment: Vector,
    bearing_distance: float,
    end: float,
    youngs_modulus: float,
    sections: Sequence[ShaftSection],
) -> list[Any]:
    """Deflection at C in multiple precision, piece by piece of the polynomials."""
    import mpmath as mp

    with mp.workdps(REFERENCE_DIGITS):
        a = mp.mpf(bearing_distance)
        # B_x = -M_Cy/a, B_y = M_Cx/a, C = -F - B; the forces on the shaft are opposite.
        at_b = [mp.mpf(moment[1]) / a, -mp.mpf(moment[0]) / a]
        at_c = [mp.mpf(force[i]) - at_b[i] for i in (0, 1)]
        breaks, place = [], mp.mpf(0)
        for section in sections:
            breaks.append((place, place + mp.mpf(section.length), mp.mpf(section.diameter)))
            place += mp.mpf(section.length)
        deflection = []
        for i in (0, 1):
            total = mp.mpf(0)
            for start, stop, diameter in breaks:
                rigidity = mp.mpf(youngs_modulus) * mp.pi * diameter**4 / 64
                total += at_c[i] * (stop**3 - start**3) / 3 / rigidity
                low = max(start, a)
                if stop > low:
                    part = (stop**3 - low**3) / 3 - a * (stop**2 - low**2) / 2
                    total += at_b[i] * part / rigidity
            deflection.append(total)
        return deflection
