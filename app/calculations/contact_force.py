"""Contact force of the pairs: request, answer, figure."""

from dataclasses import replace
from functools import partial
from typing import Any, ClassVar, Literal

import numpy as np
from pydantic import Field

from app.calculations.mechanism import MechanismFields, PairOut
from app.model import (
    AccuracyOut,
    AssumingResponse,
    Calculation,
    Maybe,
    RequestModel,
    ResponseModel,
    Size,
    Values,
    WarningOut,
    Whole,
    quantity,
    result,
    timed,
)
from app.rules import Forms
from app.settings import Settings
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
from app.units import from_si, rounded, to_si
from app.worked import worked
from core.arrays import FloatArray
from core.errors import ImpossibleMechanism, InvalidInput
from core.output.contact_force import (
    ContactForce,
    ForceCurves,
    contact_force,
    drawing_angles,
    force_curves,
    force_ratios,
    output_torque_from_input,
    reference_force,
)
from core.output.mechanism import Mechanism, Members
from core.worked.mechanism import force_steps
from core.worked.step import Step

ForceSection = Literal["curves", "equal_sharing", "approximation"]

RequestSection = Literal["curves", "equal_sharing", "approximation", "worked"]

MAX_SAMPLES = 10_001

FORCE_DIGITS = 12
"""Digits of the largest force of curves: fewer bytes, and still finer than any use."""

MAX_CURVE_VALUES = 1_000_000


application_factor = partial(
    quantity,
    "Application factor",
    "K_A",
    step=0.05,
    help="Factor on the torque for stresses and pressures, not for losses, wear and the life of "
    "bearings; not beside the contact's dynamic factor, which is the same.",
)

pin_circle_radius = partial(
    quantity,
    "Pin circle radius",
    "R",
    step=1,
    help="Radius of the circle of pin centres.",
)

peak_torque = partial(
    quantity,
    "Peak torque",
    "T_max",
    step=10,
    help="Largest torque, for static strength, at least the torque times its factor; that where "
    "not given.",
)


class TorqueFields(RequestModel, group="load"):
    """Torque, lever and load sharing of the pins."""

    ALTERNATIVES: ClassVar[tuple[Forms, ...]] = (
        (("output_torque_Nm",), ("input_torque_Nm", "efficiency")),
    )

    output_torque_Nm: Maybe[Size] = quantity("Output torque", "T", step=10)
    """Torque of the output; where both are it that on the pins."""
    input_torque_Nm: Maybe[Size] = quantity("Input torque", "T₁", step=1)
    """Torque on the crankshaft; T = T₁·i·η, i being u, or u + 1 where the ring is the output."""
    efficiency: Maybe[float] = quantity("Efficiency", "η", step=0.01, ge=1e-3, le=1)
    """Efficiency of the reducer, needed with the input torque."""
    pin_circle_radius_mm: Size = pin_circle_radius()
    force_exponent: float = quantity("Force exponent", "v", default=1.0, step=0.1, ge=0, le=1e6)
    """Force ∝ approach^v: 0 equal sharing, 1 linear, 10/9 and 3/2 the usual contact laws."""

    def force_given(self, members: Members) -> dict[str, Any]:
        """The load as the worked steps of the force take it."""
        return {
            "members": members,
            "output_torque": self.torque(members),
            "pin_circle_radius": to_si("pin_circle_radius_mm", self.pin_circle_radius_mm),
            "force_exponent": self.force_exponent,
            "driven_by": self._driven_by,
        }

    @property
    def _driven_by(self) -> tuple[float, float] | None:
        """Torque on the crankshaft, N*m, and efficiency, where these are given."""
        match self.given:
            case {"input_torque_Nm": torque, "efficiency": efficiency}:
                return torque, efficiency
        return None

    def torque(self, members: Members) -> float:
        """Torque of the output, N*m."""
        match self.given:
            case {"output_torque_Nm": torque}:
                return float(torque)
            case given:
                return output_torque_from_input(
                    input_torque=given["input_torque_Nm"],
                    ratio=members.torque_ratio,
                    efficiency=given["efficiency"],
                )

    def pin_torque(self, members: Members) -> float:
        """Torque on the pins, N*m."""
        return self.torque(members) * members.pin_share


