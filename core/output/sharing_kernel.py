"""Load sharing of pins in holes: one position.

The one unknown is the lag of the output. Exact geometry: with P the pin's centre, H the hole's and
C the difference of their radii, ``|d|^2 - C^2 = q + (cos lag - 1)*u + sin lag*v`` for
``d = P*exp(-i*lag) - H``; q, u and v are linear in the crank's direction. First order in lag and
errors: the approach is ``q + lag*v``. Both go through the same loops. Rules in `loop_rows`.
"""

import math

from core.output.contact_kernel import alone, law, pair_law, within
from core.output.giving_kernel import give, given_errors
from core.output.loop_rows import (
    CLOSE,
    CRANK,
    EPS,
    MESH,
    NO_DRIVE,
    NO_LEVER,
    NOT_SOLVED,
    NOT_STABLE,
    RADIAN,
    RIGID,
    SHARES,
    SOLVED,
    STEPS,
    TIED,
    TINY,
    TOO_FAR,
    TOO_WIDE,
    Carried,
    Errors,
    Freed,
    Law,
    Pairs,
    Position,
    Room,
    Row,
    Setup,
)
from core.output.tied_kernel import join, tie, tied_errors


def prepare(
    setup: Setup,
    law: Law,
    errors: Errors[Row],
    phase: Row,
    compliance: Row,
    outward: Row,
    pairs: Pairs,
) -> int:
    """Constants of the pairs from the deviations of one piece; the pair whose hole, pin or crank
    has no size left, or -1. Crank angles and the pin's compliance at each satellite are [K]; of
    pins that a tie ring joins see `core.output.elasticity.tied_compliance`. Outward are the
    directions of the pins from the middle, [N, 2].
    """
    none = place(setup, errors, phase, outward, pairs)
    if none < 0:
        press(setup, law, errors, compliance, pairs)
    return none


def place(setup: Setup, errors: Errors[Row], phase: Row, outward: Row, pairs: Pairs) -> int:
    """What of the constants is geometry, without which there is no play."""
    radius = setup.radius
    i = 0
    none = -1
    for j in range(setup.satellites):
        # A crank that is ahead turns its disc as well, through the ring.
        eta = errors.disc_phase[j] + errors.crank_phase[j] / setup.ratio
        own = setup.eccentricity + errors.eccentricity[j]
        half = math.sin(eta / 2)
        turn_r, turn_t = -2 * half * half, math.sin(eta)  # exp(i*eta) - 1
        pairs.phase[j] = phase[j] + errors.crank_phase[j]
        pairs.arm[j] = -2 * own if setup.exact else 1.0
        for n in range(setup.pins):
            rx, ry = outward[2 * n], outward[2 * n + 1]  # radial; tangential is (-ry, rx)
            p_r, p_t = errors.pin_radial[n], errors.pin_tangential[n]
            h_r, h_t = errors.hole_radial[i], errors.hole_tangential[i]
            larger = errors.hole_radius[i] - errors.pin_radius[n]
            gap = setup.clearance + larger - errors.eccentricity[j] + setup.loose
            off = abs(p_r) + abs(p_t) + abs(h_r) + abs(h_t) + abs(eta) * radius
            loose = abs(setup.clearance) + abs(larger) + abs(errors.eccentricity[j])
            if setup.exact:
                e_r = p_r - h_r - (turn_r * (radius + h_r) - turn_t * h_t)
                e_t = p_t - h_t - (turn_r * h_t + turn_t * (radius + h_r))
                ex, ey = e_r * rx - e_t * ry, e_r * ry + e_t * rx
                x, y = (radius + p_r) * rx - p_t * ry, (radius + p_r) * ry + p_t * rx
                pairs.x[i], pairs.y[i], pairs.ex[i], pairs.ey[i] = x, y, ex, ey
                pairs.k0[i] = ex * ex + ey * ey - gap * (2 * own + gap)
                pairs.k1[i] = 2 * (ex * x + ey * y - (x * x + y * y))
                pairs.k2[i] = 2 * (ex * y - ey * x)
                pairs.size[i] = (2 * abs(own) + off) * off
                pairs.size[i] += (loose + setup.loose) * (2 * abs(own) + abs(gap))
            else:
                e_r, e_t = p_r - h_r, p_t - h_t - eta * radius
                pairs.x[i], pairs.y[i] = -radius * ry, radius * rx
                pairs.ex[i], pairs.ey[i] = e_t * ry - e_r * rx, -e_r * ry - e_t * rx
                pairs.k0[i], pairs.k1[i], pairs.k2[i] = -gap, 0.0, 0.0
                pairs.size[i] = off + loose + setup.loose
            difference = setup.eccentricity + setup.clearance + larger
            pin = setup.pin_radius + errors.pin_radius[n]
            pairs.distance[i] = difference + setup.loose if setup.exact else difference
            if min(difference, pin, own) <= 0:
                none = i if none < 0 else none
            i += 1
    return none


