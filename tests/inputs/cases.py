"""Random mechanisms, with the awkward ones well represented."""

import math
import random

from mpmath import mp, mpf

from core.output.mechanism import Mechanism
from tests.oracles.crank_planetary import largest_gap

EXPONENTS = [0.0, 1e-9, 0.3, 1.0, 10 / 9, 1.5, 3.0, 20.0, 120.0, 500.0]


def random_crank_angles(r: random.Random, satellites: int, pins: int) -> tuple[float, ...]:
    """Crank angles: any, evenly spaced, coincident, nearly so, whole degrees, pin pitches."""
    kind = r.choice(["any", "even", "coincident", "near", "near even", "degrees", "pitch"])
    if kind == "even":
        return tuple(j * 2 * math.pi / satellites for j in range(satellites))
    if kind == "coincident":
        return tuple(r.choice([0.5, 2.0, 0.5 + math.pi]) for _ in range(satellites))
    if kind == "near":
        base = r.uniform(-7, 7)
        return tuple(base + r.choice([-1, 1]) * 10 ** r.uniform(-13, -3) for _ in range(satellites))
    if kind == "near even":
        return tuple(
            j * 2 * math.pi / satellites + r.choice([-1, 1]) * 10 ** r.uniform(-13, -3)
            for j in range(satellites)
        )
    if kind == "degrees":
        return tuple(math.radians(r.randrange(0, 360, 15)) for _ in range(satellites))
    if kind == "pitch":
        step = math.pi / pins
        return tuple(
            step * r.randint(0, 2 * pins) + r.choice([0, 0, 1, -1]) * 10 ** r.uniform(-13, -6)
            for _ in range(satellites)
        )
    return tuple(r.uniform(0, 2 * math.pi) for _ in range(satellites))


def random_mechanism(seed: int, largest_pins: int = 40) -> tuple[Mechanism, float]:
    """A mechanism without a dead centre, and a force exponent."""
    r = random.Random(seed)
    while True:
        pins = r.choice([1, 2, 3, 3, 4, 5, 6, 7, 8, r.randint(3, largest_pins)])
        satellites = r.randint(1, 6)
        mechanism = Mechanism(
            pins=pins,
            crank_angles=random_crank_angles(r, satellites, pins),
            ratio=r.choice([20.0, 1.0, 10 ** r.uniform(-1, 3)]),
            initial_crank_angle=r.choice([0.0, math.pi, r.uniform(-4, 4)]),
        )
        exponent = r.choice([*EXPONENTS, 10 ** r.uniform(-3, 2.7)])
        if largest_gap(pins, mechanism.crank_angles) < mp.pi - mpf("1e-3"):
            return mechanism, exponent
