"""Contact force of every pin/hole pair over the turn, and the approximation of its peak.

The force of a driving pair of pressure angle gamma is

    F_jn = F0 * cos(gamma_jn)^v / sum of cos(gamma)^(1 + v) over the driving pairs,   F0 = T/R

(Yanchevskiy and Niekhoroshykh 2021, eq. 10). Exponent v = 1 is eq. (4) of Yanchevsky et al.
2018, in which the pin radius cancels out; v = 0 is equal sharing, eq. (1) of Zyl.
"""

import math
from typing import NoReturn

import numpy as np

from core.arrays import FloatArray, check_not_negative, check_positive, check_single
from core.errors import ImpossibleMechanism, InvalidInput
from core.output.mechanism import Mechanism
from core.precision import ROUNDING, SAME
from core.results import Notice

MAX_FORCE_EXPONENT = 1e6
"""Largest exponent v for which forces are resolved to their stated error."""

APPROXIMATION_PINS = (3, 5)
"""Numbers of pins for which eq. (5) of Yanchevsky et al. 2018 is stated."""

APPROXIMATION_SATELLITES = (1, 2)
"""Numbers of satellites for which eq. (5) of Yanchevsky et al. 2018 is stated."""


def reference_force(*, output_torque: float, pin_circle_radius: float) -> float:
    """Reference force ``F0 = T/R``.

    Parameters
    ----------
    output_torque : float
        Torque T on the output link, N*m.
    pin_circle_radius : float
        Radius R of the circle of pin centres, m, > 0.

    Returns
    -------
    float
        Force F0, N.

    Notes
    -----
    Source: Yanchevskiy and Niekhoroshykh 2021, eq. (11).
    """
    check_positive(pin_circle_radius=pin_circle_radius)
    return output_torque / pin_circle_radius


def output_torque_from_input(*, input_torque: float, ratio: float, efficiency: float) -> float:
    """Torque on the output link ``T = T_in*u*eta``.

    Parameters
    ----------
    input_torque : float
        Torque on the crankshaft, N*m.
    ratio : float
        Ratio u.
    efficiency : float
        Efficiency eta, 0 < eta <= 1.

    Returns
    -------
    float
        Torque T, N*m.

    Notes
    -----
    Source: Yanchevskiy and Niekhoroshykh 2021, before eq. (11).
    """
    check_positive(efficiency=efficiency)
    if efficiency > 1:
        raise InvalidInput("efficiency", efficiency, "less_than_equal", limit=1)
    return input_torque * ratio * efficiency


def pressure_cosines(*, mechanism: Mechanism, crank_angles: FloatArray) -> FloatArray:
    """Cosine of the pressure angle of every pair, 0 where the pair does not drive.

    Parameters
    ----------
    mechanism : Mechanism
        Pins, satellites, ratio.
    crank_angles : array, shape (n,)
        Crank angles phi, rad.

    Returns
    -------
    array, shape (n, K, N)
        ``max(0, cos(gamma))``.

    Notes
    -----
    Source: Yanchevskiy and Niekhoroshykh 2021, eq. (6). Counted in turns, so that a pair on its
    switching angle has the cosine 0 and not a rounding error of either sign.
    """
    turns = np.asarray(crank_angles, dtype=np.float64) / mechanism.crank_angle_per_wave
    satellite = np.array(mechanism.phases.satellite_phase)
    pin = np.arange(mechanism.pins) / mechanism.pins
    phase = satellite[:, None] + pin[None, :] - 0.75
    # The angles are the last axis while it is calculated, as the longest.
    from_switching = (turns - np.floor(turns)) + phase[:, :, None]
    from_switching -= np.rint(from_switching)
    np.abs(from_switching, out=from_switching)
    np.subtract(0.25, from_switching, out=from_switching)
    drives = from_switching > 8 * ROUNDING * (1 + np.abs(turns))
    from_switching *= 2 * np.pi
    cosines = np.zeros_like(from_switching)
    np.sin(from_switching, out=cosines, where=drives)
    return cosines.transpose(2, 0, 1)


