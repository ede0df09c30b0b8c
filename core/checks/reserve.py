"""Verdict of a crank-planetary reducer under its torque and under a tenth more, and on request the
torque at which it first fails.

Clearance and deviations concentrate a small torque on fewer pairs, so that solved forces are not
proportional to the torque and the design is solved again under another one. A stated reserve is a
torque at which all checks were made and held, next to one at which a check was made and failed.
"""

import math
from dataclasses import replace

from core.checks.check import BY_RANGE, DOUBTS, MARGIN, Check, Verdict
from core.checks.crank_planetary import crank_check, crank_checks, of_parts
from core.design.results import Results

LOOKS = 12
"""Largest number of torques that are tried to find the first failure."""

NEAR, KNOWN = 1.01, 1.05
"""Ratio of a failing torque to a holding one at which no further torque is tried, and up to which
the holding one is a reserve."""

STRIDE = 10.0
"""Largest factor between one torque and the next while all hold, or none does."""

FAR = 1.3
"""Torque reserve by its value above which a check is not tried under `MARGIN` times the torque if
another one is that comes nearer to its limit. In 293 designs the reserve fell by a factor of 1.21
at most, for a value that grows with the square of the torque."""

FARTHEST = 1e6
"""Factor on the torque beyond which no check is expected at its limit."""

LEAST = 1e-6
"""Least part of a failing torque that is tried, as parts with interference press without torque."""

TOO_MUCH = ("not_stable", "beyond_hertz", "contact_wraps")
"""Reasons why a check is not known under a torque, but may be under less."""


def crank_verdict(results: Results, *, largest: bool = False) -> Verdict:
    """Verdict of a crank-planetary reducer under its torque and under `MARGIN` times its torque.

    A check with solved forces that fails, or is not known, under `MARGIN` times the torque is
    marginal. If forces cannot be solved or a contact wraps around its pin, a check that fails under
    less torque fails; this is not tried for discs in series on unlike pins, which takes long. True
    for `largest` searches for the torque at which the first check fails. For solved forces the
    torque reserve is known only then: the largest torque tried that holds, with a failing one at
    most `NEAR` times larger, or `KNOWN` times at a jump. Checks that only warn do not count for it;
    those that do at that torque are named.
    """
    found = _verdict(results, largest=largest)
    warnings = [each for each in found.checks if each.warning and each.kind.loaded]
    if not (warnings and largest and found.torque_reserve and found.largest_torque_known):
        return found
    there = results.under(found.torque_reserve)
    looked = (crank_check(each.code, there) for each in warnings)
    warned = tuple(each.code for each in looked if each.warning and each.status == "marginal")
    return replace(found, uncounted=warned)


def _verdict(results: Results, *, largest: bool) -> Verdict:
    """Verdict as of `crank_verdict`, without the checks that warn at the largest torque."""
    torques = _judged(results)
    found = torques.found
    if results.two_ways:
        equal = _judged(results.equal).found
        found = _changed(results, found, [_surer(each, equal[each.code]) for each in found.checks])
        return replace(found, torque_reserve=None)
    if not torques.moved or found.impossible:
        return found
    bears = found.torque_reserve is not None or not torques.grow
    sought = largest and bears and not results.design.clearance_unknown
    if sought and (bracket := torques.bracket()):
        return torques.between(*bracket)
    return replace(found, torque_reserve=None, largest_torque_known=False)


def _surer(solved: Check, equal: Check) -> Check:
    """Check of satellites with two ways of sharing: fails if both fail, not judged if one fails."""
    if solved.status == equal.status:
        return equal if solved.reason in TOO_MUCH else solved
    if "fail" not in (solved.status, equal.status):
        return equal
    return equal._replace(
        status="not_checked", reason="clearance_unknown", missing=("contact.hole_clearance",)
    )


def _changed(results: Results, found: Verdict, others: list[Check]) -> Verdict:
    """Verdict with some checks replaced by others of equal code."""
    by_code = {each.code: each for each in (*found.checks, *others)}
    return of_parts(design=results.design, checks=by_code.values())


def _judged(results: Results) -> "_Torques":
    """All checks under the torque and `MARGIN` times it, ordered by both."""
    torques = _Torques(results, _failed_before(results, crank_checks(results)))
    sure = [
        each
        for each in torques.found.checks
        if each.status in ("pass", "marginal")
        and each.reason not in DOUBTS
        and each.code in torques.moved
    ]
    seen: list[Check] = []
    far = FAR
    for check in sorted(sure, key=lambda each: (not each.by_torque, _left(each))):
        # A check is compared with those tried by its value alone, unless it could be nearer.
        nearest = min((each.reserve for each in seen), default=math.inf)
        if seen and _left(check) >= (max(far, nearest) if check.by_torque else far):
            seen.append(check._replace(status="pass"))
            continue
        holds = _holds(torques.at(MARGIN, check.code))
        far = math.inf if holds is None else far  # unknown forces are unknown for all checks
        check = check._replace(status="pass" if holds else "marginal")
        if check.by_torque:
            nearer = (max if holds else min)(torques.root(check.code), MARGIN)
            check = check._replace(torque_reserve=nearer)
        seen.append(check)
    torques.found = _changed(results, torques.found, seen)
    return torques


