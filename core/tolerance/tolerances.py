"""What the parts are made to, and pieces drawn from it."""

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from core.arrays import FloatArray, check_positive
from core.output.loop_rows import Errors
from core.output.real_mechanism import Deviations
from core.tolerance.draws import KINDS, OTHER, Spread, uniforms, zone_places


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

    def __post_init__(self) -> None:
        zones = {"pin_position": self.pin_position, "hole_position": self.hole_position}
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

    def middle(self, *, pins: int, satellites: int) -> Deviations:
        """The piece at the middle of all limits.

        Parameters
        ----------
        pins, satellites : int
            Numbers N and K.

        Returns
        -------
        Deviations
        """
        counts = {"pin_radius": pins, "hole_radius": pins * satellites}
        rows = {}
        for source in self.sources:
            given = getattr(self, source)
            if isinstance(given, Spread):
                middle = (given.lower + given.upper) / 2
                rows[source] = np.full(counts.get(source, satellites), middle)
        return deviations(rows=rows, pins=pins)

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


@dataclass(frozen=True, slots=True)
class Drawn:
    """Pieces that a seed draws, made where they are calculated; none hangs on the others."""

    tolerances: Tolerances
    pins: int  # N
    satellites: int  # K
    seed: int  # of the study
    samples: range  # numbers of the pieces, one after the other
    other: tuple[str, ...] = ()  # sources that are drawn from the second, independent sample

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

        def stream(source: str, part: int, count: int, common: bool) -> FloatArray:
            kind = KINDS[source][part] + (OTHER if source in self.other else 0)
            first, samples = self.samples.start, len(self)
            columns = [
                uniforms(seed=self.seed, kind=kind, index=index, samples=samples, first=first)
                for index in range(1 if common else count)
            ]
            return np.stack(columns * (count if common else 1), axis=1)

        counts = {"pin": self.pins, "hole": self.pins * self.satellites}
        rows = {
            name: np.zeros((len(self), counts.get(name.split("_")[0], self.satellites)))
            for name in Errors._fields
        }
        for source in self.tolerances.sources:
            of, given = source.split("_")[0], getattr(self.tolerances, source)
            count = counts.get(of, self.satellites)
            if isinstance(given, Spread):
                rows[source] = given.values(stream(source, 0, count, given.common))
                continue
            rows[f"{of}_radial"], rows[f"{of}_tangential"] = zone_places(
                diameter=given,
                radius_uniform=stream(source, 0, count, False),
                angle_uniform=stream(source, 1, count, False),
            )
        return Errors(**{name: np.ascontiguousarray(row) for name, row in rows.items()})


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
