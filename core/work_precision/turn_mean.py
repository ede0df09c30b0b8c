"""Means over the turn of what follows from all forces: positions at equal steps, and rules between
switching angles.
"""

import math
from collections.abc import Callable
from functools import partial
from itertools import pairwise
from typing import Any

import numpy as np

from core.arrays import FloatArray
from core.output.contact_force import force_peak
from core.output.mechanism import Mechanism
from core.output.pin_turn import all_pairs, satellite_turn
from core.results import Accuracy
from core.work_precision.rules import fixed_rules, integrate
from core.work_precision.study import (
    REFERENCE_DIGITS,
    WorkPrecision,
    measured,
    refuse_many_pairs,
)

MAX_PAIRS = 48
"""Most pairs of a study: the work of its reference grows with the cube of them at worst."""

SAMPLES = (16, 64, 256, 1024, 4096, 16384)

Exact = Callable[[list[list[Any]], list[list[Any]]], Any]
"""What is averaged, in multiple precision: of the forces over F0 and the cosines of the driving
pairs, a list for each satellite."""


def forget() -> None:
    """Forget what calculators remember of forces, so that a mean costs what it does at first."""
    for remembered in (force_peak, satellite_turn, all_pairs):
        remembered.cache_clear()


def turn_mean_study(
    *,
    mechanism: Mechanism,
    force_exponent: float,
    values: Callable[[FloatArray], FloatArray],
    exact: Exact,
    power: float,
    calculate: Callable[[], float],
    accuracy: Accuracy,
) -> WorkPrecision:
    """Error against run time of a mean over the turn, ``<x^p>^(1/p)``, of what repeats with every
    pitch of the pins.

    Parameters
    ----------
    mechanism : Mechanism
        Pins, satellites, ratio; at most `MAX_PAIRS` pairs.
    force_exponent : float
        Exponent v of the force over the approach.
    values : callable
        x at crank angles, rad, shape (n,).
    exact : callable
        The same in multiple precision.
    power : float
        p.
    calculate : callable
        The mean as the calculators have it.
    accuracy : Accuracy
        Of that.

    Returns
    -------
    WorkPrecision

    Raises
    ------
    InvalidInput
        If there are too many pairs.
    """
    refuse_many_pairs(mechanism=mechanism, limit=MAX_PAIRS)
    ends, mean = _reference(mechanism, force_exponent, exact, power)
    period = mechanism.crank_angle_per_wave / mechanism.pins
    # Crank angles between which the same pairs drive and the same one is the best placed.
    pieces = list(pairwise(float(end) * mechanism.crank_angle_per_wave / math.tau for end in ends))

    def powers(angles: FloatArray) -> FloatArray:
        return np.asarray(values(angles) ** power)

    def sampled(count: int) -> float:
        found = powers(np.linspace(0.0, period, count, endpoint=False)).mean()
        return float(found ** (1 / power))

    def between(nodes: FloatArray, weights: FloatArray) -> float:
        parts = [
            integrate(integrand=powers, start=start, end=end, nodes=nodes, weights=weights)
            for start, end in pieces
        ]
        return float((math.fsum(parts) / period) ** (1 / power))

    points = [
        measured(
            method="sampling",
            setting=("points", count),
            calculate=partial(sampled, count),
            exact=[mean],
            evaluations=count,
        )
        for count in SAMPLES
    ]
    points += [
        measured(
            method="segments_gauss",
            setting=setting,
            calculate=partial(between, nodes, weights),
            exact=[mean],
            evaluations=len(nodes) * len(pieces),
        )
        for code, setting, nodes, weights in fixed_rules()
        if code == "gauss_legendre"
    ]
    chosen = measured(
        method=accuracy.method,
        calculate=calculate,
        exact=[mean],
        evaluations=accuracy.evaluations,
    )
    return WorkPrecision.against("multiple_tanh_sinh", points=[*points, chosen], chosen=chosen)


def _reference(
    mechanism: Mechanism, exponent: float, exact: Exact, mean_power: float
) -> tuple[list[Any], Any]:
    """Ends of the smooth parts of the wave within a pitch, and the mean, to 40 digits."""
    import mpmath

    with mpmath.workdps(REFERENCE_DIGITS):
        pitch = 2 * mpmath.pi / mechanism.pins
        own = [
            mpmath.mpf(alpha) + mpmath.mpf(mechanism.initial_crank_angle)
            for alpha in mechanism.crank_angles
        ]
        phases = [[phase + n * pitch for n in range(mechanism.pins)] for phase in own]
        power, nothing = mpmath.mpf(exponent), mpmath.mpf(10) ** (10 - REFERENCE_DIGITS)
        # A pair starts or stops to drive where the sine of wave angle and phase vanishes; midway
        # between neighbouring phases another one becomes the best placed.
        places = {(half - phase) % pitch for phase in own for half in (0, mpmath.pi)}
        around = sorted(phase % pitch for phase in own)
        around.append(around[0] + pitch)
        places |= {(-mpmath.pi / 2 - (a + b) / 2) % pitch for a, b in pairwise(around)}
        ends = [mpmath.mpf(0)]
        ends += [each for each in (*sorted(places), pitch) if each - ends[-1] > nothing]

        def averaged(driving: list[list[Any]], angle: Any) -> Any:
            cosines = [[-mpmath.sin(angle + phase) for phase in some] for some in driving]
            cosines = [[c if c > nothing else mpmath.mpf(0) for c in some] for some in cosines]
            best = max(map(max, filter(None, cosines)))
            shares = [[c if power == 1 else (c / best) ** power for c in some] for some in cosines]
            total = mpmath.fsum(map(mpmath.fdot, shares, cosines))
            return exact([[f / total for f in some] for some in shares], cosines) ** mean_power

        integral = mpmath.mpf(0)
        for low, high in pairwise(ends):
            middle = (low + high) / 2
            driving = [
                [phase for phase in some if mpmath.sin(middle + phase) < 0] for some in phases
            ]
            integral += mpmath.quad(partial(averaged, driving), [low, high])
        return ends, (integral / pitch) ** (1 / mpmath.mpf(mean_power))
