"""Checks of pins in holes: dead centres, satellites alike; their room over the turn and the play
that it leaves the output; walls and gaps between them; pressure, shakedown, first yield where they
touch. Those of plastics alone are in `core.checks.plastics`.
"""

import math
from functools import partial
from typing import Any, get_args

from core.checks.check import (
    MARGIN,
    Check,
    Kind,
    Measure,
    Status,
    Unjudged,
    asked_of,
    design_check,
    gap,
    judged,
    judged_by,
    make_check,
    not_checked,
    wall,
)
from core.checks.inputs import HOLE, LIFE, LOADED, RING_GIVES, SHARING, SLIDING
from core.design.document import Design
from core.design.results import Results
from core.errors import NotKnown, if_known, is_known
from core.hertz import SLIDING as KNOWN_SLIDING
from core.hertz import (
    Body,
    ContactLimit,
    ElasticMaterial,
    HertzContact,
    force_factor,
    shakedown,
)
from core.output.fit import FITS
from core.output.mechanism import assembly_angles

BODIES: tuple[Body, ...] = get_args(Body)

FIXES = (
    "pin.diameter",
    "contact.contact_length",
    "contact.pin_radius",
    "load.pin_circle_radius",
    "mechanism.pins",
    "mechanism.satellites",
    "load.output_torque",
    "contact.fit",
)
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

_of_mechanism = partial(design_check, group="mechanism", part="contact")
_of_room = partial(
    design_check,
    group="geometry",
    part="contact",
    fixes="contact.hole_radius contact.fit",
    needs=("touching",),
)
_of_play = partial(
    _of_room, group="play", unit="arcmin", source="load_sharing", needs=("touching", "load")
)
_placed = partial(
    design_check,
    group="geometry",
    part="contact",
    unit="mm",
    keep="above",
    needs=("touching", "load"),
)
_pressed = partial(
    design_check,
    group="contact",
    part="contact",
    inputs=LOADED,
    fixes=FIXES,
    needs=("touching", "load"),
)


@_of_mechanism(
    "dead_centre",
    title="Dead centres",
    formula="Δθ < 180°",
    why="There no pair drives, and no torque is transmitted.",
    inputs="mechanism.pins mechanism.satellites mechanism.crank_spacing mechanism.crank_angles",
    fixes="mechanism.pins mechanism.satellites",
    source="yanchevskiy_2021",
)
def dead_centre(kind: Kind, design: Design, results: Results) -> Check:
    zones = design.driven.phases.dead_zones()
    if not zones:
        return Check(kind, "pass", value=0.0, limit=0.0)
    start = zones[0][0] * design.built.crank_angle_per_wave
    at = {"crank_angle": start}
    return judged(kind, float(len(zones)), 0.0, impossible=True, at=at)


@_of_mechanism(
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
    return judged(kind, float(different), 0.0, warning="different_parts")


@_of_room(
    "interference",
    title="Room of the pins in their holes",
    unit="mm",
    formula="min(C − |P·exp(−iθ) − H|) ≥ 0",
    why="Otherwise the parts cannot be put together, jam, or press without load.",
    inputs=(HOLE, "contact.eccentricity deviations rollers.radial_clearance"),
    keep="above",
)
def interference(kind: Kind, design: Design, results: Results) -> Check:
    """By geometry, before any force: the room over the turn."""
    clearance = design.known_clearance
    try:
        room = results.rooms.room
        misfit = "" if room.state == "fits" else results.fit.misfit
    except NotKnown as why:
        if clearance >= 0 and not design.deviations:  # the room is the clearance
            return judged(kind, clearance, 0.0)._replace(utilisation=None)
        if not design.load:
            raise
        if clearance < 0:  # of all pairs alike
            lacking = {
                "satellite": 1,
                "pin": 1,
                "missing_length": -clearance,
                "needed_length": design.nominal_pair.hole_radius - clearance,
            }
            found = Check(kind, "fail", value=clearance, limit=0.0, impossible=True)
            return found._replace(reason="cannot_assemble", params=lacking)
        return not_checked(kind, why)._replace(limit=0.0)
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
        "mechanism.pins mechanism.satellites mechanism.crank_spacing mechanism.crank_angles",
        "mechanism.ratio load.pin_circle_radius",
        HOLE,
        "contact.eccentricity deviations crank_support rollers.radial_clearance",
        "requirements.max_backlash contact.distribution_factor",
        OF_TEETH,
    ),
    asks="max_backlash",
)
def backlash(kind: Kind, design: Design, results: Results) -> Measure:
    of_fit = design.known_clearance and 0.0  # none, or interference
    play = results.loading.turn.backlash_max if results.solved else of_fit
    return Measure(design.members.angle_at_output(play), reason=of_both(results))


