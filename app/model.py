"""Common base of requests and answers: strictness, units, accuracy, warnings."""

import math
import re
import time
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cache, cached_property, partial, reduce
from importlib.util import find_spec
from itertools import chain
from operator import or_
from types import NoneType
from typing import (
    Annotated,
    Any,
    ClassVar,
    Literal,
    NamedTuple,
    Protocol,
    Self,
    TypeVar,
    cast,
    get_args,
    get_origin,
)

from pydantic import (
    BaseModel,
    BeforeValidator,
    ConfigDict,
    Field,
    GetCoreSchemaHandler,
    model_validator,
)
from pydantic.fields import FieldInfo
from pydantic_core import CoreSchema, PydanticCustomError

from app.rules import (
    BROKEN,
    Forms,
    Kinds,
    Rule,
    alternatives,
    between,
    field_error,
    of_other_kinds,
    schema_rules,
    wrong_form,
)
from app.settings import Settings
from app.units import (
    Convert,
    api_params,
    core_name,
    from_si,
    from_si_converter,
    register,
    shown_unit,
    to_si_converter,
)
from app.worked import Steps, worked
from core.arrays import FloatArray
from core.codes import WARNINGS, WAS
from core.errors import METHODS, Accuracy, Notice, NotKnown, within
from core.fields import LARGEST as LARGEST
from core.fields import SMALLEST, quantities_of
from core.hertz import Spread

Size = Annotated[float, Field(ge=SMALLEST, le=LARGEST)]
"""Positive physical quantity in its unit."""

Angle = Annotated[float, Field(ge=-3600, le=3600)]
"""Angle in degrees, of up to ten turns."""


def no_dust(value: Any) -> Any:
    """Validator of quantities that may be 0 or negative: refuse tiny values, which lose digits."""
    if isinstance(value, list):
        return [*map(no_dust, value)]
    if 0 < abs(value) < SMALLEST:
        raise PydanticCustomError("dust", "dust", {"limit": SMALLEST})
    return value


NO_DUST: dict[str, Any] = {
    "anyOf": [{"const": 0}, {"minimum": SMALLEST}, {"maximum": -SMALLEST}],
}
"""Values that `no_dust` accepts, for a field's JSON schema."""


class _NotNull:
    """Mark of a field that may be absent, but is never null."""

    def __get_pydantic_core_schema__(
        self, source: Any, handler: GetCoreSchemaHandler
    ) -> CoreSchema:
        schema: Any = handler(source)
        inner: CoreSchema = schema["schema"] if schema["type"] == "nullable" else schema
        return inner


Present = TypeVar("Present")
Maybe = Annotated[Present | None, _NotNull(), Field(default=None)]
"""Value that may be absent: None in Python, by default, and no null in JSON."""


def whole(value: Any) -> Any:
    """Whole number as an integer, if it is written as 3.0; other values are unchanged."""
    return int(value) if isinstance(value, float) and value.is_integer() else value


Whole = Annotated[int, BeforeValidator(whole)]
"""Whole number, as 3 or as 3.0, as other programs write it."""


MAX_NAME = 64
"""Longest name in a pointer; longer names are cut."""


def pointer(path: Iterable[str | int]) -> str:
    """JSON pointer (RFC 6901) of a path, with long names cut."""
    return "".join(map(_token, path))


def _token(part: str | int) -> str:
    name = str(part)
    cut = name if len(name) <= MAX_NAME else name[: MAX_NAME - 1] + "…"
    return "/" + cut.replace("~", "~0").replace("/", "~1")


UNION_TAGS: set[str] = set()
"""Names of the branches of a field's unions, which are no fields; pydantic puts them into error
paths."""


