"""Results over one or two inputs of a calculation: request, answer."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import ClassVar, Literal, NamedTuple

from pydantic import BaseModel, Field

from app.calculations.varied import (
    GOVERNING,
    JUDGED,
    REFUSALS,
    CalculationName,
    Inputs,
    Pointer,
    VariedFields,
    VariedResponse,
    at,
    impossible,
    is_number,
    is_of_a_list,
    refused,
)
from app.model import (
    AccuracyOut,
    Maybe,
    Report,
    RequestModel,
    ResponseModel,
    StudyCalculation,
    Values,
    Whole,
    accuracy_values,
    present,
    timed,
    untold,
)
from app.problems import FieldProblem, problem_of, refusal
from app.rules import Forms
from app.settings import Settings
from core.errors import Accuracy
from core.numerics.inverse import Want
from core.precision import SEARCHED

MOST_VALUES = 1000
"""Largest number of values of an axis."""

BLOCKS, BLOCK, LIGHT_BLOCK = 16, 4, 500
"""Number of blocks of points that few points make, and largest sizes of a block, which takes up to
a second: of points that take long, and of others."""

Status = Literal["ok", "pass", "marginal", "fail", "incomplete", "impossible"]


class AxisFields(RequestModel):
    """Input that is varied, and its values."""

    ALTERNATIVES: ClassVar[tuple[Forms, ...]] = ((("from", "to", "steps"), ("values",)),)

    pointer: Pointer = Field(description="JSON pointer to the number in `input`.")
    low: Maybe[float] = Field(alias="from", ge=-1e12, le=1e12, description="First value.")
    to: Maybe[float] = Field(ge=-1e12, le=1e12, description="Last value.")
    number: Maybe[Whole] = Field(
        alias="steps", ge=2, le=MOST_VALUES, description="Number of values of a range."
    )
    scale: Literal["linear", "log"] = Field(
        default="linear", description="`log` for values at equal ratios."
    )
    all: Maybe[list[float]] = Field(
        alias="values",
        min_length=1,
        max_length=MOST_VALUES,
        description="Values in place of a range.",
    )

    @property
    def count(self) -> int:
        """Number of values."""
        return self.number or len(self.all or ())

    def numbers(self, field: str) -> list[float]:
        """Values of the axis; a problem of a field if a range has no equal ratios."""
        if self.low is None or self.to is None:
            return self.all or []
        low, to, most = self.low, self.to, self.count - 1
        if self.scale == "linear":
            return [*(low + (to - low) * k / most for k in range(most)), to]
        for name, end in (("from", low), ("to", to)):
            if end <= 0:
                raise refusal(f"{field}/{name}", "greater_than", limit=0)
        return [*(low * (to / low) ** (k / most) for k in range(most)), to]


class ObjectiveFields(RequestModel):
    """Result of which the best point is named."""

    pointer: Pointer = Field(description="JSON pointer to the result in the answer.")
    sense: Want = Field(default="smallest", description="Which value is the best.")


class SweepRequest(VariedFields):
    """Calculation with its input, the inputs that vary, and the results that are read."""

    calculation: CalculationName = Field(description="Name of the calculation.")
    axes: list[AxisFields] = Field(
        min_length=1, max_length=2, description="Inputs that vary; the last one varies first."
    )
    outputs: Maybe[list[Pointer]] = Field(
        min_length=1,
        max_length=20,
        description="JSON pointers to results in the answer; checks are addressed by code: "
        "`/checks/contact_pressure_hole/utilisation`, the one that decides by `governing`. By "
        "default the utilisation of that one.",
    )
    objective: Maybe[ObjectiveFields]

    @property
    def varied(self) -> dict[str, str]:
        """Pointers of the axes."""
        return {f"/axes/{k}/pointer": each.pointer for k, each in enumerate(self.axes)}

    @property
    def read(self) -> tuple[str, ...]:
        """Pointers to the results that are answered, each once."""
        read = self.outputs or ([GOVERNING] if self.calculation in JUDGED else [])
        return tuple(dict.fromkeys([*read, *([self.objective.pointer] if self.objective else [])]))

    @property
    def targets(self) -> dict[str, str]:
        """Pointers to results; judged designs have their checks always."""
        named = {f"/outputs/{k}": each for k, each in enumerate(self.outputs or ())}
        if self.objective:
            named["/objective/pointer"] = self.objective.pointer
        return named | ({"": GOVERNING} if self.calculation in JUDGED else {})

    def linked(self, start: Mapping[str, float | None]) -> dict[str, float]:
        """Typed values of inputs that follow the axes, which follow nothing themselves."""
        return {name: each for name, each in super().linked(start).items() if name not in start}

    def refuse_beyond(self, settings: Settings) -> None:
        """Refuse a sweep of too many points, of one axis twice, or without results."""
        *others, last = self.axes
        most = settings.max_sweep_points // math.prod(each.count for each in others)
        if last.count > most:
            counted = "steps" if last.number else "values"
            raise refusal(f"/axes/{len(others)}/{counted}", "service_limit", limit=most)
        if len({each.pointer for each in self.axes}) < len(self.axes):
            raise refusal("/axes/1/pointer", "only_one", field="/axes/0/pointer")
        if not self.read:
            raise refusal("/outputs", "missing")
        super().refuse_beyond(settings)
        _ = self.grid

    @cached_property
    def grid(self) -> "Grid":
        """Points of the sweep."""
        inputs, axes = self.settable, []
        for k, axis in enumerate(self.axes):
            numbers = axis.numbers(f"/axes/{k}")
            if inputs.takes_whole(axis.pointer, numbers[0], f"/axes/{k}/pointer"):
                numbers = _whole(numbers, f"/axes/{k}/{'steps' if axis.number else 'values'}")
            axes.append((axis.pointer, tuple(numbers)))
        return Grid(inputs, tuple(axes), self.read)


def _whole(numbers: Sequence[float], field: str) -> list[float]:
    """Whole numbers as such; a problem of a field if there are others."""
    if not all(float(each).is_integer() for each in numbers):
        raise refusal(field, "int_type")
    return [*map(int, numbers)]


class Row(NamedTuple):
    """Results at a point."""

    status: Status
    governing: str | None = None  # code of the check that decides
    values: tuple[float | None, ...] = ()  # one to each output; empty if the input is refused
    error: float = 0.0  # largest relative error that sections of the outputs state
    problem: FieldProblem | None = None  # refusal of the input
    of_all: bool = False  # true if the problem is one of the whole request


@dataclass(frozen=True, slots=True)
class Grid:
    """Points of a sweep; each is calculated for itself."""

    inputs: Inputs
    axes: tuple[tuple[str, tuple[float, ...]], ...]  # pointer and values of each axis
    outputs: tuple[str, ...]  # pointers to results

    def __len__(self) -> int:
        return math.prod(len(values) for _, values in self.axes)

    def point(self, index: int) -> dict[str, float]:
        """Values that vary at a point, by pointer."""
        values = {}
        for pointer, numbers in reversed(self.axes):
            index, place = divmod(index, len(numbers))
            values[pointer] = numbers[place]
        return values

    def row(self, index: int) -> Row:
        """Results at a point."""
        try:
            answer = self.inputs.answer(self.point(index))
        except REFUSALS as error:
            problem = problem_of(refused(error)).errors[0]
            return Row("impossible", problem=problem, of_all=is_of_a_list(error))
        found = [at(answer, each) for each in self.outputs]
        values = (each if is_number(each) and math.isfinite(each) else None for each in found)
        errors = [at(answer, f"{each.rpartition('/')[0]}/accuracy") for each in self.outputs]
        stated = max((each["relative_error"] for each in errors if each), default=SEARCHED)
        return Row(_status(answer), answer.get("governing"), tuple(values), stated)

    def rows(self, points: range) -> list[Row]:
        """Results at some points."""
        return [self.row(index) for index in points]

    def blocks(self, size: int) -> list[range]:
        """Points in blocks."""
        return [range(k, min(k + size, len(self))) for k in range(0, len(self), size)]


def _status(answer: Values) -> Status:
    """Verdict of an answer, if it has one."""
    if impossible(answer):
        return "impossible"
    status: Status = answer.get("verdict", "ok")
    return status


class AxisOut(BaseModel):
    """Values of an input that varies."""

    pointer: str = Field(description="JSON pointer into `input`.")
    values: list[float] = Field(description="Its values.")


class RefusedPointsOut(ResponseModel):
    """Points that are impossible for one reason."""

    code: str = Field(description="Code of the refusal, or of the check.")
    pointer: Maybe[str] = Field(description="JSON pointer to the refused field.")
    detail: Maybe[str] = Field(description="Text of the refusal at the first point, in English.")
    points: list[int] = Field(description="Numbers of the points, from 0.")


class BestPointOut(ResponseModel):
    """Point with the best value of the objective."""

    point: int = Field(description="Number of the point, from 0.")
    value: float = Field(description="Value of the objective.")
    sets: dict[str, float] = Field(
        description="Values that the point sets, by JSON pointer into `input`."
    )


class SweepResponse(VariedResponse):
    """Results of all points in columns; points are in order, the last axis varies first."""

    axes: list[AxisOut]
    outputs: dict[str, list[float | None]] = Field(
        description="Results by JSON pointer, null at points that have none."
    )
    status: list[Status] = Field(
        description="Verdict at each point, `impossible` for refused inputs and for parts that "
        "cannot be put together or move, `ok` where nothing is judged."
    )
    codes: list[str] = Field(description="Codes of checks that decide.")
    governing: list[int] = Field(
        description="Place in `codes` of the check that decides at each point, or -1."
    )
    reasons: list[RefusedPointsOut] = Field(description="Why points are impossible.")
    best: Maybe[BestPointOut] = Field(
        description="Best point of `objective` that neither fails nor is impossible."
    )
    accuracy: AccuracyOut = Field(
        description="Largest error that the sections of the outputs state, or else that of "
        "searched extremes; every point equals the single answer."
    )


def _reasons(rows: Sequence[Row]) -> list[Values]:
    """Why points are impossible: refusals, and checks that say so."""
    found: dict[tuple[str, str], Values] = {}
    for index, row in enumerate(rows):
        if row.status == "impossible":
            why = row.problem
            code, pointer = (why.code, why.pointer) if why else (row.governing or "", "")
            reason = {"code": code, "pointer": pointer or None, "detail": why and why.detail}
            found.setdefault((code, pointer), present(reason) | {"points": []})
            found[code, pointer]["points"].append(index)
    return [*found.values()]


def _best(body: SweepRequest, rows: Sequence[Row]) -> Values | None:
    """Best point of the objective; the first of several."""
    if not body.objective:
        return None
    column = body.read.index(body.objective.pointer)
    known = [
        (value, k)
        for k, row in enumerate(rows)
        if row.status not in ("fail", "impossible") and (value := row.values[column]) is not None
    ]
    if not known:
        return None
    sign = 1 if body.objective.sense == "smallest" else -1
    value, point = min(known, key=lambda each: (sign * each[0], each[1]))
    grid = body.grid
    return {"point": point, "value": value, "sets": grid.inputs.setting(grid.point(point))}


def _rows(body: SweepRequest, report: Report) -> list[Row]:
    """Results at all points."""
    grid, rows = body.grid, list[Row]()
    size = max(1, min(len(grid) // BLOCKS, BLOCK)) if body.long else LIGHT_BLOCK
    for found in body.cut(grid.rows, grid.blocks(size)):
        for row in found:
            if row.of_all and row.problem:
                raise refusal(row.problem.pointer, row.problem.code, **row.problem.params)
        rows += found
        report(len(rows) / len(grid))
    return rows


def reporting(body: SweepRequest, report: Report) -> Values:
    """Values of the sweep; its progress is reported."""
    rows, run_time_us = timed(lambda: _rows(body, report))
    codes = [*dict.fromkeys(each.governing for each in rows if each.governing)]
    columns = {
        name: [each.values[k] if each.values else None for each in rows]
        for k, name in enumerate(body.read)
    }
    accuracy = Accuracy("sampling", max(each.error for each in rows), len(rows))
    return present(
        {
            "axes": [{"pointer": name, "values": [*values]} for name, values in body.grid.axes],
            "outputs": columns,
            "status": [each.status for each in rows],
            "codes": codes,
            "governing": [codes.index(each.governing) if each.governing else -1 for each in rows],
            "reasons": _reasons(rows),
            "best": _best(body, rows),
            "linked": body.grid.inputs.linked(name for name, _ in body.grid.axes),
            "accuracy": accuracy_values(accuracy, run_time_us),
        }
    )


def solve(body: SweepRequest) -> Values:
    """Results of a calculation over one or two of its inputs, in columns.

    Every point is calculated for itself, on all processors where this takes long, and equals the
    single answer. Points that fail or are impossible stay, with the reason. The header `Accept:
    application/x-ndjson` asks for an answer in lines: `{"progress": 0.25}`, at most four a second,
    and at last `{"result": ...}` or `{"problem": ...}`. Closing the connection ends the sweep.
    """
    return reporting(body, untold)


CALCULATION = StudyCalculation(
    name="sweep",
    title="Results over inputs",
    tag="exploration",
    request=SweepRequest,
    answer=SweepResponse,
    solve=solve,
    batched=False,
    reporting=reporting,
)
