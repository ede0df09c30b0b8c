"""Load sharing of pins that a tie ring joins; rules in `loop_rows`."""

import math

from core.output.contact_kernel import law
from core.output.loop_rows import (
    AS_GOOD,
    EPS,
    HALVINGS,
    NOT_SOLVED,
    SOLVED,
    STEPS,
    TINY,
    Pairs,
    Room,
    Row,
    Setup,
)


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