def _complete_schema(schema: dict[str, Any]) -> None:
    """Complete a JSON schema: units by names, descriptions in one line, no null defaults."""
    for name, field in schema.get("properties", {}).items():
        if "description" in field:
            field["description"] = " ".join(field["description"].split())
        if unit := shown_unit(name):
            field["x-unit"] = unit
        if field.get("default", ...) is None:
            del field["default"]
        for ours, theirs in (("ge", "minimum"), ("le", "maximum")):  # left in by whole numbers
            if ours in field:
                field[theirs] = field.pop(ours)


def request_schema(schema: dict[str, Any], model: type["RequestModel"]) -> None:
    """Complete the schema of a request with units, with rules between its fields, and with the
    fields of sections that the request needs.
    """
    _complete_schema(schema)
    if model.NEEDS:
        schema["x-needs"] = ["/" + path for path in model.NEEDS]
    if rules := schema_rules(model):
        schema["allOf"] = rules


class RequestModel(BaseModel):
    """A request with numbers only, finite only, and no unknown fields.

    The text below a field is its help. `group` names the form group of the fields of a class,
    except for fields that name another group.
    """

    model_config = ConfigDict(
        extra="forbid",
        strict=True,
        allow_inf_nan=False,
        use_attribute_docstrings=True,
        json_schema_extra=request_schema,
    )

    ALTERNATIVES: ClassVar[tuple[Forms, ...]] = ()
    """Forms of which exactly one has to be given, as names in JSON; an empty form makes all
    optional."""

    KIND: ClassVar[str] = "kind"
    """Field that states the kind of the model."""

    OF_OTHERS: ClassVar[tuple[str, str]] = ("of_another_kind", "kind")
    """Error code of a field of another kind, and the parameter that names the given kind."""

    KINDS: ClassVar[Kinds] = {}
    """Fields by kind, with None for no kind; fields in no kind belong to all kinds."""

    NEEDS: ClassVar[tuple[str, ...]] = ()
    """Paths of optional fields that have to be given, such as ``load/input_speed_rpm``."""

    BETWEEN: ClassVar[tuple[Rule, ...]] = ()
    """Rules between fields. The JSON schema has those between own fields, but not those that reach
    into nested models."""

    RULES: ClassVar[tuple[dict[str, Any], ...]] = ()
    """Further rules of the JSON schema, which a validator checks too."""

    CONVERTERS: ClassVar[Mapping[str, Convert]] = {}
    """Conversions of fields to the core that are no change of a unit."""

    def __init_subclass__(cls, *, group: str | None = None, **config: Any) -> None:
        super().__init_subclass__(**config)
        for name, field in vars(cls).items():
            shown = field.json_schema_extra if isinstance(field, FieldInfo) else None
            if isinstance(shown, dict) and "x-symbol" in shown and "x-group" not in shown:
                if group is None:
                    raise TypeError(f"{cls.__name__}.{name} belongs to no group")
                shown["x-group"] = group

    @classmethod
    def __pydantic_init_subclass__(cls, **_: Any) -> None:
        register(cls)

    @cached_property
    def given_paths(self) -> frozenset[tuple[str, ...]]:
        """Paths of the fields that have a value, also in models within."""
        found, fields = list[tuple[str, ...]](), type(self).model_fields
        for name, value in self.given.items():
            found.append((fields[name].alias or name,))
            if isinstance(value, RequestModel):
                found += [(name, *path) for path in value.given_paths]
        return frozenset(found)

    def path_of(self, parameter: str) -> tuple[str | int, ...]:
        """Path of the field of a core parameter, as ``rollers[2].z_max``; empty without a field. A
        name without its section stands for a field of a given section, the first given one if any.
        """
        parts = re.findall(r"[^.\[\]]+", parameter)
        own = [part for part in parts if not part.isdigit()]
        paths = [
            each
            for each in core_paths(type(self)).get(".".join(own), ())
            if len(each) == len(own) or each[: -len(own)] in self.given_paths
        ]
        if not paths:
            return ()
        path = next((each for each in paths if each in self.given_paths), paths[0])
        if len(own) == len(parts):
            return path
        above = len(path) - len(own)
        names = iter(path[above:])
        return (*path[:above], *(int(part) if part.isdigit() else next(names) for part in parts))

    @model_validator(mode="after")
    def _one_form_and_kind(self) -> Self:
        if choices := alternatives(type(self)):
            named = self.model_fields_set
            for forms, fields, allowed in choices:
                if fields & named not in allowed:
                    raise wrong_form(type(self), forms, named)
        if self.KINDS:
            self._refuse_other_kinds()
        for field, rule, other in between(type(self)):
            of_field, of_other = BROKEN[rule]
            if self.says(other) == of_other and self.says(field) == of_field:
                raise field_error(field, rule, field=other.rpartition("/")[2])
        return self

    def _refuse_other_kinds(self) -> None:
        kind = getattr(self, self.KIND)
        given = self.given
        for name in self.KINDS[kind][0]:
            if name not in given:
                raise field_error(name, "needed_beside", field=self.KIND)
        code, named = self.OF_OTHERS
        for name in of_other_kinds(type(self), kind):
            if name in given:
                raise field_error(name, code, **{named: kind or "none"})

    def says(self, path: str) -> bool:
        """True if the field at a path, names separated by ``/``, is given."""
        name, _, within = path.partition("/")
        named = name in self.model_fields_set
        return named and (not within or getattr(self, name).says(within))

    @cached_property
    def given(self) -> "Mapping[str, Any]":
        """Fields that have a value, by their names."""
        own = vars(self)  # cached properties are in it too
        return {name: value for name in _core_plan(type(self)) if (value := own[name]) is not None}

    def model_copy(self, *, update: "Mapping[str, Any] | None" = None, deep: bool = False) -> Self:
        """Copy with other fields, without cached values of the former ones."""
        copy = super().model_copy(update=update, deep=deep)
        copy._forget()
        return copy

    def __setattr__(self, name: str, value: Any) -> None:
        super().__setattr__(name, value)
        if name in type(self).model_fields:
            self._forget()

    def _forget(self) -> None:
        own = vars(self)
        for name in own.keys() - type(self).model_fields.keys():
            del own[name]

    def to_core(self) -> dict[str, Any]:
        """Given fields as the core's arguments, in SI units."""
        plan = _core_plan(type(self))
        return {plan[name].core: plan[name].convert(value) for name, value in self.given.items()}

    @property
    def not_used(self) -> list[str]:
        """Given sections that the calculation does not use."""
        return []

    ASSUMED: ClassVar[tuple[str, ...]] = ()
    """Fields whose default decides about the answer, which states the default if they are not
    given."""

    def assumed(self) -> Iterator[tuple[tuple[str, ...], Any]]:
        """Path and value of each field that is assumed, as it is not given."""
        for name in self.ASSUMED:
            if name in self.given and name not in self.model_fields_set:
                yield (name,), self.given[name]
        for name, value in self.given.items():
            if isinstance(value, (RequestModel, list)):
                for place, part in _parts(value):
                    yield from (((name, *place, *path), inner) for path, inner in part.assumed())

    def without(self, path: tuple[str, ...]) -> "Values":
        """Values of the answer without an assumption, if they are quickly calculated."""
        return {}

    def notices(self) -> tuple[Notice, ...]:
        """Notices of inputs that are interpreted differently from their typed form."""
        parts = (each for each in self.given.values() if isinstance(each, RequestModel))
        return tuple(chain.from_iterable(each.notices() for each in parts))

    def steps(self) -> Steps | None:
        """Worked steps by section of the answer; None if its calculation has none."""
        return None

    def cost(self) -> float:
        """Number of calculated points, compared with `app.endpoint.LIGHT_COST`; infinite for
        searches and solutions, which always leave the event loop.
        """
        return math.inf

    def refuse_beyond(self, settings: Settings) -> None:
        """Raise `InvalidInput` if the request exceeds the operator's limits."""


