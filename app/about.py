"""Information about the service: health, calculations, materials, examples, words."""

import gzip
import hashlib
from functools import cache
from typing import Annotated, Any, Literal

import orjson
from fastapi import APIRouter, HTTPException, Query, Request
from fastapi.responses import Response
from pydantic import Field
from starlette.datastructures import Headers
from starlette.staticfiles import NotModifiedResponse
from starlette.types import Scope

from app import VERSION
from app.calculations.work_precision import COMPARED
from app.endpoint import JSON, CompressedJSON
from app.examples import EXAMPLES
from app.model import Calculation, Maybe, ResponseModel, present
from app.problems import KINDS, RESPONSES
from app.record import root_path
from app.registry import CALCULATIONS, EXPORTS, NEGLECTED
from app.sources import ISO_286
from app.units import from_si, to_si
from app.words import Language, words_in
from core.bearings import BEARINGS, NamedBearing, Ratings
from core.contact_life import LifeCurve
from core.fields import SMALLEST
from core.hertz import LIMIT_SOURCES, Criterion, Verified
from core.material_table import ALIASES, MATERIALS
from core.materials import GROUPS, Fact, Range, Seen, TableMaterial
from core.proposal.shop import SHOPS, Shop
from core.tolerance.iso286 import CLASSES, GRADES, SIZES, Limits, class_limits
from core.tolerance.processes import PROCESSES, Process, Size

CLASS_NAMES = tuple(f"{letter}{grade}" for letter in CLASSES for grade in GRADES)
CLASS_VARIABLES = [("hole_", "shaft_")[each.islower()] + each for each in CLASS_NAMES]
"""Names of these classes for generated clients, which may ignore case."""

ClassName = Annotated[
    Literal[CLASS_NAMES],  # type: ignore[valid-type]
    Field(json_schema_extra={"x-enum-varnames": CLASS_VARIABLES}),
]


class Health(ResponseModel):
    """State and version of the service."""

    status: str = Field(description="`ok`.")
    version: str = Field(description="Version of the service.")


class LimitOut(ResponseModel):
    """Limit of the contact pressure by one criterion."""

    criterion: Criterion = Field(description="Kind of damage that the limit guards against.")
    pressure_MPa: float = Field(description="Limit of the contact pressure.")
    source: str = Field(description="Source of the limit, in English.")
    source_code: str = Field(description="Source of the limit, by code.")
    verified: Verified = Field(
        description="Way in which the source of the limit was checked: in the standard itself, or"
        " in two secondary sources."
    )
    life_curve: Maybe[LifeCurve] = Field(
        description="Curve by which the limit falls over the life, if one is known."
    )


class FactOut(ResponseModel):
    """A value of a material with its spread and its sources; one source alone is for reference."""

    name: str = Field(description="Name of the value, as in the material beside this list.")
    low: Maybe[float] = Field(description="Least value in the sources, in the unit of the name.")
    high: Maybe[float] = Field(description="Largest value in the sources, in the unit of the name.")
    source: str = Field(description="Sources of the value.")
    seen: Seen = Field(description="Number of independent sources.")

    @classmethod
    def of(cls, quantity: str, fact: Fact) -> "FactOut":
        """Answer of a value."""
        name = FACT_NAMES[quantity]
        ends = {}
        if isinstance(fact, Range):
            ends = {"low": from_si(name, fact.low), "high": from_si(name, fact.high)}
        return cls(name=name, source=fact.source, seen=fact.seen, **ends)


FACT_NAMES = {
    "youngs_modulus": "youngs_modulus_GPa",
    "poissons_ratio": "poissons_ratio",
    "yield_strength": "yield_strength_MPa",
    "strength_in_plane": "strength_in_plane_MPa",
    "strength_across": "strength_across_MPa",
    "softening": "softening_C",
    "friction": "friction",
    "dry_friction": "dry_friction",
    "wear_rate": "wear_rate_mm3_per_Nm",
}
"""Names of values whose sources differ, by those of the core."""

