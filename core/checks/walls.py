"""Checks of parts that have to fit together: pins in holes, walls and gaps between holes, pins and
rollers, to rim, bore and axis, sleeves, and the outer space.
"""

import math
from typing import Any

from core.checks import inputs as of
from core.checks.check import (
    Check,
    Element,
    Kind,
    Measure,
    Status,
    judged_by,
)
from core.checks.teeth import NOT_OF
from core.design.document import Design
from core.design.results import Results
from core.errors import NotKnown, required
from core.output.fit import FITS
from core.output.mechanism import assembly_angles

RIM = 2.7
"""Least rim below the roots of involute teeth over their module: 1.2 tooth heights of the basic
rack of ISO 53, with which a rim does not weaken teeth (AGMA 2001, ISO 6336-3)."""

SLEEVE = 0.1
"""Least wall of a sleeve over the diameter of its pin: tables of cycloid drives state 0.18 to 0.27,
and wrapped bushes have 0.1."""

BETWEEN_PINS = 0.1
"""Least wall of the ring between its pins, over their diameter."""

_WIDE: dict[str, Any] = {"unit": "mm", "keep": "above"}

_mechanism = Element("mechanism", "contact")
_placed = Element("geometry", "contact", "touching load", **_WIDE)
_body = Element("body", "body", "touching load satellite_body", **_WIDE)
_outside = Element(
    "build",
    "body",
    "touching load satellite_body",
    unit="mm",
    keep="below",
    asked_alone=True,
    source="build",
    why="Otherwise the reducer does not fit into the space that is asked.",
)


@_mechanism(
    "dead_centre",
    title="Dead centres",
    formula="Δθ < 180°",
    why="There no pair drives, and no torque is transmitted.",
    inputs=of.CRANKS,
    fixes="mechanism.pins mechanism.satellites",
    source="yanchevskiy_2021",
)
def dead_centre(kind: Kind, design: Design, results: Results) -> Check:
    zones = design.driven.phases.dead_zones()
    if not zones:
        return Check(kind, "pass", value=0.0, limit=0.0)
    start = zones[0][0] * design.built.crank_angle_per_wave
    at = {"crank_angle": start}
    return kind.judged(float(len(zones)), 0.0, impossible=True, at=at)


@_mechanism(
    "assembly",
    title="Satellites that differ",
    formula="ψ_j = 0",
    why="Otherwise they are different parts that can be exchanged by mistake.",
    inputs=(
        "mechanism.satellite_teeth mechanism.ratio mechanism.pins mechanism.satellites",
        "mechanism.crank_spacing mechanism.crank_angles",
    ),
    fixes="mechanism.satellites",
    source="yanchevskiy_2021",
)
def assembly(kind: Kind, design: Design, results: Results) -> Check:
    name = "mechanism.satellite_teeth"
    teeth = judged_by(design.mechanism.satellite_teeth, "", name, status="not_asked")
    angles = assembly_angles(mechanism=design.built, satellite_teeth=teeth)
    different = sum(not each.identical for each in angles)
    return kind.judged(float(different), 0.0, warning="different_parts")


@Element("geometry", "contact", "touching", **_WIDE)(
    "interference",
    title="Room of the pins in their holes",
    formula="min(C − |P·exp(−iθ) − H|) ≥ 0",
    why="Otherwise the parts cannot be put together, jam, or press without load.",
    inputs=(of.HOLE, "contact.eccentricity deviations rollers.radial_clearance"),
    fixes="contact.hole_radius contact.fit",
)
def interference(kind: Kind, design: Design, results: Results) -> Check:
    """Room of the pins over the turn by geometry, before any force."""
    clearance = design.known_clearance
    try:
        room = results.rooms.room
        misfit = "" if room.state == "fits" else results.fit.misfit
    except NotKnown as why:
        if clearance >= 0 and not design.deviations:  # without deviations the room is the clearance
            return kind.judged(clearance, 0.0)._replace(utilisation=None)
        if not design.load:
            raise
        if clearance < 0:  # all pairs are alike
            lacking = {
                "satellite": 1,
                "pin": 1,
                "missing_length": -clearance,
                "needed_length": design.nominal_pair.hole_radius - clearance,
            }
            found = Check(kind, "fail", value=clearance, limit=0.0, impossible=True)
            return found._replace(reason="cannot_assemble", params=lacking)
        return kind.unknown(why)._replace(limit=0.0)
    at: dict[str, float] = {}
    if room.binding:
        pair = room.binding[0]
        at = {"satellite": pair.satellite, "pin": pair.pin}
    at |= room.where
    status: Status = "fail"
    if misfit in FITS:
        status = "marginal" if misfit else "pass"
    return Check(
        kind,
        status,
        value=0.0 if status == "pass" and room.least < 0 else room.least,
        limit=0.0,
        reason=misfit,
        params=results.fit.refusal().params if misfit == "cannot_assemble" else {},
        impossible=status == "fail",
        at=at,
    )