def press(setup: Setup, law: Law, errors: Errors[Row], compliance: Row, pairs: Pairs) -> None:
    """What of the constants is elastic."""
    i = 0
    for j in range(setup.satellites):
        for n in range(setup.pins):
            larger = errors.hole_radius[i] - errors.pin_radius[n]
            difference = setup.eccentricity + setup.clearance + larger
            pin = setup.pin_radius + errors.pin_radius[n]
            pairs.curved[i] = difference / pin / (pin + difference)
            pairs.a[i], pairs.b[i], pairs.limit[i] = pair_law(
                setup.law, law, pin, difference, compliance[j]
            )
            i += 1
    if setup.support == TIED:
        join(setup, compliance, pairs)


def at(psi: float, setup: Setup, pairs: Pairs, room: Room) -> None:
    """The pairs at a wave angle; in reverse v changes its sign, and so does the lag."""
    px, py, ex, ey = pairs.x, pairs.y, pairs.ex, pairs.ey
    k0, k1, k2, q, u, v = pairs.k0, pairs.k1, pairs.k2, room.q, room.u, room.v
    way, exact, pins = setup.direction, setup.exact, setup.pins
    for j, phase in enumerate(pairs.phase):
        angle = psi + phase
        wx, wy = pairs.arm[j] * math.sin(angle), pairs.arm[j] * math.cos(angle)
        for i in range(j * pins, (j + 1) * pins):
            x, y = px[i], py[i]
            q[i] = wx * ex[i] + wy * ey[i] + k0[i]
            if exact:
                u[i] = wx * x + wy * y + k1[i]
                v[i] = way * (wx * y - wy * x + k2[i])
            else:
                v[i] = way * (wx * x + wy * y)


def play(setup: Setup, pairs: Pairs, room: Room) -> tuple[float, float, int, int]:
    """Least and largest lag at which no pair touches, and the pairs that touch there (-1: none).
    Where pairs press without load the first is larger than the second.
    """
    low, high, behind, onset = -math.inf, math.inf, -1, -1
    far = 2 * (setup.eccentricity + abs(setup.clearance)) / setup.radius
    for i in range(len(room.q)):
        q, v = room.q[i], room.v[i]
        if setup.exact:  # tangents of half the lags
            a = max(q - 2 * room.u[i], TINY)
            square = v * v - a * q
            if square < 0:
                return math.inf, -math.inf, -1, -1
            root = math.sqrt(square)
            if v >= 0:
                from_, to = -(v + root) / a, -q / (v + root) if v + root > 0 else 0.0
            else:
                from_, to = q / (root - v), (root - v) / a
        elif abs(v) * far <= abs(q) or abs(v) <= NO_LEVER * setup.radius:
            # at its dead angle: open or pressed at any lag, by more than rounding
            if q > NO_LEVER * setup.radius:
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
    if setup.exact:
        low, high = 2 * math.atan(low), 2 * math.atan(high)
    return low, high, behind, onset


def played(psi: float, setup: Setup, pairs: Pairs, room: Room) -> tuple[float, float]:
    """Limits of the play at a wave angle; the first is larger where pairs press."""
    at(psi, setup, pairs, room)
    if setup.support == SHARES:
        return mean_play(setup, pairs, room)
    low, high, _, _ = play(setup, pairs, room)
    return low, high


