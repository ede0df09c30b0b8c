"""Load sharing of pins in holes: one position, a turn, the pieces of a study.

The one unknown is the lag of the output. Exact geometry: with P the pin's centre, H the hole's and
C the difference of their radii, ``|d|^2 - C^2 = q + (cos lag - 1)*u + sin lag*v`` for
``d = P*exp(-i*lag) - H``; q, u and v are linear in the crank's direction. First order in lag and
errors: the approach is ``q + lag*v``. Both go through the same loops.

Rules of this file, which runs as it is and is compiled as well (`core.output.compiled`): floats,
ints, `math`, flat rows, named tuples and functions of this file only, since a change elsewhere
would leave a stale cache; no allocation (callers bring the room); no exceptions (a status is
returned). SI units.
"""

import math
from collections.abc import MutableSequence, Sequence
from typing import Generic, NamedTuple, TypeVar

Row = MutableSequence[float]
R = TypeVar("R")

LINEAR, POWER, HERTZ, CONFORMAL = 0, 1, 2, 3
RIGID, CRANK, MESH, TIED, SHARES = 0, 1, 2, 3, 4
"""What of the satellites gives: nothing, the bearings on their cranks, their mesh with the ring. Or
that a tie ring joins the pins, each of which then gives under the forces on all; or that each
satellite turns for itself until it has its given share of the torque."""

SOLVED, NOT_SOLVED, NO_DRIVE, NOT_STABLE, TOO_WIDE, TOO_FAR = range(6)
FORCE, PRESSURE, LAG, STIFFNESS, PLAY_END, BACKLASH, LOST_MOTION, INPUT_TORQUE = range(8)
"""What is looked at over the turn; of the pressure what `hardest` says."""

EPS = 2.0**-52
TINY = 1e-100
"""Stands for what is positive, but for deviations as large as the mechanism."""

NO_LEVER = 16 * EPS
"""Lever and approach over the radius that are no more than rounding."""

STEPS = 200
HALVINGS = 8
"""How often a step of Newton is halved that leads away from the balance of joined pins."""

AS_GOOD = 1e-11
"""What may be left of their balance where no part of a step makes it less: rounding."""

NEWTON_ALONE = 20
"""Steps of Newton after which the stretch is halved too."""

HERTZ_END = 1.2
"""Where the logarithm of the Hertz law ends, in ``approach/(b*force)``: its stiffness would grow
beyond bounds at 1. It goes on as a straight line; what lies there is refused afterwards."""


BEND = 0.4
"""Curves of contacts that wrap are smooth in the width ``sqrt(x/(1 + BEND*x))`` of the load
``x = Q/(E* dR)``, from none to the largest."""

SAME_FORCE = 1e-14
"""Relative change of a force at which Newton's steps end: what its stiffness is off by."""

FITS, BINDS, NOWHERE = 2, 1, 0
"""Whether a piece has room at all positions of the turn, at some, or at none."""

FIT_POSITIONS = 720
"""Positions of the turn at which that is looked at. Its least room is a smooth minimum, which they
miss by no more than the eccentricity times (pi/720)^2/2, 1e-5 of it."""

RADIAN = 1.0
"""Lag beyond which first order says nothing; by exact geometry pins would be in the next holes."""

CLOSE = 1e-8
"""Last step of Newton, over the lag, that studies take along the tangents."""

JUST = 1e-9
"""Part of the eccentricity by which parts that just fit may press: their sizes are rounded."""

PLACE = 1e-10
"""Width to which a summit is narrowed, rad."""

GOLDEN = (math.sqrt(5) - 1) / 2


class Curve(NamedTuple):
    """What a contact that wraps gives, for all pairs of a design: over the load ``x = Q/(E* dR)``
    the approach ``Delta/dR = x*(P - 2/pi*ln(width))``, P a polynomial of ``2*width/widest - 1``.
    """

    modulus: float  # b*E*, N/m
    widest: float  # width up to which it is known; beyond it goes on as a straight line
    powers: tuple[float, ...]  # of the polynomial, from the highest; as many for any law


