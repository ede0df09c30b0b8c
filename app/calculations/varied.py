"""Input of a calculation whose numbers vary: what `/solve`, `/sweep` and `/sensitivity` share."""

import math
from collections.abc import Iterator, Mapping
from copy import deepcopy
from dataclasses import dataclass
from functools import cache, cached_property
from typing import Annotated, Any

from pydantic import Field, PrivateAttr, TypeAdapter, ValidationError

from app.calculations import (
    contact_force,
    contact_line,
    crank_planetary,
    crankshaft,
    cyclogram,
    fit,
    hertz,
    load_sharing,
    meshing_load,
    output_efficiency,
    pin_strength,
    ring_mesh,
    roller_strength,
    satellite_bearing,
    shaft_deflection,
)
from app.calculations.crank_planetary_sections import SECTIONS, CrankPlanetaryRequest
from app.model import AssumedOut, Maybe, RequestModel, ResponseModel, Values, WarningOut
from app.pointers import has_number, holder, inner, keys, with_values
from app.problems import Problem, named, refusal, refuse_for, wrong_fields
from app.settings import Settings
from core.errors import CalculationError, InvalidInput, Notice

VARIED = {
    each.name: each
    for each in (
        module.CALCULATION
        for module in (
            hertz,
            contact_force,
            crank_planetary,
            roller_strength,
            shaft_deflection,
            cyclogram,
            output_efficiency,
            fit,
            load_sharing,
            ring_mesh,
            pin_strength,
            satellite_bearing,
            crankshaft,
            contact_line,
            meshing_load,
        )
    )
}
"""Calculations whose inputs can vary."""

JUDGED = ("crank-planetary", "roller-strength", "precession/shaft-deflection")
"""Those whose answers have checks on request."""

GOVERNING = "/checks/governing/utilisation"
"""Pointer to the utilisation of the check that decides."""

LARGEST = {"torque_reserve", "largest_torque_Nm"}
"""Results for which the largest torque is searched."""

LINKED = ("/contact/pin_radius_mm", "/contact/eccentricity_mm")
"""Inputs that the hole follows with unchanged clearance."""

HOLE = "/contact/hole_radius_mm"

REFUSALS = (Problem, CalculationError, ValidationError)
"""Exceptions by which a calculation refuses an input."""

Pointer = Annotated[str, Field(pattern="^/", max_length=200)]


class VariedFields(RequestModel):
    """Calculation with its input, of which some numbers vary."""

    _settings: Settings | None = PrivateAttr(default=None)
    calculation: str = Field(description="Name of the calculation.")
    input: dict[str, Any] = Field(description="Request of the calculation.")

    @property
    def varied(self) -> dict[str, str]:
        """Pointers to the inputs that vary, by the places that name them in this request."""
        raise NotImplementedError

    @property
    def targets(self) -> dict[str, str]:
        """Pointers to the results that are read, by the places that name them in this request."""
        raise NotImplementedError

    @cached_property
    def design(self) -> dict[str, Any]:
        """Input, with only the requested sections that the targets need."""
        design, targets = deepcopy(self.input), [keys(each) for each in self.targets.values()]
        if self.calculation == "crank-planetary":
            sections = [each[0] if each[0] in SECTIONS else "checks" for each in targets]
            if any({each[0], each[-1]} & LARGEST for each in targets):
                sections.append("largest_torque")
            design["include"] = [*dict.fromkeys(sections)]
        elif self.calculation in JUDGED:
            design["include"] = ["checks"] if any(each[0] == "checks" for each in targets) else []
        return design

    @cached_property
    def asked(self) -> RequestModel:
        """Input as the calculation's own request; a problem if the calculation refuses it."""
        try:
            return _adapter(self.calculation).validate_python(self.design)
        except ValidationError as error:
            raise refused(error) from None

    @property
    def long(self) -> bool:
        """True if an answer takes long."""
        return math.isinf(self.asked.cost())

    @property
    def inputs(self) -> "Inputs":
        """Input whose numbers are set; a problem if it has no such numbers."""
        start = {}
        for field, pointer in self.varied.items():
            parts = keys(pointer)
            place = holder(self.input, parts)
            if not isinstance(place, dict) or not is_number(place.get(parts[-1], 0)):
                raise refusal(field, "not_there", field="input")
            start[pointer] = place.get(parts[-1])
        for field, pointer in self.targets.items():
            if not has_number(_schema(self.calculation), _by_place(keys(pointer), "0")):
                raise refusal(field, "not_there", field="answer")
        hole = holder(self.input, keys(HOLE))
        radius = hole.get("hole_radius_mm") if isinstance(hole, dict) else None
        follows = any(is_number(start.get(each)) for each in LINKED) and HOLE not in start
        linked = radius if follows and is_number(radius) else None
        return Inputs(self.calculation, self.design, start, linked, self._settings)

    def assumed(self) -> Iterator[tuple[tuple[str, ...], Any]]:
        """Assumptions of the calculation except inputs that vary; an unknown clearance is assumed
        to be 0, as a target of forces is that of perfect parts.
        """
        given, asked = [*self.asked.assumed()], self.asked
        contact = getattr(asked, "contact", None)
        whole = isinstance(asked, CrankPlanetaryRequest)
        if whole and contact is not None and contact.clearance_unknown:
            given.append((("contact", "hole_clearance_mm"), 0.0))
        varied = [keys(each) for each in self.varied.values()]
        for path, value in given:
            if list(path) not in varied:
                yield ("input", *path), value

    def notices(self) -> tuple[Notice, ...]:
        """Notices of inputs that are interpreted differently from their typed form."""
        return self.asked.notices()

    def refuse_beyond(self, settings: Settings) -> None:
        """Refuse an input that its calculation refuses by its fields alone. An input that is no
        design as it is typed may be one at another value.
        """
        asked, self._settings = self.asked, settings
        try:
            asked.refuse_beyond(settings)
        except Problem as error:
            raise refused(error) from error
        except InvalidInput as error:
            if error.code == "service_limit":
                raise refused(named(error, asked)) from error


