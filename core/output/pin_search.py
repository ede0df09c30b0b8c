"""Where over the turn, along the pin and around it a measure of the moment is largest.

Over the turn all is looked at in samples first, and every summit that may be the largest is
narrowed down. Along the pin and around it the search knows how far a largest value may lie above
the best point near it, and drops only what cannot hold it:

- Where a component of the moment is largest of all directions, one at an angle a beside it is
  ``cos(a)`` of it; so is a utilisation that is the largest of sums of such components.
- Along the pin the moment is curved by the line load alone, ``M'' = F/b``.

What is left when that is little is narrowed down in all variables at once.
"""

import math
from collections.abc import Callable
from copy import copy
from dataclasses import dataclass
from functools import cache
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from core.arrays import BoolArray, FloatArray, IntArray
from core.output.pin_turn import BLOCK, Turn, combine
from core.output.sampled_turn import PinSamples
from core.precision import CONVERGED

ROUGH, ROUGHLY = 2, 1 - 1e-6
"""Rounds over the turn while points are still dropped, and what part of the largest they find at
least."""

SAMPLED = 0.99
"""What part of it samples find at least, with parabolas through the highest."""

SMOOTH, ROUNDS = 5, 14
"""Rounds over the turn that are always enough, where the forces are smooth and where not: there a
summit may be much narrower than a cell."""

CELLS = 8
"""Cells of a round's grid on each side of the best place."""

AFTER = np.maximum(np.arange(-CELLS, CELLS + 1) / CELLS, 0.0)
BEFORE = AFTER[::-1]

BESIDE = np.array([-1, 0, 1])[:, None, None]
"""From a place to its neighbours."""

SETTLED = 1e-15
"""How much lower the neighbours of the best place are, as a part of it, where it is the end."""

MISSED = SETTLED / 8
"""By how much, as a part of it, the best place of a summit may miss what is largest: where its
neighbours lie no lower than `SETTLED`, the top of the parabola through all three does by this."""

RISE = 1e-11
"""By how much, as a part of it, the top of a parabola may lie above the best place where it counts
itself: what it misses by is of the third order, that of the second."""

SIDES = 4e-15
"""How far both sides of a hill differ by rounding, as a part of its height: what its middle misses
by that is the square of it, over the fall to the next samples."""

JOINT_ROUNDS = 22
"""Most rounds in all variables at once."""

REACHED = 9.0
"""How much lower a summit may be where it is followed from than where it is highest, over what is
lost half the way to the next points: that grows with the square of the way, which may be three
times as far, to a summit about a neighbour that is not followed."""

FOLLOWED = 4
"""How far about a place that moves with the section is looked next at least, over how far it moved:
else it lags behind."""

NARROWER = 8
"""By how much smaller steps are after one that went well."""

AROUND = 24
"""Directions looked at first."""

ALONG, SECTIONS = 4, 24
"""Parts of each stretch of the pin that are looked at first, at least, and about how many sections
where there are few stretches and directions do not count."""

NEAR, NEAR_AROUND = 1e-3, 1e-5
"""What may be left, as a part of it, when the search goes on in all variables at once: along the
pin, where all summits over the turn are followed, and where directions count too."""

KEPT = 64
"""Most points about which is looked further: more are only where the measure is flat."""

CLOSER = 3
"""How much closer the next points are, at least."""

POINTS = 300
"""About how many points are looked at then where values are known in closed form."""

Measure = Callable[..., FloatArray]
"""Of the sums of the satellites' forces times each of their arms."""

Arms = Callable[[FloatArray], tuple[FloatArray, ...]]
"""Of sections: what unit forces of the satellites do there, each with the satellites last."""


@dataclass(frozen=True, slots=True)
class Summits:
    """Summits of samples over the turn, that may hold the largest value."""

    row: IntArray  # which row of the arms, shape (n,)
    arc: IntArray  # which arc of the turn, shape (n,)
    place: FloatArray  # where on it, as a part of the way, shape (n,)
    width: FloatArray  # distance of the farther neighbour, shape (n,)
    height: FloatArray  # how high they may be, shape (n,)

    def of(self, index: IntArray) -> "Summits":
        """Some of them, or some several times."""
        row, arc = self.row[index], self.arc[index]
        return Summits(row, arc, self.place[index], self.width[index], self.height[index])

    def before(self, others: "Summits") -> "Summits":
        """These and then others."""
        row, arc, place, width, height = (
            np.concatenate((getattr(self, name), getattr(others, name)))
            for name in self.__dataclass_fields__
        )
        return Summits(row, arc, place, width, height)


