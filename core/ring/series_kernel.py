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

from core.output.contact_kernel import law, within
from core.output.loop_rows import (
    EPS,
    INPUT_TORQUE,
    NO_DRIVE,
    NOT_SOLVED,
    NOT_STABLE,
    RADIAN,
    SOLVED,
    STEPS,
    TINY,
    TOO_FAR,
    TOO_WIDE,
    Load,
    Position,
    Row,
)
from core.output.sharing_kernel import start, too_wide
from core.output.turn_kernel import hardest as hardest_of
from core.output.turn_kernel import largest as largest_of
from core.output.turn_kernel import loaded as loaded_of
from core.output.turn_kernel import wave_torque
from core.ring.approach import ALONG_LEAST, ALONG_MOST, RUB, RUB_AND_PRESS, skipped, sliding, wrench
from core.ring.approach import at as mesh_at
from core.ring.approach import play as mesh_play
from core.ring.approach import shift as mesh_shift
from core.ring.approach import touch_error as mesh_touch_error
from core.ring.approach import wave_torque as mesh_wave_torque
from core.ring.series_disc import (
    Between,
    Linked,
    SeriesPairs,
    SeriesRoom,
    SeriesSetup,
    between,
    linked,
    middle,
    pins_at,
    rest,
    slack,
)

MESH_FORCE, MESH_PRESSURE = 12, 13
"""What is looked at over the turn besides: of the pins of the ring the largest force, and force
over reduced radius.
"""

BEGUN = 12
"""Halvings of the lags from which the solution is sought."""

LOOSE = 0.1
"""How far discs are settled while the lag of the output is still sought, as a part of their own
lag."""

CLOSE = 1e-12
"""Steps of Newton, as parts of the lag, after which the next ones would be rounding."""

JUST = 1e-9
"""Least step in which the lag is sought beyond the play, rad."""

LOOSELY = 8
"""Steps of Newton at most before that."""

PRESSED = 0.5
"""Of a row of flags: what is above it is set."""


class SeriesPoses(NamedTuple):
    """Positions under load as `core.output.loop_rows.Poses`, and what the ring does there."""

    forces: Row
    lag: Row
    stiffness: Row
    force: Row
    pressure: Row
    loaded: Row
    low: Row
    high: Row
    lag_error: Row
    play_error: Row
    force_error: Row
    input_torque: Row
    mesh_force: Row  # largest on a pin of the ring
    mesh_pressure: Row  # largest force over reduced radius there
    mesh_loaded: Row  # number of the ring's pairs with a force
    pressed: Row  # whether pins press without load in either stage by itself
    own: Row  # lag of the holes of each disc, [n*K]
    along: Row  # force of the ring on each disc along its crank, to the axis, [n*K]
    across: Row  # and across it, against its turning, [n*K]
    teeth: Row  # of all pairs of the ring, [n*K*z_p]


def wave(angle: float, setup: SeriesSetup) -> float:
    """Wave angle of the output mechanism at a crank angle."""
    return angle * (1 + 1 / setup.ratio) + setup.start


def placed(
    angle: float, setup: SeriesSetup, pairs: SeriesPairs, room: SeriesRoom
) -> tuple[float, float, float, bool]:
    """Least and largest lag of the output at which nothing carries, their error, and whether pins
    press in any stage by itself. The first is larger where pairs press.
    """
    psi, low, high, error, pressed = wave(angle, setup), -math.inf, math.inf, 0.0, False
    one = setup.mesh
    for j in range(setup.satellites):
        disc = between(j, pairs, room)
        teeth, found = disc.teeth, disc.mesh
        for i in range(one.pins):
            found.force[i] = 0.0
        mesh_at(angle, one, teeth, found)
        first, last, behind, onset = mesh_play(one, teeth, found)
        off = max(
            mesh_touch_error(first, behind, angle, one, teeth, found),
            mesh_touch_error(last, onset, angle, one, teeth, found),
        )
        mesh_shift(0.0, -1, one, teeth, found)
        if first > last + off:
            first = last = rest(True, psi, 0.0, setup, disc)
            pressed = True
        room.low[j], room.high[j] = first, last
        behind_most, off_high, held_high = slack(1.0, psi, last, setup, disc)
        behind_least, off_low, held_low = slack(-1.0, psi, first, setup, disc)
        room.slack_low[j], room.slack_high[j] = behind_least, behind_most
        room.held[j] = 1.0 if held_low or held_high else 0.0
        pressed = pressed or held_low or held_high
        low, high = max(low, first + behind_least), min(high, last + behind_most)
        error = max(error, off + max(off_low, off_high))
    room.pressed[0] = 1.0 if pressed or low > high + error else 0.0
    return low, high, error, pressed


