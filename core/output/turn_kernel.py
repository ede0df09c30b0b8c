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
    NOWHERE,
    PLACE,
    PLAY_END,
    PRESSURE,
    SHARES,
    SOLVED,
    STIFFNESS,
    TIED,
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
from core.output.sharing_kernel import close_by, judged, part, play, played, prepare, solve
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
    for each radian.
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
                most = arm * math.hypot(
                    pairs.ex[i] + less * x + own * y, pairs.ey[i] + less * y - own * x
                )
            else:
                over = room.q[i] + lag * room.v[i]
                most = arm * math.hypot(pairs.ex[i] + own * x, pairs.ey[i] + own * y)
            if over >= 0:
                return 0.0
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


def piece(
    sample: int,
    positions: int,
    under_load: bool,
    lost: bool,
    load: Load,
    pairs: Pairs,
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
            low, high = found.low, found.high
        else:
            low, high = played(psi, load.setup, pairs, room)
        backlash = max(backlash, high - low)
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
    positions: int,
    under_load: bool,
    lost: bool,
    law: Law,
    load: Load,
    phase: Row,
    compliance: Row,
    pairs: Pairs,
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
        can = prepare(load.setup, law, own, phase, compliance, pairs) < 0
        if not (can and piece(sample, positions, under_load, lost, load, pairs, room, results)):
            none(sample, results)
