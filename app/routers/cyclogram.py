"""POST /cyclogram and its chart."""

from app.calculation import run
from app.figures.cyclogram import cyclogram_figure
from app.figures.theme import Figure, Theme
from app.route import calculations
from app.schemas.base import Values
from app.schemas.cyclogram import CyclogramRequest, CyclogramResponse

router = calculations("/cyclogram", tag="crank-planetary")


@router.post("", response_model=CyclogramResponse)
def cyclogram(body: CyclogramRequest) -> Values:
    """Which pin/hole pairs drive, when, how many together; dead centres; assembly angles."""
    return CyclogramResponse.values(*run(body, body.solve))


@router.post("/chart")
def cyclogram_chart(body: CyclogramRequest, theme: Theme = "light") -> Figure:
    """The cyclogram as a Plotly figure, ready for Plotly.js."""
    run(body, body.refuse_undrawable)
    return cyclogram_figure(CyclogramResponse.values(*run(body, body.solve)), theme)
