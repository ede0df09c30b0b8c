"""Pairs of pin and hole that drive over the turn, and the contact force of each pair.

A pair drives through exactly half of each turn of the wave angle, at known angles (see
`core.output.mechanism`). The cyclogram therefore has a closed form and needs no sampling.

The force of a driving pair of pressure angle gamma is

    F_jn = F0 * cos(gamma_jn)^v / sum of cos(gamma)^(1 + v) over the driving pairs,   F0 = T/R

(Yanchevskiy and Niekhoroshykh 2021, eq. 10). Exponent v = 1 is eq. (4) of Yanchevsky et al. 2018,
in which the pin radius cancels out; v = 0 is equal sharing, eq. (1) of Zyl.

The pair with the largest cosine of the pressure angle carries the most. Its force is smooth between
the angles at which a pair starts or stops driving or another pair becomes the best placed. The peak
within each such segment is found exactly (see `core.output.force_laws`), one-sided values at the
ends included, and the largest of all is the peak over the turn.
"""

import itertools
import math
import operator
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Annotated, NamedTuple, NoReturn

import numpy as np

from core.arrays import FloatArray, check_not_negative, check_positive, check_single
from core.errors import Accuracy, ImpossibleMechanism, InvalidInput, Notice, poorly_known
from core.fields import Output, answer, answered
from core.output.driving_set import segments
from core.output.force_laws import force_law
from core.output.mechanism import Mechanism, WavePhases, pressure_cosines
from core.precision import ROUNDING, SAME

MAX_DRIVING_PHASES = 40_000
"""Most driving phases (pairs times wave turns) that one cyclogram lists."""


class DrivingPair(NamedTuple):
    """Driving phases of one pair."""

    satellite: int  # from 1
    pin: int  # from 1
    driving: Annotated[tuple[tuple[float, float], ...], Output("deg", "φ", "2021, eq. 6")]
    """Ranges of crank angle within a period in which the pair drives."""


class CountInterval(NamedTuple):
    """Range of crank angle with one number of driving pairs."""

    start: float  # crank angle, rad
    end: float  # crank angle, rad
    pairs: int  # number of driving pairs


@dataclass(frozen=True, slots=True)
class Cyclogram:
    """Driving phases of all pairs, and the number of driving pairs, over the crank angle."""

    working_phase: float = answer("deg", "", "2018; 2021, eq. 6")
    """Crank angle over which a pair drives without interruption."""
    period: float = answer("deg")
    """Crank angle after which the same pairs drive again."""
    pattern_period: float = answer("deg")
    """Crank angle after which the number of driving pairs repeats."""
    pairs: tuple[DrivingPair, ...] = answer()
    """Pairs of pins and holes, satellite by satellite."""
    driving_count: tuple[CountInterval, ...] = answer()
    """Number of driving pairs over the period of their number."""
    min_driving: int = answer()
    """Fewest pairs that drive together."""
    max_driving: int = answer()
    """Most pairs that drive together."""
    mean_driving: float = answer()
    """Mean number of driving pairs."""
    dead_centres: tuple[float, ...] = answer("deg")
    """Crank angles at which no pair drives."""
    dead_zones: tuple[tuple[float, float], ...] = answer("deg")
    """Ranges of crank angle in which no pair drives."""
    # error of angles and of a pair's total driving angle, over the range
    accuracy: Accuracy = answer()

    @property
    @answered()
    def notices(self) -> tuple[Notice, ...]:
        """Notice if the range is so short that rounding leaves hardly anything known."""
        return poorly_known(self.accuracy)


