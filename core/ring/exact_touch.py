"""Where the pins of a ring touch a cycloid disc in exact geometry, and how far it may turn between
them.

The words of `core.ring.approach` hold, whose loops use these and say what a pair is in first order.
"""

import math
from typing import NamedTuple

from core.output.loop_rows import EPS, STEPS, Curve, Row, Wrap

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


def straddles(i: int, setup: MeshSetup, pairs: MeshPairs) -> bool:
    """Whether a pin is so much wider than the tool that it may press both flanks of a valley: by
    more than the path is round there. One that does so presses without load.
    """
    radius, k = setup.tool_circle, setup.eccentricity * setup.pins / setup.tool_circle
    wider = pairs.larger[i] - setup.equidistant
    return wider * (setup.pins * k - 1) > radius * (1 - k) * (1 - k)


def touch(
    i: int,
    j: int,
    lag: float,
    setup: MeshSetup,
    pairs: MeshPairs,
    room: MeshRoom,
    across: bool = False,
) -> Touch:
    """Pair i of satellite j at a lag, which is counted as the torque turns; its foot is kept. Or
    its foot across the valley, from the mirror image of the nearest one: without one it is as good
    as infinitely far.

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
    first, foot = -final, room.foot[i]
    if across or off > setup.tool or off * (pins * k - 1) > radius * (1 - k) * (1 - k):
        # The nearest point of the path may not be the one at hand.
        angle, half = math.atan2(sa, ca) / (pins - 1), math.pi / (pins - 1)
        place = math.floor((angle - math.atan2(py, px)) / half)
        if across:
            valley = 2 * half * math.floor((place + 1) / 2) - angle
            foot = 2 * valley - foot
            place += 1 if place % 2 else -1
        first = half * place - angle
        final = first + half
    foot, last = min(max(foot, first), final), False
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
    length = math.sqrt(size)
    nx, ny = gx / length, gy / length
    if not across:
        room.foot[i] = foot
    elif under <= 0 or abs(gy * dx - gx * dy) > close * under:  # driven to the middle
        return Touch(-math.inf, 0.0, 0.0, nx, ny)
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


def quarter(setup: MeshSetup) -> float:
    """A quarter of the pitch of the lobes: further no disc turns before its pins hold it."""
    return math.pi / 2 / (setup.pins - 1)


def rounded(i: int, lag: float, setup: MeshSetup, pairs: MeshPairs) -> float:
    """Approach of a pin that may be rounding alone."""
    return ROUNDED * EPS * (pairs.size[i] + abs(lag) * setup.radius)


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
