"""Friction of the pins in the holes: request, answer, figure."""

import math
from typing import ClassVar, Literal

import numpy as np
from pydantic import Field

from app.calculations.document import (
    FORCES,
    TOUCHING,
    TURNING,
    ForcesUsed,
    Needs,
    StrengthFields,
    forces_used,
)
from app.calculations.ideal_forces import CurveFields
from app.model import (
    Calculation,
    DocumentResponse,
    Maybe,
    ResponseModel,
    Values,
    timed,
)
from app.sources import ARCHARD_1953, WANG_2016, YANCHEVSKIY_2021
from app.theme import (
    Amount,
    Figure,
    Theme,
    axis,
    curve,
    layout,
    note,
    text,
    vertical_line,
)
from app.units import from_si
from app.worked import Steps
from core.arrays import FloatArray
from core.design.curves import design_losses
from core.output.losses import LossCurves, PinLosses
from core.worked.losses import loss_steps


class OutputEfficiencyRequest(CurveFields, StrengthFields):
    """Design document with a load, a contact, and friction or rollers."""

    NEEDS: ClassVar[Needs] = (*TURNING, *TOUCHING, "friction")
    USES: ClassVar[frozenset[str]] = FORCES | {"friction", "requirements"}

    include: list[Literal["curves", "worked"]] = Field(
        default=[],
        max_length=2,
        description="Optional results; only those that are named are computed.",
    )

    def cost(self) -> float:
        """Number of points of the forces, or of the curves if more."""
        samples = self.samples if "curves" in self.include else 0
        return max(super().cost(), self.mechanism.points(samples=samples))

    def solve(self) -> PinLosses:
        """Losses, with the fit of pins in holes."""
        return self.with_fit(self.results.losses.pins)

    def steps(self) -> Steps:
        """Worked steps of friction and wear."""
        return {"output_efficiency": loss_steps(self.results)}

    def solve_all(self) -> tuple[PinLosses, LossCurves | None]:
        """Losses, with curves over a turn on request."""
        losses = self.solve()
        if "curves" not in self.include:
            return losses, None
        return losses, self.curves(losses, turn(self.samples_of(self.design.built)))

    def curves(self, losses: PinLosses, crank_angle: FloatArray) -> LossCurves:
        """Loss and efficiency at crank angles, rad."""
        return design_losses(results=self.results, losses=losses, crank_angle=crank_angle)

    def solve_for_drawing(self) -> tuple[PinLosses, LossCurves, FloatArray]:
        """Losses, curves for drawing, and the switching angles, rad."""
        angles, switching = self.drawn_angles()
        losses = self.solve()
        return losses, self.curves(losses, angles), switching


class LossCurvesOut(ResponseModel, of=LossCurves):
    """Loss and efficiency over one turn of the crank."""


class OutputEfficiencyResponse(DocumentResponse, of=PinLosses):
    """Sliding speed, loss, efficiency, pv and wear of the pins."""

    forces: ForcesUsed = forces_used()
    curves: Maybe[LossCurvesOut] = None

    @classmethod
    def values(
        cls,
        result: tuple[PinLosses, LossCurves | None],
        run_time_us: float | None = None,
        **given: object,
    ) -> Values:
        """Values of the core's losses and curves."""
        losses, curves = result
        drawn = None if curves is None else LossCurvesOut.values(curves)
        return super().values(losses, run_time_us, curves=drawn, **given)


CLEAR = (0, 1)
"""Places of the values of the means in each plot's height, clear of the curves: the loss never
comes near 0, and the efficiency fills its plot."""


def loss_figure(
    losses: PinLosses, curves: LossCurves, switching_deg: FloatArray, theme: Theme
) -> Figure:
    """Loss over the turn above, efficiency below, each with its mean and switching angles
    (degrees).
    """
    angles = from_si("crank_angle_deg", curves.crank_angle)
    end = float(angles[-1])
    angle = Amount("%{x:.2f}", "°")
    rows = (
        ("loss", "y", curves.loss, losses.mean_loss, "W"),
        ("efficiency", "y2", curves.efficiency, losses.efficiency, ""),
    )
    data = []
    for index, (name, own, values, mean, unit) in enumerate(rows):
        shown = Amount("%{y:.5g}", unit)
        hovered = text("at_angle", name=text(name), value=shown, angle=angle)
        data.append(curve(text(name), angles, values, 0, theme, hovered, colour=index, yaxis=own))
        average = text("mean_of", name=text(name))
        hovered = text("mean_hover", name=average, value=shown)
        across = curve(average, [0.0, end], [mean] * 2, 1, theme, hovered, colour=index, yaxis=own)
        data.append(across)
    return {
        "data": data,
        "layout": layout(
            theme,
            height=420,
            xaxis=axis(theme, text("crank_angle"), "°", range=[0, end], anchor="y2"),
            yaxis=axis(theme, text("loss"), "W", domain=[0.44, 1], rangemode="tozero"),
            yaxis2=axis(theme, text("efficiency"), domain=[0, 0.34]),
            shapes=[vertical_line(theme, place) for place in switching_deg.round(4).tolist()],
            annotations=[
                note(
                    theme,
                    text("mean_value", value=Amount(float(mean), unit, 5)),
                    x=end,
                    y=clear,
                    xref="x",
                    yref=f"{own} domain",
                    xanchor="right",
                    yanchor="bottom",
                )
                for (_, own, _, mean, unit), clear in zip(rows, CLEAR, strict=True)
            ],
        ),
    }


def turn(samples: int) -> FloatArray:
    """Crank angles of a turn, evenly spaced, both ends included, rad."""
    return np.linspace(0.0, 2 * math.pi, samples)


def solve(body: OutputEfficiencyRequest) -> Values:
    """Friction of the pins in the holes, or on their sleeves: loss, efficiency, pv and wear."""
    return OutputEfficiencyResponse.values(*timed(body.solve_all), forces=body.forces)


def figure(body: OutputEfficiencyRequest, theme: Theme = "light") -> Figure:
    """Loss and efficiency over the turn as a Plotly figure, ready for Plotly.js."""
    body.mechanism.refuse_undrawable()
    losses, curves, switching = body.solve_for_drawing()
    return loss_figure(losses, curves, from_si("switching_deg", switching), theme)


CALCULATION = Calculation(
    name="output-efficiency",
    title="Efficiency of the output mechanism",
    tag="crank-planetary",
    request=OutputEfficiencyRequest,
    answer=OutputEfficiencyResponse,
    solve=solve,
    figure=figure,
    sources=(YANCHEVSKIY_2021, WANG_2016, ARCHARD_1953),
    neglects=(
        "friction_on_forces",
        "heat",
        "lubricant_film",
        "seals",
    ),
)
