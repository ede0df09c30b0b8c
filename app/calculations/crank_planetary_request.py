"""The request for a crank-planetary reducer: the design, and which sections of the answer."""

import math
from collections.abc import Iterator
from functools import cached_property
from typing import Any, Literal, Self, get_args

from pydantic import Field, model_validator

from app.calculations.both_meshes import DesignCouplingFields
from app.calculations.checks import FixesFor, ScopedRequirementsFields
from app.calculations.design import DesignFields, SatelliteBodyFields, TemperaturesFields
from app.calculations.fatigue import PinFatigueFields
from app.calculations.ideal_forces import CyclogramFields
from app.calculations.mechanism import MAX_PAIRS
from app.calculations.output_efficiency import FrictionFields
from app.calculations.ring import RING_PIN_LISTS, RingFields
from app.calculations.satellite_bearing import BearingFields, CrankshaftFields
from app.model import Angle, Maybe, Values, quantity
from app.rules import field_error
from app.settings import Settings
from core.checks.check import Verdict
from core.checks.crank_planetary import crank_verdict
from core.checks.usual_modification import UsualModification, usual_modification
from core.design.crank_results import MOST_BEARING_PAIRS
from core.design.results import MOST_PIN_PAIRS, Results
from core.errors import CalculationError, Notice, if_known, is_known
from core.output.elasticity import RingInSeries
from core.output.mechanism import Mechanism
from core.output.turn import Turn

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
    "checks",
    "fixes",
    "combined",
    "worked",
]

SECTIONS: tuple[Section, ...] = get_args(Section)

_TOUCHING = ("load", "contact")
_MESHING = ("load", "contact/eccentricity_mm", "gear/modification")
_TURNING = (*_TOUCHING, "load/input_speed_rpm", "contact/eccentricity_mm")

NEEDS: dict[Section, tuple[str, ...]] = {
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
    "checks": (),
    "fixes": (),
    "combined": (),
    "worked": (),
}
"""Which parts of the request each section of the answer needs, and which of their fields."""

INVOLUTE_NEEDS = (
    "load",
    "contact/eccentricity_mm",
    *(f"gear/{body}_profile_shift" for body in ("satellite", "ring")),
)
"""The same of the mesh of involute teeth."""

SEARCHED = frozenset(("fixes", "combined", "usual_fit", "usual_modification"))
"""Sections for which designs are tried."""

STRENGTH: tuple[Section, ...] = (
    "pin_strength",
    "output_efficiency",
    "satellite_bearing",
    "crankshaft",
    "rollers",
)
"""Sections of strength and life."""

AS_MADE = ("hertz", "geometry", *STRENGTH)
"""Sections that follow from the forces of the mechanism as it is made, where it is given so."""

MOST_PAIRS: dict[Section, int] = {
    "pin_strength": MOST_PIN_PAIRS,
    "satellite_bearing": MOST_BEARING_PAIRS,
    "crankshaft": MOST_BEARING_PAIRS,
    "rollers": MOST_BEARING_PAIRS,
}
"""Most pairs of which they are calculated."""


class _UsualCoupling:
    """That of a design of which none is stated: both meshes in series, where they are known."""

    def section(self, _: Any = None) -> RingInSeries:
        """The coupling in SI units."""
        return RingInSeries()


