"""Answer of the load sharing with clearance and errors."""

from functools import partial
from typing import Any, Literal

from app.calculations.both_meshes import RingPartOut, RingTurnOut
from app.calculations.ideal_forces import CountIntervalOut, Range
from app.calculations.mechanism import FitOut, PairOut
from app.model import (
    AccuracyOut,
    DocumentResponse,
    Maybe,
    ResponseModel,
    Values,
    WarningOut,
    result,
)
from app.units import from_si
from core.output.loaded_position import LoadedPosition
from core.output.over_turn import OverTurn
from core.output.real_curves import RealCurves, StiffnessCurve
from core.output.real_cyclogram import RealCyclogram

Direction = Literal["driving", "reverse"]

worse_direction = partial(
    result,
    "Direction of the torque with the larger force, for which the results are given, if the torque "
    "alternates.",
)


class PositionOut(ResponseModel, of=LoadedPosition):
    """Mechanism at one crank angle under load."""

    BESIDE = ("pressure_MPa", "ring")

    play_arcmin: Maybe[list[float]]
    torque_direction: Maybe[Direction] = worse_direction()
    pressure_MPa: Maybe[list[list[float]]] = result(
        "Pressure of each pair as it is judged, as one list per satellite, if requested.",
        symbol="p_0",
    )
    ring: Maybe[RingPartOut] = result(
        "Mesh with the ring, if both meshes are in series. All other values then hold for both "
        "meshes, but forces and pressures for the pins of the output."
    )


class LagTurnOut(
    ResponseModel,
    of=OverTurn,
    only=(
        "transmission_error",
        "unloaded_transmission_error",
        "stiffness_min",
        "stiffness_max",
    ),
):
    """Extremes of lag and stiffness over the turn."""


class OverTurnOut(LagTurnOut, of=OverTurn):
    """Extremes over the turn of the wave; the accuracy of the answer is that of the peak force."""

    BESIDE = ("pressure_MPa", "ring")

    torque_direction: Maybe[Direction] = result(
        "Direction of the torque at the largest force, if the torque alternates; every other "
        "number is the worse of both directions."
    )
    pressure_MPa: Maybe[list[list[float]]] = result(
        "Largest pressure of each pair over the turn as it is judged, as one list per "
        "satellite, if requested.",
        symbol="p_0",
    )
    ring: Maybe[RingTurnOut] = result(
        "Mesh with the ring, if both meshes are in series. All other values then hold for both "
        "meshes, but forces and pressures for the pins of the output, over as many turns of the"
        " crank as a disc has lobes."
    )


class RealCurvesOut(ResponseModel, of=RealCurves):
    """Mechanism over one turn of the crank, at evenly spaced angles."""

    torque_direction: Maybe[Direction] = worse_direction()
    pairs: list[PairOut] = result("Pairs, in the order of the lists of forces.")


class StiffnessCurveOut(ResponseModel, of=StiffnessCurve):
    """Lag over torque at the first crank angle."""


class CarryingPairOut(PairOut):
    """Carrying phases of one pair."""

    loaded_deg: list[Range] = result(
        "Ranges of crank angle in which the pair's force is above zero.", symbol="φ"
    )


class RealCyclogramOut(ResponseModel, of=RealCyclogram):
    """Pairs that carry under the torque without the dynamic factor, with phases and numbers, over
    the crank revolutions of the mechanism.
    """

    pairs: list[CarryingPairOut] = result("Pairs of pins and holes, satellite by satellite.")
    loaded_count: list[CountIntervalOut] = result(
        "Number of pairs that carry, by ranges of crank angle."
    )

    @classmethod
    def values(
        cls, result: RealCyclogram, run_time_us: float | None = None, **given: Any
    ) -> Values:
        """Values of the core's result."""
        return super().values(
            result,
            run_time_us,
            pairs=[
                {
                    "satellite": pair.satellite,
                    "pin": pair.pin,
                    "loaded_deg": from_si("loaded_deg", pair.driving),
                }
                for pair in result.pairs
            ],
            loaded_count=[
                {
                    "from_deg": from_si("from_deg", start),
                    "to_deg": from_si("to_deg", end),
                    "pairs": pairs,
                }
                for start, end, pairs in result.loaded_count
            ],
            **given,
        )


class IdealOut(ResponseModel):
    """Mechanism without clearance and deviations, by ideal forces."""

    peak_force_N: float = result(
        "Largest ideal force by the exponent of the contact law, 10/9 for Hertz and Palmgren. "
        "The value of `/contact-force` uses its own `force_exponent`, by default 1.",
        symbol="F_max",
        equation="2021, eq. 10",
    )
    ratio: Maybe[float] = result("Real over ideal peak force, if the turn is requested.")


class LoadSharingResponse(DocumentResponse):
    """Requested results of the mechanism as it is made."""

    positions: Maybe[list[PositionOut]] = result("Results at the requested crank angles.")
    over_turn: Maybe[OverTurnOut] = result("Extremes over the turn.")
    curves: Maybe[RealCurvesOut] = result("Curves over the turn.")
    stiffness_curve: Maybe[StiffnessCurveOut] = result("Curve of the lag over the torque.")
    ideal: Maybe[IdealOut] = result("Results of the mechanism without clearance and deviations.")
    fit: FitOut = result("Fit of the pins in their holes.")
    accuracy: AccuracyOut
    warnings: Maybe[list[WarningOut]] = None
