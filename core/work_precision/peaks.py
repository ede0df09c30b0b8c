"""Largest values over the turn: sampling, polished sampling, and the calculators' own searches."""

import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any, Literal

import numpy as np

from core.arrays import ComplexArray, FloatArray, Number
from core.output.contact_force import approximate_peak_ratio, force_ratios, peak_force
from core.output.edge_load import IDLE, SlopingContacts
from core.output.loop_rows import FORCE
from core.output.mechanism import Mechanism
from core.output.over_turn import OverTurn
from core.output.pin_strength import PinStresses, pin_stresses
from core.output.pin_turn import PinTurn, all_pairs, pin_turn
from core.output.stage import Stage
from core.output.summits import Grid, all_summits, summits
from core.output.turn import Turn
from core.ring.series import MeshesInSeries
from core.ring.series_turn import SeriesOverTurn, SeriesTurn
from core.work_precision.exact import pair_forces, pair_phases
from core.work_precision.study import (
    DEFAULT,
    REFERENCE_DIGITS,
    Method,
    Outcome,
    Reference,
    WorkPrecision,
    refuse_many_pairs,
    work_precision,
)

MAX_PAIRS = 300
"""Most pairs of the study of the peak force: its reference and its samples grow with them."""

MAX_PIN_PAIRS = 48
"""Most pairs of that of the pins: each summit of its reference takes some hundred sums over
them."""

MAX_REAL_PAIRS = 36
"""Most pairs of that with clearance: it solves some twenty thousand positions."""

MAX_COMPLIANT_PAIRS = 9
"""The same with compliant satellites, which takes four times as long."""

SAMPLES = (16, 64, 256, 1024, 4096, 16384, 65536)
POLISHED = (16, 64, 256)

MAX_SAMPLED = 2_000_000
"""Most forces that are sampled at once."""

MAX_SERIES_PAIRS = 60
"""The same of both meshes in series, of both together."""

POSITIONS = (24, 60, 120, 360, 720, 1440, 2880)
ZOOMED = (24, 60, 120, 360, 720)
DENSE = 4
"""How many times as many positions as the calculator's the reference with clearance has."""

REAL_DIGITS = 12
"""Digits of that reference."""

GOLDEN_STEPS = 40
"""Steps after which a summit is as good as doubles can tell."""

EXACT_STEPS = 85
"""Steps in multiple precision: a value is stationary at its summit, so half the digits of the place
give all of it."""

SUMMITS = 8
"""Most summits of a reference of the pins; more are only where all are alike."""

PinQuantity = Literal["bending_stress", "slope"]


def golden_section(*, value: Callable[[Any], Any], low: Any, high: Any, steps: int) -> Any:
    """Largest value between two places, by golden-section search.

    Parameters
    ----------
    value : callable
        Of a place.
    low, high : float or mpmath number
        Ends, about one summit.
    steps : int
        Steps.

    Returns
    -------
    float or mpmath number
    """
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


def _polished(
    largest: Callable[[FloatArray], FloatArray], period: float, count: int, most: int
) -> float:
    """Largest of samples at equal steps over a period, so many of the highest summits narrowed."""
    values, step = largest(np.linspace(0.0, period, count, endpoint=False)), period / count
    tops = np.flatnonzero((values >= np.roll(values, 1)) & (values >= np.roll(values, -1)))
    tops = tops[np.argsort(-values[tops], kind="stable")[:most]]
    narrowed = [
        golden_section(
            value=lambda angle: float(largest(np.array([angle]))[0]),
            low=(top - 1) * step,
            high=(top + 1) * step,
            steps=GOLDEN_STEPS,
        )
        for top in tops.tolist()
    ]
    return float(max(values.max(), *narrowed))


