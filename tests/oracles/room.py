"""The room of pins in their holes by plain distances: nothing of core, no arcs.

The lag is scanned and nested about its best places, the turn likewise.
"""

import cmath
import math
from collections.abc import Callable
from dataclasses import dataclass


@dataclass(frozen=True)
class Sizes:
    """A mechanism in SI units; deviations by the names of the service's, zeros where absent."""

    pins: int
    cranks: tuple[float, ...]
    ratio: float
    radius: float
    pin: float
    eccentricity: float
    hole: float
    off: dict

    def _of(self, name: str, j: int, n: int) -> float:
        values = self.off.get(name)
        if not values:
            return 0.0
        if name.startswith("hole"):
            return values[j][n]
        return values[n] if name.startswith("pin") else values[j]

    def left(self, wave: float, lag: float) -> float:
        """What is left to the tightest pin: its hole's radius less its own and their distance."""
        least = math.inf
        for j, start in enumerate(self.cranks):
            own = self.eccentricity + self._of("eccentricity", j, 0)
            ahead = self._of("crank_phase", j, 0)
            angle = wave + start + ahead
            crank = own * complex(math.sin(angle), math.cos(angle))
            turned = cmath.exp(1j * (self._of("disc_phase", j, 0) + ahead / self.ratio))
            for n in range(self.pins):
                place = 1j * cmath.exp(2j * math.pi * n / self.pins)

                def on(kind: str, j: int = j, n: int = n) -> complex:
                    outward = self.radius + self._of(f"{kind}_radial", j, n)
                    return outward + 1j * self._of(f"{kind}_tangential", j, n)

                pin = on("pin") * place * cmath.exp(-1j * lag)
                hole = on("hole") * place * turned + crank
                room = self.hole + self._of("hole_radius", j, n)
                room -= self.pin + self._of("pin_radius", j, n)
                least = min(least, room - abs(pin - hole))
        return least


def highest(
    f: Callable[[float], float], low: float, high: float, points: int, rounds: int
) -> tuple[float, float]:
    """Place and height of the largest value: a scan, then closer ones about its three best."""
    best = (low, f(low))
    places = [low + (high - low) * i / (points - 1) for i in range(points)]
    heights = [f(place) for place in places]
    for i in sorted(range(points), key=lambda i: -heights[i])[:3]:
        middle, width = places[i], (high - low) / (points - 1)
        for _ in range(rounds):
            near = [middle + width * k / 4 for k in range(-4, 5)]
            values = [f(place) for place in near]
            top = max(range(9), key=values.__getitem__)
            middle, width = near[top], width / 3
            if values[top] > best[1]:
                best = (near[top], values[top])
    return best


def room(sizes: Sizes, wave: float, far: float) -> float:
    """Room at a wave angle, over lags up to `far` about 0."""
    return highest(lambda lag: sizes.left(wave, lag), -far, far, 41, 24)[1]
