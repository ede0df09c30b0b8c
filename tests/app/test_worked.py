"""Worked steps: each formula, evaluated, is what core has calculated, whichever input moves."""

import ast
import json
import math
from collections.abc import Iterator
from copy import deepcopy
from pathlib import Path
from typing import Any

import httpx
import pytest
from pydantic import TypeAdapter, ValidationError

from app.endpoint import answered
from app.examples import EXAMPLES
from app.model import RequestModel, ResponseModel
from app.problems import Problem
from app.registry import CALCULATIONS
from app.units import core_name, suffix, to_si
from core.worked import words
from core.worked.step import names_of
from core.worked.words import OTHERS, VALUES
from tests.app.worked_designs import REQUESTS
from tests.oracles.formula import value_of

ROOT = Path(__file__).parents[2]
CASES = REQUESTS | {
    each["id"]: (each["calculation"], each["input"])
    for each in EXAMPLES
    if getattr(CALCULATIONS[each["calculation"]].request, "steps", None)
    not in (None, RequestModel.steps)
}
LEFT = 1e-15  # of what cancels, in SI units, in the place of 0


def steps_of(calculation: str, body: dict[str, Any]) -> list[dict[str, Any]]:
    asked = CALCULATIONS[calculation]
    include = [*body.get("include", []), "worked"]
    if calculation == "crank-planetary" and "include" not in body:
        include = ["worked"]
    request = TypeAdapter(asked.request).validate_json(json.dumps(body | {"include": include}))
    found: list[dict[str, Any]] = answered(asked, request)["worked"]
    return found


def check(steps: list[dict[str, Any]]) -> None:
    """Each step is a formula of two names or more that gives its result, or a method."""
    for step in steps:
        words_of = f"{step['section']} {step['code']} {step['symbol']}"
        assert ("formula" in step) != ("method" in step), words_of
        assert set(step["names"]) == set(step["values"]), words_of
        if "method" in step:
            continue
        names, formula = step["names"], step["formula"]
        assert formula.isascii() and len(names) >= 2, words_of
        assert set(names) == set(names_of(formula)), words_of
        values = {name: to_si(names[name], value) for name, value in step["values"].items()}
        wanted = to_si(step["code"], step["result"])
        found = value_of(formula, values)
        left = 0.0 if wanted else LEFT
        assert math.isclose(found, wanted, rel_tol=1e-9, abs_tol=left), (words_of, found, wanted)


def descendants(kind: type[Any]) -> Iterator[type[Any]]:
    """Models that descend from one."""
    for each in kind.__subclasses__():
        yield each
        yield from descendants(each)