def _parts(value: Any) -> Iterator[tuple[tuple[str, ...], RequestModel]]:
    """Models in a value, itself or in a list, with their places."""
    if isinstance(value, RequestModel):
        yield (), value
    elif isinstance(value, list):
        for index, each in enumerate(value):
            yield from (((str(index), *place), part) for place, part in _parts(each))


class _InCore(NamedTuple):
    """Conversion of a field to the core."""

    core: str  # name in the core
    convert: Convert  # conversion of values to SI units


@cache
def _core_plan(model: type[RequestModel]) -> dict[str, _InCore]:
    """Conversion of the fields of a request to the core, by field."""
    plan = {}
    for name, field in model.model_fields.items():
        part = any(hasattr(held, "section") for held in _held(field.annotation))
        made = model.CONVERTERS.get(name) or (_section if part else None)
        core = core_name(name)
        plan[name] = _InCore(core, _within(core, made) if made else to_si_converter(name))
    return plan


@cache
def core_names(model: type[RequestModel]) -> dict[str, str]:
    """Names in core of the fields of a request."""
    return {name: each.core for name, each in _core_plan(model).items()}


def _within(core: str, make: Convert) -> Convert:
    """Conversion to a part of core, whose refusals name its place."""
    return lambda value: within(core, partial(make, value))


