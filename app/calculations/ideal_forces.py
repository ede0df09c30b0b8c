"""Cyclogram and contact force by ideal forces: fields of requests and answers."""

import math
from dataclasses import replace
from typing import Any, Literal

from pydantic import Field

from app.calculations.mechanism import MechanismFields, PairOut
from app.fields import SectionFields
from app.model import (
    AssumingResponse,
    Maybe,
    RequestModel,
    ResponseModel,
    Values,
    Whole,
    quantity,
    result,
)
from app.settings import Settings
from app.units import UNITS, from_si, rounded, to_si
from core.arrays import FloatArray
from core.design.sections import Load
from core.design.stated import output_torque
from core.errors import ImpossibleMechanism, InvalidInput, required
from core.output.contact_force import (
    ContactForce,
    CountInterval,
    Cyclogram,
    DrivingPair,
    ForceCurves,
    contact_force,
    cyclogram,
    drawing_angles,
    force_curves,
)
from core.output.mechanism import AssemblyAngle, Mechanism, Members, assembly_angles

Range = tuple[float, float]

ANGLE_DIGITS = 16
"""Digits of the period, or of a shorter range, to which angles are rounded: below their own
error."""

_, DEGREE = UNITS["deg"]
"""Size of a degree, rad."""

MAX_DRAWN_PHASES = 2000
"""Largest number of driving phases in a figure."""


ForceSection = Literal["curves", "equal_sharing", "approximation"]

MAX_SAMPLES = 10_001

FORCE_DIGITS = 12
"""Digits of forces in curves, relative to the largest force, which saves bytes."""

MAX_CURVE_VALUES = 1_000_000


class RangeFields(RequestModel, group="mechanism"):
    """Range of the turn that the cyclogram shows."""

    revolutions: float = quantity(
        "Crank revolutions", default=1.0, step=1, advanced=True, gt=0, le=1e6
    )
    """Length of the cyclogram in turns of the crank."""


class CyclogramFields(MechanismFields, RangeFields):
    """Mechanism and the range of its cyclogram."""

    def cost(self) -> float:
        """Number of points of its pairs and turns."""
        return self.points(revolutions=self.revolutions)

    @property
    def driving_phases(self) -> float:
        """Approximate number of driving phases in the range, at least one for each pair."""
        return self.pairs * max(1.0, self.revolutions * self.mechanism().waves_per_turn)

    def refuse_undrawable(self) -> None:
        """Refuse a figure of more pairs or driving phases than anyone can tell apart."""
        super().refuse_undrawable()
        if self.driving_phases > MAX_DRAWN_PHASES:
            most = MAX_DRAWN_PHASES * self.revolutions / self.driving_phases
            raise InvalidInput("revolutions", self.revolutions, "to_be_drawn", limit=most)

    def solve(self) -> tuple[Cyclogram, tuple[AssemblyAngle, ...]]:
        """Cyclogram, and assembly angles if the numbers of teeth are given."""
        return self.solve_for(self.mechanism())

    def solve_for(self, mechanism: Mechanism) -> tuple[Cyclogram, tuple[AssemblyAngle, ...]]:
        """Cyclogram under a torque: of the mechanism whose driving pairs are those that carry."""
        found = cyclogram(mechanism=mechanism, revolutions=self.revolutions)
        if teeth := self.satellite_teeth:
            return found, assembly_angles(mechanism=mechanism, satellite_teeth=teeth)
        return found, ()


class DrivingPairOut(PairOut, of=DrivingPair):
    """Driving phases of one pair."""


class CountIntervalOut(ResponseModel, of=CountInterval):
    """Range of the crank angle with one number of driving pairs."""

    from_deg: float = result("Crank angle at the start of the range.", symbol="φ")
    to_deg: float = result("Crank angle at the end of the range.", symbol="φ")
    pairs: int = result("Number of driving pairs within the range.")


class AssemblyAngleOut(ResponseModel, of=AssemblyAngle):
    """Rotation of one satellite's holes against its teeth."""


class CyclogramResponse(AssumingResponse, of=Cyclogram):
    """Pairs that drive, with their phases and numbers."""

    dead_zones_deg: Maybe[list[Range]]
    assembly: Maybe[list[AssemblyAngleOut]] = result(
        "Angles of the satellites' holes relative to their teeth, if the teeth are given."
    )

    @classmethod
    def values(
        cls,
        result: tuple[Cyclogram, tuple[AssemblyAngle, ...]],
        run_time_us: float | None = None,
        **given: object,
    ) -> Values:
        """Values of the core's result."""
        found, assembly = result
        # One by one and in one step: there are too few for arrays, and none is below 0.
        finest = min(found.driving_count[-1].end, found.period) / DEGREE
        place = 10.0 ** (ANGLE_DIGITS - 1 - math.floor(math.log10(finest)))

        def degrees(angle: float) -> float:
            return int(angle / DEGREE * place + 0.5) / place

        return super().values(
            found,
            run_time_us,
            working_phase_deg=degrees(found.working_phase),
            period_deg=degrees(found.period),
            pattern_period_deg=degrees(found.pattern_period),
            pairs=[
                {
                    "satellite": satellite,
                    "pin": pin,
                    "driving_deg": [(degrees(start), degrees(stop)) for start, stop in driving],
                }
                for satellite, pin, driving in found.pairs
            ],
            driving_count=[
                {"from_deg": degrees(start), "to_deg": degrees(stop), "pairs": pairs}
                for start, stop, pairs in found.driving_count
            ],
            dead_centres_deg=[*map(degrees, found.dead_centres)],
            dead_zones_deg=[(degrees(start), degrees(stop)) for start, stop in found.dead_zones]
            or None,
            assembly=[AssemblyAngleOut.values(each) for each in assembly] or None,
            **given,
        )


