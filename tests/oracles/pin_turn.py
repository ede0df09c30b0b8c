"""Loads of a pin over the turn, the slow way: scanned closely, then narrowed at 64 bits.

Nothing is shared with ``core``: every pair by its own cosine over a whole turn, the law of the
forces as printed, no support function. What is narrowed is a grid in all variables at once, which
is halved, or doubled where the best lies at its edge.
"""

from collections.abc import Callable, Sequence
from itertools import pairwise, product
from typing import Any

import numpy as np
from mpmath import mp, mpf

from tests.oracles.crank_planetary import breaks, phases

NEAR = 1e-3
"""How far below the largest, as a part of it, a sample may be that lies beside the largest."""

STARTS = 12
"""Most places from which the worst cycle is narrowed."""

PART = np.unique(
    np.concatenate(((1 - np.cos(np.linspace(0, np.pi, 30))) / 2, 10 ** np.linspace(-14, -0.4, 70)))
)
WAY = np.unique(np.concatenate((PART, 1 - PART))).astype(np.longdouble)
"""Where a segment is looked at, as parts of the way."""

AGAIN = 1e-2
"""What part of the first windows the highest is narrowed in anew."""

DIRECTIONS = 720
"""Directions in which a cycle is looked at first: at the corner of a criterion its utilisation may
be largest within a narrow range.
"""

GRID = np.linspace(-1, 1, 9).astype(np.longdouble)

Array = Any


def long(value: mpf) -> np.longdouble:
    """Next to the nearest number of 64 bits: the nearest double and the rest."""
    near = float(value)
    return np.longdouble(near) + np.longdouble(float(value - near))


def odd(k: int) -> int:
    return -1 if k % 2 else 1


class Turn:
    """Forces of the satellites on pin 1 over F0, tangential + i*radial."""

    def __init__(self, pins: int, crank_angles: Sequence[mpf], exponent: mpf) -> None:
        rows = phases(pins, crank_angles)
        own = [row[0] for row in rows]
        self.exponent = long(exponent)
        self.segments = []
        for start, stop in pairwise(breaks([t for row in rows for t in row], 2 * mp.pi)):
            driving = [t for row in rows for t in row if mp.sin((start + stop) / 2 + t) < 0]
            drives = np.array([mp.sin((start + stop) / 2 + t) < 0 for t in own])
            angles = [self.angles(start, stop, of) for of in (driving, own)]
            self.segments.append((long(stop - start), *angles, drives))

    @staticmethod
    def angles(start: mpf, stop: mpf, phases: list[mpf]) -> tuple[Array, Array]:
        """Angles at the start beyond whole half turns, and the sign of these: exact at switches."""
        turns = [int(mp.nint((start + t) / mp.pi)) for t in phases]
        beyond = [start + t - k * mp.pi for t, k in zip(phases, turns, strict=True)]
        beyond = [
            min(
                (mpf(0), start - stop, each),
                key=lambda x: abs(x - each) + (x is each) * mpf("1e-30"),
            )
            for each in beyond
        ]
        return np.array([long(x) for x in beyond]), np.array([odd(k) for k in turns])

    def forces(self, part: int, way: Array) -> Array:
        """Shape (K, n)."""
        width, (all_angles, all_signs), (angles, signs), drives = self.segments[part]
        v = self.exponent
        moved = width * way
        cosines = np.maximum(-all_signs[:, None] * np.sin(all_angles[:, None] + moved), 0)
        best = cosines.max(axis=0)
        total = ((cosines / best) ** v * cosines).sum(axis=0)
        turned = angles[:, None] + moved
        cosine, sine = -signs[:, None] * np.sin(turned), signs[:, None] * np.cos(turned)
        force = (np.maximum(cosine, 0) / best) ** v / total
        return np.where(drives[:, None], force, 0) * (cosine + 1j * sine)


Grids = Sequence[Array]


def narrowed(
    value: Callable[[Grids], tuple[Any, Sequence[int]]],
    place: list[Any],
    within: list[tuple[Any, Any]],
    window: list[Any],
) -> Any:
    """Largest value near a place; `value` gives that of a grid, and where on it."""
    best = -np.inf
    for _ in range(400):
        grids = [
            np.clip(at + around * GRID, *ends) if around else np.array([at])
            for at, ends, around in zip(place, within, window, strict=True)
        ]
        found, index = value(grids)
        best = max(best, found)
        for k, (grid, i) in enumerate(zip(grids, index, strict=True)):
            place[k] = grid[i]
            edge = i in (0, len(grid) - 1) and place[k] not in within[k]
            window[k] = window[k] * 2 if edge else window[k] / 2
        if max(window) < 1e-17:
            break
    return best


