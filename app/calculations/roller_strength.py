"""Swinging rollers: request, answer, figure."""

import math
from dataclasses import replace
from functools import cached_property
from typing import Annotated, Any, ClassVar, Self

from pydantic import Field, field_validator, model_validator

from app.calculations.checks import JudgedFields, JudgedResponse
from app.calculations.fatigue import CycleOut, FatigueFields, strength_of
from app.model import (
    Calculation,
    Maybe,
    Size,
    Values,
    Whole,
    no_dust,
    quantity,
    timed,
    warned,
)
from app.rules import Forms, field_error
from app.sources import OVSYANNIKOV_2019, SHIGLEY
from app.theme import LEGEND, Amount, Chart, Figure, Theme, drawn, text
from app.units import from_si
from app.worked import Steps
from core.checks.check import Verdict
from core.checks.plain import RollerDesign, roller_checks
from core.errors import Notice, NotKnown
from core.fatigue import CycleFatigue
from core.rollers.roller_curves import roller_curves
from core.rollers.roller_strength import (
    RollerStrength,
    roller_arguments,
    roller_fatigue,
    roller_strength,
)
from core.worked.rollers import roller_steps

MAX_ROLLERS = 1000
"""Largest number of rollers of a mechanism."""

_JUDGED_BY = ("yield_strength", "eccentricity")
_TIRED_BY = ("tensile_strength", "roller_rotates", "fatigue")
"""Inputs of the checks and the fatigue only."""

_CHECKED = (
    "output_torque",
    "hole_circle_radius",
    "rollers",
    "sphere_diameter",
    "cylinder_length",
    "sphere_width",
    "spacing",
)
"""Inputs of the checks besides the result."""

Gap = Annotated[float, Field(ge=-1e6, le=1e6)]


NOTCHES = ("fatigue_notch_factor", "notch")


ROLLER_POINTS = 400
"""Number of points of a roller, with its part of the curves."""


