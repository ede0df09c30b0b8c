"""Checks of rolling bearings as they are bought: whether there are such ones, whether they fit and
may turn so fast, whether they carry enough, and not too much.
"""

import math
from functools import partial

import numpy as np

from core.checks.check import Check, Kind, design_check, judged, judged_by
from core.checks.inputs import BEARING_LOAD, SPEEDS
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
from core.design.sections import RollingBearing
from core.errors import NotKnown, required

PRESSED = 1e-4
"""What a bearing's outside may be larger than its seat, m: it is pressed in."""

_ENVELOPE = ("bore_diameter", "outer_diameter", "width")

_SIZES = tuple(f"bearing.{name}" for name in _ENVELOPE)

_bearing = partial(
    design_check,
    group="bearing",
    part="satellite_bearing",
    needs=("touching", "load", "bearing"),
)
_crank_bearing = partial(
    design_check,
    group="crankshaft",
    part="crank_bearings",
    needs=("touching", "load", "crankshaft"),
    inputs="crankshaft.bearings",
)


def _share(bearing: RollingBearing, bounds: Bounds) -> float:
    """The larger of its ratings, over the largest one that fits."""
    given = (
        (bearing.dynamic_rating, bounds.dynamic),
        (bearing.static_rating, bounds.static),
    )
    shares = [rating / bound for rating, bound in given if rating is not None]
    if not shares:
        raise NotKnown("rating_unknown", "bearing.dynamic_rating")
    return max(shares)


def _possible(kind: Kind, bearing: RollingBearing, bounds: Bounds) -> Check:
    """Whether there is a bearing of such ratings."""
    share, most = _share(bearing, bounds), IMPOSSIBLE[bearing.kind]
    found = judged(kind, share, most)
    if found.status == "fail":
        return found._replace(impossible=True)
    if share > HIGH[bearing.kind]:
        return found._replace(status="marginal", warning=True, reason="rating_high")
    if share < LOW:
        return found._replace(status="marginal", warning=True, reason="rating_low")
    return found


def _known_sizes(bearing: RollingBearing, *paths: str) -> tuple[float, ...]:
    """Its sizes, which have to be given."""
    if not bearing.sizes:
        raise NotKnown("envelope_unknown", *paths)
    return bearing.sizes


def _bounds(design: Design) -> Bounds:
    """Largest ratings of the satellites' bearings, by their sizes or by the room for them."""
    bearing, outer = design.bearing, _seat(design)
    if not bearing.sizes and math.isfinite(outer):
        least = _least_bore(design)
        if least < outer:  # else there is no room, as `bearing_fits` says
            return largest_ratings_of_room(
                kind=bearing.kind,
                least_bore=least,
                outer_diameter=outer,
                width=design.nominal_pair.contact_length,
            )
    bore, outer, width = _known_sizes(bearing, *_SIZES)
    return largest_ratings(kind=bearing.kind, bore_diameter=bore, outer_diameter=outer, width=width)


def _seat(design: Design) -> float:
    """What the satellites' bearings sit in, m; infinite where it is not given."""
    body = design.satellite_body
    return 2 * body.bore_radius if body and body.bore_radius is not None else math.inf


def _least_bore(design: Design) -> float:
    """Least bore of the satellites' bearings: the eccentric, or what encloses the shaft, m."""
    shaft = design.crankshaft
    if shaft and shaft.eccentric_diameter is not None:
        return float(shaft.eccentric_diameter)
    inside = (shaft.shaft_diameter or 0.0) if shaft else 0.0
    return float(inside + 2 * design.known_eccentricity)


@_bearing(
    "bearing_rating",
    title="Ratings of the satellites' bearings",
    formula="C/C_max, C₀/C₀_max ≤ q",
    why="There is no bearing of these sizes that carries so much.",
    inputs=(
        "bearing.kind bearing.dynamic_rating bearing.static_rating",
        _SIZES,
        "satellite_body.bore_radius contact.contact_length contact.eccentricity",
        "crankshaft.eccentric_diameter crankshaft.shaft_diameter",
    ),
    source="envelope",
)
def bearing_rating(kind: Kind, design: Design, results: Results) -> Check:
    found = _possible(kind, design.bearing, _bounds(design))
    if not (design.bearing.sizes or found.reason):  # by the room for them
        return found._replace(reason="envelope_unknown", missing=_SIZES)
    return found


def _room(design: Design) -> float:
    """What is left between a bearing and what is about it, m; of one whose sizes are not given only
    that there is no room for any.
    """
    least, seat = _least_bore(design), _seat(design)
    if not design.bearing.sizes and seat <= least:
        return seat - least
    bore, outer, _ = _known_sizes(design.bearing, *_SIZES)
    return min(bore - least, seat + PRESSED - outer)


@_bearing(
    "bearing_fits",
    title="Room for the satellites' bearings",
    unit="mm",
    formula="D ≤ 2·r_b, d ≥ d_shaft + 2·e, B ≤ b",
    why="Otherwise the bearing does not go onto its eccentric, or into the satellite.",
    inputs=(
        _SIZES,
        "satellite_body.bore_radius contact.contact_length contact.eccentricity",
        "crankshaft.eccentric_diameter crankshaft.shaft_diameter",
    ),
    fixes="satellite_body.bore_radius",
    keep="above",
    needed=False,
)
def bearing_fits(kind: Kind, design: Design, results: Results) -> Check:
    found = judged(kind, _room(design), 0.0)
    if found.status == "fail":
        return found._replace(impossible=True)
    if (design.bearing.width or 0.0) > design.nominal_pair.contact_length:
        return found._replace(status="marginal", warning=True, reason="wider_than_satellite")
    return found