class VariedResponse(ResponseModel):
    """Answer about an input whose numbers vary."""

    linked: list[str] = Field(description="JSON pointers to inputs that follow those that vary.")
    assumed: Maybe[list[AssumedOut]] = Field(
        description="Values that were not given and decide about the answer."
    )
    warnings: Maybe[list[WarningOut]] = Field(
        description="Warnings about the interpretation of `input`."
    )


@dataclass(frozen=True, slots=True)
class Inputs:
    """Input of a calculation some numbers of which are set."""

    calculation: str  # its name
    design: dict[str, Any]  # input as typed
    start: dict[str, float | None]  # typed numbers by pointer; None for those not given
    hole: float | None  # typed radius of the hole that follows; None if none does
    settings: Settings | None  # limits of the operator

    @property
    def linked(self) -> list[str]:
        """Pointers to inputs that follow those that vary."""
        return [] if self.hole is None else [HOLE]

    def setting(self, values: Mapping[str, float]) -> dict[str, float]:
        """Numbers that are set, with that of the hole that follows."""
        if self.hole is None:
            return {**values}
        moved = [
            value - start
            for name, value in values.items()
            if name in LINKED and (start := self.start[name]) is not None
        ]
        return {**values, HOLE: self.hole + sum(moved)}

    def changed(self, values: Mapping[str, float]) -> dict[str, Any]:
        """Input with other numbers."""
        return with_values(self.design, self.setting(values))

    def answer(self, values: Mapping[str, float]) -> Values:
        """Values of the answer to an input with other numbers; one of `REFUSALS` if there is none.
        A list that does not fit a number is a problem of the whole request.
        """
        asked = _adapter(self.calculation).validate_python(self.changed(values))
        try:
            if self.settings:
                asked.refuse_beyond(self.settings)
            found: Values = VARIED[self.calculation].solve(asked)
            return found
        except CalculationError as error:
            refuse_for(asked, error)

    def takes_whole(self, pointer: str, near: float, field: str) -> bool:
        """True if an input takes whole numbers only; a problem of a field if there is no input."""
        try:
            asked = self.changed({pointer: math.floor(near) + 0.5})
            _adapter(self.calculation).validate_python(asked)
        except ValidationError as error:
            wrong = {each["type"] for each in error.errors()}
            if "extra_forbidden" in wrong:
                raise refusal(field, "not_there", field="input") from None
            return "int_type" in wrong
        return False


@cache
def _schema(name: str) -> dict[str, Any]:
    """JSON schema of a calculation's answer."""
    return TypeAdapter(VARIED[name].answer).json_schema()


@cache
def _adapter(name: str) -> TypeAdapter[RequestModel]:
    """Validator of a calculation's requests."""
    return TypeAdapter(VARIED[name].request)


def _by_place(path: list[str], governing: str) -> list[str]:
    """Path with the governing check by its code, or its place in the list."""
    return ["checks", governing, *path[2:]] if path[:2] == ["checks", "governing"] else path


def at(answer: Values, target: str) -> Any:
    """Value at a pointer of an answer; None if there is none."""
    found: Any = answer
    for part in _by_place(keys(target), answer.get("governing") or ""):
        found = inner(found, part)
    return found


def is_of_a_list(error: Exception) -> bool:
    """True if a list does not fit the number that was set, which no range of numbers cures."""
    return isinstance(error, Problem) and any(
        each.code == "different_length" for each in error.errors
    )


def refused(error: Exception) -> Exception:
    """Reason for the refusal of an input, in the names of this request."""
    problem = wrong_fields(error) if isinstance(error, ValidationError) else error
    if not isinstance(problem, Problem):
        return error
    return problem.beneath("/input")


def is_number(value: Any) -> bool:
    """True for numbers, which truth values are not."""
    return isinstance(value, (int, float)) and not isinstance(value, bool)
