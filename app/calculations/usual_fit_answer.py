"""Answers about a design with usual values of its unknown clearance or ring."""

from pydantic import Field

from app.model import Maybe, ResponseModel, Values, result
from app.units import from_si
from core.checks.check import Outcome
from core.checks.usual_fit import UsualFit
from core.checks.usual_modification import UsualModification
from core.design.ring import RingClass


class UsualFitOut(ResponseModel, of=UsualFit):
    """Design with a usual clearance."""

    fit_class: str = Field(
        alias="class", description="Fit such as H7/f7; `printed` for holes softer than 20 GPa."
    )
    largest_torque_Nm: Maybe[float] = result(
        "Torque at which the first check fails, if requested and known."
    )
    verdict: Outcome = Field(description="Verdict of the design with the usual clearance.")

    @classmethod
    def of(cls, found: UsualFit, *, largest: bool) -> Values:
        """Values of the design with a fit."""
        torque = found.results.design.output_torque
        values = cls.values(
            found,
            fit_class=found.name,
            largest_torque_Nm=found.judged.largest_torque(torque) if largest else None,
            verdict=found.judged.verdict,
        )
        return {"class": values.pop("fit_class"), **values}


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
        design = found.results.design
        at_output = design.members.angle_at_output

        def spread(name: str, median: float, percent_90: float) -> Values:
            return {"median": from_si(name, median), "percent_90": from_si(name, percent_90)}

        values = cls.values(
            found,
            peak_force_N=spread("force_N", *found.peak_force),
            max_pressure_MPa=spread("pressure_MPa", *found.max_pressure),
            backlash_arcmin=spread("angle_arcmin", *map(at_output, found.backlash)),
            verdict=found.verdict.verdict,
            largest_torque_Nm=found.verdict.largest_torque(design.output_torque)
            if largest
            else None,
        )
        return {"class": values.pop("ring_class"), **values}
