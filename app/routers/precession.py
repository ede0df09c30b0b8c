"""POST /precession/contact-line, /meshing-load and /shaft-deflection with their charts."""

from app.calculation import run
from app.figures.precession import contact_line_figure, meshing_load_figure, shaft_figure
from app.figures.theme import Figure, Theme
from app.route import calculations
from app.schemas.base import Values
from app.schemas.precession.contact_line import ContactLineRequest, ContactLineResponse
from app.schemas.precession.meshing_load import MeshingLoadRequest, MeshingLoadResponse
from app.schemas.precession.shaft_deflection import ShaftDeflectionRequest, ShaftDeflectionResponse

router = calculations("/precession", tag="precessional gear")


@router.post("/contact-line", response_model=ContactLineResponse)
def contact_line(body: ContactLineRequest) -> Values:
    """Contact lines of the rollers and their lengths; points for drawing where asked."""
    return ContactLineResponse.values(*run(body, body.solve))


@router.post("/contact-line/chart")
def contact_line_chart(body: ContactLineRequest, theme: Theme = "light") -> Figure:
    """Contact lines developed on the rollers, and the wheel seen along its axis."""
    asked = body.model_copy(update={"include": ["points"], "samples": 41})
    lines = ContactLineResponse.values(*run(asked, asked.solve))
    return contact_line_figure(lines, body.roller_circle_radius_mm, body.roller_radius_mm, theme)


@router.post("/meshing-load", response_model=MeshingLoadResponse)
def meshing_load(body: MeshingLoadRequest) -> Values:
    """Line load, force and moment of the mesh."""
    return MeshingLoadResponse.values(*run(body, body.solve_load))


@router.post("/meshing-load/chart")
def meshing_load_chart(body: MeshingLoadRequest, theme: Theme = "light") -> Figure:
    """Line load along every contact line."""
    curves, _ = run(body, body.solve_curves)
    return meshing_load_figure(curves, theme)


@router.post("/shaft-deflection", response_model=ShaftDeflectionResponse)
def shaft_deflection(body: ShaftDeflectionRequest) -> Values:
    """Reactions of the shaft and its deflection at the bearings B and C, in both planes."""
    return ShaftDeflectionResponse.values(*run(body, body.solve))


@router.post("/shaft-deflection/chart")
def shaft_deflection_chart(body: ShaftDeflectionRequest, theme: Theme = "light") -> Figure:
    """Shear force, bending moment and deflection along the shaft, in both planes."""
    (_, diagram), _ = run(body, body.solve_diagram)
    return shaft_figure(diagram, body.bearing_distance_mm, theme)
