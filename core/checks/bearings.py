"""Checks of rolling bearings of the satellites, of the crankshaft, and as rollers on the pins.

Each sort of check is written once, as common fields of its records and a function; a row for each
place has the codes.
"""

import math
from collections.abc import Iterable, Mapping, Sequence
from itertools import pairwise
from typing import Any

import numpy as np

from core.checks import inputs as of
from core.checks.check import Check, Element, Kind
from core.crank import pin_rollers
from core.crank.bearing_life import EXPONENTS, PEAK_SAFETY, STATIC_SAFETY, Bearing
from core.crank.envelope import (
    HIGH,
    IMPOSSIBLE,
    LOW,
    MIN_LOAD,
    MOST_DYNAMIC,
    MOST_STATIC,
    Bounds,
    largest_ratings,
    largest_ratings_of_room,
)
from core.design.document import Design
from core.design.results import Results
from core.design.sections import CatalogueBearing
from core.errors import Accuracy, NotKnown, required

PRESSED = 1e-4
"""Excess of a bearing's outside over its seat that can be pressed in, m."""

_SORTS: dict[str, dict[str, Any]] = {
    "life": {
        "title": "Life of {them}",
        "unit": "h",
        "why": "Otherwise {one} fails before the life that is asked.",
        "source": "iso_281_life",
        "keep": "above",
        "known": lambda design, results: {"limit": design.life},
    },
    "static": {
        "title": "Static load of {them}",
        "why": "Otherwise rolling elements dent their tracks.",
        "keep": "above",
    },
    "ratings": {
        "title": "Ratings of {them}",
        "why": "There is no bearing of these sizes that carries so much.",
        "source": "envelope",
        "impossible": True,
    },
    "room": {"unit": "mm", "keep": "above", "impossible": True},
    "speed": {"title": "Speed of {them}", "unit": "rpm", "source": "user", "needed": False},
    "least": {"title": "Least load of {them}", "unit": "N", "keep": "above", "needed": False},
}
_SORTS["system"] = _SORTS["life"]

SATELLITE = Element(
    "bearing",
    "satellite_bearing",
    "touching load bearing",
    codes=(
        "life=bearing_life system=system_life static=bearing_static ratings=bearing_rating",
        "room=bearing_fits speed=bearing_speed least=bearing_min_load most=bearing_overload",
    ),
    sorts=_SORTS,
    words={"them": "the satellites' bearings", "one": "a bearing of a satellite"},
)
CRANKSHAFT = Element(
    "crankshaft",
    "crank_bearings",
    "touching load crankshaft",
    codes=(
        "life=crank_bearing_life static=crank_bearing_static ratings=crank_bearing_rating",
        "room=crank_bearing_fits",
        "speed=crank_bearing_speed",
    ),
    sorts=_SORTS,
    words={"them": "the crankshaft's bearings", "one": "a bearing of the crankshaft"},
)
ROLLERS = Element(
    "pin_rollers",
    "contact",
    "touching load rollers",
    codes=(
        "life=pin_roller_life static=pin_roller_static room=pin_roller_fits tilt=pin_roller_tilt",
        "speed=pin_roller_speed least=pin_roller_min_load most=pin_roller_max_load",
    ),
    sorts=_SORTS,
    words={"them": "the rollers on the pins", "one": "a roller"},
)

ROWS = (SATELLITE, CRANKSHAFT, ROLLERS)


_Life = tuple[float, float, Mapping[str, Any]]
"""Life in s, its exponent over the load, and its place."""

_PLACES = "load.pin_circle_radius load.input_speed load.output_torque"


def _lasting(
    kind: Kind, limit: float, lives: Sequence[_Life], accuracy: Accuracy, *, solved: bool
) -> Check:
    """Check of the shortest of several lives."""
    value, _, at = min(lives, key=lambda each: each[0])
    reserve = min((life / limit) ** (1 / power) for life, power, _ in lives)
    error = 4 * max(power for _, power, _ in lives) * float(accuracy.relative_error)
    return kind.judged(value, limit, reserve=reserve, error=error, solved=solved, at=at)


