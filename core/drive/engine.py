"""Equilibrium of a planar drive: bodies joined by contacts with gaps and springs, under a torque.

Unknowns are displacements ``q`` of bodies (rotation of the output; rotation of each disc and its
shifts along and across its crank; three of a tie ring) and ``b`` of pins that bend (two at each
plane). The energy ``sum U_i(approach_i) + (q, b).K.(q, b)/2 - T*sum(share*q)`` is stationary. A lag
is a rotation against the direction in which the output turns. Complex numbers describe a contact
from the ideal place of its pin: the real axis points outward, the imaginary axis as the output
turns, the crank along ``w = exp(-i*a)``. With ``m(t) = exp(-i*t) - 1``:

    PIN (pin in a hole)  s = eps + m(turn)*P - m(own)*H - shift*w + bend,  d = s - e_j*w,
                         approach = |d| - (e_j + gap)
    JOURNAL (crank in the bearing of its disc)  approach = |shift| - gap
    LOBE (ring pin on a lobe of a disc)
        D = eps - (de + shift)*w + (exp(i*own) - 1)*P_0 + bend + R_m*(1 - exp(-i*s))
            - e*w*(1 - exp(-i*z_p*s)),  approach = gap - n.D  at the foot s of D on the path

P and ``H = P - eps`` are the centres of pin and hole, P_0 is the ring pin's from the disc's centre,
e_j the eccentricity of the crank, de its error, n the outward normal of the path. No formula takes
a difference of large numbers. FLANK is the second foot of a ring pin on the other flank of a valley
narrower than the pin. Without EXACT, a group is in first order of lags and errors, with the levers
of perfect parts. All functions are compiled (`core.drive.compiled`) and take floats, ints, bools
and NumPy arrays only, in SI units.
"""

import math
from typing import Annotated, NamedTuple

from core.arrays import FloatArray, IntArray

Row = Annotated[FloatArray, "row"]
Table = Annotated[FloatArray, "table"]
Block = Annotated[FloatArray, "block"]
Whole = Annotated[IntArray, "whole"]
"""Arrays of one, two and three axes, and of integers with two; functions are compiled by these
annotations."""

Pose = tuple[float, float, float, float, float, float]
"""Numbers that `pose` returns: four of rotations, and two shifts, m."""

JOURNAL, PIN, LOBE, FLANK = range(4)
"""Kinds of a group: crank in its bearing, pin in its hole, ring pin on its lobe, second foot of a
ring pin."""

LINEAR, POWER, HERTZ, CONFORMAL = range(4)
"""Laws of contact, see `law`."""

KIND, LAW, START, STOP, TURN, OWN, ALONG, ACROSS, EXACT, OF = range(10)
"""Integers of a group: kind, law, first contact and end, indices of the displacements that move it
(-1: none), 1 for exact geometry, and for a FLANK the group of the first feet."""

(
    RATE,  # turns of the wave for each turn of the crank
    PHASE,  # angle at the crank angle 0, rad
    ECC,  # eccentricity of its own crank, m
    OFF,  # error of ECC, m
    LATE,  # lag of the disc due to errors, rad
    LOBES,  # number of ring pins z_p
    TOOL_R,  # radius of the tool's circle R_m, m
    TOOL,  # radius of the tool r_m, m
    EXPONENT,  # exponent of the force law
    BASE_E,  # nominal eccentricity, with which a disc is cut, m
    CIRCLE,  # radius of the pins' circle, m
    SHORT,  # e*z_p over R_m, in first order over CIRCLE
    HOLLOW,  # largest curvature of the path's valleys, 1/m
    ROTATION,  # rotation of a modified profile: gap over lever, rad
    RADIUS,  # radius of a ring pin, m
    RATIO,  # ratio u, with a ring the number of lobes of a disc
) = range(16)
"""Floats of a group of contacts."""

BLOCK, PLANE, FIRST = range(3)
"""Integers of a contact: block and plane of a pin that bends (-1: none); of a FLANK, the contact
with the first foot."""

CB, SB, PX, PY, EX, EY, GAP, A, B, LIMIT, RAD, CURVED, WIDER = range(13)
"""Floats of a contact: cosine and sine of its angle, place of the pin and its error against hole or
tool, m, gap, m (of a LOBE the excess of the pin's radius over the tool's), constants A and B of the
law, largest force of the law, radius of the pin, difference of curvatures, radial clearance."""

(
    CA,
    SA,
    MOST,
    OPEN,
    SLOPE,
    LEVER,
    BENT,
    SLIDE,
    FOOT,
    DELTA,
    FORCE,
    STIFF,
    NX,
    NY,
    BOW,
    AX,
    AY,
    HX,
    HY,
    UX,
    UY,
    END,
) = range(22)
"""Floats of a contact at a position: cosine and sine of its angle; largest force of the law, gap,
slope of the path, lever of perfect parts, difference of curvatures, distance to the pitch point,
foot; approach, force, stiffness, normal, curvature of the distance, arm of the pin (of a LOBE its
offset from its ideal place), arm and rotation of the disc, lag at which a ring pin stops the disc.
"""

(
    STATUS,
    STEPS,
    LAG,
    STIFFNESS,
    LOW,
    HIGH,
    PRESSED,
    PLAY,
    PIN_FORCE,
    PIN_PRESSED,
    PIN_LOADED,
    LOBE_FORCE,
    LOBE_PRESSED,
    LOBE_LOADED,
    INPUT_TORQUE,
    ALONG_MOST,
    ALONG_LEAST,
    RUB,
    RUB_PRESSED,
    LOST,
    INTERFERENCE,
) = range(21)
"""Read-outs of a position. LAG, LOW and HIGH count in the direction of the torque. PRESSED is 1 if
parts press without load; PIN_PRESSED and LOBE_PRESSED are the largest force over reduced radius of
`pressing`. RUB is the largest product of force and distance to the pitch point, RUB_PRESSED that of
the root of force over reduced radius and that distance. ALONG is the force of the ring on a disc
along its crank towards the axis, INTERFERENCE the least value over all lags of the largest approach
without load."""

SOLVED, NO_DRIVE, NOT_STABLE, TOO_WIDE = range(4)
"""Status of a position."""

FITS, BINDS, NOWHERE = 2, 1, 0
"""Places at which a piece goes together without load: all, some or none."""

CLASS = 1e-11
"""Unbalance over the largest force before the last step, which leaves its square."""

ROUGH = 1e-5
"""Estimate of that unbalance above which contacts follow the step in second order and are not
measured anew."""

FOLLOWED = 20
"""Number of steps after which contacts are measured at each."""

STILL = 128 * 2.0**-52
"""Step over the largest displacement that is rounding; tiny torques allow no smaller step."""

LEAST_DAMP, LIGHT = 1e-3, 1e-2
"""Damping stiffness, N/m: the first one where nothing else holds a displacement, and one that is
too small to have another effect."""

REACH = 5e-6
"""Longest first step, m, from a start that is near; later steps grow up to `FURTHEST`."""

FURTHEST = 2.5e-4

AHEAD = 1.0
"""Longest way between two positions, rad, over which displacements are extrapolated."""

ROAM = 8e-6
"""Sum of steps, m, after which contacts that were farther open than `FAR` are looked at again."""

FAR = 1.5 * ROAM

STEPS_MOST = 400

HERTZ_END = 1.2
"""Least ``approach/(b*force)`` of Hertz's law, whose stiffness is infinite at 1. The law goes on as
a straight line, and forces on this line are refused afterwards."""

WRAP_BEND = 0.4
"""Constant in the width of conformal contacts, equal to `core.output.conformal_law.BEND`."""

EPS = 2.0**-52
TINY = 1e-100
NOTHING = 1e-9
"""Force over the largest one up to which a disc carries nothing."""

FEET = 30
"""Largest number of steps to a foot; the longest step is `FAR_STEP` over z_p, rad."""

FAR_STEP = 0.1
LAST_STEP = 3e-5
"""Last step to a foot, times z_p, rad; an error of its cube is left."""
NO_TURN = 1e-3
"""Lever over the longest one below which a ring pin, near its dead angle, limits no play."""

CLOSE = 1e-4
"""Last step to the end of a play, over the play; an error of its cube is left."""

SMALL = 0.03
"""Step to the end of a play, over the quarter of a pitch, up to which its second order tells which
ring pins cannot be the first to stop a disc."""

NO_LEVER = 1e-12
"""Lever over the radius of the pin circle up to which a contact carries no torque."""

FAR_LAG = 1e-2
"""Longest step of a lag in `rest`, rad."""

FAINT = 1e-12
"""Stiffness that holds discs that float, over the largest stiffness."""

NEXT_TO_NONE = 1e-1, 1e-3, 1e-5, 1e-7, 1e-9
"""Approaches of a pin over the clearance of crank bearings. Forces at these approaches, one after
the other, push discs that float to the end of their play."""

PRESSES = 1e-5
"""Approach over the clearance of crank bearings; a larger force than at it presses without load."""

LEAST_PLAY = 1e-14
"""Difference of lags that may be rounding, rad."""

ROUNDED = 1e3 * EPS
"""Approach over the sizes of its terms that may be rounding."""

HALVINGS = 200
AT_REST = 1e-15
"""Step of a lag, rad, that is none."""

MIDDLES = 12
PLACE = 1e-10
"""Width of the bracket about a summit at which `narrow` ends, rad."""

MET = 2e-3
"""Width of the bracket about a known summit at which `narrow` ends, rad."""

FLAT = 1e-10
"""Fall from a summit to the places on both sides, over its height, at which `narrow` ends."""

BESIDE = 0.1
"""Distance of a summit from the best place, over the gap between places, below which the next place
is beyond the summit, so that places close to it stand on both sides."""

CLOSE_BY = 1e4
"""Fall over that at the end of `narrow` from which the next place is nearer by the root of both."""

BENT_ALIKE = 3.0
"""Largest ratio of the bends about a smooth summit."""

GOLDEN = (math.sqrt(5) - 1) / 2


class Drive(NamedTuple):
    """Groups of contacts, springs and shares of the torque of a drive."""

    gi: Whole  # [G, 10] integers of the groups
    gf: Table  # [G, 16] floats of the groups
    ci: Whole  # [n, 3] integers of the contacts
    cf: Table  # [n, 13] floats of the contacts
    table: Row  # constants of the conformal law, see `over_width`
    kgg: Table  # [bodies, bodies] stiffness between bodies
    kbb: Table  # [2*K, 2*K] stiffness of a pin that bends
    kbg: Block  # [pins, 2*K, bodies] stiffness between bending pins and bodies
    share: Row  # share of the torque on each body
    weight: Row  # weights of squared displacements: squared radius, m^2, or 1


class Work(NamedTuple):
    """Arrays for the solution of one position; ``w`` has the floats of contacts at a position."""

    q: Row  # displacements of bodies
    b: Table  # [pins, 2*K] bending of pins, m
    w: Table  # [n, 22] floats of contacts
    grad: Table  # [n, 6] gradient of each approach by turn, own, along, across and bending
    side: Row  # [6] derivatives of a contact's place across its normal
    hgg: Table  # second derivatives of the energy by bodies
    hbb: Block  # second derivatives by bending of each pin
    low: Block  # factors of hbb
    used: Row  # 1 for a pin that a contact or a body bends, 0 for others
    hbg: Block  # second derivatives by bending and bodies
    rg: Row  # unbalance of bodies
    rb: Table  # unbalance of bending pins
    sol: Block  # first half of the solutions of hbb for hbg and -rb
    red: Table  # hgg without bending pins, then its factor
    p: Row  # step of bodies
    pb: Table  # step of bending pins
    kept: Row  # displacements kept while a play is solved
    first: Row  # displacements to the first contact at the last position with a play
    bends: Table  # bending kept while a play is solved
    last: Table  # bending of pins at the position before
    older: Table  # bending of pins at the last position but one
    sides: Table  # [2, bodies] displacements under a torque in either direction
    play: Table  # [bodies, 2] least and largest lag of each disc in its ring
    # [G, 3] on the disc: force along its crank towards the axis, force across it against its
    # rotation, N, and torque about its centre, N*m
    wrench: Table


def over_width(x: float, table: Row) -> tuple[float, float]:
    """``Delta/dR`` over the load x of a conformal contact, and the derivative of ``Delta/dR``.
    Table: modulus, widest, n and n powers of `conformal_law.Curve`; modulus, since, widest, powers
    of `Wrap`.
    """
    width, widest = math.sqrt(x / (1 + WRAP_BEND * x)), table[1]
    beyond = width >= widest
    width = widest if beyond else width
    place = 2 * width / widest - 1
    value = slope = 0.0
    for n in range(3, 3 + int(table[2])):
        slope = slope * place + value
        value = value * place + table[n]
    value -= 2 / math.pi * math.log(width)
    if beyond:
        return value, value
    turn = 2 * width / widest * slope - 2 / math.pi
    return value, value + turn * (1 - WRAP_BEND * width * width) / 2


def excess(x: float, table: Row) -> float:
    """Square of a conformal contact's largest pressure over Hertz's, under the load x."""
    at = 3 + int(table[2])
    place = 2 * min(math.sqrt(x / (1 + WRAP_BEND * x)) / table[at + 2], 1.0) - 1
    value = 0.0
    for n in range(at + 3, len(table)):
        value = value * place + table[n]
    return value * value * (1 + WRAP_BEND * x)


