"""Shares of the torque that the satellites carry, if they are uneven, and the cause."""

import math
from dataclasses import dataclass
from itertools import pairwise
from typing import Literal

import numpy as np

from core.checks.check import Check, Verdict
from core.checks.crank_planetary import crank_check
from core.design.document import changed
from core.design.results import Results
from core.errors import Notice, if_known
from core.fields import answer
from core.output.elasticity import pin_compliance
from core.output.room import Deviations

ShareModel = Literal["real", "factor", "given"]

ShareReason = Literal[
    "pin_bending", "deviations", "ring_mesh", "crank_support", "clearance", "given"
]

ALIKE = 0.01
"""Largest difference of shares, over 1/K, that counts as even."""

UNEVEN = 1.1
"""Share times K above which sharing is reported as uneven."""

EVEN_CRANKS = 1e-9
"""Difference of the angles between cranks that counts as rounding, rad."""


@dataclass(frozen=True, slots=True)
class DiscShare:
    """Load of one satellite."""

    satellite: int = answer()
    """Number of the satellite, from 1."""
    torque: float = answer("Nm")
    """Mean torque of the satellite over the turn, under the torque without the application
    factor."""
    share: float = answer()
    """Mean torque of the satellite over the whole torque."""
    share_at_peak: float = answer()
    """Share of the satellite at the crank angle of the largest force."""


@dataclass(frozen=True, slots=True)
class Governed:
    """Check that depends on the shares."""

    check: Check
    even: Check | None  # the check with even shares, if that needs no other solution


@dataclass(frozen=True, slots=True)
class DiscShares:
    """Shares of the torque of all satellites."""

    model: ShareModel  # solved forces, a load-sharing factor, or stated shares
    discs: tuple[DiscShare, ...]  # each satellite
    reason: ShareReason  # main cause of the difference
    governs: tuple[Governed, ...]  # deciding checks that depend on the shares

    @property
    def largest(self) -> DiscShare:
        """Satellite that carries most."""
        return max(self.discs, key=lambda each: each.share)

    @property
    def notices(self) -> tuple[Notice, ...]:
        """Warning if one satellite carries much more than an even share."""
        largest, even = self.largest, 1 / len(self.discs)
        if largest.share <= UNEVEN * even:
            return ()
        said = {"satellite": largest.satellite, "share": largest.share, "even": even}
        return (Notice("uneven_sharing", said | {"reason": self.reason}),)


def disc_shares(*, results: Results, found: Verdict) -> DiscShares | None:
    """Shares of the torque over the turn; None if all differ from 1/K by at most `ALIKE`, or forces
    are not known. `found` is the verdict of the design.
    """
    design = results.design
    count = design.mechanism.satellites
    if not (results.uneven and design.load and design.touching):
        return None
    if design.disc_factor > 1:
        model, reason, discs = _by_factor(results)
    else:
        solved = if_known(lambda: _by_forces(results))
        if solved is None:
            return None
        model, reason, discs = solved
    if max(abs(each.share * count - 1) for each in discs) <= ALIKE:
        return None
    return DiscShares(model, discs, reason, _governed(results, found))


Sharing = tuple[ShareModel, ShareReason, tuple[DiscShare, ...]]


def _by_factor(results: Results) -> Sharing:
    """Shares with K_alpha/K for the satellite of the largest pressure; the rest share evenly."""
    design = results.design
    count, torque = design.mechanism.satellites, design.pin_torque
    place = if_known(lambda: results.peak) or {}
    most = int(place.get("satellite", 1))
    rest = (1 - design.disc_factor / count) / (count - 1)
    shares = [design.disc_factor / count if j == most else rest for j in range(1, count + 1)]
    discs = (DiscShare(j, torque * each, each, each) for j, each in enumerate(shares, 1))
    return "factor", "given", tuple(discs)


def _by_forces(results: Results) -> Sharing | None:
    """Shares by solved forces; None if all satellites are alike."""
    design = results.design
    if _alike(results) and not results.in_series:
        return None
    forces, torque = results.real_forces, design.pin_torque
    turn = results.made(forces.way * torque)
    given = design.support.given_shares
    means = turn.mean(turn.couple)
    wave = design.built.wave_angle(forces.turn.peak_crank_angle)
    there = turn.at(wave=wave, values=turn.couple)
    shares, at_peak = means / means.sum(), there / there.sum()
    if given:
        shares = at_peak = np.array(given)
    discs = tuple(
        DiscShare(j + 1, torque * share, share, peak)
        for j, (share, peak) in enumerate(zip(shares.tolist(), at_peak.tolist(), strict=True))
    )
    if given:
        return "given", "given", discs
    return "real", _reason(results, shares.tolist()), discs


def _alike(results: Results) -> bool:
    """True if every satellite meets equal conditions over the turn."""
    design = results.design
    angles = sorted(each % (2 * math.pi) for each in design.built.crank_angles)
    gap = 2 * math.pi / len(angles)
    even = all(abs(b - a - gap) < EVEN_CRANKS for a, b in pairwise(angles))
    bends = design.pin and design.pin.satellite_positions
    stated = design.support.given_shares or _deviating(results)
    return even and not bends and not stated


def _deviating(results: Results) -> bool:
    """True if a size or a place deviates."""
    return results.design.output_deviations not in (None, Deviations())


def _reason(results: Results, shares: list[float]) -> ShareReason:
    """Main cause of the difference; bending if parallel springs of contact and pin explain half."""
    design, count = results.design, len(shares)
    most = shares.index(max(shares))
    bends = design.pin and design.pin.satellite_positions
    if bends:
        reference = design.pin_torque / design.pin_circle_radius
        contact = float(results.compliance(reference / count))
        stiffness = [1 / (contact + each) for each in pin_compliance(design.pin)]
        more = stiffness[most] / sum(stiffness) - 1 / count
        if more >= (shares[most] - 1 / count) / 2:
            return "pin_bending"
    if _deviating(results):
        return "deviations"
    if bends:
        return "pin_bending"
    if results.in_series:
        return "ring_mesh"
    return "crank_support" if design.support.gives else "clearance"


def _governed(results: Results, found: Verdict) -> tuple[Governed, ...]:
    """Deciding checks that depend on the shares, each with its result for even shares."""
    design = results.design
    decide = {found.governing, *(part.governing for part in found.parts)}
    even: Results | None = None
    if design.disc_factor > 1:
        even = Results(changed(design, {"contact.distribution_factor": 1.0}), equal=True)
    elif not design.as_made:
        even = results.equal
    return tuple(
        Governed(check, None if even is None else crank_check(check.code, even))
        for check in found.checks
        if check.code in decide and check.by_torque and "satellite_coupling" in check.kind.inputs
    )
