"""POST /hertz and its chart."""

from app.calculation import run
from app.figures.hertz import PressureCurve, hertz_figure
from app.figures.theme import Figure, Theme
from app.route import calculations
from app.schemas.base import Values
from app.schemas.hertz import HertzRequest, HertzResponse
from app.units import from_si

router = calculations("/hertz", tag="crank-planetary")


@router.post("", response_model=HertzResponse)
def hertz(body: HertzRequest) -> Values:
    """Hertz stress of pin and hole, its validity, and the conformal pressure where it applies."""
    return HertzResponse.values(*run(body, body.solve))


@router.post("/chart")
def hertz_chart(body: HertzRequest, theme: Theme = "light") -> Figure:
    """Pressure across the contact as a Plotly figure, ready for Plotly.js."""
    profiles, _ = run(body, body.solve_profiles)
    return hertz_figure(
        [
            PressureCurve(name, from_si("place_mm", place), from_si("pressure_MPa", pressure))
            for name, place, pressure in profiles
        ],
        {name: from_si("pressure_MPa", pressure) for name, pressure in body.limits()},
        theme,
    )