def cyclogram(*, mechanism: Mechanism, revolutions: float = 1.0) -> Cyclogram:
    """Cyclogram of the pin/hole pairs over a number of crank turns, in closed form.

    A pair of phase ``theta`` drives while ``psi + theta`` lies between pi and 2*pi: through a crank
    angle of ``pi/(1 + 1/u)`` once in each ``2*pi/(1 + 1/u)``. Source: Yanchevskiy and Niekhoroshykh
    2021, eq. (6); eq. (1) of Yanchevsky et al. 2018 has ``initial_crank_angle = pi``. Driving
    phases are cut at the ends of the range, > 0 turns from 0; `InvalidInput` is raised if it is no
    longer than rounding or holds more than `MAX_DRIVING_PHASES`.

    Three pins, two satellites at 120 degrees, u = 20 (2021, fig. 6 b): 2 or 4 pairs drive.

    >>> m = Mechanism.evenly_spaced(pins=3, satellites=2, ratio=20.0, crank_spacing=2*math.pi/3)
    >>> c = cyclogram(mechanism=m)
    >>> c.min_driving, c.max_driving, round(math.degrees(c.working_phase), 6)
    (2, 4, 171.428571)
    """
    if not (0 < revolutions < math.inf):
        raise InvalidInput("revolutions", revolutions, "greater_than", limit=0)
    phases = mechanism.phases
    per_wave = mechanism.crank_angle_per_wave
    shown = _Range(revolutions * 2 * math.pi, per_wave)
    if shown.waves <= SAME:
        shortest = SAME * per_wave / (2 * math.pi)
        raise InvalidInput("revolutions", revolutions, "too_short_range", limit=shortest)
    pair_count = mechanism.pins * mechanism.satellites
    if shown.waves * pair_count > MAX_DRIVING_PHASES:
        raise InvalidInput("revolutions", revolutions, "too_many_phases", limit=MAX_DRIVING_PHASES)
    numbers = _numbers(phases)
    pairs, cut_off = _pairs(phases, shown)
    counts = numbers_of_pairs(pairs, end=shown.end, error=shown.sliver * per_wave / 2)
    driven = math.fsum(stop - start for pair in pairs for start, stop in pair.driving)
    merged = abs(driven - math.fsum((each.end - each.start) * each.pairs for each in counts))
    dead_centres, dead_zones = _dead(phases.dead_zones(), shown)
    return Cyclogram(
        working_phase=per_wave / 2,
        period=per_wave,
        pattern_period=per_wave / (mechanism.pins * phases.symmetry),
        pairs=pairs,
        driving_count=counts,
        min_driving=min(numbers),
        max_driving=max(numbers),
        mean_driving=pair_count / 2,
        dead_centres=dead_centres,
        dead_zones=dead_zones,
        accuracy=Accuracy(
            method="closed_form",
            # The total driving angle of a pair has the errors of all its ends.
            relative_error=ROUNDING * (4 * max(1.0, 1 / shown.waves) + shown.waves)
            + (phases.error + cut_off) / shown.waves
            + merged / (pair_count * shown.end),
            evaluations=pair_count,
        ),
    )


class _Range:
    """Range [0, end] of the crank angle, to which wave positions, in turns, are cut."""

    __slots__ = ("end", "per_wave", "sliver", "waves")

    def __init__(self, end: float, per_wave: float) -> None:
        self.end = end
        self.per_wave = per_wave
        self.waves = end / per_wave
        self.sliver = SAME * max(1.0, self.waves)  # widths up to this are rounding, not shown

    def crank_angle(self, position: float) -> float:
        """Crank angle of a wave position, rad."""
        return position * self.per_wave if position < self.waves else self.end


def _pairs(phases: WavePhases, shown: _Range) -> tuple[tuple[DrivingPair, ...], float]:
    """All pairs with their driving phases, and the largest width cut off as rounding, in turns."""
    pins, waves, per_wave, sliver = phases.pins, shown.waves, shown.per_wave, shown.sliver
    pairs, dropped = [], 0.0
    for j, phase in enumerate(phases.satellite_phase, 1):
        for n in range(pins):
            start = (0.5 - phase - n / pins) % 1.0
            driving = []
            if start - 0.5 > sliver:  # begun before the range
                driving.append((0.0, shown.crank_angle(start - 0.5)))
            elif start > 0.5:
                dropped = max(dropped, start - 0.5)
            whole = math.ceil(waves - sliver - start)
            if whole < waves - start:
                dropped = max(dropped, waves - start - whole)
            for turn in range(whole):
                first = start + turn
                last = first + 0.5
                driving.append((first * per_wave, last * per_wave if last < waves else shown.end))
            pairs.append(DrivingPair(j, n + 1, tuple(driving)))
    return tuple(pairs), dropped