def _apart(kind: Kind, design: Design, radius: float, *, solid: bool) -> Check:
    """Check of the wall (`solid`) or gap between neighbours of a radius, m, on the pin circle."""
    pins = design.pin_count
    if pins < 2:
        return Check(kind, "not_applicable", reason="one_only")
    width = 2 * design.pin_circle_radius * math.sin(math.pi / pins) - 2 * radius
    return _thick(kind, design, width, radius) if solid else kind.gap(width, size=radius)


def _thick(kind: Kind, design: Design, width: float, size: float) -> Check:
    """Check of a wall against the requested least wall, or a usual one."""
    least, guide = design.requirements.min_wall, design.wall_guide
    return kind.wall(width, size=size, least=least, guide=guide)


@_placed(
    "wall_holes",
    part="body",
    title="Wall between holes",
    formula="2·R·sin(π/N) − 2·r_out ≥ w",
    why="Otherwise the holes overlap, or the satellite is weak between them.",
    inputs="mechanism.pins load.pin_circle_radius contact.hole_radius requirements.min_wall",
    fixes="load.pin_circle_radius contact.pin_radius mechanism.pins",
    source="wang_2016",
)
def wall_holes(kind: Kind, design: Design, results: Results) -> Check:
    return _apart(kind, design, design.nominal_pair.hole_radius, solid=True)


@_placed(
    "pins_apart",
    title="Space between pins",
    formula="2·R·sin(π/N) − 2·r_in > 0",
    why="Otherwise the pins overlap.",
    inputs="mechanism.pins load.pin_circle_radius contact.pin_radius",
    fixes="load.pin_circle_radius contact.pin_radius mechanism.pins",
)
def pins_apart(kind: Kind, design: Design, results: Results) -> Check:
    return _apart(kind, design, design.nominal_pair.pin_radius, solid=False)


@_placed(
    "holes_off_centre",
    title="Holes beside the centre",
    formula="R − r_out > 0",
    why="Otherwise the holes reach the axis.",
    inputs="load.pin_circle_radius contact.hole_radius",
    fixes="load.pin_circle_radius contact.pin_radius",
)
def holes_off_centre(kind: Kind, design: Design, results: Results) -> Check:
    size = design.nominal_pair.hole_radius
    return kind.gap(design.pin_circle_radius - size, size=size)


def _within_roots(kind: Kind, design: Design, *, solid: bool) -> Check:
    """Check of the wall between holes and tooth roots over the range of root radii: it passes by
    the least radius, fails by the largest, and is not known in between. A `solid` wall has a
    requested or usual least thickness; otherwise a gap is enough.
    """
    size = design.nominal_pair.hole_radius
    reach = design.pin_circle_radius + size
    known = design.satellite_body and design.satellite_body.root_radius
    gear, guide = design.gear, design.wall_guide
    source = "roots" if gear and not known else ""
    if gear and gear.kind == "involute":
        guide = RIM * gear.module

    def wide(radius: float) -> Check:
        if not solid:
            return kind.gap(radius - reach, size=size)._replace(limit_source=source)
        asked = design.requirements.min_wall
        found = kind.wall(radius - reach, size=size, least=asked, guide=guide)
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


@_body(
    "wall_rim",
    title="Wall to the rim",
    formula="r_f − R − r_out ≥ w",
    why="Otherwise the holes break through the rim of the satellite.",
    inputs=(of.ROOTS, "load.pin_circle_radius contact.hole_radius requirements.min_wall"),
    fixes=(
        "satellite_body.outer_radius satellite_body.root_radius load.pin_circle_radius",
        "contact.pin_radius",
    ),
    source="wang_2016",
)
def wall_rim(kind: Kind, design: Design, results: Results) -> Check:
    if math.isinf(design.roots[1]):
        raise NotKnown("size_missing", "satellite_body.outer_radius")
    return _within_roots(kind, design, solid=True)


