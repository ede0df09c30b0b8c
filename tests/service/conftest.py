"""Running services for the tests of its operation: to start one more takes longest of a test."""

import socket

import pytest

from tests.running_service import running_service


@pytest.fixture(scope="session")
def serve():
    """Context manager of a running service, by its settings."""
    return running_service


@pytest.fixture(scope="session")
def service(serve):
    """A running service with tight limits."""
    with serve(receive_seconds=1.5, max_connections=40, max_seconds=60) as running:
        yield running


@pytest.fixture(scope="session")
def narrow(serve):
    """One that has few places and few descriptors, and waits long."""
    limits = {"processes": 1, "max_large": 2, "receive_seconds": 3600, "max_seconds": 3600}
    with serve(descriptors=256, **limits) as running:
        yield running


def left_behind(folder):
    """Path of a Unix socket at which nobody listens any more."""
    path = str(folder / "socket")
    with socket.socket(socket.AF_UNIX) as gone:
        gone.bind(path)
    return path


@pytest.fixture
def left_socket(tmp_path):
    return left_behind(tmp_path)


@pytest.fixture(scope="session")
def two_workers(serve, tmp_path_factory):
    """Two workers at a Unix socket that was left behind, below a prefix."""
    path = left_behind(tmp_path_factory.mktemp("two_workers"))
    with serve(unix_socket=path, root_path="/reducers", workers=2, processes=2) as running:
        yield running
