"""Checks of satellites in their ring under load: what presses without it, pressure, play; of
cycloid discs on its pins also transmission error, strength of the pins, pressure in their seats,
efficiency, pv.
"""

from functools import partial
from typing import Any, get_args

from core.checks.check import (
    Check,
    Kind,
    Measure,
    asked_of,
    design_check,
    judged,
    judged_by,
    over_range,
)
from core.checks.contact import of_both, over_life, static_limit, whence
from core.checks.crank import other_ring
from core.checks.inputs import (
    FATIGUE,
    INVOLUTE_TEETH,
    LIFE,
    OF_BENT_PINS,
    RING_FORCES,
    RING_LOADED,
    SPEEDS,
    TEETH_GAPS,
    TEETH_GIVE,
    TEETH_LOADED,
)
from core.checks.involute_mesh import Pressed, involute_pressed, refused
from core.checks.pins import BentPins
from core.checks.plastics import by_softest
from core.checks.ring_pins import CYCLOID
from core.design.document import Design
from core.design.results import Results
from core.design.ring import RingBody, RingKind
from core.errors import ImpossibleMechanism, NotKnown
from core.precision import AS_TYPED
from core.ring.sharing import MeshTurn

FIRST_ORDER = 0.02
"""Error of a pressure in first order, of the mesh: of the peak force up to 4 % were seen."""

TEETH: tuple[RingKind, ...] = (*CYCLOID, "involute")
"""Rings of which a mesh is known."""

BODIES: tuple[RingBody, ...] = get_args(RingBody)

_check = partial(
    design_check,
    group="gear",
    part="teeth",
    needs=("load", "contact", "gear"),
    not_of=partial(other_ring, of=TEETH),
)

MODIFICATION = ("gear.modification.equidistant", "gear.modification.pin_circle")

_FIXES = (
    *MODIFICATION,
    "gear.contact_length",
    "gear.ring_pin_radius",
    "contact.eccentricity",
)
"""What may lower the pressure of the teeth, besides the torque."""

_THICKER = ("gear.ring_pin_radius", "gear.sleeve_bore_radius", "gear.span", "load.output_torque")
"""What may cure pins that bend."""


def _error(turn: MeshTurn) -> float:
    """Relative error of what is proportional to the forces of a mesh, of number and model."""
    return float(turn.accuracy.relative_error) + (0.0 if turn.mesh.exact else FIRST_ORDER)


def ring_alone(results: Results) -> str | None:
    """Why a value is of each disc by itself in its ring, where both meshes are in series."""
    return "ring_alone" if results.in_series else None


@_check(
    "ring_pressed",
    title="Interference of the teeth without load",
    unit="mm",
    formula="δ ≤ 0",
    why="With it satellites and ring press without load, and go together by force only.",
    inputs=TEETH_GAPS,
    fixes=(MODIFICATION, "gear.satellite_profile_shift"),
    source="ring_mesh",
)
def ring_pressed(kind: Kind, design: Design, results: Results) -> Check:
    if design.gear.kind == "involute":
        if narrow := refused(results=results, kind=kind, names=("ring_profile_shift",)):
            return narrow  # spaces that have room for the teeth at no eccentricity
        pair = results.ring.pair
        over = -pair.normal_backlash
        felt = over > AS_TYPED * pair.teeth.module
        return judged(kind, over if felt else 0.0, 0.0, impossible=True)
    try:
        over = results.ring.working[0].interference
    except ImpossibleMechanism as why:  # of the forces, which this asks for no more
        angle = why.where.get("crank_angle")
        if angle is None or why.code == "cannot_assemble":  # which says nothing of the teeth
            raise
        own = results.series.teeth if results.in_series else (results.ring.mesh,)
        over = max(teeth.pressing_at(teeth.wave(angle)) for teeth in own)
        if not over > 0:
            raise
        place: dict[str, Any] = why.where | why.params
        said: dict[str, Any] = {"reason": why.code, "params": place, "at": why.where}
        return judged(kind, over, 0.0, impossible=True, **said)
    return judged(kind, over, 0.0, impossible=True, reason=ring_alone(results) or "")


