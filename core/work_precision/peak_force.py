"""Peak force: sampling, polished sampling, segment-exact, and the papers' approximations."""

from functools import partial
from typing import Any

import numpy as np

from core.output.mechanism import Mechanism
from core.output.peak_force import peak_force
from core.output.pin_forces import approximate_peak_ratio, force_ratios
from core.work_precision.study import (
    GOLDEN_STEPS,
    REFERENCE_DIGITS,
    WorkPoint,
    WorkPrecision,
    golden_section,
    measured,
    refuse_many_pairs,
)

MAX_PAIRS = 300
"""Most pairs of a study: its reference and its samples grow with them."""

SAMPLES = (16, 64, 256, 1024, 4096, 16384, 65536)


def peak_force_study(*, mechanism: Mechanism, force_exponent: float = 1.0) -> WorkPrecision:
    """Error against run time of the peak of the contact force.

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
    pairs = mechanism.pins * mechanism.satellites
    refuse_many_pairs(mechanism=mechanism, limit=MAX_PAIRS)
    peak = peak_force(mechanism=mechanism, force_exponent=force_exponent)
    exact = [_reference(mechanism, force_exponent, peak.peak_crank_angle)]
    end = mechanism.crank_angle_per_wave

    def sampled(count: int) -> float:
        angles = np.linspace(0.0, end, count, endpoint=False)
        ratios = force_ratios(
            mechanism=mechanism, crank_angles=angles, force_exponent=force_exponent
        )
        return float(ratios.max())

    def force(angle: float) -> float:
        angles = np.array([angle])
        ratios = force_ratios(
            mechanism=mechanism, crank_angles=angles, force_exponent=force_exponent
        )
        return float(ratios.max())

    def polished(count: int) -> float:
        angles = np.linspace(0.0, end, count, endpoint=False)
        largest = force_ratios(
            mechanism=mechanism, crank_angles=angles, force_exponent=force_exponent
        ).max(axis=(1, 2))
        best, step = int(largest.argmax()), end / count
        narrowed = golden_section(
            value=force, low=angles[best] - step, high=angles[best] + step, steps=GOLDEN_STEPS
        )
        return max(float(largest[best]), float(narrowed))

    points: list[WorkPoint | None] = [
        measured(
            method="sampling",
            setting=("points", count),
            calculate=partial(sampled, count),
            exact=exact,
            evaluations=count,
        )
        for count in SAMPLES
        if count * pairs <= 2_000_000
    ]
    points += [
        measured(
            method="golden_section",
            setting=("points", count),
            calculate=partial(polished, count),
            exact=exact,
            evaluations=count + GOLDEN_STEPS,
        )
        for count in (16, 64, 256)
    ]
    chosen = measured(
        method="segment_exact",
        calculate=lambda: (
            peak_force(mechanism=mechanism, force_exponent=force_exponent).peak_force_ratio
        ),
        exact=exact,
        evaluations=peak.accuracy.evaluations,
    )
    points.append(chosen)
    points.append(
        measured(
            method="approximation",
            calculate=lambda: approximate_peak_ratio(
                pins=mechanism.pins, satellites=mechanism.satellites
            ),
            exact=exact,
            evaluations=1,
        )
    )
    points.append(
        measured(
            method="equal_sharing",
            calculate=lambda: peak_force(mechanism=mechanism, force_exponent=0.0).peak_force_ratio,
            exact=exact,
            evaluations=1,
        )
    )
    return WorkPrecision.against("multiple_peak", points=points, chosen=chosen)


def _reference(mechanism: Mechanism, exponent: float, crank_angle: float) -> Any:
    """Peak in multiple precision, on the piece of the turn where it was found."""
    import mpmath

    with mpmath.workdps(REFERENCE_DIGITS):
        phases = [
            mpmath.mpf(alpha)
            + mpmath.mpf(mechanism.initial_crank_angle)
            + 2 * mpmath.pi * n / mechanism.pins
            for alpha in mechanism.crank_angles
            for n in range(mechanism.pins)
        ]
        power = mpmath.mpf(exponent)
        psi = mpmath.mpf(crank_angle) * (1 + 1 / mpmath.mpf(mechanism.ratio))

        def cosines(angle: Any) -> list[Any]:
            return [c for c in (-mpmath.sin(angle + phase) for phase in phases) if c > 0]

        def force(angle: Any) -> Any:
            driving = cosines(angle)
            best = max(driving)
            shares = sum((c / best) ** (1 + power) for c in driving)
            return 1 / (best * shares)

        # The peak lies within rounding of psi: on a kink there, or at a smooth maximum beside it.
        width = mpmath.mpf("1e-7")
        # A force is stationary at its peak, so half the digits of the place give all of it.
        polished = golden_section(value=force, low=psi - width, high=psi + width, steps=85)
        return max(polished, force(psi))
