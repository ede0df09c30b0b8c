"""Crank-planetary reducer as one job: its figures and worked steps, by sections of the answer."""

from contextlib import suppress

from app.calculations.contact_force import contact_force_figure
from app.calculations.crank_planetary_answer import (
    CrankPlanetaryResponse,
    LoadSharingOut,
)
from app.calculations.crank_planetary_sections import (
    CrankPlanetaryRequest,
    carrying_pairs,
    real_curves,
    solve,
)
from app.calculations.cyclogram import cyclogram_figure, over_one_axis
from app.calculations.ideal_forces import ContactForceResponse, CyclogramResponse, ForceCurvesOut
from app.calculations.involute_mesh import drawn_path
from app.calculations.load_sharing_answer import RealCyclogramOut
from app.calculations.ring_mesh_figure import (
    DrawnPath,
    ShownMesh,
    path_figure,
    ring_mesh_figure,
)
from app.model import Calculation
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
from app.units import from_si
from core.design.drawings import MAX_DRAWN_PAIRS
from core.errors import NotKnown

DRAWN_SAMPLES = 361
"""Number of crank angles of solved forces in the figure."""


def _path(body: CrankPlanetaryRequest) -> DrawnPath:
    """Pressure along the path of contact of involute teeth, as in the section `ring_mesh`."""
    ring, factor = body.results.ring, body.design.load_factor
    _ = ring.involute_load(factor)  # materials are needed
    return drawn_path(pair=ring.pair, loaded=ring.loaded_teeth(factor))


def _shown_mesh(body: CrankPlanetaryRequest) -> ShownMesh:
    """Ring mesh that the figure shows."""
    turn, own = body.results.ring.working[0], body.mechanism
    if turn.mesh.disc.pins * own.satellites > MAX_DRAWN_PAIRS:
        name = "ratio" if own.ring_teeth is None else "ring_teeth"
        limit = {"limit": MAX_DRAWN_PAIRS // own.satellites, "satellites": own.satellites}
        raise refusal(f"/mechanism/{name}", "too_many_pairs", **limit)
    return ShownMesh.at_peak(turn, body.design.members)


def _pattern_figure(body: CrankPlanetaryRequest, theme: Theme) -> Figure:
    """Cyclogram; for solved forces that of the carrying pairs, with the ideal one as an outline."""
    ideal = body.mechanism.solve_for(body.carrying)
    answer = CyclogramResponse.values(ideal)
    if not body.draws_real:
        return cyclogram_figure(answer, theme)
    real = carrying_pairs(body)
    return cyclogram_figure(answer, theme, RealCyclogramOut.values(real))


def _force_figure(body: CrankPlanetaryRequest, theme: Theme) -> Figure:
    """Forces; for solved forces with the largest ideal force as a thin line. Pins that do not go
    into their holes have none, and are refused.
    """
    with suppress(NotKnown):
        body.results.refuse_misfits()
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
    """Cyclogram and, with a load, forces over one angle axis, as a Plotly figure: by the model of
    the answer, with ideal forces thin beside solved ones.

    If `include` names one of the sections `cyclogram` and `contact_force`, that section is drawn
    alone. If it names `ring_mesh` alone, the ring mesh at its peak and over the turn is drawn, or
    the path of contact of involute teeth.
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


CALCULATION = Calculation(
    name="crank-planetary",
    title="Crank-planetary reducer",
    tag="crank-planetary",
    request=CrankPlanetaryRequest,
    answer=CrankPlanetaryResponse,
    solve=solve,
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
