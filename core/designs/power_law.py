"""Peaks of any law of load sharing for arrays of designs: bounds, halving, roots.

With t = tan(pressure angle of the best placed pair) another pair's cosine over the best one's is
``u = cos(d) - t*sin(d)``, linear in t, and the force ratio is
``f = sqrt(1 + t^2)/sum(u^(1 + v))``. So every u, and every sum of powers of them, is bounded over
a stretch by its values at the ends: a stretch whose force or whose slope shows that no peak is in
it is dropped, others are halved.
"""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from core.contact_force import FloatArray
from core.designs.segments import EQUAL, IntArray, Peaks, Phases, Segments
from core.results import ROUNDING

RESOLUTION = 1e-11
"""Share of its bracket to which a peak is located: its height is then right to rounding."""

SPLITS = 50
"""Most halvings of a stretch in which a peak may hide."""


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


def power_peaks(*, phases: Phases, exponent: FloatArray) -> Peaks:
    """Peaks for any exponent: ends of segments, and where the slope inside falls through 0.

    Parameters
    ----------
    phases : Phases
        Phases of the satellites.
    exponent : array, shape (n,)
        Exponent v of the force over the approach.

    Returns
    -------
    Peaks
    """
    segments = Segments.of(phases)
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
    np.minimum.at(place, which[1], phases.position(segments.start[which] + moved))
    return Peaks(ratio, place, error, evaluations)


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
