"""Check, its record, comparison of a value with its limit, verdicts of parts and of the whole."""

import math
from collections.abc import Callable, Iterable, Mapping, Set
from dataclasses import dataclass, field
from typing import Any, Literal, NamedTuple, TypeVar, get_args

from core.checks.inputs import Paths, paths
from core.design.document import value_at
from core.errors import UNKNOWN, ImpossibleMechanism, InvalidInput, NotKnown, required
from core.hertz import Spread
from core.precision import AS_TYPED, ROUNDING

Status = Literal["pass", "marginal", "fail", "not_checked", "not_asked", "not_applicable"]

STATUSES: tuple[Status, ...] = get_args(Status)

Outcome = Literal["pass", "marginal", "fail", "incomplete"]

PartStatus = Literal["pass", "marginal", "fail", "open", "left_out", "not_asked"]

MARGIN = 1.1
"""Torque reserve below which a check is marginal."""


BY_RANGE = ("range_decides", "default_decides")
"""Reasons of a marginal check that fails only at one end of the range of an assumed value."""

DOUBTS = ("pressure_error", "shakedown_unknown", *BY_RANGE)
"""Reasons of a marginal check that other torques do not change."""

Given = TypeVar("Given")

Judge = Callable[..., "Check | Measure"]
"""Function that makes the check of a design; it may return a `Measure` if the limit is
requested."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Kind:
    """Record of a check, attached to the function that makes it."""

    code: str  # name in answers
    title: str  # name in English
    group: str  # subject, a key of `GROUPS`
    part: str = ""  # part of the reducer that is judged, a key of `PARTS`; empty for other gears
    needed: bool = True  # True if the part is open without the check
    formula: str  # condition that has to hold
    why: str  # consequence of a failure, in English
    inputs: tuple[str, ...]  # paths of all inputs
    fixes: tuple[str, ...] = ()  # paths of inputs that a fix may change
    unit: str = ""  # unit of value and limit, as in names of fields; empty for plain numbers
    source: str = "geometry"  # source of the formula, a key of `CHECK_SOURCES`
    keep: Literal["below", "above"] = "below"  # allowed side of the limit
    needs: tuple[str, ...] = ()  # sections that a design must have for the check to be made
    # Further required inputs, by path, with the code of the reason if they are not given.
    requires: Mapping[str, str] = field(default_factory=dict)
    # Function that returns a code why the check does not apply to a design; empty if it applies.
    not_of: Callable[..., str] = field(default_factory=lambda: lambda *_: "")
    demands: tuple[str, ...] = ()  # requirements; without any, an unknown value is `not_asked`
    asks: str = ""  # requirement that states the limit, if a user may request one
    impossible: bool = False  # True if a design that fails cannot exist or move
    only_asked: bool = False  # True if the value is calculated only when a limit is requested
    asked_alone: bool = False  # True if a requested limit makes the check need no sections
    # Function that returns attributes known without the value, such as the limit.
    known: Callable[..., dict[str, Any]] = field(default_factory=lambda: lambda *_: {})
    judge: "Judge"  # function that makes the check; the record is its first argument

    @property
    def loaded(self) -> bool:
        """True if the check depends on the output torque."""
        return "load.output_torque" in self.inputs

    def sections(self, given: Set[str]) -> tuple[str, ...]:
        """Sections that the check needs; `given` are a design's sections and requested limits."""
        return (self.asks,) if self.asked_alone and self.asks in given else self.needs

    def of(self, *design: Any, unforced: bool = False) -> "Check":
        """Check of a design and its results; it states the reason if it could not be made.
        `unforced` marks a design whose meshes cannot exist or move, so that no force is known.
        """
        try:
            found = self._found(*design, unforced=unforced)
        except Unjudged as why:
            found = self.unknown(why)._replace(**why.known)
        except UNKNOWN as why:
            found = self.unknown(why)
            demanded = [value_at(design[0], path) is not None for path in self.demands]
            asked = any(demanded) or not (self.demands and isinstance(why, NotKnown))
            known = {} if unforced else self.known(*design)
            found = found._replace(**known if asked else {"status": "not_asked"})
        if self.asks:
            return self._asked(found, getattr(design[0].requirements, self.asks))
        assert isinstance(found, Check)
        return found

    def _found(self, *design: Any, unforced: bool) -> "Check | Measure":
        """Call the check's function, unless the design rules the check out."""
        if reason := self.not_of(*design):
            return Check(self, "not_applicable", reason=reason)
        for path, code in self.requires.items():
            required(value_at(design[0], path), code, path)
        if self.only_asked and not asked_of(design[0], self.asks):
            raise NotKnown("no_limit")
        if unforced:
            raise NotKnown("cannot_be")
        return self.judge(self, *design)

    def _asked(self, found: "Check | Measure", limit: float | None) -> "Check":
        """Judge what was found against a limit that a user may request."""
        if isinstance(found, Check) and found.status == "not_applicable":
            return found._replace(limit=limit)
        if limit is None:
            missing = (f"requirements.{self.asks}",)
            return Check(self, "not_asked", value=found.value, reason="no_limit", missing=missing)
        if isinstance(found, Check):
            return found._replace(limit=limit)
        value, error, at, solved = found.value, found.error, found.at, found.solved
        reserve = found.reserve(limit / value) if found.reserve and value > 0 else None
        check = self.judged(value, limit, reserve=reserve, error=error, at=at, solved=solved)
        check = check._replace(reason=found.reason or check.reason)
        return check._replace(utilisation=found.used(limit)) if found.used else check

    def unknown(self, why: NotKnown | ImpossibleMechanism) -> "Check":
        """Check that could not be made, with the reason."""
        found = Check(self, "not_checked", reason=why.code)
        if isinstance(why, ImpossibleMechanism):
            return found._replace(params=why.where | why.params)
        return found._replace(missing=why.missing, refusal=why.refusal, params=why.params)

    def judged(
        self,
        value: float,
        limit: float,
        *,
        reserve: float | None = None,
        error: float = 4 * ROUNDING,
        warning: str = "",
        **more: Any,
    ) -> "Check":
        """Check of a value against its limit; `more` sets further attributes.

        The reserve is the factor on the torque at which the value is at its limit. A limit within
        the relative error of value and model makes the check marginal; an infinite error leaves it
        unchecked, as does an error of 1 or more with a smaller limit. A warning is the reason of a
        failure that is only a warning.

        >>> from core.checks.records import CHECKS
        >>> CHECKS["pin_static"].judged(90.0, 100.0, reserve=1.2).status
        'pass'
        >>> CHECKS["pin_static"].judged(99.0, 100.0, reserve=1.02).status
        'marginal'
        >>> CHECKS["wall_holes"].judged(1.0, 2.0).utilisation
        2.0
        """
        part, whole = (value, limit) if self.keep == "below" else (limit, value)
        used = whole > 0 and part >= 0 and limit > 0  # a limit of 0 has no utilisation
        utilisation = part / whole if used else None
        doubtful = abs(value - limit) <= error * abs(value)
        if not error < (1.0 if value > limit else math.inf):
            more |= {"reason": "value_unknown"}
            return Check(self, "not_checked", value=value, limit=limit, **more)
        status: Status = "pass"
        if doubtful and reserve is not None:  # a size equal to its requested limit passes
            status = "marginal"
            if error > AS_TYPED:
                more.setdefault("reason", "pressure_error")
        elif not (part <= whole or doubtful):
            status = "marginal" if warning else "fail"
            more.setdefault("reason", warning)
        elif reserve is not None and reserve < MARGIN and not warning:
            status = "marginal"
        more.setdefault("impossible", self.impossible and status == "fail")
        return Check(
            self,
            status,
            value=value,
            limit=limit,
            utilisation=utilisation,
            torque_reserve=reserve,
            warning=bool(warning),
            **more,
        )

    def gap(self, width: float, *, size: float) -> "Check":
        """Check of a gap, m, that has to exist; rounding may take `AS_TYPED` of `size`, m."""
        there = width > AS_TYPED * size
        found = self.judged(width if there else min(width, 0.0), 0.0)
        return found if there else found._replace(status="fail", impossible=True)

    def wall(
        self, width: float, *, size: float, least: float | None = None, guide: float | None = None
    ) -> "Check":
        """Check of a wall, m, against a requested least wall; a usual one (`guide`) only warns."""
        found = self.gap(width, size=size)
        if found.status == "fail":
            return found._replace(limit=least or guide or 0.0)
        if least is not None:
            return self.judged(width, least)
        if guide is not None:
            return self.judged(width, guide, warning="thin_wall", limit_source="guide")
        return found._replace(status="not_checked", reason="no_sourced_limit")


