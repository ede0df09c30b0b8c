"""All checks of a crank-planetary reducer under its torque, its parts, and what these come to."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import cache

from core.checks import balance, bearings, contacts, demands, pins, teeth, walls
from core.checks.check import (
    Check,
    PartStatus,
    PartVerdict,
    Verdict,
    asked_of,
    cannot_be,
    rank,
    verdict,
)
from core.checks.inputs import paths
from core.design.document import Design
from core.design.results import Results
from core.errors import NotKnown, is_known
from core.hertz import Body

CRANK_CHECKS = {
    kind.code: kind
    for kind in (
        *walls.FITTED,
        demands.clearance,
        *contacts.CONTACT,
        *demands.PLAY,
        *walls.LAYOUT,
        *walls.BODY,
        *pins.BENDING,
        walls.wall_sleeve,
        *pins.HOLLOW,
        *demands.FRICTION,
        *teeth.FORCE,
        walls.gear_room,
        *bearings.LIVES,
        *teeth.MESH,
        *teeth.TIPS,
        *teeth.RING_PINS,
        walls.ring_pin_room,
        teeth.ring_pressed,
        *contacts.TEETH,
        *demands.TURNING,
        *pins.RING_BENDING,
        *demands.SEATS,
        *bearings.OF_SATELLITES,
        *bearings.OF_CRANKSHAFT,
        *bearings.ON_PINS,
        *balance.BALANCE,
    )
}
"""By code, in the order in which those that are judged alike are listed."""

_NEEDS = tuple(dict.fromkeys(need for kind in CRANK_CHECKS.values() for need in kind.needs))
_ASKED_ALONE = tuple(kind.asks for kind in CRANK_CHECKS.values() if kind.asked_alone)


@dataclass(frozen=True, slots=True)
class Part:
    """A part of a reducer."""

    code: str  # its name in requests and answers
    title: str  # its name in English
    own: str = ""  # sections of a design that its checks need besides load and contact
    by_forces: bool = True  # whether these read the pins' forces
    demands: str = ""  # requirements: without its section or one of these nobody asks for it

    @property
    def sections(self) -> tuple[str, ...]:
        """All sections that its checks need."""
        return ("load", "contact", *self.own.split())


PARTS = {
    part.code: part
    for part in (
        Part("contact", "pins in holes"),
        Part("pins", "pins", "pin"),
        Part("teeth", "teeth of satellite and ring", "gear", by_forces=False),
        Part("satellite_bearing", "bearings of the satellites", "gear bearing"),
        Part("crank_bearings", "bearings and balance of the crankshaft", "gear crankshaft"),
        Part("body", "body of the satellite", "satellite_body", by_forces=False),
        Part(
            "losses",
            "friction, wear and efficiency",
            "friction",
            demands="min_efficiency max_sliding_speed max_pv max_wear",
        ),
    )
}
"""By code, in the order in which they are shown."""

MESHES = ("contact", "teeth")
"""Parts without which there are no forces."""

UNCOVERED = ("crankshaft", "output_bearing", "housing", "lubrication", "dynamics")
"""Subjects that no part covers."""


def crank_check(code: str, results: Results) -> Check:
    """One check of a crank-planetary reducer; it says why where it could not be made. A check that
    fails by a value that is assumed, and holds at the mild end of that, is marginal.

    Parameters
    ----------
    code : str
        Which.
    results : Results
        Results of a design.
    """
    kind = CRANK_CHECKS[code]
    check = kind.of(results.design, results)
    assumed = [path for path in results.design.mild if path in kind.inputs]
    if check.status != "fail" or not assumed:
        return check
    ends = [results.milder[path] for path in assumed]
    milder = (kind.of(made.design, made) for made in ends)
    if all(each.status == "fail" for each in milder):
        return check
    return check._replace(status="marginal", impossible=False, reason="default_decides")


def crank_codes(design: Design) -> tuple[str, ...]:
    """Codes of the checks that the sections of a design allow, first of those that need less."""
    there = [need for need in _NEEDS if getattr(design, need)]
    asked = asked_of(design, *_ASKED_ALONE)
    return _codes(frozenset((*there, *asked)), design.scope)


@cache
def _codes(given: frozenset[str], scope: tuple[str, ...]) -> tuple[str, ...]:
    judged = {code: kind for code, kind in CRANK_CHECKS.items() if kind.part in scope}
    needed = {code: kind.sections(given) for code, kind in judged.items()}
    made = [code for code, needs in needed.items() if given.issuperset(needs)]
    return tuple(sorted(made, key=lambda code: len(needed[code])))


def cannot_mesh(results: Results) -> bool:
    """Tell whether pins in holes or teeth cannot be, so that no force is known."""
    kinds = map(CRANK_CHECKS.__getitem__, crank_codes(results.design))
    meshing = (kind.code for kind in kinds if kind.part in MESHES and kind.code != "pins_apart")
    unasked = (
        code for code in meshing if not (CRANK_CHECKS[code].loaded or CRANK_CHECKS[code].asks)
    )
    return cannot_be(crank_check(code, results) for code in unasked)


def crank_checks(results: Results) -> Verdict:
    """All checks of a crank-planetary reducer, as far as they are in its scope: nothing that hangs
    on forces is checked where pins in holes or teeth cannot be.
    """
    design, codes = results.design, crank_codes(results.design)
    checks = [crank_check(code, results) for code in codes if not CRANK_CHECKS[code].loaded]
    unforced = cannot_mesh(results)
    checks += (
        CRANK_CHECKS[code].of(design, results, unforced=True)
        if unforced
        else crank_check(code, results)
        for code in codes
        if CRANK_CHECKS[code].loaded
    )
    return of_parts(design=design, checks=checks)


def of_parts(*, design: Design, checks: Iterable[Check]) -> Verdict:
    """The verdict of a reducer's checks, of which its parts' are made.

    Parameters
    ----------
    design : Design
        The design.
    checks : iterable of Check
        Its checks.
    """
    made = sorted(checks, key=rank)
    parts = tuple(_part(design, part, made) for part in PARTS.values())
    judged = {part.code for part in parts if part.judged}
    pressed = "contact" in design.scope and bool(design.load) and design.touching
    left_out = {
        **{code: code not in judged for code in PARTS},
        "contact_life_pin": pressed and _without_life(design, "pin"),
        "contact_life_hole": pressed and _without_life(design, "hole"),
        "ligament_strength": "body" in judged,
        **dict.fromkeys(UNCOVERED, True),
    }
    return verdict(
        made,
        tuple(name for name, so in left_out.items() if so),
        parts,
        unknown=design.clearance_unknown or any(map(_unknown, made)),
        once="contact" in design.scope and bool(design.load and design.plastics),
    )


def _without_life(design: Design, body: Body) -> bool:
    """True where the limit of the pressure of a body is known, but not that over the life."""
    limit = design.lasting[body].limit
    return limit is not None and not is_known(lambda: limit.life)


NOTHING_KNOWN = paths(
    "limit_unknown static_limit_unknown yield_unknown direction_unknown friction_unknown"
)
"""Reasons for which a check knows nothing of what a body bears, which may be less than all else."""


def _unknown(check: Check) -> bool:
    """True where a check knows nothing of what a body bears, or only a bound above it."""
    bounded = check.status == "fail" and check.reason == "above_any"
    return bounded or (check.opens and check.reason in NOTHING_KNOWN)


def _part(design: Design, part: Part, made: list[Check]) -> PartVerdict:
    """Verdict of a part, by the checks that are made, the one that decides first."""
    if part.code not in design.scope:
        return PartVerdict(code=part.code, status="left_out")
    demanded = asked_of(design, *part.demands.split())
    if part.demands and not demanded and not getattr(design, part.sections[-1]):
        return PartVerdict(code=part.code, status="not_asked")
    own = [check for check in made if check.kind.part == part.code]
    decided = [check for check in own if check.status in ("fail", "marginal", "pass")]
    governing = decided[0].code if decided else None
    if decided and decided[0].status == "fail":
        return PartVerdict(code=part.code, status="fail", governing=governing)
    lacks = list(_lacks(design, part, own))
    if not decided:
        demands = (f"requirements.{name}" for name in part.demands.split())
        lacks.append(NotKnown("nothing_judged", *demands))
    if not lacks:
        marginal = any(check.status == "marginal" for check in decided)
        status: PartStatus = "marginal" if marginal else "pass"
        return PartVerdict(code=part.code, status=status, governing=governing)
    first, missing = lacks[0], dict.fromkeys(name for each in lacks for name in each.missing)
    return PartVerdict(
        code=part.code,
        status="open",
        governing=governing,
        reason=first.code,
        params=first.params,
        refusal=first.refusal,
        missing=tuple(missing),
    )


def _lacks(design: Design, part: Part, own: list[Check]) -> Iterator[NotKnown]:
    """Unknowns of a part, for which it is open."""
    absent = tuple(
        name
        for name in part.sections
        if not (design.rubs if name == "friction" else getattr(design, name))
    )
    if absent:
        yield NotKnown("section_missing", *absent)
    gear = design.gear
    by_forces = part.by_forces
    if part.code == "teeth" and gear and gear.kind == "involute" and not gear.unknown_teeth:
        by_forces = design.mechanism.satellites > 1  # which share by their pins
    if by_forces and design.clearance_unknown:
        known = design.contact.eccentricity is not None
        missing = "contact.hole_clearance" if known else "contact.eccentricity"
        yield NotKnown("clearance_unknown", missing)
    if by_forces and design.rollers and design.rollers.radial_clearance is None:
        yield NotKnown("roller_clearance_unknown", "rollers.radial_clearance")
    if "gear" in part.sections and gear and gear.kind == "cycloid" and gear.modification is None:
        yield NotKnown("modification_unknown", "gear.modification")
    if part.code == "teeth":
        if gear and gear.kind == "involute" and gear.unknown_teeth:
            yield NotKnown("teeth_not_judged", *gear.unknown_teeth)
        elif gear and gear.kind not in ("cycloid", "involute"):
            yield NotKnown("teeth_not_judged")
    elif "gear" in part.sections and gear and gear.kind == "none":
        yield NotKnown("no_ring_force", "gear.kind")
    for check in own:
        if check.opens:
            yield NotKnown(check.reason, *check.missing, refusal=check.refusal, **check.params)
