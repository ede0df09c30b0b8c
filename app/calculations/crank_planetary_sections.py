"""Request for a crank-planetary reducer: design, sections of the answer and their needs."""

import math
import time
from collections.abc import Callable, Iterator
from functools import cached_property, partial
from typing import Any, ClassVar, Literal, Self, get_args

from pydantic import Field, PrivateAttr, model_validator

from app.calculations.both_meshes import RingTurnOut
from app.calculations.checks import (
    FixesFor,
    codes_to_fix,
    fix_values,
    judgement,
    lacking,
    places_of,
    usual_values,
)
from app.calculations.combined import combined
from app.calculations.crank_planetary_answer import (
    ColdYieldOut,
    DesignHertzOut,
    DesignLossesOut,
    EnvelopeOut,
    LoadSharingOut,
    MassOut,
    PartMassOut,
)
from app.calculations.crankshaft import CrankshaftResponse
from app.calculations.design_mesh import mesh_of
from app.calculations.document import TORQUE, TOUCHING, DocumentFields, Needs, StrengthFields
from app.calculations.geometry_answer import GeometryOut
from app.calculations.hertz import entry_of
from app.calculations.ideal_forces import (
    ContactForceResponse,
    CyclogramResponse,
    ForceCurvesOut,
)
from app.calculations.load_sharing_answer import RealCyclogramOut
from app.calculations.mechanism import MAX_PAIRS, FitOut
from app.calculations.members_answer import MembersOut, at_output
from app.calculations.pin_rollers_answer import RollersOut
from app.calculations.pin_strength import PinStrengthResponse
from app.calculations.reducer_fixes import fixes_of
from app.calculations.ring_mesh_answer import RingDrawingOut
from app.calculations.satellite_bearing import (
    SatelliteBearingResponse,
)
from app.calculations.shares_answer import SharesOut, shares_warnings
from app.calculations.usual_fit_answer import UsualFitOut, UsualModificationOut
from app.model import (
    Angle,
    Maybe,
    ResponseModel,
    Values,
    notices_of,
    pointer,
    present,
    quantity,
    timed,
    warning,
)
from app.rules import field_error
from app.settings import Settings
from app.units import to_si
from app.worked import Steps
from core.checks.check import Verdict
from core.checks.cold_yield import ColdYield, cold_yield
from core.checks.crank_planetary import cannot_mesh
from core.checks.reserve import crank_verdict
from core.checks.shares import disc_shares
from core.checks.usual_modification import (
    UsualModification,
    usual_clearance_too,
    usual_modification,
)
from core.design.crank_results import MOST_BEARING_PAIRS
from core.design.drawings import pins_in_holes, ring_drawing
from core.design.mass import mass
from core.design.real_forces import RealForces
from core.design.results import MOST_IN_SERIES, MOST_PIN_PAIRS, Results
from core.errors import CalculationError, Notice, if_known, is_known
from core.fixes.changes import Search
from core.fixes.crank import possible
from core.fixes.fix import Fix
from core.materials import NOT_LISTED
from core.output.contact_force import ContactForce, ForceCurves, PairNumber, drawing_angles
from core.output.mechanism import Mechanism
from core.output.real_cyclogram import RealCyclogram, carried_forces, real_cyclogram
from core.output.turn import Turn
from core.ring.series_turn import SeriesOverTurn
from core.worked.crank import bearing_steps, shaft_steps
from core.worked.hertz import judged_steps
from core.worked.losses import loss_steps
from core.worked.mechanism import clearance_steps, cyclogram_steps, force_steps
from core.worked.members import member_steps
from core.worked.pin_rollers import roller_steps
from core.worked.pins import strength_steps
from core.worked.ring import ring_steps
from core.worked.step import Step

