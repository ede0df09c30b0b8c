"""POST /contact-force and its chart."""

from app.calculation import run
from app.figures.contact_force import contact_force_figure
from app.figures.theme import Figure, Theme
from app.route import calculations
from app.schemas.base import Values
from app.schemas.contact_force import ContactForceRequest, ContactForceResponse
from app.units import from_si

router = calculations("/contact-force", tag="crank-planetary")


@router.post("", response_model=ContactForceResponse)
def contact_force(body: ContactForceRequest) -> Values:
    """Contact force of the pairs: the exact peak, and curves and approximations where asked."""
    return ContactForceResponse.values(*run(body, body.solve))


@router.post("/chart")
def contact_force_chart(body: ContactForceRequest, theme: Theme = "light") -> Figure:
    """Force of every pair over the turn as a Plotly figure, ready for Plotly.js."""
    run(body, body.refuse_undrawable)
    (force, switching), run_time_us = run(body, lambda: body.solve_for_drawing(body.mechanism()))
    return contact_force_figure(
        ContactForceResponse.values(force, run_time_us),
        from_si("switching_deg", switching),
        theme,
    )
