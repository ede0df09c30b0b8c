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
from typing import Any, NamedTuple

from core.output.contact_kernel import law, line_law, pair_law
from core.output.loop_rows import (
    EPS,
    HERTZ,
    INPUT_TORQUE,
    NOT_STABLE,
    SOLVED,
    STEPS,
    TINY,
    TOO_FAR,
    Curve,
    Law,
    Load,
    Position,
    Row,
    Wrap,
)
from core.output.sharing_kernel import judged as judged_by_lag
from core.output.sharing_kernel import start as start_alone
from core.output.sharing_kernel import touch_error as touch_error_alone

ALONG_MOST, ALONG_LEAST, RUB, RUB_AND_PRESS = range(8, 12)
"""What is looked at over the turn besides: the largest and the least force of a disc along its
crank; the largest product of a pair's distance to the pitch point and its force, N*m, or the root
of force over reduced radius, m*sqrt(N/m)."""

FEET = 30
"""Steps of Newton to a foot at most."""

FAR_STEP = 0.1
"""Longest of them, over the angle of a pin's pitch by its number of pins."""

ROUNDED = 1e3
"""Roundings of the terms of an approach that may be no more than that."""

NO_TURN = 1e-3
"""Lever over the longest one below which a pin, at its dead angle, limits no play."""


class MeshSetup(NamedTuple):
    """What a ring and its discs are, without their errors."""

    pins: int  # of the ring
    satellites: int
    ratio: float
    exact: bool  # of the kernel's own geometry: False
    radius: float  # of the pin circle
    pin_radius: float
    eccentricity: float
    clearance: float
    direction: float
    law: int
    exponent: float
    curve: Curve  # of the kernel's conformal law, which no ring has: as its `wrap`
    wrap: Wrap
    support: int
    gives: float
    loose: float
    foot: bool  # exact geometry, else first order
    tool_circle: float  # R_m
    tool: float  # r_m
    equidistant: float
    pin_circle: float
    rotation: float


class MeshPairs(NamedTuple):
    """What of the pairs does not change over the turn, [K*N], [K] where said; and what the position
    makes of their laws.
    """

    phase: Row  # [K]
    share: Row  # [K] of the torque, where it is given
    own: Row  # [K] eccentricity of the satellite's own crank, and its error
    off: Row  # [K]
    eta: Row  # [K] by how much its holes are ahead of its teeth
    cosine: Row  # of the pin's place
    sine: Row
    radial: Row
    tangential: Row
    larger: Row
    moved: Row  # how far it may be off its place along the path
    base: Row  # law: HERTZ A + C at a reduced radius of 1 m, and the limit there
    most: Row
    a: Row
    b: Row
    limit: Row
    curved: Row
    distance: Row
    size: Row


class MeshRoom(NamedTuple):
    """Results of one position, [K*N], as the kernel's, and the feet."""

    q: Row
    u: Row  # whether approach and lever are exact where the lag is counted from
    v: Row
    unsure: Row
    force: Row
    lever: Row
    stiffness: Row
    own_lag: Row  # [K]
    own_moves: Row  # [K]
    own_error: Row  # [K]
    cosine: Row  # of the angle from the crank to the pin
    sine: Row
    slope: Row  # speed of the path over that of its circle, S
    steep: Row  # 1/S
    foot: Row
    fixed: Row  # what is added to the approach, so that the first pair just touches
    zero: Row  # its first: the lag from which it is counted


class Touch(NamedTuple):
    """A pin at a lag, in exact geometry."""

    approach: float
    lever: float
    bend: float  # its derivative
    x: float  # the normal
    y: float


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


