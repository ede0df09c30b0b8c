"""Ring mesh and output mechanism in series over the turns of the crank in one period.

Forces of the ring repeat with the crank, those of the output with the wave, which makes ``z + 1``
turns while the crank makes z turns and the output one: z turns are the period. With pins that are
alike, forces repeat sooner on other pins: the ring's after each of its ``z + 1`` pitches, the
output's after each of its N pitches.
"""

import math
from dataclasses import dataclass

import numpy as np

from core.arrays import ComplexArray, FloatArray
from core.drive import engine
from core.errors import Notice, derived, poorly_known
from core.fields import answer
from core.numerics.extremes import first_largest
from core.output.contact_force import PairNumber
from core.output.over_turn import OverTurn, Peak
from core.output.real_turn import refined
from core.output.sampled_turn import off_straight
from core.output.summits import Summit, highest
from core.output.turn import LOOKED_AGAIN, POSITIONS, Rows, Turn
from core.ring.series import MeshesInSeries

LEAST_A_TURN = 48
"""Least number of positions in a turn of the crank."""

OF_A_PITCH = 4
"""Number of positions in a pitch of the ring pins, unless that makes more than `MOST`."""

MOST = 2000
"""Number of positions in a period above which a pitch has fewer."""

LEAST = 120
"""Least number of positions in a period."""

NEAR = 5e-5
"""Largest distance of forces from the straight lines between samples, over the largest force; a
longer period has more, in proportion to its turns of the wave."""


