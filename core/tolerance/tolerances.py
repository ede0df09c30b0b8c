"""What the parts are made to, and pieces drawn from it."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from core.arrays import FloatArray, check_positive
from core.output.loop_rows import Errors
from core.output.real_mechanism import Deviations
from core.tolerance.draws import KINDS, OF_RING, OTHER, Spread, uniforms, zone_places


@dataclass(frozen=True, slots=True)
class Tolerances:
    """What the parts are made to; None is exact."""

    pin_position: float | None = None  # diameter of the zone of the centres, m
    hole_position: float | None = None  # likewise
    pin_radius: Spread | None = None  # deviation of the radius, not of the diameter, m
    hole_radius: Spread | None = None  # likewise
    eccentricity: Spread | None = None  # deviation, m
    crank_phase: Spread | None = None  # rad
    disc_phase: Spread | None = None  # rad
    ring_pin_position: float | None = None  # as of the pins, of those of a ring
    ring_pin_radius: Spread | None = None  # likewise
    equidistant: Spread | None = None  # of the modification, m; one tool cuts all discs of a piece
    modification_pin_circle: Spread | None = None  # likewise

    def __post_init__(self) -> None:
        zones = {name: getattr(self, name) for name in KINDS if name.endswith("position")}
        check_positive(**{name: zone for name, zone in zones.items() if zone is not None})

    @property
    def sources(self) -> tuple[str, ...]:
        """Names of what varies."""
        return tuple(name for name in KINDS if getattr(self, name) is not None)

    @property
    def mean_clearance(self) -> float:
        """What the middles of all limits add to the radial clearance of pin and hole, m."""

        def middle(spread: Spread | None) -> float:
            return 0.0 if spread is None else (spread.lower + spread.upper) / 2

        return middle(self.hole_radius) - middle(self.pin_radius) - middle(self.eccentricity)

    @property
    def middle(self) -> "Tolerances":
        """Of which all pieces are at the middle of all limits."""
        found = self
        for source in self.sources:
            found = found.without(source)
        return found

    @property
    def of_ring(self) -> tuple[str, ...]:
        """Names of what varies of a ring and the discs on it."""
        return tuple(name for name in self.sources if name in OF_RING)

    def without(self, source: str) -> "Tolerances":
        """The same with a source at the middle of its limits.

        Parameters
        ----------
        source : str
            Name of the source.

        Returns
        -------
        Tolerances
        """
        given = getattr(self, source)
        if isinstance(given, Spread):
            middle = (given.lower + given.upper) / 2
            return replace(self, **{source: replace(given, lower=middle, upper=middle)})  # type: ignore[arg-type]
        return replace(self, **{source: None})


class RingRows(NamedTuple):
    """Deviations of the pins of rings, and of the tools of their discs, a row for each piece."""

    ring_pin_radial: FloatArray  # m, shape (n, z_p)
    ring_pin_tangential: FloatArray  # m, (n, z_p)
    ring_pin_radius: FloatArray  # m, (n, z_p)
    equidistant: FloatArray  # of the modification, m, (n, 1)
    modification_pin_circle: FloatArray  # m, (n, 1)


@dataclass(frozen=True, slots=True)
class Drawn:
    """Pieces that a seed draws, made where they are calculated; none hangs on the others."""

    tolerances: Tolerances
    pins: int  # N
    satellites: int  # K
    seed: int  # of the study
    samples: range  # numbers of the pieces, one after the other
    other: tuple[str, ...] = ()  # sources that are drawn from the second, independent sample
    ring_pins: int = 0  # z_p of a ring

    def __len__(self) -> int:
        return len(self.samples)

    def part(self, first: int, last: int) -> "Drawn":
        """Some of them.

        Parameters
        ----------
        first, last : int
            Of these pieces the first one, and the one after the last.

        Returns
        -------
        Drawn
        """
        return replace(self, samples=self.samples[first:last])

    def rows(self) -> Errors[FloatArray]:
        """Deviations of the pieces.

        Returns
        -------
        Errors
            A table of each deviation, C-contiguous: a row for each piece.
        """
        counts = {"pin": self.pins, "hole": self.pins * self.satellites}
        rows = {
            name: np.zeros((len(self), counts.get(name.split("_")[0], self.satellites)))
            for name in Errors._fields
        }
        for source in self.tolerances.sources:
            if source not in OF_RING:
                of = source.split("_")[0]
                rows |= self._drawn(source, of, counts.get(of, self.satellites))
        return Errors(**{name: np.ascontiguousarray(row) for name, row in rows.items()})

    def ring_rows(self) -> RingRows:
        """The same of the ring's pins, and of the tools.

        Returns
        -------
        RingRows
        """
        counts = {name: self.ring_pins for name in RingRows._fields if name.startswith("ring_pin")}
        rows = {name: np.zeros((len(self), counts.get(name, 1))) for name in RingRows._fields}
        for source in self.tolerances.of_ring:
            rows |= self._drawn(source, "ring_pin", self.ring_pins if "ring_pin" in source else 1)
        return RingRows(**rows)

    def _drawn(self, source: str, of: str, count: int) -> dict[str, FloatArray]:
        """Rows of a source by their names, of so many parts."""
        given = getattr(self.tolerances, source)
        if isinstance(given, Spread):
            return {source: given.values(self._stream(source, 0, count, given.common))}
        places = zone_places(
            diameter=given,
            radius_uniform=self._stream(source, 0, count, False),
            angle_uniform=self._stream(source, 1, count, False),
        )
        return dict(zip((f"{of}_radial", f"{of}_tangential"), places, strict=True))

    def _stream(self, source: str, part: int, count: int, common: bool) -> FloatArray:
        """Numbers of a source between 0 and 1, a column for each of so many parts."""
        kind = KINDS[source][part] + (OTHER if source in self.other else 0)
        first, samples = self.samples.start, len(self)
        columns = [
            uniforms(seed=self.seed, kind=kind, index=index, samples=samples, first=first)
            for index in range(1 if common else count)
        ]
        return np.stack(columns * (count if common else 1), axis=1)


def deviations(*, rows: Mapping[str, FloatArray], pins: int) -> Deviations:
    """Deviations of one piece.

    Parameters
    ----------
    rows : mapping of str to array
        Flat rows by the names of `Deviations`.
    pins : int
        Number N.

    Returns
    -------
    Deviations
    """

    def entries(name: str, row: FloatArray) -> tuple[object, ...]:
        if not name.startswith("hole"):
            return tuple(row.tolist())
        return tuple(tuple(each) for each in row.reshape(-1, pins).tolist())

    return Deviations(**{name: entries(name, row) for name, row in rows.items()})  # type: ignore[arg-type]