NAMES: dict[RingBody, str] = {
    "pin": "pins or teeth of the ring",
    "disc": "satellites' teeth",
}


def _pressed(results: Results, body: RingBody, *, static: bool) -> Pressed:
    """Largest pressure over the turn, under the dynamic load, or at the peak torque."""
    design = results.design
    if design.gear.kind == "involute":
        factor = design.static_torque / design.pin_torque if static else design.load_factor
        return involute_pressed(results=results, factor=factor)
    turn = results.ring.static if static else results.ring.loading
    value = turn.max_pressure
    pair, angle = turn.hardest_place
    at = {"satellite": pair.satellite, "pin": pair.pin, "crank_angle": angle}
    return Pressed(value, _error(turn), True, at)


def _pressure(body: RingBody) -> Kind:

    def limits(design: Design, results: Results) -> dict[str, Any]:
        """Of a material that has a limit."""
        material = design.lasting_teeth.get(body)
        limit = material and material.limit
        if not limit:
            return {}
        allowed = float(limit.allowable) / design.requirements.pitting_safety
        return {"limit": allowed, "life_factor": limit.life_factor, **whence(limit)}

    @_check(
        f"ring_pressure_{body}",
        unit="MPa",
        title=f"Contact pressure of the {NAMES[body]}",
        formula="p ≤ p_all·Z_NT/S",
        why=f"Above it the surface of the {NAMES[body]} pits within the life.",
        inputs=(TEETH_LOADED, LIFE, "requirements.pitting_safety"),
        fixes=(_FIXES, "load.output_torque"),
        source="ring_mesh",
        known=limits,
    )
    def pressure(kind: Kind, design: Design, results: Results) -> Check:
        pressed = _pressed(results, body, static=False)
        material = design.lasting_teeth[body]
        unknown = "plastic_limit_unknown" if material.plastic else "limit_unknown"
        missing = f"{design.teeth_path(body)}.allowable_pressure"
        limit = judged_by(material.limit, unknown, missing, value=pressed.value, at=pressed.at)
        known = limits(design, results)
        found = judged(
            kind,
            **pressed._asdict(),
            **known,
            reserve=(known["limit"] / pressed.value) ** 2,
        )
        return over_life(found=found, limit=limit)

    return pressure


def _static(body: RingBody) -> Kind:
    @_check(
        f"ring_static_{body}",
        unit="MPa",
        title=f"Contact pressure of the {NAMES[body]} at the peak torque",
        formula="p(T_max) ≤ p_static",
        why=f"Above it the surface of the {NAMES[body]} is dented at once.",
        inputs=(TEETH_GIVE, "load.peak_torque"),
        requires={"load.peak_torque": "no_peak_torque"},
        demands=("load.peak_torque",),
        fixes=(_FIXES, "load.peak_torque"),
        source="static_pressure",
    )
    def static(kind: Kind, design: Design, results: Results) -> Check:
        pressed = _pressed(results, body, static=True)
        limit, source = static_limit(
            material=design.lasting_teeth[body],
            missing=f"{design.teeth_path(body)}.allowable_pressure",
            value=pressed.value,
            at=pressed.at,
        )
        reserve = (limit / pressed.value) ** 2
        return judged(kind, **pressed._asdict(), limit=limit, reserve=reserve, **source)

    return static


@_check(
    "ring_static_cold",
    title="First yield of plastic teeth",
    unit="MPa",
    formula="p ≤ f(ν, μ)·R_min",
    why="Above it the teeth yield under the first load, even cold.",
    inputs=(
        TEETH_GIVE,
        "load.output_torque load.peak_torque contact.dynamic_factor gear.friction_coefficient",
        "gear.rolling",
    ),
    fixes=(_FIXES, "load.output_torque load.peak_torque"),
    source="first_yield",
    needs=("load", "contact", "plastic_teeth"),
)
def ring_static_cold(kind: Kind, design: Design, results: Results) -> Check:
    """Judge the weaker of the satellites' teeth and the ring's teeth or pins."""

    def by(made: Results, *, most: bool = False) -> Check:
        pressed = _pressed(made, "disc", static=True)
        limit = min(made.ring.cold_limit(body, most=most) for body in design.plastic_teeth)
        reserve = None if most else (limit / pressed.value) ** 2
        return judged(kind, **pressed._asdict(), limit=limit, reserve=reserve)

    def most() -> Check:
        return by_softest(results=results, judge=lambda made: by(made, most=True))

    return over_range(least=lambda: by(results), most=most, values=design.usual_in_teeth)


