"""Mesh of satellites and ring within the whole design: answer and drawing."""

from app.calculations.involute_mesh import solved_pair
from app.calculations.members_answer import at_output
from app.calculations.ring_mesh_answer import (
    MeshTurnOut,
    RingEfficiencyOut,
    RingGeometryOut,
    RingIdealOut,
    TeethTurnOut,
)
from app.calculations.solved import Solved
from core.design.results import Results
from core.errors import if_known
from core.ring.series_teeth import TeethInSeries


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
