"""Tables that belong together: sections of the whole design, requirements, examples and oracles of
all calculations."""

from dataclasses import fields

import pytest
from pydantic import TypeAdapter

from app.calculations.checks import ScopedRequirementsFields
from app.calculations.crank_planetary_answer import CrankPlanetaryResponse
from app.calculations.crank_planetary_sections import (
    ANSWERS,
    NEEDS_OF,
    SECTIONS,
    WORKED,
    CrankPlanetaryRequest,
)
from app.calculations.document import DocumentFields
from app.examples import REQUESTS
from app.model import Calculation, StudyCalculation
from app.registry import CALCULATIONS
from app.units import core_name
from core.design.document import Design
from core.design.sections import Requirements
from tests.oracles.answers import CALCULATIONS as ORACLES

OF_THE_VERDICT = {"checks", "largest_torque", "fixes", "combined", "worked"}
"""Sections of the answer that are no part of the design's results."""

OF_THE_ANSWER = {"crank_angle_deg", "include", "fixes_for"}
"""Fields of the request that say what is answered, not what is designed."""

OF_OTHERS = {
    "crank-planetary",
    "propose",
    "sensitivity",
    "solve",
    "sweep",
    "tolerance-study",
    "work-precision",
}
"""Calculations whose numbers are those of others, or random."""


def test_a_section_of_the_answer_is_in_all_tables() -> None:
    assert {*SECTIONS} == NEEDS_OF.keys() == ANSWERS.keys() | OF_THE_VERDICT
    assert {*SECTIONS} - {"largest_torque"} <= CrankPlanetaryResponse.model_fields.keys()
    assert WORKED.keys() <= ANSWERS.keys()


def test_a_section_of_the_design_may_be_asked() -> None:
    asked = CrankPlanetaryRequest.model_fields.keys() - OF_THE_ANSWER
    assert asked == DocumentFields.model_fields.keys()
    assert asked == {each.name for each in fields(Design)}
    parts = {part.partition("/")[0] for needed in NEEDS_OF.values() for part in needed}
    assert parts <= asked
    models = DocumentFields.model_json_schema()["$defs"]
    assert [name for name, each in models.items() if not each.get("description")] == []


def test_a_requirement_may_be_asked() -> None:
    asked = {core_name(name) for name in ScopedRequirementsFields.model_fields}
    assert asked == {each.name for each in fields(Requirements)}


QUICK = [each for each in CALCULATIONS.values() if not isinstance(each, StudyCalculation)]


@pytest.mark.parametrize("calculation", QUICK, ids=lambda each: each.name)
def test_a_calculation_answers_its_example(calculation: Calculation) -> None:
    body = TypeAdapter(calculation.request).validate_python(REQUESTS[calculation.name])
    answer = calculation.answered(body)
    assert answer and answer.keys() <= calculation.answer.model_fields.keys()


def test_every_calculation_has_its_oracle() -> None:
    held = {each.path for each in ORACLES}
    assert CALCULATIONS.keys() - OF_OTHERS <= held
