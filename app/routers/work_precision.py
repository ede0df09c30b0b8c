"""POST /work-precision and its chart."""

from app.calculation import run
from app.figures.theme import Figure, Theme
from app.figures.work_precision import work_precision_figure
from app.route import calculations
from app.schemas.base import Values
from app.schemas.work_precision import WorkPrecisionRequest, WorkPrecisionResponse

router = calculations("/work-precision", tag="accuracy")


@router.post("", response_model=WorkPrecisionResponse)
def work_precision(body: WorkPrecisionRequest) -> Values:
    """Error against run time of the methods of a calculation, for the input given."""
    study, _ = run(body, body.solve)
    return WorkPrecisionResponse.values(study)


@router.post("/chart")
def work_precision_chart(body: WorkPrecisionRequest, theme: Theme = "light") -> Figure:
    """The same as a diagram, both axes logarithmic."""
    study, _ = run(body, body.solve)
    return work_precision_figure(WorkPrecisionResponse.values(study), theme)
