"""POST /roller-strength and its chart."""

from fastapi import APIRouter

from app.calculation import run
from app.figures.roller_strength import roller_figure
from app.figures.theme import Figure, Theme
from app.processes import calculating, drawing
from app.schemas.roller_strength import RollerStrengthRequest, RollerStrengthResponse

router = APIRouter(prefix="/roller-strength", tags=["swinging rollers"])


@router.post("", response_model_exclude_none=True)
@calculating
def roller_strength(body: RollerStrengthRequest) -> RollerStrengthResponse:
    """Stiffness, load sharing with position errors, and bending stress of swinging rollers."""
    return RollerStrengthResponse.from_core(*run(body, body.solve))


@router.post("/chart")
@drawing
def roller_strength_chart(body: RollerStrengthRequest, theme: Theme = "light") -> Figure:
    """Stiffness over length, non-uniformity over position error, stress over length."""
    curves, _ = run(body, body.solve_curves)
    return roller_figure(curves, theme)
