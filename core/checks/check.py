"""A check and its record, a value against its limit, the verdict of parts and of all checks."""

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


Given = TypeVar("Given")

Judge = Callable[..., "Check | Measure"]
"""Makes the check of a design; of what somebody may ask, a measure will do."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Kind:
    """Record of a check, at the function that makes it."""

    code: str  # its name in answers
    title: str  # its name in English
    group: str  # what it is about, a key of `GROUPS`
    part: str = ""  # of the reducer that it judges, a key of `PARTS`; of other calculations none
    needed: bool = True  # whether its part is open where it cannot be made
    formula: str  # what has to hold
    why: str  # what is wrong where it does not hold, in English
    inputs: tuple[str, ...]  # paths of what it depends on
    fixes: tuple[str, ...] = ()  # and of what a fix may change
    unit: str = ""  # of value and limit, as names end in it; empty for plain numbers
    source: str = "geometry"  # where the formula comes from, a key of `CHECK_SOURCES`
    keep: Literal["below", "above"] = "below"  # on which side of the limit the value has to stay
    needs: tuple[str, ...] = ()  # what has to be there of a design: it is made of no other one
    # What has to be given besides, by its path, with the code of why nothing is known without it.
    requires: Mapping[str, str] = field(default_factory=dict)
    # Why it is no check of a design, a code; empty of others.
    not_of: Callable[..., str] = field(default_factory=lambda: lambda *_: "")
    demands: tuple[str, ...] = ()  # paths: where none is given nobody asks what is not known
    asks: str = ""  # requirement that is its limit, where somebody may ask it
    impossible: bool = False  # whether what fails by it cannot exist or move
    only_asked: bool = False  # whether its value is not looked for where nobody does
    asked_alone: bool = False  # whether it needs nothing else where that is asked
    # Attributes of the check that are known although its value is not, as its limit.
    known: Callable[..., dict[str, Any]] = field(default_factory=lambda: lambda *_: {})
    judge: "Judge"  # the check of a design, told which it is

    @property
    def loaded(self) -> bool:
        """True where the torque of the output moves it."""
        return "load.output_torque" in self.inputs

    def sections(self, given: Set[str]) -> tuple[str, ...]:
        """Sections that a design has to have, where it has these, or asks them."""
        return (self.asks,) if self.asked_alone and self.asks in given else self.needs

    def of(self, *design: Any, unforced: bool = False) -> "Check":
        """The check of a design, which has the requirements, and of what follows from it, as its
        function takes them; it says why where it could not be made. Unforced, no force is known, as
        the parts that hand it on cannot exist or move.
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
        """Call its function, where nothing here keeps it from looking."""
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
        """Judge what was found against a limit that somebody may ask."""
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
        """The check where it could not be made, by why what it looks at is not known."""
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
        """The check by a value and its limit, with other attributes that it has.

        Parameters
        ----------
        value, limit : float
            What is compared.
        reserve : float, optional
            Factor on the torque at which it is at its limit.
        error : float
            Relative error of the value, of number and model: where the limit lies within, the check
            is marginal. Without a finite error it is not checked, nor where the value may be
            anything down to 0, from an error of 1 on, with a smaller limit.
        warning : str
            Reason where it does not hold, if that is a warning only.
        **more
            Other attributes of the check.

        Examples
        --------
        >>> from core.checks.records import CHECKS
        >>> CHECKS["pin_static"].judged(90.0, 100.0, reserve=1.2).status
        'pass'
        >>> CHECKS["pin_static"].judged(99.0, 100.0, reserve=1.02).status
        'marginal'
        >>> CHECKS["wall_holes"].judged(1.0, 2.0).utilisation
        2.0
        """
        part, whole = (value, limit) if self.keep == "below" else (limit, value)
        used = whole > 0 and part >= 0 and limit > 0  # of a limit of 0 there is nothing to use
        utilisation = part / whole if used else None
        doubtful = abs(value - limit) <= error * abs(value)
        if not error < (1.0 if value > limit else math.inf):
            more |= {"reason": "value_unknown"}
            return Check(self, "not_checked", value=value, limit=limit, **more)
        status: Status = "pass"
        if doubtful and reserve is not None:  # without one: sizes that are asked for are there
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
        """A gap of a width, m, that has to be there, else the part cannot exist; between parts of a
        size, m, of which rounding may take `AS_TYPED`.
        """
        there = width > AS_TYPED * size
        found = self.judged(width if there else min(width, 0.0), 0.0)
        return found if there else found._replace(status="fail", impossible=True)

    def wall(
        self, width: float, *, size: float, least: float | None = None, guide: float | None = None
    ) -> "Check":
        """A wall, as `gap`, that is at least as wide as is asked, or else as is usual, below which
        it is marginal; m.
        """
        found = self.gap(width, size=size)
        if found.status == "fail":
            return found._replace(limit=least or guide or 0.0)
        if least is not None:
            return self.judged(width, least)
        if guide is not None:
            return self.judged(width, guide, warning="thin_wall", limit_source="guide")
        return found._replace(status="not_checked", reason="no_sourced_limit")


