"""Sections of requests made of the dataclasses of the design document, whose fields say title,
unit, limits and help (`core.fields`): the names in JSON, their schema and validation, and the
conversion to SI units follow.
"""

import math
from collections.abc import Collection, Iterator, Mapping
from dataclasses import MISSING, fields, is_dataclass
from functools import cache, cached_property, reduce
from itertools import chain
from operator import or_
from types import NoneType, new_class
from typing import (
    TYPE_CHECKING,
    Annotated,
    Any,
    ClassVar,
    Literal,
    NamedTuple,
    TypeVar,
    cast,
    get_args,
    get_type_hints,
)

from pydantic import AfterValidator, BeforeValidator
from pydantic import Field as Limits
from pydantic.fields import FieldInfo

from app.model import (
    LIST,
    NO_DUST,
    OPTIONAL,
    RequestModel,
    Values,
    core_names,
    no_dust,
    quantity,
    whole,
)
from app.rules import Rule
from app.units import Convert, core_name, from_si
from core.design.stated import filled as filled_by_core
from core.design.stated import fills
from core.design.stated import section as section_of
from core.fields import Input, Variants, help_of

Request = TypeVar("Request", bound=RequestModel)

LIMITED: Any = Annotated
"""Generic type of annotations that are made at import."""


class JsonForm(NamedTuple):
    """Form of a value in JSON, and its conversion to the core if that is no change of its unit."""

    annotation: Any
    convert: Convert | None = None


JSON_FORMS: dict[Any, JsonForm] = {}
"""Forms of types of core that are neither numbers, words, lists nor sections."""


class SectionFields(RequestModel):
    """Section of the document, or part of one.

    A subclass names its dataclass of core as `of`, or those of several kinds by kind. It has the
    fields of that but those in `without`, or of those alone in `only`, and adds what core does not
    know. Fields in `needs` have to be stated. An annotation with a default alone, of a field that
    core has, changes the type and the default in JSON.
    """

    DOCUMENT: ClassVar[Any]
    """Dataclass of the section, or dataclasses by kind."""

    if TYPE_CHECKING:

        def __getattr__(self, name: str) -> Any:
            """Value of a field that the dataclass says."""

    def __init_subclass__(
        cls,
        *,
        of: Any = None,
        without: Collection[str] = (),
        only: Collection[str] = (),
        needs: Collection[str] = (),
        group: str | None = None,
        **config: Any,
    ) -> None:
        if of is not None:
            kinds = [*of.values()] if isinstance(of, Mapping) else [of]
            chosen = {"kind": _kind_field(of)} if isinstance(of, Variants) else {}
            for each in chain.from_iterable(map(request_fields, kinds)):
                if each.core not in without and (not only or each.core in only):
                    chosen.setdefault(each.core, each)
            stated = {*needs}
            if isinstance(of, Mapping):
                cls.KINDS = {name: _of_kind(kind) for name, kind in of.items()}
            else:
                stated |= {name for name, each in chosen.items() if each.needed}
            _give_fields(cls, chosen, stated, group)
            named = {core: each.input.alias or each.name for core, each in chosen.items()}
            _give_rules(cls, kinds, {"kind": "kind"} | named)
            cls.DOCUMENT = of
        super().__init_subclass__(group=group, **config)

    @cached_property
    def stated(self) -> dict[str, Any]:
        """Stated values in SI units, by their names in core."""
        named, own = core_names(type(self)), self.to_core()
        typed = [named[name] for name in self.model_fields_set]
        return {core: own[core] for core in typed if core in own}

    @property
    def kind_of_core(self) -> Any:
        """Dataclass of the section."""
        made = self.DOCUMENT
        return made[self.kind] if isinstance(made, Mapping) else made

    @cached_property
    def made(self) -> Any:
        """Section in SI units."""
        return section_of(kind=self.kind_of_core, stated=self.stated)

    def section(self) -> Any:
        """Section in SI units, as part of another one."""
        return self.made

    def assumed(self) -> Iterator[tuple[tuple[str, ...], Any]]:
        """Assumed values, with those that core takes for fields that are not given."""
        yield from super().assumed()
        yield from (((name,), value) for name, value in self.filled.items())

    @property
    def filled(self) -> Values:
        """Values that core takes for fields that are not given."""
        kind = self.kind_of_core
        if not fills(kind):
            return {}
        named, own = core_names(type(self)), vars(self)
        typed = {named[name]: own[name] for name in self.model_fields_set}  # units do not matter
        usual = filled_by_core(kind=kind, stated=typed)
        return {name: from_si(name, usual[core]) for name, core in named.items() if core in usual}


