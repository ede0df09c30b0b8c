"""Checks of the play of the output: backlash and lost motion against what is asked."""

from collections.abc import Callable

from core.checks.check import Check, judged, not_asked
from core.checks.crank_design import CrankDesign
from core.checks.real_forces import RealForces


def no_eccentricity(code: str) -> Check:
    """A check that hangs on the clearance where that is not known.

    Parameters
    ----------
    code : str
        Which.

    Returns
    -------
    Check
    """
    missing = ("eccentricity",)
    return Check(code=code, status="not_checked", reason="eccentricity_missing", missing=missing)


def _backlash(design: CrankDesign) -> Check:
    code, limit = "backlash", design.max_backlash
    forces = design.loading if design.as_made else None
    value = forces.turn.backlash_max if isinstance(forces, RealForces) else None
    if not design.as_made and design.clearance is not None:  # none, or interference
        value = 0.0
    if limit is None:
        return not_asked(code=code, value=value, name=f"max_{code}")
    if design.eccentricity is None:
        return no_eccentricity(code)
    if value is None:
        return Check(
            code=code, status="not_checked", limit=limit, reason=design.why_unknown(forces)
        )
    return judged(code, value, limit)


def _lost_motion(design: CrankDesign) -> Check:
    code, limit = "lost_motion", design.max_lost_motion
    if limit is None:
        known = design.as_made and design.dynamic_factor == 1
        forces = design.real_forces if known else None
        value = forces.turn.lost_motion if isinstance(forces, RealForces) else None
        return not_asked(code=code, value=value, name=f"max_{code}")
    if design.eccentricity is None:
        return no_eccentricity(code)
    forces = design.real_forces  # at the torque itself, of which it takes a share
    if not isinstance(forces, RealForces):
        return Check(
            code=code, status="not_checked", limit=limit, reason=design.why_unknown(forces)
        )
    return judged(code, forces.turn.lost_motion, limit)


PLAY: dict[str, Callable[[CrankDesign], Check]] = {
    "backlash": _backlash,
    "lost_motion": _lost_motion,
}
"""Checks of the play of the output, by code."""
