"""Contact lines of the precessional gear: request, answer, figure."""

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
from app.theme import INK, Amount, Figure, Theme, axis, curve, layout, series_style, text
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


def contact_line_figure(
    answer: Values,
    roller_circle_radius_mm: float,
    roller_radius_mm: float,
    theme: Theme,
) -> Figure:
    """Contact lines developed on their rollers, and the wheel along its axis and from the side.

    `answer` is a `ContactLineResponse` with points, in mm and degrees; the radii are R_C and rho.
    """
    data, lines = [], answer["lines"]
    for index, line in enumerate(lines):
        points = line["points"]
        colour, _, _ = series_style(index, theme)
        name = text("roller_angle", angle=Amount(line["position_angle_deg"], "°"))
        group: Figure = {
            "legendgroup": str(index),
            "showlegend": len(lines) <= MOST_NAMED,
        }
        data.append(
            curve(
                name,
                points["x_mm"],
                points["z_mm"],
                index,
                theme,
                text(
                    "length_of_line",
                    name=name,
                    length=Amount(line["length_mm"], "mm", 5),
                    x=Amount("%{x:.4g}", "mm"),
                    z=Amount("%{y:.4g}", "mm"),
                ),
                **group,
            )
        )
        seen: Figure = {
            "xaxis": "x2",
            "yaxis": "y2",
            "legendgroup": str(index),
            "showlegend": False,
        }
        angle = math.radians(line["position_angle_deg"])
        x, y = _circle(
            -roller_circle_radius_mm * math.sin(angle),
            roller_circle_radius_mm * math.cos(angle),
            roller_radius_mm,
        )
        data.append(
            curve(name, x, y, index, theme, name, **seen)
            | {"line": {"color": colour, "width": 1, "simplify": False}}
        )
        side = seen | {"xaxis": "x3"}
        middle = roller_circle_radius_mm * math.cos(angle)
        low, high = line["z_min_mm"], line["z_max_mm"]
        bottom, top = middle - roller_radius_mm, middle + roller_radius_mm
        data.append(
            curve(
                name,
                [low, high, high, low, low],
                [bottom, bottom, top, top, bottom],
                index,
                theme,
                name,
                **side,
            )
            | {"line": {"color": colour, "width": 1, "simplify": False}}
        )
        on_line = text("contact_line", name=name)
        across, upward, along = points["position_mm"].T
        for horizontal, view in ((across, seen), (along, side)):
            data.append(
                curve(name, horizontal, upward, index, theme, on_line, **view)
                | {"line": {"color": colour, "width": 4, "simplify": False}}
            )
    x, y = _circle(0.0, 0.0, roller_circle_radius_mm)
    data.append(
        curve(
            text("roller_circle"),
            x,
            y,
            2,
            theme,
            text("roller_circle"),
            xaxis="x2",
            yaxis="y2",
            showlegend=False,
        )
        | {"line": {"color": INK[theme]["muted"], "width": 1, "dash": "dot", "simplify": False}}
    )
    return {
        "data": data,
        "layout": layout(
            theme,
            height=820,
            xaxis=axis(theme, text("arc_on_roller"), "mm", anchor="y"),
            yaxis=axis(theme, text("along_axis"), "mm", domain=[0.6, 1]),
            xaxis2=axis(
                theme,
                "x",
                "mm",
                anchor="y2",
                domain=[0, 0.62],
                constrain="domain",  # the wheel fills its panel at any width
                constraintoward="left",
            ),
            xaxis3=axis(theme, "z", "mm", anchor="y2", domain=[0.7, 1]),
            yaxis2=axis(theme, "y", "mm", domain=[0, 0.48], scaleanchor="x2", constrain="domain"),
        ),
    }


def _circle(x: float, y: float, radius: float) -> tuple[list[float], list[float]]:
    """Points of a circle."""
    angles = [2 * math.pi * i / 48 for i in range(49)]
    return [x + radius * math.cos(a) for a in angles], [y + radius * math.sin(a) for a in angles]


def solve(body: ContactLineRequest) -> Values:
    """Contact lines of the rollers and their lengths; points for drawing on request."""
    return ContactLineResponse.values(*timed(body.solve))


def figure(body: ContactLineRequest, theme: Theme = "light") -> Figure:
    """Contact lines developed on the rollers, and the wheel seen along its axis."""
    lines = solve(body.model_copy(update={"include": ["points"], "samples": 41}))
    return contact_line_figure(lines, body.roller_circle_radius_mm, body.roller_radius_mm, theme)


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
