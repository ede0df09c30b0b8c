"""Checks of plastic pins and holes: what is necessary, none of which is enough.

A plastic creeps, wears and goes soft, and no source says what pressure a contact of it bears for
long. So each check here may fail, and none passes: what holds is `necessary_only`.
"""

import math
from collections.abc import Callable, Mapping
from functools import partial

from core.checks.check import Check, design_check, judged, necessary
from core.checks.inputs import LOADED, SLIDING
from core.checks.pin_contact import FIXES, in_disc
from core.derived import if_known
from core.design.document import Design
from core.design.results import Results
from core.errors import NotKnown
from core.hertz import HertzContact, force_factor
from core.materials import Body
from core.numerics.inverse import edge

DEEP = 3.0
"""Depth of solid material below a contact over its half-width: there the pressure has fallen to a
third, and the largest stress lies at 0.75."""

_check = partial(
    design_check,
    group="plastic",
    part="contact",
    needs=("plastics", "load"),
)


@_check(
    "contact_static_cold",
    title="First yield of the plastic",
    unit="MPa",
    formula="p ≤ f(ν, μ)·R_min",
    why="Above it the plastic yields under the first load, even cold.",
    inputs=(*LOADED, *SLIDING, "load.peak_torque"),
    fixes=(*FIXES, "load.peak_torque"),
    source="first_yield",
)
def contact_static_cold(design: Design, results: Results) -> Check:
    """Of the weaker body; where its friction is not known it fails where it would without."""
    unknown = [] if design.hole_friction is not None else [friction_unknown()]
    limits, contact = list[float](), results.static_contact
    for body in design.plastics:
        try:
            limits.append(results.cold_limit(body, contact))
        except NotKnown as why:
            unknown.append(why)
    if not limits:
        raise unknown[0]
    pressure, limit = contact.governing_pressure, min(limits)
    if pressure is None:
        raise NotKnown("contact_wraps")
    found = in_disc(
        kind=contact_static_cold,
        results=results,
        contact=contact,
        pressure=pressure,
        limit=limit,
        reserve=_yielding(contact, results.static_contact_at, results),
        at=results.peak,
    )
    if found.status == "fail" or not unknown:
        return necessary(found)
    first = unknown[0]
    return Check(
        contact_static_cold,
        "not_checked",
        value=pressure,
        reason=first.code,
        missing=first.missing,
        at=found.at,
    )


def _yielding(
    contact: HertzContact,
    contact_at: Callable[[float], HertzContact],
    results: Results,
    lasting: Mapping[Body, float] | None = None,
) -> float:
    """Factor on the force at which the first plastic body whose strength is known yields, or a part
    of it that lasts is reached: the limit falls as the contact wraps around its pin.
    """

    def limit(there: HertzContact) -> float:
        known = (if_known(partial(results.cold_limit, each, there)) for each in bodies)
        return min(
            one * (lasting[each] if lasting else 1.0)
            for each, one in zip(bodies, known, strict=True)
            if one is not None
        )

    def left(factor: float) -> float:
        there = contact_at(factor)
        pressure = there.governing_pressure
        return math.nan if pressure is None else limit(there) - float(pressure)

    bodies = results.design.plastics
    first = force_factor(contact=contact, contact_at=contact_at, limit=limit(contact))
    inside, outside = sorted((1.0, first))
    if not left(inside) >= 0 or left(outside) >= 0:
        return first
    return edge(inside=inside, outside=outside, excess=left)[0]


def friction_unknown() -> NotKnown:
    """That nothing is known of the friction in the holes."""
    return NotKnown("friction_unknown", "friction.coefficient")


