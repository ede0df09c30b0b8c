"""Number of involute pairs that carry, as flanks beyond the path of contact are only microns apart.

Pairs beyond the path touch at the corner of a tip once the teeth deflect. The result holds for
teeth without errors and is for information: a pitch error of some microns removes most of it.

In the frame of the ring the planet's centre lies on the real axis, at the eccentricity. Tooth i and
space i face each other there if the planet is turned by 0. Flanks are the anticlockwise ones.
"""

import math
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from core.arrays import BoolArray, FloatArray, IntArray, check_positive
from core.errors import Accuracy, ImpossibleMechanism
from core.fields import answer
from core.numerics.extremes import other_places, zoom
from core.precision import ROUNDING
from core.ring.involute import InvolutePair
from core.ring.line_of_action import involute, roll

PAIR_STIFFNESS = 14e9
"""Stiffness of a pair of steel teeth along the line of action over the tooth width, N/m^2."""

POSITIONS = 97
"""Number of positions within a pitch in the first search."""

HALVINGS = 60
"""Number of bisections for the crossing of a ring's flank and the planet's tip circle."""


class Touching(NamedTuple):
    """Turns of the planet about its own centre at which its pairs touch; arrays of shape (m, n)."""

    pair: IntArray  # index i of each pair, shape (n,)
    onset: FloatArray  # angle eps_i at which the pair touches, rad; infinite if never
    lever: FloatArray  # lever h_i of the force about the planet's centre, m
    at_corner: BoolArray  # true if the pair touches at the corner of a tip, beside the path


class SharedTorque(NamedTuple):
    """Forces of pairs that share a planet's torque, shape (m, n), and its rotation, shape (m,)."""

    force: FloatArray  # F_i, N
    rotation: FloatArray  # angular deflection of the planet from centred teeth, rad


@dataclass(frozen=True, kw_only=True)
class PairsThatCarry:
    """Pairs that carry over a pitch."""

    loaded_pairs_min: int = answer()
    """Least number of pairs with a force."""
    loaded_pairs_max: int = answer()
    """Largest number of pairs with a force."""
    largest_share: float = answer()
    """Largest share of the force that one pair carries."""
    edge_contact: bool = answer()
    """True if a pair carries at the corner of a tip, where the pressure is not known."""
    accuracy: Accuracy


def touching(*, pair: InvolutePair, angle: FloatArray) -> Touching:
    """Turns at which the pairs of a planet touch, for its turns theta_s in rad, shape (m,).

    A pair touches on the path after half the backlash if the roll angle
    ``axis_i + eps + sigma_s + alpha_w`` lies on the path, at the corner of the ring's tip on the
    planet's flank, or at the corner of the planet's tip on the ring's flank; the least turn counts.
    """
    line, teeth = pair.line, pair.teeth
    count = teeth.satellite_teeth
    index = np.arange(count) - count // 2
    axis = np.mod(angle, 2 * math.pi / count)[:, None] + 2 * math.pi * index / count
    space = np.mod(angle, 2 * math.pi / count)[:, None] * count / teeth.ring_teeth
    space = space + 2 * math.pi * index / teeth.ring_teeth + teeth.ring_half_angle
    flank = axis + teeth.satellite_half_angle
    free = pair.backlash / 2
    at = flank + free + line.angle
    on_path = (pair.start_roll_satellite <= at) & (at <= pair.end_roll)
    by_ring = _by_ring_tip(pair, flank, space)
    by_satellite, lever = _by_satellite_tip(pair, flank, space)
    onsets = np.stack([np.where(on_path, free, np.inf), by_ring, by_satellite])
    first = onsets.argmin(axis=0)
    return Touching(
        pair=index,
        onset=onsets.min(axis=0),
        lever=np.where(first == 2, lever, line.satellite_base),
        at_corner=first > 0,
    )


def _by_ring_tip(pair: InvolutePair, flank: FloatArray, space: FloatArray) -> FloatArray:
    """Turns at which the corners of the ring's tips touch the planet's flanks, rad."""
    line, tip = pair.line, pair.teeth.ring_tip
    at_tip = float(involute(math.atan(roll(tip, base=line.ring_base))))
    corner = tip * np.exp(1j * (space - at_tip))
    from_centre = corner - line.eccentricity
    radius = np.abs(from_centre)
    form = line.satellite_base * math.hypot(1, max(pair.form_roll_satellite, 0.0))
    there = (radius >= form) & (radius <= pair.teeth.satellite_tip)
    tangent = roll(np.where(there, radius, form), base=line.satellite_base)
    turned = _wrapped(np.angle(from_centre) - flank + tangent - np.arctan(tangent))
    return np.where(there, turned, np.inf)


