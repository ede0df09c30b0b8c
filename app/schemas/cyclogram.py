"""Request and answer of the cyclogram."""

import math

from app.schemas.base import AccuracyOut, RequestModel, ResponseModel, Values, WarningOut, quantity
from app.schemas.mechanism import MechanismFields
from app.units import UNITS
from core.errors import InvalidInput
from core.output.cyclogram import Cyclogram, cyclogram
from core.output.mechanism import AssemblyAngle, assembly_angles

Range = tuple[float, float]

ANGLE_DIGITS = 16
"""Digits of a period, or of a range shorter than that, to which angles are rounded: a part of their
own error."""

_, DEGREE = UNITS["deg"]
"""Size of a degree, rad."""

MAX_DRAWN_PHASES = 2000
"""Most driving phases that a figure shows."""


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

    @property
    def driving_phases(self) -> float:
        """About how often pairs drive in the range, at least once each."""
        return self.pairs * max(1.0, self.revolutions * (1 + 1 / self.ratio_given()))

    def cost_ms(self, *, drawn: bool) -> float:
        """About what the cyclogram costs; measured: 3 to 7 us a driving phase, 12 more drawn."""
        return (0.02 if drawn else 0.007) * self.driving_phases

    def refuse_undrawable(self) -> None:
        """Refuse a figure of more pairs or driving phases than anyone can tell apart.

        Raises
        ------
        InvalidInput
            If there are.
        """
        super().refuse_undrawable()
        if self.driving_phases > MAX_DRAWN_PHASES:
            raise InvalidInput(
                "revolutions",
                self.revolutions,
                f"must be at most {MAX_DRAWN_PHASES * self.revolutions / self.driving_phases:.3g} "
                f"to be drawn ({MAX_DRAWN_PHASES} driving phases)",
            )

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
    warnings: list[WarningOut] | None = None

    @classmethod
    def values(
        cls,
        result: tuple[Cyclogram, tuple[AssemblyAngle, ...] | None],
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
            assembly=assembly and [AssemblyAngleOut.values(each) for each in assembly],
            **given,
        )
