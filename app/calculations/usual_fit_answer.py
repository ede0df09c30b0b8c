"""Answers about a design with usual values of its unknown clearance or ring."""

from pydantic import Field

from app.model import Maybe, ResponseModel, Values, present, result
from app.units import from_si
from core.checks.check import Outcome, Verdict
from core.checks.reserve import crank_verdict
from core.checks.usual_modification import UsualModification
from core.design.real_forces import RealForces
from core.design.results import Results
from core.design.ring import RingClass
from core.errors import if_known


class UsualFitOut(ResponseModel):
    """Design with a usual clearance."""

    fit_class: str = Field(
        alias="class", description="Fit such as H7/f7; `printed` for holes softer than 20 GPa."
    )
    hole_clearance_mm: float = result("Radial clearance.", symbol="c")
    peak_force_N: Maybe[float] = result("Largest force of all pairs over the turn.", symbol="F_max")
    largest_torque_Nm: Maybe[float] = result(
        "Torque at which the first check fails, if requested and known."
    )
    verdict: Outcome = Field(description="Verdict of the design with the usual clearance.")

    @classmethod
    def of(cls, name: str, results: Results, judged: Verdict, *, largest: bool) -> Values:
        """Values of the design with a fit."""
        forces = if_known(lambda: results.judged_forces)
        values: Values = {
            "class": name,
            "hole_clearance_mm": from_si("clearance_mm", results.design.clearance),
            "peak_force_N": forces.turn.peak_force if isinstance(forces, RealForces) else None,
            "largest_torque_Nm": _largest_torque(results) if largest else None,
            "verdict": judged.verdict,
        }
        return present(values)


def _largest_torque(results: Results) -> float | None:
    """Torque at the first failure, N*m, as far as it is known."""
    judged = crank_verdict(results, largest=True)
    if not judged.largest_torque_known or judged.torque_reserve is None:
        return None
    return abs(results.design.output_torque) * judged.torque_reserve


class SpreadOut(ResponseModel):
    """Values that sampled pieces keep."""

    median: float = result("Value that half of the pieces do not exceed.")
    percent_90: float = result("Value that 90 % of the pieces do not exceed.")


class UsualModificationOut(ResponseModel, of=UsualModification):
    """Design with a usual ring: discs with a modification, if none is known, and pins anywhere in
    round zones. Forces are an upper estimate, as only the contacts are elastic.
    """

    BESIDE = ("peak_force_N", "max_pressure_MPa", "backlash_arcmin", "largest_torque_Nm", "verdict")

    ring_class: RingClass = Field(alias="class", description="Manufacture of discs and ring.")
    peak_force_N: SpreadOut = Field(
        description="Largest force of all pairs over the turn, under the torque times the "
        "application factor."
    )
    max_pressure_MPa: SpreadOut = Field(
        description="Largest pressure over the turn, under the torque times the application factor."
    )
    backlash_arcmin: SpreadOut = Field(
        description="Largest play of the output by the teeth alone over the turn."
    )
    largest_torque_Nm: Maybe[float] = result(
        "Torque at which the first check fails, if requested and known, for the piece whose "
        "pressure 90 % of the pieces do not exceed."
    )
    verdict: Outcome = Field(
        description="Verdict of the design with that piece, with a usual clearance if none is "
        "known."
    )

    @classmethod
    def of(cls, found: UsualModification, *, largest: bool) -> Values:
        """Values of the design with a usual ring."""
        at_output = found.results.design.members.angle_at_output

        def spread(name: str, median: float, percent_90: float) -> Values:
            return {"median": from_si(name, median), "percent_90": from_si(name, percent_90)}

        values = cls.values(
            found,
            peak_force_N=spread("force_N", *found.peak_force),
            max_pressure_MPa=spread("pressure_MPa", *found.max_pressure),
            backlash_arcmin=spread("angle_arcmin", *map(at_output, found.backlash)),
            verdict=found.verdict.verdict,
            largest_torque_Nm=_largest_torque(found.results) if largest else None,
        )
        return {"class": values.pop("ring_class"), **values}
