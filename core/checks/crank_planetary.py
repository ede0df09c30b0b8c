"""All checks of a crank-planetary reducer under its torque, its parts, and their verdicts."""

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
    governs,
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
"""Records of all checks by code, in the order of the list for equal ranks."""

_NEEDS = tuple(dict.fromkeys(need for kind in CRANK_CHECKS.values() for need in kind.needs))
_ASKED_ALONE = tuple(kind.asks for kind in CRANK_CHECKS.values() if kind.asked_alone)


@dataclass(frozen=True, slots=True)
class Part:
    """Part of a reducer."""

    code: str  # name in requests and answers
    title: str  # name in English
    own: str = ""  # sections that its checks need besides load and contact
    by_forces: bool = True  # True if its checks read the forces on pins
    demands: str = ""  # requirements; without its section and any of them it is `not_asked`

    @property
    def sections(self) -> tuple[str, ...]:
        """All sections that the checks of the part need."""
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
"""Parts by code, in the order in which they are shown."""

MESHES = ("contact", "teeth")
"""Parts without which there are no forces."""

UNCOVERED = ("crankshaft", "output_bearing", "housing", "lubrication", "dynamics")
"""Subjects that no part covers."""


def crank_check(code: str, results: Results) -> Check:
    """One check of a crank-planetary reducer, by its code; it states why it could not be made.

    A check that fails by an assumed value, but holds at the mild end of its range, is marginal.
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
    """Codes of the checks that the sections of a design allow, those with fewer needs first."""
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
    """True if pins in holes or teeth cannot mesh, so that no force is known."""
    kinds = map(CRANK_CHECKS.__getitem__, crank_codes(results.design))
    meshing = (kind.code for kind in kinds if kind.part in MESHES and kind.code != "pins_apart")
    unasked = (
        code for code in meshing if not (CRANK_CHECKS[code].loaded or CRANK_CHECKS[code].asks)
    )
    return cannot_be(crank_check(code, results) for code in unasked)


def crank_checks(results: Results) -> Verdict:
    """Verdict of all checks in a reducer's scope; forces are left out if meshes cannot exist."""
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
    """Verdict of a reducer from its checks, by the verdicts of its parts."""
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
    """True if the pressure limit of a body is known, but not over the life."""
    limit = design.lasting[body].limit
    return limit is not None and not is_known(lambda: limit.life)


NOTHING_KNOWN = paths(
    "limit_unknown static_limit_unknown yield_unknown direction_unknown friction_unknown"
)
"""Reasons of a check that does not know the strength of a body, which may be the lowest."""


def _unknown(check: Check) -> bool:
    """True if a check does not know the strength of a body, or only an upper bound of it."""
    bounded = check.status == "fail" and check.reason == "above_any"
    return bounded or (check.opens and check.reason in NOTHING_KNOWN)


def _part(design: Design, part: Part, made: list[Check]) -> PartVerdict:
    """Verdict of a part by the checks that are made; the first in rank decides."""
    if part.code not in design.scope:
        return PartVerdict(code=part.code, status="left_out")
    own = [check for check in made if check.kind.part == part.code]
    decided = [check for check in own if check.status in ("fail", "marginal", "pass")]
    if part.demands and not decided and not asked_of(design, *part.demands.split()):
        return PartVerdict(code=part.code, status="not_asked")
    governing = governs(own)
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
    """Unknown inputs that leave a part open."""
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
        by_forces = design.mechanism.satellites > 1  # several satellites share by their pins
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
