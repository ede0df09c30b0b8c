"""Exact peak of the contact force for arrays of mechanisms with the same numbers of pairs.

The segments of the turn are those of `core.driving_set`, here over one sector of the wave with
all satellites apart. With t = tan(pressure angle of the best placed pair) another pair's cosine
over the best one's is u = cos(d) - t*sin(d), linear in t, and the force ratio is

    f = sqrt(1 + t^2)/sum(u^(1 + v))

Arrays have the designs as their last axis, for it is the longest.
"""

import math
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from core.contact_force import MAX_FORCE_EXPONENT, FloatArray
from core.designs.checks import check_finite, check_positive, first_where
from core.errors import InvalidInput
from core.mechanism import SAME_PHASE
from core.results import ROUNDING

IntArray = NDArray[np.intp]

CHUNK = 50_000
"""About how many cosines are worked on at once: enough to pay, few enough for the cache."""

SLIVER = 4 * ROUNDING
"""Width below which a segment is nothing but rounding, in turns."""

EQUAL = 1e-13
"""Peaks closer than this, or than their errors, are one peak reached more than once."""

RESOLUTION = 1e-11
"""Share of its bracket to which a peak is located: its height is then right to rounding."""

SPLITS = 50
"""Most halvings of a stretch in which a peak may hide."""


@dataclass(frozen=True, slots=True)
class PeakForces:
    """Largest contact force of any pair over the turn, for each design.

    Attributes
    ----------
    peak_force_ratio : array, shape (n,)
        Peak force over the reference force F0, dimensionless.
    peak_crank_angle : array, shape (n,)
        Smallest crank angle >= 0 at which it is reached, rad.
    peak_satellite, peak_pin : array of int, shape (n,)
        Numbers of the pair that carries it there, from 1.
    relative_error : array, shape (n,)
        Bound of the relative error of `peak_force_ratio`.
    evaluations : array of int, shape (n,)
        Places at which the force was calculated.
    """

    peak_force_ratio: FloatArray
    peak_crank_angle: FloatArray
    peak_satellite: IntArray
    peak_pin: IntArray
    relative_error: FloatArray
    evaluations: IntArray


