"""Exact answers for the crank-planetary output mechanism, found the slow way at 40 digits.

Nothing here is shared with ``core``: no symmetry beyond the pin spacing, no closed form, no
cubic. The doubles that a caller gives are taken as exact numbers, pi is mpmath's.

Two facts carry the search. At any position the largest force is that of the pair with the
largest cosine, so only ``f(psi) = c_best^v / sum c^(1+v)`` has to be maximised. And f is
continuous: a pair that begins to drive does so with cosine 0, so the one-sided limits at a
switching angle agree with f there, v = 0 included (where that pair's own force jumps). Between
two neighbours of all switching angles and all changes of the best pair f is smooth.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from flint import arb
from mpmath import mp, mpf

from tests.oracles import DIGITS
from tests.oracles.balls import from_ball, to_ball


@dataclass(frozen=True, slots=True)
class Peak:
    """Largest force ratio and the wave angle psi at which it is reached."""

    ratio: mpf
    wave_angle: mpf


def phases(pins: int, crank_angles: Sequence[float]) -> list[list[mpf]]:
    """Phase theta of pair (satellite, pin), one row for each satellite."""
    return [[mpf(a) + 2 * mp.pi * n / pins for n in range(pins)] for a in crank_angles]


def wave_angle(crank_angle: float, ratio: float, initial_crank_angle: float = 0.0) -> mpf:
    """psi = phi*(1 + 1/u) + phi_0."""
    return mpf(crank_angle) * (1 + 1 / mpf(ratio)) + mpf(initial_crank_angle)


def cosines(pins: int, crank_angles: Sequence[float], psi: mpf) -> list[list[mpf]]:
    """Cosine of the pressure angle of each pair, P2 eq. (6)."""
    return [[-mp.sin(psi + t) for t in row] for row in phases(pins, crank_angles)]


def forces(pins: int, crank_angles: Sequence[float], exponent: float, psi: mpf) -> list[list[mpf]]:
    """F/F0 of each pair by P2 eq. (10); needs at least one driving pair."""
    rows = cosines(pins, crank_angles, psi)
    best = max(c for row in rows for c in row)
    v = mpf(exponent)
    total = sum((c / best) ** (1 + v) for row in rows for c in row if c > 0)
    return [[(c / best) ** v / (best * total) if c > 0 else mpf(0) for c in row] for row in rows]


def largest_gap(pins: int, crank_angles: Sequence[float]) -> mpf:
    """Largest gap between neighbouring phases on the circle; at pi or more nothing drives."""
    period = 2 * mp.pi / pins
    folded = sorted(mpf(a) % period for a in crank_angles)
    folded.append(folded[0] + period)
    return max(b - a for a, b in pairwise(folded))


def peak(
    pins: int,
    crank_angles: Sequence[float],
    exponent: float,
    *,
    samples: int = 12,
    whole_turn: bool = False,
    screened: bool = False,
) -> Peak:
    """Largest F/F0 over the turn, to some 35 digits.

    Every segment is sampled in mpmath; wherever the derivative of ln f changes from plus to
    minus the root is polished. ``whole_turn`` does without the period 2*pi/N as well.
    ``screened`` leaves out the segments that doubles show to lie below the peak by more than
    their slopes could make up for: thousands of mechanisms become affordable.
    """
    theta = [t for row in phases(pins, crank_angles) for t in row]
    v = to_ball(exponent)

    turned = [to_ball(t).sin_cos() for t in theta]

    def log_force(psi: mpf) -> tuple[arb, arb]:
        """Return ln f and its derivative; the derivative is that inside a segment."""
        sin, cos = to_ball(psi).sin_cos()
        pairs = [(-sin * ct - cos * st, sin * st - cos * ct) for st, ct in turned]
        best, best_slope = max(pairs, key=lambda pair: pair[0].mid())
        total = slope = arb(0)
        for c, dc in pairs:
            if c > 0:
                power = (c / best) ** v if exponent else arb(1)
                total += power * c
                slope += power * dc
        return (-total.log()).mid(), (v * best_slope / best - (1 + v) * slope / total).mid()

    places = breaks(theta, 2 * mp.pi if whole_turn else 2 * mp.pi / pins)
    segments = list(pairwise(places))
    if screened:
        segments = _worth_searching(segments, theta, float(exponent))
    knots = []
    for start, end in segments:
        inner = [start + (end - start) * mpf(2 * i + 1) / (2 * samples) for i in range(samples)]
        knots.append([(p, *log_force(p)) for p in inner])
    ends = {p for segment in segments for p in segment}
    best = max([(log_force(p)[0], p) for p in ends] + [(f, p) for row in knots for p, f, _ in row])
    for row, (start, end) in zip(knots, segments, strict=True):
        # the outer half-steps of a segment may hide a summit between sample and end
        width = (end - start) / samples
        brackets = [(a, b) for a, b in pairwise(row) if a[2] > 0 > b[2]]
        if row[0][2] < 0:
            brackets.append(((start, None, None), row[0]))
        if row[-1][2] > 0:
            brackets.append((row[-1], (end, None, None)))
        for left, right in brackets:
            level = max(f for _, f, _ in (left, right) if f is not None)
            slope = max(abs(s) for _, _, s in (left, right) if s is not None)
            if level + 2 * slope * to_ball(width) < best[0]:
                continue
            # and where a summit has parted in two, there are three changes of sign
            best = max(
                [best, *(_summit(log_force, *part) for part in _parts(log_force, left, right))]
            )
    return Peak(ratio=from_ball(best[0].exp()), wave_angle=best[1])


def _parts(log_force, left, right, pieces: int = 8) -> list[tuple[mpf, mpf]]:  # type: ignore[no-untyped-def]
    """Parts of a bracket in which the derivative changes from plus to minus."""
    start, end = left[0], right[0]
    inner = [start + (end - start) * mpf(i) / pieces for i in range(1, pieces)]
    slopes = [arb(1), *(log_force(p)[1] for p in inner), arb(-1)]
    parts = zip(pairwise([start, *inner, end]), pairwise(slopes), strict=True)
    return [part for part, (before, after) in parts if before > 0 and not after > 0]


def _worth_searching(
    segments: Sequence[tuple[mpf, mpf]], theta: Sequence[mpf], exponent: float, samples: int = 257
) -> list[tuple[mpf, mpf]]:
    """Segments whose largest sample, raised by their steepest slope over a step, may win."""
    phase = np.array([float(t) for t in theta])
    v = exponent
    bounds, levels = [], []
    for start, end in segments:
        a, width = float(start), float(end - start)
        psi = a + width * (np.arange(samples) + 0.5) / samples
        c, dc = -np.sin(psi[:, None] + phase), -np.cos(psi[:, None] + phase)
        index = c.argmax(axis=1)[:, None]
        top, slope = np.take_along_axis(c, index, 1), np.take_along_axis(dc, index, 1)
        c = np.maximum(c, 0.0)
        power = np.where(c > 0, (c / top) ** v, 0.0)
        total = (power * c).sum(axis=1)
        slopes = v * (slope / top)[:, 0] - (1 + v) * (power * dc).sum(axis=1) / total
        level = float((-np.log(total)).max())
        levels.append(level)
        bounds.append(level + 2 * float(np.abs(slopes).max()) * width / samples + 1e-11 * (1 + v))
    highest = max(levels)
    return [s for s, bound in zip(segments, bounds, strict=True) if bound >= highest]


def breaks(theta: Sequence[mpf], period: mpf) -> list[mpf]:
    """Switching angles and changes of the best pair in one period, both ends included."""
    turn = 2 * mp.pi
    ordered = sorted(t % turn for t in theta)
    ordered.append(ordered[0] + turn)
    ties = [(a + b) / 2 for a, b in pairwise(ordered)]
    points = [-t for t in theta] + [mp.pi - t for t in theta] + [-mp.pi / 2 - t for t in ties]
    folded = sorted(p % period for p in points)
    merged = [folded[0]]
    for p in folded[1:]:
        if p - merged[-1] > mpf(10) ** (8 - DIGITS):
            merged.append(p)
    if folded[0] + period - merged[-1] < mpf(10) ** (8 - DIGITS):
        merged.pop()
    return [*merged, merged[0] + period]


def _summit(log_force, left: mpf, right: mpf) -> tuple[arb, mpf]:  # type: ignore[no-untyped-def]
    """Root of the derivative to half the digits: the value is then right to all of them.

    Illinois steps, with a bisection as every third: the derivative may rise like a small power.
    """
    small = mpf(10) ** (1 - DIGITS // 2)
    middle, slope_left, slope_right = (left + right) / 2, None, None
    for step in range(1000):
        value, slope = log_force(middle)
        if right - left < small or abs(slope) < to_ball(small**1.2):
            break
        if slope > 0:
            left, slope_left = middle, slope
            slope_right = slope_right and slope_right / 2
        else:
            right, slope_right = middle, slope
            slope_left = slope_left and slope_left / 2
        middle = (left + right) / 2
        if step % 3 and slope_left and slope_right:
            middle = left + (right - left) * from_ball(
                (slope_left / (slope_left - slope_right)).mid()
            )
    return value, middle


def driving_count(pins: int, crank_angles: Sequence[float], psi: mpf) -> int:
    """Number of pairs with a positive cosine."""
    return sum(c > 0 for row in cosines(pins, crank_angles, psi) for c in row)


def driving_intervals(
    theta: mpf, ratio: float, initial_crank_angle: float, end: mpf
) -> list[tuple[mpf, mpf]]:
    """Crank angles in [0, end] where -sin(psi + theta) > 0, that is psi + theta in (pi, 2*pi)."""
    speed = 1 + 1 / mpf(ratio)
    start = mpf(initial_crank_angle) + theta
    turn = int(mp.floor(start / (2 * mp.pi))) - 1
    found = []
    while True:
        low = ((2 * turn + 1) * mp.pi - start) / speed
        high = ((2 * turn + 2) * mp.pi - start) / speed
        if low >= end:
            return found
        if high > 0:
            found.append((max(low, mpf(0)), min(high, end)))
        turn += 1


def relative_error(value: float, exact: mpf) -> float:
    """|value - exact| / |exact| as a double; infinite for a value that is no number."""
    if not math.isfinite(value):
        return math.inf
    return float(abs((mpf(value) - exact) / exact))
