"""The mechanism as it is made, over the turn: peak, backlash, lost motion, transmission error.

Everything depends on the wave angle alone and repeats with its turn; with deviations it has no
shorter period. Forces have kinks and play has cusps where pairs take over from each other, and
extremes like to sit there: summits are narrowed by golden section, which asks for no derivative.
"""

import math
from dataclasses import dataclass

import numpy as np

from core.arrays import check_finite, check_single
from core.errors import InvalidInput
from core.numerics.extremes import other_places, second_look
from core.output.contact_force import PairNumber
from core.output.loaded_position import notices
from core.output.real_mechanism import RealMechanism
from core.output.sharing_kernel import (
    BACKLASH,
    FORCE,
    INPUT_TORQUE,
    LAG,
    LOST_MOTION,
    PLACE,
    PLAY_END,
    PRESSURE,
    STIFFNESS,
)
from core.output.summits import Grid, Summit, all_summits, highest, summits
from core.output.turn import Turn
from core.results import ROUNDING, Accuracy, Notice, poorly_known

TIE = 1e-9
"""Relative difference below which two summits are one peak, reported at the first crank angle."""


LOOKED_AGAIN = 461
"""Positions of the second look, a prime: so many as a third of the time allows."""


@dataclass(frozen=True, slots=True)
class OverTurn:
    """Extremes over the turn of the wave."""

    peak_force: float  # F_max of all pairs, N
    peak_force_ratio: float  # F_max/F0, F0 = T/R
    peak_crank_angle: float  # first one >= 0, rad
    peak_pair: PairNumber  # the one that carries it there
    backlash_max: float  # largest play of the unloaded output, rad; 0 where pairs press
    backlash_min: float  # least play, rad
    lost_motion: float  # largest difference of lags under a share of the torque both ways, rad
    transmission_error: float  # largest less least lag under load, rad
    unloaded_transmission_error: float  # the same of the lag at which the first pair touches, rad
    stiffness_min: float  # least torsional stiffness, N*m/rad
    stiffness_max: float  # largest, N*m/rad
    loaded_pairs_min: int  # least number of pairs that carry
    loaded_pairs_max: int  # largest number
    max_pressure: float | None  # largest Hertz pressure, Pa, where the materials are known
    pair_force: tuple[tuple[float, ...], ...]  # largest force of each pair, N, K x N
    input_torque_ripple: float  # largest less least torque of the crank, without friction, N*m
    pressed_without_load: bool  # whether pairs press so anywhere
    angle_error: float  # estimate, of backlash, lost motion and transmission errors, rad
    stiffness_error: float  # estimate, relative
    pair_error: float  # estimate, of the pairs' forces, over the peak
    ripple_error: float  # estimate, N*m
    # Of the peak force: what twice as many positions change, what a second look at other positions
    # found above, and rounding. An honest estimate, no proof.
    accuracy: Accuracy
    notices: tuple[Notice, ...]


def _height(summit: Summit) -> float:
    return summit.height


def _crank_angle(real: RealMechanism, psi: float) -> float:
    """First crank angle >= 0 of a wave angle, rad."""
    off = (psi - real.mechanism.initial_crank_angle) % (2 * math.pi)
    if off > 2 * math.pi - 100 * PLACE:
        off = 0.0
    return off / (1 + 1 / real.mechanism.ratio)


