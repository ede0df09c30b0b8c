"""Exact peak of the contact force over the turn, for any force exponent.

At any position the pair with the largest cosine of the pressure angle carries the most. Between
the angles at which a pair starts or stops driving, or another pair becomes the best placed,
everything is smooth: there the peak is found exactly, and the largest of these is the peak over
the turn.
"""

import math
from dataclasses import dataclass

from core.output.driving_set import segments
from core.output.force_laws import force_law
from core.output.mechanism import Mechanism, WavePhases
from core.output.pin_forces import check_exponent, refuse_dead_centre
from core.precision import ROUNDING, SAME
from core.results import Accuracy

EQUAL = 1e-13
"""Peaks closer than this, or than their errors, are one peak reached more than once."""

PHASE_ROUNDING = 3 * ROUNDING
"""Error of a phase by rounding, in turns: of the angle given, its way from degrees over radians to
turns, and its place within a sector."""


@dataclass(frozen=True, slots=True)
class PeakForce:
    """Largest contact force of any pair over the turn."""

    peak_force_ratio: float  # F_max/F0
    peak_crank_angle: float  # smallest one >= 0, rad
    peak_satellite: int  # from 1
    peak_pin: int  # from 1
    accuracy: Accuracy  # of `peak_force_ratio`


def peak_force(*, mechanism: Mechanism, force_exponent: float = 1.0) -> PeakForce:
    """Exact peak of the contact force over the turn, with its position and its pair.

    Between two neighbouring switching angles the set of driving pairs is constant; within it
    the best placed pair p has ``f = cos(x)^v / sum cos(x + d_i)^(1 + v)`` where x is its own
    pressure angle and d_i are the phases of the others against it. With t = tan(x) the
    stationary points for v = 1 are the roots of ``P*t^3 + (3*P - n)*t - 2*Q = 0``,
    ``P = sum sin^2 d_i``, ``Q = sum sin d_i cos d_i``; for v = 0 there is none inside, and the
    peak lies on a switching angle. One-sided values at the switching angles count.

    Parameters
    ----------
    mechanism : Mechanism
        Pins, satellites, ratio.
    force_exponent : float
        Exponent v of the force over the approach, from 0 to `MAX_FORCE_EXPONENT`.

    Returns
    -------
    PeakForce

    Raises
    ------
    InvalidInput
        If the exponent is negative or above `MAX_FORCE_EXPONENT`.
    ImpossibleMechanism
        If the mechanism has a dead centre, or one within rounding: there the force would be
        unbounded.

    Notes
    -----
    Source of the force: Yanchevskiy and Niekhoroshykh 2021, eq. (10). Erratum: their remark
    after eq. (11) that f stays below 1 is false for one satellite (1.249 for three pins).

    Examples
    --------
    Three pins, one satellite; and two satellites at 180 degrees: 2/3 exactly.

    >>> one = Mechanism.evenly_spaced(pins=3, satellites=1, ratio=20.0)
    >>> round(peak_force(mechanism=one).peak_force_ratio, 13)
    1.2492332112159
    >>> two = Mechanism.evenly_spaced(pins=3, satellites=2, ratio=20.0)
    >>> peak_force(mechanism=two).peak_force_ratio == 2/3
    True
    """
    check_exponent(force_exponent)
    phases = mechanism.phases
    zones = phases.dead_zones()
    if zones:
        refuse_dead_centre(zones[0][0] * mechanism.crank_angle_per_wave)
    distinct = len(phases.sector_phases)
    if force_exponent == 1 and distinct == phases.symmetry and distinct * phases.pins % 2 == 0:
        return _evenly_spaced_peak(mechanism)

    parts = list(segments(phases))
    law = force_law(parts=parts, exponent=force_exponent)
    candidates = law.candidates()
    ratio, winner, offset = max(candidates)
    error = law.relative_error(winner, offset, PHASE_ROUNDING + phases.error)
    # Of equal peaks (mirror images, repeats) the first after crank angle 0 is the one to name.
    repeat = 1 / (phases.pins * phases.symmetry)
    position = min(
        _first_repeat(place + 0.75 - parts[index].phase, repeat)
        for value, index, place in candidates
        if value >= ratio * (1 - max(EQUAL, error))
    )
    if not error < 1:  # a dead centre within the rounding of the phases
        refuse_dead_centre(position * mechanism.crank_angle_per_wave)
    satellite, pin = _best_pair(phases, position)
    return PeakForce(
        peak_force_ratio=ratio,
        peak_crank_angle=position * mechanism.crank_angle_per_wave,
        peak_satellite=satellite,
        peak_pin=pin,
        accuracy=Accuracy(method=law.method, relative_error=error, evaluations=len(candidates)),
    )


def _evenly_spaced_peak(mechanism: Mechanism) -> PeakForce:
    """Peak for v = 1 and an even number m of evenly spaced phases, c pairs on each: 4/(c*m)."""
    phases = mechanism.phases
    pairs = mechanism.pins * mechanism.satellites
    position = _first_repeat(0.75 - phases.sector_phases[0], 1 / (phases.pins * phases.symmetry))
    satellite, pin = _best_pair(phases, position)
    return PeakForce(
        peak_force_ratio=4 / pairs,
        peak_crank_angle=position * mechanism.crank_angle_per_wave,
        peak_satellite=satellite,
        peak_pin=pin,
        accuracy=Accuracy(
            method="closed_form_even",
            relative_error=ROUNDING + 4 * math.pi * phases.error,
            evaluations=1,
        ),
    )


def _first_repeat(position: float, repeat: float) -> float:
    """First repeat of a wave position at or after 0; a rounding error beside a repeat is 0."""
    first = position % repeat
    return first if SAME < first < repeat - SAME else 0.0


def _best_pair(phases: WavePhases, position: float) -> tuple[int, int]:
    """Numbers of the best placed pair at a wave position, the first of equals."""
    places = []
    for satellite, phase in enumerate(phases.satellite_phase):
        off = (0.75 - position - phase) * phases.pins
        # Midway between two pins the first of them is the one to name.
        pin = math.ceil(off - 0.5 - SAME * phases.pins)
        distance = round(abs(off - pin) / phases.pins, 12)
        places.append((distance, satellite, pin % phases.pins))
    _, satellite, pin = min(places)
    return satellite + 1, pin + 1
