"""Largest bending stress or slope of pins: positions at equal steps against the search by arcs."""

from functools import partial
from typing import Any, Literal

import numpy as np

from core.arrays import ComplexArray, FloatArray
from core.output.mechanism import Mechanism
from core.output.pin_forces import force_ratios
from core.output.pin_strength import PinStresses, pin_stresses
from core.output.pin_turn import PinTurn, all_pairs, pin_turn
from core.work_precision.study import (
    GOLDEN_STEPS,
    REFERENCE_DIGITS,
    WorkPrecision,
    golden_section,
    measured,
    refuse_many_pairs,
)

MAX_PAIRS = 48
"""Most pairs of a study: each summit of its reference takes some hundred sums over them."""

SAMPLES, POLISHED = (16, 64, 256, 1024, 4096, 16384), (16, 64, 256)

SUMMITS = 8
"""Most summits of the reference; more are only where all are alike."""


PinQuantity = Literal["bending_stress", "slope"]


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
        Pins, satellites, ratio; at most `MAX_PAIRS` pairs.
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
    refuse_many_pairs(mechanism=mechanism, limit=MAX_PAIRS)

    def solve() -> PinStresses:
        pin_turn.cache_clear()  # not what it remembers
        all_pairs.cache_clear()
        return pin_stresses(mechanism=mechanism, force_exponent=force_exponent, **loaded)

    found = solve()
    (case,) = found.cases
    if quantity == "slope":
        arms = found.pin.slopes[int(case.slopes.argmax())] * case.loads.unit
    else:
        (arms,) = found.pin.moments(np.array([case.place]), case.loads.unit)
    # All forces of a satellite are parallel to its crank.
    turned = arms * np.exp(1j * np.array(mechanism.crank_angles))
    pitch = mechanism.crank_angle_per_wave / mechanism.pins

    def largest() -> float:
        (case,) = solve().cases
        return float(case.slopes.max()) if quantity == "slope" else case.bent

    def sizes(angles: FloatArray) -> FloatArray:
        """Of all pins, any of which meets within a pitch what one meets in a turn."""
        ratios = force_ratios(
            mechanism=mechanism, crank_angles=angles, force_exponent=force_exponent
        )
        return np.asarray(np.abs(np.einsum("k,ikn->in", turned, ratios)).max(axis=1))

    def sampled(count: int) -> float:
        return float(sizes(np.linspace(0.0, pitch, count, endpoint=False)).max())

    def polished(count: int) -> float:
        values, step = sizes(np.linspace(0.0, pitch, count, endpoint=False)), pitch / count
        best = int(values.argmax())
        narrowed = golden_section(
            value=lambda angle: float(sizes(np.array([angle]))[0]),
            low=(best - 1) * step,
            high=(best + 1) * step,
            steps=GOLDEN_STEPS,
        )
        return max(float(values[best]), float(narrowed))

    assert isinstance(case.loads.turn, PinTurn)
    exact = [_reference(mechanism, force_exponent, arms, *case.loads.turn.drawn())]
    asked = [("sampling", sampled, count, 0) for count in SAMPLES]
    asked += [("golden_section", polished, count, GOLDEN_STEPS) for count in POLISHED]
    points = [
        measured(
            method=method,
            setting=("points", count),
            calculate=partial(calculate, count),
            exact=exact,
            evaluations=count + more,
        )
        for method, calculate, count, more in asked
    ]
    chosen = measured(
        method=found.method,
        calculate=largest,
        exact=exact,
        evaluations=found.evaluations,
    )
    return WorkPrecision.against("multiple_peak", points=[*points, chosen], chosen=chosen)


def _reference(
    mechanism: Mechanism,
    exponent: float,
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
        cranks = [mpmath.mpf(angle) for angle in mechanism.crank_angles]
        start, pitch = mpmath.mpf(mechanism.initial_crank_angle), 2 * mpmath.pi / mechanism.pins
        phases = [start + angle + n * pitch for angle in cranks for n in range(mechanism.pins)]
        turned = [mpmath.mpf(a) * mpmath.expj(b) for a, b in zip(arms, cranks, strict=True)]
        power = mpmath.mpf(exponent)

        def size(place: Any) -> Any:
            """Of pin 1, the first of each satellite."""
            cosines = [-mpmath.sin(2 * mpmath.pi * place + phase) for phase in phases]
            best = max(cosines)
            shares = [(c / best) ** power if c > 0 else mpmath.mpf(0) for c in cosines]
            own = mpmath.fdot(turned, shares[:: mechanism.pins])
            return abs(own) / mpmath.fdot(shares, cosines)

        # As of the peak force, half the digits of the place give all of it.
        return max(
            golden_section(
                value=size,
                low=mpmath.mpf(around[top]),
                high=mpmath.mpf(around[top + 2]),
                steps=85,
            )
            for top in tops.tolist()
        )
