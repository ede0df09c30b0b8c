"""Request and answer of the contact lines."""

from typing import Literal

from pydantic import Field

from app.schemas.base import AccuracyOut, ResponseModel, Values, WarningOut, quantity
from app.schemas.precession.gear import GearFields
from core.errors import InvalidInput
from core.precession.contact_line import (
    ContactLines,
    ContactPoints,
    contact_lines,
    contact_points,
)

MAX_POINT_VALUES = 200_000
"""Most points of all contact lines together."""


class ContactLineRequest(GearFields):
    """A mesh whose contact lines are asked."""

    torque_sign: Literal[-1, 1] | None = quantity(
        "Sign of the torque",
        symbol="",
        group="load",
        default=None,
        help="Chooses the loaded flank of rollers whose limits are given in z.",
    )
    include: list[Literal["points"]] = Field(
        default=[], max_length=1, description="Optional results: what is not named is not computed."
    )
    samples: int = quantity(
        "Samples",
        symbol="",
        group="rollers",
        default=61,
        ge=2,
        le=10_001,
        step=1,
        advanced=True,
        help="Number of points of each contact line.",
    )

    def cost_ms(self, *, drawn: bool) -> float:
        """What the rollers cost, and 0.02 ms for each point."""
        points = 0.02 * self.samples * self.roller_count if "points" in self.include else 0.0
        return super().cost_ms(drawn=drawn) + points

    def solve(self) -> tuple[ContactLines, list[ContactPoints] | None]:
        """Contact lines, and their points where asked."""
        try:
            lines = contact_lines(
                **self.gear(), rollers=self.all_rollers(), torque_sign=self.torque_sign
            )
        except InvalidInput as error:
            raise self.about_the_wheel(error) from error
        if "points" not in self.include:
            return lines, None
        if self.samples * len(lines.lines) > MAX_POINT_VALUES:
            raise InvalidInput(
                "samples",
                self.samples,
                f"must be at most {MAX_POINT_VALUES // len(lines.lines)} for "
                f"{len(lines.lines)} rollers",
            )
        return lines, [contact_points(line=line, samples=self.samples) for line in lines.lines]


class PointsOut(ResponseModel):
    """Points of a contact line: developed on the roller (z over x) and in space."""

    z_mm: list[float]
    phi_deg: list[float]
    x_mm: list[float]
    position_mm: list[tuple[float, float, float]]


class ContactLineOut(ResponseModel):
    """One contact line."""

    position_angle_deg: float
    z_min_mm: float
    z_max_mm: float
    phi_min_deg: float
    phi_max_deg: float
    length_mm: float
    relative_error: float = Field(description="Bound of the relative error of its length.")
    points: PointsOut | None = None


class ContactLineResponse(ResponseModel):
    """Contact lines of all rollers."""

    lines: list[ContactLineOut]
    total_length_mm: float
    accuracy: AccuracyOut
    warnings: list[WarningOut] | None = None

    @classmethod
    def values(
        cls,
        result: tuple[ContactLines, list[ContactPoints] | None],
        run_time_us: float | None = None,
        **given: object,
    ) -> Values:
        """Values of the lines and their points."""
        found, points = result
        drawn = [None] * len(found.lines) if points is None else map(PointsOut.values, points)
        lines = [
            ContactLineOut.values(line, points=each)
            for line, each in zip(found.lines, drawn, strict=True)
        ]
        return super().values(found, run_time_us, lines=lines, **given)
