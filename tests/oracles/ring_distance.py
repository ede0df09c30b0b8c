"""How far the pins of a ring stand from the discs, by a search of the nearest point of each path.

Nothing is shared with ``core``: points of the path are looked at over more than a lobe to either
side, and of the nearest Newton's method makes the foot. So no pin is too far off, or moved too far.
"""

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

POINTS = 241
"""Points of a path that are looked at, over 2.4 pitches of its lobes."""

LAGS = 161
"""Lags between which what is least or touches first is sought."""

Floats = NDArray[np.float64]


class Distances:
    """Approaches of all pins at a crank angle, by the lag of the discs."""

    def __init__(self, mesh: Any, crank_angle: float) -> None:
        disc, own = mesh.disc, mesh.deviations
        self.lobes, self.eccentricity = disc.satellite_teeth, disc.eccentricity
        pins = self.lobes + 1
        self.circle = disc.ring_pin_circle_radius + disc.modification.pin_circle
        self.tool = disc.ring_pin_radius + disc.modification.equidistant
        count = len(mesh.crank_angles)

        def errors(name: str, number: int) -> Floats:
            return np.array(getattr(own, name) or (0.0,) * number, dtype=float)

        ahead, late = errors("crank_phase", count), errors("disc_phase", count)
        crank = crank_angle + np.array(mesh.crank_angles) + ahead
        self.radius = disc.ring_pin_radius + errors("pin_radius", pins)
        place = disc.ring_pin_circle_radius + errors("pin_radial", pins)
        place = place + 1j * errors("pin_tangential", pins)
        place = 1j * np.exp(2j * np.pi * np.arange(pins) / pins) * place
        arm = 1j * (self.eccentricity + errors("eccentricity", count)) * np.exp(-1j * crank)
        self.seen = place - arm[:, None]
        self.turned = crank / self.lobes - late - ahead / self.lobes

    def _path(self, t: Any, power: int = 0) -> Any:
        """The tool's path, or its derivatives."""
        pins = self.lobes + 1
        turning = self.circle * np.exp(-1j * t)
        return (
            1j
            * (-1j) ** power
            * (turning - pins**power * self.eccentricity * np.exp(-1j * pins * t))
        )

    def at(self, lag: float) -> tuple[Floats, Floats]:
        """Approaches, [K, z_p], and their derivatives by the lag."""
        points = self.seen * np.exp(-1j * (self.turned - lag))[:, None]
        off = np.linspace(-1.2, 1.2, POINTS) * 2 * np.pi / self.lobes
        t = (np.pi / 2 - np.angle(points))[..., None] + off
        near = np.abs(self._path(t) - points[..., None]).argmin(axis=-1)
        foot = np.take_along_axis(t, near[..., None], axis=-1)[..., 0]
        for _ in range(12):
            apart, way = points - self._path(foot), self._path(foot, 1)
            rises = (apart * np.conj(way)).real
            bends = np.abs(way) ** 2 - (apart * np.conj(self._path(foot, 2))).real
            step = np.where(bends > 0, rises / np.where(bends > 0, bends, 1.0), 0.0)
            foot = foot + np.clip(step, off[0] - off[1], off[1] - off[0])
        way = self._path(foot, 1)
        normal = 1j * way / np.abs(way)
        far = ((points - self._path(foot)) * np.conj(normal)).real
        return self.radius - self.tool - far, -(1j * points * np.conj(normal)).real

    def worst(self, lag: float) -> float:
        """Largest approach."""
        return float(self.at(lag)[0].max())

    def torque(self, lag: float, stiffness: float) -> float:
        """Torque of linear contacts."""
        approach, lever = self.at(lag)
        return float((stiffness * np.maximum(approach, 0.0) * lever).sum())

    def freest(self) -> tuple[float, float]:
        """The lag within a quarter of a pitch at which the largest approach is least, and that."""
        far = math.pi / 2 / self.lobes
        lags = np.linspace(-far, far, LAGS)
        worst = np.array([self.worst(float(lag)) for lag in lags])
        found = []
        for i in range(1, LAGS - 1):
            if worst[i] <= min(worst[i - 1], worst[i + 1]):
                low, high = float(lags[i - 1]), float(lags[i + 1])
                for _ in range(90):  # golden section
                    first = high - (high - low) * (math.sqrt(5) - 1) / 2
                    second = low + high - first
                    low, high = (low, second) if self.worst(first) < self.worst(second) else (
                        first, high
                    )  # fmt: skip
                found.append((self.worst((low + high) / 2), (low + high) / 2))
        least, lag = min(found)
        return lag, least

    def play(self) -> tuple[float, float] | None:
        """Lags at which a pin touches first either way; None where some press at any."""
        free, least = self.freest()
        if least > 0:
            return None
        step, ends = math.pi / 2 / self.lobes / LAGS, []
        for way in (-1, 1):
            low, high = free, free + way * step
            while self.worst(high) <= 0:
                low, high = high, high + way * step
            for _ in range(60):
                between = (low + high) / 2
                low, high = (between, high) if self.worst(between) <= 0 else (low, between)
            ends.append(low)
        return ends[0], ends[1]
