"""Spreadsheets, read back: cells are the service's numbers, and formulas, calculated here by an
evaluator of their own, give them and follow the inputs.
"""

import io
import math
import re
from collections.abc import Iterator
from typing import Any

import openpyxl
import pytest

from app.examples import EXAMPLES, REQUESTS
from app.exports.xlsx import CALCULATIONS
from core.precision import EXACT

pytestmark = pytest.mark.anyio

PATH = "export/xlsx"
CELL = re.compile(r"(?:(?:'([^']+)'|([A-Za-z]+))!)?\$?([A-Z]{1,2})\$?(\d+)")
KNOWN = {
    "SQRT": math.sqrt,
    "SIN": math.sin,
    "COS": math.cos,
    "TAN": math.tan,
    "ASIN": math.asin,
    "ACOS": math.acos,
    "ATAN": math.atan,
    "ABS": abs,
    "MIN": min,
    "MAX": max,
    "PI": lambda: math.pi,
}
WHOLE = {each["id"]: each["input"] for each in EXAMPLES}


class Calculated:
    """A workbook whose formulas are calculated, with cells that are set."""

    def __init__(self, content: bytes) -> None:
        self.book = openpyxl.load_workbook(io.BytesIO(content))
        self.known: dict[tuple[str, str], Any] = {}

    def __call__(self, sheet: str, cell: str) -> Any:
        if (sheet, cell) not in self.known:
            value = self.book[sheet][cell].value
            if isinstance(value, str) and value.startswith("="):
                value = self._result(sheet, value[1:])
            self.known[sheet, cell] = value
        return self.known[sheet, cell]

    def _result(self, sheet: str, formula: str) -> float:
        names: dict[str, Any] = {}

        def read(found: re.Match[str]) -> str:
            quoted, plain, column, row = found.groups()
            names[f"c{len(names)}"] = self(quoted or plain or sheet, column + row)
            return f"c{len(names) - 1}"

        text = CELL.sub(read, formula).replace("^", "**")
        return float(eval(text, {"__builtins__": {}}, KNOWN | names))

    def set(self, sheet: str, name: str, value: float) -> None:
        """Set the value in the row of a name, and forget what was calculated."""
        (row,) = (each for each in self.book[sheet].iter_rows() if each[1].value == name)
        row[5].value = value
        self.known.clear()

    def rows(self, sheet: str) -> Iterator[list[Any]]:
        """Rows below the heads, with results in the place of formulas."""
        for row in self.book[sheet].iter_rows(min_row=2):
            yield [self(sheet, each.coordinate) for each in row]


async def book(api: Any, calculation: str, body: Any) -> Calculated:
    response = await api.post(PATH, json={"calculation": calculation, "input": body})
    assert response.status_code == 200, response.text
    named = f'attachment; filename="{calculation.replace("/", "-")}.xlsx"'
    assert response.headers["content-disposition"] == named
    return Calculated(response.content)


@pytest.mark.parametrize(
    ("calculation", "body"),
    [
        ("hertz", REQUESTS["hertz"]),
        ("roller-strength", REQUESTS["roller-strength"]),
        ("precession/shaft-deflection", REQUESTS["precession/shaft-deflection"]),
        pytest.param("crank-planetary", WHOLE["cycloid"], marks=pytest.mark.slow),
        pytest.param("crank-planetary", WHOLE["involute"], marks=pytest.mark.slow),
    ],
)
async def test_formulas_give_the_numbers_of_the_service(
    api: Any, calculation: str, body: Any
) -> None:
    found = await book(api, calculation, body)
    live = 0
    for row in found.book["Worked steps"].iter_rows(min_row=2):
        ours, theirs = found("Worked steps", row[4].coordinate), row[6].value
        assert ours == pytest.approx(theirs, rel=EXACT, abs=1e-12), row[1].value
        live += str(row[4].value).startswith("=")
    assert live > 4