@_of_play(
    "lost_motion",
    title="Lost motion of the output mechanism",
    formula="θ(+3 % T) − θ(−3 % T) ≤ Δφ",
    why="Otherwise the output gives way by more than is asked when the torque turns.",
    inputs=(
        "load.output_torque contact.distribution_factor load.pin_circle_radius mechanism.pins",
        "mechanism.satellites mechanism.crank_spacing mechanism.crank_angles mechanism.ratio",
        SHARING,
        "requirements.max_lost_motion",
        RING_GIVES,
        "gear.modification.rotation",
    ),
    asks="max_lost_motion",
)
def lost_motion(kind: Kind, design: Design, results: Results) -> Measure:
    """At the torque itself, of which it takes a share; not solved for where nobody asks. Asked, it
    is that of the softest material that sources allow.
    """
    solved = results.solved and design.load_factor == 1
    asked, _ = asked_of(design, "max_lost_motion"), design.known_clearance
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
    inputs=(HOLE, "contact.eccentricity"),
    source="yanchevskiy_2021",
)
def clearance(kind: Kind, design: Design, results: Results) -> Check:
    share = max(design.known_clearance, 0.0) / design.known_eccentricity
    wanted = [
        make_check(play, design, results).status == "pass"
        for play in (backlash, lost_motion)
        if share > MOST_PLAY and asked_of(design, play.asks)
    ]
    if wanted and all(wanted):  # as much play as is asked for
        return Check(kind, "pass", value=share, limit=MOST_PLAY)
    ratio = {"ratio": share}
    return judged(kind, share, MOST_PLAY, warning="clearance_like_eccentricity", params=ratio)


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
    inputs="mechanism.pins load.pin_circle_radius contact.hole_radius requirements.min_wall",
    fixes="load.pin_circle_radius contact.pin_radius mechanism.pins",
    source="wang_2016",
)
def wall_holes(kind: Kind, design: Design, results: Results) -> Check:
    radius, least = design.nominal_pair.hole_radius, design.requirements.min_wall
    width = _between(design, radius)
    if math.isinf(width):
        return Check(kind, "not_applicable", reason="one_only")
    return wall(kind, width=width, size=radius, least=least, guide=design.wall_guide)


@_placed(
    "pins_apart",
    title="Space between pins",
    formula="2·R·sin(π/N) − 2·r_in > 0",
    why="Otherwise the pins overlap.",
    inputs="mechanism.pins load.pin_circle_radius contact.pin_radius",
    fixes="load.pin_circle_radius contact.pin_radius mechanism.pins",
)
def pins_apart(kind: Kind, design: Design, results: Results) -> Check:
    radius = design.nominal_pair.pin_radius
    width = _between(design, radius)
    if math.isinf(width):
        return Check(kind, "not_applicable", reason="one_only")
    return gap(kind, width=width, size=radius)


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
    return gap(kind, width=design.load.pin_circle_radius - size, size=size)


def _against_limit(kind: Kind, results: Results, warning: str = "") -> Check:
    """The governing pressure against its limit."""
    design, contact = results.design, results.hertz
    return in_disc(
        kind=kind,
        results=results,
        contact=contact,
        pressure=contact.governing_pressure,
        **kind.known(design, results),
        reserve=results.contact_reserves[kind.code],
        warning=warning,
        at=results.peak,
    )


