"""Ring and output mechanism in series: discs that find their own lag between the two.

Unknown are the lag of the output, and the lag of the holes of each disc, both behind their ideal
angle and counted as the torque turns. In its ring a disc is what `core.ring.approach` makes of it,
on the pins of the output what `core.output.sharing_kernel` makes of one satellite that is turned
back: at its lag the wave angle is as much less, and the output lags behind it by the difference.
Of a disc the torque of the ring and that of the pins about its centre are equal; the torque of all
pins on the output is the load. Both are derivatives of the stored energy, so that what the discs
add to the stiffness is eliminated by Schur's complement.

The functions stand for those of the same names of `core.output.sharing_kernel` and keep its rules;
their wave angle is the crank angle.
"""

import math
from typing import Any, NamedTuple

from core.output.sharing_kernel import (
    EPS,
    NO_DRIVE,
    NOT_SOLVED,
    NOT_STABLE,
    RADIAN,
    SOLVED,
    STEPS,
    TOO_FAR,
    TOO_WIDE,
    Pairs,
    Position,
    Room,
    Row,
    Setup,
    at,
    balance,
    play,
    start,
    too_wide,
    touch_error,
    wave_torque,
    within,
)
from core.ring.approach import at as mesh_at
from core.ring.approach import balance as mesh_balance
from core.ring.approach import on_crank as mesh_on_crank
from core.ring.approach import play as mesh_play
from core.ring.approach import shift as mesh_shift
from core.ring.approach import wave_torque as mesh_wave_torque

MIDDLES = 12
"""Steps to where a disc that carries nothing comes to either end of its freedom."""

PRESSED = 0.5
"""Of a row of flags: what is above it is set."""


class SeriesSetup(NamedTuple):
    """What a design is, without its errors."""

    pins: int  # of the output
    satellites: int
    direction: float  # of the torque: 1, or -1 in reverse
    ratio: float
    start: float  # wave angle at the crank angle 0
    mesh: Any  # `MeshSetup` of one disc in its ring
    output: Setup  # of one disc on the pins of the output


class SeriesPairs(NamedTuple):
    """Constants of the pairs, disc by disc."""

    teeth: tuple[Any, ...]  # `MeshPairs`
    holes: tuple[Pairs, ...]


class SeriesRoom(NamedTuple):
    """Results of one position, disc by disc, and what the discs are in it, [K]."""

    teeth: tuple[Any, ...]  # `MeshRoom`
    holes: tuple[Room, ...]
    force: Row  # of all pins of the output, [K*N]
    lag: Row
    moves: Row  # by the lag of the output
    torque: Row  # of the ring about the disc's centre
    error: Row  # of the lag
    low: Row  # play in the ring; where it presses what it leaves without torque, twice
    high: Row
    slack_low: Row  # play on the pins, as far as the output lags behind; likewise
    slack_high: Row
    held: Row  # whether the pins press into a disc without load


class Held(NamedTuple):
    """Pins of the output on a disc: torque on the output, and about the disc's centre; the second
    derivatives of the energy by the lags of output and disc.
    """

    torque: float
    gross: float
    on_disc: float
    by_output: float
    by_both: float
    by_disc: float


class Linked(NamedTuple):
    """A disc between ring and pins, at a lag of the output and its own."""

    torque: float  # on the output
    size: float  # of the terms of its balance
    gross: float
    slope: float  # of the torque on the output, with the disc's balance solved
    value: float  # torque of the ring less that of the pins
    change: float  # step of Newton of its lag, and its derivative by the lag of the output
    moves: float
    weight: float  # torque on the output by what the balance is off
    share: float  # 1 over the slope of the balance


def wave(angle: float, setup: SeriesSetup) -> float:
    """Wave angle of the output mechanism at a crank angle."""
    return angle * (1 + 1 / setup.ratio) + setup.start


def pins_at(
    j: int, psi: float, lag: float, setup: SeriesSetup, pairs: SeriesPairs, room: SeriesRoom
) -> None:
    """The pins of the output about a disc that lags: in first order lines of action are fixed."""
    turned = setup.direction * lag if setup.output.exact else 0.0
    at(psi - turned, setup.output, pairs.holes[j], room.holes[j])