class CurveFields(RequestModel, group="load"):
    """How finely curves are asked."""

    samples: Whole = quantity("Samples", default=361, step=1, advanced=True, ge=2, le=MAX_SAMPLES)
    """Number of points of each curve."""

    def refuse_beyond(self, settings: Settings) -> None:
        """Refuse more samples than the operator allows.

        Raises
        ------
        InvalidInput
            If there are.
        """
        if self.samples > settings.max_curve_samples:
            raise InvalidInput(
                "samples", self.samples, "service_limit", limit=settings.max_curve_samples
            )
        super().refuse_beyond(settings)

    def samples_of(self, mechanism: Mechanism) -> int:
        """Points of each curve, where the service sends so many for a mechanism.

        Raises
        ------
        InvalidInput
            If there are more than `MAX_CURVE_VALUES` for all pairs.
        """
        pairs = mechanism.pins * mechanism.satellites
        if self.samples * pairs > MAX_CURVE_VALUES:
            raise InvalidInput(
                "samples", self.samples, "service_limit", limit=MAX_CURVE_VALUES // pairs
            )
        return self.samples


class LoadFields(CurveFields, TorqueFields):
    """Torque, lever and load sharing of the pins, and what is asked of the force."""

    include: list[ForceSection] = Field(
        default=[], max_length=3, description="Optional results: what is not named is not computed."
    )

    @property
    def curve_samples(self) -> int:
        """Points of each curve; 0 where none is asked."""
        return self.samples if "curves" in self.include else 0

    def solve_for(self, mechanism: Mechanism, members: Members) -> ContactForce:
        """Contact force of a mechanism under this load; what is not included is not computed."""
        return contact_force(
            mechanism=mechanism,
            output_torque=self.pin_torque(members),
            pin_circle_radius=to_si("pin_circle_radius_mm", self.pin_circle_radius_mm),
            force_exponent=self.force_exponent,
            curve_samples=self.samples_of(mechanism) if "curves" in self.include else None,
            equal_sharing="equal_sharing" in self.include,
            approximation="approximation" in self.include,
        )

    def forces_at(self, mechanism: Mechanism, members: Members, crank_angle: float) -> FloatArray:
        """Force of every pair, N, shape (K, N), at a crank angle, rad."""
        reference = reference_force(
            output_torque=self.pin_torque(members),
            pin_circle_radius=to_si("pin_circle_radius_mm", self.pin_circle_radius_mm),
        )
        ratios = force_ratios(
            mechanism=mechanism,
            crank_angles=np.array([crank_angle]),
            force_exponent=self.force_exponent,
        )
        forces: FloatArray = reference * ratios[0]
        return forces

    def solve_for_drawing(
        self, mechanism: Mechanism, members: Members
    ) -> tuple[ContactForce, FloatArray]:
        """Contact force with curves fit to be drawn, and the switching angles, rad."""
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
    """The peak force of one satellite alone, which answers say where their number is assumed."""
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


class ContactForceRequest(MechanismFields, LoadFields):
    """A mechanism and its load."""

    def cost(self) -> float:
        """Points of its pairs and curves."""
        return self.points(exponent=self.force_exponent, samples=self.curve_samples)

    def without(self, path: tuple[str, ...]) -> Values:
        """The peak force of one satellite, where their number is assumed."""
        return force_of_one(self, self)

    include: list[RequestSection] = Field(  # type: ignore[assignment]
        default=[], max_length=4, description="Optional results: what is not named is not computed."
    )

    def solve(self) -> ContactForce:
        """Contact force of the mechanism under the load."""
        return self.solve_for(self.mechanism(), self.members)

    def steps(self) -> list[Step]:
        """Worked steps of the force."""
        mechanism = self.mechanism()
        given = self.force_given(self.members)
        return force_steps(mechanism=mechanism, found=self.solve(), **given)