def in_disc(
    *,
    kind: Kind,
    results: Results,
    contact: HertzContact,
    pressure: float,
    limit: float,
    **more: Any,
) -> Check:
    """The pressure against a limit, with what the edge of the disc makes of it: near enough nothing
    passes.

    Parameters
    ----------
    kind : Kind
        The check.
    results : Results
        Results of the design.
    contact : HertzContact
        The contact that is judged.
    pressure, limit : float
        Its governing pressure and the limit of that, Pa.
    **more
        What `judged` is told besides.

    Returns
    -------
    Check
    """
    disc = results.disc_of(contact)
    error = (contact.conformal_error or 0.0) + 8 * contact.accuracy.relative_error
    if disc is not None:
        error += disc.params.get("error", 0.0)
        if disc.code != "finite_disc" and pressure <= limit:
            said = {"reason": disc.code, "params": disc.params, "at": more.get("at", {})}
            return Check(kind, "not_checked", value=pressure, limit=limit, **said)
    reserve = more.get("reserve") or math.inf
    solved = results.solved or bool(results.design.pin)
    if not solved and reserve < math.inf:
        solved = results.ovals_under(max(reserve, MARGIN))
    return judged(kind, pressure, limit, error=error, solved=solved, **more)


def whence(limit: ContactLimit) -> dict[str, str]:
    """Where a limit of the pressure comes from.

    Parameters
    ----------
    limit : ContactLimit
        The limit.

    Returns
    -------
    dict
        Attributes of a check.
    """
    return {
        "limit_source": limit.source,
        "criterion": limit.criterion,
        "verified": limit.verified or "",
    }


def over_life(*, found: Check, limit: ContactLimit) -> Check:
    """A pressure against a limit, with how much of the life that has in it, where nothing else is
    said. Without a speed the limit is the least one, and a pressure that holds the one without
    life factor fails by what is not given.

    Parameters
    ----------
    found : Check
        The pressure, judged.
    limit : ContactLimit
        The limit.

    Returns
    -------
    Check
    """
    if found.reason:
        return found
    try:
        life = limit.life
    except NotKnown as why:
        return found._replace(reason=why.code, missing=why.missing)
    if life.loads == limit.loads:
        return found._replace(reason="life_of_teeth")
    value, least = found.compared
    found = found._replace(reason="life_without_speed", missing=("load.input_speed",))
    if found.status == "fail" and value <= least / life.factor:
        return found._replace(status="marginal", reason="range_decides")
    return found


def static_limit(
    *, material: ElasticMaterial, missing: str, value: float, **known: Any
) -> tuple[float, dict[str, Any]]:
    """What a surface bears once: what it bears for ever it bears once too.

    Parameters
    ----------
    material : ElasticMaterial
        Of the surface.
    missing : str
        Core name of its limit.
    value : float
        Pressure that it is to bear, Pa.
    **known
        What else is known of the check.

    Returns
    -------
    tuple of float and dict
        The limit, Pa, and whence it is.

    Raises
    ------
    Unjudged
        If it is not known, as beyond a lasting limit.
    """
    if material.static_pressure is not None:
        return material.static_pressure, {}
    unknown = "plastic_limit_unknown" if material.plastic else "limit_unknown"
    lasting = judged_by(material.limit, unknown, missing, value=value, **known)
    if value > lasting.pressure:
        raise Unjudged("static_limit_unknown", value=value, **known)
    return float(lasting.pressure), whence(lasting)


def _pressure(body: Body) -> Kind:
    code = f"contact_pressure_{body}"

    def limit_of(design: Design, results: Results) -> ContactLimit:
        """That of the material, which has to have one."""
        return judged_by(
            design.lasting[body].limit,
            "plastic_limit_unknown" if body in design.plastics else "limit_unknown",
            f"contact.{body}_material.allowable_pressure",
            value=if_known(lambda: results.hertz.governing_pressure),
            at=if_known(lambda: results.peak) or {},
        )

    def known(design: Design, results: Results) -> dict[str, Any]:
        limit = limit_of(design, results)
        return {
            "limit": results.pressure_limits[code],
            "life_factor": limit.life_factor,
            **whence(limit),
        }

    @_pressed(
        code,
        unit="MPa",
        title=f"Contact pressure of the {body}",
        formula="p ≤ p_all·Z_NT/S",
        why=f"Above it the surface of the {body} pits within the life.",
        inputs=(LOADED, LIFE, "requirements.pitting_safety"),
        fixes=(FIXES, f"contact.{body}_material"),
        source="yanchevsky_2018",
        known=known,
    )
    def pressure(kind: Kind, design: Design, results: Results) -> Check:
        limit = limit_of(design, results)
        return over_life(found=_against_limit(kind, results), limit=limit)

    return pressure


