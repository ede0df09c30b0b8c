"""Load sharing of pins in holes: the loops over pairs, for one position.

The one unknown is the lag of the output. Exact geometry: with P the pin's centre, H the hole's and
C the difference of their radii, ``|d|^2 - C^2 = q + (cos lag - 1)*u + sin lag*v`` for
``d = P*exp(-i*lag) - H``; q, u and v are linear in the crank's direction. First order in lag and
errors: the approach is ``q + lag*v``. Both go through the same loops.

Rules of this file, so that the same source can be compiled for studies: floats, ints, `math`, flat
rows, named tuples and functions of this file only; no allocation (callers bring the room); no
exceptions (a status is returned). SI units.
"""

import math
from typing import NamedTuple

from core.output.sharing_pairs import Pairs, Room, Row, Setup

LINEAR, POWER, HERTZ = 0, 1, 2
SOLVED, NOT_SOLVED, NO_DRIVE, NOT_STABLE = 0, 1, 2, 3

EPS = 2.0**-52
TINY = 1e-100
"""Stands for what is positive, but for deviations as large as the mechanism."""

STEPS = 200
NEWTON_ALONE = 20
"""Steps of Newton after which the stretch is halved too."""

HERTZ_END = 1.2
"""Where the logarithm of the Hertz law ends, in ``approach/(b*force)``: its stiffness would grow
beyond bounds at 1. It goes on as a straight line; what lies there is refused afterwards."""


def at(psi: float, setup: Setup, pairs: Pairs, room: Room) -> None:
    """The pairs at a wave angle; in reverse v changes its sign, and so does the lag."""
    px, py, ex, ey = pairs.x, pairs.y, pairs.ex, pairs.ey
    k0, k1, k2, q, u, v = pairs.k0, pairs.k1, pairs.k2, room.q, room.u, room.v
    way, exact, pins = setup.direction, setup.exact, setup.pins
    for j in range(setup.satellites):
        angle = psi + pairs.phase[j]
        wx, wy = pairs.arm[j] * math.sin(angle), pairs.arm[j] * math.cos(angle)
        for i in range(j * pins, (j + 1) * pins):
            x, y = px[i], py[i]
            q[i] = wx * ex[i] + wy * ey[i] + k0[i]
            if exact:
                u[i] = wx * x + wy * y + k1[i]
                v[i] = way * (wx * y - wy * x + k2[i])
            else:
                v[i] = way * (wx * x + wy * y)


def play(setup: Setup, room: Room) -> tuple[float, float, int, int]:
    """Least and largest lag at which no pair touches, and the pairs that touch there (-1: none).
    Where pairs press without load the first is larger than the second.
    """
    low, high, behind, onset = -math.inf, math.inf, -1, -1
    far = 2 * setup.eccentricity / setup.radius
    for i in range(setup.pins * setup.satellites):
        q, v = room.q[i], room.v[i]
        if setup.exact:
            a = max(q - 2 * room.u[i], TINY)
            square = v * v - a * q
            if square < 0:
                return math.inf, -math.inf, -1, -1
            root = math.sqrt(square)
            if v >= 0:
                from_, to = -(v + root) / a, -q / (v + root) if v + root > 0 else 0.0
            else:
                from_, to = q / (root - v), (root - v) / a
            from_, to = 2 * math.atan(from_), 2 * math.atan(to)
        elif abs(v) * far <= abs(q):  # at its dead angle: open or pressed at any lag
            if q > 0:
                return math.inf, -math.inf, -1, -1
            continue
        elif v > 0:
            from_, to = -math.inf, -q / v
        else:
            from_, to = -q / v, math.inf
        if from_ > low:
            low, behind = from_, i
        if to < high:
            high, onset = to, i
    return low, high, behind, onset