def _dead(
    zones: Sequence[tuple[float, float]], shown: _Range
) -> tuple[tuple[float, ...], tuple[tuple[float, float], ...]]:
    """Dead centres and dead zones of one turn, repeated over the range without rounding, rad."""
    if not zones:
        return (), ()
    cut = []
    for turn in range(-1, math.ceil(shown.waves) + 1):
        for start, stop in zones:
            first, last = max(start + turn, 0.0), min(stop + turn, shown.waves)
            if last - first > shown.sliver or (start == stop and first == last):
                cut.append((shown.crank_angle(first), shown.crank_angle(last)))
    centres = sorted({place for zone in cut for place in zone})
    return tuple(centres), tuple([(start, stop) for start, stop in cut if stop > start])


def _numbers(phases: WavePhases) -> list[int]:
    """Numbers of pairs that drive together, one after another, over one sector."""
    pins, mean = phases.pins, phases.pins * len(phases.satellite_phase) / 2
    changes = [(position, growth) for position, growth in phases.switching() if growth]
    if not changes:
        return [int(mean)]
    starts, growths = zip(*changes, strict=True)
    # The number before the first change is the one with which the mean is half of all pairs.
    first = round(mean + pins * sum(map(operator.mul, growths, starts)))
    return [*itertools.accumulate(growths, initial=first)]


def numbers_of_pairs(
    pairs: Sequence[DrivingPair], *, end: float, error: float
) -> tuple[CountInterval, ...]:
    """Number of pairs that drive from crank angle 0 to `end`, rad; ends closer than twice the error
    are merged.
    """
    changes = sorted(
        change
        for each in pairs
        for start, stop in each.driving
        for change in ((start, 1), (stop, -1))
    )
    counts: list[CountInterval] = []
    begun, number, index = 0.0, 0, 0
    while index < len(changes):
        place, after = changes[index][0], number
        while index < len(changes) and changes[index][0] <= place + 2 * error:
            after, index = after + changes[index][1], index + 1
        if after == number or place <= 2 * error:
            number = after
            continue
        stop = end if place >= end - 2 * error else place
        if stop > begun:
            counts.append(CountInterval(begun, stop, number))
        begun, number = stop, after
    if begun < end:
        counts.append(CountInterval(begun, end, number))
    return tuple(counts)


MAX_FORCE_EXPONENT = 1e6
"""Largest exponent v for which forces are resolved to their stated error."""

APPROXIMATION_PINS = (3, 5)
"""Numbers of pins for which eq. (5) of Yanchevsky et al. 2018 is stated."""

APPROXIMATION_SATELLITES = (1, 2)
"""Numbers of satellites for which eq. (5) of Yanchevsky et al. 2018 is stated."""


def reference_force(*, output_torque: float, pin_circle_radius: float) -> float:
    """Reference force ``F0 = T/R``, N (Yanchevskiy and Niekhoroshykh 2021, eq. 11)."""
    check_positive(pin_circle_radius=pin_circle_radius)
    return output_torque / pin_circle_radius


def output_torque_from_input(*, input_torque: float, ratio: float, efficiency: float) -> float:
    """Torque on the output link ``T = T_in*u*eta``, N*m (Yanchevskiy and Niekhoroshykh 2021, before
    eq. 11), for an efficiency 0 < eta <= 1.
    """
    check_positive(efficiency=efficiency)
    if efficiency > 1:
        raise InvalidInput("efficiency", efficiency, "less_than_equal", limit=1)
    return input_torque * ratio * efficiency


