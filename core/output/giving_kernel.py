"""Load sharing of satellites that give on their cranks or in their mesh; rules in `loop_rows`."""

import math
from typing import NamedTuple

from core.output.contact_kernel import law, within
from core.output.loop_rows import (
    CRANK,
    EPS,
    NEWTON_ALONE,
    NOT_SOLVED,
    SOLVED,
    STEPS,
    TINY,
    Freed,
    Pairs,
    Room,
    Setup,
)


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
