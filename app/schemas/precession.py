"""Requests and answers of the precessional gear: contact lines, meshing load, shaft."""

from collections.abc import Sequence
from typing import Annotated, Literal, Self

import numpy as np
from numpy.typing import NDArray
from pydantic import Field, model_validator

from app.schemas.base import (
    SIZE,
    AccuracyOut,
    RequestModel,
    ResponseModel,
    WarningOut,
    field_error,
    quantity,
)
from app.units import from_si, to_si
from core.errors import InvalidInput
from core.precession.contact_line import (
    ContactLine,
    ContactLines,
    ContactPoints,
    contact_lines,
    contact_points,
)
from core.precession.meshing_load import MeshingLoad, line_load, meshing_load
from core.precession.rollers import Roller, RollerByAngle, RollerByLength, wheel_rollers
from core.precession.shaft import ShaftDiagram, ShaftSection, shaft_diagram
from core.precession.shaft_deflection import Deflection, ShaftDeflection, shaft_deflection

MAX_ROLLERS = 500
"""Most rollers of one wheel."""

MAX_POINT_VALUES = 200_000
"""Most points of all contact lines together."""

Coordinate = Annotated[float, Field(ge=-1e6, le=1e6)]
FloatArray = NDArray[np.float64]
Vector = tuple[float, float, float]
Plane = tuple[float, float]


class RollerFields(RequestModel):
    """One roller: its place on the wheel and the limits of its contact line."""

    position_angle_deg: float = quantity(
        "Position angle",
        symbol="φ₁",
        group="rollers",
        ge=-3600,
        le=3600,
        step=15,
        help="Position of the roller on the central wheel.",
    )
    z_min_mm: Coordinate | None = quantity(
        "Working length from",
        symbol="z_min",
        group="rollers",
        default=None,
        step=1,
        help="Start of the working length, along the axis from the precession centre.",
    )
    z_max_mm: Coordinate | None = quantity(
        "Working length to",
        symbol="z_max",
        group="rollers",
        default=None,
        step=1,
        help="End of the working length.",
    )
    phi_min_deg: float | None = quantity(
        "Contact from",
        symbol="φ_min",
        group="rollers",
        default=None,
        ge=-3600,
        le=3600,
        step=1,
        help="Polar angle on the roller at which contact starts, instead of a working length.",
    )
    phi_max_deg: float | None = quantity(
        "Contact to",
        symbol="φ_max",
        group="rollers",
        default=None,
        ge=-3600,
        le=3600,
        step=1,
        help="Polar angle on the roller at which contact ends.",
    )

    @model_validator(mode="after")
    def _one_pair_of_limits(self) -> Self:
        by_length = (self.z_min_mm, self.z_max_mm)
        by_angle = (self.phi_min_deg, self.phi_max_deg)
        if by_length != (None, None) and by_angle != (None, None):
            raise field_error("phi_min_deg", "give limits in z or in phi, not both")
        if by_length == by_angle == (None, None):
            raise field_error(
                "z_min_mm", "is needed: z_min_mm and z_max_mm, or phi_min_deg and phi_max_deg"
            )
        names = (
            ("phi_min_deg", "phi_max_deg")
            if by_length == (None, None)
            else ("z_min_mm", "z_max_mm")
        )
        for name in names:
            if getattr(self, name) is None:
                raise field_error(name, "is needed beside the other limit")
        return self

    def roller(self) -> Roller:
        """The roller in SI units."""
        if self.z_min_mm is not None:
            return RollerByLength(**self.to_core())
        return RollerByAngle(**self.to_core())


class WheelFields(RequestModel):
    """Evenly spaced rollers with one working length."""

    rollers_total: int = quantity(
        "Rollers of the wheel",
        symbol="z₁",
        group="rollers",
        ge=1,
        le=MAX_ROLLERS,
        step=1,
        help="Number of rollers of the central wheel.",
    )
    rollers_in_mesh: int | None = quantity(
        "Rollers in mesh",
        symbol="",
        group="rollers",
        default=None,
        ge=1,
        le=MAX_ROLLERS,
        step=1,
        help="How many of them touch the satellite, from the first on; all where not given.",
    )
    position_angle_deg: float = quantity(
        "Position of the first",
        symbol="φ₁",
        group="rollers",
        ge=-3600,
        le=3600,
        step=5,
        help="Position angle of the first roller.",
    )
    z_min_mm: Coordinate = quantity(
        "Working length from",
        symbol="z_min",
        group="rollers",
        step=1,
        help="Start of the working length, along the axis from the precession centre.",
    )
    z_max_mm: Coordinate = quantity(
        "Working length to",
        symbol="z_max",
        group="rollers",
        step=1,
        help="End of the working length.",
    )


