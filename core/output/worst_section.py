"""Where along a pin and around it something is largest: cells that may hold it, cut ever smaller.

The search knows how far a value may lie above those at the corners of a cell, and drops cells that
cannot hold the largest:

- Along the pin the moment is curved by the line load alone, ``M'' = F/b``.
- Of a component that is largest of all directions one at an angle a beside it is ``cos(a)``; so is
  a utilisation that is the largest of sums of such components.
"""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from core.arrays import FloatArray
from core.precision import SAME

ALONG, AROUND = 1, 8
"""Parts of each stretch of the pin, and directions, that are looked at first."""

CLOSER = 3
"""Into how many parts a cell is cut each way."""

KEPT, FEWEST = 200, 100
"""Most cells that are cut at first, and at last: more are left only where the value is flat."""

ENOUGH = 1e-9
"""How much more than the largest value found a cell may hold at last, as a part of it."""

BESIDE = 1e-3
"""How far beside the largest value a parabola is laid through, over the length of the stretch."""

ROUNDS = 24
"""How often cells are cut at most."""


class Cells(NamedTuple):
    """Sections and directions, each a corner of a cell, or its middle."""

    section: FloatArray  # distance from the carrier's face, m, shape (rows,)
    direction: FloatArray  # rad, shape (rows,)
    length: FloatArray  # of the cell along the pin, m, shape (rows,)
    angle: float  # of the cell around it, rad


class Place(NamedTuple):
    """Where a value is largest."""

    value: float  # in its own unit
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
    """The largest value of all sections, and of all directions where they count.

    Parameters
    ----------
    value : callable
        Of corners: values, and how large they may be within their cells, shape (rows,).
    near : callable
        Told the middles of the cells that are left: no other places are asked of after.
    stretches : array, shape (2, s)
        Ends of the stretches along which the value is smooth; the same twice for one section.
    directions : tuple of float
        The first one and the angle over which they are looked at, rad; 0 where none counts.
    beyond : float
        Value up to which a largest one does not count.
    enough : float
        How much more than the largest value found there may be, as a part of it.

    Returns
    -------
    Place or None
        None where there is nothing beyond. Of places that are alike the first section counts.
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
    """The place with its section where a parabola through three is largest: the value is flat.

    Parameters
    ----------
    value : callable
        As `largest_of_cells` takes it.
    found : Place
        Where the value is largest but for what is hardly seen.
    stretches : array, shape (2, s)
        Ends of the stretches along which the value is smooth, m.

    Returns
    -------
    Place
    """
    step = BESIDE * (stretches[1] - stretches[0])
    off = np.minimum(found.section - stretches[0], stretches[1] - found.section)
    for own in step[(step > 0) & (off >= step)][:1]:
        sections = found.section + own * np.array([-1.0, 0.0, 1.0])
        at = Cells(sections, np.full(3, found.direction), np.zeros(3), 0.0)
        before, top, after = value(at)[0].tolist()
        if top >= max(before, after) and (bend := 2 * top - before - after) > 0:
            return found._replace(section=found.section + own * (after - before) / (2 * bend))
    return found
