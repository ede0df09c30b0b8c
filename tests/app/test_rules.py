"""Rules between fields: each holds of fields that there are, and refuses what breaks it."""

import ast
from functools import cache
from pathlib import Path
from typing import ClassVar, get_args

import pytest
from pydantic import TypeAdapter, ValidationError

import app.registry
from app.calculations.crank_planetary_sections import (
    INVOLUTE_NEEDS,
    NEEDS_OF,
    CrankPlanetaryRequest,
)
from app.calculations.document import DocumentFields
from app.calculations.mechanism import PinContactFields
from app.model import Maybe, RequestModel
from app.rules import BROKEN, Rule


class Inner(RequestModel):
    size: Maybe[float] = None


class Outer(RequestModel):
    BETWEEN: ClassVar[tuple[Rule, ...]] = (
        Rule("inner/size", "needed_beside", "loose"),
        Rule("tight", "only_one", "inner/size"),
        Rule("plain", "needed", "inner"),
    )
    inner: Maybe[Inner] = None
    loose: Maybe[float] = None
    tight: Maybe[float] = None
    plain: Maybe[float] = None


@pytest.mark.parametrize(
    "given",
    [
        {"plain": 1.0},
        {"inner": {}},
        {"inner": {"size": 1.0}, "loose": 1.0},
        {"plain": 1, "tight": 1},
    ],
)
def test_what_breaks_no_rule_is_taken(given):
    assert Outer.model_validate(given)


@pytest.mark.parametrize(
    ("given", "name", "code", "beside"),
    [
        ({}, "plain", "needed", "inner"),
        ({"plain": 1.0, "loose": 1.0}, "inner/size", "needed_beside", "loose"),
        ({"inner": {}, "loose": 1.0}, "inner/size", "needed_beside", "loose"),
        ({"inner": {"size": 1.0}, "tight": 1.0}, "tight", "only_one", "size"),
    ],
)
def test_what_breaks_a_rule_is_refused(given, name, code, beside):
    with pytest.raises(ValidationError) as refused:
        Outer.model_validate(given)
    (error,) = refused.value.errors()
    assert error["ctx"] == {"name": name, "code": code, "params": {"field": beside}}


def test_what_is_needed_beside_a_fit_is_named():
    given = {"contact_length_mm": 20.0, "pin_radius_mm": 8.0, "fit": "H7/f7"}
    with pytest.raises(ValidationError) as refused:
        PinContactFields.model_validate(given)
    (error,) = refused.value.errors()
    expected = {"name": "eccentricity_mm", "code": "needed_beside", "params": {"field": "fit"}}
    assert error["ctx"] == expected


@cache
def _paths(annotation):
    """Paths of the fields of the models that an annotation allows."""
    found = set()
    if isinstance(annotation, type) and issubclass(annotation, RequestModel):
        for name, field in annotation.model_fields.items():
            found |= {name, *(f"{name}/{path}" for path in _paths(field.annotation))}
    return found.union(*map(_paths, get_args(annotation)))


def _models(model):
    yield model
    for each in model.__subclasses__():
        yield from _models(each)


def test_rules_and_tables_are_of_fields_that_there_are():
    """A misspelt path reads as one that is not given."""
    rules = [
        (model, rule)
        for model in _models(RequestModel)
        for rule in vars(model).get("BETWEEN", ())
        if model is not Outer
    ]
    assert {rule.rule for _, rule in rules} == {*BROKEN}
    for model, rule in rules:
        assert any({rule.field, rule.other} <= _paths(each) for each in _models(model)), rule
    for model in _models(DocumentFields):
        needed = set(model.NEEDS).union(*model.NEEDED_OF.values(), model.NEEDED_OF)
        assert needed <= _paths(model), model
        assert DocumentFields.model_fields.keys() >= model.USES, model
    needed = {*INVOLUTE_NEEDS}.union(*NEEDS_OF.values())
    assert needed <= _paths(CrankPlanetaryRequest)


def _empty(schema, path=""):
    """Places of a schema where one of nothing is asked for, which no JSON schema may."""
    inner = schema.items() if isinstance(schema, dict) else enumerate(schema)
    for key, value in inner:
        if key in ("allOf", "anyOf", "oneOf") and value == []:
            yield f"{path}/{key}"
        if isinstance(value, dict | list):
            yield from _empty(value, f"{path}/{key}")


def test_what_the_schema_says_of_rules_is_a_schema():
    assert [*_empty({"allOf": [{"not": {"anyOf": []}}]})] == ["/allOf/0/not/anyOf"]
    for calculation in app.registry.CALCULATIONS.values():
        assert [*_empty(TypeAdapter(calculation.request).json_schema())] == []


def test_what_is_asked_whether_it_is_given_is_a_field():
    """Some request has every field that rules name, unless its kind has no such field."""
    every = set[str]().union(*map(_paths, _models(RequestModel)))
    asked = [
        call.args[0].value
        for file in Path(app.__path__[0]).rglob("*.py")
        for call in ast.walk(ast.parse(file.read_text()))
        if isinstance(call, ast.Call)
        and isinstance(call.func, ast.Attribute)
        and call.func.attr in ("says", "has")
        and isinstance(call.args[0], ast.Constant)
    ]
    assert asked
    assert {*asked} <= every
