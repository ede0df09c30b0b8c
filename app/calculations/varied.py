"""Input of a calculation whose numbers vary: what `/solve`, `/sweep` and `/sensitivity` share."""

import math
from collections.abc import Callable, Iterable, Iterator, Mapping
from copy import deepcopy
from dataclasses import dataclass
from functools import cache, cached_property
from typing import TYPE_CHECKING, Annotated, Any, Literal

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
from app.cluster import Cut
from app.cut import over_all
from app.model import AssumedOut, Maybe, RequestModel, ResponseModel, Result, Values, WarningOut
from app.pointers import has_number, holder, inner, keys, with_values
from app.problems import Problem, named, refusal, refuse_for, wrong_fields
from app.settings import Settings, current
from core.errors import CalculationError, InvalidInput, Notice

VARIED = {
    each.CALCULATION.name: each.CALCULATION
    for each in (
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
}
"""Calculations whose inputs can vary."""

if TYPE_CHECKING:
    CalculationName = str
else:
    CalculationName = Literal[tuple(VARIED)]

JUDGED = ("crank-planetary", "roller-strength", "precession/shaft-deflection")
"""Those whose answers have checks on request."""

GOVERNING = "/checks/governing/utilisation"
"""Pointer to the utilisation of the check that decides."""

LARGEST = {"torque_reserve", "largest_torque_Nm"}
"""Results for which the largest torque is searched."""

PIN = "/contact/pin_radius_mm"

FOLLOWING = {
    "/contact/hole_radius_mm": {PIN: 1.0, "/contact/eccentricity_mm": 1.0},
    "/pin/diameter_mm": {PIN: 2.0},
}
"""Inputs that follow others with unchanged difference, and how much they do: holes with unchanged
clearance, pins that have no sleeve."""

REFUSALS = (Problem, CalculationError, ValidationError)
"""Exceptions by which a calculation refuses an input."""

Pointer = Annotated[str, Field(pattern="^/", max_length=200)]


class VariedFields(RequestModel):
    """Calculation with its input, of which some numbers vary."""

    _settings: Settings | None = PrivateAttr(default=None)
    calculation: str = Field(description="Name of the calculation.")
    input: dict[str, Any] = Field(description="Request of the calculation.")
    keep: list[Pointer] = Field(
        default=[],
        max_length=len(FOLLOWING),
        description="JSON pointers to inputs that stay as typed though they would follow those "
        "that vary.",
    )

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
    def cut(self) -> Cut:
        """Function that calculates blocks, on the cluster if they take long."""
        settings = self._settings or current()
        return over_all(settings.dask if self.long else "", settings.processes)

    @property
    def settable(self) -> "Inputs":
        """Input whose numbers are set; a problem if it has no such numbers."""
        start: dict[str, float | None] = {}
        for field, pointer in self.varied.items():
            parts = keys(pointer)
            place = holder(self.input, parts)
            if not isinstance(place, dict) or not is_number(place.get(parts[-1], 0)):
                raise refusal(field, "not_there", field="input")
            start[pointer] = place.get(parts[-1])
        for field, pointer in self.targets.items():
            if not has_number(_schema(self.calculation), _by_place(keys(pointer), "0")):
                raise refusal(field, "not_there", field="answer")
        linked = self.linked(start)
        for k, pointer in enumerate(self.keep):
            if pointer not in linked:
                raise refusal(f"/keep/{k}", "follows_nothing")
        following = {name: each for name, each in linked.items() if name not in self.keep}
        return Inputs(self.calculation, self.design, start, following, self._settings)

    def linked(self, start: Mapping[str, float | None]) -> dict[str, float]:
        """Typed values of inputs that follow those that vary."""
        linked = {}
        for pointer, others in FOLLOWING.items():
            value, radius = at(self.input, pointer), at(self.input, PIN)
            sleeve = pointer.startswith("/pin") and not (
                is_number(value) and is_number(radius) and math.isclose(value, 2 * radius)
            )
            moved = any(start.get(each) is not None for each in others)
            if moved and is_number(value) and not sleeve:
                linked[pointer] = value
        return linked

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
    following: dict[str, float]  # typed numbers that follow these, by pointer
    settings: Settings | None  # limits of the operator

    def linked(self, names: Iterable[str]) -> list[str]:
        """Pointers to inputs that follow some that are set."""
        moved = [each for each in names if self.start[each] is not None]
        return [name for name in self.following if not FOLLOWING[name].keys().isdisjoint(moved)]

    def setting(self, values: Mapping[str, float]) -> dict[str, float]:
        """Numbers that are set, with those that follow."""
        moved = {
            name: value - start
            for name, value in values.items()
            if (start := self.start[name]) is not None
        }
        return {**values} | {
            name: self.following[name]
            + sum(FOLLOWING[name].get(each, 0.0) * by for each, by in moved.items())
            for name in self.linked(values)
        }

    def changed(self, values: Mapping[str, float]) -> dict[str, Any]:
        """Input with other numbers."""
        return with_values(self.design, self.setting(values))

    def solved(self, values: Mapping[str, float], solve: Callable[[Any], Result]) -> Result:
        """Result of an input with other numbers; one of `REFUSALS` if there is none."""
        asked = _adapter(self.calculation).validate_python(self.changed(values))
        try:
            if self.settings:
                asked.refuse_beyond(self.settings)
            return solve(asked)
        except CalculationError as error:
            refuse_for(asked, error)

    def answer(self, values: Mapping[str, float]) -> Values:
        """Values of the answer to an input with other numbers; one of `REFUSALS` if there is
        none.
        """
        return self.solved(values, VARIED[self.calculation].solve)

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


def impossible(answer: Values) -> bool:
    """True if a check says that parts cannot be put together or move."""
    return any(each.get("impossible") for each in answer.get("checks", ()))


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
