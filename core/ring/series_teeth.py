"""The ring's mesh as it works in series with the pins of the output."""

import numpy as np

from core.arrays import FloatArray, IntArray
from core.errors import Accuracy, derived
from core.output.contact_force import PairNumber
from core.output.real_turn import CloseSamples
from core.output.summits import Summit
from core.output.turn import Turn
from core.ring.series_samples import teeth_samples
from core.ring.series_turn import SeriesOverTurn, SeriesTurn
from core.ring.sharing import CycloidMesh, MeshTurn


class TeethInSeries(MeshTurn):
    """The teeth as the discs find their place between ring and pins. Forces, pressures, sliding and
    lags are those of the discs in that one solution; the transmission error is that of the output,
    as are play, stiffness and ripple.

    Parameters
    ----------
    series : SeriesOverTurn
        Both meshes under the torque.
    """

    def __init__(self, series: SeriesOverTurn) -> None:
        super().__init__(series.turn)
        self.series = series

    @property
    def mesh(self) -> CycloidMesh:
        """The mesh."""
        return self.series.series.ring

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
    def _pressed(self) -> Summit:
        """The largest force over reduced radius over the turns."""
        return self.series.ring_pressed[0]

    @property
    def _period(self) -> float:
        """That after which both meshes repeat, rad."""
        return self.series.turn.period

    @property
    def pressed_without_load(self) -> bool:
        """Whether pairs press so anywhere, in either mesh."""
        return self.series.pressed_without_load

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
    def lags(self) -> tuple[float, float]:
        """Largest and least lag of the holes of a disc, counted as the torque turns, at the
        positions that were solved.
        """
        solved = [rows["own"] for rows in (self.turn.fine, self.turn.again)]
        return max(float(own.max()) for own in solved), min(float(own.min()) for own in solved)

    @property
    def transmission_error(self) -> float:
        """Largest less least lag of the output, rad."""
        return self.series.transmission_error

    @derived
    def discs(self) -> tuple[MeshTurn, ...]:
        """Each disc by itself in the ring, those that are alike there once."""
        one, torque = self.series.series, self.turn.torque / len(self.mesh.crank_angles)
        alike = {teeth.deviations.eccentricity: teeth for teeth in one.teeth}
        return tuple(MeshTurn(Turn(teeth, torque)) for teeth in alike.values())

    @property
    def play_in_ring(self) -> float:
        """Largest play of an unloaded disc by itself in the ring, rad."""
        return max(each.play_in_ring for each in self.discs)

    @property
    def interference(self) -> float:
        """Smallest possible worst approach without load of a disc by itself in the ring, m."""
        return max(each.interference for each in self.discs)

    @property
    def accuracy(self) -> Accuracy:
        """Of the largest force over reduced radius."""
        top, missed = self.series.ring_pressed
        rows = self.series.turn.fine
        unsure = float(rows["error"].max() / rows["mesh_force"].max())
        error = (missed + top.error) / top.height + unsure
        return Accuracy("sampling_zoomed", error, self.series.turn.evaluations)
