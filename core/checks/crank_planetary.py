"""All checks of a crank-planetary reducer, its parts, and its verdict; and what it says of more
torque: whether it holds a tenth more, and the largest it holds.

Forces that are solved do not grow with the torque: clearance and deviations share a small one among
fewer pairs. So the checks are made again under other torques; what they say of one from the forces
at another is an estimate.
"""

import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from functools import cache

from core.checks.balance import BALANCE
from core.checks.bearings import BEARINGS
from core.checks.body import BODY
from core.checks.check import (
    MARGIN,
    Check,
    PartVerdict,
    Verdict,
    asked_of,
    cannot_be,
    make_check,
    rank,
    verdict,
)
from core.checks.contact import CONTACT, CRANKS, FIT, LAYOUT, PLAY, life_considered
from core.checks.crank import CRANK
from core.checks.friction import FRICTION
from core.checks.involute_mesh import INVOLUTE_MESH
from core.checks.pin_rollers import PIN_ROLLERS
from core.checks.pins import PINS
from core.checks.plastics import PLASTICS
from core.checks.ring_load import RING_LOAD
from core.checks.ring_pins import RING_PINS
from core.design.document import Design, changed
from core.design.results import Results
from core.errors import NotKnown
from core.output.elasticity import RIGID_SUPPORT
from core.precision import JUDGED

CRANK_CHECKS = {
    kind.code: kind
    for kind in (
        *CRANKS,
        *FIT,
        *CONTACT,
        *PLASTICS,
        *PLAY,
        *LAYOUT,
        *BODY,
        *PINS,
        *FRICTION,
        *CRANK,
        *INVOLUTE_MESH,
        *RING_PINS,
        *RING_LOAD,
        *BEARINGS,
        *PIN_ROLLERS,
        *BALANCE,
    )
}
"""By code."""

_NEEDS = tuple(dict.fromkeys(need for kind in CRANK_CHECKS.values() for need in kind.needs))
_ASKED_ALONE = tuple(kind.asks for kind in CRANK_CHECKS.values() if kind.asked_alone)


@dataclass(frozen=True, slots=True, kw_only=True)
class Part:
    """A part of a reducer."""

    code: str  # its name in requests and answers
    title: str  # its name in English
    sections: tuple[str, ...]  # of a design that its checks need
    by_forces: bool = True  # whether these read the pins' forces
    demands: tuple[str, ...] = ()  # without its section or one of these nobody asks for it


PARTS = {
    part.code: part
    for part in (
        Part(code="contact", title="pins in holes", sections=("load", "contact")),
        Part(code="pins", title="pins", sections=("load", "contact", "pin")),
        Part(
            code="teeth",
            title="teeth of satellite and ring",
            sections=("load", "contact", "gear"),
            by_forces=False,
        ),
        Part(
            code="satellite_bearing",
            title="bearings of the satellites",
            sections=("load", "contact", "gear", "bearing"),
        ),
        Part(
            code="crank_bearings",
            title="bearings and balance of the crankshaft",
            sections=("load", "contact", "gear", "crankshaft"),
        ),
        Part(
            code="body",
            title="body of the satellite",
            sections=("load", "contact", "satellite_body"),
            by_forces=False,
        ),
        Part(
            code="losses",
            title="friction, wear and efficiency",
            sections=("load", "contact", "friction"),
            demands=("min_efficiency", "max_sliding_speed", "max_pv", "max_wear"),
        ),
    )
}
"""By code, in the order in which they are shown."""

MESHES = ("contact", "teeth")
"""Parts without which there are no forces."""

UNCOVERED = ("crankshaft", "output_bearing", "housing", "lubrication", "dynamics")
"""What no part covers."""


