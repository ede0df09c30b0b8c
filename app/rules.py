"""Rules between the fields of a request: alternative forms, fields of a kind, and relations of two
fields; their refusals, and their JSON schema.
"""

from collections.abc import Iterable
from functools import cache
from itertools import chain
from typing import Any, NamedTuple

from pydantic_core import PydanticCustomError

from core.fields import Forms as Forms
from core.fields import Kinds as Kinds
from core.fields import Rule as Rule


def field_error(name: str, code: str, **params: Any) -> PydanticCustomError:
    """Refusal of a field, or ``model/field``, by a model's validator; see `app.problems.TEXTS`."""
    return PydanticCustomError("field_error", code, {"name": name, "code": code, "params": params})


class Alternative(NamedTuple):
    """Forms of which one has to be given, their fields, and fields that may occur together."""

    forms: Forms
    fields: frozenset[str]
    allowed: frozenset[frozenset[str]]


def _name(model: Any, field: str) -> str:
    """Name of a field in JSON."""
    return model.model_fields[field].alias or field


@cache
def alternatives(model: Any) -> tuple[Alternative, ...]:
    """Alternatives of a request and of all its nested models."""
    fields = {_name(model, field): field for field in model.model_fields}
    every = (vars(each).get("ALTERNATIVES", ()) for each in model.__mro__)
    return tuple(
        Alternative(
            forms,
            frozenset(fields[name] for name in chain(*forms)),
            frozenset(frozenset(fields[name] for name in form) for form in forms),
        )
        for forms in dict.fromkeys(chain.from_iterable(every))
    )


def wrong_form(model: Any, forms: Forms, stated: set[str]) -> PydanticCustomError:
    """Reason why the given fields of a request fit none of some forms."""
    named = {_name(model, field) for field in stated}
    given = [form for form in forms if not named.isdisjoint(form)]
    if not given:
        return field_error(forms[0][0], "needed", field=forms[1][0])
    if len(given) > 1:
        first, second = (next(n for n in form if n in named) for form in given[:2])
        return field_error(second, "only_one", field=first)
    missing = next(name for name in given[0] if name not in named)
    other = next(name for name in given[0] if name != missing)
    return field_error(missing, "needed_beside", field=other)


BROKEN = {"only_one": (True, True), "needed_beside": (False, True), "needed": (False, False)}
"""Presence of the rule's field and of the other one in a violation: both; the other alone;
neither."""


@cache
def between(model: Any) -> tuple[Rule, ...]:
    """Rules between the fields of a request and of all its nested models."""
    every = (vars(each).get("BETWEEN", ()) for each in reversed(model.__mro__))
    return tuple(dict.fromkeys(chain.from_iterable(every)))


def _only(form: tuple[str, ...], names: Iterable[str]) -> dict[str, Any]:
    """Schema of a form: its fields and no others, by requirements, as generators of clients do not
    accept properties that are `false`.
    """
    others = [{"required": [name]} for name in names if name not in form]
    return {"required": [*form]} | ({"not": {"anyOf": others}} if others else {})


@cache
def of_other_kinds(model: Any, kind: Any) -> tuple[str, ...]:
    """Fields of other kinds of a request."""
    own = {*chain(*model.KINDS[kind])}
    every = dict.fromkeys(chain.from_iterable(chain(*names) for names in model.KINDS.values()))
    return tuple(name for name in every if name not in own)


def _kind_schema(model: Any, kind: Any) -> dict[str, Any]:
    """Schema of a kind: its needed fields, and none of other kinds."""
    named: dict[str, Any] = {"required": [model.KIND]}
    if kind is None:
        named = {"not": named}
    else:
        default = kind == model.model_fields[model.KIND].default
        named = {"properties": {model.KIND: {"const": kind}}} | ({} if default else named)
    needed, others = model.KINDS[kind][0], of_other_kinds(model, kind)
    rule: dict[str, Any] = {"required": [*needed]} if needed else {}
    if others:
        rule["not"] = {"anyOf": [{"required": [name]} for name in others]}
    return {"if": named, "then": rule}


def _rule_schema(rule: Rule) -> dict[str, Any]:
    """Schema of a rule between two fields of a request."""
    field, other = ({"required": [name]} for name in (rule.field, rule.other))
    if rule.rule == "only_one":
        return {"not": {"required": [rule.field, rule.other]}}
    return {"anyOf": [field, other if rule.rule == "needed" else {"not": other}]}


def schema_rules(model: Any) -> list[dict[str, Any]]:
    """JSON schema of a request's forms, kinds, rules between its own fields, and other rules."""
    rules: list[dict[str, Any]] = []
    for forms, _, _ in alternatives(model):
        names = dict.fromkeys(name for form in forms for name in form)
        rules.append({"oneOf": [_only(form, names) for form in forms]})
    rules += [_rule_schema(rule) for rule in between(model) if "/" not in rule.field + rule.other]
    rules += model.RULES
    return rules + [rule for kind in model.KINDS if (rule := _kind_schema(model, kind))["then"]]