def force_ratios(
    *, mechanism: Mechanism, crank_angles: FloatArray, force_exponent: float = 1.0
) -> FloatArray:
    """Contact force of every pair over F0 at given crank angles.

    Parameters
    ----------
    mechanism : Mechanism
        Pins, satellites, ratio.
    crank_angles : array, shape (n,)
        Crank angles phi, rad.
    force_exponent : float
        Exponent v >= 0 of the force over the approach.

    Returns
    -------
    array, shape (n, K, N)
        ``F_jn/F0``, dimensionless; 0 for pairs that do not drive.

    Raises
    ------
    InvalidInput
        If the exponent is negative or above `MAX_FORCE_EXPONENT`.
    ImpossibleMechanism
        If no pair drives at one of the angles.

    Notes
    -----
    Source: Yanchevskiy and Niekhoroshykh 2021, eq. (10). Cosines are divided by the largest
    first, so that no power of them under- or overflows.

    Erratum of Yanchevsky et al. 2018 after fig. 6: the maxima of the next pairs follow at 180/N
    degrees of the wave only for K = 2 with odd N, else at 360/N.

    Examples
    --------
    One satellite, three pins, crank angle in the middle of pair 1's working phase.

    >>> m = Mechanism.evenly_spaced(
    ...     pins=3, satellites=1, ratio=20.0, initial_crank_angle=math.pi)
    >>> force_ratios(mechanism=m, crank_angles=np.array([math.pi/2*20/21])).round(12).tolist()
    [[[1.0, 0.0, 0.0]]]
    """
    check_exponent(force_exponent)
    cosines = pressure_cosines(mechanism=mechanism, crank_angles=crank_angles).transpose(1, 2, 0)
    largest = cosines.max(axis=(0, 1))
    if not largest.all():
        refuse_dead_centre(float(np.asarray(crank_angles)[int(np.argmin(largest))]))
    relative = cosines / largest
    if force_exponent == 0:
        powers = (relative > 0).astype(np.float64)
    else:
        powers = relative if force_exponent == 1 else relative**force_exponent
    ratios: FloatArray = powers / (largest * (powers * relative).sum(axis=(0, 1)))
    return ratios.transpose(2, 0, 1)


def approximate_peak_ratio(*, pins: int, satellites: int) -> float:
    """Approximate peak over F0: ``(0.8 + 0.05*N)^(2 - K) * 4/(K*N)``.

    Parameters
    ----------
    pins, satellites : int
        Numbers N and K.

    Returns
    -------
    float
        Approximate ``max F/F0``, dimensionless.

    Notes
    -----
    Source: Yanchevsky et al. 2018, eq. (5), stated there for N = 3..5 and K = 1, 2 (cranks
    evenly spaced, v = 1) with an error below 2 %; that holds. Outside it drifts: +10 % at
    N = 6, +20 % at N = 8, +40 % at N = 12 (K = 1). See `approximation_notices`.

    Examples
    --------
    >>> round(approximate_peak_ratio(pins=3, satellites=1), 6)
    1.266667
    """
    return float((0.8 + 0.05 * pins) ** (2 - satellites) * 4 / (satellites * pins))


def approximation_notices(*, mechanism: Mechanism, force_exponent: float) -> tuple[Notice, ...]:
    """Limits of eq. (5) of Yanchevsky et al. 2018 that a mechanism breaks.

    Parameters
    ----------
    mechanism : Mechanism
        Pins, satellites, ratio.
    force_exponent : float
        Exponent v.

    Returns
    -------
    tuple of Notice
    """
    notices = []
    for name, value, (low, high) in (
        ("pins", mechanism.pins, APPROXIMATION_PINS),
        ("satellites", mechanism.satellites, APPROXIMATION_SATELLITES),
    ):
        if not low <= value <= high:
            params = {"field": name, "low": low, "high": high, "value": value}
            notices.append(Notice("approximation_range", params))
    if force_exponent != 1:
        notices.append(Notice("approximation_exponent"))
    if mechanism.satellites == 2:
        first, second = mechanism.crank_angles
        off = abs(math.remainder(second - first - math.pi, 2 * math.pi))
        if off > 2 * math.pi * SAME:
            notices.append(Notice("approximation_spacing"))
    return tuple(notices)


def check_exponent(force_exponent: float) -> None:
    """Refuse an exponent v outside 0 to `MAX_FORCE_EXPONENT`.

    Parameters
    ----------
    force_exponent : float
        Exponent v.
    """
    check_single(force_exponent=force_exponent)
    check_not_negative(force_exponent=force_exponent)
    if force_exponent > MAX_FORCE_EXPONENT:
        raise InvalidInput(
            "force_exponent", force_exponent, "less_than_equal", limit=MAX_FORCE_EXPONENT
        )


def refuse_dead_centre(crank_angle: float) -> NoReturn:
    """Refuse a position at which no pair drives, or is sure to.

    Parameters
    ----------
    crank_angle : float
        The crank angle of the position, rad.
    """
    raise ImpossibleMechanism("dead_centre", {"crank_angle": crank_angle})
