"""Checks of the crank: ring, bearings of the satellites, crankshaft."""

import math
from functools import partial
from typing import Any

import numpy as np

from core.checks.body import within_roots
from core.checks.check import Check, Kind, design_check, judged
from core.checks.inputs import BEARING_LOAD, LIFE, OF_DISCS, RING, ROOTS
from core.crank.bearing_life import EXPONENTS, PEAK_SAFETY, STATIC_SAFETY, Bearing
from core.crank.ring_mesh import STEEP
from core.design.document import Design
from core.design.results import Results
from core.design.ring import RingKind
from core.errors import NotKnown, if_known, required
from core.ring.involute import MOST_DIFFERENCE, STANDARD_ANGLES, usual_rack
from core.ring.possible_teeth import possible_teeth

_LIFE_FIXES = (
    "bearing.dynamic_rating",
    "load.pin_circle_radius",
    "load.input_speed",
    "load.output_torque",
)

_gear = partial(design_check, group="gear", part="teeth", needs=("touching", "load", "gear"))
_bearing = partial(
    design_check,
    group="bearing",
    part="satellite_bearing",
    keep="above",
    needs=("touching", "load", "bearing"),
)
_shaft = partial(
    design_check,
    group="crankshaft",
    part="crank_bearings",
    needs=("touching", "load", "crankshaft"),
)

NOT_OF: dict[RingKind, str] = {"involute": "no_involute", "cycloid": "no_ring_pins"}
"""Why a check is not one of a ring, by the kind that it is of."""


def other_ring(design: Design, results: Results, *, of: tuple[RingKind, ...]) -> str:
    """Why a check is none of the ring of a design.

    Parameters
    ----------
    design : Design
        The design.
    results : Results
        Its results.
    of : tuple of {"involute", "cycloid"}
        Kinds of ring that the check is of, the one first that it says.

    Returns
    -------
    str
        A code; empty where it is of this ring, which can be.
    """
    own = design.gear.kind
    if own not in of:
        return NOT_OF[of[0]]
    if own == "cycloid":
        _ = results.ring.force  # which refuses a disc whose path crosses itself
    return ""


@_gear(
    "pressure_angle",
    title="Operating pressure angle",
    unit="deg",
    formula="α_w ≤ 55°",
    why="Above it the ring loads the bearings far more than the torque needs.",
    inputs=(RING, "contact.eccentricity"),
    fixes="gear.module",
    source="steep",
)
def pressure_angle(kind: Kind, design: Design, results: Results) -> Check:
    if_known(lambda: results.ring.force)  # a ring that cannot be is refused, of whatever kind
    if design.gear and design.gear.kind != "involute":
        return Check(kind, "not_applicable", reason="no_involute")
    angle = results.ring.force.operating_pressure_angle
    return judged(kind, float(angle), STEEP, warning="steep_mesh")


@_gear(
    "mesh_possible",
    title="Teeth that can mesh",
    formula="ε_α,max ≥ 1",
    why="Otherwise teeth of this module do not mesh at this eccentricity, whatever their heights "
    "and shifts.",
    inputs=(
        "gear.kind gear.module gear.teeth_difference gear.reference_pressure_angle mechanism.ratio",
        "contact.eccentricity",
    ),
    fixes="gear.module",
    source="teeth_tried",
    keep="above",
    needs=("contact", "gear"),
    not_of=partial(other_ring, of=("involute",)),
)
def mesh_possible(kind: Kind, design: Design, results: Results) -> Check:
    gear = design.involute
    eccentricity, _ = design.known_eccentricity, results.ring.force  # which refuses base circles
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
    check = judged(kind, found.contact_ratio, 1.0, impossible=not found.any_mesh)
    if check.status == "fail" and found.any_mesh:
        return check._replace(status="marginal", reason="unusual_teeth")
    return check


@_gear(
    "gear_room",
    part="body",
    title="Holes within the teeth",
    unit="mm",
    formula="r_f − R − r_out > 0",
    why="Otherwise the holes lie in the teeth of the satellite, or beyond.",
    inputs=(ROOTS, "load.pin_circle_radius contact.hole_radius"),
    fixes=(
        "load.pin_circle_radius contact.pin_radius gear.ring_pin_circle_radius",
        "gear.ring_pin_radius",
    ),
    keep="above",
)
def gear_room(kind: Kind, design: Design, results: Results) -> Check:
    if design.gear.kind not in ("involute", "cycloid"):
        return Check(kind, "not_applicable", reason="no_teeth")
    return within_roots(design=design, kind=kind)


def _required_life(design: Design, results: Results) -> dict[str, Any]:
    return {"limit": design.life}


@_bearing(
    "bearing_life",
    title="Life of the satellites' bearings",
    unit="h",
    formula="L_nh ≥ L",
    why="Otherwise a bearing of a satellite fails before the life that is asked.",
    inputs=(
        BEARING_LOAD,
        LIFE,
        "bearing.ring_factor bearing.dynamic_rating bearing.reliability_percent",
    ),
    fixes=_LIFE_FIXES,
    source="iso_281_life",
    known=_required_life,
)
def bearing_life(kind: Kind, design: Design, results: Results) -> Check:
    found, limit = results.crank.bearings, design.life
    if found.given_speed == 0:
        return Check(kind, "not_applicable", limit=limit, reason="members_locked")
    lives, power = found.life, EXPONENTS[design.bearing.kind]
    worst = int(np.argmin(lives))
    value = float(lives[worst])
    return judged(
        kind,
        value,
        limit,
        reserve=(value / limit) ** (1 / power),
        error=4 * power * float(found.accuracy.relative_error),
        solved=results.crank.uneven_growth,
        at={"satellite": worst + 1},
    )


