"""Shaft of the precessional gear: request, answer, figure."""

import math
from collections.abc import Callable
from functools import cached_property, partial
from typing import Any, ClassVar

from app.calculations.checks import JudgedFields, JudgedResponse
from app.calculations.fatigue import FatigueFields, strength_of
from app.calculations.hertz import Material, material_of
from app.calculations.meshing_load import MeshFields
from app.model import (
    Calculation,
    Maybe,
    RequestModel,
    ResponseModel,
    Size,
    Values,
    quantity,
    timed,
    warned,
)
from app.rules import Forms
from app.sources import JOHNSON_1985, KHATETOVSKY_2020, SHIGLEY
from app.theme import LEGEND, Chart, Figure, Theme
from app.units import core_name, from_si, to_si
from app.worked import Steps
from core.checks.check import Verdict
from core.checks.plain import LINE_MATERIALS, ShaftDesign, shaft_checks
from core.design.document import not_given
from core.errors import Notice, NotKnown, if_known
from core.fatigue import FatigueStrength
from core.hertz import ElasticMaterial
from core.precession.line_contact import LineContact, line_contact
from core.precession.meshing_load import MeshingLoad
from core.precession.shaft import ShaftSection, shaft_diagram
from core.precession.shaft_deflection import Deflection, ShaftDeflection, shaft_deflection
from core.precession.shaft_strength import ShaftStrength, shaft_strength
from core.worked.precession import shaft_steps

Plane = tuple[float, float]


class ShaftSectionFields(RequestModel, group="shaft"):
    """Stretch of the shaft with one diameter."""

    length_mm: Size = quantity("Length", step=1)
    """Length of the shaft section."""
    diameter_mm: Size = quantity("Diameter", step=1)
    """Diameter of the shaft section."""

    def section(self) -> ShaftSection:
        """Stretch in SI units."""
        return ShaftSection(**self.to_core())


class LineContactFields(RequestModel, group="line_contact"):
    """Inputs of the pressure along the contact lines."""

    mating_radius_mm: float = quantity(
        "Curvature radius of the teeth", "r_m", step=1, ge=-1e12, le=1e12
    )
    """Radius of curvature of the satellite's teeth across the contact line; negative, and larger in
    size than the roller's, if the roller lies in a hollow."""
    roller_material: Material = quantity("Material of the rollers")
    """Name in the table of materials, or values."""
    mating_material: Material = quantity("Material of the satellite")
    """Name in the table of materials, or values."""

    def materials(self) -> tuple[ElasticMaterial, ElasticMaterial]:
        """Materials of roller and tooth."""
        return material_of(self.roller_material), material_of(self.mating_material)

    def pressure_limits(self) -> dict[str, float]:
        """Limits of roller and tooth, Pa, by their materials, as far as they are known."""
        limits = zip(LINE_MATERIALS, (each.limit for each in self.materials()), strict=True)
        return {name: float(each.pressure) for name, each in limits if each}


_GEAR = ("roller_radius_mm", "roller_circle_radius_mm")
"""Inputs of the gear that a fix may change."""

_ONE_DIAMETER = ("shaft_diameter_mm", "overhang_mm", "bearing_distance_mm")
"""Inputs of a shaft of one diameter that a fix may change."""

_diameter = "shaft_sections[{}].diameter".format
"""Core name of the diameter of a stretch of a stepped shaft, by its number."""

_OF_SHAFT = ("bearing_distance", "overhang", "youngs_modulus")
"""Arguments of the core that describe the shaft, besides its stretches."""


