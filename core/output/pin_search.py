"""Where over the turn, along the pin and around its section a measure of the moment is largest.

All is looked at in samples first. Then every summit that may be the largest is narrowed down, in
all its variables at once: each round looks at a grid about the best place known, and the next one
at the cells beside the best of that grid. What is found are values of the measure itself, so that
none is too large, and their error is the square of the last grid's width.
"""

from collections.abc import Callable, Iterator
from itertools import product
from typing import Any, NamedTuple

import numpy as np

from core.arrays import BoolArray, FloatArray, IntArray
from core.output.pin_turn import ComplexArray, PinTurn, combine

ROUNDS = {True: 6, False: 9}
"""Most rounds by whether the forces are smooth: else a summit may be much narrower than a cell."""

APART = 3
"""Samples of one arc farther apart than this are summits of their own."""

MORE = 2
"""Rounds besides where sections are searched for too: more variables settle slower."""

MOST = 4
"""Most times as many, where the best place lies beyond what was looked at."""

SETTLED = 4e-14
"""How much lower the neighbours of the best place may be, as a part of it, for it to be the end."""

WAYS, CUTS = 16, 8
"""Cells of a round's grid on each side of the best place, over the turn and along the pin."""

FEW, MANY = 24, 144
"""Directions in which all sections are looked at, and those that may be the worst."""

STEP = 2 * np.pi / MANY
"""Angle between the latter, rad."""

NEARLY = 0.98
"""Share of the largest utilisation in few directions that a section needs to be looked at again."""

Arms = tuple[FloatArray, ...]
"""What the satellites' unit forces do to sections, each shape (rows, s, K)."""

Use = Callable[[FloatArray, FloatArray], FloatArray]
"""Utilisation by a cycle of the largest and the least moment."""


class Box:
    """Ranges of one variable about the best place known, one a row.

    Parameters
    ----------
    best, low, high : array, shape (rows,)
        The best place known, and between which it may lie.
    width : array, shape (rows,)
        How far from the best place is looked at first.
    cells : int
        Cells of the grid on each side; 0 if there is nothing to choose.
    kept : int
        Cells on each side of the best that the next round looks at.
    """

    def __init__(
        self,
        best: FloatArray,
        low: FloatArray,
        high: FloatArray,
        width: FloatArray,
        cells: int,
        kept: int = 1,
    ) -> None:
        self.best, self.low, self.high, self.width = best, low, high, width
        self.cells, self.narrower = cells, kept / max(cells, 1)
        self.after = np.maximum(np.arange(-cells, cells + 1) / max(cells, 1), 0.0)
        self.before = self.after[::-1]
        self.rows = np.arange(len(best))
        self.free = np.zeros(len(best), dtype=bool)

    def places(self) -> FloatArray:
        """The grid, shape (rows, 2*cells + 1), ascending, the best place in its middle."""
        if not self.cells:
            self.grid = self.best[:, None]
            return self.grid
        before = np.minimum(self.best - self.low, self.width)[:, None]
        after = np.minimum(self.high - self.best, self.width)[:, None]
        grid = self.best[:, None] + (after * self.after - before * self.before)
        self.grid = np.minimum(np.maximum(grid, self.low[:, None]), self.high[:, None])
        return self.grid

    def move(self, index: IntArray) -> BoolArray:
        """Go on about the best of the grid.

        Returns
        -------
        array of bool, shape (rows,)
            Whether the best is at the edge of the grid and could lie beyond.
        """
        if not self.cells:
            return self.free
        self.best = self.grid[self.rows, index]
        edge: BoolArray = (index == 0) & (self.best > self.low)
        edge |= (index == 2 * self.cells) & (self.best < self.high)
        return edge

    def narrow(self, stuck: BoolArray) -> None:
        """Narrower cells, or wider ones where a row is stuck at an edge."""
        self.width = self.width * np.where(stuck, 2.0, self.narrower)


