"""Exact answers for the crank-planetary output mechanism, found the slow way in mpmath.

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
from mpmath import mp, mpf

DIGITS = 40
mp.dps = DIGITS


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
) -> Peak:
    """Largest F/F0 over the turn, to some 35 digits.

    Every segment is sampled in mpmath; wherever the derivative of ln f changes from plus to
    minus the root is polished. ``whole_turn`` does without the period 2*pi/N as well.
    """
    theta = [t for row in phases(pins, crank_angles) for t in row]
    v = mpf(exponent)

    def log_force(psi: mpf) -> tuple[mpf, mpf]:
        """Return ln f and its derivative; the derivative is that inside a segment."""
        pairs = [(-mp.sin(psi + t), -mp.cos(psi + t)) for t in theta]
        best, best_slope = max(pairs)
        total = slope = mpf(0)
        for c, dc in pairs:
            if c > 0:
                power = mp.exp(v * mp.log(c / best)) if v else mpf(1)
                total += power * c
                slope += power * dc
        return -mp.log(total), v * best_slope / best - (1 + v) * slope / total

    period = 2 * mp.pi if whole_turn else 2 * mp.pi / pins
    breaks = _breaks(theta, period)
    knots = []
    for start, end in pairwise(breaks):
        inner = [start + (end - start) * mpf(2 * i + 1) / (2 * samples) for i in range(samples)]
        knots.append([(p, *log_force(p)) for p in inner])
    ends = [(p, log_force(p)[0]) for p in breaks]
    best = max([(f, p) for p, f in ends] + [(f, p) for row in knots for p, f, _ in row])
    for row, start, end in zip(knots, breaks, breaks[1:], strict=False):
        # the outer half-steps of a segment may hide a summit between sample and end
        width = (end - start) / samples
        brackets = [(a, b) for a, b in pairwise(row) if a[2] > 0 > b[2]]
        if row[0][2] < 0:
            brackets.append(((start, mp.ninf, mp.inf), row[0]))
        if row[-1][2] > 0:
            brackets.append((row[-1], (end, mp.ninf, -mp.inf)))
        for left, right in brackets:
            slope = max(abs(s) for s in (left[2], right[2]) if abs(s) != mp.inf)
            if max(left[1], right[1]) + 2 * slope * width < best[0]:
                continue
            best = max(best, _summit(log_force, left[0], right[0]))
    return Peak(ratio=mp.exp(best[0]), wave_angle=best[1])


def _breaks(theta: Sequence[mpf], period: mpf) -> list[mpf]:
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


def _summit(log_force, left: mpf, right: mpf) -> tuple[mpf, mpf]:  # type: ignore[no-untyped-def]
    """Bisect the derivative to half the digits: the value is then right to all of them."""
    while right - left > mpf(10) ** (-DIGITS // 2 + 1):
        middle = (left + right) / 2
        if log_force(middle)[1] > 0:
            left = middle
        else:
            right = middle
    middle = (left + right) / 2
    return log_force(middle)[0], middle


def seeded_peak(pins: int, crank_angles: Sequence[float], exponent: float) -> Peak:
    """As `peak`, with the search in doubles and only the leading summits polished in mpmath.

    Thousands of mechanisms become affordable; the doubles decide only where to look.
    """
    theta = np.array([[float(t) for t in row] for row in phases(pins, crank_angles)]).ravel()
    period = 2 * mp.pi / pins
    breaks = [float(b) for b in _breaks([t for r in phases(pins, crank_angles) for t in r], period)]
    psi = np.unique(np.concatenate([np.linspace(a, b, 65) for a, b in pairwise(breaks)]))
    c = np.maximum(-np.sin(psi[:, None] + theta), 0.0)
    best = c.max(axis=1)
    log_f = -np.log(((c / best[:, None]) ** exponent * c).sum(axis=1))
    order = np.argsort(-log_f)
    step = np.gradient(psi)
    candidates: list[float] = []
    reach = 1e-9 + 2 * np.abs(np.gradient(log_f, psi)) * step
    for i in order:
        if log_f[i] + reach[i] < log_f[order[0]] or len(candidates) >= 6:
            break
        if all(abs(psi[i] - p) > 3 * step[i] for p in candidates):
            candidates.append(float(psi[i]))
    exact = [t for row in phases(pins, crank_angles) for t in row]
    v = mpf(exponent)

    def log_force(p: mpf) -> mpf:
        cs = [-mp.sin(p + t) for t in exact]
        top = max(cs)
        return -mp.log(sum((mp.exp(v * mp.log(x / top)) if v else 1) * x for x in cs if x > 0))

    results = []
    mp_breaks = _breaks(exact, period)
    for p in candidates:
        near = [b for b in mp_breaks if abs(b - p) < 0.1]
        results += [(log_force(b), b) for b in sorted(near, key=lambda b: abs(b - p))[:4]]
        i = int(np.searchsorted(psi, p))
        left, right = mpf(psi[max(i - 1, 0)]), mpf(psi[min(i + 1, len(psi) - 1)])
        results.append(_golden(log_force, left, right))
    value, where = max(results)
    return Peak(ratio=mp.exp(value), wave_angle=where)


def _golden(f, left: mpf, right: mpf) -> tuple[mpf, mpf]:  # type: ignore[no-untyped-def]
    """Golden section down to 1e-13: the value of a smooth summit is then right to 1e-24."""
    golden = (mp.sqrt(5) - 1) / 2
    a, b = left, right
    p, q = b - golden * (b - a), a + golden * (b - a)
    fp, fq = f(p), f(q)
    while b - a > mpf("1e-13"):
        if fp > fq:
            b, q, fq = q, p, fp
            p = b - golden * (b - a)
            fp = f(p)
        else:
            a, p, fp = p, q, fq
            q = a + golden * (b - a)
            fq = f(q)
    return max((fp, p), (fq, q))


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
