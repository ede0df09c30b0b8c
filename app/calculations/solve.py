"""One input of a calculation solved for one of its results: request, answer."""

import math
from collections.abc import Iterator
from copy import deepcopy
from functools import cache, cached_property
from typing import Annotated, Any, ClassVar, Literal

from pydantic import Field, TypeAdapter, ValidationError

from app.calculations import (
    contact_force,
    crank_planetary,
    hertz,
    roller_strength,
    shaft_deflection,
)
from app.calculations.crank_planetary_sections import SECTIONS, CrankPlanetaryRequest
from app.model import (
    AccuracyOut,
    AssumingResponse,
    Calculation,
    Maybe,
    RequestModel,
    ResponseModel,
    Values,
    WarningOut,
    WorkedFields,
    accuracy_values,
    present,
    result,
    timed,
)
from app.pointers import has_number, holder, inner, keys, with_values
from app.problems import (
    FieldProblem,
    Problem,
    named,
    problem_of,
    refusal,
    refuse_for,
    wrong_fields,
)
from app.rules import Forms
from app.settings import Settings
from app.worked import stated
from core.errors import Accuracy, CalculationError, InvalidInput, Notice
from core.fixes.fix import PIN_SIZES
from core.numerics.inverse import (
    MOST_WHOLE,
    SAMPLES,
    SENSES,
    TOLERANCE,
    Sense,
    Solution,
    SolveStatus,
    Want,
    solve_for,
)

SOLVED = {
    each.name: each
    for each in (
        module.CALCULATION
        for module in (
            hertz,
            contact_force,
            crank_planetary,
            roller_strength,
            shaft_deflection,
        )
    )
}
"""Calculations whose inputs can be solved."""

LINKED = ("/contact/pin_radius_mm", "/contact/eccentricity_mm")
"""Inputs that the hole follows with unchanged clearance."""

HOLE = "/contact/hole_radius_mm"

LONG_SAMPLES = 17
"""Number of first samples of the range if each takes long."""

FEW_SAMPLES = 3
"""Number of answers without the section of the target after which the search ends."""

Pointer = Annotated[str, Field(pattern="^/", max_length=200)]


class VariableFields(RequestModel):
    """Input that is solved for."""

    pointer: Pointer = Field(description="JSON pointer to the variable in `input`.")
    low: float = Field(
        alias="from", ge=-1e12, le=1e12, description="Lower end of the range of the variable."
    )
    to: float = Field(ge=-1e12, le=1e12, description="Upper end of the range of the variable.")
    integer: bool = Field(
        default=False,
        description=f"True to try only whole numbers, {MOST_WHOLE} at most; always so if the input "
        "is a whole number.",
    )
    log: bool = Field(default=False, description="True if the range is sampled at equal ratios.")


class TargetFields(RequestModel):
    """Target of a result."""

    ALTERNATIVES: ClassVar[tuple[Forms, ...]] = ((("at_least",), ("at_most",), ("equals",)),)

    pointer: Pointer = Field(
        description="JSON pointer to the result in the answer; checks are addressed by code: "
        "`/checks/contact_pressure_hole/torque_reserve`.",
    )
    at_least: Maybe[float] = Field(description="Least value of the result.")
    at_most: Maybe[float] = Field(description="Largest value of the result.")
    equals: Maybe[float] = Field(description="Value that the result has to equal.")

    @property
    def wanted(self) -> tuple[Sense, float]:
        """Comparison and value of the target."""
        given = self.given
        return next((sense, given[sense]) for sense in SENSES if sense in given)