def force_ratios(
    *, mechanism: Mechanism, crank_angles: FloatArray, force_exponent: float = 1.0
) -> FloatArray:
    """Contact force ``F_jn/F0`` of every pair, shape (n, K, N); 0 where a pair does not drive.

    Source: Yanchevskiy and Niekhoroshykh 2021, eq. (10). Cosines are divided by the largest first,
    so that no power of them under- or overflows. Erratum of Yanchevsky et al. 2018 after fig. 6:
    the maxima of the next pairs follow at 180/N degrees of the wave only for K = 2 with odd N, else
    at 360/N. Crank angles are in rad, shape (n,), the exponent v is as in `check_exponent`;
    `ImpossibleMechanism` is raised if no pair drives at one of the angles.

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
    """Approximate peak force over F0: ``(0.8 + 0.05*N)^(2 - K) * 4/(K*N)``.

    Source: Yanchevsky et al. 2018, eq. (5), stated for N = 3..5 and K = 1, 2 (cranks evenly spaced,
    v = 1) with an error below 2 %, which holds. Outside that range the error grows: +10 % at N = 6,
    +20 % at N = 8, +40 % at N = 12 (K = 1).
    """
    return float((0.8 + 0.05 * pins) ** (2 - satellites) * 4 / (satellites * pins))


def approximation_notices(*, mechanism: Mechanism, force_exponent: float) -> tuple[Notice, ...]:
    """Limits of eq. (5) of Yanchevsky et al. 2018 that a mechanism breaks."""
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
    """Raise `InvalidInput` unless the exponent v lies from 0 to `MAX_FORCE_EXPONENT`."""
    check_single(force_exponent=force_exponent)
    check_not_negative(force_exponent=force_exponent)
    if force_exponent > MAX_FORCE_EXPONENT:
        raise InvalidInput(
            "force_exponent", force_exponent, "less_than_equal", limit=MAX_FORCE_EXPONENT
        )


def refuse_dead_centre(crank_angle: float) -> NoReturn:
    """Raise `ImpossibleMechanism` for a dead centre at a crank angle, rad."""
    raise ImpossibleMechanism("dead_centre", {"crank_angle": crank_angle})


EQUAL = 1e-13
"""Peaks closer than this part, or than their errors, are one peak reached more than once."""

PHASE_ROUNDING = 3 * ROUNDING
"""Rounding error of a phase, in turns: of the given angle, of its conversion from degrees over
radians to turns, and of its place within a sector."""

AT_SWITCH = 2 * PHASE_ROUNDING
"""Distance from a switching angle, in turns, that rounding can make. For exponents between 0 and 1,
where a power of a tiny cosine is not small, the cosine is 0 within this distance."""


@dataclass(frozen=True, slots=True)
class PeakForce:
    """Largest contact force of any pair over the turn, and its place."""

    peak_force_ratio: float  # F_max/F0
    peak_crank_angle: float  # smallest one >= 0, rad
    peak_satellite: int  # from 1
    peak_pin: int  # from 1
    accuracy: Accuracy  # error of `peak_force_ratio`


def peak_force(*, mechanism: Mechanism, force_exponent: float = 1.0) -> PeakForce:
    """Exact peak of the contact force over the turn, with its crank angle and its pair.

    The method is in the module's docstring; the force is that of Yanchevskiy and Niekhoroshykh
    2021, eq. (10). Erratum: their remark after eq. (11) that f stays below 1 is false for one
    satellite (1.249 for three pins). `ImpossibleMechanism` is raised if the mechanism has a dead
    centre, or one within rounding, where the force is unbounded; the exponent v is as in
    `check_exponent`.

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
    # Equal peaks (mirror images, repeats) are named by the first after crank angle 0.
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
    """First repeat of a wave position at or after 0, in turns; an error of rounding counts as 0."""
    first = position % repeat
    return first if SAME < first < repeat - SAME else 0.0


