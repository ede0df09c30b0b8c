"""Checks of the contact of pin and hole: pressure, shakedown, first yield, width."""

from collections.abc import Callable
from functools import partial
from typing import Any

from core.checks.check import Check, judged, not_checked
from core.checks.crank_design import CrankDesign
from core.checks.design.contact import force_factor
from core.checks.design.given import Body
from core.derived import UNKNOWN, if_known
from core.errors import NotKnown
from core.hertz import HALF_WIDTH_RATIO_LIMIT, HertzContact
from core.materials import ElasticMaterial
from core.output.limit_torque import limit_torque
from core.output.sampled_turn import WAYS


def _material(design: CrankDesign, body: Body) -> ElasticMaterial:
    material = design.lasting[body]
    assert material is not None
    return material


def _missing(design: CrankDesign, body: Body, value: str) -> tuple[str, ...]:
    """What would have to be given: a value of an own material, or another material."""
    name = f"{body}_material"
    return (f"{name}.{value}",) if name in design.own_limits else (name,)


def _against(design: CrankDesign, code: str, warning: str = "", **more: Any) -> Check:
    """The governing pressure against its limit."""
    limit = design.pressure_limits[code]
    try:
        contact = design.contact
    except UNKNOWN as why:
        return not_checked(code, why, limit=limit, **more)
    pressure = contact.governing_pressure
    if pressure is None:
        ratio = {"ratio": float(contact.half_width_ratio)}
        beyond = NotKnown("hertz_impossible")
        return not_checked(code, beyond, limit=limit, params=ratio, **more)
    return judged(
        code,
        pressure,
        limit,
        reserve=design.contact_reserves[code],
        warning=warning,
        error=(contact.conformal_error or 0.0) + 8 * contact.accuracy.relative_error,
        at=design.peak,
        rough=design.as_made and design.edge is not None,
        **more,
    )


def real_reserve(*, design: CrankDesign, limit: float) -> float:
    """Factor on the torque at which the pressure of the mechanism as it is made is at a limit,
    without its forces under the torque.

    Parameters
    ----------
    design : CrankDesign
        A design whose `real` is known.
    limit : float
        The limit, Pa.

    Returns
    -------
    float
    """
    real, torque = design.real, design.output_torque
    assert torque is not None

    def contact(force: float) -> HertzContact:
        found = real.contact(0, force)
        assert found is not None
        return found

    start = float((limit / contact(1.0).max_pressure) ** 2)  # N
    force = start * force_factor(
        contact=contact(start), contact_at=lambda factor: contact(start * factor), limit=limit
    )
    torques = [
        limit_torque(real=real, direction=way, pair=0, force=force)
        for way in WAYS[design.torque_direction]
    ]
    return min(torques) / (torque * design.dynamic_factor)


def _pressure(design: CrankDesign, body: Body) -> Check:
    code, limit = f"contact_pressure_{body}", _material(design, body).limit
    if limit is None:
        contact = if_known(lambda: design.contact)
        return Check(
            code=code,
            status="not_checked",
            value=contact and contact.governing_pressure,
            reason="limit_unknown",
            at=if_known(lambda: design.peak) or {},
            missing=_missing(design, body, "allowable_pressure"),
        )
    reason, missing = "life_of_teeth", tuple[str, ...]()
    if limit.curve is None:
        reason = "no_life_curve"
    elif limit.loads is None:
        reason, missing = "life_without_speed", ("input_speed",)
    found = _against(
        design,
        code,
        limit_source=limit.source,
        criterion=limit.criterion,
        verified=limit.verified or "",
        life_factor=limit.life_factor,
    )
    return found if found.reason else found._replace(reason=reason, missing=missing)


def _plastic(design: CrankDesign, code: str, body: Body, warning: str = "") -> Check:
    """The pressure against one by the yield strength, where that governs."""
    material = _material(design, body)
    if not material.yield_governs:
        return Check(code=code, status="not_applicable", reason="tested_limit")
    if material.yield_strength is None:
        own = f"{body}_material" in design.own_limits
        return Check(
            code=code,
            status="not_asked" if own else "not_checked",
            reason="yield_unknown",
            missing=_missing(design, body, "yield_strength"),
        )
    return _against(design, code, warning=warning)


def _shakedown(design: CrankDesign, body: Body) -> Check:
    return _plastic(design, f"contact_shakedown_{body}", body)


def _yield(design: CrankDesign, body: Body) -> Check:
    return _plastic(design, f"contact_yield_{body}", body, "plastic_first")


def _conformity(design: CrankDesign) -> Check:
    contact, code = design.contact, "contact_conformity"
    ratio, limit = float(contact.half_width_ratio), HALF_WIDTH_RATIO_LIMIT
    if contact.conformal_pressure is not None:
        why = "conformal_solution"
        return Check(code=code, status="not_applicable", value=ratio, limit=limit, reason=why)
    reserve = design.contact_reserves[code]
    return judged(code, ratio, limit, reserve=reserve, warning="rough_guide")


def life_considered(*, design: CrankDesign, body: Body) -> bool:
    """Whether the limit of the pressure of a body, if one is known, is that over the life.

    Parameters
    ----------
    design : CrankDesign
        The design.
    body : {"pin", "hole"}
        Whose surface.

    Returns
    -------
    bool
    """
    limit = _material(design, body).limit
    return limit is None or limit.life_factor is not None


CONTACT: dict[str, Callable[[CrankDesign], Check]] = {
    "contact_pressure_pin": partial(_pressure, body="pin"),
    "contact_pressure_hole": partial(_pressure, body="hole"),
    "contact_shakedown_pin": partial(_shakedown, body="pin"),
    "contact_shakedown_hole": partial(_shakedown, body="hole"),
    "contact_yield_pin": partial(_yield, body="pin"),
    "contact_yield_hole": partial(_yield, body="hole"),
    "contact_conformity": _conformity,
}
"""Checks of the contact under the load, by code."""
