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
from app.theme import (
    IDEAL,
    INK,
    Amount,
    Figure,
    Theme,
    axis,
    curve,
    drawn,
    layout,
    marker,
    note,
    text,
    vertical_line,
)
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
    curves, peak_pair = answer["curves"], answer["peak_pair"]
    angles, forces = drawn(curves["crank_angle_deg"]), drawn(curves["force_N"])  # all at once
    data = [
        curve(
            f"{pair['satellite']}.{pair['pin']}",
            angles,
            force,
            pair["pin"] - 1,
            theme,
            text(
                "pair_force", **pair, force=Amount("%{y:.5g}", "N"), angle=Amount("%{x:.2f}", "°")
            ),
            colour=pair["satellite"] - 1,
        )
        for pair, force in zip(curves["pairs"], forces, strict=True)
    ]
    top = answer["peak_force_N"]
    if ideal is not None:
        top = max(top, ideal["peak_force_N"])
        data.append(_ideal_largest(ideal["curves"], theme))
    peak = {"x": answer["peak_crank_angle_deg"], "y": answer["peak_force_N"]}
    data.append(
        marker(
            text("peak"),
            peak["x"],
            peak["y"],
            theme,
            text(
                "peak_hover",
                **peak_pair,
                force=Amount("%{y:.6g}", "N"),
                angle=Amount("%{x:.3f}", "°"),
            ),
        )
    )
    return {
        "data": data,
        "layout": layout(
            theme,
            height=380,
            xaxis=axis(theme, text("crank_angle"), "°", range=[0, 360], dtick=30),
            yaxis=axis(theme, text("contact_force"), "N", range=[0, 1.15 * top]),
            shapes=[vertical_line(theme, place) for place in np.round(switching_deg, 4).tolist()],
            annotations=[
                note(
                    theme,
                    text("amount", amount=Amount(answer["peak_force_N"], "N", 5)),
                    xref="x",
                    yref="y",
                    **peak,
                    yshift=16,
                    xanchor="left" if peak["x"] < 180 else "right",
                ),
            ],
        ),
    }


def _ideal_largest(curves: Values, theme: Theme) -> Figure:
    """Curve of the largest ideal force of all pairs."""
    name, angle = text("ideal_largest"), Amount("%{x:.2f}", "°")
    hovered = text("at_angle", name=name, value=Amount("%{y:.5g}", "N"), angle=angle)
    largest = np.max(drawn(curves["force_N"]), axis=0)
    own = curve(name, curves["crank_angle_deg"], largest, 0, theme, hovered)
    line = own["line"] | {"width": 1, "dash": "dot", "color": INK[theme]["text"]}
    return own | {"meta": IDEAL, "line": line}


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
