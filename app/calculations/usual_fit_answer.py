"""Answer of a design with a usual clearance."""

from pydantic import Field

from app.model import Maybe, ResponseModel, Values, result
from app.units import from_si
from core.checks.check import Verdict
from core.checks.part import Outcome
from core.derived import if_known
from core.design.real_forces import RealForces
from core.design.results import Results


class UsualFitOut(ResponseModel):
    """The design with a clearance as such parts usually have."""

    fit_class: str = Field(
        alias="class", description="The fit, as H7/f7; `printed` of holes softer than 20 GPa."
    )
    hole_clearance_mm: float = result("Radial clearance.", symbol="c")
    peak_force_N: Maybe[float] = result("Largest force of all pairs over the turn.", symbol="F_max")
    largest_torque_Nm: Maybe[float] = result(
        "Torque at which the first check fails, as far as it is known."
    )
    verdict: Outcome = Field(description="Of the design with it.")

    @classmethod
    def of(cls, name: str, results: Results, judged: Verdict) -> Values:
        """Values of the design with a fit."""
        forces = if_known(lambda: results.judged_forces)
        torque = results.design.load.output_torque
        known = judged.largest_torque_known and judged.torque_reserve is not None
        values: Values = {
            "class": name,
            "hole_clearance_mm": from_si("clearance_mm", results.design.contact.clearance),
            "peak_force_N": forces.turn.peak_force if isinstance(forces, RealForces) else None,
            "largest_torque_Nm": abs(torque) * (judged.torque_reserve or 0.0) if known else None,
            "verdict": judged.verdict,
        }
        return {name: value for name, value in values.items() if value is not None}
