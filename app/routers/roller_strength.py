"""POST /roller-strength and its chart."""

from app.calculation import run
from app.figures.roller_strength import roller_figure
from app.figures.theme import Figure, Theme
from app.route import calculations
from app.schemas.base import Values
from app.schemas.roller_strength import RollerStrengthRequest, RollerStrengthResponse

router = calculations("/roller-strength", tag="swinging rollers")


@router.post("", response_model=RollerStrengthResponse)
def roller_strength(body: RollerStrengthRequest) -> Values:
    """Stiffness, load sharing with position errors, and bending stress of swinging rollers."""
    return RollerStrengthResponse.values(*run(body, body.solve))


@router.post("/chart")
def roller_strength_chart(body: RollerStrengthRequest, theme: Theme = "light") -> Figure:
    """Stiffness over length, non-uniformity over position error, stress over length."""
    curves, _ = run(body, body.solve_curves)
    return roller_figure(curves, theme)