Section = Literal[
    "cyclogram",
    "members",
    "contact_force",
    "load_sharing",
    "real_cyclogram",
    "hertz",
    "pin_strength",
    "output_efficiency",
    "ring_mesh",
    "ring_drawing",
    "satellite_bearing",
    "crankshaft",
    "rollers",
    "geometry",
    "usual_fit",
    "usual_modification",
    "envelope",
    "mass",
    "checks",
    "largest_torque",
    "fixes",
    "combined",
    "worked",
]

SECTIONS: tuple[Section, ...] = get_args(Section)

_TOUCHING = ("load", "contact")
_MESHING = ("load", "contact/eccentricity_mm", "gear/modification")
_TURNING = (*_TOUCHING, "load/input_speed_rpm", "contact/eccentricity_mm")

NEEDS_OF: dict[Section, Needs] = {
    "cyclogram": (),
    "members": ("load",),
    "contact_force": ("load",),
    "load_sharing": _TOUCHING,
    "real_cyclogram": _TOUCHING,
    "hertz": _TOUCHING,
    "pin_strength": (*_TOUCHING, "pin"),
    "output_efficiency": (*_TURNING, "friction"),
    "ring_mesh": _MESHING,
    "ring_drawing": _MESHING,
    "satellite_bearing": (*_TURNING, "gear", "bearing"),
    "crankshaft": (*_TURNING, "gear", "crankshaft"),
    "rollers": (*_TOUCHING, "contact/eccentricity_mm", "rollers"),
    "geometry": _TOUCHING,
    "usual_fit": (*_TOUCHING, "contact/eccentricity_mm"),
    "usual_modification": ("load", "contact/eccentricity_mm", "gear"),
    "envelope": _TOUCHING,
    "mass": (*_TOUCHING, "contact/eccentricity_mm"),
    "checks": (),
    "largest_torque": (),
    "fixes": (),
    "combined": (),
    "worked": (),
}
"""Sections and fields of the request that each section of the answer needs."""

INVOLUTE_NEEDS = (
    "load",
    "contact/eccentricity_mm",
    *(f"gear/{body}_profile_shift" for body in ("satellite", "ring")),
)
"""Sections and fields that sections of an involute mesh need."""

JUDGED = frozenset(("checks", "largest_torque", "fixes", "combined"))
"""Sections that depend on the verdict."""

SEARCHED = frozenset(("fixes", "combined", "usual_fit", "usual_modification"))
"""Sections that search among designs."""

SHARE = 0.6
"""Part of the time of a request after which the search for fixes ends: what was found is then
judged and answered."""

BUILT = frozenset(("envelope", "mass"))
"""Sections that follow from sizes of housing and carrier."""

SOLVED = frozenset(("load_sharing", "real_cyclogram", "ring_mesh", "ring_drawing"))
"""Sections whose forces are solved."""

STRENGTH: tuple[Section, ...] = (
    "pin_strength",
    "output_efficiency",
    "satellite_bearing",
    "crankshaft",
    "rollers",
)
"""Sections of strength and life."""

BY_FORCES = ("load_sharing", "real_cyclogram", "hertz", "ring_mesh", *STRENGTH)
"""Sections that depend on judged forces."""

MOST_PAIRS: dict[Section, int] = {
    "pin_strength": MOST_PIN_PAIRS,
    "satellite_bearing": MOST_BEARING_PAIRS,
    "crankshaft": MOST_BEARING_PAIRS,
    "rollers": MOST_BEARING_PAIRS,
}
"""Largest number of pairs that each section is calculated for."""