def settled(
    j: int,
    psi: float,
    lag: float,
    close: float,
    setup: SeriesSetup,
    disc: Between,
    room: SeriesRoom,
) -> tuple[Linked, bool]:
    """Disc j in balance at a lag of the output, so close as a part of its own, and whether it is.
    What is left is less than the next step of Newton, which is taken.
    """
    own, low, high = room.lag[j], -math.inf, math.inf
    # It lies between where the ring lets it go and where the pins do.
    least = min(room.low[j], lag - room.slack_low[j])
    most = max(room.high[j], lag - room.slack_high[j])
    wider = (most - least) / 2 + JUST
    least, most = least - wider, most + wider
    done = False
    for step in range(1, STEPS):
        one = linked(psi, lag, own, setup, disc)
        if one.value == 0 and one.share == 0:  # free
            if room.held[j] < PRESSED:
                own = middle(psi, lag, room.low[j], room.high[j], setup, disc)
            done = True
            break
        if abs(one.value) <= EPS * one.size or abs(one.change) <= close * abs(own):
            own += one.change if close > EPS else 0.0
            done = True
            break
        if one.value > 0:
            high = own
        else:
            low = own
        change = one.change if one.share > 0 else math.inf
        change = min(max(change, least - own), most - own)
        following = within(own, change, low, high, step)
        if following in (low, high):
            done = True
            break
        own = following
    room.lag[j], room.moves[j], room.torque[j] = own, one.moves, one.of_ring
    return one, done


def begun(
    over: float, torque: float, setup: SeriesSetup, pairs: SeriesPairs, room: SeriesRoom
) -> float:
    """Lag of the output at which discs that carry alike would carry the torque, in first order; the
    discs are put between. It is infinite where one cannot.
    """
    lag, each = 0.0, torque / setup.satellites
    for j in range(setup.satellites):
        disc = between(j, pairs, room)
        pins_at(over, room.high[j], setup, disc)
        most = start(each, setup.mesh, disc.teeth, disc.mesh)
        low, high = room.high[j], max(most, room.high[j])
        for _ in range(BEGUN if high < math.inf else 0):
            middle = (low + high) / 2
            if roughly(middle, setup.mesh, disc.teeth, disc.mesh) > each:
                high = middle
            else:
                low = middle
        own = high
        most = start(each, setup.output, disc.holes, disc.pins)
        low, high = room.slack_high[j], max(most, room.slack_high[j])
        for _ in range(BEGUN if high < math.inf else 0):
            middle = (low + high) / 2
            if roughly(middle, setup.output, disc.holes, disc.pins) > each:
                high = middle
            else:
                low = middle
        room.lag[j], room.moves[j] = own, own + high
        lag += (own + high) / setup.satellites
    if lag == math.inf:
        return lag
    for j in range(setup.satellites):
        room.lag[j] += (lag - room.moves[j]) / 2
    return lag


def roughly(lag: float, setup: Any, pairs: Any, room: Any) -> float:
    """Torque of the pairs of one mesh at a lag, in first order."""
    torque = 0.0
    for i in range(setup.pins):
        twice = 2 * pairs.distance[i] if setup.exact else 1.0
        approach = (room.q[i] + lag * room.v[i]) / twice
        if approach > TINY:
            force, _ = law(
                setup.law,
                approach,
                pairs.a[i],
                pairs.b[i],
                setup.exponent,
                0.0,
                0.0,
                setup.curve,
            )
            torque += force * room.v[i] / twice
    return torque


