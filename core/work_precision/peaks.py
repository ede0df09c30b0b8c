"""Largest force over the turn: sampling, its rivals, and the calculators' own searches."""

from typing import Any

import numpy as np

from core.errors import InvalidInput
from core.numerics.extremes import other_places
from core.output.contact_force import approximate_peak_ratio, force_ratios, peak_force
from core.output.mechanism import Mechanism
from core.output.over_turn import OverTurn
from core.output.stage import Stage
from core.output.summits import Grid, summits
from core.ring.series import MeshesInSeries
from core.ring.series_turn import SeriesOverTurn
from core.ring.sharing import CycloidMesh, MeshTurn
from core.work_precision.study import (
    REFERENCE_DIGITS,
    Method,
    Outcome,
    Reference,
    WorkPrecision,
    work_precision,
)

MAX_PAIRS = 120
"""Most pairs, of both meshes in series together: seconds where all discs and pins deviate."""

SAMPLES, POSITIONS = (16, 64, 256, 1024, 4096), (24, 60, 120, 360, 720, 1440)
"""Numbers of crank angles of ideal forces, and of positions with clearance."""

DENSE, REAL_DIGITS = 4, 12
"""How many times the calculator's positions the reference with clearance has, and its digits."""

EXACT_STEPS = 130
"""Steps after which a summit is as good as multiple precision can tell, be it smooth or a kink."""


def _refuse_many(mechanism: Mechanism, pins: str = "pins", besides: int = 0) -> None:
    """Refuse more pairs than `MAX_PAIRS` with others besides, by the name of the number of pins."""
    satellites = mechanism.satellites
    if mechanism.pins * satellites + besides > MAX_PAIRS:
        most = {"limit": (MAX_PAIRS - besides) // satellites, "satellites": satellites}
        raise InvalidInput(pins, mechanism.pins, "too_many_pairs", **most)


def peak_force_study(*, mechanism: Mechanism, force_exponent: float = 1.0) -> WorkPrecision:
    """Error against run time of the peak of the contact force.

    Raises InvalidInput for too many pairs, ImpossibleMechanism at a dead centre. Pairs are at most
    `MAX_PAIRS`; the exponent is that of the force over the approach.
    """
    _refuse_many(mechanism)
    pins, satellites = mechanism.pins, mechanism.satellites
    law: dict[str, Any] = {"mechanism": mechanism, "force_exponent": force_exponent}
    peak = peak_force(**law)

    def sampled(count: int) -> Outcome:
        angles = np.linspace(0.0, mechanism.crank_angle_per_wave, count, endpoint=False)
        return float(force_ratios(crank_angles=angles, **law).max()), count

    def approximated(_: float) -> Outcome:
        return approximate_peak_ratio(pins=pins, satellites=satellites), 1

    def searched(_: float) -> Outcome:
        found = peak_force(**law)
        return found.peak_force_ratio, found.accuracy.evaluations

    return work_precision(
        reference=Reference("multiple_peak"),
        exact=_exact_peak(mechanism, force_exponent, peak.peak_crank_angle),
        methods=[
            Method("sampling", sampled, "points", SAMPLES),
            Method("approximation", approximated),
            Method(peak.accuracy.method, searched),
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
        middle, width = psi, mpmath.mpf("2e-7")
        for _ in range(EXACT_STEPS):
            rises = force(middle + width / 20) > force(middle - width / 20)
            middle += 0.225 * width if rises else -0.225 * width  # of the part with the summit
            width *= 0.55
        return max(force(middle), force(psi))


def real_peak_study(*, real: Stage, output_torque: float) -> WorkPrecision:
    """Error against run time of the peak force over the period after which it repeats, with
    clearance and errors; of both meshes in series on the pins of the output.

    Samples miss the peak, always downwards: a bias, not a scatter. One summit narrowed is a summit,
    and not always the highest. The reference has `DENSE` times as many positions as the calculator,
    at other places, and those at dead angles; every summit is narrowed. Raises InvalidInput for too
    many pairs, ImpossibleMechanism as `Stage.solved` does. The torque on the output link, N*m, is
    not 0 and negative in reverse.
    """
    ring = isinstance(real, CycloidMesh)
    _refuse_many(real.mechanism, "ring_teeth" if ring else "pins")
    if isinstance(real, MeshesInSeries):
        own = real.mechanism.pins * real.mechanism.satellites
        _refuse_many(real.ring.mechanism, "ring_teeth", own)

    in_series = isinstance(real, MeshesInSeries)
    kind: type[OverTurn] = SeriesOverTurn if in_series else MeshTurn if ring else OverTurn

    def fresh() -> OverTurn:
        return kind(kind.TURN(real, output_torque))

    turn = fresh().turn
    narrow = turn.narrow(turn.force)

    def grid(count: int) -> Grid:
        places = turn.first + turn.period / count * np.arange(count)
        return turn.values(turn.force, places.tolist(), turn.period)

    def sampled(count: int) -> Outcome:
        return float(grid(count).heights.max()), count

    def narrowed(count: int) -> Outcome:
        return summits(grid=grid(count), narrow=narrow, most=1)[0].height, count

    def zoomed(_: float) -> Outcome:
        found = fresh()
        return found.peak_force, found.accuracy.evaluations

    even, near = turn.positions()
    others = other_places(count=DENSE * len(even), first=turn.first, period=turn.period)
    dense = turn.values(turn.force, sorted([*others.tolist(), *near]), turn.period)
    return work_precision(
        reference=Reference("sampling_dense", REAL_DIGITS),
        exact=max(each.height for each in summits(grid=dense, narrow=narrow)),
        methods=[
            Method("sampling", sampled, "positions", POSITIONS),
            Method("golden_section", narrowed, "positions", POSITIONS),
            Method("sampling_zoomed", zoomed),
        ],
    )