def wrapped(d: float, a: float, b: float, near: float, table: Row) -> tuple[float, float]:
    """Force and stiffness of a conformal contact at an approach, by Newton in logarithms."""
    aim = d * table[0] / a
    x, tangent = near / a if near > 0 else aim, 1.0
    for _ in range(16):
        secant, tangent = over_width(x, table)
        secant, tangent = secant + b, tangent + b
        part = math.log(aim / (x * secant)) * secant / tangent
        x *= math.exp(part)
        if abs(part) <= 1e-14:
            break
    return a * x, table[0] / tangent


def line(d: float, a: float, b: float, curved: float) -> tuple[float, float]:
    """Force and stiffness of Hertz's line contact, ``d = F*(a - b*ln(F/curved))``."""
    m = a / b - math.log(d / (b * curved))
    if m <= HERTZ_END - math.log(HERTZ_END):
        return d / (HERTZ_END * b), 1 / (HERTZ_END * b)
    log = math.log(m)
    y = m + log + (log + (log * (1 - log / 2) + log * (1 - log * (1.5 - log / 3)) / m) / m) / m
    for _ in range(8):
        off, slope = y - math.log(y) - m, 1 - 1 / y
        step = off * slope / (slope * slope - off / (2 * y * y))
        y -= step
        # The next step is a third of its cube over ``y*(y - 1)^2``.
        if abs(step * step * step) <= 1e-14 * y * y * (y - 1) * (y - 1):
            break
    return d / (b * y), 1 / (b * (y - 1))


def power(d: float, a: float, b: float, n: float) -> tuple[float, float]:
    """Force and stiffness of ``F = a*x^n`` with a compliance b in series, ``x + b*F = d``."""
    f = a * d**n
    if b == 0:
        return f, n * f / d
    x = d / (1 + b * f / d)
    for _ in range(60):
        f = a * x**n
        step = (x + b * f - d) / (1 + b * n * f / x)
        while step >= x:
            step *= 0.5
        x -= step
        if abs(step) < 1e-13 * x:
            break
    f = a * x**n
    k = n * f / x
    return f, k / (1 + b * k)


def turned(t: float) -> tuple[float, float]:
    """Real and imaginary part of ``exp(-i*t) - 1``."""
    if abs(t) < 0.03:
        x = t * t
        less = x * (0.5 - x * (1 / 24 - x * (1 / 720 - x / 40320)))
        return -less, -t * (1 - x * (1 / 6 - x * (1 / 120 - x / 5040)))
    h = math.sin(t / 2)
    return -2 * h * h, -math.sin(t)


def place(phi: float, drive: Drive, work: Work) -> None:
    """Set angles, gaps and levers of all contacts at a crank angle, rad."""
    gi, gf, cf, w = drive.gi, drive.gf, drive.cf, work.w
    for g in range(len(gi)):
        angle = gf[g, RATE] * phi + gf[g, PHASE]
        c, s = math.cos(angle), math.sin(angle)
        for i in range(gi[g, START], gi[g, STOP]):
            w[i, CA] = c * cf[i, CB] - s * cf[i, SB]
            w[i, SA] = s * cf[i, CB] + c * cf[i, SB]
            w[i, MOST], w[i, OPEN] = cf[i, LIMIT], cf[i, GAP]
            w[i, BENT], w[i, FOOT] = cf[i, CURVED], 0.0
            if gi[g, KIND] <= PIN:
                w[i, LEVER] = -gf[g, CIRCLE] * w[i, SA]
            else:
                place_lobe(i, g, drive, w)


def place_lobe(i: int, g: int, drive: Drive, w: Table) -> None:
    """Set slope, gap and lever of a lobe on its pin, for perfect parts."""
    gf, sa, exact = drive.gf, w[i, SA], drive.gi[g, EXACT] != 0
    z, k = gf[g, LOBES], gf[g, BASE_E] * gf[g, LOBES] / gf[g, CIRCLE]
    slope = steepness(k, i, w)
    w[i, LEVER] = -gf[g, BASE_E] * (z - 1) * sa / slope
    w[i, SLIDE] = abs(gf[g, CIRCLE] * slope - gf[g, RADIUS])
    w[i, OPEN] = w[i, OPEN] - gf[g, ROTATION] * abs(w[i, LEVER])
    w[i, SLOPE] = steepness(gf[g, BASE_E] * z / gf[g, TOOL_R], i, w) if exact else slope


def steepness(k: float, i: int, w: Table) -> float:
    """Slope of the path of eccentricity k over its circle and number of pins, at a lobe's pin."""
    ca, sa = w[i, CA], w[i, SA]
    less = sa * sa / (1 + ca) if ca > 0 else 1 - ca
    return math.sqrt((1 - k) * (1 - k) + 2 * k * less)


def curvature(slope: float, g: int, drive: Drive) -> float:
    """Curvature of the path of a group's lobes where it has a slope, 1/m."""
    pins, tool = drive.gf[g, LOBES], drive.gf[g, TOOL_R]
    k = drive.gf[g, BASE_E] * pins / tool
    bend = (1 - k) * (1 - pins * k) + (pins + 1) * (slope * slope - (1 - k) * (1 - k)) / 2
    return float(bend / (tool * slope * slope * slope))


def bend_lobe(i: int, g: int, drive: Drive, w: Table) -> None:
    """Set curvature and law of a lobe on its pin, for perfect parts."""
    gf, cf = drive.gf, drive.cf
    slope = steepness(gf[g, BASE_E] * gf[g, LOBES] / gf[g, TOOL_R], i, w)
    bend = curvature(slope, g, drive)
    # A pin wider than its valley does not touch there: its contact counts as flat.
    w[i, BENT] = max(1 / cf[i, RAD] + bend / (1 - gf[g, TOOL] * bend), EPS / cf[i, RAD])
    if drive.gi[g, LAW] == HERTZ:
        w[i, MOST] = cf[i, LIMIT] * w[i, BENT]


def law(i: int, g: int, near: float, drive: Drive, w: Table) -> tuple[float, float]:
    """Force and stiffness of a contact at its approach > 0; ``near`` is a force nearby, or 0."""
    kind, d, a, b = drive.gi[g, LAW], w[i, DELTA], drive.cf[i, A], drive.cf[i, B]
    if drive.gi[g, KIND] > PIN and w[i, BENT] == 0:
        bend_lobe(i, g, drive, w)
    if kind == LINEAR:
        return d / a, 1 / a
    if kind == HERTZ:
        return line(d, a, b, w[i, BENT] if drive.gi[g, KIND] > PIN else 1.0)
    if kind == POWER:
        return power(d, a, b, drive.gf[g, EXPONENT])
    return wrapped(d, a, b, near, drive.table)


def moved(index: int, q: Row) -> float:
    """Displacement of an index, 0 for the index -1."""
    return q[index] if index >= 0 else 0.0


def disc_at(g: int, q: Row, drive: Drive) -> tuple[float, float, float]:
    """Lag of a group's disc, rad, and its shifts along and across its crank, m."""
    gi = drive.gi
    own = drive.gf[g, LATE] + moved(gi[g, OWN], q)
    return own, moved(gi[g, ALONG], q), moved(gi[g, ACROSS], q)


def bent(i: int, b: Table, drive: Drive) -> tuple[float, float]:
    """Bending of a contact's pin at its plane, outward and as the output turns, m."""
    block, at = drive.ci[i, BLOCK], 2 * drive.ci[i, PLANE]
    return (b[block, at], b[block, at + 1]) if block >= 0 else (0.0, 0.0)


def pose(g: int, drive: Drive, work: Work) -> Pose:
    """Real and imaginary parts of ``exp(-i*t) - 1`` of the lags t of the output and of a group's
    disc, and the disc's shifts along and across its crank, m.
    """
    own, ta, tc = disc_at(g, work.q, drive)
    turn = moved(drive.gi[g, TURN], work.q)
    if drive.gi[g, EXACT] == 0:
        return 0.0, -turn, 0.0, -own, ta, tc
    (m1x, m1y), (m2x, m2y) = turned(turn), turned(own)
    return m1x, m1y, m2x, m2y, ta, tc


def pin(i: int, g: int, at: Pose, drive: Drive, work: Work) -> None:
    """Set approach, normal and arms of a pin in its hole or of a crank in its bearing."""
    (m1x, m1y, m2x, m2y, ta, tc), (bx, by) = at, bent(i, work.b, drive)
    gf, cf, w, ca, sa = drive.gf, drive.cf, work.w, work.w[i, CA], -work.w[i, SA]
    px, py, e = cf[i, PX], cf[i, PY], gf[g, ECC]
    hx, hy = px - cf[i, EX], py - cf[i, EY]
    exact = drive.gi[g, EXACT] != 0
    if not exact:
        hx, hy, px, py = gf[g, CIRCLE], 0.0, gf[g, CIRCLE], 0.0
    sx = cf[i, EX] + m1x * px - m1y * py - m2x * hx + m2y * hy - ta * ca + tc * sa + bx
    sy = cf[i, EY] + m1x * py + m1y * px - m2x * hy - m2y * hx - ta * sa - tc * ca + by
    w[i, UX], w[i, UY] = 1.0, 0.0
    w[i, AX], w[i, AY], w[i, HX], w[i, HY] = px, py, hx, hy
    if not exact:
        w[i, NX], w[i, NY], w[i, BOW] = -ca, -sa, 0.0
        w[i, DELTA] = -(ca * sx + sa * sy) - cf[i, GAP]
        return
    room = e + cf[i, GAP]
    number = sx * sx + sy * sy - 2 * e * (ca * sx + sa * sy) - (e + room) * cf[i, GAP]
    length = math.sqrt(max(room * room + number, TINY))
    w[i, DELTA], w[i, BOW] = number / (length + room), 1 / length
    w[i, NX], w[i, NY] = (sx - e * ca) / length, (sy - e * sa) / length
    w[i, AX], w[i, AY] = px + m1x * px - m1y * py, py + m1x * py + m1y * px
    w[i, HX], w[i, HY] = hx + m2x * hx - m2y * hy, hy + m2x * hy + m2y * hx


def lobe(i: int, g: int, at: Pose, drive: Drive, work: Work) -> None:
    """Set approach, normal and arms of a ring pin; only one that may touch looks for its foot."""
    (_, _, m2x, m2y, ta, tc), (bx, by) = at, bent(i, work.b, drive)
    gf, cf, w, k = drive.gf, drive.cf, work.w, drive.gf[g, SHORT]
    ca, sa = w[i, CA], -w[i, SA]
    px = cf[i, PX] - (gf[g, ECC] + ta) * ca + tc * sa + bx
    py = cf[i, PY] - (gf[g, ECC] + ta) * sa - tc * ca + by
    exact = drive.gi[g, EXACT] != 0
    if not exact:
        px, py = gf[g, CIRCLE] - gf[g, BASE_E] * ca, -gf[g, BASE_E] * sa
    mx, my = m2x * px + m2y * py, m2x * py - m2y * px
    dx = cf[i, EX] - (gf[g, OFF] + ta) * ca + tc * sa + bx + mx
    dy = cf[i, EY] - (gf[g, OFF] + ta) * sa - tc * ca + by + my
    gx, gy, wide = 1 - k * ca, -k * sa, w[i, OPEN]
    d = wide - (gx * dx + gy * dy) / w[i, SLOPE]
    w[i, DELTA], w[i, BOW] = d, 0.0
    w[i, NX], w[i, NY] = -gx / w[i, SLOPE], -gy / w[i, SLOPE]
    w[i, UX], w[i, UY], w[i, HX], w[i, HY], w[i, AX], w[i, AY] = 1.0, 0.0, px, py, dx, dy
    if not exact:
        return
    w[i, UX], w[i, UY], w[i, HX], w[i, HY] = 1 + m2x, -m2y, px + mx, py + my
    second = drive.gi[g, KIND] == FLANK
    if second and wide * gf[g, HOLLOW] <= 1:
        w[i, DELTA] = -math.inf
        return
    hollow, way = gf[g, HOLLOW] + 1 / gf[g, TOOL_R], dx * dx + dy * dy
    if not second and d < 0 and -d * (1 - max(wide, 0.0) * hollow) >= 2 * hollow * way:
        return
    foot_of(i, g, drive, w)


