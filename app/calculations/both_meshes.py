"""Answer of the ring mesh in series with the output mechanism."""

from app.calculations.mechanism import PairOut
from app.model import ResponseModel, Values, result
from app.units import from_si
from core.ring.series import RingPart, SeriesPosition
from core.ring.series_turn import RingTurn


class RingPartOut(ResponseModel, of=RingPart):
    """Ring mesh at a crank angle, if both meshes are in series."""

    BESIDE = ("crank_load_N",)

    play_arcmin: list[list[float]]
    crank_load_N: list[float] = result(
        "Magnitude of the resultant force of ring and pins on each crank."
    )


class RingTurnOut(ResponseModel, of=RingTurn):
    """Ring mesh over all turns, if both meshes are in series."""

    peak_pair: PairOut


def ring_values(position: SeriesPosition) -> Values:
    """Values of the ring mesh at a position."""
    return RingPartOut.values(
        position.ring, crank_load_N=from_si("crank_load_N", position.crank_force)
    )
