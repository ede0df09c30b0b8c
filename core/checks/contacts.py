"""Checks of contacts: pins in holes, and discs or teeth in their ring.

Each surface of a set is checked for pressure over the life and once, metals also for shakedown and
first yield. Checks of plastics are necessary and never sufficient (`necessary_only`): plastics
creep, wear and soften, and no source states a pressure that they bear for long.
"""

import math
from collections.abc import Callable, Mapping
from functools import partial
from typing import Any, NamedTuple

from core.checks import inputs as of
from core.checks.check import (
    MARGIN,
    Check,
    Element,
    Kind,
    Unjudged,
    judged_by,
    over_range,
)
from core.checks.inputs import paths
from core.checks.teeth import not_cycloid, not_toothed, torque_error
from core.design.document import Design, value_at
from core.design.results import Results
from core.design.ring import RingBody
from core.errors import NotKnown, if_known, required
from core.hertz import SLIDING as KNOWN_SLIDING
from core.hertz import Body, ContactLimit, ElasticMaterial, HertzContact, force_factor, shakedown
from core.numerics.inverse import edge
from core.precision import ROUNDING

DEEP = 3.0
"""Depth of solid material below a contact over its half-width; there the stress is a third of the
pressure, and the largest stress lies at 0.75."""

_HOLES = ("contact", "contact", "touching load")
_TEETH = ("gear", "teeth", "load contact gear")

_SORTS: dict[str, dict[str, Any]] = {
    "pressure": {
        "unit": "MPa",
        "title": "Contact pressure of the {it}",
        "formula": "p ≤ p_all·Z_NT/S",
        "why": "Above it the surface of the {it} pits within the life.",
    },
    "static": {
        "unit": "MPa",
        "title": "Contact pressure of the {it} at the peak torque",
        "formula": "p(T_max) ≤ p_static",
        "why": "Above it the surface of the {it} is dented at once.",
        "requires": {"load.peak_torque": "no_peak_torque"},
        "demands": ("load.peak_torque",),
        "source": "static_pressure",
    },
    "shakedown": {
        "unit": "MPa",
        "title": "Shakedown of the {it}",
        "formula": "p ≤ (2.31 … 2.06)·R_e",
        "why": "Above it the surface of the {it} flows on with every turn.",
        "source": "johnson_shakedown",
    },
    "yield": {
        "unit": "MPa",
        "title": "First yield of the {it}",
        "formula": "p ≤ f(ν, μ)·R_e",
        "why": "Above it the {it} yields in the first turns.",
        "source": "johnson_yield",
    },
}

IN_HOLES: dict[Body, Element] = {
    "pin": Element(
        *_HOLES,
        codes=(
            "pressure=contact_pressure_pin shakedown=contact_shakedown_pin",
            "yield=contact_yield_pin static=contact_static_pin",
        ),
        sorts=_SORTS,
        words={"it": "pin"},
    ),
    "hole": Element(
        *_HOLES,
        codes=(
            "pressure=contact_pressure_hole shakedown=contact_shakedown_hole",
            "yield=contact_yield_hole static=contact_static_hole",
        ),
        sorts=_SORTS,
        words={"it": "hole"},
    ),
}
IN_RING: dict[RingBody, Element] = {
    "pin": Element(
        *_TEETH,
        codes="pressure=ring_pressure_pin static=ring_static_pin",
        sorts=_SORTS,
        words={"it": "pins or teeth of the ring"},
        not_of=not_toothed,
    ),
    "disc": Element(
        *_TEETH,
        codes="pressure=ring_pressure_disc static=ring_static_disc",
        sorts=_SORTS,
        words={"it": "satellites' teeth"},
        not_of=not_toothed,
    ),
}


FIXES = paths(
    "pin.diameter contact.contact_length contact.pin_radius load.pin_circle_radius",
    "mechanism.pins mechanism.satellites load.output_torque contact.fit",
)
"""Inputs that may lower the pressure in the holes."""

