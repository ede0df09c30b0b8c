"""Checks of swinging rollers: stress, load sharing, room, tilt."""

import math
from collections.abc import Sequence

from core.checks.check import Check, Verdict, judged, verdict, wall
from core.fatigue import CycleFatigue
from core.results import Notice
from core.rollers.roller_strength import RollerStrength, roller_gaps

MISSING = {
    "endurance_unknown": ("tensile_strength",),
    "notch_unknown": ("fatigue.fatigue_notch_factor",),
}
"""What is missing where a fatigue is not known, by the code that says why."""

ROLLER_LENGTH = 10.0
"""Usual least length of a swinging roller, from end to end, over the eccentricity."""


def roller_checks(
    *,
    result: RollerStrength,
    output_torque: float,
    hole_circle_radius: float,
    rollers: int,
    sphere_diameter: float,
    cylinder_length: float,
    sphere_width: float,
    position_tolerance: float | None = None,
    gaps: Sequence[float] | None = None,
    yield_strength: float | None = None,
    eccentricity: float | None = None,
    bending_safety: float = 1.5,
    fatigue: CycleFatigue | Notice | None = None,
    fatigue_safety: float = 1.5,
) -> Verdict:
    """All checks of swinging rollers.

    Parameters
    ----------
    result : RollerStrength
        Their load sharing and strength.
    output_torque, hole_circle_radius, rollers : as there
        What they were calculated for.
    sphere_diameter, cylinder_length, sphere_width : as there
        Sizes of a roller.
    position_tolerance, gaps : as there
        One of them.
    yield_strength : float, optional
        Yield strength of the rollers, Pa.
    eccentricity : float, optional
        Eccentricity of the crank, m.
    bending_safety : float
        Required safety against yield.
    fatigue : CycleFatigue, Notice or None
        Fatigue of the rollers, or why it is not known; None where nobody asked.
    fatigue_safety : float
        Required safety in fatigue.

    Returns
    -------
    Verdict

    Notes
    -----
    Source of the length: Ovsyannikov et al. 2019, before fig. 3: "the length of a roller usually
    exceeds the centre distance at least 10 times", a tilt of about 12°. That is the whole length,
    two cylinders and three spheres: over half of it, 5*e, the centre moves by e, 11.3°.
    """
    stress, error = float(result.bending_stress), 4 * float(result.accuracy.relative_error)

    def reserve(growth: float) -> float:
        """Factor on the torque at which the largest force is so many times larger."""
        # F_i = c*max(0, Delta - g_i): what the rollers carry then
        largest = float(result.max_force) * growth
        ahead = roller_gaps(rollers=rollers, position_tolerance=position_tolerance, gaps=gaps)
        first = min(ahead)
        carried = math.fsum(
            max(0.0, largest - float(result.stiffness) * (gap - first)) for gap in ahead
        )
        return 2 * hole_circle_radius * carried / output_torque

    if yield_strength is None:
        strength = Check(
            code="roller_stress",
            status="not_checked",
            value=stress,
            reason="yield_unknown",
            missing=("yield_strength",),
        )
    else:
        limit = yield_strength / bending_safety
        strength = judged(
            "roller_stress", stress, limit, reserve=reserve(limit / stress), error=error
        )
    tired = []
    if fatigue is not None:
        growth = None
        if isinstance(fatigue, CycleFatigue):
            growth = reserve(fatigue.safety_factor / fatigue_safety)
        tired.append(
            fatigue_check(
                code="roller_fatigue",
                fatigue=fatigue,
                safety=fatigue_safety,
                reserve=growth,
                error=error,
            )
        )
    sharing = judged(
        "roller_sharing",
        float(result.loaded_rollers),
        float(rollers),
        warning="uneven",
    )
    if rollers > 1:
        pitch = 2 * hole_circle_radius * math.sin(math.pi / rollers)
        spacing = wall("roller_spacing", width=pitch - sphere_diameter, size=sphere_diameter)
    else:
        spacing = Check(code="roller_spacing", status="not_applicable", reason="one_only")
    room = hole_circle_radius - sphere_diameter / 2
    code, length = "roller_tilt", 2 * cylinder_length + 3 * sphere_width
    if eccentricity is None:
        tilt = Check(code=code, status="not_asked", value=length, missing=("eccentricity",))
    else:
        least = ROLLER_LENGTH * eccentricity
        tilt = judged(code, length, least, warning="tilted")
    return verdict(
        [
            strength,
            *tired,
            sharing,
            spacing,
            wall("roller_room", width=room, size=sphere_diameter),
            tilt,
        ],
        ("roller_contact", *(() if tired else ("fatigue",)), "friction"),
    )


def fatigue_check(
    *,
    code: str,
    fatigue: CycleFatigue | Notice,
    safety: float,
    reserve: float | None,
    error: float,
) -> Check:
    """The safety of a stress cycle against the one that is asked.

    Parameters
    ----------
    code : str
        Which check.
    fatigue : CycleFatigue or Notice
        The cycle, or why nothing is known of it.
    safety : float
        Required safety.
    reserve : float or None
        Factor on the torque at which the safety is the required one.
    error : float
        Relative error of the stress.

    Returns
    -------
    Check
    """
    if isinstance(fatigue, Notice):
        return Check(
            code=code,
            status="not_checked",
            limit=safety,
            reason=fatigue.code,
            missing=MISSING[fatigue.code],
        )
    return judged(code, fatigue.safety_factor, safety, reserve=reserve, error=error)
