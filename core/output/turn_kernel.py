"""Quantities over the turn, and of the pieces of a study, from the equilibria of
`sharing_kernel`; rules in `loop_rows`.
"""

import math
from collections.abc import Sequence

from core.output.contact_kernel import excess
from core.output.loop_rows import (
    BACKLASH,
    BINDS,
    FIT_POSITIONS,
    FITS,
    FORCE,
    GOLDEN,
    JUST,
    LAG,
    LOST_MOTION,
    MESH,
    NEAR,
    NOWHERE,
    PLACE,
    PLAY_END,
    PRESSURE,
    SHARES,
    SOLVED,
    STIFFNESS,
    SURE,
    TIED,
    TINY,
    Around,
    Errors,
    Law,
    Load,
    Pairs,
    Pieces,
    Poses,
    Room,
    Row,
    Setup,
)
from core.output.sharing_kernel import (
    close_by,
    judged,
    part,
    place,
    play,
    played,
    press,
    solve,
)
from core.output.tied_kernel import ring_torque


def wave_torque(psi: float, lag: float, setup: Setup, pairs: Pairs, room: Room) -> float:
    """Torque of the forces in the room on the wave, at the lag that balances them: the sum of each
    times the derivative of its approach by the wave angle.
    """
    way, sine, half = setup.direction, math.sin(lag), math.sin(lag / 2)
    less, total = -2 * half * half, 0.0
    for j, arm in enumerate(pairs.arm):
        angle = psi + pairs.phase[j]
        wx, wy = arm * math.sin(angle), arm * math.cos(angle)
        turned = room.own_lag[j] if setup.support in (MESH, SHARES) else lag
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
                grown += turned * way * (wy * x - wx * y)
            total += room.force[i] * grown
    return total - ring_torque(psi, setup, pairs, room) if setup.support == TIED else total


def largest(room: Room) -> float:
    """Largest force of the room."""
    best = 0.0
    for force in room.force:
        best = max(best, force)
    return best


def hardest(setup: Setup, pairs: Pairs, room: Room) -> float:
    """Largest force over reduced radius of the room, of contacts that wrap times the square of
    their pressure over Hertz's.
    """
    best, wrap = 0.0, setup.wrap
    within = setup.loose if setup.exact else 0.0  # lets the centres move, not the radii grow
    for i, force in enumerate(room.force):
        pressed = force * pairs.curved[i]
        most = wrap.modulus * (pairs.distance[i] - within)
        if force > wrap.since * most:
            pressed *= excess(force / most, wrap)
        best = max(best, pressed)
    return best


def loaded(room: Room) -> int:
    """Number of pairs with a force."""
    count = 0
    for force in room.force:
        if force > 0:
            count += 1
    return count


def input_torque(
    psi: float, torque: float, lag: float, setup: Setup, pairs: Pairs, room: Room
) -> float:
    """Torque that turns the crank without friction, as `solve` left the room."""
    on_wave = wave_torque(psi, lag, setup, pairs, room)
    return setup.direction * torque / setup.ratio + (1 + 1 / setup.ratio) * on_wave


def poses(
    places: Row, torque: float, setup: Setup, pairs: Pairs, room: Room, results: Poses
) -> int:
    """Positions at wave angles; the first one that cannot be, or -1."""
    count = len(room.force)
    for k, psi in enumerate(places):
        found = solve(psi, torque, setup, pairs, room)
        if judged(found, setup, pairs, room) != SOLVED:
            return k
        for i in range(count):
            results.forces[k * count + i] = room.force[i]
        results.lag[k], results.stiffness[k] = found.lag, found.stiffness
        results.force[k], results.pressure[k] = largest(room), hardest(setup, pairs, room)
        results.loaded[k] = loaded(room)
        results.low[k], results.high[k] = found.low, found.high
        results.lag_error[k], results.play_error[k] = found.lag_error, found.play_error
        results.force_error[k] = found.force_error
        results.input_torque[k] = input_torque(psi, torque, found.lag, setup, pairs, room)
    return -1


