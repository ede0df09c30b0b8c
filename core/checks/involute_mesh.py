"""Checks of involute teeth of satellite and ring: path of contact, tips, undercut, clearances and
roots; their pressure, for the checks of a ring's load.
"""

from functools import partial
from typing import Any, NamedTuple

from core.checks.check import Check, Kind, design_check, judged, judged_by
from core.checks.crank import other_ring
from core.checks.inputs import (
    INVOLUTE_CUTTER,
    INVOLUTE_LOADED,
    INVOLUTE_RACK,
    INVOLUTE_TEETH,
    SATELLITE_TIPS,
)
from core.design.document import Design
from core.design.results import Results
from core.design.ring import RingKind
from core.errors import NotKnown, required
from core.precision import AS_TYPED
from core.ring.involute import TIPS_APART

LEAST_RATIO = 1.05
"""Least contact ratio of which errors leave enough; 1.1 few pairs of one tooth of difference have.
"""

LEAST_CLEARANCE = 0.15
"""Least usual clearance of a tip, in modules."""

LEAST_TIP = 0.25
"""Least usual thickness of a tip, in modules; hardened through it would break."""

HEIGHTS = tuple(
    f"{body}_{height}" for body in ("satellite", "ring") for height in ("addendum", "tip_radius")
)
"""Inputs that say where tips are."""

INVOLUTE: tuple[RingKind, ...] = ("involute",)

_mesh = partial(
    design_check,
    group="gear",
    part="teeth",
    fixes="gear.satellite_profile_shift gear.satellite_addendum gear.ring_addendum",
    source="involute_mesh",
    needs=("contact", "gear"),
    not_of=partial(other_ring, of=INVOLUTE),
    keep="above",
)


class Pressed(NamedTuple):
    """Contact pressure of a mesh."""

    value: float  # largest, Pa
    error: float  # relative, of number and model
    solved: bool  # whether forces are shared otherwise under other torques
    at: dict[str, Any]  # where it is reached


def involute_pressed(*, results: Results, factor: float) -> Pressed:
    """Largest pressure of involute teeth, at the start of the path.

    Parameters
    ----------
    results : Results
        Results of a design.
    factor : float
        Factor on the torque.

    Returns
    -------
    Pressed

    Raises
    ------
    NotKnown
        If the path starts where the satellite has no involute, or what it hangs on is not known.
    """
    load = results.ring.involute_load(factor)
    pressure = required(load.pressure_start, "off_involutes")
    error = float(load.accuracy.relative_error) + results.ring.satellite_torque_error(factor)
    return Pressed(pressure, error, results.solved, {})


def refused(*, results: Results, kind: Kind, names: tuple[str, ...]) -> Check | None:
    """A check that fails, as no such teeth can be by one of some inputs of the ring.

    Parameters
    ----------
    results : Results
        Results of a design.
    kind : Kind
        Which check.
    names : tuple of str
        Inputs that are refused beyond a limit.

    Returns
    -------
    Check or None
        None where they are not.
    """
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
    kind: Kind, value: float, *, least: float, guide: float, impossible: bool = False
) -> Check:
    """A value that has to be there, and is marginal below a guide."""
    if value < least - AS_TYPED:
        return judged(kind, value, guide)._replace(impossible=impossible)
    found = judged(kind, value, guide, warning="less_than_usual")
    return found._replace(limit_source="guide")


@_mesh(
    "mesh_contact_ratio",
    title="Contact ratio of the teeth",
    formula="ε_α ≥ 1.05",
    why="Below 1 no pair is in contact at times, and the motion is not handed on. Slightly above, "
    "errors do so.",
    inputs=INVOLUTE_TEETH,
)
def mesh_contact_ratio(kind: Kind, design: Design, results: Results) -> Check:
    ratio = results.ring.pair.contact_ratio
    return _usual(kind, ratio, least=1.0, guide=LEAST_RATIO)


@_mesh(
    "mesh_tips",
    title="Tips that pass each other",
    formula="G ≥ 0.05",
    why="Below 0 the tips run into each other beside the path of contact: the teeth cannot turn. "
    "Slightly above, errors do so.",
    inputs=INVOLUTE_TEETH,
)
def mesh_tips(kind: Kind, design: Design, results: Results) -> Check:
    """Where the tips overlap all round nothing is measured: no tooth can pass."""
    pair = results.ring.pair
    if pair.tips_overlap_all_round:
        return Check(kind, "fail", limit=TIPS_APART, impossible=True, reason="tips_overlap")
    if pair.tip_interference is None:
        return Check(kind, "not_applicable", reason="no_crossing")
    return _usual(kind, pair.tip_interference, least=0.0, guide=TIPS_APART, impossible=True)


