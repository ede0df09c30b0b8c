"""Verdict, checks and fixes in requests and answers."""

import math
from collections.abc import Callable, Iterator, Mapping
from functools import cache, cached_property, lru_cache
from typing import Any, Literal

from pydantic import Field

from app.fields import SectionFields
from app.model import (
    REPLACED,
    AssumingResponse,
    Maybe,
    RequestModel,
    ResponseModel,
    Values,
    core_paths,
    pointer,
    present,
    result,
)
from app.problems import named
from app.units import api_params, from_si, sentence, shown_unit
from core.checks.check import (
    STATUSES,
    Check,
    Outcome,
    PartStatus,
    PartVerdict,
    Status,
    Verdict,
)
from core.checks.crank_planetary import PARTS
from core.checks.records import CHECKS
from core.checks.words import CHECK_SOURCES, GROUPS, NOT_CONSIDERED
from core.codes import CODES, WAS
from core.design.mass import PartMass
from core.design.sections import Requirements
from core.errors import if_known
from core.fixes.fix import Fix, FixStatus
from core.fixes.plain import plain_fixes
from core.hertz import LIMIT_SOURCES, Criterion, Verified

FixesFor = Literal["governing", "failed"]


class RequirementsFields(SectionFields, of=Requirements, without=("scope",), group="requirements"):
    """Limits that a design has to keep; a limit that is not given is not checked."""


class JudgedFields(RequestModel):
    """Options of a request besides the result itself."""

    requirements: RequirementsFields = Field(default_factory=RequirementsFields)
    include: list[Literal["checks", "fixes", "worked"]] = Field(
        default=[],
        max_length=3,
        description="Optional results; only those that are named are computed.",
    )
    fixes_for: FixesFor = Field(
        default="governing", description="Checks that the section `fixes` has to cure."
    )

    @cached_property
    def own(self) -> dict[str, Any]:
        """Inputs in SI units, by their names in core."""
        return self.to_core()

    def judged(
        self,
        verdict: Verdict,
        *,
        torque: float,
        design: Mapping[str, Any],
        checks: Callable[[dict[str, Any]], Verdict],
    ) -> dict[str, Any]:
        """Fields of `JudgedResponse`, with checks and fixes on request: `design` has the inputs
        that fixes may change, and `checks` judges changed ones.
        """
        judged = judgement(verdict, self, torque=torque, checks="checks" in self.include)
        if "fixes" in self.include:
            codes = codes_to_fix(verdict, self.fixes_for)
            fixes = plain_fixes(design=design, codes=codes, current=verdict, checks=checks)
            judged["fixes"] = [fix_values(each, self) for each in fixes]
        return judged


class ScopedRequirementsFields(SectionFields, of=Requirements, group="requirements"):
    """Limits that a reducer has to keep, and the parts that are judged."""


class ReasonOut(ResponseModel):
    """Reason for a status."""

    code: str = Field(description="Reason, by code.", json_schema_extra={"enum": [*CODES]})
    detail: str = Field(description="Reason, in English.")
    pointer: Maybe[str] = Field(
        description="JSON pointer to the field that the reason concerns, if it concerns one field."
    )
    params: Maybe[dict[str, Any]] = Field(
        description="Names and numbers in the text of the reason."
    )
    was: Maybe[str] = Field(description=REPLACED)


class PlaceOut(ResponseModel):
    """Place of a value."""

    satellite: Maybe[int] = result("Number of the satellite, from 1.")
    bearing: Maybe[int] = result("Number of the crankshaft bearing, 1 or 2.")
    pin: Maybe[int] = result("Number of the pin, from 1.")
    crank_angle_deg: Maybe[float] = result("Crank angle.")
    section: Maybe[Literal["root", "ring"]] = result(
        "End of a pin with a tie ring: at the carrier (root) or at the tie ring (ring)."
    )