class Wrap(NamedTuple):
    """The largest pressure of contacts that wrap, of all pairs: over Hertz's it is
    ``P*sqrt(1 + BEND*x)``, P a polynomial as that of `Curve`.
    """

    modulus: float  # b*E*, N/m; infinite where it is not known: then Hertz's pressure stands
    since: float  # load from which it governs in the place of Hertz's
    widest: float  # width up to which it is known; beyond it P stays
    powers: tuple[float, ...]


class Setup(NamedTuple):
    """What a design is, without its errors."""

    pins: int
    satellites: int
    ratio: float
    exact: bool  # geometry; else first order
    radius: float  # of the pin circle
    pin_radius: float
    eccentricity: float
    clearance: float  # radial; not as a difference of radii, which loses two digits
    direction: float  # of the torque: 1, or -1 in reverse
    law: int  # LINEAR, POWER, HERTZ, CONFORMAL
    # Of the force over the approach; about 10/9 for HERTZ and CONFORMAL, for start and steps.
    exponent: float
    curve: Curve  # CONFORMAL
    wrap: Wrap
    support: int  # RIGID, CRANK, MESH, TIED, SHARES
    gives: float  # compliance of that, m/N or rad/(N*m)
    loose: float  # what the clearance of bearings, on cranks or pins, adds to every gap


class Law(NamedTuple):
    """Law of contact of all pairs."""

    a: float  # LINEAR 1/k; POWER k; CONFORMAL b*E*
    first: float  # HERTZ: (1 - nu^2)/E of pin and hole
    second: float
    quarter: float  # pi*b*E*/4
    around: float  # pi*b
    depth: float
    ratio: float  # nu/(1 - nu) of the hole
    end: float  # CONFORMAL: load Q/(E* dR) at which it ends


class Errors(NamedTuple, Generic[R]):
    """Deviations of one piece, rows of [N], [K*N] or [K]; of many, a table of each."""

    pin_radial: R
    pin_tangential: R
    pin_radius: R
    hole_radial: R
    hole_tangential: R
    hole_radius: R
    eccentricity: R
    crank_phase: R
    disc_phase: R


class Pairs(NamedTuple):
    """What of the pairs does not change over the turn, [K*N]; [K] where said, by which it is known
    how many satellites there are.
    """

    arm: Row  # [K] -2*eccentricity of the satellite's own crank; 1 in first order
    phase: Row  # [K] crank angles with their errors
    share: Row  # [K] of the torque: SHARES
    x: Row  # factors of the crank's direction in u and v
    y: Row
    ex: Row  # and in q
    ey: Row
    k0: Row  # constant parts of q, u, v
    k1: Row
    k2: Row
    distance: Row  # of the centres in contact; in first order that of the radii
    size: Row  # of the terms that make q: times the rounding, its error
    a: Row  # law: LINEAR 1/k + C; POWER k; HERTZ A + C; CONFORMAL b*E*dR
    b: Row  # POWER C; HERTZ B; CONFORMAL b*E*C
    limit: Row  # force at which the law ends
    curved: Row  # difference of the curvatures
    # Of pins that a tie ring joins: compliances between all pairs, [K*N, K*N], but for what is in
    # their laws and for what the ring turns; by which each turns it, over its lever.
    give: Row
    ends: Row


class Room(NamedTuple):
    """Results of one position, [K*N]."""

    q: Row
    u: Row
    v: Row
    unsure: Row  # size of the terms that make q at the onset
    force: Row
    lever: Row
    stiffness: Row  # of the contact
    own_lag: Row  # [K] of the satellites, where they give; their unknown while it is sought
    own_moves: Row  # [K] their unknown by the lag of the output, see `Disc`, and its error
    own_error: Row  # [K]
    approach: Row  # of pins that a tie ring joins: while it is sought, its last one, and its step
    before: Row
    moved: Row
    system: Row  # [K*N, 2*K*N] room for equations of these


class Poses(NamedTuple):
    """Positions under load, and their play; lags count in the torque's direction."""

    forces: Row  # of all pairs, position by position
    lag: Row
    stiffness: Row
    force: Row  # largest
    pressure: Row  # the largest, as `hardest`
    loaded: Row  # number of pairs with a force
    low: Row  # play
    high: Row
    lag_error: Row
    play_error: Row
    force_error: Row
    input_torque: Row


