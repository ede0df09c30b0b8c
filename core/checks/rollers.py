"""Checks of swinging rollers: stress, load sharing, room, tilt."""

import math
from dataclasses import dataclass
from functools import partial

from core.checks.check import (
    Check,
    Checks,
    Kind,
    Verdict,
    design_check,
    judged_by,
    verdict,
)
from core.checks.inputs import FATIGUE
from core.design.document import not_given
from core.design.sections import Requirements
from core.errors import Notice
from core.fatigue import CycleFatigue
from core.rollers.roller_strength import RollerStrength, Spacing

MISSING = {
    "endurance_unknown": ("tensile_strength",),
    "notch_unknown": ("fatigue.fatigue_notch_factor",),
}
"""What is missing where a fatigue is not known, by the code that says why."""

ROLLER_LENGTH = 10.0
"""Usual least length of a swinging roller, from end to end, over the eccentricity."""


@dataclass(frozen=True, kw_only=True)
class RollerDesign:
    """Swinging rollers, as they are checked.

    Attributes
    ----------
    spacing : as of `roller_strength`
    fatigue : CycleFatigue or Notice
        Fatigue of the rollers, or why it is not known, where that is asked.
    """

    result: RollerStrength  # their load sharing and strength
    output_torque: float  # T, N*m
    hole_circle_radius: float  # R, m
    rollers: int  # n
    sphere_diameter: float  # D, m
    cylinder_length: float  # l, m
    sphere_width: float  # b, m
    spacing: Spacing
    yield_strength: float | None = None  # R_e, Pa
    eccentricity: float | None = None  # e of the crank, m
    fatigue: CycleFatigue | Notice = not_given("fatigue")
    requirements: Requirements = Requirements()

    def reserve(self, growth: float) -> float:
        """Factor on the torque at which the largest force is so many times larger."""
        # F_i = c*max(0, Delta - g_i): what the rollers carry then
        largest = float(self.result.max_force) * growth
        ahead = [float(gap) for gap in self.spacing.gaps(self.rollers)]
        first = min(ahead)
        carried = math.fsum(
            max(0.0, largest - float(self.result.stiffness) * (each - first)) for each in ahead
        )
        return 2 * self.hole_circle_radius * carried / self.output_torque

    @property
    def error(self) -> float:
        """Relative error of the stress that checks allow for."""
        return 4 * float(self.result.accuracy.relative_error)


_INPUTS = (
    "output_torque",
    "hole_circle_radius",
    "rollers",
    "diameter",
    "cylinder_length",
    "sphere_width",
    "sphere_diameter",
    "friction_coefficient",
    "youngs_modulus",
    "poissons_ratio",
    "shear_modulus",
    "position_tolerance",
    "gaps",
)

_check: Checks = partial(design_check, group="rollers")


@_check(
    "roller_stress",
    title="Bending stress of the rollers",
    unit="MPa",
    formula="σ ≤ R_e/S",
    why="Above it the rollers bend for good.",
    inputs=(_INPUTS, "stress_concentration yield_strength bending_safety"),
    fixes="diameter hole_circle_radius rollers position_tolerance output_torque",
    source="ovsyannikov_2019",
)
def roller_stress(kind: Kind, design: RollerDesign) -> Check:
    stress = float(design.result.bending_stress)
    strength = judged_by(design.yield_strength, "yield_unknown", "yield_strength", value=stress)
    limit = strength / design.requirements.bending_safety
    reserve = design.reserve(limit / stress)
    return kind.judged(stress, limit, reserve=reserve, error=design.error)


def cycle_check(
    kind: Kind,
    *,
    fatigue: CycleFatigue | Notice,
    safety: float,
    reserve: float | None,
    error: float,
) -> Check:
    """The safety of a stress cycle against the one that is asked.

    Parameters
    ----------
    kind : Kind
        Which check.
    fatigue : CycleFatigue or Notice
        The cycle, or why nothing is known of it.
    safety : float
        Required safety.
    reserve : float or None
        Factor on the torque at which the safety is the required one.
    error : float
        Relative error of the stress.

    Returns
    -------
    Check
    """
    if isinstance(fatigue, Notice):
        why = fatigue.code
        return Check(kind, "not_checked", limit=safety, reason=why, missing=MISSING[why])
    return kind.judged(fatigue.safety_factor, safety, reserve=reserve, error=error)