def mean_play(setup: Setup, pairs: Pairs, room: Room) -> tuple[float, float]:
    """The same of satellites that turn for themselves, weighted by their shares of the torque."""
    low = high = 0.0
    for j, share in enumerate(pairs.share):
        own_pairs, own = part(j, pairs, room)
        least, most, _, _ = play(setup, own_pairs, own)
        if least > most:
            return math.inf, -math.inf
        low, high = low + share * least, high + share * most
    return low, high


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
    for i in range(len(room.q)):
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


def balance(lag: float, setup: Setup, pairs: Pairs, room: Room) -> tuple[float, float, float]:
    """Torque of all pairs at a lag, its derivative, and the sum of its terms' sizes."""
    force, levers, contact = room.force, room.lever, room.stiffness
    distance, a, b = pairs.distance, pairs.a, pairs.b
    exact, kind, exponent, curve = setup.exact, setup.law, setup.exponent, setup.curve
    sine, half = math.sin(lag), math.sin(lag / 2)
    less = -2 * half * half
    cosine = 1 + less
    torque = slope = gross = 0.0
    for i, (q, u, v) in enumerate(zip(room.q, room.u, room.v)):  # noqa: B905 - not compiled
        approach = q + less * u + sine * v if exact else q + lag * v
        if approach <= TINY:  # below it powers leave the range of numbers
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
        f, stiffness = law(kind, approach, a[i], b[i], exponent, force[i], contact[i], curve)
        force[i], levers[i], contact[i] = f, lever, stiffness
        torque += f * lever
        gross += f * abs(lever)
        slope += stiffness * lever * lever + f * bend
    return torque, slope, gross


def start(torque: float, setup: Setup, pairs: Pairs, room: Room) -> float:
    """Lag at which the best placed pair alone would carry the torque, in first order."""
    best = math.inf
    for i in range(len(room.v)):
        v = room.v[i]
        twice = 2 * pairs.distance[i] if setup.exact else 1.0
        lever = v / twice
        if lever > 1e-12 * setup.radius:
            force, a, b = torque / lever, pairs.a[i], pairs.b[i]
            approach = alone(setup.law, force, a, b, setup.exponent, setup.curve)
            best = min(best, (approach * twice - room.q[i]) / v)
    return best


def solve(psi: float, torque: float, setup: Setup, pairs: Pairs, room: Room) -> Position:
    """Equilibrium of a position under a torque > 0; forces and levers are left in the room."""
    if setup.support == SHARES:
        return shares(psi, torque, setup, pairs, room)
    return together(psi, torque, setup, pairs, room)


def freed(psi: float, torque: float, setup: Setup, pairs: Pairs, room: Room) -> Freed:
    """Play of a position, from whose end the room counts the lag afterwards."""
    at(psi, setup, pairs, room)
    low, high, behind, onset = play(setup, pairs, room)
    error = max(
        touch_error(low, behind, psi, setup, pairs, room),
        touch_error(high, onset, psi, setup, pairs, room),
    )
    # Parts that just fit press by rounding only.
    pressed = low > high + error
    zero, lag = 0.0 if pressed else high, math.inf
    if zero < math.inf:
        shift(zero, -1 if pressed else onset, setup, pairs, room)
        lag = start(torque, setup, pairs, room)
    if pressed and lag < math.inf:
        lag = 0.0
    for i in range(len(room.force)):
        room.force[i] = 0.0
    return Freed(low, high, error, pressed, zero, lag)


def carry(
    torque: float, close: float, free: Freed, setup: Setup, pairs: Pairs, room: Room
) -> Carried:
    """Lag at which the pairs carry a torque, from a position without load: but for a last step of
    Newton that is `close` of the lag or less.

    Newton on torque^(1/exponent), which is convex and nearly straight for pure powers; pairs that
    press without load have other laws of growth.
    """
    lag, pressed = free.lag, free.pressed
    low, high = -math.inf if pressed else 0.0, math.inf
    power = 1.0 if pressed else 1 / setup.exponent
    step, status, far = 0, NOT_SOLVED, setup.eccentricity / setup.radius
    carried = slope = gross = change = 0.0
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
        if abs(carried - torque) <= EPS * gross or abs(change) <= close * abs(lag):
            status = SOLVED
            break
        if pressed:  # at its dead angle a pair hardly holds: no step beyond what is sought
            change = min(max(change, -far), far)
        following = within(lag, change, low, high, step)
        if following in (low, high):
            status, change = SOLVED, 0.0
            break
        lag = following
    return Carried(lag, carried, slope, gross, change, status, step)


