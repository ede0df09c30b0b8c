"""Peaks of the linear law of load sharing, v = 1, for arrays of designs: closed forms.

With t = tan(pressure angle of the best placed pair) another pair's cosine over the best one's is
``u = cos(d) - t*sin(d)``, linear in t, and the force ratio is ``f = sqrt(1 + t^2)/sum(u^2)``.
"""

import math

import numpy as np

from core.contact_force import FloatArray
from core.designs.segments import EQUAL, Peaks, Phases, Segments
from core.results import ROUNDING


def linear_peaks(phases: Phases) -> Peaks:
    """Peaks for v = 1."""
    return _odd(phases) if phases.pins % 2 else _even(phases)


def _even(phases: Phases) -> Peaks:
    """N even: the squared cosines always sum up to K*N/4, so the best placed pair peaks."""
    satellites, count = phases.sector.shape
    return Peaks(
        ratio=np.full(count, 4 / (satellites * phases.pins)),
        place=phases.position(0.75 - phases.sector).min(axis=0),
        error=np.full(count, ROUNDING),
        evaluations=np.ones(count, dtype=np.intp),
    )


def _odd(phases: Phases) -> Peaks:
    """N odd: the cubic ``P*t^3 + (3*P - n)*t - 2*Q``, which falls and rises as -f does."""
    segments = Segments.of(phases)
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
    return _largest(phases, segments, np.array(values), np.array(tangents), sums)


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


def _largest(
    phases: Phases,
    segments: Segments,
    values: FloatArray,
    tangents: FloatArray,
    sums: FloatArray,
) -> Peaks:
    """The largest of candidates, shape (4, G, n); `sums` are n, P and Q, shape (3, G, n)."""
    values = np.where(segments.real, values, 0.0)
    _, size, count = values.shape
    ratio = values.max(axis=(0, 1))
    places = np.full(values.shape, np.inf)
    top = np.nonzero(values >= ratio * (1 - EQUAL))
    angle = np.arctan(tangents[top]) / (2 * np.pi)
    places[top] = phases.position(segments.start[top[1:]] + (angle - segments.low[top[1:]]))
    winner = np.argmax(values.reshape(-1, count), axis=0)
    every = np.arange(count)
    tangent = tangents.reshape(-1, count)[winner, every]
    number, squares, products = sums[:, winner % size, every]
    # sum |sin*cos| <= sqrt(sum sin^2 * sum cos^2), all over cos^2 of the best placed pair
    stretch = 1 + tangent * tangent
    total = np.sqrt(stretch) / ratio
    slope = np.abs(tangent) + 2 * np.sqrt(np.fmax(number * stretch / total - 1, 0.0))
    terms = number + np.abs(tangent) * (2 * np.abs(products) + np.abs(tangent) * squares)
    return Peaks(
        ratio=ratio,
        place=places.min(axis=(0, 1)),
        error=ROUNDING * (4 + 4 * terms / total) + 2 * math.pi * phases.error * slope,
        evaluations=2 * segments.real.sum(axis=0) + (values[2:] > 0).sum(axis=(0, 1)),
    )