def _static_safety(design: Design, elements: Bearing) -> float:
    """Static safety of bearings that is requested, or usual for their rolling elements."""
    asked, load = design.requirements.static_safety, design.load
    usual = STATIC_SAFETY[elements]
    if load.peak_torque is not None:
        usual = PEAK_SAFETY[load.peak_kind]
    return asked or usual


def _safe(kind: Kind, results: Results, value: float, *, limit: float, **more: Any) -> Check:
    """Check of a static safety against a limit, requested or usual."""
    source = "" if results.design.requirements.static_safety else "static_guide"
    return kind.judged(value, limit, reserve=value / limit, limit_source=source, **more)


def _turning(kind: Kind, path: str, speeds: Iterable[tuple[float, float | None]]) -> Check:
    """Check of speeds against their limits, as far as limits are given."""
    each = list(speeds)
    limited = [(speed, limit) for speed, limit in each if limit is not None]
    if not limited:
        value = max(speed for speed, _ in each)
        return Check(kind, "not_asked", value=value, reason="no_limit", missing=(path,))
    speed, limit = max(limited, key=lambda one: one[0] / one[1])
    return kind.judged(speed, limit)


def _fitting(kind: Kind, room: float, *, wide: bool) -> Check:
    """Check of the room for a bearing; one wider than its satellite (`wide`) is marginal."""
    found = kind.judged(room, 0.0)
    if found.status == "fail" or not wide:
        return found
    return found._replace(status="marginal", warning=True, reason="wider_than_satellite")


def _possible(kind: Kind, bearing: CatalogueBearing, bounds: Bounds, **more: Any) -> Check:
    """Check of the larger rating over the largest that such a bearing can have."""
    given = ((bearing.dynamic_rating, bounds.dynamic), (bearing.static_rating, bounds.static))
    shares = [rating / bound for rating, bound in given if rating is not None]
    if not shares:
        raise NotKnown("rating_unknown", "bearing.dynamic_rating")
    share = max(shares)
    found = kind.judged(share, IMPOSSIBLE[bearing.kind], **more)
    if found.status == "fail" or LOW <= share <= HIGH[bearing.kind]:
        return found
    reason = "rating_low" if share < LOW else "rating_high"
    return found._replace(status="marginal", warning=True, reason=reason)


def _known_sizes(bearing: CatalogueBearing, *paths: str) -> tuple[float, ...]:
    """Bore, outer diameter and width of a bearing, m; `NotKnown` unless all are given."""
    if not bearing.sizes:
        raise NotKnown("envelope_unknown", *paths)
    return bearing.sizes


def _largest(bearing: CatalogueBearing, *paths: str) -> Bounds:
    """Largest ratings of a bearing by its sizes; `NotKnown` unless all are given."""
    bore, outer, width = _known_sizes(bearing, *paths)
    return largest_ratings(kind=bearing.kind, bore_diameter=bore, outer_diameter=outer, width=width)


_SIZES = ("bearing.bore_diameter", "bearing.outer_diameter", "bearing.width")

_SEAT = (
    _SIZES,
    "satellite_body.bore_radius contact.contact_length contact.eccentricity",
    "crankshaft.eccentric_diameter crankshaft.shaft_diameter",
)
"""Inputs of the satellite bearings and the room for them."""


def _seat(design: Design) -> float:
    """Diameter of the seat of the satellite bearings, m; infinite if it is not given."""
    body = design.satellite_body
    return 2 * body.bore_radius if body and body.bore_radius is not None else math.inf


def _least_bore(design: Design) -> float:
    """Least bore of the satellite bearings, m: the eccentric, or the circle around the shaft."""
    shaft = design.crankshaft
    if shaft and shaft.eccentric_diameter is not None:
        return float(shaft.eccentric_diameter)
    inside = (shaft.shaft_diameter or 0.0) if shaft else 0.0
    return float(inside + 2 * design.known_eccentricity)


@SATELLITE.check(
    "life",
    formula="L_nh ≥ L",
    inputs=(
        of.BEARING_LOAD,
        of.LIFE,
        "bearing.ring_factor bearing.dynamic_rating bearing.reliability_percent",
    ),
    fixes=("bearing.name bearing.dynamic_rating", _PLACES),
)
def bearing_life(kind: Kind, design: Design, results: Results) -> Check:
    found, limit = results.crank.bearings, design.life
    if found.given_speed == 0:
        return Check(kind, "not_applicable", limit=limit, reason="members_locked")
    power, lives = EXPONENTS[design.bearing.kind], enumerate(found.life.tolist(), 1)
    each = [(life, power, {"satellite": place}) for place, life in lives]
    return _lasting(kind, limit, each, found.accuracy, solved=results.crank.uneven_growth)


