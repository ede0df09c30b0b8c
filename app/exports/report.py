"""Report of a calculation: verdict, drawing, checks, inputs, results, curves, as HTML or PDF."""

import re
import unicodedata
from collections.abc import Iterator, Sequence
from contextlib import suppress
from functools import cache, cached_property, partial
from pathlib import Path
from typing import Annotated, Any, NamedTuple, NoReturn

from pydantic import Field, TypeAdapter, ValidationError

from app.calculations.crank_planetary_sections import CrankPlanetaryRequest
from app.exports.drawn import MADE_BY
from app.exports.dxf import DxfRequest, TitleBlock
from app.exports.picture import picture
from app.exports.plot import Plot
from app.exports.xlsx import CALCULATIONS, Row, Schema, SheetRequest
from app.model import Export, File, RequestModel, Values
from app.pointers import keys
from app.problems import Problem
from app.units import shown_unit
from app.words import ALL, Language, Words, digits_of
from core.errors import CalculationError

HTML, PDF = "text/html", "application/pdf"

CRANK, SWEEP = "crank-planetary", "sweep"

ASKING = ("include", "fixes_for")
"""Fields of requests that are no inputs."""

DRAWN = ("assembly", "satellite_1")
"""Parts of which the first one that is known is drawn."""

JUDGED = ("pass", "marginal", "fail")
"""Statuses of checks and parts that are judged."""

NO_RESULTS = frozenset(
    (
        *("accuracy", "checks", "counts", "fit", "fixes", "governing", "largest_torque_Nm"),
        *("largest_torque_of", "not_considered", "assumed", "parts", "verdict", "warnings"),
        *("worked", "not_used", "torque_reserve", "cold_yield"),
    )
)
"""Parts of an answer that are said elsewhere, or are no results."""

PARTED = ("x", "y", "z", "total")
"""Parts of a result that are shown together."""

MOST_OF_A_LIST = 4
"""Largest number of entries of a list among the results."""

MARKS = {"pass": "✓", "marginal": "!", "fail": "✗", "open": "?", "not_checked": "?"}
"""Signs of statuses, which do not rely on colours."""

HEADINGS = {
    "mechanism": ("group", "reducer"),
    "contact": ("group", "pins"),
    "pin": ("section", "pin_strength"),
    "fatigue": ("own", "endurance.on", "title"),
    "friction": ("section", "output_efficiency"),
    "gear": ("section", "ring_mesh"),
    "bearing": ("section", "satellite_bearing"),
    "crankshaft": ("section", "crankshaft"),
    "rollers": ("section", "rollers"),
    "build": ("section", "envelope"),
    "wheel": ("group", "rollers"),
    "shaft_sections": ("group", "shaft"),
    "tolerances": ("own", "study.on", "title"),
    "deviations": ("own", "real.on", "title"),
    "contact_law": ("own", "teeth.contact_law", "title"),
}
"""Keys of the headings of a document's sections, but for those of groups of fields."""


class ReportBlock(TitleBlock, group="drawing"):
    """Title block of a report, as the client states it."""

    link: Annotated[str, Field(max_length=8000, pattern=r"^(https?://[!-~]+)?$")] = ""
    """Link to the design."""
    note: Annotated[str, Field(max_length=500)] = ""
    """Note below the title block."""


class ReportRequest(SheetRequest):
    """Calculation with its input, and what the report says of it."""

    language: Language = "en"
    """Language of the report."""
    title_block: ReportBlock = Field(
        default=ReportBlock(), description="Title block of the report."
    )
    worked: bool = False
    """Worked steps at the end of the report."""

    @property
    def stepped(self) -> bool:
        """True if worked steps are wanted."""
        return self.worked

    @cached_property
    def asked(self) -> RequestModel:
        """Request of the calculation with checks, wanted worked steps, and a reducer's largest
        torque.
        """
        own = super().asked
        if not isinstance(own, CrankPlanetaryRequest):
            return own
        return own.model_copy(update={"include": [*(own.include or ()), "largest_torque"]})

    @property
    def plain(self) -> Values:
        """Input of the calculation without what is asked of it."""
        return {name: each for name, each in self.input.items() if name not in ASKING}


