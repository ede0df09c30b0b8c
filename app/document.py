"""Sections of requests made of the dataclasses of the design document, whose fields say title,
unit, limits and help (`core.fields`): the names in JSON, their schema and validation, and the
conversion to SI units follow.
"""

import math
from collections.abc import Collection, Iterator, Mapping
from dataclasses import MISSING, Field, fields, is_dataclass
from functools import cache, reduce
from itertools import chain
from operator import or_
from types import NoneType, new_class
from typing import (
    TYPE_CHECKING,
    Annotated,
    Any,
    ClassVar,
    NamedTuple,
    cast,
    get_args,
    get_type_hints,
)

from pydantic import AfterValidator, BeforeValidator
from pydantic import Field as Limits

from app.model import NO_DUST, Maybe, PartFields, no_dust, quantity, whole
from app.rules import Rule
from app.units import Convert, from_si
from core.fields import Input, help_of

LIMITED: Any = Annotated
OPTIONAL: Any = Maybe
LIST: Any = list
"""Generic types of annotations that are made at import."""


class Sent(NamedTuple):
    """Form of a value in JSON, and its conversion to the core if that is no change of its unit."""

    annotation: Any
    convert: Convert | None = None


SENT: dict[Any, Sent] = {}
"""Forms of types of core that are neither numbers, words, lists nor sections."""


class SectionFields(PartFields):
    """Section of the document, or part of one.

    A subclass names its dataclass of core as `of`, or those of several kinds by kind. It has the
    fields of that but those in `without`, or of those alone in `only`, and adds what core does not
    know. Fields in `needs` have to be stated.
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
            kinds = _kinds(of)
            said = {
                each.name: (each, kind)
                for kind in reversed(kinds)
                for each in reversed(_inputs(kind))
                if each.name not in without and (not only or each.name in only)
            }
            _say(cls, [*reversed(said.values())], group, needs, several=isinstance(of, Mapping))
            _rule(cls, kinds, {name: name_of(each) for name, (each, _) in said.items()})
            if isinstance(of, Mapping):
                cls.KINDS = {name: _of_kind(kind) for name, kind in of.items()}
            cls.DOCUMENT = of
        super().__init_subclass__(group=group, **config)

    def section(self, around: Any = None) -> Any:
        """Section in SI units; `around` is the request."""
        own, made = self.to_core(), self.DOCUMENT
        if isinstance(made, Mapping):
            made = made[self.kind]
            names = {each.name for each in fields(made)}
            own = {name: value for name, value in own.items() if name in names}
        return made(**own)


def _kinds(of: Any) -> list[Any]:
    """Dataclasses that a section is made of."""
    return [*dict.fromkeys(of.values())] if isinstance(of, Mapping) else [of]


def _inputs(kind: Any) -> list[Field[Any]]:
    """Fields of a dataclass that the document has."""
    return [each for each in fields(kind) if "input" in each.metadata]


def _of_kind(kind: Any) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Needed and optional fields of a dataclass, in names of JSON."""
    own = _inputs(kind)
    return (
        tuple(name_of(each) for each in own if needed(each)),
        tuple(name_of(each) for each in own if not needed(each)),
    )


def _say(
    cls: Any,
    said: list[tuple[Field[Any], Any]],
    group: str | None,
    needs: Collection[str],
    *,
    several: bool,
) -> None:
    """Give a model the fields of dataclasses that it does not inherit; a field of one of several
    kinds is optional.
    """
    own, annotations, converters = cls.__annotations__, {}, {**cls.CONVERTERS}
    for each, kind in said:
        name = name_of(each)
        if name in cls.model_fields:
            continue
        sent = _sent(_hints(kind)[each.name], each.metadata["input"], group)
        if sent.convert is not None:
            converters[name] = sent.convert
        default = _default(each)
        stated = each.name in needs or (needed(each) and not several)
        optional = default is None and not stated
        annotations[name] = OPTIONAL[sent.annotation] if optional else sent.annotation
        if name not in own:
            setattr(cls, name, _shown(each, default, optional, help_of(kind).get(each.name)))
    written = {name: each for name, each in own.items() if name not in annotations}
    cls.__annotations__ = written | annotations | own
    cls.CONVERTERS = converters


