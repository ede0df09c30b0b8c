"""Exact peak of the contact force for arrays of mechanisms with the same numbers of pairs."""

import math
import os
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

import numpy as np

from core.contact_force import MAX_FORCE_EXPONENT, FloatArray, IntArray
from core.designs.checks import check_finite, check_positive, first_where
from core.designs.room import Peaks, room
from core.errors import InvalidInput

FEWEST_A_THREAD = 20_000
"""Designs that are worth one more thread."""


@dataclass(frozen=True, slots=True)
class PeakForces:
    """Largest contact force of any pair over the turn, for each design.

    Attributes
    ----------
    peak_force_ratio : array, shape (n,)
        Peak force over the reference force F0, dimensionless.
    peak_crank_angle : array, shape (n,)
        Smallest crank angle >= 0 at which it is reached, rad.
    peak_satellite, peak_pin : array of int, shape (n,)
        Numbers of the pair that carries it there, from 1.
    relative_error : array, shape (n,)
        Bound of the relative error of `peak_force_ratio`.
    evaluations : array of int, shape (n,)
        Places at which the force was calculated.
    """

    peak_force_ratio: FloatArray
    peak_crank_angle: FloatArray
    peak_satellite: IntArray
    peak_pin: IntArray
    relative_error: FloatArray
    evaluations: IntArray


def peak_forces(
    *,
    pins: int,
    crank_angles: FloatArray,
    ratio: FloatArray,
    force_exponent: FloatArray,
    initial_crank_angle: FloatArray,
) -> PeakForces:
    """Exact peak of the contact force over the turn, for arrays of mechanisms.

    Parameters
    ----------
    pins : int
        Number of pins N of every design, at least 3: with fewer a design may have a dead
        centre, see `core.peak_force`.
    crank_angles : array, shape (n, K)
        Angle of each satellite's crank, rad.
    ratio : array, shape (n,)
        Ratio u > 0.
    force_exponent : array, shape (n,)
        Exponent v of the force over the approach.
    initial_crank_angle : array, shape (n,)
        Wave angle at crank angle 0, rad.

    Returns
    -------
    PeakForces

    Raises
    ------
    InvalidInput
        If there are fewer than three pins, or an entry is out of range; its index is named.

    Notes
    -----
    Source of the force: Yanchevskiy and Niekhoroshykh 2021, eq. (10), as in `core.peak_force`.
    How it is found, and compiled at the first call, is told in `core.designs.compiled.peak_search`.
    Large arrays are shared out to the processors.

    Examples
    --------
    Three pins, two satellites at 180 and at 90 degrees.

    >>> found = peak_forces(pins=3, crank_angles=np.array([[0, np.pi], [0, np.pi/2]]),
    ...                     ratio=np.full(2, 20.0), force_exponent=np.ones(2),
    ...                     initial_crank_angle=np.zeros(2))
    >>> found.peak_force_ratio.round(12).tolist()
    [0.666666666667, 0.694199805444]
    """
    if pins < 3:
        raise InvalidInput("pins", pins, "must be at least 3 for an array of designs")
    check_finite(crank_angles=crank_angles, initial_crank_angle=initial_crank_angle, ratio=ratio)
    check_positive(ratio=ratio)
    outside = ~((force_exponent >= 0) & (force_exponent <= MAX_FORCE_EXPONENT))
    if (index := first_where(outside)) is not None:
        limit = f"must lie from 0 to {MAX_FORCE_EXPONENT:g}"
        raise InvalidInput(f"force_exponent[{index}]", force_exponent[index], limit)
    from core.designs.compiled.peak_search import find_peaks  # with a compiler, which takes a while

    cranks = np.ascontiguousarray(crank_angles, float)
    exponents = np.ascontiguousarray(force_exponent, float)
    initials = np.ascontiguousarray(initial_crank_angle, float)
    designs, satellites = cranks.shape
    powers = bool((exponents != 1).any())
    threads = min(os.cpu_count() or 1, designs // FEWEST_A_THREAD + 1)
    share = designs // threads + 1

    def search(first: int) -> Peaks:
        part = slice(first, first + share)
        count = len(exponents[part])
        peaks = Peaks(
            ratio=np.empty(count),
            place=np.empty(count),
            satellite=np.empty(count, np.int64),
            pin=np.empty(count, np.int64),
            error=np.empty(count),
            evaluations=np.empty(count, np.int64),
        )
        own_room = room(pins=pins, satellites=satellites, powers=powers)
        find_peaks(pins, cranks[part], exponents[part], initials[part], own_room, peaks)
        return peaks

    if threads == 1:
        parts = [search(0)]
    else:
        with ThreadPoolExecutor(threads) as pool:
            parts = list(pool.map(search, range(0, designs + 1, share)))
    found = Peaks(*map(np.concatenate, zip(*parts, strict=True)))
    return PeakForces(
        peak_force_ratio=found.ratio,
        peak_crank_angle=found.place * 2 * math.pi * ratio / (1 + ratio),
        peak_satellite=found.satellite,
        peak_pin=found.pin,
        relative_error=found.error,
        evaluations=found.evaluations,
    )
