"""Search along and around a pin for the largest value, in cells that are cut ever smaller.

The search knows a bound of the value within each cell and drops cells that cannot hold the largest
one. Along the pin the moment is curved by the line load alone, ``M'' = F/b``. At an angle a beside
the direction where a component is largest, the component and any utilisation that is a largest sum
of components have fallen to ``cos(a)``.
"""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from core.arrays import FloatArray
from core.precision import SAME

ALONG, AROUND = 1, 8
"""Number of first parts of each stretch of the pin, and of directions."""

CLOSER = 3
"""Number of parts of a cell in each direction."""

KEPT, FEWEST = 200, 100
"""Largest numbers of cells cut at first and at last; more remain only if the value is flat."""

ENOUGH = 1e-9
"""Relative amount by which a cell may still exceed the largest value found, at last."""

BESIDE = 1e-3
"""Distance of the points of a parabola beside the largest value, over the length of the stretch."""

ROUNDS = 24
"""Largest number of rounds of cutting."""


class Cells(NamedTuple):
    """Sections and directions, each a corner or the middle of a cell."""

    section: FloatArray  # distance from the carrier's face, m, shape (rows,)
    direction: FloatArray  # rad, shape (rows,)
    length: FloatArray  # length of the cell along the pin, m, shape (rows,)
    angle: float  # angle of the cell around the pin, rad


class Place(NamedTuple):
    """Place of a largest value."""

    value: float  # largest value, in its own unit
    section: float  # distance from the carrier's face, m
    direction: float  # rad


def largest_of_cells(
    *,
    value: Callable[[Cells], tuple[FloatArray, FloatArray]],
    near: Callable[[Cells], None],
    stretches: FloatArray,
    directions: tuple[float, float] = (0.0, 0.0),
    beyond: float,
    enough: float = ENOUGH,
) -> Place | None:
    """Largest value of all sections and directions, or None if no value exceeds `beyond`.

    `value` gives values at corners and their bounds within the cells, shape (rows,). `near` is told
    the middles of the cells that are left. `stretches`, shape (2, s), are the ends of smooth
    stretches of the pin, m. `directions` are the first one and the angle searched, rad, 0 for none.
    `enough` is the relative excess that may be missed. The first section counts among equal ones.
    """
    (low, high), start = stretches, np.full(stretches.shape[1], directions[0])
    angle = directions[1]
    along, turned = (ALONG if (high > low).any() else 0), (AROUND if angle else 0)
    best, found = beyond, None
    for cut in range(ROUNDS):
        long = (high - low) / max(along, 1)
        angle /= max(turned, 1)
        x = low[:, None] + long[:, None] * np.arange(along + 1)
        chi = start[:, None] + angle * np.arange(turned + 1)
        shape = len(x), along + 1, turned + 1
        section, direction, length = (
            np.broadcast_to(each, shape).ravel()
            for each in (x[..., None], chi[:, None], long[:, None, None])
        )
        values, bounds = value(Cells(section, direction, length, angle))
        top = values.max()
        if top > best:
            best = float(top)
            alike = np.flatnonzero(values >= best * (1 - SAME))
            own = alike[section[alike].argmin()]
            found = Place(best, float(section[own]), float(direction[own]))
        bounds = bounds.reshape(shape)
        for axis, parts in ((1, along), (2, turned)):
            if parts:
                ends = np.arange(parts)
                bounds = np.maximum(bounds.take(ends, axis), bounds.take(ends + 1, axis))
        kept = np.argwhere(bounds > best * (1 + enough))
        if not len(kept):
            break
        order = np.argsort(-bounds[tuple(kept.T)], kind="stable")[: max(KEPT // (cut + 1), FEWEST)]
        cell, i, k = kept[order].T
        low, start, long = x[cell, i], chi[cell, k], long[cell]
        high = low + long
        near(Cells(low + long / 2, start + angle / 2, long, angle))
        along, turned = (CLOSER if along else 0), (CLOSER if turned else 0)
    return found


def settled(
    *, value: Callable[[Cells], tuple[FloatArray, FloatArray]], found: Place, stretches: FloatArray
) -> Place:
    """Place moved to the top of a parabola through three sections, as the value is flat."""
    step = BESIDE * (stretches[1] - stretches[0])
    off = np.minimum(found.section - stretches[0], stretches[1] - found.section)
    for own in step[(step > 0) & (off >= step)][:1]:
        sections = found.section + own * np.array([-1.0, 0.0, 1.0])
        at = Cells(sections, np.full(3, found.direction), np.zeros(3), 0.0)
        before, top, after = value(at)[0].tolist()
        if top >= max(before, after) and (bend := 2 * top - before - after) > 0:
            return found._replace(section=found.section + own * (after - before) / (2 * bend))
    return found
