"""POST /work-precision and its chart."""

from fastapi import APIRouter
from fastapi.concurrency import run_in_threadpool

from app.calculation import run
from app.figures.theme import Figure, Theme
from app.figures.work_precision import work_precision_figure
from app.schemas.work_precision import WorkPrecisionRequest, WorkPrecisionResponse

router = APIRouter(prefix="/work-precision", tags=["accuracy"])


@router.post("")
async def work_precision(body: WorkPrecisionRequest) -> WorkPrecisionResponse:
    """Error against run time of the methods of a calculation, for the input given."""
    study, _ = await run_in_threadpool(run, body, body.solve)
    return WorkPrecisionResponse.from_core(study)


@router.post("/chart")
async def work_precision_chart(body: WorkPrecisionRequest, theme: Theme = "light") -> Figure:
    """The same as a diagram, both axes logarithmic."""
    return work_precision_figure(await work_precision(body), theme)