def _rule(cls: Any, kinds: list[Any], names: dict[str, str]) -> None:
    """Give a model the rules of dataclasses between fields that it has."""
    names |= {"kind": "kind"}
    forms = [each for kind in kinds for each in getattr(kind, "ALTERNATIVES", ())]
    rules = [each for kind in kinds for each in getattr(kind, "BETWEEN", ())]
    if "ALTERNATIVES" not in vars(cls):
        cls.ALTERNATIVES = tuple(
            tuple(tuple(names[name] for name in form) for form in each)
            for each in dict.fromkeys(forms)
            if names.keys() >= {*chain(*each)}
        )
    if "BETWEEN" not in vars(cls):
        cls.BETWEEN = tuple(
            Rule(names[field], rule, names[other])
            for field, rule, other in dict.fromkeys(rules)
            if names.keys() >= {field, other}
        )


def name_of(each: Field[Any]) -> str:
    """Name of a field in a request: the name in core with its unit."""
    return f"{each.name}_{each.metadata['input'].unit}".removesuffix("_")


_hints = cache(get_type_hints)


def needed(each: Field[Any]) -> bool:
    """True if a request has to state a field."""
    return each.default is MISSING and not each.metadata["input"].filled


def _default(each: Field[Any]) -> Any:
    """Default of a field in the unit of the document; None if the document has none."""
    said: Input = each.metadata["input"]
    if each.default in (MISSING, None, (), math.inf) or said.silent:
        return None
    return from_si(name_of(each), each.default)


def _shown(each: Field[Any], default: Any, optional: bool, text: str | None) -> Any:
    """Field of a model, as pydantic takes it."""
    said: Input = each.metadata["input"]
    given: dict[str, Any] = {}
    if optional or default is not None:
        given["default"] = [*default] if isinstance(default, tuple) else default
    if said.alias:
        given["alias"] = said.alias
    if not said.title:
        return Limits(description=text, **given)
    schema: dict[str, Any] = NO_DUST if said.or_zero else {}
    if said.options:
        schema = schema | {"x-options": [*said.options]}
    return quantity(
        said.title,
        said.symbol,
        help=text,
        step=said.step,
        advanced=said.advanced,
        schema=schema,
        **given,
    )


def _sent(hint: Any, said: Input, group: str | None, depth: int = 0) -> Sent:
    """Form in JSON of a type of core; lists within others are at a depth."""
    if NoneType in get_args(hint):
        hint = reduce(or_, (each for each in get_args(hint) if each is not NoneType))
    if getattr(hint, "__origin__", None) is tuple:
        inner = _sent(get_args(hint)[0], said, group, depth + 1)
        least, most = said.lengths[depth]
        listed = LIMITED[LIST[inner.annotation], Limits(min_length=least, max_length=most)]
        if is_dataclass(get_args(hint)[0]) or said.unit:
            return Sent(listed)
        return Sent(listed, tuple)
    if hint in SENT:
        return SENT[hint]
    if is_dataclass(hint):
        return Sent(model_of(cast(type, hint), group))
    limits = Limits(**said.limits)
    if hint is int:
        return Sent(Annotated[int, limits, BeforeValidator(whole)])
    if hint is float:
        return Sent(Annotated[float, limits, *([AfterValidator(no_dust)] if said.or_zero else [])])
    if hint is str and said.lengths:
        return Sent(Annotated[str, Limits(max_length=said.lengths[0][1])])
    return Sent(hint)


@cache
def model_of(kind: type, group: str | None) -> type[SectionFields]:
    """Model of a part of a section: the one that names it, else one of its fields alone."""
    for each in _models(SectionFields):
        if vars(each).get("DOCUMENT") is kind:
            return each
    own = {"__module__": __name__, "__doc__": kind.__doc__}
    made = {"of": kind, "group": group}
    return new_class(
        f"{kind.__name__}Fields", (SectionFields,), made, lambda body: body.update(own)
    )


def _models(model: type[SectionFields]) -> Iterator[type[SectionFields]]:
    for each in model.__subclasses__():
        yield each
        yield from _models(each)
