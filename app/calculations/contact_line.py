"""Contact lines of the precessional gear: request, answer, figure."""

import cmath
import math
from typing import Literal

from pydantic import Field

from app.calculations.gear import GearFields
from app.model import (
    Calculation,
    Maybe,
    ResponseModel,
    Values,
    Whole,
    WorkedResponse,
    quantity,
    result,
    timed,
)
from app.sources import KHATETOVSKY_2020
from app.theme import Amount, Chart, Figure, Theme, text
from app.worked import Steps
from core.errors import InvalidInput
from core.precession.contact_line import (
    ContactLine,
    ContactLines,
    ContactPoints,
    contact_lines,
    contact_points,
)
from core.worked.precession import line_steps

POINT_NUMBERS = 6
"""Numbers in the answer for each point."""

MAX_POINT_VALUES = 200_000
"""Largest number of points of all contact lines together."""


class ContactLineRequest(GearFields, group="load"):
    """Mesh whose contact lines are requested."""

    torque_sign: Maybe[Literal[-1, 1]] = quantity("Sign of the torque")
    """Sign of the torque, which chooses the loaded flank of rollers whose limits are given in z."""
    include: list[Literal["points", "worked"]] = Field(
        default=[],
        max_length=2,
        description="Optional results; only those that are named are computed.",
    )
    samples: Whole = quantity(
        "Samples", group="rollers", default=61, step=1, advanced=True, ge=2, le=10_001
    )
    """Number of points of each curve."""

    def cost(self) -> float:
        """Number of points of the contact lines, and of requested numbers."""
        return self.points(POINT_NUMBERS * self.samples if "points" in self.include else 0)

    def solve(self) -> tuple[ContactLines, list[ContactPoints] | None]:
        """Contact lines, with their points on request."""
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
                "with_rollers",
                limit=MAX_POINT_VALUES // len(lines.lines),
                rollers=len(lines.lines),
            )
        return lines, [contact_points(line=line, samples=self.samples) for line in lines.lines]

    def steps(self) -> Steps:
        """Worked steps of the contact lines."""
        lines, _ = self.model_copy(update={"include": []}).solve()
        return {"contact_line": line_steps(gear=self.gear(), found=lines, by_angle=self.by_angle)}


class PointsOut(ResponseModel, of=ContactPoints):
    """Points of a contact line: developed on the roller (z over x) and in space."""

    position_mm: list[tuple[float, float, float]]


class ContactLineOut(ResponseModel, of=ContactLine):
    """One contact line."""

    points: Maybe[PointsOut] = result("Points of the line, if requested.")


class ContactLineResponse(WorkedResponse, of=ContactLines):
    """Contact lines of all rollers."""

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


MOST_NAMED = 12
"""Largest number of rollers that a legend names."""


def _circle(centre: complex, radius: float) -> tuple[list[float], list[float]]:
    """Points of a circle."""
    points = [centre + radius * cmath.exp(2j * math.pi * i / 48) for i in range(49)]
    return [each.real for each in points], [each.imag for each in points]


def solve(body: ContactLineRequest) -> Values:
    """Contact lines of the rollers and their lengths; points for drawing on request."""
    return ContactLineResponse.values(*timed(body.solve))


def figure(body: ContactLineRequest, theme: Theme = "light") -> Figure:
    """Contact lines developed on the rollers, and the wheel seen along its axis."""
    lines = solve(body.model_copy(update={"include": ["points"], "samples": 41}))["lines"]
    circle, radius = body.roller_circle_radius_mm, body.roller_radius_mm
    chart = Chart(theme, height=820)
    chart.axis("x", "arc_on_roller", "mm", anchor="y")
    chart.axis("y", "along_axis", "mm", domain=[0.6, 1])
    # The wheel fills its panel at any width.
    wheel: Figure = {"constrain": "domain", "constraintoward": "left"}
    chart.axis("x2", "x", "mm", anchor="y2", domain=[0, 0.62], **wheel)
    chart.axis("x3", "z", "mm", anchor="y2", domain=[0.7, 1])
    equal: Figure = {"scaleanchor": "x2", "constrain": "domain", "anchor": "x2"}
    chart.axis("y2", "y", "mm", domain=[0, 0.48], **equal)
    place = {"x": Amount("%{x:.4g}", "mm"), "z": Amount("%{y:.4g}", "mm")}
    thin, thick = {"dash": "solid", "width": 1}, {"dash": "solid", "width": 4}
    for index, line in enumerate(lines):
        points, degrees = line["points"], line["position_angle_deg"]
        name = text("roller_angle", angle=Amount(degrees, "°"))
        length = Amount(line["length_mm"], "mm", 5)
        hovered = text("length_of_line", name=name, length=length, **place)
        own: Figure = {"legendgroup": str(index), "showlegend": len(lines) <= MOST_NAMED}
        chart.curve(name, points["x_mm"], points["z_mm"], index, hovered, **own)
        across, upward, along = points["position_mm"].T
        at = circle * 1j * cmath.exp(1j * math.radians(degrees))
        low, high = line["z_min_mm"], line["z_max_mm"]
        bottom, top = at.imag - radius, at.imag + radius
        sides = [low, high, high, low, low], [bottom, bottom, top, top, bottom]
        on_line = text("contact_line", name=name)
        view: Figure = own | {"axis": "y2", "showlegend": False}
        chart.curve(name, *_circle(at, radius), index, name, line=thin, **view)
        chart.curve(name, *sides, index, name, line=thin, xaxis="x3", **view)
        chart.curve(name, across, upward, index, on_line, line=thick, **view)
        chart.curve(name, along, upward, index, on_line, line=thick, xaxis="x3", **view)
    name, dotted = text("roller_circle"), {"color": chart.ink["muted"], "width": 1, "dash": "dot"}
    whole: Figure = {"axis": "y2", "showlegend": False, "line": dotted}
    chart.curve(name, *_circle(0, circle), 2, name, **whole)
    return chart.figure


CALCULATION = Calculation(
    name="precession/contact-line",
    title="Contact lines of the precessional gear",
    tag="precessional gear",
    request=ContactLineRequest,
    answer=ContactLineResponse,
    solve=solve,
    figure=figure,
    sources=(KHATETOVSKY_2020,),
    neglects=("deviations", "elasticity"),
)
