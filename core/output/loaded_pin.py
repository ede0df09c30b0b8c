"""Largest stresses and worst stress cycle of a pin under the forces of a turn."""

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from core.arrays import FloatArray, Number
from core.numerics.extremes import zoom
from core.output.pin_beam import PinBeam, section_stress
from core.output.pin_fatigue import FatigueStrength
from core.output.pin_section import PinSection
from core.output.sampled_turn import PinForces, PinSamples
from core.output.worst_section import Cells, Place, largest_of_cells, settled

ROUGH, FEWER = 2e-7, 2e-5
"""Part by which the worst cycle of a rough search may be too small, and largest distance over the
largest force at which that search leaves out samples near the line between their neighbours."""

NEARLY, FEW = 0.98, 8
"""Corners of a strength line are searched where a stretch comes to 0.98 of the worst utilisation,
first among every eighth sample."""


class Cycle(NamedTuple):
    """Worst stress cycle of a pin's edge."""

    largest: float  # stress, Pa
    least: float  # stress, Pa
    section: float  # distance from the carrier's face, m
    direction: float  # direction around the pin, rad


@dataclass(frozen=True, slots=True)
class PinLoads:
    """Forces on a pin over a turn."""

    turn: PinSamples  # forces at samples
    pin: int = 1  # from 1

    @property
    def one_by_one(self) -> bool:
        """True if no two satellites load the pin at once."""
        return int(np.count_nonzero(self.turn.forces, axis=0).max()) <= 1


