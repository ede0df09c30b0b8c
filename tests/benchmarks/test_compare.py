"""What `make compare` sees of two answers."""

import json

import pytest

from benchmarks.compare import CORPUS, Difference

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
    assert found.numbers == 3  # what it cost is not counted


@pytest.mark.parametrize(
    ("changes", "place"),
    [
        ({"verdict": "fail"}, "/verdict"),
        ({"checks": []}, "/checks"),
        ({"checks": [ANSWER["checks"][0] | {"code": "pins_apart"}]}, "/checks/0/code"),
        ({"checks": [ANSWER["checks"][0] | {"value": 1 + 1e-11}]}, "/checks/0/value"),
        ({"hertz": ANSWER["hertz"] | {"pressure": 500.00001}}, "/hertz/pressure"),
        ({"new": 1}, "/new"),
    ],
)
def test_what_differs_is_said_with_its_place(changes: dict, place: str) -> None:
    (said,) = compared(**changes).differences
    assert said.startswith(place + ":")


def test_numbers_may_differ_by_what_is_stated_and_texts_are_counted() -> None:
    assert compared(hertz=ANSWER["hertz"] | {"pressure": 500.0000001}).differences == []
    found = compared(checks=[ANSWER["checks"][0] | {"why": "a thin wall"}])
    assert found.differences == [] and found.worded == 1


def test_a_stated_error_hides_no_more_than_a_millionth() -> None:
    rough = {"pressure": 500.0, "accuracy": {"relative_error": 0.5}}
    found = Difference()
    found.compare({"hertz": rough}, {"hertz": rough | {"pressure": 501.0}})
    assert found.differences and found.loose == ["/hertz"]


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
    assert len(requests) == 400
    assert all({*each} == {"path", "body"} for each in requests)
    assert len({each["path"] for each in requests}) >= 14
