"""Answer of the load sharing with clearance and errors."""

from functools import partial
from typing import Any, Literal

from app.calculations.both_meshes import RingPartOut, RingTurnOut
from app.calculations.ideal_forces import CountIntervalOut, Range
from app.calculations.mechanism import FitOut, PairOut
from app.model import (
    AccuracyOut,
    AssumingResponse,
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
    result, "Where the torque alternates: the direction with the larger force, which is given."
)


class PositionOut(ResponseModel):
    """Mechanism at one crank angle under load."""

    BESIDE = ("pressure_MPa", "ring")

    crank_angle_deg: float = result("Crank angle.", symbol="φ")
    rotation_arcmin: float = result(
        "Lag of the output behind its ideal angle, clearance included; negative in reverse.",
        symbol="θ",
    )
    force_N: list[list[float]] = result(
        "Force of each pair, a list for each satellite.", symbol="F_jn", equation="ΣF·h = T"
    )
    satellite_torque_Nm: list[float] = result(
        "What each satellite adds to the torque; negative where others drag it.", symbol="T_j"
    )
    satellite_rotation_arcmin: Maybe[list[float]] = result(
        "Lag of the output behind each satellite, where these turn against each other.",
        symbol="θ_j",
    )
    torque_direction: Maybe[Direction] = worse_direction()
    loaded_pairs: int = result("Number of pairs with a force.")
    play_arcmin: Maybe[list[float]] = result(
        "From where to where the unloaded output can turn; absent where pairs press without load.",
        symbol="θ₋, θ₊",
    )
    interference_mm: Maybe[float] = result(
        "Smallest possible worst approach of the unloaded pairs, where they press.", symbol="δ"
    )
    stiffness_Nm_per_arcmin: float = result(
        "Torque over rotation of the output mechanism alone, or of both meshes in series.",
        symbol="dT/dθ",
    )
    max_pressure_MPa: Maybe[float] = result(
        "Largest pressure of the pairs, as it is judged: by Hertz, or of the contact that wraps; "
        "where the torque alternates that of both directions. Absent where it is not known.",
        symbol="p_0",
        equation="Johnson 4.2",
    )
    pressure_MPa: Maybe[list[list[float]]] = result(
        "The same of each pair, where asked.", symbol="p_0"
    )
    ring: Maybe[RingPartOut] = result(
        "What the ring does, where both meshes are in series: all else is then of both, forces and "
        "pressures of the pins of the output."
    )


class OverTurnOut(ResponseModel):
    """Extremes over the turn of the wave; the accuracy of the answer is that of the peak force."""

    BESIDE = ("pressure_MPa", "ring")

    peak_force_N: float = result("Largest force of all pairs over the turn.", symbol="F_max")
    peak_force_ratio: float = result("The same over F₀ = T/R.", symbol="f")
    peak_crank_angle_deg: float = result("First crank angle at which it occurs.", symbol="φ")
    peak_pair: PairOut = result("The pair that carries it there.")
    torque_direction: Maybe[Direction] = result(
        "Where the torque alternates: the direction of the peak; every other number is the worse "
        "of both."
    )
    backlash_max_arcmin: float = result(
        "Largest play of the unloaded output, 0 where pairs press; of uniform clearance and an "
        "even number of pins 2c/(R·cos(π/N)) in first order.",
        symbol="θ₊ − θ₋",
    )
    backlash_min_arcmin: float = result("Least play of the unloaded output.", symbol="θ₊ − θ₋")
    lost_motion_arcmin: float = result(
        "Largest rotation between the two directions of a share of the torque.",
        equation="θ(+3 % T) − θ(−3 % T)",
    )
    transmission_error_arcmin: float = result("Largest less least lag under load.", symbol="TE")
    unloaded_transmission_error_arcmin: float = result(
        "The same of the lag at which the first pair touches.", symbol="TE₀"
    )
    stiffness_min_Nm_per_arcmin: float = result("Least stiffness.", symbol="dT/dθ")
    stiffness_max_Nm_per_arcmin: float = result("Largest stiffness.", symbol="dT/dθ")
    loaded_pairs_min: int = result("Least number of pairs with a force.")
    loaded_pairs_max: int = result("Largest number of pairs with a force.")
    max_pressure_MPa: Maybe[float] = result(
        "Largest pressure, as it is judged: by Hertz, or of the contact that wraps. Absent where "
        "it is not known.",
        symbol="p_0",
        equation="Johnson 4.2",
    )
    pressure_MPa: Maybe[list[list[float]]] = result(
        "The same of each pair, a list for each satellite, where asked.", symbol="p_0"
    )
    input_torque_ripple_Nm: float = result(
        "Largest less least torque that turns the crank, without friction.",
        equation="T/u + (1 + 1/u)·ΣF·∂δ/∂ψ",
    )
    pressed_without_load: bool = result("Whether pairs press without load anywhere.")
    ring: Maybe[RingTurnOut] = result(
        "What the ring does, where both meshes are in series: all else is then of both, forces and "
        "pressures of the pins of the output, over as many turns of the crank as a disc has lobes."
    )