def solve(
    psi: float, torque: float, setup: SeriesSetup, pairs: SeriesPairs, room: SeriesRoom
) -> Position:
    """Equilibrium at a crank angle under a torque > 0; forces, levers and the lags of the discs are
    left in the room. Play and lag are those of the output.
    """
    low, high, play_error, pressed = placed(psi, setup, pairs, room)
    over = wave(psi, setup)
    zero = (low + high) / 2 if low > high else high
    for i in range(setup.pins * setup.satellites):
        room.holes.force[i] = 0.0
    for i in range(setup.mesh.pins * setup.satellites):
        room.teeth.force[i] = 0.0
    if room.turned[0] == setup.direction * torque and math.isfinite(zero):
        # As far beyond the play as where it was solved last, which mostly is nearby.
        lag = zero + room.wound[0]
        for j in range(setup.satellites):
            room.lag[j] += lag - room.last[0]
    else:
        lag = begun(over, torque, setup, pairs, room)
    room.turned[0] = 0.0
    if lag == math.inf or zero == math.inf:
        return Position(0.0, 0.0, low, high, play_error, 0.0, 0.0, NO_DRIVE, 0)
    pressed = pressed or low > high
    first, last = -math.inf if pressed else zero, math.inf
    power = 1.0 if pressed else 1 / max(setup.mesh.exponent, setup.output.exponent)
    step, status, far = 0, NOT_SOLVED, setup.mesh.eccentricity / setup.mesh.radius
    value = slope = 0.0
    loose, reach = True, max(lag - zero, abs(zero), JUST)
    for step in range(1, STEPS):
        carried = size = slope = 0.0
        balanced = close = True
        for j in range(setup.satellites):
            disc = between(j, pairs, room)
            one, done = settled(j, over, lag, LOOSE if loose else EPS, setup, disc, room)
            balanced = balanced and done
            close = close and abs(one.change) <= CLOSE * abs(lag)
            carried += one.torque - one.moves * one.value
            size += one.gross + abs(one.moves) * one.size
            slope += one.slope
        value = carried - torque
        ratio, change = carried / torque, math.inf
        if slope > 0 and power == 1:
            change = -value / slope
        elif slope > 0 and ratio > 0:
            change = torque * (ratio ** (1 - power) - ratio) / (power * slope)
        if pressed:
            change = min(max(change, -far), far)
        if change > reach:  # contacts that only just touch are softer than any further on
            change, reach = reach, 2 * reach
        following = lag + change
        if loose:  # nothing is known of the sign
            inside = first < following < last
            if inside and close and abs(change) <= CLOSE * abs(lag):
                status = SOLVED if balanced else NOT_SOLVED
            loose = inside and status != SOLVED and step < LOOSELY
            if not inside:
                continue
        else:
            if value > 0:
                last = lag
            else:
                first = lag
            if abs(value) <= EPS * size or abs(change) <= EPS * abs(lag):
                status = SOLVED if balanced else NOT_SOLVED
                break
            following = within(lag, change, first, last, step)
            if following in (first, last):
                status = SOLVED if balanced else NOT_SOLVED
                break
        for j in range(setup.satellites):
            room.lag[j] += room.moves[j] * (following - lag)
        lag = following
        if status == SOLVED:
            break
    if slope <= 0:
        return Position(lag, slope, low, high, play_error, 0.0, 0.0, NOT_STABLE, step)
    lag_error, force_error, slope = series_errors(psi, torque, lag, setup, pairs, room)
    if status == SOLVED:
        room.turned[0], room.last[0], room.wound[0] = setup.direction * torque, lag, lag - zero
    lag_error += (0.0 if pressed else play_error) + EPS * abs(lag)
    return Position(lag, slope, low, high, play_error, lag_error, force_error, status, step)


