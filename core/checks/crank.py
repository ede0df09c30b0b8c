"""Checks of the crank: bearings of the satellites, ring, crankshaft."""

import math
from collections.abc import Callable
from functools import partial
from typing import TypeVar

import numpy as np

from core.arrays import FloatArray
from core.checks.check import Check, Measure, asked, attempt, judged, wall
from core.checks.design_check import Judge
from core.crank.bearing_life import EXPONENTS, STATIC_SAFETY, system_life
from core.crank.ring_mesh import STEEP
from core.crank.satellite_bearing import SatelliteBearings
from core.derived import if_known
from core.design.document import Design
from core.design.results import Results
from core.design.sections import RollingBearing
from core.errors import NotKnown

Value = TypeVar("Value")


def against(code: str, limit: Callable[[Design], float | None]) -> Callable[[Judge], Judge]:
    """A check that says its limit where it could not be made, too.

    Parameters
    ----------
    code : str
        Which.
    limit : callable
        Its limit, of a design.

    Returns
    -------
    callable
        Decorator of the check.
    """
    return lambda judge: (
        lambda design, results: attempt(code, partial(judge, design, results), limit=limit(design))
    )


def _required(value: Value | None, name: str) -> Value:
    """A number of bearings, which needs a load rating, and of a life a speed."""
    if value is None:
        raise NotKnown("rating_unknown", name)
    return value


def _lives(found: SatelliteBearings, bearing: RollingBearing) -> FloatArray:
    """Lives of the bearings."""
    _required(bearing.dynamic_rating, "bearing.dynamic_rating")
    if found.life is None:
        raise NotKnown("speed_missing", "load.input_speed")
    return found.life


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


def _equivalent(results: Results) -> float:
    """Centrifugal force of a satellite as an equivalent load has it: by the ring that turns, N."""
    return float(results.design.bearing.ring_factor) * results.centrifugal


def _required_life(design: Design) -> float:
    return design.requirements.life


@against("bearing_life", _required_life)
def _life(design: Design, results: Results) -> Check:
    found, limit = results.satellite_bearing, design.requirements.life
    lives, power = _lives(found, design.bearing), EXPONENTS[design.bearing.kind]
    worst = int(np.argmin(lives))
    value = float(lives[worst])
    return judged(
        "bearing_life",
        value,
        limit,
        reserve=(value / limit) ** (1 / power),
        error=4 * power * float(found.accuracy.relative_error)
        + _left_out(
            _equivalent(results),
            float(found.equivalent_load[worst]),
            short=value < limit,
            of=lambda load: load**-power,
        ),
        rough=results.solved,
        at={"satellite": worst + 1},
    )


def _required_safety(design: Design) -> float:
    return design.requirements.static_safety or STATIC_SAFETY[design.bearing.kind]


@against("bearing_static", _required_safety)
def _static(design: Design, results: Results) -> Check:
    found, limit = results.satellite_bearing, _required_safety(design)
    rating = _required(design.bearing.static_rating, "bearing.static_rating")
    safety = np.asarray(found.static_safety_factor)
    worst = int(np.argmin(safety))
    value, error = float(safety[worst]), float(found.accuracy.relative_error)
    return judged(
        "bearing_static",
        value,
        limit,
        reserve=value / limit,
        error=4 * error
        + _left_out(
            results.centrifugal,
            rating / value,
            short=value < limit,
            of=lambda load: 1 / load,
        ),
        rough=results.solved,
        limit_source="" if design.requirements.static_safety else "static_guide",
        at={"satellite": worst + 1},
    )


@against("system_life", _required_life)
def _system(design: Design, results: Results) -> Check:
    code, limit = "system_life", design.requirements.life
    if design.mechanism.satellites == 1:
        return Check(code=code, status="not_applicable", reason="one_only")
    if design.bearing.weibull_slope is None:
        return Check(code=code, status="not_asked", missing=("bearing.weibull_slope",))
    found, slope = results.satellite_bearing, design.bearing.weibull_slope
    lives, power = _lives(found, design.bearing), EXPONENTS[design.bearing.kind]
    value = float(system_life(lives=lives, weibull_slope=slope))
    error = 4 * power * float(found.accuracy.relative_error)

    def lasting(loads: FloatArray) -> FloatArray:
        return np.asarray(system_life(lives=loads**-power, weibull_slope=slope))

    error += _left_out(_equivalent(results), found.equivalent_load, short=value < limit, of=lasting)

    reserve = (value / limit) ** (1 / power)
    return judged(code, value, limit, reserve=reserve, error=error, rough=results.solved)


def _pressure_angle(design: Design, results: Results) -> Check:
    code = "pressure_angle"
    if_known(lambda: results.ring_mesh)  # a ring that cannot be is refused, of whatever kind
    if design.gear and design.gear.kind != "involute":
        return Check(code=code, status="not_applicable", reason="no_involute")
    angle = results.ring_mesh.operating_pressure_angle
    assert angle is not None  # of an involute
    return judged(code, float(angle), STEEP, warning="steep_mesh")