class Line(NamedTuple):
    """Quantity in a table."""

    title: str
    symbol: str
    value: str  # with its unit


class Report:
    """Contents of a report of a request and its answer, which the template shows."""

    def __init__(self, body: ReportRequest, answer: Values) -> None:
        self.body, self.answer, self.block = body, answer, body.title_block
        self.calculation = CALCULATIONS[body.calculation]
        schemas = [Schema(self.calculation.request, "title")]
        if body.calculation == SWEEP:
            schemas.append(Schema(CALCULATIONS[body.input["calculation"]].request, "title"))
        self.schema = schemas[-1]
        self.words = Words(body.language, _titles(schemas))
        self.made_by = MADE_BY

    def html(self) -> str:
        """Text of the report."""
        return str(_template().render(report=self))

    def said(self, *keys: str, **values: Any) -> str:
        """Text of the page by its keys."""
        return self.words.message(*keys, **values)

    @property
    def name(self) -> str:
        """Name of the calculation."""
        own = self.body.calculation
        if own in self.words.own["calculator"]:
            return self.said("calculator", own)
        if own in ("fit", SWEEP):
            return self.said(own, "title")
        return self.said("section", own.rpartition("/")[2].replace("-", "_"))

    @property
    def title(self) -> str:
        """Title of the design, or else the name of the calculation."""
        return self.block.title or self.name

    @property
    def labels(self) -> list[tuple[str, str]]:
        """Rows of the title block."""
        names = ("author", "revision", "date")
        return [(self.said("label", each), getattr(self.block, each)) for each in names]

    @cached_property
    def impossible(self) -> bool:
        """True if a check says that the design cannot be built."""
        return any(each.get("impossible") for each in self.answer.get("checks", ()))

    @property
    def verdict(self) -> str:
        """Word of the verdict; empty for a calculation without one."""
        outcome = "impossible" if self.impossible else self.answer.get("verdict", "")
        parts = [each for each in self.parts if each["status"] not in ("left_out", "not_asked")]
        if outcome == "incomplete" and parts:
            judged = sum(each["status"] in JUDGED for each in parts)
            return self.said("verdictWord", "soFar", judged=judged, all=len(parts))
        return self.said("verdictWord", outcome) if outcome else ""

    @property
    def deciding(self) -> Values | None:
        """Check that decides: the first open one of an incomplete verdict without parts."""
        checks, code = self.answer.get("checks", ()), self.answer.get("governing")
        if self.answer.get("verdict") == "incomplete" and not self.parts:
            return next((each for each in checks if each["status"] == "not_checked"), None)
        return next((each for each in checks if each["code"] == code), None)

    @property
    def parts(self) -> list[Values]:
        """Parts of a reducer."""
        found: list[Values] = self.answer.get("parts", [])
        return found

    @property
    def nothing_breaks(self) -> bool:
        """True if nothing that could break was judged, and the verdict is incomplete therefore."""
        return self.answer["verdict"] == "incomplete" and not self.deciding

    @property
    def largest_torque(self) -> str:
        """Largest torque; empty if it is not known."""
        found = self.answer.get("largest_torque_Nm")
        return "" if found is None else self.words.quantity(found, "N·m")

    @property
    def cold_yield(self) -> str:
        """Warning of plastic that yields at once; empty for other designs."""
        if not (found := self.answer.get("cold_yield")):
            return ""
        torque = self.words.quantity(found["torque_Nm"], "N·m", 3)
        quarter = self.words.quantity(found["quarter_Nm"], "N·m", 2)
        return self.said("checks", "coldYield", torque=torque, quarter=quarter)

    @property
    def warnings(self) -> list[str]:
        """Sentences of the warnings, each once, and of what the verdict does not consider."""
        parts = [self.answer, *(each for each in self.answer.values() if isinstance(each, dict))]
        found = [
            self.words.text(each, each.get("params", {}).get("field", ""))
            for part in parts
            for each in part.get("warnings", ())
        ]
        own = {each["code"] for each in self.parts}
        left = [each for each in self.answer.get("not_considered", ()) if each not in own]
        what = "; ".join(self.words.said("not_considered", each) for each in left)
        said = [self.said("checks", "notConsidered", what=what)] if left else []
        return list(dict.fromkeys([*found, *said]))

    def mark(self, each: Values) -> str:
        """Sign of a status."""
        return MARKS.get(each["status"], "–")

    def reason(self, found: Values) -> str:
        """Reason for the status of a check, in a sentence; empty without one."""
        if not (own := found.get("reason")):
            return ""
        *_, field = ["", *(each for each in keys(own.get("pointer", "")) if not each.isdigit())]
        text = self.words.text(own, field)
        return f"{self.words.field(field)}: {text}" if field else text

    def part_title(self, part: Values) -> str:
        """Title of a part."""
        said = self.words.said("not_considered", part["code"])
        return said[:1].upper() + said[1:]

    def check_title(self, check: Values) -> str:
        """Title of a check."""
        return self.words.said("checks", check["code"])

    @property
    def groups(self) -> Iterator[tuple[str, list[Values]]]:
        """Checks that are judged, or wait for a value, by what they are about."""
        shown = [
            each
            for each in self.answer.get("checks", ())
            if each["status"] in JUDGED
            or (each["status"] == "not_checked" and each.get("needed", True))
        ]
        for group in dict.fromkeys(each["group"] for each in shown):
            own = [each for each in shown if each["group"] == group]
            yield self.words.said("check_groups", group), own

    @property
    def others(self) -> Iterator[tuple[str, str]]:
        """Titles of checks that were not made, by their status."""
        for status in ("not_checked", "not_asked"):
            titles = [
                self.check_title(each)
                for each in self.answer.get("checks", ())
                if each["status"] == status
                and (status, each.get("needed")) != ("not_checked", None)
            ]
            if titles:
                yield self.said("status", status), "; ".join(titles)

    def amount(self, check: Values, name: str) -> str:
        """Value or limit of a check with its unit; empty without one."""
        value, above = check.get(name), check["keep"] == "above"
        if value is None:
            return ""
        if check.get("limit") == 0 and not above:  # of what is counted, or overlaps
            if name == "limit":
                return self.said("checks", "noneAllowed")
            if value == 0:
                return self.said("checks", "none")
        sign = {"limit": "≥\u00a0" if above else "≤\u00a0"}.get(name, "")
        return sign + self.words.quantity(value, check["unit"])

    def used(self, check: Values) -> str:
        """Share of the limit that is used, per cent; empty without one."""
        used = check.get("utilisation")
        if used is None or check["status"] not in JUDGED:
            return ""
        return f"{self.words.number(100 * used, 2 if used < 0.1 else 3)}\u00a0%"

    def source(self, check: Values) -> str:
        """Source of the limit of a check."""
        words, life = self.words, check.get("life_factor")
        said = [
            words.said("criteria", check.get("criterion", "")),
            words.said("sources", check["source_code"]) or check["source"],
            words.said("verified", check.get("verified", "")),
            "" if life is None else self.said("checks", "life", factor=words.number(life, 3)),
        ]
        return ": ".join(filter(None, said))

    @property
    def sources(self) -> list[str]:
        """Sources of the limits of checks, each once; tables name them by number."""
        judged = (each for _, own in self.groups for each in own if each["status"] in JUDGED)
        return list(dict.fromkeys(map(self.source, judged)))

    def place(self, check: Values) -> str:
        """Pair and crank angle of a check; empty for one of no pair."""
        at = check.get("at", {})
        if "pin" not in at:
            return ""
        angle = self.words.quantity(round(at.get("crank_angle_deg", 0.0), 2), "°")
        return self.said("checks", "at", **at | {"angle": angle})

    @property
    def inputs(self) -> Iterator[tuple[str, list[Line]]]:
        """Tables of the typed inputs under their headings, then that of assumed ones."""
        swept = self.body.calculation == SWEEP
        plain = self.body.input["input"] if swept else self.body.plain
        rows: dict[tuple[str, ...], list[Row]] = {}
        for row in self.schema.rows(plain):
            if row.path[-1] in ASKING:
                continue
            rows.setdefault(_named(row), []).append(row)
        tables: dict[str, list[Line]] = {}
        for own in rows.values():
            tables.setdefault(self._heading(own[0]), []).append(self._input(own))
        yield from tables.items()
        if assumed := self.answer.get("assumed"):
            yield self.said("report", "assumed"), [self._assumed(each) for each in assumed]

    def _heading(self, row: Row) -> str:
        """Heading of an input."""
        section = row.path[0] if len(row.path) > 1 else row.said.get("x-group", "")
        if section in HEADINGS and len(row.path) > 1:
            return self.said(*HEADINGS[section])
        return self.said("group", section if section in self.words.own["group"] else "more")

    def _input(self, rows: list[Row]) -> Line:
        """An input, of the entries of a list together."""
        name, said = rows[0].path[-1], rows[0].said
        say = self.words.value
        if name == "scope":
            say = partial(self.words.said, "not_considered")
        each = ["; ".join(map(say, row.values)) for row in rows]
        value = self._with_unit("; ".join(dict.fromkeys(each)), name)
        return Line(
            self.words.field(name, said.get("x-group", "")), said.get("x-symbol", ""), value
        )

    def _with_unit(self, value: str, name: str) -> str:
        """Text of a value with the unit of its name."""
        return value + self.words.after("%" if name.endswith("_percent") else shown_unit(name))

    def _assumed(self, each: Values) -> Line:
        """An assumed value with its range."""
        path = [name for name in keys(each["pointer"]) if not name.isdigit()]
        name, above = path[-1], "bearing" if "bearings" in path else "".join(path[-2:-1])
        value = self.words.value(each["value"])
        if "low" in each:
            ends = (self.words.number(each[end], ALL) for end in ("low", "high"))
            value += f" ({'–'.join(ends)})"
        return Line(self.words.field(name, above), "", self._with_unit(value, name))

    @property
    def results(self) -> Iterator[tuple[str, list[Line]]]:
        """Tables of the results under their headings."""
        if self.body.calculation == SWEEP:
            return
        parts = {name: each for name, each in self.answer.items() if name not in NO_RESULTS}
        rows: dict[tuple[str, ...], list[Row]] = {}
        for row in Schema(self.calculation.answer, "description").rows(parts):
            if NO_RESULTS.isdisjoint(row.path):
                path = _named(row)
                whole = path[-1] in PARTED or (path[-2:-1] and path[-2].endswith("pair"))
                path = path[:-1] if whole else path
                rows.setdefault(path, []).append(row)
        tables: dict[str, list[Line]] = {}
        for path, own in rows.items():
            section = path[0] if len(path) > 1 else ""
            again = len(path) > 2 and (*path[:-2], path[-1]) in rows  # of a part, without words
            line = self._result(path, section, own)
            if line and not (again and line.title == self.words.result(path[-1], section)):
                known = section in self.words.own["section"]
                heading = self.said("section", section) if known else self.name
                tables.setdefault(heading, []).append(line)
        yield from tables.items()

    def _result(self, path: tuple[str, ...], section: str, rows: Sequence[Row]) -> Line | None:
        """A result of a name, of all entries of a list together; None for what has no title."""
        name, numbers = path[-1], [each for row in rows for each in row.values]
        part = self.words.own["quantity"].get("_".join(path[-2:])) if len(path) > 2 else ""
        title = part or self.words.result(name, section)
        place = name in ("satellite", "pin") or len(numbers) > MOST_OF_A_LIST
        if not title or place or any(isinstance(each, str) for each in numbers):
            return None
        if name.endswith("pair"):
            at = {row.path[-1]: row.values[0] for row in rows}
            return Line(title, "", self.said("results", "pair", **at))
        parts = [row.path[-1] for row in rows if row.path[-1] in PARTED]
        title += ": " + "; ".join(self.words.result(each) for each in parts) if parts else ""
        value = "; ".join(self._number(each, name) for each in dict.fromkeys(numbers))
        return Line(title, rows[0].said.get("x-symbol", ""), self._with_unit(value, name))

    def _number(self, value: float, name: str) -> str:
        if isinstance(value, bool):
            return self.said("results", "yes" if value else "no")
        return self.words.number(value, digits_of(name))

    @property
    def points(self) -> list[list[str]]:
        """Rows of the table of a sweep, the first one of titles; none for others."""
        if self.body.calculation != SWEEP:
            return []
        axes, outputs = self.answer["axes"], self.answer["outputs"]
        heads = [each["pointer"] for each in axes] + [*outputs]
        rows: list[list[Any]] = [[]]
        for each in axes:
            rows = [[*row, value] for row in rows for value in each["values"]]
        columns = zip(*outputs.values(), strict=True)
        shown = [
            [*map(self._point, heads, (*row, *found))]
            for row, found in zip(rows, columns, strict=True)
        ]
        return [[self._pointed(each) for each in heads], *shown]

    def _point(self, pointer: str, value: float | None) -> str:
        """Value at a point of a sweep, shares of a limit in per cent."""
        if value is None:
            return "–"
        return self.words.number(100 * value if pointer.endswith("/utilisation") else value)

    def _pointed(self, pointer: str) -> str:
        """Title of what a pointer of a sweep names, with its unit."""
        path = [each for each in keys(pointer) if not each.isdigit()]
        if path == ["checks", "governing", "utilisation"]:
            return self.said("sweep", "governing")
        if path[0] == "checks":
            return f"{self.words.said('checks', path[1])}: {self.said('sweep', 'used')}"
        title = self.words.result(path[-1], path[0]) or self.words.field(
            path[-1], "".join(path[-2:-1])
        )
        unit = self.words.unit(shown_unit(path[-1]))
        return f"{title}, {unit}" if unit else title

    @property
    def drawing(self) -> str:
        """Drawing of the assembly, or else of a satellite; empty if it is not known."""
        if self.body.calculation != CRANK:
            return ""
        for part in DRAWN:
            try:
                asked = DxfRequest.model_validate({"design": self.body.plain, "parts": [part]})
                (sheet,), _ = asked.drawn()
            except (ValidationError, CalculationError):
                continue
            return picture(sheet)
        return ""

    @property
    def curves(self) -> list[str]:
        """Pictures of the figures of the calculation and of its sections, the highest first."""
        plots = []
        for draw, asked in self._figures():
            with suppress(Problem, CalculationError):  # what cannot be drawn is left out
                plots.append(Plot(draw(asked, "light"), self.words))
        return [each.svg for each in sorted(plots, key=lambda each: -each.height)]

    def _figures(self) -> Iterator[tuple[Any, Any]]:
        """Functions that draw, and the requests of their figures."""
        draw, asked = self.calculation.figure, self.body.asked
        if draw is None:
            return
        if self.body.calculation != CRANK:
            yield draw, asked
            return
        solved = "load_sharing" in self.answer
        yield draw, asked.model_copy(update={"include": ["cyclogram"] if solved else None})
        for section in [each for each in self.answer if each not in NO_RESULTS]:
            other = CALCULATIONS.get(section.replace("_", "-"))
            if section == "ring_mesh":
                yield draw, asked.model_copy(update={"include": [section]})
            elif other and other.figure and section not in ("cyclogram", "contact_force", "hertz"):
                adapter: TypeAdapter[RequestModel] = TypeAdapter(other.request)
                yield other.figure, adapter.validate_python(self.body.plain)

    @property
    def steps(self) -> list[Values]:
        """Worked steps, if they are wanted."""
        found: list[Values] = self.answer.get("worked", [])
        return found

    def step_title(self, step: Values) -> str:
        """Title of a worked step."""
        return self.words.result(step["code"], step["section"]) or self.words.field(step["code"])

    def step_way(self, step: Values) -> str:
        """Formula of a step, or the words of its method."""
        if "formula" in step:
            return _greek(f"{step['symbol']} = {step['formula'].replace('*', '·')}")
        return self.words.worked(step["method"], step.get("params", {}))

    def step_numbers(self, step: Values) -> str:
        """Numbers that go into a step."""
        return "; ".join(
            f"{_greek(symbol)} = {self.words.quantity(value, shown_unit(step['names'][symbol]), 6)}"
            for symbol, value in step["values"].items()
        )

    def step_source(self, step: Values) -> str:
        """Source of a step with the number of its equation."""
        said = self.words.said("worked_sources", step.get("source", ""))
        number = step.get("equation", "").removeprefix("after ")
        if not number:
            return said
        key = "equation" if number == step["equation"] else "after"
        return self.said("worked", key, source=said, number=number)


