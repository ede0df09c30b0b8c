"""Checks of rolling bearings as rollers on the pins: life, load, speed, room, tilt."""

import math
from functools import partial
from itertools import pairwise

from core.checks.check import Check, Kind, design_check, judged, judged_by
from core.checks.crank import static_safety
from core.checks.inputs import FORCES, LIFE, LOADED
from core.crank.bearing_life import EXPONENTS
from core.crank.pin_rollers import KINDS, MIN_LOAD, TILT
from core.design.document import Design
from core.design.results import Results
from core.errors import NotKnown, required

_SHARES = ("rollers.kind", "rollers.ratings", "rollers.rolling_elements")

_FIXES = ("load.pin_circle_radius", "mechanism.pins", "load.output_torque")

_PEAK = (*LOADED, "load.peak_torque")

_check = partial(
    design_check,
    group="pin_rollers",
    part="contact",
    needs=("touching", "load", "rollers"),
)


@_check(
    "pin_roller_life",
    title="Life of the rollers on the pins",
    unit="h",
    formula="L_10h ≥ L",
    why="Otherwise a roller fails before the life that is asked.",
    inputs=(FORCES, LIFE, _SHARES, "rollers.dynamic_rating"),
    fixes=("rollers.dynamic_rating load.input_speed", _FIXES),
    source="roller_rating",
    keep="above",
    known=lambda design, results: {"limit": design.life},
    requires={"rollers.dynamic_rating": "rating_unknown"},
)
def pin_roller_life(kind: Kind, design: Design, results: Results) -> Check:
    design.known_speed  # noqa: B018 - of which the life is a matter
    found, power = results.roller_loads, EXPONENTS[KINDS[design.rollers.kind]]
    limit, value = design.life, found.life
    return judged(
        kind,
        value,
        limit,
        reserve=(value / limit) ** (1 / power),
        error=4 * power * found.accuracy.relative_error,
        solved=results.solved,
        at={"satellite": found.satellite, "pin": found.pin},
    )


def _static_limit(design: Design) -> float:
    """Static safety that is asked, or usual."""
    return static_safety(design=design, kind=KINDS[design.rollers.kind])


@_check(
    "pin_roller_static",
    title="Static load of the rollers on the pins",
    formula="C₀w/F_max ≥ S_0",
    why="Otherwise rolling elements dent their tracks.",
    inputs=(_PEAK, _SHARES, "load.peak_kind rollers.static_rating requirements.static_safety"),
    fixes=("rollers.static_rating", _FIXES, "load.peak_torque"),
    source="roller_rating",
    keep="above",
    known=lambda design, results: {"limit": _static_limit(design)},
    requires={"rollers.static_rating": "rating_unknown"},
)
def pin_roller_static(kind: Kind, design: Design, results: Results) -> Check:
    found, limit = results.roller_loads, _static_limit(design)
    value = found.static_safety_factor
    return judged(
        kind,
        value,
        limit,
        reserve=value / limit,
        error=4 * found.accuracy.relative_error,
        solved=results.solved,
        limit_source="" if design.requirements.static_safety else "static_guide",
    )


@_check(
    "pin_roller_max_load",
    title="Largest load of the rollers on the pins",
    formula="F·K_A/F_r, F_max/F_0r ≤ 1",
    why="Above it the outer ring, which nothing supports, breaks by bending.",
    inputs=(_PEAK, "rollers.max_radial_load rollers.max_static_radial_load"),
    fixes=(_FIXES, "load.peak_torque"),
    source="user",
)
def pin_roller_max_load(kind: Kind, design: Design, results: Results) -> Check:
    own, found = design.rollers, results.roller_loads
    value = max(
        found.peak_load * design.load_factor / own.max_radial_load,
        found.static_load / own.max_static_radial_load,
    )
    if value == 0:
        missing = ("rollers.max_radial_load", "rollers.max_static_radial_load")
        return Check(kind, "not_asked", reason="no_limit", missing=missing)
    return judged(
        kind,
        value,
        1.0,
        reserve=1 / value,
        error=4 * found.accuracy.relative_error,
        solved=results.solved,
    )


