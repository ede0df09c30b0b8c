"""Request and answer of the cyclogram."""

from itertools import islice

import numpy as np

from app.schemas.base import AccuracyOut, RequestModel, ResponseModel, Values, quantity
from app.schemas.mechanism import MechanismFields
from app.units import from_si
from core.cyclogram import Cyclogram, cyclogram
from core.mechanism import AssemblyAngle, assembly_angles

Range = tuple[float, float]


class RangeFields(RequestModel):
    """How much of the turn the cyclogram shows."""

    revolutions: float = quantity(
        "Crank revolutions",
        symbol="",
        group="mechanism",
        default=1.0,
        gt=0,
        le=1e6,
        step=1,
        advanced=True,
        help="Length of the cyclogram, in turns of the crank.",
    )


class CyclogramRequest(MechanismFields, RangeFields):
    """A mechanism and the range of its cyclogram."""

    def cost_ms(self, *, drawn: bool) -> float:
        """About 0.02 ms a pair and revolution, thrice that drawn."""
        return (0.07 if drawn else 0.02) * self.pairs * max(1.0, self.revolutions)

    def solve(self) -> tuple[Cyclogram, tuple[AssemblyAngle, ...] | None]:
        """Cyclogram, and the assembly angles where the numbers of teeth are given."""
        mechanism = self.mechanism()
        assembly = (
            assembly_angles(mechanism=mechanism, satellite_teeth=self.satellite_teeth)
            if self.satellite_teeth is not None
            else None
        )
        return cyclogram(mechanism=mechanism, revolutions=self.revolutions), assembly


class DrivingPairOut(ResponseModel):
    """When one pair drives."""

    satellite: int
    pin: int
    driving_deg: list[Range]


class CountIntervalOut(ResponseModel):
    """A range of crank angle with one number of driving pairs."""

    from_deg: float
    to_deg: float
    pairs: int


class AssemblyAngleOut(ResponseModel):
    """Rotation of one satellite's holes against its teeth."""

    satellite: int
    hole_rotation_deg: float
    identical: bool


class CyclogramResponse(ResponseModel):
    """Which pairs drive, when, how many together."""

    working_phase_deg: float
    period_deg: float
    pattern_period_deg: float
    pairs: list[DrivingPairOut]
    driving_count: list[CountIntervalOut]
    min_driving: int
    max_driving: int
    mean_driving: float
    dead_centres_deg: list[float]
    dead_zones_deg: list[Range] | None = None
    assembly: list[AssemblyAngleOut] | None = None
    accuracy: AccuracyOut

    @classmethod
    def values(
        cls,
        result: tuple[Cyclogram, tuple[AssemblyAngle, ...] | None],
        run_time_us: float | None = None,
        **given: object,
    ) -> Values:
        """Values of the core's result."""
        found, assembly = result
        # All angles at once: one by one they would cost more than the calculation.
        angles = [found.working_phase, found.period, found.pattern_period]
        for pair in found.pairs:
            for phase in pair.driving:
                angles += phase
        angles += [each.end for each in found.driving_count]
        degrees = iter(from_si("angle_deg", np.array(angles)).tolist())
        for name in ("working_phase_deg", "period_deg", "pattern_period_deg"):
            given[name] = next(degrees)
        phases = zip(degrees, degrees, strict=False)  # what follows them stays
        pairs = [
            {
                "satellite": satellite,
                "pin": pin,
                "driving_deg": list(islice(phases, len(driving))),
            }
            for satellite, pin, driving in found.pairs
        ]
        counts, start = [], 0.0
        for each, end in zip(found.driving_count, degrees, strict=True):
            counts.append({"from_deg": start, "to_deg": end, "pairs": each.pairs})
            start = end
        return super().values(
            found,
            run_time_us,
            pairs=pairs,
            driving_count=counts,
            dead_zones_deg=from_si("dead_zones_deg", found.dead_zones) or None,
            assembly=assembly and [AssemblyAngleOut.values(each) for each in assembly],
            **given,
        )
