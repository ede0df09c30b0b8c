"""Figures of a crank-planetary reducer: pattern and forces, the mesh of the ring."""

from app.calculations.contact_force import (
    ContactForceResponse,
    ForceCurvesOut,
    contact_force_figure,
)
from app.calculations.crank_planetary_answer import LoadSharingOut
from app.calculations.crank_planetary_request import CrankPlanetaryRequest
from app.calculations.crank_planetary_sections import (
    MAX_DRAWN_PAIRS,
    carrying_pairs,
    real_curves,
)
from app.calculations.cyclogram import CyclogramResponse, cyclogram_figure, over_one_axis
from app.calculations.involute_mesh import drawn_path
from app.calculations.load_sharing_answer import RealCyclogramOut
from app.calculations.ring_mesh_figure import (
    DrawnPath,
    ShownMesh,
    path_figure,
    ring_mesh_figure,
)
from app.problems import refusal
from app.theme import Figure, Theme
from app.units import from_si

DRAWN_SAMPLES = 361
"""Crank angles of the figure's real forces."""


def _path(body: CrankPlanetaryRequest) -> DrawnPath:
    """The pressure along the path of contact of involute teeth, as the section `ring_mesh` has
    it.
    """
    ring, factor = body.results.ring, body.design.load_factor
    _ = ring.involute_load(factor)  # which needs materials
    return drawn_path(pair=ring.pair, loaded=ring.loaded_teeth(factor))


def _mesh(body: CrankPlanetaryRequest) -> ShownMesh:
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
        return ring_mesh_figure(_mesh(body), theme)
    body.mechanism.refuse_undrawable()
    named = {"cyclogram", "contact_force"} & {*(body.include or ())}
    if body.load is None or named == {"cyclogram"}:
        return _pattern_figure(body, theme)
    if named == {"contact_force"}:
        return _force_figure(body, theme)
    return over_one_axis(_pattern_figure(body, theme), _force_figure(body, theme))