class CrankPlanetaryRequest(StrengthFields, group="mechanism"):
    """Design document of the reducer, and the sections of the answer that are wanted.

    Judged forces are ideal, or those of the mechanism as it is made if clearance, deviations, a
    contact law or elastic satellites are given; perfect parts whose pins bend are solved too,
    without clearance, unless a `distribution_factor` above 1 states the uneven sharing. Discs on
    bearings stated by `crank_support` float.
    """

    NEEDS: ClassVar[Needs] = ("mechanism/pins",)
    USES: ClassVar[frozenset[str]] = frozenset(DocumentFields.model_fields)
    NEEDED_OF: ClassVar[dict[str, Needs]] = {
        "load": TORQUE,
        "contact": TOUCHING,
        "pin": ("pin/satellite_positions_mm",),
    }

    crank_angle_deg: Angle = quantity("Crank angle", "φ", default=0.0, step=5, advanced=True)
    """Crank angle at which the section `geometry` is calculated."""
    include: Maybe[list[Section]] = Field(
        min_length=1,
        max_length=len(SECTIONS),
        description="Sections of the answer: what is not named is not computed, nor the verdict "
        "without checks, largest_torque, fixes or combined. Where it is absent: the verdict and "
        "all but real_cyclogram, geometry, usual_fit, usual_modification, mass, checks, "
        "largest_torque, fixes and combined, as far as their input is given; envelope where "
        "build is given; members where others than the pins are the output; load_sharing where "
        "clearance, deviations, a contact law, satellites that give or pins that bend are. "
        "load_sharing and hertz with these are left out then where the forces cannot be solved. "
        "What rests on the forces of parts that cannot be put together is always: the check "
        "interference says why.",
    )
    fixes_for: FixesFor = Field(
        default="governing", description="Checks that the section `fixes` has to cure."
    )

    @model_validator(mode="after")
    def _parts_for_sections(self) -> Self:
        for section in self.include or ():
            for part in self._needs(section):
                if not self.has(part):
                    raise field_error(part, "needed_for", section=section)
        return self

    def _needs(self, section: Section) -> tuple[str, ...]:
        """Needs of a section of the answer; involute teeth need their profile shifts too."""
        teeth = section in ("ring_mesh", "ring_drawing") and self.ring_kind == "involute"
        return INVOLUTE_NEEDS if teeth else NEEDS_OF[section]

    def assumed(self) -> Iterator[tuple[tuple[str, ...], Any]]:
        """Assumed values, the most important first, with yield values of plastics from sources,
        values that judge checks, and friction of metals if it matters.
        """
        said = dict(super().assumed())
        try:
            design = self.design
        except CalculationError:  # a solution is requested for a size that makes no design yet
            yield from said.items()
            return
        own = {self._place(name): each for name, each in design.usual_values.items()}
        if "verdict" not in self.__dict__:  # requests for other results have no such field
            yield from (said | own).items()
            return
        checks = self.verdict.checks
        every = usual_values(self, self.verdict) | said | own
        flows = (each for each in checks if each.code.startswith("contact_shakedown"))
        if any(each.reason == "range_decides" for each in flows):
            every[("friction", "coefficient")] = design.hole_friction
        missed = [each for each in checks if each.reason == "default_decides"]
        first = [
            self._place(name)
            for name in design.mild
            if any(name in each.kind.inputs for each in missed)
        ]
        first += own if any(each.reason == "range_decides" for each in checks) else ()
        places = dict.fromkeys((*first, *said, *own, *every))
        yield from ((place, every[place]) for place in places)

    def _place(self, name: str) -> tuple[str, ...]:
        return tuple(map(str, self.path_of(name)))

    @property
    def builds(self) -> bool:
        """True if sizes of housing and carrier are given, or answered."""
        return super().builds or not BUILT.isdisjoint(self.include or ())

    def without(self, path: tuple[str, ...]) -> Values:
        """Peak force of one satellite, if forces are requested and the number is assumed."""
        return super().without(path) if "contact_force" in self.sections else {}

    def cost(self) -> float:
        """Number of points of its cyclogram and ideal forces; infinite for solutions."""
        include, given = self.include or (), self.given.keys()
        cranked = not given.isdisjoint(("bearing", "crankshaft"))
        searches = "pin" in given or (cranked and "gear" in given)
        solves = not SOLVED.isdisjoint(include)
        solves |= self.says("gear/modification") or self.says("requirements/max_lost_motion_arcmin")
        loaded = given >= {"load", "contact"}
        solves = solves or (loaded and not searches and not self.ideal)
        if SEARCHED & {*include} or (loaded and (searches or solves)):
            return math.inf
        if self.load is None:
            return self.mechanism.cost()
        return self.mechanism.points(
            exponent=self.load.force_exponent,
            samples=self.load.curve_samples,
            revolutions=self.mechanism.revolutions,
        )

    @cached_property
    def sections(self) -> list[Section]:
        """Sections of the answer."""
        wanted = self.include or self.usual_sections()
        return [each for each in wanted if not self._unfit(each)]

    def usual_sections(self) -> list[Section]:
        """Sections of the answer if none are named."""
        usual: tuple[Section, ...] = ("cyclogram", "contact_force", "hertz", *STRENGTH)
        if self.mechanism.output != "pins":
            usual = ("members", *usual)
        allowed = [each for each in usual if all(map(self.has, NEEDS_OF[each]))]
        allowed = [
            each for each in allowed if self.mechanism.pairs <= MOST_PAIRS.get(each, MAX_PAIRS)
        ]
        if self.says("build") and is_known(lambda: self.design.envelope):
            allowed.append("envelope")
        if self._draws_ring:
            allowed.append("ring_mesh")
        if not self.results.solved or "hertz" not in allowed:
            return allowed
        if not is_known(lambda: self.results.judged_forces):
            return [each for each in allowed if each != "hertz" and each not in STRENGTH]
        return [*allowed, "load_sharing"]

    @property
    def _draws_ring(self) -> bool:
        """True if the ring mesh is answered without being named, as it can be solved."""
        given, found = all(map(self.has, self._needs("ring_mesh"))), self.results
        if self.ring_kind == "involute":
            return given and is_known(lambda: found.ring.involute_load(1.0))
        return given and is_known(lambda: found.ring.working)

    def _unfit(self, section: Section) -> bool:
        """True if a section depends on forces of parts that cannot be assembled."""
        solved = section == "geometry" and self.results.solved
        return (section in BY_FORCES or solved) and self.unforced

    _ends: float = PrivateAttr(default=math.inf)

    def refuse_beyond(self, settings: Settings) -> None:
        """Refuse inputs beyond the operator's limits, and lists that do not fit the mechanism."""
        self._ends = time.monotonic() + SHARE * settings.max_seconds
        if self.load:
            self.load.refuse_beyond(settings)
        super().refuse_beyond(settings)

    def late(self) -> bool:
        """True if so little of the time is left that the search for fixes has to end."""
        return time.monotonic() > self._ends

    @cached_property
    def verdict(self) -> Verdict:
        """The verdict of the design."""
        return crank_verdict(self.results, largest=self.asks_largest)

    @cached_property
    def unforced(self) -> bool:
        """True if no force is known, as parts cannot be assembled."""
        return cannot_mesh(self.results)

    def steps(self) -> Steps:
        """Worked steps of the named sections, or of all usual sections that have steps."""
        named = [each for each in self.sections if each in WORKED]
        if named:
            return {each: WORKED[each](self) for each in named}
        usual = [each for each in self.usual_sections() if each in WORKED]
        return present({each: if_known(partial(WORKED[each], self)) for each in usual})

    @property
    def judges(self) -> bool:
        """True if the verdict is requested, or states why forces are left out."""
        return self.include is None or not JUDGED.isdisjoint(self.include) or self.unforced

    @property
    def asks_largest(self) -> bool:
        """True if the torque at the first failure is requested."""
        return "largest_torque" in (self.include or ())

    @cached_property
    def usual_ring(self) -> UsualModification | None:
        """Design with a usual ring of pins."""
        return usual_modification(self.design, largest=self.asks_largest)

    @cached_property
    def draws_real(self) -> bool:
        """True if figures show solved forces, which are judged and can be solved."""
        return self.results.solved and is_known(lambda: self.results.real_forces)

    @property
    def carrying(self) -> Mechanism:
        """Ideal mechanism whose pairs drive in the direction of the torque that is shown."""
        if not self.draws_real:
            return self.design.driven
        return self.design.driven_by(self.results.real_forces.way)

    @cached_property
    def solved_turn(self) -> Turn:
        """Turn under the torque of the solved forces, in their direction."""
        solved = self.results.real_forces
        return self.results.turn(solved.way * solved.torque)


