"""The worst stress cycle of a pin: of all sections and all directions around them.

The stress at a point of the edge is largest at one place of the turn and least at another. A pair
of them is followed while section and direction move, each pair that may be the worst anywhere near.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from core.arrays import BoolArray, ComplexArray, FloatArray
from core.errors import derived
from core.output.pin_fatigue import FatigueStrength
from core.output.pin_search import (
    NARROWER,
    NEAR,
    NEAR_AROUND,
    REACHED,
    OfArcs,
    Points,
    Summits,
    climbed,
    first_of,
    highest,
    largest,
    quadratics,
    sampled,
    summits,
)
from core.output.pin_turn import PinTurn, combine
from core.output.sampled_turn import PinSamples

SECANTS = 5
"""Steps to a direction in which the stress cycle has a given ratio."""

CORNERS = 0.0, 0.5
"""Least over largest stress at which the line of the FKM guideline has corners."""

ON_CORNERS, ALONG_CORNERS = 4, 6
"""Most points from which the worst cycle on a corner is looked for, and rounds along the pin."""

Cycle = tuple[float, float, float, float]
"""Largest and least stress, Pa, section, m, and direction, rad."""


@dataclass(frozen=True)
class StressCycles:
    """Stress cycles of the points of a pin's edge."""

    turn: PinTurn | PinSamples  # forces in a unit, that do not also act the other way
    moments: Callable[[FloatArray], FloatArray]  # bending stress by that unit of each force, Pa
    strength: FatigueStrength  # what they are judged by
    bent: float  # largest bending stress, Pa
    curvature: float  # largest second derivative of it along the pin, Pa/m^2
    contact_length: float  # m
    error: float  # relative, of samples, at which a search of them ends

    @property
    def closed(self) -> bool:
        """Whether what is largest over the turn is known in closed form."""
        return isinstance(self.turn, PinTurn) and self.turn.exponent == 1

    @property
    def corners(self) -> bool:
        """Whether the utilisation may be largest at a corner of its line, from which it falls at
        once: that is less steep beyond R = 0 and R = 0.5.
        """
        loaded = np.abs(self.turn.forces).sum(axis=0).min() > 0
        return self.strength.criterion == "fkm_haigh" and bool(loaded)

    def worst(self, stretches: FloatArray, beyond: float) -> Cycle | None:
        """The worst cycle.

        Parameters
        ----------
        stretches : array, shape (2, s)
            Ends of the stretches of the pin that may hold it, m.
        beyond : float
            Utilisation up to which a cycle does not count.

        Returns
        -------
        tuple of float or None
            None where there is no such cycle.
        """
        corners, unit = self.corners, self.strength.utilisation
        steep = unit(self.curvature, 0.0) + unit(0.0, self.curvature)
        steepest = self.curvature * self.contact_length

        def beside(use: FloatArray, at: Points) -> FloatArray:
            """How much higher the utilisation may be half the way to the next points."""
            turned = 2 * math.sin(at.angle / 4) ** 2 / math.cos(at.angle / 2)  # 1/cos(a/2) - 1
            found: FloatArray = steep * at.length**2 / 8 + use * turned
            return found

        def value(at: Points, rounds: int) -> tuple[FloatArray, FloatArray, FloatArray]:
            top, bottom = self._ends(self.moments(at.section), at.direction, rounds)
            use = self._used(top, bottom)
            room = left = beside(use, at)
            if corners:
                reach = (self.bent * at.angle + steepest * at.length) / 2
                corner = np.minimum(abs(bottom), abs(2 * bottom - top) / 3) <= reach
                beyond = corner * (self._used(top + reach, bottom - reach) - use)
                room, left = room + beyond, room + beyond * (NEAR_AROUND / NEAR)
            return use, room, left

        def climb(points: Points) -> Cycle:
            if isinstance(self.turn, PinSamples):
                x, chi = points.section[:1], points.direction[:1]
            else:
                pairs = self._pairs(self.turn, points, lambda use: REACHED * beside(use, points))
                x, chi = self._risen(
                    points, pairs, *self._followed(points, OfArcs(self.turn, pairs))
                )
            if corners:
                places = (x, chi), self._on_corners(points.of(np.s_[:ON_CORNERS]))
                x, chi = (np.concatenate(each) for each in zip(*places, strict=True))
            top, bottom = self._ends(self.moments(x), chi)
            best = first_of(values=self._used(top, bottom), section=x)
            return float(top[best]), float(bottom[best]), float(x[best]), float(chi[best])

        return highest(
            value=value,
            stretches=stretches,
            around=True,
            enough=min(self.error, NEAR_AROUND),
            closed=self.closed,
            climb=climb,
            size=self.turn.forces[0].size,
            beyond=beyond,
        )

    def _used(self, top: FloatArray, bottom: FloatArray) -> FloatArray:
        found: FloatArray = self.strength.utilisation((top - bottom) / 2, (top + bottom) / 2)
        return found

    @derived
    def _parts(self) -> FloatArray:
        """Forces of the satellites at the samples, along both axes, [2*K, m]."""
        samples = self.turn.forces.reshape(len(self.turn.forces), -1)
        return np.concatenate((samples.real, samples.imag))

    def _ends(
        self, arms: FloatArray, direction: FloatArray, rounds: int | None = None
    ) -> tuple[FloatArray, FloatArray]:
        """Largest and least stress of sections in directions."""
        cosine, sine = np.cos(direction)[:, None], np.sin(direction)[:, None]
        weights = np.concatenate((arms * cosine, arms * sine), axis=1)
        turn = self.turn
        if isinstance(turn, PinTurn) and self.closed:
            return turn.extremes(weights)
        if rounds == 0 or isinstance(turn, PinSamples):
            stress = combine(arms=weights, forces=self._parts)
            if isinstance(turn, PinSamples):  # nothing lies between
                return stress.max(axis=1), stress.min(axis=1)
            return sampled(turn=turn, values=stress), -sampled(turn=turn, values=-stress)
        both = (np.concatenate((each, -each)) for each in (arms * cosine, arms * sine))
        found = largest(turn=self.turn, arms=tuple(both), measure=_ahead, rounds=rounds)
        top, bottom = found.reshape(2, -1)
        return top, -bottom

    def _pairs(
        self, turn: PinTurn, points: Points, lower: Callable[[FloatArray], FloatArray]
    ) -> Summits:
        """Where over the turn the stress is largest, and then where its opposite is, in all pairs
        that are no more than so much lower at the points than the worst one.
        """
        own = self.moments(points.section)
        ahead = [own * f(points.direction)[:, None] for f in (np.cos, np.sin)]
        (most, tops), (least, bottoms) = (
            summits(
                turn=turn, arms=tuple(sign * each for each in ahead), measure=_ahead, lower=np.inf
            )
            for sign in (1, -1)
        )
        worst = self._used(most, -least)
        enough = worst - lower(worst)
        use = self._used(tops.height, -least[tops.row])
        tops = tops.of(np.flatnonzero(use >= enough[tops.row]))
        use = self._used(most[bottoms.row], -bottoms.height)
        bottoms = bottoms.of(np.flatnonzero(use >= enough[bottoms.row]))
        upper, under = np.nonzero(tops.row[:, None] == bottoms.row)
        tops, bottoms = tops.of(upper), bottoms.of(under)
        kept = np.flatnonzero(self._used(tops.height, -bottoms.height) >= enough[tops.row])
        return tops.of(kept).before(bottoms.of(kept))

    def _followed(self, points: Points, pairs: OfArcs) -> tuple[FloatArray, FloatArray]:
        """Sections and directions at which pairs are worst."""
        start = points.of(pairs.row[: len(pairs.row) // 2])
        arms_near = quadratics(arms=lambda x: (self.moments(x),), points=start)

        def near(x: FloatArray, chi: FloatArray) -> tuple[FloatArray, BoolArray]:
            ahead = arms_near(x)[0] * np.exp(-1j * chi)[..., None]
            arms = np.concatenate((ahead, -ahead))

            def stress(forces: ComplexArray) -> FloatArray:
                return np.asarray(combine(arms=arms, forces=forces).real)

            _, above, left = pairs.narrow(stress, NARROWER, seen=x.shape[1] // 2)
            use = self._used(above[: len(x)], -above[len(x) :])
            return use, (left.reshape(2, -1) == 0).all(axis=0)

        return climbed(value=near, points=start)

    def _risen(
        self, points: Points, pairs: Summits, x: FloatArray, chi: FloatArray
    ) -> tuple[FloatArray, FloatArray]:
        """The worst of these sections and directions, and where the cycle itself is worst near it:
        of high exponents the pair that was followed is not always that of the extremes.
        """

        def cycle(sections: FloatArray, directions: FloatArray) -> tuple[FloatArray, BoolArray]:
            within = np.clip(sections, start.low[:, None], start.high[:, None])
            use = self._used(*self._ends(self.moments(within.ravel()), directions.ravel()))
            return use.reshape(sections.shape), np.ones(len(sections), dtype=np.bool_)

        best = [first_of(values=self._used(*self._ends(self.moments(x), chi)), section=x)]
        start = points.of(pairs.row[best])
        near = replace(
            start,
            section=x[best],
            direction=chi[best],
            length=start.length / NARROWER,
            angle=start.angle / NARROWER,
        )
        other = climbed(value=cycle, points=near)
        return np.append(x[best], other[0]), np.append(chi[best], other[1])

    def _on_corners(self, points: Points) -> tuple[FloatArray, FloatArray]:
        """Sections and directions at which cycles at the nearest corner are worst."""
        chi, angle = points.direction, points.angle
        top, bottom = self._ends(self.moments(points.section), chi)
        ratio = np.where(np.abs(bottom) < np.abs(2 * bottom - top), *CORNERS)

        def at_corner(x: FloatArray, _: FloatArray) -> tuple[FloatArray, BoolArray]:
            nonlocal chi
            many = x.shape[1]
            arms, own = self.moments(x.ravel()), np.repeat(ratio, many)

            def off(direction: FloatArray) -> FloatArray:
                top, bottom = self._ends(arms, direction)
                return bottom - own * top

            one = np.repeat(chi, many)
            other, before = one + angle, off(one)
            for _step in range(SECANTS):
                after = off(other)
                change = np.where(after == before, np.inf, after - before)
                one, other, before = other, other - after * (other - one) / change, after
            chi = other.reshape(x.shape)[:, many // 2]
            use = self._used(*self._ends(arms, other))
            return use.reshape(x.shape), np.ones(len(x), dtype=np.bool_)

        points = replace(points, angle=0.0)
        x, _ = climbed(value=at_corner, points=points, rounds=ALONG_CORNERS)
        at_corner(x[:, None], chi)
        return x, chi


def _ahead(cosine: ComplexArray, sine: ComplexArray) -> FloatArray:
    """What sums with the cosines and the sines of a direction are along it."""
    return np.asarray(cosine.real + sine.imag)