@SATELLITE.check(
    "static",
    formula="C₀/Q_max ≥ S_0",
    inputs=(
        of.BEARING_LOAD,
        "load.input_speed",
        of.ON_STRESSES,
        "load.peak_torque load.peak_kind bearing.static_rating requirements.static_safety",
    ),
    fixes=(
        "bearing.name bearing.static_rating load.pin_circle_radius",
        "load.output_torque load.peak_torque",
    ),
    source="iso_76_rating",
    known=lambda design, results: {"limit": _static_safety(design, design.bearing.kind)},
)
def bearing_static(kind: Kind, design: Design, results: Results) -> Check:
    found = results.crank.bearings
    safety = found.static_safety_factor
    worst = int(np.argmin(safety))
    return _safe(
        kind,
        results,
        float(safety[worst]),
        limit=_static_safety(design, design.bearing.kind),
        error=4 * float(found.accuracy.relative_error),
        solved=results.crank.uneven_growth,
        at={"satellite": worst + 1},
    )


@SATELLITE.check(
    "system",
    title="Life of all satellites' bearings together",
    formula="(Σ L_j^−β)^(−1/β) ≥ L",
    why="Otherwise one of the bearings fails before the life that is asked.",
    inputs=(bearing_life.inputs, "bearing.weibull_slope"),
    fixes=bearing_life.fixes,
    not_of=lambda design, results: "one_only" if design.mechanism.satellites == 1 else "",
    requires={"bearing.weibull_slope": ""},
    demands=("bearing.weibull_slope",),
)
def system_life(kind: Kind, design: Design, results: Results) -> Check:
    limit, found = design.life, results.crank.bearings
    if found.given_speed == 0:
        return Check(kind, "not_applicable", limit=limit, reason="members_locked")
    life: _Life = (float(found.system_life), EXPONENTS[design.bearing.kind], {})
    return _lasting(kind, limit, [life], found.accuracy, solved=results.crank.uneven_growth)


@CRANKSHAFT.check(
    "life",
    formula="L_10h ≥ L",
    inputs=(
        of.OF_DISCS,
        of.LIFE,
        "crankshaft.satellite_mass crankshaft.bearings crankshaft.satellite_positions",
        "crankshaft.bearing_positions crankshaft.counterweights",
    ),
    fixes=("crankshaft.bearings.name crankshaft.bearings.dynamic_rating", _PLACES),
)
def crank_bearing_life(kind: Kind, design: Design, results: Results) -> Check:
    limit, bearings = design.life, design.crankshaft.known_bearings
    for each in bearings:
        required(each.dynamic_rating, "rating_unknown", "crankshaft.bearings")
    found = results.crank.shaft
    if not any(design.known_speeds.against(each.seat) for each in bearings):
        return Check(kind, "not_applicable", limit=limit, reason="members_locked")
    lives = [
        (found.basic_life.get(row, math.inf), EXPONENTS[each.kind], {"bearing": row + 1})
        for row, each in enumerate(bearings)
    ]
    if all(math.isinf(life) for life, _, _ in lives):
        return Check(kind, "not_applicable", limit=limit, reason="unloaded")
    return _lasting(kind, limit, lives, found.accuracy, solved=results.crank.uneven_growth)


@CRANKSHAFT.check(
    "static",
    formula="C₀/R_max ≥ S_0",
    inputs=(
        tuple(name for name in crank_bearing_life.inputs if name not in of.LIFE),
        of.ON_STRESSES,
        "load.input_speed load.peak_torque load.peak_kind requirements.static_safety",
    ),
    fixes="crankshaft.bearings.name load.pin_circle_radius load.output_torque load.peak_torque",
    source="iso_76_rating",
    needed=False,
)
def crank_bearing_static(kind: Kind, design: Design, results: Results) -> Check:
    bearings, path = design.crankshaft.known_bearings, "crankshaft.bearings"
    ratings = [required(each.static_rating, "rating_unknown", path) for each in bearings]
    limits = [_static_safety(design, each.kind) for each in bearings]
    found = results.crank.static_reactions
    carried = np.where(found > 0, np.array(ratings) / np.where(found > 0, found, 1.0), math.inf)
    worst = int(np.argmin(carried / limits))
    if math.isinf(carried[worst]):
        return Check(kind, "not_applicable", limit=limits[worst], reason="unloaded")
    return _safe(
        kind,
        results,
        float(carried[worst]),
        limit=limits[worst],
        error=4 * float(results.crank.shaft.accuracy.relative_error),
        solved=results.crank.uneven_growth,
        at={"bearing": worst + 1},
    )