class RollerStrengthRequest(JudgedFields, group="roller"):
    """Rollers, their load, and the position errors of their holes."""

    ALTERNATIVES: ClassVar[tuple[Forms, ...]] = (
        (("position_tolerance_mm",), ("gaps_mm",)),
        (("poissons_ratio",), ("shear_modulus_GPa",)),
    )

    output_torque_Nm: Size = quantity("Output torque", "T", group="load", step=10)
    """Torque on the output link."""
    hole_circle_radius_mm: Size = quantity("Hole circle radius", "R", group="load", step=1)
    """Radius of the circle of the rollers' holes."""
    rollers: Whole = quantity("Rollers", "n", group="load", step=1, ge=1, le=MAX_ROLLERS)
    """Number of rollers."""
    position_tolerance_mm: Maybe[float] = quantity(
        "Position tolerance", "χ", group="load", step=0.005, ge=0, le=1e6
    )
    """Positional tolerance of the holes; the worst case has one hole ahead in each part."""
    gaps_mm: Maybe[list[Gap]] = quantity("Gaps", "g₁ … g_n", group="load", max_length=MAX_ROLLERS)
    """Gap of each roller before it carries, instead of the worst case of a tolerance."""
    diameter_mm: Size = quantity("Cylinder diameter", "d", step=0.5)
    """Diameter of the cylinders between the spheres."""
    cylinder_length_mm: Size = quantity("Cylinder length", "l", step=1)
    """Length of one cylinder, from the middle sphere to the end sphere."""
    sphere_width_mm: Size = quantity("Sphere width", "b", step=0.5)
    """Width of a spherical part along the roller."""
    sphere_diameter_mm: Size = quantity("Sphere diameter", "D", step=0.5)
    """Diameter of the spherical parts."""
    friction_coefficient: float = quantity(
        "Friction coefficient", "k", default=0.16, step=0.01, ge=0, le=10
    )
    """Friction between sphere and hole."""
    youngs_modulus_GPa: Size = quantity(
        "Young's modulus", "E", group="material", default=210.0, step=1
    )
    """Modulus of elasticity of the material."""
    poissons_ratio: Maybe[float] = quantity(
        "Poisson's ratio", "ν", group="material", step=0.01, ge=0, lt=0.5
    )
    """Lateral strain over the strain along a tension."""
    shear_modulus_GPa: Maybe[Size] = quantity("Shear modulus", "G", group="material", step=1)
    """Shear modulus of the rollers, instead of Poisson's ratio."""
    stress_concentration: float = quantity(
        "Stress concentration", "K_σ", group="material", default=1.0, step=0.1, ge=1, le=100
    )
    """Stress concentration at the step beside the middle sphere."""

    yield_strength_MPa: Maybe[Size] = quantity("Yield strength", "R_e", group="material", step=10)
    """Yield strength, by which bending or yield below the surface is judged."""
    eccentricity_mm: Maybe[Size] = quantity("Eccentricity", "e", step=0.5)
    """Eccentricity of the crank, by which the length of the rollers is judged."""

    tensile_strength_MPa: Maybe[Size] = quantity(
        "Tensile strength", "R_m", group="material", step=10
    )
    """Tensile strength, by which fatigue is judged."""
    roller_rotates: bool = quantity("Roller rotates", default=False)
    """True if the roller spins in its seat, so that its bending is fully reversed."""
    fatigue: Maybe[FatigueFields] = None

    _sizes = field_validator("position_tolerance_mm", "gaps_mm")(no_dust)

    @model_validator(mode="after")
    def _counts(self) -> Self:
        if self.gaps_mm is not None and len(self.gaps_mm) != self.rollers:
            count = {"expected": self.rollers, "actual": len(self.gaps_mm)}
            raise field_error("gaps_mm", "different_length", **count)
        asked = self.fatigue
        if asked is not None and self.stress_concentration > 1:
            for name in NOTCHES:
                if name in asked.given:
                    raise field_error(f"fatigue/{name}", "only_one", field="stress_concentration")
        return self

    def cost(self) -> float:
        """Number of points of the rollers; infinite if fixes are searched."""
        return math.inf if "fixes" in self.include else float(ROLLER_POINTS * self.rollers)

    def solve(self) -> RollerStrength:
        """Load sharing and strength of the rollers."""
        return roller_strength(**self.design)

    @cached_property
    def design(self) -> dict[str, Any]:
        """Rollers as the core's arguments, without inputs of the checks only."""
        return roller_arguments(**self._inputs)

    @property
    def _inputs(self) -> dict[str, Any]:
        """Arguments of the core by the names of the inputs."""
        aside = (*JudgedFields.model_fields, *_JUDGED_BY, *_TIRED_BY)
        return {name: each for name, each in self.own.items() if name not in aside}

    def tired(self, result: RollerStrength, diameter: float) -> CycleFatigue | Notice | None:
        """Fatigue of rollers of a diameter, m, or why it is not known; None if not requested. The
        stress factor beside the middle sphere is the notch factor and counts once: an endurance
        limit that includes all factors is compared with the stress without it.
        """
        if self.fatigue is None:
            return None
        basis, notch = self.fatigue.section(), self.stress_concentration
        stress = float(result.bending_stress)
        if basis.endurance_limit is not None:
            stress /= notch
        elif notch > 1:
            basis = replace(basis, fatigue_notch_factor=1.0)
        try:
            strength = strength_of(basis, self.own, diameter)
        except NotKnown as why:
            return Notice(why.code)
        return roller_fatigue(bending_stress=stress, strength=strength, rotates=self.roller_rotates)

    def steps(self) -> Steps:
        """Worked steps of the rollers."""
        found = self.solve()
        cycle = self.tired(found, self.design["diameter"])
        judged = None
        if self.fatigue is not None:
            judged = {
                "basis": self.fatigue.section(),
                "tensile_strength": self.own.get("tensile_strength"),
                "yield_strength": self.own.get("yield_strength"),
                "rotates": self.roller_rotates,
            }
        return {
            "roller_strength": roller_steps(
                found=found,
                design=self.design,
                cycle=cycle if isinstance(cycle, CycleFatigue) else None,
                judged=judged,
            )
        }

    def judge(self, result: RollerStrength, tired: CycleFatigue | Notice | None) -> dict[str, Any]:
        """Verdict of a result and its fatigue, with checks and fixes on request."""
        limits: dict[str, Any] = {
            each: self.own.get(each) for each in (*_JUDGED_BY, "requirements")
        }

        def checked(
            design: dict[str, Any], result: RollerStrength, tired: CycleFatigue | Notice | None
        ) -> Verdict:
            shared: dict[str, Any] = {name: design[name] for name in _CHECKED}
            if tired:
                shared["fatigue"] = tired
            return roller_checks(RollerDesign(result=result, **shared, **limits))

        def checks(changed: dict[str, Any]) -> Verdict:
            design = roller_arguments(**changed)
            result = roller_strength(**design)
            return checked(design, result, self.tired(result, design["diameter"]))

        verdict, torque = checked(self.design, result, tired), self.output_torque_Nm
        return self.judged(verdict, torque=torque, design=self._inputs, checks=checks)