def foot_of(i: int, g: int, drive: Drive, w: Table) -> None:
    """Set approach and normal of a ring pin at its foot on the path, by steps in a bracket."""
    gf, ca, sa = drive.gf, w[i, CA], -w[i, SA]
    bx, by, px, py = w[i, AX], w[i, AY], w[i, HX], w[i, HY]
    e, radius, pins, k = gf[g, BASE_E], gf[g, TOOL_R], gf[g, LOBES], gf[g, SHORT]
    second = drive.gi[g, KIND] == FLANK
    longest, close = FAR_STEP / pins, LAST_STEP / pins
    off = 4 * math.sqrt(bx * bx + by * by)
    final = off / radius / (1 - k)
    first, foot = -final, w[i, FOOT]
    # The path is symmetric about the axes of its valleys and lobes: a pin between two axes has its
    # nearest point between them, and there the distance has a minimum.
    if second or off > gf[g, TOOL] or off * gf[g, HOLLOW] > 1:
        angle, half = math.atan2(-sa, ca) / (pins - 1), math.pi / (pins - 1)
        at = math.floor((angle - math.atan2(py, px)) / half)
        if second:
            valley = half * (at + at % 2) - angle
            foot = 2 * valley - w[drive.ci[i, FIRST], FOOT]
            at += 2 * (at % 2) - 1
        first = half * at - angle
        final = first + half
    foot, last = min(max(foot, first), final), False
    gx = gy = hx = hy = dx = dy = size = under = 0.0
    for _ in range(FEET):
        (c1, n1), (c2, n2) = turned(foot), turned(pins * foot)
        ex, ey = ca * c2 - sa * n2, sa * c2 + ca * n2
        dx, dy = bx - radius * c1 + e * ex, by - radius * n1 + e * ey
        gx, gy = 1 + c1 - k * (ca + ex), n1 - k * (sa + ey)
        hx, hy = 1 + c1 - pins * k * (ca + ex), n1 - pins * k * (sa + ey)
        size = gx * gx + gy * gy
        under = radius * size + hx * dx + hy * dy
        if last:
            break
        ahead = gy * dx - gx * dy
        step = ahead / (under if under > 0 else radius * size)
        if under > 0 and abs(step) < longest:  # in second order: by the derivative of ``under``
            bend = pins * pins * k
            jx, jy = 1 + c1 - bend * (ca + ex), n1 - bend * (sa + ey)
            grows = 3 * radius * (gx * hy - gy * hx) + jy * dx - jx * dy
            step -= step * step * grows / (2 * under)
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
    w[i, FOOT], w[i, NX], w[i, NY] = foot, -nx, -ny
    if second and abs(gy * dx - gx * dy) > close * under:  # driven to the middle
        w[i, DELTA] = -math.inf
        return
    w[i, DELTA] = w[i, OPEN] - (nx * dx + ny * dy)
    w[i, BOW] = -(gx * hx + gy * hy) / (length * under) if under > 0 else 0.0


def touch(i: int, g: int, at: Pose, drive: Drive, work: Work) -> None:
    """Set the approach of a contact at the `pose` of its group and the bending of its pin."""
    if drive.gi[g, KIND] <= PIN:
        pin(i, g, at, drive, work)
    else:
        lobe(i, g, at, drive, work)


def slopes(i: int, g: int, drive: Drive, work: Work) -> tuple[float, float]:
    """Set a contact's ``grad``, ``side``; return second derivatives by turns of output and disc."""
    w, grad, side, kind = work.w, work.grad, work.side, drive.gi[g, KIND]
    nx, ny, ca, sa, ux, uy = w[i, NX], w[i, NY], w[i, CA], -w[i, SA], w[i, UX], w[i, UY]
    hx, hy, ax, ay = w[i, HX], w[i, HY], w[i, AX], w[i, AY]
    px, py = -(ux * ca - uy * sa), -(ux * sa + uy * ca)  # along the crank
    if kind <= PIN:
        grad[i, 0], side[0] = nx * ay - ny * ax, -nx * ax - ny * ay
    else:
        grad[i, 0], side[0] = 0.0, 0.0
    grad[i, 1], side[1] = ny * hx - nx * hy, nx * hx + ny * hy
    grad[i, 2], side[2] = nx * px + ny * py, nx * py - ny * px
    grad[i, 3], side[3] = ny * px - nx * py, nx * px + ny * py
    grad[i, 4], side[4] = nx * ux + ny * uy, nx * uy - ny * ux
    grad[i, 5], side[5] = ny * ux - nx * uy, nx * ux + ny * uy
    if drive.gi[g, EXACT] == 0:
        return 0.0, 0.0
    if kind <= PIN:
        return -(nx * ax + ny * ay), nx * hx + ny * hy
    return 0.0, -(nx * hx + ny * hy)


def press(i: int, g: int, drive: Drive, work: Work) -> None:
    """Add force and stiffness of a contact to the balance and its derivatives."""
    gi, w, grad, side = drive.gi, work.w, work.grad, work.side
    by_turn, by_own = slopes(i, g, drive, work)
    f, k = law(i, g, w[i, FORCE], drive, w)
    w[i, FORCE], w[i, STIFF] = f, k
    bow, block, curved = f * w[i, BOW], drive.ci[i, BLOCK], gi[g, KIND] > PIN
    curved = curved and gi[g, EXACT] != 0
    for s in range(4):
        row = gi[g, TURN + s]
        if row < 0:
            continue
        work.rg[row] += f * grad[i, s]
        for t in range(s + 1):
            col = gi[g, TURN + t]
            if col < 0:
                continue
            x = k * grad[i, s] * grad[i, t] + bow * side[s] * side[t]
            if t == s:
                x += f * (by_turn if s == 0 else (by_own if s == 1 else 0.0))
                work.hgg[row, row] += x
                continue
            if t == 1 and curved:  # shifts turn with the disc
                x += f * -side[s] if s > 1 else 0.0
            work.hgg[row, col] += x
            work.hgg[col, row] += x
    if block >= 0:
        press_block(i, g, f, k, bow, curved, drive, work)


def press_block(
    i: int, g: int, f: float, k: float, bow: float, curved: bool, drive: Drive, work: Work
) -> None:
    """Add a contact's force and stiffness to the equations of its bending pin."""
    gi, grad, side, block = drive.gi, work.grad, work.side, drive.ci[i, BLOCK]
    at = 2 * drive.ci[i, PLANE]
    work.used[block] = 1.0
    for s in range(4, 6):
        row = at + s - 4
        work.rb[block, row] += f * grad[i, s]
        for t in range(4):
            col = gi[g, TURN + t]
            if col >= 0:
                x = k * grad[i, s] * grad[i, t] + bow * side[s] * side[t]
                if t == 1 and curved:
                    x += f * -side[s]
                work.hbg[block, row, col] += x
        for t in range(4, 6):
            x = k * grad[i, s] * grad[i, t] + bow * side[s] * side[t]
            work.hbb[block, row, at + t - 4] += x


def springs(torque: float, drive: Drive, work: Work) -> None:
    """Set the balance and its derivatives to those of springs and torque."""
    q, b = work.q, work.b
    for i in range(len(q)):
        work.rg[i] = -torque * drive.share[i]
        for k in range(len(q)):
            work.hgg[i, k] = drive.kgg[i, k]
            work.rg[i] += drive.kgg[i, k] * q[k]
    for m in range(b.shape[0]):
        work.used[m] = 0.0
        for i in range(b.shape[1]):
            r = 0.0
            for k in range(b.shape[1]):
                work.hbb[m, i, k] = drive.kbb[i, k]
                r += drive.kbb[i, k] * b[m, k]
            for k in range(len(q)):
                work.hbg[m, i, k] = drive.kbg[m, i, k]
                r += drive.kbg[m, i, k] * q[k]
                work.used[m] = max(work.used[m], abs(drive.kbg[m, i, k]))
                work.rg[k] += drive.kbg[m, i, k] * b[m, i]
            work.rb[m, i] = r


def change(i: int, g: int, of: Row, drive: Drive, work: Work) -> float:
    """Change by the step of what has derivatives ``of`` by a contact's displacements."""
    gi, found, block = drive.gi, 0.0, drive.ci[i, BLOCK]
    for s in range(4):
        if gi[g, TURN + s] >= 0:
            found += of[s] * work.p[gi[g, TURN + s]]
    if block >= 0:
        at = 2 * drive.ci[i, PLANE]
        found += of[4] * work.pb[block, at] + of[5] * work.pb[block, at + 1]
    return found


def spun(i: int, x: int, y: int, angle: float, w: Table) -> None:
    """Turn a vector of a contact by a small angle."""
    w[i, x], w[i, y] = w[i, x] - angle * w[i, y], w[i, y] + angle * w[i, x]


def follow(i: int, g: int, part: float, drive: Drive, work: Work) -> None:
    """Move approach, normal and arms of a contact along a part of the step, in second order."""
    gi, w, side = drive.gi, work.w, work.side
    by_turn, by_own = slopes(i, g, drive, work)
    w[i, DELTA] += part * change(i, g, work.grad[i], drive, work)
    if gi[g, EXACT] == 0:
        return
    across, bow = part * change(i, g, side, drive, work), w[i, BOW]
    turn, own = part * moved(gi[g, TURN], work.p), part * moved(gi[g, OWN], work.p)
    w[i, DELTA] += (bow * across * across + by_turn * turn * turn + by_own * own * own) / 2
    spun(i, NX, NY, bow * across, w)
    if gi[g, KIND] > PIN:
        w[i, DELTA] -= (across - side[1] * own) * own
        spun(i, HX, HY, own, w)
        spun(i, UX, UY, own, w)
    else:
        spun(i, HX, HY, -own, w)
        spun(i, AX, AY, -turn, w)


def assemble(torque: float, near: bool, part: float, drive: Drive, work: Work) -> None:
    """Set balance, derivatives and contact forces at q and b, if ``near`` without contacts that
    were farther open than `FAR`. Contacts follow a part of the step; 0 measures them anew.
    """
    gi, w = drive.gi, work.w
    springs(torque, drive, work)
    for g in range(len(gi)):
        at = pose(g, drive, work)
        for i in range(gi[g, START], gi[g, STOP]):
            if near and w[i, DELTA] < -FAR and gi[g, KIND] != FLANK:
                continue
            if part != 0:
                follow(i, g, part, drive, work)
            else:
                touch(i, g, at, drive, work)
            if w[i, DELTA] > TINY:
                press(i, g, drive, work)
                continue
            w[i, FORCE] = w[i, STIFF] = 0.0


def factor(m: Table) -> bool:
    """Factor a matrix by its lower half, by Cholesky; False if a pivot is not positive."""
    n = len(m)
    for j in range(n):
        s = m[j, j]
        for k in range(j):
            s -= m[j, k] * m[j, k]
        if not s > 1e-14 * abs(m[j, j]):
            return False
        m[j, j] = math.sqrt(s)
        for i in range(j + 1, n):
            s = m[i, j]
            for k in range(j):
                s -= m[i, k] * m[j, k]
            m[i, j] = s / m[j, j]
    return True


def down(m: Table, x: Row) -> None:
    """Solve the first half of the equations, in place, with the matrix from `factor`."""
    for i in range(len(x)):
        s = x[i]
        for k in range(i):
            s -= m[i, k] * x[k]
        x[i] = s / m[i, i]


def up(m: Table, x: Row) -> None:
    """Solve the second half of the equations, in place, after `down`."""
    for i in range(len(x) - 1, -1, -1):
        s = x[i]
        for k in range(i + 1, len(x)):
            s -= m[k, i] * x[k]
        x[i] = s / m[i, i]


def straight(m: int, work: Work) -> None:
    """Set the step of a pin that nothing bends: back to straight."""
    moved = 0.0
    for i in range(work.rb.shape[1]):
        moved += abs(work.rb[m, i])
    for i in range(work.rb.shape[1]):
        work.pb[m, i] = -work.b[m, i] if moved > 0 else 0.0


def eliminated(m: int, work: Work) -> bool:
    """Eliminate a bending pin from the equations of bodies; False if it is not convex."""
    low, sol, red, p = work.low[m], work.sol[m], work.red, work.p
    ng, nb = len(p), len(low)
    for i in range(nb):
        for k in range(i + 1):
            low[i, k] = work.hbb[m, i, k]
        for k in range(ng):
            sol[k, i] = work.hbg[m, i, k]
        sol[ng, i] = -work.rb[m, i]
    if not factor(low):
        return False
    for k in range(ng + 1):
        down(low, sol[k])
    for i in range(ng):
        for n in range(nb):
            for k in range(i + 1):
                red[i, k] -= sol[i, n] * sol[k, n]
            p[i] -= sol[i, n] * sol[ng, n]
    return True


def reduced(damp: float, drive: Drive, work: Work) -> bool:
    """Eliminate bending pins, factor the rest of the equations; False if it is not convex."""
    red, p = work.red, work.p
    for i in range(len(p)):
        for k in range(i + 1):
            red[i, k] = work.hgg[i, k]
        red[i, i] += damp * drive.weight[i]
        p[i] = -work.rg[i]
    for m in range(len(work.used)):
        if work.used[m] != 0 and not eliminated(m, work):
            return False
    return factor(red)


def direction(damp: float, drive: Drive, work: Work) -> bool:
    """Set Newton's step ``p``, ``pb``; False if the energy is not convex."""
    if not reduced(damp, drive, work):
        return False
    p, pb, ng = work.p, work.pb, len(work.p)
    down(work.red, p)
    up(work.red, p)
    for m in range(len(work.used)):
        if work.used[m] == 0:
            straight(m, work)
            continue
        for i in range(pb.shape[1]):
            s = work.sol[m, ng, i]
            for k in range(ng):
                s -= work.sol[m, k, i] * p[k]
            pb[m, i] = s
        up(work.low[m], pb[m])
    return True


def go(part: float, work: Work) -> None:
    """Add a part of the step to the displacements."""
    for i in range(len(work.q)):
        work.q[i] += part * work.p[i]
    for m in range(work.b.shape[0]):
        for i in range(work.b.shape[1]):
            work.b[m, i] += part * work.pb[m, i]


def along_step(work: Work) -> float:
    """Derivative of the energy along the step."""
    found = 0.0
    for i in range(len(work.q)):
        found += work.p[i] * work.rg[i]
    for m in range(work.b.shape[0]):
        for i in range(work.b.shape[1]):
            found += work.pb[m, i] * work.rb[m, i]
    return found