def largest(turn: Turn, value: Callable[[Array, Array], Array], sections: Array) -> Any:
    """Largest measure: of forces (K, n) at sections (m,), shape (m, n)."""
    looked = [value(turn.forces(part, WAY), sections) for part in range(len(turn.segments))]
    highest = max(values.max() for values in looked)
    found = []
    for part, values in enumerate(looked):
        for section in np.flatnonzero(values.max(axis=1) >= highest * (1 - NEAR)):
            node = int(values[section].argmax())

            def of(grids: Grids, part: int = part) -> tuple[Any, Sequence[int]]:
                x, way = grids
                values = value(turn.forces(part, way), x)
                index = np.unravel_index(int(values.argmax()), values.shape)
                return values[index], index  # type: ignore[return-value]

            x, ends, around = beside(sections, section)
            place, within = [x, WAY[node]], [ends, (0, 1)]
            found.append(narrowed(of, place, within, [around, gap(node)]))
    return max(found)


def gap(node: int) -> Any:
    """Distance of the farther neighbour."""
    low, high = max(node - 1, 0), min(node + 1, len(WAY) - 1)
    return max(WAY[high] - WAY[node], WAY[node] - WAY[low])


def beside(sections: Array, index: int) -> tuple[Any, tuple[Any, Any], Any]:
    """A section, those beside it, and how far these are."""
    low, high = sections[max(index - 1, 0)], sections[min(index + 1, len(sections) - 1)]
    return sections[index], (low, high), high - low


def worst_cycle(
    turn: Turn,
    arms: Callable[[Array], Array],
    sections: Array,
    used: Callable[[Array, Array], Array],
) -> Any:
    """Largest utilisation of any section in any direction by the largest and least moment."""
    forces = np.concatenate([turn.forces(part, WAY) for part in range(len(turn.segments))], axis=1)
    size = len(WAY)
    chi = np.linspace(0, 2 * np.pi, DIRECTIONS + 1)[:-1]
    looked = []
    for index, locus in enumerate(arms(sections).T @ forces):
        along = np.cos(chi)[:, None] * locus.real + np.sin(chi)[:, None] * locus.imag
        use = used(along.max(axis=1), along.min(axis=1))
        for k in np.flatnonzero((use >= np.roll(use, 1)) & (use >= np.roll(use, -1))):
            around = (k - 1) % len(chi), k, (k + 1) % len(chi)
            upper, lower = (
                {int(of[i]) for i in around} for of in (along.argmax(1), along.argmin(1))
            )
            looked += [(use[k], index, k, ends) for ends in product(upper, lower)]
    highest = max(each[0] for each in looked)
    found, seen = [], set()
    for use, index, k, ends in sorted(looked, reverse=True):
        parts = [end // size for end in ends]
        key = (*parts, 18 * k // DIRECTIONS)
        if use < highest * (1 - 4 * NEAR) or key in seen or len(seen) >= STARTS:
            continue
        seen.add(key)

        def value(grids: Grids, parts: list[int] = parts) -> tuple[Any, Sequence[int]]:
            chi, x, *ways = grids
            top, bottom = (
                np.multiply.outer(np.cos(chi), moment.real)
                + np.multiply.outer(np.sin(chi), moment.imag)
                for moment in (
                    arms(x).T @ turn.forces(part, way)
                    for part, way in zip(parts, ways, strict=True)
                )
            )
            use = used(top.max(axis=-1), bottom.min(axis=-1))
            i, j = np.unravel_index(int(use.argmax()), use.shape)
            return use[i, j], (int(i), int(j), int(top[i, j].argmax()), int(bottom[i, j].argmin()))

        x, between, around = beside(sections, index)
        nodes = [end % size for end in ends]
        place = [np.longdouble(chi[k]), x, *(WAY[node] for node in nodes)]
        window = [np.longdouble(0.1), around, *(2 * gap(node) for node in nodes)]
        within = [(-9, 9), between, (0, 1), (0, 1)]
        best = narrowed(value, place, within, [*window])
        found.append((best, value, place, within, window))
    return _again(*max(found, key=lambda each: each[0]))


def _again(
    best: Any,
    value: Callable[[Grids], tuple[Any, Sequence[int]]],
    place: list[Any],
    within: list[tuple[Any, Any]],
    window: list[Any],
) -> Any:
    """The highest narrowed anew from where it ended until that gains nothing: on a ridge between
    two variables a grid may close in too early.
    """
    while True:
        higher = narrowed(value, place, within, [each * AGAIN for each in window])
        if not higher > best:
            return best
        best = higher