class Pieces(NamedTuple):
    """Quantities of pieces; not a number where one cannot work."""

    peak_force: Row
    max_pressure: Row  # as `hardest`
    transmission_error: Row
    backlash_max: Row
    lost_motion: Row
    stiffness_min: Row
    fits: Row  # FITS, BINDS or NOWHERE


def prepare(
    setup: Setup, law: Law, errors: Errors[Row], phase: Row, compliance: Row, pairs: Pairs
) -> int:
    """Constants of the pairs from the deviations of one piece; the pair whose hole, pin or crank
    has no size left, or -1. Crank angles and the pin's compliance at each satellite are [K]; of
    pins that a tie ring joins see `core.output.contact_law.tied_compliance`.
    """
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
            beta = 2 * math.pi * n / setup.pins
            rx, ry = -math.sin(beta), math.cos(beta)  # radial; tangential is (-ry, rx)
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
            else:
                pairs.curved[i] = difference / pin / (pin + difference)
                pairs.a[i], pairs.b[i], pairs.limit[i] = pair_law(
                    setup.law, law, pin, difference, compliance[j]
                )
            i += 1
    if setup.support == TIED:
        join(setup, compliance, pairs)
    return none


def join(setup: Setup, compliance: Row, pairs: Pairs) -> None:
    """Compliances between pins that a tie ring joins, from those of one pin."""
    pins, satellites = setup.pins, setup.satellites
    count, own, by_ring = pins * satellites, satellites, satellites + satellites * satellites
    for j in range(satellites):
        for k in range(satellites):
            along = math.cos(pairs.phase[j] - pairs.phase[k])
            free = compliance[own + j * satellites + k] * along
            held = compliance[by_ring + j] * compliance[by_ring + k] * along
            for n in range(pins):
                for m in range(pins):
                    i = (j * pins + n) * count + k * pins + m
                    pairs.give[i] = held
                    if n == m:
                        pairs.give[i] += free - pins * held
        for n in range(pins):
            i = j * pins + n
            pairs.ends[i] = compliance[by_ring + j] / setup.radius
            pairs.give[i * count + i] -= compliance[j]


def pair_law(
    kind: int, law: Law, pin: float, difference: float, compliance: float
) -> tuple[float, float, float]:
    """Constants a and b of a pair's law with a compliance in series, and the force at which it
    ends: the contact would be as wide as the pin. See `core.output.contact_law.law_constants`.
    """
    if kind == LINEAR:
        return law.a + compliance, 0.0, math.inf
    if kind == POWER:
        return law.a, compliance, math.inf
    if kind == CONFORMAL:
        return law.a * difference, law.a * compliance, law.a * difference * law.end
    return line_law(law, pin, pin * (pin + difference) / difference, compliance)


def line_law(law: Law, pin: float, reduced: float, compliance: float) -> tuple[float, float, float]:
    """The same of a Hertz line contact with a reduced radius."""
    q = law.quarter / reduced
    b = (law.first + law.second) / law.around
    a = law.first * (math.log(16 * pin * pin * q) - 1)
    a += law.second * (math.log(4 * law.depth * law.depth * q) - law.ratio)
    a /= law.around
    limit = min(q * pin * pin, math.exp(min(a / b - HERTZ_END, 700.0)))
    return a + compliance, b, limit


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


def law(
    kind: int,
    approach: float,
    a: float,
    b: float,
    n: float,
    force: float,
    stiffness: float,
    curve: Curve,
) -> tuple[float, float]:
    """Force of an approach > 0, and its derivative; given those at another one nearby, or 0."""
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
    if kind == CONFORMAL:
        return wrapped(approach, a, b, curve, force)
    if b == 0:
        force = a * approach**n
        return force, n * force / approach
    if n >= 1:  # a part of the approach is the bending b*F
        near = min(n * (force / stiffness - b * force), approach) if force > 0 else 0.0
        x, bent = shared(approach, 1.0, a * b, 1.0, n, near)
        force, contact = bent / b, x
    else:
        force, contact = shared(approach, b, 1.0, 1 / a, 1 / n, force)
    stiffness = n * force / contact
    return force, stiffness / (1 + b * stiffness)