def _section(part: Any) -> Any:
    if not isinstance(part, list):
        return part.section()
    return tuple(within(f"[{n}]", partial(_section, each)) for n, each in enumerate(part))


def quantity(
    title: str,
    symbol: str = "",
    *,
    group: str | None = None,
    help: str | None = None,
    step: float | None = None,
    advanced: bool = False,
    schema: dict[str, Any] | None = None,
    **limits: Any,
) -> Any:
    """Field with its data for the form; the unit follows from its name.

    Parameters
    ----------
    title, symbol : str
        Name and symbol, as engineers write them.
    group : str, optional
        Form group of the field, if it differs from that of its class.
    help : str, optional
        Meaning in one sentence, if no text below the field states it.
    step : float, optional
        Change by the arrow keys.
    advanced : bool
        True if the form may hide it.
    schema : dict, optional
        Further JSON schema, if validators do more than limits.
    **limits
        Default and limits, as pydantic's `Field` takes them.
    """
    shown = {"symbol": symbol, "group": group, "step": step, "advanced": advanced or None}
    extra = {f"x-{key}": value for key, value in present(shown).items()}
    return Field(
        title=title,
        description=help,
        json_schema_extra=cast(Any, extra | (schema or {})),
        **limits,
    )


def result(meaning: str, *, symbol: str = "", equation: str = "") -> Any:
    """Field of an answer with its meaning in one sentence; the unit follows from its name.

    `symbol` is that of the nomenclature, `equation` the source with its equation number.
    """
    shown = {"x-symbol": symbol, "x-equation": equation}
    extra = {key: value for key, value in shown.items() if value}
    return Field(description=meaning, json_schema_extra=cast(Any, extra))


class WorkedFields(RequestModel):
    """A request that can ask for worked steps."""

    include: list[Literal["worked"]] = Field(
        default=[],
        max_length=1,
        description="Optional results; only those that are named are computed.",
    )


@cache
def core_paths(model: type[RequestModel]) -> dict[str, list[tuple[str, ...]]]:
    """Paths of the fields of a request, also in models within, by the names of their parameters in
    core, with and without the sections around them.
    """
    plan, found = _core_plan(model), dict[str, list[tuple[str, ...]]]()
    for name, (core, _) in plan.items():
        found.setdefault(core, [(model.model_fields[name].alias or name,)])
    own = found.copy()
    for name, (core, _) in plan.items():
        for held in _held(model.model_fields[name].annotation):
            for parameter, paths in core_paths(held).items():
                within = [(name, *path) for path in paths]
                found.setdefault(f"{core}.{parameter}", []).extend(within)
                if parameter not in own:
                    found.setdefault(parameter, []).extend(within)
    return found


