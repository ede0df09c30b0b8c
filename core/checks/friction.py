"""Checks of the pins' friction: efficiency, sliding speed, pv, wear against what is asked."""

from collections.abc import Callable
from functools import partial
from typing import Any

from core.checks.check import Check, asked
from core.checks.crank_design import CrankDesign
from core.output.losses import PinLosses

LIMITS = {
    "efficiency": "min_efficiency",
    "sliding_speed": "max_sliding_speed",
    "pv": "max_pv",
    "wear": "max_wear",
}
"""What has to be asked for each."""


def _asked(
    design: CrankDesign,
    code: str,
    of: Callable[[PinLosses], float | None],
    *,
    with_torque: bool = False,
    **more: Any,
) -> Check:
    """A value of the losses against what is asked."""
    found, limit = design.losses, getattr(design, LIMITS[code])
    value = None
    if isinstance(found, PinLosses):
        value = of(found)
        if with_torque:
            more["error"] = 4 * float(found.accuracy.relative_error)
            more["rough"] = design.as_made
            more["reserve"] = partial(design.reserve, value=design.moved_peak)

    def unknown() -> Check:
        reason, missing = design.unturned(found)
        if isinstance(found, PinLosses):
            reason, missing = "wear_unknown", ("friction.wear_rate",)
        return Check(code=code, status="not_checked", limit=limit, reason=reason, missing=missing)

    return asked(code, value, limit, name=LIMITS[code], unknown=unknown, **more)


def _efficiency(design: CrankDesign) -> Check:
    found = _asked(design, "efficiency", lambda losses: float(losses.efficiency))
    if found.value is None or found.limit is None:
        return found
    return found._replace(utilisation=(1 - found.value) / (1 - found.limit))  # by the losses


def _sliding_speed(design: CrankDesign) -> Check:
    return _asked(design, "sliding_speed", lambda losses: float(losses.sliding_speed))


def _pv(design: CrankDesign) -> Check:
    """Of a sleeve, which is a bush; a bare pin in a wider hole is none."""
    assert design.friction is not None
    code, found = "pv", design.losses
    if isinstance(found, PinLosses) and not design.friction.sleeve:
        value, limit, why = float(found.peak_pv), design.max_pv, "no_bush"
        return Check(code=code, status="not_applicable", value=value, limit=limit, reason=why)
    return _asked(design, code, lambda losses: float(losses.peak_pv), with_torque=True)


def _wear(design: CrankDesign) -> Check:
    def depth(losses: PinLosses) -> float | None:
        both = (losses.pin_wear, losses.hole_wear)
        return max((float(each) for each in both if each is not None), default=None)

    return _asked(design, "wear", depth, with_torque=True)


FRICTION: dict[str, Callable[[CrankDesign], Check]] = {
    "efficiency": _efficiency,
    "sliding_speed": _sliding_speed,
    "pv": _pv,
    "wear": _wear,
}
"""Checks of friction and wear, by code."""
