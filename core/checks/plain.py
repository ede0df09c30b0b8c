"""Checks of swinging rollers (stress, load sharing, room, tilt), and of the precessional gear with
its shaft (room, deflection, slope, strength, pressure).
"""

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import pairwise

from core.checks.check import (
    Check,
    Element,
    Kind,
    Measure,
    Verdict,
    asked_of,
    judged_by,
    verdict,
)
from core.checks.inputs import FATIGUE, paths
from core.design.document import not_given
from core.design.sections import Requirements
from core.errors import Notice, if_known
from core.fatigue import CycleFatigue
from core.precession.line_contact import LineContact
from core.precession.shaft_deflection import ShaftDeflection
from core.precession.shaft_strength import ShaftStrength
from core.precision import AS_TYPED
from core.rollers.roller_strength import RollerStrength, Spacing

MISSING = {
    "endurance_unknown": ("tensile_strength",),
    "notch_unknown": ("fatigue.fatigue_notch_factor",),
}
"""Inputs that are not given if the fatigue is not known, by the code of the reason."""

ROLLER_LENGTH = 10.0
"""Usual least length of a swinging roller from end to end, over the eccentricity."""


@dataclass(frozen=True, kw_only=True)
class RollerDesign:
    """Swinging rollers with their results and requirements."""

    result: RollerStrength  # load sharing and strength
    output_torque: float  # T, N*m
    hole_circle_radius: float  # R, m
    rollers: int  # n
    sphere_diameter: float  # D, m
    cylinder_length: float  # l, m
    sphere_width: float  # b, m
    spacing: Spacing  # argument of `roller_strength`
    yield_strength: float | None = None  # R_e, Pa
    eccentricity: float | None = None  # e of the crank, m
    fatigue: CycleFatigue | Notice = not_given("fatigue")  # or the reason why it is not known
    requirements: Requirements = Requirements()

    def reserve(self, growth: float) -> float:
        """Factor on the torque at which the largest force is `growth` times larger."""
        # Roller forces are F_i = c*max(0, Delta - g_i).
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


@dataclass(frozen=True, kw_only=True)
class ShaftDesign:
    """Precessional gear and its shaft with their results and requirements."""

    result: ShaftDeflection  # deflection and slope of the shaft
    positions: Sequence[float]  # angles of the wheel's rollers, rad; equal ones are one roller
    roller_circle_radius: float  # R_C, m
    roller_radius: float  # rho, m
    diameters: Sequence[float]  # diameters of the shaft, m
    strength: ShaftStrength = not_given("strength")  # bending strength of the shaft
    yield_strength: float | None = None  # R_e of the shaft, Pa
    fatigue_asked: bool = False  # a load without a cycle in `strength` is steady
    no_fatigue: Notice | None = None  # reason why fatigue is not known
    contact: LineContact = not_given("contact")  # pressure, if the teeth's curvature is given
    # Limits of roller and tooth, Pa, by paths of their materials, as far as they are known.
    pressure_limits: Mapping[str, float] = field(default_factory=dict)
    requirements: Requirements = Requirements()

    def reserve(self, growth: float) -> float:
        """Factor on the torque at which stresses are `growth` times larger: the growth itself."""
        return growth

    @property
    def error(self) -> float:
        """Relative error of deflection, slope and stress that checks allow for."""
        return 4 * float(self.result.accuracy.relative_error)


Plain = RollerDesign | ShaftDesign

_ROLLERS = paths(
    "output_torque hole_circle_radius rollers diameter cylinder_length sphere_width",
    "sphere_diameter friction_coefficient youngs_modulus poissons_ratio shear_modulus",
    "position_tolerance gaps",
)
_LINES = "torque roller_circle_radius roller_radius nutation_angle ratio_u12 rollers wheel"
"""Inputs of the contact lines and their load."""

_SHAFT = (_LINES, "reference_z bearing_distance overhang shaft_diameter shaft_sections")
"""Inputs of the moments along the shaft."""

LINE_MATERIALS = ("line_contact.roller_material", "line_contact.mating_material")
"""Materials of the parts that touch along the contact lines."""

_roller, _shaft = Element("rollers"), Element("shaft")
_bending = Element(
    "shaft", fixes="shaft_diameter shaft_sections.diameter overhang bearing_distance", source="beam"
)
_between = Element("rollers", unit="mm", keep="above")
_room = Element("room", unit="mm", keep="above")


def _static(kind: Kind, design: Plain, stress: float) -> Check:
    """Check of a bending stress against the yield strength over the required safety."""
    strength = judged_by(design.yield_strength, "yield_unknown", "yield_strength", value=stress)
    limit = strength / design.requirements.bending_safety
    reserve = design.reserve(limit / stress) if stress > 0 else None
    return kind.judged(stress, limit, reserve=reserve, error=design.error)


