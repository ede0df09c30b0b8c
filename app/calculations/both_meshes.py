"""Answer of the ring mesh in series with the output mechanism."""

from app.calculations.mechanism import PairOut
from app.model import Maybe, ResponseModel, Values, result
from app.units import from_si
from core.ring.series import SeriesPosition


class RingPartOut(ResponseModel):
    """Ring mesh at a crank angle, if both meshes are in series."""

    BESIDE = ("crank_load_N",)

    rotation_arcmin: list[float] = result(
        "Lag of each disc's holes behind their ideal angle: the part of the output's lag that "
        "the teeth cause. The rest is the lag of the pins.",
        symbol="λ_j",
    )
    force_N: list[list[float]] = result(
        "Force of each pin of the ring, a list for each satellite.", symbol="F_jk"
    )
    disc_torque_Nm: list[float] = result(
        "Torque of the forces about each disc's centre.", symbol="T_j", equation="ΣF·h"
    )
    crank_across_N: list[float] = result(
        "Force of the ring on each disc against the turning of its crank.", symbol="W_j"
    )
    crank_along_N: list[float] = result(
        "Force of the ring on each disc along its crank, to the axis."
    )
    crank_load_N: list[float] = result(
        "Magnitude of the resultant force of ring and pins on each crank."
    )
    loaded_pairs: int = result("Number of pairs with a force.")
    max_pressure_MPa: Maybe[float] = result(
        "Largest Hertz pressure of the pairs.", symbol="p_0", equation="Johnson 4.2"
    )
    play_arcmin: list[list[float]] = result(
        "Angles between which each disc can turn in the ring alone; if its pins press without "
        "load, twice the lag at which they exert no torque on it.",
        symbol="λ₋, λ₊",
    )


class RingTurnOut(ResponseModel):
    """Ring mesh over all turns, if both meshes are in series."""

    peak_force_N: float = result("Largest force of a pin of the ring.", symbol="F_max")
    peak_crank_angle_deg: float = result(
        "Crank angle of the largest force, of all turns; any of them if several peaks are equal.",
        symbol="φ",
    )
    peak_pair: PairOut = result("Satellite and ring pin with the largest force.")
    max_pressure_MPa: Maybe[float] = result(
        "Largest Hertz pressure.", symbol="p_0", equation="Johnson 4.2"
    )
    loaded_pairs_min: int = result("Least number of pairs with a force.")
    loaded_pairs_max: int = result("Largest number of pairs with a force.")


def ring_values(position: SeriesPosition) -> Values:
    """Values of the ring mesh at a position."""
    return RingPartOut.values(
        position.ring, crank_load_N=from_si("crank_load_N", position.crank_force)
    )