@SATELLITE.check(
    "ratings",
    formula="C/C_max, C₀/C₀_max ≤ q",
    inputs=("bearing.kind bearing.dynamic_rating bearing.static_rating", _SEAT),
)
def bearing_rating(kind: Kind, design: Design, results: Results) -> Check:
    """Judge ratings by the sizes of the bearing, or else by the room for it."""
    bearing, outer = design.bearing, _seat(design)
    least = _least_bore(design) if not bearing.sizes and math.isfinite(outer) else math.inf
    if not least < outer:
        return _possible(kind, bearing, _largest(bearing, *_SIZES))
    bounds = largest_ratings_of_room(
        kind=bearing.kind,
        least_bore=least,
        outer_diameter=outer,
        width=design.nominal_pair.contact_length,
    )
    found = _possible(kind, bearing, bounds)
    return found if found.reason else found._replace(reason="envelope_unknown", missing=_SIZES)


@SATELLITE.check(
    "room",
    title="Room for {them}",
    formula="D ≤ 2·r_b, d ≥ d_shaft + 2·e, B ≤ b",
    why="Otherwise the bearing does not go onto its eccentric, or into the satellite.",
    inputs=_SEAT,
    fixes="satellite_body.bore_radius",
    needed=False,
)
def bearing_fits(kind: Kind, design: Design, results: Results) -> Check:
    """Judge the room by the sizes of the bearing; without sizes only a lack of room is found."""
    least, seat, bearing = _least_bore(design), _seat(design), design.bearing
    room = seat - least
    if bearing.sizes or seat > least:
        bore, outer, _ = _known_sizes(bearing, *_SIZES)
        room = min(bore - least, seat + PRESSED - outer)
    wide = (bearing.width or 0.0) > design.nominal_pair.contact_length
    return _fitting(kind, room, wide=wide)


@SATELLITE.check(
    "speed",
    formula="n₁·(1 + 1/u) ≤ n_lim",
    why="Above it the bearing gets too hot.",
    inputs=(of.SPEEDS, "mechanism.ratio bearing.limiting_speed"),
    fixes="load.input_speed",
)
def bearing_speed(kind: Kind, design: Design, results: Results) -> Check:
    value = design.known_speeds.turning * design.built.waves_per_turn
    return _turning(kind, "bearing.limiting_speed", [(value, design.bearing.limiting_speed)])


def _rating(design: Design) -> float:
    """Dynamic rating of the satellite bearings, N; `NotKnown` if it is not given."""
    return required(design.bearing.dynamic_rating, "rating_unknown", "bearing.dynamic_rating")


@SATELLITE.check(
    "least",
    formula="Q_min ≥ q·C",
    why="Below it rolling elements slide, and tracks are smeared.",
    inputs=(of.BEARING_LOAD, "load.input_speed bearing.dynamic_rating"),
    source="slip",
)
def bearing_min_load(kind: Kind, design: Design, results: Results) -> Check:
    rating = _rating(design)
    found = results.crank.bearings
    loads = np.asarray(found.min_load)
    least = int(np.argmin(loads))
    return kind.judged(
        float(loads[least]),
        MIN_LOAD[design.bearing.kind] * rating,
        error=4 * float(found.accuracy.relative_error),
        warning="bearing_slips",
        at={"satellite": least + 1},
    )