def together(psi: float, torque: float, setup: Setup, pairs: Pairs, room: Room) -> Position:
    """Equilibrium of satellites that share a torque by one lag."""
    free = freed(psi, torque, setup, pairs, room)
    low, high, play_error, zero = free.low, free.high, free.error, free.zero
    if free.lag == math.inf:
        return Position(0.0, 0.0, low, high, play_error, 0.0, 0.0, NO_DRIVE, 0)
    by_play = 0.0 if free.pressed else play_error
    if setup.support in (CRANK, MESH):
        lag, status, step = give(torque, free, setup, pairs, room)
        slope, lag_error, force_error = given_errors(psi, torque, lag, setup, pairs, room)
        if slope <= 0:
            return Position(0.0, 0.0, low, high, play_error, 0.0, 0.0, NOT_SOLVED, step)
        for j in range(len(room.own_lag)):
            room.own_lag[j] = zero + (lag if setup.support == CRANK else room.own_lag[j])
        lag_error += by_play + EPS * abs(lag)
        return Position(
            zero + lag, slope, low, high, play_error, lag_error, force_error, status, step
        )
    found = carry(torque, EPS, free, setup, pairs, room)
    lag, slope, status, step = found.lag, found.slope, found.status, found.steps
    if slope <= 0:
        return Position(zero + lag, slope, low, high, play_error, 0.0, 0.0, NOT_STABLE, step)
    if setup.support == TIED:  # from where each pair would be with a pin of its own
        lag, status, more = tie(torque, lag, setup, pairs, room)
        slope, lag_error, force_error = tied_errors(psi, torque, lag, setup, pairs, room)
        step, status = step + more, status if slope > 0 else NOT_SOLVED
    else:
        lag_error, force_error = carried_errors(psi, torque, found, setup, pairs, room)
    lag_error += by_play + EPS * abs(lag)
    return Position(zero + lag, slope, low, high, play_error, lag_error, force_error, status, step)


def close_by(psi: float, torque: float, setup: Setup, pairs: Pairs, room: Room) -> Position:
    """What `solve` finds, without bounds of its errors: of rigid satellites the last step of Newton
    is taken along the tangents. What that leaves is `CLOSE` squared of forces and lag, and `CLOSE`
    of the stiffness; where contacts begin steeply, below the exponent 1, it is not done.
    """
    if setup.support != RIGID:
        return solve(psi, torque, setup, pairs, room)
    free = freed(psi, torque, setup, pairs, room)
    low, high, play_error = free.low, free.high, free.error
    if free.lag == math.inf:
        return Position(0.0, 0.0, low, high, play_error, 0.0, 0.0, NO_DRIVE, 0)
    close = CLOSE if setup.exponent >= 1 else EPS
    found = carry(torque, close, free, setup, pairs, room)
    slope, steps, status = found.slope, found.steps, found.status
    if slope <= 0:
        return Position(found.lag, slope, low, high, play_error, 0.0, 0.0, NOT_STABLE, steps)
    if close > EPS:
        for i, lever in enumerate(room.lever):
            room.force[i] = max(room.force[i] + room.stiffness[i] * lever * found.change, 0.0)
    lag = free.zero + found.lag + found.change
    unsure = 0.0 * slope  # not a number where that is none
    return Position(lag, slope, low, high, play_error, unsure, unsure, status, steps)


def carried_errors(
    psi: float, torque: float, found: Carried, setup: Setup, pairs: Pairs, room: Room
) -> tuple[float, float]:
    """Bounds of the errors of lag and forces as `carry` left the room.

    What the torque may be off, and with it the lag: by the balance, by rounding of its terms, and
    by rounding of each lever and approach, which that of the wave angle moves.
    """
    off = abs(found.torque - torque) + 4 * EPS * (found.gross + torque)
    rounding = EPS * (4 + 2 * abs(psi))
    for force in room.force:
        off += rounding * force * setup.radius
    for i in range(len(room.unsure)):
        twice = 2 * pairs.distance[i] if setup.exact else 1.0
        near = rounding * (room.unsure[i] / twice + abs(found.lag) * setup.radius)
        room.unsure[i] = near
        off += room.stiffness[i] * abs(room.lever[i]) * near
    lag_error = off / found.slope
    force_error = 0.0
    for i in range(len(room.unsure)):
        near = abs(room.lever[i]) * lag_error + room.unsure[i]
        force_error = max(force_error, room.stiffness[i] * near + 8 * EPS * room.force[i])
    return lag_error, force_error


