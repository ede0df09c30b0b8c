"""Sections of a crank-planetary reducer's answer: each its values, by the request."""

import math
from collections.abc import Callable
from functools import partial

import numpy as np

from app.calculations.both_meshes import RingTurnOut
from app.calculations.contact_force import ContactForceResponse, ForceCurvesOut
from app.calculations.crank_planetary_answer import DesignHertzOut, LoadSharingOut
from app.calculations.crank_planetary_request import CrankPlanetaryRequest, Section
from app.calculations.crankshaft import CrankshaftResponse
from app.calculations.cyclogram import CyclogramResponse
from app.calculations.geometry_answer import GeometryOut
from app.calculations.involute_mesh import solved_pair
from app.calculations.load_sharing_answer import RealCyclogramOut
from app.calculations.members_answer import MembersOut, at_output
from app.calculations.output_efficiency import OutputEfficiencyResponse
from app.calculations.pin_rollers_answer import RollersOut
from app.calculations.pin_strength import PinStrengthResponse
from app.calculations.ring_mesh_answer import (
    MeshTurnOut,
    RingDrawingOut,
    RingEfficiencyOut,
    RingGeometryOut,
    RingIdealOut,
    TeethTurnOut,
)
from app.calculations.satellite_bearing import SatelliteBearingResponse
from app.calculations.solved import Solved
from app.calculations.usual_fit_answer import UsualFitOut, UsualModificationOut
from app.model import Values
from app.running import timed
from app.units import to_si
from core.arrays import FloatArray
from core.checks.usual_modification import usual_clearance_too
from core.design.drawings import drawn_mesh, drawn_teeth
from core.design.real_forces import RealForces
from core.errors import if_known
from core.output.contact_force import ContactForce, ForceCurves, PairNumber, drawing_angles
from core.output.pin_geometry import PinGeometry, pin_fit, pin_geometry
from core.output.real_cyclogram import RealCyclogram, carried_forces, real_cyclogram
from core.ring.mesh_curves import MeshCurves, SeriesCurves
from core.ring.series_teeth import TeethInSeries
from core.ring.series_turn import SeriesOverTurn

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
    loss = if_known(lambda: body.results.ring.loss)
    if loss is not None:
        solved.values["efficiency"] = RingEfficiencyOut.values(loss)
    solved.take(turn.accuracy, turn.notices)
    return solved


def _ring_mesh(body: CrankPlanetaryRequest) -> Values:
    mesh, took_us = timed(partial(_mesh, body))
    return mesh.answer(took_us)


def _drawing(body: CrankPlanetaryRequest) -> Values | None:
    """Satellites and ring as they are drawn, and what discs on pins do under the torque."""
    if body.design.gear.kind == "involute":
        teeth = if_known(partial(drawn_teeth, design=body.design, chord_error=DRAWN_ERROR))
        return None if teeth is None else RingDrawingOut.of_teeth(teeth)
    turn = body.results.ring.working[0]
    pairs = turn.mesh.disc.pins * body.mechanism.satellites
    if pairs > MAX_DRAWN_PAIRS:
        return None
    drawn = drawn_mesh(design=body.design, mesh=turn.mesh, chord_error=DRAWN_ERROR)
    if not isinstance(turn, TeethInSeries):
        return RingDrawingOut.of(drawn, MeshCurves(turn, DRAWN_RING))
    curves = SeriesCurves.over_period(turn, DRAWN_RING)
    many = pairs * len(curves.crank_angle) > MAX_DRAWN_PAIRS * (DRAWN_RING + 1)
    return RingDrawingOut.of(drawn, None if many else curves)


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