class RealCurvesOut(ResponseModel):
    """Mechanism over one turn of the crank, at evenly spaced angles."""

    crank_angle_deg: list[float] = result("Crank angles.", symbol="φ")
    force_N: list[list[float]] = result("Forces, a list for each pair.", symbol="F_jn")
    torque_direction: Maybe[Direction] = worse_direction()
    pairs: list[PairOut] = result("The pairs, in the order of the forces.")
    rotation_arcmin: list[float] = result("Lag under the torque.", symbol="θ")
    reverse_rotation_arcmin: list[float] = result("Lag under the torque the other way.", symbol="θ")
    play_from_arcmin: list[float] = result("Least lag of the unloaded output.", symbol="θ₋")
    play_to_arcmin: list[float] = result("Largest lag of the unloaded output.", symbol="θ₊")
    stiffness_Nm_per_arcmin: list[float] = result("Torque over rotation.", symbol="dT/dθ")
    input_torque_Nm: list[float] = result(
        "Torque that turns the crank, without friction.", symbol="T₁"
    )


class StiffnessCurveOut(ResponseModel):
    """Lag over torque at the first crank angle."""

    crank_angle_deg: float = result("Crank angle.", symbol="φ")
    torque_Nm: list[float] = result("Torques, negative in reverse.", symbol="T")
    rotation_arcmin: list[float] = result("Lag under each.", symbol="θ")
    stiffness_Nm_per_arcmin: list[float] = result("Slope at each.", symbol="dT/dθ")


class CarryingPairOut(PairOut):
    """Carrying phases of one pair."""

    loaded_deg: list[Range] = result(
        "Ranges of crank angle in which its force is above zero.", symbol="φ"
    )


class RealCyclogramOut(ResponseModel):
    """Pairs that carry under the torque without the dynamic factor, with phases and numbers, over
    the crank revolutions of the mechanism.
    """

    period_deg: float = result("Crank angle after which the same pairs carry again.")
    pairs: list[CarryingPairOut] = result("The pairs, satellite by satellite.")
    loaded_count: list[CountIntervalOut] = result("Numbers of pairs that carry.")
    step_deg: float = result("Step of the search: what is shorter may not be found.")
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
        "Largest ideal force by the exponent of the contact law, 10/9 for Hertz and Palmgren; that "
        "of /contact-force is by its own force_exponent, 1 where none is given.",
        symbol="F_max",
        equation="2021, eq. 10",
    )
    ratio: Maybe[float] = result("Real peak over the ideal one, where the turn is asked.")


class LoadSharingResponse(AssumingResponse):
    """Requested results of the mechanism as it is made."""

    positions: Maybe[list[PositionOut]] = result("At the crank angles.")
    over_turn: Maybe[OverTurnOut] = result("Over the turn.")
    curves: Maybe[RealCurvesOut] = result("Curves over the turn.")
    stiffness_curve: Maybe[StiffnessCurveOut] = result("Lag over torque.")
    ideal: Maybe[IdealOut] = result("Without clearance and deviations.")
    fit: FitOut = result("How the pins fit into their holes.")
    accuracy: AccuracyOut
    warnings: Maybe[list[WarningOut]] = None