def positions_in_series(*, lobes: int, pitches: int) -> int:
    """Number of positions of the even grid over a period, equally many in each pitch of the ring. A
    disc has `lobes`, the period `pitches`: ``z*(z + 1)`` in z turns.

    >>> positions_in_series(lobes=20, pitches=420), positions_in_series(lobes=20, pitches=5)
    (1680, 120)
    """
    least = math.ceil(max(LEAST_A_TURN, POSITIONS / lobes) / (lobes + 1))
    return pitches * max(least, min(OF_A_PITCH, MOST // pitches), math.ceil(LEAST / pitches))


def of_ring(rows: Rows) -> ComplexArray:
    """Force of the ring on each disc, along its crank + i times across it, N, shape (n, K)."""
    found: ComplexArray = rows["along"] + 1j * rows["across"]
    return found


class SeriesTurn(Turn):
    """Both meshes under a torque on the output link, N*m, negative in reverse, over one period."""

    def __init__(self, real: MeshesInSeries, torque: float, share: float = 0.03) -> None:
        super().__init__(real, torque, share)
        lobes, pins = real.ring.disc.satellite_teeth, real.mechanism.pins
        self.first = 0.0
        self.repeats = math.gcd(lobes, pins) if real.output.pins_alike else 1
        whole = lobes if real.ring.pins_alike else lobes * (lobes + 1)
        self.pitches = whole // self.repeats
        """Number of pitches of the ring pins in a period."""
        self.period = 2 * math.pi * self.pitches / (lobes + 1)
        self.waves = 1 if real.ring.pins_alike else lobes + 1
        self.step = self.waves * pins // self.repeats % pins

    def at_waves(self, places: FloatArray) -> Rows:
        """Positions at wave angles of the output in rad."""
        own = self.real.mechanism
        return self.poses(((places - own.initial_crank_angle) / own.waves_per_turn).tolist())

    def positions(self) -> tuple[list[float], list[float]]:
        """Crank angles of an even grid, rad, and no further ones near changes of contact."""
        lobes = self.real.ring.disc.satellite_teeth
        count = positions_in_series(lobes=lobes, pitches=self.pitches)
        return [self.period * k / count for k in range(count)], []

    @derived
    def close(self) -> Rows:
        """Positions of a period, as close as forces on output pins and of the ring on discs ask."""
        near = NEAR * max(1.0, self.pitches / self.real.ring.disc.satellite_teeth)
        return refined(turn=self, near=near, besides=self._ring_off)

    def _ring_off(self, rows: Rows) -> FloatArray:
        """Distance of the ring's forces from lines between neighbours, over the largest force."""
        parts, wave = of_ring(rows), rows["wave"]
        angles = np.concatenate(([wave[-1] - self.period], wave, [wave[0] + self.period]))
        around = np.concatenate((parts[-1:], parts, parts[:1])).T
        off: FloatArray = off_straight(wave=angles, values=around).max(axis=0) / np.abs(parts).max()
        return off

    @property
    def looked_again(self) -> int:
        """Number of positions of the second look, in proportion to the grid."""
        return round(len(self.positions()[0]) * LOOKED_AGAIN / POSITIONS) | 1


@dataclass(frozen=True, slots=True)
class RingTurn:
    """Extremes of the ring's forces over the period."""

    peak_force: float = answer("N", "F_max")
    """Largest force of a pin of the ring."""
    peak_crank_angle: float = answer("deg", "φ")
    """Crank angle of the largest force, of all turns; any of them if several peaks are equal."""
    peak_pair: PairNumber = answer()
    """Satellite and ring pin with the largest force."""
    max_pressure: float = answer("MPa", "p_0", "Johnson 4.2")
    """Largest Hertz pressure."""
    loaded_pairs_min: int = answer()
    """Least number of pairs with a force."""
    loaded_pairs_max: int = answer()
    """Largest number of pairs with a force."""


class SeriesOverTurn(OverTurn):
    """Extremes of both meshes over the period, each found on demand.

    Forces and pairs are those of the output pins; `ring` has those of the ring pins.
    """

    TURN = SeriesTurn

    def __init__(self, turn: SeriesTurn) -> None:
        super().__init__(turn)
        self.series: MeshesInSeries = turn.real
        self.real = self.series.output

    @derived
    def ring_pressed(self) -> tuple[Summit, float]:
        """Place of the ring's largest force over reduced radius, and the error of that value."""
        return self._known("mesh_pressure", engine.LOBE_PRESSED)

    def _known(self, name: str, kind: int) -> tuple[Summit, float]:
        """Place of the largest value, and its change by half of the positions or a second look."""
        turn = self.turn
        coarse, fine, again = (
            self._grid(rows, name) for rows in (turn.coarse, turn.fine, turn.again)
        )
        found, missed = highest(coarse=coarse, fine=fine, narrow=turn.narrow(kind))
        top, more = self._above(again, kind, found)
        return top, missed + more

    @derived
    def _peak(self) -> Peak:
        turn = self.turn
        before = turn.evaluations
        top, missed = self._known("force", turn.force)
        place = min(each % turn.period for each in top.alike)
        there = turn.poses([place])["forces"]
        fine, again = turn.fine["forces"], turn.again["forces"]
        most = turn.of_pairs(np.max([fine.max(axis=0), again.max(axis=0), there[0]], axis=0))
        unsure = float(turn.fine["error"].max())
        return Peak(
            force=top.height,
            crank_angle=place,
            pair=first_largest(there[0]),
            pair_force=most.tolist(),
            relative_error=(missed + top.error + unsure) / top.height,
            evaluations=len(fine) + len(again) + turn.evaluations - before,
        )

    @derived
    def ring(self) -> RingTurn:
        """Extremes of the ring's forces."""
        turn, series = self.turn, self.series
        top, _ = self._known("mesh_force", engine.LOBE_FORCE)
        place = min(each % turn.period for each in top.alike)
        pair = first_largest(turn.poses([place])["teeth"][0])
        satellite, pin = divmod(pair, series.ring.disc.pins)
        loaded = turn.fine["mesh_loaded"]
        return RingTurn(
            peak_force=top.height,
            peak_crank_angle=place,
            peak_pair=PairNumber(satellite + 1, pin + 1),
            max_pressure=series.ring.pressure(self.ring_pressed[0].height),
            loaded_pairs_min=int(loaded.min()),
            loaded_pairs_max=int(loaded.max()),
        )

    @derived
    def _pressed(self) -> Summit:
        return self._known("pressure", self.turn.pressure)[0]

    @property
    def notices(self) -> tuple[Notice, ...]:
        """Notices on limits that both meshes strain and on poor accuracy."""
        of_ring = self.series.notices(pressed=self.pressed_without_load)
        return (*self._of_output(pressed=False), *of_ring, *poorly_known(self.accuracy))


def series_over_turn(
    *, real: MeshesInSeries, output_torque: float, lost_motion_share: float = 0.03
) -> SeriesOverTurn:
    """Peak forces, backlash, lost motion, transmission error and stiffness of both meshes.

    Raises ImpossibleMechanism if a position has no stable equilibrium, see `Stage.solved`.
    Arguments are those of `core.output.over_turn.over_turn`.
    """
    return SeriesOverTurn.of(real, output_torque, lost_motion_share)
