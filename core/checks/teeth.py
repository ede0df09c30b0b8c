"""Geometric checks of teeth and lobes: force of the ring, teeth that can mesh, involute teeth as
they are made, cycloid discs on their ring pins.
"""

from functools import partial
from typing import Any

from core.checks import inputs as of
from core.checks.check import Check, Element, Kind, judged_by
from core.crank.ring_mesh import STEEP
from core.design.document import Design
from core.design.refusals import named
from core.design.results import Results
from core.design.ring import RingKind
from core.errors import ImpossibleMechanism, NotKnown, if_known
from core.precision import AS_TYPED, CLASSES
from core.ring.involute import MOST_DIFFERENCE, STANDARD_ANGLES, TIPS_APART, usual_rack
from core.ring.possible_teeth import possible_teeth
from core.ring.profile import CycloidDisc

LEAST_RATIO = 1.05
"""Least contact ratio that errors leave sufficient; few pairs with one tooth of difference reach
1.1."""

LEAST_CLEARANCE = 0.15
"""Least usual clearance of a tip, in modules."""

LEAST_TIP = 0.25
"""Least usual thickness of a tip, in modules; a thinner tip breaks when hardened through."""

HEIGHTS = tuple(
    f"{body}_{height}" for body in ("satellite", "ring") for height in ("addendum", "tip_radius")
)
"""Inputs of the places of tips."""

NEAR_UNDERCUT = 1.1
"""Least radius of curvature of the pins' path over the pin radius that leaves flank despite
errors."""

NOT_OF: dict[RingKind, str] = {"involute": "no_involute", "cycloid": "no_ring_pins"}
"""Codes of the reason why a check does not apply, by the kind of ring that it judges."""


def _other_ring(design: Design, results: Results, *, kinds: tuple[RingKind, ...]) -> str:
    """Code of the reason why a check of some kinds of rings does not apply to a design."""
    own = design.gear.kind
    if own not in kinds:
        return NOT_OF[kinds[0]]
    if own == "cycloid":
        _ = results.ring.force  # `force` refuses a disc whose path crosses itself
    return ""


not_involute = partial(_other_ring, kinds=("involute",))
not_cycloid = partial(_other_ring, kinds=("cycloid",))
not_toothed = partial(_other_ring, kinds=("cycloid", "involute"))

_mesh = Element(
    "gear",
    "teeth",
    "contact gear",
    fixes="gear.satellite_profile_shift gear.satellite_addendum gear.ring_addendum",
    source="involute_mesh",
    not_of=not_involute,
    keep="above",
)
_disc_check = Element("gear", "teeth", "contact gear", keep="above", not_of=not_cycloid)


@Element("gear", "teeth", "touching load gear")(
    "pressure_angle",
    title="Operating pressure angle",
    unit="deg",
    formula="α_w ≤ 55°",
    why="Above it the ring loads the bearings far more than the torque needs.",
    inputs=(of.RING, "contact.eccentricity"),
    fixes="gear.module",
    source="steep",
)
def pressure_angle(kind: Kind, design: Design, results: Results) -> Check:
    if_known(lambda: results.ring.force)  # refuses a ring of any kind that cannot exist
    if design.gear and design.gear.kind != "involute":
        return Check(kind, "not_applicable", reason="no_involute")
    angle = results.ring.force.operating_pressure_angle
    return kind.judged(float(angle), STEEP, warning="steep_mesh")


@_mesh(
    "mesh_possible",
    title="Teeth that can mesh",
    formula="ε_α,max ≥ 1",
    why="Otherwise teeth of this module do not mesh at this eccentricity, whatever their heights "
    "and shifts.",
    inputs=of.INVOLUTE_GEARS,
    fixes="gear.module",
    source="teeth_tried",
)
def mesh_possible(kind: Kind, design: Design, results: Results) -> Check:
    gear = design.involute
    eccentricity, _ = design.known_eccentricity, results.ring.force  # `force` refuses base circles
    if not gear.unknown_teeth:
        return Check(kind, "not_applicable", reason="teeth_given")
    low, high = STANDARD_ANGLES
    if gear.teeth_difference > MOST_DIFFERENCE or not low <= gear.reference_pressure_angle <= high:
        raise NotKnown("outside_method")
    teeth = max(1, round(design.mechanism.ratio * gear.teeth_difference))
    found = possible_teeth(
        satellite_teeth=teeth,
        ring_teeth=teeth + gear.teeth_difference,
        module=gear.module,
        eccentricity=eccentricity,
        rack=usual_rack(pressure_angle=gear.reference_pressure_angle),
    )
    check = kind.judged(found.contact_ratio, 1.0, impossible=not found.any_mesh)
    if check.status == "fail" and found.any_mesh:
        return check._replace(status="marginal", reason="unusual_teeth")
    return check