_RING_FIXES = (
    of.OF_CLEARANCE,
    "gear.contact_length gear.ring_pin_radius contact.eccentricity",
)
"""Inputs that may lower the pressure of the teeth, besides the torque."""


def _whence(limit: ContactLimit) -> dict[str, str]:
    """Attributes of a check that state the source of its pressure limit."""
    source, criterion = limit.source, limit.criterion
    return {"limit_source": source, "criterion": criterion, "verified": limit.verified or ""}


def _limit_of(material: ElasticMaterial, path: str, **known: Any) -> ContactLimit:
    """Pressure limit of a material; `Unjudged` if it has none."""
    unknown = "plastic_limit_unknown" if material.plastic else "limit_unknown"
    return judged_by(material.limit, unknown, f"{path}.allowable_pressure", **known)


def _over_life(found: Check, limit: ContactLimit) -> Check:
    """Check of a pressure, with a remark on the life that its limit includes. Without a speed the
    least limit counts, and a pressure below the limit without life factor is marginal instead of
    failing.
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


def _static_limit(
    material: ElasticMaterial, path: str, **known: Any
) -> tuple[float, dict[str, str]]:
    """Pressure that a surface bears once, Pa, with its source; `Unjudged` above the limit over the
    life if no static limit is known.
    """
    if material.static_pressure is not None:
        return material.static_pressure, {}
    lasting = _limit_of(material, path, **known)
    if known["value"] > lasting.pressure:
        raise Unjudged("static_limit_unknown", **known)
    return float(lasting.pressure), _whence(lasting)


def _in_disc(
    kind: Kind, results: Results, contact: HertzContact, *, limit: float, **more: Any
) -> Check:
    """Check of a contact's governing pressure with the error of the disc's edge; an edge too near
    leaves it unchecked unless it fails.
    """
    disc, pressure = results.disc_of(contact), contact.governing_pressure
    error = 8 * contact.accuracy.relative_error
    if disc is not None:
        error += disc.params.get("error", 0.0)
        if disc.code != "finite_disc" and pressure <= limit:
            said = {"reason": disc.code, "params": disc.params, "at": more.get("at", {})}
            return Check(kind, "not_checked", value=pressure, limit=limit, **said)
    reserve = more.get("reserve") or math.inf
    solved = results.solved or bool(results.design.pin)
    if not solved and reserve < math.inf:
        solved = results.ovals_under(max(reserve, MARGIN))
    return kind.judged(pressure, limit, error=error, solved=solved, **more)


def _against_limit(kind: Kind, results: Results, **more: Any) -> Check:
    """Check of the pressure in the holes against its limit over the life."""
    return _in_disc(
        kind,
        results,
        results.hertz,
        **kind.known(results.design, results),
        reserve=results.contact_reserves[kind.code],
        at=results.peak,
        **more,
    )


def _pressure(body: Body) -> Kind:
    row = IN_HOLES[body]

    def limit_of(design: Design, results: Results) -> ContactLimit:
        return _limit_of(
            design.lasting[body],
            f"contact.{body}_material",
            value=if_known(lambda: results.hertz.governing_pressure),
            at=if_known(lambda: results.peak) or {},
        )

    def known(design: Design, results: Results) -> dict[str, Any]:
        limit = limit_of(design, results)
        own = results.pressure_limits[row.codes["pressure"]]
        return {"limit": own, "life_factor": limit.life_factor, **_whence(limit)}

    @row.check(
        "pressure",
        inputs=(of.LOADED, of.LIFE, "requirements.pitting_safety"),
        fixes=(FIXES, f"contact.{body}_material"),
        source="yanchevsky_2018",
        known=known,
    )
    def pressure(kind: Kind, design: Design, results: Results) -> Check:
        limit = limit_of(design, results)
        return _over_life(_against_limit(kind, results), limit)

    return pressure


def _flowing(sort: str, body: Body, **more: Any) -> Kind:
    """Check of the pressure against a limit by the yield strength, if yield governs."""
    row = IN_HOLES[body]

    @row.check(
        sort,
        inputs=(of.LOADED, of.SLIDING),
        fixes=(FIXES, f"contact.{body}_material"),
        known=lambda design, results: {"limit": results.pressure_limits[row.codes[sort]]},
    )
    def flowing(kind: Kind, design: Design, results: Results) -> Check:
        material = design.lasting[body]
        if material.plastic:
            return Check(kind, "not_applicable", reason="plastic_rules")
        if not material.yield_governs:
            return Check(kind, "not_applicable", reason="tested_limit")
        path = f"contact.{body}_material.yield_strength"
        strength = judged_by(material.yield_strength, "yield_unknown", path)
        found = _against_limit(kind, results, **more)
        if sort == "yield":
            return found
        pressure, sliding = results.hertz.governing_pressure, results.sliding_friction
        if found.status == "fail":
            if pressure > shakedown(sliding.low) * strength:
                return found
            decides = ("friction.coefficient",)
            return found._replace(status="marginal", reason="range_decides", missing=decides)
        # The pressure lies between first yield and certain progressive yield.
        yields = results.pressure_limits[row.codes["yield"]]
        if sliding.high > KNOWN_SLIDING and pressure > yields:
            return found._replace(status="marginal", reason="shakedown_unknown")
        return found

    return flowing


def _static(body: Body) -> Kind:
    @IN_HOLES[body].check(
        "static",
        inputs=(of.LOADED, "load.peak_torque"),
        fixes=(FIXES, f"contact.{body}_material load.peak_torque"),
    )
    def static(kind: Kind, design: Design, results: Results) -> Check:
        material = design.lasting[body]
        if material.plastic and not material.limit:
            return Check(kind, "not_applicable", reason="plastic_rules")
        contact, contact_at = results.static_contact, results.static_contact_at
        path = f"contact.{body}_material"
        limit, source = _static_limit(material, path, value=contact.governing_pressure)
        reserve = force_factor(contact=contact, contact_at=contact_at, limit=limit)
        return _in_disc(kind, results, contact, limit=limit, reserve=reserve, **source)

    return static


class Pressed(NamedTuple):
    """Contact pressure of a mesh."""

    value: float  # largest pressure, Pa
    error: float  # relative error
    solved: bool  # True if forces are not proportional to the torque
    at: Mapping[str, Any]  # place of the value


def _pressed(results: Results, *, static: bool) -> Pressed:
    """Largest pressure of the teeth over the turn, under the dynamic load or the peak torque; for
    involute teeth that at the start of the path of contact.
    """
    design = results.design
    if design.gear.kind == "involute":
        factor = design.static_torque / design.pin_torque if static else design.load_factor
        load = results.ring.involute_load(factor)
        pressure = required(load.pressure_one_pair_start, "off_involutes")
        error = float(load.accuracy.relative_error) + torque_error(results)
        return Pressed(pressure, error, results.solved, {})
    turn = results.ring.static if static else results.ring.loading
    value = turn.max_pressure
    pair, angle = turn.hardest_place
    at = {"satellite": pair.satellite, "pin": pair.pin, "crank_angle": angle}
    return Pressed(value, turn.accuracy.relative_error, True, at)


def _judged(kind: Kind, pressed: Pressed, limit: float, **more: Any) -> Check:
    """Check of a pressure of the teeth, which grows with the square root of the torque."""
    reserve = (limit / pressed.value) ** 2
    return kind.judged(limit=limit, **{"reserve": reserve, **pressed._asdict(), **more})


def _ring_limit(design: Design, body: RingBody) -> dict[str, Any]:
    """Limit of a material that has one, and whence it is."""
    material = design.lasting_teeth.get(body)
    limit = material and material.limit
    if not limit:
        return {}
    allowed = float(limit.allowable) / design.requirements.pitting_safety
    return {"limit": allowed, "life_factor": limit.life_factor, **_whence(limit)}


def _ring_pressure(body: RingBody) -> Kind:
    def limits(design: Design, results: Results) -> dict[str, Any]:
        return _ring_limit(design, body)

    @IN_RING[body].check(
        "pressure",
        inputs=(of.TEETH_LOADED, of.LIFE, "requirements.pitting_safety"),
        fixes=(_RING_FIXES, "load.output_torque"),
        source="ring_mesh",
        known=limits,
    )
    def pressure(kind: Kind, design: Design, results: Results) -> Check:
        pressed, path = _pressed(results, static=False), design.teeth_path(body)
        limit = _limit_of(design.lasting_teeth[body], path, value=pressed.value, at=pressed.at)
        return _over_life(_judged(kind, pressed, **_ring_limit(design, body)), limit)

    return pressure


@Element(*_TEETH, not_of=not_cycloid)(
    "ring_pieces",
    title="Ring pin that stands out",
    unit="MPa",
    formula="p(t_r/2) ≤ p_all·Z_NT/S",
    why="A ring pin half its zone ahead of the others bears most of the torque alone.",
    inputs=(of.TEETH_LOADED, of.LIFE, "requirements.pitting_safety tolerances.ring_pin_position"),
    fixes=(_RING_FIXES, "tolerances.ring_pin_position load.output_torque"),
    source="ring_mesh",
    needed=False,
)
def ring_pieces(kind: Kind, design: Design, results: Results) -> Check:
    """Judge the pressure on one ring pin that is thicker by half the zone of the pins' places."""
    if design.deviations and design.deviations.of_ring:
        return Check(kind, "not_applicable", reason="pins_placed")
    pressure = results.ring.pressure_on_high_pin
    for body in IN_RING:
        _limit_of(design.lasting_teeth[body], design.teeth_path(body), value=pressure)
    least = min((_ring_limit(design, body) for body in IN_RING), key=lambda each: each["limit"])
    return kind.judged(pressure, warning="pin_stands_out", solved=True, **least)