def part(j: int, pairs: Pairs, room: Room) -> tuple[Pairs, Room]:
    """Satellite j by itself, in the same rows."""
    pins = len(room.force) // len(pairs.phase)
    a, b, c, d = j * pins, (j + 1) * pins, j, j + 1
    return (
        Pairs(
            pairs.arm[c:d],
            pairs.phase[c:d],
            pairs.share[c:d],
            pairs.x[a:b],
            pairs.y[a:b],
            pairs.ex[a:b],
            pairs.ey[a:b],
            pairs.k0[a:b],
            pairs.k1[a:b],
            pairs.k2[a:b],
            pairs.distance[a:b],
            pairs.size[a:b],
            pairs.a[a:b],
            pairs.b[a:b],
            pairs.limit[a:b],
            pairs.curved[a:b],
            pairs.give,
            pairs.ends,
        ),
        Room(
            room.q[a:b],
            room.u[a:b],
            room.v[a:b],
            room.unsure[a:b],
            room.force[a:b],
            room.lever[a:b],
            room.stiffness[a:b],
            room.own_lag[c:d],
            room.own_moves[c:d],
            room.own_error[c:d],
            room.approach,
            room.before,
            room.moved,
            room.system,
        ),
    )


def shares(psi: float, torque: float, setup: Setup, pairs: Pairs, room: Room) -> Position:
    """Every satellite under its share of a torque. Lag, stiffness and play of the position are
    those of a linkage that shares it so: the mean lag of the satellites, weighted by the shares.
    """
    lag = low = high = play_error = lag_error = force_error = gives = most = 0.0
    status, steps, pressed = SOLVED, 0, False
    for j, share in enumerate(pairs.share):
        own_pairs, own = part(j, pairs, room)
        found = together(psi, share * torque, setup, own_pairs, own)
        room.own_lag[j] = found.lag
        most = max(most, abs(found.lag))
        lag, play_error = lag + share * found.lag, play_error + share * found.play_error
        low, high = low + share * found.low, high + share * found.high
        lag_error += share * found.lag_error
        force_error = max(force_error, found.force_error)
        pressed = pressed or found.low > found.high + found.play_error
        gives += share * (share / found.stiffness) if found.stiffness > 0 else math.inf
        status = found.status if status == SOLVED else status
        steps += found.steps
    if pressed:
        low, high = math.inf, -math.inf
    lag_error += EPS * (1 + len(pairs.share)) * most
    return Position(lag, 1 / gives, low, high, play_error, lag_error, force_error, status, steps)


def judged(position: Position, setup: Setup, pairs: Pairs, room: Room) -> int:
    """Whether a position can be, as `solve` left the room: a status."""
    if position.status == NO_DRIVE:
        return NO_DRIVE
    if abs(position.lag) > RADIAN:
        return NOT_STABLE if setup.exact else TOO_FAR
    if position.status != SOLVED:
        return position.status
    if not math.isfinite(position.force_error):
        return NOT_SOLVED
    return TOO_WIDE if too_wide(pairs, room) >= 0 else SOLVED


def too_wide(pairs: Pairs, room: Room) -> int:
    """The pair whose force is beyond its law, or -1."""
    for i, force in enumerate(room.force):
        if force > pairs.limit[i]:
            return i
    return -1


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
        for i in range(len(room.q)):
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


def pressing(low: float, high: float, setup: Setup, pairs: Pairs, room: Room) -> float:
    """The same of satellites that turn for themselves where their shares are given."""
    if setup.support != SHARES:
        return interference(low, high, setup, pairs, room)
    worst = -math.inf
    for j in range(len(pairs.share)):
        own_pairs, own = part(j, pairs, room)
        worst = max(worst, interference(low, high, setup, own_pairs, own))
    return worst