@pytest.mark.slow
@pytest.mark.parametrize(
    ("calculation", "body"),
    [
        *((name, REQUESTS[name]) for name in CALCULATIONS),
        *((each["calculation"], each["input"]) for each in EXAMPLES),
    ],
    ids=[*CALCULATIONS, *WHOLE],
)
async def test_every_request_and_example_is_a_spreadsheet_without_gaps(
    api: Any, calculation: str, body: Any
) -> None:
    if calculation == "crank-planetary":
        body = body | {"load": body["load"] | {"include": ["curves", "equal_sharing"]}}
    found = await book(api, calculation, body)
    for sheet in found.book.sheetnames:
        assert not [each for row in found.rows(sheet) for each in row if "{" in str(each)]


async def test_formulas_follow_the_inputs(api: Any) -> None:
    body = REQUESTS["hertz"]
    found = await book(api, "hertz", body)
    other = body | {"force_N": 5000.0, "pin_radius_mm": 7.5, "contact_length_mm": 18.0}
    for name in ("force_N", "pin_radius_mm", "contact_length_mm"):
        found.set("Inputs", name, other[name])
    answer = await api.answer("hertz", other)
    steps = {row[1]: row[4] for row in found.rows("Worked steps")}
    for name in ("max_pressure_MPa", "half_width_mm", "reduced_radius_mm"):
        assert steps[name] == pytest.approx(answer[name], rel=EXACT)


async def test_inputs_results_checks_and_curves_are_those_of_the_answer(api: Any) -> None:
    body = WHOLE["cycloid"]
    body = body | {"load": body["load"] | {"include": ["curves"]}}
    found = await book(api, "crank-planetary", body)
    asked = ["contact_force", "load_sharing", "hertz", "checks"]
    answer = await api.answer("crank-planetary", body | {"include": asked})
    inputs = {(row[0], row[1]): row for row in found.rows("Inputs")}
    assert inputs["load", "output_torque_Nm"][2:6] == ["Output torque", "T", "N·m", 200.0]
    places = inputs["pin", "satellite_positions_mm"]
    assert places[4:7] == ["mm", 13.0, 37.0]
    results = {(row[0], row[1]): row[5] for row in found.rows("Results")}
    assert results[None, "verdict"] == answer["verdict"]
    pressure = answer["hertz"]["max_pressure_MPa"]
    assert results["hertz", "max_pressure_MPa"] == pytest.approx(pressure, rel=EXACT)
    checks = {row[0]: row for row in found.rows("Checks")}
    for check in answer["checks"]:
        row = checks[check["title"]]
        assert row[1] == check["status"]
        assert row[2] == (pytest.approx(check["value"], rel=EXACT) if "value" in check else None)
        if "utilisation" in check:
            assert row[6] == pytest.approx(check["utilisation"], rel=EXACT)
    curves = answer["contact_force"]["curves"]
    rows = [*found.rows("contact_force")]
    assert [row[0] for row in rows] == pytest.approx(curves["crank_angle_deg"], rel=EXACT)
    assert [row[7] for row in rows] == pytest.approx(curves["force_N"][6], rel=EXACT)
    assert len(found.book["load_sharing"]._charts) == 1


async def test_a_sweep_is_a_table_of_its_points(api: Any) -> None:
    body = REQUESTS["sweep"]
    found, answer = await book(api, "sweep", body), await api.answer("sweep", body)
    rows = [*found.rows("sweep")]
    assert [row[:2] for row in rows[:4]] == [[4.0, 3], [4.0, 4], [4.0, 6], [6.0, 3]]
    used = answer["outputs"]["/checks/governing/utilisation"]
    for row, each in zip(rows, used, strict=True):
        assert row[2] == (each and pytest.approx(each, rel=EXACT))
    assert [row[-1] for row in rows] == answer["status"]


async def test_what_the_calculation_refuses_is_refused_at_its_field(api: Any) -> None:
    wrong = REQUESTS["hertz"] | {"force_N": -1.0}
    assert await api.refusal(PATH, {"calculation": "hertz", "input": wrong}) == (
        "/input/force_N",
        "greater_than_equal",
    )
    own = REQUESTS["crank-planetary"]
    wide = own | {"contact": own["contact"] | {"pin_radius_mm": 40.0}}
    assert await api.refusal(PATH, {"calculation": "crank-planetary", "input": wide}) == (
        "/input/contact/hole_radius_mm",
        "larger_than",
    )
    unknown = {"calculation": "propose", "input": {}}
    assert (await api.refusal(PATH, unknown))[0] == "/calculation"
