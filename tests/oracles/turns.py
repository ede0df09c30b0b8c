"""Largest values over the turn of a mechanism as made, by bisection at many positions.

Nothing is shared with ``core``, nor imported from it: pins and holes in first order, the lag halved
until the torque of all forces is the load, at every position of a scan and then about its highest
ones.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

Array = np.ndarray
HALVINGS = 55
NARROWED = 24
"""Summits of a scan about which is looked closer."""

ROUNDS = 10
"""How often, to an eighth: to 1e-12 rad of a scan of some thousand positions."""


@dataclass(frozen=True)
class Made:
    """Sizes in m, N, rad; rows by satellites; the force is ``stiffness*approach**exponent``."""

    pins: int
    cranks: tuple[float, ...]
    ratio: float
    radius: float
    eccentricity: float
    clearance: float
    stiffness: float
    exponent: float
    pin_radial: Array
    pin_tangential: Array
    pin_radius: Array
    hole_radial: Array
    hole_tangential: Array
    hole_radius: Array
    disc_phase: Array

    def sizes(self, psi: Array) -> tuple[Array, Array]:
        """Levers and gaps of all pairs along the crank, shape (K*N, n)."""
        spoke = 1j * np.exp(2j * np.pi * np.arange(self.pins) / self.pins)
        off = self.pin_radial + 1j * self.pin_tangential
        off = off - (self.hole_radial + 1j * self.hole_tangential)
        off = spoke * (off - 1j * self.radius * self.disc_phase[:, None])
        levers, gaps = [], []
        for j, angle in enumerate(self.cranks):
            along = np.conj(1j * np.exp(-1j * (psi + angle)))
            levers.append(-self.radius * (along * spoke[:, None]).imag)
            room = self.clearance + self.hole_radius[j] - self.pin_radius
            gaps.append((along * off[j][:, None]).real + room[:, None])
        return np.concatenate(levers), np.concatenate(gaps)

    def lag(self, psi: Array, torque: float) -> tuple[Array, Array]:
        """Lag, and forces of all pairs, under a torque; negative in reverse."""
        levers, gaps = self.sizes(psi)

        def forces(lag: Array) -> Array:
            return self.stiffness * np.maximum(levers * lag - gaps, 0) ** self.exponent

        low = np.full(len(psi), -0.2 * self.eccentricity / self.radius)
        high = -low
        while ((forces(high) * levers).sum(axis=0) < torque).any():
            high = 2 * high
        while ((forces(low) * levers).sum(axis=0) > torque).any():
            low = 2 * low
        for _ in range(HALVINGS):
            middle = (low + high) / 2
            short = (forces(middle) * levers).sum(axis=0) < torque
            low, high = np.where(short, middle, low), np.where(short, high, middle)
        return (low + high) / 2, forces((low + high) / 2)

    def play(self, psi: Array) -> Array:
        """How far the unloaded output turns to and fro, rad; 0 where pairs press."""
        levers, gaps = self.sizes(psi)
        with np.errstate(divide="ignore", invalid="ignore"):
            touches = gaps / levers
        high = np.where(levers > 0, touches, np.inf).min(axis=0)
        low = np.where(levers < 0, touches, -np.inf).max(axis=0)
        return np.maximum(high - low, 0.0)

    def force(self, psi: Array, torque: float) -> Array:
        """Largest force at positions, N."""
        return self.lag(psi, torque)[1].max(axis=0)

    def lost_motion(self, psi: Array, torque: float) -> Array:
        """Difference of the lags under both torques, rad."""
        return self.lag(psi, torque)[0] - self.lag(psi, -torque)[0]


def largest(value: Callable[[Array], Array], positions: int) -> float:
    """Largest value over a turn: of a scan, and closer about its highest summits."""
    step = 2 * math.pi / positions
    places = (np.arange(positions) + 0.25) * step
    heights = value(places)
    tops = np.flatnonzero((heights >= np.roll(heights, 1)) & (heights >= np.roll(heights, -1)))
    tops = tops[np.argsort(-heights[tops])][:NARROWED]
    best, centres = float(heights.max()), places[tops]
    for _ in range(ROUNDS):
        around = centres[:, None] + step * np.linspace(-1, 1, 17)
        found = value(around.ravel()).reshape(around.shape)
        best = max(best, float(found.max()))
        centres, step = around[np.arange(len(around)), found.argmax(axis=1)], step / 8
    return best