def largest(
    *,
    turn: PinTurn,
    arms: Callable[[IntArray, FloatArray], Arms],
    measure: Callable[[Arms, ComplexArray], FloatArray],
    kinds: int,
    sections: FloatArray,
) -> tuple[FloatArray, FloatArray]:
    """The largest of each kind of measure over the turn and over all sections.

    Parameters
    ----------
    turn : PinTurn
        Forces over the turn.
    arms : callable
        Of the kinds (rows,) and sections (rows, s).
    measure : callable
        Of arms and forces (rows, K, m): the measure, shape (rows, s, m).
    kinds : int
        How many there are.
    sections : array, shape (s,)
        Sections to be looked at first, from end to end; one if there is no other.

    Returns
    -------
    values, sections : array, shape (kinds,)
    """
    count, last = len(turn.nodes), len(sections) - 1
    every = np.arange(kinds)
    forces = turn.forces.reshape(1, len(turn.forces), -1)
    own = arms(every, np.tile(sections, (kinds, 1)))
    values = measure(own, forces)
    values = values.reshape(kinds, last + 1, -1, count)
    chosen, drop = _summits(values)
    bound = values + drop / 2
    if last:
        along, drop = _summits(values.swapaxes(1, 3))
        chosen, bound = chosen & along.swapaxes(1, 3), bound + drop.swapaxes(1, 3) / 2
    chosen &= bound >= values.max(axis=(1, 2, 3), keepdims=True)
    kind, section, arc, node = np.nonzero(chosen)
    places = _places(sections, section)
    way = _ways(turn, node, node - 1, node + 1, 2 if last else 1)
    at = turn.at(turn.arcs[arc])
    own = tuple(each[kind, section, None] for each in own)
    for _ in range(ROUNDS[turn.smooth] + (MORE if last else 0)):
        here = places.places()
        if last:
            own = arms(kind, here)
        found = measure(own, at(way.places())).reshape(len(kind), -1)
        index = _better(found)
        best = found[places.rows, index]
        on_pin, on_turn = np.divmod(index, way.grid.shape[1])
        stuck = places.move(on_pin) | way.move(on_turn)
        places.narrow(stuck)
        way.narrow(stuck)
        beside = np.minimum(
            found[places.rows, np.maximum(index - 1, 0)],
            found[places.rows, np.minimum(index + 1, found.shape[1] - 1)],
        )
        settled = best - beside <= SETTLED * best
        if turn.smooth:
            settled |= (way.best == way.low) | (way.best == way.high)
        if not last and settled.all():
            break
    picked = np.array([np.flatnonzero(kind == each)[best[kind == each].argmax()] for each in every])
    return best[picked], places.best[picked]


def _places(sections: FloatArray, section: IntArray) -> Box:
    """Range of sections beside those of these numbers."""
    last = len(sections) - 1
    before, after = np.maximum(section - 1, 0), np.minimum(section + 1, last)
    low, best, high = sections[before], sections[section], sections[after]
    return Box(best, low, high, np.maximum(high - best, best - low), CUTS if last else 0)


def _summits(values: FloatArray) -> tuple[BoolArray, FloatArray]:
    """Which values are largest beside their neighbours along the last axis, and by how much."""
    before = np.concatenate((values[..., :1], values[..., :-1]), axis=-1)
    after = np.concatenate((values[..., 1:], values[..., -1:]), axis=-1)
    return (values >= before) & (values >= after), values - np.minimum(before, after)


def _ways(turn: PinTurn, node: IntArray, low: IntArray, high: IntArray, kept: int) -> Box:
    """Range of the way along arcs by numbers of samples."""
    nodes, last = turn.nodes, len(turn.nodes) - 1
    start, stop = nodes[np.maximum(low, 0)], nodes[np.minimum(high, last)]
    best = nodes[node]
    ends = np.zeros(len(best)), np.ones(len(best))
    return Box(best, *ends, np.maximum(stop - best, best - start), WAYS, kept)