def summits(
    *,
    turn: Turn,
    arms: tuple[NDArray[Any], ...],
    measure: Measure,
    known: bool = True,
    lower: FloatArray | float = 0.0,
) -> tuple[FloatArray, Summits]:
    """Largest samples of a measure over the turn, and the summits that may hold the largest value.

    Parameters
    ----------
    turn : Turn
        Forces over the turn.
    arms : tuple of array, each shape (rows, K)
        What unit forces of the satellites do; complex where the direction counts.
    measure : callable
        Of the sums, each shape (rows, m).
    known : bool
        Whether also those whose height is that of their sample: samples like both their neighbours,
        ends of arcs from which the measure falls by a slope that is known, and middles of arcs with
        two sides alike.
    lower : float or array, shape (rows,)
        By how much lower than the largest a summit may be, where others may rise as something else
        moves.

    Returns
    -------
    values : array, shape (rows,)
    summits : Summits
    """
    samples = turn.forces.reshape(len(turn.forces), -1)
    values = measure(*(combine(arms=each, forces=samples) for each in arms))
    values = values.reshape(len(values), -1, len(turn.nodes))
    chosen, drop = _tops(values)
    room = drop / 2
    # an arc's first sample may have a summit beside it: twice what a parabola may rise
    first, second = turn.nodes[1:3].tolist()
    count = values.shape[2]
    end, inner, farther = (values[..., k : count - k : count - 1 - 2 * k] for k in range(3))
    slope = (end - inner) / first
    bend = np.abs(slope - (end - farther) / second) * (first / (second - first))
    room[..., :: count - 1] += bend * (first / 2)
    most = values.max(axis=(1, 2))
    heights = values + room
    # of samples that differ by rounding only, one an arc
    size = SIDES * np.abs(values).max(axis=(1, 2), keepdims=True)
    chosen &= (drop > size) | (np.arange(count) == values.argmax(axis=2)[..., None])
    chosen &= heights >= np.asarray(most - lower)[:, None, None]
    if not known:
        chosen &= drop > SETTLED * np.abs(values)
        chosen[..., count // 2] &= ~_even_hills(turn.nodes, values)
        if turn.smooth:
            chosen[..., :: count - 1] &= bend > slope / 2
    row, arc, node = np.nonzero(chosen)
    height = heights[row, arc, node]
    return most, Summits(row, turn.arcs[arc], turn.nodes[node], turn.gaps[node], height)


def largest(
    *,
    turn: Turn | PinSamples,
    arms: tuple[NDArray[Any], ...],
    measure: Measure,
    rounds: int | None = None,
) -> FloatArray:
    """The largest of a measure over the turn.

    Parameters
    ----------
    turn : Turn or PinSamples
        Forces over the turn; of samples the largest is taken as it is.
    arms : tuple of array, each shape (rows, K)
        What unit forces of the satellites do; complex where the direction counts.
    measure : callable
        Of the sums, each shape (rows, m).
    rounds : int, optional
        Rounds in which summits are narrowed; as many as they need where not given.

    Returns
    -------
    array, shape (rows,)
    """
    most = turn.forces[0].size
    if isinstance(turn, Turn):
        most += 2 * CELLS * turn.pairs.weights.shape[1]
    rows = max(1, BLOCK // most)
    if len(arms[0]) > rows:
        parts = [slice(i, i + rows) for i in range(0, len(arms[0]), rows)]
        some = (tuple(each[part] for each in arms) for part in parts)
        return np.concatenate(
            [largest(turn=turn, arms=each, measure=measure, rounds=rounds) for each in some]
        )
    if isinstance(turn, PinSamples):
        sums = (combine(arms=each, forces=turn.forces) for each in arms)
        return np.asarray(measure(*sums).max(axis=1))
    result, tops = summits(turn=turn, arms=arms, measure=measure, known=False)
    if not len(tops.row):
        return result
    summit = OfArcs(turn, tops)
    for _ in range(rounds or (SMOOTH if turn.smooth else ROUNDS)):
        own = tuple(each[summit.row] for each in arms)

        def measured(forces: NDArray[Any], own: tuple[NDArray[Any], ...] = own) -> FloatArray:
            return measure(*(combine(arms=each, forces=forces) for each in own))[:, None]

        top, above, left = (each.ravel() for each in summit.narrow(measured, CELLS**2))
        np.maximum.at(result, summit.row, above if rounds else top)
        kept = np.flatnonzero((left > 0) & (above + left >= result[summit.row]))
        if not len(kept):
            break
        if len(kept) < len(left):
            summit = summit.of(kept)
    return result


def sampled(*, turn: Turn | PinSamples, values: FloatArray) -> FloatArray:
    """About the largest value over the turn by its samples: that of the parabola through the
    highest one and its neighbours.

    Parameters
    ----------
    turn : Turn or PinSamples
        Forces over the turn; of samples the largest is taken as it is.
    values : array, shape (rows, m)
        At its samples.

    Returns
    -------
    array, shape (rows,)
    """
    every, index = np.arange(len(values)), values.argmax(axis=1)
    top: FloatArray = values[every, index]
    if isinstance(turn, PinSamples):
        return top
    node = index % len(turn.nodes)
    middle = np.minimum(np.maximum(node, 1), len(turn.nodes) - 2)
    at = index - node + middle
    beside = BESIDE[..., 0]
    return np.maximum(top, _vertex(turn.nodes[middle + beside], values[every, at + beside])[1])


class OfArcs:
    """Summits of a measure on arcs of the turn, while they are narrowed.

    Parameters
    ----------
    turn : Turn
        Forces over the turn.
    tops : Summits
        Where they are about.

    Attributes
    ----------
    at : callable
        The forces at parts of the way along each arc.
    row : array of int, shape (n,)
        Which row of the arms.
    place, width : array, shape (n,)
        Where they are by now, and how far about that is to be looked.
    """

    def __init__(self, turn: Turn, tops: Summits) -> None:
        self.turn, self.near, self.row, self.arc = turn, False, tops.row, tops.arc
        self.place, self.width, self.at = tops.place, tops.width, turn.at(tops.arc)

    def of(self, index: IntArray) -> "OfArcs":
        """Some of them."""
        found = copy(self)
        found.row, found.arc = self.row[index], self.arc[index]
        found.place, found.width = self.place[index], self.width[index]
        found.at = self.turn.at(found.arc)
        return found

    def narrow(
        self,
        measured: Callable[[NDArray[Any]], FloatArray],
        closer: int,
        *,
        seen: int | None = None,
    ) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Look about each summit, and go on to it.

        Parameters
        ----------
        measured : callable
            Of forces, shape (n, K, m): values of one or more sections, shape (n, s, m).
        closer : int
            How much closer is looked next; no more than `CELLS` beside an end of an arc at which
            the forces are not smooth.
        seen : int, optional
            By which of several sections the place goes on, where the sections move as well.

        Returns
        -------
        highest, above : array, shape (n, s)
            Largest values, and where they are more those of the parabolas through their neighbours.
        left : array, shape (n,)
            How much higher it may be; 0 where it is settled.
        """
        place, width = self.place, self.width
        before, after = np.minimum(place, width), np.minimum(1 - place, width)
        grid = place[:, None] + (after[:, None] * AFTER - before[:, None] * BEFORE)
        grid = np.minimum(grid, 1.0)
        found = measured(self.at(grid))
        top, index = found.max(axis=2), found.argmax(axis=2)
        index = np.where(top > found[:, :, CELLS], index, CELLS)
        low = np.where(before > 0, 1, CELLS + 1)[:, None]  # three places apart
        high = np.where(after > 0, 2 * CELLS - 1, CELLS - 1)[:, None]
        middle = np.minimum(np.maximum(index, low), high)
        row, section = np.arange(len(grid))[:, None], np.arange(top.shape[1])
        beside = middle + BESIDE
        values = found[row, section, beside]
        vertex, above = _vertex(grid[row, beside], values)
        above = np.maximum(top, above)
        followed = seen is not None
        best, own = index[:, seen or 0], (slice(None), seen or 0)
        at = grid[row[:, 0], best]
        stuck = ((best == 0) | (best == 2 * CELLS)) & (at > 0) & (at < 1)
        size = np.abs(top[own])
        fall = top[own] - values.min(axis=0)[own]
        settled = fall <= SETTLED * size
        parabolic = self.turn.smooth | (width <= np.minimum(place, 1 - place) / 2)
        if self.near:  # the parabola of so near places is right
            enough = RISE if followed else MISSED
            settled |= (above[own] - top[own] <= enough * size) & ~stuck & parabolic
        self.near = True
        self.place = np.where(stuck | (above == top)[own], at, vertex[own])
        narrower = np.where(parabolic, 1 / closer, 1 / min(closer, CELLS))
        self.width = width * np.where(stuck, 2.0, narrower)
        if followed:
            self.width = np.maximum(self.width, FOLLOWED * np.abs(self.place - place))
        return top, above, np.where(settled, 0.0, np.where(stuck, np.inf, fall))


def _vertex(places: FloatArray, values: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Where the parabola through three points, those of a column, is largest, between the outer
    two, and its value there.
    """
    (x0, x1, x2), (f0, f1, f2) = places, values
    rise, fall, apart = (f1 - f0) * (x2 - x1), (f2 - f1) * (x1 - x0), (x1 - x0) * (x2 - x1)
    known = (rise > fall) & (apart > 0)  # at one place values may differ by rounding
    bent = np.where(known, rise - fall, 1.0)
    middle = (x0 + x1) / 2 + rise / bent * (x2 - x0) / 2
    middle = np.where(known, np.minimum(np.maximum(middle, x0), x2), x1)
    before, after = middle - x0, middle - x1
    summed = rise * before - bent * before * after / np.where(known, x2 - x0, 1.0)
    return middle, np.where(known, f0 + summed / np.where(known, apart, 1.0), f1)


def _tops(values: FloatArray) -> tuple[BoolArray, FloatArray]:
    """Which values are largest beside their neighbours along the last axis, and by how much."""
    beside = np.concatenate((values[..., :1], values, values[..., -1:]), axis=-1)
    before, after = beside[..., :-2], beside[..., 2:]
    return values >= np.maximum(before, after), values - np.minimum(before, after)


def _even_hills(nodes: FloatArray, values: FloatArray) -> BoolArray:
    """Which arcs, along the last axis, have their summit in the middle: on both sides of it samples
    are alike but for rounding, and fall as a parabola does, from one to the next by half as much
    again or as little at most.
    """
    middle = len(nodes) // 2
    start, first, second = nodes[middle : middle + 3].tolist()
    top = values[..., middle]
    near, far = (top - values[..., middle + k] for k in (1, 2))
    parabolic = near * ((second - start) / (first - start)) ** 2
    apart = np.abs(values[..., :middle] - values[..., :middle:-1]).max(axis=-1)
    found: BoolArray = (apart <= SIDES * np.abs(top)) & (np.abs(far - parabolic) <= parabolic / 2)
    return found


@dataclass(frozen=True, slots=True)
class Points:
    """Points of the pin's edge about which a largest value may lie."""

    section: FloatArray  # distance from the carrier's face, m, shape (rows,)
    direction: FloatArray  # rad, shape (rows,)
    length: FloatArray  # distance of neighbouring sections, m, shape (rows,)
    angle: float  # between neighbouring directions, rad
    low: FloatArray  # start of the stretch of the pin that has the section, m, shape (rows,)
    high: FloatArray  # its end, m, shape (rows,)

    def of(self, index: IntArray | slice) -> "Points":
        """Some of them, or some several times."""
        rows = (self.section, self.direction, self.length, self.low, self.high)
        section, direction, length, low, high = (each[index] for each in rows)
        return Points(section, direction, length, self.angle, low, high)


def quadratics(*, arms: Arms, points: Points) -> Arms:
    """Arms near points, where the line load is even, so that moments are quadratic.

    Parameters
    ----------
    arms : callable
        Of any sections.
    points : Points
        On the stretches that count.

    Returns
    -------
    callable
        Of sections of the stretches, m, shape (rows, s).
    """
    low, high = points.low, points.high
    ends = arms(np.stack((low, (low + high) / 2, high)))
    width = np.where(high > low, high - low, 1.0)[:, None]

    def within(x: FloatArray) -> tuple[FloatArray, ...]:
        t = ((x - low[:, None]) / width)[..., None]
        parts = (1 - t) * (1 - 2 * t), 4 * t * (1 - t), t * (2 * t - 1)
        return tuple(
            sum(part * each[:, None] for part, each in zip(parts, values, strict=True))
            for values in ends
        )

    return within


Found = TypeVar("Found")
"""What is known of the largest value."""


def highest(
    *,
    value: Callable[[Points, int], tuple[FloatArray, FloatArray, FloatArray]],
    stretches: FloatArray,
    around: bool = False,
    enough: float,
    climb: Callable[[Points], Found],
    size: int,
    closed: bool = False,
    beyond: float = -np.inf,
) -> Found | None:
    """The largest value of all sections, and of all directions where they count.

    Parameters
    ----------
    value : callable
        Of points and in how many rounds the turn is to be searched: values, shape (rows,), and how
        far above them a largest one may lie that is no farther off than half the way to the next
        points; and how much of that `climb` needs to be little.
    stretches : array, shape (2, s)
        Ends of the stretches along which the value is smooth; the same twice for one section.
    around : bool
        Whether directions count.
    enough : float
        What may be left of the latter, as a part of the value, for this search to end.
    climb : callable
        What is to be known of the largest value about the points that are left, the best first.
    size : int
        How many numbers the values of a point are made of.
    closed : bool
        Whether values are exact.
    beyond : float
        Value up to which a largest one does not count.

    Returns
    -------
    object
        What `climb` finds; None where there is nothing beyond.
    """
    long = stretches[1] > stretches[0]
    cuts = ALONG if around else max(ALONG, SECTIONS // max(1, int(long.sum())))
    parts = np.where(long, cuts, 0)
    row = np.repeat(np.arange(len(parts)), parts + 1)
    part = np.maximum(parts, 1)[row]
    way = (np.arange(len(row)) - np.repeat(np.cumsum(parts + 1) - parts - 1, parts + 1)) / part
    low, high = stretches[:, row]
    directions = 2 * np.pi * np.arange(AROUND) / AROUND if around else np.zeros(1)
    points = np.array([low * (1 - way) + high * way, low, high, (high - low) / part])
    x, low, high, length = np.repeat(points, len(directions), axis=1)
    angle = float(directions[1]) if around else 0.0
    at = Points(x, np.tile(directions, points.shape[1]), length, angle, low, high)
    best, rows, rounds = beyond, max(1, BLOCK // size), 0
    while True:
        blocks = [np.s_[i : i + rows] for i in range(0, len(at.section), rows)]
        found = [value(at.of(each), rounds) for each in blocks]
        values, room, above = map(np.concatenate, zip(*found, strict=True))
        best = max(best, float(values.max()))
        share = 1 - CONVERGED if closed else ROUGHLY if rounds else SAMPLED
        least = max(min(best * share, float(values.max())), beyond * share)
        kept = np.flatnonzero(values + room >= least)
        if not len(kept):
            return None
        kept = kept[np.argsort(-values[kept], kind="stable")[:KEPT]]
        left = float(above[kept].max()) / enough
        if left <= best:
            return climb(at.of(kept[_apart(at.of(kept))]))
        closer = CLOSER
        if closed:  # what is left falls with the square of it
            many = (POINTS / len(kept)) ** (0.5 if long.any() else 1.0)
            closer = max(closer, min(int(many), math.ceil(math.sqrt(left / best))) | 1)
        steps_x, steps_chi = (each / closer for each in _steps(closer, bool(long.any()), around))
        near = at.of(kept)
        x = near.section[:, None] + near.length[:, None] * steps_x
        inside = (x >= near.low[:, None]) & (x <= near.high[:, None])
        inside &= (near.length > 0)[:, None] | (steps_x == 0)
        chi = (near.direction[:, None] + at.angle * steps_chi)[inside]
        own = near.of(np.nonzero(inside)[0])
        at = Points(x[inside], chi, own.length / closer, at.angle / closer, own.low, own.high)
        rounds = ROUGH


def climbed(
    *,
    value: Callable[[FloatArray, FloatArray], tuple[FloatArray, BoolArray]],
    points: Points,
    rounds: int = JOINT_ROUNDS,
) -> tuple[FloatArray, FloatArray]:
    """Sections about points, and directions where they count, at which a value is largest, by
    Newton's method with differences.

    Parameters
    ----------
    value : callable
        Of sections and directions, shape (rows, m), which may lie a little beyond the points'
        stretches: values there, and for each row whether they are as good as they get.
    points : Points
        Where to start.
    rounds : int
        Most rounds.

    Returns
    -------
    section, direction : array, shape (rows,)
    """
    x, chi, length = points.section, points.direction, points.length
    angle, every = np.full(len(x), points.angle), np.arange(len(x))
    before = np.zeros(len(x), dtype=np.bool_)  # whether the last step was one of Newton's
    along, around = bool(length.any()) or not points.angle, points.angle > 0
    move_x, move_chi = _steps(3, along, around)
    lines, columns = 3 if around else 1, 3 if along else 1
    for _ in range(rounds):
        f, settled = value(
            x[:, None] + length[:, None] * move_x, chi[:, None] + angle[:, None] * move_chi
        )
        grid, top = f.reshape(-1, lines, columns), f.argmax(axis=1)
        highest = f[every, top]
        over = highest - f.min(axis=1) <= SETTLED * np.abs(highest)
        by_x, by_chi = grid[:, lines // 2].T, grid[:, :, columns // 2].T
        here = by_x[columns // 2]
        slope_x, slope_chi = (by_x[-1] - by_x[0]) / 2, (by_chi[-1] - by_chi[0]) / 2
        bent_x, bent_chi = by_x[-1] + by_x[0] - 2 * here, by_chi[-1] + by_chi[0] - 2 * here
        mixed = (grid[:, -1, -1] - grid[:, -1, 0] - grid[:, 0, -1] + grid[:, 0, 0]) / 4
        held = (length == 0) | np.where(slope_x > 0, x >= points.high, x <= points.low)
        slope_x, bent_x, mixed = np.where(held, ([0.0], [-1.0], [0.0]), (slope_x, bent_x, mixed))
        if lines == 1:
            bent_chi -= 1.0
        bent = bent_x * bent_chi - mixed * mixed
        known = (bent_x < 0) & (bent > 0)
        size = np.where(known, bent, 1.0)
        step_x = (mixed * slope_chi - bent_chi * slope_x) / size
        step_chi = (mixed * slope_x - bent_x * slope_chi) / size
        far = np.maximum(np.abs(step_x), np.abs(step_chi))
        known &= far <= 1
        step_x, step_chi = np.where(known, (step_x, step_chi), (move_x[top], move_chi[top]))
        gain = slope_x * step_x + slope_chi * step_chi  # twice what is left to a parabola's top
        left = np.maximum(here.max() - here, 2 * SETTLED * np.abs(here))
        over |= known & settled & (2 * gain <= left)
        x = np.minimum(np.maximum(x + length * step_x, points.low), points.high)
        chi = chi + angle * step_chi
        if over.all():
            break
        wider = np.where(highest > here, np.where(before, 1.0, 2.0), 0.5)
        wider = np.where(known, np.maximum(far, 1 / NARROWER), wider)
        before = known
        length, angle = length * wider, angle * wider
    return x, chi


@cache
def _steps(count: int, along: bool, around: bool) -> tuple[FloatArray, FloatArray]:
    """Steps along the pin and around it, as many each way about the middle one: all pairs."""
    steps = np.arange(count) - float(count // 2)
    grid = np.meshgrid(steps if along else 0.0, steps if around else 0.0)
    return grid[0].ravel(), grid[1].ravel()


def first_of(*, values: FloatArray, section: FloatArray) -> int:
    """Where the largest value is; of values alike but for rounding that at the least section.

    Parameters
    ----------
    values, section : array, shape (n,)
        Of each place, its value and its section.

    Returns
    -------
    int
    """
    alike = np.flatnonzero(values >= values.max() * (1 - CONVERGED))
    return int(alike[section[alike].argmin()])


def _apart(points: Points) -> IntArray:
    """Points that are no neighbours of one before them on their stretch."""
    rows = points.section, points.direction, points.length, points.low
    x, chi, length, low = (each.tolist() for each in rows)
    chosen: list[int] = []
    for k in range(len(x)):
        if all(
            low[k] != low[j]
            or abs(x[k] - x[j]) > 1.5 * length[j]
            or abs(chi[k] - chi[j]) > 1.5 * points.angle
            for j in chosen
        ):
            chosen.append(k)
    return np.array(chosen)