class Element:
    """Machine element: common fields of the records of its checks.

    For one of several similar elements, `codes` maps sorts of check to codes (``sort=code``),
    `sorts` has fields common to a sort, and `words` fills placeholders in title and reason.
    """

    def __init__(
        self,
        group: str,
        part: str = "",
        needs: str = "",
        *,
        codes: Paths = (),
        sorts: Mapping[str, Mapping[str, Any]] | None = None,
        words: Mapping[str, str] | None = None,
        **common: Any,
    ) -> None:
        self.common = {"group": group, "part": part, "needs": needs, **common}
        self.codes = dict(each.split("=") for each in paths(codes))
        self.sorts, self.words = sorts or {}, words or {}

    def __call__(self, code: str, **own: Any) -> Callable[[Judge], Kind]:
        """Decorator that makes a function the record of a check; `own` overrides common fields."""
        said = self.common | own
        said |= {name: paths(said.get(name, ())) for name in ("needs", "inputs", "fixes")}
        return lambda judge: Kind(code=code, judge=judge, **said)

    def check(self, sort: str, **own: Any) -> Callable[[Judge], Kind]:
        """Decorator as `__call__`, for a check of a sort."""
        of = {**self.sorts.get(sort, {}), **own}
        words = {name: of[name].format(**self.words) for name in ("title", "why")}
        return self(self.codes[sort], **of | words)