def over_turn(
    *, real: RealMechanism, output_torque: float, lost_motion_share: float = 0.03
) -> OverTurn:
    """Peak force, backlash, lost motion, transmission error and stiffness over the turn.

    Parameters
    ----------
    real : RealMechanism
        The mechanism.
    output_torque : float
        Torque T on the output link, N*m, not 0; negative in reverse.
    lost_motion_share : float
        Share of the torque under which the lost motion is taken, 0 < share <= 1.

    Returns
    -------
    OverTurn

    Raises
    ------
    InvalidInput
        If an input is out of range.
    ImpossibleMechanism
        See `RealMechanism.solved`.

    Notes
    -----
    Two pins whose errors nearly use up the clearance make the force a row of spikes narrower than
    any grid, so every summit of the grid is narrowed, and the grid is dense where pairs take up.
    Where many summits are nearly as high, a second look at positions that the first did not have
    narrows those that may be higher; what it finds above is in the stated error.

    Examples
    --------
    >>> from core.output.contact_law import LinearLaw
    >>> from core.output.mechanism import Mechanism
    >>> real = RealMechanism(
    ...     mechanism=Mechanism.evenly_spaced(pins=8, satellites=1, ratio=18.0),
    ...     pin_circle_radius=0.020, pin_radius=0.003, eccentricity=0.0015, contact_length=0.010,
    ...     clearance=2e-5, law=LinearLaw(stiffness=5e7), exact=False)
    >>> turn = over_turn(real=real, output_torque=30.0)
    >>> round(turn.peak_force, 4), round(turn.backlash_max, 10), round(turn.backlash_min, 10)
    (957.1068, 0.0021647844, 0.002)
    """
    check_single(output_torque=output_torque, lost_motion_share=lost_motion_share)
    check_finite(output_torque=output_torque)
    if output_torque == 0:
        raise InvalidInput("output_torque", output_torque, "not_zero")
    if not lost_motion_share > 0:
        raise InvalidInput("lost_motion_share", lost_motion_share, "greater_than", limit=0)
    if not lost_motion_share <= 1:
        raise InvalidInput("lost_motion_share", lost_motion_share, "less_than_equal", limit=1)
    turn = Turn(real, output_torque, lost_motion_share)
    even, near = turn.positions()
    step = even[1] - even[0]
    places = sorted({*even, *near})
    between = sorted({psi + step / 2 for psi in even} - {*places})
    rough = turn.poses(places)
    rough_forces = turn.pair_force
    order = np.argsort([*places, *between], kind="stable")
    every = {
        name: np.concatenate([rough[name], row])[order] for name, row in turn.poses(between).items()
    }

    def grids(name: str, sign: int = 1) -> dict[str, Grid]:
        """The coarse and the fine grid of a row."""
        whole = np.array([*places, *between])[order]
        return {
            "coarse": Grid(np.array(places), sign * rough[name]),
            "fine": Grid(whole, sign * every[name]),
        }

    others = other_places(count=LOOKED_AGAIN, first=even[0])
    again = turn.poses(others.tolist())

    def above(name: str, kind: int, top: Summit, sign: int = 1) -> tuple[Summit, float]:
        """The higher one of a summit and what a second look finds, and by how much it is."""
        place, height, error = second_look(
            places=others,
            heights=sign * again[name],
            known=top.height,
            narrow=turn.narrow(kind, sign),
        )
        if not height > top.height:
            return top, 0.0
        return Summit(place, height, error, (place,)), height - top.height

    found, top, rough_peak = all_summits(**grids("force"), narrow=turn.narrow(FORCE))
    top, missed_peak = above("force", FORCE, top)
    found.append(top)
    peak = top.height
    place = min(
        (each for summit in found if summit.height >= peak * (1 - TIE) for each in summit.alike),
        key=lambda psi: _crank_angle(real, psi),
    )
    turn.values(FORCE, {psi for summit in found for psi in summit.alike})  # of every pair
    turn.values(FORCE, [place])
    force = [*turn.room.force]
    pair = force.index(max(force))
    contact = real.contact(pair, peak)
    max_pressure = None
    if contact is not None:
        max_pressure = contact.max_pressure
        curved = real.pairs.curved
        if max(curved) > min(curved) * (1 + 1e-12):
            pressed_most = summits(grid=grids("pressure")["fine"], narrow=turn.narrow(PRESSURE))
            pressure = above("pressure", PRESSURE, max(pressed_most, key=_height))[0].height
            max_pressure *= math.sqrt(pressure / (peak * curved[pair]))

    def extreme(name: str, kind: int, sign: int = 1, jumps: bool = False) -> tuple[float, float]:
        """Largest value over the turn, or least for the sign -1, and an estimate of its error; on
        the high side of a jump nothing is missed.
        """
        top, missed = highest(**grids(name, sign), narrow=turn.narrow(kind, sign))
        top, more = above(name, kind, top, sign)
        return sign * top.height, missed + more + (0.0 if jumps else top.error)

    def spread(name: str, kind: int) -> tuple[float, float]:
        """Largest less least value over the turn, and an estimate of its error."""
        (high, off), (low, other) = (extreme(name, kind, sign) for sign in (1, -1))
        return high - low, off + other

    lag = spread("lag", LAG)
    pressed = bool((every["low"] > every["high"] + every["play_error"]).any())
    unloaded = 0.0, 0.0
    if not pressed:
        unloaded = spread("high", PLAY_END)
    for rows in (rough, every, again):
        rows["backlash"] = np.maximum(rows["high"] - rows["low"], 0.0)
    backlash = [extreme("backlash", BACKLASH, sign) for sign in (1, -1)]
    lost = turn.values(LOST_MOTION, even)
    most_lost, missed_lost = highest(
        coarse=Grid(lost.places[::2], lost.heights[::2]),
        fine=lost,
        narrow=turn.narrow(LOST_MOTION),
    )
    again["lost_motion"] = turn.values(LOST_MOTION, others.tolist()).heights
    most_lost, more_lost = above("lost_motion", LOST_MOTION, most_lost)
    missed_lost += more_lost
    stiff = [extreme("stiffness", STIFFNESS, sign, True) for sign in (1, -1)]
    ripple = spread("input_torque", INPUT_TORQUE)
    rounding = float(every["lag_error"].max() + 2 * every["play_error"].max())
    unsure = float(every["force_error"].max())
    accuracy = Accuracy(
        "sampling_zoomed",
        (abs(peak - rough_peak) + missed_peak + top.error + unsure) / peak,
        turn.evaluations,
    )
    return OverTurn(
        peak_force=peak,
        peak_force_ratio=peak * real.pin_circle_radius / abs(output_torque),
        peak_crank_angle=_crank_angle(real, place),
        peak_pair=PairNumber(pair // real.mechanism.pins + 1, pair % real.mechanism.pins + 1),
        backlash_max=backlash[0][0],
        backlash_min=backlash[1][0] + 0.0,
        lost_motion=most_lost.height,
        transmission_error=lag[0],
        unloaded_transmission_error=unloaded[0],
        stiffness_min=stiff[1][0],
        stiffness_max=stiff[0][0],
        loaded_pairs_min=int(every["loaded"].min()),
        loaded_pairs_max=int(every["loaded"].max()),
        max_pressure=max_pressure,
        pair_force=real.rows(turn.pair_force),
        input_torque_ripple=ripple[0],
        pressed_without_load=pressed,
        angle_error=rounding
        + max(
            lag[1],
            unloaded[1],
            *[off for _, off in backlash],
            missed_lost + most_lost.error,
        ),
        stiffness_error=max(off / value for value, off in stiff) + 8 * ROUNDING,
        pair_error=max(map(float.__sub__, turn.pair_force, rough_forces)) / peak,
        ripple_error=ripple[1] + 2 * unsure * len(force) * real.eccentricity,
        accuracy=accuracy,
        notices=(
            *notices(
                real=real,
                lag=float(np.abs(every["lag"]).max()),
                pressed=pressed,
                contact=contact,
            ),
            *poorly_known(accuracy),
        ),
    )
