"""Curves of forces, angular deflections and gaps of cycloid discs and ring pins for drawings."""

import math

import numpy as np

from core.arrays import FloatArray
from core.errors import derived
from core.output.turn import Rows
from core.ring.series_teeth import TeethInSeries
from core.ring.series_turn import SeriesTurn
from core.ring.sharing import CycloidMesh, MeshTurn, mesh_gaps, mesh_position


class MeshCurves:
    """Cycloid mesh under a torque at even crank angles, each curve found on demand.

    The turn has at least ``angles`` angles besides its end.

    Examples
    --------
    >>> from core.materials import ElasticMaterial
    >>> from core.output.elasticity import LinearLaw
    >>> from core.ring.profile import CycloidDisc, Modification
    >>> from core.ring.sharing import mesh_over_turn
    >>> disc = CycloidDisc(satellite_teeth=11, eccentricity=2.5e-3,
    ...                    ring_pin_circle_radius=0.05, ring_pin_radius=0.005,
    ...                    modification=Modification(equidistant=2e-5))
    >>> steel = ElasticMaterial(210e9, 0.3)
    >>> mesh = CycloidMesh(disc=disc, crank_angles=(0.0,), contact_length=0.01,
    ...                    law=LinearLaw(1e8), pin_material=steel, disc_material=steel)
    >>> turn = mesh_over_turn(mesh=mesh, output_torque=100.0)
    >>> found = MeshCurves(turn, 20)
    >>> found.force.shape, found.gap.shape, len(found.crank_angle)
    ((1, 12, 25), (1, 12, 25), 25)
    >>> bool(found.force.max() <= turn.peak_force)
    True
    """

    def __init__(self, turn: MeshTurn, angles: int) -> None:
        self.turn = turn
        self.mesh: CycloidMesh = turn.mesh
        repeats = turn.turn.repeats
        self._own = -(-angles // repeats)
        self.crank_angle = np.linspace(0.0, 2 * math.pi, self._own * repeats + 1)
        """Crank angles from 0 to a whole turn, rad, shape (M,)."""

    @derived
    def _period(self) -> tuple[FloatArray, FloatArray]:
        """Forces, N, and lags, rad, over one period."""
        turn, mesh = self.turn.turn, self.mesh
        waves = [mesh.wave(float(each)) for each in self.crank_angle[: self._own]]
        rows = turn.poses(waves)
        return (
            rows["forces"].T.reshape(len(mesh.crank_angles), mesh.disc.pins, -1),
            math.copysign(1.0, turn.torque) * rows["lag"],
        )

    def _over_turn(self, values: FloatArray) -> FloatArray:
        """Values of all pairs over the turn; one period later a pin has those of the next pin."""
        repeats = self.turn.turn.repeats
        turned = [np.roll(values, -each, axis=1) for each in range(repeats)]
        return np.concatenate([*turned, values[..., :1]], axis=2)

    @property
    def force(self) -> FloatArray:
        """Force of each ring pin on each disc, N, shape (K, z_p, M)."""
        return self._over_turn(self._period[0])

    period = 2 * math.pi
    """Crank angle after which the forces repeat, `further` pins on, rad."""

    further = 0
    """Number of pins by which forces are shifted after a period."""

    @property
    def rotation(self) -> FloatArray:
        """Angular deflection of the output, rad, negative in reverse, shape (M,)."""
        _, lags = self._period
        return np.append(np.tile(lags, self.turn.turn.repeats), lags[0])

    @derived
    def gap(self) -> FloatArray:
        """Gap between disc and pin under the torque, m, shape (K, z_p, M); 0 if they press."""
        mesh, torque, (_, lags) = self.mesh, self.turn.turn.torque, self._period
        rows = []
        for angle, lag in zip(self.crank_angle[: self._own].tolist(), lags.tolist(), strict=True):
            own: tuple[float, ...] = (lag,) * len(mesh.crank_angles)
            if mesh.support.turning:  # discs have different lags
                found = mesh_position(mesh=mesh, crank_angle=angle, output_torque=torque)
                own = found.rotation
            rows.append(mesh_gaps(mesh=mesh, crank_angle=angle, rotation=own))
        return self._over_turn(np.maximum(np.moveaxis(np.array(rows), 0, -1), 0.0))


class SeriesCurves:
    """Teeth of both meshes in series at M crank angles in rad, each curve found on demand."""

    def __init__(self, teeth: TeethInSeries, crank_angle: FloatArray) -> None:
        turn = teeth.series.turn
        assert isinstance(turn, SeriesTurn)
        self.turn, self.mesh = turn, teeth.mesh
        self.period: float = turn.period
        """Crank angle after which the forces repeat, `further` pins on, rad."""
        self.further = turn.pitches % self.mesh.disc.pins
        """Number of pins by which forces are shifted after a period."""
        self.crank_angle = crank_angle

    @classmethod
    def over_period(cls, teeth: TeethInSeries, angles: int) -> "SeriesCurves":
        """Curves at even angles over one period, at least ``angles`` of them in it and per turn."""
        period: float = teeth.series.turn.period
        steps = math.ceil(angles * max(1.0, period / (2 * math.pi)))
        return cls(teeth, np.linspace(0.0, period, steps + 1))

    @derived
    def _rows(self) -> Rows:
        return self.turn.poses([self.turn.real.wave(float(each)) for each in self.crank_angle])

    @property
    def _way(self) -> float:
        return math.copysign(1.0, self.turn.torque)

    @property
    def force(self) -> FloatArray:
        """Force of each ring pin on each disc, N, shape (K, z_p, M)."""
        pins, many = self.mesh.disc.pins, len(self.crank_angle)
        found: FloatArray = self._rows["teeth"].T.reshape(-1, pins, many)
        return found

    @property
    def rotation(self) -> FloatArray:
        """Angular deflection of the output, rad, negative in reverse, shape (M,)."""
        found: FloatArray = self._way * self._rows["lag"]
        return found

    @property
    def own_rotation(self) -> FloatArray:
        """Angular deflection of the holes of each disc, rad, negative in reverse, shape (K, M)."""
        found: FloatArray = self._way * self._rows["own"].T
        return found

    @derived
    def gap(self) -> FloatArray:
        """Gap between disc and pin under the torque, m, shape (K, z_p, M); 0 if they press."""
        rows = [
            mesh_gaps(mesh=self.mesh, crank_angle=angle, rotation=tuple(lags))
            for angle, lags in zip(
                self.crank_angle.tolist(), self.own_rotation.T.tolist(), strict=True
            )
        ]
        gaps: FloatArray = np.maximum(np.moveaxis(np.array(rows), 0, -1), 0.0)
        return gaps