def _ring_static(body: RingBody) -> Kind:
    @IN_RING[body].check(
        "static",
        inputs=(of.TEETH_GIVE, "load.peak_torque"),
        fixes=(_RING_FIXES, "load.peak_torque"),
    )
    def static(kind: Kind, design: Design, results: Results) -> Check:
        pressed, path = _pressed(results, static=True), design.teeth_path(body)
        seen = {"value": pressed.value, "at": pressed.at}
        limit, source = _static_limit(design.lasting_teeth[body], path, **seen)
        return _judged(kind, pressed, limit, **source)

    return static


def _necessary(
    results: Results, values: Mapping[str, Any], by: Callable[[Results, bool], Check]
) -> Check:
    """Necessary check of a pressure: judged by the least strength that sources state, it fails for
    certain by the largest strength and the least moduli. Numbers are those of the largest moduli.
    """

    def most() -> Check:
        found, softest = by(results, True), results.softest
        if found.status != "fail" or softest is results:
            return found
        return found if by(softest, True).status == "fail" else found._replace(status="pass")

    return over_range(least=lambda: by(results, False), most=most, values=values)


_COLD: dict[str, Any] = {"unit": "MPa", "source": "first_yield"}

_plastic = Element("plastic", "contact", "plastics load")


@Element(*_TEETH, not_of=not_toothed)(
    "ring_static_cold",
    title="First yield of plastic teeth",
    formula="p ≤ f(ν, μ)·R_min",
    why="Above it the teeth yield under the first load, even cold.",
    inputs=(
        of.TEETH_GIVE,
        "load.output_torque load.peak_torque load.application_factor gear.friction_coefficient",
        "gear.rolling",
    ),
    fixes=(_RING_FIXES, "load.output_torque load.peak_torque"),
    needs="load contact plastic_teeth",
    **_COLD,
)
def ring_static_cold(kind: Kind, design: Design, results: Results) -> Check:
    """Judge the weaker of satellite teeth and ring teeth or pins."""

    def by(made: Results, most: bool) -> Check:
        pressed = _pressed(made, static=True)
        limit = min(made.ring.cold_limit(body, most=most) for body in design.plastic_teeth)
        return _judged(kind, pressed, limit, **{"reserve": None} if most else {})

    return _necessary(results, design.usual_in_teeth, by)