def crank_check(code: str, results: Results) -> Check:
    """One check of a crank-planetary reducer; it says why where it could not be made. What fails by
    a value that is assumed, and holds at the mild end of that, is marginal.

    Parameters
    ----------
    code : str
        Which.
    results : Results
        Results of a design.

    Returns
    -------
    Check
    """
    kind = CRANK_CHECKS[code]
    check = make_check(kind, results.design, results)
    assumed = [path for path in results.design.mild if path in kind.inputs]
    if check.status != "fail" or not assumed:
        return check
    ends = [results.milder[path] for path in assumed]
    milder = (make_check(kind, made.design, made) for made in ends)
    if all(each.status == "fail" for each in milder):
        return check
    return check._replace(status="marginal", impossible=False, reason="default_decides")


def crank_codes(design: Design) -> tuple[str, ...]:
    """The checks that the sections of a design allow.

    Parameters
    ----------
    design : Design
        The design.

    Returns
    -------
    tuple of str
        Their codes, first of those that need less.
    """
    there = [need for need in _NEEDS if getattr(design, need)]
    asked = asked_of(design, *_ASKED_ALONE)
    return _codes(frozenset((*there, *asked)), design.scope)


@cache
def _codes(given: frozenset[str], scope: tuple[str, ...]) -> tuple[str, ...]:
    judged = {code: kind for code, kind in CRANK_CHECKS.items() if kind.part in scope}
    needed = {code: kind.sections(given) for code, kind in judged.items()}
    made = [code for code, needs in needed.items() if given.issuperset(needs)]
    return tuple(sorted(made, key=lambda code: len(needed[code])))


def crank_checks(results: Results) -> Verdict:
    """All checks of a crank-planetary reducer, as far as they are in its scope.

    Parameters
    ----------
    results : Results
        Results of a design.

    Returns
    -------
    Verdict
        Nothing that hangs on forces is checked where pins in holes or teeth cannot be.
    """
    design, codes = results.design, crank_codes(results.design)
    checks = [crank_check(code, results) for code in codes if not CRANK_CHECKS[code].loaded]
    meshing = (each for each in checks if each.kind.part in MESHES and each.code != "pins_apart")
    unforced = cannot_be(meshing)
    checks += (
        make_check(CRANK_CHECKS[code], design, results, unforced=True)
        if unforced
        else crank_check(code, results)
        for code in codes
        if CRANK_CHECKS[code].loaded
    )
    return of_parts(design=design, checks=checks)


def of_parts(*, design: Design, checks: Iterable[Check]) -> Verdict:
    """The verdict of a reducer's checks, of which its parts' are made.

    Parameters
    ----------
    design : Design
        The design.
    checks : iterable of Check
        Its checks.

    Returns
    -------
    Verdict
    """
    made = sorted(checks, key=rank)
    parts = tuple(_part(design, part, made) for part in PARTS.values())
    judged = {part.code for part in parts if part.judged}
    pressed = "contact" in design.scope and bool(design.load) and design.touching
    left_out = {
        **{code: code not in judged for code in PARTS},
        "contact_life_pin": pressed and not life_considered(design=design, body="pin"),
        "contact_life_hole": pressed and not life_considered(design=design, body="hole"),
        "ligament_strength": "body" in judged,
        **dict.fromkeys(UNCOVERED, True),
    }
    return verdict(
        made,
        tuple(name for name, so in left_out.items() if so),
        parts,
        unknown=design.clearance_unknown or any(map(_unknown, made)),
        once="contact" in design.scope and bool(design.load and design.plastics),
    )


NOTHING_KNOWN = (
    "limit_unknown",
    "static_limit_unknown",
    "yield_unknown",
    "direction_unknown",
    "friction_unknown",
)
"""Reasons for which a check knows nothing of what a body bears, which may be less than all else."""


def _unknown(check: Check) -> bool:
    """Whether a check knows nothing of what a body bears, or only a bound above it."""
    bounded = check.status == "fail" and check.reason == "above_any"
    return bounded or (check.opens and check.reason in NOTHING_KNOWN)