OWN_FACTS = (
    "strength_in_plane",
    "strength_across",
    "softening",
    "friction",
    "dry_friction",
    "wear_rate",
)
"""Values that no other field of a material has."""


class MaterialOut(ResponseModel):
    """A material of the table."""

    name: str = Field(description="Name of the material in requests.")
    title: str = Field(description="Designation of the material.")
    group: str = Field(description="Group of the material, in English.")
    group_code: str = Field(description="Group of the material, by code.")
    youngs_modulus_GPa: Maybe[float] = Field(
        description="Young's modulus; absent if no source states it, so that requests have to "
        "give it."
    )
    poissons_ratio: Maybe[float] = Field(
        description="Poisson's ratio; absent if no source states it, so that requests have to "
        "give it."
    )
    allowable_pressure_MPa: Maybe[float] = Field(
        description="Endurance limit of the contact pressure, if one is known."
    )
    limits: list[LimitOut]
    source: str = Field(description="Source of Young's modulus and Poisson's ratio.")
    tensile_strength_MPa: Maybe[float] = Field(description="Tensile strength.")
    yield_strength_MPa: Maybe[float] = Field(
        description="Yield strength Re or Rp0.2, or yield stress of a plastic."
    )
    valid_diameter_mm: Maybe[float] = Field(
        description="Largest diameter or wall for which the strengths hold."
    )
    strength_source: Maybe[str] = Field(
        description="Source of the strengths: a standard, as quoted in two secondary sources."
    )
    strength_in_plane_MPa: Maybe[float] = Field(
        description="Usual strength of a printed plastic in the plane of its layers."
    )
    strength_across_MPa: Maybe[float] = Field(
        description="Usual strength of a printed plastic across its layers."
    )
    softening_C: Maybe[float] = Field(
        description="Heat deflection temperature under 1.8 MPa, or temperature at which the "
        "material softens."
    )
    friction: Maybe[float] = Field(description="Usual friction coefficient of running pairs.")
    dry_friction: Maybe[float] = Field(
        description="Largest dry friction coefficient in data sheets; for information only."
    )
    wear_rate_mm3_per_Nm: Maybe[float] = Field(
        description="Largest dry wear coefficient in the sources; for information only, as no "
        "check uses it by itself."
    )
    youngs_modulus_low_GPa: Maybe[float] = Field(
        description="Least Young's modulus in the sources; deflections are judged by it."
    )
    youngs_modulus_high_GPa: Maybe[float] = Field(
        description="Largest Young's modulus in the sources; pressures and forces are judged by it."
    )
    density_kg_m3: Maybe[float] = Field(description="Density.")
    density_source: Maybe[str] = Field(description="Source of the density.")
    facts: Maybe[list[FactOut]] = Field(
        description="Values on which sources differ, or which have a single source, with the "
        "sources of each."
    )
    aliases: Maybe[list[str]] = Field(
        description="Other names of the material that requests may use."
    )

    @classmethod
    def of(cls, entry: TableMaterial) -> "MaterialOut":
        """Answer of a table entry."""
        facts, moduli, strength = entry.facts, dict(entry.moduli), entry.strength
        match facts.get("youngs_modulus"):
            case Range(low=low, high=high):
                moduli |= {"youngs_modulus_low": low, "youngs_modulus_high": high}
        limits = [
            LimitOut(
                criterion=limit.criterion,
                pressure_MPa=from_si("pressure_MPa", limit.pressure),
                source=LIMIT_SOURCES[limit.source],
                source_code=limit.source,
                verified=limit.verified or "secondary",
                **present({"life_curve": limit.curve}),
            )
            for limit in entry.limits
        ]
        numbers = {
            "youngs_modulus_GPa": moduli.get("youngs_modulus"),
            "poissons_ratio": moduli.get("poissons_ratio"),
            "youngs_modulus_low_GPa": moduli.get("youngs_modulus_low"),
            "youngs_modulus_high_GPa": moduli.get("youngs_modulus_high"),
            "tensile_strength_MPa": strength.tensile,
            # The strength of a printed plastic in its plane states that value.
            "yield_strength_MPa": strength.yield_strength
            if "strength_in_plane" not in facts
            else None,
            "valid_diameter_mm": strength.valid_diameter,
            "density_kg_m3": entry.density,
        } | {FACT_NAMES[each]: facts[each].value for each in OWN_FACTS if each in facts}
        others = {
            "strength_source": strength.source or None,
            "density_source": entry.density_source or None,
            "allowable_pressure_MPa": next(
                (each.pressure_MPa for each in limits if each.criterion != "static"), None
            ),
            "facts": [FactOut.of(name, each) for name, each in facts.items()] or None,
            "aliases": list(ALIASES.get(entry.name, ())) or None,
        }
        return cls(
            name=entry.name,
            title=entry.title,
            group=GROUPS[entry.group],
            group_code=entry.group,
            limits=limits,
            source=entry.source,
            **present({name: from_si(name, value) for name, value in numbers.items()} | others),
        )


