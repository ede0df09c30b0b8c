"""Checks of the pins' friction: efficiency, sliding speed, pv, wear against what is asked."""

from functools import partial

from core.checks.check import Check, Kind, Measure, Unjudged, design_check
from core.checks.inputs import FORCES, INVOLUTE_TEETH, LIFE, SPEEDS
from core.design.document import Design
from core.design.results import Results
from core.errors import if_known

_check = partial(design_check, group="friction", part="losses", needs=("touching", "load", "rubs"))


@_check(
    "efficiency",
    title="Efficiency of the output mechanism",
    formula="η ≥ η_min",
    why="Below it more is lost than is asked.",
    inputs=(
        FORCES,
        "gear.modification.rotation",
        SPEEDS,
        INVOLUTE_TEETH,
        "gear.friction_coefficient gear.sleeve_bore_radius friction.coefficient friction.sleeve",
        "rollers.kind rollers.bore_diameter rollers.friction_coefficient",
        "requirements.min_efficiency",
    ),
    fixes="friction.coefficient load.pin_circle_radius pin.diameter",
    source="user",
    keep="above",
    asks="min_efficiency",
)
def efficiency(kind: Kind, design: Design, results: Results) -> Measure:
    """Its limit is used by the losses: at least those of pins, and of teeth where their friction is
    known.
    """
    value, asked = results.losses.efficiency, design.requirements.min_efficiency
    toothed = design.gear and design.gear.kind != "none"
    if toothed and design.gear.friction_coefficient is None and value >= (asked or 1.0):
        raise Unjudged("ring_friction_unknown", "gear.friction_coefficient", value=value)
    return Measure(value, used=lambda limit: (1 - value) / (1 - limit), reason="losses_left_out")


@_check(
    "sliding_speed",
    title="Sliding speed",
    unit="m_per_s",
    formula="v ≤ v_max",
    why="Above it the surfaces get hot.",
    inputs=(
        SPEEDS,
        "mechanism.ratio contact.eccentricity friction.sleeve pin.diameter contact.pin_radius",
        "requirements.max_sliding_speed",
    ),
    fixes="load.input_speed pin.diameter",
    source="user",
    asks="max_sliding_speed",
)
def sliding_speed(kind: Kind, design: Design, results: Results) -> Check | Measure:
    if design.rollers:
        return Check(kind, "not_applicable", reason="rollers_roll")
    return Measure(float(results.losses.pins.sliding_speed))


def _with_torque(results: Results, value: float) -> Measure:
    """A value of the losses that grows with the largest force."""
    return Measure(
        value,
        error=4 * float(results.losses.pins.accuracy.relative_error),
        reserve=lambda growth: growth,
        solved=results.solved,
    )


@_check(
    "pv",
    title="Pressure times sliding speed",
    unit="MPa_m_per_s",
    formula="p·v ≤ (pv)_all",
    why="Above it the surfaces get hot and wear fast.",
    inputs=(FORCES, SPEEDS, "friction.sleeve requirements.max_pv"),
    fixes=(
        "contact.pin_radius contact.contact_length load.pin_circle_radius load.input_speed",
        "load.output_torque",
    ),
    source="user",
    asks="max_pv",
)
def pv(kind: Kind, design: Design, results: Results) -> Check | Measure:
    """Of a sleeve, which is a bush; a bare pin in a wider hole is none."""
    if design.rollers:
        return Check(kind, "not_applicable", reason="rollers_roll")
    value = float(results.losses.pins.peak_pv)
    if not design.friction.sleeve:
        return Check(kind, "not_applicable", value=value, reason="no_bush")
    return _with_torque(results, value)


@_check(
    "wear",
    title="Wear of pins and holes",
    unit="mm",
    formula="h ≤ h_max",
    why="Above it the output has more play than is asked before the end of its life.",
    inputs=(FORCES, LIFE, "friction.wear_rate friction.life requirements.max_wear"),
    fixes=(
        "friction.wear_rate contact.contact_length contact.pin_radius load.pin_circle_radius",
        "load.input_speed load.output_torque",
    ),
    source="archard_1953",
    asks="max_wear",
)
def wear(kind: Kind, design: Design, results: Results) -> Check | Measure:
    if design.rollers:
        return Check(kind, "not_applicable", reason="rollers_roll")
    losses = results.losses.pins
    hole = if_known(lambda: losses.hole_wear) or 0.0
    return _with_torque(results, float(max(losses.pin_wear, hole)))


FRICTION = (efficiency, sliding_speed, pv, wear)
