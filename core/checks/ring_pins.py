"""Checks of a ring of pins: what geometry alone says of a cycloid disc on them."""

import math
from functools import partial

from core.checks.check import Check, Kind, design_check, judged, judged_by, wall
from core.checks.crank import NOT_OF, other_ring
from core.design.document import Design
from core.design.refusals import named
from core.design.results import Results
from core.design.ring import RingKind
from core.errors import NotKnown
from core.ring.profile import CycloidDisc

NEAR_UNDERCUT = 1.1
"""Least bend of the pins' path over their radius for which errors leave a part of the flank."""

BETWEEN_PINS = 0.1
"""Least wall of the ring between its pins, over their diameter."""

CYCLOID: tuple[RingKind, ...] = ("cycloid",)

_OTHER = partial(other_ring, of=CYCLOID)

_ring = partial(design_check, group="gear", part="teeth", needs=("contact", "gear"), not_of=_OTHER)

_PATH = (
    "gear.kind",
    "gear.ring_pin_circle_radius",
    "gear.modification.equidistant",
    "gear.modification.pin_circle",
    "mechanism.ratio",
    "contact.eccentricity",
)


def _disc(design: Design) -> CycloidDisc:
    """A disc; of a larger difference the flanks near the tips are cut off, and nothing is known."""
    lobes, difference = design.lobes, design.gear.teeth_difference or 1
    if difference > 1:
        raise NotKnown("cycloid_difference", difference=difference)
    made = partial(
        design.cycloid.disc, satellite_teeth=lobes, eccentricity=design.known_eccentricity
    )
    return named(design, "gear", made)


@_ring(
    "ring_undercut",
    title="Flanks that the ring's pins leave",
    formula="ρ_min/r_m ≥ 1.1",
    why="At 1 and below, the outline loops: its tool would cut off a part of the satellite's "
    "flanks. Slightly above, errors do so.",
    inputs=(_PATH, "gear.ring_pin_radius gear.teeth_difference"),
    fixes="gear.ring_pin_radius gear.ring_pin_circle_radius contact.eccentricity",
    keep="above",
)
def ring_undercut(kind: Kind, design: Design, results: Results) -> Check:
    if design.lobes < 2:
        return Check(kind, "not_applicable", reason="one_only")
    disc = _disc(design)
    if disc.undercut:
        return judged(kind, disc.undercut_margin, NEAR_UNDERCUT)._replace(impossible=True)
    found = judged(kind, disc.undercut_margin, NEAR_UNDERCUT, warning="near_undercut")
    return found._replace(limit_source="guide")


@_ring(
    "ring_valley_tool",
    title="Tool in the valleys of the discs",
    unit="mm",
    formula="ρ_v ≥ r_t",
    why="A larger wheel or cutter does not reach the bottom of the valleys.",
    inputs=(_PATH, "gear.ring_pin_radius gear.teeth_difference gear.tool_radius"),
    fixes="gear.tool_radius gear.ring_pin_radius",
    keep="above",
    needed=False,
)
def ring_valley_tool(kind: Kind, design: Design, results: Results) -> Check:
    """Not asked where no tool is given, nor of discs that are nowhere concave."""
    tool = judged_by(design.cycloid.tool_radius, "no_tool", "gear.tool_radius", status="not_asked")
    concave = _disc(design).min_concave_radius
    if concave is None:
        return Check(kind, "not_applicable", reason="no_valley")
    return judged(kind, concave, tool)


@_ring(
    "ring_pin_room",
    title="Space between the ring's pins",
    unit="mm",
    formula="2·R_p·sin(π/n) − 2·r_p ≥ 0.2·r_p",
    why="Otherwise the pins of the ring overlap, or hardly any of it is left between them.",
    inputs=(
        "gear.kind gear.ring_pin_circle_radius gear.ring_pin_radius gear.teeth_difference",
        "gear.every_second_pin mechanism.ratio",
    ),
    fixes="gear.ring_pin_radius gear.ring_pin_circle_radius",
    keep="above",
    needs=("gear",),
    not_of=lambda design, results: "" if design.gear.kind in CYCLOID else NOT_OF["cycloid"],
)
def ring_pin_room(kind: Kind, design: Design, results: Results) -> Check:
    pins = design.ring_pins // (2 if design.cycloid.every_second_pin else 1)
    size, circle = design.cycloid.known_pin_radius, design.cycloid.ring_pin_circle_radius
    width = 2 * circle * math.sin(math.pi / pins) - 2 * size
    return wall(kind, width=width, size=size, guide=2 * BETWEEN_PINS * size)


RING_PINS = (ring_undercut, ring_valley_tool, ring_pin_room)
