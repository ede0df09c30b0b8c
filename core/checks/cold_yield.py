"""The torque at which a plastic contact of pins and holes yields at once: all that is known of what
may not last.
"""

from dataclasses import dataclass

from core.checks.check import Verdict
from core.checks.crank_planetary import crank_check, under
from core.checks.plastics import PLASTICS, cold_limits
from core.design.results import Results
from core.errors import required
from core.materials import Body

LOOKS, NEAR = 6, 1e-4
"""Torques at most that are looked at where forces are solved; how near 1 the last reserve is."""

LASTING = 0.25
"""Part of the torque under which the stress is half of the strength."""


@dataclass(frozen=True, slots=True, kw_only=True)
class ColdYield:
    """When the weaker plastic body of the contact of pins and holes yields at once, of those with a
    known strength; its teeth may do so before.
    """

    torque: float  # above which it does, N*m; the peak torque is as many times as large as it is
    body: Body  # which
    strength: float  # its strength in the direction that is loaded, Pa
    friction: float  # mu in the holes
    open: tuple[str, ...]  # codes of checks that would have to be made before it may last

    @property
    def quarter(self) -> float:
        """A quarter of that torque, N*m: half of the stress."""
        return LASTING * self.torque


def cold_yield(*, results: Results, found: Verdict) -> ColdYield | None:
    """The torque at which a plastic contact yields at once.

    Parameters
    ----------
    results : Results
        Results of a design.
    found : Verdict
        Its checks.

    Returns
    -------
    ColdYield or None
        None where no plastic touches, where its strength is not known, and where the parts do not
        go together.

    Raises
    ------
    NotKnown
        If its friction is not known.
    """
    design, checks = results.design, {each.code: each for each in found.checks}
    check = checks.get("contact_static_cold")
    misfits = {each.code for each in found.checks if each.status == "fail"} & {"interference"}
    if check is None or found.impossible or misfits or not check.by_torque:
        return None
    friction, factor = design.hole_friction, check.reserve
    for _ in range(LOOKS if check.rough or results.solved else 0):
        there = Results(under(design=design, factor=factor), equal=results.shared_equally)
        seen = crank_check(check.code, there)
        if not seen.by_torque:
            return None
        factor *= seen.reserve
        if abs(seen.reserve - 1) <= NEAR:
            break
    limits = cold_limits(results=results, contact=results.static_contact)
    body = min(limits, key=limits.__getitem__)
    strength = required(design.lasting[body].loaded_strength(body), "yield_unknown")
    judged = [kind.code for kind in PLASTICS if kind is not check.kind]
    unknown = (
        code
        for code in judged
        if checks[code].status == "not_checked" and not checks[code].only_needed
    )
    worn = checks.get("wear")
    known = worn is not None and (worn.value is not None or worn.status == "not_applicable")
    wears = () if known else ("wear",)
    teeth = (each.code for each in found.checks if each.reason == "plastic_limit_unknown"
             and each.kind.part == "teeth")  # fmt: skip
    return ColdYield(
        torque=abs(design.load.output_torque) * factor,
        body=body,
        strength=strength,
        friction=friction,
        open=(*unknown, *wears, *teeth),
    )
