"""Checks of a precessional gear and its shaft: room, deflection, slope."""

import math
from collections.abc import Iterable, Sequence
from itertools import pairwise

from core.checks.check import Check, Measure, Verdict, asked, judged, verdict, wall
from core.checks.rollers import fatigue_check
from core.precession.line_contact import LineContact
from core.precession.shaft_deflection import ShaftDeflection
from core.precession.shaft_strength import ShaftStrength
from core.results import Notice


def shaft_checks(
    *,
    result: ShaftDeflection,
    positions: Sequence[float],
    roller_circle_radius: float,
    roller_radius: float,
    diameters: Iterable[float],
    max_deflection: float | None = None,
    max_slope: float | None = None,
    strength: ShaftStrength | None = None,
    yield_strength: float | None = None,
    fatigue_asked: bool = False,
    no_fatigue: Notice | None = None,
    bending_safety: float = 1.5,
    fatigue_safety: float = 1.5,
    contact: LineContact | None = None,
    pressure_limits: Sequence[float | None] = (None, None),
    pitting_safety: float = 1.2,
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
    strength : ShaftStrength, optional
        Its bending strength, where that is asked.
    yield_strength : float, optional
        Yield strength of the shaft, Pa.
    fatigue_asked : bool
        Whether its fatigue is asked; without a cycle in `strength` the load is steady.
    no_fatigue : Notice, optional
        Why that is not known.
    bending_safety, fatigue_safety : float
        Required safety against yield and in fatigue.
    contact : LineContact, optional
        Pressure along the contact lines, where the curvature of the teeth is given.
    pressure_limits : sequence of float or None
        Limits of the pressure of roller and tooth, Pa.
    pitting_safety : float
        Required safety against pitting.

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

    def beyond(code: str, value: float, limit: float | None) -> Check:
        measure = Measure(value, error=4 * error, reserve=float)
        return asked(code, limit, lambda: measure, name=code.replace("shaft", "max"))

    limits = {"deflection": max_deflection, "slope": max_slope}
    unasked = [name for name, limit in limits.items() if limit is None]
    more, left = [], []
    if strength is not None:
        more.append(_static(strength, yield_strength, bending_safety, error))
        if fatigue_asked:
            more.append(_fatigue(strength, no_fatigue, fatigue_safety, error))
    if contact is not None:
        more.append(_pressure(contact, pressure_limits, pitting_safety))
    else:
        left.append("line_pressure")
    if strength is None:
        left.append("shaft_strength")
    elif not fatigue_asked:
        left.append("fatigue")
    return verdict(
        [
            spacing,
            wall("shaft_in_circle", width=room, size=roller_radius),
            beyond("shaft_deflection", deflection, max_deflection),
            beyond("shaft_slope", slope, max_slope),
            *more,
        ],
        (*unasked, *left, "bearing", "friction"),
    )


def _static(
    strength: ShaftStrength, yield_strength: float | None, safety: float, error: float
) -> Check:
    """Bending stress against the yield strength."""
    code, stress = "shaft_static", strength.peak_stress
    if yield_strength is None:
        return Check(
            code=code,
            status="not_checked",
            value=stress,
            reason="yield_unknown",
            missing=("yield_strength",),
        )
    limit = yield_strength / safety
    reserve = limit / stress if stress > 0 else None
    return judged(code, stress, limit, reserve=reserve, error=4 * error)


def _fatigue(strength: ShaftStrength, unknown: Notice | None, safety: float, error: float) -> Check:
    """Its reversed bending; a load that turns with the shaft bends it one way."""
    code, cycle = "shaft_fatigue", strength.fatigue
    fatigue = unknown or cycle
    if fatigue is None:
        return Check(code=code, status="not_applicable", reason="steady_load")
    reserve = None if isinstance(fatigue, Notice) else fatigue.safety_factor / safety
    return fatigue_check(
        code=code, fatigue=fatigue, safety=safety, reserve=reserve, error=4 * error
    )


def _pressure(contact: LineContact, limits: Sequence[float | None], safety: float) -> Check:
    """The pressure along the lines against the lower of both limits, where both are known."""
    code, pressure = "line_pressure", contact.max_pressure
    bodies = ("line_contact.roller_material", "line_contact.mating_material")
    missing = tuple(name for name, each in zip(bodies, limits, strict=True) if each is None)
    error = float(contact.accuracy.relative_error)
    limit = min((each for each in limits if each is not None), default=math.inf) / safety
    found = judged(code, pressure, limit, reserve=(limit / pressure) ** 2, error=4 * error)
    if missing and found.status != "fail":
        return Check(
            code=code,
            status="not_checked",
            value=pressure,
            reason="limit_unknown",
            missing=missing,
        )
    return found
