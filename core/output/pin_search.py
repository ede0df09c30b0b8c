"""Where over the turn, along the pin and around it a measure of the moment is largest.

Over the turn all is looked at in samples first, and every summit that may be the largest is
narrowed down. Along the pin and around it the search knows how far a largest value may lie above
the best point near it, and drops only what cannot hold it:

- Where a component of the moment is largest of all directions, one at an angle a beside it is
  ``cos(a)`` of it; so is a utilisation that is the largest of sums of such components.
- Along the pin the moment is curved by the line load alone, ``M'' = F/b``.
"""

from collections.abc import Callable
from dataclasses import dataclass
from itertools import count
from typing import Any

import numpy as np
from numpy.typing import NDArray

from core.arrays import BoolArray, FloatArray
from core.output.pin_turn import Turn, combine
from core.output.sampled_turn import PinSamples

ROUNDS = 9
"""Rounds over the turn that are always enough: where the forces are not smooth a summit may be much
narrower than a cell; where they are, fewer are taken."""

SETTLED = 4e-14
"""How much lower the neighbours of the best place may be, as a part of it, for it to be the end."""

CELLS = 16
"""Cells of a round's grid on each side of the best place."""

AFTER = np.maximum(np.arange(-CELLS, CELLS + 1) / CELLS, 0.0)
BEFORE = AFTER[::-1]

BLOCK = 1_000_000
"""Numbers that are worked on at once."""

AROUND = 24
"""Directions looked at first."""

ALONG = 4
"""Parts of each stretch of the pin that are looked at first."""

ENOUGH = 2e-13
"""What a largest value may be missed by, as a part of it, at which the search ends."""

SAMPLED = 0.95
"""Least share of the largest sample that may belong to what turns out largest."""

KEPT = 64
"""Most points about which is looked further: more are only where the measure is flat."""

THIRDS = np.array([-1.0, 0.0, 1.0]) / 3

Measure = Callable[..., FloatArray]
"""Of the sums of the satellites' forces times each of their arms."""


