"""What the service says about itself: health, calculations, materials, examples."""

from typing import Any

from fastapi import APIRouter, HTTPException
from pydantic import Field

from app import VERSION
from app.examples import EXAMPLES
from app.model import NEGLECTED, Calculation, Maybe, ResponseModel
from app.problems import KINDS
from app.record import root_path
from app.registry import CALCULATIONS
from app.units import from_si
from core.materials import GROUPS, LIMIT_SOURCES, MATERIALS, Criterion, TableMaterial


class Health(ResponseModel):
    """Whether the service works, and which it is."""

    status: str
    version: str


class LimitOut(ResponseModel):
    """Limit of the contact pressure by one criterion."""

    criterion: Criterion
    pressure_MPa: float
    source: str
    source_code: str


class MaterialOut(ResponseModel):
    """A material of the table."""

    name: str
    title: str
    group: str
    group_code: str
    youngs_modulus_GPa: float
    poissons_ratio: float
    allowable_pressure_MPa: Maybe[float] = Field(
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
                source=LIMIT_SOURCES[limit.source],
                source_code=limit.source,
            )
            for limit in entry.limits
        ]
        endurance = [each.pressure_MPa for each in limits if each.criterion == "endurance"]
        return cls(
            name=entry.name,
            title=entry.title,
            group=GROUPS[entry.group],
            group_code=entry.group,
            youngs_modulus_GPa=from_si("youngs_modulus_GPa", material.youngs_modulus),
            poissons_ratio=material.poissons_ratio,
            **({"allowable_pressure_MPa": endurance[0]} if endurance else {}),
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


class NeglectedOut(ResponseModel):
    """What a model leaves out."""

    code: str = Field(json_schema_extra={"enum": [*NEGLECTED]})
    detail: str


class CalculationOut(ResponseModel):
    """A calculation of the service."""

    name: str = Field(description="Its one name: in paths, batches, studies and examples.")
    title: str
    path: str
    chart: Maybe[str] = Field(default=None, description="Path of its figure.")
    batched: bool = Field(description="Whether batches take it.")
    sources: list[str]
    model: list[NeglectedOut] = Field(description="What its model leaves out.")

    @classmethod
    def of(cls, each: Calculation) -> "CalculationOut":
        """Answer of a calculation."""
        prefix = root_path() + API
        return cls(
            name=each.name,
            title=each.title,
            path=f"{prefix}/{each.name}",
            **({"chart": f"{prefix}/{each.name}/chart"} if each.figure else {}),
            batched=each.batched,
            sources=[*each.sources],
            model=[NeglectedOut(code=code, detail=NEGLECTED[code]) for code in each.neglects],
        )


class Calculations(ResponseModel):
    """All calculations."""

    calculations: list[CalculationOut]


class ProblemKind(ResponseModel):
    """What a kind of problem is."""

    type: str
    description: str


API = "/api/v1"

router = APIRouter(prefix=API, tags=["service"])


@router.get("/health", operation_id="health")
async def health() -> Health:
    """Whether the service works."""
    return Health(status="ok", version=VERSION)


problems = APIRouter()


@problems.get("/problems/{kind}", include_in_schema=False)
async def problem_kind(kind: str) -> ProblemKind:
    """What a kind of problem is: the address that is the `type` of such a problem."""
    if kind not in KINDS:
        raise HTTPException(404)
    return ProblemKind(type=f"{root_path()}/problems/{kind}", description=KINDS[kind])


@router.get("/calculations", operation_id="calculations", response_model_exclude_none=True)
async def calculations() -> Calculations:
    """What can be calculated: names, paths, sources, and what each model leaves out."""
    return Calculations(calculations=[CalculationOut.of(each) for each in CALCULATIONS.values()])


@router.get("/materials", operation_id="materials", response_model_exclude_none=True)
async def materials() -> Materials:
    """The table of materials, each value with its source."""
    return Materials(materials=[MaterialOut.of(entry) for entry in MATERIALS.values()])


@router.get("/examples", operation_id="examples")
async def examples() -> Examples:
    """The papers' figures and numbers as ready requests."""
    return Examples(examples=[Example(**example) for example in EXAMPLES])
