"""Change of a result with each of some inputs: request, answer."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

from pydantic import Field

from app.calculations.crank_planetary_sections import CrankPlanetaryRequest
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
    refused,
)
from app.model import (
    AccuracyOut,
    Maybe,
    Report,
    ResponseModel,
    Size,
    StudyCalculation,
    Values,
    accuracy_values,
    pointer,
    present,
    result,
    timed,
    untold,
)
from app.problems import FieldProblem, invalid_input, problem_of, refusal
from app.settings import Settings
from core.checks.crank_planetary import crank_checks
from core.checks.reserve import crank_verdict
from core.errors import Accuracy
from core.precision import ROUNDING, SEARCHED

MOST_INPUTS = 12
"""Largest number of inputs."""

STEP, FINE = 0.01, 1e-4
"""Relative step of an input for changes, and for derivatives; of 1 where the input is 0."""

KINK = 1e-3
"""Difference of the derivatives of both sides from which on a kink is looked for: of a smooth
result it doubles with the step."""

USUAL = (
    "/contact/pin_radius_mm",
    "/gear/ring_pin_radius_mm",
    "/contact/eccentricity_mm",
    "/gear/ring_pin_circle_radius_mm",
    "/load/pin_circle_radius_mm",
    "/contact/contact_length_mm",
    "/pin/diameter_mm",
    "/mechanism/pins",
    "/contact/hole_clearance_mm",
    "/gear/modification/equidistant_mm",
    "/gear/modification/pin_circle_mm",
    "/load/output_torque_Nm",
)
"""Inputs of a reducer that vary if none are named, as far as they are given and not 0."""


class SensitivityRequest(VariedFields):
    """Calculation with its input, the inputs that vary, and the result that is read."""

    calculation: CalculationName = Field(description="Name of the calculation.")
    inputs: Maybe[list[Pointer]] = Field(
        min_length=1,
        max_length=MOST_INPUTS,
        description="JSON pointers to numbers in `input`; by default the usual sizes of a reducer.",
    )
    output: Maybe[Pointer] = Field(
        description="JSON pointer to the result in the answer. By default that is the utilisation "
        "of the check that decides, of a reducer under its largest torque.",
    )
    spread: Maybe[dict[str, Size]] = Field(
        max_length=MOST_INPUTS,
        description="Change of an input to both sides by its pointer, in place of a hundredth.",
    )

    @cached_property
    def pointers(self) -> list[str]:
        """Pointers to the inputs that vary."""
        spread = [*(self.spread or {})]
        if self.inputs is not None:
            return [*dict.fromkeys(self.inputs)]
        usual = USUAL if self.calculation == "crank-planetary" else ()
        given = [each for each in usual if is_number(at(self.input, each)) and at(self.input, each)]
        return [*dict.fromkeys([*spread, *given])][:MOST_INPUTS]

    @property
    def varied(self) -> dict[str, str]:
        """Pointers to the inputs that vary."""
        return {f"/inputs/{k}": each for k, each in enumerate(self.pointers)}

    @property
    def targets(self) -> dict[str, str]:
        """Pointer to the result."""
        return {"/output": self.output or GOVERNING}

    def refuse_beyond(self, settings: Settings) -> None:
        """Refuse a request without inputs or a result, or a spread of other inputs."""
        super().refuse_beyond(settings)
        if not self.pointers:
            raise refusal("/inputs", "missing")
        if self.output is None and self.calculation not in JUDGED:
            raise refusal("/output", "missing")
        if others := {*(self.spread or ())} - {*self.pointers}:
            raise refusal(pointer(("spread", min(others))), "not_there", field="inputs")
        _ = self.study

    @cached_property
    def study(self) -> "Study":
        """Inputs with their steps."""
        inputs, steps, fine = self.settable, dict[str, float](), set[str]()
        spread, part = self.spread or {}, STEP if self.changes else FINE
        for k, name in enumerate(self.pointers):
            value = inputs.start[name]
            if value is None:
                raise refusal(f"/inputs/{k}", "not_there", field="input")
            if inputs.takes_whole(name, value, f"/inputs/{k}"):
                steps[name] = spread.get(name, 1.0)
                if not steps[name].is_integer():
                    raise refusal(pointer(("spread", name)), "int_type")
                continue
            steps[name] = spread.get(name) or part * (abs(value) or 1.0)
            if not self.changes:
                fine.add(name)
        return Study(inputs, self.output, steps, frozenset(fine), not self.changes)

    @property
    def changes(self) -> bool:
        """True if changes are asked, not derivatives."""
        return self.output is None or bool(self.spread)


@dataclass(frozen=True, slots=True)
class Side:
    """Result at a value of an input."""

    value: float  # of the input
    result: float | None = None  # None if there is none
    governing: str | None = None  # code of the check that decides
    problem: FieldProblem | None = None  # refusal of the input
    impossible: bool = False  # true if the check that decides says so

    def beside(self, middle: "Side") -> Values:
        """Values of the answer, with the change from the middle, or the reason for none."""
        values = {"value": self.value, "governing": self.governing}
        if self.result is not None and middle.result is not None:
            return values | {"result": self.result, "change": self.result - middle.result}
        if self.problem:
            return values | {"reason": self.problem.code, "detail": self.problem.detail}
        return values | {"reason": self.governing if self.impossible else "not_there"}


@dataclass(frozen=True, slots=True)
class Study:
    """Inputs that vary one by one."""

    inputs: Inputs
    output: str | None  # pointer to the result; None for the utilisation that decides
    steps: dict[str, float]  # change of each input to a side, by pointer
    fine: frozenset[str]  # inputs whose derivative has an error
    slopes: bool  # true if derivatives are asked
    factor: float = 1.0  # on the torque
    middle: Side = Side(math.nan)  # result of the input as given

    def side(self, values: dict[str, float], value: float = 0.0) -> Side:
        """Result at a value of an input that is set."""
        try:
            found, governing, impossible = self._read(values)
        except REFUSALS as error:
            return Side(value, problem=problem_of(refused(error)).errors[0])
        known = not impossible and is_number(found) and math.isfinite(found)
        return Side(value, float(found) if known else None, governing, impossible=impossible)

    def _read(self, values: dict[str, float]) -> tuple[Any, str | None, bool]:
        """Result, code of the check that decides, and true if it says that nothing works."""
        if self.output is None and self.inputs.calculation == "crank-planetary":
            return self.inputs.solved(values, self._look)
        answer = self.inputs.answer(values)
        return at(answer, self.output or GOVERNING), answer.get("governing"), impossible(answer)

    def _look(self, asked: CrankPlanetaryRequest) -> tuple[float | None, str | None, bool]:
        """Utilisation of the check that decides under the torque times the factor."""
        found = crank_checks(asked.results.under(self.factor))
        code = found.governing
        return found[code].utilisation if code else None, code, found.impossible

    def around(self, name: str) -> list[Side]:
        """Sides of an input at -1, 0 and 1 steps; for a derivative with its error at -2 to 2."""
        start, step = self.inputs.start[name] or 0.0, self.steps[name]
        most = 2 if name in self.fine else 1
        middle = replace(self.middle, value=start)
        return [
            self.side({name: start + k * step}, start + k * step) if k else middle
            for k in range(-most, most + 1)
        ]

    def rows(self, names: Sequence[str]) -> list[tuple[float, Values]]:
        """Size of the change with each of some inputs, and the values of its answer."""
        return [self.row(name) for name in names]

    def row(self, name: str) -> tuple[float, Values]:
        """Size of the change with an input, and the values of its answer."""
        sides = self.around(name)
        half = len(sides) // 2
        middle, ends = sides[half], {"minus": sides[half - 1], "plus": sides[half + 1]}
        values: Values = {"pointer": name, "value": middle.value, "step": self.steps[name]}
        for end, side in ends.items():
            values[end] = present(side.beside(middle))
        size = max(abs(values[end].get("change", 0.0)) for end in ends)
        if not self.slopes:
            return size, values
        return size / self.steps[name] * (abs(middle.value) or 1.0), values | derived(sides)


def slope(one: Side, other: Side, logs: bool) -> float:
    """Derivative between two sides, of logarithms if so; NaN if a result lacks."""
    if one.result is None or other.result is None:
        return math.nan
    if logs:
        return math.log(other.result / one.result) / math.log(other.value / one.value)
    return (other.result - one.result) / (other.value - one.value)


def derived(sides: Sequence[Side]) -> Values:
    """Derivative by central differences, its error by twice the step, and those of both sides; at a
    kink, at a jump and where a side lacks only the latter.
    """
    logs = all(each.value > 0 and (each.result is None or each.result > 0) for each in sides)
    half, first, last = len(sides) // 2, sides[0], sides[-1]
    less, middle, more = sides[half - 1 : half + 2]
    before, after = slope(less, middle, logs), slope(middle, more, logs)
    values: Values = {"absolute": None if logs else True}
    values |= {"derivative_minus": before, "derivative_plus": after}
    near, far = slope(less, more, logs), slope(first, last, logs)
    apart, wide = after - before, slope(middle, last, logs) - slope(first, middle, logs)
    scale = max(abs(before), abs(after), 1.0 if logs else 0.0)
    kink = abs(apart) > KINK * scale and abs(wide - 2 * apart) > abs(apart) / 2
    if half == 1:
        values["derivative"] = near
    elif not kink and not math.isnan(far):
        values |= {"derivative": near, "derivative_error": abs(near - far) / 3 + ROUNDING / FINE}
    return {name: each for name, each in values.items() if each is not None and each == each}


class SideOut(ResponseModel):
    """Result at a value of an input."""

    value: float = Field(description="Value of the input.")
    result: Maybe[float] = Field(description="Result there; absent if there is none.")
    change: Maybe[float] = Field(description="Change of the result.")
    governing: Maybe[str] = Field(description="Code of the check that decides there.")
    reason: Maybe[str] = Field(description="Code of the reason why there is no result.")
    detail: Maybe[str] = Field(description="Text of the refusal, in English.")


class ChangeOut(ResponseModel):
    """Change of the result with an input."""

    pointer: str = Field(description="JSON pointer into `input`.")
    value: float = result("Value of the input as given.")
    step: float = result("Change of the input to each side.")
    minus: SideOut
    plus: SideOut
    derivative: Maybe[float] = result(
        "Relative change of the result over that of the input, by both sides; absent at a kink or "
        "a jump, where those of the sides differ."
    )
    derivative_error: Maybe[float] = result("Error of that, by twice the step.")
    derivative_minus: Maybe[float] = result("That of the smaller side.")
    derivative_plus: Maybe[float] = result("That of the larger side.")
    absolute: Maybe[bool] = Field(
        description="True if derivatives are of the numbers themselves, as one is 0 or negative."
    )


class SensitivityResponse(VariedResponse):
    """Change of a result with each of some inputs, the largest first."""

    result: float = Field(description="Result of the input as given.")
    output: str = Field(description="JSON pointer to the result.")
    governing: Maybe[str] = Field(description="Code of the check that decides.")
    torque_Nm: Maybe[float] = Field(
        description="Output torque of all utilisations: the largest one of the reducer as given; "
        "absent if that is not known, and they are under the torque as given."
    )
    inputs: list[ChangeOut]
    accuracy: AccuracyOut


def _largest(asked: CrankPlanetaryRequest) -> tuple[float, float | None]:
    """Factor on the torque up to the largest torque, and that torque, if it is known."""
    found = crank_verdict(asked.results, largest=True)
    if not asked.design.load:
        return 1.0, None
    most = found.largest_torque(asked.results.design.output_torque)
    return (found.torque_reserve or 1.0, most) if most else (1.0, None)


def _values(body: SensitivityRequest, report: Report) -> Values:
    """Values of the answer without its accuracy."""
    study, torque = body.study, None
    if body.output is None and body.calculation == "crank-planetary":
        factor, torque = study.inputs.solved({}, _largest)
        study = replace(study, factor=factor)
    middle = study.side({})
    if middle.result is None:
        if middle.problem:
            raise invalid_input([middle.problem])
        raise refusal("/output", "not_there", field="answer")
    study, found = replace(study, middle=middle), list[tuple[float, Values]]()
    blocks = [[name] for name in study.steps] if body.long else [[*study.steps]]
    for rows in body.cut(study.rows, blocks):
        found += rows
        report(len(found) / len(study.steps))
    return {
        "result": middle.result,
        "output": study.output or GOVERNING,
        "governing": middle.governing,
        "torque_Nm": torque,
        "inputs": [values for _, values in sorted(found, key=lambda each: -each[0])],
        "linked": [
            *dict.fromkeys(each for name in study.steps for each in study.inputs.linked([name]))
        ],
    }


def reporting(body: SensitivityRequest, report: Report) -> Values:
    """Values of the changes; progress is reported."""
    values, run_time_us = timed(lambda: _values(body, report))
    looks = sum(4 if name in body.study.fine else 2 for name in body.study.steps)
    accuracy = Accuracy("sampling", SEARCHED, 1 + looks)
    return present(values | {"accuracy": accuracy_values(accuracy, run_time_us)})


def solve(body: SensitivityRequest) -> Values:
    """Change of a result with each of some inputs to both sides, the largest first.

    Without `output` that is the utilisation of the check that decides, of a reducer under its
    largest torque: each input changes by a hundredth, a whole number by 1, others by their
    `spread`. Of an `output` without `spread` it is the derivative of logarithms.
    """
    return reporting(body, untold)


CALCULATION = StudyCalculation(
    name="sensitivity",
    title="Inputs that matter",
    tag="exploration",
    request=SensitivityRequest,
    answer=SensitivityResponse,
    solve=solve,
    batched=False,
    reporting=reporting,
)