class RequestField(NamedTuple):
    """Field of a dataclass, as requests have it."""

    core: str
    name: str
    """Name in JSON: that in core with its unit."""
    input: Input
    hint: Any
    default: Any
    """Default in the unit of JSON; None for none."""
    needed: bool
    help: str | None


@cache
def request_fields(kind: Any) -> tuple[RequestField, ...]:
    """Fields of a dataclass that requests have, with those from which others follow."""
    found = [*request_fields(kind.FOLLOWS_FROM)] if hasattr(kind, "FOLLOWS_FROM") else []
    hints, helps = get_type_hints(kind), help_of(kind)
    for each in fields(kind):
        if own := each.metadata.get("input"):
            name = f"{each.name}_{own.unit}".removesuffix("_")
            if core_name(name) != each.name:
                raise KeyError(f"{own.unit}, unit of {each.name}, is not in app.units")
            absent = own.silent or each.default in (MISSING, None, (), math.inf)
            default = None if absent else from_si(name, each.default)
            needed = each.default is MISSING and not own.filled
            hint, text = hints[each.name], helps.get(each.name)
            found.append(RequestField(each.name, name, own, hint, default, needed, text))
    return tuple(found)


def _of_kind(kind: Any) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Needed and optional fields of a dataclass, in names of JSON."""
    needed = tuple(each.name for each in request_fields(kind) if each.needed)
    return needed, tuple(each.name for each in request_fields(kind) if not each.needed)


def _kind_field(of: Variants) -> RequestField:
    """Field of the kind of a section."""
    named: Any = tuple(name for name in of if name)
    about = Input(title=of.title, symbol="", unit="", limits={})
    return RequestField("kind", "kind", about, Literal[named], of.default, False, of.help)


def _give_fields(
    cls: Any, chosen: Mapping[str, RequestField], stated: Collection[str], group: str | None
) -> None:
    """Give a model the fields of dataclasses that it does not inherit; those that have no default
    and need not be stated are optional.
    """
    own, annotations, converters = cls.__annotations__, {}, {**cls.CONVERTERS}
    for core, each in chosen.items():
        if each.name in cls.model_fields and core not in stated:
            continue
        form = _json_form(each.hint, each.input, group)
        if form.convert is not None:
            converters[each.name] = form.convert
        needed = each.default is None and core in stated
        known = needed or each.default is not None
        annotations[each.name] = form.annotation if known else OPTIONAL[form.annotation]
        written = vars(cls).get(each.name, None if needed else each.default)
        if not isinstance(written, FieldInfo):
            setattr(cls, each.name, _field(each, {} if needed else {"default": written}))
    besides = {name: each for name, each in own.items() if name not in annotations}
    cls.__annotations__ = besides | annotations | own
    cls.CONVERTERS = converters


def _give_rules(cls: Any, kinds: Collection[Any], names: Mapping[str, str]) -> None:
    """Give a model the rules of dataclasses between fields that it has, and the kinds of one."""
    for kind in kinds:
        if hasattr(kind, "KINDS"):
            cls.KIND = names[kind.KIND]
            cls.KINDS = {
                each: tuple(tuple(names[name] for name in part) for part in parts)
                for each, parts in kind.KINDS.items()
            }
    forms = chain.from_iterable(getattr(kind, "ALTERNATIVES", ()) for kind in kinds)
    rules = chain.from_iterable(getattr(kind, "BETWEEN", ()) for kind in kinds)
    if "ALTERNATIVES" not in vars(cls):
        cls.ALTERNATIVES = tuple(
            tuple(tuple(names[name] for name in form) for form in each)
            for each in dict.fromkeys(forms)
            if names.keys() >= {*chain(*each)}
        )
    of_core = (
        Rule(names[field], rule, names[other])
        for field, rule, other in dict.fromkeys(rules)
        if names.keys() >= {field, other}
    )
    cls.BETWEEN = (*vars(cls).get("BETWEEN", ()), *of_core)


def _field(each: RequestField, given: dict[str, Any]) -> Any:
    """Field of a model, as pydantic takes it; `given` may have its default."""
    about = each.input
    if about.alias:
        given["alias"] = about.alias
    if not about.title:
        return Limits(description=each.help, **given)
    least = about.least
    more = {
        "x-options": [*about.options],
        "pattern": about.pattern and f"^{about.pattern}$",
        "anyOf": least and [{"minimum": least}, {"maximum": -least}],
    }
    given["schema"] = (NO_DUST if about.or_zero else {}) | {k: v for k, v in more.items() if v}
    given |= {"help": each.help, "step": about.step, "advanced": about.advanced}
    return quantity(about.title, about.symbol, **given)


def _json_form(hint: Any, about: Input, group: str | None, depth: int = 0) -> JsonForm:
    """Form in JSON of a type of core; lists within others are at a depth."""
    if NoneType in get_args(hint):
        hint = reduce(or_, (each for each in get_args(hint) if each is not NoneType))
    if getattr(hint, "__origin__", None) is tuple:
        inner = _json_form(get_args(hint)[0], about, group, depth + 1)
        least, most = about.lengths[depth]
        listed = LIMITED[LIST[inner.annotation], Limits(min_length=least, max_length=most)]
        if is_dataclass(get_args(hint)[0]) or about.unit:
            return JsonForm(listed)
        return JsonForm(listed, tuple)
    if hint in JSON_FORMS:
        return JSON_FORMS[hint]
    if is_dataclass(hint):
        return JsonForm(model_of(cast(type, hint), group))
    limits = Limits(**about.limits)
    if hint is int:
        return JsonForm(Annotated[int, limits, BeforeValidator(whole)])
    if hint is float:
        more = [AfterValidator(no_dust)] if about.or_zero else []
        return JsonForm(Annotated[float, limits, *more])
    if hint is str and about.lengths:
        return JsonForm(Annotated[str, Limits(max_length=about.lengths[0][1])])
    return JsonForm(hint)


@cache
def model_of(kind: type, group: str | None) -> type[SectionFields]:
    """Model of a part of a section: the one that names it, else one of its fields alone."""
    for each in _models(SectionFields):
        if vars(each).get("DOCUMENT") is kind:
            return each
    return _made(kind.__name__, kind, group)


def _made(name: str, kind: Any, group: str | None) -> type[SectionFields]:
    """Model of the fields of a dataclass, or of those of several kinds."""
    own = {"__module__": __name__, "__doc__": kind.__doc__}
    config = {"of": kind, "group": group, "use_attribute_docstrings": False}  # there is no source
    return new_class(f"{name}Fields", (SectionFields,), config, lambda body: body.update(own))


def _models(model: type[SectionFields]) -> Iterator[type[SectionFields]]:
    for each in model.__subclasses__():
        yield each
        yield from _models(each)


class SectionedFields(RequestModel):
    """Document that has sections.

    A subclass names the dataclasses of its sections, or those of several kinds, by section. It has
    an optional field for each, whose model has the fields of the dataclass, and whose group in the
    form has the name of the section. A section that the subclass annotates has the model that
    stands there.
    """

    def __init_subclass__(cls, *, sections: Mapping[str, Any] | None = None, **config: Any) -> None:
        own, fields = cls.__annotations__, dict[str, Any]()
        for name, kind in (sections or {}).items():
            model = name.title().replace("_", "")
            fields[name] = own[name] if name in own else OPTIONAL[_made(model, kind, name)]
        cls.__annotations__ = fields | own
        super().__init_subclass__(**config)
