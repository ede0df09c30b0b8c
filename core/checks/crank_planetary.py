"""Checks of a crank-planetary reducer: cranks, fit of pin and hole, walls; all of its parts."""

import cmath
import math
from functools import partial

from core.checks.check import (
    Check,
    Measure,
    Status,
    Verdict,
    asked,
    attempt,
    judged,
    not_checked,
    verdict,
    wall,
)
from core.checks.crank import BEARING, GEAR, SHAFT, within_roots
from core.checks.design_check import Judge
from core.checks.friction import FRICTION
from core.checks.pin_contact import CONTACT, life_considered
from core.checks.pins import PIN_FATIGUE, PINS
from core.checks.play import PLAY
from core.derived import if_known
from core.design.document import Design
from core.design.real_forces import RealForces
from core.design.results import Results
from core.errors import NotKnown
from core.output.mechanism import assembly_angles


def _dead_centre(design: Design, results: Results) -> Check:
    zones, code = design.driven.phases.dead_zones(), "dead_centre"
    if not zones:
        return Check(code=code, status="pass", value=0.0, limit=0.0)
    start = zones[0][0] * design.mechanism.built.crank_angle_per_wave
    return judged(code, float(len(zones)), 0.0, impossible=True, at={"crank_angle": start})


def _crank_balance(design: Design, results: Results) -> Check:
    angles = design.mechanism.built.crank_angles
    off = abs(sum(cmath.exp(1j * angle) for angle in angles)) / len(angles)
    return judged("crank_balance", off if off > 1e-9 else 0.0, 0.0, warning="unbalanced")


def _assembly(design: Design, results: Results) -> Check:
    teeth = design.mechanism.satellite_teeth
    if teeth is None:
        missing = ("mechanism.satellite_teeth",)
        return Check(code="assembly", status="not_asked", missing=missing)
    angles = assembly_angles(mechanism=design.mechanism.built, satellite_teeth=teeth)
    different = sum(not each.identical for each in angles)
    return judged("assembly", float(different), 0.0, warning="different_parts")


def _interference(design: Design, results: Results) -> Check:
    """By geometry, before any force: the room over the turn."""
    code, clearance = "interference", design.known_clearance
    try:
        fit = results.fit
    except NotKnown as why:
        if clearance >= 0 and not design.deviations:  # the room is the clearance
            return judged(code, clearance, 0.0)._replace(utilisation=None)
        if not design.load:
            raise
        if clearance < 0:  # of all pairs alike
            lacking = {
                "satellite": 1,
                "pin": 1,
                "missing_length": -clearance,
                "needed_length": design.contact.pair.hole_radius - clearance,
            }
            found = Check(code=code, status="fail", value=clearance, limit=0.0, impossible=True)
            return found._replace(reason="cannot_assemble", params=lacking)
        return not_checked(code, why, limit=0.0)
    at: dict[str, float] = {}
    if fit.room.binding:
        pair = fit.room.binding[0]
        at = {"satellite": pair.satellite, "pin": pair.pin}
    if fit.room.crank_angle is not None:
        at["crank_angle"] = fit.room.crank_angle
    misfit = fit.misfit
    status: Status = "fail"
    if not misfit or misfit == "fits_by_bearing_clearance":
        status = "marginal" if misfit else "pass"
    return Check(
        code=code,
        status=status,
        value=0.0 if status == "pass" and fit.room.least < 0 else fit.room.least,
        limit=0.0,
        reason=misfit,
        params=fit.refusal().params if misfit == "cannot_assemble" else {},
        impossible=status == "fail" and misfit != "pressed_without_load",
        at=at,
    )


MOST_PLAY = 0.75
"""Clearance over the eccentricity above which a design is marginal: the play is a large part of
what the mechanism moves by."""


def _clearance(design: Design, results: Results) -> Check:
    code, clearance = "clearance", design.known_clearance
    share = max(clearance, 0.0) / design.known_eccentricity
    wanted = [
        PLAY[name](design, results).status == "pass"
        for name in ("backlash", "lost_motion")
        if share > MOST_PLAY and getattr(design.requirements, f"max_{name}") is not None
    ]
    if wanted and all(wanted):  # as much play as is asked for
        return Check(code=code, status="pass", value=share, limit=MOST_PLAY)
    ratio = {"ratio": share}
    return judged(code, share, MOST_PLAY, warning="clearance_like_eccentricity", params=ratio)


def _between(code: str, design: Design, radius: float, least: float | None = None) -> Check:
    """The wall or the gap between neighbours on the pin circle."""
    pins = design.mechanism.pins
    if pins < 2:
        return Check(code=code, status="not_applicable", reason="one_only")
    pitch = 2 * design.load.pin_circle_radius * math.sin(math.pi / pins)
    return wall(code, width=pitch - 2 * radius, size=radius, least=least)


