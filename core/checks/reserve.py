"""The verdict of a crank-planetary reducer: whether it holds, whether it holds a tenth more torque,
and, where that is asked, the torque at which it first fails.

Clearance and deviations share a small torque among fewer pairs, so forces that are solved do not
grow in proportion to it: the design is solved again under another one. A reserve is a torque that
was looked at and held, beside one that was looked at and failed; no other is stated.
"""

import math
from dataclasses import replace

from core.checks.check import MARGIN, Check, Verdict
from core.checks.crank_planetary import crank_check, crank_checks, of_parts
from core.design.results import Results

LOOKS = 12
"""Torques at most that are looked at for one at which a check fails."""

NEAR, KNOWN = 1.01, 1.05
"""How many times larger a torque that fails is than one that holds, at which no other is looked at,
and up to which that one is a reserve.
"""

STRIDE = 10.0
"""How many times larger or smaller the next torque is at most, while all hold, or none does."""

FAR = 1.3
"""Factor on the torque that a check has left, by its value, with which it is not looked at under
`MARGIN` times the torque, where another one is: what is left fell by 1.21 times at most in 293
designs, by a number that grows with the square of the torque.
"""

FARTHEST = 1e6
"""Times the torque beyond which no check is expected at its limit."""

LEAST = 1e-6
"""Part of a torque that fails, below which none is looked for: of parts that press without any."""

TOO_MUCH = ("not_stable", "not_balanced", "beyond_hertz", "contact_wraps")
"""Reasons for which a check is not known under a torque, and may be under less."""

BY_RANGE = ("range_decides", "default_decides")
"""Reasons for which a check fails by one end of what is not typed, and is marginal."""

DOUBTS = ("pressure_error", "shakedown_unknown", *BY_RANGE)
"""Reasons for which a check is marginal whatever it is under other torques."""


def crank_verdict(results: Results, *, largest: bool = False) -> Verdict:
    """All checks of a crank-planetary reducer, judged under the torque and under a tenth more.

    Parameters
    ----------
    results : Results
        Results of a design.
    largest : bool
        Whether the torque is looked for at which it first fails.

    Returns
    -------
    Verdict
        Where forces cannot be solved, or a contact wraps around its pin, a check fails that does so
        under less torque, at which it is known, but of discs in series on unlike pins, which take
        long. A check whose forces are solved is marginal that fails, or is not known, under
        `MARGIN` times the torque. Where forces are solved a reserve is known only where the largest
        torque is asked: that of the check which fails first, at the largest torque looked at that
        holds, with one that fails at most `NEAR` times as large, beside a jump `KNOWN` times.
    """
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


def _changed(results: Results, found: Verdict, others: list[Check]) -> Verdict:
    """The verdict with other checks in the place of those of their codes."""
    by_code = {each.code: each for each in (*found.checks, *others)}
    return of_parts(design=results.design, checks=by_code.values())


def _judged(results: Results) -> "_Torques":
    """All checks under the torque and `MARGIN` times it; by both they are ordered."""
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
        if _left(check) >= far and seen:
            seen.append(check._replace(status="pass"))
            continue
        holds = _holds(torques.at(MARGIN, check.code))
        far = math.inf if holds is None else far  # forces that are not known, of others neither
        check = check._replace(status="pass" if holds else "marginal")
        if check.by_torque:
            nearer = (max if holds else min)(torques.root(check.code), MARGIN)
            check = check._replace(torque_reserve=nearer)
        seen.append(check)
    torques.found = _changed(results, torques.found, seen)
    return torques


def _failed_before(results: Results, found: Verdict) -> Verdict:
    """Checks of which those fail that are not known, as the torque is too much, and fail under
    less: it is passed on the way to the torque, whatever comes then.
    """
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
    """True where a check holds, over the range of what is not typed too; None where it is not
    known.
    """
    if check.status == "not_checked" and not check.only_needed:
        return None
    over = check.by_torque and check.reserve < 1
    return not (check.status == "fail" or check.reason in BY_RANGE or over)


def _left(check: Check) -> float:
    """Reserve of a check under its torque, or else its limit over its value; 0 where that
    is not known.
    """
    return check.reserve if check.by_torque else 1 / (check.utilisation or math.inf)


class _Torques:
    """Checks of a design under several torques."""

    def __init__(self, results: Results, found: Verdict) -> None:
        self.results, self.found = results, found
        counted = [each for each in found.checks if _holds(each) is not None and not each.warning]
        self.grow = [each for each in counted if each.by_torque]
        # Codes of those whose forces are solved; of such a design others that hold may fail too.
        self.moved = [each.code for each in self.grow if each.solved]
        if self.moved or results.solved:
            others = (each for each in counted if each.kind.loaded and not each.by_torque)
            self.moved += [each.code for each in others if _holds(each) and each.utilisation]
        self.exact = min((each.reserve for each in self.grow if not each.solved), default=math.inf)
        self.looks = {1.0: {each.code: each for each in found.checks if each.code in self.moved}}
        self.there: dict[float, Results] = {}

    def at(self, factor: float, code: str) -> Check:
        """A check under so many times the torque."""
        if factor not in self.looks:
            self.looks[factor], self.there[factor] = {}, self.results.under(factor)
        made = self.looks[factor]
        if code not in made:
            made[code] = crank_check(code, self.there[factor])
        return made[code]

    def look(self, factor: float) -> dict[str, Check]:
        """The checks that have to be made again under so many times the torque."""
        return {code: self.at(factor, code) for code in self.moved}

    def holds(self, factor: float) -> bool | None:
        """True where all checks hold under so many times the torque; None where it is unknown."""
        if factor > self.exact:
            return False
        found = {_holds(check) for check in self.look(factor).values()}
        return False if False in found else None if None in found else True

    def bracket(self) -> tuple[float, float] | None:
        """Factors on the torque beside each other, at which all checks hold and the first one
        fails; None where no torque is found that holds, or none beside it that fails.
        """
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
            # Halved where no check says where the unknown begins, or two looks came no nearer.
            slow = slow + 1 if held and above / held > math.sqrt(apart) else 0
            halves = held and (above < failed or slow == 2)
            factor = math.sqrt(held * above) if halves else self.next(held, above)
            if not factor:
                break
            slow = 0 if halves else slow
        return (held, failed) if held and failed <= KNOWN * held else None

    def next(self, held: float, above: float) -> float:
        """The torque to look at, a little below that at which the first check should fail; 0 where
        less cures nothing, or more breaks nothing.
        """
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
        """Factor at which a check should be at its limit, by the power of the torque between the
        two looks that are next to it; 0 where less torque does not cure it.
        """
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
        """The verdict with a reserve, which is that of the check that fails next to it."""
        failing = (each for each in self.looks.get(failed, {}).values() if _holds(each) is False)
        first = min(failing, key=_left, default=None)
        seen = []
        for each in self.found.checks:
            if first and each.code == first.code:
                seen.append(each._replace(torque_reserve=reserve, solved=False))
            elif each.code in self.moved and each.by_torque:
                seen.append(each._replace(torque_reserve=max(each.reserve, NEAR * reserve)))
        return _changed(self.results, self.found, seen)
