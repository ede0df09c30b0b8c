"""Deflection of the precessional gear's input shaft at its two bearings."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

from core.arrays import Vector
from core.precession.shaft import (
    Plane,
    ShaftSection,
    bearing_reactions,
    bending_stiffness,
    shaft_pieces,
    shaft_stretches,
)
from core.results import ROUNDING, Accuracy, Notice

SHORT_SHAFT = 3.3
"""Length over largest diameter below which shear adds more than 5 % to a deflection."""

LARGE_DEFLECTION = 0.1
"""Deflection over length above which the small-deflection beam is off by about 1 %."""


@dataclass(frozen=True, slots=True)
class Deflection:
    """Deflection of a place on the shaft.

    Attributes
    ----------
    x, y : float
        In the two planes, m.
    total : float
        ``sqrt(x^2 + y^2)``, m.
    """

    x: float
    y: float
    total: float


@dataclass(frozen=True, slots=True)
class ShaftDeflection:
    """Reactions and deflection of the shaft.

    Attributes
    ----------
    reaction_B, reaction_C : tuple of float, shape (2,)
        Reactions (x, y) of the shaft on the satellite, N.
    deflection_B, deflection_C : Deflection
        Deflection of the shaft at B and C, in the direction of the satellite's forces on it.
    simplified_deflection_B, simplified_deflection_C : Deflection or None
        The same with the smallest diameter everywhere; None for a shaft of one diameter.
    simplification_error_B, simplification_error_C : float or None
        Relative error of those, dimensionless.
    accuracy : Accuracy
        Of the deflections over their own size.
    notices : tuple of Notice
        Assumptions that the shaft strains.
    """

    reaction_B: Plane
    reaction_C: Plane
    deflection_B: Deflection
    deflection_C: Deflection
    simplified_deflection_B: Deflection | None
    simplified_deflection_C: Deflection | None
    simplification_error_B: float | None
    simplification_error_C: float | None
    accuracy: Accuracy
    notices: tuple[Notice, ...]


@dataclass(frozen=True, slots=True)
class _Influence:
    """Deflection at one place per force at another, m/N, and the stretches behind them."""

    at_c_by_c: float
    at_c_by_b: float
    at_b_by_b: float

    def deflections(self, reaction_b: Plane, reaction_c: Plane) -> tuple[Deflection, Deflection]:
        """Deflections of B and C under the satellite's forces, opposite to the reactions."""
        loads = list(zip(reaction_b, reaction_c, strict=True))
        at_b = [-b * self.at_b_by_b - c * self.at_c_by_b for b, c in loads]
        at_c = [-b * self.at_c_by_b - c * self.at_c_by_c for b, c in loads]
        return _deflection(*at_b), _deflection(*at_c)


