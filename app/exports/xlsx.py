"""Any calculation as a spreadsheet: inputs, results, checks, curves, and worked steps whose cells
calculate.
"""

import ast
import io
import itertools
import math
from collections.abc import Iterator, Mapping
from datetime import UTC, datetime
from functools import cached_property
from typing import TYPE_CHECKING, Any, Literal, NamedTuple

import orjson
from pydantic import Field, TypeAdapter, ValidationError

from app.calculations.sweep import CALCULATION as SWEEP
from app.calculations.varied import JUDGED, VARIED, refused
from app.content import encoded
from app.exports.drawn import MADE_BY
from app.model import Export, File, RequestModel, Values
from app.problems import nested
from app.settings import Settings
from app.units import PLAIN, UNITS, shown_unit, suffix
from core.worked.words import NOTES, SOURCES

if TYPE_CHECKING:
    from xlsxwriter import Workbook
    from xlsxwriter.worksheet import Worksheet

    CalculationName = str
else:
    CalculationName = Literal[(*VARIED, SWEEP.name)]

CALCULATIONS = VARIED | {SWEEP.name: SWEEP}
"""Calculations that are answered as a spreadsheet."""

XLSX = "application/vnd.openxmlformats-officedocument.spreadsheetml.sheet"

MADE = datetime(2000, 1, 1, tzinfo=UTC)
"""Time in the files, which are the same each time."""

APART = ("checks", "worked")
"""Parts of an answer with sheets of their own."""

LEAST_ROWS = 8
"""Least length of lists that are a curve."""

CURVES_DRAWN = 12
"""Largest number of curves in a chart."""

HEADS = ("Section", "Name", "Quantity", "Symbol", "Unit", "Value")
"""Heads of the columns of quantities."""

VALUE = "F"
"""Column of values."""


class SheetRequest(RequestModel):
    """Calculation with its input."""

    calculation: CalculationName = Field(description="Name of the calculation.")
    input: dict[str, Any] = Field(description="Request of the calculation.")

    @property
    def stepped(self) -> bool:
        """True if worked steps are wanted."""
        return True

    @cached_property
    def asked(self) -> RequestModel:
        """Request of the calculation, with checks if it has them and with wanted worked steps; a
        problem if the calculation refuses it.
        """
        kind: TypeAdapter[RequestModel] = TypeAdapter(CALCULATIONS[self.calculation].request)
        try:
            plain = kind.validate_python(self.input)
            more = ["checks"] if self.calculation in JUDGED else []
            stepped = self.stepped and type(plain).steps is not RequestModel.steps
            more += ["worked"] if stepped else []
            if not more:
                return plain
            sections = getattr(plain, "sections", None) or getattr(plain, "include", None) or ()
            return kind.validate_python(
                self.input | {"include": [*dict.fromkeys([*sections, *more])]}
            )
        except ValidationError as error:
            raise refused(error) from None

    def refuse_beyond(self, settings: Settings) -> None:
        """Refuse what the calculation refuses by its fields."""
        with nested("/input", self.asked):
            self.asked.refuse_beyond(settings)

    @property
    def answer(self) -> Values:
        """Answer of the calculation, as it is sent; a problem if the calculation refuses it."""
        calculation = CALCULATIONS[self.calculation]
        with nested("/input", self.asked):
            return dict(orjson.loads(encoded(calculation.answered(self.asked))))


class Row(NamedTuple):
    """Quantity of a request or an answer."""

    path: tuple[str, ...]
    values: list[Any]  # one, or those of a list
    said: Mapping[str, Any]  # its words in the schema
    words: str  # name of its title there

    @property
    def cells(self) -> list[Any]:
        """Cells of the row."""
        *above, name = self.path
        words = self.said.get(self.words, "")
        symbol = self.said.get("x-symbol", "")
        return ["/".join(above), name, words, symbol, shown_unit(name), *self.values]