Grown = tuple[HertzContact, Callable[[float], HertzContact]]
"""Contact, and function that gives the contact under a factor on its force."""


def _yielding(
    kind: Kind, results: Results, loaded: Callable[[Results], Grown], part: Mapping[Body, float]
) -> Check:
    """Check of the pressure in the holes against a share of the yield pressure of the weaker
    plastic body; the limit falls as the contact wraps around its pin.
    """

    def least(contact: HertzContact, most: bool = False) -> float:
        cold = partial(results.cold_limit, contact=contact, most=most)
        return min(cold(body) * share for body, share in part.items())

    def reserve_of(contact: HertzContact, at: Callable[[float], HertzContact]) -> float:
        """Factor on the force at which it yields."""

        def left(factor: float) -> float:
            there = at(factor)
            return least(there) - float(there.governing)

        first = force_factor(contact=contact, contact_at=at, limit=least(contact))
        inside, outside = sorted((1.0, first))
        if not left(inside) >= 0 or left(outside) >= 0:
            return first
        met, _ = edge(inside=inside, outside=outside, excess=left)
        return met * (1 - 512 * ROUNDING)  # stay below a jump of the limit despite rounding

    def by(made: Results, most: bool) -> Check:
        limit = least(loaded(results)[0], most)
        reserve = None if most else reserve_of(*loaded(made))
        contact, _ = loaded(made)
        return _in_disc(kind, made, contact, limit=limit, reserve=reserve, at=results.peak)

    return _necessary(results, results.design.usual_in_holes, by)


