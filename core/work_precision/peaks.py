"""Largest force over the turn: sampling, polished sampling, and the calculators' own searches."""

import math
from collections.abc import Callable
from typing import Any

import numpy as np

from core.arrays import FloatArray
from core.errors import InvalidInput
from core.output.contact_force import approximate_peak_ratio, force_ratios, peak_force
from core.output.mechanism import Mechanism
from core.output.over_turn import OverTurn
from core.output.stage import Stage
from core.output.summits import Grid, all_summits, summits
from core.output.turn import Turn
from core.ring.series import MeshesInSeries
from core.ring.series_turn import SeriesOverTurn, SeriesTurn
from core.work_precision.study import (
    DEFAULT,
    REFERENCE_DIGITS,
    Method,
    Outcome,
    Reference,
    WorkPrecision,
    work_precision,
)

MAX_PAIRS, MAX_REAL_PAIRS, MAX_COMPLIANT_PAIRS, MAX_SERIES_PAIRS = 300, 36, 9, 60
"""Most pairs of ideal forces; with clearance, where some twenty thousand positions are solved; with
compliant satellites, which take four times as long; of both meshes in series together."""

SAMPLES, POLISHED = (16, 64, 256, 1024, 4096, 16384, 65536), (16, 64, 256)
MAX_SAMPLED = 2_000_000
"""Numbers of crank angles, and most ideal forces that are sampled at once."""

POSITIONS, ZOOMED = (24, 60, 120, 360, 720, 1440, 2880), (24, 60, 120, 360, 720)
DENSE, REAL_DIGITS = 4, 12
"""Positions with clearance; how many times as many as the calculator's the reference has, and to
how many digits that is right."""

GOLDEN_STEPS, EXACT_STEPS = 40, 85
"""Steps after which a summit is as good as doubles can tell; as multiple precision can: a value is
stationary at its summit, so half the digits of the place give all of it."""