def within_roots(*, design: Design, code: str, least: float | None = None) -> Check:
    """The wall between the holes and the roots of the satellite's teeth: it passes by the least
    radius of these, fails by the largest, and is not known between.

    Parameters
    ----------
    design : Design
        The design.
    code : str
        Which check.
    least : float, optional
        Least width that is asked, m.

    Returns
    -------
    Check
    """
    size = design.contact.pair.hole_radius
    reach = design.load.pin_circle_radius + size
    known = design.satellite_body and design.satellite_body.root_radius
    source = "roots" if design.gear and not known else ""
    shallow, deep = (
        wall(code, width=radius - reach, size=size, least=least)._replace(limit_source=source)
        for radius in reversed(design.roots)
    )
    if deep.status != "fail":
        return deep
    if shallow.status == "fail":
        return shallow
    cycloid = design.gear and design.gear.kind == "cycloid"
    if cycloid and design.contact.eccentricity is None:
        raise NotKnown("eccentricity_assumed", "contact.eccentricity")
    name = "gear.ring_pin_radius" if cycloid else "satellite_body.root_radius"
    return Check(
        code=code, status="not_checked", limit=deep.limit, reason="roots_unknown", missing=(name,)
    )


def _gear_room(design: Design, results: Results) -> Check:
    if design.gear.kind not in ("involute", "cycloid"):
        return Check(code="gear_room", status="not_applicable", reason="no_teeth")
    return within_roots(design=design, code="gear_room")


@against("crank_bearing_life", _required_life)
def _shaft_life(design: Design, results: Results) -> Check:
    code, limit = "crank_bearing_life", design.requirements.life
    bearings = design.crankshaft.bearings
    if bearings is None:
        return Check(code=code, status="not_asked", missing=("crankshaft.bearings",))
    for each in bearings:
        _required(each.dynamic_rating, "crankshaft.bearings")
    found = results.crankshaft
    lives = [math.inf if each is None else each for each in found.basic_life]
    if math.isinf(min(lives)):
        return Check(code=code, status="not_applicable", limit=limit, reason="unloaded")
    powers = [EXPONENTS[each.kind] for each in bearings]
    value, worst = min(zip(lives, (1, 2), strict=True))
    reserves = [(life / limit) ** (1 / power) for life, power in zip(lives, powers, strict=True)]

    def lasting(power: float) -> Callable[[FloatArray], FloatArray]:
        return lambda load: load**-power

    left_out = 0.0
    if found.balance is not None:  # what balances the satellites is what presses the bearings
        speed = design.known_speed
        left_out = max(
            _left_out(each.unbalance * speed**2, load, short=value < limit, of=lasting(power))
            for each, load, power in zip(
                found.balance.corrections, found.equivalent_reaction.tolist(), powers, strict=True
            )
            if load
        )

    return judged(
        code,
        value,
        limit,
        reserve=min(reserves),
        error=4 * max(powers) * float(found.accuracy.relative_error) + left_out,
        rough=results.solved,
        at={"bearing": worst},
    )


def _balance(design: Design, results: Results, code: str, limit: float | None, name: str) -> Check:
    """What is left of the satellites' centrifugal forces against what is asked."""

    def left() -> Measure:
        shaft, made = design.crankshaft, design.deviations
        if shaft.satellite_mass is None:
            raise NotKnown("mass_unknown", "crankshaft.satellite_mass")
        if made is not None and any((*made.eccentricity, *made.crank_phase)):
            raise NotKnown("cranks_deviate")
        balance = results.crankshaft.balance
        assert balance is not None  # of a mass that is known
        return Measure(getattr(balance, code.removeprefix("unbalance_")))

    return asked(code, limit, left, name=name)


def _unbalance_force(design: Design, results: Results) -> Check:
    return _balance(
        design, results, "unbalance_force", design.requirements.max_unbalance, "max_unbalance"
    )


def _unbalance_couple(design: Design, results: Results) -> Check:
    limit, name = design.requirements.max_unbalance_couple, "max_unbalance_couple"
    return _balance(design, results, "unbalance_couple", limit, name)


BEARING: dict[str, Judge] = {
    "bearing_life": _life,
    "bearing_static": _static,
    "system_life": _system,
}
"""Checks of the satellites' bearings, by code."""

GEAR: dict[str, Judge] = {
    "pressure_angle": _pressure_angle,
    "gear_room": _gear_room,
}
"""Checks of the ring against the satellite, by code."""

SHAFT: dict[str, Judge] = {
    "crank_bearing_life": _shaft_life,
    "unbalance_force": _unbalance_force,
    "unbalance_couple": _unbalance_couple,
}
"""Checks of the crankshaft, by code."""