def _failed_before(results: Results, found: Verdict) -> Verdict:
    """Verdict in which checks unknown under too much torque fail if they fail under less torque."""
    open_parts = {part.code for part in found.parts if part.status == "open"}
    of_open = (each for each in found.checks if each.opens and each.kind.part in open_parts)
    unknown = {each.code: each for each in of_open if each.reason in TOO_MUCH}
    if not unknown or (results.in_series and not results.series.pins_alike):
        return found
    solved, unsolved = 0.0, 1.0
    for _ in range(LOOKS):
        factor = math.sqrt(solved * unsolved) or unsolved / STRIDE
        there = results.under(factor)
        looked = [crank_check(code, there) for code in unknown]
        failed = [
            unknown[each.code]._replace(
                status="fail", torque_reserve=factor * each.reserve, solved=True
            )
            for each in looked
            if each.status == "fail" and each.by_torque
        ]
        if failed:
            return _changed(results, found, failed)
        too_much = any(each.reason in TOO_MUCH for each in looked)
        solved, unsolved = (solved, factor) if too_much else (factor, unsolved)
    return found


def _holds(check: Check) -> bool | None:
    """True if a check holds over the range of assumed values too; None if it is not known."""
    if check.status == "not_checked" and not check.only_needed:
        return None
    over = check.by_torque and check.reserve < 1
    return not (check.status == "fail" or check.reason in BY_RANGE or over)


def _left(check: Check) -> float:
    """Torque reserve of a check, or else its limit over its value; 0 if that is not known."""
    return check.reserve if check.by_torque else 1 / (check.utilisation or math.inf)


class _Torques:
    """Checks of a design under several torques."""

    def __init__(self, results: Results, found: Verdict) -> None:
        self.results, self.found = results, found
        counted = [each for each in found.checks if _holds(each) is not None and not each.warning]
        self.grow = [each for each in counted if each.by_torque]
        # Codes of checks that other torques move; with solved forces any loaded check may fail.
        self.moved = [each.code for each in self.grow if each.solved]
        if self.moved or results.solved:
            others = (each for each in counted if each.kind.loaded and not each.by_torque)
            self.moved += [each.code for each in others if _holds(each) and each.utilisation]
        self.exact = min((each.reserve for each in self.grow if not each.solved), default=math.inf)
        self.looks = {1.0: {each.code: each for each in found.checks if each.code in self.moved}}

    def at(self, factor: float, code: str) -> Check:
        """Check under a factor on the torque."""
        made = self.looks.setdefault(factor, {})
        if code not in made:
            made[code] = crank_check(code, self.results.under(factor))
        return made[code]

    def holds(self, factor: float) -> bool | None:
        """True if all checks hold under a factor on the torque; None if that is not known.

        The check that is nearest to its limit is made first. After one that fails, only those are
        made that should fail too.
        """
        if factor > self.exact:
            return False
        roots = {code: self.root(code) for code in self.moved}
        found: set[bool | None] = set()
        for code in sorted(self.moved, key=roots.__getitem__):
            if False in found and roots[code] > factor:
                break
            found.add(_holds(self.at(factor, code)))
        return False if False in found else None if None in found else True

    def bracket(self) -> tuple[float, float] | None:
        """Neighbouring torque factors where all checks hold and the first fails, or None."""
        held, failed, above, factor, slow = 0.0, math.inf, math.inf, 1.0, 0
        for _ in range(LOOKS):
            apart = above / held if held else math.inf
            holds = self.holds(factor)
            held, above = (factor, above) if holds else (held, factor)
            failed = factor if holds is False else failed
            if held == self.exact:
                return held, math.inf
            if held and above <= NEAR * held:
                break
            # Bisect if no check predicts where the unknown begins, or two tries came no nearer.
            slow = slow + 1 if held and above / held > math.sqrt(apart) else 0
            halves = held and (above < failed or slow == 2)
            factor = math.sqrt(held * above) if halves else self.next(held, above)
            if not factor:
                break
            slow = 0 if halves else slow
        return (held, failed) if held and failed <= KNOWN * held else None

    def next(self, held: float, above: float) -> float:
        """Next factor to try, below the expected failure; 0 if no other torque can help."""
        root = min(map(self.root, self.moved), default=FARTHEST)
        wanted = self.exact if self.exact <= root else root / math.sqrt(NEAR)
        if not held:
            least = max(wanted, above / STRIDE)
            return min(least, above / NEAR) if wanted > LEAST * above else 0.0
        if above == math.inf:
            most = held * STRIDE if held >= MARGIN else MARGIN
            endless = min(root, self.exact) >= FARTHEST and held >= MARGIN
            return 0.0 if endless else min(max(wanted, held * NEAR), most, self.exact)
        near = min(max(wanted, held * NEAR), above / NEAR, self.exact)
        return near if held < near < above else math.sqrt(held * above)

    def root(self, code: str) -> float:
        """Expected factor at a check's limit, by a power law; 0 if less torque does not cure it."""
        looks = self.looks.items()
        left = ((_left(each[code]), factor) for factor, each in looks if code in each)
        known = ((math.log(y), math.log(factor)) for y, factor in left if 0 < y < math.inf)
        nearest = sorted(known, key=lambda each: abs(each[0]))
        if not nearest:
            return FARTHEST
        (y, x), *others = nearest
        slope = (y - others[0][0]) / (x - others[0][1]) if others else -1.0
        if slope >= 0:
            return 0.0 if y < 0 else FARTHEST
        return min(math.exp(min(x - y / slope, 99.0)), FARTHEST)

    def between(self, reserve: float, failed: float) -> Verdict:
        """Verdict with the reserve found, given to the check that fails next to it."""
        failing = (each for each in self.looks.get(failed, {}).values() if _holds(each) is False)
        first = min(failing, key=_left, default=None)
        seen = []
        for each in self.found.checks:
            if first and each.code == first.code:
                seen.append(each._replace(torque_reserve=reserve, solved=False))
            elif each.code in self.moved and each.by_torque:
                seen.append(each._replace(torque_reserve=max(each.reserve, NEAR * reserve)))
        return _changed(self.results, self.found, seen)