class MaterialTable(ResponseModel):
    """The table of materials."""

    materials: list[MaterialOut]


class SizeOut(ResponseModel):
    """Limits of a diameter, or its ISO 286 class."""

    tolerance_class: Maybe[str] = Field(alias="class", description="ISO 286 class.")
    lower_mm: Maybe[float] = Field(description="Lower limit deviation.")
    upper_mm: Maybe[float] = Field(description="Upper limit deviation.")

    @classmethod
    def of(cls, size: Size) -> "SizeOut | None":
        """Answer of a size; None where there is none."""
        if isinstance(size, Limits):
            ends = {end: from_si("size_mm", getattr(size, end)) for end in ("lower", "upper")}
            return cls(**{"lower_mm": ends["lower"], "upper_mm": ends["upper"]})
        return None if size is None else cls(**{"class": size})


class ProcessEntry(ResponseModel, of=Process):
    """Usual deviations of a manufacturing process: guide values for the part as it is made."""

    hole_diameter: Maybe[SizeOut] = Field(
        description="Usual class or limits of the diameter of holes."
    )
    pin_diameter: Maybe[SizeOut] = Field(
        description="Usual class or limits of the diameter of pins; absent if the process makes "
        "no pins."
    )

    @classmethod
    def of(cls, each: Process) -> "ProcessEntry":
        """Answer of a process."""
        sizes: dict[str, Any] = {
            f"{part}_diameter": SizeOut.of(each.size(part)) for part in ("hole", "pin")
        }
        return cls.model_validate(cls.values(each, **sizes))


class ShopOut(ResponseModel, of=Shop):
    """Parts of a reducer that `/propose` makes by a process."""


class ProcessTable(ResponseModel):
    """Manufacturing processes, from coarse to fine."""

    processes: list[ProcessEntry]
    reducers: list[ShopOut] = Field(description="Processes of `/propose`.")


class BearingRatingsOut(ResponseModel, of=Ratings):
    """Load ratings of a bearing by one maker."""


class BearingOut(ResponseModel, of=NamedBearing):
    """A bearing of the table."""


class BearingTable(ResponseModel):
    """The table of bearings."""

    bearings: list[BearingOut]


class Example(ResponseModel):
    """A paper's figure or number as a ready request."""

    id: str = Field(description="Identifier of the example.")
    title: str = Field(description="Title of the example.")
    source: str = Field(description="Paper from which the example is taken.")
    calculation: str = Field(description="Name of the calculation that the example asks for.")
    input: dict[str, Any] = Field(description="Request of the example.")


class ExampleList(ResponseModel):
    """All examples, in the order in which the page offers them."""

    examples: list[Example]