class Schema:
    """Words of a request's or an answer's quantities."""

    def __init__(self, kind: Any, words: Literal["title", "description"]) -> None:
        self.whole, self.words = TypeAdapter(kind).json_schema(), words

    def rows(self, value: Any, said: Any = None, path: tuple[str, ...] = ()) -> Iterator[Row]:
        """Quantities within a value, those that stand alone before those of sections; curves are no
        quantities.
        """
        said = self.whole if said is None else said
        if isinstance(value, dict):
            if path and _curve(value):
                return
            for name, each in sorted(value.items(), key=_deep):
                yield from self.rows(each, self._within(said, name), (*path, name))
        elif isinstance(value, list) and any(isinstance(each, list) for each in value):
            return  # points of a drawing
        elif isinstance(value, list) and any(isinstance(each, dict) for each in value):
            for number, each in enumerate(value, 1):
                yield from self.rows(each, self._within(said, None), (*path, str(number)))
        elif value not in (None, []):
            values = value if isinstance(value, list) else [value]
            yield Row(path, values, self._own(said), self.words)

    def _own(self, said: Any) -> Mapping[str, Any]:
        return next((each for each in self._kinds(said) if "title" in each), {})

    def _kinds(self, said: Any) -> Iterator[Mapping[str, Any]]:
        """Schemas of the kinds that a value may have, the words of a field first."""
        yield said
        if "$ref" in said:
            yield from self._kinds(self.whole["$defs"][said["$ref"].rpartition("/")[2]])
        for each in (*said.get("anyOf", ()), *said.get("oneOf", ()), *said.get("allOf", ())):
            yield from self._kinds(each)

    def _within(self, said: Any, name: str | None) -> Mapping[str, Any]:
        """Schema of a field, or of the entries of a list."""
        for each in self._kinds(said):
            found = each.get("items") if name is None else each.get("properties", {}).get(name)
            if found:
                return dict(found)
        return {}


def _deep(item: tuple[str, Any]) -> bool:
    return isinstance(item[1], (dict, list))


def _curve(value: Mapping[str, Any]) -> dict[str, list[Any]]:
    """Columns of a table of curves, angles first; empty for other values."""
    columns = dict[str, list[Any]]()
    for name, each in value.items():
        many = isinstance(each, list) and each and isinstance(each[0], list)
        rows = each if many else [each]
        for number, one in enumerate(rows if isinstance(each, list) else []):
            if len(one) >= LEAST_ROWS and not isinstance(one[0], (dict, list)):
                columns[f"{name} {number + 1}" if many else name] = one
    lengths = {len(each) for each in columns.values()}
    if len(columns) < 2 or len(lengths) > 1:
        return {}
    return dict(sorted(columns.items(), key=lambda each: suffix(each[0]) != "deg"))


def _curves(value: Any, path: tuple[str, ...] = ()) -> Iterator[tuple[str, dict[str, list[Any]]]]:
    """Tables of curves of an answer by their sections."""
    if not isinstance(value, dict):
        return
    if found := _curve(value):
        yield " ".join(each for each in path if each != "curves") or "curves", found
    for name, each in value.items():
        if name not in APART:
            yield from _curves(each, (*path, name))


def _points(answer: Values) -> dict[str, list[Any]]:
    """Columns of a sweep: its axes, the last of which varies first, results and status."""
    axes = answer["axes"]
    points = itertools.product(*(each["values"] for each in axes))
    named = [each["pointer"] for each in axes]
    columns = zip(named, map(list, zip(*points, strict=True)), strict=True)
    return {**dict(columns), **answer["outputs"], "status": answer["status"]}