def _by_samples(
    largest: Callable[[FloatArray], FloatArray], period: float, samples: Sequence[int]
) -> list[Method]:
    """Equal steps over a period, and the best of them polished; of the largest value at crank
    angles, shape (n,).
    """

    def sampled(count: int) -> Outcome:
        return float(largest(np.linspace(0.0, period, count, endpoint=False)).max()), count

    def polished(count: int) -> Outcome:
        return _polished(largest, period, count, 1), count + GOLDEN_STEPS

    return [
        Method("sampling", [("points", count) for count in samples], sampled),
        Method("golden_section", [("points", count) for count in POLISHED], polished),
    ]


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
    refuse_many_pairs(mechanism=mechanism, limit=MAX_PAIRS)
    pins, satellites = mechanism.pins, mechanism.satellites
    angle = peak_force(mechanism=mechanism, force_exponent=force_exponent).peak_crank_angle

    def largest(angles: FloatArray) -> FloatArray:
        ratios = force_ratios(
            mechanism=mechanism, crank_angles=angles, force_exponent=force_exponent
        )
        return np.asarray(ratios.max(axis=(1, 2)))

    def segment_exact(_: float) -> Outcome:
        peak = peak_force(mechanism=mechanism, force_exponent=force_exponent)
        return peak.peak_force_ratio, peak.accuracy.evaluations

    def approximation(_: float) -> Outcome:
        return approximate_peak_ratio(pins=pins, satellites=satellites), 1

    def equal_sharing(_: float) -> Outcome:
        return peak_force(mechanism=mechanism, force_exponent=0.0).peak_force_ratio, 1

    samples = [count for count in SAMPLES if count * pins * satellites <= MAX_SAMPLED]
    return work_precision(
        reference=Reference("multiple_peak"),
        exact=[_exact_peak(mechanism, force_exponent, angle)],
        methods=[
            *_by_samples(largest, mechanism.crank_angle_per_wave, samples),
            Method("segment_exact", DEFAULT, segment_exact, chosen=True),
            Method("approximation", DEFAULT, approximation),
            Method("equal_sharing", DEFAULT, equal_sharing),
        ],
    )


def _exact_peak(mechanism: Mechanism, force_exponent: float, crank_angle: float) -> Any:
    """Peak in multiple precision, on the piece of the turn where it was found."""
    import mpmath

    with mpmath.workdps(REFERENCE_DIGITS):
        phases = pair_phases(mechanism)
        psi = mpmath.mpf(crank_angle) * (1 + 1 / mpmath.mpf(mechanism.ratio))

        def force(angle: Any) -> Any:
            forces, _ = pair_forces(phases=phases, force_exponent=force_exponent, wave_angle=angle)
            return max(map(max, forces))

        # The peak lies within rounding of psi: on a kink there, or at a smooth maximum beside it.
        width = mpmath.mpf("1e-7")
        polished = golden_section(value=force, low=psi - width, high=psi + width, steps=EXACT_STEPS)
        return max(polished, force(psi))


def pin_bending_study(
    *,
    mechanism: Mechanism,
    force_exponent: float = 1.0,
    quantity: PinQuantity = "bending_stress",
    **loaded: Any,
) -> WorkPrecision:
    """Error against run time of the largest bending stress of the pins in its section, or of their
    largest slope in the middle of a satellite.

    Parameters
    ----------
    mechanism : Mechanism
        Pins, satellites, ratio; at most `MAX_PIN_PAIRS` pairs.
    force_exponent : float
        Exponent v of the force over the approach.
    quantity : {"bending_stress", "slope"}
        Which of them.
    **loaded
        What `core.output.pin_strength.pin_stresses` takes; of ideal forces that are shared equally.

    Returns
    -------
    WorkPrecision
        The calculator's method looks for the section or the satellite as well, and for all else of
        the pins.

    Raises
    ------
    InvalidInput
        If there are too many pairs.
    ImpossibleMechanism
        If the mechanism has a dead centre.
    """
    refuse_many_pairs(mechanism=mechanism, limit=MAX_PIN_PAIRS)

    def solve() -> PinStresses:
        _forget()
        return pin_stresses(mechanism=mechanism, force_exponent=force_exponent, **loaded)

    result = solve()
    (case,) = result.cases
    assert isinstance(case.loads.turn, PinTurn)
    if quantity == "slope":
        arms = result.pin.slopes[int(case.slopes.argmax())] * case.loads.unit
    else:
        (arms,) = result.pin.moments(np.array([case.place]), case.loads.unit)
    # All forces of a satellite are parallel to its crank.
    turned = arms * np.exp(1j * np.array(mechanism.crank_angles))

    def largest(angles: FloatArray) -> FloatArray:
        """Of all pins, any of which meets within a pitch what one meets in a turn."""
        ratios = force_ratios(
            mechanism=mechanism, crank_angles=angles, force_exponent=force_exponent
        )
        return np.asarray(np.abs(np.einsum("k,ikn->in", turned, ratios)).max(axis=1))

    def search(_: float) -> Outcome:
        result = solve()
        (case,) = result.cases
        value = float(case.slopes.max()) if quantity == "slope" else case.bent
        return value, result.evaluations

    pitch = mechanism.crank_angle_per_wave / mechanism.pins
    return work_precision(
        reference=Reference("multiple_peak"),
        exact=[_exact_bending(mechanism, force_exponent, arms, *case.loads.turn.drawn())],
        methods=[
            *_by_samples(largest, pitch, SAMPLES[:-1]),
            Method(result.method, DEFAULT, search, chosen=True),
        ],
    )


