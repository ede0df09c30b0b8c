"""Quantities of the pieces of a study of both meshes in series, from the equilibria of
`core.ring.series_kernel`; rules in `core.output.loop_rows`.
"""

import math
from collections.abc import Sequence
from typing import Any, Generic, NamedTuple, TypeVar

from core.output.loop_rows import BINDS, FITS, NOWHERE, SOLVED, Errors, Law, Load, Row
from core.output.sharing_kernel import prepare as prepare_holes
from core.output.turn_kernel import none as none_of_output
from core.ring.approach import prepare_mesh
from core.ring.exact_touch import MeshSetup
from core.ring.series_disc import SeriesPairs, SeriesRoom, SeriesSetup
from core.ring.series_disc import between as one_disc
from core.ring.series_kernel import hardest as hardest_pin
from core.ring.series_kernel import judged as judged_in_series
from core.ring.series_kernel import largest as largest_pin
from core.ring.series_kernel import of_mesh as of_ring
from core.ring.series_kernel import placed
from core.ring.series_kernel import solve as solve_in_series

R = TypeVar("R")


class MeshErrors(NamedTuple, Generic[R]):
    """What of one piece the ring alone has, rows of [z_p], [K] or as said; of many, a table of
    each.
    """

    radial: R  # of its pins
    tangential: R
    radius: R
    disc_phase: R  # of each disc's holes against its teeth
    tool: R  # [4] of `MeshSetup`: tool_circle, tool, equidistant, pin_circle


class SeriesPieces(NamedTuple):
    """Quantities of pieces; not a number where one cannot work."""

    peak_force: Row  # of the pins of the output
    max_pressure: Row  # of these, as `hardest`
    transmission_error: Row
    backlash_max: Row
    lost_motion: Row
    stiffness_min: Row
    fits: Row  # FITS, BINDS or NOWHERE
    ring_peak_force: Row  # of the pins of the ring
    ring_max_pressure: Row  # of these, force over reduced radius


def cut(setup: Any, tool: Row) -> SeriesSetup:
    """The design of discs that another tool cuts."""
    own: Any = setup.mesh
    mesh = MeshSetup(
        own.pins,
        own.satellites,
        own.ratio,
        own.exact,
        own.radius,
        own.pin_radius,
        own.eccentricity,
        own.clearance,
        own.direction,
        own.law,
        own.exponent,
        own.curve,
        own.wrap,
        own.support,
        own.gives,
        own.loose,
        own.foot,
        tool[0],
        tool[1],
        tool[2],
        tool[3],
        own.rotation,
    )
    return SeriesSetup(
        setup.pins,
        setup.satellites,
        setup.direction,
        setup.ratio,
        setup.start,
        mesh,
        setup.output,
    )


def prepare_both(
    setup: SeriesSetup,
    laws: tuple[Law, Law],
    errors: Errors[Row],
    mesh: MeshErrors[Row],
    phase: Row,
    compliance: tuple[Row, Row],
    outward: Row,
    pairs: SeriesPairs,
    room: SeriesRoom,
) -> bool:
    """Constants of the pairs of one piece, disc by disc; whether all have a size. Laws and
    compliances are those of the ring, and of the pins of the output, outward the directions of
    these from the middle. Of the errors a disc has the phase that its lag has not: a crank ahead
    turns it there.
    """
    can = True
    for j in range(setup.satellites):
        disc = one_disc(j, pairs, room)
        a, b = j * setup.pins, (j + 1) * setup.pins
        own, crank = errors.eccentricity[j : j + 1], errors.crank_phase[j : j + 1]
        on_teeth = (
            mesh.radial,
            mesh.tangential,
            mesh.radius,
            own,
            crank,
            mesh.disc_phase[j : j + 1],
        )
        on_pins = Errors(
            errors.pin_radial,
            errors.pin_tangential,
            errors.pin_radius,
            errors.hole_radial[a:b],
            errors.hole_tangential[a:b],
            errors.hole_radius[a:b],
            own,
            crank,
            errors.disc_phase[j : j + 1],
        )
        at = phase[j : j + 1]
        teeth, pins = compliance[0][j : j + 1], compliance[1][j : j + 1]
        if prepare_mesh(setup.mesh, laws[0], on_teeth, at, teeth, disc.teeth) >= 0:
            can = False
        if prepare_holes(setup.output, laws[1], on_pins, at, pins, outward, disc.holes) >= 0:
            can = False
    return can