class GearFields(RequestModel):
    """Geometry of the mesh and its rollers."""

    roller_circle_radius_mm: float = quantity(
        "Roller circle radius",
        symbol="R_C",
        group="gear",
        **SIZE,
        step=1,
        help="Radius of the circle of the roller axes.",
    )
    roller_radius_mm: float = quantity(
        "Roller radius",
        symbol="ρ",
        group="gear",
        **SIZE,
        step=0.5,
        help="Radius of a roller.",
    )
    nutation_angle_deg: float = quantity(
        "Nutation angle",
        symbol="θ",
        group="gear",
        gt=0,
        lt=90,
        step=0.5,
        help="Angle between the axes of the central wheel and the satellite.",
    )
    ratio_u12: float = quantity(
        "Ratio",
        symbol="u₁₂",
        group="gear",
        ge=-1e6,
        le=1e6,
        step=0.01,
        help="Ratio of the mesh with the input shaft held.",
    )
    rollers: list[RollerFields] | None = quantity(
        "Rollers",
        symbol="",
        group="rollers",
        default=None,
        min_length=1,
        max_length=MAX_ROLLERS,
        help="The rollers in mesh, one by one.",
    )
    wheel: WheelFields | None = quantity(
        "Wheel",
        symbol="",
        group="rollers",
        default=None,
        help="Evenly spaced rollers with one working length, instead of a list.",
    )

    @model_validator(mode="after")
    def _rollers_or_wheel(self) -> Self:
        if self.rollers is not None and self.wheel is not None:
            raise field_error("wheel", "give either rollers or wheel")
        if self.rollers is None and self.wheel is None:
            raise field_error("rollers", "is needed: rollers or wheel")
        return self

    def gear(self) -> dict[str, float]:
        """Geometry in SI units, as the core's arguments."""
        return {
            "roller_circle_radius": to_si("radius_mm", self.roller_circle_radius_mm),
            "roller_radius": to_si("radius_mm", self.roller_radius_mm),
            "nutation_angle": to_si("angle_deg", self.nutation_angle_deg),
            "ratio_u12": self.ratio_u12,
        }

    def all_rollers(self) -> Sequence[Roller]:
        """The rollers in SI units."""
        if self.rollers is not None:
            return [each.roller() for each in self.rollers]
        assert self.wheel is not None
        return wheel_rollers(**self.wheel.to_core())

    def about_the_wheel(self, error: InvalidInput) -> InvalidInput:
        """A refusal of one roller, as one of the wheel where a wheel was given."""
        if self.wheel is not None and error.parameter.startswith("rollers["):
            return InvalidInput("wheel", None, f"{error.parameter} {error.limit}")
        return error


class ContactLineRequest(GearFields):
    """A mesh whose contact lines are asked."""

    torque_sign: Literal[-1, 1] | None = quantity(
        "Sign of the torque",
        symbol="",
        group="load",
        default=None,
        help="Chooses the loaded flank of rollers whose limits are given in z.",
    )
    include: list[Literal["points"]] = Field(
        default=[], description="Optional results: what is not named is not computed."
    )
    samples: int = quantity(
        "Samples",
        symbol="",
        group="rollers",
        default=61,
        ge=2,
        le=10_001,
        step=1,
        advanced=True,
        help="Number of points of each contact line.",
    )

    def solve(self) -> tuple[ContactLines, list[ContactPoints] | None]:
        """Contact lines, and their points where asked."""
        try:
            lines = contact_lines(
                **self.gear(), rollers=self.all_rollers(), torque_sign=self.torque_sign
            )
        except InvalidInput as error:
            raise self.about_the_wheel(error) from error
        if "points" not in self.include:
            return lines, None
        if self.samples * len(lines.lines) > MAX_POINT_VALUES:
            raise InvalidInput(
                "samples",
                self.samples,
                f"must be at most {MAX_POINT_VALUES // len(lines.lines)} for "
                f"{len(lines.lines)} rollers",
            )
        return lines, [contact_points(line=line, samples=self.samples) for line in lines.lines]


