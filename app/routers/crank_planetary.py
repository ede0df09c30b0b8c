"""POST /crank-planetary and its chart: mechanism, load and contact as one job."""

from app.calculation import run
from app.figures.contact_force import contact_force_figure
from app.figures.crank_planetary import over_one_axis
from app.figures.cyclogram import cyclogram_figure
from app.figures.theme import Figure, Theme
from app.route import calculations
from app.schemas.base import Values, warning
from app.schemas.contact_force import ContactForceResponse
from app.schemas.crank_planetary import CrankPlanetaryRequest, CrankPlanetaryResponse, GeometryOut
from app.schemas.cyclogram import CyclogramResponse
from app.schemas.hertz import HertzResponse
from app.units import from_si

router = calculations("/crank-planetary", tag="crank-planetary")


@router.post("", response_model=CrankPlanetaryResponse)
def crank_planetary(body: CrankPlanetaryRequest) -> Values:
    """Cyclogram, contact force, Hertz stress and geometry: the sections that are asked.

    Warnings say how pins and holes fit, whichever sections are asked.
    """
    sections: Values = {}
    if "cyclogram" in body.include:
        sections["cyclogram"] = CyclogramResponse.values(*run(body, body.mechanism.solve))
    if not {"contact_force", "hertz"}.isdisjoint(body.include):
        force, force_us = run(body, body.solve_force)
        if "contact_force" in body.include:
            sections["contact_force"] = ContactForceResponse.values(force, force_us)
        if "hertz" in body.include:
            contact, hertz_us = run(body, lambda: body.solve_hertz(force))
            sections["hertz"] = HertzResponse.values(contact, hertz_us)
    if "geometry" in body.include:
        sections["geometry"] = GeometryOut.values(*run(body, body.solve_geometry))
    fit, _ = run(body, body.solve_fit)
    if fit is not None and fit.notices:
        sections["warnings"] = [warning(each) for each in fit.notices]
    return sections


@router.post("/chart")
def crank_planetary_chart(body: CrankPlanetaryRequest, theme: Theme = "light") -> Figure:
    """Cyclogram and, where a load is given, forces over one angle axis, as a Plotly figure."""
    run(body, body.mechanism.refuse_undrawable)
    pattern = cyclogram_figure(CyclogramResponse.values(*run(body, body.mechanism.solve)), theme)
    if body.load is None:
        return pattern
    load = body.load
    (force, switching), force_us = run(body, lambda: load.solve_for_drawing(body.built))
    return over_one_axis(
        pattern,
        contact_force_figure(
            ContactForceResponse.values(force, force_us),
            from_si("switching_deg", switching),
            theme,
        ),
    )
