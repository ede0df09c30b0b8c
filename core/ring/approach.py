"""Approach of a cycloid disc to the pins of its ring: what of the loops over pairs is the ring's.

The functions stand for those of the same names of `core.output.sharing_kernel`, whose equilibrium
then is the mesh's, and keep its rules. The lag is that of the disc's teeth behind their ideal
angle; the wave angle is the crank angle. Seen from a pin's place on the disc's edge, complex
numbers being turned by ``-i*exp(i*t)``, all depends on the angle a from the crank to the pin:

    P_0 = R + rho + i*tau - (e + de)*exp(-i*a),   P = P_0*exp(i*(lag + eta))
    G(s) = exp(-i*s) - K*exp(-i*a)*exp(-i*z_p*s),   normal n = G/|G| at the foot s of P on the path
    D = (rho + i*tau - dR) - de*exp(-i*a) - m(-lag - eta)*P_0 + R_m*m(s) - e*exp(-i*a)*m(z_p*s)

with ``m(x) = 1 - exp(-i*x)``: no difference of large numbers. The approach is ``dr - dr_m - n.D``.
First order in lag and errors: ``h*lag - g``.
"""

import math
from collections.abc import Sequence
from typing import Any

from core.output.contact_kernel import law, line_law, pair_law
from core.output.loop_rows import (
    EPS,
    HERTZ,
    INPUT_TORQUE,
    NOT_STABLE,
    SOLVED,
    TINY,
    TOO_FAR,
    Law,
    Load,
    Position,
    Row,
)
from core.output.sharing_kernel import judged as judged_by_lag
from core.output.sharing_kernel import start as start_alone
from core.output.sharing_kernel import touch_error as touch_error_alone
from core.ring.exact_touch import (
    NO_TURN,
    MeshPairs,
    MeshRoom,
    MeshSetup,
    Touch,
    first_touch,
    freest,
    passed,
    quarter,
    reach,
    rounded,
    straddles,
    touch,
    touched,
    worst_at,
)

ALONG_MOST, ALONG_LEAST, RUB, RUB_AND_PRESS = range(8, 12)
"""What is looked at over the turn besides: the largest and the least force of a disc along its
crank; the largest product of a pair's distance to the pitch point and its force, N*m, or the root
of force over reduced radius, m*sqrt(N/m)."""


def prepare_mesh(
    setup: MeshSetup,
    own_law: Law,
    errors: Sequence[Row],
    phase: Row,
    compliance: Row,
    pairs: MeshPairs,
) -> int:
    """Constants of the pairs from the deviations: of the pins radial, tangential, of their radius,
    of eccentricities, of crank and disc phases; the pair with no radius left, or -1.
    """
    radial, tangential, larger, eccentric, crank, disc = errors
    i, none = 0, -1
    for j in range(setup.satellites):
        pairs.phase[j] = phase[j] + crank[j]
        pairs.own[j], pairs.off[j] = setup.eccentricity + eccentric[j], eccentric[j]
        pairs.eta[j] = disc[j] + crank[j] / setup.ratio
        for k in range(setup.pins):
            beta = 2 * math.pi * k / setup.pins
            pairs.cosine[i], pairs.sine[i] = math.cos(beta), math.sin(beta)
            pairs.radial[i], pairs.tangential[i] = radial[k], tangential[k]
            pairs.larger[i] = larger[k]
            pairs.moved[i] = abs(radial[k]) + abs(tangential[k]) + abs(eccentric[j])
            pairs.moved[i] += abs(setup.pin_circle) + abs(pairs.eta[j]) * setup.radius
            pairs.size[i] = pairs.moved[i] + abs(larger[k]) + abs(setup.equidistant)
            pairs.size[i] += setup.rotation * setup.radius
            pin = setup.pin_radius + larger[k]
            if min(pin, pairs.own[j]) <= 0:
                none = i if none < 0 else none
            elif setup.law == HERTZ:
                a, b, limit = line_law(own_law, pin, 1.0, compliance[j])
                pairs.base[i], pairs.b[i], pairs.most[i] = a, b, limit
            else:
                pairs.a[i], pairs.b[i], pairs.limit[i] = pair_law(
                    setup.law, own_law, pin, 1.0, compliance[j]
                )
            i += 1
    return none


