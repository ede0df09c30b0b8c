"""A pin under the forces of a turn: its largest stresses and its worst stress cycle."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from core.arrays import BoolArray, ComplexArray, FloatArray, IntArray
from core.output.pin_beam import PinBeam, section_stress
from core.output.pin_fatigue import FatigueStrength
from core.output.pin_search import (
    CELLS,
    ENOUGH,
    JOINT_ROUNDS,
    JOINT_SMOOTH,
    NARROWER,
    NEAR,
    NEAR_AROUND,
    ROUNDS,
    Measure,
    OfArcs,
    Points,
    climbed,
    first_of,
    highest,
    largest,
    narrowed,
    sampled,
    summits,
)
from core.output.pin_turn import PinTurn, combine
from core.output.sampled_turn import PinSamples

FIRST = np.zeros(1, dtype=np.intp)

Cycle = tuple[float, float, float, float]
"""Largest and least stress, Pa, section, m, and direction, rad."""

Arms = Callable[[FloatArray], tuple[FloatArray, ...]]
"""Of sections: what unit forces of the satellites do there, each with the satellites last."""


@dataclass(frozen=True, slots=True)
class PinLoads:
    """Forces on a pin over a turn."""

    turn: PinTurn | PinSamples  # forces in a unit
    unit: float  # N; negative where they act the other way
    error: float = NEAR  # relative, of samples, at which a search of them ends
    alternates: bool = False  # whether they also act the other way
    pin: int = 1  # from 1
    wave: FloatArray | None = None  # wave angles of samples, rad

    @property
    def closed(self) -> PinTurn | None:
        """The turn, where what is largest over it is known in closed form."""
        turn = self.turn
        return turn if isinstance(turn, PinTurn) and turn.exponent == 1 else None

    @property
    def one_by_one(self) -> bool:
        """Whether no two satellites load the pin at once."""
        return int(np.count_nonzero(self.turn.forces, axis=0).max()) <= 1


@dataclass(frozen=True)
class LoadedPin:
    """A pin as a beam, and where satellites load it."""

    beam: PinBeam  # in its supports
    diameter: float  # d, m
    positions: FloatArray  # middle planes of the satellites, m, shape (K,)

    @property
    def area(self) -> float:
        """Of its section, m^2."""
        return math.pi * self.diameter**2 / 4

    @property
    def modulus(self) -> float:
        """Section modulus W, m^3."""
        return math.pi * self.diameter**3 / 32

    @cached_property
    def ends(self) -> FloatArray:
        """Ends of loads and supports."""
        half = self.beam.contact_length / 2
        ends = np.concatenate(([0.0], self.positions - half, self.positions + half))
        if self.beam.span is not None:
            ends = np.clip(np.append(ends, self.beam.span), None, self.beam.span)
        return np.unique(np.maximum(ends, 0.0))

    @property
    def rooted(self) -> bool:
        """Whether it bends most at its root: a cantilever, whose satellites all push it one way."""
        return self.beam.span is None

    @cached_property
    def bent(self) -> FloatArray:
        """Sections at one of which a load that is alone bends most, m: where it has no shear force,
        and the supports.
        """
        if self.rooted:
            return np.zeros(1)
        shear, _ = self.beam.reactions(self.positions)
        none = self.positions + (shear - 0.5) * self.beam.contact_length
        return np.array([0.0, *none, self.beam.span])

    @cached_property
    def slopes(self) -> FloatArray:
        """Slope at each satellite by a unit of each one's force, rad/N, shape (K, K)."""
        return np.asarray(self.beam.slope(self.positions[:, None], self.positions))

    @cached_property
    def effects(self) -> FloatArray:
        """What a unit of each satellite's force does, K rows each: force, deflection, m, and slope,
        rad, at the satellites; then the mean shear stress at `ends` and the bending stress at
        `bent`, Pa.
        """
        z = self.positions
        return np.concatenate(
            (
                np.eye(len(z)),
                self.beam.deflection(z[:, None], z),
                self.slopes,
                self.shears(self.ends, 1.0),
                self.moments(self.bent, 1.0),
            )
        )

    def stretches(self, convex: bool = True) -> FloatArray:
        """Stretches of the pin that may hold what is largest, shape (2, s).

        Parameters
        ----------
        convex : bool
            Whether that is convex in the moment: between loads, where the moment changes evenly,
            it is largest at an end then.
        """
        if self.rooted:
            return np.zeros((2, 1))
        low, high = self.ends[:-1], self.ends[1:]
        if convex:
            middle, half = (low + high) / 2, float(self.beam.contact_length) / 2
            loaded = (np.abs(middle[:, None] - self.positions) < half).any(axis=1)
            ends = self.ends[[0, -1]]
            low, high = (np.concatenate((each[loaded], ends)) for each in (low, high))
        return np.array([low, high])

    def moments(self, x: FloatArray, unit: float) -> FloatArray:
        """Bending stress at sections by a unit of each satellite's force, Pa."""
        found: FloatArray = unit / self.modulus * self.beam.moment(x[..., None], self.positions)
        return found

    def shears(self, x: FloatArray, unit: float) -> FloatArray:
        """Mean shear stress of the same, Pa."""
        found: FloatArray = unit / self.area * self.beam.shear(x[..., None], self.positions)
        return found

    def _curvature(self, loads: PinLoads) -> float:
        """Largest second derivative of the bending stress along the pin."""
        most = float(np.abs(loads.turn.forces).sum(axis=0).max())
        return abs(loads.unit) / self.modulus * most / float(self.beam.contact_length)

    def largest(self, loads: PinLoads) -> FloatArray:
        """Largest `effects` over the turn."""
        return largest(turn=loads.turn, arms=(loads.unit * self.effects,), measure=np.abs)

    def bending(self, loads: PinLoads) -> tuple[float, float]:
        """Largest bending stress of any section, Pa, and the section, m."""
        return self._along(loads, lambda x: (self.moments(x, loads.unit),), np.abs, 0.0)

    def equivalent(self, loads: PinLoads, beyond: float) -> float:
        """Largest equivalent stress of any section, Pa; 0 where it is not beyond one, Pa."""

        def arms(x: FloatArray) -> tuple[FloatArray, ...]:
            return self.moments(x, loads.unit), self.shears(x, loads.unit)

        if self.rooted:  # the shear force is largest there, or before any later load
            found = largest(turn=loads.turn, arms=arms(self.ends[:-1]), measure=_equivalent)
            return float(found.max())
        return self._along(loads, arms, _equivalent, beyond)[0]

    def _along(
        self, loads: PinLoads, arms: Arms, measure: Measure, beyond: float
    ) -> tuple[float, float]:
        """Largest measure of any section, and the section; 0 where it is not beyond a value."""
        turn, curvature = loads.turn, self._curvature(loads)
        samples = turn.forces.reshape(len(self.positions), -1)

        def value(at: Points, rounds: int) -> tuple[FloatArray, FloatArray]:
            if rounds:
                found = largest(turn=turn, arms=arms(at.section), measure=measure, rounds=rounds)
            else:
                sums = (combine(arms=each, forces=samples) for each in arms(at.section))
                found = sampled(turn=turn, values=measure(*sums))
            return found, curvature * at.length**2 / 8

        def climb(points: Points) -> tuple[float, float]:
            if isinstance(turn, PinSamples):
                return float(value(points.of(FIRST), 0)[0][0]), float(points.section[0])
            _, tops = summits(turn=turn, arms=arms(points.section), measure=measure)
            own, summit = points.of(tops.row), OfArcs(turn, tops)
            arms_at = _quadratics(arms, own)

            def near(x: FloatArray, _: FloatArray) -> tuple[FloatArray, BoolArray]:
                along = arms_at(x)

                def measured(forces: ComplexArray) -> FloatArray:
                    return measure(*(combine(arms=each, forces=forces) for each in along))

                _, above, settled = summit.narrow(measured, NARROWER, seen=1)
                return above, settled

            x, _ = climbed(value=near, points=own)
            values = largest(turn=turn, arms=arms(x), measure=measure)
            top = first_of(values=values, section=x)
            return float(values[top]), float(x[top])

        found = highest(
            value=value,
            stretches=self.stretches(),
            enough=loads.error,
            climb=climb,
            size=turn.forces[0].size,
            beyond=beyond,
        )
        return (0.0, 0.0) if found is None else found

    def direction(self, loads: PinLoads, section: float) -> float:
        """Direction of the largest moment of a section, rad."""
        turn = loads.turn
        assert isinstance(turn, PinTurn)
        arms = self.moments(np.array([section]), loads.unit)
        _, tops = summits(turn=turn, arms=(arms,), measure=np.abs)
        summit, each = OfArcs(turn, tops), arms[tops.row]
        for _ in range(ROUNDS):
            values, _, settled = summit.narrow(
                lambda forces: np.abs(combine(arms=each, forces=forces))[:, None], CELLS
            )
            if settled.all():
                break
        moments = combine(arms=each, forces=summit.at(summit.place[:, None]))
        moment = moments[values[:, 0].argmax(), 0]
        return math.atan2(moment.imag, moment.real)

    def cycle(
        self, loads: PinLoads, strength: FatigueStrength, bent: float, beyond: float
    ) -> Cycle | None:
        """The worst stress cycle of any point of the edge.

        Parameters
        ----------
        loads : PinLoads
            Forces that do not also act the other way.
        strength : FatigueStrength
            What it is judged by.
        bent : float
            Largest bending stress, Pa.
        beyond : float
            Utilisation up to which a cycle does not count.

        Returns
        -------
        largest, least : float
            Stress, Pa; None where there is no such cycle.
        section, direction : float
            m, rad.
        """
        turn, closed, curvature = loads.turn, loads.closed, self._curvature(loads)
        steepest = curvature * float(self.beam.contact_length)
        steep = strength.utilisation(curvature, 0.0) + strength.utilisation(0.0, curvature)
        corners = strength.criterion == "fkm_haigh" and bool(
            np.abs(turn.forces).sum(axis=0).min() > 0
        )

        def used(top: FloatArray, bottom: FloatArray) -> FloatArray:
            found: FloatArray = strength.utilisation((top - bottom) / 2, (top + bottom) / 2)
            return found

        def cycles(
            arms: FloatArray, direction: FloatArray, rounds: int | None = None
        ) -> tuple[FloatArray, FloatArray]:
            """Largest and least stress."""
            cosine, sine = np.cos(direction)[:, None], np.sin(direction)[:, None]
            weights = np.concatenate((arms * cosine, arms * sine), axis=1)
            if closed is not None:
                return closed.extremes(weights)
            if rounds == 0:
                samples = turn.forces.reshape(len(self.positions), -1)
                parts = np.concatenate((samples.real, samples.imag))
                stress = combine(arms=weights, forces=parts)
                return sampled(turn=turn, values=stress), -sampled(turn=turn, values=-stress)
            both = (np.concatenate((each, -each)) for each in (arms * cosine, arms * sine))
            found = largest(turn=turn, arms=tuple(both), measure=_ahead, rounds=rounds)
            top, bottom = found.reshape(2, -1)
            return top, -bottom

        def value(at: Points, rounds: int) -> tuple[FloatArray, FloatArray]:
            top, bottom = cycles(self.moments(at.section, loads.unit), at.direction, rounds)
            use = used(top, bottom)
            beside = 2 * math.sin(at.angle / 4) ** 2 / math.cos(at.angle / 2)  # 1/cos(a/2) - 1
            room = steep * at.length**2 / 8 + use * beside
            if corners:
                # its line is less steep beyond R = 0 and R = 0.5: the utilisation may be
                # largest where it has a corner, from which it falls at once
                reach = (bent * at.angle + steepest * at.length) / 2
                corner = np.minimum(abs(bottom), abs(2 * bottom - top) / 3) <= reach
                room = room + corner * (used(top + reach, bottom - reach) - use)
            return use, room

        def at_point(section: float, direction: float) -> Cycle:
            arms = self.moments(np.array([section]), loads.unit)
            (top,), (bottom,) = cycles(arms, np.array([direction]))
            return float(top), float(bottom), section, direction

        def climb(points: Points) -> Cycle:
            if isinstance(turn, PinSamples) or (closed is not None and corners):
                return at_point(float(points.section[0]), float(points.direction[0]))
            if closed is not None:
                arms_near = _quadratics(lambda x: (self.moments(x, loads.unit),), points)

                def near(x: FloatArray, chi: FloatArray) -> tuple[FloatArray, BoolArray]:
                    arms = arms_near(x)[0].reshape(x.size, -1)
                    use = used(*cycles(arms, chi.ravel())).reshape(x.shape)
                    return use, np.ones(len(x), dtype=np.bool_)

                x, chi = climbed(value=near, points=points)
                high, low = cycles(self.moments(x, loads.unit), chi)
                best = first_of(values=used(high, low), section=x)
                return float(high[best]), float(low[best]), float(x[best]), float(chi[best])
            own = self.moments(points.section, loads.unit)
            ahead = [own * f(points.direction)[:, None] for f in (np.cos, np.sin)]
            tops, bottoms = (
                summits(turn=turn, arms=tuple(sign * each for each in ahead), measure=_ahead)[1]
                for sign in (1, -1)
            )
            upper, lower = np.nonzero(tops.row[:, None] == bottoms.row)
            start = points.of(tops.row[upper])
            every = np.arange(len(upper))
            at = turn.at(np.concatenate((tops.arc[upper], bottoms.arc[lower])))
            arms_at = _quadratics(lambda x: (self.moments(x, loads.unit),), start)

            def stresses(
                high: FloatArray, low: FloatArray, x: FloatArray, chi: FloatArray
            ) -> list[FloatArray]:
                """Of both pairs of arcs, shape (rows, m, s, c)."""
                forces = at(np.concatenate((high, low)))
                cosine, sine = (f(chi)[:, None, None, :] for f in (np.cos, np.sin))
                (weights,) = arms_at(x)
                both = forces[: len(high)], forces[len(high) :]
                sums = (
                    combine(arms=weights, forces=each).swapaxes(1, 2)[..., None] for each in both
                )
                return [each.real * cosine + each.imag * sine for each in sums]

            def grid_value(
                high: FloatArray, low: FloatArray, x: FloatArray, chi: FloatArray
            ) -> tuple[FloatArray, list[IntArray]]:
                top, bottom = stresses(high, low, x, chi)
                use = used(top.max(axis=1), bottom.min(axis=1))
                values, (section, direction) = _picked(use, (0, 1))
                at_best = (every, slice(None), section, direction)
                ways = top[at_best].argmax(axis=-1), bottom[at_best].argmin(axis=-1)
                return values, [*ways, section, direction]

            values, places = narrowed(
                value=grid_value,
                places=(tops.place[upper], bottoms.place[lower], start.section, start.direction),
                widths=(
                    tops.width[upper],
                    bottoms.width[lower],
                    start.length,
                    np.full(len(upper), start.angle),
                ),
                limits=((0.0, 1.0), (0.0, 1.0), (start.low, start.high), (-math.inf, math.inf)),
                cells=(CELLS, CELLS, CELLS // 2, CELLS),
                rounds=JOINT_SMOOTH if turn.smooth and not corners else JOINT_ROUNDS,
            )
            best = int(values.argmax())
            return at_point(float(places[2][best]), float(places[3][best]))

        return highest(
            value=value,
            stretches=self.stretches(strength.criterion != "fkm_haigh"),
            around=True,
            enough=ENOUGH if closed is not None and corners else min(loads.error, NEAR_AROUND),
            closed=closed is not None,
            climb=climb,
            size=turn.forces[0].size,
            beyond=beyond,
        )


def _quadratics(arms: Arms, points: Points) -> Arms:
    """The same at sections (rows, s) of the stretches of points: there the line load is even, so
    that moments are quadratic.
    """
    low, high = points.low, points.high
    ends = arms(np.stack((low, (low + high) / 2, high)))
    width = np.where(high > low, high - low, 1.0)[:, None]

    def within(x: FloatArray) -> tuple[FloatArray, ...]:
        t = ((x - low[:, None]) / width)[..., None]
        parts = (1 - t) * (1 - 2 * t), 4 * t * (1 - t), t * (2 * t - 1)
        return tuple(
            sum(part * each[:, None] for part, each in zip(parts, values, strict=True))
            for values in ends
        )

    return within


def _picked(values: FloatArray, axes: Sequence[int]) -> tuple[FloatArray, list[IntArray]]:
    """Largest value of each row of (rows, a, b), and where; of values alike the first."""
    flat = values.reshape(len(values), -1)
    index = flat.argmax(axis=1)
    places = np.unravel_index(index, values.shape[1:])
    return flat[np.arange(len(flat)), index], [places[axis] for axis in axes]


def _equivalent(bending: ComplexArray, mean_shear: ComplexArray) -> FloatArray:
    found: FloatArray = section_stress(bending=bending, mean_shear=mean_shear)
    return found


def _ahead(cosine: ComplexArray, sine: ComplexArray) -> FloatArray:
    """What sums with the cosines and the sines of a direction are along it."""
    return np.asarray(cosine.real + sine.imag)
