"""What the service says about itself."""

from fastapi import APIRouter

from app import VERSION
from app.examples import EXAMPLES
from app.schemas.service import Example, Examples, Health, MaterialOut, Materials
from core.materials import MATERIALS

router = APIRouter(tags=["service"])


@router.get("/health")
async def health() -> Health:
    """Whether the service works."""
    return Health(status="ok", version=VERSION)


@router.get("/materials", response_model_exclude_none=True)
async def materials() -> Materials:
    """The table of materials, each value with its source."""
    return Materials(materials=[MaterialOut.of(entry) for entry in MATERIALS.values()])


@router.get("/examples")
async def examples() -> Examples:
    """The papers' figures and numbers as ready requests."""
    return Examples(examples=[Example(**example) for example in EXAMPLES])
