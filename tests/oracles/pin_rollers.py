"""Rollers on pins by other ways: their speed by velocities, their load zone by quadrature."""

import math

import numpy as np

ZONE = {"ball": (1.5, 10 / 3), "roller": (10 / 9, 9 / 2)}
"""Exponents of the force over the approach, and of the damage of a ring that stands still over the
force."""


def ring_speed(
    *, eccentricity: float, ring: float, hole: float, crank: float, turn: float
) -> float:
    """Speed of a ring that rolls in a hole, against its pin, by velocities in the fixed frame.

    The carrier and the discs turn at `turn`, the crank at `crank`; the ring touches its hole where
    the line of centres says.
    """
    centre = 0.0 + 0.0j  # of the pin, which turns about a far axis
    axis = -20 * eccentricity + 0.0j
    hole_centre = centre + eccentricity  # the hole's, along the crank
    carried = 1j * turn * (centre - axis)
    # the disc's centre moves on its crank about the axis, the disc turns with the carrier
    disc_centre = axis + eccentricity
    moved = 1j * crank * (disc_centre - axis) + 1j * turn * (hole_centre - disc_centre)
    contact = hole_centre - hole
    disc_there = moved + 1j * turn * (contact - hole_centre)
    # without slip: carried + 1j*w*(contact - centre) has the same velocity across
    across = (disc_there - carried) / (1j * (contact - centre))
    return abs(across.real - turn)


def shares(*, kind: str, elements: int) -> tuple[float, float]:
    """Share of the ratings left if the two elements next to the load carry all of it: by quadrature
    over the load zone of a rigid seat.
    """
    law, power = ZONE[kind]
    angle = np.linspace(-math.pi / 2, math.pi / 2, 200_001)

    def integral(values: np.ndarray) -> float:
        return float(np.trapezoid(values, angle)) / (2 * math.pi)

    wide = np.cos(angle) ** law
    most = 1 / (elements * integral(wide * np.cos(angle)))
    rigid = most * integral(wide**power) ** (1 / power)
    pitch = 2 * math.pi / elements
    place = np.linspace(-pitch, pitch, 200_001)
    share = 1 - np.abs(place) / pitch
    alone = float(np.trapezoid(share**power, place)) / (2 * math.pi)
    return rigid / alone ** (1 / power), 5 / elements