def _part(design: Design, part: Part, made: list[Check]) -> PartVerdict:
    """What a part comes to, by the checks that are made, the one that decides first."""
    if part.code not in design.scope:
        return PartVerdict(code=part.code, status="left_out")
    demanded = asked_of(design, *part.demands)
    if part.demands and not demanded and not getattr(design, part.sections[-1]):
        return PartVerdict(code=part.code, status="not_asked")
    own = [check for check in made if check.kind.part == part.code]
    decided = [check for check in own if check.status in ("fail", "marginal", "pass")]
    governing = decided[0].code if decided else None
    if decided and decided[0].status == "fail":
        return PartVerdict(code=part.code, status="fail", governing=governing)
    lacks = list(_lacks(design, part, own))
    if not decided:
        demands = (f"requirements.{name}" for name in part.demands)
        lacks.append(NotKnown("nothing_judged", *demands))
    if lacks:
        missing = dict.fromkeys(name for each in lacks for name in each.missing)
        return PartVerdict(
            code=part.code,
            status="open",
            governing=governing,
            reason=lacks[0].code,
            params=lacks[0].params,
            refusal=lacks[0].refusal,
            missing=tuple(missing),
        )
    marginal = any(check.status == "marginal" for check in decided)
    return PartVerdict(
        code=part.code, status="marginal" if marginal else "pass", governing=governing
    )


def _lacks(design: Design, part: Part, own: list[Check]) -> Iterator[NotKnown]:
    """What is not known of a part, for which it is open."""
    absent = tuple(
        name
        for name in part.sections
        if not (design.rubs if name == "friction" else getattr(design, name))
    )
    if absent:
        yield NotKnown("section_missing", *absent)
    gear = design.gear
    by_forces = part.by_forces
    if part.code == "teeth" and gear and gear.kind == "involute" and not gear.unknown_teeth:
        by_forces = design.mechanism.satellites > 1  # which share by their pins
    if by_forces and design.clearance_unknown:
        known = design.contact.eccentricity is not None
        missing = "contact.hole_clearance" if known else "contact.eccentricity"
        yield NotKnown("clearance_unknown", missing)
    if by_forces and design.rollers and design.rollers.radial_clearance is None:
        yield NotKnown("roller_clearance_unknown", "rollers.radial_clearance")
    if "gear" in part.sections and gear and gear.kind == "cycloid" and gear.modification is None:
        yield NotKnown("modification_unknown", "gear.modification")
    if part.code == "teeth":
        if gear and gear.kind == "involute" and gear.unknown_teeth:
            yield NotKnown("teeth_not_judged", *gear.unknown_teeth)
        elif gear and gear.kind not in ("cycloid", "involute"):
            yield NotKnown("teeth_not_judged")
    elif "gear" in part.sections and gear and gear.kind == "none":
        yield NotKnown("no_ring_force", "gear.kind")
    for check in own:
        if check.opens:
            yield NotKnown(check.reason, *check.missing, refusal=check.refusal, **check.params)


LOOKS = 8
"""Torques at most that are looked at, until the last one's reserve is as far off 1 as `JUDGED`."""

FURTHER, NEAR = 3, 0.1
"""Torques at most that are looked at for the reserves of checks that fail later, and how near the
logarithm of one is that needs no look."""

STEEPEST = 3.0
"""Most that a reserve changes with the torque, as a slope of logarithms, and 1 over the least."""

TOO_MUCH = ("not_stable", "not_balanced", "beyond_first_order", "beyond_hertz", "contact_wraps")
"""Reasons for which a check is not known under a torque, and may be under less."""

LESS = 0.1
"""Factor on a torque that is too much, at which is looked next."""

CURES_NOTHING = 0.01
"""Slope of them below which less torque cures nothing: of parts that press without any."""


