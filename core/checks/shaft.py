"""Checks of a precessional gear and its shaft: room, deflection, slope."""

import math
from collections.abc import Iterable, Sequence
from itertools import pairwise

from core.checks.check import Check, Verdict, judged, verdict, wall
from core.precession.shaft_deflection import ShaftDeflection


def shaft_checks(
    *,
    result: ShaftDeflection,
    positions: Sequence[float],
    roller_circle_radius: float,
    roller_radius: float,
    diameters: Iterable[float],
    max_deflection: float | None = None,
    max_slope: float | None = None,
) -> Verdict:
    """All checks of a precessional gear and its shaft.

    Parameters
    ----------
    result : ShaftDeflection
        The shaft's deflection and slope.
    positions : sequence of float
        Position angles of the wheel's rollers, rad; the same one twice is one roller.
    roller_circle_radius, roller_radius : float
        Radii R_C of the circle of the rollers and rho of a roller, m.
    diameters : iterable of float
        Diameters of the shaft, m.
    max_deflection, max_slope : float, optional
        Largest deflection, m, and slope, rad, that are asked for.

    Returns
    -------
    Verdict
    """
    turn = 2 * math.pi
    places = sorted(angle % turn for angle in positions)
    apart = [after - before for before, after in pairwise([*places, places[0] + turn])]
    apart = [each for each in apart if 1e-9 < each < turn - 1e-9]
    if apart:
        pitch = 2 * roller_circle_radius * math.sin(min(apart) / 2)
        spacing = wall("line_spacing", width=pitch - 2 * roller_radius, size=roller_radius)
    else:
        spacing = Check(code="line_spacing", status="not_applicable", reason="one_only")
    room = roller_circle_radius - roller_radius - max(diameters) / 2
    deflection = max(result.deflection_B.total, result.deflection_C.total)
    slope = max(result.slope_B.total, result.slope_C.total)
    error = float(result.accuracy.relative_error)
    limits = {"deflection": max_deflection, "slope": max_slope}
    unasked = [name for name, limit in limits.items() if limit is None]
    return verdict(
        [
            spacing,
            wall("shaft_in_circle", width=room, size=roller_radius),
            _asked("shaft_deflection", deflection, max_deflection, "max_deflection", error),
            _asked("shaft_slope", slope, max_slope, "max_slope", error),
        ],
        (*unasked, "line_pressure", "shaft_strength", "bearing", "friction"),
    )


def _asked(code: str, value: float, limit: float | None, name: str, error: float) -> Check:
    """A value that grows with the torque against a limit that the user may ask."""
    if limit is None:
        return Check(code=code, status="not_asked", value=value, reason="no_limit", missing=(name,))
    reserve = limit / value if value > 0 else None
    return judged(code, value, limit, reserve=reserve, error=4 * error)