def shared(
    total: float, first: float, second: float, scale: float, power: float, near: float
) -> tuple[float, float]:
    """The positive root x of ``first*x + second*(scale*x)^power = total`` for a power >= 1, and the
    second term there; `near` is a number near the root, or 0.
    """
    x, term = near, 0.0
    for step in range(60):
        if not x > TINY:
            one, other = total / first, (total / second) ** (1 / power) / scale
            x = one * other / (one + other)  # below the root: Halley's steps all lead upwards
        term = second * (scale * x) ** power
        off, slope = first * x + term - total, first + power * term / x
        curve = power * (power - 1) * term / (x * x)
        part = off * slope / (slope * slope - off * curve / 2) / x
        if step == 0 and near > 0 and abs(part) > 0.3:
            x = 0.0
            continue
        x -= part * x
        if abs(part) <= 3e-6:  # its cube is what is left
            term *= 1 - power * part * (1 - (power - 1) * part / 2)
            break
    return x, term


def given_over(x: float, curve: Curve) -> tuple[float, float]:
    """``Delta/dR`` over the load x, and its derivative by it."""
    width = math.sqrt(x / (1 + BEND * x))
    beyond = width >= curve.widest
    if beyond:
        width = curve.widest
    place = 2 * width / curve.widest - 1
    value = slope = 0.0
    for power in curve.powers:
        slope = slope * place + value
        value = value * place + power
    value -= 2 / math.pi * math.log(width)
    if beyond:
        return value, value
    turn = 2 * width / curve.widest * slope - 2 / math.pi  # by the logarithm of the width
    return value, value + turn * (1 - BEND * width * width) / 2


def wrapped(approach: float, a: float, b: float, curve: Curve, force: float) -> tuple[float, float]:
    """Force of a contact that wraps, and its derivative, by Newton's method in logarithms, where it
    is nearly straight: with the force at another approach nearby, or 0.
    """
    aim = approach * curve.modulus / a
    x, tangent = force / a if force > 0 else aim, 1.0
    for _ in range(16):
        secant, tangent = given_over(x, curve)
        secant, tangent = secant + b, tangent + b
        part = math.log(aim / (x * secant)) * secant / tangent
        x *= math.exp(part)
        if abs(part) <= SAME_FORCE:
            break
    return a * x, curve.modulus / tangent


def alone(kind: int, force: float, a: float, b: float, n: float, curve: Curve) -> float:
    """Approach under a force."""
    if kind == LINEAR:
        return a * force
    if kind == HERTZ:
        return force * b * max(a / b - math.log(force), HERTZ_END)
    if kind == CONFORMAL:
        return force * (given_over(force / a, curve)[0] + b) / curve.modulus
    return float((force / a) ** (1 / n) + b * force)


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
    if setup.support == SHARES:
        return shares(psi, torque, setup, pairs, room)
    return together(psi, torque, setup, pairs, room)


class Freed(NamedTuple):
    """A position without load, and where its lag under load is looked for."""

    low: float  # play
    high: float
    error: float  # of its ends
    pressed: bool
    zero: float  # from where the lag is counted
    lag: float  # to begin with; infinite where no pair can drive


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


class Carried(NamedTuple):
    """What the pairs carry at a lag, as `carry` left the room."""

    lag: float
    torque: float
    slope: float
    gross: float
    change: float  # next step of Newton
    status: int
    steps: int


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


def within(x: float, change: float, low: float, high: float, step: int) -> float:
    """The next place of Newton inside a bracket, at one of its ends where nothing is left of it.

    Below the exponent 1 each touch is a step of the torque, over which Newton goes back and forth:
    then every second time the stretch is halved.
    """
    following = x + change
    if low < following < high and not (step > NEWTON_ALONE and step % 2 and high - low < math.inf):
        return following
    if high == math.inf:
        return x + max(abs(x), 1e-9)
    if low == -math.inf:
        return x - max(abs(x), 1e-9)
    return (low + high) / 2


class Disc(NamedTuple):
    """A satellite that gives, at a lag of the output.

    All contact normals of one disc are parallel to its eccentricity: what its crank's bearing gives
    is taken from every approach alike. What its mesh with the ring gives turns it back against the
    output. Its unknown is how far the bearing has gone back, less than 0, or its own lag; its own
    equation, which grows with that, says that the forces do this.
    """

    torque: float
    gross: float
    slope: float  # of the torque by the lag of the output, with the own equation solved
    value: float  # what the own equation is off, and the size of its terms
    size: float
    change: float  # step of Newton of the unknown, and its derivative by the lag of the output
    moves: float
    weight: float  # torque by what the own equation is off
    share: float  # 1 over the slope of the own equation


