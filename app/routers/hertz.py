"""POST /hertz and its chart."""

from fastapi import APIRouter

from app.calculation import run
from app.figures.hertz import PressureCurve, hertz_figure
from app.figures.theme import Figure, Theme
from app.processes import calculating, drawing
from app.schemas.hertz import HertzRequest, HertzResponse
from app.units import from_si

router = APIRouter(prefix="/hertz", tags=["crank-planetary"])


@router.post("", response_model_exclude_none=True)
@calculating
def hertz(body: HertzRequest) -> HertzResponse:
    """Hertz stress of pin and hole, its validity, and the conformal pressure where it applies."""
    return HertzResponse.from_core(*run(body, body.solve))


@router.post("/chart")
@drawing
def hertz_chart(body: HertzRequest, theme: Theme = "light") -> Figure:
    """Pressure across the contact as a Plotly figure, ready for Plotly.js."""
    profiles, _ = run(body, body.solve_profiles)
    return hertz_figure(
        [
            PressureCurve(name, from_si("place_mm", place), from_si("pressure_MPa", pressure))
            for name, place, pressure in profiles
        ],
        from_si("allowable_pressure_MPa", body.allowable_pressure()),
        theme,
    )