class RollerStrengthResponse(JudgedResponse, of=RollerStrength):
    """Stiffness, load sharing and stress of the rollers."""

    loaded_rollers: int
    fatigue: Maybe[CycleOut] = None


def solve(body: RollerStrengthRequest) -> Values:
    """Stiffness, load sharing and bending stress of swinging rollers."""
    result, run_time_us = timed(body.solve)
    tired = body.tired(result, body.design["diameter"])
    judged = body.judge(result, tired)
    cycle = CycleOut.values(tired) if isinstance(tired, CycleFatigue) else None
    values = RollerStrengthResponse.values(result, run_time_us, fatigue=cycle, **judged)
    return warned(values, tired)


def figure(body: RollerStrengthRequest, theme: Theme = "light") -> Figure:
    """Stiffness, non-uniformity and stress as curves through this design."""
    curves = roller_curves(**body.design)
    design, limit = curves.design, curves.limit
    lengths, errors = curves.length_ratio, curves.position_error
    legend, chart = LEGEND | {"y": 0.62}, Chart(theme, height=920)
    chart.layout |= {"legend": legend, "legend2": legend | {"y": 0.23}}
    chart.axis("x", "length_ratio", anchor="y")
    chart.axis("y", "stiffness_ratio", domain=[0.79, 1], type="log")
    chart.axis("x2", "position_error", anchor="y2", range=[0, errors[-1]], zeroline=False)
    chart.axis("y2", "nonuniformity", domain=[0.4, 0.61], rangemode="tozero", anchor="x2")
    chart.axis("x3", "length_ratio", anchor="y3")
    stressed = {"domain": [0, 0.22], "rangemode": "tozero", "anchor": "x3"}
    chart.axis("y3", "bending_stress", "MPa", **stressed)

    length, stiffness = Amount("%{x:.3g}"), Amount("%{y:.4g}")
    hovered = text("stiffness_hover", stiffness=stiffness, length=length)
    chart.curve("stiffness", lengths, curves.relative_stiffness, 0, hovered, showlegend=False)
    hovered = text("design_stiffness", stiffness=Amount("%{y:.5g}"))
    chart.mark("design", design.shape.length, design.relative_stiffness, hovered)

    error = Amount("%{x:.4g}")
    for index, (rollers, values) in enumerate(curves.nonuniformity.items()):
        said = {"rollers": rollers, "nonuniformity": Amount("%{y:.4g}"), "error": error}
        hovered = text("nonuniformity_hover", **said)
        chart.curve(f"n = {rollers}", errors, values, index, hovered, axis="y2")
    place = design.relative_position_error, design.load_nonuniformity
    hovered = text("design_nonuniformity", nonuniformity=Amount("%{y:.5g}"), error=error)
    chart.mark("design", *place, hovered, axis="y2", showlegend=False)
    chart.verticals([limit], "muted", xref="x2", yref="y2 domain", layer="above")
    corner = {"xanchor": "left", "yanchor": "top", "xshift": 4}
    chart.note("one_carries", x=limit, y=1, xref="x2", yref="y2 domain", **corner)

    modulus = body.design["youngs_modulus"]
    own: Figure = {"axis": "y3", "legend": "legend2"}
    for index, (each, values) in enumerate(curves.stress.items()):
        if curves.scales_gaps:
            name = text("gaps_times", factor=Amount(each))
        else:
            tolerance = Amount(from_si("tolerance_mm", each), "mm", 3)
            ratio = Amount(each / body.design["diameter"], "", 3)
            name = text("tolerance", tolerance=tolerance, ratio=ratio)
        shown = {"stress": Amount("%{y:.4g}", "MPa"), "ratio": Amount("%{customdata:.4g}")}
        hovered = text("stress_hover", name=name, length=length, **shown)
        stress, ratios = from_si("stress_MPa", values), drawn(values / modulus)
        chart.curve(name, lengths, stress, index, hovered, customdata=ratios, **own)
    shown = {"stress": Amount("%{y:.5g}", "MPa")}
    shown["ratio"] = Amount(design.bending_stress / modulus, "", 5)
    place = design.shape.length, from_si("stress_MPa", design.bending_stress)
    chart.mark("design", *place, text("design_stress", **shown), axis="y3", showlegend=False)
    return chart.figure


CALCULATION = Calculation(
    name="roller-strength",
    title="Strength of swinging rollers",
    tag="rollers",
    request=RollerStrengthRequest,
    answer=RollerStrengthResponse,
    solve=solve,
    figure=figure,
    sources=(OVSYANNIKOV_2019, SHIGLEY),
    neglects=("contact_compliance", "roller_tilt", "equal_discs"),
)
