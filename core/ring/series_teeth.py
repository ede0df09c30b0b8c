"""The ring's mesh as it works in series with the pins of the output."""

import numpy as np

from core.arrays import FloatArray, IntArray
from core.derived import derived
from core.output.contact_force import PairNumber
from core.output.over_turn import Extreme
from core.output.real_turn import CloseSamples
from core.output.summits import Summit
from core.output.turn import Turn
from core.results import Accuracy
from core.ring.approach import ALONG_LEAST, ALONG_MOST, RUB, RUB_AND_PRESS
from core.ring.series_kernel import MESH_PRESSURE
from core.ring.series_samples import teeth_samples
from core.ring.series_turn import SeriesOverTurn, SeriesTurn
from core.ring.sharing import MeshTurn


class TeethInSeries(MeshTurn):
    """Forces, pressures and sliding of the teeth as the discs find their place between ring and
    pins. Play, lags, stiffness and ripple stay those of the ring alone, with a rigid output.

    Parameters
    ----------
    turn : Turn
        The ring by itself under the torque.
    series : SeriesOverTurn
        Both meshes under it.
    """

    def __init__(self, turn: Turn, series: SeriesOverTurn) -> None:
        super().__init__(turn)
        self.series = series

    @property
    def samples(self) -> tuple[FloatArray, FloatArray]:
        """Crank angles of positions, rad, and the forces of all pairs there, N."""
        rows = self.series.turn.fine
        return rows["wave"], rows["teeth"]

    @property
    def close(self) -> CloseSamples:
        """Forces of all pairs, sampled as closely as those of the output and the ring's on the
        discs need: until each pin has had what each other one that is alike had.
        """
        turn = self.series.turn
        assert isinstance(turn, SeriesTurn)
        return teeth_samples(turn)

    @property
    def even(self) -> IntArray:
        """Which of these are evenly spaced."""
        places, _ = self.series.turn.positions()
        return np.searchsorted(self.series.turn.fine["wave"], places)

    @property
    def peak_force(self) -> float:
        """Largest force, N."""
        return self.series.ring.peak_force

    @property
    def peak_crank_angle(self) -> float:
        """Crank angle at which it occurs, rad; of equal peaks any."""
        return self.series.ring.peak_crank_angle

    @property
    def peak_pair(self) -> PairNumber:
        """The pair that carries it there."""
        return self.series.ring.peak_pair

    @property
    def loaded_pairs_min(self) -> int:
        """Least number of pairs that carry."""
        return self.series.ring.loaded_pairs_min

    @property
    def loaded_pairs_max(self) -> int:
        """Largest number of pairs that carry."""
        return self.series.ring.loaded_pairs_max

    @property
    def _hardest(self) -> Summit:
        """The largest force over reduced radius over the turns."""
        return self.series.top("mesh_pressure", MESH_PRESSURE)[0]

    @property
    def _period(self) -> float:
        """That after which both meshes repeat, rad."""
        return self.series.turn.period

    def forces_at(self, crank_angle: float) -> FloatArray:
        """Forces of all pairs at a crank angle, counted over all turns after which both meshes
        repeat, N.

        Parameters
        ----------
        crank_angle : float
            The angle, rad.

        Returns
        -------
        array, shape (K, z_p)
        """
        forces: FloatArray = self.series.turn.poses([crank_angle])["teeth"]
        return forces.reshape(-1, self.mesh.disc.pins)

    @derived
    def _along(self) -> tuple[Extreme, Extreme]:
        series = self.series
        return series.by_values(ALONG_MOST), series.by_values(ALONG_LEAST, -1)

    @derived
    def hardest_rub(self) -> float:
        """Largest product over the turn of force and distance to the pitch point, N*m."""
        return self.series.by_values(RUB).value

    @derived
    def hardest_pressed_rub(self) -> float | None:
        """Largest product of Hertz pressure and that distance, Pa*m, of known materials."""
        unit = self.mesh.pressure(1.0)
        return None if unit is None else unit * self.series.by_values(RUB_AND_PRESS).value

    @property
    def accuracy(self) -> Accuracy:
        """Of the largest force over reduced radius."""
        top, missed = self.series.top("mesh_pressure", MESH_PRESSURE)
        rows = self.series.turn.fine
        unsure = float(rows["force_error"].max() / rows["mesh_force"].max())
        error = (missed + top.error) / top.height + unsure
        return Accuracy("sampling_zoomed", error, self.series.turn.evaluations)


def teeth_in_series(*, series: SeriesOverTurn) -> TeethInSeries:
    """The teeth of both meshes in series.

    Parameters
    ----------
    series : SeriesOverTurn
        Both meshes under a torque.

    Returns
    -------
    TeethInSeries
    """
    return TeethInSeries(Turn(series.series.ring, series.turn.torque), series)