class CheckOut(ResponseModel):
    """One check: compared values, status and reason."""

    code: str = Field(description="Code of the check.", json_schema_extra={"enum": [*CHECKS]})
    was: Maybe[str] = Field(description=REPLACED)
    title: str = Field(description="Title of the check, in English.")
    group: str = Field(description="Subject of the check.", json_schema_extra={"enum": [*GROUPS]})
    status: Status = Field(description="Result of the check.")
    needed: Maybe[bool] = Field(
        description="False if the part is judged without this check, as its input is seldom known"
        " or has no source; absent otherwise."
    )
    impossible: Maybe[bool] = Field(
        description="True if the mechanism cannot exist or move in this way; absent otherwise."
    )
    value: Maybe[float] = Field(description="Value that is compared with the limit, in `unit`.")
    limit: Maybe[float] = Field(
        description="Limit of the value, in `unit`, with the required safety included."
    )
    unit: str = Field(description="Unit of value and limit as shown; empty for plain numbers.")
    keep: Literal["below", "above"] = Field(
        description="Side of the limit on which the value has to stay."
    )
    utilisation: Maybe[float] = Field(description="Utilised part of the limit; 1 at the limit.")
    margin: Maybe[float] = Field(description="Distance of the value from the limit, in `unit`.")
    torque_reserve: Maybe[float] = Field(
        description="Factor on the torque at which the value reaches its limit, if it follows "
        "from the value; if forces are solved, only the check that fails first has "
        "one, with `largest_torque`.",
    )
    formula: str = Field(description="Condition that has to hold.")
    why: str = Field(description="Consequence if the condition does not hold, in English.")
    reason: Maybe[ReasonOut]
    source: str = Field(description="Source of the limit or the formula, in English.")
    source_code: str = Field(description="Source of the limit or the formula, by code.")
    criterion: Maybe[Criterion] = Field(
        description="Kind of damage that a material's limit guards against."
    )
    verified: Maybe[Verified] = Field(
        description="Way in which the source of a material's limit was checked."
    )
    because: Maybe[Literal["margin", "guide"]] = Field(
        description="Cause of a marginal check: `margin`, it does not hold at 1.1 times the torque;"
        " `guide`, a guide value is not kept. Where it is absent, `reason` is the cause."
    )
    life_factor: Maybe[float] = Field(
        description="Life factor contained in a material's limit, for the number of loads; absent"
        " if no curve is known.",
    )
    at: Maybe[PlaceOut]
    inputs: list[str] = Field(description="JSON pointers to the inputs on which the check depends.")
    missing: Maybe[list[str]] = Field(
        description="JSON pointers to the inputs that the check lacks."
    )


class PartOut(ResponseModel):
    """Verdict of a part of the reducer."""

    code: str = Field(description="Code of the part.", json_schema_extra={"enum": [*PARTS]})
    title: str = Field(description="Title of the part, in English.")
    status: PartStatus = Field(
        description="`fail` if a check of the part fails, else `open` if an input that the part "
        "needs is not known, else `marginal` or `pass`; `left_out` if the part is not"
        " in `requirements.scope`, `not_asked` if no limit is requested."
    )
    governing: Maybe[str] = Field(
        description="Check that decides, of those that are made of the part.",
        json_schema_extra={"enum": [*CHECKS]},
    )
    reason: Maybe[str] = Field(
        description="Reason why the part is open, by code.", json_schema_extra={"enum": [*CODES]}
    )
    detail: Maybe[str] = Field(description="Reason why the part is open, in English.")
    missing: Maybe[list[str]] = Field(
        description="JSON pointers to the inputs that the part lacks."
    )


class SideEffectOut(ResponseModel):
    """Effect of a fix on another check."""

    code: str = Field(description="Code of the check that changes.")
    status_from: Status = Field(description="Status of the check without the fix.")
    status_to: Status = Field(description="Status of the check with the fix.")
    utilisation_from: Maybe[float] = Field(description="Utilisation of the check without the fix.")
    utilisation_to: Maybe[float] = Field(description="Utilisation of the check with the fix.")


class FixOut(ResponseModel):
    """One input changed so that a check passes."""

    code: str = Field(description="Code of the check that the fix cures.")
    pointer: str = Field(description="JSON pointer to the input that is changed.")
    title: str = Field(description="Name of the input, in English.")
    unit: str = Field(description="Unit of the input as shown.")
    before: float | str = Field(alias="from", description="Present value of the input.")
    to: float | str = Field(
        description="Value of the input with the fix, rounded to the safe side, or a name if the "
        "input is a choice."
    )
    exact: Maybe[float] = Field(description="Value before rounding, if it is solved for.")
    change: Maybe[float] = Field(description="Relative change of the value, if it is solved for.")
    standard: Maybe[str] = Field(description="Standard that has a part of this size.")
    sets: dict[str, float | str] = Field(description="Values that the fix sets, by JSON pointer.")
    status: FixStatus = Field(description="Status that says if the fix cures the check.")
    verdict: Outcome = Field(description="Verdict of the whole design with the fix.")
    side_effects: list[SideEffectOut] = Field(description="Other checks that change.")


