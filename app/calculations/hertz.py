"""Hertz contact of pin and hole: request, answer, figure."""

from collections.abc import Collection
from functools import lru_cache
from typing import TYPE_CHECKING, Annotated, Any, Literal, Self

from pydantic import (
    BeforeValidator,
    ConfigDict,
    Discriminator,
    Field,
    Tag,
    field_validator,
    model_validator,
)
from pydantic_core import PydanticCustomError

from app.fields import JSON_FORMS, JsonForm, SectionFields
from app.model import (
    UNION_TAGS,
    AssumingResponse,
    Calculation,
    Maybe,
    RequestModel,
    ResponseModel,
    Size,
    Values,
    WorkedFields,
    no_dust,
    present,
    quantity,
    request_schema,
    result,
    timed,
    warning,
)
from app.rules import field_error
from app.sources import JOHNSON_1985, PERSSON_1964, YANCHEVSKY_2018
from app.theme import Amount, Chart, Figure, Theme, text
from app.units import from_si, to_si
from app.worked import Steps
from core.contact_life import LifeCurve
from core.design.contact import Contact
from core.errors import Notice, if_known
from core.hertz import (
    LIMIT_SOURCES,
    BodySafety,
    ContactLimit,
    Criterion,
    ElasticMaterial,
    HertzContact,
    Layers,
    LimitLife,
    conformal_profile,
    hertz,
    pressure_profile,
)
from core.material_table import ALIASES, ELASTOMERS, MATERIALS, NAMES, SEVERAL, plain_name
from core.materials import GROUPS, NOT_LISTED, TableMaterial, by_values
from core.worked.hertz import hertz_steps


def known_name(given: object) -> object:
    """Name in the table of materials; an unknown name is refused with similar names."""
    if not isinstance(given, str):
        return given
    plain = plain_name(given)
    if plain in NAMES:
        return NAMES[plain]
    if plain in map(plain_name, ELASTOMERS):
        raise PydanticCustomError("elastomer", "elastomer")
    for each, candidates in SEVERAL.items():
        if plain == plain_name(each):
            said = {"candidates": ", ".join(candidates) or "-"}
            raise PydanticCustomError("several_materials", "several_materials", said)
    groups = (
        f"{title}: {', '.join(each.name for each in MATERIALS.values() if each.group == group)}"
        for group, title in GROUPS.items()
    )
    aliases = ", ".join(alias for names in ALIASES.values() for alias in names)
    values = ", ".join(
        ("youngs_modulus_GPa", "poissons_ratio", "yield_strength_MPa", "allowable_pressure_MPa")
    )
    said = {"values": values, "materials": "; ".join(groups), "aliases": aliases}
    raise PydanticCustomError("unknown_material", "unknown_material", said)


def whole_name(given: object) -> object:
    """Name in the table of a material with all elastic data; others have to be given by values."""
    name = known_name(given)
    if isinstance(name, str):
        _refuse_missing(MATERIALS[name])
    return name


def _refuse_missing(entry: TableMaterial, given: Collection[str] = ()) -> None:
    for missing in entry.missing:
        field = {"youngs_modulus": "youngs_modulus_GPa"}.get(missing, missing)
        if field not in given:
            raise field_error(field, "not_sourced", material=entry.name)


if TYPE_CHECKING:
    MaterialName = str
    WholeName = str
else:
    MaterialName = Annotated[Literal[tuple(MATERIALS)], BeforeValidator(known_name)]
    WholeName = Annotated[
        Literal[tuple(name for name, each in MATERIALS.items() if not each.missing)],
        BeforeValidator(whole_name),
    ]


def _values_schema(schema: dict[str, Any], model: type[RequestModel]) -> None:
    """JSON schema of a material by values, which needs a name or both elastic constants."""
    request_schema(schema, model)
    needed = (["name"], ["youngs_modulus_GPa", "poissons_ratio"])
    schema["anyOf"] = [{"required": names} for names in needed]


