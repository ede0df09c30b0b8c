"""Checks of limits that a user may request of the meshes: play, evenness, efficiency, sliding,
wear, seats.

Each check returns a measure, which `Kind.of` compares with the requirement of its record. A measure
that takes a solution is calculated only if a limit is requested.
"""

from core.checks import inputs as of
from core.checks.check import (
    Check,
    Element,
    Kind,
    Measure,
    Unjudged,
    asked_of,
    judged_by,
)
from core.checks.teeth import not_cycloid, not_toothed, ring_alone
from core.design.document import Design
from core.design.results import Results
from core.errors import NotKnown, if_known
from core.precision import CLASSES

MOST_PLAY = 0.75
"""Clearance over the eccentricity above which a design is marginal, as the play takes a large part
of the motion."""

_LESS = "contact.hole_radius contact.fit"

_BACKLASH = {
    "unit": "arcmin",
    "formula": "max(θ₊ − θ₋) ≤ Δφ",
    "why": "Otherwise the unloaded output turns by more than is asked.",
}
_EFFICIENCY = {"formula": "η ≥ η_min", "source": "user", "keep": "above"}
_PV = {"unit": "MPa_m_per_s", "formula": "p·v ≤ (pv)_all", "source": "user", "asks": "max_pv"}

# A stated load-sharing factor is an input of play, as it excludes meshes in series.
_play = Element("play", "contact", "touching load", fixes=_LESS, source="load_sharing")
_rubs = Element("friction", "losses", "touching load rubs")
_ring = Element("gear", "teeth", "load contact gear")
_of_teeth = Element("gear", "teeth", "load contact gear", not_of=not_toothed)


def _of_both(results: Results) -> str | None:
    """Code that marks a value of both meshes, if they are in series."""
    return "both_meshes" if results.in_series else None


@_play(
    "backlash",
    title="Backlash of the output",
    inputs=(
        of.CRANKS,
        "mechanism.ratio load.pin_circle_radius",
        of.HOLE,
        "contact.eccentricity deviations crank_support rollers.radial_clearance",
        "requirements.max_backlash contact.distribution_factor",
        "gear.kind gear.ring_pin_circle_radius gear.teeth_difference",
        of.OF_CLEARANCE,
        "gear.modification.rotation",
    ),
    asks="max_backlash",
    **_BACKLASH,
)
def backlash(kind: Kind, design: Design, results: Results) -> Measure:
    of_fit = design.known_clearance and 0.0  # no clearance, or interference
    play = results.loading.turn.backlash_max if results.solved else of_fit
    return Measure(design.members.angle_at_output(play), reason=_of_both(results))


@_play(
    "lost_motion",
    title="Lost motion of the output",
    unit="arcmin",
    formula="θ(+3 % T) − θ(−3 % T) ≤ Δφ",
    why="Otherwise the output gives way by more than is asked when the torque turns.",
    inputs=(
        "load.output_torque contact.distribution_factor load.pin_circle_radius",
        of.CRANKS,
        "mechanism.ratio",
        of.SHARING,
        "requirements.max_lost_motion",
        of.RING_GIVES,
        "gear.modification.rotation",
    ),
    asks="max_lost_motion",
)
def lost_motion(kind: Kind, design: Design, results: Results) -> Measure:
    """Lost motion at the working torque itself; without a requested limit only from forces that are
    solved anyway. A requested limit is judged with the least moduli of sources.
    """
    solved = results.solved and design.load_factor == 1
    asked, _ = asked_of(design, "max_lost_motion"), design.known_clearance
    if not (solved or asked):
        raise NotKnown("no_limit")
    made = results.softest if asked else results
    lost = made.real_forces.turn.lost_motion
    return Measure(design.members.angle_at_output(lost), reason=_of_both(results))


@Element("geometry", "contact", "touching")(
    "clearance",
    title="Clearance over eccentricity",
    formula="(r_out − r_in − e)/e ≤ 0.75",
    why="Otherwise the play is a large part of what the mechanism moves by.",
    inputs=(of.HOLE, "contact.eccentricity"),
    fixes=_LESS,
    source="yanchevskiy_2021",
)
def clearance(kind: Kind, design: Design, results: Results) -> Check:
    share = max(design.known_clearance, 0.0) / design.known_eccentricity
    wanted = [
        play.of(design, results).status == "pass"
        for play in (backlash, lost_motion)
        if share > MOST_PLAY and asked_of(design, play.asks)
    ]
    if wanted and all(wanted):  # play that the requested limits allow is no warning
        return Check(kind, "pass", value=share, limit=MOST_PLAY)
    ratio = {"ratio": share}
    return kind.judged(share, MOST_PLAY, warning="clearance_like_eccentricity", params=ratio)