class JudgedResponse(AssumingResponse):
    """An answer with a verdict."""

    BESIDE = ("fixes",)

    verdict: Maybe[Outcome] = Field(
        description="`fail` if a check fails, else `incomplete` if a check could not be made or "
        "no check concerns strength under the load, else `marginal`, else `pass`. A "
        "reducer with `parts` has the verdict of its parts, `incomplete` if a part is"
        " open. The verdict says nothing about `not_considered`. Verdict and checks "
        "are left out if `include` names only other sections."
    )
    governing: Maybe[str] = Field(
        description="Code of the check that limits most; a condition that is only necessary counts "
        "by what it uses of its limit.",
        json_schema_extra={"enum": [*CHECKS]},
    )
    torque_reserve: Maybe[float] = Field(
        description="Factor on the torque at which the first check fails. A reducer has it with "
        "`largest_torque`: if forces are solved, it is the largest factor that was "
        "examined and holds, with a failing one at most 1 % above, or 5 % beside a "
        "jump. The factor is absent if none is found."
    )
    largest_torque_Nm: Maybe[float] = Field(
        description="Torque times `torque_reserve`; absent if less torque cures nothing or an "
        "input is not known. The value of a reducer is the least over "
        "`largest_torque_of`, as far as these parts are judged, and is absent while "
        "the clearance is not known.",
    )
    counts: Maybe[dict[str, int]] = Field(description=f"Checks by status: {', '.join(STATUSES)}.")
    not_considered: Maybe[list[str]] = Field(
        description="Effects and parts that the verdict does not consider: "
        + "; ".join(f"`{code}`, {text}" for code, text in NOT_CONSIDERED.items())
        + "."
    )
    checks: Maybe[list[CheckOut]] = Field(
        description="All checks, the deciding one first, if requested."
    )
    fixes: Maybe[list[FixOut]] = Field(
        description="Changes that cure the governing check, or all that fail, if requested; empty"
        " if no change of a value that can be offered does so."
    )


SOURCES = LIMIT_SOURCES | CHECK_SOURCES


@cache
def _kind_values(code: str) -> Values:
    """Values common to all checks of a kind."""
    kind, was = CHECKS[code], WAS["checks"].get(code)
    return present(
        {
            "code": code,
            "was": was,
            "title": kind.title,
            "group": kind.group,
            "unit": shown_unit(f"value_{kind.unit}"),
            "keep": kind.keep,
            "formula": kind.formula,
            "why": kind.why,
        }
    )


_ALONG = ("build.gap", "pin.contact_length", "contact.contact_length")

FOLLOWS = {
    "load.output_torque": ("load.input_torque", "load.efficiency"),
    "mechanism.ratio": (
        "mechanism.output_ratio",
        "mechanism.satellite_teeth",
        "mechanism.ring_teeth",
    ),
    "gear.teeth_difference": ("mechanism.satellite_teeth", "mechanism.ring_teeth"),
    "contact.hole_radius": (
        "contact.pin_radius",
        "contact.eccentricity",
        "contact.hole_clearance",
        "contact.fit",
    ),
    "pin.satellite_positions": _ALONG,
    "pin.span": _ALONG,
    "crankshaft.satellite_positions": ("pin.satellite_positions",),
    "crankshaft.bearing_positions": (
        "pin.satellite_positions",
        "build.carrier_width",
        "build.second_carrier_width",
        "pin.diameter",
        "contact.pin_radius",
        "crankshaft.bearings",
    ),
}
"""Values of a design that a request may leave out, with the values that they follow from."""


@lru_cache(maxsize=64)
def _inputs(model: type[RequestModel], given: frozenset[tuple[str, ...]]) -> dict[str, list[str]]:
    """JSON pointers to the given inputs of each check, or to the fields that they follow from."""
    paths = core_paths(model)

    def there(*names: str) -> Iterator[str]:
        for name in names:
            stated = [path for path in paths.get(name, ()) if path in given]
            if stated:
                yield pointer(stated[0])
            else:
                yield from there(*FOLLOWS.get(name, ()))

    return {code: [*dict.fromkeys(there(*kind.inputs))] for code, kind in CHECKS.items()}


def _reason(found: Check | PartVerdict | PartMass, body: RequestModel) -> Values:
    """Reason for the status of a check or part, in the words of the refusal if one exists."""
    values: Values = {"code": found.reason}
    if found.refusal is None:
        params = api_params({**found.params})
        values["detail"] = sentence(found.reason, params)
    else:
        refused = named(found.refusal, body)
        (error,) = refused.errors
        values |= {"detail": refused.detail, "pointer": error.pointer}
        params = error.params
    if params:
        values["params"] = params
    if was := WAS["reasons"].get(found.reason):
        values["was"] = was
    return values