Answer = Callable[[CrankPlanetaryRequest], Values | None]
"""Function that answers a section; None if there is no answer."""


def _cyclogram(body: CrankPlanetaryRequest) -> Values:
    pattern = timed(lambda: body.mechanism.solve_for(body.design.driven))
    return CyclogramResponse.values(*pattern)


def _members(body: CrankPlanetaryRequest) -> Values:
    loads, took_us = timed(lambda: body.results.member_loads)
    return MembersOut.values(loads, took_us, output=body.mechanism.output)


def ideal_force(body: CrankPlanetaryRequest) -> ContactForce:
    """Contact force; without its own section only the values that other sections need."""
    load = body.known_load
    if "contact_force" not in body.sections:
        load = load.model_copy(update={"include": []})
    return load.solve_for(body.design.driven, body.design.members)


def _contact_force(body: CrankPlanetaryRequest) -> Values:
    return ContactForceResponse.values(*timed(partial(ideal_force, body)))


def _load_sharing(body: CrankPlanetaryRequest) -> Values:
    """Solved forces over the turn, at the working torque."""
    sharing, run_us = timed(lambda: body.results.real_forces)
    forces = if_known(lambda: body.results.judged_forces)
    force_N = forces.force if isinstance(forces, RealForces) else None
    curves = None
    load = body.known_load
    if load.curve_samples:
        curves = real_curves(body, load.samples_of(body.design.built))
    drawn = curves and ForceCurvesOut.values(curves)
    ring = sharing.turn.ring if isinstance(sharing.turn, SeriesOverTurn) else None
    values = LoadSharingOut.values(
        sharing,
        run_us,
        judged_force_N=force_N,
        curves=drawn,
        ring=ring and RingTurnOut.values(ring),
    )
    return at_output(values, body.design.members)