@_check(
    "ring_backlash",
    title="Backlash of the teeth",
    unit="arcmin",
    formula="max(θ₊ − θ₋) ≤ Δφ",
    why="Otherwise the unloaded output turns by more than is asked.",
    inputs=(TEETH_GAPS, "contact.distribution_factor requirements.max_ring_backlash"),
    fixes=(MODIFICATION, "gear.satellite_profile_shift"),
    source="ring_mesh",
    asks="max_ring_backlash",
)
def ring_backlash(kind: Kind, design: Design, results: Results) -> Check | Measure:
    """Of the ring alone; not looked for where nobody asks. Of involute teeth known at once."""
    if design.gear.kind == "involute":
        return Measure(design.members.angle_at_output(max(results.ring.pair.backlash, 0.0)))
    judged_by(design.requirements.max_ring_backlash, "no_limit")
    play = results.ring.working[0].play_in_ring
    return Measure(design.members.angle_at_output(play), reason=ring_alone(results))


@_check(
    "ring_transmission_error",
    title="Transmission error of the teeth",
    unit="arcmin",
    formula="max θ − min θ ≤ TE",
    why="Otherwise the output turns less evenly than is asked.",
    inputs=(RING_FORCES, "requirements.max_transmission_error"),
    fixes=MODIFICATION,
    source="ring_mesh",
    asks="max_transmission_error",
    only_asked=True,
)
def ring_transmission_error(kind: Kind, design: Design, results: Results) -> Check | Measure:
    """Under the torque itself, of both meshes where they are in series; not looked for where nobody
    asks.
    """
    if design.gear.kind == "involute":
        raise NotKnown("tooth_errors_unknown")
    worst = max(turn.transmission_error for turn in results.ring.working)
    return Measure(design.members.angle_at_output(worst), reason=of_both(results))


def _not_bent(design: Design, results: Results) -> str:
    """Why a check is none of pins of the ring that bend; empty where they do."""
    if other := other_ring(design, results, of=CYCLOID):
        return other
    return "pins_in_seats" if design.cycloid.pin_support == "seat" else ""


_bent = partial(_check, not_of=_not_bent)


def _not_seated(design: Design, results: Results) -> str:
    """Why a check is none of pins of the ring in seats; empty where they are."""
    if other := other_ring(design, results, of=CYCLOID):
        return other
    return "" if design.cycloid.pin_support == "seat" else "pins_bend"


def _no_sleeves(design: Design, results: Results) -> str:
    """Why a check is none of sleeves that slide on the pins of the ring; empty where they do."""
    if other := other_ring(design, results, of=CYCLOID):
        return other
    ring = design.cycloid
    return "" if ring.sleeve_bore_radius and not ring.rolling else "no_bush"


def _pins(results: Results) -> BentPins:
    """The pins of the ring, whose forces are solved."""
    model_error = 0.0 if results.ring.mesh.exact else FIRST_ORDER
    return BentPins(results.ring.pin_strength, results.ring.pin, True, model_error)


@_bent(
    "ring_pin_stress",
    title="Static strength of the pins of the ring",
    unit="MPa",
    formula="σ_v ≤ R_e/S_F",
    why="Above it the pins of the ring bend for good.",
    inputs=(RING_LOADED, "load.peak_torque requirements.bending_safety"),
    fixes=_THICKER,
    source="pin_beam",
)
def ring_pin_stress(kind: Kind, design: Design, results: Results) -> Check:
    pins, safety = _pins(results), design.requirements.bending_safety
    return pins.static(kind, safety=safety, at={"pin": pins.found.pin})