IDEAL_ALONE = ("contact.distribution_factor", "load.force_exponent")
"""Inputs of ideal forces that solved forces do not use."""


def usual_values(body: Any, verdict: Verdict) -> dict[tuple[str, ...], float | str]:
    """Assumed values by which checks of a reducer are judged, by paths of fields."""
    found: dict[tuple[str, ...], float | str] = {}
    decided = [each for each in verdict.checks if each.status in ("pass", "marginal", "fail")]
    assumed = body.design.usual
    for check, name in ((each, name) for each in decided for name in each.kind.inputs):
        path = body.path_of(name)
        parent = value_in(body, path[:-1])
        usual = assumed | {"requirements.static_safety": check.limit}
        if not path or (parent is None and name not in usual):
            continue
        if parent is not None and path[-1] in parent.model_fields_set:
            continue
        if name in IDEAL_ALONE and body.design.as_made:
            continue
        value = getattr(parent, path[-1], None)
        if value is None:
            value = from_si(path[-1], usual.get(name))
        if isinstance(value, (float, str)):
            found.setdefault(path, value)
    mechanism = body.mechanism
    if any(each.kind.loaded for each in decided) and "output" not in mechanism.model_fields_set:
        found["mechanism", "output"] = mechanism.output
    return found


def check_values(check: Check, body: RequestModel, inputs: list[str]) -> Values:
    """Values of a check, with its inputs as pointers into a request."""
    kind = check.kind
    unit, source = f"value_{kind.unit}", check.limit_source or kind.source
    at = dict(check.at)
    if "crank_angle" in at:
        at["crank_angle_deg"] = from_si("angle_deg", at.pop("crank_angle"))
    values: Values = {
        "status": check.status,
        "needed": None if check.needed else False,
        "impossible": True if check.impossible and check.status == "fail" else None,
        "value": from_si(unit, check.value),
        "limit": from_si(unit, check.limit),
        "utilisation": check.utilisation,
        "margin": from_si(unit, if_known(lambda: check.margin)),
        "torque_reserve": None if check.solved else check.torque_reserve,
        "source": SOURCES[source or "user"],
        "source_code": source or "user",
        "criterion": check.criterion or None,
        "verified": check.verified or None,
        "life_factor": check.life_factor,
        "because": check.because or None,
        "at": at or None,
        "inputs": inputs,
    }
    return _kind_values(check.code) | present(values | lacking(check, body))


def lacking(found: Check | PartMass, body: RequestModel) -> Values:
    """Reason for a status or an unknown mass, and pointers to the inputs that it lacks."""
    paths = [path for name in found.missing if (path := body.path_of(name))]
    return {
        "reason": _reason(found, body) if found.reason else None,
        "missing": [*map(pointer, paths)] or None,
    }


def value_in(body: Any, path: tuple[str | int, ...]) -> Any:
    """Value at a path of a request; None if a part on the way is not given."""
    for part in path:
        if body is None:
            break
        body = body[part] if isinstance(part, int) else getattr(body, part, None)
    return body


def places_of(variable: str, body: RequestModel) -> list[tuple[str | int, ...]]:
    """Paths of the fields that a fix of an input sets: those of both bearings of the crankshaft."""
    section, _, name = variable.rpartition(".")
    both = section == "crankshaft.bearings"
    names = [f"{section}[{index}].{name}" for index in (0, 1)] if both else [variable]
    return [path for each in names if (path := body.path_of(each))]


def _typed(body: RequestModel) -> dict[str, tuple[str | int, ...]]:
    """Paths of typed fields that determine the size of another one."""
    every = (
        "load.output_torque",
        "contact.hole_radius",
        "contact.hole_clearance",
        "pin.diameter",
    )
    return {name: path for name in every if (path := body.path_of(name)) in body.given_paths}


def _short(value: float) -> float:
    """Number without the rounding of units and sums."""
    return float(f"{value:.12g}")


