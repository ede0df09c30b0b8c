"""Settings of all tests: a busy machine is no reason to fail; slow tests can be left out."""

import ctypes
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any

import pytest
from hypothesis import settings

from tests.inputs.children import end_those_of
from tests.running_service import Service, running_service

# `make test` draws the same examples each time; `make accuracy` draws more, and others each time
settings.register_profile("khv", deadline=None, derandomize=True, max_examples=25)
settings.register_profile("quick", settings.get_profile("khv"), max_examples=10)
settings.register_profile(
    "many", settings.get_profile("khv"), derandomize=False, print_blob=True, max_examples=300
)
settings.load_profile("khv")

HERE = Path(__file__).parent
SLOW = {
    HERE / place
    for place in (
        "reference",  # thousands of cases at 40 digits
        "service",  # starts the service
        "benchmarks",
        "app/test_batch_api.py",
        "app/test_both_meshes_api.py",
        "app/test_compiled.py",
        "app/test_contact_law_api.py",
        "app/test_design_sections_api.py",
        "app/test_dxf_api.py",
        "app/test_fixes_reposted.py",
        "app/test_fuzz.py",
        "app/test_jobs.py",
        "app/test_openapi_conformance.py",
        "app/test_processes.py",
        "app/test_real_design_api.py",
        "app/test_reserves_api.py",
        "app/test_ring_design_api.py",
        "app/test_tolerance_study_api.py",
        "app/test_tutorial.py",
        "app/test_work_precision_api.py",
        "core/test_check_inputs.py",
        "core/test_checks_strength.py",
        "core/test_compiled.py",
        "core/test_largest_torque.py",
        "core/test_ring_mesh.py",
        "core/test_room.py",
        "core/test_tolerance.py",
        "core/test_usual_modification.py",
    )
}
"""Folders and files that take seconds each; `make check` leaves them out."""

collect_ignore = ["corpus", "inputs", "office", "oracles"]  # no doctests and no tests there


@pytest.fixture(scope="session", autouse=True)
def compiled_loops() -> None:
    """Turns and pieces are calculated by the compiled loops, as in the service."""
    from core.drive import compiled

    compiled.load()


@pytest.fixture(scope="module", autouse=True)
def freed() -> Iterator[None]:
    """Memory that the tests of a module have left is the system's again: a worker grows less."""
    yield
    with suppress(AttributeError):  # of another library of C
        ctypes.CDLL(None).malloc_trim(0)


@pytest.fixture(scope="session")
def served() -> Iterator[Service]:
    """A running service for all who need no other: to start one takes six seconds of the processor.

    A busy machine is no reason to fail; the tests are its proxy, which shows it below a prefix.
    """
    proxy = {"trusted_proxies": "127.0.0.0/8", "root_path": "/reducers"}
    with running_service(max_seconds=300, **proxy) as running:
        yield running


@pytest.hookimpl(optionalhook=True)
def pytest_testnodedown(node: Any) -> None:
    """End the processes that a worker's tests started when the worker ends, even by a hung test."""
    end_those_of(node.workerinput["workerid"], node.workerinput["testrunuid"])


def pytest_ignore_collect(collection_path: Path, config: pytest.Config) -> bool | None:
    # what is not asked for need not be imported
    asked = config.option.markexpr
    skipped = "not slow" in asked and collection_path in SLOW
    skipped |= "not browser" in asked and collection_path == HERE / "browser"
    return skipped or None


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    for item in items:
        if SLOW & {item.path, *item.path.parents}:
            item.add_marker(pytest.mark.slow)