def left_over(damp: float, step: float, drive: Drive, work: Work) -> float:
    """Estimate of the unbalance after the step, in second order, over the largest force."""
    gi, w, top, rest = drive.gi, work.w, 0.0, 0.0
    for i in range(len(work.q)):
        rest = max(rest, damp * abs(work.p[i]) * math.sqrt(drive.weight[i]))
    for g in range(len(gi)):
        for i in range(gi[g, START], gi[g, STOP]):
            f, d = w[i, FORCE], w[i, DELTA]
            if f <= 0:
                if d >= -2 * step and step > 1e-13:
                    return math.inf
                continue
            x = change(i, g, work.grad[i], drive, work)
            k, top = w[i, STIFF], max(top, f)
            if x > -0.5 * d:
                rest = max(rest, (abs(k * d - f) + 1e-3 * f) * (x / d) * (x / d))
            else:
                rest = max(rest, f + k * abs(x))
    return rest / top if top > 0 else math.inf


def settled(slope: float, work: Work) -> bool:
    """True if the step releases too little energy to change a force by `CLASS` of the largest."""
    top = stiff = 0.0
    for i in range(len(work.w)):
        top, stiff = max(top, work.w[i, FORCE]), max(stiff, work.w[i, STIFF])
    return bool(-slope * stiff <= CLASS * top * CLASS * top)


def length_of(drive: Drive, work: Work) -> float:
    """Sum of the changes of displacements by the step, m: no gap changes by half more."""
    step = bend = 0.0
    for i in range(len(work.q)):
        step += abs(work.p[i]) * math.sqrt(drive.weight[i])
    for m in range(work.b.shape[0]):
        for i in range(work.b.shape[1]):
            bend = max(bend, abs(work.pb[m, i]))
    return step + 2 * bend


def far_off(drive: Drive, work: Work) -> float:
    """Largest displacement of a body, m."""
    far = 0.0
    for i in range(len(work.q)):
        far = max(far, abs(work.q[i]) * math.sqrt(drive.weight[i]))
    return far


def afloat(drive: Drive) -> float:
    """Radial clearance of crank bearings in which discs float, m; 0 if they do not."""
    for g in range(len(drive.gi)):
        if drive.gi[g, KIND] == JOURNAL:
            return float(drive.cf[drive.gi[g, START], GAP])
    return 0.0


def held(drive: Drive, work: Work) -> None:
    """Add a stiffness to bodies that nothing holds, and a faint one to discs that float."""
    most = 0.0
    for i in range(len(work.q)):
        most = max(most, work.hgg[i, i] / drive.weight[i])
        if work.hgg[i, i] == 0:
            work.hgg[i, i] = drive.weight[i]
    if afloat(drive) > 0:
        for i in range(1, len(work.q)):
            work.hgg[i, i] += FAINT * most * drive.weight[i]


def last_step(torque: float, near: bool, drive: Drive, work: Work) -> None:
    """Take the last step of Newton, and one more along which forces change linearly."""
    gi, w = drive.gi, work.w
    go(1.0, work)
    assemble(torque, near, 0.0, drive, work)
    held(drive, work)
    if not direction(0.0, drive, work) or length_of(drive, work) > REACH:
        return
    go(1.0, work)
    for g in range(len(gi)):
        for i in range(gi[g, START], gi[g, STOP]):
            if w[i, FORCE] > 0:
                x = change(i, g, work.grad[i], drive, work)
                w[i, FORCE] = max(w[i, FORCE] + w[i, STIFF] * x, 0.0)


def solve(torque: float, reach: float, drive: Drive, work: Work) -> int:
    """Solve the equilibrium near q and b in place by a first step up to ``reach``, m; return the
    steps taken, negative on failure.
    """
    gone = damp = slope = step = part = roamed = 0.0  # part: of the step that contacts follow
    cap, cuts = reach, 0
    for count in range(1, STEPS_MOST):
        if part == 0 and roamed > ROAM:
            roamed = 0.0
        assemble(torque, roamed > 0, part, drive, work)
        if gone > 0:
            after = along_step(work)
            if slope < 0 and after > -0.9 * slope and cuts < 40:
                shorter = gone * min(max(slope / (slope - after), 0.1), 0.6)
                part = shorter - gone if part != 0 else 0.0
                go(shorter - gone, work)
                gone, cuts = shorter, cuts + 1
                continue
            cap = min(4 * cap, FURTHEST) if gone * step >= 0.99 * cap else cap
            gone, cuts = 0.0, 0
        if not direction(damp, drive, work):
            damp, part = max(100 * damp, LEAST_DAMP), 0.0
            if damp > 1e14:
                return -count
            continue
        slope, step = along_step(work), length_of(drive, work)
        rest = left_over(damp, step, drive, work) if step < REACH else math.inf
        still = step <= STILL * far_off(drive, work) or (step < REACH and settled(slope, work))
        if part == 0 and (rest <= CLASS or (damp < LIGHT and still)):
            last_step(torque, roamed + step <= ROAM, drive, work)
            return count
        damp = damp * 0.01 if damp > LIGHT else 0.0
        gone = min(1.0, cap / step) if step > 0 else 1.0
        go(gone, work)
        roamed += gone * step
        following = rest > ROUGH and not still and roamed <= ROAM and count < FOLLOWED
        if part != 0 and not following:  # slopes of contacts that followed tell nothing of others
            part = gone = 0.0
        else:
            part = gone if following else 0.0
    return -STEPS_MOST


def rounding(i: int, g: int, lag: float, drive: Drive) -> float:
    """Largest approach of a ring pin that may be rounding, m."""
    cf, gf = drive.cf, drive.gf
    size = abs(cf[i, EX]) + abs(cf[i, EY]) + abs(cf[i, GAP]) + abs(gf[g, OFF])
    turn = abs(lag) + abs(gf[g, LATE]) + gf[g, ROTATION]
    return float(ROUNDED * (size + turn * gf[g, CIRCLE]))


def of_ring(g: int, body: int, drive: Drive) -> bool:
    """True if a group's lobes turn with a body."""
    return bool(drive.gi[g, KIND] == LOBE and drive.gi[g, OWN] == body)


def dead(g: int, drive: Drive) -> float:
    """Lever below which a ring pin limits no play, m."""
    return float(NO_TURN * drive.gf[g, BASE_E] * (drive.gf[g, LOBES] - 1))


def turns(i: int, w: Table) -> float:
    """Derivative of a ring pin's approach by the lag of its disc after `touch`, m."""
    return float(w[i, NY] * w[i, HX] - w[i, NX] * w[i, HY])


def stops_at(lag: float, side: float, i: int, g: int, drive: Drive, w: Table) -> float:
    """Lag, times the side 1 or -1, at which a ring pin stops its disc, in second order from `touch`
    at a lag; infinite if its lever is short.
    """
    d, nx, ny, hx, hy, bow = w[i, DELTA], w[i, NX], w[i, NY], w[i, HX], w[i, HY], w[i, BOW]
    exact = drive.gi[g, EXACT] != 0
    if exact and bow == 0:  # it was too far open to look for its foot
        bow = -curvature(w[i, SLOPE], g, drive)
        across = nx * w[i, AY] - ny * w[i, AX]
        d, nx, ny = d + bow * across * across / 2, nx - bow * across * ny, ny + bow * across * nx
    lever, across = side * (ny * hx - nx * hy), nx * hx + ny * hy
    if not lever > dead(g, drive) / 2:
        return math.inf
    square = lever * lever - (2 * d * (bow * across - 1) * across if exact else 0.0)
    return float(side * lag - 2 * d / (lever + (math.sqrt(square) if square > 0 else lever)))


def ring_end(side: float, body: int, drive: Drive, work: Work) -> float:
    """Lag at which the first ring pin stops a disc that turns to the side 1 or -1, by steps in
    second order, the first of all pins and the next ones of those that stop it not much later.
    """
    gi, w, lag, within = drive.gi, work.w, 0.0, math.inf
    for step in range(13):
        best, work.q[body] = math.inf, lag
        for g in range(len(gi)):
            if not of_ring(g, body, drive):
                continue
            at = pose(g, drive, work)
            for i in range(gi[g, START], gi[g, STOP]):
                if side * w[i, LEVER] < dead(g, drive) or (step > 0 and w[i, END] > within):
                    continue
                touch(i, g, at, drive, work)
                w[i, END] = stops_at(lag, side, i, g, drive, w)
                best = min(best, w[i, END])
        if best == math.inf:
            return lag if step > 0 else side * best
        change, lag = abs(side * best - lag), side * best
        if not change > CLOSE * abs(lag):
            break
        within = best + change / 4 if change < SMALL * quarter(body, drive) else math.inf
    return lag


def pressed_at(lag: float, side: float, body: int, drive: Drive, work: Work) -> bool:
    """True if a ring pin presses that does not limit a side (side 0: one at its dead angle)."""
    gi, w = drive.gi, work.w
    work.q[body] = lag
    for g in range(len(gi)):
        if not of_ring(g, body, drive) or (side != 0 and gi[g, EXACT] == 0):
            continue
        at = pose(g, drive, work)
        for i in range(gi[g, START], gi[g, STOP]):
            lever = w[i, LEVER]
            if abs(lever) < dead(g, drive) if side == 0 else side * lever < dead(g, drive):
                touch(i, g, at, drive, work)
                if w[i, DELTA] > rounding(i, g, lag, drive):
                    return True
    return False


def on_top(i: int, g: int, drive: Drive, w: Table) -> float:
    """Lag next to 0 at which a ring pin stands on the top of a lobe, rad."""
    gf, ca, sa = drive.gf, w[i, CA], w[i, SA]
    z = gf[g, LOBES] - 1
    x = drive.cf[i, PX] - gf[g, ECC] * ca
    y = drive.cf[i, PY] + gf[g, ECC] * sa
    lag = (math.atan2(sa, ca) - math.pi) / z - math.atan2(y, x) - gf[g, LATE]
    pitch = 2 * math.pi / z
    return float(lag - pitch * math.floor(lag / pitch + 0.5))


def presses_on_top(i: int, g: int, body: int, drive: Drive, work: Work) -> bool:
    """True if a ring pin presses the top of its lobe."""
    lag = on_top(i, g, drive, work.w)
    work.q[body] = lag
    touch(i, g, pose(g, drive, work), drive, work)
    return bool(work.w[i, DELTA] > rounding(i, g, lag, drive))


def passed(low: float, high: float, body: int, drive: Drive, work: Work) -> bool:
    """True if a ring pin presses the top of a lobe that it passes between two lags."""
    gi, w = drive.gi, work.w
    for g in range(len(gi)):
        if not of_ring(g, body, drive) or gi[g, EXACT] == 0:
            continue
        z, late = drive.gf[g, LOBES] - 1, abs(drive.gf[g, LATE])
        near = 2 * z * (max(abs(low), abs(high)) + late)
        for i in range(gi[g, START], gi[g, STOP]):
            if w[i, CA] >= 0 or abs(w[i, SA]) > near or not low < on_top(i, g, drive, w) < high:
                continue
            if presses_on_top(i, g, body, drive, work):
                return True
    return False


def worst_at(lag: float, body: int, drive: Drive, work: Work) -> tuple[float, float, int, int]:
    """Largest approach of a body's ring pins at a lag, its derivative, contact and group."""
    gi, w, worst, slope, first, group = drive.gi, work.w, -math.inf, 0.0, -1, -1
    work.q[body] = lag
    for g in range(len(gi)):
        if not of_ring(g, body, drive):
            continue
        at = pose(g, drive, work)
        for i in range(gi[g, START], gi[g, STOP]):
            touch(i, g, at, drive, work)
            if gi[g, EXACT] != 0:
                foot_of(i, g, drive, w)
            if w[i, DELTA] > worst:
                worst, slope, first, group = w[i, DELTA], turns(i, w), i, g
    return worst, slope, first, group


def next_top(first: float, last: float, body: int, drive: Drive, work: Work) -> float:
    """First of the lags up to ``last`` at which a pin on the top of a lobe presses most."""
    gi, w = drive.gi, work.w
    for g in range(len(gi)):
        if not of_ring(g, body, drive) or gi[g, EXACT] == 0:
            continue
        for i in range(gi[g, START], gi[g, STOP]):
            lag = on_top(i, g, drive, w)
            if w[i, CA] >= 0 or not first < lag < last:
                continue
            presses = presses_on_top(i, g, body, drive, work)
            if presses and worst_at(lag, body, drive, work)[2] == i:
                last = lag
    return last


def freest(low: float, high: float, body: int, drive: Drive, work: Work) -> tuple[float, float]:
    """Lag between two at which ring pins press least, and their largest approach there."""
    w, found, least, first = work.w, low, math.inf, low
    while first < high:
        last = next_top(first, high, body, drive, work)
        below, above, lag, left, right = first, last, (first + last) / 2, -1, -1
        # Up to a lag with a pin on a lobe's top, the largest approach falls, then rises: by steps
        # in a bracket to where the approaches of the pins on both sides are equal.
        for _ in range(HALVINGS):
            worst, slope, i, _ = worst_at(lag, body, drive, work)
            if worst < least:
                found, least = lag, worst
            if slope > 0:
                above, right = lag, i
            else:
                below, left = lag, i
            if left >= 0 and right >= 0 and left != right:
                parting = turns(right, w) - turns(left, w)
                step = (w[left, DELTA] - w[right, DELTA]) / parting if parting > 0 else math.inf
                lag += step
                if abs(step) <= AT_REST:
                    break
            if not below < lag < above:
                lag = (below + above) / 2
            if lag in (below, above):
                break
        first = last
    return found, least


