"""The crank-planetary reducer as one job: request, answer, figure."""

import math
from collections.abc import Callable, Iterator
from functools import cached_property, partial
from typing import Any, Literal, Self, get_args

import numpy as np
from pydantic import Field, model_validator

from app.calculations.both_meshes import DesignCouplingFields, RingTurnOut
from app.calculations.checks import (
    FixesFor,
    ScopedRequirementsFields,
    codes_to_fix,
    judgement,
)
from app.calculations.combined import combined
from app.calculations.contact_force import (
    ContactForceResponse,
    ForceCurvesOut,
    contact_force_figure,
)
from app.calculations.crank_planetary_answer import (
    ColdYieldOut,
    CrankPlanetaryResponse,
    DesignHertzOut,
    LoadSharingOut,
)
from app.calculations.crankshaft import CrankshaftResponse
from app.calculations.cyclogram import (
    CyclogramFields,
    CyclogramResponse,
    cyclogram_figure,
    over_one_axis,
)
from app.calculations.design import (
    DesignFields,
    SatelliteBodyFields,
    TemperaturesFields,
)
from app.calculations.fatigue import PinFatigueFields
from app.calculations.fit_answer import FitOut
from app.calculations.geometry_answer import GeometryOut
from app.calculations.hertz import entry_of
from app.calculations.involute_mesh import drawn_path, solved_pair
from app.calculations.load_sharing_answer import RealCyclogramOut
from app.calculations.mechanism import MAX_PAIRS
from app.calculations.members_answer import MembersOut, at_output
from app.calculations.output_efficiency import FrictionFields, OutputEfficiencyResponse
from app.calculations.pin_rollers_answer import RollersOut
from app.calculations.pin_strength import PinStrengthResponse
from app.calculations.reducer_fixes import fixes_of
from app.calculations.ring import RING_PIN_LISTS, RingFields
from app.calculations.ring_mesh_answer import (
    MeshTurnOut,
    RingDrawingOut,
    RingEfficiencyOut,
    RingGeometryOut,
    RingIdealOut,
    TeethTurnOut,
)
from app.calculations.ring_mesh_figure import (
    DrawnPath,
    ShownMesh,
    path_figure,
    ring_mesh_figure,
)
from app.calculations.satellite_bearing import (
    BearingFields,
    CrankshaftFields,
    SatelliteBearingResponse,
)
from app.calculations.shares_answer import SharesOut, shares_warnings
from app.calculations.solved import Solved
from app.calculations.usual_fit_answer import UsualFitOut, UsualModificationOut
from app.model import (
    Angle,
    Calculation,
    Maybe,
    Values,
    field_error,
    quantity,
    warning,
)
from app.problems import refusal
from app.running import run
from app.settings import Settings
from app.sources import (
    ARCHARD_1953,
    HARRIS,
    ISO_281,
    ISO_6336,
    JOHNSON_1985,
    PERSSON_1964,
    SHIGLEY,
    WANG_2016,
    YANCHEVSKIY_2021,
    YANCHEVSKY_2018,
    ZYL,
)
from app.theme import Figure, Theme
from app.units import from_si, to_si
from app.worked import worked
from core.arrays import FloatArray
from core.checks.check import Verdict
from core.checks.cold_yield import ColdYield, cold_yield
from core.checks.largest_torque import crank_verdict
from core.checks.shares import disc_shares
from core.checks.usual_modification import (
    UsualModification,
    usual_clearance_too,
    usual_modification,
)
from core.derived import if_known
from core.design.drawings import drawn_mesh, drawn_teeth
from core.design.real_forces import RealForces
from core.design.results import MOST_BEARING_PAIRS, MOST_IN_SERIES, MOST_PIN_PAIRS, Results
from core.errors import CalculationError
from core.fixes.fix import Fix
from core.material_record import NOT_LISTED
from core.output.contact_force import ContactForce, ForceCurves, PairNumber, drawing_angles
from core.output.mechanism import Mechanism
from core.output.pin_geometry import (
    PinGeometry,
    pin_fit,
    pin_geometry,
)
from core.output.real_cyclogram import RealCyclogram, carried_forces, real_cyclogram
from core.output.satellite_support import RingInSeries
from core.output.turn import Turn
from core.results import Notice
from core.ring.mesh_curves import MeshCurves, SeriesCurves
from core.ring.series_teeth import TeethInSeries
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
    "checks",
    "fixes",
    "combined",
    "worked",
]

