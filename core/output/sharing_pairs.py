"""What a design is to the loops over its pairs, and the constants of the pairs.

The rules of `core.output.sharing_kernel` hold here as well.
"""

import math
from collections.abc import MutableSequence
from typing import NamedTuple

Row = MutableSequence[float]


class Setup(NamedTuple):
    """What a design is, without its errors."""

    pins: int
    satellites: int
    ratio: float
    exact: bool  # geometry; else first order
    radius: float  # of the pin circle
    eccentricity: float
    clearance: float  # radial; not as a difference of radii, which loses two digits
    direction: float  # of the torque: 1, or -1 in reverse
    law: int  # LINEAR, POWER, HERTZ
    exponent: float  # of the force over the approach; about 10/9 for Hertz, for start and steps


class Errors(NamedTuple):
    """Deviations of one piece; rows of [N], [K*N] or [K]."""

    pin_radial: Row
    pin_tangential: Row
    pin_radius: Row
    hole_radial: Row
    hole_tangential: Row
    hole_radius: Row
    eccentricity: Row
    crank_phase: Row
    disc_phase: Row


class Pairs(NamedTuple):
    """What of the pairs does not change over the turn, [K*N]; [K] where said."""

    arm: Row  # [K] -2*eccentricity of the satellite's own crank; 1 in first order
    phase: Row  # [K] crank angles with their errors
    x: Row  # factors of the crank's direction in u and v
    y: Row
    ex: Row  # and in q
    ey: Row
    k0: Row  # constant parts of q, u, v
    k1: Row
    k2: Row
    distance: Row  # of the centres in contact
    size: Row  # of the terms that make q: times the rounding, its error
    a: Row  # law: LINEAR 1/k + C; POWER k; HERTZ A + C
    b: Row  # POWER C; HERTZ B


class Room(NamedTuple):
    """Results of one position, [K*N]."""

    q: Row
    u: Row
    v: Row
    unsure: Row  # size of the terms that make q at the onset
    force: Row
    lever: Row
    stiffness: Row  # of the contact
    own_lag: Row  # [K] of the satellites, where they give


def prepare(setup: Setup, errors: Errors, phase: Row, pairs: Pairs) -> None:
    """Constants of the pairs from the deviations of one piece; the laws are the caller's."""
    radius = setup.radius
    i = 0
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
            gap = setup.clearance + larger - errors.eccentricity[j]
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
                pairs.size[i] = (2 * abs(own) + off) * off + loose * (2 * abs(own) + abs(gap))
            else:
                e_r, e_t = p_r - h_r, p_t - h_t - eta * radius
                pairs.x[i], pairs.y[i] = -radius * ry, radius * rx
                pairs.ex[i], pairs.ey[i] = e_t * ry - e_r * rx, -e_r * ry - e_t * rx
                pairs.k0[i], pairs.k1[i], pairs.k2[i] = -gap, 0.0, 0.0
                pairs.size[i] = off + loose
            pairs.distance[i] = setup.eccentricity + setup.clearance + larger
            i += 1