def reach(
    i: int,
    approach: float,
    moved: float,
    whole: float,
    setup: MeshSetup,
    pairs: MeshPairs,
    room: MeshRoom,
) -> bool:
    """Whether a pin so far off in first order may touch, if it has moved so far since its approach
    was exact, and the whole way from its place on the path.

    The path is nowhere more hollow than it may be within twice the way, and a circle of that radius
    lies outside of it; four times what that bends away from its tangent is allowed for. `S^3`
    changes along the path by `3*z*K/R_m` at most.
    """
    radius, z, off = setup.tool_circle, setup.pins - 1, 2 * moved * moved
    left = -approach * radius - off
    if left <= 0:
        return True
    k, s = setup.eccentricity * setup.pins / radius, room.slope[i]
    least, most = (1 - k) * (1 - k), (1 - k * k) * z / 2
    wider = max(pairs.larger[i] - setup.equidistant, 0.0)
    hollow = max(most - (z + 2) / 2 * least, 0.0)
    if left * (radius * least * (1 - k) - wider * hollow) > off * radius * hollow:
        return False  # not even in the middle of a valley
    fall = 6 * z * k * whole / radius
    square, cube = max(s * s - fall * room.steep[i], least), max(s * s * s - fall, least * (1 - k))
    hollow = max(most - (z + 2) / 2 * square, 0.0)
    return left * (radius * cube - wider * hollow) <= off * radius * hollow


def touch(i: int, j: int, lag: float, setup: MeshSetup, pairs: MeshPairs, room: MeshRoom) -> Touch:
    """Pair i of satellite j at a lag, which is counted as the torque turns; its foot is kept.

    The path is its own mirror image in the axes of its valleys and lobes: of a pin between two of
    them no point beyond either is nearest, and there the distance has a minimum.
    """
    e, radius, pins = setup.eccentricity, setup.tool_circle, setup.pins
    ca, sa = room.cosine[i], room.sine[i]
    turned = setup.direction * lag + pairs.eta[j]
    half = math.sin(turned / 2)
    less, turn = 2 * half * half, -math.sin(turned)  # 1 - exp(i*turned)
    px = setup.radius + pairs.radial[i] - pairs.own[j] * ca
    py = pairs.tangential[i] + pairs.own[j] * sa
    mx, my = less * px - turn * py, less * py + turn * px
    bx = pairs.radial[i] - setup.pin_circle - pairs.off[j] * ca - mx
    by = pairs.tangential[i] + pairs.off[j] * sa - my
    px, py = px - mx, py - my
    k, longest, close = e * pins / radius, FAR_STEP / pins, 3e-8 / pins
    off = 4 * math.sqrt(bx * bx + by * by)
    final = off / radius / (1 - k)
    first = -final
    if off > setup.tool or off * (pins * k - 1) > radius * (1 - k) * (1 - k):
        # The nearest point of the path may not be the one at hand.
        angle, half = math.atan2(sa, ca) / (pins - 1), math.pi / (pins - 1)
        first = half * math.floor((angle - math.atan2(py, px)) / half) - angle
        final = first + half
    foot, last = min(max(room.foot[i], first), final), False
    gx = gy = hx = hy = dx = dy = size = under = 0.0
    s1x = s1y = s2x = s2y = 0.0
    for _ in range(FEET):
        if foot != 0:
            sh, ch = math.sin(foot / 2), math.cos(foot / 2)
            s1x, s1y = 2 * sh * sh, 2 * sh * ch
            sh, ch = math.sin(pins * foot / 2), math.cos(pins * foot / 2)
            s2x, s2y = 2 * sh * sh, 2 * sh * ch
        ex, ey = ca * s2x + sa * s2y, ca * s2y - sa * s2x
        dx, dy = bx + radius * s1x - e * ex, by + radius * s1y - e * ey
        gx, gy = 1 - s1x - k * (ca - ex), k * (sa + ey) - s1y
        hx, hy = 1 - s1x - pins * k * (ca - ex), pins * k * (sa + ey) - s1y
        size = gx * gx + gy * gy
        under = radius * size + hx * dx + hy * dy
        if last:
            break
        ahead = gy * dx - gx * dy
        step = ahead / (under if under > 0 else radius * size)
        step = min(max(step, -longest), longest)
        if ahead > 0:
            first = foot
        else:
            final = foot
        if not first <= foot + step <= final:
            step = (first + final) / 2 - foot
        foot += step
        last = abs(step) <= close
    room.foot[i] = foot
    length = math.sqrt(size)
    nx, ny = gx / length, gy / length
    inward = nx * px + ny * py
    bend = inward
    if under > 0:  # the normal turns as its foot moves
        bend *= 1 - (gx * hx + gy * hy) / length * inward / under
    return Touch(
        pairs.larger[i] - setup.equidistant - (nx * dx + ny * dy),
        setup.direction * (nx * py - ny * px),
        bend,
        nx,
        ny,
    )


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


