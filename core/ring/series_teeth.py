"""Teeth of the ring mesh as they work in series with the output pins."""

from core.errors import Accuracy, derived
from core.output.contact_force import PairNumber
from core.output.real_turn import CloseSamples
from core.output.summits import Summit
from core.output.turn import Turn
from core.ring.series_samples import teeth_samples
from core.ring.series_turn import SeriesOverTurn, SeriesTurn
from core.ring.sharing import CycloidMesh, MeshTurn


class TeethInSeries(MeshTurn):
    """Ring mesh of discs that find their place between ring and output pins.

    Forces, pressures, sliding and lags are those of the discs. Transmission error, backlash,
    stiffness and ripple are those of the output.
    """

    def __init__(self, series: SeriesOverTurn) -> None:
        super().__init__(series.turn)
        self.series = series

    @property
    def mesh(self) -> CycloidMesh:
        """Ring mesh as it is made."""
        return self.series.series.ring

    @property
    def close(self) -> CloseSamples:
        """Forces of all pairs, sampled until pins that are alike have had each other's forces."""
        turn = self.series.turn
        assert isinstance(turn, SeriesTurn)
        return teeth_samples(turn)

    @property
    def peak_force(self) -> float:
        """Largest contact force, N."""
        return self.series.ring.peak_force

    @property
    def peak_crank_angle(self) -> float:
        """Crank angle of the largest contact force, rad; any one of equal peaks."""
        return self.series.ring.peak_crank_angle

    @property
    def peak_pair(self) -> PairNumber:
        """Pair with the largest contact force."""
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
        """Place of the largest force over reduced radius."""
        return self.series.ring_pressed[0]

    @property
    def _period(self) -> float:
        """Crank angle after which both meshes repeat, rad."""
        return self.series.turn.period

    @derived
    def lags(self) -> tuple[float, float]:
        """Largest and least lag of a disc's holes at solved positions, along the torque, rad."""
        solved = [rows["own"] for rows in (self.turn.fine, self.turn.again)]
        return max(float(own.max()) for own in solved), min(float(own.min()) for own in solved)

    @property
    def transmission_error(self) -> float:
        """Largest less least angular deflection of the output, rad."""
        return self.series.transmission_error

    @derived
    def discs(self) -> tuple[MeshTurn, ...]:
        """Ring meshes of each disc by itself over the turn, discs of one eccentricity once."""
        one, torque = self.series.series, self.turn.torque / len(self.mesh.crank_angles)
        alike = {teeth.deviations.eccentricity: teeth for teeth in one.teeth}
        return tuple(MeshTurn(Turn(teeth, torque)) for teeth in alike.values())

    @property
    def play_in_ring(self) -> float:
        """Largest backlash of an unloaded disc by itself in the ring, rad."""
        return max(each.play_in_ring for each in self.discs)

    @property
    def interference(self) -> float:
        """Largest interference without load of a disc by itself in the ring, m."""
        return max(each.interference for each in self.discs)

    @property
    def accuracy(self) -> Accuracy:
        """Error of the largest force over reduced radius."""
        top, missed = self.series.ring_pressed
        rows = self.series.turn.fine
        unsure = float(rows["error"].max() / rows["mesh_force"].max())
        error = (missed + top.error) / top.height + unsure
        return Accuracy("sampling_zoomed", error, self.series.turn.evaluations)