def first_touch(lag: float, far: float, body: int, drive: Drive, work: Work) -> float:
    """Lag at which the first ring pin touches between a free and a far one, by steps in
    a bracket.
    """
    gi, w = drive.gi, work.w
    for g in range(len(gi)):
        if not of_ring(g, body, drive):
            continue
        for i in range(gi[g, START], gi[g, STOP]):
            top = on_top(i, g, drive, w)
            between = w[i, CA] < 0 and min(lag, far) < top < max(lag, far)
            if between and presses_on_top(i, g, body, drive, work):
                far = top
    at = (lag + far) / 2
    for _ in range(HALVINGS):
        worst, slope, _, _ = worst_at(at, body, drive, work)
        if worst > 0:
            far = at
        else:
            lag = at
        step = worst / slope if slope != 0 else math.inf
        at -= step
        if abs(step) <= AT_REST:
            return at
        if not min(lag, far) < at < max(lag, far):
            at = (lag + far) / 2
        if at in (lag, far):
            break
    return lag


def quarter(body: int, drive: Drive) -> float:
    """Quarter of a pitch of a body's lobes, rad: by then its ring pins stop a disc."""
    for g in range(len(drive.gi)):
        if of_ring(g, body, drive):
            return float(math.pi / 2 / (drive.gf[g, LOBES] - 1))
    return 0.0


def ring_play(body: int, drive: Drive, work: Work) -> tuple[float, float]:
    """Least and largest free lag of a body in its ring; least above largest if pins press."""
    free = not pressed_at(0.0, 0.0, body, drive, work)
    high = ring_end(1.0, body, drive, work)
    free = free and not pressed_at(high, 1.0, body, drive, work)
    low = ring_end(-1.0, body, drive, work)
    free = free and not pressed_at(low, -1.0, body, drive, work)
    if low > high or (free and not passed(low, high, body, drive, work)):
        return low, high
    far = quarter(body, drive)
    lag, worst = freest(-far, far, body, drive, work)
    _, _, i, g = worst_at(lag, body, drive, work)
    exact, longest = drive.gi[g, EXACT] != 0, dead(g, drive) / NO_TURN
    if worst > rounding(i, g, lag, drive):
        return lag + worst / longest, lag - worst / longest
    if not exact:
        return low, high
    low = first_touch(lag, -far, body, drive, work)
    return low, first_touch(lag, far, body, drive, work)


def slack(g: int, drive: Drive, work: Work) -> tuple[float, float]:
    """Least and largest free lag of the output on a disc's pins; least above largest if pressed."""
    gi, w, low, high = drive.gi, work.w, -math.inf, math.inf
    exact, radius = gi[g, EXACT] != 0, drive.gf[g, CIRCLE]
    kept, work.q[gi[g, TURN]] = work.q[gi[g, TURN]], 0.0
    at = pose(g, drive, work)
    for i in range(gi[g, START], gi[g, STOP]):
        touch(i, g, at, drive, work)
        d, lever, room = w[i, DELTA], w[i, LEVER], drive.gf[g, ECC] + drive.cf[i, GAP]
        if not exact:
            if abs(lever) <= NO_LEVER * radius:
                if d > NO_LEVER * radius:
                    low, high = math.inf, -math.inf
            elif lever > 0:
                high = min(high, -d / lever)
            else:
                low = max(low, -d / lever)
            continue
        # Tangents t of half the lags solve ``a*t^2 + 2*v*t + q = 0``.
        q, length = d * (2 * room + d), room + d
        x, y, px, py = w[i, NX] * length, w[i, NY] * length, w[i, AX], w[i, AY]
        v = 2 * (x * py - y * px)
        a = max(q - 4 * (x * px + y * py - px * px - py * py), TINY)
        square = v * v - a * q
        if square < 0:
            low, high = math.inf, -math.inf
            continue
        root = math.sqrt(square)
        if v >= 0:
            low = max(low, -(v + root) / a)
            high = min(high, -q / (v + root) if v + root > 0 else 0.0)
        else:
            low, high = max(low, q / (root - v)), min(high, (root - v) / a)
    work.q[gi[g, TURN]] = kept
    return (2 * math.atan(low), 2 * math.atan(high)) if exact else (low, high)


def unturned(kind: int, body: int, drive: Drive, work: Work) -> tuple[float, float, float]:
    """Torque of pins about a disc's centre, its derivative, and the sum of its terms' sizes."""
    gi, w, torque, slope, gross = drive.gi, work.w, 0.0, 0.0, 0.0
    for g in range(len(gi)):
        if gi[g, OWN] != body or (gi[g, KIND] == PIN) != (kind == PIN):
            continue
        at = pose(g, drive, work)
        for i in range(gi[g, START], gi[g, STOP]):
            touch(i, g, at, drive, work)
            if w[i, DELTA] <= TINY:
                continue
            f, k = law(i, g, 0.0, drive, w)
            _, by_own = slopes(i, g, drive, work)
            lever, across = work.grad[i, 1], work.side[1]
            torque += f * lever if kind != PIN else -f * lever
            gross += f * abs(lever)
            slope += k * lever * lever + f * (w[i, BOW] * across * across + by_own)
    return torque, slope, gross


def rest(kind: int, slot: int, body: int, drive: Drive, work: Work) -> float:
    """Displacement of a slot at which the pins that press a disc exert no torque on it."""
    lag, low, high, far = 0.0, -math.inf, math.inf, FAR_LAG
    for step in range(1, HALVINGS):
        work.q[slot] = lag
        torque, slope, gross = unturned(kind, body, drive, work)
        if abs(torque) <= EPS * gross:
            break
        if torque > 0:
            high = lag
        else:
            low = lag
        change = -torque / slope if slope > 0 else (-far if torque > 0 else far)
        following = lag + min(max(change, -far), far)
        outside = not low < following < high or step % 8 == 7
        if outside and low > -math.inf and high < math.inf:
            following = (low + high) / 2
        if following in (lag, low, high):
            break
        lag = following
    return lag


def drives(g: int, way: float, drive: Drive, work: Work) -> bool:
    """True if a contact of a group can carry a torque in the direction 1 or -1."""
    w, exact, at = work.w, drive.gi[g, EXACT] != 0, pose(g, drive, work)
    for i in range(drive.gi[g, START], drive.gi[g, STOP]):
        lever = w[i, LEVER]
        if exact:
            touch(i, g, at, drive, work)
            lever = w[i, NX] * w[i, AY] - w[i, NY] * w[i, AX]
        if way * lever > NO_LEVER * drive.gf[g, CIRCLE]:
            return True
    return False


def ring_plays(way: float, drive: Drive, work: Work) -> tuple[bool, bool]:
    """Set plays and first touches in the ring; tell if pins press, and if a torque is carried."""
    gi, q, play, last, pressed, carries = drive.gi, work.q, work.play, -1, False, True
    series = gi[0, KIND] == PIN
    for g in range(len(gi)):
        body = gi[g, OWN]
        if gi[g, KIND] != LOBE or body == last:
            continue
        last, q[body] = body, 0.0
        least, most = ring_play(body, drive, work)
        q[body] = most if way > 0 else least
        if least > most + LEAST_PLAY:
            pressed, q[body] = True, 0.0
            if series:
                least = most = q[body] = rest(LOBE, body, body, drive, work)
        carries = carries and abs(q[body]) < math.inf
        play[body, 0], play[body, 1] = least, most
    return pressed, carries


def pin_play(g: int, drive: Drive, work: Work) -> tuple[float, float, bool]:
    """Least and largest free lag of the output over a disc's own play; True if pins press."""
    gi, q, play, pressed = drive.gi, work.q, work.play, False
    body, low, high = gi[g, OWN], 0.0, 0.0
    if body < 0 or drive.kgg[body, body] > 0:  # held where it is
        low, high = slack(g, drive, work)
        return low, high, low > high + LEAST_PLAY
    kept = q[body]
    for end in range(2):
        q[body] = play[body, end]
        least, most = slack(g, drive, work)
        if least > most + LEAST_PLAY:
            pressed = True
            least = most = rest(PIN, gi[g, TURN], body, drive, work)
        if end == 0:
            low = least
        else:
            high = most
    q[body] = kept
    return low, high, pressed


def first_lag(way: float, low: float, high: float) -> float:
    """End of a play that a torque closes; its middle if pins press without load."""
    if low > high + LEAST_PLAY:
        return (low + high) / 2 if abs(low) < 1 and abs(high) < 1 else 0.0
    return high if way > 0 else low


def straighten(work: Work) -> None:
    """Set the bending of pins and all contact forces to 0."""
    for i in range(len(work.w)):
        work.w[i, FORCE] = 0.0
    for m in range(work.b.shape[0]):
        for i in range(work.b.shape[1]):
            work.b[m, i] = 0.0


def pushing(approach: float, drive: Drive, work: Work) -> float:
    """Force of the first contact at an approach, N."""
    work.w[0, DELTA] = approach
    return law(0, 0, 0.0, drive, work.w)[0]


def adrift(
    way: float, low: float, high: float, drive: Drive, work: Work
) -> tuple[float, float, bool]:
    """Least and largest free lag of the output if discs float; True if parts press unloaded."""
    gi, q, ends, most, wide = drive.gi, work.q, (low, high), 0.0, afloat(drive)
    # Next to no torque finds both ends, which are no closer than with discs in the middle of their
    # bearings; displacements are left at the end that the torque closes.
    for side in (-way, way):
        for i in range(len(q)):
            q[i] = 0.0
        for g in range(len(gi)):
            if gi[g, KIND] == LOBE:
                q[gi[g, OWN]] = work.play[gi[g, OWN], 1 if side > 0 else 0]
        q[0] = first_lag(side, ends[0], ends[1])
        straighten(work)
        for part in NEXT_TO_NONE:
            force = pushing(part * wide, drive, work)
            solve(side * force * drive.gf[0, CIRCLE], REACH, drive, work)
        for i in range(len(work.w)):
            most = max(most, work.w[i, FORCE])
        if side > 0:
            high = max(q[0], ends[1])
        else:
            low = min(q[0], ends[0])
    return low, high, most > pushing(PRESSES * wide, drive, work)


def placed(way: float, whole: bool, drive: Drive, work: Work, row: Row) -> None:
    """Set plays and status of a position, and displacements to the first contact of each stage."""
    gi, q, play = drive.gi, work.q, work.play
    for i in range(len(q)):
        q[i] = 0.0
    pressed, carries = ring_plays(way, drive, work)
    ringed = gi[0, KIND] == LOBE
    mean = ringed or drive.share[0] < 1  # each disc has a lag of its own
    low, high = (0.0, 0.0) if mean else (-math.inf, math.inf)
    if ringed:
        for i in range(len(q)):
            low, high = low + drive.share[i] * play[i, 0], high + drive.share[i] * play[i, 1]
    driven = ringed
    for g in range(len(gi)):
        turn = gi[g, TURN]
        if gi[g, KIND] != PIN:
            continue
        least, most, presses = pin_play(g, drive, work)
        pressed = pressed or presses
        if mean:
            q[turn] = first_lag(way, least, most)
            carries = carries and drives(g, way, drive, work)
            low, high = low + drive.share[turn] * least, high + drive.share[turn] * most
        else:
            low, high = max(low, least), min(high, most)
            q[0] = first_lag(way, low, high)
    for g in range(len(gi)):
        driven = driven or (gi[g, TURN] >= 0 and drives(g, way, drive, work))
    for i in range(len(q)):
        carries = carries and driven and abs(q[i]) < math.inf
    pressed = pressed or low > high + LEAST_PLAY
    if pressed and mean and len(q) > 1:
        low, high = math.inf, -math.inf
    # Discs that float otherwise stay in the middle of their bearings.
    if whole and carries and afloat(drive) > 0:
        low, high, presses = adrift(way, low, high, drive, work)
        pressed = pressed and presses
    if way < 0:
        low, high = -high, -low
    row[LOW], row[HIGH], row[PRESSED], row[PLAY] = (
        low,
        high,
        1.0 if pressed else 0.0,
        max(high - low, 0.0),
    )
    row[STATUS] = SOLVED if carries else NO_DRIVE


def middle(g: int, drive: Drive, work: Work) -> float:
    """Middle of the lags at which a disc without force is free of ring and output pins."""
    body, lag = drive.gi[g, OWN], work.q[drive.gi[g, TURN]]
    low, high = least, most = work.play[body, 0], work.play[body, 1]
    for _ in range(MIDDLES):
        before_low, before_high = low, high
        work.q[body] = low
        low = max(least, lag - (slack(g, drive, work)[1] - low))
        work.q[body] = high
        high = min(most, lag - (slack(g, drive, work)[0] - high))
        if low == before_low and high == before_high:
            break
    return float((low + high) / 2)


def stiffness(drive: Drive, work: Work) -> float:
    """Torsional stiffness at the equilibrium of `solve`, N*m/rad; 0 if it is not stable."""
    held(drive, work)
    for i in range(len(work.q)):
        work.rg[i] = -drive.share[i]
    for m in range(work.rb.shape[0]):
        for i in range(work.rb.shape[1]):
            work.rb[m, i] = 0.0
    if not direction(0.0, drive, work):
        return 0.0
    gives = 0.0
    for i in range(len(work.q)):
        gives += drive.share[i] * work.p[i]
    return 1 / gives


