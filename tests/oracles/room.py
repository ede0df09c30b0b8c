"""The room of pins in their holes by plain distances: nothing of core, no arcs.

The lag is scanned and nested about its best places, the turn likewise.
"""

import cmath
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np


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
        """Room of the tightest pin: hole radius less pin radius less their distance."""
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


def golden(f: Callable[[float], float], low: float, high: float, times: int) -> float:
    """Height of the one summit between two places."""
    part = (math.sqrt(5) - 1) / 2
    first, second = high - part * (high - low), low + part * (high - low)
    one, two = f(first), f(second)
    for _ in range(times):
        if one > two:
            high, second, two = second, first, one
            first = high - part * (high - low)
            one = f(first)
        else:
            low, first, one = first, second, two
            second = low + part * (high - low)
            two = f(second)
    return max(one, two)


def room_in_ring(
    sizes: Sizes, wave: float, turned: Sequence[tuple[float, float]], far: float
) -> float:
    """Room at a wave angle of discs that turn back about their own centres, each from and to where
    is said, over lags of the output up to `far`: all lags of a disc are looked at, ever closer.
    """
    discs = []
    for j, ends in enumerate(turned):
        own = sizes.eccentricity + sizes._of("eccentricity", j, 0)
        ahead = sizes._of("crank_phase", j, 0)
        angle = wave + sizes.cranks[j] + ahead
        turns = np.exp(1j * (sizes._of("disc_phase", j, 0) + ahead / sizes.ratio))
        rows = []
        for n in range(sizes.pins):
            place = 1j * np.exp(2j * np.pi * n / sizes.pins)
            pin = (
                sizes.radius
                + sizes._of("pin_radial", j, n)
                + 1j * sizes._of("pin_tangential", j, n)
            )
            hole = sizes.radius + sizes._of("hole_radial", j, n)
            hole = (hole + 1j * sizes._of("hole_tangential", j, n)) * turns
            gap = sizes.hole + sizes._of("hole_radius", j, n)
            gap -= sizes.pin + sizes._of("pin_radius", j, n)
            rows.append((pin * place, hole * place, gap))
        pins, holes, gaps = map(np.array, zip(*rows, strict=True))
        discs.append((ends, own * 1j * np.exp(-1j * angle), pins, holes, gaps.real))

    def most(lag: float) -> float:
        worst = math.inf
        for (low, high), crank, pins, holes, gaps in discs:
            best, apart = -math.inf, pins * np.exp(-1j * lag) - crank
            for _ in range(10):
                own = np.linspace(low, high, 17)
                left = gaps - abs(apart - holes * np.exp(-1j * own)[:, None])
                heights = left.min(axis=1)
                top = int(heights.argmax())
                best = max(best, float(heights[top]))
                low, high = own[max(top - 1, 0)], own[min(top + 1, 16)]
            worst = min(worst, best)
        return worst

    return golden(most, -far, far, 44)