class ShaftDeflectionRequest(MeshFields, JudgedFields, group="shaft"):
    """Mesh, its torque, and the shaft that carries it."""

    ALTERNATIVES: ClassVar[tuple[Forms, ...]] = ((("shaft_diameter_mm",), ("shaft_sections",)),)

    def cost(self) -> float:
        """Number of points of the contact lines; infinite if fixes are searched."""
        return math.inf if "fixes" in self.include else super().cost()

    bearing_distance_mm: Size = quantity("Bearing distance", "a", step=1)
    """Distance between the satellite's bearings C and B."""
    overhang_mm: Size = quantity("Overhang", "b", step=1)
    """Distance from B to the clamped end of the shaft."""
    shaft_diameter_mm: Maybe[Size] = quantity("Shaft diameter", "d", step=1)
    """Diameter of the shaft over its whole length."""
    shaft_sections: Maybe[list[ShaftSectionFields]] = quantity(
        "Shaft sections", min_length=1, max_length=100
    )
    """Sections of the shaft from C to the clamp, given instead of one diameter; their lengths add
    up to a + b."""
    youngs_modulus_GPa: Size = quantity("Young's modulus", "E", default=210.0, step=1)
    """Modulus of elasticity of the material."""

    yield_strength_MPa: Maybe[Size] = quantity("Yield strength", "R_e", step=10)
    """Yield strength, by which bending or yield below the surface is judged."""
    tensile_strength_MPa: Maybe[Size] = quantity("Tensile strength", "R_m", step=10)
    """Tensile strength, by which fatigue is judged."""
    load_rotates_with_shaft: bool = quantity("Load turns with the shaft", default=False)
    """True if the mesh turns with the shaft and always bends it in one direction; otherwise its
    bending is fully reversed."""
    fatigue: Maybe[FatigueFields] = None
    line_contact: Maybe[LineContactFields] = None

    def solve_shaft(self, load: MeshingLoad) -> ShaftDeflection:
        """Reactions and deflection of the shaft under the load of the mesh."""
        return shaft_deflection(
            force=load.force,
            moment=load.moment,
            force_error=load.force_error,
            moment_error=load.moment_error,
            **self.shaft,
        )

    @property
    def shaft(self) -> dict[str, Any]:
        """Shaft as the core's arguments."""
        own = self.own
        whole = {name: own[name] for name in _OF_SHAFT}
        match own:
            case {"shaft_sections": sections}:
                return whole | {"shaft_sections": [*sections]}
            case _:
                length = own["bearing_distance"] + own["overhang"]
                one = ShaftSection(length=length, diameter=own["shaft_diameter"])
                return whole | {"shaft_sections": [one]}

    def solve_all(self) -> tuple[MeshingLoad, ShaftDeflection]:
        """Load of the mesh, and reactions and deflection of the shaft."""
        load = self.solve_load()
        return load, self.solve_shaft(load)

    @cached_property
    def fatigue_strength(self) -> Callable[[float], FatigueStrength] | Notice | None:
        """Fatigue strength of the shaft, or why it is not known; None if not requested."""
        if self.fatigue is None:
            return None
        strength = partial(strength_of, self.fatigue.section(), self.own)
        try:
            strength(1.0)
        except NotKnown as why:
            return Notice(why.code)
        return strength

    def no_fatigue(self) -> Notice | None:
        """Reason why the fatigue of the shaft is not known; None if known or not requested."""
        found = self.fatigue_strength
        return found if isinstance(found, Notice) else None

    def strength(self, result: ShaftDeflection) -> ShaftStrength | None:
        """Bending strength of the shaft, if it is requested."""
        if self.given.keys().isdisjoint(("yield_strength_MPa", "tensile_strength_MPa", "fatigue")):
            return None
        fatigue, shaft = self.fatigue_strength, self.shaft
        return shaft_strength(
            reaction_B=result.reaction_B,
            reaction_C=result.reaction_C,
            bearing_distance=shaft["bearing_distance"],
            overhang=shaft["overhang"],
            sections=shaft["shaft_sections"],
            yield_strength=self.own.get("yield_strength"),
            fatigue=None if isinstance(fatigue, Notice) else fatigue,
            load_rotates_with_shaft=self.load_rotates_with_shaft,
        )

    def contact(self, load: MeshingLoad) -> LineContact | None:
        """Pressure along the contact lines, if the curvature of the teeth is given."""
        if not self.line_contact:
            return None
        roller, mating = self.line_contact.materials()
        return line_contact(
            line_load=load.max_line_load,
            roller_radius=self.own["roller_radius"],
            mating_radius=to_si("radius_mm", self.line_contact.mating_radius_mm),
            roller_material=roller,
            mating_material=mating,
            load_error=float(load.accuracy.relative_error),
        )

    def steps(self) -> Steps:
        """Worked steps of the shaft."""
        load, found = self.solve_all()
        return {
            "shaft_deflection": shaft_steps(
                load=load,
                found=found,
                shaft=self.shaft,
                strength=self.strength(found),
                judged={
                    "basis": self.fatigue and self.fatigue.section(),
                    "tensile_strength": self.own.get("tensile_strength"),
                    "yield_strength": self.own.get("yield_strength"),
                },
                contact=self._touching(load),
            )
        }

    def _touching(self, load: MeshingLoad) -> tuple[LineContact, dict[str, Any]] | None:
        """Pressure along the contact lines, with its inputs."""
        contact, lines = self.contact(load), self.line_contact
        if not (contact and lines):
            return None
        return contact, {
            "roller_radius": self.own["roller_radius"],
            "mating_radius": to_si("radius_mm", lines.mating_radius_mm),
            "materials": lines.materials(),
        }

    def checks(
        self, load: MeshingLoad, result: ShaftDeflection, strength: ShaftStrength | None
    ) -> Verdict:
        """Checks of a result."""
        limits = self.line_contact.pressure_limits() if self.line_contact else {}
        design = ShaftDesign(
            result=result,
            positions=self.positions(),
            roller_circle_radius=self.own["roller_circle_radius"],
            roller_radius=self.own["roller_radius"],
            diameters=[each.diameter for each in self.shaft["shaft_sections"]],
            strength=strength or not_given("strength"),
            yield_strength=self.own.get("yield_strength"),
            fatigue_asked=bool(self.fatigue),
            no_fatigue=self.no_fatigue(),
            contact=self.contact(load) or not_given("contact"),
            pressure_limits=limits,
            requirements=self.requirements.section(),
        )
        return shaft_checks(design)

    def judge(
        self, load: MeshingLoad, result: ShaftDeflection, strength: ShaftStrength | None
    ) -> dict[str, Any]:
        """Verdict of a result, with checks and fixes on request."""

        def checks(changed: dict[str, Any]) -> Verdict:
            fields = {
                name: from_si(name, changed[core_name(name)])
                for name in (*_GEAR, *_ONE_DIAMETER)
                if core_name(name) in changed
            }
            sections = [
                each.model_copy(
                    update={"diameter_mm": from_si("diameter_mm", changed[_diameter(index)])}
                )
                for index, each in enumerate(self.shaft_sections or ())
            ]
            body = self.model_copy(update=fields | {"shaft_sections": sections or None})
            same_gear = all(getattr(body, name) == getattr(self, name) for name in _GEAR)
            own = load if same_gear else body.solve_load()
            found = body.solve_shaft(own)
            return body.checks(own, found, body.strength(found))

        verdict = self.checks(load, result, strength)
        torque, varied = self.torque_Nm, self._varied()
        return self.judged(verdict, torque=torque, design=varied, checks=checks)

    def _varied(self) -> dict[str, float]:
        """Inputs that a fix may change, SI, by core names; of a stepped shaft the diameters, as its
        lengths add up.
        """
        names = _GEAR if self.shaft_sections else (*_GEAR, *_ONE_DIAMETER)
        found = {core_name(name): to_si(name, getattr(self, name)) for name in names}
        for index, each in enumerate(self.shaft_sections or ()):
            found[_diameter(index)] = to_si("diameter_mm", each.diameter_mm)
        return found