class NeglectedOut(ResponseModel):
    """Effect that a model leaves out."""

    code: str = Field(
        description="Neglected effect, by code.", json_schema_extra={"enum": [*NEGLECTED]}
    )
    detail: str = Field(description="Neglected effect, in English.")


class CalculationOut(ResponseModel):
    """A calculation of the service."""

    name: str = Field(
        description="Name of the calculation in paths, batches, studies and examples."
    )
    title: str = Field(description="Title of the calculation.")
    path: str = Field(description="Path of the endpoint.")
    chart: Maybe[str] = Field(description="Path of the figure.")
    batched: bool = Field(description="True if batches accept the calculation.")
    compared: bool = Field(
        description="True if `/work-precision` compares methods of the calculation."
    )
    sources: list[str] = Field(description="Sources of the formulas.")
    model: list[NeglectedOut] = Field(
        description="Effects that the model leaves out even if all of its sections are given. "
        "Effects that are left out because a section is not given are in "
        "`not_considered` of the answer."
    )

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
            compared=each.name in {name for name, *_ in COMPARED},
            sources=[*each.sources],
            model=[NeglectedOut(code=code, detail=NEGLECTED[code]) for code in each.neglects],
        )


class ExportOut(ResponseModel):
    """Files of a design."""

    name: str = Field(description="Path of the endpoint after `/api/v1/`.")
    title: str = Field(description="Name for users.")
    installed: bool = Field(
        description="True if the service answers them; otherwise it lacks the extra that they need."
    )
    media_types: list[str] = Field(
        description="Media types that the service answers: a request is "
        "answered in the first one that fits its files, or in PDF if it accepts that."
    )


class CalculationList(ResponseModel):
    """All calculations and files."""

    calculations: list[CalculationOut]
    exports: list[ExportOut]


class ProblemKind(ResponseModel):
    """Explanation of a kind of problem."""

    type: str
    description: str


API = "/api/v1"


class ClassOut(ResponseModel):
    """Limits of a diameter by an ISO 286 class."""

    tolerance_class: str = Field(
        alias="class", description="ISO 286 class: lower case for a shaft, upper case for a hole."
    )
    lower_mm: float = Field(description="Lower limit deviation.")
    upper_mm: float = Field(description="Upper limit deviation.")

    @classmethod
    def of(cls, name: str, size_mm: float) -> "ClassOut":
        """Answer of a class at a nominal diameter."""
        limits = class_limits(size=to_si("size_mm", size_mm), tolerance_class=name)
        ends = {end: from_si(f"{end}_mm", getattr(limits, end)) for end in ("lower", "upper")}
        return cls(**{"class": name, "lower_mm": ends["lower"], "upper_mm": ends["upper"]})


class ClassList(ResponseModel):
    """Classes at a nominal diameter."""

    size_mm: float = Field(description="Nominal diameter.")
    source: str = Field(description="Source of the table.")
    tolerances: list[ClassOut]


class NoticeWords(ResponseModel):
    """Words of a warning, with explanation."""

    text: str = Field(description="Text of the warning.")
    title: str = Field(description="Title of the warning.")
    tests: str = Field(description="Condition under which the warning is not given.")
    why: str = Field(description="Reason why the warning matters.")
    mend: str = Field(description="Advice on what to change.")


class CheckWords(ResponseModel):
    """Words of a check."""

    title: str = Field(description="Title of the check.")
    why: str = Field(description="Consequence if the check fails.")
    warning: Maybe[NoticeWords] = Field(
        default=None, description="Warning with the code of the check, in answers without checks."
    )
    refusal: Maybe[str] = Field(
        default=None, description="Text of a refusal with the code of the check."
    )


class FieldWords(ResponseModel):
    """Words of a field of requests."""

    title: str = Field(description="Title of the field.")
    help: str = Field(description="Meaning of the field.")


