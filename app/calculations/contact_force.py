"""Contact force of the pairs: its request and its figure."""

from typing import ClassVar, Literal

import numpy as np
from pydantic import Field

from app.calculations.ideal_forces import ContactForceResponse, LoadFields, force_of_one
from app.calculations.mechanism import MechanismFields
from app.model import (
    Calculation,
    Values,
    timed,
)
from app.rules import Forms
from app.sources import YANCHEVSKIY_2021, YANCHEVSKY_2018, ZYL
from app.theme import IDEAL, Amount, Chart, Figure, Theme, drawn, text
from app.units import from_si
from app.worked import Steps
from core.arrays import FloatArray
from core.design.sections import Load, MechanismSection
from core.output.contact_force import (
    ContactForce,
)
from core.worked.mechanism import force_steps

RequestSection = Literal["curves", "equal_sharing", "approximation", "worked"]


class LeverFields(
    LoadFields, of=Load, only=("pin_circle_radius",), needs=("pin_circle_radius",), group="load"
):
    """Load with its lever."""


class ContactForceRequest(
    MechanismFields, LeverFields, of=MechanismSection, needs=("pins",), group="mechanism"
):
    """A mechanism and its load."""

    ALTERNATIVES: ClassVar[tuple[Forms, ...]] = (
        (("output_torque_Nm",), ("input_torque_Nm", "efficiency")),
    )

    def cost(self) -> float:
        """Number of points of its pairs and curves."""
        return self.points(exponent=self.force_exponent, samples=self.curve_samples)

    def without(self, path: tuple[str, ...]) -> Values:
        """Peak force of one satellite, if the number of satellites is assumed."""
        return force_of_one(self, self)

    include: list[RequestSection] = Field(  # type: ignore[assignment]
        default=[],
        max_length=4,
        description="Optional results; only those that are named are computed.",
    )

    def solve(self) -> ContactForce:
        """Contact force of the mechanism under the load."""
        return self.solve_for(self.mechanism(), self.members)

    def steps(self) -> Steps:
        """Worked steps of the force."""
        mechanism = self.mechanism()
        given = self.force_given(self.members)
        return {"contact_force": force_steps(mechanism=mechanism, found=self.solve(), **given)}


def contact_force_figure(
    answer: Values, switching_deg: FloatArray, theme: Theme, ideal: Values | None = None
) -> Figure:
    """Force of every pair over the turn, thin lines at switching angles, and the peak.

    Parameters
    ----------
    answer : dict
        Answer of `/contact-force` with curves.
    switching_deg : array
        Crank angles at which a pair starts or stops driving, degrees.
    ideal : dict, optional
        Ideal forces with curves beside solved ones; their largest force is drawn as a thin line.
    """
    curves, top = answer["curves"], answer["peak_force_N"]
    x, y = answer["peak_crank_angle_deg"], answer["peak_force_N"]
    if ideal is not None:
        top = max(top, ideal["peak_force_N"])
    chart = Chart(theme, height=380)
    chart.axis("x", "crank_angle", "°", range=[0, 360], dtick=30)
    chart.axis("y", "contact_force", "N", range=[0, 1.15 * top])
    angles, forces = drawn(curves["crank_angle_deg"]), drawn(curves["force_N"])  # all at once
    shown = {"force": Amount("%{y:.5g}", "N"), "angle": Amount("%{x:.2f}", "°")}
    for pair, force in zip(curves["pairs"], forces, strict=True):
        satellite, pin = pair["satellite"], pair["pin"]
        hovered, colour = text("pair_force", **pair, **shown), satellite - 1
        chart.curve(f"{satellite}.{pin}", angles, force, pin - 1, hovered, colour=colour)
    if ideal is not None:
        largest = np.max(drawn(ideal["curves"]["force_N"]), axis=0)
        thin = {"width": 1, "dash": "dot", "color": chart.ink["text"]}
        ideal_angles = ideal["curves"]["crank_angle_deg"]
        chart.curve("ideal_largest", ideal_angles, largest, meta=IDEAL, line=thin)
    shown = {"force": Amount("%{y:.6g}", "N"), "angle": Amount("%{x:.3f}", "°")}
    chart.mark("peak", x, y, text("peak_hover", **answer["peak_pair"], **shown))
    chart.verticals(np.round(switching_deg, 4).tolist())
    side = {"yshift": 16, "xanchor": "left" if x < 180 else "right"}
    chart.note(text("amount", amount=Amount(y, "N", 5)), x=x, y=y, xref="x", yref="y", **side)
    return chart.figure


def solve(body: ContactForceRequest) -> Values:
    """Contact force of the pairs: the exact peak, and curves and approximations on request."""
    return ContactForceResponse.values(*timed(body.solve))


def figure(body: ContactForceRequest, theme: Theme = "light") -> Figure:
    """Force of every pair over the turn as a Plotly figure, ready for Plotly.js."""
    body.refuse_undrawable()
    (force, switching), run_time_us = timed(
        lambda: body.solve_for_drawing(body.mechanism(), body.members)
    )
    answer = ContactForceResponse.values(force, run_time_us)
    return contact_force_figure(answer, from_si("switching_deg", switching), theme)


CALCULATION = Calculation(
    name="contact-force",
    title="Contact force",
    tag="crank-planetary",
    request=ContactForceRequest,
    answer=ContactForceResponse,
    solve=solve,
    figure=figure,
    sources=(YANCHEVSKIY_2021, YANCHEVSKY_2018, ZYL),
    neglects=("clearance", "deviations", "friction", "pin_bending", "equal_discs"),
)