def numbers(body: Any, path: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    """Paths of the numbers of a request that may move a little."""
    items = body.items() if isinstance(body, dict) else enumerate(body)
    for key, value in items:
        if isinstance(value, float):
            yield (*path, key)
        elif isinstance(value, (dict, list)):
            yield from numbers(value, (*path, key))


def moved(body: dict[str, Any], paths: list[tuple[Any, ...]]) -> dict[str, Any]:
    """The request with these numbers a hundredth larger, or a little more, each by another part."""
    other = deepcopy(body)
    for place, path in enumerate(paths):
        inner: Any = other
        for key in path[:-1]:
            inner = inner[key]
        inner[path[-1]] *= 1.01 + 1e-4 * place
    return other


def refused(calculation: str, body: dict[str, Any], paths: list[tuple[Any, ...]]) -> int:
    """How many numbers may not move alone: the others move with as many as leave the same steps."""
    codes = [step["code"] for step in steps_of(calculation, body)]

    def count(paths: list[tuple[Any, ...]]) -> int:
        half = len(paths) // 2
        try:
            steps = steps_of(calculation, moved(body, paths))
        except (ValidationError, Problem):  # no such reliability, lengths that do not add up
            return count(paths[:half]) + count(paths[half:]) if half else 1
        if half and [step["code"] for step in steps] != codes:
            return count(paths[:half]) + count(paths[half:])
        check(steps)
        return 0

    return count(paths)


@pytest.mark.parametrize(
    "case",
    [pytest.param(each, marks=[pytest.mark.slow] * (each == "cycloid")) for each in CASES],
)
def test_every_formula_gives_the_result(case: str) -> None:
    check(steps_of(*CASES[case]))


@pytest.mark.slow
@pytest.mark.parametrize("case", REQUESTS)
def test_every_formula_follows_the_inputs(case: str) -> None:
    """Inputs that move by a hundredth move core's numbers, and the formulas with them."""
    calculation, body = REQUESTS[case]
    paths = [*numbers(body)]
    assert 4 * refused(calculation, body, paths) < len(paths)


def test_a_wrong_formula_is_found() -> None:
    steps = steps_of(*REQUESTS["force"])
    first = next(step for step in steps if step.get("formula") == "T/R")
    first["formula"] = "T*R"
    with pytest.raises(AssertionError):
        check(steps)


def test_a_step_has_what_the_answer_has() -> None:
    asked = CALCULATIONS["hertz"]
    body = REQUESTS["hertz"][1] | {"include": ["worked"]}
    answer = asked.answered(TypeAdapter(asked.request).validate_json(json.dumps(body)))
    worked = {step["code"]: step["result"] for step in answer["worked"]}
    results = {name for name in answer if isinstance(answer[name], float)}
    assert results <= {*worked}
    for name in results & set(worked):
        assert worked[name] == answer[name], name


@pytest.mark.parametrize("calculation", CALCULATIONS)
def test_nothing_is_worked_unless_asked(calculation: str) -> None:
    for name, body in REQUESTS.values():
        if name == calculation:
            asked = CALCULATIONS[name]
            request = TypeAdapter(asked.request).validate_json(json.dumps(body))
            if name != "crank-planetary" or "include" in body:
                assert "worked" not in asked.answered(request)


def test_what_cannot_be_is_not_worked() -> None:
    """A mechanism with a dead centre has its cyclogram and no force."""
    body = {
        "mechanism": {"pins": 1, "satellites": 2, "ratio": 61.0, "crank_spacing_deg": 90.0},
        "load": {"output_torque_Nm": 50.0, "pin_circle_radius_mm": 30.0},
        "include": ["checks"],
    }
    assert {step["section"] for step in steps_of("crank-planetary", body)} == {"cyclogram"}


def test_every_text_and_unit_is_used() -> None:
    said = {"solved", "simulated", "of_distances", "root"}  # of app.worked.stated
    for file in (ROOT / "core" / "worked").glob("[!w]*.py"):
        for node in ast.walk(ast.parse(file.read_text())):
            if isinstance(node, ast.Constant) and isinstance(node.value, str):
                said.add(node.value)
    named = {core_name(name) for name in (*VALUES, *OTHERS.split())}
    for table in (named, words.NOTES, words.ERRATA, words.SOURCES):
        assert set(table) <= said, set(table) - said


def test_quantities_of_several_units_say_which() -> None:
    """A quantity has the unit of the field that it is, if all such fields have one unit."""
    units: dict[str, set[str]] = {}
    for kind in (RequestModel, ResponseModel):
        for model in descendants(kind):
            for name in model.model_fields:
                units.setdefault(core_name(name), set()).add(suffix(name))
    said = {core_name(name) for name in (*VALUES, *OTHERS.split())}
    for calculation, body in REQUESTS.values():
        for step in steps_of(calculation, body):
            for name in (step["code"], *step["names"].values()):
                assert core_name(name) in said or len(units[core_name(name)]) == 1, name


@pytest.mark.anyio
async def test_every_code_has_words(api: httpx.AsyncClient) -> None:
    titles = (await api.get("words")).json()
    for calculation, body in REQUESTS.values():
        for step in steps_of(calculation, body):
            for field in ("note", "method"):
                if field in step:
                    assert step[field] in titles["worked_notes"]
            if "source" in step:
                assert step["source"] in titles["worked_sources"]
            if "erratum" in step:
                assert step["erratum"] in titles["worked_errata"]


PLAY = {
    "mechanism": {"pins": 3, "satellites": 1, "ratio": 20.0},
    "load": {"output_torque_Nm": 50.0, "pin_circle_radius_mm": 30.0},
    "contact": {
        "contact_length_mm": 10.0,
        "pin_radius_mm": 5.0,
        "hole_radius_mm": 7.02,
        "eccentricity_mm": 2.0,
    },
}
SOLVED: dict[str, tuple[dict[str, Any], str, str]] = {
    "load-sharing": (PLAY, "rotation_arcmin", "solved"),
    "tolerance-study": (
        PLAY
        | {
            "tolerances": {"pin_position_mm": 0.01},
            "quantities": ["peak_force_N"],
            "samples": 20,
            "crank_angles": 12,
        },
        "peak_force_N",
        "simulated",
    ),
    "solve": (
        {
            "calculation": "hertz",
            "input": REQUESTS["hertz"][1],
            "variable": {"pointer": "/pin_radius_mm", "from": 5.0, "to": 9.0},
            "target": {"pointer": "/max_pressure_MPa", "at_most": 600.0},
        },
        "pin_radius_mm",
        "root",
    ),
}


@pytest.mark.parametrize("calculation", SOLVED)
def test_what_is_solved_says_how(calculation: str) -> None:
    body, code, method = SOLVED[calculation]
    steps = steps_of(calculation, body)
    check(steps)
    assert {step["method"] for step in steps} == {method}
    assert code in {step["code"] for step in steps}
    assert method in words.NOTES


def test_every_calculation_is_worked() -> None:
    """Exceptions are studies of methods and searches, which concern numbers of others."""
    without = {"propose", "sensitivity", "sweep", "work-precision"}
    for name, calculation in CALCULATIONS.items():
        fields = getattr(calculation.request, "model_fields", {})
        assert ("worked" in str(fields.get("include"))) == (name not in without), name
        assert ("worked" in calculation.answer.model_fields) == (name not in without), name
