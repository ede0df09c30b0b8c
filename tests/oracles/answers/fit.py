"""Least room of pins in their holes over the turn: mm, degrees.

Of distances alone: at a wave angle the room is the largest over the lag of what is left to the
tightest pin, which first rises and then falls; the turn is scanned and looked at ever closer about
the tightest places.
"""

from typing import Any

import numpy as np
from mpmath import mpf

from tests.oracles.answers.calculation import Body, Calculation, Draw, Number, Numbers

FAR = 0.4
"""Lags that are looked at, rad: the eccentricity and what is off are small beside the radius."""

GOLDEN, STEPS = (5**0.5 - 1) / 2, 80
WAVES, NARROWED, ROUNDS = 1501, 12, 10


def request(r: Draw) -> Body:
    """A mechanism whose parts are off by up to some hundredths, extremes by up to half a millimetre
    or by next to nothing.
    """
    pins, satellites = r.randint(3, 6), r.randint(1, 2)
    off = r.power(1e-5, 0.5) if r.extreme else 0.01

    def some(count: int, size: float) -> list[float]:
        return [r.decimal(-size, size) for _ in range(count)]

    return {
        "mechanism": {"pins": pins, "satellites": satellites, "ratio": r.decimal(5, 90)},
        "load": {"pin_circle_radius_mm": r.decimal(30, 60)},
        "contact": {
            "contact_length_mm": r.decimal(8, 20),
            "pin_radius_mm": r.decimal(3, 8),
            "eccentricity_mm": r.decimal(1, 3),
            "hole_clearance_mm": r.power(1e-4, 0.3) if r.extreme else r.choice((0.02, 0.03, 0.05)),
        },
        "deviations": {
            "pin_radial_mm": some(pins, off),
            "pin_radius_mm": some(pins, off / 3),
            "hole_tangential_mm": [some(pins, off) for _ in range(satellites)],
            "eccentricity_mm": some(satellites, off / 2),
            "crank_phase_deg": some(satellites, off),
        },
    }


def numbers(body: Body, answer: Any) -> Numbers:
    """The least room, as good as the doubles of the scan: some 1e-16 of the pin circle."""
    exact = least_room(body)
    whole = answer["accuracy"]["relative_error"]
    digits = 2e-16 * body["load"]["pin_circle_radius_mm"] / abs(exact)
    sent = answer["fit"]["least_room_mm"]
    return {"/fit/least_room_mm": Number(sent, mpf(exact), None, whole + digits)}


def least_room(body: Body) -> float:
    """mm."""
    contact, given = body["contact"], body["deviations"]
    pins, satellites = body["mechanism"]["pins"], body["mechanism"]["satellites"]
    radius = body["load"]["pin_circle_radius_mm"]
    spoke = 1j * np.exp(2j * np.pi * np.arange(pins) / pins)
    pin = (radius + np.array(given["pin_radial_mm"])) * spoke
    ahead = np.radians(np.array(given["crank_phase_deg"]))
    hole = (radius + 1j * np.array(given["hole_tangential_mm"])) * spoke
    hole = hole * np.exp(1j * ahead / body["mechanism"]["ratio"])[:, None]
    crank = 2 * np.pi * np.arange(satellites) / satellites + ahead
    arm = contact["eccentricity_mm"] + np.array(given["eccentricity_mm"])
    gap = contact["eccentricity_mm"] + contact["hole_clearance_mm"]
    gap = gap - np.array(given["pin_radius_mm"])

    def room(wave: np.ndarray) -> np.ndarray:
        centre = hole + (arm * 1j * np.exp(-1j * (wave[:, None] + crank)))[..., None]

        def left(lag: np.ndarray) -> np.ndarray:
            turned = pin * np.exp(-1j * lag)[:, None, None]
            return (gap - np.abs(turned - centre)).min(axis=(1, 2))

        low, high = np.full(len(wave), -FAR), np.full(len(wave), FAR)
        for _ in range(STEPS):
            one, other = high - GOLDEN * (high - low), low + GOLDEN * (high - low)
            falls = left(one) > left(other)
            low, high = np.where(falls, low, one), np.where(falls, other, high)
        return left((low + high) / 2)

    places, width = 2 * np.pi * np.arange(WAVES) / WAVES, 2 * np.pi / WAVES
    places = places[np.argsort(room(places))[:NARROWED]]
    for _ in range(ROUNDS):
        around = places[:, None] + width * np.linspace(-1, 1, 17)
        found = room(around.ravel()).reshape(around.shape)
        places, width = around[np.arange(len(places)), found.argmin(axis=1)], width / 8
    return float(found.min())


FIT = Calculation(name="Room of pins in their holes", path="fit", request=request, numbers=numbers)