def at(psi: float, setup: MeshSetup, pairs: MeshPairs, room: MeshRoom) -> None:
    """The pairs at a crank angle, in first order, and their laws at the curvatures there."""
    e, radius, way = setup.eccentricity, setup.radius, setup.direction
    k1, k = e * setup.pins / radius, e * setup.pins / setup.tool_circle
    longest = e * (setup.pins - 1)
    i = 0
    for phase, eta, off in zip(pairs.phase, pairs.eta, pairs.off):  # noqa: B905 - not compiled
        angle = psi + phase
        c, s = math.cos(angle), math.sin(angle)
        for _ in range(setup.pins):
            ca = c * pairs.cosine[i] - s * pairs.sine[i]
            sa = s * pairs.cosine[i] + c * pairs.sine[i]
            less = sa * sa / (1 + ca) if ca > 0 else 1 - ca  # 1 - cos a
            room.cosine[i], room.sine[i] = ca, sa
            slope = math.sqrt((1 - k1) * (1 - k1) + 2 * k1 * less)
            lever = -longest * sa / slope
            gap = setup.equidistant - pairs.larger[i] - eta * lever
            gap += (pairs.radial[i] - setup.pin_circle) * (1 - k1 + k1 * less) / slope
            gap += (pairs.tangential[i] * k1 * sa + off * (k1 - 1 + less)) / slope
            room.q[i], room.v[i] = -gap - setup.rotation * abs(lever), way * lever
            room.foot[i] = room.u[i] = 0.0
            slope = math.sqrt((1 - k) * (1 - k) + 2 * k * less)
            bend = (1 - k) * (1 - setup.pins * k) + (setup.pins + 1) * k * less
            bend /= setup.tool_circle * slope * slope * slope
            room.slope[i], room.steep[i] = slope, 1 / slope
            pin = setup.pin_radius + pairs.larger[i]
            # A pin that is wider than its valley has no such contact: as good as flat.
            curved = max(1 / pin + bend / (1 - setup.tool * bend), EPS / pin)
            pairs.curved[i] = curved
            if setup.law == HERTZ:
                pairs.a[i] = pairs.base[i] + pairs.b[i] * math.log(curved)
                pairs.limit[i] = pairs.most[i] * curved
            i += 1


def play(setup: MeshSetup, pairs: MeshPairs, room: MeshRoom) -> tuple[float, float, int, int]:
    """Least and largest lag at which no pair touches, and the pairs that touch there (-1: none).
    Where pairs press without load the first is larger than the second.
    """
    low, high, behind, onset = -math.inf, math.inf, -1, -1
    longest, far, free = setup.eccentricity * (setup.pins - 1), quarter(setup), True
    for i in range(len(room.force)):
        q, v = room.q[i], room.v[i]
        if abs(v) < NO_TURN * longest:  # at its dead angle: open or pressed at any lag
            free = free and (q <= 0 or q <= rounded(i, 0.0, setup, pairs))
        elif v > 0 and -q / v < high:
            high, onset = -q / v, i
        elif v < 0 and -q / v > low:
            low, behind = -q / v, i
    if setup.foot:
        if onset >= 0:
            high, onset, sure = touched(1.0, high, onset, setup, pairs, room)
            free = free and sure
        if behind >= 0:
            low, behind, sure = touched(-1.0, low, behind, setup, pairs, room)
            free = free and sure
        free = free and (low > high or not passed(low, high, setup, pairs, room))
    if free or low > high:
        return low, high, behind, onset
    lag, worst = freest(-far, far, setup, pairs, room)
    pin = worst_at(lag, setup, pairs, room)[2]
    if worst > rounded(pin, lag, setup, pairs):
        return lag + worst / longest, lag - worst / longest, -1, -1
    if not setup.foot:
        return low, high, behind, onset
    low, behind = first_touch(lag, -far, setup, pairs, room)
    high, onset = first_touch(lag, far, setup, pairs, room)
    return low, high, behind, onset


