"""One input of a calculation solved for one of its results: request, answer."""

import math
from typing import ClassVar, Literal

from pydantic import Field

from app.calculations.varied import (
    REFUSALS,
    Pointer,
    VariedFields,
    at,
    is_number,
    is_of_a_list,
    refused,
)
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
from app.pointers import holder, keys
from app.problems import (
    FieldProblem,
    problem_of,
    refusal,
)
from app.rules import Forms
from app.worked import stated
from core.errors import Accuracy, InvalidInput
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

LONG_SAMPLES = 17
"""Number of first samples of the range if each takes long."""

FEW_SAMPLES = 3
"""Number of answers without the section of the target after which the search ends."""


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


class SolveRequest(VariedFields, WorkedFields):
    """Calculation with its input, the field that may change, and the wanted result."""

    calculation: Literal[
        "hertz",
        "contact-force",
        "crank-planetary",
        "roller-strength",
        "precession/shaft-deflection",
    ] = Field(description="Name of the calculation.")
    variable: VariableFields
    target: TargetFields
    want: Want = Field(
        default="smallest", description="Choice between several inputs that meet the target."
    )

    @property
    def varied(self) -> dict[str, str]:
        """Pointer to the variable."""
        return {"/variable/pointer": self.variable.pointer}

    @property
    def targets(self) -> dict[str, str]:
        """Pointer to the result."""
        return {"/target/pointer": self.target.pointer}

    def solve(self) -> tuple[Solution, dict[str, float], list[str], list[FieldProblem]]:
        """Solution, values that it sets, linked inputs, and why inputs beyond its edge fail."""
        long, inputs = self.long, self.settable
        variable, target = self.variable.pointer, self.target.pointer
        results: list[float] = []
        refusals: dict[float, Exception] = {}

        def answer(value: float) -> float:
            try:
                values = inputs.answer({variable: value})
            except REFUSALS as error:
                if is_of_a_list(error):
                    raise refused(error) from error
                refusals[value] = error
                return math.nan
            found = at(values, target)
            results.append(float(found) if is_number(found) else math.nan)
            most = FEW_SAMPLES if holder(values, keys(target)) is None else LONG_SAMPLES
            if long and len(results) >= most and all(map(math.isnan, results)):
                raise refusal("/target/pointer", "not_there", field="answer")
            return results[-1]

        whole = inputs.takes_whole(variable, self.variable.low, "/variable/pointer")
        sense, wanted = self.target.wanted
        try:
            found = solve_for(
                function=answer,
                low=self.variable.low,
                high=self.variable.to,
                target=wanted,
                sense=sense,
                want=self.want,
                integer=self.variable.integer or whole,
                log=self.variable.log,
                samples=LONG_SAMPLES if long else SAMPLES,
            )
        except InvalidInput as error:
            name = "to" if error.parameter == "high" else "from"
            params = error.params | ({"field": "from"} if error.code == "larger_than" else {})
            raise refusal(f"/variable/{name}", error.code, **params) from error
        if not results:
            raise refused(next(iter(refusals.values())))
        if all(map(math.isnan, results)):
            raise refusal("/target/pointer", "not_there", field="answer")
        sets = {} if found.value is None else inputs.setting({variable: found.value})
        outside = _outside(found, self.want)
        beyond = []
        if outside in refusals:
            beyond = problem_of(refused(refusals[outside])).errors
        return found, sets, inputs.linked([variable]), beyond


def _outside(found: Solution, want: Want) -> float | None:
    """Input next to the edge that does not meet the target."""
    if found.value is None or found.status == "always":
        return None
    if found.bracket is not None:
        return next(end for end in found.bracket if end != found.value)
    return found.value + (1 if want == "largest" else -1)


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