@_plastic(
    "contact_static_cold",
    title="First yield of the plastic",
    formula="p ≤ f(ν, μ)·R_min",
    why="Above it the plastic yields under the first load, even cold.",
    inputs=(of.LOADED, of.SLIDING, "load.peak_torque"),
    fixes=(FIXES, "load.peak_torque"),
    **_COLD,
)
def contact_static_cold(kind: Kind, design: Design, results: Results) -> Check:
    def loaded(made: Results) -> Grown:
        return made.static_contact, made.static_contact_at

    return _yielding(kind, results, loaded, dict.fromkeys(design.plastics, 1.0))


@_plastic(
    "creep",
    title="Creep of the plastic",
    unit="MPa",
    formula="p ≤ f(ν, μ)·R_min·k_lt",
    why="Above it the plastic goes on giving way under the load.",
    inputs=(of.LOADED, of.SLIDING),
    fixes=FIXES,
    source="long_term",
)
def creep(kind: Kind, design: Design, results: Results) -> Check:
    """Judge by the given long-term part of the short-term strength."""

    def loaded(made: Results) -> Grown:
        largest = made.line_load_factor
        return made.hertz, lambda factor: made.contact_at(factor * largest)

    lasting = dict[Body, float]()
    for body, plastic in design.plastics.items():
        path = f"contact.{body}_material.long_term_factor"
        lasting[body] = required(plastic.long_term_factor, "creep_unknown", path)
    return _yielding(kind, results, loaded, lasting)


def _not_printed(design: Design, results: Results) -> str:
    """Code of the reason why holes have no infill behind their walls; empty if they may."""
    printed = "hole" in design.plastics and design.plastics["hole"].layered
    return "" if printed else "not_printed"