def _exact_bending(
    mechanism: Mechanism,
    force_exponent: float,
    arms: FloatArray,
    places: FloatArray,
    forces: ComplexArray,
) -> Any:
    """The largest in multiple precision, by the law of the forces, about the summits of the forces
    (K, n) at places in turns of the wave.
    """
    import mpmath

    unique, first = np.unique(places, return_index=True)
    heights = np.maximum.reduceat(np.abs(arms @ forces), first)
    tops = np.flatnonzero((heights >= np.roll(heights, 1)) & (heights >= np.roll(heights, -1)))
    tops = tops[np.argsort(-heights[tops], kind="stable")[:SUMMITS]]
    around = np.concatenate(([unique[-1] - 1], unique, [unique[0] + 1]))
    with mpmath.workdps(REFERENCE_DIGITS):
        phases = pair_phases(mechanism)
        turned = [
            mpmath.mpf(arm) * mpmath.expj(angle)
            for arm, angle in zip(arms, mechanism.crank_angles, strict=True)
        ]

        def size(place: Any) -> Any:
            """Of pin 1, the first of each satellite."""
            forces, _ = pair_forces(
                phases=phases, force_exponent=force_exponent, wave_angle=2 * mpmath.pi * place
            )
            return abs(mpmath.fdot(turned, [own[0] for own in forces]))

        return max(
            golden_section(
                value=size,
                low=mpmath.mpf(around[top]),
                high=mpmath.mpf(around[top + 2]),
                steps=EXACT_STEPS,
            )
            for top in tops.tolist()
        )


