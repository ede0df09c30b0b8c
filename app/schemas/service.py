"""Answers of the service about itself: health, materials, examples."""

from typing import Any

from pydantic import Field

from app.schemas.base import ResponseModel
from app.units import from_si
from core.materials import Criterion, TableMaterial


class Health(ResponseModel):
    """Whether the service works, and which it is."""

    status: str
    version: str


class FieldProblem(ResponseModel):
    """What is wrong with one field."""

    pointer: str = Field(description="JSON pointer to the field; empty for the body.")
    detail: str


class ProblemOut(ResponseModel):
    """A refusal (RFC 9457)."""

    type: str
    title: str
    status: int
    detail: str
    errors: list[FieldProblem] = Field(description="The wrong fields, 50 of them at most.")
    more: int | None = Field(default=None, description="How many fields besides are wrong.")
    where: dict[str, float] | None = Field(
        default=None, description="Position at which the mechanism cannot work."
    )


class LimitOut(ResponseModel):
    """Limit of the contact pressure by one criterion."""

    criterion: Criterion
    pressure_MPa: float
    source: str


class MaterialOut(ResponseModel):
    """A material of the table."""

    name: str
    title: str
    group: str
    youngs_modulus_GPa: float
    poissons_ratio: float
    allowable_pressure_MPa: float | None = Field(
        default=None, description="Endurance limit of the contact pressure, where there is one."
    )
    limits: list[LimitOut]
    source: str = Field(description="Where Young's modulus and Poisson's ratio come from.")

    @classmethod
    def of(cls, entry: TableMaterial) -> "MaterialOut":
        """Answer of a table entry."""
        material = entry.material
        limits = [
            LimitOut(
                criterion=limit.criterion,
                pressure_MPa=from_si("pressure_MPa", limit.pressure),
                source=limit.source,
            )
            for limit in entry.limits
        ]
        return cls(
            name=entry.name,
            title=entry.title,
            group=entry.group,
            youngs_modulus_GPa=from_si("youngs_modulus_GPa", material.youngs_modulus),
            poissons_ratio=material.poissons_ratio,
            allowable_pressure_MPa=next(
                (each.pressure_MPa for each in limits if each.criterion == "endurance"), None
            ),
            limits=limits,
            source=entry.source,
        )


class Materials(ResponseModel):
    """The table of materials."""

    materials: list[MaterialOut]


class Example(ResponseModel):
    """A paper's figure or number as a ready request."""

    id: str
    title: str
    source: str
    calculation: str
    input: dict[str, Any]


class Examples(ResponseModel):
    """All examples, in the order in which the page offers them."""

    examples: list[Example]