class DeflectionOut(ResponseModel, of=Deflection):
    """Deflection or slope in both planes and in total, in the unit of its name."""


class ShaftStrengthOut(ResponseModel, of=ShaftStrength):
    """Bending strength of the shaft, without torsion."""


class LineContactOut(ResponseModel, of=LineContact):
    """Hertz contact of roller and tooth at the largest line load."""


class ShaftDeflectionResponse(JudgedResponse, of=ShaftDeflection):
    """Reactions and deflection of the shaft at the bearings B and C."""

    strength: Maybe[ShaftStrengthOut] = None
    line_contact: Maybe[LineContactOut] = None

    @classmethod
    def values(
        cls, result: ShaftDeflection, run_time_us: float | None = None, **given: object
    ) -> Values:
        """Values of the core's result."""
        deflections = {
            f"{name}_mm": value
            and {axis: from_si("axis_mm", getattr(value, axis)) for axis in ("x", "y", "total")}
            for name in (
                "deflection_B",
                "deflection_C",
                "simplified_deflection_B",
                "simplified_deflection_C",
            )
            for value in (getattr(result, name),)
        }
        slopes = {
            f"{name}_mrad": {
                axis: from_si("axis_mrad", getattr(getattr(result, name), axis))
                for axis in ("x", "y", "total")
            }
            for name in ("slope_B", "slope_C")
        }
        return super().values(result, run_time_us, **deflections, **slopes, **given)