def lag_of(drive: Drive, q: Row) -> float:
    """Lag of the output, or mean of the lags of discs by their shares of the torque."""
    found = 0.0
    for i in range(len(q)):
        found += drive.share[i] * q[i]
    return found


def judged(count: int, drive: Drive, work: Work, row: Row) -> int:
    """Status of a position after `solve`: SOLVED, NOT_STABLE or TOO_WIDE."""
    gi, gf, w = drive.gi, drive.gf, work.w
    if abs(row[LAG]) > 1 or row[STIFFNESS] <= 0 or count < 0:
        return NOT_STABLE
    for g in range(len(gi)):
        for i in range(gi[g, START], gi[g, STOP]):
            if w[i, FORCE] > w[i, MOST]:
                return TOO_WIDE
    for g in range(len(gi)):  # beyond half a pitch of its lobes, other pins hold a disc
        if gi[g, KIND] == LOBE and gi[g, EXACT] != 0:
            lag = gf[g, LATE] + moved(gi[g, OWN], work.q)
            if abs(lag) * (gf[g, LOBES] - 1) >= math.pi:
                return NOT_STABLE
    return SOLVED


def wrenches(drive: Drive, work: Work) -> None:
    """Set ``wrench``: forces and torque of each group on its disc after `solve`."""
    gi, gf, w = drive.gi, drive.gf, work.w
    for g in range(len(gi)):
        x = y = torque = 0.0
        way = -1.0 if gi[g, KIND] <= PIN else 1.0
        c = s = 1.0
        if gi[g, KIND] > PIN:
            own = gf[g, LATE] + moved(gi[g, OWN], work.q) if gi[g, EXACT] != 0 else 0.0
            c, s = math.cos(own), math.sin(own)
        for i in range(gi[g, START], gi[g, STOP]):
            f = w[i, FORCE]
            if f <= 0:
                continue
            ca, sa, nx, ny = w[i, CA], w[i, SA], w[i, NX], w[i, NY]
            along, across = nx * ca - ny * sa, nx * sa + ny * ca  # in the crank's frame
            if gi[g, KIND] > PIN:
                along, across = along * c + across * s, across * c - along * s
            x -= f * along
            y += f * across
            torque += f * (w[i, NY] * w[i, HX] - w[i, NX] * w[i, HY])
        work.wrench[g, 0], work.wrench[g, 1], work.wrench[g, 2] = x, y, way * torque


def turning_lobe(i: int, g: int, drive: Drive, work: Work) -> float:
    """Derivative of a lobe's approach by the crank angle at held lags, in first order."""
    gf, cf, w, ca, sa = drive.gf, drive.cf, work.w, work.w[i, CA], -work.w[i, SA]
    e, k, slope = gf[g, BASE_E], gf[g, SHORT], w[i, SLOPE]
    own, ta, tc = disc_at(g, work.q, drive)
    ta += gf[g, OFF]
    tx, ty = sa, -ca  # derivative of the crank's direction
    px, py = gf[g, CIRCLE] - e * ca, -e * sa
    dx = cf[i, EX] - ta * ca + tc * sa - own * py
    dy = cf[i, EY] - ta * sa - tc * ca + own * px
    gx, gy, hx, hy = 1 - k * ca, -k * sa, -k * tx, -k * ty
    mx, my = -ta * tx - tc * ca + own * e * ty, -ta * ty - tc * sa - own * e * tx
    grown = (gx * hx + gy * hy) / slope
    over, turn = gx * dx + gy * dy, hx * dx + hy * dy + gx * mx + gy * my
    lever = gf[g, BASE_E] * (gf[g, LOBES] - 1) * (ca - w[i, SA] * grown / slope) / slope
    opens = -gf[g, ROTATION] * (lever if w[i, SA] > 0 else -lever)
    return float(opens - turn / slope + over * grown / (slope * slope))


def on_crank(torque: float, drive: Drive, work: Work) -> float:
    """Torque that turns the crank without friction, N*m, after `wrenches`."""
    gi, gf, w, total = drive.gi, drive.gf, work.w, 0.0
    exact, ratio = gi[0, EXACT] != 0, gf[0, RATIO]
    series = gi[0, KIND] == PIN and gi[len(gi) - 1, KIND] > PIN
    # In first order the terms are torque/ratio and forces times derivatives of approaches by the
    # crank angle, in exact geometry forces on discs times the arms of their cranks. Without a ring
    # a pure torque turns each disc, and a part of it acts on the crank.
    for g in range(len(gi)):
        pins = gi[g, KIND] == PIN
        if gi[g, KIND] == JOURNAL:  # bearings pass on the forces of the other groups
            continue
        _, along, across = disc_at(g, work.q, drive)
        if exact:
            turns = work.wrench[g, 1] * (gf[g, ECC] + along) + work.wrench[g, 0] * across
            total += turns * (1.0 if series or not pins else 1 + 1 / ratio)
            continue
        for i in range(gi[g, START], gi[g, STOP]):
            if w[i, FORCE] <= 0:
                continue
            if pins:
                ca, sa = w[i, CA], -w[i, SA]
                lag = moved(gi[g, TURN], work.q) - moved(gi[g, OWN], work.q) - gf[g, LATE]
                bx, by = bent(i, work.b, drive)
                sx, sy = drive.cf[i, EX] + bx, drive.cf[i, EY] + by - lag * gf[g, CIRCLE]
                total += (1 + 1 / ratio) * w[i, FORCE] * (ca * sy - sa * sx)
            else:
                total += w[i, FORCE] * turning_lobe(i, g, drive, work)
    if exact and (series or gi[0, KIND] != PIN):
        return total
    return float(total + torque / ratio)


def pressing(g: int, i: int, drive: Drive, w: Table) -> float:
    """Force over reduced radius of a contact; times its `excess` if the contact is conformal."""
    table, found = drive.table, w[i, FORCE] * w[i, BENT]
    if drive.gi[g, KIND] == PIN:
        at = 3 + int(table[2])
        most = table[at] * (drive.gf[g, BASE_E] + drive.cf[i, WIDER])
        if w[i, FORCE] > table[at + 1] * most:
            found *= excess(w[i, FORCE] / most, table)
    return float(found)


def measure(torque: float, drive: Drive, work: Work, row: Row) -> None:
    """Set the read-outs of a position after `solve`."""
    gi, w = drive.gi, work.w
    for k in range(PIN_FORCE, LOST):
        row[k] = 0.0
    wrenches(drive, work)
    row[INPUT_TORQUE] = on_crank(torque, drive, work)
    row[ALONG_MOST], row[ALONG_LEAST] = -math.inf, math.inf
    for g in range(len(gi)):
        kind = gi[g, KIND]
        at = PIN_FORCE if kind == PIN else LOBE_FORCE
        for i in range(gi[g, START], gi[g, STOP]):
            f = w[i, FORCE]
            if f <= 0 or kind in (FLANK, JOURNAL):
                continue
            pressed = pressing(g, i, drive, w)
            row[at], row[at + 1] = max(row[at], f), max(row[at + 1], pressed)
            row[at + 2] += 1
            if kind == LOBE:
                row[RUB] = max(row[RUB], w[i, SLIDE] * f)
                row[RUB_PRESSED] = max(row[RUB_PRESSED], w[i, SLIDE] * math.sqrt(pressed))
        if kind == LOBE:
            along = work.wrench[g, 0]
            for other in range(g + 1, len(gi)):  # second feet of this group
                if gi[other, KIND] == FLANK and gi[other, OF] == g:
                    along += work.wrench[other, 0]
            row[ALONG_MOST] = max(row[ALONG_MOST], along)
            row[ALONG_LEAST] = min(row[ALONG_LEAST], along)


def without_force(body: int, top: float, drive: Drive, work: Work) -> bool:
    """True if nothing presses a disc; its forces, which are rounding, become 0."""
    gi, w = drive.gi, work.w
    for g in range(len(gi)):
        for i in range(gi[g, START], gi[g, STOP]):
            if gi[g, OWN] == body and w[i, FORCE] > NOTHING * top:
                return False
    for g in range(len(gi)):
        for i in range(gi[g, START], gi[g, STOP]):
            if gi[g, OWN] == body:
                w[i, FORCE] = 0.0
    return True


def loose_discs(play: bool, drive: Drive, work: Work) -> None:
    """Put discs that carry nothing into the middle of their play."""
    gi, w, top = drive.gi, work.w, 0.0
    for i in range(len(w)):
        top = max(top, w[i, FORCE])
    for g in range(len(gi)):
        body = gi[g, OWN]
        if gi[g, KIND] != PIN or body < 0 or drive.kgg[body, body] > 0:
            continue
        if without_force(body, top, drive, work):
            if not play:
                work.play[body, 0], work.play[body, 1] = ring_play(body, drive, work)
            work.q[body] = work.first[body] = middle(g, drive, work)


def take(given: Row, into: Row) -> None:
    """Copy displacements."""
    for i in range(len(given)):
        into[i] = given[i]


def take_side(sides: Table, side: int, q: Row, kept: bool) -> None:
    """Keep or restore the displacements under a torque in one of two directions."""
    for i in range(len(q)):
        if kept:
            sides[side, i] = q[i]
        else:
            q[i] = sides[side, i]


def take_bends(given: Table, into: Table) -> None:
    """Copy the bending of pins."""
    for m in range(given.shape[0]):
        for i in range(given.shape[1]):
            into[m, i] = given[m, i]


def bend_on(part: float, work: Work) -> None:
    """Extrapolate the bending of pins by a multiple of its last change."""
    for m in range(work.b.shape[0]):
        for i in range(work.b.shape[1]):
            work.b[m, i] += part * (work.last[m, i] - work.older[m, i])


def position(
    phi: float, torque: float, warm: bool, far: bool, play: bool, drive: Drive, work: Work, row: Row
) -> int:
    """Solve a crank angle and, if asked, its play; return the status. A warm start is from
    ``work``; with a play or pins that bend, one ``far`` away is as far beyond the first contact as
    at the last position, with straight pins.
    """
    place(phi, drive, work)
    way, q, kept = math.copysign(1.0, torque), work.q, work.kept
    straight = warm and far and len(work.b) > 0
    row[STATUS] = SOLVED
    for again in range(2):
        if play or not warm or straight:
            take(q, kept)
            take_bends(work.b, work.bends)
            straighten(work)
            placed(way, play or again > 0, drive, work, row)
            for i in range(len(q)):
                kept[i] += q[i] - work.first[i] if far else 0.0
            take(q, work.first)
            if warm:
                take(kept, q)
                if not straight:
                    take_bends(work.bends, work.b)
            if row[STATUS] != SOLVED:
                return NO_DRIVE
        count = solve(torque, FURTHEST if straight else REACH, drive, work)
        if count > 0:
            break
        warm = straight = False
    row[STEPS], row[LAG] = abs(count), way * lag_of(drive, q)
    row[STIFFNESS] = stiffness(drive, work)
    status = judged(count, drive, work, row)
    row[STATUS] = status
    loose_discs(play, drive, work)
    measure(torque, drive, work, row)
    return status


def record(
    m: int, drive: Drive, work: Work, lags: Table, forces: Table, wrench: Block, plays: Block
) -> None:
    """Store lags, forces, wrenches and plays of a position in the row m."""
    for i in range(len(work.q)):
        lags[m, i] = work.q[i]
        plays[m, i, 0], plays[m, i, 1] = work.play[i, 0], work.play[i, 1]
    for i in range(forces.shape[1]):
        forces[m, i] = work.w[i, FORCE]
    for g in range(len(drive.gi)):
        for k in range(3):
            wrench[m, g, k] = work.wrench[g, k]


def positions(
    places: Row,
    torque: float,
    play: bool,
    drive: Drive,
    work: Work,
    rows: Table,
    lags: Table,
    forces: Table,
    wrench: Block,
    plays: Block,
) -> int:
    """Solve crank angles, each from the two before; return the first index not solved, or -1."""
    for m in range(len(places)):
        far = m > 0
        if m > 1:
            ahead, wide = places[m] - places[m - 1], places[m - 1] - places[m - 2]
            far = not 0 < abs(ahead) <= min(2 * abs(wide), AHEAD)
            if not far:
                for i in range(len(work.q)):
                    work.q[i] += ahead / wide * (lags[m - 1, i] - lags[m - 2, i])
                bend_on(ahead / wide, work)
        status = position(places[m], torque, m > 0, far, play, drive, work, rows[m])
        if status != SOLVED:
            return m
        record(m, drive, work, lags, forces, wrench, plays)
        take_bends(work.last, work.older)
        take_bends(work.b, work.last)
    return -1


def unloaded(
    places: Row, way: float, least: bool, drive: Drive, work: Work, rows: Table, plays: Block
) -> None:
    """Set the play at crank angles, and with ``least`` INTERFERENCE of a ring alone."""
    straighten(work)
    for m in range(len(places)):
        place(places[m], drive, work)
        placed(way, True, drive, work, rows[m])
        rows[m, INTERFERENCE] = -math.inf
        for body in range(len(work.q)):
            plays[m, body, 0], plays[m, body, 1] = work.play[body, 0], work.play[body, 1]
            if least:
                far = quarter(body, drive)
                worst = freest(-far, far, body, drive, work)[1]
                rows[m, INTERFERENCE] = max(rows[m, INTERFERENCE], worst)