class Book:
    """Spreadsheet of a request and its answer."""

    def __init__(self, book: "Workbook", asked: SheetRequest, answer: Values) -> None:
        self.book, self.answer = book, answer
        self.head = book.add_format({"bold": True, "bottom": 1})
        self.live = book.add_format({"bg_color": "#FFF7D6"})
        self.small = book.add_format({"num_format": "0.0E+00"})
        self.inputs: list[tuple[str, float, str]] = []  # name, value and cell of each number
        calculation, given = CALCULATIONS[asked.calculation], asked.input
        swept = calculation is SWEEP
        rows = [*Schema(calculation.request, "title").rows(given)]
        if swept:
            own = CALCULATIONS[given["calculation"]].request
            rows = [each for each in rows if each.path[0] != "input"]
            rows += Schema(own, "title").rows(given["input"], path=("input",))
        self._quantities("Inputs", rows, live=True)
        parts = {name: each for name, each in answer.items() if name not in APART}
        if not swept:
            found = Schema(calculation.answer, "description").rows(parts)
            self._quantities("Results", [*found])
        if answer.get("checks"):
            self._checks()
        if answer.get("worked"):
            self._steps()
        for section, columns in [("sweep", _points(answer))] if swept else _curves(parts):
            self._table(section, columns)

    def _sheet(self, name: str, heads: tuple[str, ...], widths: tuple[float, ...]) -> "Worksheet":
        sheet = self.book.add_worksheet(name)
        sheet.write_row(0, 0, heads, self.head)
        sheet.freeze_panes(1, 0)
        for column, width in enumerate(widths):
            sheet.set_column(column, column, width)
        return sheet

    def _quantities(self, name: str, rows: list[Row], *, live: bool = False) -> None:
        sheet = self._sheet(name, HEADS, (24, 30, 44, 10, 10, 16))
        for place, row in enumerate(rows, 1):
            *words, value = row.cells[: len(HEADS)]
            sheet.write_row(place, 0, words)
            sheet.write(place, len(words), value, self.live if live else None)
            sheet.write_row(place, len(HEADS), row.values[1:])
            if live and isinstance(value, (int, float)):
                self.inputs.append((row.path[-1], float(value), f"Inputs!${VALUE}${place + 1}"))

    def _checks(self) -> None:
        heads = ("Check", "Status", "Value", "Keep", "Limit", "Unit", "Used", "Formula", "Source")
        sheet = self._sheet("Checks", heads, (48, 14, 14, 8, 14, 8, 10, 24, 60))
        for place, check in enumerate(self.answer["checks"], 1):
            value, limit, row = check.get("value"), check.get("limit"), place + 1
            below = check.get("keep", "below") == "below"
            sheet.write_row(place, 0, [check["title"], check["status"], value])
            sheet.write_row(place, 3, ["≤" if below else "≥", limit, check.get("unit", "")])
            if used := check.get("utilisation"):
                ratio = f"=C{row}/E{row}" if below else f"=E{row}/C{row}"
                if math.isclose(used, value / limit if below else limit / value):
                    sheet.write_formula(place, 6, ratio, None, used)
                else:
                    sheet.write(place, 6, used)
            sheet.write_row(place, 7, [check.get("formula", ""), check.get("source", "")])

    def _steps(self) -> None:
        heads = (
            *("Section", "Quantity", "Symbol", "Formula", "Calculated here", "Unit"),
            *("Of the service", "Difference", "Source"),
        )
        sheet = self._sheet("Worked steps", heads, (22, 34, 14, 48, 16, 10, 16, 12, 60))
        values = self._sheet("Values", ("Symbol", "Name", "Value", "Unit"), (14, 34, 16, 10))
        cells = dict[tuple[str, str], str]()
        for name, value, cell in self.inputs:
            cells.setdefault(_key(name, value), cell)
        known = 0
        for place, step in enumerate(self.answer["worked"], 1):
            row, result, code = place + 1, step["result"], step["code"]
            text = step.get("formula") or NOTES[step["method"]].format_map(step.get("params", {}))
            sheet.write_row(place, 0, [step["section"], code, step["symbol"], text])
            where = dict[str, str]()
            for symbol, name in step["names"].items() if "formula" in step else ():
                value = step["values"][symbol]
                if _key(name, value) not in cells:
                    known += 1
                    values.write_row(known, 0, [symbol, name, value, shown_unit(name)])
                    cells[_key(name, value)] = f"Values!$C${known + 1}"
                where[symbol] = cells[_key(name, value)] + _unit("*", name)
            if "formula" in step:
                live = f"={excel(step['formula'], where)}{_unit('/', code)}"
                sheet.write_formula(place, 4, live, self.live, result)
                sheet.write_formula(place, 7, f"=E{row}-G{row}", self.small, 0.0)
            else:
                sheet.write(place, 4, result)
            sheet.write_row(place, 5, [step["unit"], result])
            said = (SOURCES.get(step.get("source", "")), step.get("equation"))
            sheet.write(place, 8, ", ".join(filter(None, said)))
            cells[_key(code, result)] = f"'Worked steps'!$E${row}"

    def _table(self, section: str, columns: dict[str, list[Any]]) -> None:
        name = section[:31]
        sheet = self._sheet(name, tuple(columns), (16,) * len(columns))
        first, *others = columns
        for place, column in enumerate(columns.values()):
            sheet.write_column(1, place, column)
        drawn = [each for each in others if isinstance(columns[each][0], (int, float))]
        if not drawn:
            return
        chart = self.book.add_chart({"type": "scatter", "subtype": "straight"})
        last = len(columns[first])
        for each in drawn[:CURVES_DRAWN]:
            place = [*columns].index(each)
            ends = {"categories": [name, 1, 0, last, 0], "values": [name, 1, place, last, place]}
            chart.add_series({"name": each, **ends})
        chart.set_x_axis({"name": first})
        chart.set_size({"width": 800, "height": 420})
        sheet.insert_chart(1, len(columns) + 1, chart)