def real_curves(body: CrankPlanetaryRequest, samples: int) -> ForceCurves:
    """Solved forces over the range of the figure of forces."""
    angles, _ = drawing_angles(mechanism=body.design.built, samples=2)
    turns = float(angles[-1]) / (2 * math.pi)
    carried = real_cyclogram(turn=body.solved_turn, revolutions=turns)
    crank_angle, force = carried_forces(
        turn=body.solved_turn,
        carried=carried,
        places=[body.results.real_forces.turn.peak_crank_angle],
        samples=samples,
    )
    pairs = tuple(PairNumber(each.satellite, each.pin) for each in carried.pairs)
    return ForceCurves(pairs, crank_angle, force)


def carrying_pairs(body: CrankPlanetaryRequest) -> RealCyclogram:
    """Pairs that carry."""
    return real_cyclogram(turn=body.solved_turn, revolutions=body.mechanism.revolutions)


def _real_cyclogram(body: CrankPlanetaryRequest) -> Values:
    return RealCyclogramOut.values(*timed(partial(carrying_pairs, body)))


def _hertz(body: CrankPlanetaryRequest) -> Values:
    contact, took_us = timed(lambda: body.results.hertz)
    factor = body.results.line_load_factor if body.pin else None
    return DesignHertzOut.values(contact, took_us, line_load_factor=factor)


def _ring_mesh(body: CrankPlanetaryRequest) -> Values:
    mesh, took_us = timed(partial(mesh_of, body.results))
    return mesh.answer(took_us)


def _drawing(body: CrankPlanetaryRequest) -> Values | None:
    drawn = ring_drawing(body.results)
    return RingDrawingOut.values(drawn) if drawn else None


