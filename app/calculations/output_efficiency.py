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
from app.theme import Amount, Chart, Figure, Theme, text
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


def turn(samples: int) -> FloatArray:
    """Crank angles of a turn, evenly spaced, both ends included, rad."""
    return np.linspace(0.0, 2 * math.pi, samples)


def solve(body: OutputEfficiencyRequest) -> Values:
    """Friction of the pins in the holes, or on their sleeves: loss, efficiency, pv and wear."""
    return OutputEfficiencyResponse.values(*timed(body.solve_all), forces=body.forces)


def figure(body: OutputEfficiencyRequest, theme: Theme = "light") -> Figure:
    """Loss and efficiency over the turn as a Plotly figure, ready for Plotly.js."""
    body.mechanism.refuse_undrawable()
    turn, switching = body.drawn_angles()
    losses = body.solve()
    curves = body.curves(losses, turn)
    angles = from_si("angle_deg", turn)
    end, chart = float(angles[-1]), Chart(theme, height=420)
    chart.axis("x", "crank_angle", "°", range=[0, end], anchor="y2")
    chart.axis("y", "loss", "W", domain=[0.44, 1], rangemode="tozero")
    chart.axis("y2", "efficiency", domain=[0, 0.34])
    # Values of the means are clear of the curves: the loss never comes near 0, and the efficiency
    # fills its plot.
    for colour, (axis, name, values, mean, unit, clear) in enumerate(
        (
            ("y", "loss", curves.loss, losses.mean_loss, "W", 0),
            ("y2", "efficiency", curves.efficiency, losses.efficiency, "", 1),
        )
    ):
        chart.curve(name, angles, values, axis=axis, colour=colour)
        average = text("mean_of", name=text(name))
        hovered = text("mean_hover", name=average, value=Amount("%{y:.5g}", unit))
        chart.curve(average, [0.0, end], [mean] * 2, 1, hovered, axis=axis, colour=colour)
        words = text("mean_value", value=Amount(float(mean), unit, 5))
        place = {"x": end, "y": clear, "xref": "x", "yref": f"{axis} domain"}
        chart.note(words, **place, xanchor="right", yanchor="bottom")
    chart.verticals(from_si("switching_deg", switching).round(4).tolist())
    return chart.figure


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