def _wall_holes(design: Design, results: Results) -> Check:
    return _between(
        "wall_holes", design, design.contact.pair.hole_radius, design.requirements.min_wall
    )


def _pins_apart(design: Design, results: Results) -> Check:
    return _between("pins_apart", design, design.contact.pair.pin_radius)


def _holes_off_centre(design: Design, results: Results) -> Check:
    size = design.contact.pair.hole_radius
    return wall("holes_off_centre", width=design.load.pin_circle_radius - size, size=size)


def _wall_rim(design: Design, results: Results) -> Check:
    if math.isinf(design.roots[1]):
        return Check(code="wall_rim", status="not_asked", missing=("satellite_body.outer_radius",))
    return within_roots(design=design, code="wall_rim", least=design.requirements.min_wall)


def _wall_bore(design: Design, results: Results) -> Check:
    bore, size = design.satellite_body.bore_radius, design.contact.pair.hole_radius
    if bore is None:
        missing = ("satellite_body.bore_radius",)
        return Check(code="wall_bore", status="not_asked", missing=missing)
    width = design.load.pin_circle_radius - size - bore
    return wall("wall_bore", width=width, size=size, least=design.requirements.min_wall)


def _outer_diameter(design: Design, results: Results) -> Check:
    """Of the circle in which a satellite moves."""
    code, limit = "outer_diameter", design.requirements.max_outer_diameter

    def circle() -> Measure:
        radius = design.satellite_body.outer_radius if design.satellite_body else None
        if radius is None:
            raise NotKnown("size_missing", "satellite_body.outer_radius")
        return Measure(2 * (radius + design.known_eccentricity))

    return asked(code, limit, circle, name="max_outer_diameter")


Table = dict[str, Judge]

MECHANISM: Table = {
    "dead_centre": _dead_centre,
    "crank_balance": _crank_balance,
    "assembly": _assembly,
}
FIT: Table = {"interference": _interference, "clearance": _clearance}
PLACE: Table = {
    "wall_holes": _wall_holes,
    "pins_apart": _pins_apart,
    "holes_off_centre": _holes_off_centre,
}
SPACE: Table = {"outer_diameter": _outer_diameter}
SATELLITE: Table = {"wall_rim": _wall_rim, "wall_bore": _wall_bore} | SPACE
_ALL = (
    MECHANISM | CONTACT | FIT | PLAY | PLACE | SATELLITE
    | PINS | PIN_FATIGUE | FRICTION | GEAR | BEARING | SHAFT
)  # fmt: skip


def crank_check(code: str, results: Results) -> Check:
    """One check of a crank-planetary reducer; it says why where it could not be made.

    Parameters
    ----------
    code : str
        Which.
    results : Results
        Results of a design.

    Returns
    -------
    Check
    """
    return attempt(code, partial(_ALL[code], results.design, results))


def crank_codes(design: Design) -> tuple[str, ...]:
    """The checks that the sections of a design allow.

    Parameters
    ----------
    design : Design
        The design.

    Returns
    -------
    tuple of str
        Their codes.
    """
    tables = dict(MECHANISM)
    if design.touching:
        tables |= FIT
    if design.requirements.max_outer_diameter is not None:
        tables |= SPACE
    if design.touching and design.load:
        tables |= CONTACT | PLAY | PLACE
        for section, table in SECTIONS.items():
            if getattr(design, section):
                tables |= table
    return tuple(tables)


SECTIONS: dict[str, Table] = {
    "satellite_body": SATELLITE,
    "pin": PINS,
    "fatigue": PIN_FATIGUE,
    "friction": FRICTION,
    "gear": GEAR,
    "bearing": BEARING,
    "crankshaft": SHAFT,
}
"""What is checked where a section of a design is there, besides mechanism, load and contact."""


def crank_checks(results: Results) -> Verdict:
    """All checks of a crank-planetary reducer.

    Parameters
    ----------
    results : Results
        Results of a design.

    Returns
    -------
    Verdict
    """
    design = results.design
    pressed = bool(design.load) and design.touching
    forces = if_known(lambda: results.judged_forces) if pressed else None
    fit = if_known(lambda: results.fit)
    solved = design.as_made and isinstance(forces, RealForces)
    solved = solved or (fit is not None and fit.impossible)
    absent = {
        "load": not design.load,
        "contact": not design.touching,
        "satellite_body": not design.satellite_body,
        "clearance": not solved,
        "contact_life_pin": pressed and not life_considered(design=design, body="pin"),
        "contact_life_hole": pressed and not life_considered(design=design, body="hole"),
        **{name: not getattr(design, name) for name in SECTIONS if name != "satellite_body"},
    }
    return verdict(
        [crank_check(code, results) for code in crank_codes(design)],
        tuple(name for name, so in absent.items() if so),
    )