def _by_forces(answer: type[ResponseModel], found: Callable[[Results], Any]) -> Answer:
    """Answer of a section that follows from the forces on the pins."""

    def answered(body: CrankPlanetaryRequest) -> Values:
        return answer.values(*timed(partial(found, body.results)), forces=body.forces)

    return answered


def _losses(body: CrankPlanetaryRequest) -> Values:
    """Friction of the pins, with efficiency and input torque of the whole if they are known."""
    losses = body.results.losses
    pins, took_us = timed(lambda: losses.pins)
    return DesignLossesOut.values(
        (pins, None),
        took_us,
        forces=body.forces,
        total_efficiency=if_known(lambda: losses.total_efficiency),
        input_torque_Nm=if_known(lambda: losses.input_torque),
    )


def _geometry(body: CrankPlanetaryRequest) -> Values:
    crank_angle = to_si("crank_angle_deg", body.crank_angle_deg)
    there = partial(pins_in_holes, results=body.results, crank_angle=crank_angle)
    return GeometryOut.values(*timed(there))


def _usual_fit(body: CrankPlanetaryRequest) -> Values | None:
    """Design with a usual clearance, if none is known or 0 is stated."""
    found = usual_clearance_too(design=body.design, ring=body.usual_ring, largest=body.asks_largest)
    return UsualFitOut.of(found, largest=body.asks_largest) if found else None


def _usual_modification(body: CrankPlanetaryRequest) -> Values | None:
    found = body.usual_ring
    return UsualModificationOut.of(found, largest=body.asks_largest) if found else None


def _mass(body: CrankPlanetaryRequest) -> Values:
    """Masses of the parts; one that is not known has the reason and what is missing."""
    found, took_us = timed(lambda: mass(body.design))
    parts = [PartMassOut.values(each, **lacking(each, body)) for each in found.parts]
    return MassOut.values(found, took_us, parts=parts)


ANSWERS: dict[Section, Answer] = {
    "cyclogram": _cyclogram,
    "members": _members,
    "contact_force": _contact_force,
    "load_sharing": _load_sharing,
    "real_cyclogram": _real_cyclogram,
    "hertz": _hertz,
    "ring_mesh": _ring_mesh,
    "ring_drawing": _drawing,
    "pin_strength": _by_forces(PinStrengthResponse, lambda found: found.pin_strength),
    "output_efficiency": _losses,
    "satellite_bearing": _by_forces(SatelliteBearingResponse, lambda found: found.crank.bearings),
    "crankshaft": _by_forces(CrankshaftResponse, lambda found: found.crank.shaft),
    "rollers": _by_forces(RollersOut, lambda found: found.rollers),
    "geometry": _geometry,
    "usual_fit": _usual_fit,
    "usual_modification": _usual_modification,
    "envelope": lambda body: EnvelopeOut.values(*timed(lambda: body.design.envelope)),
    "mass": _mass,
}
"""Answers of the sections, in their order; checks and fixes belong to the verdict."""


def _judged(body: CrankPlanetaryRequest) -> Values:
    """Verdict, with checks and fixes of one or several inputs on request."""
    found = body.verdict
    fixes, search = list[Fix](), Search(body.results, found, body.late)
    if {"fixes", "combined"} & {*body.sections}:
        fixes = fixes_of(body, codes_to_fix(found, body.fixes_for), search)
    values: Values = {}
    judged = partial(cold_yield, results=body.results, found=found)
    if body.design.plastics and (cold := if_known(judged)):
        values["cold_yield"] = _cold_values(body, cold)
    values |= judgement(
        found,
        body,
        torque=body.design.output_torque if body.design.load else 0.0,
        checks="checks" in body.sections,
        largest=body.asks_largest,
    )
    if "fixes" in body.sections:
        values["fixes"] = [fix_values(each, body) for each in fixes if possible(each)]
    if "combined" in body.sections:
        values["combined"] = combined(body, search, fixes)
    if search.untried:
        places = [each for name in search.untried for each in places_of(name, body)]
        values["untried"] = [*dict.fromkeys(map(pointer, places))]
    return present(values)