def touch_error(lag: float, pair: int, psi: float, setup: Setup, pairs: Pairs, room: Room) -> float:
    """By how much rounding moves the lag at which a pair touches; as `at` left the room."""
    if pair < 0:
        return 0.0
    q, v = room.q[pair], room.v[pair]
    twice = 2 * pairs.distance[pair] if setup.exact else 1.0
    # The lever may be small as a difference: the wave angle moves it by the whole radius.
    size = pairs.size[pair] + abs(lag) * twice * setup.radius
    off = EPS * (4 + 2 * abs(psi)) * size
    if not setup.exact:
        return off / abs(v) if v != 0 else math.inf
    # Of a*t^2 + 2*v*t + q = 0, where both roots may fall together.
    a = max(q - 2 * room.u[pair], TINY)
    slope = math.sqrt(max(v * v - a * q, 0.0))
    most = 2 * math.sqrt(off / a)
    return min(most, off / slope) if slope > 0 else most


def shift(lag: float, onset: int, setup: Setup, pairs: Pairs, room: Room) -> None:
    """Count the lag from here on, where the pair `onset` (-1: none) just touches and the others do
    not: small loads keep their digits.
    """
    sine, half = math.sin(lag), math.sin(lag / 2)
    less = -2 * half * half
    for i in range(setup.pins * setup.satellites):
        q, v = room.q[i], room.v[i]
        if setup.exact:
            u = room.u[i]
            q += less * u + sine * v
            room.unsure[i] = pairs.size[i] + abs(lag) * 2 * pairs.distance[i] * setup.radius
            room.u[i], room.v[i] = (1 + less) * u + sine * v, (1 + less) * v - sine * u
        else:
            q += lag * v
            room.unsure[i] = pairs.size[i] + abs(lag) * setup.radius
        room.q[i] = q if onset < 0 else min(q, 0.0)
    if onset >= 0:
        room.q[onset] = 0.0


def law(kind: int, approach: float, a: float, b: float, n: float) -> tuple[float, float]:
    """Force of an approach > 0, and its derivative."""
    if kind == LINEAR:
        return approach / a, 1 / a
    if kind == HERTZ:
        m = a / b - math.log(approach / b)
        if m <= HERTZ_END - math.log(HERTZ_END):
            return approach / (HERTZ_END * b), 1 / (HERTZ_END * b)
        y = m + math.log(m) + math.log(m) / m
        for _ in range(8):
            step = (y - math.log(y) - m) * y / (y - 1)
            y -= step
            if abs(step) <= 1e-9 * y:
                break
        return approach / (b * y), 1 / (b * (y - 1))
    if b == 0:
        force = a * approach**n
        return force, n * force / approach
    # In series with a linear compliance b: Newton in the variable in which it is convex.
    if n >= 1:
        x = min(approach, (approach / (a * b)) ** (1 / n))
        for _ in range(60):
            bent = b * a * x**n
            step = (x + bent - approach) / (1 + n * bent / x)
            x -= step
            if abs(step) <= 1e-9 * x:
                break
        force = a * x**n
        stiffness = n * force / x
    else:
        force = min(approach / b, a * approach**n)
        for _ in range(60):
            x = (force / a) ** (1 / n)
            step = (x + b * force - approach) / (x / (n * force) + b)
            force -= step
            if abs(step) <= 1e-9 * force:
                break
        stiffness = n * force / (force / a) ** (1 / n)
    return force, stiffness / (1 + b * stiffness)


def alone(kind: int, force: float, a: float, b: float, n: float) -> float:
    """Approach under a force."""
    if kind == LINEAR:
        return a * force
    if kind == HERTZ:
        return force * b * max(a / b - math.log(force), HERTZ_END)
    return float((force / a) ** (1 / n) + b * force)


