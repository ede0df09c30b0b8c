"""Tolerance study of both meshes in series, with the ring pins and the discs."""

import math
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any, ClassVar

import numpy as np

from core.arrays import FloatArray
from core.drive.model import Pieces
from core.errors import InvalidInput
from core.output.real_mechanism import RealMechanism
from core.ring.drives import LobeErrors, series_pieces, tool_of
from core.ring.profile import CycloidDisc, Modification
from core.ring.series import MeshesInSeries
from core.ring.series_turn import SeriesTurn
from core.ring.sharing import RingDeviations
from core.tolerance.study import Study
from core.tolerance.tolerances import Drawn, RingRows

FINER = 8
"""Factor on the number of positions by which the error of the grid is estimated."""

LOOKED = 16
"""Number of crank angles in each pitch of the ring pins at which a piece is checked for fit."""

NAMES = {"equidistant": "equidistant", "pin_circle": "modification_pin_circle"}
"""Names of the tolerances of a modification by the names of its fields."""

TRIED = 24
"""Number of orders of the turns that are tried to space the wave angles evenly."""


@lru_cache(maxsize=16)
def crank_places(*, lobes: int, count: int) -> tuple[float, ...]:
    """Crank angles spaced evenly in a turn, each in another of the ``lobes`` turns of a period,
    rad; wave angles of the output are nearly even too.

    >>> [round(angle/(2*math.pi), 3) for angle in crank_places(lobes=5, count=4)]
    [0.0, 2.25, 4.5, 1.75]
    """
    each, golden = np.arange(count), lobes * (math.sqrt(5) - 1) / 2
    steps = [step for step in range(1, lobes) if math.gcd(step, lobes) == 1]
    steps = sorted(steps, key=lambda step: abs(step - golden))[:TRIED]

    def turns(step: int) -> FloatArray:
        return each / count + each * step % lobes

    def widest(step: int) -> float:
        """Widest gap of the wave angles, in turns."""
        waves = np.sort(turns(step) * (1 + 1 / lobes) % 1)
        return round(float(np.diff(waves, append=waves[0] + 1).max()), 12)

    return tuple((2 * math.pi * turns(min(steps, key=widest))).tolist())


@dataclass(frozen=True, slots=True)
class SeriesStudy(Study):
    """Nominal design of both meshes in series, its tolerances, and the quantities to calculate."""

    real: MeshesInSeries  # type: ignore[assignment] # nominal design, without deviations

    def __post_init__(self) -> None:
        own = self.real.ring.disc.modification
        try:
            for disc in self._extreme_discs():
                disc.refuse_undercut()
        except InvalidInput as error:
            if error.parameter not in NAMES:
                raise
            name = NAMES[error.parameter]
            off = error.value - getattr(own, error.parameter)
            params = error.params | {"limit": error.params["limit"] - (error.value - off)}
            raise InvalidInput(f"tolerances.{name}", off, error.code, **params) from error

    def _extreme_discs(self) -> list[CycloidDisc]:
        disc = self.real.ring.disc
        return [
            _cut(disc, equidistant, pin_circle)
            for equidistant in self.tolerances.ends("equidistant")
            for pin_circle in self.tolerances.ends("modification_pin_circle")
        ]

    @property
    def output(self) -> RealMechanism:
        """Output mechanism."""
        return self.real.output

    @property
    def ring_pins(self) -> int:
        """Number z_p of ring pins."""
        return self.real.ring.disc.pins

    @property
    def pairs(self) -> int:
        """Number of pairs in both meshes."""
        own = self.real.mechanism
        return (own.pins + self.ring_pins) * own.satellites

    def places(self, count: int) -> tuple[float, ...]:
        """Crank angles at which pieces are solved, rad."""
        return crank_places(lobes=self.ring_pins - 1, count=count)

    TURN: ClassVar[Any] = SeriesTurn
    """Both meshes of one piece over the turns of a period."""

    rigid = False
    """False, as the quicker loop for rigid discs has no ring."""

    @property
    def looked(self) -> FloatArray:
        """Crank angles at which a piece is checked for fit, rad."""
        return np.sort(self.places(LOOKED * self.ring_pins))

    def drives(self, pieces: Drawn) -> Pieces:
        """Drives of pieces as the engine takes them."""
        series, of_ring = self.real, pieces.ring_rows()
        tool = _tools(series.ring.disc, of_ring)
        teeth = LobeErrors(
            of_ring.ring_pin_radial, of_ring.ring_pin_tangential, of_ring.ring_pin_radius, tool
        )
        return series_pieces(series=series, teeth=teeth, errors=pieces.rows())

    def piece(self, pieces: Drawn, index: int) -> Any:
        """Both meshes of one piece with its deviations."""
        own, ring = self.deviations(pieces, index), self.real.ring
        rows = pieces.part(index, index + 1).ring_rows()
        radial, tangential, radius = (tuple(row[0].tolist()) for row in rows[:3])
        shared = own.eccentricity, own.crank_phase, own.disc_phase
        of_ring = RingDeviations(radial, tangential, radius, *shared)
        disc = _cut(ring.disc, *(float(row[0, 0]) for row in rows[3:]))
        return MeshesInSeries(
            replace(ring, disc=disc, deviations=of_ring),
            replace(self.real.output, deviations=own),
        )

    def square_pressure(self, name: str) -> float:
        """Square of a pressure over the value that the engine has for it."""
        if name != "ring_max_pressure":
            return Study.square_pressure(self, name)
        return self.real.ring.pressure(1.0) ** 2

    def grid_errors(self, pieces: Drawn, values: FloatArray) -> dict[str, float]:
        """Relative error of each quantity by the finite number of positions, by name."""
        return self.missed_by_finer(pieces, values, FINER)


def _cut(disc: CycloidDisc, equidistant: float, pin_circle: float) -> CycloidDisc:
    """Disc with a modification changed by offsets in m."""
    own = disc.modification
    changed = Modification(own.equidistant + equidistant, own.pin_circle + pin_circle, own.rotation)
    return replace(disc, modification=changed)


def _tools(disc: CycloidDisc, rows: RingRows) -> FloatArray:
    """Values of `tool_of` for each piece, shape (S, 4)."""
    changes = np.concatenate([rows.equidistant, rows.modification_pin_circle], axis=1)
    if not changes.any():
        changes = changes[:1]
    found = []
    for equidistant, pin_circle in changes.tolist():
        found.append(tool_of(_cut(disc, equidistant, pin_circle)))
    return np.array(found * (len(rows.equidistant) // len(found)))
