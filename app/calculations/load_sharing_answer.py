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
from core.output.real_cyclogram import RealCyclogram

Direction = Literal["driving", "reverse"]

worse_direction = partial(
    result,
    "Direction of the torque with the larger force, for which the results are given, if the torque "
    "alternates.",
)


class PositionOut(ResponseModel):
    """Mechanism at one crank angle under load."""

    BESIDE = ("pressure_MPa", "ring")

    crank_angle_deg: float = result("Crank angle.", symbol="φ")
    rotation_arcmin: float = result(
        "Lag of the output behind its ideal angle, including clearance; negative in reverse.",
        symbol="θ",
    )
    force_N: list[list[float]] = result(
        "Force of each pair, as one list per satellite.", symbol="F_jn", equation="ΣF·h = T"
    )
    satellite_torque_Nm: list[float] = result(
        "Torque that each satellite contributes; negative if other satellites drag it.",
        symbol="T_j",
    )
    satellite_rotation_arcmin: Maybe[list[float]] = result(
        "Lag of the output behind each satellite, if satellites turn relative to each other.",
        symbol="θ_j",
    )
    torque_direction: Maybe[Direction] = worse_direction()
    loaded_pairs: int = result("Number of pairs with a force.")
    play_arcmin: Maybe[list[float]] = result(
        "Least and largest lag of the unloaded output; absent if pairs press without load.",
        symbol="θ₋, θ₊",
    )
    interference_mm: Maybe[float] = result(
        "Least possible value of the largest approach of the unloaded pairs, if pairs press "
        "without load.",
        symbol="δ",
    )
    stiffness_Nm_per_arcmin: float = result(
        "Torque over rotation of the output mechanism alone, or of both meshes in series.",
        symbol="dT/dθ",
    )
    max_pressure_MPa: Maybe[float] = result(
        "Largest pressure of the pairs as it is judged, by Hertz or by the conformal contact; "
        "with an alternating torque the largest of both directions. The value is absent if it "
        "is not known.",
        symbol="p_0",
        equation="Johnson 4.2",
    )
    pressure_MPa: Maybe[list[list[float]]] = result(
        "Pressure of each pair as it is judged, as one list per satellite, if requested.",
        symbol="p_0",
    )
    ring: Maybe[RingPartOut] = result(
        "Mesh with the ring, if both meshes are in series. All other values then hold for both "
        "meshes, but forces and pressures for the pins of the output."
    )


class LagTurnOut(ResponseModel):
    """Extremes of lag and stiffness over the turn."""

    transmission_error_arcmin: float = result(
        "Transmission error under load: largest less least lag over the turn.", symbol="TE"
    )
    unloaded_transmission_error_arcmin: float = result(
        "Transmission error without load: largest less least lag over the turn at which the "
        "first pair touches.",
        symbol="TE₀",
    )
    stiffness_min_Nm_per_arcmin: float = result(
        "Least torsional stiffness over the turn.", symbol="dT/dθ"
    )
    stiffness_max_Nm_per_arcmin: float = result(
        "Largest torsional stiffness over the turn.", symbol="dT/dθ"
    )


