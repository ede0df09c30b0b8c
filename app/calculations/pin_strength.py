"""Strength of the pins: request, answer, figure."""

import math
from dataclasses import replace
from functools import cached_property
from typing import Any, Literal

import numpy as np
from pydantic import Field

from app.calculations.contact_force import TorqueFields, application_factor, peak_torque
from app.calculations.fatigue import FactorsOut, FatigueFields
from app.calculations.mechanism import MechanismFields
from app.calculations.pin import PinSectionFields, strengths_of
from app.calculations.real_mechanism import torque_direction
from app.model import (
    SIZE,
    AccuracyOut,
    Calculation,
    Maybe,
    RequestModel,
    ResponseModel,
    Values,
    WarningOut,
    quantity,
    result,
)
from app.running import run
from app.sources import SHIGLEY, YANCHEVSKIY_2021
from app.theme import Amount, Figure, Theme, axis, curve, layout, text
from app.units import from_si, to_si
from core.checks.sections import DesignPin
from core.errors import InvalidInput
from core.output.mechanism import Mechanism
from core.output.pin_fatigue import FatigueStrength
from core.output.pin_strength import PinStrength, pin_strength
from core.output.sampled_turn import Direction
from core.results import Notice

MAX_PAIRS = 500
"""Most pairs whose locus is looked at."""


class PinLoadFields(TorqueFields):
    """Load of the pins, its direction and how it changes, and the speed of the crank where a life
    is wanted.
    """

    torque_direction: Direction = torque_direction()
    input_speed_rpm: Maybe[float] = quantity(
        "Input speed",
        symbol="n₁",
        group="load",
        default=None,
        **SIZE,
        step=50,
        help="Speed of the crankshaft.",
    )
    application_factor: Maybe[float] = application_factor()
    peak_torque_Nm: Maybe[float] = peak_torque()


class PinStrengthRequest(RequestModel):
    """Mechanism, load, pin and what its fatigue is judged by."""

    mechanism: MechanismFields
    load: PinLoadFields
    pin: PinSectionFields
    fatigue: Maybe[FatigueFields] = None
    include: list[Literal["deflection", "locus"]] = Field(
        default=[], max_length=2, description="Optional results: what is not named is not computed."
    )

    def refuse_beyond(self, settings: Any) -> None:
        """Refuse what exceeds the operator's limits in pairs."""
        self.mechanism.refuse_beyond(settings)
        super().refuse_beyond(settings)

    @cached_property
    def built(self) -> Mechanism:
        """The mechanism, built once."""
        return self.mechanism.mechanism()

    def design_pin(self) -> DesignPin:
        """The pin in SI units."""
        own = self.pin
        return DesignPin(
            support=own.support,
            diameter=to_si("diameter_mm", own.diameter_mm),
            satellite_positions=tuple(to_si("positions_mm", own.satellite_positions_mm)),
            span=to_si("span_mm", own.span_mm),
            contact_length=to_si("contact_length_mm", own.contact_length_mm),
            rotates=own.rotates,
            **strengths_of(own.material),
        )

    def loaded(self, pin: DesignPin) -> dict[str, Any]:
        """The mechanism, its load and the pin, as the core takes them for the stresses."""
        return {
            "mechanism": self.built,
            "force_exponent": self.load.force_exponent,
            "output_torque": self.load.torque(self.built),
            "application_factor": self.load.application_factor or 1.0,
            "peak_torque": self.load.peak_torque_Nm,
            "pin_circle_radius": to_si("pin_circle_radius_mm", self.load.pin_circle_radius_mm),
            "diameter": pin.diameter,
            "contact_length": pin.contact_length,
            "satellite_positions": pin.satellite_positions,
            "material": pin.material,
            "support": pin.support,
            "span": pin.span,
            "torque_direction": self.load.torque_direction,
        }

    def solve(self, *, locus: bool = False) -> PinStrength:
        """Strength of the pin."""
        if self.mechanism.pairs > MAX_PAIRS:
            most = self.mechanism.most_pins(MAX_PAIRS)
            raise InvalidInput("pins", self.mechanism.pins, "too_many_pairs", **most)
        pin = self.design_pin()
        judged = None if self.fatigue is None else self.fatigue.basis().strength(pin)
        strength = judged if isinstance(judged, FatigueStrength) else None
        notices: tuple[Notice, ...] = (judged,) if isinstance(judged, Notice) else ()
        if pin.valid_diameter is not None and pin.diameter > pin.valid_diameter:
            notices += (Notice("strength_beyond_size", {"limit": pin.valid_diameter * 1e3}),)
        found = pin_strength(
            **self.loaded(pin),
            rotates=pin.rotates,
            fatigue=strength,
            input_speed=to_si("input_speed_rpm", self.load.input_speed_rpm),
            deflection="deflection" in self.include,
            locus=locus or "locus" in self.include,
        )
        return replace(found, notices=notices + found.notices)