def gaps(phi: float, lags: Row, drive: Drive, work: Work, found: Row) -> None:
    """Set the approaches of all ring pins, m, at a crank angle and lags of their discs."""
    gi, w = drive.gi, work.w
    take(lags, work.q)
    place(phi, drive, work)
    for g in range(len(gi)):
        if gi[g, KIND] != LOBE:
            continue
        at = pose(g, drive, work)
        for i in range(gi[g, START], gi[g, STOP]):
            touch(i, g, at, drive, work)
            if gi[g, EXACT] != 0:
                foot_of(i, g, drive, w)
            found[i] = w[i, DELTA]


def enter(there: float, found: float, x: Row, y: Row) -> None:
    """Take in a place and its height among five places, whose middle one is the highest."""
    highest = found > y[2]
    side = 1 if (there < x[2]) != highest else 3
    x[2 * side - 2], y[2 * side - 2] = x[side], y[side]
    if highest:
        x[side], y[side] = x[2], y[2]
        side = 2
    x[side], y[side] = there, found


def tip(
    low: float, at_low: float, up: float, high: float, at_high: float, down: float
) -> tuple[float, float]:
    """Place and height where lines through two places meet, of slopes `up` and `down`; the higher
    place if one is below the other over the gap, and NaN twice where there is a jump.
    """
    gap = high - low
    ahead, behind = at_low + up * gap - at_high, at_high - down * gap - at_low
    if min(ahead, behind) < -abs(at_high - at_low) / 2:
        return math.nan, math.nan
    if ahead <= 0 or behind <= 0:
        return (low, at_low) if at_low > at_high else (high, at_high)
    off = behind / (up - down)
    return low + off, at_low + up * off


def summit(x: Row, y: Row) -> tuple[float, float]:
    """Place and height of the summit that five places and their heights suggest, as `tip`.

    A smooth summit is that of the parabola through the three highest places. Most summits are where
    a pair takes up or leaves, and the lines through two places on either side meet, in the gap from
    which the slope changes less farther on.
    """
    a, b = (y[1] - y[0]) / (x[1] - x[0]), (y[2] - y[1]) / (x[2] - x[1])
    c, d = (y[3] - y[2]) / (x[3] - x[2]), (y[4] - y[3]) / (x[4] - x[3])
    before, bend, after = (b - a) / (x[2] - x[0]), (c - b) / (x[3] - x[1]), (d - c) / (x[4] - x[2])
    if max(before, bend, after) < min(before, bend, after) / BENT_ALIKE:
        steep = b + bend * (x[2] - x[1])
        return x[2] - steep / (2 * bend), y[2] - steep**2 / (4 * bend)
    if abs(d - c) < abs(b - a):
        return tip(x[1], y[1], a, x[2], y[2], c)
    return tip(x[2], y[2], b, x[3], y[3], d)


def narrow(
    kind: int,
    sign: int,
    x: Row,
    y: Row,
    known: float,
    at: float,
    torque: float,
    share: float,
    drive: Drive,
    work: Work,
    row: Row,
) -> tuple[float, float, float, int]:
    """Place and height of a read-out's largest value about the middle one of five places, an error
    of the height, and the number of places tried: -1 if the place returned has no equilibrium. For
    ``sign`` -1 it is the least value.

    `x` are the places and `y` their heights, times the sign; both are overwritten. The search also
    ends where it closes in on a summit of height `known` at the place `at`; NaN if there is none.

    The place tried next is that of `summit`, or as far beyond it if it is near the best place.
    Where nothing higher is expected, it is so close to the best that the height falls little.
    Golden section serves at jumps, and where heights are not as expected.
    """
    play, looks, expected, off = kind in (LOW, HIGH, PLAY), 0, True, math.inf
    while True:
        side = 1 if y[1] < y[3] else 3
        near, fall = FLAT * abs(y[2]), y[2] - y[side]
        met = x[1] < at < x[3] and y[2] <= known and x[3] - x[1] < MET
        if met or not (fall > near and x[3] - x[1] > PLACE and looks < HALVINGS):
            return x[2], sign * y[2], fall, looks
        there, height = summit(x, y)
        gap = (x[3] if there > x[2] else x[1]) - x[2]
        closing, beyond = height <= y[2] + near / 2, abs(there - x[2]) < BESIDE * abs(gap)
        guessed = expected and (closing or abs(there - x[2]) > 0)
        if not guessed:
            wider = 3 if x[3] - x[2] > x[2] - x[1] else 1
            there = x[2] + (1 - GOLDEN) * (x[wider] - x[2])
        elif closing:
            part = near / (2 * fall) if fall < CLOSE_BY * near else math.sqrt(near / fall)
            there = x[2] + part * (x[side] - x[2])
        elif beyond:
            there += there - x[2]
        found = 0.0
        if play:
            place(there, drive, work)
            straighten(work)
            placed(math.copysign(1.0, torque), True, drive, work, row)
            found = sign * row[kind]
        for side in range(0 if play else (2 if kind == LOST else 1)):
            asked = torque if kind != LOST else share * torque * (1.0 - 2.0 * side)
            take_side(work.sides, side, work.q, False)
            if position(there, asked, looks > 0, False, False, drive, work, row) != SOLVED:
                return there, 0.0, 0.0, -1
            take_side(work.sides, side, work.q, True)
            found += sign * (row[LAG] if kind == LOST else row[kind])
        looks += 1
        if not guessed or closing:
            expected, off = not guessed or found <= y[2], math.inf
        elif not beyond:
            expected, off = abs(found - height) <= off, abs(found - height)
        enter(there, found, x, y)


def free_there(drive: Drive, work: Work) -> bool:
    """True if nothing touches at the displacements q and b, at the angle of `place`."""
    gi, w = drive.gi, work.w
    for g in range(len(gi)):
        at = pose(g, drive, work)
        for i in range(gi[g, START], gi[g, STOP]):
            touch(i, g, at, drive, work)
            if w[i, DELTA] > 0:
                return False
    return True


def free_everywhere(drive: Drive) -> bool:
    """True if errors are smaller than gaps, so that nothing touches at any angle without load."""
    gi, gf, cf = drive.gi, drive.gf, drive.cf
    for g in range(len(gi)):
        off, late = abs(gf[g, OFF]), abs(gf[g, LATE])
        for i in range(gi[g, START], gi[g, STOP]):
            arm = math.hypot(cf[i, PX], cf[i, PY]) + abs(gf[g, ECC])
            error = math.hypot(cf[i, EX], cf[i, EY]) + off + late * arm
            gap = cf[i, GAP] if gi[g, KIND] <= PIN else -cf[i, GAP]
            if error >= gap or gf[g, ROTATION] < 0:
                return False
    return True


def between(drive: Drive, work: Work, row: Row) -> None:
    """Put output and discs into the middle of their plays after `placed`."""
    gi, q = drive.gi, work.q
    q[0] = (row[LOW] + row[HIGH]) / 2
    for g in range(len(gi)):
        if gi[g, KIND] != PIN:
            continue
        if drive.share[gi[g, TURN]] < 1:  # each disc has a lag of its own
            low, high = slack(g, drive, work)
            q[gi[g, TURN]] = (low + high) / 2
        elif gi[g, OWN] >= 0 and drive.kgg[gi[g, OWN], gi[g, OWN]] == 0:
            q[gi[g, OWN]] = middle(g, drive, work)


def goes_together(places: Row, drive: Drive, work: Work, row: Row) -> int:
    """FITS, BINDS or NOWHERE, by the places at which a piece goes together without load."""
    free = blocked = False
    if free_everywhere(drive):
        return FITS
    for i in range(len(work.q)):
        work.q[i] = 0.0
    straighten(work)
    for m in range(len(places)):
        place(places[m], drive, work)
        if free_there(drive, work):  # a lag that is free at one place mostly is at the next one
            free = True
            continue
        placed(1.0, False, drive, work, row)
        if row[PRESSED] > 0 and afloat(drive) > 0:
            placed(1.0, True, drive, work, row)
        if row[PRESSED] > 0:
            blocked = True
        else:
            free = True
            between(drive, work, row)
        if free and blocked:
            return BINDS
    return FITS if free else NOWHERE


# Most studies have rigid discs held by their cranks, exact geometry and one lag of the output: a
# scalar loop solves them. P is the centre of a pin, eps its offset from that of its hole, w the
# direction of the crank times ``-2*e``, C the distance of both centres in contact. Then
# ``|d|^2 - C^2 = q + (cos(lag) - 1)*u + sin(lag)*v``, in which q, u and v are linear in w.

RX, RY, OX, OY, K0, K1, K2, ROOM, SIZE, Q, U, V, PUSH, ARM, HARD = range(15)
"""Floats of a pair: P, eps, constants of q, u and v, the distance C, size of the terms of q; q, u
and v of a position; force, lever and stiffness of the contact."""

PEAK, PRESSURE, TRANSMISSION, BACKLASH, MOTION, SOFTEST = range(6)
"""Quantities of a piece over the turn; PRESSURE is the largest result of `pressing`."""

FIT_POSITIONS = 720
"""Number of positions at which `fitting` looks. The least room over the turn is a smooth minimum
that these positions miss by at most 1e-5 of the eccentricity."""

NEARLY = 1e-8
"""Last step of Newton over the lag; a step along the tangents leaves an error of its square."""

JUST = 1e-9
"""Approach over the eccentricity of parts that just fit, whose sizes are rounded."""

SURE = 1e-9
"""Part of their terms by which bounds of the play are wider: a thousand times the rounding."""

NEAR = 1e-3
"""Lever over the longest one below which a pair, near its dead angle, bounds no play."""

ALONE = 20
"""Number of steps of Newton after which every other step bisects the bracket."""


def lay(gf: Table, cf: Table, w: Table) -> None:
    """Set constants of all pairs of a piece; a phase error of a crank also turns its disc."""
    discs = len(gf)
    pins = len(w) // discs
    for j in range(discs):
        e, late = gf[j, ECC], gf[j, LATE]
        half = math.sin(late / 2)
        turn_x, turn_y = -2 * half * half, -math.sin(late)  # exp(-i*late) - 1
        for i in range(j * pins, (j + 1) * pins):
            c, s, gap = cf[i, CB], cf[i, SB], cf[i, GAP]
            px, py = cf[i, PX], cf[i, PY]
            hx, hy = px - cf[i, EX], py - cf[i, EY]
            ex = cf[i, EX] - (turn_x * hx - turn_y * hy)
            ey = cf[i, EY] - (turn_x * hy + turn_y * hx)
            x, y = px * c - py * s, px * s + py * c
            ox, oy = ex * c - ey * s, ex * s + ey * c
            w[i, RX], w[i, RY], w[i, OX], w[i, OY] = x, y, ox, oy
            w[i, K0] = ox * ox + oy * oy - gap * (2 * e + gap)
            w[i, K1] = 2 * (ox * x + oy * y - (x * x + y * y))
            w[i, K2] = 2 * (ox * y - oy * x)
            w[i, ROOM] = e + gap
            off = abs(ex) + abs(ey)
            w[i, SIZE] = (2 * abs(e) + off) * off + abs(gap) * (2 * abs(e) + abs(gap))


def turn_to(psi: float, way: float, gf: Table, w: Table) -> None:
    """Set q, u and v of all pairs at a wave angle; the way -1 reverses v and the lag."""
    pins = len(w) // len(gf)
    for j in range(len(gf)):
        angle = psi + gf[j, PHASE]
        wx, wy = -2 * gf[j, ECC] * math.cos(angle), 2 * gf[j, ECC] * math.sin(angle)
        for i in range(j * pins, (j + 1) * pins):
            x, y = w[i, RX], w[i, RY]
            w[i, Q] = wx * w[i, OX] + wy * w[i, OY] + w[i, K0]
            w[i, U] = wx * x + wy * y + w[i, K1]
            w[i, V] = way * (wx * y - wy * x + w[i, K2])


def window(w: Table) -> tuple[float, float, int]:
    """Least and largest free lag (least above largest if pairs press), and the pair at its end."""
    low, high, onset = -math.inf, math.inf, -1
    for i in range(len(w)):  # tangents t of half the lags solve ``a*t^2 + 2*v*t + q = 0``
        q, v = w[i, Q], w[i, V]
        a = max(q - 2 * w[i, U], TINY)
        square = v * v - a * q
        if square < 0:
            return math.inf, -math.inf, -1
        root = math.sqrt(square)
        if v >= 0:
            first, last = -(v + root) / a, -q / (v + root) if v + root > 0 else 0.0
        else:
            first, last = q / (root - v), (root - v) / a
        low = max(low, first)
        if last < high:
            high, onset = last, i
    return 2 * math.atan(low), 2 * math.atan(high), onset


def count_from(lag: float, onset: int, w: Table) -> None:
    """Count lags from one where only the pair ``onset`` (-1: none) touches: loads keep digits."""
    sine, half = math.sin(lag), math.sin(lag / 2)
    less = -2 * half * half
    for i in range(len(w)):
        q, u, v = w[i, Q], w[i, U], w[i, V]
        q += less * u + sine * v
        w[i, U], w[i, V] = (1 + less) * u + sine * v, (1 + less) * v - sine * u
        w[i, Q] = q if onset < 0 else min(q, 0.0)
    if onset >= 0:
        w[onset, Q] = 0.0


