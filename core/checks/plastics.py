"""Checks of plastic pins and holes: what is necessary, none of which is enough.

A plastic creeps, wears and goes soft, and no source says what pressure a contact of it bears for
long. So each check here may fail, and none passes: what holds is `necessary_only`.
"""

from collections.abc import Callable, Mapping
from functools import partial

from core.checks.check import Check, Kind, design_check, judged, judged_by, over_range
from core.checks.contact import FIXES, in_disc
from core.checks.inputs import LOADED, SLIDING
from core.design.document import Design, value_at
from core.design.results import Results
from core.errors import NotKnown, required
from core.hertz import Body, HertzContact, force_factor
from core.numerics.inverse import edge
from core.precision import ROUNDING

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
    inputs=(LOADED, SLIDING, "load.peak_torque"),
    fixes=(FIXES, "load.peak_torque"),
    source="first_yield",
)
def contact_static_cold(kind: Kind, design: Design, results: Results) -> Check:
    """Judge the weaker body of the contact."""

    def by(made: Results, *, most: bool = False) -> Check:
        contact, reserve = made.static_contact, None
        limits = cold_limits(results=results, contact=results.static_contact, most=most)
        if not most:
            reserve = _yielding(contact, made.static_contact_at, made)
        return in_disc(
            kind=kind,
            results=made,
            contact=contact,
            pressure=contact.governing_pressure,
            limit=min(limits.values()),
            reserve=reserve,
            at=results.peak,
        )

    def most() -> Check:
        return by_softest(results=results, judge=lambda made: by(made, most=True))

    return over_range(least=lambda: by(results), most=most, values=design.usual_in_holes)


def cold_limits(
    *, results: Results, contact: HertzContact, most: bool = False
) -> dict[Body, float]:
    """Pressures at which plastic bodies of a contact yield at once.

    Parameters
    ----------
    results : Results
        Results of the design.
    contact : HertzContact
        The contact.
    most : bool
        Whether those at which they do for certain are wanted, not the least ones.

    Returns
    -------
    dict
        Pa, by body.
    """
    return {body: results.cold_limit(body, contact, most=most) for body in results.design.plastics}


def by_softest(*, results: Results, judge: Callable[[Results], Check]) -> Check:
    """A pressure that fails for certain, as it does with the least moduli that sources have, too.

    Parameters
    ----------
    results : Results
        Results of a design.
    judge : callable
        The check of such results.

    Returns
    -------
    Check
        Its numbers are those of the largest moduli.
    """
    found = judge(results)
    if found.status != "fail" or results.softest is results:
        return found
    return found if judge(results.softest).status == "fail" else found._replace(status="pass")


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
        strengths = cold_limits(results=results, contact=there)
        return min(one * lasting[body] if lasting else one for body, one in strengths.items())

    def left(factor: float) -> float:
        there = contact_at(factor)
        return limit(there) - float(there.governing)

    first = force_factor(contact=contact, contact_at=contact_at, limit=limit(contact))
    inside, outside = sorted((1.0, first))
    if not left(inside) >= 0 or left(outside) >= 0:
        return first
    met, _ = edge(inside=inside, outside=outside, excess=left)
    return met * (1 - 512 * ROUNDING)  # not beyond a jump of the limit by the rounding of forces


def _not_printed(design: Design, results: Results) -> str:
    """Why holes have no infill behind their walls; empty where they may."""
    printed = "hole" in design.plastics and design.plastics["hole"].layered
    return "" if printed else "not_printed"


@_check(
    "contact_solid_depth",
    title="Solid material below the contact",
    unit="mm",
    formula="3·a ≤ w",
    why="Below a thinner wall lies the infill, which gives way.",
    inputs=(LOADED, "load.peak_torque satellite_body.solid_wall"),
    fixes=("satellite_body.solid_wall", FIXES),
    source="solid_depth",
    not_of=_not_printed,
)
def contact_solid_depth(kind: Kind, design: Design, results: Results) -> Check:
    """Of holes that may be printed in layers, with infill behind their walls."""
    given = design.satellite_body.solid_wall if design.satellite_body else None
    depth = DEEP * float(results.static_contact.half_width)
    wall = judged_by(given, "solid_wall_unknown", "satellite_body.solid_wall", value=depth)

    def by(made: Results) -> Check:
        depth = DEEP * float(made.static_contact.half_width)
        reserve = (wall / depth) ** 2
        return judged(kind, depth, wall, reserve=reserve, solved=True)

    moduli = {
        path: each for path, each in design.usual_in_holes.items() if path.endswith("modulus")
    }
    return over_range(least=lambda: by(results.softest), most=lambda: by(results), values=moduli)


def _temperature(design: Design, body: Body) -> Check:
    """One body against the temperature at which it goes soft."""
    path = "temperatures.satellite" if body == "hole" else "temperatures.pins"
    given = required(value_at(design, path), "temperature_unknown", path)
    softening = design.plastics[body].softening
    name = f"contact.{body}_material"
    known = required(softening, "softening_unknown", name)
    return over_range(
        least=lambda: judged(temperature, given, known.low),
        most=lambda: judged(temperature, given, known.high),
        values={name: known},
    )


@_check(
    "temperature",
    title="Temperature of the plastic",
    unit="C",
    formula="T ≤ T_soft",
    why="Above it the plastic goes soft; a motor nearby is enough for that.",
    inputs="temperatures.satellite temperatures.pins contact.pin_material contact.hole_material",
    fixes="temperatures.satellite temperatures.pins",
    source="heat_deflection",
)
def temperature(kind: Kind, design: Design, results: Results) -> Check:
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
    inputs=(LOADED, SLIDING),
    fixes=FIXES,
    source="long_term",
)
def creep(kind: Kind, design: Design, results: Results) -> Check:
    """By the part of the short strength that whoever gives it has found to last."""
    lasting = dict[Body, float]()
    for body, plastic in design.plastics.items():
        path = f"contact.{body}_material.long_term_factor"
        lasting[body] = required(plastic.long_term_factor, "creep_unknown", path)

    def by(made: Results, *, most: bool = False) -> Check:
        contact, largest, reserve = made.hertz, made.line_load_factor, None
        limits = cold_limits(results=results, contact=results.hertz, most=most)
        if not most:
            reserve = _yielding(
                contact, lambda factor: made.contact_at(factor * largest), made, lasting
            )
        return in_disc(
            kind=kind,
            results=made,
            contact=contact,
            pressure=contact.governing_pressure,
            limit=min(share * limits[body] for body, share in lasting.items()),
            reserve=reserve,
            at=results.peak,
        )

    def most() -> Check:
        return by_softest(results=results, judge=lambda made: by(made, most=True))

    return over_range(least=lambda: by(results), most=most, values=design.usual_in_holes)


@_check(
    "fatigue_plastic",
    title="Fatigue of the plastic",
    formula="N ≥ N_L",
    why="Every turn loads each place of the holes once, and plastics have no endurance limit.",
    inputs="contact.pin_material contact.hole_material",
    keep="above",
    source="no_source",
)
def fatigue_plastic(kind: Kind, design: Design, results: Results) -> Check:
    return Check(kind, "not_checked", reason="no_plastic_fatigue")


PLASTICS = (contact_static_cold, contact_solid_depth, temperature, creep, fatigue_plastic)