def _refuse_many(mechanism: Mechanism, limit: int, pins: str = "pins") -> None:
    """Refuse more pairs than its reference can; their number is called `pins`, that of a ring has
    another name.
    """
    satellites = mechanism.satellites
    if mechanism.pins * satellites > limit:
        most = {"limit": limit // satellites, "satellites": satellites}
        raise InvalidInput(pins, mechanism.pins, "too_many_pairs", **most)


def _golden_section(value: Callable[[Any], Any], low: Any, high: Any, steps: int) -> Any:
    """Largest value about one summit between two places, floats or mpmath numbers."""
    ratio = ((5 + 0 * low) ** 0.5 - 1) / 2  # to as many digits as the place has
    left, right = high - ratio * (high - low), low + ratio * (high - low)
    at_left, at_right = value(left), value(right)
    for _ in range(steps):
        if at_left > at_right:
            high, right, at_right = right, left, at_left
            left = high - ratio * (high - low)
            at_left = value(left)
        else:
            low, left, at_left = left, right, at_right
            right = low + ratio * (high - low)
            at_right = value(right)
    return max(at_left, at_right)


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
    _refuse_many(mechanism, MAX_PAIRS)
    pins, satellites = mechanism.pins, mechanism.satellites
    law: dict[str, Any] = {"mechanism": mechanism, "force_exponent": force_exponent}
    period, angle = mechanism.crank_angle_per_wave, peak_force(**law).peak_crank_angle

    def largest(angles: FloatArray) -> FloatArray:
        return np.asarray(force_ratios(crank_angles=angles, **law).max(axis=(1, 2)))

    def samples(count: int) -> FloatArray:
        return largest(np.linspace(0.0, period, count, endpoint=False))

    def polished(count: int) -> Outcome:
        values, step = samples(count), period / count
        top = int(values.argmax())
        ends = (top - 1) * step, (top + 1) * step
        found = _golden_section(lambda one: largest(np.array([one]))[0], *ends, GOLDEN_STEPS)
        return float(max(values[top], found)), count + GOLDEN_STEPS

    def segment_exact(_: float) -> Outcome:
        peak = peak_force(**law)
        return peak.peak_force_ratio, peak.accuracy.evaluations

    def paper(_: float) -> Outcome:
        return approximate_peak_ratio(pins=pins, satellites=satellites), 1

    def equal_sharing(_: float) -> Outcome:
        return peak_force(mechanism=mechanism, force_exponent=0.0).peak_force_ratio, 1

    def sampled(count: int) -> Outcome:
        return float(samples(count).max()), count

    counts = [count for count in SAMPLES if count * pins * satellites <= MAX_SAMPLED]
    return work_precision(
        reference=Reference("multiple_peak"),
        exact=[_exact_peak(mechanism, force_exponent, angle)],
        methods=[
            Method("sampling", [("points", count) for count in counts], sampled),
            Method("golden_section", [("points", count) for count in POLISHED], polished),
            Method("segment_exact", DEFAULT, segment_exact, chosen=True),
            Method("approximation", DEFAULT, paper),
            Method("equal_sharing", DEFAULT, equal_sharing),
        ],
    )


def _exact_peak(mechanism: Mechanism, force_exponent: float, crank_angle: float) -> Any:
    """Peak in multiple precision, on the piece of the turn where it was found, by the law alone:
    ``c^v / sum c^(1 + v)`` of Yanchevskiy and Niekhoroshykh 2021, eq. (10).
    """
    import mpmath

    with mpmath.workdps(REFERENCE_DIGITS):
        psi = mpmath.mpf(crank_angle) * (1 + 1 / mpmath.mpf(mechanism.ratio))
        start, pitch = mpmath.mpf(mechanism.initial_crank_angle), 2 * mpmath.pi / mechanism.pins
        phases = [
            mpmath.mpf(crank) + start + n * pitch
            for crank in mechanism.crank_angles
            for n in range(mechanism.pins)
        ]

        def force(angle: Any) -> Any:
            sines = [mpmath.sin(angle + phase) for phase in phases]
            cosines = [-sine for sine in sines if sine < 0]  # of the pairs that drive
            best, power = max(cosines), mpmath.mpf(force_exponent)
            return 1 / mpmath.fsum((c / best) ** power * c for c in cosines)

        # The peak lies within rounding of psi: on a kink there, or at a smooth maximum beside it.
        width = mpmath.mpf("1e-7")
        return max(_golden_section(force, psi - width, psi + width, EXACT_STEPS), force(psi))


def real_peak_study(
    *, real: Stage, output_torque: float, over: type[OverTurn] = OverTurn, pins: str = "pins"
) -> WorkPrecision:
    """Error against run time of the peak force over the turn, with clearance and errors; of both
    meshes in series on the pins of the output, over the period after which all repeats.

    Samples miss the peak, always downwards: a bias, not a scatter. One summit narrowed is a
    summit, and not always the highest.

    Parameters
    ----------
    real : Stage
        Pins in holes or a ring on teeth, of at most `MAX_REAL_PAIRS` pairs, or
        `MAX_COMPLIANT_PAIRS` where satellites give or have given shares; both in series, of at most
        `MAX_SERIES_PAIRS`.
    output_torque : float
        Torque T on the output link, N*m, not 0; negative in reverse.
    over : type
        Extremes of such a stage.
    pins : str
        What the number of its pins is called.

    Returns
    -------
    WorkPrecision
        Against four times as many positions as the calculator takes, every summit narrowed.

    Raises
    ------
    InvalidInput
        If there are too many pairs.
    ImpossibleMechanism
        See `Stage.solved`.
    """
    turn: Turn
    if isinstance(real, MeshesInSeries):
        left = MAX_SERIES_PAIRS - real.mechanism.pins * real.mechanism.satellites
        _refuse_many(real.ring.mechanism, left, "ring_teeth")
        turn, over = SeriesTurn(real, output_torque), SeriesOverTurn
        whole = turn.period
    else:
        limit = MAX_COMPLIANT_PAIRS if real.support.gives else MAX_REAL_PAIRS
        _refuse_many(real.mechanism, limit, pins)
        turn, whole = Turn(real, output_torque), 2 * math.pi
    narrow = turn.narrow(turn.force)

    def grid(count: int) -> Grid:
        step = whole / count
        return turn.values(turn.force, [turn.first + step * i for i in range(count)], whole)

    def sampled(count: int) -> Outcome:
        return float(grid(count).heights.max()), count

    def narrowed(count: int) -> Outcome:
        return summits(grid=grid(count), narrow=narrow, most=1)[0].height, count

    def zoomed(_: float) -> Outcome:
        found = over(type(turn)(real, output_torque))
        return found.peak_force, found.accuracy.evaluations

    def dense() -> float:
        even, near = turn.positions()
        step = (even[1] - even[0]) / DENSE
        places = {psi + step * i for psi in even for i in range(DENSE)} | {*near}
        values = turn.values(turn.force, sorted(places), turn.period)
        return all_summits(coarse=values, fine=values, narrow=narrow)[1].height

    return work_precision(
        reference=Reference("sampling_dense", REAL_DIGITS),
        exact=[dense()],
        methods=[
            Method("sampling", [("positions", count) for count in POSITIONS], sampled),
            Method("golden_section", [("positions", count) for count in ZOOMED], narrowed),
            Method("sampling_zoomed", DEFAULT, zoomed, chosen=True),
        ],
    )
