"""Torque at which a plastic part yields at once, the known limit of a part that may not last."""

import math
from dataclasses import dataclass
from typing import Literal

from core.checks.check import Check, Verdict
from core.checks.contacts import PLASTICS
from core.checks.crank_planetary import crank_check
from core.design.results import Results
from core.errors import UNKNOWN, required
from core.fields import answer, answered
from core.hertz import Body

LOOKS, NEAR = 6, 1e-4
"""Largest number of torques tried for solved forces; distance of the last reserve from 1."""

LASTING = 0.25
"""Part of the torque at which the stress is half of the strength."""


@dataclass(frozen=True, slots=True, kw_only=True)
class ColdYield:
    """First yield of a plastic pin, hole or tooth, by its least strength and largest friction."""

    torque: float = answer("Nm")
    """Torque above which the cold plastic (23 °C) yields at the first application."""
    part: Literal["contact", "teeth"] = answer()
    """Part that yields: a pin or a hole (contact), or the teeth of a disc on pins whose forces are
    known (teeth)."""
    body: Body  # body that yields
    strength: float = answer("MPa")
    """Strength used for the yield torque, in the direction of the load."""
    friction: float = answer("", "μ")
    """Friction coefficient of the sliding contact; 0 for teeth if it is not known."""
    open: tuple[str, ...]  # codes of checks that are missing for a statement over the life

    @property
    @answered("Nm")
    def quarter(self) -> float:
        """Quarter of that torque, at which the stress is half of the strength."""
        return LASTING * self.torque


def cold_yield(*, results: Results, found: Verdict) -> ColdYield | None:
    """Torque at which a plastic part may yield at once; None if no plastic touches, a yield torque
    is not known, or the parts do not fit together. Friction in the holes has to be known.
    """
    design, checks = results.design, {each.code: each for each in found.checks}
    check, teeth = checks.get("contact_static_cold"), checks.get("ring_static_cold")
    if check is None or not check.by_torque:
        return None

    friction, looks = design.hole_friction.high, LOOKS if check.solved or results.solved else 0
    try:
        factor = _settled(results, check, looks)
        of_teeth = _settled(results, teeth, LOOKS) if teeth else math.inf
    except UNKNOWN:
        return None
    contact = results.static_contact
    limits = {body: results.cold_limit(body, contact) for body in design.plastics}
    body = min(limits, key=limits.__getitem__)
    strength = design.lasting[body].known_strength(body, f"contact.{body}_material")
    part: Literal["contact", "teeth"] = "contact"
    if of_teeth < factor:
        own = min(design.plastic_teeth, key=results.ring.cold_limit)
        part, body, factor = "teeth", "hole" if own == "disc" else "pin", of_teeth
        strength, friction = results.ring.teeth_strength(own), design.teeth_friction.high
    judged = [kind.code for kind in PLASTICS if kind is not check.kind]
    unknown = (
        code
        for code in judged
        if checks[code].status == "not_checked" and not checks[code].only_needed
    )
    worn = checks.get("wear")
    known = worn is not None and (worn.value is not None or worn.status == "not_applicable")
    wears = () if known else ("wear",)
    pressed = (
        each.code
        for each in found.checks
        if each.kind.part == "teeth" and each.reason == "plastic_limit_unknown"
    )
    return ColdYield(
        torque=abs(design.output_torque) * factor,
        part=part,
        body=body,
        strength=strength,
        friction=friction,
        open=(*unknown, *wears, *pressed),
    )


def _settled(results: Results, check: Check, looks: int) -> float:
    """Factor on the torque at the limit of a check, refined by further solutions."""
    factor = required(check.torque_reserve, "value_unknown")
    for _ in range(looks):
        there = crank_check(check.code, results.under(factor))
        reserve = required(there.torque_reserve, "value_unknown")
        factor *= reserve
        if abs(reserve - 1) <= NEAR:
            break
    return factor