def static_safety(*, design: Design, kind: Bearing) -> float:
    """Static safety of bearings that is asked, or usual.

    Parameters
    ----------
    design : Design
        The design.
    kind : {"ball", "roller"}
        Their rolling elements.

    Returns
    -------
    float
    """
    asked, load = design.requirements.static_safety, design.load
    usual = STATIC_SAFETY[kind]
    if load.peak_torque is not None:
        usual = PEAK_SAFETY[load.peak_kind]
    return asked or usual


def _required_safety(design: Design, results: Results) -> dict[str, Any]:
    return {"limit": static_safety(design=design, kind=design.bearing.kind)}


@_bearing(
    "bearing_static",
    title="Static load of the satellites' bearings",
    formula="C₀/Q_max ≥ S_0",
    why="Otherwise rolling elements dent their tracks.",
    inputs=(
        BEARING_LOAD,
        "load.input_speed contact.dynamic_factor load.application_factor load.peak_torque",
        "load.peak_kind bearing.static_rating requirements.static_safety",
    ),
    fixes="bearing.static_rating load.pin_circle_radius load.output_torque load.peak_torque",
    source="iso_76_rating",
    known=_required_safety,
)
def bearing_static(kind: Kind, design: Design, results: Results) -> Check:
    found, limit = results.crank.bearings, _required_safety(design, results)["limit"]
    safety = found.static_safety_factor
    worst = int(np.argmin(safety))
    value, error = float(safety[worst]), float(found.accuracy.relative_error)
    return judged(
        kind,
        value,
        limit,
        reserve=value / limit,
        error=4 * error,
        solved=results.crank.uneven_growth,
        limit_source="" if design.requirements.static_safety else "static_guide",
        at={"satellite": worst + 1},
    )


@_bearing(
    "system_life",
    title="Life of all satellites' bearings together",
    unit="h",
    formula="(Σ L_j^−β)^(−1/β) ≥ L",
    why="Otherwise one of the bearings fails before the life that is asked.",
    inputs=(
        BEARING_LOAD,
        LIFE,
        "bearing.ring_factor bearing.dynamic_rating bearing.reliability_percent",
        "bearing.weibull_slope",
    ),
    fixes=_LIFE_FIXES,
    source="iso_281_life",
    known=_required_life,
    not_of=lambda design, results: "one_only" if design.mechanism.satellites == 1 else "",
    requires={"bearing.weibull_slope": ""},
    demands=("bearing.weibull_slope",),
)
def system_life(kind: Kind, design: Design, results: Results) -> Check:
    limit = design.life
    found, power = results.crank.bearings, EXPONENTS[design.bearing.kind]
    if found.given_speed == 0:
        return Check(kind, "not_applicable", limit=limit, reason="members_locked")
    value = float(found.system_life)
    error = 4 * power * float(found.accuracy.relative_error)
    reserve = (value / limit) ** (1 / power)
    solved = results.crank.uneven_growth
    return judged(kind, value, limit, reserve=reserve, error=error, solved=solved)


@_shaft(
    "crank_bearing_life",
    title="Life of the crankshaft's bearings",
    unit="h",
    formula="L_10h ≥ L",
    why="Otherwise a bearing of the crankshaft fails before the life that is asked.",
    inputs=(
        OF_DISCS,
        LIFE,
        "crankshaft.satellite_mass crankshaft.bearings crankshaft.satellite_positions",
        "crankshaft.bearing_positions crankshaft.counterweights",
    ),
    fixes=(
        "crankshaft.bearings.dynamic_rating load.pin_circle_radius load.input_speed",
        "load.output_torque",
    ),
    source="iso_281_life",
    keep="above",
    known=_required_life,
)
def crank_bearing_life(kind: Kind, design: Design, results: Results) -> Check:
    limit = design.life
    bearings = design.crankshaft.known_bearings
    for each in bearings:
        required(each.dynamic_rating, "rating_unknown", "crankshaft.bearings")
    found = results.crank.shaft
    if not any(design.known_speeds.against(each.seat) for each in bearings):
        return Check(kind, "not_applicable", limit=limit, reason="members_locked")
    lives = [found.basic_life.get(row, math.inf) for row in (0, 1)]
    if math.isinf(min(lives)):
        return Check(kind, "not_applicable", limit=limit, reason="unloaded")
    powers = [EXPONENTS[each.kind] for each in bearings]
    value, worst = min(zip(lives, (1, 2), strict=True))
    reserves = [(life / limit) ** (1 / power) for life, power in zip(lives, powers, strict=True)]
    return judged(
        kind,
        value,
        limit,
        reserve=min(reserves),
        error=4 * max(powers) * float(found.accuracy.relative_error),
        solved=results.crank.uneven_growth,
        at={"bearing": worst},
    )


CRANK = (
    pressure_angle,
    mesh_possible,
    gear_room,
    bearing_life,
    bearing_static,
    system_life,
    crank_bearing_life,
)