def held(
    j: int,
    psi: float,
    lag: float,
    own: float,
    setup: SeriesSetup,
    pairs: SeriesPairs,
    room: SeriesRoom,
) -> Held:
    """Pins of the output on disc j, by the lags of the output and of the disc.

    With p the pin's centre, q the hole's from that of its disc and d between the centres, all in
    the disc's frame, the approach is ``|d|`` less a length, and its derivative by the disc's lag
    ``-Im(conj(d)*q)/|d|``.
    """
    one, holes, found = setup.output, pairs.holes[j], room.holes[j]
    if one.exact:
        pins_at(j, psi, own, setup, pairs, room)
    behind = lag - own
    torque, slope, gross = balance(behind, one, holes, found)
    if not one.exact:
        return Held(torque, gross, torque, slope, -slope, slope)
    half, way = math.sin(behind / 2), setup.direction
    less, sine = -2 * half * half, way * math.sin(behind)
    angle = psi - way * own + holes.phase[0]
    wx, wy = holes.arm[0] * math.sin(angle) / 2, holes.arm[0] * math.cos(angle) / 2
    on_disc = by_both = by_disc = 0.0
    for i in range(one.pins):
        force, stiffness = found.force[i], found.stiffness[i]
        if force == 0:
            continue
        x, y, ex, ey = holes.x[i], holes.y[i], holes.ex[i], holes.ey[i]
        px, py, qx, qy = (1 + less) * x + sine * y, (1 + less) * y - sine * x, x - ex, y - ey
        dx, dy = ex + wx + less * x + sine * y, ey + wy + less * y - sine * x
        length, lever = math.sqrt(dx * dx + dy * dy), way * found.lever[i]
        arm = (dx * qy - dy * qx) / length
        on_disc += force * way * arm
        by_both += (force * (lever * arm - px * qx - py * qy)) / length - stiffness * lever * arm
        bend = (qx * qx + qy * qy + dx * qx + dy * qy - arm * arm) / length
        by_disc += stiffness * arm * arm + force * bend
    return Held(torque, gross, on_disc, slope, by_both, by_disc)


def linked(
    j: int,
    psi: float,
    lag: float,
    own: float,
    setup: SeriesSetup,
    pairs: SeriesPairs,
    room: SeriesRoom,
) -> Linked:
    """Disc j at a lag of the output and its own; its forces are in the room."""
    on_pins = held(j, psi, lag, own, setup, pairs, room)
    torque, slope, gross = mesh_balance(own, setup.mesh, pairs.teeth[j], room.teeth[j])
    room.torque[j] = torque
    stiff, value = slope + on_pins.by_disc, torque - on_pins.on_disc
    share = 1 / stiff if stiff > 0 else 0.0
    moves = -on_pins.by_both * share
    return Linked(
        on_pins.torque,
        gross + on_pins.gross,
        on_pins.gross,
        on_pins.by_output + on_pins.by_both * moves,
        value,
        -value * share,
        moves,
        moves,
        share,
    )


def rest(
    in_ring: bool,
    j: int,
    psi: float,
    own: float,
    setup: SeriesSetup,
    pairs: SeriesPairs,
    room: SeriesRoom,
) -> float:
    """Lag at which the pins that press a disc turn it neither way: its own in the ring, or by which
    the output is behind it.
    """
    lag, low, high, far = 0.0, -math.inf, math.inf, setup.mesh.eccentricity / setup.mesh.radius
    for step in range(1, STEPS):
        if in_ring:
            torque, slope, gross = mesh_balance(lag, setup.mesh, pairs.teeth[j], room.teeth[j])
        else:
            found = held(j, psi, own + lag, own, setup, pairs, room)
            torque, slope, gross = found.on_disc, found.by_output, found.gross
        if abs(torque) <= EPS * gross:
            break
        if torque > 0:
            high = lag
        else:
            low = lag
        change = -torque / slope if slope > 0 else math.inf
        following = within(lag, min(max(change, -far), far), low, high, step)
        if following in (low, high):
            break
        lag = following
    return lag


def slack(
    side: float,
    j: int,
    psi: float,
    own: float,
    setup: SeriesSetup,
    pairs: SeriesPairs,
    room: SeriesRoom,
) -> tuple[float, float, bool]:
    """How far the output may lag behind disc j on a side at most, its error, and whether its pins
    press, at a lag of the disc.
    """
    turned = setup.direction * own if setup.output.exact else 0.0
    one, holes, found = setup.output, pairs.holes[j], room.holes[j]
    pins_at(j, psi, own, setup, pairs, room)
    low, high, behind, onset = play(one, holes, found)
    error = max(
        touch_error(low, behind, psi - turned, one, holes, found),
        touch_error(high, onset, psi - turned, one, holes, found),
    )
    if low > high + error:
        for i in range(one.pins):
            found.force[i] = 0.0
        return rest(False, j, psi, own, setup, pairs, room), error, True
    return (high if side > 0 else low), error, False


