"""Rolling bearings as rollers on the pins: section of the answer."""

from typing import Any

from app.calculations.document import ForcesUsed, forces_used
from app.model import AccuracyOut, Maybe, ResponseModel, Values, WarningOut, result
from core.design.results import RollersOnPins


class RollersOut(ResponseModel):
    """Rollers on the pins, by the roller with the largest load."""

    forces: ForcesUsed = forces_used()
    speed_rpm: Maybe[float] = result(
        "Speed of an outer ring on its pin, n·e/r_s; absent without an input speed.", symbol="n_s"
    )
    peak_load_N: float = result("Largest load of a roller over the turn.", symbol="F")
    static_load_N: float = result("Largest load of a roller at the peak torque.", symbol="F_max")
    equivalent_load_N: float = result("Equivalent load, ⟨Fᵖ⟩^(1/p) over the turn.", symbol="P")
    dynamic_rating_as_roller_N: Maybe[float] = result(
        "Dynamic load rating without a seat around the outer ring.", symbol="C_w"
    )
    static_rating_as_roller_N: Maybe[float] = result(
        "Static load rating without a seat around the outer ring.", symbol="C_0w"
    )
    life_h: Maybe[float] = result(
        "Life that 90 % of such rollers reach, (C_w/P)ᵖ million turns.", symbol="L_10h"
    )
    static_safety_factor: Maybe[float] = result(
        "Static load rating without a seat over the load at the peak torque.", symbol="S₀"
    )
    loss_W: Maybe[float] = result("Mean loss of all rollers.", symbol="P_b")
    added_clearance_mm: float = result(
        "Clearance that the rollers add to that of pins and holes, half of their radial "
        "internal clearance.",
        symbol="G_r/2",
    )
    tilt_mrad: Maybe[float] = result("Largest slope of a pin in its rollers.", symbol="θ")
    satellite: int = result("Number of the satellite whose roller has the largest load, from 1.")
    pin: int = result("Number of the pin whose roller has the largest load, from 1.")
    accuracy: AccuracyOut
    warnings: Maybe[list[WarningOut]] = None

    @classmethod
    def values(
        cls, result: RollersOnPins, run_time_us: float | None = None, **given: Any
    ) -> Values:
        """Values of loads and life, with loss, clearance and tilt beside them."""
        beside = {
            "loss_W": result.loss,
            "added_clearance_mm": result.added_clearance * 1e3,
            "tilt_mrad": None if result.tilt is None else result.tilt * 1e3,
        }
        return super().values(result.loads, run_time_us, **beside, **given)
