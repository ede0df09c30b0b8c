"""The verdict of a crank-planetary reducer: whether it holds, whether it holds a tenth more torque,
and, where that is asked, the torque at which it first fails.

Clearance and deviations share a small torque among fewer pairs, so forces that are solved do not
grow in proportion to it: the design is solved again under another one. A reserve is a torque that
was looked at and held, beside one that was looked at and failed; no other is stated.
"""

import math
from collections.abc import Mapping
from dataclasses import replace

from core.checks.check import MARGIN, Check, Verdict
from core.checks.crank_planetary import crank_check, crank_checks, of_parts
from core.design.document import Design, changed
from core.design.results import Results

LOOKS = 12
"""Torques at most that are looked at for one at which a check fails."""

NEAR, KNOWN = 1.01, 1.05
"""How many times larger a torque that fails is than one that holds, at which no other is looked at,
and up to which that one is a reserve.
"""

STRIDE = 10.0
"""How many times larger or smaller the next torque is at most, while all hold, or none does."""

CURES_NOTHING = 0.01
"""Power of the torque by which a check falls, below which less torque cures nothing: of parts that
press without any.
"""

UNSOLVED_LOOKS, LESS = 8, 0.1
"""Torques at most that are looked at where forces cannot be solved, and the first of them."""

TOO_MUCH = ("not_stable", "not_balanced", "beyond_first_order", "beyond_hertz", "contact_wraps")
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
    if two_ways(results):
        by_bending, equal = (_judged(each).found for each in (results, results.equal))
        checks = [_surer(check, equal[check.code]) for check in by_bending.checks]
        found = of_parts(design=results.design, checks=checks)
        return replace(found, torque_reserve=None)
    torques = _judged(results)
    found = torques.found
    if not torques.moved or found.impossible:
        return found
    bears = found.torque_reserve is not None or not torques.grow
    sought = largest and bears and not results.design.clearance_unknown
    if sought and (bracket := torques.bracket()):
        return torques.between(*bracket)
    return replace(found, torque_reserve=None, largest_torque_known=False)


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


def _under(results: Results, factor: float) -> Results:
    """Results under so many times the torque."""
    return Results(under(design=results.design, factor=factor), equal=results.shared_equally)


def _judged(results: Results) -> "_Torques":
    """All checks under the torque and `MARGIN` times it."""
    torques = _Torques(results, _failed_before(results, crank_checks(results)))
    sure = {
        each.code: each
        for each in torques.found.checks
        if each.code in torques.moved
        and each.status in ("pass", "marginal")
        and each.reason not in DOUBTS
    }
    if sure:
        more = torques.look(MARGIN)
        checks = (
            _with_more(each, more[each.code], torques.root(each.code))
            if each.code in sure
            else each
            for each in torques.found.checks
        )
        torques.found = of_parts(design=results.design, checks=checks)
    return torques


def _with_more(check: Check, more: Check, root: float) -> Check:
    """A check by what it is under `MARGIN` times the torque; between these two it is ordered."""
    holds = _holds(more)
    found = check._replace(status="pass" if holds else "marginal")
    nearer = max if holds else min
    return found._replace(torque_reserve=nearer(root, MARGIN)) if check.by_torque else found


def _failed_before(results: Results, found: Verdict) -> Verdict:
    """Checks of which those fail that are not known, as the torque is too much, and fail under
    less: it is passed on the way to the torque, whatever comes then.
    """
    open_parts = {part.code for part in found.parts if part.status == "open"}
    unknown = [
        each
        for each in found.checks
        if each.opens and each.reason in TOO_MUCH and each.kind.part in open_parts
    ]
    if not unknown or (results.in_series and not results.series.pins_alike):
        return found
    solved, unsolved = 0.0, 1.0
    for _ in range(UNSOLVED_LOOKS):
        factor = math.sqrt(solved * unsolved) or LESS * unsolved
        there = _under(results, factor)
        looked = [crank_check(each.code, there) for each in unknown]
        failed = {
            each.code: factor * each.reserve
            for each in looked
            if each.status == "fail" and each.by_torque
        }
        if failed:
            checks = (
                each._replace(status="fail", torque_reserve=failed[each.code], solved=True)
                if each.code in failed
                else each
                for each in found.checks
            )
            return of_parts(design=results.design, checks=checks)
        if any(each.reason in TOO_MUCH for each in looked):
            unsolved = factor
        else:
            solved = factor
    return found


def _holds(check: Check) -> bool | None:
    """Whether a check holds, over the range of what is not typed too; None where it is not
    known.
    """
    if check.status == "not_checked" and not check.only_needed:
        return None
    over = check.by_torque and check.reserve < 1
    return not (check.status == "fail" or check.reason in BY_RANGE or over)