def edge_load_study(
    *,
    mechanism: Mechanism,
    force_exponent: float = 1.0,
    edge_length: float,
    compliance: Callable[[Number], Number],
    **loaded: Any,
) -> WorkPrecision:
    """Error against run time of the largest line load at an end of a contact whose pin slopes.

    Parameters
    ----------
    mechanism : Mechanism
        Pins, satellites, ratio; at most `MAX_PIN_PAIRS` pairs.
    force_exponent : float
        Exponent v of the force over the approach.
    edge_length : float
        Length b of a contact, m, > 0.
    compliance : callable
        Approach of a level contact over its force, m/N, of forces, N.
    **loaded
        What `core.output.pin_strength.pin_stresses` takes; of ideal forces that are shared equally.

    Returns
    -------
    WorkPrecision
        Against four times as many positions as the most that are sampled, every summit narrowed.

    Raises
    ------
    InvalidInput
        If there are too many pairs.
    ImpossibleMechanism
        If the mechanism has a dead centre.
    """
    refuse_many_pairs(mechanism=mechanism, limit=MAX_PIN_PAIRS)
    forces: dict[str, Any] = {"mechanism": mechanism, "force_exponent": force_exponent}
    stresses = pin_stresses(**forces, **loaded)
    pin, (loads,) = stresses.pin, stresses.loads
    contacts = SlopingContacts(pin, [loads], edge_length, compliance)
    cranks = loads.unit * np.exp(1j * np.array(mechanism.crank_angles))
    pitch = mechanism.crank_angle_per_wave / mechanism.pins

    def largest(angles: FloatArray) -> FloatArray:
        """Of all pins, any of which meets within a pitch what one meets in a turn."""
        own = cranks[:, None] * force_ratios(crank_angles=angles, **forces)
        size = np.maximum(np.abs(own), IDLE * abs(loads.unit))
        turned = np.einsum("jk,ikn->ijn", pin.slopes, own)
        even = contacts.even(size, np.abs((turned * own.conj()).real) / size)
        return np.asarray(np.max(even, axis=(1, 2)))

    def search(_: float) -> Outcome:
        evaluations = 0

        def counted(force: Number) -> Number:
            nonlocal evaluations
            evaluations += np.size(force)
            return compliance(force)

        _forget()
        anew = replace(loads, turn=pin_turn(mechanism, force_exponent))
        edge = SlopingContacts(pin, [anew], edge_length, counted).largest()
        return edge.force, evaluations

    return work_precision(
        reference=Reference("sampling_dense", REAL_DIGITS),
        exact=[_polished(largest, pitch, SAMPLES[-1], SUMMITS)],
        methods=[
            *_by_samples(largest, pitch, SAMPLES[:-1]),
            Method("segments_sampled", DEFAULT, search, chosen=True),
        ],
    )


def _forget() -> None:
    """Forget what calculators remember of pins, so that a search costs what it does at first."""
    pin_turn.cache_clear()
    all_pairs.cache_clear()


def real_turn(*, real: Stage, output_torque: float, pins: str = "pins") -> Turn:
    """The turn that a study looks at, of no more pairs than its reference can.

    Parameters
    ----------
    real : Stage
        Pins in holes or a ring on teeth, of at most `MAX_REAL_PAIRS` pairs, or
        `MAX_COMPLIANT_PAIRS` where satellites give or have given shares; both in series, of at most
        `MAX_SERIES_PAIRS`.
    output_torque : float
        Torque T on the output link, N*m, not 0; negative in reverse.
    pins : str
        What the number of its pins is called.

    Returns
    -------
    Turn

    Raises
    ------
    InvalidInput
        If there are too many pairs.
    """
    if isinstance(real, MeshesInSeries):
        left = MAX_SERIES_PAIRS - real.mechanism.pins * real.mechanism.satellites
        refuse_many_pairs(mechanism=real.ring.mechanism, limit=left, pins="ring_teeth")
        return SeriesTurn(real, output_torque)
    limit = MAX_COMPLIANT_PAIRS if real.support.first_order else MAX_REAL_PAIRS
    refuse_many_pairs(mechanism=real.mechanism, limit=limit, pins=pins)
    return Turn(real, output_torque)


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
        As `real_turn`.
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
    turn = real_turn(real=real, output_torque=output_torque, pins=pins)
    narrow, whole, extremes = turn.narrow(FORCE), 2 * math.pi, over
    if isinstance(turn, SeriesTurn):
        whole, extremes = turn.period, SeriesOverTurn

    def grid(count: int) -> Grid:
        step = whole / count
        return turn.values(FORCE, [turn.first + step * i for i in range(count)], whole)

    def sampled(count: int) -> Outcome:
        return float(grid(count).heights.max()), count

    def narrowed(count: int) -> Outcome:
        return summits(grid=grid(count), narrow=narrow, most=1)[0].height, count

    def zoomed(_: float) -> Outcome:
        found = extremes(type(turn)(real, output_torque))
        return found.peak_force, found.accuracy.evaluations

    def dense() -> float:
        even, near = turn.positions()
        step = (even[1] - even[0]) / DENSE
        places = {psi + step * i for psi in even for i in range(DENSE)} | {*near}
        values = turn.values(FORCE, sorted(places), turn.period)
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