def fits_both(places: Row, setup: SeriesSetup, pairs: SeriesPairs, room: SeriesRoom) -> int:
    """Whether a piece goes together without load, in both meshes: FITS, BINDS or NOWHERE."""
    free = blocked = False
    for angle in places:
        low, high, error, pressed = placed(angle, setup, pairs, room)
        if pressed or low > high + error:
            blocked = True
        else:
            free = True
        if free and blocked:
            return BINDS
    return FITS if free else NOWHERE


def lost(angle: float, load: Load, pairs: SeriesPairs, room: SeriesRoom) -> tuple[float, bool]:
    """Lost motion at a crank angle, and whether it can be."""
    both, can = 0.0, True
    for back in range(2):
        setup: Any = load.back if back else load.setup
        found = solve_in_series(angle, load.share * load.torque, setup, pairs, room)
        both += found.lag
        can = can and judged_in_series(found, setup, pairs, room) == SOLVED
    return both, can


def piece_of_both(
    sample: int,
    places: Row,
    looked: Row,
    under_load: bool,
    back: bool,
    load: Load,
    pairs: SeriesPairs,
    room: SeriesRoom,
    results: SeriesPieces,
) -> bool:
    """Quantities of a piece that fits where is looked, at crank angles; whether it can work. What
    takes the forces under load, and the lost motion, are taken only where they are asked.
    """
    peak = pressure = teeth = pressed = backlash = motion = 0.0
    least_lag, most_lag, stiffness = math.inf, -math.inf, math.inf
    setup: Any = load.setup
    results.fits[sample] = fits_both(looked, setup, pairs, room)
    if results.fits[sample] != FITS:
        return False
    room.turned[0] = 0.0  # what was solved last was another piece
    for k, angle in enumerate(places):
        if under_load:
            found = solve_in_series(angle, load.torque, setup, pairs, room)
            if judged_in_series(found, setup, pairs, room) != SOLVED:
                return False
            peak = max(peak, largest_pin(room))
            pressure = max(pressure, hardest_pin(setup, pairs, room))
            teeth = max(teeth, of_ring(False, pairs, room))
            pressed = max(pressed, of_ring(True, pairs, room))
            least_lag, most_lag = min(least_lag, found.lag), max(most_lag, found.lag)
            stiffness = min(stiffness, found.stiffness)
            low, high = found.low, found.high
        else:
            low, high, _, _ = placed(angle, setup, pairs, room)
        backlash = max(backlash, high - low)
        if back:
            both, can = lost(angle, load, pairs, room)
            if not can:
                return False
            motion = both if k == 0 else max(motion, both)
    results.peak_force[sample], results.max_pressure[sample] = peak, pressure
    results.ring_peak_force[sample], results.ring_max_pressure[sample] = teeth, pressed
    results.transmission_error[sample] = most_lag - least_lag
    results.backlash_max[sample], results.lost_motion[sample] = backlash, motion
    results.stiffness_min[sample] = stiffness
    return True


def pieces(
    errors: Errors[Sequence[Row]],
    mesh: MeshErrors[Sequence[Row]],
    places: Row,
    looked: Row,
    under_load: bool,
    back: bool,
    laws: tuple[Law, Law],
    load: Load,
    phase: Row,
    compliance: tuple[Row, Row],
    outward: Row,
    pairs: SeriesPairs,
    room: SeriesRoom,
    results: SeriesPieces,
) -> None:
    """Quantities of many pieces."""
    output: Any = results
    for sample in range(len(errors.pin_radial)):
        own = Errors(
            errors.pin_radial[sample],
            errors.pin_tangential[sample],
            errors.pin_radius[sample],
            errors.hole_radial[sample],
            errors.hole_tangential[sample],
            errors.hole_radius[sample],
            errors.eccentricity[sample],
            errors.crank_phase[sample],
            errors.disc_phase[sample],
        )
        teeth = MeshErrors(
            mesh.radial[sample],
            mesh.tangential[sample],
            mesh.radius[sample],
            mesh.disc_phase[sample],
            mesh.tool[sample],
        )
        setup: Any = cut(load.setup, teeth.tool)
        back_setup: Any = cut(load.back, teeth.tool)
        made = Load(load.torque, load.share, setup, back_setup)
        can = prepare_both(setup, laws, own, teeth, phase, compliance, outward, pairs, room)
        if not (
            can
            and piece_of_both(sample, places, looked, under_load, back, made, pairs, room, results)
        ):
            none_of_output(sample, output)
            results.ring_peak_force[sample] = results.ring_max_pressure[sample] = math.nan
