"""What tolerances do to pieces of both meshes in series: a ring of pins too, and its discs."""

import math
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any

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
"""How many times as many positions show what those asked miss."""

LOOKED = 16
"""Crank angles in each pitch of the ring's pins at which is looked whether a piece fits."""

NAMES = {"equidistant": "equidistant", "pin_circle": "modification_pin_circle"}
"""Tolerances of a modification, by its own names."""

TRIED = 24
"""Ways of going through the turns that are tried, of which one comes everywhere on the wave."""


@lru_cache(maxsize=16)
def crank_places(*, lobes: int, count: int) -> tuple[float, ...]:
    """Crank angles evenly over a turn, each in another of the turns after which all repeats, so
    that the wave angles of the output are nearly even too.

    Parameters
    ----------
    lobes : int
        Of a disc: as many turns.
    count : int
        How many.

    Returns
    -------
    tuple of float
        rad.

    Examples
    --------
    >>> [round(angle/(2*math.pi), 3) for angle in crank_places(lobes=5, count=4)]
    [0.0, 2.25, 4.5, 1.75]
    """
    each, golden = np.arange(count), lobes * (math.sqrt(5) - 1) / 2
    steps = [step for step in range(1, lobes) if math.gcd(step, lobes) == 1]
    steps = sorted(steps, key=lambda step: abs(step - golden))[:TRIED]

    def turns(step: int) -> FloatArray:
        return each / count + each * step % lobes

    def widest(step: int) -> float:
        """Widest gap of the wave angles."""
        waves = np.sort(turns(step) * (1 + 1 / lobes) % 1)
        return round(float(np.diff(waves, append=waves[0] + 1).max()), 12)

    return tuple((2 * math.pi * turns(min(steps, key=widest))).tolist())


@dataclass(frozen=True, slots=True)
class SeriesStudy(Study):
    """A design of both meshes in series, its tolerances, and what is asked."""

    real: MeshesInSeries  # type: ignore[assignment] # the nominal design, without deviations

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
        """The output mechanism."""
        return self.real.output

    @property
    def ring_pins(self) -> int:
        """Number z_p of the ring's pins."""
        return self.real.ring.disc.pins

    @property
    def pairs(self) -> int:
        """Pairs of both meshes."""
        own = self.real.mechanism
        return (own.pins + self.ring_pins) * own.satellites

    def places(self, count: int) -> tuple[float, ...]:
        """Crank angles at which pieces are solved.

        Parameters
        ----------
        count : int
            How many.

        Returns
        -------
        tuple of float
            rad.
        """
        return crank_places(lobes=self.ring_pins - 1, count=count)

    rigid = False
    """No scalar loop knows a ring."""

    @property
    def looked(self) -> FloatArray:
        """Crank angles at which is looked whether a piece goes together, rad."""
        return np.sort(self.places(LOOKED * self.ring_pins))

    def drives(self, pieces: Drawn) -> Pieces:
        """Drives of pieces, as the engine takes them.

        Parameters
        ----------
        pieces : Drawn
            The pieces.

        Returns
        -------
        Pieces
        """
        series, of_ring = self.real, pieces.ring_rows()
        tool = _tools(series.ring.disc, of_ring)
        teeth = LobeErrors(
            of_ring.ring_pin_radial, of_ring.ring_pin_tangential, of_ring.ring_pin_radius, tool
        )
        return series_pieces(series=series, teeth=teeth, errors=pieces.rows())

    def piece(self, pieces: Drawn, index: int) -> Any:
        """Both meshes of one piece.

        Parameters
        ----------
        pieces : Drawn
            The pieces.
        index : int
            Which of them.

        Returns
        -------
        MeshesInSeries
        """
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

    def turn_of(self, pieces: Drawn, index: int) -> SeriesTurn:
        """One piece under the torque, over the turns.

        Parameters
        ----------
        pieces : Drawn
            The pieces.
        index : int
            Which of them.

        Returns
        -------
        SeriesTurn
        """
        piece = self.piece(pieces, index)
        return SeriesTurn(piece, self.asked.output_torque, self.asked.lost_motion_share)

    def square_pressure(self, name: str) -> float:
        """Square of a quantity that is a pressure, over what the engine says of it.

        Parameters
        ----------
        name : str
            Of the quantity.

        Returns
        -------
        float
        """
        if name != "ring_max_pressure":
            return Study.square_pressure(self, name)
        return self.real.ring.pressure(1.0) ** 2

    def grid_errors(self, pieces: Drawn, values: FloatArray) -> dict[str, float]:
        """What the positions miss of each quantity.

        Parameters
        ----------
        pieces : Drawn
            The pieces.
        values : array, shape (pieces, quantities)
            Their quantities.

        Returns
        -------
        dict of float
            By the names of the quantities, relative.
        """
        return self.missed_by_finer(pieces, values, FINER)


def _cut(disc: CycloidDisc, equidistant: float, pin_circle: float) -> CycloidDisc:
    """A disc that another tool cuts, by how much its modification is off, m."""
    own = disc.modification
    changed = Modification(own.equidistant + equidistant, own.pin_circle + pin_circle, own.rotation)
    return replace(disc, modification=changed)


def _tools(disc: CycloidDisc, rows: RingRows) -> FloatArray:
    """Sizes that come from the tool of each piece."""
    changes = np.concatenate([rows.equidistant, rows.modification_pin_circle], axis=1)
    if not changes.any():
        changes = changes[:1]
    found = []
    for equidistant, pin_circle in changes.tolist():
        found.append(tool_of(_cut(disc, equidistant, pin_circle)))
    return np.array(found * (len(rows.equidistant) // len(found)))
