"""Checks of the pins as beams: static strength, fatigue, deflection, slope."""

from collections.abc import Callable
from functools import partial

from core.checks.check import Check, Measure, asked, judged
from core.checks.crank_design import CrankDesign
from core.checks.design.pins import NEAR_CYCLE
from core.output.pin_fatigue import FatigueStrength
from core.output.pin_strength import PinStrength

HARDENED = 1400e6
"""Tensile strength above which a steel hardly yields before it breaks, Pa."""


def _of_size(design: CrankDesign, check: Check) -> Check:
    """A check by the strengths of the material: of thicker pins these are less than known, so that
    only what fails is certain, but not by how much.
    """
    if not design.size_notices:
        return check
    (thick,) = design.size_notices
    if check.status == "fail":
        return check._replace(torque_reserve=None)
    missing = ("pin.material",)
    return check._replace(
        status="not_checked",
        torque_reserve=None,
        reason=thick.code,
        params=thick.params,
        missing=missing,
    )


def _static(design: CrankDesign) -> Check:
    code, found = "pin_static", design.pin_strength
    assert design.pin is not None
    stress, tensile = found.static_stress, design.pin.tensile_strength
    strength = design.pin.material.yield_strength
    if strength is None and tensile is not None and tensile > HARDENED:
        strength = tensile
    if strength is None:
        missing = ("pin.material.yield_strength",)
        return Check(
            code=code, status="not_checked", value=stress, reason="yield_unknown", missing=missing
        )
    limit = strength / design.bending_safety
    error = 4 * found.accuracy.relative_error
    reserve = design.pin_reserve(
        limit / stress, lambda pins: pins.static_stress, share=design.static_share
    )
    check = judged(code, stress, limit, reserve=reserve, error=error, rough=design.as_made)
    return _of_size(design, check)


def _fatigue(design: CrankDesign) -> Check:
    code, found = "pin_fatigue", design.pin_strength
    assert design.pin is not None
    if found.fatigue is None:
        judged_by = design.fatigue_strength
        assert not isinstance(judged_by, FatigueStrength) and judged_by is not None
        reason = judged_by.code
        missing: tuple[str, ...] = ("fatigue.fatigue_notch_factor",)
        if reason == "endurance_unknown":
            missing = ("pin.material.tensile_strength",)
            if design.pin.tensile_strength is not None:
                missing = ("fatigue.endurance_limit",)
        assert design.fatigue is not None
        if design.fatigue.criterion == "soderberg" and design.pin.material.yield_strength is None:
            reason, missing = "yield_unknown", ("pin.material.yield_strength",)
        return Check(code=code, status="not_checked", reason=reason, missing=missing)
    safety, limit = found.fatigue.safety_factor, design.fatigue_safety
    error = 4 * found.accuracy.relative_error
    reserve = design.pin_reserve(safety / limit, _used, near=NEAR_CYCLE)
    check = judged(code, safety, limit, reserve=reserve, error=error, rough=design.as_made)
    lasts = found.fatigue.finite_strength is not None and not check.reason
    return _of_size(design, check._replace(reason="finite_life") if lasts else check)


def _used(pins: PinStrength) -> float:
    assert pins.fatigue is not None
    return 1 / pins.fatigue.safety_factor


def _bent(design: CrankDesign, code: str, limit: float | None) -> Check:
    """The largest deflection or slope against what is asked."""

    def bent(pins: PinStrength) -> float:
        return float(getattr(pins.deflection, code.removeprefix("pin_")))

    def measure() -> Measure:
        found = design.pin_strength
        assert found.deflection is not None
        bends, slopes = found.deflection.satellite, found.deflection.slope_satellite
        return Measure(
            bent(found),
            error=4 * found.accuracy.relative_error,
            at={"satellite": bends if code == "pin_deflection" else slopes},
            reserve=partial(design.pin_reserve, value=bent),
            rough=design.as_made,
        )

    return asked(code, limit, measure, name=code.replace("pin", "max"))


def _deflection(design: CrankDesign) -> Check:
    return _bent(design, "pin_deflection", design.max_deflection)


def _slope(design: CrankDesign) -> Check:
    return _bent(design, "pin_slope", design.max_slope)


PINS: dict[str, Callable[[CrankDesign], Check]] = {
    "pin_static": _static,
    "pin_deflection": _deflection,
    "pin_slope": _slope,
}
"""Checks of the pins, by code."""

PIN_FATIGUE: dict[str, Callable[[CrankDesign], Check]] = {"pin_fatigue": _fatigue}
"""The check of their fatigue, where what judges it is given."""
