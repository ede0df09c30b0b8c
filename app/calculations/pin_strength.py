"""Strength of the pins: request, answer, figure."""

import math
from dataclasses import replace
from functools import cached_property
from typing import Any, ClassVar, Literal

import numpy as np
from pydantic import Field

from app.calculations.contact_force import TorqueFields
from app.calculations.mechanism import MechanismFields
from app.calculations.pin import FatigueFields, PinSectionFields
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
from core.errors import InvalidInput
from core.fatigue import (
    EnduranceFactors,
    endurance_limit,
    notch_factor,
    reliability_factor,
    size_factor,
    surface_factor,
)
from core.materials import MATERIALS, ElasticMaterial
from core.output.mechanism import Mechanism
from core.output.pin_fatigue import FatigueStrength
from core.output.pin_strength import PinStrength, pin_strength
from core.results import Notice

MAX_PAIRS = 500
"""Most pairs whose locus is looked at."""

STEEL_GPA = 190.0, 220.0
"""Young's moduli of steels: for them only there is a rule of the endurance limit."""


class PinLoadFields(TorqueFields):
    """Load of the pins, and the speed of the crank where a life is wanted."""

    input_speed_rpm: Maybe[float] = quantity(
        "Input speed",
        symbol="n₁",
        group="load",
        default=None,
        **SIZE,
        step=50,
        help="Speed of the crankshaft.",
    )


class PinStrengthRequest(RequestModel):
    """Mechanism, load, pin and what its fatigue is judged by."""

    LONG: ClassVar[bool] = True

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

    def strengths(self) -> tuple[ElasticMaterial, float | None, bool, float | None]:
        """Material with its yield strength, tensile strength, whether it is a steel, and the
        diameter that the strengths hold for.
        """
        given = self.pin.material
        if isinstance(given, str):
            entry = MATERIALS[given]
            own = replace(entry.material, yield_strength=entry.strength.yield_strength)
            strength = entry.strength
            return own, strength.tensile, entry.group == "steel", strength.valid_diameter
        modulus = given.youngs_modulus_GPa
        values = given.model_copy(update={"tensile_strength_MPa": None}).material()
        tensile = to_si("tensile_strength_MPa", given.tensile_strength_MPa)
        return values, tensile, STEEL_GPA[0] <= modulus <= STEEL_GPA[1], None

    def judged_by(
        self, tensile: float | None, yields: float | None, steel: bool, diameter: float
    ) -> tuple[FatigueStrength | None, tuple[Notice, ...]]:
        """What the fatigue is judged by; without it the reason."""
        asked = self.fatigue
        if asked is None:
            return None, ()
        if tensile is None or (asked.endurance_limit_MPa is None and not steel):
            return None, (Notice("fatigue_no_basis"),)
        if asked.criterion == "soderberg" and yields is None:
            raise InvalidInput("yield_strength", None, "needed_beside", field="criterion")
        if asked.endurance_limit_MPa is not None:
            limit = to_si("endurance_limit_MPa", asked.endurance_limit_MPa)
            return FatigueStrength(limit, tensile, yields, asked.criterion), ()
        notch = asked.fatigue_notch_factor
        if asked.notch is not None:
            notch = notch_factor(**asked.notch.to_core(), tensile_strength=tensile)
        if notch is None:
            return None, (Notice("fatigue_no_notch"),)
        surface = asked.surface_factor
        if surface is None:
            assert asked.surface is not None
            surface = surface_factor(
                tensile_strength=tensile, surface=asked.surface, edition=asked.edition
            )
        reliability = asked.reliability_factor
        if reliability is None:
            reliability = reliability_factor(percent=asked.reliability_percent or 50.0)
        factors = EnduranceFactors(surface, size_factor(diameter=diameter), reliability, notch)
        limit = endurance_limit(tensile_strength=tensile, factors=factors)
        return FatigueStrength(limit, tensile, yields, asked.criterion, factors), ()

    def solve(self, *, locus: bool = False) -> PinStrength:
        """Strength of the pin."""
        if self.mechanism.pairs > MAX_PAIRS:
            most = self.mechanism.most_pins(MAX_PAIRS)
            raise InvalidInput("pins", self.mechanism.pins, "too_many_pairs", **most)
        material, tensile, steel, valid = self.strengths()
        diameter = to_si("diameter_mm", self.pin.diameter_mm)
        strength, notices = self.judged_by(tensile, material.yield_strength, steel, diameter)
        if valid is not None and diameter > valid:
            notices += (Notice("strength_beyond_size", {"limit": valid * 1e3}),)
        found = pin_strength(
            mechanism=self.built,
            force_exponent=self.load.force_exponent,
            output_torque=self.load.torque(self.built),
            pin_circle_radius=to_si("pin_circle_radius_mm", self.load.pin_circle_radius_mm),
            diameter=diameter,
            contact_length=to_si("contact_length_mm", self.pin.contact_length_mm),
            satellite_positions=tuple(
                to_si("satellite_positions_mm", self.pin.satellite_positions_mm)
            ),
            material=material,
            support=self.pin.support,
            span=to_si("span_mm", self.pin.span_mm),
            rotates=self.pin.rotates,
            fatigue=strength,
            input_speed=to_si("input_speed_rpm", self.load.input_speed_rpm),
            deflection="deflection" in self.include,
            locus=locus or "locus" in self.include,
        )
        return replace(found, notices=notices + found.notices)


class FactorsOut(ResponseModel):
    """What the endurance limit is made of: k_a·k_b·k_e·S_e′/K_f."""

    surface: float = result("Factor of the surface.", symbol="k_a")
    size: float = result("Factor of the size.", symbol="k_b")
    reliability: float = result("Factor of the reliability.", symbol="k_e")
    notch: float = result("Fatigue notch factor.", symbol="K_f")


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
        "Yield strength over it, where that is known.", symbol="S", default=None
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