class MeshingLoadRequest(GearFields):
    """A mesh and its torque."""

    torque_Nm: float = quantity(
        "Torque",
        symbol="M₁",
        group="load",
        ge=-1e12,
        le=1e12,
        step=1,
        help="Torque on the central wheel; its sign chooses the loaded flanks.",
    )
    reference_z_mm: Coordinate = quantity(
        "Place of C",
        symbol="l",
        group="load",
        step=1,
        help="Place of the bearing C along the axis, from the precession centre.",
    )

    def solve_load(self) -> MeshingLoad:
        """Load of the mesh."""
        try:
            return meshing_load(
                **self.gear(),
                rollers=self.all_rollers(),
                torque=self.torque_Nm,
                reference_z=to_si("reference_z_mm", self.reference_z_mm),
            )
        except InvalidInput as error:
            raise self.about_the_wheel(error) from error

    def solve_curves(self) -> list[tuple[float, FloatArray, FloatArray]]:
        """Line load of every roller: position angle, rad, places z, m, load there, N/m."""
        load = self.solve_load()
        curves = []
        for line in load.lines:
            z = np.linspace(line.z_min, line.z_max, 61)
            curves.append((line.position_angle, z, line_load(load=load, line=line, z=z)))
        return curves


class ShaftSectionFields(RequestModel):
    """A stretch of the shaft with one diameter."""

    length_mm: float = quantity("Length", symbol="", group="shaft", **SIZE, step=1)
    diameter_mm: float = quantity("Diameter", symbol="", group="shaft", **SIZE, step=1)


class ShaftDeflectionRequest(MeshingLoadRequest):
    """A mesh, its torque and the shaft that carries it."""

    bearing_distance_mm: float = quantity(
        "Bearing distance",
        symbol="a",
        group="shaft",
        **SIZE,
        step=1,
        help="Distance of the satellite's bearings, from C to B.",
    )
    overhang_mm: float = quantity(
        "Overhang",
        symbol="b",
        group="shaft",
        **SIZE,
        step=1,
        help="Distance from B to the clamped end of the shaft.",
    )
    shaft_diameter_mm: float | None = quantity(
        "Shaft diameter",
        symbol="d",
        group="shaft",
        default=None,
        **SIZE,
        step=1,
        help="Diameter of the shaft, the same everywhere.",
    )
    shaft_sections: list[ShaftSectionFields] | None = quantity(
        "Shaft sections",
        symbol="",
        group="shaft",
        default=None,
        min_length=1,
        max_length=100,
        help="Stretches of the shaft from C to the clamp, instead of one diameter; their lengths "
        "add up to a + b.",
    )
    youngs_modulus_GPa: float = quantity(
        "Young's modulus",
        symbol="E",
        group="shaft",
        default=210.0,
        **SIZE,
        step=1,
        help="Young's modulus of the shaft.",
    )

    @model_validator(mode="after")
    def _diameter_or_sections(self) -> Self:
        if self.shaft_diameter_mm is not None and self.shaft_sections is not None:
            raise field_error("shaft_sections", "give either shaft_diameter_mm or shaft_sections")
        if self.shaft_diameter_mm is None and self.shaft_sections is None:
            raise field_error("shaft_diameter_mm", "is needed: shaft_diameter_mm or shaft_sections")
        return self

    def solve_shaft(self, load: MeshingLoad) -> ShaftDeflection:
        """Reactions and deflection of the shaft under the load of the mesh."""
        return shaft_deflection(
            force=load.force,
            moment=load.moment,
            force_error=load.force_error,
            moment_error=load.moment_error,
            bearing_distance=to_si("distance_mm", self.bearing_distance_mm),
            overhang=to_si("overhang_mm", self.overhang_mm),
            youngs_modulus=to_si("youngs_modulus_GPa", self.youngs_modulus_GPa),
            shaft_diameter=to_si("diameter_mm", self.shaft_diameter_mm),
            shaft_sections=self._sections(),
        )

    def solve(self) -> ShaftDeflection:
        """Reactions and deflection of the shaft."""
        return self.solve_shaft(self.solve_load())

    def solve_diagram(self) -> tuple[ShaftDeflection, ShaftDiagram]:
        """Reactions and deflection, and the course of loads and deflection along the shaft."""
        load = self.solve_load()
        diagram = shaft_diagram(
            force=load.force,
            moment=load.moment,
            bearing_distance=to_si("distance_mm", self.bearing_distance_mm),
            overhang=to_si("overhang_mm", self.overhang_mm),
            youngs_modulus=to_si("youngs_modulus_GPa", self.youngs_modulus_GPa),
            shaft_diameter=to_si("diameter_mm", self.shaft_diameter_mm),
            shaft_sections=self._sections(),
        )
        return self.solve_shaft(load), diagram

    def _sections(self) -> list[ShaftSection] | None:
        if self.shaft_sections is None:
            return None
        return [ShaftSection(**each.to_core()) for each in self.shaft_sections]