def disc(j: int, lag: float, own: float, setup: Setup, pairs: Pairs, room: Room) -> Disc:
    """Satellite j at a lag of the output and a value of its unknown; its forces are in the room."""
    crank, gives, kind, exponent = setup.support == CRANK, setup.gives, setup.law, setup.exponent
    a, b, curve = pairs.a, pairs.b, setup.curve
    q, v, force, levers, contact = room.q, room.v, room.force, room.lever, room.stiffness
    turned, back = (lag, own) if crank else (own, 0.0)
    torque = gross = held = size = stiff = spread = middle = 0.0
    for i in range(j * setup.pins, (j + 1) * setup.pins):
        lever = v[i]
        approach = q[i] + turned * lever + back
        if approach <= TINY:
            force[i] = levers[i] = contact[i] = 0.0
            continue
        f, stiffness = law(kind, approach, a[i], b[i], exponent, force[i], contact[i], curve)
        force[i], levers[i], contact[i] = f, lever, stiffness
        torque += f * lever
        gross += f * abs(lever)
        terms = f + stiffness * (abs(turned * lever) + abs(back))
        if crank:  # the mean lever, and squares about it
            held += f
            size += terms
            stiff += stiffness
            off = lever - middle
            middle += stiffness / stiff * off
            spread += stiffness * off * (lever - middle)
        else:
            size += terms * abs(lever)
            stiff += stiffness * lever * lever
    if not crank:
        held, middle = torque, 1.0
    rest = 0.0 if crank else lag
    value, share = own - rest + gives * held, 1 / (1 + gives * stiff)
    weight = middle * stiff * share
    return Disc(
        torque,
        gross,
        spread + middle * weight,
        value,
        abs(own) + abs(rest) + gives * size,
        -value * share,
        -gives * weight if crank else share,
        weight,
        share,
    )


def near(one: Disc, own: float) -> bool:
    """Whether the own equation of a satellite is solved, up to rounding."""
    return abs(one.value) <= EPS * one.size or abs(one.change) <= EPS * abs(own)


def settle(j: int, lag: float, setup: Setup, pairs: Pairs, room: Room) -> None:
    """Solve the own equation of satellite j at a lag of the output."""
    own, low, high = room.own_lag[j], -math.inf, math.inf
    for step in range(1, STEPS):
        one = disc(j, lag, own, setup, pairs, room)
        if near(one, own):
            break
        if one.value > 0:
            high = own
        else:
            low = own
        following = within(own, one.change, low, high, step)
        if following in (low, high):
            break
        own = following
    room.own_lag[j] = own


def felt(i: int, j: int, setup: Setup, room: Room) -> tuple[float, float]:
    """Approach of a pair by the lag of the output, and by the unknown of its satellite."""
    if setup.support == CRANK:
        return room.v[i] + room.own_moves[j], 1.0
    return room.v[i] * room.own_moves[j], room.v[i]


def give(
    torque: float, free: Freed, setup: Setup, pairs: Pairs, room: Room
) -> tuple[float, int, int]:
    """Lag at which satellites that give carry a torque; status and steps.

    Newton on all equations at once, from outside. Where it takes long, the equations of the discs
    are solved at every lag, and only then the bracket of the lag is known.
    """
    lag, pressed = free.lag, free.pressed
    low, high = -math.inf if pressed else 0.0, math.inf
    crank, far = setup.support == CRANK, setup.eccentricity / setup.radius
    power = 1.0 if pressed else 1 / setup.exponent
    outer, solved = 0, False
    for j in range(setup.satellites):
        room.own_lag[j] = 0.0 if crank else lag
    for step in range(1, 2 * STEPS):
        carried = slope = size = 0.0
        settled = True
        for j in range(setup.satellites):
            one = disc(j, lag, room.own_lag[j], setup, pairs, room)
            settled = settled and (solved or near(one, room.own_lag[j]))
            room.own_lag[j] += one.change
            room.own_moves[j] = one.moves
            carried += one.torque - one.weight * one.value
            slope += one.slope
            size += one.gross + abs(one.weight) * one.size
        value, ratio, change = carried - torque, carried / torque, math.inf
        if slope > 0 and power == 1:
            change = -value / slope
        elif slope > 0 and ratio > 0:
            change = torque * (ratio ** (1 - power) - ratio) / (power * slope)
        if settled and (abs(value) <= EPS * size or abs(change) <= EPS * abs(lag)):
            return lag, SOLVED, step
        if pressed:
            change = min(max(change, -far), far)
        following = lag + change
        if settled:
            if value > 0:
                high = lag
            else:
                low = lag
            following = within(lag, change, low, high, outer)
            if following in (low, high):
                return lag, SOLVED, step
        elif outer > NEWTON_ALONE or not low < following < high:
            for j in range(setup.satellites):
                settle(j, lag, setup, pairs, room)
            solved = True
            continue
        for j in range(setup.satellites):
            room.own_lag[j] += room.own_moves[j] * (following - lag)
        lag, outer, solved = following, outer + 1, False
    return lag, NOT_SOLVED, 2 * STEPS


