"""Checks of the mechanism alone: dead centres, satellites alike."""

from functools import partial

from core.checks.check import Check, design_check, judged, judged_by
from core.design.document import Design
from core.design.results import Results
from core.output.mechanism import assembly_angles

_check = partial(design_check, group="mechanism", part="contact")


@_check(
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


@_check(
    "assembly",
    title="Satellites that differ",
    formula="ψ_j = 0",
    why="Otherwise they are different parts that can be exchanged by mistake.",
    inputs=(
        "mechanism.satellite_teeth",
        "mechanism.ring_teeth",
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


CRANKS = (dead_centre, assembly)
