"""Fixtures of all tests."""

import httpx
import pytest

from app.main import app


@pytest.fixture
def anyio_backend():
    return "asyncio"


@pytest.fixture
async def api():
    """Client of the API in the same process, below /api/v1/."""
    transport = httpx.ASGITransport(app=app)
    async with httpx.AsyncClient(transport=transport, base_url="http://service/api/v1/") as client:
        yield client