def _refused(kind: Kind, results: Results, *names: str) -> Check | None:
    """Failing check if some named inputs of the ring make teeth impossible; None otherwise."""
    try:
        _ = results.ring.pair
    except NotKnown as why:
        refusal = why.refusal
        if refusal is None or refusal.code not in ("less_than", "greater_than"):
            return None
        if refusal.parameter not in {f"gear.{name}" for name in names}:
            return None
        return Check(kind, "fail", impossible=True, reason=why.code, refusal=refusal)
    return None


def _usual(
    kind: Kind, value: float, guide: float, *, fails: bool, warning: str = "less_than_usual"
) -> Check:
    """Check of a value that is marginal below a guide value, or fails."""
    if fails:
        return kind.judged(value, guide)
    return kind.judged(value, guide, warning=warning, limit_source="guide")


def _felt(value: float) -> float:
    """Value, or 0 if it is rounding."""
    return 0.0 if abs(value) <= AS_TYPED else value


@_mesh(
    "mesh_contact_ratio",
    title="Contact ratio of the teeth",
    formula="ε_α ≥ 1.05",
    why="Below 1 no pair is in contact at times, and the motion is not handed on. Slightly above, "
    "errors do so.",
    inputs=of.INVOLUTE_TEETH,
)
def mesh_contact_ratio(kind: Kind, design: Design, results: Results) -> Check:
    ratio = results.ring.pair.contact_ratio
    return _usual(kind, ratio, LEAST_RATIO, fails=ratio < 1.0 - AS_TYPED)


@_mesh(
    "mesh_tips",
    title="Tips that pass each other",
    formula="G ≥ 0.05",
    why="Below 0 the tips run into each other beside the path of contact: the teeth cannot turn. "
    "Slightly above, errors do so.",
    inputs=of.INVOLUTE_TEETH,
    impossible=True,
)
def mesh_tips(kind: Kind, design: Design, results: Results) -> Check:
    """Fail if the tips overlap all round, as no tooth can pass then."""
    pair = results.ring.pair
    if pair.tips_overlap_all_round:
        return Check(kind, "fail", limit=TIPS_APART, impossible=True, reason="tips_overlap")
    if pair.tip_interference is None:
        return Check(kind, "not_applicable", reason="no_crossing")
    apart = pair.tip_interference
    return _usual(kind, apart, TIPS_APART, fails=apart < -AS_TYPED)


@_mesh(
    "mesh_involute",
    title="Contact on involutes only",
    formula="tan α₁ ≥ tan α_F",
    why="Otherwise a tip of one runs into the fillet of the other.",
    inputs=(of.INVOLUTE_TEETH, of.INVOLUTE_RACK, of.INVOLUTE_CUTTER),
)
def mesh_involute(kind: Kind, design: Design, results: Results) -> Check:
    """Judge the flanks of the satellite, and of the ring if its cutter is known."""
    if within := _refused(kind, results, *HEIGHTS):
        return within  # the tip lies within its base circle
    pair = results.ring.pair
    of_ring = pair.ring_flank.form_roll - pair.end_roll_ring
    value = min(pair.start_roll_satellite - pair.form_roll_satellite, of_ring)
    found = kind.judged(_felt(value), 0.0)
    if pair.teeth.cutter or found.status == "fail":
        return found
    return found._replace(reason="ring_flank_unknown", missing=("gear.cutter_teeth",))