@_check(
    "contact_solid_depth",
    title="Solid material below the contact",
    unit="mm",
    formula="3·a ≤ w",
    why="Below a thinner wall lies the infill, which gives way.",
    inputs=(*LOADED, "load.peak_torque", "satellite_body.solid_wall"),
    fixes=("satellite_body.solid_wall", *FIXES),
    source="solid_depth",
)
def contact_solid_depth(design: Design, results: Results) -> Check:
    """Of holes that may be printed in layers, with infill behind their walls."""
    kind, plastic = contact_solid_depth, design.lasting["hole"].plastic
    if plastic is None or not plastic.layered:
        return Check(kind, "not_applicable", reason="not_printed")
    wall = design.satellite_body.solid_wall if design.satellite_body else None
    depth = DEEP * float(results.static_contact.half_width)
    if wall is None:
        missing = ("satellite_body.solid_wall",)
        return Check(kind, "not_checked", value=depth, reason="solid_wall_unknown", missing=missing)
    return necessary(judged(kind, depth, wall, reserve=(wall / depth) ** 2, rough=True))


def _temperature(design: Design, body: Body) -> Check:
    """One body against the temperature at which it goes soft."""
    plastic = design.lasting[body].plastic
    name = "satellite" if body == "hole" else "pins"
    given = getattr(design.temperatures, name) if design.temperatures else None
    if given is None:
        raise NotKnown("temperature_unknown", f"temperatures.{name}")
    if plastic is None or plastic.softening is None:
        raise NotKnown("softening_unknown", f"contact.{body}_material")
    return necessary(judged(temperature, given, plastic.softening))


@_check(
    "temperature",
    title="Temperature of the plastic",
    unit="C",
    formula="T ≤ T_soft",
    why="Above it the plastic goes soft; a motor nearby is enough for that.",
    inputs=(
        "temperatures.satellite",
        "temperatures.pins",
        "contact.pin_material",
        "contact.hole_material",
    ),
    fixes=("temperatures.satellite", "temperatures.pins"),
    source="heat_deflection",
)
def temperature(design: Design, results: Results) -> Check:
    """Of the body that fails, else of the first that is not known."""
    found, unknown = [], []
    for body in design.plastics:
        try:
            found.append(_temperature(design, body))
        except NotKnown as why:
            unknown.append(why)
    failing = [check for check in found if check.status == "fail"]
    if unknown and not failing:
        raise unknown[0]
    return max(failing or found, key=lambda check: check.utilisation or 0.0)


@_check(
    "creep",
    title="Creep of the plastic",
    unit="MPa",
    formula="p ≤ f(ν, μ)·R_min·k_lt",
    why="Above it the plastic goes on giving way under the load.",
    inputs=(*LOADED, *SLIDING),
    fixes=FIXES,
    source="long_term",
)
def creep(design: Design, results: Results) -> Check:
    """By the part of the short strength that whoever gives it has found to last."""
    lasting = dict[Body, float]()
    for body in design.plastics:
        plastic = design.lasting[body].plastic
        if plastic is None or plastic.long_term_factor is None:
            raise NotKnown("creep_unknown", f"contact.{body}_material.long_term_factor")
        lasting[body] = plastic.long_term_factor
    if design.hole_friction is None:
        raise friction_unknown()
    contact, largest = results.hertz, results.line_load_factor
    limit = min(share * results.cold_limit(body, contact) for body, share in lasting.items())
    pressure = contact.governing_pressure
    if pressure is None:
        raise NotKnown("contact_wraps")
    found = in_disc(
        kind=creep,
        results=results,
        contact=contact,
        pressure=pressure,
        limit=limit,
        reserve=_yielding(
            contact, lambda factor: results.contact_at(factor * largest), results, lasting
        ),
        at=results.peak,
    )
    return necessary(found)


@_check(
    "fatigue_plastic",
    title="Fatigue of the plastic",
    formula="N ≥ N_L",
    why="Every turn loads each place of the holes once, and plastics have no endurance limit.",
    inputs=("contact.pin_material", "contact.hole_material"),
    fixes=(),
    keep="above",
    source="no_source",
)
def fatigue_plastic(design: Design, results: Results) -> Check:
    return Check(fatigue_plastic, "not_checked", reason="no_plastic_fatigue")


PLASTICS = (contact_static_cold, contact_solid_depth, temperature, creep, fatigue_plastic)
