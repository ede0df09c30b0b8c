"""The API in the same process."""

import httpx
import pytest

from app.main import create_app
from app.settings import Settings

APP = create_app(Settings(max_seconds=300))  # a busy machine is no reason to fail


@pytest.fixture
def anyio_backend():
    return "asyncio"


@pytest.fixture
async def api():
    """Client of the API in the same process, below /api/v1/."""
    transport = httpx.ASGITransport(app=APP)
    async with httpx.AsyncClient(transport=transport, base_url="http://service/api/v1/") as client:
        yield client