def _plastic(body: Body, name: str, warning: str = "", **said: str) -> Kind:
    """The pressure against one by the yield strength, where that governs."""
    code = f"contact_{name}_{body}"

    @_pressed(
        code,
        unit="MPa",
        inputs=(LOADED, SLIDING),
        fixes=(FIXES, f"contact.{body}_material"),
        known=lambda design, results: {"limit": results.pressure_limits[code]},
        **said,
    )
    def plastic(kind: Kind, design: Design, results: Results) -> Check:
        material = design.lasting[body]
        if body in design.plastics:
            return Check(kind, "not_applicable", reason="plastic_rules")
        if not material.yield_governs:
            return Check(kind, "not_applicable", reason="tested_limit")
        path = f"contact.{body}_material.yield_strength"
        strength = judged_by(material.yield_strength, "yield_unknown", path)
        found = _against_limit(kind, results, warning)
        if name == "yield":
            return found
        pressure, sliding = results.hertz.governing_pressure, results.sliding_friction
        if found.status == "fail":
            if pressure > shakedown(sliding.low) * strength:
                return found
            decides = ("friction.coefficient",)
            return found._replace(status="marginal", reason="range_decides", missing=decides)
        # between the pressure up to which nothing yields and the one from which it goes on
        yields = results.pressure_limits[f"contact_yield_{body}"]
        if sliding.high > KNOWN_SLIDING and pressure > yields:
            return found._replace(status="marginal", reason="shakedown_unknown")
        return found

    return plastic


def _shakedown(body: Body) -> Kind:
    return _plastic(
        body,
        "shakedown",
        title=f"Shakedown of the {body}",
        formula="p ≤ (2.31 … 2.06)·R_e",
        why=f"Above it the surface of the {body} flows on with every turn.",
        source="johnson_shakedown",
    )


def _yield(body: Body) -> Kind:
    return _plastic(
        body,
        "yield",
        warning="plastic_first",
        title=f"First yield of the {body}",
        formula="p ≤ f(ν, μ)·R_e",
        why=f"Above it the {body} yields in the first turns.",
        source="johnson_yield",
    )


def _static(body: Body) -> Kind:
    @_pressed(
        f"contact_static_{body}",
        unit="MPa",
        title=f"Contact pressure of the {body} at the peak torque",
        formula="p(T_max) ≤ p_static",
        why=f"Above it the surface of the {body} is dented at once.",
        inputs=(LOADED, "load.peak_torque"),
        requires={"load.peak_torque": "no_peak_torque"},
        demands=("load.peak_torque",),
        fixes=(FIXES, f"contact.{body}_material", "load.peak_torque"),
        source="static_pressure",
    )
    def static(kind: Kind, design: Design, results: Results) -> Check:
        material = design.lasting[body]
        if body in design.plastics and not material.limit:
            return Check(kind, "not_applicable", reason="plastic_rules")
        contact = results.static_contact
        pressure = contact.governing_pressure
        missing = f"contact.{body}_material.allowable_pressure"
        limit, source = static_limit(material=material, missing=missing, value=pressure)
        return in_disc(
            kind=kind,
            results=results,
            contact=contact,
            pressure=pressure,
            limit=limit,
            reserve=force_factor(
                contact=contact, contact_at=results.static_contact_at, limit=limit
            ),
            **source,
        )

    return static


@design_check(
    "contact_conformity",
    title="Width of the contact",
    group="contact",
    part="contact",
    formula="a/r ≤ 0.159",
    why="No check any more: wide contacts have a pressure of their own.",
    source="hertz",
    needs=("touching", "load"),
)
def contact_conformity(kind: Kind, design: Design, results: Results) -> Check:
    """For one release."""
    return Check(kind, "not_applicable", reason="conformal_solution")


def life_considered(*, design: Design, body: Body) -> bool:
    """Whether the limit of the pressure of a body, if one is known, is that over the life.

    Parameters
    ----------
    design : Design
        The design.
    body : {"pin", "hole"}
        Whose surface.

    Returns
    -------
    bool
    """
    limit = design.lasting[body].limit
    return not limit or is_known(lambda: limit.life)


CRANKS = (dead_centre, assembly)
FIT = (interference, clearance)
CONTACT = (
    *map(_pressure, BODIES),
    *map(_shakedown, BODIES),
    *map(_yield, BODIES),
    *map(_static, BODIES),
    contact_conformity,
)
PLAY = (backlash, lost_motion)
LAYOUT = (wall_holes, pins_apart, holes_off_centre)