class PinFatigueOut(ResponseModel):
    """The worst stress cycle of a pin; its direction and stresses are good to 1e-4, as the safety
    hardly changes about them.
    """

    direction_deg: Maybe[float] = result(
        "Direction of the worst point of the section from the tangential one, towards growing "
        "pressure angles; absent where the pin rotates.",
        symbol="χ",
        default=None,
    )
    position_mm: float = result("Its section, from the carrier's face.", symbol="x")
    max_stress_MPa: float = result("Largest stress there.", symbol="σ_max")
    min_stress_MPa: float = result("Least stress there.", symbol="σ_min")
    amplitude_MPa: float = result("Amplitude of the cycle.", symbol="σ_a")
    mean_MPa: float = result("Mean of the cycle.", symbol="σ_m")
    endurance_limit_MPa: float = result("Endurance limit of the pin.", symbol="S_e")
    finite_strength_MPa: Maybe[float] = result(
        "Strength for the cycles of the life that a design has to reach, where they are fewer "
        "than a million: it stands for the endurance limit in the safety.",
        symbol="S_f",
        default=None,
    )
    factors: Maybe[FactorsOut] = None
    safety_factor: float = result("By the criterion: all stresses may grow so much.", symbol="n")
    cycles: Maybe[float] = result(
        "Cycles that it stands, one a turn of the crank against the output; absent within the "
        "endurance limit.",
        symbol="N",
        default=None,
    )
    life_h: Maybe[float] = result(
        "The same as time; absent within the endurance limit or without a speed.", default=None
    )


class PinDeflectionOut(ResponseModel):
    """Deflection in the middle of the satellite where it is largest."""

    satellite: int = result("Number of the satellite, from 1.")
    deflection_mm: float = result("Largest deflection over the turn.", symbol="w")
    slope_mrad: float = result(
        "Largest rotation of the section there; between two supports as good as deflection over "
        "distance to the nearer one.",
        symbol="θ",
    )


class MomentLocusOut(ResponseModel):
    """Bending moment of a section of pin 1 over a turn against the output."""

    position_mm: float = result("The section, from the carrier's face.", symbol="x")
    crank_angle_deg: list[float] = result("Crank angles.", symbol="φ")
    tangential_Nm: list[float] = result("Moment by tangential forces.")
    radial_Nm: list[float] = result("Moment by radial forces.")
    stress_MPa: list[float] = result("Stress in the worst direction.", symbol="σ")


