"""Friction of the pins in the holes: request, answer, figure."""

import math
from dataclasses import replace
from functools import cached_property
from typing import Any, ClassVar, Literal, Self

import numpy as np
from pydantic import ConfigDict, Field, field_validator, model_validator

from app.calculations.contact_force import (
    CurveFields,
    TorqueFields,
    application_factor,
    peak_torque,
)
from app.calculations.hertz import PinFields, eccentricity, hole_radius
from app.calculations.mechanism import MechanismFields
from app.model import (
    NO_DUST,
    SIZE,
    AccuracyOut,
    Calculation,
    Forms,
    Maybe,
    RequestModel,
    ResponseModel,
    Values,
    WarningOut,
    field_error,
    no_dust,
    quantity,
    request_schema,
)
from app.running import run
from app.settings import Settings
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
from app.units import from_si, to_si
from core.arrays import FloatArray
from core.output.contact_force import drawing_angles
from core.output.losses import LossCurves, PinLosses, loss_curves, pin_losses
from core.output.mechanism import Mechanism
from core.output.pin_geometry import pin_fit


class DrivenLoadFields(TorqueFields):
    """Load of the pins, and the speed of the crank; how it changes counts for static safety."""

    input_speed_rpm: float = quantity(
        "Input speed",
        symbol="n₁",
        group="load",
        **SIZE,
        step=50,
        help="Speed of the crankshaft.",
    )
    application_factor: Maybe[float] = application_factor()
    peak_torque_Nm: Maybe[float] = peak_torque()


class SlidingContactFields(PinFields):
    """Sizes of pin and hole, and the crank's."""

    hole_radius_mm: Maybe[float] = hole_radius(default=None)
    eccentricity_mm: float = eccentricity()


class SleevedPinFields(RequestModel):
    """The pin itself."""

    diameter_mm: float = quantity(
        "Pin diameter",
        symbol="d",
        group="pin",
        **SIZE,
        step=0.5,
        help="Diameter of the pin itself, inside its sleeve where it has one.",
    )


class FrictionFields(RequestModel):
    """Friction and wear of pin and hole, or of pin and sleeve."""

    coefficient: float = quantity(
        "Friction coefficient",
        symbol="μ",
        group="friction",
        ge=0,
        le=10,
        step=0.01,
        schema=NO_DUST,
        help="Friction coefficient of the surfaces that slide.",
    )
    sleeve: bool = quantity(
        "Sleeves on the pins",
        symbol="",
        group="friction",
        default=False,
        help="Whether sleeves roll in the holes and slide on the pins; the pin diameter is needed.",
    )
    wear_rate_mm3_per_Nm: Maybe[float] = quantity(
        "Wear coefficient",
        symbol="k",
        group="friction",
        default=None,
        **SIZE,
        step=1e-9,
        help="Worn volume over force and sliding distance (Archard).",
    )
    life_h: Maybe[float] = quantity(
        "Life",
        symbol="t",
        group="friction",
        default=None,
        **SIZE,
        step=100,
        help="Time in which it wears.",
    )

    _coefficient_size = field_validator("coefficient")(no_dust)


class WornFields(FrictionFields):
    """The same where a rate of wear needs the time."""

    ALTERNATIVES: ClassVar[tuple[Forms, ...]] = ((("wear_rate_mm3_per_Nm", "life_h"), ()),)


def _sleeve_schema(schema: dict[str, Any], model: type[RequestModel]) -> None:
    """Sleeves need the diameter of the pin inside."""
    request_schema(schema, model)
    sleeve = {"properties": {"sleeve": {"const": True}}, "required": ["sleeve"]}
    schema["if"] = {"properties": {"friction": sleeve}, "required": ["friction"]}
    schema["then"] = {"required": ["pin"]}


class OutputEfficiencyRequest(CurveFields):
    """Mechanism, load, contact and friction."""

    mechanism: MechanismFields
    load: DrivenLoadFields
    contact: SlidingContactFields
    friction: WornFields
    pin: Maybe[SleevedPinFields] = None
    include: list[Literal["curves"]] = Field(
        default=[], max_length=1, description="Optional results: what is not named is not computed."
    )

    model_config = ConfigDict(json_schema_extra=_sleeve_schema)

    @model_validator(mode="after")
    def _pin_in_sleeve(self) -> Self:
        if self.friction.sleeve and self.pin is None:
            raise field_error("pin", "needed_beside", field="sleeve")
        return self

    def refuse_beyond(self, settings: Settings) -> None:
        """Refuse what exceeds the operator's limits in pairs or samples."""
        self.mechanism.refuse_beyond(settings)
        super().refuse_beyond(settings)

    @cached_property
    def built(self) -> Mechanism:
        """The mechanism, built once."""
        return self.mechanism.mechanism()

    def solve(self) -> PinLosses:
        """Losses, and how pins and holes fit."""
        contact, load, friction = self.contact.to_core(), self.load, self.friction
        radius = to_si("pin_circle_radius_mm", load.pin_circle_radius_mm)
        fit = pin_fit(
            pins=self.built.pins,
            pin_radius=contact["pin_radius"],
            hole_radius=contact.get("hole_radius", contact["pin_radius"] + contact["eccentricity"]),
            eccentricity=contact["eccentricity"],
            pin_circle_radius=radius,
        )
        losses = pin_losses(
            mechanism=self.built,
            force_exponent=load.force_exponent,
            output_torque=load.torque(self.built),
            pin_circle_radius=radius,
            input_speed=to_si("input_speed_rpm", load.input_speed_rpm),
            **contact,
            friction_coefficient=friction.coefficient,
            diameter=(
                to_si("diameter_mm", self.pin.diameter_mm) if self.pin and friction.sleeve else None
            ),
            wear_rate=to_si("wear_rate_mm3_per_Nm", friction.wear_rate_mm3_per_Nm),
            life=to_si("life_h", friction.life_h),
        )
        return replace(losses, notices=fit.notices + losses.notices)

    def curves(self, losses: PinLosses, crank_angle: FloatArray) -> LossCurves:
        """Loss and efficiency at crank angles, rad."""
        return loss_curves(
            losses=losses,
            mechanism=self.built,
            force_exponent=self.load.force_exponent,
            crank_angle=crank_angle,
        )

    def solve_all(self) -> tuple[PinLosses, LossCurves | None]:
        """Losses, and their curves over a turn where they are asked."""
        losses = self.solve()
        if "curves" not in self.include:
            return losses, None
        return losses, self.curves(losses, turn(self.samples_of(self.built)))

    def solve_for_drawing(self) -> tuple[PinLosses, LossCurves, FloatArray]:
        """Losses, curves fit to be drawn, and the switching angles, rad."""
        angles, switching = drawing_angles(mechanism=self.built)
        losses = self.solve()
        return losses, self.curves(losses, angles), switching