@SATELLITE.check(
    "most",
    title="Load of {them} over their ratings",
    formula="P/(0.5·C), Q_max/C₀ ≤ 1",
    why="Above it the formula of the life promises more than the bearing lasts.",
    inputs=(
        of.BEARING_LOAD,
        "load.input_speed bearing.ring_factor bearing.dynamic_rating bearing.static_rating",
        "load.peak_torque load.application_factor",
    ),
    source="iso_281_life",
    needed=False,
)
def bearing_overload(kind: Kind, design: Design, results: Results) -> Check:
    found = results.crank.bearings
    used = np.asarray(found.equivalent_load) / (MOST_DYNAMIC * _rating(design))
    if design.bearing.static_rating:
        used = np.maximum(used, 1 / (MOST_STATIC * found.static_safety_factor))
    worst = int(np.argmax(used))
    return kind.judged(
        float(used[worst]),
        1.0,
        error=4 * float(found.accuracy.relative_error),
        warning="bearing_overloaded",
        at={"satellite": worst + 1},
    )


@CRANKSHAFT.check("ratings", formula="C/C_max ≤ q", inputs="crankshaft.bearings")
def crank_bearing_rating(kind: Kind, design: Design, results: Results) -> Check:
    found = [
        _possible(kind, each, _largest(each, "crankshaft.bearings"), at={"bearing": place})
        for place, each in enumerate(design.crankshaft.known_bearings, 1)
    ]
    return max(found, key=lambda check: (check.status != "pass", check.utilisation or 0.0))


@CRANKSHAFT.check(
    "room",
    title="Bores of {them}",
    formula="d ≥ d_shaft",
    why="Otherwise the bearing does not go onto the shaft.",
    inputs="crankshaft.bearings crankshaft.shaft_diameter",
    needed=False,
)
def crank_bearing_fits(kind: Kind, design: Design, results: Results) -> Check:
    name = "crankshaft.shaft_diameter"
    shaft = required(design.crankshaft.shaft_diameter, "size_missing", name)
    bores = [
        _known_sizes(each, "crankshaft.bearings")[0] for each in design.crankshaft.known_bearings
    ]
    least = min(bores)
    return kind.judged(least - shaft, 0.0, at={"bearing": bores.index(least) + 1})


@CRANKSHAFT.check(
    "speed",
    formula="n₁ ≤ n_lim",
    why="Above it the bearing gets too hot.",
    inputs=(of.SPEEDS, "mechanism.ratio crankshaft.bearings"),
)
def crank_bearing_speed(kind: Kind, design: Design, results: Results) -> Check:
    speeds, bearings = design.known_speeds, design.crankshaft.known_bearings
    turning = [(speeds.against(each.seat), each.limiting_speed) for each in bearings]
    return _turning(kind, "crankshaft.bearings", turning)


_MADE = "rollers.kind rollers.ratings rollers.rolling_elements"

_LESS = "load.pin_circle_radius mechanism.pins load.output_torque"

_PEAK = (of.LOADED, "load.peak_torque")


@ROLLERS.check(
    "life",
    formula="L_10h ≥ L",
    inputs=(of.FORCES, of.LIFE, _MADE, "rollers.dynamic_rating"),
    fixes=("rollers.name rollers.dynamic_rating load.input_speed", _LESS),
    source="roller_rating",
    requires={"rollers.dynamic_rating": "rating_unknown"},
)
def pin_roller_life(kind: Kind, design: Design, results: Results) -> Check:
    design.known_speed  # noqa: B018 - raises without a speed, as the life needs it
    found, power = results.roller_loads, EXPONENTS[_elements(design)]
    lives = [(found.life, power, {"satellite": found.satellite, "pin": found.pin})]
    return _lasting(kind, design.life, lives, found.accuracy, solved=results.solved)


def _elements(design: Design) -> Bearing:
    """Rolling elements of the rollers on the pins."""
    return pin_rollers.KINDS[design.rollers.kind]


@ROLLERS.check(
    "static",
    formula="C₀w/F_max ≥ S_0",
    inputs=(
        _PEAK,
        _MADE,
        "load.peak_kind rollers.static_rating requirements.static_safety",
    ),
    fixes=("rollers.name rollers.static_rating", _LESS, "load.peak_torque"),
    source="roller_rating",
    known=lambda design, results: {"limit": _static_safety(design, _elements(design))},
    requires={"rollers.static_rating": "rating_unknown"},
)
def pin_roller_static(kind: Kind, design: Design, results: Results) -> Check:
    found = results.roller_loads
    error = 4 * found.accuracy.relative_error
    limit = _static_safety(design, _elements(design))
    value = found.static_safety_factor
    return _safe(kind, results, value, limit=limit, error=error, solved=results.solved)