class OverTurnOut(LagTurnOut):
    """Extremes over the turn of the wave; the accuracy of the answer is that of the peak force."""

    BESIDE = ("pressure_MPa", "ring")

    peak_force_N: float = result("Largest force of all pairs over the turn.", symbol="F_max")
    peak_force_ratio: float = result("Largest force of all pairs over F₀ = T/R.", symbol="f")
    peak_crank_angle_deg: float = result("First crank angle with the largest force.", symbol="φ")
    peak_pair: PairOut = result("Pair with the largest force at that crank angle.")
    torque_direction: Maybe[Direction] = result(
        "Direction of the torque at the largest force, if the torque alternates; every other "
        "number is the worse of both directions."
    )
    backlash_max_arcmin: float = result(
        "Largest play of the unloaded output over the turn, 0 if pairs press without load. For "
        "one satellite, a uniform clearance c much smaller than the eccentricity and an even "
        "number of pins it is about 2c/(R·cos(π/N)).",
        symbol="θ₊ − θ₋",
    )
    backlash_min_arcmin: float = result(
        "Least play of the unloaded output over the turn.", symbol="θ₊ − θ₋"
    )
    lost_motion_arcmin: float = result(
        "Largest rotation of the output between the two directions of a share of the torque.",
        equation="θ(+3 % T) − θ(−3 % T)",
    )
    loaded_pairs_min: int = result("Least number of pairs with a force.")
    loaded_pairs_max: int = result("Largest number of pairs with a force.")
    max_pressure_MPa: Maybe[float] = result(
        "Largest pressure over the turn as it is judged, by Hertz or by the conformal contact. "
        "The value is absent if it is not known.",
        symbol="p_0",
        equation="Johnson 4.2",
    )
    pressure_MPa: Maybe[list[list[float]]] = result(
        "Largest pressure of each pair over the turn as it is judged, as one list per "
        "satellite, if requested.",
        symbol="p_0",
    )
    input_torque_ripple_Nm: float = result(
        "Ripple of the input torque without friction: largest less least torque that turns the "
        "crank.",
        equation="T/u + (1 + 1/u)·ΣF·∂δ/∂ψ",
    )
    pressed_without_load: bool = result("True if pairs press without load at any crank angle.")
    ring: Maybe[RingTurnOut] = result(
        "Mesh with the ring, if both meshes are in series. All other values then hold for both "
        "meshes, but forces and pressures for the pins of the output, over as many turns of the"
        " crank as a disc has lobes."
    )


class RealCurvesOut(ResponseModel):
    """Mechanism over one turn of the crank, at evenly spaced angles."""

    crank_angle_deg: list[float] = result("Crank angles of the curves.", symbol="φ")
    force_N: list[list[float]] = result(
        "Forces over the crank angles, as one list per pair.", symbol="F_jn"
    )
    torque_direction: Maybe[Direction] = worse_direction()
    pairs: list[PairOut] = result("Pairs, in the order of the lists of forces.")
    rotation_arcmin: list[float] = result("Lag of the output under the torque.", symbol="θ")
    reverse_rotation_arcmin: list[float] = result(
        "Lag of the output under the torque in the opposite direction.", symbol="θ"
    )
    play_from_arcmin: list[float] = result("Least lag of the unloaded output.", symbol="θ₋")
    play_to_arcmin: list[float] = result("Largest lag of the unloaded output.", symbol="θ₊")
    stiffness_Nm_per_arcmin: list[float] = result(
        "Torsional stiffness: slope of the torque over the rotation.", symbol="dT/dθ"
    )
    input_torque_Nm: list[float] = result(
        "Torque that turns the crank, without friction.", symbol="T₁"
    )


class StiffnessCurveOut(ResponseModel):
    """Lag over torque at the first crank angle."""

    crank_angle_deg: float = result("Crank angle of the curve.", symbol="φ")
    torque_Nm: list[float] = result("Torques of the curve, negative in reverse.", symbol="T")
    rotation_arcmin: list[float] = result("Lag of the output under each torque.", symbol="θ")
    stiffness_Nm_per_arcmin: list[float] = result(
        "Torsional stiffness at each torque.", symbol="dT/dθ"
    )


class CarryingPairOut(PairOut):
    """Carrying phases of one pair."""

    loaded_deg: list[Range] = result(
        "Ranges of crank angle in which the pair's force is above zero.", symbol="φ"
    )


class RealCyclogramOut(ResponseModel):
    """Pairs that carry under the torque without the dynamic factor, with phases and numbers, over
    the crank revolutions of the mechanism.
    """

    period_deg: float = result("Crank angle after which the same pairs carry again.")
    pairs: list[CarryingPairOut] = result("Pairs of pins and holes, satellite by satellite.")
    loaded_count: list[CountIntervalOut] = result(
        "Number of pairs that carry, by ranges of crank angle."
    )
    step_deg: float = result("Step of the search in crank angle; shorter ranges may be missed.")
    accuracy: AccuracyOut

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