def touch_error(lag: float, pair: int, psi: float, setup: Any, pairs: Any, room: Any) -> float:
    """By how much rounding moves the lag at which a pair touches, which of a pin that was at its
    dead angle has a lever there alone; as `at` left the room.
    """
    if pair < 0 or abs(room.v[pair]) >= NO_TURN * setup.eccentricity * (setup.pins - 1):
        return touch_error_alone(lag, pair, psi, setup, pairs, room)
    off = EPS * (4 + 2 * abs(psi)) * (pairs.size[pair] + abs(lag) * setup.radius)
    j, most = pair // setup.pins, quarter(setup)
    there = touch(pair, j, lag, setup, pairs, room).approach
    error: float = off / setup.radius
    while error < most:
        ahead = touch(pair, j, lag + error, setup, pairs, room).approach
        behind = touch(pair, j, lag - error, setup, pairs, room).approach
        if max(abs(ahead - there), abs(behind - there)) > 3 * off:  # each is off by so much
            break
        error *= 2
    return error


def shift(lag: float, onset: int, setup: MeshSetup, pairs: MeshPairs, room: MeshRoom) -> None:
    """Count the lag from here on, where the pair `onset` (-1: none) just touches and the others do
    not, but those at their dead angles.
    """
    dead = NO_TURN * setup.eccentricity * (setup.pins - 1)
    for i in range(len(room.force)):
        room.unsure[i] = pairs.size[i] + abs(lag) * setup.radius
        approach = room.q[i] + lag * room.v[i]
        free = onset >= 0 and abs(room.v[i]) >= dead
        moved = pairs.moved[i] + abs(lag) * setup.radius
        if setup.foot and reach(i, approach, moved, moved, setup, pairs, room):
            one = touch(i, i // setup.pins, lag, setup, pairs, room)
            approach, room.v[i], room.u[i] = one.approach, one.lever, 1.0
        room.q[i] = min(approach, 0.0) if free else approach
        if i == onset:
            room.q[i] = 0.0
        room.fixed[i] = room.q[i] - approach
    room.zero[0] = lag


def start(torque: float, setup: Any, pairs: Any, room: Any) -> float:
    """Lag at which the best placed pair alone would carry the torque, in first order; not where
    others take over from it: the torque grows up to about a quarter of a lobe's pitch.
    """
    lag = start_alone(torque, setup, pairs, room)
    if setup.foot and lag < math.inf:
        lag = min(lag, max(math.pi / 4 / (setup.pins - 1) - room.zero[0], 0.0))
    return lag


def balance(
    lag: float, setup: MeshSetup, pairs: MeshPairs, room: MeshRoom
) -> tuple[float, float, float]:
    """Torque of all pairs at a lag, its derivative, and the sum of its terms' sizes."""
    force, levers, contact = room.force, room.lever, room.stiffness
    torque = slope = gross = 0.0
    whole, far = room.zero[0] + lag, abs(room.zero[0]) + abs(lag)
    for j in range(len(room.own_lag)):
        room.own_lag[j] = whole
    for i in range(len(room.force)):
        lever, bend = room.v[i], 0.0
        approach = room.q[i] + lag * lever
        moved, way = abs(lag) * setup.radius, pairs.moved[i] + far * setup.radius
        if room.u[i] == 0:
            moved = way
        if setup.foot and reach(i, approach, moved, way, setup, pairs, room):
            one = touch(i, i // setup.pins, whole, setup, pairs, room)
            approach, lever, bend = one.approach + room.fixed[i], one.lever, one.bend
        if approach <= TINY:
            force[i] = levers[i] = contact[i] = 0.0
            continue
        f, stiffness = law(
            setup.law,
            approach,
            pairs.a[i],
            pairs.b[i],
            setup.exponent,
            force[i],
            contact[i],
            setup.curve,
        )
        force[i], levers[i], contact[i] = f, lever, stiffness
        torque += f * lever
        gross += f * abs(lever)
        slope += stiffness * lever * lever + f * bend
        if setup.foot and straddles(i, setup, pairs):
            f, stiffness, one = beside(i, i // setup.pins, whole, setup, pairs, room)
            torque += f * one.lever
            gross += f * abs(one.lever)
            slope += stiffness * one.lever * one.lever + f * one.bend
    return torque, slope, gross


def beside(
    i: int, j: int, lag: float, setup: MeshSetup, pairs: MeshPairs, room: MeshRoom
) -> tuple[float, float, Touch]:
    """Force and stiffness of a pin that presses one flank of a valley on the other one, and where:
    the smaller force, or none.
    """
    one = touch(i, j, lag, setup, pairs, room, True)
    approach = one.approach + room.fixed[i]
    if approach <= TINY:
        return 0.0, 0.0, one
    a, b, power, curve = pairs.a[i], pairs.b[i], setup.exponent, setup.curve
    f, stiffness = law(setup.law, approach, a, b, power, 0.0, 0.0, curve)
    return f, stiffness, one


def skipped(lags: Row, setup: MeshSetup, pairs: MeshPairs) -> bool:
    """Whether a disc has turned by half a pitch of its lobes, past which other pins hold it."""
    for lag, eta in zip(lags, pairs.eta):  # noqa: B905 - not compiled
        if abs(setup.direction * lag + eta) * (setup.pins - 1) >= math.pi:
            return True
    return False


def judged(position: Position, setup: Any, pairs: Any, room: Any) -> int:
    """Whether a position can be, as `solve` left the room: a status."""
    status = judged_by_lag(position, setup, pairs, room)
    held = status in (SOLVED, TOO_FAR)
    return NOT_STABLE if setup.foot and held and skipped(room.own_lag, setup, pairs) else status


def part(j: int, pairs: MeshPairs, room: MeshRoom) -> tuple[MeshPairs, MeshRoom]:
    """Disc j by itself, in the same rows."""
    pins = len(room.force) // len(pairs.phase)
    a, b, c, d = j * pins, (j + 1) * pins, j, j + 1
    return (
        MeshPairs(
            pairs.phase[c:d],
            pairs.share[c:d],
            pairs.own[c:d],
            pairs.off[c:d],
            pairs.eta[c:d],
            pairs.cosine[a:b],
            pairs.sine[a:b],
            pairs.radial[a:b],
            pairs.tangential[a:b],
            pairs.larger[a:b],
            pairs.moved[a:b],
            pairs.base[a:b],
            pairs.most[a:b],
            pairs.a[a:b],
            pairs.b[a:b],
            pairs.limit[a:b],
            pairs.curved[a:b],
            pairs.distance[a:b],
            pairs.size[a:b],
        ),
        MeshRoom(
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
            room.cosine[a:b],
            room.sine[a:b],
            room.slope[a:b],
            room.steep[a:b],
            room.foot[a:b],
            room.fixed[a:b],
            room.zero[a:b],
        ),
    )


def tie(
    torque: float, lag: float, setup: MeshSetup, pairs: MeshPairs, room: MeshRoom
) -> tuple[float, int, int]:
    """No ring of output pins ties those of the toothed one: never asked for."""
    return lag, SOLVED, 0


def tied_errors(
    psi: float, torque: float, lag: float, setup: MeshSetup, pairs: MeshPairs, room: MeshRoom
) -> tuple[float, float, float]:
    """The same of its errors."""
    return 0.0, 0.0, 0.0


def wrench(
    i: int, j: int, setup: MeshSetup, pairs: MeshPairs, room: MeshRoom
) -> tuple[float, float, float]:
    """Force of a pair on its disc along the crank, towards the axis, and across it, against its
    turning, and its torque about the disc's centre, at the lag that was solved.
    """
    ca, sa, force, torque = room.cosine[i], room.sine[i], room.force[i], room.lever[i]
    torque *= force
    if not setup.foot:
        k = setup.eccentricity * setup.pins / setup.radius
        less = sa * sa / (1 + ca) if ca > 0 else 1 - ca
        slope = math.sqrt((1 - k) * (1 - k) + 2 * k * less)
        return force * (ca - k) / slope, -force * sa / slope, torque
    one = touch(i, j, room.own_lag[j], setup, pairs, room)
    nx, ny = force * one.x, force * one.y
    if straddles(i, setup, pairs):
        force, _, one = beside(i, j, room.own_lag[j], setup, pairs, room)
        nx, ny, torque = nx + force * one.x, ny + force * one.y, torque + force * one.lever
    turned = setup.direction * room.own_lag[j] + pairs.eta[j]
    c, s = math.cos(turned), math.sin(turned)
    x, y = nx * ca - ny * sa, nx * sa + ny * ca
    return x * c + y * s, x * s - y * c, torque


def wave_torque(
    psi: float, lag: float, setup: MeshSetup, pairs: MeshPairs, room: MeshRoom
) -> float:
    """Torque of the forces in the room on the crank but for what turns the discs, at the lag that
    balances them: the sum of each times the derivative of its approach by the crank angle.
    """
    e, total = setup.eccentricity, 0.0
    k, longest = e * setup.pins / setup.radius, e * (setup.pins - 1)
    for i in range(len(room.force)):
        force = room.force[i]
        if force == 0:
            continue
        j = i // setup.pins
        if setup.foot:
            _, across, torque = wrench(i, j, setup, pairs, room)
            total += pairs.own[j] * across - setup.direction * torque / setup.ratio
            continue
        ca, sa = room.cosine[i], room.sine[i]
        less = sa * sa / (1 + ca) if ca > 0 else 1 - ca
        slope = math.sqrt((1 - k) * (1 - k) + 2 * k * less)
        grown = k * sa / (slope * slope)  # of the slope, over it
        lever = -longest * (ca - sa * grown) / slope
        turned = setup.direction * room.own_lag[j] + pairs.eta[j]
        one = lever * turned - setup.rotation * math.copysign(lever, -sa * lever)
        one -= (pairs.radial[i] - setup.pin_circle) * (k * sa - (1 - k + k * less) * grown) / slope
        one -= pairs.tangential[i] * k * (ca - sa * grown) / slope
        one -= pairs.off[j] * (sa + (1 - less - k) * grown) / slope
        total += force * one
    return total


def input_torque(
    psi: float, torque: float, lag: float, setup: MeshSetup, pairs: MeshPairs, room: MeshRoom
) -> float:
    """Torque that turns the crank without friction, as `solve` left the room."""
    return setup.direction * torque / setup.ratio + wave_torque(psi, lag, setup, pairs, room)


def interference(
    low: float, high: float, setup: MeshSetup, pairs: MeshPairs, room: MeshRoom
) -> float:
    """Smallest possible worst approach, between two lags; `at` must have been called."""
    return freest(low, high, setup, pairs, room)[1]


def clear(psi: float, lag: float, setup: MeshSetup, pairs: MeshPairs, room: MeshRoom) -> float:
    """How far the crank may turn on before any pair can touch at a lag: not known."""
    return 0.0


def sliding(i: int, setup: MeshSetup, room: MeshRoom) -> float:
    """Distance of a pair's contact from the pitch point, at which the disc slides on a pin that
    stands still.
    """
    k, ca = setup.eccentricity * setup.pins / setup.radius, room.cosine[i]
    slope = math.sqrt((1 - k) * (1 - k) + 2 * k * (1 - ca))
    return abs(setup.radius * slope - setup.pin_radius)


def along(most: bool, setup: MeshSetup, pairs: MeshPairs, room: MeshRoom) -> float:
    """Largest, or least, force of a disc along its crank."""
    best = -math.inf if most else math.inf
    for j in range(len(pairs.phase)):
        own = 0.0
        for i in range(j * setup.pins, (j + 1) * setup.pins):
            if room.force[i] > 0:
                own += wrench(i, j, setup, pairs, room)[0]
        best = max(best, own) if most else min(best, own)
    return best


def other(kind: int, psi: float, lag: float, load: Load, pairs: MeshPairs, room: MeshRoom) -> float:
    """What is looked at besides, as `solve` left the room."""
    setup: Any = load.setup
    if kind == INPUT_TORQUE:
        return input_torque(psi, load.torque, lag, setup, pairs, room)
    if kind in (ALONG_MOST, ALONG_LEAST):
        return along(kind == ALONG_MOST, setup, pairs, room)
    most = 0.0
    for i in range(len(room.force)):
        far, force = sliding(i, setup, room), room.force[i]
        pressing = force if kind == RUB else math.sqrt(force * pairs.curved[i])
        most = max(most, far * pressing)
    return most
