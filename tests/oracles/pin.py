"""A pin as finite elements: Timoshenko's beam with evenly spread loads, at 30 digits.

Elements end where loads and supports do and in the middle of the loads; their shape functions are
the beam's own solutions, so that the nodes are exact. Nothing is shared with ``core``.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

from mpmath import mp, mpf

BAND = 4
"""Unknowns of an element."""


@dataclass(frozen=True, slots=True)
class Bent:
    """Deflection and rotation of nodes, moment and shear force to the right of them."""

    places: list[mpf]
    deflection: list[mpf]
    slope: list[mpf]
    moment: list[mpf]
    shear: list[mpf]

    def at(self, place: float) -> int:
        """Number of the node at a place."""
        return min(range(len(self.places)), key=lambda i: abs(self.places[i] - place))


def bend(
    *,
    support: str,
    diameter: float,
    contact_length: float,
    youngs_modulus: float,
    poissons_ratio: float,
    span: float | None,
    loads: Sequence[tuple[float, float]],
    looked_at: Sequence[float] = (),
) -> Bent:
    """Loads are (place, force)."""
    with mp.workdps(40):
        d, e = mpf(diameter), mpf(youngs_modulus)
        half = mpf(contact_length) / 2
        rigidity = e * mp.pi * d**4 / 64
        sheared = e / (2 * (1 + mpf(poissons_ratio))) * mp.pi * d**2 / 4 * 9 / 10
        end = max(mpf(z) + half for z, _ in loads) if span is None else mpf(span)
        ends = {mpf(0), end, *(mpf(x) for x in looked_at)}
        for z, _ in loads:
            ends |= {mpf(z) - half, mpf(z), mpf(z) + half}
        places = sorted(x for x in ends if 0 <= x <= end)
        size = 2 * len(places)
        stiffness, load = [[mpf(0)] * size for _ in range(size)], [mpf(0)] * size
        elements = []
        for i, (start, stop) in enumerate(pairwise(places)):
            length = stop - start
            middle = (start + stop) / 2
            line = sum(mpf(f) / (2 * half) for z, f in loads if abs(middle - mpf(z)) < half)
            phi = 12 * rigidity / (sheared * length**2)
            unit = rigidity / (length**3 * (1 + phi))
            a, b, c = (each * unit * length for each in (6, (4 + phi) * length, (2 - phi) * length))
            own = [
                [12 * unit, a, -12 * unit, a],
                [a, b, -a, c],
                [-12 * unit, -a, 12 * unit, -a],
                [a, c, -a, b],
            ]
            force = [line * length / 2 * each for each in (1, length / 6, 1, -length / 6)]
            elements.append((own, force))
            for row in range(4):
                load[2 * i + row] += force[row]
                for column in range(4):
                    stiffness[2 * i + row][2 * i + column] += own[row][column]
        held = {
            "cantilever": [0, 1],
            "supported": [0, size - 2],
            "fixed": [0, 1, size - 2, size - 1],
        }[support]
        free = [i for i in range(size) if i not in held]
        solved = solve([[stiffness[i][j] for j in free] for i in free], [load[i] for i in free])
        moved = [mpf(0)] * size
        for i, value in zip(free, solved, strict=True):
            moved[i] = value

        def ends(i: int) -> list[mpf]:
            """Forces of an element on its nodes."""
            own, force = elements[i]
            return [
                mp.fdot(row, moved[2 * i : 2 * i + 4]) - each
                for row, each in zip(own, force, strict=True)
            ]

        forces = [ends(i) for i in range(len(elements))]
        last = forces[-1]
        return Bent(
            places,
            moved[::2],
            moved[1::2],
            [*(-each[1] for each in forces), last[3]],
            [*(-each[0] for each in forces), last[2]],
        )


def solve(stiffness: list[list[mpf]], load: list[mpf]) -> list[mpf]:
    """Elimination without a search for pivots: the matrix is definite, and a band."""
    size = len(load)
    for i in range(size):
        for j in range(i + 1, min(i + BAND, size)):
            factor = stiffness[j][i] / stiffness[i][i]
            load[j] -= factor * load[i]
            for k in range(i, min(i + BAND, size)):
                stiffness[j][k] -= factor * stiffness[i][k]
    for i in reversed(range(size)):
        after = range(i + 1, min(i + BAND, size))
        load[i] = (load[i] - sum(stiffness[i][k] * load[k] for k in after)) / stiffness[i][i]
    return load
