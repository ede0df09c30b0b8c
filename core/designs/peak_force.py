"""Exact peak of the contact force for arrays of mechanisms with the same numbers of pairs."""

import math
from dataclasses import dataclass

import numpy as np

from core.contact_force import MAX_FORCE_EXPONENT, FloatArray
from core.designs.checks import check_finite, check_positive, first_where
from core.designs.linear_law import linear_peaks
from core.designs.power_law import power_peaks
from core.designs.segments import IntArray, Phases
from core.errors import InvalidInput

CHUNK = 50_000
"""About how many cosines are worked on at once: enough to pay, few enough for the cache."""


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
    For v = 1 and an even number of pins the sum of the squared cosines is constant and the peak
    4/(K*N); for an odd one the peaks inside segments are roots of a cubic. For other exponents a
    stretch is halved as long as neither its force can be shown to stay below the largest found
    so far, nor its slope to keep its sign.

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
    count, satellites = crank_angles.shape
    found = PeakForces(
        np.empty(count),
        np.empty(count),
        np.empty(count, dtype=np.intp),
        np.empty(count, dtype=np.intp),
        np.empty(count),
        np.empty(count, dtype=np.intp),
    )
    linear = force_exponent == 1
    for closed, rows in ((True, np.flatnonzero(linear)), (False, np.flatnonzero(~linear))):
        step = max(1, CHUNK // (satellites * satellites * 3 * (1 if closed else pins)))
        for first in range(0, len(rows), step):
            some = rows[first : first + step]
            phases = Phases.of(
                pins=pins, crank_angles=crank_angles[some].T, initial=initial_crank_angle[some]
            )
            peak = (
                linear_peaks(phases)
                if closed
                else power_peaks(phases=phases, exponent=force_exponent[some])
            )
            satellite, pin = phases.best_pair(peak.place)
            for name, each in (
                ("peak_force_ratio", peak.ratio),
                ("peak_crank_angle", peak.place * 2 * math.pi * ratio[some] / (1 + ratio[some])),
                ("peak_satellite", satellite),
                ("peak_pin", pin),
                ("relative_error", peak.error),
                ("evaluations", peak.evaluations),
            ):
                getattr(found, name)[some] = each
    return found