def _held(annotation: Any) -> list[type[RequestModel]]:
    """Models that an annotation allows, alone or in lists."""
    if isinstance(annotation, type) and issubclass(annotation, RequestModel):
        return [annotation]
    return [model for each in get_args(annotation) for model in _held(each)]


Values = dict[str, Any]
"""Answer or part of it as it is sent: present values by the names of its model."""


def present(values: Mapping[str, Any]) -> Values:
    """Values that are not None."""
    return {name: value for name, value in values.items() if value is not None}


OPTIONAL: Any = Maybe
LIST: Any = list
"""Generic types of annotations that are made at import."""


class ResponseModel(BaseModel):
    """Description of an answer, whose values are read from a core result by names without units.

    A subclass names its dataclass of core as `of`. It has the quantities of that (`core.fields`)
    but those in `without`, or of those alone in `only`, and adds what core does not know. An
    annotation of a quantity changes its type, a value what it says.
    """

    model_config = ConfigDict(json_schema_extra=_complete_schema, allow_inf_nan=False)

    BESIDE: ClassVar[tuple[str, ...]] = ()
    """Fields that are not attributes of the result: given beside it, or absent."""

    def __init_subclass__(
        cls,
        *,
        of: Any = None,
        only: Collection[str] = (),
        without: Collection[str] = (),
        **config: Any,
    ) -> None:
        if of is not None:
            ANSWERS.setdefault(of, cls)
            _give_quantities(cls, of, only, without)
        super().__init_subclass__(**config)

    @classmethod
    def __pydantic_init_subclass__(cls, **_: Any) -> None:
        register(cls)

    @classmethod
    def values(cls, result: Any, run_time_us: float | None = None, **given: Any) -> Values:
        """Values of an answer from a core result, without unknown ones; arrays stay arrays.

        Parameters
        ----------
        result : object
            Core result, SI, with attributes named as the fields without units.
        run_time_us : float, optional
            Run time of the calculation, for `accuracy`.
        **given
            Fields that replace those of the result; absent if None.
        """
        values, plan = present(given), _plan(cls, *given)
        for name, attribute, convert, needed in plan.read:
            try:
                value = getattr(result, attribute)
            except NotKnown:
                if needed:
                    raise
                continue
            if value is not None:
                values[name] = convert(value)
        if plan.warns and result.notices:
            values["warnings"] = [warning(each) for each in result.notices]
        if plan.states_accuracy:
            values["accuracy"] = accuracy_values(result.accuracy, run_time_us or 0.0)
        return values


ANSWERS: dict[Any, type[ResponseModel]] = {}
"""Model of the answer, or the first one, by dataclass of core."""


def _give_quantities(cls: Any, kind: Any, only: Collection[str], without: Collection[str]) -> None:
    """Give a model the quantities of a dataclass that it does not inherit."""
    made: dict[str, Any] = {}
    last: dict[str, Any] = {}
    for core, about, hint, meaning in quantities_of(kind):
        name = f"{core}_{about.unit}".removesuffix("_")
        if name in cls.model_fields or core in without or (only and core not in only):
            continue
        if hint is Accuracy:
            last[name] = AccuracyOut
        elif name == "notices":
            last["warnings"] = OPTIONAL[list[WarningOut]]
        else:
            made[name] = _in_json(hint, about.depth)
            if about.optional:
                made[name] = OPTIONAL[made[name]]
            if meaning and name not in vars(cls):
                shown = {"symbol": about.symbol, "equation": about.equation}
                setattr(cls, name, result(meaning, **shown))
    cls.__annotations__ = made | cls.__annotations__ | last


