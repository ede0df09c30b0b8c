"""Real reducers by catalogue and published data: what the service says of each.

`tests/inputs/catalogue.json` has of each reducer its rating, its document, a body for
`POST /crank-planetary`, and for every number of the body where in the document it stands, or
``assumed:`` and why. Where a document gives a number that the service calculates too, it stands in
`result`: its value, where the answer has it, the factor between the two models where they differ
knowingly, how far they may be apart, and why. Where teeth undercut nothing of forces is answered:
sections in `result_without` are then left out.
"""

import json
from collections import Counter
from collections.abc import Iterator
from contextlib import closing
from pathlib import Path
from typing import Any, get_args

import pytest

from core.checks.check import Outcome
from tests.inputs.in_process import Service

CATALOGUE: list[dict[str, Any]] = json.loads(
    Path(__file__).parent.parent.joinpath("inputs/catalogue.json").read_text(encoding="utf-8")
)
KINDS = {"cyclo frame", "robot joint", "printed", "winch", "involute", "paper"}
ASSUMED = "assumed: "

each = pytest.mark.parametrize("reducer", CATALOGUE, ids=lambda reducer: reducer["name"])


def numbers_of(value: Any, pointer: str = "") -> Iterator[str]:
    """JSON pointers to all numbers of a body."""
    if isinstance(value, dict):
        for name, inner in value.items():
            yield from numbers_of(inner, f"{pointer}/{name}")
    elif isinstance(value, list):
        for place, inner in enumerate(value):
            yield from numbers_of(inner, f"{pointer}/{place}")
    elif isinstance(value, int | float) and not isinstance(value, bool):
        yield pointer


def at(answer: Any, pointer: str) -> Any:
    """Value at a JSON pointer."""
    for name in pointer.split("/")[1:]:
        answer = answer[int(name) if isinstance(answer, list) else name]
    return answer


@pytest.fixture(scope="module")
def service() -> Iterator[Service]:
    """One service for all of them."""
    with closing(Service()) as running:
        yield running


def test_there_are_enough_and_of_many_kinds() -> None:
    assert len(CATALOGUE) >= 31
    names = Counter(reducer["name"] for reducer in CATALOGUE)
    assert [name for name, count in names.items() if count > 1] == []
    kinds = {reducer["kind"] for reducer in CATALOGUE}
    assert kinds <= KINDS
    assert len(kinds) >= 5


def test_more_is_cited_than_assumed() -> None:
    words = [word for reducer in CATALOGUE for word in reducer["numbers"].values()]
    assert sum(word.startswith(ASSUMED) for word in words) < len(words) / 2


@each
def test_every_number_has_its_place_in_the_document_or_a_reason(reducer: dict[str, Any]) -> None:
    assert set(numbers_of(reducer["body"])) == set(reducer["numbers"])
    for word in reducer["numbers"].values():
        assert word.removeprefix(ASSUMED).strip()
    assert reducer["rating_Nm"] > 0
    assert reducer["rating_of"]
    assert reducer["document"]


@each
def test_it_is_answered(service: Service, reducer: dict[str, Any]) -> None:
    status, answer = service.post("crank-planetary", reducer["body"] | {"include": ["checks"]})
    assert status == 200, answer
    assert answer["verdict"] in get_args(Outcome)


@each
def test_numbers_of_the_document_are_those_of_the_service(
    service: Service, reducer: dict[str, Any]
) -> None:
    results = reducer.get("result", [])
    if not results:
        return
    without = reducer.get("result_without", [])
    body = {name: each for name, each in reducer["body"].items() if name not in without}
    status, answer = service.post("crank-planetary", body)
    assert status == 200, answer
    for result in results:
        assert result["why"]
        expected = result["value"] * result.get("factor", 1.0)
        found = at(answer, result["pointer"])
        assert found == pytest.approx(expected, rel=result["tolerance"]), result["what"]
