"""Request and answer of a batch: many requests of one calculation."""

from typing import Annotated, Any, Literal

from pydantic import FailFast, Field

from app.schemas.base import RequestModel, ResponseModel
from app.schemas.service import ProblemOut
from app.settings import Settings
from core.errors import InvalidInput

Calculation = Literal[
    "cyclogram",
    "contact_force",
    "hertz",
    "crank_planetary",
    "roller_strength",
    "contact_line",
    "meshing_load",
    "shaft_deflection",
]


MAX_REQUESTS = 10_000
"""Most requests of a batch."""


class BatchRequest(RequestModel):
    """Requests of one calculation, each as its own endpoint takes it."""

    calculation: Calculation
    requests: Annotated[
        list[dict[str, Any]], FailFast(), Field(min_length=1, max_length=MAX_REQUESTS)
    ]

    def refuse_beyond(self, settings: Settings) -> None:
        """Refuse more requests than the operator allows.

        Raises
        ------
        InvalidInput
            If there are too many.
        """
        if len(self.requests) > settings.max_batch:
            raise InvalidInput(
                "requests", len(self.requests), f"must be at most {settings.max_batch}"
            )


class BatchItem(ResponseModel):
    """What became of one request: its result, or its problem with pointers into that request."""

    result: dict[str, Any] | None = Field(
        default=None, description="What the calculation's own endpoint answers."
    )
    problem: ProblemOut | None = None


class BatchResponse(ResponseModel):
    """The answers, in the order of the requests."""

    results: list[BatchItem]
