"""One code for a fact: in one place, said somewhere, with the name that it had before."""

import re
from dataclasses import replace
from pathlib import Path

import pytest

from app.calculations.checks import check_values
from app.examples import REQUESTS
from app.model import warning
from app.problems import OF_REQUESTS, TEXTS, refusal
from app.registry import CALCULATIONS
from app.units import IN_MILLIMETRES
from core.checks.check import Check
from core.checks.records import CHECKS
from core.codes import CODES, REFUSALS, WARNINGS, WAS, checks, refusals
from core.codes.given import OF_INPUT
from core.codes.limits import OF_RESULTS
from core.codes.reasons import UNKNOWN
from core.errors import Notice

ROOT = Path(__file__).parents[2]
TABLES = (refusals.INVALID, refusals.IMPOSSIBLE, UNKNOWN, OF_INPUT, OF_RESULTS, checks.CHECKS)

CURRENT = {**CODES, **CHECKS, **OF_REQUESTS}

BY_PYDANTIC = {
    *(
        "bool_type",
        "dict_type",
        "extra_forbidden",
        "float_type",
        "int_type",
        "list_type",
        "missing",
    ),
    *("multiple_of", "string_type", "string_unicode"),
}
"""Codes of requests that pydantic raises by these names."""


def named(text: str) -> dict[str, int]:
    """Some parameters of a text."""
    return dict.fromkeys(re.findall(r"{(\w+)", text), 1)


def test_no_code_stands_twice() -> None:
    assert len(CODES) == sum(map(len, TABLES))
    assert {*CODES} & {*CHECKS} == {code for code, each in CODES.items() if each.kind == "check"}
    assert not {*OF_REQUESTS} & ({*CODES} | {*CHECKS})
    assert {*IN_MILLIMETRES} < {*REFUSALS} < {*TEXTS}
    assert not {*WARNINGS} & {*REFUSALS}


def test_a_warning_has_all_its_words_and_no_other_code_has_any() -> None:
    for code, each in CODES.items():
        words = [bool(text) for text in (each.title, each.tests, each.why, each.mend)]
        assert each.text and len({*words}) == 1, code
        assert words[0] or each.kind != "limit", code


def test_every_code_is_said_somewhere() -> None:
    sources = [
        path.read_text()
        for room in ("core", "app")
        for path in (ROOT / room).rglob("*.py")
        if "codes" not in path.parts
    ]
    named = r'(?:"|\b[a-z]+=)(\w+)(?=[" ])'  # alone, or of a sort of check in its element's row
    said = {name for text in sources for name in re.findall(named, text)}
    tables = [path for path in sources if "OF_REQUESTS = {" in path]
    assert len(tables) == 1  # which names its codes itself
    of_requests = {code for code in OF_REQUESTS if sum(t.count(f'"{code}"') for t in sources) > 1}
    assert {*CODES} | {*CHECKS} <= said
    assert {*OF_REQUESTS} <= of_requests | BY_PYDANTIC


def test_what_a_code_was_called_is_no_code_of_today() -> None:
    for table in WAS.values():
        known = {*CHECKS} if table is WAS["checks"] else {*CODES}
        assert {*table} <= known and not {*table.values()} & {*CURRENT}
    assert {*WAS["warnings"]} <= {*WARNINGS}


@pytest.mark.parametrize(("code", "was"), WAS["warnings"].items())
def test_a_warning_says_what_it_was_called(code: str, was: str) -> None:
    said = warning(Notice(code, named(CODES[code].text)))
    assert (said["code"], said["was"]) == (code, was)
    assert "{" not in said["detail"]


@pytest.mark.parametrize(("code", "was"), WAS["reasons"].items())
def test_a_reason_says_what_it_was_called(code: str, was: str) -> None:
    body = CALCULATIONS["crank-planetary"].request(**REQUESTS["crank-planetary"])
    text = IN_MILLIMETRES.get(code, CODES[code].text)
    lengths = {name.removesuffix("_mm"): value for name, value in named(text).items()}
    check = Check(CHECKS["lost_motion"], "not_checked", reason=code, params=lengths)
    reason = check_values(check, body, [])["reason"]
    assert (reason["code"], reason["was"]) == (code, was)
    assert "{" not in reason["detail"]


@pytest.mark.parametrize(("code", "was"), WAS["errors"].items())
def test_a_refusal_says_what_it_was_called(code: str, was: str) -> None:
    (error,) = refusal("/gaps_mm", code, **named(TEXTS[code])).body()["errors"]
    assert (error["code"], error["was"]) == (code, was)


@pytest.mark.parametrize(("code", "was"), WAS["checks"].items())
def test_a_check_says_what_it_was_called(code: str, was: str) -> None:
    body = CALCULATIONS["crank-planetary"].request(**REQUESTS["crank-planetary"])
    said = check_values(Check(CHECKS[code], "not_asked"), body, [])
    assert (said["code"], said["was"]) == (code, was)
    assert "was" not in check_values(Check(CHECKS["lost_motion"], "not_asked"), body, [])


def test_what_has_no_other_name_says_none() -> None:
    (error,) = refusal("/pins", "not_valid").body()["errors"]
    assert {*error} == {"pointer", "code", "params", "detail"}
    assert "was" not in warning(Notice("short_pin"))


def answer_with(*codes, checks=()):
    """An answer with a warning of each code, in a section too."""
    warnings = [{"code": code} for code in codes]
    answer = {"checks": [*checks], "hertz": {"warnings": [*warnings], "force": 1.0}}
    return answer | {"warnings": [*warnings]}


def test_no_warning_repeats_a_check() -> None:
    calculation = CALCULATIONS["hertz"]
    checks = ({"code": "wall_holes"}, {"code": "pin_fatigue", "reason": {"code": "notch_unknown"}})
    for told, left in (
        (("wall_holes", "short_pin"), ["short_pin"]),
        (("notch_unknown", "wall_holes"), None),
        (("pins_apart",), ["pins_apart"]),
    ):
        judged = replace(calculation, solve=lambda _, c=told: answer_with(*c, checks=checks))
        answer = judged.answered(calculation.request(**REQUESTS["hertz"]))
        for part in (answer, answer["hertz"]):
            assert [each["code"] for each in part.get("warnings", ())] == (left or [])
            assert ("warnings" in part) == (left is not None)
        unjudged = replace(calculation, solve=lambda _, c=told: answer_with(*c))
        answer = unjudged.answered(calculation.request(**REQUESTS["hertz"]))
        assert [each["code"] for each in answer["warnings"]] == [*told]
