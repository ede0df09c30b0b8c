"""Mean of the total force: positions at equal steps, and rules between switching angles."""

import math
from collections.abc import Callable
from functools import partial
from itertools import pairwise
from typing import Any

import numpy as np

from core.arrays import FloatArray
from core.output.losses import total_force
from core.output.mechanism import Mechanism
from core.output.pin_forces import force_ratios
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


def total_force_study(*, mechanism: Mechanism, force_exponent: float = 1.0) -> WorkPrecision:
    """Error against run time of the mean total force, to which the mean loss is proportional.

    Parameters
    ----------
    mechanism : Mechanism
        Pins, satellites, ratio; at most `MAX_PAIRS` pairs.
    force_exponent : float
        Exponent v of the force over the approach.

    Returns
    -------
    WorkPrecision

    Raises
    ------
    InvalidInput
        If there are too many pairs.
    ImpossibleMechanism
        If the mechanism has a dead centre.
    """
    refuse_many_pairs(mechanism=mechanism, limit=MAX_PAIRS)
    found = total_force(mechanism=mechanism, force_exponent=force_exponent)
    ends, mean = _reference(mechanism, force_exponent)
    period = mechanism.crank_angle_per_wave / mechanism.pins
    # Crank angles between which the same pairs drive and the same one is the best placed.
    pieces = list(pairwise(float(end) * mechanism.crank_angle_per_wave / math.tau for end in ends))

    def totals(angles: FloatArray) -> FloatArray:
        ratios = force_ratios(
            mechanism=mechanism, crank_angles=angles, force_exponent=force_exponent
        )
        total: FloatArray = ratios.sum(axis=(1, 2))
        return total

    def sampled(count: int) -> float:
        return float(totals(np.linspace(0.0, period, count, endpoint=False)).mean())

    def between(nodes: FloatArray, weights: FloatArray) -> float:
        parts = [
            integrate(integrand=totals, start=start, end=end, nodes=nodes, weights=weights)
            for start, end in pieces
        ]
        return math.fsum(parts) / period

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
    calculate: Callable[..., Any] = total_force.__wrapped__  # not what it remembers
    chosen = measured(
        method=found.accuracy.method,
        calculate=lambda: calculate(mechanism=mechanism, force_exponent=force_exponent).mean,
        exact=[mean],
        evaluations=found.accuracy.evaluations,
    )
    return WorkPrecision.against("multiple_tanh_sinh", points=[*points, chosen], chosen=chosen)


def _reference(mechanism: Mechanism, exponent: float) -> tuple[list[Any], Any]:
    """Ends of the smooth parts of the wave within a pitch, and the mean, to 40 digits."""
    import mpmath

    with mpmath.workdps(REFERENCE_DIGITS):
        pitch = 2 * mpmath.pi / mechanism.pins
        own = [
            mpmath.mpf(alpha) + mpmath.mpf(mechanism.initial_crank_angle)
            for alpha in mechanism.crank_angles
        ]
        phases = [phase + n * pitch for phase in own for n in range(mechanism.pins)]
        power, nothing = mpmath.mpf(exponent), mpmath.mpf(10) ** (10 - REFERENCE_DIGITS)
        # A pair starts or stops to drive where the sine of wave angle and phase vanishes; midway
        # between neighbouring phases another one becomes the best placed.
        places = {(half - phase) % pitch for phase in own for half in (0, mpmath.pi)}
        around = sorted(phase % pitch for phase in own)
        around.append(around[0] + pitch)
        places |= {(-mpmath.pi / 2 - (a + b) / 2) % pitch for a, b in pairwise(around)}
        ends = [mpmath.mpf(0)]
        ends += [each for each in (*sorted(places), pitch) if each - ends[-1] > nothing]

        def total(driving: list[Any], angle: Any) -> Any:
            cosines = [-mpmath.sin(angle + phase) for phase in driving]
            cosines = [c if c > nothing else mpmath.mpf(0) for c in cosines]
            best = max(cosines)
            shares = [c if power == 1 else (c / best) ** power for c in cosines]
            return mpmath.fsum(shares) / mpmath.fdot(shares, cosines)

        integral = mpmath.mpf(0)
        for low, high in pairwise(ends):
            middle = (low + high) / 2
            driving = [phase for phase in phases if mpmath.sin(middle + phase) < 0]
            integral += mpmath.quad(partial(total, driving), [low, high])
        return ends, integral / pitch