class MaterialFields(RequestModel, group="material"):
    """Material by its values; with a name, values not given come from the table."""

    model_config = ConfigDict(json_schema_extra=_values_schema)

    yield_strength_MPa: Maybe[Size] = quantity("Yield strength", "R_e", step=10)
    """Yield strength, by which bending or yield below the surface is judged. Printed parts need the
    value of the filament's data sheet for the direction in which the layers are loaded."""
    tensile_strength_MPa: Maybe[Size] = quantity("Tensile strength", "R_m", step=10)
    """Tensile strength, by which fatigue is judged. Plastics are judged by the smaller of yield and
    tensile strength."""
    name: Maybe[MaterialName] = quantity("Otherwise as", "")
    """Name in the table of materials, from which values that are not given are taken."""
    youngs_modulus_GPa: Maybe[Size] = quantity("Young's modulus", "E", step=1)
    """Young's modulus of the material; a material below 20 GPa counts as a plastic."""
    poissons_ratio: Maybe[float] = quantity("Poisson's ratio", "ν", step=0.01, ge=0, lt=0.5)
    """Lateral strain over the strain along a tension; 0.35 to 0.4 is usual for plastics."""
    allowable_pressure_MPa: Maybe[Size] = quantity("Allowable pressure", "p_all", step=10)
    """Allowable contact pressure, by which this body is judged. Plastics need a value from a
    test."""
    layers: Maybe[Layers] = quantity("Layers of the print", advanced=True)
    """Orientation of the layers of a printed part: flat, across the axis of the pins, or upright,
    along it. Strengths have to be those of the loaded direction, across the layers if these are
    upright."""
    long_term_factor: Maybe[float] = quantity(
        "Long-term factor", "k_lt", step=0.05, ge=0.01, le=1, advanced=True
    )
    """Long-term strength of a plastic over its strength in a short test, from a test of your
    own."""
    life_curve: Maybe[LifeCurve] = quantity("Life curve")
    """Curve by which the allowable pressure falls over the life, for designs with a speed: that of
    through- or case-hardened steel, of nitrided steel and cast iron, or of nitrocarburised
    steel."""

    @model_validator(mode="after")
    def _named_or_elastic(self) -> Self:
        if self.base is not NOT_LISTED:
            _refuse_missing(self.base, self.given)
            return self
        pair = ("youngs_modulus_GPa", "poissons_ratio")
        missing = [name for name in pair if name not in self.given]
        if len(missing) == 2:
            raise field_error(missing[0], "needed", field="name")
        if missing:
            raise field_error(missing[0], "missing")
        return self

    @property
    def base(self) -> TableMaterial:
        """Material of the table that supplies values that are not given."""
        return MATERIALS.get(self.name or "", NOT_LISTED)

    def material(self) -> ElasticMaterial:
        """The material in SI units."""
        own = self.to_core()
        own.pop("name", None)
        pressure, curve = own.pop("allowable_pressure", None), own.pop("life_curve", None)
        limit = None if pressure is None else ContactLimit("given", pressure, curve=curve)
        return by_values(base=self.base, limit=limit, **own)


def material_of(given: str | MaterialFields) -> ElasticMaterial:
    """Material in SI units, by a name of the table or by values."""
    return MATERIALS[given].material if isinstance(given, str) else given.material()


def entry_of(given: str | MaterialFields) -> TableMaterial:
    """Entry of the table that a material names."""
    return MATERIALS[given] if isinstance(given, str) else given.base


def _kind(given: object) -> str:
    """Given form of a material, so that errors speak of this form only."""
    return "by_name" if isinstance(given, str) else "by_values"


Material = Annotated[
    Annotated[WholeName, Tag("by_name")] | Annotated[MaterialFields, Tag("by_values")],
    Discriminator(_kind),
]


UNION_TAGS.update(("by_name", "by_values"))

JSON_FORMS[ElasticMaterial] = JsonForm(Material, material_of)


def of_load_factor(factor: float | None) -> tuple[Notice, ...]:
    """Notice of a load factor below 1, which reduces the load."""
    return (Notice("load_factor_below_one", {"factor": factor}),) if (factor or 1.0) < 1 else ()


class ContactFields(
    SectionFields,
    of=Contact,
    only=("contact_length", "pin_radius", "hole_radius", "pin_material", "hole_material"),
    group="contact",
):
    """Pin and hole: sizes and materials."""

    pin_material: Material = "steel_bearing"
    hole_material: Material = "steel_through_hardened"

    def limits(self) -> list[tuple[str, float]]:
        """Body and limit of its pressure, Pa, for each body of known limit."""
        bodies = (("pin", self.pin_material), ("hole", self.hole_material))
        limits = present({body: material_of(given).limit for body, given in bodies})
        return [(body, float(limit.pressure)) for body, limit in limits.items()]

    def material_notices(self) -> tuple[Notice, ...]:
        """Notices of values that the name of a material leaves open."""
        given = (self.pin_material, self.hole_material)
        cast = (Notice("sand_cast"),) if "bronze_tin" in given else ()
        entries = dict.fromkeys(entry_of(each) for each in given)
        weak = (entry.name for entry in entries if entry.reference)
        return cast + tuple(Notice("one_source", {"material": name}) for name in weak)


MAX_FORCE_N = 1e50
"""Upper bound of any peak force: 1e12 N*m at a ratio of 1e9 and 1e-12 mm make 1e36 N, and peaks
some 1e12 times larger are refused as dead centres."""