class Check(NamedTuple):
    """Result of one check of a design."""

    kind: Kind  # record
    status: Status
    value: float | None = None  # compared value, SI
    limit: float | None = None  # limit with the required safety, SI
    utilisation: float | None = None  # 1 at the limit; None for a limit of 0 or a value below 0
    # Factor on the torque at which the value is at its limit; None if independent or not known.
    # With `solved` it assumes proportional forces, orders checks and appears in no answer.
    torque_reserve: float | None = None
    solved: bool = False  # True if forces are not proportional to the torque
    impossible: bool = False  # True if the mechanism cannot exist or move
    warning: bool = False  # True if the check is marginal at worst
    reason: str = ""  # reason that the numbers do not show, a key of `core.codes.CODES`
    params: Mapping[str, Any] = {}  # values in the reason's text, SI; mm for warnings
    refusal: InvalidInput | None = None  # reason as the refusal of an input, if it is one
    limit_source: str = ""  # source of a material's limit
    criterion: str = ""  # criterion of that limit
    verified: str = ""  # verification of that limit
    life_factor: float | None = None  # included in the limit, by the loads over the life
    # Place of the value: satellite, pin, crank_angle (rad); section `root` or `ring` of tied pins.
    at: Mapping[str, Any] = {}
    missing: tuple[str, ...] = ()  # core names of inputs that are not given

    @property
    def code(self) -> str:
        """Name of the check in answers."""
        return self.kind.code

    @property
    def because(self) -> Literal["", "guide", "margin"]:
        """Cause of a marginal check: a guide value that is not kept, or that it does not hold at
        `MARGIN` times the torque; empty where its reason is the cause, and for other checks.
        """
        if self.status != "marginal":
            return ""
        if self.warning:
            return "guide"
        by_torque = self.by_torque or self.kind.loaded
        return "margin" if by_torque and self.reason not in DOUBTS else ""

    @property
    def margin(self) -> float:
        """Distance of the value from its limit, SI, below 0 beyond it; `NotKnown` as `compared`."""
        value, limit = self.compared
        return limit - value if self.kind.keep == "below" else value - limit

    @property
    def compared(self) -> tuple[float, float]:
        """Value and limit, SI; `NotKnown` unless both are known."""
        lacks = (self.reason, *self.missing)
        return required(self.value, *lacks), required(self.limit, *lacks)

    @property
    def by_torque(self) -> bool:
        """True if the factor on the torque at the limit is known."""
        return self.torque_reserve is not None

    @property
    def reserve(self) -> float:
        """Factor on the torque at the limit; if not known 0 for a failed check, else infinite."""
        if self.torque_reserve is None:
            return 0.0 if self.status == "fail" else math.inf
        return self.torque_reserve

    @property
    def only_needed(self) -> bool:
        """True if the check holds, but is necessary and not sufficient."""
        return self.status == "not_checked" and self.reason == "necessary_only"

    @property
    def necessary(self) -> "Check":
        """Check as a necessary condition, which may fail but never passes."""
        if self.status in ("fail", "not_checked"):
            return self
        return self._replace(status="not_checked", reason="necessary_only")

    @property
    def opens(self) -> bool:
        """True if the part cannot be judged without this check."""
        return self.status == "not_checked" and self.needed

    @property
    def needed(self) -> bool:
        """True if the part is open without this check, whose limit some source states."""
        return self.kind.needed and self.reason != "no_sourced_limit"


def asked_of(design: Any, *names: str) -> dict[str, float]:
    """Requirements that a design sets, out of some names."""
    values = {name: getattr(design.requirements, name) for name in names}
    return {name: value for name, value in values.items() if value is not None}


