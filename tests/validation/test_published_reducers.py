"""Reducers that were built: what docs/validation.md prints of each, against the service.

The document has of each reducer, which is an example of the page, a table of its inputs with their
sources, and one of published numbers beside ours. All of it is read here, so that the document
cannot say anything else than example and service do.
"""

import json
import re
from collections.abc import Iterator
from contextlib import closing
from decimal import Decimal
from pathlib import Path
from typing import Any, NamedTuple

import pytest

from app.examples import EXAMPLES
from tests.inputs.in_process import Service

DOCUMENT = Path(__file__).parents[2].joinpath("docs/validation.md").read_text(encoding="utf-8")
SECTION = re.compile(r"^## \d\. .*?\n\n`([\w-]+)`\. (.*?)(?=^## )", re.MULTILINE | re.DOTALL)
SECTIONS = dict(SECTION.findall(DOCUMENT))
INPUTS = {each["id"]: each["input"] for each in EXAMPLES}
POINTER = re.compile(r"`(/[\w/]+)`")
LEFT_OUT = "left out"


class Row(NamedTuple):
    """A published number beside ours."""

    what: str
    published: str
    ours: str
    quotient: str  # published over ours; empty where ours is 0
    pointer: str  # of the answer; checks by their codes
    change: str  # of the input; empty for the example as it stands


BOUNDS = {
    # Play that is drawn is the least that parts have; a print adds to it. More than three times of
    # it would not be of these clearances.
    "play as assembled, ′": (1, 3),
    "play after running in, ′": (1, 3),
    # Tenths of a millimetre are what printed holes are off by.
    "play as assembled, 0.15 mm in the holes, ′": (0.8, 1.2),
    # A rigid crank is not what was measured: it has to show.
    "stiffness as assembled, N·m/′": (0, 0.1),
    "the same with rigid pins, N·m/′": (0, 0.1),
    # The crank governs; its stiffness is of a modulus that is known to a factor of two, and the
    # parts that are left out can only take stiffness away.
    "the same on a printed crank, N·m/′": (0.5, 1),
    "after running in, on a printed crank, N·m/′": (0.5, 1),
    "on a printed crank, all of 7.5 GPa, N·m/′": (0.5, 1),
    # Bearings and cams lose besides: measured is below ours, unless friction is at its upper end.
    # "About 70 %" is known to 5 %.
    "efficiency, ours of the teeth": (0.8, 1),
    "the same, friction 0.35": (0.93, 1.07),
    # Ours is of the holes alone, the measured one of all; "about 2°" is known to a quarter.
    "backlash, holes as usual in print, ′": (1, 2.5),
    # A bearing with a quarter of the load for its rating: 50 N*m are not for long.
    "load of a bearing on a pin at 50 N·m, N": (0.2, 0.25),
    # No play of a print: not the same thing, and to be seen as such.
    "backlash, ′": (0, 0.01),
    "backlash, 0.001 mm in the holes alone, ′": (0.9, 1.1),
    # Friction is not printed: W's range of 0.05 to 0.1 moves ours by 6 %.
    "efficiency by the maker": (0.94, 1.06),
    "efficiency by Wang's (6)": (0.9, 1),
    "efficiency by Wang's (6), friction 0.1": (0.94, 1.06),
    "efficiency by Wang's (6), perfect teeth": (0.9, 1),
    # 1/(1 - x) for x = 4*mu*(D_p - d_p)/(pi*K_1*z_c*D_p) = 0.00226, printed to four digits.
    "loss of the teeth by Wang's (4) at 0.05": (1.0017, 1.0028),
}
"""Least and largest quotient of what was published over ours, and why."""


def tables(section: str) -> list[list[list[str]]]:
    """Rows of cells of both tables of a section, without their heads."""
    found = re.findall(r"(?:^\|.*\|\n)+", section, re.MULTILINE)
    return [
        [[cell.strip() for cell in line.strip("|").split("|")] for line in table.splitlines()[2:]]
        for table in found
    ]