def _left(check: Check) -> float:
    """What is left of a check under its torque, of its reserve or else of its limit; 0 where that
    is not known.
    """
    return check.reserve if check.by_torque else 1 / (check.utilisation or math.inf)


def _may_fail(check: Check) -> bool:
    """Whether a check that holds, and has no reserve, may fail under another torque."""
    return check.kind.loaded and check.status != "fail" and bool(check.utilisation)


class _Torques:
    """Checks of a design under several torques."""

    def __init__(self, results: Results, found: Verdict) -> None:
        self.results, self.found = results, found
        counted = [each for each in found.checks if _holds(each) is not None and not each.warning]
        self.grow = [each for each in counted if each.by_torque]
        moves = any(each.solved for each in self.grow) or results.solved
        # Those whose forces are solved; of such a design others that hold may fail too.
        self.moved = [
            each.code
            for each in counted
            if (each.solved if each.by_torque else moves and _may_fail(each))
        ]
        self.exact = min((each.reserve for each in self.grow if not each.solved), default=math.inf)
        self.looks = {1.0: {each.code: each for each in found.checks if each.code in self.moved}}

    def look(self, factor: float) -> Mapping[str, Check]:
        """The checks that have to be made again under so many times the torque."""
        if factor not in self.looks:
            there = _under(self.results, factor)
            self.looks[factor] = {code: crank_check(code, there) for code in self.moved}
        return self.looks[factor]

    def holds(self, factor: float) -> bool | None:
        """Whether all checks hold under so many times the torque; None where one is not known."""
        if factor > self.exact:
            return False
        found = {_holds(check) for check in self.look(factor).values()}
        return False if False in found else None if None in found else True

    def bracket(self) -> tuple[float, float] | None:
        """Factors on the torque beside each other, at which all checks hold and the first one
        fails; None where no torque is found that holds, or none beside it that fails.
        """
        held, failed, unknown = 0.0, math.inf, math.inf
        factor, halve = 1.0, False
        for _ in range(LOOKS):
            width = min(failed, unknown) / held if held else math.inf
            holds = self.holds(factor)
            if holds:
                held = factor
            elif holds is None:
                unknown = factor
            else:
                failed = factor
            if held == self.exact:
                return held, math.inf
            above = min(failed, unknown)
            if held and above <= NEAR * held:
                break
            halve = bool(held) and above / held > math.sqrt(width) and not halve
            halve |= bool(held) and unknown < failed  # of which no check says where it begins
            if not (factor := math.sqrt(held * above) if halve else self.next(held, above)):
                break
        return (held, failed) if held and failed <= KNOWN * held else None

    def next(self, held: float, above: float) -> float:
        """The torque to look at, a little below that at which the first check should fail; 0 where
        less cures nothing, or more breaks nothing.
        """
        root = min(map(self.root, self.moved), default=math.inf)
        wanted = self.exact if self.exact <= root else root / math.sqrt(NEAR)
        if not held:
            return min(max(wanted, above / STRIDE), above / NEAR) if wanted else 0.0
        if above == math.inf and held < MARGIN:
            return min(MARGIN, self.exact)
        if above == wanted == math.inf:
            return 0.0
        if above == math.inf:
            return min(max(wanted, held * NEAR), held * STRIDE, self.exact)
        near = min(max(wanted, held * NEAR), above / NEAR, self.exact)
        return near if held < near < above else math.sqrt(held * above)

    def root(self, code: str) -> float:
        """Factor at which a check should be at its limit, by the power of the torque between the
        two looks that are next to it; 0 where less torque does not cure it.
        """
        left = ((_left(each[code]), factor) for factor, each in self.looks.items())
        known = ((math.log(y), math.log(factor)) for y, factor in left if 0 < y < math.inf)
        nearest = sorted(known, key=lambda each: abs(each[0]))
        if not nearest:
            return math.inf
        (y, x), *others, slope = *nearest, -1.0
        if others and others[0][1] != x:
            slope = (y - others[0][0]) / (x - others[0][1])
        if slope > -CURES_NOTHING:
            return 0.0 if y < 0 else math.inf
        return math.exp(x - y / slope)

    def between(self, reserve: float, failed: float) -> Verdict:
        """The verdict with a reserve, which is that of the check that fails next to it."""
        failing = (each for each in self.looks.get(failed, {}).values() if _holds(each) is False)
        first = min(failing, key=_left, default=None)
        checks = []
        for each in self.found.checks:
            if first and each.code == first.code:
                checks.append(each._replace(torque_reserve=reserve, solved=False))
            elif each.code in self.moved and each.by_torque:
                checks.append(each._replace(torque_reserve=max(each.reserve, NEAR * reserve)))
            else:
                checks.append(each)
        return of_parts(design=self.results.design, checks=checks)