@_mesh(
    "mesh_undercut",
    title="Roots that the hob leaves",
    formula="tan α_F ≥ 0",
    why="Otherwise the hob cuts away a part of the satellite's flanks.",
    inputs=(
        "gear.kind gear.teeth_difference gear.reference_pressure_angle",
        "gear.satellite_profile_shift mechanism.ratio",
        of.INVOLUTE_RACK,
    ),
    fixes="gear.satellite_profile_shift",
)
def mesh_undercut(kind: Kind, design: Design, results: Results) -> Check:
    return kind.judged(_felt(results.ring.pair.form_roll_satellite), 0.0)


@_mesh(
    "mesh_tip_clearance",
    title="Clearance of the tips",
    formula="c/m ≥ 0.15",
    why="Below 0 tips run into the roots of the others. Slightly above, errors do so.",
    inputs=(of.INVOLUTE_TEETH, "gear.dedendum", of.INVOLUTE_CUTTER),
    impossible=True,
)
def mesh_tip_clearance(kind: Kind, design: Design, results: Results) -> Check:
    """Judge both tip clearances; without a known cutter the hob's dedendum sets the ring's root."""
    pair = results.ring.pair
    least = min(pair.tip_clearance_satellite, pair.tip_clearance_ring) / pair.teeth.module
    found = _usual(kind, least, LEAST_CLEARANCE, fails=least < -AS_TYPED)
    if pair.teeth.cutter or found.reason or found.status == "fail":
        return found
    return found._replace(reason="ring_root_assumed", missing=("gear.cutter_teeth",))


@_mesh(
    "mesh_tip_thickness",
    title="Thickness of the tips",
    formula="s_a/m ≥ 0.25",
    why="Below 0 the teeth are pointed and shorter than they are meant to be. Slightly above, the "
    "tips break.",
    inputs=tuple(each for each in of.INVOLUTE_TEETH if each != "contact.eccentricity"),
    impossible=True,
)
def mesh_tip_thickness(kind: Kind, design: Design, results: Results) -> Check:
    pair = results.ring.pair
    thin = min(pair.satellite_tip_thickness, pair.ring_tip_thickness) / pair.teeth.module
    return _usual(kind, thin, LEAST_TIP, fails=thin < -AS_TYPED)


def torque_error(results: Results) -> float:
    """Relative error of the largest torque of a satellite; 0 for ideal forces."""
    return CLASSES["sampling"] if results.solved else 0.0


@_mesh(
    "mesh_root_stress",
    title="Bending of the satellite's tooth roots",
    unit="MPa",
    formula="K·σ_F ≤ σ_FG/S_D",
    why="Above it teeth of the satellites break at their roots within the life.",
    inputs=(
        of.INVOLUTE_LOADED,
        of.SATELLITE_TIPS,
        of.INVOLUTE_RACK,
        "gear.root_strength requirements.fatigue_safety",
    ),
    fixes="gear.contact_length load.output_torque",
    source="iso_6336_root",
    keep="below",
    needs="load contact gear",
    needed=False,
)
def mesh_root_stress(kind: Kind, design: Design, results: Results) -> Check:
    """Judge the root stress with the whole force at the tip of one tooth."""
    stress, given = results.ring.root_stress.root_stress_one_pair, design.involute.root_strength
    strength = judged_by(given, "root_strength_unknown", "gear.root_strength", value=stress)
    limit = strength / design.requirements.fatigue_safety
    return kind.judged(
        stress,
        limit,
        reserve=limit / stress,
        error=results.ring.pair.accuracy.relative_error + torque_error(results),
        solved=results.solved,
        limit_source="user",
    )


@_mesh(
    "mesh_ring_root",
    title="Bending of the ring's tooth roots",
    formula="σ_F ≤ σ_FG/S_D",
    why="Above it teeth of the ring break at their roots within the life.",
    inputs="gear.kind",
    fixes=(),
    source="no_source",
    keep="below",
    needed=False,
)
def mesh_ring_root(kind: Kind, design: Design, results: Results) -> Check:
    """Leave the ring's root open, as the fillet of a shaper cutter is not calculated."""
    return Check(kind, "not_checked", reason="internal_root")


_PATH = (
    "gear.kind gear.ring_pin_circle_radius",
    of.OF_CLEARANCE,
    "mechanism.ratio contact.eccentricity gear.ring_pin_radius gear.teeth_difference",
)