@_of_teeth(
    "ring_backlash",
    title="Backlash of the teeth",
    inputs=(of.TEETH_GAPS, "contact.distribution_factor requirements.max_ring_backlash"),
    fixes=(of.OF_CLEARANCE, "gear.satellite_profile_shift"),
    source="ring_mesh",
    asks="max_ring_backlash",
    **_BACKLASH,
)
def ring_backlash(kind: Kind, design: Design, results: Results) -> Check | Measure:
    """Backlash of the ring alone; for ring pins it is solved only if a limit is requested."""
    if design.gear.kind == "involute":
        return Measure(design.members.angle_at_output(max(results.ring.pair.backlash, 0.0)))
    judged_by(design.requirements.max_ring_backlash, "no_limit")
    play = results.ring.working[0].play_in_ring
    return Measure(design.members.angle_at_output(play), reason=ring_alone(results))


@_of_teeth(
    "ring_transmission_error",
    title="Transmission error of the teeth",
    unit="arcmin",
    formula="max θ − min θ ≤ TE",
    why="Otherwise the output turns less evenly than is asked.",
    inputs=(of.RING_FORCES, "requirements.max_transmission_error"),
    fixes=of.OF_CLEARANCE,
    source="ring_mesh",
    asks="max_transmission_error",
    only_asked=True,
)
def ring_transmission_error(kind: Kind, design: Design, results: Results) -> Check | Measure:
    """Transmission error at the working torque itself, of both meshes if they are in series."""
    if design.gear.kind == "involute":
        raise NotKnown("tooth_errors_unknown")
    worst = max(turn.transmission_error for turn in results.ring.working)
    return Measure(design.members.angle_at_output(worst), reason=_of_both(results))


@_rubs(
    "efficiency",
    title="Efficiency of pins and teeth",
    why="Below it more is lost than is asked.",
    inputs=(
        of.FORCES,
        "gear.modification.rotation",
        of.SPEEDS,
        of.INVOLUTE_TEETH,
        "gear.friction_coefficient gear.sleeve_bore_radius friction.coefficient friction.sleeve",
        "rollers.kind rollers.bore_diameter rollers.friction_coefficient",
        "requirements.min_efficiency",
    ),
    fixes="friction.coefficient load.pin_circle_radius pin.diameter",
    asks="min_efficiency",
    **_EFFICIENCY,
)
def efficiency(kind: Kind, design: Design, results: Results) -> Measure:
    """Efficiency by losses of pins, and of teeth of known friction; losses use the limit."""
    value, asked = results.losses.total_efficiency, design.requirements.min_efficiency
    toothed = design.gear and design.gear.kind != "none"
    if toothed and design.gear.friction_coefficient is None and value >= (asked or 1.0):
        raise Unjudged("ring_friction_unknown", "gear.friction_coefficient", value=value)
    return Measure(value, used=lambda limit: (1 - value) / (1 - limit), reason="losses_left_out")