def _cold_values(body: CrankPlanetaryRequest, cold: ColdYield) -> Values:
    """First yield of a plastic contact, and the source of its strength."""
    given = getattr(body.given["contact"], f"{cold.body}_material")
    own = not isinstance(given, str) and (given.yield_strength_MPa or given.tensile_strength_MPa)
    entry = NOT_LISTED if own else entry_of(given)
    return ColdYieldOut.values(cold, source=entry.strength.source or None)


def _notices(body: CrankPlanetaryRequest) -> tuple[Notice, ...]:
    """Notices about the design, whatever sections are requested."""
    results, found = body.results, notices_of(if_known(lambda: body.design.pin_fit))
    if body.contact is not None:
        found += body.contact.material_notices()
    forces = results.forces_in_series
    if forces and not results.in_series:
        found += (Notice("meshes_apart", {"forces": forces, "limit": MOST_IN_SERIES}),)
    if body.judges or "hertz" in body.sections:
        found += notices_of(if_known(lambda: results.disc_of(results.hertz)))
    if "pin_strength" not in body.sections:  # the section states the notice itself
        found += results.size_notices
    return found


def solve(body: CrankPlanetaryRequest) -> Values:
    """Cyclogram, contact force, load sharing, Hertz stress, pins, efficiency, bearings, crankshaft
    and geometry as requested; verdict and shares if something is judged.
    """
    asked, results = body.sections, body.results
    sections = present({name: answer(body) for name, answer in ANSWERS.items() if name in asked})
    warnings = [warning(each) for each in _notices(body)]
    if rooms := if_known(lambda: results.rooms):
        sections["fit"] = FitOut.values(rooms)
    judged = _judged(body) if body.judges else {}
    if (
        judged
        and not body.unforced
        and (shares := disc_shares(results=results, found=body.verdict))
    ):
        sections["shares"] = SharesOut.of(shares)
        warnings += shares_warnings(shares)
    if warnings:
        sections["warnings"] = warnings
    return judged | {"model": body.forces} | sections


def _work_cyclogram(body: CrankPlanetaryRequest) -> list[Step]:
    found, _ = body.mechanism.solve()
    return cyclogram_steps(found=found, **body.mechanism.cyclogram_given())


def _work_contact_force(body: CrankPlanetaryRequest) -> list[Step]:
    """Worked steps of the ideal force, with a remark if other forces are judged."""
    return force_steps(
        mechanism=body.design.driven,
        found=ideal_force(body),
        judged=not body.results.solved,
        **body.known_load.force_given(body.design.members),
    )


def _work_clearance(body: CrankPlanetaryRequest) -> list[Step]:
    fit, pair = body.design.pin_fit, body.design.nominal_pair
    return clearance_steps(
        clearance=fit.clearance,
        pin_radius=pair.pin_radius,
        hole_radius=pair.hole_radius,
        eccentricity=fit.eccentricity,
    )


WORKED: dict[Section, Callable[[CrankPlanetaryRequest], list[Step]]] = {
    "cyclogram": _work_cyclogram,
    "members": lambda body: member_steps(body.results),
    "contact_force": _work_contact_force,
    "hertz": lambda body: judged_steps(body.results),
    "geometry": _work_clearance,
    "ring_mesh": lambda body: ring_steps(body.results),
    "pin_strength": lambda body: strength_steps(
        results=body.results, found=body.results.pin_strength, deflection=True
    ),
    "output_efficiency": lambda body: loss_steps(body.results),
    "satellite_bearing": lambda body: bearing_steps(body.results),
    "crankshaft": lambda body: shaft_steps(body.results),
    "rollers": lambda body: roller_steps(body.results),
}
"""Functions that make the worked steps of sections; the other sections are solved over the turn."""