@_check(
    "roller_fatigue",
    title="Fatigue of the rollers",
    formula="n ≥ S_D",
    why="Below it the rollers break after some time beside the middle sphere.",
    inputs=(
        _INPUTS,
        "stress_concentration roller_rotates tensile_strength yield_strength",
        FATIGUE,
        "fatigue_safety",
    ),
    fixes="diameter hole_circle_radius rollers output_torque",
    source="shigley",
    keep="above",
    needs=("fatigue",),
)
def roller_fatigue(kind: Kind, design: RollerDesign) -> Check:
    fatigue, safety, reserve = design.fatigue, design.requirements.fatigue_safety, None
    if isinstance(fatigue, CycleFatigue):
        reserve = design.reserve(fatigue.safety_factor / safety)
    return cycle_check(kind, fatigue=fatigue, safety=safety, reserve=reserve, error=design.error)


@_check(
    "roller_sharing",
    title="Rollers that carry",
    formula="n_c = n",
    why="Otherwise few rollers carry all of the load.",
    inputs=_INPUTS,
    fixes="position_tolerance output_torque",
    source="ovsyannikov_2019",
    keep="above",
)
def roller_sharing(kind: Kind, design: RollerDesign) -> Check:
    carrying = float(design.result.loaded_rollers)
    return kind.judged(carrying, float(design.rollers), warning="uneven")


@_check(
    "roller_spacing",
    title="Space between rollers",
    unit="mm",
    formula="2·R·sin(π/n) − D > 0",
    why="Otherwise the spheres overlap.",
    inputs="rollers hole_circle_radius sphere_diameter",
    fixes="hole_circle_radius sphere_diameter rollers",
    keep="above",
)
def roller_spacing(kind: Kind, design: RollerDesign) -> Check:
    if design.rollers < 2:
        return Check(kind, "not_applicable", reason="one_only")
    pitch = 2 * design.hole_circle_radius * math.sin(math.pi / design.rollers)
    size = design.sphere_diameter
    return kind.gap(pitch - size, size=size)


@_check(
    "roller_room",
    title="Rollers beside the centre",
    unit="mm",
    formula="R − D/2 > 0",
    why="Otherwise the rollers reach the axis.",
    inputs="hole_circle_radius sphere_diameter",
    fixes="hole_circle_radius sphere_diameter",
    keep="above",
)
def roller_room(kind: Kind, design: RollerDesign) -> Check:
    size = design.sphere_diameter
    return kind.gap(design.hole_circle_radius - size / 2, size=size)


@_check(
    "roller_tilt",
    title="Length of the rollers",
    unit="mm",
    formula="2·l + 3·b ≥ 10·e",
    why="Shorter ones tilt too much against the discs.",
    inputs="cylinder_length sphere_width eccentricity",
    fixes="cylinder_length",
    source="ovsyannikov_2019_length",
    keep="above",
)
def roller_tilt(kind: Kind, design: RollerDesign) -> Check:
    """By Ovsyannikov et al. 2019, before fig. 3: "the length of a roller usually exceeds the centre
    distance at least 10 times", a tilt of about 12°. That is the whole length, two cylinders and
    three spheres: over half of it, 5*e, the centre moves by e, 11.3°.
    """
    length = 2 * design.cylinder_length + 3 * design.sphere_width
    said = {"value": length, "status": "not_asked"}
    eccentricity = judged_by(design.eccentricity, "", "eccentricity", **said)
    return kind.judged(length, ROLLER_LENGTH * eccentricity, warning="tilted")


ROLLERS = (
    roller_stress,
    roller_fatigue,
    roller_sharing,
    roller_spacing,
    roller_room,
    roller_tilt,
)


def roller_checks(design: RollerDesign) -> Verdict:
    """All checks of swinging rollers."""
    kinds = [kind for kind in ROLLERS if all(getattr(design, each) for each in kind.needs)]
    return verdict(
        [kind.of(design) for kind in kinds],
        ("roller_contact", *(() if design.fatigue else ("fatigue",)), "friction"),
    )