def _named(row: Row) -> tuple[str, ...]:
    """Path of a quantity without the numbers of entries of lists."""
    return tuple(each for each in row.path if not each.isdigit())


def _greek(formula: str) -> str:
    """Formula with Greek letters in place of their names."""

    def letter(found: re.Match[str]) -> str:
        case = "CAPITAL" if found[0][0].isupper() else "SMALL"
        name = found[0].upper().replace("LAMBDA", "LAMDA")
        try:
            return unicodedata.lookup(f"GREEK {case} LETTER {name}")
        except KeyError:
            return found[0]

    return re.sub(r"[A-Za-z]{2,}", letter, formula)


def _titles(schemas: Sequence[Schema]) -> dict[str, str]:
    """Titles of the fields of schemas by their names."""
    found: dict[str, str] = {}
    for schema in schemas:
        for one in reversed((schema.whole, *schema.whole.get("$defs", {}).values())):
            fields = one.get("properties", {}).items()
            found |= {name: field["title"] for name, field in fields if "title" in field}
    return found


@cache
def _template() -> Any:
    import jinja2  # slow import, needed for reports only

    folder = jinja2.FileSystemLoader(Path(__file__).parent)
    made = jinja2.Environment(
        loader=folder,
        autoescape=True,
        trim_blocks=True,
        lstrip_blocks=True,
        undefined=jinja2.StrictUndefined,
    )
    made.filters["parted"] = partial(re.split, r"_([^\W_]+)")
    return made.get_template("report.html")


def write(body: ReportRequest) -> File:
    """Report of a calculation on A4 pages in a language: verdict, drawing, checks with their limits
    and sources, inputs, results and curves, in one file without scripts; as HTML, or as PDF for
    requests that accept it.
    """
    content = Report(body, body.answer).html()
    return File(f"{body.calculation.replace('/', '-')}.html", HTML, content.encode())


def as_pdf(report: File) -> File:
    """Report as a PDF file; needs the extra `pdf` of the service."""
    import weasyprint

    page = weasyprint.HTML(string=report.content.decode(), url_fetcher=_nothing)
    name = report.name.removesuffix("html") + "pdf"
    return File(name, PDF, page.write_pdf())


def _nothing(url: str, *_: Any, **__: Any) -> NoReturn:
    """Refuse to fetch anything, as a report needs nothing from outside."""
    raise ValueError(url)


EXPORT = Export(
    name="export/report",
    title="Calculation as a report",
    request=ReportRequest,
    write=write,
    media_types=(HTML, PDF),
    extra="pdf",
    module="weasyprint",
    instead="export/report",
    convert=as_pdf,
)