def worst_cycle(
    *, turn: PinTurn, moments: Callable[[FloatArray], FloatArray], sections: FloatArray, used: Use
) -> tuple[float, float, float, float]:
    """The cycle of stress with the largest utilisation, of all directions and sections.

    A point of the section's edge in the direction chi goes from the least to the largest
    component of the moment in that direction, so that all to be searched for is the largest
    utilisation by any two places of the turn as the ends of the cycle, in any direction: it never
    falls where the upper end rises or the lower one falls.

    Parameters
    ----------
    turn : PinTurn
        Forces over the turn.
    moments : callable
        Moments at sections (...) by the satellites' unit forces, shape (..., K).
    sections : array, shape (s,)
        Sections to be looked at first, from end to end; one if there is no other.
    used : callable
        Utilisation.

    Returns
    -------
    direction, section, largest, least : float
        Direction chi, rad; section, m; moments of the ends of the cycle over F0.
    """
    last = len(sections) - 1
    weights = moments(sections)
    locus = combine(arms=weights, forces=turn.forces.reshape(len(turn.forces), -1))
    near = [0]
    if last:
        worst = _cycles(locus, FEW, used).max(axis=1)
        summit, drop = _summits(worst)
        near = np.flatnonzero(summit & (worst + drop >= NEARLY * worst.max())).tolist()
    starts = [
        (section, *start)
        for section in near
        for chi in _worst_directions(locus[section], used)
        for start in _starts(locus[section], chi, len(turn.nodes))
    ]
    best, tried = _NONE, set()
    for _ in range(MOST):
        tried |= {(start[0], start[2]) for start in starts}
        best = max(best, _climb(turn, moments, sections, used, starts))
        # in the direction found other arcs may reach farther
        again = _starts(locus[best.start], best.direction, len(turn.nodes))
        starts = [(best.start, *each) for each in again if (best.start, each[1]) not in tried]
        if not starts:
            break
    return best.direction, best.section, best.largest, best.least


class Worst(NamedTuple):
    """The largest utilisation that a climb has found; the number of the section it came from."""

    use: float
    direction: float
    section: float
    largest: float
    least: float
    start: int


_NONE = Worst(0.0, 0.0, 0.0, 0.0, 0.0, 0)


Start = tuple[int, float, tuple[int, int], tuple[tuple[int, ...], tuple[int, ...]]]
"""Number of the section, direction, arcs of both ends of the cycle, and numbers of the sample, of
the first and the last between which each may lie."""


def _climb(
    turn: PinTurn,
    moments: Callable[[FloatArray], FloatArray],
    sections: FloatArray,
    used: Use,
    starts: list[Start],
) -> Worst:
    """The largest utilisation near these starts."""
    last = len(sections) - 1
    section, chi, arcs, ends = (np.array(each) for each in zip(*starts, strict=True))
    places = _places(sections, section)
    angles = Box(chi, chi - np.pi, chi + np.pi, np.full(len(chi), STEP), WAYS, 2)
    # upper ends of the cycles, then lower ends
    ways = _ways(turn, ends[..., 0].T.ravel(), ends[..., 1].T.ravel(), ends[..., 2].T.ravel(), 2)
    at = turn.at(turn.arcs[arcs.T.ravel()])
    rows = places.rows
    weights = moments(places.places())
    rounds = ROUNDS[turn.smooth] + (MORE if last else 0)
    left = np.full(len(rows), rounds)
    for _ in range(MOST * rounds):
        here = places.places()
        if last:
            weights = moments(here)
        forces = at(ways.places())
        forces = forces.reshape(2, len(rows), *forces.shape[1:])
        moment = combine(arms=weights, forces=forces)
        around = angles.places()
        along = _along(moment[..., None, :], around[:, None, :, None])
        top, bottom = along[0].max(axis=-1), along[1].min(axis=-1)
        use = used(top, bottom).reshape(len(rows), -1)
        index = _better(use)
        best = use[rows, index]
        on_pin, on_round = np.divmod(index, around.shape[1])
        chosen = along[:, rows, on_pin, on_round]
        on_turn = np.concatenate((chosen[0].argmax(axis=-1), chosen[1].argmin(axis=-1)))
        stuck = places.move(on_pin) | angles.move(on_round)
        stuck |= ways.move(on_turn).reshape(2, -1).any(axis=0)
        left -= ~stuck
        if left.max() <= 0:
            break
        for box in (places, angles):
            box.narrow(stuck)
        ways.narrow(np.tile(stuck, 2))
    row = int(best.argmax())
    end = row, on_pin[row], on_round[row]
    place = float(angles.best[row]), float(places.best[row])
    start = int(section[row])
    return Worst(float(best[row]), *place, float(top[end]), float(bottom[end]), start)