@_mesh(
    "mesh_involute",
    title="Contact on involutes only",
    formula="tan α₁ ≥ tan α_F",
    why="Otherwise a tip of one runs into the fillet of the other.",
    inputs=(INVOLUTE_TEETH, INVOLUTE_RACK, INVOLUTE_CUTTER),
)
def mesh_involute(kind: Kind, design: Design, results: Results) -> Check:
    """Of the satellite's flanks, and of the ring's where its cutter is known."""
    if within := refused(results=results, kind=kind, names=HEIGHTS):
        return within  # a tip that lies within its base circle
    pair = results.ring.pair
    of_ring = pair.ring_flank.form_roll - pair.end_roll_ring
    value = min(pair.start_roll - pair.form_roll_satellite, of_ring)
    found = judged(kind, 0.0 if abs(value) <= AS_TYPED else value, 0.0)
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
        INVOLUTE_RACK,
    ),
    fixes="gear.satellite_profile_shift",
)
def mesh_undercut(kind: Kind, design: Design, results: Results) -> Check:
    value = results.ring.pair.form_roll_satellite
    return judged(kind, 0.0 if abs(value) <= AS_TYPED else value, 0.0)


@_mesh(
    "mesh_tip_clearance",
    title="Clearance of the tips",
    formula="c/m ≥ 0.15",
    why="Below 0 tips run into the roots of the others. Slightly above, errors do so.",
    inputs=(INVOLUTE_TEETH, "gear.dedendum", INVOLUTE_CUTTER),
)
def mesh_tip_clearance(kind: Kind, design: Design, results: Results) -> Check:
    """Of a ring whose cutter is not known with the root that the hob's dedendum gives it."""
    pair = results.ring.pair
    least = min(pair.tip_clearance_satellite, pair.tip_clearance_ring) / pair.teeth.module
    found = _usual(kind, least, least=0.0, guide=LEAST_CLEARANCE, impossible=True)
    if pair.teeth.cutter or found.reason or found.status == "fail":
        return found
    return found._replace(reason="ring_root_assumed", missing=("gear.cutter_teeth",))


@_mesh(
    "mesh_tip_thickness",
    title="Thickness of the tips",
    formula="s_a/m ≥ 0.25",
    why="Below 0 the teeth are pointed and shorter than they are meant to be. Slightly above, the "
    "tips break.",
    inputs=tuple(each for each in INVOLUTE_TEETH if each != "contact.eccentricity"),
)
def mesh_tip_thickness(kind: Kind, design: Design, results: Results) -> Check:
    pair = results.ring.pair
    thin = min(pair.satellite_tip_thickness, pair.ring_tip_thickness) / pair.teeth.module
    return _usual(kind, thin, least=0.0, guide=LEAST_TIP, impossible=True)


@_mesh(
    "mesh_root_stress",
    title="Bending of the satellite's tooth roots",
    unit="MPa",
    formula="K·σ_F ≤ σ_FG/S_D",
    why="Above it teeth of the satellites break at their roots within the life.",
    inputs=(
        INVOLUTE_LOADED,
        SATELLITE_TIPS,
        INVOLUTE_RACK,
        "gear.root_strength requirements.fatigue_safety",
    ),
    fixes="gear.contact_length load.output_torque",
    source="iso_6336_root",
    keep="below",
    needs=("load", "contact", "gear"),
    needed=False,
)
def mesh_root_stress(kind: Kind, design: Design, results: Results) -> Check:
    """The whole force at the tip of one tooth."""
    stress, given = results.ring.root_stress.stress, design.involute.root_strength
    strength = judged_by(given, "root_strength_unknown", "gear.root_strength", value=stress)
    limit = strength / design.requirements.fatigue_safety
    factor = design.load_factor
    return judged(
        kind,
        stress,
        limit,
        reserve=limit / stress,
        error=results.ring.pair.accuracy.relative_error
        + results.ring.satellite_torque_error(factor),
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
    """Not known: a shaper's fillet, and the section where it breaks, are not calculated."""
    return Check(kind, "not_checked", reason="internal_root")


INVOLUTE_MESH = (
    mesh_contact_ratio,
    mesh_tips,
    mesh_involute,
    mesh_undercut,
    mesh_tip_clearance,
    mesh_tip_thickness,
    mesh_root_stress,
    mesh_ring_root,
)
