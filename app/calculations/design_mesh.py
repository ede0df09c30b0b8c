"""Mesh of satellites and ring within the whole design: answer and drawing."""

from app.calculations.involute_mesh import solved_pair
from app.calculations.members_answer import at_output
from app.calculations.ring_mesh_answer import (
    MeshTurnOut,
    RingDrawingOut,
    RingEfficiencyOut,
    RingGeometryOut,
    RingIdealOut,
    TeethTurnOut,
)
from app.calculations.solved import Solved
from app.model import Values
from core.design.drawings import drawn_mesh, drawn_teeth
from core.design.results import Results
from core.errors import if_known
from core.ring.mesh_curves import MeshCurves, SeriesCurves
from core.ring.series_teeth import TeethInSeries

DRAWN_RING = 120
"""Least number of crank angles at which discs and ring are drawn."""

MAX_DRAWN_PAIRS = 240
"""Largest number of pairs of discs and ring that are drawn."""

DRAWN_ERROR = 1e-5
"""Chord error of the drawn outline, m."""


def mesh_of(results: Results) -> Solved:
    """The mesh of the ring under the torque, in the direction of the larger pressure."""
    design = results.design
    if design.gear.kind == "involute":
        return _involute_mesh(results)
    turn, solved = results.ring.working[0], Solved()
    shown = TeethTurnOut if isinstance(turn, TeethInSeries) else MeshTurnOut
    mesh, members = turn.mesh, design.members
    each = design.pin_torque / design.mechanism.satellites
    solved.values |= {
        "geometry": RingGeometryOut.values(mesh.disc),
        "torque_direction": "driving" if turn.turn.torque > 0 else "reverse",
        "ideal": at_output(RingIdealOut.of(mesh.disc, each), members),
        "over_turn": at_output(shown.values(turn), members),
    }
    if loss := if_known(lambda: results.ring.loss):
        solved.values["efficiency"] = RingEfficiencyOut.values(loss)
    solved.take(turn.accuracy, turn.notices)
    return solved


def _involute_mesh(results: Results) -> Solved:
    """The mesh of involute teeth, of the satellite with the largest torque."""
    design = results.design
    factor = design.load_factor
    pair, loaded = results.ring.pair, results.ring.loaded_teeth(factor)
    _ = results.ring.involute_load(factor)  # materials are needed
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
    del values["kind"]  # the design states them
    values["satellite_torque_Nm"] = loaded["torque"]
    values["geometry"] = at_output(values["geometry"], design.members)
    return solved


def drawing_of(results: Results) -> Values | None:
    """Satellites and ring as they are drawn, and curves of discs on pins under the torque."""
    design = results.design
    if design.gear.kind == "involute":
        return if_known(
            lambda: RingDrawingOut.of_teeth(drawn_teeth(design=design, chord_error=DRAWN_ERROR))
        )
    turn = results.ring.working[0]
    pairs = turn.mesh.disc.pins * design.mechanism.satellites
    if pairs > MAX_DRAWN_PAIRS:
        return None
    drawn = drawn_mesh(design=design, mesh=turn.mesh, chord_error=DRAWN_ERROR)
    if not isinstance(turn, TeethInSeries):
        return RingDrawingOut.with_curves(drawn, MeshCurves(turn, DRAWN_RING))
    curves = SeriesCurves.over_period(turn, DRAWN_RING)
    many = pairs * len(curves.crank_angle) > MAX_DRAWN_PAIRS * (DRAWN_RING + 1)
    return RingDrawingOut.of(drawn) if many else RingDrawingOut.with_curves(drawn, curves)