def result(title: str, symbol: str, meaning: str, **default: Any) -> Any:
    """A field of the answer: its name, symbol, meaning and equation."""
    return Field(
        title=title, description=meaning, json_schema_extra={"x-symbol": symbol}, **default
    )


class LossCurvesOut(ResponseModel):
    """Loss and efficiency over one turn of the crank."""

    crank_angle_deg: list[float] = result("Crank angle", "φ", "Crank angles, evenly spaced.")
    loss_W: list[float] = result("Loss", "P", "Power that friction takes, μ·v·ΣF.")
    efficiency: list[float] = result("Efficiency", "η", "Output over output and loss.")


class OutputEfficiencyResponse(ResponseModel):
    """Sliding speed, loss, efficiency, pv and wear of the pins."""

    relative_speed_rpm: float = result(
        "Relative speed", "n", "Speed of the crank against the output link, n₁·(1 + 1/u)."
    )
    sliding_speed_m_per_s: float = result(
        "Sliding speed",
        "v",
        "Of the pin in the hole, e·ω; with a sleeve of the pin in it, e·ω·r_p/r_s.",
    )
    sleeve_speed_rpm: Maybe[float] = result(
        "Speed of the sleeves", "n_s", "Of the sleeves against their pins, n·e/r_s.", default=None
    )
    output_power_W: float = result("Output power", "P₂", "T·ω₁/u.")
    peak_force_N: float = result("Peak force", "F_max", "Largest contact force over the turn.")
    mean_total_force_ratio: float = result(
        "Mean total force",
        "⟨ΣF⟩/F₀",
        "Mean over the turn of the sum of all contact forces, over F₀ = T/R; 4/π for linear "
        "contacts and an even number of evenly spaced phases.",
    )
    mean_loss_W: float = result("Mean loss", "P", "Mean of μ·v·ΣF over the turn.")
    efficiency: float = result(
        "Efficiency", "η", "Of the output mechanism alone: P₂/(P₂ + P) with the mean loss."
    )
    min_efficiency: float = result("Least efficiency", "η_min", "Least over the turn.")
    max_efficiency: float = result("Largest efficiency", "η_max", "Largest over the turn.")
    peak_pv_MPa_m_per_s: float = result(
        "Peak pv", "(pv)_max", "Largest force over the projected area 2·r·b, times e·ω."
    )
    mean_pv_MPa_m_per_s: float = result(
        "Mean pv", "(pv)_m", "The same with the mean force of all pairs over the turn."
    )
    pin_wear_mm: Maybe[float] = result(
        "Wear of the pin",
        "h_in",
        "Depth where it is deepest, k·F_max·e/(b·r) in each turn of the relative speed.",
        default=None,
    )
    hole_wear_mm: Maybe[float] = result(
        "Wear of the hole",
        "h_out",
        "The same of the hole, k·F_max·e/(b·r_out); absent with sleeves, which roll in it.",
        default=None,
    )
    friction_couple: float = result(
        "Couple of the friction",
        "ΔP/P",
        "Share of the torque that friction itself carries on the mean, μ·r·⟨ΣF⟩/T: to the first "
        "order the loss is too large by this share.",
    )
    curves: Maybe[LossCurvesOut] = None
    accuracy: AccuracyOut
    warnings: Maybe[list[WarningOut]] = None

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
"""Where the values of the means stand, in parts of each plot's height, clear of the curves: the
loss never comes near 0, and the efficiency fills its plot.
"""


def loss_figure(
    losses: PinLosses, curves: LossCurves, switching_deg: FloatArray, theme: Theme
) -> Figure:
    """Loss over the turn above, efficiency below, each with its mean; switching angles thin.

    Parameters
    ----------
    losses : PinLosses
        The means.
    curves : LossCurves
        Loss and efficiency over the turn.
    switching_deg : array
        Crank angles at which a pair starts or stops driving, degrees.
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
    return OutputEfficiencyResponse.values(*run(body, body.solve_all))


def figure(body: OutputEfficiencyRequest, theme: Theme = "light") -> Figure:
    """Loss and efficiency over the turn as a Plotly figure, ready for Plotly.js."""
    run(body, body.mechanism.refuse_undrawable)
    (losses, curves, switching), _ = run(body, body.solve_for_drawing)
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
        "clearance",
        "deviations",
        "equal_discs",
        "friction_on_forces",
        "heat",
        "lubricant_film",
        "pin_bending",
        "seals",
    ),
)
