"""A pin under the forces of a turn: its largest stresses and its worst stress cycle."""

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from core.arrays import BoolArray, ComplexArray, FloatArray
from core.output.pin_beam import PinBeam, section_stress
from core.output.pin_cycle import Cycle, StressCycles
from core.output.pin_fatigue import FatigueStrength
from core.output.pin_search import (
    CELLS,
    NARROWER,
    NEAR,
    REACHED,
    ROUNDS,
    Arms,
    Measure,
    OfArcs,
    Points,
    climbed,
    first_of,
    highest,
    largest,
    quadratics,
    sampled,
    summits,
)
from core.output.pin_section import PinSection
from core.output.pin_turn import PinTurn, combine
from core.output.sampled_turn import PinSamples

FIRST = np.zeros(1, dtype=np.intp)


@dataclass(frozen=True, slots=True)
class PinLoads:
    """Forces on a pin over a turn."""

    turn: PinTurn | PinSamples  # forces in a unit
    unit: float  # N; negative where they act the other way
    error: float = NEAR  # relative, of samples, at which a search of them ends
    alternates: bool = False  # whether they also act the other way
    pin: int = 1  # from 1

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
    bore_diameter: float = 0.0  # d_i, m

    @cached_property
    def section(self) -> PinSection:
        """Its section."""
        return PinSection(self.diameter, self.bore_diameter)

    @cached_property
    def area(self) -> float:
        """Area over which a shear force has 3/4 of its largest stress as its mean, m^2."""
        return float(self.section.shear_area)

    @cached_property
    def modulus(self) -> float:
        """Section modulus W, m^3."""
        return float(self.section.modulus)

    @cached_property
    def ends(self) -> FloatArray:
        """Ends of loads and supports."""
        half = self.beam.contact_length / 2
        ends = np.concatenate(([0.0], self.positions - half, self.positions + half))
        if not self.rooted:
            ends = np.clip(np.append(ends, self.beam.span), None, self.beam.span)
        return np.unique(np.maximum(ends, 0.0))

    @property
    def rooted(self) -> bool:
        """Whether it bends most at its root: a cantilever, whose satellites all push it one way."""
        return self.beam.rooted

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

    def by_unit(self, what: str, x: FloatArray) -> FloatArray:
        """What a unit of each load does at sections, by its name of `PinBeam`, shape (..., K)."""
        return np.asarray(getattr(self.beam, what)(x[..., None], self.positions))

    @cached_property
    def slopes(self) -> FloatArray:
        """Slope at each satellite by a unit of each load, rad/N, shape (K, K)."""
        return self.by_unit("slope", self.positions)

    @cached_property
    def effects(self) -> FloatArray:
        """What a unit of each load does, K rows each: force, deflection, m, and slope, rad, at the
        satellites; then the mean shear stress at `ends` and the bending stress at `bent`, Pa.
        """
        return np.concatenate(
            (
                np.eye(*self.slopes.shape),
                self.by_unit("deflection", self.positions),
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
        """Bending stress at sections by a unit of each load, Pa."""
        found: FloatArray = unit / self.modulus * self.by_unit("moment", x)
        return found

    def shears(self, x: FloatArray, unit: float) -> FloatArray:
        """Mean shear stress of the same, Pa."""
        found: FloatArray = unit / self.area * self.by_unit("shear", x)
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
        samples = turn.forces.reshape(len(turn.forces), -1)

        def room(at: Points) -> FloatArray:
            return curvature * at.length**2 / 8

        def value(at: Points, rounds: int) -> tuple[FloatArray, FloatArray, FloatArray]:
            if rounds:
                found = largest(turn=turn, arms=arms(at.section), measure=measure, rounds=rounds)
            else:
                sums = (combine(arms=each, forces=samples) for each in arms(at.section))
                found = sampled(turn=turn, values=measure(*sums))
            return found, room(at), room(at)

        def climb(points: Points) -> tuple[float, float]:
            if isinstance(turn, PinSamples):
                return float(value(points.of(FIRST), 0)[0][0]), float(points.section[0])
            own, lower = arms(points.section), REACHED * room(points)
            _, tops = summits(turn=turn, arms=own, measure=measure, lower=lower)
            start, summit = points.of(tops.row), OfArcs(turn, tops)
            arms_at = quadratics(arms=arms, points=start)

            def near(x: FloatArray, _: FloatArray) -> tuple[FloatArray, BoolArray]:
                along = arms_at(x)

                def measured(forces: ComplexArray) -> FloatArray:
                    return measure(*(combine(arms=each, forces=forces) for each in along))

                _, above, left = summit.narrow(measured, NARROWER, seen=1)
                return above, left == 0

            x, _ = climbed(value=near, points=start)
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
            values, _, left = summit.narrow(
                lambda forces: np.abs(combine(arms=each, forces=forces))[:, None], CELLS
            )
            if not left.any():
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
        cycles = StressCycles(
            turn=loads.turn,
            moments=lambda x: self.moments(x, loads.unit),
            strength=strength,
            bent=bent,
            curvature=self._curvature(loads),
            contact_length=float(self.beam.contact_length),
            error=loads.error,
        )
        return cycles.worst(self.stretches(strength.criterion != "fkm_haigh"), beyond)


def _equivalent(bending: ComplexArray, mean_shear: ComplexArray) -> FloatArray:
    found: FloatArray = section_stress(bending=bending, mean_shear=mean_shear)
    return found
