"""Checks of a satellite's body: what its holes leave of it to its rim and its bore, and the room
that it takes.
"""

import math
from functools import partial

from core.checks.check import Check, Kind, Measure, design_check, gap, wall
from core.checks.inputs import ROOTS
from core.design.document import Design, value_at
from core.design.results import Results
from core.errors import NotKnown, required

RIM = 2.7
"""Least rim below the roots of involute teeth over their module: 1.2 times the height of teeth of
the basic rack of ISO 53, as rims that do not weaken the teeth have (AGMA 2001, ISO 6336-3)."""

_check = partial(
    design_check,
    group="body",
    part="body",
    unit="mm",
    keep="above",
    needs=("touching", "load", "satellite_body"),
)


def within_roots(*, design: Design, kind: Kind, solid: bool = False) -> Check:
    """The wall between the holes and the roots of the satellite's teeth: it passes by the least
    radius of these, fails by the largest, and is not known between.

    Parameters
    ----------
    design : Design
        The design.
    kind : Kind
        Which check.
    solid : bool
        Whether it has to be as thick as is asked, or usual; else it has to be there.

    Returns
    -------
    Check
    """
    size = design.nominal_pair.hole_radius
    reach = design.load.pin_circle_radius + size
    known = design.satellite_body and design.satellite_body.root_radius
    source = "roots" if design.gear and not known else ""

    def wide(radius: float) -> Check:
        if not solid:
            return gap(kind, width=radius - reach, size=size)._replace(limit_source=source)
        asked = design.requirements.min_wall
        found = wall(kind, width=radius - reach, size=size, least=asked, guide=_rim_guide(design))
        return found if found.limit_source else found._replace(limit_source=source)

    shallow, deep = map(wide, reversed(design.roots))
    if deep.status != "fail":
        return deep
    if shallow.status == "fail":
        return shallow
    cycloid = design.gear and design.gear.kind == "cycloid"
    if cycloid:
        _ = design.known_eccentricity
    name = "gear.ring_pin_radius" if cycloid else "satellite_body.root_radius"
    return Check(kind, "not_checked", limit=deep.limit, reason="roots_unknown", missing=(name,))


def _rim_guide(design: Design) -> float | None:
    """Least wall to the rim that is usual, m: within involute teeth 1.2 times their height."""
    gear = design.gear
    if gear and gear.kind == "involute":
        return RIM * gear.module
    return design.wall_guide


@_check(
    "wall_rim",
    title="Wall to the rim",
    formula="r_f − R − r_out ≥ w",
    why="Otherwise the holes break through the rim of the satellite.",
    inputs=(ROOTS, "load.pin_circle_radius contact.hole_radius requirements.min_wall"),
    fixes=(
        "satellite_body.outer_radius satellite_body.root_radius load.pin_circle_radius",
        "contact.pin_radius",
    ),
    source="wang_2016",
)
def wall_rim(kind: Kind, design: Design, results: Results) -> Check:
    if math.isinf(design.roots[1]):
        raise NotKnown("size_missing", "satellite_body.outer_radius")
    return within_roots(design=design, kind=kind, solid=True)


@_check(
    "wall_bore",
    title="Wall to the bore",
    formula="R − r_out − r_b ≥ w",
    why="Otherwise the holes break into the bore of the satellite.",
    inputs=(
        "satellite_body.bore_radius load.pin_circle_radius contact.hole_radius",
        "requirements.min_wall",
    ),
    fixes="satellite_body.bore_radius load.pin_circle_radius contact.pin_radius",
    source="wang_2016",
)
def wall_bore(kind: Kind, design: Design, results: Results) -> Check:
    size = design.nominal_pair.hole_radius
    bore = required(design.bore_radius, "size_missing", "satellite_body.bore_radius")
    width, least = design.load.pin_circle_radius - size - bore, design.requirements.min_wall
    return wall(kind, width=width, size=size, least=least, guide=design.wall_guide)


@_check(
    "outer_diameter",
    title="Diameter of the space of the satellites",
    formula="2·(r_o + e) ≤ D_max",
    why="Otherwise the satellites do not fit into the space that is asked.",
    inputs="satellite_body.outer_radius contact.eccentricity requirements.max_outer_diameter",
    fixes="satellite_body.outer_radius",
    keep="below",
    asks="max_outer_diameter",
    asked_alone=True,
)
def outer_diameter(kind: Kind, design: Design, results: Results) -> Measure:
    """Of the circle in which a satellite moves."""
    path = "satellite_body.outer_radius"
    radius: float = required(value_at(design, path), "size_missing", path)
    return Measure(2 * (radius + design.known_eccentricity))


BODY = (wall_rim, wall_bore, outer_diameter)
