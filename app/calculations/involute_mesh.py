"""A satellite of involute teeth in its ring: what a request says of the pair, and what is answered
of it.
"""

from typing import ClassVar, Literal

import numpy as np

from app.calculations.hertz import Material, contact_length, material_of
from app.calculations.involute_teeth import (
    InvoluteGeometryOut,
    InvoluteStressesOut,
    InvoluteTeethFields,
    RootStressOut,
)
from app.calculations.ring_mesh_answer import SharedPairsOut
from app.calculations.ring_mesh_figure import DrawnPath
from app.calculations.solved import Solved
from app.model import Maybe, Size, Values, quantity
from app.units import to_si
from core.errors import NotKnown
from core.results import Notice
from core.ring.involute import InvolutePair
from core.ring.involute_load import involute_load, mean_loss_ratio, pressure_along, root_stress
from core.ring.shared_pairs import pairs_that_carry

DRAWN_PLACES = 201
"""Places of the line of action in the figure."""

LEAST_DRAWN = 0.02
"""Least roll angle in the figure, over the largest: at the base circle the pressure has no end."""


class InvoluteRingFields(InvoluteTeethFields, group="gear"):
    """Involute teeth of satellite and ring, and what their stresses need."""

    ASSUMED: ClassVar[tuple[str, ...]] = ("satellite_material", "ring_material")

    kind: Literal["involute"] = quantity("Ring")
    """Involute teeth."""
    contact_length_mm: Size = contact_length()
    satellite_material: Material = quantity("Satellite material", default="steel_structural")
    """A name of the table of materials, or values."""
    ring_material: Material = quantity("Ring material", default="steel_structural")
    """A name of the table of materials, or values."""
    face_load_factor: float = quantity(
        "Face load factor", "K_Hβ", default=1.0, step=0.05, advanced=True, ge=1, le=10
    )
    """Factor on the force for stresses, as it is not the same along the width."""
    pair_stiffness_N_per_mm: Maybe[Size] = quantity(
        "Stiffness of a pair", "k", step=10_000, advanced=True
    )
    """Along the line of action, for the pairs that carry; 14 N/(mm·µm) of the width where not
    given."""
    friction_coefficient: Maybe[float] = quantity(
        "Friction coefficient", "μ", step=0.01, ge=0, le=1
    )
    """Of the flanks; without it no loss is answered."""


def solved_pair(
    *,
    gear: InvoluteRingFields,
    pair: InvolutePair,
    torque: float,
    application_factor: float,
    power: float | None,
    asked: set[str],
) -> Solved:
    """Geometry of a pair, and the sections that are asked for.

    Parameters
    ----------
    gear : InvoluteRingFields
        Width, materials, friction.
    pair : InvolutePair
        The teeth.
    torque : float
        Torque of a satellite, N*m.
    application_factor : float
        Factor K_A of the stresses.
    power : float or None
        Power of the output, W.
    asked : set of str
        Sections.

    Returns
    -------
    Solved
    """
    values: Values = {"kind": "involute", "geometry": InvoluteGeometryOut.values(pair)}
    solved = Solved(values)
    solved.take(pair.accuracy, _notices(pair))
    loaded = {"torque": torque, "contact_length": to_si("length_mm", gear.contact_length_mm)}
    factor = application_factor * gear.face_load_factor
    if "stresses" in asked:
        load = involute_load(
            pair=pair,
            satellite_material=material_of(gear.satellite_material),
            ring_material=material_of(gear.ring_material),
            load_factor=factor,
            **loaded,
        )
        root, unknown = None, tuple[Notice, ...]()
        try:
            found = root_stress(pair=pair, load_factor=factor, **loaded)
            root = RootStressOut.values(found)
        except NotKnown as why:
            unknown = (Notice(why.code),)
        values["stresses"] = InvoluteStressesOut.values(load, root=root)
        solved.take(load.accuracy, unknown)
        if gear.friction_coefficient is not None:
            values["efficiency"] = _efficiency(pair, gear.friction_coefficient, power)
    if "shared_pairs" in asked:
        stiffness = to_si("stiffness_N_per_mm", gear.pair_stiffness_N_per_mm)
        carried = pairs_that_carry(pair=pair, stiffness=stiffness, **loaded)
        values["shared_pairs"] = SharedPairsOut.values(carried)
        solved.take(carried.accuracy)
    return solved


def _notices(pair: InvolutePair) -> tuple[Notice, ...]:
    """What of the teeth does not mesh."""
    found = []
    if not pair.contact_ratio >= 1:
        found.append(Notice("path_short", {"contact_ratio": pair.contact_ratio}))
    if not pair.on_involutes:
        found.append(Notice("off_involutes"))
    if pair.normal_backlash < 0:
        found.append(Notice("teeth_press"))
    return tuple(found)


def _efficiency(pair: InvolutePair, friction: float, power: float | None) -> Values:
    """What the flanks lose, one pair carrying, mean over the path."""
    each = mean_loss_ratio(pair=pair, friction=1.0)
    lost = friction * each
    return {
        "loss_per_friction": each,
        "loss_ratio": lost,
        "efficiency": 1 / (1 + lost),
        "loss_error": float(pair.accuracy.relative_error),
    } | ({} if power is None else {"mean_loss_W": lost * power})


def drawn_path(
    *, gear: InvoluteRingFields, pair: InvolutePair, torque: float, application_factor: float
) -> DrawnPath:
    """The pressure of one pair along its path of contact.

    Parameters
    ----------
    gear : InvoluteRingFields
        Width and materials.
    pair : InvolutePair
        The teeth.
    torque : float
        Torque of a satellite, N*m.
    application_factor : float
        Factor K_A of the pressure.

    Returns
    -------
    DrawnPath
    """
    rolls = {
        "path_start": pair.start_roll,
        "path_end": pair.end_roll,
        "pitch_point": pair.line.pitch_roll,
    }
    least = LEAST_DRAWN * max(rolls.values())
    line = np.linspace(max(min(rolls.values()), least), max(rolls.values()), DRAWN_PLACES)
    path = np.linspace(max(pair.start_roll, least), max(pair.end_roll, least), DRAWN_PLACES)
    points = {name: roll for name, roll in rolls.items() if roll >= least}
    pressures = [
        pressure_along(
            pair=pair,
            torque=torque,
            contact_length=to_si("length_mm", gear.contact_length_mm),
            satellite_material=material_of(gear.satellite_material),
            ring_material=material_of(gear.ring_material),
            load_factor=application_factor * gear.face_load_factor,
            roll=roll,
        )
        for roll in (line, path, np.array([*points.values()]))
    ]
    base = pair.line.satellite_base
    places = {name: base * roll for name, roll in points.items()}
    return DrawnPath(base * line, base * path, places, *map(np.asarray, pressures))