def _in_json(hint: Any, depth: int) -> Any:
    """Type in answers of a type of core; arrays have `depth` axes."""
    inner = get_args(hint)
    if NoneType in inner:
        return OPTIONAL[
            _in_json(reduce(or_, (each for each in inner if each is not NoneType)), depth)
        ]
    if hint == FloatArray:
        return LIST[_in_json(FloatArray, depth - 1)] if depth else float
    if get_origin(hint) is list or inner[1:] == (...,):
        return LIST[_in_json(inner[0], depth)]
    if hint.__module__.startswith("core.") and hint not in ANSWERS:
        raise TypeError(
            f"the model of {hint.__name__} is made after that of an answer which has it"
        )
    return float if hint is Any else ANSWERS.get(hint, hint)


def _leave_to_checks(values: Values, checks: list[Values]) -> None:
    """Remove warnings from an answer and its sections that its checks state."""
    said = {each["code"] for each in checks}
    said |= {each["reason"]["code"] for each in checks if "reason" in each}
    for part in (values, *values.values()):
        if isinstance(part, dict) and "warnings" in part:
            kept = [each for each in part.pop("warnings") if each["code"] not in said]
            part |= {"warnings": kept} if kept else {}


class Report(Protocol):
    """Function that is told the progress of a study, from 0 to 1, and what is found at once."""

    def __call__(self, share: float, **found: Values) -> None:
        """Tell it."""


