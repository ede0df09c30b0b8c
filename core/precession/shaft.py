"""The precessional gear's input shaft: its sections, reactions and diagrams.

The shaft is clamped at one end and free at the other, C. The satellite sits on it by two bearings:
one at C, and one at B, which is at a distance a from C and b from the clamp. Places along the shaft
count from C.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from core.arrays import FloatArray, Vector, check_positive
from core.errors import InvalidInput
from core.precision import ROUNDING

Plane = tuple[float, float]

SAME_LENGTH = 16 * ROUNDING
"""Relative difference up to which the lengths of the sections add up to the shaft's length."""


@dataclass(frozen=True, slots=True)
class ShaftSection:
    """Stretch of the shaft of one diameter."""

    length: float  # m, > 0
    diameter: float  # m, > 0


@dataclass(frozen=True, slots=True)
class ShaftDiagram:
    """Shear force, bending moment and deflection along the shaft."""

    # Places from C to the clamp, m, shape (n,); B occurs twice, before and after its load.
    position: FloatArray
    shear_force: FloatArray  # N, shape (n, 2), in both planes: sum of the satellite's forces from C
    bending_moment: FloatArray  # N*m, shape (n, 2): moment of forces between C and the place
    deflection: FloatArray  # m, shape (n, 2)


def bearing_reactions(
    *, force: Vector, moment: Vector, bearing_distance: float
) -> tuple[Plane, Plane]:
    """Reactions at B and C, N: ``B = (-M_Cy, M_Cx)/a``, ``C = -F - B``.

    The force F, N, of the mesh acts on the satellite, its moment M_C, N*m, is about C. Source:
    Khatetovsky et al. 2020, eqs (28)-(31). Erratum: the paper solves (28) as ``C_x = F_x - B_x``,
    with which the forces in x do not add up to zero.
    """
    check_positive(bearing_distance=bearing_distance)
    b = (-moment[1] / bearing_distance, moment[0] / bearing_distance)
    return b, (-force[0] - b[0], -force[1] - b[1])


def shaft_stretches(
    *,
    bearing_distance: float,
    overhang: float,
    youngs_modulus: float,
    shaft_sections: Sequence[ShaftSection],
) -> list[ShaftSection]:
    """Sections of the shaft, checked: sizes are positive, lengths add up to a + b."""
    check_positive(overhang=overhang, youngs_modulus=youngs_modulus)
    length = bearing_distance + overhang
    for index, section in enumerate(shaft_sections):
        path = f"shaft_sections[{index}]"
        check_positive(**{f"{path}.length": section.length, f"{path}.diameter": section.diameter})
    total = math.fsum(section.length for section in shaft_sections)
    if not abs(total - length) <= SAME_LENGTH * length:
        raise InvalidInput(
            "shaft_sections",
            total,
            "different_sum",
            field="bearing_distance",
            other="overhang",
            needed_length=length,
            given_length=total,
        )
    return list(shaft_sections)


class ShaftPiece(NamedTuple):
    """Stretch of the shaft of one diameter without a load inside."""

    behind_b: bool  # True if it lies between B and the clamp, False between C and B
    near: float  # nearer end, m from B for a piece behind B, else from C
    far: float  # farther end, m from the same bearing
    length: float  # m, to more digits than the difference of the ends
    diameter: float  # m
    from_b: float  # distance of the end farther from B, m from B


def shaft_pieces(
    *, sections: Sequence[ShaftSection], bearing_distance: float, overhang: float
) -> list[ShaftPiece]:
    """Sections of the shaft from C to the clamp, cut at B.

    A step behind B is counted from C or the clamp, whichever is nearer to B, to keep more digits.
    """
    a, b = bearing_distance, overhang
    lengths = [section.length for section in sections]
    from_c = [math.fsum(lengths[:i]) for i in range(len(lengths) + 1)]
    behind = [s - a if a <= b else b - math.fsum(lengths[i:]) for i, s in enumerate(from_c)]
    pieces = []
    for section, start, (near, far) in zip(sections, from_c, pairwise(behind), strict=False):
        length, diameter = section.length, section.diameter
        if near < 0:
            part = length if far <= 0 else -near
            pieces.append(ShaftPiece(False, start, start + part, part, diameter, from_b=-near))
        if far > 0:
            part = length if near >= 0 else far
            pieces.append(ShaftPiece(True, max(near, 0.0), far, part, diameter, from_b=far))
    return pieces


def bending_stiffness(*, youngs_modulus: float, diameter: float) -> float:
    """Bending stiffness ``E*I = E*pi*d^4/64`` of a round section, N*m^2."""
    return youngs_modulus * (math.pi / 64) * diameter**4


def shaft_diagram(
    *,
    force: Vector,
    moment: Vector,
    bearing_distance: float,
    overhang: float,
    youngs_modulus: float,
    shaft_sections: Sequence[ShaftSection],
    samples: int = 101,
) -> ShaftDiagram:
    """Shear force, bending moment and deflection along the shaft, for drawing.

    Parameters are as in `core.precession.shaft_deflection.shaft_deflection`; `samples` places are
    added to B and the ends of the sections.
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
    pieces = shaft_pieces(sections=sections, bearing_distance=bearing_distance, overhang=overhang)
    at_b, at_c = -np.array(reaction_b), -np.array(reaction_c)
    starts = [piece.near + (bearing_distance if piece.behind_b else 0.0) for piece in pieces]
    breaks = np.unique(starts[1:])
    regular = np.setdiff1d(np.linspace(0.0, bearing_distance + overhang, samples), breaks)
    position = np.sort(np.concatenate((regular, breaks, [bearing_distance])))
    behind = np.zeros(len(position), dtype=bool)
    behind[np.searchsorted(position, bearing_distance) + 1 :] = True
    place = position[:, None]
    deflection = np.zeros((len(position), 2))
    for piece, start in zip(pieces, starts, strict=True):
        loads = at_c + at_b if piece.behind_b else at_c
        zero = at_b * bearing_distance if piece.behind_b else 0.0
        near = np.maximum(start - place, 0.0)
        far = np.maximum(start + piece.length - place, 0.0)
        here = loads * place - zero
        deflection += (
            here * (far - near) * (far + near) / 2
            + loads * (far - near) * (far * far + far * near + near * near) / 3
        ) / bending_stiffness(youngs_modulus=youngs_modulus, diameter=piece.diameter)
    return ShaftDiagram(
        position=position,
        shear_force=at_c + behind[:, None] * at_b,
        bending_moment=at_c * place + behind[:, None] * at_b * (place - bearing_distance),
        deflection=deflection,
    )