def _disc(design: Design) -> CycloidDisc:
    """Cycloid disc; a difference of teeth above 1 cuts off flanks near the tips: not known."""
    lobes, difference = design.lobes, design.gear.teeth_difference or 1
    if difference > 1:
        raise NotKnown("cycloid_difference", difference=difference)
    made = partial(
        design.cycloid.disc, satellite_teeth=lobes, eccentricity=design.known_eccentricity
    )
    return named(design, "gear", made)


@_disc_check(
    "ring_undercut",
    title="Flanks that the ring's pins leave",
    formula="ρ_min/r_m ≥ 1.1",
    why="At 1 and below, the outline loops: its tool would cut off a part of the satellite's "
    "flanks. Slightly above, errors do so.",
    inputs=_PATH,
    fixes="gear.ring_pin_radius gear.ring_pin_circle_radius contact.eccentricity",
    impossible=True,
)
def ring_undercut(kind: Kind, design: Design, results: Results) -> Check:
    if design.lobes < 2:
        return Check(kind, "not_applicable", reason="one_only")
    disc = _disc(design)
    margin, warning = disc.undercut_margin, "near_undercut"
    return _usual(kind, margin, NEAR_UNDERCUT, fails=disc.undercut, warning=warning)


@_disc_check(
    "ring_valley_tool",
    title="Tool in the valleys of the discs",
    unit="mm",
    formula="ρ_v ≥ r_t",
    why="A larger wheel or cutter does not reach the bottom of the valleys.",
    inputs=(_PATH, "gear.tool_radius"),
    fixes="gear.tool_radius gear.ring_pin_radius",
    needed=False,
)
def ring_valley_tool(kind: Kind, design: Design, results: Results) -> Check:
    """Judge the tool radius in concave valleys; not asked without a tool."""
    tool = judged_by(design.cycloid.tool_radius, "no_tool", "gear.tool_radius", status="not_asked")
    concave = _disc(design).min_concave_radius
    if concave is None:
        return Check(kind, "not_applicable", reason="no_valley")
    return kind.judged(concave, tool)


def ring_alone(results: Results) -> str | None:
    """Code that marks a value of each disc alone in its ring, if both meshes are in series."""
    return "ring_alone" if results.in_series else None


@Element("gear", "teeth", "load contact gear")(
    "ring_pressed",
    title="Interference of the teeth without load",
    unit="mm",
    formula="δ ≤ 0",
    why="With it satellites and ring press without load, and go together by force only.",
    inputs=of.TEETH_GAPS,
    fixes=(of.OF_CLEARANCE, "gear.satellite_profile_shift"),
    source="ring_mesh",
    not_of=not_toothed,
    impossible=True,
)
def ring_pressed(kind: Kind, design: Design, results: Results) -> Check:
    if design.gear.kind == "involute":
        if narrow := _refused(kind, results, "ring_profile_shift"):
            return narrow  # the spaces are too narrow for the teeth at any eccentricity
        pair = results.ring.pair
        over = -pair.normal_backlash
        felt = over > AS_TYPED * pair.teeth.module
        return kind.judged(over if felt else 0.0, 0.0)
    try:
        over = results.ring.loading.interference
    except ImpossibleMechanism as why:  # the forces do not exist, and are not needed further
        angle = why.where.get("crank_angle")
        if angle is None or why.code == "cannot_assemble":  # the reason does not concern the teeth
            raise
        own = results.series.teeth if results.in_series else (results.ring.mesh,)
        over = max(teeth.pressing_at(teeth.wave(angle)) for teeth in own)
        if not over > 0:
            raise
        place: dict[str, Any] = why.where | why.params
        said: dict[str, Any] = {"reason": why.code, "params": place, "at": why.where}
        return kind.judged(over, 0.0, **said)
    return kind.judged(over, 0.0, reason=ring_alone(results) or "")


FORCE = (pressure_angle, mesh_possible)
MESH = (mesh_contact_ratio, mesh_tips, mesh_involute, mesh_undercut)
TIPS = (mesh_tip_clearance, mesh_tip_thickness, mesh_root_stress, mesh_ring_root)
RING_PINS = (ring_undercut, ring_valley_tool)
