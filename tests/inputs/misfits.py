"""Random mechanisms with misfits from 1 um to 10 mm: for core, and for plain distances."""

import random

from core.output.mechanism import Mechanism
from core.output.room import Deviations, Rooms
from tests.oracles.room import Sizes

MM = 1e-3


def drawn(rng: random.Random) -> tuple[Rooms, Sizes]:
    """A mechanism with misfits from 1 um to 10 mm, and the same for plain distances."""
    pins, satellites, radius = rng.randint(1, 8), rng.randint(1, 3), rng.uniform(20, 60) * MM
    eccentricity = rng.uniform(0.5, 3) * MM
    misfit = 10 ** rng.uniform(-6, -2)
    clearance = rng.choice([0.0, 1.0, 10 ** rng.uniform(-2, 1)]) * misfit
    ratio = rng.uniform(2, 60)

    def row(count: int, size: float = misfit) -> tuple[float, ...]:
        return tuple(rng.uniform(-1, 1) * size for _ in range(count))

    def table() -> tuple[tuple[float, ...], ...]:
        return tuple(row(pins) for _ in range(satellites))

    kinds = {
        "pin_radial": lambda: row(pins),
        "pin_tangential": lambda: row(pins),
        "pin_radius": lambda: row(pins, min(misfit, 1e-3)),
        "hole_radial": table,
        "hole_tangential": table,
        "hole_radius": table,
        "eccentricity": lambda: row(satellites, min(misfit, eccentricity / 3)),
        "crank_phase": lambda: row(satellites, misfit / radius),
        "disc_phase": lambda: row(satellites, misfit / radius / 4),
    }
    off = {name: make() for name, make in kinds.items() if rng.random() < 0.4}
    mechanism = Mechanism.evenly_spaced(pins=pins, satellites=satellites, ratio=ratio)
    pin = 4 * MM
    own = Rooms(mechanism, radius, pin, eccentricity, clearance, Deviations(**off))
    hole = pin + eccentricity + clearance
    return own, Sizes(pins, mechanism.crank_angles, ratio, radius, pin, eccentricity, hole, off)
