"""Checks of the contact of pin and hole: pressure, shakedown, first yield, width."""

from functools import partial
from typing import Any

from core.checks.check import Check, judged, not_checked
from core.checks.design_check import Judge
from core.derived import UNKNOWN, if_known
from core.design.document import Body, Design
from core.design.results import Results
from core.errors import NotKnown
from core.hertz import HALF_WIDTH_RATIO_LIMIT


def _missing(design: Design, body: Body, value: str) -> tuple[str, ...]:
    """What would have to be given: a value of an own material, or another material."""
    name = f"{body}_material"
    own = name in design.contact.own_limits
    return (f"contact.{name}.{value}",) if own else (f"contact.{name}",)


def _against(design: Design, results: Results, code: str, warning: str = "", **more: Any) -> Check:
    """The governing pressure against its limit."""
    limit = results.pressure_limits[code]
    try:
        contact = results.hertz
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
        reserve=results.contact_reserves[code],
        warning=warning,
        error=(contact.conformal_error or 0.0) + 8 * contact.accuracy.relative_error,
        at=results.peak,
        rough=results.solved or results.edge is not None,
        **more,
    )


def _pressure(design: Design, results: Results, body: Body) -> Check:
    code, limit = f"contact_pressure_{body}", design.lasting[body].limit
    if limit is None:
        contact = if_known(lambda: results.hertz)
        return Check(
            code=code,
            status="not_checked",
            value=contact and contact.governing_pressure,
            reason="limit_unknown",
            at=if_known(lambda: results.peak) or {},
            missing=_missing(design, body, "allowable_pressure"),
        )
    reason, missing = "life_of_teeth", tuple[str, ...]()
    if limit.curve is None:
        reason = "no_life_curve"
    elif limit.loads is None:
        reason, missing = "life_without_speed", ("load.input_speed",)
    found = _against(
        design,
        results,
        code,
        limit_source=limit.source,
        criterion=limit.criterion,
        verified=limit.verified or "",
        life_factor=limit.life_factor,
    )
    return found if found.reason else found._replace(reason=reason, missing=missing)


def _plastic(design: Design, results: Results, code: str, body: Body, warning: str = "") -> Check:
    """The pressure against one by the yield strength, where that governs."""
    material = design.lasting[body]
    if not material.yield_governs:
        return Check(code=code, status="not_applicable", reason="tested_limit")
    if material.yield_strength is None:
        own = f"{body}_material" in design.contact.own_limits
        return Check(
            code=code,
            status="not_asked" if own else "not_checked",
            reason="yield_unknown",
            missing=_missing(design, body, "yield_strength"),
        )
    return _against(design, results, code, warning=warning)


def _shakedown(design: Design, results: Results, body: Body) -> Check:
    return _plastic(design, results, f"contact_shakedown_{body}", body)


def _yield(design: Design, results: Results, body: Body) -> Check:
    return _plastic(design, results, f"contact_yield_{body}", body, "plastic_first")


def _conformity(design: Design, results: Results) -> Check:
    contact, code = results.hertz, "contact_conformity"
    ratio, limit = float(contact.half_width_ratio), HALF_WIDTH_RATIO_LIMIT
    if contact.conformal_pressure is not None:
        why = "conformal_solution"
        return Check(code=code, status="not_applicable", value=ratio, limit=limit, reason=why)
    reserve = results.contact_reserves[code]
    rough = results.solved or results.edge is not None
    return judged(code, ratio, limit, reserve=reserve, warning="rough_guide", rough=rough)


def life_considered(*, design: Design, body: Body) -> bool:
    """Whether the limit of the pressure of a body, if one is known, is that over the life.

    Parameters
    ----------
    design : Design
        The design.
    body : {"pin", "hole"}
        Whose surface.

    Returns
    -------
    bool
    """
    limit = design.lasting[body].limit
    return limit is None or limit.life_factor is not None


CONTACT: dict[str, Judge] = {
    "contact_pressure_pin": partial(_pressure, body="pin"),
    "contact_pressure_hole": partial(_pressure, body="hole"),
    "contact_shakedown_pin": partial(_shakedown, body="pin"),
    "contact_shakedown_hole": partial(_shakedown, body="hole"),
    "contact_yield_pin": partial(_yield, body="pin"),
    "contact_yield_hole": partial(_yield, body="hole"),
    "contact_conformity": _conformity,
}
"""Checks of the contact under the load, by code."""
