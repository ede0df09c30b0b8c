"""Request and answer of the strength of swinging rollers."""

from typing import Annotated, Self

from pydantic import Field, field_validator, model_validator

from app.schemas.base import (
    SIZE,
    AccuracyOut,
    RequestModel,
    ResponseModel,
    WarningOut,
    field_error,
    no_dust,
    quantity,
)
from core.rollers.roller_curves import RollerCurves, roller_curves
from core.rollers.roller_strength import RollerStrength, roller_strength

MAX_ROLLERS = 1000
"""Most rollers of one mechanism."""

Gap = Annotated[float, Field(ge=-1e6, le=1e6)]


class RollerStrengthRequest(RequestModel):
    """Rollers, their load, and how far their holes are off."""

    output_torque_Nm: float = quantity(
        "Output torque",
        symbol="T",
        group="load",
        **SIZE,
        step=10,
        help="Torque on the output shaft.",
    )
    hole_circle_radius_mm: float = quantity(
        "Hole circle radius",
        symbol="R",
        group="load",
        **SIZE,
        step=1,
        help="Radius of the circle of the rollers' holes.",
    )
    rollers: int = quantity(
        "Rollers",
        symbol="n",
        group="load",
        ge=1,
        le=MAX_ROLLERS,
        step=1,
        help="Number of rollers.",
    )
    position_tolerance_mm: float | None = quantity(
        "Position tolerance",
        symbol="χ",
        group="load",
        default=None,
        ge=0,
        le=1e6,
        step=0.005,
        help="Positional tolerance of the holes; the worst case has one hole ahead in each part.",
    )
    gaps_mm: list[Gap] | None = quantity(
        "Gaps",
        symbol="g₁ … g_n",
        group="load",
        default=None,
        max_length=MAX_ROLLERS,
        help="Gap of each roller before it carries, instead of the worst case of a tolerance.",
    )
    diameter_mm: float = quantity(
        "Cylinder diameter",
        symbol="d",
        group="roller",
        **SIZE,
        step=0.5,
        help="Diameter of the cylinders between the spheres.",
    )
    cylinder_length_mm: float = quantity(
        "Cylinder length",
        symbol="l",
        group="roller",
        **SIZE,
        step=1,
        help="Length of one cylinder, from the middle sphere to the end sphere.",
    )
    sphere_width_mm: float = quantity(
        "Sphere width",
        symbol="b",
        group="roller",
        **SIZE,
        step=0.5,
        help="Width of a spherical part along the roller.",
    )
    sphere_diameter_mm: float = quantity(
        "Sphere diameter",
        symbol="D",
        group="roller",
        **SIZE,
        step=0.5,
        help="Diameter of the spherical parts.",
    )
    friction_coefficient: float = quantity(
        "Friction coefficient",
        symbol="k",
        group="roller",
        ge=0,
        le=10,
        step=0.01,
        default=0.16,
        help="Friction between sphere and hole.",
    )
    youngs_modulus_GPa: float = quantity(
        "Young's modulus",
        symbol="E",
        group="material",
        **SIZE,
        step=1,
        default=210.0,
        help="Young's modulus of the rollers.",
    )
    poissons_ratio: float | None = quantity(
        "Poisson's ratio",
        symbol="ν",
        group="material",
        default=None,
        ge=0,
        lt=0.5,
        step=0.01,
        help="Poisson's ratio of the rollers; gives the shear modulus.",
    )
    shear_modulus_GPa: float | None = quantity(
        "Shear modulus",
        symbol="G",
        group="material",
        default=None,
        **SIZE,
        step=1,
        help="Shear modulus of the rollers, instead of Poisson's ratio.",
    )
    stress_concentration: float = quantity(
        "Stress concentration",
        symbol="K_σ",
        group="material",
        default=1.0,
        ge=1,
        le=100,
        step=0.1,
        help="Stress concentration at the step beside the middle sphere.",
    )

    _sizes = field_validator("position_tolerance_mm", "gaps_mm")(no_dust)

    @model_validator(mode="after")
    def _one_form_each(self) -> Self:
        for first, second in (
            ("position_tolerance_mm", "gaps_mm"),
            ("poissons_ratio", "shear_modulus_GPa"),
        ):
            given = [getattr(self, name) is not None for name in (first, second)]
            if all(given):
                raise field_error(second, f"give either {first} or {second}")
            if not any(given):
                raise field_error(first, f"is needed: {first} or {second}")
        if self.gaps_mm is not None and len(self.gaps_mm) != self.rollers:
            raise field_error(
                "gaps_mm",
                f"must have one gap for each of the {self.rollers} rollers, has "
                f"{len(self.gaps_mm)}",
            )
        return self

    def solve(self) -> RollerStrength:
        """Load sharing and strength of the rollers."""
        return roller_strength(**self.to_core())

    def solve_curves(self) -> RollerCurves:
        """Curves of stiffness, non-uniformity and stress through this design."""
        return roller_curves(**self.to_core())


class RollerStrengthResponse(ResponseModel):
    """Stiffness, load sharing and stress of the rollers."""

    stiffness_N_per_mm: float
    relative_stiffness: float
    mean_force_N: float
    relative_position_error: float
    load_nonuniformity: float
    max_force_N: float
    centre_force_N: float
    forces_N: list[float]
    displacement_mm: float
    bending_moment_Nm: float
    bending_stress_MPa: float
    loaded_rollers: int
    accuracy: AccuracyOut
    warnings: list[WarningOut] | None = None