def quarter(setup: MeshSetup) -> float:
    """A quarter of the pitch of the lobes: further no disc turns before its pins hold it."""
    return math.pi / 2 / (setup.pins - 1)


def rounded(i: int, lag: float, setup: MeshSetup, pairs: MeshPairs) -> float:
    """Approach of a pin that may be rounding alone."""
    return ROUNDED * EPS * (pairs.size[i] + abs(lag) * setup.radius)


def touch_error(lag: float, pair: int, psi: float, setup: Any, pairs: Any, room: Any) -> float:
    """By how much rounding moves the lag at which a pair touches, which of a pin that was at its
    dead angle has a lever there alone; as `at` left the room.
    """
    if pair < 0 or abs(room.v[pair]) >= NO_TURN * setup.eccentricity * (setup.pins - 1):
        return touch_error_alone(lag, pair, psi, setup, pairs, room)
    lever = touch(pair, pair // setup.pins, lag, setup, pairs, room).lever
    off = EPS * (4 + 2 * abs(psi)) * (pairs.size[pair] + abs(lag) * setup.radius)
    return off / abs(lever) if lever != 0 else math.inf


def touched(
    side: float, lag: float, onset: int, setup: MeshSetup, pairs: MeshPairs, room: MeshRoom
) -> tuple[float, int, bool]:
    """Lag at which the first pair touches on a side, the pair, and whether no other presses there,
    from where it is in first order: Newton for each pair, and of their roots the nearest.
    """
    z = setup.pins - 1
    dead, left = (
        NO_TURN * setup.eccentricity * z,
        1 - setup.eccentricity * setup.pins / setup.radius,
    )
    pressed = last = False
    for _ in range(13):
        best, first = math.inf, onset
        pressed = pressed and last
        for i in range(len(room.force)):
            v, moved = room.v[i], pairs.moved[i] + abs(lag) * setup.radius
            drives, approach = side * v >= dead, room.q[i] + lag * v
            if drives == last or not reach(i, approach, moved, moved, setup, pairs, room):
                continue
            if last and left * abs(room.sine[i]) > 2 * z * (
                abs(lag) + pairs.size[i] / setup.radius
            ):
                continue  # it turns no dead angle, and only leaves its flank
            one = touch(i, i // setup.pins, lag, setup, pairs, room)
            if drives and side * one.lever > dead / 2:
                root = side * (lag - one.approach / one.lever)
                if root < best:
                    best, first = root, i
            elif one.approach > 0 and one.approach > rounded(i, lag, setup, pairs):
                pressed = True
        if last or best == math.inf:
            break
        change, lag, onset = abs(side * best - lag), side * best, first
        last = change <= 1e-9 * abs(lag)
    return lag, onset, last and not pressed


def passed(low: float, high: float, setup: MeshSetup, pairs: MeshPairs, room: MeshRoom) -> bool:
    """Whether a pin presses the top of a lobe that it passes between two lags."""
    near = (setup.pins - 1) * max(abs(low), abs(high))
    for i in range(len(room.force)):
        own = near + (setup.pins - 1) * abs(pairs.eta[i // setup.pins])
        if room.cosine[i] < 0 and abs(room.sine[i]) <= 2 * own:
            lag = on_top(i, setup, pairs, room)
            if low < lag < high:
                one = touch(i, i // setup.pins, lag, setup, pairs, room)
                if one.approach > rounded(i, lag, setup, pairs):
                    return True
    return False


def on_top(i: int, setup: MeshSetup, pairs: MeshPairs, room: MeshRoom) -> float:
    """Lag at which a pin stands on the top of a lobe, the nearest to none."""
    j, ca, sa, pitch = i // setup.pins, room.cosine[i], room.sine[i], 4 * quarter(setup)
    x = setup.radius + pairs.radial[i] - pairs.own[j] * ca
    y = pairs.tangential[i] + pairs.own[j] * sa
    turned = (math.atan2(sa, ca) - math.pi) / (setup.pins - 1) - math.atan2(y, x)
    lag = setup.direction * (turned - pairs.eta[j])
    return lag - pitch * math.floor(lag / pitch + 0.5)


def worst_at(
    lag: float, setup: MeshSetup, pairs: MeshPairs, room: MeshRoom
) -> tuple[float, float, int]:
    """Largest approach at a lag, how it grows, and whose it is; `at` must have been called."""
    worst, slope, pin = -math.inf, 0.0, 0
    for i in range(len(room.force)):
        approach, lever = room.q[i] + lag * room.v[i], room.v[i]
        moved = pairs.moved[i] + abs(lag) * setup.radius
        if setup.foot and reach(i, approach - worst, moved, moved, setup, pairs, room):
            one = touch(i, i // setup.pins, lag, setup, pairs, room)
            approach, lever = one.approach, one.lever
        if approach > worst:
            worst, slope, pin = approach, lever, i
    return worst, slope, pin


def freest(
    low: float, high: float, setup: MeshSetup, pairs: MeshPairs, room: MeshRoom
) -> tuple[float, float]:
    """The lag between two at which the worst approach is least, and that; `at` must have been
    called. Between lags at which a pin on the top of a lobe is the worst it falls and then rises:
    the sign of its slope is bisected.
    """
    found, least, first = low, math.inf, low
    while first < high:
        last = high
        for i in range(len(room.force) if setup.foot else 0):
            lag = on_top(i, setup, pairs, room)
            if first < lag < last and room.cosine[i] < 0:
                one = touch(i, i // setup.pins, lag, setup, pairs, room)
                if one.approach > 0 and worst_at(lag, setup, pairs, room)[2] == i:
                    last = lag
        below, above = first, last
        for _ in range(STEPS):
            lag = (below + above) / 2
            worst, slope, _ = worst_at(lag, setup, pairs, room)
            if worst < least:
                found, least = lag, worst
            if lag in (below, above):
                break
            if slope > 0:
                above = lag
            else:
                below = lag
        first = last
    return found, least


def first_touch(
    lag: float, far: float, setup: MeshSetup, pairs: MeshPairs, room: MeshRoom
) -> tuple[float, int]:
    """Lag at which the first pair touches between one at which none does and a far one, and the
    pair, bisected.
    """
    for i in range(len(room.force)):
        there = on_top(i, setup, pairs, room)
        if min(lag, far) < there < max(lag, far) and room.cosine[i] < 0:
            one = touch(i, i // setup.pins, there, setup, pairs, room)
            if one.approach > rounded(i, there, setup, pairs):
                far = there
    pin = -1
    for _ in range(STEPS):
        between = (lag + far) / 2
        worst, _, first = worst_at(between, setup, pairs, room)
        if between in (lag, far):
            break
        if worst > 0:
            far, pin = between, first
        else:
            lag = between
    return lag, pin


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
    return torque, slope, gross


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


def on_crank(
    i: int, j: int, setup: MeshSetup, pairs: MeshPairs, room: MeshRoom
) -> tuple[float, float]:
    """Parts of the normal of a pair along the crank, towards the axis, and across it, against its
    turning, at the lag that was solved.
    """
    ca, sa = room.cosine[i], room.sine[i]
    if not setup.foot:
        k = setup.eccentricity * setup.pins / setup.radius
        less = sa * sa / (1 + ca) if ca > 0 else 1 - ca
        slope = math.sqrt((1 - k) * (1 - k) + 2 * k * less)
        return (ca - k) / slope, -sa / slope
    one = touch(i, j, room.own_lag[j], setup, pairs, room)
    turned = setup.direction * room.own_lag[j] + pairs.eta[j]
    c, s = math.cos(turned), math.sin(turned)
    x, y = one.x * ca - one.y * sa, one.x * sa + one.y * ca
    return x * c + y * s, x * s - y * c


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
            _, across = on_crank(i, j, setup, pairs, room)
            lever = setup.direction * room.lever[i]
            total += force * (pairs.own[j] * across - lever / setup.ratio)
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
                own += room.force[i] * on_crank(i, j, setup, pairs, room)[0]
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
