"""Checks of the crank: bearings of the satellites, ring, crankshaft."""

import math
from collections.abc import Callable

import numpy as np

from core.arrays import FloatArray
from core.checks.check import Check, asked, judged, wall
from core.checks.crank_design import CrankDesign
from core.checks.play import no_eccentricity
from core.checks.sections import RollingBearing
from core.crank.bearing_life import EXPONENTS, STATIC_SAFETY, system_life
from core.crank.crankshaft import Crankshaft
from core.crank.ring_mesh import STEEP
from core.crank.satellite_bearing import SatelliteBearings


def _unknown(
    design: CrankDesign, code: str, found: object, limit: float | None, section: str
) -> Check:
    """A check whose loads are not known: why, and what is missing."""
    if getattr(design, section) is None or design.gear is None:
        missing: tuple[str, ...] = (section if getattr(design, section) is None else "gear",)
        reason = "section_missing"
    else:
        reason, missing = design.unturned(found, speed=section != "bearing")
    return Check(code=code, status="not_checked", limit=limit, reason=reason, missing=missing)


def _rating(code: str, limit: float, name: str) -> Check:
    """A check that needs a load rating."""
    missing = (name,)
    return Check(
        code=code, status="not_checked", limit=limit, reason="rating_unknown", missing=missing
    )


def _no_life(design: CrankDesign, code: str, limit: float, bearing: RollingBearing) -> Check:
    """A life that is not known: without a rating, or without a speed."""
    if bearing.dynamic_rating is None:
        return _rating(code, limit, "bearing.dynamic_rating")
    reason, missing = design.unturned(None)
    return Check(code=code, status="not_checked", limit=limit, reason=reason, missing=missing)


def _left_out(
    force: float,
    load: float | FloatArray,
    *,
    short: bool,
    of: Callable[[FloatArray], FloatArray],
) -> float:
    """Relative error of a number of bearings, as of a life, by a force that their loads leave out,
    whatever its direction: with it a load is at most their sum and, which counts where the number
    is too small, at least their difference.
    """
    loads = np.asarray(load)
    with np.errstate(divide="ignore"):  # without a load a bearing lasts for ever
        moved = float(of(np.abs(loads - force) if short else loads + force) / of(loads))
    return max(moved - 1, 0.0) if short else 1 - moved


def _equivalent(design: CrankDesign) -> float:
    """Centrifugal force of a satellite as an equivalent load has it: by the ring that turns, N."""
    assert design.bearing is not None
    return float(design.bearing.ring_factor) * design.centrifugal


def _life(design: CrankDesign) -> Check:
    code, limit, found = "bearing_life", design.life, design.bearings
    if not isinstance(found, SatelliteBearings):
        return _unknown(design, code, found, limit, "bearing")
    assert design.bearing is not None
    if found.life is None:
        return _no_life(design, code, limit, design.bearing)
    worst, power = int(np.argmin(found.life)), EXPONENTS[design.bearing.kind]
    value = float(found.life[worst])
    return judged(
        code,
        value,
        limit,
        reserve=design.reserve(
            (value / limit) ** (1 / power),
            lambda factors: design.moved_loads(factors, power).max(axis=1),
        ),
        error=4 * power * float(found.accuracy.relative_error)
        + _left_out(
            _equivalent(design),
            float(found.equivalent_load[worst]),
            short=value < limit,
            of=lambda load: load**-power,
        ),
        rough=design.as_made,
        at={"satellite": worst + 1},
    )