def value(kind: int, psi: float, load: Load, pairs: Pairs, room: Room) -> tuple[float, bool]:
    """A quantity at a wave angle, and whether the position can be."""
    if kind in (PLAY_END, BACKLASH):
        low, high = played(psi, load.setup, pairs, room)
        return high if kind == PLAY_END else max(high - low, 0.0), True
    both, can = 0.0, True
    for back in range(2 if kind == LOST_MOTION else 1):
        setup = load.back if back else load.setup
        torque = load.share * load.torque if kind == LOST_MOTION else load.torque
        found = solve(psi, torque, setup, pairs, room)
        both += found.lag
        can = can and judged(found, setup, pairs, room) == SOLVED
    if kind == LOST_MOTION:
        return both, can
    most = largest(room)
    if kind == FORCE:
        return most, can
    if kind == PRESSURE:
        return hardest(setup, pairs, room), can
    if kind == LAG:
        return found.lag, can
    if kind == STIFFNESS:
        return found.stiffness, can
    return other(kind, psi, found.lag, load, pairs, room), can


def other(kind: int, psi: float, lag: float, load: Load, pairs: Pairs, room: Room) -> float:
    """What is looked at besides, as `solve` left the room: the torque of the crank."""
    return input_torque(psi, load.torque, lag, load.setup, pairs, room)


def values(kind: int, places: Row, load: Load, pairs: Pairs, room: Room, results: Row) -> int:
    """A quantity at wave angles; the first position that cannot be, or -1."""
    for k, psi in enumerate(places):
        results[k], can = value(kind, psi, load, pairs, room)
        if not can:
            return k
    return -1


def narrow(
    kind: int, sign: int, low: float, high: float, load: Load, pairs: Pairs, room: Room
) -> tuple[float, float, float, int]:
    """Place and height of the largest value between two places, or of the least for the sign -1, by
    golden section, which asks for no derivative; its error, by how much it changed while the width
    was narrowed to its last sixteenth; and at how many places it looked: 0 where the place is one
    that cannot be.
    """
    error, looks, left = 0.0, 0, True
    a, b = high - GOLDEN * (high - low), low + GOLDEN * (high - low)
    at_a = at_b = 0.0
    while looks < 2 or high - low > PLACE:
        if looks >= 2:
            if high - low < 16 * PLACE:
                error = max(error, abs(at_a - at_b))
            left = sign * at_a >= sign * at_b
            if left:
                high, b, at_b = b, a, at_a
                a = high - GOLDEN * (high - low)
            else:
                low, a, at_a = a, b, at_b
                b = low + GOLDEN * (high - low)
        psi = a if left else b
        looked, can = value(kind, psi, load, pairs, room)
        if not can:
            return psi, 0.0, 0.0, 0
        if left:
            at_a = looked
        else:
            at_b = looked
        looks += 1
        left = False
    if sign * at_a >= sign * at_b:
        return a, at_a, error, looks
    return b, at_b, error, looks


def clear(psi: float, lag: float, setup: Setup, pairs: Pairs, room: Room) -> float:
    """How far the wave may turn on from where `at` was called before any pair can touch at a lag,
    rad.

    At one lag what `at` makes of a pair is ``k + m*cos(psi - psi_0)``: it changes by no more than m
    for each radian, and of ``k + m < 0`` the pair touches nowhere.
    """
    sine, half = math.sin(lag), math.sin(lag / 2)
    less, far = -2 * half * half, 2 * math.pi
    if not setup.exact:
        sine = lag
    for j in range(len(pairs.arm)):
        arm = abs(pairs.arm[j])
        for i in range(j * setup.pins, (j + 1) * setup.pins):
            x, y, own = pairs.x[i], pairs.y[i], setup.direction * sine
            if setup.exact:
                over = room.q[i] + less * room.u[i] + sine * room.v[i]
                middle = pairs.k0[i] + less * pairs.k1[i] + own * pairs.k2[i]
                a, b = pairs.ex[i] + less * x + own * y, pairs.ey[i] + less * y - own * x
            else:
                over, middle = room.q[i] + lag * room.v[i], pairs.k0[i]
                a, b = pairs.ex[i] + own * x, pairs.ey[i] + own * y
            if over >= 0:
                return 0.0
            square = arm * arm * (a * a + b * b)
            if middle * middle > square:
                continue
            most = math.sqrt(square)
            if -over < most * far:
                far = -over / most
    return far


