"""Request and answer of the strength of swinging rollers."""

from dataclasses import dataclass
from typing import Annotated, Self

import numpy as np
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
from core.arrays import FloatArray
from core.rollers.roller_curves import (
    load_nonuniformity,
    relative_stiffness,
    relative_stress,
    single_roller_limit,
)
from core.rollers.roller_strength import (
    RollerStrength,
    modulus_ratio,
    roller_strength,
)

MAX_ROLLERS = 1000
"""Most rollers of one mechanism."""

ROLLER_SIZES = (
    "output_torque_Nm",
    "hole_circle_radius_mm",
    "cylinder_length_mm",
    "sphere_width_mm",
    "sphere_diameter_mm",
    "diameter_mm",
    "friction_coefficient",
    "youngs_modulus_GPa",
    "stress_concentration",
)
"""Numbers that every request has."""

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

    def solve_curves(self) -> "RollerCurves":
        """Curves of stiffness, non-uniformity and stress through this design."""
        design = self.solve()
        own = self.to_core()
        diameter, modulus = own["diameter"], own["youngs_modulus"]
        shape = {
            "relative_width": own["sphere_width"] / diameter,
            "relative_sphere": own["sphere_diameter"] / diameter,
            "friction_coefficient": self.friction_coefficient,
            "modulus_ratio": modulus_ratio(
                youngs_modulus=modulus,
                poissons_ratio=self.poissons_ratio,
                shear_modulus=own.get("shear_modulus"),
            ),
        }
        own_length = own["cylinder_length"] / diameter
        lengths = np.linspace(min(0.5, own_length / 2), max(4.0, 1.5 * own_length), 121)
        delta = design.relative_position_error
        limit = single_roller_limit(rollers=self.rollers)
        errors = np.linspace(0.0, max(2 * limit, 1.25 * delta), 121)
        tolerance = delta * design.mean_force / design.stiffness
        scale = tolerance if tolerance > 0 else 2e-4 * diameter
        return RollerCurves(
            design=design,
            own_length=own_length,
            limit=limit,
            lengths=lengths,
            stiffness=relative_stiffness(relative_length=lengths, **shape),
            errors=errors,
            nonuniformity={
                rollers: load_nonuniformity(relative_position_error=errors, rollers=rollers)
                for rollers in sorted({3, 4, 6, 8, self.rollers})
            },
            stress={
                factor * scale: modulus
                * relative_stress(
                    relative_length=lengths,
                    **shape,
                    rollers=self.rollers,
                    relative_torque=self.output_torque_Nm / (modulus * diameter**3),
                    relative_radius=own["hole_circle_radius"] / diameter,
                    relative_tolerance=factor * scale / diameter,
                    stress_concentration=self.stress_concentration,
                )
                for factor in ((0.5, 1.0, 1.5, 2.0) if tolerance > 0 else (0.0, 0.5, 1.0))
            },
        )


@dataclass(frozen=True, slots=True)
class RollerCurves:
    """Curves through a design, in SI units.

    Attributes
    ----------
    design : RollerStrength
        The design itself.
    own_length, limit : float
        Its l/d, and the delta from which on one roller carries everything.
    lengths, stiffness : array, shape (n,)
        l/d and relative stiffness.
    errors : array, shape (n,)
        delta.
    nonuniformity : dict of int to array
        Psi over delta by the number of rollers.
    stress : dict of float to array
        Bending stress over l/d, Pa, by the position tolerance, m.
    """

    design: RollerStrength
    own_length: float
    limit: float
    lengths: FloatArray
    stiffness: FloatArray
    errors: FloatArray
    nonuniformity: dict[int, FloatArray]
    stress: dict[float, FloatArray]


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