def crank_verdict(results: Results, *, every: bool = False) -> Verdict:
    """All checks of a crank-planetary reducer, judged under the torque and under others.

    Parameters
    ----------
    results : Results
        Results of a design.
    every : bool
        Whether the reserve of every check is wanted, not only of the one that fails first: then the
        torques under which the others fail are looked at too, but of discs in series, which take
        long.

    Returns
    -------
    Verdict
        Where forces cannot be solved, or a contact wraps around its pin, a check fails that does so
        under less torque, at which it is known, but of discs in series on unlike pins, which take
        long. Where forces are solved a check is marginal that fails, or is not known, under
        `MARGIN` times the torque, and the least reserve is that of the torque at which the first
        one fails; the others are by secants of what was looked at. Where no such torque is found,
        as forces cannot be solved or jump with it, the reserves stay estimates, and the largest
        torque looked at under which all checks hold is given. None is stated beyond a torque under
        which forces cannot be solved: it is estimated between that and the last at which they can.
        Of a mechanism that cannot be none is looked for: no torque cures it.

    Notes
    -----
    Secants of the logarithms of reserve and torque, of all checks at once.
    """
    found, design = crank_checks(results), results.design
    found = _failed_before(results, found)
    if two_ways(results):
        equal = _failed_before(results.equal, crank_checks(results.equal))
        surer = [_surer(check, equal[check.code]) for check in found.checks]
        return of_parts(design=design, checks=surer)
    torques = _Torques(design, found)
    moved = torques.looks or (results.solved and torques.others)
    if design.clearance_unknown or not moved:
        return found
    every = every and not results.in_series
    return torques.judged(every=every, guess=_guess(results))


def _failed_before(results: Results, found: Verdict) -> Verdict:
    """The same where checks that are not known, as the torque is too much, fail under less: that is
    passed on the way to it, whatever comes then.
    """
    open_parts = {part.code for part in found.parts if part.status == "open"}
    unknown = [
        each
        for each in found.checks
        if each.opens and each.reason in TOO_MUCH and each.kind.part in open_parts
    ]
    if not unknown or (results.in_series and not results.series.pins_alike):
        return found
    design, solved, unsolved = results.design, 0.0, 1.0
    for _ in range(LOOKS):
        factor = math.sqrt(solved * unsolved) or LESS * unsolved
        there = Results(under(design=design, factor=factor), equal=results.shared_equally)
        looked = [crank_check(each.code, there) for each in unknown]
        broken = {
            each.code: factor * each.torque_reserve
            for each in looked
            if each.status == "fail" and each.torque_reserve
        }
        if broken:
            checks = (
                each._replace(status="fail", torque_reserve=broken[each.code], rough=True)
                if each.code in broken
                else each
                for each in found.checks
            )
            return of_parts(design=design, checks=checks)
        if any(each.reason in TOO_MUCH for each in looked):
            unsolved = factor
        else:
            solved = factor
    return found


def two_ways(results: Results) -> bool:
    """Whether satellites of perfect parts, of which the clearance is not known, may share the load
    by the bending of their pins or equally.

    Parameters
    ----------
    results : Results
        Results of a design.

    Returns
    -------
    bool
    """
    design = results.design
    return design.clearance_unknown and results.solved and not design.as_made


def _surer(solved: Check, equal: Check) -> Check:
    """A check of satellites that may share the load in two ways: it fails where it fails by both,
    and is not judged where by one.
    """
    if solved.status == equal.status:
        return equal if solved.reason in TOO_MUCH else solved
    if "fail" not in (solved.status, equal.status):
        return equal
    return equal._replace(
        status="not_checked", reason="clearance_unknown", missing=("contact.hole_clearance",)
    )


def under(*, design: Design, factor: float) -> Design:
    """A design under so many times its torques.

    Parameters
    ----------
    design : Design
        The design.
    factor : float
        Factor on working and peak torque.

    Returns
    -------
    Design
    """
    torque, peak = design.load.output_torque * factor, design.load.peak_torque
    more = {"load.output_torque": torque, "load.peak_torque": peak and peak * factor}
    return changed(design, more)


DOUBTS = ("pressure_error", "shakedown_unknown", "range_decides", "default_decides")
"""Reasons for which a check is marginal whatever it is under other torques."""


UNSOLVED = -math.inf
"""What is left of reserves where forces cannot be solved, as a logarithm."""


