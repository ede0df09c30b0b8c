"""The largest torque of a design as it is made: its forces are solved again at that torque.

Real forces do not grow with the torque: clearance and deviations share a small one among fewer
pairs. A reserve of pins, bearings or wear by the forces at one torque is an estimate at another.
"""

import math

from core.checks.check import MARGIN, Check, Verdict, verdict
from core.checks.crank_planetary import crank_checks
from core.design.document import Design, changed
from core.design.results import Results
from core.output.satellite_support import Shares

LOOKS, SETTLED = 8, 1e-5
"""Torques at most that are looked at, and how far the last one's reserve may be off 1."""

STEEPEST = 3.0
"""Most that a reserve changes with the torque, as a slope of logarithms, and 1 over the least."""


def exact_torque(*, design: Design, found: Verdict) -> Verdict:
    """The verdict of a design with its torque reserve found by its checks at that torque.

    Parameters
    ----------
    design : Design
        The design.
    found : Verdict
        Its verdict.

    Returns
    -------
    Verdict
        As it is where it is no estimate, and of given shares, whose forces take too long. What
        stays one, as forces cannot be solved or jump with the torque, has the largest torque looked
        at under which all checks hold.

    Notes
    -----
    Secants of the logarithms of reserve and torque, from the estimate. At the last torque no check
    fails and the first is at its limit: reserves that were estimated below it are raised to it.
    """
    reserve = found.torque_reserve
    if not (found.largest_torque_estimated and reserve) or isinstance(design.support, Shares):
        return found
    x0, y0 = 0.0, math.log(reserve)
    x, safe = y0, 0.0
    for _ in range(LOOKS):
        there = crank_checks(Results(_under(design, math.exp(x))))
        unknown = there.counts["not_checked"] > found.counts["not_checked"]
        if unknown or not there.torque_reserve:
            break
        left = there.torque_reserve
        if abs(left - 1) <= SETTLED:
            return _settled(found, math.exp(x) * left, _first(there), rough=False)
        if left > 1:
            safe = max(safe, math.exp(x))
        y = math.log(left)
        slope = (y - y0) / (x - x0) if x != x0 else -1.0
        slope = max(-STEEPEST, min(slope, -1 / STEEPEST))
        x0, y0, x = x, y, x - y / slope
    return _settled(found, safe, _first(found), rough=True) if safe else found


def _under(design: Design, factor: float) -> Design:
    """The design under so many times its torques."""
    torque, peak = design.load.output_torque * factor, design.load.peak_torque
    more = {"load.output_torque": torque, "load.peak_torque": peak and peak * factor}
    return changed(design, more)


def _first(found: Verdict) -> str:
    """Code of the check that fails first."""
    counted = [
        each
        for each in found.checks
        if each.torque_reserve == found.torque_reserve and not each.warning
    ]
    return counted[0].code


def _settled(found: Verdict, reserve: float, first: str, *, rough: bool) -> Verdict:
    """The verdict with the reserve of the check that fails first, no other one below it that could
    fail: a warning may come at less.
    """

    def settled(check: Check) -> Check:
        known = check.torque_reserve
        if known is None or not check.rough or check.warning:
            return check
        own = reserve if check.code == first else max(known, reserve)
        status = check.status
        if status in ("pass", "marginal") and not check.reason:
            status = "marginal" if own < MARGIN else "pass"
        return check._replace(torque_reserve=own, status=status, rough=rough)

    return verdict([settled(each) for each in found.checks], found.not_considered)