class PointsOut(ResponseModel):
    """Points of a contact line: developed on the roller (z over x) and in space."""

    z_mm: list[float]
    phi_deg: list[float]
    x_mm: list[float]
    position_mm: list[Vector]


class ContactLineOut(ResponseModel):
    """One contact line."""

    position_angle_deg: float
    z_min_mm: float
    z_max_mm: float
    phi_min_deg: float
    phi_max_deg: float
    length_mm: float
    points: PointsOut | None = None

    @classmethod
    def of(cls, line: ContactLine, points: ContactPoints | None) -> Self:
        """Answer from a line and its points."""
        if points is None:
            return cls.from_core(line, points=None)
        return cls.from_core(line, points=PointsOut.from_core(points))


class ContactLineResponse(ResponseModel):
    """Contact lines of all rollers."""

    lines: list[ContactLineOut]
    total_length_mm: float
    accuracy: AccuracyOut

    @classmethod
    def from_core(
        cls,
        result: tuple[ContactLines, list[ContactPoints] | None],
        run_time_us: float | None = None,
        **given: object,
    ) -> Self:
        """Answer from the lines and their points."""
        found, points = result
        each_points: list[ContactPoints | None] = [None] * len(found.lines)
        if points is not None:
            each_points = list(points)
        return super().from_core(
            found,
            run_time_us,
            lines=[
                ContactLineOut.of(line, drawn)
                for line, drawn in zip(found.lines, each_points, strict=True)
            ],
            **given,
        )


class MeshingLoadResponse(ResponseModel):
    """Resultants of the mesh, moment about the point C."""

    force_N: Vector
    moment_Nm: Vector
    max_line_load_N_per_mm: float
    total_length_mm: float
    accuracy: AccuracyOut
    warnings: list[WarningOut] | None = None


class DeflectionOut(ResponseModel):
    """Deflection in both planes and in all, in the unit of its name."""

    x: float
    y: float
    total: float

    @classmethod
    def of(cls, deflection: Deflection) -> Self:
        """Answer from the core's deflection, mm."""
        return cls(
            x=from_si("x_mm", deflection.x),
            y=from_si("y_mm", deflection.y),
            total=from_si("total_mm", deflection.total),
        )


class ShaftDeflectionResponse(ResponseModel):
    """Reactions and deflection of the shaft at the bearings B and C."""

    reaction_B_N: Plane
    reaction_C_N: Plane
    deflection_B_mm: DeflectionOut
    deflection_C_mm: DeflectionOut
    simplified_deflection_B_mm: DeflectionOut | None = None
    simplified_deflection_C_mm: DeflectionOut | None = None
    simplification_error_B: float | None = None
    simplification_error_C: float | None = None
    accuracy: AccuracyOut
    warnings: list[WarningOut] | None = None

    @classmethod
    def from_core(
        cls, result: ShaftDeflection, run_time_us: float | None = None, **given: object
    ) -> Self:
        """Answer from the core's result."""
        deflections = {
            f"{name}_mm": None if value is None else DeflectionOut.of(value)
            for name in (
                "deflection_B",
                "deflection_C",
                "simplified_deflection_B",
                "simplified_deflection_C",
            )
            for value in (getattr(result, name),)
        }
        return super().from_core(result, run_time_us, **deflections, **given)