class Unjudged(NotKnown):
    """Reason why a known value has no limit, with attributes of its check."""

    def __init__(self, code: str, *missing: str, **known: Any) -> None:
        super().__init__(code, *missing)
        self.known = known


def judged_by(given: Given | None, code: str, *missing: str, **known: Any) -> Given:
    """Limit, or another input needed for judging, if it is given; otherwise raise `Unjudged`.
    `code` is the reason, a key of `core.codes.CODES`, `missing` the core names of the inputs that
    are not given, `known` attributes of the check that are known, such as its value, or a status of
    `not_asked`.
    """
    if given is None:
        raise Unjudged(code, *missing, **known)
    return given


def over_range(
    *, least: Callable[[], Check], most: Callable[[], Check], values: Mapping[str, Spread]
) -> Check:
    """Necessary condition of a material, judged over the range of values that sources state.

    The check fails only if it fails by the least value (`NotKnown` if there is none) and by the
    largest, or by a bound that no such material exceeds. `values` are the ranges of values that are
    not given, by path.
    """
    differ = tuple(path for path, each in values.items() if each.low < each.high)
    try:
        found = least()
    except NotKnown as why:
        sure, missing = most(), tuple(dict.fromkeys((*why.missing, *differ)))
        if sure.status == "fail":
            return sure._replace(torque_reserve=None, reason="above_any", missing=missing)
        raise Unjudged(why.code, *missing, value=sure.value, at=sure.at) from why
    if found.status == "fail" and differ and most().status != "fail":
        return found._replace(status="marginal", reason="range_decides", missing=differ)
    return found.necessary


class Measure(NamedTuple):
    """Value that is compared with a limit that a user may request."""

    value: float  # SI
    error: float = 4 * ROUNDING  # relative error of value and model
    at: Mapping[str, float] = {}  # place of the value
    # Factor on the torque as a function of the growth of the value; None if it does not grow.
    reserve: Callable[[float], float] | None = None
    solved: bool = False  # True if the value is not proportional to the torque
    used: Callable[[float], float] | None = None  # utilisation of a limit, if not the ratio
    reason: str | None = None  # code of a remark


@dataclass(frozen=True, slots=True, kw_only=True)
class PartVerdict:
    """Verdict of a part of the reducer."""

    code: str  # key of `PARTS`
    # `fail` if a check fails, else `open` if a needed value is not known or nothing is judged, else
    # `marginal` or `pass`; `left_out` of the scope, or `not_asked` without a requested limit.
    status: PartStatus
    governing: str | None = None  # code of the deciding check
    reason: str = ""  # reason why it is open, a key of `core.codes.CODES`
    params: Mapping[str, Any] = field(default_factory=dict)  # values in the reason's text, SI
    refusal: InvalidInput | None = None  # reason as the refusal of an input, if it is one
    missing: tuple[str, ...] = ()  # core names of inputs that are not given

    @property
    def judged(self) -> bool:
        """True if the part passes, is marginal or fails."""
        return self.status in ("pass", "marginal", "fail")


def whole(parts: Iterable[PartVerdict]) -> Outcome:
    """Verdict of several parts together.

    >>> whole([PartVerdict(code="pins", status="pass"), PartVerdict(code="body", status="open")])
    'incomplete'
    """
    statuses = {part.status for part in parts}
    if "fail" in statuses:
        return "fail"
    if "open" in statuses or not statuses & {"marginal", "pass"}:
        return "incomplete"
    return "marginal" if "marginal" in statuses else "pass"


@dataclass(frozen=True, slots=True)
class Verdict:
    """Verdict of all checks of a design."""

    # Parts decide: `fail` if one fails, `incomplete` if one is open or none judged, and so on.
    # Without parts `incomplete` means a check not made, or none that depends on the load.
    verdict: Outcome
    governing: str | None  # code of the check that limits most, see `governs`
    # Factor on the torque at the first failure; None if the largest torque is not known. For
    # plastics, which may not last, the factor at which they yield at once.
    torque_reserve: float | None
    # True if the torque alone decides: less torque cures every failure by a known factor. With
    # parts, at least one is judged; without parts, every check is made.
    largest_torque_known: bool
    largest_torque_of: tuple[str, ...]  # judged parts it holds for; an upper bound for the whole
    counts: dict[str, int]  # number of checks by status
    parts: tuple[PartVerdict, ...]  # empty for other calculations than the reducer
    not_considered: tuple[str, ...]  # keys of `NOT_CONSIDERED`
    checks: tuple[Check, ...]  # in order of `rank`
    uncounted: tuple[str, ...] = ()  # codes of checks that only warn, and do at the largest torque

    @property
    def impossible(self) -> bool:
        """True if the design cannot exist or move."""
        return cannot_be(self.checks)

    @property
    def unforced(self) -> bool:
        """True if no force is known, as the design cannot exist or move."""
        return any(each.reason == "cannot_be" for each in self.checks)

    def largest_torque(self, torque: float) -> float | None:
        """Torque at the first failure of a check, N*m, if it is known; `torque` is the design's."""
        if self.torque_reserve is None or not self.largest_torque_known:
            return None
        return abs(torque) * self.torque_reserve

    def __getitem__(self, code: str) -> Check:
        """Check with a code."""
        return next(each for each in self.checks if each.code == code)