def _by_satellite_tip(
    pair: InvolutePair, flank: FloatArray, space: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """Turns at which corners of the planet's tips touch the ring's flanks, rad; levers, m."""
    line, tip = pair.line, pair.teeth.satellite_tip

    low = float(roll(pair.teeth.ring_tip, base=line.ring_base))
    high = float(roll(pair.ring_root_radius, base=line.ring_base))

    def place(tangent: FloatArray | float, turned: FloatArray) -> FloatArray:
        """Point of the ring's flank at a roll angle, from the planet's centre, m."""
        on_flank = line.ring_base * np.exp(1j * (turned - tangent)) * (1 + 1j * tangent)
        return np.asarray(on_flank - line.eccentricity)

    there = (np.abs(place(low, space)) <= tip) & (tip <= np.abs(place(high, space)))
    own = space[there]
    lows, highs = np.full(own.shape, low), np.full(own.shape, high)
    for _ in range(HALVINGS):
        middle = (lows + highs) / 2
        inside = np.abs(place(middle, own)) < tip
        lows, highs = np.where(inside, middle, lows), np.where(inside, highs, middle)
    corner = place(highs, own)
    at_tip = float(involute(math.atan(pair.end_roll)))
    turn, lever = np.full(space.shape, np.inf), np.full(space.shape, line.satellite_base)
    turn[there] = _wrapped(np.angle(corner) - flank[there] + at_tip)
    lever[there] = np.abs(np.imag(np.conj(corner) * 1j * np.exp(1j * (own - highs))))
    return turn, lever


def _wrapped(angle: FloatArray) -> FloatArray:
    """Angle within half a turn of 0."""
    return np.remainder(angle + math.pi, 2 * math.pi) - math.pi


def shared_torque(*, found: Touching, torque: float, stiffness: float) -> SharedTorque:
    """Forces of pairs of one stiffness that share a torque, closed in the order of their onsets:
    ``F_i = k*h_i*max(0, eps - eps_i)``, ``sum F_i*h_i = T_j``. The torque T_j is in N*m, the
    stiffness k along the line of action in N/m, both > 0.
    """
    check_positive(torque=torque, stiffness=stiffness)
    order = found.onset.argsort(axis=1)
    onset = np.take_along_axis(found.onset, order, axis=1)
    weight = np.take_along_axis(found.lever, order, axis=1) ** 2
    first = onset[:, :1]
    with np.errstate(invalid="ignore"):
        later = np.where(np.isinf(onset), np.inf, onset - first)
        taken = np.cumsum(weight * np.where(np.isinf(later), 0, later), axis=1)
    turns = (torque / stiffness + taken) / np.cumsum(weight, axis=1)
    closed = (later < turns).sum(axis=1, keepdims=True)
    rotation = first + np.take_along_axis(turns, np.maximum(closed, 1) - 1, axis=1)
    force = stiffness * found.lever * np.maximum(0, rotation - found.onset)
    return SharedTorque(force, rotation[:, 0])


def pairs_that_carry(
    *, pair: InvolutePair, torque: float, contact_length: float, stiffness: float | None = None
) -> PairsThatCarry:
    """Numbers of pairs of perfect teeth that carry over a pitch, and the largest share of one pair.

    Raises ImpossibleMechanism if the teeth interfere or touch where they are not involutes. The
    torque T_j of the planet, N*m, and the contact length, m, are > 0; the stiffness of a pair, N/m,
    is `PAIR_STIFFNESS` times the contact length by default.
    """
    if not pair.on_involutes:
        raise ImpossibleMechanism("teeth_interfere")
    check_positive(torque=torque, contact_length=contact_length)
    k = PAIR_STIFFNESS * contact_length if stiffness is None else stiffness
    pitch = 2 * math.pi / pair.teeth.satellite_teeth

    def shares(angle: FloatArray) -> tuple[FloatArray, Touching]:
        found = touching(pair=pair, angle=angle)
        return shared_torque(found=found, torque=torque, stiffness=k).force, found

    def largest(angle: FloatArray) -> FloatArray:
        return np.asarray(shares(angle)[0].max(axis=1) * pair.line.satellite_base / torque)

    places = np.linspace(0, pitch, POSITIONS, endpoint=False)
    force, found = shares(places)
    others = other_places(count=POSITIONS - 8, period=pitch)
    sampled, second = force.max(axis=1) * pair.line.satellite_base / torque, largest(others)
    tops = np.array([places[sampled.argmax()], others[second.argmax()]])
    _, heights, errors = zoom(values=largest, places=tops, width=pitch / POSITIONS)
    loaded = (force > 0).sum(axis=1)
    best = int(heights.argmax())
    error = float(abs(heights[0] - heights[1]) + errors[best]) + 64 * ROUNDING
    return PairsThatCarry(
        loaded_pairs_min=int(loaded.min()),
        loaded_pairs_max=int(loaded.max()),
        largest_share=float(heights[best]),
        edge_contact=bool(((force > 0) & found.at_corner).any()),
        accuracy=Accuracy("sampling_zoomed", error / float(heights[best]), 2 * POSITIONS),
    )