def series_errors(
    angle: float,
    torque: float,
    lag: float,
    setup: SeriesSetup,
    pairs: SeriesPairs,
    room: SeriesRoom,
) -> tuple[float, float, float]:
    """Bounds of the errors of the lag of the output and of all forces at the lags in the room: by
    what the balances are off there, and by rounding of their terms, of levers and of approaches.
    And the stiffness there.
    """
    psi = wave(angle, setup)
    in_ring, on_pins = EPS * (4 + 2 * abs(angle)), EPS * (4 + 2 * abs(psi))
    mesh, output, teeth, holes = setup.mesh, setup.output, room.teeth, room.holes
    off, slope, force_error, carried = 4 * EPS * torque, 0.0, 0.0, 0.0
    for j in range(setup.satellites):
        own, disc = room.lag[j], between(j, pairs, room)
        one = linked(psi, lag, own, setup, disc)
        slope += one.slope
        rough, unsure = 4 * EPS * one.size + abs(one.value), 0.0
        for i in range(j * mesh.pins, (j + 1) * mesh.pins):
            near = in_ring * (pairs.teeth.size[i] + abs(own) * mesh.radius)
            teeth.unsure[i] = near
            rough += in_ring * teeth.force[i] * mesh.radius
            rough += teeth.stiffness[i] * abs(teeth.lever[i]) * near
        for i in range(j * output.pins, (j + 1) * output.pins):
            twice = 2 * pairs.holes.distance[i] if output.exact else 1.0
            near = on_pins * (pairs.holes.size[i] / twice + abs(lag - own) * output.radius)
            holes.unsure[i] = near
            unsure += on_pins * holes.force[i] * output.radius
            unsure += holes.stiffness[i] * abs(holes.lever[i]) * near
        room.error[j] = (rough + unsure) * one.share
        carried += one.torque - one.moves * one.value
        off += unsure + 4 * EPS * one.gross + abs(one.moves) * (rough + unsure)
        room.moves[j], room.torque[j] = one.moves, one.of_ring
    off += abs(carried - torque)
    lag_error = off / slope if slope > 0 else math.inf
    for j in range(setup.satellites):
        room.error[j] += abs(room.moves[j]) * lag_error
        for i in range(j * mesh.pins, (j + 1) * mesh.pins):
            near = abs(teeth.lever[i]) * room.error[j] + teeth.unsure[i]
            near = teeth.stiffness[i] * near + 8 * EPS * teeth.force[i]
            force_error = max(force_error, near)
        for i in range(j * output.pins, (j + 1) * output.pins):
            near = abs(holes.lever[i]) * (lag_error + room.error[j]) + holes.unsure[i]
            near = holes.stiffness[i] * near + 8 * EPS * holes.force[i]
            force_error = max(force_error, near)
    return lag_error, force_error, slope


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
    if max(too_wide(pairs.teeth, room.teeth), too_wide(pairs.holes, room.holes)) >= 0:
        return TOO_WIDE
    skips = setup.mesh.foot and skipped(room.lag, setup.mesh, pairs.teeth)
    return NOT_STABLE if skips else SOLVED


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
        own, disc = room.lag[j], between(j, pairs, room)
        turned = over - (setup.direction * own if setup.output.exact else 0.0)
        total += mesh_wave_torque(psi, own, setup.mesh, disc.teeth, disc.mesh)
        on_pins = wave_torque(turned, lag - own, setup.output, disc.holes, disc.pins)
        total += (1 + 1 / setup.ratio) * on_pins
    return total


def on_crank(
    j: int, psi: float, lag: float, setup: SeriesSetup, pairs: SeriesPairs, room: SeriesRoom
) -> tuple[float, float, float, float]:
    """Forces on disc j along its crank, to the axis, and across it, against its turning: of the
    ring, and of the pins of the output, as `solve` left the room.
    """
    pins_along = pins_across = 0.0
    along, across = on_teeth(j, setup, pairs, room)
    output, own, disc = setup.output, room.lag[j], between(j, pairs, room)
    holes, found, way = disc.holes, disc.pins, setup.direction
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


def on_teeth(
    j: int, setup: SeriesSetup, pairs: SeriesPairs, room: SeriesRoom
) -> tuple[float, float]:
    """The first two of these alone."""
    along = across = 0.0
    mesh, disc = setup.mesh, between(j, pairs, room)
    for i in range(mesh.pins):
        if disc.mesh.force[i] > 0:
            x, y, _ = wrench(i, 0, mesh, disc.teeth, disc.mesh)
            along += x
            across += y
    return along, across