def solve(body: ShaftDeflectionRequest) -> Values:
    """Reactions of the shaft and its deflection at the bearings B and C, in both planes."""
    (load, result), run_time_us = timed(body.solve_all)
    strength, contact = body.strength(result), body.contact(load)
    judged = body.judge(load, result, strength)
    values = ShaftDeflectionResponse.values(
        result,
        run_time_us,
        strength=strength and ShaftStrengthOut.values(strength),
        line_contact=contact and LineContactOut.values(contact),
        **judged,
    )
    fatigue = strength and if_known(lambda: strength.fatigue)
    return warned(values, contact, body.no_fatigue(), fatigue)


def figure(body: ShaftDeflectionRequest, theme: Theme = "light") -> Figure:
    """Shear force, bending moment and deflection along the shaft, in both planes."""
    load = body.solve_load()
    diagram = shaft_diagram(force=load.force, moment=load.moment, **body.shaft)
    place = from_si("position_mm", diagram.position)
    chart = Chart(theme, height=680, legend=LEGEND | {"y": 1.06})
    chart.axis("x", "along_shaft", "mm", anchor="y3")
    panels = (
        ("y", "shear_force", "N", from_si("force_N", diagram.shear_force), [0.7, 1.0]),
        ("y2", "bending_moment", "N·m", from_si("moment_Nm", diagram.bending_moment), [0.36, 0.66]),
        ("y3", "deflection", "mm", from_si("deflection_mm", diagram.deflection), [0.0, 0.32]),
    )
    for axis, title, unit, values, domain in panels:
        chart.axis(axis, title, unit, domain=domain)
        for plane, name in enumerate(("plane_xz", "plane_yz")):
            own: Figure = {"axis": axis, "showlegend": axis == "y"}
            chart.curve(name, place, values[:, plane], plane, **own)
    chart.verticals([body.bearing_distance_mm], "muted", layer="above")
    for name, x in (("C", 0.0), ("B", body.bearing_distance_mm), ("clamp", place[-1])):
        chart.note(name, x=x, y=1, xref="x", yref="paper", yanchor="bottom")
    return chart.figure


CALCULATION = Calculation(
    name="precession/shaft-deflection",
    title="Shaft of the precessional gear",
    tag="precessional gear",
    request=ShaftDeflectionRequest,
    answer=ShaftDeflectionResponse,
    solve=solve,
    figure=figure,
    sources=(KHATETOVSKY_2020, JOHNSON_1985, SHIGLEY),
    neglects=("shear", "bearing_elasticity", "friction"),
)