def _static(design: CrankDesign) -> Check:
    code, limit, found = "bearing_static", design.static_safety, design.bearings
    source = ""
    if limit is None and design.bearing is not None:
        limit, source = STATIC_SAFETY[design.bearing.kind], "static_guide"
    if not isinstance(found, SatelliteBearings):
        return _unknown(design, code, found, limit, "bearing")
    assert limit is not None
    if found.static_safety_factor is None:
        return _rating(code, limit, "bearing.static_rating")
    worst = int(np.argmin(found.static_safety_factor))
    value, error = float(found.static_safety_factor[worst]), float(found.accuracy.relative_error)
    assert design.bearing is not None and design.bearing.static_rating is not None
    share = design.static_share
    return judged(
        code,
        value,
        limit,
        reserve=design.reserve(
            value / limit, lambda factors: design.moved_loads(factors * share).max(axis=1)
        ),
        error=4 * error
        + _left_out(
            design.centrifugal,
            design.bearing.static_rating / value,
            short=value < limit,
            of=lambda load: 1 / load,
        ),
        rough=design.as_made,
        limit_source=source,
        at={"satellite": worst + 1},
    )


def _system(design: CrankDesign) -> Check:
    code, limit, found = "system_life", design.life, design.bearings
    assert design.bearing is not None
    if design.satellites == 1:
        return Check(code=code, status="not_applicable", reason="one_only")
    if design.bearing.weibull_slope is None:
        return Check(code=code, status="not_asked", missing=("bearing.weibull_slope",))
    if not isinstance(found, SatelliteBearings):
        return _unknown(design, code, found, limit, "bearing")
    if found.system_life is None:
        return _no_life(design, code, limit, design.bearing)
    value, power = float(found.system_life), EXPONENTS[design.bearing.kind]
    error, slope = 4 * power * float(found.accuracy.relative_error), design.bearing.weibull_slope

    def lasting(loads: FloatArray) -> FloatArray:
        return np.asarray(system_life(lives=loads**-power, weibull_slope=slope))

    error += _left_out(_equivalent(design), found.equivalent_load, short=value < limit, of=lasting)

    def together(factors: FloatArray) -> FloatArray:
        return lasting(design.moved_loads(factors, power)) ** (-1 / power)

    reserve = design.reserve((value / limit) ** (1 / power), together)
    return judged(code, value, limit, reserve=reserve, error=error, rough=design.as_made)


def _pressure_angle(design: CrankDesign) -> Check:
    code, mesh = "pressure_angle", design.mesh
    if design.gear is not None and design.gear.kind != "involute":
        return Check(code=code, status="not_applicable", reason="no_involute")
    if mesh is None or mesh.operating_pressure_angle is None:
        return no_eccentricity(code)
    return judged(code, float(mesh.operating_pressure_angle), STEEP, warning="steep_mesh")


def within_roots(*, design: CrankDesign, code: str, least: float | None = None) -> Check:
    """The wall between the holes and the roots of the satellite's teeth: it passes by the least
    radius of these, fails by the largest, and is not known between.

    Parameters
    ----------
    design : CrankDesign
        The design.
    code : str
        Which check.
    least : float, optional
        Least width that is asked, m.

    Returns
    -------
    Check
    """
    assert design.pin_circle_radius is not None and design.hole_radius is not None
    reach, size = design.pin_circle_radius + design.hole_radius, design.hole_radius
    source = "roots" if design.root_radius is None and design.gear else ""
    shallow, deep = (
        wall(code, width=radius - reach, size=size, least=least)._replace(limit_source=source)
        for radius in reversed(design.roots)
    )
    if deep.status != "fail":
        return deep
    if shallow.status == "fail":
        return shallow
    cycloid = design.gear is not None and design.gear.kind == "cycloid"
    if cycloid and design.eccentricity is None:
        return no_eccentricity(code)
    name = "gear.ring_pin_radius" if cycloid else "satellite_body.root_radius"
    return Check(
        code=code, status="not_checked", limit=deep.limit, reason="roots_unknown", missing=(name,)
    )


def _gear_room(design: CrankDesign) -> Check:
    assert design.gear is not None
    if design.gear.kind not in ("involute", "cycloid"):
        return Check(code="gear_room", status="not_applicable", reason="no_teeth")
    return within_roots(design=design, code="gear_room")