def largest(
    *,
    turn: Turn | PinSamples,
    arms: tuple[NDArray[Any], ...],
    measure: Measure,
    rounds: int = ROUNDS,
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
    rounds : int
        Most rounds in which summits are narrowed.

    Returns
    -------
    array, shape (rows,)
    """
    samples = turn.forces.reshape(len(turn.forces), -1)
    more = 0 if isinstance(turn, PinSamples) else 2 * CELLS * turn.weights.shape[1]
    rows = max(1, BLOCK // (samples.shape[1] + more))
    if len(arms[0]) > rows:
        parts = [slice(i, i + rows) for i in range(0, len(arms[0]), rows)]
        return np.concatenate(
            [
                largest(
                    turn=turn,
                    arms=tuple(each[part] for each in arms),
                    measure=measure,
                    rounds=rounds,
                )
                for part in parts
            ]
        )
    values = measure(*(combine(arms=each, forces=samples) for each in arms))
    if isinstance(turn, PinSamples):
        return np.asarray(values.max(axis=1))
    values = values.reshape(len(values), -1, len(turn.nodes))
    chosen, drop = _summits(values)
    chosen &= values + drop / 2 >= values.max(axis=(1, 2), keepdims=True)
    row, arc, node = np.nonzero(chosen)
    own = tuple(each[row] for each in arms)
    at = turn.at(turn.arcs[arc])
    gaps = np.concatenate(([0.0], np.diff(turn.nodes), [0.0]))
    place, width = turn.nodes[node], np.maximum(gaps[node], gaps[node + 1])
    every, best = np.arange(len(row)), values[chosen]
    for _ in range(rounds):
        before, after = np.minimum(place, width), np.minimum(1 - place, width)
        grid = place[:, None] + (after[:, None] * AFTER - before[:, None] * BEFORE)
        grid = np.minimum(np.maximum(grid, 0.0), 1.0)
        forces = at(grid)
        found = measure(*(combine(arms=each, forces=forces) for each in own))
        index = found.argmax(axis=1)
        index = np.where(found[every, index] > found[:, CELLS], index, CELLS)
        best, place = found[every, index], grid[every, index]
        end = (place == 0) | (place == 1)
        stuck = ((index == 0) | (index == 2 * CELLS)) & ~end
        width = width * np.where(stuck, 2.0, 1 / CELLS)
        beside, beyond = (
            np.minimum(
                found[every, np.maximum(index - step, 0)],
                found[every, np.minimum(index + step, 2 * CELLS)],
            )
            for step in (1, 2)
        )
        settled = best - beside <= SETTLED * best
        if turn.smooth:  # and steep at the end of its arc: no summit lies within the last cell
            settled |= end & (best - beside > (beside - beyond) / 2)
        if settled.all():
            break
    result = np.asarray(values.max(axis=(1, 2)))
    np.maximum.at(result, row, best)
    return result


def _summits(values: FloatArray) -> tuple[BoolArray, FloatArray]:
    """Which values are largest beside their neighbours along the last axis, and by how much."""
    before = np.concatenate((values[..., :1], values[..., :-1]), axis=-1)
    after = np.concatenate((values[..., 1:], values[..., -1:]), axis=-1)
    return (values >= before) & (values >= after), values - np.minimum(before, after)


@dataclass(frozen=True, slots=True)
class Points:
    """Points of the pin's edge about which a largest value may lie.

    Attributes
    ----------
    section, direction : array, shape (rows,)
        Distance from the carrier's face, m; rad.
    length : array, shape (rows,)
        Distance of neighbouring sections, m.
    angle : float
        Of neighbouring directions, rad.
    """

    section: FloatArray
    direction: FloatArray
    length: FloatArray
    angle: float


def highest(
    *,
    value: Callable[[Points, int], tuple[FloatArray, FloatArray]],
    ends: FloatArray,
    around: bool = False,
    enough: float = ENOUGH,
) -> tuple[float, float, float]:
    """The largest value of all sections, and of all directions where they count.

    Parameters
    ----------
    value : callable
        Of points and in how many rounds the turn is to be searched: values, shape (rows,), and how
        far above them a largest one may lie that is no farther off than half the way to the next
        points.
    ends : array, shape (s,)
        Ends of the stretches along which the value is smooth, ascending; one section if there is
        no other.
    around : bool
        Whether directions count.
    enough : float
        What the value may be missed by, as a part of it.

    Returns
    -------
    value, section, direction : float
    """
    long = len(ends) > 1
    if long:
        low, high = (np.repeat(each, ALONG + 1) for each in (ends[:-1], ends[1:]))
        way = np.tile(np.arange(ALONG + 1) / ALONG, len(ends) - 1)
        stretches = np.array([low * (1 - way) + high * way, low, high, (high - low) / ALONG])
    else:
        stretches = np.array([ends, ends, ends, [0.0]])
    directions = 2 * np.pi * np.arange(AROUND) / AROUND if around else np.zeros(1)
    angle = directions[1] if around else 0.0
    x, low, high, length = np.repeat(stretches, len(directions), axis=1)
    chi = np.tile(directions, stretches.shape[1])
    moves = np.meshgrid(THIRDS if long else 0.0, THIRDS if around else 0.0)
    move_x, move_chi = (each.ravel() for each in moves)
    best = -np.inf, 0.0, 0.0
    for level in count():
        rounds = min(2 * level, ROUNDS) if long or around else ROUNDS
        values, room = value(Points(x, chi, length, angle), rounds)
        top = int(values.argmax())
        best = max(best, (float(values[top]), float(x[top]), float(chi[top])))
        if rounds == ROUNDS and room.max() <= enough * best[0]:
            break
        # no more than rounding may have put the best of all above the best of these
        least = min(best[0] * (1 if rounds else SAMPLED), float(values[top]))
        kept = np.flatnonzero(values + room >= least)
        kept = kept[np.argsort(-values[kept], kind="stable")[:KEPT]]
        x = (x[kept, None] + length[kept, None] * move_x).ravel()
        chi = (chi[kept, None] + angle * move_chi).ravel()
        low, high, length = (np.repeat(each[kept], len(move_x)) for each in (low, high, length / 3))
        angle /= 3
        inside = (x >= low) & (x <= high)
        x, chi, low, high, length = (each[inside] for each in (x, chi, low, high, length))
    return best
