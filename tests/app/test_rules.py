"""Rules between fields: each holds of fields that there are, and refuses what breaks it."""

from typing import ClassVar, get_args

import pytest
from pydantic import ValidationError

import app.registry  # noqa: F401 - with it all requests are known
from app.calculations.crank_planetary_request import CrankPlanetaryRequest
from app.calculations.pin_contact import PinContactFields
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


@pytest.mark.parametrize(
    ("request_model", "given", "name", "beside"),
    [
        (
            PinContactFields,
            {"contact_length_mm": 20.0, "pin_radius_mm": 8.0, "fit": "H7/f7"},
            "eccentricity_mm",
            "fit",
        ),
        (
            CrankPlanetaryRequest,
            {"mechanism": {"pins": 6, "ratio": 20.0}, "rollers": {"name": "686"}},
            "contact/pin_radius_mm",
            "rollers",
        ),
    ],
)
def test_what_is_needed_beside_a_fit_or_rollers_is_named(request_model, given, name, beside):
    with pytest.raises(ValidationError) as refused:
        request_model.model_validate(given)
    (error,) = refused.value.errors()
    assert error["ctx"] == {"name": name, "code": "needed_beside", "params": {"field": beside}}


def _fields(annotation):
    """Paths of the fields of the models that an annotation allows."""
    if isinstance(annotation, type) and issubclass(annotation, RequestModel):
        for name, field in annotation.model_fields.items():
            yield name
            yield from (f"{name}/{path}" for path in _fields(field.annotation))
    for each in get_args(annotation):
        yield from _fields(each)


def _models(model):
    yield model
    for each in model.__subclasses__():
        yield from _models(each)


def test_rules_are_of_fields_that_there_are():
    rules = {
        (model, rule)
        for model in _models(RequestModel)
        for rule in vars(model).get("BETWEEN", ())
        if model is not Outer
    }
    assert {rule.rule for _, rule in rules} == {*BROKEN}
    for model, rule in rules:
        assert any({rule.field, rule.other} <= {*_fields(each)} for each in _models(model)), rule