def _key(name: str, value: float) -> tuple[str, str]:
    """Name and value by which a number is found again, despite rounding of its unit."""
    return name, f"{value:.12g}"


def _unit(sign: str, name: str) -> str:
    """Factor of the unit of a name in SI units, after a sign; empty for SI units."""
    size = UNITS.get(suffix(name), PLAIN)[1]
    return "" if size == 1 else f"{sign}{size!r}"


SIGNS: dict[type[ast.AST], str] = {
    ast.Add: "+",
    ast.Sub: "-",
    ast.Mult: "*",
    ast.Div: "/",
    ast.Pow: "^",
    ast.USub: "-",
}
"""Signs of a spreadsheet by nodes of a formula."""


def excel(formula: str, cells: Mapping[str, str]) -> str:
    """Formula of a spreadsheet for one of a worked step, with the cells of its names.

    >>> excel("-a^2*sqrt(b)/pi", {"a": "A1", "b": "B2"})
    '(((-((A1)^2))*SQRT((B2)))/PI())'
    """

    def text(node: ast.AST) -> str:
        match node:
            case ast.BinOp():
                return f"({text(node.left)}{SIGNS[type(node.op)]}{text(node.right)})"
            case ast.UnaryOp():
                return f"({SIGNS[type(node.op)]}{text(node.operand)})"
            case ast.Call(func=ast.Name(id=name)):
                return f"{name.upper()}({','.join(map(text, node.args))})"
            case ast.Name(id=name):
                return "PI()" if name == "pi" else f"({cells[name]})"
            case ast.Constant():
                return repr(node.value)
        raise ValueError(formula)

    return text(ast.parse(formula.replace("^", "**"), mode="eval").body)


def write(body: SheetRequest) -> File:
    """Spreadsheet (XLSX) of a calculation: its inputs, results, checks and curves with charts, and
    the worked steps as formulas. Cells of inputs that closed formulas use may be changed; what is
    solved or searched is a number of the service.
    """
    import xlsxwriter  # slow import, needed for files only

    calculation = CALCULATIONS[body.calculation]
    answer, content = body.answer, io.BytesIO()
    plain = {"strings_to_formulas": False, "strings_to_urls": False, "strings_to_numbers": False}
    with xlsxwriter.Workbook(content, {"in_memory": True, **plain}) as book:
        book.set_properties({"title": calculation.title, "comments": MADE_BY, "created": MADE})
        Book(book, body, answer)
    return File(f"{calculation.name.replace('/', '-')}.xlsx", XLSX, content.getvalue())


EXPORT = Export(
    name="export/xlsx",
    title="Calculation as a spreadsheet",
    request=SheetRequest,
    write=write,
    media_types=(XLSX,),
)