def shaft_deflection(
    *,
    force: Vector,
    moment: Vector,
    bearing_distance: float,
    overhang: float,
    youngs_modulus: float,
    shaft_diameter: float | None = None,
    shaft_sections: Sequence[ShaftSection] | None = None,
    force_error: float = 0.0,
    moment_error: float = 0.0,
) -> ShaftDeflection:
    """Reactions, and the deflections of the shaft at B and C by Mohr's integral.

    ``y_C = P_C*f_CC + P_B*f_CB``, ``y_B = P_C*f_CB + P_B*f_BB`` with ``P = -(reaction)`` and,
    s counting from C, ``f_CC = integral s^2/(E*I) ds`` from 0 to a + b, ``f_CB = integral
    s*(s - a)/(E*I) ds`` and ``f_BB = integral (s - a)^2/(E*I) ds`` from a to a + b; for one
    diameter ``(a + b)^3/3, b^3/3 + a*b^2/2, b^3/3`` over ``E*I``.

    Parameters
    ----------
    force : tuple of float, shape (3,)
        Force F of the mesh, N.
    moment : tuple of float, shape (3,)
        Its moment about C, N*m.
    bearing_distance : float
        Distance a from C to B, m.
    overhang : float
        Distance b from B to the clamp, m.
    youngs_modulus : float
        Young's modulus E, Pa.
    shaft_diameter : float, optional
        Diameter of the shaft, m; this or `shaft_sections`.
    shaft_sections : sequence of ShaftSection, optional
        The shaft's stretches from C to the clamp; their lengths add up to a + b.
    force_error, moment_error : float
        Bounds of the error of force and moment, N and N*m, if known.

    Returns
    -------
    ShaftDeflection

    Raises
    ------
    InvalidInput
        If a size is not positive, not exactly one of diameter and sections is given, or the
        lengths of the sections do not add up.

    Notes
    -----
    Source: Khatetovsky et al. 2020, eqs (28)-(36). Errata: (33)-(36) exchange the unit loads of
    B and C, and (34) has C_x for C_y and ``(a + z2) + z2`` for ``a + z2``; as printed, Maxwell's
    reciprocity fails. P_B and P_C are the forces on the shaft; the paper takes the reactions,
    which turns the direction round.

    Examples
    --------
    >>> result = shaft_deflection(
    ...     force=(168.756146705, -337.606954169, 0.0),
    ...     moment=(-0.0316199045437, -0.0724918335263, 10.0), bearing_distance=0.03,
    ...     overhang=0.04, shaft_diameter=0.02, youngs_modulus=210e9)
    >>> [round(component, 8) for component in result.reaction_B]
    [2.41639445, -1.05399682]
    >>> result.simplified_deflection_C is None
    True
    """
    reaction_b, reaction_c = bearing_reactions(
        force=force, moment=moment, bearing_distance=bearing_distance
    )
    sections = shaft_stretches(
        bearing_distance=bearing_distance,
        overhang=overhang,
        youngs_modulus=youngs_modulus,
        shaft_diameter=shaft_diameter,
        shaft_sections=shaft_sections,
    )
    influence = _influence(sections, bearing_distance, youngs_modulus)
    at_b, at_c = influence.deflections(reaction_b, reaction_c)
    simplified: tuple[Deflection | None, Deflection | None] = (None, None)
    smallest = min(section.diameter for section in sections)
    if any(section.diameter != smallest for section in sections):
        simplified = _influence(
            [ShaftSection(bearing_distance + overhang, smallest)], bearing_distance, youngs_modulus
        ).deflections(reaction_b, reaction_c)
    error_b = moment_error / bearing_distance + ROUNDING * math.hypot(*reaction_b)
    error_c = force_error + error_b + ROUNDING * math.hypot(*reaction_c)
    error = max(
        _relative(by_b * error_b + by_c * error_c, by_b, by_c, reaction_b, reaction_c, place)
        for by_b, by_c, place in (
            (influence.at_b_by_b, influence.at_c_by_b, at_b),
            (influence.at_c_by_b, influence.at_c_by_c, at_c),
        )
    )
    length = bearing_distance + overhang
    return ShaftDeflection(
        reaction_B=reaction_b,
        reaction_C=reaction_c,
        deflection_B=at_b,
        deflection_C=at_c,
        simplified_deflection_B=simplified[0],
        simplified_deflection_C=simplified[1],
        simplification_error_B=_simplification_error(simplified[0], at_b),
        simplification_error_C=_simplification_error(simplified[1], at_c),
        accuracy=Accuracy(
            method="Mohr's integral in closed form", relative_error=error, evaluations=1
        ),
        notices=_notices(length, max(section.diameter for section in sections), at_c.total),
    )


def _deflection(x: float, y: float) -> Deflection:
    return Deflection(x=x, y=y, total=math.hypot(x, y))


def _influence(
    sections: Sequence[ShaftSection], bearing_distance: float, youngs_modulus: float
) -> _Influence:
    a = bearing_distance
    at_c_by_c, at_c_by_b, at_b_by_b = [], [], []
    for start, end, diameter in shaft_pieces(sections=sections, bearing_distance=a):
        flexibility = (end - start) / bending_stiffness(
            youngs_modulus=youngs_modulus, diameter=diameter
        )
        at_c_by_c.append(flexibility * (start * start + start * end + end * end) / 3)
        if start >= a:
            near, far = start - a, end - a
            squares = (near * near + near * far + far * far) / 3
            at_b_by_b.append(flexibility * squares)
            at_c_by_b.append(flexibility * (squares + a * (near + far) / 2))
    return _Influence(math.fsum(at_c_by_c), math.fsum(at_c_by_b), math.fsum(at_b_by_b))


def _relative(
    by_load: float,
    by_b: float,
    by_c: float,
    reaction_b: Plane,
    reaction_c: Plane,
    place: Deflection,
) -> float:
    """Relative error of a deflection: of its loads, and of rounding where its terms cancel."""
    size = by_b * math.hypot(*reaction_b) + by_c * math.hypot(*reaction_c)
    error = by_load + 16 * ROUNDING * size
    return error / place.total if place.total > error else float(error > 0)


def _simplification_error(simplified: Deflection | None, exact: Deflection) -> float | None:
    if simplified is None or exact.total == 0:
        return None
    return (simplified.total - exact.total) / exact.total


def _notices(length: float, diameter: float, deflection: float) -> tuple[Notice, ...]:
    found = []
    if length < SHORT_SHAFT * diameter:
        found.append(
            Notice(
                code="short_shaft",
                detail="The shaft is short for its diameter: shear, which the formulas leave out, "
                "adds more than 5 % to its deflection.",
                value=length / diameter,
                limit=SHORT_SHAFT,
            )
        )
    if deflection > LARGE_DEFLECTION * length:
        found.append(
            Notice(
                code="large_deflection",
                detail="The shaft bends by more than a tenth of its length: the formulas are "
                "those of small deflections.",
                value=deflection / length,
                limit=LARGE_DEFLECTION,
            )
        )
    return tuple(found)