def _lasting(kind: Kind, design: Plain, fatigue: CycleFatigue | Notice) -> Check:
    """Check of the safety of a stress cycle, or the reason why it is not known."""
    safety = design.requirements.fatigue_safety
    if isinstance(fatigue, Notice):
        why = fatigue.code
        return Check(kind, "not_checked", limit=safety, reason=why, missing=MISSING[why])
    reserve = design.reserve(fatigue.safety_factor / safety)
    return kind.judged(fatigue.safety_factor, safety, reserve=reserve, error=design.error)


@_roller(
    "roller_stress",
    title="Bending stress of the rollers",
    unit="MPa",
    formula="σ ≤ R_e/S",
    why="Above it the rollers bend for good.",
    inputs=(_ROLLERS, "stress_concentration yield_strength bending_safety"),
    fixes="diameter hole_circle_radius rollers position_tolerance output_torque",
    source="ovsyannikov_2019",
)
def roller_stress(kind: Kind, design: RollerDesign) -> Check:
    return _static(kind, design, float(design.result.bending_stress))


@_roller(
    "roller_fatigue",
    title="Fatigue of the rollers",
    formula="n ≥ S_D",
    why="Below it the rollers break after some time beside the middle sphere.",
    inputs=(
        _ROLLERS,
        "stress_concentration roller_rotates tensile_strength yield_strength",
        FATIGUE,
        "fatigue_safety",
    ),
    fixes="diameter hole_circle_radius rollers output_torque",
    source="shigley",
    keep="above",
    needs="fatigue",
)
def roller_fatigue(kind: Kind, design: RollerDesign) -> Check:
    return _lasting(kind, design, design.fatigue)


@_roller(
    "roller_sharing",
    title="Rollers that carry",
    formula="n_c = n",
    why="Otherwise few rollers carry all of the load.",
    inputs=_ROLLERS,
    fixes="position_tolerance output_torque",
    source="ovsyannikov_2019",
    keep="above",
)
def roller_sharing(kind: Kind, design: RollerDesign) -> Check:
    carrying = float(design.result.loaded_rollers)
    return kind.judged(carrying, float(design.rollers), warning="uneven")


@_between(
    "roller_spacing",
    title="Space between rollers",
    formula="2·R·sin(π/n) − D > 0",
    why="Otherwise the spheres overlap.",
    inputs="rollers hole_circle_radius sphere_diameter",
    fixes="hole_circle_radius sphere_diameter rollers",
)
def roller_spacing(kind: Kind, design: RollerDesign) -> Check:
    if design.rollers < 2:
        return Check(kind, "not_applicable", reason="one_only")
    pitch = 2 * design.hole_circle_radius * math.sin(math.pi / design.rollers)
    size = design.sphere_diameter
    return kind.gap(pitch - size, size=size)


@_between(
    "roller_room",
    title="Rollers beside the centre",
    formula="R − D/2 > 0",
    why="Otherwise the rollers reach the axis.",
    inputs="hole_circle_radius sphere_diameter",
    fixes="hole_circle_radius sphere_diameter",
)
def roller_room(kind: Kind, design: RollerDesign) -> Check:
    size = design.sphere_diameter
    return kind.gap(design.hole_circle_radius - size / 2, size=size)


@_between(
    "roller_tilt",
    title="Length of the rollers",
    formula="2·l + 3·b ≥ 10·e",
    why="Shorter ones tilt too much against the discs.",
    inputs="cylinder_length sphere_width eccentricity",
    fixes="cylinder_length",
    source="ovsyannikov_2019_length",
)
def roller_tilt(kind: Kind, design: RollerDesign) -> Check:
    """Ovsyannikov et al. 2019, before fig. 3: "the length of a roller usually exceeds the centre
    distance at least 10 times", a tilt of about 12°. The whole length, two cylinders and three
    spheres, is compared: over half of it, 5*e, the centre moves by e, 11.3°.
    """
    length = 2 * design.cylinder_length + 3 * design.sphere_width
    said = {"value": length, "status": "not_asked"}
    eccentricity = judged_by(design.eccentricity, "", "eccentricity", **said)
    return kind.judged(length, ROLLER_LENGTH * eccentricity, warning="tilted")


ROLLERS = (roller_stress, roller_fatigue, roller_sharing, roller_spacing, roller_room, roller_tilt)