def _best_pair(phases: WavePhases, position: float) -> tuple[int, int]:
    """Satellite and pin, from 1, of the first of the best placed pairs at a wave position."""
    places = []
    for satellite, phase in enumerate(phases.satellite_phase):
        off = (0.75 - position - phase) * phases.pins
        # Midway between two pins the first of them is the one to name.
        pin = math.ceil(off - 0.5 - SAME * phases.pins)
        distance = round(abs(off - pin) / phases.pins, 12)
        places.append((distance, satellite, pin % phases.pins))
    _, satellite, pin = min(places)
    return satellite + 1, pin + 1


class PairNumber(NamedTuple):
    """Satellite and pin of a pair."""

    satellite: Annotated[int, Output("", "j")]
    """Number of the satellite, from 1."""
    pin: Annotated[int, Output("", "n")]
    """Number of the pin, from 1."""


@dataclass(frozen=True, slots=True)
class ForceCurves:
    """Contact force of every pair over the turn."""

    pairs: tuple[PairNumber, ...] = answer()
    """Pairs, in the order of the lists of forces."""
    crank_angle: FloatArray = answer("deg", "φ")
    """Crank angles of the curves."""
    force: FloatArray = answer("N", "F_jn", "2021, eq. 10", depth=2)
    """Forces over the crank angles, as one list per pair."""


@dataclass(frozen=True, slots=True)
class ContactForce:
    """Peak contact force of the pairs; curves and other laws are None where not asked for."""

    reference_force: float = answer("N", "F_0", "2018; 2021")
    """Torque over the radius of the pin circle."""
    peak_force: float = answer("N", "F_max", "2021, eq. 10")
    """Largest ideal contact force over the turn, by force_exponent."""
    peak_force_ratio: float = answer("", "f", "2021, eq. 11")
    """Largest contact force over the reference force."""
    peak_crank_angle: float = answer("deg", "φ")
    """Crank angle of the peak."""
    peak_pair: PairNumber = answer()
    """Pair with the largest force."""
    curves: ForceCurves | None = answer()
    """Force of every pair over the turn, if requested."""
    equal_sharing_peak: float | None = answer("N", "F_max", "Zyl, eq. 1")
    """Largest force if all driving pairs carried alike."""
    approximate_peak: float | None = answer("N", "F_max", "2018, eq. 5")
    """Largest force by the approximate formula for 3 to 5 pins."""
    approximate_peak_error: float | None = answer()
    """Approximate over exact peak, less 1."""
    # Relative error of the forces and their ratio: also the absolute error of
    # `approximate_peak_error`; the angle of a smooth peak is known to its square root.
    accuracy: Accuracy = answer()
    # limits of the approximation that are broken; results hardly known
    notices: tuple[Notice, ...] = answer()


@lru_cache(maxsize=1024)
def force_peak(mechanism: Mechanism, force_exponent: float) -> PeakForce:
    """Peak by `peak_force`, kept for later calls, as mechanisms vary less often than sizes."""
    return peak_force(mechanism=mechanism, force_exponent=force_exponent)