class PinStrengthResponse(ResponseModel):
    """Bending, shear, static safety, fatigue and deflection of the pins."""

    peak_force_N: float = result("Largest contact force over the turn.", symbol="F_max")
    peak_moment_Nm: float = result("Largest bending moment of any section.", symbol="M")
    peak_moment_position_mm: float = result("That section, from the carrier's face.", symbol="x")
    peak_bending_stress_MPa: float = result("Its stress, 32·M/(π·d³).", symbol="σ_b")
    peak_shear_force_N: float = result("Largest shear force of any section.", symbol="V")
    peak_shear_stress_MPa: float = result("Its largest stress, 4/3·V/A.", symbol="τ")
    peak_equivalent_stress_MPa: float = result(
        "Largest equivalent stress (Mises) of any section.", symbol="σ_v"
    )
    static_safety_factor: Maybe[float] = result(
        "Yield strength over it at the peak torque, where that is known.", symbol="S", default=None
    )
    fatigue: Maybe[PinFatigueOut] = None
    deflection: Maybe[PinDeflectionOut] = None
    locus: Maybe[MomentLocusOut] = None
    accuracy: AccuracyOut
    warnings: Maybe[list[WarningOut]] = None


def strength_figure(found: PinStrength, theme: Theme) -> Figure:
    """The moment's locus with the worst direction, and the stress over the turn.

    Parameters
    ----------
    found : PinStrength
        With its locus.
    theme : {"light", "dark"}
        Look of the figure.

    Returns
    -------
    dict
        ``{data, layout}``.
    """
    locus = found.locus
    assert locus is not None
    angles = from_si("crank_angle_deg", locus.crank_angle)
    stress = from_si("stress_MPa", locus.stress)
    hovered = text(
        "locus_hover",
        name=text("moment_locus"),
        along=Amount("%{x:.5g}", "N·m"),
        across=Amount("%{y:.5g}", "N·m"),
    )
    data = [curve(text("moment_locus"), locus.tangential, locus.radial, 0, theme, hovered)]
    largest = float(np.hypot(locus.tangential, locus.radial).max())
    if found.fatigue is not None and found.fatigue.direction is not None:
        chi = found.fatigue.direction
        ends = np.array([-largest, largest])
        worst = text("worst_direction")
        hovered = text("mean_hover", name=worst, value=Amount(math.degrees(chi), "°", 5))
        data.append(
            curve(worst, ends * math.cos(chi), ends * math.sin(chi), 1, theme, hovered, colour=1)
        )
    hovered = text(
        "at_angle",
        name=text("bending_stress"),
        value=Amount("%{y:.5g}", "MPa"),
        angle=Amount("%{x:.2f}", "°"),
    )
    data.append(
        curve(text("bending_stress"), angles, stress, 2, theme, hovered, xaxis="x2", yaxis="y2")
    )
    return {
        "data": data,
        "layout": layout(
            theme,
            height=420,
            xaxis=axis(theme, text("moment_tangential"), "N·m", domain=[0, 0.42]),
            yaxis=axis(theme, text("moment_radial"), "N·m", scaleanchor="x"),
            xaxis2=axis(theme, text("crank_angle"), "°", domain=[0.58, 1], anchor="y2"),
            yaxis2=axis(theme, text("bending_stress"), "MPa", anchor="x2"),
        ),
    }


def solve(body: PinStrengthRequest) -> Values:
    """Strength of the pins: bending, shear, static safety, fatigue by the true stress cycle."""
    return PinStrengthResponse.values(*run(body, body.solve))


def figure(body: PinStrengthRequest, theme: Theme = "light") -> Figure:
    """Locus of the moment and stress over the turn as a Plotly figure, ready for Plotly.js."""
    run(body, body.mechanism.refuse_undrawable)
    found, _ = run(body, lambda: body.solve(locus=True))
    return strength_figure(found, theme)


CALCULATION = Calculation(
    name="pin-strength",
    title="Strength of the pins",
    tag="crank-planetary",
    request=PinStrengthRequest,
    answer=PinStrengthResponse,
    solve=solve,
    figure=figure,
    sources=(YANCHEVSKIY_2021, SHIGLEY),
    neglects=(
        "clearance",
        "deviations",
        "equal_discs",
        "fretting",
        "friction",
        "seat_compliance",
    ),
)