@_room(
    "line_spacing",
    title="Space between rollers",
    formula="2·R_C·sin(Δφ/2) − 2·ρ > 0",
    why="Otherwise the rollers overlap.",
    inputs="roller_circle_radius roller_radius rollers wheel",
    fixes="roller_radius roller_circle_radius",
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


@_room(
    "shaft_in_circle",
    title="Shaft within the rollers",
    formula="R_C − ρ − d/2 > 0",
    why="Otherwise the shaft reaches the rollers.",
    inputs="roller_circle_radius roller_radius shaft_diameter shaft_sections",
    fixes="shaft_diameter shaft_sections.diameter roller_radius roller_circle_radius",
)
def shaft_in_circle(kind: Kind, design: ShaftDesign) -> Check:
    size = design.roller_radius
    room = design.roller_circle_radius - size - max(design.diameters) / 2
    return kind.gap(room, size=size)


def _bent(design: ShaftDesign, name: str) -> Measure:
    """Larger deflection or slope of the shaft in the bearings B and C."""
    largest = max(getattr(design.result, f"{name}_{place}").total for place in "BC")
    return Measure(largest, error=design.error, reserve=float)


@_bending(
    "shaft_deflection",
    title="Deflection of the shaft",
    unit="mm",
    formula="max(Δ_B, Δ_C) ≤ Δ_max",
    why="Above it the mesh is off its place.",
    inputs=(_SHAFT, "youngs_modulus max_deflection"),
    asks="max_deflection",
)
def shaft_deflection(kind: Kind, design: ShaftDesign) -> Measure:
    return _bent(design, "deflection")


@_bending(
    "shaft_slope",
    title="Slope of the shaft in its bearings",
    unit="mrad",
    formula="max(θ_B, θ_C) ≤ θ_max",
    why="Above it the bearings carry on their edges.",
    inputs=(_SHAFT, "youngs_modulus max_slope"),
    asks="max_slope",
)
def shaft_slope(kind: Kind, design: ShaftDesign) -> Measure:
    return _bent(design, "slope")


@_shaft(
    "shaft_static",
    title="Static strength of the shaft in bending",
    unit="MPa",
    formula="σ ≤ R_e/S_F",
    why="Above it the shaft bends for good.",
    inputs=(_SHAFT, "yield_strength bending_safety"),
    fixes="shaft_diameter shaft_sections.diameter overhang",
    source="beam",
    needs="strength",
)
def shaft_static(kind: Kind, design: ShaftDesign) -> Check:
    return _static(kind, design, design.strength.peak_stress)


@_shaft(
    "shaft_fatigue",
    title="Fatigue of the shaft in bending",
    formula="n ≥ S_D",
    why="Below it the shaft breaks after some time where it bends most.",
    inputs=(
        _SHAFT,
        "load_rotates_with_shaft youngs_modulus tensile_strength",
        tuple(each for each in FATIGUE if each != "fatigue.criterion"),
        "fatigue_safety",
    ),
    fixes="shaft_diameter shaft_sections.diameter overhang",
    source="shigley",
    keep="above",
    needs="strength fatigue_asked",
)
def shaft_fatigue(kind: Kind, design: ShaftDesign) -> Check:
    """Fatigue in reversed bending; a load that turns with the shaft bends it steadily."""
    fatigue = design.no_fatigue or if_known(lambda: design.strength.fatigue)
    if not fatigue:
        return Check(kind, "not_applicable", reason="steady_load")
    return _lasting(kind, design, fatigue)


@Element("lines")(
    "line_pressure",
    title="Pressure along the contact lines",
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
    needs="contact",
)
def line_pressure(kind: Kind, design: ShaftDesign) -> Check:
    """Compare the pressure with the lower limit of roller and tooth over the required safety; a
    missing limit leaves the check open unless it fails by the known one.
    """
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


def _verdict(kinds: Iterable[Kind], design: Plain, left: Iterable[str]) -> Verdict:
    """Verdict of the checks whose needs a design meets, with the subjects left out."""
    there = [kind for kind in kinds if all(getattr(design, each) for each in kind.needs)]
    return verdict([kind.of(design) for kind in there], tuple(left))


def roller_checks(design: RollerDesign) -> Verdict:
    """Verdict of all checks of swinging rollers."""
    left = ("roller_contact", *(() if design.fatigue else ("fatigue",)), "friction")
    return _verdict(ROLLERS, design, left)


def shaft_checks(design: ShaftDesign) -> Verdict:
    """Verdict of all checks of a precessional gear and its shaft."""
    limits = {"deflection": "max_deflection", "slope": "max_slope"}
    left = [name for name, limit in limits.items() if not asked_of(design, limit)]
    if not design.contact:
        left.append("line_pressure")
    if not design.strength:
        left.append("shaft_strength")
    elif not design.fatigue_asked:
        left.append("fatigue")
    return _verdict(SHAFT, design, (*left, "bearing", "friction"))