def contact_force(
    *,
    mechanism: Mechanism,
    output_torque: float,
    pin_circle_radius: float,
    force_exponent: float = 1.0,
    curve_samples: int | None = None,
    equal_sharing: bool = False,
    approximation: bool = False,
) -> ContactForce:
    """Exact peak of the contact force of the pairs, and further results where asked for.

    Sources are eq. (10) of Yanchevskiy and Niekhoroshykh 2021, eq. (5) of Yanchevsky et al. 2018,
    and eq. (1) of Zyl, which is eq. (10) with the exponent 0. `ImpossibleMechanism` is raised if
    the mechanism has a dead centre. The exponent v is as in `check_exponent`. Curves of the forces
    have `curve_samples` even crank angles from 0 to a full turn, at least 2; the peaks of Zyl and
    of eq. (5) come if asked for.

    Zyl's example: T = 50 N*m, R = 32.5 mm, six pins, one satellite: 888.23 N.

    >>> m = Mechanism.evenly_spaced(pins=6, satellites=1, ratio=20.0)
    >>> force = contact_force(mechanism=m, output_torque=50.0, pin_circle_radius=0.0325,
    ...                       equal_sharing=True)
    >>> round(force.equal_sharing_peak, 2), round(force.peak_force, 2)
    (888.23, 1025.64)
    """
    reference = reference_force(output_torque=output_torque, pin_circle_radius=pin_circle_radius)
    check_single(
        force_exponent=force_exponent,
        output_torque=output_torque,
        pin_circle_radius=pin_circle_radius,
    )
    peak = force_peak(mechanism, force_exponent)
    curves = None
    if curve_samples is not None:
        if curve_samples < 2:
            raise InvalidInput("samples", curve_samples, "greater_than_equal", limit=2)
        curves = force_curves(
            mechanism=mechanism,
            crank_angle=np.linspace(0.0, 2 * math.pi, curve_samples),
            reference=reference,
            force_exponent=force_exponent,
        )
    error = peak.accuracy.relative_error
    equal_peak = approximate_peak = approximate_error = None
    notices: tuple[Notice, ...] = ()
    if equal_sharing:
        equal = force_peak(mechanism, 0.0)
        equal_peak = reference * equal.peak_force_ratio
        error = max(error, equal.accuracy.relative_error)
    if approximation:
        ratio = approximate_peak_ratio(pins=mechanism.pins, satellites=mechanism.satellites)
        approximate_peak = reference * ratio
        approximate_error = ratio / peak.peak_force_ratio - 1
        notices = approximation_notices(mechanism=mechanism, force_exponent=force_exponent)
    # rounding of T, u, eta and R, of their products and of their conversion to SI units
    error += 5 * ROUNDING
    accuracy = Accuracy(peak.accuracy.method, error, peak.accuracy.evaluations)
    return ContactForce(
        reference_force=reference,
        peak_force=reference * peak.peak_force_ratio,
        peak_force_ratio=peak.peak_force_ratio,
        peak_crank_angle=peak.peak_crank_angle,
        peak_pair=PairNumber(peak.peak_satellite, peak.peak_pin),
        curves=curves,
        equal_sharing_peak=equal_peak,
        approximate_peak=approximate_peak,
        approximate_peak_error=approximate_error,
        accuracy=accuracy,
        notices=notices + poorly_known(accuracy),
    )


def force_curves(
    *, mechanism: Mechanism, crank_angle: FloatArray, reference: float, force_exponent: float
) -> ForceCurves:
    """Force of every pair at crank angles, rad, shape (n,), for a reference force F0, N."""
    ratios = force_ratios(
        mechanism=mechanism, crank_angles=crank_angle, force_exponent=force_exponent
    )
    pairs = tuple(
        PairNumber(satellite + 1, pin + 1)
        for satellite in range(mechanism.satellites)
        for pin in range(mechanism.pins)
    )
    return ForceCurves(
        pairs=pairs,
        crank_angle=crank_angle,
        force=reference * ratios.transpose(1, 2, 0).reshape(len(pairs), len(crank_angle)),
    )


def drawing_angles(*, mechanism: Mechanism, samples: int = 361) -> tuple[FloatArray, FloatArray]:
    """Crank angles for a plot of forces over the turn, and the switching angles among them, rad.

    The angles are evenly spaced, with both sides of every switching angle added. They cover one
    turn, or 12 periods of a pair where the turn has more than 60.
    """
    period = mechanism.crank_angle_per_wave
    end = 2 * math.pi if period >= 2 * math.pi / 60 else 12 * period
    sector = period / mechanism.pins
    first = period * np.array([position for position, _ in mechanism.phases.switching()])
    switching = np.add.outer(sector * np.arange(math.ceil(end / sector)), first).ravel()
    switching = switching[switching <= end]
    beside = 1e-9 * period
    before, after = np.maximum(switching - beside, 0.0), np.minimum(switching + beside, end)
    angles = np.concatenate((np.linspace(0.0, end, samples), before, after))
    angles.sort()
    return angles, switching