@ROLLERS.check(
    "most",
    title="Largest load of {them}",
    formula="F·K_A/F_r, F_max/F_0r ≤ 1",
    why="Above it the outer ring, which nothing supports, breaks by bending.",
    inputs=(_PEAK, "rollers.max_radial_load rollers.max_static_radial_load"),
    fixes=(_LESS, "load.peak_torque"),
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
    error = 4 * found.accuracy.relative_error
    return kind.judged(value, 1.0, reserve=1 / value, error=error, solved=results.solved)


@ROLLERS.check(
    "least",
    formula="F ≥ 0.0167·C₀",
    why="Below it outer rings slide in the holes before they roll.",
    inputs=(of.FORCES, "rollers.static_rating"),
    source="track_rollers",
)
def pin_roller_min_load(kind: Kind, design: Design, results: Results) -> Check:
    """Judge the largest load over the turn, as no roller is loaded during half of it."""
    name = "rollers.static_rating"
    limit = pin_rollers.MIN_LOAD * required(design.rollers.static_rating, "rating_unknown", name)
    found = results.roller_loads
    error = 4 * found.accuracy.relative_error
    return kind.judged(found.peak_load, limit, error=error, warning="bearing_slips")


@ROLLERS.check(
    "speed",
    formula="n·e/r_s ≤ n_lim",
    why="Above it the roller gets too hot.",
    inputs=(
        "load.input_speed mechanism.ratio contact.eccentricity contact.pin_radius",
        "rollers.limiting_speed",
    ),
    fixes="load.input_speed",
)
def pin_roller_speed(kind: Kind, design: Design, results: Results) -> Check:
    turned = design.known_eccentricity / design.pair.pin_radius
    value = design.known_speeds.turning * design.built.waves_per_turn * turned
    return _turning(kind, "rollers.limiting_speed", [(value, design.rollers.limiting_speed)])


@ROLLERS.check(
    "room",
    title="Room for the rollers along the pins",
    formula="n·B ≤ |z_j − z_k|, b",
    why="Otherwise rollers of neighbouring satellites lie in each other.",
    inputs=("rollers.width rollers.per_satellite pin.satellite_positions contact.contact_length",),
)
def pin_roller_fits(kind: Kind, design: Design, results: Results) -> Check:
    """Judge the room between satellites; rollers wider than the satellite are marginal."""
    length = design.rollers.length
    if math.isinf(length):
        raise NotKnown("size_missing", "rollers.width")
    places = sorted(design.pin.satellite_positions) if design.pin else []
    pitch = min((other - one for one, other in pairwise(places)), default=math.inf)
    width = design.nominal_pair.contact_length
    return _fitting(kind, min(pitch, max(width, length)) - length, wide=length > width)


@ROLLERS.check(
    "tilt",
    title="Slope of the pins in their rollers",
    unit="mrad",
    formula="θ ≤ θ_max",
    why="Above it rolling elements carry on their ends, and last less than the formula says.",
    inputs=(of.LOADED, "rollers.kind"),
    source="tilt_guide",
    needs="touching load rollers pin",
    needed=False,
)
def pin_roller_tilt(kind: Kind, design: Design, results: Results) -> Check:
    found = results.pin_loads
    return kind.judged(
        found.deflection.slope,
        pin_rollers.TILT[design.rollers.kind],
        error=4 * found.accuracy.relative_error,
        warning="roller_tilted",
        at={"satellite": found.deflection.slope_satellite},
    )


LIVES = (bearing_life, bearing_static, system_life, crank_bearing_life, crank_bearing_static)
OF_SATELLITES = (bearing_rating, bearing_fits, bearing_speed, bearing_min_load, bearing_overload)
OF_CRANKSHAFT = (crank_bearing_rating, crank_bearing_fits, crank_bearing_speed)
LOADS = (pin_roller_life, pin_roller_static, pin_roller_max_load, pin_roller_min_load)
ON_PINS = (*LOADS, pin_roller_speed, pin_roller_fits, pin_roller_tilt)
