"""Checks of the contact of pin and hole: pressure, shakedown, first yield, width."""

import math
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from typing import Any, Literal

from core.checks.check import Check, judged
from core.checks.crank_design import CrankDesign
from core.exploration.solve import edge
from core.hertz import HALF_WIDTH_RATIO_LIMIT, HertzContact
from core.materials import ElasticMaterial

FIRST_YIELD = 1.79
"""Largest pressure at first yield below the surface over the yield strength (Mises, v = 0.3)."""

SHAKEDOWN = 4 / math.sqrt(3)
"""Largest pressure of elastic shakedown over the yield strength: the largest orthogonal shear, a
quarter of it, is the shear yield strength ``Re/sqrt(3)``."""

Body = Literal["pin", "hole"]


def _material(design: CrankDesign, body: Body) -> ElasticMaterial:
    material = design.pin_material if body == "pin" else design.hole_material
    assert material is not None
    return material


def _missing(design: CrankDesign, body: Body, value: str) -> tuple[str, ...]:
    """What would have to be given: a value of an own material, or another material."""
    name = f"{body}_material"
    return (f"{name}.{value}",) if name in design.own_limits else (name,)


def _against(design: CrankDesign, code: str, limit: float, warning: str = "", **more: Any) -> Check:
    """The governing pressure against a limit."""
    contact = design.contact
    pressure = None if contact is None else contact.governing_pressure
    if contact is None or pressure is None:
        reason = "dead_centre" if contact is None else "no_pressure"
        return Check(code=code, status="not_checked", limit=limit, reason=reason, **more)
    found = judged(
        code,
        pressure,
        limit,
        reserve=_reserve(design, contact, pressure, limit),
        warning=warning,
        error=(contact.conformal_error or 0.0) + 8 * contact.accuracy.relative_error,
        at=design.peak,
        **more,
    )
    return _unless_clearance(design, found)


def _unless_clearance(design: CrankDesign, found: Check) -> Check:
    """A check under the forces without clearance: with it fewer pairs carry, each more, so that
    only what fails is known, and not by how much.
    """
    if not (design.clearance or 0.0) > 0:
        return found
    if found.status == "fail":
        return replace(found, torque_reserve=None)
    unknown: dict[str, Any] = dict.fromkeys(("value", "utilisation", "torque_reserve"))
    return replace(found, status="not_checked", reason="force_law", at={}, **unknown)


def _reserve(design: CrankDesign, contact: HertzContact, pressure: float, limit: float) -> float:
    """Factor on the torque at which the governing pressure is at a limit, Pa.

    Hertz's pressure grows with the root of the torque, Persson's faster, up to the torque itself;
    where Persson's takes over, the governing pressure jumps by a per cent.
    """
    by_hertz = float((limit / contact.max_pressure) ** 2)
    if design.contact_at(by_hertz).conformal_pressure is None:
        # where no theory holds any more, that is the end
        return min(by_hertz, float(contact.half_width_ratio**-2))

    def left(factor: float) -> float:
        there = design.contact_at(factor).governing_pressure
        return math.nan if there is None else float(limit - there)

    ratio = limit / pressure
    met, _ = edge(
        inside=0.97 * min(ratio, ratio * ratio),
        outside=1.03 * max(ratio, ratio * ratio),
        excess=left,
    )
    return met


def _pressure(design: CrankDesign, body: Body) -> Check:
    code, limit = f"contact_pressure_{body}", _material(design, body).limit
    if limit is None:
        return Check(
            code=code,
            status="not_checked",
            value=None if design.contact is None else design.contact.governing_pressure,
            reason="limit_unknown",
            at=design.peak,
            missing=_missing(design, body, "allowable_pressure"),
        )
    return _against(
        design,
        code,
        float(limit.pressure) / design.pitting_safety,
        limit_source=limit.source,
        criterion=limit.criterion,
        verified=limit.verified or "",
    )


def _plastic(design: CrankDesign, code: str, body: Body, ratio: float, warning: str = "") -> Check:
    """The pressure against so many times the yield strength, where that governs."""
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
    return _against(design, code, ratio * material.yield_strength, warning=warning)


def _shakedown(design: CrankDesign, body: Body) -> Check:
    return _plastic(design, f"contact_shakedown_{body}", body, SHAKEDOWN)


def _yield(design: CrankDesign, body: Body) -> Check:
    return _plastic(design, f"contact_yield_{body}", body, FIRST_YIELD, "plastic_first")


def _conformity(design: CrankDesign) -> Check:
    contact, code = design.contact, "contact_conformity"
    if contact is None:
        return Check(code=code, status="not_checked", reason="dead_centre")
    ratio, limit = float(contact.half_width_ratio), HALF_WIDTH_RATIO_LIMIT
    if contact.conformal_pressure is not None:
        why = "conformal_solution"
        return Check(code=code, status="not_applicable", value=ratio, limit=limit, reason=why)
    found = judged(code, ratio, limit, reserve=(limit / ratio) ** 2, warning="rough_guide")
    return _unless_clearance(design, found)


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