def given_errors(
    psi: float, torque: float, lag: float, setup: Setup, pairs: Pairs, room: Room
) -> tuple[float, float, float]:
    """Slope of the torque as `give` left the room, and bounds of the errors of lag and forces: by
    the balance, by rounding of terms, levers and approaches as in `solve`, and by what the discs'
    own equations are off.
    """
    crank, rounding = setup.support == CRANK, EPS * (4 + 2 * abs(psi))
    value, slope, off = -torque, 0.0, 4 * EPS * torque
    for j in range(setup.satellites):
        own_lag = room.own_lag[j]
        one = disc(j, lag, own_lag, setup, pairs, room)
        room.own_moves[j] = one.moves
        value, slope = value + one.torque, slope + one.slope
        own, moved = abs(one.value) + 4 * EPS * one.size, 0.0
        turned, back = (lag, own_lag) if crank else (own_lag, 0.0)
        for i in range(j * setup.pins, (j + 1) * setup.pins):
            by_lag, by_own = felt(i, j, setup, room)
            unsure = rounding * (room.unsure[i] + abs(turned) * setup.radius + abs(back))
            rough = rounding * room.force[i] * setup.radius
            room.unsure[i] = unsure
            off += rough + room.stiffness[i] * abs(by_lag) * unsure
            own += 0.0 if crank else setup.gives * rough
            moved += setup.gives * room.stiffness[i] * abs(by_own) * unsure
        off += 4 * EPS * one.gross + abs(one.weight) * own
        room.own_error[j] = one.share * (own + moved)
    lag_error, force_error = (off + abs(value)) / slope if slope > 0 else math.inf, 0.0
    for j in range(setup.satellites):
        for i in range(j * setup.pins, (j + 1) * setup.pins):
            by_lag, by_own = felt(i, j, setup, room)
            unsure = abs(by_lag) * lag_error + room.unsure[i] + abs(by_own) * room.own_error[j]
            force_error = max(force_error, room.stiffness[i] * unsure + 8 * EPS * room.force[i])
    return slope, lag_error, force_error


def carried_forces(setup: Setup, pairs: Pairs, room: Room) -> int:
    """Forces of the approaches in the room; how many pairs carry."""
    count = 0
    for i, approach in enumerate(room.approach):
        room.force[i] = room.lever[i] = room.stiffness[i] = 0.0
        if approach > TINY:
            room.force[i], room.stiffness[i] = law(
                setup.law,
                approach,
                pairs.a[i],
                pairs.b[i],
                setup.exponent,
                0.0,
                0.0,
                setup.curve,
            )
            room.lever[i] = room.v[i]
            count += 1
    return count


def lacking(i: int, lag: float, turned: float, pairs: Pairs, room: Room) -> float:
    """By how much an approach is not what lag and forces leave of it; the ring is turned."""
    count = len(room.force)
    off = room.q[i] + lag * room.v[i] - room.approach[i] - pairs.ends[i] * room.v[i] * turned
    for k in range(count):
        if room.force[k] > 0:
            off -= pairs.give[i * count + k] * room.force[k]
    return off


def ring_turned(pairs: Pairs, room: Room) -> float:
    """What the forces turn of the ring."""
    turned = 0.0
    for i, force in enumerate(room.force):
        turned += pairs.ends[i] * room.v[i] * force
    return turned


