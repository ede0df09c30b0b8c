"""Tolerances of the parts, and pieces drawn from them."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np

from core.arrays import FloatArray, check_not_negative
from core.output.room import Deviations, Errors
from core.tolerance.draws import (
    KINDS,
    OF_RING,
    OTHER,
    Spread,
    normals,
    uniforms,
    zone_places,
)


@dataclass(frozen=True, slots=True)
class Tolerances:
    """Tolerances of the parts; None is exact."""

    pin_position: float | None = None  # diameter of the zone of output pin centres, m
    hole_position: float | None = None  # diameter of the zone of hole centres, m
    pin_radius: Spread | None = None  # deviation of the radius, not of the diameter, m
    hole_radius: Spread | None = None  # deviation of the radius, not of the diameter, m
    eccentricity: Spread | None = None  # deviation, m
    crank_phase: Spread | None = None  # rad
    disc_phase: Spread | None = None  # rad
    ring_pin_position: float | None = None  # diameter of the zone of ring pin centres, m
    ring_pin_radius: Spread | None = None  # deviation of the radius, not of the diameter, m
    # Deviations of the modification, m; one tool cuts all discs of a piece.
    equidistant: Spread | None = None
    modification_pin_circle: Spread | None = None  # deviation of the tool's circle radius, m

    def __post_init__(self) -> None:
        zones = {name: zone for name, zone in self._given.items() if name.endswith("position")}
        check_not_negative(**zones)

    @property
    def _given(self) -> dict[str, Any]:
        """Position tolerances and spreads that are not None, by name."""
        every = {name: getattr(self, name) for name in KINDS}
        return {name: each for name, each in every.items() if each is not None}

    @property
    def sources(self) -> tuple[str, ...]:
        """Names of the tolerances that are given."""
        return tuple(self._given)

    def ends(self, source: str) -> tuple[float, float]:
        """Least and largest deviation of a source; 0 if it is exact."""
        given = self._given.get(source, 0.0)
        if isinstance(given, Spread):
            return given.lower, given.upper
        return -given / 2, given / 2

    @property
    def mean_clearance(self) -> float:
        """Radial clearance of pin and hole that the middles of all limits add, m."""
        hole, pin, crank = (
            sum(self.ends(source)) / 2 for source in ("hole_radius", "pin_radius", "eccentricity")
        )
        return hole - pin - crank

    @property
    def middle(self) -> "Tolerances":
        """Tolerances with all sources at the middle of their limits."""
        found = self
        for source in self.sources:
            found = found.without(source)
        return found

    @property
    def of_ring(self) -> tuple[str, ...]:
        """Names of the given tolerances of a ring and its discs."""
        return tuple(name for name in self.sources if name in OF_RING)

    def without(self, source: str) -> "Tolerances":
        """Tolerances with one source at the middle of its limits."""
        given = getattr(self, source)
        if isinstance(given, Spread):
            middle = (given.lower + given.upper) / 2
            return replace(self, **{source: replace(given, lower=middle, upper=middle)})  # type: ignore[arg-type]
        return replace(self, **{source: None})


class RingRows(NamedTuple):
    """Deviations of ring pins and of the tools of discs, one row for each of n pieces."""

    ring_pin_radial: FloatArray  # m, shape (n, z_p)
    ring_pin_tangential: FloatArray  # m, shape (n, z_p)
    ring_pin_radius: FloatArray  # m, shape (n, z_p)
    equidistant: FloatArray  # change of the tool radius, m, shape (n, 1)
    modification_pin_circle: FloatArray  # change of the tool's circle radius, m, shape (n, 1)


@dataclass(frozen=True, slots=True)
class Drawn:
    """Pieces drawn by a seed when they are calculated; no piece depends on others."""

    tolerances: Tolerances
    pins: int  # number N of output pins
    satellites: int  # number K of discs
    seed: int  # seed of the study
    samples: range  # consecutive numbers of the pieces
    other: tuple[str, ...] = ()  # sources that are drawn from the second, independent sample
    ring_pins: int = 0  # number z_p of ring pins

    def __len__(self) -> int:
        return len(self.samples)

    def part(self, first: int, last: int) -> "Drawn":
        """Pieces from index ``first`` to before ``last``."""
        return replace(self, samples=self.samples[first:last])

    def rows(self) -> Errors[FloatArray]:
        """Deviations of the pieces, C-contiguous tables with one row for each piece."""
        counts = {"pin": self.pins, "hole": self.pins * self.satellites}

        def many(name: str) -> int:
            return counts.get(name.split("_")[0], self.satellites)

        tables = {name: np.zeros((len(self), many(name))) for name in Errors._fields}
        own = [source for source in self.tolerances.sources if source not in OF_RING]
        self._fill(tables, {source: (source.split("_")[0], many(source)) for source in own})
        return Errors(**tables)

    def ring_rows(self) -> RingRows:
        """Deviations of the ring pins and of the tools of the pieces."""

        def many(name: str) -> int:
            return self.ring_pins if name.startswith("ring_pin") else 1

        tables = {name: np.zeros((len(self), many(name))) for name in RingRows._fields}
        own = self.tolerances.of_ring
        self._fill(tables, {source: ("ring_pin", many(source)) for source in own})
        return RingRows(**tables)

    def _fill(
        self, tables: Mapping[str, FloatArray], sources: Mapping[str, tuple[str, int]]
    ) -> None:
        """Draw sources, given as kind of part and count by name, into the tables."""
        numbers = self._numbers({source: count for source, (_, count) in sources.items()})
        for source, (of, _) in sources.items():
            given = getattr(self.tolerances, source)
            if isinstance(given, Spread):
                tables[source][:] = given.spread(numbers[source][0]).T
                continue
            of_radius, of_angle = numbers[source]
            radial, tangential = zone_places(
                diameter=given, radius_uniform=of_radius, angle_uniform=of_angle
            )
            tables[f"{of}_radial"][:], tables[f"{of}_tangential"][:] = radial.T, tangential.T

    def _numbers(self, counts: Mapping[str, int]) -> dict[str, list[FloatArray]]:
        """Random numbers of each source, in one pass; those of normal sources are normal."""

        def normal(source: str) -> bool:
            given = getattr(self.tolerances, source)
            return isinstance(given, Spread) and given.distribution == "normal"

        streams: list[tuple[int, int]] = []
        parts: dict[str, list[slice]] = {}
        normal_ones = 0
        for source in sorted(counts, key=normal, reverse=True):
            common = getattr(getattr(self.tolerances, source), "common", False)
            count = 1 if common else counts[source]
            other = OTHER if source in self.other else 0
            for kind in KINDS[source]:
                parts.setdefault(source, []).append(slice(len(streams), len(streams) + count))
                streams += [(kind + other, index) for index in range(count)]
            normal_ones = len(streams) if normal(source) else normal_ones
        numbers = uniforms(
            seed=self.seed, streams=streams, samples=len(self), first=self.samples.start
        )
        numbers[:normal_ones] = normals(numbers[:normal_ones])
        return {source: [numbers[part] for part in own] for source, own in parts.items()}


def deviations(*, rows: Mapping[str, FloatArray], pins: int) -> Deviations:
    """Deviations of one piece from flat rows by the names of `Deviations`."""

    def entries(name: str, row: FloatArray) -> tuple[object, ...]:
        if not name.startswith("hole"):
            return tuple(row.tolist())
        return tuple(tuple(each) for each in row.reshape(-1, pins).tolist())

    return Deviations(**{name: entries(name, row) for name, row in rows.items()})  # type: ignore[arg-type]