class SolveRequest(WorkedFields):
    """Calculation with its input, the field that may change, and the wanted result."""

    calculation: Literal[
        "hertz",
        "contact-force",
        "crank-planetary",
        "roller-strength",
        "precession/shaft-deflection",
    ] = Field(description="Name of the calculation.")
    input: dict[str, Any] = Field(description="Request of the calculation.")
    variable: VariableFields
    target: TargetFields
    want: Want = Field(
        default="smallest", description="Choice between several inputs that meet the target."
    )

    @property
    def adapter(self) -> TypeAdapter[RequestModel]:
        """Validator of the calculation's requests."""
        return TypeAdapter(SOLVED[self.calculation].request)

    @cached_property
    def design(self) -> dict[str, Any]:
        """Input, with only the requested sections that the target needs."""
        design = deepcopy(self.input)
        target = keys(self.target.pointer)
        sections = SECTIONS
        if self.calculation == "crank-planetary":
            design["include"] = [target[0] if target and target[0] in sections else "checks"]
            if target and {target[0], target[-1]} & {"torque_reserve", "largest_torque_Nm"}:
                design["include"].append("largest_torque")
        elif self.calculation in ("roller-strength", "precession/shaft-deflection"):
            design["include"] = ["checks"] if target[:1] == ["checks"] else []
        return design

    @cached_property
    def asked(self) -> RequestModel:
        """Input as the calculation's own request; a problem if the calculation refuses it."""
        try:
            return self.adapter.validate_python(self.design)
        except ValidationError as error:
            raise _refused(error) from None

    def assumed(self) -> Iterator[tuple[tuple[str, ...], Any]]:
        """Assumptions of the calculation except the solved input; an unknown clearance is assumed
        to be 0, as a target of forces is that of perfect parts.
        """
        given, asked = [*self.asked.assumed()], self.asked
        contact = getattr(asked, "contact", None)
        whole = isinstance(asked, CrankPlanetaryRequest)
        if whole and contact is not None and contact.clearance_unknown:
            given.append((("contact", "hole_clearance_mm"), 0.0))
        for path, value in given:
            if list(path) != keys(self.variable.pointer):
                yield ("input", *path), value

    def notices(self) -> tuple[Notice, ...]:
        """Notices of inputs that are interpreted differently from their typed form."""
        return self.asked.notices()

    def refuse_beyond(self, settings: Settings) -> None:
        """Refuse an input that its calculation refuses by its fields alone. An input that is no
        design as it is typed may be one at another value.
        """
        asked = self.asked
        try:
            asked.refuse_beyond(settings)
        except Problem as error:
            raise _refused(error) from error
        except InvalidInput as error:
            if error.code == "service_limit":
                raise _refused(named(error, asked)) from error

    def solve(self) -> tuple[Solution, dict[str, float], list[str], list[FieldProblem]]:
        """Solution, values that it sets, linked inputs, and why inputs beyond its edge fail."""
        calculation, adapter = SOLVED[self.calculation], self.adapter
        long = math.isinf(self.asked.cost())
        parts = keys(self.variable.pointer)
        place = holder(self.input, parts)
        if not isinstance(place, dict) or not _is_number(place.get(parts[-1], 0)):
            raise refusal("/variable/pointer", "not_there", field="input")
        target = keys(self.target.pointer)
        if not has_number(_schema(self.calculation), target):
            raise refusal("/target/pointer", "not_there", field="answer")
        start: Any = place.get(parts[-1])
        hole = holder(self.input, keys(HOLE))
        linked = []
        if self.variable.pointer in LINKED and hole and _is_number(start):
            linked = [HOLE] if _is_number(hole.get("hole_radius_mm")) else []

        def setting(value: float) -> dict[str, float]:
            one = {self.variable.pointer: value}
            return one | {HOLE: hole["hole_radius_mm"] + (value - start)} if linked else one

        def changed(value: float) -> dict[str, Any]:
            return with_values(self.design, setting(value))

        results: list[float] = []
        refusals: dict[float, Exception] = {}

        def answer(value: float) -> float:
            try:
                asked = adapter.validate_python(changed(value))
                values = _values(calculation, asked)
            except (Problem, CalculationError, ValidationError) as error:
                if isinstance(error, Problem) and _is_of_a_list(error):
                    raise _refused(error) from error
                refusals[value] = error
                return math.nan
            found = _at(values, target)
            results.append(float(found) if _is_number(found) else math.nan)
            most = FEW_SAMPLES if holder(values, target) is None else LONG_SAMPLES
            if long and len(results) >= most and all(map(math.isnan, results)):
                raise refusal("/target/pointer", "not_there", field="answer")
            return results[-1]

        between = math.floor(self.variable.low) + 0.5
        wrong = _wrong(adapter, changed(between))
        if "extra_forbidden" in wrong:
            raise refusal("/variable/pointer", "not_there", field="input")
        sense, wanted = self.target.wanted
        try:
            found = solve_for(
                function=answer,
                low=self.variable.low,
                high=self.variable.to,
                target=wanted,
                sense=sense,
                want=self.want,
                integer=self.variable.integer or "int_type" in wrong,
                log=self.variable.log,
                samples=LONG_SAMPLES if long else SAMPLES,
            )
        except InvalidInput as error:
            name = "to" if error.parameter == "high" else "from"
            params = error.params | ({"field": "from"} if error.code == "larger_than" else {})
            raise refusal(f"/variable/{name}", error.code, **params) from error
        if not results:
            raise _refused(next(iter(refusals.values())))
        if all(map(math.isnan, results)):
            raise refusal("/target/pointer", "not_there", field="answer")
        sets = {} if found.value is None else setting(found.value)
        outside = _outside(found, self.want)
        refused = []
        if outside in refusals:
            refused = problem_of(_refused(refusals[outside])).errors
        return found, sets, linked, refused


@cache
def _schema(name: str) -> dict[str, Any]:
    """JSON schema of a calculation's answer."""
    return TypeAdapter(SOLVED[name].answer).json_schema()


