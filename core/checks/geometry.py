"""Checks of what geometry allows: pins in their holes, their room over the turn and the play it
leaves the output; how pins, holes and satellites are laid out: dead centres, satellites alike,
walls and gaps between pins, holes, rim and bore, the room that is there.
"""

import math
from functools import partial

from core.checks.check import (
    Check,
    Kind,
    Measure,
    Status,
    design_check,
    gap,
    judged,
    judged_by,
    make_check,
    not_checked,
    wall,
)
from core.checks.inputs import HOLE, RING_GIVES, ROOTS, SHARING
from core.design.document import Design, value_at
from core.design.results import Results
from core.errors import NotKnown, required
from core.output.mechanism import assembly_angles

MOST_PLAY = 0.75
"""Clearance over the eccentricity above which a design is marginal: the play is a large part of
what the mechanism moves by."""

OF_TEETH = (
    "gear.kind",
    "gear.ring_pin_circle_radius",
    "gear.teeth_difference",
    "gear.modification.equidistant",
    "gear.modification.pin_circle",
    "gear.modification.rotation",
)
"""Of the play of teeth that are in series."""

_check = partial(design_check, part="contact", fixes=("contact.hole_radius", "contact.fit"))
_of_room = partial(_check, group="geometry", needs=("touching",))
_of_play = partial(
    _check, group="play", unit="arcmin", source="load_sharing", needs=("touching", "load")
)


@_of_room(
    "interference",
    title="Room of the pins in their holes",
    unit="mm",
    formula="min(C − |P·exp(−iθ) − H|) ≥ 0",
    why="Otherwise the parts cannot be put together, jam, or press without load.",
    inputs=(*HOLE, "contact.eccentricity", "deviations", "rollers.radial_clearance"),
    keep="above",
)
def interference(design: Design, results: Results) -> Check:
    """By geometry, before any force: the room over the turn."""
    clearance = design.known_clearance
    try:
        room = results.rooms.room
        misfit = "" if room.state == "fits" else results.fit.misfit
    except NotKnown as why:
        if clearance >= 0 and not design.deviations:  # the room is the clearance
            return judged(interference, clearance, 0.0)._replace(utilisation=None)
        if not design.load:
            raise
        if clearance < 0:  # of all pairs alike
            lacking = {
                "satellite": 1,
                "pin": 1,
                "missing_length": -clearance,
                "needed_length": design.contact.pair.hole_radius - clearance,
            }
            found = Check(interference, "fail", value=clearance, limit=0.0, impossible=True)
            return found._replace(reason="cannot_assemble", params=lacking)
        return not_checked(interference, why)._replace(limit=0.0)
    at: dict[str, float] = {}
    if room.binding:
        pair = room.binding[0]
        at = {"satellite": pair.satellite, "pin": pair.pin}
    at |= room.where
    status: Status = "fail"
    if not misfit or misfit == "fits_by_bearing_clearance":
        status = "marginal" if misfit else "pass"
    return Check(
        interference,
        status,
        value=0.0 if status == "pass" and room.least < 0 else room.least,
        limit=0.0,
        reason=misfit,
        params=results.fit.refusal().params if misfit == "cannot_assemble" else {},
        impossible=status == "fail" and misfit != "pressed_without_load",
        at=at,
    )


def of_both(results: Results) -> str | None:
    """Why a value is of both meshes, where it is.

    Parameters
    ----------
    results : Results
        Results of a design.

    Returns
    -------
    str or None
        The reason.
    """
    return "both_meshes" if results.in_series else None


@_of_play(
    "backlash",
    title="Backlash of the output mechanism",
    formula="max(θ₊ − θ₋) ≤ Δφ",
    why="Otherwise the unloaded output turns by more than is asked.",
    inputs=(
        "mechanism.pins",
        "mechanism.satellites",
        "mechanism.crank_spacing",
        "mechanism.crank_angles",
        "mechanism.ratio",
        "load.pin_circle_radius",
        *HOLE,
        "contact.eccentricity",
        "deviations",
        "crank_support",
        "rollers.radial_clearance",
        "requirements.max_backlash",
        "contact.distribution_factor",  # which no meshes in series have
        *OF_TEETH,
    ),
    asks="max_backlash",
)
def backlash(design: Design, results: Results) -> Measure:
    of_fit = design.known_clearance and 0.0  # none, or interference
    play = results.loading.turn.backlash_max if results.solved else of_fit
    return Measure(design.members.angle_at_output(play), reason=of_both(results))


@_of_play(
    "lost_motion",
    title="Lost motion of the output mechanism",
    formula="θ(+3 % T) − θ(−3 % T) ≤ Δφ",
    why="Otherwise the output gives way by more than is asked when the torque turns.",
    inputs=tuple(
        dict.fromkeys(
            (
                "load.output_torque",
                "contact.distribution_factor",  # which no meshes in series have
                "load.pin_circle_radius",
                "mechanism.pins",
                "mechanism.satellites",
                "mechanism.crank_spacing",
                "mechanism.crank_angles",
                "mechanism.ratio",
                *SHARING,
                "requirements.max_lost_motion",
                *RING_GIVES,
                "gear.modification.rotation",
            )
        )
    ),
    asks="max_lost_motion",
)
def lost_motion(design: Design, results: Results) -> Measure:
    """At the torque itself, of which it takes a share; not solved for where nobody asks. Asked, it
    is that of the softest material that sources allow.
    """
    solved = results.solved and design.load_factor == 1
    asked, _ = design.requirements.asked("max_lost_motion"), design.known_clearance
    if not (solved or asked):
        raise NotKnown("no_limit")
    made = results.softest if asked else results
    lost = made.real_forces.turn.lost_motion
    return Measure(design.members.angle_at_output(lost), reason=of_both(results))