def ahead(psi: float, low: float, high: float, setup: Setup, pairs: Pairs, room: Room) -> float:
    """The same at the middle of the play, of given shares of each satellite's own."""
    if setup.support != SHARES:
        return clear(psi, (low + high) / 2, setup, pairs, room) if high - low < math.inf else 0.0
    far = 2 * math.pi
    for j in range(len(pairs.share)):
        own_pairs, own = part(j, pairs, room)
        least, most, _, _ = play(setup, own_pairs, own)
        if most - least < math.inf:
            far = min(far, clear(psi, (least + most) / 2, setup, own_pairs, own))
        else:
            far = 0.0
    return far


def fitting(setup: Setup, pairs: Pairs, room: Room) -> int:
    """Whether a piece goes together without load: FITS, BINDS or NOWHERE. Positions up to which no
    pair can touch at the middle of the play are not looked at.
    """
    free = blocked = False
    step = 2 * math.pi / FIT_POSITIONS
    k = 0
    while k < FIT_POSITIONS and not (free and blocked):
        psi = k * step
        low, high = played(psi, setup, pairs, room)
        if low <= high + JUST * setup.eccentricity / setup.radius:
            free = True
            k += int(ahead(psi, low, high, setup, pairs, room) / step)
        else:
            blocked = True
        k += 1
    if free and blocked:
        return BINDS
    return FITS if free else NOWHERE


def widest(setup: Setup, pairs: Pairs, around: Around, room: Room) -> float:
    """Largest play over even positions of the wave, 0 where all press.

    Only where it can be the largest the play is looked at: at the others it is no wider than
    `at_most` says. First where it may be widest.
    """
    at_most(setup, pairs, around)
    width, most, first = around.width, 0.0, 0
    for k in range(len(width)):
        if width[k] > width[first]:
            first = k
    for step in range(len(width)):
        k = (first + step) % len(width)
        if width[k] > most:
            width[k] = -math.inf
            low, high = played(2 * math.pi * k / len(width), setup, pairs, room)
            most = max(most, high - low)
    return most


def at_most(setup: Setup, pairs: Pairs, around: Around) -> None:
    """Bounds of the play, where there is any, at even positions of the wave: in the row `width`.

    A pair does not touch where ``a*t^2 + 2*v*t + q <= 0``, t the tangent of half the lag; lags are
    no further apart than twice their t. With a lever v above 0 that ends at ``t = -q/(v + s)``,
    ``s = sqrt(v^2 - a*q)``: no later than with s = v, as a parabola is above its tangent. While the
    pair is open all around ``-a*q`` is no less than m, of the least a and the least -q, and s no
    less than the tangent of ``sqrt(v^2 + m)`` at the longest lever: ``v + s >= 2*(c + d*v)``. With
    a lever below 0 it begins there. In first order ``q + lag*v <= 0`` is as that of m = 0.

    The play, from the last begin to the first end, is no wider than between any two of these.
    Rounding of the terms is 1e-12 of them, also of the lever, above `NEAR` of the longest: `SURE`
    is added. First order looks at no pair near its dead angle, nor is that one a bound.
    """
    front, back, sine, cosine = around.front, around.back, around.sine, around.cosine
    far = math.inf
    if not setup.exact:
        far = (1 - SURE) * 2 * (setup.eccentricity + abs(setup.clearance)) / setup.radius
    apart = setup.support == SHARES
    for k in range(len(front)):
        front[k] = back[k] = math.inf
        around.width[k] = 0.0
    for j in range(setup.satellites):
        sx, cx = math.sin(pairs.phase[j]), math.cos(pairs.phase[j])
        sx, cx = pairs.arm[j] * sx, pairs.arm[j] * cx
        for i in range(j * setup.pins, (j + 1) * setup.pins):
            ex, ey = pairs.ex[i], pairs.ey[i]
            vx, vy = (pairs.y[i], -pairs.x[i]) if setup.exact else (pairs.x[i], pairs.y[i])
            arm, reach = abs(pairs.arm[j]), math.sqrt(vx * vx + vy * vy)
            longest, m = arm * reach + abs(pairs.k2[i]), 0.0
            if setup.exact:
                open_by, swing = -pairs.k0[i], arm * (abs(ex) + abs(ey))
                steep = -2 * pairs.k1[i] - 2 * arm * reach - open_by - swing
                m = max(steep, 0.0) * max(open_by - swing - SURE * pairs.size[i], 0.0)
            half = 0.5 / max(math.sqrt(longest * longest + m), TINY)
            c, d = max(m * half, TINY), 0.5 + longest * half
            # of the crank's direction arm*(sin(psi + phase), cos(psi + phase))
            way, least = setup.direction * d, NEAR * longest * d
            v_s, v_c, v_0 = way * (cx * vx - sx * vy), way * (sx * vx + cx * vy), way * pairs.k2[i]
            q_s, q_c = cx * ex - sx * ey, sx * ex + cx * ey
            q_0 = SURE * pairs.size[i] - pairs.k0[i]
            for k in range(len(front)):
                v = v_s * sine[k] + v_c * cosine[k] + v_0
                end = (q_0 - q_s * sine[k] - q_c * cosine[k]) / (c + abs(v))
                front[k] = min(front[k], end if v > least else math.inf)
                back[k] = min(back[k], end if v < -least else math.inf)
        if apart or j == setup.satellites - 1:
            weight = pairs.share[j] if apart else 1.0
            for k in range(len(front)):
                end, begin = front[k], back[k]
                between = end + begin + SURE * (abs(end) + abs(begin))
                around.width[k] += weight * between if max(end, begin) < far else math.inf
                front[k] = back[k] = math.inf


