"""Curves of forces, angular deflections and gaps of cycloid discs and ring pins for drawings."""

import math

import numpy as np

from core.arrays import FloatArray
from core.errors import derived
from core.output.turn import Rows
from core.ring.series_turn import SeriesTurn
from core.ring.sharing import MeshTurn, gaps_at


class MeshCurves:
    """Teeth of a ring mesh under a torque at M crank angles, rad, each curve found on demand."""

    def __init__(self, teeth: MeshTurn, crank_angle: FloatArray) -> None:
        self.turn, self.mesh, self.crank_angle = teeth.turn, teeth.mesh, crank_angle
        self.period, self.further = 2 * math.pi, 0
        """Crank angle, rad, after which forces repeat, and number of pins by which they move on."""
        if isinstance(self.turn, SeriesTurn):
            self.period, self.further = self.turn.period, self.turn.pitches % self.mesh.disc.pins

    @classmethod
    def over_period(cls, teeth: MeshTurn, angles: int) -> "MeshCurves":
        """Curves at even angles over a period of both meshes in series, or over a turn of the ring
        alone; at least ``angles`` of them in it and in each turn.
        """
        turn = teeth.turn
        if isinstance(turn, SeriesTurn):
            end, steps = turn.period, math.ceil(angles * max(1.0, turn.period / (2 * math.pi)))
        else:  # the angles repeat from pin to pin
            end, steps = 2 * math.pi, math.ceil(angles / turn.repeats) * turn.repeats
        return cls(teeth, np.linspace(0.0, end, steps + 1))

    @derived
    def _rows(self) -> Rows:
        return self.turn.poses([self.turn.real.wave(float(each)) for each in self.crank_angle])

    @property
    def force(self) -> FloatArray:
        """Force of each ring pin on each disc, N, shape (K, z_p, M)."""
        return self._by_pair(self._rows["teeth"])

    def _by_pair(self, rows: FloatArray) -> FloatArray:
        return rows.T.reshape(-1, self.mesh.disc.pins, len(rows))

    @property
    def rotation(self) -> FloatArray:
        """Angular deflection of the output, rad, negative in reverse, shape (M,)."""
        found: FloatArray = math.copysign(1.0, self.turn.torque) * self._rows["lag"]
        return found

    @property
    def own_rotation(self) -> FloatArray:
        """Angular deflection of the holes of each disc, rad, negative in reverse, shape (K, M)."""
        found: FloatArray = math.copysign(1.0, self.turn.torque) * self._rows["own"].T
        return found

    @derived
    def gap(self) -> FloatArray:
        """Gap between disc and pin under the torque, m, shape (K, z_p, M); 0 if they press."""
        gaps = gaps_at(mesh=self.mesh, crank_angle=self.crank_angle, lags=self.own_rotation.T)
        return self._by_pair(np.maximum(gaps, 0.0))