def placed(
    angle: float, setup: SeriesSetup, pairs: SeriesPairs, room: SeriesRoom
) -> tuple[float, float, float, bool]:
    """Least and largest lag of the output at which nothing carries, their error, and whether pins
    press in any stage by itself. The first is larger where pairs press.
    """
    psi, low, high, error, pressed = wave(angle, setup), -math.inf, math.inf, 0.0, False
    one = setup.mesh
    for j in range(setup.satellites):
        teeth, found = pairs.teeth[j], room.teeth[j]
        for i in range(one.pins):
            found.force[i] = 0.0
        mesh_at(angle, one, teeth, found)
        first, last, behind, onset = mesh_play(one, teeth, found)
        off = max(
            touch_error(first, behind, angle, one, teeth, found),
            touch_error(last, onset, angle, one, teeth, found),
        )
        mesh_shift(0.0, -1, one, teeth, found)
        if first > last + off:
            first = last = rest(True, j, psi, 0.0, setup, pairs, room)
            pressed = True
        room.low[j], room.high[j] = first, last
        behind_most, off_high, held_high = slack(1.0, j, psi, last, setup, pairs, room)
        behind_least, off_low, held_low = slack(-1.0, j, psi, first, setup, pairs, room)
        room.slack_low[j], room.slack_high[j] = behind_least, behind_most
        room.held[j] = 1.0 if held_low or held_high else 0.0
        pressed = pressed or held_low or held_high
        low, high = max(low, first + behind_least), min(high, last + behind_most)
        error = max(error, off + max(off_low, off_high))
    return low, high, error, pressed


def middle(
    j: int, psi: float, lag: float, setup: SeriesSetup, pairs: SeriesPairs, room: SeriesRoom
) -> float:
    """Middle of the lags at which disc j, without force, lies between ring and pins."""
    ends = room.low[j], room.high[j]
    low, high = ends
    for _ in range(MIDDLES if setup.output.exact else 1):
        before = low, high
        low = max(ends[0], lag - slack(1.0, j, psi, low, setup, pairs, room)[0])
        high = min(ends[1], lag - slack(-1.0, j, psi, high, setup, pairs, room)[0])
        if before == (low, high):
            break
    return (low + high) / 2


def settled(
    j: int, psi: float, lag: float, setup: SeriesSetup, pairs: SeriesPairs, room: SeriesRoom
) -> tuple[Linked, bool]:
    """Disc j in balance at a lag of the output, and whether it is."""
    own, low, high = room.lag[j], -math.inf, math.inf
    one, done = linked(j, psi, lag, own, setup, pairs, room), False
    for step in range(1, STEPS):
        if one.value == 0 and one.share == 0:  # free
            if room.held[j] < PRESSED:
                own = middle(j, psi, lag, setup, pairs, room)
            done = True
            break
        if abs(one.value) <= EPS * one.size or abs(one.change) <= EPS * abs(own):
            done = True
            break
        if one.value > 0:
            high = own
        else:
            low = own
        following = within(own, one.change if one.share > 0 else math.inf, low, high, step)
        if following in (low, high):
            done = True
            break
        own = following
        one = linked(j, psi, lag, own, setup, pairs, room)
    room.lag[j], room.moves[j] = own, one.moves
    return one, done