class HertzRequest(
    WorkedFields,
    ContactFields,
    of=Contact,
    only=("contact_length", "pin_radius", "hole_radius", "distribution_factor"),
    needs=("contact_length", "pin_radius", "hole_radius"),
    group="contact",
):
    """Pin, hole and the force between them."""

    dynamic_factor: Size = quantity("Application factor", "K_A", default=1.0, step=0.05)
    """Factor on the force for the dynamic load."""
    distribution_factor: Size = 1.0
    force_N: float = quantity("Contact force", "F", step=100, ge=0, le=MAX_FORCE_N)
    """Force between pin and hole."""

    _force_size = field_validator("force_N")(no_dust)

    def notices(self) -> tuple[Notice, ...]:
        """Notices, also of a dynamic factor below 1."""
        return super().notices() + of_load_factor(self.dynamic_factor)

    def cost(self) -> float:
        """Nearly 0, as one contact takes a few formulas."""
        return 0.0

    @property
    def pressed(self) -> dict[str, Any]:
        """Contact as the core's arguments."""
        return {
            "force": self.force_N,
            "contact_length": to_si("contact_length_mm", self.contact_length_mm),
            "pin_radius": to_si("pin_radius_mm", self.pin_radius_mm),
            "hole_radius": to_si("hole_radius_mm", self.hole_radius_mm),
            "pin_material": material_of(self.pin_material),
            "hole_material": material_of(self.hole_material),
            "dynamic_factor": self.dynamic_factor,
            "distribution_factor": self.distribution_factor,
        }

    def solve(self) -> HertzContact:
        """Contact under the force."""
        return hertz(**self.pressed)

    def steps(self) -> Steps:
        """Worked steps of the contact."""
        return {"hertz": hertz_steps(found=self.solve(), **self.pressed)}


class LifeOut(ResponseModel, of=LimitLife):
    """Fall of the pressure limit over the life: (N_k/N_L)^m, at most Z_m."""


class SafetyOut(ResponseModel, of=BodySafety):
    """One body judged by the limit of its own material under the governing pressure."""

    limit_MPa: float = result("Limit of the pressure.", symbol="p_P")
    criterion: Criterion = result("Kind of damage that the limit guards against.")
    source: Maybe[str] = result(
        "Source of the limit, in English; absent if the request gives the limit."
    )
    source_code: Maybe[str] = result("Source of the limit, by code.")
    life: Maybe[LifeOut] = Field(
        description="Fall of the limit over the life, by 1e10 loads if no speed is given; absent "
        "if no curve is known."
    )

    @classmethod
    def values(
        cls, result: BodySafety, run_time_us: float | None = None, **given: object
    ) -> Values:
        """Values of the core's judgement."""
        judged = _judged_by(result.body, result.limit)
        return judged | {"safety_factor": result.safety_factor, **given}


@lru_cache(maxsize=256)
def _judged_by(body: str, limit: ContactLimit) -> Values:
    """Values of a body and its limit, independent of the pressure."""
    life = if_known(lambda: limit.life)
    values = {
        "body": body,
        "limit_MPa": from_si("limit_MPa", limit.pressure),
        "criterion": limit.criterion,
        "source": LIMIT_SOURCES.get(limit.source),
        "source_code": limit.source or None,
        "life": life and LifeOut.values(life),
    }
    return present(values)


class HertzResponse(AssumingResponse, of=HertzContact):
    """Stress of the line contact of pin and hole."""

    safety: Maybe[list[SafetyOut]]

    @classmethod
    def values(
        cls, result: HertzContact, run_time_us: float | None = None, **given: object
    ) -> Values:
        """Values of the core's contact."""
        values = super().values(result, run_time_us, **given)
        if not result.safety:
            del values["safety"]
        return values


def solve(body: HertzRequest) -> Values:
    """Hertz stress of pin and hole, its validity, and the conformal pressure if it applies."""
    answer = HertzResponse.values(*timed(body.solve))
    notices = body.material_notices()
    if notices:
        answer["warnings"] = [*answer.get("warnings", ()), *map(warning, notices)]
    return answer


def figure(body: HertzRequest, theme: Theme = "light") -> Figure:
    """Pressure across the contact as a Plotly figure, ready for Plotly.js."""
    contact, chart = body.solve(), Chart(theme, height=300)
    chart.axis("x", "along_arc", "mm")
    chart.axis("y", "contact_pressure", "MPa", rangemode="tozero")
    profiles = {"hertz": pressure_profile(contact=contact)}
    if contact.is_conformal:
        profiles["conformal"] = conformal_profile(contact=contact)
    shown = {"pressure": Amount("%{y:.5g}", "MPa"), "place": Amount("%{x:.4g}", "mm")}
    for index, (name, (places, pressures)) in enumerate(profiles.items()):
        x, y = from_si("place_mm", places), from_si("pressure_MPa", pressures)
        chart.curve(name, x, y, index, text("pressure_hover", name=text(name), **shown))
    highest = max(float(pressures.max()) for _, pressures in profiles.values())
    widest = from_si("place_mm", max(float(places[-1]) for places, _ in profiles.values()))
    for (name, limit), dash in zip(body.limits(), ("longdash", "dot"), strict=False):
        if limit <= 4 * highest:
            words, of = {"body": text(name)}, [from_si("limit_MPa", limit)] * 2
            hovered = text("body_limit_hover", pressure=shown["pressure"], **words)
            line = {"color": chart.ink["alert"], "dash": dash, "width": 1.5}
            chart.curve(text("body_limit", **words), [-widest, widest], of, 0, hovered, line=line)
    return chart.figure


CALCULATION = Calculation(
    name="hertz",
    title="Hertz contact of pin and hole",
    tag="crank-planetary",
    request=HertzRequest,
    answer=HertzResponse,
    solve=solve,
    figure=figure,
    sources=(YANCHEVSKY_2018, PERSSON_1964, JOHNSON_1985),
    neglects=("edge_pressure", "friction", "misalignment"),
)