def peak_forces(
    *,
    pins: int,
    crank_angles: FloatArray,
    ratio: FloatArray,
    force_exponent: FloatArray,
    initial_crank_angle: FloatArray,
) -> PeakForces:
    """Exact peak of the contact force over the turn, for arrays of mechanisms.

    Parameters
    ----------
    pins : int
        Number of pins N of every design, at least 3: with fewer a design may have a dead
        centre, see `core.peak_force`.
    crank_angles : array, shape (n, K)
        Angle of each satellite's crank, rad.
    ratio : array, shape (n,)
        Ratio u > 0.
    force_exponent : array, shape (n,)
        Exponent v of the force over the approach.
    initial_crank_angle : array, shape (n,)
        Wave angle at crank angle 0, rad.

    Returns
    -------
    PeakForces

    Raises
    ------
    InvalidInput
        If there are fewer than three pins, or an entry is out of range; its index is named.

    Notes
    -----
    Source of the force: Yanchevskiy and Niekhoroshykh 2021, eq. (10), as in `core.peak_force`.
    For v = 1 and an even number of pins the sum of the squared cosines is constant and the peak
    4/(K*N); for an odd one the peaks inside segments are roots of a cubic. For other exponents a
    stretch is halved as long as neither its force can be shown to stay below the largest found
    so far, nor its slope to keep its sign.

    Examples
    --------
    Three pins, two satellites at 180 and at 90 degrees.

    >>> found = peak_forces(pins=3, crank_angles=np.array([[0, np.pi], [0, np.pi/2]]),
    ...                     ratio=np.full(2, 20.0), force_exponent=np.ones(2),
    ...                     initial_crank_angle=np.zeros(2))
    >>> found.peak_force_ratio.round(12).tolist()
    [0.666666666667, 0.694199805444]
    """
    if pins < 3:
        raise InvalidInput("pins", pins, "must be at least 3 for an array of designs")
    check_finite(crank_angles=crank_angles, initial_crank_angle=initial_crank_angle, ratio=ratio)
    check_positive(ratio=ratio)
    outside = ~((force_exponent >= 0) & (force_exponent <= MAX_FORCE_EXPONENT))
    if (index := first_where(outside)) is not None:
        limit = f"must lie from 0 to {MAX_FORCE_EXPONENT:g}"
        raise InvalidInput(f"force_exponent[{index}]", force_exponent[index], limit)
    count, satellites = crank_angles.shape
    found = PeakForces(
        np.empty(count),
        np.empty(count),
        np.empty(count, dtype=np.intp),
        np.empty(count, dtype=np.intp),
        np.empty(count),
        np.empty(count, dtype=np.intp),
    )
    linear = force_exponent == 1
    linear_law = _linear if pins % 2 else _constant_sum
    for law, rows in ((linear_law, np.flatnonzero(linear)), (_power, np.flatnonzero(~linear))):
        step = max(1, CHUNK // (satellites * satellites * 3 * (pins if law is _power else 1)))
        for first in range(0, len(rows), step):
            some = rows[first : first + step]
            phases = _phases(pins, crank_angles[some].T, initial_crank_angle[some])
            peak = law(phases, force_exponent[some])
            pair = _best_pair(phases, peak.place)
            for name, each in (
                ("peak_force_ratio", peak.ratio),
                ("peak_crank_angle", peak.place * 2 * math.pi * ratio[some] / (1 + ratio[some])),
                ("peak_satellite", pair[0] + 1),
                ("peak_pin", pair[1] + 1),
                ("relative_error", peak.error),
                ("evaluations", peak.evaluations),
            ):
                getattr(found, name)[some] = each
    return found


class _Phases(NamedTuple):
    """Phases of the satellites, shape (K, n), in turns; compare `core.mechanism.WavePhases`."""

    pins: int
    satellite: FloatArray  # of the pair with pin 1, in [0, 1)
    sector: FloatArray  # within a sector [0, 1/N)
    error: FloatArray  # shape (n,): by how much they may be elsewhere


def _phases(pins: int, crank_angles: FloatArray, initial: FloatArray) -> _Phases:
    """Phases of designs, those that differ by rounding made one; as `WavePhases.of`."""
    cells = pins if pins % 2 == 0 else 2 * pins
    turn = 2 * math.pi
    scaled = (np.fmod(crank_angles, turn) / turn + np.fmod(initial, turn) / turn) * cells
    cell = np.floor(scaled)
    residue = scaled - cell
    tolerance = SAME_PHASE * cells
    order = np.argsort(residue, axis=0)
    ascending = np.take_along_axis(residue, order, axis=0)
    wrapped = np.zeros_like(ascending)
    snapped = np.zeros(crank_angles.shape[1])
    lowest = representative = ascending[0].copy()
    for j in range(1, len(ascending)):
        own = ascending[j].copy()
        wraps = (own > 1 - tolerance) & (lowest <= tolerance)
        joins = ~wraps & (own - representative <= tolerance)
        wrapped[j] = wraps
        ascending[j] = np.where(wraps, lowest, np.where(joins, representative, own))
        snapped = np.maximum(snapped, np.abs(ascending[j] + wraps - own))
        representative = np.where(wraps | joins, representative, own)
    np.put_along_axis(residue, order, ascending, axis=0)
    carried = np.empty_like(wrapped)
    np.put_along_axis(carried, order, wrapped, axis=0)
    cell += carried
    return _Phases(
        pins=pins,
        satellite=(cell % cells + residue) / cells,
        sector=(cell % (cells // pins) + residue) / cells,
        error=2 * ROUNDING + snapped / cells,
    )


class _Segments(NamedTuple):
    """Segments of smooth peak force over one sector of the wave, shape (G, n), in turns."""

    start: FloatArray  # wave position
    low: FloatArray  # pressure angle of the best placed pair there
    high: FloatArray  # and at the segment's end
    real: NDArray[np.bool_]  # not only a sliver of rounding
    nearest: FloatArray  # shape (G, K, n): phase of each satellite's nearest pin against the best
    first: FloatArray  # shape (G, K, n): number of its first driving pin, from the nearest
    driving: IntArray  # shape (G, K, n): how many drive


def _segments(phases: _Phases) -> _Segments:
    sector = 1 / phases.pins
    ordered = np.sort(phases.sector, axis=0)
    following = np.concatenate((ordered[1:], ordered[:1] + sector))
    switches = [0.75 - (ordered + following) / 2, 1.0 - ordered]
    if phases.pins % 2:
        switches.append(0.5 - ordered)
    start = np.sort(np.concatenate(switches) % sector, axis=0)
    width = np.concatenate((start[1:], start[:1] + sector)) - start
    middle = start + width / 2
    nearest = middle[:, None] + (phases.sector - 0.75)
    nearest -= np.rint(nearest * phases.pins) / phases.pins
    best = np.argmin(np.abs(nearest), axis=1)[:, None]
    at_middle = np.take_along_axis(nearest, best, axis=1)[:, 0]
    first = np.floor(phases.pins * (-0.25 - nearest)) + 1
    last = np.ceil(phases.pins * (0.25 - nearest)) - 1
    return _Segments(
        start=start,
        low=at_middle - width / 2,
        high=at_middle + width / 2,
        real=width > SLIVER,
        nearest=nearest - at_middle[:, None],
        first=first,
        driving=(last - first + 1).astype(np.intp),
    )


class _Peak(NamedTuple):
    """Peaks of designs, shape (n,)."""

    ratio: FloatArray
    place: FloatArray  # first wave position within the sector, but for rounding, in turns
    error: FloatArray
    evaluations: IntArray


def _constant_sum(phases: _Phases, _: FloatArray) -> _Peak:
    """v = 1, N even: the squared cosines always sum up to K*N/4, so the best placed pair peaks."""
    satellites, count = phases.sector.shape
    return _Peak(
        ratio=np.full(count, 4 / (satellites * phases.pins)),
        place=_sector_position(0.75 - phases.sector, phases.pins).min(axis=0),
        error=np.full(count, ROUNDING),
        evaluations=np.ones(count, dtype=np.intp),
    )


def _sector_position(position: FloatArray, pins: int) -> FloatArray:
    """Wave position within [0, 1/N); a rounding error beside its ends is 0."""
    within = position % (1 / pins)
    inside = (within > SAME_PHASE) & (within < 1 / pins - SAME_PHASE)
    return np.where(inside, within, 0.0)


def _best_pair(phases: _Phases, position: FloatArray) -> tuple[IntArray, IntArray]:
    """Satellite and pin, from 0, of the best placed pair; of equals the first."""
    off = (0.75 - position - phases.satellite) * phases.pins
    pin = np.ceil(off - 0.5 - SAME_PHASE * phases.pins)
    satellite = np.argmin(np.round(np.abs(off - pin) / phases.pins, 12), axis=0)
    chosen = np.take_along_axis(pin, satellite[None], axis=0)[0]
    return satellite, (chosen % phases.pins).astype(np.intp)


def _linear(phases: _Phases, _: FloatArray) -> _Peak:
    """v = 1, N odd: the cubic ``P*t^3 + (3*P - n)*t - 2*Q``, which falls and rises as -f does."""
    segments = _segments(phases)
    pins = phases.pins
    # sin(2*pi*c/N)/sin(2*pi/N)/2 for the c = (N - 1)/2 or (N + 1)/2 neighbours that drive
    spread = (pins - 2 * segments.driving) / (4 * math.cos(np.pi / pins))
    double = (
        4 * np.pi * (segments.nearest + (2 * segments.first + segments.driving - 1) / (2 * pins))
    )
    number = segments.driving.sum(axis=1).astype(np.float64)
    squares = number / 2 - (spread * np.cos(double)).sum(axis=1)
    products = (spread * np.sin(double)).sum(axis=1)
    sums = np.array((number, squares, products))

    def force(tangent: FloatArray) -> FloatArray:
        total = number - squares + tangent * (tangent * squares - 2 * products)
        ratio: FloatArray = np.sqrt(1 + tangent * tangent) / total
        return ratio

    def cubic(tangent: FloatArray) -> FloatArray:
        value: FloatArray = tangent * (squares * (tangent * tangent + 3) - number) - 2 * products
        return value

    low, high = np.tan(2 * np.pi * segments.low), np.tan(2 * np.pi * segments.high)
    with np.errstate(divide="ignore"):
        turning = np.sqrt(np.fmax(number / (3 * squares) - 1, 0.0))
    values, tangents = [force(low), force(high)], [low, high]
    for left, right in ((np.fmax(low, turning), high), (low, np.fmin(high, -turning))):
        rises = (left < right) & segments.real  # and an end at infinity is beyond the other
        for end, sign in ((left, -1), (right, 1)):
            rises &= sign * cubic(end) >= 0
        root = np.zeros_like(low)
        root[rises] = _root_of_cubic(sums[:, rises], left[rises], right[rises])
        values.append(np.where(rises, force(root), 0.0))
        tangents.append(root)
    return _peak_of_linear(phases, segments, np.array(values), np.array(tangents), sums)


def _root_of_cubic(sums: FloatArray, left: FloatArray, right: FloatArray) -> FloatArray:
    """Root between two places where the cubic rises: Newton's method from the steeper side."""
    number, squares, products = sums
    root = np.where(right > 0, right, left)
    for _ in range(60):
        value = root * (squares * (root * root + 3) - number) - 2 * products
        slope = 3 * squares * (root * root + 1) - number
        step = np.divide(value, slope, out=np.zeros_like(value), where=slope > 0)
        root = np.fmin(np.fmax(root - step, left), right)
        if np.abs(step).max(initial=0.0) < 1e-8:  # each step squares the error
            break
    return root


def _peak_of_linear(
    phases: _Phases,
    segments: _Segments,
    values: FloatArray,
    tangents: FloatArray,
    sums: FloatArray,
) -> _Peak:
    """The largest of candidates, shape (4, G, n); `sums` are n, P and Q, shape (3, G, n)."""
    values = np.where(segments.real, values, 0.0)
    _, size, count = values.shape
    ratio = values.max(axis=(0, 1))
    places = np.full(values.shape, np.inf)
    top = np.nonzero(values >= ratio * (1 - EQUAL))
    angle = np.arctan(tangents[top]) / (2 * np.pi)
    places[top] = _sector_position(
        segments.start[top[1:]] + (angle - segments.low[top[1:]]), phases.pins
    )
    winner = np.argmax(values.reshape(-1, count), axis=0)
    every = np.arange(count)
    tangent = tangents.reshape(-1, count)[winner, every]
    number, squares, products = sums[:, winner % size, every]
    # sum |sin*cos| <= sqrt(sum sin^2 * sum cos^2), all over cos^2 of the best placed pair
    stretch = 1 + tangent * tangent
    total = np.sqrt(stretch) / ratio
    slope = np.abs(tangent) + 2 * np.sqrt(np.fmax(number * stretch / total - 1, 0.0))
    terms = number + np.abs(tangent) * (2 * np.abs(products) + np.abs(tangent) * squares)
    return _Peak(
        ratio=ratio,
        place=places.min(axis=(0, 1)),
        error=ROUNDING * (4 + 4 * terms / total) + 2 * math.pi * phases.error * slope,
        evaluations=2 * segments.real.sum(axis=0) + (values[2:] > 0).sum(axis=(0, 1)),
    )


class _Pairs(NamedTuple):
    """Driving pairs of segments, shape (S, m): where fewer drive, cosine and sine are 0."""

    cosine: FloatArray  # of the phase against the best placed pair
    sine: FloatArray
    exponent: FloatArray  # shape (m,)

    def of(self, columns: IntArray) -> "_Pairs":
        """Those of some segments."""
        return _Pairs(*(each.take(columns, axis=-1) for each in self))


class _Ends(NamedTuple):
    """What is known at one end of stretches, shape (m,) and (S, m)."""

    tangent: FloatArray
    force: FloatArray
    slope: FloatArray  # of the sign of the force's
    shares: FloatArray  # u^(1 + v)
    leads: FloatArray  # sin(d)*u^v

    def of(self, columns: IntArray) -> "_Ends":
        """Those of some stretches."""
        return _Ends(*(each.take(columns, axis=-1) for each in self))


def _at(pairs: _Pairs, tangent: FloatArray) -> _Ends:
    ratio = np.fmax(pairs.cosine - tangent * pairs.sine, 0.0)
    power = ratio**pairs.exponent
    shares, leads = power * ratio, power * pairs.sine
    total, stretch = shares.sum(axis=0), 1 + tangent * tangent
    slope = tangent * total + (1 + pairs.exponent) * stretch * leads.sum(axis=0)
    return _Ends(tangent, np.sqrt(stretch) / total, slope, shares, leads)


def _power(phases: _Phases, exponent: FloatArray) -> _Peak:
    """Any exponent: ends of segments, and the places inside at which the slope falls through 0."""
    segments = _segments(phases)
    pins, count = phases.pins, len(exponent)
    most = np.arange((pins + 1) // 2)[:, None]
    angle = 2 * np.pi * (segments.nearest[:, :, None] + (segments.first[:, :, None] + most) / pins)
    drives = most < segments.driving[:, :, None]
    slots = (len(segments.start), -1, count)
    segment, row = np.nonzero(segments.real)
    pairs = _Pairs(
        cosine=np.where(drives, np.cos(angle), 0.0).reshape(slots)[segment, :, row].T.copy(),
        sine=np.where(drives, np.sin(angle), 0.0).reshape(slots)[segment, :, row].T.copy(),
        exponent=exponent[row],
    )
    low = _at(pairs, np.tan(2 * np.pi * segments.low[segment, row]))
    high = _at(pairs, np.tan(2 * np.pi * segments.high[segment, row]))
    ratio = np.zeros(count)
    np.maximum.at(ratio, row, np.fmax(low.force, high.force))
    columns, left, right, evaluations = _brackets(pairs, row, low, high, ratio)
    roots = _summits(pairs.of(columns), left, right)
    at_roots = _at(pairs.of(columns), roots).force

    every = np.arange(len(row))
    columns = np.concatenate((every, every, columns))
    tangent = np.concatenate((low.tangent, high.tangent, roots))
    force = np.concatenate((low.force, high.force, at_roots))
    ratio = np.zeros(count)
    np.maximum.at(ratio, row[columns], force)
    winner = np.empty(count, dtype=np.intp)
    exact = np.flatnonzero(force == ratio[row[columns]])
    winner[row[columns[exact]]] = exact
    error = _error_of_power(pairs.of(columns[winner]), tangent[winner], phases.error)
    equal = ratio * (1 - np.fmax(EQUAL, error))
    top = np.flatnonzero(force >= equal[row[columns]])
    place = np.full(count, np.inf)
    which = segment[columns[top]], row[columns[top]]
    moved = np.arctan(tangent[top]) / (2 * np.pi) - segments.low[which]
    np.minimum.at(place, which[1], _sector_position(segments.start[which] + moved, pins))
    return _Peak(ratio, place, error, evaluations)


def _brackets(
    pairs: _Pairs, row: IntArray, low: _Ends, high: _Ends, ratio: FloatArray
) -> tuple[IntArray, FloatArray, FloatArray, IntArray]:
    """Stretches with one summit that may be the highest, and the places looked at by design.

    `ratio`, the highest found so far of each design, is raised on the way.

    Over a stretch every pair's u is between its values at the ends, and with it every sum: that
    bounds the force and its slope. Beside the end of a segment, where a pair begins to drive,
    stretches are halved until they are no longer than their distance from it.
    """
    columns = np.arange(len(row))
    left, right = low, high
    evaluations = np.bincount(row, minlength=len(ratio)) * 2
    found: list[tuple[IntArray, FloatArray, FloatArray]] = []
    for halving in range(SPLITS):
        open_ = _may_peak(pairs.exponent[columns], left, right, ratio[row[columns]])
        length = right.tangent - left.tangent
        apart = np.fmin(left.tangent - low.tangent[columns], high.tangent[columns] - right.tangent)
        summit = open_ & (left.slope >= 0) & (right.slope <= 0) & (left.slope > right.slope)
        alone = (length <= apart) & (halving > 2) | (halving == SPLITS - 1)
        done = np.flatnonzero(summit & alone)
        found.append((columns[done], left.tangent[done], right.tangent[done]))
        rest = np.flatnonzero(open_ & ~(summit & alone))
        if not len(rest):
            break
        columns, left, right = columns[rest], left.of(rest), right.of(rest)
        middle = _at(pairs.of(columns), (left.tangent + right.tangent) / 2)
        np.maximum.at(ratio, row[columns], middle.force)
        evaluations += np.bincount(row[columns], minlength=len(ratio))
        columns = np.concatenate((columns, columns))
        left, right = _joined(left, middle), _joined(middle, right)
    columns, starts, stops = (np.concatenate(each) for each in zip(*found, strict=True))
    return columns, starts, stops, evaluations


def _joined(first: _Ends, second: _Ends) -> _Ends:
    return _Ends(*(np.concatenate(each, axis=-1) for each in zip(first, second, strict=True)))


def _may_peak(
    exponent: FloatArray, left: _Ends, right: _Ends, highest: FloatArray
) -> NDArray[np.bool_]:
    """Whether a stretch's force may exceed the highest found, and its slope change its sign."""
    least = np.fmin(left.shares, right.shares).sum(axis=0)
    most = np.fmax(left.shares, right.shares).sum(axis=0)
    squares = left.tangent**2, right.tangent**2
    largest = 1 + np.fmax(*squares)
    smallest = 1 + np.where(left.tangent * right.tangent > 0, np.fmin(*squares), 0.0)
    lead_low = (1 + exponent) * np.fmin(left.leads, right.leads).sum(axis=0)
    lead_high = (1 + exponent) * np.fmax(left.leads, right.leads).sum(axis=0)
    slope_low = left.tangent * np.where(left.tangent < 0, most, least)
    slope_low += lead_low * np.where(lead_low < 0, largest, smallest)
    slope_high = right.tangent * np.where(right.tangent < 0, least, most)
    slope_high += lead_high * np.where(lead_high > 0, largest, smallest)
    higher = (exponent > 0) & (np.sqrt(largest) > highest * least)
    open_: NDArray[np.bool_] = higher & (slope_low <= 0) & (slope_high >= 0)
    return open_


def _summits(pairs: _Pairs, left: FloatArray, right: FloatArray) -> FloatArray:
    """Where the slope falls through 0: Illinois steps, bisection behind."""
    summits = (left + right) / 2
    waiting = np.flatnonzero(right > left)
    close = RESOLUTION * (right - left)[waiting]
    left, right, pairs = left[waiting], right[waiting], pairs.of(waiting)
    rising, falling = _at(pairs, left).slope, _at(pairs, right).slope
    kept = np.zeros(len(left), dtype=np.intp)
    for iteration in range(120):
        if not len(waiting):
            break
        place = right - falling * (right - left) / (falling - rising)
        halve = (place <= left) | (place >= right) | (iteration % 4 == 3)
        place[halve] = (left + right)[halve] / 2
        value = _at(pairs, place).slope
        up = value > 0
        falling = np.where(up, np.where(kept > 0, falling / 2, falling), value)
        rising = np.where(up, value, np.where(kept < 0, rising / 2, rising))
        left, right = np.where(up, place, left), np.where(up, right, place)
        kept = np.where(up, 1, -1)
        summits[waiting] = place
        rest = np.flatnonzero((right - left > close) & (value != 0))
        if len(rest) < 0.7 * len(waiting) or not len(rest):
            waiting, close, kept, pairs = waiting[rest], close[rest], kept[rest], pairs.of(rest)
            left, right, rising, falling = left[rest], right[rest], rising[rest], falling[rest]
    return summits


def _error_of_power(pairs: _Pairs, tangent: FloatArray, phase_error: FloatArray) -> FloatArray:
    """Relative error of forces, from that of the phases in turns; as `core.force_laws`."""
    exponent = pairs.exponent
    best = 1 / np.sqrt(1 + tangent * tangent)
    ratio = np.fmax(pairs.cosine - tangent * pairs.sine, 0.0)
    power = ratio**exponent
    total = (power * ratio).sum(axis=0)
    angle_error = 2 * math.pi * phase_error
    drives = (pairs.cosine != 0) | (pairs.sine != 0)
    widened = np.where(drives, (ratio + angle_error / best) ** exponent, 0.0)
    widened *= 1 + (ratio * best <= angle_error)
    sines = np.abs(pairs.sine + tangent * pairs.cosine)
    slope = exponent * np.abs(tangent)
    slope += (1 + exponent) * (widened * sines).sum(axis=0) / total
    others = np.fmax(total - 1, 0.0) / total
    lost = (power * drives).sum(axis=0) * (1 + np.abs(tangent)) / total
    rounding = ROUNDING * (6 + 2 * (1 + exponent) * (others + lost))
    error: FloatArray = rounding + angle_error * slope
    return error