class Words(ResponseModel):
    """Texts of the service by code, in a table for each kind of code. A code of a refusal,
    warning, check or reason is in one of their tables, whichever of them uses it.

    A name in braces is a parameter of the refusal, warning or figure, whose value is put there,
    with its unit if the name ends in one.
    """

    refusals: dict[str, str] = Field(
        description="Texts of refusals, by `code` of `errors`: the rest of a sentence that starts"
        " with the field, or a whole sentence if the mechanism is impossible."
    )
    places: dict[str, str] = Field(description="Names of the positions in `where` of a refusal.")
    notices: dict[str, NoticeWords] = Field(description="Warnings, by `code` of `warnings`.")
    checks: dict[str, CheckWords] = Field(description="Checks, by `code`.")
    check_groups: dict[str, str] = Field(description="Subjects of checks, by `group`.")
    reasons: dict[str, str] = Field(
        description="Reasons for the status of a check, by `reason.code`, if the code has no text"
        " elsewhere."
    )
    was: dict[str, dict[str, str]] = Field(
        description="Former codes, valid for one more release, by the codes of `errors`, of "
        "`warnings` and of reasons of checks that replace them."
    )
    sources: dict[str, str] = Field(description="Sources of checks and limits, by `source_code`.")
    criteria: dict[str, str] = Field(
        description="Kinds of damage that a limit of the pressure guards against, by `criterion`."
    )
    verified: dict[str, str] = Field(
        description="Ways in which the source of a limit was checked, by `verified`."
    )
    not_considered: dict[str, str] = Field(description="Effects that a verdict does not consider.")
    methods: dict[str, str] = Field(description="Methods of calculation, by `method_code`.")
    worked_values: dict[str, str] = Field(
        description="Intermediate values of worked steps, by `code` of `worked`."
    )
    worked_notes: dict[str, str] = Field(
        description="Texts for `note` and `method` of worked steps."
    )
    worked_errata: dict[str, str] = Field(description="Texts for `erratum` of worked steps.")
    worked_sources: dict[str, str] = Field(description="Texts for `source` of worked steps.")
    settings: dict[str, str] = Field(description="Settings of methods, by `setting_code`.")
    figures: dict[str, str] = Field(
        description="Texts of figures, by the id in `layout.meta.words`; an id that starts with "
        "`methods.` or `settings.` refers to the table of that name."
    )
    fields: Maybe[dict[str, FieldWords]] = Field(
        default=None,
        description="Fields of requests, by name, or by group and name where groups differ: "
        "`pin.diameter_mm`. English is in the description of the API.",
    )
    materials: Maybe[dict[str, str]] = Field(
        default=None, description="Materials, by name. English is in `/materials`."
    )
    material_groups: Maybe[dict[str, str]] = Field(
        default=None, description="Groups of materials. English is in `/materials`."
    )
    examples: Maybe[dict[str, str]] = Field(
        default=None, description="Examples, by `id`. English is in `/examples`."
    )
    neglected: Maybe[dict[str, str]] = Field(
        default=None,
        description="Effects that models leave out, by `code`. English is in `/calculations`.",
    )


class Packed:
    """Content that is compressed and tagged once, as a page asks for some sixty files."""

    def __init__(self, content: bytes, media_type: str) -> None:
        self.plain = Response(content, media_type=media_type, headers={"vary": "accept-encoding"})
        self.zipped = Response(
            gzip.compress(content, mtime=0),
            media_type=media_type,
            headers={"vary": "accept-encoding", "content-encoding": "gzip"},
        )
        self.etag = f'"{hashlib.blake2b(content, digest_size=12).hexdigest()}"'
        for each in (self.plain, self.zipped):
            each.headers["etag"] = f"W/{self.etag}"

    def response(self, scope: Scope) -> Response:
        """Answer to a request: the content, or that nothing has changed."""
        headers = Headers(scope=scope)
        response = self.zipped if "gzip" in headers.get("accept-encoding", "") else self.plain
        known = headers.get("if-none-match", "")
        if known.strip() == "*" or self.etag in [
            each.strip().removeprefix("W/") for each in known.split(",")
        ]:
            return NotModifiedResponse(response.headers)
        return response