@_of_room(
    "clearance",
    title="Clearance over eccentricity",
    formula="(r_out − r_in − e)/e ≤ 0.75",
    why="Otherwise the play is a large part of what the mechanism moves by.",
    inputs=(*HOLE, "contact.eccentricity"),
    source="yanchevskiy_2021",
)
def clearance(design: Design, results: Results) -> Check:
    share = max(design.known_clearance, 0.0) / design.known_eccentricity
    wanted = [
        make_check(play, design, results).status == "pass"
        for play in (backlash, lost_motion)
        if share > MOST_PLAY and design.requirements.asked(play.asks)
    ]
    if wanted and all(wanted):  # as much play as is asked for
        return Check(clearance, "pass", value=share, limit=MOST_PLAY)
    ratio = {"ratio": share}
    return judged(clearance, share, MOST_PLAY, warning="clearance_like_eccentricity", params=ratio)


RIM = 2.7
"""Least rim below the roots of involute teeth over their module: 1.2 times the height of teeth of
the basic rack of ISO 53, as rims that do not weaken the teeth have (AGMA 2001, ISO 6336-3)."""

_of_mechanism = partial(design_check, group="mechanism", part="contact")
_placed = partial(
    design_check,
    group="geometry",
    part="contact",
    unit="mm",
    keep="above",
    needs=("touching", "load"),
)
_body = partial(_placed, part="body", group="body", needs=("touching", "load", "satellite_body"))


@_of_mechanism(
    "dead_centre",
    title="Dead centres",
    formula="Δθ < 180°",
    why="There no pair drives, and no torque is transmitted.",
    inputs=(
        "mechanism.pins",
        "mechanism.satellites",
        "mechanism.crank_spacing",
        "mechanism.crank_angles",
    ),
    fixes=("mechanism.pins", "mechanism.satellites"),
    source="yanchevskiy_2021",
)
def dead_centre(design: Design, results: Results) -> Check:
    zones = design.driven.phases.dead_zones()
    if not zones:
        return Check(dead_centre, "pass", value=0.0, limit=0.0)
    start = zones[0][0] * design.mechanism.built.crank_angle_per_wave
    at = {"crank_angle": start}
    return judged(dead_centre, float(len(zones)), 0.0, impossible=True, at=at)


@_of_mechanism(
    "assembly",
    title="Satellites that differ",
    formula="ψ_j = 0",
    why="Otherwise they are different parts that can be exchanged by mistake.",
    inputs=(
        "mechanism.satellite_teeth",
        "mechanism.ratio",
        "mechanism.pins",
        "mechanism.satellites",
        "mechanism.crank_spacing",
        "mechanism.crank_angles",
    ),
    fixes=("mechanism.satellites",),
    source="yanchevskiy_2021",
)
def assembly(design: Design, results: Results) -> Check:
    name = "mechanism.satellite_teeth"
    teeth = judged_by(design.mechanism.satellite_teeth, "", name, status="not_asked")
    angles = assembly_angles(mechanism=design.mechanism.built, satellite_teeth=teeth)
    different = sum(not each.identical for each in angles)
    return judged(assembly, float(different), 0.0, warning="different_parts")


def _between(design: Design, radius: float) -> float:
    """Width between neighbours on the pin circle, m; infinite of a single one."""
    pins = design.mechanism.pins
    if pins < 2:
        return math.inf
    return 2 * design.load.pin_circle_radius * math.sin(math.pi / pins) - 2 * radius


@_placed(
    "wall_holes",
    part="body",
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
    width = _between(design, radius)
    if math.isinf(width):
        return Check(wall_holes, "not_applicable", reason="one_only")
    return wall(wall_holes, width=width, size=radius, least=least, guide=design.wall_guide)


@_placed(
    "pins_apart",
    title="Space between pins",
    formula="2·R·sin(π/N) − 2·r_in > 0",
    why="Otherwise the pins overlap.",
    inputs=("mechanism.pins", "load.pin_circle_radius", "contact.pin_radius"),
    fixes=("load.pin_circle_radius", "contact.pin_radius", "mechanism.pins"),
)
def pins_apart(design: Design, results: Results) -> Check:
    radius = design.contact.pair.pin_radius
    width = _between(design, radius)
    if math.isinf(width):
        return Check(pins_apart, "not_applicable", reason="one_only")
    return gap(pins_apart, width=width, size=radius)


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
    return gap(holes_off_centre, width=design.load.pin_circle_radius - size, size=size)


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
    size = design.contact.pair.hole_radius
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
        raise NotKnown("size_missing", "satellite_body.outer_radius")
    return within_roots(design=design, kind=wall_rim, solid=True)


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
    size = design.contact.pair.hole_radius
    bore = required(design.bore_radius, "size_missing", "satellite_body.bore_radius")
    width, least = design.load.pin_circle_radius - size - bore, design.requirements.min_wall
    return wall(wall_bore, width=width, size=size, least=least, guide=design.wall_guide)


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
    path = "satellite_body.outer_radius"
    radius: float = required(value_at(design, path), "size_missing", path)
    return Measure(2 * (radius + design.known_eccentricity))


CRANKS = (dead_centre, assembly)
SPACE = (wall_holes, pins_apart, holes_off_centre, wall_rim, wall_bore, outer_diameter)
FIT = (interference, clearance)
PLAY = (backlash, lost_motion)