def of_rub(pressing: bool, setup: SeriesSetup, pairs: SeriesPairs, room: SeriesRoom) -> float:
    """Largest product of a pair's distance to the pitch point of its disc and its force on the
    ring, or the root of that over the reduced radius.
    """
    most = 0.0
    for i, force in enumerate(room.teeth.force):
        far = sliding(i, setup.mesh, room.teeth)
        most = max(most, far * (math.sqrt(force * pairs.teeth.curved[i]) if pressing else force))
    return most


def along_crank(most: bool, setup: SeriesSetup, pairs: SeriesPairs, room: SeriesRoom) -> float:
    """Largest, or least, force of the ring on a disc along its crank."""
    best = -math.inf if most else math.inf
    for j in range(setup.satellites):
        own, _ = on_teeth(j, setup, pairs, room)
        best = max(best, own) if most else min(best, own)
    return best


def of_mesh(pressing: bool, pairs: SeriesPairs, room: SeriesRoom) -> float:
    """Largest force on a pin of the ring, or force over reduced radius."""
    most = 0.0
    for i, force in enumerate(room.teeth.force):
        most = max(most, force * pairs.teeth.curved[i] if pressing else force)
    return most


def largest(room: SeriesRoom) -> float:
    """Largest force of the output's pins."""
    return largest_of(room.holes)


def hardest(setup: SeriesSetup, pairs: SeriesPairs, room: SeriesRoom) -> float:
    """What presses them most."""
    return hardest_of(setup.output, pairs.holes, room.holes)


def other(
    kind: int,
    psi: float,
    lag: float,
    load: Load,
    pairs: SeriesPairs,
    room: SeriesRoom,
) -> float:
    """What is looked at besides, as `solve` left the room."""
    setup: Any = load.setup
    if kind == INPUT_TORQUE:
        return input_torque(psi, load.torque, lag, setup, pairs, room)
    if kind in (RUB, RUB_AND_PRESS):
        return of_rub(kind == RUB_AND_PRESS, setup, pairs, room)
    if kind in (ALONG_MOST, ALONG_LEAST):
        return along_crank(kind == ALONG_MOST, setup, pairs, room)
    return of_mesh(kind == MESH_PRESSURE, pairs, room)


def poses(
    places: Row,
    torque: float,
    setup: SeriesSetup,
    pairs: SeriesPairs,
    room: SeriesRoom,
    results: SeriesPoses,
) -> int:
    """Positions at crank angles; the first one that cannot be, or -1."""
    count, teeth = setup.pins * setup.satellites, setup.mesh.pins * setup.satellites
    for k, psi in enumerate(places):
        found = solve(psi, torque, setup, pairs, room)
        if judged(found, setup, pairs, room) != SOLVED:
            return k
        for i in range(count):
            results.forces[k * count + i] = room.holes.force[i]
        results.lag[k], results.stiffness[k] = found.lag, found.stiffness
        results.force[k], results.pressure[k] = largest(room), hardest(setup, pairs, room)
        results.loaded[k], results.mesh_loaded[k] = loaded_of(room.holes), loaded_of(room.teeth)
        results.low[k], results.high[k] = found.low, found.high
        results.lag_error[k], results.play_error[k] = found.lag_error, found.play_error
        results.force_error[k] = found.force_error
        results.input_torque[k] = input_torque(psi, torque, found.lag, setup, pairs, room)
        results.mesh_force[k] = of_mesh(False, pairs, room)
        results.mesh_pressure[k] = of_mesh(True, pairs, room)
        results.pressed[k] = room.pressed[0]
        for j in range(setup.satellites):
            results.own[k * setup.satellites + j] = room.lag[j]
            along, across = on_teeth(j, setup, pairs, room)
            results.along[k * setup.satellites + j] = along
            results.across[k * setup.satellites + j] = across
        for i in range(teeth):
            results.teeth[k * teeth + i] = room.teeth.force[i]
    return -1