def law_alone(
    kind: int, d: float, i: int, exponent: float, cf: Table, table: Row, w: Table
) -> tuple[float, float]:
    """Force, N, and stiffness, N/m, of pair i by a law, at an approach d > 0, m."""
    if kind == LINEAR:
        return d / cf[i, A], 1 / cf[i, A]
    if kind == HERTZ:
        return line(d, cf[i, A], cf[i, B], 1.0)
    if kind == CONFORMAL:
        return wrapped(d, cf[i, A], cf[i, B], w[i, PUSH], table)
    return power(d, cf[i, A], cf[i, B], exponent)


def torque_at(
    lag: float, kind: int, exponent: float, cf: Table, table: Row, w: Table
) -> tuple[float, float, float]:
    """Torque of all pairs at a lag, its derivative, and the sum of the sizes of its terms."""
    sine, half = math.sin(lag), math.sin(lag / 2)
    less = -2 * half * half
    torque = slope = gross = 0.0
    for i in range(len(w)):
        approach = w[i, Q] + less * w[i, U] + sine * w[i, V]
        if approach <= TINY:
            w[i, PUSH] = w[i, ARM] = w[i, HARD] = 0.0
            continue
        c = w[i, ROOM]
        length = math.sqrt(c * c + approach)
        approach /= length + c
        lever = ((1 + less) * w[i, V] - sine * w[i, U]) / (2 * length)
        bend = (-((1 + less) * w[i, U] + sine * w[i, V]) / 2 - lever * lever) / length
        f, stiff = law_alone(kind, approach, i, exponent, cf, table, w)
        w[i, PUSH], w[i, ARM], w[i, HARD] = f, lever, stiff
        torque += f * lever
        gross += f * abs(lever)
        slope += stiff * lever * lever + f * bend
    return torque, slope, gross


def next_place(x: float, change: float, low: float, high: float, step: int) -> float:
    """Next step of Newton within a bracket, which is bisected where Newton leaves it."""
    following = x + change
    if low < following < high and not (step > ALONE and step % 2):
        return following
    if high == math.inf:
        return x + max(abs(x), 1e-9)
    if low == -math.inf:
        return x - max(abs(x), 1e-9)
    return (low + high) / 2


def first_guess(
    torque: float, kind: int, exponent: float, gf: Table, cf: Table, table: Row, w: Table
) -> float:
    """Lag at which the best placed pair alone carries the torque; infinite if none can."""
    lag = math.inf
    for i in range(len(w)):
        lever = w[i, V] / (2 * w[i, ROOM])
        if lever <= NO_LEVER * gf[0, CIRCLE]:
            continue
        f, approach = torque / lever, 0.0
        if kind == LINEAR:
            approach = cf[i, A] * f
        elif kind == HERTZ:
            approach = f * cf[i, B] * max(cf[i, A] / cf[i, B] - math.log(f), HERTZ_END)
        elif kind == CONFORMAL:
            over, _ = over_width(f / cf[i, A], table)
            approach = f * (over + cf[i, B]) / table[0]
        else:
            approach = (f / cf[i, A]) ** (1 / exponent) + cf[i, B] * f
        lag = min(lag, (approach - w[i, Q] / (2 * w[i, ROOM])) / lever)
    return lag


def carry(
    psi: float,
    torque: float,
    way: float,
    kind: int,
    gf: Table,
    cf: Table,
    table: Row,
    w: Table,
    found: Row,
) -> bool:
    """Solve lag, stiffness and play under a torque > 0, in ``found``; False if there are none."""
    turn_to(psi, way, gf, w)
    low, high, onset = window(w)
    pressed, exponent = low > high + LEAST_PLAY, gf[0, EXPONENT]
    zero = 0.0 if pressed else high
    if abs(zero) == math.inf:
        return False
    count_from(zero, -1 if pressed else onset, w)
    lag = first_guess(torque, kind, exponent, gf, cf, table, w)
    if lag == math.inf:
        return False
    for i in range(len(w)):
        w[i, PUSH] = 0.0
    lag = 0.0 if pressed else lag
    below, above = -math.inf if pressed else 0.0, math.inf
    # ``torque^(1/exponent)`` is nearly straight; the last step of Newton goes along the tangents.
    power, far = 1.0 if pressed else 1 / exponent, gf[0, BASE_E] / gf[0, CIRCLE]
    close = NEARLY if exponent >= 1 else EPS
    slope = change = 0.0
    for step in range(1, HALVINGS):
        carried, slope, gross = torque_at(lag, kind, exponent, cf, table, w)
        if carried > torque:
            above = lag
        else:
            below = lag
        ratio, change = carried / torque, math.inf
        if slope > 0 and power == 1:
            change = (torque - carried) / slope
        elif slope > 0 and ratio > 0:
            change = torque * (ratio ** (1 - power) - ratio) / (power * slope)
        if abs(carried - torque) <= EPS * gross or abs(change) <= close * abs(lag):
            break
        if pressed:  # near its dead angle a pair hardly resists
            change = min(max(change, -far), far)
        following = next_place(lag, change, below, above, step)
        if following in (below, above):
            change = 0.0
            break
        lag = following
    if slope <= 0 or abs(lag) > 1 or not abs(change) < 1:
        return False
    for i in range(len(w)):
        if w[i, PUSH] > 0:
            w[i, PUSH] = max(w[i, PUSH] + w[i, HARD] * w[i, ARM] * change, 0.0)
        if w[i, PUSH] > cf[i, LIMIT]:
            return False
    found[0], found[1], found[2] = zero + lag + change, slope, high - low
    return True


def hardest(gf: Table, cf: Table, table: Row, w: Table) -> tuple[float, float]:
    """Largest force of the pairs, N, and largest force over reduced radius as of `pressing`."""
    most = pressure = 0.0
    at = 3 + int(table[2])
    for i in range(len(w)):
        f = w[i, PUSH]
        pressed, widest = f * cf[i, CURVED], table[at] * (gf[0, BASE_E] + cf[i, WIDER])
        if f > table[at + 1] * widest:
            pressed *= excess(f / widest, table)
        most, pressure = max(most, f), max(pressure, pressed)
    return most, pressure


def clear(lag: float, gf: Table, w: Table) -> float:
    """Wave angle, rad, from that of `turn_to` on, by which no pair can touch at a lag."""
    sine, half = math.sin(lag), math.sin(lag / 2)
    less, far, pins = -2 * half * half, 2 * math.pi, len(w) // len(gf)
    # An approach is ``k + m*cos(psi - psi_0)``: it grows by at most m for each radian, and never
    # touches if ``k + m < 0``.
    for j in range(len(gf)):
        arm = 2 * gf[j, ECC]
        for i in range(j * pins, (j + 1) * pins):
            x, y = w[i, RX], w[i, RY]
            over = w[i, Q] + less * w[i, U] + sine * w[i, V]
            middle = w[i, K0] + less * w[i, K1] + sine * w[i, K2]
            a, b = w[i, OX] + less * x + sine * y, w[i, OY] + less * y - sine * x
            if over >= 0:
                return 0.0
            square = arm * arm * (a * a + b * b)
            if middle * middle > square:
                continue
            most = math.sqrt(square)
            if -over < most * far:
                far = -over / most
    return far


def fitting(gf: Table, w: Table) -> int:
    """FITS, BINDS or NOWHERE, by the positions at which a piece goes together without load."""
    free = blocked = False
    step, k = 2 * math.pi / FIT_POSITIONS, 0
    while k < FIT_POSITIONS and not (free and blocked):
        turn_to(k * step, 1.0, gf, w)
        low, high, _ = window(w)
        if low <= high + JUST * gf[0, BASE_E] / gf[0, CIRCLE]:
            free = True
            if high - low < math.inf:  # no pair can touch up to there at the middle of the play
                k += int(clear((low + high) / 2, gf, w) / step)
        else:
            blocked = True
        k += 1
    if free and blocked:
        return BINDS
    return FITS if free else NOWHERE


def widest(places: Row, gf: Table, w: Table, room: Table) -> float:
    """Largest play over wave angles, rad; 0 if all press."""
    at_most(places, gf, w, room)
    front = room[0]
    most, first = 0.0, 0  # only positions whose bound exceeds the largest play are solved
    for k in range(len(places)):
        if front[k] > front[first]:
            first = k
    for step in range(len(places)):
        k = (first + step) % len(places)
        if front[k] > most:
            turn_to(places[k], 1.0, gf, w)
            low, high, _ = window(w)
            most = max(most, high - low)
    return most


def at_most(places: Row, gf: Table, w: Table, room: Table) -> None:
    """Set upper bounds of the play, rad, where there is any, at wave angles: in ``room[0]``."""
    # With t the tangent of half the lag, a pair is free where ``a*t^2 + 2*v*t + q <= 0``; a
    # difference of lags is at most twice that of their t. For a lever v > 0 the free range ends at
    # ``t = -q/(v + s)``, ``s = sqrt(v^2 - a*q)``, no later than with s = v, as a parabola lies
    # above its tangent. While the pair is open all around, ``-a*q`` is at least m, the product of
    # the least a and the least -q, and s at least the tangent of ``sqrt(v^2 + m)`` at the longest
    # lever: ``v + s >= 2*(c + d*v)``. For v < 0 the range begins there. The play, from the last
    # begin to the first end, is no wider than between any begin and any end. `SURE` covers
    # rounding, which is 1e-12 of the terms.
    pins = len(w) // len(gf)
    front, back, across, along = room[0], room[1], room[2], room[3]
    for k in range(len(places)):
        front[k] = back[k] = math.inf
    for j in range(len(gf)):
        arm = 2 * gf[j, ECC]
        for k in range(len(places)):
            angle = places[k] + gf[j, PHASE]
            across[k], along[k] = -arm * math.cos(angle), arm * math.sin(angle)
        for i in range(j * pins, (j + 1) * pins):
            x, y, ex, ey = w[i, RX], w[i, RY], w[i, OX], w[i, OY]
            reach, open_by = math.sqrt(x * x + y * y), -w[i, K0]
            longest, swing = arm * reach + abs(w[i, K2]), arm * (abs(ex) + abs(ey))
            steep = -2 * w[i, K1] - 2 * arm * reach - open_by - swing
            m = max(steep, 0.0) * max(open_by - swing - SURE * w[i, SIZE], 0.0)
            half = 0.5 / max(math.sqrt(longest * longest + m), TINY)
            c, d = max(m * half, TINY), 0.5 + longest * half
            least, q0 = NEAR * longest * d, SURE * w[i, SIZE] - w[i, K0]
            x, y, k2 = d * x, d * y, d * w[i, K2]
            for k in range(len(places)):
                wx, wy = across[k], along[k]
                v = wx * y - wy * x + k2
                if v > least:
                    front[k] = min(front[k], (q0 - wx * ex - wy * ey) / (c + v))
                elif v < -least:
                    back[k] = min(back[k], (q0 - wx * ex - wy * ey) / (c - v))
    for k in range(len(places)):
        end, begin = front[k], back[k]
        front[k] = end + begin + SURE * (abs(end) + abs(begin))


def piece(
    places: Row,
    torque: float,
    share: float,
    under_load: bool,
    lost: bool,
    kind: int,
    gf: Table,
    cf: Table,
    table: Row,
    w: Table,
    room: Table,
    row: Row,
) -> int:
    """Set the quantities of a piece; return FITS, BINDS or NOWHERE, less 3 if it cannot work."""
    lay(gf, cf, w)
    fits = fitting(gf, w)
    if fits != FITS:
        return fits
    way, size, found = math.copysign(1.0, torque), abs(torque), room[4]
    least, most, stiffness = math.inf, -math.inf, math.inf
    for k in range(6):
        row[k] = 0.0
    if not under_load:
        row[BACKLASH] = widest(places, gf, w, room)
    for k in range(len(places) if under_load or lost else 0):
        if under_load:
            if not carry(places[k], size, way, kind, gf, cf, table, w, found):
                return fits - 3
            peak, pressure = hardest(gf, cf, table, w)
            row[PEAK], row[PRESSURE] = max(row[PEAK], peak), max(row[PRESSURE], pressure)
            least, most = min(least, found[0]), max(most, found[0])
            stiffness = min(stiffness, found[1])
            row[BACKLASH] = max(row[BACKLASH], found[2])
        both = 0.0
        for side in range(2 if lost else 0):
            sign = way * (1.0 - 2.0 * side)
            if not carry(places[k], share * size, sign, kind, gf, cf, table, w, found):
                return fits - 3
            both += found[0]
        row[MOTION] = max(row[MOTION], both)
    row[TRANSMISSION] = most - least if under_load else 0.0
    row[SOFTEST] = stiffness
    return fits


def pieces(
    places: Row,
    torque: float,
    share: float,
    under_load: bool,
    lost: bool,
    kind: int,
    gf: Block,
    cf: Block,
    table: Row,
    w: Table,
    room: Table,
    fits: Row,
    rows: Table,
) -> None:
    """Set the quantities of many pieces in ``rows``, NaN if one cannot work; room: five rows."""
    for s in range(len(gf)):
        given = piece(
            places,
            torque,
            share,
            under_load,
            lost,
            kind,
            gf[s],
            cf[s],
            table,
            w,
            room,
            rows[s],
        )
        fits[s] = given if given >= 0 else given + 3
        if given != FITS:
            for k in range(6):
                rows[s, k] = math.nan