@_check(
    "pin_roller_min_load",
    title="Least load of the rollers on the pins",
    unit="N",
    formula="F ≥ 0.0167·C₀",
    why="Below it outer rings slide in the holes before they roll.",
    inputs=(FORCES, "rollers.static_rating"),
    source="track_rollers",
    keep="above",
    needed=False,
)
def pin_roller_min_load(kind: Kind, design: Design, results: Results) -> Check:
    """Of the largest load over the turn: half of it no roller is loaded."""
    name = "rollers.static_rating"
    rating = required(design.rollers.static_rating, "rating_unknown", name)
    found = results.roller_loads
    return judged(
        kind,
        found.peak_load,
        MIN_LOAD * rating,
        error=4 * found.accuracy.relative_error,
        warning="bearing_slips",
    )


@_check(
    "pin_roller_speed",
    title="Speed of the rollers on the pins",
    unit="rpm",
    formula="n·e/r_s ≤ n_lim",
    why="Above it the roller gets too hot.",
    inputs=(
        "load.input_speed mechanism.ratio contact.eccentricity contact.pin_radius",
        "rollers.limiting_speed",
    ),
    fixes="load.input_speed",
    source="user",
    needed=False,
)
def pin_roller_speed(kind: Kind, design: Design, results: Results) -> Check:
    turned = design.known_eccentricity / design.pair.pin_radius
    value = design.known_speeds.turning * design.built.waves_per_turn * turned
    said = {"value": value, "status": "not_asked"}
    speed = design.rollers.limiting_speed
    limit = judged_by(speed, "no_limit", "rollers.limiting_speed", **said)
    return judged(kind, value, limit)


@_check(
    "pin_roller_fits",
    title="Room for the rollers along the pins",
    unit="mm",
    formula="n·B ≤ |z_j − z_k|, b",
    why="Otherwise rollers of neighbouring satellites lie in each other.",
    inputs="rollers.width rollers.per_satellite pin.satellite_positions contact.contact_length",
    keep="above",
)
def pin_roller_fits(kind: Kind, design: Design, results: Results) -> Check:
    """Between satellites, where their places are given; wider than them they stand out."""
    length = design.rollers.length
    if math.isinf(length):
        raise NotKnown("size_missing", "rollers.width")
    places = sorted(design.pin.satellite_positions) if design.pin else []
    pitch = min((other - one for one, other in pairwise(places)), default=math.inf)
    width = design.nominal_pair.contact_length
    found = judged(kind, min(pitch, max(width, length)) - length, 0.0)
    if found.status == "fail":
        return found._replace(impossible=True)
    if length > width:
        return found._replace(status="marginal", warning=True, reason="wider_than_satellite")
    return found


@_check(
    "pin_roller_tilt",
    title="Slope of the pins in their rollers",
    unit="mrad",
    formula="θ ≤ θ_max",
    why="Above it rolling elements carry on their ends, and last less than the formula says.",
    inputs=(LOADED, "rollers.kind"),
    source="tilt_guide",
    needs=("touching", "load", "rollers", "pin"),
    needed=False,
)
def pin_roller_tilt(kind: Kind, design: Design, results: Results) -> Check:
    found = results.pin_loads
    return judged(
        kind,
        found.deflection.slope,
        TILT[design.rollers.kind],
        error=4 * found.accuracy.relative_error,
        warning="roller_tilted",
        at={"satellite": found.deflection.slope_satellite},
    )


PIN_ROLLERS = (
    pin_roller_life,
    pin_roller_static,
    pin_roller_max_load,
    pin_roller_min_load,
    pin_roller_speed,
    pin_roller_fits,
    pin_roller_tilt,
)