SECTIONS: tuple[Section, ...] = get_args(Section)

_TOUCHING = ("load", "contact")
_MESHING = ("load", "contact/eccentricity_mm", "gear/modification")
_TURNING = (*_TOUCHING, "load/input_speed_rpm", "contact/eccentricity_mm")

_NEEDS: dict[Section, tuple[str, ...]] = {
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

DRAWN_SAMPLES = 361
"""Crank angles of the figure's real forces."""

DRAWN_RING = 120
"""Crank angles at which discs and ring are drawn, at least, of at most `MAX_DRAWN_PAIRS`."""

MAX_DRAWN_PAIRS = 240
"""Most pairs of discs and ring that are drawn."""

DRAWN_ERROR = 1e-5
"""Chord error of the outline there, m."""

STRENGTH: tuple[Section, ...] = (
    "pin_strength",
    "output_efficiency",
    "satellite_bearing",
    "crankshaft",
    "rollers",
)
"""Sections of strength and life."""

STEPS: dict[Section, Callable[[Results], list[Step]]] = {
    "output_efficiency": loss_steps,
    "satellite_bearing": bearing_steps,
    "crankshaft": shaft_steps,
    "rollers": roller_steps,
}
"""Worked steps of those that are worked from the results of a design alone."""

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
        max_length=len(_NEEDS),
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
        involute = self.gear is not None and self.gear.kind == "involute"
        teeth = section in ("ring_mesh", "ring_drawing") and involute
        return INVOLUTE_NEEDS if teeth else _NEEDS[section]

    def _has(self, part: str) -> bool:
        """Whether a part of the request, or a field of one, is given; rollers have friction."""
        if part == "friction" and self.rollers is not None:
            return True
        value: Any = self
        for name in part.split("/"):
            value = None if value is None else getattr(value, name)
        return value is not None

    def notices(self) -> tuple[Notice, ...]:
        """Also that nothing is known of the clearance, where nobody says that it is none."""
        found = (*super().notices(), *self._of_ring())
        if self.contact is None or not self.contact.clearance_unknown:
            return found  # without an eccentricity that is what is missing, and said
        perfect = (each for each in found if each.code != "perfect_parts")
        return (Notice("clearance_unknown"), *perfect)

    def _of_ring(self) -> Iterator[Notice]:
        """What is not known of a ring whose mesh is judged."""
        gear, made = self.gear, self.deviations
        if gear is None or gear.modification is None:
            return
        if made is None or all(getattr(made, name) is None for name in RING_PIN_LISTS):
            yield Notice("ring_deviations_unknown")

    def assumed(self) -> Iterator[tuple[tuple[str, ...], Any]]:
        """Also the friction of plastics, by which they yield, where it is known."""
        yield from super().assumed()
        try:
            design = self.design
        except CalculationError:  # of which a solution is asked: a size that makes none yet
            return
        dry = design.plastics and not (design.friction or design.sleeved or design.rollers)
        if dry and design.dry_friction is not None:
            yield ("friction", "coefficient"), design.dry_friction

    def without(self, path: tuple[str, ...]) -> Values:
        """The peak force of one satellite, where forces are asked and their number is assumed."""
        return super().without(path) if "contact_force" in self.sections else {}

    def cost(self) -> float:
        """Points of its cyclogram and its ideal forces; what searches or solves has no end."""
        include = self.include or ()
        cranked = self.bearing is not None or self.crankshaft is not None
        searches = self.pin is not None or (cranked and self.gear is not None)
        lost_motion = self.requirements.max_lost_motion_arcmin is not None
        in_series = self.gear is not None and self.gear.modification is not None
        solves = self.as_made or in_series or "load_sharing" in include or lost_motion
        loaded = self.load is not None and self.contact is not None
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
        if self.include is not None:
            return [each for each in self.include if not self._unfit(each)]
        return self.usual_sections()

    def usual_sections(self) -> list[Section]:
        """Sections where none are named."""
        usual: tuple[Section, ...] = ("cyclogram", "contact_force", "hertz", *STRENGTH)
        if self.mechanism.output != "pins":
            usual = ("members", *usual)
        allowed = [each for each in usual if all(map(self._has, _NEEDS[each]))]
        allowed = [
            each for each in allowed if self.mechanism.pairs <= MOST_PAIRS.get(each, MAX_PAIRS)
        ]
        if self._draws_ring:
            allowed.append("ring_mesh")
        if not self.results.solved or "hertz" not in allowed:
            return allowed
        if if_known(lambda: self.results.judged_forces) is None:
            return [each for each in allowed if each != "hertz" and each not in STRENGTH]
        return [each for each in (*allowed, "load_sharing") if not self._unfit(each)]

    @property
    def _draws_ring(self) -> bool:
        """Whether the mesh of the ring is answered where it is not named: it can be solved."""
        given, found = all(map(self._has, self._needs("ring_mesh"))), self.results
        if self.gear is not None and self.gear.kind == "involute":
            return given and if_known(lambda: found.involute_load(1.0)) is not None
        return given and if_known(lambda: found.ring_working) is not None

    def _unfit(self, section: Section) -> bool:
        """Whether a section rests on forces of parts that cannot be put together."""
        made = section in ("load_sharing", "real_cyclogram") or (
            section in AS_MADE and self.results.solved
        )
        fit = if_known(lambda: self.results.fit) if made else None
        return fit is not None and fit.impossible

    def refuse_beyond(self, settings: Settings) -> None:
        """Refuse what exceeds the operator's limits in mechanism or load, and lists of deviations
        that do not fit the mechanism.
        """
        super().refuse_beyond(settings)
        if self.load is not None:
            self.load.refuse_beyond(settings)

    def solve_force(self) -> ContactForce:
        """Contact force; without its own section only what the others need of it."""
        assert self.load is not None
        load = self.load
        if "contact_force" not in self.sections:
            load = load.model_copy(update={"include": []})
        return load.solve_for(self.design.driven, self.design.members)

    @cached_property
    def results(self) -> Results:
        """What follows from the design."""
        return Results(self.design)

    def parts(self) -> dict[str, Any]:
        """Without pins where there is no contact: nothing loads them. Both meshes are in series
        where nothing else is stated of the satellites.
        """
        given = {
            name: part
            for name, part in super().parts().items()
            if name != "pin" or self.contact is not None
        }
        if "gear" in given and "crank_support" not in given:
            given.setdefault("satellite_coupling", _UsualCoupling())
        return given

    @cached_property
    def verdict(self) -> Verdict:
        """The verdict of the design."""
        return crank_verdict(self.results, every="checks" in self.sections)

    def judge(self) -> Values:
        """Verdict, and checks and fixes, of one input and of several, where asked."""
        found = self.verdict
        fixes: list[Fix] = []
        if {"fixes", "combined"} & {*self.sections}:
            codes = codes_to_fix(found, self.fixes_for)
            fixes = fixes_of(self, codes, found)
        values: Values = {}
        if (cold := cold_yield(results=self.results, found=found)) is not None:
            values["cold_yield"] = self.cold_values(cold)
        values |= judgement(
            found,
            self,
            torque=self.design.load.output_torque if self.design.load else None,
            checks="checks" in self.sections,
            fixes=fixes if "fixes" in self.sections else None,
        )
        if "combined" in self.sections:
            values["combined"] = combined(self, found, fixes)
        return {name: value for name, value in values.items() if value is not None}

    def cold_values(self, cold: ColdYield) -> Values:
        """When a plastic contact yields at once, and where its strength comes from."""
        assert self.contact is not None
        given = getattr(self.contact, f"{cold.body}_material")
        own = not isinstance(given, str) and (
            given.yield_strength_MPa or given.tensile_strength_MPa
        )
        entry = NOT_LISTED if own else entry_of(given)
        return ColdYieldOut.values(cold, source=entry.strength.source or None)

    def cyclogram_steps(self) -> list[Step]:
        """Worked steps of the cyclogram."""
        found, _ = self.mechanism.solve()
        return cyclogram_steps(found=found, **self.mechanism.cyclogram_given())

    def force_steps(self) -> list[Step]:
        """Worked steps of the ideal force, which say so where others are judged."""
        assert self.load is not None
        return force_steps(
            mechanism=self.design.driven,
            found=self.solve_force(),
            judged=not self.results.solved,
            **self.load.force_given(self.design.members),
        )

    def hertz_steps(self) -> list[Step]:
        """Worked steps of the contact that is judged."""
        return judged_steps(self.results)

    def clearance_steps(self) -> list[Step]:
        """Worked steps of the clearance."""
        fit, pair = self.solve_fit(), self.design.contact.pair
        assert fit is not None
        return clearance_steps(
            clearance=fit.clearance,
            pin_radius=pair.pin_radius,
            hole_radius=pair.hole_radius,
            eccentricity=fit.eccentricity,
        )

    def strength_steps(self, section: Section) -> list[Step]:
        """Worked steps of a section of strength and life."""
        if section == "pin_strength":
            return strength_steps(results=self.results, found=self.results.pin_strength)
        return STEPS[section](self.results)

    def solve_usual_fit(self) -> Values | None:
        """The design with a usual clearance, where none is known or 0 is stated."""
        found = usual_clearance_too(design=self.design, ring=self.usual_ring)
        if found is None:
            return None
        name, results, judged = found
        return UsualFitOut.of(name, results, judged)

    @cached_property
    def usual_ring(self) -> UsualModification | None:
        """The design with a usual ring of pins."""
        return usual_modification(self.design)

    def strength(self, section: Section) -> Any:
        """Result of a section of strength and life."""
        return getattr(self.results, section)

    @cached_property
    def draws_real(self) -> bool:
        """Whether figures show the forces that are solved: where these are judged, and can be."""
        return self.results.solved and if_known(lambda: self.results.real_forces) is not None

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

    def solve_real_cyclogram(self) -> RealCyclogram:
        """Which pairs carry."""
        return real_cyclogram(turn=self.solved_turn, revolutions=self.mechanism.revolutions)

    def real_curves(self, samples: int) -> ForceCurves:
        """Forces that are solved, over the range of the figure of forces."""
        angles, _ = drawing_angles(mechanism=self.built, samples=2)
        turns = float(angles[-1]) / (2 * math.pi)
        carried = real_cyclogram(turn=self.solved_turn, revolutions=turns)
        crank_angle, force = carried_forces(
            turn=self.solved_turn,
            carried=carried,
            places=[self.results.real_forces.turn.peak_crank_angle],
            samples=samples,
        )
        pairs = tuple(PairNumber(each.satellite, each.pin) for each in carried.pairs)
        return ForceCurves(pairs, crank_angle, force)

    def solve_sharing(self) -> Values:
        """The forces that are solved over the turn, at the torque itself."""
        sharing, run_us = run(self, lambda: self.results.real_forces)
        forces = if_known(lambda: self.results.judged_forces)
        force_N = forces.force if isinstance(forces, RealForces) else None
        curves = None
        if self.load is not None and self.load.curve_samples:
            curves, _ = run(self, partial(self.real_curves, self.load.samples_of(self.built)))
        drawn = curves and ForceCurvesOut.values(curves)
        ring = sharing.turn.ring if isinstance(sharing.turn, SeriesOverTurn) else None
        values = LoadSharingOut.values(
            sharing,
            run_us,
            judged_force_N=force_N,
            curves=drawn,
            ring=ring and RingTurnOut.values(ring),
        )
        return at_output(values, self.design.members)

    def solve_pair(self) -> Solved:
        """The mesh of involute teeth, of the satellite with the largest torque."""
        results, design = self.results, self.design
        factor = design.load_factor
        pair, loaded = results.involute_pair, results.loaded_teeth(factor)
        _ = results.involute_load(factor)  # which needs materials
        asked = {"stresses"} | ({"shared_pairs"} if pair.on_involutes else set())
        solved = solved_pair(
            ring=design.gear,
            pair=pair,
            loaded=loaded,
            output_torque=design.pin_torque,
            input_speed=design.turning_speed,
            asked=asked,
        )
        values = solved.values
        del values["kind"]  # which the design says
        values["satellite_torque_Nm"] = loaded["torque"]
        values["geometry"] = at_output(values["geometry"], design.members)
        return solved

    def solve_ring(self) -> Solved:
        """The mesh of the ring under the torque, in the direction of the larger pressure."""
        if self.design.gear.kind == "involute":
            return self.solve_pair()
        assert self.load is not None
        turn, solved = self.results.ring_working[0], Solved()
        shown = TeethTurnOut if isinstance(turn, TeethInSeries) else MeshTurnOut
        mesh, members = turn.mesh, self.design.members
        each = self.design.pin_torque / self.mechanism.satellites
        solved.values |= {
            "geometry": RingGeometryOut.values(mesh.disc),
            "method": "exact" if mesh.exact else "first_order",
            "torque_direction": "driving" if turn.turn.torque > 0 else "reverse",
            "ideal": at_output(RingIdealOut.of(mesh.disc, each), members),
            "over_turn": at_output(shown.values(turn), members),
        }
        loss = if_known(lambda: self.results.ring_loss)
        if loss is not None:
            solved.values["efficiency"] = RingEfficiencyOut.values(loss)
        solved.take(turn.accuracy, turn.notices)
        return solved

    def solve_ring_drawing(self) -> Values | None:
        """Satellites and ring as they are drawn, and what discs on pins do under the torque."""
        if self.design.gear.kind == "involute":
            teeth = if_known(partial(drawn_teeth, design=self.design, chord_error=DRAWN_ERROR))
            return None if teeth is None else RingDrawingOut.of_teeth(teeth)
        turn = self.results.ring_working[0]
        pairs = turn.mesh.disc.pins * self.mechanism.satellites
        if pairs > MAX_DRAWN_PAIRS:
            return None
        drawn = drawn_mesh(design=self.design, mesh=turn.mesh, chord_error=DRAWN_ERROR)
        if not isinstance(turn, TeethInSeries):
            return RingDrawingOut.of(drawn, MeshCurves(turn, DRAWN_RING))
        curves = SeriesCurves(turn, angles=DRAWN_RING)
        many = pairs * len(curves.crank_angle) > MAX_DRAWN_PAIRS * (DRAWN_RING + 1)
        return RingDrawingOut.of(drawn, None if many else curves)

    def solve_path(self) -> DrawnPath:
        """The pressure along the path of contact of involute teeth, as `solve_pair` has it."""
        results, factor = self.results, self.design.load_factor
        _ = results.involute_load(factor)  # which needs materials
        return drawn_path(pair=results.involute_pair, loaded=results.loaded_teeth(factor))

    def solve_ring_figure(self) -> ShownMesh:
        """What the figure of the mesh shows."""
        turn, own = self.results.ring_working[0], self.mechanism
        if turn.mesh.disc.pins * own.satellites > MAX_DRAWN_PAIRS:
            name = "ratio" if own.ring_teeth is None else "ring_teeth"
            limit = {"limit": MAX_DRAWN_PAIRS // own.satellites, "satellites": own.satellites}
            raise refusal(f"/mechanism/{name}", "too_many_pairs", **limit)
        return ShownMesh.of(turn, members=self.design.members)

    def solve_disc(self) -> Notice | None:
        """Whether the edge of the satellite is so near to its holes that the pressure is off."""
        return if_known(lambda: self.results.disc_of(self.results.hertz))

    def solve_geometry(self) -> tuple[PinGeometry, FloatArray]:
        """Pins and holes at the crank angle, and the force of each pair there, N."""
        assert self.load is not None and self.contact is not None
        crank_angle = to_si("crank_angle_deg", self.crank_angle_deg)
        sizes = self.contact.sizes_on(self.load.pin_circle_radius_mm)
        sizes["eccentricity"] = pin_fit(pins=self.mechanism.pins, **sizes).eccentricity
        geometry = pin_geometry(mechanism=self.built, crank_angle=crank_angle, **sizes)
        if not self.results.solved:
            forces = self.load.forces_at(self.design.driven, self.design.members, crank_angle)
        else:
            forces = np.array(self.results.forces_at(crank_angle))
        return geometry, forces


WORKED: dict[Section, Callable[[CrankPlanetaryRequest], list[Step]]] = {
    "cyclogram": CrankPlanetaryRequest.cyclogram_steps,
    "members": lambda body: member_steps(body.results),
    "contact_force": CrankPlanetaryRequest.force_steps,
    "hertz": CrankPlanetaryRequest.hertz_steps,
    "geometry": CrankPlanetaryRequest.clearance_steps,
    "ring_mesh": lambda body: ring_steps(body.results),
    **{each: partial(CrankPlanetaryRequest.strength_steps, section=each) for each in STRENGTH},
}
"""What works the sections of the answer; the others are solved over the turn."""


ANSWERS: dict[Section, Callable[..., Values]] = {
    "pin_strength": PinStrengthResponse.values,
    "output_efficiency": lambda found, run_us, **given: OutputEfficiencyResponse.values(
        (found, None), run_us, **given
    ),
    "satellite_bearing": SatelliteBearingResponse.values,
    "crankshaft": CrankshaftResponse.values,
    "rollers": RollersOut.values,
}
"""Values of the sections of strength and life, by their results."""


def solve(body: CrankPlanetaryRequest) -> Values:
    """Cyclogram, contact force, load sharing, Hertz stress, pins, efficiency, bearings, crankshaft,
    geometry: the sections that are asked.

    Verdict and warnings are there whichever sections are asked.
    """
    asked, _ = run(body, lambda: body.sections)
    sections: Values = {}
    if "cyclogram" in asked:
        pattern = run(body, lambda: body.mechanism.solve_for(body.design.driven))
        sections["cyclogram"] = CyclogramResponse.values(*pattern)
    if "members" in asked:
        loads, took_us = run(body, lambda: body.results.member_loads)
        sections["members"] = MembersOut.values(loads, took_us, output=body.mechanism.output)
    if "contact_force" in asked:
        sections["contact_force"] = ContactForceResponse.values(*run(body, body.solve_force))
    if "load_sharing" in asked:
        sections["load_sharing"], _ = run(body, body.solve_sharing)
    if "real_cyclogram" in asked:
        found = run(body, body.solve_real_cyclogram)
        sections["real_cyclogram"] = RealCyclogramOut.values(*found)
    if "hertz" in asked:
        contact, hertz_us = run(body, lambda: body.results.hertz)
        factor = body.results.line_load_factor if body.pin else None
        sections["hertz"] = DesignHertzOut.values(contact, hertz_us, line_load_factor=factor)
    if "ring_mesh" in asked:
        ring, ring_us = run(body, body.solve_ring)
        sections["ring_mesh"] = ring.answer(ring_us)
    if "ring_drawing" in asked:
        drawing, _ = run(body, body.solve_ring_drawing)
        if drawing is not None:
            sections["ring_drawing"] = drawing
    for name, answer in ANSWERS.items():
        if name in asked:
            found, run_us = run(body, partial(body.strength, name))
            sections[name] = answer(found, run_us, forces=body.forces)
    if "geometry" in asked:
        sections["geometry"] = GeometryOut.values(*run(body, body.solve_geometry))
    if "usual_fit" in asked:
        usual, _ = run(body, body.solve_usual_fit)
        if usual is not None:
            sections["usual_fit"] = usual
    if "usual_modification" in asked:
        ring_made, _ = run(body, lambda: body.usual_ring)
        if ring_made is not None:
            sections["usual_modification"] = UsualModificationOut.of(ring_made)
    sizes, _ = run(body, body.solve_fit)
    fit, _ = run(body, lambda: if_known(lambda: body.results.fit))
    if fit is not None:
        sections["fit"] = FitOut.values(fit)
    notices = (() if sizes is None else sizes.notices) + (
        () if body.contact is None else body.contact.material_notices()
    )
    if run(body, lambda: body.results.in_series)[0]:
        notices += (Notice("both_meshes"),)
    elif forces := run(body, lambda: body.results.forces_in_series)[0]:
        notices += (Notice("meshes_apart", {"forces": forces, "limit": MOST_IN_SERIES}),)
    if (disc := run(body, body.solve_disc)[0]) is not None:
        notices += (disc,)
    if "pin_strength" not in asked:  # which tells it itself
        notices += run(body, lambda: body.results.size_notices)[0]
    judged, _ = run(body, body.judge)
    warnings = [warning(each) for each in notices]
    shares, _ = run(body, lambda: disc_shares(results=body.results, found=body.verdict))
    if shares is not None:
        sections["shares"] = SharesOut.of(shares)
        warnings += shares_warnings(shares)
    if warnings:
        sections["warnings"] = warnings
    return judged | {"model": body.forces} | sections


def work(body: CrankPlanetaryRequest) -> list[Values]:
    """Worked steps of the sections that are named; where none is, of all usual ones that can be."""
    sections, _ = run(body, lambda: body.sections)
    named = [each for each in sections if each in WORKED]
    if named:
        return worked(**{each: run(body, partial(WORKED[each], body))[0] for each in named})
    usual, _ = run(body, body.usual_sections)
    found = {}
    for each in usual:
        if each in WORKED:
            steps, _ = run(body, partial(if_known, partial(WORKED[each], body)))
            if steps is not None:
                found[each] = steps
    return worked(**found)


def _pattern_figure(body: CrankPlanetaryRequest, theme: Theme) -> Figure:
    """The cyclogram; where forces are solved that of the pairs which carry, about it the ideal
    one.
    """
    ideal, _ = run(body, lambda: body.mechanism.solve_for(body.carrying))
    answer = CyclogramResponse.values(ideal)
    if not body.draws_real:
        return cyclogram_figure(answer, theme)
    real, _ = run(body, body.solve_real_cyclogram)
    return cyclogram_figure(answer, theme, RealCyclogramOut.values(real))


def _force_figure(body: CrankPlanetaryRequest, theme: Theme) -> Figure:
    """The forces; where they are solved with the largest ideal one as a thin line."""
    load = body.load
    assert load is not None
    (force, switching), _ = run(
        body, lambda: load.solve_for_drawing(body.carrying, body.design.members)
    )
    ideal = ContactForceResponse.values(force)
    if not body.draws_real:
        return contact_force_figure(ideal, from_si("switching_deg", switching), theme)
    sharing, _ = run(body, lambda: body.results.real_forces)
    curves, _ = run(body, partial(body.real_curves, DRAWN_SAMPLES))
    drawn = ForceCurvesOut.values(curves)
    real = LoadSharingOut.values(sharing, judged_force_N=None, curves=drawn)
    return contact_force_figure(real, switching[:0], theme, ideal)


def figure(body: CrankPlanetaryRequest, theme: Theme = "light") -> Figure:
    """Cyclogram and, where a load is given, forces over one angle axis, as a Plotly figure: by the
    model of the answer, and the ideal one thin beside the real one. Where `include` names one of
    the sections `cyclogram` and `contact_force`, that alone; where it names `ring_mesh` alone, the
    mesh of the ring at its peak and over the turn, or the path of contact of involute teeth.
    """
    if body.include == ["ring_mesh"]:
        if body.design.gear.kind == "involute":
            return path_figure(run(body, body.solve_path)[0], theme)
        return ring_mesh_figure(run(body, body.solve_ring_figure)[0], theme)
    run(body, body.mechanism.refuse_undrawable)
    named = {"cyclogram", "contact_force"} & {*(body.include or ())}
    if body.load is None or named == {"cyclogram"}:
        return _pattern_figure(body, theme)
    if named == {"contact_force"}:
        return _force_figure(body, theme)
    return over_one_axis(_pattern_figure(body, theme), _force_figure(body, theme))


CALCULATION = Calculation(
    name="crank-planetary",
    title="Crank-planetary reducer",
    tag="crank-planetary",
    request=CrankPlanetaryRequest,
    answer=CrankPlanetaryResponse,
    solve=solve,
    worked=work,
    figure=figure,
    sources=(
        YANCHEVSKIY_2021,
        YANCHEVSKY_2018,
        ZYL,
        JOHNSON_1985,
        PERSSON_1964,
        HARRIS,
        ISO_6336,
        SHIGLEY,
        WANG_2016,
        ARCHARD_1953,
        ISO_281,
    ),
    neglects=(
        "bodies_rigid",
        "body_strength",
        "centrifugal_forces",
        "edge_pressure",
        "fretting",
        "friction_on_forces",
        "heat",
        "lubricant_film",
        "seals",
        "seat_compliance",
        "shaft_bearings",
        "tilt",
    ),
)