def piece(
    sample: int,
    under_load: bool,
    lost: bool,
    load: Load,
    pairs: Pairs,
    around: Around,
    room: Room,
    results: Pieces,
) -> bool:
    """Quantities of a piece that fits, over even positions of the wave; whether it can work. What
    takes the forces under load, and the lost motion, are taken only where they are asked.
    """
    peak = pressure = backlash = motion = 0.0
    least_lag, most_lag, stiffness = math.inf, -math.inf, math.inf
    results.fits[sample] = fitting(load.setup, pairs, room)
    if results.fits[sample] != FITS:
        return False
    if not under_load:
        backlash = widest(load.setup, pairs, around, room)
    positions = len(around.sine) if under_load or lost else 0
    for k in range(positions):
        psi = 2 * math.pi * k / positions
        if under_load:
            found = close_by(psi, load.torque, load.setup, pairs, room)
            if judged(found, load.setup, pairs, room) != SOLVED:
                return False
            peak = max(peak, largest(room))
            pressure = max(pressure, hardest(load.setup, pairs, room))
            least_lag, most_lag = min(least_lag, found.lag), max(most_lag, found.lag)
            stiffness = min(stiffness, found.stiffness)
            backlash = max(backlash, found.high - found.low)
        if lost:
            both, can = value(LOST_MOTION, psi, load, pairs, room)
            if not can:
                return False
            motion = both if k == 0 else max(motion, both)
    results.peak_force[sample], results.max_pressure[sample] = peak, pressure
    results.transmission_error[sample] = most_lag - least_lag
    results.backlash_max[sample], results.lost_motion[sample] = backlash, motion
    results.stiffness_min[sample] = stiffness
    return True


def none(sample: int, results: Pieces) -> None:
    """Quantities of a piece that does not fit or cannot work."""
    results.peak_force[sample] = results.max_pressure[sample] = math.nan
    results.transmission_error[sample] = results.backlash_max[sample] = math.nan
    results.lost_motion[sample] = results.stiffness_min[sample] = math.nan


def pieces(
    errors: Errors[Sequence[Row]],
    under_load: bool,
    lost: bool,
    law: Law,
    load: Load,
    phase: Row,
    compliance: Row,
    outward: Row,
    pairs: Pairs,
    around: Around,
    room: Room,
    results: Pieces,
) -> None:
    """Quantities of many pieces."""
    for sample in range(len(errors.pin_radial)):
        own = Errors(
            errors.pin_radial[sample],
            errors.pin_tangential[sample],
            errors.pin_radius[sample],
            errors.hole_radial[sample],
            errors.hole_tangential[sample],
            errors.hole_radius[sample],
            errors.eccentricity[sample],
            errors.crank_phase[sample],
            errors.disc_phase[sample],
        )
        can = place(load.setup, own, phase, outward, pairs) < 0
        if can and (under_load or lost):
            press(load.setup, law, own, compliance, pairs)
        if not (can and piece(sample, under_load, lost, load, pairs, around, room, results)):
            none(sample, results)