class CrankPlanetaryRequest(DesignFields, group="mechanism"):
    """Mechanism, load and contact, and which sections of the answer are wanted.

    The forces that are judged are those of `DesignFields`, but for perfect parts whose pins bend:
    these are solved too, with no clearance, unless `distribution_factor` above 1 states how uneven
    the sharing is. Of cycloid discs whose modification is known, as is the clearance of the pins,
    both meshes are solved in series, where neither `satellite_coupling` nor `crank_support` says
    otherwise.
    """

    mechanism: CyclogramFields
    satellite_coupling: Maybe[DesignCouplingFields] = None
    fatigue: Maybe[PinFatigueFields] = None
    friction: Maybe[FrictionFields] = None
    gear: Maybe[RingFields] = None
    bearing: Maybe[BearingFields] = None
    crankshaft: Maybe[CrankshaftFields] = None
    satellite_body: Maybe[SatelliteBodyFields] = None
    temperatures: Maybe[TemperaturesFields] = None
    requirements: ScopedRequirementsFields = Field(default_factory=ScopedRequirementsFields)
    crank_angle_deg: Angle = quantity("Crank angle", "φ", default=0.0, step=5, advanced=True)
    """Crank angle of the section geometry."""
    include: Maybe[list[Section]] = Field(
        min_length=1,
        max_length=len(NEEDS),
        description="Sections of the answer: what is not named is not computed. Where it is "
        "absent: all but real_cyclogram, geometry, usual_fit, usual_modification, checks, fixes "
        "and combined, as far as their input is given; members where others than the pins are the "
        "output; load_sharing where clearance, deviations, a contact law, satellites that give or "
        "pins that bend are. "
        "load_sharing and hertz with these are left out then where the forces cannot be solved. "
        "What rests on the forces of parts that cannot be put together is always: the check "
        "interference says why.",
    )
    fixes_for: FixesFor = Field(
        default="governing", description="Which checks the section fixes is to cure."
    )

    @model_validator(mode="after")
    def _parts_for_sections(self) -> Self:
        for section in self.include or ():
            for part in self._needs(section):
                if not self._has(part):
                    raise field_error(part, "needed_for", section=section)
        return self

    @model_validator(mode="after")
    def _ring_in_series(self) -> Self:
        coupling = self.satellite_coupling
        if coupling is None or coupling.kind != "ring":
            return self
        if self.gear is None:
            raise field_error("gear", "needed_beside", field="satellite_coupling")
        if self.gear.kind != "cycloid":
            raise field_error("gear/kind", "outside_method")
        return self

    def _needs(self, section: Section) -> tuple[str, ...]:
        """What a section of the answer needs; of involute teeth their shifts."""
        teeth = section in ("ring_mesh", "ring_drawing") and self.ring_kind == "involute"
        return INVOLUTE_NEEDS if teeth else NEEDS[section]

    def _has(self, part: str) -> bool:
        """Whether a part of the request, or a field of one, is given; rollers have friction."""
        return self.says(part) or (part == "friction" and self.says("rollers"))

    def notices(self) -> tuple[Notice, ...]:
        """Also that nothing is known of the clearance, where nobody says that it is none."""
        found = (*super().notices(), *self._of_ring())
        if self.contact is None or not self.contact.clearance_unknown:
            return found  # without an eccentricity that is what is missing, and said
        perfect = (each for each in found if each.code != "perfect_parts")
        return (Notice("clearance_unknown"), *perfect)

    def _of_ring(self) -> Iterator[Notice]:
        """What is not known of a ring whose mesh is judged."""
        listed = any(self.says(f"deviations/{name}") for name in RING_PIN_LISTS)
        if self.says("gear/modification") and not listed:
            yield Notice("ring_deviations_unknown")

    def assumed(self) -> Iterator[tuple[tuple[str, ...], Any]]:
        """Also the friction of plastics, by which they yield, where it is known."""
        yield from super().assumed()
        try:
            design = self.design
        except CalculationError:  # of which a solution is asked: a size that makes none yet
            return
        dry = design.plastics and not (design.friction or design.sleeved or design.rollers)
        if dry and is_known(lambda: design.dry_friction):
            yield ("friction", "coefficient"), design.dry_friction

    def without(self, path: tuple[str, ...]) -> Values:
        """The peak force of one satellite, where forces are asked and their number is assumed."""
        return super().without(path) if "contact_force" in self.sections else {}

    def cost(self) -> float:
        """Points of its cyclogram and its ideal forces; what searches or solves has no end."""
        include, given = self.include or (), self.given.keys()
        cranked = not given.isdisjoint(("bearing", "crankshaft"))
        searches = "pin" in given or (cranked and "gear" in given)
        solves = self.as_made or "load_sharing" in include
        solves |= self.says("gear/modification") or self.says("requirements/max_lost_motion_arcmin")
        loaded = given >= {"load", "contact"}
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
        named = [each for each in self.include or () if not self._unfit(each)]
        return named if self.include else self.usual_sections()

    def usual_sections(self) -> list[Section]:
        """Sections where none are named."""
        usual: tuple[Section, ...] = ("cyclogram", "contact_force", "hertz", *STRENGTH)
        if self.mechanism.output != "pins":
            usual = ("members", *usual)
        allowed = [each for each in usual if all(map(self._has, NEEDS[each]))]
        allowed = [
            each for each in allowed if self.mechanism.pairs <= MOST_PAIRS.get(each, MAX_PAIRS)
        ]
        if self._draws_ring:
            allowed.append("ring_mesh")
        if not self.results.solved or "hertz" not in allowed:
            return allowed
        if not is_known(lambda: self.results.judged_forces):
            return [each for each in allowed if each != "hertz" and each not in STRENGTH]
        return [each for each in (*allowed, "load_sharing") if not self._unfit(each)]

    @property
    def _draws_ring(self) -> bool:
        """Whether the mesh of the ring is answered where it is not named: it can be solved."""
        given, found = all(map(self._has, self._needs("ring_mesh"))), self.results
        if self.ring_kind == "involute":
            return given and is_known(lambda: found.ring.involute_load(1.0))
        return given and is_known(lambda: found.ring.working)

    def _unfit(self, section: Section) -> bool:
        """Whether a section rests on forces of parts that cannot be put together."""
        made = section in ("load_sharing", "real_cyclogram") or (
            section in AS_MADE and self.results.solved
        )
        return made and bool(if_known(lambda: self.results.fit.impossible))

    def refuse_beyond(self, settings: Settings) -> None:
        """Refuse what exceeds the operator's limits in mechanism or load, and lists of deviations
        that do not fit the mechanism.
        """
        super().refuse_beyond(settings)
        if self.load:
            self.load.refuse_beyond(settings)

    @cached_property
    def results(self) -> Results:
        """What follows from the design."""
        return Results(self.design)

    def parts(self) -> dict[str, Any]:
        """Without pins where there is no contact: nothing loads them. Both meshes are in series
        where nothing else is stated of the satellites.
        """
        given = super().parts()
        if "contact" not in given:
            given.pop("pin", None)
        if "gear" in given and "crank_support" not in given:
            given.setdefault("satellite_coupling", _UsualCoupling())
        return given

    @cached_property
    def verdict(self) -> Verdict:
        """The verdict of the design."""
        return crank_verdict(self.results, every="checks" in self.sections)

    @cached_property
    def usual_ring(self) -> UsualModification | None:
        """The design with a usual ring of pins."""
        return usual_modification(self.design)

    @cached_property
    def draws_real(self) -> bool:
        """Whether figures show the forces that are solved: where these are judged, and can be."""
        return self.results.solved and is_known(lambda: self.results.real_forces)

    @property
    def carrying(self) -> Mechanism:
        """The ideal mechanism whose pairs drive in the direction of the torque that is shown."""
        if not self.draws_real:
            return self.design.driven
        return self.design.driven_by(self.results.real_forces.way)

    @cached_property
    def solved_turn(self) -> Turn:
        """The turn under the torque of the forces that are solved, in their direction."""
        solved = self.results.real_forces
        return self.results.turn(solved.way * solved.torque)
