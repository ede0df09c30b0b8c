"""Checks of space: walls and gaps between pins, holes, rim and bore, the room that is there."""

import math
from functools import partial

from core.checks.check import Check, Kind, Measure, design_check, wall
from core.checks.inputs import ROOTS
from core.design.document import Design
from core.design.results import Results
from core.errors import NotKnown

_placed = partial(
    design_check, group="geometry", unit="mm", keep="above", needs=("touching", "load")
)
_body = partial(_placed, group="body", needs=("touching", "load", "satellite_body"))


def _between(kind: Kind, design: Design, radius: float, least: float | None = None) -> Check:
    """The wall or the gap between neighbours on the pin circle."""
    pins = design.mechanism.pins
    if pins < 2:
        return Check(kind, "not_applicable", reason="one_only")
    pitch = 2 * design.load.pin_circle_radius * math.sin(math.pi / pins)
    return wall(kind, width=pitch - 2 * radius, size=radius, least=least)


@_placed(
    "wall_holes",
    title="Wall between holes",
    formula="2·R·sin(π/N) − 2·r_out ≥ w",
    why="Otherwise the holes overlap, or the satellite is weak between them.",
    inputs=(
        "mechanism.pins",
        "load.pin_circle_radius",
        "contact.hole_radius",
        "requirements.min_wall",
    ),
    fixes=("load.pin_circle_radius", "contact.pin_radius", "mechanism.pins"),
    source="wang_2016",
)
def wall_holes(design: Design, results: Results) -> Check:
    radius, least = design.contact.pair.hole_radius, design.requirements.min_wall
    return _between(wall_holes, design, radius, least)


@_placed(
    "pins_apart",
    title="Space between pins",
    formula="2·R·sin(π/N) − 2·r_in > 0",
    why="Otherwise the pins overlap.",
    inputs=("mechanism.pins", "load.pin_circle_radius", "contact.pin_radius"),
    fixes=("load.pin_circle_radius", "contact.pin_radius", "mechanism.pins"),
)
def pins_apart(design: Design, results: Results) -> Check:
    return _between(pins_apart, design, design.contact.pair.pin_radius)


@_placed(
    "holes_off_centre",
    title="Holes beside the centre",
    formula="R − r_out > 0",
    why="Otherwise the holes reach the axis.",
    inputs=("load.pin_circle_radius", "contact.hole_radius"),
    fixes=("load.pin_circle_radius", "contact.pin_radius"),
)
def holes_off_centre(design: Design, results: Results) -> Check:
    size = design.contact.pair.hole_radius
    return wall(holes_off_centre, width=design.load.pin_circle_radius - size, size=size)


def within_roots(*, design: Design, kind: Kind, least: float | None = None) -> Check:
    """The wall between the holes and the roots of the satellite's teeth: it passes by the least
    radius of these, fails by the largest, and is not known between.

    Parameters
    ----------
    design : Design
        The design.
    kind : Kind
        Which check.
    least : float, optional
        Least width that is asked, m.

    Returns
    -------
    Check
    """
    size = design.contact.pair.hole_radius
    reach = design.load.pin_circle_radius + size
    known = design.satellite_body and design.satellite_body.root_radius
    source = "roots" if design.gear and not known else ""
    shallow, deep = (
        wall(kind, width=radius - reach, size=size, least=least)._replace(limit_source=source)
        for radius in reversed(design.roots)
    )
    if deep.status != "fail":
        return deep
    if shallow.status == "fail":
        return shallow
    cycloid = design.gear and design.gear.kind == "cycloid"
    if cycloid and design.contact.eccentricity is None:
        raise NotKnown("eccentricity_assumed", "contact.eccentricity")
    name = "gear.ring_pin_radius" if cycloid else "satellite_body.root_radius"
    return Check(kind, "not_checked", limit=deep.limit, reason="roots_unknown", missing=(name,))


@_body(
    "wall_rim",
    title="Wall to the rim",
    formula="r_f − R − r_out ≥ w",
    why="Otherwise the holes break through the rim of the satellite.",
    inputs=(*ROOTS, "load.pin_circle_radius", "contact.hole_radius", "requirements.min_wall"),
    fixes=(
        "satellite_body.outer_radius",
        "satellite_body.root_radius",
        "load.pin_circle_radius",
        "contact.pin_radius",
    ),
    source="wang_2016",
)
def wall_rim(design: Design, results: Results) -> Check:
    if math.isinf(design.roots[1]):
        return Check(wall_rim, "not_asked", missing=("satellite_body.outer_radius",))
    return within_roots(design=design, kind=wall_rim, least=design.requirements.min_wall)


@_body(
    "wall_bore",
    title="Wall to the bore",
    formula="R − r_out − r_b ≥ w",
    why="Otherwise the holes break into the bore of the satellite.",
    inputs=(
        "satellite_body.bore_radius",
        "load.pin_circle_radius",
        "contact.hole_radius",
        "requirements.min_wall",
    ),
    fixes=("satellite_body.bore_radius", "load.pin_circle_radius", "contact.pin_radius"),
    source="wang_2016",
)
def wall_bore(design: Design, results: Results) -> Check:
    bore, size = design.satellite_body.bore_radius, design.contact.pair.hole_radius
    if bore is None:
        return Check(wall_bore, "not_asked", missing=("satellite_body.bore_radius",))
    width = design.load.pin_circle_radius - size - bore
    return wall(wall_bore, width=width, size=size, least=design.requirements.min_wall)


@_body(
    "outer_diameter",
    title="Diameter of the space of the satellites",
    formula="2·(r_o + e) ≤ D_max",
    why="Otherwise the satellites do not fit into the space that is asked.",
    inputs=(
        "satellite_body.outer_radius",
        "contact.eccentricity",
        "requirements.max_outer_diameter",
    ),
    fixes=("satellite_body.outer_radius",),
    keep="below",
    asks="max_outer_diameter",
    asked_alone=True,
)
def outer_diameter(design: Design, results: Results) -> Measure:
    """Of the circle in which a satellite moves."""
    radius = design.satellite_body.outer_radius if design.satellite_body else None
    if radius is None:
        raise NotKnown("size_missing", "satellite_body.outer_radius")
    return Measure(2 * (radius + design.known_eccentricity))


SPACE = (wall_holes, pins_apart, holes_off_centre, wall_rim, wall_bore, outer_diameter)
