"""The crank-planetary reducer as one job: request, answer by sections, figures, worked steps."""

import math
from collections.abc import Callable
from functools import partial

import numpy as np

from app.calculations.both_meshes import RingTurnOut
from app.calculations.checks import codes_to_fix, fix_values, judgement
from app.calculations.combined import combined
from app.calculations.contact_force import contact_force_figure
from app.calculations.crank_planetary_answer import (
    ColdYieldOut,
    CrankPlanetaryResponse,
    DesignHertzOut,
    LoadSharingOut,
)
from app.calculations.crank_planetary_request import CrankPlanetaryRequest, Section
from app.calculations.crankshaft import CrankshaftResponse
from app.calculations.cyclogram import cyclogram_figure, over_one_axis
from app.calculations.geometry_answer import GeometryOut
from app.calculations.hertz import entry_of
from app.calculations.ideal_forces import ContactForceResponse, CyclogramResponse, ForceCurvesOut
from app.calculations.involute_mesh import drawn_path, solved_pair
from app.calculations.load_sharing_answer import RealCyclogramOut
from app.calculations.mechanism import FitOut
from app.calculations.members_answer import MembersOut, at_output
from app.calculations.output_efficiency import OutputEfficiencyResponse
from app.calculations.pin_rollers_answer import RollersOut
from app.calculations.pin_strength import PinStrengthResponse
from app.calculations.reducer_fixes import fixes_of
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
from app.calculations.satellite_bearing import SatelliteBearingResponse
from app.calculations.shares_answer import SharesOut, shares_warnings
from app.calculations.solved import Solved
from app.calculations.usual_fit_answer import UsualFitOut, UsualModificationOut
from app.model import Calculation, Values, notices_of, present, timed, warning
from app.problems import refusal
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
from core.checks.cold_yield import ColdYield, cold_yield
from core.checks.shares import disc_shares
from core.checks.usual_modification import usual_clearance_too
from core.design.drawings import drawn_mesh, drawn_teeth
from core.design.real_forces import RealForces
from core.design.results import MOST_IN_SERIES
from core.errors import Notice, if_known
from core.fixes.fix import Fix
from core.materials import NOT_LISTED
from core.output.contact_force import ContactForce, ForceCurves, PairNumber, drawing_angles
from core.output.mechanism import PinGeometry, pin_fit, pin_geometry
from core.output.real_cyclogram import RealCyclogram, carried_forces, real_cyclogram
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

DRAWN_RING = 120
"""Crank angles at which discs and ring are drawn, at least, of at most `MAX_DRAWN_PAIRS`."""

MAX_DRAWN_PAIRS = 240
"""Most pairs of discs and ring that are drawn."""

DRAWN_ERROR = 1e-5
"""Chord error of the outline there, m."""


def _cyclogram(body: CrankPlanetaryRequest) -> Values:
    pattern = timed(lambda: body.mechanism.solve_for(body.design.driven))
    return CyclogramResponse.values(*pattern)


def _members(body: CrankPlanetaryRequest) -> Values:
    loads, took_us = timed(lambda: body.results.member_loads)
    return MembersOut.values(loads, took_us, output=body.mechanism.output)


def ideal_force(body: CrankPlanetaryRequest) -> ContactForce:
    """Contact force; without its own section only what the others need of it."""
    load = body.known_load
    if "contact_force" not in body.sections:
        load = load.model_copy(update={"include": []})
    return load.solve_for(body.design.driven, body.design.members)


def _contact_force(body: CrankPlanetaryRequest) -> Values:
    return ContactForceResponse.values(*timed(partial(ideal_force, body)))


def _load_sharing(body: CrankPlanetaryRequest) -> Values:
    """The forces that are solved over the turn, at the torque itself."""
    sharing, run_us = timed(lambda: body.results.real_forces)
    forces = if_known(lambda: body.results.judged_forces)
    force_N = forces.force if isinstance(forces, RealForces) else None
    curves = None
    load = body.known_load
    if load.curve_samples:
        curves = real_curves(body, load.samples_of(body.built))
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
    """Forces that are solved, over the range of the figure of forces."""
    angles, _ = drawing_angles(mechanism=body.built, samples=2)
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
    """Which pairs carry."""
    return real_cyclogram(turn=body.solved_turn, revolutions=body.mechanism.revolutions)