def leaves(value: Any, pointer: str = "") -> Iterator[tuple[str, Any]]:
    """Values of a body by their JSON pointers."""
    if isinstance(value, dict):
        for name, inner in value.items():
            yield from leaves(inner, f"{pointer}/{name}")
    elif isinstance(value, list):
        for place, inner in enumerate(value):
            yield from leaves(inner, f"{pointer}/{place}")
    else:
        yield pointer, value


def changed(body: dict[str, Any], change: str) -> dict[str, Any]:
    """A copy of the body with what a row says of its input."""
    made: dict[str, Any] = json.loads(json.dumps(body))
    for part in change.split(";") if change else ():
        _, _, value = part.partition(" = ")
        for pointer in POINTER.findall(part):
            *above, last = pointer.split("/")[1:]
            section = made
            for name in above:
                section = section.setdefault(name, {})
            if value:
                section[last] = float(value)
            else:
                assert LEFT_OUT in part
                del section[last]
    return made


def at(answer: Any, pointer: str) -> float:
    """Number at a JSON pointer; checks by their codes."""
    for name in pointer.split("/")[1:]:
        if isinstance(answer, list):
            (answer,) = (each for each in answer if each["code"] == name)
        else:
            answer = answer[name]
    return float(answer)


ROWS = [
    pytest.param(name, Row(*cells), id=f"{name}-{cells[0]}")
    for name, section in SECTIONS.items()
    for cells in tables(section)[1]
]


@pytest.fixture(scope="module")
def service() -> Iterator[Service]:
    """One service for all of them."""
    with closing(Service()) as running:
        yield running


def test_there_are_at_least_three_and_each_is_an_example() -> None:
    assert len(SECTIONS) >= 3
    cited = {each["id"] for each in EXAMPLES if each["source"].startswith("docs/validation.md")}
    assert set(SECTIONS) == cited


@pytest.mark.parametrize("name", SECTIONS)
def test_every_input_has_its_source_or_is_ours(name: str) -> None:
    said = {}
    for cell, value, source in tables(SECTIONS[name])[0]:
        (pointer,) = POINTER.findall(cell)
        assert source.removeprefix("ours:").strip(), pointer
        said[pointer] = value
    given = dict(leaves(INPUTS[name]))
    assert set(said) == set(given)
    for pointer, value in given.items():
        same = said[pointer] if isinstance(value, str) else json.loads(said[pointer])
        assert same == value, pointer


@pytest.mark.parametrize(("name", "row"), ROWS)
def test_ours_is_what_the_service_answers(service: Service, name: str, row: Row) -> None:
    (pointer,) = POINTER.findall(row.pointer)
    body = changed(INPUTS[name], row.change)
    status, answer = service.post("crank-planetary", body | {"include": [pointer.split("/")[1]]})
    assert status == 200, answer
    found, printed = at(answer, pointer), Decimal(row.ours)
    last_digit = 10.0 ** int(printed.as_tuple().exponent)
    assert abs(found - float(printed)) <= last_digit / 2, found
    if not row.quotient:
        assert found == 0
        return
    low, high = BOUNDS[row.what]
    quotient, published = Decimal(row.quotient), float(row.published)
    assert abs(published / found - float(quotient)) <= 10.0 ** int(quotient.as_tuple().exponent) / 2
    assert low <= published / found <= high


def test_every_bound_is_used() -> None:
    with_quotient = {row.what for _, row in (param.values for param in ROWS) if row.quotient}  # type: ignore[misc]
    assert with_quotient == set(BOUNDS)


def test_every_file_of_validation_is_named() -> None:
    here = {f"tests/validation/{each.name}" for each in Path(__file__).parent.glob("test_*.py")}
    named = set(re.findall(r"`(tests/validation/\w+\.py)`", DOCUMENT))
    assert named == here - {f"tests/validation/{Path(__file__).name}"}