def _better(values: FloatArray) -> IntArray:
    """Where each row is largest; in its middle if nothing is larger."""
    index = values.argmax(axis=1)
    middle = values.shape[1] // 2
    found: IntArray = np.where(values.max(axis=1) > values[:, middle], index, middle)
    return found


def _along(moment: ComplexArray, chi: Any) -> FloatArray:
    """Components of moments in directions."""
    found: FloatArray = np.cos(chi) * moment.real + np.sin(chi) * moment.imag
    return found


def _cycles(locus: ComplexArray, directions: int, used: Use) -> FloatArray:
    """Utilisation in each direction by samples; last axis."""
    chi = 2 * np.pi * np.arange(directions) / directions
    along = _along(locus[..., None, :], chi[:, None])
    top = along.max(axis=-1)
    return used(top, -np.roll(top, directions // 2, axis=-1))


def _worst_directions(locus: ComplexArray, used: Use) -> list[float]:
    """Directions in which a section's worst cycle may be, by its samples."""
    use = _cycles(locus[_outer(locus)], MANY, used)
    around = np.concatenate((use[-1:], use, use[:1]))
    drop = use - np.minimum(around[:-2], around[2:])
    summit = (use >= around[:-2]) & (use >= around[2:])
    found: list[float] = (STEP * np.flatnonzero(summit & (use + drop >= use.max()))).tolist()
    return found


def _starts(
    locus: ComplexArray, chi: float, count: int
) -> Iterator[tuple[float, tuple[int, int], tuple[tuple[int, ...], tuple[int, ...]]]]:
    """What may be the ends of the cycle in a direction, and in those a step beside it."""
    ends = []
    for own in (chi, chi + np.pi):
        along = _along(locus, own).reshape(-1, count)
        peaks, drop = _summits(along)
        peaks &= along + drop / 2 >= along.max()
        near = [along.argmax(), *(_along(locus, own + off).argmax() for off in (STEP, -STEP))]
        samples = [divmod(int(each), count) for each in near]
        ends.append(_ranges(samples + [(int(a), int(n)) for a, n in np.argwhere(peaks)]))
    for upper, lower in product(*ends):
        yield chi, (upper[0], lower[0]), (upper[1:], lower[1:])


def _ranges(samples: list[tuple[int, int]]) -> list[tuple[int, int, int, int]]:
    """Arcs with the number of a sample and of those between which to look, of these samples; those
    of one arc make one range, unless they are far apart.
    """
    found: list[list[int]] = []
    for arc, node in samples:
        for own in found:
            if own[0] == arc and own[2] - APART <= node <= own[3] + APART:
                own[2], own[3] = min(own[2], node - 1), max(own[3], node + 1)
                break
        else:
            found.append([arc, node, node - 1, node + 1])
    return [(arc, node, low, high) for arc, node, low, high in found]


def _outer(locus: ComplexArray) -> IntArray:
    """Samples that may reach farthest in some direction: not inside the polygon of some that do."""
    chi = 2 * np.pi * np.arange(FEW) / FEW
    corners = locus[_along(locus, chi[:, None]).argmax(axis=1)]
    sides = np.roll(corners, -1) - corners
    inside = (np.conj(sides)[:, None] * (locus - corners[:, None])).imag > 0
    found: IntArray = np.flatnonzero(~(inside | (sides == 0)[:, None]).all(axis=0))
    return found