def _real_cyclogram(body: CrankPlanetaryRequest) -> Values:
    return RealCyclogramOut.values(*timed(partial(carrying_pairs, body)))


def _hertz(body: CrankPlanetaryRequest) -> Values:
    contact, took_us = timed(lambda: body.results.hertz)
    factor = body.results.line_load_factor if body.pin else None
    return DesignHertzOut.values(contact, took_us, line_load_factor=factor)


def _involute_mesh(body: CrankPlanetaryRequest) -> Solved:
    """The mesh of involute teeth, of the satellite with the largest torque."""
    results, design = body.results, body.design
    factor = design.load_factor
    pair, loaded = results.ring.pair, results.ring.loaded_teeth(factor)
    _ = results.ring.involute_load(factor)  # which needs materials
    asked = {"stresses"} | ({"shared_pairs"} if pair.on_involutes else set())
    solved = solved_pair(
        ring=design.involute,
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


def _mesh(body: CrankPlanetaryRequest) -> Solved:
    """The mesh of the ring under the torque, in the direction of the larger pressure."""
    if body.design.gear.kind == "involute":
        return _involute_mesh(body)
    turn, solved = body.results.ring.working[0], Solved()
    shown = TeethTurnOut if isinstance(turn, TeethInSeries) else MeshTurnOut
    mesh, members = turn.mesh, body.design.members
    each = body.design.pin_torque / body.mechanism.satellites
    solved.values |= {
        "geometry": RingGeometryOut.values(mesh.disc),
        "method": "exact" if mesh.exact else "first_order",
        "torque_direction": "driving" if turn.turn.torque > 0 else "reverse",
        "ideal": at_output(RingIdealOut.of(mesh.disc, each), members),
        "over_turn": at_output(shown.values(turn), members),
    }
    if loss := if_known(lambda: body.results.ring.loss):
        solved.values["efficiency"] = RingEfficiencyOut.values(loss)
    solved.take(turn.accuracy, turn.notices)
    return solved


def _ring_mesh(body: CrankPlanetaryRequest) -> Values:
    mesh, took_us = timed(partial(_mesh, body))
    return mesh.answer(took_us)


def _drawing(body: CrankPlanetaryRequest) -> Values | None:
    """Satellites and ring as they are drawn, and what discs on pins do under the torque."""
    if body.design.gear.kind == "involute":
        return if_known(
            lambda: RingDrawingOut.of_teeth(
                drawn_teeth(design=body.design, chord_error=DRAWN_ERROR)
            )
        )
    turn = body.results.ring.working[0]
    pairs = turn.mesh.disc.pins * body.mechanism.satellites
    if pairs > MAX_DRAWN_PAIRS:
        return None
    drawn = drawn_mesh(design=body.design, mesh=turn.mesh, chord_error=DRAWN_ERROR)
    if not isinstance(turn, TeethInSeries):
        return RingDrawingOut.with_curves(drawn, MeshCurves(turn, DRAWN_RING))
    curves = SeriesCurves.over_period(turn, DRAWN_RING)
    many = pairs * len(curves.crank_angle) > MAX_DRAWN_PAIRS * (DRAWN_RING + 1)
    return RingDrawingOut.of(drawn) if many else RingDrawingOut.with_curves(drawn, curves)


def _pin_strength(body: CrankPlanetaryRequest) -> Values:
    found, took_us = timed(lambda: body.results.pin_strength)
    return PinStrengthResponse.values(found, took_us, forces=body.forces)


def _output_efficiency(body: CrankPlanetaryRequest) -> Values:
    found, took_us = timed(lambda: body.results.losses.pins)
    return OutputEfficiencyResponse.values((found, None), took_us, forces=body.forces)


def _satellite_bearing(body: CrankPlanetaryRequest) -> Values:
    found, took_us = timed(lambda: body.results.crank.bearings)
    return SatelliteBearingResponse.values(found, took_us, forces=body.forces)


def _crankshaft(body: CrankPlanetaryRequest) -> Values:
    found, took_us = timed(lambda: body.results.crank.shaft)
    return CrankshaftResponse.values(found, took_us, forces=body.forces)


def _rollers(body: CrankPlanetaryRequest) -> Values:
    found, took_us = timed(lambda: body.results.rollers)
    return RollersOut.values(found, took_us, forces=body.forces)


def _pins_and_holes(body: CrankPlanetaryRequest) -> tuple[PinGeometry, FloatArray]:
    """Pins and holes at the crank angle, and the force of each pair there, N."""
    load = body.known_load
    crank_angle = to_si("crank_angle_deg", body.crank_angle_deg)
    sizes = body.given["contact"].sizes_on(load.pin_circle_radius_mm)
    sizes["eccentricity"] = pin_fit(pins=body.mechanism.pins, **sizes).eccentricity
    geometry = pin_geometry(mechanism=body.built, crank_angle=crank_angle, **sizes)
    if not body.results.solved:
        forces = load.forces_at(body.design.driven, body.design.members, crank_angle)
    else:
        forces = np.array(body.results.forces_at(crank_angle))
    return geometry, forces


def _geometry(body: CrankPlanetaryRequest) -> Values:
    return GeometryOut.values(*timed(partial(_pins_and_holes, body)))


def _usual_fit(body: CrankPlanetaryRequest) -> Values | None:
    """The design with a usual clearance, where none is known or 0 is stated."""
    found = usual_clearance_too(design=body.design, ring=body.usual_ring)
    return UsualFitOut.of(*found) if found else None


def _usual_modification(body: CrankPlanetaryRequest) -> Values | None:
    found = body.usual_ring
    return UsualModificationOut.of(found) if found else None


ANSWERS: dict[Section, Callable[[CrankPlanetaryRequest], Values | None]] = {
    "cyclogram": _cyclogram,
    "members": _members,
    "contact_force": _contact_force,
    "load_sharing": _load_sharing,
    "real_cyclogram": _real_cyclogram,
    "hertz": _hertz,
    "ring_mesh": _ring_mesh,
    "ring_drawing": _drawing,
    "pin_strength": _pin_strength,
    "output_efficiency": _output_efficiency,
    "satellite_bearing": _satellite_bearing,
    "crankshaft": _crankshaft,
    "rollers": _rollers,
    "geometry": _geometry,
    "usual_fit": _usual_fit,
    "usual_modification": _usual_modification,
}
"""What answers a section, in the order of the answer; None where there is nothing to say. Checks
and fixes are of the verdict.
"""


DRAWN_SAMPLES = 361
"""Crank angles of the figure's real forces."""


def _path(body: CrankPlanetaryRequest) -> DrawnPath:
    """The pressure along the path of contact of involute teeth, as the section `ring_mesh` has
    it.
    """
    ring, factor = body.results.ring, body.design.load_factor
    _ = ring.involute_load(factor)  # which needs materials
    return drawn_path(pair=ring.pair, loaded=ring.loaded_teeth(factor))


def _shown_mesh(body: CrankPlanetaryRequest) -> ShownMesh:
    """What the figure of the mesh shows."""
    turn, own = body.results.ring.working[0], body.mechanism
    if turn.mesh.disc.pins * own.satellites > MAX_DRAWN_PAIRS:
        name = "ratio" if own.ring_teeth is None else "ring_teeth"
        limit = {"limit": MAX_DRAWN_PAIRS // own.satellites, "satellites": own.satellites}
        raise refusal(f"/mechanism/{name}", "too_many_pairs", **limit)
    return ShownMesh.at_peak(turn, body.design.members)


def _pattern_figure(body: CrankPlanetaryRequest, theme: Theme) -> Figure:
    """The cyclogram; where forces are solved that of the pairs which carry, about it the ideal
    one.
    """
    ideal = body.mechanism.solve_for(body.carrying)
    answer = CyclogramResponse.values(ideal)
    if not body.draws_real:
        return cyclogram_figure(answer, theme)
    real = carrying_pairs(body)
    return cyclogram_figure(answer, theme, RealCyclogramOut.values(real))


def _force_figure(body: CrankPlanetaryRequest, theme: Theme) -> Figure:
    """The forces; where they are solved with the largest ideal one as a thin line."""
    load = body.known_load
    force, switching = load.solve_for_drawing(body.carrying, body.design.members)
    ideal = ContactForceResponse.values(force)
    if not body.draws_real:
        return contact_force_figure(ideal, from_si("switching_deg", switching), theme)
    sharing = body.results.real_forces
    curves = real_curves(body, DRAWN_SAMPLES)
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
            return path_figure(_path(body), theme)
        return ring_mesh_figure(_shown_mesh(body), theme)
    body.mechanism.refuse_undrawable()
    named = {"cyclogram", "contact_force"} & {*(body.include or ())}
    if body.load is None or named == {"cyclogram"}:
        return _pattern_figure(body, theme)
    if named == {"contact_force"}:
        return _force_figure(body, theme)
    return over_one_axis(_pattern_figure(body, theme), _force_figure(body, theme))


def _work_cyclogram(body: CrankPlanetaryRequest) -> list[Step]:
    found, _ = body.mechanism.solve()
    return cyclogram_steps(found=found, **body.mechanism.cyclogram_given())


def _work_contact_force(body: CrankPlanetaryRequest) -> list[Step]:
    """Those of the ideal force, which say so where others are judged."""
    return force_steps(
        mechanism=body.design.driven,
        found=ideal_force(body),
        judged=not body.results.solved,
        **body.known_load.force_given(body.design.members),
    )


def _work_clearance(body: CrankPlanetaryRequest) -> list[Step]:
    fit, pair = body.solve_fit(), body.design.contact.pair
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
"""What works the sections of the answer; the others are solved over the turn."""


def work(body: CrankPlanetaryRequest) -> list[Values]:
    """Worked steps of the sections that are named; where none is, of all usual ones that can be."""
    named = [each for each in body.sections if each in WORKED]
    if named:
        return worked(**{each: WORKED[each](body) for each in named})
    usual = [each for each in body.usual_sections() if each in WORKED]
    return worked(**present({each: if_known(partial(WORKED[each], body)) for each in usual}))


def _judged(body: CrankPlanetaryRequest) -> Values:
    """Verdict, and checks and fixes, of one input and of several, where asked."""
    found = body.verdict
    fixes: list[Fix] = []
    if {"fixes", "combined"} & {*body.sections}:
        codes = codes_to_fix(found, body.fixes_for)
        fixes = fixes_of(body, codes, found)
    values: Values = {}
    judged = partial(cold_yield, results=body.results, found=found)
    if body.design.plastics and (cold := if_known(judged)):
        values["cold_yield"] = _cold_values(body, cold)
    values |= judgement(
        found,
        body,
        torque=body.design.load.output_torque if body.design.load else 0.0,
        checks="checks" in body.sections,
    )
    if "fixes" in body.sections:
        values["fixes"] = [fix_values(each, body) for each in fixes]
    if "combined" in body.sections:
        values["combined"] = combined(body, found, fixes)
    return present(values)


def _cold_values(body: CrankPlanetaryRequest, cold: ColdYield) -> Values:
    """When a plastic contact yields at once, and where its strength comes from."""
    given = getattr(body.given["contact"], f"{cold.body}_material")
    own = not isinstance(given, str) and (given.yield_strength_MPa or given.tensile_strength_MPa)
    entry = NOT_LISTED if own else entry_of(given)
    return ColdYieldOut.values(cold, source=entry.strength.source or None)


def _notices(body: CrankPlanetaryRequest) -> tuple[Notice, ...]:
    """What is to be said of the design, whichever sections are asked."""
    results, found = body.results, notices_of(if_known(body.solve_fit))
    if body.contact is not None:
        found += body.contact.material_notices()
    if results.in_series:
        found += (Notice("both_meshes"),)
    elif forces := results.forces_in_series:
        found += (Notice("meshes_apart", {"forces": forces, "limit": MOST_IN_SERIES}),)
    found += notices_of(if_known(lambda: results.disc_of(results.hertz)))
    if "pin_strength" not in body.sections:  # which tells it itself
        found += results.size_notices
    return found


def solve(body: CrankPlanetaryRequest) -> Values:
    """Cyclogram, contact force, load sharing, Hertz stress, pins, efficiency, bearings, crankshaft,
    geometry: the sections that are asked.

    Verdict and warnings are there whichever sections are asked.
    """
    asked, results = body.sections, body.results
    sections = present({name: answer(body) for name, answer in ANSWERS.items() if name in asked})
    warnings = [warning(each) for each in _notices(body)]
    if rooms := if_known(lambda: results.rooms):
        sections["fit"] = FitOut.values(rooms)
    judged = _judged(body)
    if results.uneven and (shares := disc_shares(results=results, found=body.verdict)):
        sections["shares"] = SharesOut.of(shares)
        warnings += shares_warnings(shares)
    if warnings:
        sections["warnings"] = warnings
    return judged | {"model": body.forces} | sections


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