@_body(
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
    return _thick(kind, design, design.pin_circle_radius - size - bore, size)


@_outside(
    "outer_diameter",
    title="Outer diameter",
    formula="D ≤ D_max",
    inputs=(
        "build.housing_diameter build.carrier_diameter gear.kind gear.ring_pin_circle_radius",
        "gear.ring_pin_radius gear.module gear.teeth_difference gear.ring_profile_shift",
        "mechanism.ratio satellite_body.outer_radius contact.eccentricity",
        "load.pin_circle_radius pin.diameter contact.pin_radius requirements.max_outer_diameter",
    ),
    fixes=(
        "gear.ring_pin_circle_radius gear.module satellite_body.outer_radius",
        "load.pin_circle_radius",
    ),
    asks="max_outer_diameter",
)
def outer_diameter(kind: Kind, design: Design, results: Results) -> Measure:
    """Diameter of ring housing or carrier, the larger one."""
    return Measure(design.outermost[0])


@_outside(
    "length",
    title="Length",
    formula="L ≤ L_max",
    inputs=(
        "mechanism.satellites contact.contact_length pin.contact_length pin.satellite_positions",
        "pin.support pin.span pin.diameter contact.pin_radius build.gap build.carrier_width",
        "build.second_carrier_width build.housing_width crankshaft.satellite_positions",
        "crankshaft.bearing_positions crankshaft.bearings requirements.max_length",
    ),
    fixes=(
        "build.carrier_width build.second_carrier_width contact.contact_length build.gap",
        "contact.pin_radius",
    ),
    asks="max_length",
)
def length(kind: Kind, design: Design, results: Results) -> Measure:
    """Length over carrier, ring housing and bearings of the crankshaft."""
    return Measure(design.extent[0])


@Element("gear", "body", "touching load gear", **_WIDE)(
    "gear_room",
    title="Holes within the teeth",
    formula="r_f − R − r_out > 0",
    why="Otherwise the holes lie in the teeth of the satellite, or beyond.",
    inputs=(of.ROOTS, "load.pin_circle_radius contact.hole_radius"),
    fixes=(
        "load.pin_circle_radius contact.pin_radius gear.ring_pin_circle_radius",
        "gear.ring_pin_radius",
    ),
)
def gear_room(kind: Kind, design: Design, results: Results) -> Check:
    if design.gear.kind not in ("involute", "cycloid"):
        return Check(kind, "not_applicable", reason="no_teeth")
    return _within_roots(kind, design, solid=False)


@Element("pin", "pins", "touching load pin", **_WIDE)(
    "wall_sleeve",
    title="Wall of the sleeves",
    formula="r_in − d/2 ≥ 0.1·d",
    why="Thinner sleeves break or run out of round.",
    inputs="contact.pin_radius pin.diameter",
    fixes="contact.pin_radius",
)
def wall_sleeve(kind: Kind, design: Design, results: Results) -> Check:
    if not design.sleeved:
        return Check(kind, "not_applicable", reason="without_sleeve")
    radius, diameter = design.nominal_pair.pin_radius, design.pin.diameter
    width, guide = radius - diameter / 2, SLEEVE * diameter
    return kind.wall(width, size=radius, guide=guide)


@Element("gear", "teeth", "gear", **_WIDE)(
    "ring_pin_room",
    title="Space between the ring's pins",
    formula="2·R_p·sin(π/n) − 2·r_p ≥ 0.2·r_p",
    why="Otherwise the pins of the ring overlap, or hardly any of it is left between them.",
    inputs=(
        "gear.kind gear.ring_pin_circle_radius gear.ring_pin_radius gear.teeth_difference",
        "gear.every_second_pin mechanism.ratio",
    ),
    fixes="gear.ring_pin_radius gear.ring_pin_circle_radius",
    not_of=lambda design, results: "" if design.gear.kind == "cycloid" else NOT_OF["cycloid"],
)
def ring_pin_room(kind: Kind, design: Design, results: Results) -> Check:
    pins = design.ring_pins // (2 if design.cycloid.every_second_pin else 1)
    size, circle = design.cycloid.known_pin_radius, design.cycloid.ring_pin_circle_radius
    width = 2 * circle * math.sin(math.pi / pins) - 2 * size
    return kind.wall(width, size=size, guide=2 * BETWEEN_PINS * size)


FITTED = (dead_centre, assembly, interference)
LAYOUT = (wall_holes, pins_apart, holes_off_centre)
BODY = (wall_rim, wall_bore, outer_diameter, length)
