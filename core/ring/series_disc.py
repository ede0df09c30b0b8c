"""One disc between the ring and the pins of the output: rows of both, and its balance at a lag of
the output and its own; rules in `core.output.loop_rows`.
"""

import math
from typing import Any, NamedTuple

from core.output.contact_kernel import within
from core.output.loop_rows import EPS, STEPS, Pairs, Room, Row, Setup
from core.output.sharing_kernel import at, balance, part, play, touch_error
from core.ring.approach import balance as mesh_balance
from core.ring.approach import part as mesh_part

MIDDLES = 12
"""Steps to where a disc that carries nothing comes to either end of its freedom."""


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
    """Constants of the pairs, disc by disc: as many numbers of each in every row."""

    teeth: Any  # `MeshPairs`
    holes: Pairs


class SeriesRoom(NamedTuple):
    """Results of one position, disc by disc, and what the discs are in it, [K]."""

    teeth: Any  # `MeshRoom`
    holes: Room
    lag: Row
    moves: Row  # by the lag of the output
    torque: Row  # of the ring about the disc's centre
    error: Row  # of the lag
    low: Row  # play in the ring; where it presses what it leaves without torque, twice
    high: Row
    slack_low: Row  # play on the pins, as far as the output lags behind; likewise
    slack_high: Row
    held: Row  # whether the pins press into a disc without load
    turned: Row  # [1] torque that was solved last, negative in reverse; 0 where it was not
    last: Row  # [1] lag of the output then
    wound: Row  # [1] and by how much it was beyond the play
    pressed: Row  # [1] whether pins press without load in either stage by itself


class Between(NamedTuple):
    """One disc: what is the ring's, and what the output's."""

    teeth: Any  # `MeshPairs`
    mesh: Any  # `MeshRoom`
    holes: Pairs
    pins: Room


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
    of_ring: float  # about its centre
    size: float  # of the terms of its balance
    gross: float  # of those of the torque on the output
    slope: float  # of the torque on the output, with the disc's balance solved
    value: float  # torque of the ring less that of the pins
    change: float  # step of Newton of its lag
    moves: float  # its lag by that of the output; so the torque by what the balance is off
    share: float  # 1 over the slope of the balance


def between(j: int, pairs: SeriesPairs, room: SeriesRoom) -> Between:
    """Disc j by itself, in the same rows."""
    teeth, mesh = mesh_part(j, pairs.teeth, room.teeth)
    holes, pins = part(j, pairs.holes, room.holes)
    return Between(teeth, mesh, holes, pins)


def pins_at(psi: float, lag: float, setup: SeriesSetup, disc: Between) -> None:
    """The pins of the output about a disc that lags: in first order lines of action are fixed."""
    turned = setup.direction * lag if setup.output.exact else 0.0
    at(psi - turned, setup.output, disc.holes, disc.pins)


def held(psi: float, lag: float, own: float, setup: SeriesSetup, disc: Between) -> Held:
    """Pins of the output on a disc, by the lags of the output and of the disc.

    With p the pin's centre, q the hole's from that of its disc and d between the centres, all in
    the disc's frame, the approach is ``|d|`` less a length, and its derivative by the disc's lag
    ``-Im(conj(d)*q)/|d|``.
    """
    one, holes, found = setup.output, disc.holes, disc.pins
    if one.exact:
        pins_at(psi, own, setup, disc)
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


def linked(psi: float, lag: float, own: float, setup: SeriesSetup, disc: Between) -> Linked:
    """A disc at a lag of the output and its own; its forces are in the room."""
    on_pins = held(psi, lag, own, setup, disc)
    torque, slope, gross = mesh_balance(own, setup.mesh, disc.teeth, disc.mesh)
    stiff, value = slope + on_pins.by_disc, torque - on_pins.on_disc
    share = 1 / stiff if stiff > 0 else 0.0
    moves = -on_pins.by_both * share
    return Linked(
        on_pins.torque,
        torque,
        gross + on_pins.gross,
        on_pins.gross,
        on_pins.by_output + on_pins.by_both * moves,
        value,
        -value * share,
        moves,
        share,
    )


def rest(in_ring: bool, psi: float, own: float, setup: SeriesSetup, disc: Between) -> float:
    """Lag at which the pins that press a disc turn it neither way: its own in the ring, or by which
    the output is behind it.
    """
    lag, low, high, far = 0.0, -math.inf, math.inf, setup.mesh.eccentricity / setup.mesh.radius
    for step in range(1, STEPS):
        if in_ring:
            torque, slope, gross = mesh_balance(lag, setup.mesh, disc.teeth, disc.mesh)
        else:
            found = held(psi, own + lag, own, setup, disc)
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
    side: float, psi: float, own: float, setup: SeriesSetup, disc: Between
) -> tuple[float, float, bool]:
    """How far the output may lag behind a disc on a side at most, its error, and whether its pins
    press, at a lag of the disc.
    """
    turned = setup.direction * own if setup.output.exact else 0.0
    one, holes, found = setup.output, disc.holes, disc.pins
    pins_at(psi, own, setup, disc)
    low, high, behind, onset = play(one, holes, found)
    error = max(
        touch_error(low, behind, psi - turned, one, holes, found),
        touch_error(high, onset, psi - turned, one, holes, found),
    )
    if low > high + error:
        for i in range(one.pins):
            found.force[i] = 0.0
        return rest(False, psi, own, setup, disc), error, True
    return (high if side > 0 else low), error, False


def middle(
    psi: float, lag: float, least: float, most: float, setup: SeriesSetup, disc: Between
) -> float:
    """Middle of the lags at which a disc, without force, lies between the ends of its play in the
    ring and the pins.
    """
    low, high = least, most
    for _ in range(MIDDLES if setup.output.exact else 1):
        before = low, high
        low = max(least, lag - slack(1.0, psi, low, setup, disc)[0])
        high = min(most, lag - slack(-1.0, psi, high, setup, disc)[0])
        if before == (low, high):
            break
    return (low + high) / 2