def _of_size(fix: Fix, body: RequestModel) -> tuple[tuple[str | int, ...], Values]:
    """Place of a fix of a size in a request, and all values that the fix sets there."""
    path, *_ = paths = places_of(fix.variable, body)
    typed = _typed(body)
    name = str(path[-1])
    before, to, exact = (from_si(name, each) for each in (fix.before, fix.after, fix.exact))
    if fix.variable == "load.output_torque" and fix.variable not in typed:  # input torque is given
        name = "input_torque_Nm"
        given_path = (*path[:-1], name)
        path, paths, given = given_path, [given_path], value_in(body, given_path)
        to, exact = (given * each / before for each in (to, exact))
        before = given
        digit = 10.0 ** (math.floor(math.log10(to)) - 2)
        to = math.floor(to / digit) * digit  # at most the torque that cures
    if fix.after != fix.exact:  # a rounded size stays one in the field's unit
        to = _short(to)
    sets = {pointer(each): to for each in paths}
    match fix.variable, typed:
        case "contact.pin_radius" | "contact.eccentricity", {"contact.hole_radius": hole}:
            sets[pointer(hole)] = _short(value_in(body, hole) + to - before)
        case "contact.hole_radius", {"contact.hole_clearance": clearance}:
            sets[pointer(clearance)] = _short(value_in(body, clearance) + to - before)
            if fix.variable not in typed:  # the hole follows the clearance
                del sets[pointer(path)]
    if fix.variable == "contact.pin_radius" and "pin.diameter" in typed:
        pin = typed["pin.diameter"]
        if math.isclose(float(value_in(body, pin)), 2 * before, rel_tol=1e-12):  # without a sleeve
            sets[pointer(pin)] = 2 * to
    for name, value in fix.beside.items():
        place = body.path_of(name)  # fields of one section
        sets[pointer(place)] = _short(from_si(str(place[-1]), value))
    return path, {"from": before, "to": to, "exact": exact, "sets": sets}


def fix_values(fix: Fix, body: RequestModel) -> Values:
    """Values of a fix, with all fields that it sets in a request."""
    if isinstance(fix.after, str):
        path, *_ = paths = places_of(fix.variable, body)
        sets = {pointer(each): fix.after for each in paths}
        changed: Values = {"from": fix.before, "to": fix.after, "sets": sets}
    else:
        path, changed = _of_size(fix, body)
    name = str(path[-1])
    parent: Any = value_in(body, path[:-1])
    values: Values = {
        "code": fix.code,
        "pointer": pointer(path),
        "title": type(parent).model_fields[name].title,
        "unit": shown_unit(name),
        **changed,
        "change": fix.change,
        "standard": "ISO 2338" if fix.standard else None,
        "status": fix.status,
        "verdict": fix.verdict,
        "side_effects": [
            present(
                {
                    "code": each.code,
                    "status_from": each.before.status,
                    "status_to": each.after.status,
                    "utilisation_from": each.before.utilisation,
                    "utilisation_to": each.after.utilisation,
                }
            )
            for each in fix.side_effects
        ],
    }
    return present(values)


def judgement(
    verdict: Verdict,
    body: RequestModel,
    *,
    torque: float,
    checks: bool,
    largest: bool = True,
) -> dict[str, Any]:
    """Fields of `JudgedResponse` except fixes; None for absent values, such as a largest torque
    that was not requested or has no load.
    """
    most = verdict.largest_torque(torque) if largest else None
    values: list[Values] | None = None
    if checks:
        inputs = _inputs(type(body), body.given_paths)
        shown = verdict.checks
        if verdict.impossible:  # no torque to be factors of
            shown = tuple(each._replace(torque_reserve=None) for each in shown)
        values = [check_values(each, body, inputs[each.code]) for each in shown]
    own: Values = {}
    if verdict.parts:
        own["parts"] = [part_values(each, body) for each in verdict.parts]
        if most is not None:
            own["largest_torque_of"] = list(verdict.largest_torque_of)
            own["largest_torque_without"] = list(verdict.uncounted) or None
    return own | {
        "verdict": verdict.verdict,
        "governing": verdict.governing,
        "torque_reserve": verdict.torque_reserve if largest else None,
        "largest_torque_Nm": most,
        "counts": verdict.counts,
        "not_considered": list(verdict.not_considered),
        "checks": values,
    }


def part_values(found: PartVerdict, body: RequestModel) -> Values:
    """Values of a part's verdict."""
    paths = [path for name in found.missing if (path := body.path_of(name))]
    values: Values = {
        "code": found.code,
        "title": PARTS[found.code].title,
        "status": found.status,
        "governing": found.governing,
        "reason": found.reason or None,
        "detail": _reason(found, body)["detail"] if found.reason else None,
        "missing": [pointer(path) for path in paths] or None,
    }
    return present(values)


def codes_to_fix(verdict: Verdict, which: FixesFor) -> list[str]:
    """Codes of checks to be fixed: the governing one unless it passes, or all that fail."""
    if which == "failed":
        return [each.code for each in verdict.checks if each.status == "fail"]
    governing = (each for each in verdict.checks if each.code == verdict.governing)
    return [each.code for each in governing if each.status in ("fail", "marginal")]