def _outside(found: Solution, want: Want) -> float | None:
    """Input next to the edge that does not meet the target."""
    if found.value is None or found.status == "always":
        return None
    if found.bracket is not None:
        return next(end for end in found.bracket if end != found.value)
    return found.value + (1 if want == "largest" else -1)


def _values(calculation: Calculation, asked: RequestModel) -> Values:
    """Values of an answer; a refusal names the fields of this request."""
    try:
        return calculation.solve(asked)
    except CalculationError as error:
        refuse_for(asked, error)


def _wrong(adapter: TypeAdapter[RequestModel], changed: dict[str, Any]) -> set[str]:
    """Kinds of errors of values that were set in a valid input."""
    try:
        adapter.validate_python(changed)
    except ValidationError as error:
        return {each["type"] for each in error.errors()}
    return set()


def _is_of_a_list(error: Problem) -> bool:
    """True if a list does not fit the number that was set, which no range of numbers cures."""
    return any(each.code == "different_length" for each in error.errors)


def _refused(error: Exception) -> Exception:
    """Reason for the refusal of an input, in the names of this request."""
    problem = wrong_fields(error) if isinstance(error, ValidationError) else error
    if not isinstance(problem, Problem):
        return error
    return problem.beneath("/input")


def _is_number(value: Any) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def _at(answer: Values, target: list[str]) -> Any:
    """Value at a pointer of an answer; None if there is none."""
    found: Any = answer
    for part in target:
        found = inner(found, part)
    return found


class BestOut(ResponseModel):
    """Closest result to a target that no input meets."""

    value: float = result("Value of the variable.")
    target: float = result("Result at that value.")


class SolveResponse(AssumingResponse):
    """Inputs that meet the target."""

    status: SolveStatus = Field(
        description="`always` if the whole range meets the target, `several` if more than one "
        "range does, `infeasible` if none does."
    )
    value: Maybe[float] = result(
        "Value of the variable that meets the target, as requested by `want`."
    )
    sets: Maybe[dict[str, float]] = Field(
        description="Values that the solution sets, by JSON pointer into `input`."
    )
    bracket: Maybe[tuple[float, float]] = result(
        "Neighbouring values between which the edge of the range lies."
    )
    refused: Maybe[list[FieldProblem]] = Field(
        description="Problems for which the input is refused beyond that edge, if it is; the "
        "target may be met there."
    )
    intervals: list[tuple[float, float]] = result("Ranges of the variable that meet the target.")
    best: Maybe[BestOut] = None
    monotone: bool = result(
        "True if the result only rises or only falls over the range, as sampled."
    )
    standard_size: Maybe[float] = result(
        "Radius of the next standard pin (ISO 2338) that meets the target, as `pin_radius_mm` "
        "states it."
    )
    linked: list[str] = Field(description="JSON pointers to inputs that follow the variable.")
    accuracy: AccuracyOut = Field(
        description="Accuracy of the search, by the width of the bracket. The error that the "
        "calculation states for the result moves the value as well, the less the more"
        " strongly the result depends on it."
    )
    warnings: Maybe[list[WarningOut]] = Field(
        description="Warnings about the interpretation of `input`."
    )


def solve(body: SolveRequest) -> Values:
    """Smallest or largest value of an input at which a result meets its target."""
    (found, sets, linked, refused), run_time_us = timed(body.solve)
    accuracy = Accuracy("bracketing", TOLERANCE, found.evaluations)
    values: Values = {
        "status": found.status,
        "value": found.value,
        "sets": sets or None,
        "bracket": found.bracket,
        "refused": [each.body() for each in refused] or None,
        "intervals": found.intervals,
        "best": found.best and {"value": found.best[0], "target": found.best[1]},
        "monotone": found.monotone,
        "standard_size": _standard(body, found),
        "linked": linked,
        "accuracy": accuracy_values(accuracy, run_time_us),
    }
    if "worked" in body.include:
        name = body.variable.pointer.rpartition("/")[2]
        values["worked"] = stated("solve", {name: found.value}, "root")
    return present(values)


def _standard(body: SolveRequest, found: Solution) -> float | None:
    if not body.variable.pointer.endswith("/pin_radius_mm") or found.value is None:
        return None
    if "diameter_mm" in body.input.get("pin", {}):  # the contact is that of a sleeve
        return None
    radii = [size / 2 for size in PIN_SIZES]
    if body.want == "largest":
        radii = radii[::-1]
    return next(
        (
            radius
            for radius in radii
            if any(start <= radius <= end for start, end in found.intervals)
        ),
        None,
    )


CALCULATION = Calculation(
    name="solve",
    title="An input solved for a result",
    tag="exploration",
    request=SolveRequest,
    answer=SolveResponse,
    solve=solve,
    batched=False,
)