@_bearing(
    "bearing_speed",
    title="Speed of the satellites' bearings",
    unit="rpm",
    formula="n₁·(1 + 1/u) ≤ n_lim",
    why="Above it the bearing gets too hot.",
    inputs=(SPEEDS, "mechanism.ratio bearing.limiting_speed"),
    fixes="load.input_speed",
    source="user",
    needed=False,
)
def bearing_speed(kind: Kind, design: Design, results: Results) -> Check:
    value = design.known_speeds.turning * design.built.waves_per_turn
    said = {"value": value, "status": "not_asked"}
    speed = design.bearing.limiting_speed
    limit = judged_by(speed, "no_limit", "bearing.limiting_speed", **said)
    return judged(kind, value, limit)


def _rating(design: Design) -> float:
    """Dynamic rating of the satellites' bearings, which has to be given, N."""
    return required(design.bearing.dynamic_rating, "rating_unknown", "bearing.dynamic_rating")


@_bearing(
    "bearing_min_load",
    title="Least load of the satellites' bearings",
    unit="N",
    formula="Q_min ≥ q·C",
    why="Below it rolling elements slide, and tracks are smeared.",
    inputs=(BEARING_LOAD, "load.input_speed bearing.dynamic_rating"),
    source="slip",
    keep="above",
    needed=False,
)
def bearing_min_load(kind: Kind, design: Design, results: Results) -> Check:
    rating = _rating(design)
    found = results.crank.bearings
    loads = np.asarray(found.min_load)
    least = int(np.argmin(loads))
    return judged(
        kind,
        float(loads[least]),
        MIN_LOAD[design.bearing.kind] * rating,
        error=4 * float(found.accuracy.relative_error),
        warning="bearing_slips",
        at={"satellite": least + 1},
    )


@_bearing(
    "bearing_overload",
    title="Load of the satellites' bearings over their ratings",
    formula="P/(0.5·C), Q_max/C₀ ≤ 1",
    why="Above it the formula of the life promises more than the bearing lasts.",
    inputs=(
        BEARING_LOAD,
        "load.input_speed bearing.ring_factor bearing.dynamic_rating bearing.static_rating",
        "load.peak_torque load.application_factor contact.dynamic_factor",
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
    return judged(
        kind,
        float(used[worst]),
        1.0,
        error=4 * float(found.accuracy.relative_error),
        warning="bearing_overloaded",
        at={"satellite": worst + 1},
    )


@_crank_bearing(
    "crank_bearing_rating",
    title="Ratings of the crankshaft's bearings",
    formula="C/C_max ≤ q",
    why="There is no bearing of these sizes that carries so much.",
    source="envelope",
)
def crank_bearing_rating(kind: Kind, design: Design, results: Results) -> Check:
    found = []
    for place, each in enumerate(design.crankshaft.known_bearings, 1):
        bore, outer, width = _known_sizes(each, "crankshaft.bearings")
        bounds = largest_ratings(
            kind=each.kind, bore_diameter=bore, outer_diameter=outer, width=width
        )
        made = _possible(kind, each, bounds)
        found.append(made._replace(at={"bearing": place}))
    return max(found, key=lambda check: (check.status != "pass", check.utilisation or 0.0))


@_crank_bearing(
    "crank_bearing_fits",
    title="Bores of the crankshaft's bearings",
    unit="mm",
    formula="d ≥ d_shaft",
    why="Otherwise the bearing does not go onto the shaft.",
    inputs="crankshaft.bearings crankshaft.shaft_diameter",
    keep="above",
    needed=False,
)
def crank_bearing_fits(kind: Kind, design: Design, results: Results) -> Check:
    name = "crankshaft.shaft_diameter"
    shaft = required(design.crankshaft.shaft_diameter, "size_missing", name)
    bores = [
        _known_sizes(each, "crankshaft.bearings")[0] for each in design.crankshaft.known_bearings
    ]
    left = min(bores) - shaft
    found = judged(kind, left, 0.0, at={"bearing": bores.index(min(bores)) + 1})
    return found._replace(impossible=found.status == "fail")


@_crank_bearing(
    "crank_bearing_speed",
    title="Speed of the crankshaft's bearings",
    unit="rpm",
    formula="n₁ ≤ n_lim",
    why="Above it the bearing gets too hot.",
    inputs=(SPEEDS, "mechanism.ratio crankshaft.bearings"),
    source="user",
    needed=False,
)
def crank_bearing_speed(kind: Kind, design: Design, results: Results) -> Check:
    speeds = design.known_speeds
    turning = [
        (speeds.against(each.seat), each.limiting_speed)
        for each in design.crankshaft.known_bearings
    ]
    limited = [(speed, limit) for speed, limit in turning if limit is not None]
    if not limited:
        value = max(speed for speed, _ in turning)
        missing = ("crankshaft.bearings",)
        return Check(kind, "not_asked", value=value, reason="no_limit", missing=missing)
    speed, limit = max(limited, key=lambda each: each[0] / each[1])
    return judged(kind, speed, limit)


BEARINGS = (
    bearing_rating,
    bearing_fits,
    bearing_speed,
    bearing_min_load,
    bearing_overload,
    crank_bearing_rating,
    crank_bearing_fits,
    crank_bearing_speed,
)
