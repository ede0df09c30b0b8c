"""Requests of `make compare`, and differences that it finds between two answers."""

import json
from collections import Counter

import pytest

from benchmarks.compare import CORPUS, Difference
from tests.corpus.engine import CASES, STUDIES, engine

ANSWER = {
    "verdict": "pass",
    "checks": [{"code": "wall_holes", "value": 1.0, "why": "thin"}],
    "hertz": {"pressure": 500.0, "accuracy": {"relative_error": 1e-9, "run_time_us": 3.0}},
}


def compared(**changes) -> Difference:
    found = Difference()
    found.compare(ANSWER, ANSWER | changes)
    return found


def test_the_same_is_the_same() -> None:
    found = compared()
    assert found.differences == [] and found.worded == 0
    assert found.numbers == 2  # what it cost and its stated error are not counted


@pytest.mark.parametrize(
    ("changes", "place"),
    [
        ({"verdict": "fail"}, "/verdict"),
        ({"checks": []}, "/checks"),
        ({"checks": [ANSWER["checks"][0] | {"code": "pins_apart"}]}, "/checks/0/code"),
        ({"checks": [ANSWER["checks"][0] | {"value": 1 + 2e-6}]}, "/checks/0/value"),
        ({"hertz": ANSWER["hertz"] | {"pressure": 500.001}}, "/hertz/pressure"),
        ({"new": 1}, "/new"),
    ],
)
def test_what_differs_is_said_with_its_place(changes: dict, place: str) -> None:
    (said,) = compared(**changes).differences
    assert said.startswith(place + ":")


def test_numbers_may_differ_by_their_class_and_texts_are_counted() -> None:
    assert compared(hertz=ANSWER["hertz"] | {"pressure": 500.0001}).differences == []
    assert compared(checks=[ANSWER["checks"][0] | {"value": 1 + 5e-7}]).differences == []
    found = compared(checks=[ANSWER["checks"][0] | {"why": "a thin wall"}])
    assert found.differences == [] and found.worded == 1


@pytest.mark.parametrize(
    ("section", "allowed"),
    [
        ({"positions": [{"force_N": 1.0}]}, 1e-9),
        ({"positions": [{"rotation_arcmin": 1.0}]}, 1e-9),
        ({"curves": {"force_N": [[1.0]]}}, 1e-9),
        ({"ideal": {"peak_force_N": 1.0}}, 1e-9),
        ({"over_turn": {"peak_force_N": 1.0}}, 1e-6),
        ({"over_turn": {"transmission_error_arcmin": 1.0}}, 1e-6),
        ({"over_turn": {"transmission_error_arcmin": 1e-7}}, 1e-3),  # of 1e-4'
        ({"load_sharing": {"ring": {"max_pressure_MPa": 1.0}}}, 1e-6),
        ({"quantities": {"peak_force_N": {"percentiles": [{"value": 1.0}]}}}, 1e-6),
        ({"over_turn": {"peak_crank_angle_deg": 1.0}}, 1e-3),
    ],
)
def test_a_class_is_that_of_the_field_whatever_is_stated(section: dict, allowed: float) -> None:
    stated = {"accuracy": {"relative_error": 0.5}}
    for share, seen in ((0.7, 0), (1.3, 1)):
        found = Difference()
        found.compare(section | stated, scaled(section, 1 + share * allowed) | stated)
        assert len(found.differences) == seen


def scaled(value: object, factor: float) -> object:
    """All numbers of a part of an answer, so many times."""
    if isinstance(value, dict):
        return {name: scaled(each, factor) for name, each in value.items()}
    return [scaled(each, factor) for each in value] if isinstance(value, list) else value * factor


def test_a_small_number_of_a_list_is_compared_by_the_largest() -> None:
    forces = {"positions": [{"force_N": [[2000.0, 1e-3], [0.0, 50.0]]}]}
    for change, seen in ((1e-6, 0), (3e-6, 1)):
        found = Difference()
        moved = {"positions": [{"force_N": [[2000.0, 1e-3 + change], [0.0, 50.0]]}]}
        found.compare(forces, moved)
        assert len(found.differences) == seen


def said(after: dict, before: dict) -> Difference:
    found = Difference({"pins_apart": "pins_overlap", "wall_holes": "holes_overlap"})
    found.compare(before, after)
    return found


def test_a_code_is_the_same_by_what_it_says_that_it_was() -> None:
    old = {"warnings": [{"code": "pins_overlap", "params": {}, "detail": "overlap"}]}
    new = {"code": "pins_apart", "was": "pins_overlap", "params": {}, "detail": "overlap"}
    found = said({"warnings": [new]}, old)
    assert found.differences == [] and found.renamed == {"pins_overlap -> pins_apart": 1}
    assert said({"warnings": [new | {"was": "short_pin"}]}, old).differences
    assert said({"warnings": [{name: new[name] for name in new if name != "was"}]}, old).differences
    reason = {"reason": {"code": "jams", "detail": "in a part of the turn"}}
    named = {"reason": reason["reason"] | {"params": {"pin": 2}, "pointer": "/pins"}}
    found = said(named, reason)
    assert found.differences == [] and found.worded == 2


def test_a_warning_that_a_check_says_is_none() -> None:
    holes = {"code": "holes_overlap"}
    checks = [{"code": "wall_holes"}, {"code": "pin_fatigue", "reason": {"code": "notch_unknown"}}]
    before = {"checks": checks, "hertz": {"warnings": [{"code": "notch_unknown"}]}}
    after = {"checks": checks, "hertz": {}}
    found = said(after, before | {"warnings": [holes]})
    assert found.differences == []
    assert found.left_to_checks == {"holes_overlap": 1, "notch_unknown": 1}
    for other in ({"code": "short_pin"}, {"code": "pins_overlap"}):
        assert said(after, before | {"warnings": [other]}).differences == ["/warnings: only before"]
    assert said({"hertz": {}}, before | {"warnings": [holes]}).differences  # without its checks


def test_the_corpus() -> None:
    requests = json.loads(CORPUS.read_text(encoding="utf-8"))
    assert len(requests) == 600
    assert all({*each} - {"case"} == {"path", "body"} for each in requests)
    assert len({each["path"] for each in requests}) >= 14
    drawn = [each for each in requests if "case" in each]
    assert drawn == engine()  # which a seed gives again
    counts = Counter(each["case"] for each in drawn)
    assert counts == dict.fromkeys(CASES, 20) | {f"study of {x}": n for x, n in STUDIES.items()}
    assert counts.total() == 200