class Element:
    """A machine element: what the records of its checks have in common. For one of several, as
    rolling bearings, codes are those of its checks by their sort (``sort=code``), sorts what all
    records of a sort say, and words what title and reason there call it.
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
        """Decorator of a function that is a check of it, which becomes its record, by its code and
        what its own record says besides, or instead; sections and paths as words.
        """
        said = self.common | own
        said |= {name: paths(said.get(name, ())) for name in ("needs", "inputs", "fixes")}
        return lambda judge: Kind(code=code, judge=judge, **said)

    def check(self, sort: str, **own: Any) -> Callable[[Judge], Kind]:
        """As a call, of its check of a sort."""
        of = {**self.sorts.get(sort, {}), **own}
        words = {name: of[name].format(**self.words) for name in ("title", "why")}
        return self(self.codes[sort], **of | words)


class Check(NamedTuple):
    """One check of a design.

    Attributes
    ----------
    utilisation : float or None
        How much of the limit is used, 1 at the limit; None where the limit is 0 or the value not
        positive.
    torque_reserve : float or None
        Factor on the torque at which the value is at its limit; None where it does not depend on
        it, or is not known. Where `solved` it is what it would be if forces grew in proportion:
        that orders checks, and no answer states it.
    refusal : InvalidInput or None
        The reason as the refusal of who asks for what the check looks at, where it is one.
    life_factor : float or None
        Of the limit, which is in it, by the loads over the life; None where none is known.
    at : mapping
        Where the value is reached: satellite, pin, crank_angle (rad); of pins that a tie ring joins
        their section, `root` or `ring`.
    """

    kind: Kind  # which
    status: Status  # how it went
    value: float | None = None  # that is compared, in SI units
    limit: float | None = None  # with the required safety in it
    utilisation: float | None = None
    torque_reserve: float | None = None
    solved: bool = False  # whether forces are solved again under another torque, shared otherwise
    impossible: bool = False  # whether the mechanism cannot exist or move so
    warning: bool = False  # whether the check can be marginal at worst
    reason: str = ""  # why, where the numbers do not say it: a key of `core.codes.CODES`
    params: Mapping[str, Any] = {}  # what its words name, SI; of a warning as its notice has it
    refusal: InvalidInput | None = None
    limit_source: str = ""  # of the limit of a material
    criterion: str = ""  # of that limit
    verified: str = ""  # how that was seen
    life_factor: float | None = None
    at: Mapping[str, Any] = {}
    missing: tuple[str, ...] = ()  # core names of inputs that would have to be given

    @property
    def code(self) -> str:
        """Its name in answers."""
        return self.kind.code

    @property
    def margin(self) -> float:
        """Distance to the limit, below 0 beyond it, in SI units; `NotKnown` as `compared`."""
        value, limit = self.compared
        return limit - value if self.kind.keep == "below" else value - limit

    @property
    def compared(self) -> tuple[float, float]:
        """Value and limit, in SI units; `NotKnown` where they are not both known."""
        lacks = (self.reason, *self.missing)
        return required(self.value, *lacks), required(self.limit, *lacks)

    @property
    def by_torque(self) -> bool:
        """True where a factor on the torque is known at which it is at its limit."""
        return self.torque_reserve is not None

    @property
    def reserve(self) -> float:
        """Factor on the torque at which it fails: without one that is known 0 of what fails, which
        no less torque is known to cure, and infinite of the others.
        """
        if self.torque_reserve is None:
            return 0.0 if self.status == "fail" else math.inf
        return self.torque_reserve

    @property
    def only_needed(self) -> bool:
        """True where it holds, which is necessary and not enough to pass."""
        return self.status == "not_checked" and self.reason == "necessary_only"

    @property
    def necessary(self) -> "Check":
        """The check as one that is necessary and not enough: it may fail, and never passes."""
        if self.status in ("fail", "not_checked"):
            return self
        return self._replace(status="not_checked", reason="necessary_only")

    @property
    def opens(self) -> bool:
        """True where its part cannot be judged without it."""
        return self.status == "not_checked" and self.needed

    @property
    def needed(self) -> bool:
        """True where its part is open without it: a limit that no source has nobody could give."""
        return self.kind.needed and self.reason != "no_sourced_limit"


def asked_of(design: Any, *names: str) -> dict[str, float]:
    """Requirements that are asked of a design, of some, by their names.

    Parameters
    ----------
    design : object
        The design.
    *names : str
        Their names.
    """
    values = {name: getattr(design.requirements, name) for name in names}
    return {name: value for name, value in values.items() if value is not None}


class Unjudged(NotKnown):
    """A value that is known, and nothing to hold it against; with attributes of its check."""

    def __init__(self, code: str, *missing: str, **known: Any) -> None:
        super().__init__(code, *missing)
        self.known = known


def judged_by(given: Given | None, code: str, *missing: str, **known: Any) -> Given:
    """Limit, or else by which a value is judged, which has to be given.

    Parameters
    ----------
    given : object or None
        What it is; None where it is not given.
    code : str
        Why nothing is judged without it, a key of `core.codes.CODES`.
    *missing : str
        Core names of inputs that would have to be given.
    **known
        Attributes of the check that are known all the same, as its value; its status, where nobody
        asks without.

    Returns
    -------
    object

    Raises
    ------
    Unjudged
        If it is not given.
    """
    if given is None:
        raise Unjudged(code, *missing, **known)
    return given


def over_range(
    *, least: Callable[[], Check], most: Callable[[], Check], values: Mapping[str, Spread]
) -> Check:
    """A necessary condition by a material, over all that sources have of it.

    Parameters
    ----------
    least : callable
        The check by the least that they have; `NotKnown` where they have nothing.
    most : callable
        The same by the largest, or by what no such material exceeds.
    values : mapping
        Values that are not given, as sources have them, by their paths.

    Returns
    -------
    Check
        It fails where it does by all. A bound that it fails by lends it no reserve.
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
    """Value that is compared with a limit that somebody may ask."""

    value: float  # in SI units
    error: float = 4 * ROUNDING  # relative, of number and model
    at: Mapping[str, float] = {}  # where it is reached
    # Factor on the torque under which the value is so many times as large, where it grows with it.
    reserve: Callable[[float], float] | None = None
    solved: bool = False  # whether it does not grow in proportion, as forces are solved
    used: Callable[[float], float] | None = None  # part of a limit, where that is not their ratio
    reason: str | None = None  # what else it is of than the check says


