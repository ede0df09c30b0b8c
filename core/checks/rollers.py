"""Checks of swinging rollers: stress, load sharing, room, tilt."""

import math
from collections.abc import Sequence

from core.checks.check import Check, Verdict, judged, verdict, wall
from core.rollers.roller_strength import RollerStrength, roller_gaps

ROLLER_LENGTH = 10.0
"""Least length of a swinging roller's cylinder over the eccentricity."""


def roller_checks(
    *,
    result: RollerStrength,
    output_torque: float,
    hole_circle_radius: float,
    rollers: int,
    sphere_diameter: float,
    cylinder_length: float,
    position_tolerance: float | None = None,
    gaps: Sequence[float] | None = None,
    yield_strength: float | None = None,
    eccentricity: float | None = None,
    bending_safety: float = 1.5,
) -> Verdict:
    """All checks of swinging rollers.

    Parameters
    ----------
    result : RollerStrength
        Their load sharing and strength.
    output_torque, hole_circle_radius, rollers, sphere_diameter, cylinder_length : as there
        What they were calculated for.
    position_tolerance, gaps : as there
        One of them.
    yield_strength : float, optional
        Yield strength of the rollers, Pa.
    eccentricity : float, optional
        Eccentricity of the crank, m.
    bending_safety : float
        Required safety against yield.

    Returns
    -------
    Verdict
    """
    stress = float(result.bending_stress)
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
        # F_i = c*max(0, Delta - g_i): what the rollers carry when the first is at its limit
        largest = float(result.max_force) * limit / stress
        ahead = roller_gaps(rollers=rollers, position_tolerance=position_tolerance, gaps=gaps)
        first = min(ahead)
        carried = math.fsum(
            max(0.0, largest - float(result.stiffness) * (gap - first)) for gap in ahead
        )
        strength = judged(
            "roller_stress",
            stress,
            limit,
            reserve=2 * hole_circle_radius * carried / output_torque,
            error=4 * float(result.accuracy.relative_error),
        )
    sharing = judged(
        "roller_sharing",
        float(result.loaded_rollers),
        float(rollers),
        keep="above",
        warning="uneven",
        error=0.0,
    )
    if rollers > 1:
        pitch = 2 * hole_circle_radius * math.sin(math.pi / rollers)
        spacing = wall("roller_spacing", width=pitch - sphere_diameter, size=sphere_diameter)
    else:
        spacing = Check(code="roller_spacing", status="not_applicable", reason="one_only")
    room = hole_circle_radius - sphere_diameter / 2
    if eccentricity is None:
        tilt = Check(
            code="roller_tilt", status="not_asked", value=cylinder_length, missing=("eccentricity",)
        )
    else:
        tilt = judged("roller_tilt", cylinder_length, ROLLER_LENGTH * eccentricity, keep="above")
    return verdict(
        [strength, sharing, spacing, wall("roller_room", width=room, size=sphere_diameter), tilt],
        ("roller_contact", "fatigue", "friction"),
    )
