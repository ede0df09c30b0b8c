"""Checks of the pins' friction: efficiency, sliding speed, pv, wear against what is asked."""

from collections.abc import Callable
from dataclasses import replace

from core.checks.check import Check, judged, not_asked
from core.checks.crank_design import CrankDesign
from core.output.losses import PinLosses


def _known(design: CrankDesign, code: str, limit: float | None) -> PinLosses | Check:
    """Losses; else the check that cannot be made, or that nobody asks."""
    found = design.losses
    if isinstance(found, PinLosses):
        return found
    if limit is None:
        return not_asked(code=code, value=None, name=LIMITS[code])
    reason, missing = design.unturned(found)
    return Check(code=code, status="not_checked", limit=limit, reason=reason, missing=missing)


def _efficiency(design: CrankDesign) -> Check:
    code, limit = "efficiency", design.min_efficiency
    found = _known(design, code, limit)
    if isinstance(found, Check):
        return found
    value = float(found.efficiency)
    if limit is None:
        return not_asked(code=code, value=value, name=LIMITS[code])
    used = (1 - value) / (1 - limit)  # by the losses
    return replace(judged(code, value, limit, keep="above"), utilisation=used)


def _sliding_speed(design: CrankDesign) -> Check:
    code, limit = "sliding_speed", design.max_sliding_speed
    found = _known(design, code, limit)
    if isinstance(found, Check):
        return found
    value = float(found.sliding_speed)
    return (
        not_asked(code=code, value=value, name=LIMITS[code])
        if limit is None
        else judged(code, value, limit)
    )


def _pv(design: CrankDesign) -> Check:
    """Of a sleeve, which is a bush; a bare pin in a wider hole is none."""
    code, limit = "pv", design.max_pv
    found = _known(design, code, limit)
    if isinstance(found, Check):
        return found
    assert design.friction is not None
    value, error = float(found.peak_pv), 4 * float(found.accuracy.relative_error)
    if not design.friction.sleeve:
        return Check(code=code, status="not_applicable", value=value, limit=limit, reason="no_bush")
    if limit is None:
        return not_asked(code=code, value=value, name=LIMITS[code])
    return judged(code, value, limit, reserve=limit / value, error=error, rough=design.as_made)


def _wear(design: CrankDesign) -> Check:
    code, limit = "wear", design.max_wear
    found = _known(design, code, limit)
    if isinstance(found, Check):
        return found
    depths = [float(each) for each in (found.pin_wear, found.hole_wear) if each is not None]
    if limit is None:
        return not_asked(code=code, value=max(depths, default=None), name=LIMITS[code])
    if not depths:
        missing = ("friction.wear_rate",)
        return Check(
            code=code, status="not_checked", limit=limit, reason="wear_unknown", missing=missing
        )
    value, error = max(depths), 4 * float(found.accuracy.relative_error)
    return judged(code, value, limit, reserve=limit / value, error=error, rough=design.as_made)


LIMITS = {
    "efficiency": "min_efficiency",
    "sliding_speed": "max_sliding_speed",
    "pv": "max_pv",
    "wear": "max_wear",
}
"""What has to be asked for each."""

FRICTION: dict[str, Callable[[CrankDesign], Check]] = {
    "efficiency": _efficiency,
    "sliding_speed": _sliding_speed,
    "pv": _pv,
    "wear": _wear,
}
"""Checks of friction and wear, by code."""