class TorqueFields(
    SectionFields,
    of=Load,
    only=(
        *("output_torque", "input_torque", "efficiency"),
        *("pin_circle_radius", "force_exponent"),
    ),
    group="load",
):
    """Torque, lever and load sharing of the pins."""

    def force_given(self, members: Members) -> dict[str, Any]:
        """Load as the worked steps of the force take it."""
        own = self.stated
        driven_by = (own["input_torque"], own["efficiency"]) if "input_torque" in own else None
        return {
            "members": members,
            "output_torque": self.torque(members),
            "pin_circle_radius": own.get("pin_circle_radius"),
            "force_exponent": self.force_exponent,
            "driven_by": driven_by,
        }

    def torque(self, members: Members) -> float | None:
        """Torque of the output, N*m; None if it is not given."""
        return output_torque(load=self.stated, members=members)

    def pin_torque(self, members: Members) -> float:
        """Torque on the pins, N*m."""
        torque = required(self.torque(members), "size_missing", "load.output_torque")
        return torque * members.pin_share


class CurveFields(RequestModel, group="load"):
    """Resolution of curves."""

    samples: Whole = quantity("Samples", default=361, step=1, advanced=True, ge=2, le=MAX_SAMPLES)
    """Number of points of each curve."""

    def refuse_beyond(self, settings: Settings) -> None:
        """Refuse more samples than the operator allows."""
        if self.samples > settings.max_curve_samples:
            raise InvalidInput(
                "samples", self.samples, "service_limit", limit=settings.max_curve_samples
            )
        super().refuse_beyond(settings)

    def samples_of(self, mechanism: Mechanism) -> int:
        """Number of points of each curve; refused above `MAX_CURVE_VALUES` for all pairs."""
        pairs = mechanism.pins * mechanism.satellites
        if self.samples * pairs > MAX_CURVE_VALUES:
            raise InvalidInput(
                "samples", self.samples, "service_limit", limit=MAX_CURVE_VALUES // pairs
            )
        return self.samples


class LoadFields(CurveFields, TorqueFields):
    """Torque, lever and load sharing of the pins, and requested results of the force."""

    include: list[ForceSection] = Field(
        default=[],
        max_length=3,
        description="Optional results; only those that are named are computed.",
    )

    @property
    def curve_samples(self) -> int:
        """Number of points of each curve; 0 if no curves are requested."""
        return self.samples if "curves" in self.include else 0

    def solve_for(self, mechanism: Mechanism, members: Members) -> ContactForce:
        """Contact force of a mechanism under this load, as far as it is requested."""
        return contact_force(
            mechanism=mechanism,
            output_torque=self.pin_torque(members),
            pin_circle_radius=to_si("pin_circle_radius_mm", self.pin_circle_radius_mm),
            force_exponent=self.force_exponent,
            curve_samples=self.samples_of(mechanism) if "curves" in self.include else None,
            equal_sharing="equal_sharing" in self.include,
            approximation="approximation" in self.include,
        )

    def solve_for_drawing(
        self, mechanism: Mechanism, members: Members
    ) -> tuple[ContactForce, FloatArray]:
        """Contact force with curves for drawing, and the switching angles, rad."""
        angles, switching = drawing_angles(mechanism=mechanism)
        force = self.model_copy(update={"include": []}).solve_for(mechanism, members)
        curves = force_curves(
            mechanism=mechanism,
            crank_angle=angles,
            reference=force.reference_force,
            force_exponent=self.force_exponent,
        )
        return replace(force, curves=curves), switching


def force_of_one(mechanism: MechanismFields, load: LoadFields) -> Values:
    """Peak force of one satellite alone, stated if the number of satellites is assumed."""
    one = mechanism.model_copy(update={"satellites": 1, "crank_spacing_deg": None}).mechanism()
    try:
        found = contact_force(
            mechanism=one,
            output_torque=load.pin_torque(mechanism.members),
            pin_circle_radius=to_si("pin_circle_radius_mm", load.pin_circle_radius_mm),
            force_exponent=load.force_exponent,
        )
    except ImpossibleMechanism:  # at a dead centre of fewer pairs
        return {}
    return {"without": {"peak_force_N": from_si("peak_force_N", found.peak_force)}}


class ForceCurvesOut(ResponseModel, of=ForceCurves):
    """Force of every pair over the turn: one list for each pair, in the order of `pairs`, rounded
    to 12 digits of the largest force.
    """

    @classmethod
    def values(cls, result: ForceCurves, run_time_us: float | None = None, **given: Any) -> Values:
        """Values of the core's curves."""
        forces = rounded(from_si("force_N", result.force), FORCE_DIGITS)
        return super().values(result, run_time_us, force_N=forces, **given)


class ContactForceResponse(AssumingResponse, of=ContactForce):
    """Exact peak of the contact force, and requested results."""