router = APIRouter(prefix=API, tags=["service"], default_response_class=CompressedJSON)


@router.get("/health", operation_id="health")
async def health() -> Health:
    """State and version of the service."""
    return Health(status="ok", version=VERSION)


problems = APIRouter()


@problems.get("/problems/{kind}", include_in_schema=False)
async def problem_kind(kind: str) -> ProblemKind:
    """Explanation of a kind of problem; its address is the `type` of such problems."""
    if kind not in KINDS:
        raise HTTPException(404)
    return ProblemKind(type=f"{root_path()}/problems/{kind}", description=KINDS[kind][1])


@router.get("/calculations", operation_id="calculations", response_model_exclude_none=True)
async def calculations() -> CalculationList:
    """Calculations of the service: names, paths, sources, effects that models leave out; files of
    a design that it answers.
    """
    return CalculationList(
        calculations=[CalculationOut.of(each) for each in CALCULATIONS.values()],
        exports=[
            ExportOut(
                name=each.name,
                title=each.title,
                installed=bool(each.answered),
                media_types=[*each.answered],
            )
            for each in EXPORTS.values()
        ],
    )


@router.get("/materials", operation_id="materials", response_model_exclude_none=True)
async def materials() -> MaterialTable:
    """The table of materials, each value with its source."""
    return MaterialTable(materials=[MaterialOut.of(entry) for entry in MATERIALS.values()])


@router.get("/bearings", operation_id="bearings")
async def bearings() -> BearingTable:
    """The table of bearings by name, with the load ratings of each maker and their source."""
    return BearingTable.model_validate({"bearings": [*map(BearingOut.values, BEARINGS.values())]})


@router.get("/tolerances", operation_id="tolerances", responses={422: RESPONSES[422]})
async def tolerances(
    size_mm: Annotated[
        float,
        Query(ge=SMALLEST, le=SIZES[-1], allow_inf_nan=False, description="Nominal diameter."),
    ],
    name: Annotated[
        ClassName | None, Query(alias="class", description="One class; all where not given.")
    ] = None,
) -> ClassList:
    """Limits of the ISO 286 classes of pins and holes at a nominal diameter. Classes f and g up to
    3 mm and m above 180 mm use the standard's formulas of 1988.
    """
    names = CLASS_NAMES if name is None else (name,)
    found = [ClassOut.of(each, size_mm) for each in names]
    return ClassList(size_mm=size_mm, source=ISO_286, tolerances=found)


@router.get("/processes", operation_id="processes", response_model_exclude_none=True)
async def processes() -> ProcessTable:
    """Usual deviations of manufacturing processes with sources: guides for unknown tolerances."""
    return ProcessTable(
        processes=[ProcessEntry.of(each) for each in PROCESSES.values()],
        reducers=[ShopOut.model_validate(ShopOut.values(each)) for each in SHOPS.values()],
    )


@router.get("/examples", operation_id="examples")
async def examples() -> ExampleList:
    """The papers' figures and numbers as ready requests."""
    return ExampleList(examples=[Example(**example) for example in EXAMPLES])


@cache
def _words(language: Language) -> Packed:
    words = Words(**words_in(language))
    return Packed(orjson.dumps(words.model_dump(exclude_none=True)), JSON)


@router.get("/words", operation_id="words", response_model=Words, responses={422: RESPONSES[422]})
async def words(
    request: Request,
    language: Annotated[Language, Query(description="Language of the texts.")] = "en",
) -> Response:
    """Texts by code. English titles and help of fields are in the description of the API;
    `/calculations`, `/materials` and `/examples` explain their own codes and names in English.
    """
    return _words(language).response(request.scope)