def cannot_be(checks: Iterable[Check]) -> bool:
    """True if a check says that the design cannot exist or move."""
    return any(each.impossible and each.status == "fail" for each in checks)


def rank(check: Check) -> tuple[float, ...]:
    """Sort key of checks: impossible, failing, not made, marginal, passing, then not judged.

    Within a status the torque reserve decides, as utilisations of different powers of the torque
    cannot be compared; a failure independent of the torque comes first.
    """
    order = {"fail": 1, "not_checked": 2, "marginal": 3, "pass": 4, "not_asked": 5}
    place = 0 if check.impossible and check.status == "fail" else order.get(check.status, 6)
    if check.status == "not_checked" and not check.opens:
        place = order["not_asked"]
    used = -check.utilisation if check.utilisation is not None else 0.0
    return place, check.reserve, used


def governs(checks: Iterable[Check]) -> str | None:
    """Code of the check that limits most: the worst failing one, or the one nearest its limit. A
    condition that is only necessary counts by what it uses of its limit.
    """

    def held(check: Check) -> bool:
        return check.only_needed and check.utilisation is not None

    def place(check: Check) -> tuple[float, ...]:
        return rank(check._replace(status="pass") if held(check) else check)

    known = [each for each in checks if held(each) or each.status in ("fail", "marginal", "pass")]
    return min(known, key=place).code if known else None


def verdict(
    checks: Iterable[Check],
    not_considered: tuple[str, ...] = (),
    parts: tuple[PartVerdict, ...] = (),
    *,
    unknown: bool = False,
    once: bool = False,
) -> Verdict:
    """Verdict of checks. Verdicts of the parts of a reducer determine it; other gears have none.
    `unknown` says that a torque below all known limits may be too much, `once` that known limits
    hold for loads that act once only, as for plastics.

    >>> from core.checks.records import CHECKS
    >>> pin_fatigue, pin_static = CHECKS["pin_fatigue"], CHECKS["pin_static"]
    >>> passing = pin_static.judged(50.0, 100.0, reserve=2.0)
    >>> found = verdict([Check(pin_fatigue, "not_checked"), passing])
    >>> found.verdict, found.governing, found.torque_reserve
    ('incomplete', 'pin_static', None)
    >>> verdict([passing]).torque_reserve
    2.0
    """
    ranked = tuple(sorted(checks, key=rank))
    statuses = [each.status for each in ranked]
    counts: dict[str, int] = {status: statuses.count(status) for status in STATUSES}
    decided = [each for each in ranked if each.status in ("fail", "marginal", "pass")]
    held = [each for each in ranked if each.only_needed]
    counted = [each for each in (*decided, *held) if each.by_torque and not each.warning]
    bears = bool(counted) and not unknown and not cannot_be(ranked)
    outcome: Outcome = "pass"
    if parts:
        outcome = whole(parts)
    elif counts["fail"]:
        outcome = "fail"
    elif counts["not_checked"] or not counted:  # no check depends on the load
        outcome = "incomplete"
    elif counts["marginal"]:
        outcome = "marginal"
    stuck = any(each.status == "fail" and not each.by_torque for each in decided)
    having = {each.kind.part for each in counted}
    of = tuple(part.code for part in parts if part.judged and part.code in having)
    enough = bool(of) if parts else not counts["not_checked"]
    known = bears and enough and not stuck and not once
    bounds = any(each.only_needed or each.reason == "range_decides" for each in counted)
    bounded = bears and (once or (bounds and not of))
    least = min(each.reserve for each in counted) if known or bounded else None
    return Verdict(
        verdict=outcome,
        governing=governs(ranked),
        torque_reserve=least,
        largest_torque_known=known,
        largest_torque_of=of if known else (),
        counts=counts,
        parts=parts,
        not_considered=not_considered,
        checks=ranked,
    )