@_plastic(
    "contact_solid_depth",
    title="Solid material below the contact",
    unit="mm",
    formula="3·a ≤ w",
    why="Below a thinner wall lies the infill, which gives way.",
    inputs=(of.LOADED, "load.peak_torque satellite_body.solid_wall"),
    fixes=("satellite_body.solid_wall", FIXES),
    source="solid_depth",
    not_of=_not_printed,
)
def contact_solid_depth(kind: Kind, design: Design, results: Results) -> Check:
    """Judge holes that may be printed in layers with infill behind their walls."""
    given = design.satellite_body.solid_wall if design.satellite_body else None
    depth = DEEP * float(results.static_contact.half_width)
    wall = judged_by(given, "solid_wall_unknown", "satellite_body.solid_wall", value=depth)

    def by(made: Results) -> Check:
        depth = DEEP * float(made.static_contact.half_width)
        return kind.judged(depth, wall, reserve=(wall / depth) ** 2, solved=True)

    moduli = {
        path: each for path, each in design.usual_in_holes.items() if path.endswith("modulus")
    }
    return over_range(least=lambda: by(results.softest), most=lambda: by(results), values=moduli)


def _temperature(kind: Kind, design: Design, body: Body) -> Check:
    """Check of the temperature of one body against its softening range."""
    path = "temperatures.satellite" if body == "hole" else "temperatures.pins"
    given = required(value_at(design, path), "temperature_unknown", path)
    name = f"contact.{body}_material"
    known = required(design.plastics[body].softening, "softening_unknown", name)
    return over_range(
        least=lambda: kind.judged(given, known.low),
        most=lambda: kind.judged(given, known.high),
        values={name: known},
    )


@_plastic(
    "temperature",
    title="Temperature of the plastic",
    unit="C",
    formula="T ≤ T_soft",
    why="Above it the plastic goes soft; a motor nearby is enough for that.",
    inputs=("temperatures.satellite temperatures.pins", of.MATERIALS),
    fixes="temperatures.satellite temperatures.pins",
    source="heat_deflection",
)
def temperature(kind: Kind, design: Design, results: Results) -> Check:
    """Judge the failing body, or else the first body of unknown temperature."""
    found, unknown = [], []
    for body in design.plastics:
        try:
            found.append(_temperature(kind, design, body))
        except NotKnown as why:
            unknown.append(why)
    failing = [check for check in found if check.status == "fail"]
    if unknown and not failing:
        raise unknown[0]
    return max(failing or found, key=lambda check: check.utilisation or 0.0)


@_plastic(
    "fatigue_plastic",
    title="Fatigue of the plastic",
    formula="N ≥ N_L",
    why="Every turn loads each place of the holes once, and plastics have no endurance limit.",
    inputs=of.MATERIALS,
    keep="above",
    source="no_source",
)
def fatigue_plastic(kind: Kind, design: Design, results: Results) -> Check:
    return Check(kind, "not_checked", reason="no_plastic_fatigue")


@Element(*_HOLES)(
    "contact_conformity",
    title="Width of the contact",
    formula="a/r ≤ 0.159",
    why="No check any more: wide contacts have a pressure of their own.",
    source="hertz",
)
def contact_conformity(kind: Kind, design: Design, results: Results) -> Check:
    """Keep the code of a former check for one release."""
    return Check(kind, "not_applicable", reason="conformal_solution")


PLASTICS = (contact_static_cold, contact_solid_depth, temperature, creep, fatigue_plastic)
CONTACT = (
    *map(_pressure, IN_HOLES),
    *(_flowing("shakedown", body) for body in IN_HOLES),
    *(_flowing("yield", body, warning="plastic_first") for body in IN_HOLES),
    *map(_static, IN_HOLES),
    contact_conformity,
    *PLASTICS,
)
TEETH = (
    *map(_ring_pressure, IN_RING),
    ring_pieces,
    *map(_ring_static, IN_RING),
    ring_static_cold,
)