class ForceCurvesOut(ResponseModel):
    """Force of every pair over the turn: one list for each pair, in the order of `pairs`, rounded
    to 12 digits of the largest force.
    """

    crank_angle_deg: list[float] = result("Crank angles of the curves.", symbol="φ")
    force_N: list[list[float]] = result(
        "Forces, a list for each pair.", symbol="F_jn", equation="2021, eq. 10"
    )
    pairs: list[PairOut] = result("The pairs, in the order of the forces.")

    @classmethod
    def values(cls, result: ForceCurves, run_time_us: float | None = None, **given: Any) -> Values:
        """Values of the core's curves."""
        forces = rounded(from_si("force_N", result.force), FORCE_DIGITS)
        return super().values(result, run_time_us, force_N=forces, **given)


class ContactForceResponse(AssumingResponse):
    """The exact peak of the contact force, and what was asked besides."""

    reference_force_N: float = result(
        "Torque over the radius of the pin circle.", symbol="F_0", equation="2018; 2021"
    )
    peak_force_N: float = result(
        "Largest ideal contact force over the turn, by force_exponent.",
        symbol="F_max",
        equation="2021, eq. 10",
    )
    peak_force_ratio: float = result(
        "Largest contact force over the reference force.", symbol="f", equation="2021, eq. 11"
    )
    peak_crank_angle_deg: float = result("Crank angle of the peak.", symbol="φ")
    peak_pair: PairOut = result("The pair that carries the peak.")
    curves: Maybe[ForceCurvesOut] = result("Force of every pair over the turn, where asked.")
    equal_sharing_peak_N: Maybe[float] = result(
        "Largest force if all driving pairs carried alike.", symbol="F_max", equation="Zyl, eq. 1"
    )
    approximate_peak_N: Maybe[float] = result(
        "Largest force by the approximate formula for 3 to 5 pins.",
        symbol="F_max",
        equation="2018, eq. 5",
    )
    approximate_peak_error: Maybe[float] = result("The approximation over the exact peak, less 1.")
    accuracy: AccuracyOut
    warnings: Maybe[list[WarningOut]] = None


def contact_force_figure(
    answer: Values, switching_deg: FloatArray, theme: Theme, ideal: Values | None = None
) -> Figure:
    """Force of every pair over the turn, switching angles as thin lines, the peak marked.

    Parameters
    ----------
    answer : dict
        The forces with their curves, as `/contact-force` answers.
    switching_deg : array
        Crank angles at which a pair starts or stops driving, degrees.
    theme : {"light", "dark"}
        Look of the figure.
    ideal : dict, optional
        Where the forces are the real ones, the ideal ones likewise: the largest of them is a thin
        line.
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
    """The largest ideal force of all pairs."""
    name, angle = text("ideal_largest"), Amount("%{x:.2f}", "°")
    hovered = text("at_angle", name=name, value=Amount("%{y:.5g}", "N"), angle=angle)
    largest = np.max(drawn(curves["force_N"]), axis=0)
    own = curve(name, curves["crank_angle_deg"], largest, 0, theme, hovered)
    line = own["line"] | {"width": 1, "dash": "dot", "color": INK[theme]["text"]}
    return own | {"meta": IDEAL, "line": line}


def solve(body: ContactForceRequest) -> Values:
    """Contact force of the pairs: the exact peak, and curves and approximations where asked."""
    return ContactForceResponse.values(*timed(body.solve))


def figure(body: ContactForceRequest, theme: Theme = "light") -> Figure:
    """Force of every pair over the turn as a Plotly figure, ready for Plotly.js."""
    body.refuse_undrawable()
    (force, switching), run_time_us = timed(
        lambda: body.solve_for_drawing(body.mechanism(), body.members)
    )
    answer = ContactForceResponse.values(force, run_time_us)
    return contact_force_figure(answer, from_si("switching_deg", switching), theme)


def work(body: ContactForceRequest) -> list[Values]:
    """Worked steps of the contact force."""
    return worked(contact_force=body.steps())


CALCULATION = Calculation(
    name="contact-force",
    title="Contact force",
    tag="crank-planetary",
    request=ContactForceRequest,
    answer=ContactForceResponse,
    solve=solve,
    worked=work,
    figure=figure,
    sources=(YANCHEVSKIY_2021, YANCHEVSKY_2018, ZYL),
    neglects=("clearance", "deviations", "friction", "pin_bending", "equal_discs"),
)