def untold(share: float, **found: Values) -> None:
    """Progress report that nobody receives."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Calculation:
    """Calculation as the service offers it; `app.registry` lists all of them."""

    # Path below the API's prefix, and name in batches, studies and examples.
    name: str
    title: str  # name for users
    tag: str  # chapter in the API's description
    request: Any  # model of the request, or an annotated union of models
    answer: type["ResponseModel"]  # model that describes the answer
    solve: Callable[[Any], Values]  # module function: values of the answer to a request
    # Module function: Plotly figure of a request and a theme.
    figure: Callable[[Any, Any], dict[str, Any]] | None = None
    sources: tuple[str, ...] = ()  # sources of its formulas
    # Effects left out even with all sections given, keys of `app.registry.NEGLECTED`.
    neglects: tuple[str, ...] = ()
    batched: bool = True  # True if batches take it

    def solved(self, body: Any, report: Report) -> Values:
        """Values of the answer to a request, without assumptions and notices."""
        return self.solve(body)

    def answered(self, body: Any, report: Report = untold) -> Values:
        """Values of the answer to a request, with assumptions and notices of the input.

        `report` is told the progress of a study, from 0 to 1.
        """
        values = self.solved(body, report)
        if not_used := body.not_used:
            values["not_used"] = not_used
        if assumed := [
            {"pointer": "/" + "/".join(path), **_taken(path[-1], value), **body.without(path)}
            for path, value in body.assumed()
        ]:
            values["assumed"] = assumed
        asked = "worked" in (getattr(body, "include", None) or ())
        if asked and (steps := body.steps()) is not None:
            values["worked"] = worked(steps)
        warned(values, *body.notices())
        if checks := values.get("checks"):
            _leave_to_checks(values, checks)
        return values


@dataclass(frozen=True, slots=True, kw_only=True)
class StudyCalculation(Calculation):
    """Calculation that may take long and reports its progress."""

    reporting: Callable[[Any, Report], Values]  # function `solve` with a progress report

    def solved(self, body: Any, report: Report) -> Values:
        """Values of the answer to a request; progress is reported."""
        return self.reporting(body, report)


class File(NamedTuple):
    """A file that is answered."""

    name: str
    media_type: str
    content: bytes


@dataclass(frozen=True, slots=True, kw_only=True)
class Export:
    """Files of a design as the service offers them; `app.registry` lists all of them."""

    name: str  # path below the API's prefix
    title: str  # name for users
    request: type["RequestModel"]  # model of the request
    write: Callable[[Any], File]  # module function: file of a request
    media_types: tuple[str, ...]  # media types of the files
    extra: str = ""  # extra of the installation that they need; they take as long as a study then
    module: str = ""  # module that the extra brings
    instead: str = ""  # name of the export that needs no extra
    # Module function: a file in the last media type, for requests that accept it; that needs the
    # extra, and the file as it is written does not.
    convert: Callable[[File], File] | None = None

    @property
    def answered(self) -> tuple[str, ...]:
        """Media types that the service answers, as it has the extra that the others need."""
        if not self.module or find_spec(self.module) is not None:
            return self.media_types
        return self.media_types[:-1] if self.convert else ()

    def converts(self, accept: str) -> bool:
        """True if a request with this `Accept` is answered in the last media type."""
        return self.convert is not None and self.media_types[-1] in accept

    def file(self, body: Any, *, converted: bool) -> File:
        """File of a request, in the last media type if `converted`."""
        written = self.write(body)
        return self.convert(written) if converted and self.convert else written


class _Plan(NamedTuple):
    """Conversion of a core result to an answer."""

    read: list[tuple[str, str, Convert, bool]]
    """Name, core name, conversion of the value, and True if the value is required."""
    warns: bool
    states_accuracy: bool


BESIDE_RESULTS = ("accuracy", "warnings", "assumed", "not_used", "worked")
"""Fields of an answer that no core result has by that name."""


@cache
def _plan(model: type[ResponseModel], *given: str) -> _Plan:
    fields = model.model_fields
    return _Plan(
        [
            (
                name,
                core_name(name),
                _inner_values(field.annotation) or from_si_converter(name),
                field.is_required(),
            )
            for name, field in fields.items()
            if name not in (*BESIDE_RESULTS, *model.BESIDE, *given)
        ],
        "warnings" in fields,
        "accuracy" in fields,
    )


def _inner_values(annotation: Any) -> Convert | None:
    """Values of the answer that a field holds, alone or in a list, if it holds one."""
    if isinstance(annotation, type) and issubclass(annotation, ResponseModel):
        return annotation.values
    one = next(filter(None, map(_inner_values, get_args(annotation))), None)
    if one is not None and get_origin(annotation) is list:
        return lambda values: [*map(one, values)]
    return one


class AccuracyOut(BaseModel):
    """Method of the numbers, their possible error, and their cost."""

    model_config = ConfigDict(json_schema_extra=_complete_schema)

    method: str = Field(description="Method of calculation, in English.")
    method_code: str = Field(
        description="Method of calculation, by code.", json_schema_extra={"enum": [*METHODS]}
    )
    relative_error: float = Field(
        description="Bound or estimate of the relative error; 1 or more means that nothing is "
        "known."
    )
    evaluations: int = Field(description="Number of evaluations of the method's function.")
    run_time_us: float = Field(description="Run time of the calculation.")


Result = TypeVar("Result")


def timed(calculation: Callable[[], Result]) -> tuple[Result, float]:
    """Result of a calculation and its run time, microseconds to a tenth."""
    start = time.perf_counter_ns()
    result = calculation()
    return result, (time.perf_counter_ns() - start) // 100 / 10


def accuracy_values(accuracy: Accuracy, run_time_us: float) -> Values:
    """Accuracy of a core result with its run time."""
    return {
        "method": METHODS[accuracy.method],
        "method_code": accuracy.method,
        "relative_error": accuracy.relative_error,
        "evaluations": accuracy.evaluations,
        "run_time_us": run_time_us,
    }


class AssumedOut(BaseModel):
    """Important value that was not given."""

    pointer: str = Field(description="JSON pointer to the field.")
    value: float | str | list[float] | dict[str, Any] = Field(
        description="Value that is assumed for the field."
    )
    low: Maybe[float] = Field(
        description="Least value in the sources of a material that disagree; checks are judged "
        "over the whole range."
    )
    high: Maybe[float] = Field(
        description="Largest value in the sources of a material that disagree."
    )
    without: Maybe[dict[str, float]] = Field(
        description="Result without the assumption: for the number of satellites, the peak force "
        "with one satellite by the ideal forces."
    )


class StepOut(BaseModel):
    """Derivation of one number of an answer from others."""

    model_config = ConfigDict(json_schema_extra=_complete_schema)

    section: str = Field(description="Section of the answer to which the step belongs.")
    code: str = Field(
        description="Quantity that is worked out: a field of the section, or an intermediate "
        "value; the code ends in its unit."
    )
    symbol: str = Field(description="Name of the quantity in the formulas of later steps.")
    formula: Maybe[str] = Field(
        default=None,
        description="Formula in infix notation over `names`: + - * / ^ ( ), sqrt sin cos tan asin"
        " acos atan abs min max, pi. It holds in SI units, angles in rad.",
    )
    method: Maybe[str] = Field(
        default=None,
        description="Way in which the value was obtained if there is no formula, by code: "
        "summed, searched, solved, counted or given.",
    )
    names: dict[str, str] = Field(
        description="Quantity behind each name of the formula, or each number that goes into the "
        "method, with its unit at the end."
    )
    values: dict[str, float] = Field(
        description="Value of each name of the formula, in the unit of the quantity."
    )
    result: float = Field(description="Result of the step, in `unit`.")
    unit: str = Field(description="Unit of the result as shown; empty for plain numbers.")
    source: Maybe[str] = Field(default=None, description="Source of the formula, by code.")
    equation: Maybe[str] = Field(default=None, description="Number of the equation in the source.")
    erratum: Maybe[str] = Field(default=None, description="Misprint in the source, by code.")
    note: Maybe[str] = Field(default=None, description="Note on the step, by code.")
    params: Maybe[dict[str, Any]] = Field(
        default=None, description="Names and numbers in the text of `note` or `method`."
    )


class WorkedResponse(ResponseModel):
    """Answer that can have worked steps."""

    worked: Maybe[list[StepOut]] = Field(
        default=None,
        description="Worked steps: derivation of the numbers from each other, if requested; "
        "`GET /words` contains the texts by code.",
    )


class AssumingResponse(WorkedResponse):
    """Answer that states its assumptions."""

    assumed: Maybe[list[AssumedOut]] = Field(
        default=None,
        description="Values that were not given and decide about the answer; absent if all were "
        "given.",
    )


class DocumentResponse(AssumingResponse):
    """Answer to a design document."""

    not_used: Maybe[list[str]] = Field(
        default=None, description="Given sections of the document that this answer does not use."
    )


def notices_of(*results: Any) -> tuple[Notice, ...]:
    """Notices of those core results that are not None; a result may be a notice itself."""
    found: list[Notice] = []
    for each in results:
        if isinstance(each, Notice):
            found.append(each)
        elif each is not None:
            found += each.notices
    return tuple(found)


REPLACED = "Former code that this code replaces, given for one release."


class WarningOut(BaseModel):
    """Limit of validity that the result strains; the number is given all the same."""

    code: str = Field(description="Code of the warning.", json_schema_extra={"enum": [*WARNINGS]})
    params: dict[str, Any] = Field(description="Names and numbers in the text of the warning.")
    detail: str = Field(description="Text of the warning, in English.")
    was: Maybe[str] = Field(default=None, description=REPLACED)


def warned(values: Values, *results: Any) -> Values:
    """Values of an answer, with notices of further results before its warnings."""
    if notices := notices_of(*results):
        values["warnings"] = [*map(warning, notices), *values.get("warnings", ())]
    return values


def _taken(name: str, value: object) -> Values:
    """Assumed value of a field, with its range if sources differ."""
    if not isinstance(value, Spread):
        return {"value": value}
    usual, low, high = from_si(name, value)
    return {"value": usual} | ({"low": low, "high": high} if low < high else {})


def warning(notice: Notice) -> Values:
    """Warning of a core notice, with the API's names in place of the core's."""
    params = api_params(notice.params)
    values = {"code": notice.code, "params": params}
    values["detail"] = WARNINGS[notice.code].text.format(**params)
    if was := WAS["warnings"].get(notice.code):
        values["was"] = was
    return values
