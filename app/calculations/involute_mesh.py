"""Involute satellite in its ring: fields of the pair in a request, and its answer."""

from typing import Any

import numpy as np

from app.calculations.involute_teeth import (
    InvoluteGeometryOut,
    InvoluteStressesOut,
    RootStressOut,
)
from app.calculations.ring_mesh_answer import RingEfficiencyOut, SharedPairsOut
from app.calculations.ring_mesh_figure import DrawnPath
from app.calculations.solved import Solved
from app.model import Values
from core.design.ring import InvoluteRing
from core.errors import Notice, NotKnown
from core.ring.involute import InvolutePair
from core.ring.involute_load import involute_load, involute_loss, pressure_along, root_stress
from core.ring.shared_pairs import pairs_that_carry

DRAWN_PLACES = 201
"""Number of places of the line of action in the figure."""

LEAST_DRAWN = 0.02
"""Least roll angle in the figure over the largest, as the pressure is infinite at the base
circle."""


def solved_pair(
    *,
    ring: InvoluteRing,
    pair: InvolutePair,
    loaded: dict[str, Any],
    output_torque: float,
    input_speed: float | None,
    asked: set[str],
    notices: tuple[Notice, ...] = (),
) -> Solved:
    """Geometry of a pair, and the sections that are requested.

    Parameters
    ----------
    ring : InvoluteRing
        Ring with friction and stiffness.
    loaded : dict
        Torque of a satellite, width, materials and load factor, as arguments of
        `core.ring.involute_load.involute_load`.
    output_torque : float
        Torque of all satellites, N*m.
    input_speed : float or None
        Speed of the crank against the ring, rad/s.
    """
    values: Values = {"kind": "involute", "geometry": InvoluteGeometryOut.values(pair)}
    solved = Solved(values)
    solved.take(pair.accuracy, notices)
    forces = {name: loaded[name] for name in ("torque", "contact_length")}
    if "stresses" in asked:
        load = involute_load(pair=pair, **loaded)
        root, unknown = None, tuple[Notice, ...]()
        try:
            found = root_stress(pair=pair, load_factor=loaded["load_factor"], **forces)
            root = RootStressOut.values(found)
        except NotKnown as why:
            unknown = (Notice(why.code),)
        values["stresses"] = InvoluteStressesOut.values(load, root=root)
        solved.take(load.accuracy, unknown)
        if ring.friction_coefficient is not None:
            loss = involute_loss(
                pair=pair,
                friction=ring.friction_coefficient,
                output_torque=output_torque,
                input_speed=input_speed,
            )
            values["efficiency"] = RingEfficiencyOut.values(loss)
    if "shared_pairs" in asked:
        carried = pairs_that_carry(pair=pair, stiffness=ring.pair_stiffness, **forces)
        values["shared_pairs"] = SharedPairsOut.values(carried)
        solved.take(carried.accuracy)
    return solved


def pair_notices(pair: InvolutePair) -> tuple[Notice, ...]:
    """Notices of teeth that do not mesh properly."""
    found = []
    if not pair.contact_ratio >= 1:
        found.append(Notice("path_short", {"contact_ratio": pair.contact_ratio}))
    if not pair.on_involutes:
        found.append(Notice("off_involutes"))
    if pair.normal_backlash < 0:
        found.append(Notice("teeth_press"))
    return tuple(found)


def drawn_path(*, pair: InvolutePair, loaded: dict[str, Any]) -> DrawnPath:
    """Pressure of one pair along its path of contact; `loaded` as in `solved_pair`."""
    rolls = {
        "path_start": pair.start_roll_satellite,
        "path_end": pair.end_roll,
        "pitch_point": pair.line.pitch_roll,
    }
    least = LEAST_DRAWN * max(rolls.values())
    line = np.linspace(max(min(rolls.values()), least), max(rolls.values()), DRAWN_PLACES)
    path = np.linspace(
        max(pair.start_roll_satellite, least), max(pair.end_roll, least), DRAWN_PLACES
    )
    points = {name: roll for name, roll in rolls.items() if roll >= least}
    pressures = [
        pressure_along(pair=pair, **loaded, roll=roll)
        for roll in (line, path, np.array([*points.values()]))
    ]
    base = pair.line.satellite_base
    places = {name: base * roll for name, roll in points.items()}
    return DrawnPath(base * line, base * path, places, *map(np.asarray, pressures))