def balance(lag: float, setup: Setup, pairs: Pairs, room: Room) -> tuple[float, float, float]:
    """Torque of all pairs at a lag, its derivative, and the sum of its terms' sizes."""
    force, levers, contact = room.force, room.lever, room.stiffness
    distance, a, b = pairs.distance, pairs.a, pairs.b
    exact, kind, exponent = setup.exact, setup.law, setup.exponent
    sine, half = math.sin(lag), math.sin(lag / 2)
    less = -2 * half * half
    cosine = 1 + less
    torque = slope = gross = 0.0
    for i, (q, u, v) in enumerate(zip(room.q, room.u, room.v)):  # noqa: B905 - not compiled
        approach = q + less * u + sine * v if exact else q + lag * v
        if approach <= 0:
            force[i] = levers[i] = contact[i] = 0.0
            continue
        bend = 0.0
        lever = v
        if exact:
            c = distance[i]
            length = math.sqrt(c * c + approach)
            approach /= length + c
            lever = (cosine * v - sine * u) / (2 * length)
            bend = (-(cosine * u + sine * v) / 2 - lever * lever) / length
        f, stiffness = law(kind, approach, a[i], b[i], exponent)
        force[i], levers[i], contact[i] = f, lever, stiffness
        torque += f * lever
        gross += f * abs(lever)
        slope += stiffness * lever * lever + f * bend
    return torque, slope, gross


def start(torque: float, setup: Setup, pairs: Pairs, room: Room) -> float:
    """Lag at which the best placed pair alone would carry the torque, in first order."""
    best = math.inf
    for i in range(setup.pins * setup.satellites):
        v = room.v[i]
        twice = 2 * pairs.distance[i] if setup.exact else 1.0
        lever = v / twice
        if lever > 1e-12 * setup.radius:
            approach = alone(setup.law, torque / lever, pairs.a[i], pairs.b[i], setup.exponent)
            best = min(best, (approach * twice - room.q[i]) / v)
    return best


class Position(NamedTuple):
    """Lag of a position (counted in the direction of the torque), and what belongs to it."""

    lag: float
    stiffness: float
    low: float  # play
    high: float
    play_error: float
    lag_error: float
    force_error: float
    status: int
    steps: int


def solve(psi: float, torque: float, setup: Setup, pairs: Pairs, room: Room) -> Position:
    """Equilibrium of a position under a torque > 0; forces and levers are left in the room."""
    at(psi, setup, pairs, room)
    play_low, play_high, behind, onset = play(setup, room)
    play_error = max(
        touch_error(play_low, behind, psi, setup, pairs, room),
        touch_error(play_high, onset, psi, setup, pairs, room),
    )
    # Parts that just fit press by rounding only.
    pressed = play_low > play_high + play_error
    zero = 0.0 if pressed else play_high
    lag = math.inf
    if zero < math.inf:
        shift(zero, -1 if pressed else onset, setup, pairs, room)
        lag = start(torque, setup, pairs, room)
    if lag == math.inf:
        return Position(0.0, 0.0, play_low, play_high, play_error, 0.0, 0.0, NO_DRIVE, 0)
    if pressed:
        lag = 0.0
    low, high = -math.inf if pressed else 0.0, math.inf
    # Newton on torque^(1/exponent), which is convex and nearly straight for pure powers; pairs
    # that press without load have other laws of growth.
    power = 1.0 if pressed else 1 / setup.exponent
    step, status, far = 0, NOT_SOLVED, setup.eccentricity / setup.radius
    carried = slope = gross = 0.0
    for step in range(1, STEPS):
        carried, slope, gross = balance(lag, setup, pairs, room)
        if carried > torque:
            high = lag
        else:
            low = lag
        ratio = carried / torque
        change = math.inf
        if slope > 0 and power == 1:
            change = (torque - carried) / slope
        elif slope > 0 and ratio > 0:
            change = torque * (ratio ** (1 - power) - ratio) / (power * slope)
        if abs(carried - torque) <= EPS * gross or abs(change) <= EPS * abs(lag):
            status = SOLVED
            break
        if pressed:  # at its dead angle a pair hardly holds: no step beyond what is sought
            change = min(max(change, -far), far)
        following = lag + change
        # Below the exponent 1 each touch is a step of the torque, over which Newton goes back and
        # forth: then every second time the stretch is halved.
        if not low < following < high or (
            step > NEWTON_ALONE and step % 2 and high - low < math.inf
        ):
            if high == math.inf:
                following = lag + max(abs(lag), 1e-9)
            elif low == -math.inf:
                following = lag - max(abs(lag), 1e-9)
            else:
                following = (low + high) / 2
                if following in (low, high):
                    status = SOLVED
                    break
        lag = following
    if slope <= 0:
        return Position(
            zero + lag, slope, play_low, play_high, play_error, 0.0, 0.0, NOT_STABLE, step
        )
    # What the torque may be off, and with it the lag: by the balance, by rounding of its terms,
    # and by rounding of each lever and approach, which that of the wave angle moves.
    off = abs(carried - torque) + 4 * EPS * (gross + torque)
    rounding = EPS * (4 + 2 * abs(psi))
    for force in room.force:
        off += rounding * force * setup.radius
    for i in range(setup.pins * setup.satellites):
        twice = 2 * pairs.distance[i] if setup.exact else 1.0
        near = rounding * (room.unsure[i] / twice + abs(lag) * setup.radius)
        room.unsure[i] = near
        off += room.stiffness[i] * abs(room.lever[i]) * near
    lag_error = off / slope
    force_error = 0.0
    for i in range(setup.pins * setup.satellites):
        near = abs(room.lever[i]) * lag_error + room.unsure[i]
        force_error = max(force_error, room.stiffness[i] * near + 8 * EPS * room.force[i])
    return Position(
        zero + lag,
        slope,
        play_low,
        play_high,
        play_error,
        lag_error + (0.0 if pressed else play_error) + EPS * abs(lag),
        force_error,
        status,
        step,
    )