@_rubs(
    "sliding_speed",
    title="Sliding speed",
    unit="m_per_s",
    formula="v ≤ v_max",
    why="Above it the surfaces get hot.",
    inputs=(
        of.SPEEDS,
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
    """Value of the losses that is proportional to the largest force."""
    return Measure(
        value,
        error=4 * float(results.losses.pins.accuracy.relative_error),
        reserve=lambda growth: growth,
        solved=results.solved,
    )


@_rubs(
    "pv",
    title="Pressure times sliding speed",
    why="Above it the surfaces get hot and wear fast.",
    inputs=(of.FORCES, of.SPEEDS, "friction.sleeve requirements.max_pv"),
    fixes=(
        "contact.pin_radius contact.contact_length load.pin_circle_radius load.input_speed",
        "load.output_torque",
    ),
    **_PV,
)
def pv(kind: Kind, design: Design, results: Results) -> Check | Measure:
    """Judge a sleeve, which is a bush; a bare pin in a wider hole is not."""
    if design.rollers:
        return Check(kind, "not_applicable", reason="rollers_roll")
    value = float(results.losses.pins.peak_pv)
    if not design.friction.sleeve:
        return Check(kind, "not_applicable", value=value, reason="no_bush")
    return _with_torque(results, value)


@_rubs(
    "wear",
    title="Wear of pins and holes",
    unit="mm",
    formula="h ≤ h_max",
    why="Above it the output has more play than is asked before the end of its life.",
    inputs=(of.FORCES, of.LIFE, "friction.wear_rate friction.life requirements.max_wear"),
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


def _not_seated(design: Design, results: Results) -> str:
    """Code of the reason why a check of ring pins in seats does not apply, or empty."""
    if other := not_cycloid(design, results):
        return other
    return "" if design.cycloid.pin_support == "seat" else "pins_bend"


def _no_sleeves(design: Design, results: Results) -> str:
    """Code of the reason why a check of sliding sleeves on ring pins does not apply, or empty."""
    if other := not_cycloid(design, results):
        return other
    ring = design.cycloid
    return "" if ring.sleeve_bore_radius and not ring.rolling else "no_bush"


@_ring(
    "ring_seat_pressure",
    title="Pressure of the ring's pins in their seats",
    unit="MPa",
    formula="F/(2·r_p·b) ≤ p_all",
    why="Above it the bores that hold the pins of the ring wear out.",
    inputs=(
        tuple(name for name in of.RING_LOADED if name not in of.OF_BENT_PINS),
        "requirements.max_seat_pressure",
    ),
    fixes="gear.ring_pin_radius gear.contact_length load.output_torque",
    source="user",
    not_of=_not_seated,
    asks="max_seat_pressure",
    only_asked=True,
    needed=False,
)
def ring_seat_pressure(kind: Kind, design: Design, results: Results) -> Check | Measure:
    """Largest force on a ring pin over the area that the pin covers."""
    turn = results.ring.loading
    area = 2 * turn.mesh.disc.ring_pin_radius * turn.mesh.contact_length
    pair = turn.peak_pair
    return Measure(
        turn.peak_force / area,
        error=turn.accuracy.relative_error,
        at={"satellite": pair.satellite, "pin": pair.pin, "crank_angle": turn.peak_crank_angle},
        reserve=lambda growth: growth,
        solved=True,
    )


@_of_teeth(
    "ring_efficiency",
    title="Efficiency of the teeth",
    why="Below it more is lost in the teeth than is asked.",
    inputs=(
        of.RING_FORCES,
        of.INVOLUTE_TEETH,
        "gear.friction_coefficient requirements.min_ring_efficiency",
    ),
    fixes="gear.friction_coefficient",
    asks="min_ring_efficiency",
    only_asked=True,
    **_EFFICIENCY,
)
def ring_efficiency(kind: Kind, design: Design, results: Results) -> Check | Measure:
    """Efficiency of the ring; the utilisation of the limit is that of the losses."""
    loss = results.ring.loss
    return Measure(
        loss.efficiency,
        error=loss.loss_ratio * loss.efficiency * CLASSES["sampling"],
        used=lambda limit: (1 - loss.efficiency) / (1 - limit),
    )


@_ring(
    "ring_pv",
    title="Pressure times sliding speed of the sleeves of the ring",
    why="Above it the sleeves on the pins of the ring get hot and wear fast.",
    inputs=(of.RING_FORCES, of.SPEEDS, "contact.distribution_of gear.rolling requirements.max_pv"),
    fixes="gear.contact_length load.input_speed load.output_torque",
    not_of=_no_sleeves,
    requires={"load.input_speed": "speed_missing"},
    only_asked=True,
    needed=False,
    **_PV,
)
def ring_pv(kind: Kind, design: Design, results: Results) -> Check | Measure:
    error = results.ring.working[0].accuracy.relative_error
    return Measure(results.ring.pv, error=error, solved=True)


PLAY = (backlash, lost_motion)
FRICTION = (efficiency, sliding_speed, pv, wear)
TURNING = (ring_backlash, ring_transmission_error)
SEATS = (ring_seat_pressure, ring_efficiency, ring_pv)
