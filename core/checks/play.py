"""Checks of the play of the output: backlash and lost motion against what is asked."""

from collections.abc import Callable

from core.checks.check import Check, asked
from core.checks.crank_design import CrankDesign
from core.checks.design.forces import Forces
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


def _asked(
    design: CrankDesign, code: str, limit: float | None, value: float | None, forces: Forces
) -> Check:
    """A play against what is asked."""
    if limit is not None and design.eccentricity is None:
        return no_eccentricity(code)

    def unknown() -> Check:
        reason = design.why_unknown(forces)
        return Check(code=code, status="not_checked", limit=limit, reason=reason)

    return asked(code, value, limit, name=f"max_{code}", unknown=unknown)


def _backlash(design: CrankDesign) -> Check:
    forces = design.loading if design.as_made else None
    value = forces.turn.backlash_max if isinstance(forces, RealForces) else None
    if not design.as_made and design.clearance is not None:  # none, or interference
        value = 0.0
    return _asked(design, "backlash", design.max_backlash, value, forces)


def _lost_motion(design: CrankDesign) -> Check:
    limit = design.max_lost_motion
    wanted = limit is not None and design.eccentricity is not None
    # at the torque itself, of which it takes a share
    known = wanted or (limit is None and design.as_made and design.dynamic_factor == 1)
    forces = design.real_forces if known else None
    value = forces.turn.lost_motion if isinstance(forces, RealForces) else None
    return _asked(design, "lost_motion", limit, value, forces)


PLAY: dict[str, Callable[[CrankDesign], Check]] = {
    "backlash": _backlash,
    "lost_motion": _lost_motion,
}
"""Checks of the play of the output, by code."""
