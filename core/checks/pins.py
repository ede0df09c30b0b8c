"""Checks of the pins as beams: static strength, fatigue, deflection, slope."""

from core.checks.check import Check, Measure, asked, judged
from core.checks.design_check import Judge
from core.design.document import Design
from core.design.results import Results
from core.output.pin_fatigue import FatigueStrength

HARDENED = 1400e6
"""Tensile strength above which a steel hardly yields before it breaks, Pa."""


def _of_size(results: Results, check: Check) -> Check:
    """A check by the strengths of the material: of thicker pins these are less than known, so that
    only what fails is certain, but not by how much.
    """
    if not results.size_notices:
        return check
    (thick,) = results.size_notices
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


def _static(design: Design, results: Results) -> Check:
    code, found = "pin_static", results.pin_strength
    stress, tensile = found.static_stress, design.pin.tensile_strength
    strength = design.pin.material.yield_strength
    if strength is None and tensile is not None and tensile > HARDENED:
        strength = tensile
    if strength is None:
        missing = ("pin.material.yield_strength",)
        return Check(
            code=code, status="not_checked", value=stress, reason="yield_unknown", missing=missing
        )
    limit = strength / design.requirements.bending_safety
    error = 4 * found.accuracy.relative_error
    reserve = limit / stress
    check = judged(code, stress, limit, reserve=reserve, error=error, rough=results.solved)
    return _of_size(results, check)


def _fatigue(design: Design, results: Results) -> Check:
    code, found = "pin_fatigue", results.pin_strength
    if found.fatigue is None:
        judged_by = results.fatigue_strength
        assert not isinstance(judged_by, FatigueStrength) and judged_by is not None
        reason = judged_by.code
        missing: tuple[str, ...] = ("fatigue.fatigue_notch_factor",)
        if reason == "endurance_unknown":
            missing = ("pin.material.tensile_strength",)
            if design.pin.tensile_strength is not None:
                missing = ("fatigue.endurance_limit",)
        if design.fatigue.criterion == "soderberg" and design.pin.material.yield_strength is None:
            reason, missing = "yield_unknown", ("pin.material.yield_strength",)
        return Check(code=code, status="not_checked", reason=reason, missing=missing)
    safety, limit = found.fatigue.safety_factor, design.requirements.fatigue_safety
    error = 4 * found.accuracy.relative_error
    reserve = safety / limit
    check = judged(code, safety, limit, reserve=reserve, error=error, rough=results.solved)
    lasts = found.fatigue.finite_strength is not None and not check.reason
    return _of_size(results, check._replace(reason="finite_life") if lasts else check)


def _bent(design: Design, results: Results, code: str, limit: float | None) -> Check:
    """The largest deflection or slope against what is asked."""

    def measure() -> Measure:
        found = results.pin_strength
        assert found.deflection is not None
        bends, slopes = found.deflection.satellite, found.deflection.slope_satellite
        return Measure(
            float(getattr(found.deflection, code.removeprefix("pin_"))),
            error=4 * found.accuracy.relative_error,
            at={"satellite": bends if code == "pin_deflection" else slopes},
            reserve=lambda growth: growth,
            rough=results.solved,
        )

    return asked(code, limit, measure, name=code.replace("pin", "max"))


def _deflection(design: Design, results: Results) -> Check:
    return _bent(design, results, "pin_deflection", design.requirements.max_deflection)


def _slope(design: Design, results: Results) -> Check:
    return _bent(design, results, "pin_slope", design.requirements.max_slope)


PINS: dict[str, Judge] = {
    "pin_static": _static,
    "pin_deflection": _deflection,
    "pin_slope": _slope,
}
"""Checks of the pins, by code."""

PIN_FATIGUE: dict[str, Judge] = {"pin_fatigue": _fatigue}
"""The check of their fatigue, where what judges it is given."""