class _Torques:
    """Checks of a design whose reserves are estimates, under several torques."""

    def __init__(self, design: Design, found: Verdict) -> None:
        self.design, self.found = design, found
        self.counted = {each.code for each in found.checks if not each.warning}
        # by code: logarithms of factors on the torque, and of the reserve that is left there
        self.looks: dict[str, list[tuple[float, float]]] = {}
        # checks that hold, that the torque moves, and of which no reserve is known
        self.others = [
            each
            for each in found.checks
            if each.status in ("pass", "marginal")
            and not (each.warning or each.by_torque)
            and each.utilisation
            and each.kind.loaded
        ]
        # logarithms of factors under which a check is not known
        self.unsolved: dict[str, list[float]] = {each.code: [] for each in found.checks}
        for each in found.checks:
            if each.rough and each.torque_reserve:
                self.looks[each.code] = [(0.0, math.log(each.torque_reserve))]
        self.exact = [
            math.log(each.torque_reserve)
            for each in found.checks
            if each.torque_reserve and not each.rough and not each.warning
        ]

    def look(self, factor: float) -> float:
        """The least logarithm of a reserve that is left under so many times the torque; `UNSOLVED`
        where one is not known there.
        """
        there, x = Results(under(design=self.design, factor=factor)), math.log(factor)
        least, known = min(self.exact, default=math.inf) - x, True
        for check in [*self.others]:
            if crank_check(check.code, there).status == "fail":
                self.others.remove(check)
                self.looks[check.code] = [(0.0, math.log(_left(check)))]
        for code, looks in self.looks.items():
            reserve = _left(crank_check(code, there))
            if reserve:
                looks.append((x, math.log(reserve)))
                least = min(least, looks[-1][1] if code in self.counted else math.inf)
            else:
                self.unsolved[code].append(x)
                known = known and code not in self.counted
        return least if known else UNSOLVED

    def root(self, code: str) -> float:
        """Logarithm of the factor at which a check fails, by the two looks next to it; between the
        last that holds and the first that does not, where there are such, and the two say that it
        lies elsewhere.
        """
        (x1, y1), *others = sorted(self.looks[code], key=lambda look: abs(look[1]))
        if not math.isfinite(y1):
            return math.inf
        x0, y0 = others[0] if others else (x1, math.inf)
        slope = (y1 - y0) / (x1 - x0) if math.isfinite(y0) and x1 != x0 else -1.0
        lower = max((look for look in self.looks[code] if look[1] >= 0), default=(-math.inf, 0.0))
        upper = min((look for look in self.looks[code] if look[1] < 0), default=(math.inf, 0.0))
        if not math.isfinite(lower[0] - upper[0] + lower[1]):
            return x1 - y1 / max(-STEEPEST, min(slope, -1 / STEEPEST))
        x = x1 - y1 / slope if slope < 0 else math.nan
        if lower[0] < x < upper[0]:
            return x
        return (lower[0] * upper[1] - upper[0] * lower[1]) / (upper[1] - lower[1])

    def within(self, code: str) -> float:
        """The same; between the next look and the torque without forces that is next to that,
        where the two looks say that it lies beyond.
        """
        x = self.root(code)
        known = min((look for look, _ in self.looks[code]), key=lambda look: abs(look - x))
        beyond = [each for each in self.unsolved[code] if abs(each - known) <= abs(x - known)]
        between = [each for each in beyond if (each - known) * (x - known) > 0]
        if not between or not math.isfinite(x):
            return x
        return (known + min(between, key=lambda each: abs(each - known))) / 2

    def first(self) -> float:
        """Logarithm of the factor at which the first check fails."""
        roots = [self.root(code) for code in self.looks if code in self.counted]
        return min([*roots, *self.exact], default=math.inf)

    def away(self, code: str) -> float:
        """How far the factor at which a check fails lies from the next look, as a logarithm, or
        what is left there, where that is more.
        """
        x = self.within(code)
        return min(max(abs(x - look), abs(left)) for look, left in self.looks[code])

    def look_further(self) -> None:
        """Looks at the torques under which the other checks fail, farthest from what is known;
        where one is without forces, nearer.
        """
        for _ in range(FURTHER):
            away = {self.away(code): code for code in self.looks}
            farthest = max(filter(math.isfinite, away), default=0.0)
            if farthest <= NEAR:
                return
            self.look(math.exp(self.within(away[farthest])))

    def largest(self, left: float) -> tuple[float, bool]:
        """The largest factor that is known to hold, 0 where none is, and whether the first check
        fails there; by what is left under `MARGIN` times the torque.
        """
        unsolved = math.log(MARGIN) if left == UNSOLVED else math.inf
        holds = 1.0 if self.first() >= 0 else 0.0
        if left >= 0:
            holds = MARGIN
        if self.found.impossible:
            return holds, False
        before, left_before = math.log(MARGIN), left
        for _ in range(LOOKS):
            x = self.first()
            if x >= unsolved:  # forces cannot be solved there
                x = (math.log(holds or 1.0) + unsolved) / 2
            if not math.isfinite(x):
                break
            left = self.look(math.exp(x))
            if left == UNSOLVED:
                unsolved = x
            elif abs(left) <= JUDGED:
                return math.exp(self.first()), True
            elif left >= 0:
                holds = max(holds, math.exp(x))
            elif x < before and left - left_before < CURES_NOTHING * (before - x):
                break
            before, left_before = x, left
        return holds, False

    def guessed(self) -> float:
        """About the factor at which the first check fails."""
        holds, settled = self.largest(self.look(MARGIN))
        return math.exp(self.first()) if settled else holds

    def judged(self, *, every: bool, guess: float | None = None) -> Verdict:
        """The verdict with what is seen under other torques; by a guess one of them, near which the
        first check fails, and no other.
        """
        left = self.look(MARGIN)
        at_margin = {code: looks[1][1] for code, looks in self.looks.items() if looks[1:]}
        at_margin |= {check.code: 0.0 for check in self.others}
        if guess is None:
            limit, settled = self.largest(left)
        else:
            settled = False
            known = guess > 0 and self.look(guess) > UNSOLVED and math.isfinite(self.first())
            limit = math.exp(self.first()) if known else 0.0
        if settled and every:
            self.look_further()
        checks = []
        for check in self.found.checks:
            if check.code in self.looks:
                own = math.exp(self.within(check.code))
                given = limit > 0 or self.found.impossible  # none is where none holds
                raised = max(own, limit) if given else None
                reserve = raised if check.code in self.counted else own
                seen = self.away(check.code) <= NEAR and own == math.exp(self.root(check.code))
                rough = not (settled and seen)
                check = check._replace(torque_reserve=reserve, rough=rough)
                check = _under_margin(check, at_margin.get(check.code, -1.0) >= 0)
            checks.append(check)
        found = of_parts(design=self.design, checks=checks)
        if found.torque_reserve is None:
            return found
        least = found.torque_reserve if settled else limit
        return replace(found, torque_reserve=least, largest_torque_estimated=not settled)


def _left(check: Check) -> float:
    """What is left of a check under its torque, as its reserve or else of its limit; 0 where
    neither is known.
    """
    return check.torque_reserve or 1 / (check.utilisation or math.inf)


def _guess(results: Results) -> float | None:
    """Factor on the torque at which the first check fails, about, of a design in series that takes
    long, as its pins deviate: by each mesh with satellites that turn as one. None of other designs.
    """
    if not results.in_series or results.series.pins_alike:
        return None
    apart = changed(results.design, {"satellite_coupling": RIGID_SUPPORT})
    return _Torques(apart, crank_checks(Results(apart))).guessed()


def _under_margin(check: Check, holds: bool) -> Check:
    """A check that holds, or does not, under `MARGIN` times the torque."""
    sure = check.status in ("pass", "marginal") and check.reason not in DOUBTS
    if check.warning or not sure:
        return check
    found = check._replace(status="pass" if holds else "marginal")
    if not check.by_torque:
        return found
    nearer = max if holds else min
    return found._replace(torque_reserve=nearer(check.reserve, MARGIN))