@dataclass(frozen=True)
class LoadedPin:
    """Pin as a beam, and the places at which satellites load it."""

    beam: PinBeam  # pin in its supports
    diameter: float  # d, m
    positions: FloatArray  # middle planes of the satellites, m, shape (K,)
    bore_diameter: float = 0.0  # d_i, m

    @cached_property
    def section(self) -> PinSection:
        """Section of the pin."""
        return PinSection(self.diameter, self.bore_diameter)

    @cached_property
    def area(self) -> float:
        """Area, m^2, over which a shear force has a mean stress of 3/4 of its largest stress."""
        return float(self.section.shear_area)

    @cached_property
    def modulus(self) -> float:
        """Section modulus W, m^3."""
        return float(self.section.modulus)

    @cached_property
    def ends(self) -> FloatArray:
        """Ends of loads and supports along the pin, m, ascending."""
        half = self.beam.contact_length / 2
        ends = np.concatenate(([0.0], self.positions - half, self.positions + half))
        if not self.rooted:
            ends = np.clip(np.append(ends, self.beam.span), None, self.beam.span)
        return np.unique(np.maximum(ends, 0.0))

    @property
    def rooted(self) -> bool:
        """True for a cantilever, which bends most at its root under loads of one direction."""
        return self.beam.rooted

    @cached_property
    def bent(self) -> FloatArray:
        """Sections at one of which a single load bends the pin most, m: sections without shear
        force, and supports.
        """
        if self.rooted:
            return np.zeros(1)
        shear, _ = self.beam.reactions(self.positions)
        none = self.positions + (shear - 0.5) * self.beam.contact_length
        return np.array([0.0, *none, self.beam.span])

    def held(self, turn: PinForces) -> PinForces:
        """Forces over a turn with those of what joins the pins' ends: here of nothing."""
        return turn

    def by_unit(self, what: str, x: FloatArray) -> FloatArray:
        """Result of a `PinBeam` method at sections by a unit of each load, shape (..., K)."""
        return np.asarray(getattr(self.beam, what)(x[..., None], self.positions))

    @cached_property
    def slopes(self) -> FloatArray:
        """Slope at each satellite by a unit of each load, rad/N, shape (K, K)."""
        return self.by_unit("slope", self.positions)

    @cached_property
    def effects(self) -> FloatArray:
        """Effects of a unit of each load in rows: K forces, K deflections, m, and K slopes, rad, at
        the satellites; then mean shear stresses at `ends` and bending stresses at `bent`, Pa.
        """
        return np.concatenate(
            (
                np.eye(*self.slopes.shape),
                self.by_unit("deflection", self.positions),
                self.slopes,
                self.shears(self.ends),
                self.moments(self.bent),
            )
        )

    def stretches(self, convex: bool = True) -> FloatArray:
        """Stretches of the pin that may hold the largest value, m, shape (2, s): only loaded ones
        and the ends of the pin for a value that is convex in the moment.
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

    def moments(self, x: FloatArray) -> FloatArray:
        """Bending stress at sections by a unit of each load, Pa."""
        found: FloatArray = self.by_unit("moment", x) / self.modulus
        return found

    def shears(self, x: FloatArray) -> FloatArray:
        """Mean shear stress at sections by a unit of each load, Pa."""
        found: FloatArray = self.by_unit("shear", x) / self.area
        return found

    def changes(self, turn: PinSamples) -> tuple[float, float]:
        """Bounds of the second and the first derivative of the bending stress along the pin."""
        most = float(np.abs(turn.forces).sum(axis=0).max()) / self.modulus
        return most / float(self.beam.contact_length), most

    def largest(self, loads: PinLoads) -> FloatArray:
        """Largest size of each of `effects` over the turn."""
        return loads.turn.largest(np.abs(loads.turn.sums(self.effects)))

    def bending(self, loads: PinLoads) -> Place:
        """Largest bending stress of any section, Pa, and its place."""
        found = self._along(loads, lambda turn, x: np.abs(turn.sums(self.moments(x))), 0.0)
        assert found is not None
        return found

    def equivalent(self, loads: PinLoads, beyond: float) -> float:
        """Largest equivalent stress, Pa; between two supports `beyond` if none is larger."""

        def stress(turn: PinSamples, x: FloatArray) -> FloatArray:
            sums = turn.sums(self.moments(x)), turn.sums(self.shears(x))
            return np.asarray(section_stress(bending=sums[0], mean_shear=sums[1]))

        if self.rooted:  # the shear force is largest there, or before any later load
            return float(loads.turn.largest(stress(loads.turn, self.ends[:-1])).max())
        found = self._along(loads, stress, beyond)
        return beyond if found is None else found.value

    def _along(
        self,
        loads: PinLoads,
        measure: Callable[[PinSamples, FloatArray], FloatArray],
        beyond: float,
    ) -> Place | None:
        """Largest measure of any section over the turn; None if none is larger than `beyond`."""
        turn, (curvature, steepest) = loads.turn.loaded, self.changes(loads.turn)

        def value(at: Cells) -> tuple[FloatArray, FloatArray]:
            found = turn.largest(measure(turn, at.section))
            return found, found + curvature * at.length**2 / 8

        def near(at: Cells) -> None:
            nonlocal turn
            values = measure(turn, at.section)
            reach = (steepest * at.length)[:, None]
            turn = turn.only((values >= values.max(axis=1, keepdims=True) - reach).any(axis=0))

        ends = self.stretches()
        found = largest_of_cells(value=value, near=near, stretches=ends, beyond=beyond)
        turn = loads.turn
        return found and settled(value=value, found=found, stretches=ends)

    def cycle(self, loads: PinLoads, strength: FatigueStrength, beyond: float) -> Cycle | None:
        """Worst stress cycle at any point of the edge; None if no utilisation is above `beyond`."""
        stretches = self.stretches(convex=strength.criterion != "fkm_haigh")
        search = _CycleSearch(self, loads.turn, strength)
        found = search.worst(stretches, beyond)
        if found is None:
            return None
        if search.corners and not self.rooted:
            found = search.along_corners(stretches, found)
        return search.cycle(found)


class _CycleSearch:
    """Search for the worst cycle of a pin's edge over sections and directions."""

    def __init__(self, pin: LoadedPin, turn: PinSamples, strength: FatigueStrength) -> None:
        self.pin, self.turn, self.strength = pin, turn, strength
        # The FKM guideline's strength line has corners: it is less steep beyond R = 0 and R = 0.5.
        always = bool(turn.forces.any(axis=0).all())
        self.corners = strength.criterion == "fkm_haigh" and always
        self.left = self.rough = turn.thinned(FEWER).loaded
        self.curvature, self.steepest = pin.changes(turn)
        self.steep = self._used(self.curvature, 0.0) + self._used(0.0, -self.curvature)

    def worst(self, stretches: FloatArray, beyond: float) -> Place | None:
        """Worst place of stretches beyond a utilisation; approximate beside a corner."""
        self.left = self.rough
        about = largest_of_cells(
            value=self.value,
            near=self.near,
            stretches=stretches,
            directions=(0.0, 2 * math.pi),
            beyond=beyond,
            enough=ROUGH,
        )
        if about is None:
            return None
        x, chi = about.section, about.direction
        angle = 3 * math.sqrt(8 * ROUGH)
        length = 3 * math.sqrt(8 * ROUGH * about.value / self.steep)
        ends = np.clip(np.array([[x - length], [x + length]]), stretches.min(), stretches.max())
        self.left = self.turn.loaded
        self.near(Cells(np.array([x]), np.array([chi]), np.array([2 * length]), 2 * angle))
        found = largest_of_cells(
            value=self.value,
            near=self.near,
            stretches=ends,
            directions=(chi - angle, 2 * angle),
            beyond=0.0,
        )
        self.left = self.turn
        return found and settled(value=self.value, found=found, stretches=stretches)

    def along_corners(self, stretches: FloatArray, found: Place) -> Place:
        """Worst place where the strength line may have a corner, from which utilisation falls off
        steeply: the worst section, each by its worst direction, first among a few samples.
        """
        for stretch in stretches[:, stretches[1] > stretches[0]].T:
            about = self.worst(stretch[:, None], NEARLY * found.value)
            if about is not None:
                few = self.about_corner(
                    about, stretch, self.turn.of(np.arange(0, len(self.turn.wave), FEW)), 0.25, 0.3
                )
                every = self.about_corner(few, stretch, self.turn, 0.02, 0.02)
                found = max(found, about, every)
        return found

    def about_corner(
        self, about: Place, stretch: FloatArray, turn: PinSamples, part: float, angle: float
    ) -> Place:
        """Worst place within a part of its stretch and an angle, rad, about another."""
        low, high = stretch.tolist()
        length = part * (high - low)
        section, direction = np.array(about[1:])[:, None]
        self.left = turn
        self.near(Cells(section, direction, np.array([2 * length]), 2 * angle))

        def directions(x: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
            def used(chi: FloatArray) -> FloatArray:
                ends = self.ends(np.repeat(x, len(chi) // len(x)), chi)
                return np.asarray(self._used(*ends))

            return zoom(values=used, places=np.full(len(x), about.direction), width=angle)

        (x,), (height,), _ = zoom(
            values=lambda x: directions(x)[1], places=section, width=length, low=low, high=high
        )
        return Place(float(height), float(x), float(directions(np.array([x]))[0][0]))

    def cycle(self, place: Place) -> Cycle:
        """Stress cycle at a place."""
        self.left = self.turn
        section, direction = np.array(place[1:])[:, None]
        (top,), (bottom,) = self.ends(section, direction)
        (stress,), chi = self.stress(section, direction), place.direction
        if math.isclose(top, -bottom) and stress.argmax() > stress.argmin():
            chi += math.pi  # the one of two equal points that is pulled first
        return Cycle(float(top), float(bottom), place.section, chi)

    def stress(self, x: FloatArray, chi: FloatArray) -> FloatArray:
        """Stress at sections in directions at the samples left, Pa."""
        ways = np.stack((np.cos(chi), np.sin(chi)), axis=1)[..., None]
        arms = self.pin.moments(x)[:, None] * ways
        found: FloatArray = arms.reshape(len(x), -1) @ self.parts
        return found

    @property
    def parts(self) -> FloatArray:
        """Components of the forces along both axes at the samples left, N, shape (2*K, n)."""
        return np.concatenate((self.left.forces.real, self.left.forces.imag))

    def ends(self, x: FloatArray, chi: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Largest and least stress at sections in directions, Pa."""
        found = self.stress(x, chi)
        return self.left.largest(found), -self.left.largest(-found)

    def value(self, at: Cells) -> tuple[FloatArray, FloatArray]:
        """Utilisation at corners of cells, and its upper bound within the cells."""
        top, bottom = self.ends(at.section, at.direction)
        use = self._used(top, bottom)
        bound = (use + self.steep * at.length**2 / 8) / math.cos(at.angle / 2)
        if self.corners:
            reach = (np.maximum(top, -bottom) * at.angle + self.steepest * at.length) / 2
            close = np.minimum(np.abs(bottom), np.abs(2 * bottom - top) / 3) <= reach
            bound += close * (self._used(top + reach, bottom - reach) - use)
        return use, bound

    def near(self, at: Cells) -> None:
        """Keep the samples at which the stress may be largest or least within cells."""
        found = self.stress(at.section, at.direction)
        top, bottom = found.max(axis=1, keepdims=True), found.min(axis=1, keepdims=True)
        sizes = np.abs(self.pin.moments(at.section)) @ np.abs(self.left.forces).max(axis=1)
        reach = (sizes * at.angle + self.steepest * at.length)[:, None]
        self.left = self.left.only(((found >= top - reach) | (found <= bottom + reach)).any(axis=0))

    def _used(self, top: Number, bottom: Number) -> Number:
        """Utilisation of the strength by a cycle between two stresses, Pa."""
        return self.strength.utilisation((top - bottom) / 2, (top + bottom) / 2)