def unbalanced(torque: float, lag: float, pairs: Pairs, room: Room) -> float:
    """How far approaches and torque are off, as parts of them."""
    turned, short, off, size = ring_turned(pairs, room), torque, 0.0, TINY
    for i, force in enumerate(room.force):
        short -= force * room.v[i]
        size = max(size, abs(room.approach[i]))
        off = max(off, abs(lacking(i, lag, turned, pairs, room)))
    return off / size + abs(short) / torque


def fill(row: int, i: int, count: int, width: int, pairs: Pairs, room: Room) -> None:
    """One of the equations of the pairs that carry: approaches with what they take of each
    other.
    """
    pair_turns, column = pairs.ends[i] * room.v[i], 0
    for k in range(count):
        if room.force[k] > 0:
            taken = pairs.give[i * count + k] + pair_turns * pairs.ends[k] * room.v[k]
            room.system[row * width + column] = taken * room.stiffness[k] + (1.0 if k == i else 0.0)
            column += 1


def eliminate(rows: int, width: int, system: Row) -> None:
    """Solve equations by Gauss and Jordan, in place: the columns beyond the rows are answers."""
    for column in range(rows):
        pivot = column
        for row in range(column + 1, rows):
            if abs(system[row * width + column]) > abs(system[pivot * width + column]):
                pivot = row
        if pivot != column:
            for k in range(column, width):
                one, other = column * width + k, pivot * width + k
                system[one], system[other] = system[other], system[one]
        whole = system[column * width + column]
        for k in range(column, width):
            system[column * width + k] /= whole
        for row in range(rows):
            part = system[row * width + column]
            if row != column and part != 0:
                for k in range(column, width):
                    system[row * width + k] -= part * system[column * width + k]


def tied_step(
    torque: float, lag: float, carrying: int, setup: Setup, pairs: Pairs, room: Room
) -> float:
    """Newton's step of the lag; that of the approaches is left in the room."""
    count, width = len(room.force), carrying + 2
    turned, row = ring_turned(pairs, room), 0
    for i in range(count):
        room.moved[i] = lacking(i, lag, turned, pairs, room)
        if room.force[i] > 0:
            fill(row, i, count, width, pairs, room)
            room.system[row * width + carrying] = room.moved[i]
            room.system[row * width + carrying + 1] = room.v[i]
            row += 1
    eliminate(carrying, width, room.system)
    short, slope, row = torque, 0.0, 0
    for i in range(count):
        if room.force[i] > 0:
            pull = room.stiffness[i] * room.v[i]
            short -= room.force[i] * room.v[i] + pull * room.system[row * width + carrying]
            slope += pull * room.system[row * width + carrying + 1]
            row += 1
    step = short / slope if slope != 0 else 0.0
    for i in range(count):
        pair_turns = pairs.ends[i] * room.v[i]
        room.moved[i] += step * room.v[i]
        row = 0
        for k in range(count):
            if room.force[k] > 0:
                taken = pairs.give[i * count + k] + pair_turns * pairs.ends[k] * room.v[k]
                change = room.system[row * width + carrying]
                change += step * room.system[row * width + carrying + 1]
                room.moved[i] -= taken * room.stiffness[k] * change
                row += 1
    return step


def tie(
    torque: float, lag: float, setup: Setup, pairs: Pairs, room: Room
) -> tuple[float, int, int]:
    """Balance of pins that a tie ring joins, from a lag near it; a status, and steps.

    Approach and force of each pair depend on all: ``d = q + v*lag - S*F(d)``, with one matrix S,
    which is symmetric and positive, so that there is one solution. Newton in all approaches and the
    lag finds which pairs carry as it goes; a step that leads away is halved.
    """
    count = len(room.force)
    for i in range(count):
        room.approach[i] = room.q[i] + lag * room.v[i]
    carrying = carried_forces(setup, pairs, room)
    error = unbalanced(torque, lag, pairs, room)
    for step in range(1, STEPS):
        turned = tied_step(torque, lag, carrying, setup, pairs, room)
        size = most = TINY
        for i in range(count):
            size, most = max(size, abs(room.approach[i])), max(most, abs(room.moved[i]))
            room.before[i] = room.approach[i]
        settled, part, after = most <= 16 * EPS * size, 1.0, error
        for _ in range(HALVINGS):
            for i in range(count):
                room.approach[i] = room.before[i] + part * room.moved[i]
            carrying = carried_forces(setup, pairs, room)
            after = unbalanced(torque, lag + part * turned, pairs, room)
            if carrying > 0 and (settled or after < error or after <= 4 * EPS):
                break
            part /= 2
        if after >= error and (settled or error <= AS_GOOD):
            for i in range(count):
                room.approach[i] = room.before[i]
            carried_forces(setup, pairs, room)
            return lag, SOLVED, step
        lag, error = lag + part * turned, after
        if settled or error <= 4 * EPS:
            return lag, SOLVED, step
        if carrying == 0:
            break
    return lag, NOT_SOLVED, STEPS


