"""What every request and answer shares: strictness, units, accuracy, warnings."""

import math
import re
import time
from abc import abstractmethod
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cache, cached_property, lru_cache
from itertools import chain
from typing import (
    Annotated,
    Any,
    ClassVar,
    Literal,
    NamedTuple,
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
from core.codes import WARNINGS, WAS
from core.errors import METHODS, Accuracy, Notice, NotKnown
from core.hertz import Spread

SMALLEST = 1e-12
LARGEST = 1e12

Size = Annotated[float, Field(ge=SMALLEST, le=LARGEST)]
"""A positive physical quantity, in its unit: within these limits no result leaves the range of
numbers and none loses digits at its lower end."""

RingSize = Annotated[float, Field(ge=SMALLEST, le=1e5)]
"""A size of a ring, mm: up to a hundred metres; the turn of a larger one takes long."""

Angle = Annotated[float, Field(ge=-3600, le=3600)]
"""An angle in degrees, of up to ten turns."""


def no_dust(value: Any) -> Any:
    """Validator of quantities that may be 0 or negative: smaller sizes lose their digits."""
    if isinstance(value, list):
        return [*map(no_dust, value)]
    if 0 < abs(value) < SMALLEST:
        raise PydanticCustomError("dust", "dust", {"limit": SMALLEST})
    return value


NO_DUST: dict[str, Any] = {
    "anyOf": [{"const": 0}, {"minimum": SMALLEST}, {"maximum": -SMALLEST}],
}
"""What `no_dust` takes, for a field's JSON schema."""


class _NotNull:
    """Marks a field that may be absent, but is never null."""

    def __get_pydantic_core_schema__(
        self, source: Any, handler: GetCoreSchemaHandler
    ) -> CoreSchema:
        schema: Any = handler(source)
        inner: CoreSchema = schema["schema"] if schema["type"] == "nullable" else schema
        return inner


Present = TypeVar("Present")
Maybe = Annotated[Present | None, _NotNull(), Field(default=None)]
"""What may be absent: None in Python, which is its default, and no null in JSON."""


def _whole(value: Any) -> Any:
    return int(value) if isinstance(value, float) and value.is_integer() else value


Whole = Annotated[int, BeforeValidator(_whole)]
"""A whole number, as 3 or as 3.0: other programs write it so."""


MAX_NAME = 64
"""Most letters of a name in a pointer; longer ones are cut."""


def pointer(path: Iterable[str | int]) -> str:
    """JSON pointer (RFC 6901) of a path; names that are too long are cut."""
    return "".join(map(_token, path))


def _token(part: str | int) -> str:
    name = str(part)
    cut = name if len(name) <= MAX_NAME else name[: MAX_NAME - 1] + "…"
    return "/" + cut.replace("~", "~0").replace("/", "~1")


UNION_TAGS: set[str] = set()
"""Names of the branches of a field's unions: pydantic puts them into the path of an error; they are
no fields."""


def _complete_schema(schema: dict[str, Any]) -> None:
    """Write each field's unit, which its name ends in, into the JSON schema; its description in one
    line; no default of null.
    """
    for name, field in schema.get("properties", {}).items():
        if "description" in field:
            field["description"] = " ".join(field["description"].split())
        if unit := shown_unit(name):
            field["x-unit"] = unit
        if field.get("default", ...) is None:
            del field["default"]
        for ours, theirs in (("ge", "minimum"), ("le", "maximum")):  # of whole numbers
            if ours in field:
                field[theirs] = field.pop(ours)


def request_schema(schema: dict[str, Any], model: type["RequestModel"]) -> None:
    """The schema of a request: units, and which of its fields exclude or need each other."""
    _complete_schema(schema)
    if rules := schema_rules(model):
        schema["allOf"] = rules


class RequestModel(BaseModel):
    """A request: numbers only, finite only, nothing unknown.

    The text below a field is its help. `group` is the group of the form that the fields of a class
    belong to, but for those that name another.
    """

    model_config = ConfigDict(
        extra="forbid",
        strict=True,
        allow_inf_nan=False,
        use_attribute_docstrings=True,
        json_schema_extra=request_schema,
    )

    ALTERNATIVES: ClassVar[tuple[Forms, ...]] = ()
    """Forms of which just one has to be given, each its names in JSON; an empty one says that none
    need be."""

    KIND: ClassVar[str] = "kind"
    """The field that says of which kind it is."""

    OF_OTHERS: ClassVar[tuple[str, str]] = ("of_another_kind", "kind")
    """Code of what belongs to another one, and its parameter that names the one that is given."""

    KINDS: ClassVar[Kinds] = {}
    """What its kinds have; fields that no kind has are those of all. None: without a kind."""

    BETWEEN: ClassVar[tuple[Rule, ...]] = ()
    """Rules between its fields, which the JSON schema has too, and those that reach into the
    models within, which it has not."""

    RULES: ClassVar[tuple[dict[str, Any], ...]] = ()
    """What its JSON schema says besides, of which a validator says the same."""

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
    def core_paths(self) -> dict[str, tuple[str, ...]]:
        """Path of the field of each core parameter, here or in the models within, the first; by its
        name alone and beneath those of the models that hold it, ``pin.diameter``.
        """
        return core_paths(self.shape)

    def path_of(self, parameter: str) -> tuple[str | int, ...]:
        """Path of the field of a core parameter, ``rollers[2].z_max`` included; empty where it has
        none.
        """
        path = self.core_paths.get(parameter, ())
        if path or "[" not in parameter:
            return path
        parts = re.findall(r"[^.\[\]]+", parameter)
        own = [part for part in parts if not part.isdigit()]
        path = self.core_paths.get(".".join(own), ())
        if not path:
            return path
        above = len(path) - len(own)
        names = iter(path[above:])
        return (*path[:above], *(int(part) if part.isdigit() else next(names) for part in parts))

    @cached_property
    def shape(self) -> "Shape":
        """Its model, and its fields that are given, with the shapes of the models in them."""
        given = [
            (name, value.shape if isinstance(value, RequestModel) else None)
            for name, value in self.given.items()
        ]
        return type(self), tuple(given)

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
        """Whether the field at a path is given.

        Parameters
        ----------
        path : str
            Names of the fields from this model on, by ``/``.

        Returns
        -------
        bool
        """
        name, _, within = path.partition("/")
        named = name in self.model_fields_set
        return named and (not within or getattr(self, name).says(within))

    @cached_property
    def given(self) -> "Mapping[str, Any]":
        """The fields that have a value, by their names."""
        own = vars(self)  # with what is worked out of them and kept
        return {name: value for name in _core_plan(type(self)) if (value := own[name]) is not None}

    def model_copy(self, *, update: "Mapping[str, Any] | None" = None, deep: bool = False) -> Self:
        """The same with other fields; what is worked out and kept is of the former ones."""
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
        """The given fields as the core's arguments, in SI units."""
        plan = _core_plan(type(self))
        return {plan[name].core: plan[name].convert(value) for name, value in self.given.items()}

    ASSUMED: ClassVar[tuple[str, ...]] = ()
    """Fields whose default decides about the answer, which says so where they are not given."""

    def assumed(self) -> Iterator[tuple[tuple[str, ...], Any]]:
        """What is assumed, since it is not given: the path of each field, and its value."""
        for name, value in self.given.items():
            if name in self.ASSUMED and name not in self.model_fields_set:
                yield (name,), value
        for name, value in self.given.items():
            if isinstance(value, RequestModel):
                yield from (((name, *path), inner) for path, inner in value.assumed())

    def without(self, path: tuple[str, ...]) -> "Values":
        """What the answer would be without an assumption, where that is soon said."""
        return {}

    def notices(self) -> tuple[Notice, ...]:
        """What of the request is taken otherwise than it is typed."""
        parts = (each for each in self.given.values() if isinstance(each, RequestModel))
        return tuple(chain.from_iterable(each.notices() for each in parts))

    def cost(self) -> float:
        """How many points are calculated, which says where (`app.endpoint.LIGHT_COST`): of what
        solves or searches so many that it leaves the event loop whatever it states.
        """
        return math.inf

    def refuse_beyond(self, settings: Settings) -> None:
        """Refuse what exceeds the operator's limits.

        Raises
        ------
        InvalidInput
            If it does.
        """


class _InCore(NamedTuple):
    """How a field is told to the core."""

    core: str  # its name there
    convert: Convert  # what takes its values to SI units


@cache
def _core_plan(model: type[RequestModel]) -> dict[str, _InCore]:
    """How the fields of a request are told to the core."""
    plan = {}
    for name, field in model.model_fields.items():
        part = any(issubclass(held, PartFields) for held, _ in _held(field.annotation))
        plan[name] = _InCore(core_name(name), _section if part else to_si_converter(name))
    return plan


class PartFields(RequestModel):
    """A part of a section, alone or in a list: the arguments of the core have it in SI units."""

    @abstractmethod
    def section(self) -> Any:
        """The same in SI units."""


def _section(part: Any) -> Any:
    return tuple(map(_section, part)) if isinstance(part, list) else part.section()


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
    """A field with what the form needs to show it; its unit follows from its name.

    Parameters
    ----------
    title, symbol : str
        Name and symbol, as engineers write them.
    group : str, optional
        Group of the form that the field belongs to, where it is not that of its class.
    help : str, optional
        What it is, in a sentence, where no text below the field says it.
    step : float, optional
        By how much the arrow keys change it.
    advanced : bool
        Whether the form may fold it away.
    schema : dict, optional
        What its JSON schema says besides, where validators do more than limits.
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
    """A field of an answer with what it means; its unit follows from its name.

    Parameters
    ----------
    meaning : str
        What it is, in a sentence.
    symbol : str
        Symbol of the nomenclature.
    equation : str
        Source with the number of its equation.
    """
    shown = {"x-symbol": symbol, "x-equation": equation}
    extra = {key: value for key, value in shown.items() if value}
    return Field(description=meaning, json_schema_extra=cast(Any, extra))


class WorkedFields(RequestModel):
    """A request that can ask how its answer follows."""

    include: list[Literal["worked"]] = Field(
        default=[], max_length=1, description="Optional results: what is not named is not computed."
    )

    def to_core(self) -> dict[str, Any]:
        """The given fields as the core's arguments, without what is asked."""
        own = super().to_core()
        own.pop("include", None)
        return own


Shape = tuple[type[RequestModel], tuple[tuple[str, "Shape | None"], ...]]
"""Of a request, what the paths of its fields hang on, and which of them are given."""


@lru_cache(maxsize=512)
def core_paths(shape: Shape) -> dict[str, tuple[str, ...]]:
    """Paths of the fields of a request, by its shape; where a model is not given, as if it were. By
    its name alone a parameter is the first of that name that is given, or else the first.
    """
    model, within = shape[0], present(dict(shape[1]))
    plan = _core_plan(model)
    found: dict[str, tuple[str, ...]] = {}
    for name, (core, _) in reversed(plan.items()):
        found[core] = (name,)
    for name, (core, _) in plan.items():
        held = [within[name]] if name in within else _held(model.model_fields[name].annotation)
        for each in held:
            for parameter, path in core_paths(each).items():
                found.setdefault(f"{core}.{parameter}", (name, *path))
    within_it = {name: (core_paths(inner), {*given_paths(inner)}) for name, inner in within.items()}
    for missing in (False, True):
        for name, (paths, given) in within_it.items():
            for parameter, path in paths.items():
                if missing or path in given:
                    found.setdefault(parameter, (name, *path))
    return found


def given_paths(shape: Shape) -> Iterator[tuple[str, ...]]:
    """Paths of the fields that requests of a shape have given."""
    yield from ((name,) for name, _ in shape[1])
    for name, inner in present(dict(shape[1])).items():
        yield from ((name, *path) for path in given_paths(inner))


def _held(annotation: Any) -> list[Shape]:
    """Shapes of the models that an annotation allows, alone or in lists."""
    if isinstance(annotation, type) and issubclass(annotation, RequestModel):
        return [(annotation, ())]
    return [shape for each in get_args(annotation) for shape in _held(each)]


Values = dict[str, Any]
"""An answer, or a part of it, as it is sent: what there is, by the names of its model."""


def present(values: Mapping[str, Any]) -> Values:
    """What there is of values: those that are not None."""
    return {name: value for name, value in values.items() if value is not None}


class ResponseModel(BaseModel):
    """The description of an answer, whose values are read from a core result by names without
    units.
    """

    model_config = ConfigDict(json_schema_extra=_complete_schema, allow_inf_nan=False)

    BESIDE: ClassVar[tuple[str, ...]] = ()
    """Fields that are no attributes of the result: said beside it, else absent."""

    @classmethod
    def __pydantic_init_subclass__(cls, **_: Any) -> None:
        register(cls)

    @classmethod
    def values(cls, result: Any, run_time_us: float | None = None, **given: Any) -> Values:
        """Values of an answer from a core result, without what is not known of it; arrays stay
        arrays.

        Parameters
        ----------
        result : object
            Core result, in SI units, with attributes named as the fields without their units.
        run_time_us : float, optional
            What the calculation cost, for `accuracy`.
        **given
            Fields that are said here, not read from the result; absent where None.
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


def _leave_to_checks(values: Values, checks: list[Values]) -> None:
    """Leave out of an answer and its sections the warnings that its checks say."""
    said = {each["code"] for each in checks}
    said |= {each["reason"]["code"] for each in checks if "reason" in each}
    for part in (values, *values.values()):
        if isinstance(part, dict) and "warnings" in part:
            kept = [each for each in part.pop("warnings") if each["code"] not in said]
            part |= {"warnings": kept} if kept else {}


Report = Callable[[float], None]
"""Is told how much of a study is done, from 0 to 1."""


def untold(share: float) -> None:
    """How much is done, where nobody is told."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Calculation:
    """A calculation as the service offers it; `app.registry` lists all of them."""

    # Its path below the API's prefix; its one name in batches, studies and examples too.
    name: str
    title: str  # what it is, for people
    tag: str  # its chapter in the API's description
    request: Any  # model of its request, or an annotated union of models
    answer: type["ResponseModel"]  # model that describes its answer
    solve: Callable[[Any], Values]  # a function of a module: the values of the answer to a request
    # A function of a module: the Plotly figure of a request and a theme.
    figure: Callable[[Any, Any], dict[str, Any]] | None = None
    sources: tuple[str, ...] = ()  # where its formulas come from
    # What its model leaves out with all of its sections given, keys of `app.registry.NEGLECTED`.
    neglects: tuple[str, ...] = ()
    batched: bool = True  # whether batches take it
    # A function of a module: the worked steps of a request, as `app.worked` makes them.
    worked: Callable[[Any], list[Values]] | None = None

    def solved(self, body: Any, report: Report) -> Values:
        """Values of the answer to a request, by the calculation alone."""
        return self.solve(body)

    def answered(self, body: Any, report: Report = untold) -> Values:
        """Values of the answer to a request, with what was assumed and taken otherwise than typed.

        Parameters
        ----------
        body : RequestModel
            The request.
        report : callable, optional
            Of a study what is told how much is done, from 0 to 1.

        Returns
        -------
        dict
        """
        values = self.solved(body, report)
        if assumed := [
            {"pointer": "/" + "/".join(path), **_taken(path[-1], value), **body.without(path)}
            for path, value in body.assumed()
        ]:
            values["assumed"] = assumed
        if self.worked is not None and "worked" in (body.include or ()):
            values["worked"] = self.worked(body)
        if notices := body.notices():
            values["warnings"] = [*map(warning, notices), *values.get("warnings", ())]
        if checks := values.get("checks"):
            _leave_to_checks(values, checks)
        return values


@dataclass(frozen=True, slots=True, kw_only=True)
class StudyCalculation(Calculation):
    """A calculation that may take long, and says meanwhile how much of it is done."""

    reporting: Callable[[Any, Report], Values]  # as `solve`, with what is told

    def solved(self, body: Any, report: Report) -> Values:
        """Values of the answer to a request; what is told is told."""
        return self.reporting(body, report)


class File(NamedTuple):
    """A file that is answered."""

    name: str
    media_type: str
    content: bytes


@dataclass(frozen=True, slots=True, kw_only=True)
class Export:
    """Files of a design as the service offers them; `app.registry` lists all of them."""

    name: str  # its path below the API's prefix
    title: str  # what it is, for people
    request: type["RequestModel"]  # model of its request
    write: Callable[[Any], File]  # a function of a module: the file of a request
    media_types: tuple[str, ...]  # which kinds of files


class _Plan(NamedTuple):
    """How an answer is made of a core result."""

    read: list[tuple[str, str, Convert, bool]]
    """What is read from it: name, core's name, what makes a value of it that is sent, and whether
    it has to be there."""
    warns: bool
    states_accuracy: bool


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
            if name not in ("accuracy", "warnings", "assumed", "worked", *model.BESIDE, *given)
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
    """How the numbers were got, how wrong they may be, and what they cost."""

    model_config = ConfigDict(json_schema_extra=_complete_schema)

    method: str = Field(description="How the numbers were got, in English.")
    method_code: str = Field(
        description="The same by code.", json_schema_extra={"enum": [*METHODS]}
    )
    relative_error: float = Field(
        description="Bound or estimate of the relative error; from 1 on nothing is known."
    )
    evaluations: int = Field(description="Evaluations of the function behind the method.")
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
    """What was not given, and decides."""

    pointer: str = Field(description="JSON pointer to the field.")
    value: float | str | dict[str, Any] = Field(description="What is taken for it.")
    low: Maybe[float] = Field(
        description="Of a material whose sources differ: the least. Checks are judged over all."
    )
    high: Maybe[float] = Field(description="The largest.")
    without: Maybe[dict[str, float]] = Field(
        description="Of the number of satellites: the peak force of one, by the ideal forces."
    )


class StepOut(BaseModel):
    """How one number of an answer follows from others."""

    model_config = ConfigDict(json_schema_extra=_complete_schema)

    section: str = Field(description="What of the answer it belongs to.")
    code: str = Field(
        description="What is worked out: a field of the section, or a value on the way to one; its "
        "name ends in its unit."
    )
    symbol: str = Field(description="How it is called in the formulas of later steps.")
    formula: Maybe[str] = Field(
        default=None,
        description="Infix over `names`: + - * / ^ ( ), sqrt sin cos tan asin acos atan abs min "
        "max, pi. It holds in SI units, angles in rad.",
    )
    method: Maybe[str] = Field(
        default=None,
        description="How it was got in the place of a formula, by code: what is summed, searched, "
        "solved, counted or given.",
    )
    names: dict[str, str] = Field(
        description="What each name of the formula is, or each number that goes into the method, "
        "with its unit at its end."
    )
    values: dict[str, float] = Field(description="Its value, in that unit.")
    result: float = Field(description="The result, in `unit`.")
    unit: str = Field(description="Unit of the result as shown; empty for plain numbers.")
    source: Maybe[str] = Field(default=None, description="Where the formula stands, by code.")
    equation: Maybe[str] = Field(default=None, description="Number of its equation there.")
    erratum: Maybe[str] = Field(default=None, description="What the print has wrong, by code.")
    note: Maybe[str] = Field(default=None, description="What is to be known of it, by code.")
    params: Maybe[dict[str, Any]] = Field(
        default=None, description="What the text of `note` or `method` names."
    )


def worked_steps() -> Any:
    """The field of an answer that has its worked steps."""
    return Field(
        default=None,
        description="How its numbers follow from each other, where asked; words by code are in "
        "`GET /words`.",
    )


class WorkedResponse(ResponseModel):
    """An answer that can be worked step by step."""

    worked: Maybe[list[StepOut]] = worked_steps()


def assumptions() -> Any:
    """The field of an answer that says what it assumes."""
    return Field(description="What was not given and decides; absent where all was.")


class AssumingResponse(WorkedResponse):
    """An answer that says what it assumes."""

    assumed: Maybe[list[AssumedOut]] = assumptions()


def notices_of(*results: Any) -> tuple[Notice, ...]:
    """Notices of core results, of those that there are; one may be a notice itself."""
    found: list[Notice] = []
    for each in results:
        if isinstance(each, Notice):
            found.append(each)
        elif each is not None:
            found += each.notices
    return tuple(found)


REPLACED = "The code that this one replaces; for one release."


class WarningOut(BaseModel):
    """A limit of validity that the result strains; the number is given all the same."""

    code: str = Field(description="Which limit.", json_schema_extra={"enum": [*WARNINGS]})
    params: dict[str, Any] = Field(description="What the text names: numbers and fields.")
    detail: str = Field(description="The same in English.")
    was: Maybe[str] = Field(default=None, description=REPLACED)


def _taken(name: str, value: object) -> Values:
    """Value that is assumed for a field, with its range where sources differ."""
    if not isinstance(value, Spread):
        return {"value": value}
    usual, low, high = from_si(name, value)
    return {"value": usual} | ({"low": low, "high": high} if low < high else {})


def warning(notice: Notice) -> Values:
    """Warning of a core notice; the API's names stand in for the core's."""
    params = api_params(notice.params)
    values = {"code": notice.code, "params": params}
    values["detail"] = WARNINGS[notice.code].text.format(**params)
    if was := WAS["warnings"].get(notice.code):
        values["was"] = was
    return values
