"""Checks of a precessional gear and its shaft: room, deflection, slope."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from itertools import pairwise

from core.checks.check import (
    Check,
    Kind,
    Measure,
    Verdict,
    asked_of,
    design_check,
    judged_by,
    verdict,
)
from core.checks.inputs import FATIGUE
from core.checks.rollers import cycle_check
from core.design.document import not_given
from core.design.sections import Requirements
from core.errors import Notice, if_known
from core.precession.line_contact import LineContact
from core.precession.shaft_deflection import ShaftDeflection
from core.precession.shaft_strength import ShaftStrength
from core.precision import AS_TYPED


@dataclass(frozen=True, kw_only=True)
class ShaftDesign:
    """A precessional gear and its shaft, as they are checked.

    Attributes
    ----------
    positions : sequence of float
        Position angles of the wheel's rollers, rad; the same one twice is one roller.
    strength : ShaftStrength
        Its bending strength, where that is asked.
    fatigue_asked : bool
        Whether its fatigue is asked; without a cycle in `strength` the load is steady.
    contact : LineContact
        Pressure along the contact lines, where the curvature of the teeth is given.
    """

    result: ShaftDeflection  # the shaft's deflection and slope
    positions: Sequence[float]
    roller_circle_radius: float  # R_C, m
    roller_radius: float  # rho, m
    diameters: Sequence[float]  # of the shaft, m
    strength: ShaftStrength = not_given("strength")
    yield_strength: float | None = None  # R_e of the shaft, Pa
    fatigue_asked: bool = False
    no_fatigue: Notice | None = None  # why that is not known
    contact: LineContact = not_given("contact")
    # Of roller and tooth, Pa, by the paths of their materials, as far as they are known.
    pressure_limits: Mapping[str, float] = field(default_factory=dict)
    requirements: Requirements = Requirements()

    @property
    def error(self) -> float:
        """Relative error of deflection, slope and stress that checks allow for."""
        return 4 * float(self.result.accuracy.relative_error)


LINE_MATERIALS = ("line_contact.roller_material", "line_contact.mating_material")
"""Materials of what touches along the contact lines."""

_LINES = (
    "torque",
    "roller_circle_radius",
    "roller_radius",
    "nutation_angle",
    "ratio_u12",
    "rollers",
    "wheel",
)
"""Of the contact lines and their load."""

_INPUTS = (
    *_LINES,
    "reference_z",
    "bearing_distance",
    "overhang",
    "shaft_diameter",
    "shaft_sections",
)
"""Of the moments along the shaft."""


@design_check(
    "line_spacing",
    title="Space between rollers",
    group="room",
    unit="mm",
    formula="2·R_C·sin(Δφ/2) − 2·ρ > 0",
    why="Otherwise the rollers overlap.",
    inputs="roller_circle_radius roller_radius rollers wheel",
    fixes="roller_radius roller_circle_radius",
    keep="above",
)
def line_spacing(kind: Kind, design: ShaftDesign) -> Check:
    turn = 2 * math.pi
    places = sorted(angle % turn for angle in design.positions)
    apart = [after - before for before, after in pairwise([*places, places[0] + turn])]
    apart = [each for each in apart if AS_TYPED < each < turn - AS_TYPED]
    if not apart:
        return Check(kind, "not_applicable", reason="one_only")
    pitch, size = 2 * design.roller_circle_radius * math.sin(min(apart) / 2), design.roller_radius
    return kind.gap(pitch - 2 * size, size=size)


@design_check(
    "shaft_in_circle",
    title="Shaft within the rollers",
    group="room",
    unit="mm",
    formula="R_C − ρ − d/2 > 0",
    why="Otherwise the shaft reaches the rollers.",
    inputs="roller_circle_radius roller_radius shaft_diameter shaft_sections",
    fixes="shaft_diameter roller_radius roller_circle_radius",
    keep="above",
)
def shaft_in_circle(kind: Kind, design: ShaftDesign) -> Check:
    size = design.roller_radius
    room = design.roller_circle_radius - size - max(design.diameters) / 2
    return kind.gap(room, size=size)


@design_check(
    "shaft_deflection",
    title="Deflection of the shaft",
    group="shaft",
    unit="mm",
    formula="max(Δ_B, Δ_C) ≤ Δ_max",
    why="Above it the mesh is off its place.",
    inputs=(_INPUTS, "youngs_modulus max_deflection"),
    fixes="shaft_diameter overhang bearing_distance",
    source="beam",
    asks="max_deflection",
)
def shaft_deflection(kind: Kind, design: ShaftDesign) -> Measure:
    largest = max(design.result.deflection_B.total, design.result.deflection_C.total)
    return Measure(largest, error=design.error, reserve=float)


@design_check(
    "shaft_slope",
    title="Slope of the shaft in its bearings",
    group="shaft",
    unit="mrad",
    formula="max(θ_B, θ_C) ≤ θ_max",
    why="Above it the bearings carry on their edges.",
    inputs=(_INPUTS, "youngs_modulus max_slope"),
    fixes="shaft_diameter overhang bearing_distance",
    source="beam",
    asks="max_slope",
)
def shaft_slope(kind: Kind, design: ShaftDesign) -> Measure:
    largest = max(design.result.slope_B.total, design.result.slope_C.total)
    return Measure(largest, error=design.error, reserve=float)


@design_check(
    "shaft_static",
    title="Static strength of the shaft in bending",
    group="shaft",
    unit="MPa",
    formula="σ ≤ R_e/S_F",
    why="Above it the shaft bends for good.",
    inputs=(_INPUTS, "yield_strength bending_safety"),
    fixes="shaft_diameter overhang",
    source="beam",
    needs=("strength",),
)
def shaft_static(kind: Kind, design: ShaftDesign) -> Check:
    stress = design.strength.peak_stress
    strength = judged_by(design.yield_strength, "yield_unknown", "yield_strength", value=stress)
    limit = strength / design.requirements.bending_safety
    reserve = limit / stress if stress > 0 else None
    return kind.judged(stress, limit, reserve=reserve, error=design.error)


@design_check(
    "shaft_fatigue",
    title="Fatigue of the shaft in bending",
    group="shaft",
    formula="n ≥ S_D",
    why="Below it the shaft breaks after some time where it bends most.",
    inputs=(
        _INPUTS,
        "load_rotates_with_shaft youngs_modulus tensile_strength",
        tuple(each for each in FATIGUE if each != "fatigue.criterion"),
        "fatigue_safety",
    ),
    fixes="shaft_diameter overhang",
    source="shigley",
    keep="above",
    needs=("strength", "fatigue_asked"),
)
def shaft_fatigue(kind: Kind, design: ShaftDesign) -> Check:
    """Its reversed bending; a load that turns with the shaft bends it one way."""
    fatigue = design.no_fatigue or if_known(lambda: design.strength.fatigue)
    safety = design.requirements.fatigue_safety
    if not fatigue:
        return Check(kind, "not_applicable", reason="steady_load")
    reserve = None if isinstance(fatigue, Notice) else fatigue.safety_factor / safety
    return cycle_check(kind, fatigue=fatigue, safety=safety, reserve=reserve, error=design.error)


@design_check(
    "line_pressure",
    title="Pressure along the contact lines",
    group="lines",
    unit="MPa",
    formula="p₀ ≤ p_all/S_H",
    why="Above it rollers or teeth pit in the long run.",
    inputs=(
        _LINES,
        "line_contact.mating_radius line_contact.roller_material line_contact.mating_material",
        "pitting_safety",
    ),
    fixes="roller_radius roller_circle_radius",
    source="hertz",
    needs=("contact",),
)
def line_pressure(kind: Kind, design: ShaftDesign) -> Check:
    """Against the lower of both limits, where both are known."""
    pressure, limits = design.contact.max_pressure, design.pressure_limits
    missing = tuple(name for name in LINE_MATERIALS if name not in limits)
    error = 4 * float(design.contact.accuracy.relative_error)
    limit = min(limits.values(), default=math.inf) / design.requirements.pitting_safety
    found = kind.judged(pressure, limit, reserve=(limit / pressure) ** 2, error=error)
    if missing and found.status != "fail":
        return Check(kind, "not_checked", value=pressure, reason="limit_unknown", missing=missing)
    return found


SHAFT = (
    line_spacing,
    shaft_in_circle,
    shaft_deflection,
    shaft_slope,
    shaft_static,
    shaft_fatigue,
    line_pressure,
)


def shaft_checks(design: ShaftDesign) -> Verdict:
    """All checks of a precessional gear and its shaft."""
    limits = {"deflection": "max_deflection", "slope": "max_slope"}
    left = [name for name, limit in limits.items() if not asked_of(design, limit)]
    if not design.contact:
        left.append("line_pressure")
    if not design.strength:
        left.append("shaft_strength")
    elif not design.fatigue_asked:
        left.append("fatigue")
    kinds = [kind for kind in SHAFT if all(getattr(design, each) for each in kind.needs)]
    return verdict(
        [kind.of(design) for kind in kinds],
        (*left, "bearing", "friction"),
    )
