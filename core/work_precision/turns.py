"""Least room of pins in their holes, ends of what carries: positions of the turn, and between."""

import math

import numpy as np

from core.arrays import FloatArray
from core.numerics.extremes import zoom
from core.output.real_cyclogram import HALVINGS, SAMPLES, carried_ends
from core.output.room import POSITIONS, Rooms
from core.output.stage import Stage
from core.work_precision.peaks import REAL_DIGITS, SUMMITS, real_turn
from core.work_precision.study import (
    DEFAULT,
    Method,
    Outcome,
    Reference,
    WorkPrecision,
    refuse_many_pairs,
    work_precision,
)

MAX_ROOM_PAIRS = 240
"""Most pairs of the study of the room."""

ANGLES = (24, 60, 120, 360, 720, 1440, 2880)
FINER = 8
"""How many times as many positions as the calculator's the reference of the room has."""

STEPS = (4, 8, 12)
EXACT_HALVINGS = 44
"""Halvings after which an end is as good as doubles can tell."""


def least_room_study(*, rooms: Rooms) -> WorkPrecision:
    """Error against run time of the least room over the turn, as a part of the difference of radii
    that is left then: the room itself may be next to nothing.

    Parameters
    ----------
    rooms : Rooms
        Pins in their holes, which hold them; at most `MAX_ROOM_PAIRS` pairs.

    Returns
    -------
    WorkPrecision
        Angles miss where the room is least, always: it is smaller than they see.

    Raises
    ------
    InvalidInput
        If there are too many pairs.
    """
    refuse_many_pairs(mechanism=rooms.mechanism, limit=MAX_ROOM_PAIRS)

    def tight(wave: FloatArray) -> FloatArray:
        return -rooms.eccentricity - rooms.rooms(wave)[0]

    def sampled(count: int) -> Outcome:
        return -float(tight(2 * math.pi * np.arange(count) / count).max()), count

    def zoomed(_: float) -> Outcome:
        return rooms.eccentricity + rooms.over_turn().least, POSITIONS

    def dense() -> float:
        step = 2 * math.pi / (FINER * POSITIONS)
        places: FloatArray = step * np.arange(FINER * POSITIONS, dtype=np.float64)
        tops = places[np.argsort(-tight(places))[:SUMMITS]]
        return -float(zoom(values=tight, places=tops, width=step)[1].max())

    return work_precision(
        reference=Reference("sampling_dense", REAL_DIGITS),
        exact=[dense()],
        methods=[
            Method("sampling", [("positions", count) for count in ANGLES], sampled),
            Method("arcs_zoomed", DEFAULT, zoomed, chosen=True),
        ],
    )


def carried_ends_study(*, real: Stage, output_torque: float) -> WorkPrecision:
    """Error against run time of the crank angles from and to which pairs carry: of all of them
    together, and the turn.

    Parameters
    ----------
    real : Stage
        The mechanism, by itself or in series with its ring, as
        `core.work_precision.peaks.real_turn` takes it.
    output_torque : float
        Torque T on the output link, N*m, not 0; negative in reverse.

    Returns
    -------
    WorkPrecision
        What is too coarse to see all ends is left out.

    Raises
    ------
    InvalidInput
        If there are too many pairs.
    ImpossibleMechanism
        See `Stage.solved`.
    """
    turn = real_turn(real=real, output_torque=output_torque)
    crank = real.mechanism.crank_angle_per_wave / (2 * math.pi)

    def ends(samples: int, halvings: int) -> FloatArray:
        found = carried_ends(turn=turn, samples=samples, halvings=halvings)
        return found.wave[np.lexsort((found.wave, found.falls, found.pair))]

    exact = ends(SAMPLES, EXACT_HALVINGS)

    def all_of(wave: FloatArray) -> list[float]:
        return [crank * 2 * math.pi, *(crank * wave).tolist()]

    def looked(samples: int, halvings: int) -> Outcome:
        before = turn.evaluations
        found = ends(samples, halvings)
        if len(found) != len(exact):
            return math.nan, 1
        off = np.remainder(found - exact + math.pi, 2 * math.pi) - math.pi
        return all_of(exact + off), turn.evaluations - before

    return work_precision(
        reference=Reference("bisection", REAL_DIGITS),
        exact=all_of(exact),
        methods=[
            Method("sampling", [("positions", n) for n in ANGLES], lambda n: looked(n, 0)),
            Method("bisection", [("steps", n) for n in STEPS], lambda n: looked(SAMPLES, n)),
            Method("bisection", DEFAULT, lambda _: looked(SAMPLES, HALVINGS), chosen=True),
        ],
    )
