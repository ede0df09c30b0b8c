"""Checks of the pins' friction: efficiency, sliding speed, pv, wear against what is asked."""

from collections.abc import Callable

from core.checks.check import Check, Measure, asked
from core.checks.design_check import Judge
from core.derived import if_known
from core.design.document import Design
from core.design.results import Results
from core.errors import NotKnown
from core.output.losses import PinLosses

LIMITS = {
    "efficiency": "min_efficiency",
    "sliding_speed": "max_sliding_speed",
    "pv": "max_pv",
    "wear": "max_wear",
}
"""What has to be asked for each."""


def _asked(
    design: Design,
    results: Results,
    code: str,
    of: Callable[[PinLosses], float],
    *,
    with_torque: bool = False,
) -> Check:
    """A value of the losses against what is asked."""

    def measure() -> Measure:
        found = results.output_efficiency
        if not with_torque:
            return Measure(of(found))
        return Measure(
            of(found),
            error=4 * float(found.accuracy.relative_error),
            reserve=lambda growth: growth,
            rough=results.solved,
        )

    return asked(code, getattr(design.requirements, LIMITS[code]), measure, name=LIMITS[code])


def _efficiency(design: Design, results: Results) -> Check:
    found = _asked(design, results, "efficiency", lambda losses: float(losses.efficiency))
    if found.value is None or found.limit is None:
        return found
    return found._replace(utilisation=(1 - found.value) / (1 - found.limit))  # by the losses


def _sliding_speed(design: Design, results: Results) -> Check:
    return _asked(design, results, "sliding_speed", lambda losses: float(losses.sliding_speed))


def _pv(design: Design, results: Results) -> Check:
    """Of a sleeve, which is a bush; a bare pin in a wider hole is none."""
    losses = None if design.friction.sleeve else if_known(lambda: results.output_efficiency)
    if losses is None:
        return _asked(design, results, "pv", lambda losses: float(losses.peak_pv), with_torque=True)
    value, limit = float(losses.peak_pv), design.requirements.max_pv
    return Check(code="pv", status="not_applicable", value=value, limit=limit, reason="no_bush")


def _wear(design: Design, results: Results) -> Check:
    def depth(losses: PinLosses) -> float:
        depths = [each for each in (losses.pin_wear, losses.hole_wear) if each is not None]
        if not depths:
            raise NotKnown("wear_unknown", "friction.wear_rate")
        return float(max(depths))

    return _asked(design, results, "wear", depth, with_torque=True)


FRICTION: dict[str, Judge] = {
    "efficiency": _efficiency,
    "sliding_speed": _sliding_speed,
    "pv": _pv,
    "wear": _wear,
}
"""Checks of friction and wear, by code."""
