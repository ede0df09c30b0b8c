"""Rolling bearings as rollers on the pins: section of the answer."""

from typing import Any

from app.calculations.document import ForcesUsed, forces_used
from app.model import Maybe, ResponseModel, Values, result
from core.crank.pin_rollers import PinRollers
from core.design.results import RollersOnPins


class RollersOut(ResponseModel, of=PinRollers):
    """Rollers on the pins, by the roller with the largest load."""

    forces: ForcesUsed = forces_used()
    loss_W: Maybe[float] = result("Mean loss of all rollers.", symbol="P_b")
    added_clearance_mm: float = result(
        "Clearance that the rollers add to that of pins and holes, half of their radial "
        "internal clearance.",
        symbol="G_r/2",
    )
    tilt_mrad: Maybe[float] = result("Largest slope of a pin in its rollers.", symbol="θ")

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