def tied_errors(
    psi: float, torque: float, lag: float, setup: Setup, pairs: Pairs, room: Room
) -> tuple[float, float, float]:
    """Slope of the torque as `tie` left the room, and bounds of the errors of lag and forces."""
    count, rounding = len(room.force), EPS * (4 + 2 * abs(psi))
    turned, carrying, short = ring_turned(pairs, room), 0, torque
    for i in range(count):
        off = rounding * (room.unsure[i] + abs(lag) * setup.radius)
        off += abs(lacking(i, lag, turned, pairs, room)) + 4 * EPS * abs(room.q[i])
        for k in range(count):
            taken = abs(pairs.give[i * count + k])
            taken += abs(pairs.ends[i] * room.v[i] * pairs.ends[k] * room.v[k])
            off += 4 * EPS * taken * room.force[k]
        room.unsure[i] = off
        short -= room.force[i] * room.v[i]
        carrying += 1 if room.force[i] > 0 else 0
    width, row = 2 * carrying, 0
    for i in range(count):
        if room.force[i] > 0:
            fill(row, i, count, width, pairs, room)
            for column in range(carrying, width):
                room.system[row * width + column] = 1.0 if column == row + carrying else 0.0
            row += 1
    eliminate(carrying, width, room.system)
    # forces by what the approaches would be without them
    slope, by_off, row = 0.0, abs(short), 0
    for i in range(count):
        if room.force[i] == 0:
            continue
        by_off += rounding * room.force[i] * setup.radius
        column = carrying
        for k in range(count):
            if room.force[k] > 0:
                answer = room.stiffness[i] * room.system[row * width + column]
                slope += room.v[i] * answer * room.v[k]
                by_off += abs(room.v[i] * answer) * room.unsure[k]
                column += 1
        row += 1
    lag_error, force_error, row = by_off / slope if slope > 0 else math.inf, 0.0, 0
    for i in range(count):
        if room.force[i] == 0:
            continue
        unsure, column = 8 * EPS * room.force[i], carrying
        for k in range(count):
            if room.force[k] > 0:
                answer = abs(room.stiffness[i] * room.system[row * width + column])
                unsure += answer * (room.unsure[k] + abs(room.v[k]) * lag_error)
                column += 1
        force_error = max(force_error, unsure)
        row += 1
    return slope, lag_error, force_error


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


def ring_torque(psi: float, setup: Setup, pairs: Pairs, room: Room) -> float:
    """What the wave takes back as it makes a tie ring turn more easily, or less."""
    now = beside = 0.0
    for j, phase in enumerate(pairs.phase):
        angle = psi + phase
        wx, wy = math.sin(angle), math.cos(angle)
        for i in range(j * setup.pins, (j + 1) * setup.pins):
            felt = room.force[i] * pairs.ends[i]
            now += felt * (wx * pairs.x[i] + wy * pairs.y[i])
            beside += felt * (wy * pairs.x[i] - wx * pairs.y[i])
    return now * beside


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


def excess(x: float, wrap: Wrap) -> float:
    """Square of the pressure under the load x over Hertz's."""
    place, value = 2 * min(math.sqrt(x / (1 + BEND * x)) / wrap.widest, 1.0) - 1, 0.0
    for power in wrap.powers:
        value = value * place + power
    return value * value * (1 + BEND * x)


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


class Load(NamedTuple):
    """Load of a turn, and the share of it under which the lost motion is taken."""

    torque: float
    share: float
    setup: Setup  # with the torque's direction
    back: Setup  # with the other one


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
