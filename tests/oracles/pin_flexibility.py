"""Deflections of a pin under unit forces at its satellites, by least work at 40 digits."""

from collections.abc import Callable
from itertools import pairwise
from typing import Any

from mpmath import mp, mpf

Line = tuple[Callable[[mpf], mpf], Callable[[mpf], mpf]]
"""Moment and shear force along the pin."""


def pin_gives(pin: Any) -> list[list[mpf]]:
    """Deflection at each satellite (rows) under a unit force at each (columns), m/N.

    Of a pin that is built in at both ends the force and the moment at the far end are those that
    make the energy of bending and shear least.
    """
    mp.dps = 40
    modulus, d = mpf(pin.material.youngs_modulus), mpf(pin.diameter)
    stiff = modulus * mp.pi * d**4 / 64
    shear = modulus / (2 * (1 + mpf(pin.material.poissons_ratio))) * mp.pi * d**2 / 4 * 9 / 10
    places = [mpf(z) for z in pin.satellite_positions]
    length = max(places) if pin.support == "cantilever" else mpf(pin.span)
    cuts = sorted({mpf(0), *places, length})

    def work(one: Line, other: Line) -> mpf:
        total = mpf(0)
        for low, high in pairwise(cuts):
            middle, part = (low + high) / 2, (high - low) / 6
            near = (high - low) * mpf(10) ** -30  # shear forces jump where a force acts
            ends = one[0](low) * other[0](low) + one[0](high) * other[0](high)
            total += part * (ends + 4 * one[0](middle) * other[0](middle)) / stiff
            inside = low + near
            total += (high - low) * one[1](inside) * other[1](inside) / shear
        return total

    def load(z: mpf) -> Line:
        if pin.support == "supported":
            share = z / length
            return (
                lambda x: (1 - share) * x if x < z else share * (length - x),
                lambda x: 1 - share if x < z else -share,
            )
        return (lambda x: z - x if x < z else mpf(0), lambda x: mpf(1) if x < z else mpf(0))

    loads, free = [load(z) for z in places], list[Line]()
    if pin.support == "fixed":
        free = [(lambda x: length - x, lambda x: mpf(1)), (lambda x: mpf(1), lambda x: mpf(0))]
    found = [[work(one, other) for other in loads] for one in loads]
    if free:
        within = mp.matrix([[work(one, other) for other in free] for one in free])
        for k, other in enumerate(loads):
            held = mp.lu_solve(within, mp.matrix([-work(one, other) for one in free]))
            for i, one in enumerate(loads):
                found[i][k] += mp.fsum(
                    h * work(one, each) for h, each in zip(held, free, strict=True)
                )
    return found