@_bent(
    "ring_pin_fatigue",
    title="Fatigue of the pins of the ring",
    formula="n ≥ S_D",
    why="Below it the pins of the ring break after some time where they bend most.",
    inputs=(RING_LOADED, "gear.rotates", FATIGUE, LIFE, "requirements.fatigue_safety"),
    fixes=_THICKER,
    source="shigley",
    keep="above",
)
def ring_pin_fatigue(kind: Kind, design: Design, results: Results) -> Check:
    """By what the fatigue of the pins of the output is judged by."""
    _, pins = results.ring.pin_fatigue_strength, _pins(results)  # known, or raises
    safety = design.requirements.fatigue_safety
    return pins.fatigue(kind, safety=safety, at={"pin": pins.found.pin})


@_bent(
    "ring_pin_slope",
    title="Slope of the pins of the ring in the satellites",
    unit="mrad",
    formula="θ ≤ θ_max",
    why="Above it the teeth carry on their edges.",
    inputs=(RING_LOADED, "requirements.max_slope"),
    fixes=tuple(name for name in _THICKER if name != "gear.span"),
    source="beam",
    asks="max_slope",
)
def ring_pin_slope(kind: Kind, design: Design, results: Results) -> Check | Measure:
    made = results.softest if asked_of(design, "max_slope") else results
    return _pins(made).bent("slope", "slope_satellite")


@_check(
    "ring_seat_pressure",
    title="Pressure of the ring's pins in their seats",
    unit="MPa",
    formula="F/(2·r_p·b) ≤ p_all",
    why="Above it the bores that hold the pins of the ring wear out.",
    inputs=(
        tuple(name for name in RING_LOADED if name not in OF_BENT_PINS),
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
    """Of the force on the area that the pin covers; not looked for where nobody asks."""
    turn = results.ring.loading
    area = 2 * turn.mesh.disc.ring_pin_radius * turn.mesh.contact_length
    pair = turn.peak_pair
    return Measure(
        turn.peak_force / area,
        error=_error(turn),
        at={"satellite": pair.satellite, "pin": pair.pin, "crank_angle": turn.peak_crank_angle},
        reserve=lambda growth: growth,
        solved=True,
    )


@_check(
    "ring_efficiency",
    title="Efficiency of the teeth",
    formula="η ≥ η_min",
    why="Below it more is lost in the teeth than is asked.",
    inputs=(
        RING_FORCES,
        INVOLUTE_TEETH,
        "gear.friction_coefficient requirements.min_ring_efficiency",
    ),
    fixes="gear.friction_coefficient",
    source="user",
    keep="above",
    asks="min_ring_efficiency",
    only_asked=True,
)
def ring_efficiency(kind: Kind, design: Design, results: Results) -> Check | Measure:
    """Its limit is used by the losses; not looked for where nobody asks."""
    loss = results.ring.loss
    exact = design.gear.kind == "involute" or results.ring.working[0].mesh.exact
    unsure = loss.loss_error + (0.0 if exact else FIRST_ORDER)
    return Measure(
        loss.efficiency,
        error=loss.loss_ratio * loss.efficiency * unsure,
        used=lambda limit: (1 - loss.efficiency) / (1 - limit),
    )


@_check(
    "ring_pv",
    title="Pressure times sliding speed of the sleeves of the ring",
    unit="MPa_m_per_s",
    formula="p·v ≤ (pv)_all",
    why="Above it the sleeves on the pins of the ring get hot and wear fast.",
    inputs=(RING_FORCES, SPEEDS, "contact.distribution_of gear.rolling requirements.max_pv"),
    fixes="gear.contact_length load.input_speed load.output_torque",
    source="user",
    not_of=_no_sleeves,
    requires={"load.input_speed": "speed_missing"},
    asks="max_pv",
    only_asked=True,
    needed=False,
)
def ring_pv(kind: Kind, design: Design, results: Results) -> Check | Measure:
    return Measure(results.ring.pv, error=_error(results.ring.working[0]), solved=True)


RING_LOAD = (
    ring_pressed,
    *map(_pressure, BODIES),
    *map(_static, BODIES),
    ring_static_cold,
    ring_backlash,
    ring_transmission_error,
    ring_pin_stress,
    ring_pin_fatigue,
    ring_pin_slope,
    ring_seat_pressure,
    ring_efficiency,
    ring_pv,
)