def wave_torque(psi: float, lag: float, setup: Setup, pairs: Pairs, room: Room) -> float:
    """Torque of the forces in the room on the wave, at the lag that balances them: the sum of each
    times the derivative of its approach by the wave angle.
    """
    way, sine, half = setup.direction, math.sin(lag), math.sin(lag / 2)
    less, total = -2 * half * half, 0.0
    for j in range(setup.satellites):
        angle, arm = psi + pairs.phase[j], pairs.arm[j]
        wx, wy = arm * math.sin(angle), arm * math.cos(angle)
        for i in range(j * setup.pins, (j + 1) * setup.pins):
            if room.force[i] == 0:
                continue
            x, y, ex, ey, c = pairs.x[i], pairs.y[i], pairs.ex[i], pairs.ey[i], pairs.distance[i]
            grown = wy * ex - wx * ey  # q by the angle: wx becomes wy, and wy -wx
            if setup.exact:
                grown += less * (wy * x - wx * y) + way * sine * (wy * y + wx * x)
                square = c * c + wx * ex + wy * ey + pairs.k0[i] + less * pairs.k1[i]
                square += less * (wx * x + wy * y) + way * sine * (wx * y - wy * x + pairs.k2[i])
                grown /= 2 * math.sqrt(square)
            else:
                grown += lag * way * (wy * x - wx * y)
            total += room.force[i] * grown
    return total


def largest(room: Row) -> float:
    """Largest of a row of forces."""
    best = 0.0
    for force in room:
        best = max(best, force)
    return best


def interference(low: float, high: float, setup: Setup, pairs: Pairs, room: Room) -> float:
    """Smallest possible worst approach, between two lags; `at` must have been called.

    The worst approach is convex in the lag in first order, and nearly so in exact geometry: the
    sign of its slope is bisected.
    """
    worst = 0.0
    for _ in range(STEPS):
        lag = (low + high) / 2
        sine, half = math.sin(lag), math.sin(lag / 2)
        less = -2 * half * half
        worst, slope = -math.inf, 0.0
        for i in range(setup.pins * setup.satellites):
            q, u, v = room.q[i], room.u[i], room.v[i]
            if setup.exact:
                c = pairs.distance[i]
                approach = q + less * u + sine * v
                approach /= math.sqrt(max(c * c + approach, 0.0)) + c
                lever = (1 + less) * v - sine * u
            else:
                approach, lever = q + lag * v, v
            if approach > worst:
                worst, slope = approach, lever
        if lag in (low, high):
            break
        if slope > 0:
            high = lag
        else:
            low = lag
    return worst