def solve(
    psi: float, torque: float, setup: SeriesSetup, pairs: SeriesPairs, room: SeriesRoom
) -> Position:
    """Equilibrium at a crank angle under a torque > 0; forces, levers and the lags of the discs are
    left in the room. Play and lag are those of the output.
    """
    low, high, play_error, pressed = placed(psi, setup, pairs, room)
    over, lag = wave(psi, setup), math.inf
    zero = (low + high) / 2 if low > high else high
    for j in range(setup.satellites):
        for i in range(setup.pins):
            room.holes[j].force[i] = 0.0
        for i in range(setup.mesh.pins):
            room.teeth[j].force[i] = 0.0
        pins_at(j, over, room.high[j], setup, pairs, room)
        in_ring = start(torque, setup.mesh, pairs.teeth[j], room.teeth[j])
        alone = max(in_ring, room.high[j])
        alone += max(start(torque, setup.output, pairs.holes[j], room.holes[j]), room.slack_high[j])
        if alone < lag:
            lag = alone
        room.lag[j] = room.high[j]
    if lag == math.inf or zero == math.inf:
        return Position(0.0, 0.0, low, high, play_error, 0.0, 0.0, NO_DRIVE, 0)
    for j in range(setup.satellites):
        room.lag[j] += max(lag - room.high[j] - room.slack_high[j], 0.0) / 2
    first, last = -math.inf if pressed or low > high else zero, math.inf
    power = 1.0
    if not pressed and low <= high:
        power = 1 / max(setup.mesh.exponent, setup.output.exponent)
    step, status, far = 0, NOT_SOLVED, setup.mesh.eccentricity / setup.mesh.radius
    value = slope = 0.0
    for step in range(1, STEPS):
        carried = size = slope = 0.0
        balanced = True
        for j in range(setup.satellites):
            one, done = settled(j, over, lag, setup, pairs, room)
            balanced = balanced and done
            carried += one.torque - one.weight * one.value
            size += one.gross + abs(one.weight) * one.size
            slope += one.slope
        value = carried - torque
        if value > 0:
            last = lag
        else:
            first = lag
        ratio, change = carried / torque, math.inf
        if slope > 0 and power == 1:
            change = -value / slope
        elif slope > 0 and ratio > 0:
            change = torque * (ratio ** (1 - power) - ratio) / (power * slope)
        if abs(value) <= EPS * size or abs(change) <= EPS * abs(lag):
            status = SOLVED if balanced else NOT_SOLVED
            break
        if pressed:
            change = min(max(change, -far), far)
        following = within(lag, change, first, last, step)
        if following in (first, last):
            status = SOLVED if balanced else NOT_SOLVED
            break
        for j in range(setup.satellites):
            room.lag[j] += room.moves[j] * (following - lag)
        lag = following
    if slope <= 0:
        return Position(lag, slope, low, high, play_error, 0.0, 0.0, NOT_STABLE, step)
    for j in range(setup.satellites):
        for i in range(setup.pins):
            room.force[j * setup.pins + i] = room.holes[j].force[i]
    lag_error, force_error = series_errors(psi, torque, lag, value, setup, pairs, room)
    lag_error += (0.0 if pressed else play_error) + EPS * abs(lag)
    return Position(lag, slope, low, high, play_error, lag_error, force_error, status, step)


def series_errors(
    angle: float,
    torque: float,
    lag: float,
    value: float,
    setup: SeriesSetup,
    pairs: SeriesPairs,
    room: SeriesRoom,
) -> tuple[float, float]:
    """Bounds of the errors of the lag of the output and of all forces, as `solve` left the room: by
    what the balances are off, and by rounding of their terms, of levers and of approaches.
    """
    psi = wave(angle, setup)
    in_ring, on_pins = EPS * (4 + 2 * abs(angle)), EPS * (4 + 2 * abs(psi))
    mesh, output = setup.mesh, setup.output
    off, slope, force_error = abs(value) + 4 * EPS * torque, 0.0, 0.0
    for j in range(setup.satellites):
        own = room.lag[j]
        one = linked(j, psi, lag, own, setup, pairs, room)
        slope += one.slope
        teeth, holes = room.teeth[j], room.holes[j]
        rough, unsure = 4 * EPS * one.size + abs(one.value), 0.0
        for i in range(mesh.pins):
            near = in_ring * (pairs.teeth[j].size[i] + abs(own) * mesh.radius)
            teeth.unsure[i] = near
            rough += in_ring * teeth.force[i] * mesh.radius
            rough += teeth.stiffness[i] * abs(teeth.lever[i]) * near
        for i in range(output.pins):
            twice = 2 * pairs.holes[j].distance[i] if output.exact else 1.0
            near = on_pins * (pairs.holes[j].size[i] / twice + abs(lag - own) * output.radius)
            holes.unsure[i] = near
            unsure += on_pins * holes.force[i] * output.radius
            unsure += holes.stiffness[i] * abs(holes.lever[i]) * near
        room.error[j] = (rough + unsure) * one.share
        off += unsure + 4 * EPS * one.gross + abs(one.weight) * (rough + unsure)
        room.moves[j] = one.moves
    lag_error = off / slope if slope > 0 else math.inf
    for j in range(setup.satellites):
        teeth, holes = room.teeth[j], room.holes[j]
        room.error[j] += abs(room.moves[j]) * lag_error
        for i in range(mesh.pins):
            near = abs(teeth.lever[i]) * room.error[j] + teeth.unsure[i]
            near = teeth.stiffness[i] * near + 8 * EPS * teeth.force[i]
            force_error = max(force_error, near)
        for i in range(output.pins):
            near = abs(holes.lever[i]) * (lag_error + room.error[j]) + holes.unsure[i]
            near = holes.stiffness[i] * near + 8 * EPS * holes.force[i]
            force_error = max(force_error, near)
    return lag_error, force_error


