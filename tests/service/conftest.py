"""A running service for the tests of its operation."""

import pytest

from tests.running_service import running_service


@pytest.fixture(scope="session")
def serve():
    """Context manager of a running service, by its settings."""
    return running_service


@pytest.fixture(scope="session")
def service(serve):
    """A running service with tight limits; to start one more takes longest of a test."""
    with serve(receive_seconds=1.5, max_connections=40, max_seconds=60) as running:
        yield running