@dataclass(frozen=True, slots=True, kw_only=True)
class PartVerdict:
    """Verdict of a part.

    Attributes
    ----------
    status : PartStatus
        `fail` where one of its checks fails; else `open` where what it needs is not known or
        nothing of it is judged; else `marginal` or `pass`. `left_out` where the design's scope
        leaves it out, `not_asked` where nobody asks for it.
    """

    code: str  # which part, a key of `PARTS`
    status: PartStatus
    governing: str | None = None  # code of the check that decides of it
    reason: str = ""  # why it is open, a key of `core.codes.CODES`
    params: Mapping[str, Any] = field(default_factory=dict)  # what its words name, in SI units
    refusal: InvalidInput | None = None  # the reason as a refusal, where it is one
    missing: tuple[str, ...] = ()  # core names of inputs that would have to be given

    @property
    def judged(self) -> bool:
        """True where it passes or fails."""
        return self.status in ("pass", "marginal", "fail")


def whole(parts: Iterable[PartVerdict]) -> Outcome:
    """Verdict of parts together.

    Examples
    --------
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
    """Verdict of all checks of a design.

    Attributes
    ----------
    verdict : Outcome
        Of a design with parts, of these: `fail` where one fails, else `incomplete` where one is
        open or none is judged, else `marginal` where one is, else `pass`. For other calculations:
        `incomplete` where a check could not be made, or none is of what the load could break.
    governing : str or None
        Code of the check that decides of those that are made: the worst failing one, else the one
        next to its limit.
    torque_reserve : float or None
        Factor on the torque at which the first check fails; None where no largest torque is known,
        but of plastics, which may not last: of these that at which they yield at once counts.
    largest_torque_known : bool
        Whether the torque alone decides: nothing fails that less torque does not cure, by a factor
        that is known, and of parts one is judged; without parts nothing is unknown.
    largest_torque_of : tuple of str
        Parts that are judged and that it is of, where it is known: of the whole it is an upper
        bound.
    counts : dict of str to int
        How many checks have each status.
    parts : tuple of PartVerdict
        What each part of the reducer comes to; none of other calculations.
    not_considered : tuple of str
        What is not looked at, keys of `NOT_CONSIDERED`.
    checks : tuple of Check
        All of them, the one that decides first: of an incomplete verdict one that is not checked.
    """

    verdict: Outcome
    governing: str | None
    torque_reserve: float | None
    largest_torque_known: bool
    largest_torque_of: tuple[str, ...]
    counts: dict[str, int]
    parts: tuple[PartVerdict, ...]
    not_considered: tuple[str, ...]
    checks: tuple[Check, ...]

    @property
    def impossible(self) -> bool:
        """True where such a design cannot exist or move."""
        return cannot_be(self.checks)

    @property
    def unforced(self) -> bool:
        """True where no force is known of it, as it cannot exist or move."""
        return any(each.reason == "cannot_be" for each in self.checks)

    def __getitem__(self, code: str) -> Check:
        """The check of a code."""
        return next(each for each in self.checks if each.code == code)


def cannot_be(checks: Iterable[Check]) -> bool:
    """Tell whether a check says that the design cannot exist or move."""
    return any(each.impossible and each.status == "fail" for each in checks)


def rank(check: Check) -> tuple[float, ...]:
    """Key by which checks are sorted, as they decide the verdict: impossible, failing, not made,
    marginal, passing, then what is not judged.

    Utilisations of different powers of the torque cannot be compared; its reserve can. A check that
    fails whatever the torque comes before.
    """
    order = {"fail": 1, "not_checked": 2, "marginal": 3, "pass": 4, "not_asked": 5}
    place = 0 if check.impossible and check.status == "fail" else order.get(check.status, 6)
    if check.status == "not_checked" and not check.opens:
        place = order["not_asked"]
    used = -check.utilisation if check.utilisation is not None else 0.0
    return place, check.reserve, used


def verdict(
    checks: Iterable[Check],
    not_considered: tuple[str, ...] = (),
    parts: tuple[PartVerdict, ...] = (),
    *,
    unknown: bool = False,
    once: bool = False,
) -> Verdict:
    """The verdict of checks.

    Parameters
    ----------
    checks : iterable of Check
        The checks.
    not_considered : tuple of str
        What is not looked at, keys of `NOT_CONSIDERED`.
    parts : tuple of PartVerdict
        What the parts of a reducer come to, of which the verdict is made; none of what has none.
    unknown : bool
        Whether less torque than all that is known may be too much.
    once : bool
        Whether what is known is of loads that act once only, as of plastics.

    Examples
    --------
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
    held = (each for each in ranked if each.only_needed)
    counted = [each for each in (*decided, *held) if each.by_torque and not each.warning]
    bears = bool(counted) and not unknown and not cannot_be(ranked)
    outcome: Outcome = "pass"
    if parts:
        outcome = whole(parts)
    elif counts["fail"]:
        outcome = "fail"
    elif counts["not_checked"] or not counted:  # room alone: nothing that the load could break
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
        governing=decided[0].code if decided else None,
        torque_reserve=least,
        largest_torque_known=known,
        largest_torque_of=of if known else (),
        counts=counts,
        parts=parts,
        not_considered=not_considered,
        checks=ranked,
    )