def played(
    psi: float, setup: SeriesSetup, pairs: SeriesPairs, room: SeriesRoom
) -> tuple[float, float]:
    """Limits of the play of the output at a crank angle."""
    low, high, _, _ = placed(psi, setup, pairs, room)
    return low, high


def judged(position: Position, setup: SeriesSetup, pairs: SeriesPairs, room: SeriesRoom) -> int:
    """Whether a position can be, as `solve` left the room: a status."""
    if position.status == NO_DRIVE:
        return NO_DRIVE
    if abs(position.lag) > RADIAN:
        return NOT_STABLE if setup.output.exact else TOO_FAR
    if position.status != SOLVED:
        return position.status
    if not math.isfinite(position.force_error):
        return NOT_SOLVED
    for j in range(setup.satellites):
        if too_wide(pairs.teeth[j], room.teeth[j]) >= 0:
            return TOO_WIDE
        if too_wide(pairs.holes[j], room.holes[j]) >= 0:
            return TOO_WIDE
    return SOLVED


def input_torque(
    psi: float,
    torque: float,
    lag: float,
    setup: SeriesSetup,
    pairs: SeriesPairs,
    room: SeriesRoom,
) -> float:
    """Torque that turns the crank without friction, as `solve` left the room: its part of the load,
    and of each force times the derivative of its approach by the crank angle at those lags.
    """
    over, total = wave(psi, setup), setup.direction * torque / setup.ratio
    for j in range(setup.satellites):
        own = room.lag[j]
        turned = over - (setup.direction * own if setup.output.exact else 0.0)
        total += mesh_wave_torque(psi, own, setup.mesh, pairs.teeth[j], room.teeth[j])
        on_pins = wave_torque(turned, lag - own, setup.output, pairs.holes[j], room.holes[j])
        total += (1 + 1 / setup.ratio) * on_pins
    return total


def on_crank(
    j: int, psi: float, lag: float, setup: SeriesSetup, pairs: SeriesPairs, room: SeriesRoom
) -> tuple[float, float, float, float]:
    """Forces on disc j along its crank, to the axis, and across it, against its turning: of the
    ring, and of the pins of the output, as `solve` left the room.
    """
    along = across = pins_along = pins_across = 0.0
    mesh, output, own = setup.mesh, setup.output, room.lag[j]
    for i in range(mesh.pins):
        force = room.teeth[j].force[i]
        if force > 0:
            x, y = mesh_on_crank(i, 0, mesh, pairs.teeth[j], room.teeth[j])
            along += force * x
            across += force * y
    holes, found, way = pairs.holes[j], room.holes[j], setup.direction
    half = math.sin((lag - own) / 2)
    less, sine = -2 * half * half, way * math.sin(lag - own)
    angle = wave(psi, setup) - way * own + holes.phase[0]
    ux, uy = math.sin(angle), math.cos(angle)
    for i in range(output.pins):
        force = found.force[i]
        if force == 0:
            continue
        if not output.exact:  # all normals along the crank, from the hole to the pin
            pins_along += force
            continue
        x, y = holes.x[i], holes.y[i]
        dx = holes.ex[i] + holes.arm[0] * ux / 2 + less * x + sine * y
        dy = holes.ey[i] + holes.arm[0] * uy / 2 + less * y - sine * x
        length = math.sqrt(dx * dx + dy * dy)
        pins_along -= force * (dx * ux + dy * uy) / length
        pins_across += force * (ux * dy - uy * dx) / length
    return along, across, pins_along, pins_across