def _shaft_life(design: CrankDesign) -> Check:
    code, limit, found = "crank_bearing_life", design.life, design.shaft
    assert design.crankshaft is not None
    bearings = design.crankshaft.bearings
    if bearings is None:
        return Check(code=code, status="not_asked", missing=("crankshaft.bearings",))
    if any(each.dynamic_rating is None for each in bearings):
        return _rating(code, limit, "crankshaft.bearings")
    if not isinstance(found, Crankshaft):
        return _unknown(design, code, found, limit, "crankshaft")
    lives = [math.inf if each is None else each for each in found.basic_life]
    if math.isinf(min(lives)):
        return Check(code=code, status="not_applicable", limit=limit, reason="unloaded")
    powers = [EXPONENTS[each.kind] for each in bearings]
    value, worst = min(zip(lives, (1, 2), strict=True))
    reserves = [(life / limit) ** (1 / power) for life, power in zip(lives, powers, strict=True)]
    loads = zip(found.equivalent_reaction.tolist(), reserves, strict=True)
    allowed = [load * reserve if load else math.inf for load, reserve in loads]

    def lasting(power: float) -> Callable[[FloatArray], FloatArray]:
        return lambda load: load**-power

    left_out = 0.0
    if found.balance is not None:  # what balances the satellites is what presses the bearings
        assert design.input_speed is not None
        speed = design.input_speed
        left_out = max(
            _left_out(each.unbalance * speed**2, load, short=value < limit, of=lasting(power))
            for each, load, power in zip(
                found.balance.corrections, found.equivalent_reaction.tolist(), powers, strict=True
            )
            if load
        )

    def used(factors: FloatArray) -> FloatArray:
        return np.asarray((design.moved_reactions(factors) / allowed).max(axis=1))

    return judged(
        code,
        value,
        limit,
        reserve=design.reserve(min(reserves), used),
        error=4 * max(powers) * float(found.accuracy.relative_error) + left_out,
        rough=design.as_made,
        at={"bearing": worst},
    )


def _balance(design: CrankDesign, code: str, limit: float | None, name: str) -> Check:
    """What is left of the satellites' centrifugal forces against what is asked."""
    found = design.shaft
    known = found.balance if isinstance(found, Crankshaft) else None
    made = design.deviations
    deviate = made is not None and any((*made.eccentricity, *made.crank_phase))
    if deviate:
        known = None
    value = None if known is None else getattr(known, code.removeprefix("unbalance_"))

    def unknown() -> Check:
        assert design.crankshaft is not None
        if design.crankshaft.satellite_mass is None:
            missing = ("crankshaft.satellite_mass",)
            return Check(
                code=code, status="not_checked", limit=limit, reason="mass_unknown", missing=missing
            )
        if deviate:
            return Check(code=code, status="not_checked", limit=limit, reason="cranks_deviate")
        return _unknown(design, code, found, limit, "crankshaft")

    return asked(code, value, limit, name=name, unknown=unknown)


def _unbalance_force(design: CrankDesign) -> Check:
    return _balance(design, "unbalance_force", design.max_unbalance, "max_unbalance")


def _unbalance_couple(design: CrankDesign) -> Check:
    name = "max_unbalance_couple"
    return _balance(design, "unbalance_couple", design.max_unbalance_couple, name)


BEARING: dict[str, Callable[[CrankDesign], Check]] = {
    "bearing_life": _life,
    "bearing_static": _static,
    "system_life": _system,
}
"""Checks of the satellites' bearings, by code."""

GEAR: dict[str, Callable[[CrankDesign], Check]] = {
    "pressure_angle": _pressure_angle,
    "gear_room": _gear_room,
}
"""Checks of the ring against the satellite, by code."""

SHAFT: dict[str, Callable[[CrankDesign], Check]] = {
    "crank_bearing_life": _shaft_life,
    "unbalance_force": _unbalance_force,
    "unbalance_couple": _unbalance_couple,
}
"""Checks of the crankshaft, by code."""
