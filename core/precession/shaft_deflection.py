"""Deflection of the precessional gear's input shaft at its two bearings."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

from core.arrays import Vector
from core.errors import Accuracy, Notice, poorly_known
from core.fields import answer
from core.precession.shaft import (
    Plane,
    ShaftSection,
    bearing_reactions,
    bending_stiffness,
    shaft_pieces,
    shaft_stretches,
)
from core.precision import ROUNDING

SHORT_SHAFT = 3.3
"""Length over largest diameter below which shear adds more than 5 % to a deflection."""

LARGE_DEFLECTION = 0.1
"""Deflection over length above which the beam theory of small deflections is off by about 1 %."""


@dataclass(frozen=True, slots=True)
class Deflection:
    """Deflection of a place on the shaft, m, or slope there, rad, in the two planes."""

    x: float = answer()
    """Component in the plane of X."""
    y: float = answer()
    """Component in the plane of Y."""
    total: float = answer()
    """Resultant of both planes."""


@dataclass(frozen=True, slots=True)
class ShaftDeflection:
    """Reactions and deflections of the shaft."""

    reaction_B: Plane = answer("N", "B", "2020, eq. 30, 31")
    """Reaction of the bearing B, X and Y."""
    reaction_C: Plane = answer("N", "C", "2020, eq. 28, 29")
    """Reaction of the bearing C, X and Y."""
    deflection_B: Deflection = answer("mm", "Δ_B", "2020, eq. 34, 36")
    """Deflection of the shaft at B."""
    deflection_C: Deflection = answer("mm", "Δ_C", "2020, eq. 33, 35")
    """Deflection of the shaft at C."""
    slope_B: Deflection = answer("mrad", "θ_B", "Mohr")
    """Slope of the shaft at B."""
    slope_C: Deflection = answer("mrad", "θ_C", "Mohr")
    """Slope of the shaft at C."""
    simplified_deflection_B: Deflection | None = answer("mm", "Δ_B", "2020, eq. 34, 36")
    """Deflection at B of a shaft with one diameter, if the shaft has steps."""
    simplified_deflection_C: Deflection | None = answer("mm", "Δ_C", "2020, eq. 33, 35")
    """Deflection at C of a shaft with one diameter, if the shaft has steps."""
    simplification_error_B: float | None = answer()
    """Simplified over exact deflection at B, less 1."""
    simplification_error_C: float | None = answer()
    """Simplified over exact deflection at C, less 1."""
    # Largest relative error of reactions, slopes and deflections, as vectors, simplified ones too.
    accuracy: Accuracy = answer()
    notices: tuple[Notice, ...] = answer()


def shaft_deflection(
    *,
    force: Vector,
    moment: Vector,
    bearing_distance: float,
    overhang: float,
    youngs_modulus: float,
    shaft_sections: Sequence[ShaftSection],
    force_error: float = 0.0,
    moment_error: float = 0.0,
) -> ShaftDeflection:
    """Reactions, and deflections of the shaft at B and C by Mohr's integral.

    The satellite presses on the shaft with P_B and P_C, opposite to the reactions. Force F and
    moment M about C of the mesh, ``M = P_B*a`` in each plane, bend the shaft at the distance s from
    C with

        P_C*s + P_B*max(s - a, 0) = F*s - M*min(s/a, 1).

    Mohr's integral takes the bending moment over E*I times s for the deflection of C, and times
    ``max(s - a, 0)`` for that of B. For one diameter ``y_C = (P_C*(a + b)^3/3 + P_B*f)/(E*I)`` and
    ``y_B = (P_C*f + P_B*b^3/3)/(E*I)`` with ``f = b^3/3 + a*b^2/2``.

    Source: Khatetovsky et al. 2020, eqs (28)-(36). Errata: (33)-(36) exchange the unit loads of B
    and C, (34) and (36) have ``(a + z2) + z2`` for ``a + z2``, and (34) has C_x for C_y; as
    printed, Maxwell's reciprocity fails. (33), (35) have the sign opposite to (34), (36). P_B and
    P_C are the forces on the shaft; the paper takes the reactions, which reverses the direction.
    Force and moment are in N and N*m, with bounds of their errors; a is the distance of the
    bearings, b that from B to the clamp, m. The lengths of the sections, from C to the clamp, add
    up to a + b.

    >>> result = shaft_deflection(
    ...     force=(168.756146705, -337.606954169, 0.0),
    ...     moment=(-0.0316199045437, -0.0724918335263, 10.0), bearing_distance=0.03,
    ...     overhang=0.04, shaft_sections=[ShaftSection(0.07, 0.02)], youngs_modulus=210e9)
    >>> [round(component, 8) for component in result.reaction_B]
    [2.41639445, -1.05399682]
    """
    reaction_b, reaction_c = bearing_reactions(
        force=force, moment=moment, bearing_distance=bearing_distance
    )
    sections = shaft_stretches(
        bearing_distance=bearing_distance,
        overhang=overhang,
        youngs_modulus=youngs_modulus,
        shaft_sections=shaft_sections,
    )
    length = bearing_distance + overhang

    def deflections(sections: Sequence[ShaftSection]) -> list[tuple[Deflection, float]]:
        return [
            _deflection(influence, force, moment, (force_error, moment_error))
            for influence in _influences(sections, bearing_distance, overhang, youngs_modulus)
        ]

    found = deflections(sections)
    at_b, at_c, turn_b, turn_c = (each for each, _ in found)
    simplified_b, simplified_c = None, None
    diameters = {section.diameter for section in sections}
    if len(diameters) > 1:
        found += deflections([ShaftSection(length, min(diameters))])[:2]
        simplified_b, simplified_c = (each for each, _ in found[4:])
    size_b, size_c = math.hypot(*reaction_b), math.hypot(*reaction_c)
    reaction_b_error = moment_error / bearing_distance + 2 * ROUNDING * size_b
    reaction_c_error = force_error + reaction_b_error + ROUNDING * size_c
    errors = [error for _, error in found]
    errors += [_relative(reaction_b_error, size_b), _relative(reaction_c_error, size_c)]
    accuracy = Accuracy("mohr", max(errors), 1)
    return ShaftDeflection(
        reaction_B=reaction_b,
        reaction_C=reaction_c,
        deflection_B=at_b,
        deflection_C=at_c,
        slope_B=turn_b,
        slope_C=turn_c,
        simplified_deflection_B=simplified_b,
        simplified_deflection_C=simplified_c,
        simplification_error_B=_simplification_error(simplified_b, at_b),
        simplification_error_C=_simplification_error(simplified_c, at_c),
        accuracy=accuracy,
        notices=_notices(length, max(diameters), at_c.total) + poorly_known(accuracy),
    )


class _Influence(NamedTuple):
    """Deflection of a place per force F, m/N, and per moment M, 1/N, with error bounds."""

    by_force: float
    by_moment: float
    by_force_error: float
    by_moment_error: float


def _influences(
    sections: Sequence[ShaftSection], a: float, b: float, youngs_modulus: float
) -> list[_Influence]:
    """Influences on the deflections and slopes at B and C: Mohr's integrals, piece by piece."""
    places: tuple[list[tuple[float, ...]], ...] = ([], [], [], [])
    for piece in shaft_pieces(sections=sections, bearing_distance=a, overhang=b):
        near, far = piece.near, piece.far
        mean, square = (near + far) / 2, (near * near + near * far + far * far) / 3
        if piece.behind_b:
            b_means = (square + a * mean, mean)
            c_means = (square + 2 * a * mean + a * a, mean + a)
            turns = (mean + a, 1.0), (mean + a, 1.0)
        else:
            b_means, c_means = (0.0, 0.0), (square, square / a)
            turns = (0.0, 0.0), (mean, mean / a)
        stiffness = bending_stiffness(youngs_modulus=youngs_modulus, diameter=piece.diameter)
        error = ROUNDING * (12 + 6 * min(a, b) / piece.from_b)
        for place, means in zip(places, (b_means, c_means, *turns), strict=True):
            force, moment = (piece.length / stiffness * mean for mean in means)
            place.append((force, moment, error * force, error * moment))
    return [_Influence(*map(math.fsum, zip(*place, strict=True))) for place in places]


def _deflection(
    influence: _Influence, force: Vector, moment: Vector, errors: tuple[float, float]
) -> tuple[Deflection, float]:
    """Deflection of a place and its relative error, from the loads and their errors."""
    x = influence.by_force * force[0] - influence.by_moment * moment[1]
    y = influence.by_force * force[1] + influence.by_moment * moment[0]
    total = math.hypot(x, y)
    sizes = (*errors, math.hypot(*force[:2]), math.hypot(*moment[:2]))
    error = math.fsum(part * size for part, size in zip(influence, sizes, strict=True))
    return Deflection(x=x, y=y, total=total), _relative(error, total)


def _relative(error: float, size: float) -> float:
    return error / size if size else float(error > 0)


def _simplification_error(simplified: Deflection | None, exact: Deflection) -> float | None:
    if simplified is None or exact.total == 0:
        return None
    return (simplified.total - exact.total) / exact.total


def _notices(length: float, diameter: float, deflection: float) -> tuple[Notice, ...]:
    found = []
    if length < SHORT_SHAFT * diameter:
        found.append(Notice("short_shaft"))
    if deflection > LARGE_DEFLECTION * length:
        found.append(Notice("large_deflection"))
    return tuple(found)
